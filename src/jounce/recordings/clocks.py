"""Tables whose channels are sampled at different rates: split into one table per clock.

Loggers write slower channels with blank cells between their samples, or give each group of channels its own time
column. The tables are split as in formats with groups (MDF, TDMS).
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.columns import Column, ColumnTable, name_and_unit, names_time
from jounce.core.errors import JounceError
from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.core.units import conversion_factor
from jounce.recordings.quality import FEWEST_SAMPLES
from jounce.recordings.reader import SignalTable

_GAP = 1.5  # usual steps; between one step (jitter) and two (a missing sample)

Rows = NDArray[np.intp]


def by_clock(
    signals: SignalTable, time: str, step: float | None, *, bridges_gaps: bool
) -> tuple[SignalTable, bool]:
    """Split the tables of a file by clock; also return whether every table now has the column ``time``.

    ``time`` is the user's name of the time column (may be empty), ``step`` (s) the given step of rows without time.
    Channels with gaps remain in their table, with a fault, unless the gaps are bridged later.
    """
    first = _of_table(signals.columns, time, step, bridges_gaps)
    others = [part for table in signals.others for part in _of_table(table, "", None, bridges_gaps)]
    has_time = first[0] is not signals.columns and "time" in first[0].names
    return replace(signals, columns=first[0], others=(*first[1:], *others)), has_time


def is_steady(instants: Array) -> bool:
    """Whether instants (s) form a clock without gaps: enough of them, and no step much larger than the median."""
    if instants.size < FEWEST_SAMPLES or not np.isfinite(instants).all():
        return False
    steps = np.diff(instants)
    return bool(steps.min() > 0.0 and steps.max() <= _GAP * float(np.median(steps)))


def rate_of(instants: Array) -> float:
    """Return the median rate of a clock in Hz.

    >>> rate_of(np.arange(9) * 0.01)
    100.0
    """
    return round(1.0 / float(np.median(np.diff(instants))), 9)


@dataclass(frozen=True)
class _Clock:
    """Rows with a timestamp, their instants in s, and the index of the time column (-1 for a given step)."""

    rows: Rows
    instants: Array
    place: int


def _of_table(
    table: ColumnTable, time: str, step: float | None, bridges_gaps: bool
) -> list[ColumnTable]:
    count = max((column.values.size for column in table), default=0)
    count = max(
        [count, *(int(column.part[0][-1]) + 1 for column in table if column.part is not None)]
    )
    if step is not None:
        if not any(_gappy(column) for column in table):
            return [table]
        channels = tuple(column for column in table if column.name != "time")
        clock = _Clock(np.arange(count), np.asarray(np.arange(count) * step, dtype=float), -1)
        table = replace(table, columns=(Column("time", "s", clock.instants, table.file), *channels))
        clocks = {0: clock}
    else:
        clocks = dict(_clocks(table, time, count))
    if not clocks or (len(clocks) == 1 and not any(_gappy(column) for column in table)):
        return [_with_time(table, clocks, time)]
    homes = _homes(table, clocks)
    tables: list[ColumnTable] = []
    for place, clock in clocks.items():
        members = [
            column for at, column in enumerate(table) if homes[at] == place and at not in clocks
        ]
        tables += _of_group(table, clocks, clock, members, count, time, bridges_gaps)
    return tables


def _with_time(table: ColumnTable, clocks: Mapping[int, _Clock], time: str) -> ColumnTable:
    """Name the only clock of a table ``time``, unless the user named the time column."""
    if len(clocks) != 1 or time or "time" in table.names:
        return table
    (place,) = clocks
    columns, own = list(table.columns), table.columns[place]
    columns[place] = replace(own, name="time", written=own.written or own.label)
    return replace(
        table,
        columns=tuple(columns),
        remarks=(*table.remarks, finding("recordings.taken_for_time", table.file, name=own.label)),
    )


def _gappy(column: Column) -> bool:
    return _rows_of(column) is not None


def _rows_of(column: Column) -> tuple[Rows, Array] | None:
    """Return rows and values of a column with blank cells; None if there are no blank or some invalid cells."""
    if column.part is not None or column.fault is not None:
        return column.part
    missing = np.isnan(column.values)
    if not missing.any() or missing.all():
        return None
    rows = np.flatnonzero(~missing)
    return rows, column.values[rows]


def _clocks(table: ColumnTable, time: str, count: int) -> Iterator[tuple[int, _Clock]]:
    """Yield the time columns that are followed by channels, by index."""
    wanted = (time, name_and_unit(time)[0]) if time else ("time",)
    clocks: list[tuple[int, _Clock]] = []
    for place, column in enumerate(table):
        is_named = _is_called(column, wanted)
        if is_named or names_time(column.name):
            clock = _clock(column, place, count, unit=name_and_unit(time)[1] if is_named else "")
            if clock is not None:
                clocks.append((place, clock))
    named = [item for item in clocks if _is_called(table.columns[item[0]], wanted)]
    preferred = (named if len(named) == 1 else clocks)[:1]
    distinct = list(preferred)
    for place, clock in clocks:
        alike = [_is_named_alike(table, place, before) for before, _ in distinct]
        if all(
            _is_other(clock, before, is_named=alike[i]) for i, (_, before) in enumerate(distinct)
        ):
            distinct.append((place, clock))
    distinct.sort(key=lambda item: item[0])
    ends = [place for place, _ in [*distinct, (len(table), None)]][1:]
    for (place, clock), end in zip(distinct, ends, strict=True):
        if end - place > 1 or len(distinct) == 1:
            yield place, clock


def _is_called(column: Column, names: Sequence[str]) -> bool:
    return any(name and name in (column.name, column.label, column.written) for name in names)


def _clock(column: Column, place: int, count: int, unit: str) -> _Clock | None:
    """Return the column as a clock if its timestamps start in the first row, have no gaps, and increase."""
    part = _rows_of(column)
    if part is None and column.fault is not None:
        return None
    rows, stamps = (np.arange(count), column.values) if part is None else part
    try:
        factor = conversion_factor(column.unit or unit, "s")
    except JounceError:
        return None
    if unit and column.unit and unit != column.unit:  # refused later, where the column is read
        return None
    if (
        stamps.size < 2
        or rows.size != stamps.size
        or rows[-1] != rows.size - 1
        or not np.all(np.diff(stamps) > 0.0)
    ):
        return None
    return _Clock(rows, np.asarray(stamps * factor, dtype=float), place)


def _is_named_alike(table: ColumnTable, place: int, first: int) -> bool:
    """Whether two time columns have similar names (``Time 1``, ``Time 2``), or one is named after its channel."""
    stems = [_NUMBERED.sub("", table.columns[at].name).casefold() for at in (place, first)]
    behind = table.columns[place + 1].name if place + 1 < len(table) else ""
    return stems[0] == stems[1] or (behind != "" and table.columns[place].name.endswith(behind))


_NUMBERED = re.compile(r"[\s_.:-]*\d.*$")


def _is_other(clock: _Clock, first: _Clock, *, is_named: bool) -> bool:
    """Whether a clock has its own instants: neither the same instants nor shifted ones (a time of day).

    A clock of equal length must also be named as a second clock (``is_named``), which excludes e.g. lap times.
    """
    if clock.rows.size != first.rows.size:
        return True
    if not is_named:
        return False
    offset = clock.instants - first.instants
    step = float(np.median(np.diff(first.instants)))
    if np.ptp(offset) > 0.01 * step:  # more than digits of a file
        return True
    return 0.01 * step < abs(float(offset[0])) < 0.5 * float(np.ptp(first.instants))


def _homes(table: ColumnTable, clocks: Mapping[int, _Clock]) -> list[int]:
    """Return the index of the clock of each column: the last clock before it, or else the first."""
    places = sorted(clocks)
    return [
        max([place for place in places if place <= at], default=places[0])
        for at in range(len(table))
    ]


def _of_group(
    table: ColumnTable,
    places: Collection[int],
    clock: _Clock,
    members: Sequence[Column],
    count: int,
    time: str,
    bridges: bool,
) -> list[ColumnTable]:
    """Split the columns of one clock: a table with a value at each timestamp, and a table for each lower rate."""
    place = max(clock.place, 0)
    own = table.columns[place]
    complete: list[Column] = []
    slower: dict[bytes, tuple[Rows, list[Column]]] = {}
    for column in members:
        part = _rows_of(column)
        rows, values = (np.arange(column.values.size), column.values) if part is None else part
        if column.fault is not None and part is None:
            complete.append(column)
        elif np.array_equal(rows, clock.rows):
            complete.append(replace(column, values=values, fault=None, part=None))
        elif rows.size > 1 and rows[-1] < clock.rows.size and (bridges or _is_slower(clock, rows)):
            sampled = replace(column, values=values, fault=None, part=None)
            slower.setdefault(rows.tobytes(), (rows, []))[1].append(sampled)
        else:
            complete.append(column)  # its fault is reported when the channel is read
    head = replace(
        own, values=own.values if own.part is None else own.part[1], fault=None, part=None
    )
    if own.name != "time":
        unit = own.unit or name_and_unit(time)[1]
        head = replace(head, name="time", unit=unit, written=own.written or own.label)
    lines = table.lines[: clock.rows.size] if clock.rows.size < count else table.lines
    remarks = table.remarks if place == min(places) else ()
    base = ColumnTable((head, *complete), table.comments, table.file, lines, remarks)
    return [base, *(_slower(base, clock, rows, columns) for rows, columns in slower.values())]


def _is_slower(clock: _Clock, rows: Rows) -> bool:
    """Whether rows belong to a lower rate: spread over the whole record, without missing samples."""
    return bool(rows[-1] - rows[0] >= rows.size) and is_steady(clock.instants[rows])


def _slower(base: ColumnTable, clock: _Clock, rows: Rows, columns: Sequence[Column]) -> ColumnTable:
    time = Column("time", "s", np.ascontiguousarray(clock.instants[rows]), base.file)
    lines = [base.lines[row] for row in rows] if base.lines else ()
    return ColumnTable((time, *columns), (), base.file, lines)


def lower_rate_finding(
    names: Sequence[str], instants: Array, values: Array, step: float, where: str
) -> Finding:
    """Report the interpolation of channels of a lower rate; warn if they vary too fast for their rate.

    ``values`` (a column for each channel) are samples at ``instants`` (s); ``step`` (s) is the step of the recording.
    """
    rate = rate_of(instants)
    share = _fast_share(values)
    code = "recordings.lower_rate_uncertain" if share > _FAST else "recordings.lower_rate"
    numbers: dict[str, Any] = {
        "own": rate,
        "rate": 1.0 / step,
        "highest": 0.5 * rate,
        "fast": 0.25 * rate,
    }
    return finding(code, f"{where}: {', '.join(names)}", rate, share=share, **numbers)


_FAST = (
    0.01  # share of power above a quarter of the rate, where a spline errs most: 10 % in amplitude
)


def _fast_share(values: Array) -> float:
    """Return the largest fraction of power above a quarter of the rate among the detrended columns."""
    from scipy import signal

    if values.shape[0] < 2 * FEWEST_SAMPLES:
        return 0.0
    windowed = signal.detrend(values, axis=0) * np.hanning(values.shape[0])[:, None]
    power = np.abs(np.fft.rfft(windowed, axis=0)) ** 2
    whole = power.sum(axis=0)
    fast = power[power.shape[0] // 2 :].sum(axis=0)
    return float(
        np.max(np.divide(fast, whole, out=np.zeros_like(whole), where=whole > 0.0), initial=0.0)
    )
