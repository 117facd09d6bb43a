"""What all lumped vehicles share: the body on its axles, loads from driving, and the laws of a strut.

Angles are small: a point of the body ``x`` ahead and ``y`` to the left of the centre of gravity is at
``z - x pitch + y roll``. Heights are zero where all springs are undeformed and the road is level.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from jounce.control.actuators import AnyActuator
from jounce.mechanics import System
from jounce.mechanics.elements import bump_stop_force, damper_force, friction_force, spring_force
from jounce.models.actuation import controlled_force
from jounce.models.channels import TURNS, show_height, show_turn
from jounce.parts.vehicles import Vehicle, WheeledAxle


@dataclass(frozen=True)
class Body:
    """The body's coordinates: height of the centre of gravity (m), pitch and roll (rad; roll 0 in half cars)."""

    z: ca.SX
    pitch: ca.SX
    roll: ca.SX

    def height(self, x: ca.SX, y: ca.SX | float = 0.0) -> ca.SX:
        """Height of a point of the body, m."""
        return self.z - x * self.pitch + y * self.roll


def add_body(system: System, vehicle: Vehicle, *, rolls: bool = False) -> Body:
    """Add the body with its weight, the moments of driving, and what is to be seen of it."""
    z, pitch = system.coordinate("body.z"), system.coordinate("body.pitch", "rad")
    roll = system.coordinate("body.roll", "rad") if rolls else ca.SX(0.0)
    mass = system.parameter("body.mass")
    system.point_mass(mass, z)
    system.force(z, -mass * system.parameter("gravity"))
    system.point_mass(system.parameter("body.pitch_inertia"), pitch)
    system.force(pitch, _pitch_moment(system, vehicle))
    if rolls:
        system.point_mass(system.parameter("body.roll_inertia"), roll)
    _show_body(system, Body(z, pitch, roll), rolls=rolls)
    return Body(z, pitch, roll)


def _pitch_moment(system: System, vehicle: Vehicle) -> ca.SX:
    """Moment of braking, given or from deceleration, N m, nose down positive."""
    moment = system.track("pitch_moment").value
    height = getattr(getattr(vehicle, "body"), "height")  # noqa: B009 - every vehicle has a body
    if height is not None:
        deceleration = system.track("deceleration").value
        moment += system.parameter("body.mass") * system.parameter("body.height") * deceleration
    system.output("body.pitch_moment", moment, "N*m", "moment of driving on the body, nose down positive")
    return moment


def _show_body(system: System, body: Body, *, rolls: bool) -> None:
    show_height(system, "body", body.z, "centre of gravity of the body")
    for turn in list(TURNS)[: 1 + rolls]:
        show_turn(system, turn, getattr(body, turn))


def strut_force(
    system: System, axle: WheeledAxle, deflection: ca.SX, velocity: ca.SX, actuator: AnyActuator | None = None
) -> ca.SX:
    """Force (N) of one wheel's spring, damper, friction and stops."""
    if axle.spring is None:
        force = system.parameter("spring_rate") * deflection
    else:
        force = spring_force(system, axle.spring, "spring", deflection)
    force += controlled_force(
        system, actuator, deflection, velocity, lambda: _damper(system, axle, deflection, velocity)
    )
    force += friction_force(system, axle.friction, "friction", velocity)
    force += bump_stop_force(system, axle.bump_stop, "bump_stop", deflection)
    return force - bump_stop_force(system, axle.rebound_stop, "rebound_stop", -deflection)


def _damper(system: System, axle: WheeledAxle, deflection: ca.SX, velocity: ca.SX) -> ca.SX:
    if axle.damper is None:
        return system.parameter("damping_coefficient") * velocity
    return damper_force(system, axle.damper, "damper", deflection, velocity)
