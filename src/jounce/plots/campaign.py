"""Trials of a campaign: measured and simulated signals of one trial, and an overview of all trials."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import DisplayUnit, display_unit, display_unit_for
from jounce.core.errors import FitError
from jounce.core.types import Array
from jounce.plots.display import number, words_of
from jounce.plots.figures import (
    AFTER,
    BEFORE,
    GRADES,
    INK,
    MEASURED,
    MUTED,
    PALETTE,
    VERDICTS,
    WIDTH,
    in_lines,
    in_style,
    new_figure,
)
from jounce.recordings.schema import QUANTITIES, quantity_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.campaign.trial_result import Signals, TrialComparison, TrialResult


_LIVELY = 0.15  # of the largest excursion: larger ones must be in the zoom


@in_style
def measured_against_simulated(
    trial: TrialResult, obstacle: tuple[float, float] | None = None
) -> Figure:
    """Draw every channel of a trial: measured, before and after updating, with the residuals below.

    The left half shows the whole record, the right half the obstacle pass.

    Parameters
    ----------
    trial : TrialResult
        A trial of a campaign with its signals.
    obstacle : (float, float), optional
        First and last time at which the wheel is on the obstacle, s; shaded. The zoom always includes the times at
        which the measured signals vary strongly.

    Returns
    -------
    matplotlib.figure.Figure
        Two rows (signal, residual) per channel.

    Raises
    ------
    FitError
        If the trial has no signals, because its recording could not be used.
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
    known = quantity_of(name)
    unit = display_unit(QUANTITIES[known][0] if known else "1", float(np.abs(shown.measured).max()))
    for axes in rows[0]:
        axes.plot(
            shown.time,
            shown.measured * unit.factor,
            color=MEASURED,
            linewidth=2.2,
            label="measured",
        )
        _draw_simulated(axes, before, unit, BEFORE, "before updating", dashed=True)
        _draw_simulated(axes, after, unit, AFTER, "after updating", dashed=False)
    for axes in rows[1]:
        for signal, colour, width in ((before, BEFORE, 0.8), (after, AFTER, 1.0)):
            if signal is not None:
                difference = (signal.measured - signal.simulated) * unit.factor
                axes.plot(signal.time, difference, color=colour, linewidth=width)
    rows[0][0].set_title(f"trial {trial.entry.number}: {name}")
    comparison = trial.after or trial.before
    if comparison is not None and name in comparison.channels:
        agreement = comparison.channels[name]
        rating = f"ISO 18571 {agreement.iso18571:.2f} ({agreement.grade})"
        rating += f", NRMSE {number(agreement.nrmse, 2)}, R² {agreement.r2:.2f}"
        rows[0][1].set_title(rating, loc="right", fontweight="normal", fontsize=8.5, color=INK)
    rows[0][0].set_ylabel(f"{words_of(name)}\n[{unit.name or '–'}]")
    rows[1][0].set_ylabel(f"residual\n[{unit.name or '–'}]")


def _draw_simulated(
    axes: Axes, signals: Signals | None, unit: DisplayUnit, colour: str, label: str, *, dashed: bool
) -> None:
    if signals is None:
        return
    line = {"linestyle": (0, (4, 1.6)), "linewidth": 1.0} if dashed else {"linewidth": 1.0}
    axes.plot(signals.time, signals.simulated * unit.factor, color=colour, label=label, **line)


def lively_window(
    signals: dict[str, Signals], obstacle: tuple[float, float] | None = None
) -> tuple[float, float]:
    """Choose the time range (s) of the zoom: the times at which measured signals vary strongly, and the obstacle."""
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


_MARKERS = "osD^vP"


def channels_of(trials: Sequence[TrialResult]) -> list[str]:
    """Return all channels compared in any trial, in order of appearance."""
    names: dict[str, None] = {}
    for trial in trials:
        for comparison in (trial.after, trial.before):
            if comparison is not None:
                names.update(dict.fromkeys(comparison.channels))
    return list(names)


@in_style
def trial_matrix(trials: Sequence[TrialResult]) -> Figure:
    """Draw the ISO/TS 18571 rating of every trial and channel, before and after updating, as a table of colours.

    Parameters
    ----------
    trials : sequence of TrialResult
        All trials of a campaign.

    Returns
    -------
    matplotlib.figure.Figure
        One row per trial; on the right, the lowest R² of its channels after updating and the verdict in words.
    """
    channels = channels_of(trials)
    figure = new_figure(1.3 + 0.27 * len(trials))
    axes = figure.subplots()
    width = len(channels)
    for row, trial in enumerate(trials):
        for group, comparison in enumerate((trial.before, trial.after)):
            for column, name in enumerate(channels):
                _draw_cell(axes, group * (width + 0.3) + column, row, comparison, name)
        verdict = trial.after.verdict if trial.after is not None else "not usable"
        if trial.after is not None:
            lowest = f"{min(channel.r2 for channel in trial.after.channels.values()):.2f}".replace(
                "-", "−"
            )
            axes.text(2 * width + 0.2, row, lowest, ha="center", va="center", fontsize=8.5)
        axes.text(
            2 * width + 0.6,
            row,
            verdict,
            va="center",
            fontsize=8.5,
            color=VERDICTS[verdict],
            weight="bold",
        )
    _label_matrix(axes, trials, channels)
    return figure


def _draw_cell(
    axes: Axes, x: float, row: int, comparison: TrialComparison | None, name: str
) -> None:
    from matplotlib.patches import Rectangle

    channel = comparison.channels.get(name) if comparison is not None else None
    fill = GRADES[channel.grade] if channel is not None else "#eceef0"
    axes.add_patch(Rectangle((x - 0.49, row - 0.45), 0.98, 0.9, facecolor=fill, linewidth=0.0))
    text = f"{channel.iso18571:.2f}" if channel is not None else "–"
    dark = channel is not None and channel.grade == "excellent"
    axes.text(x, row, text, ha="center", va="center", fontsize=8.5, color="white" if dark else INK)


def _label_matrix(axes: Axes, trials: Sequence[TrialResult], channels: list[str]) -> None:
    from matplotlib.patches import Patch

    width = max(len(channels), 1)
    axes.set_xlim(-0.6, 2 * width + 1.6)
    axes.set_ylim(len(trials) - 0.4, -2.1)
    axes.set_xticks([])
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)
    axes.grid(visible=False)
    uses = {"fit": "fitted", "hold-out": "held out"}
    axes.set_yticks(
        range(len(trials)), [f"trial {t.entry.number}, {uses[t.entry.use]}" for t in trials]
    )
    for label, trial in zip(axes.get_yticklabels(), trials, strict=True):
        label.set_fontweight("bold" if trial.entry.use == "fit" else "normal")
    inches = float(axes.get_figure().get_size_inches()[0])  # type: ignore[union-attr]
    most = int(
        (inches - 1.2) / (2 * width + 2.2) / 0.078
    )  # characters above a column that keep names from overlapping
    for group, text in enumerate(("before updating", "after updating")):
        start = group * (width + 0.3)
        axes.text(
            start + (width - 1) / 2, -1.8, text, ha="center", va="center", weight="bold", fontsize=9
        )
        for column, name in enumerate(channels):
            axes.text(
                start + column, -0.95, in_lines(name, most), ha="center", va="center", fontsize=8.5
            )
    axes.text(2 * width + 0.2, -0.95, "lowest R²", ha="center", va="center", fontsize=8.5)
    axes.text(2 * width + 0.6, -0.95, "verdict", va="center", weight="bold", fontsize=9)
    edges = ("above 0.94", "above 0.80", "above 0.58", "below")
    patches = [
        Patch(facecolor=c, label=f"{g} ({e})")
        for (g, c), e in zip(GRADES.items(), edges, strict=True)
    ]
    axes.legend(
        handles=patches, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4, columnspacing=1.2
    )


@in_style
def residual_against_speed_and_pitch(trials: Sequence[TrialResult]) -> Figure:
    """Draw the normalised error of every trial after updating against speed and against obstacle pitch.

    Parameters
    ----------
    trials : sequence of TrialResult
        All trials of a campaign.

    Returns
    -------
    matplotlib.figure.Figure
        NRMSE of trials over one obstacle against speed (m/s), and of trials over trains against pitch (mm); filled
        marks are fitted trials, hollow ones held out. If there is only one kind of trial, it takes the whole width.

    Raises
    ------
    FitError
        If no trial could be compared, or none of those compared has a speed or a pitch.
    """
    usable = [trial for trial in trials if trial.after is not None]
    if not usable:
        raise FitError("no trial could be compared", where="residuals")
    speed, pitch = display_unit_for("m/s", "speed"), display_unit("m")
    singles = [
        (speed.factor * trial.entry.speed, trial)
        for trial in usable
        if trial.entry.speed is not None and trial.obstacle_pitch is None
    ]
    trains = [
        (pitch.factor * trial.obstacle_pitch, trial)
        for trial in usable
        if trial.obstacle_pitch is not None
    ]
    panels = [
        (1.4, singles, {"xlabel": speed.label("speed"), "title": "single obstacle"}),
        (1.0, trains, {"xlabel": pitch.label("pitch of the obstacles"), "title": "trains"}),
    ]
    panels = [panel for panel in panels if panel[1]]
    if not panels:
        raise FitError(
            "none of the compared trials has a speed or an obstacle pitch", where="residuals"
        )
    figure = new_figure(3.4)
    widths = {"width_ratios": [width for width, _, _ in panels]}
    all_axes = figure.subplots(1, len(panels), sharey=True, squeeze=False, gridspec_kw=widths)[0]
    for axes, (_, points, words) in zip(all_axes, panels, strict=True):
        _draw_errors(axes, points, channels_of(usable))
        axes.set(**words)
    all_axes[0].set(ylabel="NRMSE after updating [–]")
    all_axes[0].set_ylim(bottom=0.0)
    for axes, (_, points, _) in zip(all_axes, panels, strict=True):
        _number_points(axes, [trial for _, trial in points], [x for x, _ in points])
    _residual_legend(figure, channels_of(usable))
    return figure


def _draw_errors(
    axes: Axes, points: Sequence[tuple[float, TrialResult]], channels: Sequence[str]
) -> None:
    """Draw the error of each trial and channel over ``x`` in display units."""
    for k, name in enumerate(channels):
        for x, trial in points:
            assert trial.after is not None
            if name in trial.after.channels:
                colour = PALETTE[k % len(PALETTE)]
                axes.plot(
                    x,
                    trial.after.channels[name].nrmse,
                    marker=_MARKERS[k % len(_MARKERS)],
                    color=colour,
                    linestyle="none",
                    markerfacecolor=colour if trial.entry.use == "fit" else "white",
                    markersize=5.5,
                )
    axes.margins(x=0.1, y=0.12)


def _number_points(axes: Axes, trials: Sequence[TrialResult], places: Sequence[float]) -> None:
    """Write each trial's number next to its points if there is room; points are at ``places`` in display units."""
    low, high = axes.get_ylim()
    begin, end = axes.get_xlim()
    taken: list[tuple[float, float]] = []
    for trial, x in zip(trials, places, strict=True):
        assert trial.after is not None
        for channel in trial.after.channels.values():
            at = (260.0 * (x - begin) / (end - begin), 190.0 * (channel.nrmse - low) / (high - low))
            for offset in ((4.0, 3.0), (4.0, -9.0), (-12.0, 3.0), (-12.0, -9.0)):
                spot = (at[0] + offset[0], at[1] + offset[1])
                if all(
                    abs(spot[0] - other[0]) > 11.0 or abs(spot[1] - other[1]) > 8.0
                    for other in taken
                ):
                    axes.annotate(
                        str(trial.entry.number),
                        (x, channel.nrmse),
                        offset,
                        textcoords="offset points",
                        fontsize=7,
                        color=MUTED,
                    )
                    taken.append(spot)
                    break


def _residual_legend(figure: Figure, channels: Sequence[str]) -> None:
    from matplotlib.lines import Line2D

    handles = [
        Line2D(
            [],
            [],
            color=PALETTE[k % len(PALETTE)],
            marker=_MARKERS[k % len(_MARKERS)],
            linestyle="none",
            label=name,
        )
        for k, name in enumerate(channels)
    ]
    handles += [
        Line2D([], [], color=INK, marker="o", linestyle="none", label="fitted"),
        Line2D(
            [],
            [],
            color=INK,
            marker="o",
            markerfacecolor="white",
            linestyle="none",
            label="held out",
        ),
    ]
    figure.legend(
        handles=handles,
        loc="outside upper right",
        ncols=len(handles),
        columnspacing=1.2,
        handletextpad=0.2,
    )
