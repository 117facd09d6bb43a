"""Thin long curves: points that no screen or printer could resolve are dropped, peaks are kept."""

from __future__ import annotations

import numpy as np

from jounce.core.types import Array


def thin(x: Array, y: Array, low: float, high: float, columns: int) -> tuple[Array, Array]:
    """Drop points that a screen with ``columns`` columns cannot resolve; keep the minimum and maximum of each column.

    Parameters
    ----------
    x, y : array (n,)
        A line in any unit, x ascending.
    low, high : float
        Limits of the displayed range of x, same unit.
    columns : int
        Number of columns.

    Returns
    -------
    x, y : array (m,)
        At most four points per column: first, lowest, highest, last.

    Examples
    --------
    >>> x = np.linspace(0.0, 1.0, 10_000)
    >>> y = np.where(x == x[5_000], 7.0, np.sin(x))
    >>> few, seen = thin(x, y, 0.0, 1.0, 100)
    >>> len(few) <= 400, float(seen.max())
    (True, 7.0)
    """
    if len(x) <= 4 * columns or not high > low:
        return x, y
    column = np.clip(((x - low) * (columns / (high - low))).astype(np.int32), -1, columns)
    starts = np.flatnonzero(np.diff(column, prepend=column[0] - 1))
    counts = np.diff(np.append(starts, len(x)))
    parts = [starts, starts + counts - 1]
    for extreme in (np.fmin, np.fmax):
        at = np.flatnonzero(y == np.repeat(extreme.reduceat(y, starts), counts))
        parts.append(at[np.flatnonzero(np.diff(column[at], prepend=np.int32(-2)))])
    index = np.unique(np.concatenate(parts))
    return x[index], y[index]
