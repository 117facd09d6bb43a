"""Loops of load: branches, mean lines, zeros, drift and noise of a sweep that goes up and down."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array

_TURN = 0.05
"""Share of the range by which an input must go back before it counts as turned."""
_MIDDLE = 0.3
"""Share of the range about its middle in which friction slips on both branches."""
_BINS = 60
"""Number of intervals of a branch whose samples are averaged, if it has several times as many."""


@dataclass(frozen=True)
class Branch:
    """Part of a sweep in one direction.

    Attributes
    ----------
    samples : slice
        Its samples, with both turning points.
    direction : {1, -1}
        1: the input rises, -1: it falls.
    """

    samples: slice
    direction: int


def branches_of(sweep: Array) -> tuple[Branch, ...]:
    """Split an input (any unit) at its turning points; noise below a share of its range turns nothing.

    >>> [(b.samples.start, b.samples.stop, b.direction) for b in branches_of(np.array([0.0, 1.0, 0.0, -1.0, 0.0]))]
    [(0, 2, 1), (1, 4, -1), (3, 5, 1)]
    """
    return _branches(np.ascontiguousarray(sweep, dtype=float).tobytes())


@lru_cache(maxsize=16)
def _branches(samples: bytes) -> tuple[Branch, ...]:
    """Split an input; a sheet asks for the branches of one input for each of its quantities."""
    sweep = np.frombuffer(samples)
    if sweep.size < 2 or np.ptp(sweep) == 0.0:
        return ()
    band = _TURN * float(np.ptp(sweep))
    values = sweep.tolist()
    first = extreme = values[0]
    turns, at, direction = [0], 0, 0
    for i, value in enumerate(values):
        if direction == 0:
            if abs(value - first) > band:
                direction, at, extreme = (1 if value > first else -1), i, value
        elif direction * (value - extreme) >= 0.0:
            at, extreme = i, value
        elif direction * (extreme - value) > band:
            turns.append(at)
            direction, at, extreme = -direction, i, value
    turns.append(sweep.size - 1)
    return tuple(
        Branch(slice(a, b + 1), 1 if sweep[b] > sweep[a] else -1)
        for a, b in itertools.pairwise(turns)
        if b > a
    )


def directions_of(sweep: Array) -> NDArray[np.int_]:
    """Return the direction of each sample of an input (any unit): 1 rising, -1 falling."""
    directions = np.ones(sweep.size, dtype=int)
    for branch in branches_of(sweep):
        directions[branch.samples.start + (branch.samples.start > 0) : branch.samples.stop] = (
            branch.direction
        )
    return directions


@dataclass(frozen=True)
class Lines:
    """Rising, falling and mean line over the same inputs, each in the unit of its values; NaN where not measured."""

    inputs: Array
    up: Array
    down: Array

    @property
    def mean(self) -> Array:
        """Mean of both branches, or the only one (the unit of the values)."""
        both = (self.up + self.down) / 2.0
        return np.where(np.isnan(self.up), self.down, np.where(np.isnan(self.down), self.up, both))

    @property
    def elastic(self) -> Array:
        """Curve without dry friction (the unit of the values): the branch that comes to an end, less half the opening.

        Friction has slipped along the branch that comes to an end, and not yet along the one that leaves it: the mean
        of both is too steep there. Exact if all friction slips well before the middle (Masing's rule); without two
        branches, the mean line.
        """
        half = (self.up - self.down) / 2.0
        middle, reach = (self.inputs[0] + self.inputs[-1]) / 2.0, np.ptp(self.inputs) / 2.0
        away = self.inputs - middle
        inner = half[np.isfinite(half) & (np.abs(away) <= _MIDDLE * reach)]
        if not inner.size:
            return self.mean
        opening = float(np.median(inner))
        coming = np.where(away > 0.0, self.up - opening, self.down + opening)
        return np.where(np.isfinite(half) & (away != 0.0), coming, self.mean)

    @property
    def opening(self) -> float:
        """Largest distance of the branches (the unit of the values); 0 without two branches."""
        gap = np.abs(self.up - self.down)
        return float(np.nanmax(gap)) if np.isfinite(gap).any() else 0.0


def lines_of(sweep: Array, values: Array, inputs: Array) -> Lines:
    """Interpolate the branches of a loop at given inputs (its unit), averaged over cycles.

    The first branch of several cycles begins on another path than the loop, and is left out.
    """
    branches = branches_of(sweep)
    turning = _spans_loop(branches, sweep)
    parts: dict[int, list[Array]] = {1: [], -1: []}
    for branch in branches[1:] if turning else branches:
        x, y = sweep[branch.samples], values[branch.samples]
        good = np.isfinite(x) & np.isfinite(y)
        if good.any():
            parts[branch.direction].append(_at(x[good], y[good], inputs))
    up, down = (_mean_of(parts[direction], inputs) for direction in (1, -1))
    return Lines(inputs, up, down)


def _spans_loop(branches: tuple[Branch, ...], sweep: Array) -> bool:
    """Whether the branches after the first cover the range of the sweep in both directions."""
    rest = branches[1:]
    reach = {1: 0.0, -1: 0.0}
    for branch in rest:
        reach[branch.direction] = max(reach[branch.direction], float(np.ptp(sweep[branch.samples])))
    return min(reach.values()) > 0.9 * float(np.ptp(sweep))


def _mean_of(parts: list[Array], inputs: Array) -> Array:
    if not parts:
        return np.full(inputs.shape, np.nan)
    stack = np.array(parts)
    known = np.isfinite(stack)
    count = known.sum(axis=0)
    total = np.where(known, stack, 0.0).sum(axis=0)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def _at(x: Array, y: Array, inputs: Array) -> Array:
    """Interpolate one branch; dense samples are averaged first, so that noise does not decide."""
    order = np.argsort(x, kind="stable")
    x, y = x[order], y[order]
    if x.size > 4 * _BINS:
        starts = np.arange(_BINS) * x.size // _BINS
        counts = np.diff(np.append(starts, x.size))
        x, y = (
            np.concatenate([part[:1], np.add.reduceat(part, starts) / counts, part[-1:]])
            for part in (x, y)
        )
    reach = 1e-9 * float(np.ptp(x))
    inside = (inputs >= x[0] - reach) & (inputs <= x[-1] + reach)
    return np.where(inside, np.interp(inputs, x, y), np.nan)


def value_at(sweep: Array, values: Array, at: float = 0.0) -> float:
    """Return the value where the input is ``at`` (its unit), the mean of both branches; NaN if it is never there."""
    return float(lines_of(sweep, values, np.array([at])).mean[0])


def drift_of(sweep: Array, values: Array) -> tuple[float, float]:
    """Return the drift per sample (unit of the values), from equal inputs of successive cycles, and its standard error.

    The first branch is left out if there are enough others. (0, inf) without two branches in one direction.
    """
    branches = branches_of(sweep)
    branches = branches[1:] if len(branches) > 3 else branches
    inputs = np.linspace(float(np.min(sweep)), float(np.max(sweep)), 21)
    slopes = []
    for first, second in zip(branches, branches[2:], strict=False):
        x = inputs[1:-1]
        a, b = (_branch_at(sweep, values, branch, x) for branch in (first, second))
        i, j = (_instants_at(sweep, branch, x) for branch in (first, second))
        slope = (b - a) / (j - i)
        slopes += slope[np.isfinite(slope)].tolist()
    if len(slopes) < 4:
        return 0.0, float("inf")
    return float(np.mean(slopes)), float(np.std(slopes) / np.sqrt(len(slopes) - 1))


def _branch_at(sweep: Array, values: Array, branch: Branch, inputs: Array) -> Array:
    x, y = sweep[branch.samples], values[branch.samples]
    good = np.isfinite(x) & np.isfinite(y)
    return _at(x[good], y[good], inputs) if good.sum() > 1 else np.full(inputs.shape, np.nan)


def _instants_at(sweep: Array, branch: Branch, inputs: Array) -> Array:
    """Return where in the sweep a branch passes inputs, in samples."""
    number = np.arange(sweep.size, dtype=float)
    return _branch_at(sweep, number, branch, inputs)


def noise_of(values: Array) -> float:
    """Estimate the standard deviation of readings (their unit) from their third differences.

    >>> rng = np.random.default_rng(1)
    >>> 0.8 < noise_of(np.linspace(0.0, 50.0, 400) + rng.normal(0.0, 1.0, 400)) < 1.2
    True
    """
    finite = values[np.isfinite(values)]
    if finite.size < 8:
        return 0.0
    rough = np.diff(finite, 3)
    return 1.4826 * float(np.median(np.abs(rough))) / float(np.sqrt(20.0))
