"""What can be wrong with a record before it is evaluated: units, columns, weights, saturation, the other plate."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.findings import Finding
from jounce.inspection.conditioning import WheelSignals

if TYPE_CHECKING:
    from jounce.parts.testers import Tester

Array = NDArray[np.float64]
FORCE_UNITS = {0.22481: "pounds (lbf)", 0.10197: "kilograms (kgf)", 0.1: "daN", 0.001: "kN", 4.4482: "", 9.80665: ""}
LENGTH_UNITS = {1.0 / 25.4: "inches", 0.001: "metres", 0.1: "centimetres", 1000.0: "micrometres"}
_NEAR = 0.06
_WEIGHT_WARNING, _WEIGHT_PROBLEM = 0.02, 0.08
_LEAST_LOAD, _GREATEST_LOAD = 300.0, 30e3
_FEWEST_CLIPPED = 6
_CLIPPED_SHARE = 0.01
_SLOWEST_SAMPLING = 200.0  # Hz
_SHORTEST = 2.0  # s


def problem(place: str, message: str, value: float | None = None) -> Finding:
    """Make the finding of what makes a record unfit."""
    return Finding(place, "problem", message, value)


def warning(place: str, message: str, value: float | None = None) -> Finding:
    """Make the finding of what weakens a value."""
    return Finding(place, "warning", message, value)


def check_finite(channels: Mapping[str, Array], time: Array) -> list[Finding]:
    """Name the first value of each channel (any unit) on ``time`` (s) that is not a number."""
    findings = []
    for name, values in channels.items():
        if not np.isfinite(values).all():
            bad = np.flatnonzero(~np.isfinite(values))
            text = (
                f"{bad.size} sample{'s are' if bad.size > 1 else ' is'} no number, the first at {time[bad[0]]:.4g} s: "
                "the record has gaps; repeat the test."
            )
            findings.append(problem(name, text, float(bad.size)))
    return findings


def check_columns(signals: WheelSignals, raw: Array, tester: Tester | None) -> list[Finding]:
    """Look for a record that is too short, swapped columns, heights in another unit; ``raw`` is the force in N."""
    length = float(signals.time[-1] - signals.time[0])
    if length < _SHORTEST:
        return [problem("time", f"the record is too short: {length:.3g} s, without a run-down.", length)]
    if signals.height is None:
        return []
    place = f"{signals.wheel}.plate.z"
    stroke, force = float(np.ptp(signals.height)), float(np.max(np.abs(raw)))
    if (stroke > 0.2 or abs(float(np.median(signals.height))) > 0.3) and force < 100.0:
        text = (
            f"the plate would move {1e3 * stroke:.4g} mm and the force reach {force:.3g} N only: the columns of plate "
            "and force are swapped."
        )
        return [problem(place, text, stroke)]
    if stroke == 0.0:
        return [problem(place, "the plate never moves; was its sensor connected?", 0.0)]
    if tester is None:
        return []
    ratio = stroke / tester.stroke
    if tester.kind == "rigid-plate":
        return _rigid_stroke(place, ratio, stroke, tester)
    if not 0.15 < ratio < 30.0:
        text = f"the plate moves {1e3 * stroke:.4g} mm on an excenter of {1e3 * tester.stroke:.4g} mm: check its unit."
        return [problem(place, text, stroke)]
    return []


def _rigid_stroke(place: str, ratio: float, stroke: float, tester: Tester) -> list[Finding]:
    said = f"the plate moves {1e3 * stroke:.4g} mm, the tester's stroke is {1e3 * tester.stroke:.4g} mm"
    for factor, unit in LENGTH_UNITS.items():
        if abs(ratio / factor - 1.0) < 2.0 * _NEAR:
            return [problem(place, f"{said}: the heights seem to be in {unit}; correct the unit in the header.", ratio)]
    if not 0.7 < ratio < 1.4:
        return [problem(place, f"{said}: wrong unit, wrong tester, or a defect of the plate.", ratio)]
    if abs(stroke - tester.stroke) > tester.limits.stroke_tolerance:
        return [
            warning(place, f"{said}; allowed are {1e3 * tester.limits.stroke_tolerance:.2g} mm of difference.", ratio)
        ]
    return []


def check_load(signals: WheelSignals, measured: float, tester: Tester | None) -> list[Finding]:
    """Compare the static load of the header with what the force cell shows on average (N)."""
    place = f"{signals.wheel}.static_load"
    load = signals.static_load
    if load is None:
        if not _LEAST_LOAD < measured < _GREATEST_LOAD:
            text = (
                f"the plate carries {measured:.4g} N on average, which is no wheel load: check the unit of the force."
            )
            return [problem(f"{signals.wheel}.plate.force", text, measured)]
        text = f"the header does not give the static load; {measured:.0f} N were taken from the force itself."
        return [*_range(place, measured, tester), warning(place, text, measured)]
    ratio = measured / load
    said = f"the header gives {load:.0f} N, the plate carries {measured:.4g} N on average"
    for factor, unit in FORCE_UNITS.items():
        if abs(ratio / factor - 1.0) < _NEAR:
            text = f"the forces seem to be in {unit}" if unit else "the static load seems to be in another unit"
            return [problem(f"{signals.wheel}.plate.force", f"{said}: {text}; correct the unit in the header.", ratio)]
    if abs(ratio - 1.0) > _WEIGHT_PROBLEM:
        text = (
            f"{said}: the static weight contradicts the signal (wrong, or a force offset of {measured - load:+.0f} N)."
        )
        return [problem(place, text, ratio)]
    findings = _range(place, load, tester)
    if abs(ratio - 1.0) > _WEIGHT_WARNING:
        findings.append(warning(place, f"{said}: {100.0 * (ratio - 1.0):+.1f} %, allowed are 2 %.", ratio))
    return findings


def _range(place: str, load: float, tester: Tester | None) -> list[Finding]:
    if tester is None:
        return []
    low, high = tester.limits.wheel_load_min, tester.limits.wheel_load_max
    if low <= load <= high:
        return []
    return [
        warning(place, f"{load:.0f} N is outside the weights this tester is made for, {low:.0f} to {high:.0f} N.", load)
    ]


def check_pair(loads: Mapping[str, float | None], measured: Mapping[str, float]) -> list[Finding]:
    """Look at both wheels together (N): swapped sides, or the same offset on both force cells."""
    if set(loads) != {"left", "right"} or set(measured) != {"left", "right"}:
        return []
    left, right = loads["left"], loads["right"]
    if left is None or right is None or max(_off(measured[side], loads[side]) for side in loads) < 0.03:
        return []
    if max(_off(measured["left"], right), _off(measured["right"], left)) < 0.02:
        text = (
            f"the plates carry {measured['left']:.0f} N (left) and {measured['right']:.0f} N (right), the header says "
            f"{left:.0f} N and {right:.0f} N: left and right are swapped."
        )
        return [problem("left, right", text)]
    offsets = measured["left"] - left, measured["right"] - right
    if abs(offsets[0] - offsets[1]) < 0.1 * max(abs(value) for value in offsets):
        text = (
            f"both forces are {0.5 * sum(offsets):+.0f} N off the static loads: an offset of the force; tare the cells."
        )
        return [problem("left, right", text, 0.5 * sum(offsets))]
    return []


def _off(measured: float, load: float | None) -> float:
    return abs(measured / load - 1.0) if load else np.inf


def check_sampling(signals: WheelSignals, tester: Tester | None) -> list[Finding]:
    """Look at the sampling rate."""
    rate, place = signals.sample_rate, f"{signals.wheel}.plate.force"
    wanted = tester.limits.sampling_frequency_min if tester is not None else 1000.0
    if rate < _SLOWEST_SAMPLING:
        return [problem(place, f"{rate:.4g} samples per second are too few; {wanted:.0f} are asked for.", rate)]
    if rate < 0.999 * wanted:
        return [warning(place, f"{rate:.4g} samples per second; {wanted:.0f} are asked for.", rate)]
    return []


def check_clipping(force: Array, load: float, place: str) -> list[Finding]:
    """Look for a saturated force (N): flat pieces at its largest or smallest value, lift-off apart."""
    findings = []
    for limit, name in ((float(force.max()), "upper"), (float(force.min()), "lower")):
        if name == "lower" and abs(limit) < 0.05 * load:
            continue
        flat = force == limit
        count = int(np.count_nonzero(flat))
        if count < _FEWEST_CLIPPED or not np.any(flat[:-2] & flat[1:-1] & flat[2:]):
            continue
        jumps = np.abs(np.diff(force))
        entered = jumps[flat[1:] != flat[:-1]]
        if entered.size == 0 or float(np.median(entered)) <= 1.5 * float(np.min(jumps[jumps > 0.0], initial=np.inf)):
            continue
        share = count / force.size
        text = f"the force is clipped at {limit:.4g} N ({100.0 * share:.2g} % of the samples)"
        if share > _CLIPPED_SHARE:
            findings.append(problem(place, f"{text}: saturated; widen the range of the force cell.", share))
        else:
            findings.append(warning(place, f"{text}; amplitudes come out too small.", share))
    return findings


def check_other_plate(
    wheel: str, own: tuple[int, int], other: tuple[int, int] | None, step: float, order: str
) -> list[Finding]:
    """Tell whether the other plate runs while this one is tested: samples of motion, s between samples."""
    if other is None:
        return []
    overlap = (min(own[1], other[1]) - max(own[0], other[0])) * step
    if overlap < 0.5:
        return []
    text = f"the other plate runs for {overlap:.1f} s of this test"
    if order == "together":
        return [Finding(f"{wheel}.plate.z", "note", f"{text}, as the wheel order says; it shakes this wheel as well.")]
    return [
        warning(f"{wheel}.plate.z", f"{text}: it shakes this wheel as well; test one wheel after the other.", overlap)
    ]


def check_wandering(mean: Array, frequency: Array, load: float, wheel: str) -> list[Finding]:
    """Look for a wheel that slips: mean force (N) of turns (their frequency in Hz) that stays off the load (N)."""
    known = np.isfinite(mean) & (frequency > 6.0)
    if np.count_nonzero(known) < 12:
        return []
    smooth = np.convolve(mean[known] / load - 1.0, np.full(6, 1.0 / 6.0), mode="valid")
    drift = float(smooth[int(np.argmax(np.abs(smooth)))])
    if abs(drift) < 0.05:
        return []
    text = f"the mean force leaves the static load by {100.0 * drift:+.0f} % during the test: the wheel slips or rolls."
    return [(problem if abs(drift) > 0.2 else warning)(f"{wheel}.plate.force", text, drift)]
