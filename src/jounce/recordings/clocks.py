"""Tables whose channels are sampled at several rates: each channel on the instants at which it was measured.

Loggers write slower channels with blank cells in the rows between their samples, or give each group of channels a time
column of its own. Both become what formats with groups (MDF, TDMS) have already: a table a clock.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from jounce.core.columns import Column, ColumnTable, name_and_unit, names_time
from jounce.core.errors import JounceError
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.core.units import conversion_factor
from jounce.recordings.quality import FEWEST_SAMPLES
from jounce.recordings.reader import SignalTable

_GAP = 1.5  # usual steps above which a sample is missing: what is between is no channel of a lower rate
_ROUNDING = 1e-9

Rows = NDArray[np.intp]


def by_clock(signals: SignalTable, time: str, step: float | None, *, bridges_gaps: bool) -> tuple[SignalTable, bool]:
    """Give each clock of a file its table, and say whether ``time`` is now that of all of them.

    ``time`` is the column that the user calls time, empty for none; ``step`` (s) the given one of rows without time.
    Channels with gaps stay where they are, with the fault that says so, unless the gaps are bridged later.
    """
    first = _of_table(signals.columns, time, step, bridges_gaps)
    others = [part for table in signals.others for part in _of_table(table, "", None, bridges_gaps)]
    is_made = first[0] is not signals.columns and "time" in first[0].names
    return replace(signals, columns=first[0], others=(*first[1:], *others)), is_made


def is_steady(instants: Array) -> bool:
    """Whether these are instants (s) of a clock without gaps: enough of them, and none further apart than usual."""
    if instants.size < FEWEST_SAMPLES or not np.isfinite(instants).all():
        return False
    steps = np.diff(instants)
    return bool(steps.min() > 0.0 and steps.max() <= _GAP * float(np.median(steps)))


def rate_of(instants: Array) -> float:
    """Usual rate of a clock in Hz.

    >>> rate_of(np.arange(9) * 0.01)
    100.0
    """
    return round(1.0 / float(np.median(np.diff(instants))), 9)


@dataclass(frozen=True)
class _Clock:
    """Rows that have a stamp, their instants in s, and the place of its column (-1 where a step is given)."""

    rows: Rows
    instants: Array
    place: int


def _of_table(table: ColumnTable, time: str, step: float | None, bridges_gaps: bool) -> list[ColumnTable]:
    count = max((column.values.size for column in table), default=0)
    count = max([count, *(int(column.part[0][-1]) + 1 for column in table if column.part is not None)])
    if step is not None:
        if not any(_gappy(column) for column in table):
            return [table]
        kept = tuple(column for column in table if column.name != "time")
        clock = _Clock(np.arange(count), np.asarray(np.arange(count) * step, dtype=float), -1)
        table = replace(table, columns=(Column("time", "s", clock.instants, table.file), *kept))
        clocks = {0: clock}
    else:
        clocks = dict(_clocks(table, time, count))
    if not clocks or (len(clocks) == 1 and not any(_gappy(column) for column in table)):
        return [_with_time(table, clocks, time)]
    homes = _homes(table, clocks)
    tables: list[ColumnTable] = []
    for place, clock in clocks.items():
        members = [column for at, column in enumerate(table) if homes[at] == place and at not in clocks]
        tables += _of_group(table, clocks, clock, members, count, time, bridges_gaps)
    return tables


def _with_time(table: ColumnTable, clocks: Mapping[int, _Clock], time: str) -> ColumnTable:
    """The table, its only clock named ``time`` where nobody has said which column is."""
    if len(clocks) != 1 or time or "time" in table.names:
        return table
    (place,) = clocks
    columns, own = list(table.columns), table.columns[place]
    columns[place] = replace(own, name="time", written=own.written or own.label)
    return replace(table, columns=tuple(columns), remarks=(*table.remarks, f"{own.label!r} was taken for the time"))


def _gappy(column: Column) -> bool:
    return _rows_of(column) is not None


def _rows_of(column: Column) -> tuple[Rows, Array] | None:
    """Rows of a column that hold a number, and the numbers; None where all do, or some hold what is no number."""
    if column.part is not None or column.fault is not None:
        return column.part
    missing = np.isnan(column.values)
    if not missing.any() or missing.all():
        return None
    rows = np.flatnonzero(~missing)
    return rows, column.values[rows]


def _clocks(table: ColumnTable, time: str, count: int) -> Iterator[tuple[int, _Clock]]:
    """Columns of time that have channels behind them, by their place."""
    wanted = (time, name_and_unit(time)[0]) if time else ("time",)
    found: list[tuple[int, _Clock]] = []
    for place, column in enumerate(table):
        is_named = _is_called(column, wanted)
        if is_named or names_time(column.name):
            clock = _clock(column, place, count, unit=name_and_unit(time)[1] if is_named else "")
            if clock is not None:
                found.append((place, clock))
    named = [one for one in found if _is_called(table.columns[one[0]], wanted)]
    first = (named if len(named) == 1 else found)[:1]
    kept = list(first)
    for place, clock in found:
        alike = [_is_named_alike(table, place, before) for before, _ in kept]
        if all(_is_other(clock, before, is_named=alike[i]) for i, (_, before) in enumerate(kept)):
            kept.append((place, clock))
    kept.sort(key=lambda one: one[0])
    ends = [place for place, _ in [*kept, (len(table), None)]][1:]
    for (place, clock), end in zip(kept, ends, strict=True):
        if end - place > 1 or len(kept) == 1:
            yield place, clock


def _is_called(column: Column, names: Sequence[str]) -> bool:
    return any(name and name in (column.name, column.label, column.written) for name in names)


def _clock(column: Column, place: int, count: int, unit: str) -> _Clock | None:
    """The column as a clock: its stamps stand from the first row on, and ascend."""
    part = _rows_of(column)
    if part is None and column.fault is not None:
        return None
    rows, stamps = (np.arange(count), column.values) if part is None else part
    try:
        factor = conversion_factor(column.unit or unit, "s")
    except JounceError:
        return None
    if unit and column.unit and unit != column.unit:  # which is refused where it is asked for
        return None
    if stamps.size < 2 or rows.size != stamps.size or rows[-1] != rows.size - 1 or not np.all(np.diff(stamps) > 0.0):
        return None
    return _Clock(rows, np.asarray(stamps * factor, dtype=float), place)


def _is_named_alike(table: ColumnTable, place: int, first: int) -> bool:
    """Whether two columns of time are called alike (``Time 1``, ``Time 2``), or the second after the one behind it."""
    stems = [_NUMBERED.sub("", table.columns[at].name).casefold() for at in (place, first)]
    behind = table.columns[place + 1].name if place + 1 < len(table) else ""
    return stems[0] == stems[1] or (behind != "" and table.columns[place].name.endswith(behind))


_NUMBERED = re.compile(r"[\s_.:-]*\d.*$")


def _is_other(clock: _Clock, first: _Clock, *, is_named: bool) -> bool:
    """Whether a clock has instants of its own: not the same ones, nor the same with another zero (a time of day).

    One of as many samples must also be named as a clock beside the other (``is_named``): a time of a lap is none.
    """
    if clock.rows.size != first.rows.size:
        return True
    if not is_named:
        return False
    apart = clock.instants - first.instants
    step = float(np.median(np.diff(first.instants)))
    if np.ptp(apart) > 0.01 * step:
        return True
    return 0.01 * step < abs(float(apart[0])) < 0.5 * float(np.ptp(first.instants))


def _homes(table: ColumnTable, clocks: Mapping[int, _Clock]) -> list[int]:
    """The clock of each column: the one before it, or the first."""
    places = sorted(clocks)
    return [max([place for place in places if place <= at], default=places[0]) for at in range(len(table))]


def _of_group(
    table: ColumnTable,
    places: Collection[int],
    clock: _Clock,
    members: Sequence[Column],
    count: int,
    time: str,
    bridges: bool,
) -> list[ColumnTable]:
    """Tables of the columns behind one clock: those with a number at each stamp, and those of each lower rate."""
    place = max(clock.place, 0)
    own = table.columns[place]
    whole: list[Column] = []
    slower: dict[bytes, tuple[Rows, list[Column]]] = {}
    for column in members:
        part = _rows_of(column)
        rows, values = (np.arange(column.values.size), column.values) if part is None else part
        if column.fault is not None and part is None:
            whole.append(column)
        elif np.array_equal(rows, clock.rows):
            whole.append(replace(column, values=values, fault=None, part=None))
        elif (
            rows.size
            and rows[-1] < clock.rows.size
            and rows.size > 1
            and (bridges or (rows[-1] - rows[0] >= rows.size and is_steady(clock.instants[rows])))
        ):
            kept = replace(column, values=values, fault=None, part=None)
            slower.setdefault(rows.tobytes(), (rows, []))[1].append(kept)
        else:
            whole.append(column)  # whoever asks for it is told what is missing
    head = replace(own, values=own.values if own.part is None else own.part[1], fault=None, part=None)
    if own.name != "time":
        unit = own.unit or name_and_unit(time)[1]
        head = replace(head, name="time", unit=unit, written=own.written or own.label)
    lines = table.lines[: clock.rows.size] if clock.rows.size < count else table.lines
    remarks = table.remarks if place == min(places) else ()
    base = ColumnTable((head, *whole), table.comments, table.file, lines, remarks)
    return [base, *(_slower(base, clock, rows, columns) for rows, columns in slower.values())]


def _is_slower(clock: _Clock, rows: Rows) -> bool:
    """Whether rows are those of a lower rate: not all in a stretch of the record, and none missing."""
    return bool(rows[-1] - rows[0] >= rows.size) and is_steady(clock.instants[rows])


def _slower(base: ColumnTable, clock: _Clock, rows: Rows, columns: Sequence[Column]) -> ColumnTable:
    time = Column("time", "s", np.ascontiguousarray(clock.instants[rows]), base.file)
    lines = [base.lines[row] for row in rows] if base.lines else ()
    return ColumnTable((time, *columns), (), base.file, lines)


def told(names: Sequence[str], instants: Array, values: Array, step: float, where: str) -> Finding:
    """What was done with channels of a lower rate; a warning where they move as fast as their samples can tell.

    ``values`` (a column a channel) are those at their own ``instants`` (s); ``step`` (s) is that of the recording.
    """
    rate = rate_of(instants)
    share = _fast_share(values)
    text = (
        f"recorded at {rate:g} Hz, the recording has {1.0 / step:g} Hz; a cubic spline through the "
        f"samples lies between them, and above {0.5 * rate:g} Hz nothing was measured"
    )
    if share > _FAST:
        text += (
            f"; {100.0 * share:.2g} % of the power lies above {0.25 * rate:g} Hz: what lies between the samples is "
            "uncertain"
        )
    return Finding(f"{where}: {', '.join(names)}", "warning" if share > _FAST else "note", text, rate)


_FAST = 0.01  # share of a channel's power above a quarter of its rate from which its samples are too few


def _fast_share(values: Array) -> float:
    """Largest share of power above a quarter of the rate, of the columns' movements."""
    from scipy import signal

    if values.shape[0] < 2 * FEWEST_SAMPLES:
        return 0.0
    moved = signal.detrend(values, axis=0) * np.hanning(values.shape[0])[:, None]
    power = np.abs(np.fft.rfft(moved, axis=0)) ** 2
    whole = power.sum(axis=0)
    fast = power[power.shape[0] // 2 :].sum(axis=0)
    return float(np.max(np.divide(fast, whole, out=np.zeros_like(whole), where=whole > 0.0), initial=0.0))
