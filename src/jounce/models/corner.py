"""3-D corner on a road: a suspension template with strut and tyre, its body on a guide.

Displacements of body and wheel centre are relative to the design position; compression is positive.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import casadi as ca

from jounce.control.actuators import AnyActuator
from jounce.mechanics import Mechanism, Model, System, Track
from jounce.mechanics.bodies import Body
from jounce.mechanics.elements import friction_force
from jounce.models.actuation import controlled_force, element_force
from jounce.models.attachments import (
    add_rocker,
    add_strut_points,
    add_tyre,
    bar_angle,
    bar_stiffness,
    damper_law,
    friction_law,
    lowest_point,
    spring_law,
    stop_law,
    third_damper_law,
    third_deflection,
    third_law,
    torsion_law,
    winding,
)
from jounce.models.channels import (
    show_bushings,
    show_energy,
    show_hardpoints,
    show_height,
    show_point,
    show_reactions,
    show_strut,
    show_tyre,
)
from jounce.models.linkage import (
    DescribedSuspension,
    ElementLength,
    Linkage,
    Suspension,
    hang_on_guide,
)
from jounce.models.templates import double_wishbone, five_link, mcpherson, trailing_arm
from jounce.parts.corners import Corner, DoubleWishbone, FiveLink, McPherson, TrailingArm

_AnyLinkage = TypeVar("_AnyLinkage", bound=Linkage)

TEMPLATES: dict[type[Corner], Callable[[Linkage], None]] = {
    DoubleWishbone: double_wishbone,
    McPherson: mcpherson,
    FiveLink: five_link,
    TrailingArm: trailing_arm,
}


def suspension(
    rig: Corner,
    mechanism: Mechanism,
    *,
    guide: str | None = None,
    rack: Track | ca.SX | None = None,
) -> Linkage:
    """Add the bodies of a suspension to a mechanism; only the structure of the description matters.

    ``guide`` ("fixed", "vertical", "vertical+spherical") is the constraint of the body, and ``rack`` is the travel of
    the rack (m); by default those of the description.
    """
    return build_linkage(rig, mechanism, hang_on_guide(mechanism, guide or rig.guide), rack=rack)


def build_linkage(
    rig: Corner,
    mechanism: Mechanism,
    chassis: Body,
    *,
    rack: Track | ca.SX | None = None,
    ahead: ca.SX | float = 0.0,
    turned: ca.SX | float = 1.0,
    kind: type[_AnyLinkage] = Linkage,  # type: ignore[assignment]
) -> _AnyLinkage:
    """Add a suspension to a body, shifted by ``ahead`` (m) along x; a ``turned`` of -1 puts it on the opposite side."""
    steering = getattr(rig, "steering", None)
    if rack is None and steering is not None:
        rack = mechanism.parameter("steering.rack_travel")
    holder = chassis
    if rack is not None:
        holder = mechanism.body("rack")
        mechanism.driven("rack", chassis, holder, axis=ca.SX([0.0, 1.0, 0.0]), travel=rack)
    linkage = kind(rig, mechanism, chassis, holder, ahead=ahead, turned=turned)
    TEMPLATES[type(rig)](linkage)
    add_rocker(linkage)
    add_strut_points(linkage)
    return linkage


def corner(rig: Corner, *, detail: bool = False, actuator: AnyActuator | None = None) -> Model:
    """Write the equations of a 3-D corner; they depend only on the structure of ``rig``.

    With ``detail`` the outputs also include all hardpoints, joint reactions and energies. An ``actuator`` acts along
    the damper.
    """
    rig.require("bodies", "spring", "damper", "tyre", what="how it moves")
    mechanism = Mechanism()
    mechanism.gravity = mechanism.parameter("gravity")
    road = mechanism.track("road.z")
    linkage = suspension(rig, mechanism)
    mechanism.output("road.z", road.value, "m", "road height under the wheel")
    elements = {**add_strut(linkage, actuator), **add_both_alike(linkage)}
    tyre = add_tyre(linkage, road, actuator)
    show_tyre(mechanism, tyre.deflection, tyre.force)
    show_motions(
        linkage, linkage.wheel_centre.value[2] - linkage.number("hardpoints.wheel_centre[2]")
    )
    if detail:
        show_hardpoints(linkage)
        show_point(mechanism, "contact_point", lowest_point(linkage, road.value))
        show_reactions(mechanism)
        show_bushings(linkage)
        elements["tyre"] = tyre.force, tyre.closing
        if linkage.bushings:
            elements["bushings"] = (
                sum((power for _, power in linkage.bushings.values()), ca.SX(0.0)),
                ca.SX(1.0),
            )
        show_energy(linkage, elements, tyre.force * road.rate)
    return mechanism.finish()


def add_strut(
    linkage: Suspension, actuator: AnyActuator | None = None
) -> dict[str, tuple[ca.SX, ca.SX]]:
    """Add spring, stops and damper (or actuator); return force and deflection rate of each element."""
    spring, damper = linkage.line("spring"), linkage.line("damper")
    sprung, damped = strut_forces(linkage, spring, damper, actuator)
    linkage.push(spring, sprung)
    linkage.push(damper, damped)
    return {
        "spring": (sprung, -spring.rate),
        "damper": (damped, -damper.rate),
        **add_torsion_bar(linkage),
    }


def strut_forces(
    linkage: DescribedSuspension,
    spring: ElementLength,
    damper: ElementLength,
    actuator: AnyActuator | None = None,
) -> tuple[ca.SX, ca.SX]:
    """Return and output forces (N, compression positive) of spring and stops, and of damper (actuator) and friction."""
    mechanism = linkage.mechanism
    elastic, stops = spring_law(linkage, spring), stop_law(linkage, spring)
    if "spring" not in linkage.rig.without:
        elastic = element_force(mechanism, actuator, "spring", elastic, -spring.rate)
    stops = element_force(mechanism, actuator, "stops", stops, -spring.rate)
    viscous = controlled_force(
        mechanism, actuator, damper.deflection, -damper.rate, lambda: damper_law(linkage, damper)
    )
    viscous += friction_law(linkage, damper)
    what = "spring, stops, damper and friction"
    show_strut(
        mechanism, spring.deflection, -damper.rate, elastic + stops + viscous, what, " from design"
    )
    return elastic + stops, viscous


def add_torsion_bar(linkage: DescribedSuspension) -> dict[str, tuple[ca.SX, ca.SX]]:
    """Add the torsion bar; return its torque (N m) and winding rate (rad/s)."""
    mechanism, bar = linkage.mechanism, linkage.rig.torsion_bar
    if bar is None:
        return {}
    angle = linkage.of_pose("torsion_bar.angle", lambda whole: winding(whole, bar.on))
    torque = torsion_law(linkage, angle)
    mechanism.force(angle, -torque)
    mechanism.output(
        "torsion_bar.angle", angle, "rad", "turn of the torsion bar from design, positive in bump"
    )
    mechanism.output(
        "torsion_bar.torque", torque, "N*m", "torque of the torsion bar, positive against bump"
    )
    return {"torsion bar": (torque, mechanism.rate_of(angle))}


def add_both_alike(
    linkage: DescribedSuspension, *, damped: bool = True
) -> dict[str, tuple[ca.SX, ca.SX]]:
    """Add this wheel's half of third spring and Z-bar, with the other wheel moving in parallel; see ``add_strut``."""
    rig, mechanism = linkage.rig, linkage.mechanism
    both_alike: dict[str, tuple[ca.SX, ca.SX]] = {}
    if rig.third_spring is not None:
        half = third_deflection(linkage)
        deflection = half.value(linkage)
        force = third_law(
            linkage, 2.0 * linkage.side * linkage.hardpoint("third_spring_end")[1] - deflection
        )
        rate = mechanism.rate_of(deflection)
        force += third_damper_law(linkage, deflection, rate if damped else ca.SX(0.0))
        linkage.press(half, -0.5 * force)
        show_third_spring(mechanism, deflection, force)
        both_alike["third spring"] = force, 0.5 * rate
    if rig.anti_roll_bar is not None and rig.anti_roll_bar.kind == "z":
        end = bar_angle(linkage)
        angle = end.value(linkage)
        torque = bar_stiffness(linkage) * 2.0 * angle
        linkage.press(end, -torque)
        show_bar(mechanism, 2.0 * angle, torque)
        both_alike["Z-bar"] = torque, mechanism.rate_of(angle)
    return both_alike


def show_bar(mechanism: System, twist: ca.SX, torque: ca.SX) -> None:
    """Add channels of the anti-roll bar."""
    mechanism.output(
        "anti_roll_bar.twist",
        twist,
        "rad",
        "twist of the anti-roll bar from design, positive as its right end",
    )
    mechanism.output(
        "anti_roll_bar.torque",
        torque,
        "N*m",
        "torque in the anti-roll bar, positive against its twist",
    )


def show_third_spring(mechanism: System, deflection: ca.SX, force: ca.SX) -> None:
    """Add channels of the third spring."""
    mechanism.output(
        "third_spring.deflection",
        deflection,
        "m",
        "third spring, from design, compression positive",
    )
    mechanism.output(
        "third_spring.force", force, "N", "third spring and damper, compression positive"
    )


def show_motions(linkage: DescribedSuspension, centre: ca.SX, heave: ca.SX | None = None) -> None:
    """Add channels of body, wheel and its angles, and the guide's friction; heights (m) are relative to design.

    ``heave`` is the body's displacement, by default the guide's.
    """
    mechanism = linkage.mechanism
    bodies = [("unsprung", centre, "wheel centre")]
    if linkage.rig.guide != "fixed":
        heave = mechanism.coordinate_named("sprung.distance") if heave is None else heave
        _guide_friction(linkage, heave)
        bodies.insert(0, ("sprung", heave, "sprung mass"))
    for name, z, text in bodies:
        show_height(mechanism, name, z, text, ", height above design")
    show_wheel(linkage)


def _guide_friction(linkage: DescribedSuspension, heave: ca.SX) -> None:
    mechanism, friction = linkage.mechanism, linkage.rig.guide_friction
    if friction is None:
        return
    force = friction_force(mechanism, friction, "guide_friction", mechanism.rate_of(heave))
    mechanism.force(heave, -force)
    mechanism.output("guide.force", -force, "N", "guide friction on the sprung mass, up positive")


def show_wheel(linkage: DescribedSuspension) -> None:
    """Add channels of the wheel's angles."""
    show, of_wheel = linkage.mechanism.output, linkage.of_wheel
    show("wheel.camber", of_wheel("wheel.camber", _camber), "rad", "camber, positive top outward")
    show("wheel.steer", of_wheel("wheel.steer", _steer), "rad", "steer about +z")


def _camber(linkage: Suspension) -> ca.SX:
    return -ca.asin(linkage.carrier.outward(linkage.spin_direction.value)[2])


def _steer(linkage: Suspension) -> ca.SX:
    axis = linkage.carrier.outward(linkage.spin_direction.value)
    return ca.atan2(-linkage.side * axis[0], linkage.side * axis[1])
