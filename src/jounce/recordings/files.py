"""Files into recordings in SI, and recordings into files."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.columns import Column, ColumnTable, name_and_unit
from jounce.core.errors import RecordingError, nearest
from jounce.core.files import existing_file
from jounce.core.findings import Finding
from jounce.core.serialise import Formats, to_plain
from jounce.core.types import Array
from jounce.core.units import conversion_factor, to_si
from jounce.recordings.quality import FEWEST_SAMPLES, check_channels, check_time
from jounce.recordings.readers import ReaderOptions, SignalTable, read_signals
from jounce.recordings.schema import channel_unit, quantity_of, recording

if TYPE_CHECKING:
    import xarray as xr

Columns = Mapping[str, str] | str | None


def read_recording(
    path: Path | str,
    *,
    columns: Columns = None,
    sample_time: float | str | None = None,
    variable: str = "",
) -> tuple[xr.Dataset, list[Finding]]:
    r"""Read a measured or simulated recording, whatever its format, units and column order.

    Parameters
    ----------
    path : Path or str
        File of a format in ``READERS``, chosen by its suffix.
    columns : mapping of str to str, or str, optional
        Where channels are in the file: jounce name to name of the column, with a unit where the file gives none, e.g.
        ``{"time": "t_ms [ms]", "sprung.az": "AccBody [g]"}``. Columns that are not mentioned are found by their own
        names. As one text: names and units of the file's columns (or of a matrix) in their order.
    sample_time : float or str, optional
        Constant step in s (or text with unit) of a file without time; replaces the file's time where there is one.
    variable : str
        Matrix variable (``.mat``) or group (``.tdms``) to read.

    Returns
    -------
    dataset : xarray.Dataset
        Channels in SI on uniform ``time`` (s).
    findings : list of Finding
        Columns that are no channel, resampling, constant and clipped channels.

    Raises
    ------
    RecordingError
        For a missing, unreadable or empty file, a missing column or unit, time that does not ascend or jitters, values
        that are not finite, or no channel at all.
    DescriptionError
        For a unit that does not fit the channel.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "pass.csv"
    >>> _ = file.write_text("t [ms], sprung.az [g]\n" + "\n".join(f"{i}, {i % 3}" for i in range(10)))
    >>> run, findings = read_recording(file, columns={"time": "t"})
    >>> float(run["sprung.az"].max()), float(run["time"][1]), findings
    (19.6133, 0.001, [])
    """
    file = Path(path)
    signals = _read_table(file, columns, variable)
    mapping = dict(columns) if isinstance(columns, Mapping) else {}
    located, findings = _locate_channels(signals, mapping, needs_time=sample_time is None)
    name_row, uneven = signals.columns.name_row, list[Finding]()
    if sample_time is None:
        recorded = in_si(located["time"], "s")
        time, uneven = check_time(recorded, where=str(file), name_row=name_row)
    else:
        step = to_si(sample_time, "s", where=f"{file}: sample time")
        rows = next(iter(located.values())).values.size
        if step <= 0.0:
            raise RecordingError("the sample time is not positive", where=str(file), found=f"{step:g} s")
        if rows < FEWEST_SAMPLES:
            allowed = f"at least {FEWEST_SAMPLES}"
            raise RecordingError("too few samples", where=str(file), found=str(rows), allowed=allowed)
        time = np.asarray(np.arange(rows) * step, dtype=float)
    units = {
        # a command is in the unit of its actuator, which only the file knows
        name: column.unit or "1" if quantity_of(name) == "command" else channel_unit(name)
        for name, column in located.items()
        if name != "time"
    }
    values = {name: in_si(located[name], unit) for name, unit in units.items()}
    findings += check_channels(values, where=str(file), name_row=name_row)
    if uneven:
        from scipy.interpolate import CubicSpline

        together = CubicSpline(recorded, np.stack(list(values.values()), axis=1))(time)
        values = {name: np.ascontiguousarray(column) for name, column in zip(values, together.T, strict=True)}
    channels = {
        name: (array, units[name], signals.long_names.get(located[name].name, "")) for name, array in values.items()
    }
    return recording(time, channels, attributes=signals.attributes), findings + uneven


def read_columns(
    path: Path | str, wanted: Mapping[str, str], *, columns: Columns = None, variable: str = ""
) -> tuple[dict[str, Array], list[Finding]]:
    r"""Read named columns from a file that need not have time, e.g. force against displacement.

    Parameters
    ----------
    path : Path or str
        File of a format in ``READERS``, chosen by its suffix.
    wanted : mapping of str to str
        Name and SI unit of each column needed, e.g. ``{"displacement": "m", "force": "N"}``.
    columns : mapping of str to str, or str, optional
        As in ``read_recording``.
    variable : str
        Matrix variable (``.mat``) or group (``.tdms``) to read.

    Returns
    -------
    values : dict of str to ndarray of shape (n,)
        Columns in SI, in the order of ``wanted``.
    findings : list of Finding
        Constant columns.

    Raises
    ------
    RecordingError
        For a missing, unreadable or empty file, a missing column or unit, or values that are not finite.
    DescriptionError
        For a unit that does not fit.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "spring.csv"
    >>> _ = file.write_text("F [kN]; displacement [mm]\n0; 0\n0.2273; 10\n")
    >>> values, _ = read_columns(file, {"displacement": "m", "force": "N"}, columns={"force": "F"})
    >>> values["force"].tolist()
    [0.0, 227.3]
    """
    file = Path(path)
    signals = _read_table(file, columns, variable)
    mapping = dict(columns) if isinstance(columns, Mapping) else {}
    for name in mapping:
        if name not in wanted:
            raise RecordingError(
                f"columns names {name!r}, which is not read here",
                where=str(file),
                allowed=", ".join(wanted),
                hint=nearest(name, wanted),
            )
    located = {name: locate(signals.columns, mapping.get(name, name)) for name in wanted}
    values = {name: in_si(column, wanted[name]) for name, column in located.items()}
    return values, check_channels(values, where=str(file), name_row=signals.columns.name_row, clipping=False)


def _read_table(path: Path, columns: Columns, variable: str) -> SignalTable:
    if existing_file(path, RecordingError).stat().st_size == 0:
        raise RecordingError("the file is empty", where=str(path))
    header = columns if isinstance(columns, str) else ""
    return read_signals(path, ReaderOptions(variable=variable, header=header))


def locate(table: ColumnTable, spec: str) -> Column:
    """Find the column ``"name"`` or ``"name [unit]"``; the given unit counts where the file has none."""
    for column in table:
        if spec in (column.label, column.name):
            return column
    name, unit = name_and_unit(spec)
    column = table[name]
    if unit and column.unit and unit != column.unit:
        raise RecordingError("the column has another unit", where=column.where, found=column.unit, allowed=unit)
    return Column(column.name, unit or column.unit, column.values, column.file)


def in_si(column: Column, si: str) -> Array:
    """Give a column in SI; text such as ``-`` or a missing unit is accepted for plain numbers."""
    if not column.unit and si != "1":
        raise RecordingError(
            "the column has no unit",
            where=column.where,
            allowed=f"{column.name} [{si}], or a unit that converts to it",
            hint=f"Write it into the header, or map it with columns: '{column.name} [{si}]'.",
        )
    factor = conversion_factor(column.unit, si, where=column.where) if column.unit else 1.0
    return np.asarray(column.values * factor, dtype=float)


def _locate_channels(
    signals: SignalTable, mapping: Mapping[str, str], *, needs_time: bool
) -> tuple[dict[str, Column], list[Finding]]:
    """Columns by channel: the mapped ones, then those whose own name is a channel's."""
    table, located = signals.columns, dict[str, Column]()
    for name, spec in mapping.items():
        channel_unit(name)
        located[name] = locate(table, spec)
    used = {column.name for column in located.values()}
    ignored = []
    for column in table:
        if column.name in used or column.name in located:
            continue
        if quantity_of(column.name):
            located[column.name] = column
        else:
            ignored.append(column.label)
    if needs_time and "time" not in located:
        raise RecordingError(
            "no column 'time'",
            where=table.file,
            found=", ".join(column.label for column in table),
            allowed="time [s], or any unit of time",
            hint=nearest("time", table.names) or "Map it with columns, or give the sample time.",
        )
    if not set(located) - {"time"}:
        raise RecordingError(
            "no channel was found",
            where=table.file,
            found=", ".join(column.label for column in table),
            allowed="columns such as 'sprung.az [m/s^2]'",
            hint="Map columns to channels with columns.",
        )
    findings = []
    if ignored:
        text = f"columns that are no known channel were left out: {', '.join(ignored)}; map them with columns if needed"
        findings.append(Finding(table.file, "note", text))
    if signals.left_out:
        text = f"signals of another length or at other instants were left out: {', '.join(signals.left_out)}"
        findings.append(Finding(table.file, "note", text))
    return located, findings


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
    return RECORDING_FILES.write(dataset, path, force=force)


def netcdf_of(dataset: xr.Dataset) -> bytes:
    """The content of a netCDF-4 file, made in memory: a disk that fills up while HDF5 writes to it ends the process."""
    return bytes(storable(dataset).to_netcdf(None, engine="h5netcdf"))


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


def _write_csv(dataset: xr.Dataset, file: Path) -> None:
    names = ["time", *(str(name) for name, variable in dataset.data_vars.items() if variable.dims == ("time",))]
    header = ", ".join(f"{name} [{dataset[name].attrs.get('units', '1')}]" for name in names)
    table = np.column_stack([dataset[name].values for name in names])
    rows = (",".join(map(repr, row)) for row in table.tolist())
    file.write_bytes(("\n".join([header, *rows]) + "\n").encode())


def _write_netcdf(dataset: xr.Dataset, file: Path) -> None:
    file.write_bytes(netcdf_of(dataset))


RECORDING_FILES = Formats("recordings", {".nc": _write_netcdf, ".csv": _write_csv})
"""File formats that recordings are written in."""
