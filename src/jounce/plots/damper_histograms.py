"""Figures of damper histograms: travel and velocity of each corner, and the zones of velocity over laps."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from jounce.core.display import DisplayUnit, display_unit_for, size
from jounce.dampers.corners import AXLES
from jounce.dampers.histograms import ZONES, edges_of
from jounce.plots.figures import AFTER, INK, MUTED, PALETTE, in_style, legend_outside, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.dampers.histograms import DamperHistograms

_LOW, _HIGH = "#7fb2d9", AFTER
_MODEL = "#d55e00"
_SHORT = {"front_left": 0, "front_right": 1, "rear_left": 0, "rear_right": 1}
Quantity = Literal["velocity", "travel"]


@in_style
def damper_histogram_bars(
    result: DamperHistograms, quantity: Quantity = "velocity", section: str = "whole"
) -> Figure:
    """Draw the histogram of each corner: bars of the first record, lines of the others and of the model.

    Parameters
    ----------
    result : DamperHistograms
        Result of :func:`jounce.damper_histograms`.
    quantity : {"velocity", "travel"}
        What is drawn.
    section : str
        "whole", "lap 1", "sector 2" and so on.

    Returns
    -------
    matplotlib.figure.Figure
        One panel for each corner, front above rear and left beside right, as seen from above.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> t = np.arange(0.0, 20.0, 1e-3)
    >>> travel = 0.01 * np.sin(12.0 * t)
    >>> made = jn.damper_histograms(jn.recording(t, {"front_left.damper.travel": (travel, "m", "")}))
    >>> jn.plots.figure_of(made).axes[0].get_xlabel()
    'velocity, bump positive [mm/s]'
    """
    corners = result.corners
    rows, columns = _layout(corners)
    figure = new_figure(0.6 + 2.3 * rows, 7.6 if columns > 1 else 4.6)
    panels = figure.subplots(rows, columns, squeeze=False, sharex=True, sharey=True)
    unit = unit_of(quantity)
    edges = edges_of(result.data[quantity].to_numpy()) * unit.factor
    used = set()
    for k, corner in enumerate(corners):
        place = _place(corner, k, corners)
        used.add(place)
        axes = panels[place]
        for r, record in enumerate(result.records):
            shares = _shares(result, quantity, record, section, corner)
            if shares is not None:
                _draw(axes, result, quantity, edges, shares, r, record)
        axes.set_title(corner_words(corner))
        if quantity == "velocity":
            _zone_words(axes, result, section, corner)
        axes.grid(visible=False, axis="x")
    for i in range(rows):
        for j in range(columns):
            if (i, j) not in used:
                panels[i, j].set_visible(False)
    for axes in panels[-1]:
        axes.set_xlabel(unit.label(f"{quantity}, bump positive"))
    for axes in panels[:, 0]:
        axes.set_ylabel("share of time [%]")
    handles, labels = panels[_place(corners[0], 0, corners)].get_legend_handles_labels()
    legend_outside(figure, handles, labels, 3)
    return figure


def unit_of(quantity: str) -> DisplayUnit:
    """Return the unit in which a travel (m) or velocity (m/s) of dampers is shown: mm or mm/s, in or in/s.

    >>> unit_of("velocity").label("velocity"), unit_of("travel").factor
    ('velocity [mm/s]', 1000.0)
    """
    unit = display_unit_for("mm/s" if quantity == "velocity" else "mm")
    return DisplayUnit(unit.name, 1e3 * unit.factor)


def corner_words(corner: str) -> str:
    """Write the name of a corner.

    >>> corner_words("front_left")
    'front left'
    """
    return corner.replace("_", " ")


def _layout(corners: list[str]) -> tuple[int, int]:
    if any(corner in _SHORT for corner in corners):
        return len({corner.partition("_")[0] for corner in corners}), 2
    return 1, len(corners)


def _place(corner: str, k: int, corners: list[str]) -> tuple[int, int]:
    if not any(name in _SHORT for name in corners):
        return 0, k
    axles = [axle for axle in AXLES if any(name.startswith(axle) for name in corners)]
    return axles.index(corner.partition("_")[0]), _SHORT.get(corner, 0)


def _shares(
    result: DamperHistograms, quantity: str, record: str, section: str, corner: str
) -> np.ndarray | None:
    wanted = "whole" if record == result.beside else section
    shares = result.data[f"{quantity}_share"].sel(record=record, section=wanted, corner=corner)
    values = 100.0 * shares.to_numpy()
    return values if np.isfinite(values).all() else None


def _draw(
    axes: Axes,
    result: DamperHistograms,
    quantity: str,
    edges: np.ndarray,
    shares: np.ndarray,
    r: int,
    record: str,
) -> None:
    """Draw bars of the first record, and steps of the others."""
    if record == result.beside:
        label = f"model: {record}"
        axes.stairs(shares, edges, color=_MODEL, linewidth=1.4, label=label)
    elif r:
        axes.stairs(
            shares, edges, color=PALETTE[(r + 1) % len(PALETTE)], linewidth=1.2, label=record
        )
    elif quantity == "travel":
        axes.stairs(shares, edges, fill=True, color=_HIGH, alpha=0.75, label=record)
    else:
        middles = 0.5 * (edges[1:] + edges[:-1])
        low = result.low_speed * unit_of(quantity).factor
        is_low = np.abs(middles) < low * (1.0 + 1e-9)
        width = edges[1] - edges[0]
        words = size(1e3 * result.low_speed, "mm/s")
        for mask, colour, label in (
            (is_low, _LOW, f"{record}: up to {words}"),
            (~is_low, _HIGH, "faster"),
        ):
            axes.bar(middles[mask], shares[mask], width, color=colour, label=label)
    axes.axvline(0.0, color=MUTED, linewidth=0.6)


def _zone_words(axes: Axes, result: DamperHistograms, section: str, corner: str) -> None:
    """Write the shares of the zones of the first record into the upper corners of a panel."""
    zones = (
        result.data["zone_share"]
        .sel(record=result.records[0], section=section, corner=corner)
        .to_numpy()
    )
    if not np.isfinite(zones).all():
        return
    high_rebound, low_rebound, low_bump, high_bump = (f"{100.0 * share:.1f} %" for share in zones)
    style: dict[str, Any] = {
        "transform": axes.transAxes,
        "va": "top",
        "fontsize": 7.5,
        "color": INK,
    }
    axes.text(0.01, 0.98, f"rebound\nlow {low_rebound}\nhigh {high_rebound}", ha="left", **style)
    axes.text(0.99, 0.98, f"bump\nlow {low_bump}\nhigh {high_bump}", ha="right", **style)


@in_style
def zones_over_sections(result: DamperHistograms) -> Figure:
    """Draw the shares of the zones of velocity over laps or sectors, for each corner.

    Parameters
    ----------
    result : DamperHistograms
        Result of :func:`jounce.damper_histograms` with laps or sectors.

    Returns
    -------
    matplotlib.figure.Figure
        One panel for each zone; one line for each corner of the first record.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> t = np.arange(0.0, 40.0, 1e-3)
    >>> run = jn.recording(t, {"front_left.damper.travel": (0.01 * np.sin(12.0 * t), "m", "")})
    >>> made = jn.damper_histograms(run.assign_attrs(beacons=[5.0, 15.0, 25.0, 35.0]))
    >>> len(zones_over_sections(made).axes)
    4
    """
    record = result.records[0]
    sections = result.sections[1:]
    figure = new_figure(3.9)
    panels = figure.subplots(2, 2, sharex=True)
    for axes, zone in zip(panels.ravel(), (ZONES[1], ZONES[2], ZONES[0], ZONES[3]), strict=True):
        for k, corner in enumerate(result.corners):
            shares = result.data["zone_share"].sel(
                record=record, corner=corner, zone=zone, section=sections
            )
            axes.plot(
                range(len(sections)),
                100.0 * shares.to_numpy(),
                "o-",
                markersize=3.0,
                color=PALETTE[k % len(PALETTE)],
                label=corner_words(corner),
            )
        axes.set_title(zone)
        axes.set_ylim(bottom=0.0)
    every = max(1, math.ceil(len(sections) / 8))
    for axes in panels[-1]:
        axes.set_xticks(range(0, len(sections), every), sections[::every])
    for axes in panels[:, 0]:
        axes.set_ylabel("share of time [%]")
    handles, labels = panels[0, 0].get_legend_handles_labels()
    legend_outside(figure, handles, labels, 4)
    return figure
