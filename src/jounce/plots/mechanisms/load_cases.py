"""Drawings of load cases: the left and right wheel of an axle in equilibrium, with road forces and body forces."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from jounce.core.display import display_unit, display_unit_for
from jounce.core.errors import DescriptionError, unknown
from jounce.core.types import Array
from jounce.core.writing import write_files
from jounce.kinematics import sweep_travel
from jounce.kinematics.load_cases import from_across
from jounce.plots.figures import MUTED, in_style, render_figure
from jounce.plots.mechanisms.drawing import (
    MM,
    ROAD,
    View,
    axis_view,
    draw_pose,
    everything,
    show_ticks,
)
from jounce.plots.mechanisms.scene import MIDDLE, Pose, Scene, poses_of, scene_of

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.kinematics.axle_loads import AxleLoads
    from jounce.parts.corners import Corner

_Drawn: TypeAlias = "tuple[Scene, Pose, xr.Dataset]"
_PAPER = (11.0, 9.2)  # inches
_ON_ROAD, _ON_BODY = "#c1121f", "#1d2126"  # not used for any part
_LONGEST = 0.30  # m on paper: the largest force
_LABELLED = 0.12  # share of the largest force from which a force is labelled with its value
_SEEN = 0.01  # share of the largest force from which it is drawn
_LEAST = 1e-3  # N: rounding errors of the balance


@in_style
def load_case(rig: Corner, data: xr.Dataset, case: str) -> Figure:
    """Draw one load case: front and top view of the left and right wheel in equilibrium, with forces in kN (lbf).

    Parameters
    ----------
    rig : Corner
        The corner for which the cases were computed.
    data : xarray.Dataset
        Result of :func:`jounce.load_cases`.
    case : str
        Name of the case.

    Returns
    -------
    matplotlib.figure.Figure
        Axes ``front`` and ``top``: forces of the road on the wheels, and of the suspension on the body.

    Raises
    ------
    DescriptionError
        For a case that ``data`` does not have.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.LoadedAxle(
    ...     axle="front", mass=280.0, wheelbase=1.55, centre_of_mass_height=0.3, weight_share=0.48, brake_share=0.65
    ... )
    >>> rig = jn.load("formula-student-front")
    >>> [axes.get_label() for axes in load_case(rig, jn.load_cases(rig, car), "braking 1 g").figure.axes]
    ['front', 'top']
    """
    from matplotlib.figure import Figure

    known = [str(name) for name in data["case"].to_numpy()]
    if case not in known:
        raise unknown(case, known, what="load case", where="case")
    left = rig if rig.side == "left" else rig.mirrored()
    wheels: list[_Drawn] = []
    for wheel, side in (("left", left), ("right", left.mirrored())):
        loads = data.sel(case=case, wheel=wheel)
        scene = scene_of(side)
        pose = poses_of(
            side, scene, sweep_travel(side, [float(loads["wheel_travel"])], points=True)
        ).pose(0)
        wheels.append((scene, pose, loads))
    wheels = _with_third_spring(_with_bar(left, wheels))
    figure = Figure(figsize=_PAPER)
    figure.suptitle(
        f"{case}: {wheels[0][0].title.partition(',')[0]}", x=0.06, ha="left", fontweight="bold"
    )
    across = (0.0, 1.0, 0.0)
    views = (
        axis_view("front view", across, (0.0, 0.0, 1.0)),
        axis_view("top view", across, (-1.0, 0.0, 0.0)),
    )
    largest = max(
        float(np.linalg.norm(force))
        for _, pose, loads in wheels
        for _, _, force in _forces(pose, loads)
    )
    length, force_unit = display_unit("m"), display_unit_for("kN")
    labels = ("front", length.label("z")), ("top", length.label("x"))
    for k, (view, (label, up)) in enumerate(zip(views, labels, strict=True)):
        axes = figure.add_axes((0.07, 0.55 - 0.46 * k, 0.90, 0.38), label=label)
        axes.set(xlabel=length.label("y"), ylabel=up)
        axes.set_title(
            view.name
            + (", forward down" if k else ", seen from ahead: the left wheel on the right")
        )
        axes.set_aspect("equal", adjustable="box")
        for scene, pose, loads in wheels:
            draw_pose(axes, view, scene, pose)
            _draw_forces(axes, view, _forces(pose, loads), max(largest, _LEAST))
        if label == "front":
            ends = np.array([pose.contact for _, pose, _ in wheels])
            axes.axline(*(MM * view.flat(ends)), color=ROAD, linewidth=0.9, zorder=0.6)
        cloud = [everything(scene, pose) for scene, pose, _ in wheels]
        cloud += [
            _ends(*force, largest) for _, pose, loads in wheels for force in _forces(pose, loads)
        ]
        flat, room = MM * view.flat(np.vstack(cloud)), MM * np.array([0.12, 0.05])
        low, high = flat.min(axis=0) - room, flat.max(axis=0) + room
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        show_ticks(axes, view)
        _label_forces(
            axes,
            view,
            [f for _, pose, loads in wheels for f in _forces(pose, loads)],
            max(largest, _LEAST),
        )
    digits = 1 if length.factor >= MM else 2
    travels = [
        f"{length.factor * float(loads['wheel_travel']):+.{digits}f} {length.name}"
        for _, _, loads in wheels
    ]
    text = (
        f"numbers: {force_unit.name}; wheel travel: left {travels[0]}, right {travels[1]}".replace(
            "-", "−"
        )
    )
    figure.text(0.97, 0.012, text, ha="right", color=MUTED, fontsize=8.5)
    legend = (
        (_ON_ROAD, "force of the road on the wheel"),
        (_ON_BODY, "force of the suspension on the body"),
    )
    for i, (colour, words) in enumerate(legend):
        figure.text(0.07 + 0.24 * i, 0.012, f"→ {words}", color=colour, fontsize=8.5)
    return figure


def _with_bar(left: Corner, wheels: list[_Drawn]) -> list[_Drawn]:
    """Return the wheels with the T-bar turned by both; a single corner assumes that both wheels move alike."""
    if left.anti_roll_bar is None or left.anti_roll_bar.kind != "t":
        return wheels
    travels = [float(loads["wheel_travel"]) for _, _, loads in wheels]
    ends = from_across(left, (travels[0], travels[1]))
    return [
        (
            scene,
            replace(
                pose, points={**pose.points, "arb_arm_end": end.arm_end, "arb_axis": end.stem_end}
            ),
            loads,
        )
        for (scene, pose, loads), end in zip(wheels, ends, strict=True)
        if end.arm_end is not None and end.stem_end is not None
    ]


def _with_third_spring(wheels: list[_Drawn]) -> list[_Drawn]:
    """Return the wheels with the third spring straight between its two ends."""
    name = "third_spring_end"
    if not all(name in pose.points for _, pose, _ in wheels):
        return wheels
    half = 0.5 * (wheels[0][1].points[name] + wheels[1][1].points[name])
    return [
        (scene, replace(pose, points={**pose.points, MIDDLE[name]: half}), loads)
        for scene, pose, loads in wheels
    ]


def _forces(pose: Pose, loads: xr.Dataset) -> list[tuple[str, Array, Array]]:
    """Return colour, point of action (m) and vector (N) of all forces on a wheel."""
    road = np.array(
        [float(loads[f"{name}_force"]) for name in ("longitudinal", "lateral", "vertical")]
    )
    forces = [(_ON_ROAD, pose.contact, road)]
    for name in _BODY:
        if f"{name}.fx" in loads and name in pose.points:
            force = np.array([float(loads[f"{name}.f{axis}"]) for axis in "xyz"])
            forces.append((_ON_BODY, pose.points[name], force))
    return forces


_BODY = (
    *(f"{arm}_arm_{end}" for arm in ("lower", "upper") for end in ("front", "rear")),
    *(f"link_{i}_inner" for i in range(1, 6)),
    *(
        "tie_rod_inner",
        "arm_inner",
        "arm_outer",
        "rocker_pivot",
        "strut_top",
        "spring_top",
        "arb_pivot",
    ),
)
"""Hardpoints at which the suspension acts on the body, or on the rack."""


def _ends(colour: str, place: Array, force: Array, largest: float) -> Array:
    """Return both ends of an arrow, shape (2, 3), m: towards the contact point, or away from a point on the body."""
    reach = force * (_LONGEST / max(largest, _LEAST))
    return np.array([place - reach, place] if colour == _ON_ROAD else [place, place + reach])


def _draw_forces(
    axes: Axes, view: View, forces: list[tuple[str, Array, Array]], largest: float
) -> None:
    for colour, place, force in forces:
        size = float(np.linalg.norm(force))
        if size < _SEEN * largest:
            continue
        start, end = MM * view.flat(_ends(colour, place, force, largest))
        arrow = {"arrowstyle": "-|>", "color": colour, "linewidth": 1.6, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", tuple(end), tuple(start), arrowprops=arrow, zorder=6.0)


def _label_forces(
    axes: Axes, view: View, forces: list[tuple[str, Array, Array]], largest: float
) -> None:
    """Write the magnitudes of forces next to the free ends of their arrows, the largest first, without overlaps."""
    from matplotlib.patheffects import withStroke

    unit = display_unit_for("kN")
    sizes = [
        (float(np.linalg.norm(force)), colour, place, force) for colour, place, force in forces
    ]
    large = sorted(
        (arrow for arrow in sizes if arrow[0] >= _LABELLED * largest), key=lambda arrow: -arrow[0]
    )
    to_points = axes.transData + axes.figure.dpi_scale_trans.inverted()
    arrows = [
        MM * view.flat(_ends(colour, place, force, largest)) for _, colour, place, force in large
    ]
    along = np.linspace(0.0, 1.0, _SAMPLES)[:, None]
    lines = [72.0 * to_points.transform(start + along * (end - start)) for start, end in arrows]
    low, high = 72.0 * to_points.transform(np.transpose([axes.get_xlim(), axes.get_ylim()]))
    low, high = np.minimum(low, high), np.maximum(low, high)
    occupied: list[Array] = []
    for k, (size, colour, _, _) in enumerate(large):
        start, end = arrows[k]
        free, fast = (start, end) if colour == _ON_ROAD else (end, start)
        text = f"{1e-3 * unit.factor * size:.{2 if unit.name == 'kN' else 0}f}"
        room = np.array([_LETTER * len(text), _LINE])
        at = 72.0 * to_points.transform(free)

        def overlaps(offset: Array, at: Array = at, room: Array = room) -> tuple[int, int]:
            """Count overlaps of a number there: with other numbers and the frame, then with points of arrows."""
            corner = at + offset
            met = sum(bool((abs(corner - other) < room).all()) for other in occupied)
            met += bool((corner < low).any() or (corner + room > high).any())
            under = sum(
                int(((line > corner) & (line < corner + room)).all(axis=1).sum()) for line in lines
            )
            return met, under

        offsets = map(np.array, _beside(room, free - fast))
        offset = min(offsets, key=overlaps)  # the first of equals
        occupied.append(at + offset)
        axes.annotate(
            text, tuple(free), tuple(offset), textcoords="offset points", fontsize=7.5, color=colour, zorder=6.5,
            ha="left", va="bottom", path_effects=[withStroke(linewidth=2.0, foreground="white")],
        )  # fmt: skip


_SAMPLES = 60  # points along an arrow that a number should not hide
_LETTER, _LINE = 4.9, 9.5  # points, of a number in 7.5 pt


def _beside(room: Array, away: Array) -> Iterator[tuple[float, float]]:
    """Yield positions of a number around the free end of an arrow, which points ``away``; the nearest ahead first."""
    wide, tall = room
    across = (3.0, -wide - 3.0) if away[0] >= 0.0 else (-wide - 3.0, 3.0)
    for step in range(5):
        up, down = 1.0 + step * tall, -tall - 1.0 - step * tall
        for height in (up, down) if away[1] >= 0.0 else (down, up):
            for side in across:
                yield side, height


def write_loaded(axle_loads: AxleLoads, folder: Path | str, *, force: bool = False) -> list[Path]:
    """Draw all cases of an axle to files in a folder, as :func:`write_load_cases` does."""
    return write_load_cases(axle_loads.rig, axle_loads.data, folder, force=force)


def write_load_cases(
    rig: Corner, loads: xr.Dataset, folder: Path | str, *, force: bool = False
) -> list[Path]:
    """Draw all cases to files in a folder, one PNG each.

    Parameters
    ----------
    rig : Corner
        The corner for which the cases were computed.
    loads : xarray.Dataset
        Result of :func:`jounce.load_cases`.
    folder : Path or str
        Destination, created if missing.
    force : bool
        Overwrite existing files.

    Returns
    -------
    list of Path
        The files, named after the cases.

    Raises
    ------
    OutputError
        For existing files without ``force``.
    DescriptionError
        For two cases whose files would have the same name.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import jounce as jn
    >>> car = jn.LoadedAxle(
    ...     axle="front", mass=280.0, wheelbase=1.55, centre_of_mass_height=0.3, weight_share=0.48, brake_share=0.65
    ... )
    >>> rig = jn.load("formula-student-front")
    >>> found = jn.load_cases(rig, car, {"braking 1.2 g": {"longitudinal": -1.2}})
    >>> [file.name for file in write_load_cases(rig, found, pathlib.Path(tempfile.mkdtemp()) / "cases")]
    ['braking-1.2-g.png']
    """
    names = [str(name) for name in loads["case"].to_numpy()]
    files = {name: re.sub(r"[^\w.]+", "-", name).strip("-.") + ".png" for name in names}
    if len(set(files.values())) < len(names):
        raise DescriptionError(
            "two cases would be written to the same file", where="cases", found=", ".join(names)
        )
    contents: dict[str, bytes | str] = {
        file: render_figure(load_case(rig, loads, name), [".png"])[".png"]
        for name, file in files.items()
    }
    return write_files(folder, contents, force=force)
