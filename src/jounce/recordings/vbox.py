"""Racelogic VBO: text with sections; latitude and longitude in minutes, time of day as HHMMSS.ss.

Per the VBOX manuals, latitude is positive to the north and **longitude positive to the west**, both in minutes;
velocity is in km/h unless ``[header]`` states another unit. Positions become degrees, positive to the north and *east*,
and times seconds since the first row. Lap markers are the instants at which the track crosses the line ``Start`` of
``[laptiming]``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np

from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import RecordingError, at_line
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.text import is_number
from jounce.core.types import Array
from jounce.core.units import is_unit
from jounce.recordings.laps import beacon_attributes
from jounce.recordings.reader import SignalTable

_SECTION = re.compile(r"\[([^\[\]]{1,60})\]\s*")
_USUAL = {
    "sats": "1",
    "satellites": "1",
    "velocity": "km/h",
    "heading": "deg",
    "height": "m",
    "vert-vel": "km/h",
    "vertvel": "km/h",
    "longacc": "g",
    "latacc": "g",
}
"""Units of the usual columns, per the VBOX manuals, where the file states none."""
_TIME, _LATITUDE, _LONGITUDE = ("time",), ("lat", "latitude"), ("long", "longitude")
_FIXED = (*_TIME, *_LATITUDE, *_LONGITUDE)
_QUANTITIES = ("velocity", "speed", "accel", "acceleration", "heading", "height", "altitude")
"""Last words of titles without a unit: ``vertical velocity``."""
_MINUTES = 60.0
_DAY = 86400.0
_NEAR = 180.0  # minutes: positions so close to 0 N 0 E are probably in degrees


def read_vbo(text: str, path: Path) -> SignalTable:
    """Read the rows of ``[data]``, named by ``[column names]``, with the units of ``[header]``."""
    lines = text.splitlines()
    sections = _sections(lines)
    for needed in ("column names", "data"):
        if needed not in sections:
            raise RecordingError(
                "not a VBO file, or only a part of it",
                where=str(path),
                found=", ".join(f"[{name}]" for name in sections) or "no section",
                allowed="[column names] and [data]",
            )
    names = " ".join(lines[slice(*sections["column names"])]).replace(",", " ").split()
    if not names:
        raise RecordingError("the column names are missing", where=f"{path}: [column names]")
    begin, end = sections["data"]
    table, findings = _rows(lines[begin:end], begin + 1, names, path, text.endswith(("\n", "\r")))
    units = _units(names, lines, sections)
    columns = list[Column]()
    for position, (name, unit) in enumerate(zip(names, units, strict=True)):
        label = name if names.count(name) == 1 else f"{name} ({position + 1})"
        columns.append(_column(label, unit, table[:, position], path))
    findings += _degrees(table, names, path)
    attributes = _comments(lines, sections)
    attributes |= _laps(lines, sections, columns)
    return SignalTable(
        ColumnTable(tuple(columns), (), str(path)), attributes=attributes, findings=tuple(findings)
    )


def _sections(lines: Sequence[str]) -> dict[str, tuple[int, int]]:
    """Return the first and last line of each section's content, by its name; the first section of a name counts."""
    heads = [
        (i, match[1].strip().lower())
        for i, line in enumerate(lines)
        if line[:1] == "[" and (match := _SECTION.fullmatch(line.strip()))
    ]
    sections = dict[str, tuple[int, int]]()
    for (i, name), (end, _) in pairwise([*heads, (len(lines), "")]):
        sections.setdefault(name, (i + 1, end))
    return sections


def _rows(
    lines: Sequence[str], first: int, names: Sequence[str], path: Path, is_whole: bool
) -> tuple[Array, list[Finding]]:
    """Return the numbers of all rows; the last row of a file that was cut off is left out, with a problem.

    Loggers write rows of one width: a shorter last row without an end of line lost cells or digits.
    """
    rows = [(line, i) for i, line in enumerate(lines, first) if line.strip()]
    findings: list[Finding] = []
    if len(rows) > 1 and not is_whole and len(rows[-1][0]) < len(rows[-2][0]):
        rows.pop()
        findings.append(finding("recordings.row_cut_off", str(path)))
    if len(rows) < 2:
        raise RecordingError("no rows", where=f"{path}: [data]", found=str(len(rows)))
    try:
        table = np.loadtxt([line for line, _ in rows], comments=None, ndmin=2)
    except ValueError:
        table = np.empty((0, 0))
    if table.shape != (len(rows), len(names)):
        for line, number in rows:
            cells = line.split()
            if len(cells) != len(names):
                raise RecordingError(
                    "the row does not have as many cells as the header",
                    where=at_line(path, number),
                    found=f"{len(cells)} cells",
                    allowed=Phrase(
                        "{columns} cells ({header})", columns=len(names), header=", ".join(names)
                    ),
                )
            for cell, name in zip(cells, names, strict=True):
                if not is_number(cell):
                    raise RecordingError(
                        "text in a number column",
                        where=f"{at_line(path, number)}: {name}",
                        found=cell[:80],
                        allowed="a number",
                    )
        raise RecordingError("no rows", where=f"{path}: [data]")
    return np.asarray(table, dtype=float), findings


def _units(
    names: Sequence[str], lines: Sequence[str], sections: Mapping[str, tuple[int, int]]
) -> list[str]:
    """Return the unit of each column: of ``[channel units]``, of its line of ``[header]``, or the usual one.

    ``[channel units]`` has a line for each of the last columns, those that are no usual columns. An empty line is an
    unknown unit; as columns may be usual that jounce does not know, only the right number of lines tells whose it is.
    A unit that jounce cannot read is unknown, too, rather than the usual one.
    """

    def content(section: str) -> list[str]:
        return [line.strip() for line in lines[slice(*sections.get(section, (0, 0)))]]

    titles, stated = [title for title in content("header") if title], content("channel units")
    units = [_USUAL.get(name.lower(), "") for name in names]
    if len(titles) == len(names):
        for i, title in enumerate(titles):
            *before, last = title.split()
            if before and last.lower() not in _QUANTITIES:
                units[i] = _unit(last)
    if stated and not stated[-1]:
        stated.pop()  # the end of the section
    is_special = [name.lower() not in (*_USUAL, *_FIXED) for name in names]
    if len(stated) <= len(names) and (all(stated) or len(stated) == sum(is_special)):
        for i, unit in enumerate(stated, len(names) - len(stated)):
            units[i] = _unit(unit)
    return units


def _unit(text: str) -> str:
    """Return a unit as written or in lower case (``Knots``), or nothing if neither is a unit."""
    return next((unit for unit in (text, text.lower()) if is_unit(unit)), "")


def _column(name: str, unit: str, values: Array, path: Path) -> Column:
    plain = name.lower()
    if plain in _TIME:
        return _clock(values, path)
    if plain in _LATITUDE:
        return Column(name, "deg", values / _MINUTES, str(path))
    if plain in _LONGITUDE:
        return Column(name, "deg", -values / _MINUTES, str(path))
    return Column(name, unit, np.ascontiguousarray(values), str(path))


def _clock(values: Array, path: Path) -> Column:
    """Convert HHMMSS.ss to seconds since the first row; the clock may pass midnight."""
    hours, rest = np.divmod(values, 10000.0)
    minutes, seconds = np.divmod(rest, 100.0)
    wrong = ~((values >= 0.0) & (hours < 24.0) & (minutes < 60.0) & (seconds < 60.0))
    if wrong.any():
        row = int(np.argmax(wrong))
        fault = RecordingError(
            "not a time of day",
            where=f"{path}: [data], row {row + 1}: time",
            found=f"{values[row]:.10g}",
            allowed="HHMMSS.ss",
        )
        return Column("time", "s", np.empty(0), str(path), fault)
    elapsed = 3600.0 * hours + 60.0 * minutes + seconds
    nights = np.concatenate(([0.0], np.cumsum(np.diff(elapsed) < -0.5 * _DAY)))
    return Column("time", "s", (elapsed - elapsed[0] + _DAY * nights).round(6), str(path))


def _degrees(table: Array, names: Sequence[str], path: Path) -> list[Finding]:
    """Warn of positions near 0 N 0 E: some programs write degrees in place of minutes."""
    places = {
        key: next((i for i, name in enumerate(names) if name.lower() in key), None)
        for key in (_LATITUDE, _LONGITUDE)
    }
    if None in places.values():
        return []
    largest = [float(np.abs(table[:, i]).max()) for i in places.values() if i is not None]
    if max(largest) > _NEAR or max(largest) == 0.0:
        return []
    return [finding("recordings.degrees_for_minutes", str(path), largest[0], latitude=largest[0])]


def _comments(lines: Sequence[str], sections: Mapping[str, tuple[int, int]]) -> dict[str, object]:
    attributes: dict[str, object] = {}
    if lines and lines[0].startswith("File created"):
        attributes["created"] = lines[0].removeprefix("File created").strip()
    texts = (line.strip() for line in lines[slice(*sections.get("comments", (0, 0)))])
    comments = "; ".join(text for text in texts if text and text.isprintable())
    return attributes | ({"comments": comments[:1000]} if comments else {})


def _laps(
    lines: Sequence[str], sections: Mapping[str, tuple[int, int]], columns: Sequence[Column]
) -> dict[str, object]:
    """Return the instants at which the track crosses the start line; nothing without line, position or time."""
    by_name = {column.name.lower(): column for column in columns if column.fault is None}
    time = by_name.get("time")
    north = next((by_name[name] for name in _LATITUDE if name in by_name), None)
    east = next((by_name[name] for name in _LONGITUDE if name in by_name), None)
    if time is None or north is None or east is None:
        return {}
    for line in lines[slice(*sections.get("laptiming", (0, 0)))]:
        word, *cells = line.split()[:5] or [""]
        if word.lower() == "start" and len(cells) == 4 and all(map(is_number, cells)):
            west, latitude, other_west, other = (float(cell) / _MINUTES for cell in cells)
            at = crossings(
                time.values, east.values, north.values, ((-west, latitude), (-other_west, other))
            )
            return beacon_attributes([(instant, "") for instant in at.tolist()])
    return {}


def crossings(
    time: Array, east: Array, north: Array, line: tuple[tuple[float, float], tuple[float, float]]
) -> Array:
    """Return the instants (s) at which a track crosses a line between two points (degrees east, degrees north).

    >>> crossings(np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0, 2.0]), np.zeros(3), ((0.25, -1.0), (0.25, 1.0)))
    array([0.25])
    """
    (east_a, north_a), (east_b, north_b) = line
    squeeze = math.cos(math.radians(north_a))  # a degree of longitude is shorter
    along = np.array([(east_b - east_a) * squeeze, north_b - north_a])
    length = float(along @ along)
    if not 0.0 < length < math.inf:
        return np.empty(0)
    points = np.stack([(east - east_a) * squeeze, north - north_a], axis=1)
    side = points[:, 0] * along[1] - points[:, 1] * along[0]
    share_along = points @ along / length
    change = np.flatnonzero((side[:-1] <= 0.0) != (side[1:] <= 0.0))
    part = side[change] / (side[change] - side[change + 1])
    place = share_along[change] + part * (share_along[change + 1] - share_along[change])
    at = time[change] + part * (time[change + 1] - time[change])
    return np.asarray(at[(place >= 0.0) & (place <= 1.0)], dtype=float)
