"""Quarter car: sprung and unsprung mass, strut at an angle, radial tyre (paper 2, eqs 1-4, extended).

Both masses are at z = 0 when all springs are undeformed and the road is level; compression is positive.
"""

from __future__ import annotations

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
from jounce.models.channels import show_height, show_strut, show_tyre
from jounce.parts import QuarterCar


def quarter_car(rig: QuarterCar, *, actuator: AnyActuator | None = None) -> Model:
    """Write the equations of a quarter car; the values in ``rig`` matter only through its structure."""
    system = System()
    add_quarter_car(system, rig, system.track("road.z").value, actuator=actuator)
    return system.finish()


def add_quarter_car(
    system: System,
    rig: QuarterCar,
    road: ca.SX,
    *,
    sprung: ca.SX | None = None,
    actuator: AnyActuator | None = None,
) -> tuple[ca.SX, ca.SX]:
    """Add a quarter car on a road; return the height of its wheel (m) and the contact force (N, compression positive).

    The height ``road`` (m) is a track, or that of a moving body loaded by the tyre's reaction. ``sprung`` is the height
    (m) of an existing body; by default the sprung mass is added.
    """
    own = () if sprung is not None else (("sprung", system.coordinate("sprung.z")),)
    masses = (*own, ("unsprung", system.coordinate("unsprung.z")))
    heights = {"sprung": sprung, **dict(masses)}
    for body, z in masses:
        mass = system.parameter(f"{body}.mass")
        system.point_mass(mass, z)
        system.force(z, -mass * system.parameter("gravity"))
    _strut(system, rig, heights["sprung"], heights["unsprung"], actuator)
    contact = _tyre(system, rig, road, heights["unsprung"], actuator)
    _motions(system, road, heights["sprung"], heights["unsprung"])
    return heights["unsprung"], contact


def _strut(
    system: System, rig: QuarterCar, sprung: ca.SX, unsprung: ca.SX, actuator: AnyActuator | None
) -> None:
    strut = rig.strut
    deflection = ca.cos(system.parameter("strut.angle")) * (unsprung - sprung)
    velocity = system.rate_of(deflection)
    spring = spring_force(system, strut.spring, "strut.spring", deflection)
    spring = element_force(system, actuator, "spring", spring, velocity)
    damper = controlled_force(
        system,
        actuator,
        deflection,
        velocity,
        lambda: damper_force(system, strut.damper, "strut.damper", deflection, velocity),
    )
    friction = friction_force(system, strut.friction, "strut.friction", velocity)
    stop = bump_stop_force(system, strut.bump_stop, "strut.bump_stop", deflection)
    stop = element_force(system, actuator, "stops", stop, velocity)
    force = spring + damper + friction + stop
    system.force(-deflection, force)
    guide = friction_force(system, rig.guide.friction, "guide.friction", system.rate_of(sprung))
    system.force(-sprung, guide)
    show_strut(system, deflection, velocity, force)
    if rig.guide.friction is not None:
        system.output("guide.force", -guide, "N", "guide friction on the sprung mass, up positive")


def _tyre(
    system: System, rig: QuarterCar, road: ca.SX, unsprung: ca.SX, actuator: AnyActuator | None
) -> ca.SX:
    deflection = road - unsprung
    rate = system.rate_of(deflection)
    force = tyre_force(system, rig.tyre, deflection, rate, replaced_tyre(system, actuator, rate))
    system.force(-deflection, force)
    show_tyre(system, deflection, force)
    return force


def _motions(system: System, road: ca.SX, sprung: ca.SX, unsprung: ca.SX) -> None:
    system.output("road.z", road, "m", "road height under the wheel")
    for body, z in (("sprung", sprung), ("unsprung", unsprung)):
        show_height(system, body, z, f"{body} mass")
