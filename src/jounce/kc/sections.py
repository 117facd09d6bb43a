"""Tables of a rig's files: one for each file, sheet, struct or block of rows, with its title."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from jounce.core.columns import ColumnTable, columns_in, text_of
from jounce.core.errors import RecordingError
from jounce.core.files import existing_file
from jounce.core.workbooks import sheets_of
from jounce.recordings.reader import ReaderOptions
from jounce.recordings.readers import read_signals, reader_of

_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|[.,]\d+|\d+,\d+)(?:[eE][+-]?\d+)?")
_NUMBERS_ONLY = re.compile(r"[-+.,;\s\deE]*")
_LARGEST_WORKBOOK = 300_000_000  # bytes when unpacked


@dataclass(frozen=True)
class Section:
    """A table of a file.

    Attributes
    ----------
    title : str
        Name of its sheet, struct or block; empty if the file is one table.
    table : ColumnTable
        Its columns, as written.
    preamble : str
        Lines of text above the columns.
    """

    title: str
    table: ColumnTable
    preamble: str = ""

    @property
    def names(self) -> tuple[str, ...]:
        """Names that may tell the test: title, lines of text above the columns, name of the file."""
        lines = reversed(self.preamble.splitlines())
        return *filter(None, (self.title, *lines)), Path(self.table.file).stem

    @property
    def place(self) -> str:
        """File and section, as messages name them."""
        return f"{self.table.file}: {self.title}" if self.title else self.table.file


def read_sections(path: Path | str) -> Iterator[Section | tuple[str, RecordingError]]:
    """Read every table of a file; a section that cannot be read is its place and error."""
    file = existing_file(path, RecordingError)
    kind = reader_of(file).name
    if kind == "csv":
        yield from _in_text(text_of(file), file)
    elif kind == "excel":
        yield from _by_name(file, _sheets(file))
    elif kind == "mat":
        yield from _by_name(file, _structs(file))
    else:
        yield Section("", read_signals(file, ReaderOptions()).columns)


def _by_name(file: Path, names: list[str]) -> Iterator[Section | tuple[str, RecordingError]]:
    for name in names:
        try:
            table = read_signals(file, ReaderOptions(variable=name)).columns
        except RecordingError as error:
            yield f"{file}: {name}" if name else str(file), error
        else:
            yield Section(name, table, "\n".join(table.comments))


def _sheets(file: Path) -> list[str]:
    """Names of the sheets with numbers; the empty name leaves the choice, and the error, to the reader."""
    try:
        sheets = [
            title
            for title, rows in sheets_of(file, RecordingError, most_bytes=_LARGEST_WORKBOOK)
            if any(isinstance(cell, int | float) for _, row in rows for cell in row)
        ]
    except Exception:  # noqa: BLE001 - the reader reports a damaged workbook in its own words
        return [""]
    return sheets or [""]


def _structs(file: Path) -> list[str]:
    """Names of the structs that hold signals; the empty name for a file without structs."""
    signals = read_signals(file, ReaderOptions())
    names = [*signals.columns.names, *signals.left_out]
    structs = dict.fromkeys(name.rpartition(".")[0] for name in names if "." in name)
    return [*structs] or [""]


@dataclass
class _Block:
    """Lines of a text: those above the numbers, and the numbers with the number of their first line (from 0)."""

    start: int
    above: list[str]
    rows: list[str]


def _in_text(text: str, file: Path) -> Iterator[Section | tuple[str, RecordingError]]:
    blocks = _blocks(text.splitlines())
    if len(blocks) < 2:
        titles, _ = _titles_and_heads(blocks[0]) if blocks else ([], [])
        try:
            yield Section("", columns_in(text, file), "\n".join(titles))
        except RecordingError as error:
            yield str(file), error
        return
    heads: list[str] = []
    for number, block in enumerate(blocks, 1):
        titles, own = _titles_and_heads(block)
        heads = own or heads  # a block without a header has that of the block before
        title = titles[-1] if titles else f"section {number}"
        if not heads:
            yield (
                f"{file}: {title}",
                RecordingError(
                    "rows of numbers without a header",
                    where=f"{file}: {title}",
                    allowed="a header 'name [unit], ...' above them",
                ),
            )
            continue
        blank = "\n" * max(block.start - len(heads), 0)  # errors name the lines of the file
        try:
            table = columns_in("\n".join([blank + heads[0], *heads[1:], *block.rows, ""]), file)
        except RecordingError as error:
            yield f"{file}: {title}", error
        else:
            yield Section(title, table, "\n".join(titles))


def _titles_and_heads(block: _Block) -> tuple[list[str], list[str]]:
    """Split the lines above a block into titles and lines as wide as its rows: names and units."""
    row = block.rows[0]
    least = max(_width(row, row) - 1, 2)
    titles = [line.strip(" #[]\t;,") for line in block.above if _width(line, row) < least]
    return titles, [line for line in block.above if _width(line, row) >= least]


def _blocks(lines: list[str]) -> list[_Block]:
    """Split lines where text follows numbers; blank lines within numbers split nothing."""
    blocks: list[_Block] = []
    above: list[str] = []
    for number, line in enumerate(lines):
        if _is_row(line):
            if above or not blocks:
                blocks.append(_Block(number, above, []))
                above = []
            blocks[-1].rows.append(line)
        elif line.strip(" ;,\t"):
            above.append(line)
    return blocks


def _is_row(line: str) -> bool:
    """Whether a line begins with a number, and at least half of its cells are numbers."""
    if _NUMBERS_ONLY.fullmatch(line):
        return any(map(str.isdigit, line))
    cells = [cell for cell in re.split(r"[;\t\s]+|,(?!\d)|(?<!\d),", line.strip()) if cell]
    numbers = [all(_NUMBER.fullmatch(part) for part in cell.split(",") if part) for cell in cells]
    return bool(cells) and numbers[0] and 2 * sum(numbers) >= len(cells)


def _width(line: str, row: str) -> int:
    """Number of cells of a line, separated as a row of numbers is."""
    separator = next((mark for mark in (";", "\t", ",") if mark in row), None)
    return len(line.split(separator))
