"""RPC III time histories of MTS: keywords in records of 128 bytes, and groups of numbers of one channel after another.

The layout follows the keyword table of MTS (as reprinted in the documentation of rpc3-file) and MTS's ``loadrpc.m``:
an integer times ``SCALE.CHAN_n`` is the value; ``HALF_FRAMES`` adds one frame, half of it at each end. Two keywords are
not of MTS: ``SAMPLES`` (of rpc3-file) is the number of samples before the last frame was filled up, and
``JOUNCE.START`` the time of the first sample (s).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

import numpy as np

from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import OutputError, RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.text import is_number
from jounce.core.types import Array
from jounce.recordings.hdf5 import announcement, check_size, surplus
from jounce.recordings.reader import SignalTable

SUFFIXES = (".rsp", ".rpc", ".rpc3", ".tim", ".drv")
FULL_SCALE = 32752
"""Largest integer that RPC III programs use."""
MOST_CHANNELS = 128
_KEY, _RECORD, _BLOCK = 32, 128, 512  # bytes
_MOST_BLOCKS = 1024  # of a header: four times what MTS allows
_FIRST = "FORMAT"
_ORDERS = {"BINARY": "<", "BINARY_IEEE_LITTLE_END": "<", "BINARY_IEEE_BIG_END": ">"}
_ASCII = "ASCII"
_KINDS = {"SHORT_INTEGER": "i2", "FLOATING_POINT": "f4", "DOUBLE_PRECISION": "f8"}
"""Number types; DOUBLE_PRECISION is an addition of FEDEM."""
_AT_ONCE = 1 << 23  # bytes read at a time
_NO_UNIT = ("NONE", "N/A", "-")
_FEWEST_PADDED = 8  # equal samples at the end of all channels that are taken for padding
_POINTS = 2048  # of a frame and a group when written: rpc-reader misreads groups that are not full of frames
_BLANKS = bytes.maketrans(b"\t\r\n\0", b"    ")


# --- reading


def read_rpc(path: Path) -> SignalTable:
    """Read time and all channels; of a file that was cut off the complete groups, with a problem."""
    size = path.stat().st_size
    with path.open("rb") as stream:
        head = stream.read(_MOST_BLOCKS * _BLOCK)
        keywords, start = _header(head, path)
        layout = _layout(keywords, path)
        scales = [_scale(number, keywords, layout, path) for number in layout.numbers]
        if layout.order:
            raw, held, findings = _binary(stream, start, size, layout, scales, path)
        else:
            stream.seek(start)
            raw, held, findings = _numbers_in_text(stream.read(), layout, scales, path)
    findings += _scales_of_floats(keywords, layout, path)
    columns = [
        Column(
            _name(number, keywords, layout),
            _unit(keywords.get(f"UNITS.CHAN_{number}", "")),
            values,
            str(path),
            scale if isinstance(scale, RecordingError) else None,
        )
        for number, values, scale in zip(layout.numbers, raw, scales, strict=True)
    ]
    samples, remarks = _without_padding(columns, held, keywords, layout, path)
    if layout.half_frames:
        remarks.append(
            finding("recordings.half_frames", str(path), points=layout.points_per_frame // 2)
        )
    if samples < held:
        columns = [column if column.fault else _shortened(column, samples) for column in columns]
    begin = _number(keywords, "JOUNCE.START", path) if "JOUNCE.START" in keywords else 0.0
    time = np.asarray(begin + np.arange(samples) * layout.step, dtype=float)
    attributes = {
        name: keywords[key]
        for key, name in (("DATE", "date"), ("OPERATION", "operation"), ("TIME_TYPE", "time_type"))
        if keywords.get(key)
    }
    table = ColumnTable((Column("time", "s", time, str(path)), *columns), (), str(path))
    return SignalTable(table, attributes=attributes, findings=(*findings, *remarks))


@dataclass(frozen=True)
class _Layout:
    channels: int
    points_per_frame: int
    points_per_group: int
    frames: int
    half_frames: bool
    step: float
    kind: str
    order: str  # empty: text

    @property
    def numbers(self) -> range:
        return range(1, self.channels + 1)

    @property
    def points(self) -> int:
        return (self.frames + self.half_frames) * self.points_per_frame

    @property
    def groups(self) -> int:
        return -(-self.points // self.points_per_group)


def _header(head: bytes, path: Path) -> tuple[dict[str, str], int]:
    """Return the keywords, and the byte at which the numbers start; records of 128 bytes, or lines of text."""
    if not head.upper().startswith(_FIRST.encode()):
        raise RecordingError(
            "not an RPC III file",
            where=str(path),
            found=repr(head[:16])[2:-1],
            allowed=Phrase("a file that begins with {first!r}", first=_FIRST),
        )
    if b"\0" in head[:_RECORD] or head[_RECORD : _RECORD + 3].upper() == b"NUM":
        return _records(head, path)
    return _lines(head, path)


def _text(content: bytes) -> str:
    text = content.split(b"\0", 1)[0].decode("latin-1").strip()
    return text[1:-1].strip() if len(text) > 1 and text[0] == text[-1] == '"' else text


def _records(head: bytes, path: Path) -> tuple[dict[str, str], int]:
    keywords = dict[str, str]()
    count = 3
    number = 0
    while number < count:
        record = head[number * _RECORD : (number + 1) * _RECORD]
        if len(record) < _RECORD:
            raise RecordingError(
                "the header is cut off",
                where=str(path),
                found=Phrase("{count} keywords", count=number),
                allowed=Phrase("{count} keywords", count=count),
            )
        key = _text(record[:_KEY]).upper()
        if key:
            keywords.setdefault(key, _text(record[_KEY:]))
        number += 1
        if number == 3:
            blocks = _count(keywords, "NUM_HEADER_BLOCKS", path, _MOST_BLOCKS)
            count = _count(keywords, "NUM_PARAMS", path, blocks * _BLOCK // _RECORD)
    return keywords, blocks * _BLOCK


def _lines(head: bytes, path: Path) -> tuple[dict[str, str], int]:
    keywords = dict[str, str]()
    start, count = 0, 3
    while len(keywords) < count:
        end = head.find(b"\n", start) + 1
        if not end:
            raise RecordingError(
                "the header is cut off",
                where=str(path),
                found=Phrase("{count} keywords", count=len(keywords)),
                allowed=Phrase("{count} keywords", count=count),
            )
        key, _, value = head[start:end].replace(b"=", b" ", 1).strip().partition(b" ")
        start = end
        if key:
            keywords.setdefault(_text(key).upper(), _text(value))
        if len(keywords) == 3:
            count = _count(keywords, "NUM_PARAMS", path, _MOST_BLOCKS * _BLOCK // _RECORD)
    return keywords, start


def _layout(keywords: Mapping[str, str], path: Path) -> _Layout:
    form = _value(keywords, _FIRST, path).upper()
    kind = keywords.get("DATA_TYPE", "SHORT_INTEGER").upper()
    _one_of(form, (*_ORDERS, _ASCII), f"{path}: {_FIRST}")
    _one_of(keywords.get("FILE_TYPE", "TIME_HISTORY"), ("TIME_HISTORY",), f"{path}: FILE_TYPE")
    _one_of(kind, tuple(_KINDS), f"{path}: DATA_TYPE")
    largest = 2**31 - 1
    half = keywords.get("HALF_FRAMES", "0").upper()
    layout = _Layout(
        channels=_count(keywords, "CHANNELS", path, 8 * MOST_CHANNELS),
        points_per_frame=_count(keywords, "PTS_PER_FRAME", path, largest),
        points_per_group=_count(keywords, "PTS_PER_GROUP", path, largest),
        frames=_count(keywords, "FRAMES", path, largest),
        half_frames=half in ("1", "YES"),
        step=_number(keywords, "DELTA_T", path),
        kind=_KINDS[kind],
        order=_ORDERS.get(form, ""),
    )
    if not 0.0 < layout.step < math.inf:
        raise RecordingError(
            Phrase("{what} is not positive", what="the sample time"),
            where=f"{path}: DELTA_T",
            found=keywords["DELTA_T"],
        )
    if layout.points_per_group % layout.points_per_frame:
        raise RecordingError(
            "a group does not consist of whole frames",
            where=f"{path}: PTS_PER_GROUP",
            found=f"{layout.points_per_group}, PTS_PER_FRAME {layout.points_per_frame}",
        )
    return layout


def _one_of(value: str, allowed: Sequence[str], where: str) -> None:
    if value not in allowed:
        raise RecordingError(
            "an RPC III file of a kind that jounce does not read",
            where=where,
            found=value,
            allowed=", ".join(allowed),
        )


def _value(keywords: Mapping[str, str], key: str, path: Path) -> str:
    if key not in keywords:
        raise RecordingError(
            Phrase("the header has no {key}", key=key),
            where=str(path),
            hint="Is the file complete?",
        )
    return keywords[key]


def _number(keywords: Mapping[str, str], key: str, path: Path) -> float:
    text = _value(keywords, key, path)
    try:
        number = float(text) if "_" not in text else math.nan
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise RecordingError(
            "not a finite number", where=f"{path}: {key}", found=text, allowed="a number"
        )
    return number


def _count(keywords: Mapping[str, str], key: str, path: Path, most: int, *, least: int = 1) -> int:
    number = _number(keywords, key, path)
    if not least <= number <= most or number != math.floor(number):
        raise RecordingError(
            "an impossible count: the file is damaged",
            where=f"{path}: {key}",
            found=keywords[key],
            allowed=Phrase("{least} to {most}", least=least, most=most),
        )
    return int(number)


def _binary(
    stream: BinaryIO,
    start: int,
    size: int,
    layout: _Layout,
    scales: Sequence[Scale],
    path: Path,
) -> tuple[list[Array], int, list[Finding]]:
    """Read the values of all channels, and the number of samples of each; channels with a fault are empty.

    The last group is full, or ends with the last frame; of a file that was cut off the full groups are read.
    """
    dtype = np.dtype(layout.order + layout.kind)
    points, width = layout.points, layout.points_per_group
    here = max(size - start, 0) // dtype.itemsize  # numbers in the file
    of_group = layout.channels * width
    tail = points - (layout.groups - 1) * width
    short = (layout.groups - 1) * of_group + layout.channels * tail
    findings: list[Finding] = []
    groups, last = layout.groups, width
    if here < layout.groups * of_group:
        is_short = tail < width and size - start in (
            short * dtype.itemsize,
            -(-short * dtype.itemsize // _BLOCK) * _BLOCK,  # the file ends with a whole block
        )
        last = tail if is_short else width
        groups = layout.groups if is_short else here // of_group
        if is_short:
            findings.append(finding("recordings.short_group", str(path), points=tail, group=width))
        points = points if is_short else min(points, groups * width)
        findings += announcement("FRAMES", layout.points, points, str(path))
    else:
        known = -(-layout.groups * of_group * dtype.itemsize // _BLOCK) * _BLOCK
        findings += surplus(start + known, size, str(path))
    check_size(points * layout.channels, str(path))
    raw = [np.empty(0 if isinstance(scale, RecordingError) else points) for scale in scales]
    stream.seek(start)
    full = groups - (last < width)
    at_once = max(1, _AT_ONCE // (of_group * dtype.itemsize))
    parts = [(done, min(at_once, full - done), width) for done in range(0, full, at_once)]
    if last < width:
        parts.append((full, 1, last))
    for done, many, own in parts:
        wanted = many * layout.channels * own
        numbers = np.frombuffer(stream.read(wanted * dtype.itemsize), dtype)
        if numbers.size < wanted:
            raise RecordingError("the file is being changed", where=str(path))
        shaped = numbers.reshape(many, layout.channels, own)
        begin = done * width
        for channel, (values, scale) in enumerate(zip(raw, scales, strict=True)):
            if isinstance(scale, RecordingError):
                continue
            piece, numbers = values[begin : begin + many * own], shaped[:, channel]
            if piece.size == numbers.size:
                piece = piece.reshape(many, own)
            else:
                numbers = numbers.reshape(-1)[: piece.size]
            with np.errstate(invalid="ignore"):  # NaN is refused by its row
                np.multiply(numbers, scale, out=piece)
    return raw, points, findings


def _numbers_in_text(
    content: bytes, layout: _Layout, scales: Sequence[Scale], path: Path
) -> tuple[list[Array], int, list[Finding]]:
    """Read numbers as text, in the order of binary files: of each group one channel after another."""
    lines = content[: _AT_ONCE // 64].splitlines()[:-1]
    widths = {len(line.translate(_BLANKS).split()) for line in lines if line.strip()}
    if widths == {layout.channels} != {1}:
        raise RecordingError(
            "rows with as many numbers as channels: rows of samples, or groups?",
            where=str(path),
            found=Phrase("{count} numbers a line", count=layout.channels),
            allowed="groups of PTS_PER_GROUP numbers of one channel after another",
            hint="Export the file as BINARY or as a table with a header.",
        )
    numbers = _parsed(content.translate(_BLANKS), path)
    of_group = layout.channels * layout.points_per_group
    tail = layout.points - (layout.groups - 1) * layout.points_per_group
    whole = (layout.groups - 1) * of_group
    findings: list[Finding] = []
    if numbers.size == whole + layout.channels * tail:
        width, groups = tail, layout.groups
    else:
        width, groups = layout.points_per_group, min(layout.groups, numbers.size // of_group)
        whole = (groups - 1) * of_group
        findings += announcement(
            "FRAMES", layout.points, min(layout.points, groups * width), str(path)
        )
        findings += surplus(layout.groups * of_group, numbers.size, str(path))
    full = numbers[: max(whole, 0)].reshape(-1, layout.channels, layout.points_per_group)
    last = numbers[whole : whole + layout.channels * width].reshape(layout.channels, width)
    points = min(layout.points, full.shape[0] * layout.points_per_group + width)
    raw = [
        np.empty(0)
        if isinstance(scale, RecordingError)
        else np.concatenate([full[:, channel].reshape(-1), last[channel]])[:points] * scale
        for channel, scale in enumerate(scales)
    ]
    return raw, points, findings


def _parsed(content: bytes, path: Path) -> Array:
    """Return numbers separated by blanks, converted in pieces: words take ten times the memory of their text."""
    pieces = [np.empty(0)]
    start = 0
    while start < len(content):
        end = content.find(b" ", start + _AT_ONCE // 8)
        words = content[start : end if end > 0 else None].split()
        try:
            values = np.array(words, dtype=float)
        except ValueError:
            values = None
        if values is None or b"_" in content[start : end if end > 0 else None]:
            texts = (word.decode("latin-1") for word in words)
            raise RecordingError(
                "text in a number column",
                where=str(path),
                found=next(text for text in texts if not is_number(text))[:80],
                allowed="a number with a decimal point",
            )
        pieces.append(values)
        start = end if end > 0 else len(content)
    return np.concatenate(pieces)


Scale = float | RecordingError
"""Factor of a channel, or its fault if the file has none."""


def _scale(number: int, keywords: Mapping[str, str], layout: _Layout, path: Path) -> Scale:
    """Return the factor of a channel's integers; a factor that is no number is a fault of this channel only."""
    key = f"SCALE.CHAN_{number}"
    if layout.kind != "i2":
        return 1.0
    try:
        scale = _number(keywords, key, path)
    except RecordingError as error:
        return error
    if scale == 0.0:
        return RecordingError("a scale of 0", where=f"{path}: {key}", allowed="any other number")
    return scale


def _unit(text: str) -> str:
    return "" if text.upper() in _NO_UNIT else text


def _name(number: int, keywords: Mapping[str, str], layout: _Layout) -> str:
    """Return the description of a channel, with its number if it is empty or not the only channel of that name."""
    names = [keywords.get(f"DESC.CHAN_{k}", "") for k in layout.numbers]
    own = names[number - 1]
    if not own:
        return f"channel {number}"
    return own if names.count(own) == 1 else f"{own} ({number})"


def _scales_of_floats(keywords: Mapping[str, str], layout: _Layout, path: Path) -> list[Finding]:
    """Warn if floating-point numbers have scales: no program applies them."""
    if layout.kind == "i2":
        return []
    scales = [keywords.get(f"SCALE.CHAN_{k}", "1") for k in layout.numbers]
    odd = [scale for scale in scales if not is_number(scale) or float(scale) != 1.0]
    return [finding("recordings.scale_of_floats", str(path), scale=odd[0])] if odd else []


def _without_padding(
    columns: Sequence[Column], held: int, keywords: Mapping[str, str], layout: _Layout, path: Path
) -> tuple[int, list[Finding]]:
    """Return the number of samples before the padding of the last frame: zeros, or the last values repeated.

    A longer rest belongs to the record: padding is shorter than a frame.
    """
    frame = layout.points_per_frame
    if "SAMPLES" in keywords:
        least = layout.points - frame + 1
        return min(_count(keywords, "SAMPLES", path, layout.points, least=least), held), []
    ends = [column.values[-frame:] for column in columns if not column.fault]
    if held < layout.points or not ends:
        return held, []
    equal = np.all([end == end[-1] for end in ends], axis=0)
    run = int(np.argmin(equal[::-1])) if not equal.all() else 0
    padded = run if all(end[-1] == 0.0 for end in ends) else run - 1
    if padded < _FEWEST_PADDED:
        return held, []
    return held - padded, [finding("recordings.padding", str(path), padded, count=padded)]


def _shortened(column: Column, samples: int) -> Column:
    return Column(column.name, column.unit, column.values[:samples], column.file)


# --- writing


def rpc_of(
    channels: Mapping[str, tuple[Array, str]], start: float, step: float, *, integers: bool
) -> tuple[bytes, dict[str, float]]:
    """Return an RPC III file of channels (values, unit), and the largest rounding error of each channel in its unit."""
    if not 1 <= len(channels) <= MOST_CHANNELS:
        raise OutputError(
            "more channels than an RPC III file can store",
            where="recording",
            found=str(len(channels)),
            allowed=Phrase("1 to {most}", most=MOST_CHANNELS),
        )
    samples = len(next(iter(channels.values()))[0])
    groups = -(-samples // _POINTS)
    dtype = np.dtype("<i2" if integers else "<f4")
    body = np.empty((groups, len(channels), _POINTS), dtype)
    keywords: dict[str, object] = {
        "FILE_TYPE": "TIME_HISTORY",
        "TIME_TYPE": "RESPONSE",
        "DATA_TYPE": "SHORT_INTEGER" if integers else "FLOATING_POINT",
        "DELTA_T": repr(step),
        "CHANNELS": len(channels),
        "PTS_PER_FRAME": _POINTS,
        "PTS_PER_GROUP": _POINTS,
        "FRAMES": groups,
        "SAMPLES": samples,
        "HALF_FRAMES": 0,
        "REPEATS": 1,
        "BYPASS_FILTER": 0,
        "INT_FULL_SCALE": FULL_SCALE,
        "PARTITIONS": 1,
        "PART.CHAN_1": 1,
        "PART.NCHAN_1": len(channels),
        "OPERATION": "jounce",
    }
    if start != 0.0:
        keywords["JOUNCE.START"] = repr(start)
    errors = dict[str, float]()
    for number, (name, (values, unit)) in enumerate(channels.items(), 1):
        if not np.isfinite(values).all():
            raise OutputError(
                "an RPC III file can store only finite numbers",
                where=name,
                found="NaN or infinity",
                hint="Leave the channel out, or write .nc.",
            )
        largest = float(np.abs(values).max())
        if largest > float(np.finfo(np.float32).max):
            raise OutputError(
                "a number that the file cannot store",
                where=name,
                found=f"{largest:g}",
                allowed="single precision",
            )
        scale = (largest / FULL_SCALE or 1.0) if integers else 1.0
        stored = np.rint(values / scale).astype(dtype) if integers else values.astype(dtype)
        errors[name] = float(np.abs(stored * scale - values).max())
        filled = np.full(groups * _POINTS, stored[-1], dtype)
        filled[:samples] = stored
        body[:, number - 1] = filled.reshape(groups, _POINTS)
        keywords |= {
            f"DESC.CHAN_{number}": name,
            f"UNITS.CHAN_{number}": unit,
            f"SCALE.CHAN_{number}": repr(scale),
            f"LOWER_LIMIT.CHAN_{number}": repr(float(values.min())),
            f"UPPER_LIMIT.CHAN_{number}": repr(float(values.max())),
            f"MAP.CHAN_{number}": number,
        }
    return _packed(keywords) + body.tobytes(), errors


def _packed(keywords: Mapping[str, object]) -> bytes:
    count = len(keywords) + 3
    blocks = -(-count * _RECORD // _BLOCK)
    first = {_FIRST: "BINARY_IEEE_LITTLE_END", "NUM_HEADER_BLOCKS": blocks, "NUM_PARAMS": count}
    records = [_record(key, str(value)) for key, value in {**first, **keywords}.items()]
    return b"".join(records).ljust(blocks * _BLOCK, b"\0")


def _record(key: str, value: str) -> bytes:
    width = _RECORD - _KEY
    try:
        text = value.encode("latin-1")
    except UnicodeEncodeError:
        text = b"\0"
    if b"\0" in text or len(text) >= width or text != text.strip() or text[:1] == b'"':
        raise OutputError(
            "a text that the file cannot store",
            where=key,
            found=value,
            allowed=Phrase("up to {most} Latin letters", most=width - 1),
            hint="Rename the channel.",
        )
    return key.encode().ljust(_KEY, b"\0") + text.ljust(width, b"\0")
