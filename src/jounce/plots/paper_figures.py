"""The figures of the quarter-car prototype paper, drawn from a campaign: its Figs 4, 6, 8, 9 and 10."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import DisplayUnit, display_unit
from jounce.plots.campaign import lively_window
from jounce.plots.display import quantity, words_of
from jounce.plots.figures import AFTER, BEFORE, MEASURED, PALETTE, in_style, new_figure
from jounce.recordings.schema import QUANTITIES, quantity_of
from jounce.roads import Train, read_roads

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.campaign.result import CampaignResult
    from jounce.campaign.strategy_result import StrategyResult, StrategyTrial
    from jounce.campaign.trial_result import Signals
    from jounce.identify.force_deflection import ForceDeflectionTrial
    from jounce.identify.stiffness import StiffnessResult
    from jounce.roads import Road


_FIRST_UPDATE, _LAST_UPDATE = 8, 10


def paper_figures(result: CampaignResult) -> dict[str, Figure]:
    """Draw a campaign in the form of the figures of the quarter-car prototype paper, by the paper's figure numbers.

    Parameters
    ----------
    result : CampaignResult
        A campaign; figures without measurements or updates are omitted.

    Returns
    -------
    dict of str to Figure
        ``figure-4a`` and ``figure-4b``: force (N) against deflection (mm) of the spring and of the first tyre.
        ``figure-6``: a single obstacle and a train, height against distance (mm). ``figure-8``, ``figure-9`` and
        ``figure-10``: the first three updates, each with the first trial it was fitted to; (a) sprung and (b) unsprung
        mass over time, experiment and simulation with the model before and after adjustment.
    """
    bench = result.characterisation
    figures: dict[str, Figure] = {}
    if bench.spring is not None:
        figures["figure-4a"] = force_against_deflection(
            "(a) spring", bench.loaded["bench.spring"], [bench.spring]
        )
    for name, fit in list(bench.tyre.items())[:1]:
        cubic = bench.tyre_polynomial.get(name)
        laws = [fit] if cubic is None else [fit, cubic]
        figures["figure-4b"] = force_against_deflection(
            f"(b) tyre, {name}", bench.loaded[f'bench.tyre."{name}"'], laws
        )
    roads = read_roads(result.campaign.roads, folder=result.folder)
    kinds = {isinstance(road, Train): road for road in reversed(roads.values())}
    if kinds:
        figures["figure-6"] = obstacle_profiles([kinds[kind] for kind in sorted(kinds)])
    for k, strategy in enumerate(result.strategies[: _LAST_UPDATE - _FIRST_UPDATE + 1]):
        figures[f"figure-{_FIRST_UPDATE + k}"] = adjusted_and_not(
            strategy, strategy.trial(strategy.fitted_on[0])
        )
    return figures


@in_style
def force_against_deflection(
    title: str, trials: Sequence[ForceDeflectionTrial], laws: Sequence[StiffnessResult]
) -> Figure:
    """Draw the measured points of a component and the fitted laws within their fitted range, mm and N."""
    from jounce.identify.force_deflection import seat

    figure = new_figure(3.6, 5.2)
    axes = figure.subplots()
    length, force = display_unit("m"), display_unit("N")
    reach = 0.0
    for k, trial in enumerate(trials):
        seated, _ = seat(trial, zero=laws[0].zero)
        reach = max(reach, float(seated.deflection.max()))
        label = (
            f"experiment, {len(trials)} trial{'s' if len(trials) > 1 else ''}" if k == 0 else None
        )
        axes.plot(
            length.factor * seated.deflection,
            force.factor * seated.force,
            ".",
            color=MEASURED,
            alpha=0.35,
            markersize=3.0,
            label=label,
        )
    for (colour, dashes), law in zip(
        ((AFTER, "-"), (PALETTE[1], (0, (4, 1.6)))), laws, strict=False
    ):
        low, high = law.fitted_range
        offset = law.intercept.value if law.law == "linear" and law.intercept is not None else 0.0
        x = np.linspace(low, max(high, reach), 200)
        where = f"from {length.factor * low:.3g} {length.name}" if low > 0.0 else "all deflections"
        name = f"{law.law} fit{law.of_branch}, {where}"
        name += f": {quantity(law.stiffness.value, 'N/m')}" if law.law == "linear" else ""
        axes.plot(
            length.factor * x,
            force.factor * (law.curve(x) + offset),
            color=colour,
            linewidth=1.5,
            linestyle=dashes,
            label=name,
        )
    axes.set(xlabel=length.label("deflection"), ylabel=force.label("force"), title=title)
    axes.legend(loc="upper left")
    return figure


@in_style
def obstacle_profiles(roads: Sequence[Road]) -> Figure:
    """Draw obstacles side by side: height against distance, both in mm."""
    figure = new_figure(2.3)
    grid = figure.subplots(1, len(roads), squeeze=False, sharey=True)[0]
    unit = display_unit("m")
    for letter, axes, road in zip("abcdef", grid, roads, strict=False):
        x = np.linspace(road.start - 0.03, road.end() + 0.03, 2000)
        axes.plot(unit.factor * (x - road.start), unit.factor * road.height_at(x), color=AFTER)
        what = (
            f"a series of {road.count} obstacles" if isinstance(road, Train) else "single obstacle"
        )
        axes.set(xlabel=unit.label("distance"), title=f"({letter}) {what}")
    grid[0].set_ylabel(unit.label("height"))
    return figure


@in_style
def adjusted_and_not(strategy: StrategyResult, trial: StrategyTrial) -> Figure:
    """Draw a trial before and after one update: (a) sprung mass, (b) unsprung mass and other recorded channels.

    Parameters
    ----------
    strategy : StrategyResult
        An update of a campaign.
    trial : StrategyTrial
        One of its trials.

    Returns
    -------
    matplotlib.figure.Figure
        The part of the record in which signals vary strongly, over time (s).
    """
    signals = trial.signals or trial.signals_before
    figure = new_figure(0.5 + 2.0 * len(signals))
    grid = figure.subplots(len(signals), 1, sharex=True, squeeze=False)[:, 0]
    for letter, axes, name in zip("abcdef", grid, signals, strict=False):
        _draw(axes, trial, name)
        axes.set_title(f"({letter}) trial {trial.number}, {strategy.update.name}: {name}")
    if signals:
        grid[-1].set(xlim=lively_window(signals), xlabel="time [s]")
        figure.legend(*grid[0].get_legend_handles_labels(), loc="outside upper right", ncols=3)
        figure.align_ylabels(grid)
    return figure


def _draw(axes: Axes, trial: StrategyTrial, name: str, *, labels: bool = True) -> None:
    """Draw the experiment and both simulations of a channel, with the agreement of each simulation."""
    lines = (
        (trial.signals_before, trial.before, BEFORE, "simulation, not adjusted", (0, (4, 1.6))),
        (trial.signals, trial.after, AFTER, "simulation, adjusted", "-"),
    )
    shown = (trial.signals or trial.signals_before)[name]
    unit = _unit(name, shown)
    axes.plot(
        shown.time, shown.measured * unit.factor, color=MEASURED, linewidth=2.2, label="experiment"
    )
    words = []
    for signals, comparison, colour, label, dashes in lines:
        if name in signals and comparison is not None:
            curve = signals[name]
            axes.plot(
                curve.time,
                curve.simulated * unit.factor,
                color=colour,
                linewidth=1.0,
                linestyle=dashes,
                label=label,
            )
            words.append(f"{comparison.channels[name].r2:.3f}".replace("-", "−"))
    axes.set_title(f"R² {' → '.join(words)}", loc="right", fontweight="normal", fontsize=8.5)
    if labels:
        axes.set_ylabel(f"{words_of(name)}\n[{unit.name or '–'}]")


def _unit(name: str, shown: Signals) -> DisplayUnit:
    kind = quantity_of(name)
    return display_unit(QUANTITIES[kind][0] if kind else "1", float(np.abs(shown.measured).max()))


@in_style
def update_on_every_trial(strategy: StrategyResult) -> Figure:
    """Draw all trials before and after one update: a row for each trial, a column for each channel, over time (s)."""
    trials = [trial for trial in strategy.trials if trial.signals or trial.signals_before]
    channels = list(
        dict.fromkeys(name for trial in trials for name in (trial.signals or trial.signals_before))
    )
    figure = new_figure(0.6 + 1.15 * len(trials), 8.2)
    grid = figure.subplots(len(trials), len(channels), squeeze=False)
    for row, trial in zip(grid, trials, strict=True):
        signals = trial.signals or trial.signals_before
        for axes, name in zip(row, channels, strict=True):
            if name not in signals:
                axes.set_axis_off()
                continue
            _draw(axes, trial, name, labels=False)
            unit = _unit(name, signals[name]).name or "–"
            axes.set_title(
                f"{trial.number}{', fitted' if trial.is_fitted else ''}: {name} [{unit}]",
                fontsize=8.5,
            )
            axes.set_xlim(lively_window(signals))
            axes.tick_params(labelsize=7)
    for axes in grid[-1]:
        axes.set_xlabel("time [s]")
    figure.legend(*grid[0][0].get_legend_handles_labels(), loc="outside upper right", ncols=3)
    return figure
