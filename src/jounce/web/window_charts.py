"""Spectra, histograms and scatter plots of the window between two cursors, for all recordings of a layout."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.analysis.layouts import TIME, Graph, Layout
from jounce.core.errors import DescriptionError, JounceError
from jounce.core.types import Array
from jounce.core.units import unit_factor
from jounce.web.overlays import ROLES, Trace, Track, said, samples_within, traces_of

if TYPE_CHECKING:
    from jounce.report.live import Viewer

_MOST_POINTS, _MOST_LINES = 3000, 3000  # of a recording in a scatter plot, and of a spectrum
_FEWEST = 16


def window_chart(
    layout: Layout, tracks: Sequence[Track], begin: float, end: float
) -> tuple[Viewer, dict[str, Any]]:
    """Return the chart of a layout for the window from ``begin`` to ``end``, and notes on it."""
    begin, end = min(begin, end), max(begin, end)
    chart = layout.chart
    channel = chart.channel or next(
        (name for graph in layout.graphs for name in graph.channels), ""
    )
    draw = {"spectrum": _spectrum, "histogram": _histogram, "scatter": _scatter}.get(chart.kind)
    if draw is None or not channel:
        raise DescriptionError(
            "no chart is chosen", where="chart", allowed="spectrum, histogram, scatter"
        )
    only = layout.with_fields(graphs=(Graph(channels=(channel,)),))
    traces, problems = traces_of(only, tracks)
    notes = [said(problem) for problem in problems]
    lines = []
    for trace in traces:
        try:
            lines.append((trace, *draw(layout, traces, trace, begin, end)))
        except JounceError as error:
            notes.append(said(error))
    viewer = _viewer(layout, channel, lines)
    figures = [
        {"recording": trace.track.number, **figure} for trace, _, _, figure in lines if figure
    ]
    return viewer, {"notes": notes, "figures": figures}


Line = tuple[Array, Array, dict[str, Any]]


def _window(trace: Trace, channel: str, factor: float, begin: float, end: float) -> Array:
    first, last = samples_within(trace.clock, begin, end)
    values = factor * np.asarray(trace.clock.levels.samples(channel)[first:last], float)
    if np.count_nonzero(np.isfinite(values)) < _FEWEST:
        raise DescriptionError(
            "the window has too few samples",
            where=f"{trace.track.path}: {channel}",
            found=int(values.size),
            allowed=f"{_FEWEST}",
            hint="Move the cursors apart.",
        )
    return values


def _spectrum(
    _layout: Layout, _traces: Sequence[Trace], trace: Trace, begin: float, end: float
) -> Line:
    from jounce.ride.spectra import power_spectrum

    values = _window(trace, trace.channel, trace.factor, begin, end)
    levels = trace.clock.levels
    first, last = samples_within(trace.clock, begin, end)
    own = unit_factor(levels.about["unit"], "s", where=trace.track.path)
    time = own * levels.axis_values(TIME, first, last)
    even = np.linspace(time[0], time[-1], time.size)
    rate = (time.size - 1) / float(time[-1] - time[0])
    spectrum = power_spectrum(
        values if levels.about["even"] else np.interp(even, time, values), rate
    )
    density = np.sqrt(spectrum.density)
    group = -(-density.size // _MOST_LINES)
    starts = np.arange(0, density.size, group)
    x, y = spectrum.frequency[starts], np.maximum.reduceat(density, starts)
    return x, y, {"resolution": spectrum.resolution, "averages": spectrum.averages}


def _histogram(
    layout: Layout, traces: Sequence[Trace], trace: Trace, begin: float, end: float
) -> Line:
    from jounce.analysis.window import histogram

    ends = []
    for one in traces:  # bins are the same for all recordings
        first, last = samples_within(one.clock, begin, end)
        values = one.clock.levels.samples(one.channel)[first:last]
        if values.size and np.isfinite(values).any():
            ends += [one.factor * float(np.nanmin(values)), one.factor * float(np.nanmax(values))]
    values = _window(trace, trace.channel, trace.factor, begin, end)
    found = histogram(values, layout.chart.bins, limits=(min(ends), max(ends)))
    x = np.repeat(found.edges, 2)
    y = np.concatenate([[0.0], np.repeat(100.0 * found.shares, 2), [0.0]])
    return x, y, {}


def _scatter(
    layout: Layout, traces: Sequence[Trace], trace: Trace, begin: float, end: float
) -> Line:
    across = layout.chart.across or trace.channel
    levels = trace.clock.levels
    unit = next(
        (one.clock.levels.unit(across) for one in traces if across in one.clock.levels.names), ""
    )
    factor = unit_factor(levels.unit(across), unit, where=f"{trace.track.path}: {across}")
    x = _window(trace, across, factor, begin, end)
    y = _window(trace, trace.channel, trace.factor, begin, end)
    both = np.isfinite(x) & np.isfinite(y)
    x, y = x[both], y[both]
    figure: dict[str, Any] = {"samples": int(x.size), "every": max(1, -(-x.size // _MOST_POINTS))}
    if x.size > 1 and float(np.ptp(x)) > 0.0 and float(np.ptp(y)) > 0.0:
        slope, level = np.polyfit(x - x.mean(), y, 1)
        figure |= {
            "slope": float(slope),
            "offset": float(level - slope * x.mean()),
            "correlation": float(np.corrcoef(x, y)[0, 1]),
        }
    x, y = x[:: figure["every"]], y[:: figure["every"]]
    order = np.argsort(x, kind="stable")
    return x[order], y[order], figure


def _viewer(
    layout: Layout, channel: str, lines: Sequence[tuple[Trace, Array, Array, Any]]
) -> Viewer:
    from jounce.report.live import Curve, Pane, Viewer, ViewerScene

    kind = layout.chart.kind
    unit = lines[0][0].unit if lines else ""
    across = layout.chart.across or channel
    across_unit = next(
        (t.clock.levels.unit(across) for t, *_ in lines if across in t.clock.levels.names), ""
    )
    if kind == "scatter":  # points of all recordings one after the other, sorted
        x = np.concatenate([own for _, own, _, _ in lines]) if lines else np.zeros(2)
        order, parts, start = np.argsort(x, kind="stable"), [], 0
        for _, own, values, _ in lines:
            part = np.full(x.size, np.nan)
            part[start : start + own.size] = values
            parts.append(part[order])
            start += own.size
        x = x[order]
    else:
        grids = [own for _, own, _, _ in lines] or [np.zeros(2)]
        x = (
            grids[0]
            if all(np.array_equal(grids[0], one) for one in grids)
            else np.unique(np.concatenate(grids))
        )
        parts = [
            values if own.size == x.size else np.interp(x, own, values, right=np.nan)
            for _, own, values, _ in lines
        ]
    words, x_unit, y_unit = {
        "spectrum": ("frequency", "Hz", f"{unit or '1'}/√Hz"),
        "histogram": (channel, unit, "%"),
        "scatter": (across, across_unit, unit),
    }[kind]
    many = len(lines) > 1
    curves = tuple(
        Curve(
            trace.track.path.rpartition("/")[2] if many else "",
            ROLES[trace.track.number % len(ROLES)],
            values,
        )
        for (trace, *_), values in zip(lines, parts, strict=True)
    )
    scene = ViewerScene("chart", "chart", x, (Pane(channel, channel, y_unit, curves),))
    return Viewer("", (scene,), (), words=words, unit=x_unit)
