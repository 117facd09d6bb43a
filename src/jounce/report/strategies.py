"""Updates section of a campaign report: how well each update explains body and wheel motion in all trials."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.campaign.trial_result import CLOSE, LOOSE
from jounce.plots.display import number, percent
from jounce.report.page import Block, Cell, Details, PageTable, Paragraph, Subsection, Tone

if TYPE_CHECKING:
    from collections.abc import Callable

    from jounce.campaign.result import CampaignResult
    from jounce.campaign.strategy_result import StrategyTrial
    from jounce.campaign.trial_result import ChannelComparison


_METRICS: tuple[tuple[str, str, Callable[[ChannelComparison], float]], ...] = (
    ("R²", "R² of every trial before and after each update", lambda channel: channel.r2),
    ("NRMSE", "NRMSE of every trial before and after each update", lambda channel: channel.nrmse),
    (
        "ISO 18571",
        "ISO/TS 18571 rating of every trial before and after each update",
        lambda channel: channel.iso18571,
    ),
)


def progress(result: CampaignResult) -> Subsection:
    """Return all updates on all trials: contributions to the objective, and ratings of each channel."""
    blocks: list[Block] = [
        Paragraph(
            "Each update is compared with every trial, before and after: those it was fitted on (marked •) and "
            "all others. Before: the model that the update started from."
        ),
        _parts(result),
    ]
    tables = [_metric(result, label, caption, value) for label, caption, value in _METRICS]
    blocks += [
        tables[0],
        Details("The same as NRMSE and as ISO/TS 18571 rating", tuple(tables[1:])),
    ]
    return Subsection("Every update on every trial", tuple(blocks))


def _parts(result: CampaignResult) -> PageTable:
    rows: list[tuple[Cell | str, ...]] = []
    for strategy in result.strategies:
        split = strategy.objective_by_channel()
        before, after = (sum(pair[k] for pair in split.values()) for k in (0, 1))
        for k, (name, pair) in enumerate(split.items()):
            r2 = [
                trial.after.channels[name].r2
                for trial in strategy.trials
                if trial.is_fitted and trial.after is not None and name in trial.after.channels
            ]
            explained = Cell(f"{min(r2):.3f}".replace("-", "−"), _tone(min(r2)))
            shares = (
                percent(pair[0] / before) if before else "–",
                percent(pair[1] / after) if after else "–",
            )
            rows.append(
                (
                    strategy.update.name if k == 0 else "",
                    name,
                    number(pair[0]),
                    shares[0],
                    number(pair[1]),
                    shares[1],
                    percent(pair[1] / pair[0] - 1.0) if pair[0] else "–",
                    explained,
                )
            )
    header = ("update", "channel", "before", "share", "after", "share", "change", "lowest R² after")
    note = (
        "Sums of squared differences over the trials fitted on, in the squared SI unit of the channel, without "
        "weights (Eq. 2 of the quarter-car prototype paper). A channel counts as represented with R² above 0.95."
    )
    return PageTable("The objective split into its channels", header, tuple(rows), "llrrrrrr", note)


def _tone(r2: float) -> Tone:
    return "good" if r2 > CLOSE else "fair" if r2 > LOOSE else "bad"


def _metric(
    result: CampaignResult, label: str, caption: str, value: Callable[[ChannelComparison], float]
) -> PageTable:
    rows: list[tuple[Cell | str, ...]] = []
    for trial in result.trials:
        if trial.after is None and trial.before is None:
            continue
        fitted = [strategy.trial(trial.entry.number) for strategy in result.strategies]
        channels = dict.fromkeys(
            name for trial_result in fitted for name in _channels(trial_result)
        )
        for k, name in enumerate(channels):
            cells = tuple(
                _cell(trial_result, name, value, colour=label == "R²") for trial_result in fitted
            )
            rows.append((str(trial.entry.number) if k == 0 else "", name, *cells))
    header = ("trial", "channel", *(strategy.update.name for strategy in result.strategies))
    return PageTable(caption, header, tuple(rows), "ll" + "r" * len(result.strategies))


def _channels(trial: StrategyTrial) -> list[str]:
    known = trial.after or trial.before
    return [] if known is None else list(known.channels)


def _cell(
    trial: StrategyTrial, name: str, value: Callable[[ChannelComparison], float], *, colour: bool
) -> Cell | str:
    texts = [
        "–"
        if fit is None or name not in fit.channels
        else f"{value(fit.channels[name]):.3f}".replace("-", "−")
        for fit in (trial.before, trial.after)
    ]
    text = " → ".join(texts) + (" •" if trial.is_fitted else "")
    if not colour or trial.after is None or name not in trial.after.channels:
        return text
    return Cell(text, _tone(value(trial.after.channels[name])))
