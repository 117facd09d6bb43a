"""Figures of damper maps: force over velocity for each setting, and over clicks at given velocities."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.numbers import number
from jounce.dampers.adjusters import is_clicks, words_of
from jounce.plots.figures import PALETTE, in_style, legend_above, new_figure

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.core.types import Array
    from jounce.dampers.compared import ComparedForce, DamperComparison
    from jounce.dampers.curves import DamperSetting
    from jounce.dampers.map import DamperMap
    from jounce.dampers.sheet import DamperSheet
    from jounce.design.clicks import ChosenClicks

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
    _cross(row[0])
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
    return settings_in_words(item.settings) or (
        item.files[0] if len(item.files) == 1 else f"{len(item.files)} records"
    )


def settings_in_words(settings: Mapping[str, float]) -> str:
    """Write clicks, temperature and gas pressure (SI) in usual units; empty without any.

    >>> settings_in_words({"bump_clicks": 8.0, "rebound_clicks": 4.0, "gas_pressure": 1e6})
    'bump 8, rebound 4, 10 bar'
    """
    words = []
    for name, value in settings.items():
        if name == "clicks":
            words.append(f"{value:g} clicks")
        elif is_clicks(name):
            words.append(f"{words_of(name).removesuffix(' clicks')} {value:g}")
    if "temperature" in settings:
        words.append(f"{settings['temperature'] - 273.15:.3g} °C")
    if "gas_pressure" in settings:
        words.append(f"{settings['gas_pressure'] / 1e5:.3g} bar")
    return ", ".join(words)


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


@in_style
def damper_set(sheet: DamperSheet, title: str = "") -> Figure:
    r"""Draw the forces of all dampers of a sheet over velocity: a colour for each damper, a line for each setting.

    Parameters
    ----------
    sheet : DamperSheet
        Result of :func:`jounce.damper_sheet`.
    title : str
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        Force without gas over velocity.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import jounce as jn
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "left.csv"
    >>> _ = file.write_text("velocity,force\n-0.3,-450\n-0.1,-150\n0.1,80\n0.3,240\n")
    >>> len(jn.plots.figure_of(jn.damper_sheet([file])).axes[0].lines)
    3
    """
    settings = [item for damper in sheet.dampers for item in damper.map.settings]
    force = display_unit("N", max(float(np.abs(item.force).max()) for item in settings))
    speed = display_unit("m/s", max(float(np.abs(item.velocity).max()) for item in settings))
    figure = new_figure(3.8)
    axes = figure.subplots()
    for k, damper in enumerate(sheet.dampers):
        for i, item in enumerate(damper.map.settings):
            axes.plot(
                item.velocity * speed.factor, item.force * force.factor, _DASHES[k % len(_DASHES)],
                color=PALETTE[k % len(PALETTE)], linewidth=1.2, label=damper.name if i == 0 else None,
            )  # fmt: skip
    _cross(axes)
    axes.set(xlabel=speed.label("velocity, bump positive"), ylabel=force.label("force without gas"))
    axes.set_title(title)
    legend_above(axes, 4)
    return figure


@in_style
def damper_comparison(result: DamperComparison, title: str = "") -> Figure:
    r"""Draw the difference of two dampers over velocity with its interval, in the band of the tolerance.

    Parameters
    ----------
    result : DamperComparison
        Result of :func:`jounce.compare_dampers`.
    title : str
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        Forces of both over velocity, and second minus first as a share of the tolerance.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import jounce as jn
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "left.csv"
    >>> _ = file.write_text("velocity,force\n-0.3,-450\n-0.1,-150\n0.1,80\n0.3,240\n")
    >>> jn.plots.figure_of(jn.compare_dampers(file, file)).axes[1].get_ylabel()
    'difference, of the tolerance [%]'
    """
    groups: dict[str, list[ComparedForce]] = {}
    for item in result.forces:
        groups.setdefault(settings_in_words(item.clicks), []).append(item)
    force = display_unit("N", max(abs(item.first) for item in result.forces))
    speed = display_unit("m/s", max(abs(item.velocity) for item in result.forces))
    first, second = result.names
    figure = new_figure(3.8)
    left, right = figure.subplots(1, 2)
    right.axhspan(-100.0, 100.0, color="0.5", alpha=0.15, linewidth=0.0)
    reach = speed.factor * max(abs(item.velocity) for item in result.forces)
    for g, (words, own) in enumerate(groups.items()):
        colour = PALETTE[g % len(PALETTE)]
        x = np.array([item.velocity for item in own]) * speed.factor
        for name, style in (("first", "-"), ("second", "--")):
            y = np.array([getattr(item, name) for item in own]) * force.factor
            left.plot(x, y, style, color=colour, linewidth=1.2)
        tolerance = np.array([item.tolerance or np.nan for item in own]) / 100.0
        ends = np.array([item.difference.interval or (np.nan, np.nan) for item in own])
        half = np.nan_to_num(0.5 * (ends[:, 1] - ends[:, 0]) / tolerance)
        aside = 0.012 * reach * (g - 0.5 * (len(groups) - 1))
        right.errorbar(
            x + aside, np.array([item.difference.value for item in own]) / tolerance, half, fmt="o",
            color=colour, markersize=3.0, linewidth=1.0, label=words or f"{second} minus {first}",
        )  # fmt: skip
    for axes in (left, right):
        _cross(axes)
        axes.set_xlabel(speed.label("velocity, bump positive"))
    left.set_ylabel(force.label("force without gas"))
    left.set_title(title or f"{first} (solid), {second} (dashed)")
    right.set_ylabel("difference, of the tolerance [%]")
    legend_above(right, 3)
    return figure


@in_style
def chosen_clicks(result: ChosenClicks, title: str = "") -> Figure:
    r"""Draw the target of a damper and its best clicks over velocity, and what is left over.

    Parameters
    ----------
    result : ChosenClicks
        Result of :func:`jounce.choose_clicks`.
    title : str
        Title of the figure.

    Returns
    -------
    matplotlib.figure.Figure
        Forces, or damping ratios if these are compared; and the residual of the best combinations.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import jounce as jn
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "sheet.csv"
    >>> rows = "".join(f"\n{c},{v},{v * (900 - 50 * c)}" for c in (0, 8) for v in (-0.3, -0.1, 0.1, 0.3))
    >>> _ = file.write_text("clicks,velocity,force" + rows)
    >>> figure = jn.plots.figure_of(jn.choose_clicks(file, {"coefficient": 700.0}))
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['force [N]', 'left over [N]']
    """
    speed = display_unit("m/s", float(np.abs(result.velocity).max()))
    x = result.velocity * speed.factor
    wheel = result.wheel if result.compared == "ratio" else None
    unit = display_unit("N" if wheel is None else "1", float(np.abs(result.target).max()))

    def shown(values: Array) -> Array:
        if wheel is not None:
            return wheel.ratio(result.velocity, values)
        return np.asarray(values * unit.factor)

    figure = new_figure(3.8)
    left, right = figure.subplots(1, 2)
    best = result.best
    sides = [side for side in (x < 0.0, x > 0.0) if side.any()]
    for i, side in enumerate(sides):  # through rest a ratio has no value
        for k, choice in enumerate(result.choices[:_SHOWN]):
            colour = PALETTE[k % len(PALETTE)]
            label = settings_in_words(choice.clicks) if i == 0 else None
            rest = shown(choice.force - result.target)
            right.plot(
                x[side], rest[side], "o-", color=colour, markersize=2.5, linewidth=1.0, label=label
            )
            if k == 0:
                left.plot(
                    x[side],
                    shown(choice.force)[side],
                    "o-",
                    color=colour,
                    markersize=2.5,
                    label=label,
                )
        for axes, of in ((left, 0.0), (right, result.target)):
            low, high = shown(best.low - of), shown(best.high - of)
            axes.fill_between(
                x[side], low[side], high[side], color=PALETTE[0], alpha=0.2, linewidth=0.0
            )
        left.plot(
            x[side], shown(result.target)[side], "--", color="0.25", label="target" if i == 0 else None
        )  # fmt: skip
    for axes in (left, right):
        _cross(axes)
        axes.set_xlabel(speed.label("velocity, bump positive"))
    left.set_ylabel("damping ratio at the wheel" if wheel is not None else unit.label("force"))
    right.set_ylabel("left over" if wheel is not None else unit.label("left over"))
    left.set_title(title or "target and best")
    legend_above(left, 2)
    legend_above(right, 2)
    return figure


_DASHES = ("-", "--", "-.", ":")
_SHOWN = 3  # combinations whose residual is drawn


def _cross(axes: Axes) -> None:
    axes.axhline(0.0, color="0.6", linewidth=0.6)
    axes.axvline(0.0, color="0.6", linewidth=0.6)
