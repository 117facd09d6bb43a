"""Fields of results: label and unit, declared once in the type annotation.

    @dataclass(frozen=True)
    class Fit(Shown):
        rate: Annotated[Estimate, Shows("spring rate", "N/m")]
        nrmse: Annotated[float, Shows("residual, of the force range", "%")]

Terminal, page, notebook and ``print`` show these fields through :func:`fields_of` and :func:`tables_of`.
"""

from __future__ import annotations

import builtins
import inspect
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from jounce.core.display import DisplayUnit, display_unit
from jounce.core.numbers import estimate_cells, number
from jounce.core.tables import TextTable

ESTIMATE = ("quantity", "value", "standard error", "95 % interval", "unit")
"""Header of a table of estimates."""


@dataclass(frozen=True)
class Shows:
    """Annotation of a field: its label and the SI unit of its value, as text or as a function of the result.

    The unit ``%`` shows a ratio as a percentage; texts and counts have an empty unit. A mapping of estimates has one
    unit for each name.
    """

    label: str | Callable[[Any], str]
    unit: str | Callable[[Any], str | Mapping[str, str]] = ""
    digits: int = 4


def own_unit(result: Any) -> str:
    """Return the attribute ``unit`` of a result, for :class:`Shows`."""
    return str(result.unit) or "1"


@dataclass(frozen=True)
class ResultField:
    """One field of a result with its label, SI unit and value."""

    name: str
    label: str
    unit: str
    value: Any
    digits: int = 4

    @property
    def size(self) -> float:
        """Absolute value of a number; 0 for other values."""
        value = getattr(self.value, "value", self.value)
        ends = value if isinstance(value, tuple) else (value,)
        return max((abs(end) for end in ends if isinstance(end, float)), default=0.0)

    def cells(self, shown: DisplayUnit | None = None) -> tuple[str, str, str, str]:
        """Write value, standard error, 95 % interval and unit, in the usual display unit or in a given one."""
        if self.unit == "%":
            return (
                number(None if self.value is None else 100.0 * self.value, self.digits),
                "",
                "",
                "%",
            )
        unit = shown or display_unit(self.unit, self.size)
        if hasattr(self.value, "interval"):
            return estimate_cells(self.value, self.unit, unit)
        if self.value is None:
            return "–", "", "", unit.name
        if self.unit and isinstance(self.value, float):
            return number(self.value * unit.factor, self.digits), "", "", unit.name
        if self.unit and isinstance(self.value, tuple):
            return (
                " to ".join(number(end * unit.factor, self.digits) for end in self.value),
                "",
                "",
                unit.name,
            )
        return _words(self.value), "", "", ""

    def in_words(self) -> str:
        """Write the value with its unit, for use in a sentence."""
        value, _, _, unit = self.cells()
        return f"{value} {unit}".strip()

    def text(self, shown: DisplayUnit | None = None) -> str:
        """Write the value with its interval, without the unit."""
        value, _, interval, _ = self.cells(shown)
        return f"{value} ({interval})" if interval not in ("", "–") else value


def _words(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return number(value)
    return ", ".join(map(str, value)) if isinstance(value, tuple | list) else str(value)


def marks_of(kind: Any) -> Mapping[str, Shows]:
    """Return the marks of a class and its base classes: those of fields, then those of properties."""
    return _marks(kind)


@cache
def _marks(kind: Any) -> Mapping[str, Shows]:
    annotations = [
        (name, annotation, base.__module__)
        for base in reversed(kind.__mro__)
        for name, annotation in (*inspect.get_annotations(base).items(), *_of_properties(base))
    ]
    return {
        name: mark
        for name, annotation, module in annotations
        for mark in _metadata(annotation, module)
        if isinstance(mark, Shows)
    }


def _of_properties(kind: type) -> Iterator[tuple[str, Any]]:
    for name, member in vars(kind).items():
        if isinstance(member, property) and member.fget is not None:
            yield name, member.fget.__annotations__.get("return")


def _metadata(annotation: Any, module: str) -> tuple[Any, ...]:
    """Metadata of an annotation; annotations without a mark are not evaluated."""
    if isinstance(annotation, str):
        if "Shows(" not in annotation:
            return ()
        names = vars(sys.modules[module])
        annotation = eval(annotation, names, _AnnotationNames(names))  # noqa: S307 - our own source
    return getattr(annotation, "__metadata__", ())


class _AnnotationNames(dict[str, Any]):
    """Names of a module; names imported for type checkers only are replaced by a dummy type."""

    def __missing__(self, name: str) -> Any:
        return getattr(builtins, name, _Unknown)


class _Unknowns(type):
    def __getitem__(cls, _: Any) -> Any:
        return cls

    def __or__(cls, _: Any) -> Any:
        return cls

    __ror__ = __or__


class _Unknown(metaclass=_Unknowns):
    """Dummy for a type that is imported for type checkers only."""


def fields_of(result: Any, *names: str) -> list[ResultField]:
    """Return the marked fields of a result, or only the named ones, with their values.

    Examples
    --------
    >>> from jounce.identify.update import UpdatedParameter
    >>> rate = UpdatedParameter(20e3, 22e3, 10.0, (21.5e3, 22.5e3), 15e3, 25e3, False, "N/m")
    >>> [(field.label, field.in_words()) for field in fields_of(rate, "initial", "at_bound")]
    [('start', '20.000 N/mm'), ('at bound', 'no')]
    """
    marks = marks_of(type(result))
    return [field for name in names or marks for field in _fields(name, marks[name], result)]


def _fields(name: str, mark: Shows, result: Any) -> Iterator[ResultField]:
    label, unit = (part(result) if callable(part) else part for part in (mark.label, mark.unit))
    value = getattr(result, name)
    if isinstance(unit, str):
        yield ResultField(name, str(label), unit, value, mark.digits)
        return
    for key, estimate in value.items():
        words = key if "." in key else key.replace("_", " ")  # a path is shown as it is
        yield ResultField(key, f"{words}{label}", unit[key] or "1", estimate)


def tables_of(result: Any) -> Iterator[TextTable]:
    """Write a result as tables: one of its single values, then one for each list, with a row for each item."""
    fields = fields_of(result)
    single = [field for field in fields if not _is_group(field.value)]
    yield fields_table(type(result).__name__, single)
    for field in fields:
        if field not in single and field.value:
            yield group_table(field.label, field.value)


def fields_table(title: str, fields: Sequence[ResultField]) -> TextTable:
    """Write fields that have a value as rows, with columns for their uncertainty if any field has one."""
    known = [field for field in fields if field.value is not None]
    rows = [(field.label, *field.cells()) for field in known]
    if any(hasattr(field.value, "interval") for field in known):
        return TextTable(title, ESTIMATE, rows, (0, 4))
    return TextTable(title, ("quantity", "value", "unit"), [(label, value, unit) for label, value, _, _, unit in rows],
                     (0, 2))  # fmt: skip


def _is_shown(value: Any) -> bool:
    return value is not None and not _is_group(value)


def _is_group(value: Any) -> bool:
    """Whether a value is a list or mapping of results, possibly empty."""
    if not isinstance(value, Mapping | tuple | list):
        return False
    items = list(value.values()) if isinstance(value, Mapping) else list(value)
    return not items or bool(marks_of(type(items[0])))


def group_table(title: str, group: Mapping[str, Any] | Sequence[Any]) -> TextTable:
    """Write several results of one class as a table: one row for each, named by its key or its first field."""
    items = list(group.values()) if isinstance(group, Mapping) else list(group)
    columns = [list(column) for column in zip(*map(fields_of, items), strict=False)]
    columns = [column for column in columns if any(_is_shown(field.value) for field in column)]
    mixed = [column for column in columns if len({field.unit for field in column}) > 1]
    units = [_largest_unit(row) for row in zip(*mixed, strict=True)]
    names = ["", *map(str, group)] if isinstance(group, Mapping) else _column(columns.pop(0), units)
    written = [names, *(_column(column, units if column in mixed else []) for column in columns)]
    texts = [0, *(k for k, column in enumerate(columns, 1) if _is_text(column[0]))]
    if units:
        texts.append(len(written))
        written.append(["unit", *(unit.name for unit in units)])
    header, *rows = zip(*written, strict=True)
    return TextTable(title, header, rows, texts)


def _column(fields: Sequence[ResultField], units: Sequence[DisplayUnit]) -> list[str]:
    """Write one field of several results: its header, and one cell for each result, in a common unit or its own."""
    first = fields[0]
    if units:
        return [first.label, *(field.text(unit) for field, unit in zip(fields, units, strict=True))]
    unit = _largest_unit(fields)
    return [
        unit.label(first.label) if unit.name else first.label,
        *(field.text(unit) for field in fields),
    ]


def _is_text(field: ResultField) -> bool:
    return not field.unit and (
        isinstance(field.value, bool) or not isinstance(field.value, int | float)
    )


def _largest_unit(fields: Sequence[ResultField]) -> DisplayUnit:
    """Usual display unit of the largest of several values."""
    largest = max(fields, key=lambda field: field.size)
    return display_unit(largest.unit, largest.size)
