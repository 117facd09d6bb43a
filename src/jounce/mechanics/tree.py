"""Bodies on a tree of joints, and the joints that close loops.

Every place and direction is given where it lies in the design pose: x, y, z in metres in the ground's axes. The first
joint of a body hangs it into the tree; a joint between two bodies that hang already closes a loop.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import AssemblyError
from jounce.core.units import to_si
from jounce.mechanics.bodies import Body, MassProperties
from jounce.mechanics.carrier import MovingCarrier
from jounce.mechanics.closures import Closures
from jounce.mechanics.frames import GROUND, Frame, Moving, by_quaternion
from jounce.mechanics.reactions import Wrench
from jounce.mechanics.rotations import unit
from jounce.mechanics.system import System, Track

Number = float | str | ca.SX
"""A number in SI, text with a unit, or an expression of parameters."""
Vector = Sequence[float | str] | ca.SX
"""Three numbers in SI or texts with a unit, or three expressions of parameters."""
_NONE = ca.SX(3, 1)
_SQUARE = 1e-3  # cosine of the axes of a universal joint that still counts as a right angle


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
        self.units: dict[str, str] = {}
        self._bodies: dict[str, Body] = {"ground": self.ground}
        self._joints: dict[str, TreeJoint] = {}
        self._wrenches: list[Wrench] = []
        self._closures = Closures(self)

    def number(self, path: str, value: Number, unit: str = "1") -> ca.SX:
        """Give the parameter at ``path`` with a value of its own (SI ``unit``); an expression is taken as it is."""
        if isinstance(value, ca.SX):
            return value
        if path in self.values:
            hint = "Give every joint, force and watched point a name of its own."
            raise AssemblyError("the name is used twice", where=path, hint=hint)
        self.units[path] = unit
        self.values[path] = to_si(value, unit, where=path)
        return self.parameter(path)

    def vector(self, path: str, value: Vector, unit: str = "m") -> ca.SX:
        """Give three parameters ``path[0]`` to ``path[2]`` with values of their own (SI ``unit``)."""
        shape = value.shape if isinstance(value, ca.SX) else (np.size(np.asarray(value, dtype=object)), 1)
        if shape != (3, 1):
            raise AssemblyError("not a vector", where=path, found=f"{shape[0]} numbers", allowed="three: x, y, z")
        if isinstance(value, ca.SX):
            return value
        return ca.vertcat(*(self.number(f"{path}[{i}]", part, unit) for i, part in enumerate(value)))

    def direction(self, path: str, value: Vector) -> ca.SX:
        """Give the unit vector along three numbers."""
        if not isinstance(value, ca.SX):
            found = [to_si(part, "1", where=path) for part in value]
            if not any(found):
                raise AssemblyError("an axis without direction", where=path, found=tuple(found), allowed="not all zero")
        return unit(self.vector(path, value, "1"))

    def body(
        self,
        name: str,
        mass: Number | None = None,
        centre_of_mass: Vector | None = None,
        inertia: Sequence[float | str] | NDArray[np.float64] | ca.SX | None = None,
    ) -> Body:
        """Add a rigid body.

        Parameters
        ----------
        name : str
            Its name.
        mass : float, optional
            kg; without one the body only carries points, and must be welded to bodies with mass or moved by a track.
        centre_of_mass : sequence of float, shape (3,), optional
            m, in the design pose.
        inertia : sequence of float, shape (3,), (6,) or (3, 3), optional
            xx, yy, zz (, xy, xz, yz) of the tensor about the centre of mass in design axes, kg m^2, or the tensor. A
            point mass without it.

        Returns
        -------
        Body
            For joints, points and forces.
        """
        self._refuse_twice(self.placed(name), self._bodies)
        body = Body(self.placed(name))
        if mass is not None:
            if centre_of_mass is None:
                raise AssemblyError("a mass without its place", where=name, hint="Give centre_of_mass.")
            body.mass_properties = MassProperties(
                self.number(f"{name}.mass", mass, "kg"),
                self.vector(f"{name}.centre_of_mass", centre_of_mass),
                self._tensor(f"{name}.inertia", inertia),
            )
        elif inertia is not None or centre_of_mass is not None:
            raise AssemblyError("a centre of mass or an inertia without a mass", where=name, hint="Give mass.")
        self._bodies[body.name] = body
        return body

    def moving_frame(self, body: Body, field: ca.SX) -> Body:
        """Give moving axes on a body, for a mechanism that hangs on it: cheaper than joints to the body itself.

        Parameters
        ----------
        body : Body
            A body with a joint.
        field : casadi.SX, shape (3,)
            Acceleration that acts on all that hangs there, m/s^2, ground axes: gravity, inertia of driving.

        Returns
        -------
        Body
            It moves with the body; joints to it and between what hangs on it do not see that motion.
        """
        self._held("moving frame", body)
        name = f"{body.name} axes"
        self._refuse_twice(name, self._bodies)
        self._bodies[name] = Body(name, frame=GROUND, carrier=MovingCarrier(self._frame_of(body), field))
        return self._bodies[name]

    def _tensor(self, path: str, inertia: Sequence[float | str] | NDArray[np.float64] | ca.SX | None) -> ca.SX:
        if inertia is None:
            return ca.SX(3, 3)
        if isinstance(inertia, ca.SX):
            return inertia
        elements = list(inertia)
        if np.shape(np.asarray(inertia, dtype=object)) == (3, 3):
            tensor = np.asarray(inertia, dtype=float)
            if not np.allclose(tensor, tensor.T, rtol=1e-9, atol=1e-12 * float(np.max(np.abs(tensor)))):
                raise AssemblyError("not a tensor of inertia", where=path, found="not symmetric")
            elements = [tensor[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
        if len(elements) not in (3, 6):
            found, allowed = f"{len(elements)} numbers", "xx, yy, zz, or also xy, xz, yz, or a symmetric (3, 3) tensor"
            raise AssemblyError("not a tensor of inertia", where=path, found=found, allowed=allowed)
        elements += [0.0] * (6 - len(elements))
        names = ("xx", "yy", "zz", "xy", "xz", "yz")
        xx, yy, zz, xy, xz, yz = (
            self.number(f"{path}.{name}", value, "kg*m^2") for name, value in zip(names, elements, strict=True)
        )
        return ca.vertcat(ca.horzcat(xx, xy, xz), ca.horzcat(xy, yy, yz), ca.horzcat(xz, yz, zz))

    def fixed(self, name: str, parent: Body, child: Body) -> None:
        """Weld two bodies together."""
        if self._closes(name, parent, child):
            raise AssemblyError("both bodies hang already", where=name, hint="Make them one body.")
        parent, child = self._ordered(name, parent, child)
        self._hang(name, "fixed", parent, child, self._frame_of(parent).at(self._frame_of(parent).design))

    def prismatic(self, name: str, parent: Body, child: Body, axis: Vector, at: Vector = _NONE) -> ca.SX:
        """Let a body slide along an axis; give the distance (m), positive where the child moves along ``axis``."""
        place, along = self._place(name, at, axis)
        if self._closes(name, parent, child):
            return self._closures.prismatic(name, parent, child, place, along)
        parent, child, sign = self._signed(name, parent, child)
        q, v = self.coordinates([f"{name}.distance"], [f"{name}.distance rate"])
        frame = self._frame_of(parent).at(place).translated(sign * along, q, v)
        self._hang(name, "prismatic", parent, child, frame, sign * along, sign)
        return q

    def revolute(self, name: str, parent: Body, child: Body, at: Vector, axis: Vector) -> ca.SX:
        """Let a body turn about an axis; give the angle (rad), right-handed about ``axis`` from parent to child."""
        place, along = self._place(name, at, axis)
        if self._closes(name, parent, child):
            return self._closures.revolute(name, parent, child, place, along)
        parent, child, sign = self._signed(name, parent, child)
        q, v = self.coordinates([f"{name}.angle"], [f"{name}.angle rate"])
        frame = self._frame_of(parent).at(place).turned(sign * along, q, v)
        self._hang(name, "revolute", parent, child, frame, sign * along, sign)
        return q

    def cylindrical(self, name: str, parent: Body, child: Body, at: Vector, axis: Vector) -> ca.SX:
        """Let a body slide along an axis and turn about it; give distance (m) and angle (rad)."""
        place, along = self._place(name, at, axis)
        if self._closes(name, parent, child):
            return self._closures.cylindrical(name, parent, child, place, along)
        parent, child, sign = self._signed(name, parent, child)
        names = [f"{name}.distance", f"{name}.angle"]
        q, v = self.coordinates(names, [f"{text} rate" for text in names])
        frame = self._frame_of(parent).at(place).translated(sign * along, q[0], v[0]).turned(sign * along, q[1], v[1])
        self._hang(name, "cylindrical", parent, child, frame, sign * along, sign)
        return q

    def universal(self, name: str, parent: Body, child: Body, at: Vector, axis: Vector, second_axis: Vector) -> ca.SX:
        """Cross of two axes at right angles, the first on the first body; give the angles about them (rad)."""
        place, along = self._place(name, at, axis)
        second = self.direction(f"{name}.second_axis", second_axis)
        self._refuse_skew(name, axis, second_axis)
        if self._closes(name, parent, child):
            return self._closures.universal(name, parent, child, place, along, second)
        ordered, child, sign = self._signed(name, parent, child)
        names = [f"{name}.angle", f"{name}.second_angle"]
        q, v = self.coordinates(names, [f"{text} rate" for text in names])
        turns = [(sign * along, q[0], v[0]), (sign * second, q[1], v[1])]
        frame = self._frame_of(ordered).at(place)
        for turn in turns if sign > 0.0 else turns[::-1]:  # from the child outwards the other way round
            frame = frame.turned(*turn)
        self._hang(name, "universal", ordered, child, frame, sign=sign)
        return q

    def spherical(self, name: str, parent: Body, child: Body, at: Vector) -> ca.SX:
        """Let a body turn about a point; give the quaternion of its orientation against the ground."""
        place = self.vector(f"{name}.at", at)
        if self._closes(name, parent, child):
            return self._closures.coincident(name, parent, child, place, place)
        parent, child, sign = self._signed(name, parent, child)
        e, w = self.quaternion(name)
        frame = self._frame_of(parent).at(place).oriented(by_quaternion(e, w))
        self._hang(name, "spherical", parent, child, frame, sign=sign)
        return e

    def free(self, name: str, child: Body, at: Vector | None = None, moving_frame: Body | None = None) -> ca.SX:
        """Let a body fly: place (m, from the design pose) and quaternion, against the ground or a moving frame."""
        self._check(name, child)
        if child.mass_properties is None and at is None:
            raise AssemblyError("a free body without mass", where=child.name, hint="Give mass and centre_of_mass.")
        centre = child.mass_properties.centre if child.mass_properties is not None else _NONE
        place = centre if at is None else self.vector(f"{name}.at", at)
        names = [f"{name}.{axis}" for axis in "xyz"]
        r, v = self.coordinates(names, [f"{text} rate" for text in names])
        e, w = self.quaternion(name)
        frame = Frame(place, Moving(place + r, v, ca.SX(3, 1)), by_quaternion(e, w))
        self._hang(name, "free", self.ground if moving_frame is None else moving_frame, child, frame)
        return ca.vertcat(r, e)

    def driven(self, name: str, parent: Body, child: Body, axis: Vector, travel: Track | Number) -> None:
        """Let a body slide along an axis by a prescribed travel (m): a track, or a parameter."""
        if self._closes(name, parent, child):
            raise AssemblyError("both bodies hang already", where=name, hint="Drive a body that has no joint yet.")
        self._held(name, parent)
        along = self.direction(f"{name}.axis", axis)
        still = travel if isinstance(travel, Track) else self.number(f"{name}.travel", travel, "m")
        track = still if isinstance(still, Track) else Track(still, ca.SX(0.0), ca.SX(0.0))
        frame = self._frame_of(parent).translated(along, track.value, track.rate, track.acceleration)
        self._hang(name, "driven", parent, child, frame)

    def coincident(self, name: str, first: Body, second: Body, at: Vector, second_at: Vector | None = None) -> ca.SX:
        """Keep a point of one body on a point of another; give the force on the second (N, ground axes)."""
        self._held(name, first, second)
        place = self.vector(f"{name}.at", at)
        other = place if second_at is None else self.vector(f"{name}.second_at", second_at)
        return self._closures.coincident(name, first, second, place, other)

    def rod(
        self, name: str, first: Body, second: Body, at: Vector, second_at: Vector, length: Number | None = None
    ) -> ca.SX:
        """Keep two points at a distance (m, by default as designed); give the rod's force (N, tension positive)."""
        self._held(name, first, second)
        ends = self.vector(f"{name}.at", at), self.vector(f"{name}.second_at", second_at)
        wanted = None if length is None else self.number(f"{name}.length", length, "m")
        numbers = [self.values.get(f"{name}.{text}[{i}]") for i in range(3) for text in ("at", "second_at")]
        is_point = length is None and None not in numbers and numbers[::2] == numbers[1::2]
        if is_point or self.values.get(f"{name}.length", 1.0) <= 0.0:
            hint = "Use coincident() to keep two points in one place."
            found = f"{self.values.get(f'{name}.length', 0.0):g} m"
            raise AssemblyError("a rod without length", where=name, found=found, allowed="above 0 m", hint=hint)
        return self._closures.rod(name, first, second, *ends, wanted)

    def point_on_line(self, name: str, first: Body, second: Body, at: Vector, axis: Vector, point: Vector) -> ca.SX:
        """Keep a point of the second body on a line of the first; give the two forces across the line (N)."""
        self._held(name, first, second)
        place, along = self._place(name, at, axis)
        return self._closures.point_on_line(name, first, second, place, along, self.vector(f"{name}.point", point))

    def perpendicular(self, name: str, first: Body, second: Body, axis: Vector, second_axis: Vector) -> ca.SX:
        """Keep two directions at right angles; give the torque that does it (N m)."""
        self._held(name, first, second)
        one, other = self.direction(f"{name}.axis", axis), self.direction(f"{name}.second_axis", second_axis)
        return self._closures.perpendicular(name, first, second, one, other)

    def parallel(self, name: str, first: Body, second: Body, axis: Vector) -> ca.SX:
        """Keep a direction of two bodies parallel; give the two torques that do it (N m)."""
        self._held(name, first, second)
        return self._closures.parallel(name, first, second, self.direction(f"{name}.axis", axis))

    def coupler(self, name: str, expression: ca.SX) -> ca.SX:
        """Keep a linear combination of coordinates at zero, such as ``rack - radius * pinion``; give its force."""
        return self.condition(name, expression)

    def motion(self, name: str, coordinate: ca.SX, track: Track) -> ca.SX:
        """Drive a coordinate (m or rad) along a prescribed input; give the force or torque that it takes."""
        return self.condition(name, coordinate - track.value)

    def condition(self, name: str, expression: ca.SX) -> ca.SX:
        """Keep any expression of coordinates and tracks at zero; give its multiplier."""
        expression = ca.SX(expression)
        self._check_condition(name, expression)
        rate = self.rate_of(expression)
        return self.constrain([name], expression, rate, self._bias_of(rate))

    def _check_condition(self, name: str, expression: ca.SX) -> None:
        """Refuse what is not one expression of coordinates, such as the force that a closing joint gives."""
        if expression.shape != (1, 1):
            hint = "Take one of them, as joint[0]; a closing joint gives its forces and has no coordinate."
            raise AssemblyError("not one coordinate", where=name, found=f"{expression.shape[0]} expressions", hint=hint)
        given = [*self._coordinates.values(), *self._parameters.values()]
        given += [symbol for track in self._tracks.values() for symbol in (track.value, track.rate, track.acceleration)]
        known = {symbol.name() for symbol in given}
        strange = [symbol.name() for symbol in ca.symvar(expression) if symbol.name() not in known]
        moves = ca.depends_on(expression, ca.vertcat(*self._coordinates.values()))
        if strange or not moves:
            found = f"an expression of {', '.join(strange)}" if strange else "an expression of no coordinate"
            hint = "Let the joint that is to be driven come before the one that closes the loop." if strange else ""
            raise AssemblyError("not a condition on coordinates", where=name, found=found, hint=hint)

    def note(
        self, body: Body, force: ca.SX = _NONE, point: ca.SX = _NONE, torque: ca.SX = _NONE, source: str = ""
    ) -> None:
        """Note what acts on a body, for the reactions of its joint; the equations of motion have it already."""
        self._wrenches.append(Wrench(body, force, point, torque, source))

    def _check(self, name: str, *bodies: Body) -> None:
        """Refuse bodies of another mechanism, and one body twice."""
        for body in bodies:
            if self._bodies.get(body.name) is not body:
                raise AssemblyError("the body belongs to another mechanism", where=name, found=body.name)
        if len(bodies) == 2 and bodies[0] is bodies[1]:
            raise AssemblyError("a body cannot be joined to itself", where=name, found=bodies[0].name)

    def _held(self, name: str, *bodies: Body) -> None:
        """Refuse bodies that hang on nothing yet."""
        self._check(name, *bodies)
        for body in bodies:
            if body.frame is None:
                hint = "Give the joint that carries it first."
                raise AssemblyError("the body hangs on nothing yet", where=name, found=body.name, hint=hint)
        self._refuse_apart(name, *bodies)

    def _refuse_apart(self, name: str, *bodies: Body) -> None:
        """Refuse bodies whose places are in different axes."""
        carriers = {body.name: body.carrier for body in bodies if body.frame is not None}
        if len(set(map(id, carriers.values()))) > 1:
            found, hint = (
                ", ".join(carriers),
                "Join what hangs in a moving frame to that frame, not to its body or the ground.",
            )
            raise AssemblyError("the bodies hang in different moving frames", where=name, found=found, hint=hint)

    def _refuse_carried(self, name: str, *bodies: Body) -> None:
        """Refuse what is for places in ground axes only."""
        for body in bodies:
            if body.carrier.moves:
                raise AssemblyError("not for what hangs in a moving frame", where=name, found=body.name)

    def _closes(self, name: str, first: Body, second: Body) -> bool:
        self._check(name, first, second)
        self._refuse_apart(name, first, second)
        return first.frame is not None and second.frame is not None

    def _refuse_skew(self, name: str, axis: Vector, second_axis: Vector) -> None:
        """Refuse the cross of a universal joint whose axes are not at right angles."""
        if isinstance(axis, ca.SX) or isinstance(second_axis, ca.SX):
            return
        paths = (f"{name}.axis", f"{name}.second_axis")
        one, other = (np.array([self.values[f"{path}[{i}]"] for i in range(3)]) for path in paths)
        cosine = one @ other / np.sqrt(one @ one * (other @ other))
        if abs(cosine) > _SQUARE:
            degrees = float(np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))))
            raise AssemblyError(
                "the axes of a universal joint are not at right angles",
                where=name,
                found=f"{degrees:.4g} degrees between them",
                hint="Take as second axis the cross product of the first with a direction across both.",
            )

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
        name = self.placed(name)
        self._refuse_twice(name, self._joints)
        if child.frame is not None:
            raise AssemblyError("the body hangs already", where=name, found=child.name, hint="It needs one joint only.")
        child.frame, child.carrier = frame, parent.carrier
        self._joints[name] = TreeJoint(name, kind, parent, child, axis, sign < 0.0)

    def _place(self, name: str, at: Vector, axis: Vector) -> tuple[ca.SX, ca.SX]:
        return self.vector(f"{name}.at", at), self.direction(f"{name}.axis", axis)

    @staticmethod
    def _frame_of(body: Body) -> Frame:
        assert body.frame is not None
        return body.frame
