"""The walk from pose to pose (see ``kernel.poses``)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from jounce.kernel.arrays import Block, Integers, Matrix
from jounce.kernel.loops.compiling import call_many, call_native, part
from jounce.kernel.poses import END_OF_TRAVEL, NOT_TRIED, REACHED, Found, Walk, Work

_STEPS = 8
_CLOSED = 1e-8  # violation that one step brings down to rounding
_NEAR = 1e-7  # change (m, rad) that one more step brings down to rounding
_ROUNDING = 1e-15
_STRAY = 0.1  # correction allowed, as a share of the way predicted
_BENT = 0.15  # share by which a coordinate's way may differ from that of its mean slope
_SMALL = 0.02  # share of the largest coordinate's way that is small
_SHORTEST = 1e-7  # way (m) below which the end of travel is reached
_GROWTH = 2.0


@part()
def _correct(walk: Any, work: Any, size: int) -> bool:
    """Project the pose in row 0 onto the constraints for the given inputs; return success."""
    last = np.inf
    for _ in range(_STEPS):
        call_native(walk.pose, work.rows, 0, work.u, walk.p, work.m, work.out, 0)
        violation = work.out[0, size]
        # A residual that grows has left the basin of this pose. Newton's method would land somewhere, and where is
        # chance.
        if not violation < np.inf or (violation > 2.0 * last and violation > _CLOSED):
            return False
        change = 0.0
        for d in range(size):
            change = max(change, abs(work.out[0, d] - work.rows[0, d]))
            work.rows[0, d] = work.out[0, d]
        if violation < _CLOSED and (change < _NEAR or violation < _ROUNDING):
            return True
        last = violation
    return False


@part()
def _belongs(walk: Any, work: Any, i: int, step: float, length: float) -> bool:
    """Return whether the corrected pose in row 0 continues that in row 1, for a fraction of a path of that length."""
    # A pose that closes the loops may still be one of another branch. Two signs tell: it is not where the prediction
    # was, or a coordinate has not gone the mean of its slopes at both ends, which a smooth way of that length must.
    size, tracks, j = len(walk.start), walk.targets.shape[1], walk.before[i]
    off, way, slack = 0.0, 0.0, 1e-9 + 1e-6 * step * length
    for d in range(size):
        off = max(off, abs(work.rows[0, d] - work.rows[2, d]))
        way = max(way, abs(work.rows[2, d] - work.rows[1, d]))
    if off > _STRAY * way + slack:
        return False
    for d in range(size):
        ahead = 0.0
        for t in range(tracks):
            origin = walk.targets[j, t] if j >= 0 else walk.origin[t]
            ahead += (walk.targets[i, t] - origin) * work.out[0, size + 1 + t * size + d]
        gone, mean = work.rows[0, d] - work.rows[1, d], 0.5 * step * (ahead + work.rows[3, d])
        if (
            abs(gone - mean)
            > _BENT * step * max(abs(ahead), abs(work.rows[3, d])) + _SMALL * way + slack
        ):
            return False
    return True


@part()
def _curved(
    walk: Any, found: Any, i: int, j: int, d: int, slope: float, size: int
) -> tuple[float, float]:
    """Return the second and third coefficients of the cubic through the poses up to j, along the path to i."""
    g = walk.before[j]
    ahead, back, across = 0.0, 0.0, 0.0
    for t in range(walk.targets.shape[1]):
        way = walk.targets[i, t] - walk.targets[j, t]
        came = walk.targets[j, t] - (walk.targets[g, t] if g >= 0 else walk.origin[t])
        ahead += way * way
        back += came * came
        across += way * came
    # The cubic holds on a straight line only: a sweep that turns (bump, then steer) is predicted by the slopes alone.
    if g < 0 or ahead == 0.0 or back == 0.0 or across < 0.999999 * math.sqrt(ahead * back):
        return 0.0, 0.0
    r = math.sqrt(back / ahead)
    earlier = 0.0
    for t in range(walk.targets.shape[1]):
        earlier += (walk.targets[i, t] - walk.targets[j, t]) * found.slopes[t * size + d, g]
    a = (found.poses[d, g] - found.poses[d, j] + slope * r) / (r * r)
    b = (slope - earlier) / r
    third = (2.0 * a - b) / r
    return a + third * r, third


@part()
def _go(walk: Any, found: Any, work: Any, i: int) -> float:
    """Move from the previous target to target ``i``; return the fraction of the path that was reached."""
    size, tracks, j = len(walk.start), walk.targets.shape[1], walk.before[i]
    length = 0.0
    for t in range(tracks):
        origin = walk.targets[j, t] if j >= 0 else walk.origin[t]
        length += (walk.targets[i, t] - origin) ** 2
    length = math.sqrt(length)
    for d in range(size):
        work.rows[1, d] = found.poses[d, j] if j >= 0 else walk.start[d]
    if j < 0:
        _slopes_at(walk, work, size, 0.0, i)
    # The whole way is tried first, since from target to target it is mostly short; halved where it fails, doubled where
    # it goes on. Slopes at the pose walked from are those stored with it, and after the first part those just computed.
    done, step, first = 0.0, 1.0, True
    while done < 1.0:
        step = min(step, 1.0 - done)
        for d in range(size):
            slope, second, third = 0.0, 0.0, 0.0
            for t in range(tracks):
                origin = walk.targets[j, t] if j >= 0 else walk.origin[t]
                along = (
                    found.slopes[t * size + d, j]
                    if j >= 0 and first
                    else work.out[0, size + 1 + t * size + d]
                )
                slope += (walk.targets[i, t] - origin) * along
            if first and j >= 0:
                second, third = _curved(walk, found, i, j, d, slope, size)
            work.rows[0, d] = work.rows[1, d] + step * (slope + step * (second + step * third))
            work.rows[2, d] = work.rows[0, d]
            work.rows[3, d] = slope
        _drive(walk, work, i, done + step)
        if _correct(walk, work, size) and _belongs(walk, work, i, step, length):
            for d in range(size):
                work.rows[1, d] = work.rows[0, d]
            done = 1.0 if 1.0 - done - step < 1e-12 else done + step
            step, first = step * _GROWTH, False
        else:
            step *= 0.5
            # The try has overwritten the slopes with its own.
            if not first or j < 0:
                _slopes_at(walk, work, size, done, i)
            if length * step < _SHORTEST:
                return done
    return 1.0


@part()
def _drive(walk: Any, work: Any, i: int, share: float) -> None:
    """Set the inputs at a fraction of the path to target ``i``."""
    j = walk.before[i]
    for t in range(walk.targets.shape[1]):
        origin = walk.targets[j, t] if j >= 0 else walk.origin[t]
        work.u[t] = (
            walk.targets[i, t] if share >= 1.0 else origin + share * (walk.targets[i, t] - origin)
        )


@part()
def _slopes_at(walk: Any, work: Any, size: int, share: float, i: int) -> None:
    """Write the slopes of the coordinates at the pose in row 1 into ``out``."""
    _drive(walk, work, i, share)
    for d in range(size):
        work.rows[0, d] = work.rows[1, d]
    call_native(walk.pose, work.rows, 0, work.u, walk.p, work.m, work.out, 0)


@part()
def walk_poses(walk: Walk, found: Found, work: Work) -> None:
    """Compute all target poses and their outputs."""
    _find(walk, found, work)


@part()
def _find(walk: Any, found: Any, work: Any) -> None:
    size, tracks, count = len(walk.start), walk.targets.shape[1], walk.targets.shape[0]
    for i in range(count):
        j = walk.before[i]
        found.outcome[i], found.share[i] = NOT_TRIED, 0.0
        if j >= 0 and found.outcome[j] != REACHED:
            continue
        found.share[i] = _go(walk, found, work, i)
        found.outcome[i] = REACHED if found.share[i] >= 1.0 else END_OF_TRAVEL
        if found.outcome[i] != REACHED:
            continue
        for d in range(size):
            found.poses[d, i] = work.rows[1, d]
            for t in range(tracks):
                found.slopes[t * size + d, i] = work.out[0, size + 1 + t * size + d]
        for t in range(tracks):
            found.inputs[t, i] = walk.targets[i, t]
    call_many(walk.output, found.poses, found.inputs, walk.p, work.m, found.outputs, 0, count)


@part()
def walk_variants(
    walk: Walk,
    variants: Matrix,
    found: Found,
    work: Work,
    place: Integers,
    chosen: Integers,
    out: Block,
) -> None:
    """Compute all target poses and the chosen outputs for each row of parameter values."""
    for k in range(variants.shape[0]):
        for c in range(variants.shape[1]):
            walk.p[c] = variants[k, c]
        _find(walk, found, work)
        for o in range(len(chosen)):
            for i in range(len(place)):
                out[o, k, place[i]] = (
                    found.outputs[chosen[o], i] if found.outcome[i] == REACHED else np.nan
                )
