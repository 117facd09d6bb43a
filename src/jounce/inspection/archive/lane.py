"""Processing of one record: reading, evaluation, grading, and storing."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from importlib import metadata
from itertools import takewhile
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jounce.core.description import toml_table
from jounce.core.errors import (
    JounceError,
    OutputError,
    RecordingError,
    ResourceError,
    is_of_system,
    resource_error,
    unknown,
)
from jounce.core.files import content_of
from jounce.core.operation import Mark
from jounce.core.writing import working_folder
from jounce.inspection.archive.entries import Grading, RecordEntry, pack
from jounce.inspection.evaluation import evaluate
from jounce.inspection.grading import GradedInspection, grade
from jounce.inspection.limits import Limits, load_limits
from jounce.inspection.methods import METHODS
from jounce.inspection.record import SIDES, TEXTS, day_of, read_record
from jounce.inspection.result import NOT_GRADED
from jounce.parts.testers import Tester, library, load_tester

if TYPE_CHECKING:
    import xarray as xr

    from jounce.core.findings import Finding
    from jounce.inspection.archive.store import Store
    from jounce.inspection.result import Inspection

_HEADER_BYTES = 65536  # far more than any header

LIMITS = Mark("A limits file instead of the shipped limits.")


@dataclass(frozen=True)
class InspectedRecord:
    """A record with its evaluation and grading."""

    path: Path  # file of the record
    record: xr.Dataset  # plate heights (m) and forces (N) on ``time`` (s)
    graded: GradedInspection  # values, grades, verdicts, reasons

    @property
    def facts(self) -> dict[str, str]:
        """Return the texts of the record's header."""
        return {
            name: value
            for name, value in self.graded.inspection.facts.items()
            if isinstance(value, str)
        }


def check_methods(methods: Sequence[str] | None) -> list[str] | None:
    """Check methods and remove duplicates; return None if there are none."""
    for method in methods or ():
        if method not in METHODS:
            raise unknown(method, METHODS, what="method", where="methods")
    return list(dict.fromkeys(methods or ())) or None


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
        Record with a header or an accompanying TOML file.
    tester : Tester
        Tester of the record. Its method decides unless ``methods`` is given.
    vehicle : Rig or Vehicle, optional
        Vehicle under test.
    methods : sequence of {"eusama", "egea", "theta", "boge"}, optional
        Methods to evaluate, which decide; by default all that the plate supports, and the tester's method decides.
    limits : Limits, optional
        Limits to apply; by default the shipped ones.
    read : (Dataset, list of Finding), optional
        Result of an earlier ``read_record`` for this file.

    Returns
    -------
    InspectedRecord
        Result; wheels of an unusable record are not graded.

    Raises
    ------
    RecordingError
        For a file that cannot be read.
    DescriptionError
        For an invalid header, or a method that is unknown or not supported by the plate.
    """
    record, findings = read if read is not None else read_record(path, tester)
    inspection = evaluate(record, tester, vehicle, methods)
    inspection = replace(inspection, findings=_without_repeats(findings, inspection))
    graded = grade(inspection, limits, deciding=list(methods) if methods else [tester.method])
    return InspectedRecord(Path(path), record, graded)


def _without_repeats(findings: Sequence[Finding], inspection: Inspection) -> tuple[Finding, ...]:
    """Combine the findings of reader and evaluation without duplicates and without untested wheels."""
    unused = [
        f"{side}." for side in SIDES if all(wheel.wheel != side for wheel in inspection.wheels)
    ]
    read = [item for item in findings if not any(side in item.place for side in unused)]
    places = {
        item.place
        for wheel in inspection.wheels
        for item in wheel.findings
        if _is_of_clipping(item)
    }
    read = [
        item
        for item in read
        if not (_is_of_clipping(item) and item.place.rpartition(": ")[2] in places)
    ]
    messages = {item.message for item in read}
    return (*read, *(item for item in inspection.findings if item.message not in messages))


def _is_of_clipping(finding: Finding) -> bool:
    return finding.code in ("recordings.clipped", "reading_clipped", "clipped", "saturated")


def entry_of(
    path: Path | str,
    facts: Mapping[str, str] | None = None,
    tester: Tester | None = None,
    *,
    vehicle: Any = None,
    methods: Sequence[str] | None = None,
) -> RecordEntry:
    """Return a record's unchanged file and accompanying TOML file, with metadata.

    Metadata missing in ``facts`` (plate number, vehicle, date, axle, tester) is taken from the header. Tester, vehicle
    and methods are used for all evaluations.
    """
    file = Path(path)
    beside = file.with_suffix(".toml")
    content = content_of(file, RecordingError)
    sidecar = content_of(beside, RecordingError) if beside != file and beside.is_file() else None
    known = {
        **header_facts(content, sidecar),
        **{name: text for name, text in (facts or {}).items() if text},
    }
    return RecordEntry(
        file.name,
        content,
        sidecar,
        plate=known.get("plate_number", ""),
        vehicle=known.get("vehicle", ""),
        date=day_of(known.get("date", "")),
        axle=known.get("axle", ""),
        tester=tester.name if tester is not None else known.get("tester", ""),
        tester_table=None if tester is None else _table_of(tester),
        vehicle_table=None if vehicle is None else _table_of(vehicle),
        methods=tuple(methods or ()),
    )


def header_facts(content: bytes, sidecar: bytes | None = None) -> dict[str, str]:
    r"""Return the readable texts of a record's header; the record may be damaged.

    Examples
    --------
    >>> header_facts(b'# plate_number = "B-AB 123"\n# date = 2026-11-21\ntime [s], left.pla', b'axle = "front"')
    {'axle': 'front', 'plate_number': 'B-AB 123', 'date': '2026-11-21'}
    """
    said = [] if sidecar is None else [sidecar.decode("utf-8", errors="replace")]
    lines = content[:_HEADER_BYTES].decode("utf-8-sig", errors="replace").splitlines()
    comments = takewhile(lambda line: line.lstrip()[:1] in ("#", ""), lines)
    said += [line.lstrip()[1:] for line in comments if line.strip()]
    facts: dict[str, str] = {}
    for text in said:
        try:
            table = toml_table(text)
        except tomllib.TOMLDecodeError:
            continue
        facts |= {name: str(value) for name, value in table.items() if name in TEXTS}
    return facts


def _table_of(description: Any) -> dict[str, Any]:
    table: dict[str, Any] = description.model_dump(mode="json", by_alias=True, exclude_none=True)
    return table


def grading_of(graded: GradedInspection) -> Grading:
    """Create the stored grading of a graded axle."""
    return Grading(
        graded.verdict, graded.limits.label, metadata.version("jounce"), graded.to_dict()
    )


def refusal_of(error: Exception, limits: Limits | None = None) -> Grading:
    """Create the stored grading of an unreadable record: not graded, with the reason."""
    label = (limits if limits is not None else load_limits()).label
    plain = {"wheels": [], "axle": {}, "verdict": NOT_GRADED, "reasons": [str(error)]}
    return Grading(NOT_GRADED, label, metadata.version("jounce"), plain)


@dataclass(frozen=True)
class ImportedRecord:
    """Outcome of an import."""

    file: str
    number: int  # number of the record in the store
    is_new: bool  # false if the same file was already in the store
    verdict: str  # verdict of the axle; ``"not graded"`` if the record is unusable
    problem: str = ""  # why the record could not be graded; empty if it was graded
    warnings: int = 0  # number of findings about values of the record and its wheels

    def __str__(self) -> str:
        word = "accepted" if self.is_new else "known"
        reason = f" ({self.problem})" if self.problem else ""
        warned = f", {self.warnings} warning{'s' * (self.warnings > 1)}" if self.warnings else ""
        return f"{word} {self.number} {self.file}: {self.verdict}{reason}{warned}"


def import_record(
    file: Path | str,
    store: Store,
    tester: Tester | None = None,
    *,
    vehicle: Any = None,
    methods: Sequence[str] | None = None,
    limits: Limits | None = None,
) -> ImportedRecord:
    """Evaluate, grade and store a record in one transaction.

    Parameters
    ----------
    file : Path or str
        Record; an accompanying TOML file is included. Neither file is moved.
    store : Store
        Store opened for writing.
    tester : Tester, optional
        Tester of the record; by default the shipped one named in the header.
    vehicle : Rig or Vehicle, optional
        Vehicle under test.
    methods : sequence of {"eusama", "egea", "theta", "boge"}, optional
        Methods to evaluate, which decide.
    limits : Limits, optional
        Limits to apply; by default the shipped ones.

    Returns
    -------
    ImportedRecord
        Outcome; the record is then safely stored. A record that cannot be graded is stored with the reasons.

    Raises
    ------
    OutputError
        If the store or a temporary file cannot be written; nothing is stored in that case.
    RecordingError
        For an empty file, or a damaged store.
    OSError
        If the file cannot be read.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.inspection.archive.store import Store
    >>> folder = Path(tempfile.mkdtemp())
    >>> _ = (folder / "half.csv").write_text("time [s], left.plate.z [mm]")
    >>> with_reason = import_record(folder / "half.csv", Store(folder / "lane.sqlite"))
    >>> with_reason.number, with_reason.is_new, with_reason.verdict
    (1, True, 'not graded')
    """
    entry = entry_of(file, tester=tester, vehicle=vehicle, methods=methods)
    if not entry.content:
        raise RecordingError("the file is empty", where=str(file))
    known = store.number_of(entry.digest)
    if known is not None:
        return _describe_known(str(file), known, store)
    graded, grading = None, None
    try:
        entry = _with_tester(entry, tester)
        entry, graded = _evaluate(entry, vehicle, limits)
        grading = grading_of(graded)
    except (OutputError, OSError):  # the record was not evaluated, so this is not a verdict
        raise
    except Exception as error:  # noqa: BLE001 - the record must not be lost, whatever error occurs
        if is_of_system(error):
            raise resource_error(error, str(file)) from None
        problem = (
            error
            if isinstance(error, JounceError)
            else RuntimeError(f"the evaluation failed: {error!r}")
        )
        grading = refusal_of(problem, limits)
    number, is_new = store.accept(entry, grading)
    return (
        _describe_known(str(file), number, store)
        if not is_new
        else ImportedRecord(
            str(file), number, True, grading.verdict, problem_of(grading), warnings_of(grading)
        )
    )


def problem_of(grading: Grading) -> str:
    """Return why a record could not be graded; empty if it was graded or only one wheel was tested."""
    wheels = grading.result.get("wheels", [])
    reasons: list[str] = [] if wheels else list(grading.result.get("reasons", []))
    for wheel in wheels:
        if wheel["verdict"] == NOT_GRADED:
            reasons += wheel["reasons"][:1] or [f"the {wheel['wheel']} wheel is not graded."]
    return reasons[0] if reasons and grading.verdict == NOT_GRADED else ""


def _describe_known(file: str, number: int, store: Store) -> ImportedRecord:
    grading = store.newest_grading(number)
    if grading is None:
        return ImportedRecord(file, number, False, NOT_GRADED)
    return ImportedRecord(
        file, number, False, grading.verdict, problem_of(grading), warnings_of(grading)
    )


def warnings_of(grading: Grading) -> int:
    """Count the warnings about values of a record or its wheels, such as a tyre leaving the plate."""
    places = [grading.result, *grading.result.get("wheels", [])]
    return sum(
        item["severity"] == "warning" for place in places for item in place.get("findings", [])
    )


def _with_tester(entry: RecordEntry, tester: Tester | None) -> RecordEntry:
    """Use the tester named in the header if none is given, without guessing."""
    if tester is not None:
        return entry
    shipped = {
        text: shipped_tester
        for name in library()
        for shipped_tester in (load_tester(name),)
        for text in (name, shipped_tester.name)
    }
    if entry.tester not in shipped:
        raise RecordingError(
            "no tester is given, and the record does not name a known one",
            where=entry.name,
            found=entry.tester,
            allowed=", ".join(library()),
            hint="Grade the record with: jounce inspect reevaluate --tester.",
        )
    return replace(entry, tester_table=_table_of(shipped[entry.tester]))


def _evaluate(
    entry: RecordEntry, vehicle: Any, limits: Limits | None
) -> tuple[RecordEntry, GradedInspection]:
    """Evaluate the stored bytes of an entry; return it with its signals."""
    tester = stored_tester(entry)
    record, findings = read_entry(entry, tester)
    inspection = inspect_record(
        entry.name, tester, vehicle, entry.methods or None, limits, read=(record, findings)
    )
    facts = inspection.facts
    filled = replace(
        entry,
        plate=entry.plate or facts.get("plate_number", ""),
        vehicle=entry.vehicle or facts.get("vehicle", ""),
        date=entry.date or day_of(facts.get("date", "")),
        axle=entry.axle or facts.get("axle", ""),
        signals=pack(record, findings),
    )
    return filled, inspection.graded


def stored_tester(entry: RecordEntry) -> Tester:
    """Return the tester of a stored record from its description."""
    if entry.tester_table is None:
        raise RecordingError(
            "the tester of this record is unknown",
            where=entry.name,
            hint="Name the tester with --tester.",
        )
    return Tester.from_table(dict(entry.tester_table), where=entry.tester)


def read_entry(entry: RecordEntry, tester: Tester) -> tuple[xr.Dataset, list[Finding]]:
    """Read the signals of an entry from its bytes."""
    with working_folder() as folder:
        file, beside = folder / _file_name(entry.name), f"{folder}{os.sep}"
        file.write_bytes(entry.content)
        if entry.sidecar is not None:
            file.with_suffix(".toml").write_bytes(entry.sidecar)
        try:
            record, findings = read_record(file, tester)
            record = record.load()
        except (OutputError, ResourceError):
            raise
        except JounceError as error:
            where = error.where.replace(beside, "")
            raise RecordingError(
                error.what, where=where, found=error.found, allowed=error.allowed, hint=error.hint
            ) from None
    return record, [
        replace(
            item, place=item.place.replace(beside, ""), message=item.message.replace(beside, "")
        )
        for item in findings
    ]


def _file_name(name: str) -> str:
    """Return the file name of an entry: its own if valid."""
    own = Path(name.replace("\0", "")).name
    return (
        own
        if own not in ("", "..") and len(os.fsencode(own)) < _LONGEST_NAME
        else f"record{Path(own).suffix[:16]}"
    )


_LONGEST_NAME = 240  # bytes; systems allow 255
