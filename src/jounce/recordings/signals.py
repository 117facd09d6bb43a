"""Signals at a constant rate.

Zero-phase filters, resampling, derivatives, shifts in time and the lag between two records.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import RecordingError
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.types import Array
from jounce.core.units import as_number

_TWO_PASSES = (
    math.sqrt(2.0) - 1.0
)  # (w/w_d)^(2 n) at which the squared gain of two passes is 1/sqrt(2)
_ANTI_ALIAS_ORDER = 8  # two passes: -3 dB at the corner, -24 dB at half the new rate
_ANTI_ALIAS_SHARE = 0.4  # corner as a fraction of the new rate; four fifths of the band remain
_UNEVEN = 1e-3  # fraction of the mean step by which steps may differ for a filter
_JITTER = 0.01  # fraction by which the median step may exceed the requested step
_GAP = 10.0  # median steps: a spline overshoots across a wider gap, so a line replaces it
_MOST_INSTANTS = 1e8  # 0.8 GB for each channel


def check_frequency(frequency: float, sample_rate: float, *, where: str) -> None:
    """Refuse a corner frequency (Hz) outside (0, sample_rate / 2)."""
    if not 0.0 < frequency < 0.5 * sample_rate:
        raise RecordingError(
            "the frequency cannot be realised at this sample rate",
            where=where,
            found=f"{frequency:g} Hz",
            allowed=Phrase(
                "above 0 and below {sample_rate:g} Hz, half the sample rate",
                sample_rate=0.5 * sample_rate,
            ),
        )


def _signals(values: ArrayLike, what: str, fewest: int) -> Array:
    """Return signals with samples along the first axis; refuse too few samples for the purpose ``what``."""
    signals = as_samples(values, where="signal")
    count = len(signals) if signals.ndim else 0
    if count < fewest:
        raise RecordingError(
            Phrase("the signal is too short to {what}", what=what),
            found=f"{count} samples",
            allowed=f"{fewest}",
        )
    return signals


def _check_finite(*signals: Array) -> None:
    for signal in signals:
        finite = np.isfinite(signal).reshape(len(signal), -1).all(axis=1)
        if not finite.all():
            raise RecordingError(
                Phrase("sample {argmin} is not a finite number", argmin=int(np.argmin(finite)) + 1),
                where="signal",
            )


def band_limit(
    values: ArrayLike,
    sample_rate: float,
    *,
    above: float | None = None,
    below: float | None = None,
    order: int = 2,
) -> Array:
    """Apply Butterworth filters forwards and backwards: zero phase, exactly -3 dB at the given frequencies.

    Parameters
    ----------
    values : array_like, shape (n,) or (n, k)
        Signals in SI or any other unit, at a constant rate, samples along the first axis.
    sample_rate : float
        Samples per second in Hz.
    above : float, optional
        Corner frequency of the high pass in Hz.
    below : float, optional
        Corner frequency of the low pass in Hz.
    order : int
        Order of one pass; two passes double the steepness.

    Returns
    -------
    ndarray, shape of ``values``
        Filtered signals in the same unit. Compare them only with signals filtered in the same way.

    Raises
    ------
    RecordingError
        If a frequency is not below half the sample rate, or the signal too short to filter.

    Notes
    -----
    Two passes move the -3 dB point of a low pass to ``(sqrt(2) - 1)^(1 / (2 order))`` of the design frequency (0.8022
    for order 2). The design frequency is shifted to compensate, in the warped frequency of the bilinear transform.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(2000) / 1000.0
    >>> hum = np.sin(2 * np.pi * 2.0 * t) + np.sin(2 * np.pi * 200.0 * t)
    >>> bool(abs(band_limit(hum, 1000.0, below=20.0)[500:1500] - np.sin(2 * np.pi * 2.0 * t)[500:1500]).max() < 1e-3)
    True
    """
    sample_rate = as_number(sample_rate, "Hz", where="sample_rate")
    from scipy import signal

    sections = []
    for frequency, kind, sign in ((above, "highpass", 1.0), (below, "lowpass", -1.0)):
        if frequency is not None:
            check_frequency(frequency, sample_rate, where=f"{kind[:-4]} pass")
            warped = math.tan(math.pi * frequency / sample_rate) * _TWO_PASSES ** (
                sign / (2.0 * order)
            )
            design = math.atan(warped) / math.pi * sample_rate
            sections.append(signal.butter(order, design, kind, fs=sample_rate, output="sos"))
    if not sections:
        return _signals(values, "filter", 0).copy()
    return _both_ways(np.concatenate(sections), values)


def _both_ways(sections: Array, values: ArrayLike) -> Array:
    from scipy import signal

    signals = _signals(values, "filter", 3 * (2 * len(sections) + 1) + 1)
    return np.asarray(signal.sosfiltfilt(sections, signals, axis=0), dtype=float)


def cfc_coefficients(
    channel_class: float, sample_rate: float
) -> tuple[float, float, float, float, float]:
    """Coefficients ``a0, a1, a2, b1, b2`` of an SAE J211 channel frequency class (``sample_rate`` in Hz).

    They belong to ``y[t] = a0 x[t] + a1 x[t-1] + a2 x[t-2] + b1 y[t-1] + b2 y[t-2]``, run forwards and backwards.

    >>> [round(c, 8) for c in cfc_coefficients(60.0, 10e3)]
    [0.00145237, 0.00290473, 0.00145237, 1.88934322, -0.89515269]
    """
    if not (channel_class > 0.0 and sample_rate >= 10.0 * channel_class):  # SAE J211
        raise RecordingError(
            "the channel frequency class cannot be realised at this sample rate",
            where="CFC filter",
            found=f"class {channel_class:g} at {sample_rate:g} Hz",
            allowed=Phrase(
                "a class above 0 and up to {sample_rate:g}, a tenth of the sample rate",
                sample_rate=0.1 * sample_rate,
            ),
        )
    w = math.tan(math.pi * channel_class * 2.0775 / sample_rate)
    scale = 1.0 + math.sqrt(2.0) * w + w * w
    a0 = w * w / scale
    return (
        a0,
        2.0 * a0,
        a0,
        -2.0 * (w * w - 1.0) / scale,
        (-1.0 + math.sqrt(2.0) * w - w * w) / scale,
    )


def cfc_filter(values: ArrayLike, sample_rate: float, channel_class: float) -> Array:
    """Filter to an SAE J211 channel frequency class (four poles, zero phase).

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
        If the sample rate is below 10 times the class, or the signal too short.

    Examples
    --------
    >>> import numpy as np
    >>> bool(np.allclose(cfc_filter(np.full(100, 3.0), 10e3, 60.0), 3.0))
    True
    """
    sample_rate = as_number(sample_rate, "Hz", where="sample_rate")
    a0, a1, a2, b1, b2 = cfc_coefficients(
        as_number(channel_class, "1", where="channel_class"), sample_rate
    )
    return _both_ways(np.array([[a0, a1, a2, 1.0, -b1, -b2]]), values)


def resample(time: ArrayLike, values: ArrayLike, sample_rate: float) -> tuple[Array, Array]:
    """Resample signals at a new constant rate.

    Parameters
    ----------
    time : array_like, shape (n,)
        Strictly ascending time in s; need not be uniform.
    values : array_like, shape (n,) or (n, k)
        Signals in SI or any other unit, samples along the first axis.
    sample_rate : float
        New sample rate in Hz.

    Returns
    -------
    time : ndarray, shape (m,)
        Instants in s, from the first in steps of ``1 / sample_rate`` up to the last.
    values : ndarray, shape (m,) or (m, k)
        Cubic spline through the samples; a straight line across gaps of more than 10 median steps, where a spline
        would overshoot. If the rate is reduced, the signals are low-pass filtered first (zero phase, at 0.4 of the new
        rate) to prevent aliasing.

    Raises
    ------
    RecordingError
        If the rate is not positive, there are fewer than two samples, lengths differ, or the result would be too large.

    Examples
    --------
    >>> t, x = resample([0.0, 0.5, 1.0], [0.0, 1.0, 2.0], 4.0)
    >>> t.tolist(), x.round(12).tolist()
    ([0.0, 0.25, 0.5, 0.75, 1.0], [0.0, 0.5, 1.0, 1.5, 2.0])
    """
    instants, signals = as_samples(time, "s", where="time"), as_samples(values, where="signal")
    sample_rate = as_number(sample_rate, "Hz", where="sample_rate")
    if not sample_rate > 0.0 or not math.isfinite(sample_rate):
        raise RecordingError(
            "the sample rate is not positive", where="resample", found=f"{sample_rate:g} Hz"
        )
    if instants.ndim != 1 or instants.size < 2 or signals.shape[:1] != instants.shape:
        raise RecordingError(
            "time and values do not match",
            where="resample",
            found=f"shapes {instants.shape} and {signals.shape}",
            allowed="equal numbers of values and instants, at least two",
        )
    _check_finite(instants, signals)
    if not np.all(np.diff(instants) > 0.0):
        raise RecordingError("time does not increase strictly", where="resample")
    wanted = uniform_instants(float(instants[0]), float(instants[-1]), sample_rate)
    return wanted, read_at(instants, signals, wanted, sample_rate)


def uniform_instants(first: float, last: float, sample_rate: float) -> Array:
    """Return instants in s from the first in steps of ``1 / sample_rate`` up to the last; refuse too many."""
    duration = last - first
    count = duration * sample_rate * (1.0 + 1e-12) + 1e-9  # rounding must not drop the last instant
    if not count < _MOST_INSTANTS:
        raise RecordingError(
            "too many instants",
            where="resample",
            found=f"{duration:g} s in steps of {1.0 / sample_rate:g} s",
            allowed=Phrase("up to {most_instants:g}", most_instants=_MOST_INSTANTS),
            hint="Is the time in the unit that the file states?",
        )
    return np.asarray(
        np.minimum(first + np.arange(math.floor(count) + 1) / sample_rate, last), dtype=float
    )


def read_at(instants: Array, signals: Array, wanted: Array, sample_rate: float) -> Array:
    """Interpolate signals at uniform instants; low-pass filter them first if ``sample_rate`` is the lower rate."""
    steps = np.diff(instants)
    mean = float(instants[-1] - instants[0]) / (instants.size - 1)
    is_even = float(np.abs(steps - mean).max()) <= _UNEVEN * mean
    usual = mean if is_even else float(np.median(steps))
    if sample_rate * usual >= 1.0 - (1e-9 if is_even else _JITTER):
        return _between(instants, signals, wanted, usual)
    if not is_even:  # a filter needs uniform samples: at least one for each recorded step
        fine = sample_rate * math.ceil(1.0 / (sample_rate * usual))
        even = uniform_instants(float(instants[0]), float(instants[-1]), fine)
        signals, instants, mean = _between(instants, signals, even, usual), even, 1.0 / fine
    smooth = band_limit(
        signals, 1.0 / mean, below=_ANTI_ALIAS_SHARE * sample_rate, order=_ANTI_ALIAS_ORDER
    )
    return _between(instants, smooth, wanted, mean)


def _between(instants: Array, signals: Array, wanted: Array, usual: float) -> Array:
    """Interpolate by a cubic spline, and linearly across gaps."""
    from scipy.interpolate import CubicSpline

    values = np.asarray(
        CubicSpline(instants, signals)(np.clip(wanted, instants[0], instants[-1])), dtype=float
    )
    gaps = np.flatnonzero(np.diff(instants) > _GAP * usual)
    if len(gaps):
        place = np.clip(np.searchsorted(instants, wanted, side="right") - 1, 0, instants.size - 2)
        within = np.isin(place, gaps)
        left = place[within]
        share = np.clip(
            (wanted[within] - instants[left]) / (instants[left + 1] - instants[left]), 0.0, 1.0
        )
        share = share.reshape(-1, *(1,) * (signals.ndim - 1))
        values[within] = signals[left] * (1.0 - share) + signals[left + 1] * share
    return values


def derivative(values: ArrayLike, sample_rate: float) -> Array:
    """Differentiate signals with respect to time by central differences (second order, one-sided at the ends).

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
        If there are fewer than three samples.

    Examples
    --------
    >>> derivative([0.0, 1.0, 4.0, 9.0], 1.0).tolist()
    [0.0, 2.0, 4.0, 6.0]
    """
    signals, sample_rate = (
        _signals(values, "differentiate", 3),
        as_number(sample_rate, "Hz", where="sample_rate"),
    )
    return np.asarray(np.gradient(signals, 1.0 / sample_rate, axis=0, edge_order=2), dtype=float)


_CONSTANT = 1e-9  # fraction of the variance below which a part is treated as constant


def shift_signals(values: ArrayLike, sample_rate: float, lag: float) -> Array:
    """Delay signals by any time, including fractions of a sample.

    Parameters
    ----------
    values : array_like, shape (n,) or (n, k)
        Signals in SI or any other unit, at a constant rate, samples along the first axis.
    sample_rate : float
        Samples per second in Hz.
    lag : float
        Delay in s: the result at t is the signal at ``t - lag``.

    Returns
    -------
    ndarray, shape of ``values``
        Cubic spline through the samples, evaluated at the shifted instants, in the same unit; beyond the ends the
        first and last values are repeated.

    Examples
    --------
    >>> shift_signals([0.0, 1.0, 2.0, 3.0], 10.0, 0.05).round(12).tolist()
    [0.0, 0.5, 1.5, 2.5]
    """
    return shift_with_derivative(values, sample_rate, lag)[0]


def shift_with_derivative(values: ArrayLike, sample_rate: float, lag: float) -> tuple[Array, Array]:
    """Delay signals, and differentiate the result with respect to the delay (for fits that estimate the delay).

    Parameters
    ----------
    values : array_like, shape (n,) or (n, k)
        Signals in SI or any other unit, at a constant rate, samples along the first axis.
    sample_rate : float
        Samples per second in Hz.
    lag : float
        Delay in s; positive values shift the signals to later times.

    Returns
    -------
    shifted : ndarray, shape of ``values``
        As returned by ``shift_signals``.
    derivative : ndarray, shape of ``values``
        Derivative of ``shifted`` with respect to ``lag``, in the unit of ``values`` per s; 0 beyond the ends.

    Raises
    ------
    RecordingError
        If there are fewer than two samples.

    Examples
    --------
    >>> shift_with_derivative([0.0, 1.0, 2.0, 3.0], 10.0, 0.05)[1].round(12).tolist()
    [0.0, -10.0, -10.0, -10.0]
    """
    from scipy.interpolate import CubicSpline

    signals, sample_rate = (
        _signals(values, "shift", 2),
        as_number(sample_rate, "Hz", where="sample_rate"),
    )
    lag = as_number(lag, "s", where="lag")
    _check_finite(signals)
    samples = np.arange(signals.shape[0], dtype=float)
    spline = CubicSpline(samples, signals)
    wanted = samples - lag * sample_rate
    read = np.clip(wanted, 0.0, samples[-1])
    slope = np.asarray(spline(read, 1), dtype=float)
    slope[(wanted < 0.0) | (wanted > samples[-1])] = 0.0
    return np.asarray(spline(read), dtype=float), 0.0 - sample_rate * slope


def estimate_lag(
    reference: ArrayLike,
    compared: ArrayLike,
    sample_rate: float,
    *,
    maximum_lag: float | None = None,
) -> float:
    """Estimate the delay of one signal relative to another.

    Parameters
    ----------
    reference, compared : array_like, shape (n,)
        Two records of the same motion, in the same unit and at the same constant rate.
    sample_rate : float
        Samples per second in Hz.
    maximum_lag : float, optional
        Maximum absolute delay considered in s, at most half the record; by default a fifth of the record.

    Returns
    -------
    float
        Delay of ``compared`` in s, positive if it is later: ``compared(t)`` is about ``reference(t - lag)``. The delay
        maximises the correlation coefficient of the overlapping parts, refined to a fraction of a sample by a parabola.
        0 if either signal is constant.

    Raises
    ------
    RecordingError
        If the signals have different lengths or fewer than three samples.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(2000) / 1000.0
    >>> pulse = np.exp(-(((t - 1.0) / 0.05) ** 2))
    >>> late = np.exp(-(((t - 1.0123) / 0.05) ** 2))
    >>> round(estimate_lag(pulse, late, 1000.0), 5)
    0.0123
    """
    a, b = as_samples(reference, where="reference"), as_samples(compared, where="compared")
    sample_rate = as_number(sample_rate, "Hz", where="sample_rate")
    if a.shape != b.shape or a.ndim != 1 or a.size < 3:
        raise RecordingError(
            "the signals cannot be compared",
            where="lag",
            found=f"shapes {a.shape} and {b.shape}",
            allowed="two signals of the same length, at least 3 samples",
        )
    _check_finite(a, b)
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
    """Correlate the overlapping parts of two signals for every shift, by fast Fourier transform.

    Returns the coefficient (-1 to 1) of ``reference[t]`` with ``compared[t + shift]`` about the means of the
    overlapping parts, for shifts from ``-most`` to ``most`` samples; -1 if one part is constant or nothing overlaps.
    """
    t, c = reference - reference.mean(), compared - compared.mean()
    shift = np.arange(-most, most + 1)
    first_t = np.minimum(np.maximum(-shift, 0), t.size)
    first_c = np.minimum(np.maximum(shift, 0), c.size)
    length = np.minimum(t.size - first_t, c.size - first_c)
    sums = [np.concatenate(([0.0], np.cumsum(v))) for v in (t, t * t, c, c * c)]
    sum_t, square_t = (s[first_t + length] - s[first_t] for s in sums[:2])
    sum_c, square_c = (s[first_c + length] - s[first_c] for s in sums[2:])
    count = np.maximum(length, 1)
    variance_t = square_t - sum_t**2 / count
    variance_c = square_c - sum_c**2 / count
    usable = (variance_t > _CONSTANT * sums[1][-1]) & (variance_c > _CONSTANT * sums[3][-1])
    size = np.sqrt(np.where(usable, variance_t * variance_c, 1.0))
    covariance = _cross_correlation(t, c, most) - sum_t * sum_c / count
    return np.asarray(np.where(usable, covariance / size, -1.0), dtype=float)


def _cross_correlation(reference: Array, compared: Array, most: int) -> Array:
    """Sum ``reference[t] compared[t + shift]`` over the overlap, for shifts from ``-most`` to ``most``."""
    from scipy import fft

    size = fft.next_fast_len(max(reference.size, compared.size) + most, real=True)
    circular = fft.irfft(np.conj(fft.rfft(reference, size)) * fft.rfft(compared, size), size)
    return np.concatenate((circular[size - most :], circular[: most + 1]))
