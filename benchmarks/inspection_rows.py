"""Shock-absorber tests: evaluating, simulating and importing records, re-evaluating a store, comparing methods."""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from inspection_peers import egea_script, run_down, table_of_numbers
from timing import Row, median_time

import jounce as jn
from jounce.inspection.archive.lane import import_record
from jounce.inspection.archive.reevaluation import reevaluate
from jounce.inspection.archive.store import Store
from jounce.inspection.equivalence import compare_tests
from jounce.inspection.evaluation import evaluate
from jounce.inspection.limits import load_limits
from jounce.inspection.record import read_record
from jounce.parts.testers import load_tester
from jounce.testers.testing import simulate_test

_NOISE, _SEEDS = 0.01, 20
_STORED, _DIFFERENT, _LANE = 480, 8, 10_000
_CORES = f"jounce, two processes on {os.cpu_count()} cores"
_ALL_CHANNELS = {
    "left.plate.z": "mm",
    "left.plate.force": "N",
    "right.plate.z": "mm",
    "right.plate.force": "N",
}


def inspection_rows() -> list[Row]:
    """All rows."""
    return [
        *_rigid_rows(),
        *_sprung_rows(),
        *_simulation_rows(),
        *_lane_rows(),
        *_equivalence_rows(),
    ]


def _rigid_rows() -> list[Row]:
    """One wheel of 15 s at 1 kHz on a rigid plate; the peer filters cycle by cycle without a fit."""
    rig, tester = (
        jn.load("audi-a6-quarter-car"),
        load_tester("eusama").with_changes({"programme.hold_time": "5 s"}),
    )

    def record(noise: float, seed: int = 0) -> Any:
        return simulate_test(rig, tester, wheel="left", noise=noise, seed=seed, truth=False)

    def adhesion_and_phase(run: Any) -> tuple[float, float]:
        wheel = evaluate(run, tester, methods=["eusama", "egea"]).wheels[0]
        return wheel.adhesion or 0.0, wheel.phase_angle_min_deg or 0.0

    one = record(_NOISE)
    problem = f"one wheel on a rigid plate, {float(one['time'][-1]):.3g} s at 1 kHz, noise of 1 %"
    own = median_time(lambda: adhesion_and_phase(one), repeats=101)
    whole = median_time(lambda: evaluate(one, tester), repeats=101)
    peer = median_time(lambda: egea_script(one), repeats=9)
    noisy = [record(_NOISE, seed) for seed in range(_SEEDS)]
    notes = [
        _said(way(record(0.0)), np.array([way(run) for run in noisy]))
        for way in (adhesion_and_phase, egea_script)
    ]
    return [
        Row(
            problem,
            "jounce, adhesion and phase",
            own,
            None,
            1.0,
            "≤ 5 ms",
            f"with intervals; {notes[0]}",
        ),
        Row(
            problem,
            "jounce, all methods",
            whole,
            None,
            whole / own,
            "≤ 25 ms",
            "with rigidity and THETA",
        ),
        Row(problem, "SciPy, low pass and loop over cycles", peer, None, peer / own, note=notes[1]),
    ]


def _said(clean: tuple[float, float], noisy: np.ndarray) -> str:
    """Effect of noise on adhesion and phase angle."""
    adhesion, angle = np.sqrt(np.mean((noisy - np.array(clean)) ** 2, axis=0))
    return f"noise moves them by {100.0 * adhesion:.2g} points and {angle:.2g}°"


def _sprung_rows() -> list[Row]:
    """One wheel of 15 s at 1 kHz on a sprung plate."""
    rig, tester = jn.load("audi-a6-quarter-car"), load_tester("theta-msd3000")
    one = simulate_test(rig, tester, wheel="left", noise=_NOISE, truth=False)
    problem = f"one wheel on a sprung plate, {float(one['time'][-1]):.3g} s at 1 kHz, noise of 1 %"
    own = median_time(lambda: evaluate(one, tester), repeats=101)
    note = "THETA by four methods, BOGE amplitude"
    return [Row(problem, "jounce, all methods", own, target="≤ 25 ms", note=note)]


def _simulation_rows() -> list[Row]:
    """One test, simulated; the peer solves the rigid one as well as jounce does."""
    quarter, tester = jn.load("audi-a6-quarter-car"), load_tester("eusama")
    problem = "simulated test of one wheel, run-down from 25 Hz, 11.5 s at 1 kHz"
    own = median_time(
        partial(simulate_test, quarter, tester, wheel="left", truth=False), repeats=31
    )
    found = simulate_test(quarter, tester, wheel="left")
    force, load = found["truth.left.tyre.force"].to_numpy(), float(found.attrs["left.static_load"])
    exact = run_down(quarter, tester, found["time"].to_numpy(), 1e-11)

    def error(values: np.ndarray) -> float:
        return float(np.max(np.abs(values - exact))) / load

    rows = [
        Row(
            problem,
            "jounce, rigid plate",
            own,
            error(force),
            1.0,
            note="error of the force over the static load",
        )
    ]
    for tolerance in (1e-6, 1e-8, 1e-10):
        peer = partial(run_down, quarter, tester, found["time"].to_numpy(), tolerance)
        if error(peer()) <= max(error(force), 1e-6):
            break
    median = median_time(peer, repeats=3, budget=0.0)
    rows.append(
        Row(problem, "SciPy solve_ivp DOP853, rigid plate", median, error(peer()), median / own)
    )
    for way, rig, plate in (
        ("sprung plate", quarter, "theta-msd3000"),
        ("double wishbone in 3-D, rigid plate", jn.load("audi-double-wishbone"), "eusama"),
    ):
        run = partial(simulate_test, rig, load_tester(plate), wheel="left", truth=False)
        median = median_time(run, repeats=15)
        rows.append(Row(problem, f"jounce, {way}", median, None, median / own))
    return rows


def _lane_rows() -> list[Row]:
    """Reading and importing records of an axle as text, and evaluating a store of them again."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        files = list(_files(folder))
        tester = load_tester("eusama")
        problem = "record of an axle as CSV, 30 s at 1 kHz, five columns"
        own = median_time(lambda: read_record(files[0], tester), repeats=15)
        plain = median_time(lambda: table_of_numbers(files[0]), repeats=15)
        store = Store(folder / "lane.sqlite")
        imports = []
        for file in files:
            start = time.perf_counter()
            import_record(file, store)
            imports.append(time.perf_counter() - start)
        stored = float(np.median(imports))
        again = _reevaluated(store)
        store.close()
    return [
        Row(problem, "jounce, with header and checks", own, None, 1.0, "≤ 100 ms"),
        Row(problem, "pandas.read_csv, numbers only", plain, None, plain / own),
        Row(
            problem,
            "jounce, imported",
            stored,
            None,
            stored / own,
            note="read, evaluated, graded, stored",
        ),
        again,
    ]


def _files(folder: Path) -> Iterator[Path]:
    """Records of both wheels of an axle, 15 s each, one after the other."""
    tester, car = (
        load_tester("eusama").with_changes({"programme.hold_time": "4.5 s"}),
        jn.load("audi-a6-full-car"),
    )
    for seed in range(_DIFFERENT):
        run = simulate_test(car, tester, noise=_NOISE, seed=seed, truth=False)
        columns = [run["time"].to_numpy()]
        for channel, unit in _ALL_CHANNELS.items():
            columns.append(run[channel].to_numpy() * (1e3 if unit == "mm" else 1.0))
        facts = ["tester", "axle", "wheel_order", "left.static_load", "right.static_load"]
        lines = [
            f'# {fact} = "{run.attrs[fact]}{" N" if "load" in fact else ""}"' for fact in facts
        ]
        lines.append(
            ", ".join(
                ["time [s]", *(f"{channel} [{unit}]" for channel, unit in _ALL_CHANNELS.items())]
            )
        )
        file = folder / f"{seed}.csv"
        formats = ["%.3f", "%.4f", "%.1f", "%.4f", "%.1f"]
        np.savetxt(
            file, np.column_stack(columns), formats, ", ", header="\n".join(lines), comments=""
        )
        yield file


def _reevaluated(store: Store) -> Row:
    """Re-evaluate some hundred stored records and extrapolate to the whole lane."""
    first = store.numbers()
    for copy in range(
        _STORED - len(first)
    ):  # the stored signals are what is evaluated; the copies' texts are short
        number = first[copy % len(first)]
        entry = replace(
            store.entry(number), content=b"copy %d" % copy, signals=store.signals(number)
        )
        store.accept(entry, store.newest_grading(number))
    seen: list[tuple[int, float]] = []
    begin = time.perf_counter()

    def say(done: int, _: int) -> None:
        seen.append((done, time.perf_counter() - begin))

    found = reevaluate(
        store, load_limits().model_copy(update={"version": "another"}), workers=2, say=say
    )
    if found.added != _STORED:
        raise RuntimeError(f"{_STORED - found.added} records were not graded again: {found.failed}")
    (few, start), (many, end) = seen[0], seen[-1]
    each = (end - start) / (many - few)
    note = f"extrapolated from {many} records: {start:.2g} s for start and first {few}, "
    note += f"then {1e3 * each:.2g} ms per record"
    problem = f"{_LANE:,} stored axle records re-evaluated and regraded".replace(",", " ")
    return Row(
        problem, _CORES, start + each * (_LANE - few), target="≤ 6 min on two cores", note=note
    )


def _equivalence_rows() -> list[Row]:
    """The whole study, once."""
    start = time.perf_counter()
    found = compare_tests(jn.load("audi-a6-quarter-car"), workers=2)
    taken = time.perf_counter() - start
    problem = f"equivalence of EUSAMA, EGEA and THETA, {found.tests} tests simulated and evaluated"
    return [Row(problem, _CORES, taken, target="≤ 30 s")]
