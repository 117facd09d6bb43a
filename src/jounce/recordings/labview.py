"""LabVIEW measurement files: text with tagged headers, made into the plain table that it holds.

Of the grammar that National Instruments publish one segment is read: names, units, start and step of its channels, with
one column of X values, with one for each channel where these are the same, or with none.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from jounce.core.errors import RecordingError

FIRST = "LabVIEW Measurement"
_END, _SPECIAL, _SPECIAL_END = "***End_of_Header***", "***Start_Special***", "***End_Special***"
_DIGITS = 13  # of a count
_SAME_TIME = 1e-3  # of the step
_ALLOWED = "one segment after the header, with equal steps of all channels"


def plain_columns(text: str, file: Path) -> tuple[str, int | None]:
    r"""Give the table of a LabVIEW measurement file as text, each row on its line: ``time [s]`` and the channels.

    With it how many samples of each channel the header announces, where it does.
    Raises RecordingError for a file that was cut off, has several segments, or whose channels differ in their steps.

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
    separator = "," if _tags(lines[: ends[0]], "\t").get("Separator", _comma(lines)) == ["Comma"] else "\t"
    whole, own = _tags(lines[: ends[0]], separator), _tags(lines[ends[0] + 1 : ends[1]], separator)
    mark = whole.get("Decimal_Separator", ["."])[0]
    names = lines[ends[1] + 1].rstrip(separator).split(separator)
    kept = [i for i, name in enumerate(names) if name not in ("X_Value", "Comment")]
    if any(len({_number(x, mark, file) for x in own.get(tag, [])}) > 1 for tag in ("X0", "Delta_X")):
        raise _apart(str(file))
    if any(dimension != "Time" for dimension in own.get("X_Dimension", [])):
        raise RecordingError("no signals over time", where=f"{file}: X_Dimension", allowed="Time")
    units = own.get("Y_Unit_Label", [])
    units = [*units, *[""] * (len(kept) - len(units))]
    heads = [
        names[i] + (f" [{unit}]" if unit and "[" not in names[i] else "") for i, unit in zip(kept, units, strict=False)
    ]
    start, step = (_number(own.get(tag, [""])[0] or "0", mark, file) for tag in ("X0", "Delta_X"))
    first = ends[1] + 2
    _check_times(lines[first:], names, separator, mark, step, file, first)
    rows = list(_rows(lines[first:], separator, kept, mark, start, step))
    announced = [int(count) for count in own.get("Samples", []) if count.isdecimal() and len(count) < _DIGITS]
    table = "\n".join([*["#"] * (ends[1] + 1), separator.join(["time [s]", *heads]), *rows])
    return table, max(announced, default=None)


def _comma(lines: Sequence[str]) -> list[str]:
    """What the line of the separator says where tabs do not separate."""
    return next((["Comma"] for line in lines[:20] if line.startswith("Separator,Comma")), ["Tab"])


def _tags(lines: Sequence[str], separator: str) -> dict[str, list[str]]:
    """Tags of a header with what follows them; what special blocks say is left out."""
    found, special = dict[str, list[str]](), False
    for line in lines:
        special = (special or line.startswith(_SPECIAL)) and not line.startswith(_SPECIAL_END)
        tag, *values = line.rstrip(separator).split(separator)
        if tag and not special:
            found.setdefault(tag, values)
    return found


def _number(cell: str, mark: str, file: Path) -> float:
    try:
        return float(cell.replace(mark, "."))
    except ValueError:
        raise RecordingError("not a number in the header", where=str(file), found=cell) from None


def _apart(where: str, found: str | None = None) -> RecordingError:
    return RecordingError("channels begin or step differently", where=where, found=found, allowed=_ALLOWED)


def _check_times(
    lines: Sequence[str], names: Sequence[str], separator: str, mark: str, step: float, file: Path, before: int
) -> None:
    """Refuse times of a channel that are others than those of the first, whatever the header says of the steps."""
    others = [i for i, name in enumerate(names) if name == "X_Value"][1:]
    for number, line in enumerate(lines if others else (), start=before + 1):
        cells = line.split(separator)
        for own in (cells[i] for i in others if i < len(cells) and cells[i] != cells[0] and cells[i] and cells[0]):
            if abs(_number(own, mark, file) - _number(cells[0], mark, file)) > _SAME_TIME * step:
                raise _apart(f"{file}, line {number}", f"{cells[0]} and {own} s")


def _rows(
    lines: Sequence[str], separator: str, kept: Sequence[int], mark: str, start: float, step: float
) -> Iterator[str]:
    """Rows of the table: time, then the channels; where no time is written it follows from the step."""
    count = 0
    for line in lines:
        cells = line.split(separator)
        if not line.strip():
            yield ""
            continue
        instant = cells[0] if cells[0].strip() else f"{start + count * step:.15g}".replace(".", mark)
        count += 1
        yield separator.join([instant, *(cells[i] for i in kept if i < len(cells))])
