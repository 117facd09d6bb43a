"""Loops of a damper: a record split into half strokes, and the mean force of each at given velocities."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.identify.damper_record import DamperMotion

_CLEAR = 0.1  # share of the stroke on either side of its middle in which noise makes no crossing
_BLOCKS = 12  # parts of a record that has no cycles
_LEAST = 4  # samples of a slope


@dataclass(frozen=True)
class Loops:
    """Mean force of every cycle at given velocities, while the speed rises and while it falls.

    Attributes
    ----------
    velocity : array (k,)
        Velocities, m/s, bump positive.
    force : array (cycles, 2, k)
        Force (N) at each velocity in each cycle: with rising, then with falling speed; NaN where there are no samples.
    displacement, acceleration : array (2, k)
        Mean displacement from mid-stroke (m) and acceleration (m/s²) of these samples.
    """

    velocity: Array
    force: Array
    displacement: Array
    acceleration: Array

    @property
    def both(self) -> Array:
        """Mean of rising and falling speed in each cycle (cycles, k), in which lag and gas stiffness cancel.

        Parts of a record without cycles may have one of them only.
        """
        return mean_of(np.moveaxis(self.force, 1, 0))


def mean_of(values: Array) -> Array:
    """Return the mean over the first axis of what is finite; NaN where nothing is."""
    known = np.isfinite(values)
    number = known.sum(axis=0)
    mean: Array = np.where(known, values, 0.0).sum(axis=0) / np.where(number > 0, number, np.nan)
    return mean


def error_of(values: Array) -> Array:
    """Return the standard error of the mean over the first axis; NaN with less than two finite values."""
    known = np.isfinite(values)
    number = known.sum(axis=0)
    squares = np.where(known, (values - mean_of(values)) ** 2, 0.0).sum(axis=0)
    error: Array = np.sqrt(squares / np.where(number > 1, (number - 1.0) * number, np.nan))
    return error


def cycle_numbers(displacement: Array) -> NDArray[np.int64]:
    """Number the cycles of a stroke; -1 before the first whole one and after the last.

    A cycle begins where the stroke passes its middle upwards. Without two such passes, a record that ends where it
    began is one cycle, and any other is divided into parts of equal length.

    >>> cycle_numbers(np.sin(np.linspace(0.0, 6.0 * np.pi, 601)))[[5, 150, 350, 590]].tolist()
    [-1, -1, 0, -1]
    """
    side = displacement - 0.5 * float(displacement.max() + displacement.min())
    clear = np.flatnonzero(np.abs(side) > _CLEAR * float(np.ptp(displacement)))
    signs = np.sign(side[clear])
    starts = clear[1:][(signs[1:] > 0.0) & (signs[:-1] < 0.0)]
    count = len(displacement)
    if len(starts) < 2 and is_closed(displacement):
        return np.zeros(count, dtype=np.int64)
    if len(starts) < 2:
        return np.arange(count) * _BLOCKS // count
    numbers = np.searchsorted(starts, np.arange(count), side="right") - 1
    numbers[numbers == len(starts) - 1] = -1
    return numbers


def is_closed(displacement: Array) -> bool:
    """Whether a stroke ends where it began, and in the same direction, after it has turned twice.

    >>> is_closed(np.sin(np.linspace(0.0, 2.0 * np.pi, 99))), is_closed(np.linspace(0.0, 1.0, 99))
    (True, False)
    """
    some = max(1, len(displacement) // 100)
    away = float(displacement[-1] - displacement[0])
    begins, ends = displacement[some] - displacement[0], displacement[-1] - displacement[-1 - some]
    turns = abs(float(begins)) + abs(float(ends)) + _OPEN * float(np.ptp(displacement))
    return bool(abs(away) < turns and begins * ends >= 0.0)


_OPEN = 0.01  # share of the stroke


def acceleration_of(motion: DamperMotion) -> Array:
    """Differentiate the velocity (m/s²) over about a twentieth of a cycle."""
    count = len(motion.time)
    half = int(np.clip(count / max(motion.cycles, 1.0) / 40.0, 1, 200))
    if count <= 2 * half + 2:
        return np.gradient(motion.velocity, motion.time)
    span = motion.time[2 * half :] - motion.time[: -2 * half]
    rise = motion.velocity[2 * half :] - motion.velocity[: -2 * half]
    middle = rise / span
    return np.concatenate([np.full(half, middle[0]), middle, np.full(half, middle[-1])])


def loops_of(
    motion: DamperMotion,
    cycles: NDArray[np.int64],
    velocity: Array,
    width: Array,
    *,
    acceleration: Array,
    lag: float = 0.0,
    stiffness: float = 0.0,
) -> Loops:
    """Average the force in windows about velocities, by a straight line in each, whose slope is that of all cycles.

    Parameters
    ----------
    motion : DamperMotion
        The record.
    cycles : array (n,) of int
        Cycle of each sample, as :func:`cycle_numbers`.
    velocity, width : array (k,)
        Centres and half widths of the windows, m/s; windows do not overlap, centres ascend.
    acceleration : array (n,)
        Acceleration, m/s².
    lag, stiffness : float
        Delay of the force (s) and gas stiffness (N/m) to take out.
    """
    speed = motion.velocity - lag * acceleration
    force = motion.force - stiffness * motion.displacement
    count, windows = int(cycles.max()) + 1, len(velocity)
    place = np.searchsorted(velocity + width, speed)
    inside = (place < windows) & (cycles >= 0)
    inside &= speed >= (velocity - width)[np.minimum(place, windows - 1)]
    kept = np.flatnonzero(inside)
    place, speed, force = place[kept], speed[kept], force[kept]
    falls = (speed * acceleration[kept] < 0.0).astype(np.int64)
    branch = falls * windows + place
    away = speed - velocity[place]
    slope = _slopes_in(branch, away, force, 2 * windows)
    key = cycles[kept] * 2 * windows + branch
    size = 2 * count * windows
    number = np.bincount(key, minlength=size)
    mean = np.bincount(key, force - slope[branch] * away, minlength=size).astype(float)
    mean /= np.where(number > 0, number, np.nan)
    samples = np.bincount(branch, minlength=2 * windows)
    with np.errstate(all="ignore"):
        means = [
            (np.bincount(branch, values[kept], minlength=2 * windows) / samples).reshape(2, windows)
            for values in (motion.displacement, acceleration)
        ]
    return Loops(velocity, mean.reshape(count, 2, windows), *means)


def _slopes_in(window: NDArray[np.int64], away: Array, force: Array, windows: int) -> Array:
    """Return the slope of the force in each window, over all cycles; 0 with too few samples."""

    def total(weights: Array | None = None) -> Array:
        return np.bincount(window, weights, minlength=windows).astype(float)

    number, first, second = total(), total(away), total(away**2)
    spread = number * second - first**2
    steep = number * total(away * force) - first * total(force)
    known = (number >= _LEAST) & (spread > 1e-12 * number * second)
    slope: Array = np.where(known, steep, 0.0) / np.where(known, spread, 1.0)
    return slope
