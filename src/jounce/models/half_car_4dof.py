"""Half car with unsprung masses: bounce and pitch of the body, heights of the front and the rear pair of wheels."""

from __future__ import annotations

from jounce.control.actuators import AnyActuator
from jounce.mechanics import Model, System
from jounce.models.vehicle import add_body
from jounce.models.wheels import add_wheel
from jounce.parts.vehicles import HalfCar4DOF


def half_car_4dof(vehicle: HalfCar4DOF, *, actuator: AnyActuator | None = None) -> Model:
    """Write the equations of a half car with unsprung masses; only the structure of ``vehicle`` matters."""
    system = System()
    body, gravity = add_body(system, vehicle), system.parameter("gravity")
    for name, axle, side in (("front", vehicle.front, 1.0), ("rear", vehicle.rear, -1.0)):
        with system.within(name):
            height = body.height(side * system.parameter("distance"))
            add_wheel(system, axle, height, gravity, wheels=2, actuator=actuator)
    return system.finish()
