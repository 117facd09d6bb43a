"""Mechanisms in space: a builder that collects and checks bodies, joints, loads and outputs.

Positions and directions refer to the design pose: x, y, z in metres in the ground's axes. The first joint of a body
adds it to the tree; a joint between two bodies that are already in the tree closes a loop. The builder lists its
content (``str``, ``to_dict``); ``finish`` forms the equations and does not modify the builder.
"""

from __future__ import annotations

import copy
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from jounce.core.constants import GRAVITY
from jounce.core.errors import AssemblyError, unknown
from jounce.core.phrases import Phrase
from jounce.core.turns import turn
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.mechanics import joints, listing, loads, outputs
from jounce.mechanics.assembly import assemble, refuse_singular, removable
from jounce.mechanics.bodies import (
    Body,
    BodyFrames,
    BodyPoint,
    MassProperties,
    RigidMass,
    tensor_elements,
)
from jounce.mechanics.carrier import Carried, CarriedMasses, MovingCarrier
from jounce.mechanics.descriptions import NamedPart, Number, Vector
from jounce.mechanics.equations import Collection, Track, form
from jounce.mechanics.expressions import check_name, expression_of, vector_of
from jounce.mechanics.facts import Equation
from jounce.mechanics.frames import GROUND, Moving
from jounce.mechanics.joints import Joint, JointCoordinates
from jounce.mechanics.loads import Action, ForceElement
from jounce.mechanics.mass import check_inertia
from jounce.mechanics.mobility import Freedoms, Mobility
from jounce.mechanics.model import Model
from jounce.mechanics.outputs import OutputDescription
from jounce.mechanics.reactions import Reaction, reaction_of
from jounce.mechanics.rotations import unit
from jounce.mechanics.structure import Closing, HangingJoint, LoopExpression, Structure
from jounce.mechanics.system import all_or_nothing

BALANCE = "energy.balance"
"""Names of a state (work of all forces) and an output (kinetic energy minus that work) of mechanisms with loops."""
_NONE = ca.SX(3, 1)
_EMPTY = ca.SX(0, 1)


class Mechanism(Structure):
    """Builder of a mechanism: add bodies, joints, loops, forces and outputs, then call ``finish``.

    All bodies are connected to its body ``ground``. ``values`` maps parameters to their values (SI) as built.

    Parameters
    ----------
    gravity : float or casadi.SX
        m/s^2, along -z.

    Examples
    --------
    A pendulum of 1 kg that starts level:

    >>> import jounce as jn
    >>> pendulum = jn.mechanics.Mechanism()
    >>> bob = pendulum.body("bob", mass=1.0, centre_of_mass=(1.0, 0.0, 0.0), inertia=(0.01, 0.01, 0.01))
    >>> _ = pendulum.revolute("pivot", pendulum.ground, bob, at=(0.0, 0.0, 0.0), axis=(0.0, 1.0, 0.0))
    >>> pendulum.finish().coordinates
    ('pivot.angle',)
    >>> print(pendulum)
    bodies
      bob: mass 1 kg, centre of mass (1, 0, 0) m, inertia xx 0.01, yy 0.01, zz 0.01, xy 0, xz 0, yz 0 kg m^2
    joints
      pivot: revolute, ground - bob, at (0, 0, 0) m, axis (0, 1, 0); pivot.angle [rad]
    """

    def __init__(self, gravity: Number = GRAVITY) -> None:
        super().__init__()
        self.watched: dict[str, OutputDescription] = {}
        self._finished: dict[tuple[object, ...], Model] = {}
        self._counted: dict[int, Freedoms] = {}
        self.gravity = self.number("gravity", gravity, "m/s^2")

    # numbers ---------------------------------------------------------------------------------------------------

    def number(self, path: str, value: Number, unit: str = "1") -> ca.SX:
        """Add a parameter at ``path`` with a value (SI ``unit``) and return it; return an expression unchanged."""
        if isinstance(value, ca.SX):
            if value.shape != (1, 1):
                raise AssemblyError(
                    "not a number", where=path, found=f"{value.numel()} expressions", allowed="one"
                )
            return self.poses.require_still(value, path)
        placed = self._scope[1] + check_name(path, "parameter")
        if placed in self.values:
            hint = "Give every joint, force and watched point a unique name."
            raise AssemblyError("the name is used twice", where=placed, hint=hint)
        number = to_si(value, unit, where=path)
        self.units[placed], self.values[placed] = unit, number
        return self.parameter(path)

    @all_or_nothing
    def vector(self, path: str, value: Vector, unit: str = "m") -> ca.SX:
        """Add three parameters ``path[0]`` to ``path[2]`` with values (SI ``unit``) and return them."""
        shape = (
            value.shape
            if isinstance(value, ca.SX)
            else (np.size(np.asarray(value, dtype=object)), 1)
        )
        if shape != (3, 1):
            raise AssemblyError(
                "invalid vector", where=path, found=f"{shape[0]} numbers", allowed="three: x, y, z"
            )
        if isinstance(value, ca.SX):
            return self.poses.require_still(value, path)
        return ca.vertcat(
            *(self.number(f"{path}[{i}]", part, unit) for i, part in enumerate(value))
        )

    @all_or_nothing
    def direction(self, path: str, value: Vector) -> ca.SX:
        """Return the unit vector along three numbers."""
        if not isinstance(value, ca.SX):
            parts = [
                to_si(part, "1", where=path)
                for part in np.atleast_1d(np.asarray(value, dtype=object)).ravel()
            ]
            if len(parts) == 3 and not any(parts):
                raise AssemblyError(
                    "an axis without direction",
                    where=path,
                    found=tuple(parts),
                    allowed="not all zero",
                )
        return unit(self.vector(path, value, "1"))

    # bodies ----------------------------------------------------------------------------------------------------

    @all_or_nothing
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
            kg. A body without mass only carries points; weld it to a body with mass or drive it by a track.
        centre_of_mass : sequence of float, shape (3,), optional
            m, in the design pose.
        inertia : sequence of float, shape (3,), (6,) or (3, 3), optional
            xx, yy, zz (, xy, xz, yz) of the tensor about the centre of mass in design axes, kg m^2, or the tensor. By
            default the body is a point mass.

        Returns
        -------
        Body
            The body, to be passed to joints, points and forces.
        """
        placed = self._require_unused(name, self.bodies)
        properties = None
        if mass is not None:
            if centre_of_mass is None:
                raise AssemblyError(
                    "a mass without a centre of mass", where=name, hint="Give centre_of_mass."
                )
            properties = MassProperties(
                self.number(f"{name}.mass", mass, "kg"),
                self.vector(f"{name}.centre_of_mass", centre_of_mass),
                self._tensor(f"{name}.inertia", inertia),
            )
            numbers = [
                listing.Reading(self, self.values).numbers(part)
                for part in (properties.mass, properties.inertia)
            ]
            if numbers[0] is not None and numbers[1] is not None:
                check_inertia(placed, float(numbers[0]), numbers[1])
        elif inertia is not None or centre_of_mass is not None:
            raise AssemblyError(
                "a centre of mass or an inertia without a mass", where=name, hint="Give mass."
            )
        self.bodies[placed] = Body(placed, self.poses, properties)
        return self.bodies[placed]

    def _tensor(
        self, path: str, inertia: Sequence[float | str] | NDArray[np.float64] | ca.SX | None
    ) -> ca.SX:
        if inertia is None:
            return ca.SX(3, 3)
        if isinstance(inertia, ca.SX):
            if inertia.shape != (3, 3):
                shape, allowed = f"shape {inertia.shape}", "a symmetric (3, 3) tensor"
                raise AssemblyError(
                    "invalid inertia tensor", where=path, found=shape, allowed=allowed
                )
            return self.poses.require_still(inertia, path)
        names, elements = ("xx", "yy", "zz", "xy", "xz", "yz"), tensor_elements(path, inertia)
        pairs = zip(names, elements, strict=True)
        xx, yy, zz, xy, xz, yz = (
            self.number(f"{path}.{name}", value, "kg*m^2") for name, value in pairs
        )
        return ca.vertcat(ca.horzcat(xx, xy, xz), ca.horzcat(xy, yy, yz), ca.horzcat(xz, yz, zz))

    @all_or_nothing
    def moving_frame(self, body: Body, field: ca.SX) -> Body:
        """Return moving axes of a body for a mechanism attached to it; cheaper than joints to the body itself.

        Parameters
        ----------
        body : Body
            A body with a joint.
        field : casadi.SX, shape (3,)
            Acceleration acting on all bodies in the moving frame, m/s^2, ground axes: gravity, inertia of driving.

        Returns
        -------
        Body
            Axes that move with the body. Joints to them and between bodies in them do not depend on that motion.
        """
        self._require_placed("moving frame", body)
        field = vector_of(field, f"field of {body.name} axes", "m/s^2")
        name = f"{body.name} axes"
        if name in self.bodies:
            raise AssemblyError("the name is used twice", where=name)
        self.bodies[name] = Body(name, self.poses, axes_of=body)
        self.poses.frames[name] = replace(GROUND, carrier=MovingCarrier(body.frame, field))
        return self.bodies[name]

    # joints ----------------------------------------------------------------------------------------------------

    @all_or_nothing
    def add(self, joint: Joint) -> ca.SX:
        """Add a joint of any class.

        Parameters
        ----------
        joint : Joint
            Its description; the methods below create one for you.

        Returns
        -------
        casadi.SX
            Coordinates (m, rad, 1) of a tree joint; forces (N) and torques (N m) on the second body of a joint that
            closes a loop.
        """
        if not isinstance(joint, Joint):
            hint = "Use a class of jounce.mechanics, such as Revolute, or your own."
            raise AssemblyError("not a joint", where="add", found=type(joint).__name__, hint=hint)
        name, first, second = joint.name, joint.first, joint.second
        self._check(name, first, second)
        if not joint.hangs:
            self._require_placed(name, first, second)
        elif not (first.is_placed or second.is_placed):
            names, hint = (
                f"{first.name}, {second.name}",
                "Give the joints in an order that starts at the ground.",
            )
            raise AssemblyError(
                "neither body is connected to the ground yet", where=name, found=names, hint=hint
            )
        self._refuse_apart(name, first, second)
        closes = first.is_placed and second.is_placed
        if closes and not joint.closes:
            text, hint = joint.refusal
            raise AssemblyError(text, where=self.name_at_place(name), found=second.name, hint=hint)
        for track in (value for value in vars(joint).values() if isinstance(value, Track)):
            self._check_track(name, track)
        described = joint.with_symbols(self)
        self._check_numbers([described], self.values)
        placed = self._require_unused(name, (*self.hanging, *self.closing, *self.conditions))
        return (
            self._close(replace(described, name=placed))
            if closes
            else self._hang(name, replace(described, name=placed))
        )

    def _hang(self, name: str, joint: Joint) -> ca.SX:
        """Add the joint's new body to the tree."""
        parent, child, sign = joint.first, joint.second, 1
        if child.is_placed:
            parent, child, sign = child, parent, -1
        names, units = (
            [f"{name}.{tag}" for tag, _ in joint.coordinates],
            [unit for _, unit in joint.coordinates],
        )
        q, v = (
            self.coordinates(names, [f"{text} rate" for text in names], units=units)
            if names
            else (_EMPTY, _EMPTY)
        )
        e, w = self.quaternion(name) if joint.has_quaternion else (_EMPTY, _EMPTY)
        motion = JointCoordinates(q, v, e, w)
        self.poses.frames[child.name] = joint.hang(parent.frame, motion, sign)
        coordinates, quaternion = (
            tuple(symbol.name() for symbol in ca.vertsplit(part)) if part.numel() else ()
            for part in (q, e)
        )
        speeds = tuple(
            symbol.name() for part in (v, w) if part.numel() for symbol in ca.vertsplit(part)
        )
        if (given := len(joint.efforts(child, self.ground))) != len(speeds):
            allowed = f"{len(speeds)}, one for each speed: {', '.join(speeds)}"
            raise AssemblyError(
                Phrase(
                    "{given} forces or torques for {name}", given=given, name=type(joint).__name__
                ),
                where=name,
                found=given,
                allowed=allowed,
            )
        self.hanging[joint.name] = HangingJoint(
            joint, parent, child, motion, coordinates, quaternion, speeds
        )
        self._refuse_clashes()
        return ca.vertcat(q, e)

    def _close(self, joint: Joint) -> ca.SX:
        """Close a loop between two bodies of the tree."""
        rows = tuple(joint.rows())
        equations = [
            Equation(f"{joint.name}.{row.tag}" if row.tag else joint.name, joint.name, row.unit)
            for row in rows
        ]
        columns = zip(
            *((row.residual.value, row.residual.rate, row.residual.bias) for row in rows),
            strict=True,
        )
        multipliers = self.constrain(equations, *(ca.vertcat(*column) for column in columns))
        self.closing[joint.name] = Closing(joint, rows, multipliers)
        return joint.shown(multipliers)

    def fixed(self, name: str, parent: Body, child: Body) -> None:
        """Weld two bodies together."""
        self.add(joints.Fixed(name, parent, child))

    def prismatic(
        self, name: str, parent: Body, child: Body, axis: Vector, at: Vector = _NONE
    ) -> ca.SX:
        """Let a body slide along an axis; return the distance (m), positive if the child moves along ``axis``."""
        return self.add(joints.Prismatic(name, parent, child, at, axis))

    def revolute(self, name: str, parent: Body, child: Body, at: Vector, axis: Vector) -> ca.SX:
        """Let a body rotate about an axis; return the angle (rad), right-handed about ``axis`` from parent to child."""
        return self.add(joints.Revolute(name, parent, child, at, axis))

    def cylindrical(self, name: str, parent: Body, child: Body, at: Vector, axis: Vector) -> ca.SX:
        """Let a body slide along an axis and rotate about it; return distance (m) and angle (rad)."""
        return self.add(joints.Cylindrical(name, parent, child, at, axis))

    def screw(
        self, name: str, parent: Body, child: Body, at: Vector, axis: Vector, pitch: Number
    ) -> ca.SX:
        """Let a body turn on a thread; return the angle (rad). A turn advances ``pitch`` (m, not 0) along ``axis``."""
        return self.add(joints.Screw(name, parent, child, at, axis, pitch))

    def universal(
        self, name: str, parent: Body, child: Body, at: Vector, axis: Vector, second_axis: Vector
    ) -> ca.SX:
        """Add a cross of two perpendicular axes, the first on ``parent``; return the angles about them (rad)."""
        return self.add(joints.Universal(name, parent, child, at, axis, second_axis))

    def spherical(self, name: str, parent: Body, child: Body, at: Vector) -> ca.SX:
        """Let a body rotate about a point; return the quaternion of its orientation relative to the ground."""
        return self.add(joints.Spherical(name, parent, child, at))

    def link(
        self, name: str, parent: Body, child: Body, at: Vector, axis: Vector, second_at: Vector
    ) -> ca.SX:
        """Connect two bodies by a massless link, on a hinge of the first and a ball joint of the second.

        Parameters
        ----------
        name : str
            Its name.
        parent, child : Body
            The bodies.
        at, axis : sequence of float, shape (3,)
            A point of the hinge (m) and its direction, on the first body.
        second_at : sequence of float, shape (3,)
            The ball joint on the second body, m, not on the hinge's axis.

        Returns
        -------
        casadi.SX
            For a tree joint: angle of the hinge (rad) and quaternion of the child body relative to the ground.
        """
        return self.add(joints.Link(name, parent, child, at, axis, second_at))

    def free(
        self, name: str, child: Body, at: Vector | None = None, moving_frame: Body | None = None
    ) -> ca.SX:
        """Let a body move freely: position (m, from the design pose) and quaternion, in the ground or moving axes."""
        self._check(name, child)
        if child.mass_properties is None and at is None:
            raise AssemblyError(
                "a free body without mass", where=child.name, hint="Give mass and centre_of_mass."
            )
        centre = child.mass_properties.centre if child.mass_properties is not None else _NONE
        return self.add(
            joints.Free(name, moving_frame or self.ground, child, centre if at is None else at)
        )

    def driven(
        self, name: str, parent: Body, child: Body, axis: Vector, travel: Track | Number
    ) -> None:
        """Let a body slide along an axis by a prescribed travel (m): a track or a parameter."""
        self.add(joints.Driven(name, parent, child, axis, travel))

    @all_or_nothing
    def coincident(
        self, name: str, first: Body, second: Body, at: Vector, second_at: Vector | None = None
    ) -> ca.SX:
        """Keep a point of one body on a point of another; return the force on the second (N, ground axes)."""
        if second_at is None:
            self._require_placed(name, first, second)
            at = second_at = self.vector(f"{name}.at", at)
        return self.add(joints.PointToPoint(name, first, second, at, second_at))

    def rod(
        self,
        name: str,
        first: Body,
        second: Body,
        at: Vector,
        second_at: Vector,
        length: Number | None = None,
    ) -> ca.SX:
        """Keep two points at a distance: a massless rod between two ball joints.

        Parameters
        ----------
        name : str
            Its name.
        first, second : Body
            The bodies.
        at, second_at : sequence of float, shape (3,)
            The points in the design pose, m.
        length : float, optional
            m; by default the distance in the design pose.

        Returns
        -------
        casadi.SX
            Force of the rod, N, tension positive.
        """
        return self.add(joints.Rod(name, first, second, at, second_at, length))

    def point_on_line(
        self, name: str, first: Body, second: Body, at: Vector, axis: Vector, point: Vector
    ) -> ca.SX:
        """Keep a point of the second body on a line of the first; return the two forces across the line (N)."""
        return self.add(joints.PointOnLine(name, first, second, at, axis, point))

    def perpendicular(
        self, name: str, first: Body, second: Body, axis: Vector, second_axis: Vector
    ) -> ca.SX:
        """Keep two directions at right angles; return the constraint torque (N m)."""
        return self.add(joints.Perpendicular(name, first, second, axis, second_axis))

    def parallel(self, name: str, first: Body, second: Body, axis: Vector) -> ca.SX:
        """Keep a direction of each body parallel to the other's; return the two constraint torques (N m)."""
        return self.add(joints.Parallel(name, first, second, axis))

    def coupler(self, name: str, expression: ca.SX) -> ca.SX:
        """Keep a linear combination of coordinates at zero, such as ``rack - radius * pinion``; return its force."""
        value = self.poses.resolve(expression_of(expression, name))
        if any(ca.which_depends(value, self.collection.q, 2)):
            hint = "Use condition() for nonlinear expressions."
            raise AssemblyError(
                "not a linear combination of coordinates", where=name, found=str(value), hint=hint
            )
        return self._condition(name, "coupler", expression)

    def motion(self, name: str, coordinate: ca.SX, track: Track) -> ca.SX:
        """Drive a coordinate (m or rad) along a prescribed input; return the required force or torque."""
        self._check_track(name, track)
        return self._condition(name, "motion", expression_of(coordinate, name) - track.value)

    def condition(self, name: str, expression: ca.SX) -> ca.SX:
        """Keep any expression of coordinates, points of bodies and tracks at zero; return its multiplier."""
        return self._condition(name, "condition", expression)

    @all_or_nothing
    def _condition(self, name: str, kind: str, expression: ca.SX) -> ca.SX:
        expression = self._check_expression(name, expression)
        placed = self._require_unused(name, (*self.hanging, *self.closing, *self.conditions))
        value = self.poses.resolve(expression)
        rate = self.rate_of(value)
        multiplier = self.constrain(
            [Equation(placed, placed, "")], value, rate, self.collection.bias_of(rate)
        )
        self.conditions[placed] = LoopExpression(placed, kind, expression), multiplier
        return multiplier

    def _check_track(self, name: str, track: object) -> None:
        """Refuse anything but a track of this mechanism."""
        if all(track is not known for known in self.collection.tracks.values()):
            named = track.value if isinstance(track, Track) else track
            text, hint = (
                str(named),
                "Use the track returned by mechanism.track(name); call it once per name.",
            )
            raise AssemblyError("not a track of this mechanism", where=name, found=text, hint=hint)

    def _check_expression(self, name: str, expression: ca.SX) -> ca.SX:
        """Refuse anything but one expression of coordinates, such as the force of a closing joint."""
        expression = expression_of(expression, check_name(name))
        if expression.shape != (1, 1):
            hint = "Use one of them, such as joint[0]; a closing joint returns its forces and has no coordinate."
            raise AssemblyError(
                "more than one coordinate",
                where=name,
                found=f"{expression.shape[0]} expressions",
                hint=hint,
            )
        self._check_moves(name, expression, "not a condition on coordinates", self.collection.q)
        return expression

    def _check_moves(
        self, name: str, expression: ca.SX, text: str, moving: ca.SX, also: Sequence[ca.SX] = ()
    ) -> None:
        """Refuse symbols except coordinates, parameters, tracks and ``also``, and expressions without ``moving``."""
        expression = self.poses.resolve(expression)
        strange = self._strange_in(expression, also)
        if strange or not ca.depends_on(expression, moving):
            symbols = (
                f"an expression of {', '.join(strange)}"
                if strange
                else "an expression of no coordinate"
            )
            hint = "Add the driven joint before the joint that closes the loop." if strange else ""
            raise AssemblyError(text, where=name, found=symbols, hint=hint)

    def _strange_in(self, expression: ca.SX, also: Sequence[ca.SX]) -> list[str]:
        """Return symbols other than this mechanism's coordinates, parameters or tracks, such as another mechanism's."""
        given = [*also, *self.collection.coordinates.values(), *self.collection.parameters.values()]
        given += [symbol for symbol, _ in self.collection.constants.values()]
        for track in self.collection.tracks.values():
            given += [track.value, track.rate, track.acceleration]
        known = {symbol.element_hash() for symbol in given} | self.poses.named.keys()
        return [
            symbol.name() for symbol in ca.symvar(expression) if symbol.element_hash() not in known
        ]

    def _check(self, name: str, *bodies: Body) -> None:
        """Refuse other types, bodies of a different mechanism, and the same body twice."""
        check_name(name)
        for body in bodies:
            if not isinstance(body, Body):
                kind = body if isinstance(body, str) else type(body).__name__
                hint = "Use a body returned by mechanism.body(name), or mechanism.ground."
                raise AssemblyError("not a body", where=name, found=kind, hint=hint)
            if self.bodies.get(body.name) is not body:
                raise AssemblyError(
                    "the body belongs to a different mechanism", where=name, found=body.name
                )
        if len(bodies) == 2 and bodies[0] is bodies[1]:
            raise AssemblyError(
                "a body cannot be joined to itself", where=name, found=bodies[0].name
            )

    def _require_placed(self, name: str, *bodies: Body) -> None:
        """Refuse bodies that no joint connects to the tree."""
        self._check(name, *bodies)
        for body in bodies:
            if not body.is_placed:
                hint = "Give the joint that carries it first."
                raise AssemblyError(
                    "the body has no joint yet", where=name, found=body.name, hint=hint
                )
        self._refuse_apart(name, *bodies)

    def _refuse_apart(self, name: str, *bodies: Body) -> None:
        """Refuse bodies in different moving frames."""
        carriers = {body.name: body.carrier for body in bodies if body.is_placed}
        if len(set(map(id, carriers.values()))) > 1:
            hint = "Connect bodies in a moving frame to that frame, not to its body or the ground."
            names = ", ".join(carriers)
            raise AssemblyError(
                "the bodies belong to different moving frames", where=name, found=names, hint=hint
            )

    def _refuse_moving(self, name: str, *bodies: Body) -> None:
        """Refuse bodies in moving frames, for parts that need ground axes."""
        for body in bodies:
            if body.carrier.moves:
                raise AssemblyError(
                    "not available for bodies in a moving frame", where=name, found=body.name
                )

    # loads -----------------------------------------------------------------------------------------------------

    @all_or_nothing
    def act(self, load: ForceElement) -> Action:
        """Add a load of any class; ``shown`` of the returned action is the result for the caller."""
        if not isinstance(load, ForceElement):
            raise AssemblyError(
                "not a load",
                where="act",
                found=type(load).__name__,
                hint="Use one of the builder's methods.",
            )
        if any(
            "read" in each.metadata for each in fields(load)
        ):  # its numbers become parameters by its name
            check_name(load.name, load.kind)
        ends = ("first", "second", "body")
        bodies = [
            value for key, value in vars(load).items() if isinstance(value, Body) or key in ends
        ]
        self._require_placed(load.name or load.kind, *bodies)
        described = load.with_symbols(self)
        self._check_numbers([described], self.values)
        action = described.action(self)
        self._check_laws(load.name or load.kind, action.power)
        self.collection.loads.extend(action.power)
        self.loads.append((replace(described, name=self.name_at_place(load.name)), action))
        return action

    def _check_laws(self, name: str, power: Iterable[tuple[ca.SX, ca.SX]]) -> None:
        """Refuse forces that depend on anything this mechanism does not know before its equations are solved."""
        every, moving = self.collection, [*self.collection.speeds.values()]
        moving += [state for state, _ in every.internal.values()] + [
            mode for mode, _ in every.switches.values()
        ]
        strange = self._strange_in(
            ca.SX(ca.veccat(*(part for pair in power for part in pair))), moving
        )
        if strange:
            symbols = f"an expression of {', '.join(strange)}"
            hint = (
                "The expression may depend on coordinates, speeds, points, tracks and states of its "
                "mechanism, but not on reactions."
            )
            raise AssemblyError(
                "a force that cannot be computed", where=name, found=symbols, hint=hint
            )

    def force(self, along: ca.SX, magnitude: ca.SX | float | str) -> None:
        """Apply a force (N, N m) along an expression (m, rad) of coordinates and points of bodies.

        ``along`` is the expression and ``magnitude`` the force. They may be vectors, such as a point of a body and a
        force in ground axes.
        """
        along = expression_of(along, "force")
        length = self._length_of(along)
        magnitude = expression_of(magnitude, "magnitude of force", "N" if length == "m" else "N*m")
        if along.shape != magnitude.shape:
            count = f"{magnitude.numel()} along {along.numel()} expressions"
            raise AssemblyError(
                "the numbers of forces and expressions must be equal",
                where="force",
                found=count,
                allowed="one for each",
            )
        moving = [self.collection.q, *(track.value for track in self.collection.tracks.values())]
        text, modes = (
            "the expression moves no part of this mechanism, so a force along it has no effect",
            self.collection.switches.values(),
        )
        self._check_moves("force", along, text, ca.vertcat(*moving), [mode for mode, _ in modes])
        self.act(loads.GeneralForce("", length, along, magnitude))

    def load(self, rate: ca.SX, magnitude: ca.SX) -> None:
        """Add a force whose power is ``magnitude * rate``; both may be vectors.

        Reactions include it only if it acts on coordinates; ``force`` and ``apply_force`` also act on points.
        """
        rate, magnitude = (
            expression_of(rate, "rate of load"),
            expression_of(magnitude, "magnitude of load", "N"),
        )
        if rate.shape != magnitude.shape:
            count = f"{magnitude.numel()} on {rate.numel()} rates"
            raise AssemblyError(
                "the numbers of forces and rates must be equal",
                where="load",
                found=count,
                allowed="one for each",
            )
        self.act(loads.PowerOnRate("", rate, magnitude))

    def apply_force(
        self,
        body: Body,
        force: ca.SX | Sequence[float | str],
        point: Moving | ca.SX | Sequence[float | str],
    ) -> None:
        """Apply a force (N, ground axes) to a point of a body, given by ``body.point`` or its design position (m).

        For a body in a moving frame, use that frame's axes for force and point.
        """
        self._require_moving("force", body)
        where = f"force on {body.name}"
        place = self._point_of(body, point, where)
        self.act(loads.PointForce("", body, vector_of(force, where, "N"), place))

    def apply_torque(self, body: Body, torque: ca.SX | Sequence[float | str]) -> None:
        """Apply a torque (N m, ground axes or those of its moving frame) to a body."""
        self._require_moving("torque", body)
        self.act(loads.Torque("", body, vector_of(torque, f"torque on {body.name}", "N*m")))

    def push_apart(
        self,
        first: Body,
        second: Body,
        at: Moving | ca.SX | Sequence[float | str],
        second_at: Moving | ca.SX | Sequence[float | str],
        force: ca.SX | float | str,
    ) -> None:
        """Apply a force (N) that pushes two points apart along the line between them.

        ``at`` on the first body and ``second_at`` on the second are points or design positions (m), as for
        ``apply_force``.
        """
        name = loads.PushApart.kind
        self._require_placed(name, first, second)
        start, end = self._point_of(first, at, name), self._point_of(second, second_at, name)
        self.act(loads.PushApart("", first, second, start, end, self._law(name, force, "N")))

    def _require_moving(self, name: str, body: Body) -> None:
        """Refuse the ground and bodies that no joint connects to the tree."""
        self._require_placed(name, body)
        if body is self.ground:
            raise AssemblyError(
                "the ground does not move", where=name, hint="Name the body that it acts on."
            )

    def _point_of(
        self, body: Body, point: Moving | ca.SX | Sequence[float | str], where: str
    ) -> Moving:
        """Return the point of a body at a design position, or a given point; refuse points of other bodies."""
        if not isinstance(point, Moving):
            design = self.poses.require_still(vector_of(point, where), where)
            point = body.frame.point(design)
            return BodyPoint(point.value, point.rate, point.bias, body, design)
        owners = (
            {point.body}
            if isinstance(point, BodyPoint)
            else {named.body for named in self.poses.occurring(point.value)}
        )
        if owners and body not in owners:
            names = ", ".join(
                owner.name
                if self.bodies.get(owner.name) is owner
                else f"{owner.name} of another mechanism"
                for owner in owners
            )
            hint = Phrase(
                "Use a point of {name}, or push_apart() between two bodies.", name=body.name
            )
            raise AssemblyError("a point of a different body", where=where, found=names, hint=hint)
        return point

    def _law(self, where: str, law: ca.SX | float | str, unit: str) -> ca.SX:
        """One expression."""
        result = expression_of(law, where, unit)
        if result.shape != (1, 1):
            raise AssemblyError(
                "a single expression is required",
                where=where,
                found=f"{result.numel()} expressions",
                allowed="one",
            )
        return result

    def _own_law(
        self, name: str, law: ca.SX | float | str, unit: str, **beside: Number | None
    ) -> ca.SX:
        """Return a user-defined law; refuse numbers of the standard law beside it, which would have no effect."""
        set_numbers = {key: number for key, number in beside.items() if number is not None}
        given = [
            key for key, number in set_numbers.items() if isinstance(number, ca.SX) or number != 0.0
        ]
        if given:
            hint = "Include them in the law, or omit the law."
            raise AssemblyError(
                "a user-defined law takes no other numbers",
                where=name,
                found=", ".join(given),
                hint=hint,
            )
        return self._law(name, law, unit)

    def spring_damper(
        self,
        name: str,
        first: Body,
        second: Body,
        at: Vector,
        second_at: Vector,
        *,
        stiffness: Number = 0.0,
        damping: Number = 0.0,
        free_length: Number | None = None,
        force: ca.SX | None = None,
    ) -> tuple[ca.SX, ca.SX]:
        """Add a spring and damper between two points; return its length (m) and force (N, compression positive).

        Parameters
        ----------
        name : str
            Its name.
        first, second : Body
            Bodies that it pushes apart.
        at, second_at : sequence of float, shape (3,)
            Its ends in the design pose, m.
        stiffness : float
            N/m.
        damping : float
            N s/m.
        free_length : float, optional
            m; by default the length in the design pose.
        force : casadi.SX, optional
            A user-defined law instead of stiffness and damping, N, positive in compression.

        Returns
        -------
        tuple of casadi.SX
            Length and force.
        """
        law = loads.SpringDamper(
            name, first, second, at, second_at, free_length, stiffness, damping
        )
        if force is not None:
            own = self._own_law(
                name, force, "N", stiffness=stiffness, damping=damping, free_length=free_length
            )
            law = replace(law, free_length=None, stiffness=None, damping=None, force=own)
        length, pushing = self.act(law).shown
        return length, pushing

    def rotational_spring_damper(
        self,
        name: str,
        joint: str,
        *,
        stiffness: Number = 0.0,
        damping: Number = 0.0,
        free_angle: Number = 0.0,
        torque: ca.SX | None = None,
    ) -> ca.SX:
        """Add a spring and damper on the angle of a joint of the tree; return its torque (N m).

        Parameters
        ----------
        name : str
            Its name.
        joint : str
            Name of a joint with the coordinate ``<joint>.angle``.
        stiffness : float
            N m/rad.
        damping : float
            N m s/rad.
        free_angle : float
            Angle without torque, rad.
        torque : casadi.SX, optional
            A user-defined law (use ``coordinate_named`` and ``rate_of``), N m, positive along the angle.

        Returns
        -------
        casadi.SX
            Torque along the angle.
        """
        turning = {
            text: f"{text}.angle"
            for text, hung in self.hanging.items()
            if f"{text}.angle" in hung.coordinates
        }
        if check_name(joint, name) not in turning:
            raise unknown(joint, turning, what="joint with an angle in the tree", where=name)
        angle = self.collection.coordinates[turning[joint]]
        law = loads.RotationalSpringDamper(name, joint, angle, stiffness, free_angle, damping)
        if torque is not None:
            own = self._own_law(
                name, torque, "N*m", stiffness=stiffness, damping=damping, free_angle=free_angle
            )
            law = replace(law, stiffness=None, free_angle=None, damping=None, torque=own)
        return self.act(law).shown[0]

    def stop(
        self,
        name: str,
        coordinate: ca.SX,
        *,
        lower: Number | None = None,
        upper: Number | None = None,
        stiffness: Number,
        damping: Number = 0.0,
    ) -> ca.SX:
        """Add elastic stops at the ends of a coordinate's travel; return their force or torque on it (N or N m).

        Parameters
        ----------
        name : str
            Its name.
        coordinate : casadi.SX
            Coordinate returned by a joint, such as an angle or distance, or an expression of these and of body points.
        lower, upper : float, optional
            Positions of contact, m or rad.
        stiffness : float
            N/m or N m/rad.
        damping : float
            N s/m or N m s/rad while in contact; a stop never pulls, which limits the damping force.
        """
        coordinate = self._check_expression(name, coordinate)
        length = self._length_of(coordinate)
        return self.act(
            loads.Stop(name, length, coordinate, stiffness, damping, lower, upper)
        ).shown[0]

    def friction(
        self, name: str, coordinate: ca.SX, force: Number, *, regularisation_rate: Number = 2e-3
    ) -> ca.SX:
        """Add Coulomb friction on a coordinate; return the force or torque on it (N or N m).

        Parameters
        ----------
        name : str
            Its name.
        coordinate : casadi.SX
            Coordinate returned by a joint, such as an angle or distance.
        force : float
            N or N m, independent of the joint's load.
        regularisation_rate : float
            m/s or rad/s: below about this rate the force changes sign smoothly, so a joint that should stick creeps.
        """
        coordinate = self._check_expression(name, coordinate)
        law = loads.CoordinateFriction(
            name, self._length_of(coordinate), coordinate, regularisation_rate, force
        )
        return self.act(law).shown[0]

    def _length_of(self, expression: ca.SX) -> str:
        """Return ``rad`` for an expression of angles only, ``m`` otherwise."""
        units = {self.collection.units.get(symbol.name()) for symbol in ca.symvar(expression)} - {
            None
        }
        return "rad" if units == {"rad"} and not self.poses.occurring(expression) else "m"

    # watched outputs -------------------------------------------------------------------------------------------

    def watch_point(self, name: str, body: Body, at: Vector) -> None:
        """Add channels of a point of a body: ``<name>.x, .vx, .ax`` and so on, ground axes (m, m/s, m/s^2)."""
        self._check(name, body)
        self._refuse_moving(name, body)
        self._see(outputs.WatchedPoint(name, body, at))

    def watch_body(self, body: Body) -> None:
        """Add channels of a body, in ground axes.

        These are its centre of mass as a point, its angular velocity ``<body>.wx`` (rad/s) and acceleration
        ``.alpha_x`` (rad/s^2), and its rotation from the design pose: quaternion ``.q0`` to ``.q3`` (1; the scalar part
        ``q0`` is never negative) and ``.roll``, ``.pitch``, ``.yaw`` (rad), rotations about the ground's z axis (yaw),
        then the new y axis (pitch), then the new x axis (roll), as in ISO 8855.
        """
        self._check("watch_body", body)
        if body.mass_properties is None or not body.is_placed:
            raise AssemblyError("a body without mass or joint has no outputs", where=body.name)
        self._refuse_moving(body.name, body)
        self._see(outputs.WatchedBody(body.name, body, body.mass_properties.centre))

    def watch_angle(self, name: str, first: Body, second: Body, axis: Vector) -> None:
        """Add the angle between two bodies as channels: ``<name>`` (rad), ``<name> rate``, ``<name> acceleration``.

        Parameters
        ----------
        name : str
            Its name.
        first, second : Body
            The rotation of ``second`` is measured relative to ``first``.
        axis : sequence of float, shape (3,)
            Fixed to the first body, given in the design pose. The angle is right-handed about it, from -pi to pi, and
            zero in the design pose. If the second body also tilts, it is the rotation seen along the axis.
        """
        self._require_placed(name, first, second)
        self._see(outputs.WatchedAngle(name, first, second, axis))

    def watch_coordinates(self) -> None:
        """Add channels of all coordinates and speeds, with accelerations.

        A distance (m) or angle (rad) has ``<name> rate`` and ``<name> acceleration``; an orientation has its
        quaternion ``<joint>.e0`` to ``.e3`` and its angular velocity ``<joint>.wx`` to ``.wz`` (rad/s, body axes).
        """
        self._see(outputs.WatchedCoordinates("coordinates"))

    @all_or_nothing
    def watch_reaction(
        self, joint: str, frame: str = "ground", *, at: Vector | None = None, on: str | None = None
    ) -> None:
        """Add a joint's reaction as channels: ``<joint>.fx`` to ``.tz``, N and N m.

        Parameters
        ----------
        joint : str
            A joint of the tree, a closure, or a condition, coupler or motion. Later additions are included.
        frame : str
            ``"ground"``, or the name of a body whose axes are used.
        at : sequence of float, shape (3,), optional
            Reference point of the torque: its position in the design pose (m) on the body with the reaction. By
            default the joint's position; for a closure its point on the second body.
        on : str, optional
            Body on which the reaction acts. By default the joint's second body; for a condition the last-added body
            among those it acts on.
        """
        known = [*self.joints, *self.closures, *self.conditions]
        if check_name(joint, "reaction") not in known:
            raise unknown(joint, known, what="joint", where="reaction")
        for body in (frame, *([] if on is None else [on])):
            if check_name(body, f"reaction of {joint}") not in self.bodies:
                raise unknown(body, self.bodies, what="body", where=f"reaction of {joint}")
        key = f"reaction of {joint}"
        watched = self.watched.get(key)
        if isinstance(watched, outputs.WatchedReaction):
            if (
                watched.on == on
                and watched.frame is self.bodies[frame]
                and watched.at is None
                and at is None
            ):
                return
            hint = "Watch the reaction of each joint only once: in one frame, at one point and on one body."
            raise AssemblyError("the reaction is watched twice", where=key, hint=hint)
        place = None if at is None else self.vector(f"{joint}.reaction_at", at)
        self.watched[key] = outputs.WatchedReaction(joint, on, self.bodies[frame], place)

    def watch_energy(self) -> None:
        """Add energies (J) and loop residuals as channels.

        ``energy.kinetic``, ``energy.weight`` and, if there are any, ``energy.elastic`` of springs and stops,
        ``energy.dissipated`` by dampers, stops and friction and ``energy.supplied`` by motions since the start.
        User-defined laws and bushings are not included. With loops, ``energy.balance`` is the kinetic energy minus the
        work of all forces: constant except for numerical errors. ``constraint.residual`` is in m and rad.
        """
        self._see(outputs.WatchedEnergy("energy"))

    @all_or_nothing
    def _see(self, watch: OutputDescription) -> None:
        """Add an output; add coordinates and energies only once."""
        key = (
            watch.kind
            if watch.name == watch.kind
            else f"{watch.kind} of {self.name_at_place(watch.name)}"
        )
        if key in self.watched and watch.name != watch.kind:
            raise AssemblyError("the name is used twice", where=self.name_at_place(watch.name))
        described = watch.with_symbols(self)
        self.watched[key] = replace(
            described,
            name=described.name
            if described.name == described.kind
            else self.name_at_place(described.name),
        )
        self._refuse_clashes()

    def _refuse_clashes(self) -> None:
        """Refuse a point, body or angle whose channel names are those of watched coordinates."""
        if not any(
            isinstance(watch, outputs.WatchedCoordinates) for watch in self.watched.values()
        ):
            return
        turning = {
            watch.name for watch in self.watched.values() if isinstance(watch, outputs.WatchedAngle)
        }
        places = {
            watch.name for watch in self.watched.values() if isinstance(watch, outputs.WatchedPoint)
        }
        clashing = [
            name
            for name, hung in self.hanging.items()
            if name in places and hung.joint.has_quaternion
        ]
        clashing += sorted(turning & set(self.collection.coordinates))
        if clashing:
            text = "its coordinates have the same signal names as a watched body or point"
            hint = "Give the joint a name that differs from all watched bodies and points."
            raise AssemblyError(text, where=", ".join(clashing), hint=hint)

    def reaction(self, joint: str, on: str | None = None) -> Reaction:
        """Return force (N) and torque (N m) of a joint, closure or condition in ground axes; for outputs only.

        They refer to the joint (for a closure, to its point on the second body) and act on the body ``on``, by default
        the joint's second body. A motion, coupler or condition on a coordinate is transmitted by the coordinate's joint
        and included there; springs, dampers, stops, friction and forces on it are not. Call this after all forces and
        joints have been added.
        """
        return reaction_of(self.complete(), joint, on)

    def kinetic_energy(self) -> ca.SX:
        """Return the kinetic energy of all bodies, J."""
        return outputs.kinetic_energy(self.bodies.values())

    def weight_energy(self) -> ca.SX:
        """Return the potential energy of all weights, J, zero in the design pose."""
        return outputs.weight_energy(self.bodies.values(), self.gravity)

    # listing and values --------------------------------------------------------------------------------------------

    def to_dict(self, values: Mapping[str, float | str] | None = None) -> dict[str, Any]:
        """List bodies, joints, loops, conditions, loads and outputs, with their numbers.

        Parameters
        ----------
        values : mapping, optional
            Parameter path to value (SI, or text with a unit); replaces or extends the values as built.

        Returns
        -------
        dict
            Plain data (SI) ready for JSON; None for unknown numbers.
        """
        given = values or {}
        nothing = {
            path: value
            for path, value in given.items()
            if isinstance(value, float) and not np.isfinite(value)
        }
        numbers = self.with_values(
            {path: 0.0 if path in nothing else value for path, value in given.items()}
        )
        return listing.as_data(self, numbers | nothing, self.watched.values())

    def with_values(self, values: Mapping[str, float | str]) -> dict[str, float]:
        """Return the value of every parameter by path; ``values`` (SI, or text with a unit) replace those as built."""
        for path in values:
            if check_name(path, "values") not in self.parameters:
                raise unknown(path, self.parameters, what="parameter", where="values")
        units = self.units
        given = {
            path: to_si(value, units.get(path, "1"), where=f"values: {path}")
            for path, value in values.items()
        }
        return self.values | given

    def check_values(self, values: Mapping[str, float]) -> None:
        """Refuse ``values`` (SI) of parameters that no body, joint or load of this mechanism can have."""
        for name, body in self.mass_values(values).items():
            check_inertia(name, *body)
        joints_ = [
            *(hung.joint for hung in self.hanging.values()),
            *(closed.joint for closed in self.closing.values()),
        ]
        self._check_numbers(
            [*joints_, *(load for load, _ in self.loads), *self.watched.values()], values
        )

    def _check_numbers(self, things: Iterable[NamedPart], values: Mapping[str, float]) -> None:
        """Run each description's own check of its numbers."""
        reading = listing.Reading(self, values)
        for each in things:
            each.check(reading.numbers_of(each))
            for axis in (
                field.name for field in fields(each) if field.metadata.get("read") == "direction"
            ):
                numbers = reading.numbers(getattr(each, axis))
                if numbers is not None and not np.all(np.isfinite(numbers)):
                    where, hint = f"{each.name}.{axis}", "Its three numbers must not all be zero."
                    raise AssemblyError("an axis without direction", where=where, hint=hint)

    def __str__(self) -> str:
        return listing.as_text(self.to_dict())

    # the equations ---------------------------------------------------------------------------------------------

    def complete(self) -> Mechanism:
        """Return a copy that includes masses and weights of all bodies; later additions do not change the original."""
        whole = copy.copy(self)
        whole.collection, whole.loads, whole.watched = (
            self.collection.copy(),
            list(self.loads),
            dict(self.watched),
        )
        whole._scope = ("", "")
        carriers: dict[int, MovingCarrier] = {}
        for body in self.bodies.values():
            if not body.is_placed:
                raise AssemblyError(
                    "the body has no joint",
                    where=body.name,
                    hint="Give the body a joint, or free().",
                )
            properties, carrier = body.mass_properties, body.carrier
            if isinstance(carrier, MovingCarrier):
                carriers[id(carrier)] = carrier
            elif properties is not None:
                whole.inertia(RigidMass(body.frame, properties))
                weight = ca.vertcat(0.0, 0.0, -properties.mass * self.gravity)
                whole.act(loads.PointForce("", body, weight, body.frame.point(properties.centre)))
        for carrier in carriers.values():
            for group in _by_place(
                body for body in self.bodies.values() if body.carrier is carrier
            ):
                whole.inertia(CarriedMasses(carrier, [_to_carried(body) for body in group]))
        whole.collection.loops = self.loops()
        return whole

    def mass_matrix(self, model: Model) -> ca.Function:
        """Return the mass matrix (kg, kg m, kg m^2) of the speeds as a function of the model's x, u and p."""
        whole, v = self.complete(), self.collection.v
        matrix = sum(
            (inertia.matrix(v) for inertia in whole.collection.inertias),
            ca.SX(v.shape[0], v.shape[0]),
        )
        return ca.Function("mass", [model.x, model.u, model.p], [matrix])

    def generalised_force(self, model: Model) -> ca.Function:
        """Return the force of all loads on the speeds (N, N m) as a function of the model's x, u, p and m."""
        loads = _resolve(self.complete().collection, self.poses)
        return ca.Function("force", [model.x, model.u, model.p, model.m], [loads.force_on(loads.v)])

    def mobility(
        self,
        start: Mapping[str, float | str] | None = None,
        *,
        values: Mapping[str, float | str] | None = None,
        inputs: Mapping[str, float] | None = None,
    ) -> Mobility:
        """Count the degrees of freedom; name the motions and the over-constrained joints.

        Parameters
        ----------
        start : mapping, optional
            Coordinates (m, rad) by name, as for :func:`jounce.mechanics.assemble`: the pose at which to count.
        values : mapping, optional
            Parameter path to value (SI, or text with a unit); replaces the value as built.
        inputs : mapping, optional
            Track to its value (m, rad) at that pose; 0 by default.

        Returns
        -------
        Mobility
            Degrees of freedom, Grübler's count, redundant equations and the free motions; its ``str`` lists them.

        Raises
        ------
        AssemblyError
            If the loops cannot be closed, or the pose is singular: a count there would not apply nearby.

        Examples
        --------
        A rigid axle on four rods that are not parallel, and a Panhard rod: it cannot roll and rise independently.

        >>> import jounce as jn
        >>> linkage = jn.mechanics.Mechanism()
        >>> axle = linkage.body("axle", mass=80.0, centre_of_mass=(0.0, 0.0, 0.3), inertia=(10.0, 2.0, 10.0))
        >>> _ = linkage.free("axle", axle)
        >>> for side in (-1.0, 1.0):
        ...     low = {"at": (0.5, 0.5 * side, 0.25), "second_at": (0.0, 0.55 * side, 0.2)}
        ...     high = {"at": (0.4, 0.5 * side, 0.45), "second_at": (0.0, 0.2 * side, 0.42)}
        ...     _ = linkage.rod(f"lower {side:+g}", linkage.ground, axle, **low)
        ...     _ = linkage.rod(f"upper {side:+g}", linkage.ground, axle, **high)
        >>> _ = linkage.rod("Panhard", linkage.ground, axle, at=(-0.1, 0.5, 0.3), second_at=(-0.1, -0.5, 0.3))
        >>> linkage.mobility().degrees_of_freedom
        1
        """
        model = self._form_once(frozenset())
        p, u = self._numbers(model, self.with_values(values or {}), inputs or {})
        pose = assemble(model, p, u, start, redundant="keep")
        refuse_singular(model, pose.x, u, p)
        return self.freedoms(model).at(pose.x, u, p, pose.redundant)

    def freedoms(self, model: Model) -> Freedoms:
        """Return the counter of degrees of freedom for a model of this mechanism, created once per model."""
        with turn((id(self), "freedoms")):
            if id(model) not in self._counted:
                self._counted[id(model)] = Freedoms(
                    self, model, self.generalised_force(model)
                )  # keeps the model alive
            return self._counted[id(model)]

    def places(self, values: Mapping[str, float]) -> dict[str, Array]:
        """Return design positions (m, at parameter values) of bodies, joints, loads and watched parts by path."""
        reading = listing.Reading(self, values)
        every: list[NamedPart] = [hung.joint for hung in self.hanging.values()]
        every += [closed.joint for closed in self.closing.values()]
        every += [*(load for load, _ in self.loads), *self.watched.values()]
        given = [
            (f"{each.name}.{field.name}", getattr(each, field.name), field.metadata)
            for each in every
            for field in fields(each)
        ]
        vectors = {
            path: value
            for path, value, about in given
            if about.get("read") == "vector" and about["unit"] == "m"
        }
        masses = {
            name: body.mass_properties
            for name, body in self.bodies.items()
            if body.mass_properties is not None
        }
        vectors |= {f"{name}.centre_of_mass": mass.centre for name, mass in masses.items()}
        read = {
            path: reading.numbers(value)
            for path, value in vectors.items()
            if isinstance(value, ca.SX)
        }
        return {path: value for path, value in read.items() if value is not None}

    def finish(
        self,
        redundant: str = "keep",
        start: Mapping[str, float | str] | None = None,
        *,
        values: Mapping[str, float] | None = None,
        inputs: Mapping[str, float] | None = None,
    ) -> Model:
        """Form the equations of motion.

        Parameters
        ----------
        redundant : {"keep", "remove"}
            ``remove`` drops redundant loop equations at the pose assembled from ``start``; the force
            reported for a joint that lost equations is then only the share of its remaining ones.
        start : mapping, optional
            Coordinates (m, rad) by name, as for :func:`jounce.mechanics.assemble`.
        values : mapping, optional
            Parameter path to value (SI) for that pose; replaces the value as built.
        inputs : mapping, optional
            Track to its value (m, rad) at that pose; 0 by default.

        Returns
        -------
        Model
            The equations.
        """
        _check_choice(redundant, ("keep", "remove"))
        model = self._form(frozenset(), balance=False)
        if redundant == "remove" and model.constraints:
            dropped = removable(model, *self._numbers(model, values or {}, inputs or {}), start)
            return self._form(dropped, balance=False) if dropped else model
        return model

    def model(
        self,
        redundant: str = "refuse",
        start: Mapping[str, float | str] | None = None,
        *,
        values: Mapping[str, float] | None = None,
        inputs: Mapping[str, float] | None = None,
    ) -> Model:
        """Return the finished model for a run; form it again only if parts were added.

        Parameters
        ----------
        redundant : {"refuse", "remove"}
            As for ``finish``; ``refuse`` keeps all equations, and assembly reports redundant ones.
        start, values, inputs : mapping, optional
            SI, as for ``finish``.
        """
        _check_choice(redundant, ("refuse", "remove"))
        every = self._form_once(frozenset())
        if redundant != "remove" or not every.constraints:
            return every
        size = self._size()
        known = [
            key[0]
            for key in self._finished
            if key[1:] == size and isinstance(key[0], frozenset) and key[0]
        ]
        return self._form_once(
            removable(every, *self._numbers(every, values or {}, inputs or {}), start, known)
        )

    def _form_once(self, dropped: frozenset[str]) -> Model:
        """Return the model without the ``dropped`` loop equations, formed once."""
        key = (dropped, *self._size())
        with turn((id(self), key)):
            if key not in self._finished:
                self._finished[key] = self._form(dropped, balance=True)
            return self._finished[key]

    def _size(self) -> tuple[object, ...]:
        """Counts that grow with every part that is added."""
        each = (
            self.bodies,
            self.hanging,
            self.closing,
            self.conditions,
            self.loads,
            *vars(self.collection).values(),
        )
        return (
            *(len(part) for part in each if isinstance(part, dict | list)),
            *self.watched.values(),
        )

    def _form(self, dropped: frozenset[str], *, balance: bool) -> Model:
        """Form the equations without the ``dropped`` loop equations; optionally with the loops' energy balance."""
        whole = self.complete()
        if balance and whole.collection.constraints:
            whole.watch_balance()
        self._check_outputs()
        for watch in self.watched.values():
            watch.show(whole)
        return form(_resolve(whole.collection, self.poses), dropped)

    def _check_outputs(self) -> None:
        """Refuse outputs of symbols that this mechanism does not have."""
        every = self.collection
        given = [*every.speeds.values(), *every.accelerations.values()]
        given += [state for state, _ in every.internal.values()] + [
            mode for mode, _ in every.switches.values()
        ]
        given += [
            part
            for constraint in every.constraints
            for part in ca.vertsplit(constraint.multipliers)
        ]
        if not self._strange_in(ca.SX(ca.veccat(*every.outputs.values())), given):
            return
        for output, expression in every.outputs.items():
            strange = self._strange_in(expression, given)
            if strange:
                text = "the expression contains symbols that this mechanism does not have"
                raise AssemblyError(text, where=f"output {output.name}", found=", ".join(strange))

    def watch_balance(self) -> None:
        """Add the energy balance of the loops, which must stay constant. Unknown if a track moves a body."""
        is_driven = any(isinstance(hung.joint, joints.Driven) for hung in self.hanging.values())
        if is_driven and self.tracks:
            return
        power = outputs.total(ca.dot(rate, force) for rate, force in self.collection.loads)
        taken = self.internal_state(BALANCE)
        self.set_internal_rate(BALANCE, power + outputs.total(self.supplied_powers()))
        self.output(
            BALANCE,
            self.kinetic_energy() - taken,
            "J",
            "kinetic energy less the work of all forces",
        )

    def _numbers(
        self, model: Model, values: Mapping[str, float], inputs: Mapping[str, float]
    ) -> tuple[Array, Array]:
        """Return the values of a model's parameters and inputs."""
        every = self.with_values(values)
        for name in inputs:
            if name not in model.tracks:
                raise unknown(name, model.tracks, what="track", where="inputs")
        lacking = [name for name in model.parameters if name not in every]
        if lacking:
            raise AssemblyError(
                "some parameters have no value",
                where=", ".join(lacking),
                hint="Give the values of the parameters in values.",
            )
        u = np.zeros(model.u.shape[0])
        for i, name in enumerate(model.tracks):
            u[i * model.track_order] = to_si(inputs.get(name, 0.0), "1", where=f"inputs: {name}")
        return np.array([every[name] for name in model.parameters]), u


def _resolve(collection: Collection, poses: BodyFrames) -> Collection:
    """Replace all named points in expressions by their formulas from the joints."""
    loads = [part for pair in collection.loads for part in pair]
    rates = [rate for _, rate in collection.internal.values()]
    switches = [expression for _, expression in collection.switches.values()]
    parts = [
        *loads,
        *(rate for rate in rates if rate is not None),
        *switches,
        *collection.outputs.values(),
    ]
    named = poses.occurring(ca.veccat(*parts)) if parts else []
    if not named:
        return collection
    symbols, values = ([getattr(item, part) for item in named] for part in ("symbol", "value"))
    result = iter(ca.substitute(parts, symbols, values))
    return replace(
        collection,
        loads=[(next(result), next(result)) for _ in collection.loads],
        internal={
            name: (symbol, None if rate is None else next(result))
            for name, (symbol, rate) in collection.internal.items()
        },
        switches={name: (mode, next(result)) for name, (mode, _) in collection.switches.items()},
        outputs={output: next(result) for output in collection.outputs},
    )


def _check_choice(redundant: str, choices: tuple[str, ...]) -> None:
    if redundant not in choices:
        raise unknown(str(redundant), choices, what="choice", where="redundant")


def _by_place(bodies: Iterable[Body]) -> list[list[Body]]:
    """Group bodies with mass by the prefix of their names."""
    result: dict[str, list[Body]] = {}
    for body in bodies:
        if body.mass_properties is not None:
            result.setdefault(body.name.rpartition(".")[0], []).append(body)
    return list(result.values())


def _to_carried(body: Body) -> Carried:
    """Return a body with mass as seen from its moving axes."""
    assert body.mass_properties is not None
    properties, frame = body.mass_properties, body.frame
    alone = RigidMass(frame, properties)
    return Carried(
        properties.mass,
        frame.point(properties.centre),
        frame.orientation,
        properties.inertia,
        alone,
    )
