"""What a reader gives and what it may be told."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from jounce.core.columns import ColumnTable, parse_header
from jounce.core.errors import RecordingError


@dataclass(frozen=True)
class ReaderOptions:
    """What the user says about a file that the file does not say itself.

    Attributes
    ----------
    variable : str
        Matrix variable (``.mat``) or group (``.tdms``) to read; empty: the only one or all.
    header : str
        Names and units of the columns in their order: ``"displacement [mm], force [N]"``; empty: those of the file.
    """

    variable: str = ""
    header: str = ""


@dataclass(frozen=True)
class SignalTable:
    """Columns of a file with what else it says about them.

    Attributes
    ----------
    columns : ColumnTable
        Numbers as written, with units as written.
    long_names : mapping of str to str
        Names in words of columns that have one.
    attributes : mapping
        Facts about the whole recording.
    left_out : tuple of str
        Signals of the file that are on other instants than the columns.
    """

    columns: ColumnTable
    long_names: Mapping[str, str] = field(default_factory=dict)
    attributes: Mapping[str, object] = field(default_factory=dict)
    left_out: tuple[str, ...] = ()


def refuse_variable(path: Path, options: ReaderOptions) -> None:
    """Refuse ``variable`` for a format that has no variables to choose from."""
    if options.variable:
        raise RecordingError(
            "a variable cannot be chosen in a file of this format",
            where=str(path),
            found=options.variable,
            hint="Map channels with columns instead.",
        )


def renamed(table: ColumnTable, header: str) -> ColumnTable:
    """Give the columns the names and units of ``header``, in order; an empty header leaves them."""
    if not header:
        return table
    heads = parse_header(header)
    if len(heads) != len(table):
        raise RecordingError(
            f"the given header names {len(heads)} columns, the file has {len(table)}",
            where=table.file,
            found=", ".join(column.label for column in table),
        )
    columns = tuple(
        replace(column, name=name, unit=unit) for column, (name, unit) in zip(table.columns, heads, strict=True)
    )
    return replace(table, columns=columns)


@dataclass(frozen=True)
class Reader:
    """A file format that can be read.

    Attributes
    ----------
    name : str
        Short name.
    label : str
        What it is, for lists.
    suffixes : tuple of str
        File suffixes in lower case, with the dot.
    read : callable
        Gives the file's columns.
    source : str
        Definition of the format.
    example : str
        A file of this format, or how one is written.
    extra : str
        Extra of jounce that is needed; empty for none.
    """

    name: str
    label: str
    suffixes: tuple[str, ...]
    read: Callable[[Path, ReaderOptions], SignalTable]
    source: str
    example: str
    extra: str = ""
