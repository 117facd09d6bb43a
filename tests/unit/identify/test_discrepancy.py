"""Intervals that count what the model lacks: richer rigs, exact slopes, what is claimed and when it is withheld."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError, FitError
from jounce.core.findings import Finding
from jounce.identify.densities import DoubtDensity
from jounce.identify.discrepancy import (
    DrawnRun,
    ModelErrorProblem,
    _doubt_behind,
    _one_sided,
    _State,
    _Stray,
    discrepancy_of,
    fit_model_error,
    noise_variance,
)
from jounce.identify.estimate import Estimate, student_factor
from jounce.identify.extended_rig import ExtendedRig, RideExtent
from jounce.identify.fit_problem import free_parameters
from jounce.identify.laws import Laws, States
from jounce.identify.settings import UpdateSettings
from jounce.simulation.compiled import compile_rig

RIG = jn.load("kart-quarter-car").with_changes({
    "strut.friction": {"force": 4.0, "regularisation_velocity": 0.005},
    "guide.friction": {"force": 6.0, "regularisation_velocity": 0.005},
    "tyre.damping_coefficient": 15.0,
})  # fmt: skip
DOUBTED = UpdateSettings(weights="normalised", doubt=jn.Doubt())
FREE = {
    "strut.spring.rate": "15 %",
    "strut.damper.coefficient": "50 %",
    "guide.friction.force": ["0 N", "30 N"],
    "tyre.stiffness": "15 %",
}
BUMP = {"height": "10 mm", "length": "60 mm", "start": "0.2 m"}
DEGRESSIVE = {
    "velocity": [-1.2, -0.5, -0.15, 0.0, 0.15, 0.5, 1.2],
    "force": [-150, -85, -32, 0, 28, 70, 125],
}


def trial(speed, truth, *, told=RIG, noise=0.0, seed=0):
    """One pass of a true rig, described by another one."""
    course = jn.Trial(road=jn.HalfSine(**BUMP), speed=speed, duration=0.8)
    run = jn.simulate(truth, course, tolerance=1e-7)[["sprung.az", "unsprung.az"]]
    draw = np.random.default_rng(seed)
    for name, size in (("sprung.az", noise), ("unsprung.az", 4.0 * noise)):
        run[name].values = run[name].values + size * draw.standard_normal(run.sizes["time"])
    return jn.FitTrial(f"{speed} m/s", told, course, run)


def trials(changes, *, count=3, **more):
    truth = RIG.with_changes(changes)
    return [
        trial(speed, truth, seed=i, **more) for i, speed in enumerate((1.95, 2.86, 3.79)[:count])
    ]


@pytest.fixture(scope="module")
def wrong():
    """A degressive damper fitted by a linear one."""
    made = trials({"strut.damper": DEGRESSIVE}, noise=0.1)
    return made, jn.update_model(made, FREE, weights="normalised", align="lag", doubt=jn.Doubt())


# the richer rig ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["kart-quarter-car", "kart-double-wishbone"])
def test_the_richer_rig_moves_as_the_rig_does(name):
    rig = jn.load(name)
    free = [
        path
        for path in ("strut.spring.rate", "strut.damper.coefficient", "tyre.stiffness")
        if path in rig.parameters()
    ]
    doubt = jn.Doubt(tyre_curvature=0.0)
    richer = ExtendedRig(
        rig, free, doubt, RideExtent(0.007, 0.0015, 1.0), compile_rig(rig).facts.parameters
    )
    numbers = richer.numbers(rig.parameters(), {}, np.zeros(len(richer.nuisances)))
    course = jn.Trial(road=jn.HalfSine(**BUMP), speed=1.95, duration=0.5)
    plain = jn.simulate(rig, course, tolerance=1e-7)
    rich = jn.simulate(richer.description.with_changes(numbers), course, tolerance=1e-7)
    for channel in ("sprung.az", "unsprung.az", "strut.force", "tyre.force"):
        size = float(np.abs(plain[channel]).max())
        assert np.abs(rich[channel] - plain[channel]).max() < 2e-4 * size, channel
    assert len(richer.nuisances) > 12


def test_slopes_of_all_doubts_are_those_of_differences():
    free = free_parameters(RIG, FREE)
    one = ModelErrorProblem(
        trials({}, count=1),
        free,
        UpdateSettings(weights="normalised", align="lag", doubt=jn.Doubt()),
    )
    here = _State(np.zeros(len(free)), np.zeros(len(one.nuisances)), np.zeros((1, 2)), np.zeros(1))
    blocks, _ = one.blocks(here)
    names = [*FREE, *(nuisance.name for nuisance in one.nuisances)]
    assert {
        "height",
        "contact_patch",
        "presliding",
        "arms",
        "sprung.mass",
        "tyre curvature",
    } <= set(names)
    for k, name in enumerate(names):
        vectors = []
        for step in (
            2e-4,
            -2e-4,
        ):  # small enough that no reversal of the guide comes or goes in between
            moved = _State(here.theta.copy(), here.xi.copy(), here.own, here.lags)
            (moved.theta if k < len(free) else moved.xi)[k if k < len(free) else k - len(free)] += (
                step
            )
            vectors.append([block.residual for block in one.blocks(moved)[0]])
        rough = (
            0.1
            if name in ("height", "contact_patch", "presliding", "arms") or "corner" in name
            else 1e-3
        )
        for block, after, before in zip(blocks, *vectors, strict=True):
            slope = (before - after) / 4e-4
            error = np.sort(np.abs(slope - block.common[:, k]))[
                : int(0.98 * len(slope))
            ]  # but for jumps at landings
            assert np.linalg.norm(error) <= rough * max(np.linalg.norm(slope), 1e-3), name


def test_slopes_do_not_depend_on_where_the_search_comes_from():
    """What a presliding force did in the last motion is no part of what an input changes in this one."""
    free = free_parameters(RIG, FREE)
    one = ModelErrorProblem(
        trials({}, count=1),
        free,
        UpdateSettings(weights="normalised", align="lag", doubt=jn.Doubt()),
    )
    xi = np.zeros(len(one.nuisances))
    xi[one.place["presliding"]] = 1.0
    here = _State(np.zeros(len(free)), xi, np.zeros((1, 2)), np.zeros(1))
    one.blocks(
        _State(np.full(len(free), 0.5), xi, np.full((1, 2), 2.0), np.zeros(1))
    )  # elsewhere, at another speed
    arriving, _ = one.blocks(here)
    staying, _ = one.blocks(here)
    column = len(free) + one.place["height"]
    for now, again in zip(arriving, staying, strict=True):
        slope = again.common[:, column]
        assert np.linalg.norm(now.common[:, column] - slope) < 0.1 * np.linalg.norm(slope), (
            now.channel
        )


def test_inertia_of_arms_couples_the_masses_and_leaves_each_its_own():
    """Force between the masses and what is added to them: M = [[sprung, c], [c, unsprung]], whatever the angle."""
    free, course = free_parameters(RIG, FREE), jn.Trial(road=jn.Flat(), speed=1.0, duration=0.2)
    made = jn.simulate(RIG, course)[["sprung.az", "unsprung.az"]]
    one = ModelErrorProblem(
        [jn.FitTrial("level", RIG, course, made)], free, UpdateSettings(weights="printed", doubt=jn.Doubt()),
        priors={"strut.spring.rate": (23e3, 300.0)},
    )  # fmt: skip
    assert [(own.name, own.deviation) for own in one.own] == [
        ("speed", 0.003),
        ("slowing", 0.02),
    ]  # of each trial
    half = (
        0.15 * 22730.0
    )  # a scaled unit, in which a prior has its mean and the root of its precision
    assert one.priors == pytest.approx(np.array([[270.0 / half, half / 300.0], *[[0.0, 0.0]] * 3]))
    run, ratio, arms = one.runs[0], np.cos(RIG.parameters()["strut.angle"]), 0.2
    body, wheel = 3.0, -40.0  # m/s^2
    still = np.zeros(5)
    moved = States(
        np.arange(5.0), still, ratio * (wheel - body) * np.arange(5.0), still, still, still
    )
    force = arms * run.forces(moved)["arms"][2]  # along the strut, apart
    sprung, unsprung = 16.0 + arms, 5.0 + arms
    assert sprung * body - ratio * force == pytest.approx(16.0 * body + arms * wheel)
    assert unsprung * wheel + ratio * force == pytest.approx(5.0 * wheel + arms * body)


def test_a_measured_actuator_force_stays_beside_what_is_doubted():
    time = np.linspace(0.0, 1.2, 241)
    truth, passes = RIG.with_changes({"strut.spring.rate": 24000.0}), []
    for frequency in (2.0, 4.0, 7.0):
        force = 40.0 * np.sin(2.0 * np.pi * frequency * time) * np.minimum(time / 0.3, 1.0)
        level = jn.Excitation(time=time, height=np.zeros(241))
        course = jn.Trial(
            excitation=level, actuator_force={"time": time, "force": force}, duration=1.2
        )
        passes.append(
            jn.FitTrial(
                f"{frequency}",
                RIG,
                course,
                jn.simulate(truth, course)[["sprung.az", "unsprung.az"]],
            )
        )
    for doubt in (jn.Doubt(), jn.Doubt(presliding=0.0, arms=0.0)):
        found = jn.update_model(passes, FREE, weights="normalised", doubt=doubt).discrepancy
        assert found.parameters["strut.spring.rate"].component.value == pytest.approx(
            24000.0, rel=2e-3
        )


def test_presliding_builds_up_over_a_distance_and_turns_over_with_the_motion():
    time = np.linspace(0.0, 1.0, 2001)
    still = np.zeros_like(time)
    wave = 0.1 * np.sin(2.0 * np.pi * 2.0 * time)
    z = States(time, still, wave, still, still, still).sliding(wave)
    assert np.abs(z).max() <= 1.0
    assert z[250] > 0.99
    assert z[499] > 0.99
    assert z[750] < -0.99
    slow = States(10.0 * time, still, 0.1 * wave, still, still, still).sliding(0.1 * wave)
    assert slow == pytest.approx(z, abs=1e-9)  # a distance, whatever the speed


def test_a_bend_of_the_damper_is_friction_to_a_model_with_a_line():
    """Degressive law without friction: the nearest line and friction have friction; a linear one has none."""
    v = 0.5 * np.sin(np.linspace(0.0, 20.0, 2000))
    still = np.zeros_like(v)
    seen = States(
        np.linspace(0.0, 1.0, 2000), np.cos(np.linspace(0.0, 20.0, 2000)), v, still, still, still
    )
    free = ["strut.damper.coefficient", "strut.friction.force"]
    richer = ExtendedRig(
        RIG, free, jn.Doubt(), RideExtent(0.007, 0.0015, 0.5), compile_rig(RIG).facts.parameters
    )
    laws = Laws(richer, [seen], every=1)
    p = {**RIG.parameters(), "strut.friction.force": 0.0, "strut.damper.coefficient": 150.0}
    xi = np.zeros(len(richer.nuisances))
    assert laws.readings("strut.friction.force", p, xi, 0.0) == pytest.approx((0.0, 0.0), abs=1e-9)
    places, root = richer.damper_covariance_root()
    bends = np.array([20.0, 5.0, -2.0, -1.0, 1.0, 2.0, -5.0, -20.0])
    xi[list(places)] = np.linalg.solve(root, bends)
    component, effective = laws.readings("strut.friction.force", p, xi, 0.0)
    assert component == 0.0
    assert effective > 1.0


def test_noise_is_what_lies_above_the_motion():
    time = np.arange(2000) / 1000.0
    noise = 0.3 * np.random.default_rng(1).standard_normal(2000)
    assert noise_variance(noise) == pytest.approx(0.09, rel=0.1)
    assert noise_variance(noise + 5.0 * np.sin(2.0 * np.pi * 30.0 * time)) == pytest.approx(
        0.09, rel=0.1
    )


# what is claimed --------------------------------------------------------------------------------------------------


def test_intervals_hold_the_truth_where_those_of_the_noise_do_not(wrong):
    _, found = wrong
    truth = {"strut.spring.rate": 22730.0, "guide.friction.force": 6.0, "tyre.stiffness": 138468.0}
    for path, value in truth.items():
        law = found.discrepancy.parameters[path]
        assert law.interval[0] <= value <= law.interval[1], path
        assert law.interval[0] <= law.component.value <= law.interval[1]
        assert law.interval[0] <= law.effective.value <= law.interval[1]
        assert law.value == pytest.approx(0.5 * sum(law.interval))
    low, high = found.parameters["guide.friction.force"].interval
    assert not low <= 6.0 <= high
    plain = abs(found.parameters["guide.friction.force"].value - 6.0)
    assert (
        abs(found.discrepancy.parameters["guide.friction.force"].component.value - 6.0)
        < 0.5 * plain
    )


def test_what_is_counted_is_told(wrong):
    _, found = wrong
    told = found.discrepancy
    assert told.trials == 3
    assert set(told.unexplained) == {"sprung.az", "unsprung.az"}
    assert all(0.0 <= share <= 1.0 for share in told.unexplained.values())
    assert (
        told.objective < 0.5
    )  # the richer model leaves less than half of what the plain one leaves
    assert told.noise["sprung.az"] == pytest.approx(0.1, rel=0.2)
    assert told.counted["damper_shape"] == 8
    shares = told.parameters["strut.damper.coefficient"].shares
    assert {"damper_shape", "unexplained rest", "height"} <= set(shares)
    assert all(0.0 <= share <= 1.0 for share in shares.values())
    for law in (
        told.parameters.values()
    ):  # the rest alone is estimated from the trials, and only its share counts them
        half = law.component.interval[1] - law.component.value
        freedom = told.trials / max(law.shares["unexplained rest"], 1e-3) ** 2
        assert half == pytest.approx(
            student_factor(freedom) * law.component.standard_error, rel=1e-9
        )
        assert max(law.shares.values()) < 1.0
    over = np.mean(
        [share / (1.0 - share) for share in told.unexplained.values()]
    )  # energy of the rest over the noise
    best = told.reduced_to / (1.0 - told.reduced_to)
    assert best <= 0.8 * over if told.would_reduce else best == pytest.approx(over)


def test_without_model_error_the_price_is_small():
    made = trials({"strut.spring.rate": 23500.0}, noise=0.1)
    found = jn.update_model(made, FREE, weights="normalised", align="lag", doubt=jn.Doubt())
    rate, tyre = (
        found.discrepancy.parameters[path] for path in ("strut.spring.rate", "tyre.stiffness")
    )
    assert rate.identified
    assert tyre.identified
    assert rate.interval[0] < 23500.0 < rate.interval[1]
    assert rate.half_width < 0.1 * rate.value
    assert max(found.discrepancy.unexplained.values()) < 0.5


def test_intervals_of_both_sides_of_a_damper_do_not_follow_the_guess():
    """Passes of a known bilinear damper: both guesses give the same intervals, and the spring its own rate."""
    truth = {"strut.damper.bump_coefficient": 90.0, "strut.damper.rebound_coefficient": 260.0}
    rate, damper = "strut.spring.rate", {"bump_coefficient": 90.0, "rebound_coefficient": 260.0}
    passes, found = trials({"strut.damper": damper}, noise=0.05), []
    for guess in (60.0, 500.0):
        told = RIG.with_changes({"strut.damper": dict.fromkeys(damper, guess)})
        made = [jn.FitTrial(one.name, told, one.trial, one.measured) for one in passes]
        free = free_parameters(
            told, {rate: "15 %", **{path: ["10 N*s/m", "900 N*s/m"] for path in truth}}
        )
        start = {rate: 22730.0, **truth}
        found.append(
            discrepancy_of(fit_model_error(made, free, start, DOUBTED, lags={}), {}).parameters
        )
    for path, value in {rate: 22730.0, **truth}.items():
        low, high = found[0][path].interval
        assert found[1][path].interval == pytest.approx((low, high), rel=1e-6), path
        assert low < value < high
        assert found[0][path].half_width < 0.15 * value, path
    assert found[0][rate].effective.value == pytest.approx(found[0][rate].component.value, rel=5e-3)


def test_a_damper_of_two_sides_that_is_told_as_a_line_is_said_to_have_them(wrong):
    """Known sides are found beside a line between them; one that bends alike on both sides is not of two."""
    made = trials(
        {"strut.damper": {"bump_coefficient": 180.0, "rebound_coefficient": 120.0}}, noise=0.1
    )
    free = free_parameters(RIG, {"strut.spring.rate": "15 %", "strut.damper.coefficient": "50 %"})
    start = {"strut.spring.rate": 22730.0, "strut.damper.coefficient": 150.0}
    found = discrepancy_of(fit_model_error(made, free, start, DOUBTED, lags={}), {})
    told = [finding for finding in found.findings if finding.place == "strut.damper"]
    assert [finding.severity for finding in told] == ["warning"]
    assert told[0].value == pytest.approx(60.0, abs=6.0)
    assert told[0].message.startswith("firmer in bump than in rebound (18")
    assert "rebound_coefficient" in told[0].message
    assert "strut.damper" not in [finding.place for finding in wrong[1].discrepancy.findings]


@pytest.mark.parametrize(
    ("bends", "sure", "told"),
    [
        (np.array([4.0, 2.0, 1.0, 0.2, 0.2, 1.0, 2.0, 4.0]), 1e-3, "bump"),
        (-np.array([4.0, 2.0, 1.0, 0.2, 0.2, 1.0, 2.0, 4.0]), 1e-3, "rebound"),
        (np.array([4.0, 2.0, 1.0, 0.2, 0.2, 1.0, 2.0, 4.0]), 10.0, ""),  # not sure
        (
            np.array([-4.0, -2.0, 1.0, 0.2, -0.2, -1.0, 2.0, 4.0]),
            1e-3,
            "",
        ),  # the same law on both sides
        (
            0.05 * np.array([4.0, 2.0, 1.0, 0.2, 0.2, 1.0, 2.0, 4.0]),
            1e-6,
            "",
        ),  # dampers are no more alike
    ],
)
def test_sides_of_a_damper_differ_where_forces_beside_a_line_have_one_sign(bends, sure, told):
    path = "strut.damper.coefficient"
    rig = RIG.with_changes({path: 20.0})
    richer = ExtendedRig(
        rig, [path], jn.Doubt(), RideExtent(0.007, 0.0015, 0.5), compile_rig(rig).facts.parameters
    )
    places, root = richer.damper_covariance_root()
    xi = np.zeros(len(richer.nuisances))
    xi[list(places)] = np.linalg.solve(root, bends)
    run = SimpleNamespace(fitted_values=lambda theta: {path: float(theta[0])})
    found = _one_sided(SimpleNamespace(
        problem=SimpleNamespace(richer=richer, free=[path], runs=[run]), state=SimpleNamespace(theta=[20.0], xi=xi),
        step=SimpleNamespace(covariance=sure * np.eye(1 + len(xi))),
    ))  # fmt: skip
    assert [finding.message.split()[2] for finding in found] == ([told] if told else [])


def test_fewer_than_three_trials_give_no_such_interval():
    found = jn.update_model(trials({}, count=2), FREE, weights="normalised", doubt=jn.Doubt())
    assert found.discrepancy is None
    assert any(
        "it requires 3 fitted trials (here 2)" in finding.message for finding in found.findings
    )


def test_a_contradicted_bench_value_withholds_its_parameter(wrong):
    made, _ = wrong
    bench = {"tyre.stiffness": Estimate(170e3, 500.0, (169e3, 171e3))}
    found = jn.update_model(
        made, FREE, weights="normalised", align="lag", doubt=jn.Doubt(), bench=bench
    )
    law = found.discrepancy.parameters["tyre.stiffness"]
    assert not law.identified
    assert "contradicts its bench value" in law.why
    middle, half = 0.5 * sum(law.interval), np.hypot(law.half_width, 1e3)
    assert f"{abs(middle - 170e3) / half:.1f} times what both intervals allow" in law.why
    assert found.findings[0].place == "tyre.stiffness"
    assert (
        "this parameter compensates for something that the model lacks" in found.findings[0].message
    )


def test_a_doubt_that_leaves_its_prior_is_named():
    made = trials({"unsprung.mass": 6.0}, noise=0.05)
    sure = jn.Doubt(values={"unsprung.mass": "0.5 %"}, contact_patch=0.0)
    found = jn.update_model(made, FREE, weights="normalised", align="lag", doubt=sure)
    assert found.discrepancy.would_reduce in ("values", "lumped")
    assert not any(law.identified for law in found.discrepancy.parameters.values())
    assert any(
        finding.place == "unsprung.mass" and "doubt.values" in finding.message
        for finding in found.findings
    )


@pytest.mark.usefixtures("units_kept")
def test_a_doubt_that_leaves_its_prior_withholds_what_goes_with_it():
    """A gain of one sensor moves no rate over a mass, but friction, whose interval (3 %) is narrower than the gain."""
    made = [
        replace(one, measured=one.measured.assign({"sprung.az": 1.08 * one.measured["sprung.az"]}))
        for one in trials({}, noise=0.02)
    ]
    found = jn.update_model(
        made, FREE, weights="normalised", align="lag", doubt=jn.Doubt(gain=0.002)
    )
    truth = RIG.parameters()
    for path, law in found.discrepancy.parameters.items():
        assert law.identified == (path != "guide.friction.force")
        assert law.interval[0] <= truth[path] <= law.interval[1]
    (said,) = (finding.message for finding in found.findings if finding.place == "sprung.az gain")
    assert said.endswith("(doubt.gain); for this reason not identified: guide.friction.force")
    strays = {
        "height": _Stray(-9.0, np.array([0.2, 0.99])),
        "strut.angle": _Stray(5.0, np.array([0.3, 1.01])),
    }
    assert [_doubt_behind(strays, i) for i in (0, 1)] == ["", "strut.angle"]


def test_laws_that_are_not_doubted_are_named():
    """In vehicles no law is: the interval says so, since it would look better than it is."""
    car, passes = jn.load("audi-a6-half-car-4dof"), []
    truth = car.with_changes({"front.spring_rate": 31e3})
    for speed in (8.0, 10.0, 14.0):
        bump = jn.HalfSine(height="20 mm", length="0.5 m", start="2 m")
        course = jn.Trial(road=bump, speed=speed, duration="1.2 s")
        run = jn.simulate(truth, course)[["body.az", "body.pitch_rate"]]
        passes.append(jn.FitTrial(f"{speed}", car, course, run))
    found = jn.update_model(
        passes, {"front.spring_rate": "20 %"}, weights="normalised", doubt=jn.Doubt()
    )
    law = found.discrepancy.parameters["front.spring_rate"]
    assert law.interval[0] <= 31e3 <= law.interval[1]
    said = [finding for finding in found.findings if finding.place == "intervals"]
    assert [finding.severity for finding in said] == ["warning"]
    assert "dampers, friction, springs, tyres" in said[0].message


def test_base_motion_is_doubted_in_its_size():
    time = np.linspace(0.0, 1.2, 241)
    truth, passes = RIG.with_changes({"strut.damper": DEGRESSIVE}), []
    for frequency in (1.5, 3.0, 6.0):
        height = 0.006 * np.sin(2.0 * np.pi * frequency * time) * np.minimum(time / 0.3, 1.0)
        course = jn.Trial(excitation=jn.Excitation(time=time, height=height), duration=1.2)
        run = jn.simulate(truth, course)[["sprung.az", "unsprung.az"]]
        passes.append(jn.FitTrial(f"{frequency} Hz", RIG, course, run))
    found = jn.update_model(passes, FREE, weights="normalised", doubt=jn.Doubt())
    assert "height" in found.discrepancy.nuisances
    assert not {"speed", "slowing", "contact_patch"} & set(found.discrepancy.counted)
    law = found.discrepancy.parameters["strut.spring.rate"]
    assert law.interval[0] <= 22730.0 <= law.interval[1]


# priors and doubts as they are written ------------------------------------------------------------------------------


def test_a_prior_narrows_and_draws(wrong):
    made, without = wrong
    tight = {"bounds": "15 %", "prior": ["22.73 N/mm", "0.05 N/mm"]}
    found = jn.update_model(
        made,
        {**FREE, "strut.spring.rate": tight},
        weights="normalised",
        align="lag",
        doubt=jn.Doubt(),
    )
    before, after = (one.discrepancy.parameters["strut.spring.rate"] for one in (without, found))
    assert after.half_width < 0.5 * before.half_width
    assert after.component.value == pytest.approx(22730.0, abs=100.0)
    assert (
        found.parameters["strut.spring.rate"].value == without.parameters["strut.spring.rate"].value
    )


@pytest.mark.parametrize(
    ("given", "doubt", "message"),
    [
        ({"bounds": "15 %", "prior": ["22.7 N/mm", "0.1 N/mm"]}, None, "a prior requires doubt"),
        (
            {"bounds": "15 %", "prior": ["22.7 N/mm"]},
            {},
            "invalid bounds for a parameter with a prior",
        ),
        ({"prior": ["22.7 N/mm", "0.1 N/mm"]}, {}, "invalid bounds for a parameter with a prior"),
        ({"bounds": "15 %", "prior": ["22.7 N/mm", "0 N/mm"]}, {}, "invalid standard deviation"),
        ({"bounds": "15 %", "prior": ["22.7 kg", "0.1 N/mm"]}, {}, "unit"),
        ("15 %", {"heigth": "1 %"}, "heigth"),
        ("15 %", {"height": "-1 %"}, "height"),
        ("15 %", {"values": {"unsprung.mas": "1 %"}}, "unknown parameter"),
        ("15 %", {"values": {"unsprung.mass": "-1 %"}}, "negative"),
    ],
)
def test_priors_and_doubts_that_cannot_be_meant_are_refused(given, doubt, message):
    with pytest.raises((FitError, DescriptionError), match=message):
        jn.update_model(trials({}), {"strut.spring.rate": given}, doubt=doubt)


def test_masses_that_move_far_and_pairs_that_act_alike_lead():
    free = {"sprung.mass": "20 %", "strut.spring.rate": "20 %"}
    found = jn.update_model(
        trials({"strut.damper": DEGRESSIVE, "sprung.mass": 17.5}), free, weights="normalised"
    )
    places = [finding.place for finding in found.findings]
    assert "sprung.mass" in places
    assert any("known from weighing" in finding.message for finding in found.findings)
    value = found.correlation[0][1]
    assert any("strongly correlated" in finding.message for finding in found.findings) == (
        abs(value) > 0.9
    )


# the density of a posterior ---------------------------------------------------------------------------------------


def density_of(made, update, doubt):
    settings = UpdateSettings(weights="normalised", align="lag", tolerance=1e-6, doubt=doubt)
    free = free_parameters(RIG, FREE)
    return DoubtDensity(fit_model_error(made, free, update.values(), settings, lags=update.lags))


@pytest.fixture(scope="module")
def density(wrong):
    """Of doubts that come to rest: friction of the guide follows its velocity."""
    return density_of(*wrong, jn.Doubt(guide_presliding=0.0))


def along(density):
    """Log densities at nine places along a line, and by how much each rise is not that of both slopes."""
    step = density.region.root @ np.array([0.9, -0.2, 0.3, 0.2])
    found = [density(density.best + share * step) for share in np.linspace(-1.0, 1.0, 9)]
    rises = np.diff([one[0] for one in found])
    slopes = np.array([float(one[1] @ step) for one in found])
    return step, found, slopes, np.abs(rises - 0.125 * (slopes[1:] + slopes[:-1]))


@pytest.mark.slow
def test_a_density_whose_doubts_do_not_come_to_rest_is_off_by_little(wrong):
    """Friction that builds up over travel: the search ends with doubts that still move, and slopes lag behind."""
    *_, off = along(density_of(*wrong, jn.Doubt()))
    assert np.median(off) < 0.1
    assert np.max(off) < 0.4


def test_a_density_is_that_of_the_parameters_alone_and_has_its_own_slopes(density):
    """Whatever was asked before; a rise is that of both slopes, but for the few places where wheels lift off."""
    step, found, slopes, off = along(density)
    assert density(density.best - step)[0] == found[0][0]
    assert np.median(off) < 0.01
    assert np.max(off) < 0.2
    assert 0.5 * (slopes[0] - slopes[-1]) == pytest.approx(
        step @ np.linalg.inv(density.covariance) @ step, rel=0.2
    )


def test_draws_lag_as_far_as_is_known_where_lags_are_not_fitted():
    """A fitted trial by what the calibration found and the draw adds; another by half a sample's doubt."""
    state = SimpleNamespace(lags=np.array([1e-4, 3e-4]))
    one = SimpleNamespace(nuisances=[None], runs=[None, None], align=False)
    drawn = object.__new__(DrawnRun)
    drawn.fit, drawn.problem, drawn.rate = SimpleNamespace(problem=one, state=state), one, 1000.0
    step, lags = np.array([9.0, 1.0, 2.0, 3.0, -0.4]), []  # of a doubt; speed and lag of each trial
    for drawn.fitted in (0, 1, None):
        lags.append(drawn._lag(step, None))
    assert lags == pytest.approx([1e-4 + 2.0 * 5e-4, 3e-4 - 0.4 * 5e-4, 0.0])
    many = [drawn._lag(step, np.random.default_rng(i)) for i in range(200)]
    assert np.std(many) == pytest.approx(5e-4, rel=0.2)
    one.align = True
    assert drawn._lag(step, None) == 0.0


def test_where_the_richer_model_does_not_run_a_posterior_is_refused(wrong, monkeypatch):
    """An update then tells of intervals of the noise only; a posterior that was asked for model error is none."""
    made, update = wrong
    why = Finding(
        "intervals",
        "warning",
        "no interval that counts what the model lacks: the extended model diverged",
    )
    lost = replace(update, discrepancy=None, findings=(why,))
    monkeypatch.setattr("jounce.identify.posterior.run_update", lambda *_, **__: (lost, None))
    with pytest.raises(FitError, match="the extended model diverged"):
        jn.posterior(made, FREE, weights="normalised", align="lag", doubt=jn.Doubt(), draws=1000)
