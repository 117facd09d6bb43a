"""Points and other triples of values along x, y and z."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from pydantic import BeforeValidator

from jounce.core.types import Array
from jounce.core.units import (
    Length,
    NonNegativeDampingCoefficient,
    NonNegativeRotationalStiffness,
    NonNegativeStiffness,
)

Triple = tuple[float, float, float]


def _three(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if not isinstance(value, (list, tuple)):
        raise ValueError(
            f'three values along x, y and z are needed, as in ["150 mm", "400 mm", "155 mm"]; found {value!r}'
        )
    if len(value) != 3:
        raise ValueError(f"three values along x, y and z are needed; found {len(value)}: {list(value)}")
    return value


Point = Annotated[tuple[Length, Length, Length], BeforeValidator(_three)]
"""Position in m: x forward, y left, z up."""
StiffnessTriple = Annotated[
    tuple[NonNegativeStiffness, NonNegativeStiffness, NonNegativeStiffness], BeforeValidator(_three)
]
RotationalStiffnessTriple = Annotated[
    tuple[NonNegativeRotationalStiffness, NonNegativeRotationalStiffness, NonNegativeRotationalStiffness],
    BeforeValidator(_three),
]
DampingTriple = Annotated[
    tuple[NonNegativeDampingCoefficient, NonNegativeDampingCoefficient, NonNegativeDampingCoefficient],
    BeforeValidator(_three),
]


def distance(one: Triple | Array, other: Triple | Array) -> float:
    """Distance between two points in m."""
    return float(np.linalg.norm(np.subtract(one, other)))


def distance_to_line(point: Triple | Array, one: Triple | Array, other: Triple | Array) -> float:
    """Distance in m of a point from the line through two others that differ."""
    along = np.subtract(other, one)
    return float(np.linalg.norm(np.cross(along, np.subtract(point, one))) / np.linalg.norm(along))
