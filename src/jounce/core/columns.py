"""Number columns from text files: ``name [unit]`` headers, errors that name file, line and column."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import compress
from pathlib import Path

import numpy as np

from jounce.core.errors import RecordingError, nearest
from jounce.core.files import existing_file
from jounce.core.types import Array
from jounce.core.units import conversion_factor

_HEADER = re.compile(r"^\s*(.*?)\s*(?:\[\s*([^\]]*?)\s*\])?\s*$")
_DECIMAL_COMMA = re.compile(r"^\s*[+-]?\d+,\d+(?:[eE][+-]?\d+)?\s*$")
_SEPARATOR_NAMES = {",": "comma", ";": "semicolon", "\t": "tab"}


@dataclass(frozen=True)
class Column:
    """One column of a file: numbers as written, all finite, in the ``unit`` of the header (empty for none)."""

    name: str
    unit: str
    values: Array
    file: str = ""

    @property
    def label(self) -> str:
        """Header as written: ``name [unit]``, or the bare name without a unit."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    @property
    def where(self) -> str:
        """File and column, as errors name them."""
        return f"{self.file}: column {self.label!r}" if self.file else f"column {self.label!r}"

    def in_si(self, si: str) -> Array:
        """Give the values in ``si`` (e.g. ``"m"``; ``"1"`` for plain numbers); refuse a missing or unfitting unit."""
        if not self.unit and si != "1":
            raise RecordingError(
                "the header has no unit",
                where=self.where,
                allowed=f"'{self.name} [{si}]' or a unit that converts to it",
            )
        return self.values * conversion_factor(self.unit, si, where=self.where)


@dataclass(frozen=True)
class ColumnTable:
    """Columns of one file in their order, found by position or by name: all of the same length, at least one row.

    ``comments`` are the lines before the header that start with ``#``, without it; ``lines`` the line of each row in a
    text file, from 1.
    """

    columns: tuple[Column, ...]
    comments: tuple[str, ...] = ()
    file: str = ""
    lines: Sequence[int] = ()

    def __iter__(self) -> Iterator[Column]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __getitem__(self, key: int | str) -> Column:
        if isinstance(key, int):
            return self.columns[key]
        for column in self.columns:
            if key in (column.name, column.label):
                return column
        raise RecordingError(
            f"no column {key!r}",
            where=self.file,
            found=", ".join(column.label for column in self.columns),
            hint=nearest(key, self.names),
        )

    @property
    def names(self) -> tuple[str, ...]:
        """Names without units, in file order."""
        return tuple(column.name for column in self.columns)

    def name_row(self, row: int) -> str:
        """Name a row (from 0) for error messages: by its line where there is one."""
        return f"line {self.lines[row]}" if self.lines else f"row {row + 1}"


def read_columns_csv(path: Path | str) -> ColumnTable:
    r"""Read a text file of number columns separated by commas, semicolons or tabs.

    The first line that is neither empty nor a ``#`` comment is the header: one ``name [unit]`` per column. A trailing
    separator is accepted only when the header and every row have it. Numbers use a decimal point.

    Gives raw numbers (not converted), all finite, and the comments before the header. A RecordingError with the line
    refuses a missing, empty or binary file, a missing header, text or a blank or NaN in a number column, rows of
    different lengths, trailing separators and decimal commas.

    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "spring.csv"
    >>> _ = file.write_text("displacement [mm], force [N]\n0, 0\n10, 227.3\n")
    >>> table = read_columns_csv(file)
    >>> table.names, table["force"].unit, float(table["displacement"].in_si("m")[1])
    (('displacement', 'force'), 'N', 0.01)
    """
    file = Path(path)
    lines = _text_of(file).splitlines()
    comments, start = _leading_comments(lines)
    if start == len(lines):
        raise RecordingError("the file is empty", where=str(file), allowed="a header 'name [unit], ...' and rows")
    separator = _separator(lines[start])
    header = _cells(lines[start], separator)
    _check_header(header, file, start + 1, separator)
    rows, numbers = _without_blank_lines(lines[start + 1 :], start + 2)
    if not rows:
        raise RecordingError("a header but no rows of numbers", where=f"{file}, line {start + 1}")
    values = _plain_numbers(rows, len(header), separator)
    if values is None:
        values = _values([_cells(line, separator) for line in rows], numbers, header, file, separator)
    names = [name_and_unit(cell) for cell in header[: values.shape[1]]]
    columns = tuple(
        Column(name, unit, np.ascontiguousarray(column), str(file))
        for (name, unit), column in zip(names, values.T, strict=True)
    )
    return ColumnTable(columns, comments, str(file), numbers)


def read_comments_csv(path: Path | str) -> tuple[str, ...]:
    r"""Read the ``#`` lines before the header of a text file, without the ``#``; the rest may be anything.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "lane.csv"
    >>> _ = file.write_text("# axle = 'front'\n\ntime [s], force [N]\n0, ?")
    >>> read_comments_csv(file)
    ("axle = 'front'",)
    """
    return _leading_comments(_text_of(Path(path)).splitlines())[0]


def parse_header(header: str) -> list[tuple[str, str]]:
    """Split ``"displacement [mm], force [N]"`` into names and units (empty where there is none).

    Examples
    --------
    >>> parse_header("displacement [mm], force [N], slip")
    [('displacement', 'mm'), ('force', 'N'), ('slip', '')]
    """
    return [name_and_unit(cell) for cell in header.split(_separator(header))]


def _text_of(file: Path) -> str:
    content = existing_file(file, RecordingError).read_bytes()
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return content.decode("utf-16", errors="replace")
    if b"\0" in content:
        raise RecordingError("not a text file", where=str(file), allowed="columns separated by comma, semicolon or tab")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace")


def _leading_comments(lines: list[str]) -> tuple[tuple[str, ...], int]:
    """Comments before the header, and the header's index (``len(lines)`` when there is none)."""
    comments = []
    for index, line in enumerate(lines):
        if line.lstrip().startswith("#"):
            comments.append(line.lstrip()[1:].strip())
        elif line.strip():
            return tuple(comments), index
    return tuple(comments), len(lines)


def _separator(header: str) -> str:
    outside = re.sub(r"\[[^\]]*\]|\"[^\"]*\"", "", header)
    return next((mark for mark in ("\t", ";", ",") if mark in outside), ",")


def _cells(line: str, separator: str) -> list[str]:
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True))]


def name_and_unit(cell: str) -> tuple[str, str]:
    """Split one header ``"force [N]"`` into its name and its unit (empty where there is none)."""
    match = _HEADER.match(cell)
    return (match[1], match[2] or "") if match else (cell, "")


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return "_" not in cell


def _check_header(header: list[str], file: Path, line: int, separator: str) -> None:
    where = f"{file}, line {line}"
    if all(_is_number(cell) or _DECIMAL_COMMA.match(cell) for cell in header if cell):
        raise RecordingError(
            "the header is missing", where=where, found=separator.join(header), allowed="'name [unit]' for every column"
        )
    named = header[:-1] if header[-1] == "" else header
    seen: set[str] = set()
    for position, cell in enumerate(named, 1):
        name, _ = name_and_unit(cell)
        if not name:
            raise RecordingError(f"column {position} has no name", where=where, found=cell, allowed="'name [unit]'")
        if name in seen:
            raise RecordingError(f"two columns are named {name!r}", where=where, hint="Rename or remove one of them.")
        seen.add(name)


def _without_blank_lines(lines: list[str], first: int) -> tuple[list[str], Sequence[int]]:
    """Lines with something on them, and their numbers; ``first`` is the number of the first line."""
    filled = [bool(line.strip(" \r\ufeff")) for line in lines]
    if all(filled):
        return lines, range(first, first + len(lines))
    return list(compress(lines, filled)), list(compress(range(first, first + len(lines)), filled))


def _plain_numbers(lines: list[str], width: int, separator: str) -> Array | None:
    """Rows of finite numbers without quotes and without faults; None for all others, which are read cell by cell."""
    try:
        values = np.loadtxt(lines, delimiter=separator, comments=None, ndmin=2)
    except ValueError:
        return None
    return values if values.shape == (len(lines), width) and np.isfinite(values).all() else None


def _values(rows: list[list[str]], lines: Sequence[int], header: list[str], file: Path, separator: str) -> Array:
    """Numbers of all rows, shape (rows, columns); the first thing wrong is raised with its line."""
    trailing = header[-1] == ""
    for row, line in zip(rows, lines, strict=True):
        if len(row) != len(header) or (trailing and row[-1] != ""):
            raise _ragged(row, header, f"{file}, line {line}", separator)
    width = len(header) - trailing
    kept = [row[:width] for row in rows]
    try:
        values = np.array(kept, dtype=float)
    except ValueError:
        values = None
    if values is None or not np.isfinite(values).all() or any("_" in cell for row in kept for cell in row):
        raise _first_bad_cell(kept, lines, header, file)
    return values


def _ragged(row: list[str], header: list[str], where: str, separator: str) -> RecordingError:
    columns = len(header) - (header[-1] == "")
    mark = _SEPARATOR_NAMES[separator]
    if len(row) == len(header) + 1 and row[-1] == "":
        return RecordingError(
            f"the row ends with a {mark} that the header does not have",
            where=where,
            hint=f"Remove the {mark} at the end of the rows.",
        )
    if header[-1] == "":
        return RecordingError(
            f"the header ends with a {mark} that this row does not have",
            where=where,
            hint=f"Remove the {mark} at the end of the header.",
        )
    halves = separator == "," and len(row) == 2 * columns
    return RecordingError(
        "the row does not have as many cells as the header",
        where=where,
        found=f"{len(row)} cells",
        allowed=f"{columns} cells ({', '.join(header[:columns])})",
        hint="Decimal commas? Write 1.5, not 1,5." if halves else "",
    )


def _first_bad_cell(rows: list[list[str]], lines: Sequence[int], header: list[str], file: Path) -> RecordingError:
    for order, (row, line) in enumerate(zip(rows, lines, strict=True)):
        for position, cell in enumerate(row):
            if not _is_number(cell) or not math.isfinite(float(cell)):
                where = f"{file}, line {line}: column {header[position]!r}"
                return _bad_cell(cell, where, is_first=order == 0 and not any(_is_number(c) for c in row))
    raise AssertionError("no bad cell in rows that could not be read")


def _bad_cell(cell: str, where: str, *, is_first: bool) -> RecordingError:
    if cell == "":
        return RecordingError("the cell is blank", where=where, allowed="a number", hint="Fill it or remove the row.")
    if _DECIMAL_COMMA.match(cell):
        return RecordingError(
            "decimal comma", where=where, found=cell, allowed="a decimal point", hint=f"Write {cell.replace(',', '.')}."
        )
    if _is_number(cell):
        return RecordingError("not a finite number", where=where, found=cell, hint="Fill the gap or remove the row.")
    hint = "Units belong into the header, as 'name [unit]'." if is_first else ""
    return RecordingError("text in a number column", where=where, found=cell, allowed="a number", hint=hint)
