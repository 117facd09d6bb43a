"""Rows of the benchmark table for mechanisms: the prototype's double wishbone, sweeps, slopes, building and compiling.

``python benchmarks/mechanism_rows.py [--quick]`` prints them alone.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
from gradient_rows import gradient_rows, residual_rows, stiff_rows
from mechanism_peers import PEERS, TARGETS, cheapest
from mechanism_problem import DURATION, SPEEDS, TIMES, TYRES, Case
from peer_kinematics import TRAVELS, sweeps
from timing import Row, markdown, median_time

import jounce as jn
from jounce.core.segments import Segments
from jounce.kinematics.sweeps import prepare_sweep
from jounce.simulation.compiled import compile_rig
from jounce.simulation.prepare import PreparedRun, prepare
from jounce.simulation.reduced import ReducedCorner, reduction_of

RIG = Path(__file__).parent.parent / "tests" / "files" / "prototype-double-wishbone.toml"
ASKED = {
    ("bilateral", 2e-5): "≤ 4 ms",
    ("bilateral", 1e-6): "≤ 7 ms, slowest ≤ 12 ms",
    ("unilateral", 1e-4): "≤ 8 ms",
    ("unilateral", 1e-6): "≤ 16 ms",
}
REDUCED = {
    ("bilateral", 2e-5): "",
    ("bilateral", 1e-6): "≤ 0.55 ms",
    ("unilateral", 1e-4): "≤ 0.5 ms",
    ("unilateral", 1e-6): "≤ 1.1 ms",
}
TOLERANCES = (3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 1e-6)


def double_wishbone_rows(*, quick: bool = False) -> list[Row]:
    """Both tyres at both errors; each way at the loosest setting that reaches the error at that speed."""
    rows, speeds = [], SPEEDS[:1] if quick else SPEEDS
    for tyre in TYRES:
        for asked in TARGETS[tyre]:
            problem = f"double wishbone, {tyre} tyre, obstacle, 3 s at 1 kHz, error {asked:.0e}"
            own = [_own(Case(tyre, speed), asked) for speed in speeds]
            rows.append(_row(problem, "jounce, compiled run", own, own, ASKED[tyre, asked]))
            one = [_own(Case(tyre, speed), asked, _reduced) for speed in speeds]
            rows.append(_row(problem, "jounce, as one coordinate", one, own, REDUCED[tyre, asked]))
            for name, peer in PEERS.items():
                if peer.is_installed:
                    found = [
                        cheapest(name, Case(tyre, v), asked, budget=0.6 if quick else 3.0)
                        for v in speeds
                    ]
                    reached = "" if all(f.is_reached for f in found) else "error not reached"
                    rows.append(
                        _row(
                            problem, name, [(f.seconds, f.error) for f in found], own, note=reached
                        )
                    )
    return rows


def _row(
    problem: str, way: str, found: list[tuple[float, float]], own, target: str = "", note: str = ""
) -> Row:
    """Median at the first speed; the others in the note."""
    times = " / ".join(f"{seconds * 1e3:.3g}" for seconds, _ in found)
    speeds = " / ".join(str(speed) for speed in SPEEDS[: len(found)])
    text = f"{times} ms at {speeds} m/s" if len(found) > 1 else ""
    error = max(error for _, error in found)
    ratio = found[0][0] / own[0][0]
    return Row(
        problem,
        way,
        found[0][0],
        error,
        ratio,
        target,
        ", ".join(part for part in (note, text) if part),
    )


def _full(rig: jn.Rig, road: Segments, tolerance: float) -> PreparedRun:
    compiled = compile_rig(rig)
    return prepare(
        compiled, compiled.parameter_values(rig.parameters()), road, TIMES, tolerance=tolerance
    )


def _reduced(rig: jn.Rig, road: Segments, tolerance: float) -> PreparedRun:
    laid_out = ReducedCorner(
        reduction_of(rig), rig.parameters(), [road], TIMES, tolerance
    ).lay_out()
    assert laid_out.holds(laid_out.prepared.run().states)
    return laid_out.prepared


def _own(case: Case, asked: float, lay_out=_full) -> tuple[float, float]:
    """Median time (s) and error of our own run."""
    rig = jn.load(str(RIG)).with_changes({"tyre.lift_off": case.unilateral})
    hub = case.points["W"][2]
    names = [output.name for output in compile_rig(rig).facts.outputs]
    height, wave, start = case.bump
    edges = np.array([0.0, start, start + np.pi / wave, DURATION])
    road = Segments(
        edges, np.array([0, 1, 0]), np.array([[0.0] * 4, [0.0, height, wave, 0.0], [0.0] * 4])
    )
    assert abs(hub - 0.1385) < 1e-12
    for tolerance in TOLERANCES:
        run = lay_out(rig, road, tolerance)
        outputs = run.run().outputs
        error = case.error(outputs[names.index("sprung.z")], outputs[names.index("unsprung.z")])
        if error <= asked:
            break
    return median_time(run.run, repeats=101), error


def sweep_rows() -> list[Row]:
    """Travel sweeps of the reference double wishbone."""
    rig, problem = (
        jn.load("reference-double-wishbone"),
        "travel sweep of a double wishbone, 41 poses",
    )
    sweep = prepare_sweep(rig, TRAVELS)
    count = len(sweep.run())
    own = median_time(sweep.run, repeats=101)
    rows = [Row(problem, "jounce, arrays only", own, None, 1.0, "≤ 2 ms", f"{count} quantities")]
    whole = median_time(lambda: jn.sweep_travel(rig, TRAVELS), repeats=51)
    rows.append(Row(problem, "jounce, jn.sweep_travel with its Dataset", whole, None, whole / own))
    for name, run in sweeps().items():
        median = median_time(run, repeats=21)
        rows.append(Row(problem, name, median, None, median / own))
    heights = {"hardpoints.tie_rod_inner[2]": np.linspace(0.175, 0.195, 10_000)}
    median = median_time(lambda: jn.sweep_variants(rig, heights, TRAVELS), repeats=3, budget=1.0)
    variants = "10 000 hardpoint variants, 41 poses each"
    rows.append(Row(variants, "jounce, whole catalogue", median, None, None, "≤ 10 s"))
    return rows


def start_rows() -> list[Row]:
    """Building and compiling the 3-D model in fresh processes."""
    script = (
        "import sys, time, jounce as jn\nfrom jounce.simulation.compiled import compile_rig\n"
        "import casadi, llvmlite.binding\nrig = jn.load(sys.argv[1]); start = time.perf_counter()\n"
        "compile_rig(rig); print(time.perf_counter() - start)"
    )

    def once(folder: str) -> float:
        command = [sys.executable, "-c", script, str(RIG)]
        environment = {**os.environ, "JOUNCE_CACHE_DIR": folder}
        done = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
        return float(done.stdout)

    problem = "build and compile the double wishbone"
    with tempfile.TemporaryDirectory() as folder:
        first = once(folder)
        cached = float(np.median([once(folder) for _ in range(5)]))
    return [
        Row(problem, "first time", first, target="≤ 1 s"),
        Row(problem, "from the cache", cached, target="≤ 50 ms"),
    ]


def mechanism_rows(*, quick: bool = False) -> list[Row]:
    """All of them."""
    parts: list[Callable[[], list[Row]]] = [lambda: double_wishbone_rows(quick=quick), sweep_rows]
    parts += [gradient_rows, stiff_rows, residual_rows, start_rows]
    return [row for part in parts for row in part()]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="one speed, short runs of the peers")
    print(markdown(mechanism_rows(quick=parser.parse_args().quick)))
