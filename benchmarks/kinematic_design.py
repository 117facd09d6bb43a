"""Hardpoints from targets on a push-rod double wishbone: slopes of all rows, and whole designs, beside SciPy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.optimize import least_squares
from timing import Row, median_time

import jounce as jn
from jounce.kinematics.model import kinematic_model
from jounce.kinematics.sweeps import prepare_sweep
from jounce.kinematics.tangents import Tangents

RIG = "formula-student-front"
POINTS = (
    "upper_arm_front",
    "upper_arm_rear",
    "tie_rod_inner",
    "upper_ball_joint",
    "pushrod_inner",
    "lower_arm_front",
    "lower_arm_rear",
    "lower_ball_joint",
    "tie_rod_outer",
    "pushrod_outer",
)
TOLERANCES = {"toe": "0.005 deg", "camber": "0.02 deg", "roll_centre_height": "0.5 mm", "motion_ratio": 0.002}
TOLERANCES |= {"caster": "0.05 deg", "scrub_radius": "0.5 mm", "caster_trail": "0.5 mm", "camber_gain": "0.2 deg/m"}
TRAVELS = (-0.02, 0.02, 0.0, -0.01, 0.01)


def kinematic_design_rows() -> list[Row]:
    """Times of slopes and of designs."""
    rows = [_tangents()]
    for count, goals, starts, limit in ((14, 12, 8, "≤ 0.5 s"), (30, 40, 64, "≤ 10 s")):
        paths, targets = _task(count, goals)
        rig, free = jn.load(RIG), dict.fromkeys(paths, "15 mm")
        found = jn.design_kinematics(rig, free, targets, starts=starts)
        worst = max(_off(target) for target in found.targets)

        def run(
            rig: Any = rig, free: dict[str, str] = free, targets: Sequence[Any] = targets, starts: int = starts
        ) -> Any:
            return jn.design_kinematics(rig, free, targets, starts=starts)

        own = median_time(run, repeats=3)
        problem = f"{count} coordinates, {goals} targets"
        way = f"jounce, {starts} starts, worst target {worst:.1g} tolerances"
        rows.append(Row(problem, way, own, None, 1.0, limit))
        if count < 20:
            theirs, off = _scipy(paths, targets)
            way = f"SciPy least_squares over jn.sweep_travel, 1 start, worst target {off:.1g} tolerances"
            rows.append(Row(problem, way, theirs, None, theirs / own))
    return rows


def _tangents() -> Row:
    rig = jn.load(RIG)
    model = kinematic_model(rig)
    sweep = prepare_sweep(rig, np.linspace(-0.03, 0.03, 41))
    points = [i for i, path in enumerate(model.parameters) if path.startswith("hardpoints.")][:30]
    directions = np.zeros((len(model.tracks) + len(model.parameters), len(points)))
    directions[len(model.tracks) + np.array(points), np.arange(len(points))] = 1.0
    tangents = Tangents(sweep, directions)

    def both() -> None:
        sweep.run()
        tangents.run()

    median = median_time(both, repeats=51)
    problem = "push-rod double wishbone, 41 poses"
    return Row(
        problem, f"jounce, {len(model.rows)} quantities and slopes to 30 coordinates", median, None, None, "≤ 1.2 ms"
    )


def _task(count: int, goals: int) -> tuple[list[str], list[dict[str, Any]]]:
    """Paths that are free, and targets that another rig within their boxes meets."""
    rig, random = jn.load(RIG), np.random.default_rng(3)
    paths = [f"hardpoints.{name}[{i}]" for name in POINTS for i in range(3)][:count]
    before = rig.parameters()
    other = rig.with_changes({path: before[path] + random.uniform(-0.005, 0.005) for path in paths})
    targets = [
        {
            "quantity": name,
            "at": travel,
            "value": float(jn.sweep_travel(other, travel)[name][0]),
            "tolerance": tolerance,
        }
        for travel in TRAVELS
        for name, tolerance in TOLERANCES.items()
    ]
    return paths, targets[:goals]


def _off(target: Any) -> float:
    return abs(float(target.after) - float(target.wanted)) / target.tolerance


def _scipy(paths: list[str], targets: list[dict[str, Any]]) -> tuple[float, float]:
    """Seconds and worst target of a script around sweeps: differences of whole sweeps."""
    rig = jn.load(RIG)
    before = np.array([rig.parameters()[path] for path in paths])
    read = jn.design_kinematics(rig, {paths[0]: "1 mm"}, targets, starts=1).targets  # values and tolerances in SI
    heights = np.unique([target["at"] for target in targets])

    def off(shift: np.ndarray) -> np.ndarray:
        moved = rig.with_changes(dict(zip(paths, (before + shift).tolist(), strict=True)))
        swept = jn.sweep_travel(moved, heights)
        rows = [
            (float(swept[item["quantity"]][np.searchsorted(heights, item["at"])]) - float(goal.wanted)) / goal.tolerance
            for item, goal in zip(targets, read, strict=True)
        ]
        return np.array(rows)

    def run() -> Any:
        return least_squares(off, np.zeros(len(paths)), bounds=(-0.015, 0.015), x_scale=0.015)

    worst = float(np.max(np.abs(run().fun)))
    return median_time(run, repeats=1), worst


if __name__ == "__main__":
    from timing import markdown

    print(markdown(kinematic_design_rows()))
