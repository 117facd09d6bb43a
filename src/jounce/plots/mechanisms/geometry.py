"""Geometry of a suspension: instant centres, roll centre and steering axis in side, front and top view."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import display_unit
from jounce.core.types import Array
from jounce.kinematics import sweep_travel
from jounce.plots.display import PARALLEL, kinematic_value, number
from jounce.plots.figures import INK, MUTED, PALETTE, figure_type, in_style
from jounce.plots.mechanisms.drawing import (
    MM,
    Look,
    View,
    draw_pose,
    everything,
    show_ticks,
    views_of,
)
from jounce.plots.mechanisms.scene import Pose, Scene, scene_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.parts.corners import Corner

_WIDTH = 11.0  # inches, as all lengths below
_LEFT, _RIGHT, _BETWEEN, _BOTTOM, _ABOVE, _TOP = 0.72, 0.15, 0.78, 0.55, 0.8, 0.95
_ROOM = 0.04  # m around the drawing
_NEAR = 1.2  # m from the wheel: nearer instant centres are drawn at their position
_CENTRE, _ROLL, _AXIS = PALETTE[1], PALETTE[3], PALETTE[0]
_OTHER = "#a3aab1"
_AXIS_ROWS = ("caster", "kingpin_inclination", "caster_trail", "scrub_radius")
_NUMBERS = (
    "roll_centre_height",
    "instant_centre_y",
    "instant_centre_z",
    "front_view_swing_arm_length",
    "side_instant_centre_x",
    "side_instant_centre_z",
    "camber",
    "camber_gain",
    "bump_steer",
    "caster",
    "kingpin_inclination",
    "caster_trail",
    "scrub_radius",
    "motion_ratio",
)


@dataclass(frozen=True)
class _Centres:
    """Centres of rotation of a corner at design: points of shape (2,), m, NaN if arms are parallel; and all rows."""

    scene: Scene
    rows: Mapping[str, float]
    units: Mapping[str, str]

    @property
    def pose(self) -> Pose:
        return self.scene.design

    @property
    def front(self) -> Array:
        """Position (y, z) of the front-view instant centre."""
        return np.array([self.rows["instant_centre_y"], self.rows["instant_centre_z"]])

    @property
    def side(self) -> Array:
        """Position (x, z) of the side-view instant centre."""
        return np.array([self.rows["side_instant_centre_x"], self.rows["side_instant_centre_z"]])

    def value_to_show(self, name: str) -> float:
        """Value of a row to write; infinite for the height of a centre at infinity."""
        away = self.rows.get(
            {"instant_centre_z": "instant_centre_y"}.get(name, name.replace("centre_z", "centre_x"))
        )
        return self.rows[name] if away is None or abs(away) < PARALLEL else math.inf

    @property
    def axis(self) -> tuple[Array, Array] | None:
        """Ground intersection of the steering axis, and its point above the wheel; None without steering."""
        if not all(math.isfinite(self.rows.get(name, math.nan)) for name in _AXIS_ROWS):
            return None
        caster, inclination, trail, scrub = (self.rows[name] for name in _AXIS_ROWS)
        side = self.scene.side
        ground = self.pose.contact + np.array([trail, -side * scrub, 0.0])
        along = np.array([-math.tan(caster), -side * math.tan(inclination), 1.0])
        return ground, ground + 1.8 * self.scene.radius * along

    @property
    def roll(self) -> Array:
        """Position (y, z) of the roll centre of a symmetric axle."""
        return np.array([0.0, self.pose.ground + self.rows["roll_centre_height"]])


@in_style
def suspension_geometry(rigs: Corner | Mapping[str, Corner], *, title: str = "") -> Figure:
    """Draw a corner at design in front, side and top view with instant centres, roll centre and steering axis.

    Parameters
    ----------
    rigs : Corner, or mapping of str to Corner
        A corner with hardpoints. Of several, given by name, the last is drawn in full, the others with thin lines
        behind it.
    title : str
        Text before the kind of suspension.

    Returns
    -------
    matplotlib.figure.Figure
        Axes ``front``, ``side``, ``top`` at the same scale (mm), and a table of the values.

    Raises
    ------
    DescriptionError
        For a rig without hardpoints.

    Examples
    --------
    >>> import jounce as jn
    >>> figure = suspension_geometry(jn.load("formula-student-front"))
    >>> [axes.get_label() for axes in figure.axes]
    ['front', 'side', 'top', 'numbers']
    """
    named = dict(rigs) if isinstance(rigs, Mapping) else {"": rigs}
    centres = {name: _centres(rig) for name, rig in named.items()}
    scene = list(centres.values())[-1].scene
    front, side, top, _ = views_of(scene)
    clouds = [
        np.vstack([everything(geometry.scene, geometry.pose) for geometry in centres.values()])
    ]
    clouds += [np.array([[0.0, 0.0, geometry.pose.ground] for geometry in centres.values()])]
    clouds += [np.array([[0.0, *geometry.roll] for geometry in centres.values()])]
    drawn = np.vstack([cloud[np.isfinite(cloud).all(axis=1)] for cloud in clouds])
    wheel = scene.design.points["wheel_centre"]
    ahead = drawn[drawn[:, 1] * scene.side > 0.0] if scene.side else drawn
    boxes = {
        "front": _box(
            front, drawn, [_in_front(geometry.front) for geometry in centres.values()], wheel
        ),
        "side": _box(side, ahead, [_beside(geometry.side) for geometry in centres.values()], wheel),
        "top": _box(top, drawn, [], wheel),
    }
    for name in ("front", "side"):  # they are aligned
        boxes[name][:, 1] = (
            min(boxes[panel][0, 1] for panel in ("front", "side")),
            max(boxes[panel][1, 1] for panel in ("front", "side")),
        )
    boxes["top"][:, 0] = boxes["front"][:, 0]
    figure, axes = _paper(boxes)
    words = scene.title[0].upper() + scene.title[1:]
    figure.suptitle(
        f"{title}: {scene.title}" if title else words,
        x=_LEFT / _WIDTH,
        ha="left",
        fontsize=11.5,
        fontweight="bold",
    )
    for name, view in (("front", front), ("side", side), ("top", top)):
        axes[name].set_title(view.name)
        show_ticks(axes[name], view)
        for k, geometry in enumerate(centres.values()):
            last = k == len(centres) - 1
            draw_pose(
                axes[name],
                view,
                geometry.scene,
                geometry.pose,
                None if last else Look(_OTHER, ghost=True),
            )
            _construction(axes[name], name, view, geometry, strong=last)
    _labels(axes)
    _numbers(axes["numbers"], centres)
    _legend(
        figure,
        list(centres),
        steers=any(geometry.axis is not None for geometry in centres.values()),
    )
    return figure


def _centres(rig: Corner) -> _Centres:
    swept = sweep_travel(rig, [0.0]).isel(wheel_travel=0)
    rows = {str(name): float(swept[name]) for name in swept.data_vars}
    return _Centres(
        scene_of(rig),
        rows,
        {str(name): str(swept[name].attrs["units"]) for name in swept.data_vars},
    )


def _in_front(centre: Array) -> Array:
    return np.array([0.0, *centre])


def _beside(centre: Array) -> Array:
    return np.array([centre[0], 0.0, centre[1]])


def _box(view: View, cloud: Array, centres: list[Array], wheel: Array) -> Array:
    """Lower and upper corner on paper, shape (2, 2), m, of the drawing and of the centres nearby."""
    flat = view.flat(cloud)
    origin = view.flat(wheel)
    near = [
        view.flat(centre)
        for centre in centres
        if np.max(np.abs(view.flat(centre) - origin)) < _NEAR
    ]
    points = np.vstack([flat, *(point[None, :] for point in near)])
    return np.array([points.min(axis=0) - _ROOM, points.max(axis=0) + _ROOM])


def _paper(boxes: Mapping[str, Array]) -> tuple[Figure, dict[str, Axes]]:
    """Make a figure with views at one scale that fill its width: front and side aligned, top below, and a table."""
    spans = {name: box[1] - box[0] for name, box in boxes.items()}
    room = _WIDTH - _LEFT - _RIGHT - _BETWEEN
    scale = room / (spans["front"][0] + spans["side"][0])  # inches of paper for one metre
    upper, lower = (
        scale * spans["front"][1],
        max(scale * spans["top"][1], 0.21 * (len(_NUMBERS) + 2)),
    )
    size = np.array([_WIDTH, _BOTTOM + lower + _ABOVE + upper + _TOP])
    figure = figure_type()(figsize=(_WIDTH, float(size[1])))
    wide = scale * spans["front"][0]
    places = {
        "front": (_LEFT, _BOTTOM + lower + _ABOVE, wide, upper),
        "side": (_LEFT + wide + _BETWEEN, _BOTTOM + lower + _ABOVE, room - wide, upper),
        "top": (_LEFT, _BOTTOM, wide, lower),
        "numbers": (_LEFT + wide + 0.3, _BOTTOM, room - wide + _BETWEEN - 0.3, lower),
    }
    axes = {}
    for name, (left, bottom, width, height) in places.items():
        axes[name] = figure.add_axes(
            (left / size[0], bottom / size[1], width / size[0], height / size[1]), label=name
        )
        if name in boxes:
            middle, half = boxes[name].mean(axis=0), 0.5 * np.array([width, height]) / scale
            low, high = MM * (middle - half), MM * (middle + half)
            axes[name].set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    return figure, axes


def _construction(axes: Axes, name: str, view: View, geometry: _Centres, *, strong: bool) -> None:
    """Draw instant centre, roll centre and steering axis in one view."""
    pose = geometry.pose
    style: dict[str, Any] = {"linewidth": 0.7, "zorder": 1.2}
    colours = (_OTHER,) * 3
    if strong:
        style, colours = {"linewidth": 1.1, "zorder": 4.5}, (_CENTRE, _ROLL, _AXIS)
    ends = [*(geometry.scene.steering_axis or ())]
    if name in ("front", "side"):
        axes.axhline(MM * pose.ground, color=MUTED, linewidth=0.7, zorder=0.5)
        centre = geometry.front if name == "front" else geometry.side
        place = _in_front(centre) if name == "front" else _beside(centre)
        if np.all(np.isfinite(place)):
            target = MM * view.flat(place)
            for start, dash in (
                (pose.contact, "-"),
                *((pose.points[end], (0, (1, 2))) for end in ends),
            ):
                _segment(
                    axes, MM * view.flat(start), target, color=colours[0], linestyle=dash, **style
                )
            _mark(axes, target, colours[0], "o", strong=strong)
            if strong:
                _outside(axes, target, "y" if name == "front" else "x", float(centre[0]))
    if name == "front":
        axes.axvline(0.0, color=MUTED, linewidth=0.7, linestyle=(0, (8, 3, 2, 3)), zorder=0.5)
        roll = MM * view.flat(np.array([0.0, *geometry.roll]))
        _segment(
            axes,
            MM * view.flat(pose.contact),
            roll,
            color=colours[1],
            linestyle=(0, (4, 2)),
            **style,
        )
        _mark(axes, roll, colours[1], "D", strong=strong)
    if geometry.axis is not None:
        ground, upper = geometry.axis
        ends_on_paper = MM * view.flat(ground), MM * view.flat(upper)
        _segment(axes, *ends_on_paper, color=colours[2], linestyle=(0, (5, 2, 1, 2)), **style)
        _mark(axes, ends_on_paper[0], colours[2], "x", strong=strong)


def _segment(axes: Axes, start: Array, end: Array, **style: Any) -> None:
    axes.plot(
        [start[0], end[0]], [start[1], end[1]], scalex=False, scaley=False, clip_on=True, **style
    )


def _mark(axes: Axes, place: Array, colour: str, marker: str, *, strong: bool) -> None:
    face: dict[str, Any] = (
        {} if marker == "x" else {"markerfacecolor": colour if strong else "white"}
    )
    axes.plot(
        *place, marker, color=colour, markersize=6.0, zorder=6.0, scalex=False, scaley=False, **face
    )


def _outside(axes: Axes, target: Array, axis: str, place: float) -> None:
    """Write at the edge the position (m along an axis) of an instant centre outside the drawing."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    if left <= target[0] <= right and low <= target[1] <= high:
        return
    unit = display_unit("m")
    if not left <= target[0] <= right:
        arrow = "←" if target[0] < left else "→"
    else:
        arrow = "↑" if target[1] > high else "↓"
    on_left = target[0] < 0.5 * (left + right)
    x, side = (0.01, "left") if on_left else (0.99, "right")
    text = f"{arrow} instant centre at {axis} = {number(place * unit.factor, 4)} {unit.name}"
    axes.text(
        x, 0.97, text, transform=axes.transAxes, ha=side, va="top", fontsize=7.5, color=_CENTRE
    )


def _labels(axes: Mapping[str, Axes]) -> None:
    unit = display_unit("m")
    for name, pair in (("front", "yz"), ("side", "xz"), ("top", "yx")):
        axes[name].set(xlabel=unit.label(pair[0]), ylabel=unit.label(pair[1]))


def _numbers(axes: Axes, centres: Mapping[str, _Centres]) -> None:
    """Write the table of values, one column per rig."""
    axes.axis("off")
    last = list(centres.values())[-1]
    names = [name for name in _NUMBERS if name in last.rows]
    columns = 1.0 - 0.17 * np.arange(len(centres))[::-1]
    step = 1.0 / (len(_NUMBERS) + 2)
    for x, label in zip(columns, centres, strict=True):
        axes.text(
            x,
            1.0 - 0.5 * step,
            label,
            ha="right",
            va="center",
            fontsize=8.5,
            fontweight="bold",
            color=INK,
        )
    for k, name in enumerate(names):
        y = 1.0 - (k + 1.5) * step
        si = last.units[name]
        unit = display_unit(si)
        words = unit.label(name.replace("_", " ")) if unit.name else name.replace("_", " ")
        axes.text(0.02, y, words, ha="left", va="center", fontsize=8.5, color=INK)
        for x, geometry in zip(columns, centres.values(), strict=True):
            value = kinematic_value(name, geometry.value_to_show(name), si)
            text = value if isinstance(value, str) else number(value, 4)
            axes.text(x, y, text, ha="right", va="center", fontsize=8.5, color=INK)
    axes.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))


def _legend(figure: Figure, names: list[str], *, steers: bool) -> None:
    from matplotlib.lines import Line2D

    marks = [
        Line2D([], [], color=_CENTRE, marker="o", linewidth=1.1, label="instant centre"),
        Line2D(
            [],
            [],
            color=_ROLL,
            marker="D",
            linewidth=1.1,
            linestyle=(0, (4, 2)),
            label="roll centre",
        ),
    ]
    if steers:
        dashes = (0, (5, 2, 1, 2))
        marks.append(
            Line2D(
                [],
                [],
                color=_AXIS,
                marker="x",
                linewidth=1.1,
                linestyle=dashes,
                label="steering axis",
            )
        )
    if len(names) > 1:
        marks += [
            Line2D([], [], color=_OTHER, linewidth=1.6, label=" and ".join(names[:-1])),
            Line2D([], [], color=INK, linewidth=2.2, label=names[-1]),
        ]
    figure.legend(
        handles=marks,
        loc="upper right",
        ncols=len(marks),
        bbox_to_anchor=(1.0 - _RIGHT / _WIDTH, 1.0),
    )
