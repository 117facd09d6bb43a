"""Page of a sweep: extremes and curves, then all quantities at selected poses."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.kc.tests import TESTS
from jounce.parts import Corner, DependentAxle
from jounce.plots.display import kinematic_value, number
from jounce.report.chart import Chart
from jounce.report.kc_drawing import axle_drawing
from jounce.report.page import Block, Page, PageTable, Paragraph, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from jounce.kinematics.swept import Swept

_SHOWN = 7
"""Number of poses in the table: as many as fit side by side."""


_CURVES = (
    "toe",
    "camber",
    "caster",
    "kingpin_inclination",
    "scrub_radius",
    "caster_trail",
    "half_track_change",
    "lateral_shift",
    "axle_steer",
    "roll_centre_height",
    "roll_steer",
    "ackermann_percentage",
    "motion_ratio",
    "wheel_rate",
)
"""Curves shown at first, of each wheel; all others can be selected in the viewer and are in the table."""


def swept_page(sweep: Swept, *, title: str) -> Page:
    """Create a page of a sweep: extremes, curves, the mechanism with its hardpoints, and all quantities."""

    def blocks(number: int) -> tuple[Block, ...]:
        from jounce.plots.signals import preferred_channels
        from jounce.report.recordings import recordings_page

        data = sweep.data
        along = [str(name) for name, values in data.data_vars.items() if values.ndim == 1]
        first = preferred_channels(along, [(name,) for name in _CURVES], len(along))
        page = recordings_page({title: data}, first or None, title=title, rig=sweep.rig)
        return page.sections[number].blocks

    drawn = [Section("Extremes", partial(blocks, 0)), Section("Curves", partial(blocks, 1))]
    if isinstance(sweep.rig, Corner | DependentAxle):
        drawn.append(Section("Mechanism", partial(_mechanism, sweep.rig, title)))
    return Page(title, (*drawn, Section("Poses", poses_table(sweep))), "Kinematic sweep")


def _mechanism(rig: Corner | DependentAxle, title: str) -> tuple[Block, ...]:
    """Return the drawing and the table of hardpoints."""
    if isinstance(rig, Corner):
        return mechanism_picture(rig, title), hardpoints_table(rig)
    drawing = axle_drawing(rig, TESTS["bounce"])
    words = f"{title}: both wheels and what joins them at design; arrows: bump."
    charts = () if drawing is None else (Chart((drawing,), "mechanism", words, words),)
    return *charts, hardpoints_table(rig)


def mechanism_picture(rig: Corner, title: str) -> Picture:
    """Return the drawing in front, side and top view and in perspective."""

    def draw() -> Figure:
        from jounce.plots.mechanisms.drawing import mechanism

        return mechanism(rig)

    words = f"{title}: front, side and top view at design, and perspective."
    return Picture(draw, "mechanism", words, words)


def hardpoints_table(rig: Corner | DependentAxle) -> PageTable:
    """Return the coordinates of all hardpoints at design, in the usual unit of lengths."""
    unit = display_unit("m")
    rows = tuple(
        (name.replace("_", " "), *(_coordinate(value * unit.factor) for value in place))
        for name, place in rig.hardpoints
        if isinstance(place, tuple)
    )
    header = ("hardpoint", *(unit.label(axis) for axis in "xyz"))
    note = "x forward, y left, z up."
    return PageTable("Hardpoints at design", header, rows, "lrrr", note)


def _coordinate(value: float) -> str:
    return f"{value:.2f}".replace("-", "−")


def poses_table(sweep: Swept) -> tuple[Block, ...]:
    """Return a table of all quantities at selected poses; for a grid, the other axis is nearest to design."""
    along, *others = map(str, sweep.data.dims)
    shown = sweep.data.sel(dict.fromkeys(others, 0.0), method="nearest") if others else sweep.data
    count = shown.sizes[along]
    at = np.unique(np.linspace(0, count - 1, min(count, _SHOWN)).round().astype(int))
    unit = display_unit(str(shown[along].attrs.get("units", "1")))  # poses are numbered
    rows = []
    for name, variable in shown.data_vars.items():
        values, si = variable.to_numpy(), str(variable.attrs["units"])
        own = display_unit(si, float(np.nanmax(np.abs(values), initial=0.0)))
        cells = (kinematic_value(str(name), float(value), si) for value in values[at])
        rows.append(
            (
                str(name),
                own.name or "–",
                *(cell if isinstance(cell, str) else number(cell) for cell in cells),
            )
        )
    places = (
        f"{value * unit.factor:.4g} {unit.name}".strip() for value in shown[along].to_numpy()[at]
    )
    caption = f"Quantities over {along.replace('_', ' ')}"
    many = "".join(
        f" at each of {sweep.data.sizes[name]} values of {name.replace('_', ' ')}"
        for name in others
    )
    words = f"{count} poses{many}{', shown for the one nearest to 0' if others else ''}"
    header = ("quantity", "unit", *places)
    return PageTable(caption, header, tuple(rows), "ll" + "r" * len(at)), Paragraph(words, "muted")


def effort_page(sweep: Swept, *, title: str) -> Page:
    """Create a page of the steering effort over a sweep."""
    return Page(title, (Section("Poses", poses_table(sweep)),), "Steering effort")
