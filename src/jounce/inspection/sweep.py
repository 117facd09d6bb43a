"""Detection and checks of the frequency sweep of a test."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.inspection.checks import check_exciter
from jounce.inspection.findings import problem, warning
from jounce.inspection.signals import (
    FEWEST_TURNS,
    Turns,
    WheelSignals,
    band_of,
    find_turns,
    limits_of,
    plate_acceleration,
)

if TYPE_CHECKING:
    from jounce.parts.testers import Tester

HIGHEST_SHARE = 0.985  # share of the highest frequency above which a turn belongs to the hold
_WAIT = 1.0  # s of the hold that are evaluated
_SLOW_TIME, _PASSES = 0.25, 2
"""Length (s) of the moving average that is subtracted from a height, and number of passes.

Two passes leave 1 % of an oscillation at 1 Hz, 13 % at 2 Hz, and all of it from 4 Hz upwards.
"""
_RESONANCE, _BELOW_RESONANCE = (
    7.0,
    5.0,
)  # Hz: a sweep must fall below the first; falls below the second are counted
_LASTING = 5  # minimum number of turns beyond these frequencies
_QUIET_SHARE = 0.12  # an eighth: see ``turns_of``
_SLOWEST_TURN, _ODD_TURN, _FAST_CHANGE = (
    5.0,
    0.06,
    0.3,
)  # Hz; relative differences of turns from their neighbours, and over two turns
SWINGS = 0.5
"""Correlation of a plate's spring force with its height above which the plate oscillates on its spring.

An Audi A6 on the shipped sprung testers gives 0.1 with its dampers, 0.3 to 0.4 with 30 % of them, 0.7 to 0.8 with 5 %.
"""
_FORCE_TIME = 0.011  # s: averaging time of forces, which attenuates 18 Hz by 6 %


@dataclass(frozen=True)
class Sweep:
    """Turns of a test and its downward or upward sweep."""

    turns: Turns  # of the exciter
    first: int  # turn at which the hold ends and the frequency starts to fall
    last: int  # turn with the lowest frequency
    hold: slice  # turns of the hold
    sweep_rate: (
        float  # maximum rate of the frequency within 6 to 18 Hz (or over the whole sweep), Hz/s
    )

    @property
    def highest(self) -> float:
        """Frequency of the hold, Hz."""
        return float(np.median(self.turns.frequency[self.hold]))

    @property
    def begin(self) -> float:
        """Start time of the evaluated part, up to 1 s before the frequency falls, s."""
        return float(max(self.turns.top[self.hold][0], self.turns.top[self.first] - _WAIT))


def find_sweep(
    signals: WheelSignals, tester: Tester | None, *, rigid: bool
) -> tuple[Sweep | None, list[Finding]]:
    """Find turns and sweep of a test, with findings; None with the reason if there is no sweep.

    The signals span the plate's motion with a short margin. On a rigid plate the frequency must fall through the
    tester's band (18 to 6 Hz); a sprung plate may be swept in either direction.
    """
    turns = turns_of(signals, None if rigid else tester)
    place = (
        f"{signals.wheel}.plate.z"
        if signals.height is not None
        else f"{signals.wheel}.plate.frequency"
    )
    if turns is None:
        return None, [problem(place, "few_turns", fewest=FEWEST_TURNS)]
    low, high = band_of(tester)
    if not rigid:
        exciter = exciter_height(signals, tester)
        amplitude = 0.5 * tester.stroke  # type: ignore[union-attr]
        driven = None if exciter is None else find_turns(signals.time, exciter, 0.0, amplitude)
        whole = _whole_sweep(driven or turns)
        swings = spring_against_height(signals, tester) < -SWINGS
        findings = _sprung_findings(whole, place)
        if driven is not None and exciter is not None and tester is not None:
            swept = driven.top[turns_of_sweep(driven.frequency, driven.top)]
            if swept.size > 0:
                span = float(swept.min()), float(swept.max())
                findings += check_exciter(exciter, signals, driven, span, tester)
        return whole if swings else _whole_sweep(turns), findings
    frequency = turns.frequency
    top = float(np.percentile(frequency, 95.0))
    lowest = float(frequency.min())
    words = {"low": lowest, "top": top}
    if top < high:
        return None, [problem(place, "never_high", top, high=high, **words)]
    begin = 0.5 * (top + high) if top > high else high
    falls = _falls(frequency, begin, low)
    if falls == 0:
        rises = _falls(frequency[::-1], begin, low)
        code = "no_sweep" if lowest > high else "sweep_up" if rises else "sweep_cut_off"
        return None, [problem(place, code, lowest, **words)]
    if falls > 1:
        return None, [problem(place, "several_sweeps", float(falls), count=falls)]
    if missing := _missing_rows(turns, place):
        return None, missing
    first = int(np.flatnonzero(frequency >= HIGHEST_SHARE * top)[-1])
    last = first + int(np.argmin(frequency[first:]))
    begun = first
    while (
        begun > 0 and frequency[begun - 1] > 0.97 * top
    ):  # slightly below its end, so noise does not truncate the hold
        begun -= 1
    rate = _rate(turns.top[first : last + 1], frequency[first : last + 1], low, high)
    sweep = Sweep(turns, first, last, slice(begun, first + 1), rate)
    return sweep, _sweep_findings(sweep, tester, place)


def _missing_rows(turns: Turns, place: str) -> list[Finding]:
    """Report lost rows from turns longer or shorter than their neighbours; a heavy drive's frequency is smooth.

    A pause of the drive lasts longer than two turns, unlike a turn with lost rows.
    """
    times = turns.crossing[::2]
    lengths = np.diff(times)
    usual = 0.5 * (lengths[:-2] + lengths[2:])
    share, beside = lengths[1:-1] / usual, lengths[2:] / np.maximum(lengths[:-2], 1e-12)
    # Below 5 Hz the speed of a decelerating plate changes within a turn.
    steady = (usual < 1.0 / _SLOWEST_TURN) & (share < 2.0) & (np.abs(beside - 1.0) < _FAST_CHANGE)
    away = np.where(steady, np.abs(share - 1.0), 0.0)
    if away.max(initial=0.0) < _ODD_TURN:
        return []
    at = int(np.argmax(away))
    words = {
        "time": float(times[at + 1]),
        "turn": 1e3 * float(lengths[at + 1]),
        "usual": 1e3 * float(usual[at]),
    }
    return [problem(place, "rows_missing", float(away[at]), **words)]


def _sprung_findings(sweep: Sweep, place: str) -> list[Finding]:
    """Check that the sweep of a sprung plate passes the wheel's resonance exactly once."""
    frequency, top = sweep.turns.frequency, sweep.highest
    middle = np.median(
        np.lib.stride_tricks.sliding_window_view(np.pad(frequency, 2, mode="edge"), 5), axis=1
    )
    low = min(_BELOW_RESONANCE, 0.4 * top)
    falls, rises = (
        _falls(_lasting(series, 0.75 * top, low), 0.75 * top, low)
        for series in (middle, middle[::-1])
    )
    if falls > 1:
        return [problem(place, "several_sweeps", float(falls), count=falls)]
    lowest = float(middle.min())
    # For testers that do not start at 25 Hz, frequencies are relative to the highest one.
    if falls + rises == 0 and lowest > min(_RESONANCE, 0.6 * top):
        code = "no_sweep" if lowest > 0.75 * top else "sweep_cut_off"
        return [problem(place, code, lowest, low=lowest, top=top)]
    return []


def _lasting(frequency: Array, high: float, low: float) -> Array:
    """Return frequencies (n,) in Hz of stretches above ``high`` or below ``low`` that last several turns."""
    level = np.where(frequency >= high, 1, np.where(frequency <= low, -1, 0))
    ends = np.append(np.flatnonzero(np.diff(level)) + 1, level.size)
    begins = np.append(0, ends[:-1])
    lasting = ends - begins >= _LASTING
    return np.asarray(frequency[np.repeat(lasting, ends - begins)])


def _whole_sweep(turns: Turns) -> Sweep:
    """Return a sweep over all turns; sprung plates may be swept in either direction."""
    frequency = turns.frequency
    top = float(np.percentile(frequency, 95.0))
    at_top = np.flatnonzero(frequency >= HIGHEST_SHARE * top)
    rate = _rate(turns.top, frequency, 0.5 * top, top)
    return Sweep(
        turns, int(at_top[-1]), frequency.size - 1, slice(int(at_top[0]), int(at_top[-1]) + 1), rate
    )


def turns_of(signals: WheelSignals, tester: Tester | None = None) -> Turns | None:
    """Find turns from the plate's height or, without it, from the tacho (then with unknown phase).

    On the sprung plate of a ``tester`` turns may be as small as an eighth of the exciter's or of the largest, and may
    be superimposed on slow motion of the car.
    """
    if signals.height is not None:
        middle = 0.5 * float(signals.height.max() + signals.height.min())
        amplitude = 0.5 * float(np.ptp(signals.height))
        if tester is None:
            return find_turns(signals.time, signals.height, middle, amplitude)
        quick = signals.height
        for _ in range(_PASSES):
            quick = quick - _slow_part(quick, signals.sample_rate)
        return find_turns(
            signals.time, quick, 0.0, _QUIET_SHARE * min(amplitude, 0.5 * tester.stroke)
        )
    if signals.tacho is None:
        return None
    steps = 0.5 * (signals.tacho[1:] + signals.tacho[:-1]) * np.diff(signals.time)
    angle = 2.0 * np.pi * np.concatenate([[0.0], np.cumsum(steps)])
    return find_turns(signals.time, np.sin(angle), 0.0, 1.0)


def spring_against_height(signals: WheelSignals, tester: Tester | None) -> float:
    """Return the correlation (-1 to 1) of the plate's spring force with the plate's height.

    Near -1 the plate oscillates freely on its spring; near 1 the height is inverted, because a spring pushes back. 0
    if nothing moves.
    """
    if signals.height is None or tester is None:
        return 0.0
    height, force = signals.height - signals.height.mean(), _spring_force(signals, tester)
    size = float(np.linalg.norm(height) * np.linalg.norm(force))
    return float(height @ force) / size if size > 0.0 else 0.0


def _spring_force(signals: WheelSignals, tester: Tester) -> Array:
    """Return the spring force (n,) in N on a plate about its mean: tyre force plus the plate's inertia."""
    mass = signals.plate_mass or tester.plate_mass
    height = np.zeros_like(signals.force) if signals.height is None else signals.height
    force = signals.force + mass * plate_acceleration(height, signals.sample_rate)
    return np.asarray(force - force.mean())


def exciter_height(signals: WheelSignals, tester: Tester | None) -> Array | None:
    """Compute the exciter's height (n,) in m under a sprung plate: plate height plus spring deflection.

    It is needed because an undamped wheel oscillates at its natural frequency, together with the plate. None if the
    spring or the plate's height is unknown.
    """
    if signals.height is None or tester is None or tester.plate_spring_rate is None:
        return None
    half = max(round(0.5 * _FORCE_TIME * signals.sample_rate), 1)
    padded = np.pad(_spring_force(signals, tester), half, mode="edge")
    smooth = np.convolve(padded, np.full(2 * half + 1, 1.0 / (2 * half + 1)), mode="valid")
    return np.asarray(signals.height - signals.height.mean() + smooth / tester.plate_spring_rate)


def _slow_part(height: Array, sample_rate: float) -> Array:
    """Return the moving average of a height (n,) in m over 0.25 s; the rate is in Hz."""
    half = min(max(round(0.5 * _SLOW_TIME * sample_rate), 1), (height.size - 1) // 2)
    sums = np.concatenate([[0.0], np.cumsum(np.pad(height, half, mode="edge"))])
    return np.asarray((sums[2 * half + 1 :] - sums[: -2 * half - 1]) / (2 * half + 1))


def _falls(frequency: Array, high: float, low: float) -> int:
    """Count how often the frequency (Hz) falls from above ``high`` to below ``low``."""
    level = np.where(frequency >= high, 1, np.where(frequency <= low, -1, 0))
    level = level[level != 0]
    return int(np.count_nonzero((level[:-1] == 1) & (level[1:] == -1)))


def _rate(time: Array, frequency: Array, low: float, high: float) -> float:
    """Return the maximum rate of change in the band over five turns, Hz/s."""
    if time.size < 8:
        return 0.0
    rate = np.abs(frequency[5:] - frequency[:-5]) / (time[5:] - time[:-5])
    inside = (frequency[5:] >= low) & (frequency[:-5] <= high)
    return float(rate[inside].max()) if inside.any() else float(rate.max())


def _sweep_findings(sweep: Sweep, tester: Tester | None, place: str) -> list[Finding]:
    findings = []
    most, least = limits_of(tester).sweep_rate_max, limits_of(tester).sweep_time_min
    if sweep.sweep_rate > 1.02 * most:  # rate and duration are read from turns to within 2 %
        findings.append(
            warning(place, "sweep_fast", sweep.sweep_rate, rate=sweep.sweep_rate, most=most)
        )
    top = sweep.turns.top
    length = float(top[sweep.last] - top[sweep.first])
    # The sweep's duration is unknown if the record ends above 2 Hz.
    if length < 0.98 * least and sweep.turns.frequency[sweep.last] < 2.0:
        findings.append(warning(place, "sweep_short", length, length=length, least=least))
    return findings


_ONE_TURN = 0.25  # relative tolerance of a turn's duration about the reciprocal of its frequency
_BESIDE, _BACK = (
    0.15,
    1.02,
)  # share of the median of five turns, and multiple of the slowest one before: crossing noise
_FEWEST_TURNS = 5  # window length of the median


def turns_of_sweep(frequency: Array, time: Array) -> NDArray[np.bool_]:
    """Find the turns of the sweep: complete turns from the highest frequency onwards, each slower than the last.

    Takes frequencies (n,) of the turns in Hz and their times (n,) in s. All False if there are too few turns.

    Examples
    --------
    >>> frequency = np.concatenate([np.full(3, 2.0), np.linspace(10.0, 6.0, 21)])  # it swings before the motor starts
    >>> turns_of_sweep(frequency, np.cumsum(1.0 / frequency)).tolist() == [False] * 3 + [True] * 21
    True
    """
    whole = np.flatnonzero(_whole_turns(frequency, time))
    is_swept = np.zeros(frequency.size, dtype=bool)
    if whole.size < _FEWEST_TURNS:
        return is_swept
    first, second = np.array_split(frequency[whole], 2)
    ordered = whole if float(np.mean(first)) >= float(np.mean(second)) else whole[::-1]
    usual = _medians(frequency[ordered])
    near = ordered[np.abs(frequency[ordered] / usual - 1.0) < _BESIDE]
    near = near[int(np.argmax(frequency[near])) :]
    slowest = np.minimum.accumulate(frequency[near])
    is_swept[near[frequency[near] <= _BACK * slowest]] = True
    return is_swept


def _whole_turns(frequency: Array, time: Array) -> NDArray[np.bool_]:
    """Return turns (n,) whose distance to a neighbour matches their period; others are unrelated oscillations."""
    whole = np.abs(frequency[:-1] * np.diff(time) - 1.0) < _ONE_TURN
    before, after = np.append(False, whole), np.append(whole, False)
    return np.asarray(before | after)


def _medians(values: Array) -> Array:
    """Return the running median of (n,) values over five samples."""
    rows = np.lib.stride_tricks.sliding_window_view(np.pad(values, 2, mode="edge"), 5)
    return np.asarray(np.median(rows, axis=1))
