"""Data with their own time and units: channels and recordings of xarray, tables of pandas and Polars."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.columns import Column, name_and_unit
from jounce.core.errors import RecordingError, value_or_kind
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.recordings.quality import check_time
from jounce.recordings.schema import channel_unit, is_spelling, quantity_of, recording_of

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


def recording(
    time: ArrayLike | pd.DataFrame,
    channels: Mapping[str, tuple[ArrayLike, str, str]] | None = None,
    *,
    attributes: Mapping[str, object] | None = None,
) -> xr.Dataset:
    """Create a recording from signals.

    Parameters
    ----------
    time : array_like, shape (n,), or DataFrame
        Time of the samples in s; or, as the only argument, a pandas or Polars table with columns ``name [unit]``,
        including ``time [s]`` as a column or index.
    channels : mapping of str to (array_like of shape (n,), str, str)
        Values in SI, SI unit, and label (empty: derived from the name) of each channel. Float arrays are not copied.
    attributes : mapping, optional
        Attributes of the whole recording.

    Returns
    -------
    xarray.Dataset
        One variable per channel with ``units``, ``long_name`` and ``place`` on the coordinate ``time`` (s).

    Raises
    ------
    RecordingError
        If a channel and ``time`` have different numbers of samples.

    Examples
    --------
    >>> run = recording([0.0, 0.001], {"sprung.az": ([0.0, 1.5], "m/s^2", "")})
    >>> run["sprung.az"].attrs["place"], run["sprung.az"].attrs["long_name"], float(run["sprung.az"].max())
    ('sprung', 'vertical acceleration, sprung', 1.5)
    """
    if channels is None:
        return as_recording(time).assign_attrs(attributes or {})
    return recording_of(time, channels, attributes)


def is_table(given: object) -> bool:
    """Whether an object is a table of pandas or Polars."""
    return hasattr(given, "columns") and hasattr(given, "to_numpy")


def as_recording(given: Any, *, where: str = "recording") -> xr.Dataset:
    """Return a recording; convert a channel, or a table with columns ``name [unit]``.

    A named index of a pandas table is treated as a column. Columns of known quantities are converted to SI; others keep
    their unit. Durations and timestamps of a recording are converted to seconds.

    >>> import pandas as pd
    >>> table = pd.DataFrame({"time [ms]": [0.0, 1.0], "strut.force [kN]": [0.2, 0.3]})
    >>> as_recording(table)["strut.force"].sel(time=0.001).item()
    300.0
    """
    import xarray as xr

    if isinstance(given, xr.Dataset):
        return _respell(given, where)
    if isinstance(given, xr.DataArray) and given.name is not None:
        return _respell(given.to_dataset(), where)
    if not is_table(given):
        raise RecordingError(
            Phrase("{given} is not a recording", given=value_or_kind(given)),
            where=where,
            allowed="an xarray.Dataset, or a table with columns 'name [unit]', including 'time [s]'",
            hint="jn.read_recording(...) reads a recording from a file, jn.recording(...) creates one from arrays.",
        )
    columns = table_columns(given, where)
    if "time" not in columns:
        labels = ", ".join(columns)
        raise RecordingError(
            "no column 'time'", where=where, found=labels, allowed="a column or index 'time [s]'"
        )
    time = columns.pop("time").in_si("s")
    channels = {}
    for name, column in columns.items():
        unit = (
            channel_unit(name) if quantity_of(name) not in ("", "command") else column.unit or "1"
        )
        channels[name] = (column.in_si(unit), unit, "")
    return recording_of(time, channels)


def _respell(run: xr.Dataset, where: str) -> xr.Dataset:
    """Convert durations and timestamps to seconds, and rewrite SI units in jounce's spelling."""
    if "time" in run.coords and run["time"].dtype.kind in "mM":
        seconds = as_samples(run["time"], "s", where=f"{where}: time")
        run = run.assign_coords(
            time=(run["time"].dims, seconds, {"units": "s", "long_name": "time"})
        )
    respelled = {}
    for name, variable in run.variables.items():
        if quantity_of(str(name)) in ("", "command"):
            continue
        unit, si = variable.attrs.get("units"), channel_unit(str(name))
        if unit != si and is_spelling(unit, si):
            respelled[name] = variable.dims, variable.values, {**variable.attrs, "units": si}
    return run.assign(respelled) if respelled else run


def table_columns(table: Any, where: str) -> dict[str, Column]:
    """Return the columns of a pandas or Polars table by name without unit; a named index comes first."""
    index = getattr(getattr(table, "index", None), "name", None)
    values_of = {} if index is None else {str(index): table.index}
    values_of |= {str(header): table[header] for header in table.columns}
    columns = {}
    for header, values in values_of.items():
        name, unit = name_and_unit(header)
        unit = "s" if np.asarray(values).dtype.kind in "mM" else unit
        columns[name] = Column(name, unit, as_samples(values, where=f"{where}: {header}"), where)
    return columns


def by_path(given: Any) -> Any:
    """Return the columns of a table by name, numbers as text with the header's unit; other objects unchanged.

    >>> import pandas as pd
    >>> by_path(pd.DataFrame({"strut.spring.rate [N/mm]": [25.0, 26.0]}))
    {'strut.spring.rate': ['25.0 N/mm', '26.0 N/mm']}
    """
    if not is_table(given):
        return given
    columns = {}
    for header in given.columns:
        (name, unit), values = name_and_unit(str(header)), given[header]
        texts = (
            [f"{value!r} {unit}" for value in as_samples(values, where=header).tolist()]
            if unit
            else []
        )
        columns[name] = texts or values
    return columns


def carries_time(given: object) -> bool:
    """Whether an object is a channel, a recording or a table with its own time."""
    return is_table(given) or "time" in getattr(given, "coords", ())


def clock_of(given: Sequence[Any], *, where: str) -> xr.DataArray:
    """Return the common time of channels; None in ``given`` denotes a missing channel.

    Raises
    ------
    RecordingError
        If none of them has a time, or their times differ.
    """
    times: list[xr.DataArray] = [
        channel["time"]
        for channel in given
        if hasattr(channel, "coords") and "time" in channel.coords
    ]
    if not times:
        raise _no_time(where)
    if any(not np.array_equal(time.values, times[0].values) for time in times[1:]):
        raise RecordingError(
            "the channels were recorded at different times",
            where=where,
            hint="Resample the channels.",
        )
    return times[0]


def rate_of_channels(given: Sequence[Any], *, where: str) -> float:
    """Return the common sample rate (Hz) of channels on uniform time."""
    time = as_samples(clock_of(given, where=where), "s", where=f"{where}: time")
    if check_time(time, where=where)[1]:
        raise RecordingError(
            "the time steps are not uniform", where=where, hint="Resample the recording first."
        )
    return (time.size - 1) / float(time[-1] - time[0])


def carried_channel(given: Any, unit: str, *, where: str) -> xr.DataArray:
    """Return a channel with its own time unchanged, or the only channel in a unit of a recording or table.

    >>> run = recording([0.0, 0.1], {"body.z": ([0.0, 1.0], "m", ""), "tyre.force": ([2.0, 3.0], "N", "")})
    >>> carried_channel(run, "m", where="decay").name
    'body.z'
    """
    import xarray as xr

    if not carries_time(given):
        raise _no_time(where)
    if isinstance(given, xr.DataArray):
        return given
    run = as_recording(given, where=where)
    names = [
        str(name) for name, channel in run.data_vars.items() if channel.attrs.get("units") == unit
    ]
    if len(names) == 1:
        return run[names[0]]
    raise _ambiguous(f"a channel in {unit}", names or run.data_vars, where, bool(names))


def damper_channels(
    run: xr.Dataset, *, where: str
) -> tuple[xr.DataArray, xr.DataArray | None, xr.DataArray]:
    """Return displacement, velocity (or None) and force of the only part with displacement and force in a recording.

    Parts that also have a velocity take precedence, e.g. a strut over a tyre.
    """
    places: dict[str, dict[str, str]] = {}
    units = {"m": "displacement", "m/s": "velocity", "N": "force"}
    for name, channel in run.data_vars.items():
        kind = units.get(channel.attrs.get("units", ""))
        if kind is not None and channel.dims == ("time",):
            place = places.setdefault(str(name).rpartition(".")[0], {})
            place[kind] = "" if kind in place else str(name)
    complete = {
        place: names
        for place, names in places.items()
        if names.get("displacement") and names.get("force")
    }
    candidates = {
        place: names for place, names in complete.items() if names.get("velocity")
    } or complete
    if len(candidates) != 1:
        what = "a displacement and a force of one place"
        raise _ambiguous(what, candidates or run.data_vars, where, bool(candidates))
    (names,) = candidates.values()
    velocity = names.get("velocity")
    return run[names["displacement"]], run[velocity] if velocity else None, run[names["force"]]


def _no_time(where: str) -> RecordingError:
    allowed = "an array of times in addition to the samples, or channels of a recording such as run['strut.force']"
    return RecordingError("the time is missing", where=where, allowed=allowed)


def _ambiguous(what: str, names: Iterable[Any], where: str, several: bool) -> RecordingError:
    return RecordingError(
        f"{'more than one has' if several else 'it has not'} {what}",
        where=where,
        found=", ".join(map(str, names)),
        hint="Select a channel, e.g. run['strut.deflection'].",
    )
