"""Full car: heave, pitch and roll of the body, four wheels, anti-roll bars (7 degrees of freedom)."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from jounce.control.actuators import AnyActuator
from jounce.mechanics import Model, System
from jounce.models.vehicle import Body, add_body
from jounce.models.wheels import add_wheel
from jounce.parts.vehicles import FullAxle, FullCar

_SIDES = {"left": 1.0, "right": -1.0}


@dataclass(frozen=True)
class _Wheel:
    """A wheel hung under the body: heights of wheel and body above it, and deflection of its strut, m."""

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
        twist = system.parameter(f"{name}.anti_roll_bar_rate") * (left.deflection - right.deflection)
        system.force(right.deflection - left.deflection, twist)
    if vehicle.body.height is not None:
        _lateral(system, body, axles)
    return system.finish()


def _axle(
    system: System, name: str, axle: FullAxle, body: Body, end: float, actuator: AnyActuator | None
) -> dict[str, _Wheel]:
    """Two wheels of an axle ahead (``end`` 1) or behind (-1); the numbers are the axle's."""
    gravity = system.parameter("gravity")
    wheels = {}
    for side, sign in _SIDES.items():
        with system.within(f"{name}_{side}", name):
            x, y = end * system.parameter("distance"), 0.5 * sign * system.parameter("track")
            height = body.height(x, y)
            unsprung, _ = add_wheel(system, axle, height, gravity, actuator=actuator)
            wheels[side] = _Wheel(unsprung, height, unsprung - height)
    return wheels


def _lateral(system: System, body: Body, axles: dict[str, dict[str, _Wheel]]) -> None:
    """Let a lateral acceleration roll the body about the roll centres; the rest of its moment goes to the wheels."""
    acceleration = system.track("lateral_acceleration").value
    front, rear = (system.parameter(f"{name}.distance") for name in axles)
    force = system.parameter("body.mass") * acceleration
    for name, share in (("front", rear / (front + rear)), ("rear", front / (front + rear))):
        centre = system.parameter(f"{name}.roll_centre_height")
        system.force(body.roll, share * force * (system.parameter("body.height") - centre))
        transfer = share * force * centre / system.parameter(f"{name}.track")
        left, right = (axles[name][side].unsprung for side in _SIDES)
        system.force(left - right, transfer)
    system.output("body.lateral_acceleration", acceleration, "m/s^2", "lateral acceleration, to the left positive")
