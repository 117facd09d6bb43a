"""Force elements as immutable descriptions.

Springs, friction, stops, tyres, steering, anti-roll bars, torsion bars and third springs. Curves, dampers and bushings
have modules of their own.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated, Any, Literal, Self

from pydantic import model_validator

from jounce.core.description import Description
from jounce.core.errors import as_found
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.units import (
    Angle,
    Force,
    Length,
    NonNegativeDampingCoefficient,
    NonNegativeForce,
    PositiveLength,
    PositiveRotationalStiffness,
    PositiveSpeed,
    PositiveStiffness,
    Pressure,
    Torque,
    Unit,
)
from jounce.parts.bodies import Point, Triple
from jounce.parts.bushings import Mount
from jounce.parts.curves import Curve
from jounce.parts.dampers import Damper, StrutDamper


class Spring(Description):
    """Strut spring: ``rate`` (N/m) or a ``curve`` of deflection, plus ``preload`` (N) at zero deflection."""

    rate: PositiveStiffness | None = None
    curve: Curve | None = None
    preload: Force = 0.0

    @model_validator(mode="after")
    def _one_law(self) -> Spring:
        require_one(self, "rate", "curve")
        return self


class Friction(Description):
    """Coulomb friction, regularised as ``force * tanh(velocity / regularisation_velocity)``.

    ``presliding`` is the fraction (1) of the force that depends on travel instead of velocity (Dahl model): after a
    reversal it builds up over ``presliding_distance`` (m).
    """

    force: NonNegativeForce
    regularisation_velocity: PositiveSpeed = 0.002
    presliding: Annotated[float, Unit("1", at_least=0.0, at_most=1.0)] | None = None
    presliding_distance: PositiveLength | None = None

    @model_validator(mode="after")
    def _a_share_and_its_distance(self) -> Friction:
        if (self.presliding is None) != (self.presliding_distance is None):
            raise ValueError(
                "presliding and presliding_distance belong together: give both or neither"
            )
        return self


class BumpStop(Description):
    """Stop that adds ``rate * (deflection - gap) + progression * (deflection - gap)^3`` once the gap is closed."""

    gap: Length
    rate: PositiveStiffness
    progression: Annotated[float, Unit("N/m^3", at_least=0.0)] = 0.0


class Tyre(Description):
    """Radial tyre: ``stiffness`` (N/m) or a ``curve`` of deflection, damping, and lift-off (on by default)."""

    stiffness: PositiveStiffness | None = None
    curve: Curve | None = None
    damping_coefficient: NonNegativeDampingCoefficient = 0.0
    lift_off: bool = True

    @model_validator(mode="after")
    def _one_law(self) -> Tyre:
        require_one(self, "stiffness", "curve")
        return self


def require_one(part: Description, *names: str) -> None:
    """Refuse a part that gives none or more than one of the named laws."""
    given = [name for name in names if getattr(part, name) is not None]
    if len(given) != 1:
        laws = Phrase(" and ".join(given) if given else "none of them")
        raise error_at(
            (), Phrase("give exactly one of {names}", names=", ".join(names)), found=laws
        )


class CoilSpring(Description):
    """Spring between two points: ``rate`` (N/m) or a ``curve`` of its deflection, and its load at design length.

    With ``free_length`` (m), rate and curve apply to free length minus length. Otherwise they apply to design length
    minus length, and ``preload`` (N, default 0) is added as the force at design length.
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
                Phrase(
                    "give preload or free_length, not both; found preload = {preload:g} N and free_length = "
                    "{free_length:g} m. preload is the spring force at design length; it follows from the "
                    "free length",
                    preload=self.preload,
                    free_length=self.free_length,
                )
            )
        return self


class SpatialStrut(Description):
    """Spring and damper between hardpoints. Deflections are design length minus length, forces compression positive.

    Stops act along the spring (gaps are measured from design length), friction acts along the damper. ``on`` is the
    body that carries the lower end.
    """

    spring: CoilSpring
    damper: StrutDamper
    friction: Friction | None = None
    bump_stop: BumpStop | None = None
    rebound_stop: BumpStop | None = None
    on: str

    @model_validator(mode="before")
    @classmethod
    def _geometry_says_the_angle(cls, table: Any) -> Any:
        if isinstance(table, dict) and "angle" in table:
            raise error_at(
                ("angle",),
                "a 3-D rig has no strut-angle setting: the angle follows from the geometry",
                found=as_found(table["angle"]),
                hint="Move hardpoints.strut_top or hardpoints.strut_bottom instead.",
            )
        return table


TyreLaw = Literal["vertical", "radial"]
"""How the load of an inclined wheel is computed; see `CornerTyre`."""


class CornerTyre(Tyre):
    """Tyre of a 3-D rig; its force is normal to the road.

    For a corner on its guide, ``law`` selects the deflection: ``"vertical"`` uses the height of the wheel centre, where
    the force also acts; ``"radial"`` measures it in the wheel plane, and the force acts at the contact point, the
    lowest point of the wheel disc. In a car, where wheels lean with the body, tyres are always radial: otherwise the
    moments about the road would not balance, and energy would not be conserved. ``undeformed_radius`` (m) defaults to
    the wheel's radius.
    """

    law: TyreLaw = "vertical"
    undeformed_radius: PositiveLength | None = None


class SteeringColumn(Description):
    """Shafts between handwheel and pinion with one or two universal joints; positions in m.

    The first shaft runs from ``handwheel`` to ``upper_joint``, the last one ends at ``pinion``. With a ``lower_joint``,
    an intermediate shaft connects the joints. ``yoke_angle`` (rad) is the angle of the first shaft's yoke with the
    wheels straight ahead; at zero its pin is normal to the plane of the two shafts. ``phase`` (rad) is the angle
    between the yokes of the intermediate shaft. Both angles are right-handed about the direction from handwheel to
    pinion.
    """

    handwheel: Point
    upper_joint: Point
    lower_joint: Point | None = None
    pinion: Point
    yoke_angle: Angle = 0.0
    phase: Angle = 0.0

    @model_validator(mode="after")
    def _has_shafts(self) -> Self:
        points = {
            name: getattr(self, name)
            for name in ("handwheel", "upper_joint", "lower_joint", "pinion")
        }
        given = [(name, point) for name, point in points.items() if point is not None]
        for (first, start), (second, end) in pairwise(given):
            if math.dist(start, end) < _SHORTEST_SHAFT:
                raise error_at(
                    (second,),
                    Phrase("coincides with {name}", name=first),
                    allowed="the other end of a shaft",
                )
        for (_, start), (joint, middle), (_, end) in zip(given, given[1:], given[2:], strict=False):
            bend = _bend(start, middle, end)
            if bend > _STEEPEST_JOINT:
                allowed = Phrase(
                    "up to {most:g} deg, the limit of universal joints", most=_STEEPEST_JOINT
                )
                raise error_at(
                    (joint,),
                    Phrase("bends the column by {bend:.3g} deg", bend=bend),
                    allowed=allowed,
                )
        return self


_SHORTEST_SHAFT = 1e-3  # m: rounding hardpoints to millimetres would rotate a shorter shaft
_STEEPEST_JOINT = (
    60.0  # deg, chosen limit: the driven shaft then turns at 0.5 to 2 times the driving speed
)


def _bend(start: Triple, middle: Triple, end: Triple) -> float:
    """Return the angle between the lines into and out of a point, deg."""
    before, after = (
        [b - a for a, b in zip(*pair, strict=True)] for pair in ((start, middle), (middle, end))
    )
    along = sum(a * b for a, b in zip(before, after, strict=True)) / (
        math.hypot(*before) * math.hypot(*after)
    )
    return math.degrees(math.acos(min(max(along, -1.0), 1.0)))


class Steering(Description):
    """Rack that moves the inner end of the tie rod along y by ``rack_travel`` (m, positive to the left).

    ``rack_ratio`` (m/rad) is rack travel over pinion rotation; positive if turning the handwheel to the left moves the
    rack to the left. Without a ``column`` the handwheel turns the pinion directly.

    On the K&C rig, ``column_stiffness`` (N m/rad, at the pinion) acts between handwheel and pinion, ``assistance`` is
    the rack force that the assistance carries per rack force by hand, and ``housing`` are the mounts of the rack
    housing on one side; the other side has their mirror images.
    """

    rack_travel: Length = 0.0
    rack_ratio: Annotated[float, Unit("m/rad")] | None = None
    column: SteeringColumn | None = None
    column_stiffness: PositiveRotationalStiffness | None = None
    assistance: Annotated[float, Unit("1", at_least=0.0)] | None = None
    housing: tuple[Mount, ...] = ()

    @model_validator(mode="after")
    def _turns_the_rack(self) -> Self:
        if self.rack_ratio == 0.0:
            raise error_at(
                ("rack_ratio",),
                "a rack that does not move",
                found=Phrase("0 m/rad"),
                allowed="any other ratio, negative if the rack moves the other way",
            )
        for name in ("column", "column_stiffness"):
            if getattr(self, name) is not None and self.rack_ratio is None:
                raise error_at((name,), "turns a pinion without a rack; add steering.rack_ratio")
        return self


class Blade(Description):
    """Flexible arm of an anti-roll bar: ``width`` and ``thickness`` (m) of its cross section, constant along the arm.

    ``angle`` (rad) is the rotation about its length: at 0 the blade is softest in bending, at 90 degrees stiffest.
    """

    width: PositiveLength
    thickness: PositiveLength
    angle: Angle = 0.0
    youngs_modulus: Pressure = 210e9


class AntiRollBar(Description):
    """Torsion bar: ``stiffness`` (N m/rad) of twist between its ends, linked to the body ``on``.

    ``kind`` selects the type: ``"u"`` twists with the difference of its ends; ``"z"`` with their sum, which resists
    heave but not roll; ``"t"`` is a stem from ``arb_pivot`` to ``arb_axis`` with a transverse hinge at the pivot,
    twisted by a crossbar at its other end. ``blade`` arms bend in series with the bar.
    """

    stiffness: PositiveRotationalStiffness
    on: str
    kind: Literal["u", "z", "t"] = "u"
    blade: Blade | None = None


class TorsionBar(Description):
    """Torsion bar on the axis of an arm or the rocker: ``stiffness`` (N m/rad), ``preload`` (N m) at design.

    Torque and angle are positive in bump. The bar replaces the strut's spring, or acts in parallel with it.
    """

    stiffness: PositiveRotationalStiffness
    preload: Torque = 0.0
    on: str


class ThirdSpring(Description):
    """Spring and optional damper between ``hardpoints.third_spring_end`` and its mirror image.

    It resists heave and has almost no effect in roll. ``on`` is the body that carries its end. Deflection is design
    length minus length, compression positive, as for a strut.
    """

    spring: CoilSpring
    damper: Damper | None = None
    on: str
