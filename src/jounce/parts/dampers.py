"""Damper laws, one class each: the parameters in a rig file and the resulting force.

Each law is written once, with NumPy functions that accept numbers and symbols. Models evaluate it at symbols of their
state, fits and closed forms at samples. Slope, stiffness at rest and equivalent coefficients are derived from it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, Protocol, Self

import numpy as np
from pydantic import BaseModel, Discriminator, Field, Tag, model_validator

from jounce.core.description import Description
from jounce.core.errors import unknown
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.samples import Listed
from jounce.core.types import Array
from jounce.core.units import (
    Force,
    NonNegativeDampingCoefficient,
    NonNegativeForce,
    PositiveLength,
    PositiveSpeed,
    Speed,
    Stiffness,
    Unit,
)
from jounce.parts.tables import check_ascending, check_table, on_lines

_STEP = 2.0**-100  # imaginary part of the complex-step derivative: no rounding error
_NEARBY = 1e-9  # m/s on either side of rest, where the slope may change
_FARTHEST, _PLACES = (
    6.0,
    4001,
)  # integration limit in standard deviations, where the Gaussian weight is 2e-9; number of points


class OperatingPoint(Protocol):
    """Operating point of a law: deflection (m), velocity (m/s) and length (m), with access to the law's parameters.

    Compression and bump are positive. Each quantity is a symbol of a model, a number or an array.
    """

    @property
    def deflection(self) -> Any:
        """Compression of the damper, m."""

    @property
    def velocity(self) -> Any:
        """Speed of shortening, m/s."""

    def number(self, name: str) -> Any:
        """Return a parameter of the law by name."""

    def switch(self, name: str, x: Any) -> Any:
        """Return 1 for ``x`` above zero, 0 below, and 0.5 at zero."""

    def table(self, variable: str, x: Any, points: int) -> Any:
        """Return the force at ``x``, interpolated and extrapolated linearly through the law's points."""

    def grid(self, damper: Grid) -> Any:
        """Return the force of a grid at the current velocity, and length or clicks."""

    def state(self, name: str, rate: Callable[[Any], Any]) -> Any:
        """Return a first-order state of the law; ``rate`` computes its time derivative from it."""


@dataclass(frozen=True)
class SampledPoint:
    """Operating points as numbers or arrays; internal states are zero, as before the first movement."""

    number: Callable[[str], Any]
    velocity: Any
    deflection: Any = 0.0
    length: Any = None

    def switch(self, name: str, x: Any) -> Any:  # noqa: ARG002 - models name their switches
        """Return 1 for ``x`` above zero, 0 below, and 0.5 at zero."""
        return np.heaviside(np.real(x), 0.5)

    def table(self, variable: str, x: Any, points: int) -> Array:  # noqa: ARG002 - models count the symbols
        """Return the force at ``x``, interpolated and extrapolated linearly through the law's points."""
        return on_lines(self.number(variable), self.number("force"), x)

    def grid(self, damper: Grid) -> Array:
        """Return the force of a grid at one length, or at its clicks."""
        return damper.at_length(self.length).forces(self.velocity)

    def state(self, name: str, rate: Callable[[Any], Any]) -> Any:  # noqa: ARG002
        """Return zero: states are not integrated."""
        return 0.0 * np.real(self.velocity)


class DamperLaw(Description):
    """Base of damper laws. Velocity is positive in bump (shortening), force in compression.

    A law that is linear in some parameters names them in ``weights``; ``basis`` returns the functions they multiply,
    ``shapes`` names the parameters of the basis. Any other law overrides ``evaluate``.
    """

    kind: str
    weights: ClassVar[tuple[str, ...]] = ()
    shapes: ClassVar[tuple[str, ...]] = ()
    not_negative: ClassVar[tuple[str, ...]] = ()
    """Weights that a fit keeps at zero or above."""
    hysteretic: ClassVar[bool] = False
    """Whether the force depends on more than the velocity."""
    remembers: ClassVar[bool] = False
    """Whether the force depends on the history of the motion, through an internal state."""
    pushes_at_rest: ClassVar[bool] = False
    """Whether the force at zero velocity may differ from zero, e.g. due to gas pressure."""

    @classmethod
    def basis(cls, at: OperatingPoint) -> tuple[Any, ...]:
        """Return the basis functions in the order of ``weights``."""
        raise NotImplementedError(cls.__name__)

    def evaluate(self, at: OperatingPoint) -> Any:
        """Return the force at an operating point, N."""
        columns = self.basis(at)
        return sum(
            at.number(name) * column for name, column in zip(self.weights, columns, strict=True)
        )

    def forces(self, velocity: Any, deflection: Any = 0.0) -> Array:
        """Return the force at velocities (m/s) and deflections (m), N, with internal states at zero.

        >>> BilinearDamper(bump_coefficient=300.0, rebound_coefficient=900.0).forces(np.array([-1.0, 1.0])).tolist()
        [-900.0, 300.0]
        """
        return np.asarray(
            self.evaluate(SampledPoint(lambda name: getattr(self, name), velocity, deflection))
        )

    def slopes(self, velocity: Any, deflection: Any = 0.0) -> Array:
        """Return the derivative of the force with respect to velocity, N s/m."""
        return np.imag(self.forces(np.asarray(velocity) + 1j * _STEP, deflection)) / _STEP

    def slope_at_rest(self) -> float:
        """Return the derivative of the force with respect to velocity at rest, N s/m; the mean of bump and rebound.

        >>> BilinearDamper(bump_coefficient=300.0, rebound_coefficient=900.0).slope_at_rest()
        600.0
        """
        return float(self.slopes(np.array([-_NEARBY, _NEARBY])).mean())

    def at_rest(self, deflection: float = 0.0) -> tuple[float, float]:
        """Return force (N) and stiffness (N/m) at zero velocity and a deflection (m), e.g. of the gas.

        >>> TanhDamper(coefficient=900.0, force=0.0, slope=1.0, stiffness=2000.0, offset=150.0).at_rest(0.01)
        (170.0, 2000.0)
        """
        force = self.forces(0.0, deflection + 1j * _STEP)
        return float(force.real), float(force.imag) / _STEP

    def mean_coefficient(self, speed: float) -> float:
        """Return the linear coefficient (N s/m) with the same force difference between bump and rebound at a speed."""
        rebound, bump = self.forces(np.array([-speed, speed]))
        return float(bump - rebound) / (2.0 * speed)

    def statistical_coefficient(self, deviation: float) -> float:
        """Return the equivalent coefficient (N s/m) for a Gaussian velocity of a standard deviation (m/s).

        It is the mean of force times velocity divided by the mean square velocity: the linear damper dissipates the
        same power (statistical linearisation). Internal states are zero.

        >>> LinearDamper(coefficient=1500.0).statistical_coefficient(0.3).__round__(6)
        1500.0
        """
        z = np.linspace(-_FARTHEST, _FARTHEST, _PLACES)
        weight = np.exp(-0.5 * z**2)
        return float(weight @ (self.forces(deviation * z) * z) / (weight @ z**2) / deviation)

    def at_length(self, length: float) -> DamperLaw:  # noqa: ARG002 - used by maps
        """Return the law at a damper length (m); only maps depend on it."""
        return self

    def bends(self) -> tuple[float, ...] | None:
        """Return the velocities (m/s) at which a piecewise linear force bends, or None for any other law."""
        return None

    def points(self, beyond: float = 1.0) -> tuple[Array, Array] | None:
        """Return velocities (m/s) and forces (N) of a piecewise linear law, to ``beyond`` (m/s) outside its bends."""
        bends = self.bends()
        if bends is None:
            return None
        velocity = np.array([bends[0] - beyond, *bends, bends[-1] + beyond])
        return velocity, self.forces(velocity)

    @classmethod
    def search(cls, stroke: float, speed: float, resolution: float) -> tuple[Array, Array, Array]:  # noqa: ARG003
        """Return starting points of the shapes for a fit (one per row), and their lower and upper bounds.

        ``stroke`` (m) and ``speed`` (m/s) are maxima of the record, ``resolution`` (m/s) is the step of its velocity.
        """
        return np.zeros((1, 0)), np.zeros(0), np.zeros(0)


class VelocityTable(DamperLaw):
    """Damper force as a table over velocity (m/s, bump positive), interpolated and extrapolated linearly."""

    kind: Literal["table"] = "table"
    velocity: Annotated[tuple[Speed, ...], Listed] = Field(min_length=2)
    force: Annotated[tuple[Force, ...], Listed] = Field(min_length=2)
    pushes_at_rest: ClassVar[bool] = True

    @model_validator(mode="after")
    def _check(self) -> Self:
        check_table("velocity", self.velocity, self.force)
        return self

    def evaluate(self, at: OperatingPoint) -> Any:
        """Return the force at an operating point, N."""
        return at.table("velocity", at.velocity, len(self.velocity))

    def points(self, beyond: float = 1.0) -> tuple[Array, Array]:  # noqa: ARG002 - the last segments are extrapolated
        """Return the velocities (m/s) and forces (N) of the table."""
        return np.array(self.velocity), np.array(self.force)


class LinearDamper(DamperLaw):
    """Damper force ``coefficient * velocity``; the coefficient is in N s/m."""

    kind: Literal["linear"] = "linear"
    coefficient: NonNegativeDampingCoefficient
    weights: ClassVar[tuple[str, ...]] = ("coefficient",)

    @classmethod
    def basis(cls, at: OperatingPoint) -> tuple[Any, ...]:
        """Return the basis functions in the order of ``weights``."""
        return (at.velocity,)

    def bends(self) -> tuple[float, ...]:
        """Return zero velocity: a straight line bends nowhere, any velocity would do."""
        return (0.0,)


class BilinearDamper(DamperLaw):
    """Damper with separate coefficients for bump and rebound, N s/m."""

    kind: Literal["bilinear"] = "bilinear"
    bump_coefficient: NonNegativeDampingCoefficient
    rebound_coefficient: NonNegativeDampingCoefficient
    weights: ClassVar[tuple[str, ...]] = ("bump_coefficient", "rebound_coefficient")

    @classmethod
    def basis(cls, at: OperatingPoint) -> tuple[Any, ...]:
        """Return the basis functions in the order of ``weights``."""
        bump = at.switch("bump", at.velocity)
        return bump * at.velocity, (1.0 - bump) * at.velocity

    def evaluate(self, at: OperatingPoint) -> Any:
        """Return the force at an operating point, N. Equal to the sum over the basis, with one multiplication less."""
        bump = at.switch("bump", at.velocity)
        rebound = at.number("rebound_coefficient")
        return (rebound + bump * (at.number("bump_coefficient") - rebound)) * at.velocity

    def bends(self) -> tuple[float, ...]:
        """Return the velocity at which rebound changes to bump: zero."""
        return (0.0,)


class BlowOffDamper(DamperLaw):
    """Digressive damper: steep up to the blow-off force of each direction, where its valve opens, flatter beyond.

    In bump the force rises linearly to ``bump_blow_off_force`` at ``bump_blow_off_velocity``; beyond it the slope is
    ``bump_high_speed_coefficient``. Rebound likewise, with positive parameters of its own.
    Two straight lines approximate the relief valve [dixon-2007]; the knee of a real valve is round.
    """

    kind: Literal["blow-off"] = "blow-off"
    bump_blow_off_force: NonNegativeForce
    bump_blow_off_velocity: PositiveSpeed
    bump_high_speed_coefficient: NonNegativeDampingCoefficient
    rebound_blow_off_force: NonNegativeForce
    rebound_blow_off_velocity: PositiveSpeed
    rebound_high_speed_coefficient: NonNegativeDampingCoefficient
    weights: ClassVar[tuple[str, ...]] = (
        "bump_blow_off_force",
        "bump_high_speed_coefficient",
        "rebound_blow_off_force",
        "rebound_high_speed_coefficient",
    )
    shapes: ClassVar[tuple[str, ...]] = ("bump_blow_off_velocity", "rebound_blow_off_velocity")
    not_negative: ClassVar[tuple[str, ...]] = weights

    @classmethod
    def basis(cls, at: OperatingPoint) -> tuple[Any, ...]:
        """Return the basis functions in the order of ``weights``."""
        bump = at.switch("bump", at.velocity)
        columns = []
        for side, share, speed in (
            ("bump", bump, at.velocity),
            ("rebound", 1.0 - bump, -at.velocity),
        ):
            sign = 1.0 if side == "bump" else -1.0
            knee = at.number(f"{side}_blow_off_velocity")
            over = speed - knee
            beyond = at.switch(f"{side} blow-off", over) * over
            columns += [sign * (share * speed - beyond) / knee, sign * beyond]
        return tuple(columns)

    def bends(self) -> tuple[float, ...]:
        """Return the rebound blow-off velocity (negative), zero and the bump blow-off velocity."""
        return -self.rebound_blow_off_velocity, 0.0, self.bump_blow_off_velocity

    @classmethod
    def search(cls, stroke: float, speed: float, resolution: float) -> tuple[Array, Array, Array]:  # noqa: ARG003
        """Return starting points and bounds of the knees: 2 to 100 % of the largest speed."""
        shares = (0.08, 0.2, 0.4, 0.7)
        starts = np.array([[bump, rebound] for bump in shares for rebound in shares]) * speed
        return starts, np.full(2, max(0.02 * speed, 2.0 * resolution)), np.full(2, speed)


class TanhDamper(DamperLaw):
    """Hysteretic damper ``F = c v + k x + f tanh(slope (v + displacement_coupling x)) + offset`` (Kwok 2006)."""

    kind: Literal["tanh"] = "tanh"
    coefficient: NonNegativeDampingCoefficient
    stiffness: Stiffness = 0.0
    force: NonNegativeForce
    slope: Annotated[float, Unit("s/m", above=0.0)]
    displacement_coupling: Annotated[float, Unit("1/s")] = 0.0
    offset: Force = 0.0
    weights: ClassVar[tuple[str, ...]] = ("coefficient", "stiffness", "force", "offset")
    shapes: ClassVar[tuple[str, ...]] = ("slope", "displacement_coupling")
    not_negative: ClassVar[tuple[str, ...]] = ("coefficient", "force")
    hysteretic: ClassVar[bool] = True
    pushes_at_rest: ClassVar[bool] = True

    @classmethod
    def basis(cls, at: OperatingPoint) -> tuple[Any, ...]:
        """Return the basis functions in the order of ``weights``."""
        lagged = at.velocity + at.number("displacement_coupling") * at.deflection
        return at.velocity, at.deflection, np.tanh(at.number("slope") * lagged), 1.0

    @classmethod
    def search(cls, stroke: float, speed: float, resolution: float) -> tuple[Array, Array, Array]:
        """Return starting points of the shapes for a fit (one per row), and their lower and upper bounds."""
        reach = 0.5 * stroke
        couplings = np.array([-0.3, -0.1, 0.0, 0.1, 0.3]) * speed / reach
        starts = np.array(
            [
                [slope / speed, coupling]
                for slope in (1.5, 5.0, 15.0, 50.0)
                for coupling in couplings
            ]
        )
        limit = 10.0 * speed / reach
        finest = 0.5 / max(resolution, 1e-3 * speed)
        return (
            starts,
            np.array([0.2 / speed, -limit]),
            np.array([max(finest, 100.0 / speed), limit]),
        )


class BoucWenDamper(DamperLaw):
    """Hysteretic damper ``F = c v + k x + f z + offset`` with the normalised Bouc-Wen state ``-1 <= z <= 1``.

    ``z' = rate (v - sigma |v| |z|^(n-1) z + (sigma - 1) v |z|^n)``, rate in 1/m, sigma >= 1/2, exponent n >= 1.
    """

    kind: Literal["bouc-wen"] = "bouc-wen"
    coefficient: NonNegativeDampingCoefficient
    stiffness: Stiffness = 0.0
    hysteretic_force: NonNegativeForce
    rate: Annotated[float, Unit("1/m", above=0.0)]
    sigma: Annotated[float, Unit("1", at_least=0.5)]
    exponent: Annotated[float, Unit("1", at_least=1.0)]
    offset: Force = 0.0
    weights: ClassVar[tuple[str, ...]] = ("coefficient", "stiffness", "hysteretic_force", "offset")
    shapes: ClassVar[tuple[str, ...]] = ("rate", "sigma", "exponent")
    not_negative: ClassVar[tuple[str, ...]] = ("coefficient", "hysteretic_force")
    hysteretic: ClassVar[bool] = True
    remembers: ClassVar[bool] = True
    pushes_at_rest: ClassVar[bool] = True

    @classmethod
    def basis(cls, at: OperatingPoint) -> tuple[Any, ...]:
        """Return the basis functions in the order of ``weights``."""
        return at.velocity, at.deflection, at.state("z", lambda z: cls._rate_of(at, z)), 1.0

    @staticmethod
    def _rate_of(at: OperatingPoint, z: Any) -> Any:
        """Return the rate of the state z; ``|z|^n`` is computed by logarithm, as n may be fractional.

        Absolute values are switches: the solver places steps where the motion or the hysteresis changes sign.
        """
        rate, sigma, exponent = (at.number(name) for name in ("rate", "sigma", "exponent"))
        forward = 2.0 * at.switch("forward", at.velocity) - 1.0
        side = 2.0 * at.switch("side", z) - 1.0
        power = np.exp(exponent * np.log(np.fmax(side * z, 1e-150)))
        turning = sigma * forward * at.velocity * power * side
        return rate * (at.velocity - turning + (sigma - 1.0) * at.velocity * power)

    @classmethod
    def search(cls, stroke: float, speed: float, resolution: float) -> tuple[Array, Array, Array]:  # noqa: ARG003
        """Return starting points of the shapes for a fit (one per row), and their lower and upper bounds."""
        rates = np.array([4.0, 20.0, 100.0, 500.0]) / stroke
        starts = np.array(
            [[r, sigma, n] for r in rates for sigma in (0.6, 2.0, 20.0) for n in (1.1, 2.0)]
        )
        return starts, np.array([0.3 / stroke, 0.5, 1.0]), np.array([1e4 / stroke, 1e3, 10.0])


class MapDamper(DamperLaw):
    """Damper force over length and velocity: ``force[i][j]`` (N) at ``length[i]`` (m) and ``velocity[j]`` (m/s).

    Velocity is positive in bump (shortening), force in compression. Interpolation is linear; beyond the table the
    force is extrapolated over velocity and constant over length.
    """

    kind: Literal["map"] = "map"
    length: Annotated[tuple[PositiveLength, ...], Listed] = Field(min_length=2)
    velocity: Annotated[tuple[Speed, ...], Listed] = Field(min_length=2)
    force: Annotated[tuple[Annotated[tuple[Force, ...], Listed], ...], Listed]
    pushes_at_rest: ClassVar[bool] = True

    @model_validator(mode="after")
    def _is_a_grid(self) -> Self:
        _check_grid("length", self.length, self.velocity, self.force)
        return self

    @property
    def rows(self) -> tuple[float, ...]:
        """Lengths of the rows, m."""
        return self.length

    def evaluate(self, at: OperatingPoint) -> Any:
        """Return the force at an operating point, N."""
        return at.grid(self)

    def at_length(self, length: float) -> VelocityTable:
        """Return the table over velocity at a damper length (m)."""
        return _row_of(self, length)


class ClickDamper(DamperLaw):
    """Adjustable damper: ``force[i][j]`` (N) at ``measured_clicks[i]`` and ``velocity[j]`` (m/s), set to ``clicks``.

    Velocity is positive in bump (shortening), force in compression. Interpolation is linear over clicks and velocity;
    the force is extrapolated over velocity, never over clicks. Clicks may be fractions, so that a search or a sweep
    moves them like any other number; at measured clicks a slope by them is the mean of both sides.
    """

    kind: Literal["clicks"] = "clicks"
    clicks: Annotated[float, Unit("1")]
    measured_clicks: Annotated[tuple[Annotated[float, Unit("1")], ...], Listed] = Field(
        min_length=2
    )
    velocity: Annotated[tuple[Speed, ...], Listed] = Field(min_length=2)
    force: Annotated[tuple[Annotated[tuple[Force, ...], Listed], ...], Listed]
    pushes_at_rest: ClassVar[bool] = True

    @model_validator(mode="after")
    def _is_a_grid(self) -> Self:
        _check_grid("measured_clicks", self.measured_clicks, self.velocity, self.force)
        if not self.measured_clicks[0] <= self.clicks <= self.measured_clicks[-1]:
            raise error_at(
                ("clicks",),
                "not among the clicks that were measured",
                found=f"{self.clicks:g}",
                allowed=Phrase(
                    "{low:g} to {high:g}",
                    low=self.measured_clicks[0],
                    high=self.measured_clicks[-1],
                ),
            )
        return self

    @property
    def rows(self) -> tuple[float, ...]:
        """Clicks of the rows."""
        return self.measured_clicks

    def evaluate(self, at: OperatingPoint) -> Any:
        """Return the force at an operating point, N."""
        return at.grid(self)

    def at_length(self, length: float | None) -> VelocityTable:  # noqa: ARG002 - the length changes nothing
        """Return the table over velocity at the present clicks."""
        return _row_of(self, self.clicks)

    def points(self, beyond: float = 1.0) -> tuple[Array, Array]:
        """Return the velocities (m/s) and forces (N) at the present clicks."""
        return _row_of(self, self.clicks).points(beyond)


Grid = MapDamper | ClickDamper
"""Laws that are tables over velocity and something else."""


def _check_grid(
    name: str,
    rows: tuple[float, ...],
    velocity: tuple[float, ...],
    force: tuple[tuple[float, ...], ...],
) -> None:
    """Refuse forces that are not a grid over ascending rows and velocities; ``name`` names the rows."""
    check_ascending(name, rows)
    check_ascending("velocity", velocity)
    if len(force) != len(rows):
        raise ValueError(
            Phrase(
                "force has {count} rows and {name} has {second_count} points; give one row for each {name}",
                name=name,
                count=len(force),
                second_count=len(rows),
            )
        )
    for i, row in enumerate(force):
        if len(row) != len(velocity):
            raise error_at(
                ("force", i),
                Phrase(
                    "this row has {count} forces and velocity {second_count} points; give equal numbers of both",
                    count=len(row),
                    second_count=len(velocity),
                ),
            )


def _row_of(damper: Grid, place: float) -> VelocityTable:
    """Return the table over velocity between two rows of a grid."""
    forces = tuple(
        float(np.interp(place, damper.rows, column)) for column in zip(*damper.force, strict=True)
    )
    return VelocityTable(velocity=damper.velocity, force=forces)


def damper_kind(value: Any) -> str:
    """Return the kind of a damper table: its ``kind``, or inferred from its keys."""
    if not isinstance(value, dict):
        return str(getattr(value, "kind", "linear"))
    if "kind" in value:
        return str(value["kind"])
    if {"bump_coefficient", "rebound_coefficient"} & value.keys():
        return "bilinear"
    if "measured_clicks" in value:
        return "clicks"
    return "table" if {"velocity", "force"} & value.keys() else "linear"


_LumpedDamper = (
    Annotated[LinearDamper, Tag("linear")]
    | Annotated[BilinearDamper, Tag("bilinear")]
    | Annotated[BlowOffDamper, Tag("blow-off")]
    | Annotated[VelocityTable, Tag("table")]
    | Annotated[ClickDamper, Tag("clicks")]
    | Annotated[TanhDamper, Tag("tanh")]
    | Annotated[BoucWenDamper, Tag("bouc-wen")]
)
Damper = Annotated[_LumpedDamper, Discriminator(damper_kind)]


def _strut_damper_kind(value: Any) -> str:
    """Return the kind of a damper table: a map has lengths, other kinds are as in lumped rigs."""
    if isinstance(value, dict) and "kind" not in value and "length" in value:
        return "map"
    return damper_kind(value)


StrutDamper = Annotated[
    _LumpedDamper | Annotated[MapDamper, Tag("map")], Discriminator(_strut_damper_kind)
]


def damper_laws(part: BaseModel, prefix: str = "") -> Iterator[tuple[str, DamperLaw]]:
    """Yield the damper laws of a description with their paths, e.g. ``("strut.damper", LinearDamper(...))``."""
    for name in getattr(type(part), "model_fields", ()):  # objects without fields have no laws
        value = getattr(part, name)
        if isinstance(value, DamperLaw):
            yield f"{prefix}{name}", value
        elif isinstance(value, BaseModel):
            yield from damper_laws(value, f"{prefix}{name}.")


def as_damper(damper: DamperLaw | Mapping[str, Any], where: str = "damper") -> DamperLaw:
    """Return a law unchanged, or read it from its table; ``where`` is the location reported in errors."""
    if isinstance(damper, DamperLaw):
        return damper
    laws: dict[str, type[DamperLaw]] = {
        law.model_fields["kind"].default: law for law in DamperLaw.__subclasses__()
    }
    kind = _strut_damper_kind(dict(damper))
    if kind not in laws:
        raise unknown(kind, laws, what="damper law", where=where)
    return laws[kind].from_table(dict(damper), where=where)
