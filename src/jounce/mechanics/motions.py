"""Prescribed motions as closed-form pieces, for the tracks of a mechanism."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import AssemblyError, DescriptionError
from jounce.core.samples import as_samples
from jounce.core.segments import SINE, Segments, piecewise_linear
from jounce.core.units import as_number


def constant_rate(rate: float, start: float = 0.0) -> Segments:
    """Return a motion with a constant rate.

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
    pieces = np.array([[_value(start), _value(rate, "/s"), 0.0, 0.0]])
    return Segments(np.array([0.0, 1.0]), np.zeros(1, dtype=np.int64), pieces)


def _value(value: object, per: str = "") -> float:
    """Convert a number of a motion to m, or to rad if it has an angle unit; or the same ``per`` time."""
    try:
        return as_number(value, f"m{per}", where="motion")
    except DescriptionError:
        return as_number(value, f"rad{per}", where="motion")


def harmonic(amplitude: float, frequency: float, phase: float = 0.0, mean: float = 0.0) -> Segments:
    """Return the motion ``mean + amplitude sin(2 pi frequency t + phase)``.

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
    mean, amplitude, phase = _value(mean), _value(amplitude), as_number(phase, "rad", where="phase")
    frequency = as_number(frequency, "Hz", where="frequency")
    coefficients = np.array([[mean, amplitude, 2.0 * np.pi * frequency, phase]])
    return Segments(np.array([0.0, 1.0]), np.array([SINE], dtype=np.int64), coefficients)


def step(start: float, end: float, begin: float, stop: float) -> Segments:
    """Return the motion from one value to another by a cubic with zero end slopes; at rest before and after.

    Parameters
    ----------
    start, end : float
        m or rad.
    begin, stop : float
        s.

    Returns
    -------
    Segments
        Value against time in s. Its acceleration jumps at both ends.

    Raises
    ------
    AssemblyError
        If ``stop`` is not after ``begin``.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> value, rate = jn.mechanics.step(0.0, 0.5, begin=1.0, stop=2.0).evaluate(np.array([0.5, 1.5, 9.0]))
    >>> value.tolist(), rate.tolist()
    ([0.0, 0.25, 0.5], [0.0, 0.75, 0.0])
    """
    begin, stop = as_number(begin, "s", where="begin"), as_number(stop, "s", where="stop")
    start, end = _value(start), _value(end)
    width, rise = stop - begin, end - start
    if not width > 0.0:
        raise AssemblyError(
            "invalid motion",
            found=f"from {begin:g} s to {stop:g} s",
            allowed="stop later than begin",
        )
    cubic = [start, 0.0, 3.0 * rise / width**2, -2.0 * rise / width**3]
    pieces = np.array([[start, 0.0, 0.0, 0.0], cubic, [end, 0.0, 0.0, 0.0]])
    edges = np.array([begin - 1.0, begin, stop, stop + 1.0])
    return Segments(edges, np.zeros(3, dtype=np.int64), pieces)


def interpolated(time: ArrayLike, value: ArrayLike, *, smooth: bool = True) -> Segments:
    """Return a motion through points by a cubic spline or straight lines; constant beyond the first and last point.

    Parameters
    ----------
    time : array_like, shape (n,)
        s, strictly ascending.
    value : array_like, shape (n,)
        m or rad.
    smooth : bool
        Natural cubic spline or straight lines; straight lines have rate jumps, which a driven mass cannot follow.

    Returns
    -------
    Segments
        Value against time in s.

    Raises
    ------
    AssemblyError
        If there are fewer than two points or the times do not ascend.
    """
    t = as_samples(time, "s", where="time", error=AssemblyError)
    try:
        x = as_samples(value, "m", where="value", error=AssemblyError)
    except DescriptionError:  # the unit of an angle
        x = as_samples(value, "rad", where="value", error=AssemblyError)
    if (
        t.ndim != 1
        or len(t) < 2
        or t.shape != x.shape
        or not np.all(np.diff(t) > 0.0)
        or not np.all(np.isfinite(x))
    ):
        shapes = f"times of shape {t.shape}, values of shape {x.shape}"
        raise AssemblyError(
            "invalid motion", found=shapes, allowed="two finite points or more, ascending in time"
        )
    pieces = piecewise_linear(t, x).coefficients
    if smooth:
        from scipy.interpolate import CubicSpline

        pieces = CubicSpline(t, x, bc_type="natural").c[::-1].T
    ends = np.zeros((2, 4))
    ends[:, 0] = x[0], x[-1]
    edges = np.concatenate([[t[0] - 1.0], t, [t[-1] + 1.0]])
    return Segments(
        edges, np.zeros(len(t) + 1, dtype=np.int64), np.vstack([ends[:1], pieces, ends[1:]])
    )


def constant(value: float) -> Segments:
    """Return a track that stays at ``value`` (m or rad)."""
    return constant_rate(0.0, value)


__all__: Sequence[str] = ("constant", "constant_rate", "harmonic", "interpolated", "step")
