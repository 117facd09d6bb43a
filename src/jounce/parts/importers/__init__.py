"""Import of descriptions from other programs, converted to jounce's names, units and signs."""

from jounce.parts.importers.adams import import_adams
from jounce.parts.importers.chrono import import_chrono
from jounce.parts.importers.chrono_file import (
    ChronoCorner,
    DamperMap,
    RigidPart,
    read_chrono_corner,
    shipped_corner,
)
from jounce.parts.importers.curves import PastedCurve, read_pasted_curve
from jounce.parts.importers.hardpoints import import_hardpoints
from jounce.parts.importers.mjcf import import_mjcf
from jounce.parts.importers.pasted import PastedPoints, read_pasted_points
from jounce.parts.importers.tir import TyreProperties, read_tir, tyre_from_tir

__all__ = [
    "ChronoCorner",
    "DamperMap",
    "PastedCurve",
    "PastedPoints",
    "RigidPart",
    "TyreProperties",
    "import_adams",
    "import_chrono",
    "import_hardpoints",
    "import_mjcf",
    "read_chrono_corner",
    "read_pasted_curve",
    "read_pasted_points",
    "read_tir",
    "shipped_corner",
    "tyre_from_tir",
]
