"""Springs, dampers, friction, stops and tyres as frozen descriptions."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Discriminator, Tag, model_validator

from jounce.core.description import Description
from jounce.core.units import (
    Force,
    Length,
    NonNegativeDampingCoefficient,
    NonNegativeForce,
    PositiveSpeed,
    PositiveStiffness,
    Stiffness,
    Unit,
)
from jounce.parts.curves import Curve, VelocityTable


class Spring(Description):
    """Strut spring: ``rate`` (N/m) or a ``curve`` of deflection, plus ``preload`` (N) at zero deflection."""

    rate: PositiveStiffness | None = None
    curve: Curve | None = None
    preload: Force = 0.0

    @model_validator(mode="after")
    def _one_law(self) -> Spring:
        require_one(self, "rate", "curve")
        return self


class LinearDamper(Description):
    """Damper force ``coefficient * velocity``, N s/m."""

    kind: Literal["linear"] = "linear"
    coefficient: NonNegativeDampingCoefficient


class BilinearDamper(Description):
    """Damper with one coefficient in bump and another in rebound, N s/m."""

    kind: Literal["bilinear"] = "bilinear"
    bump_coefficient: NonNegativeDampingCoefficient
    rebound_coefficient: NonNegativeDampingCoefficient


class TanhDamper(Description):
    """Hysteretic damper ``F = c v + k x + f tanh(slope (v + displacement_coupling x)) + offset`` (Kwok 2006)."""

    kind: Literal["tanh"] = "tanh"
    coefficient: NonNegativeDampingCoefficient
    stiffness: Stiffness = 0.0
    force: NonNegativeForce
    slope: Annotated[float, Unit("s/m", above=0.0)]
    displacement_coupling: Annotated[float, Unit("1/s")] = 0.0
    offset: Force = 0.0


class BoucWenDamper(Description):
    """Hysteretic damper ``F = c v + k x + f z + offset`` with the normalised Bouc-Wen state ``-1 <= z <= 1``.

    ``z' = rate (v - sigma |v| |z|^(n-1) z + (sigma - 1) v |z|^n)``, rate in 1/m, sigma >= 1/2, exponent n >= 1.
    """

    kind: Literal["bouc-wen"] = "bouc-wen"
    coefficient: NonNegativeDampingCoefficient
    stiffness: Stiffness = 0.0
    hysteretic_force: NonNegativeForce
    rate: Annotated[float, Unit("1/m", above=0.0)]
    sigma: Annotated[float, Unit("1", at_least=0.5)]
    exponent: Annotated[float, Unit("1", at_least=1.0)]
    offset: Force = 0.0


def damper_kind(value: Any) -> str:
    """Name the law of a damper table: by ``kind``, else by its keys."""
    if not isinstance(value, dict):
        return str(getattr(value, "kind", "linear"))
    if "kind" in value:
        return str(value["kind"])
    if {"bump_coefficient", "rebound_coefficient"} & value.keys():
        return "bilinear"
    return "table" if {"velocity", "force"} & value.keys() else "linear"


Damper = Annotated[
    Annotated[LinearDamper, Tag("linear")]
    | Annotated[BilinearDamper, Tag("bilinear")]
    | Annotated[VelocityTable, Tag("table")]
    | Annotated[TanhDamper, Tag("tanh")]
    | Annotated[BoucWenDamper, Tag("bouc-wen")],
    Discriminator(damper_kind),
]


class Friction(Description):
    """Coulomb friction, regularised as ``force * tanh(velocity / regularisation_velocity)``."""

    force: NonNegativeForce
    regularisation_velocity: PositiveSpeed = 0.002


class BumpStop(Description):
    """Stop that adds ``rate * (deflection - gap) + progression * (deflection - gap)^3`` once the gap is closed."""

    gap: Length
    rate: PositiveStiffness
    progression: Annotated[float, Unit("N/m^3", at_least=0.0)] = 0.0


class Tyre(Description):
    """Radial tyre: ``stiffness`` (N/m) or a ``curve`` of deflection, damping, and lift-off (on by default)."""

    stiffness: PositiveStiffness | None = None
    curve: Curve | None = None
    damping_coefficient: NonNegativeDampingCoefficient = 0.0
    lift_off: bool = True

    @model_validator(mode="after")
    def _one_law(self) -> Tyre:
        require_one(self, "stiffness", "curve")
        return self


def require_one(part: Description, *names: str) -> None:
    """Refuse a part that gives none or more than one of the named laws."""
    given = [name for name in names if getattr(part, name) is not None]
    if len(given) != 1:
        found = " and ".join(given) if given else "none of them"
        raise ValueError(f"give exactly one of {', '.join(names)}; found {found}")


__all__ = [
    "BilinearDamper",
    "BoucWenDamper",
    "BumpStop",
    "Damper",
    "Friction",
    "LinearDamper",
    "Spring",
    "TanhDamper",
    "Tyre",
]
