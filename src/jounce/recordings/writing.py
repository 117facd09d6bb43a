"""Recordings into files: netCDF for everything, CSV for other programs."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.serialise import check_writable, replacing, to_plain, write_atomically

if TYPE_CHECKING:
    import xarray as xr

SUFFIXES = (".nc", ".csv")


def write_recording(dataset: xr.Dataset, path: Path | str, *, force: bool = False) -> Path:
    """Write a recording so that ``read_recording`` gives it back.

    Parameters
    ----------
    dataset : xarray.Dataset
        A recording.
    path : Path or str
        ``.nc`` for netCDF-4 (all attributes), ``.csv`` for text with ``name [unit]`` headers (numbers in full).
    force : bool
        Overwrite an existing file.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    OutputError
        For an existing file without ``force``, a missing folder, or another suffix.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> from jounce.recordings import read_recording, recording
    >>> run = recording([i / 1000 for i in range(9)], {"tyre.force": ([200.0 + i for i in range(9)], "N", "")})
    >>> file = write_recording(run, pathlib.Path(tempfile.mkdtemp()) / "run.nc")
    >>> read_recording(file)[0].equals(run)
    True
    """
    file = check_recording_file(path, force=force)
    if file.suffix.lower() == ".csv":
        return write_atomically(file, _csv_text(dataset), force=force)
    with replacing(file) as temporary:
        storable(dataset).to_netcdf(temporary, engine="h5netcdf")
    return file


def check_recording_file(path: Path | str, *, force: bool = False) -> Path:
    """Refuse, before the work, a file that no recording could be written to; give the path."""
    return check_writable(path, what="recordings", suffixes=SUFFIXES, force=force)


def storable(dataset: xr.Dataset) -> xr.Dataset:
    """The same dataset with attributes a file can hold: what is neither text nor number becomes JSON text."""
    copy = dataset.copy(deep=False)
    copy.attrs = {str(key): _storable_attribute(value) for key, value in dataset.attrs.items()}
    for variable in copy.variables.values():
        variable.encoding.pop("source", None)
    return copy


def _storable_attribute(value: object) -> object:
    if isinstance(value, (str, int, float, np.ndarray, np.generic)) and not isinstance(value, (bool, np.bool_)):
        return value
    return json.dumps(to_plain(value), ensure_ascii=False)


def _csv_text(dataset: xr.Dataset) -> str:
    names = ["time", *(str(name) for name, variable in dataset.data_vars.items() if variable.dims == ("time",))]
    header = ", ".join(f"{name} [{dataset[name].attrs.get('units', '1')}]" for name in names)
    table = np.column_stack([dataset[name].values for name in names])
    rows = (",".join(map(repr, row)) for row in table.tolist())
    return "\n".join([header, *rows]) + "\n"
