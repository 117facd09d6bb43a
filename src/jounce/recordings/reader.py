"""What a reader of files is: what it is told about a file, and what it gives of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from jounce.core.columns import ColumnTable
from jounce.core.findings import Finding


@dataclass(frozen=True)
class ReaderOptions:
    """What the user tells about a file that it does not contain.

    Attributes
    ----------
    variable : str
        Matrix variable (``.mat``) or group (``.tdms``, ``.nc``) to read; empty: the only one or all.
    header : str
        Names and units of the columns in their order: ``"displacement [mm], force [N]"``; empty: those of the file.
    database : Path or None
        Database of bus messages (``.dbc``, ``.arxml``) with which recorded bus frames (``.mf4``) are decoded.
    """

    variable: str = ""
    header: str = ""
    database: Path | None = None


@dataclass(frozen=True)
class SignalTable:
    """Columns of a file, numbers and units as written, and what else it contains.

    ``others`` are tables of signals that are sampled at other instants than the columns, each with its own ``time``;
    ``left_out`` names what is no signal over time; ``findings`` are doubts about the file.
    """

    columns: ColumnTable
    long_names: Mapping[str, str] = field(default_factory=dict)
    attributes: Mapping[str, object] = field(default_factory=dict)
    left_out: tuple[str, ...] = ()
    others: tuple[ColumnTable, ...] = ()
    findings: tuple[Finding, ...] = ()

    @property
    def tables(self) -> tuple[ColumnTable, ...]:
        """The columns, and those at other instants."""
        return self.columns, *self.others


Read = Callable[[Path, ReaderOptions], SignalTable]


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
    has_variables : bool
        Whether the file holds several matrices or groups, of which the user may choose one.
    has_database : bool
        Whether its bus frames are decoded with a database.
    is_isolated : bool
        Whether it is read in a child process with limits of memory and time: formats of jounce that are not text.
    """

    name: str
    label: str
    suffixes: tuple[str, ...]
    read: Read
    source: str
    example: str
    extra: str = ""
    has_variables: bool = False
    has_database: bool = False
    is_isolated: bool = False
