"""Hardpoints from targets on a push-rod double wishbone: derivatives and complete designs, compared with SciPy."""

from __future__ import annotations

from collections.abc import Sequence
from time import perf_counter
from typing import Any

import numpy as np
from scipy.optimize import approx_fprime, least_squares
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
TOLERANCES = {
    "toe": "0.005 deg",
    "camber": "0.02 deg",
    "roll_centre_height": "0.5 mm",
    "motion_ratio": 0.002,
}
TOLERANCES |= {
    "caster": "0.05 deg",
    "scrub_radius": "0.5 mm",
    "caster_trail": "0.5 mm",
    "camber_gain": "0.2 deg/m",
}
_MOST = 30
TRAVELS = (-0.02, 0.02, 0.0, -0.01, 0.01)


def kinematic_design_rows() -> list[Row]:
    """Times of derivatives and designs."""
    rows = _tangents()
    for count, goals, starts, limit in ((14, 12, 8, "≤ 0.5 s"), (30, 40, 64, "≤ 10 s")):
        paths, targets = _task(count, goals)
        rig, free = jn.load(RIG), dict.fromkeys(paths, "15 mm")
        found = jn.design_kinematics(rig, free, targets, starts=starts)
        worst = max(_off(target) for target in found.targets)

        def run(
            rig: Any = rig,
            free: dict[str, str] = free,
            targets: Sequence[Any] = targets,
            starts: int = starts,
        ) -> Any:
            return jn.design_kinematics(rig, free, targets, starts=starts)

        own = median_time(run, repeats=3)
        problem = f"{count} coordinates, {goals} targets"
        way = f"jounce, {starts} starts, worst target {worst:.1g} tolerances"
        rows.append(Row(problem, way, own, None, 1.0, limit))
        theirs, off = _scipy(paths, targets)
        way = f"SciPy least_squares over jn.sweep_travel, 1 start, ≤ {_MOST} steps, worst target {off:.1g} tolerances"
        rows.append(Row(problem, way, theirs, None, theirs / own))
    return [*rows, *_front(), _spread()]


def _tangents() -> list[Row]:
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

    def differences() -> None:
        approx_fprime(before, swept, 1e-6)

    def swept(numbers: np.ndarray) -> np.ndarray:
        sweep.walk.p[points] = numbers
        return np.nan_to_num(sweep.run().ravel())

    before = sweep.walk.p[points].copy()
    median = median_time(both, repeats=51)
    theirs = median_time(differences, repeats=11)
    problem = "push-rod double wishbone, 41 poses"
    way = f"jounce, {len(model.rows)} quantities and slopes to 30 coordinates"
    return [
        Row(problem, way, median, None, 1.0, "≤ 1.2 ms"),
        Row(problem, "SciPy approx_fprime over array sweeps", theirs, None, theirs / median),
    ]


_GOALS = (
    {"quantity": "camber_gain", "value": "-45 deg/m", "tolerance": "1 deg/m"},
    {"quantity": "roll_centre_height", "value": "15 mm", "tolerance": "1 mm"},
)
_MOVES = (
    "upper_arm_front[2]",
    "upper_arm_rear[2]",
    "lower_arm_front[2]",
    "lower_arm_rear[2]",
    "upper_ball_joint[2]",
)
_FROM = (60.0, 60.0)  # tolerances: where areas under fronts count from


def _front() -> list[Row]:
    """A Pareto front of two objectives, and that of pymoo's NSGA-II for the same model, if installed."""
    free, problem = (
        {f"hardpoints.{name}": "5 mm" for name in _MOVES},
        "Pareto front of two objectives, 5 coordinates, 20 designs",
    )

    def run() -> Any:
        return jn.kinematic_front(RIG, free, _GOALS, points=20)

    front = run()
    own = median_time(run, repeats=3)
    area = _area([tuple(design.goals.values()) for design in front.designs])
    way = f"jounce, {front.evaluations} designs evaluated, hypervolume {area:.4g}"
    rows = [Row(problem, way, own, None, 1.0)]
    try:
        from pymoo.algorithms.moo.nsga2 import NSGA2
        from pymoo.core.problem import ElementwiseProblem
        from pymoo.optimize import minimize
    except ImportError:
        return rows
    rig = jn.load(RIG)
    sweep = prepare_sweep(rig, [0.0])
    names = [row.name for row in sweep.model.rows]
    places = [names.index(str(goal["quantity"])) for goal in _GOALS]
    points = [sweep.model.parameters.index(path) for path in free]
    before = sweep.walk.p[points].copy()

    class Goals(ElementwiseProblem):  # type: ignore[misc]
        def __init__(self) -> None:
            super().__init__(
                n_var=len(free),
                n_obj=2,
                xl=np.full(len(free), -0.005),
                xu=np.full(len(free), 0.005),
            )

        def _evaluate(self, x: np.ndarray, out: dict[str, Any], *_: object, **__: object) -> None:
            sweep.walk.p[points] = before + x
            gain, centre = sweep.run()[places].ravel()
            out["F"] = [abs(np.degrees(gain) + 45.0), abs(1e3 * centre - 15.0)]

    def theirs() -> Any:
        return minimize(Goals(), NSGA2(pop_size=40), ("n_gen", 100), seed=1)

    found = theirs()
    time = median_time(theirs, repeats=1)
    way = f"pymoo NSGA-II, 4000 designs evaluated, hypervolume {_area([tuple(one) for one in found.F]):.4g}"
    return [*rows, Row(problem, way, time, None, time / own)]


def _area(front: Sequence[tuple[float, ...]]) -> float:
    """Hypervolume of a front of two objectives: the larger, the better."""
    total, height = 0.0, _FROM[1]
    for first, second in sorted(front):
        if second < height:
            total += (_FROM[0] - first) * (height - second)
            height = second
    return total


def _spread() -> Row:
    toe = {"quantity": "toe", "over": "-30 mm:30 mm:10 mm", "value": 0.0, "tolerance": "0.05 deg"}
    made = {"points": "0.5 mm", "links": "0.3 mm", "adjust": ["tie_rod_length"], "cars": 100}
    median = median_time(lambda: jn.kinematic_spread(RIG, [toe], made), repeats=1)
    return Row("tolerance study, 100 cars, one adjustment", "jounce", median)


def _task(count: int, goals: int) -> tuple[list[str], list[dict[str, Any]]]:
    """Free paths, and targets that a known rig within their boxes meets."""
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
    """Time (s) and worst target of a script with finite differences of sweeps."""
    rig = jn.load(RIG)
    before = np.array([rig.parameters()[path] for path in paths])
    read = jn.design_kinematics(
        rig, {paths[0]: "1 mm"}, targets, starts=1
    ).targets  # values and tolerances in SI
    heights = np.unique([target["at"] for target in targets])

    def off(shift: np.ndarray) -> np.ndarray:
        moved = rig.with_changes(dict(zip(paths, (before + shift).tolist(), strict=True)))
        swept = jn.sweep_travel(moved, heights)
        rows = [
            (
                float(swept[item["quantity"]][np.searchsorted(heights, item["at"])])
                - float(goal.wanted)
            )
            / goal.tolerance
            for item, goal in zip(targets, read, strict=True)
        ]
        return np.array(rows)

    def run() -> Any:
        return least_squares(
            off, np.zeros(len(paths)), bounds=(-0.015, 0.015), x_scale=0.015, max_nfev=_MOST
        )

    begin = perf_counter()
    worst = float(np.max(np.abs(run().fun)))
    return perf_counter() - begin, worst


if __name__ == "__main__":
    from timing import markdown

    print(markdown(kinematic_design_rows()))
