"""The models: the quarter car, and every class of rig by the name that ``model`` has in its file."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from jounce.core.constants import GRAVITY
from jounce.core.description import Description
from jounce.core.units import Acceleration, Mass, Unit
from jounce.parts.corner import Corner
from jounce.parts.corners import DoubleWishbone, FiveLink, McPherson, TrailingArm
from jounce.parts.elements import BumpStop, Damper, Friction, Spring, Tyre
from jounce.parts.rig import Rig, stop_to_strut

_StrutAngle = Annotated[float, Unit("rad", at_least=0.0, at_most=1.2)]


class Lump(Description):
    """A mass that only translates along z, kg."""

    mass: Mass


class Strut(Description):
    """Spring and damper unit at ``angle`` to the vertical; lumped, its motion ratio is ``cos(angle)``."""

    angle: _StrutAngle = 0.0
    spring: Spring
    damper: Damper
    friction: Friction | None = None
    bump_stop: BumpStop | None = None


class Guide(Description):
    """Vertical guide of the sprung mass."""

    friction: Friction | None = None


class QuarterCar(Rig):
    """Quarter car: sprung and unsprung mass on strut and tyre, both vertical (paper 2, eqs 1-4, extended).

    Signs: z up, deflections and forces positive in compression. ``gravity`` in m/s^2.
    """

    schema_: Literal["jounce.rig/1"] = Field(default="jounce.rig/1", alias="schema")
    model: Literal["quarter-car"] = "quarter-car"
    gravity: Acceleration = GRAVITY
    sprung: Lump
    unsprung: Lump
    strut: Strut
    guide: Guide = Guide()
    tyre: Tyre

    @model_validator(mode="before")
    @classmethod
    def _stop_belongs_to_the_strut(cls, table: Any) -> Any:
        return stop_to_strut(table)


RIGS: dict[str, type[Rig]] = {
    "quarter-car": QuarterCar,
    "double-wishbone": DoubleWishbone,
    "mcpherson": McPherson,
    "five-link": FiveLink,
    "trailing-arm": TrailingArm,
}

__all__ = ["RIGS", "Corner", "DoubleWishbone", "FiveLink", "McPherson", "QuarterCar", "Rig", "TrailingArm"]
