"""A page as a PDF document, and its tables as CSV files and one workbook."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from jounce.core.optional import require
from jounce.core.text import guard_formula, slug
from jounce.core.workbooks import CONTROL, workbook_bytes
from jounce.report.chart import Chart
from jounce.report.live import Viewer
from jounce.report.page import (
    Block,
    Bullets,
    Cell,
    Details,
    Facts,
    Findings,
    Page,
    PageTable,
    Paragraph,
    Picture,
    alignments,
    group_findings,
)
from jounce.report.typeset import breakable, missing_letters, typeset

if TYPE_CHECKING:
    from jounce.report.page import Fact

_BOXES = "characters without an installed font appear as boxes; a browser shows them"
TABLES = ("csv", "xlsx")
"""File formats of a page's tables."""


def page_pdf(page: Page, figures: Mapping[str, Mapping[str, bytes]], template: bytes) -> bytes:
    """Typeset a page as PDF; ``figures`` contains the panels of each figure as SVG, by name and file name."""
    import jounce

    content = {
        "title": page.title,
        "subtitle": page.subtitle,
        "banner": page.banner,
        "note": page.figure_note,
        "foot": f"{page.title} · jounce {jounce.__version__}",
        "sections": [
            {
                "title": section.title,
                "own_page": section.own_page,
                "blocks": _blocks(section.blocks, figures),
            }
            for section in page.sections
        ],
    }
    if missing_letters(json.dumps(content, ensure_ascii=False)):
        content["foot"] = f"{content['foot']} · {_BOXES}"
    files = {name: svg for panels in figures.values() for name, svg in panels.items()}
    data = json.dumps(_restore_file_names(breakable(content)), ensure_ascii=False).encode(
        "utf-8", "replace"
    )
    made: bytes = typeset({"main.typ": template, "page.json": data, **files}, "pdf")
    return made


def _restore_file_names(value: Any) -> Any:
    """Restore the file names of figures as written next to the document."""
    if isinstance(value, dict):
        return {
            key: item.replace("\u200b", "")
            if key in ("file", "kind")
            else _restore_file_names(item)
            for key, item in value.items()
        }
    return [_restore_file_names(item) for item in value] if isinstance(value, list) else value


def _blocks(
    blocks: Sequence[Block], figures: Mapping[str, Mapping[str, bytes]]
) -> list[dict[str, Any]]:
    plain_blocks: list[dict[str, Any]] = []
    for block in blocks:
        if (
            isinstance(block, Details) and block.is_still
        ):  # paper has no animation whose static copy this would be
            plain_blocks += _blocks(block.blocks, figures)
        elif (plain := _plain(block, figures)) is not None:
            plain_blocks.append(plain)
    return plain_blocks


def _plain(block: Block, figures: Mapping[str, Mapping[str, bytes]]) -> dict[str, Any] | None:
    kind = type(block).__name__
    if isinstance(block, Paragraph):
        return {"kind": kind, "text": block.text, "tone": block.tone}
    if isinstance(block, Bullets):
        return {"kind": kind, "items": list(block.items)}
    if isinstance(block, PageTable):
        return {"kind": kind, **_table(block)}
    if isinstance(block, Picture | Chart):
        names = list(figures[block.name])
        widths = [panel.width for panel in block.panels] if isinstance(block, Chart) else [1]
        panels = [{"file": name, "width": width} for name, width in zip(names, widths, strict=True)]
        rows = _arrange_panels(panels)
        full = (
            max(_FULL, *(sum(panel["width"] for panel in row) for row in rows))
            if isinstance(block, Chart)
            else 1
        )
        return {"kind": "Figure", "rows": rows, "full": full, "caption": block.caption}
    if isinstance(block, Facts):
        return {"kind": kind, "items": [_fact(fact) for fact in block.items]}
    if isinstance(block, Findings):
        tones = {"problem": "bad", "warning": "fair", "note": "muted"}
        groups = [
            {
                "tone": tones[severity],
                "heading": heading,
                "items": [{"places": p, "message": m} for p, m in rows],
            }
            for severity, heading, rows in group_findings(block)
        ]
        return {"kind": kind, "groups": groups}
    if isinstance(block, Viewer):
        return None  # an animation; its figures are separate blocks
    if isinstance(block, Details):
        title = f"{block.summary} ({block.note})" if block.note else block.summary
    else:
        title = block.title
    return {"kind": "Group", "title": title, "blocks": _blocks(block.blocks, figures)}


def _arrange_panels(panels: list[dict[str, Any]]) -> list[list[dict[str, Any]]]:
    """Arrange panels side by side while their text remains legible."""
    rows: list[list[dict[str, Any]]] = []
    for panel in panels:
        if not rows or sum(beside["width"] for beside in rows[-1]) + panel["width"] > _MOST:
            rows.append([])
        rows[-1].append(panel)
    return rows


def _fact(fact: Fact) -> dict[str, str]:
    return {"label": fact.label, "value": fact.value, "note": fact.note, "tone": fact.tone}


_FULL, _MOST = 700, 1010
"""Total panel width in pixels that fills the page, and the maximum that remains legible."""
_WIDE, _WIDE_NAME = 22, 44
"""Number of characters above which a text column, and the first column, shares the remaining width."""


def _table(table: PageTable) -> dict[str, Any]:
    align = alignments(table)
    rows = [[_cell(cell) for cell in row] for row in table.rows]
    longest = [
        max(
            (max(len(row[k]["text"]), len(row[k]["note"])) for row in rows if k < len(row)),
            default=0,
        )
        for k in range(len(table.header))
    ]
    widths = [
        "fill" if a == "left" and n > (_WIDE if k else _WIDE_NAME) else "auto"
        for k, (a, n) in enumerate(zip(align, longest, strict=True))
    ]
    return {
        "caption": table.caption,
        "header": list(table.header),
        "rows": rows,
        "align": align,
        "widths": widths,
        "note": table.note,
    }


def _cell(cell: Cell | str) -> dict[str, str]:
    if isinstance(cell, str):
        return {"text": cell, "tone": "plain", "note": ""}
    return {"text": cell.text, "tone": cell.tone, "note": cell.note}


def tables_of(page: Page) -> dict[str, PageTable]:
    """Return all tables of a page by file name, in order: ``01-parameters-of-strategy-1``."""
    tables = [block for block in page.blocks() if isinstance(block, PageTable)]
    return {
        f"{k:02d}-{slug(table.caption)[:60].rstrip('-')}": table
        for k, table in enumerate(tables, 1)
    }


_NUMBER = re.compile(r"−?\d+(\.\d+)?(e−?\d+)?")


def value_of(cell: Cell | str) -> float | str:
    """Return a cell as a number if possible, otherwise as text followed by its note.

    Examples
    --------
    >>> value_of("−1.5e−3"), value_of("22.7 N/mm"), value_of(Cell("good", "good", "of all"))
    (-0.0015, '22.7 N/mm', 'good (of all)')
    """
    text, note = (cell, "") if isinstance(cell, str) else (cell.text, cell.note)
    if _NUMBER.fullmatch(text) and not note:
        return float(text.replace("−", "-"))
    return f"{text} ({note})" if note else text


def table_csv(table: PageTable) -> str:
    """Format a table as CSV, with decimal points and a ``'`` before texts that look like formulas.

    Examples
    --------
    >>> print(table_csv(PageTable("t", ("name", "value [mm]"), (("=1+1", "−0.50"),))), end="")
    name,value [mm]
    '=1+1,-0.50
    """
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([guard_formula(title) for title in table.header])
    for row in table.rows:
        writer.writerow([_csv_text(cell) for cell in row])
    return CONTROL.sub(" ", stream.getvalue())


def _csv_text(cell: Cell | str) -> str:
    value = value_of(cell)
    if isinstance(value, str):
        return guard_formula(value)
    return (cell if isinstance(cell, str) else cell.text).replace("−", "-")


def tables_xlsx(page: Page) -> bytes:
    """Write all tables of a page into one workbook: a sheet with a list of tables, then one sheet per table.

    Raises
    ------
    MissingPackageError
        Without openpyxl (extra ``io``).
    """
    openpyxl = require("openpyxl", "io")
    book = openpyxl.Workbook()
    contents = book.active
    contents.title = "Contents"
    _append(contents, (page.title,))
    if page.banner:
        _append(contents, (page.banner,))
    bold = openpyxl.styles.Font(bold=True)
    for name, table in tables_of(page).items():
        sheet = book.create_sheet(name[:31])
        _append(contents, (name[:31], table.caption))
        _append(sheet, table.header)
        for cell in sheet[1]:
            cell.font = bold
        for row in table.rows:
            _append(sheet, [value_of(cell) for cell in row])
        sheet.freeze_panes = "B2"
        for k, column in enumerate(sheet.columns, 1):
            width = max((len(str(cell.value or "")) for cell in column), default=8)
            sheet.column_dimensions[openpyxl.utils.get_column_letter(k)].width = min(
                max(width + 2, 8), 60
            )
    return workbook_bytes(book)


def _append(sheet: Any, values: Sequence[float | str]) -> None:
    """Append a row; texts that begin with ``=`` are kept as texts."""
    row = sheet.max_row + (sheet.max_row > 1 or sheet.cell(1, 1).value is not None)
    for column, value in enumerate(values, 1):
        cell = sheet.cell(row, column)
        cell.value = CONTROL.sub(" ", value) if isinstance(value, str) else value
        if isinstance(value, str):
            cell.data_type = "s"
