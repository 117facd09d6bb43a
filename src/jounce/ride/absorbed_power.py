"""Power that a seated person absorbs from vertical vibration, and the shock limit of the NATO mobility tradition."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.samples import as_samples
from jounce.core.types import Array
from jounce.core.units import as_number
from jounce.ride.weighting import Start, filter_exactly

POWER_LIMIT = 6.0
"""W: absorbed power that drivers accept for hours, the ride limit of NRMM."""
SHOCK_LIMIT = 2.5 * 9.80665
"""m/s^2: peak vertical acceleration of the driver over a discrete obstacle, the shock limit of NRMM (2.5 g)."""
SHOCK_BAND = 30.0
"""Hz: corner of the low pass (Butterworth, fourth order) before a peak is read."""
SHORTEST = 1.0
"""s: shortest record of which a mean power is given."""
_FOOT = 0.3048  # m: the filter is given for ft/s^2
_GAIN, _ZERO, _POLE = 14.5 / _FOOT, 44.0, 63.0  # sqrt(W)/(m/s^2), 1/s, 1/s
_DAMPED, _SQUARE = 24.0, 750.0  # 1/s, 1/s^2: s^2 + 24 s + 750
_DECAY = 26.0  # time constants after which a response is forgotten: exp(-26) = 5e-12
_SLOWEST_RATE = 100.0  # Hz; half of it passes what the body takes up
_ORDER = 4


def absorbed_power_response(frequency: ArrayLike) -> NDArray[np.complex128]:
    """Return the response of the absorbed-power filter, sqrt(W)/(m/s^2), at frequencies in Hz.

    ``H(s) = 14.5 s (s + 44) / ((s + 63) (s^2 + 24 s + 750))`` for ft/s^2, s in 1/s. The mean square of the filtered
    vertical acceleration of the seat is the absorbed power in W. It is for a seated person in vertical vibration, not
    for other axes, and it is largest near 4.5 Hz.

    Parameters
    ----------
    frequency : array_like
        Frequencies, Hz.

    Returns
    -------
    ndarray of complex
        The response, same shape; a positive angle means lead.

    Notes
    -----
    The coefficients are those of ``ChAbsorbed_Power_Vertical`` of Project Chrono (``chrono-filters``), written there as
    a bilinear filter. The idea is that of Lee and Pradko (``lee-pradko-1968``); their own table of constants was not at
    hand, so powers may differ from those by it.

    Examples
    --------
    >>> [round(float(abs(h)) ** 2, 2) for h in absorbed_power_response([1.0, 4.5, 10.0])]    # W/(m/s^2)^2
    [0.08, 2.24, 0.53]
    """
    f = as_samples(frequency, "Hz", where="frequency", error=DescriptionError)
    s: NDArray[np.complex128] = np.asarray(2j * math.pi * f, dtype=np.complex128)
    return np.asarray(
        _GAIN * s * (s + _ZERO) / ((s + _POLE) * (s * s + _DAMPED * s + _SQUARE)),
        dtype=np.complex128,
    )


def absorbed_power(values: ArrayLike, sample_rate: float, *, start: Start = "rest") -> float:
    """Return the mean power (W) that a seated person absorbs from a vertical acceleration.

    Parameters
    ----------
    values : array_like, shape (n,)
        Vertical acceleration of the seat, m/s^2, at a constant rate; without gravity or with it (``start``).
    sample_rate : float
        Samples per second, Hz; 100 or more.
    start : {"rest", "first", "mean"}
        Constant acceleration before the record, as for :func:`jounce.weight`.

    Returns
    -------
    float
        Mean over the record, W. A sine of amplitude a gives ``|H|^2 a^2 / 2``. The power of one shock depends on the
        length of the record: compare equal courses.

    Raises
    ------
    RecordingError
        If the record is shorter than 1 s, a value is not finite, or the rate is too low.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(0.0, 30.0, 1e-3)
    >>> round(absorbed_power(2.0 * np.sin(2.0 * np.pi * 4.5 * t), 1000.0), 1)
    4.5
    """
    powers = power_course(values, sample_rate, start=start)
    rate = as_number(sample_rate, "Hz", where="sample_rate")
    check_length((powers.size - 1) / rate, where="absorbed power")
    return float(np.trapezoid(powers) / (powers.size - 1))


def power_course(values: ArrayLike, sample_rate: float, *, start: Start = "rest") -> Array:
    """Return the instantaneous absorbed power (W) at each sample of an acceleration (m/s^2, rate in Hz)."""
    return np.asarray(absorbed_root(values, sample_rate, start=start) ** 2)


def absorbed_root(values: ArrayLike, sample_rate: float, *, start: Start = "rest") -> Array:
    """Filter an acceleration (m/s^2, rate in Hz); the square of the result is the power in W."""
    return filter_exactly(
        values,
        sample_rate,
        absorbed_power_response,
        memory=2.0 * _DECAY / _DAMPED,
        slowest_rate=_SLOWEST_RATE,
        start=start,
        where="absorbed power",
    )


def check_length(duration: float, *, where: str) -> None:
    """Raise an error if a record (duration in s) is too short for a mean power."""
    if duration < SHORTEST * (1.0 - 1e-9):
        raise RecordingError(
            "the measurement is too short for a mean power",
            where=where,
            found=f"{duration:g} s",
            allowed=f"{SHORTEST:g} s",
        )


def shock(values: ArrayLike, sample_rate: float, *, start: Start = "rest") -> float:
    """Return the largest magnitude of an acceleration below 30 Hz, m/s^2 (rate in Hz).

    The low pass is a Butterworth filter of fourth order, as Project Chrono applies it (``chrono-filters``). Drivers
    are said to accept 2.5 g over a discrete obstacle.

    Parameters
    ----------
    values : array_like, shape (n,)
        Vertical acceleration, m/s^2, at a constant rate.
    sample_rate : float
        Samples per second, Hz; 100 or more.
    start : {"rest", "first", "mean"}
        Constant acceleration before the record, as for :func:`jounce.weight`.

    Returns
    -------
    float
        Largest magnitude, m/s^2, about ``start``.

    Raises
    ------
    RecordingError
        If a value is not finite, or the rate is too low.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(0.0, 10.0, 1e-3)
    >>> round(shock(5.0 * np.sin(2.0 * np.pi * 2.0 * t), 1000.0), 2)
    5.0
    """
    return float(np.abs(shock_course(values, sample_rate, start=start)).max())


def shock_course(values: ArrayLike, sample_rate: float, *, start: Start = "rest") -> Array:
    """Return an acceleration (m/s^2, rate in Hz) below 30 Hz at each sample, about ``start``."""
    return filter_exactly(
        values,
        sample_rate,
        _low_pass,
        memory=_DECAY / (2.0 * math.pi * SHOCK_BAND * math.cos(0.375 * math.pi)),
        slowest_rate=_SLOWEST_RATE,
        start=start,
        where="shock",
    )


def _low_pass(frequency: Array) -> NDArray[np.complex128]:
    """Return the response of the Butterworth low pass at frequencies in Hz."""
    p = 1j * frequency / SHOCK_BAND
    response = np.ones_like(p)
    for k in range(_ORDER // 2):
        response = response / (
            p * p + 2.0 * math.sin((2 * k + 1) * math.pi / (2 * _ORDER)) * p + 1.0
        )
    return np.asarray(response, dtype=np.complex128)
