"""Curves of one variable: force over deflection, and torque over angle."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from jounce.core.description import Description
from jounce.core.samples import Listed
from jounce.core.units import Angle, Force, Length, Number, PositiveNumber, Torque
from jounce.parts.tables import check_table


class PolynomialCurve(Description):
    """Force ``F = c[0] x + c[1] x^2 + ...`` without a constant term; ``x`` in m, ``c[i]`` in N/m^(i+1)."""

    kind: Literal["polynomial"] = "polynomial"
    coefficients: Annotated[tuple[Number, ...], Listed] = Field(min_length=1, max_length=9)


class PowerCurve(Description):
    """Force ``F = coefficient * x^exponent`` for ``x > 0`` in m (zero below); SI units."""

    kind: Literal["power"] = "power"
    coefficient: PositiveNumber
    exponent: PositiveNumber


class TableCurve(Description):
    """Force as a table over deflection (m, compression positive), interpolated and extrapolated linearly."""

    kind: Literal["table"] = "table"
    deflection: Annotated[tuple[Length, ...], Listed] = Field(min_length=2)
    force: Annotated[tuple[Force, ...], Listed] = Field(min_length=2)

    @model_validator(mode="after")
    def _check(self) -> Self:
        check_table("deflection", self.deflection, self.force)
        return self


Curve = Annotated[PolynomialCurve | PowerCurve | TableCurve, Field(discriminator="kind")]


class RotationalTableCurve(Description):
    """Torque as a table over angle (rad), interpolated and extrapolated linearly."""

    kind: Literal["table"] = "table"
    angle: Annotated[tuple[Angle, ...], Listed] = Field(min_length=2)
    torque: Annotated[tuple[Torque, ...], Listed] = Field(min_length=2)

    @model_validator(mode="after")
    def _check(self) -> Self:
        check_table("angle", self.angle, self.torque, "torque")
        return self
