"""netCDF-4 files as ``write_recording`` writes them, or others with a dimension ``time``."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import RecordingError
from jounce.recordings.readers.table import Reader, ReaderOptions, SignalTable, refuse_variable, renamed


def read(path: Path, options: ReaderOptions) -> SignalTable:
    """Read every variable over ``time`` with its ``units`` and ``long_name``."""
    import xarray as xr

    refuse_variable(path, options)
    try:
        with xr.open_dataset(path, engine="h5netcdf", decode_times=False, decode_timedelta=False) as file:
            dataset = file.load()
    except (OSError, ValueError, KeyError) as error:
        raise RecordingError(f"not a netCDF-4 file ({error})", where=str(path)) from None
    if "time" not in dataset.variables or dataset["time"].dims != ("time",):
        raise RecordingError("no time", where=str(path), allowed="a coordinate 'time' on a dimension 'time'")
    columns, long_names, left_out = [], {}, []
    for name, variable in dataset.variables.items():
        if variable.dims == ("time",) and variable.dtype.kind in "fiu":
            values = np.ascontiguousarray(variable.values, dtype=float)
            columns.append(Column(str(name), str(variable.attrs.get("units", "")), values, str(path)))
            long_names[str(name)] = str(variable.attrs.get("long_name", ""))
        else:
            left_out.append(str(name))
    attributes = {str(key): value for key, value in dataset.attrs.items()}
    table = renamed(ColumnTable(tuple(columns), (), str(path)), options.header)
    return SignalTable(table, long_names, attributes, tuple(left_out))


READER = Reader(
    name="netcdf",
    label="netCDF-4 recording",
    suffixes=(".nc", ".nc4"),
    read=read,
    source="netCDF-4, https://docs.unidata.ucar.edu/netcdf-c",
    example="run.nc written by jounce simulate --out run.nc",
)
