"""Spectra of signals, transfer functions with coherence, third-octave bands, responses of linear models to spectra."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.errors import RecordingError, nearest, unknown
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import as_number, to_si
from jounce.recordings.carried import rate_of_channels
from jounce.recordings.quality import check_time
from jounce.ride.weighting import weighting_response
from jounce.simulation.linear_model import LinearModel

if TYPE_CHECKING:
    import xarray as xr

WINDOWS = {"hann": 1.5, "boxcar": 1.0}
"""Windows, each with its noise bandwidth (1) in frequency steps."""
_USUAL_PARTS = 8  # default number of segments: 15 averages with Hann, a standard error of 27 %
_FEWEST_SAMPLES = 8  # per segment: fewer give at most three frequencies between 0 and half the rate
_HALF_BAND = 10.0**0.05  # edge over centre of a third-octave band, base ten (IEC 61260)


@dataclass(frozen=True)
class Spectrum(Shown):
    """One-sided power spectral density of a signal.

    Attributes
    ----------
    frequency : ndarray, shape (n,)
        Hz, from 0 in constant steps.
    density : ndarray, shape (n,)
        Unit of the signal squared per Hz; its integral over frequency is the mean square.
    resolution : float
        Noise bandwidth of the window, Hz; narrower peaks are not resolved.
    averages : float
        Number of independent spectra (1) in the mean; the relative standard error is the reciprocal of its root.
    """

    frequency: Array
    density: Array
    resolution: float
    averages: float

    @property
    def step(self) -> float:
        """Frequency step, Hz."""
        return float(self.frequency[1] - self.frequency[0])

    def mean_square(self, low: float = 0.0, high: float = math.inf) -> float:
        """Return the mean square between two frequencies (Hz), in the signal's unit squared; bins may be partial."""
        below = np.maximum(self.frequency - 0.5 * self.step, 0.0)
        above = np.minimum(self.frequency + 0.5 * self.step, self.frequency[-1])
        inside = np.clip(np.minimum(above, high) - np.maximum(below, low), 0.0, None)
        share = inside / (above - below)  # the first and the last bin are half as wide
        return float(np.sum(self.density * self.step * share))


@dataclass(frozen=True)
class Transfer(Shown):
    """Complex response of an output to an input, by frequency.

    Attributes
    ----------
    frequency : ndarray, shape (n,)
        Frequencies, Hz.
    response : ndarray of complex, shape (n,)
        Unit of the output over that of the input; a positive angle means lead.
    coherence : ndarray, shape (n,)
        Share (1) of the output that the input explains linearly; 1 for a linear model.
    averages : float
        Number of independent spectra (1) averaged; infinite for a linear model.
    """

    frequency: Array
    response: NDArray[np.complex128]
    coherence: Array
    averages: float

    @property
    def relative_error(self) -> Array:
        """Relative standard error (1) of the gain, from coherence and averages; infinite without coherence."""
        return relative_error(self.coherence, self.averages)


@dataclass(frozen=True)
class Bands:
    """Third-octave bands.

    Attributes
    ----------
    centre, low, high : ndarray, shape (n,)
        Exact base-ten frequencies of IEC 61260, Hz.
    rms : ndarray, shape (n,)
        Root mean square in each band, in the unit of the signal.
    """

    centre: Array
    low: Array
    high: Array
    rms: Array

    def weighted(self, name: str) -> float:
        """Return the weighted r.m.s. in the signal's unit: root sum of squares of gain times r.m.s. (ISO 2631-1)."""
        return float(np.sqrt(np.sum((abs(weighting_response(name, self.centre)) * self.rms) ** 2)))


def power_spectrum(
    values: ArrayLike,
    sample_rate: float | None = None,
    *,
    segment: float | str | None = None,
    window: str = "hann",
) -> Spectrum:
    """Compute the one-sided power spectral density by Welch's method.

    Parameters
    ----------
    values : array_like, shape (n,)
        Signal at a constant rate, in SI or any other unit (m/s^2, N, ...).
    sample_rate : float, optional
        Samples per second, Hz; not needed for a channel of a recording, which includes its time.
    segment : float or str, optional
        Length of the averaged segments, s or text with a unit; by default an eighth of the record. Longer segments
        increase resolution and scatter.
    window : {"hann", "boxcar"}
        Hann segments overlap by half; boxcar segments do not.

    Returns
    -------
    Spectrum
        Density in the unit of ``values`` squared per Hz. The mean of each segment is subtracted first.

    Raises
    ------
    RecordingError
        If the signal is too short or not finite, or the segment longer than the record.
    DescriptionError
        If the window is unknown.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(0.0, 20.0, 0.001)
    >>> spectrum = power_spectrum(3.0 * np.sin(2.0 * np.pi * 10.0 * t), 1000.0)
    >>> float(spectrum.frequency[spectrum.density.argmax()]), round(spectrum.mean_square(), 3)    # 3^2 / 2
    (10.0, 4.5)
    """
    rate = (
        rate_of_channels([values], where="signal")
        if sample_rate is None
        else as_number(sample_rate, "Hz")
    )
    signal = _check_signal(values, rate, "signal")
    count = _segment_length(signal, rate, segment, window)
    frequency, density = cross_spectrum(signal, signal, rate, count, window)
    resolution = WINDOWS[window] * rate / count
    return Spectrum(
        frequency, density.real.copy(), resolution, independent_segments(signal.size, count, window)
    )


def transfer_function(
    given: ArrayLike,
    answer: ArrayLike,
    sample_rate: float | None = None,
    *,
    segment: float | str | None = None,
    window: str = "hann",
) -> Transfer:
    """Estimate a transfer function with coherence from two signals (H1, unbiased if only the output is noisy).

    Parameters
    ----------
    given : array_like, shape (n,)
        Input signal at a constant rate, in SI or any other unit (m, m/s^2, ...).
    answer : array_like, shape (n,)
        Output signal at the same times, in SI or any other unit (m/s^2, N, ...).
    sample_rate : float, optional
        Samples per second, Hz; not needed for channels of a recording, which include their time.
    segment : float or str, optional
        Length of the averaged segments, s or text with a unit; by default an eighth of the record. It must exceed the
        system's ringing time; otherwise the peaks are too low and the coherence drops.
    window : {"hann", "boxcar"}
        As in `power_spectrum`.

    Returns
    -------
    Transfer
        Unit of ``answer`` over unit of ``given``. Response and coherence are zero where the input has no power.

    Raises
    ------
    RecordingError
        If the signals differ in length, are too short or not finite, or contain fewer than two segments (the coherence
        of a single segment is always 1).

    Examples
    --------
    >>> import numpy as np
    >>> noise = np.random.default_rng(0).normal(size=20_000)
    >>> late = transfer_function(noise, 2.0 * np.roll(noise, 1), 1000.0)
    >>> bool(np.allclose(abs(late.response), 2.0, rtol=0.05)), bool(late.coherence.min() > 0.99)
    (True, True)
    """
    is_sampled = sample_rate is None
    rate = (
        rate_of_channels([given, answer], where="transfer function")
        if is_sampled
        else as_number(sample_rate, "Hz")
    )
    x, y = _check_signal(given, rate, "input"), _check_signal(answer, rate, "output")
    if x.shape != y.shape:
        raise RecordingError(
            "input and output have different lengths",
            where="transfer function",
            found=f"{x.size} and {y.size} samples",
        )
    count = _segment_length(x, rate, segment, window)
    averages = independent_segments(x.size, count, window)
    if averages <= 1.0:
        raise RecordingError(
            "a transfer function needs at least two segments",
            where="segment",
            found=f"{count / rate:g} s",
            allowed=Phrase("at most half the record of {size:g} s", size=x.size / rate),
        )
    frequency, cross = cross_spectrum(x, y, rate, count, window)
    input_power = cross_spectrum(x, x, rate, count, window)[1].real
    output_power = cross_spectrum(y, y, rate, count, window)[1].real
    response = np.divide(cross, input_power, out=np.zeros_like(cross), where=input_power > 0.0)
    product = input_power * output_power
    coherence = np.divide(
        abs(cross) ** 2, product, out=np.zeros_like(input_power), where=product > 0.0
    )
    return Transfer(frequency, response, np.clip(coherence, 0.0, 1.0), averages)


def channel_transfer(
    run: xr.Dataset,
    output: str,
    given: str = "road.z",
    *,
    segment: float | str | None = None,
    settling: float = 0.0,
) -> Transfer:
    """Estimate the transfer function (SI) between two channels of a recording on uniform time, see `transfer_function`.

    ``segment`` is the length of the segments (s or text with a unit); the first ``settling`` seconds are skipped.
    """
    names = [str(name) for name in run.data_vars]
    for name in (output, given):
        if name not in names:
            raise RecordingError(
                Phrase("no channel {name!r}", name=name),
                where="recording",
                found=", ".join(names),
                hint=nearest(name, names),
            )
    time = np.asarray(run["time"].values, dtype=float)
    if check_time(time, where="recording")[1]:
        raise RecordingError(
            "the time steps are not uniform",
            where="recording",
            hint="Resample the recording first.",
        )
    rate = (time.size - 1) / float(time[-1] - time[0])
    first = math.ceil(settling * rate - 1e-6)  # rounding must not skip an additional sample
    x, y = (np.asarray(run[name].values, dtype=float)[first:] for name in (given, output))
    return transfer_function(x, y, rate, segment=segment)


def model_transfer(
    model: LinearModel, frequency: ArrayLike, output: str, given: str = "road.z"
) -> Transfer:
    """Compute a linearised model's transfer function (SI) at frequencies in Hz, comparable with `transfer_function`."""
    f = np.atleast_1d(as_samples(frequency, "Hz", where="frequency"))
    response = np.asarray(model.frequency_response(f, output, given), dtype=np.complex128)
    return Transfer(f, response, np.ones_like(f), math.inf)


def response_spectrum(
    model: LinearModel,
    frequency: ArrayLike,
    density: ArrayLike,
    output: str,
    tracks: str | Mapping[str, float] = "road.z",
) -> Array:
    """Return the one-sided density of a linear model's output on a random road: squared gain times road density.

    Takes frequencies above 0 (Hz, shape (n,)) and the one-sided ``density`` of the road's height over time (m^2/Hz);
    the result is in the unit of the output squared per Hz. ``tracks`` is one input, or several that follow the same
    road, each with a delay in s (rear wheels: wheelbase over speed).
    """
    f = np.atleast_1d(as_samples(frequency, "Hz", where="frequency"))
    delays = {tracks: 0.0} if isinstance(tracks, str) else tracks
    gain = np.zeros(f.shape, dtype=np.complex128)
    for track, delay in delays.items():
        gain += model.frequency_response(f, output, track) * np.exp(-2j * math.pi * f * delay)
    return np.asarray(abs(gain) ** 2 * as_samples(density, where="density"), dtype=np.float64)


def third_octaves(spectrum: Spectrum) -> Bands:
    """Compute root mean squares in third-octave bands with ideal edges, base ten.

    Bands narrower than the spectrum's resolution or above half the sample rate are omitted. A spectrum without any
    resolved band raises an error.
    """
    width = _HALF_BAND - 1.0 / _HALF_BAND
    lowest = math.ceil(
        10.0 * math.log10(spectrum.resolution / width) - 1e-9
    )  # 1e-9: rounding of the logarithms
    highest = math.floor(10.0 * math.log10(float(spectrum.frequency[-1]) / _HALF_BAND) + 1e-9)
    if highest < lowest:
        raise RecordingError(
            "the spectrum does not resolve any third-octave band",
            found=f"{spectrum.resolution:g} Hz up to {spectrum.frequency[-1]:g} Hz",
            hint="Use longer segments.",
        )
    centre = 10.0 ** (np.arange(lowest, highest + 1) / 10.0)
    low, high = centre / _HALF_BAND, centre * _HALF_BAND
    squares = [spectrum.mean_square(a, b) for a, b in zip(low.tolist(), high.tolist(), strict=True)]
    return Bands(centre, low, high, np.sqrt(squares))


def _check_signal(values: ArrayLike, sample_rate: float, what: str) -> Array:
    signal = as_samples(values, where=what)
    if signal.ndim != 1 or signal.size < _FEWEST_SAMPLES or not 0.0 < sample_rate < math.inf:
        raise RecordingError(
            "insufficient data for a spectrum",
            where=what,
            found=f"shape {signal.shape} at {sample_rate:g} Hz",
            allowed=Phrase(
                "at least {fewest_samples} samples, with a sample rate",
                fewest_samples=_FEWEST_SAMPLES,
            ),
        )
    if not np.isfinite(signal).all():
        raise RecordingError(
            Phrase(
                "sample {argmin} is not a finite number",
                argmin=int(np.argmin(np.isfinite(signal))) + 1,
            ),
            where=what,
        )
    return signal


def _segment_length(
    signal: Array, sample_rate: float, segment: float | str | None, window: str
) -> int:
    """Return the number of samples of a segment."""
    if window not in WINDOWS:
        raise unknown(str(window), WINDOWS, what="window", where="spectrum")
    if segment is None:
        return max(signal.size // _USUAL_PARTS, _FEWEST_SAMPLES)
    length = to_si(segment, "s", where="segment")
    count = round(length * sample_rate)
    if not _FEWEST_SAMPLES <= count <= signal.size:
        shortest, longest = _FEWEST_SAMPLES / sample_rate, signal.size / sample_rate
        raise RecordingError(
            "the segment does not fit the record",
            where="segment",
            found=f"{length:g} s",
            allowed=Phrase("{shortest:g} s to {longest:g} s", shortest=shortest, longest=longest),
        )
    return count


def relative_error(coherence: Array, averages: float) -> Array:
    """Return the relative error of a gain (H1, H2), also that of its phase in rad; infinite without coherence."""
    with np.errstate(divide="ignore"):
        return np.asarray(
            np.sqrt(np.clip(1.0 - coherence, 0.0, None) / (2.0 * averages * coherence))
        )


def cross_spectrum(
    x: Array, y: Array, sample_rate: float, count: int, window: str
) -> tuple[Array, NDArray[np.complex128]]:
    """Return the one-sided cross spectrum: frequencies in Hz, mean of conj(X) Y per Hz.

    It equals ``scipy.signal.csd``, which takes 60 MB and 0.4 s to load.
    """
    step = count - (count // 2 if window == "hann" else 0)
    weights = np.ones(count)
    if window == "hann":
        weights -= np.cos(2.0 * np.pi / count * np.arange(count))
    starts = range(0, x.size - count + 1, step)
    total = np.zeros(count // 2 + 1, np.complex128)
    for start in starts:
        first, second = (
            np.fft.rfft(weights * (segment - segment.mean()))
            for segment in (x[start : start + count], y[start : start + count])
        )
        total += first.conj() * second
    density: NDArray[np.complex128] = total / (len(starts) * sample_rate * float(weights @ weights))
    density[1 : (count + 1) // 2] *= 2.0  # the other side; zero and the highest frequency have none
    return np.asarray(np.fft.rfftfreq(count, 1.0 / sample_rate), dtype=float), density


def independent_segments(samples: int, count: int, window: str) -> float:
    """Return the number of independent segments; a Hann segment with 50 % overlap counts as 0.947."""
    if window != "hann":
        return float(samples // count)
    pieces = (samples - count) // (count - count // 2) + 1
    shared = (1.0 / 6.0) ** 2  # squared correlation of Hann windows half a length apart
    return pieces / (1.0 + 2.0 * shared * (pieces - 1) / pieces)
