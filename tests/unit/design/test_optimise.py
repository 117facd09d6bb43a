"""Optimal designs: against closed forms, with limits, over corners, on trials; and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError, FitError
from jounce.design.optimise import optimise
from jounce.design.problem import design_problem, read_metric, units_of
from jounce.ride.closed_forms import (
    LumpedCorner,
    comfort_damping,
    road_holding_damping,
    road_holding_rate,
)
from jounce.ride.stationary import stationary

ROAD = {"road": "C", "speed": "20 m/s"}
DAMPER, SPRING = "strut.damper.coefficient", "strut.spring.rate"
CAR_A = jn.QuarterCar(
    sprung={"mass": 400.0},
    unsprung={"mass": 40.0},
    strut={"spring": {"rate": 25e3}, "damper": {"coefficient": 1500.0}},
    tyre={"stiffness": 200e3},
)
CORNER = LumpedCorner(400.0, 40.0, 25e3, 200e3)
AXLES = {
    "front.spring_rate": "±40 %",
    "rear.spring_rate": "±40 %",
    "front.damping_coefficient": ("500 N*s/m", "8000 N*s/m"),
    "rear.damping_coefficient": ("500 N*s/m", "8000 N*s/m"),
}


def test_dampers_of_the_closed_forms():
    for metric, best in (
        ("sprung.az", comfort_damping(CORNER)),
        ("tyre.force", road_holding_damping(CORNER)),
    ):
        found = optimise(CAR_A, {DAMPER: (300.0, 5000.0)}, metric, **ROAD)
        assert found.converged
        assert found.derivatives == "exact"
        assert found.values[DAMPER] == pytest.approx(best, rel=1e-6)
        assert found.after[metric] == pytest.approx(
            stationary(found.rig, "C", 20.0)[metric], rel=1e-9
        )
        assert found.value == pytest.approx(
            (found.after[metric] / found.before[metric]) ** 2, rel=1e-9
        )
        assert abs(found.numbers[0].sensitivity) < 1e-4
        low, high = found.numbers[0].flat or (0.0, 0.0)
        assert 0.8 * best < low < best < high < 1.2 * best


def test_stiffness_of_the_closed_form_with_both_numbers_free():
    free = {DAMPER: (300.0, 5000.0), SPRING: ("5 N/mm", "60 N/mm")}
    found = optimise(CAR_A, free, "tyre.force", **ROAD)
    best = LumpedCorner(400.0, 40.0, road_holding_rate(CORNER), 200e3)
    assert found.values[SPRING] == pytest.approx(road_holding_rate(CORNER), rel=1e-4)
    assert found.values[DAMPER] == pytest.approx(road_holding_damping(best), rel=1e-4)


def test_limits_hold_and_say_what_they_cost():
    free = {DAMPER: (300.0, 5000.0), SPRING: ("5 N/mm", "60 N/mm")}
    limits = {
        "strut.deflection": "12 mm",
        "mode 1 frequency": ("1 Hz", "1.5 Hz"),
        "strut.deflection static": "0.4 m",
    }
    found = optimise(CAR_A, free, "sprung.az", limits, **ROAD)
    travel, frequency, static = found.constraints
    assert found.converged
    assert (travel.is_active, frequency.is_active, static.is_active) == (True, True, False)
    assert travel.value == pytest.approx(0.012, rel=1e-6)
    assert travel.value == pytest.approx(
        stationary(found.rig, "C", 20.0)["strut.deflection"], rel=1e-9
    )
    assert frequency.value == pytest.approx(jn.modes(found.rig)[0].frequency_hz, rel=1e-9)
    assert static.value == pytest.approx(400.0 * 9.81 / found.values[SPRING], rel=1e-9)
    assert static.gain == 0.0
    looser = optimise(
        CAR_A, free, "sprung.az", {**limits, "strut.deflection": 0.012 * 1.001}, **ROAD
    )
    assert np.log(found.value / looser.value) / np.log(1.001) == pytest.approx(
        travel.gain, rel=0.01
    )


def test_ranges_around_the_best_keep_the_limits():
    free = {DAMPER: (300.0, 5000.0), SPRING: ("5 N/mm", "60 N/mm")}
    limits = {
        "strut.deflection": "12 mm",
        "mode 1 frequency": (None, "1.5 Hz"),
        "strut.deflection static": "0.4 m",
    }
    found = optimise(CAR_A, free, "sprung.az", limits, **ROAD)
    free_of_limits = optimise(CAR_A, free, "sprung.az", **ROAD)
    for number, other in zip(found.numbers, free_of_limits.numbers, strict=True):
        low, high = number.flat or (0.0, 0.0)
        assert number.lower <= low <= number.value <= high <= number.upper
        assert (other.flat or (0.0, 0.0))[0] < number.value
        for end, outwards in ((low, -1.0), (high, 1.0)):
            rig = found.rig.with_changes({number.path: end})
            assert stationary(rig, "C", 20.0)["strut.deflection"] <= 0.012 * (1.0 + 1e-5)
            assert jn.modes(rig)[0].frequency_hz <= 1.5 * (1.0 + 1e-5)
            assert 400.0 * 9.81 / rig.parameters()[SPRING] <= 0.4 * (1.0 + 1e-5)
            further = end + outwards * 3e-3 * number.value
            if number.lower < further < number.upper:  # one of them would not hold there
                moved = found.rig.with_changes({number.path: further})
                rises = (
                    stationary(moved, "C", 20.0)["sprung.az"] / found.after["sprung.az"]
                ) ** 2 > 1.0095
                breaks = (
                    stationary(moved, "C", 20.0)["strut.deflection"] > 0.012
                    or jn.modes(moved)[0].frequency_hz > 1.5
                )
                assert rises or breaks or 400.0 * 9.81 / moved.parameters()[SPRING] > 0.4
    damper = found.numbers[0].flat or (0.0, 0.0)
    assert damper[0] == pytest.approx(
        found.values[DAMPER], rel=1e-3
    )  # less damping would break the limit of travel
    assert damper[1] > 1.01 * found.values[DAMPER]


def test_worst_corner_of_a_vehicle():
    vehicle = jn.load("audi-a6-half-car-4dof")
    mean = optimise(vehicle, AXLES, "tyre.force coefficient", band="iso", **ROAD)
    worst = optimise(vehicle, AXLES, "worst tyre.force coefficient", band="iso", **ROAD)
    of = {name: stationary(found.rig, "C", 20.0, band="iso").load_coefficients for name, found in
          (("mean", mean), ("worst", worst))}  # fmt: skip
    assert mean.converged
    assert worst.converged
    assert max(of["worst"].values()) < 0.999 * max(of["mean"].values())
    sums = {name: sum(value**2 for value in found.values()) for name, found in of.items()}
    assert sums["mean"] < 0.999 * sums["worst"]


def test_full_car_keeps_left_and_right_alike():
    objective = {"sprung.az weighted": 1.0, "tyre.force coefficient": 0.5}
    found = optimise(
        jn.load("audi-a6-full-car"), AXLES, objective, {"strut.deflection": "10 mm"}, **ROAD
    )
    assert found.converged
    assert found.value < 0.95
    by_channel = {constraint.channel: constraint for constraint in found.constraints}
    left, right = (
        by_channel["rear_left.strut.deflection"],
        by_channel["rear_right.strut.deflection"],
    )
    assert left.is_active
    assert left.gain == pytest.approx(right.gain, rel=1e-3)
    assert left.gain > 0.01
    assert [f.place for f in found.findings if f.severity == "note"] == [
        "sprung.az weighted"
    ]  # a band is taken


def test_simulated_trial_with_a_tyre_that_lifts_off():
    rig = jn.load("kart-quarter-car")
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m"),
        speed="1.95 m/s",
        duration="1 s",
    )
    found = optimise(rig, {DAMPER: (30.0, 600.0)}, "sprung.az", trial=trial)
    assert found.converged
    assert found.value < 0.9
    around = [found.values[DAMPER] * share for share in (0.9, 1.1)]
    runs = [
        jn.simulate(rig.with_changes({DAMPER: c}), trial)["sprung.az"]
        for c in (*around, found.values[DAMPER])
    ]
    sizes = [float(np.sqrt((run**2).mean())) for run in runs]
    assert sizes[2] < min(sizes[:2])
    assert found.after["sprung.az"] == pytest.approx(sizes[2], rel=0.01)


def test_slopes_of_all_metrics_are_those_of_differences():
    vehicle = jn.load("audi-a6-half-car-4dof")
    more = [
        "body.az Wk",
        "strut.deflection static",
        "mode 2 damping_ratio",
        "tyre.force coefficient",
        "mode 4 frequency",
    ]
    free = {"front.spring_rate": "±50 %", "rear.damping_coefficient": "±90 %", "body.mass": "±20 %"}
    trial = jn.Trial(
        road=jn.Versine(height="20 mm", length="2 m", start="0.5 m"),
        speed="10 m/s",
        duration="2.5 s",
    )
    for given in (ROAD, {"trial": trial}):
        problem = design_problem(vehicle, free, "body.az", more=more, **given)
        found = problem.numbers(problem.start)
        for i, value in enumerate(problem.start):
            step = np.eye(3)[i] * 1e-4 * value
            above, below = (problem.numbers(problem.start + side * step) for side in (1.0, -1.0))
            for text, (numbers, slopes) in found.items():
                difference = (above[text][0] - below[text][0]) / 2e-4
                assert slopes[i] * value == pytest.approx(
                    difference, rel=2e-4, abs=2e-6 * np.max(np.abs(numbers))
                ), text


def test_overdamped_modes_go_on_smoothly():
    metrics = {"mode 2 frequency": 1.0, "mode 2 damping_ratio": 1.0}
    problem = design_problem(CAR_A, {DAMPER: (100.0, 30e3)}, metrics, **ROAD)
    ratios = [
        problem.numbers(np.array([c]))["mode 2 damping_ratio"][0][0]
        for c in np.linspace(4e3, 5.5e3, 60)
    ]
    assert ratios[0] < 1.0 < ratios[-1]
    assert np.all(np.diff(ratios) > 0.0)
    assert np.max(np.diff(ratios)) < 4.0 * np.median(np.diff(ratios))


def test_bounds_that_hold_and_numbers_that_matter_little_are_found():
    bound = optimise(CAR_A, {SPRING: ("20 N/mm", "30 N/mm")}, "sprung.az", **ROAD)
    assert bound.numbers[0].at == "lower"
    assert [f.place for f in bound.findings if "bound" in f.message] == [SPRING]
    car = jn.load("audi-a6-half-car-4dof")
    flat = optimise(
        car, {"body.height": (0.4, 0.7), "front.damping_coefficient": "±30 %"}, "body.az", **ROAD
    )
    assert [f.place for f in flat.findings if "has little influence" in f.message] == [
        "body.height"
    ]


def test_more_starts_do_not_end_worse():
    one, many = (
        optimise(CAR_A, {DAMPER: (300.0, 5000.0)}, "tyre.force", starts=count, **ROAD)
        for count in (1, 4)
    )
    assert many.value <= one.value * (1 + 1e-9)


@pytest.mark.parametrize(
    ("free", "objective", "constraints", "given", "text"),
    [
        ({}, "sprung.az", {}, ROAD, "no free parameter"),
        (
            {"strut.damper.coefficien": "10 %"},
            "sprung.az",
            {},
            ROAD,
            "unknown parameter.*Did you mean",
        ),
        ({DAMPER: (1500.0, 1500.0)}, "sprung.az", {}, ROAD, "lower bound must be below"),
        ({DAMPER: (2000.0, 3000.0)}, "sprung.az", {}, ROAD, "exclude the start value"),
        ({DAMPER: ("-1 N*s/m", "3 kN*s/m")}, "sprung.az", {}, ROAD, "out of range"),
        ({DAMPER: "10 mm"}, "sprung.az", {}, ROAD, "wrong unit"),
        ({DAMPER: "±10 %"}, "sprung.ax", {}, ROAD, "unknown metric 'sprung.ax'.*Did you mean"),
        (
            {DAMPER: "±10 %"},
            "camber_gain",
            {},
            ROAD,
            "unknown metric 'camber_gain'.*jounce design kinematics",
        ),
        ({DAMPER: "±10 %"}, "sprung.az smoothed", {}, ROAD, "no such metric of a channel"),
        (
            {DAMPER: "±10 %"},
            "sprung.az coefficient",
            {},
            ROAD,
            "a coefficient is defined only for forces",
        ),
        ({DAMPER: "±10 %"}, "mode 1 colour", {}, ROAD, "not a quantity of a mode"),
        ({DAMPER: "±10 %"}, "mode 3 frequency", {}, ROAD, "only 2 modes"),
        ({DAMPER: "±10 %"}, "", {}, ROAD, "invalid metric"),
        ({DAMPER: "±10 %"}, {}, {}, ROAD, "no objective is given"),
        ({DAMPER: "±10 %"}, {"sprung.az": -1.0}, {}, ROAD, "invalid weight"),
        ({DAMPER: "±10 %"}, {"sprung.az": "much"}, {}, ROAD, "invalid weight"),
        ({DAMPER: "±10 %"}, "sprung.az", {"strut.deflection": "10 N"}, ROAD, "wrong unit"),
        (
            {DAMPER: "±10 %"},
            "sprung.az",
            {"strut.deflection": (0.02, 0.01)},
            ROAD,
            "greater than the upper",
        ),
        ({DAMPER: "±10 %"}, "sprung.az", {"strut.deflection": (None, None)}, ROAD, "no limit"),
        (
            {DAMPER: "±10 %"},
            "sprung.az",
            {"strut.deflection": "1 mm"},
            ROAD,
            "no design within the bounds",
        ),
        ({DAMPER: "±10 %"}, "sprung.az", {}, {"road": "C"}, "no speed"),
        ({DAMPER: "±10 %"}, "sprung.az", {}, {"speed": 20.0}, "no road"),
        ({DAMPER: "±10 %"}, "sprung.az", {}, {"road": "X", "speed": 20.0}, "unknown road class"),
        ({DAMPER: "±10 %"}, "sprung.az", {}, {**ROAD, "starts": 0}, "invalid number of searches"),
        (
            {DAMPER: "±10 %"},
            "sprung.az",
            {},
            {**ROAD, "trial": jn.Trial(road=jn.Flat(), speed=1.0, duration=1.0)},
            "its own road",
        ),
    ],
)
def test_bad_requests(free, objective, constraints, given, text):
    with pytest.raises((DescriptionError, FitError), match=rf"(?s){text}"):
        optimise(CAR_A, free, objective, constraints, **given)


def test_infeasible_limits_say_what_can_be_reached():
    with pytest.raises(FitError) as caught:
        optimise(
            CAR_A, {DAMPER: (500.0, 2000.0)}, "sprung.az", {"strut.deflection": "9 mm"}, **ROAD
        )
    reached = stationary(CAR_A.with_changes({DAMPER: 2000.0}), "C", 20.0)["strut.deflection"]
    assert f"{reached:.4g} m" in str(caught.value)
    assert "at most 0.009 m" in str(caught.value)


def test_metrics_are_read_by_their_words():
    units = units_of(jn.load("audi-a6-full-car"))
    metric = read_metric("worst tyre.force coefficient", units, where="")
    assert (len(metric.channels), metric.unit, metric.is_worst) == (4, "1", True)
    assert read_metric("front_left.sprung.az Wd", units, where="").weighting == "Wd"
    assert read_metric("body.az weighted", units, where="").channels == ("body.az",)


def test_result_is_plain_data():
    found = optimise(CAR_A, {DAMPER: "±50 %"}, "sprung.az", {"strut.deflection": "20 mm"}, **ROAD)
    plain = found.to_dict()
    assert plain["values"][DAMPER] == found.values[DAMPER]
    assert plain["constraints"][0]["upper"] == 0.02
    assert "rig" not in plain
    assert found.rig.parameters()[DAMPER] == found.values[DAMPER]
    assert CAR_A.parameters()[DAMPER] == 1500.0
