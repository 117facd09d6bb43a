"""McPherson strut: one arm, and an upright whose strut slides through a ball joint on the body."""

from __future__ import annotations

import casadi as ca

from jounce.mechanics.bodies import Body
from jounce.mechanics.bushings import add_sliding_bushing
from jounce.mechanics.rotations import unit
from jounce.models.linkage import Linkage


def mcpherson(linkage: Linkage) -> None:
    """Hang arm and upright; the strut's line on the upright runs through the strut's top on the body."""
    mechanism = linkage.mechanism
    lower = linkage.arm("lower_arm")
    upright = linkage.body("upright")
    ball, top = linkage.hardpoint("lower_ball_joint"), linkage.hardpoint("strut_top")
    foot = linkage.hardpoint("strut_bottom")
    mechanism.spherical("lower_ball_joint", lower, upright, at=ball)
    _slide(linkage, upright, foot, top)
    linkage.carry("upright", upright)
    linkage.rod("tie_rod", "tie_rod_inner", "tie_rod_outer", upright, steered=True)
    linkage.steering_axis = upright.frame.point(ball), linkage.chassis.frame.point(top)
    linkage.lines["upright"] = ("lower_ball_joint", "wheel_centre", "strut_bottom", "tie_rod_outer")


def _slide(linkage: Linkage, upright: Body, foot: ca.SX, top: ca.SX) -> None:
    """Let the strut slide along its line on the upright; its top stays on the body, at a joint or in a bushing."""
    mechanism, along, soft = linkage.mechanism, unit(top - foot), linkage.has_bushing("strut_top")
    if getattr(linkage.rig.bodies, "strut", None) is not None:
        strut = linkage.body("strut")
        mechanism.prismatic("strut_slider", upright, strut, axis=along, at=foot)
        if soft:
            linkage.cushion("strut_top", linkage.chassis, strut)
        else:
            mechanism.coincident("strut_top", linkage.chassis, strut, at=top)
    elif soft:
        law = linkage.bushing_of("strut_top")
        add_sliding_bushing(mechanism, upright, linkage.chassis, foot, along, top, law["stiffness"], law["damping"])
    else:
        mechanism.point_on_line("strut_slider", upright, linkage.chassis, at=foot, axis=along, point=top)
