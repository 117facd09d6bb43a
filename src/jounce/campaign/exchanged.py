"""Detect records exchanged between trials: the conditions of the other trial explain each of them better."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations

from jounce.campaign.trial_result import compare_trial
from jounce.core.errors import JounceError
from jounce.core.findings import Finding, finding
from jounce.identify.fit_problem import FitTrial

_MOST = 8
"""Trials that are held against each other's conditions: those that the model explains worst."""
_HALF = 0.5
"""Share of what is left under a trial's own conditions, below which those of the other trial explain it better: other
conditions leave several times as much, and other values of the rig change both alike."""


def better_exchanged(
    doubtful: Sequence[int], same: Callable[[int, int], bool], under: Callable[[int, int], FitTrial]
) -> list[Finding]:
    """Name pairs of trials whose records the model explains much better with their conditions exchanged.

    Parameters
    ----------
    doubtful : sequence of int
        Numbers of the trials that the model does not explain, the worst first.
    same : callable
        Whether two trials have the same conditions.
    under : callable
        Gives the record of one trial under the conditions of another.
    """
    left: dict[tuple[int, int], float] = {}

    def residual_of(record: int, conditions: int) -> float:
        key = (record, conditions)
        if key not in left:
            left[key] = _largest_residual(lambda: under(record, conditions))
        return left[key]

    findings = []
    for first, second in combinations(sorted(doubtful[:_MOST]), 2):
        if same(first, second):
            continue
        pairs = ((first, second), (second, first))
        if all(residual_of(own, other) < _HALF * residual_of(own, own) for own, other in pairs):
            numbers = {
                name: 1.0 - residual_of(*pair)
                for name, pair in zip(("first", "second"), pairs, strict=True)
            }
            place = f"trials {first} and {second}"
            findings.append(
                finding("campaign.better_exchanged", place, numbers["first"], **numbers)
            )
    return findings


def _largest_residual(trial: Callable[[], FitTrial]) -> float:
    """Largest share (1) of a channel's variance that the model leaves; infinite where it cannot be compared."""
    try:
        comparison = compare_trial(trial(), None)[0]
    except JounceError:
        return float("inf")
    return max(1.0 - channel.r2 for channel in comparison.channels.values())
