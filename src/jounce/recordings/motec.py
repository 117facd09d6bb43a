"""MoTeC log files (``.ld``), and the lap markers beside them (``.ldx``).

MoTeC does not publish the format: the layout is that of the public parser gotzl/ldparser and of its descendants.
Numbers are little-endian. The header points to a linked list of channels (name, unit, rate, number type, offset of the
samples); a value is (number / scale / 10^decimals + shift) * multiplier.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np

from jounce.core.columns import Column
from jounce.core.errors import RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.markup import parse_xml
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import is_unit
from jounce.recordings.hdf5 import check_size, surplus
from jounce.recordings.laps import beacon_attributes

_MARK = 0x40
_CHANNEL = struct.Struct("<4I4H4h32s8s12s")
_SPACE = 84  # bytes of a channel in the list, at least; most programs write 124
_HEAD = 1636  # bytes up to the end of the comment
_POINTERS = struct.Struct("<II20xI")  # first channel, its samples, event; at byte 8
_FIELDS = {
    "date": (94, 16),
    "time_of_day": (126, 16),
    "driver": (158, 64),
    "vehicle": (222, 64),
    "venue": (350, 64),
    "comment": (1572, 64),
}
"""Texts of the header: first byte, and length."""
_EVENT = struct.Struct("<64s64s1024s")
_KINDS = {
    **{(family, 2): "<i2" for family in (0, 3, 5)},
    **{(family, 4): "<i4" for family in (0, 3, 5, 6)},
    (7, 2): "<f2",
    (7, 4): "<f4",
}
"""Number types by their two codes: family, and bytes of a number."""
_LONGEST_LDX = 5_000_000  # bytes
_MICROSECOND = 1e-6


@dataclass(frozen=True)
class Log:
    """Columns by clock, the first of each is time; texts of the header and lap markers; what was left out; findings."""

    clocks: tuple[tuple[Column, ...], ...]
    attributes: Mapping[str, object]
    left_out: tuple[str, ...]
    findings: tuple[Finding, ...]


def read_log(path: Path) -> Log:
    """Read all channels; damage of one channel is its fault or a problem, and the others are kept."""
    content = path.read_bytes()
    if len(content) < _HEAD or int.from_bytes(content[:4], "little") != _MARK:
        raise RecordingError(
            "not a MoTeC log file, or only its beginning",
            where=str(path),
            found=f"{len(content)} bytes, {content[:4].hex(' ')}",
            allowed=Phrase("at least {least} bytes, {begin}", least=_HEAD, begin="40 00 00 00"),
        )
    first, _, event = _POINTERS.unpack_from(content, 8)
    findings: list[Finding] = []
    clocks: dict[tuple[int, int], list[Column]] = {}
    left_out, taken = list[str](), 0
    channels = list(_channels(content, first, path, findings))
    names = [channel.name for channel in channels]
    for number, channel in enumerate(channels, 1):
        kind = _KINDS.get(channel.kind)
        if kind is None or not channel.rate or not channel.count:
            left_out.append(channel.name)
            continue
        width = np.dtype(kind).itemsize
        held = min(max(len(content) - channel.offset, 0) // width, channel.count)
        if held < channel.count:
            place = f"{path}: {channel.name}"
            findings.append(
                finding("recordings.cut_off", place, held, announced=channel.count, held=held)
            )
        if held < 2:
            left_out.append(channel.name)
            continue
        taken += held * width
        if taken > len(content):
            raise RecordingError(
                "channels share the same bytes: the file is damaged",
                where=f"{path}: {channel.name}",
                hint="Use an undamaged copy.",
            )
        check_size(taken // width, str(path))
        numbers = np.frombuffer(content, kind, held, channel.offset)
        name = channel.name
        if names.count(name) > 1:
            name = f"{name} ({number})"
        columns = clocks.setdefault((channel.rate, held), [])
        if not columns:
            time = np.asarray(np.arange(held) / channel.rate, dtype=float)
            columns.append(Column("time", "s", time, str(path)))
        columns.append(_column(name, channel, numbers, path))
    if not any(column.fault is None for columns in clocks.values() for column in columns[1:]):
        faults = [column.fault for columns in clocks.values() for column in columns if column.fault]
        if faults:
            raise faults[0]
        raise RecordingError(
            "no channel with samples", where=str(path), found=", ".join(left_out) or "no channel"
        )
    known = max(channel.offset + channel.count * channel.kind[1] for channel in channels)
    findings += surplus(known, len(content), str(path))
    attributes = _texts(content, event)
    beacons, remarks = _beacons(path)
    return Log(
        tuple(map(tuple, clocks.values())),
        attributes | beacons,
        tuple(left_out),
        (*findings, *remarks),
    )


@dataclass(frozen=True)
class _Channel:
    name: str
    unit: str
    rate: int  # Hz
    offset: int
    count: int
    kind: tuple[int, int]
    shift: int
    multiplier: int
    scale: int
    decimals: int


def _channels(
    content: bytes, place: int, path: Path, findings: list[Finding]
) -> Iterator[_Channel]:
    """Follow the list of channels; a link to a channel already read, or out of the file, ends it with a problem.

    Newer loggers write the unit into the field of the short name and leave the field of the unit empty.
    """
    seen, in_short = set[int](), list[str]()
    while place:
        is_loop = place in seen or len(seen) > len(content) // _SPACE
        if is_loop or place + _CHANNEL.size > len(content):
            code = "recordings.list_loops" if is_loop else "recordings.list_ends"
            findings.append(finding(code, str(path), place, place=place, count=len(seen)))
            break
        seen.add(place)
        (_, following, offset, count, _, family, width, rate, shift, multiplier, scale, decimals, name,
         short, unit) = _CHANNEL.unpack_from(content, place)  # fmt: skip
        own, own_short, own_unit = _text(name), _text(short), _text(unit)
        if not own_unit and own_short and is_unit(own_short):
            own_unit = own_short
            in_short.append(own)
        yield _Channel(
            own or own_short or f"channel {len(seen)}",
            own_unit,
            rate,
            offset,
            count,
            (family, width),
            shift,
            multiplier,
            scale,
            decimals,
        )
        place = following
    if in_short:
        names = ", ".join(in_short)
        findings.append(finding("recordings.units_in_short_names", str(path), names=names))


def _column(name: str, channel: _Channel, numbers: np.ndarray[Any, Any], path: Path) -> Column:
    """Return a channel in its unit; a scale or multiplier of 0, or absurd decimals, are its fault."""
    factors = {
        "scale": channel.scale,
        "multiplier": channel.multiplier,
        "decimals": abs(channel.decimals) <= 30,
    }
    wrong = next((factor for factor, value in factors.items() if not value), "")
    fault, values = None, np.empty(0)
    if wrong:
        fault = RecordingError(
            Phrase("impossible {factor}: the channel is damaged", factor=wrong),
            where=f"{path}: {name}",
            found=f"{getattr(channel, wrong)}",
            hint="Use an undamaged copy.",
        )
    else:
        values = _scaled(numbers, channel)
    return Column(name, channel.unit, values, str(path), fault)


def _scaled(numbers: np.ndarray[Any, Any], channel: _Channel) -> Array:
    divisor = channel.scale * 10.0**channel.decimals
    values = numbers.astype(float)
    if divisor != 1.0:
        values /= divisor
    if channel.shift:
        values += channel.shift
    if channel.multiplier != 1:
        values *= channel.multiplier
    return values


def _text(content: bytes) -> str:
    text = content.split(b"\0", 1)[0].decode("latin-1").strip()
    return text if text.isprintable() else ""


def _texts(content: bytes, event: int) -> dict[str, object]:
    """Return the texts of the header and of the event that are not empty."""
    texts = {key: _text(content[at : at + length]) for key, (at, length) in _FIELDS.items()}
    if 0 < event <= len(content) - _EVENT.size:
        name, session, comment = map(_text, _EVENT.unpack_from(content, event))
        texts |= {"event": name, "session": session, "event_comment": comment}
    return {key: text for key, text in texts.items() if text}


def _beacons(path: Path) -> tuple[dict[str, object], list[Finding]]:
    """Return the lap markers of the ``.ldx`` beside a log as attributes; one that cannot be read is a finding."""
    beside = next(
        (
            file
            for suffix in (".ldx", ".LDX", ".Ldx")
            if (file := path.with_suffix(suffix)).is_file()
        ),
        None,
    )
    if beside is None:
        return {}, []
    try:
        if beside.stat().st_size > _LONGEST_LDX:
            raise ValueError("more than 5 MB")
        root = parse_xml(beside.read_bytes())
        markers = [
            (float(marker.attrib["Time"]) * _MICROSECOND, marker.get("Name", ""))
            for group in root.iter("MarkerGroup")
            if group.get("Name", "").startswith("Beacon")
            for marker in group.iter("Marker")
        ]
    except (OSError, ValueError, LookupError, RecursionError, ET.ParseError) as error:
        reason = f"no {error}" if isinstance(error, KeyError) else str(error)
        return {}, [finding("recordings.no_beacons", str(beside), reason=reason)]
    return beacon_attributes(markers), []
