"""Suspension templates: bodies, joints and rods of double wishbone, McPherson strut, five links and trailing arm.

Each connects its bodies to the car's body, closes its loops, and sets the body that carries the upright's parts.
"""

from __future__ import annotations

import casadi as ca

from jounce.mechanics.bodies import Body
from jounce.mechanics.bushings import add_sliding_bushing
from jounce.mechanics.rotations import unit
from jounce.models.linkage import Linkage


def double_wishbone(linkage: Linkage) -> None:
    """Add arms and upright, and close the loops."""
    mechanism = linkage.mechanism
    lower, upper = linkage.arm("lower_arm"), linkage.arm("upper_arm")
    upright = linkage.body("upright")
    bottom, top = linkage.hardpoint("lower_ball_joint"), linkage.hardpoint("upper_ball_joint")
    mechanism.spherical("lower_ball_joint", lower, upright, at=bottom)
    mechanism.coincident("upper_ball_joint", upper, upright, at=top)
    linkage.carry("upright", upright)
    linkage.rod("tie_rod", "tie_rod_inner", "tie_rod_outer", upright, steered=True)
    linkage.steering_axis = upright.frame.point(bottom), upright.frame.point(top)
    linkage.lines["upright"] = (
        "lower_ball_joint",
        "wheel_centre",
        "upper_ball_joint",
        "tie_rod_outer",
    )


def mcpherson(linkage: Linkage) -> None:
    """Add arm and upright; the strut's line on the upright passes through the strut's top on the body."""
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
    """Let the strut slide along its line on the upright; its top is attached to the body by a joint or a bushing."""
    mechanism, along, soft = linkage.mechanism, unit(top - foot), linkage.has_bushing("strut_top")
    if getattr(linkage.rig.bodies, "strut", None) is not None:
        strut = linkage.body("strut")
        mechanism.prismatic("strut_slider", upright, strut, axis=along, at=foot)
        if soft:
            linkage.cushion("strut_top", linkage.chassis, strut)
        else:
            mechanism.coincident("strut_top", linkage.chassis, strut, at=top)
    elif soft:
        law = linkage.linear_bushing("strut_top")
        add_sliding_bushing(mechanism, upright, linkage.chassis, foot, along, top, **law)
    else:
        mechanism.point_on_line(
            "strut_slider", upright, linkage.chassis, at=foot, axis=along, point=top
        )


def five_link(linkage: Linkage) -> None:
    """Add the upright as a free body and connect it by its links."""
    mechanism = linkage.mechanism
    upright = linkage.body("upright")
    mechanism.free(
        "upright", upright, at=linkage.hardpoint("wheel_centre"), moving_frame=linkage.moving_frame
    )
    linkage.carry("upright", upright)
    for i in range(1, 6):
        linkage.rod(f"link_{i}", f"link_{i}_inner", f"link_{i}_outer", upright, steered=i == 5)
    linkage.lines["upright"] = tuple(f"link_{i}_outer" for i in range(1, 6))


def trailing_arm(linkage: Linkage) -> None:
    """Add the arm, which carries the wheel."""
    arm = linkage.body("arm")
    linkage.pivot("arm", arm, ("arm_outer", "arm_inner"))
    linkage.carry("arm", arm)
    linkage.owners.update({"arm_inner": linkage.chassis, "arm_outer": linkage.chassis})
    linkage.lines["arm"] = ("arm_inner", "wheel_centre", "arm_outer")
