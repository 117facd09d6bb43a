"""Run all benchmarks and write the table into the documentation: ``make bench``.

Ratios count, not times: every peer solves the same problem to the same displacement error in the same run.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from damper_rows import damper_rows
from exchange_rows import exchange_rows
from inspection_rows import inspection_rows
from kc_rows import kc_rows
from kinematic_design import kinematic_design_rows
from laboratory_rows import laboratory_rows
from mechanism_rows import mechanism_rows
from peers import casadi_runs, cheapest, diffrax_runs, linear_runs, numba_runs, scipy_runs
from problems import CHANNELS, DURATION, TIMES, Obstacle, QuarterCar, displacement_error, long_road
from recording_rows import recording_rows
from report_rows import report_rows
from ride_rows import ride_rows
from scale_rows import scale_rows
from start_rows import start_rows
from timing import Row, markdown, median_time, shown
from variant_rows import variant_rows
from vehicle_rows import vehicle_rows

import jounce as jn
from jounce.core.segments import Segments, piecewise_linear
from jounce.identify.fit_problem import FitTrial
from jounce.models import build
from jounce.simulation.compiled import compile_model
from jounce.simulation.prepare import prepare

ERROR = 1e-6
PAGE = Path(__file__).parent.parent / "docs" / "explanation" / "benchmarks.md"


def obstacle_rows() -> list[Row]:
    """Nonlinear quarter car over the obstacle, 3 s at 1 kHz."""
    car, bump, rig = QuarterCar(), Obstacle(), jn.load("kart-quarter-car")
    compiled = compile_model(build(rig))
    p, road = compiled.parameter_values(rig.parameters()), _segments(bump)
    exact = prepare(compiled, p, road, TIMES, tolerance=1e-12, method="explicit")
    exact.run()
    reference = exact.out.states.copy()
    for tolerance in (1e-5, 3e-6, 1e-6, 3e-7):
        case = prepare(compiled, p, road, TIMES, tolerance=tolerance)
        case.run()
        error = displacement_error(case.out.states, reference)
        if error <= ERROR:
            break
    problem, own = (
        "quarter car with lift-off, obstacle, 3 s at 1 kHz",
        median_time(case.run, repeats=101),
    )
    rows = [
        Row(
            problem,
            "jounce, compiled run",
            own,
            error,
            1.0,
            "≤ 0.08 ms",
            f"states and {len(CHANNELS)} channels",
        )
    ]
    trial = jn.Trial(
        road=jn.HalfSine(height=bump.height, length=bump.length, start=bump.start),
        speed=bump.speed,
        duration=DURATION,
    )
    whole = median_time(lambda: jn.simulate(rig, trial, tolerance=tolerance), repeats=51)
    rows.append(
        Row(problem, "jounce, jn.simulate with its Dataset", whole, error, whole / own, "+ 0.7 ms")
    )
    for peers in (numba_runs, diffrax_runs, casadi_runs, scipy_runs):
        for name, _, run, error in cheapest(peers(car, bump), reference, ERROR):
            note = "" if error <= ERROR else "error not reached"
            median = median_time(run)
            rows.append(Row(problem, name, median, error, median / own, note=note))
    return rows


def linear_rows() -> list[Row]:
    """Linear quarter car on a long road, exact propagation."""
    car, rig = QuarterCar(), jn.load("kart-quarter-car").with_changes({"tyre.lift_off": False})
    compiled = compile_model(build(rig))
    time_, height = long_road()
    p = compiled.parameter_values(rig.parameters())
    case = prepare(compiled, p, piecewise_linear(time_, height), time_)
    case.run()
    reference = case.out.states - case.out.states[:, :1]
    problem, own = "linear quarter car, road of 10 s at 1 kHz", median_time(case.run, repeats=101)
    rows = [
        Row(
            problem,
            "jounce, exact propagation",
            own,
            None,
            1.0,
            "≤ 0.1 ms",
            f"states and {len(CHANNELS)} channels",
        )
    ]
    for name, run in linear_runs(car, time_, height):
        error = displacement_error(run(), reference)
        median = median_time(run)
        rows.append(Row(problem, name, median, error, median / own, note="states only"))
    return rows


def update_rows() -> list[Row]:
    """One update with three parameters on one trial, against its own noise-free data."""
    rig = jn.load("kart-quarter-car")
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m"),
        speed="1.95 m/s",
        duration="3 s",
    )
    factors = {"strut.spring.rate": 1.06, "strut.damper.coefficient": 0.93, "tyre.stiffness": 0.95}
    values = rig.parameters()
    truth = rig.with_changes({path: values[path] * factor for path, factor in factors.items()})
    measured = jn.simulate(truth, trial, tolerance=1e-7)[["sprung.az", "unsprung.az"]]
    fit = FitTrial("trial", rig, trial, measured)
    free = dict.fromkeys(factors, "10 %")
    rows = []
    for method in ("least-squares", "bfgs"):
        result = jn.update_model([fit], free, method=method)
        found = result.parameters
        error = max(
            abs(found[path].value / (values[path] * factor) - 1.0)
            for path, factor in factors.items()
        )
        median = median_time(
            lambda method=method: jn.update_model([fit], free, method=method), repeats=9
        )
        note = f"{result.evaluations} evaluations, truth to {error:.0e}"
        rows.append(
            Row(
                "update of three parameters on one trial",
                method,
                median,
                None,
                None,
                "≤ 50 ms, 1e-6",
                note,
            )
        )
    return rows


def _segments(bump: Obstacle) -> Segments:
    edges = np.array([0.0, bump.start, bump.start + bump.length, DURATION * bump.speed])
    coefficients = np.array([[0.0] * 4, [0.0, bump.height, np.pi / bump.length, 0.0], [0.0] * 4])
    return Segments(edges, np.array([0, 1, 0]), coefficients).in_time(bump.speed)


PARTS = (
    obstacle_rows,
    linear_rows,
    mechanism_rows,
    kc_rows,
    kinematic_design_rows,
    vehicle_rows,
    ride_rows,
    exchange_rows,
    inspection_rows,
    variant_rows,
    scale_rows,
    update_rows,
    laboratory_rows,
    recording_rows,
    damper_rows,
    start_rows,
    report_rows,
)


def main() -> None:
    """Run everything, print the table and write the page."""
    rows: list[Row] = []
    for part in PARTS:
        new = part()
        rows += new
        for row in new:
            sys.stderr.write(f"{row.problem}: {row.way}: {shown(row.median)}\n")
    table = markdown(rows)
    sys.stdout.write(table + "\n")
    text = PAGE.read_text(encoding="utf-8")
    head, _, rest = text.partition("<!-- table -->")
    _, _, tail = rest.partition("<!-- end of table -->")
    PAGE.write_text(
        f"{head}<!-- table -->\n\n{table}\n\n<!-- end of table -->{tail}", encoding="utf-8"
    )


if __name__ == "__main__":
    main()
