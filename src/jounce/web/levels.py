"""Display of long records: a child process reads a file once and stores channels with extremes of 256 samples.

A record is displayed as one column per screen pixel, each with minimum and maximum, computed from single samples at
high zoom. No peak is lost at any zoom.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import DisplayUnit
from jounce.core.errors import RecordingError, unknown
from jounce.core.types import Array

if TYPE_CHECKING:
    from jounce.report.live import Viewer

BLOCK = 256
_PIECE, _UNEVEN = (
    50_000,
    1e-3,
)  # samples; tolerance of evenly spaced instants as a fraction of a step
ABOUT = "about.json"
_MOST_CHANNELS = 200


def write_levels(file: Path, folder: Path) -> dict[str, Any]:
    """Read a record without conversion, store its channels in a folder, and return its summary."""
    from jounce.recordings.reader import ReaderOptions
    from jounce.recordings.readers import reader_of

    read = reader_of(file).read(file, ReaderOptions()).tables
    tables = [[channel for channel in table if channel.fault is None] for table in read]
    left_out = [
        str(channel.fault).replace(str(file), file.name)
        for table in read
        for channel in table
        if channel.fault
    ]
    table = max(
        (candidate for candidate in tables if candidate),
        key=lambda candidate: candidate[0].values.size,
        default=[],
    )
    time = next((channel for channel in table if channel.name == "time"), None)
    if time is None or time.values.size < 2:
        raise RecordingError(
            "the recording has no time axis",
            where=str(file.name),
            allowed="a column 'time' with at least two values",
        )
    count = time.values.size
    step = float(time.values[-1] - time.values[0]) / (count - 1)
    even = _is_even(time.values, step, str(file.name))
    folder.mkdir(parents=True, exist_ok=True)
    if not even:
        np.save(folder / "time.npy", time.values)
    channels: list[dict[str, str]] = []
    for k, channel in enumerate(
        [channel for channel in table if channel is not time][:_MOST_CHANNELS]
    ):
        values = np.asarray(channel.values, np.float32)
        np.save(folder / f"{k}.npy", values)
        starts = np.arange(0, count, BLOCK)
        np.save(
            folder / f"{k}.levels.npy",
            np.stack([end.reduceat(values, starts) for end in (np.fmin, np.fmax)]),
        )
        same = sum(other["name"].partition(" #")[0] == channel.name for other in channels)
        channels.append(
            {"name": f"{channel.name} #{same + 1}" if same else channel.name, "unit": channel.unit}
        )
    about = {"count": count, "first": float(time.values[0]), "step": float(step), "even": even,
             "last": float(time.values[-1]), "unit": time.unit or "s", "channels": channels,
             "left_out": left_out[:_MOST_CHANNELS]}  # fmt: skip
    (folder / ABOUT).write_text(json.dumps(about), encoding="utf-8")
    return about


def _is_even(time: Array, step: float, where: str) -> bool:
    """Whether instants are evenly spaced, checked in cache-sized chunks; an error if they do not ascend."""
    even = True
    for start in range(0, len(time) - 1, _PIECE):
        part = time[start : start + _PIECE + 1]
        if not bool(np.all(part[1:] > part[:-1])):
            raise RecordingError("time does not increase", where=where)
        wanted = time[0] + step * np.arange(start, start + len(part))
        even = even and bool(np.abs(part - wanted).max() <= _UNEVEN * step)
    return even


@dataclass(frozen=True)
class Levels:
    """A stored record: its channels, and the extremes of every 256 samples."""

    folder: Path
    about: dict[str, Any]

    def viewer(self, names: Sequence[str], low: float, high: float, columns: int) -> Viewer:
        """Return some channels from ``low`` to ``high`` (in the unit of its time) in a number of columns."""
        from jounce.report.live import Curve, Pane, Viewer, ViewerScene

        known = {channel["name"]: k for k, channel in enumerate(self.about["channels"])}
        for name in names:
            if name not in known:
                raise unknown(name, known, what="channel", where="channels")
        first, last = self._index(low), min(self._index(high) + 1, self.about["count"])
        if last - first < 2:
            first, last = max(0, first - 1), min(first + 2, self.about["count"])
        edges = (
            None
            if last - first <= 4 * columns
            else np.linspace(first, last, columns + 1).astype(np.int64)
        )
        panes = []
        for name in names:
            y = self._values(known[name], first, last, edges)
            unit = self.about["channels"][known[name]]["unit"]
            panes.append(Pane(name, name, DisplayUnit(unit, 1.0).name, (Curve(name, "after", y),)))
        places = np.arange(first, last) if edges is None else _twice(edges)
        scene = ViewerScene("record", "record", self._time(places), tuple(panes))
        return Viewer("", (scene,), (("after", "record", True),), unit=self.about["unit"])

    def _values(self, channel: int, first: int, last: int, edges: Any) -> Array:
        values = np.load(self.folder / f"{channel}.npy", mmap_mode="r")
        if edges is None:
            return np.asarray(values[first:last], float)
        if (last - first) / (len(edges) - 1) >= 4 * BLOCK:
            levels = np.load(self.folder / f"{channel}.levels.npy", mmap_mode="r")
            starts = edges[:-1] // BLOCK
            below, above = levels[0, : -(-last // BLOCK)], levels[1, : -(-last // BLOCK)]
        else:
            part = np.asarray(values[first:last])
            starts, below, above = edges[:-1] - first, part, part
        ends = np.fmin.reduceat(below, starts), np.fmax.reduceat(above, starts)
        return np.stack(ends, axis=1).ravel().astype(float)

    def _index(self, time: float) -> int:
        count = int(self.about["count"])
        if self.about["even"]:
            index = int(
                np.floor(np.clip((time - self.about["first"]) / self.about["step"], 0.0, count - 1))
            )
        else:
            index = (
                int(
                    np.searchsorted(np.load(self.folder / "time.npy", mmap_mode="r"), time, "right")
                )
                - 1
            )
        return min(max(index, 0), count - 1)

    def _time(self, places: Any) -> Array:
        if self.about["even"]:
            return np.asarray(self.about["first"] + self.about["step"] * places, float)
        times = np.load(self.folder / "time.npy", mmap_mode="r")
        whole = np.floor(places).astype(np.int64)
        return np.asarray(
            times[whole]
            + (places - whole) * (times[np.minimum(whole + 1, len(times) - 1)] - times[whole])
        )


def _twice(edges: Any) -> Any:
    """Return two positions per column: at its start and at its middle."""
    return np.stack([edges[:-1], 0.5 * (edges[:-1] + edges[1:])], axis=1).ravel()
