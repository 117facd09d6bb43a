"""Evaluation of bench files, which gives a rig its start values, and the state of knowledge during a campaign.

A bench table that fails does not stop the others.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.polynomial import Polynomial

from jounce.campaign.description import Bench, DecayBench, StiffnessBench
from jounce.core.errors import RecordingError, reason
from jounce.core.findings import Finding, at_place, finding
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.design.lumping import lump
from jounce.identify.decay import (
    CombinedDecay,
    DecayResult,
    combine_decays,
    fit_decay,
    ratio_from_decrement,
)
from jounce.identify.estimate import Estimate
from jounce.identify.force_deflection import ForceDeflectionTrial
from jounce.identify.motion import TRANSLATION, MeasuredMotion, MotionName
from jounce.identify.signs import ForcePositive, StrokePositive, check_stroke, compression_positive
from jounce.identify.stiffness import (
    PressureStiffness,
    StiffnessResult,
    fit_stiffness,
    stiffness_against_pressure,
)
from jounce.identify.update import UpdatedParameter
from jounce.inspection.quarter_car import LinearQuarterCar, road_poles, road_polynomial
from jounce.parts import Corner, Rig
from jounce.parts.leverage import static_spring_force
from jounce.parts.variants import with_strut_angle
from jounce.recordings import Sensor, channel_unit
from jounce.recordings.formats import TableFormat
from jounce.simulation import linearise

TyreTable = dict[str, Any]
TYRE_PATHS = ("tyre.stiffness", "tyre.curve")
"""Path prefixes of the tyre's elastic law, which is stored separately for each pressure."""


@dataclass(frozen=True)
class Knowledge(Shown):
    """Rig values that apply to all trials, and the tyre's elastic law by pressure (Pa).

    ``between`` returns the tyre at a pressure that was not measured; it is None if the pressure dependence is unknown.
    """

    rig: Rig
    tyres: Mapping[float, TyreTable] = field(default_factory=dict)
    between: Callable[[float], TyreTable] | None = None

    def tyre_at(self, pressure: float | None) -> TyreTable:
        """Return the tyre's elastic law at a pressure (Pa) as a table of a rig file; empty for the rig's own law."""
        if pressure is None:
            return {}
        if pressure in self.tyres:
            return self.tyres[pressure]
        return self.between(pressure) if self.between is not None else {}

    def rig_for(
        self,
        strut_angle: float | None,
        pressure: float | None,
        changes: Mapping[str, Any],
        added_mass: float = 0.0,
    ) -> Rig:
        """Return the rig as set up for one trial: strut angle (rad), pressure (Pa), changes by path, added mass (kg).

        The strut of a 3-D rig is rotated about its lower end, see :func:`jounce.parts.variants.with_strut_angle`.
        """
        rig = with_tyre(self.rig, self.tyre_at(pressure))
        rig = rig if strut_angle is None else with_strut_angle(rig, strut_angle)
        rig = rig.with_changes(dict(changes)) if changes else rig
        return (
            rig.with_changes({SPRUNG_MASS: rig.parameters()[SPRUNG_MASS] + added_mass})
            if added_mass
            else rig
        )

    def after(
        self, fitted: Mapping[str, UpdatedParameter], pressures: Sequence[float | None]
    ) -> Knowledge:
        """Adopt fitted values; values of the tyre apply only at the pressures of the fitted trials."""
        tyre = {path: p for path, p in fitted.items() if path.startswith(TYRE_PATHS)}
        rig = self.rig.with_changes(
            {path: p.value for path, p in fitted.items() if path not in tyre}
        )
        if not tyre:
            return Knowledge(rig, self.tyres, self.between)
        tyres = dict(self.tyres)
        for pressure in dict.fromkeys(pressures):
            set_up = with_tyre(rig, self.tyre_at(pressure))
            start = set_up.parameters()
            scaled = set_up.with_changes(
                {
                    path: start[path] * p.value / p.initial if p.initial else p.value
                    for path, p in tyre.items()
                }
            )
            if pressure is not None:
                tyres[pressure] = tyre_of(scaled)
            if pressure == pressures[0]:
                rig = scaled
        return Knowledge(rig, tyres, self.between)


def with_tyre(rig: Rig, table: TyreTable) -> Rig:
    """Return the rig with the elastic law of its tyre replaced; an empty table changes nothing."""
    if not table:
        return rig
    dump = rig.model_dump(by_alias=True, exclude_none=True)
    others = {
        key: value for key, value in dump["tyre"].items() if key not in ("stiffness", "curve")
    }
    return type(rig).from_table({**dump, "tyre": {**others, **table}})


def tyre_of(rig: Rig) -> TyreTable:
    """Return the elastic law of a rig's tyre as a table of a rig file."""
    tyre = rig.model_dump(by_alias=True, exclude_none=True)["tyre"]
    return {key: tyre[key] for key in ("stiffness", "curve") if key in tyre}


@dataclass(frozen=True)
class Replaced:
    """A rig value that was replaced by a measurement, SI."""

    path: str
    described: float | None
    measured: float
    standard_error: float | None
    source: str


@dataclass(frozen=True)
class DampingChoice:
    """One interpretation of the decays: damping ratio (1), coefficients at the sprung mass and the strut (N s/m).

    ``at_strut`` is None if the rig's damper is not a single coefficient; ``is_used`` marks the campaign's choice.
    """

    method: str
    damping_ratio: Estimate
    seen: Estimate
    at_strut: Estimate | None
    is_used: bool


@dataclass
class Characterisation(Shown):
    """Results of all bench tables, and the rig values that they replaced.

    ``loaded`` holds the fitted trials of the test machine by table, e.g. ``bench.tyre."0.31 MPa"``.
    """

    spring: StiffnessResult | None = None
    tyre: dict[str, StiffnessResult] = field(default_factory=dict)
    tyre_polynomial: dict[str, StiffnessResult] = field(default_factory=dict)
    pressure: PressureStiffness | None = None
    decay: DecayResult | CombinedDecay | None = None
    decays: tuple[DecayResult, ...] = ()
    damping_choices: tuple[DampingChoice, ...] = ()
    replaced: list[Replaced] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    failed: list[str] = field(default_factory=list)
    loaded: dict[str, list[ForceDeflectionTrial]] = field(default_factory=dict)


def characterise(
    rig: Rig, bench: Bench, folder: Path, sensors: Mapping[str, Sensor] | None = None
) -> tuple[Characterisation, Knowledge]:
    """Evaluate all bench tables (files relative to ``folder``); return results and the rig with measured values."""
    measured = Characterisation()
    knowledge = Knowledge(rig)
    steps: list[tuple[Callable[..., Knowledge], str, Any]] = [
        (_spring, "bench.spring", bench.spring),
        (_tyre, "bench.tyre", bench.tyre),
        (partial(_decay, sensors=sensors), "bench.decay", bench.decay),
    ]
    for step, place, table in steps:
        if not table:
            continue
        try:
            knowledge = step(measured, knowledge, table, folder)
        except Exception as error:  # noqa: BLE001 - one bad file must not stop the others
            measured.failed.append(place)
            measured.findings.append(
                finding("campaign.described_value_used", place, error=reason(error))
            )
    return measured, knowledge


def files_of(patterns: tuple[str, ...], folder: Path, where: str) -> list[Path]:
    """Find the files of a table without duplicates; every pattern must match at least one file."""
    files: list[Path] = []
    for pattern in patterns:
        matches = (
            sorted(folder.glob(pattern)) if not Path(pattern).is_absolute() else [Path(pattern)]
        )
        if not matches:
            raise RecordingError(
                "no file matches",
                where=where,
                found=pattern,
                hint=Phrase("The pattern is relative to {folder}.", folder=folder),
            )
        files += [
            file for file in matches if file not in files
        ]  # a file counted twice would look like a repetition
    return files


_COLUMNS: dict[MotionName, dict[str, str]] = {
    "translation": {"displacement": "m", "force": "N"},
    "rotation": {"angle": "rad", "torque": "N*m"},
}


def read_force_deflection(
    files: list[Path],
    table: TableFormat,
    stroke_positive: StrokePositive | None = None,
    force_positive: ForcePositive | None = None,
    motions: Sequence[MeasuredMotion] = (TRANSLATION,),
) -> tuple[list[ForceDeflectionTrial], list[Finding]]:
    """Read trials of a test machine: ``displacement`` (m) and ``force`` (N), positive in compression by default.

    With ``ROTATION`` in ``motions``, files with ``angle`` (rad) and ``torque`` (N m) are also read.
    """
    trials, findings = [], []
    for file in files:
        values, notes = table.read_columns(file, [_COLUMNS[kind.name] for kind in motions])
        motion = next(kind for kind in motions if set(_COLUMNS[kind.name]) == set(values))
        deflection, force = values.values()
        trials.append(
            ForceDeflectionTrial(
                deflection, force, file.name, stroke_positive, force_positive, motion.name
            )
        )
        findings += notes
    return trials, findings


def _fit(
    table: StiffnessBench,
    folder: Path,
    where: str,
    load: float,
    measured: Characterisation,
    **choice: Any,
) -> StiffnessResult:
    paths = files_of(table.files, folder, where)
    trials, findings = read_force_deflection(
        paths, table, table.stroke_positive, table.force_positive
    )
    settings: dict[str, Any] = {
        "law": table.law,
        "degree": table.degree,
        "discard_below": table.discard_below,
        "intercept": table.intercept,
        "branch": table.branch,
        "operating_force": load
        if load > 0.0
        else None,  # a torsion bar or a third spring may carry the entire load
        **choice,
    }
    result = fit_stiffness(trials, **settings)
    measured.loaded.setdefault(where.removesuffix(" as polynomial"), trials)
    measured.findings += [
        at_place(f"{where}: {item.place}", item) for item in (*findings, *result.findings)
    ]
    return result


def _has_value(
    measured: Characterisation, place: str, findings: Sequence[Finding], estimate: Estimate
) -> bool:
    """Whether a bench result may replace the described value; otherwise a finding states the reason."""
    problem = next((item.message for item in findings if item.severity == "problem"), None)
    unsure = estimate.standard_error is not None and estimate.standard_error > _UNSURE * abs(
        estimate.value
    )
    if problem is None and not unsure:
        return True
    why = problem or f"{estimate.value:.3g} ± {estimate.standard_error:.2g} is no value"
    measured.findings.append(finding("campaign.replaces_nothing", place, error=why))
    return False


_UNSURE = 0.5
"""Relative standard error above which a bench result is discarded: its interval includes zero and twice the value."""


def _spring(
    measured: Characterisation, knowledge: Knowledge, table: StiffnessBench, folder: Path
) -> Knowledge:
    rig = knowledge.rig
    values = rig.parameters()
    result = measured.spring = _fit(
        table, folder, "bench.spring", _static_spring_force(rig), measured
    )
    if not _has_value(measured, "bench.spring", result.findings, result.stiffness):
        return knowledge
    dump = rig.model_dump(by_alias=True, exclude_none=True)
    dump["strut"]["spring"] = _measured_spring(result, values)
    measured.replaced.append(
        Replaced(
            "strut.spring.rate",
            values.get("strut.spring.rate"),
            result.stiffness.value,
            result.stiffness.standard_error,
            "bench.spring",
        )
    )
    return Knowledge(type(rig).from_table(dump), knowledge.tyres, knowledge.between)


def _measured_spring(result: StiffnessResult, values: Mapping[str, float]) -> dict[str, Any]:
    """Return the table of the spring with its measured law; the rig's preload or free length is kept."""
    load = {
        key: values[f"strut.spring.{key}"]
        for key in ("preload", "free_length")
        if f"strut.spring.{key}" in values
    }
    if result.law != "linear":
        return {**load, "curve": result.curve.to_table(result.fitted_range[1])}
    rate = result.stiffness.value
    if result.intercept_choice == "keep" and result.intercept is not None:
        if "free_length" in load:
            load["free_length"] += result.intercept.value / rate
        else:
            load["preload"] = result.intercept.value
    return {**load, "rate": rate}


def _static_spring_force(rig: Rig) -> float:
    """Return the static spring force in N; for a 3-D rig in the design position."""
    if isinstance(rig, Corner):
        return static_spring_force(rig)
    values = rig.parameters()
    return values["sprung.mass"] * values["gravity"] / math.cos(values.get("strut.angle", 0.0))


def static_tyre_force(rig: Rig) -> float:
    """Return the static tyre load of the rig in N."""
    values = rig.parameters()
    if isinstance(rig, Corner):
        masses = [body.mass for body in rig.body_masses().values()]
        return (values.get("sprung.mass", 0.0) + sum(masses)) * rig.gravity
    return (values["sprung.mass"] + values["unsprung.mass"]) * values["gravity"]


def _tyre(
    measured: Characterisation,
    knowledge: Knowledge,
    tables: dict[str, StiffnessBench],
    folder: Path,
) -> Knowledge:
    values = knowledge.rig.parameters()
    load = static_tyre_force(knowledge.rig)
    tyres = {}
    for name, table in tables.items():
        place, pressure = f'bench.tyre."{name}"', to_si(name, "Pa", where="bench.tyre")
        result = measured.tyre[name] = _fit(table, folder, place, load, measured)
        if not _has_value(measured, place, result.findings, result.stiffness):
            continue
        tyres[pressure] = _tyre_table(result)
        measured.replaced.append(
            Replaced(
                "tyre.stiffness",
                values.get("tyre.stiffness"),
                result.stiffness.value,
                result.stiffness.standard_error,
                place,
            )
        )
    if not tyres:
        return knowledge
    points = [
        (at, measured.tyre[name].stiffness) for name in tables if (at := to_si(name, "Pa")) in tyres
    ]
    measured.pressure = stiffness_against_pressure(points)
    measured.findings += measured.pressure.findings
    linear = all(result.law == "linear" for result in measured.tyre.values())
    between = partial(_interpolate, measured) if linear else partial(_nearest, tyres)
    first = next(iter(tyres.values()))
    return Knowledge(with_tyre(knowledge.rig, first), tyres, between)


def _nearest(tyres: Mapping[float, dict[str, Any]], pressure: float) -> dict[str, Any]:
    """Return the tyre table measured at the nearest pressure (Pa)."""
    return tyres[min(tyres, key=lambda known: abs(known - pressure))]


def _interpolate(measured: Characterisation, pressure: float) -> dict[str, Any]:
    """Interpolate the tyre table at a pressure (Pa) between the measured pressures."""
    assert measured.pressure is not None
    stiffness, notes = measured.pressure.at(pressure)
    measured.findings += [note for note in notes if note not in measured.findings]
    return {"stiffness": stiffness.value}


def polynomial_tyres(
    bench: Bench, knowledge: Knowledge, folder: Path, measured: Characterisation
) -> Knowledge:
    """Replace the tyre's stiffness by its measured curve (cubic through the origin, fitted to all points)."""
    load = static_tyre_force(knowledge.rig)
    tyres = {}
    for name, table in bench.tyre.items():
        if name not in measured.tyre_polynomial:
            measured.tyre_polynomial[name] = _fit(
                table,
                folder,
                f'bench.tyre."{name}" as polynomial',
                load,
                measured,
                law="polynomial",
                discard_below=0.0,
            )
        tyres[to_si(name, "Pa")] = _tyre_table(measured.tyre_polynomial[name])
    if not tyres:
        raise RecordingError(
            'tyre_law = "polynomial" needs measured tyre curves',
            where="update",
            allowed='a [bench.tyre."P"] table',
        )

    return Knowledge(
        with_tyre(knowledge.rig, next(iter(tyres.values()))), tyres, partial(_nearest, tyres)
    )


def _tyre_table(result: StiffnessResult) -> dict[str, Any]:
    if result.law == "linear":
        return {"stiffness": result.stiffness.value}
    return {"curve": result.curve.to_table(result.fitted_range[1])}


@dataclass(frozen=True)
class DecayRecord:
    """A free decay as read: file, time (s), signal (SI, positive in compression), and the reader's findings."""

    file: str
    time: Array
    signal: Array
    findings: tuple[Finding, ...]


def decay_records(
    table: DecayBench, folder: Path, sensors: Mapping[str, Sensor] | None = None
) -> list[DecayRecord]:
    """Read the free decays of a campaign; file names are relative to ``folder``."""
    records = []
    for file in files_of(table.files, folder, "bench.decay"):
        data, notes = table.read(file, folder, sensors)
        data = compression_positive(data, table.stroke_positive, None)
        if table.channel not in data:
            raise RecordingError(
                "the channel is missing",
                where=file.name,
                found=", ".join(map(str, data.data_vars)),
                allowed=table.channel,
            )
        time, signal = data["time"].to_numpy(), data[table.channel].to_numpy()
        records.append(DecayRecord(file.name, time, signal, tuple(notes)))
    return records


def _decay(
    measured: Characterisation,
    knowledge: Knowledge,
    table: DecayBench,
    folder: Path,
    sensors: Mapping[str, Sensor] | None = None,
) -> Knowledge:
    """Estimate the damping at the strut from free decays of the sprung mass.

    With the hub blocked, the decay measures the damping referred to the wheel, ``c_w = c r^2`` (motion ratio ``r``, or
    ``cos(angle)`` for a lumped rig). With the wheel on its tyre, the decay rate is that of the body mode of the
    two-mass system with ``c_w``; for light damping and a light wheel the apparent damping is
    ``c_w (k_t / (k_w + k_t))^2``.
    """
    rig = knowledge.rig
    values = rig.parameters()
    seen_at = _at_wheel(rig)
    on_tyre = table.support == "tyre"
    results = []
    check_stroke(table.channel, table.stroke_positive, where="bench.decay.stroke_positive")
    for record in decay_records(table, folder, sensors):
        time, signal = record.time, record.signal
        measured.findings += record.findings
        asked: dict[str, Any] = {"mass": seen_at.sprung_mass, "quantity": _quantity(table.channel)}
        asked |= {"begin": table.from_, "end": table.to, "name": record.file}
        stiffness: float | None = seen_at.wheel_rate
        if on_tyre:
            plain = fit_decay(time, signal, quadratic_drag="no", **asked)
            stiffness = seen_at.stiffness_behind(plain.damping_coefficient.value)
        results.append(
            fit_decay(
                time, signal, stiffness=stiffness, quadratic_drag=table.quadratic_drag, **asked
            )
        )
    measured.decays = tuple(results)
    measured.decay = combine_decays(results) if len(results) > 1 else results[0]
    measured.findings += [
        at_place(f"bench.decay: {item.place}", item) for item in measured.decay.findings
    ]
    has_coefficient = "strut.damper.coefficient" in values
    refer: Callable[[float], tuple[float, float]] = (
        seen_at.refer if on_tyre else lambda seen: (seen, 1.0)
    )
    measured.damping_choices = _damping_choices(
        measured.decay, seen_at, refer if has_coefficient else None, table.method
    )
    if not has_coefficient:
        measured.findings.append(finding("campaign.decay_not_used", "bench.decay"))
        return knowledge
    at_strut = next(choice.at_strut for choice in measured.damping_choices if choice.is_used)
    assert at_strut is not None
    if not math.isfinite(at_strut.value):
        raise RecordingError(
            "the decays have too few oscillations for a logarithmic decrement",
            where="bench.decay.method",
        )
    seen = next(choice.seen for choice in measured.damping_choices if choice.is_used)
    if not _has_value(measured, "bench.decay", measured.decay.findings, at_strut):
        return knowledge
    if on_tyre and seen_at.damping_behind(seen.value) is None:
        measured.findings.append(finding("campaign.decay_too_fast", "bench.decay", seen.value))
    measured.replaced.append(
        Replaced(
            "strut.damper.coefficient",
            values["strut.damper.coefficient"],
            at_strut.value,
            at_strut.standard_error,
            "bench.decay",
        )
    )
    changed = rig.with_changes({"strut.damper.coefficient": max(at_strut.value, 0.0)})
    return Knowledge(changed, knowledge.tyres, knowledge.between)


def _damping_choices(
    decay: DecayResult | CombinedDecay,
    seen_at: _AtWheel,
    refer: Callable[[float], tuple[float, float]] | None,
    method: str,
) -> tuple[DampingChoice, ...]:
    """Interpret the decays by both methods; ``refer`` converts a coefficient to the wheel and returns its slope."""
    mass = seen_at.sprung_mass
    decrement = decay.logarithmic_decrement
    ratio = ratio_from_decrement(decrement.value) if math.isfinite(decrement.value) else math.inf
    slope = (2.0 * math.pi) ** 2 / ((2.0 * math.pi) ** 2 + decrement.value**2) ** 1.5
    critical = 4.0 * math.pi * decay.natural_frequency_hz.value * mass
    naive = _scale_estimate(
        Estimate(decrement.value, decrement.standard_error, decrement.interval), slope, ratio
    )
    ways = {
        "viscous-and-coulomb": (decay.damping_ratio, decay.damping_coefficient),
        "logarithmic-decrement": (naive, _scale_estimate(naive, critical, ratio * critical)),
    }

    def at_strut(seen: Estimate) -> Estimate | None:
        if refer is None or not math.isfinite(seen.value):
            return None if refer is None else Estimate(seen.value)
        value, slope = refer(seen.value)
        return _scale_estimate(seen, slope / seen_at.lever, value / seen_at.lever)

    return tuple(
        DampingChoice(name, damping_ratio, seen, at_strut(seen), name == method)
        for name, (damping_ratio, seen) in ways.items()
    )


def _scale_estimate(source: Estimate, factor: float, value: float) -> Estimate:
    """Propagate an estimate to a dependent quantity with value ``value`` and derivative ``factor``."""
    if source.standard_error is None or source.interval is None or not math.isfinite(value):
        return Estimate(value)
    low, high = (value + factor * (end - source.value) for end in source.interval)
    return Estimate(value, factor * source.standard_error, (low, high))


def _quantity(channel: str) -> Literal["displacement", "velocity", "acceleration"]:
    """Return the quantity of a decay channel according to its unit."""
    unit = channel_unit(channel)
    kinds: dict[str, Literal["displacement", "velocity", "acceleration"]] = {
        "m": "displacement",
        "m/s": "velocity",
        "m/s^2": "acceleration",
    }
    if unit not in kinds:
        allowed = "a displacement, velocity or acceleration"
        raise RecordingError(
            "invalid motion", where=f"bench.decay: channel {channel!r}", found=unit, allowed=allowed
        )
    return kinds[unit]


@dataclass(frozen=True)
class _AtWheel:
    """Properties of a rig at rest: rates of strut and tyre at the wheel (N/m), masses (kg), tyre damping (N s/m).

    ``lever`` is the ratio of the damping at the wheel to the damping of the damper (1).
    """

    wheel_rate: float
    tyre_rate: float
    sprung_mass: float
    unsprung_mass: float
    tyre_damping: float
    lever: float

    def swing(self, damping: float) -> tuple[float, float]:
        """Return damping (N s/m) and stiffness (N/m) of the single mass equivalent to the body, for a wheel damping."""
        masses = self.sprung_mass, self.unsprung_mass
        poles = road_poles(
            LinearQuarterCar(*masses, self.wheel_rate, damping, self.tyre_rate, self.tyre_damping)
        )
        upper = poles[poles.imag > 1e-6 * np.abs(poles)]
        if not upper.size:
            return math.nan, math.nan
        pole = upper[int(np.argmin(np.abs(upper)))]
        return -2.0 * self.sprung_mass * float(pole.real), self.sprung_mass * float(abs(pole)) ** 2

    def stiffness_behind(self, seen: float) -> float | None:
        """Return the stiffness (N/m) of that mass for its damping (N s/m); None if no wheel damping produces it."""
        at_wheel = self.damping_behind(seen)
        return None if at_wheel is None else self.swing(at_wheel[0])[1]

    def refer(self, seen: float) -> tuple[float, float]:
        """Convert the damping of a single mass (N s/m) to damping at the wheel (N s/m); return its slope (1), too.

        A decay faster than any wheel damping allows is scaled by the strut's share of the static deflection.
        """
        return self.damping_behind(seen) or (seen / self._share**2, 1.0 / self._share**2)

    @property
    def _share(self) -> float:
        """Strut's share of the body's deflection under a static load."""
        return self.tyre_rate / (self.wheel_rate + self.tyre_rate)

    def damping_behind(self, seen: float) -> tuple[float, float] | None:
        """Find the minimum wheel damping (N s/m) for the damping of a single mass (N s/m), and its slope (1).

        Return None if there is no solution: the decay rate of the body mode is bounded, and beyond some damping
        the mode is no longer oscillatory or no longer the slowest.

        The system has a pole ``p`` for the damping ``c`` if ``P(p) + c Q(p) = 0``. The real part of ``p`` is known;
        requiring a real ``c`` gives a cubic equation for the square of its imaginary part.
        """
        least = self.swing(0.0)[0] - seen
        if least >= 0.0:  # the tyre's damping alone is sufficient
            return -least / self._share**2, 1.0 / self._share**2
        plain, damped = self._characteristic
        along = Polynomial([-seen / (2.0 * self.sprung_mass), 1j])
        product = plain(along) * Polynomial(damped(along).coef.conj())
        poles = along(np.sqrt(_positive_roots(Polynomial(product.coef.imag[1::2]))))
        dampings, end = -(plain(poles) / damped(poles)).real, self._end
        for i in np.argsort(dampings):
            value, pole = float(dampings[i]), poles[i]
            if 0.0 < value < end and abs(self.swing(value)[0] - seen) < _SAME_SWING * seen:
                slope = damped(pole) / (plain.deriv()(pole) + value * damped.deriv()(pole))
                return value, 1.0 / (2.0 * self.sprung_mass * float(slope.real))
        return None

    @property
    def _characteristic(self) -> tuple[Polynomial, Polynomial]:
        """Characteristic polynomial without damping at the wheel, and its increment per 1 N s/m."""
        masses = self.sprung_mass, self.unsprung_mass
        without, with_one = (
            Polynomial(
                road_polynomial(
                    LinearQuarterCar(*masses, self.wheel_rate, c, self.tyre_rate, self.tyre_damping)
                )[::-1]
            )
            for c in (0.0, 1.0)
        )
        return without, with_one - without

    @property
    def _end(self) -> float:
        """Critical damping of the body at the wheel (N s/m), at which the poles of the body meet on the real axis.

        The product of all four poles does not depend on the damping, and the poles of the wheel are the faster ones.
        """
        plain, damped = self._characteristic
        standstill = (
            plain.deriv() * damped - plain * damped.deriv()
        )  # stationary points of the damping along the axis
        meet = -_positive_roots(standstill(Polynomial([0.0, -1.0])))
        between = self.wheel_rate * self.tyre_rate / (self.sprung_mass * self.unsprung_mass)
        dampings = -plain(meet) / damped(meet)
        return float(np.min(dampings[(dampings > 0.0) & (meet**4 < between)], initial=math.inf))


def _positive_roots(of: Polynomial) -> Array:
    """Return the real positive roots of a polynomial."""
    roots = np.asarray(of.roots(), dtype=complex)
    return np.asarray(
        roots.real[(np.abs(roots.imag) < _SAME_SWING * np.abs(roots)) & (roots.real > 0.0)]
    )


_SAME_SWING = 1e-6  # relative tolerance of the required decay rate, and of real roots


def _at_wheel(rig: Rig) -> _AtWheel:
    """Linearise a rig about static equilibrium for the evaluation of decays."""
    if isinstance(rig, Corner):
        lumped = lump(rig)
        sprung, unsprung = lumped.effective_masses
        of_tyre = lumped.tyre_stiffness, lumped.tyre_damping
        return _AtWheel(
            lumped.wheel_rate, of_tyre[0], sprung, unsprung, of_tyre[1], lumped.damper_ratio**2
        )
    values, model = rig.parameters(), linearise(rig)
    row = {name: i for i, name in enumerate(model.states)}
    wheel_rate = -values["sprung.mass"] * model.A[row["sprung.vz"], row["sprung.z"]]
    both = -values["unsprung.mass"] * model.A[row["unsprung.vz"], row["unsprung.z"]]
    lever = math.cos(values.get("strut.angle", 0.0)) ** 2
    sprung, unsprung, loss = (
        values[path] for path in ("sprung.mass", "unsprung.mass", "tyre.damping_coefficient")
    )
    return _AtWheel(float(wheel_rate), float(both - wheel_rate), sprung, unsprung, loss, lever)


SPRUNG_MASS = "sprung.mass"
"""Parameter to which the ``added_mass`` of a trial is added."""
_MACHINE = 0.005
"""Minimum relative error of a test machine."""


def bench_values(
    measured: Characterisation, rig: Rig, pressure: float | None
) -> dict[str, Estimate]:
    """Return the bench results for rig parameters by path, SI; tyre results for a pressure (Pa).

    The intervals cover the slope over the fitted range, the slope at the static load, and the test machine's error.
    """
    values, given, used = (
        rig.parameters(),
        dict[str, Estimate](),
        {item.source for item in measured.replaced},
    )
    if measured.spring is not None and "bench.spring" in used and "strut.spring.rate" in values:
        given["strut.spring.rate"] = _cover_readings(
            measured.spring.stiffness, measured.spring.tangent_stiffness
        )
    by_pressure = {
        to_si(name, "Pa"): result
        for name, result in measured.tyre.items()
        if f'bench.tyre."{name}"' in used
    }
    tyre = (
        by_pressure.get(pressure)
        if pressure is not None
        else next(iter(by_pressure.values()), None)
    )
    if tyre is not None and "tyre.stiffness" in values:
        given["tyre.stiffness"] = _cover_readings(tyre.stiffness, tyre.tangent_stiffness)
    for at_strut in (choice.at_strut for choice in measured.damping_choices if choice.is_used):
        is_used = "bench.decay" in used and at_strut is not None and math.isfinite(at_strut.value)
        if at_strut is not None and is_used and "strut.damper.coefficient" in values:
            given["strut.damper.coefficient"] = _cover_readings(at_strut)
    return given


def _cover_readings(*readings: Estimate | None) -> Estimate:
    """Return an estimate whose interval covers all readings of a component test."""
    known = [reading for reading in readings if reading is not None]
    ends = [
        end for reading in known for end in (reading.interval or (reading.value, reading.value))
    ]
    unsure = _MACHINE * abs(known[0].value)
    return Estimate(
        known[0].value, known[0].standard_error, (min(ends) - unsure, max(ends) + unsure)
    )
