"""What there is to draw of a 3-D rig: its parts between hardpoints, its wheel, its strut, at design."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.types import Array
from jounce.plots.style import INK, PALETTE

if TYPE_CHECKING:
    from jounce.parts.corners import Corner


COLOURS = {
    "lower_arm": PALETTE[0],
    "upper_arm": PALETTE[2],
    "arm": PALETTE[0],
    "link_1": PALETTE[0],
    "link_2": PALETTE[5],
    "link_3": PALETTE[2],
    "link_4": "#7a9a1e",
    "link_5": PALETTE[1],
    "tie_rod": PALETTE[1],
    "upright": INK,
    "strut": PALETTE[3],
    "pushrod": PALETTE[4],
    "rocker": "#7b5ea7",
    "anti_roll_bar": "#8c6d5a",
}
"""Colour of each part, the same in every picture."""
_STEERING_AXES = {
    "double-wishbone": ("lower_ball_joint", "upper_ball_joint"),
    "mcpherson": ("lower_ball_joint", "strut_top"),
}
_WORDS = {
    "double-wishbone": "double wishbone",
    "mcpherson": "McPherson strut",
    "five-link": "five-link suspension",
    "trailing-arm": "trailing arm",
    "anti_roll_bar": "anti-roll bar",
    "pushrod": "push rod",
}
BAR = ("arb_pivot", "arb_arm_end", "arb_link_end")
_USUAL_WIDTH = 0.6  # of the radius


@dataclass(frozen=True)
class Part:
    """A part as a line along hardpoints, or as a plate with corners at three or more of them.

    Attributes
    ----------
    name : str
        As descriptions call it.
    points : tuple of str
        Hardpoints along it.
    colour : str
        As ``#rrggbb``.
    """

    name: str
    points: tuple[str, ...]
    colour: str

    @property
    def words(self) -> str:
        """The name as people write it."""
        return _WORDS.get(self.name) or self.name.replace("_", " ")

    @property
    def plate(self) -> bool:
        """Whether it is drawn as a surface."""
        return len(self.points) > 2 and self.name != "anti_roll_bar"


@dataclass(frozen=True)
class Bracket:
    """A thin line from a hardpoint to the nearest place on the part that carries it.

    Attributes
    ----------
    point : str
        The hardpoint.
    first, second : str
        The place lies between these two.
    share : float
        How far from the first to the second [1].
    colour : str
        As ``#rrggbb``.
    """

    point: str
    first: str
    second: str
    share: float
    colour: str


@dataclass(frozen=True)
class Scene:
    """What does not change from pose to pose.

    Attributes
    ----------
    title : str
        Model and side.
    side : float
        1 on the left, -1 on the right.
    parts : tuple of Part
        Links, arms, upright, in the order of drawing; not the strut.
    brackets : tuple of Bracket
        How points that lie beside their part are held.
    on_body : frozenset of str
        Hardpoints that stand on the car's body.
    spring, damper : tuple of str
        Hardpoints at its bottom and its top.
    steering_axis : tuple of str, or None
        Lower and upper hardpoint; None where no two points mark the axis.
    radius, undeformed_radius, width : float
        Of the wheel at design, of the unloaded tyre, and across, m.
    design : Pose
        The pose that the description gives.
    """

    title: str
    side: float
    parts: tuple[Part, ...]
    brackets: tuple[Bracket, ...]
    on_body: frozenset[str]
    spring: tuple[str, str]
    damper: tuple[str, str]
    steering_axis: tuple[str, str] | None
    radius: float
    undeformed_radius: float
    width: float
    design: Pose

    @property
    def damper_length(self) -> float:
        """Design length of the damper in m."""
        bottom, top = (self.design.points[name] for name in self.damper)
        return float(np.linalg.norm(top - bottom))

    @property
    def coil_radius(self) -> float:
        """Radius in m with which the spring is drawn."""
        bottom, top = (self.design.points[name] for name in self.spring)
        return min(0.1 * float(np.linalg.norm(top - bottom)), 0.3 * self.radius)

    @property
    def strut_colour(self) -> str:
        """Colour of spring and damper."""
        return COLOURS["strut"]


@dataclass(frozen=True)
class Pose:
    """Where everything is at one moment.

    Attributes
    ----------
    points : mapping of str to ndarray, shape (3,)
        Hardpoints, m.
    spin_axis : ndarray, shape (3,)
        Unit vector along the wheel's axis, outboard.
    contact : ndarray, shape (3,)
        Where the wheel meets the road or, in flight, would meet it, m.
    ground : float
        Height of the road there, m.
    touches : bool
        Whether the tyre carries anything.
    label : str
        What pose this is, e.g. ``"wheel travel 20 mm"``.
    """

    points: Mapping[str, Array]
    spin_axis: Array
    contact: Array
    ground: float
    touches: bool = True
    label: str = ""


def require_corner(rig: object) -> Corner:
    """Give a rig that has hardpoints; refuse all others."""
    from jounce.parts.corners import Corner

    if not isinstance(rig, Corner):
        raise DescriptionError(
            "only a 3-D rig of one corner can be drawn as a mechanism; this one has no hardpoints",
            found=getattr(rig, "model", type(rig).__name__),
            allowed="double-wishbone, mcpherson, five-link, trailing-arm",
        )
    return rig


def scene_of(rig: Corner) -> Scene:
    """Say what there is to draw of a 3-D rig.

    Parameters
    ----------
    rig : Corner
        Its description.

    Returns
    -------
    Scene
        Parts and wheel; which points stand on the body comes from the equations.

    Raises
    ------
    DescriptionError
        For a rig without hardpoints.
    """
    require_corner(rig)
    from jounce.mechanics import Mechanism
    from jounce.models.corner import suspension

    linkage = suspension(rig, Mechanism())
    lines = {name: points for name, points in linkage.lines.items() if name != "strut"}
    names = rig.hardpoints.given()
    if "arb_pivot" in names:
        lines.setdefault("anti_roll_bar", BAR)
    parts = tuple(Part(name, points, COLOURS.get(name, PALETTE[4])) for name, points in lines.items())
    holders = {linkage.chassis.name, linkage.rack.name}
    owners = {name: owner.name for name, owner in linkage.owners.items()}
    on_body = {name for name, owner in owners.items() if owner in holders} | ({"arb_pivot"} & set(names))
    model = str(getattr(rig, "model"))  # noqa: B009 - every subclass has it
    return Scene(
        f"{_WORDS.get(model, model)}, {rig.side} side",
        rig.sign,
        parts,
        _brackets(parts, owners, names),
        frozenset(on_body),
        _ends(names, "spring"),
        _ends(names, "damper"),
        _STEERING_AXES.get(model),
        rig.wheel.radius,
        rig.undeformed_radius,
        rig.wheel.width or _USUAL_WIDTH * rig.wheel.radius,
        _design(rig),
    )


def _brackets(
    parts: tuple[Part, ...], owners: Mapping[str, str], names: Mapping[str, tuple[float, float, float]]
) -> tuple[Bracket, ...]:
    """Hold every point that its part's line does not reach; the rocker's axis is shown in the same way."""
    by_name = {part.name: part for part in parts}
    found = []
    for name, owner in owners.items():
        part = by_name.get(owner)
        if part is None or name in part.points:
            continue
        edges = list(pairwise(part.points)) + ([(part.points[-1], part.points[0])] if part.plate else [])
        found.append(min((_held(names, name, *edge, part.colour) for edge in edges), key=lambda held: held[0])[1])
    if "rocker_axis" in names:
        found.append(Bracket("rocker_axis", "rocker_pivot", "rocker_pivot", 0.0, COLOURS["rocker"]))
    return tuple(found)


def _held(
    names: Mapping[str, tuple[float, float, float]], name: str, first: str, second: str, colour: str
) -> tuple[float, Bracket]:
    """Distance in m of a point from the line between two others, and the bracket between."""
    point, start, end = (np.array(names[one]) for one in (name, first, second))
    along = end - start
    square = float(along @ along)
    share = float(np.clip((point - start) @ along / square, 0.0, 1.0)) if square > 0.0 else 0.0
    return float(np.linalg.norm(start + share * along - point)), Bracket(name, first, second, share, colour)


def _ends(names: Mapping[str, Any], element: str) -> tuple[str, str]:
    bottom, top = (own if (own := f"{element}_{end}") in names else f"strut_{end}" for end in ("bottom", "top"))
    return bottom, top


def _design(rig: Corner) -> Pose:
    points = {name: np.array(place) for name, place in rig.hardpoints.given().items()}
    axis = spin_axes(np.array(rig.wheel.camber), np.array(-rig.sign * rig.wheel.toe), rig.sign)
    contact = contact_points(points["wheel_centre"], axis, rig.wheel.radius)
    return Pose(points, axis, contact, float(contact[2]), label="design position")


def spin_axes(camber: Array, steer: Array, side: float) -> Array:
    """Unit vectors along the wheel's axis, outboard, shape (..., 3), of camber and steer (rad) on a side (1 left)."""
    level = np.cos(camber)
    return np.stack([-side * np.sin(steer) * level, side * np.cos(steer) * level, -np.sin(camber)], axis=-1)


def contact_points(centre: Array, axis: Array, radius: float) -> Array:
    """Lowest points of wheels, shape (..., 3), m, of centre and axis of that shape and radius in m."""
    down = axis * axis[..., 2:] - np.array([0.0, 0.0, 1.0])
    return np.asarray(centre + radius * down / np.linalg.norm(down, axis=-1, keepdims=True))
