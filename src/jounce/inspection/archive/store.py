"""Record store of a lane: raw records and their gradings in one SQL database, by default SQLite.

Every record is stored together with its grading in one transaction, so a crash never leaves a partial record. Several
processes may write concurrently. Records keep their original bytes; gradings are added, never replaced.
"""

from __future__ import annotations

import hashlib
import json
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, TypeVar
from weakref import finalize

from jounce.core.errors import OutputError, RecordingError
from jounce.core.optional import require
from jounce.core.phrases import Phrase
from jounce.core.serialise import to_json
from jounce.inspection.archive.database import (
    CONTENTS,
    DESCRIPTIONS,
    READS,
    RECORDS,
    RESULTS,
    VEHICLES,
    WATCHED,
    DamagedStoreError,
    hide_password,
    open_database,
    problems_of,
    reported_errors,
)
from jounce.inspection.archive.entries import (
    Grading,
    RecordEntry,
    StoredRecord,
    digest_of,
    plate_key,
    storable,
)

require("sqlalchemy", "store")

from sqlalchemy import Column, Select, and_, delete, func, insert, select  # noqa: E402
from sqlalchemy.engine import Connection  # noqa: E402
from sqlalchemy.exc import IntegrityError  # noqa: E402

T = TypeVar("T")
_RESULT_COLUMNS = (
    RESULTS.c.record,
    RESULTS.c.verdict,
    RESULTS.c.limits,
    RESULTS.c.software,
    RESULTS.c.result,
    RESULTS.c.seal.label("result_seal"),
)
_OF_ENTRY = ("name", "plate", "vehicle", "date", "axle", "tester")
_SHOWN = (*_OF_ENTRY, "accepted")
_SHOWN_COLUMNS = (RECORDS.c.number, *(RECORDS.c[name] for name in _SHOWN), RECORDS.c.seal)
_ATTEMPTS = 5  # chosen number of retries after conflicts with other processes
_GAP = 100  # consecutive rows that may be missing in a damaged table


class Store:
    """An open record store: a file, created if missing, or a database URL (``postgresql+psycopg://...``).

    A damaged file raises an error unless ``damaged`` is set, which opens it read-only. A database of a different kind
    or version raises an error.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.inspection.archive.entries import Grading, RecordEntry
    >>> store = Store(tempfile.mkdtemp() + "/lane.sqlite")
    >>> entry = RecordEntry("a.csv", b"time [s]", plate="B-AB 123", date="2026-11-21")
    >>> number, is_new = store.accept(entry, Grading("pass", "1", "0", {"adhesion": 0.6}))
    >>> is_new, store.accept(entry, None)[1], store.content(number)[0]
    (True, False, b'time [s]')
    >>> [found.grading.verdict for found in store.records(plate="b ab 123")]
    ['pass']
    """

    def __init__(
        self, location: str | Path, *, read_only: bool = False, damaged: bool = False
    ) -> None:
        self.address, self.read_only = str(location), read_only or damaged
        self.location = hide_password(self.address)  # for messages and results
        self._engine = open_database(self.address, read_only=self.read_only, damaged=damaged)
        finalize(
            self, self._engine.dispose
        )  # from Python 3.13 on, SQLite connections must be closed

    def accept(self, entry: RecordEntry, grading: Grading | None) -> tuple[int, bool]:
        """Store a record with its grading (None if not yet graded) in one transaction.

        Returns its number, and whether it is new. If the same file is already stored, nothing changes.
        """
        return self._again(lambda: self._accept(entry, grading))

    def _again(self, write: Callable[[], T]) -> T:
        """Write, with retries if another process inserted the same record, vehicle, tester or file."""
        for _ in range(_ATTEMPTS):
            try:
                return write()
            except IntegrityError:
                continue
        raise OutputError(
            "the record could not be stored: other processes keep writing the same record",
            where=self.location,
        )

    def _accept(self, entry: RecordEntry, grading: Grading | None) -> tuple[int, bool]:
        packed = {
            "content": zlib.compress(entry.content, 6),
            "sidecar": None if entry.sidecar is None else zlib.compress(entry.sidecar, 6),
            "signals": entry.signals,
        }  # before the transaction, which would block other writers
        with self._writing() as connection:
            known = connection.execute(
                select(RECORDS.c.number).where(RECORDS.c.digest == entry.digest)
            ).scalar()
            if known is not None:
                return int(known), False
            _note_vehicle(connection, entry)
            values = {
                "digest": entry.digest,
                **{name: getattr(entry, name) for name in _OF_ENTRY},
                "plate_key": plate_key(entry.plate),
                "accepted": _now(),
                "tester_digest": _note_description(connection, entry.tester_table),
                "vehicle_digest": _note_description(connection, entry.vehicle_table),
                "methods": ",".join(entry.methods),
            }
            values = _storable(values)
            values["seal"] = _seal(*(values[name] for name in _SHOWN))
            number = int(
                connection.execute(
                    insert(RECORDS).values(**values).returning(RECORDS.c.number)
                ).scalar_one()
            )
            connection.execute(insert(CONTENTS).values(record=number, **packed))
            if grading is not None:
                connection.execute(insert(RESULTS).values(**_row_of(number, grading)))
            return number, True

    def number_of(self, digest: str) -> int | None:
        """Return the number of the record with a digest; None if it is not in the store."""
        with self._reading() as connection:
            number = connection.execute(
                select(RECORDS.c.number).where(RECORDS.c.digest == digest)
            ).scalar()
        return None if number is None else int(number)

    def add_gradings(self, gradings: Sequence[tuple[int, Grading]]) -> None:
        """Add gradings to records by their numbers, all of them or none."""
        if not gradings:
            return
        with self._writing() as connection:
            connection.execute(
                insert(RESULTS), [_row_of(number, grading) for number, grading in gradings]
            )

    def content(self, number: int) -> tuple[bytes, bytes | None]:
        """Return file and sidecar of a record as imported; raise an error if their bytes have changed."""
        wanted = select(CONTENTS.c.content, CONTENTS.c.sidecar, RECORDS.c.digest).join(
            RECORDS, RECORDS.c.number == CONTENTS.c.record
        )
        with self._reading() as connection:
            row = connection.execute(wanted.where(CONTENTS.c.record == number)).one_or_none()
        if row is None:
            raise RecordingError("no such record", where=self.location, found=number)
        try:
            content, sidecar = (
                zlib.decompress(row.content),
                row.sidecar and zlib.decompress(row.sidecar),
            )
        except zlib.error:
            content, sidecar = b"", None
        if digest_of(content, sidecar) != row.digest:
            raise DamagedStoreError(
                Phrase("record {number} is damaged", number=number),
                where=self.location,
                hint="Restore it from a backup copy.",
            )
        return content, sidecar

    def signals(self, number: int) -> bytes | None:
        """Return the packed signals of a record; None if it could not be read when imported."""
        with self._reading() as connection:
            return connection.execute(
                select(CONTENTS.c.signals).where(CONTENTS.c.record == number)
            ).scalar()

    def entry(self, number: int) -> RecordEntry:
        """Return the metadata of a record, without its file."""
        tester, vehicle = DESCRIPTIONS.alias("tester_of"), DESCRIPTIONS.alias("vehicle_of")
        joined = RECORDS.outerjoin(tester, tester.c.digest == RECORDS.c.tester_digest)
        joined = joined.outerjoin(vehicle, vehicle.c.digest == RECORDS.c.vehicle_digest)
        asked = select(
            RECORDS, tester.c.content.label("of_tester"), vehicle.c.content.label("of_vehicle")
        )
        with self._reading() as connection:
            row = connection.execute(
                asked.select_from(joined).where(RECORDS.c.number == number)
            ).one_or_none()
        if row is None:
            raise RecordingError("no such record", where=self.location, found=number)
        places = {name: getattr(row, name) for name in _OF_ENTRY}
        tables = [
            None if text is None else json.loads(text) for text in (row.of_tester, row.of_vehicle)
        ]
        methods = tuple(filter(None, row.methods.split(",")))
        return RecordEntry(
            content=b"", **places, tester_table=tables[0], vehicle_table=tables[1], methods=methods
        )

    def numbers(self) -> list[int]:
        """Return the numbers of all records, ascending."""
        with self._reading() as connection:
            return list(
                connection.execute(select(RECORDS.c.number).order_by(RECORDS.c.number)).scalars()
            )

    def records(
        self,
        *,
        plate: str | None = None,
        verdict: str | None = None,
        tester: str | None = None,
        since: str | None = None,
        until: str | None = None,
    ) -> list[StoredRecord]:
        """Return records by date that meet all given conditions.

        Parameters
        ----------
        plate : str, optional
            Number plate; case, spaces and hyphens are ignored; a trailing ``*`` matches anything.
        verdict, tester : str, optional
            Exact verdict and tester.
        since, until : str, optional
            First and last day, ISO 8601, both included.
        """
        newest = select(func.max(RESULTS.c.number)).group_by(RESULTS.c.record).scalar_subquery()
        joined = RECORDS.outerjoin(
            RESULTS, and_(RESULTS.c.record == RECORDS.c.number, RESULTS.c.number.in_(newest))
        )
        asked = select(*_SHOWN_COLUMNS, *_RESULT_COLUMNS)
        for column, value in ((RESULTS.c.verdict, verdict), (RECORDS.c.tester, tester)):
            asked = asked if value is None else asked.where(column == value)
        if plate is not None:
            key = plate_key(plate)
            column = RECORDS.c.plate_key
            asked = asked.where(column.startswith(key) if plate.endswith("*") else column == key)
        asked = asked if since is None else asked.where(RECORDS.c.date >= since)
        asked = asked if until is None else asked.where(RECORDS.c.date <= until)
        with self._reading() as connection:
            rows = connection.execute(
                asked.select_from(joined).order_by(RECORDS.c.date, RECORDS.c.number)
            )
            return [_record_of_row(row, _grading(row)) for row in rows]

    def readable_records(self) -> tuple[list[StoredRecord], list[str]]:
        """Read a damaged store row by row; return the readable records, and the errors of the others."""
        lost: list[str] = []
        gradings: dict[int, Grading] = {}
        for row in self._rows(select(*_RESULT_COLUMNS), RESULTS.c.number, lost):
            try:
                grading = _grading(row)
            except RecordingError as error:
                lost.append(error.what)
            else:
                gradings |= {} if grading is None else {row.record: grading}
        records = []
        for row in self._rows(select(*_SHOWN_COLUMNS), RECORDS.c.number, lost):
            try:
                records.append(_record_of_row(row, gradings.get(row.number)))
            except RecordingError as error:
                lost.append(error.what)
        return records, lost

    def _rows(self, asked: Select[Any], number: Column[int], lost: list[str]) -> Iterator[Any]:
        """Yield rows by number, one by one, without an index, until a long gap."""
        at = missing = 0
        unread: list[int] = []
        while missing < _GAP:
            at += 1
            row, missing = None, missing + 1
            try:
                with self._reading() as connection:
                    row = connection.execute(asked.where(number == at)).one_or_none()
            except RecordingError:
                unread.append(at)
            if row is not None:
                lost += [
                    f"row {row_number} of the {number.table.name} cannot be read"
                    for row_number in unread
                ]
                missing, unread = 0, []
                yield row
        if unread:
            lost.append(f"the {number.table.name} cannot be read from row {unread[0]} on")

    def _record(self, number: int) -> StoredRecord:
        with self._reading() as connection:
            row = connection.execute(
                select(*_SHOWN_COLUMNS).where(RECORDS.c.number == number)
            ).one()
        return _record_of_row(row, self.newest_grading(number))

    def gradings(self, number: int) -> list[Grading]:
        """Return all gradings of a record, oldest first."""
        asked = (
            select(*_RESULT_COLUMNS).where(RESULTS.c.record == number).order_by(RESULTS.c.number)
        )
        with self._reading() as connection:
            return [
                grading
                for row in connection.execute(asked)
                if (grading := _grading(row)) is not None
            ]

    def newest_grading(self, number: int) -> Grading | None:
        """Return the newest grading of a record."""
        asked = (
            select(*_RESULT_COLUMNS)
            .where(RESULTS.c.record == number)
            .order_by(RESULTS.c.number.desc())
            .limit(1)
        )
        with self._reading() as connection:
            row = connection.execute(asked).one_or_none()
        return None if row is None else _grading(row)

    def note_watched(self, path: str, size: int, modified: int, message: str = "") -> None:
        """Store size (bytes), time (ns) and error message of a file in a watched folder."""
        row = _storable({"path": path, "size": size, "modified": modified, "message": message})

        def write() -> None:
            with self._writing() as connection:
                connection.execute(delete(WATCHED).where(WATCHED.c.path == row["path"]))
                connection.execute(insert(WATCHED).values(**row))

        self._again(write)

    def watched_files(self) -> dict[str, tuple[int, int]]:
        """Return size (bytes) and time (ns) of the examined files by path."""
        with self._reading() as connection:
            rows = connection.execute(select(WATCHED.c.path, WATCHED.c.size, WATCHED.c.modified))
            return {row.path: (row.size, row.modified) for row in rows}

    def problems(self) -> list[str]:
        """Check the whole store, every record byte by byte; return a list of damage, empty for an intact store."""
        with self._reading() as connection:
            problems = problems_of(connection)
        for number in self.numbers():
            try:
                self.content(number)
                self._record(number)
                self.gradings(number)
            except RecordingError as error:
                problems.append(error.what)
        return problems

    def close(self) -> None:
        """Close the connection to the database."""
        self._engine.dispose()

    @contextmanager
    def _writing(self) -> Iterator[Connection]:
        if self.read_only:
            raise OutputError("the store is open for reading only", where=self.location)
        with reported_errors(self.location), self._engine.begin() as connection:
            yield connection

    @contextmanager
    def _reading(self) -> Iterator[Connection]:
        with reported_errors(self.location), self._engine.connect() as connection:
            yield connection.execution_options(**{READS: True})


def _note_vehicle(connection: Connection, entry: RecordEntry) -> None:
    key = plate_key(entry.plate)
    if (
        not key
        or connection.execute(select(VEHICLES.c.plate).where(VEHICLES.c.plate_key == key)).first()
    ):
        return
    row = {"plate_key": key, "plate": entry.plate, "name": entry.vehicle, "since": _now()}
    connection.execute(insert(VEHICLES).values(**_storable(row)))


def _note_description(connection: Connection, table: Mapping[str, Any] | None) -> str | None:
    """Store a description once and return its digest."""
    if table is None:
        return None
    text = storable(json.dumps(json.loads(to_json(table)), sort_keys=True))
    digest = hashlib.sha256(text.encode()).hexdigest()
    if (
        connection.execute(
            select(DESCRIPTIONS.c.digest).where(DESCRIPTIONS.c.digest == digest)
        ).first()
        is None
    ):
        connection.execute(insert(DESCRIPTIONS).values(digest=digest, content=text))
    return digest


def _row_of(record: int, grading: Grading) -> dict[str, Any]:
    said = {name: getattr(grading, name) for name in ("verdict", "limits", "software")}
    row = _storable({"record": record, **said, "result": to_json(grading.result, indent=None)})
    return {**row, "seal": _seal(*row.values()), "graded": _now()}


def _storable(row: Mapping[str, Any]) -> dict[str, Any]:
    return {
        name: storable(value) if isinstance(value, str) else value for name, value in row.items()
    }


def _seal(*parts: object) -> str:
    """Return a checksum of the columns read without the file, to detect flipped bits, e.g. in a verdict."""
    return hashlib.sha256("\0".join(map(str, parts)).encode()).hexdigest()


def _grading(row: Any) -> Grading | None:
    if row.result is None:
        return None
    if _seal(row.record, row.verdict, row.limits, row.software, row.result) != row.result_seal:
        raise DamagedStoreError(
            Phrase("a grading of record {record} is damaged", record=row.record),
            hint="Use a backup copy of the store.",
        )
    return Grading(row.verdict, row.limits, row.software, json.loads(row.result))


def _record_of_row(row: Any, grading: Grading | None) -> StoredRecord:
    known: dict[str, Any] = {name: getattr(row, name) for name in _SHOWN}
    if _seal(*known.values()) != row.seal:
        raise DamagedStoreError(
            Phrase("the metadata of record {number} are damaged", number=row.number),
            hint="Use a backup copy of the store.",
        )
    return StoredRecord(row.number, **known, grading=grading)


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="milliseconds")
