"""Force elements of a 3-D suspension: spring, damper and stops of the strut, rocker, tyre."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from jounce.mechanics import Track
from jounce.mechanics.elements import (
    bump_stop_force,
    curve_force,
    damper_force,
    damper_map_force,
    friction_force,
    tyre_force,
)
from jounce.mechanics.frames import Moving
from jounce.mechanics.rotations import unit
from jounce.models.linkage import Linkage
from jounce.parts.elements import MapDamper


@dataclass(frozen=True)
class Line:
    """The line between the two ends of an element: ends, length and its rate, length at design."""

    bottom: Moving
    top: Moving
    length: ca.SX
    rate: ca.SX
    design: ca.SX

    @property
    def deflection(self) -> ca.SX:
        """Design length minus length, m."""
        return self.design - self.length


def line_of(linkage: Linkage, element: str) -> Line:
    """Give the line of ``"spring"`` or ``"damper"``."""
    bottom, top = linkage.end_of(element, "bottom"), linkage.end_of(element, "top")
    lower, upper = linkage.carriers[linkage.rig.strut.on].frame.point(bottom), linkage.chassis.frame.point(top)
    reach = upper - lower
    length = ca.sqrt(ca.dot(reach.value, reach.value))
    design = top - bottom
    return Line(lower, upper, length, ca.dot(reach.value, reach.rate) / length, ca.sqrt(ca.dot(design, design)))


def add_rocker(linkage: Linkage) -> None:
    """Hang a rocker on the body and a push rod between it and the suspension."""
    rig = linkage.rig
    if getattr(rig.hardpoints, "rocker_pivot", None) is None:
        return
    pivot, end = linkage.hardpoint("rocker_pivot"), linkage.hardpoint("rocker_axis")
    rocker = linkage.body("rocker")
    linkage.mechanism.revolute("rocker", linkage.chassis, rocker, at=pivot, axis=end - pivot)
    outer, inner = linkage.hardpoint("pushrod_outer"), linkage.hardpoint("pushrod_inner")
    foot = getattr(rig.strut, "pushrod_on", "upright")
    linkage.mechanism.rod("pushrod", linkage.carriers[foot], rocker, outer, inner)
    linkage.owners.update({"rocker_pivot": linkage.chassis, "rocker_axis": linkage.chassis, "pushrod_inner": rocker})
    linkage.owners["pushrod_outer"] = linkage.carriers[foot]
    linkage.lines["pushrod"] = ("pushrod_outer", "pushrod_inner")
    linkage.lines["rocker"] = ("pushrod_inner", "rocker_pivot", "strut_bottom")


def add_strut_points(linkage: Linkage) -> None:
    """Say which bodies the ends of spring and damper move with."""
    rig = linkage.rig
    carrier = linkage.carriers[rig.strut.on]
    for element in ("strut", "spring", "damper"):
        for end, body in (("bottom", carrier), ("top", linkage.chassis)):
            if getattr(rig.hardpoints, f"{element}_{end}") is not None:
                linkage.owners[f"{element}_{end}"] = body
    linkage.lines["strut"] = ("strut_bottom", "strut_top")


def spring_law(linkage: Linkage, line: Line) -> ca.SX:
    """Spring force (N, compression positive)."""
    mechanism, spring, path = linkage.mechanism, linkage.rig.strut.spring, "strut.spring"
    free = spring.free_length is not None
    deflection = mechanism.parameter(f"{path}.free_length") - line.length if free else line.deflection
    if spring.curve is not None:
        force = curve_force(mechanism, spring.curve, f"{path}.curve", deflection)
    else:
        force = mechanism.parameter(f"{path}.rate") * deflection
    return force + mechanism.parameter(f"{path}.preload") if spring.preload is not None else force


def stop_law(linkage: Linkage, line: Line) -> ca.SX:
    """Force of bump and rebound stops (N, compression positive)."""
    strut = linkage.rig.strut
    bump = bump_stop_force(linkage.mechanism, strut.bump_stop, "strut.bump_stop", line.deflection)
    rebound = bump_stop_force(linkage.mechanism, strut.rebound_stop, "strut.rebound_stop", -line.deflection)
    return bump - rebound


def damper_law(linkage: Linkage, line: Line) -> ca.SX:
    """Damper and friction force (N, compression positive)."""
    mechanism, strut = linkage.mechanism, linkage.rig.strut
    if isinstance(strut.damper, MapDamper):
        force = damper_map_force(mechanism, strut.damper, "strut.damper", line.length, -line.rate)
    else:
        force = damper_force(mechanism, strut.damper, "strut.damper", line.deflection, -line.rate)
    return force + friction_force(mechanism, strut.friction, "strut.friction", -line.rate)


def push(linkage: Linkage, line: Line, force: ca.SX) -> None:
    """Let a force push the ends of a line apart."""
    body = linkage.carriers[linkage.rig.strut.on]
    linkage.mechanism.push_apart(linkage.chassis, body, line.top, line.bottom, force)


def undeformed_radius(linkage: Linkage) -> ca.SX:
    """Radius of the unloaded tyre, m."""
    given = linkage.rig.tyre.undeformed_radius is not None
    return linkage.number("tyre.undeformed_radius" if given else "wheel.radius")


def wheel_down(linkage: Linkage) -> ca.SX:
    """Unit vector in the wheel's plane towards the road."""
    axis, up = linkage.spin_direction.value, linkage.carrier.up
    return unit(axis * ca.dot(axis, up) - up)


def add_tyre(linkage: Linkage, road: Track) -> tuple[ca.SX, ca.SX]:
    """Let the tyre carry the wheel; give its deflection (m) and force (N), compression positive."""
    rig, mechanism, centre, carrier = linkage.rig, linkage.mechanism, linkage.wheel_centre, linkage.carrier
    height = carrier.height(centre.value) - road.value
    if rig.tyre.law == "radial":
        along = -wheel_down(linkage)
        deflection = undeformed_radius(linkage) - height / ca.dot(along, carrier.up)
        rate = mechanism.rate_of(deflection)
    else:
        along = carrier.up
        deflection = undeformed_radius(linkage) - height
        rate = road.rate - ca.dot(along, carrier.velocity(centre))
    force = tyre_force(mechanism, rig.tyre, deflection, rate)
    mechanism.apply_force(linkage.upright, force * along, centre)
    return deflection, force
