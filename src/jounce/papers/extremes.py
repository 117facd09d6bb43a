"""Least and greatest values of a signal within a window of time, between the samples too."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import jounce as jn
from jounce.papers import Array


@dataclass(frozen=True)
class Window:
    """Extremes of a signal within a closed window of time.

    Attributes
    ----------
    start, end : float
        Of the window, s.
    min, max : float
        Least and greatest value, in the signal's SI unit.
    t_min, t_max : float
        When they occur first, s.
    """

    start: float
    end: float
    min: float
    t_min: float
    max: float
    t_max: float


def extremes_within(time: Array, value: Array, rate: Array, start: float, end: float) -> Window:
    """Find the extremes of a signal of which samples and their time derivatives are known.

    Between samples the signal is the cubic that has both: exact to the fourth power of the sample distance.

    Parameters
    ----------
    time : ndarray, shape (n,)
        s, ascending.
    value, rate : ndarray, shape (n,)
        Signal in its SI unit, and its derivative in that per second; the derivative has no jumps.
    start, end : float
        Closed window within the samples, s.

    Returns
    -------
    Window
        Its ends count.

    Raises
    ------
    RecordingError
        For a window that is empty or reaches beyond the samples.

    Examples
    --------
    >>> t = np.linspace(0.0, 1.0, 51)
    >>> found = extremes_within(t, np.sin(6.0 * t), 6.0 * np.cos(6.0 * t), 0.0, 1.0)
    >>> round(found.max, 5), round(found.t_max, 5), round(found.min, 5)
    (1.0, 0.2618, -1.0)
    """
    slack = 1e-9 * max(1.0, abs(end))
    if not (start < end and time[0] - slack <= start and end <= time[-1] + slack):
        raise jn.RecordingError(
            "no such window", found=f"{start:g} to {end:g} s", allowed=f"within {time[0]:g} to {time[-1]:g} s"
        )
    ends = np.array([start, end])
    at = np.concatenate([ends, _turning_points(time, value, rate)])
    at = np.sort(at[(at >= start) & (at <= end)])
    values = between(time, value, rate, at)
    low, high = int(np.argmin(values)), int(np.argmax(values))
    return Window(start, end, float(values[low]), float(at[low]), float(values[high]), float(at[high]))


def between(time: Array, value: Array, rate: Array, at: Array) -> Array:
    """Values at the times ``at`` (s) of a signal known by samples and their derivatives (SI), shape of ``at``."""
    i = np.clip(np.searchsorted(time, at, side="right") - 1, 0, len(time) - 2)
    width = time[i + 1] - time[i]
    s = (at - time[i]) / width
    rest = 1.0 - s
    ends = value[i] * (1.0 + 2.0 * s) * rest**2 + value[i + 1] * (3.0 - 2.0 * s) * s**2
    return np.asarray(ends + width * s * rest * (rate[i] * rest - rate[i + 1] * s))


def _turning_points(time: Array, value: Array, rate: Array) -> Array:
    """Times (s) at which the cubics between samples are level."""
    width = np.diff(time)
    mean = np.diff(value) / width
    left, right = rate[:-1], rate[1:]
    # derivative over the share s of the interval: left + 2 b s + c s^2
    b, c = 3.0 * mean - 2.0 * left - right, 3.0 * (left + right - 2.0 * mean)
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(b**2 - c * left)
        far = -(b + np.copysign(root, b))
        shares = np.concatenate([far / c, left / far])  # without cancellation
    places = np.tile(np.arange(len(width)), 2)
    inside = (shares >= 0.0) & (shares <= 1.0)
    return np.asarray(time[places[inside]] + shares[inside] * width[places[inside]])
