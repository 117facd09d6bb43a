"""Figures of analyses of records: statistics, spectra, transfer functions, modes, integrated accelerations."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.old_names import old_argument
from jounce.core.types import Array
from jounce.plots.display import number, ratio_unit
from jounce.plots.figures import (
    AFTER,
    BEFORE,
    GRID,
    INK,
    MEASURED,
    MUTED,
    PALETTE,
    in_legend,
    in_lines,
    in_style,
    legend_above,
    limits,
    log_axes,
    new_figure,
)
from jounce.plots.signals import MOST_COLUMNS
from jounce.plots.thinning import thin

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.analysis.integrate import Integration
    from jounce.analysis.modes import FittedModes
    from jounce.analysis.spectrum import ChannelSpectrum, RecordSpectra
    from jounce.analysis.statistics import RecordStatistics
    from jounce.analysis.transfer import TransferEstimate

_LONGEST_NAME = 22  # characters of a channel name next to its axes
_DECADES = 1e-7  # of the largest density: smaller values are not shown
_CLASSES = 60


@in_style
@old_argument("found", "statistics")
def channel_statistics(statistics: RecordStatistics) -> Figure:
    r"""Draw each channel over time with a histogram of its values; dashed: the distribution of Gaussian noise.

    Parameters
    ----------
    statistics : RecordStatistics
        Result of :func:`jounce.describe_channels`.

    Returns
    -------
    matplotlib.figure.Figure
        One row for each channel, in the current system of units.

    Examples
    --------
    >>> import jounce as jn
    >>> run = jn.recording([0.001 * i for i in range(64)], {"tyre.force": ([float(i % 7) for i in range(64)], "N", "")})
    >>> channel_statistics(jn.describe_channels(run)).axes[0].get_ylabel()
    'tyre.force\n[N]'
    """
    rows = statistics.channels
    figure = new_figure(0.7 + 1.05 * len(rows))
    grid = figure.subplots(
        len(rows), 2, squeeze=False, sharex="col", gridspec_kw={"width_ratios": [4.0, 1.0]}
    )
    time = statistics.source.run["time"].to_numpy()
    for (axes, beside), row in zip(grid, rows, strict=True):
        values = statistics.source.values(row.channel)
        unit = display_unit(row.unit, max(abs(row.minimum), abs(row.maximum)))
        few, shown = thin(time, values, float(time[0]), float(time[-1]), MOST_COLUMNS)
        axes.plot(few, shown * unit.factor, color=PALETTE[0], linewidth=0.7)
        axes.set_ylabel(
            unit.label(f"{in_lines(row.channel, _LONGEST_NAME)}\n").replace("\n ", "\n")
        )
        beside.sharey(axes)
        if row.standard_deviation > 0.0 and row.peak_to_peak > 0.0:
            _occurrences(
                beside,
                values * unit.factor,
                row.mean.value * unit.factor,
                row.standard_deviation * unit.factor,
            )
        beside.tick_params(labelleft=False, labelbottom=False)
        beside.grid(axis="x", visible=False)
    limits(grid[0, 0], float(time[0]), float(time[-1]))
    grid[-1, 0].set_xlabel("time [s]")
    grid[-1, 1].set_xlabel("occurrence")
    figure.align_ylabels(grid[:, 0])
    return figure


def _occurrences(axes: Axes, values: Array, mean: float, deviation: float) -> None:
    density, edges = np.histogram(values, bins=_CLASSES, density=True)
    scaled = density * deviation
    axes.fill_betweenx(
        np.repeat(edges, 2)[1:-1], np.repeat(scaled, 2), color="#a9cce6", linewidth=0.0
    )
    level = np.linspace(edges[0], edges[-1], 200)
    gauss = np.exp(-0.5 * ((level - mean) / deviation) ** 2) / np.sqrt(2.0 * np.pi)
    axes.plot(gauss, level, color=INK, linewidth=1.0, linestyle=(0, (4, 2)))
    axes.set_xlim(0.0, 1.15 * max(float(scaled.max()), 0.4))


@in_style
@old_argument("found", "spectra")
def channel_spectra(spectra: RecordSpectra) -> Figure:
    """Draw the power spectral density of each channel, with its interval and significant peaks.

    Parameters
    ----------
    spectra : RecordSpectra
        Result of :func:`jounce.estimate_spectra`.

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes for each channel, over frequency (Hz); circles: peaks; shaded: confidence interval.

    Examples
    --------
    >>> import jounce as jn, numpy as np
    >>> noise = np.random.default_rng(0).normal(size=2000)
    >>> run = jn.recording(np.arange(2000) / 100.0, {"sprung.az": (noise, "m/s^2", "")})
    >>> channel_spectra(jn.estimate_spectra(run)).axes[0].get_xlabel()
    'frequency [Hz]'
    """
    rows = spectra.channels
    columns = 1 if len(rows) < 3 else 2
    lines = max(-(-len(rows) // columns), 1)
    figure = new_figure(0.7 + 2.2 * lines, 9.6 if columns > 1 else 7.6)
    grid = figure.subplots(lines, columns, sharex=True, squeeze=False)
    for axes, row in zip(grid.flat, rows, strict=False):
        _spectrum(axes, row, spectra.interval)
    for axes in grid.flat[len(rows) :]:
        axes.remove()
    for axes in list(grid.flat)[max(len(rows) - columns, 0) : len(rows)]:
        axes.set_xlabel("frequency [Hz]")
        axes.tick_params(labelbottom=True)
    words = (
        f"segments of {number(spectra.segment, 3)} s, resolution {number(spectra.resolution, 2)} Hz"
    )
    freedom = f"{number(spectra.degrees_of_freedom, 3)} degrees of freedom, shaded: {100.0 * spectra.confidence:g} %"
    figure.suptitle(f"{words}, {freedom}", x=0.01, ha="left", fontsize=9, color=MUTED)
    return figure


def _spectrum(axes: Axes, row: ChannelSpectrum, interval: tuple[float, float]) -> None:
    unit = display_unit(row.unit)
    shown = row.frequency > 0.0
    f, density = row.frequency[shown], row.density[shown] * unit.factor**2
    greatest = float(density.max(initial=0.0)) or 1.0
    density = np.maximum(density, 1e-3 * _DECADES * greatest)
    axes.fill_between(
        f, density * interval[0], density * interval[1], color="#a9cce6", linewidth=0.0, alpha=0.6
    )
    axes.plot(f, density, color=PALETTE[0], linewidth=1.0)
    for peak in row.peaks:
        height = float(np.interp(peak.frequency, f, density))
        axes.plot(
            [peak.frequency], [height], "o", color=BEFORE, markersize=4.0, markerfacecolor="none"
        )
        axes.annotate(
            number(peak.frequency, 3),
            (peak.frequency, height),
            xytext=(0, 5),
            textcoords="offset points",
            ha="center",
            fontsize=7.5,
            color=INK,
        )
    log_axes(axes)
    squared = f"({unit.name})²" if "/" in unit.name or "·" in unit.name else f"{unit.name or '1'}²"
    axes.set(
        title=row.channel, ylabel=f"density [{squared}/Hz]" if unit.name != "" else "density [1/Hz]"
    )
    lowest = max(0.3 * float(density.min()), _DECADES * greatest)
    axes.set_ylim(lowest, 6.0 * greatest * interval[1] / max(interval[1], 1.0))
    limits(axes, float(f[0]), float(f[-1]))


@in_style
@old_argument("found", "transfer")
def transfer_estimate(transfer: TransferEstimate) -> Figure:
    """Draw gain with its interval, phase and coherence of two measured channels, compared with a linear model.

    Parameters
    ----------
    transfer : TransferEstimate
        Result of :func:`jounce.estimate_transfer`.

    Returns
    -------
    matplotlib.figure.Figure
        Gain, phase (°) and coherence (1) over frequency (Hz); dotted: largest coherence expected by chance.

    Examples
    --------
    >>> import jounce as jn, numpy as np
    >>> noise = np.random.default_rng(0).normal(size=4000)
    >>> signals = {"road.z": (noise, "m", ""), "body.z": (noise, "m", "")}
    >>> run = jn.recording(np.arange(4000) / 100.0, signals)
    >>> found = jn.estimate_transfer(run, "body.z", "road.z")
    >>> [axes.get_ylabel() for axes in transfer_estimate(found).axes]
    ['gain [–]', 'phase [°]', 'coherence [–]']
    """
    from matplotlib.ticker import MultipleLocator

    output, given = display_unit(transfer.output_unit), display_unit(transfer.given_unit)
    factor = output.factor / given.factor
    figure = new_figure(5.6)
    gain, phase, coherence = figure.subplots(
        3, 1, sharex=True, gridspec_kw={"height_ratios": [2.2, 1.2, 1.0]}
    )
    f = transfer.frequency
    low, high = (end * factor for end in transfer.gain_interval)
    value = transfer.gain * factor
    shown = np.isfinite(high) & (value > 0.0) & (transfer.coherence > transfer.significant)
    seen = value[shown] if shown.any() else value[value > 0.0]
    bottom, top = (0.3 * float(seen.min()), 3.0 * float(seen.max())) if seen.size else (0.1, 10.0)
    bottom = max(bottom, 1e-5 * top)
    interval = f"{100.0 * transfer.confidence:g} % interval"
    upper, lower = (
        np.where(shown, np.minimum(high, 10.0 * top), np.nan),
        np.where(shown, np.maximum(low, 0.1 * bottom), np.nan),
    )
    gain.fill_between(f, lower, upper, color="#a9cce6", linewidth=0.0, alpha=0.7, label=interval)
    gain.plot(
        f,
        np.where(value > 0.0, value, np.nan),
        color=PALETTE[0],
        linewidth=1.1,
        label=f"measured, {transfer.estimator}",
    )
    degrees = np.degrees(transfer.phase)
    half = np.degrees(np.minimum(transfer.factor * transfer.phase_error, np.pi))
    phase.vlines(
        f[shown], (degrees - half)[shown], (degrees + half)[shown], color="#a9cce6", linewidth=1.5
    )
    phase.plot(f, np.where(shown, degrees, np.nan), ".", color=PALETTE[0], markersize=2.5)
    if transfer.model is not None:
        line = {"color": BEFORE, "linewidth": 1.3, "linestyle": (0, (5, 2))}
        gain.plot(f, np.abs(transfer.model) * factor, label="model", **line)
        phase.plot(f, np.degrees(_unbroken(np.angle(transfer.model))), **line)
    coherence.plot(f, transfer.coherence, color=PALETTE[0], linewidth=1.1)
    coherence.axhline(transfer.significant, color=MUTED, linewidth=1.0, linestyle=":")
    for axes in (phase, coherence):
        log_axes(axes, "x")
    log_axes(gain)
    per = ratio_unit(output.name, given.name)
    gain.set(
        ylabel=f"gain [{per}]", ylim=(bottom, top), title=f"{transfer.output} over {transfer.given}"
    )
    phase.set(ylabel="phase [°]", ylim=(-190.0, 190.0))
    phase.yaxis.set_major_locator(MultipleLocator(90.0))
    coherence.set(ylabel="coherence [–]", ylim=(0.0, 1.05), xlabel="frequency [Hz]")
    limits(coherence, float(f[0]), float(f[-1]))
    legend_above(gain, 3)
    figure.align_ylabels([gain, phase, coherence])
    return figure


def _unbroken(angle: Array) -> Array:
    """Angles with gaps where the line would jump from one end of the axis to the other."""
    broken = angle.copy()
    broken[1:][np.abs(np.diff(angle)) > np.pi] = np.nan
    return broken


@in_style
@old_argument("found", "modes")
def measured_modes(modes: FittedModes) -> Figure:
    """Draw the measured lines with the fitted modes, and below them the poles of denominators of rising order.

    Parameters
    ----------
    modes : FittedModes
        Result of :func:`jounce.fit_modes`.

    Returns
    -------
    matplotlib.figure.Figure
        Magnitudes over frequency (Hz), each output relative to its maximum. Below: filled points are stable poles,
        solid lines the modes with their intervals, dashed lines the modes of the model.
    """
    figure = new_figure(5.4)
    above, below = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [1.7, 1.0]})
    sizes = np.abs(modes.measured).max(axis=0)
    for k, name in enumerate(modes.outputs):
        colour = PALETTE[k % len(PALETTE)]
        above.plot(
            modes.frequency,
            np.abs(modes.measured[:, k]) / sizes[k],
            color=colour,
            linewidth=0.9,
            alpha=0.55,
        )
        fitted = np.abs(modes.fitted[:, k]) / sizes[k]
        above.plot(modes.frequency, fitted, color=colour, linewidth=1.8, label=in_legend(name))
    table = modes.stabilisation
    stable = table.is_stable
    below.plot(
        table.frequency[~stable],
        table.order[~stable],
        "o",
        color=MUTED,
        markersize=3.0,
        markerfacecolor="none",
    )
    below.plot(table.frequency[stable], table.order[stable], "o", color=AFTER, markersize=3.5)
    for mode in modes.modes:
        for axes in (above, below):
            if mode.frequency.interval is not None:
                axes.axvspan(*mode.frequency.interval, color=GRID, linewidth=0.0, zorder=0)
            axes.axvline(mode.frequency.value, color=MEASURED, linewidth=0.9, zorder=1)
            if mode.model_frequency is not None:
                axes.axvline(
                    mode.model_frequency,
                    color=BEFORE,
                    linewidth=1.2,
                    linestyle=(0, (5, 2)),
                    zorder=1,
                )
        words = f"{number(mode.frequency.value, 3)} Hz\nζ {number(mode.damping_ratio.value, 2)}"
        at = (mode.frequency.value, 1.0)
        above.annotate(
            words, at, xycoords=above.get_xaxis_transform(), xytext=(3, -3), textcoords="offset points",
            va="top", fontsize=8, color=INK,
        )  # fmt: skip
    log_axes(above)
    log_axes(below, "x")
    what = {"transfer": f"over {modes.given}", "spectrum": "density", "decay": "free decay"}[
        modes.kind
    ]
    least = max(0.3 * float(np.min(np.abs(modes.measured) / sizes)), 1e-4)
    above.set(ylabel=f"{what}, of its largest [–]", ylim=(least, 8.0))
    below.set(ylabel="order", xlabel="frequency [Hz]")
    limits(below, float(modes.frequency[0]), float(modes.frequency[-1]))
    legend_above(above, 4)
    figure.align_ylabels([above, below])
    return figure


@in_style
def integrated_motion(integration: Integration) -> Figure:
    """Draw each acceleration with its velocity and displacement; shaded: times affected by the ends of the record.

    Parameters
    ----------
    integration : Integration
        Result of :func:`jounce.integrate_acceleration`.

    Returns
    -------
    matplotlib.figure.Figure
        One column for each of the first three channels, in the current system of units, over time (s).
    """
    shown = integration.channels[:_MOST_INTEGRATED]
    figure = new_figure(5.0, max(7.6, 4.2 * len(shown)))
    grid = figure.subplots(3, len(shown), sharex=True, squeeze=False)
    first, last = float(integration.time[0]), float(integration.time[-1])
    for column, row in zip(grid.T, shown, strict=True):
        signals = (
            (
                row.channel,
                integration.source.values(row.channel)[: len(integration.time)],
                row.unit,
                0.0,
            ),
            (row.velocity_channel, row.velocity, row.velocity_unit, row.velocity_error),
            (
                row.displacement_channel,
                row.displacement,
                row.displacement_unit,
                row.displacement_error,
            ),
        )
        for axes, (name, values, si, error) in zip(column, signals, strict=True):
            unit = display_unit(si, float(np.abs(values).max()))
            few, drawn = thin(integration.time, values, first, last, MOST_COLUMNS)
            axes.plot(few, drawn * unit.factor, color=PALETTE[0], linewidth=0.8)
            axes.set_ylabel(unit.label(f"{in_lines(name, _LONGEST_NAME)}\n").replace("\n ", "\n"))
            inner = (
                drawn[(few >= integration.valid[0]) & (few <= integration.valid[1])] * unit.factor
            )
            if inner.size:
                room = 0.15 * max(float(np.ptp(inner)), 1e-12)
                axes.set_ylim(float(inner.min()) - room, float(inner.max()) + room)
            for low, high in ((first, integration.valid[0]), (integration.valid[1], last)):
                if high > low:
                    axes.axvspan(low, high, color=GRID, linewidth=0.0, zorder=0)
            if error:
                words = f"noise error: {unit.behind(number(error * unit.factor, 2))} (standard deviation)"
                axes.set_title(words, fontsize=8, color=MUTED, fontweight="normal")
        column[-1].set_xlabel("time [s]")
        limits(column[-1], first, last)
        figure.align_ylabels(column)
    return figure


_MOST_INTEGRATED = 3
