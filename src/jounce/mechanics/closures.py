"""Loop closures: the equations that a joint between two bodies of the tree adds, and the forces they stand for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import casadi as ca

from jounce.mechanics.bodies import Body
from jounce.mechanics.frames import Moving
from jounce.mechanics.rotations import normals

if TYPE_CHECKING:
    from jounce.mechanics.tree import Tree

_AXES = ("x", "y", "z")


@dataclass(frozen=True)
class Dot:
    """A scalar product of two moving vectors, with its rate and bias."""

    value: ca.SX
    rate: ca.SX
    bias: ca.SX

    @classmethod
    def of(cls, a: Moving, b: Moving) -> Dot:
        """Form the product."""
        return cls(
            ca.dot(a.value, b.value),
            ca.dot(a.rate, b.value) + ca.dot(a.value, b.rate),
            ca.dot(a.bias, b.value) + 2.0 * ca.dot(a.rate, b.rate) + ca.dot(a.value, b.bias),
        )


class Closures:
    """Writes the equations of closures into a mechanism, with the wrenches that their multipliers are."""

    def __init__(self, tree: Tree) -> None:
        self._tree = tree

    def coincident(self, name: str, first: Body, second: Body, at: ca.SX, second_at: ca.SX) -> ca.SX:
        """Two points in one place; the multipliers are the force on the second body."""
        one, other = first.point(at), second.point(second_at)
        gap = other - one
        names = [f"{name}.{axis}" for axis in _AXES]
        force = self._tree.constrain(names, gap.value, gap.rate, gap.bias)
        self._pull(name, first, second, one, other, force)
        return force

    def rod(self, name: str, first: Body, second: Body, at: ca.SX, second_at: ca.SX, length: ca.SX | None) -> ca.SX:
        """Two points at a distance; the multiplier is the rod's force over its length, compression positive."""
        one, other = first.point(at), second.point(second_at)
        reach = other - one
        design = second_at - at
        squared = ca.dot(design, design) if length is None else length**2
        product = Dot.of(reach, reach)
        density = self._tree.constrain([name], 0.5 * (product.value - squared), 0.5 * product.rate, 0.5 * product.bias)
        self._pull(name, first, second, one, other, density * reach.value)
        return -density * ca.sqrt(squared)

    def point_on_line(self, name: str, first: Body, second: Body, at: ca.SX, axis: ca.SX, point: ca.SX) -> ca.SX:
        """A point of the second body on a line of the first."""
        start, other = first.point(at), second.point(point)
        across = [first.direction(normal) for normal in normals(axis)]
        rows = [Dot.of(normal, other - start) for normal in across]
        forces = self._rows([f"{name}.across", f"{name}.across_2"], rows)
        force = forces[0] * across[0].value + forces[1] * across[1].value
        self._pull(name, first, second, other, other, force)
        return forces

    def perpendicular(self, name: str, first: Body, second: Body, axis: ca.SX, second_axis: ca.SX) -> ca.SX:
        """Two directions at right angles."""
        return self._square(name, first, second, first.direction(axis), second.direction(second_axis))

    def parallel(self, name: str, first: Body, second: Body, axis: ca.SX) -> ca.SX:
        """A direction of both bodies in parallel."""
        other = second.direction(axis)
        torques = [
            self._square(f"{name}.{tag}", first, second, first.direction(normal), other)
            for tag, normal in zip(("tilt", "tilt_2"), normals(axis), strict=True)
        ]
        return ca.vertcat(*torques)

    def revolute(self, name: str, first: Body, second: Body, at: ca.SX, axis: ca.SX) -> ca.SX:
        """Closes a loop by a hinge: force on the second body, then the torques across the axis."""
        return ca.vertcat(self.coincident(name, first, second, at, at), self.parallel(name, first, second, axis))

    def universal(self, name: str, first: Body, second: Body, at: ca.SX, axis: ca.SX, second_axis: ca.SX) -> ca.SX:
        """Closes a loop by a universal joint."""
        force = self.coincident(name, first, second, at, at)
        return ca.vertcat(force, self.perpendicular(f"{name}.cross", first, second, axis, second_axis))

    def cylindrical(self, name: str, first: Body, second: Body, at: ca.SX, axis: ca.SX) -> ca.SX:
        """Closes a loop by a sleeve that slides and turns."""
        forces = self.point_on_line(name, first, second, at, axis, at)
        return ca.vertcat(forces, self.parallel(name, first, second, axis))

    def prismatic(self, name: str, first: Body, second: Body, at: ca.SX, axis: ca.SX) -> ca.SX:
        """Closes a loop by a guide that only slides."""
        normal, other = normals(axis)
        forces = self.cylindrical(name, first, second, at, axis)
        twist = self._square(f"{name}.twist", first, second, first.direction(normal), second.direction(other))
        return ca.vertcat(forces, twist)

    def _square(self, name: str, first: Body, second: Body, one: Moving, other: Moving) -> ca.SX:
        torque = self._rows([name], [Dot.of(one, other)])
        self._twist(name, first, second, torque * ca.cross(other.value, one.value))
        return torque

    def _rows(self, names: list[str], rows: list[Dot]) -> ca.SX:
        columns = zip(*((row.value, row.rate, row.bias) for row in rows), strict=True)
        return self._tree.constrain(names, *(ca.vertcat(*column) for column in columns))

    def _pull(self, name: str, first: Body, second: Body, one: Moving, other: Moving, force: ca.SX) -> None:
        """Note the constraint force on the second body and its opposite on the first."""
        self._tree.note(second, force, other.value, source=name)
        self._tree.note(first, -force, one.value, source=name)

    def _twist(self, name: str, first: Body, second: Body, torque: ca.SX) -> None:
        self._tree.note(second, torque=torque, source=name)
        self._tree.note(first, torque=-torque, source=name)
