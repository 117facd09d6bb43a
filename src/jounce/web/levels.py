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

from jounce.core.columns import time_column
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
_SINGLE, _VISIBLE = (
    6e-8,
    1e-5,
)  # relative rounding error of single precision; largest share of a channel's range for it
_SAME = 1e-6  # of a step: instants that are the same
ABOUT = "about.json"
_MOST_CHANNELS = 200


def write_levels(file: Path, folder: Path) -> dict[str, Any]:
    """Read a record without conversion, store its channels in a folder, and return its summary."""
    from jounce.recordings.reader import ReaderOptions
    from jounce.recordings.readers import reader_of

    signals = reader_of(file).read(file, ReaderOptions())
    if not any("time" in table.names for table in signals.tables):
        from jounce.recordings.clocks import by_clock

        signals, _ = by_clock(signals, "", None, bridges_gaps=False)  # 'Time [s]', as loggers write
    read = signals.tables
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
    time = time_column(table)
    if time is None or time.values.size < 2:
        raise RecordingError(
            "the recording has no time axis",
            where=str(file.name),
            allowed="a column of time, as in time [s], with at least two values",
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
        write_channel(folder, str(k), channel.values)
        same = sum(other["name"].partition(" #")[0] == channel.name for other in channels)
        channels.append(
            {"name": f"{channel.name} #{same + 1}" if same else channel.name, "unit": channel.unit}
        )
    about = {"count": count, "first": float(time.values[0]), "step": float(step), "even": even,
             "last": float(time.values[-1]), "unit": time.unit or "s", "channels": channels,
             "left_out": left_out[:_MOST_CHANNELS]}  # fmt: skip
    (folder / ABOUT).write_text(json.dumps(about), encoding="utf-8")
    return about


def write_channel(folder: Path, stem: str, samples: Any) -> None:
    """Store the samples of a channel, and their extremes; in single precision if that loses nothing that is visible."""
    given = np.asarray(samples)
    starts = np.arange(0, given.size, BLOCK)
    low, high = (float(end.reduce(given)) for end in (np.fmin, np.fmax))
    coarse = max(abs(low), abs(high)) * _SINGLE > _VISIBLE * (high - low) > 0.0
    values = np.asarray(given, np.float64 if coarse else np.float32)
    ends = [end.reduceat(values, starts) for end in (np.fmin, np.fmax)]
    np.save(folder / f"{stem}.levels.npy", np.stack(ends))
    np.save(folder / f"{stem}.npy", values)


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

    @property
    def names(self) -> list[str]:
        """Names of the channels, without time."""
        return [channel["name"] for channel in self.about["channels"]]

    def unit(self, name: str) -> str:
        """Return the unit of a channel as in the file."""
        return str(self.about["channels"][self._stem(name)[0]]["unit"])

    def samples(self, name: str) -> Any:
        """Return all samples of a channel, mapped from the file that stores them."""
        return np.load(self.folder / f"{self._stem(name)[1]}.npy", mmap_mode="r")

    def axis_values(self, axis: str, first: int, last: int) -> Array:
        """Return ``time`` or a channel from one sample to before another, in the unit of the file."""
        if axis == "time":
            return self._time(np.arange(first, last))
        return np.asarray(self.samples(axis)[first:last], float)

    def check_axis(self, axis: str, *, where: str) -> None:
        """Refuse a channel with descending values or gaps as an axis."""
        if axis == "time" or (self.folder / f"{self._stem(axis)[1]}.axis").exists():
            return
        values, before = self.samples(axis), -np.inf
        for start in range(0, values.size, _PIECE):
            piece = np.asarray(values[start : start + _PIECE], float)
            if not (piece[0] >= before and bool(np.all(piece[1:] >= piece[:-1]))):
                raise RecordingError(
                    "the channel is no axis: it descends or has gaps",
                    where=f"{where}: {axis}",
                    allowed="time, or a channel that never descends, such as a distance",
                    hint="Compute a distance with the formula integral(speed), or use a scatter plot.",
                )
            before = piece[-1]
        (self.folder / f"{self._stem(axis)[1]}.axis").touch()

    def first_from(self, values: Any, axis: str = "time", *, behind: bool = False) -> Any:
        """Return the first samples not before values of an axis (or ``behind`` them), in the unit of the file."""
        wanted, count = np.asarray(values, float), self.about["count"]
        if axis != "time":
            own = self.samples(axis)
            return np.searchsorted(own, wanted.astype(own.dtype), "right" if behind else "left")
        wanted = wanted + (_SAME if behind else -_SAME) * self.about["step"]  # decimal fractions
        if self.about["even"]:
            steps = np.clip((wanted - self.about["first"]) / self.about["step"], -1.0, count)
            return (np.floor(steps) + 1 if behind else np.ceil(steps)).clip(0, count).astype(int)
        times = np.load(self.folder / "time.npy", mmap_mode="r")
        return np.searchsorted(times, wanted, "right" if behind else "left")

    def extremes(self, name: str, starts: Any, last: int) -> tuple[Any, Any]:
        """Return minimum and maximum from each of the ascending samples ``starts`` to the next, or to ``last``."""
        values = self.samples(name)
        if last - starts[0] >= 4 * BLOCK * len(starts):
            stem = self._stem(name)[1]
            levels = np.load(self.folder / f"{stem}.levels.npy", mmap_mode="r")
            below, above = levels[0, : -(-last // BLOCK)], levels[1, : -(-last // BLOCK)]
            starts = starts // BLOCK
        else:
            below = above = np.asarray(values[starts[0] : last])
            starts = starts - starts[0]
        return np.fmin.reduceat(below, starts), np.fmax.reduceat(above, starts)

    def _stem(self, name: str) -> tuple[int, str]:
        for k, channel in enumerate(self.about["channels"]):
            if channel["name"] == name:
                return k, channel.get("stem", str(k))
        raise unknown(name, self.names, what="channel", where="channels")

    def viewer(self, names: Sequence[str], low: float, high: float, columns: int) -> Viewer:
        """Return some channels from ``low`` to ``high`` (in the unit of its time) in a number of columns."""
        from jounce.report.live import Curve, Pane, Viewer, ViewerScene

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
            y = self._values(name, first, last, edges)
            unit = self.unit(name)
            panes.append(Pane(name, name, DisplayUnit(unit, 1.0).name, (Curve(name, "after", y),)))
        places = np.arange(first, last) if edges is None else _twice(edges)
        scene = ViewerScene("record", "record", self._time(places), tuple(panes))
        return Viewer("", (scene,), (("after", "record", True),), unit=self.about["unit"])

    def _values(self, name: str, first: int, last: int, edges: Any) -> Array:
        if edges is None:
            return np.asarray(self.samples(name)[first:last], float)
        return np.stack(self.extremes(name, edges[:-1], last), axis=1).ravel().astype(float)

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
