"""Consistency of Parquet files: their row counts, and the end of the data according to their footer."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from jounce.core.errors import RecordingError
from jounce.core.findings import Finding
from jounce.core.phrases import Phrase
from jounce.recordings.hdf5 import surplus

_END = 8  # bytes after the footer: its length, and the magic number
_LONGEST_FOOTER = 5_000_000  # bytes; a longer footer would take seconds to parse


def check_counts(metadata: Any, path: Path) -> None:
    """Refuse a Parquet file whose row counts contradict each other."""
    groups = [metadata.row_group(i) for i in range(metadata.num_row_groups)]
    flat = [
        i
        for i in range(metadata.num_columns)
        if metadata.schema.column(i).max_repetition_level == 0
    ]
    counts = [sum(group.num_rows for group in groups)]
    counts += [sum(group.column(i).num_values for group in groups) for i in flat]
    if any(count != metadata.num_rows for count in counts) or any(
        group.column(i).num_values != group.num_rows for group in groups for i in flat
    ):
        what = "the file states different numbers of rows in different places: it is damaged"
        listed = ", ".join(map(str, sorted({metadata.num_rows, *counts})))
        raise RecordingError(what, where=str(path), found=listed, hint="Use an undamaged copy.")


def check_end(metadata: Any, path: Path) -> list[Finding]:
    """Warn if the footer does not directly follow the data, because bytes were added or removed.

    Filters, indexes and padding may occur between columns. Any change of the file's length moves its end.
    """
    size = path.stat().st_size
    start = size - _END - metadata.serialized_size
    groups = [metadata.row_group(i) for i in range(metadata.num_row_groups)]
    chunks = [group.column(i) for group in groups for i in range(group.num_columns)]
    if (
        sum(chunk.total_compressed_size for chunk in chunks) == start - 4
        or metadata.serialized_size > _LONGEST_FOOTER
    ):
        return []
    content = path.read_bytes()
    footer, _ = _struct(content, start, 0)
    last = max(_ends(content, footer), default=start)
    if last > start:
        what = Phrase(
            "according to its footer, the last {last} bytes of the file contain data: the file is damaged",
            last=last - start,
        )
        raise RecordingError(what, where=str(path), hint="Use an undamaged copy.")
    return surplus(last, start, str(path))


_FILE_OFFSET, _META, _OFFSET_INDEX, _COLUMN_INDEX = (
    2,
    3,
    4,
    6,
)  # fields of a column in a group of rows
_COMPRESSED, _PAGES, _DICTIONARY, _FILTER = 7, 9, 11, 14  # fields of a column's metadata


def _ends(content: bytes, footer: dict[int, Any]) -> Iterator[int]:
    """Yield the end of each part of the file listed in the footer."""
    for chunk in (chunk for group in footer[4] for chunk in group[1]):
        about = chunk[_META]
        end = min(about[_PAGES], about.get(_DICTIONARY) or about[_PAGES]) + about[_COMPRESSED]
        yield end
        if chunk.get(_FILE_OFFSET) == end:  # a copy of the column's metadata
            again, behind = _struct(content, end, 0)
            if about in (again, again.get(_META)):
                yield behind
        for index in (_OFFSET_INDEX, _COLUMN_INDEX):
            if index in chunk:
                yield chunk[index] + chunk[index + 1]
        if _FILTER in about:
            head, behind = _struct(content, about[_FILTER], 0)
            yield behind + head[1]


# --- Thrift's compact protocol, the encoding of Parquet's metadata


_TRUE, _FALSE, _BYTE, _DOUBLE, _TEXT, _LIST, _SET, _MAP, _STRUCT = (
    1,
    2,
    3,
    7,
    8,
    9,
    10,
    11,
    12,
)  # its types
_DEEPEST = 20  # levels of nested structs; only damaged files nest deeper


def _struct(content: bytes, at: int, depth: int) -> tuple[dict[int, Any], int]:
    """Parse the fields of a struct by number; also return the offset of its end."""
    if depth > _DEEPEST:
        raise ValueError("structs are nested too deeply")
    fields: dict[int, Any] = {}
    field = 0
    while head := content[at]:
        at += 1
        step, kind = head >> 4, head & 15
        if not step:
            field, at = _number(content, at)
        field += step
        if kind in (_TRUE, _FALSE):
            fields[field] = kind == _TRUE
        else:
            fields[field], at = _value(content, at, kind, depth)
    return fields, at + 1


def _value(content: bytes, at: int, kind: int, depth: int) -> tuple[Any, int]:
    if kind == _STRUCT:
        return _struct(content, at, depth + 1)
    if kind in (_LIST, _SET):
        size, inner = content[at] >> 4, content[at] & 15
        size, at = _varint(content, at + 1) if size == 15 else (size, at + 1)
        items = []
        for _ in range(size):
            item, at = _value(content, at, _BYTE if inner == _FALSE else inner, depth + 1)
            items.append(item)
        return items, at
    if kind == _TEXT:
        size, at = _varint(content, at)
        return None, at + size
    if kind == _DOUBLE:
        return struct.unpack_from("<d", content, at)[0], at + 8
    if kind in (_TRUE, _BYTE):
        return content[at], at + 1
    if kind == _MAP or kind > _STRUCT:
        raise ValueError("nothing that Parquet has")
    return _number(content, at)


def _varint(content: bytes, at: int) -> tuple[int, int]:
    value = shift = 0
    while (byte := content[at]) & 128:
        value, shift, at = value | (byte & 127) << shift, shift + 7, at + 1
    return value | byte << shift, at + 1


def _number(content: bytes, at: int) -> tuple[int, int]:
    value, at = _varint(content, at)
    return value >> 1 ^ -(value & 1), at
