"""Moving frames: a mechanism on a moving body is formulated in that body's axes, as if the body were fixed.

Joints, loops and internal forces do not depend on the carrier's motion; only masses and external forces do. A point
at ``r`` with velocity ``u`` in the axes of a body with origin velocity ``v``, spin ``w`` and angular acceleration
``alpha`` has, in the same axes, velocity and acceleration

    v + w x r + u,    a + alpha x r + w x (w x r) + 2 w x u + du/dt.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import casadi as ca

from jounce.mechanics.equations import InertialTerms
from jounce.mechanics.frames import Carrier, Frame, Moving, Orientation, symmetric
from jounce.mechanics.rotations import skew


class MovingCarrier(Carrier):
    """Axes of a body that moves.

    Parameters
    ----------
    frame : Frame
        Frame of the body.
    field : casadi.SX, shape (3,)
        Uniform acceleration of all masses by gravity and the inertia of driving, m/s^2, ground axes.
    """

    moves = True

    def __init__(self, frame: Frame, field: ca.SX) -> None:
        turn = self._turn = frame.orientation
        self.turning_bias = turn.spin_bias
        self._design, self._origin, self.up = frame.design, frame.origin, turn.unrotate(Carrier.up)
        self.rate, self.turning, self._field = turn.unrotate(frame.origin.rate), turn.spin, field

    def arm(self, place: ca.SX) -> ca.SX:
        """Return a position relative to the origin of the axes, m."""
        return place - self._design

    def place(self, place: ca.SX) -> ca.SX:
        """Return a position in ground axes, m."""
        return self._origin.value + self.outward(self.arm(place))

    def height(self, place: ca.SX) -> ca.SX:
        """Return the height of a position above z = 0 of the ground, m."""
        return self._origin.value[2] + ca.dot(self.up, self.arm(place))

    def outward(self, vector: ca.SX) -> ca.SX:
        """Transform a vector into ground axes."""
        return self._turn.rotate(vector)

    def inward(self, vector: ca.SX) -> ca.SX:
        """Transform a vector from ground axes into these axes."""
        return self._turn.unrotate(vector)

    def velocity(self, point: Moving) -> ca.SX:
        """Return the velocity of a point relative to the ground, m/s, in these axes."""
        return self.rate + ca.cross(self.turning, self.arm(point.value)) + point.rate

    def spin(self, orientation: Orientation) -> ca.SX:
        """Return the angular velocity of an orientation relative to the ground, rad/s, in these axes."""
        return self.turning + orientation.ground_spin

    @cached_property
    def start(self) -> ca.SX:
        """Acceleration of the origin at constant speeds, minus the field, m/s^2, in these axes."""
        return self._turn.unrotate(self._origin.bias - self._field)

    def acceleration(self, point: Moving) -> ca.SX:
        """Return the acceleration of a point at constant speeds, minus the field, m/s^2, in these axes."""
        coriolis = ca.cross(2.0 * self.turning, point.rate)
        return self.start + self.steady @ self.arm(point.value) + coriolis + point.bias

    def spin_bias(self, orientation: Orientation) -> ca.SX:
        """Return the angular acceleration of an orientation at constant speeds, rad/s^2, in these axes."""
        seen = orientation.ground_spin
        return (
            self.turning_bias
            + ca.cross(self.turning, seen)
            + orientation.rotate(orientation.spin_bias)
        )

    @cached_property
    def steady(self) -> ca.SX:
        """Matrix that maps an arm to its acceleration at constant speeds, 1/s^2."""
        return skew(self.turning_bias) + skew(self.turning) @ skew(self.turning)

    def matrix(
        self, v: ca.SX, total: ca.SX, moment: ca.SX, tensor: ca.SX, push: ca.SX, twist: ca.SX
    ) -> ca.SX:
        """Return the mass matrix of the bodies in these axes by mass, first moment and inertia about the origin.

        ``push`` and ``twist`` are the linear and angular momenta per unit speed, in these axes about their origin.
        """
        linear, angular = ca.jacobian(self.rate, v), ca.jacobian(self.turning, v)
        swept = skew(moment)
        coupling = linear.T @ push + angular.T @ twist
        own = linear.T @ (total * linear - swept @ angular) + angular.T @ (
            swept @ linear + tensor @ angular
        )
        return coupling + coupling.T + own

    def force(self, v: ca.SX, push: ca.SX, twist: ca.SX) -> ca.SX:
        """Return the generalised force of a force (N) and a torque (N m) about the origin, in these axes."""
        linear, angular = ca.jacobian(self.rate, v), ca.jacobian(self.turning, v)
        return linear.T @ push + angular.T @ twist


@dataclass(frozen=True)
class Carried:
    """A rigid body in moving axes: mass (kg), its centre, orientation, and inertia about the centre (kg m^2)."""

    mass: ca.SX
    centre: Moving
    orientation: Orientation
    inertia: ca.SX
    alone: InertialTerms
    """Contribution to the mass matrix for fixed axes."""


class CarriedMasses:
    """Inertia of all bodies on one carrier, summed before the carrier's motion is included."""

    def __init__(self, carrier: MovingCarrier, masses: Sequence[Carried]) -> None:
        self._carrier, self._masses = carrier, masses
        self._arms = [carrier.arm(mass.centre.value) for mass in masses]
        self._tensors = [mass.orientation.turned(mass.inertia) for mass in masses]

    def matrix(self, v: ca.SX) -> ca.SX:
        """Return the mass matrix for the speeds ``v``."""
        size = v.shape[0]
        total, alone, moment, tensor = ca.SX(0.0), ca.SX(size, size), ca.SX(3, 1), ca.SX(3, 3)
        push, twist = ca.SX(3, size), ca.SX(3, size)  # momenta of the motions in these axes
        for mass, arm, turned in zip(self._masses, self._arms, self._tensors, strict=True):
            shift, turn = (
                ca.jacobian(mass.centre.rate, v),
                ca.jacobian(mass.orientation.ground_spin, v),
            )
            weighed = mass.mass * arm
            alone += mass.alone.matrix(v)
            push += mass.mass * shift
            twist += skew(weighed) @ shift + turned @ turn
            total, moment = total + mass.mass, moment + weighed
            outer = symmetric(weighed @ arm.T)
            tensor += turned + ca.trace(outer) * ca.SX.eye(3) - outer
        return alone + self._carrier.matrix(v, total, moment, tensor, push, twist)

    def bias(self, v: ca.SX) -> ca.SX:
        """Return the generalised inertial force at constant speeds, minus the force of the field."""
        carrier, result = self._carrier, ca.SX(v.shape[0], 1)
        push, twist = ca.SX(3, 1), ca.SX(3, 1)
        for mass, arm, tensor in zip(self._masses, self._arms, self._tensors, strict=True):
            force, torque = (
                mass.mass * carrier.acceleration(mass.centre),
                self._torque(mass, tensor),
            )
            result += (
                ca.jacobian(mass.centre.rate, v).T @ force
                + ca.jacobian(mass.orientation.ground_spin, v).T @ torque
            )
            push, twist = push + force, twist + ca.cross(arm, force) + torque
        return result + carrier.force(v, push, twist)

    def _torque(self, carried: Carried, tensor: ca.SX) -> ca.SX:
        """Return the rate of a body's angular momentum about its centre at constant speeds."""
        spin = self._carrier.spin(carried.orientation)
        return tensor @ self._carrier.spin_bias(carried.orientation) + ca.cross(spin, tensor @ spin)


class Shifting(NamedTuple):
    """A function of one coordinate: its value and its slope."""

    value: ca.SX
    slope: ca.SX


@dataclass(frozen=True)
class TravellingMasses:
    """Combined inertia, about the axes' origin, of all masses in moving axes that a single coordinate moves.

    Attributes
    ----------
    carrier : MovingCarrier
        The axes.
    rate : casadi.SX
        Rate of the coordinate, m/s.
    mass : casadi.SX
        kg.
    moment, momentum, angular_momentum : Shifting
        First moment (kg m); linear (kg) and angular momentum (kg m) at unit rate. ``momentum`` is the slope of
        ``moment``.
    tensor, inertia : Shifting
        Inertia (kg m^2, shape (3, 3)), and twice the energy at unit rate (kg).
    """

    carrier: MovingCarrier
    rate: ca.SX
    mass: ca.SX
    moment: Shifting
    momentum: Shifting
    angular_momentum: Shifting
    tensor: Shifting
    inertia: Shifting

    def matrix(self, v: ca.SX) -> ca.SX:
        """Return the mass matrix for the speeds ``v``."""
        along = ca.jacobian(self.rate, v)
        push, twist = self.momentum.value @ along, self.angular_momentum.value @ along
        carried = self.carrier.matrix(
            v, self.mass, self.moment.value, self.tensor.value, push, twist
        )
        return self.inertia.value * (along.T @ along) + carried

    def bias(self, v: ca.SX) -> ca.SX:
        """Return the generalised inertial force at constant speeds, minus the force of the field."""
        carrier, rate = self.carrier, self.rate
        start, turning, bent = carrier.start, carrier.turning, carrier.turning_bias
        moment, momentum, angular, tensor = (
            self.moment,
            self.momentum,
            self.angular_momentum,
            self.tensor,
        )
        push = self.mass * start + carrier.steady @ moment.value
        push += rate * (2.0 * ca.cross(turning, momentum.value) + rate * momentum.slope)
        spinning = tensor.value @ turning + rate * angular.value
        twist = ca.cross(moment.value, start) + tensor.value @ bent + ca.cross(turning, spinning)
        swung = tensor.slope @ turning
        twist += rate * (swung + rate * angular.slope)
        along = ca.dot(momentum.value, start) + ca.dot(angular.value, bent)
        along += 0.5 * (rate**2 * self.inertia.slope - ca.dot(turning, swung))
        return carrier.force(v, push, twist) + ca.jacobian(self.rate, v).T * along
