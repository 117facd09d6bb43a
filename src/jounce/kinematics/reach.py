"""What stopped a sweep: where the mechanism's travel ends, and which joints hold it there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.kernel.poses import END_OF_TRAVEL, Found, Walk, space_for, walk_poses
from jounce.kinematics.grids import Grid
from jounce.kinematics.model import KinematicModel

_TOLD = 4  # ends that are told one by one
_JUST_BEFORE = 0.999  # share of the last way: where the joints are asked
_HOLDS = 0.25  # share of the largest constraint force from which a joint is named


@dataclass(frozen=True)
class End:
    """An end of travel.

    Attributes
    ----------
    travel, rack : float
        Last pose that can be reached, m.
    wanted_travel, wanted_rack : float
        Pose that was asked for, m.
    joints : tuple of str
        Joints whose forces grow without bounds there.
    """

    travel: float
    rack: float
    wanted_travel: float
    wanted_rack: float
    joints: tuple[str, ...]

    def __str__(self) -> str:
        at = f"at wheel travel {1e3 * self.travel:.4g} mm"
        wanted = f"{1e3 * self.wanted_travel:.4g} mm"
        if self.rack or self.wanted_rack:
            at += f", rack travel {1e3 * self.rack:.4g} mm"
            wanted += f", {1e3 * self.wanted_rack:.4g} mm"
        held = (
            f"; {' and '.join(self.joints)} {'are' if len(self.joints) > 1 else 'is'} stretched" if self.joints else ""
        )
        return f"the mechanism reaches the end of its travel {at}, on the way to {wanted}{held}"


def told(ends: Sequence[End]) -> str:
    """Say where a sweep had to stop; of many ends the first."""
    more = f"; and {len(ends) - _TOLD} more ends of travel" if len(ends) > _TOLD else ""
    return "; ".join(map(str, ends[:_TOLD])) + more


def no_pose(ends: Sequence[End]) -> SimulationError:
    """Build the error for a sweep without any pose."""
    why = f": {ends[0]}" if ends else ""
    return SimulationError(f"no pose of the sweep can be reached{why}", hint="Sweep a smaller range.")


def ends_of_travel(model: KinematicModel, walk: Walk, layout: Grid, found: Found) -> list[End]:
    """Give the places where a walk had to stop, the first of them with the joints that hold it."""
    ends: list[End] = []
    for i in np.flatnonzero(found.outcome == END_OF_TRAVEL):
        j = int(layout.before[i])
        start = layout.targets[j] if j >= 0 else np.zeros(2)
        last = start + found.share[i] * (layout.targets[i] - start)
        first = len(ends) < _TOLD
        joints = _holding(model, walk, found, int(i), start + _JUST_BEFORE * (last - start)) if first else ()
        wanted = layout.targets[i]
        ends.append(End(float(last[0]), float(last[1]), float(wanted[0]), float(wanted[1]), joints))
    return ends


def _holding(model: KinematicModel, walk: Walk, found: Found, i: int, last: Array) -> tuple[str, ...]:
    """Joints that take the largest forces just before the end of travel."""
    j = int(walk.before[i])
    tracks = walk.targets.shape[1]
    near = _to_target(walk, found, j, last[:tracks])
    again, work = space_for(near, len(model.rows))
    walk_poses(near, again, work)
    pose, at = again.poses[:, 0], near.targets[0]
    if not np.all(np.isfinite(pose)):
        pose, at = near.start, near.origin
    matrix = model.functions["gradient"](pose, at, walk.p, 0.0).full()
    shares = np.abs(np.linalg.svd(matrix)[0][:, -1])
    names: dict[str, float] = {}
    for name, share in zip(model.constraints, shares * np.linalg.norm(matrix, axis=1), strict=True):
        joint = name.partition(".")[0]
        if joint != "wheel_travel":
            names[joint] = max(names.get(joint, 0.0), float(share))
    largest = max(names.values(), default=0.0)
    return tuple(name for name, share in names.items() if share >= _HOLDS * largest > 0.0)


def _to_target(walk: Walk, found: Found, j: int, target: Array) -> Walk:
    """Give the walk from target ``j`` of another one to a target of its own."""
    start, origin = (found.poses[:, j], walk.targets[j]) if j >= 0 else (walk.start, walk.origin)
    return walk._replace(
        start=np.ascontiguousarray(start),
        origin=np.ascontiguousarray(origin),
        targets=np.array([target]),
        before=np.array([-1], dtype=np.int64),
    )
