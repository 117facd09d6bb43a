"""Units at the border: text with a unit in, SI floats inside."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import cache, lru_cache
from numbers import Real
from typing import Annotated, Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from jounce.core.errors import DescriptionError, shown

_NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*$")
_UNIT = re.compile(r"[\w\s*/^().°-]*")
_DIMENSIONLESS = {"", "1", "-"}


@cache
def _registry() -> Any:
    import pint

    try:
        return pint.UnitRegistry(cache_folder=":auto:", autoconvert_offset_to_baseunit=True)
    except OSError:  # no folder that could be written: slower, with the same units
        return pint.UnitRegistry(autoconvert_offset_to_baseunit=True)


@lru_cache(maxsize=512)
def _factor(unit: str, si: str) -> float:
    """Return what one ``unit`` is in ``si``; raise ValueError with the reason when it is none."""
    registry = _registry()
    name = {"%": "percent"}.get(unit, unit).replace("²", "^2").replace("³", "^3").replace("·", "*")
    if not _UNIT.fullmatch(name):  # pint passes over what it does not know, a long minus among it
        raise ValueError(f"{unit!r} is not a unit")
    if unit == "g" and si == "m/s^2":
        name = "standard_gravity"  # pint reads g as gram
    target = registry.Unit(si if si not in _DIMENSIONLESS else "dimensionless")
    try:
        return float(registry.Quantity(1.0, registry.Unit(name)).to(target).magnitude)
    except Exception as error:
        raise ValueError(f"{unit!r} is not a unit of {si if si not in _DIMENSIONLESS else 'a plain number'}") from error


def conversion_factor(unit: str, si: str, *, where: str = "") -> float:
    """Give the SI value of one ``unit``, in ``si`` (``"1"``: a plain number).

    The unit is as the user writes it, e.g. ``"mm"``, ``"N*s/m"``, or ``"g"`` for standard gravity where ``si`` is
    m/s^2. A DescriptionError at the place ``where`` refuses units that are unknown or measure something else.
    """
    try:
        return _factor(unit.strip(), si)
    except ValueError as error:
        raise DescriptionError(
            "wrong unit", where=where, found=unit, allowed=f"a unit that converts to {si}", hint=_unit_hint(unit)
        ) from error


def _unit_hint(unit: str) -> str:
    if re.search(r"[A-Za-z]\.[A-Za-z]", unit):
        return "Write products with * as in N*s/m."
    return "Check spelling and case, e.g. 'mm', 'N/mm', 'N*s/m', 'MPa', 'deg', 'm/s^2'."


def to_si(value: object, si: str, *, where: str = "") -> float:
    """Read one physical value in ``si``: text with its unit (``"22.73 N/mm"``), or a bare number that is already SI.

    A DescriptionError at the place ``where`` refuses a missing or wrong unit, and what is not a finite number.
    """
    if isinstance(value, bool) or not isinstance(value, (Real, str)):
        raise DescriptionError("not a physical value", where=where, found=value, allowed=f"'<number> <unit of {si}>'")
    if not isinstance(value, str):
        try:
            number = float(value)
        except OverflowError:  # an integer of hundreds of digits
            number = math.inf
    else:
        match = _NUMBER.match(value)
        if match is None:
            raise DescriptionError("not a number with a unit", where=where, found=value, allowed=f"'<number> {si}'")
        number = float(match[1])
        if match[2] == "" and si not in _DIMENSIONLESS:
            raise DescriptionError(
                "the unit is missing",
                where=where,
                found=value,
                allowed=f"'{match[1]} {si}' (or a unit that converts to it), or the bare number {match[1]} in SI",
            )
        if match[2]:
            number *= conversion_factor(match[2], si, where=where)
    if not math.isfinite(number):
        raise DescriptionError("not a finite number", where=where, found=value, allowed="a finite number")
    if number != 0.0 and not _SMALLEST <= abs(number) <= _LARGEST:
        allowed = f"0, or a size of {_SMALLEST:g} to {_LARGEST:g} {si}".rstrip(" 1")
        raise DescriptionError("not a size that anything has", where=where, found=value, allowed=allowed)
    return number


_SMALLEST, _LARGEST = 1e-300, 1e30
"""Sizes in SI beyond which nothing of a vehicle lies, and products of a few values are no numbers any more."""


def positive_si(value: object, si: str, *, where: str, zero: bool = False) -> float:
    """Read one physical value as :func:`to_si` does, and refuse those below 0 and (but with ``zero``) 0 itself."""
    number = to_si(value, si, where=where)
    if number < 0.0 or (number == 0.0 and not zero):
        allowed = f"{'at least' if zero else 'above'} 0 {si if si != '1' else ''}".rstrip()
        raise DescriptionError("out of range", where=where, found=value, allowed=allowed)
    return number


@dataclass(frozen=True)
class Unit:
    """Pydantic annotation of a physical field: ``Annotated[float, Unit("m")]`` reads text with units into SI."""

    si: str
    above: float | None = None
    at_least: float | None = None
    at_most: float | None = None

    def _read(self, value: object) -> float:
        try:
            number = to_si(value, self.si)
        except DescriptionError as error:
            raise PydanticCustomError(
                "physical_value",
                "{what}; found {found}; allowed: {allowed}. {hint}",
                {"what": error.what, "found": shown(value), "allowed": error.allowed, "hint": error.hint},
            ) from None
        if not self._is_allowed(number):
            raise PydanticCustomError(
                "out_of_range",
                "out of range; found {found}; allowed: {allowed}",
                {"found": shown(value), "allowed": f"{self._range()} {self.si}"},
            )
        return number

    def _is_allowed(self, number: float) -> bool:
        return (
            (self.above is None or number > self.above)
            and (self.at_least is None or number >= self.at_least)
            and (self.at_most is None or number <= self.at_most)
        )

    def _range(self) -> str:
        bounds = [("above", self.above), ("at least", self.at_least), ("at most", self.at_most)]
        return ", ".join(f"{word} {bound:g}" for word, bound in bounds if bound is not None)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self._read)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return {
            "anyOf": [{"type": "number"}, {"type": "string"}],
            "description": f"text with a unit that converts to {self.si}, or a bare number in {self.si}",
        }


Length = Annotated[float, Unit("m")]
PositiveLength = Annotated[float, Unit("m", above=0.0)]
NonNegativeLength = Annotated[float, Unit("m", at_least=0.0)]
Mass = Annotated[float, Unit("kg", above=0.0)]
PositiveTime = Annotated[float, Unit("s", above=0.0)]
Speed = Annotated[float, Unit("m/s")]
PositiveSpeed = Annotated[float, Unit("m/s", above=0.0)]
Force = Annotated[float, Unit("N")]
NonNegativeForce = Annotated[float, Unit("N", at_least=0.0)]
Stiffness = Annotated[float, Unit("N/m")]
PositiveStiffness = Annotated[float, Unit("N/m", above=0.0)]
DampingCoefficient = Annotated[float, Unit("N*s/m")]
NonNegativeDampingCoefficient = Annotated[float, Unit("N*s/m", at_least=0.0)]
Acceleration = Annotated[float, Unit("m/s^2")]
Angle = Annotated[float, Unit("rad")]
Frequency = Annotated[float, Unit("Hz", above=0.0)]
Pressure = Annotated[float, Unit("Pa", above=0.0)]
Number = Annotated[float, Unit("1")]
PositiveNumber = Annotated[float, Unit("1", above=0.0)]
ProductOfInertia = Annotated[float, Unit("kg*m^2")]
MomentOfInertia = Annotated[float, Unit("kg*m^2", above=0.0)]
NonNegativeStiffness = Annotated[float, Unit("N/m", at_least=0.0)]
PositiveRotationalStiffness = Annotated[float, Unit("N*m/rad", above=0.0)]
NonNegativeRotationalStiffness = Annotated[float, Unit("N*m/rad", at_least=0.0)]
