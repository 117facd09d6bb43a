"""Costs along anti-diagonals and the path back through them (see ``identify.warping``)."""

from __future__ import annotations

import numpy as np

from jounce.core.types import Array
from jounce.kernel.arrays import Block, IntegerMatrix, Matrix, Vector
from jounce.kernel.loops.compiling import part

_COMPARED, _REFERENCE, _BOTH = 0, 1, 2
_STRIP = 1024  # cells of one anti-diagonal


@part(forceinline=True)
def _span(s: int, n: int, radius: int) -> tuple[int, int]:
    """Return the first and last m of anti-diagonal ``s`` inside the table and the band (k = 2 m + s % 2)."""
    odd = s % 2
    lowest = max(-radius, -s, s - 2 * (n - 1))
    highest = min(radius, s, 2 * (n - 1) - s)
    return (lowest - odd + 1) // 2, (highest - odd) // 2


@part()
def _advance(
    costs: Array, x: Array, backwards: Array, s: int, first: int, last: int, centre: int
) -> None:
    """Compute anti-diagonal ``s`` for m from ``first`` to ``last`` in place; ``costs[s % 2, m + centre]``."""
    if last < first:
        return
    n, odd, width = x.size, s % 2, last - first + 1
    i = (s + odd) // 2 + first
    j_backwards = n - 1 - (s - odd) // 2 + first
    left = x[i : i + width]
    right = backwards[j_backwards : j_backwards + width]
    own = costs[odd, first + centre : first + centre + width]
    before = costs[1 - odd, first + centre - 1 + odd : first + centre - 1 + odd + width]
    behind = costs[1 - odd, first + centre + odd : first + centre + odd + width]
    for m in range(width):
        difference = left[m] - right[m]
        least = own[m]
        least = before[m] if before[m] < least else least
        least = behind[m] if behind[m] < least else least
        own[m] = least + difference * difference


@part()
def _direction(costs: Array, s: int, m: int, centre: int) -> int:
    """Return the step that leads into cell ``m`` of anti-diagonal ``s``, before that anti-diagonal is computed."""
    odd = s % 2
    from_compared = costs[1 - odd, m + centre - 1 + odd]
    from_reference = costs[1 - odd, m + centre + odd]
    from_both = costs[odd, m + centre]
    if from_compared <= from_reference and from_compared <= from_both:
        return _COMPARED
    return _REFERENCE if from_reference <= from_both else _BOTH


@part()
def _begin(x: Array, backwards: Array, costs: Array) -> None:
    costs[:] = np.inf
    costs[0, costs.shape[1] // 2] = (x[0] - backwards[x.size - 1]) ** 2


@part()
def _advance_block(
    costs: Array,
    x: Array,
    backwards: Array,
    start: int,
    block: int,
    radius: int,
    low: int,
    high: int,
) -> None:
    """Compute ``block`` anti-diagonals for k from ``low`` to ``high``, in strips that stay in the processor's cache.

    A strip passes through all anti-diagonals of the block before the next strip begins. It moves left by one ``k`` on
    each of them, so the values that a cell needs are already computed, in its strip or the previous one, and not yet
    overwritten.
    """
    n, centre = x.size, costs.shape[1] // 2
    end = min(start + block, 2 * n - 1)
    at = low
    while at <= high + end - start:
        for s in range(start, end):
            first, last = _span(s, n, radius)
            left, odd = max(at - (s - start), low), s % 2
            right = min(at - (s - start) + 2 * _STRIP - 1, high)
            first, last = max(first, (left - odd + 1) // 2), min(last, (right - odd) // 2)
            _advance(costs, x, backwards, s, first, last, centre)
        at += 2 * _STRIP


@part()
def _cost_of(x: Array, backwards: Array, radius: int, costs: Array, block: int) -> float:
    """Compute the cost of the cheapest path in a band."""
    _begin(x, backwards, costs)
    for start in range(1, 2 * x.size - 1, block):
        _advance_block(costs, x, backwards, start, block, radius, -radius, radius)
    return float(costs[0, costs.shape[1] // 2])


@part()
def _store(
    x: Array, backwards: Array, radius: int, most: float, costs: Array, stores: Array, block: int
) -> None:
    """Store the costs just before anti-diagonals 1, 1 + block, 1 + 2 block, ..., near the cells in use.

    A cell that costs more than ``most``, the cost of a known path, is not on the cheapest path. Ends of the band that
    contain only such cells are skipped and set to infinity.
    """
    centre = costs.shape[1] // 2
    _begin(x, backwards, costs)
    low, high = 0, 0
    for stored in range(stores.shape[0]):
        while low < high and costs[low % 2, (low - low % 2) // 2 + centre] > most:
            costs[low % 2, (low - low % 2) // 2 + centre] = np.inf
            low += 1
        while high > low and costs[high % 2, (high - high % 2) // 2 + centre] > most:
            costs[high % 2, (high - high % 2) // 2 + centre] = np.inf
            high -= 1
        store = stores[stored]
        first, last = (
            max(low // 2 + centre - block, 0),
            min(high // 2 + centre + block, costs.shape[1]),
        )
        for odd in range(2):
            for m in range(first, last):
                store[odd, m] = costs[odd, m]
        low, high = max(low - block, -radius), min(high + block, radius)
        _advance_block(costs, x, backwards, 1 + stored * block, block, radius, low, high)


@part()
def path_back(
    x: Vector,
    backwards: Vector,
    radius: int,
    narrow: int,
    costs: Matrix,
    stores: Block,
    directions: IntegerMatrix,
    path: IntegerMatrix,
) -> int:
    """Fill in the pairs of samples on the path in ascending order; return the column of the first.

    If ``narrow`` is not negative, a band of this radius gives a first path, and cells that cost more are skipped.
    ``directions`` has a row for each anti-diagonal between two of ``stores``, with the cells near the path.
    """
    n, centre, block, half = (
        x.size,
        costs.shape[1] // 2,
        directions.shape[0],
        directions.shape[1] // 2,
    )
    at = 2 * n - 2
    path[0, at] = path[1, at] = n - 1
    if n > 1:
        most = _cost_of(x, backwards, narrow, costs, block) if narrow >= 0 else np.inf
        _store(x, backwards, radius, most, costs, stores, block)
    i, j = n - 1, n - 1
    for stored in range(stores.shape[0] - 1, -1, -1):
        start = 1 + stored * block
        around = (i - j) // 2
        before = stores[stored]
        for s in range(start, i + j + 1):
            first, last = _span(s, n, radius)
            first, last = max(first, around - half), min(last, around + half)
            for m in range(first, last + 1):
                directions[s - start, m - around + half] = _direction(before, s, m, centre)
            _advance(before, x, backwards, s, first, last, centre)
        while i + j >= start:
            s = i + j
            step = directions[s - start, (i - j - s % 2) // 2 - around + half]
            i -= step != _REFERENCE
            j -= step != _COMPARED
            at -= 1
            path[0, at], path[1, at] = i, j
    return at
