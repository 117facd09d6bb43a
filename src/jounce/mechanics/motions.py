"""Prescribed motions as closed-form pieces, for the tracks of a mechanism."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import AssemblyError
from jounce.core.segments import SINE, Segments, piecewise_linear


def steady(rate: float, start: float = 0.0) -> Segments:
    """Give a motion with a constant rate.

    Parameters
    ----------
    rate : float
        m/s or rad/s.
    start : float
        Value at t = 0, m or rad.

    Returns
    -------
    Segments
        Value against time in s.
    """
    return Segments(np.array([0.0, 1.0]), np.zeros(1, dtype=np.int64), np.array([[start, rate, 0.0, 0.0]]))


def harmonic(amplitude: float, frequency: float, phase: float = 0.0, mean: float = 0.0) -> Segments:
    """Give the motion ``mean + amplitude sin(2 pi frequency t + phase)``.

    Parameters
    ----------
    amplitude, mean : float
        m or rad.
    frequency : float
        Hz.
    phase : float
        rad.

    Returns
    -------
    Segments
        Value against time in s.
    """
    coefficients = np.array([[mean, amplitude, 2.0 * np.pi * frequency, phase]])
    return Segments(np.array([0.0, 1.0]), np.array([SINE], dtype=np.int64), coefficients)


def through(time: ArrayLike, value: ArrayLike, *, smooth: bool = True) -> Segments:
    """Give a motion through points: a cubic spline, or straight lines.

    Parameters
    ----------
    time : array_like, shape (n,)
        s, strictly ascending.
    value : array_like, shape (n,)
        m or rad.
    smooth : bool
        Spline (natural ends) or straight lines; lines have jumps of the rate, which a driven mass cannot follow.

    Returns
    -------
    Segments
        Value against time in s.

    Raises
    ------
    AssemblyError
        When there are fewer than two points or the times do not ascend.
    """
    t, x = np.asarray(time, dtype=float), np.asarray(value, dtype=float)
    if t.ndim != 1 or len(t) < 2 or t.shape != x.shape or np.any(np.diff(t) <= 0.0):
        raise AssemblyError("not a motion", found=f"{t.shape} times", allowed="two points or more, ascending in time")
    if not smooth:
        return piecewise_linear(t, x)
    from scipy.interpolate import CubicSpline

    pieces = CubicSpline(t, x, bc_type="natural").c[::-1].T
    return Segments(t, np.zeros(len(t) - 1, dtype=np.int64), np.ascontiguousarray(pieces))


def held(value: float) -> Segments:
    """Give a track that stays at ``value`` (m or rad)."""
    return steady(0.0, value)


__all__: Sequence[str] = ("harmonic", "held", "steady", "through")
