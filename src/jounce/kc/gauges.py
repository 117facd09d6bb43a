"""Toe from distances: two dial gauges on a plate at the wheel, or a difference over the rim."""

from __future__ import annotations

import numpy as np

from jounce.core.errors import RecordingError
from jounce.core.types import Array


def toe_of_gauges(front: Array, rear: Array, base: float | Array | None, where: str) -> Array:
    """Return the toe angle (rad, toe-in positive) of two dial gauges (m, positive when the plate moves outward).

    ``base`` is the distance of the gauges in m. Raises RecordingError without it.

    >>> toe_of_gauges(np.array([-0.001]), np.array([0.001]), 0.4, "").round(6).tolist()
    [0.005]
    """
    return np.asarray(np.arctan((rear - front) / _base(base, where)), dtype=float)


def toe_of_distance(distance: Array, base: float | Array | None, where: str) -> Array:
    """Return the toe angle (rad) of one wheel from its toe-in as a distance (m) over a base or rim (m)."""
    return np.asarray(np.arctan(distance / _base(base, where)), dtype=float)


def _base(base: float | Array | None, where: str) -> float | Array:
    if base is None or not np.all(np.asarray(base) > 0.0):
        raise RecordingError(
            "toe as a distance needs the length that it is measured over",
            where=where,
            allowed="above 0",
            hint='Give it: a column "gauge base [mm]", or gauge_base = "400 mm" in the channel map.',
        )
    return base
