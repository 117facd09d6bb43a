"""Variables of netCDF files: netCDF-4, which is HDF5, and netCDF-3 with its three widths of numbers."""

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
from jounce.core.types import Array
from jounce.recordings.hdf5 import held_rows, surplus


@dataclass(frozen=True)
class Variable:
    """A variable: its dimensions, the kind of its numbers, how many rows are announced and how many are there."""

    dimensions: tuple[str, ...]
    shape: tuple[int, ...]
    kind: str
    attributes: Mapping[str, Any]
    held: Callable[[], int]
    raw: Callable[[int], Any]

    @property
    def along(self) -> str:
        """The dimension of a vector of numbers, beside which all others have the length 1; empty for what is none."""
        long = [name for name, size in zip(self.dimensions, self.shape, strict=True) if size != 1]
        is_vector = self.kind in "fiu" and self.dimensions and len(long) < 2
        return (long or list(self.dimensions))[0] if is_vector else ""

    def values(self, rows: int) -> Array:
        """Give the first rows of a vector: unpacked, NaN for gaps, times since an instant from the first one."""
        raw = np.asarray(self.raw(rows)).reshape(-1)
        values = np.asarray(_unpacked(raw, self.attributes))
        if values.dtype.kind == "f":
            values = np.where(np.abs(values) == values.dtype.type(_FILLED), np.nan, values)
        if self.unit[1]:
            values = values - values[:1]  # of integers before they are rounded: instants are large
        return np.ascontiguousarray(values, dtype=float)

    @property
    def unit(self) -> tuple[str, str]:
        """The unit, and for a time the instant that it counts from (CF 4.4)."""
        unit, _, since = str(self.attributes.get("units", "")).partition(" since ")
        return unit.strip(), since.strip()


@dataclass(frozen=True)
class Group:
    """Variables and attributes of a file, or of a group within it, and the groups below it."""

    variables: Mapping[str, Variable]
    attributes: Mapping[str, Any]
    groups: Mapping[str, Group] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()

    def signals(self, path: str = "") -> Iterator[tuple[str, Group]]:
        """Give each group that holds numbers over something, with those that lie above it along the same."""
        if any(one.along and name != "time" for name, one in self.variables.items()):
            yield path, self
        for name, group in self.groups.items():
            inherited = {key: one for key, one in self.variables.items() if key in one.dimensions}
            below = Group({**inherited, **group.variables}, {**self.attributes, **group.attributes}, group.groups)
            yield from below.signals(f"{path}/{name}".lstrip("/"))


@contextmanager
def opened(path: Path) -> Iterator[Group]:
    """Open a netCDF file of any kind; its numbers can be read until the block ends."""
    with path.open("rb") as stream:
        is_classic = stream.read(3) == b"CDF"
    if is_classic:
        yield _classic(path.read_bytes(), str(path))
        return
    import h5netcdf

    with h5netcdf.File(path, "r") as file:
        yield _hdf5_group(file)


def _hdf5_group(group: Any) -> Group:
    return Group(
        {str(name): _hdf5_variable(one) for name, one in group.variables.items()},
        _plain_attributes(group.attrs),
        {str(name): _hdf5_group(one) for name, one in group.groups.items()},
    )


def _hdf5_variable(one: Any) -> Variable:
    def raw(rows: int) -> Any:
        return one[tuple(slice(None) if size == 1 else slice(rows) for size in one.shape)]

    kind = getattr(one.dtype, "kind", "O")
    return Variable(
        one.dimensions, one.shape, kind, _plain_attributes(one.attrs), lambda: held_rows(one._h5ds)[1], raw
    )  # fmt: skip


def _plain_attributes(attributes: Mapping[str, Any]) -> dict[str, Any]:
    return {str(name): plain_attribute(value) for name, value in attributes.items()}


def plain_attribute(value: Any) -> Any:
    """Text as text, however it is stored, and one value in place of a list of one.

    >>> plain_attribute(b"m/s"), plain_attribute(["N"]), plain_attribute(np.array([2.5]))
    ('m/s', 'N', np.float64(2.5))
    """
    if isinstance(value, bytes):
        return _text(value)
    if isinstance(value, str):  # HDF5 says that it is ASCII where it is not
        return _text(value.encode(errors="surrogateescape"))
    if isinstance(value, (list, tuple, np.ndarray)):
        items = np.asarray(value)
        if items.dtype.kind in "OSU":
            items = np.array([plain_attribute(item) for item in items.ravel().tolist()], dtype=object)
        return items[0] if items.shape == (1,) else items
    return value if isinstance(value, (int, float, np.generic)) else ""  # h5py.Empty: a text of no letter


def _text(content: bytes) -> str:
    content = content.rstrip(b"\0")
    try:
        return content.decode()
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace")


_FILLED = 9.9692099683868690e36
"""What the netCDF library puts where no number was written, and no attribute says so."""
_CODES, _GAPS = ("scale_factor", "add_offset", "_Unsigned", "dtype"), ("_FillValue", "missing_value")


def _unpacked(raw: Array, about: Mapping[str, Any]) -> Array:
    """Values of numbers that are packed or stand for gaps (CF 8.1 and 2.5.1); most are neither, and need no library."""
    gaps = [np.asarray(about[key]) for key in _GAPS if key in about]
    none = raw.dtype.kind == "f" and all(gap.dtype.kind == "f" and bool(np.isnan(gap).all()) for gap in gaps)
    if not any(key in about for key in _CODES) and (none or not gaps):
        return raw
    import xarray as xr

    variable = xr.Variable(("time",), raw, dict(about))
    decoded = xr.conventions.decode_cf_variable("", variable, decode_times=False, decode_timedelta=False)
    return np.asarray(decoded.values)


# --- netCDF-3: a header of big-endian numbers, then the variables, those of the record dimension row by row


_DIMENSION, _VARIABLE, _ATTRIBUTE = 10, 11, 12
_KINDS = {1: "i1", 2: "S1", 3: ">i2", 4: ">i4", 5: ">f4", 6: ">f8", 7: "u1", 8: ">u2", 9: ">u4", 10: ">i8", 11: ">u8"}
_WORD = 4  # bytes: everything begins at a multiple of it


class _Header:
    """What is read from the header, one after the other; ValueError and struct.error where it cannot be true."""

    def __init__(self, content: bytes) -> None:
        self.content, self.at = content, _WORD
        version = content[3]
        if version not in (1, 2, 5):
            raise ValueError(f"version {version}")
        self.count, self.place = ">q" if version == 5 else ">i", ">i" if version == 1 else ">q"

    def number(self, kind: str = "") -> int:
        (found,) = struct.unpack_from(kind or self.count, self.content, self.at)
        self.at += struct.calcsize(kind or self.count)
        return int(found)

    def size(self) -> int:
        size = self.number()
        if not 0 <= size <= len(self.content):
            raise ValueError(f"a length of {size}")
        return size

    def numbers(self, kind: str, count: int) -> Any:
        found = np.frombuffer(self.content, kind, count, self.at)
        self.at += -(-found.nbytes // _WORD) * _WORD
        return found

    def name(self) -> str:
        return str(self.numbers("S1", self.size()).tobytes().decode())

    def items(self, tag: int, read: Callable[[], Any]) -> list[Any]:
        told, count = self.number(">i"), self.size()
        if told != tag and (told or count):
            raise ValueError(f"a list of kind {told}")
        return [read() for _ in range(count)]

    def attribute(self) -> tuple[str, Any]:
        name, kind = self.name(), _KINDS[self.number(">i")]
        values = self.numbers(kind, self.size())
        return name, plain_attribute(values.tobytes() if kind == "S1" else values)

    def variable(self, dimensions: Sequence[tuple[str, int]]) -> _Placed:
        name, own = self.name(), tuple(dimensions[self.size()] for _ in range(self.size()))
        attributes, kind = dict(self.items(_ATTRIBUTE, self.attribute)), np.dtype(_KINDS[self.number(">i")])
        self.number()  # its size, which follows from the rest and overflows where it is large
        return _Placed(name, own, attributes, kind, self.number(self.place))


@dataclass(frozen=True)
class _Placed:
    """A variable of the header, its place in the file; the length of the record dimension is 0."""

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


def _classic(content: bytes, where: str) -> Group:
    header, size = _Header(content), len(content)
    records = header.number()
    dimensions = header.items(_DIMENSION, lambda: (header.name(), header.number()))
    attributes = dict(header.items(_ATTRIBUTE, header.attribute))
    variables = header.items(_VARIABLE, lambda: header.variable(dimensions))
    widths = [one.width for one in variables if one.is_record]
    step = widths[0] if len(widths) == 1 else sum(-(-width // _WORD) * _WORD for width in widths)
    first = min((one.begin for one in variables if one.is_record), default=size)
    if records == -1:  # written as a stream, whose end was not known
        records = (size - first) // max(step, 1)
    parts = sorted([(0, header.at), *((one.begin, one.begin + one.width) for one in variables)])
    if min(records, *(length for _, length in dimensions), 0) < 0 or any(
        begin < end for (_, end), (begin, _) in pairwise(parts)
    ):
        raise ValueError("variables lie over each other")
    end = max(first + records * step if widths else 0, *(end for _, end in parts))
    findings = surplus(end, size, where) if size - end >= _WORD else []
    return Group({one.name: _placed(one, content, records, step) for one in variables}, attributes, {}, tuple(findings))


def _placed(one: _Placed, content: bytes, records: int, step: int) -> Variable:
    shape = tuple(size for _, size in one.dimensions[one.is_record :])
    shape = (records, *shape) if one.is_record else shape
    apart = step if one.is_record and records != 1 else one.kind.itemsize
    room = max(0, len(content) - one.begin - one.kind.itemsize + apart) // max(apart, 1)
    held = min(max(shape, default=1), room)

    def raw(rows: int) -> Any:
        return np.ndarray(rows, one.kind, content, one.begin, (apart,))

    return Variable(tuple(name for name, _ in one.dimensions), shape, one.kind.kind, one.attributes, lambda: held, raw)
