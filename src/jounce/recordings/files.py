"""Read files as recordings in SI, and write recordings to files."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.columns import Column, ColumnTable, name_and_unit
from jounce.core.errors import DescriptionError, JounceError, RecordingError, nearest, value_or_kind
from jounce.core.files import existing_file
from jounce.core.findings import Finding, at_place, finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import conversion_factor, to_si
from jounce.core.writing import Formats
from jounce.recordings import isolated
from jounce.recordings.carried import as_recording
from jounce.recordings.clocks import by_clock, is_steady, lower_rate_finding, rate_of
from jounce.recordings.conditioning import condition, electrical_columns
from jounce.recordings.plausibility import implausible
from jounce.recordings.quality import (
    FEWEST_SAMPLES,
    LARGEST_JITTER,
    check_channels,
    check_instants,
    check_time,
)
from jounce.recordings.reader import ReaderOptions, SignalTable
from jounce.recordings.readers import is_read_in_child, read_signals
from jounce.recordings.schema import channel_unit, quantity_of, recording_of
from jounce.recordings.sensor_files import read_sensors
from jounce.recordings.signals import read_at, uniform_instants
from jounce.recordings.writers import RECORDING_FILES, rpc_of_recording

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from jounce.recordings.sensors import Sensor

Columns = Mapping[str, str] | str | None


def read_recording(
    path: Path | str,
    *,
    columns: Columns = None,
    sample_time: float | str | None = None,
    variable: str = "",
    resample: float | str | None = None,
    database: Path | str | None = None,
    sensors: Mapping[str, Sensor] | Path | str | None = None,
) -> tuple[xr.Dataset, list[Finding]]:
    r"""Read a measured or simulated recording, whatever its format, units and column order.

    Parameters
    ----------
    path : Path or str
        File of a format in ``READERS``, chosen by its suffix.
    columns : mapping of str to str, or str, optional
        Columns of channels in the file: jounce's name to the column's name, with a unit if the file gives none, e.g.
        ``{"time": "t_ms [ms]", "sprung.az": "AccBody [g]"}``. Other columns are recognised by their own names. A single
        string lists names and units of the file's columns (or of a matrix) in order.
    sample_time : float or str, optional
        Constant step in s (or text with unit) of a file without time; overrides the file's time.
    variable : str
        Matrix variable or struct (``.mat``) or group (``.tdms``, ``.nc``) to read.
    resample : float or str, optional
        Constant step in s (or text with unit) of the recording. Time may then be irregular, signals may have their own
        clocks (slow channels, bus messages), and samples may be missing. If the step is larger than that of the
        file, the signals are first low-pass filtered with zero phase at 0.4 of the new rate.
    database : Path or str, optional
        Database of bus messages (``.dbc``) used to decode the bus frames of an MDF file.
    sensors : mapping of str to Sensor, Path or str, optional
        Sensors by channel, or a file that describes them: columns in volts or counts are converted to the quantities of
        their channels. The file has tables ``[sensors."sprung.az"]`` (schema ``jounce.sensors/1``); a campaign or the
        settings of a laboratory are also accepted.

    Returns
    -------
    dataset : xarray.Dataset
        Channels in SI on the uniform ``time`` (s) of the fastest channel, limited to the interval that all channels
        cover. A channel of a lower rate is interpolated by a cubic spline; its attribute ``recorded_rate`` is its rate
        in Hz.
    findings : list of Finding
        Columns that are not channels, interpretations (decimal commas), lower rates and the frequencies up to which
        they are valid, time that only some channels cover, resampling with the largest gap, a sample time that
        contradicts the recorded time, and constant and clipped channels. Implausible magnitudes are reported as
        problems, with the likely unit.

    Raises
    ------
    RecordingError
        If the file is missing, unreadable or empty, a column or unit is missing, time does not increase or (without
        ``resample``) jitters, values are not finite, or no channel is found.
    DescriptionError
        If a unit does not fit the channel.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "pass.csv"
    >>> _ = file.write_text("t (ms); sprung.az (g)\n" + "\n".join(f"{i}; {i % 3},0" for i in range(10)))
    >>> run, findings = read_recording(file, columns={"time": "t"})
    >>> float(run["sprung.az"].max()), float(run["time"][1]), [finding.message for finding in findings]
    (19.6133, 0.001, ['decimal commas were read as decimal points'])
    """
    mapping = dict(columns) if isinstance(columns, Mapping) else {}
    return read_mapped(
        path,
        lambda _: mapping,
        columns=columns,
        sample_time=sample_time,
        variable=variable,
        resample=resample,
        database=database,
        sensors=sensors,
    )


def read_mapped(
    path: Path | str,
    choose: Callable[[SignalTable], Mapping[str, str]],
    *,
    columns: Columns = None,
    sample_time: float | str | None = None,
    variable: str = "",
    resample: float | str | None = None,
    database: Path | str | None = None,
    sensors: Mapping[str, Sensor] | Path | str | None = None,
) -> tuple[xr.Dataset, list[Finding]]:
    """Read a recording whose columns ``choose`` maps to channels, once it sees them; else as `read_recording`."""
    file = existing_file(path, RecordingError)
    if is_read_in_child(file):
        isolated.prepare()  # the child starts while this process imports xarray
        import xarray  # noqa: F401
    chains = read_sensors(sensors) if isinstance(sensors, str | Path) else sensors or {}
    signals = _read_table(file, columns, variable, database)
    mapping = {**electrical_columns(chains, signals.tables), **choose(signals)}
    new_step = _positive(resample, f"{file}: resample", "the step to resample to")
    given_step = _positive(sample_time, f"{file}: sample time", "the sample time")
    recorded = _own_time(signals, mapping) if given_step is not None else None
    has_own_time = False
    if given_step is None or not signals.others:
        gaps = new_step is not None
        signals, has_own_time = by_clock(
            signals, mapping.get("time", ""), given_step, bridges_gaps=gaps
        )
    if has_own_time:  # each table has its time, from the file or from the given step of the rows
        mapping.pop("time", None)
    main = _main_table(signals, mapping)
    has_clocks = given_step is None or has_own_time  # a given step belongs to one clock only
    tables = (
        _usable(signals, main, mapping, is_resampled=new_step is not None)
        if has_clocks
        else (main,)
    )
    located, findings = _locate_channels(signals, main, tables, mapping, has_step=not has_clocks)
    remarks = [
        at_place(str(file), item)
        for table in signals.tables
        for item in table.remarks
        if table in tables
    ]
    findings = [*signals.findings, *remarks, *findings]
    clocks = {
        table: table["time"] for table in tables if table is not main and "time" in table.names
    }
    if main not in clocks and "time" in main.names and "time" in located:
        clocks[main] = main["time"]
    if "time" in located:
        column, home = located.pop("time")
        clocks[home] = column
    rows = next((column.values.size for column, table in located.values() if table is main), 0)
    if given_step is not None:
        if rows < FEWEST_SAMPLES and not has_own_time:
            allowed = f"at least {FEWEST_SAMPLES}"
            raise RecordingError(
                "too few samples", where=str(file), found=str(rows), allowed=allowed
            )
        findings += _contradiction(
            recorded, given_step, rows if recorded is None else recorded.values.size, str(file)
        )
    if has_clocks:
        instants = {table: in_si(column, "s") for table, column in clocks.items()}
    else:
        assert given_step is not None
        instants = {main: np.asarray(np.arange(rows) * given_step, dtype=float)}
    units = {
        # a command has the unit of its actuator, which only the file gives
        name: column.unit or "1" if quantity_of(name) == "command" else channel_unit(name)
        for name, (column, _) in located.items()
    }
    values = {name: in_si(located[name][0], unit) for name, unit in units.items()}
    homes = {name: table for name, (_, table) in located.items()}
    for table in dict.fromkeys(homes.values()):
        own = {name: array for name, array in values.items() if homes[name] is table}
        if new_step is None and table in instants:
            check_instants(instants[table], where=str(file), name_row=table.name_row)
        findings += check_channels(own, where=str(file), name_row=table.name_row)
    measured = values
    if new_step is not None:
        time, values, uneven = _resample(instants, values, homes, new_step, str(file))
    else:
        time, values, uneven = _together(instants, values, homes, str(file))
    step = float(time[-1] - time[0]) / (time.size - 1)
    slower = _slower(instants, measured, homes, step, str(file))
    findings += uneven
    findings += [finding for finding, _, _ in slower]
    read_units = {
        name: column.unit for name, (column, _) in located.items() if quantity_of(name) != "command"
    }
    findings += implausible(
        {name: values[name] for name in read_units},
        step,
        where=str(file),
        written=read_units,
        headers={name: column.label for name, (column, _) in located.items()},
    )
    channels = {
        name: (array, units[name], signals.long_names.get(located[name][0].name, ""))
        for name, array in values.items()
    }
    rates = {name: rate for _, names, rate in slower for name in names}
    attributes = dict(signals.attributes)
    if given_step is not None and attributes.pop("beacons", None) is not None:
        attributes.pop("beacon_names", None)
        findings.append(finding("recordings.beacons_of_other_time", str(file)))
    if rates:
        attributes["recorded_rates"] = "; ".join(
            f"{name} {rate:g} Hz, between them a spline" for name, rate in rates.items()
        )
    run = recording_of(time, channels, attributes=attributes)
    for name, rate in rates.items():
        run[name].attrs["recorded_rate"] = rate
    if chains:
        run, more = condition(run, chains, where=str(file))
        findings += more
    run.encoding["source"] = str(file)
    return run, findings


def _own_time(signals: SignalTable, mapping: Mapping[str, str]) -> Column | None:
    """Return the file's own time, which a given step replaces; None if it is missing or unreadable."""
    try:
        return locate(_main_table(signals, mapping), mapping.get("time", "time"))
    except JounceError:
        return None


def _usable(
    signals: SignalTable, main: ColumnTable, mapping: Mapping[str, str], *, is_resampled: bool
) -> tuple[ColumnTable, ...]:
    """Select the tables whose channels can share one time; tables that are not mapped may shorten it only a little."""
    if is_resampled:
        return signals.tables
    usable = []
    for table in signals.tables:
        clock = next(
            (column for column in table if column.name == "time" and column.fault is None), None
        )
        if table is main or (clock is not None and clock.unit and is_steady(in_si(clock, "s"))):
            usable.append(table)
    named = [
        table
        for table in usable
        if any(_is_home(table, spec) for name, spec in mapping.items() if name != "time")
    ]
    own = mapping.get("time", "time")
    try:
        first = in_si(locate(main, own if _is_home(main, own) else "time"), "s")
    except JounceError:
        return tuple(usable)

    def is_harmless(table: ColumnTable) -> bool:
        time = in_si(table["time"], "s")
        cut = max(time[0] - first[0], first[-1] - time[-1])
        return bool(cut <= (1.0 / rate_of(time) if mapping else _MOST_CUT * (first[-1] - first[0])))

    return tuple(table for table in usable if table is main or table in named or is_harmless(table))


_MOST_CUT = 0.1
"""Fraction of the main clock's time that unmapped channels may cut off, e.g. by a late start."""


def _together(
    instants: Mapping[ColumnTable, Array],
    values: Mapping[str, Array],
    homes: Mapping[str, ColumnTable],
    file: str,
) -> tuple[Array, dict[str, Array], list[Finding]]:
    """Interpolate all signals on the fastest clock, over the interval that all of them cover."""
    used = list(dict.fromkeys(homes.values()))
    fastest = min(
        used,
        key=lambda table: (
            float(np.median(np.diff(instants[table]))) if instants[table].size > 1 else 0.0
        ),
    )
    time, findings = check_time(instants[fastest], where=file, name_row=fastest.name_row)
    rate = (time.size - 1) / float(time[-1] - time[0])
    span = float(time[0]), float(time[-1])
    first, last = (
        max(instants[table][0] for table in used),
        min(instants[table][-1] for table in used),
    )
    slack = 1e-6 / rate
    inside = (time >= first - slack) & (time <= last + slack)
    if np.count_nonzero(inside) < FEWEST_SAMPLES:
        raise RecordingError("the signals do not overlap in time", where=file)
    wanted, common = time[inside], dict[str, Array]()
    for table in used:
        names = [name for name in values if homes[name] is table]
        if table is fastest and not findings:
            is_whole = bool(inside.all())
            common |= {name: values[name] if is_whole else values[name][inside] for name in names}
            continue
        stacked = np.stack([values[name] for name in names], axis=1)
        stacked = read_at(instants[table], stacked, wanted, rate)
        common |= {
            name: np.ascontiguousarray(column)
            for name, column in zip(names, stacked.T, strict=True)
        }
    slowest = max(float(np.median(np.diff(instants[table]))) for table in used)
    cut = max(float(wanted[0]) - span[0], span[1] - float(wanted[-1]))
    if cut > slack:
        findings = [
            *findings,
            # Signals usually end within one sample of each other; a larger cut loses samples.
            finding(
                "recordings.all_recorded",
                f"{file}: time",
                cut,
                severity="warning" if cut > 1.5 * slowest else "note",
                first=wanted[0],
                last=wanted[-1],
                fastest_first=span[0],
                fastest_last=span[1],
            ),
        ]
    return wanted, {name: common[name] for name in values}, findings


def _slower(
    instants: Mapping[ColumnTable, Array],
    values: Mapping[str, Array],
    homes: Mapping[str, ColumnTable],
    step: float,
    file: str,
) -> list[tuple[Finding, list[str], float]]:
    """Find channels recorded at a lower rate than the recording's: return their finding, names and rate."""
    slower = []
    for table in dict.fromkeys(homes.values()):
        names = [name for name in values if homes[name] is table]
        if len(set(homes.values())) > 1 and step * rate_of(instants[table]) < 1.0 - LARGEST_JITTER:
            together = np.stack([values[name] for name in names], axis=1)
            finding = lower_rate_finding(names, instants[table], together, step, file)
            slower.append((finding, names, rate_of(instants[table])))
    return slower


def _positive(given: float | str | None, where: str, what: str) -> float | None:
    """Convert a step to s and check that it is positive; None if not given."""
    if given is None:
        return None
    step = to_si(given, "s", where=where)
    if step <= 0.0:
        raise RecordingError(
            Phrase("{what} is not positive", what=what),
            where=where.rpartition(": ")[0],
            found=f"{step:g} s",
        )
    if step < _SHORTEST_STEP:
        length, allowed = (
            f"{step:g} s",
            Phrase("{shortest_step:g} s or more", shortest_step=_SHORTEST_STEP),
        )
        raise RecordingError(
            Phrase("{what} is too short", what=what),
            where=where.rpartition(": ")[0],
            found=length,
            allowed=allowed,
        )
    return step


_SHORTEST_STEP = 1e-12  # s: shorter than the step of any logger


def _contradiction(recorded: Column | None, step: float, rows: int, file: str) -> list[Finding]:
    """Warn if a given sample time moves a sample by half a step or more from its recorded time."""
    try:
        time = in_si(recorded, "s") if recorded is not None else np.empty(0)
    except JounceError:  # unreadable time is the usual reason for a given step
        return []
    if time.size < 2:
        return []
    given, own = (rows - 1) * step, float(time[-1] - time[0])
    departure = float(np.abs(time - time[0] - np.arange(rows) * step).max())
    if departure < 0.5 * step:
        return []
    return [
        finding(
            "recordings.sample_time_contradicts",
            f"{file}: time",
            own,
            step=step,
            given=given,
            own=own,
            departure=departure,
        )
    ]


def _resample(
    instants: Mapping[ColumnTable, Array],
    values: Mapping[str, Array],
    homes: Mapping[str, ColumnTable],
    step: float,
    file: str,
) -> tuple[Array, dict[str, Array], list[Finding]]:
    """Interpolate all signals at uniform instants of their common interval, with a finding on the largest gap."""
    used = {table: time for table, time in instants.items() if table in homes.values()}
    for table, time in used.items():
        check_instants(time, where=file, name_row=table.name_row)
    first, last = max(time[0] for time in used.values()), min(time[-1] for time in used.values())
    if last < first:
        raise RecordingError("the signals do not overlap in time", where=file)
    wanted = uniform_instants(float(first), float(last), 1.0 / step)
    if wanted.size < FEWEST_SAMPLES:
        size, allowed = f"{wanted.size} in steps of {step:g} s", f"at least {FEWEST_SAMPLES}"
        raise RecordingError(
            "too few samples", where=f"{file}: resample", found=size, allowed=allowed
        )
    resampled: dict[str, Array] = {}
    notes = []
    for table, time in used.items():
        names = [name for name in values if homes[name] is table]
        stacked = read_at(
            time, np.stack([values[name] for name in names], axis=1), wanted, 1.0 / step
        )
        resampled |= {
            name: np.ascontiguousarray(column)
            for name, column in zip(names, stacked.T, strict=True)
        }
        notes.append(_gap_finding(time, wanted, step, names if len(used) > 1 else [], file))
    return wanted, {name: resampled[name] for name in values}, notes


def _gap_finding(time: Array, wanted: Array, step: float, names: list[str], file: str) -> Finding:
    gaps = np.diff(time)
    widest = int(np.argmax(gaps))
    gap, usual = float(gaps[widest]), float(np.median(gaps))
    is_limited = step * (1.0 - 1e-9) > usual
    code = {
        (False, False): "recordings.resampled",
        (False, True): "recordings.resampled_limited",
        (True, False): "recordings.resampled_of",
        (True, True): "recordings.resampled_limited_of",
    }[bool(names), is_limited]
    # a warning from three steps on: two samples missing in a row
    return finding(
        code,
        f"{file}: time",
        gap,
        severity="warning" if gap > 3.0 * max(step, usual) else "note",
        instants=wanted.size,
        step=step,
        limit=0.4 / step,
        names=", ".join(names),
        gap=gap,
        start=time[widest],
    )


def read_columns(
    path: Path | str,
    wanted: Mapping[str, str] | Sequence[Mapping[str, str]],
    *,
    columns: Columns = None,
    variable: str = "",
) -> tuple[dict[str, Array], list[Finding]]:
    r"""Read named columns from a file that may have no time, e.g. force against displacement.

    Parameters
    ----------
    path : Path or str
        File of a format in ``READERS``, chosen by its suffix.
    wanted : mapping of str to str, or sequence of such mappings
        Name and SI unit of each required column, e.g. ``{"displacement": "m", "force": "N"}``, or several alternative
        sets: the first set whose names are all in the file or in ``columns`` is read, otherwise the first.
    columns : mapping of str to str, or str, optional
        As in ``read_recording``.
    variable : str
        Matrix variable (``.mat``) or group (``.tdms``, ``.nc``) to read.

    Returns
    -------
    values : dict of str to ndarray of shape (n,)
        Columns in SI, in the order of ``wanted``.
    findings : list of Finding
        Interpretations (decimal commas) and constant columns; implausible magnitudes are reported as problems.

    Raises
    ------
    RecordingError
        If the file is missing, unreadable or empty, a column or unit is missing, or values are not finite.
    DescriptionError
        If a unit does not fit.

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
    sets = [wanted] if isinstance(wanted, Mapping) else list(wanted)
    complete = (
        names
        for names in sets
        if all(n in mapping or has_column(signals.columns, n) for n in names)
    )
    wanted = next(complete, sets[0])
    for name in mapping:
        if name not in wanted:
            allowed = [allowed_name for names in sets for allowed_name in names]
            raise RecordingError(
                Phrase("columns names {name!r}, which this reader does not use", name=name),
                where=str(file),
                allowed=", ".join(allowed),
                hint=nearest(name, allowed),
            )
    located = {name: locate(signals.columns, mapping.get(name, name)) for name in wanted}
    values = {name: in_si(column, wanted[name]) for name, column in located.items()}
    remarks = [at_place(str(file), item) for item in signals.columns.remarks]
    findings = check_channels(
        values, where=str(file), name_row=signals.columns.name_row, clipping=False
    )
    read_units = {name: column.unit for name, column in located.items() if quantity_of(name)}
    headers = {name: column.label for name, column in located.items()}
    known = {name: values[name] for name in read_units}
    magnitudes = implausible(known, None, where=str(file), written=read_units, headers=headers)
    return values, [*signals.findings, *remarks, *findings, *magnitudes]


def _read_table(
    path: Path, columns: Columns, variable: str, database: Path | str | None = None
) -> SignalTable:
    if not isinstance(columns, Mapping | str | None):
        allowed = "a mapping from channel names to columns, or all names in order as one string"
        raise RecordingError(
            Phrase("{columns} was given", columns=value_or_kind(columns)),
            where="columns",
            allowed=allowed,
        )
    if existing_file(path, RecordingError).stat().st_size == 0:
        raise RecordingError("the file is empty", where=str(path))
    header = columns if isinstance(columns, str) else ""
    return read_signals(path, ReaderOptions(variable, header, Path(database) if database else None))


def locate(table: ColumnTable, spec: str) -> Column:
    """Find the column ``"name"`` or ``"name [unit]"``; the given unit applies if the file has none."""
    if has_column(table, spec):
        return table[spec]
    name, unit = name_and_unit(spec)
    column = table[name]
    own = (
        "" if name in (column.written, column.label) else column.unit
    )  # the full header 'Force [N]', followed by a different unit
    if unit and own and unit != own:
        hint = Phrase(
            "If the header is wrong, give the name in full, followed by the right unit: '{label} [{unit}]'.",
            label=column.label,
            unit=unit,
        )
        raise RecordingError(
            "the column has a different unit",
            where=column.where,
            found=column.unit,
            allowed=unit,
            hint=hint,
        )
    return replace(column, unit=unit or column.unit)


def has_column(table: ColumnTable, spec: str) -> bool:
    """Whether the table has a column of that name, with or without its unit."""
    return any(spec in (column.label, column.name, column.written) for column in table)


def in_si(column: Column, si: str) -> Array:
    """Return a column in SI; a dimensionless column may have no unit, or text such as ``-``."""
    if not column.unit and si != "1":
        raise RecordingError(
            "the column has no unit",
            where=column.where,
            allowed=Phrase("{name} [{si}], or a unit that converts to it", name=column.name, si=si),
            hint=Phrase(
                "State the unit in the header, or map it with columns: '{name} [{si}]'.",
                name=column.name,
                si=si,
            ),
        )
    try:
        factor = conversion_factor(column.unit, si, where=column.where) if column.unit else 1.0
    except DescriptionError as error:
        override = f"--columns NAME='{column.label} [{si}]'"
        hint = f"{error.hint} If the header is wrong, state the right unit after it: {override}."
        raise DescriptionError(
            error.what, where=error.where, found=error.found, allowed=error.allowed, hint=hint
        ) from None
    return column.times(factor)


def _main_table(signals: SignalTable, mapping: Mapping[str, str]) -> ColumnTable:
    """Return the table with most of the requested columns, then with most channels."""

    def score(table: ColumnTable) -> tuple[int, int]:
        mapped = sum(_is_home(table, spec) for name, spec in mapping.items() if name != "time")
        return mapped, sum(
            bool(quantity_of(column.name)) and column.name != "time" for column in table
        )

    return max(signals.tables, key=score)


def _is_home(table: ColumnTable, spec: str) -> bool:
    return has_column(table, spec) or has_column(table, name_and_unit(spec)[0])


def _locate_channels(
    signals: SignalTable,
    main: ColumnTable,
    tables: Sequence[ColumnTable],
    mapping: Mapping[str, str],
    *,
    has_step: bool,
) -> tuple[dict[str, tuple[Column, ColumnTable]], list[Finding]]:
    """Find the column and table of each channel: mapped columns first, then columns with the names of channels."""
    located: dict[str, tuple[Column, ColumnTable]] = {}
    without = " and without a sample time" if has_step else ""
    for name, spec in mapping.items():
        channel_unit(name)
        home = next((table for table in (main, *signals.tables) if _is_home(table, spec)), main)
        if home not in tables:
            raise RecordingError(
                "the signal was recorded at instants different from the others",
                where=f"{main.file}: {name}",
                found=spec,
                hint=Phrase(
                    "Put them on a common time base with resample, e.g. '10 ms'{without}.",
                    without=without,
                ),
            )
        located[name] = locate(home, spec), home
    used = {(column.name, id(table)) for column, table in located.values()}
    ignored, duplicates = list[str](), list[str]()
    empty: list[Column] = []
    bare: list[Column] = []
    for table in tables:
        for column in table:
            if (column.name, id(table)) in used or column.name in located:
                if (
                    column.name != "time"
                    and located.get(column.name, (column, table))[1] is not table
                ):
                    duplicates.append(column.label)
                continue
            if column.name == "time" and (
                table is not main or (has_step and column.fault is not None)
            ):
                continue
            if not quantity_of(column.name):
                ignored.append(column.label)
            elif column.fault is not None and column.is_empty:
                empty.append(column)
            elif (
                not column.unit
                and channel_unit(column.name) not in ("1", "s")
                and column.fault is None
            ):
                bare.append(column)
            else:
                located[column.name] = table[column.name], table
    others = [
        column.label
        for table in signals.tables
        if table not in tables
        for column in table
        if column.name != "time"
    ]
    if not has_step and "time" not in located:
        if "time" in main.names:
            main["time"].readable()  # raises the reason
        raise RecordingError(
            "no column 'time'",
            where=main.file,
            found=", ".join(column.label for column in main),
            allowed="time [s], or any unit of time",
            hint=f"{nearest('time', main.names)} {_HOW_TIME}".strip(),
        )
    if not set(located) - {"time"}:
        for column in empty:
            column.readable()  # raises the reason
        for column in bare:
            in_si(column, channel_unit(column.name))  # raises: no unit
        raise RecordingError(
            "no channel was found",
            where=main.file,
            found=", ".join([column.label for column in main] + others),
            allowed="columns such as 'sprung.az [m/s^2]'",
            hint="Map columns to channels with columns, with their units: {'sprung.az': 'NAME [m/s^2]'}.",
        )
    findings = []
    if ignored:
        findings.append(finding("recordings.unknown_columns", main.file, names=", ".join(ignored)))
    if empty:
        labels = ", ".join(column.label for column in empty)
        findings.append(finding("recordings.without_numbers", main.file, labels=labels))
    if bare:
        labels = ", ".join(
            f"{column.name} = '{column.name} [{channel_unit(column.name)}]'" for column in bare
        )
        findings.append(finding("recordings.without_unit", main.file, labels=labels))
    written = {name.casefold() for name in located}
    if len(written) < len(located):
        same = [
            name
            for name in located
            if sum(name.casefold() == other.casefold() for other in located) > 1
        ]
        findings.append(finding("recordings.differ_by_case", main.file, names=", ".join(same)))
    if duplicates:
        findings.append(
            finding("recordings.at_other_instants", main.file, names=", ".join(duplicates))
        )
    if signals.left_out or others:
        code = "recordings.signals_left_out"
        if others:
            code = "recordings.resample_without" if has_step else "recordings.resample"
        findings.append(finding(code, main.file, names=", ".join([*signals.left_out, *others])))
    return located, findings


_HOW_TIME = "Map the time column with columns, {'time': 'NAME [s]'}, or give the sample time."


def write_recording(
    dataset: xr.Dataset | pd.DataFrame, path: Path | str, *, force: bool = False
) -> Path:
    """Write a recording to a file that ``read_recording`` reads back unchanged.

    Parameters
    ----------
    dataset : xarray.Dataset or pandas.DataFrame
        A recording, or a table with columns ``name [unit]``.
    path : Path or str
        ``.nc`` (netCDF-4), ``.mat`` (MATLAB), ``.mf4`` (MDF 4.10), ``.parquet`` and ``.xlsx`` (Excel) keep names,
        units, long names and attributes; the last three need the extra ``io``. ``.csv`` is text with ``name [unit]``
        headers and numbers in full precision. ``.rsp`` (RPC III) keeps names, units and numbers in single precision.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    OutputError
        If the file exists and ``force`` is not set, the folder is missing, the suffix is unknown, names collide
        (``.mat``) or do not fit the format, data are not numbers over time (except ``.nc``), or a sheet is too small.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> from jounce.recordings import read_recording, recording
    >>> run = recording([i / 1000 for i in range(9)], {"tyre.force": ([200.0 + i for i in range(9)], "N", "")})
    >>> file = write_recording(run, pathlib.Path(tempfile.mkdtemp()) / "run.nc")
    >>> read_recording(file)[0].equals(run)
    True
    """
    return RECORDING_FILES.write(as_recording(dataset), path, force=force)


def write_rpc(
    dataset: xr.Dataset | pd.DataFrame,
    path: Path | str,
    *,
    integers: bool = False,
    force: bool = False,
) -> dict[str, float]:
    """Write a recording as an RPC III time history (``.rsp``) for test rigs.

    Parameters
    ----------
    dataset : xarray.Dataset or pandas.DataFrame
        A recording with a constant time step, or a table with columns ``name [unit]``; up to 128 channels.
    path : Path or str
        File to write; its suffix must be ``.rsp``.
    integers : bool
        Store 16-bit integers with a scale per channel, as older RPC III programs expect; otherwise single precision.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    dict of str to float
        Largest rounding error of each channel, in its SI unit (that of the channel): for integers at most half of its
        largest magnitude / 32752, in single precision at most 6e-8 of the number.

    Raises
    ------
    OutputError
        If the file exists and ``force`` is not set, the time step is not constant, a number is not finite, a name is
        longer than 95 Latin letters, or there are more than 128 channels.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> from jounce.recordings import read_recording, recording
    >>> run = recording([i / 1000 for i in range(9)], {"tyre.force": ([200.0 + i for i in range(9)], "N", "")})
    >>> errors = write_rpc(run, pathlib.Path(tempfile.mkdtemp()) / "run.rsp", integers=True)
    >>> 0.0 < errors["tyre.force"] < 0.5 * 208.0 / 32752
    True
    """
    content, errors = rpc_of_recording(as_recording(dataset), integers=integers)
    formats = Formats("RPC III files", {".rsp": lambda data, file: file.write_bytes(data)})
    formats.write(content, path, force=force)
    return errors


def to_pandas(dataset: xr.Dataset) -> pd.DataFrame:
    """Convert a recording to a pandas data frame.

    Parameters
    ----------
    dataset : xarray.Dataset
        A recording, or any dataset over one dimension.

    Returns
    -------
    pandas.DataFrame
        Indexed by that dimension (``time [s]``), with one column for each channel, named with its SI unit as in CSV
        files. For a dataset of variants, the varied parameters come first.

    Raises
    ------
    RecordingError
        If the dataset has several dimensions.

    Examples
    --------
    >>> from jounce.recordings import recording
    >>> run = recording([0.0, 0.001], {"tyre.force": ([200.0, 201.0], "N", "")})
    >>> to_pandas(run)["tyre.force [N]"].tolist()
    [200.0, 201.0]
    """
    if len(dataset.dims) != 1:
        dimensions = ", ".join(map(str, dataset.dims)) or "none"
        raise RecordingError(
            "not a table",
            where="dataset",
            found=f"dimensions {dimensions}",
            allowed="one dimension",
        )
    (along,) = dataset.dims

    def heading(name: object) -> str:
        return f"{name} [{dataset[name].attrs.get('units', '1')}]"

    names = [
        name
        for name, data in {**dataset.coords, **dataset.data_vars}.items()
        if data.dims == (along,)
    ]
    table = dataset.reset_coords()[[name for name in names if name != along]]
    frame = table.to_dataframe().rename(columns={name: heading(name) for name in table.data_vars})
    frame.index.name = heading(along) if along in dataset.coords else str(along)
    return frame
