"""What differs between descriptions: values by path, with their units."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pydantic import BaseModel

from jounce.core.description import Description
from jounce.core.display import display_unit
from jounce.core.errors import DescriptionError
from jounce.core.numbers import number
from jounce.core.shown import Shown
from jounce.core.tables import TextTable
from jounce.parts.rig import result_unit_of

_DIGITS = range(4, 13)  # as few as tell two numbers apart
_SAME = 1e-12  # relative: files in other units round differently
_TEXTS = frozenset({"source", "estimated", "schema_"})  # remarks, not values


@dataclass(frozen=True)
class DifferentValue:
    """A value that is not the same in all descriptions.

    Attributes
    ----------
    path : str
        Path of the value, as ``--set`` takes it.
    unit : str
        SI unit of numbers; empty for texts and switches.
    values : tuple of float, str, bool or None
        Value in each description, in their order, numbers in ``unit``; ``None`` where a description has no such value.
    """

    path: str
    unit: str
    values: tuple[float | str | bool | None, ...]

    def cells(self) -> tuple[tuple[str, ...], str]:
        """Write the values in their display unit, with enough digits to tell them apart; and that unit."""
        numbers = [value for value in self.values if isinstance(value, float)]
        shown = display_unit(self.unit, max(map(abs, numbers), default=0.0))
        scaled = [value * shown.factor for value in numbers]
        digits = next((n for n in _DIGITS if _are_apart(scaled, n)), _DIGITS[-1])
        texts = []
        for value in self.values:
            if isinstance(value, float):
                texts.append(number(value * shown.factor, digits))
            elif isinstance(value, bool):
                texts.append("yes" if value else "no")
            else:
                texts.append(value or "–")
        return tuple(texts), shown.name if numbers else ""


def _are_apart(values: Sequence[float], digits: int) -> bool:
    return len({number(value, digits) for value in values}) == len(set(values))


@dataclass(frozen=True)
class DescriptionDifferences(Shown):
    """All values that differ between descriptions.

    Attributes
    ----------
    names : tuple of str
        Names of the descriptions.
    rows : tuple of DifferentValue
        The values that differ, in the order of the descriptions' fields; empty if all are equal.
    """

    names: tuple[str, ...]
    rows: tuple[DifferentValue, ...]

    def __str__(self) -> str:
        return str(self.table()) if self.rows else f"{', '.join(self.names)}: no differences"

    def table(self) -> TextTable:
        """Return a table with a column per description, in display units."""
        cells = ((row.path, row.cells()) for row in self.rows)
        rows = [(path, *values, unit) for path, (values, unit) in cells]
        return TextTable("Differences", ("parameter", *self.names, "unit"), rows)

    def to_dict(self) -> dict[str, Any]:
        """Return names and rows as plain data; numbers in SI units."""
        return {
            "names": list(self.names),
            "rows": [
                {"path": row.path, "unit": row.unit, "values": list(row.values)}
                for row in self.rows
            ],
        }


def compare_descriptions(descriptions: Mapping[str, Description]) -> DescriptionDifferences:
    """List the values that differ between rigs, vehicles or other descriptions.

    Parameters
    ----------
    descriptions : mapping of str to Description
        Two or more descriptions by name: rigs as loaded, changed or updated, vehicles, trials, campaigns.

    Returns
    -------
    DescriptionDifferences
        Paths, SI units and values; ``print`` writes a table in display units. ``source`` and ``estimated``, which
        are remarks, are not compared. Numbers that agree to 12 digits are equal: files in other units round
        differently.

    Raises
    ------
    DescriptionError
        For fewer than two descriptions, or anything that is not a description.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("kart-quarter-car")
    >>> stiff = rig.with_changes({"strut.spring.rate": "25 N/mm"})
    >>> heavy = stiff.with_changes({"sprung.mass": "60 kg"})
    >>> print(jn.compare_descriptions({"as it is": rig, "stiff": stiff, "heavy": heavy}))
    Differences
    parameter          as it is  stiff  heavy  unit
    ─────────────────  ────────  ─────  ─────  ────
    sprung.mass           16.00  16.00  60.00    kg
    strut.spring.rate     22.73  25.00  25.00  N/mm
    """
    if len(descriptions) < 2:
        raise DescriptionError(
            "there is nothing to compare",
            where="descriptions",
            found=len(descriptions),
            allowed="at least two descriptions",
        )
    for name, description in descriptions.items():
        if not isinstance(description, Description):
            raise DescriptionError(
                "not a description",
                where=name,
                found=description,
                allowed="a rig, a vehicle, a trial or a campaign",
                hint="Load files: jn.load(file).",
            )
    values = {name: dict(_values(each)) for name, each in descriptions.items()}
    paths = dict.fromkeys(path for each in values.values() for path in each)
    rows = []
    for path in paths:
        row = tuple(each.get(path) for each in values.values())
        if any(not _is_same(row[0], other) for other in row[1:]):
            owner = next(name for name, each in values.items() if path in each)
            is_numeric = any(isinstance(value, float) for value in row)
            unit = result_unit_of(descriptions[owner], path) if is_numeric else ""
            rows.append(DifferentValue(path, unit, row))
    return DescriptionDifferences(tuple(descriptions), tuple(rows))


def _values(value: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the values of a description by path, without remarks."""
    if isinstance(value, BaseModel):
        for name in type(value).model_fields:
            if path or name not in _TEXTS:
                yield from _values(getattr(value, name), f"{path}.{name}" if path else name)
    elif isinstance(value, Mapping):
        for name, item in value.items():
            yield from _values(item, f"{path}.{name}")
    elif isinstance(value, tuple | list):
        for i, item in enumerate(value):
            yield from _values(item, f"{path}[{i}]")
    elif value is not None:
        yield path, value if isinstance(value, bool | float | str) else _plain(value)


def _plain(value: Any) -> float | str:
    return float(value) if isinstance(value, int) else str(value)


def _is_same(one: Any, other: Any) -> bool:
    if isinstance(one, float) and isinstance(other, float):
        return abs(one - other) <= _SAME * max(abs(one), abs(other))
    return bool(one == other) and type(one) is type(other)
