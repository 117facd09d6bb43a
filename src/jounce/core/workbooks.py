"""Read and write Excel workbooks: texts stay texts, numbers keep all digits, equal content gives equal bytes.

The size declared in a file is not trusted: it may claim billions of cells.
"""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from jounce.core.errors import JounceError
from jounce.core.optional import require

CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")
"""Characters that are invalid in XML, and therefore in a cell or figure."""
MOST_ROWS, MOST_COLUMNS, LONGEST_TEXT = 1_048_576, 16_384, 32_767
"""Rows and columns of a sheet, and characters of a cell: the limits of Excel."""


def workbook_of(sheets: Mapping[str, Iterable[Sequence[float | str]]]) -> bytes:
    """Write rows of numbers and texts, sheet by sheet; numbers are restored exactly when read."""
    openpyxl = require("openpyxl", "io")
    book = openpyxl.Workbook(write_only=True)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        sheet._writer = openpyxl.worksheet._writer.WorksheetWriter(sheet, io.BytesIO())
        sheet._writer.write_top()
        for row in rows:
            sheet.append([_cell(openpyxl, sheet, value) for value in row])
    return workbook_bytes(book)


def _cell(openpyxl: Any, sheet: Any, value: float | str) -> Any:
    is_text = isinstance(value, str)
    cell = openpyxl.cell.WriteOnlyCell(sheet, value if is_text else repr(float(value)))
    cell.data_type = (
        "s" if is_text else "n"
    )  # not a formula, and with all digits: openpyxl writes only 16
    return cell


def split_text(text: str) -> list[str]:
    """Split a text into pieces that fit into a cell.

    >>> [len(piece) for piece in split_text("x" * 40_000)]
    [32767, 7233]
    """
    return [text[i : i + LONGEST_TEXT] for i in range(0, len(text), LONGEST_TEXT)]


def workbook_bytes(book: Any) -> bytes:
    """Return a workbook as bytes, without creation times and with relative paths.

    It is built in memory: openpyxl writes sheets to files in ``TMPDIR``, misses some errors of a full disk there, and
    leaves the files if the process is killed.
    """
    excel = require("openpyxl.writer.excel", "io")

    class Archive(zipfile.ZipFile):
        def writestr(self, name: Any, content: bytes | str, *_: Any) -> None:  # type: ignore[override]
            data = content.encode() if isinstance(content, str) else content
            if name == "docProps/core.xml":
                data = re.sub(
                    rb"(<dcterms:(?:created|modified)[^>]*>)[^<]*",
                    rb"\g<1>2000-01-01T00:00:00Z",
                    data,
                )
            if name == "xl/_rels/workbook.xml.rels":  # as Excel writes it; Octave reads no other
                data = data.replace(b'Target="/xl/', b'Target="')
            super().writestr(
                zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED
            )

    class Writer(excel.ExcelWriter):  # type: ignore[misc, name-defined]
        def write_worksheet(self, sheet: Any) -> None:
            if self.workbook.write_only:
                sheet.close()
                writer = sheet._writer
            else:
                writer = excel.WorksheetWriter(sheet, io.BytesIO())
                writer.write()
            sheet._rels = writer._rels
            self._archive.writestr(sheet.path[1:], writer.read())
            self.manifest.append(sheet)

    stream = io.BytesIO()
    Writer(book, Archive(stream, "w")).save()
    return stream.getvalue()


def sheets_of(
    file: Path,
    error: type[JounceError],
    *,
    most_bytes: int,
    most_rows: int = MOST_ROWS,
    most_columns: int | None = None,
) -> Iterator[tuple[str, Iterator[tuple[int, list[Any]]]]]:
    """Return the sheets of a workbook by name, each as rows with their numbers; raise ``error`` for larger ones.

    Rows have the length of their content, or ``most_columns`` if given. Exceptions of openpyxl about a damaged file are
    passed on.
    """
    openpyxl = require("openpyxl", "io")
    with zipfile.ZipFile(file) as archive:
        size = sum(info.file_size for info in archive.infolist())
    if size > most_bytes:
        raise error(
            "the workbook is too large",
            where=str(file),
            found=f"{size / 1e6:.0f} MB",
            allowed=f"up to {most_bytes / 1e6:.0f} MB",
        )
    book = openpyxl.load_workbook(file, read_only=True, data_only=True)

    def rows_of(sheet: Any) -> Iterator[tuple[int, list[Any]]]:
        sheet.reset_dimensions()
        for number, row in enumerate(sheet.iter_rows(values_only=True, max_col=most_columns), 1):
            if number > most_rows:
                raise error(
                    "too many rows", where=f"{file}, {sheet.title}", allowed=f"up to {most_rows}"
                )
            yield number, list(row)

    try:
        for sheet in book.worksheets:
            yield sheet.title, rows_of(sheet)
    finally:
        book.close()
