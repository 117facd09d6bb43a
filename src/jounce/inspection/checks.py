"""Checks of a record before it is evaluated: units, columns, weights, saturation, the other plate."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.inspection.findings import problem, remark, warning
from jounce.inspection.signals import Turns, WheelSignals, limits_of
from jounce.recordings.quality import FEWEST_CLIPPED

if TYPE_CHECKING:
    from jounce.parts.testers import Tester

FORCE_UNITS = {
    0.22481: "pounds (lbf)", 0.10197: "kilograms (kgf)", 0.1: "daN", 0.001: "kN", 4.4482: "", 9.80665: "", 1000.0: ""
}  # fmt: skip
LENGTH_UNITS = {1.0 / 25.4: "inches", 0.001: "metres", 0.1: "centimetres", 1000.0: "micrometres"}
"""Ratio of the written value to the value in N or mm; an empty name means that the load has the wrong unit."""

_RIGID_BAND = (
    7.0,
    24.0,
)  # Hz: between the end of the band (6 Hz) and the hold (25 Hz), where every sweep passes
_RIGID_SPREAD = 1.3
"""Ratio of large to small strokes beyond which no plate is rigid.

Simulated on the shipped testers with 1 % noise, an Audi A6 gives 1.00 on rigid plates; on sprung ones 1.7 to 1.9
with its dampers, 2.9 to 4.2 with 30 % of them and 4.6 to 7.9 with 5 %.
"""
_FEWEST_STROKES = (
    12  # turns: a single outlier then does not affect the tenth or ninetieth percentile
)
_SPRUNG_SPREAD, _COMPRESSED = (
    1.1,
    1.5,
)  # the stroke of a sprung plate varies more than this; forces compress the spring by less
_NEAR = (
    0.06  # relative tolerance of a unit's ratio; daN and kgf differ by 2 %, the nearer one is used
)
_KILO, _NEAR_KILO = (
    0.001,
    0.5,
)  # kN over N, and its relative tolerance: no other unit is within a factor of ten
_WEIGHT_WARNING, _WEIGHT_PROBLEM = (
    0.02,
    0.08,
)  # a relative error of the load causes an equal relative error of the adhesion
_LEAST_LOAD, _GREATEST_LOAD = 300.0, 30e3  # N: 30 kg and 3 t on one wheel
_CLIPPED_SHARE = (
    0.01  # share of the samples: clipping a steady sine for this share cuts off 0.05 % of it
)
_DROPOUT = 8e-3  # s: a fifth of the shortest period, at 25 Hz
_SLOWEST_SAMPLING = 200.0  # Hz: eight samples per period at 25 Hz
_SHORTEST = 2.0  # s: half the time of the fastest allowed sweep (3 Hz/s) from 18 to 6 Hz
_SWING = 1.0  # s: about one period of the body's oscillation
_COARSE = 0.05  # share of the static load or stroke: rounding to such steps adds noise of 1.4 %
_SLOW_BANDS = (1.5, 4.0), (4.0, 7.0)  # Hz: the second is used if the first contains too few turns
_MIDDLE_BAND, _FAST_BAND = (
    (8.0, 14.0),
    (20.0, 40.0),
)  # Hz: around wheel hop, where filters have no effect; around the hold
_FEWEST_IN_BAND = 2.0  # turns
_FALLEN, _RISEN = 0.96, 0.975
"""Stroke relative to the middle band (1): at the 25 Hz hold after a second-order low pass at 45 Hz, and in the slowest
band after a first-order high pass at 0.6 Hz."""
_EXCITER_BANDS, _EXCITER_OFF = (
    ((1.5, 4.0), (3.0, 8.0)),
    0.05,
)  # Hz; an error of the stroke causes an equal error of the amplification
_TURNS_OF_MEAN, _FREQUENCY_OFF = (
    10,
    0.04,
)  # turns that are averaged, because noise shifts single crossings
_STILL, _STILL_OF_LOAD = (
    0.5,
    0.03,
)  # standard deviation of a force while its plate moves over that at rest; 1


def check_finite(channels: Mapping[str, Array], time: Array) -> list[Finding]:
    """Report the first NaN or infinite value of each channel (any unit) on ``time`` (s)."""
    findings = []
    for name, values in channels.items():
        if not np.isfinite(values).all():
            bad = np.flatnonzero(~np.isfinite(values))
            count, first = int(bad.size), float(time[bad[0]])
            code = "samples_missing" if count > 1 else "sample_missing"
            findings.append(problem(name, code, float(count), count=count, time=first))
    return findings


def check_tester(name: str, tester: Tester | None) -> list[Finding]:
    """Compare the tester named in the header with the one used for the evaluation."""
    if not name or tester is None:
        return []
    own_name, kind = _find_shipped(name)
    if kind and kind != tester.kind:
        return [
            problem(
                "tester", "other_kind", name=name, kind=kind, tester=tester.name, own=tester.kind
            )
        ]
    if tester.name in (name, own_name):
        return []
    return [remark("tester", "note", "other_tester", name=name, tester=tester.name)]


@lru_cache(maxsize=32)
def _find_shipped(name: str) -> tuple[str, str]:
    """Find a shipped tester by file name or display name; return its name and kind, or empty strings."""
    from jounce.parts.testers import library, load_tester

    for file, path in library().items():
        tester = load_tester(path)
        if name in (file, tester.name):
            return tester.name, tester.kind
    return "", ""


def check_rigid(strokes: Array, frequency: Array, place: str) -> list[Finding]:
    """Report a sprung plate: unlike a rigid one, its stroke (n,) in m varies with frequency (n,) in Hz."""
    inside = (frequency > _RIGID_BAND[0]) & (frequency < _RIGID_BAND[1])
    if np.count_nonzero(inside) < _FEWEST_STROKES:
        return []
    low, high = (float(stroke) for stroke in np.percentile(strokes[inside], [10.0, 90.0]))
    if high <= _RIGID_SPREAD * low:
        return []
    return [problem(place, "not_rigid", high / max(low, 1e-12), low=1e3 * low, high=1e3 * high)]


def check_sprung(
    strokes: Array, frequency: Array, signals: WheelSignals, tester: Tester
) -> list[Finding]:
    """Report a rigid plate: with the tester's spring, these strokes (n,) in m cannot produce the measured forces.

    The spring is between the exciter and the plate, so its compression cannot exceed the sum of their motions.
    """
    inside = (frequency > _RIGID_BAND[0]) & (frequency < _RIGID_BAND[1])
    if tester.plate_spring_rate is None or np.count_nonzero(inside) < _FEWEST_STROKES:
        return []
    low, high = (float(stroke) for stroke in np.percentile(strokes[inside], [10.0, 90.0]))
    compressed = float(np.ptp(signals.force)) / tester.plate_spring_rate
    if high > _SPRUNG_SPREAD * low or compressed <= _COMPRESSED * (tester.stroke + high):
        return []
    words = {"stroke": 1e3 * high, "compressed": 1e3 * compressed, "exciter": 1e3 * tester.stroke}
    return [problem(f"{signals.wheel}.plate.z", "not_sprung", compressed / high, **words)]


def check_even_stroke(signals: WheelSignals, turns: Turns) -> list[Finding]:
    """Detect filtered records: the stroke of a rigid plate must be the same at every frequency."""
    middle = _amplitude(signals.height, signals.time, turns, _MIDDLE_BAND)
    if middle is None:
        return []
    place, findings = f"{signals.wheel}.plate.z", []
    fast = _amplitude(signals.height, signals.time, turns, _FAST_BAND)
    slow = [_amplitude(signals.height, signals.time, turns, band) for band in _SLOW_BANDS]
    slowest = next(
        (size for size in slow if size is not None), None
    )  # a high pass reduces the slowest turns
    for code, size, least in (("stroke_falls", fast, _FALLEN), ("stroke_rises", slowest, _RISEN)):
        if size is not None and size < least * middle:
            words = {"stroke": 2e3 * size, "middle": 2e3 * middle}
            findings.append(warning(place, code, size / middle, **words))
    return findings


def check_exciter(
    exciter: Array, signals: WheelSignals, turns: Turns, span: tuple[float, float], tester: Tester
) -> list[Finding]:
    """Compare the exciter's height (n,) in m, from a sprung plate's height and force, with stroke and programme.

    ``span`` (s) is that of the sweep: a plate at rest shows only force noise and no turns.
    """
    findings, place = [], f"{signals.wheel}.plate.z"
    within = slice(*np.searchsorted(signals.time, span))
    sizes = (
        _amplitude(exciter[within], signals.time[within], turns, band) for band in _EXCITER_BANDS
    )
    shares = [2.0 * size / tester.stroke for size in sizes if size is not None]
    farthest = max(shares, key=lambda share: abs(share - 1.0), default=1.0)
    if abs(farthest - 1.0) > _EXCITER_OFF and not tester.plate_damping_coefficient:
        words = {"stroke": 1e3 * farthest * tester.stroke, "expected": 1e3 * tester.stroke}
        findings.append(warning(place, "exciter_off", farthest, **words))
    times = turns.crossing[::2]
    times = times[(times >= span[0]) & (times <= span[1])]
    programme = max(tester.programme.start_frequency, tester.programme.end_frequency)
    fastest = _TURNS_OF_MEAN / float(
        np.min(times[_TURNS_OF_MEAN:] - times[:-_TURNS_OF_MEAN], initial=np.inf)
    )
    if fastest > 0.0 and abs(fastest / programme - 1.0) > _FREQUENCY_OFF:
        words = {"frequency": fastest, "expected": programme}
        findings.append(warning(place, "frequency_off", fastest / programme, **words))
    return findings


def _amplitude(
    height: Array | None, time: Array, turns: Turns, band: tuple[float, float]
) -> float | None:
    """Return the amplitude (m) of a height (n,) in m at the turns' frequency within a band (Hz), on time (s).

    None if the height is unknown or has too few turns in the band.
    """
    if height is None or time.size < 2:  # a span outside the record has no turns
        return None
    inside = (time >= turns.crossing[0]) & (time <= turns.crossing[-1])
    frequency = turns.frequency_at(time[inside])
    chosen = (frequency >= band[0]) & (frequency < band[1])
    if float(frequency[chosen].sum()) * (time[1] - time[0]) < _FEWEST_IN_BAND:
        return None
    at = np.flatnonzero(inside)[chosen]
    angle = turns.angle(time[at])
    waves = np.stack([np.cos(angle), np.sin(angle), np.ones(at.size)], axis=1)
    return float(np.hypot(*np.linalg.lstsq(waves, height[at], rcond=None)[0][:2]))


def check_resolution(signals: WheelSignals, raw: Array, load: float) -> list[Finding]:
    """Report coarse steps of force (n,) in N relative to static load (N), and of height relative to stroke."""
    findings = []
    for name, code, values, whole in (
        ("force", "force_coarse", raw, load),
        (
            "z",
            "height_coarse",
            signals.height,
            0.0 if signals.height is None else float(np.ptp(signals.height)),
        ),
    ):
        step = (
            float(np.diff(np.unique(values)).min(initial=np.inf)) if values is not None else np.inf
        )
        if np.isfinite(step) and step > _COARSE * whole:
            shown = 1e3 * step if name == "z" else step
            findings.append(warning(f"{signals.wheel}.plate.{name}", code, step, step=shown))
    return findings


def check_together(raw: Array, moving: tuple[int, int], load: float, wheel: str) -> list[Finding]:
    """Report the force (n,) in N of the other plate: constant while this plate moves, changing while it rests.

    ``moving`` is the half-open sample range of the plate's motion; the static load is in N.
    """
    inside, outside = raw[slice(*moving)], np.concatenate([raw[: moving[0]], raw[moving[1] :]])
    # At least a fifth of the motion's duration is needed to estimate the scatter of the force at rest.
    if outside.size < 0.2 * inside.size or np.std(inside) >= min(
        _STILL * np.std(outside), _STILL_OF_LOAD * load
    ):
        return []
    words = {"moves": float(np.std(outside)), "still": float(np.std(inside))}
    return [
        problem(f"{wheel}.plate.force", "force_elsewhere", words["still"] / words["moves"], **words)
    ]


def check_columns(signals: WheelSignals, raw: Array, tester: Tester | None) -> list[Finding]:
    """Report a record that is too short, swapped columns, or heights in a wrong unit; ``raw`` is the force in N."""
    length = float(signals.time[-1] - signals.time[0])
    if length < _SHORTEST:
        return [problem("time", "too_short", length, length=length)]
    if signals.height is None:
        return []
    place = f"{signals.wheel}.plate.z"
    stroke, force = float(np.ptp(signals.height)), float(np.max(np.abs(raw)))
    # A wheel load is above 100 N, a stroke below 0.2 m, and the median height within 0.3 m of zero.
    if force < 100.0 and (stroke > 0.2 or abs(float(np.median(signals.height))) > 0.3):
        return [problem(place, "columns_swapped", stroke, stroke=1e3 * stroke, force=force)]
    if stroke == 0.0:
        return [problem(place, "plate_still", 0.0)]
    if tester is None:
        return []
    ratio = stroke / tester.stroke
    if tester.kind == "rigid-plate":
        return _rigid_stroke(place, ratio, stroke, tester)
    # A sprung plate moves less than its exciter above resonance, and many times more at an undamped resonance.
    if not 0.15 < ratio < 30.0:
        return [
            problem(place, "stroke_unit", stroke, stroke=1e3 * stroke, expected=1e3 * tester.stroke)
        ]
    return []


def _rigid_stroke(place: str, ratio: float, stroke: float, tester: Tester) -> list[Finding]:
    words = {"stroke": 1e3 * stroke, "expected": 1e3 * tester.stroke}
    for factor, unit in LENGTH_UNITS.items():
        if (
            abs(ratio / factor - 1.0) < 2.0 * _NEAR
        ):  # a stroke is the difference between two readings
            return [problem(place, "height_unit", ratio, unit=unit, **words)]
    if not 0.7 < ratio < 1.4:  # for a 6 mm stroke, below 4.2 or above 8.4 mm: a different tester
        return [problem(place, "stroke_wrong", ratio, **words)]
    if abs(stroke - tester.stroke) > tester.limits.stroke_tolerance:
        return [
            warning(
                place, "stroke_off", ratio, allowed=1e3 * tester.limits.stroke_tolerance, **words
            )
        ]
    return []


def check_load(signals: WheelSignals, measured: float, tester: Tester | None) -> list[Finding]:
    """Compare the static load in the header with the mean measured force (N)."""
    place = f"{signals.wheel}.static_load"
    load = signals.static_load
    if load is None:
        if not _LEAST_LOAD < measured < _GREATEST_LOAD:
            return [
                problem(
                    f"{signals.wheel}.plate.force", "no_wheel_load", measured, measured=measured
                )
            ]
        return [
            *_range(place, measured, tester),
            warning(place, "load_from_signal", measured, measured=measured),
        ]
    ratio = measured / load
    words = {"load": load, "measured": measured}
    if _is_turned(measured, load):
        return [problem(f"{signals.wheel}.plate.force", "force_sign", ratio, **words)]
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
    """Return the unit of a force that is ``ratio`` times (1) its value in N; empty if the load has the wrong unit."""
    if (
        abs(ratio / _KILO - 1.0) < _NEAR_KILO
    ):  # the plate's inertia is significant at such small values
        return FORCE_UNITS[_KILO]
    nearest = min(FORCE_UNITS, key=lambda factor: abs(ratio / factor - 1.0))
    return FORCE_UNITS[nearest] if abs(ratio / nearest - 1.0) < _NEAR else None


def _is_turned(measured: float, load: float) -> bool:
    """Whether a mean force is a static load (both in N) with the opposite sign."""
    return abs(measured / load + 1.0) < _WEIGHT_PROBLEM


def _range(place: str, load: float, tester: Tester | None) -> list[Finding]:
    if tester is None:
        return []
    low, high = tester.limits.wheel_load_min, tester.limits.wheel_load_max
    if low <= load <= high:
        return []
    return [warning(place, "load_out_of_range", load, load=load, low=low, high=high)]


def check_pair(loads: Mapping[str, float | None], measured: Mapping[str, float]) -> list[Finding]:
    """Check both wheels together (N) for swapped sides, or the same offset on both force cells."""
    if set(loads) != {"left", "right"} or set(measured) != {"left", "right"}:
        return []
    left, right = loads["left"], loads["right"]
    # Swapped sides: loads match crosswise within the warning tolerance, but not side by side.
    if (
        left is None
        or right is None
        or max(_off(measured[side], loads[side]) for side in loads) < 0.03
    ):
        return []
    if max(_off(measured["left"], right), _off(measured["right"], left)) < _WEIGHT_WARNING:
        return [
            problem("left, right", "sides_swapped", left_load=left, right_load=right, **measured)
        ]
    if all(
        _unit_of(measured[side] / load) is not None or _is_turned(measured[side], load)
        for side, load in (("left", left), ("right", right))
    ):
        return []  # the findings of each wheel report its unit or sign
    offsets = measured["left"] - left, measured["right"] - right
    # Chosen limit: the zero shifts of both sides agree within a tenth.
    if abs(offsets[0] - offsets[1]) < 0.1 * max(abs(value) for value in offsets):
        offset = 0.5 * sum(offsets)
        return [problem("left, right", "both_offset", offset, offset=offset)]
    return []


def _off(measured: float, load: float | None) -> float:
    return abs(measured / load - 1.0) if load else np.inf


def check_sampling(signals: WheelSignals, tester: Tester | None) -> list[Finding]:
    """Report a sampling rate that is too low."""
    rate, place = signals.sample_rate, f"{signals.wheel}.plate.force"
    wanted = limits_of(tester).sampling_frequency_min
    if rate < _SLOWEST_SAMPLING:
        return [problem(place, "samples_too_few", rate, rate=rate, wanted=wanted)]
    if rate < 0.999 * wanted:  # tolerates clocks written with only a few digits
        return [warning(place, "samples_few", rate, rate=rate, wanted=wanted)]
    return []


def check_clipping(force: Array, load: float, place: str) -> list[Finding]:
    """Report a saturated force (N): flat sections at its maximum or minimum, except lift-off."""
    findings = []
    for limit, name in ((float(force.max()), "upper"), (float(force.min()), "lower")):
        if name == "lower" and abs(limit) < 0.05 * load:  # lift-off, allowing for a zero offset
            continue
        flat = force == limit
        count = int(np.count_nonzero(flat))
        if count < FEWEST_CLIPPED or not np.any(flat[:-2] & flat[1:-1] & flat[2:]):
            continue
        jumps = np.abs(np.diff(force))
        entered = jumps[flat[1:] != flat[:-1]]
        # A flat section entered in single resolution steps is a turning point of the signal, not saturation.
        if entered.size == 0 or float(np.median(entered)) <= 1.5 * float(
            np.min(jumps[jumps > 0.0], initial=np.inf)
        ):
            continue
        share = count / force.size
        words = {"limit": limit, "percent": 100.0 * share}
        if share > _CLIPPED_SHARE:
            findings.append(problem(place, "saturated", share, **words))
        else:
            findings.append(warning(place, "clipped", share, **words))
    return findings


def check_dropout(force: Array, signals: WheelSignals, load: float) -> list[Finding]:
    """Report a dropout, a force (N) of exactly zero: a moving plate always exerts an inertia force."""
    if signals.plate_mass <= 0.0:
        return []
    # Near zero, allowing for a zero offset.
    still = np.flatnonzero((np.diff(force) == 0.0) & (np.abs(force[1:]) < 0.05 * load))
    runs = np.split(still, np.flatnonzero(np.diff(still) > 1) + 1)
    longest = max(runs, key=len)
    length = (longest.size + 1) / signals.sample_rate
    if longest.size + 1 < FEWEST_CLIPPED or length < _DROPOUT:
        return []
    words = {"force": float(force[longest[0]]), "time": 1e3 * length}
    return [problem(f"{signals.wheel}.plate.force", "dropout", length, **words)]


def check_other_plate(
    wheel: str, own: tuple[int, int], other: tuple[int, int] | None, step: float, order: str
) -> list[Finding]:
    """Report that the other plate runs during this test; motion as sample ranges, sample interval in s."""
    if other is None:
        return []
    overlap = (min(own[1], other[1]) - max(own[0], other[0])) * step
    if overlap < 0.5:  # s: one plate may run down while the other one starts
        return []
    if order == "together":
        return [remark(f"{wheel}.plate.z", "note", "other_together", time=overlap)]
    return [warning(f"{wheel}.plate.z", "other_running", overlap, time=overlap)]


def check_order(order: str, moving: Mapping[str, tuple[int, int] | None]) -> list[Finding]:
    """Compare the wheel order in the header with the order in which the plates run (samples).

    Without an order in the header, only the column names identify the sides.
    """
    spans = {side: span for side, span in moving.items() if span is not None}
    sides = [side.strip() for side in order.split(",")]
    if not (order == "" or len(sides) == 2) or set(spans) != {"left", "right"}:
        return []
    first, second = sorted(spans, key=lambda side: spans[side][0])
    # Plates that start within half a run of each other are tested together.
    apart = spans[second][0] >= spans[first][0] + 0.5 * (spans[first][1] - spans[first][0])
    if apart and order == "":
        return [remark("left, right", "note", "order_missing", order=f"{first}, {second}")]
    if first == sides[0] or not apart:
        return []
    return [problem("left, right", "order_contradicts", order=order, first=first)]


def _means(values: Array, time: Array, length: float) -> Array:
    """Return means of (n,) values over a length (s) from each time (n,) in s that allows it; else the overall mean."""
    sums = np.concatenate([[0.0], np.cumsum(values)])
    ends = np.searchsorted(time, time + length)
    whole = np.flatnonzero(ends < time.size)
    if whole.size == 0:
        return np.array([np.average(values, weights=np.diff(time, prepend=0.0))])
    return np.asarray((sums[ends[whole]] - sums[whole]) / (ends[whole] - whole))


def check_wandering(
    mean: Array, frequency: Array, load: float, wheel: str, *, hops: bool = False
) -> list[Finding]:
    """Report a slipping wheel: the mean force (N) of turns (frequency in Hz) deviates from the load (N).

    The mean is taken over one oscillation of the body, or over the whole test if the wheel hops.
    """
    known = np.isfinite(mean) & (
        frequency > 6.0
    )  # Hz: slower turns are rare and affected by body motion
    if np.count_nonzero(known) < 12:
        return []
    smooth = _means(
        mean[known] / load - 1.0, np.cumsum(1.0 / frequency[known]), np.inf if hops else _SWING
    )
    drift = float(smooth[int(np.argmax(np.abs(smooth)))])
    # Adhesion is minimum force over load, so its error is about as large. A fifth is a problem.
    if abs(drift) < 0.05:
        return []
    return [
        (problem if abs(drift) > 0.2 else warning)(
            f"{wheel}.plate.force", "slips", drift, percent=100.0 * drift
        )
    ]
