"""Figures of speed limits: metrics over speed, and limit speeds over the height of an obstacle."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.numbers import number
from jounce.plots.figures import INK, PALETTE, in_lines, in_style, legend_above, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.variants.limits import SpeedLimits

_LONGEST = 26  # characters of a line of a panel's title


@in_style
def speed_limit_curves(result: SpeedLimits, title: str = "") -> Figure:
    """Draw each metric over speed with its limit; of several heights also the limit speed over height.

    Parameters
    ----------
    result : SpeedLimits
        Result of :func:`jounce.find_speed_limits`.
    title : str
        Vehicle and road.

    Returns
    -------
    matplotlib.figure.Figure
        One panel for each metric, with a line for each height.

    Examples
    --------
    >>> import jounce as jn
    >>> bump = jn.HalfSine(height="60 mm", length="1 m")
    >>> found = jn.find_speed_limits("audi-a6-quarter-car", bump, fastest=10.0, points=3)
    >>> jn.plots.figure_of(found).axes[0].get_xlabel()
    'speed [m/s]'
    """
    metrics = list(dict.fromkeys(curve.metric for curve in result.curves))
    several = len(result.heights) > 1
    panels = len(metrics) + several
    figure = new_figure(3.4 * -(-panels // 2) + 0.2)
    axes = figure.subplots(-(-panels // 2), min(panels, 2), squeeze=False).ravel()
    speed = display_unit("m/s")
    for axis, metric in zip(axes, metrics, strict=False):
        _over_speed(axis, result, metric, speed.factor)
        axis.set_xlabel(speed.label("speed"))
    if several:
        _over_height(axes[len(metrics)], result, speed.factor)
        axes[len(metrics)].set_ylabel(speed.label("limit speed"))
    for axis in axes[panels:]:
        axis.set_visible(False)
    if title:
        figure.suptitle(title)
    return figure


def _over_speed(axis: Axes, result: SpeedLimits, metric: str, factor: float) -> None:
    """Draw a metric over speed, its limit, and where it crosses it."""
    curves = [curve for curve in result.curves if curve.metric == metric]
    top = max(float(np.nanmax(np.abs(curve.values), initial=0.0)) for curve in curves)
    unit = display_unit(curves[0].unit, max(top, abs(curves[0].limit)))
    for k, curve in enumerate(curves):
        colour = PALETTE[k % len(PALETTE)]
        height = "" if curve.height is None else f"{number(1e3 * curve.height, 3)} mm"
        axis.plot(
            curve.speed * factor, curve.values * unit.factor, "o-", color=colour, markersize=2.5,
            linewidth=1.2, label=height or None,
        )  # fmt: skip
        for item in curve.crossings:
            axis.plot(
                item.speed * factor, curve.limit * unit.factor, "v" if item.is_exceeded_above else "^",
                color=colour, markersize=6,
            )  # fmt: skip
    axis.axhline(curves[0].limit * unit.factor, color=INK, linewidth=0.9, linestyle="--")
    axis.set_ylabel(unit.label(in_lines(metric, _LONGEST)))
    if len(curves) > 1:
        legend_above(axis, 4)


def _over_height(axis: Axes, result: SpeedLimits, factor: float) -> None:
    """Draw the limit speed of all limits over height; triangles point to where it is if it was not driven."""
    heights = [height for height in result.heights if height is not None]
    slowest, fastest = result.curves[0].speed[[0, -1]]
    speeds = [result.limit_speed(height) for height in heights]
    ends = [fastest if speed is None else speed for speed in speeds]
    x = [1e3 * height for height in heights]
    axis.plot(x, [speed * factor for speed in ends], "-", color=PALETTE[0])
    for place, speed, end in zip(x, speeds, ends, strict=True):
        marker = "^" if speed is None else "v" if speed == slowest else "o"
        axis.plot(place, end * factor, marker, color=PALETTE[0])
    axis.set_xlabel("obstacle height [mm]")
    axis.set_xlim(0.0, 1.05e3 * max(heights))
    axis.set_ylim(bottom=0.0)
