"""What can be wrong with a record before it is evaluated: units, columns, weights, saturation, the other plate."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.inspection.findings import problem, remark, warning
from jounce.inspection.signals import WheelSignals, limits_of

if TYPE_CHECKING:
    from jounce.parts.testers import Tester

FORCE_UNITS = {0.22481: "pounds (lbf)", 0.10197: "kilograms (kgf)", 0.1: "daN", 0.001: "kN", 4.4482: "", 9.80665: ""}
LENGTH_UNITS = {1.0 / 25.4: "inches", 0.001: "metres", 0.1: "centimetres", 1000.0: "micrometres"}
_RIGID_BAND, _RIGID_SPREAD, _FEWEST_STROKES = (7.0, 24.0), 1.3, 12  # Hz, 1, 1
_SPRUNG_SPREAD, _COMPRESSED = 1.1, 1.5  # strokes on a spring vary by more, forces compress it by less
_NEAR, _KILO, _NEAR_KILO = 0.06, 0.001, 0.5
_WEIGHT_WARNING, _WEIGHT_PROBLEM = 0.02, 0.08
_LEAST_LOAD, _GREATEST_LOAD = 300.0, 30e3
_FEWEST_CLIPPED = 6
_CLIPPED_SHARE = 0.01
_DROPOUT = 8e-3  # s
_SLOWEST_SAMPLING = 200.0  # Hz
_SHORTEST = 2.0  # s
_SWING = 1.0  # s


def check_finite(channels: Mapping[str, Array], time: Array) -> list[Finding]:
    """Name the first value of each channel (any unit) on ``time`` (s) that is not a number."""
    findings = []
    for name, values in channels.items():
        if not np.isfinite(values).all():
            bad = np.flatnonzero(~np.isfinite(values))
            count, plural = int(bad.size), "s are" if bad.size > 1 else " is"
            first = float(time[bad[0]])
            findings.append(problem(name, "samples_missing", float(count), count=count, plural=plural, time=first))
    return findings


def check_tester(name: str, tester: Tester | None) -> list[Finding]:
    """Compare the tester that the header names with the one by which the record is evaluated."""
    if not name or tester is None:
        return []
    own_name, kind = _shipped(name)
    if kind and kind != tester.kind:
        return [problem("tester", "other_kind", name=name, kind=kind, tester=tester.name, own=tester.kind)]
    if tester.name in (name, own_name):
        return []
    return [remark("tester", "note", "other_tester", name=name, tester=tester.name)]


@lru_cache(maxsize=32)
def _shipped(name: str) -> tuple[str, str]:
    """Name and kind of a shipped tester, by its file or the name that it gives itself; empty where there is none."""
    from jounce.parts.testers import library, load_tester

    for file, path in library().items():
        found = load_tester(path)
        if name in (file, found.name):
            return found.name, found.kind
    return "", ""


def check_rigid(strokes: Array, frequency: Array, place: str) -> list[Finding]:
    """Tell a plate on a spring by its stroke (n,) in m: it follows the frequency (n,) in Hz, a rigid one's does not."""
    inside = (frequency > _RIGID_BAND[0]) & (frequency < _RIGID_BAND[1])
    if np.count_nonzero(inside) < _FEWEST_STROKES:
        return []
    low, high = (float(one) for one in np.percentile(strokes[inside], [10.0, 90.0]))
    if high <= _RIGID_SPREAD * low:
        return []
    return [problem(place, "not_rigid", high / max(low, 1e-12), low=1e3 * low, high=1e3 * high)]


def check_sprung(strokes: Array, frequency: Array, signals: WheelSignals, tester: Tester) -> list[Finding]:
    """Tell a rigid plate from one on the tester's spring, whose forces such strokes (n,) in m could not make.

    The spring is between the exciter and the plate, so no force compresses it by more than both of them move.
    """
    inside = (frequency > _RIGID_BAND[0]) & (frequency < _RIGID_BAND[1])
    if tester.plate_spring_rate is None or np.count_nonzero(inside) < _FEWEST_STROKES:
        return []
    low, high = (float(one) for one in np.percentile(strokes[inside], [10.0, 90.0]))
    compressed = float(np.ptp(signals.force)) / tester.plate_spring_rate
    if high > _SPRUNG_SPREAD * low or compressed <= _COMPRESSED * (tester.stroke + high):
        return []
    words = {"stroke": 1e3 * high, "compressed": 1e3 * compressed, "exciter": 1e3 * tester.stroke}
    return [problem(f"{signals.wheel}.plate.z", "not_sprung", compressed / high, **words)]


def check_columns(signals: WheelSignals, raw: Array, tester: Tester | None) -> list[Finding]:
    """Look for a record that is too short, swapped columns, heights in another unit; ``raw`` is the force in N."""
    length = float(signals.time[-1] - signals.time[0])
    if length < _SHORTEST:
        return [problem("time", "too_short", length, length=length)]
    if signals.height is None:
        return []
    place = f"{signals.wheel}.plate.z"
    stroke, force = float(np.ptp(signals.height)), float(np.max(np.abs(raw)))
    if force < 100.0 and (stroke > 0.2 or abs(float(np.median(signals.height))) > 0.3):
        return [problem(place, "columns_swapped", stroke, stroke=1e3 * stroke, force=force)]
    if stroke == 0.0:
        return [problem(place, "plate_still", 0.0)]
    if tester is None:
        return []
    ratio = stroke / tester.stroke
    if tester.kind == "rigid-plate":
        return _rigid_stroke(place, ratio, stroke, tester)
    if not 0.15 < ratio < 30.0:
        return [problem(place, "stroke_unit", stroke, stroke=1e3 * stroke, expected=1e3 * tester.stroke)]
    return []


def _rigid_stroke(place: str, ratio: float, stroke: float, tester: Tester) -> list[Finding]:
    words = {"stroke": 1e3 * stroke, "expected": 1e3 * tester.stroke}
    for factor, unit in LENGTH_UNITS.items():
        if abs(ratio / factor - 1.0) < 2.0 * _NEAR:
            return [problem(place, "height_unit", ratio, unit=unit, **words)]
    if not 0.7 < ratio < 1.4:
        return [problem(place, "stroke_wrong", ratio, **words)]
    if abs(stroke - tester.stroke) > tester.limits.stroke_tolerance:
        return [warning(place, "stroke_off", ratio, allowed=1e3 * tester.limits.stroke_tolerance, **words)]
    return []


def check_load(signals: WheelSignals, measured: float, tester: Tester | None) -> list[Finding]:
    """Compare the static load of the header with what the force cell shows on average (N)."""
    place = f"{signals.wheel}.static_load"
    load = signals.static_load
    if load is None:
        if not _LEAST_LOAD < measured < _GREATEST_LOAD:
            return [problem(f"{signals.wheel}.plate.force", "no_wheel_load", measured, measured=measured)]
        return [
            *_range(place, measured, tester),
            warning(place, "load_from_signal", measured, measured=measured),
        ]
    ratio = measured / load
    words = {"load": load, "measured": measured}
    unit = _unit_of(ratio)
    if unit == "":
        return [problem(place, "load_unit", ratio, **words)]
    if unit is not None:
        return [problem(f"{signals.wheel}.plate.force", "force_unit", ratio, unit=unit, **words)]
    if abs(ratio - 1.0) > _WEIGHT_PROBLEM:
        return [problem(place, "load_contradicts", ratio, offset=measured - load, **words)]
    findings = _range(place, load, tester)
    if abs(ratio - 1.0) > _WEIGHT_WARNING:
        findings.append(warning(place, "load_off", ratio, percent=100.0 * (ratio - 1.0), **words))
    return findings


def _unit_of(ratio: float) -> str | None:
    """Unit of a force that is ``ratio`` times (1) its value in N; empty where rather the load is in another unit."""
    if abs(ratio / _KILO - 1.0) < _NEAR_KILO:  # what the plate's inertia leaves is not small beside so few newtons
        return FORCE_UNITS[_KILO]
    nearest = min(FORCE_UNITS, key=lambda factor: abs(ratio / factor - 1.0))
    return FORCE_UNITS[nearest] if abs(ratio / nearest - 1.0) < _NEAR else None


def _range(place: str, load: float, tester: Tester | None) -> list[Finding]:
    if tester is None:
        return []
    low, high = tester.limits.wheel_load_min, tester.limits.wheel_load_max
    if low <= load <= high:
        return []
    return [warning(place, "load_out_of_range", load, load=load, low=low, high=high)]


def check_pair(loads: Mapping[str, float | None], measured: Mapping[str, float]) -> list[Finding]:
    """Look at both wheels together (N): swapped sides, or the same offset on both force cells."""
    if set(loads) != {"left", "right"} or set(measured) != {"left", "right"}:
        return []
    left, right = loads["left"], loads["right"]
    if left is None or right is None or max(_off(measured[side], loads[side]) for side in loads) < 0.03:
        return []
    if max(_off(measured["left"], right), _off(measured["right"], left)) < 0.02:
        return [problem("left, right", "sides_swapped", left_load=left, right_load=right, **measured)]
    if all(_unit_of(measured[side] / loads[side]) is not None for side in loads):  # type: ignore[operator]
        return []  # each wheel says of which unit it is
    offsets = measured["left"] - left, measured["right"] - right
    if abs(offsets[0] - offsets[1]) < 0.1 * max(abs(value) for value in offsets):
        offset = 0.5 * sum(offsets)
        return [problem("left, right", "both_offset", offset, offset=offset)]
    return []


def _off(measured: float, load: float | None) -> float:
    return abs(measured / load - 1.0) if load else np.inf


def check_sampling(signals: WheelSignals, tester: Tester | None) -> list[Finding]:
    """Look at the sampling rate."""
    rate, place = signals.sample_rate, f"{signals.wheel}.plate.force"
    wanted = limits_of(tester).sampling_frequency_min
    if rate < _SLOWEST_SAMPLING:
        return [problem(place, "samples_too_few", rate, rate=rate, wanted=wanted)]
    if rate < 0.999 * wanted:
        return [warning(place, "samples_few", rate, rate=rate, wanted=wanted)]
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
        words = {"limit": limit, "percent": 100.0 * share}
        if share > _CLIPPED_SHARE:
            findings.append(problem(place, "saturated", share, **words))
        else:
            findings.append(warning(place, "clipped", share, **words))
    return findings


def check_dropout(force: Array, signals: WheelSignals, load: float) -> list[Finding]:
    """Look for a force (N) that is exactly nothing for a while: a cell under a moving plate always feels the plate."""
    if signals.plate_mass <= 0.0:
        return []
    still = np.flatnonzero((np.diff(force) == 0.0) & (np.abs(force[1:]) < 0.05 * load))
    runs = np.split(still, np.flatnonzero(np.diff(still) > 1) + 1)
    longest = max(runs, key=len)
    length = (longest.size + 1) / signals.sample_rate
    if longest.size + 1 < _FEWEST_CLIPPED or length < _DROPOUT:
        return []
    words = {"force": float(force[longest[0]]), "time": 1e3 * length}
    return [problem(f"{signals.wheel}.plate.force", "dropout", length, **words)]


def check_other_plate(
    wheel: str, own: tuple[int, int], other: tuple[int, int] | None, step: float, order: str
) -> list[Finding]:
    """Tell whether the other plate runs while this one is tested: samples of motion, s between samples."""
    if other is None:
        return []
    overlap = (min(own[1], other[1]) - max(own[0], other[0])) * step
    if overlap < 0.5:
        return []
    if order == "together":
        return [remark(f"{wheel}.plate.z", "note", "other_together", time=overlap)]
    return [warning(f"{wheel}.plate.z", "other_running", overlap, time=overlap)]


def check_order(order: str, moving: Mapping[str, tuple[int, int] | None]) -> list[Finding]:
    """Compare the order of the wheels that the header gives with that in which the plates run (samples).

    Where it gives none, nothing but the names of the columns says which side is which.
    """
    spans = {side: span for side, span in moving.items() if span is not None}
    sides = [side.strip() for side in order.split(",")]
    if not (order == "" or len(sides) == 2) or set(spans) != {"left", "right"}:
        return []
    first, second = sorted(spans, key=lambda side: spans[side][0])
    apart = spans[second][0] >= spans[first][0] + 0.5 * (spans[first][1] - spans[first][0])
    if apart and order == "":
        return [remark("left, right", "note", "order_missing", order=f"{first}, {second}")]
    if first == sides[0] or not apart:
        return []
    return [problem("left, right", "order_contradicts", order=order, first=first)]


def _means(values: Array, time: Array, length: float) -> Array:
    """Means of (n,) values over a length (s), from each time (n,) in s on that has so much after it; or that of all."""
    sums = np.concatenate([[0.0], np.cumsum(values)])
    ends = np.searchsorted(time, time + length)
    whole = np.flatnonzero(ends < time.size)
    if whole.size == 0:
        return np.array([np.average(values, weights=np.diff(time, prepend=0.0))])
    return np.asarray((sums[ends[whole]] - sums[whole]) / (ends[whole] - whole))


def check_wandering(mean: Array, frequency: Array, load: float, wheel: str, *, hops: bool = False) -> list[Finding]:
    """Look for a wheel that slips: mean force (N) of turns (their frequency in Hz) that stays off the load (N).

    It is looked at over a swing of the body; of a wheel that hops, whose body is thrown about, over all of the test.
    """
    known = np.isfinite(mean) & (frequency > 6.0)
    if np.count_nonzero(known) < 12:
        return []
    smooth = _means(mean[known] / load - 1.0, np.cumsum(1.0 / frequency[known]), np.inf if hops else _SWING)
    drift = float(smooth[int(np.argmax(np.abs(smooth)))])
    if abs(drift) < 0.05:
        return []
    return [(problem if abs(drift) > 0.2 else warning)(f"{wheel}.plate.force", "slips", drift, percent=100.0 * drift)]
