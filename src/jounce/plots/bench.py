"""Springs and tyres on the test machine: points, fitted law, what each trial says by itself."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.identify.force_deflection import ForceDeflectionTrial, renamed, seat
from jounce.plots.display import display_unit, number, quantity
from jounce.plots.style import AFTER, INK, MEASURED, MUTED, PALETTE, legend_above, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.identify.force_deflection import Zero
    from jounce.identify.stiffness import PressureStiffness, StiffnessResult

_MM = display_unit("m")


@styled
def stiffness_fit(result: StiffnessResult, trials: Sequence[ForceDeflectionTrial] = (), title: str = "") -> Figure:
    """Draw a fitted force law over the measured points, and the stiffness of each trial by itself.

    Parameters
    ----------
    result : StiffnessResult
        What was fitted.
    trials : sequence of ForceDeflectionTrial, optional
        The trials it was fitted to; with them the measured points are drawn as the fit saw them.
    title : str
        What was measured, e.g. ``"spring"``.

    Returns
    -------
    matplotlib.figure.Figure
        Force against deflection (mm, N), and the stiffness of each trial with its 95 % interval (N/mm).

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> x = np.linspace(0.0, 0.015, 31)
    >>> trials = [ForceDeflectionTrial(x, k * x, f"spring {k}") for k in (22700.0, 22760.0)]
    >>> [axes.get_xlabel() for axes in stiffness_fit(jn.fit_stiffness(trials), trials).axes]
    ['deflection [mm]', 'stiffness [N/mm]']
    """
    figure = new_figure(3.7)
    left, right = figure.subplots(1, 2, gridspec_kw={"width_ratios": [1.5, 1.0]})
    reach = _draw_points(left, trials, result.zero) or result.fitted_range[1]
    _draw_law(left, result, reach)
    left.set(xlabel="deflection [mm]", ylabel="force [N]", title=title)
    _draw_trials(right, result)
    figure.legend(*left.get_legend_handles_labels(), loc="outside lower left", ncols=3, columnspacing=1.4)
    return figure


def _draw_points(axes: Axes, trials: Sequence[ForceDeflectionTrial], zero: Zero) -> float:
    """Draw all points from where the fit counts them; give the largest deflection in m."""
    reach = 0.0
    for k, trial in enumerate(renamed(list(trials))):
        seated, _ = seat(trial, zero=zero)
        label = ("measured" if len(trials) == 1 else f"measured, {len(trials)} trials") if k == 0 else None
        axes.plot(
            seated.deflection * _MM.factor,
            seated.force,
            color=MEASURED,
            alpha=0.75,
            linewidth=0.6,
            marker=".",
            markersize=3.0,
            markeredgewidth=0.0,
            label=label,
        )
        reach = max(reach, float(seated.deflection.max()))
    return reach


def _draw_law(axes: Axes, result: StiffnessResult, reach: float) -> None:
    low, high = result.fitted_range
    inside, whole = np.linspace(low, high, 200), np.linspace(0.0, max(high, reach), 200)
    dropped = 0.0  # force that the fit has and the law for the model has not
    if result.law == "linear" and result.intercept_choice == "drop" and result.intercept is not None:
        dropped = result.intercept.value
    axes.plot(
        inside * _MM.factor, result.curve(inside) + dropped, color=AFTER, linewidth=1.8, label=f"fit, {result.law}"
    )
    label = "for the model, without intercept" if dropped else "beyond the fitted range"
    axes.plot(whole * _MM.factor, result.curve(whole), color=AFTER, linewidth=1.0, linestyle=(0, (4, 2)), label=label)
    if low > 0.02 * high:
        axes.axvspan(0.0, low * _MM.factor, color="#e4e8eb", linewidth=0.0, zorder=0, label="not fitted")
    if result.operating_deflection is not None:
        at = result.operating_deflection * _MM.factor
        axes.axvline(at, color=PALETTE[1], linewidth=1.2, linestyle=(0, (1, 1.5)), label="static operating point")


def _draw_trials(axes: Axes, result: StiffnessResult) -> None:
    unit = display_unit("N/m")
    pooled = result.stiffness
    if pooled.interval is not None:
        axes.axvspan(*(end * unit.factor for end in pooled.interval), color=AFTER, alpha=0.15, linewidth=0.0)
    axes.axvline(pooled.value * unit.factor, color=AFTER, linewidth=1.4)
    for row, trial in enumerate(result.trials):
        value, interval = trial.stiffness.value * unit.factor, trial.stiffness.interval
        if interval is not None:
            axes.plot([end * unit.factor for end in interval], [row, row], color=MUTED, linewidth=1.2)
        axes.plot(value, row, "o", color=MEASURED, markersize=4.5)
    axes.set_yticks(range(len(result.trials)), [_short(trial.name) for trial in result.trials])
    axes.set_ylim(len(result.trials) - 0.4, -0.6)
    axes.grid(axis="y", visible=False)
    axes.set(xlabel=unit.label("stiffness"))
    axes.locator_params(axis="x", nbins=5)
    axes.set_title(f"all: {quantity(pooled.value, 'N/m')} (band: 95 %)", fontweight="normal", fontsize=9)


def _short(name: str) -> str:
    bare = name.rpartition("/")[2].removesuffix(".csv")
    return bare if len(bare) <= 18 else f"…{bare[-17:]}"


@styled
def tyre_pressure(result: PressureStiffness) -> Figure:
    """Draw tyre stiffness against inflation pressure.

    Parameters
    ----------
    result : PressureStiffness
        Stiffness at each measured pressure.

    Returns
    -------
    matplotlib.figure.Figure
        Stiffness (N/mm) with 95 % intervals against pressure (MPa), joined as values between are interpolated.
    """
    figure = new_figure(2.9, 4.6)
    axes = figure.subplots()
    stiffness, pressure = display_unit("N/m"), display_unit("Pa")
    x = [value * pressure.factor for value in result.pressures]
    y = [one.value * stiffness.factor for one in result.stiffnesses]
    axes.plot(x, y, color=AFTER, label="interpolated")
    for place, one in zip(x, result.stiffnesses, strict=True):
        if one.interval is not None:
            axes.plot([place, place], [end * stiffness.factor for end in one.interval], color=MUTED, linewidth=1.4)
    axes.plot(x, y, "o", color=MEASURED, markersize=5, label="fitted, with 95 % interval")
    axes.set(xlabel=pressure.label("inflation pressure"), ylabel=stiffness.label("tyre stiffness"))
    axes.margins(x=0.12, y=0.2)
    if result.exponent is not None:
        text = f"proportional to pressure to the power {number(result.exponent, 2)}"
        axes.text(0.98, 0.05, text, transform=axes.transAxes, ha="right", color=INK, fontsize=8.5)
    legend_above(axes, 2)
    return figure
