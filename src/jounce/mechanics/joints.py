"""Joint types, one class each.

A joint *hangs* a body that is not in the tree yet: then it has coordinates, and ``hang`` returns the child's frame.
Between two bodies of the tree it *closes* a loop: then it has equations, ``rows``, each with the force and torque of
its multiplier on the second body. ``efforts`` returns the wrenches on the bodies of unit forces on its coordinates; the
reaction of the joint is perpendicular to those directions. To add a joint type, define these three methods and pass it
to :meth:`jounce.mechanics.Mechanism.add`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import casadi as ca
import numpy as np

from jounce.core.errors import AssemblyError
from jounce.mechanics.bodies import Body
from jounce.mechanics.descriptions import Given, Known, NamedPart, direction, place, quantity
from jounce.mechanics.equations import Track
from jounce.mechanics.frames import Frame, Moving, by_quaternion
from jounce.mechanics.rotations import normals

_NONE = ca.SX(3, 1)
_SQUARE = 1e-3  # cosine of the axes of a universal joint up to which they count as perpendicular
_TURN = 2.0 * np.pi  # rad


@dataclass(frozen=True)
class JointCoordinates:
    """Symbols of a tree joint: distances and angles with their rates, quaternion and angular velocity."""

    q: ca.SX
    v: ca.SX
    e: ca.SX
    w: ca.SX


@dataclass(frozen=True)
class ClosingEquation:
    """One equation of a closing joint; a multiplier of 1 is this force and torque on the second body, at ``point``.

    The opposite force and torque act on the first body at the same point. ``residual`` is in ``unit``: ``m``, ``rad``
    (the sine of an angle) or ``m^2``.
    """

    tag: str
    unit: str
    residual: Moving
    force: ca.SX = _NONE
    torque: ca.SX = _NONE
    point: ca.SX = _NONE


@dataclass(frozen=True)
class Effort:
    """Force and torque on ``body`` (at ``point``), and opposite on ``other``, of a unit force on a speed."""

    body: Body
    other: Body
    force: ca.SX = _NONE
    torque: ca.SX = _NONE
    point: ca.SX = _NONE


@dataclass(frozen=True, eq=False)
class Joint(NamedPart):
    """Connection of two bodies: a body's first joint adds it to the tree, further joints close loops."""

    first: Body
    second: Body

    coordinates: ClassVar[tuple[tuple[str, str], ...]] = ()
    """Name suffixes and units of its distances and angles."""
    has_quaternion: ClassVar[bool] = False
    """Whether the child's orientation relative to the ground is among its coordinates."""
    hangs: ClassVar[bool] = True
    closes: ClassVar[bool] = True
    refusal: ClassVar[tuple[str, str]] = ("both bodies already have joints", "")
    """Message and hint for a joint that cannot close a loop."""

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:
        """Return the frame of the child body.

        Coordinates are those of the second body relative to the first. If the first body is the child, ``sign`` is
        -1 and multiple motions are applied in reverse order.
        """
        raise NotImplementedError

    def rows(self) -> list[ClosingEquation]:
        """Return the equations that close the loop."""
        raise NotImplementedError

    def efforts(self, hung: Body, ground: Body) -> list[Effort]:  # noqa: ARG002 - for joints with coordinates
        """Return the wrenches of unit forces on its speeds, in their order."""
        return []

    def shown(self, multipliers: ca.SX) -> ca.SX:
        """Return the result for the caller when it closes a loop: forces (N) and torques (N m) on the second body."""
        return multipliers

    def _along(self, axis: ca.SX) -> ca.SX:
        """Return a direction of the first body in the current pose."""
        return self.first.frame.direction(axis).value

    def _push(self, axis: ca.SX, at: ca.SX) -> Effort:
        return Effort(
            self.second,
            self.first,
            force=self._along(axis),
            point=self.second.frame.point(at).value,
        )

    def _twist(self, along: ca.SX) -> Effort:
        return Effort(self.second, self.first, torque=along)

    def _turns(self, hung: Body, ground: Body) -> list[Effort]:
        """Return the efforts on the three speeds of a quaternion, which are relative to the ground."""
        matrix = hung.frame.orientation.matrix
        return [Effort(hung, ground, torque=matrix[:, i]) for i in range(3)]


@dataclass(frozen=True, eq=False)
class Fixed(Joint):
    """Two bodies welded together.

    It adds the body that has no joint yet to the tree. It has no coordinate and transmits every force and torque.
    """

    kind = "fixed"
    closes = False
    refusal = ("both bodies already have joints", "Make them one body.")

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:  # noqa: ARG002
        """Return the frame of the child body."""
        return parent.at(parent.design)


@dataclass(frozen=True, eq=False)
class Prismatic(Joint):
    """Translation along an axis.

    ``at`` (m) is the reference point of its torque, ``axis`` (1, of any length) the direction of travel.
    """

    at: Given = place()
    axis: Given = direction()
    kind = "prismatic"
    coordinates = (("distance", "m"),)

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:
        """Return the frame of the child body."""
        return parent.at(self.at).translated(sign * self.axis, motion.q, motion.v)

    def rows(self) -> list[ClosingEquation]:
        """Its equations."""
        normal, other = normals(self.axis)
        sleeve = [*_on_line(self, self.at, self.axis, self.at), *_parallel(self, self.axis)]
        return [
            *sleeve,
            _square(
                "twist", self.first.frame.direction(normal), self.second.frame.direction(other)
            ),
        ]

    def efforts(self, hung: Body, ground: Body) -> list[Effort]:  # noqa: ARG002
        """Return the wrenches of unit forces along its coordinates."""
        return [self._push(self.axis, self.at)]


@dataclass(frozen=True, eq=False)
class Revolute(Joint):
    """A hinge.

    ``at`` (m) is a point of its axis, ``axis`` (1, of any length) the direction about which the second body turns.
    """

    at: Given = place()
    axis: Given = direction()
    kind = "revolute"
    coordinates = (("angle", "rad"),)

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:
        """Return the frame of the child body."""
        return parent.at(self.at).turned(sign * self.axis, motion.q, motion.v)

    def rows(self) -> list[ClosingEquation]:
        """Its equations."""
        return [*_point_to_point(self, self.at, self.at), *_parallel(self, self.axis)]

    def efforts(self, hung: Body, ground: Body) -> list[Effort]:  # noqa: ARG002
        """Return the wrenches of unit forces along its coordinates."""
        return [self._twist(self._along(self.axis))]


@dataclass(frozen=True, eq=False)
class Cylindrical(Joint):
    """A sleeve that slides along an axis and turns about it.

    ``at`` (m) is a point of its axis, ``axis`` (1, of any length) the direction of its translation and rotation.
    """

    at: Given = place()
    axis: Given = direction()
    kind = "cylindrical"
    coordinates = (("distance", "m"), ("angle", "rad"))

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:
        """Return the frame of the child body."""
        along, (slide, turn), (speed, spin) = (
            sign * self.axis,
            *(ca.vertsplit(part) for part in (motion.q, motion.v)),
        )
        return parent.at(self.at).translated(along, slide, speed).turned(along, turn, spin)

    def rows(self) -> list[ClosingEquation]:
        """Its equations."""
        return [*_on_line(self, self.at, self.axis, self.at), *_parallel(self, self.axis)]

    def efforts(self, hung: Body, ground: Body) -> list[Effort]:  # noqa: ARG002
        """Return the wrenches of unit forces along its coordinates."""
        return [self._push(self.axis, self.at), self._twist(self._along(self.axis))]


@dataclass(frozen=True, eq=False)
class Screw(Joint):
    """A nut on a thread: each turn of the second body advances it along the axis by the pitch, m.

    ``at`` (m) is a point of its axis, ``axis`` (1, of any length) its direction, ``pitch`` (m, not 0) the advance per
    turn, negative for a left-hand thread.
    """

    at: Given = place()
    axis: Given = direction()
    pitch: Given = quantity("m")
    kind = "screw"
    coordinates = (("angle", "rad"),)

    def check(self, known: Known) -> None:
        """Refuse a pitch of zero."""
        super().check(known)
        if known("pitch") == 0.0:
            hint = "Without pitch, use a revolute joint; a negative pitch is a left-hand thread."
            raise AssemblyError(
                "a screw without pitch", where=self.name, found="0 m a turn", hint=hint
            )

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:
        """Return the frame of the child body."""
        along, lead = sign * self.axis, self.pitch / _TURN
        return (
            parent.at(self.at)
            .translated(along, lead * motion.q, lead * motion.v)
            .turned(along, motion.q, motion.v)
        )

    def rows(self) -> list[ClosingEquation]:
        """Return the equations of a sleeve, and one that couples rotation to translation over any number of turns."""
        first, second = self.first.frame, self.second.frame
        across, sideways = (first.direction(normal) for normal in normals(self.axis))
        mark, axis, foot = (
            second.direction(normals(self.axis)[0]),
            first.direction(self.axis),
            second.point(self.at),
        )
        slide = (foot - first.point(self.at)).dot(axis)
        turn = Moving(
            *(part * (_TURN / self.pitch) for part in (slide.value, slide.rate, slide.bias))
        )
        thread = sideways.scaled(turn.cosine) - across.scaled(
            turn.sine
        )  # perpendicular to the mark when rotation and translation match
        climb = -ca.dot(
            mark.value, across.scaled(turn.cosine).value + sideways.scaled(turn.sine).value
        )
        lead = ClosingEquation(
            "lead",
            "rad",
            mark.dot(thread),
            force=climb * _TURN / self.pitch * axis.value,
            torque=ca.cross(mark.value, thread.value),
            point=foot.value,
        )
        return [*_on_line(self, self.at, self.axis, self.at), *_parallel(self, self.axis), lead]

    def efforts(self, hung: Body, ground: Body) -> list[Effort]:  # noqa: ARG002
        """Return the wrenches of unit forces along its coordinates."""
        return [self._twist(self._along(self.axis))]


@dataclass(frozen=True, eq=False)
class Universal(Joint):
    """A cross of two axes at right angles, the first on the first body.

    ``at`` (m) is its centre, ``axis`` and ``second_axis`` (1, of any length) are fixed to the first and second body.
    """

    at: Given = place()
    axis: Given = direction()
    second_axis: Given = direction()
    kind = "universal"
    coordinates = (("angle", "rad"), ("second_angle", "rad"))

    def check(self, known: Known) -> None:
        """Refuse axes that are not perpendicular."""
        super().check(known)
        axis, second = (known(field) for field in ("axis", "second_axis"))
        cosine = axis @ second / np.sqrt(axis @ axis * (second @ second))
        if abs(cosine) > _SQUARE:
            degrees = float(np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))))
            raise AssemblyError(
                "the axes of a universal joint are not at right angles",
                where=self.name,
                found=f"{degrees:.4g} degrees between them",
                hint="As the second axis, use the cross product of the first with a direction perpendicular to both.",
            )

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:
        """Return the frame of the child body."""
        turns = [
            (sign * axis, motion.q[i], motion.v[i])
            for i, axis in enumerate((self.axis, self.second_axis))
        ]
        frame = parent.at(self.at)
        for turn in (
            turns if sign > 0.0 else turns[::-1]
        ):  # in reverse order from the second body to the first
            frame = frame.turned(*turn)
        return frame

    def rows(self) -> list[ClosingEquation]:
        """Its equations."""
        axes = self.first.frame.direction(self.axis), self.second.frame.direction(self.second_axis)
        return [*_point_to_point(self, self.at, self.at), _square("cross", *axes)]

    def efforts(self, hung: Body, ground: Body) -> list[Effort]:  # noqa: ARG002
        """Return the wrenches of unit forces along its coordinates."""
        second = self.second.frame.direction(self.second_axis).value
        return [self._twist(self._along(self.axis)), self._twist(second)]


@dataclass(frozen=True, eq=False)
class Spherical(Joint):
    """A ball joint.

    ``at`` (m) is its centre; it turns freely in all directions.
    """

    at: Given = place()
    kind = "spherical"
    has_quaternion = True

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:  # noqa: ARG002
        """Return the frame of the child body."""
        return parent.at(self.at).oriented(by_quaternion(motion.e, motion.w))

    def rows(self) -> list[ClosingEquation]:
        """Its equations."""
        return _point_to_point(self, self.at, self.at)

    def efforts(self, hung: Body, ground: Body) -> list[Effort]:
        """Return the wrenches of unit forces along its coordinates."""
        return self._turns(hung, ground)


@dataclass(frozen=True, eq=False)
class Link(Joint):
    """A massless rigid link, on a hinge of the first body and a ball joint of the second.

    ``at`` (m) is a point of the hinge and ``axis`` (1, of any length) its direction, ``second_at`` (m) the centre of
    the ball, not on the hinge's axis.
    """

    at: Given = place()
    axis: Given = direction()
    second_at: Given = place()
    kind = "link"
    coordinates = (("angle", "rad"),)
    has_quaternion = True

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:
        """Return the child's frame, from the hinge out to the ball or from the ball on the parent back to the hinge."""
        orientation = by_quaternion(motion.e, motion.w)
        if sign > 0.0:
            link = parent.at(self.at).turned(self.axis, motion.q, motion.v)
            return link.at(self.second_at).oriented(orientation)
        ball = parent.at(self.second_at).oriented(orientation)
        return ball.turned(self.axis, motion.q, motion.v).at(self.at).oriented(orientation)

    def rows(self) -> list[ClosingEquation]:
        """Keep the ball on its circle: at its position along the axis, and at its distance from the hinge."""
        reach, axis = self._reach, self.first.frame.direction(self.axis)
        height, ball = reach.dot(axis), self.second.frame.point(self.second_at).value
        design = self.second_at - self.at
        level = Moving(height.value - ca.dot(design, self.axis), height.rate, height.bias)
        return [
            ClosingEquation("along", "m", level, force=axis.value, point=ball),
            ClosingEquation(
                "length",
                "m^2",
                _half_square(reach, ca.dot(design, design)),
                force=reach.value,
                point=ball,
            ),
        ]

    def efforts(self, hung: Body, ground: Body) -> list[Effort]:
        """Return the wrenches of unit forces along its coordinates."""
        swept = ca.cross(self._along(self.axis), self._reach.value)
        ball = self.second.frame.point(self.second_at).value
        push = Effort(self.second, self.first, force=swept / ca.dot(swept, swept), point=ball)
        return [push, *self._turns(hung, ground)]

    @property
    def _reach(self) -> Moving:
        return self.second.frame.point(self.second_at) - self.first.frame.point(self.at)


@dataclass(frozen=True, eq=False)
class Free(Joint):
    """No joint at all: the second body moves freely relative to the ground or a moving frame.

    ``at`` (m) is the point of the body whose displacements are the coordinates, usually its centre of mass.
    """

    at: Given = place()
    kind = "free"
    coordinates = (("x", "m"), ("y", "m"), ("z", "m"))
    has_quaternion = True
    closes = False
    refusal = ("the body already has a joint", "It needs one joint only.")

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:  # noqa: ARG002
        """Return the frame of the child body."""
        origin = Moving(self.at + motion.q, motion.v, ca.SX(3, 1))
        return Frame(self.at, origin, by_quaternion(motion.e, motion.w), parent.carrier)

    def efforts(self, hung: Body, ground: Body) -> list[Effort]:
        """Return the wrenches of unit forces along its coordinates."""
        origin = hung.frame.origin.value
        pushes = [Effort(hung, ground, force=ca.SX.eye(3)[:, i], point=origin) for i in range(3)]
        return [*pushes, *self._turns(hung, ground)]


@dataclass(frozen=True, eq=False)
class Driven(Joint):
    """Translation along an axis by a prescribed travel: a track, or a parameter (m).

    ``axis`` (1, of any length) is its direction, ``travel`` the track of the mechanism, or a number in m.
    """

    axis: Given = direction()
    travel: Given = quantity("m")
    kind = "driven"
    closes = False
    refusal = ("both bodies already have joints", "Drive a body that has no joint yet.")

    def hang(self, parent: Frame, motion: JointCoordinates, sign: int) -> Frame:  # noqa: ARG002
        """Return the frame of the child body."""
        still = Track(self.travel, ca.SX(0.0), ca.SX(0.0))
        track = self.travel if isinstance(self.travel, Track) else still
        return parent.translated(sign * self.axis, track.value, track.rate, track.acceleration)


@dataclass(frozen=True, eq=False)
class PointToPoint(Joint):
    """A point of the second body coincides with a point of the first.

    ``at`` and ``second_at`` (m) are the points of the first and second body; created by ``Mechanism.coincident``.
    """

    at: Given = place()
    second_at: Given = place()
    kind = "point to point"
    hangs = False

    def rows(self) -> list[ClosingEquation]:
        """Its equations."""
        return _point_to_point(self, self.at, self.second_at)


@dataclass(frozen=True, eq=False)
class Rod(Joint):
    """Two points at a fixed distance (m, by default that of the design pose).

    ``at`` and ``second_at`` (m) are its ends on the first and second body, ``length`` (m, above 0) its length.
    """

    at: Given = place()
    second_at: Given = place()
    length: Given = quantity("m", None)
    kind = "rod"
    hangs = False

    def defaults(self) -> dict[str, ca.SX]:
        """Return the length in the design pose as the default."""
        return {"length": ca.sqrt(self._squared_length)} if self.length is None else {}

    def check(self, known: Known) -> None:
        """Refuse a rod without length."""
        super().check(known)
        if known("length") <= 0.0:
            hint = "Use coincident() to keep two points together."
            length = f"{known('length'):g} m"
            raise AssemblyError(
                "a rod without length",
                where=self.name,
                found=length,
                allowed="above 0 m",
                hint=hint,
            )

    @property
    def _squared_length(self) -> ca.SX:
        design = self.second_at - self.at
        return ca.dot(design, design) if self.length is None else ca.SX(self.length**2)

    def rows(self) -> list[ClosingEquation]:
        """Return its equation; the multiplier is the rod's force divided by its length, compression positive."""
        other = self.second.frame.point(self.second_at)
        reach = other - self.first.frame.point(self.at)
        return [
            ClosingEquation(
                "",
                "m^2",
                _half_square(reach, self._squared_length),
                force=reach.value,
                point=other.value,
            )
        ]

    def shown(self, multipliers: ca.SX) -> ca.SX:
        """Return the rod's force, N, tension positive."""
        return -multipliers * ca.sqrt(self._squared_length)


@dataclass(frozen=True, eq=False)
class PointOnLine(Joint):
    """A point of the second body on a line of the first.

    ``at`` (m) and ``axis`` (1, of any length) are the line on the first body, ``point`` (m) is fixed to the second.
    """

    at: Given = place()
    axis: Given = direction()
    point: Given = place()
    kind = "point on line"
    hangs = False

    def rows(self) -> list[ClosingEquation]:
        """Its equations."""
        return _on_line(self, self.at, self.axis, self.point)


@dataclass(frozen=True, eq=False)
class Perpendicular(Joint):
    """Two directions at right angles.

    ``axis`` (1, of any length) is fixed to the first body, ``second_axis`` (1, of any length) to the second.
    """

    axis: Given = direction()
    second_axis: Given = direction()
    kind = "perpendicular"
    hangs = False

    def rows(self) -> list[ClosingEquation]:
        """Its equations."""
        return [
            _square(
                "",
                self.first.frame.direction(self.axis),
                self.second.frame.direction(self.second_axis),
            )
        ]


@dataclass(frozen=True, eq=False)
class Parallel(Joint):
    """A direction of each body, kept parallel.

    ``axis`` (1, of any length) is the direction in the design pose; it is fixed to both bodies.
    """

    axis: Given = direction()
    kind = "parallel"
    hangs = False

    def rows(self) -> list[ClosingEquation]:
        """Its equations."""
        return _parallel(self, self.axis)


# building blocks of joint equations ------------------------------------------------------------------------------


def _point_to_point(joint: Joint, at: ca.SX, second_at: ca.SX) -> list[ClosingEquation]:
    """Return equations for coincident points; the multipliers are the force on the second body."""
    other = joint.second.frame.point(second_at)
    gap = other - joint.first.frame.point(at)
    return [
        ClosingEquation(
            axis,
            "m",
            Moving(gap.value[i], gap.rate[i], gap.bias[i]),
            force=ca.SX.eye(3)[:, i],
            point=other.value,
        )
        for i, axis in enumerate("xyz")
    ]


def _on_line(joint: Joint, at: ca.SX, axis: ca.SX, point: ca.SX) -> list[ClosingEquation]:
    """Return equations that keep a point of the second body on a line of the first."""
    other = joint.second.frame.point(point)
    reach = other - joint.first.frame.point(at)
    across = [joint.first.frame.direction(normal) for normal in normals(axis)]
    return [
        ClosingEquation(tag, "m", normal.dot(reach), force=normal.value, point=other.value)
        for tag, normal in zip(("across", "across_2"), across, strict=True)
    ]


def _parallel(joint: Joint, axis: ca.SX) -> list[ClosingEquation]:
    """Return equations that keep a direction of each body parallel."""
    other = joint.second.frame.direction(axis)
    across = [joint.first.frame.direction(normal) for normal in normals(axis)]
    return [
        _square(tag, normal, other) for tag, normal in zip(("tilt", "tilt_2"), across, strict=True)
    ]


def _square(tag: str, first: Moving, second: Moving) -> ClosingEquation:
    """Return the equation that keeps a direction of the first body perpendicular to one of the second."""
    return ClosingEquation(
        tag, "rad", first.dot(second), torque=ca.cross(second.value, first.value)
    )


def _half_square(reach: Moving, squared: ca.SX) -> Moving:
    """Return half the excess of a squared length."""
    product = reach.dot(reach)
    return Moving(0.5 * (product.value - squared), 0.5 * product.rate, 0.5 * product.bias)
