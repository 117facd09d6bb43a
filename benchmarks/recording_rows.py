"""Reading times of recordings: RPC III, integers and single precision, beside the same channels in other formats.

Times are processor seconds of this process, which hardly depend on other load of the machine; formats that a child
process reads take more than that.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
from timing import Row, processor_time

import jounce as jn
from jounce.recordings.reader import ReaderOptions
from jounce.recordings.readers import read_signals

SAMPLES, CHANNELS = 1_000_000, 16
TARGET = "≥ 200 MB/s"
REPEATS = 5


def recording_rows() -> list[Row]:
    """16 channels of a million samples: the reader alone, and `read_recording` with all its checks."""
    random = np.random.default_rng(1)
    run = jn.recording(
        np.arange(SAMPLES) / 1000.0,
        {
            f"p{k}.strut.force": (10.0 * random.normal(size=SAMPLES).cumsum(), "N", "")
            for k in range(CHANNELS)
        },
    )
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for integers, kind in ((True, "16-bit integers"), (False, "single precision")):
            file = Path(folder) / f"{integers}.rsp"
            jn.write_rpc(run, file, integers=integers)
            rows += _rows(file, f"RPC III, {kind}", TARGET)
    return rows


def _rows(file: Path, kind: str, target: str) -> list[Row]:
    size = file.stat().st_size / 1e6
    problem = f"{kind}, {CHANNELS} channels, {size:.0f} MB"
    rows = []
    for way, read, goal in (
        ("channels in their units", lambda: read_signals(file, ReaderOptions()), target),
        ("jn.read_recording: SI, with all checks", lambda: jn.read_recording(file), ""),
    ):
        read()
        median = float(np.median([processor_time(read) for _ in range(REPEATS)]))
        note = f"{size / median:.0f} MB/s, {median / SAMPLES / CHANNELS * 1e9:.0f} ns a number"
        rows.append(Row(problem, way, median, target=goal, note=note))
    return rows


if __name__ == "__main__":
    from timing import markdown

    sys.stdout.write(markdown(recording_rows()) + "\n")
