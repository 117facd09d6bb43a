"""Notebook display of results and descriptions: a short table with units, and a hint at the remaining content."""

from __future__ import annotations

import dataclasses
import inspect
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from html import escape
from typing import Any

from jounce.core.display import display_unit
from jounce.core.results import marks_of, tables_of
from jounce.core.tables import TextTable
from jounce.core.text import shorten, visible

_FIRST, _LONGEST_CELL, _LONGEST = 20, 160, 8000  # rows; characters of a cell; characters of all
_STYLE = (
    "<style>.jounce{font:13px sans-serif}.jounce table{border-collapse:collapse;margin:.4em 0}"
    ".jounce td,.jounce th{text-align:left;padding:.15em .8em .15em 0;vertical-align:top}"
    ".jounce .n{text-align:right;font-variant-numeric:tabular-nums}.jounce small{opacity:.7}</style>"
)

Row = tuple[str, str, str]  # name, value, unit or description


class Shown:
    """Mix-in for objects that a notebook shows as a table; text is never interpreted as markup."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        kind: Any = type(self)
        if not marks_of(kind):
            return html_table(kind.__name__, _summary(kind), list(_rows(self)), _more(self))
        tables = list(tables_of(self))
        titles = [(kind.__name__, _summary(kind)), *((table.title, "") for table in tables[1:])]
        longest = _LONGEST // len(tables)
        return "".join(
            html_table(
                *title, list(map(tuple, table.rows)), _more(self), table.header, longest=longest
            )
            for title, table in zip(titles, tables, strict=True)
        )

    def __str__(self) -> str:
        if hasattr(type(self), "model_fields"):
            return super().__str__()
        if marks_of(type(self)):
            return "\n\n".join(map(str, tables_of(self)))
        return str(
            TextTable(type(self).__name__, ("field", "value", ""), list(_rows(self)), (0, 1, 2))
        )


def html_table(
    title: str,
    subtitle: str,
    rows: Sequence[Sequence[str]],
    more: str,
    header: Sequence[str] = (),
    *,
    longest: int = _LONGEST,
) -> str:
    """Write a table with a title, of at most ``longest`` characters; a note counts omitted rows and how to get them.

    Examples
    --------
    >>> "&lt;b&gt;" in html_table("<b>", "", [("mass", "16", "kg")], "see to_dict()")
    True
    """
    for count in range(min(_FIRST, len(rows)), -1, -1):
        left = len(rows) - count
        note = f"… and {left} more: {more}" if left else f"more: {more}"
        body = "".join(
            f"<tr>{''.join(_cells(row, right=bool(header)))}</tr>" for row in rows[:count]
        )
        head = f"<tr>{''.join(f'<th>{_text(word)}</th>' for word in header)}</tr>" if header else ""
        text = (
            f'{_STYLE}<div class="jounce"><strong>{_text(title)}</strong> {_text(subtitle)}<table>{head}{body}</table>'
            f"<small>{_text(note)}</small></div>"
        )
        if len(text) <= longest:
            break
    return text


def _cells(row: Sequence[str], *, right: bool) -> Iterator[str]:
    for k, cell in enumerate(row):
        if k == 1 and row[2:] == ("",):  # texts span the column of the unit, too
            yield f'<td colspan="2">{_text(cell)}</td>'
            return
        is_number = right and k > 0 and re.match(r"−?\d", cell)
        yield f'<td class="n">{_text(cell)}</td>' if is_number else f"<td>{_text(cell)}</td>"


def _text(text: str) -> str:
    return escape(visible(shorten(text, _LONGEST_CELL)))


def _more(value: Any) -> str:
    return next(
        (f"{name}()" for name in ("parameters", "to_dict") if hasattr(value, name)),
        "its attributes",
    )


@cache
def _summary(kind: Any) -> str:
    """First sentence of the docstring of a class."""
    text = " ".join((inspect.getdoc(kind) or "").partition("\n\n")[0].split())
    return re.sub(r"``?|:\w+:", "", text)


@cache
def _words(kind: Any) -> dict[str, str]:
    """Description of each attribute from the docstring of a class, with the unit."""
    lines = (inspect.getdoc(kind) or "").partition("Attributes\n----------\n")[2].split("\n")
    texts: dict[str, list[str]] = {}
    names: list[str] = []
    for line in lines:
        if line and not line.startswith(" "):
            if set(line) <= {"-"}:  # the next section
                break
            names = [name.strip() for name in line.partition(" :")[0].split(",")]
            texts |= {name: [] for name in names}
        for name in names if line.startswith(" ") else ():
            texts[name].append(line.strip())
    return {name: re.sub(r"``?", "", " ".join(words)) for name, words in texts.items()}


def _rows(value: Any) -> Iterator[Row]:
    """Yield fields with their descriptions; numbers of a description by path, in the current system of units."""
    fields = getattr(type(value), "model_fields", None)
    if fields is not None:
        for name, field in fields.items():
            yield from _field_rows(name, getattr(value, name), field)
        return
    kind: Any = type(value)
    words = _words(kind)
    for attribute in dataclasses.fields(value):
        if not attribute.name.startswith("_"):
            yield (
                attribute.name,
                _brief(getattr(value, attribute.name)),
                words.get(attribute.name, ""),
            )


def _field_rows(path: str, value: Any, field: Any) -> Iterator[Row]:
    from jounce.core.units import Unit

    fields = getattr(type(value), "model_fields", None)
    if fields is not None:
        for name, inner in fields.items():
            yield from _field_rows(f"{path}.{name}", getattr(value, name), inner)
        return
    if value is None or value in ((), "", {}) or path == "schema_":
        return
    units = [item for item in getattr(field, "metadata", ()) if isinstance(item, Unit)]
    units = units or list(_units_in(getattr(field, "annotation", None)))
    if units and isinstance(value, float):
        unit = display_unit(units[0].si, value)
        yield path, number(value * unit.factor), unit.name
    elif (
        units
        and isinstance(value, tuple)
        and value
        and all(isinstance(item, float) for item in value)
    ):
        unit = display_unit(units[0].si, max(map(abs, value)))
        yield path, _series([item * unit.factor for item in value]), unit.name
    else:
        yield path, _brief(value), ""


def _units_in(annotation: Any) -> Iterator[Any]:
    from jounce.core.units import Unit

    for item in getattr(annotation, "__metadata__", ()):
        if isinstance(item, Unit):
            yield item
    for part in getattr(annotation, "__args__", ()):
        yield from _units_in(part)


def number(value: float) -> str:
    """Write a number with five significant digits and a true minus sign."""
    if not math.isfinite(value):
        return "–" if math.isnan(value) else "−∞" if value < 0.0 else "∞"
    return f"{value + 0.0:.5g}".replace("-", "−")


def _series(values: Sequence[float]) -> str:
    return (
        ", ".join(map(number, values))
        if len(values) <= 4
        else f"{number(values[0])} … {number(values[-1])}"
    )


def _brief(value: Any) -> str:
    """Summarise a value in a few words."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if value is None:
        return "–"
    if isinstance(value, str):
        return value
    if isinstance(value, complex):
        return f"{number(value.real)} {'−' if value.imag < 0.0 else '+'} {number(abs(value.imag))}i"
    if isinstance(value, (int, float)) or (
        hasattr(value, "item") and getattr(value, "ndim", 1) == 0
    ):
        return number(float(value)) if not isinstance(value, int) else str(value)
    interval = getattr(value, "interval", None)
    if isinstance(getattr(value, "value", None), float) and interval:
        return f"{number(value.value)} (95 %: {number(interval[0])} to {number(interval[1])})"
    if isinstance(getattr(value, "value", None), float):
        return number(value.value)
    if hasattr(value, "data_vars"):
        return f"{len(value.data_vars)} channels, {', '.join(f'{name}: {size}' for name, size in value.sizes.items())}"
    if hasattr(value, "shape"):
        return f"{' x '.join(map(str, value.shape))} numbers"
    if isinstance(value, Mapping):
        return _join_names([str(name) for name in value])
    if isinstance(value, (list, tuple)):
        if all(isinstance(item, (int, float)) and not isinstance(item, bool) for item in value):
            return _series(value)
        if all(isinstance(item, str) for item in value):
            return _join_names(list(value))
        return f"{len(value)} x {type(value[0]).__name__}"
    return type(value).__name__ if dataclasses.is_dataclass(value) else str(value)


def _join_names(names: list[str]) -> str:
    return (
        ", ".join(names) if len(names) <= 4 else f"{', '.join(names[:3])} and {len(names) - 3} more"
    )


def dataset_html(data: Any) -> str:
    """Write a recording or a sweep as a table of channels with unit and extremes; other data as xarray shows them."""
    import numpy as np

    names = list(data.data_vars)
    if not names or not all("units" in data[name].attrs for name in names):
        return str(data._repr_html_())
    rows: list[Any] = []
    for name in names:
        values = data[name].to_numpy()
        if values.dtype.kind not in "fiu":
            rows.append((str(name), "", "", ""))
            continue
        known = values[np.isfinite(values)]
        low, high = (float(known.min()), float(known.max())) if known.size else (math.nan, math.nan)
        unit = display_unit(
            str(data[name].attrs["units"]), max(abs(low), abs(high)) if known.size else 0.0
        )
        rows.append((str(name), number(low * unit.factor), number(high * unit.factor), unit.name))
    over = []
    for axis, size in data.sizes.items():
        if axis in data.coords and size:
            ends = data[axis].to_numpy()
            unit = display_unit(
                str(data[axis].attrs.get("units", "1")), float(np.abs(ends[[0, -1]]).max())
            )
            first, last = (number(float(end) * unit.factor) for end in (ends[0], ends[-1]))
            over.append(f"{size} values of {axis} from {first} to {last} {unit.name}".rstrip())
    title = "Recording" if "time" in data.sizes else "Sweep"
    more = "jn.plots.show(data) draws it, jn.to_pandas(data) is a table, print(data) lists all"
    return html_table(title, ", ".join(over), rows, more, ("channel", "least", "greatest", "unit"))
