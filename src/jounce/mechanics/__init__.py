"""Symbolic authoring of mechanical systems: coordinates, masses, force elements -> equations of motion."""

from jounce.mechanics.model import Model, Output
from jounce.mechanics.system import System, Track

__all__ = ["Model", "Output", "System", "Track"]
