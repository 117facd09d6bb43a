"""Turns of the plate that belong to the run-down, among all that a record shows."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array

_ONE_TURN, _BESIDE, _BACK = 0.25, 0.15, 1.02
_FEWEST_TURNS = 5


def run_down(frequency: Array, time: Array) -> NDArray[np.bool_]:
    """Find the turns of the run-down (or run-up): whole ones, from the highest frequency on, each slower than the last.

    Parameters
    ----------
    frequency : ndarray, shape (n,)
        Of each turn, Hz.
    time : ndarray, shape (n,)
        Its middle, s.

    Returns
    -------
    ndarray of bool, shape (n,)
        Which turns belong to it; none where there are too few.

    Examples
    --------
    >>> frequency = np.concatenate([np.full(3, 2.0), np.linspace(10.0, 6.0, 21)])  # it swings before the motor starts
    >>> run_down(frequency, np.cumsum(1.0 / frequency)).tolist() == [False] * 3 + [True] * 21
    True
    """
    whole = np.flatnonzero(_whole_turns(frequency, time))
    found = np.zeros(frequency.size, dtype=bool)
    if whole.size < _FEWEST_TURNS:
        return found
    first, second = np.array_split(frequency[whole], 2)
    ordered = whole if float(np.mean(first)) >= float(np.mean(second)) else whole[::-1]
    usual = _medians(frequency[ordered])
    kept = ordered[np.abs(frequency[ordered] / usual - 1.0) < _BESIDE]
    kept = kept[int(np.argmax(frequency[kept])) :]
    slowest = np.minimum.accumulate(frequency[kept])
    found[kept[frequency[kept] <= _BACK * slowest]] = True
    return found


def _whole_turns(frequency: Array, time: Array) -> NDArray[np.bool_]:
    """Turns (n,) at one over their frequency from the one before or after: others are swings of another kind."""
    whole = np.abs(frequency[:-1] * np.diff(time) - 1.0) < _ONE_TURN
    before, after = np.append(False, whole), np.append(whole, False)
    return np.asarray(before | after)


def _medians(values: Array) -> Array:
    """Median of each of (n,) values and the two on either side of it."""
    rows = np.lib.stride_tricks.sliding_window_view(np.pad(values, 2, mode="edge"), 5)
    return np.asarray(np.median(rows, axis=1))
