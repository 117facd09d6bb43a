"""What connects both wheels of an axle: anti-roll bar and third spring, at any pair of their travels.

Everything follows from one energy: forces at the wheels are its slopes along their travel, forces of links those that
hold the bar.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from jounce.core.types import Array
from jounce.kinematics.model import KinematicModel
from jounce.models.bars import t_bar_function
from jounce.parts import Corner


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
    """Force of the third spring with its damper at rest (N), and the way it pushes the left side, (n, 3)."""
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
    pivot, sides = left.point("arb_pivot"), (left, right)
    stem = left.point("arb_axis") - pivot
    arms, far = (
        np.stack([one.point(f"arb_{name}") - pivot for one in sides], axis=1) for name in ("arm_end", "link_end")
    )
    known = [wheel.ends.bar for wheel in sides if wheel.ends and wheel.ends.bar]
    ends, rates = [end - pivot for end, _ in known], [rate for _, rate in known]
    count = len(ends[0])
    each = [np.tile(part, (1, count)) for part in (stem[:, None], arms, far)]
    parts = t_bar_function().map(count)(*each, np.stack(ends, axis=2).transpose(1, 0, 2).reshape(3, 2 * count))
    hinge, twist = (part.full()[0] for part in parts[:2])
    tips, ways = (part.full().reshape(3, count, 2).transpose(2, 1, 0) for part in parts[2:4])  # (2, n, 3)
    levers = parts[4].full().reshape(2, count, 2).transpose(1, 2, 0)  # (n, motion, link)
    torque = stiffness * twist
    held = np.isfinite(levers).all(axis=(1, 2)) & np.isfinite(twist)
    pulls = np.full((count, 2), np.nan)
    asked = np.stack([np.zeros_like(torque), torque], axis=1)
    pulls[held] = np.linalg.solve(levers[held], asked[held][:, :, None])[:, :, 0]
    for i, (way, rate) in enumerate(zip(ways, rates, strict=True)):
        found.forces[i] = found.forces[i] + pulls[:, i] * _dot(way, rate)
        found.links.append(np.asarray(pulls[:, i], dtype=np.float64))
        found.arm_ends.append(pivot + tips[i])
    over = np.stack([np.cos(hinge), np.zeros(count), np.sin(hinge)], axis=1)
    found.stem_end = pivot + stem[0] * over * [1.0, 1.0, -1.0] + stem[2] * over[:, ::-1]
    found.add("anti_roll_bar_hinge_angle", hinge, "rad", "turn of the T-bar about its hinge", "positive: about +y")
    _add_bar(found, twist, torque)


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
    spring, still = model.functions["third_force"].map(len(length))(each, seen[None, :]).full()
    force = spring + still
    found.forces[0] = found.forces[0] - force * _dot(outward, rate)
    found.forces[1] = found.forces[1] + force * _dot(outward, other_rate)
    found.third = force, outward
    found.add("third_spring_length", length, "m", "length of the third spring", "never negative")
    text = "compression of the third spring from design"
    found.add("third_spring_deflection", design - length, "m", text, "positive: compression")
    found.add("third_spring_force", spring, "N", "force of the third spring", "positive: compression")


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.sum(a * b, axis=-1))
