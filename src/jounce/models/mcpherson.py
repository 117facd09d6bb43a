"""McPherson strut: one arm, and an upright whose strut slides through a ball joint on the body."""

from __future__ import annotations

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
    if linkage.has_bushing("strut_top"):
        bushing = linkage.bushing_of("strut_top")[:2]
        add_sliding_bushing(mechanism, upright, linkage.chassis, foot, unit(top - foot), top, *bushing)
    else:
        mechanism.point_on_line("strut_slider", upright, linkage.chassis, at=foot, axis=unit(top - foot), point=top)
    linkage.carry("upright", upright)
    linkage.rod("tie_rod", "tie_rod_inner", "tie_rod_outer", upright, steered=True)
    linkage.steering_axis = upright.point(ball), linkage.chassis.point(top)
    linkage.lines["upright"] = ("lower_ball_joint", "wheel_centre", "strut_bottom", "tie_rod_outer")
