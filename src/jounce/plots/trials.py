"""All trials at a glance: where the model holds, and how its error depends on speed and obstacle pitch."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from jounce.core.errors import FitError
from jounce.plots.style import GRADES, INK, MUTED, PALETTE, VERDICTS, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.campaign.result import TrialResult
    from jounce.campaign.validation import TrialComparison

_MARKERS = "osD^vP"


def channels_of(trials: Sequence[TrialResult]) -> list[str]:
    """All channels compared in any trial, in order of appearance."""
    found: dict[str, None] = {}
    for trial in trials:
        for comparison in (trial.after, trial.before):
            if comparison is not None:
                found.update(dict.fromkeys(comparison.channels))
    return list(found)


@styled
def trial_matrix(trials: Sequence[TrialResult]) -> Figure:
    """Draw the ISO/TS 18571 rating of every trial and channel, before and after updating, as a table of colours.

    Parameters
    ----------
    trials : sequence of TrialResult
        All trials of a campaign.

    Returns
    -------
    matplotlib.figure.Figure
        One row per trial; at the right the lowest R² of its channels after updating and the verdict in words.
    """
    channels = channels_of(trials)
    figure = new_figure(1.2 + 0.27 * len(trials))
    axes = figure.subplots()
    width = len(channels)
    for row, trial in enumerate(trials):
        for group, comparison in enumerate((trial.before, trial.after)):
            for column, name in enumerate(channels):
                _draw_cell(axes, group * (width + 0.3) + column, row, comparison, name)
        verdict = trial.after.verdict if trial.after is not None else "not usable"
        if trial.after is not None:
            lowest = f"{min(channel.r2 for channel in trial.after.channels.values()):.2f}".replace("-", "−")
            axes.text(2 * width + 0.2, row, lowest, ha="center", va="center", fontsize=8.5)
        axes.text(2 * width + 0.6, row, verdict, va="center", fontsize=8.5, color=VERDICTS[verdict], weight="bold")
    _label_matrix(axes, trials, channels)
    return figure


def _draw_cell(axes: Axes, x: float, row: int, comparison: TrialComparison | None, name: str) -> None:
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
    axes.set_ylim(len(trials) - 0.4, -1.75)
    axes.set_xticks([])
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)
    axes.grid(visible=False)
    uses = {"fit": "fitted", "hold-out": "held out"}
    axes.set_yticks(range(len(trials)), [f"trial {t.entry.number}, {uses[t.entry.use]}" for t in trials])
    for label, trial in zip(axes.get_yticklabels(), trials, strict=True):
        label.set_fontweight("bold" if trial.entry.use == "fit" else "normal")
    for group, text in enumerate(("before updating", "after updating")):
        start = group * (width + 0.3)
        axes.text(start + (width - 1) / 2, -1.45, text, ha="center", va="center", weight="bold", fontsize=9)
        for column, name in enumerate(channels):
            axes.text(start + column, -0.8, name, ha="center", va="center", fontsize=8.5)
    axes.text(2 * width + 0.2, -0.8, "lowest R²", ha="center", va="center", fontsize=8.5)
    axes.text(2 * width + 0.6, -0.8, "verdict", va="center", weight="bold", fontsize=9)
    edges = ("above 0.94", "above 0.80", "above 0.58", "below")
    patches = [Patch(facecolor=c, label=f"{g} ({e})") for (g, c), e in zip(GRADES.items(), edges, strict=True)]
    axes.legend(handles=patches, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=4, columnspacing=1.2)


@styled
def residual_against_speed_and_pitch(trials: Sequence[TrialResult]) -> Figure:
    """Draw the normalised error of every trial after updating against speed and against obstacle pitch.

    Parameters
    ----------
    trials : sequence of TrialResult
        All trials of a campaign.

    Returns
    -------
    matplotlib.figure.Figure
        NRMSE against speed (m/s) and pitch (mm); filled marks are fitted trials, hollow ones held out.

    Raises
    ------
    FitError
        When no trial could be compared.
    """
    usable = [trial for trial in trials if trial.after is not None]
    if not usable:
        raise FitError("no trial could be compared", where="residuals")
    figure = new_figure(3.4)
    left, right = figure.subplots(1, 2, sharey=True, gridspec_kw={"width_ratios": [1.4, 1.0]})
    single = [trial for trial in usable if trial.entry.speed is not None and trial.obstacle_pitch is None]
    _draw_errors(left, [(float(t.entry.speed or 0.0), t) for t in single], channels_of(usable))
    trains = [(1e3 * trial.obstacle_pitch, trial) for trial in usable if trial.obstacle_pitch is not None]
    _draw_errors(right, trains, channels_of(usable))
    left.set(xlabel="speed [m/s]", ylabel="NRMSE after updating [–]", title="single obstacle")
    right.set(xlabel="pitch of the obstacles [mm]", title="trains")
    left.set_ylim(bottom=0.0)
    _number_points(left, single, [float(trial.entry.speed or 0.0) for trial in single])
    _number_points(right, [trial for _, trial in trains], [x for x, _ in trains])
    _residual_legend(figure, channels_of(usable))
    return figure


def _draw_errors(axes: Axes, points: Sequence[tuple[float, TrialResult]], channels: Sequence[str]) -> None:
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
    if not points:
        axes.text(0.5, 0.5, "no such trial", transform=axes.transAxes, ha="center", color=MUTED)


def _number_points(axes: Axes, trials: Sequence[TrialResult], places: Sequence[float]) -> None:
    """Write each trial's number beside its points where there is room; points are at ``places`` in display units."""
    low, high = axes.get_ylim()
    begin, end = axes.get_xlim()
    taken: list[tuple[float, float]] = []
    for trial, x in zip(trials, places, strict=True):
        assert trial.after is not None
        for channel in trial.after.channels.values():
            at = (260.0 * (x - begin) / (end - begin), 190.0 * (channel.nrmse - low) / (high - low))
            for offset in ((4.0, 3.0), (4.0, -9.0), (-12.0, 3.0), (-12.0, -9.0)):
                spot = (at[0] + offset[0], at[1] + offset[1])
                if all(abs(spot[0] - other[0]) > 11.0 or abs(spot[1] - other[1]) > 8.0 for other in taken):
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
            [], [], color=PALETTE[k % len(PALETTE)], marker=_MARKERS[k % len(_MARKERS)], linestyle="none", label=name
        )
        for k, name in enumerate(channels)
    ]
    handles += [
        Line2D([], [], color=INK, marker="o", linestyle="none", label="fitted"),
        Line2D([], [], color=INK, marker="o", markerfacecolor="white", linestyle="none", label="held out"),
    ]
    figure.legend(handles=handles, loc="outside upper right", ncols=len(handles), columnspacing=1.2, handletextpad=0.2)
