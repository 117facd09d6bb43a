"""Page of a corner's clearances: minimum distance of each pair of bodies, and lengths of links."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.report.page import Block, Page, TableColumn, answer_page, findings_blocks, table_of

if TYPE_CHECKING:
    from jounce.kinematics.clearance_study import ClearanceStudy


def clearances_page(study: ClearanceStudy, *, title: str) -> Page:
    """Create a page of minimum distances and lengths of links."""
    least, blocks = study.least, list[Block]()
    if least:
        columns = {
            "clearance": "least clearance",
            "wheel_travel": "at travel",
            "rack_travel": "at rack",
        }
        numbers = (
            TableColumn(label, [pair[key] for pair in least.values()], "m")
            for key, label in columns.items()
        )
        blocks.append(
            table_of(
                "Clearances, negative where bodies overlap",
                (TableColumn("between", [*least]), *numbers),
            )
        )
    lengths = (
        TableColumn("between", [*study.lengths]),
        TableColumn("length", [*study.lengths.values()], "m"),
    )
    blocks.append(table_of("Lengths of links at design", lengths))
    blocks += findings_blocks(study.findings)
    return answer_page(title, blocks)
