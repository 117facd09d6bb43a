"""Points and rigid bodies: position, mass, centre of mass and physically valid inertia."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Annotated, Any, Self

import numpy as np
from pydantic import BeforeValidator, model_validator

from jounce.core.description import Description
from jounce.core.errors import as_found, show_value
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.samples import as_list
from jounce.core.types import Array
from jounce.core.units import (
    Force,
    Length,
    Mass,
    MomentOfInertia,
    NonNegativeDampingCoefficient,
    NonNegativeForce,
    NonNegativeRotationalStiffness,
    NonNegativeStiffness,
    NonNegativeTorque,
    Number,
    ProductOfInertia,
    Torque,
)

Triple = tuple[float, float, float]


def _three(value: Any) -> Any:
    value = as_list(value)
    if not isinstance(value, (list, tuple)):
        what = 'three values along x, y and z are needed, as in ["150 mm", "400 mm", "155 mm"]'
        raise error_at((), what, found=as_found(value))
    if len(value) != 3:
        entries = Phrase("{count}: {values}", count=len(value), values=show_value(list(value)))
        raise error_at((), "three values along x, y and z are needed", found=entries)
    return value


Point = Annotated[tuple[Length, Length, Length], BeforeValidator(_three)]
"""Position in m: x forward, y left, z up."""
StiffnessTriple = Annotated[
    tuple[NonNegativeStiffness, NonNegativeStiffness, NonNegativeStiffness], BeforeValidator(_three)
]
RotationalStiffnessTriple = Annotated[
    tuple[
        NonNegativeRotationalStiffness,
        NonNegativeRotationalStiffness,
        NonNegativeRotationalStiffness,
    ],
    BeforeValidator(_three),
]
DampingTriple = Annotated[
    tuple[
        NonNegativeDampingCoefficient, NonNegativeDampingCoefficient, NonNegativeDampingCoefficient
    ],
    BeforeValidator(_three),
]

Direction = Annotated[tuple[Number, Number, Number], BeforeValidator(_three)]
"""Direction in design axes: x forward, y left, z up; its length does not matter."""
ForceTriple = Annotated[tuple[Force, Force, Force], BeforeValidator(_three)]
TorqueTriple = Annotated[tuple[Torque, Torque, Torque], BeforeValidator(_three)]
FrictionTriple = Annotated[
    tuple[NonNegativeForce, NonNegativeForce, NonNegativeForce], BeforeValidator(_three)
]
FrictionTorqueTriple = Annotated[
    tuple[NonNegativeTorque, NonNegativeTorque, NonNegativeTorque], BeforeValidator(_three)
]


def distance(first: Triple | Array, second: Triple | Array) -> float:
    """Distance between two points in m."""
    return math.dist(first, second)


def distance_to_line(point: Triple | Array, first: Triple | Array, second: Triple | Array) -> float:
    """Distance in m of a point from the line through two distinct points."""
    (ax, ay, az), (bx, by, bz) = (
        [b - a for a, b in zip(first, end, strict=True)] for end in (second, point)
    )
    return math.hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx) / math.hypot(
        ax, ay, az
    )


TRIANGLE_TOLERANCE = 1e-3
"""Relative excess of the largest principal moment over the sum of the others that is accepted as rounding."""

INERTIA_ELEMENTS = {
    "xx": (0, 0),
    "yy": (1, 1),
    "zz": (2, 2),
    "xy": (0, 1),
    "xz": (0, 2),
    "yz": (1, 2),
}
"""Tensor elements in descriptions: name to row and column."""


class Inertia(Description):
    """Inertia tensor about the centre of mass in design axes, kg m^2; ``xy`` is ``-integral(x y dm)`` and so on."""

    xx: MomentOfInertia
    yy: MomentOfInertia
    zz: MomentOfInertia
    xy: ProductOfInertia = 0.0
    xz: ProductOfInertia = 0.0
    yz: ProductOfInertia = 0.0

    @model_validator(mode="after")
    def _some_body_has_it(self) -> Self:
        moments = self.principal_moments
        smallest, middle, largest = (f"{moment:.6g}" for moment in moments)
        shown = Phrase(
            "its principal moments are {smallest}, {middle} and {largest} kg m^2",
            smallest=smallest,
            middle=middle,
            largest=largest,
        )
        if moments[0] <= 0.0:
            raise ValueError(
                Phrase(
                    "impossible inertia: {shown}, and all must be above 0; make the products xy, xz, yz "
                    "smaller or check their signs (xy = -integral of x y dm)",
                    shown=shown,
                )
            )
        if moments[2] > moments[0] + moments[1] + TRIANGLE_TOLERANCE * moments[2]:
            raise ValueError(
                Phrase(
                    "impossible inertia: {shown}, and the largest must not exceed the sum of the others "
                    "({moments:.6g}); check units and axes",
                    shown=shown,
                    moments=moments[0] + moments[1],
                )
            )
        return self

    @property
    def tensor(self) -> Array:
        """Inertia tensor, shape (3, 3), kg m^2."""
        return np.array(
            [[self.xx, self.xy, self.xz], [self.xy, self.yy, self.yz], [self.xz, self.yz, self.zz]],
            dtype=float,
        )

    @property
    def principal_moments(self) -> Array:
        """Principal moments, ascending, shape (3,), kg m^2."""
        return np.array(_principal_moments(self.xx, self.yy, self.zz, self.xy, self.xz, self.yz))


@lru_cache(256)  # variants of a rig rarely differ in the inertia of bodies
def _principal_moments(
    xx: float, yy: float, zz: float, xy: float, xz: float, yz: float
) -> tuple[float, ...]:
    return tuple(
        np.linalg.eigvalsh(
            np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], dtype=float)
        ).tolist()
    )


class RigidBody(Description):
    """Mass (kg), centre of mass (m, at design position) and inertia about it (kg m^2, design axes)."""

    mass: Mass
    centre_of_mass: Point
    inertia: Inertia
