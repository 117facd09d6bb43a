"""Ride studies: spectra of the body's acceleration, and comfort against road holding for several controllers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.plots.point_names import name_points
from jounce.plots.style import INK, MUTED, PALETTE, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from jounce.ride.comparison import Merit, Ride, RideStudy

_HIGHEST = 50.0  # Hz
_SIZES = (40.0, 260.0)  # points^2


@styled
def ride_spectra(rides: Sequence[Ride]) -> Figure:
    r"""Draw the spectra of body acceleration and wheel load, one line for each ride.

    Parameters
    ----------
    rides : sequence of Ride
        Runs over the same road.

    Returns
    -------
    matplotlib.figure.Figure
        Power spectral densities over frequency (Hz): acceleration ((m/s^2)^2/Hz) above, wheel load (N^2/Hz) below
        where the rig has a tyre.
    """
    spectra = [ride.spectra() for ride in rides]
    channels = list(spectra[0])
    figure = new_figure(2.9 * len(channels))
    rows = figure.subplots(len(channels), 1, sharex=True, squeeze=False)[:, 0]
    labels = {"az": "acceleration [(m/s²)²/Hz]", "force": "wheel load [N²/Hz]"}
    for name, axes in zip(channels, rows, strict=True):
        for i, (ride, spectrum) in enumerate(zip(rides, spectra, strict=True)):
            found = spectrum[name]
            band = (found.frequency > 0.0) & (found.frequency <= _HIGHEST)
            style = "-" if i < len(PALETTE) else "--"
            axes.loglog(
                found.frequency[band], found.density[band], style, color=PALETTE[i % len(PALETTE)], label=ride.control
            )
        axes.set(title=name, ylabel=labels[name.rpartition(".")[2]])
    rows[-1].set_xlabel("frequency [Hz]")
    rows[-1].set_xlim(0.2, _HIGHEST)
    if len(rides) > 1:
        rows[0].legend(ncols=min(len(rides), 4), fontsize=8)
    return figure


@styled
def trade_off(study: RideStudy) -> Figure:
    """Draw comfort against road holding (travel, where the rig has no tyre), the size of a point showing the travel.

    Parameters
    ----------
    study : RideStudy
        Rides of one rig over one road.

    Returns
    -------
    matplotlib.figure.Figure
        One point for each controller; better is to the lower left. Lines mark the passive rig.
    """
    from jounce.ride.comparison import MERITS

    merits = {merit.name: merit for merit in MERITS}
    across = merits["comfort"]
    up = merits["load_coefficient" if "load_coefficient" in study.rides[0].merits else "travel"]
    figure = new_figure(5.2)
    axes = figure.subplots()
    travel = np.array([ride.merits["travel"] for ride in study.rides])
    low, high = float(travel.min()), float(max(travel.max(), travel.min() * (1.0 + 1e-9)))
    sizes = np.interp(travel, (low, high), _SIZES)
    places = np.array([(ride.merits[across.name], _shown(up, ride.merits[up.name])) for ride in study.rides])
    for i in np.argsort(-sizes, kind="stable"):  # small ones upon large ones
        is_passive = study.rides[i].control == "passive"
        x, y = places[i]
        colour = INK if is_passive else PALETTE[0]
        axes.scatter(x, y, sizes[i], color=colour, alpha=0.85, edgecolors="white", linewidths=0.8, zorder=3)
        if is_passive:
            axes.axvline(x, color=MUTED, linewidth=0.8, linestyle=":")
            axes.axhline(y, color=MUTED, linewidth=0.8, linestyle=":")
    axes.set(xlabel=f"{across.label} [m/s²]", ylabel=f"{up.label} [{'–' if up.unit == '1' else 'mm'}]")
    axes.set_title(f"Better is to the lower left; size shows travel, {1e3 * low:.3g} to {1e3 * high:.3g} mm r.m.s.")
    axes.margins(0.1)
    axes.autoscale_view()
    name_points(axes, [ride.control for ride in study.rides], places, np.sqrt(sizes / np.pi))
    return figure


def _shown(merit: Merit, value: float) -> float:
    return 1e3 * value if merit.unit == "m" else value
