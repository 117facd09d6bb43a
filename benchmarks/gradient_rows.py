"""Rows of the benchmark table for slopes, stiff variants and closed loops of the prototype's double wishbone.

``python benchmarks/gradient_rows.py`` prints them alone.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from mechanism_problem import DURATION, SPEEDS, TIMES, TYRES, Case
from timing import Row, markdown, median_time

import jounce as jn
from jounce.core.segments import Segments
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.prepare import prepare, solve
from jounce.simulation.reduced import ReducedCorner, Reduction, reduction_of
from jounce.simulation.result import Solution

RIG = Path(__file__).parent.parent / "tests" / "files" / "prototype-double-wishbone.toml"
FREE = (
    "hardpoints.strut_bottom[2]",
    "hardpoints.upper_ball_joint[1]",
    "hardpoints.lower_ball_joint[1]",
    "hardpoints.tie_rod_outer[2]",
    "hardpoints.lower_arm_front[2]",
    "sprung.mass",
    "bodies.upright.mass",
    "strut.spring.rate",
    "strut.damper.coefficient",
    "tyre.stiffness",
)
CHANNEL = "sprung.az"
ARMS = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")
BUSHING = {"stiffness": [1e7] * 3, "rotational_stiffness": [20.0] * 3}
STIFF = {"bushings": dict.fromkeys(ARMS, BUSHING), "strut.friction": {"force": 10.0}}


def in_turns(runs: dict[str, Callable[[], object]], rounds: int = 31) -> dict[str, float]:
    """Median time (s) of each; they run alternately, so other load on the machine affects all of them."""
    times: dict[str, list[float]] = {way: [] for way in runs}
    for _ in range(rounds):
        for way, run in runs.items():
            start = time.perf_counter()
            run()
            times[way].append(time.perf_counter() - start)
    return {way: float(np.median(each)) for way, each in times.items()}


def gradient_rows() -> list[Row]:
    """Mean square of the body's acceleration and its derivatives with respect to ten parameters, complete runs."""
    rows = []
    for tyre in TYRES:
        rig, road = _rig(tyre), _road(Case(tyre, SPEEDS[0]))
        plain, sensitive = compile_rig(rig), compile_rig(rig, FREE)
        p, column = plain.parameter_values(rig.parameters()), plain.output_names.index(CHANNEL)

        def value(
            p: np.ndarray, plain: Compiled = plain, road: Segments = road, column: int = column
        ) -> float:
            return float(np.mean(solve(plain, p, road, TIMES).outputs[column] ** 2))

        def slopes(
            p: np.ndarray = p,
            sensitive: Compiled = sensitive,
            road: Segments = road,
            column: int = column,
        ) -> np.ndarray:
            run: Solution = solve(sensitive, p, road, TIMES)
            return 2.0 * run.output_slopes[column] @ run.outputs[column] / len(TIMES)

        corner = ReducedCorner(_reduction(rig), rig.parameters(), [road], TIMES, 1e-5, FREE)

        def reduced(corner: ReducedCorner = corner, column: int = column) -> np.ndarray:
            found = corner.run()
            assert found is not None
            run = found[0]
            return 2.0 * run.output_slopes[column] @ run.outputs[column] / len(TIMES)

        def differences(p: np.ndarray = p, plain: Compiled = plain, value=value) -> np.ndarray:  # noqa: ANN001
            start, found = value(p), []
            for path in FREE:
                i = plain.facts.parameters.index(path)
                step = 1e-6 * abs(p[i])
                found.append((value(p + step * np.eye(len(p))[i]) - start) / step)
            return np.array(found)

        problem = f"gradient along ten parameters, double wishbone, {tyre} tyre, 3 s at 1 kHz"
        off = f"error {_apart(differences(), slopes()):.0e}"
        ways = {
            "one simulation": (lambda value=value, p=p: value(p), "", ""),
            "jounce, sensitivities with the run": (slopes, "≤ 6 simulations", ""),
            "jounce, sensitivities of the corner as one coordinate": (
                reduced,
                "",
                f"error {_apart(reduced(), slopes()):.0e}",
            ),
            "one-sided finite differences, same engine": (differences, "", off),
        }
        times = in_turns({way: run for way, (run, _, _) in ways.items()})
        one = times["one simulation"]
        rows += [
            Row(problem, way, times[way], None, times[way] / one, *texts)
            for way, (_, *texts) in ways.items()
        ]
    return rows


def stiff_rows() -> list[Row]:
    """Arms on bushings of 1e7 N/m with friction in the strut, compared with ball joints without friction."""
    runs, methods = {}, {}
    for way, changes in (("rigid joints", {}), ("bushings of 1e7 N/m and friction", STIFF)):
        rig = _rig("unilateral").with_changes(changes)
        compiled, road = compile_rig(rig), _road(Case("unilateral", SPEEDS[0]))
        run = prepare(compiled, compiled.parameter_values(rig.parameters()), road, TIMES)
        runs[way], methods[way] = run.run, run.run().method
    times, problem = in_turns(runs), "double wishbone, default tolerance, 3 s at 1 kHz"
    rigid, stiff = times.values()
    targets = ("", "≤ 20 × rigid")
    return [
        Row(problem, way, times[way], None, ratio, target, methods[way])
        for way, ratio, target in zip(runs, (1.0, stiff / rigid), targets, strict=True)
    ]


def residual_rows() -> list[Row]:
    """Largest gap of the loops, over both tyres and all speeds; runs with all hardpoints, reactions and energies."""
    worst, slowest = 0.0, 0.0
    for tyre in TYRES:
        rig = _rig(tyre)
        compiled = compile_rig(rig, detail=True)
        p, row = (
            compiled.parameter_values(rig.parameters()),
            compiled.output_names.index("constraint.residual"),
        )
        for speed in SPEEDS:
            run = prepare(compiled, p, _road(Case(tyre, speed)), TIMES)
            worst = max(worst, float(np.max(run.run().outputs[row])))
            slowest = max(slowest, median_time(run.run, repeats=11))
    note = f"loops open by {worst:.0e} m at most, {len(compiled.output_names)} channels"
    return [
        Row(
            "double wishbone with `detail`, 3 s at 1 kHz",
            "jounce, slowest of six",
            slowest,
            None,
            None,
            "< 1e-9 m",
            note,
        )
    ]


def _rig(tyre: str) -> jn.Rig:
    return jn.load(str(RIG)).with_changes({"tyre.lift_off": tyre == "unilateral"})


def _reduction(rig: jn.Rig) -> Reduction:
    found = reduction_of(rig)
    assert found is not None
    return found


def _road(case: Case) -> Segments:
    height, wave, start = case.bump
    edges = np.array([0.0, start, start + np.pi / wave, DURATION])
    return Segments(
        edges, np.array([0, 1, 0]), np.array([[0.0] * 4, [0.0, height, wave, 0.0], [0.0] * 4])
    )


def _apart(found: np.ndarray, exact: np.ndarray) -> float:
    return float(np.max(np.abs(found / exact - 1.0)))


if __name__ == "__main__":
    print(markdown([*gradient_rows(), *stiff_rows(), *residual_rows()]))
