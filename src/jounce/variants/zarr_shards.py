"""Shards of a sweep as a Zarr group, which other programs can open as one dataset.

Every variable is an array of version 2 of the `specification
<https://zarr-specs.readthedocs.io/en/latest/v2/v2.0.html>`_ with one chunk per shard: raw values that need no package
for writing and reading. A shard is valid once its record exists, which lists its chunks with their checksums.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import struct
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.serialise import to_json, to_plain
from jounce.core.types import Array
from jounce.core.writing import write_atomically

if TYPE_CHECKING:
    import xarray as xr

_GROUP, _ARRAY, _ATTRIBUTES, _ALL = ".zgroup", ".zarray", ".zattrs", ".zmetadata"
_DIMENSIONS = "_ARRAY_DIMENSIONS"  # name used by xarray
_TEXTS = [{"id": "vlen-utf8"}]


def checksum(content: bytes) -> str:
    """Return the checksum that detects damage of a file."""
    return hashlib.sha256(content).hexdigest()[:32]


def put(folder: Path, number: int, shard: xr.Dataset, count: int, size: int) -> bytes:
    """Write the chunks of a shard, and the group's metadata with the first shard; return the record of the chunks.

    ``count`` is the total number of variants, ``size`` that of a shard.
    """
    if not (folder / _ALL).is_file():
        _begin(folder, shard, count, size)
    chunks = {}
    for name, variable in shard.variables.items():
        along = "variant" in variable.dims
        key = f"{name}/{'.'.join([str(number if along else 0), *['0'] * (variable.ndim - 1)])}"
        content = _pack(variable.to_numpy(), size if along else None)
        write_atomically(folder / key, content, force=True)
        chunks[key] = checksum(content)
    record = {
        "rows": shard.sizes["variant"],
        "chunks": chunks,
        "coordinates": [str(name) for name in shard.coords],
        "attributes": to_plain(shard.attrs),
    }
    return f"{to_json(record)}\n".encode()


def take(folder: Path, record: bytes) -> xr.Dataset | None:
    """Read a shard by its record; None if a chunk is missing or damaged."""
    import xarray as xr

    about = json.loads(record)
    variables = {}
    for key, content in _whole_chunks(folder, about):
        if content is None:
            return None
        name = key.rpartition("/")[0]
        array, attributes = (_read(folder / name / file) for file in (_ARRAY, _ATTRIBUTES))
        dimensions = attributes.pop(_DIMENSIONS)
        values = _unpack(content, array)
        variables[name] = xr.Variable(
            dimensions, values[: about["rows"]] if "variant" in dimensions else values, attributes
        )
    coordinates = {name: variables.pop(name) for name in about["coordinates"]}
    return xr.Dataset(variables, coordinates, about["attributes"])


def is_whole(folder: Path, record: bytes) -> bool:
    """Whether every chunk of a shard is undamaged."""
    return all(content is not None for _, content in _whole_chunks(folder, json.loads(record)))


def describe(folder: Path, attributes: Mapping[str, Any]) -> None:
    """Write the group's attributes, and the consolidated metadata."""
    known = _read(folder / _ATTRIBUTES) if (folder / _ATTRIBUTES).is_file() else {}
    metadata = {
        **to_plain(dict(attributes)),
        **{key: text for key, text in known.items() if key == "coordinates"},
    }
    write_atomically(folder / _ATTRIBUTES, to_json(metadata), force=True)
    files = [
        folder / _GROUP,
        folder / _ATTRIBUTES,
        *sorted(folder.glob(f"*/{_ARRAY}")),
        *sorted(folder.glob(f"*/{_ATTRIBUTES}")),
    ]
    gathered = {file.relative_to(folder).as_posix(): _read(file) for file in files}
    write_atomically(
        folder / _ALL, to_json({"zarr_consolidated_format": 1, "metadata": gathered}), force=True
    )


def clear(folder: Path) -> None:
    """Remove the group of an earlier sweep and nothing else."""
    for file in folder.glob(f"*/{_ARRAY}"):
        shutil.rmtree(file.parent)
    for name in (_ALL, _GROUP, _ATTRIBUTES):
        (folder / name).unlink(missing_ok=True)


def _begin(folder: Path, shard: xr.Dataset, count: int, size: int) -> None:
    for name, variable in shard.variables.items():
        along = "variant" in variable.dims
        is_text = variable.dtype.kind not in "fiub"
        array = {
            "zarr_format": 2,
            "shape": [count, *variable.shape[1:]] if along else list(variable.shape),
            "chunks": [size, *variable.shape[1:]] if along else list(variable.shape),
            "dtype": "|O" if is_text else variable.dtype.newbyteorder("<").str,
            "fill_value": "NaN" if variable.dtype.kind == "f" else None,
            "filters": _TEXTS if is_text else None,
            "compressor": None,
            "order": "C",
        }
        (folder / str(name)).mkdir(exist_ok=True)
        write_atomically(folder / str(name) / _ARRAY, to_json(array), force=True)
        attributes = {**to_plain(variable.attrs), _DIMENSIONS: list(variable.dims)}
        write_atomically(folder / str(name) / _ATTRIBUTES, to_json(attributes), force=True)
    write_atomically(folder / _GROUP, to_json({"zarr_format": 2}), force=True)
    # variables that xarray reads as coordinates
    beside = [str(name) for name in shard.coords if name not in shard.dims]
    write_atomically(folder / _ATTRIBUTES, to_json({"coordinates": " ".join(beside)}), force=True)
    describe(folder, shard.attrs)


def _whole_chunks(folder: Path, about: Mapping[str, Any]) -> Iterator[tuple[str, bytes | None]]:
    for key, expected in about["chunks"].items():
        try:
            content = (folder / key).read_bytes()
        except OSError:
            content = b""
        yield key, content if checksum(content) == expected else None


def _read(file: Path) -> dict[str, Any]:
    result: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
    return result


def _pack(values: Array, size: int | None) -> bytes:
    """Pack a chunk with its full number of rows, even if the last shard has fewer."""
    missing = 0 if size is None else size - len(values)
    if values.dtype.kind in "fiub":
        filling = np.zeros((missing, *values.shape[1:]), dtype=values.dtype)
        whole = np.concatenate([values, filling]) if missing else values
        return np.ascontiguousarray(whole, dtype=values.dtype.newbyteorder("<")).tobytes()
    texts = [str(text).encode() for text in values.ravel()] + [b""] * (
        missing * int(np.prod(values.shape[1:]))
    )
    return struct.pack("<I", len(texts)) + b"".join(
        struct.pack("<I", len(text)) + text for text in texts
    )


def _unpack(content: bytes, array: Mapping[str, Any]) -> Array:
    shape = array["chunks"]
    if array["dtype"] != "|O":
        return np.frombuffer(content, array["dtype"]).reshape(shape).copy()
    texts, at = np.empty(struct.unpack_from("<I", content)[0], dtype=object), 4
    for i in range(len(texts)):
        (length,) = struct.unpack_from("<I", content, at)
        texts[i] = content[at + 4 : at + 4 + length].decode()
        at += 4 + length
    return texts.reshape(shape)
