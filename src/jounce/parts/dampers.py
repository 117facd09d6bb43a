"""Damper laws, one class each: the description in a rig file, and the force that follows from it.

A law is written once, with NumPy's functions, which work on numbers and on symbols alike: models evaluate it at symbols
of their state, fits and closed forms at samples. Slope, stiffness at rest and equivalent coefficients follow from it.
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

_STEP = 2.0**-100  # imaginary part of a derivative by complex step: it adds no rounding
_NEARBY = 1e-9  # m/s on either side of rest, where the two sides may have slopes of their own
_FARTHEST, _PLACES = (
    6.0,
    4001,
)  # standard deviations, beyond which the Gaussian weight is 2e-9; points of the mean


class OperatingPoint(Protocol):
    """Where a law is evaluated: its deflection (m), velocity (m/s) and length (m), and what its numbers are there.

    Compression and bump are positive. Each of these is a symbol of a model, a number or an array.
    """

    @property
    def deflection(self) -> Any:
        """How far the damper is pushed in, m."""

    @property
    def velocity(self) -> Any:
        """How fast it shortens, m/s."""

    def number(self, name: str) -> Any:
        """Give a number of the law."""

    def switch(self, name: str, x: Any) -> Any:
        """Give 1 where ``x`` is above zero, 0 below, and their mean at zero."""

    def table(self, variable: str, x: Any, points: int) -> Any:
        """Give the force at ``x`` on straight lines through the law's points and beyond them."""

    def grid(self, damper: MapDamper) -> Any:
        """Give the force at length and velocity on a map."""

    def state(self, name: str, rate: Callable[[Any], Any]) -> Any:
        """Give a first-order state of the law, whose rate follows from it."""


@dataclass(frozen=True)
class SampledPoint:
    """Operating points as numbers or arrays; a state rests at zero, as a damper does that has not moved yet."""

    number: Callable[[str], Any]
    velocity: Any
    deflection: Any = 0.0
    length: Any = None

    def switch(self, name: str, x: Any) -> Any:  # noqa: ARG002 - models name their switches
        """Give 1 where ``x`` is above zero, 0 below, and their mean at zero."""
        return np.heaviside(np.real(x), 0.5)

    def table(self, variable: str, x: Any, points: int) -> Array:  # noqa: ARG002 - models count the symbols
        """Give the force at ``x`` on straight lines through the law's points and beyond them."""
        return on_lines(self.number(variable), self.number("force"), x)

    def grid(self, damper: MapDamper) -> Array:
        """Give the force of one length on a map."""
        return damper.at_length(self.length).forces(self.velocity)

    def state(self, name: str, rate: Callable[[Any], Any]) -> Any:  # noqa: ARG002
        """Give zero."""
        return 0.0 * np.real(self.velocity)


class DamperLaw(Description):
    """Base of damper laws. Velocity is positive in bump (shortening), force in compression.

    A law whose numbers are factors of its force names them in ``weights`` and gives what they multiply in ``basis``;
    ``shapes`` are the numbers that its basis depends on. Any other law overrides ``evaluate``.
    """

    kind: str
    weights: ClassVar[tuple[str, ...]] = ()
    shapes: ClassVar[tuple[str, ...]] = ()
    not_negative: ClassVar[tuple[str, ...]] = ()
    """Weights that a fit keeps at zero or above."""
    hysteretic: ClassVar[bool] = False
    """Whether the force depends on more than the velocity."""
    remembers: ClassVar[bool] = False
    """Whether the force depends on the path so far, by a state of its own."""
    pushes_at_rest: ClassVar[bool] = False
    """Whether there may be a force without a velocity, as of gas."""

    @classmethod
    def basis(cls, at: OperatingPoint) -> tuple[Any, ...]:
        """Give what the weights multiply, in their order."""
        raise NotImplementedError(cls.__name__)

    def evaluate(self, at: OperatingPoint) -> Any:
        """Give the force at an operating point, N."""
        columns = self.basis(at)
        return sum(
            at.number(name) * column for name, column in zip(self.weights, columns, strict=True)
        )

    def forces(self, velocity: Any, deflection: Any = 0.0) -> Array:
        """Give the force at velocities (m/s) and deflections (m) of these numbers, N; a state of the law is at zero.

        >>> BilinearDamper(bump_coefficient=300.0, rebound_coefficient=900.0).forces(np.array([-1.0, 1.0])).tolist()
        [-900.0, 300.0]
        """
        return np.asarray(
            self.evaluate(SampledPoint(lambda name: getattr(self, name), velocity, deflection))
        )

    def slopes(self, velocity: Any, deflection: Any = 0.0) -> Array:
        """Give the slope of the force over velocity there, N s/m."""
        return np.imag(self.forces(np.asarray(velocity) + 1j * _STEP, deflection)) / _STEP

    def slope_at_rest(self) -> float:
        """Give the slope of the force over velocity at rest, N s/m; the mean where both directions differ.

        >>> BilinearDamper(bump_coefficient=300.0, rebound_coefficient=900.0).slope_at_rest()
        600.0
        """
        return float(self.slopes(np.array([-_NEARBY, _NEARBY])).mean())

    def at_rest(self, deflection: float = 0.0) -> tuple[float, float]:
        """Give force (N) and stiffness (N/m) at rest at a deflection (m): of the gas.

        >>> TanhDamper(coefficient=900.0, force=0.0, slope=1.0, stiffness=2000.0, offset=150.0).at_rest(0.01)
        (170.0, 2000.0)
        """
        force = self.forces(0.0, deflection + 1j * _STEP)
        return float(force.real), float(force.imag) / _STEP

    def mean_coefficient(self, speed: float) -> float:
        """Give the coefficient (N s/m) that has the same difference of forces between bump and rebound at a speed."""
        rebound, bump = self.forces(np.array([-speed, speed]))
        return float(bump - rebound) / (2.0 * speed)

    def statistical_coefficient(self, deviation: float) -> float:
        """Give the coefficient (N s/m) that a Gaussian velocity of that standard deviation (m/s) meets.

        It is the mean of force times velocity over that of the velocity squared, so that it takes up as much power
        (statistical linearisation). A state of the law is at zero.

        >>> LinearDamper(coefficient=1500.0).statistical_coefficient(0.3).__round__(6)
        1500.0
        """
        z = np.linspace(-_FARTHEST, _FARTHEST, _PLACES)
        weight = np.exp(-0.5 * z**2)
        return float(weight @ (self.forces(deviation * z) * z) / (weight @ z**2) / deviation)

    def at_length(self, length: float) -> DamperLaw:  # noqa: ARG002 - of a map
        """Give the law at a length (m) of the damper."""
        return self

    def bends(self) -> tuple[float, ...] | None:
        """Give the velocities (m/s) at which straight lines of force meet; None of a law that is no straight lines."""
        return None

    def points(self, beyond: float = 1.0) -> tuple[Array, Array] | None:
        """Give velocities (m/s) and forces (N) of a law of straight lines, the last ones ``beyond`` its bends (m/s)."""
        bends = self.bends()
        if bends is None:
            return None
        velocity = np.array([bends[0] - beyond, *bends, bends[-1] + beyond])
        return velocity, self.forces(velocity)

    @classmethod
    def search(cls, stroke: float, speed: float, resolution: float) -> tuple[Array, Array, Array]:  # noqa: ARG003
        """Give rows of shapes that a fit starts from, and their least and greatest values.

        ``stroke`` (m) is that of the record, ``speed`` (m/s) its largest, ``resolution`` (m/s) the step of its
        velocity.
        """
        return np.zeros((1, 0)), np.zeros(0), np.zeros(0)


class VelocityTable(DamperLaw):
    """Damper force through points of velocity (m/s, bump positive), straight lines between them and beyond."""

    kind: Literal["table"] = "table"
    velocity: Annotated[tuple[Speed, ...], Listed] = Field(min_length=2)
    force: Annotated[tuple[Force, ...], Listed] = Field(min_length=2)
    pushes_at_rest: ClassVar[bool] = True

    @model_validator(mode="after")
    def _check(self) -> Self:
        check_table("velocity", self.velocity, self.force)
        return self

    def evaluate(self, at: OperatingPoint) -> Any:
        """Give the force at an operating point, N."""
        return at.table("velocity", at.velocity, len(self.velocity))

    def points(self, beyond: float = 1.0) -> tuple[Array, Array]:  # noqa: ARG002 - the last lines go on
        """Give the velocities (m/s) and forces (N) of the table."""
        return np.array(self.velocity), np.array(self.force)


class LinearDamper(DamperLaw):
    """Damper force ``coefficient * velocity``, N s/m."""

    kind: Literal["linear"] = "linear"
    coefficient: NonNegativeDampingCoefficient
    weights: ClassVar[tuple[str, ...]] = ("coefficient",)

    @classmethod
    def basis(cls, at: OperatingPoint) -> tuple[Any, ...]:
        """Give what the weights multiply, in their order."""
        return (at.velocity,)

    def bends(self) -> tuple[float, ...]:
        """Give rest: any velocity is as good."""
        return (0.0,)


class BilinearDamper(DamperLaw):
    """Damper with one coefficient in bump and another in rebound, N s/m."""

    kind: Literal["bilinear"] = "bilinear"
    bump_coefficient: NonNegativeDampingCoefficient
    rebound_coefficient: NonNegativeDampingCoefficient
    weights: ClassVar[tuple[str, ...]] = ("bump_coefficient", "rebound_coefficient")

    @classmethod
    def basis(cls, at: OperatingPoint) -> tuple[Any, ...]:
        """Give what the weights multiply, in their order."""
        bump = at.switch("bump", at.velocity)
        return bump * at.velocity, (1.0 - bump) * at.velocity

    def evaluate(self, at: OperatingPoint) -> Any:
        """Give the force at an operating point, N: the sum over the basis with one product less for runs."""
        bump = at.switch("bump", at.velocity)
        rebound = at.number("rebound_coefficient")
        return (rebound + bump * (at.number("bump_coefficient") - rebound)) * at.velocity

    def bends(self) -> tuple[float, ...]:
        """Give rest."""
        return (0.0,)


class BlowOffDamper(DamperLaw):
    """Digressive damper: steep up to the blow-off force of a direction, at which its valve opens, flatter beyond.

    Bump: ``force / velocity * v`` up to ``bump_blow_off_velocity``, where the force is ``bump_blow_off_force``; from
    there on the slope is ``bump_high_speed_coefficient``. Rebound likewise, with its own positive numbers.
    Straight lines with a knee stand for the valve's relief [dixon-2007]; the knee of a real valve is round.
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
        """Give what the weights multiply, in their order."""
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
        """Give both blow-off velocities and rest."""
        return -self.rebound_blow_off_velocity, 0.0, self.bump_blow_off_velocity

    @classmethod
    def search(cls, stroke: float, speed: float, resolution: float) -> tuple[Array, Array, Array]:  # noqa: ARG003
        """Give knees from a fiftieth of the largest speed up to it."""
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
        """Give what the weights multiply, in their order."""
        lagged = at.velocity + at.number("displacement_coupling") * at.deflection
        return at.velocity, at.deflection, np.tanh(at.number("slope") * lagged), 1.0

    @classmethod
    def search(cls, stroke: float, speed: float, resolution: float) -> tuple[Array, Array, Array]:
        """Give rows of shapes that a fit starts from, and their least and greatest values."""
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
        """Give what the weights multiply, in their order."""
        return at.velocity, at.deflection, at.state("z", lambda z: cls._rate_of(at, z)), 1.0

    @staticmethod
    def _rate_of(at: OperatingPoint, z: Any) -> Any:
        """Rate of the state z; ``|z|^n`` by logarithm so that n may be fitted.

        The absolute values are switches, so that steps land where the motion or the hysteresis turns over.
        """
        rate, sigma, exponent = (at.number(name) for name in ("rate", "sigma", "exponent"))
        forward = 2.0 * at.switch("forward", at.velocity) - 1.0
        side = 2.0 * at.switch("side", z) - 1.0
        power = np.exp(exponent * np.log(np.fmax(side * z, 1e-150)))
        turning = sigma * forward * at.velocity * power * side
        return rate * (at.velocity - turning + (sigma - 1.0) * at.velocity * power)

    @classmethod
    def search(cls, stroke: float, speed: float, resolution: float) -> tuple[Array, Array, Array]:  # noqa: ARG003
        """Give rows of shapes that a fit starts from, and their least and greatest values."""
        rates = np.array([4.0, 20.0, 100.0, 500.0]) / stroke
        starts = np.array(
            [[r, sigma, n] for r in rates for sigma in (0.6, 2.0, 20.0) for n in (1.1, 2.0)]
        )
        return starts, np.array([0.3 / stroke, 0.5, 1.0]), np.array([1e4 / stroke, 1e3, 10.0])


class MapDamper(DamperLaw):
    """Damper force over its length and velocity: ``force[i][j]`` (N) at ``length[i]`` (m) and ``velocity[j]`` (m/s).

    Velocity is positive in bump (shortening), force in compression. Straight lines between the points; extrapolated
    beyond the velocities, constant beyond the lengths.
    """

    kind: Literal["map"] = "map"
    length: Annotated[tuple[PositiveLength, ...], Listed] = Field(min_length=2)
    velocity: Annotated[tuple[Speed, ...], Listed] = Field(min_length=2)
    force: Annotated[tuple[Annotated[tuple[Force, ...], Listed], ...], Listed]
    pushes_at_rest: ClassVar[bool] = True

    @model_validator(mode="after")
    def _is_a_grid(self) -> Self:
        check_ascending("length", self.length)
        check_ascending("velocity", self.velocity)
        if len(self.force) != len(self.length):
            raise ValueError(
                Phrase(
                    "force has {count} rows and length {second_count} points; give one row for each length",
                    count=len(self.force),
                    second_count=len(self.length),
                )
            )
        for i, row in enumerate(self.force):
            if len(row) != len(self.velocity):
                raise error_at(
                    ("force", i),
                    Phrase(
                        "this row has {count} forces and velocity {second_count} points; give as many of both",
                        count=len(row),
                        second_count=len(self.velocity),
                    ),
                )
        return self

    def evaluate(self, at: OperatingPoint) -> Any:
        """Give the force at an operating point, N."""
        return at.grid(self)

    def at_length(self, length: float) -> VelocityTable:
        """Give the row at a length (m) of the damper."""
        forces = tuple(
            float(np.interp(length, self.length, column))
            for column in zip(*self.force, strict=True)
        )
        return VelocityTable(velocity=self.velocity, force=forces)


def damper_kind(value: Any) -> str:
    """Name the law of a damper table: by ``kind``, else by its keys."""
    if not isinstance(value, dict):
        return str(getattr(value, "kind", "linear"))
    if "kind" in value:
        return str(value["kind"])
    if {"bump_coefficient", "rebound_coefficient"} & value.keys():
        return "bilinear"
    return "table" if {"velocity", "force"} & value.keys() else "linear"


_LumpedDamper = (
    Annotated[LinearDamper, Tag("linear")]
    | Annotated[BilinearDamper, Tag("bilinear")]
    | Annotated[BlowOffDamper, Tag("blow-off")]
    | Annotated[VelocityTable, Tag("table")]
    | Annotated[TanhDamper, Tag("tanh")]
    | Annotated[BoucWenDamper, Tag("bouc-wen")]
)
Damper = Annotated[_LumpedDamper, Discriminator(damper_kind)]


def _strut_damper_kind(value: Any) -> str:
    """Name the law of a damper table: a map has lengths, the rest as in lumped rigs."""
    if isinstance(value, dict) and "kind" not in value and "length" in value:
        return "map"
    return damper_kind(value)


StrutDamper = Annotated[
    _LumpedDamper | Annotated[MapDamper, Tag("map")], Discriminator(_strut_damper_kind)
]


def damper_laws(part: BaseModel, prefix: str = "") -> Iterator[tuple[str, DamperLaw]]:
    """Give the damper laws of a description with their paths, e.g. ``("strut.damper", LinearDamper(...))``."""
    for name in getattr(type(part), "model_fields", ()):  # what only has parameters has no laws
        value = getattr(part, name)
        if isinstance(value, DamperLaw):
            yield f"{prefix}{name}", value
        elif isinstance(value, BaseModel):
            yield from damper_laws(value, f"{prefix}{name}.")


def as_damper(damper: DamperLaw | Mapping[str, Any], where: str = "damper") -> DamperLaw:
    """Give a law as it is, or read its table; ``where`` places errors."""
    if isinstance(damper, DamperLaw):
        return damper
    laws: dict[str, type[DamperLaw]] = {
        law.model_fields["kind"].default: law for law in DamperLaw.__subclasses__()
    }
    kind = _strut_damper_kind(dict(damper))
    if kind not in laws:
        raise unknown(kind, laws, what="damper law", where=where)
    return laws[kind].from_table(dict(damper), where=where)
