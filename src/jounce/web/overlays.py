"""Recordings of a project on one axis: their curves at screen resolution, and the figures of a window."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from jounce.analysis.layouts import TIME, Layout
from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.core.phrases import Phrase, german_of
from jounce.core.types import Array
from jounce.core.units import unit_factor
from jounce.web.formulas import with_formulas
from jounce.web.known_channels import is_known_channel
from jounce.web.levels import Levels
from jounce.web.stored import RecordSource

if TYPE_CHECKING:
    from jounce.report.live import Viewer

ROLES = ("after", "other-5", "other-1", "other-2", "other-3", "other-6")
"""Colours of curves, in the order of recordings or of channels."""
_SPARSE = 2  # samples per column up to which all samples are drawn


@dataclass(frozen=True)
class Clock:
    """Axis of one recording: its own values times ``factor`` plus ``shift`` are those of the common axis."""

    levels: Levels
    axis: str
    unit: str
    factor: float
    shift: float

    def index(self, values: Any, *, behind: bool = False) -> Any:
        """Return the first samples that are not before values of the common axis, or are ``behind`` them."""
        own = (np.asarray(values, float) - self.shift) / self.factor
        return self.levels.first_from(own, self.axis, behind=behind)

    def at(self, first: int, last: int) -> Array:
        """Return the values of a range of samples on the common axis."""
        own = self.levels.axis_values(self.axis, first, last)
        return np.asarray(self.factor * own + self.shift, float)

    @property
    def ends(self) -> tuple[float, float]:
        """First and last value on the common axis."""
        count = self.levels.about["count"]
        return float(self.at(0, 1)[0]), float(self.at(count - 1, count)[0])


@dataclass(frozen=True)
class Track:
    """A recording of a layout: its samples on the common axis, or the reason why it is not shown."""

    number: int
    path: str
    clock: Clock | None
    digest: str = ""
    problem: JounceError | None = None
    formulas: Sequence[dict[str, Any]] = ()


@dataclass(frozen=True)
class Trace:
    """One channel of one recording in a graph; its samples times ``factor`` are in the unit of the graph."""

    graph: int
    order: int
    channel: str
    track: Track
    clock: Clock
    unit: str
    factor: float

    def value(self, place: float) -> float | None:
        """Return the value at a place of the common axis, between two samples on a straight line."""
        levels, count = self.clock.levels, self.clock.levels.about["count"]
        after = int(self.clock.index(place))
        low, high = max(0, after - 1), min(after + 1, count)
        x = self.clock.at(low, high)
        if not x.size or not x[0] <= place <= x[-1]:
            return None
        y = np.asarray(levels.samples(self.channel)[low:high], float)
        value = float(np.interp(place, x, y)) * self.factor
        return value if np.isfinite(value) else None


def tracks_of(records: RecordSource, layout: Layout) -> list[Track]:
    """Open the recordings of a layout; those that cannot be shown say why."""
    tracks: list[Track] = []
    opened: dict[str, Levels] = {}
    refused: dict[str, JounceError] = {}
    for path in dict.fromkeys(laid.path for laid in layout.recordings):
        try:
            opened[path] = records.open(path)
        except JounceError as error:
            refused[path] = error
    refused |= records.compute(opened, layout.formulas)
    unit = ""
    for number, laid in enumerate(layout.recordings):
        try:
            if laid.path in refused:
                raise refused[laid.path]
            levels, formulas = with_formulas(opened[laid.path], layout.formulas)
            unit = unit or ("s" if layout.axis == TIME else levels.unit(layout.axis))
            own = levels.about["unit"] if layout.axis == TIME else levels.unit(layout.axis)
            factor = unit_factor(own, unit, where=f"{laid.path}: {layout.axis}")
            levels.check_axis(layout.axis, where=laid.path)
            shift = laid.shifts.get(layout.axis, 0.0)
            clock = Clock(levels, layout.axis, unit, factor, shift)
            tracks.append(Track(number, laid.path, clock, levels.folder.name, None, formulas))
        except JounceError as error:
            tracks.append(Track(number, laid.path, None, "", error))
    return tracks


def traces_of(layout: Layout, tracks: Sequence[Track]) -> tuple[list[Trace], list[JounceError]]:
    """Return the curves of a layout, and what cannot be drawn: channels that no recording has, other units."""
    traces: list[Trace] = []
    problems: list[JounceError] = []
    shown = [(track, track.clock) for track in tracks if track.clock is not None]
    computed = {
        formula.name for formula in layout.formulas
    }  # what is wrong with them is said there
    for number, graph in enumerate(layout.graphs):
        unit: str | None = None
        for order, channel in enumerate(graph.channels):
            having = [(track, clock) for track, clock in shown if channel in clock.levels.names]
            if shown and not having and channel not in computed:
                problems.append(
                    RecordingError(
                        Phrase("no recording has the channel {name!r}", name=channel),
                        where=", ".join(track.path for track, _ in shown),
                    )
                )
            for track, clock in having:
                own = clock.levels.unit(channel)
                unit = own if unit is None else unit
                if not layout.recordings[track.number].shown:
                    continue
                try:
                    factor = unit_factor(own, unit, where=f"{track.path}: {channel}")
                except JounceError as error:
                    problems.append(error)
                    continue
                traces.append(Trace(number, order, channel, track, clock, unit, factor))
    return traces, problems


def curves(
    layout: Layout, tracks: Sequence[Track], low: float, high: float, columns: int
) -> tuple[Viewer, dict[str, Any]]:
    """Return the curves from ``low`` to ``high`` of the common axis, and what the page needs beside them."""
    from jounce.report.live import Curve, Pane, Viewer, ViewerScene

    traces, problems = traces_of(layout, tracks)
    edges = np.linspace(low, high, columns + 1)
    lines = [_polyline(trace, edges) for trace in traces]
    grids = {x.tobytes(): x for x, _ in lines if x.size > 1}
    x = np.unique(np.concatenate([*grids.values(), edges[[0, -1]]]))
    panes, drawn = [], []
    one = len({trace.track.number for trace in traces}) < 2
    for number, graph in enumerate(layout.graphs):
        own = [
            (trace, line)
            for trace, line in zip(traces, lines, strict=True)
            if trace.graph == number
        ]
        panes.append(
            Pane(
                ", ".join(graph.channels),
                ", ".join(graph.channels),
                own[0][0].unit if own else "",
                tuple(
                    Curve(
                        _label(trace, one, len(graph.channels) < 2),
                        ROLES[(trace.order if one else trace.track.number) % len(ROLES)],
                        _read(x, *line),
                    )
                    for trace, line in own
                ),
            )
        )
        drawn.append(
            [
                {"recording": trace.track.number, "dash": 0 if one else trace.order}
                for trace, _ in own
            ]
        )
    unit = next((track.clock.unit for track in tracks if track.clock), "s")
    words = "time" if layout.axis == TIME else layout.axis
    viewer = Viewer("", (ViewerScene("data", "data", x, tuple(panes)),), (), words=words, unit=unit)
    more = {
        "curves": drawn,
        "problems": [said(problem) for problem in problems],
        "lacking": _lacking(layout, tracks),
        "python": python_of(layout, tracks),
    }
    return viewer, more


def _lacking(layout: Layout, tracks: Sequence[Track]) -> list[dict[str, Any]]:
    """Return the recordings that lack channels which others have."""
    shown = [(track.path, set(track.clock.levels.names)) for track in tracks if track.clock]
    wanted = dict.fromkeys(name for graph in layout.graphs for name in graph.channels)
    having = [name for name in wanted if any(name in names for _, names in shown)]
    lacks = [(path, [name for name in having if name not in names]) for path, names in shown]
    return [{"path": path, "channels": missing} for path, missing in lacks if missing]


def python_of(layout: Layout, tracks: Sequence[Track]) -> str:
    """Return Python code that computes the same channels and statistics of the window."""
    lines = ["import jounce as jn"]
    wanted = dict.fromkeys(name for graph in layout.graphs for name in graph.channels)
    for track in tracks:
        if track.clock is None:
            continue
        units = {
            channel["name"]: channel["unit"]
            for channel in track.clock.levels.about["channels"]
            if "stem" not in channel
        }
        named = [name for name in wanted if name in units]
        read = [name for name in named if is_known_channel(name, units[name])]
        others = [name for name in named if name not in read]
        lines.append("")
        if others:
            lines.append(f"# to be mapped to known channels with columns={{...}}: {others!r}")
        lines.append(f"recording, findings = jn.read_recording({track.path!r})")
        for formula in layout.formulas:
            unit = f", unit={formula.unit!r}" if formula.unit else ""
            lines.append(f"computed = jn.compute_channel(recording, {formula.formula!r}{unit})")
        if layout.cursors and layout.axis == TIME and read:
            shift = layout.recordings[track.number].shifts.get(TIME, 0.0)
            begin, end = (round(value - shift, 9) for value in sorted(layout.cursors))
            lines.append(
                f"statistics = jn.describe_channels(recording, {read!r}, begin={begin!r}, end={end!r})"
            )
    return "\n".join(lines) + "\n"


def about_tracks(tracks: Sequence[Track]) -> list[dict[str, Any]]:
    """Return what the page shows of each recording: its state, its range on the common axis, and its channels."""
    return [
        {
            "path": track.path,
            "digest": track.digest,
            "problem": None if track.problem is None else said(track.problem),
            "ends": None if track.clock is None else track.clock.ends,
            "count": 0 if track.clock is None else track.clock.levels.about["count"],
            "channels": [] if track.clock is None else track.clock.levels.about["channels"],
            "formulas": track.formulas,
        }
        for track in tracks
    ]


def whole_range(tracks: Sequence[Track], layout: Layout) -> tuple[float, float]:
    """Return the range of the common axis that the shown recordings cover."""
    shown = [
        track.clock.ends
        for track in tracks
        if track.clock and layout.recordings[track.number].shown
    ]
    ends = shown or [track.clock.ends for track in tracks if track.clock] or [(0.0, 1.0)]
    low, high = min(first for first, _ in ends), max(last for _, last in ends)
    return (low, high) if high > low else (low - 0.5, low + 0.5)


def window_rows(
    layout: Layout, tracks: Sequence[Track], begin: float, end: float
) -> list[dict[str, Any]]:
    """Return values at both cursors and statistics of every sample between them, for each curve."""
    from jounce.analysis.window import window_statistics

    rows: list[dict[str, Any]] = []
    for trace in traces_of(layout, tracks)[0]:
        first, last = samples_within(trace.clock, min(begin, end), max(begin, end))
        a, b = trace.value(begin), trace.value(end)
        row: dict[str, Any] = {
            "recording": trace.track.number,
            "graph": trace.graph,
            "order": trace.order,
            "channel": trace.channel,
            "unit": trace.unit,
            "a": a,
            "b": b,
            "difference": None if a is None or b is None else b - a,
            "statistics": None,
        }
        values = trace.clock.levels.samples(trace.channel)[first:last]
        if values.size and np.isfinite(values).any():
            found = window_statistics(values).to_dict()
            scaled = {
                name: number * trace.factor for name, number in found.items() if name not in _COUNTS
            }
            if trace.factor < 0.0:
                scaled |= {"minimum": scaled["maximum"], "maximum": scaled["minimum"]}
            row["statistics"] = {**found, **scaled}
        rows.append(row)
    return rows


_COUNTS = ("samples", "missing")


def samples_within(clock: Clock, begin: float, end: float) -> tuple[int, int]:
    """Return the first sample not before ``begin``, and the one behind the last not after ``end``."""
    return int(clock.index(begin)), int(clock.index(end, behind=True))


def aligned(
    layout: Layout,
    tracks: Sequence[Track],
    reference: int,
    moved: int,
    channel: str,
    *,
    by: Literal["correlation", "rise", "fall", "maximum", "minimum", "start"],
    level: float | None = None,
    maximum_shift: float | None = None,
    moved_channel: str = "",
) -> dict[str, Any]:
    """Return the shift of a recording on the common axis that aligns it with another, and how well they agree.

    ``moved_channel`` is the channel of the moved recording if its name differs.
    The shift is absolute: that of the reference is added. Different rates are compared at the lower one.
    """
    from jounce.analysis.alignment import coincident, correlated, mean_rate

    if reference == moved or max(reference, moved) >= len(tracks):
        raise DescriptionError(
            "these are not two recordings of the layout", where="reference, moved"
        )
    channels = {reference: channel, moved: moved_channel or channel}
    first, second = (_whole_track(tracks[number], name) for number, name in channels.items())
    if by == "correlation":
        lower = mean_rate(first, second)
        found = correlated(first, second, maximum_shift=maximum_shift, resample=lower)
    else:
        units = [
            clock.levels.unit(channels[number])
            for number in (moved, reference)
            if (clock := tracks[number].clock) is not None
        ]
        factor = unit_factor(units[0], units[1], where=tracks[moved].path)
        second = replace(second, values=factor * second.values)
        found = coincident(first, second, by, level)
    base = layout.recordings[reference].shifts.get(layout.axis, 0.0)
    return {**found.to_dict(), "shift": base + found.shift}


def _whole_track(track: Track, channel: str) -> Any:
    from jounce.analysis.alignment import Track as Signal
    from jounce.analysis.alignment import track_over

    if track.clock is None:
        raise track.problem or RecordingError("not shown", where=track.path)
    clock, where = track.clock, f"{track.path}: {channel}"
    count = int(clock.levels.about["count"])
    along = clock.factor * np.asarray(clock.levels.axis_values(clock.axis, 0, count), float)
    values = np.asarray(clock.levels.samples(channel), float)
    if clock.axis == TIME:
        return Signal(along, values, where)
    return track_over(along, values, where, clock.unit)


def said(error: JounceError) -> dict[str, Any]:
    """Return a message as pages show it."""
    text = error.message()
    return {"text": str(text), "german": german_of(text)}


def _polyline(trace: Trace, edges: Array) -> tuple[Array, Array]:
    """Return what is drawn of a curve: its samples, or minimum and maximum of each column."""
    clock, levels = trace.clock, trace.clock.levels
    count = int(levels.about["count"])
    places = np.minimum(clock.index(edges), count)
    first, last = max(0, int(places[0]) - 1), min(count, int(places[-1]) + 1)
    if last - first <= _SPARSE * (len(edges) - 1):
        y = np.asarray(levels.samples(trace.channel)[first:last], float)
        return clock.at(first, last), trace.factor * y
    filled = np.flatnonzero(places[1:] > places[:-1])
    ends = levels.extremes(trace.channel, places[filled], int(places[filled[-1] + 1]))
    x = np.stack([edges[filled], 0.5 * (edges[filled] + edges[filled + 1])], axis=1).ravel()
    return x, trace.factor * np.stack(ends, axis=1).ravel().astype(float)


def _read(x: Array, own: Array, values: Array) -> Array:
    """Return a drawn line at other places on it; gaps beyond its ends."""
    if not own.size:
        return np.full(x.size, np.nan)
    return np.interp(x, own, values, left=np.nan, right=np.nan)


def _label(trace: Trace, one_recording: bool, one_channel: bool) -> str:
    name = trace.track.path.rpartition("/")[2]
    return ", ".join(
        [*([] if one_channel else [trace.channel]), *([] if one_recording else [name])]
    )
