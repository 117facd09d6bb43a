"""Sweeps into files: netCDF for everything, CSV for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.serialise import check_writable, replacing, write_atomically
from jounce.recordings.files import SUFFIXES, storable

if TYPE_CHECKING:
    import xarray as xr


def check_sweep_file(path: Path | str, *, force: bool = False) -> Path:
    """Refuse, before the work, a file that could not be written after it; give the path."""
    return check_writable(path, what="sweeps", suffixes=SUFFIXES, force=force)


def write_sweep(sweep: xr.Dataset, path: Path | str, *, force: bool = False) -> Path:
    """Write a sweep to a file.

    Parameters
    ----------
    sweep : xarray.Dataset
        As :func:`sweep_travel` and its relatives give it.
    path : Path or str
        ``.nc`` for netCDF-4 with all attributes; ``.csv`` for one row a pose with ``name [unit]`` headers, SI.
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
    >>> import jounce as jn
    >>> sweep = jn.sweep_travel(jn.load("reference-double-wishbone"), [-0.04, 0.0, 0.04])
    >>> file = jn.write_sweep(sweep, pathlib.Path(tempfile.mkdtemp()) / "sweep.csv")
    >>> file.read_text(encoding="utf-8").splitlines()[0].startswith("wheel_travel [m], rack_travel [m]")
    True
    """
    file = check_sweep_file(path, force=force)
    if file.suffix.lower() == ".csv":
        return write_atomically(file, _csv_text(sweep), force=force)
    with replacing(file) as temporary:
        storable(_arrayed(sweep)).to_netcdf(temporary, engine="h5netcdf")
    return file


def _arrayed(sweep: xr.Dataset) -> xr.Dataset:
    """The same sweep with attributes that list numbers as arrays, which a file can hold."""
    listed = {str(key): value for key, value in sweep.attrs.items() if isinstance(value, (list, tuple))}
    numbers = {key: np.array(value) for key, value in listed.items() if all(isinstance(x, float) for x in value)}
    return sweep.assign_attrs(numbers)


def _csv_text(sweep: xr.Dataset) -> str:
    """One row a pose; values that do not exist (out of reach, at infinity) stay empty."""
    names = [*map(str, sweep.coords), *map(str, sweep.data_vars)]
    sizes = {str(name): size for name, size in sweep.sizes.items()}
    columns = [_on_grid(sweep[name].variable, sizes) for name in names]
    header = ", ".join(f"{name} [{sweep[name].attrs.get('units', '1')}]" for name in names)
    rows = (",".join(map(_number, row)) for row in zip(*columns, strict=True))
    return "\n".join([header, *rows]) + "\n"


def _on_grid(variable: Any, sizes: dict[str, int]) -> list[float]:
    return list(variable.set_dims(sizes).transpose(*sizes).values.ravel().tolist())


def _number(value: float) -> str:
    return repr(value) if np.isfinite(value) else ""
