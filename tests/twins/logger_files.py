"""Files of loggers and test rigs, packed byte by byte from descriptions of the formats, without code of readers.

RPC III: table of keywords of MTS, as reprinted in the documentation of rpc3-file. MoTeC: layout in gotzl/ldparser. VBO:
manuals of Racelogic. SST: class ``RawTelemetryData`` of Sufni.Bridge.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence

import numpy as np


def rpc_file(
    channels: Sequence[tuple[str, str, np.ndarray]],
    step: float,
    *,
    kind: str = "FLOATING_POINT",
    form: str = "BINARY",
    frame: int = 64,
    group: int = 128,
    full: bool = True,
    scales: Sequence[float] = (),
    padding: str = "last",
    extra: Mapping[str, object] | None = None,
    lines: bool = False,
) -> bytes:
    """An RPC III time history: of each group, one channel after another."""
    samples = len(channels[0][2])
    frames = -(-samples // frame)
    scales = scales or [1.0] * len(channels)
    keys: dict[str, object] = {
        "FILE_TYPE": "TIME_HISTORY",
        "DATA_TYPE": kind,
        "CHANNELS": len(channels),
        "DELTA_T": f"{step:.6E}",
        "PTS_PER_FRAME": frame,
        "PTS_PER_GROUP": group,
        "FRAMES": frames,
        "DATE": "22-Feb-2000 10:20:11",
    }
    for number, ((name, unit, _), scale) in enumerate(zip(channels, scales, strict=True), 1):
        keys[f"DESC.CHAN_{number}"] = name
        keys[f"UNITS.CHAN_{number}"] = unit
        keys[f"SCALE.CHAN_{number}"] = repr(scale)
    keys |= extra or {}
    blocks = -(-(len(keys) + 3) // 4)
    keys = {"FORMAT": form, "NUM_HEADER_BLOCKS": blocks, "NUM_PARAMS": len(keys) + 3, **keys}
    if lines:
        head = "".join(f"{key} {value}\n" for key, value in keys.items()).encode()
    else:
        head = b"".join(
            struct.pack("32s96s", key.encode(), str(value).encode()) for key, value in keys.items()
        ).ljust(blocks * 512, b"\0")
    code = {"SHORT_INTEGER": "h", "FLOATING_POINT": "f"}[kind]
    order = ">" if form.endswith("BIG_END") else "<"
    body = b""
    for start in range(0, frames * frame, group):
        width = group if full else min(group, frames * frame - start)
        for (_, _, values), scale in zip(channels, scales, strict=True):
            piece = list(values[start : start + width] / scale)
            piece += [float(values[-1]) / scale if padding == "last" else 0.0] * (
                width - len(piece)
            )
            if code == "h":
                piece = [round(number) for number in piece]
            if form == "ASCII":
                body += " ".join(map(repr, map(float, piece))).encode() + b"\r\n"
            else:
                body += struct.pack(f"{order}{width}{code}", *piece)
    return head + body


def ld_file(
    channels: Sequence[tuple[str, str, int, tuple[int, int], np.ndarray]],
    *,
    numbers: Mapping[str, tuple[int, int, int, int]] | None = None,
    texts: Mapping[int, bytes] | None = None,
) -> bytes:
    """A MoTeC log: (name, unit, rate in Hz, number type, numbers); ``numbers``: shift, multiplier, scale, decimals."""
    kinds = {
        (7, 4): "f",
        (7, 2): "e",
        (3, 2): "h",
        (5, 4): "i",
        (0, 2): "h",
        (3, 4): "i",
        (9, 4): "f",
    }
    first, each = 1762, 124
    head = bytearray(first)
    struct.pack_into("<I", head, 0, 0x40)
    data = first + each * len(channels)
    struct.pack_into("<II", head, 8, first, data)
    for at, text in (texts or {}).items():
        head[at : at + len(text)] = text
    metas, bodies = b"", b""
    for number, (name, unit, rate, kind, values) in enumerate(channels):
        shift, multiplier, scale, decimals = (numbers or {}).get(name, (0, 1, 1, 0))
        here = first + number * each
        code = kinds[kind]
        stored = values if code in "fe" else [round(value) for value in values.tolist()]
        body = struct.pack(f"<{len(values)}{code}", *stored)
        metas += struct.pack(
            "<IIIIHHHHhhhh32s8s12s40x",
            here - each if number else 0,
            here + each if number + 1 < len(channels) else 0,
            data + len(bodies),
            len(values),
            0x2EE1 + number,
            *kind,
            rate,
            shift,
            multiplier,
            scale,
            decimals,
            name.encode(),
            name[:8].encode(),
            unit.encode(),
        )
        bodies += body
    return bytes(head) + metas + bodies


def ldx_text(beacons: Sequence[tuple[str, float]]) -> str:
    """Lap markers as MoTeC i2 stores them: microseconds."""
    rows = "".join(
        f'<Marker Version="100" ClassName="BCN" Name="{name}" Flags="77" Time="{1e6 * time:.17e}"/>\n'
        for name, time in beacons
    )
    return (
        '<?xml version="1.0"?>\n<LDXFile Locale="English" DefaultLocale="C" Version="1.6">\n<Layers><Layer>'
        f'<MarkerBlock><MarkerGroup Name="Beacons" Index="3">\n{rows}</MarkerGroup></MarkerBlock></Layer>'
        '<Details><String Id="Total Laps" Value="3"/></Details></Layers></LDXFile>\n'
    )


def vbo_text(
    rows: Sequence[str],
    *,
    names: str = "sats time lat long velocity heading height vert-vel Longacc Latacc",
    titles: Sequence[str] = (
        "satellites", "time", "latitude", "longitude", "velocity kmh", "heading", "height",
        "Vertical velocity kmh", "Long accel g", "Lat accel g",
    ),
    more: str = "",
) -> str:  # fmt: skip
    """A file of a VBOX as its manuals show it."""
    head = "\r\n".join(titles)
    return (
        f"File created on 08/07/2008 @ 11:18\r\n\r\n[header]\r\n{head}\r\n\r\n[channel units]\r\n\r\n"
        "[comments]\r\nVBMicro V01.00 Bld. 0011\r\nSerial Number : 00006999\r\n\r\n"
        f"[module Information]\r\n\r\n{more}[column names]\r\n{names}\r\n\r\n[data]\r\n"
        + "".join(f"{row}\r\n" for row in rows)
    )


def sst_file(
    fork: np.ndarray, shock: np.ndarray, rate: int, *, began: int = 1_700_000_000
) -> bytes:
    """Telemetry of Sufni, version 3: 16 bytes, then pairs of 16-bit numbers."""
    pairs = np.stack([fork, shock], axis=1).astype("<u2")
    return struct.pack("<3sBHHq", b"SST", 3, rate, 0, began) + pairs.tobytes()
