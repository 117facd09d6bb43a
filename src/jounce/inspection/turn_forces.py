"""Force in every turn of the plate, measured and from a fitted quarter car, and curves over frequency.

The same evaluation is applied to the measured and the modelled force. The difference of the two curves is noise where
the model is valid, and a smooth curve elsewhere (friction, kinked dampers). The smooth part is estimated by a Gaussian
process whose magnitude, often zero, maximises the likelihood (Rasmussen and Williams).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import FitError
from jounce.core.findings import Finding
from jounce.core.types import Array, Complex
from jounce.inspection.findings import problem, warning
from jounce.inspection.quarter_car import (
    POOR,
    TYRES,
    LinearQuarterCar,
    ResponseFit,
    Stretch,
    delay_of,
    fit_response,
    predicted_force,
    road_poles,
    stretch_of,
    wheel_damping,
)
from jounce.inspection.signals import WheelSignals, plate_acceleration
from jounce.inspection.sweep import Sweep
from jounce.kernel.call import Loop

PASS, STOP, RIPPLE = 2.0, 4.0, 0.01  # times the frequency of the turn, share: EGEA SPECSUS2018
_POINTS = 1025  # samples of the tabulated half of the filter
_find = Loop("turn_forces")
FIELDS = ("least", "least_time", "greatest", "down", "up", "mean", "half_amplitude")


@cache
def prototype() -> tuple[Array, float]:
    """Return one half of the filter's impulse response over time in periods (weight per period, 1), and its length.

    A sinc with Kaiser window between pass band (2 f) and stop band (4 f) with a ripple of 0.01 (EGEA SPECSUS2018). It
    is adjusted within that ripple to a gain of exactly 1 at 0, f and 2 f, so the filter does not bias amplitudes.
    """
    from scipy.signal import kaiser_beta
    from scipy.signal.windows import kaiser

    attenuation = -20.0 * math.log10(RIPPLE)
    half = 0.5 * (attenuation - 7.95) / (2.285 * 2.0 * math.pi * (STOP - PASS))
    window = kaiser(2 * _POINTS - 1, kaiser_beta(attenuation))[_POINTS - 1 :]
    u = np.linspace(0.0, half, _POINTS)
    weights = np.full(_POINTS, 2.0 * half / (_POINTS - 1))
    weights[[0, -1]] *= 0.5
    waves = np.cos(2.0 * np.pi * np.outer(np.arange(3), u))
    taps = window * (STOP + PASS) * np.sinc((STOP + PASS) * u)
    gains = (waves * window * weights) @ waves.T
    taps += window * (np.linalg.solve(gains, 1.0 - (waves * weights) @ taps) @ waves)
    taps.setflags(write=False)
    return taps, half


def force_in_periods(
    signals: Array,
    rate: float,
    start: float,
    tops: Array,
    frequencies: Array,
    level: float,
    window: tuple[float, float],
) -> Array:
    """Evaluate forces in each period of the plate after a low pass matched to the period.

    Forces (rows, n) in N are sampled at ``rate`` Hz from ``start`` s; ``tops`` (s) are the times at which the plate is
    highest, with the frequencies (Hz) at these times. The minimum force is searched for in a ``window`` of periods
    after the top, and around it the crossings of a ``level`` (N), or of the middle if the level is never crossed.
    Returns (rows, periods, 7) in the order of ``FIELDS``: minimum force (N) and its time (s), maximum force (N) in the
    period around it, times (s) of the fall below the level before and the rise above it after the minimum, mean force
    (N), and half of maximum minus minimum (N). NaN outside the record or if the minimum is at the window's end.
    """
    taps, half = prototype()
    block, places, at = (
        np.ascontiguousarray(values, dtype=np.float64) for values in (signals, tops, frequencies)
    )
    forces = np.full((len(block), len(places), len(FIELDS)), np.nan)
    longest = rate / at.min()
    smooth, room = (
        np.empty(int(longest * (window[1] - window[0] + 1.2)) + 8),
        int(half * longest) + 2,
    )
    weight, wave, bell = np.empty(2 * room), np.empty(room), np.empty(room)
    _find(
        block,
        rate,
        start,
        places,
        at,
        level,
        taps,
        half,
        *window,
        smooth,
        weight,
        wave,
        bell,
        forces,
    )
    return forces


_SIZES = np.array([0.3, 0.6, 1.2, 2.5, 5.0, 10.0, 30.0, 100.0, 1000.0])
_BELIEVED = 2.0  # minimum gain in log likelihood over zero magnitude: two standard errors
_FLOOR = 1e-9  # share of the largest difference: noise floor for records without noise
_FEWEST = 8  # minimum number of turns for smoothing
_SAME = 0.06  # Hz: turns closer than this, as in a hold, are merged


@dataclass(frozen=True)
class FrequencyCurve:
    """A quantity over frequency."""

    frequency: Array  # (n,): ascending, Hz
    value: Array  # (n,): the quantity
    error: Array  # (n,): standard error of the correction to the model, unit of the quantity

    def with_turns(self, frequency: Array, value: Array) -> FrequencyCurve:
        """Add turns (Hz, unit of the quantity) without a measurement."""
        both = np.concatenate([self.frequency, frequency])
        order = np.argsort(both, kind="stable")
        order = order[np.diff(both[order], prepend=-1.0) > 1e-6]
        unknown = np.concatenate([self.error, np.zeros(frequency.size)])
        return FrequencyCurve(
            both[order], np.concatenate([self.value, value])[order], unknown[order]
        )

    def at(self, frequency: Array, otherwise: Array) -> Array:
        """Return the curve at frequencies (Hz), and ``otherwise`` outside its range; unit of the quantity."""
        from scipy.interpolate import CubicSpline

        if self.frequency.size < _FEWEST:
            return otherwise
        inside = (frequency >= self.frequency[0]) & (frequency <= self.frequency[-1])
        return np.where(inside, CubicSpline(self.frequency, self.value)(frequency), otherwise)

    def lowest(self) -> tuple[float, float, float]:
        """Return frequency (Hz), value and error of the turn with the minimum value."""
        at = int(np.argmin(self.value))
        return float(self.frequency[at]), float(self.value[at]), float(self.error[at])

    def least(self, low: float, high: float) -> tuple[float, float, float] | None:
        """Return frequency (Hz), value and error of the minimum between two frequencies (Hz), ends included.

        None if the curve does not cover both ends.
        """
        from scipy.interpolate import CubicSpline

        f = self.frequency
        if f.size < 4 or f[0] > low + 1e-6 or f[-1] < high - 1e-6:
            return None
        grid = np.linspace(low, high, 1 + int(np.ceil((high - low) / 0.02)))
        near = slice(max(np.searchsorted(f, low) - 3, 0), np.searchsorted(f, high) + 3)
        values = CubicSpline(f[near], self.value[near])(grid)
        at = int(np.argmin(values))
        return float(grid[at]), float(values[at]), float(np.interp(grid[at], f, self.error))


def corrected_curve(
    frequency: Array, measured: Array, modelled: Array, spread: Array, length: float
) -> FrequencyCurve:
    """Correct a modelled curve by a measured one; frequencies in Hz in any order, NaN if unknown.

    ``spread`` is the relative noise of the measured values, in any scale; ``length`` (Hz) is the correlation length of
    the model error. The returned curve is sorted by frequency, without duplicates.
    """
    known = np.isfinite(measured) & np.isfinite(modelled) & (spread > 0.0)
    order = np.argsort(frequency[known], kind="stable")
    f, y, base, wide = _merge_turns(
        *(values[known][order] for values in (frequency, measured, modelled, spread))
    )
    if f.size < _FEWEST:
        return FrequencyCurve(f, y, np.full(f.size, np.nan))
    gap = y - base
    if not np.any(gap):
        return FrequencyCurve(f, y, np.zeros(f.size))
    noise = wide * _noise(gap, wide)
    added, error = _posterior(f, gap, noise, length)
    return FrequencyCurve(f, base + added, error)


def _merge_turns(f: Array, y: Array, base: Array, wide: Array) -> tuple[Array, Array, Array, Array]:
    """Average turns at nearly the same frequency."""
    starts = np.flatnonzero(np.diff(np.floor(f / _SAME), prepend=-1.0))
    if starts.size == f.size:
        return f, y, base, wide
    counts = np.diff(np.append(starts, f.size))
    means = [np.add.reduceat(values, starts) / counts for values in (f, y, base)]
    return means[0], means[1], means[2], np.sqrt(np.add.reduceat(wide**2, starts)) / counts


def _noise(gap: Array, wide: Array) -> float:
    """Estimate the noise from jumps between neighbouring values, in units of ``wide``."""
    second = gap[:-2] - 2.0 * gap[1:-1] + gap[2:]
    scale = np.sqrt(wide[:-2] ** 2 + 4.0 * wide[1:-1] ** 2 + wide[2:] ** 2)
    jumps = float(np.median(np.abs(second) / scale)) / 0.6745
    return max(jumps, _FLOOR * float(np.max(np.abs(gap) / wide)), 1e-300)


def _posterior(f: Array, gap: Array, noise: Array, length: float) -> tuple[Array, Array]:
    """Return mean and standard error of the smooth part of ``gap``; zero if it is not significant.

    The process is expanded in cosines over the band, weighted by its kernel's spectrum (Solin and Sarkka).
    """
    reach = float(f[-1] - f[0]) + 2.0 * length
    order = np.arange(min(int(2.0 * reach / length) + 2, f.size // 2))
    weight = np.exp(-0.25 * (np.pi * order * length / reach) ** 2)
    basis = np.cos(np.pi * np.outer((f - f[0] + length) / reach, order)) * weight
    basis *= math.sqrt(1.0 / float(np.mean(np.sum(basis**2, axis=1))))
    white = basis / noise[:, None]
    values, vectors = np.linalg.eigh(white.T @ white)
    values = np.maximum(values, 0.0)
    along = vectors.T @ (white.T @ (gap / noise))
    rises = (_SIZES * float(np.median(noise))) ** 2
    grown = np.outer(rises, values)
    likelihoods = 0.5 * np.sum(np.outer(rises, along**2) / (1.0 + grown) - np.log1p(grown), axis=1)
    best = int(np.argmax(likelihoods))
    chosen = rises[best] if likelihoods[best] > _BELIEVED else 0.0
    shares = chosen / (1.0 + chosen * values)
    turned = basis @ vectors
    return turned @ (shares * along), np.sqrt((turned**2) @ shares)


LOWEST_FIT, HIGHEST_FIT = 0.7, 40.0  # Hz: from below body bounce to above exciter frequencies
LOWEST_TURN = 3.5  # Hz: well below the evaluated band, for curves that extend beyond its end
UNDERFLOW = 0.01  # share of the static load below which a force means lift-off
_BOX_TIME = 0.009  # s: averaging time for lift-off detection, against sample noise
_AFTER_LIFT_OFF = 0.06  # s omitted before and after lift-off
_SHORTEST_STRETCH = 0.8  # s: shorter stretches have spectral lines more than 1.25 Hz apart
_WINDOW = (-0.12, 0.63)
"""Search window of the minimum force in periods after the plate's top: phase angles of -43 to 227 degrees."""
_WHOLE_TURN = (-0.1, 1.1)  # used without a height, when the turn's phase is unknown
_UNDAMPED, _OWN = (
    0.05,
    0.2,
)  # damping ratio, and relative shift of the wheel's natural frequency by lift-off
_HIGHEST_OF_BODY = 2.5  # Hz; the body also heaves, pitches and rolls on the other wheels


@dataclass(frozen=True)
class Analysis:
    """Results of every turn, measured and modelled."""

    load: float  # static load, N
    fit: ResponseFit | None  # fitted quarter car; None if the fit failed
    top: Array  # (n,): times at which the plate is highest, s
    frequency: Array  # (n,): frequency at these times, Hz
    turn_frequency: Array  # (n,): reciprocal of the time to the next top, Hz
    measured: Array  # (n, 7): see ``force_in_periods``
    modelled: Array  # (n, 7): same values of the model, NaN where the tyre lifts off
    lifted: NDArray[np.bool_]  # (n,): turns with lift-off, or still affected by it
    amplitude: float  # of the plate, m; NaN if unknown


def find_lift_off(force: Array, load: float, sample_rate: float) -> NDArray[np.bool_]:
    """Flag samples (n,) whose mean force (N) over 9 ms is below 1 % of the static load (N); rate in Hz."""
    size = max(round(_BOX_TIME * sample_rate), 1)
    sums = np.concatenate([[0.0], np.cumsum(force)])
    mean = (sums[size:] - sums[:-size]) / size
    low = np.zeros(force.size, dtype=bool)
    low[size // 2 : size // 2 + mean.size] = mean < UNDERFLOW * load
    return low


def stretches_between(
    lifted: NDArray[np.bool_], first: int, last: int, sample_rate: float
) -> list[tuple[int, int]]:
    """Return sample ranges from ``first`` to ``last`` without lift-off, long enough for a fit; rate in Hz."""
    if not lifted[first:last].any():
        return [(first, last)]
    margin = max(round(_AFTER_LIFT_OFF * sample_rate), 1)
    flags = np.flatnonzero(lifted[first:last]) + first
    edges = np.concatenate([[first - margin], flags, [last + margin]])
    gaps = [(int(a) + margin, int(b) - margin) for a, b in pairwise(edges)]
    return [(a, b) for a, b in gaps if b - a >= _SHORTEST_STRETCH * sample_rate]


def analyse(signals: WheelSignals, sweep: Sweep, load: float) -> tuple[Analysis, list[Finding]]:
    """Fit a quarter car to one wheel's test on a rigid plate, and evaluate every turn under a static load (N).

    Includes turns from 1 s before the sweep down to 3.5 Hz; the findings report problems of the fit.
    """
    rate, start = signals.sample_rate, float(signals.time[0])
    lifted = find_lift_off(signals.force, load, rate)
    model = np.full(signals.force.size, np.nan)
    fit, findings = None, list[Finding]()
    if signals.height is not None:
        first = max(round((sweep.begin - start) * rate), 0)
        end = min(round((float(sweep.turns.crossing[-1]) + 0.3 - start) * rate), signals.force.size)
        fit, findings = fit_test(
            signals, stretches_between(lifted, first, end, rate), load, sweep.highest, model
        )
    turns = sweep.turns
    span = slice(sweep.hold.start, sweep.last + 1)
    used = (turns.frequency[span] >= LOWEST_TURN) & (turns.top[span] >= sweep.begin - 1e-9)
    top, frequency = turns.top[span][used], turns.frequency[span][used]
    following = np.append(np.diff(turns.top), np.nan)[span][used]
    window = _WINDOW if signals.height is not None else _WHOLE_TURN
    rows = np.stack([signals.force, np.where(np.isfinite(model), model, load)])
    both = force_in_periods(rows, rate, start, top, frequency, load, window)
    off = _turns_hit(
        lifted | ~np.isfinite(model) if fit is not None else lifted, top, frequency, rate, start
    )
    both[1, off] = np.nan
    amplitude = 0.5 * float(np.ptp(signals.height)) if signals.height is not None else np.nan
    touched = _turns_hit(lifted, top, frequency, rate, start)
    return Analysis(
        load, fit, top, frequency, 1.0 / following, both[0], both[1], touched, amplitude
    ), findings


def _turns_hit(
    flags: NDArray[np.bool_], top: Array, frequency: Array, rate: float, start: float
) -> NDArray[np.bool_]:
    """Flag turns (n,) with a flagged sample between half a turn before and 1.2 turns after their top."""
    counts = np.concatenate([[0], np.cumsum(flags)])
    low = np.clip(((top - 0.5 / frequency - start) * rate).astype(int), 0, flags.size)
    high = np.clip(((top + 1.2 / frequency - start) * rate).astype(int), 0, flags.size)
    return np.asarray(counts[high] > counts[low])


def fit_test(
    signals: WheelSignals,
    parts: list[tuple[int, int]],
    load: float,
    highest: float,
    model: Array,
    *,
    upright: bool = False,
) -> tuple[ResponseFit | None, list[Finding]]:
    """Fit a quarter car to parts (sample ranges) of a test with heights, and write its force into ``model`` (N).

    Static load in N, highest frequency in Hz; ``upright`` means that the sign of the height is known to be correct.
    None if no quarter car resembles the test; the findings report problems.
    """
    height, place = signals.height, f"{signals.wheel}.plate.force"
    if height is None:
        return None, []
    high = min(1.08 * highest, HIGHEST_FIT)
    stretches = [
        stretch_of(height[a:b], signals.force[a:b] - load, signals.sample_rate, LOWEST_FIT, high)
        for a, b in parts
    ]
    try:
        fit = fit_response(stretches, load, where=place)
    except FitError as error:
        return None, [warning(place, "not_fitted", text=error.what)]
    strange = not TYRES[0] < fit.corner.tyre_stiffness < TYRES[1]
    doubtful = strange or fit.explained < 0.9  # a height with the wrong sign is worth another fit
    # The inverted height must explain more than half of the current residual.
    if (
        doubtful
        and not upright
        and _upside_down(signals, parts, load, high) > 0.5 * (1.0 + fit.explained)
    ):
        return None, [problem(f"{signals.wheel}.plate.z", "upside_down", fit.explained)]
    if (
        strange or fit.explained < 0.3
    ):  # a car without dampers, which is not a pure quarter car, reaches 0.75
        stiffness = fit.corner.tyre_stiffness
        return None, [problem(place, "no_wheel", stiffness, stiffness=1e-3 * stiffness)]
    fit = replace(fit, delay=delay_of(fit, stretches, signals.plate_mass))
    from scipy.fft import irfft

    predicted = [predicted_force(fit, stretch) for stretch in stretches]
    for (a, _), stretch, force in zip(parts, stretches, predicted, strict=True):
        spectrum = np.zeros(stretch.samples // 2 + 1, dtype=complex)
        lowest = round(stretch.s[0].imag / (2.0 * np.pi) * stretch.samples / signals.sample_rate)
        spectrum[lowest : lowest + stretch.s.size] = force
        model[a : a + stretch.samples] = irfft(spectrum, n=stretch.samples) + load
    left = [stretch.force - force for stretch, force in zip(stretches, predicted, strict=True)]
    return fit, _doubts(fit, stretches, left, signals, load)


def _upside_down(
    signals: WheelSignals, parts: list[tuple[int, int]], load: float, high: float
) -> float:
    """Return the share (1) of the force that is explained with an inverted height."""
    height = np.zeros(0) if signals.height is None else -signals.height
    inertia = signals.plate_mass * plate_acceleration(height, signals.sample_rate)
    force = signals.force - 2.0 * inertia - load  # it was subtracted with the wrong sign
    turned = [
        stretch_of(height[a:b], force[a:b], signals.sample_rate, LOWEST_FIT, high) for a, b in parts
    ]
    return fit_response(turned, load).explained


def _doubts(
    fit: ResponseFit,
    stretches: list[Stretch],
    left: list[Complex],
    signals: WheelSignals,
    load: float,
) -> list[Finding]:
    place = f"{signals.wheel}.plate.force"
    findings = []
    if fit.explained < POOR:
        findings.append(warning(place, "poor_fit", fit.explained, percent=100.0 * fit.explained))
    for stretch, unexplained in zip(stretches, left, strict=True):
        size = 2.0 / stretch.samples * np.abs(unexplained)
        at = int(np.argmax(size))
        # For noise with Rayleigh-distributed lines, six times the median is very rare, and twelve times even more so.
        if size[at] > 0.01 * load and size[at] > 12.0 * float(np.median(size)):
            frequency = float(stretch.s[at].imag / (2.0 * np.pi))
            code = "swings_on" if _is_own(frequency, fit.corner) else "vibrates"
            findings.append(
                warning(place, code, frequency, frequency=frequency, force=float(size[at]))
            )
    return findings


def _is_own(frequency: float, corner: LinearQuarterCar) -> bool:
    """Whether a frequency (Hz) is a nearly undamped oscillation of the wheel or of the body above it."""
    ratio, own = wheel_damping(road_poles(corner))
    return ratio < _UNDAMPED and (frequency < _HIGHEST_OF_BODY or abs(frequency / own - 1.0) < _OWN)
