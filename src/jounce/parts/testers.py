"""Shock absorber testers: the exciter under the wheel, its frequency programme, and the limits of a valid test.

Simulation and evaluation share a tester file: the simulation reads stroke, plate and programme, the evaluation of a
record reads limits and column names.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import Field, model_validator

from jounce.core.description import Description, read_description
from jounce.core.errors import DescriptionError, nearest_name
from jounce.core.files import find_file, shipped_files
from jounce.core.findings import Finding, finding
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.units import (
    Frequency,
    Mass,
    NonNegativeDampingCoefficient,
    NonNegativeForce,
    PositiveLength,
    PositiveStiffness,
    PositiveTime,
    Unit,
)
from jounce.parts.rig import change_table

SCHEMA = "jounce.tester/1"
_Seconds = Annotated[float, Unit("s", at_least=0.0)]
_SecondsPerNewton = Annotated[float, Unit("s/N", at_least=0.0)]
_FrequencyOrRest = Annotated[float, Unit("Hz", at_least=0.0)]
_Rate = Annotated[float, Unit("Hz/s", above=0.0)]
_Inertia = Annotated[float, Unit("kg*m^2", above=0.0)]
_Torque = Annotated[float, Unit("N*m", above=0.0)]
_Friction = Annotated[float, Unit("N*m", at_least=0.0)]
_Viscous = Annotated[float, Unit("N*m*s/rad", at_least=0.0)]


class Programme(Description):
    """Frequency of the exciter over the test of one wheel.

    Attributes
    ----------
    start_frequency, end_frequency : float
        Hz; the frequency changes linearly in time between them, up or down.
    hold_time, hold_time_per_load : float
        Duration of the start frequency, s, and the additional duration per newton of static load, s/N.
    sweep_rate : float
        Hz/s, absolute value.
    run_down : {"controlled", "free"}
        Whether the drive follows the programme (sweep-down), or is switched off after the hold (coast-down).
    duration : float
        Maximum duration of a coast-down, s; it ends earlier if the exciter stops.
    pause : float
        Pause between the two wheels of an axle, s.
    """

    start_frequency: Frequency
    end_frequency: _FrequencyOrRest = 0.0
    hold_time: _Seconds = 0.0
    hold_time_per_load: _SecondsPerNewton = 0.0
    sweep_rate: _Rate = 2.5
    run_down: Literal["controlled", "free"] = "controlled"
    duration: Annotated[float, Unit("s", above=0.0)] = 10.0
    pause: _Seconds = 1.0

    def hold(self, static_load: float) -> float:
        """Return the duration (s) of the start frequency for a static wheel load (N)."""
        return self.hold_time + self.hold_time_per_load * static_load

    def length(self, static_load: float) -> float:
        """Return the duration (s) of the test of one wheel with a static load (N)."""
        sweep = abs(self.start_frequency - self.end_frequency) / self.sweep_rate
        return self.hold(static_load) + (self.duration if self.run_down == "free" else sweep)


class Motor(Description):
    """Motor with a linear torque-speed curve: ``stall_torque`` (N m) at rest, zero at ``no_load_frequency`` (Hz)."""

    stall_torque: _Torque
    no_load_frequency: Frequency


class Drive(Description):
    """Drive of the exciter: ``inertia`` (kg m^2), ``friction_torque`` (N m), ``viscous_friction`` (N m s/rad)."""

    inertia: _Inertia
    friction_torque: _Friction = 0.0
    viscous_friction: _Viscous = 0.0
    motor: Motor | None = None


class TesterLimits(Description):
    """Limits of a valid test.

    Attributes
    ----------
    wheel_load_min, wheel_load_max : float
        Static load of one wheel, N.
    tyre_rigidity_min, tyre_rigidity_max : float
        N/m; a tyre below the range is under-inflated, above it over-inflated.
    frequency_min, frequency_max : float
        Hz; range searched for the minimum phase angle, ends included.
    sweep_rate_max : float
        Hz/s; a faster sweep makes the result less reliable.
    sweep_time_min : float
        Minimum duration of the sweep, s.
    sampling_frequency_min : float
        Minimum sampling frequency, Hz.
    calibration_force_per_frequency : float
        Maximum residual force of the unloaded plate after inertia compensation, N/Hz.
    stroke_tolerance : float
        Tolerance of the stroke, m.
    """

    wheel_load_min: NonNegativeForce = 1000.0
    wheel_load_max: NonNegativeForce = 11000.0
    tyre_rigidity_min: PositiveStiffness = 160e3
    tyre_rigidity_max: PositiveStiffness = 400e3
    frequency_min: Frequency = 6.0
    frequency_max: Frequency = 18.0
    sweep_rate_max: _Rate = 3.0
    sweep_time_min: _Seconds = 7.5
    sampling_frequency_min: Frequency = 1000.0
    calibration_force_per_frequency: Annotated[float, Unit("N/Hz", above=0.0)] = 4.0
    stroke_tolerance: PositiveLength = 0.6e-3
    __test__: ClassVar[bool] = False  # not a pytest class

    @model_validator(mode="after")
    def _in_order(self) -> Self:
        for name in ("wheel_load", "tyre_rigidity", "frequency"):
            low, high = getattr(self, f"{name}_min"), getattr(self, f"{name}_max")
            if low >= high:
                limits = Phrase("{low:g} and {high:g} (SI)", low=low, high=high)
                raise error_at(
                    (f"{name}_min",), Phrase("not below {name}_max", name=name), found=limits
                )
        return self


class Tester(Description):
    """Shock absorber tester with one plate per side of the car.

    Attributes
    ----------
    kind : {"rigid-plate", "sprung-plate"}
        Whether the exciter moves the plate itself, or the foot of a spring under it.
    method : {"eusama", "egea", "theta", "boge"}
        The usual evaluation method of its records.
    stroke : float
        Stroke of the exciter, peak to peak, m: twice its eccentricity.
    plate_mass : float
        Mass of one plate, kg.
    plate_spring_rate, plate_damping_coefficient : float or None
        Spring and damper between exciter and plate, N/m and N s/m; for sprung plates only.
    force_cell : {"under-plate", "contact"}
        Position of the force sensor: a force measured under the plate includes the plate's inertia.
    sampling_frequency : float
        Sampling frequency of its records, Hz.
    programme : Programme
        Frequency programme of the exciter.
    drive : Drive or None
        Drive of the exciter; required for a coast-down.
    limits : TesterLimits
        Limits of a valid test.
    columns : dict
        Column name in this tester's files for each channel of a record (``left.plate.z``).
    variable, sample_time, resample
        Options to read this tester's files, as in `read_recording`: matrix or group, time step (s) of files without
        time, and the constant step (s) to which records with irregular time are resampled.
    name, source : str
        Name of the tester, and source of its values.
    estimated : tuple of str
        Paths of values that are not from the source.
    """

    schema_: Literal["jounce.tester/1"] = Field(default="jounce.tester/1", alias="schema")
    name: str = ""
    kind: Literal["rigid-plate", "sprung-plate"]
    method: Literal["eusama", "egea", "theta", "boge"]
    source: str = ""
    estimated: tuple[str, ...] = ()
    stroke: PositiveLength
    plate_mass: Mass
    plate_spring_rate: PositiveStiffness | None = None
    plate_damping_coefficient: NonNegativeDampingCoefficient | None = None
    force_cell: Literal["under-plate", "contact"] = "under-plate"
    sampling_frequency: Frequency = 1000.0
    programme: Programme
    drive: Drive | None = None
    limits: TesterLimits = TesterLimits()
    columns: dict[str, str] = {}
    variable: str = ""
    sample_time: PositiveTime | None = None
    resample: PositiveTime | None = None
    sides: ClassVar[tuple[str, ...]] = ("left", "right")
    __test__: ClassVar[bool] = False  # not a pytest class

    @property
    def amplitude(self) -> float:
        """Eccentricity of the exciter, m: half the stroke."""
        return 0.5 * self.stroke

    @model_validator(mode="after")
    def _is_complete(self) -> Self:
        sprung = self.kind == "sprung-plate"
        if sprung != (self.plate_spring_rate is not None):
            raise error_at(
                ("plate_spring_rate",),
                "a sprung plate requires it, and a rigid plate must not have it",
                found=Phrase('kind = "{kind}"', kind=self.kind),
            )
        if self.plate_damping_coefficient is not None and not sprung:
            kind = Phrase('kind = "rigid-plate"')
            raise error_at(
                ("plate_damping_coefficient",),
                "a rigid plate has no damping coefficient",
                found=kind,
            )
        if self.programme.run_down == "free" and self.drive is None:
            raise error_at(
                ("drive",),
                'a coast-down (run_down = "free") needs the drive\'s inertia; [drive] is missing',
            )
        return self

    def with_changes(self, changes: dict[str, Any]) -> Tester:
        """Return a copy with changed values by path, as for rigs: ``{"stroke": "6 mm"}``.

        Raises
        ------
        DescriptionError
            For an unknown path or a value out of range.
        """
        return Tester.from_table(change_table(self, changes), where="tester")


def library() -> dict[str, Path]:
    """Return the shipped testers: name to path."""
    return shipped_files("jounce.parts", "library/testers")


def as_tester(given: Tester | str | Path) -> Tester:
    """Return a tester unchanged, or load it from a file or by its name in the library.

    >>> as_tester("eusama") == load_tester("eusama")
    True
    """
    if isinstance(given, str | Path):
        return load_tester(given)
    if not isinstance(given, Tester):
        allowed = "a tester, its file, or the name of a shipped one"
        raise DescriptionError(
            "not a tester", where="tester", found=type(given).__name__, allowed=allowed
        )
    return given


def load_tester(name: str | Path) -> Tester:
    """Load a tester from a TOML file or, by name, from the shipped library.

    Parameters
    ----------
    name : str or Path
        Path to a file, or ``"eusama"``, ``"egea-specsus2018"``, ``"theta-msd3000"``, ``"boge"``.

    Returns
    -------
    Tester
        The immutable description, SI.

    Raises
    ------
    DescriptionError
        With file, line, path, value found, allowed values and the nearest match.

    Examples
    --------
    >>> tester = load_tester("eusama")
    >>> tester.kind, tester.amplitude   # m
    ('rigid-plate', 0.003)
    """
    path = find_file(name, library(), "tester")
    tester, _ = read_description(Tester, path, SCHEMA)
    return tester if tester.name else tester.model_copy(update={"name": path.stem})


CHANNELS = tuple(
    f"{side}.plate.{name}" for side in Tester.sides for name in ("z", "force", "frequency")
)
"""Channels that a tester's ``columns`` may name, in addition to ``time``."""


def findings_of_tester(tester: Tester, where: str = "") -> list[Finding]:
    """List implausible values of a tester; ``where`` is its source file.

    >>> tester = load_tester("egea-specsus2018")
    >>> findings_of_tester(tester)
    []
    >>> [str(finding) for finding in findings_of_tester(tester.with_changes({"sampling_frequency": "500 Hz"}))]
    ["warning: sampling_frequency: 500 Hz is below the tester's own limits.sampling_frequency_min of 1000 Hz."]
    """
    start = f"{where}: " if where else ""
    findings: list[Finding] = []
    known = set(_paths(tester.model_dump(by_alias=True)))
    for entry in tester.estimated:
        if entry not in known:
            near = nearest_name(entry, known)
            code = "parts.tester_estimated_near" if near else "parts.tester_estimated_unknown"
            findings.append(finding(code, f"{start}estimated", entry=entry, near=near))
    for name in tester.columns:
        if name not in (*CHANNELS, "time"):
            near = nearest_name(name, CHANNELS)
            code = "parts.tester_column_near" if near else "parts.tester_column_unknown"
            findings.append(finding(code, f"{start}columns.{name}", near=near))
    programme, limits = tester.programme, tester.limits
    if tester.sampling_frequency < limits.sampling_frequency_min:
        frequency, least = tester.sampling_frequency, limits.sampling_frequency_min
        place = f"{start}sampling_frequency"
        findings.append(finding("parts.tester_sampling", place, frequency=frequency, least=least))
    if programme.run_down == "controlled" and programme.sweep_rate > limits.sweep_rate_max:
        rate, most = programme.sweep_rate, limits.sweep_rate_max
        findings.append(
            finding("parts.tester_sweep_rate", f"{start}programme.sweep_rate", rate=rate, most=most)
        )
    low, high = sorted((programme.start_frequency, programme.end_frequency))
    if tester.method == "egea" and not low <= limits.frequency_min < limits.frequency_max <= high:
        numbers: dict[str, Any] = {
            "high": high,
            "low": low,
            "least": limits.frequency_min,
            "most": limits.frequency_max,
        }
        findings.append(finding("parts.tester_sweep_range", f"{start}programme", **numbers))
    return findings


def _paths(table: dict[str, Any], before: str = "") -> Iterator[str]:
    for key, value in table.items():
        yield f"{before}{key}"
        if isinstance(value, dict):
            yield from _paths(value, f"{before}{key}.")
