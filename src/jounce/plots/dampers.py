"""Figures of damper maps: force over velocity for each setting, and over clicks at given velocities."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.numbers import number
from jounce.plots.figures import PALETTE, in_style, legend_above, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.dampers.curves import DamperSetting
    from jounce.dampers.map import DamperMap

_OVER_CLICKS = 4  # velocities of each direction in the panel over clicks


@in_style
def damper_map_curves(result: DamperMap, title: str = "") -> Figure:
    """Draw the force of each setting over velocity with its interval; of several clicks also over clicks.

    Parameters
    ----------
    result : DamperMap
        Result of :func:`jounce.damper_map`.
    title : str
        Name of the damper.

    Returns
    -------
    matplotlib.figure.Figure
        Force without gas over velocity; with clicks, a second panel of the force over clicks at some velocities.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> t = np.arange(0.0, 10.0, 2e-3)
    >>> x, v = 0.02 * np.sin(10.0 * t), 0.2 * np.cos(10.0 * t)
    >>> channels = {"displacement": (x, "m", ""), "velocity": (v, "m/s", ""), "force": (900.0 * v, "N", "")}
    >>> made = jn.damper_map([jn.RecordFile("sine.csv", jn.recording(t, channels))])
    >>> jn.plots.figure_of(made).axes[0].get_xlabel()
    'velocity, bump positive [m/s]'
    """
    clicks = result.clicks
    force = display_unit("N", max(float(np.abs(item.force).max()) for item in result.settings))
    speed = display_unit("m/s", max(float(np.abs(item.velocity).max()) for item in result.settings))
    figure = new_figure(3.8)
    row = figure.subplots(1, 2 if clicks else 1, squeeze=False, sharey=True)[0]
    for k, item in enumerate(result.settings):
        colour = PALETTE[k % len(PALETTE)]
        x = item.velocity * speed.factor
        row[0].fill_between(
            x,
            item.low * force.factor,
            item.high * force.factor,
            color=colour,
            alpha=0.25,
            linewidth=0.0,
        )
        row[0].plot(
            x, item.force * force.factor, "o-", color=colour, markersize=2.5, linewidth=1.2,
            label=setting_words(item),
        )  # fmt: skip
    row[0].axhline(0.0, color="0.6", linewidth=0.6)
    row[0].axvline(0.0, color="0.6", linewidth=0.6)
    row[0].set(
        xlabel=speed.label("velocity, bump positive"), ylabel=force.label("force without gas")
    )
    row[0].set_title(title)
    if clicks:
        _over_clicks(row[1], result, force.factor, speed.factor, speed.name)
    legend_above(row[0], 2 if clicks else 4)
    return figure


def setting_words(item: DamperSetting) -> str:
    """Write the settings of a curve in usual units.

    >>> from types import SimpleNamespace
    >>> setting_words(SimpleNamespace(settings={"clicks": 8.0, "temperature": 313.15}, files=("a.csv",)))
    '8 clicks, 40 °C'
    """
    words = []
    if "clicks" in item.settings:
        words.append(f"{item.settings['clicks']:g} clicks")
    if "temperature" in item.settings:
        words.append(f"{item.settings['temperature'] - 273.15:.3g} °C")
    if "gas_pressure" in item.settings:
        words.append(f"{item.settings['gas_pressure'] / 1e5:.3g} bar")
    return ", ".join(words) or (
        item.files[0] if len(item.files) == 1 else f"{len(item.files)} records"
    )


def _over_clicks(axes: Axes, result: DamperMap, force: float, speed: float, unit: str) -> None:
    """Draw the force over clicks at velocities spread over the measured ones."""
    velocity = result.velocity
    ends = max(-float(velocity[0]), 0.0), max(float(velocity[-1]), 0.0)
    wanted = [
        sign * share * end
        for sign, end in ((-1.0, ends[0]), (1.0, ends[1]))
        for share in np.linspace(1.0, 1.0 / _OVER_CLICKS, _OVER_CLICKS)
        if end > 0.0
    ]
    grid = np.linspace(result.clicks[0], result.clicks[-1], 41)
    curves = [result.at(float(place)) for place in grid]
    for k, at in enumerate(sorted(wanted)):
        line, low, high = (
            np.array([np.interp(at, curve.velocity, getattr(curve, name)) for curve in curves])
            * force
            for name in ("force", "low", "high")
        )
        colour = PALETTE[k % len(PALETTE)]
        axes.fill_between(grid, low, high, color=colour, alpha=0.2, linewidth=0.0)
        axes.plot(grid, line, color=colour, linewidth=1.2)
        axes.annotate(
            f"{number(at * speed, 2)} {unit}", (grid[-1], line[-1]), xytext=(3, 0),
            textcoords="offset points", va="center", fontsize=7, color=colour,
        )  # fmt: skip
    axes.axhline(0.0, color="0.6", linewidth=0.6)
    axes.set_xlabel("clicks")
    axes.margins(x=0.14)
