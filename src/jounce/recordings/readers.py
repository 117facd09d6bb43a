"""File formats that can be read: each is one function with its row, which the decorator puts into ``READERS``."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.columns import Column, ColumnTable, parse_header, read_columns_csv
from jounce.core.errors import JounceError, RecordingError, nearest
from jounce.core.files import existing_file
from jounce.core.findings import Finding
from jounce.core.optional import require
from jounce.core.types import Array


@dataclass(frozen=True)
class ReaderOptions:
    """What the user tells about a file that it does not contain.

    Attributes
    ----------
    variable : str
        Matrix variable (``.mat``) or group (``.tdms``) to read; empty: the only one or all.
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


READERS: list[Reader] = []
"""Every format that can be read, in the order of lists."""


def reader(
    name: str, label: str, suffixes: tuple[str, ...], *, source: str, example: str, extra: str = "", **more: bool
) -> Callable[[Read], Read]:
    """Add the decorated function to ``READERS``; the arguments are the fields of its row, a `Reader`."""

    def add(read: Read) -> Read:
        READERS.append(Reader(name, label, suffixes, read, source, example, extra, **more))
        return read

    return add


def reader_of(path: Path) -> Reader:
    """Reader for a file, chosen by its suffix."""
    for known in READERS:
        if path.suffix.lower() in known.suffixes:
            return known
    suffixes = sorted(suffix for known in READERS for suffix in known.suffixes)
    raise RecordingError(
        "the file's suffix is of no known format", where=str(path), found=path.suffix, allowed=", ".join(suffixes)
    )


def read_signals(path: Path, options: ReaderOptions) -> SignalTable:
    """Columns of a file of any known format."""
    chosen = reader_of(path)
    if options.variable and not chosen.has_variables:
        raise RecordingError(
            "a variable cannot be chosen in a file of this format",
            where=str(path),
            found=options.variable,
            hint="Map channels with columns instead.",
        )
    if options.database is not None:
        if not chosen.has_database:
            formats = ", ".join(suffix for known in READERS if known.has_database for suffix in known.suffixes)
            raise RecordingError(
                "a database of bus messages means nothing for this format",
                where=str(path),
                found=str(options.database),
                allowed=formats,
            )
        existing_file(options.database, RecordingError)
    signals = chosen.read(path, options)
    for table in signals.tables:
        _check_shape(table, chosen, path)
    return signals


def _check_shape(table: ColumnTable, reader: Reader, path: Path) -> None:
    """Refuse what a reader gives that is no table: every column needs as many plain numbers as the others."""
    lengths = {column.values.shape for column in table if column.fault is None}
    wrong = next((column for column in table if column.fault is None and not _is_signal(column.values)), None)
    if wrong is not None or len(lengths) > 1:
        what = "a column is no row of real numbers" if wrong is not None else "the columns have different lengths"
        raise RecordingError(
            f"{what}: the reader {reader.name!r} does not know this file",
            where=f"{path}: {wrong.label}" if wrong is not None else str(path),
            found=f"shape {np.shape(wrong.values)}, {getattr(wrong.values, 'dtype', type(wrong.values).__name__)}"
            if wrong is not None
            else ", ".join(f"{column.label}: {len(column.values)}" for column in table if column.fault is None),
        )


def _is_signal(values: object) -> bool:
    return isinstance(values, np.ndarray) and values.ndim == 1 and values.dtype == float and values.size > 0


@contextmanager
def _understood(path: Path, what: str) -> Iterator[None]:
    """Whatever a library raises over a file is one refusal: damaged files make them raise errors of any kind."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    except JounceError:
        raise
    except Exception as error:  # noqa: BLE001 - bare Exceptions, KeyErrors and struct errors alike
        text = " ".join(str(error).split())[:200]
        raise RecordingError(f"not {what}, or damaged ({text or type(error).__name__})", where=str(path)) from None


def _named(columns: Iterable[Column], path: Path, options: ReaderOptions) -> ColumnTable:
    """The columns as a table; with a header they get its names and units, in order."""
    return _renamed(ColumnTable(tuple(columns), (), str(path)), options.header)


def _renamed(table: ColumnTable, header: str) -> ColumnTable:
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


@reader(
    "csv",
    "text columns with 'name [unit]' headers",
    (".csv", ".txt", ".tsv"),
    source="RFC 4180, with units in the header",
    example="time [s], sprung.az [m/s^2]",
)
def _read_csv(path: Path, options: ReaderOptions) -> SignalTable:
    """Comma, semicolon or tab separated columns."""
    return SignalTable(_renamed(read_columns_csv(path), options.header))


@reader(
    "netcdf",
    "netCDF-4 recording",
    (".nc", ".nc4"),
    source="netCDF-4, https://docs.unidata.ucar.edu/netcdf-c",
    example="run.nc written by jounce simulate --out run.nc",
)
def _read_netcdf(path: Path, options: ReaderOptions) -> SignalTable:
    """Every variable over ``time`` with its ``units`` and ``long_name``."""
    import xarray as xr

    try:
        with xr.open_dataset(path, engine="h5netcdf", decode_times=False, decode_timedelta=False) as file:
            dataset = file.load()
    except (OSError, ValueError, KeyError) as error:
        raise RecordingError(f"not a netCDF-4 file ({error})", where=str(path)) from None
    if "time" not in dataset.variables or dataset["time"].dims != ("time",):
        raise RecordingError("no time", where=str(path), allowed="a coordinate 'time' on a dimension 'time'")
    columns, long_names, left_out = [], {}, []
    for name, variable in dataset.variables.items():
        if variable.dims == ("time",) and variable.dtype.kind in "fiu":
            values = np.ascontiguousarray(variable.values, dtype=float)
            columns.append(Column(str(name), str(variable.attrs.get("units", "")), values, str(path)))
            long_names[str(name)] = str(variable.attrs.get("long_name", ""))
        else:
            left_out.append(str(name))
    attributes = {str(key): value for key, value in dataset.attrs.items()}
    return SignalTable(_named(columns, path, options), long_names, attributes, tuple(left_out))


_WIDEST = 64
"""Columns of a matrix up to which it is taken for signals without being named."""


@reader(
    "mat",
    "MATLAB file, version 5 or 7.3, numeric vectors and matrices",
    (".mat",),
    source="MAT-File Format, The MathWorks",
    example="columns={'time': 'Tout [s]', 'strut.force': 'x_F(:,3) [N]'}",
    has_variables=True,
)
def _read_mat(path: Path, options: ReaderOptions) -> SignalTable:
    """Every numeric vector as a column, and the columns of every matrix.

    Columns of a matrix ``x_F`` are named as in MATLAB: ``x_F(:,1)``, ``x_F(:,2)``, ... With ``options.header`` those of
    one matrix (``options.variable``, or the only one as wide as the header) get names and units. Variables of one
    length become columns: that of the matrix with a header, otherwise the most frequent one.
    """
    arrays = _matlab_arrays(path)
    heads = parse_header(options.header) if options.header else []
    chosen = _chosen_matrix(arrays, options.variable, len(heads), path)
    lengths = [int(array.shape[0]) for array in arrays.values() if array.shape[0] > 1]
    if chosen:
        rows = arrays[chosen].shape[0]
    elif lengths:
        rows = max(set(lengths), key=lambda length: (lengths.count(length), length))
    else:
        raise RecordingError("no numeric variable with more than one row", where=str(path))
    columns = []
    for name, array in arrays.items():
        width = array.shape[1]
        if array.shape[0] == rows and (width <= _WIDEST or name == chosen):
            own = [(name, "")] if width == 1 else [(f"{name}(:,{index})", "") for index in range(1, width + 1)]
            named = heads if heads and name == chosen else own
            columns += [
                Column(n, u, np.ascontiguousarray(v), str(path)) for (n, u), v in zip(named, array.T, strict=True)
            ]
    left_out = tuple(name for name, array in arrays.items() if not chosen and array.shape[0] not in (1, rows))
    return SignalTable(ColumnTable(tuple(columns), (), str(path)), left_out=left_out)


def _chosen_matrix(arrays: dict[str, Array], variable: str, width: int, path: Path) -> str:
    """Variable that gets the header (``width`` names); empty when there is neither."""
    sizes = ", ".join(f"{name} ({a.shape[0]} x {a.shape[1]})" for name, a in arrays.items() if a.shape[0] > 1)
    if variable and variable not in arrays:
        hint = nearest(variable, arrays)
        raise RecordingError(f"no numeric variable {variable!r}", where=str(path), found=sizes or "none", hint=hint)
    if not width:
        return variable
    fitting = [name for name, array in arrays.items() if array.shape[1] == width and array.shape[0] > 1]
    if variable and variable not in fitting:
        raise RecordingError(
            f"the given header names {width} columns, {variable!r} has {arrays[variable].shape[1]}", where=str(path)
        )
    if not variable and len(fitting) != 1:
        raise RecordingError(
            f"{len(fitting)} variables have as many columns as the given header ({width})",
            where=str(path),
            found=sizes or "none",
            hint="Say which variable.",
        )
    return variable or fitting[0]


def _matlab_arrays(path: Path) -> dict[str, Array]:
    """Real numeric variables as (rows, columns); row vectors stand up."""
    from scipy.io import loadmat
    from scipy.io.matlab import MatReadError

    try:
        content: dict[str, Any] = loadmat(path)
    except NotImplementedError:  # version 7.3 is HDF5; MATLAB stores columns first, so its matrices come transposed
        import h5py

        with h5py.File(path, "r") as file:
            content = {
                name: np.asarray(item[()]).T
                for name, item in file.items()
                if isinstance(item, h5py.Dataset) and item.attrs.get("MATLAB_class") not in (b"char", b"cell")
            }
    except (MatReadError, ValueError, TypeError, OSError, IndexError, KeyError, EOFError) as error:
        raise RecordingError(f"not a MATLAB file ({error})", where=str(path)) from None
    found = {}
    for name, value in content.items():
        if isinstance(value, np.ndarray) and value.dtype.kind in "fiu" and value.ndim == 2 and value.size > 0:
            array = np.asarray(value, dtype=float)
            found[name] = array.T if array.shape[0] == 1 else array
    return found


@reader(
    "tdms",
    "LabVIEW TDMS, one group",
    (".tdms",),
    source="TDMS File Format Internal Structure, National Instruments",
    example="columns={'sprung.az': 'Accelerometer 1 [g]'}",
    extra="io",
    has_variables=True,
)
def _read_tdms(path: Path, options: ReaderOptions) -> SignalTable:
    """Channels of one group (``options.variable``; the only one otherwise) with their ``unit_string``.

    Time is a channel of its own, or comes from the waveform properties ``wf_start_offset`` and ``wf_increment``.
    """
    nptdms = require("nptdms", "io")
    try:
        file = nptdms.TdmsFile.read(path)
    except Exception as error:  # noqa: BLE001 - nptdms raises bare ValueErrors, KeyErrors and struct errors alike
        raise RecordingError(f"not a TDMS file ({error})", where=str(path)) from None
    groups, wanted = {group.name: group for group in file.groups()}, options.variable
    if wanted not in groups and (wanted or len(groups) != 1):
        raise RecordingError(
            f"no group {wanted!r}" if wanted else "not exactly one group",
            where=str(path),
            found=", ".join(sorted(groups)) or "none",
            hint="Say which one with variable.",
        )
    group = groups[wanted] if wanted in groups else next(iter(groups.values()))
    channels = [channel for channel in group.channels() if len(channel) > 1 and channel.dtype.kind in "fiu"]
    if not channels:
        raise RecordingError("no numeric channel", where=f"{path}: group {group.name!r}")
    columns = [
        Column(one.name, str(one.properties.get("unit_string", "")), np.asarray(one[:], dtype=float), str(path))
        for one in channels
    ]
    increments = {float(one.properties["wf_increment"]) for one in channels if "wf_increment" in one.properties}
    if len(increments) > 1:
        raise RecordingError(
            "the channels have different sample times", where=str(path), found=f"{sorted(increments)} s", allowed="one"
        )
    if increments and not any(column.name == "time" for column in columns):
        start = float(channels[0].properties.get("wf_start_offset", 0.0))
        instants = np.asarray(start + np.arange(columns[0].values.size) * increments.pop(), dtype=float)
        columns.insert(0, Column("time", "s", instants, str(path)))
    return SignalTable(_named(columns, path, options))


@reader(
    "mdf",
    "ASAM MDF 3 or 4, channels on one time axis",
    (".mf4", ".mdf", ".dat"),
    source="ASAM MDF 4.2",
    example="columns={'sprung.az': 'AccZ_body [g]'}",
    extra="io",
)
def _read_mdf(path: Path, options: ReaderOptions) -> SignalTable:
    """Numeric channels on the time axis that most channels share; bus frames are not decoded."""
    asammdf = require("asammdf", "io")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with asammdf.MDF(path) as file:
                signals = [
                    signal
                    for signal in file.iter_channels(skip_master=True)
                    if signal.samples.ndim == 1 and signal.samples.dtype.kind in "fiu" and signal.samples.size > 1
                ]
    except Exception as error:  # noqa: BLE001 - asammdf raises bare exceptions of many kinds
        raise RecordingError(f"not an MDF file ({error})", where=str(path)) from None
    if not signals:
        raise RecordingError("no numeric channel over time", where=str(path), hint="Decode bus frames first.")
    axes = [signal.timestamps.tobytes() for signal in signals]
    usual = max(axes, key=axes.count)
    kept = [signal for signal, axis in zip(signals, axes, strict=True) if axis == usual]
    columns = [Column("time", "s", np.asarray(kept[0].timestamps, dtype=float), str(path))]
    columns += [
        Column(signal.name, str(signal.unit or ""), np.asarray(signal.samples, dtype=float), str(path))
        for signal in kept
    ]
    left_out = tuple(signal.name for signal, axis in zip(signals, axes, strict=True) if axis != usual)
    return SignalTable(_named(columns, path, options), left_out=left_out)


_TIME_RESPONSE = 1


@reader(
    "uff",
    "universal file, time responses (data set 58)",
    (".uff", ".unv", ".uf"),
    source="Universal File Format, University of Cincinnati SDRL",
    example="columns={'sprung.az': 'Mic 01 [m/s^2]'}",
    extra="io",
)
def _read_uff(path: Path, options: ReaderOptions) -> SignalTable:
    """Time responses that share the first one's instants.

    A channel is named after its response entity (or ``point_<node>``), followed by ``:<node><direction>`` when several
    have that name.
    """
    pyuff = require("pyuff", "io")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            file = pyuff.UFF(str(path))
            kinds = np.atleast_1d(file.get_set_types())
            sets = [file.read_sets(int(index)) for index in np.flatnonzero(kinds == 58)]
    except Exception as error:  # noqa: BLE001 - pyuff raises bare Exceptions
        raise RecordingError(f"not a universal file ({error})", where=str(path)) from None
    sets = [one for one in sets if one["func_type"] == _TIME_RESPONSE]
    if not sets:
        found = ", ".join(f"{int(kind)}" for kind in kinds)
        raise RecordingError("no time response", where=str(path), found=f"data sets {found}", allowed="data set 58")
    instants = np.asarray(sets[0]["x"], dtype=float)
    columns = [Column("time", "s", instants, str(path))]
    entities = [str(one["rsp_ent_name"]).strip() for one in sets]
    names = [
        entity if entity not in ("", "NONE") else f"point_{one['rsp_node']}"
        for one, entity in zip(sets, entities, strict=True)
    ]
    left_out = []
    for one, name in zip(sets, names, strict=True):
        full = name if names.count(name) == 1 else f"{name}:{one['rsp_node']}{one['rsp_dir']:+d}"
        if np.array_equal(one["x"], instants):
            unit = str(one["ordinate_axis_units_lab"]).strip()
            values = np.asarray(one["data"], dtype=float)
            columns.append(Column(full, "" if unit == "NONE" else unit, values, str(path)))
        else:
            left_out.append(full)
    return SignalTable(_named(columns, path, options), left_out=tuple(left_out))
