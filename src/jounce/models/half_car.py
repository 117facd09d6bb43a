"""Half car on massless axles (paper 2, eqs 6-11): bounce and pitch of the body, two wheels an axle."""

from __future__ import annotations

import casadi as ca

from jounce.control.actuators import AnyActuator
from jounce.mechanics import Model, System
from jounce.models.actuation import controlled_force
from jounce.models.channels import show_height, show_strut
from jounce.models.vehicle import add_body
from jounce.parts.vehicles import HalfCar


def half_car(vehicle: HalfCar, *, actuator: AnyActuator | None = None) -> Model:
    """Write the equations of a half car; the values in ``vehicle`` matter only through its structure."""
    system = System()
    body = add_body(system, vehicle)
    for axle, side in (("front", 1.0), ("rear", -1.0)):
        with system.within(axle):
            _axle(system, vehicle, body.height(side * system.parameter("distance")), actuator)
    return system.finish()


def _axle(system: System, vehicle: HalfCar, height: ca.SX, actuator: AnyActuator | None) -> None:
    """Two springs and dampers between road and body; ``compat`` says how the road comes in."""
    road = system.track("road.z")
    ground = -road.value if vehicle.compat == "simulink" else road.value
    deflection = ground - height
    velocity = system.rate_of(deflection if vehicle.compat == "physical" else -height)
    force = system.parameter("spring_rate") * deflection
    force += controlled_force(
        system, actuator, deflection, velocity, lambda: system.parameter("damping_coefficient") * velocity
    )
    system.force(height, 2.0 * force)
    system.output("road.z", road.value, "m", "road height under the axle")
    show_height(system, "sprung", height, "body above the axle")
    show_strut(system, deflection, velocity, force, "strut force of one wheel")
