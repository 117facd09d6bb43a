"""Human exposure to vibration according to ISO 2631-1: mean values, doses, advice, comfort, daily exposure.

Signals are weighted accelerations (`jounce.ride.weighting`) at a constant rate; integrals over them are trapezoids.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import RecordingError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.recursion import first_order
from jounce.core.samples import as_samples
from jounce.core.types import Array
from jounce.core.units import as_number

Averaging = Literal["linear", "exponential"]
TIME_CONSTANT = 1.0  # s; ISO 2631-1, 6.3.1
LARGEST_CREST_FACTOR = 9.0  # 1; ISO 2631-1, 6.2.1
LARGEST_MTVV_RATIO, LARGEST_VDV_RATIO = 1.5, 1.75  # 1; ISO 2631-1, 6.3.3
SICK_PER_DOSE = (
    1.0 / 3.0 / 100.0
)  # share of people per m/s^1.5: ISO 2631-1, annex D, gives 1/3 in per cent
WORKING_DAY = 8.0 * 3600.0  # s; A(8) of directive 2002/44/EC
ACTION_VALUE, LIMIT_VALUE = 0.5, 1.15  # m/s^2; directive 2002/44/EC, article 3
COMFORT_FACTORS = {"x": 1.0, "y": 1.0, "z": 1.0}  # ISO 2631-1, 8.2.2
HEALTH_FACTORS = {"x": 1.4, "y": 1.4, "z": 1.0}  # ISO 2631-1, 7.2.3
COMFORT_SCALE: tuple[tuple[float, float, str], ...] = (
    (0.0, 0.315, "not uncomfortable"),
    (0.315, 0.63, "a little uncomfortable"),
    (0.5, 1.0, "fairly uncomfortable"),
    (0.8, 1.6, "uncomfortable"),
    (1.25, 2.5, "very uncomfortable"),
    (2.0, math.inf, "extremely uncomfortable"),
)
"""Lower and upper limit (m/s^2, vibration total value) and description of ISO 2631-1, C.2.3; ranges overlap."""


def integral(values: Array, sample_rate: float) -> float:
    """Integrate over the record by the trapezoidal rule: unit of ``values`` times s, with ``sample_rate`` in Hz."""
    return float(values.sum() - 0.5 * (values[0] + values[-1])) / sample_rate


def duration_of(values: Array, sample_rate: float) -> float:
    """Return the time from the first to the last sample, s (``values`` in any unit, ``sample_rate`` in Hz)."""
    return (values.size - 1) / sample_rate


def rms(values: ArrayLike, sample_rate: float) -> float:
    """Return the root mean square over the record, in the unit of ``values`` (rate in Hz)."""
    signal, sample_rate = _check_signal(values, sample_rate)
    return math.sqrt(integral(signal * signal, sample_rate) / duration_of(signal, sample_rate))


def running_rms(
    values: ArrayLike,
    sample_rate: float,
    *,
    averaging: Averaging = "linear",
    time_constant: float = TIME_CONSTANT,
) -> Array:
    """Compute the running r.m.s. of a weighted acceleration (m/s^2, rate in Hz), assumed zero before the record.

    ``"linear"`` averages over the last ``time_constant`` seconds (1 s in the standard); ``"exponential"`` uses weights
    that decay with this time constant. Shorter records raise an error.

    Notes
    -----
    Source: ISO 2631-1:1997, 6.3.1, equations 2 and 3 (``iso-2631-1``).
    """
    signal, sample_rate = _check_signal(values, sample_rate)
    total = duration_of(signal, sample_rate)
    if not total >= time_constant * (1.0 - 1e-9):  # rounding of (n - 1) / rate
        raise RecordingError(
            "the record is too short for the running r.m.s.",
            found=f"{total:g} s",
            allowed=f"{time_constant:g} s",
        )
    squares = signal * signal
    if averaging == "exponential":
        return np.asarray(np.sqrt(_decaying_mean(squares, 1.0 / (sample_rate * time_constant))))
    if averaging != "linear":
        raise unknown(
            str(averaging), ("linear", "exponential"), what="averaging", where="running r.m.s."
        )
    energy = np.concatenate([[0.0], np.cumsum(0.5 * (squares[1:] + squares[:-1]))]) / sample_rate
    index = np.arange(signal.size)
    before = np.interp(index - time_constant * sample_rate, index, energy)
    return np.asarray(np.sqrt(np.maximum(energy - before, 0.0) / time_constant))


def _decaying_mean(squares: Array, step: float) -> Array:
    """Solve ``time_constant y' = x - y`` from y = 0, x linear between samples; ``step`` is relative to the constant."""
    decay = math.exp(-step)
    lost = -math.expm1(-step) / step
    new, old = 1.0 - lost, lost - decay
    drive = np.concatenate([[0.0], new * squares[1:] + old * squares[:-1]])
    return np.asarray(np.maximum(first_order(drive, decay), 0.0))


def mtvv(values: ArrayLike, sample_rate: float, *, averaging: Averaging = "linear") -> float:
    """Return the MTVV, m/s^2: maximum running r.m.s. over 1 s of a weighted signal (rate in Hz)."""
    return float(running_rms(values, sample_rate, averaging=averaging).max())


def vdv(values: ArrayLike, sample_rate: float) -> float:
    """Return the fourth power vibration dose value of a weighted acceleration (m/s^2) at a rate in Hz; m/s^1.75."""
    signal, sample_rate = _check_signal(values, sample_rate)
    squares = signal * signal
    return float(integral(squares * squares, sample_rate) ** 0.25)


def evdv(values: ArrayLike, sample_rate: float) -> float:
    """Return the estimated vibration dose value (m/s^1.75), 1.4 r.m.s. T^(1/4), of values in m/s^2 at a rate in Hz."""
    signal, sample_rate = _check_signal(values, sample_rate)
    return float(1.4 * rms(signal, sample_rate) * duration_of(signal, sample_rate) ** 0.25)


def msdv(values: ArrayLike, sample_rate: float) -> float:
    """Return the motion sickness dose value of an acceleration (m/s^2) weighted by Wf, at a rate in Hz; m/s^1.5."""
    signal, sample_rate = _check_signal(values, sample_rate)
    return math.sqrt(integral(signal * signal, sample_rate))


def crest_factor(values: ArrayLike, sample_rate: float) -> float:
    """Return the largest absolute value over r.m.s. (1) of a weighted acceleration (m/s^2) at a rate in Hz."""
    signal, sample_rate = _check_signal(values, sample_rate)
    average = rms(signal, sample_rate)
    if not average > 0.0:
        raise RecordingError(
            "the signal is zero, so it has no crest factor",
            found="0 m/s^2",
            allowed="above 0 m/s^2",
        )
    return float(abs(signal).max()) / average


def total_value(
    values: Mapping[str, float], factors: Mapping[str, float] = COMFORT_FACTORS
) -> float:
    """Return the vibration total value, m/s^2: root sum of squares of axis ``values`` (m/s^2) times ``factors`` (1)."""
    return math.sqrt(sum((factors[axis] * value) ** 2 for axis, value in values.items()))


def comfort_words(acceleration: float) -> str:
    """Return likely reactions in public transport to a vibration total value in m/s^2; several if ranges overlap.

    >>> comfort_words(0.2), comfort_words(0.9)
    ('not uncomfortable', 'fairly uncomfortable to uncomfortable')
    """
    words = [text for low, high, text in COMFORT_SCALE if low <= acceleration <= high]
    return " to ".join(words)


def daily_exposure(acceleration: float, exposure: float = WORKING_DAY) -> float:
    """Return A(8) in m/s^2 of a health-weighted ``acceleration`` (m/s^2) with an ``exposure`` in s per day."""
    return acceleration * math.sqrt(exposure / WORKING_DAY)


def time_to_reach(value: float, acceleration: float) -> float:
    """Return the daily exposure in s at which A(8) of a health-weighted ``acceleration`` (m/s^2) reaches ``value``."""
    return math.inf if acceleration <= 0.0 else WORKING_DAY * (value / acceleration) ** 2


def advice(values: ArrayLike, sample_rate: float, *, place: str) -> tuple[Finding, ...]:
    """Report shocks in a weighted acceleration (m/s^2, rate in Hz) for which r.m.s. alone is not enough.

    The basic method (r.m.s.) is sufficient up to a crest factor of 9 (ISO 2631-1, 6.2.1). MTVV and VDV should also be
    reported if MTVV / a_w exceeds 1.5 or VDV / (a_w T^(1/4)) exceeds 1.75 (6.3.3).
    """
    signal, sample_rate = _check_signal(values, sample_rate)
    average, total = rms(signal, sample_rate), duration_of(signal, sample_rate)
    if average <= 0.0:
        return ()
    crest, dose = (
        crest_factor(signal, sample_rate),
        vdv(signal, sample_rate) / (average * total**0.25),
    )
    findings = []
    if crest > LARGEST_CREST_FACTOR:
        findings.append(finding("ride.crest_factor", place, crest, factor=crest))
    if total >= TIME_CONSTANT:
        ratio = mtvv(signal, sample_rate) / average
        if ratio > LARGEST_MTVV_RATIO:
            findings.append(finding("ride.mtvv", place, ratio, ratio=ratio))
    if dose > LARGEST_VDV_RATIO:
        findings.append(finding("ride.vdv", place, dose, dose=dose))
    return tuple(findings)


def _check_signal(values: ArrayLike, sample_rate: float) -> tuple[Array, float]:
    signal, sample_rate = (
        as_samples(values, where="signal"),
        as_number(sample_rate, "Hz", where="sample_rate"),
    )
    if signal.ndim != 1 or signal.size < 2 or not sample_rate > 0.0:
        raise RecordingError(
            "invalid signal",
            found=f"shape {signal.shape} at {sample_rate:g} Hz",
            allowed="at least 2 samples, with a sample rate",
        )
    return signal, sample_rate
