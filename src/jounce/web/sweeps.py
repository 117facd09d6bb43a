"""Sweeps of a corner or axle for the page: over travel, rack or roll, beside other versions, targets and centres."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from jounce.core.commands import command_line
from jounce.core.errors import DescriptionError
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.operations.index import operations
from jounce.operations.request import Request
from jounce.parts import DependentAxle
from jounce.web.answers import (
    Changes,
    CurvesAnswer,
    cached_run,
    differences_of,
    digest_of,
    key_of,
    variants,
    word,
)
from jounce.web.project import Project

if TYPE_CHECKING:
    import xarray as xr

    from jounce.design.kinematic_targets import Wanted
    from jounce.parts import Rig
    from jounce.report.live import Pane, Viewer

Over = Literal["travel", "rack", "roll"]
_MOST = 400  # maximum poses of an interactive sweep


@dataclass(frozen=True)
class Question:
    """A sweep of ``rig`` over travel, rack or roll: a range for one of them, single values for the others.

    ``text`` is the rig's unsaved text, ``against`` are rigs for comparison; ``targets`` have the keys of a study,
    ``study`` is a study file.
    """

    rig: str
    changes: Changes
    travel: str
    over: Over = "travel"
    rack: str = ""
    roll: str = ""
    text: str | None = None
    against: Sequence[str] = ()
    channels: Sequence[str] = ()
    targets: Sequence[Mapping[str, Any]] = field(default=())
    study: str = ""


def swept(project: Project, asked: Question) -> CurvesAnswer:
    """Sweep a corner or axle as changed, as saved, and a rig for comparison; return curves and equivalent code."""
    from jounce.kinematics.sweeps import sweep_values
    from jounce.report.recordings import curve_viewer

    count = len(
        sweep_values(getattr(asked, asked.over), asked.over, "rad" if asked.over == "roll" else "m")
    )
    if count > _MOST:
        raise DescriptionError(
            "too many poses for an interactive sweep",
            where=asked.over,
            found=count,
            allowed=f"{_MOST}",
        )
    rigs = variants(project, asked.rig, asked.changes, asked.text, asked.against)
    way = f"{asked.over} {asked.travel} {asked.rack} {asked.roll}"
    runs = {
        label: cached_run(f"{way} {key_of(rig)}", partial(_run, rig, asked))
        for label, rig in rigs.items()
    }
    first = next(iter(rigs.values()))
    viewer = curve_viewer({"": runs}, list(asked.channels) or None, rig=first)
    if isinstance(first, DependentAxle):
        viewer = _with_axle(viewer, first, next(iter(runs.values())))
    findings = next(iter(runs.values())).attrs.get("findings", "")
    wanted = [*_study_targets(project, asked.study), *asked.targets]
    more = {
        "digest": digest_of(rigs["as it is"]),
        "centres": _centres(next(iter(runs.values())), viewer),
        "differences": differences_of(rigs),
        "targets": _bands(first, wanted, asked.over, viewer),
        "notes": [
            *(
                _note(label, run)
                for label, run in runs.items()
                if run.attrs.get("status") != "completed"
            ),
            *([findings] if isinstance(first, DependentAxle) and findings else []),
        ],
    }
    return CurvesAnswer(viewer, more | _ways(asked))


def _with_axle(viewer: Viewer, rig: DependentAxle, run: xr.Dataset) -> Viewer:
    """Return a viewer that also shows both sides of a dependent axle in the poses of its sweep."""
    from jounce.kinematics.dependent_poses import SweptAxle
    from jounce.plots.mechanisms.axle import sides_of
    from jounce.report.live import Motion, PosedRig

    along = run.variables[next(iter(run.dims))]
    order = np.argsort(along.values)
    over = along.values[order]
    axle = SweptAxle(rig)
    left, right = (run[f"{side}.wheel_travel"].values[order] for side in ("left", "right"))
    places = axle.at(left, right).poses
    words, unit = str(along.attrs["long_name"]), str(along.attrs["units"])
    posed: PosedRig | None = None
    for drawing, poses in reversed(sides_of(axle.built, places, over, words, unit)):
        posed = PosedRig(drawing, poses, rolls=False, other=posed)
    assert posed is not None
    scene = viewer.scenes[0]
    x = scene.x * to_si(f"1 {viewer.unit}", unit)
    ground = np.interp(x, over, posed.poses.ground)
    motion = Motion(posed, np.zeros_like(x), x, ground, np.ones_like(x))
    return replace(viewer, scenes=(replace(scene, motion=motion), *viewer.scenes[1:]))


def _run(rig: Rig, asked: Question) -> xr.Dataset:
    import jounce as jn

    if isinstance(rig, DependentAxle):
        if asked.over == "rack":
            return jn.sweep_rack(rig, asked.rack)  # refused
        rolled = asked.over == "roll"
        sweep = jn.sweep_roll(rig, asked.roll) if rolled else jn.sweep_travel(rig, asked.travel)
        return _axle_first(sweep)
    if asked.over == "rack":
        return jn.sweep_rack(rig, asked.rack, asked.travel or 0.0, points=True)
    if asked.over == "roll":
        return _sweep_roll(rig, asked.roll, asked.rack or 0.0)
    return jn.sweep_travel(
        rig,
        asked.travel,
        to_si(asked.rack, "m", where="rack travel") if asked.rack else None,
        points=True,
    )


def _sweep_roll(rig: Rig, roll: str, rack: float | str) -> xr.Dataset:
    """Return the sweep of a rolling axle, with positions of the left wheel's points relative to the body."""
    import jounce as jn

    axle = jn.sweep_roll(rig, roll, rack)
    side = "right" if getattr(rig, "side", "left") == "right" else "left"
    travel = axle[f"{side}.wheel_travel"].to_numpy()
    own = jn.sweep_path(rig, travel, to_si(rack, "m", where="rack travel"), points=True)
    placed = {
        str(name): ("roll_angle", own[name].to_numpy(), own[name].attrs)
        for name in own.data_vars
        if "." in str(name)  # quantities of the axle
    }
    return _axle_first(axle).assign(placed)


def _axle_first(run: xr.Dataset) -> xr.Dataset:
    """Put quantities of the whole axle before those of its wheels."""
    names: list[str] = sorted(map(str, run.data_vars), key=lambda name: "." in name)
    return run[names]


def _note(label: str, run: xr.Dataset) -> str:
    return f"{label}: {run.attrs.get('stopped', run.attrs.get('status', ''))}"


def _centres(run: xr.Dataset, viewer: Viewer) -> dict[str, Any] | None:
    """Return instant centres per pose, mm: (y, z) in front view, (x, z) in side view, and heights (z)."""
    motion = viewer.scenes[0].motion
    names = (
        "instant_centre_y",
        "instant_centre_z",
        "side_instant_centre_x",
        "side_instant_centre_z",
    )
    if motion is None or not all(name in run.variables for name in (*names, "roll_centre_height")):
        return None
    poses = motion.mechanism.poses
    along = run.variables[next(iter(run.dims))].to_numpy()
    index = np.searchsorted(along, poses.over)
    rows = {name: run.variables[name].to_numpy()[index] for name in (*names, "roll_centre_height")}
    roll = poses.contact[:, 2] + rows["roll_centre_height"]
    return {
        "front": _pairs(rows["instant_centre_y"], rows["instant_centre_z"]),
        "side": _pairs(rows["side_instant_centre_x"], rows["side_instant_centre_z"]),
        "roll": _pairs(np.zeros_like(roll), roll),
    }


def _pairs(first: Array, other: Array) -> list[list[float] | None]:
    """Return positions in mm; ``None`` for parallel arms."""
    pairs = 1e3 * np.stack([first, other], axis=1)
    return [np.round(pair, 2).tolist() if np.isfinite(pair).all() else None for pair in pairs]


def _study_targets(project: Project, study: str) -> list[Mapping[str, Any]]:
    """Return the targets of a study file of the project."""
    if not study:
        return []
    from jounce.core.description import read_description
    from jounce.core.files import only_below
    from jounce.design.kinematic_study import SCHEMA, KinematicStudy

    with only_below(project.root):
        description, _ = read_description(KinematicStudy, project.inside(study), SCHEMA)
    return [
        target.model_dump(exclude_none=True) for target in description.target if target.rig is None
    ]


def _bands(
    rig: Rig, targets: Sequence[Mapping[str, Any]], over: Over, viewer: Viewer
) -> list[dict[str, Any]]:
    """Return the targets along the axis of the sweep, in the units of their panes; those of K&C tests have none."""
    targets = [target for target in targets if not target.get("test")]
    if not targets:
        return []
    from jounce.design.kinematic_study import KinematicTarget
    from jounce.design.kinematic_targets import read_targets
    from jounce.kinematics.model import check_corner

    wanted = read_targets(
        {"": check_corner(rig)}, [KinematicTarget(**target) for target in targets], {}
    )
    panes = {pane.name: pane for pane in viewer.scenes[0].panes}
    bands = []
    for target in wanted:
        pane = panes.get(target.quantity)
        if target.along == over and pane is not None and not target.text.slope:
            bands.append(_band(target, pane, viewer.unit))
    return bands


def _band(target: Wanted, pane: Pane, along: str) -> dict[str, Any]:
    unit = 1.0 if pane.unit in ("", target.unit) else to_si(f"1 {pane.unit}", target.unit)
    axis = 1.0 if not along else to_si(f"1 {along}", "rad" if target.along == "roll" else "m")
    low, high = (
        (end + by * target.tolerance) / unit for end, by in ((target.low, -1.0), (target.high, 1.0))
    )
    return {
        "quantity": target.quantity,
        "at": (target.at / axis).tolist(),
        "low": [float(value) if np.isfinite(value) else None for value in low],
        "high": [float(value) if np.isfinite(value) else None for value in high],
    }


def _ways(asked: Question) -> dict[str, Any]:
    over = {"travel": ("travel", "rack"), "rack": ("rack", "travel"), "roll": ("roll", "rack")}[
        asked.over
    ]
    coordinates = {name: value for name in over if (value := getattr(asked, name))}
    request = Request(
        operations()["kinematics"], {"rig": word(asked.rig), "set": asked.changes, **coordinates}
    )
    python = f"import jounce as jn\n\ncurves = {request.expression()}.data\n"
    command = command_line(["jounce", *request.words(), "--out", "curves.csv"])
    return {"python": python, "command": command, "files": {}}
