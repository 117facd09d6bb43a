"""Descriptions of other programs, read into jounce's names, units and signs."""

from jounce.parts.importers.chrono import import_chrono
from jounce.parts.importers.chrono_corner import ChronoCorner, DamperMap, read_chrono_corner, shipped_corner
from jounce.parts.importers.chrono_file import RigidPart

__all__ = ["ChronoCorner", "DamperMap", "RigidPart", "import_chrono", "read_chrono_corner", "shipped_corner"]
