"""Names beside a drawing: in two columns at its edges, evenly spread, with thin lines that do not cross."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.types import Array
from jounce.plots.style import INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SIZE = 7.0  # points
_LEADER = "#8b939b"


def column_width(names: Mapping[str, object]) -> float:
    """Width in inches that a column of these names needs, with the start of its lines."""
    return 0.22 + max(map(len, names)) * 0.6 * SIZE / 72.0


def write_names(axes: Axes, places: Mapping[str, Array], scale: float, floor: float = 0.0) -> None:
    """Write names at the left and right edges of axes whose scale is equal in both directions.

    Parameters
    ----------
    axes : Axes
        Where; its limits are set.
    places : mapping of str to ndarray, shape (2,)
        Where each name belongs, mm.
    scale : float
        mm per inch of paper.
    floor : float
        Height above the lower edge that stays free, inches.
    """
    (left, right), (low, high) = sorted(axes.get_xlim()), sorted(axes.get_ylim())
    gap, width = 1.35 * SIZE / 72.0 * scale, column_width(places) * scale
    low += max(gap, floor * scale)
    for names, inner, side in zip(_columns(places), (left + width, right - width), ("right", "left"), strict=True):
        if not names:
            continue
        points = np.array([places[name] for name in names])
        heights = _untangled(points, inner, spread(points[:, 1], low, high - gap, gap))
        start = inner + (-0.04 if side == "right" else 0.04) * scale
        for name, point, height in zip(names, points, heights, strict=True):
            axes.plot([inner, point[0]], [height, point[1]], color=_LEADER, linewidth=0.5, zorder=6.0)
            axes.text(
                start,
                height,
                name,
                fontsize=SIZE,
                color=INK,
                ha=side,
                va="center_baseline",
                zorder=7.0,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6},
            )


def _columns(places: Mapping[str, Array]) -> tuple[list[str], list[str]]:
    """Names that stand on the left and on the right, each from bottom to top."""
    ordered = sorted(places, key=lambda name: (round(float(places[name][0]), 3), name))
    half = len(ordered) // 2
    left, right = (
        sorted(part, key=lambda name: (float(places[name][1]), name)) for part in (ordered[:half], ordered[half:])
    )
    return left, right


def spread(wanted: Array, low: float, high: float, gap: float) -> Array:
    """Heights near those wanted, shape (n,), ascending, at least ``gap`` apart and within ``low`` and ``high``.

    Closer together than ``gap`` only where they would not fit. All in the same unit.

    Examples
    --------
    >>> spread(np.array([0.0, 0.0, 5.0]), -10.0, 10.0, 1.0).tolist()
    [-0.5, 0.5, 5.0]
    """
    count = len(wanted)
    gap = min(gap, (high - low) / max(count - 1, 1))
    steps = gap * np.arange(count)
    groups: list[list[float]] = []  # sum and number of what is pushed together
    for value in wanted - steps:
        groups.append([float(value), 1.0])
        while len(groups) > 1 and groups[-2][0] / groups[-2][1] > groups[-1][0] / groups[-1][1]:
            total, number = groups.pop()
            groups[-1][0] += total
            groups[-1][1] += number
    even = np.concatenate([np.full(int(number), total / number) for total, number in groups])
    return np.asarray(np.clip(even, low, high - steps[-1]) + steps)


def _untangled(points: Array, start: float, heights: Array) -> Array:
    """Heights dealt out again until no two straight lines from ``start`` to the points cross."""
    heights = heights.copy()
    for _ in range(len(heights) ** 2):
        crossed = [
            (i, j)
            for i in range(len(heights))
            for j in range(i + 1, len(heights))
            if _cross(start, heights[i], points[i], heights[j], points[j])
        ]
        if not crossed:
            break
        i, j = crossed[0]
        heights[i], heights[j] = heights[j], heights[i]
    return heights


def _cross(start: float, first: float, a: Array, second: float, b: Array) -> bool:
    """Whether two lines that begin at the same abscissa cross."""
    reach = min(abs(a[0] - start), abs(b[0] - start))
    if reach <= 0.0:
        return False
    ends = [h + (p[1] - h) * reach / abs(p[0] - start) for h, p in ((first, a), (second, b))]
    return bool((first - second) * (ends[0] - ends[1]) < -1e-9)
