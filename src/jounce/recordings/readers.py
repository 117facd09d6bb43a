"""Readable file formats: one function each, registered in ``READERS`` by a decorator."""

from __future__ import annotations

import gc
import json
import logging
import os
import re
import struct
import sys
import traceback
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from datetime import datetime, time, timedelta
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from jounce.core.columns import (
    NO_NUMBER,
    Column,
    ColumnTable,
    columns_in,
    name_and_unit,
    names_time,
    parse_header,
    text_of,
)
from jounce.core.errors import JounceError, RecordingError, is_of_system, nearest, resource_error
from jounce.core.files import existing_file, reading
from jounce.core.findings import Finding, finding
from jounce.core.optional import require
from jounce.core.phrases import Phrase
from jounce.core.process_settings import PROCESS_SETTINGS, collect_warnings
from jounce.core.types import Array
from jounce.core.units import is_unit, is_unit_of
from jounce.core.workbooks import sheets_of
from jounce.core.writing import working_folder
from jounce.recordings.aim import preamble
from jounce.recordings.hdf5 import announcement, check_size, surplus
from jounce.recordings.isolated import is_possible, read_isolated, too_much_memory
from jounce.recordings.labview import FIRST, plain_columns
from jounce.recordings.matlab import read_matrices
from jounce.recordings.motec import read_log
from jounce.recordings.netcdf import VariableGroup, open_netcdf
from jounce.recordings.parquet import check_counts, check_end
from jounce.recordings.reader import Read, Reader, ReaderOptions, SignalTable
from jounce.recordings.rpc import SUFFIXES as RPC_SUFFIXES
from jounce.recordings.rpc import read_rpc
from jounce.recordings.schema import channel_unit, quantity_of
from jounce.recordings.vbox import read_vbo
from jounce.recordings.writers import ABOUT, EXCEL, attributes_in

READERS: list[Reader] = []
"""Every readable format, in the order in which lists show them."""


def reader(
    name: str,
    label: str,
    suffixes: tuple[str, ...],
    *,
    source: str,
    example: str,
    extra: str = "",
    **more: bool,
) -> Callable[[Read], Read]:
    """Register the decorated function in ``READERS``; the arguments are the fields of its `Reader`."""

    def add(read: Read) -> Read:
        READERS.append(Reader(name, label, suffixes, read, source, example, extra, **more))
        return read

    return add


def reader_of(path: Path) -> Reader:
    """Reader for a file, chosen by its suffix."""
    likely = [known for known in READERS if path.suffix.lower() in known.suffixes]
    if len(likely) > 1:  # .dat is text, or MDF
        with (
            reading(existing_file(path, RecordingError), RecordingError),
            path.open("rb") as stream,
        ):
            is_mdf = stream.read(len(_MDF[-1])).startswith(_MDF)
        return next(known for known in likely if (known.name == "mdf") is is_mdf)
    if likely:
        return likely[0]
    suffixes = sorted({suffix for known in READERS for suffix in known.suffixes})
    raise RecordingError(
        "the file's suffix does not belong to a known format",
        where=str(path),
        found=path.suffix,
        allowed=", ".join(suffixes),
    )


_MDF = (b"MDF", b"UnFinMF")
"""First bytes of MDF files, finalised and not."""


def is_read_in_child(path: Path) -> bool:
    """Whether a child process reads files of this format, and this process can start one."""
    is_known = any(path.suffix.lower() in known.suffixes for known in READERS)
    return is_possible() and is_known and reader_of(path).is_isolated


def read_signals(path: Path, options: ReaderOptions) -> SignalTable:
    """Read the columns of a file in any known format."""
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
            formats = ", ".join(
                suffix for known in READERS if known.has_database for suffix in known.suffixes
            )
            raise RecordingError(
                "a bus message database cannot be used with this format",
                where=str(path),
                found=str(options.database),
                allowed=formats,
            )
        existing_file(options.database, RecordingError)
    try:
        signals = (read_isolated if is_read_in_child(path) else _read_here)(chosen, path, options)
    except MemoryError as error:
        raise (resource_error if is_of_system(error) else too_much_memory)(
            error, str(path)
        ) from None
    for table in signals.tables:
        _check_shape(table, chosen, path)
    return signals


def _read_here(chosen: Reader, path: Path, options: ReaderOptions) -> SignalTable:
    return chosen.read(path, options)


def _check_shape(table: ColumnTable, reader: Reader, path: Path) -> None:
    """Refuse a reader's result unless all columns are real-valued arrays of the same length."""
    sound = [column for column in table if column.fault is None]
    for column in sound:
        if not _is_signal(column.values):
            raise RecordingError(
                Phrase(
                    "a column does not contain real numbers: the reader {name!r} does not support this file",
                    name=reader.name,
                ),
                where=f"{path}: {column.label}",
                found=f"shape {np.shape(column.values)}, {getattr(column.values, 'dtype', 'no array')}",
            )
    if len({column.values.size for column in sound}) > 1:
        raise RecordingError(
            Phrase(
                "the columns have different lengths: the reader {name!r} does not support this file",
                name=reader.name,
            ),
            where=str(path),
            found=", ".join(f"{column.label}: {column.values.size}" for column in sound),
        )


def _is_signal(values: object) -> bool:
    return (
        isinstance(values, np.ndarray)
        and values.ndim == 1
        and values.dtype == float
        and values.size > 0
    )


@contextmanager
def _quiet() -> Iterator[None]:
    """Silence libraries that log about damaged files: findings report the damage."""
    with PROCESS_SETTINGS:
        before = logging.root.manager.disable
        logging.disable(logging.CRITICAL)
        try:
            yield
        finally:
            logging.disable(before)


@contextmanager
def _refuse_if_damaged(path: Path, what: str) -> Iterator[None]:
    """Convert any error of a library to a RecordingError: damaged files raise errors of any kind."""
    try:
        with collect_warnings():
            yield
    except (JounceError, MemoryError):
        raise
    except Exception as error:  # bare Exceptions, KeyErrors and struct errors alike
        if is_of_system(error):
            raise
        text = " ".join(str(error).split())[:200]
        with PROCESS_SETTINGS:
            hook = sys.unraisablehook
            sys.unraisablehook = lambda _: (
                None
            )  # half-built objects print tracebacks when they are freed
            try:
                traceback.clear_frames(error.__traceback__)
                gc.collect()
            finally:
                sys.unraisablehook = hook
        raise RecordingError(
            f"not {what}, or damaged ({text or type(error).__name__})", where=str(path)
        ) from None


def _table_of(columns: Iterable[Column], path: Path, options: ReaderOptions) -> ColumnTable:
    """Return the columns as a table; the header option, if given, overrides names and units."""
    return _rename(ColumnTable(tuple(columns), (), str(path)), options.header)


def _rename(table: ColumnTable, header: str) -> ColumnTable:
    if not header:
        return table
    heads = parse_header(header)
    if len(heads) != len(table):
        raise RecordingError(
            Phrase(
                "the given header names {count} columns, but the file has {second_count}",
                count=len(heads),
                second_count=len(table),
            ),
            where=table.file,
            found=", ".join(column.label for column in table),
        )
    columns = tuple(
        replace(column, name=name, unit=unit)
        for column, (name, unit) in zip(table.columns, heads, strict=True)
    )
    return replace(table, columns=columns)


@reader(
    "csv",
    "text columns with 'name [unit]' headers",
    (".csv", ".txt", ".tsv", ".dat"),
    source="RFC 4180, with units in the header",
    example="time [s], sprung.az [m/s^2]",
)
def _read_csv(path: Path, options: ReaderOptions) -> SignalTable:
    """Read columns separated by commas, semicolons or tabs; also LabVIEW text files, whatever their suffix.

    The texts and beacon markers above a table of AiM become attributes.
    """
    text = text_of(path)
    if text.startswith(FIRST):
        return _labview(text, path, options)
    columns = columns_in(text, path, len(parse_header(options.header)) if options.header else 0)
    attributes, findings = preamble(text, path)
    return SignalTable(
        _rename(columns, options.header), attributes=attributes, findings=tuple(findings)
    )


@reader(
    "lvm",
    "LabVIEW measurement file (text), one segment",
    (".lvm",),
    source="Specification for the LabVIEW Measurement File, National Instruments",
    example="columns={'sprung.az': 'Acceleration'}, with the units of its header",
)
def _read_lvm(path: Path, options: ReaderOptions) -> SignalTable:
    """Read the segment's channels with their ``Y_Unit_Label``; time as written, or from ``X0`` and ``Delta_X``."""
    text = text_of(path)
    if not text.startswith(FIRST):
        raise RecordingError(
            "not a LabVIEW measurement file",
            where=str(path),
            allowed=Phrase("a file that begins with {first!r}", first=FIRST),
        )
    return _labview(text, path, options)


def _labview(text: str, path: Path, options: ReaderOptions) -> SignalTable:
    plain, announced = plain_columns(text, path)
    table = _rename(columns_in(plain, path), options.header)
    held = len(table.columns[0].values)
    findings = announcement("Samples", announced or 0, held, str(path), refused=False)
    if announced is not None and held > announced:
        findings.append(
            finding(
                "recordings.rows_added", f"{path}: Samples", held, announced=announced, held=held
            )
        )
    return SignalTable(table, findings=tuple(findings))


@reader(
    "netcdf",
    "netCDF recording, version 4 or 3",
    (".nc", ".nc4"),
    source="netCDF, https://docs.unidata.ucar.edu/netcdf-c",
    example="run.nc written by jounce simulate --out run.nc",
    has_variables=True,
    is_isolated=True,
)
def _read_netcdf(path: Path, options: ReaderOptions) -> SignalTable:
    """Read every variable over the dimension of ``time`` (or of most variables) with ``units`` and ``long_name``.

    ``options.variable`` selects a group of a file with several groups; by default the only group with signals is read.
    """
    columns, long_names, remarks = [], dict[str, str](), []
    with _refuse_if_damaged(path, "a netCDF file"), open_netcdf(path) as root:
        groups = dict(root.signals())
        place, group = _select_group(groups, options.variable, path)
        findings = list(root.findings)
        dimensions = [variable.along for variable in group.variables.values() if variable.along]
        time = group.variables["time"].along if "time" in group.variables else ""
        along = time or max(dimensions, key=dimensions.count)
        signals = {
            name: variable for name, variable in group.variables.items() if variable.along == along
        }
        held = {name: variable.held() for name, variable in signals.items()}
        for name, variable in signals.items():
            findings += announcement(name, max(variable.shape), held[name], str(path))
        rows = min(held.values())
        check_size(rows * len(signals), str(path))
        for name, variable in signals.items():
            unit, since = variable.unit
            bare, own = (name, unit) if unit else name_and_unit(name)
            columns.append(Column(bare, own, variable.values(rows), str(path)))
            long_names[bare] = str(variable.attributes.get("long_name", ""))
            if since:
                remarks.append(
                    finding("recordings.clock", str(path), name=name, unit=unit, since=since)
                )
        left_out = [name for name in group.variables if name not in signals]
        left_out += [name for name in groups if name != place]
    table = replace(_table_of(columns, path, options), remarks=tuple(remarks))
    return SignalTable(
        table, long_names, group.attributes, tuple(left_out), findings=tuple(findings)
    )


def _select_group(
    groups: Mapping[str, VariableGroup], variable: str, path: Path
) -> tuple[str, VariableGroup]:
    if variable or (len(groups) > 1 and "" not in groups):
        if variable not in groups:
            raise RecordingError(
                Phrase("no group {variable!r} with signals", variable=variable)
                if variable
                else "several groups contain signals",
                where=str(path),
                found=", ".join(filter(None, groups)) or "none",
                hint=nearest(variable, groups) or "Select a group with variable.",
            )
        return variable, groups[variable]
    if not groups:
        raise RecordingError("no numeric variable over time", where=str(path))
    return next(iter(groups.items()))


_WIDEST = 64
"""Maximum width of a matrix whose columns are read as signals by default; wider matrices are images or maps."""


@reader(
    "mat",
    "MATLAB file, version 4 to 7.3: vectors and matrices, also in structs and cells",
    (".mat",),
    source="MAT-File Format, The MathWorks",
    example="columns={'time': 'Tout [s]', 'strut.force': 'x_F(:,3) [N]', 'sprung.az': 'run.acc [g]'}",
    has_variables=True,
    is_isolated=True,
)
def _read_mat(path: Path, options: ReaderOptions) -> SignalTable:
    """Read every numeric vector, and the columns of every matrix, at any depth of structs and cells.

    Columns are named as in MATLAB: ``x_F(:,1)``, ``run.acc``, ``Y(2).Data``, ``c{3}``; within the struct
    ``options.variable``, or the only variable of the file, the name of the struct is omitted. A struct with values, a
    name and a unit is one signal of that name; a list of names (and units) next to a matrix of that width names its
    columns. With ``options.header`` the columns of one matrix (``options.variable``, or the only one as wide as the
    header) get names and units. Only variables of one length become columns: the length of the matrix with a header,
    otherwise the most frequent length.
    """
    with _refuse_if_damaged(path, "a MATLAB file"):
        matrices, unread, findings, texts = read_matrices(path)
    struct, variable = "", options.variable
    if variable and variable not in matrices:
        within = tuple(variable + mark for mark in ".({")
        inside = {name: matrix for name, matrix in matrices.items() if name.startswith(within)}
        if inside:
            matrices, struct, variable = inside, variable, ""
    elif not variable:
        roots = {re.split(r"[.({]", name)[0] for name in matrices}
        struct = next(iter(roots)) if len(roots) == 1 else ""
    arrays = {name: matrix.values for name, matrix in matrices.items()}
    heads = parse_header(options.header) if options.header else []
    chosen = _select_matrix(arrays, variable, len(heads), path)
    lengths = [int(array.shape[0]) for array in arrays.values() if array.shape[0] > 1]
    if chosen:
        rows = arrays[chosen].shape[0]
    elif lengths:
        rows = max(set(lengths), key=lambda length: (lengths.count(length), length))
    else:
        hint = (
            Phrase(
                "Objects (timeseries, tables) cannot be read: {unread}. Save plain vectors.",
                unread=", ".join(unread),
            )
            if unread
            else ""
        )
        raise RecordingError(
            "no numeric variable with more than one row", where=str(path), hint=hint
        )
    columns = []
    for name, matrix in matrices.items():
        array = matrix.values
        if array.shape[0] == rows and (array.shape[1] <= _WIDEST or name == chosen):
            own = [(n.removeprefix(f"{struct}."), u, at) for n, u, at in matrix.columns]
            heads_of = [(n, u, "") for n, u in heads] if heads and name == chosen else own
            columns += [
                Column(n, u, np.array(v, dtype=float), str(path), written=at if at != n else "")
                for (n, u, at), v in zip(heads_of, array.T, strict=True)
            ]
    left_out = [
        name for name, array in arrays.items() if not chosen and array.shape[0] not in (1, rows)
    ]
    names, stored_names = texts.get("names"), texts.get("long_names")
    long_names = {}
    if isinstance(names, Mapping) and isinstance(stored_names, Mapping):
        long_names = {
            str(name): str(stored_names[key])
            for key, name in names.items()
            if np.size(stored_names.get(key, []))
        }
    return SignalTable(
        ColumnTable(tuple(columns), (), str(path)),
        long_names,
        attributes_in(texts.get("attributes", "")),
        left_out=(*left_out, *unread),
        findings=tuple(findings),
    )


def _select_matrix(arrays: dict[str, Array], variable: str, width: int, path: Path) -> str:
    """Return the variable that the header (``width`` names) belongs to; empty without header and variable."""
    sizes = ", ".join(
        f"{name} ({a.shape[0]} x {a.shape[1]})" for name, a in arrays.items() if a.shape[0] > 1
    )
    if variable and variable not in arrays:
        hint = nearest(variable, arrays)
        raise RecordingError(
            Phrase("no numeric variable {variable!r}", variable=variable),
            where=str(path),
            found=sizes or "none",
            hint=hint,
        )
    if not width:
        return variable
    fitting = [
        name for name, array in arrays.items() if array.shape[1] == width and array.shape[0] > 1
    ]
    if variable and variable not in fitting:
        raise RecordingError(
            Phrase(
                "the given header names {width} columns, but {variable!r} has {shape}",
                width=width,
                variable=variable,
                shape=arrays[variable].shape[1],
            ),
            where=str(path),
        )
    if not variable and len(fitting) != 1:
        raise RecordingError(
            Phrase(
                "{count} variables have as many columns as the given header ({width})",
                count=len(fitting),
                width=width,
            ),
            where=str(path),
            found=sizes or "none",
            hint="Select a group with variable.",
        )
    return variable or fitting[0]


@reader(
    "tdms",
    "LabVIEW TDMS, one group",
    (".tdms",),
    source="TDMS File Format Internal Structure, National Instruments",
    example="columns={'sprung.az': 'Accelerometer 1 [g]'}",
    extra="io",
    has_variables=True,
    is_isolated=True,
)
def _read_tdms(path: Path, options: ReaderOptions) -> SignalTable:
    """Read the channels of one group (``options.variable``; by default the only one) with their ``unit_string``.

    Time is a channel, or follows from the waveform properties ``wf_start_offset`` and ``wf_increment``.
    """
    nptdms = require("nptdms", "io")
    # a stream: with a path the library would also read an index file next to it
    with _refuse_if_damaged(path, "a TDMS file"), _quiet(), path.open("rb") as stream:
        at, lost = _bytes_without_segment(stream)
        file = nptdms.TdmsFile.read(stream)
        status = file.file_status
        expected = dict(status.channel_statuses or {}) if status.incomplete_final_segment else {}
    groups, wanted = {group.name: group for group in file.groups()}, options.variable
    if wanted not in groups and (wanted or len(groups) != 1):
        raise RecordingError(
            Phrase("no group {wanted!r}", wanted=wanted)
            if wanted
            else "the file has no group or several",
            where=str(path),
            found=", ".join(sorted(groups)) or "none",
            hint="Select a group with variable.",
        )
    group = groups[wanted] if wanted in groups else next(iter(groups.values()))
    where = f"{path}: group {group.name!r}"
    findings: list[Finding] = []
    if lost:
        findings.append(finding("recordings.damaged", str(path), lost, lost=lost, start=at))
    for channel in group.channels():
        if (
            channel.path in expected
            and expected[channel.path].read_length < expected[channel.path].expected_length
        ):
            lost = expected[channel.path].expected_length - expected[channel.path].read_length
            findings += announcement(
                channel.name, len(channel) + lost, len(channel), where, refused=False
            )
    clocks: dict[tuple[float, ...], list[Column]] = {}
    with _refuse_if_damaged(path, "a TDMS file"):
        for channel in group.channels():
            if len(channel) > 1 and channel.dtype.kind in "fiu":
                unit = str(channel.properties.get("unit_string", ""))
                column = Column(channel.name, unit, np.array(channel[:], dtype=float), str(path))
                step = channel.properties.get("wf_increment")
                clock: tuple[float, ...] = ()
                if step is not None:
                    clock = (float(step), float(channel.properties.get("wf_start_offset", 0.0)))
                clocks.setdefault(clock if findings else (*clock, len(channel)), []).append(column)
    if not clocks:
        raise RecordingError("no numeric channel", where=where)
    tables = []
    for clock, columns in clocks.items():
        held = min(
            len(column.values) for column in columns
        )  # in a truncated file, the rows that all channels have
        table = [replace(column, values=column.values[:held]) for column in columns]
        if len(clock) > 1 and not any(column.name == "time" for column in table):
            instants = np.asarray(clock[1] + np.arange(held) * clock[0], dtype=np.float64)
            table.insert(0, Column("time", "s", instants, str(path)))
        tables.append(table)
    return _by_clock(tables, path, options, findings=tuple(findings))


def _bytes_without_segment(stream: BinaryIO) -> tuple[int, int]:
    """Return the end of the last TDMS segment and the number of bytes after it, which the library skips silently."""
    size, at = stream.seek(0, os.SEEK_END), 0
    while at + 28 <= size:
        stream.seek(at)
        tag, _, _, length, before_data = struct.unpack("<4sIIQQ", stream.read(28))
        if tag != b"TDSm" or at + 28 + before_data > size:  # its list of channels is incomplete
            break
        if length == 2**64 - 1:  # the writer was interrupted
            at = size
            break
        at = min(at + 28 + length, size)
    stream.seek(0)
    return at, size - at


@reader(
    "mdf",
    "ASAM MDF 3 or 4, also with bus frames",
    (".mf4", ".mdf", ".dat"),
    source="ASAM MDF 4.2",
    example="columns={'sprung.az': 'AccZ_body [g]'}, database='vehicle.dbc'",
    extra="io",
    has_database=True,
    is_isolated=True,
)
def _read_mdf(path: Path, options: ReaderOptions) -> SignalTable:
    """Read numeric channels by time axis; bus frames (CAN, LIN) are decoded with ``options.database``.

    Signals of bus messages are named as in the database.
    """
    asammdf = require("asammdf", "io")
    # asammdf 8.1 and later look up column lists (MDF 4.2) as `self.self`, and fail to read them
    require("asammdf.blocks.v4_blocks", "io").ListData.self = property(lambda data: data)
    findings: list[Finding] = []
    long_names = dict[str, str]()
    with (
        working_folder() as folder,
        _refuse_if_damaged(path, "an MDF file"),
        _quiet(),
        asammdf.MDF(path, temporary_folder=str(folder)) as file,
    ):
        has_frames = any(name.endswith("DataFrame") for name in file.channels_db)
        sources = [file]
        if options.database is not None:
            databases = [(str(options.database), 0)]
            with _refuse_if_damaged(options.database, "a database of bus messages"):
                sources.append(
                    file.extract_bus_logging(database_files={"CAN": databases, "LIN": databases})
                )
        clocks: dict[bytes, list[Column]] = {}
        for source in sources:
            for signal in source.iter_channels(skip_master=True):
                if (
                    signal.name.startswith(_FRAMES)
                    or signal.samples.ndim != 1
                    or signal.samples.size < 2
                ):
                    continue
                if signal.samples.dtype.kind not in "fiu":
                    continue
                announced = int(source.groups[signal.group_index].channel_group.cycles_nr)
                findings += announcement(
                    signal.name, announced, int(signal.samples.size), str(path), refused=False
                )
                instants = np.array(signal.timestamps, dtype=float)
                columns = clocks.setdefault(
                    instants.tobytes(), [Column("time", "s", instants, str(path))]
                )
                values = np.array(signal.samples, dtype=float)
                columns.append(Column(signal.name, str(signal.unit or ""), values, str(path)))
                long_names[signal.name] = str(signal.comment or "")
        attributes = attributes_in(getattr(file.header, "description", ""))
    if not clocks:
        hint = ""
        if has_frames:
            hint = (
                "The database contains none of the bus frames of the file."
                if options.database
                else "The file contains bus frames: give the database (.dbc) that decodes them."
            )
        raise RecordingError("no numeric channel that varies over time", where=str(path), hint=hint)
    signals = _by_clock(list(clocks.values()), path, options, findings=tuple(findings))
    return replace(signals, long_names=long_names, attributes=attributes)


_FRAMES = ("CAN_", "LIN_", "ETH_", "FLX_")
_TIME_RESPONSE, _FUNCTIONS = 1, 58  # function type and data set of the universal file format


@reader(
    "uff",
    "universal file, time responses (data set 58)",
    (".uff", ".unv", ".uf"),
    source="Universal File Format, University of Cincinnati SDRL",
    example="columns={'sprung.az': 'Mic 01 [m/s^2]'}",
    extra="io",
    is_isolated=True,
)
def _read_uff(path: Path, options: ReaderOptions) -> SignalTable:
    """Read time responses with real values, on the time axis that most of them share.

    A channel is named after its response entity (or ``point_<node>``), followed by ``:<node><direction>`` if the name
    is not unique. Time has the unit of the data set, s by default.
    """
    pyuff = require("pyuff", "io")
    with _refuse_if_damaged(path, "a universal file"):
        file = pyuff.UFF(str(path))
        kinds = [int(kind) for kind in np.atleast_1d(file.get_set_types())]
        functions = [
            file.read_sets(index) for index, kind in enumerate(kinds) if kind == _FUNCTIONS
        ]
    findings: list[Finding] = []
    if sum(line.strip() == b"-1" for line in path.read_bytes().splitlines()) % 2:
        findings.append(finding("recordings.no_end", str(path)))
    sets = [data_set for data_set in functions if data_set["func_type"] == _TIME_RESPONSE]
    if not sets:
        there = f"data sets {', '.join(map(str, kinds))}" if kinds else "no whole data set"
        if functions:
            numbers = sorted({int(data_set["func_type"]) for data_set in functions})
            there = f"data set 58 with functions of type {', '.join(map(str, numbers))}"
        raise RecordingError(
            "no time response",
            where=str(path),
            found=there,
            allowed=Phrase(
                "data set 58 with functions of type {time_response} (time response)",
                time_response=_TIME_RESPONSE,
            ),
        )
    entities = [str(data_set["rsp_ent_name"]).strip() for data_set in sets]
    names = [
        entity if entity not in ("", "NONE") else f"point_{data_set['rsp_node']}"
        for data_set, entity in zip(sets, entities, strict=True)
    ]
    clocks: dict[tuple[str, bytes], list[Column]] = {}
    left_out = []
    for data_set, name in zip(sets, names, strict=True):
        full = (
            name
            if names.count(name) == 1
            else f"{name}:{data_set['rsp_node']}{data_set['rsp_dir']:+d}"
        )
        values, instants = np.ravel(data_set["data"]), np.asarray(data_set["x"], dtype=float)
        if np.iscomplexobj(values) or values.size < 2:
            left_out.append(full)
            continue
        announced = int(data_set.get("num_pts", values.size))
        findings += announcement(full, announced, int(values.size), str(path), refused=False)
        held = min(values.size, instants.size)
        clock, unit = (
            _label(data_set["abscissa_axis_units_lab"]) or "s",
            _label(data_set["ordinate_axis_units_lab"]),
        )
        columns = clocks.setdefault(
            (clock, instants[:held].tobytes()), [Column("time", clock, instants[:held], str(path))]
        )
        columns.append(Column(full, unit, np.array(values[:held], dtype=float), str(path)))
    if not clocks:
        raise RecordingError(
            "no time response of real numbers", where=str(path), found=", ".join(left_out)
        )
    return _by_clock(
        list(clocks.values()), path, options, left_out=tuple(left_out), findings=tuple(findings)
    )


def _label(text: object) -> str:
    label = str(text).strip()
    return "" if label.upper() == "NONE" else label


@reader(
    "parquet",
    "Parquet table",
    (".parquet", ".pq"),
    source="Apache Parquet, https://parquet.apache.org/docs/file-format",
    example="columns={'sprung.az': 'acc_body [g]'}",
    extra="io",
    is_isolated=True,
)
def _read_parquet(path: Path, options: ReaderOptions) -> SignalTable:
    """Read every numeric column; units come from the name (``force [N]``) or the field's metadata.

    Timestamps, durations and times of day (but not dates) become seconds since the first; an index written by pandas
    is read as a column.
    """
    arrow, parquet = require("pyarrow", "io"), require("pyarrow.parquet", "io")
    columns, long_names = [], dict[str, str]()
    with (
        _refuse_if_damaged(path, "a Parquet file"),
        parquet.ParquetFile(path, page_checksum_verification=True) as file,
    ):
        check_counts(file.metadata, path)
        findings = check_end(file.metadata, path)
        table = file.read()
        attributes = attributes_in(
            (table.schema.metadata or {}).get(ABOUT.encode(), b"").decode(errors="replace")
        )
        for field_, chunks in zip(table.schema, table.columns, strict=True):
            metadata = {
                key.decode(): value.decode() for key, value in (field_.metadata or {}).items()
            }
            name, unit = name_and_unit(field_.name)
            unit = unit or metadata.get("unit") or metadata.get("units") or ""
            long_names[name] = metadata.get("long_name", "")
            kind, values, fault = field_.type, np.empty(0), None
            if (
                arrow.types.is_temporal(kind)
                and hasattr(kind, "unit")
                and _may_be_clock(name, unit)
            ):
                integers = chunks.cast(arrow.int32() if kind.bit_width == 32 else arrow.int64())
                ticks = integers.to_numpy()  # float, with NaN, where instants are missing
                values, unit = (
                    (ticks - ticks[0]).astype(float)
                    * {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}[kind.unit],
                    "s",
                )
            elif (
                arrow.types.is_integer(kind)
                or arrow.types.is_floating(kind)
                or arrow.types.is_decimal(kind)
            ):
                values = np.array(chunks.cast(arrow.float64()).to_numpy(), dtype=float)
            else:
                fault = RecordingError(
                    "text in a number column",
                    where=f"{path}: column {field_.name!r}",
                    found=str(kind),
                    allowed="numbers",
                    hint=NO_NUMBER,
                )
            columns.append(
                Column(
                    name, unit, values, str(path), fault, "" if field_.name == name else field_.name
                )
            )
    if not columns or not table.num_rows:
        raise RecordingError("no rows", where=str(path))
    return SignalTable(
        _table_of(columns, path, options), long_names, attributes, findings=tuple(findings)
    )


@reader(
    "rpc",
    "RPC III time history, binary or text",
    RPC_SUFFIXES,
    source="RPC III file format, MTS: its keywords in the documentation of rpc3-file 1.0, and loadrpc.m",
    example="run.rsp written by jounce simulate --out run.rsp",
)
def _read_rpc(path: Path, options: ReaderOptions) -> SignalTable:
    """Read all channels, named by their descriptions, in their units; time follows from ``DELTA_T``.

    No child process is needed: no library is involved, and memory is limited by the size of the file.
    """
    with reading(path, RecordingError):
        signals = read_rpc(path)
    return replace(signals, columns=_rename(signals.columns, options.header))


@reader(
    "motec",
    "MoTeC log file, with the lap markers of the .ldx beside it",
    (".ld",),
    source="layout found by the public parser gotzl/ldparser: MoTeC publishes none",
    example="columns={'front_left.strut.deflection': 'Damper Pos FL'}",
    is_isolated=True,
)
def _read_motec(path: Path, options: ReaderOptions) -> SignalTable:
    """Read the channels of each rate with their own time; the texts of the header are attributes."""
    with reading(path, RecordingError):
        log = read_log(path)
    signals = _by_clock(
        list(map(list, log.clocks)), path, options, left_out=log.left_out, findings=log.findings
    )
    return replace(signals, attributes=log.attributes)


@reader(
    "vbo",
    "Racelogic VBOX file (text)",
    (".vbo",),
    source="VBO file format, Racelogic, manuals of VBOX II Lite, VBOX Touch and VBOX Micro",
    example="columns={'body.speed': 'velocity', 'body.ay': 'Latacc'}",
)
def _read_vbo(path: Path, options: ReaderOptions) -> SignalTable:
    """Read the rows of a drive: time in s, positions in degrees to the north and east, laps from the start line."""
    signals = read_vbo(text_of(path), path)
    return replace(signals, columns=_rename(signals.columns, options.header))


_SST_HEAD = struct.Struct("<3sBHHq")  # signature, version, rate in Hz, padding, seconds since 1970
_NO_SENSOR = 0xFFFF


@reader(
    "sst",
    "Sufni suspension telemetry, version 3: fork and shock in counts",
    (".sst",),
    source="class RawTelemetryData of Sufni.Bridge (sghctoma), version 3",
    example="columns={'front.fork.counts': 'fork'}, sensors='bicycle.toml'",
)
def _read_sst(path: Path, options: ReaderOptions) -> SignalTable:
    """Read pairs of 16-bit numbers of the angle sensors; a missing sensor is left out, a missing sample is NaN."""
    with reading(path, RecordingError):
        content = path.read_bytes()
    size = _SST_HEAD.size
    signature, version, rate, _, began = _SST_HEAD.unpack(content[:size].ljust(size, b"\0"))
    if (signature, version) != (b"SST", 3) or not rate or len(content) < size:
        raise RecordingError(
            "not a file of Sufni telemetry of version 3",
            where=str(path),
            found=f"{content[:4]!r}, {rate} Hz",
            allowed="SST, version 3, a rate above 0 Hz",
        )
    counts = np.frombuffer(content, "<u2", offset=size, count=(len(content) - size) // 4 * 2)
    pairs = np.where(counts == _NO_SENSOR, np.nan, counts).reshape(-1, 2).T
    time = np.asarray(np.arange(pairs.shape[1]) / rate, dtype=float)
    columns, left_out = [Column("time", "s", time, str(path))], []
    for name, values in zip(("fork", "shock"), pairs, strict=True):
        if np.isnan(values).all():
            left_out.append(name)
        else:
            columns.append(Column(name, "counts", np.ascontiguousarray(values), str(path)))
    if len(columns) == 1:
        raise RecordingError("no channel with samples", where=str(path), found=f"{time.size} rows")
    return SignalTable(
        _table_of(columns, path, options),
        attributes={"recorded": began},
        left_out=tuple(left_out),
        findings=tuple(surplus(size + 4 * time.size, len(content), str(path))),
    )


_LARGEST_WORKBOOK = 1_000_000_000
"""Bytes, unpacked: a full sheet (a million rows) of ten columns takes about half of it."""


@reader(
    "excel",
    "Excel workbook, one sheet with 'name [unit]' headers",
    (".xlsx", ".xlsm"),
    source="ECMA-376, Office Open XML",
    example="columns={'sprung.az': 'acc_body [g]'}",
    extra="io",
    has_variables=True,
    is_isolated=True,
)
def _read_excel(path: Path, options: ReaderOptions) -> SignalTable:
    """Read the only sheet with numbers, or the sheet ``options.variable``; cells are read like those of a text file.

    A range of rows or cells may follow the sheet's name: ``Run 1!A5:D300``, ``!5:300``. Formulas are read as the values
    that Excel stored. ``write_recording`` stores names, units, long names and attributes in extra sheets.
    """
    require("openpyxl", "io")
    sheet_rows: dict[str, list[list[Any]]] = {}
    with _refuse_if_damaged(path, "an Excel workbook"):
        sheets = sheets_of(path, RecordingError, most_bytes=_LARGEST_WORKBOOK)
        for title, rows in sheets:
            sheet_rows[title] = [row for _, row in rows]
    is_ours = {*EXCEL} <= sheet_rows.keys() and options.variable in ("", EXCEL[0])
    sheet, mark, area = (options.variable, "", "")
    if sheet not in sheet_rows and "!" in sheet:
        sheet, mark, area = sheet.rpartition("!")
    title = EXCEL[0] if is_ours else _select_sheet(sheet_rows, sheet, path)
    if mark:
        sheet_rows[title] = _within(sheet_rows[title], area, path)
    table = _by_cell(
        _of_sheet(sheet_rows[title], options.header, path, title), sheet_rows[title], path, title
    )
    if not is_ours:
        others = tuple(
            name for name, rows in sheet_rows.items() if name != title and _holds_numbers(rows)
        )
        with _refuse_if_damaged(path, "an Excel workbook"):
            table = _without_days(table, path, title)
        return SignalTable(table, left_out=others)
    about = [
        ["" if cell is None else str(cell) for cell in [*row, *[""] * 3][:3]]
        for row in sheet_rows[EXCEL[1]][1:]
    ]
    if not options.header and len(about) == len(table):
        columns = [
            replace(column, name=name, unit=unit)
            for column, (name, unit, _) in zip(table, about, strict=True)
        ]
        table = replace(table, columns=tuple(columns))
    with _refuse_if_damaged(path, "a recording's workbook"):
        attributes = {
            str(key): json.loads("".join(str(piece) for piece in pieces if piece is not None))
            for key, *pieces in sheet_rows[EXCEL[2]][1:]
        }
    return SignalTable(table, {name: long_name for name, _, long_name in about}, attributes)


_AREA = re.compile(r"\$?([A-Z]*)\$?([1-9]\d*):\$?([A-Z]*)\$?([1-9]\d*)")


def _within(rows: list[list[Any]], area: str, path: Path) -> list[list[Any]]:
    """Clear all cells of a sheet outside a range of rows (``5:300``) or cells (``A5:D300``)."""
    match = _AREA.fullmatch(area.upper())
    if match is None or (match[1] == "") != (match[3] == ""):
        allowed = "rows or cells of a sheet, e.g. 'Run 1!5:300' or 'Run 1!A5:D300'"
        raise RecordingError(
            "invalid range", where=f"{path}: variable", found=area, allowed=allowed
        )
    first, last = (_place(match[1]), _place(match[3]) + 1) if match[1] else (0, None)
    top, bottom = int(match[2]), int(match[4])
    return [
        [*[None] * first, *row[first:last]] if top <= number <= bottom else []
        for number, row in enumerate(rows, 1)
    ]


def _place(letters: str) -> int:
    """Convert the letters of a sheet's column to its index, counted from 0.

    >>> [_place(name) for name in ("A", "Z", "AA", "ZZ", "AAA")]
    [0, 25, 26, 701, 702]
    """
    place = 0
    for letter in letters:
        place = 26 * place + ord(letter) - ord("A") + 1
    return place - 1


def _of_sheet(rows: list[list[Any]], header: str, path: Path, sheet: str) -> ColumnTable:
    """Parse the columns of a sheet; errors name rows of the sheet."""
    try:
        table = columns_in(_as_text(rows), path, len(parse_header(header)) if header else 0)
    except RecordingError as error:
        if error.what == "the file is empty":
            raise RecordingError("all rows are empty", where=f"{path}: sheet {sheet!r}") from None
        where = error.where.replace(f"{path}, line ", f"{path}: sheet {sheet!r}, row ")
        raise RecordingError(
            error.what, where=where, found=error.found, allowed=error.allowed, hint=error.hint
        ) from None
    remarks = [
        finding(item.code, item.place, **{**item.numbers, "kind": "row"})
        if "kind" in item.numbers
        else item
        for item in table.remarks
    ]
    return _rename(replace(table, remarks=tuple(remarks), place="row"), header)


def _select_sheet(sheets: Mapping[str, list[list[Any]]], variable: str, path: Path) -> str:
    if variable:
        if variable not in sheets:
            hint = nearest(variable, sheets)
            raise RecordingError(
                Phrase("no sheet {variable!r}", variable=variable),
                where=str(path),
                found=", ".join(sheets),
                hint=hint,
            )
        return variable
    likely = [name for name, rows in sheets.items() if _holds_numbers(rows)]
    if not likely:
        raise RecordingError("no sheet with numbers", where=str(path), found=", ".join(sheets))
    if len(likely) > 1:
        hint = "Select a sheet: variable = 'SHEET' (--variable), or 'SHEET!5:300' for some of its rows."
        raise RecordingError(
            "several sheets contain numbers", where=str(path), found=", ".join(likely), hint=hint
        )
    return likely[0]


def _holds_numbers(rows: list[list[Any]]) -> bool:
    return any(map(_has_number, rows))


def _has_number(row: list[Any]) -> bool:
    return any(isinstance(cell, int | float) and not isinstance(cell, bool) for cell in row)


def _as_text(rows: list[list[Any]]) -> str:
    """Join cells by tabs, one line per row, limited to columns used by rows with several cells."""
    filled = [[i for i, cell in enumerate(row) if cell not in (None, "")] for row in rows]
    used = [i for places in filled if len(places) > 1 for i in places]
    first, end = min(used, default=0), max(used, default=-1) + 1
    lines = []
    for row in _with_seconds(rows):
        cells = [_cell_text(cell) for cell in [*row, *[None] * end]]
        lines.append(
            "\t".join(cells[first:end]) if any(cells[first:end]) else " ".join(filter(None, cells))
        )
    return "".join(f"{line}\n" for line in lines)


def _with_seconds(rows: list[list[Any]]) -> list[list[Any]]:
    """Convert durations of time columns to s, whether or not their header names a unit of time.

    Other durations are unchanged: openpyxl also returns a number formatted in hours as a duration.
    """
    converted = [list(row) for row in rows]
    below = {
        i: n
        for n, row in reversed([*enumerate(rows)])
        for i, cell in enumerate(row)
        if isinstance(cell, timedelta)
    }
    for i, n in below.items():
        above = [
            row[i] for row in rows[max(n - 2, 0) : n] if i < len(row) and isinstance(row[i], str)
        ]
        cells = {type(row[i]) for row in rows[n:] if i < len(row) and row[i] not in (None, "")}
        is_bare_unit = bool(above) and is_unit(above[-1]) and not names_time(above[-1])
        name, unit = (
            (above[0], above[-1]) if is_bare_unit else name_and_unit(above[-1] if above else "")
        )
        if cells == {timedelta} and _may_be_clock(name, unit):
            for row in converted[n:]:
                if i < len(row) and isinstance(row[i], timedelta):
                    row[i] = row[i].total_seconds()
            if above:
                converted[n - 1][i] = "s" if is_bare_unit else f"{name} [s]"
    return converted


def _may_be_clock(name: str, unit: str) -> bool:
    """Whether a column of durations or dates can be a clock, judged by name and unit; a known channel cannot."""
    is_channel = quantity_of(name) and channel_unit(name) != "s"
    return names_time(name) or (not is_channel and (not unit or is_unit_of(unit, "s")))


def _by_cell(table: ColumnTable, rows: list[list[Any]], path: Path, sheet: str) -> ColumnTable:
    """Make the faults of columns name the sheet's cell and the kind of its content.

    A known channel is not a clock: dates and durations in it are faults.
    """
    columns = list(table.columns)
    for place, column in enumerate(columns):
        reported = column.fault or RecordingError("", allowed="a number")
        line = reported.line or 0
        if not (
            line
            or (column.fault is None and column.unit == "s" and not _may_be_clock(column.name, "s"))
        ):
            continue
        heads = (column.written or column.label, column.label, column.name)
        below = {
            i
            for row in rows
            for i, cell in enumerate(row)
            if isinstance(cell, str) and _cell_text(cell) in heads
        }
        cells = [
            (n, i, row[i]) for n, row in enumerate(rows, 1) for i in sorted(below) if i < len(row)
        ]
        if line:
            here = [
                item
                for item in cells
                if item[0] == line and _cell_text(item[2])[:80] == reported.found
            ]
        else:
            here = [item for item in cells if isinstance(item[2], datetime | time | timedelta)]
        if not here:
            if line:
                where = reported.where.replace(f", line {line}", f": sheet {sheet!r}, row {line}")
                new_fault = RecordingError(
                    reported.what,
                    where=where,
                    found=reported.found,
                    allowed=reported.allowed,
                    hint=reported.hint,
                )
                columns[place] = replace(column, fault=new_fault)
            continue
        line, i, cell = here[0]
        kind = next((word for kinds, word in _KINDS_OF_CELL if isinstance(cell, kinds)), "")
        kind = "an error" if not kind and str(cell) in _ERRORS_OF_EXCEL else kind
        new_fault = RecordingError(
            Phrase("{kind} in a column of numbers", kind=kind) if kind else reported.what,
            where=f"{path}: sheet {sheet!r}, cell {_letters(i)}{line} (column {heads[0]!r})",
            found=str(cell).upper() if isinstance(cell, bool) else _cell_text(cell)[:80],
            allowed=reported.allowed,
            hint="Correct the cell, or format it as a number; rename the column if it is not a channel."
            if kind
            else reported.hint,
        )
        columns[place] = replace(column, fault=new_fault)
    return replace(table, columns=tuple(columns))


_KINDS_OF_CELL = (
    (bool, "a truth value"), (datetime, "a date"), (time, "a time of day"), (timedelta, "a duration")
)  # fmt: skip
_ERRORS_OF_EXCEL = (
    "#DIV/0!",
    "#NAME?",
    "#NULL!",
    "#NUM!",
    "#REF!",
    "#VALUE!",
    "#GETTING_DATA",
    "#SPILL!",
    "#CALC!",
)


def _letters(column: int) -> str:
    """Convert the index of a sheet's column, counted from 0, to its letters.

    >>> [_letters(column) for column in (0, 25, 26, 701, 702)]
    ['A', 'Z', 'AA', 'ZZ', 'AAA']
    """
    return (_letters(column // 26 - 1) if column > 25 else "") + chr(ord("A") + column % 26)


def _without_days(table: ColumnTable, path: Path, sheet: str) -> ColumnTable:
    """Convert durations written by pandas to s: they are stored in days, with the number format of integers."""
    columns, remarks = list(table.columns), list(table.remarks)
    for place, column in enumerate(columns):
        seconds = (column.values * 86400.0).round(9)
        if (
            column.fault is None
            and column.unit in ("", "s")
            and names_time(column.name)
            and not np.array_equal(column.values, column.values.round())
            and np.allclose(seconds / 86400.0, column.values, rtol=1e-15, atol=0.0)
            and _format_below(path, sheet, column.written or column.label) == "0"
        ):
            columns[place] = replace(
                column, unit="s", values=seconds, written=column.written or column.label
            )
            remarks.append(finding("recordings.durations", str(path), name=column.label))
    return replace(table, columns=tuple(columns), remarks=tuple(remarks))


def _format_below(path: Path, sheet: str, header: str) -> str:
    """Return the number format of the first number below a header in a workbook."""
    book = require("openpyxl", "io").load_workbook(path, read_only=True, data_only=True)
    try:
        place = None
        for row in book[sheet].iter_rows():
            if place is not None and place < len(row) and isinstance(row[place].value, int | float):
                return str(row[place].number_format)
            place = next((i for i, cell in enumerate(row) if cell.value == header), place)
    finally:
        book.close()
    return ""


def _cell_text(cell: Any) -> str:
    """Format a cell as in a text file; dates and times as ISO 8601."""
    if cell is None:
        return ""
    if isinstance(cell, datetime | time):
        return cell.isoformat()
    return repr(cell) if isinstance(cell, float) else " ".join(str(cell).replace('"', "'").split())


def _by_clock(
    clocks: list[list[Column]],
    path: Path,
    options: ReaderOptions,
    *,
    left_out: tuple[str, ...] = (),
    findings: tuple[Finding, ...] = (),
) -> SignalTable:
    """Separate columns on the most common clock from those on other clocks; columns without a clock are dropped."""
    usual = max(clocks, key=len)
    others = [columns for columns in clocks if columns is not usual]
    timed = [columns for columns in others if columns[0].name == "time"]
    unclear = tuple(
        column.name for columns in others if columns[0].name != "time" for column in columns
    )
    return SignalTable(
        _table_of(usual, path, options),
        left_out=left_out + unclear,
        others=tuple(ColumnTable(tuple(columns), (), str(path)) for columns in timed),
        findings=findings,
    )
