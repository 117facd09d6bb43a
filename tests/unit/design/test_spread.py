"""Tolerance studies: bands of many cars against closed forms, what adjustments bring back, what cannot be asked."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import jounce as jn
from jounce.design.kinematic_study import Spread
from jounce.design.kinematics import read_task
from jounce.kinematics.refitting import Changes, refit, rod_lengths

TOE = {"quantity": "toe", "over": "-20 mm:20 mm:20 mm", "value": 0.0, "tolerance": "0.05 deg"}
RATIO = {"quantity": "motion_ratio", "value": 0.59, "tolerance": 0.01}
FRONT = "formula-student-front"


def test_the_band_of_one_part_is_its_spread_times_its_effect() -> None:
    rig, tolerance = jn.load(FRONT), 0.4e-3
    made = {"exact": {"tie_rod_inner length": tolerance}, "cars": 40, "seed": 3}
    found = jn.kinematic_spread(rig, [TOE, RATIO], made)
    step = 1e-4
    ends = [jn.apply_adjustments(rig, {"tie_rod_length": sign * step}) for sign in (-1.0, 1.0)]
    effect = (ends[1].wheel.toe - ends[0].wheel.toe) / (
        2.0 * step
    )  # rad/m, by the adjustments' own assembly
    drawn = np.random.default_rng(3).standard_normal((40, _sources(rig)))
    lengths = drawn[:, _index_of_tie_rod(rig)] * tolerance / 2.0
    toe = found.targets[0]
    middle = toe.at.index(0.0)
    low, high = np.percentile(effect * lengths, [2.5, 97.5])
    assert (toe.low[middle], toe.high[middle]) == pytest.approx((low, high), rel=0.02)
    assert toe.causes == {"tie_rod_inner length": pytest.approx(1.0)}
    assert found.failed == 0
    assert toe.low_adjusted == toe.low  # nothing is adjusted


def _sources(rig: jn.Rig) -> int:
    """Deviations a car: nine points on the body or rocker, three joints, the push rod's end, links and push rod."""
    held, joints, rocker = 6, 3, 4
    return 3 * (held + joints + rocker) + len(rod_lengths(rig)) + 1


def _index_of_tie_rod(rig: jn.Rig) -> int:
    return _sources(rig) - 1 - len(rod_lengths(rig)) + list(rod_lengths(rig)).index("tie_rod_inner")


def test_the_tie_rod_brings_back_what_the_tie_rod_did() -> None:
    made = {"exact": {"tie_rod_inner length": "0.5 mm"}, "adjust": ["tie_rod_length"], "cars": 15}
    found = jn.kinematic_spread(FRONT, [TOE], made)
    (toe,) = found.targets
    assert found.met < 0.5
    assert found.met_adjusted == 1.0
    assert (
        np.max(np.abs([*toe.low_adjusted, *toe.high_adjusted])) <= np.max(np.abs(toe.drawn)) + 1e-6
    )
    need = found.adjustments["tie_rod_length"]
    assert -0.6e-3 < need.low < -0.2e-3
    assert 0.2e-3 < need.high < 0.6e-3
    assert need.at_its_end == 0.0
    assert found.table().count("\n") == 4


def test_a_rocker_that_is_off_changes_the_motion_ratio_alone() -> None:
    found = jn.kinematic_spread(FRONT, [TOE, RATIO], {"exact": {"rocker_pivot": "1 mm"}, "cars": 6})
    toe, ratio = found.targets
    assert toe.low == pytest.approx(toe.drawn, abs=1e-12)
    assert ratio.high[0] - ratio.low[0] > 0.002
    assert set(ratio.causes) == {"rocker_pivot"}


@pytest.mark.parametrize(
    ("rig", "made", "words"),
    [
        (FRONT, {"points": "0 mm"}, "the spread contains no deviation"),
        (FRONT, {"exact": {"tie_rod_iner": "1 mm"}}, "tie_rod_inner"),
        (FRONT, {"points": "1 mm", "adjust": ["strut_angle"]}, "tie_rod_length"),
        (FRONT, {"points": "1 mm", "adjust": ["tie_rod_lenght"]}, "tie_rod_length"),
        ("semi-trailing-arm", {"links": "1 mm"}, "the spread contains no deviation"),  # it has none
    ],
)
def test_what_cannot_be_asked_of_a_spread(rig: str, made: dict, words: str) -> None:
    with pytest.raises(jn.DescriptionError, match=words):
        jn.kinematic_spread(rig, [{"quantity": "camber", "value": 0.0, "tolerance": "1 deg"}], made)


def test_a_trailing_arm_hangs_on_the_brackets_that_were_made() -> None:
    """The arm keeps its shape and lies with its eyes on the line of both brackets; the wheel stands on its height."""
    rig = jn.load("semi-trailing-arm")
    away = {
        "arm_inner": np.array([0.003, -0.002, 0.004]),
        "arm_outer": np.array([-0.002, 0.001, -0.003]),
    }
    given = rig.hardpoints.given()
    brackets = {name: np.array(given[name]) + shift for name, shift in away.items()}
    built = refit(rig, Changes({name: tuple(place.tolist()) for name, place in brackets.items()}))
    points = {name: np.array(place) for name, place in built.hardpoints.given().items()}
    own = ("arm_inner", "arm_outer", "wheel_centre", "strut_bottom")
    for one in own:
        for other in own:
            drawn = np.linalg.norm(np.subtract(given[one], given[other]))
            assert np.linalg.norm(points[one] - points[other]) == pytest.approx(drawn, abs=1e-13)
    line = brackets["arm_outer"] - brackets["arm_inner"]
    for name in away:
        off = points[name] - brackets["arm_inner"]
        assert np.linalg.norm(np.cross(off, line)) / np.linalg.norm(line) < 1e-13
    assert points["wheel_centre"][2] == pytest.approx(given["wheel_centre"][2], abs=1e-14)
    toe = {
        "quantity": "toe",
        "over": "-20 mm:20 mm:20 mm",
        "value": "0 deg",
        "tolerance": "0.1 deg",
    }
    found = jn.kinematic_spread(rig, [toe], {"points": "1 mm", "cars": 40})
    assert found.failed == 0
    assert set(found.targets[0].causes) >= {"arm_inner", "arm_outer"}
    assert found.targets[0].low[1] < found.targets[0].drawn[1] < found.targets[0].high[1]


def test_a_spread_passes_over_a_rig_without_targets() -> None:
    rigs = {"front": jn.load(FRONT), "rear": jn.load(FRONT)}
    task = read_task(rigs, {"front.hardpoints.tie_rod_inner": "5 mm"}, [{**TOE, "rig": "front"}])
    spread = Spread(points="1 mm", cars=2)
    replace(task, spread=spread).check_spread(task.read()[2])
    with pytest.raises(jn.DescriptionError, match="the spread contains no deviation"):
        replace(task, spread=Spread(points=0.0)).check_spread(task.read()[2])
