"""Queries of a record store: vehicle history, search, export of results, verification, re-evaluation."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from jounce.core.errors import DescriptionError, RecordingError, unknown
from jounce.core.operation import Count, File, Mark, Switch, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain, to_plain
from jounce.core.shown import Shown
from jounce.core.waiting import progress_through
from jounce.inspection.archive.entries import StoredRecord
from jounce.inspection.archive.exporting import check_export, export, rows_of
from jounce.inspection.archive.history import Trend, WheelVisit, day_number, history_of, trends_of
from jounce.inspection.archive.reevaluation import Reevaluation, reevaluate
from jounce.inspection.archive.store import Store
from jounce.inspection.limits import VERDICTS, load_limits
from jounce.inspection.result import NOT_GRADED
from jounce.parts.testers import library, load_tester

STORE = Mark("The store: a SQLite file, or a database URL.", "STORE")
PLATES = Mark(
    "Number plate, or a pattern such as B-AB*; case, spaces and hyphens are ignored.", "PLATE"
)
VERDICT = Mark("Verdict of the axle: pass, advise, fail or not graded.", "VERDICT")
TESTER = Mark("Name of the tester, as in its file, or of a shipped one.", "TESTER")
SINCE, UNTIL = Mark("First day, e.g. 2026-01-31.", "DAY"), Mark("Last day.", "DAY")
COLUMNS = ("number", "date", "plate", "vehicle", "axle", "tester", "name")
"""Attributes shown in a list of records, besides the verdict."""


# history --------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class VehicleHistory(Shown):
    """The history of one vehicle.

    Attributes
    ----------
    plate, vehicle : str
        Number plate and vehicle from the newest record.
    records : tuple of int
        Numbers of its records.
    visits : tuple of WheelVisit
        Values of each wheel by date, SI.
    trends : tuple of Trend
        Change of each wheel's values per year.
    """

    plate: str
    vehicle: str
    records: tuple[int, ...]
    visits: tuple[WheelVisit, ...]
    trends: tuple[Trend, ...]

    @property
    def title(self) -> str:
        """Number plate and vehicle."""
        return ", ".join(filter(None, (self.plate, self.vehicle)))

    def to_dict(self) -> dict[str, Any]:
        """Return visits and trends as plain data, SI."""
        wheels = [
            {
                "record": visit.record,
                "date": visit.date,
                "axle": visit.axle,
                "wheel": visit.wheel,
                **visit.values,
                "verdict": visit.verdict,
                "limits": visit.limits,
                "unreliable": visit.unreliable,
            }
            for visit in self.visits
        ]
        about = {"plate": self.plate, "vehicle": self.vehicle, "records": list(self.records)}
        plain: dict[str, Any] = to_plain({**about, "wheels": wheels, "trends": self.trends})
        return plain


@operation(
    "inspect history",
    arguments=0,
    offers=("figure", "report"),
    figure="jounce.plots.inspection:history_figure",
    page="jounce.report.stores:vehicle_history_page",
    title="{result.title}",
    doing="reading the store",
    example='jounce inspect history --plate "B-AB 123" --store lane.sqlite --figure history.svg',
)
def read_inspection_history(
    plate: Annotated[str, Mark("Number plate; case, spaces and hyphens are ignored.", "PLATE")],
    store: Annotated[Path | str, STORE],
) -> VehicleHistory:
    """Show the history of one vehicle: adhesion, phase angle and damping ratio of each wheel, and their trends.

    Parameters
    ----------
    plate : str
        Number plate; case, spaces and hyphens are ignored.
    store : Path or str
        SQLite file, or a database URL.

    Returns
    -------
    VehicleHistory
        Visits of each wheel, SI, with the change of each value per year.

    Raises
    ------
    RecordingError
        If the store does not exist or has no record of this plate.

    Examples
    --------
    >>> import tempfile
    >>> file = tempfile.mkdtemp() + "/lane.sqlite"
    >>> Store(file).close()
    >>> read_inspection_history("B-AB 123", file)   # doctest: +ELLIPSIS
    Traceback (most recent call last):
    jounce.core.errors.RecordingError: ...: no record of this number plate; found 'B-AB 123'. List the vehicles ...
    """
    with closing(Store(store, read_only=True)) as opened:
        records, visits = opened.records(plate=plate), history_of(opened, plate)
        if not records:
            raise RecordingError(
                "no record of this number plate",
                where=opened.location,
                found=plate,
                hint="List the vehicles with: jounce inspect search.",
            )
    newest, numbers = records[-1], tuple(record.number for record in records)
    return VehicleHistory(
        newest.plate, newest.vehicle, numbers, tuple(visits), tuple(trends_of(visits))
    )


# search ---------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class FoundRecords(Shown):
    """Records of a store that match the given conditions: location of the store, and records by number."""

    store: str
    records: tuple[StoredRecord, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return the metadata of each record, with its newest verdict."""
        return {"store": self.store, "records": [_summary(record) for record in self.records]}


def _summary(record: StoredRecord) -> dict[str, Any]:
    grading = record.grading
    about = {name: getattr(record, name) for name in (*COLUMNS, "accepted")}
    return {**about, "verdict": grading and grading.verdict, "limits": grading and grading.limits}


@operation(
    "inspect search",
    arguments=0,
    page="jounce.report.stores:record_search_page",
    title="{result.store}",
    doing="reading the store",
    example="jounce inspect search --store lane.sqlite --verdict fail --since 2026-01-01",
)
def find_inspections(
    store: Annotated[Path | str, STORE],
    plate: Annotated[str | None, PLATES] = None,
    verdict: Annotated[str | None, VERDICT] = None,
    tester: Annotated[str | None, TESTER] = None,
    since: Annotated[str | None, SINCE] = None,
    until: Annotated[str | None, UNTIL] = None,
) -> FoundRecords:
    """Find records by plate, verdict, tester and date.

    Parameters
    ----------
    store : Path or str
        SQLite file, or a database URL.
    plate : str, optional
        Number plate, or a pattern such as ``B-AB*``; case, spaces and hyphens are ignored.
    verdict : str, optional
        Verdict of the axle: pass, advise, fail or not graded.
    tester : str, optional
        Name of the tester, as in its file, or of a shipped one.
    since, until : str, optional
        First and last day, such as ``2026-01-31``.

    Returns
    -------
    FoundRecords
        Records with their newest gradings.

    Raises
    ------
    RecordingError
        If the store does not exist.
    DescriptionError
        For an unknown verdict or an invalid date.

    Examples
    --------
    >>> import tempfile
    >>> file = tempfile.mkdtemp() + "/lane.sqlite"
    >>> Store(file).close()
    >>> find_inspections(file, verdict="fail").records
    ()
    """
    conditions = _conditions(plate, verdict, tester, since, until)
    with closing(Store(store, read_only=True)) as opened:
        return FoundRecords(opened.location, tuple(opened.records(**conditions)))


def _conditions(
    plate: str | None, verdict: str | None, tester: str | None, since: str | None, until: str | None
) -> dict[str, Any]:
    """Check the conditions of a search."""
    words = tuple(dict.fromkeys((*VERDICTS, NOT_GRADED)))
    if verdict is not None and verdict not in words:
        raise unknown(verdict, words, what="verdict", where="verdict")
    for name, day in (("since", since), ("until", until)):
        if day is not None and day_number(day) is None:
            raise DescriptionError("not a date", where=name, found=day, allowed="e.g. 2026-01-31")
    if tester is not None:
        tester = load_tester(tester).name if tester in library() else tester
    return {"plate": plate, "verdict": verdict, "tester": tester, "since": since, "until": until}


# table ----------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class ExportedRecords(Plain):
    """A written table: store, file, counts of records and rows, and the losses of a damaged store."""

    store: str
    out: str
    records: int
    rows: int
    lost: tuple[str, ...] = ()

    @property
    def remark(self) -> str:
        """Summary of unreadable data."""
        return "; ".join(self.lost)

    @property
    def is_met(self) -> bool:
        """Whether nothing is lost."""
        return not self.lost


@operation(
    "inspect export",
    arguments=0,
    page="jounce.report.stores:exported_records_page",
    title="{result.store}",
    doing="reading the store",
    example="jounce inspect export --store lane.sqlite --out lane.parquet --since 2026-01-01",
)
def export_inspections(
    store: Annotated[Path | str, STORE],
    out: Annotated[Path | str, File("Table to write: .csv or .parquet.", "FILE")],
    *,
    plate: Annotated[str | None, PLATES] = None,
    verdict: Annotated[str | None, VERDICT] = None,
    tester: Annotated[str | None, TESTER] = None,
    since: Annotated[str | None, SINCE] = None,
    until: Annotated[str | None, UNTIL] = None,
    damaged: Annotated[
        bool, Switch("Write everything that can still be read from a damaged store.")
    ] = False,
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
) -> ExportedRecords:
    """Write the latest results as a table with one row per wheel (SI).

    Parameters
    ----------
    store : Path or str
        SQLite file, or a database URL.
    out : Path or str
        Table to write: ``.csv``, or ``.parquet`` (extra ``lane``).
    plate, verdict, tester, since, until : str, optional
        Conditions, as for :func:`find_inspections`.
    damaged : bool
        Whether to write everything readable from a damaged store, ignoring the conditions.
    force : bool
        Whether to overwrite an existing file.

    Returns
    -------
    ExportedRecords
        Numbers of written records and rows, and unreadable data.

    Raises
    ------
    RecordingError
        If the store does not exist, or is damaged and ``damaged`` is not set.
    OutputError
        For an unsupported suffix or an existing file.

    Examples
    --------
    >>> import tempfile
    >>> folder = tempfile.mkdtemp()
    >>> Store(folder + "/lane.sqlite").close()
    >>> export_inspections(folder + "/lane.sqlite", folder + "/lane.csv").rows
    0
    """
    conditions = _conditions(plate, verdict, tester, since, until)
    check_export(out, force=force)
    lost: Sequence[str] = ()
    with closing(Store(store, read_only=True, damaged=damaged)) as opened:
        if damaged:
            records, lost = opened.readable_records()
        else:
            records = opened.records(**conditions)
    rows = rows_of(records)
    export(rows, out, force=force)
    return ExportedRecords(opened.location, str(out), len(records), len(rows), tuple(lost))


# verification and re-evaluation ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class VerifiedStore(Plain):
    """A verified store: location and number of records."""

    store: str
    records: int
    problems: tuple[str, ...] = ()


@operation(
    "inspect verify",
    arguments=0,
    page="jounce.report.stores:verified_store_page",
    title="{result.store}",
    doing="reading the store",
    example="jounce inspect verify --store lane.sqlite",
)
def verify_inspections(store: Annotated[Path | str, STORE]) -> VerifiedStore:
    """Check a store byte by byte: the database, and every record against its checksum. Nothing is written.

    Parameters
    ----------
    store : Path or str
        SQLite file, or a database URL.

    Returns
    -------
    VerifiedStore
        Location and number of records.

    Raises
    ------
    RecordingError
        If the store does not exist or is damaged in any way.

    Examples
    --------
    >>> import tempfile
    >>> file = tempfile.mkdtemp() + "/lane.sqlite"
    >>> Store(file).close()
    >>> verify_inspections(file).records
    0
    """
    with closing(Store(store, read_only=True)) as opened:
        problems, count = opened.problems(), len(opened.numbers())
    if problems:
        raise RecordingError(
            Phrase("the store is damaged: {problems}", problems="; ".join(problems)),
            where=opened.location,
            hint="Use a backup copy of the store.",
        )
    return VerifiedStore(opened.location, count)


@dataclass(frozen=True)
class ReevaluatedStore(Shown):
    """A re-evaluated store: location, limits, and result."""

    store: str
    limits: str
    result: Reevaluation

    @property
    def is_met(self) -> bool:
        """Whether every record was readable."""
        return not self.result.failed

    def to_dict(self) -> dict[str, Any]:
        """Return counts, changes of verdicts, and unreadable records as plain data."""
        result = self.result
        changes = [
            {"before": a, "after": b, "records": count} for (a, b), count in result.changes.items()
        ]
        names = ("records", "added", "unchanged", "changed", "failed")
        about = {
            "store": self.store,
            "limits": self.limits,
            **{name: getattr(result, name) for name in names},
        }
        plain: dict[str, Any] = to_plain({**about, "changes": changes})
        return plain


@operation(
    "inspect reevaluate",
    arguments=0,
    page="jounce.report.stores:reevaluated_store_page",
    title="{result.store}",
    doing="evaluating",
    example="jounce inspect reevaluate --store lane.sqlite --limits stricter.toml",
)
def reevaluate_inspections(
    store: Annotated[Path | str, STORE],
    limits: Annotated[
        Path | str | None, File("A limits file instead of the shipped limits.", "FILE")
    ] = None,
    *,
    tester: Annotated[
        Path | str | None,
        Mark(
            "Tester of records that name none: a tester file, or the name of a shipped one.",
            "TESTER",
        ),
    ] = None,
    workers: Annotated[int, Count("Number of processes.", least=1)] = 2,
    from_files: Annotated[bool, Switch("Read the original files again (slower).")] = False,
    progress: Callable[[str], None] = lambda _: None,
) -> ReevaluatedStore:
    """Evaluate and grade all stored records again, optionally with different limits; earlier gradings are kept.

    Parameters
    ----------
    store : Path or str
        SQLite file, or a database URL.
    limits : Path or str, optional
        Limits file instead of the shipped limits.
    tester : Path or str, optional
        Tester of records that name none.
    workers : int
        Number of processes, 1 or more.
    from_files : bool
        Whether to read the original files again (slower).
    progress : callable
        Called with a progress text of one line.

    Returns
    -------
    ReevaluatedStore
        Added gradings and changes of verdicts.

    Raises
    ------
    RecordingError
        If the store does not exist.
    DescriptionError
        For invalid limits or an invalid tester.

    Examples
    --------
    >>> import tempfile
    >>> file = tempfile.mkdtemp() + "/lane.sqlite"
    >>> Store(file).close()
    >>> reevaluate_inspections(file).result.records
    0
    """
    if workers < 1:
        raise DescriptionError(
            "invalid number of processes", where="workers", found=workers, allowed="1 or more"
        )
    chosen, graded_by = None if tester is None else load_tester(tester), load_limits(limits)
    Store(store, read_only=True).close()  # raises an error instead of creating a missing store
    with closing(Store(store)) as opened:
        result = reevaluate(
            opened,
            graded_by,
            tester=chosen,
            workers=workers,
            from_files=from_files,
            say=lambda done, number: progress(
                progress_through("evaluated {which} of {count}", done, number)
            ),
        )
    return ReevaluatedStore(opened.location, graded_by.label, result)
