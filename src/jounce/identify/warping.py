"""Dynamic time warping of two signals on a narrow band, in little memory.

Cells (i, j) of the cost table are computed along anti-diagonals ``s = i + j``, where they do not depend on each other.
With ``k = i - j``, cells of an even ``s`` live at ``k = 2 m`` in one array and cells of an odd ``s`` at ``k = 2 m + 1``
in another; both are overwritten in place. Every ``_BLOCK`` anti-diagonals they are stored, and the path back is found
block by block from these stores, near the path only: memory is a few megabytes where the table would be gigabytes.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.kernel.call import kept

Indices = NDArray[np.int64]
_BLOCK = 256
_COMPARED, _REFERENCE, _BOTH = 0, 1, 2


def warping_path(compared: Array, reference: Array, radius: int) -> tuple[Indices, Indices]:
    """Find the cheapest alignment of two signals of the same length: pairs of samples from (0, 0) to (n - 1, n - 1).

    The sum of squared differences over the pairs is least; among equal paths the one that advances ``compared`` alone
    wins, then the one that advances ``reference`` alone. Only pairs with ``|i - j| <= radius`` are allowed
    (Sakoe-Chiba).

    >>> i, j = warping_path(np.array([0.0, 0.0, 1.0, 2.0]), np.array([0.0, 1.0, 2.0, 2.0]), 2)
    >>> list(zip(i.tolist(), j.tolist(), strict=True))
    [(0, 0), (1, 0), (2, 1), (3, 2), (3, 3)]
    """
    x = np.ascontiguousarray(compared, dtype=np.float64)
    backwards = np.ascontiguousarray(np.asarray(reference, dtype=np.float64)[::-1])
    if x.shape != backwards.shape or x.ndim != 1 or x.size == 0:
        raise ValueError(f"two signals of the same length are needed, got shapes {x.shape} and {backwards.shape}")
    path: tuple[Indices, Indices] = _path(x, backwards, max(int(radius), 0))
    return path


@kept(inline="always")
def _span(s: int, n: int, radius: int) -> tuple[int, int]:
    """First and last m of anti-diagonal ``s`` inside the table and the band (k = 2 m + s % 2)."""
    odd = s % 2
    lowest = max(-radius, -s, s - 2 * (n - 1))
    highest = min(radius, s, 2 * (n - 1) - s)
    return (lowest - odd + 1) // 2, (highest - odd) // 2


@kept()
def _advance(costs: Array, x: Array, backwards: Array, s: int, first: int, last: int, centre: int) -> None:
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


@kept()
def _direction(costs: Array, s: int, m: int, centre: int) -> int:
    """Which step leads into cell ``m`` of anti-diagonal ``s``, before that anti-diagonal is computed."""
    odd = s % 2
    from_compared = costs[1 - odd, m + centre - 1 + odd]
    from_reference = costs[1 - odd, m + centre + odd]
    from_both = costs[odd, m + centre]
    if from_compared <= from_reference and from_compared <= from_both:
        return _COMPARED
    return _REFERENCE if from_reference <= from_both else _BOTH


@kept()
def _stores(x: Array, backwards: Array, radius: int, centre: int) -> NDArray[np.float64]:
    """Costs just before anti-diagonals 1, 1 + block, 1 + 2 block, ...; shape (blocks, 2, width)."""
    n = x.size
    costs = np.full((2, 2 * centre + 1), np.inf)
    costs[0, centre] = (x[0] - backwards[n - 1]) ** 2
    stores = np.empty(((2 * n - 3) // _BLOCK + 1, 2, 2 * centre + 1))
    for s in range(1, 2 * n - 1):
        if (s - 1) % _BLOCK == 0:
            stores[(s - 1) // _BLOCK] = costs
        first, last = _span(s, n, radius)
        _advance(costs, x, backwards, s, first, last, centre)
    return stores


@kept()
def _path(x: Array, backwards: Array, radius: int) -> tuple[Indices, Indices]:
    n = x.size
    path = np.empty((2, 2 * n - 1), dtype=np.int64)
    at = 2 * n - 2
    path[:, at] = n - 1
    centre = radius // 2 + 2
    stores = _stores(x, backwards, radius, centre) if n > 1 else np.empty((0, 2, 1))
    half = _BLOCK // 2 + 2
    directions = np.empty((_BLOCK, 2 * half + 1), dtype=np.int8)
    i, j = n - 1, n - 1
    for block in range(stores.shape[0] - 1, -1, -1):
        start = 1 + block * _BLOCK
        around = (i - j) // 2
        costs = stores[block]
        for s in range(start, i + j + 1):
            first, last = _span(s, n, radius)
            first, last = max(first, around - half), min(last, around + half)
            for m in range(first, last + 1):
                directions[s - start, m - around + half] = _direction(costs, s, m, centre)
            _advance(costs, x, backwards, s, first, last, centre)
        while i + j >= start:
            s = i + j
            step = directions[s - start, (i - j - s % 2) // 2 - around + half]
            i -= step != _REFERENCE
            j -= step != _COMPARED
            at -= 1
            path[0, at], path[1, at] = i, j
    return path[0, at:].copy(), path[1, at:].copy()
