"""Immutable, validated descriptions of suspension components, and their files."""

from jounce.parts.advice import rig_findings
from jounce.parts.axles import DependentAxle, SolidAxle, TwistBeam
from jounce.parts.corners import Corner, DoubleWishbone, FiveLink, McPherson, TrailingArm
from jounce.parts.files import as_rig, changed_text, library, load, rig_from_table, rig_path, save
from jounce.parts.rig import Rig
from jounce.parts.vehicles import FullCar, FullCar3D, HalfCar, HalfCar4DOF, QuarterCar, Vehicle

__all__ = [
    "Corner",
    "DependentAxle",
    "DoubleWishbone",
    "FiveLink",
    "FullCar",
    "FullCar3D",
    "HalfCar",
    "HalfCar4DOF",
    "McPherson",
    "QuarterCar",
    "Rig",
    "SolidAxle",
    "TrailingArm",
    "TwistBeam",
    "Vehicle",
    "as_rig",
    "changed_text",
    "library",
    "load",
    "rig_findings",
    "rig_from_table",
    "rig_path",
    "save",
]
