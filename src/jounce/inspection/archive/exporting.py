"""Export of results as a CSV or Parquet table with one row per wheel."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jounce.core.optional import require
from jounce.core.text import guard_row
from jounce.core.writing import Formats
from jounce.inspection.methods import METHODS
from jounce.inspection.quantities import NUMBERS

if TYPE_CHECKING:
    from jounce.inspection.archive.entries import StoredRecord

Row = dict[str, Any]
VALUES = {name: quantity.si for name, quantity in NUMBERS.items()}
"""Exported values of a wheel with their units; ``<name>_half_width`` is the half width of the 95 % interval."""
_OF_RECORD = ("number", "name", "plate", "vehicle", "date", "axle", "tester", "accepted")
TEXTS = (
    *_OF_RECORD[1:], "wheel", *(f"grade_{method}" for method in METHODS), "verdict", "reasons", "axle_verdict",
    "axle_reasons", "findings", "limits", "software",
)  # fmt: skip
COLUMNS = (
    *_OF_RECORD, "wheel", *(column for name in VALUES for column in (name, f"{name}_half_width")), "lift_off",
    *(f"grade_{method}" for method in METHODS), "verdict", "reasons", "axle_verdict", "axle_reasons",
    "findings", "limits", "software",
)  # fmt: skip


def rows_of(records: Iterable[StoredRecord]) -> list[Row]:
    """Return one row per wheel and record from the newest grading; a record without wheels has one row."""
    rows = []
    for record in records:
        about: Row = {name: getattr(record, name) for name in _OF_RECORD}
        result: Mapping[str, Any] = {} if record.grading is None else record.grading.result
        if record.grading is not None:
            grading = record.grading
            about |= {
                "axle_verdict": grading.verdict,
                "limits": grading.limits,
                "software": grading.software,
            }
            about["axle_reasons"] = " ".join(
                result.get("reasons", [])
            )  # an axle may fail although its wheels pass
        wheels = result.get("wheels") or [
            {"verdict": "not graded", "reasons": result.get("reasons", [])}
        ]
        said = _messages(result)
        rows += [
            {**about, **_of_wheel(wheel), "findings": " ".join([*_messages(wheel), *said])}
            for wheel in wheels
        ]
    return rows


def _messages(about: Mapping[str, Any]) -> list[str]:
    """Return the evaluation's messages about a wheel or a record, except problems, which are among the reasons."""
    return [
        finding["message"]
        for finding in about.get("findings", [])
        if finding["severity"] != "problem"
    ]


def _of_wheel(wheel: Mapping[str, Any]) -> Row:
    uncertainty, grade = wheel.get("uncertainty", {}), wheel.get("grade", {})
    row: Row = {
        "wheel": wheel.get("wheel"),
        "lift_off": wheel.get("lift_off"),
        "verdict": wheel["verdict"],
    }
    for name in VALUES:
        row |= {name: wheel.get(name), f"{name}_half_width": uncertainty.get(name)}
    row |= {f"grade_{method}": grade.get(method) for method in METHODS}
    return {**row, "reasons": " ".join(wheel["reasons"])}


def check_export(path: Path | str, *, force: bool = False) -> Path:
    """Raise an error for an export that cannot be written, before any work is done."""
    file = TABLES.check(path, force=force)
    if file.suffix.lower() == ".parquet":
        require("pyarrow", "lane")
    return file


def export(rows: Sequence[Row], path: Path | str, *, force: bool = False) -> Path:
    """Write rows, SI, as a table: ``.csv`` (comma, UTF-8, empty for unknown values) or ``.parquet`` (typed columns).

    The file is written atomically. Parquet requires the extra ``lane``.

    Examples
    --------
    >>> import tempfile
    >>> file = export([{"number": 1, "wheel": "left", "adhesion": 0.5}], tempfile.mkdtemp() + "/lane.csv")
    >>> file.read_text().splitlines()[1].split(",")[:11]
    ['1', '', '', '', '', '', '', '', 'left', '', '']
    """
    return TABLES.write(rows, check_export(path, force=force), force=force)


def _write_csv(rows: Sequence[Row], file: Path) -> None:
    with file.open("w", encoding="utf-8", newline="") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(guard_row(row.get(name) for name in COLUMNS) for row in rows)


def _write_parquet(rows: Sequence[Row], file: Path) -> None:
    arrow, parquet = require("pyarrow", "lane"), require("pyarrow.parquet", "lane")
    kinds = dict.fromkeys(COLUMNS, arrow.float64()) | dict.fromkeys(TEXTS, arrow.string())
    kinds |= {"number": arrow.int64(), "lift_off": arrow.bool_()}
    units = VALUES | {f"{name}_half_width": unit for name, unit in VALUES.items()}
    about = {name: {"unit": unit} for name, unit in units.items()}
    schema = arrow.schema(
        [arrow.field(name, kinds[name], metadata=about.get(name)) for name in COLUMNS]
    )
    parquet.write_table(
        arrow.Table.from_pylist([{**dict.fromkeys(COLUMNS), **row} for row in rows], schema), file
    )


TABLES = Formats("tables", {".csv": _write_csv, ".parquet": _write_parquet})
