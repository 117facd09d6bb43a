"""Poses of a suspension sampled over its travel, and polynomials through their quantities.

Samples are taken at Chebyshev points of a range of travel, each pose exact to rounding. A polynomial keeps the first
coefficients; the following ones, sampled as well, bound its error.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.core.remembered import Recent
from jounce.core.types import Array
from jounce.kernel.native import Native, Source, code_from_cache
from jounce.kernel.poses import Walk, space_for, walk_variants
from jounce.roads import Trial
from jounce.simulation.compiled import sources
from jounce.simulation.settings import RunSettings

if TYPE_CHECKING:
    from jounce.models.reduced import SampledCorner


DEGREES = (10, 18)
"""Degrees of the polynomials; the second is used for large wheel travel or a tight tolerance."""
SHARE, SHOWN = 1e-3, 0.1
"""Shares of the tolerance: allowed error of a lever or mass (the static load is about a hundred times the motion), and
of a quantity without effect on the static load, such as a channel."""
STEPS_SHARE = 0.9
"""Share of the tolerance that remains for the integration."""
TIGHTEST, COARSEST = 1e-7, 5e-3
"""Tolerance below which rounding alone exceeds the allowed error of a table; sample step (s) above which a wheel may
leave its range and return unnoticed."""
ROUNDINGS = 8.0 * float(np.finfo(float).eps)
"""Relative rounding of a quantity or its slope at a pose."""
FLAT, TURNED = 1e-3, 0.5
"""Minimum reference slope (1, rad/m) for the error of a quantity; angle (rad) of a wheel beyond which it may flip over,
which only the full mechanism can show."""
BESIDE, OFF, TRIES = 0.25, 0.5, 3
"""Margin of the next range on either side, as a share of the range used by the wheel; maximum offset of the pose at
rest from the centre, as a share of the range; number of ranges tried."""
_NARROW, _WIDE, _FOLLOWED = (
    0.02,
    0.06,
    1.5,
)  # m, m, road heights: limits and factor of the first range on either side


def first_range(road: float) -> float:
    """Return the first range of travel (m) on either side, for a road that rises by ``road`` (m)."""
    return min(_NARROW + _FOLLOWED * road, _WIDE)


def may_reduce(trial: Trial, settings: RunSettings) -> bool:
    """Whether runs on a trial may be reduced, regardless of the rig."""
    fine = settings.tolerance >= TIGHTEST and settings.output_step <= COARSEST
    return settings.method == "auto" and fine and trial.actuator_force is None


class TravelTable(NamedTuple):
    """Parameters of a reduced corner for one range of travel (m), and the bound of their relative error."""

    low: float
    high: float
    numbers: Array
    error: float


class LastTables(Recent[TravelTable]):
    """Cache of recent tables: a rig often runs repeatedly, and a table requires tens of poses."""

    most = 64


class ChebyshevBasis(NamedTuple):
    """Points from -1 to 1, the transform from values to Chebyshev coefficients, and from the leading ones to powers."""

    points: Array
    coefficients: Array
    powers: Array
    squares: Array


@cache
def basis(degree: int) -> ChebyshevBasis:
    """Return points and matrices for a degree: twice as many points as retained coefficients."""
    count = 2 * (degree + 1)
    angles = np.pi * (np.arange(count)[::-1] + 0.5) / count
    orders = np.arange(count)
    transform = 2.0 / count * np.cos(orders[:, None] * angles)
    transform[0] *= 0.5
    powers = np.zeros((degree + 1, degree + 1))
    for k in range(degree + 1):
        powers[k, : k + 1] = np.polynomial.chebyshev.cheb2poly(np.eye(degree + 1)[k])[: k + 1]
    return ChebyshevBasis(np.cos(angles), transform, powers, orders.astype(float) ** 2)


@dataclass(frozen=True)
class Sampling:
    """Sampling of the poses of suspensions of one structure.

    ``names`` are the quantities sampled, the mass first; ``tracks``, ``parameters`` and ``start`` belong to the poses.
    """

    native: Native
    names: tuple[str, ...]
    tracks: tuple[str, ...]
    parameters: tuple[str, ...]
    start: Array

    def walk(self, p: Array, rack: float, travel: Array) -> tuple[Walk, NDArray[np.intp]]:
        """Return a path through poses at ascending travels (m), and the index of each target among them."""
        up, down = (
            np.flatnonzero(travel >= 0.0),
            np.flatnonzero(travel < 0.0)[::-1],
        )  # from design in both directions
        place = np.concatenate([up, down])
        targets = np.zeros((len(travel), len(self.tracks)))
        targets[:, 0] = travel[place]
        if "rack" in self.tracks:
            targets[:, self.tracks.index("rack")] = rack
        before = np.arange(-1, len(travel) - 1, dtype=np.int64)
        before[len(up) : len(up) + 1] = -1
        address, origin = self.native.address, np.zeros(len(self.tracks))
        return Walk(
            address["pose"], address["output"], p, self.start, origin, targets, before
        ), place

    def sample(self, p: Array, rack: float, travel: Array) -> Array:
        """Return the quantities of every row at ascending travels, shape (quantities, rows, travels)."""
        walk, place = self.walk(p[0].copy(), rack, travel)
        values = np.empty((len(self.names), len(p), len(travel)))
        every = np.arange(len(self.names), dtype=np.int64)
        walk_variants(
            walk, np.ascontiguousarray(p), *space_for(walk, len(self.names)), place, every, values
        )
        return values


def sampling_of(identity: str, make: Callable[[], SampledCorner]) -> Sampling:
    """Return native code that samples a suspension, from the cache or built by ``make``."""

    def source() -> Source:
        corner = make()
        notes = {
            "names": corner.names,
            "tracks": corner.tracks,
            "parameters": corner.parameters,
            "start": corner.start,
        }
        return Source({"pose": corner.pose, "output": corner.output}, None, json.dumps(notes))

    native, notes = code_from_cache(f"{sources()} {identity}", source)
    table = json.loads(notes)
    names, tracks, parameters = (tuple(table[name]) for name in ("names", "tracks", "parameters"))
    return Sampling(native, names, tracks, parameters, np.array(table["start"], dtype=float))
