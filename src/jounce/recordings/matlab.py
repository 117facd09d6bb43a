"""Numeric data of MATLAB files: vectors and matrices, also inside structs and cells as test rigs and Simulink write."""

from __future__ import annotations

import io
import math
import struct
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.columns import name_and_unit
from jounce.core.errors import RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.process_settings import collect_warnings
from jounce.core.types import Array
from jounce.recordings.hdf5 import read_part

_VALUES = ("data", "values", "value", "signal", "samples", "y")
_NAMES = ("name", "label", "title", "signalname", "channel")
_UNITS = ("unit", "units")
_LISTS = (
    "names",
    "labels",
    "channels",
    "channelnames",
    "channel_names",
    "headers",
    "header",
    "columns",
    "signals",
)
_DEEPEST = 20  # levels of nested structs and cells; only damaged files nest deeper


@dataclass(frozen=True)
class Matrix:
    """A numeric variable, or a numeric field of structs and cells; rows are samples.

    ``path`` is its MATLAB expression; ``heads`` are the names and units of its columns (empty if the file has none).
    """

    path: str
    values: Array
    heads: tuple[tuple[str, str], ...] = ()

    @property
    def columns(self) -> list[tuple[str, str, str]]:
        """Name, unit and MATLAB expression of each column."""
        width = self.values.shape[1]
        own = (
            [self.path]
            if width == 1
            else [f"{self.path}(:,{index})" for index in range(1, width + 1)]
        )
        heads = self.heads or tuple((name, "") for name in own)
        return [(name, unit, path) for (name, unit), path in zip(heads, own, strict=True)]


def read_matrices(path: Path) -> tuple[dict[str, Matrix], list[str], list[Finding], dict[str, Any]]:
    """Read numeric matrices by MATLAB expression, names of unreadable data, findings, and texts by variable."""
    from scipy.io import loadmat

    findings: list[Finding] = []
    with path.open("rb") as stream:
        if stream.read(19).startswith((b"# Created by Octave", b"Octave-1-", b"\x89HDF")):
            hint = "Save the file with `save -v7 FILE.mat` in Octave, or `save FILE.mat -v7.3` in MATLAB."
            raise RecordingError(
                "a file in an Octave or HDF5 format, not a MATLAB file", where=str(path), hint=hint
            )
    try:
        with collect_warnings() as warnings:
            content: dict[str, Any] = loadmat(_inflate(path), simplify_cells=True)
        messages = (
            " ".join(str(warning.message).split(chr(10))[0].split()) for warning in warnings
        )
        findings += [
            finding("recordings.matlab_warning", str(path), error=text)
            for text in dict.fromkeys(messages)
        ]
    except NotImplementedError:  # version 7.3 is HDF5
        content = _content_of_hdf5(path, findings)
    plain = {name: value for name, value in content.items() if not name.startswith(("__", "#"))}
    matrices: dict[str, Matrix] = {}
    left_out: list[str] = []
    _walk("", plain, matrices, left_out, 0)
    texts = {
        name: value
        for name, value in plain.items()
        if _is_text(value) or isinstance(value, Mapping)
    }
    return matrices, left_out, findings, texts


_HEAD, _COMPRESSED = 128, 15  # bytes before the first variable, and type of compressed ones
_MOST_INFLATED = (
    4_000_000_000  # bytes: the numbers that a recording may have (hdf5._MOST), as doubles
)


def _inflate(path: Path) -> io.BytesIO:
    """Decompress the variables of a version 5 file and check their announced sizes; return other versions unchanged.

    scipy accepts a variable before reading its checksum, and reads the first variables of a truncated file.
    """
    content = path.read_bytes()
    order = {b"IM": "<", b"MI": ">"}.get(content[126:_HEAD])
    if order is None or content[124:126] not in (b"\0\1", b"\1\0"):
        return io.BytesIO(content)
    parts, at = [content[:_HEAD]], _HEAD
    while at < len(content):
        kind, size = struct.unpack(f"{order}II", content[at : at + 8].ljust(8, b"\0"))
        body = content[at + 8 : at + 8 + size]
        if len(body) < size or at + 8 > len(content):
            what = "the file was cut off within a variable"
            raise RecordingError(
                what,
                where=str(path),
                found=f"{len(body)} bytes",
                allowed=Phrase("{size} bytes", size=size),
            )
        variable = content[at : at + 8 + size]
        if kind == _COMPRESSED:
            inflater = zlib.decompressobj()
            variable = inflater.decompress(body, _MOST_INFLATED - sum(map(len, parts)))
            if not inflater.eof or inflater.unused_data:
                raise ValueError("a compressed variable does not end where it should")
        for inner, held in _elements(variable, order):
            if inner == _MATRIX:
                _check_matrix(held, order, 0)
        parts.append(variable)
        at += 8 + size
    return io.BytesIO(b"".join(parts))


_MATRIX, _CELL, _STRUCT, _OBJECT, _DOUBLE, _LAST = (
    14,
    1,
    2,
    3,
    6,
    15,
)  # types and classes of MAT-files of level 5
_SIZES = {1: 1, 2: 1, 3: 2, 4: 2, 5: 4, 6: 4, 7: 4, 9: 8, 12: 8, 13: 8}
"""Bytes per number, by stored type."""


def _elements(content: bytes | memoryview, order: str) -> Iterator[tuple[int, memoryview]]:
    """Yield type and content of consecutive data elements; raise ValueError if one is cut off."""
    view, at = memoryview(content), 0
    while at + 8 <= len(view):
        (kind,) = struct.unpack_from(f"{order}I", view, at)
        if kind >> 16:  # up to four bytes are stored in the tag itself
            kind, size, start, after = kind & 0xFFFF, kind >> 16, at + 4, at + 8
        else:
            (size,) = struct.unpack_from(f"{order}I", view, at + 4)
            start, after = at + 8, at + 8 + -(-size // 8) * 8
        if start + size > min(after, len(view)):
            raise ValueError("a part of a variable is cut off")
        yield kind, view[start : start + size]
        at = after


def _check_matrix(matrix: memoryview, order: str, depth: int) -> None:
    """Refuse a numeric matrix, also inside structs and cells, whose size differs from its announced dimensions."""
    parts = list(_elements(matrix, order))
    if len(parts) < 4 or depth > _DEEPEST or len(parts[0][1]) < 4:
        return
    kind = struct.unpack_from(f"{order}I", parts[0][1])[0] & 0xFF
    if kind in (_CELL, _STRUCT, _OBJECT):
        for inner, held in parts[3:]:
            if inner == _MATRIX:
                _check_matrix(held, order, depth + 1)
    elif _DOUBLE <= kind <= _LAST:
        stored, numbers = parts[3]
        announced = math.prod(struct.unpack(f"{order}{len(parts[1][1]) // 4}i", parts[1][1]))
        count = len(numbers) // _SIZES.get(stored, 8)
        if count != announced:
            raise ValueError(
                Phrase(
                    "a matrix declares {announced} numbers but contains {count}",
                    announced=announced,
                    count=count,
                )
            )


def _walk(
    path: str, value: Any, matrices: dict[str, Matrix], left_out: list[str], depth: int
) -> None:
    if depth > _DEEPEST:
        left_out.append(path)
    elif isinstance(value, dict):
        _walk_struct(path, value, matrices, left_out, depth)
    elif isinstance(value, list) or (isinstance(value, np.ndarray) and value.dtype == object):
        items = list(
            np.ravel(np.array(value, dtype=object)) if isinstance(value, np.ndarray) else value
        )
        marks = "()" if items and all(isinstance(item, dict) for item in items) else "{}"
        for index, item in enumerate(items, 1):
            _walk(f"{path}{marks[0]}{index}{marks[1]}", item, matrices, left_out, depth + 1)
    elif (values := _numbers(value)) is not None:
        matrices[path] = Matrix(path, values)
    elif not _is_text(value) and np.size(value):
        left_out.append(path)


def _walk_struct(
    path: str, struct: dict[str, Any], matrices: dict[str, Matrix], left_out: list[str], depth: int
) -> None:
    """Collect the fields of a struct (or the variables of the file): one signal with name and unit, or many."""
    before = f"{path}." if path else ""
    keys = {str(key).lower(): str(key) for key in struct}
    data = [keys[key] for key in _VALUES if key in keys and _numbers(struct[keys[key]]) is not None]
    name, unit = (_text_under(struct, keys, options) for options in (_NAMES, _UNITS))
    is_signal = path and len(data) == 1 and (name or unit)
    units = next((struct[keys[key]] for key in _UNITS if key in keys), None)
    for key, value in struct.items():
        at = f"{before}{key}"
        values = _numbers(value)
        if values is None:
            _walk(at, value, matrices, left_out, depth + 1)
        elif is_signal and key == data[0]:
            label, own = name_and_unit(name) if name else (path, "")
            width = values.shape[1]
            names = (
                [label] if width == 1 else [f"{label}(:,{index})" for index in range(1, width + 1)]
            )
            matrices[at] = Matrix(at, values, tuple((label_, unit or own) for label_ in names))
        else:
            matrices[at] = Matrix(at, values, _heads(str(key), at, values, struct, keys, units))


def _heads(
    key: str,
    path: str,
    values: Array,
    struct: Mapping[str, Any],
    keys: Mapping[str, str],
    units: Any,
) -> tuple[tuple[str, str], ...]:
    """Return names and units stored next to a matrix: a name for each column, and units by name or by column."""
    width = values.shape[1]
    lists = [list(map(str, np.ravel(np.array(struct[keys[name]])))) for name in _LISTS if name in keys
             and _is_texts(struct[keys[name]])]  # fmt: skip
    names = next((texts for texts in lists if len(texts) == width > 1), None)
    if isinstance(units, Mapping):
        own, names_of = (
            units.get(key),
            next((struct[keys[name]] for name in _LISTS if name in keys), None),
        )
        name = names_of.get(key) if isinstance(names_of, Mapping) else None
        return (
            ((str(name) if _is_text(name) else path, str(own)),)
            if width == 1 and _is_text(own) and str(own)
            else ()
        )
    by_column = list(map(str, np.ravel(np.array(units)))) if _is_texts(units) else []
    if names is None:
        return ()
    heads = [name_and_unit(name) for name in names]
    if len(by_column) == width:
        heads = [(name, unit or own) for (name, own), unit in zip(heads, by_column, strict=True)]
    return tuple(heads)


def _text_under(
    struct: Mapping[str, Any], keys: Mapping[str, str], options: tuple[str, ...]
) -> str:
    texts = (struct[keys[option]] for option in options if option in keys)
    return next((str(text).strip() for text in texts if _is_text(text) and str(text).strip()), "")


def _is_text(value: Any) -> bool:
    return isinstance(value, (str, np.str_)) or (
        isinstance(value, np.ndarray) and value.dtype.kind == "U"
    )


def _is_texts(value: Any) -> bool:
    items = value.ravel().tolist() if isinstance(value, np.ndarray) else value
    return (
        isinstance(items, list) and len(items) > 1 and all(isinstance(item, str) for item in items)
    )


def _numbers(value: Any) -> Array | None:
    """Return real numbers with shape (rows, columns), row vectors transposed; None for anything else."""
    if not isinstance(value, (np.ndarray, np.generic, int, float)) or isinstance(value, bool):
        return None
    array = np.asarray(value)
    if array.dtype.kind not in "fiu" or array.ndim > 2 or array.size == 0:
        return None
    numbers = np.asarray(array, dtype=float)
    if numbers.ndim == 2:
        return numbers.T if numbers.shape[0] == 1 else numbers
    return numbers.reshape(-1, 1)


def _content_of_hdf5(path: Path, findings: list[Finding]) -> dict[str, Any]:
    import h5py

    with h5py.File(path, "r") as file:
        return {
            name: _plain(item, file, findings, str(path), 0)
            for name, item in file.items()
            if not name.startswith("#")
        }


def _plain(item: Any, file: Any, findings: list[Finding], where: str, depth: int) -> Any:
    """Convert a struct, cell, text or array of a version 7.3 file to the form of older versions."""
    import h5py

    if depth > _DEEPEST or "MATLAB_object_decode" in item.attrs:
        return b"object"
    if isinstance(item, h5py.Group):
        fields = {
            name: _plain(field, file, findings, where, depth + 1) for name, field in item.items()
        }
        lists = [value for value in fields.values() if isinstance(value, _FieldOfStructs)]
        if (
            fields and len(lists) == len(fields) and len({len(value) for value in lists}) == 1
        ):  # an array of structs
            return [
                dict(zip(fields, row, strict=True)) for row in zip(*fields.values(), strict=True)
            ]
        return fields
    kind = item.attrs.get("MATLAB_class", b"")
    if item.attrs.get("MATLAB_empty", 0):
        return "" if kind == b"char" else np.empty(0)
    if kind == b"char":
        return (
            "".join(map(chr, np.asarray(item[()]).T.ravel(order="F").tolist()))
            if item.size < 10_000
            else ""
        )
    if item.dtype == h5py.ref_dtype:
        items = [
            _plain(file[ref], file, findings, where, depth + 1)
            for ref in np.asarray(item[()]).ravel()
            if ref
        ]
        return items if kind == b"cell" else _FieldOfStructs(items)
    values, finding = read_part(item, where)
    findings.extend(finding)
    return np.asarray(values).T  # MATLAB stores columns first


class _FieldOfStructs(list[Any]):
    """One field of an array of structs: a value for each element."""
