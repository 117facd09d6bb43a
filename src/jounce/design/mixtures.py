"""What searches for fronts between competing goals share: mixtures of goals to aim at, and which designs are best."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, pairwise

import numpy as np

from jounce.core.types import Array

MOST_GOALS = 8
_LEAST = 1e-3  # smallest part of a mixture
_SAME = 1e-3  # share of a goal's range below which two designs are one


def mixtures(goals: int, points: int) -> Iterator[Array]:
    """Mixtures of goals, evenly spread over those of all (a simplex lattice), about as many as points."""
    steps = 2
    while len(list(combinations(range(steps + goals), goals - 1))) <= points:
        steps += 1
    for bars in combinations(range(steps + goals - 1), goals - 1):
        ends = (-1, *bars, steps + goals - 1)
        shares = np.array([b - a - 1 for a, b in pairwise(ends)]) / steps
        if np.count_nonzero(shares) > 1:  # the corners are known
            yield np.maximum(shares, _LEAST)


def achieved(goals: Array, best: Array, span: Array, mixture: Array) -> float:
    """How bad the relatively worst of the goals (less is better) is, seen along a mixture."""
    return float(np.max((goals - best) / (span * mixture)))


def undominated(goals: Array, span: Array) -> list[int]:
    """Rows of goals (less is better) of which none is better in every goal than another, each once.

    >>> undominated(np.array([[1.0, 3.0], [2.0, 2.0], [2.0, 4.0], [3.0, 1.0], [3.0, 1.0]]), np.array([2.0, 2.0]))
    [0, 1, 3]
    """
    kept: list[int] = []
    near = _SAME * span
    for i, one in enumerate(goals):
        worse = np.any(np.all(goals <= one + near, axis=1) & np.any(goals < one - near, axis=1))
        again = any(np.all(np.abs(goals[k] - one) <= near) for k in kept)
        if not worse and not again:
            kept.append(i)
    return kept
