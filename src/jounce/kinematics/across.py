"""Connections of both wheels of an axle, anti-roll bar and third spring, at any pair of wheel travels.

All forces follow from one energy: forces at the wheels are its derivatives by their travel, and forces of links keep
the bar in equilibrium.
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
    """Ends of the connections on one wheel's side: positions (m), slopes by travel, ground axes, shape (n, 3)."""

    bar: tuple[Array, Array] | None
    third: tuple[Array, Array] | None

    @classmethod
    def of(
        cls, model: KinematicModel, rig: Corner, states: tuple[Array, Array, Array], side: float
    ) -> Ends:
        """Compute ends on a side (1 left, -1 right) for poses, inputs and parameters; NaN without a pose."""
        poses, inputs, numbers = states
        count = poses.shape[1]
        each = np.tile(numbers[:, None], (1, count))
        values = (
            model.functions["across"].map(count)(poses, inputs, each, np.zeros((1, count))).full()
        )
        parts = list(values.reshape(-1, 3, count).transpose(0, 2, 1) * [1.0, side, 1.0])
        bar = (parts.pop(0), parts.pop(0)) if _is_t_bar(rig) else None
        return cls(bar, (parts[0], parts[1]) if parts else None)


@dataclass
class Connection:
    """Forces between both wheels, at n pairs of travels; index 0 is the left wheel.

    ``forces`` push the wheel centres down (N); ``rows`` are further results: value, unit, text, sign.
    """

    forces: list[Array]
    turns: list[Array] = field(default_factory=list)
    """Torque on each end of a U- or Z-bar, N m about its axis to the left."""
    links: list[Array] = field(default_factory=list)
    """Tension of each link of a T-bar, N; its ends on the bar are ``arm_ends``, that of its stem ``stem_end`` (m)."""
    arm_ends: list[Array] = field(default_factory=list)
    stem_end: Array | None = None
    third: tuple[Array, Array] | None = None
    """Force of the third spring with its damper at rest (N), and its direction on the left side, (n, 3)."""
    rows: dict[str, tuple[Array, str, str, str]] = field(default_factory=dict)

    def add(self, name: str, value: Array, unit: str, text: str, sign: str) -> None:
        """Add a row."""
        self.rows[name] = value, unit, text, sign


@dataclass(frozen=True)
class ConnectedWheel:
    """Wheel data for its connections: rows (axes of a left wheel), ends, and parameters by path.

    ``turned`` is -1 if the wheel is on the opposite side from its description.
    """

    rows: dict[str, Array]
    ends: Ends | None
    numbers: dict[str, float]
    turned: float

    def point(self, name: str) -> Array:
        """Hardpoint at design on this wheel's side, m, shape (3,)."""
        x, y, z = (self.numbers[f"hardpoints.{name}[{i}]"] for i in range(3))
        return np.array([x, self.turned * y, z])


def connect(
    rig: Corner, model: KinematicModel, numbers: Array, left: ConnectedWheel, right: ConnectedWheel
) -> Connection:
    """Compute forces of anti-roll bar and third spring on both wheels, by the law of the left corner."""
    count = len(left.rows["wheel_travel"])
    connection = Connection([np.zeros(count), np.zeros(count)])
    if rig.anti_roll_bar is not None:
        stiffness = left.rows["anti_roll_bar_stiffness"]
        if _is_t_bar(rig):
            _t_bar(connection, stiffness, left, right)
        else:
            _bar(connection, stiffness, left, right, 1.0 if rig.anti_roll_bar.kind == "z" else -1.0)
    if rig.third_spring is not None:
        _third(connection, rig, model, numbers, (left, right))
    return connection


def reaches_over(rig: Corner) -> bool:
    """Whether forces between the wheels need the ends on both sides."""
    return _is_t_bar(rig) or rig.third_spring is not None


def _is_t_bar(rig: Corner) -> bool:
    return rig.anti_roll_bar is not None and rig.anti_roll_bar.kind == "t"


def _bar(
    connection: Connection,
    stiffness: Array,
    left: ConnectedWheel,
    right: ConnectedWheel,
    way: float,
) -> None:
    """Add a U-bar (way -1) or Z-bar (1), twisted by the difference, or by the sum, of both ends."""
    angles = [wheel.rows["anti_roll_bar_angle"] for wheel in (left, right)]
    twist = angles[1] + way * angles[0]
    torque = stiffness * twist
    for i, (wheel, sign) in enumerate(((left, way), (right, 1.0))):
        connection.turns.append(sign * torque)
        connection.forces[i] = (
            connection.forces[i] + sign * torque * wheel.rows["anti_roll_bar_motion_ratio"]
        )
    _add_bar(connection, twist, torque)


def _add_bar(connection: Connection, twist: Array, torque: Array) -> None:
    sign = "positive: right wheel in bump"
    connection.add("anti_roll_bar_twist", twist, "rad", "twist of the anti-roll bar", sign)
    connection.add("anti_roll_bar_torque", torque, "N*m", "torque in the anti-roll bar", sign)


def _t_bar(
    connection: Connection, stiffness: Array, left: ConnectedWheel, right: ConnectedWheel
) -> None:
    """Add a T-bar: equal motion of both ends rotates it about its hinge; their difference twists its stem."""
    pivot, sides = left.point("arb_pivot"), (left, right)
    stem = left.point("arb_axis") - pivot
    arms, link_ends = (
        np.stack([wheel_.point(f"arb_{name}") - pivot for wheel_ in sides], axis=1)
        for name in ("arm_end", "link_end")
    )
    bars = [wheel.ends.bar for wheel in sides if wheel.ends and wheel.ends.bar]
    ends, rates = [end - pivot for end, _ in bars], [rate for _, rate in bars]
    count = len(ends[0])
    each = [np.tile(part, (1, count)) for part in (stem[:, None], arms, link_ends)]
    parts = t_bar_function().map(count)(
        *each, np.stack(ends, axis=2).transpose(1, 0, 2).reshape(3, 2 * count)
    )
    hinge, twist = (part.full()[0] for part in parts[:2])
    tips, directions = (
        part.full().reshape(3, count, 2).transpose(2, 1, 0) for part in parts[2:4]
    )  # (2, n, 3)
    levers = parts[4].full().reshape(2, count, 2).transpose(1, 2, 0)  # (n, motion, link)
    torque = stiffness * twist
    reached = np.isfinite(levers).all(axis=(1, 2)) & np.isfinite(twist)
    pulls = np.full((count, 2), np.nan)
    demands = np.stack([np.zeros_like(torque), torque], axis=1)
    pulls[reached] = np.linalg.solve(levers[reached], demands[reached][:, :, None])[:, :, 0]
    for i, (direction, rate) in enumerate(zip(directions, rates, strict=True)):
        connection.forces[i] = connection.forces[i] + pulls[:, i] * _dot(direction, rate)
        connection.links.append(np.asarray(pulls[:, i], dtype=np.float64))
        connection.arm_ends.append(pivot + tips[i])
    stem_direction = np.stack([np.cos(hinge), np.zeros(count), np.sin(hinge)], axis=1)
    connection.stem_end = (
        pivot + stem[0] * stem_direction * [1.0, 1.0, -1.0] + stem[2] * stem_direction[:, ::-1]
    )
    connection.add(
        "anti_roll_bar_hinge_angle",
        hinge,
        "rad",
        "turn of the T-bar about its hinge",
        "positive: about +y",
    )
    _add_bar(connection, twist, torque)


def _third(
    connection: Connection,
    rig: Corner,
    model: KinematicModel,
    numbers: Array,
    wheels: tuple[ConnectedWheel, ConnectedWheel],
) -> None:
    thirds = (wheel.ends.third for wheel in wheels if wheel.ends and wheel.ends.third)
    (left_end, left_rate), (right_end, right_rate) = thirds
    reach = left_end - right_end
    length = np.linalg.norm(reach, axis=1)
    outward = reach / length[:, None]
    ends = [wheel.point("third_spring_end") for wheel in wheels]
    design, mirrored = float(np.linalg.norm(ends[0] - ends[1])), 2.0 * abs(float(ends[0][1]))
    assert rig.third_spring is not None
    effective_length = (
        length if rig.third_spring.spring.free_length is not None else length + (mirrored - design)
    )
    each = np.tile(numbers[:, None], (1, len(length)))
    spring, still = (
        model.functions["third_force"].map(len(length))(each, effective_length[None, :]).full()
    )
    force = spring + still
    connection.forces[0] = connection.forces[0] - force * _dot(outward, left_rate)
    connection.forces[1] = connection.forces[1] + force * _dot(outward, right_rate)
    connection.third = force, outward
    connection.add(
        "third_spring_length", length, "m", "length of the third spring", "never negative"
    )
    text = "compression of the third spring from design"
    connection.add("third_spring_deflection", design - length, "m", text, "positive: compression")
    connection.add(
        "third_spring_force", spring, "N", "force of the third spring", "positive: compression"
    )


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.sum(a * b, axis=-1))
