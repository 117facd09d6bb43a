"""Inspection methods: the quantities each of them measures on a tester, and their evaluation.

Each method is one row of ``METHODS``: key, name, shipped tester, supported plates, values (units and names are in
``quantities.NUMBERS``) and the function that computes the values from a test. Its findings are rows of
``findings.toml``. Command choices, schemas, tables and grades are derived from these rows; bands are defined in
``limits.toml``, because they may differ between lanes.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.constants import NORMAL_95
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.inspection.findings import remark, warning
from jounce.inspection.quantities import NUMBERS
from jounce.inspection.quarter_car import (
    LinearQuarterCar,
    ResponseFit,
    body_damping,
    force_response,
    rig_poles,
    road_poles,
    wheel_damping,
)
from jounce.inspection.signals import Turns, WheelSignals, band_of, limits_of
from jounce.inspection.sweep import Sweep
from jounce.inspection.turn_forces import UNDERFLOW, Analysis, corrected_curve
from jounce.parts.testers import Tester
from jounce.testers.plates import RIGIDITY, RIGIDITY_FREQUENCY, phase_angle, tyre_rigidity

_ADHESION_LENGTH, _PHASE_LENGTH = 1.2, 2.0  # Hz: correlation length of the model error
_NEAR = 4.0  # Hz around the minimum force: turns farther away contribute less than 1 % to the model error there
_END = 0.05  # Hz: distance below which a frequency counts as the end of the band or as a turn with lift-off
_BESIDE = 2.0  # Hz beyond the band that are included in the smoothing: the correlation length
_TOLERANCE = 1.0  # Hz: tolerance of the hold about 25 Hz, for which EGEA's rigidity constants apply
_FEWEST_TURNS = 6  # turns of the hold: a quarter of a second
_LOWEST, _HIGHEST, _POINTS = 1.5, 15.0, 541  # Hz, in steps of 0.025 Hz
_FEWEST_EXTREMES = 4  # turning points: three swings, two decrements
_EVEN = 0.2  # relative tolerance of the duration of neighbouring swings in one free decay
_VAGUE = 0.1  # half width above which a damping ratio is meaningless
_LOWEST_RESONANCE = 2.0  # Hz; resonances below it are the body's


@dataclass(frozen=True)
class WheelTest:
    """Test of one wheel, the input of the methods."""

    signals: WheelSignals  # signals of the section in which the plate moves
    sweep: Sweep  # turns and sweep of the plate
    load: float  # static load, N
    tester: Tester | None  # tester used; None for a rigid plate without further data
    fit: ResponseFit | None  # quarter car fitted to the test
    analysis: Analysis | None = None  # forces of every turn; on a rigid plate only

    @cached_property
    def strokes(self) -> Array | None:
        """Stroke of the plate (m) in each turn; None without its height."""
        return stroke_by_turn(self.signals.height, self.signals.time, self.sweep.turns)

    @cached_property
    def adhesion(self) -> Adhesion | None:
        """Minimum and maximum force on a rigid plate; None if no turn could be evaluated."""
        return None if self.analysis is None else find_adhesion(self.analysis, self.sweep.highest)


@dataclass
class MethodResult:
    """Result of one method."""

    # by key, in SI or in the unit of the key; ``half_widths`` of the 95 % intervals, None if unknown
    values: dict[str, Any] = field(default_factory=dict)
    half_widths: dict[str, float | None] = field(default_factory=dict)
    findings: list[Finding] = field(
        default_factory=list
    )  # findings that make the values less reliable
    phase_deg: Array | None = None  # phase angle of every turn in degrees, for the curves
    unreliable: tuple[str, ...] = ()  # keys of values whose error is not covered by an interval


@dataclass(frozen=True)
class Method:
    """A method of inspection, with its key in files and results and its display name.

    Further fields: the default shipped ``tester``, the kinds of ``plates`` on which the method can be evaluated, its
    gradable values (keys of :data:`jounce.inspection.quantities.NUMBERS`) with the main one first, and the function
    that computes them.
    """

    key: str
    name: str
    tester: str
    plates: tuple[str, ...]
    numbers: tuple[str, ...]
    evaluate: Callable[[WheelTest], MethodResult]


@dataclass(frozen=True)
class Adhesion:
    """Adhesion and relative force amplitude of a test."""

    adhesion: float  # minimum over static force (1); 0 with lift-off
    frequency_hz: float  # frequency of the minimum force, Hz
    lift_off: bool  # whether the tyre left the plate
    relative_force_amplitude: (
        float  # (static - minimum) / static force (1); with lift-off (maximum - static) / static
    )
    half_width: float | None  # of the 95 % intervals of both values (1); None if unknown


def find_adhesion(analysis: Analysis, highest: float) -> Adhesion | None:
    """Find the adhesion of a sweep up to the ``highest`` frequency in Hz; None if no turn could be evaluated."""
    least, load = analysis.measured[:, 0], analysis.load
    known = np.isfinite(least)
    if np.count_nonzero(known) < 4:
        return None
    greatest = float(np.nanmax(analysis.measured[:, 2]))
    lowest = int(np.nanargmin(least))
    if analysis.lifted[known].any():
        at = float(analysis.frequency[lowest])
        return Adhesion(0.0, at, True, (greatest - load) / load, None)
    modelled = analysis.modelled[:, 0] if analysis.fit is not None else np.full(least.size, load)
    near = np.abs(analysis.frequency - analysis.frequency[lowest]) < _NEAR
    if analysis.fit is not None and np.isfinite(modelled).any():
        near |= np.abs(analysis.frequency - analysis.frequency[int(np.nanargmin(modelled))]) < _NEAR
    curve = corrected_curve(
        analysis.frequency[near],
        least[near],
        modelled[near],
        np.ones(int(np.count_nonzero(near))),
        _ADHESION_LENGTH,
    )
    at, force, error = (
        curve.lowest()
        if curve.value.size
        else (analysis.frequency[lowest], least[lowest], math.nan)
    )
    fit = analysis.fit
    if fit is not None:
        spread = fit.spread_at(at, np.abs)
        error = math.hypot(error, spread * analysis.amplitude)
    half = NORMAL_95 * error / load if math.isfinite(error) else None
    share = force / load
    lifted = share <= 0.0
    amplitude = (greatest - load) / load if share < UNDERFLOW else 1.0 - share
    return Adhesion(max(share, 0.0), min(float(at), highest), lifted, amplitude, half)


def _of_fit(test: WheelTest) -> MethodResult:
    """Return the values of the fitted quarter car that every method reports: explained force and body damping ratio."""
    result = MethodResult()
    if test.fit is not None:
        result.values["explained_force"] = test.fit.explained
        half = NORMAL_95 * test.fit.spread(_of_body)
        if half < _VAGUE:
            result.values["body_damping_ratio"] = _of_body(test.fit.corner)
            result.half_widths["body_damping_ratio"] = half
    return result


def _of_body(corner: LinearQuarterCar) -> float:
    return body_damping(road_poles(corner))


def _eusama(test: WheelTest) -> MethodResult:
    """Compute the adhesion and EGEA's relative force amplitude, both from the minimum force."""
    result, minimum = _of_fit(test), test.adhesion
    if minimum is None:
        return result
    result.values |= {
        "adhesion": minimum.adhesion,
        "adhesion_frequency_hz": minimum.frequency_hz,
        "relative_force_amplitude": minimum.relative_force_amplitude,
    }
    result.half_widths |= {
        "adhesion": minimum.half_width,
        "relative_force_amplitude": minimum.half_width,
    }
    return result


@dataclass(frozen=True)
class PhaseMinimum:
    """Minimum phase angle."""

    angle_deg: float  # degrees
    frequency_hz: float  # frequency of the minimum, Hz
    half_width_deg: float | None  # of its 95 % interval, degrees
    at_end: bool  # whether the minimum is at an end of the band
    # whether the tyre leaves the plate there; the angle is then that of the fitted quarter car
    in_lift_off: bool = False


def phase_angles(analysis: Analysis, rows: Array) -> Array:
    """Compute the phase angle (degrees) of each turn from its force values (n, 7).

    ``360 f (t_ref - t_top)``: t_ref is midway between the times at which the force falls below the static load and
    rises above it again around its minimum; f is the reciprocal of the time from this top to the next. The force falls
    before the top if the angle is below 90 degrees.
    """
    reference = 0.5 * (rows[:, 3] + rows[:, 4])
    return np.asarray(360.0 * analysis.turn_frequency * (reference - analysis.top))


def find_phase_minimum(
    analysis: Analysis, band: tuple[float, float]
) -> tuple[PhaseMinimum | None, Array]:
    """Find the minimum phase angle within a band (Hz, ends included), and the angles of the turns (n,) in degrees.

    In and near the band the angles are those of the smoothed curve whose minimum is returned; elsewhere they are those
    of the single turns. The minimum is None if the turns do not cover the band.
    """
    measured = phase_angles(analysis, analysis.measured)
    frequency = analysis.turn_frequency
    if analysis.fit is None:
        modelled = np.full(
            measured.size, float(np.nanmedian(measured)) if np.isfinite(measured).any() else 0.0
        )
        spread = 1.0 / np.maximum(analysis.measured[:, 6], 1.0)
    else:
        modelled = phase_angles(analysis, analysis.modelled)
        swing = np.where(
            np.isfinite(analysis.modelled[:, 6]), analysis.modelled[:, 6], analysis.measured[:, 6]
        )
        spread = 1.0 / np.maximum(swing, 1.0)
    inside = (frequency > band[0] - _BESIDE) & (frequency < band[1] + _BESIDE)
    steady = inside & ~analysis.lifted
    curve = corrected_curve(
        frequency[steady], measured[steady], modelled[steady], spread[steady], _PHASE_LENGTH
    )
    hops = frequency[inside & analysis.lifted]
    unknown = frequency[
        inside & (analysis.lifted | ~np.isfinite(measured)) & np.isfinite(frequency)
    ]
    if unknown.size and analysis.fit is not None:
        curve = curve.with_turns(
            unknown, np.degrees(phase_angle(force_response(analysis.fit.corner, unknown)))
        )
    minimum, angles = curve.least(*band), curve.at(frequency, measured)
    if minimum is None:
        return None, angles
    at, angle, error = minimum
    fit = analysis.fit
    if fit is not None:
        error = math.hypot(error, math.degrees(fit.spread_at(at, phase_angle)))
    half = NORMAL_95 * error if math.isfinite(error) else None
    hopping = bool(hops.size) and float(np.min(np.abs(hops - at))) < _END
    return PhaseMinimum(angle, at, half, min(at - band[0], band[1] - at) < _END, hopping), angles


@dataclass(frozen=True)
class Rigidity:
    """Tyre rigidity (N/m), half width of its 95 % interval (N/m), and the force amplitude behind it (N)."""

    rigidity: float
    half_width: float
    force_amplitude: float


def find_rigidity(
    signals: WheelSignals, sweep: Sweep, load: float
) -> tuple[Rigidity | None, list[Finding]]:
    """Find the rigidity of a tyre under a static load (N); None without plate height or a hold at 25 Hz."""
    place = f"{signals.wheel}.tyre"
    if signals.height is None:
        return None, [warning(place, "no_rigidity_height")]
    turns = sweep.turns
    held = turns.frequency[sweep.hold]
    top = turns.top[sweep.hold]
    count = min(sweep.hold.stop - sweep.hold.start, 25)
    if count < _FEWEST_TURNS or abs(sweep.highest - RIGIDITY_FREQUENCY) > _TOLERANCE:
        return None, [
            warning(place, "no_rigidity_hold", count=count, frequency=float(np.median(held)))
        ]
    begin, end = top[-count], top[-1]
    rate, start = signals.sample_rate, float(signals.time[0])
    cut = slice(max(round((begin - start) * rate), 0), round((end - start) * rate))
    time, height, force = signals.time[cut], signals.height[cut], signals.force[cut] - load
    wave = np.exp(-1j * turns.angle(time))
    amplitude = 2.0 * abs(complex(np.mean(force * wave)))
    stroke = 2.0 * abs(complex(np.mean((height - height.mean()) * wave)))
    rest = force - 2.0 * np.real(np.mean(force * wave) * np.conj(wave)) - force.mean()
    error = float(np.std(rest)) * np.sqrt(2.0 / force.size)
    return Rigidity(
        tyre_rigidity(amplitude, stroke), NORMAL_95 * RIGIDITY[0] * error / stroke, amplitude
    ), []


def rigidity_findings(value: float, tester: Tester | None, place: str) -> list[Finding]:
    """Report an under- or overinflated tyre from its rigidity (N/m), by the limits of a tester."""
    low, high = limits_of(tester).tyre_rigidity_min, limits_of(tester).tyre_rigidity_max
    if low <= value <= high:
        return []
    code, limit = ("tyre_soft", low) if value < low else ("tyre_stiff", high)
    return [warning(place, code, value, rigidity=1e-3 * value, limit=1e-3 * limit)]


def _egea(test: WheelTest) -> MethodResult:
    """Compute minimum phase angle and tyre rigidity, in addition to the EUSAMA values."""
    result, wheel, analysis = _eusama(test), test.signals.wheel, test.analysis
    tyre, result.findings = find_rigidity(test.signals, test.sweep, test.load)
    if tyre is not None:
        result.values["tyre_rigidity"], result.half_widths["tyre_rigidity"] = (
            tyre.rigidity,
            tyre.half_width,
        )
        result.findings += rigidity_findings(tyre.rigidity, test.tester, f"{wheel}.tyre")
    if test.signals.height is None or analysis is None:
        result.findings.append(warning(f"{wheel}.plate.z", "no_height_no_phase"))
        return result
    band = band_of(test.tester)
    if test.fit is not None and (delay := test.fit.delay) != 0.0:
        code = "force_late" if delay > 0.0 else "force_early"
        result.findings.append(
            warning(f"{wheel}.plate.force", code, delay, milliseconds=1e3 * abs(delay))
        )
        return result
    minimum, result.phase_deg = find_phase_minimum(analysis, band)
    if minimum is None:
        result.findings.append(
            warning(f"{wheel}.phase", "phase_not_covered", low=band[0], high=band[1])
        )
        return result
    result.values |= {
        "phase_angle_min_deg": minimum.angle_deg,
        "phase_frequency_hz": minimum.frequency_hz,
    }
    if (
        analysis.lifted.any()
    ):  # after lift-off the wheel's motion is chaotic, which noise and fit do not reveal
        result.unreliable = ("phase_angle_min_deg", "phase_frequency_hz")
        result.findings.append(warning(f"{wheel}.phase", "phase_after_lift_off"))
    else:
        result.half_widths["phase_angle_min_deg"] = minimum.half_width_deg
    if minimum.in_lift_off:
        result.findings.append(warning(f"{wheel}.phase", "phase_in_lift_off"))
    if minimum.angle_deg < 0.0:
        result.findings.append(warning(f"{wheel}.phase", "phase_below_zero", minimum.angle_deg))
    if minimum.at_end:
        at = minimum.frequency_hz
        result.findings.append(warning(f"{wheel}.phase", "phase_at_end", at, frequency=at))
    return result


@dataclass(frozen=True)
class Theta:
    """Damping ratios (1) on the rig and on the road, each with the half width of its 95 % interval (1)."""

    rig: float
    road: float
    rig_half_width: float
    road_half_width: float


def theta_by_fit(fit: ResponseFit, tester: Tester | None) -> Theta:
    """Compute damping ratios of the wheel from the poles of a fitted quarter car.

    The rig value includes the tester's plate and plate spring under the wheel; on the road, and on a rigid plate, the
    plate is at rest.
    """

    def on_road(corner: LinearQuarterCar) -> float:
        return wheel_damping(road_poles(corner))[0]

    def on_rig(corner: LinearQuarterCar) -> float:
        if tester is None or tester.plate_spring_rate is None:
            return on_road(corner)
        damping = tester.plate_damping_coefficient or 0.0
        return wheel_damping(
            rig_poles(corner, tester.plate_mass, tester.plate_spring_rate, damping)
        )[0]

    road, half = on_road(fit.corner), NORMAL_95 * fit.spread(on_road)
    if tester is None or tester.plate_spring_rate is None:
        return Theta(road, road, half, half)
    return Theta(on_rig(fit.corner), road, NORMAL_95 * fit.spread(on_rig), half)


def half_power(frequency: Array, amplitude: Array) -> float | None:
    """Compute the damping ratio (1) from the width of a resonance at 0.707 of its height: (f2 - f1) / (2 f_r).

    Frequencies (n,) in Hz in any order, amplitudes (n,) in any unit. None if one of the two points does not exist,
    as for damping ratios above about 0.2.
    """
    order = np.argsort(frequency)
    f, a = frequency[order], amplitude[order]
    top = int(np.argmax(a))
    level = a[top] / math.sqrt(2.0)
    below, above = np.flatnonzero(a[:top] < level), np.flatnonzero(a[top:] < level)
    if below.size == 0 or above.size == 0:
        return None
    i, j = int(below[-1]), top + int(above[0])
    low = np.interp(level, a[i : i + 2], f[i : i + 2])
    high = f[j - 1] + (a[j - 1] - level) / (a[j - 1] - a[j]) * (f[j] - f[j - 1])
    return float((high - low) / (2.0 * f[top]))


def plate_gain(corner: LinearQuarterCar, tester: Tester, frequency: Array) -> Array:
    """Return the height of a sprung plate over that of the exciter (1), frequencies (n,) in Hz."""
    s = 2j * np.pi * np.asarray(frequency, dtype=float)
    spring = (
        float(tester.plate_spring_rate or 0.0) + float(tester.plate_damping_coefficient or 0.0) * s
    )
    return np.asarray(
        abs(spring / (tester.plate_mass * s * s + spring + force_response(corner, frequency)))
    )


def theta_by_amplification(gain: float, corner: LinearQuarterCar, tester: Tester) -> float | None:
    """Compute the rig's damping ratio (1) for which the plate moves ``gain`` times (1) the exciter at resonance.

    All values of the corner except its damping are used. None if no damping gives this amplification.
    """
    from scipy.optimize import brentq

    frequency = np.linspace(_LOWEST, _HIGHEST, _POINTS)

    def miss(logarithm: float) -> float:
        trial = replace(corner, damping_coefficient=math.exp(logarithm))
        return math.log(float(plate_gain(trial, tester, frequency).max()) / gain)

    critical = 2.0 * math.sqrt((corner.spring_rate + corner.tyre_stiffness) * corner.unsprung_mass)
    low, high = math.log(0.01 * critical), math.log(0.6 * critical)
    if not (gain > 0.0 and miss(low) > 0.0 > miss(high)):
        return None
    fitted = replace(corner, damping_coefficient=math.exp(brentq(miss, low, high, xtol=1e-6)))
    damping = tester.plate_damping_coefficient or 0.0
    return wheel_damping(
        rig_poles(fitted, tester.plate_mass, float(tester.plate_spring_rate or 0.0), damping)
    )[0]


def theta_by_decay(height: Array, sample_rate: float) -> tuple[float, float] | None:
    """Compute damping ratio (1) and frequency (Hz) of the free decay after the exciter has stopped.

    Turning points of the height (n,) in m are followed backwards from the end while they are evenly spaced and grow
    (rate in Hz). None if there are fewer than four.
    """
    size = max(round(0.005 * sample_rate), 1)
    smooth = np.convolve(height, np.full(size, 1.0 / size), mode="valid")
    rest = float(np.mean(smooth[-max(round(0.3 * sample_rate), 3) :]))
    away = smooth - rest
    slope = np.diff(away)
    turns = np.flatnonzero((slope[:-1] > 0.0) != (slope[1:] > 0.0)) + 1
    if turns.size < _FEWEST_EXTREMES:
        return None
    floor = max(
        5e-3 * float(np.max(np.abs(away))),
        4.0 * float(np.std(away[-max(round(0.1 * sample_rate), 3) :])),
    )
    turns = turns[np.abs(away[turns]) > floor]
    even = _even_turns(turns, away)
    if even.size < _FEWEST_EXTREMES:
        return None
    slope_of_log = float(np.polyfit(np.arange(even.size), np.log(np.abs(away[even])), 1)[0])
    ratio = -slope_of_log / math.hypot(math.pi, slope_of_log)
    half_turn = float(even[-1] - even[0]) / (even.size - 1) / sample_rate
    return (ratio, 0.5 / half_turn) if ratio > 0.0 else None


def _even_turns(turns: NDArray[np.intp], away: Array) -> NDArray[np.intp]:
    """Return the decay's turning points: backwards from the last, alternating, growing and evenly spaced."""
    even = [int(turns[-1])] if turns.size else []
    for at in turns[-2::-1]:
        now, then = away[even[-1]], away[at]
        if now * then > 0.0 or abs(then) <= abs(now):
            break
        if len(even) > 1 and abs((even[-1] - at) / (even[-2] - even[-1]) - 1.0) > _EVEN:
            break
        # Decrements scatter more than times: noise affects the height of a small swing, but hardly its turning time.
        if (
            len(even) > 1
            and abs(math.log(-then / now) / math.log(-now / away[even[-2]]) - 1.0) > 3.0 * _EVEN
        ):
            break
        even.append(int(at))
    return np.array(even[::-1], dtype=np.intp)


def _theta(test: WheelTest) -> MethodResult:
    """Compute damping ratios from the fitted quarter car; on a sprung plate also by the older methods."""
    result, wheel = _of_fit(test), test.signals.wheel
    if test.fit is not None:
        theta = theta_by_fit(test.fit, test.tester)
        result.values |= {
            "theta_rig": theta.rig,
            "theta_road": theta.road,
            "theta_methods": {"fit": theta.rig},
        }
        result.half_widths |= {
            "theta_rig": theta.rig_half_width,
            "theta_road": theta.road_half_width,
        }
        if theta.road <= theta.road_half_width:
            result.findings.append(warning(f"{wheel}.theta", "undamped", theta.road))
        if theta.road >= 1.0:
            result.findings.append(warning(f"{wheel}.theta", "overdamped", theta.road))
        if test.analysis is None and (delay := test.fit.delay) != 0.0:
            words = {"milliseconds": 1e3 * abs(delay)}
            result.findings.append(
                warning(f"{wheel}.plate.force", "channels_apart", delay, **words)
            )
    height, strokes, tester = test.signals.height, test.strokes, test.tester
    if test.analysis is not None or tester is None or height is None or strokes is None:
        return result
    frequency = test.sweep.turns.frequency
    above = frequency > _LOWEST_RESONANCE
    gain = float(strokes[above].max(initial=0.0)) / tester.stroke
    decay = theta_by_decay(height, test.signals.sample_rate)
    result.values["theta_methods"] = {
        "fit": result.values.get("theta_rig"),
        "half_power": half_power(frequency[above], strokes[above]),
        "amplification": theta_by_amplification(gain, test.fit.corner, tester)
        if test.fit is not None
        else None,
        "free_decay": decay[0] if decay is not None else None,
    }
    guessed = [name.replace("_", " ") for name in tester.estimated if name.startswith("plate_")]
    if guessed:
        result.findings.append(
            remark(f"{wheel}.theta", "note", "plate_estimated", names=", ".join(guessed))
        )
    return result


@dataclass(frozen=True)
class BogeAmplitude:
    """Maximum peak-to-peak plate movement (m), half width of its 95 % interval (m), and its frequency (Hz)."""

    amplitude: float
    half_width: float
    frequency_hz: float


def stroke_by_turn(height: Array | None, time: Array, turns: Turns) -> Array | None:
    """Return the peak-to-peak height (m) of each turn between upward crossings; height (n,) in m on time (n,) in s."""
    if height is None:
        return None
    starts = np.searchsorted(time, turns.crossing[::2])
    starts = np.minimum(starts, height.size - 1)
    count = turns.top.size
    if starts.size <= count:
        starts = np.append(starts, height.size - 1)
    starts = starts[: count + 1]
    high, low = (
        np.maximum.reduceat(height, starts)[:count],
        np.minimum.reduceat(height, starts)[:count],
    )
    return np.asarray(high - low)


def find_boge(test: WheelTest) -> BogeAmplitude | None:
    """Find the maximum movement of a plate while the exciter passes the wheel's resonance."""
    height, strokes, frequency = test.signals.height, test.strokes, test.sweep.turns.frequency
    if height is None or strokes is None:
        return None
    at = int(np.argmax(np.where(frequency > _LOWEST_RESONANCE, strokes, 0.0)))
    third = np.diff(height, 3)
    noise = float(np.median(np.abs(third))) / (0.6745 * np.sqrt(20.0))
    return BogeAmplitude(float(strokes[at]), NORMAL_95 * noise * np.sqrt(2.0), float(frequency[at]))


def _boge(test: WheelTest) -> MethodResult:
    boge = find_boge(test)
    if boge is None:
        return MethodResult()
    return MethodResult({"boge_amplitude": boge.amplitude}, {"boge_amplitude": boge.half_width})


_RIGID, _SPRUNG = "rigid-plate", "sprung-plate"
METHODS: dict[str, Method] = {
    method.key: method
    for method in (
        Method("eusama", "EUSAMA", "eusama", (_RIGID,), ("adhesion",), _eusama),
        Method(
            "egea", "EGEA", "egea-specsus2018", (_RIGID,),
            ("phase_angle_min_deg", "relative_force_amplitude", "tyre_rigidity"), _egea,
        ),
        Method(
            "theta", "THETA", "theta-msd3000", (_RIGID, _SPRUNG),
            ("theta_road", "theta_rig", "body_damping_ratio", "explained_force"), _theta,
        ),
        Method("boge", "BOGE", "boge", (_SPRUNG,), ("boge_amplitude",), _boge),
    )
}  # fmt: skip
"""Methods by key, in the order of listing and evaluation."""

QUANTITIES = {name: NUMBERS[name] for method in METHODS.values() for name in method.numbers}
"""Quantities that can have limits, by their key in results."""


def methods_on(plate: str) -> tuple[str, ...]:
    """Return the keys of the methods that can be evaluated on a kind of plate."""
    return tuple(key for key, method in METHODS.items() if plate in method.plates)


def method_names(keys: tuple[str, ...]) -> str:
    """Return the display names of methods: ``EUSAMA, EGEA``."""
    return ", ".join(METHODS[key].name if key in METHODS else key for key in keys)
