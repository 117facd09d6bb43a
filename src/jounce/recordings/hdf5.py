"""HDF5 (netCDF-4, MATLAB 7.3): detect samples that a file announces but never wrote (they would read as zeros)."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np

from jounce.core.errors import RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array

_MOST = 5e8  # numbers, 4 GB as doubles: more do not fit a common computer


def rows_on_disk(dataset: Any) -> tuple[int, int]:
    """Return the longest axis of an h5py dataset and the number of rows written along it."""
    _check_kind(dataset)
    shape = dataset.shape
    axis = int(np.argmax(shape)) if shape else 0
    announced = int(shape[axis]) if shape else 1
    if dataset.chunks is None:
        written = dataset.id.get_storage_size()
        return axis, announced if written or dataset.nbytes == 0 else 0
    expected = math.prod(
        -(-size // chunk) for size, chunk in zip(shape, dataset.chunks, strict=True)
    )
    chunks: list[Any] = []
    dataset.id.chunk_iter(chunks.append)
    ends = [
        piece.chunk_offset[axis] + dataset.chunks[axis]
        for piece in chunks
        if _is_readable(dataset, piece)
    ]
    count = len(ends)
    if count >= expected:
        return axis, announced
    whole = (
        expected
        // -(-announced // dataset.chunks[axis])
        * -(-max(ends, default=0) // dataset.chunks[axis])
    )
    if count < whole:
        raise RecordingError(
            "some parts of the record were never written",
            where=f"{dataset.file.filename}: {dataset.name.lstrip('/')}",
            found=f"{count} of {expected} pieces",
        )
    return axis, min(announced, max(ends, default=0))


def _is_readable(dataset: Any, piece: Any) -> bool:
    """Whether a listed chunk has an address and can be read from there: damage can hide it."""
    if piece.byte_offset is None:
        return False
    try:
        return bool(dataset.id.read_direct_chunk(piece.chunk_offset)[1])
    except (OSError, RuntimeError):
        return False


def _check_kind(dataset: Any) -> None:
    """Refuse external data, and number types that no program writes: one damaged bit changes the type of all."""
    import h5py

    where = f"{dataset.file.filename}: {dataset.name.lstrip('/')}"
    if dataset.external or dataset.is_virtual:
        hint = "Copy the data into this file, e.g. with h5repack."
        raise RecordingError("the data are stored in other files", where=where, hint=hint)
    kind = dataset.id.get_type()
    if isinstance(kind, (h5py.h5t.TypeFloatID, h5py.h5t.TypeIntegerID)) and not any(
        kind == known for known in _readable_kinds()
    ):
        what = "an impossible number type: the file is damaged"
        allowed = "integers of up to 8 bytes, floating-point numbers of 2, 4 or 8"
        raise RecordingError(what, where=where, allowed=allowed, hint="Use an undamaged copy.")


@cache
def _readable_kinds() -> tuple[Any, ...]:
    from h5py import h5t

    kinds = (("IEEE_F", (16, 32, 64)), ("STD_I", (8, 16, 32, 64)), ("STD_U", (8, 16, 32, 64)))
    names = [
        f"{kind}{bits}{end}" for kind, sizes in kinds for bits in sizes for end in ("LE", "BE")
    ]
    return *(getattr(h5t, name) for name in names), h5t.NATIVE_LDOUBLE


def read_part(dataset: Any, where: str) -> tuple[Array, list[Finding]]:
    """Read the written part, with a problem if the dataset announces more."""
    axis, held = rows_on_disk(dataset)
    findings = (
        announcement(dataset.name.lstrip("/"), dataset.shape[axis], held, where)
        if dataset.shape
        else []
    )
    across = math.prod(dataset.shape) // max(1, dataset.shape[axis] if dataset.shape else 1)
    check_size(held * across, f"{where}: {dataset.name.lstrip('/')}")
    if not findings:
        return np.asarray(dataset[()]), []
    return np.asarray(
        dataset[tuple(slice(held) if i == axis else slice(None) for i in range(dataset.ndim))]
    ), findings


def check_size(numbers: int, where: str) -> None:
    """Refuse more numbers than a recording can have."""
    if numbers > _MOST:
        raise RecordingError(
            "too many numbers",
            where=where,
            found=f"{numbers}",
            allowed=Phrase("up to {most:g}", most=_MOST),
        )


def announcement(
    name: str, announced: int, held: int, where: str, *, refused: bool = True
) -> list[Finding]:
    """Report a problem if a file holds fewer samples than announced; raise if it holds none and ``refused``."""
    if held >= announced:
        return []
    if held == 0 and refused:
        raise RecordingError(
            "the file contains none of the samples that it declares",
            where=f"{where}: {name}",
            found=f"0 of {announced}",
        )
    return [finding("recordings.cut_off", f"{where}: {name}", held, announced=announced, held=held)]


def surplus(known: int, present: int, where: str) -> list[Finding]:
    """Warn if a file has more bytes than its parts account for."""
    if known >= present:
        return []
    return [finding("recordings.bytes_left", where, present - known, known=known, held=present)]
