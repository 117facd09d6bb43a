"""Database of a record store: created atomically, and checked before anything is written."""

from __future__ import annotations

import contextlib
import os
import re
import sqlite3
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from jounce.core.errors import DescriptionError, JounceError, OutputError, RecordingError
from jounce.core.optional import how_to_install, require
from jounce.core.phrases import Phrase
from jounce.core.writing import sweep_beside, temporary_beside

require("sqlalchemy", "store")

from sqlalchemy import (  # noqa: E402 - said above, where it is missing
    BigInteger,
    Column,
    ForeignKey,
    Index,
    Integer,
    LargeBinary,
    MetaData,
    String,
    Table,
    Text,
    create_engine,
    event,
    func,
    insert,
    inspect,
    select,
    text,
)
from sqlalchemy.engine import Connection, Engine, make_url  # noqa: E402
from sqlalchemy.exc import ArgumentError, DBAPIError, IntegrityError, NoSuchModuleError  # noqa: E402

SCHEMA_VERSION = "jounce.store/1"
_TABLES = MetaData()

VEHICLES = Table(
    "vehicles",
    _TABLES,
    Column("plate_key", String, primary_key=True),
    Column("plate", String, nullable=False),
    Column("name", String, nullable=False),
    Column("since", String, nullable=False),
)
DESCRIPTIONS = Table(  # testers and vehicles, as JSON of their tables
    "descriptions",
    _TABLES,
    Column("digest", String(64), primary_key=True),
    Column("content", Text, nullable=False),
)
RECORDS = Table(
    "records",
    _TABLES,
    Column("number", Integer, primary_key=True),
    Column("digest", String(64), nullable=False, unique=True),
    Column("name", String, nullable=False),
    Column("plate", String, nullable=False),
    Column("plate_key", String, nullable=False, index=True),
    Column("vehicle", String, nullable=False),
    Column("date", String, nullable=False, index=True),
    Column("axle", String, nullable=False),
    Column("tester", String, nullable=False),
    Column("accepted", String, nullable=False),
    Column("tester_digest", ForeignKey("descriptions.digest")),
    Column("vehicle_digest", ForeignKey("descriptions.digest")),
    Column("methods", String, nullable=False),
    Column("seal", String(64), nullable=False),  # checksum of the displayed columns
)
CONTENTS = Table(  # separate from the records, so searching and checking do not read them
    "contents",
    _TABLES,
    Column("record", ForeignKey("records.number"), primary_key=True),
    Column("content", LargeBinary, nullable=False),
    Column("sidecar", LargeBinary),
    Column("signals", LargeBinary),
)
RESULTS = Table(
    "results",
    _TABLES,
    Column("number", Integer, primary_key=True),
    Column("record", ForeignKey("records.number"), nullable=False),
    Column("graded", String, nullable=False),
    Column("verdict", String, nullable=False),
    Column("limits", String, nullable=False),
    Column("software", String, nullable=False),
    Column("result", Text, nullable=False),
    Column("seal", String(64), nullable=False),
    Index("results_of_record", "record", "number"),
)
WATCHED = Table(  # files of watched folders that were examined
    "watched",
    _TABLES,
    Column("path", String, primary_key=True),
    Column("size", BigInteger, nullable=False),
    Column("modified", BigInteger, nullable=False),
    Column("message", Text, nullable=False),
)
ABOUT = Table(
    "about",
    _TABLES,
    Column("name", String, primary_key=True),
    Column("value", String, nullable=False),
)
NAMES = frozenset(_TABLES.tables)
SMALL = tuple(sorted(NAMES - {CONTENTS.name}))
"""Tables that are checked whenever a store is opened."""


def create_tables(connection: Connection) -> None:
    """Create missing tables and store their version."""
    _TABLES.create_all(connection)
    if connection.execute(select(ABOUT.c.value).where(ABOUT.c.name == "schema")).scalar() is None:
        connection.execute(insert(ABOUT).values(name="schema", value=SCHEMA_VERSION))


READS = "jounce_reads"
"""Option of a read-only connection, which never waits for locks."""
_WAIT = 30.0  # s that a writer waits for another writer
_WHOLE = "ok"
_DAMAGES = ("malformed", "not a database", "corrupt", "decode", "invalid page")
_MAGIC = b"SQLite format 3\0"
_PLAIN_SQLITE = "sqlite:///"
_PASSWORD, _PASSWORD_ASKED = re.compile(r"(://[^/:@]*:).*@"), re.compile(r"([?&]\w*passw\w*=)[^&]*")
_PATIENCE = 10  # s to wait for a server
_CLAIMED = 5.0  # s after which a claim on a store's name is considered stale
_MAKING = 0x6A6F756E6365  # ID of the lock for creating tables: "jounce"
_LEFT_ALONE = (
    "The store was left unchanged; use a backup copy. To save the readable records: jounce "
    "inspect export --damaged."
)


class DamagedStoreError(RecordingError):
    """Error for a damaged record store or a different kind of file, which is never written to."""


def hide_password(location: str) -> str:
    """Return a location without its password, for messages and results.

    Examples
    --------
    >>> hide_password("postgresql+psycopg://lane:se/cr@t@host/lane"), hide_password("lane.sqlite")
    ('postgresql+psycopg://lane:***@host/lane', 'lane.sqlite')
    """
    if "://" not in location:
        return location
    return _PASSWORD_ASKED.sub(r"\1***", _PASSWORD.sub(r"\1***@", location))


def file_of(location: str) -> Path | None:
    """Return the file of a location; None if it is not a SQLite file."""
    if location.startswith(_PLAIN_SQLITE):
        return Path(location.removeprefix(_PLAIN_SQLITE))
    return None if "://" in location else Path(location)


def open_database(location: str, *, read_only: bool, damaged: bool = False) -> Engine:
    """Open a database (a file, or a URL of SQLAlchemy); create it if missing.

    A damaged database raises an error before any write, unless it is opened read-only with ``damaged``.
    """
    file = file_of(location)
    if file is None:
        return _open_other(location, read_only=read_only)
    if not file.parent.is_dir():
        raise OutputError(
            "the folder of the store does not exist",
            where=str(file.parent),
            hint="Create the folder first.",
        )
    if not file.exists():
        if read_only:
            raise RecordingError(
                "no such store", where=location, hint="Check the path and the name."
            )
        _make(file)
    if not file.is_file():
        raise RecordingError("not a file", where=location, allowed="a record store")
    if damaged:
        return _sqlite(file, read_only=True, damaged=True)
    _check_file(file)
    looking = _sqlite(file, read_only=True)
    try:
        with reported_errors(location), looking.begin() as connection:
            _check_tables(connection, location)
    except JounceError:
        looking.dispose()
        raise
    if read_only:
        return looking
    looking.dispose()
    sweep_beside(file)
    return _sqlite(file, read_only=False)


def problems_of(connection: Connection) -> list[str]:
    """Check a SQLite file completely, page by page; other databases perform their own checks."""
    if connection.dialect.name != "sqlite":
        return []
    problems = [
        str(row) for row in connection.exec_driver_sql("PRAGMA integrity_check(20)").scalars()
    ]
    problems += [
        f"{row[0]}: a row points to nothing"
        for row in connection.exec_driver_sql("PRAGMA foreign_key_check")
    ]
    return [text for text in problems if text != _WHOLE]


@contextmanager
def reported_errors(location: str) -> Iterator[None]:
    """Convert database errors to a single message."""
    try:
        yield
    except (JounceError, IntegrityError):
        raise
    except (DBAPIError, sqlite3.Error) as error:
        cause = error.orig if isinstance(error, DBAPIError) else error
        reason = (str(cause).strip() or type(cause).__name__).splitlines()[0]
        if any(word in reason for word in _DAMAGES):
            raise DamagedStoreError(
                Phrase("the store is damaged: {reason}", reason=reason),
                where=location,
                hint=_LEFT_ALONE,
            ) from None
        hint = "Check permissions and disk space."
        if "locked" in reason:
            hint = "Another process is writing; try again."
        elif file_of(location) is None:
            hint = "Check the server, its database, the permissions and the password."
        raise OutputError(
            Phrase("the store cannot be used: {reason}", reason=reason), where=location, hint=hint
        ) from None


def _open_other(location: str, *, read_only: bool) -> Engine:
    """Open a database other than a SQLite file, or a SQLite database given with its driver."""
    allowed = "a file, or e.g. postgresql+psycopg://user@host/lane"
    try:
        url = make_url(location)
        if "@" in (url.host or ""):
            raise ArgumentError
        if url.drivername == "postgresql":
            url = url.set(drivername="postgresql+psycopg")
        can_wait = url.drivername == "postgresql+psycopg" and "connect_timeout" not in url.query
        waits = {"connect_timeout": _PATIENCE} if can_wait else {}
        engine = create_engine(url, pool_pre_ping=True, connect_args=waits)
    except NoSuchModuleError:
        what = "unknown kind of database"
        raise DescriptionError(
            what, where="store", found=hide_password(location), allowed=allowed
        ) from None
    except (ArgumentError, ValueError):  # their messages contain parts of the password
        hint = "In a password, write / : @ as %2F %3A %40."
        what = "the database address cannot be read"
        raise DescriptionError(
            what, where="store", found=hide_password(location), allowed=allowed, hint=hint
        ) from None
    except ModuleNotFoundError as error:
        command = (
            how_to_install("postgresql") if error.name == "psycopg" else f"pip install {error.name}"
        )
        what, hint = (
            "the driver of this database is not installed",
            Phrase("Install the driver with: {command}", command=command),
        )
        raise RecordingError(what, where=hide_password(location), hint=hint) from None
    try:
        with reported_errors(hide_password(location)), engine.begin() as connection:
            if not read_only:
                _make_tables(connection, hide_password(location))
            _check_tables(connection, hide_password(location))
    except JounceError:
        engine.dispose()
        raise
    return engine


def _make_tables(connection: Connection, location: str) -> None:
    """Create the tables in a server's database, unless it contains different tables of the same names."""
    if (
        connection.dialect.name == "postgresql"
    ):  # processes that create the same table concurrently conflict
        connection.execute(select(func.pg_advisory_xact_lock(_MAKING)))
    there = set(inspect(connection).get_table_names()) & NAMES
    if there and there != NAMES:
        names = ", ".join(sorted(there))
        raise RecordingError(
            "a different kind of database", where=location, found=names, allowed="a record store"
        )
    create_tables(connection)


def _sqlite(file: Path, *, read_only: bool, damaged: bool = False) -> Engine:
    """Return the engine of a file; commits are flushed to disk."""
    from urllib.parse import quote

    mode = "ro" if read_only else "rw"
    if read_only and not os.access(file.parent, os.W_OK) and not _log_of(file).exists():
        mode += "&immutable=1"  # the lock file cannot be created, so nobody can write
    address = f"sqlite:///file:{quote(str(file.resolve()))}?mode={mode}&uri=true"
    engine = create_engine(address, connect_args={"timeout": _WAIT})

    @event.listens_for(engine, "connect")
    def prepare(connection: Any, _: Any) -> None:
        connection.isolation_level = None  # transactions are started below, immediately for writing
        if damaged:
            connection.execute(
                "PRAGMA writable_schema=ON"
            )  # makes SQLite continue reading despite missing pages
        connection.execute("PRAGMA synchronous=FULL")
        connection.execute("PRAGMA foreign_keys=ON")

    @event.listens_for(engine, "begin")
    def begin(connection: Connection) -> None:
        reads = read_only or connection.get_execution_options().get(READS, False)
        connection.exec_driver_sql("BEGIN" if reads else "BEGIN IMMEDIATE")

    return engine


def _make(file: Path) -> None:
    """Create an empty store under a temporary name and rename it when complete, to make it atomic."""
    temporary = temporary_beside(file)
    engine = _sqlite(temporary, read_only=False)
    try:
        with reported_errors(str(file)):
            with engine.begin() as connection:
                create_tables(connection)
            with (
                engine.connect() as connection
            ):  # last, because creating the log fails silently if the disk is full
                raw = connection.connection.driver_connection
                assert raw is not None
                raw.execute("PRAGMA journal_mode=WAL")
        engine.dispose()
        _give_name(temporary, file)
    finally:
        engine.dispose()
        for left in (
            temporary,
            *(Path(f"{temporary}{end}") for end in ("-journal", "-wal", "-shm")),
        ):
            left.unlink(missing_ok=True)
    _write_through(file.parent)


def _give_name(made: Path, file: Path) -> None:
    """Give a store its final name, unless another process has already created the store."""
    try:
        file.hardlink_to(made)
    except FileExistsError:
        return
    except OSError:  # no hard links (network share, FAT): one process at a time checks and renames
        claim = file.with_name(f".{file.name}.claim")
        end = time.monotonic() + _CLAIMED
        while not file.exists():
            try:
                os.close(os.open(claim, os.O_CREAT | os.O_EXCL | os.O_WRONLY))
            except FileExistsError:
                if time.monotonic() < end:
                    time.sleep(0.01)
                    continue
            try:  # an old claim is from a process that was killed
                if not file.exists():
                    made.replace(file)
            finally:
                claim.unlink(missing_ok=True)


def _write_through(folder: Path) -> None:
    """Flush a folder's directory entries to disk, if the system supports it."""
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def _log_of(file: Path) -> Path:
    return file.with_name(f"{file.name}-wal")


def _check_file(file: Path) -> None:
    """Raise an error for files that are not SQLite, or shorter than stated in their first page."""
    for attempt in range(3):
        has_log = _log_of(file).exists()
        with file.open("rb") as stream:
            head = stream.read(100)
        size = file.stat().st_size
        if size == 0:
            raise DamagedStoreError(
                "the store is damaged: the file is empty", where=str(file), hint=_LEFT_ALONE
            )
        if not head.startswith(_MAGIC):
            raise DamagedStoreError(
                "no record store, or its start is damaged", where=str(file), hint=_LEFT_ALONE
            )
        page = int.from_bytes(head[16:18], "big")
        stated = int.from_bytes(head[28:32], "big") * (65536 if page == 1 else page)
        if has_log or size >= stated:
            return
        time.sleep(0.05 * (attempt + 1))  # another process may be writing its last pages
    what = Phrase("the store is damaged: it has {size} of {stated} bytes", size=size, stated=stated)
    raise DamagedStoreError(what, where=str(file), hint=_LEFT_ALONE)


def _check_tables(connection: Connection, location: str) -> None:
    """Raise an error for a damaged or different kind of database; contents are checked when read."""
    is_file = connection.dialect.name == "sqlite"
    names = set(inspect(connection).get_table_names())
    if not names >= NAMES or (is_file and names - NAMES):
        tables = ", ".join(sorted(names)[:8]) or "no table"
        raise RecordingError(
            "a different kind of database", where=location, found=tables, allowed="a record store"
        )
    for name in SMALL if is_file else ():
        report = str(connection.exec_driver_sql(f"PRAGMA quick_check('{name}')").scalar())
        if report != _WHOLE:
            raise DamagedStoreError(
                Phrase("the store is damaged: {report}", report=report.strip()),
                where=location,
                hint=_LEFT_ALONE,
            )
    version = connection.execute(text("SELECT value FROM about WHERE name = 'schema'")).scalar()
    if version != SCHEMA_VERSION:
        raise RecordingError(
            "a record store of a different version",
            where=location,
            found=str(version),
            allowed=SCHEMA_VERSION,
        )
