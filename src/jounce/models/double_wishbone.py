"""Double wishbone: two arms on the body, the upright between their ball joints, a tie rod."""

from __future__ import annotations

from jounce.models.linkage import Linkage


def double_wishbone(linkage: Linkage) -> None:
    """Hang arms and upright, close the loops."""
    mechanism = linkage.mechanism
    lower, upper = linkage.arm("lower_arm"), linkage.arm("upper_arm")
    upright = linkage.body("upright")
    bottom, top = linkage.hardpoint("lower_ball_joint"), linkage.hardpoint("upper_ball_joint")
    mechanism.spherical("lower_ball_joint", lower, upright, at=bottom)
    mechanism.coincident("upper_ball_joint", upper, upright, at=top)
    linkage.carry("upright", upright)
    linkage.rod("tie_rod", "tie_rod_inner", "tie_rod_outer", upright, steered=True)
    linkage.steering_axis = upright.frame.point(bottom), upright.frame.point(top)
    linkage.lines["upright"] = ("lower_ball_joint", "wheel_centre", "upper_ball_joint", "tie_rod_outer")
