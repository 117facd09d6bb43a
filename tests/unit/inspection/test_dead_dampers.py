"""A wheel without a damper fails under every method, on every tyre, with noise; refused are damaged records only."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from jounce.inspection import evaluate, simulated
from jounce.inspection.grading import difference_of, grade, grade_differences, sentences_of
from jounce.inspection.limits import load_limits, shipped_limits
from jounce.inspection.methods import METHODS
from jounce.inspection.result import Inspection, WheelResult
from jounce.parts import load
from jounce.parts.variants import wear_dampers
from jounce.plots.inspection import inspection_curves
from jounce.testers.testing import simulate_test

TYRES = {
    "as published": {},
    "real": {"tyre.damping_coefficient": 100.0},
    "soft, as published": {"tyre.stiffness": 140e3},
    "soft, real": {"tyre.stiffness": 140e3, "tyre.damping_coefficient": 100.0},
    "without damping": {"tyre.damping_coefficient": 0.0},
}


@pytest.mark.parametrize("noise", [0.0, 0.01])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("tyre", TYRES)
def test_quarter_car_fails(tyre, method, noise):
    car = load("audi-a6-quarter-car").with_changes(TYRES[tyre])
    found = simulated.simulate_inspection(
        wear_dampers(car, 1.0), simulated.tester_for(method), noise=noise, seed=3
    ).wheel
    assert found.is_gradable, found.reasons
    assert found.verdict == "fail", found.reasons
    assert found.value("body_damping_ratio") == pytest.approx(0.0, abs=8e-3)
    sound = simulated.simulate_inspection(
        car, simulated.tester_for(method), noise=noise, seed=3
    ).wheel
    assert sound.verdict in (
        ["not graded"] if method == "boge" else ["pass", "advise"]
    )  # advice: soft tyres


def test_damping_ratio_is_the_truth_within_its_interval():
    car = wear_dampers(
        load("audi-a6-quarter-car").with_changes({"tyre.damping_coefficient": 100.0}), 1.0
    )
    found = simulated.simulate_inspection(car, simulated.tester_for("theta"), noise=0.01)
    assert (
        abs(found.wheel.theta_road - found.theta_road)
        < found.wheel.uncertainty["theta_road"]
        < 2e-3
    )


@pytest.mark.parametrize("axle", ["front", "rear"])
@pytest.mark.parametrize("method", METHODS)
def test_both_wheels_of_a_full_car_fail(method, axle):
    graded, _ = simulated.simulate_axle(
        wear_dampers(load("audi-a6-full-car"), 1.0),
        simulated.tester_for(method),
        axle=axle,
        noise=0.01,
    )
    for wheel in graded.wheels:
        assert wheel.verdict == "fail", wheel.reasons
        said = " ".join(one.message for one in wheel.findings)
        assert "other plate runs" not in said
        assert "another machine running" not in said or method == "boge"  # its plate swings as well
        assert "slips" not in said


@pytest.mark.parametrize(
    ("method", "force"),
    [*((method, force) for method in ("theta", "boge") for force in (40.0, 80.0, 150.0, 300.0)),
     ("egea", 300.0), ("egea", 500.0), ("eusama", 250.0), ("eusama", 400.0)],
)  # fmt: skip
def test_dry_friction_does_not_pass_for_a_damper(method, force):
    """Without a damper friction holds a wheel on these testers as a damper would; the verdict asks for another look."""
    deciding = [method] if method in ("egea", "eusama") else ["theta"]
    dead = {
        "strut.damper.coefficient": 0.0,
        "strut.friction": {"force": force, "regularisation_velocity": 0.001},
    }
    car = load("audi-a6-quarter-car").with_changes(dead)
    record = simulate_test(car, simulated.tester_for(method), noise=0.005, seed=1)
    found = evaluate(record, simulated.tester_for(method), methods=deciding)
    graded = grade(found, deciding=deciding)
    wheel = graded.wheels[0]
    if deciding != ["theta"]:
        assert wheel.grade[method] in ("sufficient", "good")  # by its own criterion
    assert wheel.verdict in ("advise", "fail"), wheel.reasons
    assert any("dry friction" in reason for reason in wheel.reasons)
    assert any("trockene Reibung" in one for one in sentences_of(graded.grades[0].reasons, "de"))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    "damper",
    [
        {"coefficient": 1000.0},
        {"velocity": [-1.0, -0.1, 0.0, 0.1, 1.0], "force": [-2400.0, -300.0, 0.0, 120.0, 700.0]},
        {
            "velocity": [-1.0, -0.3, -0.1, 0.0, 0.1, 0.3, 1.0],
            "force": [-900.0, -500.0, -200.0, 0.0, 200.0, 500.0, 900.0],
        },
    ],
)
def test_bent_dampers_and_a_little_friction_pass(method, damper):
    given = {
        "strut.damper": damper,
        "strut.friction": {"force": 30.0, "regularisation_velocity": 0.001},
    }
    car = load("audi-a6-quarter-car").with_changes(given)
    found = evaluate(
        simulate_test(car, simulated.tester_for(method), noise=0.01, seed=1),
        simulated.tester_for(method),
    )
    deciding = "theta" if method == "boge" else method  # whose limits nobody has verified
    assert grade(found, deciding=[deciding]).wheels[0].verdict == "pass"


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("wear", [0.5, 0.86, 0.88, 0.89, 0.92, 0.94, 1.0])
def test_a_light_wheel_that_hops_and_swings_on_is_not_refused(method, wear):
    """A kart of 206 N: with little damping it leaves the plate and swings on when the plate has stopped."""
    car, tester = wear_dampers(load("kart-quarter-car"), wear), simulated.tester_for(method)
    found = evaluate(simulate_test(car, tester, noise=0.01, seed=2), tester).wheels[0]
    assert found.is_gradable, [one.message for one in found.findings if one.severity == "problem"]
    assert any("leaves the plate" in one.message for one in found.findings) == found.lift_off
    if tester.kind == "sprung-plate":
        assert found.corner.spring_rate == pytest.approx(
            22.73e3 * np.cos(car.strut.angle) ** 2, rel=0.02
        )
        assert found.corner.damping_coefficient == pytest.approx(121.2 * (1.0 - wear), abs=1.0)


@pytest.mark.parametrize(
    ("value", "half", "near"), [(0.014, 0.005, True), (0.014, 0.003, False), (0.006, 0.005, True)]
)
def test_a_damped_body_within_its_interval_only_is_told(value, half, near):
    wheel = WheelResult(
        "left", static_load=4e3, phase_angle_min_deg=50.0, uncertainty={"body_damping_ratio": half},
        more={"body_damping_ratio": value},
    )  # fmt: skip
    graded = grade(Inspection((wheel,), {"axle": "front"}, methods=("egea",)))
    assert graded.wheels[0].verdict == ("pass" if value > 0.01 else "fail")
    told = [
        one for one in graded.wheels[0].reasons if "body" in one and "the class is uncertain" in one
    ]
    assert bool(told) is near


def _twice(record: xr.Dataset) -> xr.Dataset:
    time = np.arange(2 * record["time"].size) * 1e-3
    channels = {name: ("time", np.tile(values, 2), values.attrs) for name, values in record.items()}
    return xr.Dataset(channels, {"time": ("time", time, {"units": "s"})}, record.attrs)


DAMAGE = {
    "upside down": (lambda r: r.assign({"left.plate.z": -r["left.plate.z"]}), "wrong sign"),
    "cut off": (lambda r: r.sel(time=slice(0.0, 7.5)), "cut off"),
    "without sweep": (lambda r: r.sel(time=slice(0.0, 4.5)), "sweep is missing"),
    "two sweeps": (_twice, "2 sweeps"),
}


@pytest.mark.parametrize("wear", [0.0, 0.9, 1.0])
@pytest.mark.parametrize("method", ["theta", "boge"])
@pytest.mark.parametrize("damage", DAMAGE)
def test_damage_is_told_from_a_dead_damper(damage, method, wear):
    """Refused is the damaged record, with the reason; the same record undamaged is evaluated."""
    car = load("audi-a6-quarter-car").with_changes({"tyre.damping_coefficient": 100.0})
    tester = simulated.tester_for(method)
    record = simulated.simulate_inspection(
        wear_dampers(car, wear) if wear else car, tester, noise=0.01
    ).record
    record = record[[name for name in record if str(name).startswith("left.plate.")]]
    assert evaluate(record, tester).is_gradable
    spoil, reason = DAMAGE[damage]
    assert reason in evaluate(spoil(record), tester).wheel("left").reasons[0]


def test_ratio_that_is_zero_within_its_uncertainty_is_the_lowest_band(tmp_path):
    text = shipped_limits().read_text(encoding="utf-8")
    (tmp_path / "own.toml").write_text(
        text.replace('{ to = 0.10, label = "red"', '{ from = 0.0, to = 0.10, label = "red"')
    )
    own = load_limits(tmp_path / "own.toml")
    for value, band in ((-0.001, "red"), (-0.003, None), (0.0, "red")):
        wheel = WheelResult("left", theta_road=value, uncertainty={"theta_road": 0.002})
        found = grade(Inspection((wheel,), methods=("theta",)), own).wheels[0]
        assert found.grade.get("theta") == band
    wheel = WheelResult("left", theta_road=-0.009, uncertainty={"theta_road": 0.002})
    assert grade(Inspection((wheel,), methods=("theta",))).wheels[0].verdict == "fail"


def test_difference_within_its_uncertainty_fails_nobody():
    """Phase angles of 0.24 and -0.03 degrees, each to 0.17, are equal as far as anyone can tell."""

    def reasons(left: float, right: float, half: float):
        wheels = [
            WheelResult(side, phase_angle_min_deg=value, uncertainty={"phase_angle_min_deg": half})
            for side, value in (("left", left), ("right", right))
        ]
        found = difference_of("phase_angle_min_deg", *wheels, ("left", "right"))
        (graded,), about = grade_differences([found], load_limits(), ["egea"], "wheels")
        return graded, about[0]

    graded, reason = reasons(0.24, -0.03, 0.17)
    assert reason.verdict == "pass"
    assert graded.relative == 1.0
    assert graded.relative_uncertainty == pytest.approx(0.17 / 0.24)
    assert "100.0 % ± 70.9 %" in reason.text()
    assert "may be in range within its uncertainty" in reason.text()
    _, sure = reasons(50.0, 30.0, 0.17)
    assert sure.verdict == "fail"
    assert "is too large" in sure.text()
    _, unsure = reasons(50.0, 34.9, 0.5)  # 30.2 %, to 1.2 %
    assert unsure.verdict == "pass"


@pytest.mark.parametrize("wear", [0.5, 0.9, 1.0])
def test_phase_curve_least_value_and_table_are_of_one_curve(wear):
    """Where the tyre has lifted off, single turns swing far below what the table gives."""
    car = load("audi-a6-quarter-car").with_changes({"tyre.damping_coefficient": 100.0})
    found = simulated.simulate_inspection(
        wear_dampers(car, wear), simulated.tester_for("egea"), noise=0.01
    ).wheel
    figure = inspection_curves(Inspection((found,)))
    axes = next(axes for axes in figure.axes if "Phase" in axes.get_title(loc="left"))
    dot, curve = axes.lines[:2]
    frequency, angle = (np.asarray(values) for values in curve.get_data())
    inside = (frequency >= 6.0) & (frequency <= 18.0)
    assert dot.get_ydata()[0] == found.phase_angle_min_deg
    assert angle[inside].min() == pytest.approx(found.phase_angle_min_deg, abs=0.01)  # degrees
    assert found.phase_frequency_hz in frequency[inside]
