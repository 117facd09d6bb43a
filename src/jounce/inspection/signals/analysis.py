"""One wheel's test taken apart: the quarter car that explains it, and the forces of every turn beside the model's."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import FitError
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.inspection.checks import problem, warning
from jounce.inspection.signals.conditioning import WheelSignals, plate_acceleration
from jounce.inspection.signals.course import Course
from jounce.inspection.signals.period_filter import force_in_periods
from jounce.inspection.signals.response_fit import ResponseFit, Stretch, fit_response, predicted_force, stretch_of

Complex = NDArray[np.complex128]
LOWEST_FIT, HIGHEST_FIT, LOWEST_TURN = 0.7, 40.0, 3.5  # Hz
UNDERFLOW = 0.01
_BOX_TIME = 0.009
_AFTER_LIFT_OFF = 0.06
_SHORTEST_STRETCH = 0.8
_WINDOW = (-0.12, 0.63)
_WHOLE_TURN = (-0.1, 1.1)
_TYRES = (5e4, 1.2e6)


@dataclass(frozen=True)
class Analysis:
    """What every turn shows, measured and modelled.

    Attributes
    ----------
    load : float
        Static load, N.
    fit : ResponseFit or None
        Quarter car; None where none could be fitted.
    top, frequency : ndarray, shape (n,)
        When the plate was at the top (s), and its frequency then (Hz).
    turn_frequency : ndarray, shape (n,)
        One over the time to the next top, Hz.
    measured, modelled : ndarray, shape (n, 7)
        See ``force_in_periods``; the model's are NaN where the tyre lifts off.
    lifted : ndarray of bool, shape (n,)
        Turns in which the tyre leaves the plate, or which are not yet over it.
    amplitude : float
        Of the plate, m; NaN where it is not known.
    """

    load: float
    fit: ResponseFit | None
    top: Array
    frequency: Array
    turn_frequency: Array
    measured: Array
    modelled: Array
    lifted: NDArray[np.bool_]
    amplitude: float


def find_lift_off(force: Array, load: float, sample_rate: float) -> NDArray[np.bool_]:
    """Samples (n,) in which the mean force (N) over 9 ms is below 1 % of the static load (N); rate in Hz."""
    size = max(round(_BOX_TIME * sample_rate), 1)
    sums = np.concatenate([[0.0], np.cumsum(force)])
    mean = (sums[size:] - sums[:-size]) / size
    low = np.zeros(force.size, dtype=bool)
    low[size // 2 : size // 2 + mean.size] = mean < UNDERFLOW * load
    return low


def stretches_between(lifted: NDArray[np.bool_], first: int, last: int, sample_rate: float) -> list[tuple[int, int]]:
    """Samples (from, up to) between ``first`` and ``last`` without lift-off that are long enough to be fitted (Hz)."""
    if not lifted[first:last].any():
        return [(first, last)]
    margin = max(round(_AFTER_LIFT_OFF * sample_rate), 1)
    flags = np.flatnonzero(lifted[first:last]) + first
    edges = np.concatenate([[first - margin], flags, [last + margin]])
    gaps = [(int(a) + margin, int(b) - margin) for a, b in pairwise(edges)]
    return [(a, b) for a, b in gaps if b - a >= _SHORTEST_STRETCH * sample_rate]


def analyse(signals: WheelSignals, course: Course, load: float) -> tuple[Analysis, list[Finding]]:
    """Fit a quarter car to one wheel's test on a rigid plate, and evaluate every turn.

    Parameters
    ----------
    signals : WheelSignals
        The test.
    course : Course
        Its turns.
    load : float
        Static load, N.

    Returns
    -------
    analysis : Analysis
        Turns from 1 s before the run-down on, down to 3 Hz.
    findings : list of Finding
        What is wrong with the fit.
    """
    rate, start = signals.sample_rate, float(signals.time[0])
    lifted = find_lift_off(signals.force, load, rate)
    model = np.full(signals.force.size, np.nan)
    fit, findings = None, list[Finding]()
    if signals.height is not None:
        first = max(round((course.begin - start) * rate), 0)
        end = min(round((float(course.turns.crossing[-1]) + 0.3 - start) * rate), signals.force.size)
        fit, findings = fit_test(signals, stretches_between(lifted, first, end, rate), load, course.highest, model)
    turns = course.turns
    kept = slice(course.hold.start, course.last + 1)
    used = (turns.frequency[kept] >= LOWEST_TURN) & (turns.top[kept] >= course.begin - 1e-9)
    top, frequency = turns.top[kept][used], turns.frequency[kept][used]
    following = np.append(np.diff(turns.top), np.nan)[kept][used]
    window = _WINDOW if signals.height is not None else _WHOLE_TURN
    rows = np.stack([signals.force, np.where(np.isfinite(model), model, load)])
    both = force_in_periods(rows, rate, start, top, frequency, load, window)
    off = _turns_hit(lifted | ~np.isfinite(model) if fit is not None else lifted, top, frequency, rate, start)
    both[1, off] = np.nan
    amplitude = 0.5 * float(np.ptp(signals.height)) if signals.height is not None else np.nan
    touched = _turns_hit(lifted, top, frequency, rate, start)
    return Analysis(load, fit, top, frequency, 1.0 / following, both[0], both[1], touched, amplitude), findings


def _turns_hit(flags: NDArray[np.bool_], top: Array, frequency: Array, rate: float, start: float) -> NDArray[np.bool_]:
    """Turns (n,) with a flagged sample between half a turn before and 1.2 turns after their top."""
    counts = np.concatenate([[0], np.cumsum(flags)])
    low = np.clip(((top - 0.5 / frequency - start) * rate).astype(int), 0, flags.size)
    high = np.clip(((top + 1.2 / frequency - start) * rate).astype(int), 0, flags.size)
    return np.asarray(counts[high] > counts[low])


def fit_test(
    signals: WheelSignals, parts: list[tuple[int, int]], load: float, highest: float, model: Array
) -> tuple[ResponseFit | None, list[Finding]]:
    """Fit a quarter car to parts of a test and write its force into ``model``.

    Parameters
    ----------
    signals : WheelSignals
        The test; heights are needed.
    parts : list of (int, int)
        Samples, from and up to.
    load, highest : float
        Static load (N) and highest frequency (Hz).
    model : ndarray, shape (n,)
        Is given the modelled force (N) in these parts.

    Returns
    -------
    fit : ResponseFit or None
        None where nothing resembles a quarter car.
    findings : list of Finding
        What is wrong.
    """
    height, place = signals.height, f"{signals.wheel}.plate.force"
    if height is None:
        return None, []
    high = min(1.08 * highest, HIGHEST_FIT)
    stretches = [
        stretch_of(height[a:b], signals.force[a:b] - load, signals.sample_rate, LOWEST_FIT, high) for a, b in parts
    ]
    try:
        fit = fit_response(stretches, load, where=place)
    except FitError as error:
        return None, [warning(place, "not_fitted", text=error.what)]
    strange = not _TYRES[0] < fit.corner.tyre_stiffness < _TYRES[1]
    doubtful = strange or fit.explained < 0.9
    if doubtful and _upside_down(signals, parts, load, high) > 0.5 * (1.0 + fit.explained):
        return None, [problem(f"{signals.wheel}.plate.z", "upside_down", fit.explained)]
    if strange or fit.explained < 0.3:
        stiffness = fit.corner.tyre_stiffness
        return None, [problem(place, "no_wheel", stiffness, stiffness=1e-3 * stiffness)]
    from scipy.fft import irfft

    predicted = [predicted_force(fit, one) for one in stretches]
    for (a, _), one, force in zip(parts, stretches, predicted, strict=True):
        spectrum = np.zeros(one.samples // 2 + 1, dtype=complex)
        lowest = round(one.s[0].imag / (2.0 * np.pi) * one.samples / signals.sample_rate)
        spectrum[lowest : lowest + one.s.size] = force
        model[a : a + one.samples] = irfft(spectrum, n=one.samples) + load
    left = [one.force - force for one, force in zip(stretches, predicted, strict=True)]
    return fit, _doubts(fit, stretches, left, signals, load)


def _upside_down(signals: WheelSignals, parts: list[tuple[int, int]], load: float, high: float) -> float:
    """Share (1) of the force that is explained when the height is turned over."""
    height = np.zeros(0) if signals.height is None else -signals.height
    inertia = signals.plate_mass * plate_acceleration(height, signals.sample_rate)
    force = signals.force - 2.0 * inertia - load  # it had been taken off with the wrong sign
    turned = [stretch_of(height[a:b], force[a:b], signals.sample_rate, LOWEST_FIT, high) for a, b in parts]
    return fit_response(turned, load).explained


def _doubts(
    fit: ResponseFit, stretches: list[Stretch], left: list[Complex], signals: WheelSignals, load: float
) -> list[Finding]:
    place = f"{signals.wheel}.plate.force"
    findings = []
    if fit.explained < 0.97:
        findings.append(warning(place, "poor_fit", fit.explained, percent=100.0 * fit.explained))
    for one, unexplained in zip(stretches, left, strict=True):
        size = 2.0 / one.samples * np.abs(unexplained)
        at = int(np.argmax(size))
        if size[at] > 0.01 * load and size[at] > 12.0 * float(np.median(size)):
            frequency = float(one.s[at].imag / (2.0 * np.pi))
            findings.append(warning(place, "vibrates", frequency, frequency=frequency, force=float(size[at])))
    return findings
