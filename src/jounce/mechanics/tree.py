"""Bodies on a tree of joints, and the joints that close loops.

Every place and direction is given where it lies in the design pose: x, y, z in metres in the ground's axes. The first
joint of a body hangs it into the tree; a joint between two bodies that hang already closes a loop.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np
from pydantic import BaseModel

from jounce.core.errors import AssemblyError
from jounce.mechanics.bodies import Body, MassProperties
from jounce.mechanics.closures import Closures
from jounce.mechanics.frames import GROUND, Frame, Moving, by_quaternion
from jounce.mechanics.reactions import Wrench
from jounce.mechanics.rotations import unit
from jounce.mechanics.system import System, Track
from jounce.parts.parameters import parameters_of

Vector = Sequence[float] | ca.SX
"""Three numbers, or three expressions of parameters."""
_NONE = ca.SX(3, 1)


@dataclass(frozen=True)
class TreeJoint:
    """The joint that hangs ``child`` on ``parent``; ``reversed`` where the user named the child first."""

    name: str
    kind: str
    parent: Body
    child: Body
    axis: ca.SX | None = None
    reversed: bool = False


class Tree(System):
    """Bodies, joints and loops of a mechanism."""

    def __init__(self) -> None:
        super().__init__()
        self.ground = Body("ground", frame=GROUND)
        self.values: dict[str, float] = {}
        self._bodies: dict[str, Body] = {"ground": self.ground}
        self._joints: dict[str, TreeJoint] = {}
        self._wrenches: list[Wrench] = []
        self._closures = Closures(self)

    def number(self, path: str, value: float | ca.SX) -> ca.SX:
        """Give the parameter at ``path`` with a value of its own; an expression is taken as it is."""
        if isinstance(value, ca.SX):
            return value
        self.values[path] = float(value)
        return self.parameter(path)

    def vector(self, path: str, value: Vector) -> ca.SX:
        """Give three parameters ``path[0]`` to ``path[2]`` with values of their own."""
        if isinstance(value, ca.SX):
            return value
        return ca.vertcat(*(self.number(f"{path}[{i}]", float(part)) for i, part in enumerate(value)))

    def take(self, path: str, part: BaseModel) -> None:
        """Take the numbers of a part's description as parameters under ``path``, for the force laws of ``elements``."""
        self.values.update(parameters_of(part, f"{path}."))

    def body(
        self,
        name: str,
        mass: float | ca.SX | None = None,
        centre_of_mass: Vector | None = None,
        inertia: Sequence[float] | ca.SX | None = None,
    ) -> Body:
        """Add a rigid body.

        Parameters
        ----------
        name : str
            Its name.
        mass : float, optional
            kg; without one the body only carries points, and must be held by bodies with mass.
        centre_of_mass : sequence of float, shape (3,), optional
            m, in the design pose.
        inertia : sequence of float, shape (3,) or (6,), optional
            xx, yy, zz (, xy, xz, yz) of the tensor about the centre of mass in design axes, kg m^2. A matrix (3, 3)
            of expressions is taken as it is. A point mass without it.

        Returns
        -------
        Body
            For joints, points and forces.
        """
        self._refuse_twice(name, self._bodies)
        body = Body(name)
        if mass is not None:
            if centre_of_mass is None:
                raise AssemblyError("a mass without its place", where=name, hint="Give centre_of_mass.")
            body.mass_properties = MassProperties(
                self.number(f"{name}.mass", mass),
                self.vector(f"{name}.centre_of_mass", centre_of_mass),
                self._tensor(f"{name}.inertia", inertia),
            )
        self._bodies[name] = body
        return body

    def _tensor(self, path: str, inertia: Sequence[float] | ca.SX | None) -> ca.SX:
        if inertia is None:
            return ca.SX(3, 3)
        if isinstance(inertia, ca.SX):
            return inertia
        elements = [*inertia, *([0.0] * (6 - len(inertia)))]
        names = ("xx", "yy", "zz", "xy", "xz", "yz")
        xx, yy, zz, xy, xz, yz = (
            self.number(f"{path}.{name}", value) for name, value in zip(names, elements, strict=True)
        )
        return ca.vertcat(ca.horzcat(xx, xy, xz), ca.horzcat(xy, yy, yz), ca.horzcat(xz, yz, zz))

    def fixed(self, name: str, parent: Body, child: Body) -> None:
        """Weld two bodies together."""
        if self._closes(parent, child):
            raise AssemblyError("both bodies hang already", where=name, hint="Make them one body.")
        parent, child = self._ordered(name, parent, child)
        self._hang(name, "fixed", parent, child, self._frame_of(parent).at(self._frame_of(parent).design))

    def prismatic(self, name: str, parent: Body, child: Body, axis: Vector, at: Vector = _NONE) -> ca.SX:
        """Let a body slide along an axis; give the distance (m), positive where the child moves along ``axis``."""
        place, along = self._place(name, at, axis)
        if self._closes(parent, child):
            return self._closures.prismatic(name, parent, child, place, along)
        parent, child, sign = self._signed(name, parent, child)
        q, v = self.coordinates([f"{name}.distance"], [f"{name}.distance rate"])
        frame = self._frame_of(parent).at(place).slid(sign * along, q, v)
        self._hang(name, "prismatic", parent, child, frame, sign * along, sign)
        return q

    def revolute(self, name: str, parent: Body, child: Body, at: Vector, axis: Vector) -> ca.SX:
        """Let a body turn about an axis; give the angle (rad), right-handed about ``axis`` from parent to child."""
        place, along = self._place(name, at, axis)
        if self._closes(parent, child):
            return self._closures.revolute(name, parent, child, place, along)
        parent, child, sign = self._signed(name, parent, child)
        q, v = self.coordinates([f"{name}.angle"], [f"{name}.angle rate"])
        frame = self._frame_of(parent).at(place).turned(sign * along, q, v)
        self._hang(name, "revolute", parent, child, frame, sign * along, sign)
        return q

    def cylindrical(self, name: str, parent: Body, child: Body, at: Vector, axis: Vector) -> ca.SX:
        """Let a body slide along an axis and turn about it; give distance (m) and angle (rad)."""
        place, along = self._place(name, at, axis)
        if self._closes(parent, child):
            return self._closures.cylindrical(name, parent, child, place, along)
        parent, child, sign = self._signed(name, parent, child)
        names = [f"{name}.distance", f"{name}.angle"]
        q, v = self.coordinates(names, [f"{text} rate" for text in names])
        frame = self._frame_of(parent).at(place).slid(sign * along, q[0], v[0]).turned(sign * along, q[1], v[1])
        self._hang(name, "cylindrical", parent, child, frame, sign * along, sign)
        return q

    def universal(self, name: str, parent: Body, child: Body, at: Vector, axis: Vector, second_axis: Vector) -> ca.SX:
        """Cross of two axes at right angles, one on each body; give the angles about them (rad)."""
        place, along = self._place(name, at, axis)
        second = unit(self.vector(f"{name}.second_axis", second_axis))
        if self._closes(parent, child):
            return self._closures.universal(name, parent, child, place, along, second)
        ordered, child = self._ordered(name, parent, child)
        if ordered is not parent:
            along, second = second, along
        names = [f"{name}.angle", f"{name}.second_angle"]
        q, v = self.coordinates(names, [f"{text} rate" for text in names])
        frame = self._frame_of(ordered).at(place).turned(along, q[0], v[0]).turned(second, q[1], v[1])
        self._hang(name, "universal", ordered, child, frame, sign=1.0 if ordered is parent else -1.0)
        return q

    def spherical(self, name: str, parent: Body, child: Body, at: Vector) -> ca.SX:
        """Let a body turn about a point; give the quaternion of its orientation against the ground."""
        place = self.vector(f"{name}.at", at)
        if self._closes(parent, child):
            return self._closures.coincident(name, parent, child, place, place)
        parent, child, sign = self._signed(name, parent, child)
        e, w = self.quaternion(name)
        frame = self._frame_of(parent).at(place).oriented(by_quaternion(e, w))
        self._hang(name, "spherical", parent, child, frame, sign=sign)
        return e

    def free(self, name: str, child: Body, at: Vector | None = None) -> ca.SX:
        """Let a body fly: place (m, ground axes, from the design pose) and quaternion against the ground."""
        if child.mass_properties is None and at is None:
            raise AssemblyError("a free body without mass", where=child.name, hint="Give mass and centre_of_mass.")
        centre = child.mass_properties.centre if child.mass_properties is not None else _NONE
        place = centre if at is None else self.vector(f"{name}.at", at)
        names = [f"{name}.{axis}" for axis in "xyz"]
        r, v = self.coordinates(names, [f"{text} rate" for text in names])
        e, w = self.quaternion(name)
        frame = Frame(place, Moving(place + r, v, ca.SX(3, 1)), by_quaternion(e, w))
        self._hang(name, "free", self.ground, child, frame)
        return ca.vertcat(r, e)

    def driven(self, name: str, parent: Body, child: Body, axis: Vector, travel: Track | ca.SX) -> None:
        """Let a body slide along an axis by a prescribed travel (m): a track, or a parameter."""
        along = unit(self.vector(f"{name}.axis", axis))
        track = travel if isinstance(travel, Track) else Track(travel, ca.SX(0.0), ca.SX(0.0))
        frame = self._frame_of(parent).slid(along, track.value, track.rate, track.acceleration)
        self._hang(name, "driven", parent, child, frame)

    def coincident(self, name: str, first: Body, second: Body, at: Vector, second_at: Vector | None = None) -> ca.SX:
        """Keep a point of one body on a point of another; give the force on the second (N, ground axes)."""
        place = self.vector(f"{name}.at", at)
        other = place if second_at is None else self.vector(f"{name}.second_at", second_at)
        return self._closures.coincident(name, first, second, place, other)

    def rod(
        self, name: str, first: Body, second: Body, at: Vector, second_at: Vector, length: float | ca.SX | None = None
    ) -> ca.SX:
        """Keep two points at a distance (m, by default as designed); give the rod's force (N, tension positive)."""
        ends = self.vector(f"{name}.at", at), self.vector(f"{name}.second_at", second_at)
        wanted = None if length is None else self.number(f"{name}.length", length)
        return self._closures.rod(name, first, second, *ends, wanted)

    def point_on_line(self, name: str, first: Body, second: Body, at: Vector, axis: Vector, point: Vector) -> ca.SX:
        """Keep a point of the second body on a line of the first; give the two forces across the line (N)."""
        place, along = self._place(name, at, axis)
        return self._closures.point_on_line(name, first, second, place, along, self.vector(f"{name}.point", point))

    def perpendicular(self, name: str, first: Body, second: Body, axis: Vector, second_axis: Vector) -> ca.SX:
        """Keep two directions at right angles; give the torque that does it (N m)."""
        one = unit(self.vector(f"{name}.axis", axis))
        return self._closures.perpendicular(
            name, first, second, one, unit(self.vector(f"{name}.second_axis", second_axis))
        )

    def parallel(self, name: str, first: Body, second: Body, axis: Vector) -> ca.SX:
        """Keep a direction of two bodies parallel; give the two torques that do it (N m)."""
        return self._closures.parallel(name, first, second, unit(self.vector(f"{name}.axis", axis)))

    def coupler(self, name: str, expression: ca.SX) -> ca.SX:
        """Keep a linear combination of coordinates at zero, such as ``rack - radius * pinion``; give its force."""
        return self.condition(name, expression)

    def motion(self, name: str, coordinate: ca.SX, track: Track) -> ca.SX:
        """Drive a coordinate (m or rad) along a prescribed input; give the force or torque that it takes."""
        return self.condition(name, coordinate - track.value)

    def condition(self, name: str, expression: ca.SX) -> ca.SX:
        """Keep any expression of coordinates and tracks at zero; give its multiplier."""
        rate = self.rate_of(expression)
        return self.constrain([name], expression, rate, self._bias_of(rate))

    def note(
        self, body: Body, force: ca.SX = _NONE, point: ca.SX = _NONE, torque: ca.SX = _NONE, source: str = ""
    ) -> None:
        """Note what acts on a body, for the reactions of its joint; the equations of motion have it already."""
        self._wrenches.append(Wrench(body, force, point, torque, source))

    def _closes(self, first: Body, second: Body) -> bool:
        return first.frame is not None and second.frame is not None

    def _ordered(self, name: str, first: Body, second: Body) -> tuple[Body, Body]:
        """Parent and child: the one that hangs already comes first."""
        if first.frame is None and second.frame is None:
            raise AssemblyError(
                "neither body hangs on anything yet",
                where=name,
                found=f"{first.name}, {second.name}",
                hint="Give the joints in an order that starts at the ground.",
            )
        return (first, second) if first.frame is not None else (second, first)

    def _signed(self, name: str, first: Body, second: Body) -> tuple[Body, Body, float]:
        parent, child = self._ordered(name, first, second)
        return parent, child, 1.0 if parent is first else -1.0

    def _hang(
        self,
        name: str,
        kind: str,
        parent: Body,
        child: Body,
        frame: Frame,
        axis: ca.SX | None = None,
        sign: float = 1.0,
    ) -> None:
        self._refuse_twice(name, self._joints)
        child.frame = frame
        self._joints[name] = TreeJoint(name, kind, parent, child, axis, sign < 0.0)

    def _place(self, name: str, at: Vector, axis: Vector) -> tuple[ca.SX, ca.SX]:
        if not isinstance(axis, ca.SX) and not np.any(np.asarray(axis, dtype=float)):
            raise AssemblyError("an axis without direction", where=name, found=tuple(axis))
        return self.vector(f"{name}.at", at), unit(self.vector(f"{name}.axis", axis))

    @staticmethod
    def _frame_of(body: Body) -> Frame:
        assert body.frame is not None
        return body.frame
