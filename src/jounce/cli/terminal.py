"""Display of a page in a terminal: facts, tables and findings, in order, without figures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from jounce.cli.reply import show_findings
from jounce.cli.tables import FittedTable
from jounce.report.page import (
    Bullets,
    Cell,
    Facts,
    Findings,
    PageTable,
    Paragraph,
    Subsection,
    alignments,
)

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.report.page import Block, Page


STYLES = {"plain": "", "muted": "dim", "good": "green", "fair": "yellow", "bad": "bold red"}
"""Terminal style of each tone."""


def show_page(out: Console, page: Page) -> None:
    """Print a page."""
    if heading := ": ".join(filter(None, (page.title, page.subtitle))):
        out.print(heading, style="bold")
    for section in page.sections:
        if not section.is_drawn:
            _show_blocks(out, section.blocks)


def _show_blocks(out: Console, blocks: Sequence[Block]) -> None:
    for block in blocks:
        if isinstance(block, PageTable):
            rows = [[_text(cell) for cell in row] for row in block.rows]
            texts = [k for k, side in enumerate(alignments(block)) if side == "left"]
            out.print(FittedTable(block.caption, block.header, rows, texts))
            if block.note:
                out.print(block.note)
        elif isinstance(block, Facts):
            for fact in block.items:
                text = f"{fact.label}: {fact.value}" + (f" ({fact.note})" if fact.note else "")
                out.print(text, style=STYLES[fact.tone])
        elif isinstance(block, Findings):
            show_findings(out, block.items)
        elif isinstance(block, Paragraph):
            out.print(block.text)
        elif isinstance(block, Bullets):
            out.print(*(f"- {item}" for item in block.items), sep="\n")
        elif isinstance(block, Subsection):
            out.print(block.title)
            _show_blocks(out, block.blocks)


def _text(cell: Cell | str) -> str:
    if isinstance(cell, str):
        return cell
    return f"{cell.text} ({cell.note})" if cell.note else cell.text
