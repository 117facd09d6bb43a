"""Interface of file readers: the options that they receive, and the table that they return."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from jounce.core.columns import ColumnTable
from jounce.core.findings import Finding


@dataclass(frozen=True)
class ReaderOptions:
    """Information about a file that it does not contain itself.

    Attributes
    ----------
    variable : str
        Matrix variable (``.mat``) or group (``.tdms``, ``.nc``) to read; empty: the only one or all.
    header : str
        Names and units of the columns in their order: ``"displacement [mm], force [N]"``; empty: those of the file.
    database : Path or None
        Database of bus messages (``.dbc``, ``.arxml``) used to decode recorded bus frames (``.mf4``).
    """

    variable: str = ""
    header: str = ""
    database: Path | None = None


@dataclass(frozen=True)
class SignalTable:
    """Columns of a file with numbers and units as written, and its other contents.

    ``others`` are tables of signals on different clocks, each with its own ``time``; ``left_out`` names data that are
    not signals over time; ``findings`` are warnings about the file.
    """

    columns: ColumnTable
    long_names: Mapping[str, str] = field(default_factory=dict)
    attributes: Mapping[str, object] = field(default_factory=dict)
    left_out: tuple[str, ...] = ()
    others: tuple[ColumnTable, ...] = ()
    findings: tuple[Finding, ...] = ()

    @property
    def tables(self) -> tuple[ColumnTable, ...]:
        """The columns, followed by the tables on different clocks."""
        return self.columns, *self.others


Read = Callable[[Path, ReaderOptions], SignalTable]


@dataclass(frozen=True)
class Reader:
    """A readable file format.

    Attributes
    ----------
    name : str
        Short name.
    label : str
        Description, for lists.
    suffixes : tuple of str
        File suffixes in lower case, with the dot.
    read : callable
        Returns the file's columns.
    source : str
        Definition of the format.
    example : str
        A file of this format, or how one is written.
    extra : str
        Required extra of jounce; empty for none.
    has_variables : bool
        Whether the file holds several matrices or groups, of which the user may choose one.
    has_database : bool
        Whether its bus frames are decoded with a database.
    is_isolated : bool
        Whether it is read in a child process with limited memory and time: binary formats read by jounce itself.
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
