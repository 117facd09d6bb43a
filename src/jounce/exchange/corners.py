"""Checks of rigs for export as mechanisms: 3-D corners with a spring on the strut."""

from __future__ import annotations

from jounce.core.errors import OutputError
from jounce.parts import Corner, Rig


def corner_of(
    rig: Rig, what: str, allowed: str = "3-D corners such as kart-double-wishbone"
) -> Corner:
    """Return the rig if it is a 3-D corner, else raise an error with the text ``what``."""
    if not isinstance(rig, Corner):
        raise OutputError(
            what, where="rig", found=getattr(rig, "model", type(rig).__name__), allowed=allowed
        )
    return rig


def require_parts(rig: Corner, *parts: str, what: str) -> None:
    """Refuse a corner that lacks parts required by the file ``what``, or has a torsion bar instead of its spring."""
    rig.require("bodies", "spring", "damper", *parts, what=what)
    if "spring" in rig.without:
        raise OutputError(
            "export of a torsion bar instead of the strut's spring is not supported",
            where="torsion_bar",
        )
