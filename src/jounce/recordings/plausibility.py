"""Plausibility checks: whether the values of a record can come from a suspension, and otherwise the likely unit."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from jounce.core.catalogue import Severity
from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.text import place_in
from jounce.core.types import Array
from jounce.core.units import conversion_factor
from jounce.recordings.schema import channel_unit, place_of, quantity_of


@dataclass(frozen=True)
class Reach:
    """Range of a quantity on suspensions, from kart to truck, in SI.

    No suspension exceeds ``most``; ``usual`` covers nearly all, so the likely unit is the one that brings the value
    into this range. The limits are wide because they only detect wrong units, which err by a factor of 10 or more.
    """

    number: str  # "mean", "r.m.s.", "peak", "range" or "rate"
    most: float
    usual: tuple[float, float]
    least: float = 0.0  # a smaller value other than 0 is suspicious


_MOTION = (
    Reach("range", 1.5, (2e-3, 0.5), least=1e-4),
    Reach("rate", 30.0, (5e-3, 5.0)),  # r.m.s. of the change from sample to sample
)
_ACCELERATION = (Reach("mean", 30.0, (0.02, 15.0)), Reach("r.m.s.", 1000.0, (0.05, 50.0)))
_HEAVE = (_ACCELERATION[0], Reach("r.m.s.", 1000.0, (0.05, 50.0), least=0.01))
_BODY_HEAVE = (_ACCELERATION[0], Reach("r.m.s.", 100.0, (0.05, 20.0), least=0.01))
_VELOCITY = (Reach("r.m.s.", 30.0, (5e-3, 5.0), least=1e-3),)
_FORCE = (Reach("peak", 1e6, (50.0, 1e5), least=10.0),)
_ANGLE = (Reach("peak", 1.6, (1e-3, 0.6)),)
_MOMENT = (Reach("peak", 1e6, (1.0, 1e5)),)
REACHES: dict[str, tuple[Reach, ...]] = {
    **dict.fromkeys(("deflection", "displacement", "stroke", "travel"), _MOTION),
    "z": (_MOTION[1],),  # a road may climb
    **dict.fromkeys(("ax", "ay", "acceleration"), _ACCELERATION),
    "az": _HEAVE,
    **dict.fromkeys(("deflection_velocity", "velocity", "vz"), _VELOCITY),
    **dict.fromkeys(("speed", "vx", "vy"), (Reach("peak", 150.0, (1.0, 80.0)),)),
    **dict.fromkeys(("force", "load"), _FORCE),
    **dict.fromkeys(("camber", "toe", "pitch", "roll"), _ANGLE),
    "steer": (Reach("peak", 20.0, (1e-2, 12.0)),),
    "phase_angle": (Reach("peak", 6.3, (0.05, 3.2)),),
    **dict.fromkeys(("pitch_rate", "roll_rate", "yaw_rate"), (Reach("r.m.s.", 20.0, (5e-3, 3.0)),)),
    **dict.fromkeys(
        ("pitch_acceleration", "roll_acceleration"), (Reach("r.m.s.", 2000.0, (0.02, 50.0)),)
    ),
    "pressure": (Reach("peak", 2e8, (5e4, 3e7)),),
    "frequency": (Reach("peak", 500.0, (0.1, 50.0)),),
    "adhesion": (Reach("peak", 1.5, (0.05, 1.0)),),
    **dict.fromkeys(("moment", "torque"), _MOMENT),
}
"""Limits that no suspension exceeds, by quantity; other quantities may have any magnitude."""

_UNITS = {
    "m/s^2": ("g", "mm/s^2", "mg"),
    "m": ("m", "cm", "mm", "inch"),
    "m/s": ("m/s", "km/h", "cm/s", "mm/s"),
    "N": ("N", "kN", "daN", "lbf"),
    "rad": ("deg", "mrad"),
    "rad/s": ("deg/s",),
    "rad/s^2": ("deg/s^2",),
    "Hz": ("rpm",),
    "Pa": ("Pa", "kPa", "bar", "MPa"),
    "1": ("%",),
    "N*m": ("N*m", "kN*m", "N*mm"),
}
_BODY = ("body", "sprung", "seat", "chassis")
_FASTEST_STEP = 1.05e-5  # s: no logger of suspensions is faster than 10 us (5 % for rounding)
_FAST_STEP, _SHORT, _SOME = 1.05e-4, 0.3, 100
"""A step (s) that is suspicious if the record is shorter than ``_SHORT`` (s) and has more than ``_SOME`` samples."""
SLOWEST_STEP = 0.2  # s; bounce is about 1 Hz, which needs five samples a period
MOST_POWER = 2e4  # W; peak of the largest dampers
MOST_WORK = 8e3  # J a cycle


def implausible(
    channels: Mapping[str, Array],
    step: float | None,
    *,
    where: str,
    written: Mapping[str, str] | None = None,
    headers: Mapping[str, str] | None = None,
) -> list[Finding]:
    """Report values that no suspension reaches.

    Parameters
    ----------
    channels : mapping of str to ndarray of shape (n,)
        Signals in SI by channel name, at constant steps.
    step : float or None
        Time step in s; None for columns that are not signals over time.
    where : str
        File named in the findings.
    written : mapping of str to str, optional
        Unit that the file gives for each channel; by default its SI unit.
    headers : mapping of str to str, optional
        Header of each channel in the file; a finding quotes it to show how to state another unit.

    Returns
    -------
    list of Finding
        A problem for each channel beyond ``REACHES``, with the likely unit; for implausible time steps; for a force
        that does more work over its stroke than any damper; and for a velocity that is not the rate of the displacement
        of the same part, or is its absolute value. If ``written`` is given, also a warning for tiny signals (strokes
        below 0.1 mm, forces below 10 N) and for a mean of 1 m/s^2 (gravity?).

    Examples
    --------
    >>> import numpy as np
    >>> wave = np.sin(2.0 * np.pi * 1.5 * np.arange(1000) * 0.001)
    >>> [finding.message for finding in implausible({"stroke": 12.45 * wave}, 0.001, where="a.csv")]
    ['the range is 24.9 m, but no suspension exceeds 1.5 m; is its unit mm or cm rather than m?']
    """
    units = {name: (written or {}).get(name) or channel_unit(name) for name in channels}
    length = max((values.size for values in channels.values()), default=0)
    findings = list(_of_time(step, length, where)) if step is not None else []
    for name, values in channels.items():
        findings += _of_channel(
            name,
            values,
            step,
            units[name],
            place_in(where, name),
            (headers or {}).get(name, ""),
            is_read=written is not None,
        )
    if not findings and step is not None:
        findings += _of_work(channels, step, where)
        findings += _of_rates(channels, step, where)
    return findings


def _of_time(step: float, samples: int, where: str) -> Iterator[Finding]:
    if step > SLOWEST_STEP:
        likely = "ms" if step < 1e3 * SLOWEST_STEP else "µs"
        place = place_in(where, "time")
        yield finding("recordings.steps_too_long", place, step, step=step, likely=likely)
    elif step <= _FASTEST_STEP or (
        step <= _FAST_STEP and samples > _SOME and samples * step < _SHORT
    ):
        severity: Severity = "problem" if step <= _FASTEST_STEP else "warning"
        yield finding(
            "recordings.steps_too_short",
            place_in(where, "time"),
            step,
            severity=severity,
            step=step,
            rate=1.0 / step,
            duration=samples * step,
        )


def _number(kind: str, values: Array, step: float | None) -> float:
    if kind == "mean":
        return abs(float(values.mean()))
    if kind == "r.m.s.":
        return float(np.sqrt(np.mean(values**2)))
    if kind == "range":
        return float(np.ptp(values))
    if kind == "rate" and step is not None:
        return float(np.sqrt(np.mean(np.diff(values) ** 2))) / step
    return float(np.abs(values).max())


def _of_channel(
    name: str, values: Array, step: float | None, unit: str, at: str, header: str, *, is_read: bool
) -> Iterator[Finding]:
    quantity = quantity_of(name)
    is_body = any(part in _BODY for part in name.split("."))
    reaches = _BODY_HEAVE if is_body and quantity == "az" else REACHES.get(quantity)
    if values.size < 2 or reaches is None or "road" in place_of(name).split("."):
        return
    si = channel_unit(name)
    for reach in reaches:
        if step is None and reach.number not in ("peak", "range"):
            continue
        number = _number(reach.number, values, step)
        of = f"{si}/s" if reach.number == "rate" else si
        if number > reach.most:
            code = (
                "recordings.changes_too_fast" if reach.number == "rate" else "recordings.too_large"
            )
            advice = _advice(number, reach, unit, si, header)
            yield finding(
                code,
                at,
                number,
                number=reach.number,
                size=number,
                unit=of,
                most=reach.most,
                advice=advice,
            )
            return
        # Even smaller values come from a channel at rest, not from a wrong unit.
        if is_read and 1e-2 * reach.least < number < reach.least:
            advice = _advice(number, reach, unit, si, header)
            yield finding(
                "recordings.too_small",
                at,
                number,
                number=reach.number,
                size=number,
                unit=si,
                advice=advice,
            )
            return
    if (
        quantity == "az"
        and step is not None
        and values.size * step >= 1.0
        and abs(_number("mean", values, step) - 1.0)
        < 0.02  # allows for sensor offsets, and mounting angles up to 11 deg
    ):
        yield finding(
            "recordings.mean_of_gravity", at, values.mean(), mean=values.mean(), unit=unit
        )


def _advice(number: float, reach: Reach, unit: str, si: str, header: str) -> Finding:
    """Suggest the one or two units in which the value would be most usual."""
    likely: list[tuple[float, str]] = []
    middle = math.sqrt(reach.usual[0] * reach.usual[1])
    try:
        raw = number / conversion_factor(unit, si)
        for other in _UNITS.get(si, ()):
            factor = conversion_factor(other, si)
            if reach.usual[0] <= raw * factor <= reach.usual[1]:  # the value as read is outside
                likely.append((abs(math.log(raw * factor / middle)), other))
    except DescriptionError:
        likely.clear()
    names = [other for _, other in sorted(likely)[:2]]
    if not names:
        return finding("recordings.check_unit", "")
    code = "recordings.other_unit" if names[1:] == [] else "recordings.one_of_two_units"
    question = finding(code, "", first=names[0], second=names[-1], unit=unit)
    return (
        finding("recordings.map_unit", "", question=question, header=header, unit=names[0])
        if header
        else question
    )


def _beside(
    channels: Mapping[str, Array], first: tuple[str, ...], second: tuple[str, ...]
) -> Iterator[tuple[str, str]]:
    """Yield pairs of channels of the same part, the first with a quantity of ``first``, the other of ``second``."""
    for name in channels:
        if name.rpartition(".")[2] in first:
            for other in channels:
                if place_of(other) == place_of(name) and other.rpartition(".")[2] in second:
                    yield name, other


_STROKES = ("deflection", "displacement", "stroke", "travel")


def _of_work(channels: Mapping[str, Array], step: float, where: str) -> Iterator[Finding]:
    for stroke, force in _beside(channels, _STROKES, ("force",)):
        x, f = channels[stroke], channels[force]
        work = abs(float(np.sum(0.5 * (f[1:] + f[:-1]) * np.diff(x))))
        x0 = x - x.mean()
        cycles = max(1.0, 0.5 * np.count_nonzero(np.diff(np.signbit(x0))))
        power = work / (step * (x.size - 1))
        if work / cycles > MOST_WORK or power > MOST_POWER:
            yield finding(
                "recordings.work_too_large",
                place_in(where, force),
                work / cycles,
                work=work / cycles,
                stroke=stroke,
                power=power,
            )


_ROUNDING = 1e-12  # range of a constant channel, relative to its magnitude
_SAME = 0.95  # correlation above which two signals are equal apart from noise


def _of_rates(channels: Mapping[str, Array], step: float, where: str) -> Iterator[Finding]:
    pairs = [
        *_beside(channels, _STROKES, ("velocity", "deflection_velocity")),
        *_beside(channels, ("z",), ("vz",)),
        *_beside(channels, ("vz",), ("az",)),
    ]
    for name, rate in pairs:
        is_at_rest = np.ptp(channels[name]) <= _ROUNDING * np.max(np.abs(channels[name]))
        if "road" in place_of(name).split(".") or is_at_rest:
            continue
        yield from _of_sign(channels[name], channels[rate], name, place_in(where, rate))
        first, second = (
            _without_line(v)
            for v in (channels[name], np.cumsum(channels[rate] - channels[rate].mean()) * step)
        )
        sizes = float(first.std()), float(second.std())
        # Offsets and filters change the ratio by less than this, wrong units (mm, deg, g) by about ten or more.
        if min(sizes) > 0.0 and not 0.1 < sizes[1] / sizes[0] < 10.0:
            yield finding(
                "recordings.rates_disagree",
                place_in(where, rate),
                sizes[1] / sizes[0],
                times=sizes[1] / sizes[0],
                name=name,
            )


def _without_line(values: Array) -> Array:
    place = np.linspace(-1.0, 1.0, values.size)
    centred = values - values.mean()
    return np.asarray(centred - place * float(place @ centred) / float(place @ place), dtype=float)


def _of_sign(values: Array, rate: Array, name: str, at: str) -> Iterator[Finding]:
    """Report a rate with inverted or lost sign, for a signal that both rises and falls."""
    steps = np.gradient(values)
    # A lost sign cannot be detected if the signal only rises or only falls.
    if np.ptp(rate) == 0.0 or min(np.max(steps), -np.min(steps)) < 0.1 * np.max(np.abs(steps)):
        return
    if np.min(rate) >= 0.0 and _correlation(np.abs(steps), rate) > _SAME:
        yield finding("recordings.sign_lost", at, name=name)
    elif _correlation(steps, rate) < -_SAME:
        yield finding("recordings.sign_reversed", at, name=name)


def _correlation(first: Array, second: Array) -> float:
    """Return the correlation coefficient of two signals; NaN if either is constant."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return float(np.corrcoef(first, second)[0, 1])
