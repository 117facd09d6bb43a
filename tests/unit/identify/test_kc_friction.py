"""Dry friction in updates to K&C sheets: estimated from bounce, simulated, and counted."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.identify.kc_friction import FrictionCurve, FrictionEffects, strut_friction

RIG = jn.load("generic-mcpherson")
SPRING = "strut.spring.rate"
RUBBED = RIG.with_changes({"strut.friction": {"force": 60.0}})


@pytest.mark.parametrize("noise", [0.0, 3.0])
def test_the_friction_of_the_strut_follows_from_the_loop_of_wheel_loads(noise: float) -> None:
    sheet = jn.kc_test(RUBBED, "bounce")
    rng = np.random.default_rng(1)
    for name in ("left.vertical_force", "right.vertical_force"):
        seen = sheet[name].values + rng.normal(0.0, noise, sheet.sizes["sample"])
        sheet[name] = sheet[name].copy(data=seen)
    assert strut_friction(RIG, {"bounce": sheet}, 0.0) == pytest.approx(60.0, rel=0.02 + noise / 60)


def test_without_a_loop_or_with_stated_friction_nothing_is_estimated() -> None:
    plain = {"bounce": jn.kc_test(RIG, "bounce")}
    assert strut_friction(RIG, plain, 0.0) == 0.0
    assert strut_friction(RUBBED, {"bounce": jn.kc_test(RUBBED, "bounce")}, 0.0) == 0.0
    half = {"bounce": jn.kc_test(RUBBED, "bounce").isel(sample=slice(0, 11))}
    assert strut_friction(RIG, half, 0.0) == 0.0


def test_what_friction_adds_is_the_difference_of_both_simulations() -> None:
    """In a test with forces a strut that sticks keeps the wheel from rising: no loop shows it."""
    with_it, without = (jn.kc_test(rig, "lateral-opposed") for rig in (RUBBED, RIG))
    x = with_it["input"].values
    nodes = np.array([-1000.0, -500.0, 0.0, 500.0, 1000.0])
    curve = FrictionCurve("lateral-opposed", "left.camber", nodes, is_open=False, sweep=x)
    (added,) = FrictionEffects(RUBBED, RIG, 0.0).of({}, [curve], "load", "locked")
    assert {len(np.unique(np.round(run["input"].values))) for run in (with_it, without)} == {21}

    def mean(run: object) -> np.ndarray:
        values = run["left.camber"].values  # type: ignore[index]
        down = np.interp(nodes, x[10:31][::-1], values[10:31][::-1])
        up = np.interp(nodes, [*x[30:-1], *x[:11]], [*values[30:-1], *values[:11]])
        return 0.5 * (up + down)

    want = mean(with_it) - mean(without)
    assert added == pytest.approx(want, abs=1e-9)
    assert np.abs(added).max() > 1e-5


@pytest.mark.parametrize("start", [RIG, RUBBED], ids=["not stated", "stated"])
def test_a_spring_beside_friction_is_found(start: jn.Rig) -> None:
    truth = RUBBED.with_changes({SPRING: 1.1 * RIG.parameters()[SPRING]})
    sheet = {name: jn.kc_test(truth, name) for name in ("bounce", "roll")}
    fit = jn.update_kc(start, sheet, {SPRING: "30 %"})
    estimate = fit.parameters[SPRING]
    assert estimate.value == pytest.approx(truth.parameters()[SPRING], rel=2e-3)
    assert estimate.has(truth.parameters()[SPRING])
    named = {item.code for item in fit.findings}
    assert ("identify.kc_friction_estimated" in named) == (start is RIG)


@pytest.mark.parametrize("is_stated", [False, True])
def test_loops_that_friction_of_bushings_opens_are_reported(is_stated: bool) -> None:
    soft = {
        "stiffness": ["8 kN/mm", "6 kN/mm", "3 kN/mm"],
        "rotational_stiffness": ["5 N*m/deg"] * 3,
    }
    plain = RIG.with_changes({"bushings": {"lower_arm_front": soft, "lower_arm_rear": soft}})
    dry = plain.with_changes({"bushings.lower_arm_rear.friction": ["200 N", "200 N", "200 N"]})
    sheet = {name: jn.kc_test(dry, name, points=21) for name in ("bounce", "lateral-opposed")}
    free = {"bushings.lower_arm_rear.stiffness[1]": "30 %"}
    fit = jn.update_kc(dry if is_stated else plain, sheet, free)
    said = [item for item in fit.findings if item.code == "identify.kc_loops_open"]
    assert len(said) == (0 if is_stated else 1)
    assert all("lateral-opposed" in str(item) and "not estimated" in str(item) for item in said)


def test_friction_that_holds_the_wheel_does_not_draw_the_numbers_towards_it() -> None:
    """Under aligning moments the wheel moves vertically by 30 µm, a fifth of what it would without friction."""
    rig = jn.load("mcpherson-elastic")
    point, mount = "hardpoints.tie_rod_inner[2]", "subframe.mounts[0].stiffness[2]"
    truth = {
        point: rig.hardpoints.tie_rod_inner[2] + 0.0025,
        mount: 0.8 * rig.parameters()[mount],
    }
    changed = rig.with_changes(truth)
    tests = ("bounce", "lateral-in-phase", "aligning-opposed")
    sheet = {test: jn.kc_test(changed, test, points=21) for test in tests}
    for names, free in ((tests, {point: "5 mm", mount: "50 %"}), (tests[2:], {point: "5 mm"})):
        fit = jn.update_kc(rig, {name: sheet[name] for name in names}, free)
        assert all(estimate.has(truth[path]) for path, estimate in fit.parameters.items())
        assert "identify.kc_friction_unsettled" not in {item.code for item in fit.findings}
        if names == tests:
            assert abs(fit.parameters[point].value - truth[point]) < 1e-4
            assert fit.parameters.keys() == {point}  # the mount moves nothing by a micrometre
