"""Trailing or semi-trailing arm: one body on one axis."""

from __future__ import annotations

from jounce.models.linkage import Linkage


def trailing_arm(linkage: Linkage) -> None:
    """Hang the arm, which carries the wheel."""
    arm = linkage.body("arm")
    linkage.pivot("arm", arm, ("arm_outer", "arm_inner"))
    linkage.carry("arm", arm)
    linkage.owners.update({"arm_inner": linkage.chassis, "arm_outer": linkage.chassis})
    linkage.lines["arm"] = ("arm_inner", "wheel_centre", "arm_outer")
