"""Dependent axles: two wheels on one beam. Points are given on the left side; the right one is their mirror image."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from jounce.core.constants import GRAVITY
from jounce.core.description import Description
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.units import Acceleration, PositiveRotationalStiffness
from jounce.parts.bodies import Point, RigidBody
from jounce.parts.bushings import Bushing, Link, WheelBearing
from jounce.parts.corners import Wheel
from jounce.parts.elements import AntiRollBar, CornerTyre, SpatialStrut
from jounce.parts.points import SAME_POINT, Groups, NamedPoints, write_point
from jounce.parts.rig import Rig

CENTRED = 1e-6
"""Distance in m from the centre plane of the car within which a point is in it."""


class AxleHardpoints(NamedPoints):
    """Points of all dependent axles: design positions in m, x forward, y left, z up; the road is z = 0.

    Spring and damper act along the strut unless they have end points of their own.
    """

    wheel_centre: Point
    strut_bottom: Point
    strut_top: Point
    spring_bottom: Point | None = None
    spring_top: Point | None = None
    damper_bottom: Point | None = None
    damper_top: Point | None = None
    arb_pivot: Point | None = None
    arb_arm_end: Point | None = None
    arb_link_end: Point | None = None

    together: ClassVar[Groups] = (
        ("spring_bottom", "spring_top"),
        ("damper_bottom", "damper_top"),
        ("arb_pivot", "arb_arm_end", "arb_link_end"),
    )
    different: ClassVar[Groups] = (
        ("strut_bottom", "strut_top"),
        ("spring_bottom", "spring_top"),
        ("damper_bottom", "damper_top"),
        ("arb_arm_end", "arb_link_end"),
    )
    one_sided: ClassVar[tuple[str, ...]] = ()
    """Points that exist once and may lie anywhere."""
    beside: ClassVar[Groups] = (("wheel_centre",),)
    """Groups of which a point lies beside the centre plane, so that its mirror image differs."""

    @model_validator(mode="after")
    def _is_the_left_side(self) -> Self:
        for name in type(self).model_fields:
            point = getattr(self, name)
            if point is not None and name not in self.one_sided and point[1] < -CENTRED:
                raise error_at(
                    (name,),
                    "lies on the right side",
                    found=write_point(point),
                    allowed="points of the left side, y from 0",
                    hint="The right side is their mirror image.",
                )
        for group in self.beside:
            points = [getattr(self, name) for name in group]
            if all(point[1] < SAME_POINT for point in points):
                raise error_at(
                    group[:1],
                    "lies in the centre plane of the car",
                    found=write_point(points[0]),
                    allowed="a point of the left side, y above 0",
                    hint="The axle has it on both sides.",
                )
        return self


class AxleStrut(SpatialStrut):
    """Spring and damper between the axle and the car's body, the same on both sides."""

    on: Literal["axle"] = "axle"


class AxleBar(AntiRollBar):
    """Anti-roll bar: its halves turn on the car's body, its links hold the axle."""

    on: Literal["axle"] = "axle"
    kind: Literal["u"] = "u"


class AxleBushings(Description):
    """Bushings in place of ball joints, by the name of a hardpoint; those of the left side act on both."""

    strut_bottom: Bushing | None = None
    strut_top: Bushing | None = None
    spring_bottom: Bushing | None = None
    spring_top: Bushing | None = None
    damper_bottom: Bushing | None = None
    damper_top: Bushing | None = None
    arb_pivot: Bushing | None = None
    arb_arm_end: Bushing | None = None
    arb_link_end: Bushing | None = None


class AxleLinks(Description):
    """Links that yield under load, by their name."""

    arb_link: Link | None = None


class AxleBodies(Description):
    """Bodies with mass, wheels included; runs need them, the K&C rig and sweeps do not."""


class DependentAxle(Rig):
    """Base of axles whose wheels are joined by a beam; forces and motions of one wheel move the other.

    Units SI; x forward, y left, z up; all points in the design position. ``hardpoints`` are those of the left side. An
    axle of a car needs ``bodies`` and ``tyre``.
    """

    schema_: Literal["jounce.rig/1"] = Field(default="jounce.rig/1", alias="schema")
    gravity: Acceleration = GRAVITY
    wheel: Wheel
    tyre: CornerTyre | None = None
    hardpoints: AxleHardpoints
    bodies: AxleBodies | None = None
    strut: AxleStrut
    bushings: AxleBushings
    links: AxleLinks
    anti_roll_bar: AxleBar | None = None
    bearing: WheelBearing | None = None

    side: ClassVar[str] = "left"
    subframe: ClassVar[None] = None
    torsion_bar: ClassVar[None] = None
    third_spring: ClassVar[None] = None
    without: ClassVar[tuple[str, ...]] = ()
    has_strut: ClassVar[bool] = True
    sign: ClassVar[float] = 1.0
    bushed_in_runs: ClassVar[tuple[str, ...]] = ()
    """Hardpoints whose bushings act in runs; the K&C rig knows all."""

    @property
    def lacks(self) -> tuple[str, ...]:
        """Parts that a car on this axle needs and the description omits."""
        return tuple(name for name in ("bodies", "tyre") if getattr(self, name) is None)

    @property
    def total_mass(self) -> float:
        """Mass of the axle with both wheels, kg."""
        raise NotImplementedError

    @property
    def only_in_kc(self) -> tuple[str, ...]:
        """Bushings, stiffnesses and bearings that runs leave out."""
        soft = [name for name in self._given("bushings") if name not in self.bushed_in_runs]
        yielding = [f"links.{name}" for name in self._given("links")]
        bearing = ["bearing"] if self.bearing is not None else []
        return (*(f"bushings.{name}" for name in soft), *yielding, *bearing)

    @model_validator(mode="after")
    def _has_what_it_names(self) -> Self:
        if (self.anti_roll_bar is None) != (self.hardpoints.arb_pivot is None):
            raise error_at(
                ("anti_roll_bar",),
                "an anti-roll bar needs its table [anti_roll_bar] and hardpoints arb_pivot, arb_arm_end, arb_link_end",
            )
        points = self.hardpoints
        named = [("bushings", name, name) for name in self._given("bushings")]
        named += [
            ("links", name, "arb_link_end" if name == "arb_link" else f"{name}_axle")
            for name in self._given("links")
        ]
        for table, name, point in named:
            if getattr(points, point) is None:
                raise error_at((table, name), Phrase("the hardpoint {name} is missing", name=point))
        return self

    def _given(self, table: str) -> list[str]:
        parts = getattr(self, table)
        return [name for name in type(parts).model_fields if getattr(parts, name) is not None]


class SolidAxleHardpoints(AxleHardpoints):
    """Points of a solid axle on links; each ends on the axle and on the car's body.

    Lower and upper links are on both sides; an upper link in the centre plane exists once. A Panhard rod or a Watt
    linkage guides the axle sideways: ``watt_pivot`` is the pivot of its lever on the axle, and two rods connect the
    ends of the lever to the body.
    """

    lower_link_axle: Point
    lower_link_body: Point
    upper_link_axle: Point | None = None
    upper_link_body: Point | None = None
    panhard_axle: Point | None = None
    panhard_body: Point | None = None
    watt_pivot: Point | None = None
    watt_upper_axle: Point | None = None
    watt_upper_body: Point | None = None
    watt_lower_axle: Point | None = None
    watt_lower_body: Point | None = None

    together = (
        ("upper_link_axle", "upper_link_body"),
        ("panhard_axle", "panhard_body"),
        ("watt_pivot", "watt_upper_axle", "watt_upper_body", "watt_lower_axle", "watt_lower_body"),
    )
    different = (
        ("lower_link_axle", "lower_link_body"),
        ("upper_link_axle", "upper_link_body"),
        ("panhard_axle", "panhard_body"),
        ("watt_upper_axle", "watt_upper_body"),
        ("watt_lower_axle", "watt_lower_body"),
        ("watt_pivot", "watt_upper_axle"),
        ("watt_pivot", "watt_lower_axle"),
    )
    beside = (("wheel_centre",), ("lower_link_axle", "lower_link_body"))
    one_sided = (
        "panhard_axle",
        "panhard_body",
        "watt_pivot",
        "watt_upper_axle",
        "watt_upper_body",
        "watt_lower_axle",
        "watt_lower_body",
    )

    @property
    def has_centre_link(self) -> bool:
        """Whether the upper link exists once, in the centre plane."""
        ends = self.upper_link_axle, self.upper_link_body
        return all(end is not None and abs(end[1]) < CENTRED for end in ends)


class SolidAxleBushings(AxleBushings):
    """Rubber at the hardpoints of a solid axle and its links; each that is missing is an ideal joint."""

    lower_link_axle: Bushing | None = None
    lower_link_body: Bushing | None = None
    upper_link_axle: Bushing | None = None
    upper_link_body: Bushing | None = None
    panhard_axle: Bushing | None = None
    panhard_body: Bushing | None = None
    watt_upper_axle: Bushing | None = None
    watt_upper_body: Bushing | None = None
    watt_lower_axle: Bushing | None = None
    watt_lower_body: Bushing | None = None


class SolidAxleLinks(AxleLinks):
    """Links of a solid axle that yield under load."""

    lower_link: Link | None = None
    upper_link: Link | None = None
    panhard: Link | None = None
    watt_upper: Link | None = None
    watt_lower: Link | None = None


class SolidAxleBodies(AxleBodies):
    """The ``axle`` with both wheels, and the ``watt_lever`` of a Watt linkage."""

    axle: RigidBody
    watt_lever: RigidBody | None = None


class SolidAxle(DependentAxle):
    """Solid axle on two, three or four links, guided sideways by a Panhard rod, a Watt linkage or its upper links."""

    model: Literal["solid-axle"] = "solid-axle"
    hardpoints: SolidAxleHardpoints
    bodies: SolidAxleBodies | None = None
    bushings: SolidAxleBushings = SolidAxleBushings()
    links: SolidAxleLinks = SolidAxleLinks()

    bushed_in_runs = (
        "lower_link_body",
        "upper_link_body",
        "panhard_body",
        "watt_upper_body",
        "watt_lower_body",
    )

    @property
    def total_mass(self) -> float:
        """Mass of the axle with both wheels, kg."""
        bodies = self.bodies
        if bodies is None:
            return 0.0
        return bodies.axle.mass + (0.0 if bodies.watt_lever is None else bodies.watt_lever.mass)

    @model_validator(mode="after")
    def _is_guided_once(self) -> Self:
        points = self.hardpoints
        if points.panhard_axle is not None and points.watt_pivot is not None:
            raise error_at(
                ("hardpoints", "watt_pivot"),
                "the axle is guided sideways twice, by a Panhard rod and a Watt linkage",
                allowed="one of them",
            )
        if self.bodies is not None and (
            (self.bodies.watt_lever is None) != (points.watt_pivot is None)
        ):
            raise error_at(
                ("bodies", "watt_lever"),
                "a Watt linkage and the mass of its lever belong together",
                allowed="both of them, or none",
            )
        return self


class TwistBeamHardpoints(AxleHardpoints):
    """Points of a twist beam: each half turns in a bushing at ``pivot``; the beam joins the halves.

    ``shear_centre`` is the point in the centre plane of the car through which the beam's axis of twist runs, across
    the car.
    """

    pivot: Point
    shear_centre: Point

    different = (("pivot", "wheel_centre"),)
    beside = (("wheel_centre",), ("pivot",))
    one_sided = ("shear_centre",)

    @model_validator(mode="after")
    def _beam_is_in_the_middle(self) -> Self:
        if abs(self.shear_centre[1]) > CENTRED:
            raise error_at(
                ("shear_centre",),
                "is not in the centre plane of the car",
                found=write_point(self.shear_centre),
                allowed="y = 0",
            )
        return self


class TwistBeamBushings(AxleBushings):
    """Rubber at the pivots and struts of a twist beam; each that is missing is an ideal joint."""

    pivot: Bushing | None = None


class Beam(Description):
    """Beam between the halves: ``torsional_stiffness`` (N m/rad) of twist between the wheels' sides."""

    torsional_stiffness: PositiveRotationalStiffness


class TwistBeamBodies(AxleBodies):
    """The left ``half`` with its wheel; the right one is its mirror image."""

    half: RigidBody


class TwistBeam(DependentAxle):
    """Twist-beam axle: two trailing halves on a beam that is stiff in bending and soft in torsion."""

    model: Literal["twist-beam"] = "twist-beam"
    hardpoints: TwistBeamHardpoints
    bodies: TwistBeamBodies | None = None
    beam: Beam
    bushings: TwistBeamBushings = TwistBeamBushings()
    links: AxleLinks = AxleLinks()

    bushed_in_runs = ("pivot",)

    @property
    def total_mass(self) -> float:
        """Mass of the axle with both wheels, kg."""
        return 0.0 if self.bodies is None else 2.0 * self.bodies.half.mass


if TYPE_CHECKING:
    AnyDependentAxle = DependentAxle
else:
    AnyDependentAxle = Annotated[SolidAxle | TwistBeam, Field(discriminator="model")]
"""Any of the axles above, selected by ``model``."""
