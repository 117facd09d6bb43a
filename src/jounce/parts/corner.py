"""What all 3-D rigs share: one corner of a car, its body on a guide, its wheel on the road."""

from __future__ import annotations

from typing import Any, Literal, Self

from pydantic import Field, model_validator

from jounce.core.constants import GRAVITY
from jounce.core.description import Description, misplaced
from jounce.core.units import Acceleration, Angle, Mass, PositiveLength
from jounce.parts.bodies import Inertia, RigidBody
from jounce.parts.elements import Friction
from jounce.parts.hardpoints import Hardpoints, written
from jounce.parts.points import Point
from jounce.parts.rig import Rig, stop_to_strut
from jounce.parts.struts import AntiRollBar, CornerTyre, SpatialStrut

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
