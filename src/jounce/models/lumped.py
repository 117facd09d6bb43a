"""Lumped vehicles: half car, half car with unsprung masses, full car of 7 degrees of freedom.

They share the body on its axles, the loads of driving and the laws of a strut. Angles are small: a point of the body
``x`` ahead and ``y`` to the left of the centre of gravity has the height ``z - x pitch + y roll``. Heights are zero
when all springs are undeformed and the road is level.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from jounce.control.actuators import AnyActuator
from jounce.mechanics import Model, System
from jounce.mechanics.elements import (
    bump_stop_force,
    damper_force,
    friction_force,
    spring_force,
    tyre_force,
)
from jounce.models.actuation import controlled_force, element_force, replaced_tyre
from jounce.models.channels import TURNS, show_height, show_strut, show_turn, show_tyre
from jounce.parts.vehicles import FullAxle, FullCar, HalfCar, HalfCar4DOF, Vehicle, WheeledAxle


@dataclass(frozen=True)
class LumpedBody:
    """The body's coordinates: height of the centre of gravity (m), pitch and roll (rad; roll 0 in half cars)."""

    z: ca.SX
    pitch: ca.SX
    roll: ca.SX

    def height(self, x: ca.SX, y: ca.SX | float = 0.0) -> ca.SX:
        """Return the height of a point of the body, m."""
        return self.z - x * self.pitch + y * self.roll


def add_body(system: System, vehicle: Vehicle, *, rolls: bool = False) -> LumpedBody:
    """Add the body with its weight, the moments of driving, and its channels."""
    z, pitch = system.coordinate("body.z"), system.coordinate("body.pitch", "rad")
    roll = system.coordinate("body.roll", "rad") if rolls else ca.SX(0.0)
    mass = system.parameter("body.mass")
    system.point_mass(mass, z)
    system.force(z, -mass * system.parameter("gravity"))
    system.point_mass(system.parameter("body.pitch_inertia"), pitch)
    system.force(pitch, _pitch_moment(system, vehicle))
    if rolls:
        system.point_mass(system.parameter("body.roll_inertia"), roll)
    _show_body(system, LumpedBody(z, pitch, roll), rolls=rolls)
    return LumpedBody(z, pitch, roll)


def _pitch_moment(system: System, vehicle: Vehicle) -> ca.SX:
    """Return the moment of braking, given or from deceleration, N m, nose down positive."""
    moment = system.track("pitch_moment").value
    height = getattr(getattr(vehicle, "body"), "height")  # noqa: B009 - every vehicle has a body
    if height is not None:
        deceleration = system.track("deceleration").value
        moment += system.parameter("body.mass") * system.parameter("body.height") * deceleration
    system.output(
        "body.pitch_moment", moment, "N*m", "moment of driving on the body, nose down positive"
    )
    return moment


def _show_body(system: System, body: LumpedBody, *, rolls: bool) -> None:
    show_height(system, "body", body.z, "centre of gravity of the body")
    for turn in list(TURNS)[: 1 + rolls]:
        show_turn(system, turn, getattr(body, turn))


def strut_force(
    system: System,
    axle: WheeledAxle,
    deflection: ca.SX,
    velocity: ca.SX,
    actuator: AnyActuator | None = None,
) -> ca.SX:
    """Return the force (N) of one wheel's spring, damper, friction and stops."""
    if axle.spring is None:
        force = system.parameter("spring_rate") * deflection
    else:
        force = spring_force(system, axle.spring, "spring", deflection)
    force = element_force(system, actuator, "spring", force, velocity)
    force += controlled_force(
        system, actuator, deflection, velocity, lambda: _damper(system, axle, deflection, velocity)
    )
    force += friction_force(system, axle.friction, "friction", velocity)
    stops = bump_stop_force(system, axle.bump_stop, "bump_stop", deflection)
    stops -= bump_stop_force(system, axle.rebound_stop, "rebound_stop", -deflection)
    return force + element_force(system, actuator, "stops", stops, velocity)


def _damper(system: System, axle: WheeledAxle, deflection: ca.SX, velocity: ca.SX) -> ca.SX:
    if axle.damper is None:
        return system.parameter("damping_coefficient") * velocity
    return damper_force(system, axle.damper, "damper", deflection, velocity)


def add_wheel(
    system: System,
    axle: WheeledAxle,
    height: ca.SX,
    gravity: ca.SX,
    *,
    plate: ca.SX | None = None,
    wheels: int = 1,
    actuator: AnyActuator | None = None,
) -> tuple[ca.SX, ca.SX]:
    """Add one wheel, or ``wheels`` that move as one, under the body; return its height and the contact force of one.

    Call it within the prefix of the wheel. ``height`` is that of the body above it (m). The wheel stands on a road, or
    on a ``plate`` (height in m), on which it exerts its reaction. Output forces are those of one wheel.
    """
    ground = system.track("road.z").value if plate is None else plate
    unsprung = system.coordinate("unsprung.z")
    mass = wheels * system.parameter("unsprung_mass")
    system.point_mass(mass, unsprung)
    system.force(unsprung, -mass * gravity)
    deflection = unsprung - height
    velocity = system.rate_of(deflection)
    force = strut_force(system, axle, deflection, velocity, actuator)
    system.force(-deflection, wheels * force)
    tyre_deflection = ground - unsprung
    tyre_rate = system.rate_of(tyre_deflection)
    contact = tyre_force(
        system, axle.tyre, tyre_deflection, tyre_rate, replaced_tyre(system, actuator, tyre_rate)
    )
    system.force(-tyre_deflection, wheels * contact)
    if plate is None:
        system.output("road.z", ground, "m", "road height under the wheel")
    show_height(system, "sprung", height, "body above the wheel")
    show_height(system, "unsprung", unsprung, "unsprung mass")
    show_strut(system, deflection, velocity, force, "strut force of one wheel")
    show_tyre(system, tyre_deflection, contact, " of one wheel")
    return unsprung, contact


def half_car(vehicle: HalfCar, *, actuator: AnyActuator | None = None) -> Model:
    """Write the equations of a half car; the values in ``vehicle`` matter only through its structure."""
    system = System()
    body = add_body(system, vehicle)
    for axle, side in (("front", 1.0), ("rear", -1.0)):
        with system.within(axle):
            _massless_axle(
                system, vehicle, body.height(side * system.parameter("distance")), actuator
            )
    return system.finish()


def _massless_axle(
    system: System, vehicle: HalfCar, height: ca.SX, actuator: AnyActuator | None
) -> None:
    """Add two springs and dampers between road and body; ``compat`` selects how the road acts."""
    road = system.track("road.z")
    ground = -road.value if vehicle.compat == "simulink" else road.value
    deflection = ground - height
    velocity = system.rate_of(deflection if vehicle.compat == "physical" else -height)
    force = element_force(
        system, actuator, "spring", system.parameter("spring_rate") * deflection, velocity
    )
    force += controlled_force(
        system,
        actuator,
        deflection,
        velocity,
        lambda: system.parameter("damping_coefficient") * velocity,
    )
    system.force(height, 2.0 * force)
    system.output("road.z", road.value, "m", "road height under the axle")
    show_height(system, "sprung", height, "body above the axle")
    show_strut(system, deflection, velocity, force, "strut force of one wheel")


def half_car_4dof(vehicle: HalfCar4DOF, *, actuator: AnyActuator | None = None) -> Model:
    """Write the equations of a half car with unsprung masses; only the structure of ``vehicle`` matters."""
    system = System()
    body, gravity = add_body(system, vehicle), system.parameter("gravity")
    for name, axle, side in (("front", vehicle.front, 1.0), ("rear", vehicle.rear, -1.0)):
        with system.within(name):
            height = body.height(side * system.parameter("distance"))
            add_wheel(system, axle, height, gravity, wheels=2, actuator=actuator)
    return system.finish()


_SIDES = {"left": 1.0, "right": -1.0}


@dataclass(frozen=True)
class _HungWheel:
    """A wheel under the body: heights of the wheel and of the body above it, and deflection of its strut, m."""

    unsprung: ca.SX
    height: ca.SX
    deflection: ca.SX


def full_car(vehicle: FullCar, *, actuator: AnyActuator | None = None) -> Model:
    """Write the equations of a full car; the values in ``vehicle`` matter only through its structure."""
    system = System()
    body = add_body(system, vehicle, rolls=True)
    axles = {}
    for name, axle, side in (("front", vehicle.front, 1.0), ("rear", vehicle.rear, -1.0)):
        axles[name] = _axle(system, name, axle, body, side, actuator)
        left, right = axles[name]["left"], axles[name]["right"]
        twist = system.parameter(f"{name}.anti_roll_bar_rate") * (
            left.deflection - right.deflection
        )
        system.force(right.deflection - left.deflection, twist)
    if vehicle.body.height is not None:
        _lateral(system, body, axles)
    return system.finish()


def _axle(
    system: System,
    name: str,
    axle: FullAxle,
    body: LumpedBody,
    end: float,
    actuator: AnyActuator | None,
) -> dict[str, _HungWheel]:
    """Add two wheels of the front (``end`` 1) or rear axle (-1), with the axle's parameters."""
    gravity = system.parameter("gravity")
    wheels = {}
    for side, sign in _SIDES.items():
        with system.within(f"{name}_{side}", name):
            x, y = end * system.parameter("distance"), 0.5 * sign * system.parameter("track")
            height = body.height(x, y)
            unsprung, _ = add_wheel(system, axle, height, gravity, actuator=actuator)
            wheels[side] = _HungWheel(unsprung, height, unsprung - height)
    return wheels


def _lateral(system: System, body: LumpedBody, axles: dict[str, dict[str, _HungWheel]]) -> None:
    """Let lateral acceleration roll the body about the roll centres; apply the remaining moment to the wheels."""
    acceleration = system.track("lateral_acceleration").value
    front, rear = (system.parameter(f"{name}.distance") for name in axles)
    force = system.parameter("body.mass") * acceleration
    for name, share in (("front", rear / (front + rear)), ("rear", front / (front + rear))):
        centre = system.parameter(f"{name}.roll_centre_height")
        system.force(body.roll, share * force * (system.parameter("body.height") - centre))
        transfer = share * force * centre / system.parameter(f"{name}.track")
        left, right = (axles[name][side].unsprung for side in _SIDES)
        system.force(left - right, transfer)
    system.output(
        "body.lateral_acceleration",
        acceleration,
        "m/s^2",
        "lateral acceleration, to the left positive",
    )
