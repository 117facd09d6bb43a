"""Mechanisms in space: bodies, joints, loops and forces by name, in the ground axes of the design pose."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import AssemblyError, unknown
from jounce.mechanics.assembly import assemble, superfluous
from jounce.mechanics.bodies import Body, RigidMass
from jounce.mechanics.frames import Moving
from jounce.mechanics.model import Model
from jounce.mechanics.reactions import Reaction, kinetic_energy, tree_reaction, weight_energy
from jounce.mechanics.rotations import normals
from jounce.mechanics.system import Track
from jounce.mechanics.tree import Number, Tree, Vector

_NONE = ca.SX(3, 1)
_POINT = 1e-12  # m: a line shorter than that has no direction


class Mechanism(Tree):
    """A mechanism under construction: bodies, joints, loops, forces, outputs, then ``finish``.

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
    """

    def __init__(self, gravity: Number = 9.81) -> None:
        super().__init__()
        self.gravity = self.number("gravity", gravity, "m/s^2")
        self._settled: set[str] = set()
        self._watched: dict[str, Callable[[], None]] = {}
        self._stored: list[ca.SX] = []
        self._lost: list[ca.SX] = []
        self._supplied: list[ca.SX] = []
        self._finished: dict[tuple[object, ...], Model] = {}

    def apply_force(self, body: Body, force: ca.SX, point: Moving) -> None:
        """Let a force (N, ground axes) act on a point of a body, such as ``body.point(casadi.DM([0, 0, 1]))``."""
        self.load(point.rate, force)
        self.note(body, force, point.value)

    def apply_torque(self, body: Body, torque: ca.SX) -> None:
        """Let a torque (N m, ground axes) act on a body."""
        self.load(body.spin, torque)
        self.note(body, torque=torque)

    def push_apart(self, first: Body, second: Body, at: Moving, second_at: Moving, force: ca.SX) -> None:
        """Let a force (N) push two points apart along the line between them."""
        reach = second_at - at
        along = reach.value / _length(reach.value)
        self.load(ca.dot(along, reach.rate), force)
        for body, point, sign in ((first, at, -1.0), (second, second_at, 1.0)):
            self.note(body, sign * force * along, point.value)

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
        """Put a spring and damper between two points; give its length (m) and force (N, compression positive).

        Parameters
        ----------
        name : str
            Its name.
        first, second : Body
            The bodies it pushes apart.
        at, second_at : sequence of float, shape (3,)
            Its ends in the design pose, m.
        stiffness : float
            N/m.
        damping : float
            N s/m.
        free_length : float, optional
            m; by default the length in the design pose.
        force : casadi.SX, optional
            A law of your own in place of stiffness and damping, N, positive in compression.

        Returns
        -------
        tuple of casadi.SX
            Length and force.
        """
        self._held(name, first, second)
        places = self.vector(f"{name}.at", at), self.vector(f"{name}.second_at", second_at)
        ends = first.point(places[0]), second.point(places[1])
        reach = ends[1] - ends[0]
        length = _length(reach.value)
        if force is None:
            rate = ca.dot(reach.value, reach.rate) / length
            design = _length(places[1] - places[0])
            free = design if free_length is None else self.number(f"{name}.free_length", free_length, "m")
            force = self._spring_and_damper(
                self.number(f"{name}.stiffness", stiffness, "N/m"),
                length - free,
                self.number(f"{name}.damping", damping, "N*s/m"),
                rate,
            )
        self.push_apart(first, second, *ends, force)
        return length, force

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
        """Put a spring and damper on the angle of a revolute or cylindrical joint of the tree; give its torque (N m).

        Parameters
        ----------
        name : str
            Its name.
        joint : str
            The joint.
        stiffness : float
            N m/rad.
        damping : float
            N m s/rad.
        free_angle : float
            Angle without torque, rad.
        torque : casadi.SX, optional
            A law of your own (use ``coordinate_named`` and ``rate_of``), N m, positive along the angle.

        Returns
        -------
        casadi.SX
            Torque on the second body along the joint's axis.
        """
        if joint not in self._joints or f"{joint}.angle" not in self._coordinates:
            turning = [text for text in self._joints if f"{text}.angle" in self._coordinates]
            raise unknown(joint, turning, what="joint with an angle in the tree", where=name)
        angle = self._coordinates[f"{joint}.angle"]
        if torque is None:
            torque = self._spring_and_damper(
                self.number(f"{name}.stiffness", stiffness, "N*m/rad"),
                angle - self.number(f"{name}.free_angle", free_angle, "rad"),
                self.number(f"{name}.damping", damping, "N*m*s/rad"),
                self.rate_of(angle),
            )
        hung = self._joints[joint]
        assert hung.axis is not None
        along = hung.parent.direction(hung.axis).value * torque
        self.load(self.rate_of(angle), torque)
        self.note(hung.child, torque=along)
        self.note(hung.parent, torque=-along)
        return torque

    def _spring_and_damper(self, stiffness: ca.SX, stretch: ca.SX, damping: ca.SX, rate: ca.SX) -> ca.SX:
        """Force of a linear spring and damper against a stretch and its rate; its energies are kept account of."""
        self._stored.append(0.5 * stiffness * stretch**2)
        self._lost.append(damping * rate**2)
        return -stiffness * stretch - damping * rate

    def motion(self, name: str, coordinate: ca.SX, track: Track) -> ca.SX:
        """Drive a coordinate (m or rad) along a prescribed input; give the force or torque that it takes."""
        force = super().motion(name, coordinate, track)
        self._supplied.append(force * track.rate)
        return force

    def reaction(self, joint: str) -> Reaction:
        """Give force (N) and torque (N m) of a joint on its second body, in ground axes; for outputs only.

        They are given at the joint (for a closure, at its point on the second body). What drives a coordinate is
        counted as the joint's; springs, dampers and friction of a joint are not. Ask when all forces and joints are in.
        """
        self.settle()
        if joint in self._joints:
            hung = self._joints[joint]
            bodies = self._hanging(hung.child)
            wrenches = [wrench for wrench in self._wrenches if any(wrench.body is body for body in bodies)]
            found = tree_reaction(self, hung.child, bodies, wrenches)
            return found if not hung.reversed else Reaction(-found.force, -found.torque, found.point)
        own = [wrench for wrench in self._wrenches if wrench.joint == joint]
        if not own:
            raise unknown(joint, [*self._joints, *self.closures], what="joint", where="reaction")
        own = [wrench for wrench in own if wrench.body is own[0].body]
        at = next((wrench.point for wrench in own if wrench.force.nnz()), _NONE)
        torque = sum((w.torque + ca.cross(w.point - at, w.force) for w in own if w.force.nnz()), ca.SX(3, 1))
        torque += sum((w.torque for w in own if not w.force.nnz()), ca.SX(3, 1))
        return Reaction(sum((w.force for w in own), ca.SX(3, 1)), torque, at)

    def watch_point(self, name: str, body: Body, at: Vector) -> None:
        """Let a point of a body be seen: ``<name>.x, .vx, .ax`` and so on, ground axes (m, m/s, m/s^2)."""
        point = body.point(self.vector(f"{name}.place", at))
        acceleration = point.bias + self.accelerated(point.rate)
        for i, axis in enumerate("xyz"):
            self.output(f"{name}.{axis}", point.value[i], "m", f"{name}, {axis}")
            self.output(f"{name}.v{axis}", point.rate[i], "m/s", f"{name}, velocity along {axis}")
            self.output(f"{name}.a{axis}", acceleration[i], "m/s^2", f"{name}, acceleration along {axis}")

    def watch_body(self, body: Body) -> None:
        """Let a body be seen: its centre of mass, angular velocity (rad/s) and acceleration (rad/s^2), ground axes."""
        if body.mass_properties is None or body.frame is None:
            raise AssemblyError("a body without mass or joint has nothing to show", where=body.name)
        self.watch_point(body.name, body, body.mass_properties.centre)
        orientation = body.frame.orientation
        spin_rate = orientation.rotate(orientation.spin_bias + self.accelerated(orientation.spin))
        for i, axis in enumerate("xyz"):
            self.output(f"{body.name}.w{axis}", body.spin[i], "rad/s", f"{body.name}, angular velocity about {axis}")
            text = f"{body.name}, angular acceleration about {axis}"
            self.output(f"{body.name}.alpha_{axis}", spin_rate[i], "rad/s^2", text)

    def watch_angle(self, name: str, first: Body, second: Body, axis: Vector) -> None:
        """Let the turn of a body against another be seen: ``<name>`` (rad), ``<name> rate``, ``<name> acceleration``.

        Parameters
        ----------
        name : str
            Its name.
        first, second : Body
            The turn of the second is measured against the first.
        axis : sequence of float, shape (3,)
            Fixed to the first body, given in the design pose; the turn is right-handed about it, from -pi to pi, zero
            in the design pose. Where the second body also tilts, it is the turn seen along the axis.
        """
        self._held(name, first, second)
        across, sideways = normals(self.direction(f"{name}.axis", axis))
        turned = second.direction(across).value
        angle = ca.atan2(ca.dot(turned, first.direction(sideways).value), ca.dot(turned, first.direction(across).value))
        self._show(name, angle, self.rate_of(angle), self.acceleration_of(angle), "rad")

    def watch_coordinates(self) -> None:
        """Let all coordinates and speeds be seen, with accelerations.

        A distance (m) or angle (rad) comes with ``<name> rate`` and ``<name> acceleration``; an orientation as its
        quaternion ``<joint>.e0`` to ``.e3`` and its angular velocity ``<joint>.wx`` to ``.wz`` (rad/s, body axes).
        """
        self._watched["coordinates"] = self._show_coordinates

    def _show_coordinates(self) -> None:
        for name, symbol in self._coordinates.items():
            speed = f"{name} rate"
            if speed in self._speeds:
                unit = "rad" if name.endswith("angle") else "m"
                self._show(name, symbol, self._speeds[speed], self._accelerations[speed], unit)
            else:
                self.output(name, symbol, "1", f"{name}, quaternion")
        for name, symbol in self._speeds.items():
            if name.removesuffix(" rate") not in self._coordinates:
                self.output(name, symbol, "rad/s", f"{name}, angular velocity in the body's axes")

    def _show(self, name: str, value: ca.SX, rate: ca.SX, acceleration: ca.SX, unit: str) -> None:
        self.output(name, value, unit, name)
        self.output(f"{name} rate", rate, f"{unit}/s", f"{name}, rate")
        self.output(f"{name} acceleration", acceleration, f"{unit}/s^2", f"{name}, acceleration")

    def watch_reaction(self, joint: str, frame: str = "ground") -> None:
        """Let a joint's reaction on its second body be seen: ``<joint>.fx`` to ``.tz``, N and N m.

        Parameters
        ----------
        joint : str
            A joint of the tree or a closure. What is added to the mechanism later counts, too.
        frame : str
            ``"ground"``, or the name of a body whose axes are used.
        """
        if joint not in (*self._joints, *self.closures):
            raise unknown(joint, [*self._joints, *self.closures], what="joint", where="reaction")
        if frame not in self._bodies:
            raise unknown(frame, self._bodies, what="body", where=f"reaction of {joint}")
        self._watched[f"reaction of {joint}"] = lambda: self._show_reaction(joint, self._bodies[frame])

    def _show_reaction(self, joint: str, carrier: Body) -> None:
        found = self.reaction(joint)
        for symbol, vector, unit in (("f", found.force, "N"), ("t", found.torque, "N*m")):
            turned = self._frame_of(carrier).orientation.unrotate(vector)
            for i, axis in enumerate("xyz"):
                what = "force" if symbol == "f" else "torque"
                self.output(f"{joint}.{symbol}{axis}", turned[i], unit, f"{joint}, reaction {what} along {axis}")

    def watch_energy(self) -> None:
        """Let energies be seen (J), and what is left open of the loops.

        ``energy.kinetic``, ``energy.weight`` and, where there are such, ``energy.elastic`` of linear springs,
        ``energy.dissipated`` by linear dampers and ``energy.supplied`` by motions since the start. Forces by laws of
        your own and bushings are not among them. ``constraint.violation`` is in m and rad.
        """
        self._watched["energy"] = self._show_energy

    def _show_energy(self) -> None:
        self.output("energy.kinetic", self.kinetic_energy(), "J", "kinetic energy")
        self.output("energy.weight", self.weight_energy(), "J", "potential energy of the weights")
        self.output("constraint.violation", self.violation(), "m", "what is left open of the loops")
        if self._stored:
            self.output("energy.elastic", _total(self._stored), "J", "energy of the springs")
        for name, powers, text in (
            ("energy.dissipated", self._lost, "energy lost in dampers since the start"),
            ("energy.supplied", self._supplied, "energy put in by motions since the start"),
        ):
            if powers:
                taken = self._internal[name][0] if name in self._internal else self.internal_state(name)
                self.set_internal_rate(name, _total(powers))
                self.output(name, taken, "J", text)

    def kinetic_energy(self) -> ca.SX:
        """Kinetic energy of all bodies, J."""
        return kinetic_energy(self._bodies.values())

    def weight_energy(self) -> ca.SX:
        """Potential energy of the weights, J, zero in the design pose."""
        return weight_energy(self._bodies.values(), self.gravity)

    def violation(self) -> ca.SX:
        """Size of what is left open of all loops (m and rad)."""
        values = ca.vertcat(*(constraint.value for constraint in self._constraints))
        return ca.sqrt(ca.dot(values, values)) if values.numel() else ca.SX(0.0)

    @property
    def parameters(self) -> tuple[str, ...]:
        """Paths of all parameters."""
        return tuple(self._parameters)

    @property
    def tracks(self) -> tuple[str, ...]:
        """Names of all prescribed inputs."""
        return tuple(self._tracks)

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints of the tree, from the ground outwards."""
        return tuple(self._joints)

    @property
    def closures(self) -> tuple[str, ...]:
        """Names of what closes the loops."""
        return tuple(dict.fromkeys(wrench.joint for wrench in self._wrenches if wrench.source))

    def loops(self) -> dict[str, tuple[str, ...]]:
        """Joint that closes a loop to the joints around that loop, itself first."""
        ends: dict[str, dict[str, list[str]]] = {}
        for wrench in self._wrenches:
            if wrench.source:
                branches = ends.setdefault(wrench.joint, {})
                branches[wrench.body.name] = self._branch(wrench.body)
        found = {}
        for name, branches in ends.items():
            joints = [joint for branch in branches.values() for joint in branch]
            found[name] = (name, *(joint for joint in joints if joints.count(joint) == 1))
        return found

    def _branch(self, body: Body) -> list[str]:
        """Joints from the ground to a body."""
        for joint in self._joints.values():
            if joint.child is body:
                return [*self._branch(joint.parent), joint.name]
        return []

    def _hanging(self, root: Body) -> list[Body]:
        """A body and all that hangs on it."""
        found = [root]
        for joint in self._joints.values():
            if any(joint.parent is body for body in found):
                found.append(joint.child)
        return found

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
            ``remove`` leaves out loop equations that repeat others at the pose that ``start`` assembles to; the force
            that a joint without some of its equations shows is then only what the others leave for it.
        start : mapping, optional
            Coordinates (m, rad) by name, as for :func:`jounce.mechanics.assemble`.
        values : mapping, optional
            Parameter path to another value (SI) than it was built with, for that pose.
        inputs : mapping, optional
            Track to its value (m, rad) at that pose; 0 where it is not given.

        Returns
        -------
        Model
            The equations.
        """
        self.settle()
        self._dropped: frozenset[str] = frozenset()
        for show in self._watched.values():
            show()
        model = super().finish()
        if redundant == "remove" and model.constraints:
            every = {**self.values, **(values or {})}
            p = np.array([every[name] for name in model.parameters])
            u = np.zeros(model.u.shape[0])
            for i, name in enumerate(model.tracks):
                u[i * model.track_order] = (inputs or {}).get(name, 0.0)
            pose = assemble(model, p, u, start, redundant="keep").x
            self._dropped = frozenset(superfluous(model, p, u, pose))
            model = super().finish() if self._dropped else model
        return model

    def model(
        self,
        redundant: str = "refuse",
        start: Mapping[str, float | str] | None = None,
        *,
        values: Mapping[str, float] | None = None,
        inputs: Mapping[str, float] | None = None,
    ) -> Model:
        """Give the finished model, formed anew only when something was added.

        Parameters
        ----------
        redundant : {"refuse", "remove"}
            As for ``finish``; ``refuse`` keeps all equations, and assembly says when they repeat each other.
        start, values, inputs : mapping, optional
            SI, as for ``finish``.
        """
        way = "remove" if redundant == "remove" else "keep"
        if self._size(way) not in self._finished:
            model = self.finish(way, start, values=values, inputs=inputs)
            self._finished[self._size(way)] = model
        return self._finished[self._size(way)]

    def _size(self, redundant: str) -> tuple[object, ...]:
        """What grows with everything that is added."""
        each = (self._bodies, self._joints, self._constraints, self._loads, self._parameters, self._outputs)
        return (redundant, *(len(part) for part in each), *self._watched)

    def mass_matrix(self, model: Model) -> ca.Function:
        """Give the mass matrix (kg, kg m, kg m^2) of the speeds as a function of the model's x, u and p."""
        v = ca.vertcat(*self._speeds.values())
        matrix = ca.SX(v.shape[0], v.shape[0])
        for inertia in self._inertias:
            matrix += inertia.matrix(v)
        return ca.Function("mass", [model.x, model.u, model.p], [matrix])

    def mass_values(self, values: Mapping[str, float]) -> dict[str, tuple[float, NDArray[np.float64]]]:
        """Mass (kg) and inertia (kg m^2, (3, 3)) of every body at parameter values."""
        paths = list(self._parameters)
        p, numbers = ca.vertcat(*self._parameters.values()), [values[path] for path in paths]
        found = {}
        for body in self._bodies.values():
            properties = body.mass_properties
            if properties is not None:
                mass, inertia = ca.Function("mass", [p], [properties.mass, properties.inertia])(numbers)
                found[body.name] = float(mass), inertia.full()
        return found

    def settle(self) -> None:
        """Add masses and weights of all bodies that have theirs not yet; called by ``finish``."""
        for body in self._bodies.values():
            if body.frame is None:
                raise AssemblyError("the body hangs on nothing", where=body.name, hint="Give it a joint, or free().")
            properties = body.mass_properties
            if properties is not None and body.name not in self._settled:
                self.inertia(RigidMass(body.frame, properties))
                weight = ca.vertcat(0.0, 0.0, -properties.mass * self.gravity)
                self.apply_force(body, weight, body.point(properties.centre))
            self._settled.add(body.name)


def _length(vector: ca.SX) -> ca.SX:
    """Length of a vector, m, above zero."""
    return ca.sqrt(ca.dot(vector, vector) + _POINT**2)


def _total(terms: list[ca.SX]) -> ca.SX:
    return sum(terms, ca.SX(0.0))
