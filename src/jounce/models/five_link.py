"""Five-link suspension: an upright held by five links; the fifth is the toe link and rides on the rack."""

from __future__ import annotations

from jounce.models.linkage import Linkage


def five_link(linkage: Linkage) -> None:
    """Let the upright fly and tie it by its links."""
    mechanism = linkage.mechanism
    upright = linkage.body("upright")
    mechanism.free("upright", upright, at=linkage.hardpoint("wheel_centre"), moving_frame=linkage.moving_frame)
    linkage.carry("upright", upright)
    for i in range(1, 6):
        linkage.rod(f"link_{i}", f"link_{i}_inner", f"link_{i}_outer", upright, steered=i == 5)
    linkage.lines["upright"] = tuple(f"link_{i}_outer" for i in range(1, 6))
