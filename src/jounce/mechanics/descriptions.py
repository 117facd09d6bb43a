"""Descriptions: frozen classes for the parts of a mechanism; their numbers become parameters of its model.

A field declares its kind of quantity: ``place()``, ``direction()``, ``quantity(unit)``, or ``law(unit)`` for a law or a
moving point. A user's description contains numbers, texts with a unit, or expressions of parameters. When a mechanism
adds it, these become symbols of parameters ``<name>.<field>``. The mechanism's listing and its checks of changed
numbers are derived from these fields.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, dataclass, field, fields, replace
from typing import Any, ClassVar, Protocol, Self, TypeAlias

import casadi as ca
import numpy as np

from jounce.core.errors import AssemblyError
from jounce.core.types import Array
from jounce.mechanics.bodies import Body, BodyPoint
from jounce.mechanics.equations import Track
from jounce.mechanics.frames import Moving

Number: TypeAlias = float | str | ca.SX
"""A number in SI units, text with a unit, or an expression of parameters."""
Vector: TypeAlias = Sequence[float | str] | ca.SX
"""Three numbers in SI units or texts with a unit, or three expressions of parameters."""
Given = Any
"""A field of a description: numbers as given, or symbols (casadi.SX) after a mechanism has added it."""
Plain = str | float | bool | list[Any] | dict[str, Any] | None
"""Content of a JSON file."""
Write = Callable[[ca.SX], Plain]
"""Function that writes an expression: its values if it depends on parameters only, else a dict with its text."""
Known = Callable[[str], Array]
"""Function that returns the current values of a field, NaN if unknown."""


class Numbers(Protocol):
    """An object that turns numbers into parameters, such as a mechanism."""

    def number(self, path: str, value: Number, unit: str = "1") -> ca.SX:
        """Symbol of a number."""

    def vector(self, path: str, value: Vector, unit: str = "m") -> ca.SX:
        """Return the symbols of three numbers."""

    def direction(self, path: str, value: Vector) -> ca.SX:
        """Return the unit vector along three numbers."""


def quantity(
    unit: str, default: Any = MISSING, *, above: float | None = None, at_least: float | None = None
) -> Any:
    """Declare a field that is a number in ``unit``, with its limits.

    ``{length}`` and ``{force}`` in the unit are filled in by the description.
    """
    bounds = {"above": above, "at_least": at_least}
    return field(default=default, metadata={"read": "number", "unit": unit, **bounds})


def place(default: Any = MISSING, *, unit: str = "m", at_least: float | None = None) -> Any:
    """Declare a field of three numbers: a position in the design pose (m), or numbers in a different unit."""
    return field(default=default, metadata={"read": "vector", "unit": unit, "at_least": at_least})


def direction() -> Any:
    """Declare a field that is a direction in the design pose, of any length."""
    return field(metadata={"read": "direction", "unit": "1"})


def law(unit: str, default: Any = MISSING) -> Any:
    """Declare a field that is an expression of moving quantities, or a moving point, in ``unit``."""
    return field(default=default, metadata={"law": True, "unit": unit})


@dataclass(frozen=True, eq=False)
class NamedPart:
    """A named part of a mechanism."""

    name: str
    kind: ClassVar[str] = ""
    """Kind of part, in one word."""
    positive: ClassVar[str] = ""
    """Direction of a positive force, if the part has a force."""

    def units(self) -> dict[str, str]:
        """Return values for placeholders in the units of the fields."""
        return {}

    def defaults(self) -> dict[str, ca.SX]:
        """Return default values of fields that were not given."""
        return {}

    def with_symbols(self, numbers: Numbers) -> Self:
        """Return the description with its numbers replaced by symbols of parameters."""
        symbols: dict[str, Any] = {}
        for each in fields(self):
            value, read = getattr(self, each.name), each.metadata.get("read")
            if (
                read
                and not isinstance(value, Track)
                and (value is not None or each.default is MISSING)
            ):
                path, unit = f"{self.name}.{each.name}", self._unit(each.metadata)
                symbols[each.name] = (
                    numbers.direction(path, value)
                    if read == "direction"
                    else getattr(numbers, read)(path, value, unit)
                )
        return replace(self, **symbols)

    def check(self, known: Known) -> None:
        """Refuse impossible numbers; called when the part is created and when numbers change."""
        for each in fields(self):
            limits = [(word, each.metadata.get(word)) for word in ("above", "at_least")]
            for word, limit in limits:
                if limit is None or getattr(self, each.name) is None:
                    continue
                values, unit = known(each.name), self._unit(each.metadata)
                if np.any(values <= limit if word == "above" else values < limit):
                    shown = ", ".join(f"{part:g}" for part in np.atleast_1d(values))
                    raise AssemblyError(
                        "out of range",
                        where=f"{self.name}.{each.name}",
                        found=f"{shown} {unit}",
                        allowed=f"{word.replace('_', ' ')} {limit:g} {unit}",
                    )

    def to_plain(self, write: Write) -> dict[str, Plain]:
        """Return name, kind, bodies, numbers, laws and their units as plain data."""
        units: dict[str, Plain] = {}
        result: dict[str, Plain] = {"name": self.name, "kind": self.kind, "units": units}
        if self.positive:
            result["positive"] = self.positive
        defaults = self.defaults()
        for each in fields(self):
            value, key = getattr(self, each.name), each.name
            if value is None and key in defaults:
                value = defaults[key]
                result["as_designed"] = [
                    *(name for name in defaults if getattr(self, name) is None)
                ]
            if key == "name":
                continue
            if isinstance(value, Body):
                result[key] = value.name
            elif isinstance(value, Track):
                result[key] = value.value.name()
            elif "unit" in each.metadata and value is not None:
                result[key], units[key] = write(_value_to_list(value)), self._unit(each.metadata)
            elif key in ("on", "joint"):
                result[key] = value
        return result

    def _unit(self, metadata: Mapping[str, Any]) -> str:
        unit: str = metadata["unit"]
        return unit.format(**self.units())


def _value_to_list(value: ca.SX | Moving) -> ca.SX:
    """Return the value of a field for listing; for a point of a body its position in the design pose."""
    if isinstance(value, BodyPoint):
        return value.design
    return value.value if isinstance(value, Moving) else value
