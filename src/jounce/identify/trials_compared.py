"""Compare the trials of an update: find trials that disagree with the others, and exchanged channels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.identify.fit_problem import Residuals, UpdateProblem
from jounce.identify.leftovers import LeftOver
from jounce.identify.signals import noise_of
from jounce.recordings.schema import channel_unit

_FEWEST = 3  # minimum number of trials to identify the wrong one
_CONTRADICTS = 0.5  # remaining share of the others' residual without a trial that is not by chance
_MATTERS = 0.01  # relative change of a value below which it is not reported
_EXPLAINS = 0.5  # share of a trial's residual with the values of the others
_MORE, _LITTLE = (
    9.0,
    1e-3,
)  # times the mean square that others leave; of the signal's: 3 % of its size
_SWAPPED = 0.5  # by which the correlations of two exchanged channels are larger, in sum


def disagreeing(
    problem: UpdateProblem, residuals: Residuals, scaled: Array, free: NDArray[np.bool_]
) -> list[Finding]:
    """Report the trial without which the others agree much better, and its effect on the values.

    ``residuals`` are those at the optimum ``scaled``; ``free`` marks the unknowns inside their bounds.
    """
    rows, jacobian = residuals.groups, residuals.jacobian[:, free]
    if len(rows) < _FEWEST or not free.any():
        return []
    grams = [jacobian[part].T @ jacobian[part] for part in rows]
    pulls = [jacobian[part].T @ residuals.vector[part] for part in rows]
    squares = [float(residuals.vector[part] @ residuals.vector[part]) for part in rows]
    gram, pull, square = sum(grams), sum(pulls), sum(squares)
    steps = [
        -np.linalg.pinv(gram - own_gram, hermitian=True) @ (pull - own)
        for own_gram, own in zip(grams, pulls, strict=True)
    ]
    gains = [
        -float(step @ (pull - own)) / max(square - left, 1e-300)
        for step, own, left in zip(steps, pulls, squares, strict=True)
    ]
    worst = int(np.argmax(gains))
    half = np.array([item.half_range for item in problem.free])
    values, known = problem.values(scaled), np.flatnonzero(free[: len(half)])
    moved = {
        problem.free[i].path: steps[worst][k] * half[i] / (values[i] or half[i])
        for k, i in enumerate(known)
    }
    if gains[worst] < _CONTRADICTS or not moved or max(map(abs, moved.values())) < _MATTERS:
        return []
    shifts = ", ".join(
        f"{path} {100.0 * share:+.2g} %" for path, share in moved.items() if abs(share) > _MATTERS
    )
    findings = [
        finding(
            "identify.trial_disagrees",
            problem.trials[worst].source.name,
            gains[worst],
            share=1.0 - gains[worst],
            shifts=shifts,
        )
    ]
    left = residuals.vector[rows[worst]] + jacobian[rows[worst]] @ steps[worst]
    own = jacobian[rows[worst]][:, : len(known)]
    pulled, lengths = own.T @ left, np.maximum((own**2).sum(axis=0), 1e-300)
    shares = pulled**2 / lengths / max(float(left @ left), 1e-300)
    best = int(np.argmax(shares))
    if shares[best] > _EXPLAINS:
        i = known[best]
        change = 100.0 * float(-pulled[best] / lengths[best] * half[i] / (values[i] or half[i]))
        share = 100.0 * float(shares[best])
        findings.append(
            finding(
                "identify.trial_differs_by",
                problem.trials[worst].source.name,
                change,
                path=problem.free[i].path,
                change=change,
                share=share,
            )
        )
    return findings


def unlike(left: Mapping[str, Sequence[LeftOver]]) -> list[Finding]:
    """Report trials with much larger residuals, apart from noise, than the others in the updated model."""
    shares = dict[str, list[float]]()
    for parts in left.values():
        for part in parts:
            size = float(np.mean((part.measured - part.measured.mean()) ** 2))
            rest = max(float(np.mean(part.rest**2)) - noise_of(part.measured) ** 2, 0.0)
            shares.setdefault(part.trial, []).append(rest / max(size, 1e-300))
    if len(shares) < _FEWEST:
        return []
    mean = {trial: float(np.mean(some)) for trial, some in shares.items()}
    trial = max(mean, key=lambda name: mean[name])
    others = float(np.median([share for name, share in mean.items() if name != trial]))
    if mean[trial] < max(_MORE * others, _LITTLE):
        return []
    return [finding("identify.trial_unlike", trial, mean[trial], share=mean[trial], others=others)]


def exchanged_channels(left: Mapping[str, Sequence[LeftOver]]) -> list[Finding]:
    """Report pairs of channels with equal units whose records match each other's readings better than their own."""
    findings = []
    for first, other in combinations(left, 2):
        if channel_unit(first) != channel_unit(other):
            continue
        pairs = {part.trial: part for part in left[other]}
        trials = [
            part.trial
            for part in left[first]
            if part.trial in pairs and _look_swapped(part, pairs[part.trial])
        ]
        if trials:
            findings.append(
                finding("identify.channels_exchanged", first, other=other, trials=", ".join(trials))
            )
    return findings


def _look_swapped(first: LeftOver, other: LeftOver) -> bool:
    if len(first.measured) != len(other.measured):
        return False
    straight = _alike(first.measured, first.read) + _alike(other.measured, other.read)
    return (
        _alike(first.measured, other.read) + _alike(other.measured, first.read)
        > straight + _SWAPPED
    )


def _alike(first: Array, other: Array) -> float:
    first, other = first - first.mean(), other - other.mean()
    size = float(np.linalg.norm(first) * np.linalg.norm(other))
    return float(first @ other) / size if size > 0.0 else 0.0
