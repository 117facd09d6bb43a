"""One record through the lane: read, evaluated, graded, and as an entry of the store."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jounce.core.errors import JounceError
from jounce.inspection.evaluation import evaluate
from jounce.inspection.grading import GradedInspection, grade
from jounce.inspection.limits import Limits, load_limits
from jounce.inspection.record import read_record
from jounce.inspection.result import NOT_GRADED

if TYPE_CHECKING:
    import xarray as xr

    from jounce.core.findings import Finding
    from jounce.inspection.store import Grading, RecordEntry
    from jounce.parts.testers import Tester


@dataclass(frozen=True)
class InspectedRecord:
    """A record with what came of it.

    Attributes
    ----------
    path : Path
        Its file.
    record : xarray.Dataset
        Plate heights (m) and forces (N) on ``time`` (s).
    graded : GradedInspection
        Values, grades, verdicts, reasons.
    """

    path: Path
    record: xr.Dataset
    graded: GradedInspection

    @property
    def facts(self) -> dict[str, str]:
        """What the record's header says in words."""
        return {name: value for name, value in self.graded.inspection.facts.items() if isinstance(value, str)}


def inspect_record(
    path: Path | str,
    tester: Tester,
    vehicle: Any = None,
    methods: Sequence[str] | None = None,
    limits: Limits | None = None,
    *,
    read: tuple[xr.Dataset, list[Finding]] | None = None,
) -> InspectedRecord:
    """Read a record of one axle, evaluate and grade it.

    Parameters
    ----------
    path : Path or str
        The record, with its header or the TOML file beside it.
    tester : Tester
        On which it was made. Its own method decides where ``methods`` does not say otherwise.
    vehicle : Rig or Vehicle, optional
        Under test.
    methods : sequence of {"eusama", "egea", "theta", "boge"}, optional
        What to evaluate and what decides; by default all that the plate allows are graded, and the tester's decides.
    limits : Limits, optional
        Those that come with jounce by default.
    read : (Dataset, list of Finding), optional
        What ``read_record`` gave for this file already.

    Returns
    -------
    InspectedRecord
        Also for a record that is unfit: its wheels are not graded then.

    Raises
    ------
    RecordingError
        For a file that cannot be read.
    DescriptionError
        For a wrong header, an unknown method, or one that the plate does not allow.
    """
    record, findings = read if read is not None else read_record(path, tester)
    inspection = evaluate(record, tester, vehicle, methods)
    known = {(one.place, one.message) for one in inspection.findings}
    new = [one for one in findings if (one.place, one.message) not in known]
    inspection = replace(inspection, findings=(*new, *inspection.findings))
    graded = grade(inspection, limits, deciding=list(methods) if methods else [tester.method])
    return InspectedRecord(Path(path), record, graded)


def entry_of(path: Path | str, facts: dict[str, str] | None = None, tester: Tester | None = None) -> RecordEntry:
    """Give a record's file, and the TOML file beside it, as they are, with what is known of them (``facts``)."""
    from jounce.inspection.store import RecordEntry

    file, known = Path(path), facts or {}
    beside = file.with_suffix(".toml")
    return RecordEntry(
        file.name,
        file.read_bytes(),
        beside.read_bytes() if beside != file and beside.is_file() else None,
        plate=known.get("plate_number", ""),
        vehicle=known.get("vehicle", ""),
        date=known.get("date", ""),
        axle=known.get("axle", ""),
        tester=tester.name if tester is not None else known.get("tester", ""),
    )


def grading_of(graded: GradedInspection) -> Grading:
    """Give what the store keeps of a graded axle."""
    from jounce.inspection.store import Grading

    return Grading(graded.verdict, graded.limits.label, metadata.version("jounce"), graded.to_dict())


def refusal_of(error: JounceError, limits: Limits | None = None) -> Grading:
    """Give what the store keeps of a record that cannot be read: not graded, with the reason."""
    from jounce.inspection.store import Grading

    label = (limits if limits is not None else load_limits()).label
    plain = {"wheels": [], "axle": {}, "verdict": NOT_GRADED, "reasons": [str(error)]}
    return Grading(NOT_GRADED, label, metadata.version("jounce"), plain)
