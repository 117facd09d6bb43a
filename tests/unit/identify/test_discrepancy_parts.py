"""What a calibration claims and withholds, from intervals and doubts as they come out of it."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

import jounce as jn
from jounce.identify import discrepancy
from jounce.identify.discrepancy import (
    ModelErrorProblem,
    NuisanceEstimate,
    _ChannelResiduals,
    _contradictions,
    _findings,
    _free_group_by_group,
    _groups,
    _in_prior_deviations,
    _law_estimate,
    _length,
    _mean_squares,
    _OwnDoubt,
    _Run,
    _SearchPoint,
    _share_of_rest,
    _shares,
    _State,
    _Stray,
    _System,
    noise_variance,
)
from jounce.identify.estimate import Estimate
from jounce.identify.extended_rig import ExtendedRig, Nuisance, RideExtent
from jounce.identify.laws import Laws, States
from jounce.simulation.compiled import compile_rig

COMPONENT, EFFECTIVE = Estimate(10.0, 1.0, (8.0, 12.0)), Estimate(11.0, 1.0, (9.0, 14.0))


def test_an_interval_is_the_hull_of_both_values() -> None:
    law = _law_estimate(COMPONENT, EFFECTIVE, {"height": 0.3}, "", {}, "a", 0.1)
    assert (law.value, law.interval, law.identified, law.why) == (11.0, (8.0, 14.0), True, "")
    assert (law.component, law.effective, law.shares) == (COMPONENT, EFFECTIVE, {"height": 0.3})
    unknown = _law_estimate(Estimate(7.0), EFFECTIVE, {}, "", {}, "a", 0.1)
    assert unknown.interval == (7.0, 14.0)


@pytest.mark.parametrize(
    ("half", "why"), [(4.9, ""), (5.1, "its interval is wider than its value")]
)
def test_what_is_wider_than_its_value_is_not_identified(half: float, why: str) -> None:
    for value in (10.0, -10.0):
        law = _law_estimate(
            *[Estimate(value, 1.0, (value - half, value + half))] * 2, {}, "", {}, "a", 0.1
        )
        assert (law.identified, law.why) == (not why, why)


def test_why_a_parameter_is_withheld() -> None:
    law = _law_estimate(
        COMPONENT, EFFECTIVE, {}, "height", {"a": "2.0 times what both intervals allow"}, "a", 0.9
    )
    assert (law.identified, law.why) == (
        False,
        "contradicts its bench value by 2.0 times what both intervals allow",
    )
    law = _law_estimate(COMPONENT, EFFECTIVE, {}, "height", {"b": "?"}, "a", 0.9)
    assert (law.identified, law.why) == (False, "height leaves its prior")


@pytest.mark.parametrize(
    ("bench", "told"),
    [(16.0, ""), (5.9, "1.0 times"), (16.1, "1.0 times"), (21.0, "2.0 times"), (6.1, "")],
)
def test_bench_values_are_held_against_both_intervals(bench: float, told: str) -> None:
    estimates = {
        "a": (COMPONENT, EFFECTIVE),
        "b": (COMPONENT, EFFECTIVE),
    }  # 11 +- 3, with 4 of the bench 5
    found = _contradictions(
        estimates, {"a": Estimate(bench, 1.0, (bench - 4.0, bench + 4.0)), "c": Estimate(9.0)}
    )
    assert [text.startswith(told) for text in found.values()] == [True] * bool(told)
    sure = _contradictions(estimates, {"b": Estimate(14.1), "a": Estimate(13.9)})
    assert sure == {"b": "1.0 times what both intervals allow"}


def test_findings_of_a_calibration_name_what_to_do() -> None:
    nuisances = {"speed": NuisanceEstimate("inputs", "1", 2.0, 0.5, 0.4, 0.1)}
    assert nuisances["speed"].deviations == pytest.approx(-3.2)
    one = SimpleNamespace(free=[SimpleNamespace(path="a"), SimpleNamespace(path="b")])
    strays = {"speed": _Stray(-3.2, np.array([0.2, 1.01]))}
    found = _findings(
        one, strays, nuisances, {"a": "2.0 times"}, {"x": 0.3, "y": 0.51}, "height", 0.42
    )
    assert [(one.place, one.severity, one.value) for one in found] == [
        ("a", "warning", None), ("speed", "warning", -3.2), ("y", "note", 0.51)
    ]  # fmt: skip
    assert "on the bench by 2.0 times" in found[0].message
    assert "3.2 standard deviations" in found[1].message
    assert found[1].message.endswith("(doubt.inputs); for this reason not identified: b")
    for draws, told in (
        ((0.99, 0.0), "no parameter depends on it"),
        ((1.1, 1.1), "no parameter of this update counts"),
    ):
        drawn = _findings(
            one, {"speed": _Stray(-3.2, np.array(draws))}, nuisances, {}, {"x": 0.3}, "", 0.3
        )
        assert told in drawn[0].message
    assert found[2].message.startswith("with all uncertain inputs fitted, 51 %")
    assert found[2].message.endswith(
        "explains it; more freedom for height would reduce the residual to 42 % of the total"
    )
    assert _findings(one, {}, {}, {}, {"x": 0.51}, "", 0.51)[0].message.endswith(
        "none of these inputs explains it"
    )
    assert _findings(one, {}, {}, {}, {"x": 0.3, "y": 0.49}, "height", 0.42) == []


def test_laws_that_are_as_described_read_as_they_are() -> None:
    """Where nothing bends, both readings of each parameter are its value; presliding adds to dry friction."""
    time = np.linspace(0.0, 4.0, 4001)
    wave = np.sin(9.0 * time)
    strut, velocity = 0.007 + 0.01 * np.cos(5.0 * time), -0.05 * np.sin(5.0 * time)
    seen = States(
        time,
        strut,
        velocity,
        0.001 + 0.002 * wave,
        0.018 * np.cos(9.0 * time),
        0.3 * np.cos(7.0 * time),
    )
    rig = jn.load("kart-quarter-car").with_changes({
        "strut.friction": {"force": 4.0, "regularisation_velocity": 0.005},
        "guide.friction": {"force": 6.0, "regularisation_velocity": 0.02},
    })  # fmt: skip
    paths = ("strut.spring.rate", "strut.damper.coefficient", "strut.friction.force", "guide.friction.force",
             "tyre.stiffness", "tyre.damping_coefficient")  # fmt: skip
    richer = ExtendedRig(
        rig,
        paths,
        jn.Doubt(tyre_curvature=0.0),
        RideExtent(0.007, 0.0015, 1.0),
        compile_rig(rig).facts.parameters,
    )
    changed = dict(zip(paths, (23e3, 150.0, 5.0, 7.0, 140e3, 20.0), strict=True))
    p, xi = {**rig.parameters(), **changed}, np.zeros(len(richer.nuisances))
    for every in (1, 3):
        laws = Laws(richer, [seen, seen], every)
        assert {path: laws.readings(path, p, xi, 0.0) for path in paths} == {
            path: pytest.approx((value, value), rel=1e-9) for path, value in changed.items()
        }
    component, effective = laws.readings("strut.friction.force", p, xi, 2.0)
    assert component == 7.0
    assert 5.5 < effective < 7.0  # it lags the friction and is a part of it
    assert laws.readings("sprung.mass", p, xi, 2.0) == (p["sprung.mass"],) * 2
    off = States(
        time, strut, velocity, seen.tyre - 1.0, seen.tyre_rate, seen.body
    )  # it never touches
    assert Laws(richer, [seen, off]).readings("tyre.stiffness", p, xi, 0.0)[1] == pytest.approx(
        140e3
    )
    np.testing.assert_allclose(
        seen.acceleration()[1:-1], -0.25 * np.cos(5.0 * time)[1:-1], atol=1e-5
    )


@pytest.mark.parametrize(
    ("name", "ridden", "curved"),
    [
        ("kart-quarter-car", RideExtent(0.007, 0.0015, 1.0), {"strut.spring", "tyre"}),
        ("kart-quarter-car", RideExtent(0.0, 0.0015, 1.0), {"tyre"}),
        ("kart-quarter-car", RideExtent(0.007, 0.0, 1.0), {"strut.spring"}),
        ("kart-double-wishbone", RideExtent(0.007, 0.0015, 1.0), {"tyre"}),
    ],
)
def test_what_may_be_curved_is_what_is_loaded(
    name: str, ridden: RideExtent, curved: set[str]
) -> None:
    rig = jn.load(name)
    richer = ExtendedRig(rig, [], jn.Doubt(), ridden, compile_rig(rig).facts.parameters)
    assert set(richer._curved) == curved
    masses = {one.group: one.deviation for one in richer.nuisances if one.name.endswith("mass")}
    assert masses == {
        group: {"stated": 0.005, "lumped": 0.02, "estimated": 0.03}[group] for group in masses
    }
    assert ("stated" in masses) == (name == "kart-double-wishbone")
    assert richer._absent_paths() & {"strut.spring.rate", "tyre.stiffness"} == {
        f"{part}.{'rate' if part == 'strut.spring' else 'stiffness'}" for part in curved
    }
    for part in curved:
        numbers = richer.numbers(rig.parameters(), {}, np.zeros(len(richer.nuisances)))
        coefficients = [path for path in numbers if path.startswith(f"{part}.curve.coefficients")]
        assert len(coefficients) == 1 + len(richer._curved[part])


@pytest.mark.parametrize("share", [1.0, 0.5])
def test_lags_follow_what_a_step_leaves(share: float) -> None:
    """Residuals that are what the unknowns and a lag make of them: the lag is found; no parameter falls below zero."""
    draw = np.random.default_rng(6).normal
    free = [
        SimpleNamespace(lower=0.0, scale=lambda value: value - 2.0),
        SimpleNamespace(lower=-1.0),
    ]
    one = SimpleNamespace(
        free=free,
        nuisances=["a"],
        align=True,
        runs=[None, None],
        own=[_OwnDoubt("speed", "speed", 0.1)],
    )
    state = _State(
        np.array([-1.9, 0.3]), np.array([0.2]), np.array([[0.1], [0.2]]), np.array([1e-3, -2e-3])
    )
    step, late = (
        np.array([-4.0, 0.5, -0.7, 0.4, -0.3]),
        (0.003, -0.001),
    )  # parameters, doubt, a speed of each trial
    blocks = []
    for trial in (0, 1, 0):
        common, own, lag = draw(size=(30, 3)), draw(size=(30, 1)), draw(size=30)
        residual = (
            share * (common @ step[:3] + own @ step[3 + trial : 4 + trial]) + late[trial] * lag
        )
        blocks.append(_ChannelResiduals("az", trial, residual, common, own, lag))
    moved = ModelErrorProblem.step_state(one, state, step, blocks, share)
    np.testing.assert_allclose(moved.lags, state.lags + late, rtol=1e-9)
    np.testing.assert_allclose(moved.theta, [-2.0, 0.3 + 0.5 * share])
    np.testing.assert_allclose(moved.xi, [0.2 - 0.7 * share])
    np.testing.assert_allclose(moved.own.ravel(), [0.1 + 0.4 * share, 0.2 - 0.3 * share])


def test_the_length_of_a_channel_is_the_mean_of_its_own_blocks() -> None:
    rows = [
        (name, None, np.zeros(count), None) for name, count in (("a", 10), ("b", 50), ("a", 20))
    ]
    assert [_length(SimpleNamespace(rows=rows), name) for name in "ab"] == [15.0, 50.0]


def system(samples: int = 400) -> _System:
    """Two channels in two trials: a parameter, something that is doubted, and one unknown of each trial."""
    draw = np.random.default_rng(8)
    rows = []
    for trial in range(2):
        for name, noise in (("a", 0.1), ("b", 0.4)):
            columns = np.cumsum(draw.normal(size=(samples, 3)), axis=0) / samples**0.5
            lacking = np.sin(0.02 * np.arange(samples) * (1.0 + trial))
            residual = (
                columns @ [0.5, -0.2, 0.3] + 0.3 * lacking + noise * draw.normal(size=samples)
            )
            rows.append((name, columns, residual, np.array([0, 1, 2 + trial])))
    return _System(
        ["a", "b"],
        rows,
        np.array([0.0, 1.0, 1.0, 1.0]),
        np.array([0.0, 0.4, 0.1, -0.2]),
        np.zeros((0, 5)),
    )


def test_what_was_weighed_counts_beside_the_priors() -> None:
    """One row says that the sum of both unknowns is 3 with a standard deviation of 1, another is no news."""
    away, slopes = np.array([0.0, 0.5]), np.array([[1.0, 1.0], [0.0, 0.0]])
    equations = _System([], [], np.array([0.0, 4.0]), away, np.column_stack([slopes, [3.0, 0.0]]))
    information, score, square = equations.beforehand()
    assert information.tolist() == [[1.0, 1.0], [1.0, 5.0]]
    assert score.tolist() == [3.0, 1.0]
    assert square == 4.0 * 0.25 + 9.0
    assert equations.solve().step == pytest.approx([3.5, -0.5])


def test_a_step_weighs_noise_and_a_third_of_the_energy_of_the_rest() -> None:
    """Normal equations by hand, with the weights that the step itself leaves."""
    one = system()
    found = one.solve()
    step = found.step
    left = [(name, residual - columns @ step[index]) for name, columns, residual, index in one.rows]
    for name in "ab":
        own = [each for channel, each in left if channel == name]
        noise = np.mean([noise_variance(each) for each in own])
        energy = np.mean([len(each) * (np.mean(each**2) - noise_variance(each)) for each in own])
        assert found.noise[name] == pytest.approx(noise, rel=1e-3)
        assert found.energy[name] == pytest.approx(energy, rel=1e-3)
        assert found.square[name] == pytest.approx(
            np.mean([np.mean(each**2) for each in own]), rel=1e-3
        )

    def information(share: float) -> np.ndarray:
        total = np.diag(one.prior)
        for name, columns, _, index in one.rows:
            place = np.eye(4)[index]
            total = total + place.T @ columns.T @ columns @ place / (
                found.noise[name] + share * found.energy[name]
            )
        return total

    np.testing.assert_allclose(found.covariance, np.linalg.inv(information(1.0 / 3.0)), rtol=1e-3)
    score = -one.prior * one.away
    for name, columns, residual, index in one.rows:
        score = score + np.eye(4)[index].T @ columns.T @ residual / (
            found.noise[name] + found.energy[name] / 3.0
        )
    np.testing.assert_allclose(step, found.covariance @ score, rtol=1e-3)
    doubted = np.array([False, True, False, False])
    for rest, share in ((True, 1.0 / 3.0), (False, 0.0)):
        kept = np.linalg.inv(np.delete(np.delete(information(share), 1, 0), 1, 1))
        known = one.covariance_given(doubted, found, rest=rest)
        np.testing.assert_allclose(np.delete(np.delete(known, 1, 0), 1, 1), kept, rtol=1e-9)
        assert not known[1].any()


def test_shares_of_what_a_parameter_owes_to_doubts_and_to_the_rest() -> None:
    one = system()
    found = one.solve()
    free = [SimpleNamespace(path="k")]
    nuisances = [SimpleNamespace(name="gravel", group="height", mean=0.0, deviation=1.0)]
    calibration = SimpleNamespace(
        free=free,
        nuisances=nuisances,
        runs=[0, 1],
        own=[_OwnDoubt("speed", "speed", 0.1)],
        align=True,
    )
    masks = _groups(calibration, 4)
    assert {name: mask.tolist() for name, mask in masks.items()} == {
        "height": [False, True, False, False], "speed": [False, False, True, True]
    }  # fmt: skip
    held = SimpleNamespace(
        free=free,
        nuisances=nuisances,
        runs=[0, 1],
        own=[_OwnDoubt("speed", "speed", 0.1)],
        align=False,
    )
    assert {name: np.flatnonzero(mask).tolist() for name, mask in _groups(held, 6).items()} == {
        "height": [1], "speed": [2, 4], "lag": [3, 5]
    }  # fmt: skip
    slopes = np.array([[2.0, 0.5]])  # of the reading by parameter and doubt
    error = np.sqrt(np.einsum("ij,jl,il->i", slopes, found.covariance[:2, :2], slopes))
    shares = _shares(calibration, one, found, slopes, error)
    covariances = {name: one.covariance_given(mask, found) for name, mask in masks.items()}
    covariances["unexplained rest"] = one.covariance_given(
        np.zeros(4, dtype=bool), found, rest=False
    )
    for name, covariance in covariances.items():
        expected = 1.0 - float(slopes[0] @ covariance[:2, :2] @ slopes[0]) / error[0] ** 2
        assert shares["k"][name] == pytest.approx(expected)
        assert 0.0 < expected < 1.0
    rest = _share_of_rest(one, found, np.stack([slopes, slopes]), np.stack([error, error]))
    assert rest == pytest.approx(np.full((2, 1), shares["k"]["unexplained rest"]))


def test_noise_is_the_power_above_eleven_twentieths_of_the_band() -> None:
    count = 800  # 401 frequencies; from the 220th on, but for the last
    time = np.arange(count)
    for place, is_in in ((219, False), (220, True), (399, True), (400, False)):
        wave = np.cos(2.0 * np.pi * place * time / count)
        power = np.sum(np.abs(np.fft.rfft(wave)) ** 2) / count
        assert noise_variance(wave) == pytest.approx(power / 180.0 * is_in, abs=1e-9)


def test_a_step_that_cannot_be_simulated_is_halved() -> None:
    tried: list[float] = []

    def blocks(share: float) -> tuple[list[str], list[str]]:
        if share > 0.2:
            raise jn.SimulationError("diverged")
        return ["blocks"], ["states"]

    def moved(_: object, __: object, ___: object, share: float) -> float:
        tried.append(share)
        return share

    one = SimpleNamespace(step_state=moved, blocks=blocks, free=["k"])
    place = _SearchPoint(one, None, [], [])
    after = place.after(
        np.array([50.0, 3.0 / 0.8])
    )  # doubts go three standard deviations at most, parameters as far
    assert (after.state, after.blocks, after.states) == (pytest.approx(0.2), ["blocks"], ["states"])
    assert tried == pytest.approx([0.8, 0.4, 0.2])
    one.blocks = lambda _: blocks(1.0)
    with pytest.raises(jn.SimulationError, match="diverged"):
        place.after(np.array([1.0, 0.0]))


def test_mean_squares_are_those_of_each_channel() -> None:
    blocks = [_ChannelResiduals(name, 0, np.full(count, size), *[np.zeros(0)] * 3)
              for name, count, size in (("a", 4, 1.0), ("b", 9, 3.0), ("a", 2, 2.0))]  # fmt: skip
    assert _mean_squares(blocks) == {"a": 2.5, "b": 9.0}


def test_inputs_and_sensors_are_doubted_as_the_doubts_say() -> None:
    rig = jn.load("kart-quarter-car")
    richer = SimpleNamespace(
        has_laws=True, rig=rig, values=rig.parameters(), extent=RideExtent(0.007, 0.0015, 1.0)
    )
    one = SimpleNamespace(
        beside={}, doubt=jn.Doubt(), richer=richer, runs=[SimpleNamespace(patched=True)], free=[]
    )
    assert {
        each.name: (each.unit, each.mean, each.deviation) for each in ModelErrorProblem._inputs(one)
    } == {
        "height": ("1", 0.0, 0.015),
        "contact_patch": ("m^2", pytest.approx(0.009**2), pytest.approx(1.5 * 0.009**2)),
        "presliding": ("N", 0.0, 4.0),
        "arms": ("kg", 0.0, pytest.approx(0.2)),
    }
    nothing = jn.Doubt(height=0.0, contact_patch=0.0, presliding=0.0, arms=0.0)
    assert (
        ModelErrorProblem._inputs(
            SimpleNamespace(beside={}, doubt=nothing, richer=richer, runs=one.runs, free=[])
        )
        == []
    )
    channels = [
        SimpleNamespace(name=name, measured=np.array([1.0, 3.0]), sensor=sensor)
        for name, sensor in (("a", jn.Sensor(low_pass="50 Hz")), ("b", None), ("c", jn.Sensor()))
    ]
    runs = [SimpleNamespace(channels=channels)]

    def sensors(doubt: jn.Doubt) -> list[Nuisance]:
        problem = SimpleNamespace(beside={}, doubt=doubt, runs=runs)
        problem.gain_doubt = lambda channel: ModelErrorProblem.gain_doubt(problem, channel)
        return ModelErrorProblem._sensors(problem)

    assert {each.name: (each.group, each.mean, each.deviation) for each in sensors(jn.Doubt())} == {
        "a corner": ("corner", 0.0, 0.15),
        "b bandwidth": ("bandwidth", 0.0, 0.0005),
        "c bandwidth": ("bandwidth", 0.0, 0.0005),
    } | {
        f"{name} {group}": (group, 0.0, deviation)
        for name in "abc"
        for group, deviation in (("gain", 0.01), ("bias", 0.03))
    }
    sure = jn.Doubt(gain=0.0, bias=0.0, corner=0.0, bandwidth=0.0)
    assert sensors(sure) == []


def test_a_pass_at_another_speed_that_slows_down_comes_later() -> None:
    """At 2 m/s instead of 2.5; what it slows begins at the obstacle, and what it has lost stays behind it."""
    track = jn.mechanics.interpolated([0.0, 1.0, 2.0, 3.0, 5.0], [0.0, 0.0, 1.0, 0.0, 0.0])
    run = SimpleNamespace(road=True, speed=2.5, passing=(1.0, 3.0))
    moved = _Run._warp(run, track, {"speed": -0.5, "slowing": 0.1})
    assert moved.edges[1:-1] == pytest.approx(
        [0.0, 1.25, 2.5 + 0.05 / 2.0, 3.75 + 0.1, 6.25 + 0.1 + 0.2]
    )
    assert _Run._warp(SimpleNamespace(road=False), track, {"speed": -0.5}) is track


def test_doubts_in_their_own_deviations_are_those_of_correlated_forces() -> None:
    root = np.array([[2.0, 0.0], [1.0, 3.0]])
    nuisances = [SimpleNamespace(deviation=deviation) for deviation in (9.0, 4.0, 5.0)]
    one = SimpleNamespace(
        richer=SimpleNamespace(damper_covariance_root=lambda: ((1, 2), root)), nuisances=nuisances
    )
    assert _in_prior_deviations(one, np.array([7.0, 2.0, -1.0])).tolist() == [7.0, 1.0, -0.2]


@pytest.mark.parametrize(("reach", "named"), [(0.5, ""), (40.0, "height")])
def test_a_group_that_would_explain_the_rest_is_named(reach: float, named: str) -> None:
    """A rest of the shape of what a height does, which its prior does not allow."""
    draw = np.random.default_rng(9)
    shape = np.sin(0.05 * np.arange(500))
    columns = np.column_stack([np.cos(0.013 * np.arange(500)), 0.1 * shape])
    rows = [("a", columns, 0.1 * reach * shape + 0.05 * draw.normal(size=500), np.array([0, 1]))]
    free = [SimpleNamespace(path="k")]
    nuisances = [SimpleNamespace(name="bump", group="height", mean=0.0, deviation=1.0)]
    one = SimpleNamespace(
        free=free, nuisances=nuisances, runs=[0], own=[], align=True, names=["a"],
        richer=SimpleNamespace(damper_covariance_root=lambda: None),
    )  # fmt: skip
    equations = _System(["a"], rows, np.array([0.0, 1.0]), np.array([0.0, 0.0]), np.zeros((0, 3)))
    found = equations.solve()
    state = _State(np.zeros(1), np.zeros(1), np.zeros((1, 0)), np.zeros(1))
    slopes = np.array([[[1.0, 0.02]], [[1.0, 0.0]]])
    name, left, strays = _free_group_by_group(
        one, state, equations, found, slopes, np.array([[0.5], [0.5]])
    )
    assert name == named
    freer = equations.solve(np.array([0.0, 1e-4]))
    energy = (freer if named else found).energy["a"] / (500.0 * found.noise["a"])
    assert left == pytest.approx(energy / (1.0 + energy))
    assert set(strays) == ({"bump"} if named else set())
    for stray in strays.values():
        assert stray.to == pytest.approx(freer.step[1])
        assert stray.to == pytest.approx(reach, rel=0.1)
        assert stray.draws == pytest.approx(np.abs(slopes @ freer.step).max(axis=0) / 0.5)


def test_forces_beside_the_strut_are_added_to_what_was_measured() -> None:
    times = np.linspace(0.0, 1.0, 41)
    given = jn.mechanics.interpolated([0.0, 0.5, 1.0], [0.0, 3.0, 1.0])
    shape, other = np.sin(9.0 * times), np.cos(5.0 * times)
    run = SimpleNamespace(
        beside={"presliding": shape, "arms": other}, prepared=SimpleNamespace(times=times)
    )
    force = _Run._command(run, given, {"presliding": 2.0, "height": 9.0})
    assert force.evaluate(times[:-1])[0] == pytest.approx(
        given.evaluate(times[:-1])[0] + 2.0 * shape[:-1]
    )
    middle = 0.5 * (times[1:] + times[:-1])
    assert force.evaluate(middle)[0] == pytest.approx(
        np.interp(middle, times, given.evaluate(times)[0] + 2.0 * shape)
    )
    assert _Run._command(SimpleNamespace(beside={}), given, {"presliding": 2.0}) is given


@pytest.mark.parametrize(
    ("square", "length", "step"),
    [
        (1e-4, 0.01, 0.002),
        (-1.0, 5e-4, 5e-4),
        (2.4e-7, 5e-4, 5e-4),
        (4e-6, 0.002, 5e-4),
        (4e-4, 0.02, 0.003),
    ],
)
def test_a_road_is_averaged_over_the_patch(
    monkeypatch: pytest.MonkeyPatch, square: float, length: float, step: float
) -> None:
    road = jn.HalfSine(height="10 mm", length="60 mm")
    monkeypatch.setattr(discrepancy, "excitation", lambda _, __, trial, ___: [trial.road])
    source = SimpleNamespace(rig=None, trial=jn.Trial(road=road, speed=2.0, duration=0.3))
    facts = SimpleNamespace(tracks=["guide"])
    run = SimpleNamespace(compiled=SimpleNamespace(facts=facts, free=()), patched=True, _roads={},
                          prepared=SimpleNamespace(source=source))  # fmt: skip
    run._tracks = lambda patch: _Run._tracks(run, patch)
    (averaged,) = _Run.signals(run, {"contact_patch": square})
    assert (averaged.of, averaged.method) == (road, "moving-average")
    assert (averaged.contact_length, averaged.step) == pytest.approx((length, step))
    run.patched = False
    assert _Run.signals(run, {"contact_patch": square}) == [road]


BILINEAR = jn.load("kart-quarter-car").with_changes({
    "strut.damper": {"bump_coefficient": 90.0, "rebound_coefficient": 260.0},
    "strut.friction": {"force": 12.0, "regularisation_velocity": 0.005},
})  # fmt: skip
SIDES = ("strut.damper.bump_coefficient", "strut.damper.rebound_coefficient")
_TIME = np.linspace(0.0, 2.0, 2001)
_PASS = np.exp(-1.5 * _TIME) * np.sin(
    14.0 * _TIME
)  # one that leaves a mean deflection, and bump unlike rebound


def _passed(strut: np.ndarray) -> States:
    return States(
        _TIME, strut, np.gradient(strut, _TIME), 0.001 + 0.0 * _TIME, 0.0 * _TIME, 0.0 * _TIME
    )


def _richer(
    rig: jn.QuarterCar, free: tuple[str, ...], fitted: dict[str, float] | None = None
) -> ExtendedRig:
    used = compile_rig(rig).facts.parameters
    return ExtendedRig(
        rig, free, jn.Doubt(spring_curvature=0.0), RideExtent(0.007, 0.0015, 0.5), used, fitted
    )


@pytest.mark.parametrize("friction", [(), ("strut.friction.force",)])
def test_an_asymmetric_damper_that_is_as_described_leaves_the_spring_its_rate(
    friction: tuple[str, ...],
) -> None:
    paths = ("strut.spring.rate", *SIDES, *friction)
    richer = _richer(BILINEAR, paths)
    p, xi = BILINEAR.parameters(), np.zeros(len(richer.nuisances))
    laws = Laws(richer, [_passed(0.007 + 0.01 * _PASS)])
    for path in paths:
        assert laws.readings(path, p, xi, 0.0) == pytest.approx((p[path], p[path]), rel=1e-9), path


def test_friction_that_the_rig_states_is_no_part_of_the_damper() -> None:
    rig = BILINEAR.with_changes({"strut.damper": {"coefficient": 150.0}})
    paths = ("strut.spring.rate", "strut.damper.coefficient")
    richer = _richer(rig, paths)
    laws = Laws(richer, [_passed(0.007 + 0.01 * _PASS)])
    for path in paths:
        p = rig.parameters()
        assert laws.readings(path, p, np.zeros(len(richer.nuisances)), 0.0) == pytest.approx(
            (p[path],) * 2
        ), path


def test_forces_beside_a_law_of_two_sides_count_on_the_side_they_are_on() -> None:
    """The same force on both sides is so much more in bump and so much less in rebound."""
    richer = _richer(BILINEAR, SIDES)
    places, root = richer.damper_covariance_root()
    xi = np.zeros(len(richer.nuisances))
    xi[list(places)] = np.linalg.solve(
        root, 40.0 * np.array([-0.5, -0.175, -0.06, -0.015, 0.015, 0.06, 0.175, 0.5])
    )
    laws, p = Laws(richer, [_passed(0.007 + 0.01 * _PASS)]), BILINEAR.parameters()
    for path in SIDES:  # 40 N s/m more on either side, whichever reading
        assert laws.readings(path, p, xi, 0.0) == pytest.approx((p[path] + 40.0,) * 2, rel=1e-6)
    xi[list(places)] = np.linalg.solve(root, np.full(8, 10.0))
    bump, rebound = (laws.readings(path, p, xi, 0.0) for path in SIDES)
    assert min(bump) > p[SIDES[0]] + 10.0
    assert max(rebound) < p[SIDES[1]] - 10.0
    only = Laws(richer, [_passed(0.007 + 0.01 * _TIME)])  # never in rebound
    assert only.readings(SIDES[1], p, xi, 0.0) == (p[SIDES[1]],) * 2
    assert min(only.readings(SIDES[0], p, xi, 0.0)) > p[SIDES[0]]


def test_what_is_doubted_of_a_damper_is_a_share_of_the_law_that_was_fitted() -> None:
    fitted = dict(zip(SIDES, (90.0, 260.0), strict=True))
    starts = [(30.0, 30.0), (600.0, 50.0)]
    guesses = [BILINEAR.with_changes(dict(zip(SIDES, start, strict=True))) for start in starts]
    here = [one.deviation for one in _richer(BILINEAR, SIDES).nuisances]
    for guess in guesses:
        assert [one.deviation for one in _richer(guess, SIDES, fitted).nuisances] == pytest.approx(
            here
        )
        assert [one.deviation for one in _richer(guess, SIDES).nuisances] != pytest.approx(
            here, rel=0.1
        )


@pytest.mark.parametrize(
    ("fitted", "knotted"), [((0.0, 260.0), True), ((90.0, 0.0), True), ((0.0, 0.0), False)]
)
def test_a_side_that_is_fitted_to_nothing_stays_as_it_is(
    fitted: tuple[float, float], *, knotted: bool
) -> None:
    values, doubt = dict(zip(SIDES, fitted, strict=True)), jn.Doubt(damper_force=0.0)
    richer = ExtendedRig(BILINEAR, SIDES, doubt, RideExtent(0.007, 0.0015, 0.5), [], values)
    assert (richer.damper_covariance_root() is not None) == knotted
    assert ("damper" in richer.laws_as_described()) == (not knotted)
    assert all(np.isfinite(one.deviation) and one.deviation > 0.0 for one in richer.nuisances)
