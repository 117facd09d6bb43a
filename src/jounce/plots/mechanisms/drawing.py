"""Drawings of mechanisms: views, shapes, a pose in any view, and a sheet of three orthogonal and one oblique view."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import display_unit
from jounce.core.types import Array
from jounce.plots.figures import INK, MUTED, figure_type, in_style
from jounce.plots.labels import column_height, column_width, write_names
from jounce.plots.mechanisms.scene import MIDDLE, Pose, Poses, Scene, poses_of, scene_of

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

    from jounce.parts.corners import Corner


_AROUND = 72
_TYRE = ((-0.5, 0.9), (-0.42, 0.975), (-0.25, 1.0), (0.25, 1.0), (0.42, 0.975), (0.5, 0.9))
COILS = 8.0


@dataclass(frozen=True)
class View:
    """A parallel projection: unit vectors, shape (3,), that point right and up on paper."""

    name: str
    right: Array
    up: Array

    @property
    def back(self) -> Array:
        """Unit vector towards the viewer, shape (3,)."""
        return np.cross(self.right, self.up)

    def flat(self, points: Array) -> Array:
        """Project points in space, shape (..., 3), to paper, shape (..., 2), in the same unit."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)


def axis_view(name: str, right: tuple[float, float, float], up: tuple[float, float, float]) -> View:
    """Return a view along a ground axis."""
    return View(name, np.array(right), np.array(up))


def oblique_view(name: str, azimuth: float, elevation: float) -> View:
    """Return a view from ``azimuth`` (rad, from straight ahead of the car towards its left) and ``elevation`` (rad)."""
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    back = np.array(
        [
            np.cos(elevation) * np.cos(azimuth),
            np.cos(elevation) * np.sin(azimuth),
            np.sin(elevation),
        ]
    )
    return View(name, right, np.cross(back, right))


def _across(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors normal to an axis and to each other; the second is as close to vertical as possible."""
    level = np.cross(axis, [0.0, 0.0, 1.0])
    size = np.linalg.norm(level)
    level = level / size if size > 1e-9 else np.array([1.0, 0.0, 0.0])
    return level, np.cross(level, axis)


def circle(centre: Array, axis: Array, radius: float) -> Array:
    """Return points on a closed circle in space, shape (n, 3)."""
    first, second = _across(axis)
    angle = np.linspace(0.0, 2.0 * np.pi, _AROUND + 1)[:, None]
    return np.asarray(centre + radius * (np.cos(angle) * first + np.sin(angle) * second))


def tyre(
    centre: Array, axis: Array, radius: float, width: float, ground: float | None = None
) -> Array:
    """Return rings of a tyre's surface, shape (rings, n, 3); points below ``ground`` (m) are moved up to it."""
    rings = np.stack(
        [circle(centre + share * width * axis, axis, size * radius) for share, size in _TYRE]
    )
    if ground is not None:
        rings[..., 2] = np.maximum(rings[..., 2], ground)
    return rings


def outline(points: Array) -> Array:
    """Return the convex hull of points on paper, shape (n, 2) to (m, 2), counter-clockwise.

    Examples
    --------
    >>> outline(np.array([[0.0, 0.0], [1.0, 0.0], [0.5, 0.2], [1.0, 1.0], [0.0, 1.0]])).tolist()
    [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
    """
    ordered = [tuple(point) for point in np.unique(points.reshape(-1, 2), axis=0)]
    if len(ordered) < 3:
        return np.array(ordered)
    halves = []
    for run in (ordered, ordered[::-1]):
        half: list[tuple[float, float]] = []
        for x, y in run:
            while len(half) > 1 and _turn(half[-2], half[-1], (x, y)) <= 0.0:
                half.pop()
            half.append((x, y))
        halves.append(half[:-1])
    return np.array(halves[0] + halves[1])


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def coil(bottom: Array, top: Array, radius: float) -> Array:
    """Return a helix between two points, shape (n, 3), with straight ends."""
    axis = (top - bottom) / np.linalg.norm(top - bottom)
    first, second = _across(axis)
    share = np.linspace(0.0, 1.0, int(24 * COILS) + 1)
    reach = np.clip(np.minimum(share, 1.0 - share) * 3.0 * COILS, 0.0, 1.0)[:, None]
    angle = 2.0 * np.pi * COILS * share[:, None]
    turned = np.cos(angle) * first + np.sin(angle) * second
    turns = bottom + (0.08 + 0.84 * share[:, None]) * (top - bottom) + radius * reach * turned
    return np.vstack([bottom, turns, top])


MM = 1e3
RUBBER, ROAD = "#5b636b", "#7d7468"
_RIM, _SHOULDER = 0.56, 0.9
DAMPER_BODY = 0.5  # of its design length


@dataclass(frozen=True)
class Look:
    """Style of a pose in a drawing."""

    colour: str | None = None  # one colour for all parts instead of their own
    ghost: bool = False  # with thin lines behind a different pose, without surfaces and points, the strut as a line

    @property
    def strength(self) -> float:
        """Factor of opacity and line widths [1]."""
        return 0.65 if self.ghost else 1.0


def draw_pose(
    axes: Axes,
    view: View,
    scene: Scene,
    pose: Pose,
    look: Look | None = None,
    *,
    pressed: bool = False,
) -> None:
    """Draw all moving parts, in mm; ``pressed`` draws the undeformed tyre flattened by the road."""
    look = look or Look()
    _draw_wheel(axes, view, scene, pose, look, pressed=pressed)
    for order, part in enumerate(scene.parts):
        if not all(name in pose.points for name in part.points):
            continue
        colour = look.colour or part.colour
        flat = MM * view.flat(np.array([pose.points[name] for name in part.points]))
        if part.coil and not look.ghost:
            turns = coil(
                pose.points[part.points[0]], pose.points[part.points[1]], scene.coil_radius
            )
            _line(axes, MM * view.flat(turns), colour, 1.2, 3.4, look)
            continue
        if part.plate:
            corners = outline(flat) if part.name == "upright" else flat
            if not look.ghost:
                axes.fill(
                    corners[:, 0],
                    corners[:, 1],
                    color=colour,
                    alpha=0.13,
                    linewidth=0.0,
                    zorder=2.0,
                )
            flat = np.vstack([corners, corners[:1]])
        _line(axes, flat, colour, 2.2 * look.strength, 3.0 + 0.01 * order, look)
    for bracket in scene.brackets:
        first, second = pose.points[bracket.first], pose.points[bracket.second]
        ends = np.array([pose.points[bracket.point], first + bracket.share * (second - first)])
        _line(
            axes,
            MM * view.flat(ends),
            look.colour or bracket.colour,
            1.0 * look.strength,
            2.9,
            look,
        )
    _draw_strut(axes, view, scene, pose, look)
    if not look.ghost:
        _draw_points(axes, view, scene, pose)


def _line(
    axes: Axes, flat: Array, colour: str, width: float, zorder: float, look: Look, **options: Any
) -> None:
    axes.plot(
        flat[:, 0],
        flat[:, 1],
        color=colour,
        linewidth=width,
        alpha=look.strength,
        zorder=zorder - (1.5 if look.ghost else 0.0),
        solid_joinstyle="round",
        **options,
    )


def _draw_wheel(
    axes: Axes, view: View, scene: Scene, pose: Pose, look: Look, *, pressed: bool
) -> None:
    centre = pose.points["wheel_centre"]
    radius = scene.undeformed_radius if pressed else scene.radius
    ground = pose.ground if pressed and pose.touches else None
    surface = MM * view.flat(tyre(centre, pose.spin_axis, radius, scene.width, ground))
    edge = outline(surface)
    colour = look.colour or RUBBER
    if not look.ghost:
        axes.fill(edge[:, 0], edge[:, 1], color=RUBBER, alpha=0.12, linewidth=0.0, zorder=1.0)
    edge = np.vstack([edge, edge[:1]])
    _line(axes, edge, colour, 1.1 * look.strength, 1.8, look)
    if not look.ghost:
        facing = pose.spin_axis if view.back @ pose.spin_axis > 0.0 else -pose.spin_axis
        for share in (_SHOULDER, _RIM):
            ring = circle(centre + 0.5 * scene.width * facing, facing, share * radius)
            _line(axes, MM * view.flat(ring), colour, 0.7, 1.7, look)


def _draw_strut(axes: Axes, view: View, scene: Scene, pose: Pose, look: Look) -> None:
    if scene.spring is None or scene.damper is None:
        return
    colour = look.colour or scene.strut_colour
    bottom, top = (pose.points[name] for name in scene.damper)
    along = (top - bottom) / np.linalg.norm(top - bottom)
    tube = np.array([bottom, bottom + DAMPER_BODY * scene.damper_length * along])
    _line(axes, MM * view.flat(np.array([bottom, top])), colour, 1.3 * look.strength, 3.3, look)
    if look.ghost:
        return
    _line(axes, MM * view.flat(tube), colour, 3.6 * look.strength, 3.3, look, solid_capstyle="butt")
    turns = coil(pose.points[scene.spring[0]], pose.points[scene.spring[1]], scene.coil_radius)
    _line(axes, MM * view.flat(turns), colour, 1.2 * look.strength, 3.4, look)


def _draw_points(axes: Axes, view: View, scene: Scene, pose: Pose) -> None:
    for on_body, marker in ((True, "s"), (False, "o")):
        names = [
            name
            for name in pose.points
            if (name in scene.on_body) is on_body and name != "wheel_centre"
        ]
        flat = MM * view.flat(np.array([pose.points[name] for name in names]))
        axes.plot(
            *flat.T,
            marker,
            color="white",
            markeredgecolor=INK,
            markeredgewidth=0.9,
            markersize=4.2,
            zorder=5.0,
        )
    centre, contact = (
        MM * view.flat(place) for place in (pose.points["wheel_centre"], pose.contact)
    )
    axes.plot(*centre, "+", color=INK, markersize=8.0, markeredgewidth=1.2, zorder=5.0)
    axes.plot(
        *contact,
        "^" if pose.touches else "v",
        color=ROAD if pose.touches else "white",
        markeredgecolor=ROAD,
        markersize=6.0,
        zorder=5.0,
    )


def draw_steering_axis(axes: Axes, view: View, scene: Scene, pose: Pose) -> None:
    """Draw the steering axis, from the ground to slightly above its upper point."""
    if scene.steering_axis is None:
        return
    lower, upper = (pose.points[name] for name in scene.steering_axis)
    along = upper - lower
    if abs(along[2]) < 1e-6 * float(np.linalg.norm(along)):
        return
    start = lower + along * (pose.ground - lower[2]) / along[2]
    ends = MM * view.flat(np.array([start, upper + 0.15 * along]))
    axes.plot(*ends.T, color=MUTED, linewidth=1.0, linestyle=(0, (5, 2, 1, 2)), zorder=4.0)


def draw_ground(
    axes: Axes, view: View, scene: Scene, pose: Pose, line: Array | None = None
) -> None:
    """Draw the road below the wheel, in mm, as a strip of some width; ``line`` has its x and z, shape (n, 2), m."""
    corners = ground_corners(scene, pose)
    if line is None:
        line = corners[:2, [0, 2]]
    sides = [
        np.column_stack([line[:, 0], np.full(len(line), y), line[:, 1]]) for y in corners[[0, 2], 1]
    ]
    base = float(line[:, 1].min()) - 0.06 * scene.radius
    for side in sides:
        below = np.column_stack([side[::-1, :2], np.full(len(line), base)])
        axes.fill(
            *(MM * view.flat(np.vstack([side, below]))).T,
            facecolor=ROAD,
            alpha=0.14,
            linewidth=0.0,
            zorder=0.4,
        )
        axes.plot(*(MM * view.flat(side)).T, color=ROAD, linewidth=0.9, zorder=0.6)
    top = np.vstack([sides[0], sides[1][::-1]])
    axes.fill(*(MM * view.flat(top)).T, facecolor=ROAD, alpha=0.14, linewidth=0.0, zorder=0.5)
    for k in (0, -1):
        end = np.array([sides[0][k], sides[1][k]])
        face = np.vstack([end, [[*end[1, :2], base], [*end[0, :2], base]]])
        axes.fill(*(MM * view.flat(face)).T, facecolor=ROAD, alpha=0.14, linewidth=0.0, zorder=0.4)
        axes.plot(*(MM * view.flat(end)).T, color=ROAD, linewidth=0.9, zorder=0.6)


def ground_corners(scene: Scene, pose: Pose) -> Array:
    """Return the corners of the level ground drawn under a wheel, shape (4, 3), m."""
    x, y = pose.points["wheel_centre"][:2]
    reach, across = 1.1 * scene.undeformed_radius, 0.95 * scene.width
    return np.array(
        [
            (x + i * reach, y + j * across, pose.ground)
            for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))
        ]
    )


_WIDTH, _TALLEST = 11.0, 8.8  # inches of paper, as all lengths below
_LEFT, _RIGHT, _BETWEEN = 0.62, 0.15, 0.72
_INSIDE = 0.3  # margin between the drawing and the edges of its axes
_BOTTOM, _TOP, _ABOVE = 0.98, 0.72, 0.72
ARROWS = 0.85
"""Height in inches kept free in the last view for the directions of the axes."""
DASHED: Any = (0, (3, 1.2))
AZIMUTH, ELEVATION = np.radians(38.0), np.radians(20.0)


def views_of(scene: Scene) -> tuple[View, View, View, View]:
    """Return the front, side (from outside), top (front down) and oblique (from ahead, inboard and above) views."""
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
    """Scale and centre of each view; the three views along the axes have the same scale and are aligned."""

    views: tuple[View, View, View, View]  # front, side, top, and in space
    middles: tuple[Array, ...]  # centre of each view, shape (2,), mm
    scale: float  # mm per inch of the first three
    oblique_scale: float  # mm per inch of the last
    heights: tuple[float, float]  # of the upper and the lower two axes, inches

    @classmethod
    def for_poses(cls, scene: Scene, poses: Sequence[Pose], *, names: bool) -> Sheet:
        """Find scales at which all poses and the names of hardpoints fill the width, and the heights of the axes."""
        views = views_of(scene)
        cloud = np.vstack([everything(scene, pose) for pose in poses])
        written = {**_hardpoints_of(scene.design), "contact point": None}
        across = _panel_width() - (2.0 * column_width(written) if names else 0.1) - _INSIDE
        tallest = (_TALLEST - _BOTTOM - _TOP - _ABOVE) / 2.0 - _INSIDE
        column = column_height(written) if names else 0.0
        spans, middles = [], []
        for view in views:
            flat = MM * view.flat(cloud)
            low, high = flat.min(axis=0), flat.max(axis=0)
            spans.append(high - low)
            middles.append(0.5 * (low + high))
        scale = float(np.max(np.array(spans[:3]) / (across, tallest)))
        upper = max(spans[0][1] / scale, spans[1][1] / scale, column)
        lower = max(spans[2][1] / scale, column + ARROWS)
        oblique = float(np.max(spans[3] / (across, lower)))
        return cls(
            views, tuple(middles), scale, oblique, (float(upper) + _INSIDE, float(lower) + _INSIDE)
        )

    @property
    def paper(self) -> tuple[float, float]:
        """Width and height in inches."""
        return _WIDTH, _BOTTOM + self.heights[1] + _ABOVE + self.heights[0] + _TOP

    def scale_of(self, view: View) -> float:
        """Millimetres per inch."""
        return self.oblique_scale if view is self.views[3] else self.scale

    def panels(self, figure: Figure) -> list[Axes]:
        """Add the axes, two by two."""
        width, size = _panel_width(), np.array(self.paper)
        labels = [
            tuple(display_unit("m").label(word) for word in pair) for pair in ("yz", "xz", "yx")
        ]
        labels.append(("", ""))
        panels = []
        for k, view in enumerate(self.views):
            height = self.heights[k // 2]
            corner = (
                _LEFT + (k % 2) * (width + _BETWEEN),
                _BOTTOM + (1 - k // 2) * (self.heights[1] + _ABOVE),
            )
            box = (*(np.array(corner) / size), *(np.array([width, height]) / size))
            axes = figure.add_axes(box, label=("front", "side", "top", "space")[k])
            half = 0.5 * np.array([width, height]) * self.scale_of(view)
            low, high = self.middles[k] - half, self.middles[k] + half
            axes.set(
                xlim=(low[0], high[0]),
                ylim=(low[1], high[1]),
                xlabel=labels[k][0],
                ylabel=labels[k][1],
            )
            axes.set_title(view.name)
            show_ticks(axes, view)
            panels.append(axes)
        return panels


def _panel_width() -> float:
    return (_WIDTH - _LEFT - _RIGHT - _BETWEEN) / 2.0


def show_ticks(axes: Axes, view: View) -> None:
    """Show coordinates along ground axes, even if these point left or down; none in the oblique view."""
    from matplotlib.ticker import FuncFormatter, MultipleLocator

    if view.name.startswith("from"):
        axes.set(xticks=[], yticks=[])
        axes.grid(visible=False)
        axes.spines[:].set_visible(False)
        return
    shown = display_unit("m").factor / MM
    for axis, direction in ((axes.xaxis, view.right), (axes.yaxis, view.up)):
        sign = -1.0 if direction.sum() < 0.0 else 1.0
        if shown != 1.0:
            low, high = axis.get_view_interval()
            steps = [
                step
                for step in (0.5, 1.0, 2.0, 5.0, 10.0, 20.0)
                if step > (high - low) * shown / _MOST_TICKS
            ]
            axis.set_major_locator(MultipleLocator((steps or [50.0])[0] / shown))
        if shown != 1.0 or sign < 0.0:
            text = partial(_place, factor=sign * shown)
            axis.set_major_formatter(FuncFormatter(text))
    axes.tick_params(length=2.5)


_MOST_TICKS = 6


def _place(value: float, _: int | None = None, *, factor: float) -> str:
    return f"{factor * value + 0.0:g}".replace("-", "−")


def new_sheet(title: str, scene: Scene, paper: tuple[float, float]) -> Figure:
    """Return an empty sheet with a title; ``paper`` is its size in inches."""
    figure = figure_type()(figsize=paper)
    words = scene.title[0].upper() + scene.title[1:]
    figure.suptitle(
        f"{title}: {scene.title}" if title else words,
        x=_LEFT / paper[0],
        y=1.0 - 0.14 / paper[1],
        ha="left",
        va="top",
        fontsize=11.5,
        fontweight="bold",
    )
    return figure


def everything(scene: Scene, pose: Pose) -> Array:
    """Return all points that must be visible, shape (n, 3), m."""
    surface = tyre(pose.points["wheel_centre"], pose.spin_axis, scene.radius, scene.width).reshape(
        -1, 3
    )
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
        axes.text(
            x + 1.25 * dx, y + 1.25 * dy, name, fontsize=8, color=MUTED, ha="center", va="center"
        )


def handles_of(scene: Scene) -> list[Line2D]:
    """Return the legend of a rig: its parts and marks."""
    handles = [_handle(part.words, part.colour, linewidth=2.2) for part in scene.parts]
    handles += [
        _handle("spring and damper", scene.strut_colour, linewidth=2.2),
        _handle("wheel", RUBBER, linewidth=1.1),
    ]
    return handles + _marks(scene)


def pose_handles(scene: Scene, shown: Sequence[Pose], looks: Sequence[Look]) -> list[Line2D]:
    """Return the legend of several poses."""
    handles = [_handle(scene.design.label, INK, linewidth=2.2)]
    handles += [
        _handle(pose.label, str(look.colour), linewidth=1.8)
        for pose, look in zip(shown, looks, strict=True)
    ]
    handles.append(_handle("path of the wheel centre", INK, linewidth=0.9))
    handles.append(_handle("path of the contact point", INK, linewidth=0.9, linestyle=DASHED))
    return handles + _marks(scene)


def _marks(scene: Scene) -> list[Line2D]:
    plain = {
        "linestyle": "none",
        "markerfacecolor": "white",
        "markeredgecolor": INK,
        "markersize": 4.5,
    }
    axis = (
        [_handle("steering axis", MUTED, linewidth=1.0, linestyle=(0, (5, 2, 1, 2)))]
        if scene.steering_axis
        else []
    )
    return [
        *axis,
        _handle("on the body", INK, marker="s", **plain),
        _handle("moves", INK, marker="o", **plain),
        _handle("contact point", ROAD, marker="^", linestyle="none", markersize=6.0),
    ]


def _handle(label: str, colour: str, **options: Any) -> Line2D:
    from matplotlib.lines import Line2D

    return Line2D([], [], color=colour, label=label, **options)


_LOW, _MIDDLE, _HIGH = "#0067a8", "#a9b0b7", "#d55e00"


@in_style
def mechanism(
    rig: Corner,
    poses: xr.Dataset | None = None,
    at: Sequence[float | str] | None = None,
    *,
    names: bool = True,
    title: str = "",
) -> Figure:
    """Draw a 3-D rig at design: front, side and top view at the same scale, and an oblique view.

    Parameters
    ----------
    rig : Corner
        Double wishbone, McPherson strut, five-link or trailing arm.
    poses : xarray.Dataset, optional
        A sweep or a run with hardpoints: several poses are drawn over each other, with the paths of wheel centre and
        contact point.
    at : sequence of float or str, optional
        Poses to draw: travel (m) or time (s), or text with a unit; the nearest poses are used. By default the first and
        the last of a sweep, and those with the lowest and the highest wheel of a run.
    names : bool
        Write the names of the hardpoints.
    title : str
        Text before the kind of suspension.

    Returns
    -------
    matplotlib.figure.Figure
        Axes ``front``, ``side``, ``top`` and ``space``, all in mm.

    Raises
    ------
    DescriptionError
        For a rig without hardpoints, or a pose that ``poses`` does not reach.
    RecordingError
        For ``poses`` without hardpoints.

    Examples
    --------
    >>> import jounce as jn
    >>> figure = mechanism(jn.load("reference-double-wishbone"))
    >>> [axes.get_label() for axes in figure.axes]
    ['front', 'side', 'top', 'space']
    """
    scene = scene_of(rig)
    tracks = None if poses is None else poses_of(rig, scene, poses)
    chosen = [] if tracks is None else _choose_poses(tracks, at)
    shown = [] if tracks is None else [tracks.pose(k) for k in chosen]
    looks = [Look(colour, ghost=True) for colour in _colours(tracks, chosen)]
    handles = handles_of(scene) if tracks is None else pose_handles(scene, shown, looks)
    sheet = Sheet.for_poses(scene, [scene.design, *shown], names=names)
    figure = new_sheet(title, scene, sheet.paper)
    for axes, view in zip(sheet.panels(figure), sheet.views, strict=True):
        draw_ground(axes, view, scene, scene.design)
        for pose, look in zip(shown, looks, strict=True):
            draw_pose(axes, view, scene, pose, look)
        if tracks is not None:
            for track, style in ((tracks.points["wheel_centre"], "-"), (tracks.contact, DASHED)):
                axes.plot(
                    *(MM * view.flat(track)).T,
                    color=INK,
                    linewidth=0.9,
                    linestyle=style,
                    zorder=4.2,
                )
        draw_pose(axes, view, scene, scene.design, Look() if tracks is None else Look(INK))
        draw_steering_axis(axes, view, scene, scene.design)
        if names:
            places = {**_hardpoints_of(scene.design), "contact point": scene.design.contact}
            floor = ARROWS if view is sheet.views[3] else 0.0
            flat = {name: MM * view.flat(place) for name, place in places.items()}
            write_names(axes, flat, sheet.scale_of(view), floor)
    draw_directions(figure.axes[3], sheet.views[3])
    columns = -(-len(handles) // 2)
    figure.legend(
        handles=handles,
        loc="lower center",
        ncols=columns,
        columnspacing=1.6,
        bbox_to_anchor=(0.5, 0.01),
    )
    return figure


def _hardpoints_of(pose: Pose) -> dict[str, Array]:
    """Positions of the hardpoints of a pose, m."""
    return {name: place for name, place in pose.points.items() if name not in MIDDLE.values()}


def _choose_poses(poses: Poses, at: Sequence[float | str] | None) -> list[int]:
    from jounce.core.units import to_si

    if at is None:
        height = poses.points["wheel_centre"][:, 2]
        ends = (
            [int(height.argmin()), int(height.argmax())] if poses.in_time else [0, len(poses) - 1]
        )
        return sorted(set(ends))
    values = [to_si(value, poses.unit, where="at") for value in at]
    return list(dict.fromkeys(poses.nearest(value, "at") for value in values))


def _colours(poses: Poses | None, chosen: Sequence[int]) -> list[str]:
    """One colour for each pose, from blue for the lowest value to orange for the highest."""
    if poses is None or not chosen:
        return []
    from matplotlib.colors import LinearSegmentedColormap, to_hex

    values = poses.over[list(chosen)]
    span = (
        max(abs(values.min()), abs(values.max()))
        if not poses.in_time and values.min() < 0.0
        else np.ptp(values)
    )
    first = -span if not poses.in_time and values.min() < 0.0 else values.min()
    length = (values.max() - first if values.min() >= 0.0 else 2.0 * span) or 1.0
    colours = LinearSegmentedColormap.from_list("travel", [_LOW, _MIDDLE, _HIGH])
    return [to_hex(colours(float((value - first) / length))) for value in values]
