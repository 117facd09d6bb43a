"""Force laws of one variable as data: polynomial, power law and table."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Literal

from pydantic import Field, model_validator

from jounce.core.description import Description
from jounce.core.units import Force, Length, Number, PositiveNumber, Speed


class PolynomialCurve(Description):
    """Force ``F = c[0] x + c[1] x^2 + ...`` without a constant term; ``x`` in m, ``c[i]`` in N/m^(i+1)."""

    kind: Literal["polynomial"] = "polynomial"
    coefficients: tuple[Number, ...] = Field(min_length=1, max_length=9)


class PowerCurve(Description):
    """Force ``F = coefficient * x^exponent`` for ``x > 0`` in m (zero below); SI units."""

    kind: Literal["power"] = "power"
    coefficient: PositiveNumber
    exponent: PositiveNumber


class TableCurve(Description):
    """Force through points of deflection (m, compression positive), straight lines between them and beyond."""

    kind: Literal["table"] = "table"
    deflection: tuple[Length, ...] = Field(min_length=2)
    force: tuple[Force, ...] = Field(min_length=2)

    @model_validator(mode="after")
    def _check(self) -> TableCurve:
        check_table("deflection", self.deflection, self.force)
        return self


class VelocityTable(Description):
    """Damper force through points of velocity (m/s, bump positive), straight lines between them and beyond."""

    kind: Literal["table"] = "table"
    velocity: tuple[Speed, ...] = Field(min_length=2)
    force: tuple[Force, ...] = Field(min_length=2)

    @model_validator(mode="after")
    def _check(self) -> VelocityTable:
        check_table("velocity", self.velocity, self.force)
        return self


def check_table(name: str, x: tuple[float, ...], force: tuple[float, ...]) -> None:
    """Refuse tables of unequal length or with points that do not ascend."""
    if len(x) != len(force):
        raise ValueError(f"{name} has {len(x)} points and force has {len(force)}; give as many of both")
    for i, (a, b) in enumerate(pairwise(x)):
        if b <= a:
            raise ValueError(f"{name}[{i + 1}] = {b:g} does not lie above {name}[{i}] = {a:g}; sort the points")


Curve = Annotated[PolynomialCurve | PowerCurve | TableCurve, Field(discriminator="kind")]
