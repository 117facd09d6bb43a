"""Filters that leave the phase alone, resampling and derivatives. Their causal relatives are in ``sensors``."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import RecordingError
from jounce.core.types import Array

_TWO_PASSES = math.sqrt(2.0) - 1.0  # (w/w_d)^(2 n) at which the squared gain of two passes is 1/sqrt(2)
_ANTI_ALIAS_ORDER = 8
_ANTI_ALIAS_SHARE = 0.4


def check_frequency(frequency: float, sample_rate: float, *, where: str) -> None:
    """Refuse a corner frequency (Hz) outside (0, sample_rate / 2)."""
    if not 0.0 < frequency < 0.5 * sample_rate:
        raise RecordingError(
            "the frequency cannot be realised at this sample rate",
            where=where,
            found=f"{frequency:g} Hz",
            allowed=f"above 0 and below {0.5 * sample_rate:g} Hz, half the sample rate",
        )


def band_limit(
    values: ArrayLike,
    sample_rate: float,
    *,
    above: float | None = None,
    below: float | None = None,
    order: int = 2,
) -> Array:
    """Filter by Butterworth forwards and backwards: the phase stays, -3 dB lies exactly at the given frequencies.

    Parameters
    ----------
    values : array_like, shape (n,) or (n, k)
        Signals in SI or any other unit, at a constant rate, samples along the first axis.
    sample_rate : float
        Samples per second in Hz.
    above : float, optional
        Keep what is faster than this frequency in Hz (high pass).
    below : float, optional
        Keep what is slower than this frequency in Hz (low pass).
    order : int
        Order of one pass; two passes double the steepness.

    Returns
    -------
    ndarray, shape of ``values``
        Filtered signals in the same unit. Compare filtered with equally filtered signals only.

    Raises
    ------
    RecordingError
        For a frequency that is not below half the sample rate, or a signal too short to filter.

    Notes
    -----
    Two passes move the -3 dB point of a low pass to ``(sqrt(2) - 1)^(1 / (2 order))`` of the design frequency (0.8022
    for order 2); the design frequency is moved the other way first, in the warped frequency of the bilinear transform.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(2000) / 1000.0
    >>> hum = np.sin(2 * np.pi * 2.0 * t) + np.sin(2 * np.pi * 200.0 * t)
    >>> bool(abs(band_limit(hum, 1000.0, below=20.0)[500:1500] - np.sin(2 * np.pi * 2.0 * t)[500:1500]).max() < 1e-3)
    True
    """
    from scipy import signal

    sections = []
    for frequency, kind, sign in ((above, "highpass", 1.0), (below, "lowpass", -1.0)):
        if frequency is not None:
            check_frequency(frequency, sample_rate, where=f"{kind[:-4]} pass")
            warped = math.tan(math.pi * frequency / sample_rate) * _TWO_PASSES ** (sign / (2.0 * order))
            design = math.atan(warped) / math.pi * sample_rate
            sections.append(signal.butter(order, design, kind, fs=sample_rate, output="sos"))
    if not sections:
        return np.array(values, dtype=float)
    return _both_ways(np.concatenate(sections), values)


def _both_ways(sections: Array, values: ArrayLike) -> Array:
    from scipy import signal

    signals = np.asarray(values, dtype=float)
    needed = 3 * (2 * len(sections) + 1) + 1
    if signals.shape[0] < needed:
        raise RecordingError(
            "the signal is too short to filter", found=f"{signals.shape[0]} samples", allowed=f"{needed}"
        )
    return np.asarray(signal.sosfiltfilt(sections, signals, axis=0), dtype=float)


def cfc_coefficients(channel_class: float, sample_rate: float) -> tuple[float, float, float, float, float]:
    """Give the recursion of an SAE J211 channel frequency class.

    Parameters
    ----------
    channel_class : float
        Channel frequency class (CFC), e.g. 60, 180, 600, 1000: a label in Hz; -3 dB lies at 1.667 times that.
    sample_rate : float
        Samples per second in Hz, at least 10 times the class.

    Returns
    -------
    a0, a1, a2, b1, b2 : float
        Of ``y[t] = a0 x[t] + a1 x[t-1] + a2 x[t-2] + b1 y[t-1] + b2 y[t-2]``, applied forwards and backwards.

    Raises
    ------
    RecordingError
        When the sample rate is below 10 times the class.

    Examples
    --------
    >>> [round(c, 8) for c in cfc_coefficients(60.0, 10e3)]
    [0.00145237, 0.00290473, 0.00145237, 1.88934322, -0.89515269]
    """
    if not (channel_class > 0.0 and sample_rate >= 10.0 * channel_class):
        raise RecordingError(
            "the channel frequency class cannot be realised at this sample rate",
            where="CFC filter",
            found=f"class {channel_class:g} at {sample_rate:g} Hz",
            allowed=f"a class above 0 and up to {0.1 * sample_rate:g}, a tenth of the sample rate",
        )
    w = math.tan(math.pi * channel_class * 2.0775 / sample_rate)
    scale = 1.0 + math.sqrt(2.0) * w + w * w
    a0 = w * w / scale
    return a0, 2.0 * a0, a0, -2.0 * (w * w - 1.0) / scale, (-1.0 + math.sqrt(2.0) * w - w * w) / scale


def cfc_filter(values: ArrayLike, sample_rate: float, channel_class: float) -> Array:
    """Filter to an SAE J211 channel frequency class (four poles, no phase).

    Parameters
    ----------
    values : array_like, shape (n,) or (n, k)
        Signals in SI or any other unit, at a constant rate, samples along the first axis.
    sample_rate : float
        Samples per second in Hz, at least 10 times the class.
    channel_class : float
        Channel frequency class, e.g. 60: -6 dB at 2.0775 times that many Hz, -3 dB at 1.667 times.

    Returns
    -------
    ndarray, shape of ``values``
        Filtered signals in the same unit.

    Raises
    ------
    RecordingError
        When the sample rate is below 10 times the class, or the signal too short.

    Examples
    --------
    >>> import numpy as np
    >>> bool(np.allclose(cfc_filter(np.full(100, 3.0), 10e3, 60.0), 3.0))
    True
    """
    a0, a1, a2, b1, b2 = cfc_coefficients(channel_class, sample_rate)
    return _both_ways(np.array([[a0, a1, a2, 1.0, -b1, -b2]]), values)


def resample(time: ArrayLike, values: ArrayLike, sample_rate: float) -> tuple[Array, Array]:
    """Give signals at another constant rate.

    Parameters
    ----------
    time : array_like, shape (n,)
        Strictly ascending time in s; need not be uniform unless the rate is reduced.
    values : array_like, shape (n,) or (n, k)
        Signals in SI or any other unit, samples along the first axis.
    sample_rate : float
        Wanted samples per second in Hz.

    Returns
    -------
    time : ndarray, shape (m,)
        From the first instant in steps of ``1 / sample_rate`` s up to the last instant.
    values : ndarray, shape (m,) or (m, k)
        Cubic spline through the samples. When the rate is reduced, the samples are band-limited first (phase-free, at
        0.4 of the new rate), so that nothing folds back.

    Raises
    ------
    RecordingError
        For a rate that is not positive, fewer than two samples, or lengths that differ.

    Examples
    --------
    >>> t, x = resample([0.0, 0.5, 1.0], [0.0, 1.0, 2.0], 4.0)
    >>> t.tolist(), x.round(12).tolist()
    ([0.0, 0.25, 0.5, 0.75, 1.0], [0.0, 0.5, 1.0, 1.5, 2.0])
    """
    from scipy.interpolate import CubicSpline

    instants, signals = np.asarray(time, dtype=float), np.asarray(values, dtype=float)
    if not sample_rate > 0.0 or not math.isfinite(sample_rate):
        raise RecordingError("the sample rate is not positive", where="resample", found=f"{sample_rate:g} Hz")
    if instants.ndim != 1 or instants.size < 2 or signals.shape[:1] != instants.shape:
        raise RecordingError(
            "time and values do not fit together",
            where="resample",
            found=f"shapes {instants.shape} and {signals.shape}",
            allowed="as many values as instants, at least two",
        )
    duration = float(instants[-1] - instants[0])
    old_rate = (instants.size - 1) / duration
    if sample_rate < old_rate * (1.0 - 1e-9):
        signals = band_limit(signals, old_rate, below=_ANTI_ALIAS_SHARE * sample_rate, order=_ANTI_ALIAS_ORDER)
    count = math.floor(duration * sample_rate * (1.0 + 1e-12) + 1e-9) + 1
    wanted = np.minimum(instants[0] + np.arange(count) / sample_rate, instants[-1])
    return wanted, np.asarray(CubicSpline(instants, signals)(wanted), dtype=float)


def derivative(values: ArrayLike, sample_rate: float) -> Array:
    """Differentiate signals in time by central differences (second order, also at both ends).

    Parameters
    ----------
    values : array_like, shape (n,) or (n, k)
        Signals in SI or any other unit, at a constant rate, samples along the first axis, n >= 3.
        Band-limit measured displacements first.
    sample_rate : float
        Samples per second in Hz.

    Returns
    -------
    ndarray, shape of ``values``
        Derivative, in the unit of ``values`` per second.

    Raises
    ------
    RecordingError
        For fewer than three samples.

    Examples
    --------
    >>> derivative([0.0, 1.0, 4.0, 9.0], 1.0).tolist()
    [0.0, 2.0, 4.0, 6.0]
    """
    signals = np.asarray(values, dtype=float)
    if signals.shape[0] < 3:
        raise RecordingError(
            "the signal is too short to differentiate", found=f"{signals.shape[0]} samples", allowed="3"
        )
    return np.asarray(np.gradient(signals, 1.0 / sample_rate, axis=0, edge_order=2), dtype=float)
