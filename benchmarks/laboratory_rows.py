"""Raw records of a laboratory, a belt that has been running, and integration of accelerations without drift."""

from __future__ import annotations

import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from timing import Row

import jounce as jn
from jounce.campaign import FolderCampaign, campaign_from_folder
from jounce.recordings import recording

sys.path.insert(0, str(Path(__file__).parent.parent / "tests" / "recovery"))
import raw_laboratory as laboratory  # noqa: E402 - the laboratory of the tests, in NumPy

SEED = 3


def laboratory_rows() -> list[Row]:
    """All rows, in processor time except the integration, which uses all processors."""
    with tempfile.TemporaryDirectory(prefix="jounce-bench-") as name:
        folder = Path(name)
        lab = laboratory.drawn(SEED)
        laboratory.write(lab, folder / "raw")
        laboratory.write_book(lab, folder / "raw")
        count = sum(1 for _ in (folder / "raw").glob("*.csv"))

        def take_in() -> FolderCampaign:
            return campaign_from_folder(folder / "mine", folder / "raw", force=True)

        made = take_in()
        problem = (
            f"folder of raw records: {count} CSV files, 16 trials of 10 s at 2 kHz (processor time)"
        )
        recognised = _processor(take_in)
        updated = _processor(lambda: jn.run_campaign(made.campaign), repeats=3)
        rows = [
            Row(
                problem,
                "jounce, recognised and converted to a campaign",
                recognised,
                None,
                1.0,
                "≤ 3 s",
            ),
            Row(
                problem,
                "jounce, up to the updated and validated model",
                recognised + updated,
                None,
                None,
                "≤ 60 s",
            ),
        ]
    return rows + _belt_rows() + _integration_rows()


def _belt_rows() -> list[Row]:
    rig = jn.load("kart-quarter-car")
    road = jn.HalfSine(height="10 mm", length="60 mm", start="0.1 m", recurrence="1.97 m")
    trial = jn.Trial(road=road, speed=3.87, duration=1.97 / 3.87)
    plain = _processor(lambda: jn.simulate(rig, trial), repeats=100)
    periodic = _processor(lambda: jn.simulate(rig, trial, start="periodic"), repeats=100)
    problem = "quarter car over one loop of a belt at 3.87 m/s (processor time)"
    return [
        Row(problem, "jounce, from rest", plain, None, 1.0),
        Row(problem, 'jounce, start = "periodic"', periodic, None, periodic / plain, "≤ 5 times"),
    ]


def _integration_rows() -> list[Row]:
    clock = np.arange(600_000) / 1000.0
    draw = np.random.default_rng(1)
    names = [f"sprung_{side}.a{axis}" for side in ("left", "right") for axis in "xyz"] + [
        "sprung.az",
        "unsprung.az",
    ]
    channels = {
        name: (np.sin(31.0 * clock) + 0.1 * draw.standard_normal(clock.size), "m/s^2", "")
        for name in names
    }
    data = recording(clock, channels)
    seconds = _median(lambda: jn.integrate_acceleration(data), time.perf_counter, 3)
    problem = "integration of 8 accelerations over 10 minutes at 1 kHz"
    return [
        Row(problem, "jounce, velocity and displacement without drift", seconds, None, 1.0, "≤ 1 s")
    ]


def _processor(work: Callable[[], object], repeats: int = 5) -> float:
    work()
    return _median(work, time.process_time, repeats)


def _median(work: Callable[[], object], clock: Callable[[], float], repeats: int) -> float:
    """Median of the times in s."""
    times = []
    for _ in range(repeats):
        start = clock()
        work()
        times.append(clock() - start)
    return statistics.median(times)
