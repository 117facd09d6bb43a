"""Tables of the record store."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sqlalchemy import (
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
    insert,
    select,
)

if TYPE_CHECKING:
    from sqlalchemy.engine import Connection

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
    Column("seal", String(64), nullable=False),  # checksum of what is shown of the record
)
CONTENTS = Table(  # apart from the records, so that searching and checking need not read them
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
WATCHED = Table(  # files of watched folders that were looked at
    "watched",
    _TABLES,
    Column("path", String, primary_key=True),
    Column("size", BigInteger, nullable=False),
    Column("modified", BigInteger, nullable=False),
    Column("message", Text, nullable=False),
)
ABOUT = Table("about", _TABLES, Column("name", String, primary_key=True), Column("value", String, nullable=False))
NAMES = frozenset(_TABLES.tables)
SMALL = tuple(sorted(NAMES - {CONTENTS.name}))
"""Tables that are checked whenever a store is opened."""


def create_tables(connection: Connection) -> None:
    """Make the tables that are not there yet, and note their version."""
    _TABLES.create_all(connection)
    if connection.execute(select(ABOUT.c.value).where(ABOUT.c.name == "schema")).scalar() is None:
        connection.execute(insert(ABOUT).values(name="schema", value=SCHEMA_VERSION))
