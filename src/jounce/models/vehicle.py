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
from jounce.parts.vehicles import Vehicle, WheeledAxle

_TURNS = {"pitch": "nose down", "roll": "right side down"}


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
    z, pitch = system.coordinate("body.z"), system.coordinate("body.pitch")
    roll = system.coordinate("body.roll") if rolls else ca.SX(0.0)
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
    for name, value, text in (
        ("z", body.z, "height"),
        ("vz", system.rate_of(body.z), "vertical velocity"),
        ("az", system.acceleration_of(body.z), "vertical acceleration"),
    ):
        unit = {"z": "m", "vz": "m/s", "az": "m/s^2"}[name]
        system.output(f"body.{name}", value, unit, f"centre of gravity of the body, {text}")
    for turn, sign in list(_TURNS.items())[: 1 + rolls]:
        angle = getattr(body, turn)
        system.output(f"body.{turn}", angle, "rad", f"body {turn}, {sign} positive")
        system.output(f"body.{turn}_rate", system.rate_of(angle), "rad/s", f"body {turn} rate")
        acceleration = system.acceleration_of(angle)
        system.output(f"body.{turn}_acceleration", acceleration, "rad/s^2", f"body {turn} acceleration")


def show_height(system: System, name: str, z: ca.SX, text: str) -> None:
    """Let a height be seen, with velocity and acceleration."""
    system.output(f"{name}.z", z, "m", f"{text}, height")
    system.output(f"{name}.vz", system.rate_of(z), "m/s", f"{text}, vertical velocity")
    system.output(f"{name}.az", system.acceleration_of(z), "m/s^2", f"{text}, vertical acceleration")


def show_strut(system: System, deflection: ca.SX, velocity: ca.SX, force: ca.SX) -> None:
    """Let the strut of one wheel be seen."""
    system.output("strut.deflection", deflection, "m", "strut deflection, compression positive")
    system.output("strut.velocity", velocity, "m/s", "strut deflection rate, bump positive")
    system.output("strut.force", force, "N", "strut force of one wheel, compression positive")


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
