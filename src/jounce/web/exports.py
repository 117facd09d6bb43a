"""Export of the curves and tables on a workbench page as images, documents and tables.

The browser sends its displayed content as blocks of a page, and the report writers format it. Exported figures,
documents and workbooks therefore show the same numbers as the page.
"""

from __future__ import annotations

import csv
import io
import re
import tempfile
from collections.abc import Callable, Iterable
from html import escape
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, PlainValidator, WithJsonSchema, model_validator

from jounce.core.errors import JounceError
from jounce.core.text import slug
from jounce.core.types import Array
from jounce.core.units import Unit
from jounce.report.chart import LINES, Chart, Panel, Series, chart_svg
from jounce.report.document import table_csv, tables_xlsx
from jounce.report.page import Block, Page, PageTable, Paragraph, Section
from jounce.report.render import REPORTS, chart_style, plain_colours, png_of

Form = Literal["png", "svg", "pdf", "html", "csv", "xlsx"]
KINDS: dict[Form, str] = {
    "png": "image/png",
    "svg": "image/svg+xml",
    "pdf": "application/pdf",
    "html": "text/html; charset=utf-8",
    "csv": "text/csv; charset=utf-8",
    "xlsx": "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
}
APART = ("png", "pdf", "xlsx")
"""Forms that are written in a process of its own, as ``DOCUMENT`` in its folder: their libraries need 80 MB."""
DOCUMENT = "document"
_MOST_PANELS, _MOST_BLOCKS = 120, 200
_WIDE, _NARROW = (880, 230), (430, 210)  # panel size in pixels: single column, and side by side


def _read_values(given: Any) -> Array:
    if not isinstance(given, list) or not all(
        isinstance(value, int | float) or value is None for value in given
    ):
        raise ValueError("not a list of numbers and nulls")
    return np.array(given, dtype=float)  # null is NaN


Values = Annotated[
    Any,
    PlainValidator(_read_values),
    WithJsonSchema({"type": "array", "items": {"anyOf": [{"type": "number"}, {"type": "null"}]}}),
]
"""Numbers in the displayed unit; null for missing values."""


class _Sent(BaseModel):
    model_config = ConfigDict(extra="forbid")


class SentCurve(_Sent):
    """One curve over the axis of its figure, in the unit of its panel."""

    label: str = ""
    role: Annotated[str, Field(pattern=r"^[a-z]+(-\d)?$")] = "after"
    y: Values


class SentPanel(_Sent):
    """A pair of axes."""

    title: str
    unit: str = ""
    curves: list[SentCurve] = Field(max_length=20)


class SentChart(_Sent):
    """Panels over a common axis; ``window`` is its visible part."""

    kind: Literal["chart"]
    caption: str
    x_label: str
    x: Values
    panels: list[SentPanel] = Field(min_length=1, max_length=_MOST_PANELS)
    window: tuple[Annotated[float, Unit("1")], Annotated[float, Unit("1")]] | None = None
    columns: Annotated[int, Field(ge=1, le=3)] = 1

    @model_validator(mode="after")
    def _check_lengths(self) -> SentChart:
        for panel in self.panels:
            for curve in panel.curves:
                if len(curve.y) != len(self.x):
                    raise ValueError(
                        f"{panel.title}: {len(curve.y)} values over an axis of {len(self.x)}"
                    )
        return self


class SentTable(_Sent):
    """A table as displayed; ``numbers`` are the right-aligned columns."""

    kind: Literal["table"]
    caption: str
    header: list[str] = Field(min_length=1, max_length=100)
    rows: list[list[str]] = Field(max_length=20_000)
    numbers: list[int] = []

    @model_validator(mode="after")
    def _check_lengths(self) -> SentTable:
        for number, row in enumerate(self.rows, 1):
            if len(row) != len(self.header):
                raise ValueError(
                    f"row {number} has {len(row)} cells, the header {len(self.header)}"
                )
        return self


_COLOUR = r"^(#[0-9a-f]{6})?$"
_Size = Annotated[float, Unit("1", at_least=0.0, at_most=1e4)]


class SentShape(_Sent):
    """A line or an area of a drawing: its path in pixels (M, L, A and Z), and how it is drawn."""

    d: str = Field(max_length=50_000, pattern=r"^[MLAZ\d .,-]+$")
    fill: str = Field(default="", pattern=_COLOUR)
    stroke: str = Field(default="", pattern=_COLOUR)
    width: _Size = 1.0
    dash: list[_Size] = Field(default_factory=list, max_length=6)
    alpha: Annotated[float, Unit("1", at_least=0.0, at_most=1.0)] = 1.0

    def svg(self) -> str:
        """Return the SVG element."""
        line = f' stroke="{self.stroke}" stroke-width="{self.width:g}"' if self.stroke else ""
        if self.dash:
            line += f' stroke-dasharray="{" ".join(f"{part:g}" for part in self.dash)}"'
        alpha = f' opacity="{self.alpha:g}"' if self.alpha < 1.0 else ""
        return f'<path d="{self.d}" fill="{self.fill or "none"}"{line}{alpha}/>'


class SentName(_Sent):
    """A name in a drawing, to the right of its place, px."""

    text: str = Field(max_length=200)
    x: Annotated[float, Unit("1")]
    y: Annotated[float, Unit("1")]

    def svg(self) -> str:
        """Return the SVG element."""
        return f'<text x="{self.x:.1f}" y="{self.y:.1f}">{escape(self.text)}</text>'


class SentDrawing(_Sent):
    """A drawing of a mechanism, from back to front, on paper."""

    kind: Literal["drawing"]
    caption: str
    width: Annotated[int, Field(ge=10, le=4000)]
    height: Annotated[int, Field(ge=10, le=4000)]
    shapes: list[SentShape] = Field(max_length=20_000)
    names: list[SentName] = Field(default_factory=list, max_length=500)


class SentText(_Sent):
    """A paragraph, or the heading of the following blocks."""

    kind: Literal["text", "heading"]
    text: str


Sent: TypeAlias = Annotated[
    SentChart | SentTable | SentDrawing | SentText, Field(discriminator="kind")
]


class Exported(_Sent):
    """Displayed content and requested file; ``scale`` is the resolution of a PNG relative to the screen."""

    title: str
    subtitle: str = ""
    form: Form
    scale: Annotated[float, Unit("1", at_least=0.5, at_most=8.0)] = 2.0
    blocks: list[Sent] = Field(min_length=1, max_length=_MOST_BLOCKS)


def exported(asked: Exported) -> bytes:
    """Write the content of a page as a file in the requested format.

    Raises
    ------
    JounceError
        If an image is requested of content that is not a figure, or a CSV file of several figures or tables.
    MissingPackageError
        Without typst (PNG and PDF, extra ``pdf``) or openpyxl (XLSX, extra ``io``).
    """
    return _WRITERS[asked.form](asked)


def file_name(asked: Exported) -> str:
    """Return the name of the file that a browser saves."""
    return f"{slug(asked.title)}.{asked.form}"


def _svg(asked: Exported) -> bytes:
    return plain_colours(chart_svg(_only_chart(asked), chart_style())).encode()


def _png(asked: Exported) -> bytes:
    return png_of(chart_svg(_only_chart(asked), chart_style()), asked.scale)


def _only_chart(asked: Exported) -> Chart:
    charts = [block for block in asked.blocks if isinstance(block, SentChart | SentDrawing)]
    if len(charts) != 1 or len(asked.blocks) != 1:
        hint = "Save each figure from its own menu, or the whole page as PDF."
        raise JounceError(
            "this format can contain only one figure",
            where=asked.form,
            found=len(charts),
            hint=hint,
        )
    (figure,) = charts
    if isinstance(figure, SentDrawing):
        return drawing_of(figure, "figure")
    return chart_of(figure, "figure")


def _document(asked: Exported) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        return Path(REPORTS.write(page_of(asked), Path(folder) / f"page.{asked.form}")).read_bytes()


def _csv(asked: Exported) -> bytes:
    data = [block for block in asked.blocks if isinstance(block, SentChart | SentTable)]
    if len(data) != 1:
        hint = "Save each figure and table from its own menu, or all of them as XLSX."
        raise JounceError(
            "a CSV file can contain only one figure or table", found=len(data), hint=hint
        )
    (block,) = data
    text = table_csv(table_of(block)) if isinstance(block, SentTable) else _columns_csv(block)
    return b"\xef\xbb\xbf" + text.encode()  # spreadsheets detect the encoding by these bytes


def _columns_csv(chart: SentChart) -> str:
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(_headers(chart))
    writer.writerows(
        zip(*([_written(value) for value in column] for column in _columns(chart)), strict=True)
    )
    return stream.getvalue()


def _written(value: float) -> str:
    return "" if np.isnan(value) else f"{value:.10g}"


def _headers(chart: SentChart) -> list[str]:
    """Return the column headers: the axis, then each curve with its unit."""
    names = [chart.x_label]
    for panel in chart.panels:
        for curve in panel.curves:
            name = f"{panel.title}, {curve.label}" if curve.label else panel.title
            names.append(f"{name} [{panel.unit or '–'}]")
    return names


def _columns(chart: SentChart) -> list[list[float]]:
    """Return the axis and all curves within the visible part."""
    columns = [chart.x, *(curve.y for panel in chart.panels for curve in panel.curves)]
    low, high = chart.window or (-np.inf, np.inf)
    shown = (chart.x >= low) & (chart.x <= high)
    return [column[shown].tolist() for column in columns]


def _xlsx(asked: Exported) -> bytes:
    page = page_of(asked, as_table=lambda chart: [numbers_of(chart)])
    if not any(isinstance(block, PageTable) for block in page.blocks()):
        raise JounceError("there is no table or curve to export", where=asked.title)
    return tables_xlsx(page)


def numbers_of(chart: SentChart) -> PageTable:
    """Return the numbers of a figure as a table, with the number of digits that a workbook shows."""
    columns = [
        [_written(value).replace("-", "−") for value in column] for column in _columns(chart)
    ]
    rows = tuple(tuple(row) for row in zip(*columns, strict=True))
    return PageTable(chart.caption, tuple(_headers(chart)), rows, "r" * len(columns))


def table_of(table: SentTable) -> PageTable:
    """Convert a table to that of a report."""
    align = "".join("r" if k in table.numbers else "l" for k in range(len(table.header)))
    return PageTable(
        table.caption, tuple(table.header), tuple(tuple(row) for row in table.rows), align
    )


def chart_of(chart: SentChart, name: str) -> Chart:
    """Convert a figure to that of a report; stacked panels share the axis below the last one."""
    width, height = _WIDE if chart.columns == 1 else _NARROW
    panels = []
    for k, panel in enumerate(chart.panels):
        is_foot = chart.columns > 1 or k == len(chart.panels) - 1
        curves = tuple(
            Series(
                chart.x,
                curve.y,
                curve.role,
                LINES.get(curve.role, "line"),
                curve.label,
            )
            for curve in panel.curves
        )
        panels.append(
            Panel(
                curves,
                chart.x_label if is_foot else "",
                f"[{panel.unit or '–'}]",
                panel.title,
                x_range=chart.window,
                width=width,
                height=height,
                is_first_on_top=len(curves) > 1 and curves[0].role == "after",
            )
        )
    return Chart(tuple(panels), name, chart.caption, chart.caption, chart.columns)


def drawing_of(drawing: SentDrawing, name: str) -> Chart:
    """Convert a drawing to a figure of a report, on white paper in every scheme of colours."""
    paper = f'<rect width="{drawing.width}" height="{drawing.height}" fill="#ffffff"/>'
    shapes = "".join(shape.svg() for shape in drawing.shapes)
    names = "".join(each.svg() for each in drawing.names)
    dark = f'<g style="--ink:#22262b">{names}</g>'
    panel = Panel((), width=drawing.width, height=drawing.height, drawn=f"{paper}{shapes}{dark}")
    return Chart((panel,), name, drawing.caption, drawing.caption, 1)


def page_of(
    asked: Exported, as_table: Callable[[SentChart], Iterable[Block]] | None = None
) -> Page:
    """Return all blocks as a page of a report, a section per heading; ``as_table`` converts figures to tables."""
    sections: list[Section] = []
    title, blocks = "", list[Block]()

    def close() -> None:
        if blocks:
            sections.append(Section(title or asked.title, tuple(blocks)))

    for number, block in enumerate(asked.blocks, 1):
        if isinstance(block, SentText):
            if block.kind == "text":
                blocks.append(Paragraph(block.text))
                continue
            close()
            title, blocks = block.text, []
        elif isinstance(block, SentTable):
            blocks.append(table_of(block))
        elif isinstance(block, SentDrawing):
            blocks += [] if as_table else [drawing_of(block, f"figure-{number}")]
        elif as_table is not None:
            blocks += as_table(block)
        else:
            blocks.append(chart_of(block, f"figure-{number}"))
    close()
    return Page(_plain(asked.title), tuple(sections), asked.subtitle)


def _plain(text: str) -> str:
    return re.sub(r"\s+", " ", text).strip()


_WRITERS: dict[Form, Callable[[Exported], bytes]] = {
    "svg": _svg,
    "png": _png,
    "pdf": _document,
    "html": _document,
    "csv": _csv,
    "xlsx": _xlsx,
}
