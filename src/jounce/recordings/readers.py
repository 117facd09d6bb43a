"""File formats that can be read: each is one function with its row, which the decorator puts into ``READERS``."""

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
from jounce.core.findings import Finding
from jounce.core.optional import require
from jounce.core.process_settings import PROCESS_SETTINGS, caught_warnings
from jounce.core.types import Array
from jounce.core.units import is_unit, is_unit_of
from jounce.core.workbooks import sheets_of
from jounce.core.writing import working_folder
from jounce.recordings.hdf5 import announcement, check_size
from jounce.recordings.isolated import is_possible, read_isolated, too_much_memory
from jounce.recordings.labview import FIRST, plain_columns
from jounce.recordings.matlab import read_matrices
from jounce.recordings.netcdf import Group, opened
from jounce.recordings.parquet import check_counts, check_end
from jounce.recordings.reader import Read, Reader, ReaderOptions, SignalTable
from jounce.recordings.schema import channel_unit, quantity_of
from jounce.recordings.writers import ABOUT, EXCEL, attributes_in

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
    likely = [known for known in READERS if path.suffix.lower() in known.suffixes]
    if len(likely) > 1:  # .dat is text, or MDF
        with reading(existing_file(path, RecordingError), RecordingError), path.open("rb") as stream:
            is_mdf = stream.read(len(_MDF[-1])).startswith(_MDF)
        return next(known for known in likely if (known.name == "mdf") is is_mdf)
    if likely:
        return likely[0]
    suffixes = sorted({suffix for known in READERS for suffix in known.suffixes})
    raise RecordingError(
        "the file's suffix is of no known format", where=str(path), found=path.suffix, allowed=", ".join(suffixes)
    )


_MDF = (b"MDF", b"UnFinMF")
"""What MDF files begin with, whole and unfinished ones."""


def is_read_in_child(path: Path) -> bool:
    """Whether a file is of a format that a child process reads, where this process can have one."""
    is_known = any(path.suffix.lower() in known.suffixes for known in READERS)
    return is_possible() and is_known and reader_of(path).is_isolated


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
    try:
        signals = (read_isolated if is_read_in_child(path) else _read_here)(chosen, path, options)
    except MemoryError as error:
        raise (resource_error if is_of_system(error) else too_much_memory)(error, str(path)) from None
    for table in signals.tables:
        _check_shape(table, chosen, path)
    return signals


def _read_here(chosen: Reader, path: Path, options: ReaderOptions) -> SignalTable:
    return chosen.read(path, options)


def _check_shape(table: ColumnTable, reader: Reader, path: Path) -> None:
    """Refuse what a reader gives that is no table: every column needs as many plain numbers as the others."""
    whole = [column for column in table if column.fault is None]
    for column in whole:
        if not _is_signal(column.values):
            raise RecordingError(
                f"a column is no row of real numbers: the reader {reader.name!r} does not know this file",
                where=f"{path}: {column.label}",
                found=f"shape {np.shape(column.values)}, {getattr(column.values, 'dtype', 'no array')}",
            )
    if len({column.values.size for column in whole}) > 1:
        raise RecordingError(
            f"the columns have different lengths: the reader {reader.name!r} does not know this file",
            where=str(path),
            found=", ".join(f"{column.label}: {column.values.size}" for column in whole),
        )


def _is_signal(values: object) -> bool:
    return isinstance(values, np.ndarray) and values.ndim == 1 and values.dtype == float and values.size > 0


@contextmanager
def _quiet() -> Iterator[None]:
    """What libraries log about damaged files is said by findings."""
    with PROCESS_SETTINGS:
        before = logging.root.manager.disable
        logging.disable(logging.CRITICAL)
        try:
            yield
        finally:
            logging.disable(before)


@contextmanager
def _understood(path: Path, what: str) -> Iterator[None]:
    """Whatever a library raises over a file is one refusal: damaged files make them raise errors of any kind."""
    try:
        with caught_warnings():
            yield
    except (JounceError, MemoryError):
        raise
    except Exception as error:  # bare Exceptions, KeyErrors and struct errors alike
        if is_of_system(error):
            raise
        text = " ".join(str(error).split())[:200]
        with PROCESS_SETTINGS:
            hook = sys.unraisablehook
            sys.unraisablehook = lambda _: None  # half-made objects print tracebacks of their own when they are freed
            try:
                traceback.clear_frames(error.__traceback__)
                gc.collect()
            finally:
                sys.unraisablehook = hook
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
    (".csv", ".txt", ".tsv", ".dat"),
    source="RFC 4180, with units in the header",
    example="time [s], sprung.az [m/s^2]",
)
def _read_csv(path: Path, options: ReaderOptions) -> SignalTable:
    """Comma, semicolon or tab separated columns; also the text of LabVIEW, whatever its suffix."""
    text = text_of(path)
    if text.startswith(FIRST):
        return _labview(text, path, options)
    return SignalTable(
        _renamed(columns_in(text, path, len(parse_header(options.header)) if options.header else 0), options.header)
    )


@reader(
    "lvm",
    "LabVIEW measurement file (text), one segment",
    (".lvm",),
    source="Specification for the LabVIEW Measurement File, National Instruments",
    example="columns={'sprung.az': 'Acceleration'}, with the units of its header",
)
def _read_lvm(path: Path, options: ReaderOptions) -> SignalTable:
    """Channels of the segment with their ``Y_Unit_Label``; time as written, or from ``X0`` and ``Delta_X``."""
    text = text_of(path)
    if not text.startswith(FIRST):
        raise RecordingError("not a LabVIEW measurement file", where=str(path), allowed=f"a file that begins {FIRST!r}")
    return _labview(text, path, options)


def _labview(text: str, path: Path, options: ReaderOptions) -> SignalTable:
    plain, announced = plain_columns(text, path)
    table = _renamed(columns_in(plain, path), options.header)
    held = len(table.columns[0].values)
    findings = announcement("Samples", announced or 0, held, str(path), refused=False)
    if announced is not None and held > announced:
        more = f"the header announces {announced} samples and the file holds {held}: rows were added to it"
        findings.append(Finding(f"{path}: Samples", "warning", more, float(held)))
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
    """Every variable over the dimension of ``time`` (or of most variables) with its ``units`` and ``long_name``.

    Of a file with groups the only one with signals is read, or that of ``options.variable``.
    """
    columns, long_names, remarks = [], dict[str, str](), []
    with _understood(path, "a netCDF file"), opened(path) as root:
        groups = dict(root.signals())
        place, group = _chosen_group(groups, options.variable, path)
        findings = list(root.findings)
        dimensions = [one.along for one in group.variables.values() if one.along]
        time = group.variables["time"].along if "time" in group.variables else ""
        along = time or max(dimensions, key=dimensions.count)
        signals = {name: one for name, one in group.variables.items() if one.along == along}
        held = {name: one.held() for name, one in signals.items()}
        for name, one in signals.items():
            findings += announcement(name, max(one.shape), held[name], str(path))
        rows = min(held.values())
        check_size(rows * len(signals), str(path))
        for name, one in signals.items():
            unit, since = one.unit
            bare, own = (name, unit) if unit else name_and_unit(name)
            columns.append(Column(bare, own, one.values(rows), str(path)))
            long_names[bare] = str(one.attributes.get("long_name", ""))
            if since:
                remarks.append(f"{name!r} is a clock: {unit} since {since}")
        left_out = [name for name in group.variables if name not in signals]
        left_out += [name for name in groups if name != place]
    table = replace(_named(columns, path, options), remarks=tuple(remarks))
    return SignalTable(table, long_names, group.attributes, tuple(left_out), findings=tuple(findings))


def _chosen_group(groups: Mapping[str, Group], variable: str, path: Path) -> tuple[str, Group]:
    if variable or (len(groups) > 1 and "" not in groups):
        if variable not in groups:
            raise RecordingError(
                f"no group {variable!r} with signals" if variable else "several groups hold signals",
                where=str(path),
                found=", ".join(filter(None, groups)) or "none",
                hint=nearest(variable, groups) or "Say which one with variable.",
            )
        return variable, groups[variable]
    if not groups:
        raise RecordingError("no variable with numbers over time", where=str(path))
    return next(iter(groups.items()))


_WIDEST = 64
"""Columns of a matrix up to which it is taken for signals without being named."""


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
    """Every numeric vector as a column, and the columns of every matrix, wherever they lie in structs and cells.

    Columns are named as in MATLAB: ``x_F(:,1)``, ``run.acc``, ``Y(2).Data``, ``c{3}``; within the struct
    ``options.variable``, or the only variable of the file, without its name in front. A struct with its values, a name
    and a unit is one signal of that name; a list of names (and units) beside a matrix of that width names its columns.
    With ``options.header`` the columns of one matrix (``options.variable``, or the only one as wide as the header) get
    names and units. Variables of one length become columns: that of the matrix with a header, otherwise the most
    frequent one.
    """
    with _understood(path, "a MATLAB file"):
        matrices, unread, findings, texts = read_matrices(path)
    struct, variable = "", options.variable
    if variable and variable not in matrices:
        within = tuple(variable + mark for mark in ".({")
        inside = {name: one for name, one in matrices.items() if name.startswith(within)}
        if inside:
            matrices, struct, variable = inside, variable, ""
    elif not variable:
        roots = {re.split(r"[.({]", name)[0] for name in matrices}
        struct = next(iter(roots)) if len(roots) == 1 else ""
    arrays = {name: one.values for name, one in matrices.items()}
    heads = parse_header(options.header) if options.header else []
    chosen = _chosen_matrix(arrays, variable, len(heads), path)
    lengths = [int(array.shape[0]) for array in arrays.values() if array.shape[0] > 1]
    if chosen:
        rows = arrays[chosen].shape[0]
    elif lengths:
        rows = max(set(lengths), key=lambda length: (lengths.count(length), length))
    else:
        hint = (
            f"Objects (timeseries, tables) cannot be read: {', '.join(unread)}. Save plain vectors." if unread else ""
        )
        raise RecordingError("no numeric variable with more than one row", where=str(path), hint=hint)
    columns = []
    for name, one in matrices.items():
        array = one.values
        if array.shape[0] == rows and (array.shape[1] <= _WIDEST or name == chosen):
            own = [(n.removeprefix(f"{struct}."), u, at) for n, u, at in one.columns]
            named = [(n, u, "") for n, u in heads] if heads and name == chosen else own
            columns += [
                Column(n, u, np.array(v, dtype=float), str(path), written=at if at != n else "")
                for (n, u, at), v in zip(named, array.T, strict=True)
            ]
    left_out = [name for name, array in arrays.items() if not chosen and array.shape[0] not in (1, rows)]
    names, told = texts.get("names"), texts.get("long_names")
    long_names = {}
    if isinstance(names, Mapping) and isinstance(told, Mapping):
        long_names = {str(name): str(told[key]) for key, name in names.items() if np.size(told.get(key, []))}
    return SignalTable(
        ColumnTable(tuple(columns), (), str(path)),
        long_names,
        attributes_in(texts.get("attributes", "")),
        left_out=(*left_out, *unread),
        findings=tuple(findings),
    )


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
    """Channels of one group (``options.variable``; the only one otherwise) with their ``unit_string``.

    Time is a channel of its own, or comes from the waveform properties ``wf_start_offset`` and ``wf_increment``.
    """
    nptdms = require("nptdms", "io")
    with _understood(path, "a TDMS file"), _quiet(), path.open("rb") as stream:  # a path would take an index beside it
        at, lost = _bytes_without_segment(stream)
        file = nptdms.TdmsFile.read(stream)
        status = file.file_status
        expected = dict(status.channel_statuses or {}) if status.incomplete_final_segment else {}
    groups, wanted = {group.name: group for group in file.groups()}, options.variable
    if wanted not in groups and (wanted or len(groups) != 1):
        raise RecordingError(
            f"no group {wanted!r}" if wanted else "not exactly one group",
            where=str(path),
            found=", ".join(sorted(groups)) or "none",
            hint="Say which one with variable.",
        )
    group = groups[wanted] if wanted in groups else next(iter(groups.values()))
    where = f"{path}: group {group.name!r}"
    findings: list[Finding] = []
    if lost:
        text = f"{lost} bytes from byte {at} on belong to no segment: the file is damaged; what lies before was read"
        findings.append(Finding(str(path), "problem", text, float(lost)))
    for one in group.channels():
        if one.path in expected and expected[one.path].read_length < expected[one.path].expected_length:
            lost = expected[one.path].expected_length - expected[one.path].read_length
            findings += announcement(one.name, len(one) + lost, len(one), where, refused=False)
    clocks: dict[tuple[float, ...], list[Column]] = {}
    with _understood(path, "a TDMS file"):
        for one in group.channels():
            if len(one) > 1 and one.dtype.kind in "fiu":
                unit = str(one.properties.get("unit_string", ""))
                column = Column(one.name, unit, np.array(one[:], dtype=float), str(path))
                step = one.properties.get("wf_increment")
                clock: tuple[float, ...] = ()
                if step is not None:
                    clock = (float(step), float(one.properties.get("wf_start_offset", 0.0)))
                clocks.setdefault(clock if findings else (*clock, len(one)), []).append(column)
    if not clocks:
        raise RecordingError("no numeric channel", where=where)
    tables = []
    for clock, columns in clocks.items():
        held = min(len(column.values) for column in columns)  # of a file that was cut off, what all channels have
        table = [replace(column, values=column.values[:held]) for column in columns]
        if len(clock) > 1 and not any(column.name == "time" for column in table):
            instants = np.asarray(clock[1] + np.arange(held) * clock[0], dtype=np.float64)
            table.insert(0, Column("time", "s", instants, str(path)))
        tables.append(table)
    return _by_clock(tables, path, options, findings=tuple(findings))


def _bytes_without_segment(stream: BinaryIO) -> tuple[int, int]:
    """Where the last TDMS segment ends, and how many bytes lie behind it; the library leaves them out silently."""
    size, at = stream.seek(0, os.SEEK_END), 0
    while at + 28 <= size:
        stream.seek(at)
        tag, _, _, length, before_data = struct.unpack("<4sIIQQ", stream.read(28))
        if tag != b"TDSm" or at + 28 + before_data > size:  # what its channels are is not whole
            break
        if length == 2**64 - 1:  # the writer did not come to its end
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
    """Numeric channels by time axis; bus frames (CAN, LIN) are decoded with ``options.database``.

    A signal of a bus message is named as in the database.
    """
    asammdf = require("asammdf", "io")
    # asammdf 8.1 and later ask lists of columns (MDF 4.2) for `self.self`, and read none of them
    require("asammdf.blocks.v4_blocks", "io").ListData.self = property(lambda one: one)
    findings: list[Finding] = []
    long_names = dict[str, str]()
    with (
        working_folder() as folder,
        _understood(path, "an MDF file"),
        _quiet(),
        asammdf.MDF(path, temporary_folder=str(folder)) as file,
    ):
        has_frames = any(name.endswith("DataFrame") for name in file.channels_db)
        sources = [file]
        if options.database is not None:
            databases = [(str(options.database), 0)]
            with _understood(options.database, "a database of bus messages"):
                sources.append(file.extract_bus_logging(database_files={"CAN": databases, "LIN": databases}))
        clocks: dict[bytes, list[Column]] = {}
        for source in sources:
            for signal in source.iter_channels(skip_master=True):
                if signal.name.startswith(_FRAMES) or signal.samples.ndim != 1 or signal.samples.size < 2:
                    continue
                if signal.samples.dtype.kind not in "fiu":
                    continue
                announced = int(source.groups[signal.group_index].channel_group.cycles_nr)
                findings += announcement(signal.name, announced, int(signal.samples.size), str(path), refused=False)
                instants = np.array(signal.timestamps, dtype=float)
                columns = clocks.setdefault(instants.tobytes(), [Column("time", "s", instants, str(path))])
                values = np.array(signal.samples, dtype=float)
                columns.append(Column(signal.name, str(signal.unit or ""), values, str(path)))
                long_names[signal.name] = str(signal.comment or "")
        attributes = attributes_in(getattr(file.header, "description", ""))
    if not clocks:
        hint = ""
        if has_frames:
            hint = (
                "None of its bus frames is in the database."
                if options.database
                else "It holds bus frames: give the database (.dbc) that decodes them."
            )
        raise RecordingError("no numeric channel over time", where=str(path), hint=hint)
    found = _by_clock(list(clocks.values()), path, options, findings=tuple(findings))
    return replace(found, long_names=long_names, attributes=attributes)


_FRAMES = ("CAN_", "LIN_", "ETH_", "FLX_")
_TIME_RESPONSE, _FUNCTIONS = 1, 58


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
    """Time responses, real numbers over the instants of most of them.

    A channel is named after its response entity (or ``point_<node>``), followed by ``:<node><direction>`` when several
    have that name. Time is in the unit that the data set gives, s where it gives none.
    """
    pyuff = require("pyuff", "io")
    with _understood(path, "a universal file"):
        file = pyuff.UFF(str(path))
        kinds = [int(kind) for kind in np.atleast_1d(file.get_set_types())]
        functions = [file.read_sets(index) for index, kind in enumerate(kinds) if kind == _FUNCTIONS]
    findings: list[Finding] = []
    if sum(line.strip() == b"-1" for line in path.read_bytes().splitlines()) % 2:
        text = "the last data set has no end: the file was cut off, and that data set was left out"
        findings.append(Finding(str(path), "problem", text))
    sets = [one for one in functions if one["func_type"] == _TIME_RESPONSE]
    if not sets:
        numbers = sorted({int(one["func_type"]) for one in functions})
        raise RecordingError(
            "no time response",
            where=str(path),
            found=f"data set 58 with functions of type {', '.join(map(str, numbers))}"
            if functions
            else f"data sets {', '.join(map(str, kinds))}"
            if kinds
            else "no whole data set",
            allowed=f"data set 58 with functions of type {_TIME_RESPONSE} (time response)",
        )
    entities = [str(one["rsp_ent_name"]).strip() for one in sets]
    names = [
        entity if entity not in ("", "NONE") else f"point_{one['rsp_node']}"
        for one, entity in zip(sets, entities, strict=True)
    ]
    clocks: dict[tuple[str, bytes], list[Column]] = {}
    left_out = []
    for one, name in zip(sets, names, strict=True):
        full = name if names.count(name) == 1 else f"{name}:{one['rsp_node']}{one['rsp_dir']:+d}"
        values, instants = np.ravel(one["data"]), np.asarray(one["x"], dtype=float)
        if np.iscomplexobj(values) or values.size < 2:
            left_out.append(full)
            continue
        findings += announcement(full, int(one.get("num_pts", values.size)), int(values.size), str(path), refused=False)
        held = min(values.size, instants.size)
        clock, unit = _label(one["abscissa_axis_units_lab"]) or "s", _label(one["ordinate_axis_units_lab"])
        columns = clocks.setdefault(
            (clock, instants[:held].tobytes()), [Column("time", clock, instants[:held], str(path))]
        )
        columns.append(Column(full, unit, np.array(values[:held], dtype=float), str(path)))
    if not clocks:
        raise RecordingError("no time response of real numbers", where=str(path), found=", ".join(left_out))
    return _by_clock(list(clocks.values()), path, options, left_out=tuple(left_out), findings=tuple(findings))


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
    """Every column with numbers; its unit from the name (``force [N]``) or the field's metadata (``unit``, ``units``).

    Instants, durations and times of day (not days) become seconds since the first; the index that pandas
    writes is a column like the others.
    """
    arrow, parquet = require("pyarrow", "io"), require("pyarrow.parquet", "io")
    columns, long_names = [], dict[str, str]()
    with _understood(path, "a Parquet file"), parquet.ParquetFile(path, page_checksum_verification=True) as file:
        check_counts(file.metadata, path)
        findings = check_end(file.metadata, path)
        table = file.read()
        attributes = attributes_in((table.schema.metadata or {}).get(ABOUT.encode(), b"").decode(errors="replace"))
        for field_, chunks in zip(table.schema, table.columns, strict=True):
            told = {key.decode(): value.decode() for key, value in (field_.metadata or {}).items()}
            name, unit = name_and_unit(field_.name)
            unit = unit or told.get("unit") or told.get("units") or ""
            long_names[name] = told.get("long_name", "")
            kind, values, fault = field_.type, np.empty(0), None
            if arrow.types.is_temporal(kind) and hasattr(kind, "unit") and _may_be_clock(name, unit):
                whole = chunks.cast(arrow.int32() if kind.bit_width == 32 else arrow.int64())
                ticks = whole.to_numpy()  # float, with NaN, where instants are missing
                values, unit = (
                    (ticks - ticks[0]).astype(float) * {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}[kind.unit],
                    "s",
                )
            elif arrow.types.is_integer(kind) or arrow.types.is_floating(kind) or arrow.types.is_decimal(kind):
                values = np.array(chunks.cast(arrow.float64()).to_numpy(), dtype=float)
            else:
                fault = RecordingError(
                    "text in a number column",
                    where=f"{path}: column {field_.name!r}",
                    found=str(kind),
                    allowed="numbers",
                    hint=NO_NUMBER,
                )
            columns.append(Column(name, unit, values, str(path), fault, "" if field_.name == name else field_.name))
    if not columns or not table.num_rows:
        raise RecordingError("no rows", where=str(path))
    return SignalTable(_named(columns, path, options), long_names, attributes, findings=tuple(findings))


_LARGEST_WORKBOOK = 1_000_000_000  # bytes, unpacked


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
    """The only sheet with numbers, or that of ``options.variable``; its cells are read as those of a text file.

    Behind the sheet's name may stand a range of its rows, or cells: ``Run 1!A5:D300``, ``!5:300``.
    Of formulas the values count that Excel has kept. A workbook that ``write_recording`` wrote tells names, units, long
    names and attributes in sheets of their own.
    """
    require("openpyxl", "io")
    kept: dict[str, list[list[Any]]] = {}
    with _understood(path, "an Excel workbook"):
        sheets = sheets_of(path, RecordingError, most_bytes=_LARGEST_WORKBOOK)
        for title, rows in sheets:
            kept[title] = [row for _, row in rows]
    is_ours = {*EXCEL} <= kept.keys() and options.variable in ("", EXCEL[0])
    sheet, mark, area = (options.variable, "", "")
    if sheet not in kept and "!" in sheet:
        sheet, mark, area = sheet.rpartition("!")
    title = EXCEL[0] if is_ours else _chosen_sheet(kept, sheet, path)
    if mark:
        kept[title] = _within(kept[title], area, path)
    table = _by_cell(_of_sheet(kept[title], options.header, path, title), kept[title], path, title)
    if not is_ours:
        others = tuple(name for name, rows in kept.items() if name != title and _holds_numbers(rows))
        with _understood(path, "an Excel workbook"):
            table = _without_days(table, path, title)
        return SignalTable(table, left_out=others)
    about = [["" if cell is None else str(cell) for cell in [*row, *[""] * 3][:3]] for row in kept[EXCEL[1]][1:]]
    if not options.header and len(about) == len(table):
        columns = [replace(one, name=name, unit=unit) for one, (name, unit, _) in zip(table, about, strict=True)]
        table = replace(table, columns=tuple(columns))
    with _understood(path, "a recording's workbook"):
        attributes = {
            str(key): json.loads("".join(str(piece) for piece in pieces if piece is not None))
            for key, *pieces in kept[EXCEL[2]][1:]
        }
    return SignalTable(table, {name: long_name for name, _, long_name in about}, attributes)


_AREA = re.compile(r"\$?([A-Z]*)\$?([1-9]\d*):\$?([A-Z]*)\$?([1-9]\d*)")


def _within(rows: list[list[Any]], area: str, path: Path) -> list[list[Any]]:
    """Rows of a sheet, empty but for a range of rows (``5:300``) or cells (``A5:D300``)."""
    found = _AREA.fullmatch(area.upper())
    if found is None or (found[1] == "") != (found[3] == ""):
        allowed = "rows or cells of a sheet, e.g. 'Run 1!5:300' or 'Run 1!A5:D300'"
        raise RecordingError("not a range", where=f"{path}: variable", found=area, allowed=allowed)
    first, last = (_place(found[1]), _place(found[3]) + 1) if found[1] else (0, None)
    top, bottom = int(found[2]), int(found[4])
    return [
        [*[None] * first, *row[first:last]] if top <= number <= bottom else [] for number, row in enumerate(rows, 1)
    ]


def _place(letters: str) -> int:
    """Place of a sheet's column from 0, by its name.

    >>> [_place(name) for name in ("A", "Z", "AA", "ZZ", "AAA")]
    [0, 25, 26, 701, 702]
    """
    place = 0
    for letter in letters:
        place = 26 * place + ord(letter) - ord("A") + 1
    return place - 1


def _of_sheet(rows: list[list[Any]], header: str, path: Path, sheet: str) -> ColumnTable:
    """Columns of a sheet, whose errors name its rows."""
    try:
        table = columns_in(_as_text(rows), path, len(parse_header(header)) if header else 0)
    except RecordingError as error:
        if error.what == "the file is empty":
            raise RecordingError("no row holds anything", where=f"{path}: sheet {sheet!r}") from None
        where = error.where.replace(f"{path}, line ", f"{path}: sheet {sheet!r}, row ")
        raise RecordingError(
            error.what, where=where, found=error.found, allowed=error.allowed, hint=error.hint
        ) from None
    remarks = [text.replace("the header is line", "the header is row") for text in table.remarks]
    remarks = [text.replace("from the line below", "from the row below") for text in remarks]
    return _renamed(replace(table, remarks=tuple(remarks), place="row"), header)


def _chosen_sheet(sheets: Mapping[str, list[list[Any]]], variable: str, path: Path) -> str:
    if variable:
        if variable not in sheets:
            hint = nearest(variable, sheets)
            raise RecordingError(f"no sheet {variable!r}", where=str(path), found=", ".join(sheets), hint=hint)
        return variable
    likely = [name for name, rows in sheets.items() if _holds_numbers(rows)]
    if not likely:
        raise RecordingError("no sheet with numbers", where=str(path), found=", ".join(sheets))
    if len(likely) > 1:
        hint = "Say which: variable = 'SHEET' (--variable), or 'SHEET!5:300' for some of its rows."
        raise RecordingError("several sheets hold numbers", where=str(path), found=", ".join(likely), hint=hint)
    return likely[0]


def _holds_numbers(rows: list[list[Any]]) -> bool:
    return any(map(_has_number, rows))


def _has_number(row: list[Any]) -> bool:
    return any(isinstance(cell, int | float) and not isinstance(cell, bool) for cell in row)


def _as_text(rows: list[list[Any]]) -> str:
    """Cells between tabs, a line a row: of the columns that rows with several cells use, and of titles all."""
    filled = [[i for i, cell in enumerate(row) if cell not in (None, "")] for row in rows]
    used = [i for places in filled if len(places) > 1 for i in places]
    first, end = min(used, default=0), max(used, default=-1) + 1
    lines = []
    for row in _with_seconds(rows):
        cells = [_cell_text(cell) for cell in [*row, *[None] * end]]
        lines.append("\t".join(cells[first:end]) if any(cells[first:end]) else " ".join(filter(None, cells)))
    return "".join(f"{line}\n" for line in lines)


def _with_seconds(rows: list[list[Any]]) -> list[list[Any]]:
    """Rows in which the unit above durations is s, whether another unit of time is written there or none.

    Durations below anything else stay: a number that is shown as hours is a duration for the library, too.
    """
    found = [list(row) for row in rows]
    below = {
        i: n for n, row in reversed([*enumerate(rows)]) for i, cell in enumerate(row) if isinstance(cell, timedelta)
    }
    for i, n in below.items():
        above = [row[i] for row in rows[max(n - 2, 0) : n] if i < len(row) and isinstance(row[i], str)]
        cells = {type(row[i]) for row in rows[n:] if i < len(row) and row[i] not in (None, "")}
        is_bare_unit = bool(above) and is_unit(above[-1]) and not names_time(above[-1])
        name, unit = (above[0], above[-1]) if is_bare_unit else name_and_unit(above[-1] if above else "")
        if cells == {timedelta} and _may_be_clock(name, unit):
            for row in found[n:]:
                if i < len(row) and isinstance(row[i], timedelta):
                    row[i] = row[i].total_seconds()
            if above:
                found[n - 1][i] = "s" if is_bare_unit else f"{name} [s]"
    return found


def _may_be_clock(name: str, unit: str) -> bool:
    """Whether durations and instants below a name and a unit are meant so: below a channel's they are a mistake."""
    is_channel = quantity_of(name) and channel_unit(name) != "s"
    return names_time(name) or (not is_channel and (not unit or is_unit_of(unit, "s")))


def _by_cell(table: ColumnTable, rows: list[list[Any]], path: Path, sheet: str) -> ColumnTable:
    """The table; a column's fault names the sheet's cell, and what is neither number nor text there.

    A known channel is no clock: instants and durations in it are such a fault.
    """
    columns = list(table.columns)
    for place, column in enumerate(columns):
        old = column.fault or RecordingError("", allowed="a number")
        line = int(found[1]) if (found := re.search(r", line (\d+): column ", old.where)) else 0
        if not (line or (column.fault is None and column.unit == "s" and not _may_be_clock(column.name, "s"))):
            continue
        heads = (column.written or column.label, column.label, column.name)
        below = {i for row in rows for i, cell in enumerate(row) if isinstance(cell, str) and _cell_text(cell) in heads}
        cells = [(n, i, row[i]) for n, row in enumerate(rows, 1) for i in sorted(below) if i < len(row)]
        if line:
            here = [one for one in cells if one[0] == line and _cell_text(one[2])[:80] == old.found]
        else:
            here = [one for one in cells if isinstance(one[2], datetime | time | timedelta)]
        if not here:
            if line:
                where = old.where.replace(f", line {line}", f": sheet {sheet!r}, row {line}")
                fault = RecordingError(old.what, where=where, found=old.found, allowed=old.allowed, hint=old.hint)
                columns[place] = replace(column, fault=fault)
            continue
        line, i, cell = here[0]
        kind = next((word for kinds, word in _KINDS_OF_CELL if isinstance(cell, kinds)), "")
        kind = "an error" if not kind and str(cell) in _ERRORS_OF_EXCEL else kind
        fault = RecordingError(
            f"{kind} in a column of numbers" if kind else old.what,
            where=f"{path}: sheet {sheet!r}, cell {_letters(i)}{line} (column {heads[0]!r})",
            found=str(cell).upper() if isinstance(cell, bool) else _cell_text(cell)[:80],
            allowed=old.allowed,
            hint="Correct the cell, or format it as a number; rename the column if it is no channel."
            if kind
            else old.hint,
        )
        columns[place] = replace(column, fault=fault)
    return replace(table, columns=tuple(columns))


_KINDS_OF_CELL = (
    (bool, "a truth value"), (datetime, "a date"), (time, "a time of day"), (timedelta, "a duration")
)  # fmt: skip
_ERRORS_OF_EXCEL = ("#DIV/0!", "#NAME?", "#NULL!", "#NUM!", "#REF!", "#VALUE!", "#GETTING_DATA", "#SPILL!", "#CALC!")


def _letters(column: int) -> str:
    """Name of a column of a sheet, from 0.

    >>> [_letters(column) for column in (0, 25, 26, 701, 702)]
    ['A', 'Z', 'AA', 'ZZ', 'AAA']
    """
    return (_letters(column // 26 - 1) if column > 25 else "") + chr(ord("A") + column % 26)


def _without_days(table: ColumnTable, path: Path, sheet: str) -> ColumnTable:
    """The table with durations in s that pandas wrote: days, shown as whole numbers that they are not."""
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
            columns[place] = replace(column, unit="s", values=seconds, written=column.written or column.label)
            remarks.append(f"{column.label!r} holds durations as pandas writes them, in days: they were read as s")
    return replace(table, columns=tuple(columns), remarks=tuple(remarks))


def _format_below(path: Path, sheet: str, header: str) -> str:
    """How a workbook shows the first number below a header."""
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
    """A cell as a text file has it: clocks as ISO 8601 has them."""
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
    """Columns on the clock that most of them share, and those on others; columns without a clock are left out."""
    usual = max(clocks, key=len)
    others = [columns for columns in clocks if columns is not usual]
    timed = [columns for columns in others if columns[0].name == "time"]
    unclear = tuple(column.name for columns in others if columns[0].name != "time" for column in columns)
    return SignalTable(
        _named(usual, path, options),
        left_out=left_out + unclear,
        others=tuple(ColumnTable(tuple(columns), (), str(path)) for columns in timed),
        findings=findings,
    )
