"""Small tables of texts and numbers, as people type them: text files and the first sheet of a workbook."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

from jounce.core.columns import text_of
from jounce.core.errors import RecordingError
from jounce.core.files import reading
from jounce.core.units import to_si


def cells_of_file(file: Path) -> list[list[str]]:
    """Read the cells of a text file or of the first sheet of a workbook as texts with decimal points."""
    if file.suffix.lower() == ".xlsx":
        from jounce.core.optional import require

        with reading(file, RecordingError):
            book = require("openpyxl", "io").load_workbook(file, read_only=True, data_only=True)
            sheet = book.worksheets[0]
            cells = [
                ["" if cell is None else str(cell) for cell in row]
                for row in sheet.iter_rows(values_only=True)
            ]
    else:
        return cells_of_text(text_of(file))
    return _with_points(cells)


def cells_of_text(text: str) -> list[list[str]]:
    """Split a text at tabs or semicolons if most of its lines have them, else at commas."""
    lines = [line for line in text.splitlines() if line.strip()]
    separator = next(
        (mark for mark in ";\t" if 2 * sum(mark in line for line in lines) > len(lines)), ","
    )
    return _with_points(list(csv.reader(io.StringIO(text), delimiter=separator)))


def _with_points(cells: list[list[str]]) -> list[list[str]]:
    return [[re.sub(r"(?<=\d),(?=\d)", ".", cell) for cell in row] for row in cells]


def si_of_cell(cell: str, unit: str, si: str, where: str) -> float:
    """Read a number of a table in SI: its unit is that of the cell, else that of the heading, else SI.

    >>> si_of_cell("50", "mm/s", "m/s", "row 2"), si_of_cell("0.2", "", "m/s", "row 3")
    (0.05, 0.2)
    """
    text = cell.strip()
    try:
        float(text)
    except ValueError:
        return to_si(text, si, where=where)
    return to_si(f"{text} {unit or si}" if si != "1" or unit else text, si, where=where)
