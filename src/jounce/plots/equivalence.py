"""Three tests of the same car: from which wear on each of them rejects, over what else it feels."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.plots.style import MUTED, PALETTE, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.inspection.equivalence import Equivalence, Factor

_NAMES = {"eusama": "EUSAMA adhesion", "egea": "EGEA phase angle", "theta": "THETA"}
_NEVER = "dots at the top: never rejects"
_SOUND, _WORN = "#dceedd", "#f6ddd4"


@styled
def equivalence(study: Equivalence) -> Figure:
    """Draw for each factor the damper wear from which each method rejects.

    Parameters
    ----------
    study : Equivalence
        Of :func:`jounce.inspection.equivalence.compare_tests`.

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes a factor: wear (%) over the factor; above its line a method rejects, where it has dots at the
        top it never does. Sound dampers are shaded green, worn ones red.
    """
    from matplotlib.lines import Line2D

    figure = new_figure(4.0)
    row = figure.subplots(1, len(study.factors), sharey=True, squeeze=False)[0]
    for factor, axes in zip(study.factors, row, strict=True):
        _panel(study, factor, axes)
    row[0].set_ylabel("damping lost [%]")
    handles = [line for line in row[0].lines if line.get_label() in _NAMES.values()]
    if any(line.get_linestyle() == "None" for axes in row for line in axes.lines):
        handles += [Line2D([], [], color=MUTED, marker=".", linestyle="None", markersize=2.5, label=_NEVER)]
    figure.legend(handles=handles, loc="outside upper left", ncols=len(handles), fontsize=8.5, frameon=False)
    return figure


def _panel(study: Equivalence, factor: Factor, axes: Axes) -> None:
    from jounce.inspection.equivalence import SOUND, WORN

    values = factor.scale * study.planes[factor.name][factor.name].to_numpy()
    axes.axhspan(0.0, 100.0 * SOUND, color=_SOUND, zorder=0)
    axes.axhspan(100.0 * WORN, 100.0, color=_WORN, zorder=0)
    for i, (method, name) in enumerate(_NAMES.items()):
        edge = study.rejecting_wear(factor.name, method)
        axes.plot(values, 100.0 * edge, color=PALETTE[i], label=name)
        never = values[np.isnan(edge)]
        if len(never):
            axes.plot(never, np.full(len(never), 98.5 - 2.2 * i), ".", color=PALETTE[i], markersize=2.5)
    middle = 0.5 * (values[0] + values[-1])
    for height, text in ((50.0 * SOUND, "sound"), (50.0 * (1.0 + WORN), "worn")):
        axes.text(middle, height, text, ha="center", va="center", fontsize=8, color=MUTED)
    axes.set(xlabel=factor.label, xlim=(values[0], values[-1]), ylim=(0.0, 100.0))
