"""Rigs: what is tested. Each rig is one frozen description; ``model`` in its file names the class."""

from __future__ import annotations

from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from jounce.core.description import Description
from jounce.core.units import Acceleration, Mass, Unit
from jounce.parts.elements import BumpStop, Damper, Friction, Spring, Tyre
from jounce.parts.parameters import change_table, parameters_of

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


class Rig(Description):
    """What all rigs share: origin of the values and how to vary them."""

    schema_: Literal["jounce.rig/1"] = Field(default="jounce.rig/1", alias="schema")
    source: str = ""
    estimated: tuple[str, ...] = ()

    def parameters(self) -> dict[str, float]:
        """Give every number of the rig by its path, SI: ``{"strut.spring.rate": 22730.0, ...}``."""
        return parameters_of(self)

    def with_changes(self, changes: dict[str, Any]) -> Self:
        """Give a copy with other values; nothing is ever mutated.

        Parameters
        ----------
        changes : dict
            Path to value, text with unit or SI number: ``{"strut.spring.rate": "25 N/mm"}``.

        Raises
        ------
        DescriptionError
            For an unknown path (with the nearest one) or a value out of range.
        """
        return type(self).from_table(change_table(self, changes))


class QuarterCar(Rig):
    """Quarter car: sprung and unsprung mass on strut and tyre, both vertical (paper 2, eqs 1-4, extended).

    Signs: z up, deflections and forces positive in compression. ``gravity`` in m/s^2.
    """

    model: Literal["quarter-car"] = "quarter-car"
    gravity: Acceleration = 9.81
    sprung: Lump
    unsprung: Lump
    strut: Strut
    guide: Guide = Guide()
    tyre: Tyre

    @model_validator(mode="before")
    @classmethod
    def _stop_belongs_to_the_strut(cls, table: Any) -> Any:
        if isinstance(table, dict) and "bump_stop" in table and isinstance(table.get("strut"), dict):
            table = dict(table)
            table["strut"] = {"bump_stop": table.pop("bump_stop"), **table["strut"]}
        return table


RIGS: dict[str, type[Rig]] = {"quarter-car": QuarterCar}
