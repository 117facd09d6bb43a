"""Documents: pages of text, tables and figures as one HTML file each, with their figures and data beside it.

:func:`write_campaign` reports a bench campaign, :func:`write_protocol` the test of a car's shock absorbers; any other
page is put together from :class:`Page` and :class:`Section` and written by :func:`write_page`. Nothing here computes a
physical number.
"""

from __future__ import annotations

from jounce.plots.style import write_figure
from jounce.report.animation import animate
from jounce.report.campaign import campaign_page, write_campaign
from jounce.report.decisions import design_front_page, front_page, optimisation_page
from jounce.report.equivalence import equivalence_page
from jounce.report.fits import damper_page, decay_page, stiffness_page
from jounce.report.history import history_page
from jounce.report.kinematic_design import kinematic_design_page
from jounce.report.load_cases import load_cases_page
from jounce.report.models import model_comparison_page, modes_page, roughness_page
from jounce.report.page import (
    Bullets,
    Cell,
    Details,
    Fact,
    Facts,
    Findings,
    Page,
    Paragraph,
    Picture,
    Section,
    Subsection,
    Table,
)
from jounce.report.posterior import posterior_page
from jounce.report.protocol import write_protocol
from jounce.report.recordings import recordings_page
from jounce.report.render import REPORTS, write_folder, write_page
from jounce.report.ride import ride_page
from jounce.report.variants import sweep_page

__all__ = [
    "REPORTS",
    "Bullets",
    "Cell",
    "Details",
    "Fact",
    "Facts",
    "Findings",
    "Page",
    "Paragraph",
    "Picture",
    "Section",
    "Subsection",
    "Table",
    "animate",
    "campaign_page",
    "damper_page",
    "decay_page",
    "design_front_page",
    "equivalence_page",
    "front_page",
    "history_page",
    "kinematic_design_page",
    "load_cases_page",
    "model_comparison_page",
    "modes_page",
    "optimisation_page",
    "posterior_page",
    "recordings_page",
    "ride_page",
    "roughness_page",
    "stiffness_page",
    "sweep_page",
    "write_campaign",
    "write_figure",
    "write_folder",
    "write_page",
    "write_protocol",
]
