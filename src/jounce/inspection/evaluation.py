"""Evaluation of a measured or simulated tester record: values of each wheel, and findings about them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.constants import GRAVITY
from jounce.core.errors import RecordingError, unknown
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.inspection import checks
from jounce.inspection.findings import problem, sentence_of, warning
from jounce.inspection.methods import METHODS, WheelTest, find_boge, methods_on, stroke_by_turn
from jounce.inspection.record import FORCE, HEIGHT, SIDES, TACHO, read_facts, wheels_of
from jounce.inspection.result import FIELDS, Inspection, WheelCurves, WheelResult
from jounce.inspection.signals import (
    WheelSignals,
    mean_shaking,
    moving_part,
    signals_of,
    standstill_force,
    uniform_time,
)
from jounce.inspection.sweep import SWINGS, Sweep, exciter_height, find_sweep, spring_against_height
from jounce.inspection.turn_forces import analyse, find_lift_off, fit_test, stretches_between
from jounce.parts.testers import Tester, as_tester
from jounce.recordings.carried import as_recording
from jounce.recordings.schema import check_units

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


_MARGIN = 0.5  # s kept before and after the plate's motion
_SLOWEST = 0.3  # Hz: tacho frequency below which the drive is at rest
_AS_MUCH = 0.5  # share of the named plate's shaking: more than the car transmits to the other plate
_STANDING = 0.1e-3  # m: exciters of the shipped testers have strokes of 6 mm or more
_EXCITER = 0.3  # share of the stroke: an exciter's height is computed from noisy forces


@dataclass(frozen=True)
class _RecordTask:
    """Inputs shared by all wheels of a record."""

    tester: Tester | None
    vehicle_load: float | None
    methods: tuple[str, ...]
    rigid: bool


def evaluate(
    record: xr.Dataset | pd.DataFrame,
    tester: Tester | str | Path | None = None,
    vehicle: Any = None,
    methods: Iterable[str] | None = None,
) -> Inspection:
    """Evaluate the record of one axle on a tester.

    Parameters
    ----------
    record : xarray.Dataset or pandas.DataFrame
        Plate forces (N) and heights (m) on ``time`` (s) of one or two wheels, as returned by ``read_record`` and
        simulations; attributes such as ``left.static_load`` (N).
    tester : Tester, str or Path, optional
        Plate kind, mass, springs and limits; by default a rigid plate whose force needs no inertia compensation.
    vehicle : Rig or Vehicle, optional
        Vehicle under test; its wheel loads are compared with the measured static loads.
    methods : iterable of {"eusama", "egea", "theta", "boge"}, optional
        Methods to evaluate; by default all that the plate supports.

    Returns
    -------
    Inspection
        Values per wheel in SI with their uncertainties. A wheel with an unusable record has no values and is never
        graded; its findings and reasons explain why.

    Raises
    ------
        When there is no wheel in the record, or a channel of one is not in SI.
        When there is no wheel in the record.
    DescriptionError
        If a method is unknown or not supported by the plate.

    Examples
    --------
    >>> from jounce.inspection.quarter_car import LinearQuarterCar, force_response
    >>> from jounce.recordings import recording
    >>> t = np.arange(12000) / 1000.0
    >>> f = np.clip(25.0 - 2.5 * (t - 1.5), 0.1, 25.0)  # slow enough to be steady at every instant
    >>> angle = 2 * np.pi * np.cumsum(f) / 1000.0
    >>> z = 3e-3 * np.sin(angle)
    >>> gain = force_response(LinearQuarterCar(400.0, 40.0, 25e3, 1500.0, 200e3), f)
    >>> force = 4316.4 + 3e-3 * (gain.real * np.sin(angle) + gain.imag * np.cos(angle))
    >>> channels = {"left.plate.z": (z, "m", ""), "left.plate.force": (force, "N", "")}
    >>> found = evaluate(recording(t, channels, attributes={"left.static_load": 4316.4})).wheel("left")
    >>> round(found.adhesion, 2), found.lift_off
    (0.71, False)
    """
    record = as_recording(record, where="record")
    facts, notes = read_facts(record.attrs)
    tester = None if tester is None else as_tester(tester)
    task = _task(tester, vehicle, methods, str(facts.get("axle", "")))
    sides = tested_wheels(record, facts)
    names = [name for name in map(str, record.data_vars) if name.partition(".")[0] in sides]
    if names:
        check_units(record[names], where="record")
    channels = {name: np.asarray(record[name].values, dtype=float) for name in names}
    time = np.asarray(record["time"].values, dtype=float)
    gaps = checks.check_finite(channels, time)
    try:
        dataset, clock = uniform_time(record)
    except RecordingError as error:
        dataset, clock = record, [problem("time", "clock", text=error.message())]
    named = checks.check_tester(str(facts.get("tester", "")), tester)
    general = [*notes, *clock, *named]
    unfit = [finding for finding in (*clock, *gaps, *named) if finding.severity == "problem"]
    wheels = [
        _unfit(side, about)
        for side in sides
        if (about := [item for item in unfit if _concerns(item, side)])
    ]
    sound = tuple(side for side in sides if all(wheel.wheel != side for wheel in wheels))
    wheels += _evaluate_wheels(dataset, sound, facts, task) if sound else []
    wheels += _without_force(record, facts)
    wheels.sort(key=lambda wheel: SIDES.index(wheel.wheel))
    axle = {"axle": facts["axle"]} if "axle" in facts else {}
    return Inspection(tuple(wheels), axle, facts, task.methods, tuple(general))


def tested_wheels(record: xr.Dataset, facts: Mapping[str, Any]) -> tuple[str, ...]:
    """Return the tested wheels; if the record's wheel order names a single wheel, only that one.

    The car shakes the other plate slightly, a sprung plate more. A plate that moves as much as the named one also
    counts as tested, to detect swapped sides.
    """
    sides, order = wheels_of(record), facts.get("wheel_order")
    if order not in sides or len(sides) == 1:
        return sides
    shaken = {side: _shaking(record, side) for side in sides}
    return tuple(
        side for side in sides if side == order or shaken[side] > _AS_MUCH * shaken[str(order)]
    )


def _without_force(record: xr.Dataset, facts: Mapping[str, Any]) -> list[WheelResult]:
    """Return wheels whose plate moved but whose force is not in the record: a missing or misspelt column."""
    lost = []
    order = facts.get("wheel_order")
    for side in (order,) if order in SIDES else SIDES:
        force, height = f"{side}.{FORCE}", f"{side}.{HEIGHT}"
        if force not in record and height in record and _shaking(record, str(side)) > _STANDING:
            lost.append(
                _unfit(str(side), [problem(force, "force_missing", found=height, force=force)])
            )
    return lost


def _shaking(record: xr.Dataset, side: str) -> float:
    """Return the mean stroke (m) of a plate in short blocks; 0 without its height."""
    name, time = f"{side}.{HEIGHT}", np.asarray(record["time"].values, dtype=float)
    heights = record[name].to_numpy() if name in record else np.empty(0)
    known = heights[np.isfinite(heights)]
    length = float(time[-1] - time[0]) if known.size > 1 else 0.0
    return mean_shaking(known, (time.size - 1) / length) if length > 0.0 else 0.0


def require_gradable(inspection: Inspection, where: str = "record") -> None:
    """Raise an error unless every wheel of an inspection can be graded.

    Raises
    ------
    RecordingError
        With the first reason; commands exit with code 2.
    """
    for wheel in inspection.wheels:
        for finding in wheel.findings:
            if finding.severity == "problem":
                raise RecordingError(
                    finding.message.removesuffix("."), where=f"{where}: {finding.place}"
                )


def _task(
    tester: Tester | None, vehicle: Any, methods: Iterable[str] | None, axle: str
) -> _RecordTask:
    rigid = tester is None or tester.kind == "rigid-plate"
    possible = methods_on("rigid-plate" if tester is None else tester.kind)
    chosen = tuple(methods) if methods is not None else possible
    for method in chosen:
        if method not in possible:
            plate = "rigid" if rigid else "sprung"
            choices = METHODS if method not in METHODS else possible
            raise unknown(
                method,
                choices,
                what="method" if method not in METHODS else f"method of a {plate} plate",
            )
    return _RecordTask(
        tester, None if vehicle is None else wheel_load(vehicle, axle), chosen, rigid
    )


def wheel_load(vehicle: Any, axle: str = "") -> float | None:
    """Return the static load (N) of a quarter car's wheel or of each wheel of a vehicle's axle; None if unknown.

    Examples
    --------
    >>> from jounce.parts import load
    >>> [round(wheel_load(load("audi-a6-full-car"), axle)) for axle in ("front", "rear")]
    [4909, 3969]
    """
    masses = [
        getattr(getattr(vehicle, part, None), "mass", None) for part in ("sprung", "unsprung")
    ]
    known = [float(mass) for mass in masses if mass is not None]
    if len(known) == 2:
        return GRAVITY * sum(known)
    here, there = (
        getattr(vehicle, part, None)
        for part in (axle, {"front": "rear", "rear": "front"}.get(axle, ""))
    )
    if not all(hasattr(place, "unsprung_mass") for place in (here, there)):
        return None
    share = there.distance / (here.distance + there.distance)  # type: ignore[union-attr]
    return GRAVITY * float(0.5 * share * vehicle.body.mass + here.unsprung_mass)  # type: ignore[union-attr]


def _concerns(finding: Finding, side: str) -> bool:
    return finding.place in ("time", "tester") or finding.place.startswith(f"{side}.")


def _unfit(wheel: str, findings: list[Finding], load: float | None = None) -> WheelResult:
    problems = [item for item in findings if item.severity == "problem"]
    reasons, german = (
        tuple(sentence_of(item, language) for item in problems) for language in ("en", "de")
    )
    said = {"reasons": german}
    return WheelResult(
        wheel, static_load=load, findings=tuple(findings), reasons=reasons, german=said
    )


def _evaluate_wheels(
    record: xr.Dataset, sides: tuple[str, ...], facts: Mapping[str, Any], task: _RecordTask
) -> list[WheelResult]:
    signals = {side: signals_of(record, side, task.tester) for side in sides}
    stroke = task.tester.stroke if task.tester is not None else 6e-3
    heights, share = (
        {side: wheel.height for side, wheel in signals.items()},
        0.15 if task.rigid else 0.05,
    )
    if not task.rigid and any(
        spring_against_height(wheel, task.tester) < -SWINGS for wheel in signals.values()
    ):
        heights, share = (
            {side: exciter_height(wheel, task.tester) for side, wheel in signals.items()},
            _EXCITER,
        )
    beside = {side: next((heights[name] for name in sides if name != side), None) for side in sides}
    moving = {
        side: _moving(wheel, heights[side], share * stroke, beside[side])
        for side, wheel in signals.items()
    }
    measured = {}
    for side, wheel in signals.items():
        span, other = moving[side], next((moving[name] for name in sides if name != side), None)
        if span is not None:
            still = standstill_force(wheel, span, other)
            measured[side] = (
                float(np.mean(wheel.force[span[0] : span[1]])) if still is None else still
            )
    pair = checks.check_pair({side: wheel.static_load for side, wheel in signals.items()}, measured)
    pair += checks.check_order(str(facts.get("wheel_order", "")), moving)
    results = []
    for side, wheel in signals.items():
        pair = pair if side == sides[0] or _is_unfit(pair) else []
        other = next((moving[name] for name in sides if name != side), None)
        raw = np.asarray(record[f"{side}.{FORCE}"].values, dtype=float)
        results.append(
            _evaluate_wheel(wheel, raw, moving[side], other, measured.get(side), pair, facts, task)
        )
    return results


def _moving(
    signals: WheelSignals, height: Array | None, least: float, other: Array | None
) -> tuple[int, int] | None:
    if height is not None:
        return moving_part(height, signals.sample_rate, least, other)
    if signals.tacho is None:
        return None
    turning = np.flatnonzero(signals.tacho > _SLOWEST)
    return (int(turning[0]), int(turning[-1]) + 1) if turning.size else None


def _evaluate_wheel(
    signals: WheelSignals,
    raw: Array,
    span: tuple[int, int] | None,
    other: tuple[int, int] | None,
    measured: float | None,
    pair: list[Finding],
    facts: Mapping[str, Any],
    task: _RecordTask,
) -> WheelResult:
    wheel, tester = signals.wheel, task.tester
    findings = [
        *checks.check_columns(signals, raw, tester),
        *checks.check_sampling(signals, tester),
    ]
    if signals.height is None and signals.tacho is None:
        names = {"height": f"{wheel}.{HEIGHT}", "tacho": f"{wheel}.{TACHO}"}
        findings.append(problem(f"{wheel}.{FORCE}", "no_frequency", **names))
    elif (span is None or measured is None) and not _is_unfit(findings):
        findings.append(problem(f"{wheel}.plate.z", "plate_never_moves"))
    if _is_unfit(findings) or span is None or measured is None:
        return _unfit(wheel, findings, signals.static_load)
    findings += pair if _is_unfit(pair) else [*pair, *checks.check_load(signals, measured, tester)]
    load = signals.static_load if signals.static_load is not None else measured
    findings += checks.check_clipping(raw[span[0] : span[1]], load, f"{wheel}.{FORCE}")
    findings += checks.check_dropout(raw[span[0] : span[1]], signals, load)
    findings += checks.check_together(raw, span, load, wheel)
    findings += checks.check_resolution(signals, raw, load)
    step = 1.0 / signals.sample_rate
    findings += checks.check_other_plate(
        wheel, span, other, step, str(facts.get("wheel_order", ""))
    )
    findings += _vehicle_findings(load, task.vehicle_load, wheel)
    margin = round(_MARGIN * signals.sample_rate)
    cut = signals.part(max(span[0] - margin, 0), min(span[1] + margin, raw.size))
    sweep, about = find_sweep(cut, tester, rigid=task.rigid)
    findings += (
        [problem(f"{wheel}.{HEIGHT}", "upside_down")] if _swings_upside_down(cut, tester) else about
    )
    if _is_unfit(findings) or sweep is None:
        return _unfit(wheel, findings, load)
    result = _on_rigid_plate if task.rigid else _on_sprung_plate
    return result(cut, sweep, load, findings, task)


def _swings_upside_down(signals: WheelSignals, tester: Tester | None) -> bool:
    """Whether a plate's height is inverted: its spring seems to push it away from the middle instead of back."""
    if signals.height is None or tester is None or tester.plate_spring_rate is None:
        return False
    return (
        float(np.ptp(signals.height)) > tester.stroke
        and spring_against_height(signals, tester) > SWINGS
    )


def _is_unfit(findings: list[Finding]) -> bool:
    return any(finding.severity == "problem" for finding in findings)


def _vehicle_findings(load: float, expected: float | None, wheel: str) -> list[Finding]:
    if expected is None or abs(load / expected - 1.0) < 0.15:  # 75 kg on an Audi A6's front wheel
        return []
    return [
        warning(
            f"{wheel}.static_load", "other_vehicle", load / expected, load=load, expected=expected
        )
    ]


def _on_rigid_plate(
    signals: WheelSignals, sweep: Sweep, load: float, findings: list[Finding], task: _RecordTask
) -> WheelResult:
    wheel = signals.wheel
    strokes = stroke_by_turn(signals.height, signals.time, sweep.turns)
    if strokes is not None:
        uneven = checks.check_rigid(strokes, sweep.turns.frequency, f"{wheel}.{HEIGHT}")
        findings += uneven or checks.check_even_stroke(signals, sweep.turns)
    analysis, about = analyse(signals, sweep, load)
    findings += about
    swing = np.nan_to_num(
        analysis.modelled[:, 5] - load
    )  # an undamped body oscillates for a long time
    steady = analysis.measured[:, 5] - swing
    hops = bool(analysis.lifted.any())
    if hops:  # landings compensate for airborne phases, so the whole force is averaged
        steady = _mean_by_turn(signals, analysis.top)
    findings += checks.check_wandering(steady, analysis.frequency, load, wheel, hops=hops)
    if _is_unfit(findings):
        return _unfit(wheel, findings, load)
    test = WheelTest(signals, sweep, load, task.tester, analysis.fit, analysis)
    if test.adhesion is None:
        findings.append(problem(f"{wheel}.{FORCE}", "no_turn"))
        return _unfit(wheel, findings, load)
    if test.adhesion.lift_off:
        findings.append(warning(f"{wheel}.{FORCE}", "lift_off", 0.0))
    known = {
        "lift_off": test.adhesion.lift_off,
        "resonance_frequency_hz": test.adhesion.frequency_hz,
    }
    curves = WheelCurves(
        analysis.top,
        analysis.frequency,
        analysis.measured[:, 0],
        analysis.measured[:, 2],
        np.full(analysis.top.size, np.nan),
        np.full(analysis.top.size, analysis.amplitude),
    )
    return _by_methods(test, known, findings, curves, task.methods)


def _mean_by_turn(signals: WheelSignals, top: Array) -> Array:
    """Return the mean force (N) from the top of each turn (n,) in s to the next; NaN for the last."""
    at = np.clip(
        np.round((top - signals.time[0]) * signals.sample_rate).astype(int), 0, signals.force.size
    )
    sums = np.concatenate([[0.0], np.cumsum(signals.force)])
    return np.append((sums[at[1:]] - sums[at[:-1]]) / np.maximum(np.diff(at), 1), np.nan)


def _on_sprung_plate(
    signals: WheelSignals, sweep: Sweep, load: float, findings: list[Finding], task: _RecordTask
) -> WheelResult:
    wheel, tester, height = signals.wheel, task.tester, signals.height
    if height is None or tester is None:
        findings.append(problem(f"{wheel}.plate.z", "height_missing"))
        return _unfit(wheel, findings, load)
    strokes = stroke_by_turn(height, signals.time, sweep.turns)
    if strokes is not None:
        findings += checks.check_sprung(strokes, sweep.turns.frequency, signals, tester)
    if _is_unfit(findings):
        return _unfit(wheel, findings, load)
    rate = signals.sample_rate
    lifted = find_lift_off(signals.force, load, rate)
    model = np.full(height.size, np.nan)
    highest = max(sweep.highest, tester.programme.start_frequency, tester.programme.end_frequency)
    parts = stretches_between(lifted, 0, height.size, rate)
    upright = spring_against_height(signals, tester) < -SWINGS
    fit, about = fit_test(signals, parts, load, 1.2 * highest, model, upright=upright)
    findings += about
    if _is_unfit(findings):
        return _unfit(wheel, findings, load)
    test = WheelTest(signals, sweep, load, tester, fit)
    known: dict[str, Any] = {"lift_off": bool(lifted.any())}
    movement = find_boge(test)
    if movement is not None:
        known["resonance_frequency_hz"] = movement.frequency_hz
    if lifted.any():
        findings.append(warning(f"{wheel}.{FORCE}", "lift_off_left_out"))
    turns = sweep.turns
    empty = np.full(turns.top.size, np.nan)
    amplitudes = empty if test.strokes is None else 0.5 * test.strokes
    curves = WheelCurves(turns.top, turns.frequency, empty, empty, empty, amplitudes)
    return _by_methods(test, known, findings, curves, task.methods)


def _by_methods(
    test: WheelTest,
    known: dict[str, Any],
    findings: list[Finding],
    curves: WheelCurves,
    chosen: Iterable[str],
) -> WheelResult:
    """Combine the results of the chosen methods with the method-independent values."""
    halves: dict[str, float | None] = {}
    unreliable: dict[str, None] = {}
    for key, method in METHODS.items():
        if key in chosen:
            result = method.evaluate(test)
            known, halves, findings = (
                known | result.values,
                halves | result.half_widths,
                findings + result.findings,
            )
            unreliable |= dict.fromkeys(result.unreliable)
            curves = (
                curves if result.phase_deg is None else replace(curves, phase_deg=result.phase_deg)
            )
    return WheelResult(
        wheel=test.signals.wheel,
        static_load=test.load,
        uncertainty={
            key: float(half)
            for key, half in halves.items()
            if half is not None and np.isfinite(half)
        },
        unreliable=tuple(unreliable),
        corner=None if test.fit is None else test.fit.corner,
        findings=tuple(findings),
        curves=curves,
        **{key: value for key, value in known.items() if key in FIELDS},
        more={key: value for key, value in known.items() if key not in FIELDS},
    )
