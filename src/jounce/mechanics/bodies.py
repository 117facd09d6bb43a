"""Rigid bodies: their mass, their frames as determined by the joints, and their points for use in expressions.

:meth:`Body.point` returns *symbols* for the position of a point, and the mechanism records the body to which they
belong. A force along an expression of such points can therefore be divided among the bodies: the force on each point is
the derivative of the expression with respect to that point. Before equations are formed, the symbols are replaced by
their expressions in the joint coordinates.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import AssemblyError
from jounce.core.units import to_si
from jounce.mechanics.equations import Collection
from jounce.mechanics.expressions import vector_of
from jounce.mechanics.frames import GROUND, Carrier, Frame, Moving
from jounce.mechanics.rotations import skew


@dataclass(frozen=True)
class MassProperties:
    """Mass (kg), design position of its centre (m) and inertia about it in design axes (kg m^2, shape (3, 3))."""

    mass: ca.SX
    centre: ca.SX
    inertia: ca.SX


@dataclass(frozen=True)
class Named:
    """A point or direction of a body for use in expressions, with its symbols."""

    body: Body
    design: ca.SX
    symbol: ca.SX
    value: ca.SX
    is_point: bool


@dataclass(frozen=True)
class BodyPoint(Moving):
    """A point of a body, at ``design`` (m) in the design pose."""

    body: Body
    design: ca.SX


@dataclass
class BodyFrames:
    """Frames of a mechanism's bodies by name, and their points and directions used in expressions."""

    collection: Collection
    frames: dict[str, Frame] = field(default_factory=lambda: {"ground": GROUND})
    named: dict[int, tuple[Named, int]] = field(default_factory=dict)

    def require_still(self, expression: ca.SX, where: str) -> ca.SX:
        """Refuse an expression given for a number if it depends on anything but parameters, such as a coordinate."""
        constants = (symbol for symbol, _ in self.collection.constants.values())
        parameters = [*self.collection.parameters.values(), *constants]
        known = {symbol.element_hash() for symbol in parameters}
        moving = [
            symbol.name() for symbol in ca.symvar(expression) if symbol.element_hash() not in known
        ]
        if moving:
            symbols, allowed = (
                f"an expression of {', '.join(moving)}",
                "numbers, and expressions of this mechanism's parameters",
            )
            hint = (
                "A position in the design pose cannot describe a moving point: give the moving part a "
                "body and a joint."
            )
            raise AssemblyError(
                "not a number", where=where, found=symbols, allowed=allowed, hint=hint
            )
        return expression

    def name(self, body: Body, design: ca.SX, moving: Moving, *, is_point: bool) -> Moving:
        """Return a point or direction with symbols; return it unchanged if it is fixed or in a moving frame."""
        if body.frame is GROUND or body.carrier.moves:
            return moving
        symbol = ca.SX.sym(f"{body.name} {'point' if is_point else 'direction'}", 3)
        named = Named(body, design, symbol, ca.densify(moving.value), is_point)
        self.named.update(
            {part.element_hash(): (named, i) for i, part in enumerate(ca.vertsplit(symbol))}
        )
        return replace(moving, value=symbol)

    def occurring(self, expression: ca.SX) -> list[Named]:
        """Return the points and directions that occur in an expression."""
        result = [self.named.get(symbol.element_hash()) for symbol in ca.symvar(expression)]
        return list({id(entry[0]): entry[0] for entry in result if entry is not None}.values())

    def resolve(self, expression: ca.SX) -> ca.SX:
        """Replace all named points and directions in an expression by their formulas from the joints."""
        named = self.occurring(expression)
        if not named:
            return expression
        symbols, values = ([getattr(item, part) for item in named] for part in ("symbol", "value"))
        return ca.substitute(expression, ca.vertcat(*symbols), ca.vertcat(*values))


@dataclass(frozen=True, eq=False)
class Body:
    """A rigid body of a mechanism.

    Attributes
    ----------
    name : str
        Name used in messages and channels.
    poses : BodyFrames
        Frames of the bodies of its mechanism.
    mass_properties : MassProperties, optional
        None for a body that only carries points.
    axes_of : Body, optional
        The body whose moving axes this object represents; None for a real body.
    """

    name: str
    poses: BodyFrames = field(repr=False)
    mass_properties: MassProperties | None = None
    axes_of: Body | None = None

    @property
    def is_placed(self) -> bool:
        """Whether a joint connects it to another body."""
        return self.name in self.poses.frames

    @property
    def itself(self) -> Body:
        """The body itself; for moving axes, the body with which they move."""
        return self.axes_of or self

    @property
    def frame(self) -> Frame:
        """Frame of the body, with the origin at its joint."""
        if not self.is_placed:
            raise AssemblyError(
                "the body has no joint yet",
                where=self.name,
                hint="Give the joint of this body first.",
            )
        return self.poses.frames[self.name]

    @property
    def carrier(self) -> Carrier:
        """Carrier of the body's axes: the ground, or a moving body whose axes then replace the ground axes."""
        return self.frame.carrier

    def point(self, design: ca.SX | Sequence[float | str]) -> BodyPoint:
        """Return the point of the body at ``design`` (m, or text with a unit) in the design pose.

        Use its ``value`` in expressions passed to a mechanism, which identifies the body from it. To differentiate such
        an expression, use ``rate_of``. The design position may depend on numbers and parameters only; a point that
        slides along a body does not belong to it.
        """
        where = f"point of {self.name}"
        place = self.poses.require_still(vector_of(design, where), where)
        named = self.poses.name(self, place, self.frame.point(place), is_point=True)
        return BodyPoint(named.value, named.rate, named.bias, self, place)

    def direction(self, design: ca.SX | Sequence[float | str]) -> Moving:
        """Return the direction of the body that is ``design`` (of any length, m) in the design pose; see ``point``."""
        where = f"direction of {self.name}"
        along = self.poses.require_still(vector_of(design, where), where)
        return self.poses.name(self, along, self.frame.direction(along), is_point=False)

    @property
    def spin(self) -> ca.SX:
        """Angular velocity, rad/s, ground axes."""
        return self.carrier.spin(self.frame.orientation)


def tensor_elements(
    path: str, inertia: Sequence[float | str] | NDArray[np.float64]
) -> list[float | str]:
    """Return the elements xx, yy, zz, xy, xz, yz of a tensor given by three or six elements or as a matrix."""
    elements = np.asarray(inertia, dtype=object)
    if elements.shape == (3, 3):
        tensor = np.array([[to_si(part, "kg*m^2", where=path) for part in row] for row in elements])
        if not np.allclose(tensor, tensor.T, rtol=1e-9, atol=1e-12 * float(np.max(np.abs(tensor)))):
            raise AssemblyError("invalid inertia tensor", where=path, found="not symmetric")
        elements = np.array(
            [tensor[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
        )
    if elements.shape not in ((3,), (6,)):
        count, allowed = (
            f"{elements.size} numbers",
            "xx, yy, zz, optionally xy, xz, yz, or a symmetric (3, 3) tensor",
        )
        raise AssemblyError("invalid inertia tensor", where=path, found=count, allowed=allowed)
    return [*elements, *[0.0] * (6 - len(elements))]


class RigidMass:
    """Inertia of a rigid body about its frame's origin, in its own axes."""

    def __init__(self, frame: Frame, properties: MassProperties) -> None:
        self._frame, self._mass = frame, properties.mass
        arm = properties.centre - frame.design
        self._moment = self._mass * arm
        steiner = self._mass * (ca.dot(arm, arm) * ca.SX.eye(3) - arm @ arm.T)
        self._tensor = properties.inertia + steiner

    def matrix(self, v: ca.SX) -> ca.SX:
        """Return the mass matrix for the speeds ``v``."""
        rotate = self._frame.orientation.rotate
        linear = ca.jacobian(self._frame.origin.rate, v)
        angular = ca.jacobian(self._frame.orientation.spin, v)
        swept = ca.horzsplit(-skew(self._moment) @ angular)
        turned = ca.horzcat(*(rotate(column) if column.nnz() else column for column in swept))
        coupling = linear.T @ turned
        return (
            self._mass * (linear.T @ linear)
            + coupling
            + coupling.T
            + angular.T @ (self._tensor @ angular)
        )

    def bias(self, v: ca.SX) -> ca.SX:
        """Return the generalised inertial force at constant speeds."""
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
