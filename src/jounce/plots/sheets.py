"""The sheet a mechanism is drawn on: four views in line, two of them sharing each scale, and a legend."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.types import Array
from jounce.plots.drawing import MM, ROAD, RUBBER, Look, ground_corners
from jounce.plots.labels import column_width
from jounce.plots.scenes import Pose, Scene
from jounce.plots.shapes import View, axis_view, oblique_view, tyre
from jounce.plots.style import INK, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

_SIZE = (11.0, 8.8)  # inches; all below too
_LEFT, _RIGHT, _BETWEEN = 0.62, 0.15, 0.72
_BOTTOM, _TOP, _ABOVE = 0.98, 0.72, 0.72
ARROWS = 0.85
"""Height in inches kept free in the last view for the directions of the axes."""
DASHED: Any = (0, (3, 1.2))
AZIMUTH, ELEVATION = np.radians(38.0), np.radians(20.0)


def views_of(scene: Scene) -> tuple[View, View, View, View]:
    """Front, side (from outside), top (front down, below the front view) and space (from ahead, inboard and above)."""
    ahead = -scene.side
    outside = "left" if scene.side > 0.0 else "right"
    return (
        axis_view("front view", (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
        axis_view(f"side view, from the {outside}", (ahead, 0.0, 0.0), (0.0, 0.0, 1.0)),
        axis_view("top view", (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0)),
        oblique_view("from ahead, inboard and above", -scene.side * AZIMUTH, ELEVATION),
    )


@dataclass(frozen=True)
class Sheet:
    """Scale and middle of each view; the three views along the axes share one scale and stand in line.

    Attributes
    ----------
    views : tuple of View
        Front, side, top, and in space.
    middles : tuple of ndarray, shape (2,)
        What stands in the middle of each, mm.
    scale, oblique_scale : float
        mm per inch of the first three and of the last.
    """

    views: tuple[View, View, View, View]
    middles: tuple[Array, ...]
    scale: float
    oblique_scale: float

    @classmethod
    def for_poses(cls, scene: Scene, poses: Sequence[Pose], *, names: bool) -> Sheet:
        """Find scales with which all poses fit, beside the names of the hardpoints."""
        views = views_of(scene)
        cloud = np.vstack([everything(scene, pose) for pose in poses])
        width, height = _panel()
        margin = 2.0 * column_width({**scene.design.points, "contact point": None}) if names else 0.1
        room = np.array([width - margin - 0.3, height - 0.3])
        spans, middles = [], []
        for view in views:
            flat = MM * view.flat(cloud)
            low, high = flat.min(axis=0), flat.max(axis=0)
            spans.append((high - low) / room)
            middles.append(0.5 * (low + high))
        return cls(views, tuple(middles), float(np.max(spans[:3])), float(np.max(spans[3])))

    def scale_of(self, view: View) -> float:
        """Millimetres per inch."""
        return self.oblique_scale if view is self.views[3] else self.scale

    def panels(self, figure: Figure) -> list[Axes]:
        """Add the axes, two by two."""
        width, height = _panel()
        size = np.array(_SIZE)
        labels = (("y [mm]", "z [mm]"), ("x [mm]", "z [mm]"), ("y [mm]", "x [mm]"), ("", ""))
        found = []
        for k, view in enumerate(self.views):
            corner = (_LEFT + (k % 2) * (width + _BETWEEN), _BOTTOM + (1 - k // 2) * (height + _ABOVE))
            box = (*(np.array(corner) / size), *(np.array([width, height]) / size))
            axes = figure.add_axes(box, label=("front", "side", "top", "space")[k])
            half = 0.5 * np.array([width, height]) * self.scale_of(view)
            low, high = self.middles[k] - half, self.middles[k] + half
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel=labels[k][0], ylabel=labels[k][1])
            axes.set_title(view.name)
            _ticks(axes, view)
            found.append(axes)
        return found


def _panel() -> tuple[float, float]:
    return (
        (_SIZE[0] - _LEFT - _RIGHT - _BETWEEN) / 2.0,
        (_SIZE[1] - _BOTTOM - _TOP - _ABOVE) / 2.0,
    )


def _ticks(axes: Axes, view: View) -> None:
    """Show places along ground axes, also where these point to the left or down; none in space."""
    from matplotlib.ticker import FuncFormatter

    if view.name.startswith("from"):
        axes.set(xticks=[], yticks=[])
        axes.grid(visible=False)
        axes.spines[:].set_visible(False)
        return
    for axis, direction in ((axes.xaxis, view.right), (axes.yaxis, view.up)):
        if direction.sum() < 0.0:
            axis.set_major_formatter(FuncFormatter(lambda value, _: f"{0.0 - value:g}".replace("-", "−")))
    axes.tick_params(length=2.5)


def new_sheet(title: str, scene: Scene) -> Figure:
    """Give an empty sheet with its title."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=_SIZE)
    words = scene.title[0].upper() + scene.title[1:]
    figure.suptitle(
        f"{title}: {scene.title}" if title else words,
        x=_LEFT / _SIZE[0],
        y=1.0 - 0.14 / _SIZE[1],
        ha="left",
        va="top",
        fontsize=11.5,
        fontweight="bold",
    )
    return figure


def everything(scene: Scene, pose: Pose) -> Array:
    """All points that must be on the paper, shape (n, 3), m."""
    surface = tyre(pose.points["wheel_centre"], pose.spin_axis, scene.radius, scene.width).reshape(-1, 3)
    return np.vstack([*pose.points.values(), surface, ground_corners(scene, pose)])


def draw_directions(axes: Axes, view: View) -> None:
    """Draw the ground axes as three short arrows in the corner."""
    (left, right), (low, _) = axes.get_xlim(), axes.get_ylim()
    length = 0.07 * (right - left)
    x, y = left + 1.3 * length, low + 0.7 * length
    style = {"arrowstyle": "-|>", "color": MUTED, "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0}
    for name, axis in zip("xyz", np.eye(3), strict=True):
        dx, dy = (float(part) for part in length * view.flat(axis))
        axes.annotate("", (x + dx, y + dy), (x, y), arrowprops=style)
        axes.text(x + 1.25 * dx, y + 1.25 * dy, name, fontsize=8, color=MUTED, ha="center", va="center")


def handles_of(scene: Scene) -> list[Line2D]:
    """Legend of a rig: its parts, and what the marks mean."""
    found = [_line(part.words, part.colour, linewidth=2.2) for part in scene.parts]
    found += [_line("spring and damper", scene.strut_colour, linewidth=2.2), _line("wheel", RUBBER, linewidth=1.1)]
    return found + _marks(scene)


def pose_handles(scene: Scene, shown: Sequence[Pose], looks: Sequence[Look]) -> list[Line2D]:
    """Legend of several poses."""
    found = [_line(scene.design.label, INK, linewidth=2.2)]
    found += [_line(pose.label, str(look.colour), linewidth=1.8) for pose, look in zip(shown, looks, strict=True)]
    found.append(_line("path of the wheel centre", INK, linewidth=0.9))
    found.append(_line("path of the contact point", INK, linewidth=0.9, linestyle=DASHED))
    return found + _marks(scene)


def _marks(scene: Scene) -> list[Line2D]:
    plain = {"linestyle": "none", "markerfacecolor": "white", "markeredgecolor": INK, "markersize": 4.5}
    axis = [_line("steering axis", MUTED, linewidth=1.0, linestyle=(0, (5, 2, 1, 2)))] if scene.steering_axis else []
    return [
        *axis,
        _line("on the body", INK, marker="s", **plain),
        _line("moves", INK, marker="o", **plain),
        _line("contact point", ROAD, marker="^", linestyle="none", markersize=6.0),
    ]


def _line(label: str, colour: str, **options: Any) -> Line2D:
    from matplotlib.lines import Line2D

    return Line2D([], [], color=colour, label=label, **options)
