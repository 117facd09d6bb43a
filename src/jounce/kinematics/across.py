"""What connects both wheels of an axle: anti-roll bar and third spring, at any pair of their travels.

Everything follows from one energy: forces at the wheels are its slopes along their travel, forces of links those that
hold the bar.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.kinematics.model import KinematicModel
from jounce.parts import Corner

_ITERATIONS, _LEVEL, _CLOSED = 30, 1e-14, 1e-9  # m^2
_LOOSE = 1e7  # how ill a bar may be held by its links
_ACROSS = np.array([0.0, 1.0, 0.0])


@dataclass(frozen=True)
class Ends:
    """Ends of what reaches over to the other wheel: places (m) and slopes along travel, ground axes, shape (n, 3)."""

    bar: tuple[Array, Array] | None
    third: tuple[Array, Array] | None

    @classmethod
    def of(cls, model: KinematicModel, rig: Corner, states: tuple[Array, Array, Array], side: float) -> Ends:
        """Ends of a wheel on a side (1 left, -1 right) at poses, inputs and numbers; no pose gives no number."""
        poses, inputs, numbers = states
        count = poses.shape[1]
        each = np.tile(numbers[:, None], (1, count))
        found = model.functions["across"].map(count)(poses, inputs, each, np.zeros((1, count))).full()
        parts = list(found.reshape(-1, 3, count).transpose(0, 2, 1) * [1.0, side, 1.0])
        bar = (parts.pop(0), parts.pop(0)) if _is_t_bar(rig) else None
        return cls(bar, (parts[0], parts[1]) if parts else None)


@dataclass
class Connection:
    """What connects both wheels, at n pairs of travels; index 0 is the left wheel.

    ``forces`` push the wheel centres down (N); ``rows`` name what is known besides: value, unit, text, sign.
    """

    forces: list[Array]
    turns: list[Array] = field(default_factory=list)
    """Torque that each end of a U- or Z-bar asks for, N m about its axis to the left."""
    links: list[Array] = field(default_factory=list)
    """Tension of each link of a T-bar, N; its ends on the bar are ``arm_ends``, that of its stem ``stem_end`` (m)."""
    arm_ends: list[Array] = field(default_factory=list)
    stem_end: Array | None = None
    third: tuple[Array, Array] | None = None
    """Force of the third spring (N) and the direction in which it pushes the left wheel's side, (n, 3)."""
    rows: dict[str, tuple[Array, str, str, str]] = field(default_factory=dict)

    def add(self, name: str, value: Array, unit: str, text: str, sign: str) -> None:
        """Add a row."""
        self.rows[name] = value, unit, text, sign


@dataclass(frozen=True)
class Wheel:
    """What a connection knows of a wheel: its rows (axes of a left wheel), the ends, its numbers by path.

    ``turned`` is -1 where it stands on the other side than its numbers say.
    """

    rows: dict[str, Array]
    ends: Ends | None
    numbers: dict[str, float]
    turned: float

    def point(self, name: str) -> Array:
        """Hardpoint at design on this wheel's side, m, shape (3,)."""
        x, y, z = (self.numbers[f"hardpoints.{name}[{i}]"] for i in range(3))
        return np.array([x, self.turned * y, z])


def connect(rig: Corner, model: KinematicModel, numbers: Array, left: Wheel, right: Wheel) -> Connection:
    """Give the forces of anti-roll bar and third spring for both wheels, the law being the left corner's."""
    count = len(left.rows["wheel_travel"])
    found = Connection([np.zeros(count), np.zeros(count)])
    if rig.anti_roll_bar is not None:
        stiffness = left.rows["anti_roll_bar_stiffness"]
        if _is_t_bar(rig):
            _t_bar(found, stiffness, left, right)
        else:
            _bar(found, stiffness, left, right, 1.0 if rig.anti_roll_bar.kind == "z" else -1.0)
    if rig.third_spring is not None:
        _third(found, rig, model, numbers, (left, right))
    return found


def reaches_over(rig: Corner) -> bool:
    """Tell whether forces between the wheels need the places of ends on both sides."""
    return _is_t_bar(rig) or rig.third_spring is not None


def _is_t_bar(rig: Corner) -> bool:
    return rig.anti_roll_bar is not None and rig.anti_roll_bar.kind == "t"


def _bar(found: Connection, stiffness: Array, left: Wheel, right: Wheel, way: float) -> None:
    """U-bar (way -1) or Z-bar (1): it twists by the difference, or by the sum, of both ends."""
    angles = [wheel.rows["anti_roll_bar_angle"] for wheel in (left, right)]
    twist = angles[1] + way * angles[0]
    torque = stiffness * twist
    for i, (wheel, sign) in enumerate(((left, way), (right, 1.0))):
        found.turns.append(sign * torque)
        found.forces[i] = found.forces[i] + sign * torque * wheel.rows["anti_roll_bar_motion_ratio"]
    _add_bar(found, twist, torque)


def _add_bar(found: Connection, twist: Array, torque: Array) -> None:
    found.add("anti_roll_bar_twist", twist, "rad", "twist of the anti-roll bar", "positive: right wheel in bump")
    found.add("anti_roll_bar_torque", torque, "N*m", "torque in the anti-roll bar", "positive: right wheel in bump")


def _t_bar(found: Connection, stiffness: Array, left: Wheel, right: Wheel) -> None:
    """T-bar: hinged over by both ends alike, its stem twisted by what they differ."""
    pivot = left.point("arb_pivot")
    stem = left.point("arb_axis") - pivot
    size = np.linalg.norm(stem)
    stem = stem / size
    arms = [wheel.point("arb_arm_end") - pivot for wheel in (left, right)]
    lengths = [
        float(np.linalg.norm(wheel.point("arb_link_end") - pivot - arm))
        for wheel, arm in zip((left, right), arms, strict=True)
    ]
    known = [wheel.ends.bar for wheel in (left, right) if wheel.ends and wheel.ends.bar]
    ends, rates = [end - pivot for end, _ in known], [rate for _, rate in known]
    hinge = 0.5 * (left.rows["anti_roll_bar_angle"] + right.rows["anti_roll_bar_angle"])
    twist = np.zeros_like(hinge)
    for _ in range(_ITERATIONS):
        standing = _turned(stem[None, :], _ACROSS, hinge)
        tips = [_turned(_turned(arm[None, :], stem, twist), _ACROSS, hinge) for arm in arms]
        links = [end - tip for end, tip in zip(ends, tips, strict=True)]
        off = np.stack([_dot(link, link) - length**2 for link, length in zip(links, lengths, strict=True)], axis=1)
        slopes = np.stack(
            [
                np.stack([-2.0 * _dot(link, np.cross(axis, tip)) for axis in (_ACROSS, standing)], axis=1)
                for link, tip in zip(links, tips, strict=True)
            ],
            axis=1,
        )
        if np.nanmax(np.abs(off), initial=0.0) < _LEVEL:
            break
        step = _solved(slopes, -off)
        hinge, twist = hinge + step[:, 0], twist + step[:, 1]
    twist = np.where(np.max(np.abs(off), axis=1) < _CLOSED, twist, np.nan)  # the links do not reach
    torque = stiffness * twist
    along = [link / length for link, length in zip(links, lengths, strict=True)]
    levers = np.stack(  # rows: about the hinge, about the stem; columns: left and right link
        [
            np.stack([_dot(way, np.cross(axis, tip)) for way, tip in zip(along, tips, strict=True)], axis=1)
            for axis in (_ACROSS, standing)
        ],
        axis=1,
    )
    pulls = _solved(levers, np.stack([np.zeros_like(torque), torque], axis=1))
    for i, (way, rate) in enumerate(zip(along, rates, strict=True)):
        found.forces[i] = found.forces[i] + pulls[:, i] * _dot(way, rate)
        found.links.append(np.asarray(pulls[:, i], dtype=np.float64))
        found.arm_ends.append(pivot + tips[i])
    found.stem_end = np.asarray(pivot + size * _turned(stem[None, :], _ACROSS, hinge))
    found.add("anti_roll_bar_hinge_angle", hinge, "rad", "turn of the T-bar about its hinge", "positive: about +y")
    _add_bar(found, twist, torque)


def _solved(matrices: Array, right: Array) -> Array:
    """Solve for the two motions of a T-bar at each pose; a bar that its links cannot hold is refused."""
    known = np.isfinite(matrices).all(axis=(1, 2))
    if np.any(np.linalg.cond(matrices[known]) > _LOOSE):
        raise SimulationError(
            "the links of the T-bar cannot hold it: they pass its hinge or its stem",
            hint="Move hardpoints.arb_arm_end or arb_link_end.",
        )
    found = np.full_like(right, np.nan)
    found[known] = np.linalg.solve(matrices[known], right[known][:, :, None])[:, :, 0]
    return found


def _third(found: Connection, rig: Corner, model: KinematicModel, numbers: Array, wheels: tuple[Wheel, Wheel]) -> None:
    (one, rate), (other, other_rate) = (wheel.ends.third for wheel in wheels if wheel.ends and wheel.ends.third)
    reach = one - other
    length = np.linalg.norm(reach, axis=1)
    outward = reach / length[:, None]
    ends = [wheel.point("third_spring_end") for wheel in wheels]
    design, mirrored = float(np.linalg.norm(ends[0] - ends[1])), 2.0 * abs(float(ends[0][1]))
    assert rig.third_spring is not None
    seen = length if rig.third_spring.spring.free_length is not None else length + (mirrored - design)
    each = np.tile(numbers[:, None], (1, len(length)))
    force = model.functions["third_force"].map(len(length))(each, seen[None, :]).full()[0]
    found.forces[0] = found.forces[0] - force * _dot(outward, rate)
    found.forces[1] = found.forces[1] + force * _dot(outward, other_rate)
    found.third = force, outward
    found.add("third_spring_length", length, "m", "length of the third spring", "never negative")
    text = "compression of the third spring from design"
    found.add("third_spring_deflection", design - length, "m", text, "positive: compression")
    found.add("third_spring_force", force, "N", "force of the third spring", "positive: compression")


def _turned(vectors: Array, axis: Array, angle: Array) -> Array:
    """Vectors (n, 3) or (1, 3) turned about an axis (3,) by angles (n,)."""
    c, s = np.cos(angle)[:, None], np.sin(angle)[:, None]
    along = (vectors @ axis)[:, None] * axis
    return np.asarray(along + (vectors - along) * c + np.cross(axis, vectors) * s)


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.sum(a * b, axis=-1))
