"""Moving frames: points and directions of a body, their velocities, and their accelerations at constant speeds.

Every point is identified by its position in the design pose (ground axes, m); the axes of every frame are the ground's
in that pose. "Bias" is the acceleration at constant speeds.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import casadi as ca

from jounce.mechanics.rotations import quaternion_matrix, skew

_ZERO = ca.SX(3, 1)


@dataclass(frozen=True)
class Moving:
    """A vector with its rate and the bias of its acceleration, in ground axes."""

    value: ca.SX
    rate: ca.SX
    bias: ca.SX

    def __sub__(self, other: Moving) -> Moving:
        return Moving(self.value - other.value, self.rate - other.rate, self.bias - other.bias)

    def dot(self, other: Moving) -> Moving:
        """Return the scalar product, as a moving scalar."""
        return Moving(
            ca.dot(self.value, other.value),
            ca.dot(self.rate, other.value) + ca.dot(self.value, other.rate),
            ca.dot(self.bias, other.value)
            + 2.0 * ca.dot(self.rate, other.rate)
            + ca.dot(self.value, other.bias),
        )

    def scaled(self, factor: Moving) -> Moving:
        """Multiply by a moving scalar."""
        return Moving(
            factor.value * self.value,
            factor.rate * self.value + factor.value * self.rate,
            factor.bias * self.value + 2.0 * factor.rate * self.rate + factor.value * self.bias,
        )

    @property
    def sine(self) -> Moving:
        """Return the sine of a moving angle."""
        s, c = ca.sin(self.value), ca.cos(self.value)
        return Moving(s, c * self.rate, c * self.bias - s * self.rate**2)

    @property
    def cosine(self) -> Moving:
        """Return the cosine of a moving angle."""
        s, c = ca.sin(self.value), ca.cos(self.value)
        return Moving(c, -s * self.rate, -s * self.bias - c * self.rate**2)


class Orientation:
    """Orientation of a frame by its rotation matrix; ``spin`` (rad/s) and ``spin_bias`` in the frame's own axes."""

    def __init__(self, matrix: ca.SX, spin: ca.SX, spin_bias: ca.SX) -> None:
        self.matrix, self.spin, self.spin_bias = matrix, spin, spin_bias

    def rotate(self, vector: ca.SX) -> ca.SX:
        """Transform a vector from the frame's axes into ground axes."""
        return self.matrix @ vector

    def unrotate(self, vector: ca.SX) -> ca.SX:
        """Transform a vector from ground axes into the frame's axes."""
        return self.matrix.T @ vector

    def turned(self, tensor: ca.SX) -> ca.SX:
        """Transform a symmetric tensor from the frame's axes into ground axes."""
        return symmetric(self.matrix @ tensor @ self.matrix.T)

    @property
    def ground_spin(self) -> ca.SX:
        """Return the angular velocity in ground axes, rad/s."""
        return self.rotate(self.spin)

    def moving(self, vector: ca.SX) -> Moving:
        """Return the motion of a vector fixed in the frame."""
        swept = ca.cross(self.spin, vector)
        bias = ca.cross(self.spin_bias, vector) + ca.cross(self.spin, swept)
        return Moving(self.rotate(vector), self.rotate(swept), self.rotate(bias))


class FixedOrientation(Orientation):
    """The orientation of the ground, and of bodies that only slide on it."""

    def __init__(self) -> None:
        super().__init__(ca.SX.eye(3), _ZERO, _ZERO)

    def rotate(self, vector: ca.SX) -> ca.SX:
        """Return the argument unchanged: the axes do not rotate."""
        return vector

    def unrotate(self, vector: ca.SX) -> ca.SX:
        """Return the argument unchanged: the axes do not rotate."""
        return vector

    def turned(self, tensor: ca.SX) -> ca.SX:
        """Return the argument unchanged: the axes do not rotate."""
        return tensor

    def moving(self, vector: ca.SX) -> Moving:
        """Return the vector with zero rate: the frame does not rotate."""
        return Moving(vector, _ZERO, _ZERO)


class AxisRotation(Orientation):
    """Rotation about an axis fixed in the ground: only a sine, a cosine and their products vary."""

    def __init__(self, axis: ca.SX, angle: ca.SX, speed: ca.SX) -> None:
        self.axis, self.angle, self.speed = axis, angle, speed
        self.sine, self.cosine = ca.sin(angle), ca.cos(angle)
        along = axis @ axis.T
        self._shares = along, ca.SX.eye(3) - along, skew(axis)
        matrix = along + self.cosine * self._shares[1] + self.sine * self._shares[2]
        super().__init__(matrix, axis * speed, _ZERO)

    def rotate(self, vector: ca.SX) -> ca.SX:
        """Transform a vector from the frame's axes into ground axes."""
        along, across = self._parts(vector)
        return along + self.cosine * across + self.sine * ca.cross(self.axis, vector)

    def unrotate(self, vector: ca.SX) -> ca.SX:
        """Transform a vector from ground axes into the frame's axes."""
        along, across = self._parts(vector)
        return along + self.cosine * across - self.sine * ca.cross(self.axis, vector)

    def moving(self, vector: ca.SX) -> Moving:
        """Return the motion of a vector fixed in the frame."""
        along, across = self._parts(vector)
        sideways = ca.cross(self.axis, vector)
        turned = self.cosine * across + self.sine * sideways
        swept = self.cosine * sideways - self.sine * across
        return Moving(along + turned, self.speed * swept, -(self.speed**2) * turned)

    def turned(self, tensor: ca.SX) -> ca.SX:
        """Transform a symmetric tensor into ground axes, as constants times sine, cosine and their products."""
        p, q, k = self._shares
        still, level, cross = (
            p @ tensor @ p.T + q @ tensor @ q.T,
            k @ tensor @ k.T - q @ tensor @ q.T,
            k @ tensor @ q.T,
        )
        straight, sideways = p @ tensor @ q.T, p @ tensor @ k.T
        result = symmetric(still) + self.sine**2 * symmetric(level)
        result += self.cosine * symmetric(straight + straight.T) + self.sine * symmetric(
            sideways + sideways.T
        )
        return result + self.sine * self.cosine * symmetric(cross + cross.T)

    @property
    def ground_spin(self) -> ca.SX:
        """Return the angular velocity in ground axes, rad/s."""
        return self.spin

    def _parts(self, vector: ca.SX) -> tuple[ca.SX, ca.SX]:
        along = ca.dot(self.axis, vector) * self.axis
        return along, vector - along


def symmetric(matrix: ca.SX) -> ca.SX:
    """Return the matrix with its lower triangle copied from the upper one."""
    return ca.triu2symm(ca.triu(matrix))


def by_quaternion(e: ca.SX, spin: ca.SX) -> Orientation:
    """Return the orientation given by a quaternion relative to the ground and a spin in the frame's own axes."""
    return Orientation(quaternion_matrix(e), spin, _ZERO)


class Carrier:
    """Carrier of a frame's axes: here the ground, with fixed axes (for moving ones see module ``carrier``).

    Attributes
    ----------
    up : casadi.SX, shape (3,)
        The ground's z axis in the axes of the carrier.
    moves : bool
        Whether the axes move.
    """

    up = ca.SX([0.0, 0.0, 1.0])
    moves = False

    def place(self, place: ca.SX) -> ca.SX:
        """Return a position in ground axes, m."""
        return place

    def height(self, place: ca.SX) -> ca.SX:
        """Return the height of a position above z = 0 of the ground, m."""
        return place[2]

    def outward(self, vector: ca.SX) -> ca.SX:
        """Transform a vector into ground axes."""
        return vector

    def inward(self, vector: ca.SX) -> ca.SX:
        """Transform a vector from ground axes into these axes."""
        return vector

    def velocity(self, point: Moving) -> ca.SX:
        """Return the velocity of a point relative to the ground, m/s, in these axes."""
        return point.rate

    def spin(self, orientation: Orientation) -> ca.SX:
        """Return the angular velocity of an orientation relative to the ground, rad/s, in these axes."""
        return orientation.ground_spin


GROUND_AXES = Carrier()


@dataclass(frozen=True)
class Frame:
    """A rigid frame: design position and motion of its origin, its orientation, and the carrier of its axes."""

    design: ca.SX
    origin: Moving
    orientation: Orientation
    carrier: Carrier = GROUND_AXES

    def point(self, design: ca.SX) -> Moving:
        """Return the motion of the point at ``design`` in the design pose."""
        arm = self.orientation.moving(design - self.design)
        origin = self.origin
        return Moving(origin.value + arm.value, origin.rate + arm.rate, origin.bias + arm.bias)

    def direction(self, design: ca.SX) -> Moving:
        """Return the motion of the direction that is ``design`` in the design pose."""
        return self.orientation.moving(design)

    def at(self, design: ca.SX) -> Frame:
        """Return the same frame with its origin at ``design``."""
        return replace(self, design=design, origin=self.point(design))

    def translated(
        self, axis: ca.SX, distance: ca.SX, speed: ca.SX, acceleration: ca.SX | float = 0.0
    ) -> Frame:
        """Return a frame that slides along an axis of this one; ``acceleration`` is a prescribed acceleration."""
        along = self.orientation.moving(axis)
        origin = Moving(
            self.origin.value + along.value * distance,
            self.origin.rate + along.rate * distance + along.value * speed,
            self.origin.bias
            + along.bias * distance
            + 2.0 * along.rate * speed
            + along.value * acceleration,
        )
        return replace(self, origin=origin)

    def turned(self, axis: ca.SX, angle: ca.SX, speed: ca.SX) -> Frame:
        """Return a frame that rotates about an axis of this one through its origin."""
        parent = self.orientation
        if isinstance(parent, FixedOrientation):
            return self.oriented(AxisRotation(axis, angle, speed))
        turn = AxisRotation(axis, angle, speed)
        carried = turn.unrotate(parent.spin)
        spin = carried + axis * speed
        bias = turn.unrotate(parent.spin_bias) + ca.cross(carried, axis * speed)
        return self.oriented(Orientation(parent.matrix @ turn.matrix, spin, bias))

    def oriented(self, orientation: Orientation) -> Frame:
        """Return a frame with the same origin and a different orientation."""
        return replace(self, orientation=orientation)


GROUND = Frame(_ZERO, Moving(_ZERO, _ZERO, _ZERO), FixedOrientation())
