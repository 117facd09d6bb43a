"""Figures of every result, in one style. They show numbers and never compute them.

``jn.plots.show(result)`` draws anything; the functions below draw one kind each and give a matplotlib ``Figure``, which
:func:`write_figure` writes as SVG, PNG or PDF.
"""

from __future__ import annotations

from jounce.plots.animation import animate
from jounce.plots.bench import stiffness_fit, tyre_pressure
from jounce.plots.comparison import measured_against_simulated
from jounce.plots.dampers import damper_loops
from jounce.plots.decays import decay_fit
from jounce.plots.dispatch import figure_of, show
from jounce.plots.display import DisplayUnit, display_unit, number, quantity
from jounce.plots.histories import time_history
from jounce.plots.kinematics import kinematic_curves, write_kinematics
from jounce.plots.linear import frequency_response, modes
from jounce.plots.mechanisms import mechanism
from jounce.plots.roads import road_profile
from jounce.plots.style import add_note, new_figure, style, styled
from jounce.plots.sweeps import sweep
from jounce.plots.trials import residual_against_speed_and_pitch, trial_matrix
from jounce.plots.updating import objectives, update
from jounce.plots.writing import rendered, write_figure

__all__ = [
    "DisplayUnit",
    "add_note",
    "animate",
    "damper_loops",
    "decay_fit",
    "display_unit",
    "figure_of",
    "frequency_response",
    "kinematic_curves",
    "measured_against_simulated",
    "mechanism",
    "modes",
    "new_figure",
    "number",
    "objectives",
    "quantity",
    "rendered",
    "residual_against_speed_and_pitch",
    "road_profile",
    "show",
    "stiffness_fit",
    "style",
    "styled",
    "sweep",
    "time_history",
    "trial_matrix",
    "tyre_pressure",
    "update",
    "write_figure",
    "write_kinematics",
]
