"""Detect a low-pass filter of the logger from the noise of a record."""

from __future__ import annotations

import numpy as np

from jounce.core.types import Array

_FALL, _STEADY = (
    25.0,
    6.0,
)  # power of the noise over that at the top: all in all, and two octaves below it
_EXACT = 1e-6  # of the range: no noise at all
_ROUNDING = 4.0  # times the power of rounding: no noise is left there
_MORE = 1.5  # ratio to the power of a record: a low pass leaves half at its corner, and the fit compensates for a part
_HARMONIC, _LEAST = 0.3, 4  # of the frequency, beside multiples of it; octaves that show a fall


def low_pass_corner(
    residual: Array, rate: float, frequency: float, *, reach: float, step: float, near: float
) -> float | None:
    """Find the corner (Hz) of a low-pass filter from the noise; None without one below ``near`` frequencies.

    ``residual`` is the residual of a fit to a motion at ``frequency`` (Hz), sampled at ``rate`` (Hz); ``reach`` and
    ``step`` are range and resolution of the record in its unit. Misfits of the law appear at multiples of the
    frequency, noise at all frequencies. White noise has a flat spectrum; low-pass filtered noise falls towards the top
    of the spectrum or to the power of rounding.
    """
    if float(residual.std()) < _EXACT * reach:
        return None
    count = len(residual)
    window = np.hanning(count)
    spectrum = (
        np.abs(np.fft.rfft(window * (residual - residual.mean()))) ** 2
        * 2.0
        / (rate * float(window @ window))
    )
    at = np.fft.rfftfreq(count, 1.0 / rate)
    between = np.abs(at / frequency - np.round(at / frequency)) > _HARMONIC
    powers, top = [], 0.48 * rate
    # Below three times the frequency the motion leaves no lines for noise.
    while (
        top > 3.0 * frequency
        and np.count_nonzero(inside := between & (at > 0.5 * top) & (at <= top)) >= 3
    ):
        powers.append(float(np.quantile(spectrum[inside], 0.25)))
        top *= 0.5
    if len(powers) < _LEAST:
        return None
    end, most = powers[0], max(powers)
    rounded = step**2 / (6.0 * rate)
    if most < _FALL * max(end, 1e-300) or (powers[2] < _STEADY * end and end > _ROUNDING * rounded):
        return None
    # A quarter of the power, half the amplitude, is left within the octave of the corner of a second order.
    octave = next(k for k, power in enumerate(powers) if power > 0.25 * most)
    corner = 0.48 * rate * 0.5**octave / np.sqrt(2.0)
    return float(corner) if corner < near * frequency else None


def smoother_corner(signal: Array, response: Array, rate: float, *, near: float) -> float | None:
    """Find the frequency (Hz) above which a record lacks content of its fitted response; None if not below ``near``.

    A response with dry friction has corners, which a low-pass filter removes. Record and response are sampled at
    ``rate`` (Hz).
    """
    window = np.hanning(len(signal))
    measured, fitted = (
        np.abs(np.fft.rfft(window * (record - record.mean()))) ** 2 for record in (signal, response)
    )
    at = np.fft.rfftfreq(len(signal), 1.0 / rate)
    corner, top, lacks = (
        None,
        0.48 * rate,
        _STEADY,
    )  # noise adds content to a record and never removes it
    while np.count_nonzero(inside := (at > 0.5 * top) & (at <= top)) >= _LEAST:
        if float(np.median(fitted[inside])) <= lacks * float(np.median(measured[inside])):
            break
        corner = top = 0.5 * top
        lacks = _MORE
    return corner if corner is not None and corner < near else None
