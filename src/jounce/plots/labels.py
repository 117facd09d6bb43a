"""Label points with names: in two columns at the edges of a drawing, or next to points that may be close together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.plots.figures import INK, MUTED, lay_out

if TYPE_CHECKING:
    from matplotlib.axes import Axes


COLUMN_SIZE = 7.0  # points
_LEADER = "#8b939b"


def column_width(names: Mapping[str, object]) -> float:
    """Width in inches of a column of these names, including the start of the leader lines."""
    return 0.22 + max(map(len, names)) * 0.6 * COLUMN_SIZE / 72.0


def column_height(names: Mapping[str, object]) -> float:
    """Height in inches of these names in two columns."""
    return (len(names) // 2 + 1) * 1.35 * COLUMN_SIZE / 72.0


def write_names(axes: Axes, places: Mapping[str, Array], scale: float, floor: float = 0.0) -> None:
    """Write names at the left and right edges of axes, each with a leader line to its point, shape (2,), mm.

    The limits of the axes must be set; ``scale`` is in mm per inch of paper, ``floor`` (inches) is kept free at the
    bottom.
    """
    (left, right), (low, high) = sorted(axes.get_xlim()), sorted(axes.get_ylim())
    gap, width = 1.35 * COLUMN_SIZE / 72.0 * scale, column_width(places) * scale
    low += max(gap, floor * scale)
    for names, inner, side in zip(
        _columns(places), (left + width, right - width), ("right", "left"), strict=True
    ):
        if not names:
            continue
        points = np.array([places[name] for name in names])
        heights = _untangle(points, inner, spread(points[:, 1], low, high - gap, gap))
        start = inner + (-0.04 if side == "right" else 0.04) * scale
        for name, point, height in zip(names, points, heights, strict=True):
            axes.plot(
                [inner, point[0]], [height, point[1]], color=_LEADER, linewidth=0.5, zorder=6.0
            )
            axes.text(
                start,
                height,
                name,
                fontsize=COLUMN_SIZE,
                color=INK,
                ha=side,
                va="center_baseline",
                zorder=7.0,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6},
            )


def _columns(places: Mapping[str, Array]) -> tuple[list[str], list[str]]:
    """Names of the left and the right column, each from bottom to top."""
    ordered = sorted(places, key=lambda name: (round(float(places[name][0]), 3), name))
    half = len(ordered) // 2
    left, right = (
        sorted(part, key=lambda name: (float(places[name][1]), name))
        for part in (ordered[:half], ordered[half:])
    )
    return left, right


def spread(wanted: Array, low: float, high: float, gap: float) -> Array:
    """Return heights near the ``wanted`` ones, shape (n,), ascending, at least ``gap`` apart, from ``low`` to ``high``.

    They are closer than ``gap`` only if they would not fit otherwise. All are in the same unit.

    Examples
    --------
    >>> spread(np.array([0.0, 0.0, 5.0]), -10.0, 10.0, 1.0).tolist()
    [-0.5, 0.5, 5.0]
    """
    count = len(wanted)
    gap = min(gap, (high - low) / max(count - 1, 1))
    steps = gap * np.arange(count)
    groups: list[list[float]] = []  # sum and number of values pushed together
    for value in wanted - steps:
        groups.append([float(value), 1.0])
        while len(groups) > 1 and groups[-2][0] / groups[-2][1] > groups[-1][0] / groups[-1][1]:
            total, number = groups.pop()
            groups[-1][0] += total
            groups[-1][1] += number
    even = np.concatenate([np.full(int(number), total / number) for total, number in groups])
    return np.asarray(np.clip(even, low, high - steps[-1]) + steps)


def _untangle(points: Array, start: float, heights: Array) -> Array:
    """Permute the heights until no two straight lines from ``start`` to the points cross."""
    heights = heights.copy()
    for _ in range(len(heights) ** 2):
        crossed = [
            (i, j)
            for i in range(len(heights))
            for j in range(i + 1, len(heights))
            if _leaders_cross(start, heights[i], points[i], heights[j], points[j])
        ]
        if not crossed:
            break
        i, j = crossed[0]
        heights[i], heights[j] = heights[j], heights[i]
    return heights


def _leaders_cross(start: float, first: float, a: Array, second: float, b: Array) -> bool:
    """Whether two leader lines that begin at the same abscissa cross."""
    reach = min(abs(a[0] - start), abs(b[0] - start))
    if reach <= 0.0:
        return False
    ends = [h + (p[1] - h) * reach / abs(p[0] - start) for h, p in ((first, a), (second, b))]
    return bool((first - second) * (ends[0] - ends[1]) < -1e-9)


_SIZE = 7.5  # points of paper
_GAP = 2.5  # points of paper, around discs and names
_REACH = np.array(
    [0.0, 5.0, 11.0, 17.0, 24.0, 33.0, 43.0, 55.0, 70.0, 90.0, 115.0, 145.0]
)  # points of paper, further away
_DIRECTIONS = np.radians(np.arange(0.0, 360.0, 11.25))
_ROUNDS = 20
_SAMPLES = np.linspace(0.0, 1.0, 9)[:, None]
_OUTSIDE, _COVERED, _HIDDEN, _CROSSED, _THROUGH = 200.0, 2000.0, 800.0, 300.0, 40.0
"""Costs, in points of distance: point outside; name covered; disc hidden; lines over names; lines over discs."""


def name_points(axes: Axes, names: Sequence[str], places: Array, radii: Array) -> None:
    """Write a name next to each point, as near as there is room; distant names get a thin leader line.

    The axes must be complete; ``places``, shape (n, 2), are in data units, ``radii``, shape (n,), in points of paper.
    """
    from matplotlib.figure import Figure
    from matplotlib.patheffects import withStroke

    figure = axes.get_figure()
    assert isinstance(figure, Figure)
    trial = [
        axes.annotate(name, place, fontsize=_SIZE)
        for name, place in zip(names, places, strict=True)
    ]
    lay_out(figure)
    boxes = [text.get_window_extent() for text in trial]
    for text in trial:
        text.remove()
    scale = 72.0 / figure.dpi
    points = scale * axes.transData.transform(places)
    frame = scale * np.asarray(axes.bbox.extents)
    sizes = scale * np.array([[box.width, box.height] for box in boxes]).reshape(-1, 2)
    layout = LabelLayout(points, np.asarray(radii, dtype=float), sizes, frame[:2], frame[2:])
    for i, centre in enumerate(layout.place_all()):
        is_away = (
            float(np.hypot(*(layout.edge(i, centre[None])[0] - points[i]))) > radii[i] + 2.0 * _GAP
        )
        line = {
            "arrowstyle": "-",
            "color": MUTED,
            "linewidth": 0.5,
            "shrinkA": 0.5,
            "shrinkB": float(radii[i]),
        }
        axes.annotate(
            names[i], tuple(places[i]), tuple(centre - points[i]), textcoords="offset points", fontsize=_SIZE,
            color=INK, ha="center", va="center", zorder=6, arrowprops=line if is_away else None,
            path_effects=[withStroke(linewidth=2.0, foreground="white")],
        )  # fmt: skip


@dataclass(frozen=True)
class LabelLayout:
    """Layout of the names of discs within a frame; all lengths in points of paper."""

    points: Array  # centres of the discs, shape (n, 2)
    radii: Array  # radii of the discs, shape (n,)
    sizes: Array  # width and height of the names, shape (n, 2)
    low: Array  # lower left corner of the area for names, shape (2,)
    high: Array  # upper right corner of that area

    def place_all(self) -> Array:
        """Return the centres of the names, shape (n, 2): each in turn moves to its cheapest position, until none moves.

        Examples
        --------
        >>> frame = np.full(2, -50.0), np.full(2, 50.0)
        >>> layout = LabelLayout(np.zeros((1, 2)), np.ones(1), np.array([[20.0, 8.0]]), *frame)
        >>> layout.place_all().tolist()   # to the right of its point
        [[13.5, 0.0]]
        """
        options = [self._options(i) for i in range(len(self.points))]
        distances = np.sort(
            np.linalg.norm(self.points[:, None] - self.points[None], axis=2), axis=1
        )
        crowded_first = np.argsort(distances[:, :5].sum(axis=1), kind="stable")
        chosen: dict[int, Array] = {}
        for _ in range(_ROUNDS):
            before = dict(chosen)
            for i in map(int, crowded_first):
                others = {j: centre for j, centre in chosen.items() if j != i}
                centres, liking = options[i]
                chosen[i] = centres[int(np.argmin(liking + self._costs(i, centres, others)))]
            if before and all(np.array_equal(chosen[i], before[i]) for i in before):
                break
        return np.array([chosen[i] for i in range(len(self.points))]).reshape(-1, 2)

    def edge(self, i: int, centres: Array) -> Array:
        """Return the positions on name ``i`` nearest to its point, shape (m, 2), for each of the ``centres``."""
        return np.asarray(
            np.clip(self.points[i], centres - 0.5 * self.sizes[i], centres + 0.5 * self.sizes[i])
        )

    def _options(self, i: int) -> tuple[Array, Array]:
        """Return candidate positions of a name, shape (m, 2), with a penalty for each, shape (m,)."""
        reach, angle = (grid.ravel() for grid in np.meshgrid(_REACH, _DIRECTIONS, indexing="ij"))
        towards = np.column_stack([np.cos(angle), np.sin(angle)])
        tips = self.points[i] + towards * (self.radii[i] + _GAP + reach)[:, None]
        centres = tips + np.clip(1.6 * towards, -1.0, 1.0) * 0.5 * self.sizes[i]
        sideways = np.abs(np.sin(angle))
        return centres, reach + 4.0 * sideways + np.where(np.cos(angle) < -1e-9, 2.0, 0.0)

    def _costs(self, i: int, centres: Array, others: dict[int, Array]) -> Array:
        """Return the cost of each position of a name, shape (m,), with the other names fixed."""
        half = 0.5 * self.sizes[i] + 0.5 * _GAP
        beyond = np.maximum(self.low - (centres - half), 0.0) + np.maximum(
            centres + half - self.high, 0.0
        )
        cost = _OUTSIDE * beyond.sum(axis=1)
        away = np.maximum(np.abs(self.points[None] - centres[:, None]) - half, 0.0)
        cost += _HIDDEN * (np.hypot(away[..., 0], away[..., 1]) < self.radii).sum(axis=1)
        line = self._lines(i, centres)
        gaps = np.linalg.norm(line[:, :, None] - self.points, axis=3).min(axis=1) < self.radii
        cost += _THROUGH * np.delete(gaps, i, axis=1).sum(axis=1)
        for j, centre in others.items():
            size = 0.5 * self.sizes[j] + 0.5 * _GAP
            cost += _COVERED * (np.abs(centres - centre) < half + size).all(axis=1)
            cost += _CROSSED * (np.abs(line - centre) < size).all(axis=2).any(axis=1)
            theirs = self._lines(j, centre[None])[0]
            cost += _CROSSED * (np.abs(theirs[None] - centres[:, None]) < half).all(axis=2).any(
                axis=1
            )
            cost += _CROSSED * _cross(line, theirs)
        return np.asarray(cost)

    def _lines(self, i: int, centres: Array) -> Array:
        """Return points of the leader line to each position of a name, shape (m, samples, 2)."""
        start = self.points[i]
        return np.asarray(start + _SAMPLES * (self.edge(i, centres) - start)[:, None])


def _cross(lines: Array, other: Array) -> NDArray[np.bool_]:
    """Mask of the straight lines, shape (m, samples, 2), that cross the line ``other``, shape (samples, 2)."""

    def side(a: Array, b: Array, c: Array) -> Array:
        along, to = b - a, c - a
        return np.asarray(along[..., 0] * to[..., 1] - along[..., 1] * to[..., 0])

    a, b, c, d = lines[:, 0], lines[:, -1], other[0], other[-1]
    return np.asarray((side(a, b, c) * side(a, b, d) < 0.0) & (side(c, d, a) * side(c, d, b) < 0.0))
