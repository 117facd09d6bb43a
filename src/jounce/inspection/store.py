"""The lane's record store: raw records and their gradings in one SQL database, SQLite unless another one is named.

Every record goes in with its grading in one transaction: after a crash it is there whole, or not at all. Two processes
may write at once. Records are kept as the bytes that came in; gradings are added, never replaced.
"""

from __future__ import annotations

import hashlib
import json
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jounce.core.errors import JounceError, OutputError, RecordingError
from jounce.core.serialise import to_json
from jounce.inspection.tables import RECORDS, RESULTS, SCHEMA_VERSION, VEHICLES, create_tables

if TYPE_CHECKING:
    from sqlalchemy.engine import Connection, Engine

_WAIT = 30.0  # s that a writer waits for another one
_WHOLE = "ok"


@dataclass(frozen=True)
class RecordEntry:
    """What comes in: the file as it is, and what is known of it.

    Attributes
    ----------
    name : str
        Name of the file.
    content : bytes
        The file.
    sidecar : bytes or None
        The TOML file beside it, where there is one.
    plate : str
        Number plate of the vehicle; empty where nothing says it.
    vehicle : str
        What vehicle it is.
    date : str
        Day of the inspection, ISO 8601.
    axle : str
        ``"front"``, ``"rear"`` or another name.
    tester : str
        Name of the tester.
    """

    name: str
    content: bytes = field(repr=False)
    sidecar: bytes | None = field(default=None, repr=False)
    plate: str = ""
    vehicle: str = ""
    date: str = ""
    axle: str = ""
    tester: str = ""

    @property
    def digest(self) -> str:
        """SHA-256 of file and sidecar."""
        return hashlib.sha256(self.content + b"\0" + (self.sidecar or b"")).hexdigest()


@dataclass(frozen=True)
class Grading:
    """One grading of a record.

    Attributes
    ----------
    verdict : str
        One word.
    limits : str
        Version of the limits.
    software : str
        Version of what graded it.
    result : mapping
        Plain values, SI.
    """

    verdict: str
    limits: str
    software: str
    result: Mapping[str, Any]


@dataclass(frozen=True)
class StoredRecord:
    """A record as it lies in the store, with its newest grading.

    Attributes
    ----------
    number : int
        Its number.
    name, plate, vehicle, date, axle, tester : str
        As it came in.
    accepted : str
        When it came in, ISO 8601, UTC.
    grading : Grading or None
        The newest one.
    """

    number: int
    name: str
    plate: str
    vehicle: str
    date: str
    axle: str
    tester: str
    accepted: str
    grading: Grading | None


class Store:
    """An open record store.

    Parameters
    ----------
    location : str or Path
        A file, made where there is none, or a database URL of SQLAlchemy (``postgresql+psycopg://...``).
    read_only : bool
        Refuse to write.

    Raises
    ------
    RecordingError
        For a file that is damaged or no store of this kind: it is left as it is.

    Examples
    --------
    >>> import tempfile
    >>> store = Store(tempfile.mkdtemp() + "/lane.sqlite")
    >>> entry = RecordEntry("a.csv", b"time [s]", plate="B-AB 123", date="2026-11-21")
    >>> number, is_new = store.accept(entry, Grading("passed", "1", "0", {"adhesion": 0.6}))
    >>> is_new, store.accept(entry, None)[1], store.content(number)[0]
    (True, False, b'time [s]')
    >>> [found.grading.verdict for found in store.records(plate="B-AB 123")]
    ['passed']
    """

    def __init__(self, location: str | Path, *, read_only: bool = False) -> None:
        self.location, self.read_only = str(location), read_only
        self._engine = _engine(self.location, read_only=read_only)
        with _damage(self.location), self._engine.begin() as connection:
            _check(connection, self.location)
            if not read_only:
                create_tables(connection)

    def accept(self, entry: RecordEntry, grading: Grading | None) -> tuple[int, bool]:
        """Put a record in, with its grading, in one transaction.

        Parameters
        ----------
        entry : RecordEntry
            The record.
        grading : Grading or None
            Its grading; None where it waits for one.

        Returns
        -------
        number : int
            Of the record in the store.
        is_new : bool
            False where the same file is in the store already: then nothing changes.
        """
        from sqlalchemy import insert, select

        with self._writing() as connection:
            known = connection.execute(select(RECORDS.c.number).where(RECORDS.c.digest == entry.digest)).scalar()
            if known is not None:
                return int(known), False
            if entry.plate:
                self._note_vehicle(connection, entry)
            values = {
                "digest": entry.digest,
                "name": entry.name,
                "content": zlib.compress(entry.content, 6),
                "sidecar": None if entry.sidecar is None else zlib.compress(entry.sidecar, 6),
                "plate": entry.plate,
                "vehicle": entry.vehicle,
                "date": entry.date,
                "axle": entry.axle,
                "tester": entry.tester,
                "accepted": _now(),
            }
            number = int(connection.execute(insert(RECORDS).values(**values).returning(RECORDS.c.number)).scalar_one())
            if grading is not None:
                connection.execute(insert(RESULTS).values(**_row_of(number, grading)))
            return number, True

    def add_gradings(self, gradings: Sequence[tuple[int, Grading]]) -> None:
        """Add gradings to records by their numbers, all of them or none."""
        from sqlalchemy import insert

        if not gradings:
            return
        with self._writing() as connection:
            connection.execute(insert(RESULTS), [_row_of(number, grading) for number, grading in gradings])

    def content(self, number: int) -> tuple[bytes, bytes | None]:
        """Give file and sidecar of a record as they came in.

        Raises
        ------
        RecordingError
            When there is no such record, or its bytes are not those that came in.
        """
        from sqlalchemy import select

        wanted = select(RECORDS.c.content, RECORDS.c.sidecar, RECORDS.c.digest).where(RECORDS.c.number == number)
        with _damage(self.location), self._engine.connect() as connection:
            row = connection.execute(wanted).one_or_none()
        if row is None:
            raise RecordingError("no such record", where=self.location, found=number)
        try:
            content, sidecar = zlib.decompress(row.content), row.sidecar and zlib.decompress(row.sidecar)
        except zlib.error:
            content, sidecar = b"", None
        if RecordEntry("", content, sidecar).digest != row.digest:
            raise RecordingError(f"record {number} is damaged", where=self.location, hint="Use a copy of the store.")
        return content, sidecar

    def numbers(self) -> list[int]:
        """Numbers of all records, ascending."""
        from sqlalchemy import select

        with _damage(self.location), self._engine.connect() as connection:
            return list(connection.execute(select(RECORDS.c.number).order_by(RECORDS.c.number)).scalars())

    def records(
        self,
        *,
        plate: str | None = None,
        verdict: str | None = None,
        tester: str | None = None,
        since: str | None = None,
        until: str | None = None,
    ) -> list[StoredRecord]:
        """Find records, by date; every condition that is given must hold.

        Parameters
        ----------
        plate, verdict, tester : str, optional
            Equal to these.
        since, until : str, optional
            Days, ISO 8601, both included.
        """
        from sqlalchemy import and_, func, select

        newest = select(func.max(RESULTS.c.number)).group_by(RESULTS.c.record).scalar_subquery()
        joined = RECORDS.outerjoin(RESULTS, and_(RESULTS.c.record == RECORDS.c.number, RESULTS.c.number.in_(newest)))
        asked = select(*(c for c in RECORDS.c if c.name not in ("content", "sidecar", "digest")), *_RESULT_COLUMNS)
        for column, value in ((RECORDS.c.plate, plate), (RESULTS.c.verdict, verdict), (RECORDS.c.tester, tester)):
            asked = asked if value is None else asked.where(column == value)
        asked = asked if since is None else asked.where(RECORDS.c.date >= since)
        asked = asked if until is None else asked.where(RECORDS.c.date <= until)
        with _damage(self.location), self._engine.connect() as connection:
            rows = connection.execute(asked.select_from(joined).order_by(RECORDS.c.date, RECORDS.c.number))
            return [_stored(row) for row in rows]

    def gradings(self, number: int) -> list[Grading]:
        """All gradings of a record, the oldest first."""
        from sqlalchemy import select

        asked = select(*_RESULT_COLUMNS).where(RESULTS.c.record == number).order_by(RESULTS.c.number)
        with _damage(self.location), self._engine.connect() as connection:
            return [grading for row in connection.execute(asked) if (grading := _grading(row)) is not None]

    def close(self) -> None:
        """Let go of the database."""
        self._engine.dispose()

    @contextmanager
    def _writing(self) -> Iterator[Connection]:
        if self.read_only:
            raise OutputError("the store is open for reading only", where=self.location)
        with _damage(self.location), self._engine.begin() as connection:
            yield connection

    @staticmethod
    def _note_vehicle(connection: Connection, entry: RecordEntry) -> None:
        from sqlalchemy import insert, select

        if connection.execute(select(VEHICLES.c.plate).where(VEHICLES.c.plate == entry.plate)).scalar() is None:
            connection.execute(insert(VEHICLES).values(plate=entry.plate, name=entry.vehicle, since=_now()))


_RESULT_COLUMNS = (RESULTS.c.verdict, RESULTS.c.limits, RESULTS.c.software, RESULTS.c.result)


def _engine(location: str, *, read_only: bool) -> Engine:
    """Engine of the database; a SQLite file is written through to the disk before a transaction counts."""
    from sqlalchemy import create_engine, event

    if "://" in location:
        return create_engine(location)
    file = Path(location)
    if not file.parent.is_dir():
        raise OutputError("the folder of the store does not exist", where=str(file.parent), hint="Create it first.")
    if read_only and not file.is_file():
        raise RecordingError("no such store", where=location, hint="Check the path and the name.")
    mode = "ro" if read_only else "rwc"
    engine = create_engine(f"sqlite:///file:{file.resolve()}?mode={mode}&uri=true", connect_args={"timeout": _WAIT})

    @event.listens_for(engine, "connect")
    def prepare(connection: Any, _: Any) -> None:
        connection.isolation_level = None  # transactions are begun below, for writing at once
        if not read_only:
            connection.execute("PRAGMA journal_mode=WAL")
        connection.execute("PRAGMA synchronous=FULL")
        connection.execute("PRAGMA foreign_keys=ON")

    @event.listens_for(engine, "begin")
    def begin(connection: Connection) -> None:
        connection.exec_driver_sql("BEGIN" if read_only else "BEGIN IMMEDIATE")

    return engine


def _check(connection: Connection, location: str) -> None:
    """Refuse a file that is damaged or holds something else."""
    from sqlalchemy import inspect, text

    if connection.dialect.name == "sqlite":
        found = connection.execute(text("PRAGMA quick_check(1)")).scalar()
        if found != _WHOLE:
            raise RecordingError(f"the store is damaged: {found}", where=location, hint="Use a copy of the store.")
    names = set(inspect(connection).get_table_names())
    if names and not {"records", "results", "vehicles", "about"} <= names:
        raise RecordingError(
            "a database of another kind", where=location, found=", ".join(sorted(names)), allowed="a record store"
        )
    if names:
        version = connection.execute(text("SELECT value FROM about WHERE name = 'schema'")).scalar()
        if version != SCHEMA_VERSION:
            raise RecordingError(
                "a record store of another version", where=location, found=str(version), allowed=SCHEMA_VERSION
            )


@contextmanager
def _damage(location: str) -> Iterator[None]:
    """Turn what the database complains of into one message."""
    from sqlalchemy.exc import DBAPIError

    try:
        yield
    except JounceError:
        raise
    except DBAPIError as error:
        reason = str(error.orig)
        hint = "Use a copy of the store." if "malformed" in reason or "not a database" in reason else ""
        raise RecordingError(f"the store cannot be used: {reason}", where=location, hint=hint) from None


def _row_of(record: int, grading: Grading) -> dict[str, Any]:
    return {
        "record": record,
        "graded": _now(),
        "verdict": grading.verdict,
        "limits": grading.limits,
        "software": grading.software,
        "result": to_json(grading.result, indent=None),
    }


def _grading(row: Any) -> Grading | None:
    return None if row.result is None else Grading(row.verdict, row.limits, row.software, json.loads(row.result))


def _stored(row: Any) -> StoredRecord:
    places = (row.name, row.plate, row.vehicle, row.date, row.axle, row.tester, row.accepted)
    return StoredRecord(row.number, *places, _grading(row))


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="milliseconds")
