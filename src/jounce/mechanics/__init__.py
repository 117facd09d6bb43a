"""Symbolic authoring of mechanical systems: coordinates, masses, force elements -> equations of motion."""

from jounce.mechanics.model import Model, Output
from jounce.mechanics.mechanism import Mechanism
from jounce.mechanics.system import System, Track

__all__ = ["Mechanism", "Model", "Output", "System", "Track"]
