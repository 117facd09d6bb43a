"""The kind of rig that mechanism files can represent: a 3-D corner with a spring about its strut."""

from __future__ import annotations

from jounce.core.errors import OutputError
from jounce.parts import Corner, Rig


def corner_of(
    rig: Rig, what: str, allowed: str = "3-D corners such as kart-double-wishbone"
) -> Corner:
    """Return the rig if it is a 3-D corner; the error names the file ``what``."""
    if not isinstance(rig, Corner):
        raise OutputError(
            what, where="rig", found=getattr(rig, "model", type(rig).__name__), allowed=allowed
        )
    return rig


def require_parts(rig: Corner, *parts: str, what: str) -> None:
    """Refuse a corner without parts that the file ``what`` needs, or with a torsion bar for its spring."""
    rig.require("bodies", "spring", "damper", *parts, what=what)
    if "spring" in rig.without:
        raise OutputError(
            "a torsion bar in place of the strut's spring is not written", where="torsion_bar"
        )
