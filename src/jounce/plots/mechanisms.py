"""Suspensions as drawings: three views and one in space, with the names of the hardpoints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.plots.drawing import MM, Look, draw_ground, draw_pose, draw_steering_axis
from jounce.plots.labels import write_names
from jounce.plots.poses import Poses, poses_of
from jounce.plots.scenes import scene_of
from jounce.plots.shapes import View
from jounce.plots.sheets import ARROWS, DASHED, Sheet, draw_directions, handles_of, new_sheet, pose_handles
from jounce.plots.style import INK, styled

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.parts.corners import Corner

_LOW, _MIDDLE, _HIGH = "#0067a8", "#a9b0b7", "#d55e00"


@styled
def mechanism(
    rig: Corner,
    poses: xr.Dataset | None = None,
    at: Sequence[float | str] | None = None,
    *,
    names: bool = True,
    title: str = "",
) -> Figure:
    """Draw a 3-D rig at design: front, side and top view to one scale, and a view in space.

    Parameters
    ----------
    rig : Corner
        Double wishbone, McPherson strut, five-link or trailing arm.
    poses : xarray.Dataset, optional
        A sweep or a run with hardpoints: further poses are drawn over the first, with the paths of wheel centre and
        contact point.
    at : sequence of float or str, optional
        Which poses: travel (m) or time (s), or text with a unit; the nearest ones are drawn. By default the first and
        the last of a sweep, the lowest and the highest wheel of a run.
    names : bool
        Write the names of the hardpoints.
    title : str
        Put before the kind of suspension.

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
    chosen = [] if tracks is None else _chosen(tracks, at)
    shown = [] if tracks is None else [tracks.pose(k) for k in chosen]
    looks = [Look(colour, ghost=True) for colour in _colours(tracks, chosen)]
    handles = handles_of(scene) if tracks is None else pose_handles(scene, shown, looks)
    sheet = Sheet.for_poses(scene, [scene.design, *shown], names=names)
    figure = new_sheet(title, scene)
    for axes, view in zip(sheet.panels(figure), sheet.views, strict=True):
        draw_ground(axes, view, scene, scene.design)
        for pose, look in zip(shown, looks, strict=True):
            draw_pose(axes, view, scene, pose, look)
        if tracks is not None:
            _draw_ways(axes, view, tracks)
        draw_pose(axes, view, scene, scene.design, Look() if tracks is None else Look(INK))
        draw_steering_axis(axes, view, scene, scene.design)
        if names:
            places = {**scene.design.points, "contact point": scene.design.contact}
            floor = ARROWS if view is sheet.views[3] else 0.0
            flat = {name: MM * view.flat(place) for name, place in places.items()}
            write_names(axes, flat, sheet.scale_of(view), floor)
    draw_directions(figure.axes[3], sheet.views[3])
    columns = -(-len(handles) // 2)
    figure.legend(handles=handles, loc="lower center", ncols=columns, columnspacing=1.6, bbox_to_anchor=(0.5, 0.01))
    return figure


def _chosen(poses: Poses, at: Sequence[float | str] | None) -> list[int]:
    from jounce.core.units import to_si

    if at is None:
        height = poses.points["wheel_centre"][:, 2]
        ends = [int(height.argmin()), int(height.argmax())] if poses.in_time else [0, len(poses) - 1]
        return sorted(set(ends))
    values = [to_si(value, poses.unit, where="at") for value in at]
    return list(dict.fromkeys(poses.nearest(value, "at") for value in values))


def _colours(poses: Poses | None, chosen: Sequence[int]) -> list[str]:
    """One colour for each pose, from blue for the lowest value to orange for the highest."""
    if poses is None or not chosen:
        return []
    from matplotlib.colors import LinearSegmentedColormap, to_hex

    values = poses.over[list(chosen)]
    span = max(abs(values.min()), abs(values.max())) if not poses.in_time and values.min() < 0.0 else np.ptp(values)
    first = -span if not poses.in_time and values.min() < 0.0 else values.min()
    length = (values.max() - first if values.min() >= 0.0 else 2.0 * span) or 1.0
    colours = LinearSegmentedColormap.from_list("travel", [_LOW, _MIDDLE, _HIGH])
    return [to_hex(colours(float((value - first) / length))) for value in values]


def _draw_ways(axes: Axes, view: View, poses: Poses) -> None:
    for track, style in ((poses.points["wheel_centre"], "-"), (poses.contact, DASHED)):
        axes.plot(*(MM * view.flat(track)).T, color=INK, linewidth=0.9, linestyle=style, zorder=4.2)
