"""Poses of a driven mechanism along prescribed motions: each target is reached from the one it continues.

A target's start is extrapolated from the poses before it and corrected by Newton steps until the violation is at
rounding. Where the correction is not small against the way, or a coordinate has not gone as far as its slopes at both
ends say, the way is halved, so that the walk stays on its branch; where it cannot be shortened any more, the mechanism
has reached the end of its travel.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from jounce.kernel.arrays import Block, Integers, Matrix, Vector
from jounce.kernel.call import Loop

_walk, _walk_variants = Loop("poses"), Loop("pose_variants")

REACHED, END_OF_TRAVEL, NOT_TRIED = range(3)


class Walk(NamedTuple):
    """Input of a walk: addresses, targets and the pose from which each continues.

    ``pose`` is the address of ``f(q, u, p, m, out)`` with out = (q after a Newton step, violation before it, for each
    track the coordinates' slope). ``targets`` holds one row of track values a target; ``before[i]`` is the target that
    ``i`` continues from, -1 for the design pose ``start``, which has the track values ``origin``.
    """

    pose: int
    output: int
    p: Vector
    start: Vector
    origin: Vector
    targets: Matrix
    before: Integers


class Found(NamedTuple):
    """Output of a walk: one column per target, so that all outputs are computed at once.

    ``outcome`` is one of REACHED, END_OF_TRAVEL, NOT_TRIED; ``share`` how much of the way from the pose before could
    be walked.
    """

    poses: Matrix
    inputs: Matrix
    slopes: Matrix
    outputs: Matrix
    outcome: Integers
    share: Vector


class Work(NamedTuple):
    """Scratch: rows of ``rows`` are the pose tried, the one walked from, the one predicted, slopes along the way."""

    rows: Matrix
    u: Vector
    out: Matrix
    m: Vector


def space_for(walk: Walk, outputs: int) -> tuple[Found, Work]:
    """Make the arrays of a walk; ``outputs`` is how many each pose has."""
    count, tracks = walk.targets.shape
    size = len(walk.start)
    results = Found(
        np.full((size, count), np.nan),
        np.full((tracks, count), np.nan),
        np.zeros((size * tracks, count)),
        np.full((outputs, count), np.nan),
        np.full(count, NOT_TRIED, dtype=np.int64),
        np.zeros(count),
    )
    work = Work(
        np.zeros((4, size)), np.zeros(tracks), np.zeros((1, size * (1 + tracks) + 1)), np.zeros(1)
    )
    return results, work


def walk_poses(walk: Walk, results: Found, work: Work) -> None:
    """Find all targets and their outputs."""
    _walk(walk, results, work)


def walk_variants(
    walk: Walk,
    variants: Matrix,
    results: Found,
    work: Work,
    place: Integers,
    chosen: Integers,
    out: Block,
) -> None:
    """Find all targets for each row of parameter values; start pose and targets are the same for all of them.

    ``out`` has the shape (chosen outputs, variants, targets) and gets target ``i`` at ``place[i]``, NaN where a target
    is out of reach.
    """
    _walk_variants(walk, variants, results, work, place, chosen, out)
