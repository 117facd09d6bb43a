"""True values of a virtual bench, which a campaign should find: rig, belt and sensors."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

import numpy as np
from pydantic import Field, field_validator, model_validator

from jounce.campaign.description import TrialEntry
from jounce.campaign.shipped import truth_library
from jounce.core.description import Description, check_schema, read_toml
from jounce.core.errors import DescriptionError
from jounce.core.files import find_file
from jounce.core.units import (
    NonNegativeLength,
    Number,
    PositiveSpeed,
    PositiveTime,
    Unit,
    to_si,
)
from jounce.parts import Corner, QuarterCar, load, rig_from_table
from jounce.parts.curves import Curve, PolynomialCurve, PowerCurve
from jounce.parts.rig import change_table, split_path
from jounce.parts.variants import with_strut_angle
from jounce.recordings import Sensor
from jounce.recordings.sensors import check_sensors
from jounce.roads import HalfSine, Road

if TYPE_CHECKING:
    from jounce.identify.fit_problem import FitTrial

SCHEMA = "jounce.truth/1"
_Share = Annotated[float, Unit("1", at_least=0.0, at_most=0.5)]
_Speed = Annotated[float, Unit("m/s", at_least=0.0)]
_Seconds = Annotated[float, Unit("s", at_least=0.0)]
_Force = Annotated[float, Unit("N", above=0.0)]


class StandingTyre(Description):
    """Differences between the tyre on the test machine and the rolling tyre.

    Attributes
    ----------
    settling, settling_force : float
        Settling on the support, m, and the force over which it occurs, N.
    loss : float
        Fraction of the force lost during unloading.
    """

    settling: NonNegativeLength = 0.0
    settling_force: _Force = 50.0
    loss: _Share = 0.0


class BeltImperfections(Description):
    """Imperfections of the belt in addition to the obstacle's shape.

    Attributes
    ----------
    contact_length : float
        Length of the contact patch, which smooths the obstacle, m.
    speed_drop : float
        Relative speed loss of the belt at each obstacle.
    recovery_time : float
        Time constant of the recovery of the speed, s.
    speed_error, lag : float
        Maximum error of the stated speed, m/s, and of the start of a recording, s; drawn for each pass.
    """

    contact_length: NonNegativeLength = 0.0
    speed_drop: _Share = 0.0
    recovery_time: PositiveTime = 0.4
    speed_error: _Speed = 0.0
    lag: _Seconds = 0.0


class TruePass(Description):
    """True values of a pass: its exact speed (m/s), and the delay of the start of its recording (s)."""

    speed: PositiveSpeed
    lag: Annotated[float, Unit("s")] = 0.0


class BenchTruth(Description):
    """The true values behind the recordings of a virtual bench, hidden from the campaign.

    Attributes
    ----------
    rig : str or dict
        A quarter car or a 3-D corner: a shipped rig's name, a rig file, its table, or a rig object.
    changes : dict
        Changes of the rig by path: numbers, and whole elements such as
        ``{"strut.damper": {"velocity": [-1, 0, 1], "force": [-190, 0, 130]}}``.
    tyre : dict
        The rolling tyre by pressure, as in ``{"0.31 MPa": [128.8e3, 0.6e6, 30e6]}``: coefficients of
        ``F = c[0] x + c[1] x^2 + ...``, SI. Without an entry the rig's own tyre applies at that pressure.
    standing_tyre : StandingTyre
        Effects of the test machine on the tyre.
    obstacle : Road
        The true obstacle, or each obstacle of a train; ``start`` is the position of the first.
    belt : BeltImperfections
        Contact patch, slowing belt, errors of speed and trigger.
    sensors : dict of str to Sensor
        Recorded channels with their measuring chains.
    passes : dict of str to TruePass
        Speed and lag by trial number; values of other trials are drawn at random from the seed.
    source : str
        Source of the values.
    estimated : tuple of str
        Paths of values without a source.

    Examples
    --------
    >>> truth = BenchTruth(rig="kart-quarter-car", changes={"guide.friction.force": "4 N"})
    >>> truth.true_rig().guide.friction.force
    4.0
    """

    schema_: Literal["jounce.truth/1"] = Field(default="jounce.truth/1", alias="schema")
    rig: str | dict[str, Any]
    changes: dict[str, Any] = {}
    tyre: dict[str, Annotated[tuple[Number, ...], Field(min_length=1, max_length=9)]] = {}
    standing_tyre: StandingTyre = StandingTyre()
    obstacle: Road = HalfSine(height=0.010, length=0.060, start=0.2)
    belt: BeltImperfections = BeltImperfections()
    sensors: dict[str, Sensor] = Field(
        default={"sprung.az": Sensor(), "unsprung.az": Sensor()},
        min_length=1,
        validate_default=True,
    )
    passes: dict[str, TruePass] = {}
    source: str = ""
    estimated: tuple[str, ...] = ()

    @field_validator("rig", mode="before")
    @classmethod
    def _as_table(cls, rig: Any) -> Any:
        return _table_of(rig) if isinstance(rig, QuarterCar | Corner) else rig

    @field_validator("tyre")
    @classmethod
    def _named_by_pressure(
        cls, curves: dict[str, tuple[float, ...]]
    ) -> dict[str, tuple[float, ...]]:
        for name in curves:
            to_si(name, "Pa", where="tyre")
        return curves

    @model_validator(mode="after")
    def _has_a_rig(self) -> Self:
        self.true_rig()
        check_sensors(self.sensors, "sensors")
        return self

    def true_rig(self, pressure: float | None = None) -> QuarterCar | Corner:
        """Return the true rig, with the rolling tyre at a pressure (Pa; None: the first of ``tyre``)."""
        described = (
            load(self.rig) if isinstance(self.rig, str) else rig_from_table(self.rig, where="rig")
        )
        whole_first = dict(
            sorted(self.changes.items(), key=lambda change: len(split_path(change[0])))
        )
        rig = described.with_changes(whole_first) if self.changes else described
        if not isinstance(rig, QuarterCar | Corner):
            raise DescriptionError(
                "this rig cannot be used on the bench",
                where="rig",
                found=type(rig).__name__,
                allowed="a quarter car or a corner",
            )
        curve = self.curve_at(pressure)
        if curve is None:
            return rig
        tyre = {
            key: value
            for key, value in _table_of(rig)["tyre"].items()
            if key not in ("stiffness", "curve")
        }
        return rig.with_changes(
            {"tyre": {**tyre, "curve": {"kind": "polynomial", "coefficients": curve}}}
        )

    def curve_at(self, pressure: float | None) -> tuple[float, ...] | None:
        """Return the coefficients of the rolling tyre at a pressure (Pa), SI; None if the rig's own tyre applies."""
        by_pressure = {to_si(name, "Pa"): curve for name, curve in self.tyre.items()}
        return by_pressure.get(next(iter(by_pressure), None) if pressure is None else pressure)  # type: ignore[arg-type]

    def with_changes(self, changes: dict[str, Any]) -> Self:
        """Return a copy with changed values by path; paths that start with ``rig.`` refer to the rig.

        Raises
        ------
        DescriptionError
            If a path is unknown or a value is out of range.

        Examples
        --------
        >>> truth = BenchTruth(rig="kart-quarter-car")
        >>> other = truth.with_changes({"belt.speed_drop": 0.01, "rig.strut.friction.force": "0 N"})
        >>> other.belt.speed_drop, other.true_rig().strut.friction.force
        (0.01, 0.0)
        """
        own = {path: value for path, value in changes.items() if not path.startswith("rig.")}
        table = change_table(self, own)
        of_rig = {
            path.removeprefix("rig."): value
            for path, value in changes.items()
            if path.startswith("rig.")
        }
        others = {
            path: value
            for path, value in table["changes"].items()
            if not any(path.startswith((f"{new}.", f"{new}[")) for new in of_rig)
        }
        return type(self).from_table({**table, "changes": {**others, **of_rig}})


def load_truth(path: Path | str) -> BenchTruth:
    """Read a truth file, or a shipped truth.

    Parameters
    ----------
    path : Path or str
        TOML file with ``schema = "jounce.truth/1"``; a rig file that it names is relative to its folder. Or the name of
        a shipped one: ``"kart-prototype"``, ``"kart-low-friction"``.

    Returns
    -------
    BenchTruth
        True values of the virtual bench.

    Raises
    ------
    DescriptionError
        With file, line, path, found value and what is allowed.

    Examples
    --------
    >>> load_truth("kart-low-friction").true_rig().strut.damper.coefficient
    85.0
    """
    file = find_file(path, truth_library(), "truth")
    table, text = read_toml(file)
    check_schema(table, (SCHEMA,), str(file))
    beside = file.parent / str(table.get("rig"))
    if beside.suffix == ".toml":
        table["rig"] = _table_of(load(beside))
    try:
        return BenchTruth.from_table(table, where=str(file), text=text)
    except DescriptionError as error:
        if error.where.startswith(str(file)) or error.what.startswith(str(file)):
            raise
        place = (
            f"{file}: {error.where}" if error.where else str(file)
        )  # a value that is changed, or of the rig it names
        raise DescriptionError(
            error.what, where=place, found=error.found, allowed=error.allowed, hint=error.hint
        ) from None


def true_values(
    truth: BenchTruth, paths: Sequence[str], trials: Sequence[FitTrial], first: TrialEntry
) -> dict[str, float]:
    """Return the true values behind synthetic recordings as a test machine would measure them, by path, SI.

    Stiffnesses are tangents at the static load; the damper's coefficient is a least-squares fit to its force over the
    velocities in the ``trials``; ``first`` is the entry of the first trial, which states pressure and strut angle.
    Paths without a true value are left out.
    """
    from jounce.simulation import simulate

    rig = truth.true_rig(first.tyre_pressure)
    rig = rig if first.strut_angle is None else with_strut_angle(rig, first.strut_angle)
    values, known = rig.parameters(), dict[str, float]()
    for path in paths:
        other = path.replace("guide.friction", "guide_friction") if path not in values else path
        other = path.replace("guide_friction", "guide.friction") if other not in values else other
        if other in values:
            known[path] = values[other]
    if "tyre.stiffness" in paths and rig.tyre.curve is not None:
        run = simulate(rig, trials[0].trial)
        known["tyre.stiffness"] = _tangent(rig.tyre.curve, float(run["tyre.deflection"][0]))
    if "strut.damper.coefficient" in paths and "strut.damper.coefficient" not in values:
        velocity = np.concatenate(
            [simulate(rig, trial.trial)["strut.velocity"].to_numpy() for trial in trials]
        )
        force = rig.strut.damper.forces(velocity)
        known["strut.damper.coefficient"] = float(velocity @ force / (velocity @ velocity))
    return {path: known[path] for path in paths if path in known}


def _tangent(curve: Curve, at: float) -> float:
    """Return the slope of a curve (N/m) at a deflection (m)."""
    if isinstance(curve, PolynomialCurve):
        return float(sum((i + 1) * c * at**i for i, c in enumerate(curve.coefficients)))
    if isinstance(curve, PowerCurve):
        return float(curve.coefficient * curve.exponent * at ** (curve.exponent - 1.0))
    return float(
        np.interp(at, curve.deflection[1:], np.diff(curve.force) / np.diff(curve.deflection))
    )


def _table_of(rig: Any) -> dict[str, Any]:
    table: dict[str, Any] = rig.model_dump(by_alias=True, exclude_none=True)
    return table
