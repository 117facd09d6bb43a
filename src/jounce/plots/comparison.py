"""One trial: what was measured, and what the model gives before and after updating."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.errors import FitError
from jounce.core.types import Array
from jounce.plots.display import DisplayUnit, display_unit, number, words_of
from jounce.plots.style import AFTER, BEFORE, INK, MEASURED, WIDTH, new_figure, styled
from jounce.recordings.schema import QUANTITIES, quantity_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.campaign.result import TrialResult
    from jounce.campaign.validation import ChannelComparison, Signals

_LIVELY = 0.15  # of the largest excursion: what the zoom must show


@styled
def measured_against_simulated(trial: TrialResult, obstacle: tuple[float, float] | None = None) -> Figure:
    """Draw every channel of a trial: measured, before and after updating, with the residuals below.

    The left half shows the whole record, the right half the obstacle pass.

    Parameters
    ----------
    trial : TrialResult
        A trial of a campaign with its signals.
    obstacle : (float, float), optional
        First and last time at which the wheel is on the obstacle, s; shaded. The zoom always shows where the measured
        signals are lively.

    Returns
    -------
    matplotlib.figure.Figure
        Two rows (signal, residual) per channel.

    Raises
    ------
    FitError
        When the trial has no signals, because its recording could not be used.
    """
    signals = trial.signals or trial.signals_before
    if not signals:
        raise FitError("the trial has no signals to draw", where=f"trial {trial.entry.number}")
    figure = new_figure(0.35 + 2.45 * len(signals), WIDTH + 0.6)
    ratios = [2.6, 1.0] * len(signals)
    grid: Any = figure.subplots(
        2 * len(signals),
        2,
        sharex="col",
        sharey="row",
        gridspec_kw={"height_ratios": ratios, "width_ratios": [1.0, 1.0]},
    )
    window = lively_window(signals, obstacle)
    for k, name in enumerate(signals):
        _draw_channel(grid[2 * k : 2 * k + 2], name, trial)
    for column in (0, 1):
        grid[-1, column].set_xlabel("time [s]")
    time = next(iter(signals.values())).time
    grid[0, 0].set_xlim(float(time[0]), float(time[-1]))
    grid[0, 1].set_xlim(*window)
    if obstacle is not None:
        for axes in grid.flat:
            axes.axvspan(*obstacle, color="#dfe7ee", linewidth=0.0, zorder=0)
    handles, labels = grid[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=3)
    figure.align_ylabels(grid[:, 0])
    return figure


def _draw_channel(rows: Any, name: str, trial: TrialResult) -> None:
    before, after = trial.signals_before.get(name), trial.signals.get(name)
    shown = after or before
    assert shown is not None
    unit = _unit_of(name, shown)
    for axes in rows[0]:
        axes.plot(shown.time, shown.measured * unit.factor, color=MEASURED, linewidth=2.2, label="measured")
        _simulated(axes, before, unit, BEFORE, "before updating", dashed=True)
        _simulated(axes, after, unit, AFTER, "after updating", dashed=False)
    for axes in rows[1]:
        for signal, colour, width in ((before, BEFORE, 0.8), (after, AFTER, 1.0)):
            if signal is not None:
                difference = (signal.measured - signal.simulated) * unit.factor
                axes.plot(signal.time, difference, color=colour, linewidth=width)
    rows[0][0].set_title(f"trial {trial.entry.number}: {name}")
    comparison = trial.after or trial.before
    if comparison is not None and name in comparison.channels:
        rows[0][1].set_title(
            _caption(comparison.channels[name]), loc="right", fontweight="normal", fontsize=8.5, color=INK
        )
    rows[0][0].set_ylabel(f"{words_of(name)}\n[{unit.name or '–'}]")
    rows[1][0].set_ylabel(f"residual\n[{unit.name or '–'}]")


def _unit_of(name: str, signals: Signals) -> DisplayUnit:
    known = quantity_of(name)
    return display_unit(QUANTITIES[known][0] if known else "1", float(np.abs(signals.measured).max()))


def _simulated(
    axes: Axes, signals: Signals | None, unit: DisplayUnit, colour: str, label: str, *, dashed: bool
) -> None:
    if signals is None:
        return
    line = {"linestyle": (0, (4, 1.6)), "linewidth": 1.0} if dashed else {"linewidth": 1.0}
    axes.plot(signals.time, signals.simulated * unit.factor, color=colour, label=label, **line)


def _caption(channel: ChannelComparison) -> str:
    return f"ISO 18571 {channel.iso18571:.2f} ({channel.grade}), NRMSE {number(channel.nrmse, 2)}, R² {channel.r2:.2f}"


def lively_window(signals: dict[str, Signals], obstacle: tuple[float, float] | None = None) -> tuple[float, float]:
    """Choose what part of the time is worth a closer look.

    Parameters
    ----------
    signals : dict
        Channel to signals; those measured decide.
    obstacle : (float, float), optional
        Times in s that the window must contain.

    Returns
    -------
    (float, float)
        Begin and end in s, within the record.
    """
    begins, ends = [], []
    for signal in signals.values():
        away = np.abs(signal.measured - np.median(signal.measured))
        lively = np.flatnonzero(away > _LIVELY * away.max(initial=0.0))
        if len(lively):
            begins.append(float(signal.time[lively[0]]))
            ends.append(float(signal.time[lively[-1]]))
    time: Array = next(iter(signals.values())).time
    first, last = float(time[0]), float(time[-1])
    if obstacle is not None:
        begins.append(obstacle[0])
        ends.append(obstacle[1])
    if not begins:
        return first, last
    begin, end = min(begins), max(ends)
    margin = 0.06 * (end - begin)
    return max(first, begin - margin), min(last, end + margin)
