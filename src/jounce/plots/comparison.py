"""Several recordings or sweeps in one figure, with their differences from the first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.errors import RecordingError, nearest
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.plots.display import words_of
from jounce.plots.figures import PALETTE, in_style, legend_outside, new_figure
from jounce.plots.signals import MOST_COLUMNS, PREFERRED, preferred_channels
from jounce.plots.thinning import thin

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


_PREFERRED = (*PREFERRED, ("camber",), ("toe",), ("motion_ratio",))
_LEAST_BY_DEFAULT = 4


@in_style
def compare(
    runs: Mapping[str, xr.Dataset] | Sequence[xr.Dataset],
    channels: Sequence[str] | None = None,
    *,
    differences: bool = True,
) -> Figure:
    r"""Draw the same channels of several runs, recordings or sweeps in common axes, with their differences below.

    Parameters
    ----------
    runs : mapping of str to xarray.Dataset, or sequence of xarray.Dataset
        Runs by their names in the legend; a sequence is numbered. All must have the same axis: ``time`` (s), or the
        swept quantity.
    channels : sequence of str, optional
        Channels to draw, from top to bottom; by default usual ones, at all axles, that all runs have.
    differences : bool
        Whether to draw, below each channel, the differences of the other runs from the first one, where both are known;
        samples are interpolated linearly.

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes per channel, and one per difference, in display units. Long records are thinned such that each
        column of pixels keeps its peaks.

    Raises
    ------
    RecordingError
        For an empty collection, different axes, or a channel that is missing in one of the runs.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("kart-quarter-car")
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.5 s")
    >>> soft = jn.simulate(rig.with_changes({"strut.spring.rate": "15 N/mm"}), trial)
    >>> figure = compare({"as it is": jn.simulate(rig, trial), "soft": soft}, ["tyre.force"])
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['force\n[N]', 'difference\n[N]']
    """
    named = named_runs(runs)
    axis, names = common_axis(named), common_channels(named, channels)
    shown_differences = differences and len(named) > 1
    rows = len(names) * (2 if shown_differences else 1)
    figure = new_figure(0.9 + sum((1.6, 0.8 * shown_differences)) * len(names))
    ratios = [1.0, 0.5] * len(names) if shown_differences else [1.0] * len(names)
    panels = figure.subplots(
        rows, 1, sharex=True, squeeze=False, gridspec_kw={"height_ratios": ratios}
    )[:, 0]
    first = next(iter(named.values()))
    along = display_unit(str(first[axis].attrs.get("units", "s" if axis == "time" else "1")))
    along_factor = 1.0 if axis == "time" else along.factor
    ends = [end for data in named.values() for end in (data[axis].min(), data[axis].max())]
    low, high = float(min(ends)), float(max(ends))
    step = 2 if shown_differences else 1
    for i, name in enumerate(names):
        si = str(first[name].attrs.get("units", "1"))
        largest = max(
            float(np.nanmax(np.abs(data[name].to_numpy()), initial=0.0)) for data in named.values()
        )
        unit = display_unit(si, largest)
        reference = line_of(first, name, axis)
        for k, (label, data) in enumerate(named.items()):
            line = line_of(data, name, axis)
            colour = PALETTE[k % len(PALETTE)]
            style = {
                "color": colour,
                "linewidth": 1.1,
                "linestyle": "-" if k < len(PALETTE) else "--",
            }
            x, y = thin(*line, low, high, MOST_COLUMNS)
            panels[step * i].plot(x * along_factor, y * unit.factor, label=label, **style)
            if shown_differences and k:
                x, y = thin(
                    line[0], apart(line[1], through(reference, line[0])), low, high, MOST_COLUMNS
                )
                panels[step * i + 1].plot(x * along_factor, y * unit.factor, **style)
        panels[step * i].set_title(name)
        panels[step * i].set_ylabel(unit.label(f"{words_of(name)}\n").replace("\n ", "\n"))
        if shown_differences:
            panels[step * i + 1].set_ylabel(unit.label("difference\n").replace("\n ", "\n"))
    panels[-1].set_xlabel("time [s]" if axis == "time" else along.label(axis.replace("_", " ")))
    handles, labels = panels[0].get_legend_handles_labels()
    legend_outside(figure, handles, labels, 4)
    figure.align_ylabels(panels)
    return figure


def named_runs(runs: Mapping[str, xr.Dataset] | Sequence[xr.Dataset]) -> dict[str, xr.Dataset]:
    """Return runs by name; refuse an empty collection."""
    named = (
        dict(runs)
        if isinstance(runs, Mapping)
        else {f"run {k}": run for k, run in enumerate(runs, 1)}
    )
    if not named:
        raise RecordingError(
            "there is nothing to compare",
            where="compare",
            allowed="at least one recording or sweep",
        )
    return named


def common_axis(runs: Mapping[str, xr.Dataset]) -> str:
    """Return the name of the axis common to all runs: time, or a swept quantity."""
    axis_of = {}
    for label, data in runs.items():
        axes = [str(name) for name in data.dims if name in data.coords]
        axis = "time" if "time" in axes else axes[0] if len(axes) == 1 else ""
        if not axis:
            dimensions = " x ".join(map(str, data.dims)) or "none"
            raise RecordingError(
                "each run must be a curve over one axis", where=label, found=dimensions
            )
        axis_of[label] = axis
    if len(set(axis_of.values())) > 1:
        listed = ", ".join(f"{label}: {axis}" for label, axis in axis_of.items())
        raise RecordingError("the runs have different axes", where="compare", found=listed)
    return next(iter(axis_of.values()))


_NAMED = 3  # channels of each run in a message


def common_channels(runs: Mapping[str, xr.Dataset], channels: Sequence[str] | None) -> list[str]:
    """Return the channels to draw, which all runs must have."""
    axis = common_axis(runs)
    held = [
        [str(name) for name in data.data_vars if data.variables[name].dims == (axis,)]
        for data in runs.values()
    ]
    present = [name for name in held[0] if all(name in others for others in held)]
    if channels:
        for name in channels:
            for label, own in zip(runs, held, strict=True):
                if name not in own:
                    raise RecordingError(
                        Phrase("no channel {name!r}", name=name),
                        where=label,
                        allowed=", ".join(own),
                        hint=nearest(name, own),
                    )
        return list(channels)
    if not present:
        raise RecordingError(
            "no channel is common to all runs",
            where=", ".join(runs),
            found="; ".join(
                f"{label}: {', '.join(own[:_NAMED])}{' …' if len(own) > _NAMED else ''}"
                for label, own in zip(runs, held, strict=True)
            ),
            hint="Compare models of one kind, such as two quarter cars.",
        )
    varying = [name for name in present if any(_varies(data[name]) for data in runs.values())]
    return (
        preferred_channels(present, _PREFERRED, _LEAST_BY_DEFAULT)
        or (varying or present)[:_LEAST_BY_DEFAULT]
    )


def _varies(channel: xr.DataArray) -> bool:
    values = channel.to_numpy()
    return values.dtype.kind in "fiu" and values.size > 0 and bool(np.ptp(values) > 0.0)


def line_of(data: xr.Dataset, name: str, axis: str) -> tuple[Array, Array]:
    """Return a channel as (x, y) in SI, with x ascending."""
    x, y = (data.variables[variable].to_numpy().astype(float) for variable in (axis, name))
    if len(x) > 1 and bool(np.any(np.diff(x) < 0.0)):
        order = np.argsort(x, kind="stable")
        x, y = x[order], y[order]
    return x, y


def apart(values: Array, reference: Array) -> Array:
    """Subtract a reference, shapes (n,); NaN where either is unknown or infinite."""
    known = np.isfinite(values) & np.isfinite(reference)
    difference = np.full(len(values), np.nan)
    difference[known] = values[known] - reference[known]
    return difference


def through(line: tuple[Array, Array], x: Array) -> Array:
    """Interpolate a line linearly at ``x``; NaN beyond its ends."""
    return (
        np.interp(x, *line, left=np.nan, right=np.nan) if len(line[0]) else np.full(len(x), np.nan)
    )
