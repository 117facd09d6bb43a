"""Good recordings of every format that can be read, and what was recorded."""

from __future__ import annotations

import io
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import logger_files
import numpy as np

from jounce.core.workbooks import workbook_of

ROWS = 400
TIME = np.arange(ROWS) * 0.005
STROKE = 0.012 * np.sin(2.0 * np.pi * 1.7 * TIME) + 0.003 * np.sin(2.0 * np.pi * 11.0 * TIME)
FORCE = 900.0 + 25e3 * STROKE + 40.0 * np.sin(2.0 * np.pi * 5.0 * TIME + 0.3)
TRUTH = {"strut.stroke": STROKE, "strut.force": FORCE}


@dataclass(frozen=True)
class Sample:
    """A good file: its reader, its name, how it is read."""

    reader: str
    name: str
    content: bytes
    told: dict[str, Any] = field(default_factory=dict)
    has_checksums: bool = False
    rounding: float = 1e-9
    """Largest error of a stored number, as a share of the largest."""
    states_length: bool = True
    """Whether the format says how much belongs to a file; the end of a file that does not cannot be missed."""


_MAKERS: dict[str, Callable[[], Sample]] = {}


def _sample(make: Callable[[], Sample]) -> Callable[[], Sample]:
    _MAKERS[make.__name__.strip("_")] = make
    return make


def names() -> list[str]:
    """Names of all samples."""
    return list(_MAKERS)


def reader_of(name: str) -> str:
    """The reader of a sample, which is named after it."""
    from jounce.recordings import READERS

    return next(reader.name for reader in READERS if name.startswith(reader.name))


@cache
def sample(name: str) -> Sample:
    """One good file."""
    return _MAKERS[name]()


_TOLD = {"columns": {"time": "t [s]", "strut.stroke": "x [m]", "strut.force": "F [N]"}}


@_sample
def csv() -> Sample:
    rows = "".join(
        f"{t!r}, {x!r}, {f!r}\n"
        for t, x, f in zip(TIME.tolist(), STROKE.tolist(), FORCE.tolist(), strict=True)
    )
    return Sample("csv", "a.csv", f"time [s], strut.stroke [m], strut.force [N]\n{rows}".encode())


@_sample
def csv_decimal_commas() -> Sample:
    rows = "".join(
        f"{t:.3f};{x:.17g};{f:.17g}\n" for t, x, f in zip(TIME, STROKE, FORCE, strict=True)
    ).replace(".", ",")
    return Sample(
        "csv",
        "b.csv",
        f"# bench 3\n\ntime;strut.stroke;strut.force\ns;m;N\n{rows}".encode("utf-16"),
    )


@_sample
def lvm() -> Sample:
    return Sample("lvm", "a.lvm", _lvm("One", ".").encode())


@_sample
def lvm_without_times() -> Sample:
    return Sample("lvm", "n.lvm", _lvm("No", ",").encode())


@_sample
def lvm_with_own_times() -> Sample:
    return Sample("lvm", "m.lvm", _lvm("Multi", ".").encode())


def _lvm(columns: str, mark: str) -> str:
    """A text file of LabVIEW as LabVIEW writes it: tabs, one segment of two channels."""
    further = [""] * (columns == "Multi")

    def of_channels(tag: str, first: str, second: str) -> str:
        return "\t".join([tag, first, *further, second, ""])

    lines = ["LabVIEW Measurement\t", "Writer_Version\t2", "Reader_Version\t2", "Separator\tTab"]
    lines += [
        f"Decimal_Separator\t{mark}",
        "Multi_Headings\tNo",
        f"X_Columns\t{columns}",
        "Time_Pref\tRelative",
    ]
    lines += ["Date\t2026/01/01", "***End_of_Header***\t", "\t", of_channels("Channels", "2", "")]
    step, count = "0.005".replace(".", mark), str(ROWS)
    lines += [of_channels("Samples", count, count), of_channels("Y_Unit_Label", "m", "N")]
    lines += [of_channels("X_Dimension", "Time", "Time"), of_channels("X0", "0", "0")]
    lines += [of_channels("Delta_X", step, step), of_channels("***End_of_Header***", "", "")]
    lines.append(
        "\t".join(
            ["X_Value", "strut.stroke", *["X_Value"] * len(further), "strut.force", "Comment"]
        )
    )
    for t, x, f in zip(TIME.tolist(), STROKE.tolist(), FORCE.tolist(), strict=True):
        own = "" if columns == "No" else repr(t)
        lines.append("\t".join([own, repr(x), *[own] * len(further), repr(f)]).replace(".", mark))
    return "\r\n".join([*lines, ""])


@_sample
def netcdf() -> Sample:
    from jounce.recordings import recording, write_recording

    channels = {"strut.stroke": (STROKE, "m", "stroke"), "strut.force": (FORCE, "N", "force")}
    made = recording(TIME, channels, attributes={"made_by": "a test", "speed": 1.95})
    with tempfile.TemporaryDirectory() as folder:
        return Sample("netcdf", "a.nc", write_recording(made, Path(folder) / "a.nc").read_bytes())


@_sample
def netcdf3() -> Sample:
    from scipy.io import netcdf_file

    stream = io.BytesIO()
    with netcdf_file(stream, "w", version=2) as file:
        file.createDimension("time", None)
        for name, values, unit in (
            ("time", TIME, "s"),
            ("strut.stroke", STROKE, "m"),
            ("strut.force", FORCE, "N"),
        ):
            made = file.createVariable(name, "f8", ("time",))
            made.units, made[:] = unit, values
        file.flush()
        return Sample("netcdf", "a3.nc", stream.getvalue())


def _mat(**more: Any) -> bytes:
    from scipy.io import savemat

    stream = io.BytesIO()
    savemat(stream, {"t": TIME, "x": STROKE, "F": FORCE}, **more)
    return stream.getvalue()


@_sample
def mat4() -> Sample:
    return Sample("mat", "a4.mat", _mat(format="4"), _TOLD)


@_sample
def mat5() -> Sample:
    return Sample("mat", "a5.mat", _mat(do_compression=False), _TOLD)


@_sample
def mat5_compressed() -> Sample:
    return Sample("mat", "a5c.mat", _mat(do_compression=True), _TOLD, has_checksums=True)


@_sample
def mat5_struct() -> Sample:
    from scipy.io import savemat

    stream = io.BytesIO()
    run = {
        "t": TIME,
        "x": STROKE,
        "F": FORCE,
        "name": "run 3",
        "list": np.array([{"a": 1.0}, "text"], dtype=object),
    }
    savemat(stream, {"run": run}, do_compression=False)
    return Sample("mat", "s5.mat", stream.getvalue(), _TOLD)


@_sample
def mat73() -> Sample:
    import h5py

    stream = io.BytesIO()
    with h5py.File(stream, "w", userblock_size=512) as file:
        for name, values in (("t", TIME), ("x", STROKE), ("F", FORCE)):
            made = file.create_dataset(
                name, data=values[None, :], chunks=(1, 100), compression="gzip"
            )
            made.attrs["MATLAB_class"] = np.bytes_("double")
    content = bytearray(stream.getvalue())
    content[:128] = b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM"
    return Sample("mat", "a73.mat", bytes(content), _TOLD, has_checksums=True)


@_sample
def tdms() -> Sample:
    import nptdms

    stream = io.BytesIO()
    with nptdms.TdmsWriter(stream) as writer:
        for part in (slice(0, 150), slice(150, None)):
            writer.write_segment(
                [
                    nptdms.ChannelObject(
                        "Run",
                        name,
                        values[part],
                        properties={"unit_string": unit, "wf_increment": 0.005},
                    )
                    for name, values, unit in (("x", STROKE, "m"), ("F", FORCE, "N"))
                ]
            )
    return Sample(
        "tdms", "a.tdms", stream.getvalue(), {"columns": {"strut.stroke": "x", "strut.force": "F"}}
    )


def _mdf(version: str, suffix: str, **more: Any) -> bytes:
    import asammdf

    with tempfile.TemporaryDirectory() as folder, asammdf.MDF(version=version) as content:
        signals = [
            asammdf.Signal(v, TIME, name=n, unit=u)
            for n, v, u in (("x", STROKE, "m"), ("F", FORCE, "N"))
        ]
        content.append(signals, common_timebase=True)
        return Path(content.save(Path(folder) / f"a{suffix}", **more)).read_bytes()


_MDF_TOLD = {"columns": {"strut.stroke": "x", "strut.force": "F"}}


@_sample
def mdf3() -> Sample:
    return Sample("mdf", "a3.mdf", _mdf("3.30", ".mdf"), _MDF_TOLD)


@_sample
def mdf4() -> Sample:
    return Sample("mdf", "a4.mf4", _mdf("4.10", ".mf4"), _MDF_TOLD)


@_sample
def mdf4_compressed() -> Sample:
    return Sample(
        "mdf", "c4.mf4", _mdf("4.10", ".mf4", compression=2), _MDF_TOLD, has_checksums=True
    )


@_sample
def uff() -> Sample:
    return Sample(
        "uff",
        "a.uff",
        "".join((_set("x", 1, STROKE, "m"), _set("F", 2, FORCE, "N"))).encode(),
        _MDF_TOLD,
    )


def _set(entity: str, node: int, values: np.ndarray, unit: str) -> str:
    """A time response as the Universal File Format has it: ASCII, double precision, steps of 5 ms."""
    axis = f"{0:10d}{0:5d}{0:5d}{0:5d} "
    lines = ["    -1", "    58", "title", "NONE", "01-Jan-26", "NONE", "NONE"]
    lines.append(
        f"{1:5d}{0:10d}{0:5d}{0:10d} {entity:<10s}{node:10d}{3:4d} {'NONE':<10s}{0:10d}{0:4d}"
    )
    lines.append(f"{4:10d}{len(values):10d}{1:10d}{0.0:13.5e}{0.005:13.5e}{0.0:13.5e}")
    for label, of in (("Time", "s"), ("Response", unit), ("NONE", "NONE"), ("NONE", "NONE")):
        lines.append(f"{axis}{label:<20s} {of:<20s}")
    lines += ["".join(f"{v:20.12e}" for v in values[i : i + 4]) for i in range(0, len(values), 4)]
    return "\n".join([*lines, "    -1", ""])


_OF_RIG = (("x", "m", STROKE), ("F", "N", FORCE))


@_sample
def rpc() -> Sample:
    content = logger_files.rpc_file(_OF_RIG, 0.005, extra={"SAMPLES": ROWS})
    return Sample("rpc", "a.rsp", content, _MDF_TOLD, rounding=1e-6)


@_sample
def rpc_integers() -> Sample:
    scales = [float(np.abs(values).max()) / 32752 for _, _, values in _OF_RIG]
    content = logger_files.rpc_file(
        _OF_RIG, 0.005, kind="SHORT_INTEGER", scales=scales, extra={"SAMPLES": ROWS}
    )
    return Sample("rpc", "i.rsp", content, _MDF_TOLD, rounding=2e-5)


@_sample
def rpc_text() -> Sample:
    content = logger_files.rpc_file(_OF_RIG, 0.005, form="ASCII", extra={"SAMPLES": ROWS})
    return Sample("rpc", "t.rsp", content, _MDF_TOLD)


@_sample
def motec() -> Sample:
    channels = [(name, unit, 200, (7, 4), values) for name, unit, values in _OF_RIG]
    return Sample("motec", "a.ld", logger_files.ld_file(channels), _MDF_TOLD, rounding=1e-6)


@_sample
def vbo() -> Sample:
    rows = [
        f"008 {120000 + t:013.6f} +3119.37 -00059.48 {x!r} {f!r}"
        for t, x, f in zip(TIME.tolist(), STROKE.tolist(), FORCE.tolist(), strict=True)
    ]
    titles = ("satellites", "time", "latitude", "longitude", "x m", "F N")
    text = logger_files.vbo_text(rows, names="sats time lat long x F", titles=titles)
    return Sample("vbo", "a.vbo", text.encode(), _MDF_TOLD)


@_sample
def sst() -> Sample:
    from jounce.recordings import Sensor

    fork, shock = np.round((STROKE + 0.02) * 1e5), np.round(FORCE)
    stroke = Sensor(
        column="fork", sensitivity="100 counts/mm", zero="2000 counts", datum="undeformed"
    )
    force = Sensor(column="shock", sensitivity="1 counts/N", datum="undeformed")
    told = {"sensors": {"strut.stroke": stroke, "strut.force": force}}
    content = logger_files.sst_file(fork, shock, 200)
    return Sample("sst", "a.sst", content, told, rounding=1e-3, states_length=False)


@_sample
def parquet() -> Sample:
    import pyarrow as pa
    from pyarrow import parquet as pq

    stream = io.BytesIO()
    table = pa.table({"time [s]": TIME, "strut.stroke [m]": STROKE, "strut.force [N]": FORCE})
    pq.write_table(table, stream, row_group_size=150)
    return Sample("parquet", "a.parquet", stream.getvalue())


@_sample
def excel() -> Sample:
    rows = zip(TIME.tolist(), STROKE.tolist(), FORCE.tolist(), strict=True)
    sheets = {"Messung": [("time [s]", "strut.stroke [m]", "strut.force [N]"), *rows]}
    return Sample("excel", "a.xlsx", workbook_of(sheets))
