"""What a store of records answers, as pages."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from jounce.report.history import history_page
from jounce.report.page import Block, Bullets, Page, Paragraph, Section, TableColumn, table_of

if TYPE_CHECKING:
    from jounce.inspection.archive.questions import (
        ExportedRecords,
        FoundRecords,
        ReevaluatedStore,
        VehicleHistory,
        VerifiedStore,
    )


def vehicle_history_page(found: VehicleHistory, *, title: str) -> Page:
    """Put the history of a vehicle on a page."""
    return history_page(found.visits, found.trends, title=title)


def found_records_page(found: FoundRecords, *, title: str) -> Page:
    """List records with their verdicts."""
    from jounce.inspection.archive.questions import COLUMNS

    records = found.to_dict()["records"]
    columns = [TableColumn(name, [_text(record[name]) for record in records]) for name in (*COLUMNS, "verdict")]
    count = f"{len(records)} record{'' if len(records) == 1 else 's'}"
    return _page(title, count, [table_of(count, columns) if records else Paragraph(count)])


def exported_records_page(found: ExportedRecords, *, title: str) -> Page:
    """Say how many records and rows were written."""
    return _page(title, "Table", [Paragraph(f"{found.records} records, {found.rows} rows")])


def verified_store_page(found: VerifiedStore, *, title: str) -> Page:
    """Say that a store is sound."""
    return _page(title, "Verified", [Paragraph(f"{found.store}: sound, {found.records} records")])


def reevaluated_store_page(found: ReevaluatedStore, *, title: str) -> Page:
    """Say how many gradings were added, and which verdicts changed."""
    result = found.result
    counts = f"{result.added} gradings added, {result.unchanged} unchanged"
    text = Paragraph(f"{result.records} records under limits {found.limits}: {counts}")
    changes = [
        f"{before or 'without a grading'} → {after}: {count}" for (before, after), count in result.changes.items()
    ]
    problems = [f"problem: record {number}: {problem}" for number, problem in result.failed.items()]
    lists = [Bullets(tuple(lines)) for lines in (changes, problems) if lines]
    return _page(title, "Evaluated again", [text, *lists])


def _page(title: str, what: str, blocks: Sequence[Block]) -> Page:
    return Page(title, (Section(what, tuple(blocks)),), what)


def _text(value: object) -> str:
    return "–" if value is None else str(value)
