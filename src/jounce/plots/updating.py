"""Model updating: what the objective did, where the parameters ended, what cannot be told apart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.plots.display import digits_for, display_unit, number
from jounce.plots.style import AFTER, BEFORE, INK, MUTED, PALETTE, legend_above, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.identify.update import UpdatedParameter, UpdateResult


@styled
def update(result: UpdateResult, units: Mapping[str, str] | None = None) -> Figure:
    """Draw where the parameters of one update ended within their bounds, and how their estimates are correlated.

    Parameters
    ----------
    result : UpdateResult
        One update.
    units : mapping, optional
        SI unit of each parameter by path, for the values written beside them.

    Returns
    -------
    matplotlib.figure.Figure
        Parameters from lower (-100 %) to upper bound (+100 %) with 95 % intervals; correlation matrix
        of the parameters (lags left out).
    """
    count = len(result.parameters)
    figure = new_figure(1.15 + 0.42 * max(count, 2))
    if count == 1:
        figure.set_figwidth(5.4)
        _draw_parameters(figure.subplots(), result.parameters, units or {})
        return figure
    left, right = figure.subplots(1, 2, gridspec_kw={"width_ratios": [1.0, 0.3 + 0.11 * min(count, 8)]})
    _draw_parameters(left, result.parameters, units or {})
    _draw_correlation(right, result.correlation, count)
    return figure


def _draw_parameters(axes: Axes, parameters: Mapping[str, UpdatedParameter], units: Mapping[str, str]) -> None:
    for row, (path, p) in enumerate(parameters.items()):
        middle, half = 0.5 * (p.lower + p.upper), 0.5 * (p.upper - p.lower)
        ends = [] if p.interval is None else [100.0 * (end - middle) / half for end in p.interval]
        if ends:
            axes.plot(np.clip(ends, -108.0, 108.0), [row, row], color=AFTER, linewidth=1.6, alpha=0.6)
        colour = PALETTE[1] if p.at_bound else AFTER
        axes.plot(100.0 * (p.initial - middle) / half, row, "o", markersize=7, color="white", markeredgecolor=MUTED)
        axes.plot(100.0 * (p.value - middle) / half, row, "s" if p.at_bound else "o", markersize=6, color=colour)
        axes.text(
            1.02,
            row,
            _value_text(p, units.get(path, "1")),
            transform=axes.get_yaxis_transform(),
            va="center",
            fontsize=8.5,
            color=colour if p.at_bound else INK,
        )
    axes.axvline(-100.0, color=MUTED, linewidth=1.0)
    axes.axvline(100.0, color=MUTED, linewidth=1.0)
    axes.set_xlim(-112.0, 112.0)
    axes.set_ylim(len(parameters) - 0.4, -0.6)
    numbered = [f"{path}  {row}" if len(parameters) > 1 else path for row, path in enumerate(parameters, 1)]
    axes.set_yticks(range(len(parameters)), numbered)
    axes.set_xticks([-100, -50, 0, 50, 100])
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("place between lower and upper bound [%]")
    axes.set_title("start ○, fitted ●, at a bound ■", fontweight="normal", fontsize=9)


def _value_text(p: UpdatedParameter, si: str) -> str:
    unit = display_unit(si, p.value)
    text = number(p.value * unit.factor, digits_for(p.value, p.standard_error))
    if p.standard_error is not None:
        text += f" ± {number(p.standard_error * unit.factor, 2)}"
    return f"{text} {unit.name}".rstrip() + (" (at bound)" if p.at_bound else "")


def _draw_correlation(axes: Axes, correlation: Sequence[Sequence[float]], count: int) -> None:
    values = np.array(correlation)[:count, :count]
    axes.imshow(values, cmap="RdBu_r", vmin=-1.0, vmax=1.0, aspect="auto")
    axes.grid(visible=False)
    for row in range(len(values)):
        for column in range(len(values)):
            known = values[row, row] > 0.0 and values[column, column] > 0.0
            text = ("1" if row == column else f"{values[row, column]:+.2f}".replace("-", "−")) if known else "–"
            shade = "white" if abs(values[row, column]) > 0.6 else INK
            axes.text(column, row, text, ha="center", va="center", fontsize=8, color=shade)
    axes.set_xticks(range(count), [str(k) for k in range(1, count + 1)])
    axes.set_yticks(range(count), [str(k) for k in range(1, count + 1)])
    axes.set_xlabel("number of the parameter")
    axes.spines[:].set_visible(False)
    axes.tick_params(length=0)
    axes.set_title("correlation", fontweight="normal", fontsize=9)


def _change(percent: float) -> str:
    text = f"{percent:+.1f} %"
    return "no change" if text in ("+0.0 %", "-0.0 %") else text.replace("-", "−")


@styled
def objectives(results: Sequence[UpdateResult]) -> Figure:
    """Draw the objective of several updates before and after, each relative to its own start.

    Parameters
    ----------
    results : sequence of UpdateResult
        The updates in order.

    Returns
    -------
    matplotlib.figure.Figure
        Two bars for each update, with the objectives themselves beside them.
    """
    figure = new_figure(0.9 + 0.55 * len(results))
    axes = figure.subplots()
    for row, result in enumerate(results):
        remaining = 100.0 - result.reduction_percent
        axes.barh(row - 0.19, 100.0, 0.34, color=BEFORE, alpha=0.55, label="before" if row == 0 else None)
        axes.barh(row + 0.19, remaining, 0.34, color=AFTER, label="after" if row == 0 else None)
        axes.text(101.0, row - 0.19, number(result.objective_before), va="center", fontsize=8.5)
        text = f"{number(result.objective_after)} ({_change(-result.reduction_percent)})"
        axes.text(max(remaining, 0.0) + 1.0, row + 0.19, text, va="center", fontsize=8.5)
    axes.set_yticks(range(len(results)), [result.name for result in results])
    axes.set_ylim(len(results) - 0.45, -0.55)
    axes.set_xlim(0.0, 118.0)
    axes.set_xticks([0, 25, 50, 75, 100])
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("objective relative to its start [%]")
    legend_above(axes, 2)
    return figure
