"""Rigid bodies: mass, centre of mass, inertia, and how they move."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from jounce.core.errors import AssemblyError
from jounce.mechanics.carrier import GROUND_AXES, Carrier
from jounce.mechanics.frames import Frame, Moving
from jounce.mechanics.rotations import skew


@dataclass(frozen=True)
class MassProperties:
    """Mass (kg), design place of its centre (m) and inertia about it in design axes (kg m^2, shape (3, 3))."""

    mass: ca.SX
    centre: ca.SX
    inertia: ca.SX


@dataclass(eq=False)
class Body:
    """A rigid body; its frame's origin is where its joint is.

    Attributes
    ----------
    name : str
        For messages and channels.
    mass_properties : MassProperties, optional
        None for a body that only carries points.
    frame : Frame, optional
        Set by the joint that hangs it into the tree.
    carrier : Carrier
        What the axes of the frame belong to, the ground or a body that moves; "ground axes" are its axes then.
    """

    name: str
    mass_properties: MassProperties | None = None
    frame: Frame | None = None
    carrier: Carrier = GROUND_AXES

    def point(self, design: ca.SX | Sequence[float]) -> Moving:
        """Follow the point of the body that lies at ``design`` (m) in the design pose."""
        return self._frame.point(as_vector(design))

    def direction(self, design: ca.SX | Sequence[float]) -> Moving:
        """Follow the direction of the body that is ``design`` (of any length, m) in the design pose."""
        return self._frame.direction(as_vector(design))

    @property
    def spin(self) -> ca.SX:
        """Angular velocity, rad/s, ground axes."""
        return self.carrier.spin(self._frame.orientation)

    @property
    def _frame(self) -> Frame:
        if self.frame is None:
            raise AssemblyError("the body hangs on nothing yet", where=self.name, hint="Give its joint first.")
        return self.frame


def as_vector(numbers: ca.SX | Sequence[float]) -> ca.SX:
    """Three numbers as an expression; an expression is taken as it is."""
    return numbers if isinstance(numbers, ca.SX) else ca.SX([float(part) for part in numbers])


class RigidMass:
    """Inertia of a rigid body, written about its frame's origin and in its own axes."""

    def __init__(self, frame: Frame, properties: MassProperties) -> None:
        self._frame, self._mass = frame, properties.mass
        arm = properties.centre - frame.design
        self._moment = self._mass * arm
        steiner = self._mass * (ca.dot(arm, arm) * ca.SX.eye(3) - arm @ arm.T)
        self._tensor = properties.inertia + steiner

    def matrix(self, v: ca.SX) -> ca.SX:
        """Mass matrix for the speeds ``v``."""
        orientation = self._frame.orientation
        linear = ca.jacobian(self._frame.origin.rate, v)
        angular = ca.jacobian(orientation.spin, v)
        swept = -skew(self._moment) @ angular
        turned = ca.horzcat(*(self._rotated(swept[:, i]) for i in range(swept.shape[1])))
        coupling = linear.T @ turned
        return self._mass * (linear.T @ linear) + coupling + coupling.T + angular.T @ (self._tensor @ angular)

    def bias(self, v: ca.SX) -> ca.SX:
        """Generalised inertial force that is left when no speed changes."""
        orientation, origin = self._frame.orientation, self._frame.origin
        linear = ca.jacobian(origin.rate, v)
        angular = ca.jacobian(orientation.spin, v)
        force = self._mass * origin.bias + orientation.moving(self._moment).bias
        spin = orientation.spin
        torque = (
            self._tensor @ orientation.spin_bias
            + ca.cross(spin, self._tensor @ spin)
            + ca.cross(self._moment, orientation.unrotate(origin.bias))
        )
        return linear.T @ force + angular.T @ torque

    def _rotated(self, column: ca.SX) -> ca.SX:
        return self._frame.orientation.rotate(column) if column.nnz() else column
