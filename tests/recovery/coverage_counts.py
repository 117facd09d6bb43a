"""Count how often intervals of posteriors hold the truth of virtual benches, with and without errors of the model.

``OPENBLAS_NUM_THREADS=1 JOUNCE_BENCHES=200 python tests/recovery/coverage_counts.py counts.csv`` adds a row for each
bench to a file and goes on behind the last, so that what was counted is kept when it is stopped; the tests count the
same way. More threads only wait for each other: on a busy machine they take several times as long.
"""

from __future__ import annotations

import csv
import os
import sys
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import wrong_models

import jounce as jn

ROAD = jn.HalfSine(height="10 mm", length="60 mm", start="0.1 m")
FREE = {"strut.spring.rate": "20 %", "strut.damper.coefficient": "40 %", "tyre.stiffness": "20 %"}
NOISE = {"sprung.az": jn.Sensor(noise="0.3 m/s^2"), "unsprung.az": jn.Sensor(noise="1 m/s^2")}
FIRST = 400
"""Seeds of wrong laws from here on are others than those that the intervals were developed on."""


Truth = Mapping[str, tuple[float, ...]]
Intervals = Mapping[str, tuple[float, float]]


@dataclass(frozen=True)
class Count:
    """What came of one bench.

    ``intervals`` that were asked, and how many of them ``hold`` the truth; half-``widths`` over their values, and
    ``ratio`` of their widths to those of the Gaussian approximation (both 1, medians); ``error`` of the log density
    (1), and whether it was ``told``; processor ``time`` in s.
    """

    benches: str
    seed: int
    intervals: int
    hold: int
    widths: float
    ratio: float
    error: float
    told: bool
    time: float


def without_error(seed: int) -> Count:
    """Count a bench that is as its model says: the 95 % interval of each parameter."""
    begun = time.process_time()
    rig = jn.load("kart-quarter-car")
    draw = np.random.default_rng([13, seed])
    changes = {path: rig.parameters()[path] * draw.uniform(0.9, 1.1) for path in FREE}
    trial = jn.Trial(road=ROAD, speed=draw.uniform(1.5, 4.0), duration="0.8 s")
    run = jn.simulate(rig.with_changes(changes), trial, tolerance=1e-7)[list(NOISE)]
    fit = jn.FitTrial("one", rig, trial, jn.apply_sensors(run, NOISE, seed=seed))
    found = jn.posterior([fit], FREE, draws=4000, predict=())
    truth = {path: (value,) for path, value in changes.items()}
    gaussian = {
        path: one.gaussian for path, one in found.parameters.items() if one.gaussian is not None
    }
    return _count("as modelled", seed, found, truth, gaussian, begun)


def with_error(seed: int) -> Count:
    """Count a bench of three trials whose laws are not the model's: both readings of each identified part."""
    begun = time.process_time()
    one = wrong_models.bench(seed, trials=3)
    found = jn.posterior(
        one.trials, wrong_models.FREE, align="lag", doubt=jn.Doubt(), draws=4000, predict=()
    )
    assert found.counted == "model error"
    assert found.update is not None
    assert found.update.discrepancy is not None
    told = found.update.discrepancy.parameters
    gaussian = {path: law.interval for path, law in told.items() if law.identified}
    truth = {path: (one.component[path], one.effective[path]) for path in gaussian}
    return _count("wrong laws", seed, found, truth, gaussian, begun)


def _count(
    benches: str, seed: int, found: jn.Posterior, truth: Truth, gaussian: Intervals, begun: float
) -> Count:
    asked = {path: found.parameters[path] for path in gaussian}
    held = [
        all(p.interval[0] <= value <= p.interval[1] for value in truth[path])
        for path, p in asked.items()
    ]
    widths = [0.5 * np.ptp(p.interval) / p.value for p in asked.values()]
    ratios = [np.ptp(p.interval) / np.ptp(gaussian[path]) for path, p in asked.items()]
    middle = [float(np.median(each)) if each else float("nan") for each in (widths, ratios)]
    told = any("log density" in str(finding) for finding in found.findings)
    took = time.process_time() - begun
    return Count(
        benches, seed, len(held), sum(held), middle[0], middle[1], found.density_error, told, took
    )


def interval_of_share(hold: int, of: int) -> tuple[float, float]:
    """95 % interval of a share (1) that was counted, after Clopper and Pearson, if the counts were independent."""
    from scipy.stats import binomtest

    found = binomtest(hold, of).proportion_ci(0.95)
    return float(found.low), float(found.high)


def counted(path: Path) -> list[Count]:
    """Rows of a file."""
    if not path.exists():
        return []
    with path.open(newline="") as file:
        return [_row(texts) for texts in csv.DictReader(file)]


def _row(texts: Mapping[str, str]) -> Count:
    seed, intervals, hold = (int(texts[name]) for name in ("seed", "intervals", "hold"))
    widths, ratio, error, took = (
        float(texts[name]) for name in ("widths", "ratio", "error", "time")
    )
    return Count(
        texts["benches"], seed, intervals, hold, widths, ratio, error, texts["told"] == "True", took
    )


def _asked(benches: int) -> Iterator[tuple[str, int]]:
    """Those that take long last."""
    for i in range(benches):
        yield "as modelled", i
    for i in range(benches):
        yield "wrong laws", FIRST + i


def main(path: Path, benches: int) -> None:
    """Count what the file does not have yet, and tell."""
    done = {(row.benches, row.seed) for row in counted(path)}
    names = list(Count.__dataclass_fields__)
    with path.open("a", newline="") as file:
        writer = csv.DictWriter(file, names)
        if not done:
            writer.writeheader()
        for kind, seed in _asked(benches):
            if (kind, seed) not in done:
                row = with_error(seed) if kind == "wrong laws" else without_error(seed)
                writer.writerow({name: getattr(row, name) for name in names})
                file.flush()
    sys.stdout.write(told(counted(path)))


def told(rows: list[Count]) -> str:
    """The shares that hold, a line for each kind of benches."""
    lines = []
    for kind in dict.fromkeys(row.benches for row in rows):
        mine = [row for row in rows if row.benches == kind]
        hold, of = (sum(getattr(row, name) for row in mine) for name in ("hold", "intervals"))
        low, high = (100.0 * end for end in interval_of_share(hold, of))
        errors, ratio = (
            np.array([row.error for row in mine]),
            np.nanmedian([row.ratio for row in mine]),
        )
        share, took = 100.0 * hold / of, np.mean([row.time for row in mine])
        lines.append(
            f"{kind}: {len(mine)} benches, {hold} of {of} intervals hold ({share:.1f} %, {low:.1f} to {high:.1f}), "
            f"{ratio:.2f} of the Gaussian widths, log density off by {np.median(errors):.2f} "
            f"({errors.min():.2f} to {errors.max():.2f}), {took:.1f} s each\n"
        )
    return "".join(lines)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(os.environ.get("JOUNCE_BENCHES", "200")))
