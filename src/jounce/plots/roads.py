"""Roads: height against distance."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.plots.style import PALETTE, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from jounce.core.segments import Segments
    from jounce.roads import Road

_POINTS = 6000


@styled
def road_profile(roads: Road | Mapping[str, Road], distance: float | None = None) -> Figure:
    """Draw the height of one or several roads against distance.

    Parameters
    ----------
    roads : Road or mapping of str to Road
        One road, or several by name; several are drawn one above the other over the same distance.
    distance : float, optional
        How far, in m; by default a little beyond the end of the longest.

    Returns
    -------
    matplotlib.figure.Figure
        Height (mm) against distance (m).

    Examples
    --------
    >>> import jounce as jn
    >>> road_profile(jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")).axes[0].get_xlabel()
    'distance [m]'
    """
    named = dict(roads) if isinstance(roads, Mapping) else {"": roads}
    figure = new_figure(2.4 if len(named) == 1 else 0.5 + 0.95 * len(named))
    rows = figure.subplots(len(named), 1, sharex=True, sharey=True, squeeze=False)[:, 0]
    ends = {name: road.end() for name, road in named.items()}
    reach = distance if distance is not None else 1.08 * max(*ends.values(), 1e-3)
    for (name, road), axes in zip(named.items(), rows, strict=True):
        x, height = sampled(road.segments(reach))
        if height.min() >= 0.0:
            axes.fill_between(x, 1e3 * height, 0.0, color="#cfd6dc", linewidth=0.0)
        axes.plot(x, 1e3 * height, color=PALETTE[0], linewidth=1.1)
        axes.set_title(name)
        axes.set_ylabel("height [mm]" if len(named) == 1 else "height\n[mm]")
        axes.margins(y=0.15)
    begin = min(road.start for road in named.values()) if distance is None else 0.0
    rows[0].set_xlim(max(0.0, begin - 0.08 * (reach - begin)), reach)
    rows[-1].set_xlabel("distance [m]")
    figure.align_ylabels(rows)
    return figure


def sampled(segments: Segments) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Coordinate (m or s) and height (m) along closed-form pieces, shape (n,); jumps are drawn upright."""
    count = max(2, min(60, _POINTS // len(segments.kind)))
    share = np.linspace(0.0, 1.0, count)
    share[-1] = 1.0 - 1e-9  # still on this piece: at an edge the next one counts
    x = (segments.edges[:-1, None] + np.diff(segments.edges)[:, None] * share).ravel()
    return x, segments.evaluate(x)[0]
