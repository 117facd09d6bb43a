"""Outputs of a mechanism: frozen descriptions that become signals when its equations are formed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import casadi as ca

from jounce.mechanics.bodies import Body
from jounce.mechanics.descriptions import Given, NamedPart, direction, place
from jounce.mechanics.reactions import reaction_of
from jounce.mechanics.rotations import matrix_quaternion, normals, roll_pitch_yaw
from jounce.mechanics.structure import Structure


@dataclass(frozen=True, eq=False)
class OutputDescription(NamedPart):
    """Base class of outputs, which become channels of a run."""

    def show(self, mechanism: Structure) -> None:
        """Add its signals to a mechanism with all masses and forces."""
        raise NotImplementedError


@dataclass(frozen=True, eq=False)
class WatchedPoint(OutputDescription):
    """Position, velocity and acceleration of a point of a body."""

    body: Body
    at: Given = place()
    kind = "point"

    def show(self, mechanism: Structure) -> None:
        """Add its signals."""
        name, point = self.name, self.body.frame.point(self.at)
        acceleration = point.bias + mechanism.accelerated(point.rate)
        for i, axis in enumerate("xyz"):
            mechanism.output(f"{name}.{axis}", point.value[i], "m", f"{name}, {axis}")
            mechanism.output(
                f"{name}.v{axis}", point.rate[i], "m/s", f"{name}, velocity along {axis}"
            )
            mechanism.output(
                f"{name}.a{axis}", acceleration[i], "m/s^2", f"{name}, acceleration along {axis}"
            )


@dataclass(frozen=True, eq=False)
class WatchedBody(WatchedPoint):
    """Motion of a body's centre of mass, with the body's orientation and angular velocity."""

    kind = "body"

    def show(self, mechanism: Structure) -> None:
        """Add its signals."""
        super().show(mechanism)
        name, orientation = self.name, self.body.frame.orientation
        spin_rate = orientation.rotate(
            orientation.spin_bias + mechanism.accelerated(orientation.spin)
        )
        for i, axis in enumerate("xyz"):
            mechanism.output(
                f"{name}.w{axis}",
                self.body.spin[i],
                "rad/s",
                f"{name}, angular velocity about {axis}",
            )
            text = f"{name}, angular acceleration about {axis}"
            mechanism.output(f"{name}.alpha_{axis}", spin_rate[i], "rad/s^2", text)
        for i, part in enumerate(ca.vertsplit(matrix_quaternion(orientation.matrix))):
            mechanism.output(
                f"{name}.q{i}",
                part,
                "1",
                f"{name}, quaternion of its orientation, q0 never negative",
            )
        for turn, angle in zip(
            ("roll", "pitch", "yaw"), roll_pitch_yaw(orientation.matrix), strict=True
        ):
            mechanism.output(
                f"{name}.{turn}",
                angle,
                "rad",
                f"{name}, {turn}; yaw, then pitch, then roll (ISO 8855)",
            )


@dataclass(frozen=True, eq=False)
class WatchedAngle(OutputDescription):
    """Rotation of the second body relative to the first about an axis of the first."""

    first: Body
    second: Body
    axis: Given = direction()
    kind = "angle"

    def show(self, mechanism: Structure) -> None:
        """Add its signals."""
        across, sideways = normals(self.axis)
        frame, turned = self.first.frame, self.second.frame.direction(across).value
        angle = ca.atan2(
            ca.dot(turned, frame.direction(sideways).value),
            ca.dot(turned, frame.direction(across).value),
        )
        rate, acceleration = mechanism.rate_of(angle), mechanism.acceleration_of(angle)
        _show_motion(mechanism, self.name, (angle, rate, acceleration), "rad")


@dataclass(frozen=True, eq=False)
class WatchedCoordinates(OutputDescription):
    """All coordinates and speeds."""

    kind = "coordinates"

    def show(self, mechanism: Structure) -> None:
        """Add its signals."""
        every = mechanism.collection
        for hung in mechanism.hanging.values():
            for name, speed in zip(hung.coordinates, hung.speeds, strict=False):
                motion = every.coordinates[name], every.speeds[speed], every.accelerations[speed]
                _show_motion(mechanism, name, motion, every.units[name])
            if hung.joint.has_quaternion:
                for name in hung.quaternion:
                    mechanism.output(name, every.coordinates[name], "1", f"{name}, quaternion")
                for name in hung.speeds[len(hung.coordinates) :]:
                    text = f"{name}, angular velocity in the body's axes"
                    mechanism.output(name, every.speeds[name], "rad/s", text)


@dataclass(frozen=True, eq=False)
class WatchedReaction(OutputDescription):
    """Force and torque of a joint, closure or condition in the axes of ``frame``."""

    on: str | None
    frame: Body
    at: Given = place(None)
    kind = "reaction"

    def show(self, mechanism: Structure) -> None:
        """Add its signals."""
        reaction = reaction_of(mechanism, self.name, self.on)
        if self.at is not None:
            reaction = reaction.at(
                reaction.body.carrier.place(reaction.body.frame.point(self.at).value)
            )
        for symbol, vector, unit, what in (
            ("f", reaction.force, "N", "force"),
            ("t", reaction.torque, "N*m", "torque"),
        ):
            turned = self.frame.frame.orientation.unrotate(self.frame.carrier.inward(vector))
            for i, axis in enumerate("xyz"):
                text = f"{self.name}, reaction {what} along {axis}"
                mechanism.output(f"{self.name}.{symbol}{axis}", turned[i], unit, text)


@dataclass(frozen=True, eq=False)
class WatchedEnergy(OutputDescription):
    """Energies, and the residual of the loop equations."""

    kind = "energy"

    def show(self, mechanism: Structure) -> None:
        """Add its signals."""
        bodies, actions = mechanism.bodies.values(), [action for _, action in mechanism.loads]
        mechanism.output("energy.kinetic", kinetic_energy(bodies), "J", "kinetic energy")
        weight = weight_energy(bodies, mechanism.gravity)
        mechanism.output("energy.weight", weight, "J", "potential energy of the weights")
        left = ca.vertcat(*(constraint.value for constraint in mechanism.collection.constraints))
        size = ca.sqrt(ca.dot(left, left)) if left.numel() else ca.SX(0.0)
        mechanism.output("constraint.residual", size, "m", "residual of the loop equations")
        stored = [energy for action in actions for energy in action.stored]
        if stored:
            mechanism.output("energy.elastic", total(stored), "J", "energy of the springs")
        for name, powers, text in (
            (
                "energy.dissipated",
                [power for action in actions for power in action.lost],
                "energy lost in dampers since the start",
            ),
            (
                "energy.supplied",
                mechanism.supplied_powers(),
                "energy supplied by motions since the start",
            ),
        ):
            if powers:
                taken = mechanism.internal_state(name)
                mechanism.set_internal_rate(name, total(powers))
                mechanism.output(name, taken, "J", text)


def _show_motion(
    mechanism: Structure, name: str, motion: tuple[ca.SX, ca.SX, ca.SX], unit: str
) -> None:
    value, rate, acceleration = motion
    mechanism.output(name, value, unit, name)
    mechanism.output(f"{name} rate", rate, f"{unit}/s", f"{name}, rate")
    mechanism.output(f"{name} acceleration", acceleration, f"{unit}/s^2", f"{name}, acceleration")


def total(terms: Iterable[ca.SX]) -> ca.SX:
    """Sum of expressions."""
    return sum(terms, ca.SX(0.0))


def kinetic_energy(bodies: Iterable[Body]) -> ca.SX:
    """Kinetic energy, J."""
    energy = ca.SX(0.0)
    for body in bodies:
        properties = body.mass_properties
        if properties is not None:
            velocity = body.carrier.velocity(body.frame.point(properties.centre))
            turn = body.frame.orientation
            spin = turn.unrotate(body.spin) if body.carrier.moves else turn.spin
            energy += 0.5 * (
                properties.mass * ca.dot(velocity, velocity)
                + ca.dot(spin, properties.inertia @ spin)
            )
    return energy


def weight_energy(bodies: Iterable[Body], gravity: ca.SX) -> ca.SX:
    """Return the potential energy of the weights relative to the design pose, J."""
    energy = ca.SX(0.0)
    for body in bodies:
        properties = body.mass_properties
        if properties is not None:
            rise = (
                body.carrier.height(body.frame.point(properties.centre).value)
                - properties.centre[2]
            )
            energy += properties.mass * gravity * rise
    return energy
