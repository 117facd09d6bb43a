"""Damper laws: measured loops with what fitted laws give."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import FitError
from jounce.plots.display import display_unit
from jounce.plots.style import MEASURED, PALETTE, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@styled
def damper_loops(
    displacement: ArrayLike, velocity: ArrayLike, force: ArrayLike, fits: Mapping[str, ArrayLike], title: str = ""
) -> Figure:
    """Draw force against velocity and against displacement, measured and fitted.

    Parameters
    ----------
    displacement : array (n,)
        Piston displacement [m]; empty: only the velocity panel is drawn.
    velocity : array (n,)
        Piston velocity [m/s].
    force : array (n,)
        Measured force [N].
    fits : mapping of str to array (n,)
        Name of each law and its force at the same instants [N].
    title : str
        Name of the record.

    Returns
    -------
    matplotlib.figure.Figure
        Force-velocity and force-displacement loops.

    Raises
    ------
    FitError
        For arrays of different lengths.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.linspace(0.0, 1.0, 200)
    >>> x, v = 0.01 * np.sin(2 * np.pi * t), 0.02 * np.pi * np.cos(2 * np.pi * t)
    >>> [axes.get_xlabel() for axes in damper_loops(x, v, 900.0 * v, {"linear": 900.0 * v}).axes]
    ['velocity [m/s]', 'displacement [mm]']
    """
    x, v, measured = (np.asarray(values, float) for values in (displacement, velocity, force))
    shapes = {v.shape, measured.shape, *(np.shape(values) for values in fits.values()), *([x.shape] if x.size else [])}
    if len(shapes) != 1:
        raise FitError("the columns of the damper record have different lengths", found=", ".join(map(str, shapes)))
    panels = [("velocity", v, display_unit("m/s"))]
    if x.size:
        panels.append(("displacement", x, display_unit("m")))
    unit = display_unit("N", float(np.abs(measured).max(initial=0.0)))
    figure = new_figure(3.4)
    row = figure.subplots(1, len(panels), sharey=True, squeeze=False)[0]
    for (words, values, shown), axes in zip(panels, row, strict=True):
        axes.plot(
            values * shown.factor, measured * unit.factor, color=MEASURED, linewidth=0.9, alpha=0.8, label="measured"
        )
        for k, (name, fitted) in enumerate(fits.items()):
            axes.plot(
                values * shown.factor,
                np.asarray(fitted) * unit.factor,
                color=PALETTE[k % len(PALETTE)],
                linewidth=1.2,
                label=name,
            )
        axes.set_xlabel(shown.label(words))
        axes.locator_params(axis="x", nbins=6)
    row[0].set_ylabel(unit.label("force"))
    row[0].set_title(title)
    handles, labels = row[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=min(5, len(labels)))
    return figure
