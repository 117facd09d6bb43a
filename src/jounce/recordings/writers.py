"""Writers for recordings in several formats, which ``read_recording`` reads back without loss."""

from __future__ import annotations

import io
import json
import re
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.errors import OutputError
from jounce.core.optional import require
from jounce.core.phrases import Phrase
from jounce.core.serialise import to_plain
from jounce.core.text import guard_formula, place_in
from jounce.core.types import Array
from jounce.core.workbooks import CONTROL, MOST_COLUMNS, MOST_ROWS, split_text, workbook_of
from jounce.core.writing import Formats, working_folder
from jounce.recordings.quality import LARGEST_JITTER
from jounce.recordings.rpc import rpc_of

if TYPE_CHECKING:
    import xarray as xr

_NUMBERS = "fiub"  # numeric dtype kinds
_LONGEST_NAME = 63  # characters of a variable in MATLAB (namelengthmax)
ABOUT = "jounce"
"""Key under which other formats store the recording's attributes as JSON."""


def netcdf_of(dataset: xr.Dataset) -> bytes:
    """Return the content of a netCDF-4 file, built in memory: HDF5 would crash the process on a full disk."""
    for name in dataset.variables:
        _check_name(str(name), "/", ".csv or .parquet")
    return bytes(_storable(dataset).to_netcdf(None, engine="h5netcdf"))


def _storable(dataset: xr.Dataset) -> xr.Dataset:
    """Return the dataset with attributes that a file can store; other objects become JSON text."""
    copy = dataset.copy(deep=False)
    copy.attrs = {
        str(key): _characters(_storable_attribute(value)) for key, value in dataset.attrs.items()
    }
    for variable in copy.variables.values():
        variable.encoding.pop("source", None)
        variable.attrs = {key: _characters(value) for key, value in variable.attrs.items()}
    return copy


def _characters(value: object) -> object:
    """Encode ASCII text as netCDF characters, as the netCDF library does: only a few programs read strings."""
    return (
        np.bytes_(value.encode()) if isinstance(value, str) and value and value.isascii() else value
    )


def _storable_attribute(value: object) -> object:
    if isinstance(value, (str, int, float, np.ndarray, np.generic)) and not isinstance(
        value, (bool, np.bool_)
    ):
        return value
    return json.dumps(to_plain(value), ensure_ascii=False)


def _signals(dataset: xr.Dataset) -> dict[str, xr.DataArray]:
    """Return time and channels by name; refuse a dataset with other variables, which would be lost."""
    for name, channel in dataset.data_vars.items():
        if channel.dims != ("time",) or channel.dtype.kind not in _NUMBERS:
            shape = f"{channel.dtype.name} over ({', '.join(map(str, channel.dims))})"
            raise OutputError(
                "not a numeric channel over time",
                where=str(name),
                found=shape,
                allowed="numbers over (time)",
                hint="Leave it out, or write .nc, which can store everything.",
            )
    return {
        "time": dataset["time"],
        **{str(name): channel for name, channel in dataset.data_vars.items()},
    }


def _check_name(name: str, signs: str, instead: str) -> None:
    """Refuse a name that a format cannot store: empty, only dots, or with a line break or one of ``signs``."""
    if not name.strip(" .") or any(sign in name for sign in (*signs, "\n", "\r")):
        words = " ".join(repr(sign) for sign in signs)
        hint = Phrase("Rename the channel, or write {instead}.", instead=instead)
        raise OutputError(
            "a name that the file cannot store",
            where="channel",
            found=name,
            allowed=Phrase("names without {words}", words=words),
            hint=hint,
        )


def _check_texts(dataset: xr.Dataset, *, attributes: bool) -> None:
    """Refuse texts that a file cannot store, and units with control characters; errors of libraries name neither.

    Without ``attributes``, attributes of the recording are not checked: the format stores them as JSON in ASCII.
    """
    holders: dict[str, Any] = {"": dataset} if attributes else {}
    holders |= {str(name): variable for name, variable in dataset.variables.items()}
    for name, holder in holders.items():
        texts: list[tuple[str, Any]] = [("channel", name)]
        texts += [(f"{name} attribute".strip(), str(key)) for key in holder.attrs]
        texts += [(place_in(name, str(key)), value) for key, value in holder.attrs.items()]
        for where, value in texts:
            text = value if isinstance(value, str) else str(_storable_attribute(value))
            is_wrong = "\0" in text or not _is_unicode(text)
            is_wrong |= where.endswith(": units") and not text.isprintable()
            is_wrong |= where.endswith("attribute") and not text
            if is_wrong:
                raise OutputError(
                    f"a {'name' if where == 'channel' else 'text'} that the file cannot store",
                    where=where,
                    found=text,
                    allowed="Unicode without NUL; non-empty names, and units without control characters",
                    hint="Correct the value, or leave it out.",
                )


def _is_unicode(text: str) -> bool:
    try:
        text.encode()
    except (
        UnicodeEncodeError
    ):  # a lone surrogate, by which Python represents file names that are not UTF-8
        return False
    return True


def _unit(signal: xr.DataArray) -> str:
    return str(signal.attrs.get("units", "1"))


def _about(dataset: xr.Dataset) -> str:
    """Return the attributes of a recording as JSON text."""
    plain = {str(key): to_plain(_storable_attribute(value)) for key, value in dataset.attrs.items()}
    return json.dumps({ABOUT: plain}, ensure_ascii=False)


def attributes_in(text: object) -> dict[str, object]:
    """Parse attributes written by ``_about``; empty for other texts.

    >>> attributes_in('{"jounce": {"method": "exact"}}'), attributes_in("made by hand")
    ({'method': 'exact'}, {})
    """
    try:
        content = json.loads(str(text))
        return dict(content[ABOUT])
    except (ValueError, TypeError, KeyError, RecursionError):
        return {}


def _csv_of(dataset: xr.Dataset) -> bytes:
    signals = _signals(dataset)
    for name in signals:
        _check_name(name, ",;\t", ".nc")
    header = ",".join(
        guard_formula(f"{name} [{_unit(signal)}]") for name, signal in signals.items()
    )
    table = np.column_stack([signal.values for signal in signals.values()])
    rows = (",".join(map(repr, row)) for row in table.tolist())
    return ("\n".join([header, *rows]) + "\n").encode()


def matlab_name(name: str) -> str:
    """Convert a channel's name to a valid MATLAB name.

    >>> matlab_name("front_left.sprung.az")
    'front_left_sprung_az'
    """
    variable = re.sub(r"\W", "_", name, flags=re.ASCII)[:_LONGEST_NAME]
    return variable if variable[:1].isalpha() else f"x{variable}"[:_LONGEST_NAME]


def _mat_of(dataset: xr.Dataset) -> bytes:
    """Write vectors, and structs of their ``names``, ``units`` and ``long_names``; attributes as JSON text."""
    from scipy.io import savemat

    signals = _signals(dataset)
    own = {"names", "units", "long_names", "attributes"}
    variables: dict[str, str] = {}
    for name in signals:
        variable = matlab_name(name)
        if variable in variables or variable in own:
            raise OutputError(
                "two channels have the same name in MATLAB",
                where=variable,
                found=f"{variables.get(variable, variable)} and {name}",
                hint="Rename one of them, or write .nc or .parquet.",
            )
        variables[variable] = name
    content: dict[str, Any] = {
        variable: signals[name].values for variable, name in variables.items()
    }
    content["names"] = variables
    content["units"] = {variable: _unit(signals[name]) for variable, name in variables.items()}
    texts = {
        variable: str(signals[name].attrs.get("long_name", ""))
        for variable, name in variables.items()
    }
    content["long_names"], content["attributes"] = texts, _about(dataset)
    buffer = io.BytesIO()
    savemat(buffer, content, do_compression=True, long_field_names=True, oned_as="column")
    return buffer.getvalue()


def _mdf_of(dataset: xr.Dataset) -> bytes:
    """Write one group of channels over time, each with its unit, and its long name as a comment."""
    asammdf = require("asammdf", "io")
    signals = _signals(dataset)
    for name in signals:
        _check_name(name, "", ".nc")
    time = np.ascontiguousarray(signals.pop("time").values, dtype=float)
    rows = [
        asammdf.Signal(
            np.ascontiguousarray(signal.values, dtype=float),
            time,
            name=name,
            unit=_unit(signal),
            comment=str(signal.attrs.get("long_name", "")),
        )
        for name, signal in signals.items()
    ]
    buffer = io.BytesIO()
    with working_folder() as folder:
        file = asammdf.MDF(version="4.10", temporary_folder=str(folder))
        try:
            file.append(rows, acq_name="recording", common_timebase=True)
            file.header.description = _about(dataset)
            file.save(buffer, compression=2)
        finally:
            with suppress(OSError):  # its temporary file is removed with the folder
                file.close()
    return buffer.getvalue()


def _parquet_of(dataset: xr.Dataset) -> bytes:
    """Write one column per channel, with ``units`` and ``long_name`` in its metadata."""
    arrow, parquet = require("pyarrow", "io"), require("pyarrow.parquet", "io")
    signals = _signals(dataset)
    fields = [
        arrow.field(
            name,
            arrow.float64(),
            metadata={"units": _unit(signal), "long_name": str(signal.attrs.get("long_name", ""))},
        )
        for name, signal in signals.items()
    ]
    schema = arrow.schema(fields, metadata={ABOUT: _about(dataset)})
    columns = [np.asarray(signal.values, dtype=float) for signal in signals.values()]
    buffer = io.BytesIO()
    parquet.write_table(
        arrow.table(columns, schema=schema), buffer, compression="zstd", write_page_checksum=True
    )
    return buffer.getvalue()


EXCEL = "recording", "channels", "attributes"
"""Sheets of a workbook: columns headed ``name [unit]``, names of the channels, and attributes as JSON text."""


def _xlsx_of(dataset: xr.Dataset) -> bytes:
    """Write one column per channel, a sheet of their names, units and labels, and a sheet of attributes."""
    signals = _signals(dataset)
    for name, signal in signals.items():
        _check_name(name, "".join(CONTROL.findall(name)), ".nc")
        if not np.isfinite(signal.values).all():
            hint = "Write .nc, .mat, .mf4 or .parquet, or leave the channel out."
            raise OutputError(
                "a sheet can store only finite numbers",
                where=name,
                found="NaN or infinity",
                hint=hint,
            )
    rows, columns = dataset.sizes["time"] + 1, len(signals)
    if rows > MOST_ROWS or columns > MOST_COLUMNS:
        raise OutputError(
            "more than an Excel sheet can store",
            where="recording",
            found=f"{rows} rows, {columns} columns",
            allowed=Phrase(
                "{most_rows} rows, {most_columns} columns",
                most_rows=MOST_ROWS,
                most_columns=MOST_COLUMNS,
            ),
            hint="Write .nc or .parquet, or every tenth sample.",
        )
    heads = [f"{name} [{_unit(signal)}]" for name, signal in signals.items()]
    numbers = zip(
        *(np.asarray(signal.values, dtype=float).tolist() for signal in signals.values()),
        strict=True,
    )
    channels = [
        (name, _unit(signal), CONTROL.sub(" ", str(signal.attrs.get("long_name", ""))))
        for name, signal in signals.items()
    ]
    texts = {
        key: json.dumps(value, ensure_ascii=False)
        for key, value in json.loads(_about(dataset))[ABOUT].items()
    }
    texts = {
        key: CONTROL.sub(lambda sign: f"\\u{ord(sign[0]):04x}", text) for key, text in texts.items()
    }
    attributes = [(CONTROL.sub(" ", key), *split_text(text)) for key, text in texts.items()]
    sheets: dict[str, list[Sequence[float | str]]] = {
        EXCEL[0]: [heads, *numbers],
        EXCEL[1]: [("channel", "unit", "long name"), *channels],
        EXCEL[2]: [("attribute", "value, as JSON"), *attributes],
    }
    return workbook_of(sheets)


def rpc_of_recording(dataset: xr.Dataset, *, integers: bool) -> tuple[bytes, dict[str, float]]:
    """Return an RPC III file, and the largest rounding error of each channel in its unit."""
    signals = _signals(dataset)
    time = np.asarray(signals.pop("time").values, dtype=float)
    start, step = _uniform(time)
    return rpc_of(
        {
            name: (np.asarray(signal.values, dtype=float), _unit(signal))
            for name, signal in signals.items()
        },
        start,
        step,
        integers=integers,
    )


def _rpc_of(dataset: xr.Dataset) -> bytes:
    return rpc_of_recording(dataset, integers=False)[0]


def _uniform(time: Array) -> tuple[float, float]:
    """Return start and step of uniform time; refuse other times."""
    if time.size < 2:
        raise OutputError(
            "too few samples", where="time", found=str(time.size), allowed="2 or more"
        )
    count = np.arange(time.size)
    start, mean = float(time[0]), float(time[-1] - time[0]) / (time.size - 1)
    if not mean > 0.0 or np.abs(time - start - count * mean).max() > LARGEST_JITTER * mean:
        raise OutputError(
            "the time steps are not uniform",
            where="time",
            allowed="equal steps, which are all that the file can store",
            hint="Resample the recording first.",
        )
    short = float(f"{mean:.12g}")  # 0.001 rather than 0.0009999999999999998
    is_same = abs(short - mean) * time.size < 1e-6 * mean
    return start, short if is_same else mean


def _writer(
    content: Callable[[xr.Dataset], bytes], *, attributes: bool = True
) -> Callable[[xr.Dataset, Path], object]:
    def write(dataset: xr.Dataset, file: Path) -> None:
        _check_texts(dataset, attributes=attributes)
        file.write_bytes(content(dataset))

    return write


RECORDING_FILES = Formats(
    "recordings",
    {
        ".nc": _writer(netcdf_of),
        ".csv": _writer(_csv_of, attributes=False),
        ".mat": _writer(_mat_of),
        ".mf4": _writer(_mdf_of),
        ".parquet": _writer(_parquet_of),
        ".xlsx": _writer(_xlsx_of, attributes=False),
        ".rsp": _writer(_rpc_of, attributes=False),
    },
)
"""File formats in which recordings can be written."""
