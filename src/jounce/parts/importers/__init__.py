"""Descriptions of other programs, read into jounce's names, units and signs."""

from jounce.parts.importers.chrono_corner import (
    ChronoCorner,
    DamperMap,
    RigidPart,
    read_chrono_corner,
    shipped_corner,
)

__all__ = ["ChronoCorner", "DamperMap", "RigidPart", "read_chrono_corner", "shipped_corner"]
