"""LabVIEW measurement files: text with tagged headers, made into the plain table that it holds.

Of the grammar that National Instruments publish one segment is read: names, units, start and step of its channels, with
one column of X values, with one for each channel where these are the same, or with none. What the header says of a
channel stands in the column of its samples; above a column of X values it says nothing.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from datetime import date
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np

from jounce.core.errors import RecordingError
from jounce.core.types import Array
from jounce.core.units import LARGEST

FIRST = "LabVIEW Measurement"
_END, _SPECIAL, _SPECIAL_END = "***End_of_Header***", "***Start_Special***", "***End_Special***"
_OF_CHANNELS = ("Samples", "Date", "Time", "Y_Unit_Label", "X_Dimension", "X0", "Delta_X")
_DIGITS = 13  # of a count
_SAME_TIME = 1e-3  # of the step
_SAME_START = 0.1  # of the step, by clocks that LabVIEW asked one after the other
_HALF, _ROUNDING = 0.51, 0.51e-6  # of the last decimal, and of six of them in s
_ALLOWED = "one segment after the header, with equal steps of all channels"


def plain_columns(text: str, file: Path) -> tuple[str, int | None]:
    r"""Give the table of a LabVIEW measurement file as text, each row on its line: ``time [s]`` and the channels.

    With it how many samples of each channel the header announces, where it does.
    Raises RecordingError for a file that was cut off, has several segments, or whose channels differ in their times.

    >>> head = "LabVIEW Measurement\nSeparator\tTab\nX_Columns\tNo\n***End_of_Header***\n\nChannels\t1\n"
    >>> segment = "Y_Unit_Label\tg\nX0\t0.5\nDelta_X\t0.25\n***End_of_Header***\nX_Value\tbody\tComment\n\t1.5\n\t2.0\n"
    >>> table, announced = plain_columns(head + segment, Path("a.lvm"))
    >>> table.split("\n")[-3:], announced
    (['time [s]\tbody [g]', '0.5\t1.5', '0.75\t2.0'], None)
    """
    lines = text.splitlines()
    ends = [i for i, line in enumerate(lines) if line.startswith(_END)]
    if len(ends) != 2 or len(lines) < ends[1] + 3:
        found = "no data" if len(ends) < 2 or len(lines) < ends[1] + 3 else f"{len(ends) - 1} segments"
        hint = "Write a file for each, or all in one segment." if len(ends) > 2 else "Is the file whole?"
        raise RecordingError("no table of one segment", where=str(file), found=found, allowed=_ALLOWED, hint=hint)
    has_commas = any(line.replace("\t", ",").startswith("Separator,Comma") for line in lines[: ends[0]])
    separator = "," if has_commas else "\t"
    names = _cells(lines[ends[1] + 1].rstrip(separator), separator)
    if names[0] != "X_Value":
        where, hint = f"{file}, line {ends[1] + 2}", "Is the file whole?"
        raise RecordingError("no names of columns", where=where, found=names[0], allowed="X_Value first", hint=hint)
    clocks = [i for i, name in enumerate(names) if name == "X_Value"]
    kept = [i for i, name in enumerate(names) if name not in ("X_Value", "Comment")]
    header = _header(lines[ends[0] + 1 : ends[1]], separator, len(names))
    _check_columns(header, clocks, file)
    measured = [i for i in kept if header["Samples"][i] != "0"]
    if others := {header["X_Dimension"][i] for i in measured} - {"", "Time"}:
        found = ", ".join(sorted(others))
        raise RecordingError("no signals over time", where=f"{file}: X_Dimension", found=found, allowed="Time")
    start, step = (_common(f"{file}: {tag}", [header[tag][i] for i in measured]) for tag in ("X0", "Delta_X"))
    units = [header["Y_Unit_Label"][i] if "[" not in names[i] else "" for i in kept]
    heads = [names[i] + (f" [{unit}]" if unit else "") for i, unit in zip(kept, units, strict=True)]
    rows, written, last = _rows(lines, ends[1] + 2, separator, clocks, kept, step, file)
    _check_stamps([(header["Date"][i], header["Time"][i]) for i in measured], _step_of(written, step), file)
    mark = "," if not has_commas and any("," in row for row in rows.values()) else "."
    table = [*["#"] * (ends[1] + 1), separator.join(["time [s]", *heads]), *[""] * (len(lines) - ends[1] - 2)]
    for (place, row), time in zip(rows.items(), _times(written, last, start, step).tolist(), strict=True):
        table[place] = ("" if math.isnan(time) else repr(time).replace(".", mark)) + separator + row
    announced = [int(cell) for cell in header["Samples"] if cell.isdecimal() and len(cell) < _DIGITS]
    return "\n".join(table), max(announced, default=None)


def _cells(line: str, separator: str) -> list[str]:
    return [cell.strip() for cell in line.split(separator)]


def _header(lines: Sequence[str], separator: str, width: int) -> dict[str, list[str]]:
    """What the header says of each column, empty where it says nothing; what special blocks say is left out."""
    found, special = dict[str, list[str]](), False
    for line in lines:
        special = (special or line.startswith(_SPECIAL)) and not line.startswith(_SPECIAL_END)
        tag, *cells = _cells(line, separator)
        if not special:
            found.setdefault(tag, ["", *cells])
    return {tag: [*found.get(tag, []), *[""] * width][:width] for tag in _OF_CHANNELS}


def _check_columns(header: dict[str, list[str]], clocks: Sequence[int], file: Path) -> None:
    """Refuse what stands above a column of X values: nobody knows of which channel it speaks."""
    for tag, cells in header.items():
        for column in clocks:
            if cells[column]:
                raise RecordingError(
                    "the header says something of a column of X values",
                    where=f"{file}: {tag}",
                    found=f"{cells[column]!r} in column {column + 1}",
                    allowed="the cell of each channel in the column of its samples",
                    hint="Insert an empty cell before that of each further channel, as LabVIEW does.",
                )


def _check_stamps(stamps: Sequence[tuple[str, str]], step: float, file: Path) -> None:
    """Refuse channels that began at different times of the day; those that say none have no say."""
    told = {" ".join(stamp): _moment(*stamp) for stamp in stamps if all(stamp)}
    moments = [moment for moment in told.values() if moment is not None]
    if len(told) > 1 and (len(moments) < len(told) or max(moments) - min(moments) > _SAME_START * step):
        raise _apart(f"{file}: Date, Time", told)


def _moment(day: str, time: str) -> Fraction | None:
    """Seconds up to a moment since some day, which floats do not hold to a microsecond; none for what is no moment."""
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
        hint = "Correct the cell, or empty it where the channel has no sample."
        raise RecordingError("not a number of seconds", where=where, found=cell, allowed="finite numbers", hint=hint)
    return number


def _common(where: str, cells: Sequence[str]) -> float:
    """Give the one number that the header says of all channels; 0 where it says none."""
    numbers = {_number(cell, where): cell for cell in cells if cell}
    if len(numbers) > 1:
        raise _apart(where, [f"{cell} s" for cell in numbers.values()])
    return next(iter(numbers), 0.0)


def _apart(where: str, cells: Iterable[str]) -> RecordingError:
    found = " and ".join(cells)
    hint = "Write a file for each, or bring them onto one clock in LabVIEW (Align and Resample)."
    return RecordingError("channels begin or step differently", where=where, found=found, allowed=_ALLOWED, hint=hint)


def _rows(
    lines: Sequence[str],
    first: int,
    separator: str,
    clocks: Sequence[int],
    kept: Sequence[int],
    step: float,
    file: Path,
) -> tuple[dict[int, str], Array, float]:
    """Cells of the channels in each row that is not empty, by its place in the lines, and its time, NaN without one.

    With them what one of the last decimal is worth that is written of any time. Refuses times of a row that are apart
    by more than a thousandth of the step between rows, or of the header's ``step`` where one row only has times.
    """
    rows, times, several, last = dict[int, str](), list[float](), dict[int, dict[float, str]](), 0
    for place, line in enumerate(lines[first:], start=first):
        cells = _cells(line, separator)
        if any(cells):
            own = {_number(cells[i], str(file), place + 1): cells[i] for i in clocks if i < len(cells) and cells[i]}
            rows[place] = separator.join(cells[i] for i in kept if i < len(cells))
            times.append(next(iter(own), math.nan))
            last = min([last, *(int(Decimal(cell.replace(",", ".")).as_tuple().exponent) for cell in own.values())])
            if len(own) > 1:
                several[place] = own
    written = np.array(times)
    same = _SAME_TIME * _step_of(written, step)
    for place, own in several.items():
        if max(own) - min(own) > same:
            raise _apart(f"{file}, line {place + 1}", [f"{cell} s" for cell in own.values()])
    return rows, written, 10.0**last


def _step_of(written: Array, step: float) -> float:
    """The step between rows as it is written, or as the header says it."""
    steps = np.diff(written[np.isfinite(written)])
    return abs(float(np.median(steps)) if steps.size else step)


def _times(written: Array, last: float, start: float, step: float) -> Array:
    """Time of each row (s): as written, or from start and step where none is.

    What is written may be start and step, rounded to its ``last`` decimal as LabVIEW does: then it is these. A start so
    far from zero that floats do not hold the steps behind it is left out.
    """
    counted = step * np.arange(written.size, dtype=float)
    rounding = min(_HALF * last, _ROUNDING) + math.ulp(start)
    is_rounded = np.abs(written - start - counted) <= min(rounding, step / 2)
    if not is_rounded.all() and not np.isnan(written).all():
        return written
    return counted if math.ulp(start) > _SAME_TIME * step else start + counted
