"""Figures of spring maps: force over deflection with loading and unloading, and the rate."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.numbers import number
from jounce.plots.figures import INK, MUTED, PALETTE, in_style, legend_above, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from jounce.springs.curves import PressCurve
    from jounce.springs.map import SpringMap


@in_style
def spring_map_curves(result: SpringMap, title: str = "") -> Figure:
    """Draw force over deflection of each loading speed with loading, unloading and interval, and the rate.

    Parameters
    ----------
    result : SpringMap
        Result of :func:`jounce.spring_map`.
    title : str
        Name of the part.

    Returns
    -------
    matplotlib.figure.Figure
        Force over deflection, with the law of a bump stop; and the slope of the force.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> x = 0.03 - np.abs(np.linspace(-0.03, 0.03, 1201))
    >>> force = 25e3 * np.maximum(x - 0.005, 0.0) + np.random.default_rng(1).normal(0.0, 1.0, x.size)
    >>> made = jn.spring_map([jn.PressFile("spring.csv", x, force)])
    >>> jn.plots.figure_of(made).axes[0].get_xlabel()
    'deflection from contact [mm]'
    """
    reach = max(float(item.deflection[-1]) for item in result.curves)
    height = max(float(item.high[-1]) for item in result.curves)
    length, force = display_unit("m", reach), display_unit("N", height)
    rate = display_unit("N/m", height / reach)
    figure = new_figure(3.8)
    left, right = figure.subplots(1, 2)
    for k, item in enumerate(result.curves):
        colour = PALETTE[k % len(PALETTE)]
        x = item.deflection * length.factor
        left.fill_between(
            x,
            item.low * force.factor,
            item.high * force.factor,
            color=colour,
            alpha=0.3,
            linewidth=0.0,
        )
        left.plot(
            x, item.force * force.factor, color=colour, linewidth=1.3, label=speed_words(item)
        )
        if item.has_unloading:
            for sign in (1.0, -1.0):
                way = item.force + sign * item.hysteresis
                left.plot(x, way * force.factor, color=colour, linewidth=0.6, linestyle=":")
        slope = np.gradient(item.force, item.deflection)
        right.plot(x, slope * rate.factor, color=colour, linewidth=1.2)
    for knee in result.knees:
        for axis in (left, right):
            axis.axvline(
                knee.deflection.value * length.factor, color=MUTED, linewidth=0.8, linestyle="--"
            )
    if result.law is not None:
        x = result.curve.deflection
        law = result.law.rate.value * x + result.law.progression.value * x**3
        left.plot(
            x * length.factor, law * force.factor, color=INK, linewidth=0.9, linestyle="--",
            label="law for a rig",
        )  # fmt: skip
    left.set(xlabel=length.label("deflection from contact"), ylabel=force.label("force"))
    right.set(xlabel=length.label("deflection from contact"), ylabel=rate.label("rate"))
    right.set_ylim(bottom=0.0)
    left.set_title(title)
    legend_above(left, 2)
    return figure


def speed_words(item: PressCurve) -> str:
    """Write a loading speed.

    >>> from types import SimpleNamespace
    >>> speed_words(SimpleNamespace(speed=0.02)), speed_words(SimpleNamespace(speed=float("nan")))
    ('20.0 mm/s', 'speed unknown')
    """
    return "speed unknown" if math.isnan(item.speed) else f"{number(1e3 * item.speed, 3)} mm/s"
