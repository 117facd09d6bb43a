"""Hardpoints of the suspensions, each model its table; points that cannot be a mechanism are refused by name."""

from __future__ import annotations

from itertools import combinations
from typing import ClassVar, Self

from pydantic import model_validator

from jounce.core.description import Description, misplaced
from jounce.parts.points import Point, Triple, distance, distance_to_line

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
