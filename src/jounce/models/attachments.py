"""Force elements of a 3-D suspension: strut, bars and third spring, rocker, tyre."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from jounce.control.actuators import AnyActuator
from jounce.mechanics import System, Track
from jounce.mechanics.contact import towards_road
from jounce.mechanics.elements import (
    bump_stop_force,
    curve_force,
    damper_force,
    friction_force,
    tyre_force,
)
from jounce.mechanics.frames import Moving
from jounce.mechanics.rotations import unit
from jounce.models.actuation import replaced_tyre
from jounce.models.bars import Swing, TBar, t_bar
from jounce.models.linkage import DescribedSuspension, ElementLength, Linkage, Reached, Suspension
from jounce.parts.elements import CoilSpring, TyreLaw
from jounce.parts.leverage import AXES


def add_rocker(linkage: Linkage) -> None:
    """Add a rocker to the body and a push rod between it and the suspension."""
    rig = linkage.rig
    if getattr(rig.hardpoints, "rocker_pivot", None) is None:
        return
    pivot, end = linkage.hardpoint("rocker_pivot"), linkage.hardpoint("rocker_axis")
    rocker = linkage.body("rocker")
    linkage.mechanism.revolute("rocker", linkage.chassis, rocker, at=pivot, axis=end - pivot)
    outer, inner = linkage.hardpoint("pushrod_outer"), linkage.hardpoint("pushrod_inner")
    foot = getattr(rig.strut, "pushrod_on", "upright")
    linkage.mechanism.rod("pushrod", linkage.carriers[foot], rocker, outer, inner)
    linkage.owners.update(
        {"rocker_pivot": linkage.chassis, "rocker_axis": linkage.chassis, "pushrod_inner": rocker}
    )
    linkage.owners["pushrod_outer"] = linkage.carriers[foot]
    linkage.lines["pushrod"] = ("pushrod_outer", "pushrod_inner")
    linkage.lines["rocker"] = (
        "pushrod_inner",
        "rocker_pivot",
        *(["strut_bottom"] if rig.has_strut else []),
    )


def add_strut_points(linkage: Linkage) -> None:
    """Register the bodies to which the ends of spring and damper are attached."""
    rig = linkage.rig
    carrier = linkage.carriers[rig.strut.on]
    for element in ("strut", "spring", "damper"):
        for end, body in (("bottom", carrier), ("top", linkage.chassis)):
            if getattr(rig.hardpoints, f"{element}_{end}") is not None:
                linkage.owners[f"{element}_{end}"] = body
    if rig.has_strut:
        linkage.lines["strut"] = ("strut_bottom", "strut_top")
    if rig.third_spring is not None:
        linkage.owners["third_spring_end"] = linkage.carriers[rig.third_spring.on]


def spring_law(linkage: DescribedSuspension, line: ElementLength) -> ca.SX:
    """Return the force of the strut's spring (N, compression positive); zero if a torsion bar replaces it."""
    if "spring" not in linkage.rig.lacks and "spring" in linkage.rig.without:
        return ca.SX(0.0)
    return coil_law(
        linkage.mechanism, linkage.rig.strut.spring, "strut.spring", line.length, line.design
    )


def coil_law(
    mechanism: System, spring: CoilSpring, path: str, length: ca.SX, design: ca.SX
) -> ca.SX:
    """Return the force of a spring (N, compression positive) at a length, given its design length (m)."""
    free = spring.free_length is not None
    deflection = mechanism.parameter(f"{path}.free_length") - length if free else design - length
    if spring.curve is not None:
        force = curve_force(mechanism, spring.curve, f"{path}.curve", deflection)
    else:
        force = mechanism.parameter(f"{path}.rate") * deflection
    return force + mechanism.parameter(f"{path}.preload") if spring.preload is not None else force


def winding(linkage: Linkage, body: str) -> ca.SX:
    """Return the rotation (rad) of an arm or the rocker about its axis on the body from design; positive in bump."""
    point = linkage.hardpoint
    first, other, tip = AXES[body]
    pivot = point(first)
    axis = unit(point(other) - pivot)
    lever = point(tip) - pivot
    out = unit(lever - ca.dot(axis, lever) * axis)
    ahead = ca.cross(axis, out)
    if body == "rocker":  # in bump a push rod moves up and pushes, a pull rod moves down and pulls
        rod = point("pushrod_inner") - point("pushrod_outer")
        bump = ca.dot(rod, ahead) * rod[2]
    else:
        bump = ahead[2]
    now, (along, across) = (
        linkage.carriers[body].frame.direction(out).value,
        _directions_of_body(linkage, out, ahead),
    )
    return ca.if_else(bump < 0.0, -1.0, 1.0) * ca.atan2(ca.dot(across, now), ca.dot(along, now))


def _directions_of_body(linkage: Linkage, *directions: ca.SX) -> tuple[ca.SX, ...]:
    """Return directions fixed to the car's body, in its current attitude."""
    return tuple(linkage.chassis.frame.direction(direction).value for direction in directions)


def torsion_law(linkage: DescribedSuspension, angle: ca.SX) -> ca.SX:
    """Return the torque of the torsion bar (N m), positive against bump."""
    number = linkage.mechanism.parameter
    return number("torsion_bar.preload") + number("torsion_bar.stiffness") * angle


def third_end(linkage: Suspension) -> Moving:
    """Return the end of the third spring on this side."""
    on = linkage.rig.third_spring.on if linkage.rig.third_spring is not None else ""
    end = linkage.hardpoint("third_spring_end")
    return linkage.moving("third_spring_end", lambda whole: whole.carriers[on].frame.point(end))


def third_law(linkage: DescribedSuspension, length: ca.SX) -> ca.SX:
    """Return the force of the third spring (N, compression positive) at a length (m)."""
    third, design = (
        linkage.rig.third_spring,
        2.0 * linkage.side * linkage.hardpoint("third_spring_end")[1],
    )
    assert third is not None
    return coil_law(linkage.mechanism, third.spring, "third_spring.spring", length, design)


def third_damper_law(linkage: DescribedSuspension, deflection: ca.SX, velocity: ca.SX) -> ca.SX:
    """Return the force of the third damper (N, compression positive)."""
    assert linkage.rig.third_spring is not None
    damper = linkage.rig.third_spring.damper
    if damper is None:
        return ca.SX(0.0)
    return damper_force(linkage.mechanism, damper, "third_spring.damper", deflection, velocity)


def still_third_law(linkage: DescribedSuspension, length: ca.SX) -> ca.SX:
    """Return the force of the third damper at rest (N, compression positive) at a length (m)."""
    design = 2.0 * linkage.side * linkage.hardpoint("third_spring_end")[1]
    return third_damper_law(linkage, design - length, ca.SX(0.0))


def third_deflection(linkage: DescribedSuspension) -> Reached:
    """Return the shortening (m) of the third spring when the other wheel moves in parallel."""
    third = linkage.rig.third_spring
    assert third is not None

    def shortening(whole: DescribedSuspension, end: ca.SX) -> ca.SX:
        return 2.0 * whole.side * (whole.hardpoint("third_spring_end") - end)[1]

    return Reached("third_spring.deflection", third.on, "third_spring_end", shortening)


# anti-roll bar --------------------------------------------------------------------------------------------------------


_LEFT = ca.SX([0.0, 1.0, 0.0])


def bar_on(linkage: DescribedSuspension) -> str:
    """Return the name of the body to which the anti-roll bar's link is attached."""
    return str(getattr(linkage.rig.anti_roll_bar, "on", "upright"))


def link_end(linkage: Suspension) -> Moving:
    """Return the end of the anti-roll bar's link on the suspension."""
    end = linkage.hardpoint("arb_link_end")
    return linkage.moving(
        "arb_link_end", lambda whole: whole.carriers[bar_on(whole)].frame.point(end)
    )


def bar_axis(linkage: DescribedSuspension) -> ca.SX:
    """Return the direction of the anti-roll bar's axis on the car's body, pointing to the left.

    For a bar across the car it is as given. A T-bar is hinged across the car; its stem twists by the difference of the
    ends of its bar.
    """
    bar = linkage.rig.anti_roll_bar
    if getattr(linkage.rig.hardpoints, "arb_axis", None) is None or (
        bar is not None and bar.kind == "t"
    ):
        return _LEFT
    along = unit(linkage.hardpoint("arb_axis") - linkage.hardpoint("arb_pivot"))
    return along * ca.if_else(along[1] < 0.0, -1.0, 1.0)


def bar_angle(linkage: DescribedSuspension) -> Reached:
    """Return the rotation of the anti-roll bar's end about its axis, which points to the left, rad, 0 at design."""

    def turn(whole: DescribedSuspension, end: ca.SX) -> ca.SX:
        pivot, arm, link_ends = (
            whole.hardpoint(f"arb_{name}") for name in ("pivot", "arm_end", "link_end")
        )
        return Swing.of(bar_axis(whole), arm - pivot, link_ends - pivot, end - pivot).angle

    return Reached("anti_roll_bar.angle", bar_on(linkage), "arb_link_end", turn)


def t_bar_of(left: Suspension, right: Suspension) -> TBar:
    """Return the T-bar between two suspensions in the same axes."""
    pivot = left.hardpoint("arb_pivot")
    sides = (left, right)
    arms = [side.hardpoint("arb_arm_end") - pivot for side in sides]
    link_ends = [side.hardpoint("arb_link_end") - pivot for side in sides]
    ends = [link_end(side).value - pivot for side in (left, right)]
    return t_bar(left.hardpoint("arb_axis") - pivot, arms, link_ends, ends)


def bar_stiffness(linkage: DescribedSuspension) -> ca.SX:
    """Return the stiffness of the anti-roll bar with its blades in series, N m/rad of twist."""
    number, bar = linkage.mechanism.parameter, linkage.rig.anti_roll_bar
    stiffness = number("anti_roll_bar.stiffness")
    assert bar is not None
    if bar.blade is None:
        return stiffness
    width, thickness, angle, modulus = (
        number(f"anti_roll_bar.blade.{name}")
        for name in ("width", "thickness", "angle", "youngs_modulus")
    )
    arm = linkage.hardpoint("arb_arm_end") - linkage.hardpoint("arb_pivot")
    axis = bar_axis(linkage)
    if bar.kind == "t":
        axis = unit(linkage.hardpoint("arb_axis") - linkage.hardpoint("arb_pivot"))
    out = arm - ca.dot(axis, arm) * axis
    flat, edge = width * thickness**3 / 12.0, thickness * width**3 / 12.0
    # 1/m^4: each component of the force bends about its own axis
    bent = ca.cos(angle) ** 2 / flat + ca.sin(angle) ** 2 / edge
    blade = ca.sqrt(ca.dot(out, out)) / (3.0 * modulus) * bent  # rad/(N m) of one arm
    return 1.0 / (1.0 / stiffness + (0.5 if bar.kind == "t" else 2.0) * blade)


# springs and dampers of the strut -------------------------------------------------------------------------------------


def stop_law(linkage: DescribedSuspension, line: ElementLength) -> ca.SX:
    """Return the force of bump and rebound stops (N, compression positive)."""
    strut = linkage.rig.strut
    bump = bump_stop_force(linkage.mechanism, strut.bump_stop, "strut.bump_stop", line.deflection)
    rebound = bump_stop_force(
        linkage.mechanism, strut.rebound_stop, "strut.rebound_stop", -line.deflection
    )
    return bump - rebound


def damper_law(linkage: DescribedSuspension, line: ElementLength) -> ca.SX:
    """Return the damper force (N, compression positive)."""
    mechanism, damper = linkage.mechanism, linkage.rig.strut.damper
    return damper_force(
        mechanism, damper, "strut.damper", line.deflection, -line.rate, length=line.length
    )


def friction_law(linkage: DescribedSuspension, line: ElementLength) -> ca.SX:
    """Return the strut's dry friction (N, compression positive), which remains if an actuator replaces the damper."""
    return friction_force(
        linkage.mechanism, linkage.rig.strut.friction, "strut.friction", -line.rate
    )


def undeformed_radius(linkage: DescribedSuspension) -> ca.SX:
    """Return the radius of the unloaded tyre, m."""
    given = linkage.rig.tyre.undeformed_radius is not None
    return linkage.number("tyre.undeformed_radius" if given else "wheel.radius")


@dataclass(frozen=True)
class Pressed:
    """A tyre on its road: deflection (m), contact force (N, normal to the road), and contact point on the upright.

    The point moves with the upright, in the axes of the suspension's carrier; road and point approach each other at the
    rate ``closing`` (m/s).
    """

    deflection: ca.SX
    force: ca.SX
    point: Moving
    closing: ca.SX


def loaded_radius(linkage: Suspension, road: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Return distance (m) and direction to a road at a height (m) in the wheel's plane, and cosine of inclination."""
    down, upright = towards_road(linkage.spin_direction.value, linkage.carrier.up)
    return (
        (linkage.carrier.height(linkage.wheel_centre.value) - road) / upright,
        ca.vertcat(*down),
        upright,
    )


def contact_point(linkage: Suspension, road: ca.SX) -> tuple[Moving, ca.SX]:
    """Return the contact point on a road at a height (m), as a point of the upright, and cosine of the inclination."""
    centre, orientation = linkage.wheel_centre, linkage.upright.frame.orientation
    reach, down, upright = loaded_radius(linkage, road)
    arm = reach * down
    turn, bent = orientation.ground_spin, orientation.rotate(orientation.spin_bias)
    swept = ca.cross(turn, arm)
    bias = centre.bias + ca.cross(bent, arm) + ca.cross(turn, swept)
    return Moving(centre.value + arm, centre.rate + swept, bias), upright


def lowest_point(linkage: Suspension, road: ca.SX) -> ca.SX:
    """Return the contact point on a road at a height (m), ground axes; above the road if the wheel is off it."""
    reach, down, _ = loaded_radius(linkage, road)
    if linkage.rig.tyre.lift_off:
        reach = ca.fmin(reach, undeformed_radius(linkage))
    return linkage.carrier.place(linkage.wheel_centre.value + reach * down)


def add_tyre(
    linkage: Suspension,
    road: Track,
    actuator: AnyActuator | None = None,
    *,
    law: TyreLaw | None = None,
) -> Pressed:
    """Add the tyre's force on the wheel, by default with the ``law`` of its description.

    A vertical tyre pushes the wheel's centre up. A radial tyre deflects in the wheel's plane: with the height h of the
    centre above the road and the cosine c of the inclination it stores V(R - h / c), and the frictionless road exerts
    the normal force F / c at the contact point, which rises by -c for each metre of deflection.
    """
    rig, mechanism, carrier = linkage.rig, linkage.mechanism, linkage.carrier
    point, upright = linkage.wheel_centre, ca.SX(1.0)
    if (law or rig.tyre.law) == "radial":
        point, upright = contact_point(linkage, road.value)
    closing = road.rate - ca.dot(carrier.up, carrier.velocity(point))
    deflection = (
        undeformed_radius(linkage)
        - (carrier.height(linkage.wheel_centre.value) - road.value) / upright
    )
    force = tyre_law(linkage, deflection, closing / upright, actuator) / upright
    mechanism.apply_force(linkage.upright, force * carrier.up, point)
    return Pressed(deflection, force, point, closing)


def tyre_law(
    linkage: DescribedSuspension,
    deflection: ca.SX,
    rate: ca.SX,
    actuator: AnyActuator | None = None,
) -> ca.SX:
    """Return the force (N) of the tyre, or of its replacement, at a deflection (m) and its rate (m/s)."""
    law = replaced_tyre(linkage.mechanism, actuator, rate)
    return tyre_force(linkage.mechanism, linkage.rig.tyre, deflection, rate, law)
