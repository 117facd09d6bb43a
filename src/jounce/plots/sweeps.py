"""Studies over one variable, above all speed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.errors import RecordingError, nearest
from jounce.plots.display import display_unit, number
from jounce.plots.style import PALETTE, legend_above, new_figure, styled

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MOST_BY_DEFAULT = 6


@styled
def sweep(results: xr.Dataset, variables: Sequence[str] | None = None, along: str = "speed") -> Figure:
    r"""Draw the variables of a study against what was varied.

    Parameters
    ----------
    results : xarray.Dataset
        Variables over the coordinate ``along``; a second dimension (e.g. obstacle pitch) becomes one line per value.
        Units in SI are taken from ``units``, names from ``long_name``.
    variables : sequence of str, optional
        What to draw, one set of axes each; by default the first six.
    along : str
        Name of the coordinate that was varied.

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes per variable over the same coordinate.

    Raises
    ------
    RecordingError
        For a missing coordinate or an unknown variable.

    Examples
    --------
    >>> import xarray as xr
    >>> speed = ("speed", [1.0, 2.0], {"units": "m/s"})
    >>> peak = ("speed", [0.004, 0.006], {"units": "m", "long_name": "largest displacement"})
    >>> sweep(xr.Dataset({"peak": peak}, coords={"speed": speed})).axes[0].get_ylabel()
    'largest displacement\n[mm]'
    """
    if along not in results.coords:
        raise RecordingError(f"no coordinate {along!r}", found=", ".join(map(str, results.coords)) or "none")
    present = [str(name) for name in results.data_vars if along in results[name].dims and results[name].ndim <= 2]
    for name in variables or ():
        if name not in present:
            raise RecordingError(f"no variable {name!r}", allowed=", ".join(present), hint=nearest(name, present))
    names = list(variables or present[:_MOST_BY_DEFAULT])
    if not names:
        raise RecordingError(f"no variable over {along!r} to draw", found=", ".join(map(str, results.data_vars)))
    figure = new_figure(0.7 + 1.6 * len(names) if len(names) > 1 else 3.0)
    rows = figure.subplots(len(names), 1, sharex=True, squeeze=False)[:, 0]
    for name, axes in zip(names, rows, strict=True):
        _draw_variable(axes, results[name], along)
    if rows[0].get_legend_handles_labels()[0]:
        legend_above(rows[0], 5)
    rows[-1].set_xlabel(_label(results[along], along))
    figure.align_ylabels(rows)
    return figure


def _draw_variable(axes: Axes, variable: xr.DataArray, along: str) -> None:
    across = [dimension for dimension in variable.dims if dimension != along]
    unit = display_unit(_unit(variable), float(np.nanmax(np.abs(variable.to_numpy()), initial=0.0)))
    x = variable[along].to_numpy() * display_unit(_unit(variable[along])).factor
    mark = "." if len(x) < 60 else None
    if not across:
        axes.plot(x, variable.to_numpy() * unit.factor, color=PALETTE[0], marker=mark)
    else:
        lines = variable.transpose(along, across[0])
        for k, value in enumerate(lines[across[0]].to_numpy()):
            axes.plot(
                x,
                lines[:, k].to_numpy() * unit.factor,
                color=PALETTE[k % len(PALETTE)],
                marker=mark,
                label=_value(lines[across[0]], value),
            )
    axes.set_ylabel(unit.label(f"{variable.attrs.get('long_name', variable.name)}\n").replace("\n ", "\n"))


def _unit(variable: xr.DataArray) -> str:
    return str(variable.attrs.get("units", "1"))


def _label(variable: xr.DataArray, name: str) -> str:
    return display_unit(_unit(variable)).label(str(variable.attrs.get("long_name", name)).replace("_", " "))


def _value(coordinate: xr.DataArray, value: Any) -> str:
    if isinstance(value, str):
        return value
    unit = display_unit(_unit(coordinate))
    words = str(coordinate.attrs.get("long_name", coordinate.name)).replace("_", " ")
    return f"{words} {number(float(value) * unit.factor, 3)} {unit.name}".strip()
