"""3-D rigs: one corner of a car as a mechanism of rigid bodies between named hardpoints."""

from __future__ import annotations

from typing import Any, Literal, Self

from pydantic import model_validator

from jounce.core.description import Description, misplaced
from jounce.core.units import Acceleration, Angle, Mass, PositiveLength
from jounce.parts.bodies import Inertia, RigidBody
from jounce.parts.elements import Friction
from jounce.parts.hardpoints import (
    DoubleWishboneHardpoints,
    FiveLinkHardpoints,
    Hardpoints,
    McPhersonHardpoints,
    TrailingArmHardpoints,
    written,
)
from jounce.parts.points import Point
from jounce.parts.rig import Rig, stop_to_strut
from jounce.parts.struts import AntiRollBar, Bushing, CornerTyre, SpatialStrut, Steering

ACROSS = 0.05
"""Share of the wheel centre's distance from the middle of the car by which a point may lie on the other side."""
LINKS = tuple(f"link_{i}" for i in range(1, 6))


class Wheel(Description):
    """Wheel: ``radius`` (m); static ``camber`` (rad, positive top outward) and ``toe`` (rad, toe-in)."""

    radius: PositiveLength
    camber: Angle = 0.0
    toe: Angle = 0.0
    width: PositiveLength | None = None


class SprungBody(Description):
    """What the guide carries: its mass (kg); on a spherical joint also where its mass is, its inertia and the joint."""

    mass: Mass
    centre_of_mass: Point | None = None
    inertia: Inertia | None = None
    joint: Point | None = None


class Corner(Rig):
    """What all 3-D rigs share. x forward, y left, z up; the hardpoints are the design position, z = 0 is the road.

    ``guide`` says how the body is held: not free, free along z, or free along z and to turn about ``sprung.joint``.
    """

    gravity: Acceleration = 9.81
    side: Literal["left", "right"] = "left"
    guide: Literal["fixed", "vertical", "vertical+spherical"] = "vertical"
    guide_friction: Friction | None = None
    sprung: SprungBody | None = None
    wheel: Wheel
    tyre: CornerTyre
    hardpoints: Hardpoints
    bodies: Description
    strut: SpatialStrut
    anti_roll_bar: AntiRollBar | None = None

    @property
    def sign(self) -> float:
        """1 on the left side of the car (y > 0), -1 on the right."""
        return 1.0 if self.side == "left" else -1.0

    @property
    def undeformed_radius(self) -> float:
        """Radius of the unloaded tyre in m."""
        return self.wheel.radius if self.tyre.undeformed_radius is None else self.tyre.undeformed_radius

    def body_masses(self) -> dict[str, RigidBody]:
        """Bodies of the suspension that the description holds, by name; the sprung body is not among them."""
        found = {name: getattr(self.bodies, name) for name in type(self.bodies).model_fields}
        return {name: body for name, body in found.items() if body is not None}

    @model_validator(mode="before")
    @classmethod
    def _stop_belongs_to_the_strut(cls, table: Any) -> Any:
        return stop_to_strut(table)

    @model_validator(mode="after")
    def _is_complete(self) -> Self:
        self._check_side()
        self._check_sprung()
        self._check_attachments()
        return self

    def _check_side(self) -> None:
        """Refuse points that stand on the other side of the car, and wheels in the road."""
        centre = self.hardpoints.wheel_centre
        if self.sign * centre[1] <= 0.0:
            raise misplaced(
                ("hardpoints", "wheel_centre"),
                f"not on the {self.side} side of the car; found y = {1e3 * centre[1]:g} mm; allowed: "
                f'{"above" if self.side == "left" else "below"} 0 for side = "{self.side}" (y points to the left). '
                f"Change side, or the sign of all y",
            )
        if centre[2] <= 0.0:
            raise misplaced(
                ("hardpoints", "wheel_centre"),
                f"lies in or below the road, which is z = 0; found z = {1e3 * centre[2]:g} mm; allowed: above 0. "
                "Add the loaded radius of the tyre to all heights",
            )
        for name, point in self.hardpoints.given().items():
            allowed = 0.0 if name in self.hardpoints.outer else ACROSS * abs(centre[1])
            if self.sign * point[1] < -allowed and name not in ("rocker_axis", "arb_pivot"):
                raise misplaced(
                    ("hardpoints", name),
                    f"on the other side of the car than the wheel; found {written(point)}, the wheel centre has y = "
                    f"{1e3 * centre[1]:g} mm; allowed: points of one side. Is the sign of y wrong?",
                )

    def _check_sprung(self) -> None:
        """Refuse a body on a guide without what the guide needs to move it."""
        if self.guide == "fixed":
            return
        needed = ("mass",) if self.guide == "vertical" else ("mass", "centre_of_mass", "inertia", "joint")
        missing = [name for name in needed if self.sprung is None or getattr(self.sprung, name) is None]
        if missing:
            raise misplaced(
                ("sprung",),
                f'{", ".join(missing)} missing; guide = "{self.guide}" needs {", ".join(needed)}',
            )

    def _check_attachments(self) -> None:
        """Refuse elements on bodies that the rig does not have."""
        self._require_body("strut", self.strut_body)
        rocker = getattr(self.hardpoints, "rocker_pivot", None)
        if self.strut_body == "rocker" and rocker is None:
            raise misplaced(
                ("strut", "on"),
                "there is no rocker; allowed with hardpoints pushrod_outer, pushrod_inner, rocker_pivot, rocker_axis",
            )
        if rocker is not None:
            self._require_body("hardpoints", "rocker")
        bar_points = self.hardpoints.arb_pivot is not None
        if bar_points != (self.anti_roll_bar is not None):
            raise misplaced(
                ("hardpoints",) if bar_points else ("anti_roll_bar",),
                "an anti-roll bar needs its table [anti_roll_bar] and hardpoints arb_pivot, arb_arm_end, arb_link_end; "
                f"found only {'the points' if bar_points else 'the table'}",
            )

    def _require_body(self, element: str, name: str) -> None:
        if name in self.body_masses():
            return
        raise misplaced(
            (element, "on") if element == "strut" else (element,),
            f"the body {name!r} carries it and does not exist; allowed: {', '.join(self.body_masses())}, or a table "
            f"[bodies.{name}] with mass, centre_of_mass and inertia",
        )

    @property
    def strut_body(self) -> str:
        """Body that the strut's bottom is on."""
        return str(getattr(self.strut, "on"))  # noqa: B009 - every subclass has it


class DoubleWishboneBodies(Description):
    """Bodies of a double wishbone; the upright carries the wheel unless ``wheel`` is a body of its own."""

    lower_arm: RigidBody
    upper_arm: RigidBody
    upright: RigidBody
    tie_rod: RigidBody | None = None
    rocker: RigidBody | None = None
    wheel: RigidBody | None = None


class DoubleWishboneStrut(SpatialStrut):
    """Strut on an arm, the upright or a rocker, whose push rod stands on the body ``pushrod_on``."""

    on: Literal["lower_arm", "upper_arm", "upright", "rocker"] = "lower_arm"
    pushrod_on: Literal["lower_arm", "upper_arm", "upright"] = "lower_arm"


class DoubleWishboneBar(AntiRollBar):
    """Anti-roll bar linked to an arm or the upright."""

    on: Literal["lower_arm", "upper_arm", "upright"] = "lower_arm"


class DoubleWishboneBushings(Description):
    """Bushings in place of the arms' joints on the body."""

    lower_arm_front: Bushing | None = None
    lower_arm_rear: Bushing | None = None
    upper_arm_front: Bushing | None = None
    upper_arm_rear: Bushing | None = None
    tie_rod_inner: Bushing | None = None


class DoubleWishbone(Corner):
    """Double wishbone: two arms, an upright between their ball joints, a tie rod, a strut."""

    model: Literal["double-wishbone"] = "double-wishbone"
    hardpoints: DoubleWishboneHardpoints
    bodies: DoubleWishboneBodies
    strut: DoubleWishboneStrut
    steering: Steering | None = None
    anti_roll_bar: DoubleWishboneBar | None = None
    bushings: DoubleWishboneBushings = DoubleWishboneBushings()


class McPhersonBodies(Description):
    """Bodies of a McPherson suspension; ``strut`` is the part that slides in the upright and hangs on the body."""

    lower_arm: RigidBody
    upright: RigidBody
    strut: RigidBody | None = None
    tie_rod: RigidBody | None = None
    wheel: RigidBody | None = None


class McPhersonStrut(SpatialStrut):
    """Strut that guides the upright."""

    on: Literal["upright"] = "upright"


class McPhersonBar(AntiRollBar):
    """Anti-roll bar linked to the arm or the upright."""

    on: Literal["lower_arm", "upright"] = "upright"


class McPhersonBushings(Description):
    """Bushings in place of the arm's joints on the body."""

    lower_arm_front: Bushing | None = None
    lower_arm_rear: Bushing | None = None
    tie_rod_inner: Bushing | None = None
    strut_top: Bushing | None = None


class McPherson(Corner):
    """McPherson strut: one arm, a tie rod, and a strut that guides the upright."""

    model: Literal["mcpherson"] = "mcpherson"
    hardpoints: McPhersonHardpoints
    bodies: McPhersonBodies
    strut: McPhersonStrut
    steering: Steering | None = None
    anti_roll_bar: McPhersonBar | None = None
    bushings: McPhersonBushings = McPhersonBushings()


class FiveLinkBodies(Description):
    """Bodies of a five-link suspension; a link without mass is a rod of fixed length."""

    upright: RigidBody
    link_1: RigidBody | None = None
    link_2: RigidBody | None = None
    link_3: RigidBody | None = None
    link_4: RigidBody | None = None
    link_5: RigidBody | None = None
    rocker: RigidBody | None = None
    wheel: RigidBody | None = None


class FiveLinkStrut(SpatialStrut):
    """Strut on the upright, a link that is a body, or a rocker."""

    on: Literal["upright", "link_1", "link_2", "link_3", "link_4", "link_5", "rocker"] = "upright"
    pushrod_on: Literal["upright"] = "upright"


class FiveLinkBar(AntiRollBar):
    """Anti-roll bar linked to the upright."""

    on: Literal["upright"] = "upright"


class FiveLinkBushings(Description):
    """Bushings in place of the links' joints on the body."""

    link_1_inner: Bushing | None = None
    link_2_inner: Bushing | None = None
    link_3_inner: Bushing | None = None
    link_4_inner: Bushing | None = None
    link_5_inner: Bushing | None = None


class FiveLink(Corner):
    """Five links between body and upright; links that share a point are an arm. Link 5 is the toe link or tie rod."""

    model: Literal["five-link"] = "five-link"
    hardpoints: FiveLinkHardpoints
    bodies: FiveLinkBodies
    strut: FiveLinkStrut
    steering: Steering | None = None
    anti_roll_bar: FiveLinkBar | None = None
    bushings: FiveLinkBushings = FiveLinkBushings()


class TrailingArmBodies(Description):
    """Bodies of a trailing arm; the arm carries the wheel unless ``wheel`` is a body of its own."""

    arm: RigidBody
    wheel: RigidBody | None = None


class TrailingArmStrut(SpatialStrut):
    """Strut on the arm."""

    on: Literal["arm"] = "arm"


class TrailingArmBar(AntiRollBar):
    """Anti-roll bar linked to the arm."""

    on: Literal["arm"] = "arm"


class TrailingArmBushings(Description):
    """Bushings in place of the arm's joints on the body."""

    arm_inner: Bushing | None = None
    arm_outer: Bushing | None = None


class TrailingArm(Corner):
    """Trailing or semi-trailing arm: one body that carries the wheel, on an axis through two points of the body."""

    model: Literal["trailing-arm"] = "trailing-arm"
    hardpoints: TrailingArmHardpoints
    bodies: TrailingArmBodies
    strut: TrailingArmStrut
    anti_roll_bar: TrailingArmBar | None = None
    bushings: TrailingArmBushings = TrailingArmBushings()
