"""Requests of the page without an equivalent command, such as the preview of a file or the overlay of rides.

They are answered in a process of their own, so that the server needs neither the memory nor the libraries for them.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.errors import JounceError, unforeseen
from jounce.core.findings import Finding, for_page, with_german
from jounce.core.serialise import to_json, to_plain
from jounce.core.types import Array
from jounce.web.project import unusable

_MOST_COLUMNS, _MOST_POINTS = 200, 2000


def answer(question: Mapping[str, Any], folder: Path) -> int:
    """Print the answer as one JSON object; return the exit code. Documents are written into the folder."""
    try:
        if question["kind"] == "levels":
            from jounce.web.levels import write_levels

            reply = write_levels(Path(question["file"]), Path(question["folder"]))
        elif question["kind"] == "formulas":
            from jounce.web.formulas import write_formulas

            reply = write_formulas(question)
        elif question["kind"] == "overlay":
            from jounce.web.rides import overlaid

            reply = overlaid(question)
        elif question["kind"] == "align":
            reply = align(question)
        elif question["kind"] == "export":
            from jounce.web.exports import DOCUMENT, Exported, exported

            content = exported(Exported.model_validate_json(question["asked"]))
            reply = {"bytes": (folder / DOCUMENT).write_bytes(content)}
        elif question["kind"] == "swept":
            from jounce.web.project import Project
            from jounce.web.studies import swept

            reply = swept(Project(question["root"]), question["folder"])
        elif question["kind"] == "damper-map":
            from jounce.web.damper_maps import write_map

            reply = write_map(question, folder)
        elif question["kind"] == "preview-files":
            reply = preview_all(question)
        else:
            reply = preview(question)
        sys.stdout.write(to_json(for_page(to_plain(reply))))
    except Exception as error:  # noqa: BLE001 - any failure on a file is reported
        known = unusable(error, "") if isinstance(error, OSError) else unforeseen(error)
        plain = {
            "message": known.message(),
            "what": known.what,
            "where": known.where,
            "found": None if known.found is None else str(known.found),
            "allowed": known.allowed or None,
            "hint": known.hint or None,
        }
        sys.stdout.write(to_json({"error": with_german(plain)}))
        return 2
    return 0


def align(asked: Mapping[str, Any]) -> dict[str, Any]:
    """Return the shift of a recording onto another; both are stored already, in the given folders."""
    from jounce.analysis.layouts import Layout
    from jounce.web.overlays import aligned, tracks_of
    from jounce.web.stored import StoredRecords

    layout = Layout(**asked["layout"])
    return aligned(layout, tracks_of(StoredRecords(asked["folders"]), layout), **asked["how"])


def preview_all(asked: Mapping[str, Any]) -> dict[str, Any]:
    """Return previews of measured files before they enter a campaign."""
    from jounce.campaign.arrivals import preview_files
    from jounce.campaign.laboratory import read_trial_text

    rows = read_trial_text(asked["table"]) if asked["table"].strip() else None
    return preview_files(asked["files"], asked["columns"], rows).to_dict()


def preview(asked: Mapping[str, Any]) -> dict[str, Any]:
    """Return the columns of a file as written, and the data read from them with the given names and signs.

    If they cannot be read, ``problem`` contains the reason, along with the available columns.
    """
    from jounce.recordings.reader import ReaderOptions
    from jounce.recordings.readers import read_signals

    file = Path(asked["files"][0])
    table = read_signals(file, ReaderOptions(asked["variable"]))
    columns = [
        {
            "name": column.written or column.name,
            "unit": column.unit,
            **_ends(column.values if column.part is None else column.part[1]),
        }
        for part in table.tables
        for column in part
    ]
    answer: dict[str, Any] = {
        "columns": columns[:_MOST_COLUMNS],
        "more": max(0, len(columns) - _MOST_COLUMNS),
    }
    try:
        read = _force_deflection if asked["form"] == "force-deflection" else _recording
        shown, findings = read(file, asked)
    except JounceError as error:
        return answer | {
            "problem": error.message(),
            "findings": [],
            "content": None,
            "points": None,
        }
    return answer | {"problem": None, "findings": to_plain(findings)} | shown


def _recording(file: Path, asked: Mapping[str, Any]) -> tuple[dict[str, Any], list[Finding]]:
    from jounce.identify.signs import compression_positive
    from jounce.recordings import read_recording
    from jounce.report.live import Viewer, live_data
    from jounce.report.recordings import curve_blocks

    given = {name: asked[name] or None for name in ("columns", "sample_time", "resample")}
    record, findings = read_recording(file, variable=asked["variable"], **given)
    record = compression_positive(
        record, asked["stroke_positive"] or None, asked["force_positive"] or None
    )
    blocks = curve_blocks({"": {file.name: record}})
    return {
        "content": live_data([block for block in blocks if isinstance(block, Viewer)]),
        "points": None,
    }, findings


def _force_deflection(file: Path, asked: Mapping[str, Any]) -> tuple[dict[str, Any], list[Finding]]:
    from jounce.campaign.characterise import read_force_deflection
    from jounce.identify.signs import sign_of
    from jounce.recordings.formats import TableFormat

    table_format = TableFormat(columns=asked["columns"], variable=asked["variable"])
    trials, findings = read_force_deflection(
        [file], table_format, asked["stroke_positive"] or None, asked["force_positive"] or None
    )
    deflection, force = trials[0].arrays()
    deflection = deflection * sign_of(asked["stroke_positive"] or None, "stroke")
    force = force * sign_of(asked["force_positive"] or None, "force")
    step = max(1, -(-len(deflection) // _MOST_POINTS))
    points = {
        "x": (1e3 * deflection[::step]).tolist(),
        "y": force[::step].tolist(),
        "count": len(deflection),
    }
    return {"content": None, "points": points}, findings


def _ends(values: Array) -> dict[str, float | int | None]:
    """Return minimum and maximum of a numeric column."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiub" or not array.size:
        return {"count": int(array.size), "least": None, "greatest": None}
    finite = array[np.isfinite(array)] if array.dtype.kind == "f" else array
    ends = (float(finite.min()), float(finite.max())) if finite.size else (None, None)
    return {"count": int(array.size), "least": ends[0], "greatest": ends[1]}
