"""MATLAB files: numeric vectors and matrices, version 5 (scipy) and 7.3 (HDF5)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.columns import Column, ColumnTable, parse_header
from jounce.core.errors import RecordingError, nearest
from jounce.core.types import Array
from jounce.recordings.readers.table import Reader, ReaderOptions, SignalTable

_WIDEST = 64


def read(path: Path, options: ReaderOptions) -> SignalTable:
    """Read every numeric vector as a column, and the columns of every matrix.

    Columns of a matrix ``x_F`` are named as in MATLAB: ``x_F(:,1)``, ``x_F(:,2)``, ... With ``options.header`` those of
    one matrix (``options.variable``, or the only one as wide as the header) get names and units. Variables of one
    length become columns: that of the matrix with a header, otherwise the most frequent one.
    """
    arrays = _arrays(path)
    heads = parse_header(options.header) if options.header else []
    chosen = _chosen(arrays, options.variable, len(heads), path)
    rows = arrays[chosen].shape[0] if chosen else _usual_length(arrays, path)
    columns = []
    for name, array in arrays.items():
        width = array.shape[1]
        if array.shape[0] == rows and (width <= _WIDEST or name == chosen):
            named = heads if heads and name == chosen else _matlab_names(name, width)
            columns += [
                Column(n, u, np.ascontiguousarray(v), str(path)) for (n, u), v in zip(named, array.T, strict=True)
            ]
    left_out = tuple(name for name, array in arrays.items() if not chosen and array.shape[0] not in (1, rows))
    return SignalTable(ColumnTable(tuple(columns), (), str(path)), left_out=left_out)


def _matlab_names(name: str, width: int) -> list[tuple[str, str]]:
    return [(name, "")] if width == 1 else [(f"{name}(:,{index})", "") for index in range(1, width + 1)]


def _usual_length(arrays: dict[str, Array], path: Path) -> int:
    lengths = [int(array.shape[0]) for array in arrays.values() if array.shape[0] > 1]
    if not lengths:
        raise RecordingError("no numeric variable with more than one row", where=str(path))
    return max(set(lengths), key=lambda length: (lengths.count(length), length))


def _chosen(arrays: dict[str, Array], variable: str, width: int, path: Path) -> str:
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


def _arrays(path: Path) -> dict[str, Array]:
    """Real numeric variables as (rows, columns); row vectors stand up."""
    from scipy.io import loadmat
    from scipy.io.matlab import MatReadError

    try:
        content: dict[str, Any] = loadmat(path)
    except NotImplementedError:
        content = _hdf5(path)
    except (MatReadError, ValueError, TypeError, OSError, IndexError, KeyError, EOFError) as error:
        raise RecordingError(f"not a MATLAB file ({error})", where=str(path)) from None
    return {name: array for name, value in content.items() if (array := _numeric(value)) is not None}


def _numeric(value: object) -> Array | None:
    if not isinstance(value, np.ndarray) or value.dtype.kind not in "fiu" or value.ndim != 2 or value.size == 0:
        return None
    array = np.asarray(value, dtype=float)
    return array.T if array.shape[0] == 1 else array


def _hdf5(path: Path) -> dict[str, Any]:
    """Numeric variables of a version 7.3 file; MATLAB stores columns first, so they come transposed."""
    import h5py

    content = {}
    with h5py.File(path, "r") as file:
        for name, item in file.items():
            if isinstance(item, h5py.Dataset) and item.attrs.get("MATLAB_class") not in (b"char", b"cell"):
                content[name] = np.asarray(item[()]).T
    return content


READER = Reader(
    name="mat",
    label="MATLAB file, version 5 or 7.3, numeric vectors and matrices",
    suffixes=(".mat",),
    read=read,
    source="MAT-File Format, The MathWorks",
    example="columns={'time': 'Tout [s]', 'strut.force': 'x_F(:,3) [N]'}",
)
