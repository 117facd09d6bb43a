"""A wheel under the body of a lumped vehicle: unsprung mass between strut and tyre."""

from __future__ import annotations

import casadi as ca

from jounce.control.actuators import AnyActuator
from jounce.mechanics import System
from jounce.mechanics.elements import tyre_force
from jounce.models.channels import show_height, show_strut, show_tyre
from jounce.models.vehicle import strut_force
from jounce.parts.vehicles import WheeledAxle


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
    """Hang one wheel (or a pair that moves as one) under the body; give its height and the contact force of one.

    Parameters
    ----------
    system : System
        Within the place of the wheel.
    axle : WheeledAxle
        Its laws.
    height : casadi.SX
        Height of the body above the wheel, m.
    gravity : casadi.SX
        m/s^2.
    plate : casadi.SX, optional
        Height (m) of what it stands on and pushes back; a road otherwise.
    wheels : int
        How many move together; forces that are shown are those of one.
    actuator : AnyActuator, optional
        Of each strut.
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
    contact = tyre_force(system, axle.tyre, tyre_deflection, system.rate_of(tyre_deflection))
    system.force(-tyre_deflection, wheels * contact)
    if plate is None:
        system.output("road.z", ground, "m", "road height under the wheel")
    show_height(system, "sprung", height, "body above the wheel")
    show_height(system, "unsprung", unsprung, "unsprung mass")
    show_strut(system, deflection, velocity, force, "strut force of one wheel")
    show_tyre(system, tyre_deflection, contact, " of one wheel")
    return unsprung, contact
