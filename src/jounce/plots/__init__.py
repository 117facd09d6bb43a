"""Figures of every result, in one style. They show numbers and never compute them.

``jn.plots.show(result)`` draws anything; the functions below draw one kind each and give a matplotlib ``Figure``, which
:func:`write_figure` writes as SVG, PNG or PDF.
"""

from __future__ import annotations

from jounce.core.display import DisplayUnit, display_unit
from jounce.plots.campaign import measured_against_simulated, residual_against_speed_and_pitch, trial_matrix
from jounce.plots.comparison import compare
from jounce.plots.dispatch import figure_of, show
from jounce.plots.display import number, quantity
from jounce.plots.fits import damper_loops, decay_fit, objectives, stiffness_fit, tyre_pressure, update
from jounce.plots.kinematics import kinematic_curves, write_kinematics
from jounce.plots.mechanisms.drawing import mechanism
from jounce.plots.mechanisms.geometry import suspension_geometry
from jounce.plots.paper_figures import adjusted_and_not, paper_figures, update_on_every_trial
from jounce.plots.posterior import posterior_bands, posterior_draws, profile_likelihood
from jounce.plots.signals import frequency_response, modes, road_profile, sweep, time_history
from jounce.plots.style import add_note, new_figure, rendered, style, styled, write_figure
from jounce.plots.variants import parallel_coordinates, scatter_matrix, tornado, variant_bands

__all__ = [
    "DisplayUnit",
    "add_note",
    "adjusted_and_not",
    "compare",
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
    "paper_figures",
    "parallel_coordinates",
    "posterior_bands",
    "posterior_draws",
    "profile_likelihood",
    "quantity",
    "rendered",
    "residual_against_speed_and_pitch",
    "road_profile",
    "scatter_matrix",
    "show",
    "stiffness_fit",
    "style",
    "styled",
    "suspension_geometry",
    "sweep",
    "time_history",
    "tornado",
    "trial_matrix",
    "tyre_pressure",
    "update",
    "update_on_every_trial",
    "variant_bands",
    "write_figure",
    "write_kinematics",
]


def __dir__() -> list[str]:
    """Functions only: what can be drawn and written."""
    return [name for name in __all__ if name[0].islower()]
