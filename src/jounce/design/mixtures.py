"""Shared parts of searches for Pareto fronts: mixtures of goals to aim at, and the choice of the best designs."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from math import comb

import numpy as np

from jounce.core.types import Array

MOST_GOALS = 8  # mixtures in steps of 1/12 already take 330 of the 500 designs; more goals would be too coarse
_SAME = 1e-3  # share of a goal's range below which two designs are the same


def mixtures(goals: int, points: int) -> Iterator[Array]:
    """Yield evenly spread mixtures of goals between the corners; including corners, about as many as ``points``.

    Every goal has a share above 0: a goal with share 0 would stay at its minimum, which is a known corner.

    >>> [mixture.tolist() for mixture in mixtures(2, 5)]
    [[0.25, 0.75], [0.5, 0.5], [0.75, 0.25]]
    >>> len(list(mixtures(3, 12)))
    10
    """
    steps = goals
    while comb(steps - 1, goals - 1) + goals < points:
        steps += 1
    for bars in combinations(range(1, steps), goals - 1):
        yield np.diff((0, *bars, steps)) / steps


_NARROW = 0.03  # of the goals' ranges: gaps between designs below this are not filled
_LEAST = 1e-3  # smallest part of a mixture


def across_gap(shares: Array, known: set[tuple[int, int]]) -> Array | None:
    """Return the mixture that aims into the widest gap between neighbours on a front; None if all gaps are narrow.

    ``shares`` has the goals scaled from their minimum (0) to their maximum at a corner (1), one row per design.
    Neighbours are joined by the minimum spanning tree of all designs. Pairs in ``known`` have already been searched;
    the returned pair is added to them.

    >>> across_gap(np.array([[0.0, 1.0], [0.1, 0.7], [1.0, 0.0]]), set()).round(2).tolist()
    [0.61, 0.39]
    """
    from scipy.sparse.csgraph import minimum_spanning_tree
    from scipy.spatial.distance import cdist

    tree = minimum_spanning_tree(cdist(shares, shares)).tocoo()
    gaps = sorted(zip(tree.data, tree.row, tree.col, strict=True), reverse=True)
    for gap, i, j in gaps:
        pair = int(min(i, j)), int(max(i, j))
        if gap > _NARROW and pair not in known:
            known.add(pair)
            middle = np.maximum(0.5 * (shares[i] + shares[j]), _LEAST)
            return np.asarray(middle / middle.sum())
    return None


def achievement(goals: Array, best: Array, span: Array, mixture: Array) -> float:
    """Return the worst normalised goal (lower is better) along a mixture."""
    return float(np.max((goals - best) / (span * mixture)))


def undominated_rows(goals: Array, span: Array) -> list[int]:
    """Return the indices of rows of goals (lower is better) that no other row dominates, without duplicates.

    >>> undominated_rows(np.array([[1.0, 3.0], [2.0, 2.0], [2.0, 4.0], [3.0, 1.0], [3.0, 1.0]]), np.array([2.0, 2.0]))
    [0, 1, 3]
    """
    front: list[int] = []
    near = _SAME * span
    for i, row in enumerate(goals):
        worse = np.any(np.all(goals <= row + near, axis=1) & np.any(goals < row - near, axis=1))
        again = any(np.all(np.abs(goals[k] - row) <= near) for k in front)
        if not worse and not again:
            front.append(i)
    return front
