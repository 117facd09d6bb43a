"""Runs, equilibrium, linear models and modes of rigs."""

from jounce.simulation.derivatives import Gradient, gradient, sensitivities
from jounce.simulation.free_run import simulate_mechanism
from jounce.simulation.linearise import LinearModel, Mode, equilibrium, linearise, modes
from jounce.simulation.run import simulate
from jounce.simulation.settings import RunSettings

__all__ = [
    "Gradient",
    "LinearModel",
    "Mode",
    "RunSettings",
    "equilibrium",
    "gradient",
    "linearise",
    "modes",
    "sensitivities",
    "simulate",
    "simulate_mechanism",
]
