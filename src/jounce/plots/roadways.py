"""The road that passes under a wheel while a trial is driven."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError
from jounce.core.types import Array
from jounce.plots.roads import sampled

if TYPE_CHECKING:
    from jounce.roads import Trial

REACH = 3.2
"""How much of the road is shown behind and ahead of the wheel, in its radii."""
_VISIBLE = 2e-5  # m


@dataclass(frozen=True)
class Roadway:
    """Height of a road over distance, and where on it the wheel is in each pose.

    Attributes
    ----------
    distance, height : ndarray, shape (m,)
        Corners of the line, m, ascending in distance; jumps stand upright.
    way : ndarray, shape (n,)
        Distance driven at each pose, m.
    """

    distance: Array
    height: Array
    way: Array

    def line(self, k: int, reach: float, x: float) -> Array:
        """Give x and z (m), shape (m, 2), of the road within ``reach`` (m) of a wheel at ``x`` (m) in pose ``k``."""
        first, last = self.way[k] - reach, self.way[k] + reach
        inside = (self.distance > first) & (self.distance < last)
        ends = np.interp([first, last], self.distance, self.height)
        distance = np.concatenate([[first], self.distance[inside], [last]])
        height = np.concatenate([ends[:1], self.height[inside], ends[1:]])
        return np.column_stack([distance - self.way[k] + x, height])


def roadway_of(trial: Trial, time: Array, radius: float) -> Roadway | None:
    """Lay the road of a trial under a wheel.

    Parameters
    ----------
    trial : Trial
        What was driven.
    time : ndarray, shape (n,)
        Of the poses, s.
    radius : float
        Of the wheel, m: how much road is needed around it.

    Returns
    -------
    Roadway or None
        None for an excitation: its plate only goes up and down.

    Raises
    ------
    DescriptionError
        When the poses go on after the trial has ended.
    """
    if trial.road is None or trial.speed is None:
        return None
    if time[-1] > trial.duration * (1.0 + 1e-9):
        raise DescriptionError(
            "the poses are not of this trial; they go on after its end",
            where="trial",
            found=f"{time[-1]:g} s",
            allowed=f"up to {trial.duration:g} s",
        )
    way = trial.speed * time
    distance, height = sampled(trial.road.segments(float(way[-1]) + REACH * radius))
    kept = _bends(distance, height)
    return Roadway(distance[kept], height[kept], way)


def _bends(distance: Array, height: Array) -> NDArray[np.bool_]:
    """Which points of a line are needed to see it; those on the straight between their neighbours are not."""
    kept = np.ones(len(distance), dtype=bool)
    while True:
        at = np.flatnonzero(kept)
        if len(at) < 3:
            return kept
        before, here, after = at[:-2:2], at[1:-1:2], at[2::2]
        count = min(len(before), len(here), len(after))
        before, here, after = before[:count], here[:count], after[:count]
        share = (distance[here] - distance[before]) / np.maximum(distance[after] - distance[before], 1e-12)
        off = np.abs(height[before] + share * (height[after] - height[before]) - height[here])
        straight = here[off < 0.1 * _VISIBLE]
        if not len(straight):
            return kept
        kept[straight] = False
