"""Pages of the results of queries to a store of records."""

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
    from jounce.inspection.archive.storing import ImportedRecords


def vehicle_history_page(history: VehicleHistory, *, title: str) -> Page:
    """Create a page of the history of a vehicle."""
    return history_page(history.visits, history.trends, title=title)


def record_search_page(search: FoundRecords, *, title: str) -> Page:
    """Create a page that lists records with their verdicts."""
    from jounce.inspection.archive.questions import COLUMNS

    records = search.to_dict()["records"]
    columns = [
        TableColumn(name, [_text(record[name]) for record in records])
        for name in (*COLUMNS, "verdict")
    ]
    count = f"{len(records)} record{'' if len(records) == 1 else 's'}"
    return _page(title, count, [table_of(count, columns) if records else Paragraph(count)])


def exported_records_page(export: ExportedRecords, *, title: str) -> Page:
    """Create a page with the number of records and rows written."""
    return _page(title, "Table", [Paragraph(f"{export.records} records, {export.rows} rows")])


def verified_store_page(verified: VerifiedStore, *, title: str) -> Page:
    """Create a page that confirms the integrity of a store."""
    return _page(
        title, "Verified", [Paragraph(f"{verified.store}: sound, {verified.records} records")]
    )


def reevaluated_store_page(reevaluated: ReevaluatedStore, *, title: str) -> Page:
    """Create a page with the number of gradings added and the verdicts that changed."""
    result = reevaluated.result
    counts = f"{result.added} gradings added, {result.unchanged} unchanged"
    text = Paragraph(f"{result.records} records under limits {reevaluated.limits}: {counts}")
    changes = [
        f"{before or 'without a grading'} → {after}: {count}"
        for (before, after), count in result.changes.items()
    ]
    problems = [f"problem: record {number}: {problem}" for number, problem in result.failed.items()]
    lists = [Bullets(tuple(lines)) for lines in (changes, problems) if lines]
    return _page(title, "Evaluated again", [text, *lists])


def imported_records_page(found: ImportedRecords, *, title: str) -> Page:
    """Create a page with the number of records added to a store."""
    new = [record for record in found.records if record.is_new]
    ungraded = sum(bool(record.problem) for record in new)
    parts = [f"{len(new)} new", f"{len(found.records) - len(new)} already known"]
    parts += [f"{ungraded} of the new records cannot be graded"] if ungraded else []
    parts += [f"{len(found.failed)} not readable"] if found.failed else []
    blocks = [Paragraph(", ".join(parts))]
    if any(record.warnings for record in found.records):
        blocks.append(Paragraph("what the warnings are: column findings of inspect export"))
    return Page(title, (Section("Import", tuple(blocks)),))


def _page(title: str, what: str, blocks: Sequence[Block]) -> Page:
    return Page(title, (Section(what, tuple(blocks)),), what)


def _text(value: object) -> str:
    return "–" if value is None else str(value)
