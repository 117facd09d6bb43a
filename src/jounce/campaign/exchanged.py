"""Detect records exchanged between trials: the conditions of the other trial explain each of them better."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations

from jounce.campaign.trial_result import compare_trial
from jounce.core.errors import JounceError
from jounce.core.findings import Finding, finding
from jounce.identify.fit_problem import FitTrial

_MOST = 8
"""Maximum number of trials to compare with each other's conditions, starting with the worst explained."""
_HALF = 0.5
"""Fraction of a trial's own residual below which the conditions of the other trial explain it better: wrong conditions
leave a several times larger residual, and errors of the rig affect both residuals alike."""


def better_exchanged(
    doubtful: Sequence[int], same: Callable[[int, int], bool], under: Callable[[int, int], FitTrial]
) -> list[Finding]:
    """Find pairs of trials whose records the model explains much better with their conditions exchanged.

    Parameters
    ----------
    doubtful : sequence of int
        Numbers of the trials that the model does not explain, worst first.
    same : callable
        Whether two trials have the same conditions.
    under : callable
        Returns the record of one trial under the conditions of another.
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
    """Return the largest unexplained fraction (1) of a channel's variance; infinite if the comparison fails."""
    try:
        comparison = compare_trial(trial(), None)[0]
    except JounceError:
        return float("inf")
    return max(1.0 - channel.r2 for channel in comparison.channels.values())
