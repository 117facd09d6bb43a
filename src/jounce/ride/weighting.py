"""Frequency weightings of ISO 2631-1 as defined in ISO 8041-1, exact at every sample rate."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.errors import DescriptionError, RecordingError, unknown
from jounce.core.old_names import with_old_names
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.types import Array
from jounce.core.units import as_number

__getattr__ = with_old_names(__name__, {"weighted": "weight"})

Start = Literal["rest", "first", "mean"]
STARTS: tuple[Start, ...] = ("rest", "first", "mean")
_Q = 1.0 / math.sqrt(2.0)  # Butterworth quality factor of both band limits: ISO 8041-1, 5.6
_MEMORY = 26.0  # time constants after which a response has decayed to exp(-26) = 5e-12
_GUARD = 4096  # guard samples around each block for ringing at half the sample rate
_FADE = 512  # samples over which the record fades out after its end
_SMALLEST_BLOCK = 1 << 16  # samples: one FFT for most records
_BLOCKS_AT_ONCE = 8  # limits memory; no effect on the result


@dataclass(frozen=True)
class Weighting:
    """One frequency weighting: band limits, a transition from acceleration to velocity, and an upward step.

    Attributes
    ----------
    name : str
        Name in the standard.
    use : str
        Application.
    f1, f2 : float
        Corner frequencies of high pass and low pass, Hz.
    f3, f4 : float
        Corner frequencies of the transition, Hz; infinite for a weighting without it.
    q4 : float
        Quality factor (1) of the transition.
    f5, f6 : float
        Corner frequencies of the upward step, Hz; infinite for a weighting without it.
    q5, q6 : float
        Quality factors (1) of the step.
    limits : tuple of float
        The four frequencies (Hz) at which the tolerance of ISO 8041-1 changes.
    """

    name: str
    use: str
    f1: float
    f2: float
    f3: float
    f4: float
    q4: float
    f5: float = math.inf
    q5: float = 1.0
    f6: float = math.inf
    q6: float = 1.0
    limits: tuple[float, float, float, float] = (10**-0.6, 10**-0.2, 10**1.8, 10**2.2)

    @property
    def shortest(self) -> float:
        """Shortest useful record: one period of the lower band limit, s."""
        return 1.0 / self.f1

    @property
    def slowest_rate(self) -> float:
        """Lowest sample rate, Hz: half the upper band limit."""
        return 0.5 * self.f2

    @property
    def memory(self) -> float:
        """Duration of its impulse response, s."""
        slowest = min(
            2.0 * math.pi * self.f1 * 0.5 / _Q, 2.0 * math.pi * min(self.f4, self.f6) * 0.5
        )
        return _MEMORY / slowest


WEIGHTINGS: dict[str, Weighting] = {
    row.name: row
    for row in (
        Weighting(
            "Wk", "vertical, seat and feet", 0.4, 100.0, 12.5, 12.5, 0.63, 2.37, 0.91, 3.35, 0.91
        ),
        Weighting("Wd", "horizontal, seat", 0.4, 100.0, 2.0, 2.0, 0.63),
        Weighting(
            *(
                "Wf",
                "vertical, motion sickness",
                0.08,
                0.63,
                math.inf,
                0.25,
                0.86,
                0.0625,
                0.80,
                0.1,
                0.80,
            ),
            limits=(10**-1.3, 10**-0.9, 10**-0.4, 1.0),
        ),
        Weighting("Wc", "fore and aft, seat back", 0.4, 100.0, 8.0, 8.0, 0.63),
        Weighting("We", "rotation, seat", 0.4, 100.0, 1.0, 1.0, 0.63),
    )
}
"""All weightings by name."""


def weighting(name: str) -> Weighting:
    """Return a weighting by name; an unknown name raises an error with a suggestion."""
    if name not in WEIGHTINGS:
        raise unknown(name, WEIGHTINGS, what="weighting")
    return WEIGHTINGS[name]


def check_duration(name: str, duration: float, *, where: str) -> None:
    """Raise an error if a record (duration in s) is too short for a meaningful weighting."""
    row = weighting(name)
    if duration < row.shortest * (1.0 - 1e-9):
        raise RecordingError(
            Phrase("the measurement is too short for {name}", name=row.name),
            where=where,
            found=f"{duration:g} s",
            allowed=Phrase(
                "{shortest:g} s or more, one period of the lower frequency limit",
                shortest=row.shortest,
            ),
        )


def weighting_response(name: str, frequency: ArrayLike) -> NDArray[np.complex128]:
    """Return the complex response (1) of a weighting at frequencies in Hz; a positive angle means lead.

    Names are ``Wk``, ``Wd``, ``Wf``, ``Wc`` and ``We``. This is the response of the standard's analog filter, not of a
    seat or a body. Source: ISO 8041-1:2017, 5.6 and Annex B (``iso-8041-1``), with f1 = 0.4 Hz exactly.

    Examples
    --------
    >>> [round(float(abs(w)), 4) for w in weighting_response("Wk", [1.0, 6.3096, 100.0])]
    [0.4825, 1.0544, 0.0887]
    """
    row = weighting(name)
    f = as_samples(frequency, "Hz", where="frequency", error=DescriptionError)
    s: NDArray[np.complex128] = np.asarray(2j * math.pi * f, dtype=np.complex128)
    response = _high_pass(s, row.f1) * _low_pass(s, row.f2)
    if math.isfinite(row.f4):
        response = response * _low_pass(s, row.f4, row.q4)
    if math.isfinite(row.f3):
        response = response * (1.0 + s / (2.0 * math.pi * row.f3))
    if math.isfinite(row.f5):
        response = (
            response
            * _low_pass(s, row.f6, row.q6)
            / _low_pass(s, row.f5, row.q5)
            * (row.f5 / row.f6) ** 2
        )
    return np.asarray(response, dtype=np.complex128)


def _low_pass(
    s: NDArray[np.complex128], frequency: float, quality: float = _Q
) -> NDArray[np.complex128]:
    p = s / (2.0 * math.pi * frequency)
    return np.asarray(1.0 / (1.0 + p * (1.0 / quality + p)))


def _high_pass(s: NDArray[np.complex128], frequency: float) -> NDArray[np.complex128]:
    p = s / (2.0 * math.pi * frequency)
    return np.asarray(p * p / (1.0 + p * (1.0 / _Q + p)))


def tolerance(name: str, frequency: ArrayLike) -> tuple[Array, Array]:
    """Return the minimum and maximum ratio (1) of gain to design value allowed by ISO 8041-1, at frequencies in Hz."""
    first, second, third, last = weighting(name).limits
    f = as_samples(frequency, "Hz", where="frequency", error=DescriptionError)
    outer, inner = (f <= first) | (f >= last), (f >= second) & (f <= third)
    low = np.where(outer, 0.0, np.where(inner, 0.89, 0.79))
    return low, np.where(inner & ~outer, 1.12, 1.26)


def weight(values: ArrayLike, sample_rate: float, name: str, *, start: Start = "rest") -> Array:
    """Weight a sampled acceleration as the standard's analog filter would, phase included.

    The response is exact at every frequency up to half the sample rate (no bilinear transform, no warping), and
    causal: no part of the filter runs backwards.

    Parameters
    ----------
    values : array_like, shape (n,)
        Acceleration, m/s^2 (or any unit), at a constant rate.
    sample_rate : float
        Samples per second, Hz. Intended for 100 Hz to 10 kHz (Wf: from 2 Hz).
    name : str
        ``"Wk"``, ``"Wd"``, ``"Wf"``, ``"Wc"`` or ``"We"``.
    start : {"rest", "first", "mean"}
        Constant state before the record: zero, in which case an offset acts as a step; the first value; or the mean of
        the record (e.g. gravity in the signal). The initial state affects the first seconds (Wk 1 s, Wf 10 s); skip
        them in the evaluation unless the record begins at rest.

    Returns
    -------
    ndarray, shape (n,)
        Weighted acceleration in the unit of ``values``.

    Raises
    ------
    DescriptionError
        If the weighting is unknown.
    RecordingError
        If there are fewer than two samples, a value is not finite, or the rate is too low.

    Notes
    -----
    Blocks of the signal are multiplied by `weighting_response` in the frequency domain, padded by more than the
    filter's memory. The record is extended by its mirror image and faded out, which prevents ringing at
    the end.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(0.0, 20.0, 0.001)
    >>> shaken = weight(np.sin(2.0 * np.pi * 5.0119 * t), 1000.0, "Wk")
    >>> round(float(shaken[10000:].max()), 3)    # the gain of Wk at 5.0119 Hz
    1.039
    """
    row = weighting(name)
    return filter_exactly(
        values,
        sample_rate,
        partial(weighting_response, row.name),
        memory=row.memory,
        slowest_rate=row.slowest_rate,
        start=start,
        where=f"weighting {row.name}",
    )


def filter_exactly(
    values: ArrayLike,
    sample_rate: float,
    response: Callable[[Array], NDArray[np.complex128]],
    *,
    memory: float,
    slowest_rate: float,
    start: Start,
    where: str,
) -> Array:
    """Filter a signal (n,) at a rate (Hz) by a response over frequency (Hz) that forgets within ``memory`` (s).

    Exact at every frequency up to half the rate, and causal, as :func:`weight`; errors name ``where``.
    """
    sample_rate = as_number(sample_rate, "Hz", where="sample_rate")
    signal = _check_signal(values, sample_rate, slowest_rate, start, where)
    signal = signal - {"rest": 0.0, "first": float(signal[0]), "mean": float(signal.mean())}[start]
    samples = math.ceil(memory * sample_rate) + _GUARD
    extended = np.concatenate([signal, _continuation(signal)])
    return _convolve(extended, response, sample_rate, samples)[: signal.size]


def _check_signal(
    values: ArrayLike, sample_rate: float, slowest_rate: float, start: str, at: str
) -> Array:
    signal = as_samples(values, where=at)
    if start not in STARTS:
        raise unknown(str(start), STARTS, what="start of the record", where=at)
    if signal.ndim != 1 or signal.size < 2:
        raise RecordingError(
            "invalid signal", where=at, found=f"shape {signal.shape}", allowed="at least 2 samples"
        )
    if not np.isfinite(signal).all():
        sample = int(np.argmin(np.isfinite(signal)))
        raise RecordingError(
            Phrase("sample {sample} is not a finite number", sample=sample + 1),
            where=at,
            found=float(signal[sample]),
        )
    if not (math.isfinite(sample_rate) and sample_rate >= slowest_rate):
        raise RecordingError(
            "the sample rate is too low for the weighting",
            where=at,
            found=f"{sample_rate:g} Hz",
            allowed=Phrase("{slowest_rate:g} Hz or more", slowest_rate=slowest_rate),
        )
    return signal


def _continuation(signal: Array) -> Array:
    """Return the mirror image of the end about its last point, faded to zero."""
    count = min(_FADE, signal.size - 1)
    image = 2.0 * signal[-1] - signal[-2 : -2 - count : -1]
    return np.asarray(
        image * (0.5 + 0.5 * np.cos(math.pi * np.arange(1, count + 1) / count)), dtype=float
    )


def _convolve(
    signal: Array,
    response_at: Callable[[Array], NDArray[np.complex128]],
    sample_rate: float,
    memory: int,
) -> Array:
    """Overlap-save: each block includes ``memory`` samples before it and a guard after it."""
    margin = memory + _GUARD
    block = _block_length(signal.size, margin)
    step = block - margin
    count = -(-signal.size // step)
    padded = np.zeros(memory + count * step + _GUARD)
    padded[memory : memory + signal.size] = signal
    windows = np.lib.stride_tricks.sliding_window_view(padded, block)[::step]
    response = response_at(np.asarray(np.fft.rfftfreq(block, 1.0 / sample_rate), dtype=float))
    filtered = np.empty((count, step))
    for first in range(0, count, _BLOCKS_AT_ONCE):
        spectra = np.fft.rfft(windows[first : first + _BLOCKS_AT_ONCE], axis=1)
        spectra *= response
        filtered[first : first + _BLOCKS_AT_ONCE] = np.fft.irfft(spectra, block, axis=1)[
            :, memory : memory + step
        ]
    return filtered.ravel()[: signal.size]


def _block_length(samples: int, margin: int) -> int:
    """Return a power of two that covers the whole signal, or at least four times the margin of each block."""
    whole = 1 << math.ceil(math.log2(samples + margin))
    usual = max(_SMALLEST_BLOCK, 1 << math.ceil(math.log2(4 * margin)))
    return min(whole, usual)
