"""LabVIEW measurement files: text with tagged headers, converted to a plain table.

One segment of the format published by National Instruments is read: names, units, start and step of its channels,
with one column of X values, one for each channel if these are equal, or none. The header of a channel is in the
column of its samples; it must be empty above a column of X values.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from datetime import date
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np

from jounce.core.errors import RecordingError, at_line
from jounce.core.types import Array
from jounce.core.units import LARGEST

FIRST = "LabVIEW Measurement"
_END, _SPECIAL, _SPECIAL_END = "***End_of_Header***", "***Start_Special***", "***End_Special***"
_OF_CHANNELS = ("Samples", "Date", "Time", "Y_Unit_Label", "X_Dimension", "X0", "Delta_X")
_DIGITS = 13  # maximum digits of a count; a longer number is damaged
_SAME_TIME = 1e-3  # of the step: timestamps of a row that differ by less belong to one clock
_SAME_START = 0.1  # of the step: LabVIEW reads the clock of each channel in sequence
_HALF, _ROUNDING = (
    0.51,
    0.51e-6,
)  # half of the last decimal, and of six decimals in s, with a margin for floats
_ALLOWED = "one segment after the header, with equal steps for all channels"


def plain_columns(text: str, file: Path) -> tuple[str, int | None]:
    r"""Convert a LabVIEW measurement file to a text table with ``time [s]`` and the channels; line numbers are kept.

    Also returns the number of samples stated in the header, or None.
    Raises RecordingError if the file is truncated, has several segments, or its channels have different times.

    >>> head = "LabVIEW Measurement\nSeparator\tTab\nX_Columns\tNo\n***End_of_Header***\n\nChannels\t1\n"
    >>> segment = "Y_Unit_Label\tg\nX0\t0.5\nDelta_X\t0.25\n***End_of_Header***\nX_Value\tbody\tComment\n\t1.5\n\t2.0\n"
    >>> table, announced = plain_columns(head + segment, Path("a.lvm"))
    >>> table.split("\n")[-3:], announced
    (['time [s]\tbody [g]', '0.5\t1.5', '0.75\t2.0'], None)
    """
    lines = text.splitlines()
    ends = [i for i, line in enumerate(lines) if line.startswith(_END)]
    if len(ends) != 2 or len(lines) < ends[1] + 3:
        contents = (
            "no data" if len(ends) < 2 or len(lines) < ends[1] + 3 else f"{len(ends) - 1} segments"
        )
        hint = (
            "Write a separate file for each channel, or all of them in one segment."
            if len(ends) > 2
            else "Is the file complete?"
        )
        raise RecordingError(
            "not a table with a single segment",
            where=str(file),
            found=contents,
            allowed=_ALLOWED,
            hint=hint,
        )
    has_commas = any(
        line.replace("\t", ",").startswith("Separator,Comma") for line in lines[: ends[0]]
    )
    separator = "," if has_commas else "\t"
    names = _cells(lines[ends[1] + 1].rstrip(separator), separator)
    if names[0] != "X_Value":
        where, hint = at_line(file, ends[1] + 2), "Is the file complete?"
        raise RecordingError(
            "the column names are missing",
            where=where,
            found=names[0],
            allowed="X_Value as the first column",
            hint=hint,
        )
    clocks = [i for i, name in enumerate(names) if name == "X_Value"]
    channels = [i for i, name in enumerate(names) if name not in ("X_Value", "Comment")]
    header = _header(lines[ends[0] + 1 : ends[1]], separator, len(names))
    _check_columns(header, clocks, file)
    measured = [i for i in channels if header["Samples"][i] != "0"]
    if others := {header["X_Dimension"][i] for i in measured} - {"", "Time"}:
        contents = ", ".join(sorted(others))
        raise RecordingError(
            "no time signals", where=f"{file}: X_Dimension", found=contents, allowed="Time"
        )
    start, step = (
        _common(f"{file}: {tag}", [header[tag][i] for i in measured]) for tag in ("X0", "Delta_X")
    )
    units = [header["Y_Unit_Label"][i] if "[" not in names[i] else "" for i in channels]
    heads = [
        names[i] + (f" [{unit}]" if unit else "") for i, unit in zip(channels, units, strict=True)
    ]
    rows, written, last = _rows(lines, ends[1] + 2, separator, clocks, channels, step, file)
    _check_stamps(
        [(header["Date"][i], header["Time"][i]) for i in measured], _step_of(written, step), file
    )
    mark = "," if not has_commas and any("," in row for row in rows.values()) else "."
    table = [
        *["#"] * (ends[1] + 1),
        separator.join(["time [s]", *heads]),
        *[""] * (len(lines) - ends[1] - 2),
    ]
    for (place, row), time in zip(
        rows.items(), _times(written, last, start, step).tolist(), strict=True
    ):
        table[place] = ("" if math.isnan(time) else repr(time).replace(".", mark)) + separator + row
    announced = [
        int(cell) for cell in header["Samples"] if cell.isdecimal() and len(cell) < _DIGITS
    ]
    return "\n".join(table), max(announced, default=None)


def _cells(line: str, separator: str) -> list[str]:
    return [cell.strip() for cell in line.split(separator)]


def _header(lines: Sequence[str], separator: str, width: int) -> dict[str, list[str]]:
    """Header cells of each column, "" without one; special blocks are skipped."""
    cells_of, special = dict[str, list[str]](), False
    for line in lines:
        special = (special or line.startswith(_SPECIAL)) and not line.startswith(_SPECIAL_END)
        tag, *cells = _cells(line, separator)
        if not special:
            cells_of.setdefault(tag, ["", *cells])
    return {tag: [*cells_of.get(tag, []), *[""] * width][:width] for tag in _OF_CHANNELS}


def _check_columns(header: dict[str, list[str]], clocks: Sequence[int], file: Path) -> None:
    """Refuse header cells above a column of X values: their channel is unknown."""
    for tag, cells in header.items():
        for column in clocks:
            if cells[column]:
                raise RecordingError(
                    "the header has an entry for a column of X values",
                    where=f"{file}: {tag}",
                    found=f"{cells[column]!r} in column {column + 1}",
                    allowed="the cell of each channel in the column of its samples",
                    hint="Insert an empty cell before that of each additional channel, as LabVIEW does.",
                )


def _check_stamps(stamps: Sequence[tuple[str, str]], step: float, file: Path) -> None:
    """Refuse channels that began at different times of day; channels without a stamp are ignored."""
    moment_of = {" ".join(stamp): _moment(*stamp) for stamp in stamps if all(stamp)}
    moments = [moment for moment in moment_of.values() if moment is not None]
    if len(moment_of) > 1 and (
        len(moments) < len(moment_of) or max(moments) - min(moments) > _SAME_START * step
    ):
        raise _apart(f"{file}: Date, Time", moment_of)


def _moment(day: str, time: str) -> Fraction | None:
    """Return the exact number of seconds since day 1 (floats lose microseconds); None for invalid text."""
    try:
        hours, minutes, seconds = map(Fraction, time.replace(",", ".").split(":"))
        days = date.fromisoformat(day.replace("/", "-")).toordinal()
    except (ValueError, ZeroDivisionError):
        return None
    return 86400 * days + 3600 * hours + 60 * minutes + seconds


def _number(cell: str, where: str, line: int = 0) -> float:
    """Read a finite number, with a point or a comma."""
    try:
        number = float(cell.replace(",", ".")) if "_" not in cell else math.nan
    except ValueError:
        number = math.nan
    if not abs(number) <= LARGEST:
        where += f", line {line}: X_Value" if line else ""
        hint = "Correct the cell, or clear it if the channel has no sample there."
        raise RecordingError(
            "invalid number of seconds",
            where=where,
            found=cell,
            allowed="finite numbers",
            hint=hint,
        )
    return number


def _common(where: str, cells: Sequence[str]) -> float:
    """Return the common number of all channels in the header; 0 without one, an error if they differ."""
    numbers = {_number(cell, where): cell for cell in cells if cell}
    if len(numbers) > 1:
        raise _apart(where, [f"{cell} s" for cell in numbers.values()])
    return next(iter(numbers), 0.0)


def _apart(where: str, cells: Iterable[str]) -> RecordingError:
    values = " and ".join(cells)
    hint = (
        "Write a separate file for each channel, or put the channels on a common clock in LabVIEW "
        "(Align and Resample)."
    )
    return RecordingError(
        "the channels have different start times or steps",
        where=where,
        found=values,
        allowed=_ALLOWED,
        hint=hint,
    )


def _rows(
    lines: Sequence[str],
    first: int,
    separator: str,
    clocks: Sequence[int],
    channels: Sequence[int],
    step: float,
    file: Path,
) -> tuple[dict[int, str], Array, float]:
    """Return the channel cells of each non-empty row by line number, and the times of the rows (NaN if missing).

    Also returns the resolution of the times as written. Refuses times within a row that differ by more than a
    thousandth of the step between rows, or of the header's ``step`` if only one row has times.
    """
    rows, times, stamps, last = dict[int, str](), list[float](), dict[int, dict[float, str]](), 0
    for place, line in enumerate(lines[first:], start=first):
        cells = _cells(line, separator)
        if any(cells):
            own = {
                _number(cells[i], str(file), place + 1): cells[i]
                for i in clocks
                if i < len(cells) and cells[i]
            }
            rows[place] = separator.join(cells[i] for i in channels if i < len(cells))
            times.append(next(iter(own), math.nan))
            last = min(
                [
                    last,
                    *(
                        int(Decimal(cell.replace(",", ".")).as_tuple().exponent)
                        for cell in own.values()
                    ),
                ]
            )
            if len(own) > 1:
                stamps[place] = own
    written = np.array(times)
    same = _SAME_TIME * _step_of(written, step)
    for place, own in stamps.items():
        if max(own) - min(own) > same:
            raise _apart(at_line(file, place + 1), [f"{cell} s" for cell in own.values()])
    return rows, written, 10.0**last


def _step_of(written: Array, step: float) -> float:
    """Return the median step between rows as written, or else the step of the header."""
    steps = np.diff(written[np.isfinite(written)])
    return abs(float(np.median(steps)) if steps.size else step)


def _times(written: Array, last: float, start: float, step: float) -> Array:
    """Return the time of each row (s): as written, or else from start and step.

    If the written times are start and step rounded to the ``last`` decimal, as in LabVIEW, the exact times are used.
    A start so large that floats cannot resolve the steps is dropped.
    """
    counted = step * np.arange(written.size, dtype=float)
    rounding = min(_HALF * last, _ROUNDING) + math.ulp(start)
    is_rounded = np.abs(written - start - counted) <= min(rounding, step / 2)
    if not is_rounded.all() and not np.isnan(written).all():
        return written
    return counted if math.ulp(start) > _SAME_TIME * step else start + counted
