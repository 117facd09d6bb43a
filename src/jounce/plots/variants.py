"""Figures of many runs: sensitivities of metrics, correlation of numbers and metrics, bands over time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import DisplayUnit, display_unit
from jounce.core.errors import DescriptionError
from jounce.plots.figures import (
    INK,
    MUTED,
    PALETTE,
    at_tick,
    in_lines,
    in_style,
    legend_outside,
    new_figure,
)
from jounce.plots.parallel import between_ends, draw_uprights
from jounce.variants.sensitivity import metrics_of, numbers_of, sensitivity_indices
from jounce.variants.summary import bands

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.core.types import Array

_MOST_ROWS = 45  # bars of all metrics in one figure
_MOST_BARS, _MOST_AXES, _MOST_POINTS, _MOST_LINES = 15, 7, 4000, 1500
_FEW_VALUES = 16  # distinct values of a number, as on a grid or on Morris' levels
_LOWER, _HIGHER = PALETTE[0], PALETTE[1]
_INDICES = {  # for each design: indices drawn next to the swings, with labels
    "saltelli": (("first", "alone"), ("total", "with others")),
    "morris": (("mean_absolute_effect", "mean size"), ("effect_spread", "spread")),
}
_HEADINGS = {"saltelli": "share of the variance", "morris": "effect of the whole range"}


@in_style
def tornado(many: xr.Dataset, metrics: Sequence[str] | str | None = None) -> Figure:
    """Draw the influence of the numbers on metrics, with the most influential number on top.

    Left, for each metric: its mean over the fifth of the variants with the lowest and with the highest values of each
    number, relative to its mean over all variants (Morris design: half of the mean effect to either side). Right: the
    indices that the design provides, with their 95 % intervals.

    Parameters
    ----------
    many : xarray.Dataset
        Metrics on ``variant``, from :func:`jounce.simulate_many`; SI, shown in usual units.
    metrics : sequence of str, optional
        Metrics to draw; by default as many as fit in 45 bars: three with 15 numbers, seven with six.

    Returns
    -------
    matplotlib.figure.Figure
        One row of axes per metric.

    Examples
    --------
    >>> import jounce as jn
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="1 m"), speed="10 m/s", duration="1 s")
    >>> design = jn.sobol({"strut.damper.coefficient": "20 %", "sprung.mass": "10 %"}, 16)
    >>> many = jn.simulate_many(jn.load("audi-a6-quarter-car"), trial, design, metrics="max sprung.az")
    >>> [axes.get_title("left") for axes in tornado(many).axes]
    ['max sprung.az', 'Regression']
    """
    names = metrics_of(many, metrics)
    indices = sensitivity_indices(many, names)
    count = min(indices.sizes["number"], _MOST_BARS)
    names = names[: _MOST_ROWS // count if metrics is None else None]
    figure = new_figure((1.15 + 0.26 * count) * len(names), 9.2)
    grid = figure.subplots(len(names), 2, squeeze=False, width_ratios=[1.3, 1.0])
    for row, name in zip(grid, names, strict=True):
        at = indices.sel(metric=name)
        order = _order(at)[:count]
        _swings(row[0], at.isel(number=order), name, many[name])
        _indices(row[1], at.isel(number=order), indices.attrs["design"], many[name])
    grid[0, 0].legend(loc="lower right", ncols=2, bbox_to_anchor=(1.0, 1.0), columnspacing=1.2)
    return figure


def _order(at: xr.Dataset) -> Array:
    """Indices of the numbers by their influence on a metric, largest first."""
    weight = next(
        at[key].to_numpy() for key in ("total", "mean_absolute_effect", "regression") if key in at
    )
    return np.asarray(np.argsort(-np.nan_to_num(np.abs(weight)), kind="stable"))


def _swings(axes: Axes, at: xr.Dataset, name: str, metric: xr.DataArray) -> None:
    values = metric.to_numpy()
    centre, unit = float(np.nanmean(values)), _unit(metric)
    is_morris = "mean_effect" in at
    for key, side, colour, words in (
        ("at_low", -1, _LOWER, "number low"),
        ("at_high", 1, _HIGHER, "number high"),
    ):
        moved = (
            side * 0.5 * at["mean_effect"].to_numpy() if is_morris else at[key].to_numpy() - centre
        )
        moved = moved * unit.factor
        rows = np.arange(len(moved)) + 0.17 * side
        axes.barh(rows, moved, left=centre * unit.factor, color=colour, height=0.34, label=words)
    axes.axvline(centre * unit.factor, color=INK, linewidth=0.8)
    _rows(axes, [str(path) for path in at["number"].to_numpy()])
    axes.set_title(name)
    axes.set_xlabel(
        unit.label(
            "half of the range to either side" if is_morris else "mean over a fifth of the variants"
        )
    )


def _indices(axes: Axes, at: xr.Dataset, design: str, metric: xr.DataArray) -> None:
    shown = _INDICES.get(design, (("regression", "coefficient"), ("rank_correlation", "rank")))
    unit = _unit(metric) if design == "morris" else DisplayUnit("", 1.0)
    for k, (key, words) in enumerate(shown):
        value, low, high = (
            at[f"{key}{end}"].to_numpy() * unit.factor for end in ("", "_low", "_high")
        )
        place = np.arange(len(value)) + (k - 0.5) * 0.3
        error = np.clip(
            [value - low, high - value], 0.0, None
        )  # a percentile interval need not hold the estimate
        axes.errorbar(
            value,
            place,
            xerr=error,
            fmt="o",
            ms=4,
            color=PALETTE[2 + k],
            elinewidth=1.1,
            label=words,
        )
    axes.axvline(0.0, color=MUTED, linewidth=0.7)
    if design == "saltelli":
        axes.set_xlim(min(-0.03, axes.get_xlim()[0]), max(1.03, axes.get_xlim()[1]))
    _rows(axes, [""] * at.sizes["number"])
    axes.set_title(
        {"saltelli": "Sobol's indices", "morris": "Morris' effects"}.get(design, "Regression")
    )
    axes.set_xlabel(unit.label(_HEADINGS.get(design, "standardised coefficient")))
    axes.legend(loc="lower right", ncols=2, bbox_to_anchor=(1.0, 1.0), columnspacing=1.2)


def _rows(axes: Axes, names: Sequence[str]) -> None:
    axes.set_yticks(range(len(names)), [at_tick(name) for name in names])
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.grid(axis="y", visible=False)


@in_style
def scatter_matrix(many: xr.Dataset, metrics: Sequence[str] | str | None = None) -> Figure:
    """Draw each metric over each varied number, one dot per variant, with the mean of each tenth of the variants.

    Parameters
    ----------
    many : xarray.Dataset
        As for :func:`tornado`.
    metrics : sequence of str, optional
        Metrics to draw; by default the first seven, over the seven numbers that influence the first metric most.

    Returns
    -------
    matplotlib.figure.Figure
        One row per metric, one column per number.
    """
    names = metrics_of(many, metrics)[:_MOST_AXES]
    paths = _mattering(many, names, _MOST_AXES)
    figure = new_figure(0.5 + 1.75 * len(names), max(1.0 + 1.9 * len(paths), 3.6))
    grid = figure.subplots(len(names), len(paths), squeeze=False, sharex="col", sharey="row")
    chosen = _choose_variants(many, _MOST_POINTS)
    for row, name in zip(grid, names, strict=True):
        unit = _unit(many[name])
        y = many[name].to_numpy() * unit.factor
        for axes, path in zip(row, paths, strict=True):
            across = _unit(many[path])
            x = many[path].to_numpy() * across.factor
            axes.scatter(
                x[chosen],
                y[chosen],
                s=7,
                color=PALETTE[0],
                alpha=0.45,
                linewidths=0,
                rasterized=True,
            )
            axes.plot(
                *_course(x, y),
                color=PALETTE[1],
                linewidth=1.6,
                label="mean of a tenth of the variants",
            )
            axes.margins(0.05)
            axes.ticklabel_format(useOffset=False)
            axes.locator_params(axis="x", nbins=4)
        row[0].set_ylabel(unit.label(in_lines(name, 14)))
    for axes, path in zip(grid[-1], paths, strict=True):
        axes.set_xlabel(_unit(many[path]).label(in_lines(path, 16)))
    handles, labels = grid[0, 0].get_legend_handles_labels()
    legend_outside(figure, handles, labels, 1)
    return figure


def _course(x: Array, y: Array) -> tuple[Array, Array]:
    """Mean x and metric of each tenth of the variants that ran, sorted by x; at each value if x has only a few."""
    good = np.flatnonzero(np.isfinite(y))
    few = np.unique(x[good])
    if len(few) <= _FEW_VALUES:
        parts = [good[x[good] == value] for value in few]
    else:
        parts = np.array_split(
            good[np.argsort(x[good], kind="stable")], min(10, max(len(good) // 3, 1))
        )
    return np.array([x[part].mean() for part in parts]), np.array(
        [y[part].mean() for part in parts]
    )


@in_style
def parallel_coordinates(many: xr.Dataset, metrics: Sequence[str] | str | None = None) -> Figure:
    """Draw every variant as a line through its numbers and metrics, coloured by the first metric.

    Parameters
    ----------
    many : xarray.Dataset
        As for :func:`tornado`.
    metrics : sequence of str, optional
        Metrics to draw; all by default. The first one sets the colours. At most 12 axes are drawn, with the numbers
        that influence the first metric most.

    Returns
    -------
    matplotlib.figure.Figure
        One figure with parallel axes, each from its minimum to its maximum.
    """
    from matplotlib.collections import LineCollection

    names = metrics_of(many, metrics)[:6]
    columns = [*_mattering(many, names, 12 - len(names)), *names]
    figure = new_figure(3.6, max(5.0, 1.2 + 1.15 * len(columns)))
    axes = figure.subplots()
    first = many[names[0]].to_numpy()
    chosen = _choose_variants(many, _MOST_LINES)
    chosen = chosen[np.isfinite(first[chosen])]
    chosen = chosen[np.argsort(-first[chosen], kind="stable")]  # the smallest is drawn on top
    shares, ends, units = [], [], []
    for name in columns:
        unit = _unit(many[name])
        values = many[name].to_numpy() * unit.factor
        share, end = between_ends(values)
        shares.append(share[chosen])
        ends.append(end)
        units.append(unit)
    lines = np.stack(
        [np.broadcast_to(np.arange(len(columns)), (len(chosen), len(columns))), np.array(shares).T],
        axis=2,
    )
    alpha = float(np.clip(60.0 / max(len(chosen), 1), 0.12, 0.8))
    drawn = LineCollection(
        list(lines), cmap="viridis", linewidths=0.9, alpha=alpha, rasterized=True
    )
    drawn.set_array(first[chosen] * units[len(columns) - len(names)].factor)
    axes.add_collection(drawn)
    draw_uprights(axes, ends)
    names_at = [
        in_lines(name, 16) + (f"\n[{unit.name}]" if unit.name else "")
        for name, unit in zip(columns, units, strict=True)
    ]
    axes.set_xticks(range(len(columns)), names_at, fontsize=7.5)
    bar = figure.colorbar(drawn, ax=axes, pad=0.01, aspect=30)
    bar.solids.set_alpha(1.0)  # type: ignore[union-attr]
    bar.set_label(units[len(columns) - len(names)].label(names[0]), fontsize=8.5)
    bar.outline.set_visible(False)
    return figure


@in_style
def variant_bands(many: xr.Dataset, channels: Sequence[str] | str | None = None) -> Figure:
    """Draw the median of channels over the variants, with bands that contain 50 % and 90 % of them at each time.

    Parameters
    ----------
    many : xarray.Dataset
        Channels on ``variant`` and ``time`` (``outputs=`` of :func:`jounce.simulate_many`).
    channels : sequence of str, optional
        Channels to draw; the first four by default.

    Returns
    -------
    matplotlib.figure.Figure
        Stacked axes over time (s).
    """
    known = [
        str(name)
        for name, variable in many.data_vars.items()
        if variable.dims == ("variant", "time")
    ]
    names = [channels] if isinstance(channels, str) else list(channels or known[:4])
    if not names:
        raise DescriptionError(
            "no time-dependent channel was stored", where="channels", hint="Ask for outputs."
        )
    figure = new_figure(0.5 + 1.9 * len(names))
    column = figure.subplots(len(names), 1, squeeze=False, sharex=True)[:, 0]
    time = many["time"].to_numpy()
    for axes, name in zip(column, names, strict=True):
        unit = _unit(many[name])
        percentiles = bands(many, name, (5.0, 25.0, 50.0, 75.0, 95.0)).to_numpy() * unit.factor
        axes.fill_between(
            time,
            percentiles[0],
            percentiles[4],
            color=PALETTE[0],
            alpha=0.18,
            lw=0,
            label="5 to 95 %",
        )
        axes.fill_between(
            time,
            percentiles[1],
            percentiles[3],
            color=PALETTE[0],
            alpha=0.35,
            lw=0,
            label="25 to 75 %",
        )
        axes.plot(time, percentiles[2], color=PALETTE[0], label="median")
        axes.set_ylabel(unit.label(at_tick(name, 30)))
    column[0].legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3)
    column[-1].set_xlabel("time [s]")
    return figure


def _require_varied(many: xr.Dataset) -> list[str]:
    paths = numbers_of(many)
    if not paths:
        raise DescriptionError(
            "no parameter varies",
            where="many",
            hint="Pass the result of simulate_many or load_sweep.",
        )
    return paths


def _mattering(many: xr.Dataset, metrics: Sequence[str], most: int) -> list[str]:
    """Varied paths in order: all, or those that influence the first metric most."""
    paths = _require_varied(many)
    if len(paths) <= most:
        return paths
    try:
        at = sensitivity_indices(many, metrics[:1]).isel(metric=0)
    except DescriptionError:  # too few variants ran to rank them
        return paths[:most]
    leading = set(at["number"].to_numpy()[_order(at)[:most]])
    return [path for path in paths if path in leading]


def _choose_variants(many: xr.Dataset, most: int) -> Array:
    """Indices of the variants to draw: all, or an evenly spaced selection of at most ``most``."""
    count = many.sizes["variant"]
    return np.unique(np.linspace(0, count - 1, min(count, most)).astype(int))


def _unit(values: xr.DataArray) -> DisplayUnit:
    largest = float(np.nanmax(np.abs(values.to_numpy()), initial=0.0))
    return display_unit(str(values.attrs.get("units", "1")), largest)
