"""Tables of the record store."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sqlalchemy import Column, ForeignKey, Index, Integer, LargeBinary, MetaData, String, Table, Text, insert, select

if TYPE_CHECKING:
    from sqlalchemy.engine import Connection

SCHEMA_VERSION = "jounce.store/1"
_TABLES = MetaData()

VEHICLES = Table(
    "vehicles",
    _TABLES,
    Column("plate", String, primary_key=True),
    Column("name", String, nullable=False),
    Column("since", String, nullable=False),
)
RECORDS = Table(
    "records",
    _TABLES,
    Column("number", Integer, primary_key=True),
    Column("digest", String(64), nullable=False, unique=True),
    Column("name", String, nullable=False),
    Column("content", LargeBinary, nullable=False),
    Column("sidecar", LargeBinary),
    Column("plate", String, nullable=False, index=True),
    Column("vehicle", String, nullable=False),
    Column("date", String, nullable=False, index=True),
    Column("axle", String, nullable=False),
    Column("tester", String, nullable=False),
    Column("accepted", String, nullable=False),
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
    Index("results_of_record", "record", "number"),
)
ABOUT = Table("about", _TABLES, Column("name", String, primary_key=True), Column("value", String, nullable=False))


def create_tables(connection: Connection) -> None:
    """Make the tables that are not there yet, and note their version."""
    _TABLES.create_all(connection)
    if connection.execute(select(ABOUT.c.value).where(ABOUT.c.name == "schema")).scalar() is None:
        connection.execute(insert(ABOUT).values(name="schema", value=SCHEMA_VERSION))
