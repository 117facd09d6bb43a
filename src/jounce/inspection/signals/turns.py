"""Turns of the exciter read from a plate's height: when it is at the top, and how fast it turns."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from jounce.core.types import Array

_HYSTERESIS = 0.3
FEWEST_TURNS = 8


@dataclass(frozen=True)
class Turns:
    """Turns of a plate that moves up and down.

    Attributes
    ----------
    crossing : ndarray, shape (n,)
        Times (s) at which the plate passes its middle, upwards and downwards in turn, upwards first.
    top : ndarray, shape (m,)
        Times (s) at which it is highest.
    frequency : ndarray, shape (m,)
        Frequency (Hz) at these times.
    angle : callable
        Angle (rad) at times (s): 0 at the first upward crossing, tops at pi / 2 and every 2 pi on.
    """

    crossing: Array
    top: Array
    frequency: Array
    angle: Any

    def frequency_at(self, time: Array) -> Array:
        """Frequency in Hz at times in s."""
        return np.asarray(self.angle(time, 1) / (2.0 * np.pi))


def middle_crossings(time: Array, height: Array, middle: float, amplitude: float) -> tuple[Array, bool]:
    """Find when a signal passes its middle, and whether the first time is upwards.

    Parameters
    ----------
    time, height : ndarray, shape (n,)
        s and m.
    middle, amplitude : float
        Of the signal, m; excursions under 0.3 of the amplitude do not count.

    Returns
    -------
    times : ndarray, shape (k,)
        s.
    upwards : bool
        Whether the first one is.
    """
    away = height - middle
    far = np.flatnonzero(np.abs(away) > _HYSTERESIS * amplitude)
    if far.size < 2:
        return np.empty(0), True
    side = away[far] > 0.0
    turn = np.flatnonzero(side[1:] != side[:-1])
    changes = np.flatnonzero((away[1:] > 0.0) != (away[:-1] > 0.0))
    first = changes[np.searchsorted(changes, far[turn])]
    last = changes[np.searchsorted(changes, far[turn + 1]) - 1]
    step = time[1] - time[0]
    times = [time[i] + step * away[i] / (away[i] - away[i + 1]) for i in (first, last)]
    return 0.5 * (times[0] + times[1]), bool(turn.size) and not bool(side[turn[0]])


def find_turns(time: Array, height: Array, middle: float, amplitude: float) -> Turns | None:
    """Read the turns of an eccentric exciter from the height of its plate.

    Parameters
    ----------
    time, height : ndarray, shape (n,)
        Uniform time (s) and height (m).
    middle, amplitude : float
        Of the height, m.

    Returns
    -------
    Turns or None
        None where the plate makes fewer than 8 turns.
    """
    from scipy.interpolate import CubicSpline

    crossing, upwards = middle_crossings(time, height, middle, amplitude)
    crossing = crossing if upwards else crossing[1:]
    if crossing.size < 2 * FEWEST_TURNS:
        return None
    turn = np.pi * np.arange(crossing.size)
    when = CubicSpline(turn, crossing)
    tops = np.arange(0.5 * np.pi, turn[-1], 2.0 * np.pi)
    half = 0.5 / (crossing[1::2] - crossing[: 2 * (crossing.size // 2) : 2])
    slope = when(tops, 1)
    smooth = 1.0 / (2.0 * np.pi * np.where(slope > 0.0, slope, np.inf))
    frequency = np.where(
        np.abs(smooth / half - 1.0) < 0.3, smooth, half
    )  # the spline swings where a plate comes to rest
    return Turns(crossing, when(tops), frequency, CubicSpline(crossing, turn))
