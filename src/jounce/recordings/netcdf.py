"""Variables of netCDF files: netCDF-4 (HDF5), and netCDF-3 in its classic, 64-bit-offset and 64-bit-data variants."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.findings import Finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.recordings.hdf5 import rows_on_disk, surplus


@dataclass(frozen=True)
class Variable:
    """A variable: its dimensions, its number type, and its announced and written rows."""

    dimensions: tuple[str, ...]
    shape: tuple[int, ...]
    kind: str
    attributes: Mapping[str, Any]
    held: Callable[[], int]
    raw: Callable[[int], Any]

    @property
    def along(self) -> str:
        """Dimension of a numeric vector (all others have length 1); empty for anything else."""
        long = [name for name, size in zip(self.dimensions, self.shape, strict=True) if size != 1]
        is_vector = self.kind in "fiu" and self.dimensions and len(long) < 2
        return (long or list(self.dimensions))[0] if is_vector else ""

    def values(self, rows: int) -> Array:
        """Return the first rows of a vector, unpacked, with NaN for gaps; times are relative to the first row."""
        raw = np.asarray(self.raw(rows)).reshape(-1)
        values = np.asarray(_unpack(raw, self.attributes))
        if values.dtype.kind == "f":
            values = np.where(np.abs(values) == values.dtype.type(_FILLED), np.nan, values)
        if self.unit[1]:
            values = values - values[:1]  # as integers, before rounding: instants are large numbers
        return np.ascontiguousarray(values, dtype=float)

    @property
    def unit(self) -> tuple[str, str]:
        """Unit, and for a time its reference date (CF 4.4)."""
        unit, _, since = str(self.attributes.get("units", "")).partition(" since ")
        return unit.strip(), since.strip()


@dataclass(frozen=True)
class VariableGroup:
    """Variables and attributes of a file or of a group within it, and its subgroups."""

    variables: Mapping[str, Variable]
    attributes: Mapping[str, Any]
    groups: Mapping[str, VariableGroup] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()

    def signals(self, path: str = "") -> Iterator[tuple[str, VariableGroup]]:
        """Yield each group with numeric vectors, together with inherited variables along the same dimensions."""
        if any(variable.along and name != "time" for name, variable in self.variables.items()):
            yield path, self
        for name, group in self.groups.items():
            inherited = {
                key: variable
                for key, variable in self.variables.items()
                if key in variable.dimensions
            }
            attributes = {**self.attributes, **group.attributes}
            below = VariableGroup({**inherited, **group.variables}, attributes, group.groups)
            yield from below.signals(f"{path}/{name}".lstrip("/"))


@contextmanager
def open_netcdf(path: Path) -> Iterator[VariableGroup]:
    """Open a netCDF file of any kind; its numbers can be read until the block ends."""
    with path.open("rb") as stream:
        is_classic = stream.read(3) == b"CDF"
    if is_classic:
        yield _classic(path.read_bytes(), str(path))
        return
    import h5netcdf

    with h5netcdf.File(path, "r") as file:
        yield _hdf5_group(file)


def _hdf5_group(group: Any) -> VariableGroup:
    return VariableGroup(
        {str(name): _hdf5_variable(variable) for name, variable in group.variables.items()},
        _plain_attributes(group.attrs),
        {str(name): _hdf5_group(below) for name, below in group.groups.items()},
    )


def _hdf5_variable(variable: Any) -> Variable:
    def raw(rows: int) -> Any:
        return variable[tuple(slice(None) if size == 1 else slice(rows) for size in variable.shape)]

    kind, attributes = getattr(variable.dtype, "kind", "O"), _plain_attributes(variable.attrs)

    def count_rows() -> int:
        return rows_on_disk(variable._h5ds)[1]

    return Variable(variable.dimensions, variable.shape, kind, attributes, count_rows, raw)


def _plain_attributes(attributes: Mapping[str, Any]) -> dict[str, Any]:
    return {str(name): plain_attribute(value) for name, value in attributes.items()}


def plain_attribute(value: Any) -> Any:
    """Convert stored text to str, and a list of one value to that value.

    >>> plain_attribute(b"m/s"), plain_attribute(["N"]), plain_attribute(np.array([2.5]))
    ('m/s', 'N', np.float64(2.5))
    """
    if isinstance(value, bytes):
        return _text(value)
    if isinstance(value, str):  # HDF5 declares ASCII where it is not
        return _text(value.encode(errors="surrogateescape"))
    if isinstance(value, (list, tuple, np.ndarray)):
        items = np.asarray(value)
        if items.dtype.kind in "OSU":
            items = np.array(
                [plain_attribute(item) for item in items.ravel().tolist()], dtype=object
            )
        return items[0] if items.shape == (1,) else items
    return (
        value if isinstance(value, (int, float, np.generic)) else ""
    )  # h5py.Empty: a text of no letter


def _text(content: bytes) -> str:
    content = content.rstrip(b"\0")
    try:
        return content.decode()
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace")


_FILLED = 9.9692099683868690e36
"""Default fill value of the netCDF library for numbers that were never written."""
_CODES, _GAPS = (
    ("scale_factor", "add_offset", "_Unsigned", "dtype"),
    ("_FillValue", "missing_value"),
)


def _unpack(raw: Array, about: Mapping[str, Any]) -> Array:
    """Decode packed numbers and gaps (CF 8.1 and 2.5.1); plain numbers are returned without loading xarray."""
    gaps = [np.asarray(about[key]) for key in _GAPS if key in about]
    none = raw.dtype.kind == "f" and all(
        gap.dtype.kind == "f" and bool(np.isnan(gap).all()) for gap in gaps
    )
    if not any(key in about for key in _CODES) and (none or not gaps):
        return raw
    import xarray as xr

    variable = xr.Variable(("time",), raw, dict(about))
    decoded = xr.conventions.decode_cf_variable(
        "", variable, decode_times=False, decode_timedelta=False
    )
    return np.asarray(decoded.values)


# --- netCDF-3: a header of big-endian numbers, then the variables, those of the record dimension row by row


_DIMENSION, _VARIABLE, _ATTRIBUTE = 10, 11, 12  # tags of the format, as are the kinds of numbers
_KINDS = {
    1: "i1",
    2: "S1",
    3: ">i2",
    4: ">i4",
    5: ">f4",
    6: ">f8",
    7: "u1",
    8: ">u2",
    9: ">u4",
    10: ">i8",
    11: ">u8",
}
_WORD = 4  # bytes: every part begins at a multiple


class _Header:
    """Sequential reader of the header; invalid values raise ValueError or struct.error."""

    def __init__(self, content: bytes) -> None:
        self.content, self.at = content, _WORD
        version = content[3]
        if version not in (1, 2, 5):
            raise ValueError(Phrase("version {version}", version=version))
        self.count, self.place = ">q" if version == 5 else ">i", ">i" if version == 1 else ">q"

    def number(self, kind: str = "") -> int:
        (value,) = struct.unpack_from(kind or self.count, self.content, self.at)
        self.at += struct.calcsize(kind or self.count)
        return int(value)

    def size(self) -> int:
        size = self.number()
        if not 0 <= size <= len(self.content):
            raise ValueError(Phrase("a length of {size}", size=size))
        return size

    def numbers(self, kind: str, count: int) -> Any:
        values = np.frombuffer(self.content, kind, count, self.at)
        self.at += -(-values.nbytes // _WORD) * _WORD
        return values

    def name(self) -> str:
        return str(self.numbers("S1", self.size()).tobytes().decode())

    def items(self, tag: int, read: Callable[[], Any]) -> list[Any]:
        kind, count = self.number(">i"), self.size()
        if kind != tag and (kind or count):
            raise ValueError(Phrase("a list of kind {kind}", kind=kind))
        return [read() for _ in range(count)]

    def attribute(self) -> tuple[str, Any]:
        name, kind = self.name(), _KINDS[self.number(">i")]
        values = self.numbers(kind, self.size())
        return name, plain_attribute(values.tobytes() if kind == "S1" else values)

    def variable(self, dimensions: Sequence[tuple[str, int]]) -> _Placed:
        name, own = self.name(), tuple(dimensions[self.size()] for _ in range(self.size()))
        attributes, kind = (
            dict(self.items(_ATTRIBUTE, self.attribute)),
            np.dtype(_KINDS[self.number(">i")]),
        )
        self.number()  # its size, which follows from the rest and overflows where it is large
        return _Placed(name, own, attributes, kind, self.number(self.place))


@dataclass(frozen=True)
class _Placed:
    """A variable of the header with its offset in the file; the record dimension has length 0."""

    name: str
    dimensions: tuple[tuple[str, int], ...]
    attributes: dict[str, Any]
    kind: np.dtype[Any]
    begin: int

    @property
    def is_record(self) -> bool:
        return bool(self.dimensions) and self.dimensions[0][1] == 0

    @property
    def width(self) -> int:
        """Bytes of the variable, or of one record of it."""
        return math.prod(size for _, size in self.dimensions[self.is_record :]) * self.kind.itemsize


def _classic(content: bytes, where: str) -> VariableGroup:
    header, size = _Header(content), len(content)
    records = header.number()
    dimensions = header.items(_DIMENSION, lambda: (header.name(), header.number()))
    attributes = dict(header.items(_ATTRIBUTE, header.attribute))
    variables = header.items(_VARIABLE, lambda: header.variable(dimensions))
    widths = [variable.width for variable in variables if variable.is_record]
    step = widths[0] if len(widths) == 1 else sum(-(-width // _WORD) * _WORD for width in widths)
    first = min((variable.begin for variable in variables if variable.is_record), default=size)
    if records == -1:  # written as a stream of unknown length
        records = (size - first) // max(step, 1)
    parts = sorted([(0, header.at), *((item.begin, item.begin + item.width) for item in variables)])
    if min(records, *(length for _, length in dimensions), 0) < 0 or any(
        begin < end for (_, end), (begin, _) in pairwise(parts)
    ):
        raise ValueError("variables overlap")
    end = max(first + records * step if widths else 0, *(end for _, end in parts))
    findings = surplus(end, size, where) if size - end >= _WORD else []
    by_name = {
        variable.name: _variable_at(variable, content, records, step) for variable in variables
    }
    return VariableGroup(by_name, attributes, {}, tuple(findings))


def _variable_at(variable: _Placed, content: bytes, records: int, step: int) -> Variable:
    shape = tuple(size for _, size in variable.dimensions[variable.is_record :])
    shape = (records, *shape) if variable.is_record else shape
    stride = step if variable.is_record and records != 1 else variable.kind.itemsize
    room = max(0, len(content) - variable.begin - variable.kind.itemsize + stride) // max(stride, 1)
    held = min(max(shape, default=1), room)

    def raw(rows: int) -> Any:
        return np.ndarray(rows, variable.kind, content, variable.begin, (stride,))

    names = tuple(name for name, _ in variable.dimensions)
    return Variable(names, shape, variable.kind.kind, variable.attributes, lambda: held, raw)
