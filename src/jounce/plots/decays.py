"""Free decays: the record with the fitted response, and how viscous damping and friction show in the peaks."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.types import Array
from jounce.identify.decay import QUANTITIES, alternating, decay_response, turning_points
from jounce.plots.display import display_unit, quantity
from jounce.plots.style import AFTER, MEASURED, MUTED, PALETTE, legend_above, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.identify.decay import DecayResult

_UNITS = dict(zip(QUANTITIES, ("m", "m/s", "m/s^2"), strict=True))


@styled
def decay_fit(result: DecayResult, time: ArrayLike = (), signal: ArrayLike = (), title: str = "") -> Figure:
    """Draw a free decay, the fitted response, and each turning point against the one before.

    With viscous damping alone the turning points lie on a line through the origin; dry friction shifts the line down.
    The damping ratios that single logarithmic decrements would give then grow as the amplitude falls.

    Parameters
    ----------
    result : DecayResult
        What was fitted.
    time : array (n,), optional
        Times of the record [s].
    signal : array (n,), optional
        The record itself in SI; without it only what was fitted is drawn.
    title : str
        Name of the record.

    Returns
    -------
    matplotlib.figure.Figure
        Decay over time; turning points (displacements only); damping ratios of single decrements.
    """
    figure = new_figure(5.2)
    parts = figure.subplot_mosaic([["decay", "decay"], ["peaks", "ratios"]], height_ratios=[1.25, 1.0])
    t, record = np.asarray(time, float), np.asarray(signal, float)
    _draw_decay(parts["decay"], result, t, record)
    parts["decay"].set_title(title)
    _draw_peaks(parts["peaks"], result)
    _draw_ratios(parts["ratios"], result)
    return figure


def _draw_decay(axes: Axes, result: DecayResult, time: Array, record: Array) -> None:
    unit = display_unit(_UNITS[result.quantity])
    begin, end = result.window
    if len(record):
        axes.plot(time, record * unit.factor, color=MEASURED, linewidth=1.6, label="measured")
    dense = np.linspace(begin, end, 1500)
    response = decay_response(dense, result.parameters, result.quantity)
    axes.plot(
        dense, response * unit.factor, color=AFTER, linewidth=1.1, label="fitted: viscous damping and dry friction"
    )
    turns = np.concatenate([[0], np.flatnonzero(np.diff(np.sign(np.diff(response))) != 0) + 1])
    offset = result.parameters.offset
    envelope = np.abs(response[turns] - offset)
    for sign in (1.0, -1.0):
        label = "envelope" if sign > 0 else None
        axes.plot(
            dense[turns],
            (offset + sign * envelope) * unit.factor,
            color=PALETTE[1],
            linewidth=0.9,
            linestyle=(0, (4, 2)),
            label=label,
        )
    axes.axhline(offset * unit.factor, color=MUTED, linewidth=0.8, linestyle=(0, (1, 2)))
    span = end - begin
    axes.set_xlim(begin - 0.15 * span, end + 0.02 * span)
    axes.set(xlabel="time [s]", ylabel=unit.label(result.quantity))
    legend_above(axes, 3)


def _draw_peaks(axes: Axes, result: DecayResult) -> None:
    if result.quantity != "displacement":
        axes.set_axis_off()
        axes.text(0.5, 0.5, "turning points are drawn\nfor displacements only", ha="center", va="center", color=MUTED)
        return
    unit = display_unit("m")
    measured = np.array(result.amplitudes) * unit.factor
    axes.plot(measured[:-1], measured[1:], "o", color=MEASURED, markersize=4.5, label="measured")
    turns = alternating(turning_points(result.parameters, 40)) * unit.factor
    if len(turns) > 2:
        axes.plot(turns[:-1], turns[1:], color=AFTER, label="fitted")
        axes.plot(
            [0.0, turns[0]],
            [0.0, result.parameters.half_cycle_ratio * turns[0]],
            color=MUTED,
            linewidth=1.0,
            linestyle=(0, (1, 2)),
            label="the same without friction",
        )
    axes.set_xlim(left=0.0)
    axes.set_ylim(bottom=0.0)
    axes.set(xlabel="turning point from equilibrium [mm]", ylabel="next turning point [mm]")
    axes.set_title("each turning point against the one before", fontweight="normal", fontsize=9)
    axes.legend(loc="upper left")


def _draw_ratios(axes: Axes, result: DecayResult) -> None:
    count = len(result.naive_damping_ratios)
    cycles = 0.5 * np.arange(count)
    axes.plot(cycles, result.naive_damping_ratios, "s", color=PALETTE[1], markersize=4.5, label="single decrements")
    combined = result.damping_ratio
    if combined.interval is not None:
        axes.axhspan(*combined.interval, color=AFTER, alpha=0.15, linewidth=0.0)
    axes.axhline(combined.value, color=AFTER, label="viscous part, with 95 %")
    top = max([value for value in (*result.naive_damping_ratios, combined.value) if np.isfinite(value)], default=0.0)
    axes.set_ylim(0.0, 1.6 * top if top > 0.0 else 1.0)  # room for the legend; a wide band may leave the axes
    axes.set_xlim(-0.25, max(0.5 * count - 0.25, 1.0))
    axes.set(xlabel="cycle", ylabel="damping ratio [–]")
    friction = quantity(result.coulomb_force.value, "N", 3)
    axes.set_title(f"damping ratio (dry friction: {friction})", fontweight="normal", fontsize=9)
    axes.legend(loc="upper left")
