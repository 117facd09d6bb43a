"""What a calibration claims and withholds, from intervals and doubts as they come out of it."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

import jounce as jn
from jounce.identify.discrepancy import (
    NuisanceEstimate,
    _Block,
    _Calibration,
    _contradictions,
    _findings,
    _law_estimate,
    _length,
    _State,
    _Stray,
)
from jounce.identify.estimate import Estimate
from jounce.identify.laws import Laws, States
from jounce.identify.richer import Richer, Ridden
from jounce.simulation.compiled import compile_rig

COMPONENT, EFFECTIVE = Estimate(10.0, 1.0, (8.0, 12.0)), Estimate(11.0, 1.0, (9.0, 14.0))


def test_an_interval_is_the_hull_of_both_values() -> None:
    law = _law_estimate(COMPONENT, EFFECTIVE, {"height": 0.3}, "", {}, "a")
    assert (law.value, law.interval, law.identified, law.why) == (11.0, (8.0, 14.0), True, "")
    assert (law.component, law.effective, law.shares) == (COMPONENT, EFFECTIVE, {"height": 0.3})
    unknown = _law_estimate(Estimate(7.0), EFFECTIVE, {}, "", {}, "a")
    assert unknown.interval == (7.0, 14.0)


@pytest.mark.parametrize(("half", "why"), [(4.9, ""), (5.1, "its interval is wider than its value")])
def test_what_is_wider_than_its_value_is_not_identified(half: float, why: str) -> None:
    for value in (10.0, -10.0):
        law = _law_estimate(*[Estimate(value, 1.0, (value - half, value + half))] * 2, {}, "", {}, "a")
        assert (law.identified, law.why) == (not why, why)


def test_why_a_parameter_is_withheld() -> None:
    law = _law_estimate(COMPONENT, EFFECTIVE, {}, "height", {"a": "2.0 times what both intervals allow"}, "a")
    assert (law.identified, law.why) == (False, "contradicts its bench value by 2.0 times what both intervals allow")
    law = _law_estimate(COMPONENT, EFFECTIVE, {}, "height", {"b": "?"}, "a")
    assert (law.identified, law.why) == (False, "height leaves its prior")


@pytest.mark.parametrize(
    ("bench", "told"), [(16.0, ""), (5.9, "1.0 times"), (16.1, "1.0 times"), (21.0, "2.0 times"), (6.1, "")]
)
def test_bench_values_are_held_against_both_intervals(bench: float, told: str) -> None:
    estimates = {"a": (COMPONENT, EFFECTIVE), "b": (COMPONENT, EFFECTIVE)}  # 11 +- 3, with 4 of the bench 5
    found = _contradictions(estimates, {"a": Estimate(bench, 1.0, (bench - 4.0, bench + 4.0)), "c": Estimate(9.0)})
    assert [text.startswith(told) for text in found.values()] == [True] * bool(told)
    sure = _contradictions(estimates, {"b": Estimate(14.1), "a": Estimate(13.9)})
    assert sure == {"b": "1.0 times what both intervals allow"}


def test_findings_of_a_calibration_name_what_to_do() -> None:
    nuisances = {"speed": NuisanceEstimate("inputs", "1", 2.0, 0.5, 0.4, 0.1)}
    assert nuisances["speed"].moved == pytest.approx(-3.2)
    one = SimpleNamespace(free=[SimpleNamespace(path="a"), SimpleNamespace(path="b")])
    strays = {"speed": _Stray(-3.2, np.array([0.2, 1.01]))}
    found = _findings(one, strays, nuisances, {"a": "2.0 times"}, {"x": 0.3, "y": 0.51}, "height", 0.42)
    assert [(one.place, one.severity, one.value) for one in found] == [
        ("a", "warning", None), ("speed", "warning", -3.2), ("y", "note", 0.51)
    ]  # fmt: skip
    assert "on the bench by 2.0 times" in found[0].message
    assert "3.2 standard deviations" in found[1].message
    assert found[1].message.endswith("(doubt.inputs); not identified for it: b")
    for draws, told in (
        ((0.99, 0.0), "no parameter depends on it"),
        ((1.1, 1.1), "no parameter of this update counts"),
    ):
        drawn = _findings(one, {"speed": _Stray(-3.2, np.array(draws))}, nuisances, {}, {"x": 0.3}, "", 0.3)
        assert told in drawn[0].message
    assert found[2].message.startswith("51 % of what is left")
    assert found[2].message.endswith("explains it; more freedom for height would leave 42 % of all")
    assert _findings(one, {}, {}, {}, {"x": 0.51}, "", 0.51)[0].message.endswith("nothing that was doubted explains it")
    assert _findings(one, {}, {}, {}, {"x": 0.3, "y": 0.49}, "height", 0.42) == []


def test_laws_that_are_as_described_read_as_they_are() -> None:
    """Where nothing bends, both readings of each parameter are its value; presliding adds to dry friction."""
    time = np.linspace(0.0, 4.0, 4001)
    wave = np.sin(9.0 * time)
    strut, velocity = 0.007 + 0.01 * np.cos(5.0 * time), -0.05 * np.sin(5.0 * time)
    seen = States(time, strut, velocity, 0.001 + 0.002 * wave, 0.018 * np.cos(9.0 * time), 0.3 * np.cos(7.0 * time))
    rig = jn.load("kart-quarter-car").with_changes({
        "strut.friction": {"force": 4.0, "regularisation_velocity": 0.005},
        "guide.friction": {"force": 6.0, "regularisation_velocity": 0.02},
    })  # fmt: skip
    paths = ("strut.spring.rate", "strut.damper.coefficient", "strut.friction.force", "guide.friction.force",
             "tyre.stiffness", "tyre.damping_coefficient")  # fmt: skip
    richer = Richer(
        rig, paths, jn.Doubt(tyre_curvature=0.0), Ridden(0.007, 0.0015, 1.0), compile_rig(rig).facts.parameters
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
    off = States(time, strut, velocity, seen.tyre - 1.0, seen.tyre_rate, seen.body)  # it never touches
    assert Laws(richer, [seen, off]).readings("tyre.stiffness", p, xi, 0.0)[1] == pytest.approx(140e3)
    np.testing.assert_allclose(seen.acceleration()[1:-1], -0.25 * np.cos(5.0 * time)[1:-1], atol=1e-5)


@pytest.mark.parametrize(
    ("name", "ridden", "curved"),
    [
        ("kart-quarter-car", Ridden(0.007, 0.0015, 1.0), {"strut.spring", "tyre"}),
        ("kart-quarter-car", Ridden(0.0, 0.0015, 1.0), {"tyre"}),
        ("kart-quarter-car", Ridden(0.007, 0.0, 1.0), {"strut.spring"}),
        ("kart-double-wishbone", Ridden(0.007, 0.0015, 1.0), {"tyre"}),
    ],
)
def test_what_may_be_curved_is_what_is_loaded(name: str, ridden: Ridden, curved: set[str]) -> None:
    rig = jn.load(name)
    richer = Richer(rig, [], jn.Doubt(), ridden, compile_rig(rig).facts.parameters)
    assert set(richer._curved) == curved
    assert richer._gone() & {"strut.spring.rate", "tyre.stiffness"} == {
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
    free = [SimpleNamespace(lower=0.0, scaled=lambda value: value - 2.0), SimpleNamespace(lower=-1.0)]
    one = SimpleNamespace(free=free, nuisances=["a"], align=True, runs=[None, None], own=[("speed", 0.1)])
    state = _State(np.array([-1.9, 0.3]), np.array([0.2]), np.array([[0.1], [0.2]]), np.array([1e-3, -2e-3]))
    step, late = np.array([-4.0, 0.5, -0.7, 0.4, -0.3]), (0.003, -0.001)  # parameters, doubt, a speed of each trial
    blocks = []
    for trial in (0, 1, 0):
        common, own, lag = draw(size=(30, 3)), draw(size=(30, 1)), draw(size=30)
        residual = share * (common @ step[:3] + own @ step[3 + trial : 4 + trial]) + late[trial] * lag
        blocks.append(_Block("az", trial, residual, common, own, lag))
    moved = _Calibration.moved(one, state, step, blocks, share)
    np.testing.assert_allclose(moved.lags, state.lags + late, rtol=1e-9)
    np.testing.assert_allclose(moved.theta, [-2.0, 0.3 + 0.5 * share])
    np.testing.assert_allclose(moved.xi, [0.2 - 0.7 * share])
    np.testing.assert_allclose(moved.own.ravel(), [0.1 + 0.4 * share, 0.2 - 0.3 * share])


def test_the_length_of_a_channel_is_the_mean_of_its_own_blocks() -> None:
    rows = [(name, None, np.zeros(count), None) for name, count in (("a", 10), ("b", 50), ("a", 20))]
    assert [_length(SimpleNamespace(rows=rows), name) for name in "ab"] == [15.0, 50.0]
