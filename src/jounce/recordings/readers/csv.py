"""Text files with ``name [unit]`` headers."""

from __future__ import annotations

from pathlib import Path

from jounce.core.columns import read_columns_csv
from jounce.recordings.readers.table import Reader, ReaderOptions, SignalTable, refuse_variable, renamed


def read(path: Path, options: ReaderOptions) -> SignalTable:
    """Read comma, semicolon or tab separated columns."""
    refuse_variable(path, options)
    return SignalTable(renamed(read_columns_csv(path), options.header))


READER = Reader(
    name="csv",
    label="text columns with 'name [unit]' headers",
    suffixes=(".csv", ".txt", ".tsv"),
    read=read,
    source="RFC 4180, with units in the header",
    example="time [s], sprung.az [m/s^2]",
)
