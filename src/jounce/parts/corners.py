"""3-D rigs: one corner of a car as rigid bodies between named hardpoints, one class for each suspension."""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self, Union

from pydantic import Field, model_validator

from jounce.core.constants import GRAVITY
from jounce.core.description import Description, misplaced
from jounce.core.units import Acceleration, Angle, Mass, PositiveLength
from jounce.parts.bodies import Inertia, Point, RigidBody, Triple, distance, distance_to_line
from jounce.parts.elements import AntiRollBar, Bushing, CornerTyre, Friction, SpatialStrut, Steering
from jounce.parts.rig import Rig, stop_to_strut

LARGE = 10.0
"""Coordinate in m that no point of a corner has."""
SAME_POINT = 1e-6
"""Distance in m below which two points are one."""
ON_ONE_LINE = 1e-3
"""Share of its triangle's size that a point must keep away from the axis it is to turn about."""


class Hardpoints(Description):
    """What all suspensions have: positions at design in m, x forward, y left, z up; the road is z = 0.

    Spring and damper lie on the strut's line unless their own ends are given.
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

    outer: ClassVar[tuple[str, ...]] = ("wheel_centre",)
    """Points that stand on the wheel's side of the arms."""
    different: ClassVar[tuple[tuple[str, ...], ...]] = (
        ("strut_bottom", "strut_top"),
        ("spring_bottom", "spring_top"),
        ("damper_bottom", "damper_top"),
        ("arb_pivot", "arb_arm_end"),
        ("arb_arm_end", "arb_link_end"),
    )
    """Groups in which no two points may be the same."""
    turning: ClassVar[tuple[tuple[str, str, str], ...]] = ()
    """Two points of an axis, and a point that turns about it."""
    together: ClassVar[tuple[tuple[str, ...], ...]] = (("arb_pivot", "arb_arm_end", "arb_link_end"),)
    """Groups of which all points are given or none."""

    @model_validator(mode="after")
    def _can_move(self) -> Self:
        self._refuse_lost_points()
        for group in self.together:
            self._refuse_half(group)
        for group in self.different:
            for one, other in combinations(group, 2):
                self._refuse_equal(one, other)
        for one, other, turned in self.turning:
            self._refuse_one_line(one, other, turned)
        return self

    def at(self, name: str) -> Triple | None:
        """Position of a point in m, shape (3,); ends of spring and damper that are not given are the strut's."""
        value: Triple | None = getattr(self, name)
        element, _, end = name.partition("_")
        return self.at(f"strut_{end}") if value is None and element in ("spring", "damper") else value

    def given(self) -> dict[str, Triple]:
        """Points that the description holds: name to position in m, shape (3,)."""
        points = {name: getattr(self, name) for name in type(self).model_fields}
        return {name: point for name, point in points.items() if point is not None}

    def length(self, element: str) -> float:
        """Design length of ``"spring"``, ``"damper"`` or ``"strut"`` in m."""
        bottom, top = self.at(f"{element}_bottom"), self.at(f"{element}_top")
        assert bottom is not None
        assert top is not None
        return distance(bottom, top)

    def _refuse_lost_points(self) -> None:
        """Refuse single points in another unit than the rest; where all are large, it is a finding."""
        sizes = {name: max(abs(value) for value in point) for name, point in self.given().items()}
        for name, size in sizes.items():
            if size > LARGE and min(sizes.values()) < LARGE:
                raise misplaced(
                    (name,),
                    f"lies far from the other points; found {list(getattr(self, name))} m. Millimetres as metres? "
                    'A bare number is in m; write "150 mm"',
                )

    def _refuse_half(self, group: tuple[str, ...]) -> None:
        missing = [name for name in group if getattr(self, name) is None]
        if 0 < len(missing) < len(group):
            raise ValueError(f"{' and '.join(missing)} missing; give all of {', '.join(group)}, or none of them")

    def _refuse_equal(self, one: str, other: str) -> None:
        a, b = self.at(one), self.at(other)
        if a is None or b is None or distance(a, b) >= SAME_POINT:
            return
        one, other = (one, other) if getattr(self, other) is not None else (other, one)
        raise misplaced(
            (other,),
            f"the same point as {one}; found {written(b)} for both; allowed: two points that differ. "
            "Was a line copied and not changed?",
        )

    def _refuse_one_line(self, one: str, other: str, turned: str) -> None:
        a, b, c = self.at(one), self.at(other), self.at(turned)
        if a is None or b is None or c is None:
            return
        if distance_to_line(c, a, b) < ON_ONE_LINE * max(distance(a, b), distance(a, c)):
            raise misplaced(
                (turned,),
                f"lies on the line through {one} and {other}; found {written(c)}; allowed: a point away from it, "
                "because nothing could turn it about that axis",
            )


class DoubleWishboneHardpoints(Hardpoints):
    """Two arms, each on an axis through two points of the body, an upright between their ball joints, a tie rod."""

    lower_arm_front: Point
    lower_arm_rear: Point
    lower_ball_joint: Point
    upper_arm_front: Point
    upper_arm_rear: Point
    upper_ball_joint: Point
    tie_rod_inner: Point
    tie_rod_outer: Point
    pushrod_outer: Point | None = None
    pushrod_inner: Point | None = None
    rocker_pivot: Point | None = None
    rocker_axis: Point | None = None

    outer: ClassVar[tuple[str, ...]] = ("wheel_centre", "lower_ball_joint", "upper_ball_joint", "tie_rod_outer")
    different: ClassVar[tuple[tuple[str, ...], ...]] = (
        (
            "lower_arm_front",
            "lower_arm_rear",
            "lower_ball_joint",
            "upper_arm_front",
            "upper_arm_rear",
            "upper_ball_joint",
            "tie_rod_inner",
            "tie_rod_outer",
        ),
        *Hardpoints.different,
        ("pushrod_outer", "pushrod_inner"),
        ("rocker_pivot", "rocker_axis"),
    )
    turning: ClassVar[tuple[tuple[str, str, str], ...]] = (
        ("lower_arm_front", "lower_arm_rear", "lower_ball_joint"),
        ("upper_arm_front", "upper_arm_rear", "upper_ball_joint"),
        ("lower_ball_joint", "upper_ball_joint", "tie_rod_outer"),
        ("rocker_pivot", "rocker_axis", "pushrod_inner"),
    )
    together: ClassVar[tuple[tuple[str, ...], ...]] = (
        *Hardpoints.together,
        ("pushrod_outer", "pushrod_inner", "rocker_pivot", "rocker_axis"),
    )


class McPhersonHardpoints(Hardpoints):
    """One arm, a strut that guides the upright along the line from ``strut_bottom`` to ``strut_top``, a tie rod."""

    lower_arm_front: Point
    lower_arm_rear: Point
    lower_ball_joint: Point
    tie_rod_inner: Point
    tie_rod_outer: Point

    outer: ClassVar[tuple[str, ...]] = ("wheel_centre", "lower_ball_joint", "tie_rod_outer", "strut_bottom")
    different: ClassVar[tuple[tuple[str, ...], ...]] = (
        (
            "lower_arm_front",
            "lower_arm_rear",
            "lower_ball_joint",
            "tie_rod_inner",
            "tie_rod_outer",
            "strut_top",
        ),
        *Hardpoints.different,
    )
    turning: ClassVar[tuple[tuple[str, str, str], ...]] = (
        ("lower_arm_front", "lower_arm_rear", "lower_ball_joint"),
        ("lower_ball_joint", "strut_top", "tie_rod_outer"),
    )


class FiveLinkHardpoints(Hardpoints):
    """Five links with a joint at either end between body (inner) and upright (outer); link 5 is the toe link."""

    link_1_inner: Point
    link_1_outer: Point
    link_2_inner: Point
    link_2_outer: Point
    link_3_inner: Point
    link_3_outer: Point
    link_4_inner: Point
    link_4_outer: Point
    link_5_inner: Point
    link_5_outer: Point
    pushrod_outer: Point | None = None
    pushrod_inner: Point | None = None
    rocker_pivot: Point | None = None
    rocker_axis: Point | None = None

    outer: ClassVar[tuple[str, ...]] = ("wheel_centre", *(f"link_{i}_outer" for i in range(1, 6)))
    different: ClassVar[tuple[tuple[str, ...], ...]] = (
        *((f"link_{i}_inner", f"link_{i}_outer") for i in range(1, 6)),
        *DoubleWishboneHardpoints.different[1:],
    )
    turning: ClassVar[tuple[tuple[str, str, str], ...]] = (("rocker_pivot", "rocker_axis", "pushrod_inner"),)
    together: ClassVar[tuple[tuple[str, ...], ...]] = DoubleWishboneHardpoints.together

    @model_validator(mode="after")
    def _no_rod_twice(self) -> Self:
        for i, j in combinations(range(1, 6), 2):
            ends = [(self.at(f"link_{i}_{end}"), self.at(f"link_{j}_{end}")) for end in ("inner", "outer")]
            if all(a is not None and b is not None and distance(a, b) < SAME_POINT for a, b in ends):
                raise misplaced(
                    (f"link_{j}_inner",), f"link {j} has both ends of link {i}; allowed: five different links"
                )
        return self


class TrailingArmHardpoints(Hardpoints):
    """One arm with the wheel, on an axis through ``arm_inner`` and ``arm_outer`` of the body."""

    arm_inner: Point
    arm_outer: Point

    different: ClassVar[tuple[tuple[str, ...], ...]] = (
        ("arm_inner", "arm_outer", "wheel_centre"),
        *Hardpoints.different,
    )
    turning: ClassVar[tuple[tuple[str, str, str], ...]] = (("arm_inner", "arm_outer", "wheel_centre"),)


def written(point: Triple) -> str:
    """Write a point as files do, in mm."""
    return "[" + ", ".join(f'"{1e3 * value:g} mm"' for value in point) + "]"


ACROSS = 0.05
"""Share of the wheel centre's distance from the middle of the car by which a point may lie on the other side."""


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

    schema_: Literal["jounce.rig/1"] = Field(default="jounce.rig/1", alias="schema")
    gravity: Acceleration = GRAVITY
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

    def mirrored(self) -> Self:
        """Give the same corner of the car's other side: mirrored at y = 0, the rack's travel too.

        Returns
        -------
        Corner
            Left of a right corner and the other way round.

        Examples
        --------
        >>> from jounce.parts import load
        >>> left = load("reference-double-wishbone")
        >>> left.mirrored().hardpoints.wheel_centre   # m
        (0.0, -0.76, 0.3)
        >>> left.mirrored().mirrored() == left
        True
        """
        table = _turned_over(self.model_dump(by_alias=True, exclude_none=True))
        return type(self).from_table({**table, "side": "right" if self.side == "left" else "left"})

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


def _turned_over(table: dict[str, Any]) -> dict[str, Any]:
    """Table of a rig with the sign of everything changed that a mirror at y = 0 changes."""
    found = dict(table)
    for key, value in table.items():
        if key == "bushings":
            continue
        if isinstance(value, dict):
            found[key] = _mirrored_points(value) if key == "hardpoints" else _turned_over(value)
        elif key in ("centre_of_mass", "joint"):
            found[key] = (value[0], -value[1], value[2])
        elif key in ("xy", "yz", "rack_travel"):
            found[key] = -value
    return found


def _mirrored_points(table: dict[str, Any]) -> dict[str, Any]:
    return {name: (x, -y, z) for name, (x, y, z) in table.items()}


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


if TYPE_CHECKING:
    AnyCorner = Corner
else:
    AnyCorner = Annotated[Union[tuple(Corner.__subclasses__())], Field(discriminator="model")]  # noqa: UP007
"""Any of the suspensions above, by its ``model``."""
