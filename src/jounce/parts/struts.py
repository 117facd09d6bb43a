"""Force elements of 3-D rigs: strut, tyre, steering, anti-roll bar and bushings; lengths come from the hardpoints."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Any, Literal, Self

from pydantic import Discriminator, Field, Tag, model_validator

from jounce.core.description import Description, misplaced
from jounce.core.units import Force, Length, PositiveLength, PositiveRotationalStiffness, PositiveStiffness, Speed
from jounce.parts.curves import Curve, VelocityTable
from jounce.parts.elements import (
    BilinearDamper,
    BoucWenDamper,
    BumpStop,
    Friction,
    LinearDamper,
    TanhDamper,
    Tyre,
    damper_kind,
    require_one,
)
from jounce.parts.points import DampingTriple, RotationalStiffnessTriple, StiffnessTriple


class CoilSpring(Description):
    """Spring between two points: ``rate`` (N/m) or a ``curve`` of its deflection, and its load at design length.

    With ``free_length`` (m) the deflection of rate and curve is free length minus length. Otherwise it is design length
    minus length, and ``preload`` (N, default 0) is the force at design length that comes on top.
    """

    rate: PositiveStiffness | None = None
    curve: Curve | None = None
    preload: Force | None = None
    free_length: PositiveLength | None = None

    @model_validator(mode="after")
    def _one_law_one_load(self) -> Self:
        require_one(self, "rate", "curve")
        if self.preload is not None and self.free_length is not None:
            raise ValueError(
                f"give preload or free_length, not both; found preload = {self.preload:g} N and free_length = "
                f"{self.free_length:g} m. preload is the spring force at design length; it follows from the free length"
            )
        return self


class MapDamper(Description):
    """Damper force over its length and velocity: ``force[i][j]`` (N) at ``length[i]`` (m) and ``velocity[j]`` (m/s).

    Velocity is positive in bump (shortening), force in compression. Straight lines between the points; beyond the ends
    of velocity the lines go on, beyond the ends of length the force stays.
    """

    kind: Literal["map"] = "map"
    length: tuple[PositiveLength, ...] = Field(min_length=2)
    velocity: tuple[Speed, ...] = Field(min_length=2)
    force: tuple[tuple[Force, ...], ...]

    @model_validator(mode="after")
    def _is_a_grid(self) -> Self:
        for name, values in (("length", self.length), ("velocity", self.velocity)):
            for i, (a, b) in enumerate(pairwise(values)):
                if b <= a:
                    raise ValueError(f"{name}[{i + 1}] = {b:g} does not lie above {name}[{i}] = {a:g}; sort the points")
        if len(self.force) != len(self.length):
            raise ValueError(
                f"force has {len(self.force)} rows and length {len(self.length)} points; give one row for each length"
            )
        for i, row in enumerate(self.force):
            if len(row) != len(self.velocity):
                raise misplaced(
                    ("force", i),
                    f"this row has {len(row)} forces and velocity {len(self.velocity)} points; give as many of both",
                )
        return self


def _strut_damper_kind(value: Any) -> str:
    """Name the law of a damper table: a map has lengths, the rest as in lumped rigs."""
    if isinstance(value, dict) and "kind" not in value and "length" in value:
        return "map"
    return damper_kind(value)


StrutDamper = Annotated[
    Annotated[LinearDamper, Tag("linear")]
    | Annotated[BilinearDamper, Tag("bilinear")]
    | Annotated[VelocityTable, Tag("table")]
    | Annotated[TanhDamper, Tag("tanh")]
    | Annotated[BoucWenDamper, Tag("bouc-wen")]
    | Annotated[MapDamper, Tag("map")],
    Discriminator(_strut_damper_kind),
]


class SpatialStrut(Description):
    """Spring and damper between hardpoints. Deflections are design length minus length, forces compression positive.

    The stops work along the spring (gaps count from design length), the friction along the damper.
    """

    spring: CoilSpring
    damper: StrutDamper
    friction: Friction | None = None
    bump_stop: BumpStop | None = None
    rebound_stop: BumpStop | None = None

    @model_validator(mode="before")
    @classmethod
    def _geometry_says_the_angle(cls, table: Any) -> Any:
        if isinstance(table, dict) and "angle" in table:
            raise misplaced(
                ("angle",),
                f"a 3-D rig takes no strut angle, its geometry says it; found {table['angle']!r}. Move "
                "hardpoints.strut_top or hardpoints.strut_bottom instead",
            )
        return table


class CornerTyre(Tyre):
    """Tyre of a 3-D rig: force vertical at the wheel centre, or radial in the wheel plane through the contact point.

    ``undeformed_radius`` (m) is the wheel's radius where it is not given.
    """

    law: Literal["vertical", "radial"] = "vertical"
    undeformed_radius: PositiveLength | None = None


class Steering(Description):
    """Rack that moves the inner end of the tie rod along y by ``rack_travel`` (m, positive to the left)."""

    rack_travel: Length = 0.0


class Bushing(Description):
    """Elastic joint in place of an ideal one, along and about x, y and z of the body (N/m, N m/rad, N s/m)."""

    stiffness: StiffnessTriple
    rotational_stiffness: RotationalStiffnessTriple = (0.0, 0.0, 0.0)
    damping: DampingTriple = (0.0, 0.0, 0.0)


class AntiRollBar(Description):
    """Torsion bar: ``stiffness`` (N m/rad) of twist between its ends, linked to the body that ``on`` names."""

    stiffness: PositiveRotationalStiffness
