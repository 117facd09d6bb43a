"""Steering column: from the handwheel's angle, through shafts with universal joints, to pinion and rack.

Angles of handwheel and pinion are positive to the left (counter-clockwise for the driver).
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from jounce.core.errors import DescriptionError, SimulationError
from jounce.core.types import Array
from jounce.parts import Corner
from jounce.parts.elements import Steering, SteeringColumn

_ITERATIONS, _CLOSED = 50, 1e-13  # rad: rounding
_STRAIGHT = 1e-9  # sine of a bend below which shafts are collinear


@dataclass(frozen=True)
class _Joint:
    """A universal joint: its bend, and the angle of the first shaft's pin straight ahead from across the bend, rad."""

    bend: float
    pin: float

    def angle_behind(self, angle: Array) -> tuple[Array, Array]:
        """Return the rotation of the second shaft for a rotation of the first (rad), and its slope."""
        start = _behind(np.asarray(self.pin), self.bend)
        at = angle + self.pin
        slope = np.cos(self.bend) / (np.cos(at) ** 2 + np.cos(self.bend) ** 2 * np.sin(at) ** 2)
        return _behind(at, self.bend) - start, slope

    def curvature(self, angle: Array) -> Array:
        """Return the slope of the slope, 1/rad."""
        at, cosine = angle + self.pin, np.cos(self.bend)
        nearly_one = np.cos(at) ** 2 + cosine**2 * np.sin(at) ** 2
        return np.asarray(cosine * np.sin(self.bend) ** 2 * np.sin(2.0 * at) / nearly_one**2)


def _behind(pin: Array, bend: float) -> Array:
    """Angle after a joint, tan(after) = cos(bend) tan(pin), on the same turn as the pin."""
    turns = np.round(pin / np.pi)
    remainder = pin - np.pi * turns
    return np.asarray(
        np.pi * turns + np.arctan2(np.cos(bend) * np.sin(remainder), np.cos(remainder))
    )


def _joints(column: SteeringColumn) -> list[_Joint]:
    points = (column.handwheel, column.upper_joint, column.lower_joint, column.pinion)
    places = [np.array(point) for point in points if point is not None]
    shafts = [(b - a) / np.linalg.norm(b - a) for a, b in pairwise(places)]
    joints: list[_Joint] = []
    pin, across = float(column.yoke_angle), None
    for first, second in pairwise(shafts):
        normal = np.cross(first, second)
        size = float(np.linalg.norm(normal))
        if size > _STRAIGHT:
            normal = normal / size
        else:  # no plane: any perpendicular direction
            normal = np.cross(first, np.eye(3)[int(np.argmin(np.abs(first)))])
            normal = normal / np.linalg.norm(normal)
        if (
            across is not None
        ):  # after a joint the pin is a quarter turn ahead; the next yoke is turned by the phase
            between = float(np.arctan2(np.cross(across, normal) @ first, across @ normal))
            before = joints[-1]
            pin = (
                float(_behind(np.asarray(before.pin), before.bend))
                + 0.5 * np.pi
                + float(column.phase)
                - between
            )
        joints.append(_Joint(float(np.arctan2(size, first @ second)), pin))
        across = normal
    return joints


def steering_of(rig: Corner) -> Steering:
    """Return the steering of a corner; raise an error if no handwheel moves the rack."""
    steering = getattr(rig, "steering", None)
    if steering is None or steering.rack_ratio is None:
        raise DescriptionError(
            "the rack has no handwheel",
            where="steering.rack_ratio",
            allowed='a table [steering] with rack_ratio = "13 mm/rad", the rack\'s travel over the turn of the pinion',
        )
    return steering  # type: ignore[no-any-return]


def pinion_angle(steering: Steering, handwheel: Array) -> tuple[Array, Array]:
    """Angle of the pinion (rad) for an angle of the handwheel (rad), and its slope [1]; both positive to the left."""
    angle, slope = -np.asarray(handwheel, dtype=float), np.ones_like(handwheel, dtype=float)
    for joint in [] if steering.column is None else _joints(steering.column):
        angle, further = joint.angle_behind(angle)
        slope = slope * further
    return -angle, slope


def pinion_curvature(steering: Steering, handwheel: Array) -> Array:
    """Slope of the slope of `pinion_angle`, 1/rad."""
    angle = -np.asarray(handwheel, dtype=float)
    slope, curvature = np.ones_like(angle), np.zeros_like(angle)
    for joint in [] if steering.column is None else _joints(steering.column):
        after, further = joint.angle_behind(angle)
        curvature = joint.curvature(angle) * slope**2 + further * curvature
        angle, slope = after, slope * further
    return -curvature


def rack_travel(steering: Steering, handwheel: Array) -> tuple[Array, Array]:
    """Travel of the rack (m, to the left) for an angle of the handwheel (rad), and its slope (m/rad)."""
    assert steering.rack_ratio is not None
    angle, slope = pinion_angle(steering, handwheel)
    return steering.rack_ratio * angle, steering.rack_ratio * slope


def handwheel_angle(steering: Steering, rack: Array) -> Array:
    """Angle of the handwheel (rad, to the left) at a travel of the rack (m)."""
    assert steering.rack_ratio is not None
    pinion = np.asarray(rack, dtype=float) / steering.rack_ratio
    angle_of_wheel = pinion.copy()
    for _ in range(_ITERATIONS):
        angle, slope = pinion_angle(steering, angle_of_wheel)
        step = (pinion - angle) / slope
        angle_of_wheel = angle_of_wheel + np.clip(
            step, -0.3, 0.3
        )  # rad: within a period (pi) of the joints' waves
        size = max(1.0, float(np.nanmax(np.abs(angle_of_wheel), initial=0.0)))
        if np.nanmax(np.abs(step), initial=0.0) < _CLOSED * size:
            return np.asarray(angle_of_wheel)
    raise SimulationError(
        "the angle of the handwheel was not found", hint="Are the joints of the column too steep?"
    )
