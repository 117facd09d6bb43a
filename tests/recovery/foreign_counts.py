"""Count what updates of foreign benches say and what is true of them, and lay two counts side by side.

``OPENBLAS_NUM_THREADS=1 python tests/recovery/foreign_counts.py --benches 0:200 --out after.jsonl`` adds a line to a
file for each bench that it does not have, and prints the table; ``--starts 4`` gives the updates that many starts
instead of jounce's own number. ``--show before.jsonl after.jsonl`` prints tables of the benches that all of the files
have, ``--wrong`` lists the benches with wrong values. Seeds from 1000 on are harsh benches. An update is called as the
campaign to start from calls it: normalised weights, a lag for each trial, nothing known of the sensors, default doubts.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import foreign_benches
import numpy as np

import jounce as jn
from jounce.recordings import recording

FREE = {
    "strut.spring.rate": "20 %",
    "strut.damper.bump_coefficient": "60 %",
    "strut.damper.rebound_coefficient": "60 %",
    "guide.friction.force": ["0 N", "40 N"],
    "tyre.stiffness": "25 %",
}
ONSET = foreign_benches.NOMINAL_ONSET


def fit_trials(
    bench: foreign_benches.Bench, motions: Sequence[Any], start: dict[str, float]
) -> list[jn.FitTrial]:
    """Give the trials as the bench's user describes them."""
    damper = {
        side: start[f"strut.damper.{side}"] for side in ("bump_coefficient", "rebound_coefficient")
    }
    rig = jn.load("kart-quarter-car").with_changes({
        **bench.stated,
        "strut.spring.rate": start["strut.spring.rate"],
        "strut.damper": damper,
        "guide.friction": {"force": start["guide.friction.force"], "regularisation_velocity": ONSET},
        "tyre.stiffness": start["tyre.stiffness"],
    })  # fmt: skip
    measured = foreign_benches.records(bench, motions)
    units = {"sprung.az": "m/s^2", "unsprung.az": "m/s^2"}
    found = []
    for number, (road, speed, channels) in enumerate(
        zip(bench.roads, bench.speeds, measured, strict=True), 1
    ):
        time_ = np.arange(len(next(iter(channels.values())))) / foreign_benches.RATE
        table = recording(
            time_, {name: (values, units.get(name, "m"), "") for name, values in channels.items()}
        )
        trial = jn.Trial(road=road_of(road), speed=speed, duration=foreign_benches.DURATION)
        found.append(jn.FitTrial(f"trial {number}", rig, trial, table))
    return found


def road_of(road: foreign_benches.Road) -> jn.Road:
    """Give the same road in jounce's words."""
    same = {"height": road.height, "length": road.length, "start": road.start}
    single = {
        "half-sine": lambda: jn.HalfSine(**same),
        "versine": lambda: jn.Versine(**same),
        "trapezoid": lambda: jn.Trapezoid(**same, ramp=road.ramp),
    }[road.shape]()
    return single if road.count == 1 else jn.Train(of=single, count=road.count, pitch=road.pitch)


def counted(seed: int, starts: int | None = None) -> dict[str, Any]:
    """Run one bench and its update; all that is asked later, SI."""
    bench = foreign_benches.drawn(seed)
    motions = foreign_benches.run([bench])[0]
    return updated(bench, motions, {} if starts is None else {"starts": starts})


def updated(
    bench: foreign_benches.Bench, motions: Sequence[Any], options: dict[str, Any]
) -> dict[str, Any]:
    """Update the model of one bench, and lay what is told beside what is true."""
    truth = foreign_benches.true_values(bench, motions)
    start = foreign_benches.starts(bench, truth)
    trials = fit_trials(bench, motions, start)
    head = {
        "seed": bench.seed,
        "kind": bench.kind,
        "shape": bench.roads[0].shape,
        "channels": len(bench.channels),
    }
    begun = time.process_time()
    try:
        found = jn.update_model(
            trials, FREE, weights="normalised", align="lag", doubt=jn.Doubt(), **options
        )
    except jn.JounceError as error:
        return {**head, "error": str(error)}
    took = time.process_time() - begun
    counts = found.discrepancy
    if counts is None:
        return {**head, "error": "; ".join(one.message for one in found.findings)}
    parameters = {}
    for path, law in counts.parameters.items():
        parameters[path] = {
            "component": truth[path][0],
            "effective": truth[path][1],
            "start": start[path],
            "plain": found.parameters[path].value,
            "value": law.value,
            "interval": list(law.interval),
            "readings": [
                [one.value, *(one.interval or (one.value,) * 2)]
                for one in (law.component, law.effective)
            ],
            "identified": law.identified,
            "why": law.why,
        }
    return {
        **head,
        "cpu": took,
        "objective": counts.objective,
        "left": found.objective_after,
        "unexplained": max(counts.unexplained.values()),
        "findings": [[one.place, one.severity, one.message] for one in found.findings],
        "nuisances": {
            name: one.deviations
            for name, one in counts.nuisances.items()
            if abs(one.deviations) > 1.5
        },
        "parameters": parameters,
    }


# what the lines say ---------------------------------------------------------------------------------------------------


def is_inside(
    one: dict[str, Any], names: Iterable[str] = ("component", "effective"), widths: float = 1.0
) -> bool:
    """Tell whether an interval, stretched to so many of its widths, holds the truth."""
    low, high = one["interval"]
    middle, half = 0.5 * (low + high), 0.5 * (high - low) * widths
    return all(abs(one[name] - middle) <= half for name in names)


def is_warned(line: dict[str, Any]) -> bool:
    """Tell whether any finding of an update is a warning."""
    return any(severity == "warning" for _, severity, _ in line["findings"])


def table(lines: Sequence[dict[str, Any]]) -> str:
    """Counts by parameter, then what belongs to benches."""
    failed = [line for line in lines if "error" in line]
    lines = [line for line in lines if "error" not in line]
    if not lines:
        return f"0 benches, {len(failed)} refused"
    columns = (
        "parameter",
        "covered",
        "component",
        "effective",
        "identified",
        "of these out",
        "far out",
        "unwarned",
        "width",
    )
    rows = ["".join(f"{name:>34s}" if name == "parameter" else f"{name:>13s}" for name in columns)]
    for path in (*FREE, "all"):
        some = [
            (line, one)
            for line in lines
            for name, one in line["parameters"].items()
            if path in (name, "all")
        ]
        known = [(line, one) for line, one in some if one["identified"]]
        out = [(line, one) for line, one in known if not is_inside(one)]
        far = [one for _, one in out if not is_inside(one, widths=1.5)]
        quiet = [one for line, one in out if not is_warned(line)]
        widths = [0.5 * np.ptp(one["interval"]) / max(abs(one["value"]), 1e-300) for _, one in some]
        rows.append(
            f"{path:>34s}{_share([is_inside(one) for _, one in some]):>13s}"
            f"{_share([is_inside(one, ('component',)) for _, one in some]):>13s}"
            f"{_share([is_inside(one, ('effective',)) for _, one in some]):>13s}"
            f"{_share([one['identified'] for _, one in some]):>13s}{len(out):>6d} of {len(known):3d}"
            f"{len(far):>13d}{len(quiet):>13d}{100.0 * float(np.median(widths)):>11.1f} %"
        )
    wrong = [line for line in lines if wrongs(line)]
    cpu, objective = ([line[name] for line in lines] for name in ("cpu", "objective"))
    low, mid, high = np.quantile(objective, [0.1, 0.5, 0.9])
    rows.append(
        f"{len(lines)} benches, {len(failed)} refused; a wrong value called identified on {len(wrong)}, on "
        f"{sum(not is_warned(line) for line in wrong)} of these without a warning; a warning on "
        f"{sum(map(is_warned, lines))}; {np.mean(cpu):.1f} CPU s an update (at most {max(cpu):.1f}); "
        f"objective {low:.3f}, {mid:.3f}, {high:.3f} (10, 50, 90 %)"
    )
    return "\n".join(rows)


def wrongs(line: dict[str, Any]) -> list[str]:
    """Paths of values that are called identified and lie outside of their intervals."""
    return [
        path
        for path, one in line.get("parameters", {}).items()
        if one["identified"] and not is_inside(one)
    ]


def _share(flags: Sequence[bool]) -> str:
    return f"{100.0 * float(np.mean(flags)):.1f} %" if flags else "-"


def outcomes(line: dict[str, Any]) -> str:
    """One bench in a line: where what is called identified lies, in half-widths from the middle of its interval."""
    if "error" in line:
        return f"{line['seed']:4d} {line['kind']}: {line['error']}"
    apart = []
    for path in wrongs(line):
        one = line["parameters"][path]
        low, high = one["interval"]
        far = max(abs(one[name] - one["value"]) for name in ("component", "effective")) / (
            0.5 * (high - low)
        )
        truth = f"{one['component']:.4g} | {one['effective']:.4g}"
        apart.append(
            f"{path} {low:.4g} to {high:.4g} for {truth} ({far:.2f}; start {one['start']:.4g})"
        )
    warned = "warned" if is_warned(line) else "silent"
    head = f"{line['seed']:4d} {line['kind']}, {line['shape']}, objective {line['objective']:.3f}, {warned}"
    return f"{head}: {'; '.join(apart)}"


# running --------------------------------------------------------------------------------------------------------------


def lines_of(path: Path) -> list[dict[str, Any]]:
    """Read what was counted, by seed."""
    if not path.exists():
        return []
    lines = (json.loads(text) for text in path.read_text().splitlines())
    return sorted(lines, key=lambda line: line["seed"])


def main(arguments: Sequence[str] | None = None) -> None:
    """Count, or show what was counted."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--benches", default="0:200", help="first seed and the one behind the last")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--out", type=Path)
    parser.add_argument("--starts", type=int)
    parser.add_argument("--show", type=Path, nargs="+", help="files to print tables of")
    parser.add_argument(
        "--wrong", action="store_true", help="list the benches with a wrong value called identified"
    )
    asked = parser.parse_args(arguments)
    if asked.show:
        show(
            [lines_of(path) for path in asked.show], [str(path) for path in asked.show], asked.wrong
        )
        return
    if asked.out is None:
        parser.error("give --out FILE, or --show FILE ...")
    first, last = (int(text) for text in asked.benches.split(":"))
    done = {line["seed"] for line in lines_of(asked.out)}
    seeds = [seed for seed in range(first, last) if seed not in done]
    with asked.out.open("a") as file:
        for line in _all(seeds, asked.jobs, asked.starts):
            file.write(f"{json.dumps(line)}\n")
            file.flush()
    show([lines_of(asked.out)], [str(asked.out)], asked.wrong)


_AT_ONCE = 20  # benches that are simulated together: it takes little longer than one


def _all(seeds: Sequence[int], jobs: int, starts: int | None) -> Iterable[dict[str, Any]]:
    if jobs > 1:
        with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
            yield from pool.map(counted, seeds, [starts] * len(seeds))
        return
    options = {} if starts is None else {"starts": starts}
    for first in range(0, len(seeds), _AT_ONCE):
        benches = [foreign_benches.drawn(seed) for seed in seeds[first : first + _AT_ONCE]]
        for bench, motions in zip(benches, foreign_benches.run(benches), strict=True):
            yield updated(bench, motions, options)


def show(counts: Sequence[list[dict[str, Any]]], names: Sequence[str], wrong: bool) -> None:
    """Print a table for each file, of the benches that all have."""
    common = set.intersection(*({line["seed"] for line in lines} for lines in counts))
    write: Callable[[str], object] = sys.stdout.write
    for lines, name in zip(counts, names, strict=True):
        kept = [line for line in lines if line["seed"] in common]
        write(f"{name}\n{table(kept)}\n")
        if wrong:
            write(
                "".join(f"{outcomes(line)}\n" for line in kept if wrongs(line) or "error" in line)
            )


if __name__ == "__main__":
    main()
