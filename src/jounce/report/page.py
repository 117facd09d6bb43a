"""Elements of a page: sections of text, tables, figures and findings, as frozen data classes."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Literal, TypeAlias

from jounce.core.display import display_unit
from jounce.core.findings import Finding, not_drawn
from jounce.core.text import listed_places, slug
from jounce.plots.display import number, raise_exponents

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from jounce.core.tables import TextTable
    from jounce.report.chart import Chart
    from jounce.report.live import Viewer

Tone = Literal["plain", "good", "fair", "bad", "muted"]


@dataclass(frozen=True)
class Paragraph:
    """Text of one paragraph, coloured by its ``tone``."""

    text: str
    tone: Tone = "plain"


@dataclass(frozen=True)
class Bullets:
    """A list of short texts."""

    items: tuple[str, ...]


@dataclass(frozen=True)
class Cell:
    """A table cell with a tone that reinforces its text; ``show`` links it to a scene of a viewer."""

    text: str
    tone: Tone = "plain"
    note: str = ""
    show: str = ""


@dataclass(frozen=True)
class PageTable:
    """A table with headers.

    Attributes
    ----------
    caption : str
        What the table shows, as one sentence.
    header : tuple of str
        Header of each column, with its unit if any.
    rows : tuple of tuple
        Cells or plain strings; the first cell of each row is its header.
    align : str
        One letter per column: ``l`` for text, ``r`` for numbers, ``c``; text by default.
    note : str
        Small text below.
    """

    caption: str
    header: tuple[str, ...]
    rows: tuple[tuple[Cell | str, ...], ...]
    align: str = ""
    note: str = ""


@dataclass(frozen=True)
class TableColumn:
    """One column of numbers in an SI unit, or of texts with an empty ``unit``."""

    label: str
    values: Sequence[float | str | Cell | None]
    unit: str = ""


def table_of(caption: str, columns: Sequence[TableColumn], note: str = "") -> PageTable:
    """Create a table from columns of equal length, with numbers in the selected units.

    >>> table_of("Rates", (TableColumn("wheel", ["front"]), TableColumn("rate", [22730.0], "N/m"))).header
    ('wheel', 'rate [N/mm]')
    """
    written = [_write_column(column) for column in columns]
    header = tuple(label for label, _ in written)
    rows = tuple(zip(*(cells for _, cells in written), strict=True))
    return PageTable(
        caption, header, rows, "".join("r" if column.unit else "l" for column in columns), note
    )


def quantity_table(caption: str, rows: Sequence[tuple[str, float | None, str]]) -> PageTable:
    """Create a table of labels, values (SI) and units, each row in its selected unit.

    >>> quantity_table("Rig", [("spring rate", 22730.0, "N/m"), ("damping ratio", 0.3, "1")]).rows
    (('spring rate', '22.73', 'N/mm'), ('damping ratio', '0.3000', '–'))
    """
    cells = []
    for label, value, si in rows:
        unit = display_unit(si, abs(value or 0.0))
        cells.append(
            (label, number(None if value is None else value * unit.factor), unit.name or "–")
        )
    return PageTable(caption, ("quantity", "value", "unit"), tuple(cells), "lrl")


def as_table(table: TextTable, note: str = "") -> PageTable:
    """Convert a table of a result into a table of a page."""
    sides = "".join("l" if k in table.texts else "r" for k in range(len(table.header)))
    return PageTable(
        table.title, tuple(table.header), tuple(tuple(row) for row in table.rows), sides, note
    )


def _write_column(column: TableColumn) -> tuple[str, list[Cell | str]]:
    """Format the label and the cells of a column."""
    if not column.unit:
        return column.label, [
            value if isinstance(value, Cell) else str(value) for value in column.values
        ]
    numbers = [value for value in column.values if isinstance(value, float)]
    unit = display_unit(column.unit, max(map(abs, numbers), default=0.0))
    cells = [
        number(value * unit.factor) if isinstance(value, float) else "–" if value is None else value
        for value in column.values
    ]
    return unit.label(column.label) if unit.name else column.label, cells


@dataclass(frozen=True)
class Picture:
    """A figure, or a function that draws it, with its file name (without suffix) and a description.

    ``alternative`` is the text for screen readers. A function is called only when a document is written; a terminal
    shows the page without the figure.
    """

    source: Figure | Callable[[], Figure]
    name: str
    caption: str
    alternative: str

    @cached_property
    def figure(self) -> Figure:
        """Return the figure, calling its drawing function if it has one."""
        return self.source() if callable(self.source) else self.source

    @cached_property
    def _drawn(self) -> dict[str, bytes]:
        return {}

    def draw(self, suffixes: Sequence[str], note: str = "") -> dict[str, bytes]:
        """Return the figure in formats such as ``".svg"``, with a note; each format is drawn once."""
        from jounce.plots.figures import add_note, render_figure

        missing = [suffix for suffix in suffixes if suffix not in self._drawn]
        if missing:
            if not self._drawn:
                add_note(self.figure, note)
            self._drawn.update(render_figure(self.figure, missing, salt=self.name))
        return {suffix: self._drawn[suffix] for suffix in suffixes}


def picture_of(result: object, name: str, words: str) -> Picture:
    """Create a picture of a result with the figure of its type, drawn on writing; ``words`` is also the caption."""

    def draw() -> Figure:
        from jounce.plots import figure_of

        return figure_of(result)

    return Picture(draw, name, words, words)


@dataclass(frozen=True)
class Fact:
    """One number of the summary with a label, a short note and a tone."""

    label: str
    value: str
    note: str = ""
    tone: Tone = "plain"


@dataclass(frozen=True)
class Facts:
    """Highlighted numbers, side by side."""

    items: tuple[Fact, ...]


@dataclass(frozen=True)
class Findings:
    """Findings grouped by severity, most severe first; ``most`` limits their number."""

    items: tuple[Finding, ...]
    most: int | None = None


@dataclass(frozen=True)
class Details:
    """Collapsible blocks, expanded in print; without a heading if they replace an animation there.

    ``note`` is shown beside the summary; ``show`` is the scene of a viewer whose curves the blocks contain.
    """

    summary: str
    blocks: tuple[Block, ...]
    is_open: bool = False
    is_still: bool = False
    note: str = ""
    show: str = ""


Block: TypeAlias = (
    "Paragraph | Bullets | PageTable | Picture | Chart | Viewer | Facts | Findings | "
    "Details | Subsection"
)


@dataclass(frozen=True)
class Subsection:
    """Blocks with their own heading within a section."""

    title: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Section:
    """A heading with blocks, or with a function that creates them; listed in the table of contents.

    A function is called only when a document is written; a terminal shows the other sections. With ``own_page`` it
    begins a page of paper.
    """

    title: str
    source: tuple[Block, ...] | Callable[[], tuple[Block, ...]]
    own_page: bool = False

    @property
    def is_drawn(self) -> bool:
        """Whether a function creates the blocks."""
        return callable(self.source)

    @cached_property
    def blocks(self) -> tuple[Block, ...]:
        """Return the blocks, calling the function that creates them if there is one."""
        return self.source() if callable(self.source) else self.source


@dataclass(frozen=True)
class Page:
    """A whole document.

    Attributes
    ----------
    title, subtitle : str
        Heading of the page.
    sections : tuple of Section
        In order.
    banner : str
        Text at the top, on every section, figure and printed page, e.g. that data are synthetic.
    figure_note : str
        Short form of the banner for the foot of each figure.
    files : tuple of (str, str or bytes)
        Further files written with the page: path and content.
    name : str
        File name of the page.
    missing : tuple of Finding
        Sections that could not be drawn, and why.
    """

    title: str
    sections: tuple[Section, ...]
    subtitle: str = ""
    banner: str = ""
    figure_note: str = ""
    files: tuple[tuple[str, str | bytes], ...] = ()
    name: str = "report.html"
    missing: tuple[Finding, ...] = ()

    def pictures(self) -> tuple[Picture | Chart, ...]:
        """Return all figures in order."""
        from jounce.report.chart import Chart

        return tuple(block for block in self.blocks() if isinstance(block, Picture | Chart))

    def viewers(self) -> tuple[Viewer, ...]:
        """Return all viewers in order."""
        from jounce.report.live import Viewer

        return tuple(block for block in self.blocks() if isinstance(block, Viewer))

    def blocks(self) -> Iterator[Block]:
        """Return all blocks in order, including collapsed ones."""
        for section in self.sections:
            yield from blocks_in(section.blocks)


def sections_of(
    parts: Mapping[str, Callable[[], Section]],
) -> tuple[tuple[Section, ...], tuple[Finding, ...]]:
    """Draw sections by title; a section that fails is reported as missing and omitted from the page."""
    sections, missing = [], []
    for title, draw in parts.items():
        try:
            sections.append(draw())
        except Exception as error:  # noqa: BLE001 - the other sections are still drawn
            missing.append(not_drawn(title, error))
            sections.append(Section(title, (Findings((missing[-1],)),)))
    return tuple(sections), tuple(missing)


def blocks_in(blocks: Sequence[Block]) -> Iterator[Block]:
    """Yield blocks and their nested blocks, in order."""
    for block in blocks:
        yield block
        if isinstance(block, Details | Subsection):
            yield from blocks_in(block.blocks)


def worst_first(findings: Sequence[Finding]) -> tuple[Finding, ...]:
    """Sort findings: problems, then warnings, then notes; each in the order given."""
    order = ("problem", "warning", "note")
    return tuple(sorted(findings, key=lambda finding: order.index(finding.severity)))


def findings_blocks(findings: Sequence[Finding]) -> list[Block]:
    """Return findings as blocks of a page, most severe first; empty without findings."""
    return [Findings(worst_first(findings))] if findings else []


def answer_page(title: str, blocks: Sequence[Block], subtitle: str = "") -> Page:
    """Create a page with a single section, the answer."""
    return Page(title, (Section("Answer", tuple(blocks)),), subtitle)


_NEGATIVE = re.compile(r"(?<![\w.−-])-(?=\d)")


def as_printed(text: str) -> str:
    """Format numbers and units in a sentence as in tables: with minus signs and superscript exponents.

    >>> as_printed("moved by -2.4 % (1e-05, ISO 2631-1, 2026-11-22, 3-D), 0.9 m/s^2")
    'moved by −2.4 % (1e-05, ISO 2631-1, 2026-11-22, 3-D), 0.9 m/s²'
    """
    return raise_exponents(_NEGATIVE.sub("−", text))


def unique_slugs(names: Sequence[str]) -> list[str]:
    """Return slugs of several names, with a number appended to duplicates.

    Examples
    --------
    >>> unique_slugs(["a b", "A-b", "c"])
    ['a-b', 'a-b-2', 'c']
    """
    slugs: list[str] = []
    for name in names:
        base = candidate = slug(name)
        count = 1
        while candidate in slugs:
            count += 1
            candidate = f"{base}-{count}"
        slugs.append(candidate)
    return slugs


_SEVERITIES = {"problem": "Problems", "warning": "Warnings", "note": "Notes"}


def alignments(table: PageTable) -> list[str]:
    """Return the alignment of each column: ``left``, ``right`` or ``centre``."""
    letters = table.align.ljust(len(table.header), "l")
    return [{"l": "left", "r": "right", "c": "centre"}[letter] for letter in letters]


def group_findings(findings: Findings) -> list[tuple[str, str, list[tuple[str, str]]]]:
    """Group findings by severity, most severe first: (severity, heading, (places, message) of each).

    Identical sentences about different places are merged.
    """
    messages: dict[tuple[str, str], list[str]] = {}
    ordered = worst_first(findings.items)
    for finding in ordered:
        places = messages.setdefault((finding.severity, finding.message), [])
        if finding.place not in places:
            places.append(finding.place)
    shown = list(messages.items())[: findings.most]
    result = []
    for severity, heading in _SEVERITIES.items():
        rows = [
            (listed_places(places), as_printed(message))
            for (kind, message), places in shown
            if kind == severity
        ]
        if rows:
            result.append((severity, heading, rows))
    return result
