"""Figures of a posterior: draws and their pairs, profile likelihoods, and bands with the measurements."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import DisplayUnit, display_unit
from jounce.core.errors import FitError, unknown
from jounce.core.old_names import old_argument
from jounce.plots.figures import (
    INK,
    MUTED,
    PALETTE,
    at_tick,
    columns_of,
    in_lines,
    in_style,
    legend_outside,
    new_figure,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.core.types import Array
    from jounce.identify.posterior import Posterior
    from jounce.identify.prediction import PredictionBand

_MOST_POINTS, _BINS = 4000, 60


@in_style
@old_argument("found", "posterior")
def posterior_draws(posterior: Posterior) -> Figure:
    """Draw the distribution of each parameter and of each pair.

    If model error is included, bars and dots are the parts as measured on a test machine, and lines over the bars the
    model's effective law during the ride; the interval includes both.

    Parameters
    ----------
    posterior : Posterior
        Result of :func:`jounce.posterior`; SI, shown in usual units.

    Returns
    -------
    matplotlib.figure.Figure
        Histograms with 95 % intervals on the diagonal, scatter plots below it.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> x = np.linspace(0.0, 1.0, 50)
    >>> y = 2.0 * x + 0.1 * np.random.default_rng(1).normal(size=50)
    >>> best = float(x @ y / (x @ x))
    >>> found = jn.posterior_of(lambda p: (y - p[0] * x, -x[:, None]), {"slope": (best, 0.0, 4.0)}, draws=1000)
    >>> len(posterior_draws(found).axes)
    1
    """
    paths = list(posterior.parameters)
    names = [
        f"component of {path}" if f"component of {path}" in posterior.samples else path
        for path in paths
    ]
    columns, others, units, limits = [], [], [], []
    for path, name in zip(paths, names, strict=True):
        values = posterior.samples[name].to_numpy().ravel()
        unit = display_unit(posterior.parameters[path].unit or "1", float(np.max(np.abs(values))))
        other = posterior.samples.get(f"effective of {path}")
        columns.append(values * unit.factor)
        others.append(None if other is None else other.to_numpy().ravel() * unit.factor)
        units.append(unit)
        both = columns[-1] if others[-1] is None else np.concatenate([columns[-1], others[-1]])
        low, high = np.quantile(both, (0.0005, 0.9995))
        limits.append((low, max(high, low + 1e-12)))
    size = len(paths)
    rows = np.random.default_rng(posterior.seed).choice(
        len(columns[0]), min(_MOST_POINTS, len(columns[0])), replace=False
    )
    side = max(1.7, min(3.2, 8.4 / size))
    figure = new_figure(0.7 + side * size, 0.8 + side * size)
    grid = figure.subplots(size, size, squeeze=False)
    for i in range(size):
        for j in range(size):
            axes = grid[i, j]
            if j > i:
                axes.set_visible(False)
                continue
            if i == j:
                ends = [end * units[i].factor for end in posterior.parameters[paths[i]].interval]
                _histogram(axes, columns[i], ends, others[i], limits[i])
            else:
                axes.plot(
                    columns[j][rows],
                    columns[i][rows],
                    ".",
                    ms=1.2,
                    alpha=0.35,
                    color=PALETTE[0],
                    rasterized=True,
                )
                axes.set_ylim(limits[i])
            axes.set_xlim(limits[j])
            axes.locator_params(nbins=3)
            axes.tick_params(labelsize=7, labelbottom=i == size - 1, labelleft=j == 0)
            if i == size - 1:
                axes.set_xlabel(units[j].label(in_lines(paths[j], 18)), fontsize=7.5)
            if j == 0 and i > 0:
                axes.set_ylabel(units[i].label(in_lines(paths[i], 18)), fontsize=7.5)
    handles, labels = grid[0, 0].get_legend_handles_labels()
    legend_outside(figure, handles, labels, 3)
    return figure


def _histogram(
    axes: Axes,
    values: Array,
    interval: list[float],
    other: Array | None,
    limits: tuple[float, float],
) -> None:
    settings: dict[str, Any] = {"bins": _BINS, "range": limits}
    words = "draws" if other is None else "test machine"
    axes.hist(values, color=PALETTE[0], alpha=0.75, label=words, **settings)
    if other is not None:
        axes.hist(other, histtype="step", color=INK, lw=0.9, label="law over the ride", **settings)
    for end, label in zip(interval, ("95 % interval", None), strict=True):
        axes.axvline(end, color=PALETTE[1], lw=1.0, label=label)
    axes.set_yticks([])


@in_style
@old_argument("found", "posterior")
def profile_likelihood(posterior: Posterior) -> Figure:
    """Draw the profile log likelihood of each parameter, with the others refitted, and a Gaussian for comparison.

    Parameters
    ----------
    posterior : Posterior
        Result of :func:`jounce.posterior`.

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes for each parameter, with the level of the 95 % interval.
    """
    from jounce.identify.posterior import HALF_DROP  # its package loads more than a figure needs

    count = len(posterior.profiles)
    wide = columns_of(count)
    tall = -(-count // wide)
    figure = new_figure(0.4 + 2.1 * tall, 2.9 * wide + 0.5)
    grid = figure.subplots(tall, wide, squeeze=False).ravel()
    for axes, (path, profile) in zip(grid, posterior.profiles.items(), strict=False):
        unit = display_unit(
            posterior.parameters[path].unit or "1", float(np.max(np.abs(profile.values)))
        )
        values = profile.values * unit.factor
        top = int(np.argmax(profile.log_likelihood))
        axes.plot(values, profile.log_likelihood, color=PALETTE[0], label="profile")
        curvature = _curvature(values, profile.log_likelihood, top)
        if curvature > 0.0:
            parabola = -0.5 * curvature * (values - values[top]) ** 2
            axes.plot(values, parabola, "--", color=MUTED, lw=1.0, label="Gaussian")
        axes.axhline(-HALF_DROP, color=PALETTE[1], lw=0.9, label="95 %")
        axes.set_ylim(-8.5, 0.5)
        axes.locator_params(axis="x", nbins=4)
        axes.set_xlabel(unit.label(at_tick(path, 30)))
    for axes in grid[count:]:
        axes.set_visible(False)
    for axes in grid[::wide]:
        axes.set_ylabel("log likelihood")
    grid[0].legend(loc="lower center", fontsize=7)
    return figure


def _curvature(x: Array, y: Array, top: int) -> float:
    near = slice(max(top - 5, 0), min(top + 6, len(x)))
    return float(-2.0 * np.polyfit(x[near] - x[top], y[near], 2)[0]) if len(x[near]) > 3 else 0.0


@in_style
@old_argument("found", "posterior")
def posterior_bands(posterior: Posterior, trial: str | None = None) -> Figure:
    """Draw the prediction of a posterior for a trial, with the measured signals.

    Parameters
    ----------
    posterior : Posterior
        Result of :func:`jounce.posterior`, with predictions.
    trial : str, optional
        Name of the trial; the first by default.

    Returns
    -------
    matplotlib.figure.Figure
        Two sets of axes for each channel, over time (s): the bands, dark for the uncertainty of parameters, light for
        all included uncertainty; below, the same minus the mean, which makes narrow bands visible.
    """
    if not posterior.predictions:
        raise FitError(
            "the posterior has no predictions",
            where=posterior.name,
            hint="Call posterior without predict=().",
        )
    if trial is not None and trial not in posterior.predictions:
        raise unknown(trial, posterior.predictions, what="trial", where="trial")
    name = trial if trial is not None else next(iter(posterior.predictions))
    channels = posterior.predictions[name]
    figure = new_figure(0.9 + 2.9 * len(channels))
    ratios = [2.0, 1.0] * len(channels)
    column = figure.subplots(
        2 * len(channels), 1, squeeze=False, sharex=True, height_ratios=ratios
    )[:, 0]
    for axes, rest, (channel, band) in zip(
        column[::2], column[1::2], channels.items(), strict=True
    ):
        unit = display_unit(band.unit, float(np.max(np.abs(band.measured))))
        _band(axes, band, unit, 0.0 * band.mean)
        axes.set_ylabel(unit.label(at_tick(channel, 24)))
        axes.set_title(
            f"{100.0 * band.inside:.0f} % of the samples inside",
            loc="right",
            fontsize=7.5,
            color=MUTED,
        )
        _band(rest, band, unit, band.mean)
        rest.set_ylabel("less mean" + (f"\n[{unit.name}]" if unit.name else ""))
    first = next(iter(channels.values()))
    column[0].set_title(
        f"{name}, {'fitted' if first.is_fitted else 'held out'}", loc="left", fontsize=9
    )
    handles, labels = column[0].get_legend_handles_labels()
    legend_outside(figure, handles, labels, 4)
    column[-1].set_xlabel("time [s]")
    moving = np.flatnonzero(first.whole > 1.05 * float(np.min(first.whole)))
    if len(moving):
        column[-1].set_xlim(
            first.time[max(moving[0] - 50, 0)],
            first.time[min(moving[-1] + 50, len(first.time) - 1)],
        )
    return figure


def _band(axes: Axes, band: PredictionBand, unit: DisplayUnit, less: Array) -> None:
    """Draw a band, its mean and the recording, after subtracting the curve ``less``."""
    for whole, alpha, words in (
        (True, 0.22, "95 %, all that is counted"),
        (False, 0.5, "95 %, parameters"),
    ):
        low, high = (unit.factor * (end - less) for end in band.ends(whole=whole))
        axes.fill_between(band.time, low, high, color=PALETTE[0], alpha=alpha, lw=0, label=words)
    axes.plot(band.time, unit.factor * (band.mean - less), color=PALETTE[0], lw=0.9, label="mean")
    axes.plot(band.time, unit.factor * (band.measured - less), color=INK, lw=0.6, label="measured")
