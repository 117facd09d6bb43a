"""Small figures of a page: lines, points and intervals as data, rendered as SVG in the colours of the page.

A report has dozens of them, so they are rendered directly, without a plotting library. Colours are CSS classes that a
page defines for light, dark and print. Only screen coordinates are computed here.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from html import escape
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.types import Array
from jounce.plots.thinning import thin

Style = Literal[
    "line", "dashed", "dotted", "dash-dotted", "long-dashed", "two-dotted", "wide-dotted", "thick",
    "dots", "squares", "rings", "diamonds", "crosses",
]  # fmt: skip
CSS = (Path(__file__).parent / "templates" / "chart.css").read_text(encoding="utf-8")
"""Colours and lines of a chart's classes, also for the workbench."""
_DASHES = {
    name: [int(length) for length in lengths.split()]
    for name, lengths in re.findall(r"\.chart \.([\w-]+)\{stroke-dasharray:([\d ]+)\}", CSS)
}
"""Lengths of dashes and gaps of line styles, px."""
LINES: dict[str, Style] = {
    "before": "dashed",
    "other-5": "dashed",
    "other-1": "dotted",
    "other-2": "dash-dotted",
    "other-3": "long-dashed",
    "other-4": "two-dotted",
    "other-6": "wide-dotted",
}
"""Line style of compared curves by their role, as in the viewer; others are solid."""
MARKS = ("dots", "squares", "rings", "diamonds", "crosses")


@dataclass(frozen=True)
class Series:
    """Points (x, y) in display units; ``role`` sets the colour, ``label`` is the legend entry, if any."""

    x: ArrayLike
    y: ArrayLike
    role: str = "after"
    style: Style = "line"
    label: str = ""


@dataclass(frozen=True)
class Panel:
    """One pair of axes.

    Attributes
    ----------
    series : tuple of Series
        Drawn in order.
    x_label, y_label, title : str
        With the unit in brackets.
    bands : tuple of (float, float, str)
        Shaded ranges of x with their legend entries.
    verticals : tuple of (float, str, str)
        Positions on x, their role and legend entry.
    lanes : tuple of str
        Names instead of numbers on y; y is then 0, 1, ... from the top.
    notes : tuple of (float, float, str)
        Positions and the short texts to the right of them.
    x_range, y_range : (float, float), optional
        Limits of the axes; by default those of the data.
    from_zero : bool
        Whether the y axis begins at zero.
    width, height : int
        Size in pixels at which the text has the size of the page's text.
    drawn : str
        SVG elements of a drawing that takes the place of axes and series.
    is_first_on_top : bool
        Whether the first series is drawn last, over the others.
    """

    series: tuple[Series, ...]
    x_label: str = ""
    y_label: str = ""
    title: str = ""
    bands: tuple[tuple[float, float, str], ...] = ()
    verticals: tuple[tuple[float, str, str], ...] = ()
    lanes: tuple[str, ...] = ()
    notes: tuple[tuple[float, float, str], ...] = ()
    x_range: tuple[float, float] | None = None
    y_range: tuple[float, float] | None = None
    from_zero: bool = False
    width: int = 430
    height: int = 250
    drawn: str = ""
    is_first_on_top: bool = False


@dataclass(frozen=True)
class Chart:
    """Panels, side by side if they fit, with a file name (without suffix), a caption and alternative text."""

    panels: tuple[Panel, ...]
    name: str
    caption: str
    alternative: str
    columns: int = field(default=2)


_CHARACTER, _BOLD = 6.6, 7.2  # average width of a 12-pixel character, regular and in titles
_FINE = 4  # steps per pixel


def ticks(low: float, high: float, count: int = 5) -> list[float]:
    """Return round tick positions between two limits.

    Examples
    --------
    >>> ticks(0.0, 12.3), ticks(-1.0, 1.0)
    ([0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.0], [-1.0, -0.5, 0.0, 0.5, 1.0])
    """
    span = high - low
    if not (math.isfinite(span) and span > 0.0):
        return [low] if math.isfinite(low) else []
    raw = span / count
    power = 10.0 ** math.floor(math.log10(raw))
    step = min((s * power for s in (1.0, 2.0, 5.0, 10.0)), key=lambda s: abs(math.log(s / raw)))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [round(k * step, 12) if step < 1e9 else k * step for k in range(first, last + 1)]


def tick_text(value: float) -> str:
    """Format a tick label: ``−0.5``, ``1200``, ``1e−7``."""
    text = f"{value:.10g}"
    if "e" in text:
        mantissa, _, power = text.partition("e")
        text = f"{mantissa}e{int(power)}"
    return text.replace("-", "−")


def panel_svg(panel: Panel, identity: str, alternative: str) -> str:
    """Return one panel as an ``<svg>`` element; ``identity`` is its id on the page."""
    inner = _draw_panel(panel, identity)
    width = f"flex-basis: {panel.width}px; max-width: {1.15 * panel.width:.0f}px"
    size = f'viewBox="0 0 {panel.width} {panel.height}" style="{width}"'
    label = f'role="img" aria-labelledby="{identity}-title"'
    title = f'<title id="{identity}-title">{escape(alternative)}</title>'
    return f'<svg class="chart" {size} {label}>{title}{inner}</svg>'


def chart_svg(chart: Chart, style: str, note: str = "") -> str:
    """Return a whole figure as an SVG file with its own style sheet and an optional ``note`` at the bottom."""
    rows = [chart.panels[i : i + chart.columns] for i in range(0, len(chart.panels), chart.columns)]
    width = max(sum(panel.width for panel in row) for row in rows)
    parts, top = [], 0
    for i, row in enumerate(rows):
        left = 0
        for j, panel in enumerate(row):
            size = f'x="{left}" y="{top}" width="{panel.width}" height="{panel.height}"'
            parts.append(f"<svg {size}>{_draw_panel(panel, f'p{i}-{j}')}</svg>")
            left += panel.width
        top += max(panel.height for panel in row)
    if note:
        top += 16
        parts.append(
            f'<text class="bad" x="{width - 6}" y="{top - 5}" text-anchor="end">{escape(note)}</text>'
        )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="chart" width="{width}" height="{top}" '
        f'viewBox="0 0 {width} {top}" role="img"><title>{escape(chart.alternative)}</title><style>{style}</style>'
        f'<rect class="paper" width="{width}" height="{top}"/>{"".join(parts)}</svg>\n'
    )


def _draw_panel(panel: Panel, identity: str) -> str:
    if panel.drawn:
        return panel.drawn
    x0, x1, y0, y1 = _ranges(panel)
    y_ticks = [] if panel.lanes else ticks(y0, y1, max(2, panel.height // 55))
    names = list(panel.lanes) or [tick_text(value) for value in y_ticks]
    most = int(0.42 * panel.width / _CHARACTER)
    names = [name if len(name) <= most else f"…{name[1 - most :]}" for name in names]
    left = (
        12
        + (16 if panel.y_label else 0)
        + int(_CHARACTER * max((len(name) for name in names), default=0))
    )
    legend = _legend(panel, left)
    top = 8 + (18 if panel.title else 0) + 16 * len(legend)
    right, bottom = (
        panel.width - 12 - _overhang(panel, x0, x1),
        panel.height - (40 if panel.x_label else 24),
    )
    x_ticks = ticks(x0, x1, max(3, int((right - left) // 75)))

    def at_x(value: float) -> float:
        return left + (value - x0) / (x1 - x0) * (right - left)

    def at_y(value: float) -> float:
        return bottom - (value - y0) / (y1 - y0) * (bottom - top)

    out = [
        f'<clipPath id="{identity}-clip"><rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}"/>'
    ]
    out.append("</clipPath>")
    for low, high, _ in panel.bands:
        a, b = sorted((min(max(at_x(low), left), right), min(max(at_x(high), left), right)))
        out.append(
            f'<rect class="span" x="{a:.1f}" y="{top}" width="{b - a:.1f}" height="{bottom - top}"/>'
        )
    if not panel.lanes:
        lines = "".join(f"M{left} {at_y(value):.1f}H{right}" for value in y_ticks)
        out.append(f'<path class="grid" d="{lines}"/>')
    out.append(
        f'<path class="grid" d="{"".join(f"M{at_x(value):.1f} {top}V{bottom}" for value in x_ticks)}"/>'
    )
    places = (
        [at_y(k) for k in range(len(names))] if panel.lanes else [at_y(value) for value in y_ticks]
    )
    out += [
        f'<text x="{left - 6}" y="{place + 4:.1f}" text-anchor="end">{escape(name)}</text>'
        for name, place in zip(names, places, strict=True)
    ]
    out += [
        f'<text x="{at_x(value):.1f}" y="{bottom + 16}" text-anchor="middle">{tick_text(value)}</text>'
        for value in x_ticks
    ]
    out.append(f'<path class="axis" d="M{left} {top}V{bottom}H{right}"/>')
    for place, role, _ in panel.verticals:
        if x0 <= place <= x1:
            out.append(
                f'<path class="l {escape(role)} dotted" d="M{at_x(place):.1f} {top}V{bottom}"/>'
            )
    ordered = panel.series[::-1] if panel.is_first_on_top else panel.series
    body = "".join(
        _series(series, (x0, x1, y0, y1), (left, right, top, bottom)) for series in ordered
    )
    out.append(f'<g clip-path="url(#{identity}-clip)">{body}</g>')
    for x, y, text in panel.notes:
        out.append(
            f'<text class="note" x="{at_x(x) + 7:.1f}" y="{at_y(y) + 4:.1f}">{escape(text)}</text>'
        )
    if panel.title:
        fits = panel.width - int(_BOLD * len(panel.title))  # a long title starts left of the axis
        out.append(
            f'<text class="title" x="{max(2, min(left, fits))}" y="16">{escape(panel.title)}</text>'
        )
    if panel.x_label:
        middle = (left + right) / 2
        out.append(
            f'<text x="{middle:.0f}" y="{bottom + 34}" text-anchor="middle">{escape(panel.x_label)}</text>'
        )
    if panel.y_label:
        middle = (top + bottom) / 2
        turned = f'transform="translate(13 {middle:.0f}) rotate(-90)"'
        out.append(f'<text {turned} text-anchor="middle">{escape(panel.y_label)}</text>')
    for row, entries in enumerate(legend):
        place = left
        y = 14 + (18 if panel.title else 0) + 16 * row
        for kind, role, label in entries:
            out.append(_sample(kind, role, place, y))
            out.append(f'<text x="{place + 26}" y="{y}">{escape(label)}</text>')
            place += 40 + int(_CHARACTER * len(label))
    return "".join(out)


def _overhang(panel: Panel, x0: float, x1: float) -> int:
    """Return the pixels beyond the axes that texts to the right of points require."""
    return max(
        (
            int(_CHARACTER * len(text)) + 8
            for x, _, text in panel.notes
            if len(text) > 4 and x > x0 + 0.7 * (x1 - x0)
        ),
        default=0,
    )


def _legend(panel: Panel, left: int) -> list[list[tuple[str, str, str]]]:
    entries: dict[str, tuple[str, str, str]] = {}
    for series in panel.series:
        if series.label:
            entries.setdefault(series.label, (series.style, series.role, series.label))
    for _, role, label in panel.verticals:
        if label:
            entries.setdefault(label, ("dotted", role, label))
    for _, _, label in panel.bands:
        if label:
            entries.setdefault(label, ("band", "span", label))
    rows: list[list[tuple[str, str, str]]] = []
    used = math.inf
    for entry in entries.values():
        width = 40 + int(_CHARACTER * len(entry[2]))
        if used + width > panel.width - left:
            rows.append([])
            used = 0
        rows[-1].append(entry)
        used += width
    return rows


def _sample(kind: str, role: str, x: float, y: float) -> str:
    if kind == "band":
        return f'<rect class="span" x="{x}" y="{y - 10}" width="20" height="10"/>'
    if kind in MARKS:
        return f'<path class="m {escape(role)} {kind}" d="{_mark(kind, x + 10, y - 4)}"/>'
    return f'<path class="l {escape(role)} {kind}" d="M{x} {y - 4}h20"/>'


def _ranges(panel: Panel) -> tuple[float, float, float, float]:
    """Return the limits of the x and y axes, with a fallback if no finite values are drawn."""
    xs = np.concatenate(
        [np.asarray(series.x, float).ravel() for series in panel.series] or [np.zeros(0)]
    )
    ys = np.concatenate(
        [np.asarray(series.y, float).ravel() for series in panel.series] or [np.zeros(0)]
    )
    x0, x1 = panel.x_range or _with_margin(xs, 0.08 if panel.lanes else 0.02)
    if panel.lanes:
        return x0, x1, len(panel.lanes) - 0.4, -0.6
    if panel.y_range:
        return x0, x1, *panel.y_range
    seen = np.interp(xs, [x0, x1], [0.0, 1.0]) if len(xs) else xs
    inside = (
        ys[(seen >= 0.0) & (seen <= 1.0) & (xs >= x0) & (xs <= x1)] if len(xs) == len(ys) else ys
    )
    y0, y1 = _with_margin(inside, 0.06)
    return x0, x1, min(0.0, y0) if panel.from_zero and inside.min(initial=0.0) >= 0.0 else y0, y1


def _with_margin(values: Array, share: float) -> tuple[float, float]:
    known = values[np.isfinite(values)]
    if not len(known):
        return 0.0, 1.0
    low, high = float(known.min()), float(known.max())
    if not high > low:
        reach = abs(low) or 1.0
        return low - 0.1 * reach, high + 0.1 * reach
    return low - share * (high - low), high + share * (high - low)


def _series(
    series: Series,
    ranges: tuple[float, float, float, float],
    box: tuple[float, float, float, float],
) -> str:
    x0, x1, y0, y1 = ranges
    left, right, top, bottom = box
    x, y = np.asarray(series.x, float).ravel(), np.asarray(series.y, float).ravel()
    role = escape(series.role)
    if series.style in MARKS:
        known = np.isfinite(x) & np.isfinite(y)
        px = left + (x[known] - x0) / (x1 - x0) * (right - left)
        py = bottom - (y[known] - y0) / (y1 - y0) * (bottom - top)
        marks = "".join(
            _mark(series.style, a, b) for a, b in zip(px.tolist(), py.tolist(), strict=True)
        )
        return f'<path class="m {role} {series.style}" d="{marks}"/>'
    pieces = []
    for part in _runs(np.isfinite(x) & np.isfinite(y)):
        u, v = x[part], y[part]
        if len(u) > 1 and bool(np.all(np.diff(u) >= 0.0)):
            u, v = thin(u, v, x0, x1, int(right - left) // 2)
        px = np.round(_FINE * (left + (u - x0) / (x1 - x0) * (right - left)))
        py = np.round(_FINE * (bottom - (v - y0) / (y1 - y0) * (bottom - top)))
        pieces.append(
            _polyline(np.clip(px, -4e5, 4e5).astype(int), np.clip(py, -4e5, 4e5).astype(int))
        )
    return f'<path class="l q {role} {series.style}" transform="scale({1 / _FINE})" d="{"".join(pieces)}"/>'


def _runs(known: Array) -> list[slice]:
    """Return the parts without gaps."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], known, [False]]).astype(int)))
    return [slice(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def _polyline(x: Array, y: Array) -> str:
    steps = np.column_stack([np.diff(x), np.diff(y)])
    steps = steps[np.any(steps != 0, axis=1)]
    text = f"M{x[0]} {y[0]}"
    return text + ("l" + " ".join(f"{a} {b}" for a, b in steps.tolist()) if len(steps) else "h0")


def _mark(style: str, x: float, y: float) -> str:
    if style in ("dots", "rings"):
        return f"M{x - 3.5:.1f} {y:.1f}a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0-7 0z"
    if style == "squares":
        return f"M{x - 3.2:.1f} {y - 3.2:.1f}h6.4v6.4h-6.4z"
    if style == "diamonds":
        return f"M{x:.1f} {y - 5:.1f}l4.2 5l-4.2 5l-4.2-5z"
    return f"M{x - 4:.1f} {y - 4:.1f}l8 8m0-8l-8 8"


SCALED_CSS = (
    f".chart .q{{stroke-width:{1.4 * _FINE}}}.chart .q.measured{{stroke-width:{2 * _FINE}}}"
    f".chart .q.thick{{stroke-width:{3.5 * _FINE}}}"
    + "".join(
        f".chart .q.{name}{{stroke-dasharray:{' '.join(str(_FINE * part) for part in dash)}}}"
        for name, dash in _DASHES.items()
    )
)
"""Line widths of scaled paths, for SVG renderers without `vector-effect`."""
