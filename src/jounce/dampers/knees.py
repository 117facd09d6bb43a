"""Knees of a damper's curve: the velocity and the force at which its blow-off valves open."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np

from jounce.core.results import Shows
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.identify.estimate import Estimate, student_factor

_PLACES = 400  # velocities that are tried
_FEWEST = 9  # points of a side
_EDGE = 2  # points beyond a knee on either side
_FLOOR = 0.004  # share of the largest force: error of a curve made of windows
_SOFTER = 0.7  # slope above a knee over that below
_WIDEST = 0.5  # interval of a knee that is named, as a share of its velocity


@dataclass(frozen=True)
class Knee(Plain):
    """A bend where a valve opens: beyond it the force rises less.

    Attributes
    ----------
    side : {"bump", "rebound"}
        Direction.
    velocity, force : Estimate
        Speed (m/s) and size of the force (N, friction included, gas not) at the bend.
    softer : float
        Slope of the force just beyond the bend over that before [1].
    """

    side: Annotated[Literal["bump", "rebound"], Shows("side")]
    velocity: Annotated[Estimate, Shows("velocity", "m/s")]
    force: Annotated[Estimate, Shows("force", "N")]
    softer: Annotated[float, Shows("slope beyond over before")]


def find_knees(velocity: Array, force: Array, error: Array) -> tuple[Knee, ...]:
    """Find the knee of each side of a curve of force (N, standard ``error`` N) over velocity (m/s), bump positive.

    Before the bend the force is that of a bleed, constant plus linear or quadratic; beyond it a parabola goes on. The
    interval has all places of the bend with which the fit is not significantly worse. A side has no knee if the bend is
    at an end of the curve or cannot be told, or if the force does not rise less beyond it.

    >>> v = np.linspace(0.02, 1.0, 25)
    >>> (knee,) = find_knees(v, np.where(v < 0.3, 5e3 * v**2, 450.0 + 600.0 * (v - 0.3)), np.ones(25))
    >>> knee.side, round(knee.velocity.value, 2), round(knee.force.value)
    ('bump', 0.3, 450)
    """
    knees = []
    sides: tuple[tuple[Literal["bump", "rebound"], float], ...] = (("bump", 1.0), ("rebound", -1.0))
    for side, sign in sides:
        own = np.flatnonzero((sign * velocity > 0.0) & np.isfinite(force))
        own = own[np.argsort(np.abs(velocity[own]))]
        if len(own) >= _FEWEST:
            knee = _knee(side, np.abs(velocity[own]), sign * force[own], np.nan_to_num(error[own]))
            knees += [knee] if knee else []
    return tuple(knees)


def _knee(
    side: Literal["bump", "rebound"], velocity: Array, force: Array, error: Array
) -> Knee | None:
    fits = [_fits(velocity, force, error, power) for power in (1, 2)]
    power, (places, misfit, solution) = min(enumerate(fits, 1), key=lambda item: item[1][1].min())
    best = int(np.argmin(misfit))
    freedom = len(velocity) - solution.shape[1] - 1
    scale = max(float(misfit[best]) / freedom, 1.0)
    near = np.flatnonzero(misfit <= misfit[best] + scale * student_factor(freedom) ** 2)
    if near[0] == 0 or near[-1] == len(places) - 1:
        return None
    at = places[near]
    before = power * solution[near, 1] * at ** (power - 1)
    softer = solution[near, 2] / np.where(before > 0.0, before, np.inf)
    k = int(np.searchsorted(near, best))
    is_clear = bool(np.all(before > 0.0) and np.all(softer < _SOFTER))
    if not is_clear or at[-1] - at[0] > _WIDEST * at[k]:
        return None
    loads = solution[near, 0] + solution[near, 1] * at**power
    step = places[1] - places[0]
    slope = float(before[k])
    return Knee(
        side,
        _between(float(at[k]), float(at[0]) - step, float(at[-1]) + step),
        _between(float(loads[k]), float(loads.min()) - slope * step, float(loads.max()) + slope * step),
        float(softer[k]),
    )  # fmt: skip


def _fits(
    velocity: Array, force: Array, error: Array, power: int
) -> tuple[Array, Array, Array]:  # fmt: skip
    """Fit the curve with its bend at each of many velocities: these, sums of squares, and coefficients."""
    weight = 1.0 / np.hypot(error, _FLOOR * float(np.abs(force).max()))
    places = np.linspace(velocity[_EDGE], velocity[-1 - _EDGE], _PLACES)
    below = np.minimum(velocity, places[:, np.newaxis]) ** power
    beyond = np.maximum(velocity - places[:, np.newaxis], 0.0)
    matrix = np.stack([np.ones_like(below), below, beyond, beyond**2], axis=2)
    solution = np.linalg.pinv(matrix * weight[:, np.newaxis]) @ (force * weight)
    rest = (force - (matrix @ solution[..., np.newaxis])[..., 0]) * weight
    return places, np.sum(rest**2, axis=1), solution


def _between(value: float, low: float, high: float) -> Estimate:
    return Estimate(value, 0.25 * (high - low), (low, high))
