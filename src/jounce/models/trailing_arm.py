"""Trailing or semi-trailing arm: one body on one axis."""

from __future__ import annotations

from jounce.models.linkage import Linkage


def trailing_arm(linkage: Linkage) -> None:
    """Hang the arm, which carries the wheel."""
    inner, outer = linkage.hardpoint("arm_inner"), linkage.hardpoint("arm_outer")
    arm = linkage.body("arm")
    linkage.mechanism.revolute("arm", linkage.chassis, arm, at=inner, axis=outer - inner)
    linkage.carry("arm", arm)
    linkage.owners.update({"arm_inner": linkage.chassis, "arm_outer": linkage.chassis})
    linkage.lines["arm"] = ("arm_inner", "wheel_centre", "arm_outer")
