"""Fronts between competing goals: against every design of a fine grid, and what cannot be asked."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

FRONT = "formula-student-front"
FREE = {"hardpoints.upper_arm_front[2]": "8 mm", "hardpoints.lower_arm_front[2]": "8 mm"}
GAIN = {"quantity": "camber_gain", "value": "-45 deg/m", "tolerance": "1 deg/m"}
CENTRE = {"quantity": "roll_centre_height", "value": "15 mm", "tolerance": "1 mm"}


def test_no_design_of_a_grid_is_better_than_the_front_and_the_front_is_whole() -> None:
    front = jn.kinematic_front(FRONT, FREE, [GAIN, CENTRE], points=9, starts=1)
    found = np.array([list(design.goals.values()) for design in front.designs])
    assert len(found) >= 7
    assert np.all(np.diff(found[:, 0]) > 0.0)
    assert np.all(np.diff(found[:, 1]) < 0.0)
    rig = jn.load(FRONT)
    start = rig.parameters()
    grid = []
    for upper in np.linspace(-0.008, 0.008, 9):
        for lower in np.linspace(-0.008, 0.008, 9):
            moved = dict(zip(FREE, (upper, lower), strict=True))
            swept = jn.sweep_travel(
                rig.with_changes({path: start[path] + by for path, by in moved.items()}), [0.0]
            )
            gain, centre = float(swept["camber_gain"][0]), float(swept["roll_centre_height"][0])
            grid.append((abs(np.degrees(gain) + 45.0), abs(1e3 * centre - 15.0)))
    grid = np.array(grid)
    for one in found:
        assert not np.any(np.all(grid < one - 0.02, axis=1))
    ends = grid.min(axis=0)
    assert found.min(axis=0) == pytest.approx(ends, abs=0.3)
    # between two neighbours of the front no design of the grid lies nearer to the origin than their chord by much
    best = grid[np.argmin(grid.sum(axis=1))]
    assert np.min(found.sum(axis=1)) <= best.sum() + 0.3


def test_designs_are_rigs_and_what_must_hold_holds() -> None:
    free = {**FREE, "hardpoints.tie_rod_inner[2]": "15 mm"}
    toe = {
        "quantity": "toe",
        "over": "-30 mm:30 mm:15 mm",
        "value": 0.0,
        "tolerance": "0.05 deg",
        "must": True,
    }
    front = jn.kinematic_front(FRONT, free, [GAIN, CENTRE, toe], points=4, starts=1)
    assert front.held == (2,)
    for k, design in enumerate(front.designs):
        (rig,) = front.rigs(k).values()
        swept = jn.sweep_travel(rig, "-30 mm:30 mm:15 mm")
        assert float(np.max(np.abs(swept["toe"]))) <= np.radians(0.05) * (1.0 + 1e-6)
        gain = float(swept["camber_gain"].sel(wheel_travel=0.0))
        assert abs(np.degrees(gain) + 45.0) == pytest.approx(design.goals["camber_gain"], abs=1e-4)
    assert front.table().count("\n") == len(front.designs) + 2


def test_targets_of_one_goal_belong_together() -> None:
    steer = {"quantity": "bump_steer", "value": 0.0, "tolerance": "1 deg/m"}
    targets = [{**GAIN, "goal": "camber"}, {**CENTRE, "goal": "rest"}, {**steer, "goal": "rest"}]
    front = jn.kinematic_front(FRONT, FREE, targets, points=3, starts=1)
    assert front.goals == {"camber": (0,), "rest": (1, 2)}
    held = jn.kinematic_front(
        FRONT, FREE, [*targets[:2], {**steer, "tolerance": "20 deg/m"}], points=3, starts=1
    )
    assert held.held == (2,)


def test_one_design_that_is_best_in_all_is_said() -> None:
    targets = [
        {**GAIN, "value": "-33 deg/m"},
        {"quantity": "bump_steer", "value": 0.0, "tolerance": "1 deg/m"},
    ]
    free = {"hardpoints.upper_arm_front[2]": "8 mm", "hardpoints.tie_rod_inner[2]": "8 mm"}
    front = jn.kinematic_front(FRONT, free, targets, points=4, starts=1)
    assert len(front.designs) == 1
    assert front.designs[0].met
    assert "no trade-off" in str(front.findings[0])


@pytest.mark.parametrize(
    ("targets", "options", "words"),
    [
        ([GAIN], {}, "at least two goals"),
        ([GAIN, {**CENTRE, "must": True}], {}, "at least two goals"),
        ([GAIN, CENTRE], {"points": 2}, "3 to 500"),
        ([GAIN, CENTRE], {"starts": 0}, "1 or more"),
        (
            [
                GAIN,
                CENTRE,
                {
                    "quantity": "camber",
                    "at_least": "20 deg",
                    "tolerance": "1 deg",
                    "at": "10 mm",
                    "must": True,
                },
            ],
            {"starts": 1},
            "meets the constraints",
        ),
    ],
)
def test_what_cannot_be_asked_of_a_front(targets: list, options: dict, words: str) -> None:
    with pytest.raises(jn.DescriptionError, match=words):
        jn.kinematic_front(FRONT, FREE, targets, **options)
