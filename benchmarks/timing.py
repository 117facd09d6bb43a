"""Measure times and write their table."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Row:
    """One measured method; times in s, ``ratio`` to jounce in the same run."""

    problem: str
    way: str
    median: float
    error: float | None = None
    ratio: float | None = None
    target: str = ""
    note: str = ""


def median_time(run: Callable[[], object], *, repeats: int = 15, budget: float = 6.0) -> float:
    """Median wall time of a call in s, after one warm-up; fewer repeats if the budget (s) is used up."""
    run()
    times, begin = [], time.perf_counter()
    while len(times) < repeats and (time.perf_counter() - begin < budget or len(times) < 3):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return float(np.median(times))


def side_by_side(
    ways: Sequence[Callable[[], float]], *, rounds: int = 20
) -> list[tuple[float, float]]:
    """Median of the time (s) that each method returns, and of its ratio to the first method in the same round.

    The methods run alternately, so other load and clock changes of the machine affect all of them.
    """
    for way in ways:
        way()
    told = np.array([[way() for way in ways] for _ in range(rounds)])
    return [(float(np.median(own)), float(np.median(own / told[:, 0]))) for own in told.T]


def processor_time(run: Callable[[], object]) -> float:
    """Processor time of a call in this process, s."""
    start = time.process_time()
    run()
    return time.process_time() - start


def shown(seconds: float) -> str:
    """Format a time with three digits and a suitable unit."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6), ("ns", 1e-9)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds:.2g} s"


def markdown(rows: list[Row]) -> str:
    """The rows as a table for the documentation."""
    lines = [
        "| problem | method | median | × jounce | displacement error | target |",
        "|---|---|---:|---:|---:|---|",
    ]
    for row in rows:
        ratio = "" if row.ratio is None else f"{row.ratio:.3g}"
        error = "" if row.error is None else f"{row.error:.1e}"
        way = f"{row.way} ({row.note})" if row.note else row.way
        lines.append(
            f"| {row.problem} | {way} | {shown(row.median)} | {ratio} | {error} | {row.target} |"
        )
    return "\n".join(lines)
