"""Runs, equilibrium, linear models and modes of rigs."""

from jounce.simulation.free_run import simulate_mechanism
from jounce.simulation.linearise import LinearModel, Mode, equilibrium, linearise, modes
from jounce.simulation.run import simulate

__all__ = ["LinearModel", "Mode", "equilibrium", "linearise", "modes", "simulate", "simulate_mechanism"]
