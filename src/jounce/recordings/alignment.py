"""Signals against each other in time: shifts by parts of a sample, and the lag between two records."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import RecordingError
from jounce.core.types import Array

_CONSTANT = 1e-9  # share of a signal's variance below which a part of it counts as constant


def shift_signals(values: ArrayLike, sample_rate: float, lag: float) -> Array:
    """Delay signals by any time, also by a part of a sample.

    Parameters
    ----------
    values : array_like, shape (n,) or (n, k)
        Signals in SI or any other unit, at a constant rate, samples along the first axis.
    sample_rate : float
        Samples per second in Hz.
    lag : float
        Delay in s; positive makes the signals come later: the result at t is the signal at ``t - lag``.

    Returns
    -------
    ndarray, shape of ``values``
        Cubic spline through the samples in the same unit, read at the shifted instants; before the first and after the
        last sample the signal keeps that sample's value.

    Examples
    --------
    >>> shift_signals([0.0, 1.0, 2.0, 3.0], 10.0, 0.05).round(12).tolist()
    [0.0, 0.5, 1.5, 2.5]
    """
    return shift_with_derivative(values, sample_rate, lag)[0]


def shift_with_derivative(values: ArrayLike, sample_rate: float, lag: float) -> tuple[Array, Array]:
    """Delay signals, and say how the result changes with the delay (for estimating the delay in a fit).

    Parameters
    ----------
    values : array_like, shape (n,) or (n, k)
        Signals in SI or any other unit, at a constant rate, samples along the first axis.
    sample_rate : float
        Samples per second in Hz.
    lag : float
        Delay in s, positive later.

    Returns
    -------
    shifted : ndarray, shape of ``values``
        As ``shift_signals`` gives it.
    derivative : ndarray, shape of ``values``
        Derivative of ``shifted`` with respect to ``lag``, in the unit of ``values`` per s; 0 where a held end is read.

    Raises
    ------
    RecordingError
        For fewer than two samples.

    Examples
    --------
    >>> shift_with_derivative([0.0, 1.0, 2.0, 3.0], 10.0, 0.05)[1].round(12).tolist()
    [0.0, -10.0, -10.0, -10.0]
    """
    from scipy.interpolate import CubicSpline

    signals = np.asarray(values, dtype=float)
    if signals.shape[0] < 2:
        raise RecordingError("the signal is too short to shift", found=f"{signals.shape[0]} samples", allowed="2")
    samples = np.arange(signals.shape[0], dtype=float)
    spline = CubicSpline(samples, signals)
    wanted = samples - lag * sample_rate
    read = np.clip(wanted, 0.0, samples[-1])
    slope = np.asarray(spline(read, 1), dtype=float)
    slope[(wanted < 0.0) | (wanted > samples[-1])] = 0.0
    return np.asarray(spline(read), dtype=float), 0.0 - sample_rate * slope


def estimate_lag(
    reference: ArrayLike, compared: ArrayLike, sample_rate: float, *, maximum_lag: float | None = None
) -> float:
    """Estimate by how much one signal comes later than another.

    Parameters
    ----------
    reference, compared : array_like, shape (n,)
        Two records of the same motion, same unit, same constant rate.
    sample_rate : float
        Samples per second in Hz.
    maximum_lag : float, optional
        Largest delay looked for in s, either way, at most half the record; a fifth of the record by default.

    Returns
    -------
    float
        Delay of ``compared`` in s, positive when it comes later: ``compared(t)`` is about ``reference(t - lag)``.
        Maximum of the correlation coefficient of the overlapping parts, refined below a sample by a parabola. 0 when
        one of the signals is constant.

    Raises
    ------
    RecordingError
        For signals of different lengths or fewer than three samples.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(2000) / 1000.0
    >>> pulse = np.exp(-(((t - 1.0) / 0.05) ** 2))
    >>> late = np.exp(-(((t - 1.0123) / 0.05) ** 2))
    >>> round(estimate_lag(pulse, late, 1000.0), 5)
    0.0123
    """
    a, b = np.asarray(reference, dtype=float), np.asarray(compared, dtype=float)
    if a.shape != b.shape or a.ndim != 1 or a.size < 3:
        raise RecordingError(
            "the signals cannot be compared",
            where="lag",
            found=f"shapes {a.shape} and {b.shape}",
            allowed="two signals of the same length, at least 3 samples",
        )
    most = a.size // 5 if maximum_lag is None else int(abs(maximum_lag) * sample_rate)
    most = max(1, min(most, a.size // 2))
    if np.ptp(a) == 0.0 or np.ptp(b) == 0.0:
        return 0.0
    correlation = correlation_coefficients(a, b, most + 1)
    peak = int(np.argmax(correlation[1:-1])) + 1
    left, top, right = correlation[peak - 1 : peak + 2]
    bend = left - 2.0 * top + right
    part = 0.5 * (left - right) / bend if bend < 0.0 else 0.0
    return float((peak - (most + 1) + np.clip(part, -1.0, 1.0)) / sample_rate)


def correlation_coefficients(reference: Array, compared: Array, most: int) -> Array:
    """Correlate the overlapping parts of two signals for every shift, by one Fourier transform.

    Parameters
    ----------
    reference, compared : ndarray, shape (n,)
        Signals in any units, at the same constant rate.
    most : int
        Largest shift in samples, below n.

    Returns
    -------
    ndarray, shape (2 most + 1,)
        Coefficient (-1 to 1) of ``reference[t]`` with ``compared[t + shift]`` about the means of the overlapping parts,
        for shifts from ``-most`` to ``most``; -1 where one part is constant.

    Examples
    --------
    >>> import numpy as np
    >>> pulse = np.array([0.0, 0.0, 1.0, 3.0, 1.0, 0.0, 0.0, 0.0])
    >>> int(np.argmax(correlation_coefficients(pulse, np.roll(pulse, 1), 2))) - 2
    1
    """
    t, c = reference - reference.mean(), compared - compared.mean()
    shift = np.arange(-most, most + 1)
    length = t.size - np.abs(shift)
    first_t, first_c = np.maximum(-shift, 0), np.maximum(shift, 0)
    sums = [np.concatenate(([0.0], np.cumsum(v))) for v in (t, t * t, c, c * c)]
    sum_t, square_t = (s[first_t + length] - s[first_t] for s in sums[:2])
    sum_c, square_c = (s[first_c + length] - s[first_c] for s in sums[2:])
    variance_t = square_t - sum_t**2 / length
    variance_c = square_c - sum_c**2 / length
    usable = (variance_t > _CONSTANT * sums[1][-1]) & (variance_c > _CONSTANT * sums[3][-1])
    size = np.sqrt(np.where(usable, variance_t * variance_c, 1.0))
    covariance = _cross_correlation(t, c, most) - sum_t * sum_c / length
    return np.asarray(np.where(usable, covariance / size, -1.0), dtype=float)


def _cross_correlation(reference: Array, compared: Array, most: int) -> Array:
    """Sums ``reference[t] compared[t + shift]`` over the overlap, for shifts from -most to most."""
    from scipy import fft

    size = fft.next_fast_len(reference.size + most, real=True)
    circular = fft.irfft(np.conj(fft.rfft(reference, size)) * fft.rfft(compared, size), size)
    return np.concatenate((circular[size - most :], circular[: most + 1]))
