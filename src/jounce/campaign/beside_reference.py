"""Comparison of a campaign's results with published ones: verdicts and their interpretation."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from jounce.campaign.reference import Reference, ReferenceUpdate
from jounce.campaign.strategy_result import StrategyResult
from jounce.campaign.trial_result import TrialResult
from jounce.core.shown import Shown
from jounce.core.units import to_si
from jounce.parts.rig import unit_of

Verdict = Literal["reproduced", "not reproduced", "not comparable"]
REDUCTION_APART = 0.10
"""Difference up to which a reduction counts as reproduced. It depends on the start values: starts within 10 % of the
optimum change it by 10 percentage points (strategies of the shipped virtual bench)."""
REPRESENTED = 0.95
"""Minimum R2 of a represented channel: the bound of the verdict `holds`."""


@dataclass(frozen=True)
class ReferenceComparison(Shown):
    """A published statement compared with our result.

    Attributes
    ----------
    what : str
        Subject of the statement.
    published, ours : str
        Published value and our value, as text with units.
    verdict : {"reproduced", "not reproduced", "not comparable"}
        Whether our result agrees.
    follows : str
        Interpretation of the verdict.
    """

    what: str
    published: str
    ours: str
    verdict: Verdict
    follows: str


def beside_reference(
    reference: Reference | None, strategies: Sequence[StrategyResult], trials: Sequence[TrialResult]
) -> list[ReferenceComparison]:
    """Compare a campaign's results with the published results in its table ``[reference]``; empty without one."""
    if reference is None:
        return []
    rows: list[ReferenceComparison] = []
    for published in reference.update:
        strategy = next((item for item in strategies if item.update.name == published.update), None)
        if strategy is None:
            rows.append(
                ReferenceComparison(
                    published.update,
                    "",
                    "not run",
                    "not comparable",
                    "The update failed or was not chosen.",
                )
            )
        else:
            rows += _of_update(published, strategy)
    if reference.best_speeds:
        rows.append(_of_speeds(reference.best_speeds, trials))
    return rows


def _of_update(
    published: ReferenceUpdate, strategy: StrategyResult
) -> Iterator[ReferenceComparison]:
    name, update = published.update, strategy.update
    if published.reduction is not None:
        ours = update.reduction_percent / 100.0
        agrees = abs(ours - published.reduction) <= REDUCTION_APART
        follows = (
            "The update explains as much here as there."
            if agrees
            else "It counts from each one's own start: ours lay "
            + (
                "farther from the optimum."
                if ours > published.reduction
                else "nearer to it, or the model lacks more."
            )
        )
        yield _comparison(
            f"{name}: reduction", _percent(published.reduction), _percent(ours), agrees, follows
        )
    if published.iterations is not None:
        agrees = (
            update.iterations <= 2 * published.iterations
            and published.iterations <= 2 * update.iterations
        )
        follows = (
            "Iterations depend on method, start and stopping rule; they say nothing of the model."
        )
        yield _comparison(
            f"{name}: iterations",
            str(published.iterations),
            str(update.iterations),
            agrees,
            follows,
        )
    if published.represents is not None:
        seen = _represented_channels(strategy)
        agrees = seen == set(published.represents)
        follows = f"A channel counts as represented with R² of {REPRESENTED:g} or more on the trials of the update."
        yield _comparison(
            f"{name}: represents",
            _join_names(published.represents),
            _join_names(seen),
            agrees,
            follows,
        )
    for path, given in published.parameters.items():
        parameter = update.parameters.get(path)
        unit = (
            unit_of(strategy.knowledge.rig, path)
            if path in strategy.knowledge.rig.parameters()
            else "1"
        )
        value = to_si(given, unit, where=f"reference.update.parameters: {path}")
        if parameter is None:
            yield ReferenceComparison(
                f"{name}: {path}",
                f"{value:.4g} {unit}",
                "–",
                "not comparable",
                "It was not free here.",
            )
            continue
        low, high = _interval(strategy, path)
        agrees = low <= value <= high
        follows = (
            ""
            if agrees
            else "Another part, another law, or an error of one of both: compare the component tests."
        )
        yield _comparison(
            f"{name}: {path}",
            f"{value:.4g} {unit}",
            f"{low:.4g} to {high:.4g} {unit}",
            agrees,
            follows,
        )


def _comparison(
    what: str, published: str, ours: str, agrees: bool, follows: str
) -> ReferenceComparison:
    return ReferenceComparison(
        what, published, ours, "reproduced" if agrees else "not reproduced", follows
    )


def _interval(strategy: StrategyResult, path: str) -> tuple[float, float]:
    discrepancy = strategy.update.discrepancy
    if discrepancy is not None and path in discrepancy.parameters:
        return discrepancy.parameters[path].interval
    parameter = strategy.update.parameters[path]
    return parameter.interval or (parameter.value, parameter.value)


def _represented_channels(strategy: StrategyResult) -> set[str]:
    """Return the channels with a high R2 in all fitted trials of the update."""
    fitted = [
        trial.after for trial in strategy.trials if trial.is_fitted and trial.after is not None
    ]
    channels = set.intersection(*(set(after.channels) for after in fitted)) if fitted else set()
    return {
        name for name in channels if all(after.channels[name].r2 >= REPRESENTED for after in fitted)
    }


def _of_speeds(published: tuple[float, ...], trials: Sequence[TrialResult]) -> ReferenceComparison:
    """Compare the best predicted single-obstacle trials with the published speeds."""
    usable = [trial for trial in trials if trial.after is not None and trial.obstacle_pitch is None]
    usable = [trial for trial in usable if trial.entry.speed is not None]
    ranked = sorted(usable, key=_worst)
    best = sorted({round(trial.entry.speed or 0.0, 2) for trial in ranked[: len(published)]})
    near = [
        speed for speed in published if any(abs(speed - other) <= _SPEEDS_APART for other in best)
    ]
    said = ", ".join(f"{speed:.2f} m/s" for speed in published)
    ours = ", ".join(f"{speed:.2f} m/s" for speed in best) or "–"
    if not best:
        return ReferenceComparison(
            "best speeds", said, ours, "not comparable", "No trial of a single obstacle was usable."
        )
    follows = "By the largest NRMSE of a channel, over the trials of a single obstacle."
    return _comparison("best speeds", said, ours, len(near) == len(published), follows)


_SPEEDS_APART = 0.1  # m/s: spread of repeated settings of the published bench


def _worst(trial: TrialResult) -> float:
    assert trial.after is not None
    return max(channel.nrmse for channel in trial.after.channels.values())


def _percent(share: float) -> str:
    return f"{100.0 * share:.1f} %"


def _join_names(names: Any) -> str:
    return ", ".join(sorted(names)) or "none"
