"""Read number columns from text files with ``name [unit]`` headers; errors name file, line and column."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import compress
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError, ResourceError, at_line, below, nearest
from jounce.core.files import existing_file, reading
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.plain_rows import parse_plain_rows
from jounce.core.text import is_number, unguard_formula
from jounce.core.types import Array
from jounce.core.units import LARGEST, conversion_factor, is_unit, is_unit_of
from jounce.core.waiting import Stage, report_work

_DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+(?:[eE][+-]?\d+)?")
_SEPARATOR_NAMES = {",": "comma", ";": "semicolon", "\t": "tab", " ": "blank"}
_LONGEST_CELL = 1000  # characters: longer cells are neither names nor numbers
_BLANK = "all cells of the column are empty"
_MISSING = frozenset(
    (
        "",
        "-",
        "--",
        "---",
        "nan",
        "-nan",
        "nan(ind)",
        "-nan(ind)",
        "1.#qnan",
        "-1.#ind",
        "-1.#ind00",
        "1.#qnan0",
        "n/a",
        "n.a.",
        "na",
        "<na>",
        "nat",
        "#n/a",
        "#nv",
        "null",
        "none",
    )
)
"""Texts of loggers and spreadsheets for a missing sample, in any case."""
NO_NUMBER = "No cell of the column is a number."
_SINGLE_LETTERS = set("msNgGVAWJK%°")
"""One-letter units that are recognised after a name as in ``Force (N)``: ``(L)`` and ``(R)`` are sides."""


@dataclass(frozen=True, eq=False)
class Column:
    """One column of a file: finite numbers as written, in the ``unit`` of the header (empty without one).

    A column with cells that are not finite numbers has no values but a ``fault``, which is raised when it is used.
    ``written`` is the header's cell if it differs from ``label``: ``Force (N)``. ``part`` has the rows (from 0) with a
    number, and these numbers, if the other rows are empty: a channel with a different rate, or with gaps.
    """

    name: str
    unit: str
    values: Array
    file: str = ""
    fault: RecordingError | None = None
    written: str = ""
    part: tuple[NDArray[np.intp], Array] | None = None

    @property
    def label(self) -> str:
        """Header in its standard form: ``name [unit]``, or only the name without a unit."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    @property
    def where(self) -> str:
        """File and column, as errors name them."""
        return f"{self.file}: column {self.label!r}" if self.file else f"column {self.label!r}"

    @property
    def is_empty(self) -> bool:
        """Whether no cell of the column is a number."""
        return self.fault is not None and (
            self.fault.what == _BLANK or self.fault.hint == NO_NUMBER
        )

    def readable(self) -> Column:
        """Return the column itself; raise its fault if it has one."""
        if self.fault is not None:
            raise self.fault
        return self

    def in_si(self, si: str) -> Array:
        """Return the values in ``si`` (e.g. ``"m"``; ``"1"``: plain numbers); refuse a missing or incompatible unit."""
        self.readable()
        if not self.unit and si != "1":
            raise RecordingError(
                "the header has no unit",
                where=self.where,
                allowed=Phrase(
                    "'{name} [{si}]' or a unit that converts to it", name=self.name, si=si
                ),
            )
        return self.times(conversion_factor(self.unit, si, where=self.where))

    def times(self, factor: float) -> Array:
        """Return the values times a factor; refuse impossible sizes, whose squares overflow."""
        with np.errstate(over="ignore"):
            values = np.asarray(self.readable().values * factor, dtype=float)
            most = max(
                float(np.fmax.reduce(values, initial=0.0)),
                -float(np.fmin.reduce(values, initial=0.0)),
            )
        if LARGEST < most < math.inf:  # NaN and infinities are refused by their row
            size = f"{most / abs(factor):g} {self.unit}".rstrip()
            raise RecordingError("an impossible value", where=self.where, found=size)
        return values


@dataclass(frozen=True, eq=False)
class ColumnTable:
    """Columns of one file in order, accessed by position or name; all have the same length of at least one row.

    ``comments`` are the lines before the header that start with ``#``, without the ``#``. ``lines`` has the line number
    of each row in a text file, from 1; ``place`` is the word for such a line. ``remarks`` list interpretations that may
    be wrong. A column that cannot be read raises an error only when it is used.
    """

    columns: tuple[Column, ...]
    comments: tuple[str, ...] = ()
    file: str = ""
    lines: Sequence[int] = ()
    remarks: tuple[Finding, ...] = ()
    place: str = "line"

    def __iter__(self) -> Iterator[Column]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __getitem__(self, key: int | str) -> Column:
        if isinstance(key, int):
            return self.columns[key].readable()
        by_label = [column for column in self.columns if key in (column.label, column.written)]
        matches = by_label or [column for column in self.columns if key == column.name]
        if any(
            other.unit != matches[0].unit or not np.array_equal(other.values, matches[0].values)
            for other in matches[1:]
        ):
            raise RecordingError(
                Phrase("{count} columns are named {key!r}", count=len(matches), key=key),
                where=self.file,
                found=", ".join(column.label for column in matches),
                hint="Rename or remove all but one of them.",
            )
        if matches:
            return matches[0].readable()
        raise RecordingError(
            Phrase("no column {key!r}", key=key),
            where=self.file,
            found=", ".join(column.label for column in self.columns),
            hint=next(
                (
                    f"R replaced signs by points; map the column with its unit: {key} = '{name} [UNIT]'."
                    for name in self.names
                    if name.startswith(f"{key}..")
                ),
                nearest(key, self.names),
            ),
        )

    @property
    def names(self) -> tuple[str, ...]:
        """Names without units, in file order."""
        return tuple(column.name for column in self.columns)

    def name_row(self, row: int) -> str:
        """Return the name of a row (from 0) for error messages: its line (or ``place``) if known."""
        return f"{self.place} {self.lines[row]}" if self.lines else f"row {row + 1}"


def read_columns_csv(path: Path | str) -> ColumnTable:
    r"""Read a text file of number columns separated by commas, semicolons, tabs or blanks.

    The first line that is neither empty nor a ``#`` comment is the header: one ``name [unit]`` per column, or
    ``name (unit)``, ``name / unit``, ``name in unit`` if that is a known unit. The units may also be in a separate line
    below the names. Text that a logger writes before the header (make, date, settings) is skipped, with a remark.
    Trailing separators are accepted. If commas are not the separator and the file has no decimal points, they are read
    as decimal commas, with a remark.

    Returns raw numbers (not converted), all finite, and the comments before the header. A column with text, a blank or
    NaN keeps its fault, which is raised when the column is used. Raises RecordingError with the line for a missing,
    empty or binary file, a missing header, rows of different lengths, and decimal commas that are also separators.

    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "spring.csv"
    >>> _ = file.write_text("Weg [mm];Kraft (N);Zeit\n0;0;12:00\n10;227,3;12:01\n")
    >>> table = read_columns_csv(file)
    >>> table.names, table["Kraft"].unit, float(table["Weg"].in_si("m")[1]), table.remarks[0].message
    (('Weg', 'Kraft', 'Zeit'), 'N', 0.01, 'decimal commas were read as decimal points')
    """
    return columns_in(text_of(Path(path)), Path(path))


def columns_in(text: str, file: Path, named: int = 0) -> ColumnTable:
    r"""Read number columns of a text as :func:`read_columns_csv` does; ``file`` is its origin, for messages.

    If the names of ``named`` columns are given separately, the text may have no header.

    >>> columns_in("time [s]\tforce [N]\n0.0\t200.0\n", Path("run.xlsx"))["force"].values.tolist()
    [200.0]
    """
    table = _read_in_bulk(text, file, named)
    if table is None:
        _check_memory(len(text), file, _MEMORY_A_BYTE)
        table, _ = _read_rows(text, file, named)
    return table


_HEAD = 2000  # lines that are read row by row before all rows are read in bulk


def _read_in_bulk(text: str, file: Path, named: int) -> ColumnTable | None:
    """Read a long text of plain numbers; None for other texts, of which any row may decide what the others mean."""
    end = 0
    for _ in range(_HEAD):
        end = text.find("\n", end) + 1
        if not end:
            return None
    lines = text[:end].splitlines(keepends=True)
    try:
        head, separator = _read_rows(text[:end], file, named)
    except RecordingError:
        return None
    codes = {remark.code for remark in head.remarks}
    if (
        not isinstance(head.lines, range)  # there are blank lines
        or len(head.lines) < _FEW
        or "core.clock" in codes
        or any(column.fault or column.part for column in head)
    ):
        return None
    first, share = head.lines[0], 0.0

    def follow(now: float) -> None:
        nonlocal share
        share = now

    def reading_stage() -> Stage:
        percent = 100.0 * share
        return Stage(
            "reading {file}: {percent:.0f} %", share=share, file=file.name, percent=percent
        )

    with report_work(reading_stage):
        rows = parse_plain_rows(
            text[sum(map(len, lines[: first - 1])) :], len(head), separator, follow
        )
    if rows is None or rows.has_commas is codes.isdisjoint(_OF_COMMAS):
        return None
    for position, values in enumerate(rows.columns):
        if _may_have_thousands(values):
            cells = [_cells(line, separator)[position] for line in lines[first - 1 :]]
            if all(_GROUPED.fullmatch(cell) for cell in cells if _has_mark(cell)):
                return None
    columns = tuple(
        replace(column, values=values) for column, values in zip(head, rows.columns, strict=True)
    )
    remarks = head.remarks
    if rows.is_cut_off:
        remarks += (finding("core.cut_off", str(file)),)
    lines_of_rows = range(first, first + rows.columns[0].size)
    return replace(head, columns=columns, lines=lines_of_rows, remarks=remarks)


def _read_rows(text: str, file: Path, named: int) -> tuple[ColumnTable, str]:
    """Read number columns of a text row by row, and the separator of its cells."""
    lines = text.splitlines()
    comments, first = _leading_comments(lines)
    if first == len(lines):
        raise RecordingError(
            "the file is empty", where=str(file), allowed="a header 'name [unit], ...' and rows"
        )
    _check_width(lines[first : first + _LONGEST_PREAMBLE], file, first + 1)
    remarks: tuple[Finding, ...] = ()
    if in_comment := _names_in_comment(lines, first):
        first, lines[in_comment[0]] = in_comment
        comments, remarks = comments[:-1], (finding("core.names_in_comment", str(file)),)
    bare = _separator_of_numbers(lines[first], named)
    start = first - 1 if bare else _header_line(lines, first)
    rows, numbers = _without_blank_lines(lines[start + 1 :], start + 2)
    separator = bare or _separator_of(lines[start], rows[0] if rows else "")
    try:
        written = (
            [f"column {i + 1}" for i in range(named)]
            if bare
            else _header_cells(lines[start], separator)
        )
        header = [unguard_formula(cell) for cell in written]
        _check_header(header, file, start + 1, separator, named)
        if (
            rows
            and all(row.startswith('"') for row in rows)
            and len(_cells(rows[0], separator)) == len(header) + 1
        ):
            header = ["", *header]  # a table written by R, with row names
        units = _units_below(rows, header, separator)
        if units:
            rows, numbers = rows[1:], numbers[1:]
        if not rows:
            raise RecordingError("a header but no rows of numbers", where=at_line(file, start + 1))
        columns, understood = _columns(rows, numbers, header, units, file, separator)
        remarks += understood
        if not text.endswith(("\n", "\r")) and _is_cut_off(rows, separator):
            remarks += (finding("core.cut_off", str(file)),)
    except csv.Error as error:
        raise RecordingError(
            Phrase("not a table ({error})", error=str(error)), where=str(file)
        ) from None
    if start > first:
        remarks = (finding("core.header_below", str(file), kind="line", number=start + 1), *remarks)
    return ColumnTable(columns, comments, str(file), numbers, remarks), separator


def read_comments_csv(path: Path | str) -> tuple[str, ...]:
    r"""Read the ``#`` lines before the header of a text file, without the ``#``; the rest of the file is not checked.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "lane.csv"
    >>> _ = file.write_text("# axle = 'front'\n\ntime [s], force [N]\n0, ?")
    >>> read_comments_csv(file)
    ("axle = 'front'",)
    """
    return _leading_comments(text_of(Path(path)).splitlines())[0]


def parse_header(header: str) -> list[tuple[str, str]]:
    """Split ``"displacement [mm], force [N]"`` into names and units (empty without one).

    Examples
    --------
    >>> parse_header("displacement [mm], force [N], slip")
    [('displacement', 'mm'), ('force', 'N'), ('slip', '')]
    """
    return [name_and_unit(cell) for cell in header.split(_separator(header))]


_LEAST_MEMORY_A_BYTE, _MEMORY_A_BYTE = 6, 25
"""Bytes of memory for each byte of a text file while it is read: of plain numbers, and of any other."""


def _check_memory(size: int, file: Path, a_byte: int) -> None:
    """Refuse a text that does not fit into memory, if its size is known: it would crash the process or the machine."""
    try:
        meminfo = Path("/proc/meminfo").read_text(encoding="ascii")
        free = 1024 * int(meminfo.partition("MemAvailable:")[2].split()[0])
    except (OSError, ValueError, IndexError):
        return
    if size * a_byte > free:
        raise ResourceError(
            "the file needs more memory than is available",
            where=str(file),
            found=f"{size / 1e9:.3g} GB of text, {size * a_byte / 1e9:.3g} GB while it is read",
            allowed=Phrase("{free:.3g} GB", free=free / 1e9),
            hint="Export fewer channels or a part of the record, or a binary format (.mf4, .tdms, .parquet, .mat).",
        )


_DOS_END, _SECTOR = b"\x1a", 512
"""DOS end-of-file mark after the last line, repeated up to a multiple of this many bytes."""


def text_of(file: Path) -> str:
    """Return the text of a file of columns; refuse binary or missing files and files larger than the memory."""
    size = existing_file(file, RecordingError).stat().st_size
    _check_memory(size, file, _LEAST_MEMORY_A_BYTE)
    with reading(file, RecordingError):
        content = file.read_bytes()
    if (
        _DOS_END in content[-_SECTOR:]
        and _DOS_END in content[len(content.rstrip(_DOS_END + b"\0\r\n\t ")) :]
    ):
        content = content.rstrip(_DOS_END + b"\0\r\n\t ") + b"\n"
    wide = content.startswith((b"\xff\xfe", b"\xfe\xff"))
    text = content.decode("utf-16", errors="replace") if wide else ""
    if "\0" in text if wide else b"\0" in content:
        raise RecordingError(
            "not a text file",
            where=str(file),
            allowed="columns separated by comma, semicolon or tab",
        )
    if wide:
        return text
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        western = content.decode("cp1252", errors="replace")
        return (
            content.decode("cp1250", errors="replace")
            if _SIGN_IN_A_WORD.search(western)
            else western
        )


_SIGN_IN_A_WORD = re.compile(r"[A-Za-z][¹³¿£¥ª¯][A-Za-z]")
"""Western code-page signs within a word: Polish letters of the Central European code page (k¹t, ko³o)."""


def _is_cut_off(rows: Sequence[str], separator: str) -> bool:
    """Whether there are other rows, and the last number of the last row is shorter than in all of them."""
    *lengths, last = (len(row) - row.rfind(separator) for row in rows)
    return len(lengths) > 9 and last < min(lengths)


def _leading_comments(lines: list[str]) -> tuple[tuple[str, ...], int]:
    """Comments before the header, and the header's index (``len(lines)`` without one)."""
    comments = []
    for index, line in enumerate(lines):
        if line.lstrip().startswith("#"):
            comments.append(line.lstrip()[1:].strip())
        elif line.strip():
            return tuple(comments), index
    return tuple(comments), len(lines)


def _names_in_comment(lines: list[str], first: int) -> tuple[int, str] | None:
    """Line and text of the last comment, if it names the columns of the following numbers, as written by NumPy."""
    places = [i for i in range(first) if lines[i].lstrip().startswith("#")]
    if not places or not _BEGINS_WITH_NUMBER.match(lines[first].lstrip()):
        return None
    text = lines[places[-1]].strip(" \t#")
    separator = _separator_of(text, lines[first])
    names, numbers = _row(text, separator), _row(lines[first], separator)
    is_header = (
        len(names) == len(numbers) > 1 and _are_names(names) and all(map(_has_number, numbers))
    )
    return (places[-1], text) if is_header else None


_LONGEST_PREAMBLE = 200  # lines
_MOST_COLUMNS = 10_000  # each header is searched for a unit


def _check_width(lines: list[str], file: Path, first: int) -> None:
    """Refuse a table with too many columns before its headers are searched for units."""
    for number, line in enumerate(lines, first):
        cells = max(len(line.split()), *(line.count(mark) + 1 for mark in ",;\t"))
        if cells > _MOST_COLUMNS:
            hint = "Export fewer channels, or a binary format (.mf4, .tdms, .parquet, .mat)."
            where, allowed = (
                at_line(file, number),
                Phrase("up to {most_columns}", most_columns=_MOST_COLUMNS),
            )
            raise RecordingError(
                "too many columns", where=where, found=f"{cells}", allowed=allowed, hint=hint
            )


def _separator_of_numbers(line: str, count: int) -> str:
    """Return the separator of a line of ``count`` numbers; empty for other lines."""
    if not count:
        return ""
    rows = ((mark, _row(line.strip(), mark)) for mark in ("\t", ";", ",", " "))
    return next(
        (mark for mark, row in rows if len(row) == count and all(map(_has_number, row))), ""
    )


def _header_line(lines: list[str], first: int) -> int:
    """Index of the header: names with units, or names directly above the first row of numbers; else the first line.

    Settings of a logger are not a header, even if they have as many cells as there are columns (``Rate;1000``).
    """
    filled = [
        i
        for i in range(first, min(first + _LONGEST_PREAMBLE, len(lines)))
        if lines[i].strip(" \r\ufeff")
    ]
    likely = None
    for place, index in enumerate(filled[:-1]):
        below = [lines[i] for i in filled[place + 1 : place + 3]]
        separator = _separator_of(lines[index], below[-1])
        cells = _row(lines[index], separator)
        if len(cells) > 1 and all(map(_has_number, cells)):
            break
        rows = [_row(line, separator, len(cells)) for line in below]
        if not rows[0] or not _are_names(cells) or _are_units(cells):
            continue
        if any(unit and is_unit(unit) for _, unit in map(name_and_unit, cells)):
            return index
        row = rows[-1] if _are_units(rows[0]) else rows[0]
        are_numbers = any(map(_has_number, row)) and all(
            _has_number(cell) or _is_missing(cell) for cell in row
        )
        if len(cells) > 1 and are_numbers:
            return index
        if likely is None and any(map(_has_number, row)):
            likely = index
    return first if likely is None else likely


def _row(line: str, separator: str, width: int | None = None) -> list[str]:
    """Cells of a line without an empty last cell; no cells if their number is not ``width``."""
    try:
        cells = _header_cells(line, separator)
    except csv.Error:
        return []
    if cells and cells[-1] == "" and len(cells) != width:
        cells = cells[:-1]
    return cells if width in (None, len(cells)) else []


def _has_number(cell: str) -> bool:
    return is_number(cell) or _DECIMAL_COMMA.fullmatch(cell) is not None


def _are_names(cells: list[str]) -> bool:
    """Whether cells can name columns: all have letters, none is a number, and all except times differ."""
    worded = all(any(map(str.isalpha, cell)) and not _has_number(cell) for cell in cells)
    names = [cell for cell in cells if not names_time(name_and_unit(cell)[0])]
    return bool(cells) and worded and len(set(names)) == len(names)


_TIME_WORDS = re.compile(
    r"(?:x?time|zeit|timestamp|temps|tiempo|tempo|czas|tid|tijd|t)(?:[ _.:-]?\d.*|[ _.:-].+)?",
    re.IGNORECASE,
)


def names_time(name: str) -> bool:
    """Whether a column's name begins with a word for time, as the names of several clocks in a file do.

    >>> [names_time(name) for name in ("time", "Zeit 2", "Time_100Hz", "t", "Time - AI 1", "lap time", "tyre.force")]
    [True, True, True, True, True, False, False]
    """
    return _TIME_WORDS.fullmatch(name.strip()) is not None


def time_column(columns: Iterable[Column]) -> Column | None:
    """Return the column that is the time: named ``time``, else by a word for it or by its unit; one that ascends first.

    >>> import numpy as np
    >>> lap, clock = (Column(name, "s", np.array(v)) for name, v in (("Lap Time", [1.0, 0.0]), ("Time", [0.0, 1.0])))
    >>> time_column([lap, clock]).name, time_column([lap]).name, time_column([])
    ('Time', 'Lap Time', None)
    """
    usable = [column for column in columns if column.fault is None]
    named = next((column for column in usable if column.name == "time"), None)
    if named is not None:
        return named
    timed = [
        column
        for column in usable
        if (column.unit and is_unit_of(column.unit, "s"))
        or (names_time(column.name) and not column.unit)
    ]
    ascending = (column for column in timed if bool(np.all(np.diff(column.values) > 0.0)))
    return next(ascending, timed[0] if timed else None)


def _is_missing(cell: str) -> bool:
    return cell.lower() in _MISSING


def _are_units(cells: list[str]) -> bool:
    """Whether cells are a row of units: no cell is a number, and most of the non-empty cells are known units."""
    filled = [bare for cell in cells if (bare := cell.strip("[]() ")) not in _NO_UNIT]
    known = sum(map(_is_plain_unit, filled))
    return 2 * known > len(filled) and not any(
        _BEGINS_WITH_NUMBER.match(cell) for cell in filled if not _is_plain_unit(cell)
    )


_NO_UNIT = ("", "-", "#")


def _is_plain_unit(cell: str) -> bool:
    """Whether a cell is a unit; foreign number formats (``1.5d+00``: days?), ``ch1`` and ``V2`` are not."""
    if _NUMBERED_NAME.fullmatch(cell):
        return False
    return is_unit(cell) and (
        cell == "1" or cell.startswith("1/") or not _BEGINS_WITH_NUMBER.match(cell)
    )


_BEGINS_WITH_NUMBER = re.compile(r"[-+]?\d")
_NUMBERED_NAME = re.compile(r"(?!(?:[cm]?m|in|ft|s)[23]$)[A-Za-z]+\d+")
"""Channel names that would parse as powers of units: chains, volts, ares; areas, volumes and s2 are units."""


def _separator(header: str) -> str:
    outside = re.sub(r"\[[^\[\]]*\]|\([^()]*\)|\"[^\"]*\"", "", header)
    return next((mark for mark in ("\t", ";", ",") if mark in outside), ",")


def _separator_of(header: str, row: str) -> str:
    """Separator of a table: blanks if the header has no other separator and the row has several numbers."""
    separator = _separator(header)
    outside = re.sub(r"\[[^\[\]]*\]|\([^()]*\)|\"[^\"]*\"", "", header)
    if separator != "," or "," in outside or '"' in outside:
        return separator
    cells = _cells(row, " ")
    return (
        " " if len(cells) > 1 and all(is_number(cell.replace(",", ".")) for cell in cells) else ","
    )


def _cells(line: str, separator: str) -> list[str]:
    if separator == " " and '"' not in line:
        return line.split()
    return [
        cell.strip()
        for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True))
    ]


def _header_cells(line: str, separator: str) -> list[str]:
    if separator != " " or '"' in line:
        return _cells(line, separator)
    wide = re.split(r"\s{2,}", line.strip())
    return (
        wide if len(wide) > 1 else re.findall(r"[^\s\[(]+(?:\s?\[[^\[\]]*\]|\s?\([^()]*\))?", line)
    )


def name_and_unit(cell: str) -> tuple[str, str]:
    """Split one header into its name and its unit (empty without one).

    >>> [name_and_unit(text) for text in ("force [N]", "Force (kN)", "Weg / mm", "Weg in mm", "Force (L)", "x_F(:,1)")]
    [('force', 'N'), ('Force', 'kN'), ('Weg', 'mm'), ('Weg', 'mm'), ('Force (L)', ''), ('x_F(:,1)', '')]
    """
    text = cell.strip()
    if text.endswith("]") and "[" in text:
        name, _, unit = text[:-1].rpartition("[")
        return name.strip(), unit.strip()
    if text.endswith(".") and ".." in text:
        return _of_r(text)
    if text.endswith(")") and "(" in text:
        name, _, unit = text[:-1].rpartition("(")
        name = name.strip().removesuffix("/")
    else:
        name, _, unit = max(
            (text.rpartition(mark) for mark in (" / ", " in ")), key=lambda part: len(part[0])
        )
    name, unit = name.strip(), unit.strip()
    return (name, unit) if name and _is_loose_unit(unit) else (text, "")


def _of_r(text: str) -> tuple[str, str]:
    """Name and unit of a header in which R replaced signs by points (``make.names``); no unit if it is ambiguous.

    >>> [_of_r(text) for text in ("sprung.az..m.s.2.", "strut.force..N.", "rate..N.mm.")]
    [('sprung.az', 'm/s^2'), ('strut.force', 'N'), ('rate..N.mm.', '')]
    """
    splits = (
        (text[: mark.start()], text[mark.start() + 2 : -1])
        for mark in re.finditer(r"(?=\.\.)", text)
    )
    return next(
        ((name, _UNITS_OF_R[unit]) for name, unit in splits if name and unit in _UNITS_OF_R),
        (text, ""),
    )


_USUAL = (
    "m,cm,mm,km,in,ft,s,sec,ms,us,min,N,kN,lbf,kg,g,mg,Hz,kHz,rad,deg,mrad,rpm,V,mV,A,mA,W,kW,J,kJ,Pa,kPa,MPa,bar,"
    "m/s,cm/s,mm/s,km/h,mph,in/s,ft/s,m/s^2,mm/s^2,m/s2,m s^-1,m s^-2,m s-1,m/s^3,rad/s,deg/s,rad/s^2,deg/s^2,1/s,"
    "1/m,N s/m,N s/mm,kN s/m,Ns/m,Ns/mm,Nm,kNm,Nm/rad,Nm/deg,N m/rad,N m/deg,N m s/rad"
)
_UNITS_OF_R = {re.sub("[^A-Za-z0-9]", ".", unit): unit for unit in _USUAL.split(",")}
"""Units by their spelling in R, if it is unique (unlike that of ``N/mm`` and ``N mm``)."""


def _is_loose_unit(text: str) -> bool:
    """Whether a text outside square brackets can only be a unit."""
    return bool(text) and (text in _SINGLE_LETTERS if len(text) == 1 else is_unit(text))


def _check_header(header: list[str], file: Path, line: int, separator: str, named: int) -> None:
    where = at_line(file, line)
    if any(len(cell) > _LONGEST_CELL for cell in header):
        raise RecordingError(
            "a cell of the header is too long",
            where=where,
            allowed=Phrase("{longest_cell} characters", longest_cell=_LONGEST_CELL),
        )
    if all(is_number(cell) or _DECIMAL_COMMA.fullmatch(cell) for cell in header if cell):
        written, allowed = separator.join(header), "'name [unit]' for every column"
        if named:
            raise RecordingError(
                Phrase(
                    "the given header names {named} columns, but the file has {count}",
                    named=named,
                    count=len(header),
                ),
                where=where,
                found=written,
            )
        hint = "Write the header above the numbers, or give all names in order: columns = 'time [s], force [N]'."
        raise RecordingError(
            "the header is missing", where=where, found=written, allowed=allowed, hint=hint
        )


def _units_below(rows: Sequence[str], header: list[str], separator: str) -> list[str]:
    """Units of the columns if they are in the first row (and not in the header); otherwise empty."""
    if not rows or any(name_and_unit(cell)[1] for cell in header):
        return []
    cells = [cell.removeprefix("[").removesuffix("]").removeprefix("(").removesuffix(")").strip() for cell in
             _cells(rows[0], separator)]  # fmt: skip
    if len(cells) != len(header) or not _are_units(cells):
        return []
    return ["" if cell in _NO_UNIT else cell for cell in cells]


def _without_blank_lines(lines: list[str], first: int) -> tuple[list[str], Sequence[int]]:
    """Non-blank lines, and their numbers; ``first`` is the number of the first line."""
    filled = [bool(line.strip(" \r\ufeff")) for line in lines]
    if all(filled):
        return lines, range(first, first + len(lines))
    return list(compress(lines, filled)), list(compress(range(first, first + len(lines)), filled))


def _plain_numbers(lines: list[str], width: int, separator: str) -> Array | None:
    """Parse rows of finite numbers without quotes or faults; None for other rows, which are read cell by cell."""
    try:
        values = np.loadtxt(
            lines, delimiter=None if separator == " " else separator, comments=None, ndmin=2
        )
    except ValueError:
        return None
    return values if values.shape == (len(lines), width) and np.isfinite(values).all() else None


def _columns(
    rows: list[str],
    lines: Sequence[int],
    header: list[str],
    units: list[str],
    file: Path,
    separator: str,
) -> tuple[tuple[Column, ...], tuple[Finding, ...]]:
    """Columns of all rows, and remarks on their interpretation; refuse rows whose length differs from the header."""
    heads = header[:-1] if header[-1] == "" else header
    values, comma = _plain_numbers(rows, len(heads), separator), False
    if values is None and all(_is_quoted(row, len(heads)) for row in rows):
        values = _plain_numbers([row.replace('"', "") for row in rows], len(heads), separator)
    if values is None and separator != "," and not any("." in row for row in rows):
        values = _plain_numbers([row.replace(",", ".") for row in rows], len(heads), separator)
        comma = values is not None and any("," in row for row in rows)
    result: list[Array | RecordingError] = []
    parts: dict[int, tuple[NDArray[np.intp], Array] | None] = {}
    clocks: dict[int, str] = {}
    if values is not None:
        result = [np.ascontiguousarray(column) for column in values.T]
    else:
        table = _table(
            [_cells(line, separator) for line in rows], lines, heads, header, file, separator
        )
        marks = [_decimal_mark(column) for column in table]
        mixed = (
            _mixed_marks(table, lines, heads, file) if {",", "."} <= set("".join(marks)) else None
        )
        comma = mixed is None and "," in marks
        for position, (cells, head, mark) in enumerate(zip(table, heads, marks, strict=True)):
            name, unit = (head, units[position]) if units else name_and_unit(head)
            clock = (
                seconds_of(cells) if not mark and (names_time(name) or unit in ("", "s")) else None
            )
            if clock is not None:
                clocks[position] = clock[1]
                result.append(clock[0])
                continue
            numbers, part = _numbers(cells, lines, f"column {head!r}", file, comma)
            parts[position] = None if mixed is not None and mark else part
            result.append(mixed if mixed is not None and mark else numbers)
    for position, numbers in enumerate(result):
        if not isinstance(numbers, RecordingError) and _may_have_thousands(numbers):
            cells = [_cells(line, separator)[position] for line in rows]
            fault = _thousands(cells, lines, f"{file}: column {heads[position]!r}")
            result[position] = numbers if fault is None else fault
    cells = (
        [cell for line in rows[:_FEW] for cell in _cells(line, separator) if "," in cell]
        if comma
        else []
    )
    are_grouped = len(cells) >= _FEWEST_THOUSANDS and all(
        _GROUPED.fullmatch(cell) for cell in cells
    )
    if (
        are_grouped and separator == ","
    ):  # in quotes: files separated by commas seldom have decimal commas
        some = [_cells(line, separator) for line in rows[:_FEW]]
        marked = {i for i in range(len(heads)) if any("," in row[i] for row in some)}
        fault = _either(repr(cells[0]), str(file))
        result = [fault if i in marked else column for i, column in enumerate(result)]
        comma = False
    columns = []
    for position, (head, numbers) in enumerate(zip(heads, result, strict=True), 1):
        name, unit = (head, units[position - 1]) if units else name_and_unit(head)
        fault = numbers if isinstance(numbers, RecordingError) else None
        if not name:
            if fault is not None and fault.what == _BLANK:
                continue
            what = Phrase("column {position} has no name", position=position)
            name, fault = (
                f"column {position}",
                RecordingError(what, where=str(file), found=head, allowed="'name [unit]'"),
            )
        written = head if head not in (name, f"{name} [{unit}]") else ""
        samples = (
            numbers if fault is None and not isinstance(numbers, RecordingError) else np.empty(0)
        )
        if position - 1 in clocks:
            unit = "s"
            written = head if head != f"{name} [s]" else ""
        unit = "" if unit == "-" else unit
        columns.append(
            Column(name, unit, samples, str(file), fault, written, parts.get(position - 1))
        )
    remarks = []
    if comma:
        remarks.append(finding(_OF_COMMAS[are_grouped], str(file)))
    if units:
        remarks.append(finding("core.units_below", str(file), kind="line"))
    remarks += [
        finding("core.clock", str(file), name=heads[k], clock=clock) for k, clock in clocks.items()
    ]
    return tuple(columns), tuple(remarks)


_OF_COMMAS = ("core.decimal_commas", "core.commas_or_thousands")
_OF_DAY = re.compile(r"(?:(\d{1,6}) days? \+?)?(\d{1,2}):(\d{2}):(\d{2}(?:[.,]\d+)?)")
_OF_CALENDAR = re.compile(
    r"(\d{4}-\d{2}-\d{2}[T ]\d{2}:\d{2}:\d{2})([.,]\d+)?(?:(Z)|([+-]\d{2})(?::?(\d{2}))?)?"
)
_DAY = 86400.0


def seconds_of(cells: Sequence[str]) -> tuple[Array, str] | None:
    """Convert clock times to seconds since the first, with a description of the interpretation; None for other cells.

    Times of day (``23:59:59.75``) may pass midnight, durations may include days (``0 days 00:00:01``), and ISO 8601
    instants with a time zone are compared in UTC.

    >>> seconds_of(["23:59:59.75", "00:00:00.25"])
    (array([0. , 0.5]), 's since 23:59:59.75, past midnight')
    >>> seconds_of(["2026-03-29T01:59:59+01:00", "2026-03-29T03:00:01+02:00"])
    (array([0., 2.]), 's since 2026-03-29T01:59:59+01:00')
    """
    if not cells:
        return None
    if _OF_DAY.fullmatch(cells[0]):
        times = [_OF_DAY.fullmatch(cell) for cell in cells]
        parts = [time.groups() for time in times if time is not None]
        if len(parts) < len(cells) or any(int(h) > 24 or int(m) > 59 for _, h, m, _ in parts):
            return None
        seconds = np.array(
            [_DAY * int(d or 0) + 3600 * int(h) + 60 * int(m) for d, h, m, _ in parts], dtype=float
        )
        seconds += np.array([s.replace(",", ".") for *_, s in parts], dtype=float)
        nights = np.concatenate(([0], np.cumsum(np.diff(seconds) < -0.5 * _DAY)))
        since = f"s since {cells[0]}" + (", past midnight" if nights[-1] else "")
        return np.asarray(seconds - seconds[0] + _DAY * nights, dtype=float).round(9), since
    if not _OF_CALENDAR.fullmatch(cells[0]):
        return None
    instants = [_OF_CALENDAR.fullmatch(cell) for cell in cells]
    fields = [instant.groups(default="") for instant in instants if instant is not None]
    has_zone = {bool(utc or hours) for _, _, utc, hours, _ in fields}
    if len(fields) < len(cells) or len(has_zone) > 1:
        return None
    try:
        whole = np.array(
            [base.replace(" ", "T") for base, *_ in fields], dtype="datetime64[s]"
        ).astype(np.int64)
    except ValueError:  # the 31st of February
        return None
    zones = [
        60 * (60 * int(hours or 0) + int(f"{hours[:1]}{minutes or 0}"))
        for *_, hours, minutes in fields
    ]
    whole -= np.array(zones, dtype=np.int64)
    parts_of_second = np.array(
        [(part or "0").replace(",", ".") for _, part, *_ in fields], dtype=float
    )
    elapsed = np.asarray(
        (whole - whole[0]) + (parts_of_second - parts_of_second[0]), dtype=float
    ).round(9)
    return elapsed, f"s since {cells[0]}"


_FEWEST_THOUSANDS = 10  # that many numbers with three decimals are no coincidence
_FEW = 1000  # rows examined for digit separators
_GROUPED = re.compile(r"[+-]?[1-9]\d{0,2}[.,]\d{3}")


def _may_have_thousands(numbers: Array) -> bool:
    """Whether numbers look like 999, 1.000, 1.001: integers up to 999, and numbers from 1 with three decimals."""
    size = np.abs(numbers)
    if not size.size or float(size.max()) > 999.9995 or float(size.max()) < 100.0:
        return False
    broken = size != np.floor(size)
    grouped = size[broken]
    if grouped.size < _FEWEST_THOUSANDS or grouped.min() < 1.0 or not size[~broken].size:
        return False
    return bool(np.abs(grouped * 1e3 - np.round(grouped * 1e3)).max() < 1e-6 * 1e3)


def _thousands(cells: Sequence[str], lines: Sequence[int], where: str) -> RecordingError | None:
    """Error for numbers whose marks all precede three digits, in a column with integers below a thousand."""
    marked = [(cell, line) for cell, line in zip(cells, lines, strict=True) if _has_mark(cell)]
    if not marked or not all(_GROUPED.fullmatch(cell) for cell, _ in marked):
        return None
    cell, line = marked[0]
    return _either(f"{cell!r} (line {line})", where, ", and other cells are whole numbers")


def _is_quoted(row: str, cells: int) -> bool:
    """Whether each cell of a row has its own pair of quotes, so that it may be read without them."""
    return row.count('"') == 2 * cells and '""' not in row


def _has_mark(cell: str) -> bool:
    return "." in cell or "," in cell


def _either(cell: str, where: str, more: str = "") -> RecordingError:
    return RecordingError(
        "thousands separators, or decimals?",
        where=where,
        found=f"{cell}: all marks are followed by three digits{more}",
        allowed="numbers without thousands separators",
        hint="Export the file without them, or with decimals in all numbers.",
    )


def _table(
    rows: list[list[str]],
    lines: Sequence[int],
    heads: list[str],
    header: list[str],
    file: Path,
    separator: str,
) -> list[list[str]]:
    """Cells by column; empty cells after the last column are accepted."""
    width = len(heads)
    for row, line in zip(rows, lines, strict=True):
        if len(row) != width and not (len(row) == width + 1 and row[-1] == ""):
            raise _ragged_row_error(row, header, at_line(file, line), separator)
    return [[row[position] for row in rows] for position in range(width)]


def _mark_of(cell: str) -> str:
    """Decimal mark of a number; empty without one, or for text."""
    if "," in cell and _DECIMAL_COMMA.fullmatch(cell):
        return ","
    return "." if "." in cell and is_number(cell) else ""


def _decimal_mark(cells: list[str]) -> str:
    """Decimal mark of a column of numbers, ``,.`` if it has both; empty without one, or for text."""
    if not any("," in cell for cell in cells):
        return "." if any(map(_mark_of, cells)) else ""
    return "".join(sorted(set(map(_mark_of, cells))))


def _mixed_marks(
    table: list[list[str]], lines: Sequence[int], heads: list[str], file: Path
) -> RecordingError:
    """Error for a file with decimal commas and decimal points, either of which may be thousands separators."""
    first: dict[str, str] = {}
    for head, cells in zip(heads, table, strict=True):
        for cell, line in zip(cells, lines, strict=True):
            if mark := _mark_of(cell):
                first.setdefault(mark, f"{cell!r} (line {line}, column {head!r})")
    return RecordingError(
        "decimal commas and decimal points in one file",
        where=str(file),
        found=f"{first[',']} and {first['.']}",
        allowed="one of them",
        hint="Are the points thousands separators? Export the file without them.",
    )


def _numbers(
    cells: list[str], lines: Sequence[int], column: str, file: Path, comma: bool
) -> tuple[Array | RecordingError, tuple[NDArray[np.intp], Array] | None]:
    """Finite numbers of a column, or the error for its first fault with the line; and the rows with numbers."""
    texts = (
        [cell.replace(",", ".") if _DECIMAL_COMMA.fullmatch(cell) else cell for cell in cells]
        if comma
        else cells
    )
    try:
        values = np.array(texts, dtype=float)
    except ValueError:
        values = None
    if values is not None and np.isfinite(values).all() and not any("_" in cell for cell in texts):
        return values, None
    if not any(cells):
        return RecordingError(_BLANK, where=f"{file}: {column}", allowed="numbers"), None
    part = None
    filled = np.flatnonzero([not _is_missing(cell) for cell in texts])
    if 0 < filled.size < len(texts):
        held = [texts[row] for row in filled]
        if all(map(is_number, held)) and np.isfinite(numbers := np.array(held, dtype=float)).all():
            part = filled, numbers
    wrong = next(
        i for i, cell in enumerate(texts) if not is_number(cell) or not math.isfinite(float(cell))
    )
    no_numbers = not any(is_number(cell) for cell in texts)
    fault = _bad_cell(
        cells[wrong], below(at_line(file, lines[wrong]), column), no_numbers=no_numbers
    )
    fault.line = int(lines[wrong])
    return fault, part


def _ragged_row_error(
    row: list[str], header: list[str], where: str, separator: str
) -> RecordingError:
    columns = len(header) - (header[-1] == "")
    if header[-1] == "" and len(row) == len(header):
        mark = _SEPARATOR_NAMES[separator]
        return RecordingError(
            Phrase("the header ends with a {mark} that this row does not have", mark=mark),
            where=where,
            hint=Phrase("Remove the {mark} at the end of the header.", mark=mark),
        )
    halves = separator == "," and len(row) == 2 * columns
    return RecordingError(
        "the row does not have as many cells as the header",
        where=where,
        found=f"{len(row)} cells",
        allowed=Phrase(
            "{columns} cells ({header})", columns=columns, header=", ".join(header[:columns])
        ),
        hint="Decimal commas? Separate the columns by semicolons, or write 1.5, not 1,5."
        if halves
        else "",
    )


def _bad_cell(cell: str, where: str, *, no_numbers: bool) -> RecordingError:
    if cell == "":
        hint = (
            "Fill the cell or remove the row; for signals over time, resample (--resample) bridges the "
            "gap and reports it."
        )
        return RecordingError("the cell is blank", where=where, allowed="a number", hint=hint)
    if _DECIMAL_COMMA.fullmatch(cell):
        return RecordingError(
            "decimal comma",
            where=where,
            found=cell,
            allowed="a decimal point",
            hint=Phrase("Write {cell}.", cell=cell.replace(",", ".")),
        )
    if is_number(cell):
        return RecordingError(
            "not a finite number", where=where, found=cell, hint="Fill the gap or remove the row."
        )
    hint = NO_NUMBER if no_numbers else ""
    return RecordingError(
        "text in a number column", where=where, found=cell[:80], allowed="a number", hint=hint
    )
