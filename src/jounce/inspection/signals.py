"""Preparation of one wheel's signals: resampling, removal of the plate's inertia, moving section and turns."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError
from jounce.core.findings import Finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.inspection.record import FORCE, HEIGHT, SIDES, TACHO
from jounce.parts.testers import Tester, TesterLimits
from jounce.recordings.quality import check_time

if TYPE_CHECKING:
    import xarray as xr

_ACCELERATION_TIME, _ACCELERATION_ORDER = 0.021, 7
"""Length (s) and order of the polynomials used to compute a plate's acceleration.

At 1 kHz the error is 0.02 % at 25 Hz and 0.2 % at 40 Hz, and the noise 1/22 of that of second differences of
neighbouring samples.
"""
_BLOCK_TIME = 0.1  # s: one turn at 10 Hz; detrending a block leaves little more than 2 % of the body's oscillation
_OF_OTHER, _IDLE = (
    0.6,
    0.2,
)  # shares of the other plate's shaking and of the minimum stroke: motion transmitted through the car
_STANDSTILL, _LONG_STANDSTILL = 0.2, 2.0  # s of required standstill before or after a test
_STANDS = 0.1  # maximum coefficient of variation of a force without oscillation


@dataclass(frozen=True)
class WheelSignals:
    """Signals of one wheel, in SI."""

    wheel: str  # ``left`` or ``right``
    time: Array  # (n,): uniform time, s
    force: Array  # (n,): force of the plate on the tyre, without the plate's inertia, N
    height: Array | None  # (n,): height of the plate, m
    tacho: Array | None  # (n,): frequency of the exciter, Hz
    static_load: float | None  # from the header, N
    plate_mass: float  # mass whose inertia was subtracted, kg

    @property
    def sample_rate(self) -> float:
        """Samples per second, Hz."""
        return (self.time.size - 1) / float(self.time[-1] - self.time[0])

    def part(self, first: int, last: int) -> WheelSignals:
        """Return the samples from ``first`` up to but excluding ``last``."""
        cut = slice(first, last)
        return replace(
            self,
            time=self.time[cut],
            force=self.force[cut],
            height=None if self.height is None else self.height[cut],
            tacho=None if self.tacho is None else self.tacho[cut],
        )


@dataclass(frozen=True)
class PlateCalibration:
    """Calibration of a plate from a run without a wheel.

    Attributes
    ----------
    plate_mass : float
        Effective mass of the plate above the force cell, kg.
    residual_per_hz : float
        Maximum ratio of residual force, after inertia compensation, to frequency between 6 and 18 Hz, N/Hz.
    allowed_per_hz : float
        Allowed residual, N/Hz.
    standard_error : float
        Standard error of the mass, kg.
    """

    plate_mass: float
    residual_per_hz: float
    allowed_per_hz: float
    standard_error: float

    @property
    def is_passed(self) -> bool:
        """Whether the residual is within the allowed limit."""
        return self.residual_per_hz <= self.allowed_per_hz


def uniform_time(record: xr.Dataset, where: str = "record") -> tuple[xr.Dataset, list[Finding]]:
    """Check a record's clock and resample the channels to constant steps if allowed (jitter below 1 %).

    Raises
    ------
    RecordingError
        If the clock is unreliable.
    """
    time = np.asarray(record["time"].values, dtype=float)
    uniform, findings = check_time(time, where=where)
    if not findings:
        return record, []
    return record.interp(time=uniform, method="linear"), findings


def plate_acceleration(height: Array, sample_rate: float) -> Array:
    """Compute the acceleration (m/s^2) of a plate from its height (m), by polynomials over 21 ms; rate in Hz.

    Examples
    --------
    >>> t = np.arange(2000) / 1000.0
    >>> wave = 3e-3 * np.sin(2 * np.pi * 25.0 * t)
    >>> bool(abs(plate_acceleration(wave, 1000.0) / (2 * np.pi * 25.0) ** 2 + wave)[50:-50].max() < 5e-6)
    True
    """
    samples = max(
        2 * round(0.5 * (_ACCELERATION_TIME * sample_rate - 1.0)) + 1, _ACCELERATION_ORDER + 2
    )
    samples += 1 - samples % 2
    if height.size <= samples:
        return np.zeros_like(height)
    half = samples // 2
    inner = np.convolve(height, _curvature(samples) * sample_rate**2, mode="valid")
    return np.concatenate([np.full(half, inner[0]), inner, np.full(half, inner[-1])])


@lru_cache(maxsize=16)
def _curvature(samples: int) -> Array:
    """Return weights (1) for the second derivative, at the middle sample, of a 7th-order polynomial fit."""
    place = np.arange(samples) - samples // 2
    powers = (place[:, None] / samples) ** np.arange(_ACCELERATION_ORDER + 1)
    return np.asarray(np.linalg.pinv(powers)[2][::-1] * 2.0 / samples**2)


def limits_of(tester: Tester | None) -> TesterLimits:
    """Return the limits of a tester, or default limits if the tester is None."""
    return TesterLimits() if tester is None else tester.limits


def band_of(tester: Tester | None) -> tuple[float, float]:
    """Return the evaluated frequency band (Hz) of a sweep."""
    limits = limits_of(tester)
    return limits.frequency_min, limits.frequency_max


def signals_of(record: xr.Dataset, wheel: str, tester: Tester | None) -> WheelSignals:
    """Extract one wheel's signals from a uniformly sampled record and subtract the plate's inertia force."""
    height = _channel(record, f"{wheel}.{HEIGHT}")
    force = np.asarray(record[f"{wheel}.{FORCE}"].values, dtype=float)
    time = np.asarray(record["time"].values, dtype=float)
    mass = plate_mass_of(record.attrs, wheel, tester)
    load = record.attrs.get(f"{wheel}.static_load")
    if mass > 0.0 and height is not None:
        rate = (time.size - 1) / float(time[-1] - time[0])
        force = force - mass * plate_acceleration(height, rate)
    tacho = _channel(record, f"{wheel}.{TACHO}")
    return WheelSignals(
        wheel, time, force, height, tacho, None if load is None else float(load), mass
    )


def plate_mass_of(facts: dict[str, Any], wheel: str, tester: Tester | None) -> float:
    """Return the plate mass (kg) from the header or the tester; 0 if the cell measures the tyre force directly."""
    if tester is not None and tester.force_cell == "contact":
        return 0.0
    mass = facts.get(f"{wheel}.plate_mass")
    if mass is not None:
        return float(mass)
    return float(tester.plate_mass) if tester is not None else 0.0


def _channel(record: xr.Dataset, name: str) -> Array | None:
    return np.asarray(record[name].values, dtype=float) if name in record.data_vars else None


def moving_part(
    values: Array, sample_rate: float, least: float, other: Array | None = None
) -> tuple[int, int] | None:
    """Return the sample range in which a plate moves, in blocks of 0.1 s; None if it does not move.

    A block counts if its stroke (m) is above ``least`` m. The signals have shape (n,) and a rate in Hz. During a test
    of the ``other`` plate (m), a sprung plate is shaken through the car and then oscillates with the body. The range
    is therefore the one in which this plate is shaken more than the other; slow oscillations are ignored.
    """
    size = max(round(_BLOCK_TIME * sample_rate), 2)
    stroke = _strokes(values, size)
    moving = stroke > least
    if other is not None and bool(np.any(moving & (_strokes(other, size) > least))):
        blocks = _greatest_part(
            _bends(values, size) - _OF_OTHER * _bends(other, size) - _IDLE * least
        )
    else:
        blocks = np.flatnonzero(moving)
    if blocks.size == 0:
        return None
    return int(blocks[0] * size), int(min((blocks[-1] + 1) * size, values.size))


def mean_shaking(values: Array, sample_rate: float) -> float:
    """Return the mean stroke (m) of a plate in blocks of 0.1 s without slow motion; height (n,) in m, rate in Hz."""
    size = max(round(_BLOCK_TIME * sample_rate), 2)
    return float(np.mean(_bends(values, size))) if values.size >= size else 0.0


def _strokes(values: Array, size: int) -> Array:
    return np.asarray(np.ptp(_blocks(values, size), axis=1))


def _bends(values: Array, size: int) -> Array:
    """Return the stroke of each block after removing a linear trend, which suppresses slow oscillations."""
    blocks = _blocks(values, size)
    place = np.arange(size) - 0.5 * (size - 1)
    slope = blocks @ place / (place @ place)
    return np.asarray(np.ptp(blocks - slope[:, None] * place, axis=1))


def _blocks(values: Array, size: int) -> Array:
    return values[: values.size // size * size].reshape(-1, size)


def _greatest_part(gains: Array) -> NDArray[np.intp]:
    """Return the indices of the contiguous part of (n,) gains with the maximum sum; empty if no gain is positive."""
    sums = np.concatenate([[0.0], np.cumsum(gains)])
    lowest = np.minimum.accumulate(sums)
    last = int(np.argmax(sums - lowest))
    if sums[last] <= lowest[last]:
        return np.arange(0)
    return np.arange(int(np.argmin(sums[: last + 1])), last)


def standstill_force(
    signals: WheelSignals, moving: tuple[int, int], other: tuple[int, int] | None
) -> float | None:
    """Return the median force (N) before or, failing that, after the motion; None if the standstill is too short.

    Sections in which the wheel still oscillates are not used, because only means over whole periods are valid there.
    """
    rate, size = signals.sample_rate, signals.force.size
    before = moving[0] if other is None or other[0] > moving[0] else min(moving[0], other[0])
    if before >= max(round(_STANDSTILL * rate), 3):
        return float(np.median(signals.force[:before]))
    settled = moving[1] + round(rate)
    end = size if other is None or other[0] < moving[1] else other[0]
    if end - settled < _LONG_STANDSTILL * rate:
        return None
    after = signals.force[settled:end]
    return float(np.median(after)) if np.std(after) < _STANDS * abs(np.mean(after)) else None


def calibrate_plate(
    record: xr.Dataset, tester: Tester | None = None, *, wheel: str = ""
) -> PlateCalibration:
    """Find the effective mass of a plate from a run without a wheel on it.

    Parameters
    ----------
    record : xarray.Dataset
        Plate height (m) and force (N) over a sweep of the unloaded plate.
    tester : Tester, optional
        Tester with the limits to apply; 4 N/Hz by default.
    wheel : {"left", "right"}, optional
        Plate to calibrate; by default the only one in the record.

    Returns
    -------
    PlateCalibration
        Mass in kg, to be entered in the tester file or the header (``left.plate_mass``), and whether the residual is
        small enough between 6 and 18 Hz.

    Raises
    ------
    RecordingError
        If the plate height is missing, or the plate does not pass through 6 to 18 Hz.

    Examples
    --------
    >>> from jounce.parts.testers import Tester, TesterLimits
    >>> from jounce.recordings import recording
    >>> t = np.arange(12000) / 1000.0
    >>> z = 3e-3 * np.sin(2 * np.pi * (25.0 * t - t**2))
    >>> force = -18.0 * (2 * np.pi * (25.0 - 2.0 * t)) ** 2 * z
    >>> run = recording(t, {"left.plate.z": (z, "m", ""), "left.plate.force": (force, "N", "")})
    >>> found = calibrate_plate(run)
    >>> round(found.plate_mass, 1), found.is_passed
    (18.0, True)
    """
    side = wheel or next((name for name in SIDES if f"{name}.{FORCE}" in record.data_vars), "left")
    height, force = (_channel(record, f"{side}.{name}") for name in (HEIGHT, FORCE))
    if height is None or force is None:
        raise RecordingError(
            "a calibration needs plate height and force",
            where=side,
            found=", ".join(map(str, record.data_vars)),
        )
    time = np.asarray(record["time"].values, dtype=float)
    rate = (time.size - 1) / float(time[-1] - time[0])
    acceleration = plate_acceleration(height, rate)
    inner = slice(round(0.05 * rate), -round(0.05 * rate) - 1)
    pushed = acceleration[inner] - acceleration[inner].mean()
    pull = force[inner] - force[inner].mean()
    power = float(pushed @ pushed)
    if power <= 0.0:
        raise RecordingError("the plate does not move", where=f"{side}.{HEIGHT}")
    mass = float(pushed @ pull) / power
    residual = pull - mass * pushed
    per_hz = _residual_per_hz(time[inner], height[inner], residual, tester, f"{side}.{HEIGHT}")
    allowed = limits_of(tester).calibration_force_per_frequency
    return PlateCalibration(
        mass, per_hz, allowed, math.sqrt(float(residual @ residual) / power / max(pull.size - 2, 1))
    )


def _residual_per_hz(
    time: Array, height: Array, residual: Array, tester: Tester | None, where: str
) -> float:
    """Return the maximum ratio of residual amplitude to plate frequency, N/Hz, evaluated in half-second blocks."""
    middle = 0.5 * float(height.max() + height.min())
    turns = find_turns(time, height, middle, 0.5 * float(np.ptp(height)))
    low, high = band_of(tester)
    if turns is None or turns.frequency.max() < high or turns.frequency.min() > low:
        raise RecordingError(
            "the plate does not pass through the band",
            where=where,
            allowed=Phrase("{low:g} to {high:g} Hz", low=low, high=high),
        )
    frequency = turns.frequency_at(time)
    wave = residual * np.exp(-1j * turns.angle(time))
    size = max(round(0.5 / (time[1] - time[0])), 8)
    blocks = wave[: wave.size // size * size].reshape(-1, size).mean(axis=1)
    centre = frequency[: wave.size // size * size].reshape(-1, size).mean(axis=1)
    inside = (centre >= low) & (centre <= high)
    return float(np.max(2.0 * np.abs(blocks[inside]) / centre[inside]))


_HYSTERESIS = 0.3  # share of the amplitude, as protection against noise crossings
FEWEST_TURNS = 8  # minimum number of exciter turns of a test


@dataclass(frozen=True)
class Turns:
    """Turns of an oscillating plate."""

    # (n,): times (s) at which the plate passes its middle, alternately upwards and downwards, upwards first
    crossing: Array
    top: Array  # (m,): times (s) at which the plate is highest
    frequency: Array  # (m,): frequency (Hz) at these times
    angle: Any  # angle (rad) at times (s): 0 at the first upward crossing, tops at pi / 2 plus multiples of 2 pi

    def frequency_at(self, time: Array) -> Array:
        """Return the frequency in Hz at times in s."""
        return np.asarray(self.angle(time, 1) / (2.0 * np.pi))


def middle_crossings(
    time: Array, height: Array, middle: float, amplitude: float
) -> tuple[Array, bool]:
    """Find the times (s) at which a height (m) crosses its ``middle`` (m), and whether the first crossing is upwards.

    Excursions below 0.3 of the amplitude (m) are ignored.
    """
    away = height - middle
    far = np.flatnonzero(np.abs(away) > _HYSTERESIS * amplitude)
    if far.size < 2:
        return np.empty(0), True
    side = away[far] > 0.0
    turn = np.flatnonzero(side[1:] != side[:-1])
    changes = np.flatnonzero((away[1:] > 0.0) != (away[:-1] > 0.0))
    first = changes[np.searchsorted(changes, far[turn])]
    last = changes[np.searchsorted(changes, far[turn + 1]) - 1]
    step = time[1] - time[0]
    times = [time[i] + step * away[i] / (away[i] - away[i + 1]) for i in (first, last)]
    return 0.5 * (times[0] + times[1]), bool(turn.size) and not bool(side[turn[0]])


def find_turns(time: Array, height: Array, middle: float, amplitude: float) -> Turns | None:
    """Find the turns of an eccentric exciter from the height of its plate (m) on uniform time (s).

    Returns None if the plate makes fewer than 8 turns about its middle with the amplitude (m).
    """
    from scipy.interpolate import CubicSpline

    crossing, upwards = middle_crossings(time, height, middle, amplitude)
    crossing = crossing if upwards else crossing[1:]
    if crossing.size < 2 * FEWEST_TURNS:
        return None
    turn = np.pi * np.arange(crossing.size)
    when = CubicSpline(turn, crossing)
    tops = np.arange(0.5 * np.pi, turn[-1], 2.0 * np.pi)
    half = 0.5 / (crossing[1::2] - crossing[: 2 * (crossing.size // 2) : 2])
    slope = when(tops, 1)
    smooth = 1.0 / (2.0 * np.pi * np.where(slope > 0.0, slope, np.inf))
    frequency = np.where(
        np.abs(smooth / half - 1.0) < 0.3, smooth, half
    )  # the spline oscillates where a plate comes to rest
    return Turns(crossing, when(tops), frequency, CubicSpline(crossing, turn))
