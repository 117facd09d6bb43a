"""Pages of recordings, runs and sweeps: extremes, then all curves in a viewer with the mechanism."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import DisplayUnit, display_unit
from jounce.core.errors import JounceError
from jounce.core.findings import Finding
from jounce.core.text import slug
from jounce.core.types import Array
from jounce.plots.comparison import (
    apart,
    common_axis,
    common_channels,
    line_of,
    named_runs,
    through,
)
from jounce.plots.display import number, settle, words_of
from jounce.report.chart import Chart
from jounce.report.live import (
    Curve,
    Motion,
    Pane,
    PosedRig,
    Viewer,
    ViewerScene,
    named_words,
    scene_panels,
)
from jounce.report.page import Block, Details, Page, PageTable, Section, findings_blocks

if TYPE_CHECKING:
    import xarray as xr

    from jounce.parts import Rig
    from jounce.roads import Trial


_ROLES = ("after", "other-5", "other-1", "other-2", "other-3", "other-4", "other-6")
_REACTIONS = tuple(f".{kind}{axis}" for kind in "ft" for axis in "xyz")
_MOST_CHANNELS = 240
"""Maximum number of channels that remains easy to search; a rolling axle has 160."""
_POSES = 25
_MOST_POSES = 2000
"""Maximum number of poses shown individually; in longer runs the mechanism follows its wheel travel."""
_LONG = 10.0
"""Minimum distance (m) that is taken to be a distance along a road."""


def recordings_page(
    runs: Mapping[str, xr.Dataset] | Sequence[xr.Dataset],
    channels: Sequence[str] | None = None,
    *,
    title: str = "",
    subtitle: str = "",
    rig: Rig | None = None,
    trial: Trial | None = None,
    findings: Sequence[Finding] = (),
) -> Page:
    """Create a page of one or several recordings, runs or sweeps.

    Parameters
    ----------
    runs : mapping of str to xarray.Dataset, or sequence of xarray.Dataset
        Data over a common axis: ``time`` (s), or the swept variable; channels in SI units.
    channels : sequence of str, optional
        Channels shown initially; all others can be selected.
    title, subtitle : str
        Heading of the page.
    rig : Rig, optional
        3-D rig animated with the first run.
    trial : Trial, optional
        Trial of that run, which gives its road.
    findings : sequence of Finding
        Findings to show on the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.

    Raises
    ------
    RecordingError
        If there is nothing to show, the axes differ, or a run lacks a requested channel.

    Examples
    --------
    >>> import jounce as jn
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.5 s")
    >>> page = recordings_page({"run": jn.simulate(jn.load("kart-quarter-car"), trial)}, title="A kart")
    >>> [section.title for section in page.sections]
    ['Extremes', 'Curves']
    """
    named = named_runs(runs)
    axis = common_axis(named)
    first = common_channels(named, channels)
    units = {name: _unit(named, name) for name in _channels(named, axis, first)}
    unit = _axis_unit(next(iter(named.values())), axis)
    answer: list[Block] = [_extremes(named, axis, unit, first, units)]
    others = [name for name in units if name not in first]
    if others:
        answer.append(Details("All other channels", (_extremes(named, axis, unit, others, units),)))
    answer += findings_blocks(findings)
    curves = Section(
        "Curves", lambda: curve_blocks({"": named}, first, title=title, rig=rig, trial=trial)
    )
    sections = (Section("Extremes", tuple(answer)), curves)
    return Page(title or ", ".join(named), sections, subtitle)


def curve_blocks(
    groups: Mapping[str, Mapping[str, xr.Dataset]],
    channels: Sequence[str] | None = None,
    *,
    title: str = "",
    name: str = "curves",
    rig: Rig | None = None,
    trial: Trial | None = None,
    window: tuple[float, float] | None = None,
    figures: Sequence[Block] = (),
) -> tuple[Block, ...]:
    """Show runs in a viewer, with one scene per group, and as figures.

    Parameters
    ----------
    groups : mapping of str to mapping of str to xarray.Dataset
        Runs by name, grouped by a label (empty for a single group), over a common axis; channels in SI units.
    channels : sequence of str, optional
        Channels shown initially; all others can be selected, up to the limit of a page.
    title, name : str
        Title of the viewer, and base name of the figure files.
    rig, trial : Rig and Trial, optional
        3-D rig animated with the first run of each group, and the trial that gives its road.
    window : (float, float), optional
        Part of the axis shown initially, in SI units.
    figures : sequence of Block
        Static equivalent of the viewer; by default figures of the channels shown initially.

    Returns
    -------
    tuple of Block
        The viewer, and the figures in a collapsed section.
    """
    viewer = curve_viewer(
        groups, channels, title=title, name=name, rig=rig, trial=trial, window=window
    )
    if not figures:
        figures = [
            Chart(
                scene_panels(scene, viewer.words, viewer.unit),
                name if len(viewer.scenes) == 1 else f"{name}-{scene.name}",
                f"{scene.label[:1].upper()}{scene.label[1:]}: {_shown_panes(scene)}.",
                f"{_shown_panes(scene)} against {viewer.words}.",
                1,
            )
            for scene in viewer.scenes
        ]
    many = "figure" if len(figures) == 1 else "figures"
    return viewer, Details(
        f"The same as {'a ' * (many == 'figure')}{many}", tuple(figures), is_still=True
    )


def curve_viewer(
    groups: Mapping[str, Mapping[str, xr.Dataset]],
    channels: Sequence[str] | None = None,
    *,
    title: str = "",
    name: str = "curves",
    rig: Rig | None = None,
    trial: Trial | None = None,
    window: tuple[float, float] | None = None,
    numbers: Collection[str] | None = None,
) -> Viewer:
    """Show runs in a viewer, as :func:`curve_blocks` does, without the figures.

    With ``numbers``, only these panes and those shown initially contain curves. The others have only their names, for
    a page that can request their data later.
    """
    runs = list(dict.fromkeys(label for named in groups.values() for label in named))
    roles = {label: _ROLES[k % len(_ROLES)] for k, label in enumerate(runs)}
    scenes, words, unit, left_out = [], "", "", 0
    for label, named in groups.items():
        axis = common_axis(named)
        first = common_channels(named, channels)
        every = _channels(named, axis, first)
        chosen = every[: min(max(len(first), _most_channels(named, axis)), _MOST_CHANNELS)]
        left_out = max(left_out, len(every) - len(chosen))
        along = _axis_unit(next(iter(named.values())), axis)
        units = {channel: _unit(named, channel) for channel in chosen}
        motion = _motion(next(iter(named.values())), axis, rig, trial)
        scene = _scene(named, axis, along, chosen, first, units, motion, roles, numbers)
        part = None if window is None else (window[0] * along.factor, window[1] * along.factor)
        scenes.append(
            replace(scene, name=slug(label) if label else name, label=label or name, window=part)
        )
        words, unit = axis.replace("_", " "), along.name
    shown = tuple((role, label, True) for label, role in roles.items())
    caption = (
        f"{left_out} more channels do not fit into a page; the recording holds them."
        if left_out
        else ""
    )
    return Viewer(title, tuple(scenes), shown, caption, words, unit)


def _shown_panes(scene: ViewerScene) -> str:
    return ", ".join(pane.name for pane in scene.panes if pane.shown)


_MOST_NUMBERS = 1_200_000
"""Maximum number of samples of all curves in a scene: about 2 MB of a page."""
_LEAST_SAMPLES = 2000
"""Number of samples per curve that preserve the peaks of a long record; all curves share these instants."""


def _most_channels(named: Mapping[str, xr.Dataset], axis: str) -> int:
    """Return the number of channels of these runs that fit on a page, differences included."""
    samples = max(data.sizes[axis] for data in named.values())
    thinned = math.isqrt(
        _MOST_NUMBERS // _LEAST_SAMPLES
    )  # in long records each curve contributes this many instants to all others
    return max(_MOST_NUMBERS // samples, thinned) // (2 * len(named) - 1)


DIFFERENCE = "Δ "


def _channels(named: Mapping[str, xr.Dataset], axis: str, first: Sequence[str]) -> list[str]:
    """Return the channels of all runs, initially shown ones first; joint forces are excluded."""
    channels = dict.fromkeys(first)
    for data in named.values():
        for name in data.data_vars:
            values = data.variables[
                name
            ]  # by dimensions: creating a data array for each variable takes as long as a sweep
            is_curve = (
                values.dims == (axis,)
                and values.dtype.kind in "fiu"
                and not str(name).endswith(_REACTIONS)
            )
            if is_curve and not _is_place(str(name), data):
                channels.setdefault(str(name))
    return list(channels)


def _is_place(name: str, data: xr.Dataset) -> bool:
    """Whether a channel is a coordinate of a hardpoint."""
    point = name.rpartition(".")[0]
    return bool(point) and all(f"{point}.{letter}" in data for letter in "xyz")


def _axis_unit(data: xr.Dataset, axis: str) -> DisplayUnit:
    if axis == "time":
        return DisplayUnit("s", 1.0)
    largest = float(np.nanmax(np.abs(data[axis].to_numpy()), initial=0.0))
    unit = display_unit(str(data[axis].attrs.get("units", "1")), largest)
    return DisplayUnit("m", 1.0) if unit.name == "mm" and largest > _LONG else unit


def _unit(named: Mapping[str, xr.Dataset], name: str) -> DisplayUnit:
    held = [data.variables[name] for data in named.values() if name in data]
    largest = max(
        float(np.nanmax(np.abs(np.asarray(values.values, float)), initial=0.0)) for values in held
    )
    return display_unit(
        str(held[0].attrs.get("units", "1")), largest if np.isfinite(largest) else 0.0
    )


def _scene(
    named: Mapping[str, xr.Dataset],
    axis: str,
    unit: DisplayUnit,
    every: Sequence[str],
    first: Sequence[str],
    units: Mapping[str, DisplayUnit],
    motion: Any,
    roles: Mapping[str, str],
    numbers: Collection[str] | None,
) -> ViewerScene:
    """Return all curves on the union of their axes, interpolated linearly between samples."""
    lengths = [data.variables[axis].to_numpy().astype(float) for data in named.values()]
    x = np.unique(np.concatenate(lengths))
    panes, differences = [], []

    def is_held(name: str) -> bool:
        return numbers is None or name in first or name in numbers

    for name in every:
        curves, gaps, reference = [], [], None
        holders = [
            label
            for label, data in named.items()
            if name in data and data.variables[name].dims == (axis,)
        ]
        is_apart = is_held(f"{DIFFERENCE}{name}")
        for label in holders if is_apart or is_held(name) else ():
            data, role = named[label], roles[label]
            line = line_of(data, name, axis)
            read = line[1] if len(line[0]) == len(x) else through(line, x)
            if is_held(name):
                si = str(data.variables[name].attrs.get("units", "1"))
                curves.append(Curve(label, role, settle(read, si) * units[name].factor))
            if reference is None:
                reference = read
            elif is_apart:
                gaps.append(Curve(label, role, apart(read, reference) * units[name].factor))
        words = str(
            next(
                data.variables[name].attrs.get("long_name", "")
                for data in named.values()
                if name in data
            )
        )
        panes.append(
            Pane(
                name,
                named_words(name, words or words_of(name)),
                units[name].name,
                tuple(curves),
                name in first,
            )
        )
        if len(holders) > 1:
            words = f"{DIFFERENCE}{name}, difference from {next(iter(named))}"
            differences.append(
                Pane(f"{DIFFERENCE}{name}", words, units[name].name, tuple(gaps), shown=False)
            )
    made = motion(x) if motion is not None else None
    return ViewerScene("curves", "curves", x * unit.factor, (*panes, *differences), motion=made)


def _motion(data: xr.Dataset, axis: str, rig: Rig | None, trial: Trial | None) -> Any:
    """Return the motion of the mechanism over the common axis if the rig is a 3-D corner."""
    from jounce.parts import Corner

    if not isinstance(rig, Corner):
        return None
    try:
        if "wheel_centre.z" in data and data.sizes[axis] <= _MOST_POSES:
            return _motion_at_poses(data, axis, rig, trial)
        if axis == "wheel_travel" or (
            axis == "time" and {"sprung.z", "unsprung.z"} <= set(map(str, data.data_vars))
        ):
            return _moving(data, axis, rig, trial)
    except JounceError:  # the curves are still shown
        pass
    return None


def _motion_at_poses(data: xr.Dataset, axis: str, rig: Any, trial: Trial | None) -> Any:
    """Return every recorded pose: the recording contains the hardpoint positions."""
    from jounce.plots.mechanisms.scene import poses_of, scene_of

    drawing = scene_of(rig)
    poses = poses_of(rig, drawing, data)
    poses = poses.subset(
        np.unique(poses.over, return_index=True)[1]
    )  # ascending, without duplicates
    mechanism, over = PosedRig(drawing, poses, axis == "time"), poses.over

    def motion(x: Array) -> Motion:
        ground, load = (
            np.interp(x, over, values) for values in (poses.ground, poses.touches.astype(float))
        )
        return Motion(
            mechanism, np.zeros_like(x), x, ground, load, *_passing_road(trial, x, drawing, axis)
        )

    return motion


def _passing_road(trial: Trial | None, x: Array, drawing: Any, axis: str) -> tuple[Any, float]:
    """Return the road that passes under the wheel and its speed; none for a plate."""
    from jounce.plots.mechanisms.scene import roadway_of

    if axis != "time" or trial is None or trial.road is None or trial.speed is None:
        return None, 0.0
    return roadway_of(trial, x, drawing.undeformed_radius), float(trial.speed)


def _moving(data: xr.Dataset, axis: str, rig: Any, trial: Trial | None) -> Any:
    """Return the mechanism over its travel, attached to its body."""
    from jounce.kinematics import sweep_travel
    from jounce.plots.mechanisms.scene import poses_of, scene_of

    drawing = scene_of(rig)
    if axis == "time":
        travel = (data["unsprung.z"] - data["sprung.z"]).to_numpy()
    else:
        travel = data[axis].to_numpy()
    low, high = min(float(np.nanmin(travel)), -1e-3), max(float(np.nanmax(travel)), 1e-3)
    poses = poses_of(rig, drawing, sweep_travel(rig, np.linspace(low, high, _POSES), points=True))
    mechanism = PosedRig(drawing, poses, axis == "time")

    def motion(x: Array) -> Motion:
        def read(name: str, default: float) -> Array:
            return (
                np.nan_to_num(through(line_of(data, name, axis), x))
                if name in data
                else np.full(len(x), default)
            )

        if axis == "wheel_travel":  # a plate moves the wheel
            order = np.argsort(poses.over)
            ground = np.interp(x, poses.over[order], poses.contact[order, 2])
            return Motion(mechanism, np.zeros_like(x), x, ground, np.ones_like(x))
        body = read("sprung.z", 0.0)
        moved = read("unsprung.z", 0.0) - body
        road, speed = _passing_road(trial, x, drawing, axis)
        return Motion(
            mechanism, body, moved, read("road.z", 0.0), read("tyre.force", 1.0), road, speed
        )

    return motion


def _extremes(
    named: Mapping[str, xr.Dataset],
    axis: str,
    unit: DisplayUnit,
    names: Sequence[str],
    units: Mapping[str, DisplayUnit],
) -> PageTable:
    """Return minimum and maximum of each channel and run, and the largest difference from the first run."""
    several = len(named) > 1
    rows = []
    for name in names:
        reference = None
        for label, data in named.items():
            if name not in data or data.variables[name].dims != (axis,):
                continue
            x, y = line_of(data, name, axis)
            y = settle(y, str(data[name].attrs.get("units", "1")))
            cells = [name if reference is None else "", *((label,) if several else ())]
            known = np.isfinite(y)
            if not known.any():
                rows.append(
                    (*cells, units[name].name or "–", *("–" for _ in range(4 + 2 * several)))
                )
                continue
            for at in (
                int(np.nanargmin(np.where(known, y, np.nan))),
                int(np.nanargmax(np.where(known, y, np.nan))),
            ):
                cells += [number(y[at] * units[name].factor), number(x[at] * unit.factor)]
            if several:
                cells += _furthest(reference, (x, y), units[name], unit)
            cells.insert(2 if several else 1, units[name].name or "–")
            rows.append(tuple(cells))
            reference = reference or (x, y)
    place = f"at [{unit.name or '–'}]"
    header = ["channel", *(["run"] if several else []), "unit", "minimum", place, "maximum", place]
    header += ["largest difference", place] if several else []
    align = "l" + "l" * several + "l" + "r" * (4 + 2 * several)
    note = f"Differences are from {next(iter(named))}, where both are known." if several else ""
    return PageTable(
        f"Extremes over {axis.replace('_', ' ')}", tuple(header), tuple(rows), align, note
    )


def _furthest(
    reference: tuple[Array, Array] | None,
    line: tuple[Array, Array],
    unit: DisplayUnit,
    along: DisplayUnit,
) -> list[str]:
    if reference is None:
        return ["–", "–"]
    difference = apart(line[1], through(reference, line[0]))
    if not np.isfinite(difference).any():
        return ["–", "–"]
    at = int(np.nanargmax(np.abs(difference)))
    return [number(difference[at] * unit.factor), number(line[0][at] * along.factor)]
