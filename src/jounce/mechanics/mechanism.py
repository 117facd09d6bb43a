"""Mechanisms in space: bodies, joints, loops and forces by name, in the ground axes of the design pose."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import casadi as ca
import numpy as np

from jounce.core.constants import GRAVITY
from jounce.core.errors import AssemblyError, unknown
from jounce.core.types import Array
from jounce.mechanics.assembly import removable
from jounce.mechanics.bodies import Body
from jounce.mechanics.loads import Loaded
from jounce.mechanics.model import Model
from jounce.mechanics.reactions import Reaction, kinetic_energy, tree_reaction, weight_energy
from jounce.mechanics.rotations import normals
from jounce.mechanics.tree import Number, Vector

BALANCE = "energy.balance"
"""Work of all forces as a state; kinetic energy less that as an output, in mechanisms with loops."""
_NONE = ca.SX(3, 1)


class Mechanism(Loaded):
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

    def __init__(self, gravity: Number = GRAVITY) -> None:
        super().__init__(gravity)
        self._watched: dict[str, Callable[[], None]] = {}
        self._finished: dict[tuple[object, ...], Model] = {}

    def reaction(self, joint: str) -> Reaction:
        """Give force (N) and torque (N m) of a joint on its second body, in ground axes; for outputs only.

        They are given at the joint (for a closure, at its point on the second body). What drives a coordinate is
        counted as the joint's; springs, dampers and friction of a joint are not. Ask when all forces and joints are in.
        """
        self.settle()
        self._refuse_carried(f"reaction of {joint}", *self._bodies.values())
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
        self._refuse_carried(name, body)
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

        ``energy.kinetic``, ``energy.weight`` and, where there are such, ``energy.elastic`` of springs and stops,
        ``energy.dissipated`` by dampers, stops and friction and ``energy.supplied`` by motions since the start. Forces
        by laws of your own and bushings are not among them. ``energy.balance``, where there are loops, is the kinetic
        energy less the work of all forces: constant but for errors. ``constraint.residual`` is in m and rad.
        """
        self._watched["energy"] = self._show_energy

    def _show_energy(self) -> None:
        self.output("energy.kinetic", self.kinetic_energy(), "J", "kinetic energy")
        self.output("energy.weight", self.weight_energy(), "J", "potential energy of the weights")
        self.output("constraint.residual", self.residual(), "m", "what is left open of the loops")
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

    def residual(self) -> ca.SX:
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
    def bodies(self) -> dict[str, Body]:
        """All bodies by name, the ground first."""
        return dict(self._bodies)

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
        model = self._formed(frozenset())
        if redundant == "remove" and model.constraints:
            dropped = removable(model, *self._numbers(model, values or {}, inputs or {}), start)
            return self._formed(dropped) if dropped else model
        return model

    def _formed(self, dropped: frozenset[str]) -> Model:
        """Form the equations without some of the loops'."""
        self.settle()
        for show in self._watched.values():
            show()
        self._dropped: frozenset[str] = dropped
        return super().finish()

    def _numbers(self, model: Model, values: Mapping[str, float], inputs: Mapping[str, float]) -> tuple[Array, Array]:
        """Parameters and inputs of a model."""
        every = {**self.values, **values}
        u = np.zeros(model.u.shape[0])
        for i, name in enumerate(model.tracks):
            u[i * model.track_order] = inputs.get(name, 0.0)
        return np.array([every[name] for name in model.parameters]), u

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
        whole = self._kept(frozenset())
        if redundant != "remove" or not whole.constraints:
            return whole
        size = self._size()
        known = [key[0] for key in self._finished if key[1:] == size and isinstance(key[0], frozenset) and key[0]]
        return self._kept(removable(whole, *self._numbers(whole, values or {}, inputs or {}), start, known))

    def _kept(self, dropped: frozenset[str]) -> Model:
        """The model without some of the loop equations, formed once."""
        if (dropped, *self._size()) not in self._finished:
            self._account()
            model = self._formed(dropped)  # what is watched may add to the size
            self._finished[dropped, *self._size()] = model
        return self._finished[dropped, *self._size()]

    def _account(self) -> None:
        """Let a run see what its loops make of the energy: none of it may come or go there."""
        self.settle()
        power = self.power()
        if self._constraints and power is not None:
            taken = self._internal[BALANCE][0] if BALANCE in self._internal else self.internal_state(BALANCE)
            self.set_internal_rate(BALANCE, power)
            self.output(BALANCE, self.kinetic_energy() - taken, "J", "kinetic energy less the work of all forces")

    def _size(self) -> tuple[object, ...]:
        """What grows with everything that is added."""
        each = (self._bodies, self._joints, self._constraints, self._loads, self._parameters, self._outputs)
        return (*(len(part) for part in each), *self._watched)


def _total(terms: list[ca.SX]) -> ca.SX:
    return sum(terms, ca.SX(0.0))
