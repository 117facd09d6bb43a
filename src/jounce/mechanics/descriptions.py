"""Descriptions: frozen classes that say what a mechanism is made of, and whose numbers become parameters of its model.

A field that is a quantity says so (``place()``, ``direction()``, ``quantity(unit)``). A description as it is written
holds numbers, texts with a unit, or expressions of parameters; once a mechanism has taken it, symbols of parameters
``<name>.<field>``. Everything a mechanism lists of itself is read from these fields.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import MISSING, dataclass, field, fields, replace
from typing import Any, ClassVar, Protocol, Self

import casadi as ca

from jounce.mechanics.bodies import Body
from jounce.mechanics.equations import Track

Number = float | str | ca.SX
"""A number in SI, text with a unit, or an expression of parameters."""
Vector = Sequence[float | str] | ca.SX
"""Three numbers in SI or texts with a unit, or three expressions of parameters."""
Given = Any
"""A field of a description: numbers as they are written, symbols (casadi.SX) once a mechanism has taken it."""
Plain = str | float | bool | list[Any] | dict[str, Any] | None
"""What a file of JSON can hold."""


class Numbers(Protocol):
    """What makes parameters of numbers: a mechanism."""

    def number(self, path: str, value: Number, unit: str = "1") -> ca.SX:
        """Symbol of a number."""

    def vector(self, path: str, value: Vector, unit: str = "m") -> ca.SX:
        """Symbols of three numbers."""

    def direction(self, path: str, value: Vector) -> ca.SX:
        """Unit vector along three numbers."""


def quantity(unit: str, default: Any = MISSING) -> Any:
    """Say that a field is a number in ``unit``; ``{length}`` and ``{force}`` in it are filled in by the description."""
    return field(default=default, metadata={"read": "number", "unit": unit})


def place(default: Any = MISSING, *, unit: str = "m") -> Any:
    """Say that a field is three numbers: a place in the design pose (m), or as many numbers in another unit."""
    return field(default=default, metadata={"read": "vector", "unit": unit})


def direction() -> Any:
    """Say that a field is a direction in the design pose, of any length."""
    return field(metadata={"read": "direction", "unit": "1"})


@dataclass(frozen=True, eq=False)
class Description:
    """Something a mechanism is made of, with a name."""

    name: str
    kind: ClassVar[str] = ""
    """What it is, in a word."""

    def units(self) -> dict[str, str]:
        """What to fill into the units of the fields."""
        return {}

    def with_symbols(self, numbers: Numbers) -> Self:
        """The same with symbols of parameters in place of its numbers."""
        made: dict[str, Any] = {}
        for each in fields(self):
            value, read = getattr(self, each.name), each.metadata.get("read")
            if read and value is not None and not isinstance(value, Track):
                path, unit = f"{self.name}.{each.name}", each.metadata["unit"].format(**self.units())
                made[each.name] = (
                    numbers.direction(path, value) if read == "direction" else getattr(numbers, read)(path, value, unit)
                )
        return replace(self, **made)

    def check(self) -> None:
        """Refuse numbers that make no sense together; called on the description as it is written."""

    def listed(self, evaluate: Callable[[ca.SX], Plain]) -> dict[str, Plain]:
        """Name, kind, bodies, numbers and their units as plain data; ``evaluate`` gives the numbers of symbols."""
        units: dict[str, Plain] = {}
        found: dict[str, Plain] = {"name": self.name, "kind": self.kind, "units": units}
        for each in fields(self):
            value = getattr(self, each.name)
            if isinstance(value, Body):
                found[each.name] = value.name
            elif isinstance(value, Track):
                found[each.name] = value.value.name()
            elif each.name == "on":
                found[each.name] = value
            elif "read" in each.metadata and isinstance(value, ca.SX):
                found[each.name] = evaluate(value)
                units[each.name] = each.metadata["unit"].format(**self.units())
        return found
