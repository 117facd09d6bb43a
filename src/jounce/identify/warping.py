"""Dynamic time warping of two signals on a narrow band, in little memory.

Cells (i, j) of the cost table are computed along anti-diagonals ``s = i + j``, on which they are independent. With
``k = i - j``, cells of an even ``s`` are stored at ``k = 2 m`` in one array, those of an odd ``s`` at ``k = 2 m + 1``
in a second one; the two arrays are overwritten in place. Every ``block`` anti-diagonals they are saved, and the path is
traced back block by block from these copies, near the path only. This needs little memory, whereas the full table would
need gigabytes. A narrower band first gives an upper bound of the cost; cells at the ends of the band with a higher cost
are skipped. The same search with thinned signals takes a hundredth of the time and predicts whether skipping pays off.
"""

from __future__ import annotations

import contextlib
import math
import mmap

import numpy as np
from numpy.typing import NDArray

from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.kernel.call import Loop

Indices = NDArray[np.int64]
_BLOCK, _SHORT = (
    128,
    20_000,
)  # from four times as many samples on, fewer stores, as allocating memory takes time as well
_WIDE = 512  # a band from which a narrower one may save time
_NARROW = 16  # ratio of the band to the narrow one that gives a first path
_THIN = 16  # thinning factor of the trial
_USED = 0.85  # used share of the thinned band above which skipping does not pay off
_path, _path_here = Loop("warping"), Loop("warping", here=True)


def warping_path(
    compared: Array, reference: Array, radius: int, *, narrow: int | None = None
) -> tuple[Indices, Indices]:
    """Find the cheapest alignment of two signals of the same length: pairs of samples from (0, 0) to (n - 1, n - 1).

    The path minimises the sum of squared differences over the pairs. Among equal paths the one that advances
    ``compared`` alone is preferred, then the one that advances ``reference`` alone. Only pairs with
    ``|i - j| <= radius`` are allowed (Sakoe-Chiba). ``narrow`` is the radius of a band that is searched first
    (negative: none), by default a sixteenth if that saves time; it affects the run time only.

    >>> i, j = warping_path(np.array([0.0, 0.0, 1.0, 2.0]), np.array([0.0, 1.0, 2.0, 2.0]), 2)
    >>> list(zip(i.tolist(), j.tolist(), strict=True))
    [(0, 0), (1, 0), (2, 1), (3, 2), (3, 3)]
    """
    x = np.ascontiguousarray(compared, dtype=np.float64)
    backwards = np.ascontiguousarray(np.asarray(reference, dtype=np.float64)[::-1])
    if x.shape != backwards.shape or x.ndim != 1 or x.size == 0:
        raise ValueError(
            Phrase(
                "two signals of the same length are required, but the shapes are {shape} and {second_shape}",
                shape=x.shape,
                second_shape=backwards.shape,
            )
        )
    band = max(int(radius), 0)
    if narrow is None:
        narrow = band // _NARROW if band > _WIDE and _pays(x, backwards, band) else -1
    path, _ = _follow(
        x, backwards, band, min(narrow, band), _BLOCK * max(math.isqrt(x.size // _SHORT), 1)
    )
    return path[0].copy(), path[1].copy()


def _follow(
    x: Array, backwards: Array, band: int, narrow: int, block: int, unused: float | None = None
) -> tuple[Indices, Array]:
    """Return the path, one column per pair, and the stored costs; ``unused`` marks cells that were skipped."""
    n = x.size
    path = np.empty((2, 2 * n - 1), dtype=np.int64)
    width = 2 * (band // 2 + 2) + 1
    costs, stores = (
        np.empty((2, width)),
        _fresh(((2 * n - 3) // block + 1 if n > 1 else 0, 2, width)),
    )
    if unused is not None:
        stores.fill(unused)
    directions = np.empty((block, 2 * (block // 2 + 2) + 1), dtype=np.int64)
    loop = (
        _path if n < _SHORT else _path_here
    )  # compiling for this processor pays off for long signals
    first = loop(x, backwards, band, narrow, costs, stores, directions, path)
    return path[:, first:], stores


def _fresh(shape: tuple[int, int, int]) -> Array:
    """Allocate memory that is filled once (half a gigabyte for long signals), in pages of the usual size if possible.

    NumPy requests huge pages from Linux; finding and clearing them may take longer than computing their content.
    """
    with contextlib.suppress(AttributeError, OSError, ValueError):  # Windows; no memory; no size
        pages = mmap.mmap(-1, 8 * math.prod(shape), flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
        return np.frombuffer(pages).reshape(shape)
    return np.empty(shape)


def _pays(x: Array, backwards: Array, band: int) -> bool:
    """Whether a path from a narrower band would save time, judged by the share of the band that thinned signals use."""
    spare = x.size % _THIN
    first, second = x[: x.size - spare], backwards[spare:]
    thin = [
        np.ascontiguousarray(signal.reshape(-1, _THIN).mean(axis=1)) for signal in (first, second)
    ]
    small = band // _THIN
    _, stores = _follow(thin[0], thin[1], small, small // _NARROW, 2 * _BLOCK // _THIN, np.nan)
    return bool(np.isfinite(stores).mean() < _USED)
