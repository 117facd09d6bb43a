"""One pose of a mechanism on paper, in any view: wheel, links, spring, steering axis, road. Places are drawn in mm."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.types import Array
from jounce.plots.scenes import Pose, Scene
from jounce.plots.shapes import View, circle, coil, outline, tyre
from jounce.plots.style import INK, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MM = 1e3
RUBBER, ROAD = "#5b636b", "#7d7468"
_RIM, _SHOULDER = 0.56, 0.9
DAMPER_BODY = 0.5  # of its design length


@dataclass(frozen=True)
class Look:
    """How a pose is drawn.

    Attributes
    ----------
    colour : str, optional
        One colour for everything instead of each part's own.
    ghost : bool
        Drawn thinly behind another pose, without surfaces and points, the strut as a line.
    """

    colour: str | None = None
    ghost: bool = False

    @property
    def strength(self) -> float:
        """Share of opacity and of line widths [1]."""
        return 0.65 if self.ghost else 1.0


def draw_pose(
    axes: Axes, view: View, scene: Scene, pose: Pose, look: Look | None = None, *, pressed: bool = False
) -> None:
    """Draw everything that moves.

    Parameters
    ----------
    axes : Axes
        Where; one unit is a millimetre.
    view : View
        Where it is looked from.
    scene, pose : Scene, Pose
        What is drawn.
    look : Look, optional
        Its own colours by default.
    pressed : bool
        Draw the unloaded tyre, pressed flat by the road, instead of the wheel at its design radius.
    """
    look = look or Look()
    _draw_wheel(axes, view, scene, pose, look, pressed=pressed)
    for order, part in enumerate(scene.parts):
        if not all(name in pose.points for name in part.points):
            continue
        colour = look.colour or part.colour
        flat = MM * view.flat(np.array([pose.points[name] for name in part.points]))
        if part.plate:
            corners = outline(flat) if part.name == "upright" else flat
            if not look.ghost:
                axes.fill(corners[:, 0], corners[:, 1], color=colour, alpha=0.13, linewidth=0.0, zorder=2.0)
            flat = np.vstack([corners, corners[:1]])
        _line(axes, flat, colour, 2.2 * look.strength, 3.0 + 0.01 * order, look)
    for bracket in scene.brackets:
        first, second = pose.points[bracket.first], pose.points[bracket.second]
        ends = np.array([pose.points[bracket.point], first + bracket.share * (second - first)])
        _line(axes, MM * view.flat(ends), look.colour or bracket.colour, 1.0 * look.strength, 2.9, look)
    _draw_strut(axes, view, scene, pose, look)
    if not look.ghost:
        _draw_points(axes, view, scene, pose)


def _line(axes: Axes, flat: Array, colour: str, width: float, zorder: float, look: Look, **options: Any) -> None:
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


def _draw_wheel(axes: Axes, view: View, scene: Scene, pose: Pose, look: Look, *, pressed: bool) -> None:
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
        names = [name for name in pose.points if (name in scene.on_body) is on_body and name != "wheel_centre"]
        flat = MM * view.flat(np.array([pose.points[name] for name in names]))
        axes.plot(*flat.T, marker, color="white", markeredgecolor=INK, markeredgewidth=0.9, markersize=4.2, zorder=5.0)
    centre, contact = (MM * view.flat(place) for place in (pose.points["wheel_centre"], pose.contact))
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
    """Draw the axis the wheel steers about, from the ground to a little above its upper point."""
    if scene.steering_axis is None:
        return
    lower, upper = (pose.points[name] for name in scene.steering_axis)
    along = upper - lower
    if abs(along[2]) < 1e-6 * float(np.linalg.norm(along)):
        return
    start = lower + along * (pose.ground - lower[2]) / along[2]
    ends = MM * view.flat(np.array([start, upper + 0.15 * along]))
    axes.plot(*ends.T, color=MUTED, linewidth=1.0, linestyle=(0, (5, 2, 1, 2)), zorder=4.0)


def draw_ground(axes: Axes, view: View, scene: Scene, pose: Pose, line: Array | None = None) -> None:
    """Draw the road below the wheel as a strip with some depth.

    Parameters
    ----------
    axes : Axes
        Where; one unit is a millimetre.
    view : View
        Where it is looked from.
    scene, pose : Scene, Pose
        Where the wheel is.
    line : ndarray, shape (n, 2), optional
        x and z of the road in m; level by default.
    """
    corners = ground_corners(scene, pose)
    if line is None:
        line = corners[:2, [0, 2]]
    sides = [np.column_stack([line[:, 0], np.full(len(line), y), line[:, 1]]) for y in corners[[0, 2], 1]]
    base = float(line[:, 1].min()) - 0.06 * scene.radius
    for side in sides:
        below = np.column_stack([side[::-1, :2], np.full(len(line), base)])
        axes.fill(*(MM * view.flat(np.vstack([side, below]))).T, facecolor=ROAD, alpha=0.14, linewidth=0.0, zorder=0.4)
        axes.plot(*(MM * view.flat(side)).T, color=ROAD, linewidth=0.9, zorder=0.6)
    top = np.vstack([sides[0], sides[1][::-1]])
    axes.fill(*(MM * view.flat(top)).T, facecolor=ROAD, alpha=0.14, linewidth=0.0, zorder=0.5)
    for k in (0, -1):
        end = np.array([sides[0][k], sides[1][k]])
        face = np.vstack([end, [[*end[1, :2], base], [*end[0, :2], base]]])
        axes.fill(*(MM * view.flat(face)).T, facecolor=ROAD, alpha=0.14, linewidth=0.0, zorder=0.4)
        axes.plot(*(MM * view.flat(end)).T, color=ROAD, linewidth=0.9, zorder=0.6)


def ground_corners(scene: Scene, pose: Pose) -> Array:
    """Corners of the piece of level ground that is drawn under a wheel, shape (4, 3), m."""
    x, y = pose.points["wheel_centre"][:2]
    reach, across = 1.1 * scene.undeformed_radius, 0.95 * scene.width
    return np.array([(x + i * reach, y + j * across, pose.ground) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
