"""HDF5 (netCDF-4, MATLAB 7.3): what a file announces and never wrote comes back as zeros."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from jounce.core.errors import RecordingError
from jounce.core.findings import Finding
from jounce.core.types import Array

_MOST = 5e8


def held_rows(dataset: Any) -> tuple[int, int]:
    """The longest axis of an h5py dataset, and how many of its rows were written, apart from gaps within."""
    shape = dataset.shape
    axis = int(np.argmax(shape)) if shape else 0
    announced = int(shape[axis]) if shape else 1
    if dataset.chunks is None:
        written = dataset.id.get_storage_size()
        return axis, announced if written or dataset.nbytes == 0 else 0
    count = dataset.id.get_num_chunks()
    expected = math.prod(-(-size // chunk) for size, chunk in zip(shape, dataset.chunks, strict=True))
    if count >= expected:
        return axis, announced
    ends = [dataset.id.get_chunk_info(index).chunk_offset[axis] + dataset.chunks[axis] for index in range(count)]
    whole = expected // -(-announced // dataset.chunks[axis]) * -(-max(ends, default=0) // dataset.chunks[axis])
    if count < whole:
        raise RecordingError(
            "parts of the record were never written",
            where=f"{dataset.file.filename}: {dataset.name.lstrip('/')}",
            found=f"{count} of {expected} pieces",
        )
    return axis, min(announced, max(ends, default=0))


def held_part(dataset: Any, where: str) -> tuple[Array, list[Finding]]:
    """The numbers that were written, and a problem where the dataset announces more."""
    axis, held = held_rows(dataset)
    findings = announcement(dataset.name.lstrip("/"), dataset.shape[axis], held, where) if dataset.shape else []
    across = math.prod(dataset.shape) // max(1, dataset.shape[axis] if dataset.shape else 1)
    check_size(held * across, f"{where}: {dataset.name.lstrip('/')}")
    if not findings:
        return np.asarray(dataset[()]), []
    return np.asarray(dataset[tuple(slice(held) if i == axis else slice(None) for i in range(dataset.ndim))]), findings


def check_size(numbers: int, where: str) -> None:
    """Refuse more numbers than a recording can have."""
    if numbers > _MOST:
        raise RecordingError("too many numbers", where=where, found=f"{numbers}", allowed=f"up to {_MOST:g}")


def announcement(name: str, announced: int, held: int, where: str, *, refused: bool = True) -> list[Finding]:
    """A problem where a file announces more samples than it holds; where it holds none an error, if ``refused``."""
    if held >= announced:
        return []
    text = f"the file announces {announced} samples and holds {held}: it was cut off; what is there was read"
    if held == 0 and refused:
        raise RecordingError(
            "the file holds none of the samples that it announces", where=f"{where}: {name}", found=f"0 of {announced}"
        )
    return [Finding(f"{where}: {name}", "problem", text, float(held))]
