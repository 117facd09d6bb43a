"""LabVIEW TDMS files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import RecordingError
from jounce.core.optional import require
from jounce.recordings.readers.table import Reader, ReaderOptions, SignalTable, renamed


def read(path: Path, options: ReaderOptions) -> SignalTable:
    """Read the channels of one group (``options.variable``; the only one otherwise) with their ``unit_string``.

    Time is a channel of its own, or comes from the waveform properties ``wf_start_offset`` and ``wf_increment``.
    """
    nptdms = require("nptdms", "io")
    try:
        file = nptdms.TdmsFile.read(path)
    except Exception as error:  # noqa: BLE001 - nptdms raises bare ValueErrors, KeyErrors and struct errors alike
        raise RecordingError(f"not a TDMS file ({error})", where=str(path)) from None
    group = _group(file, options.variable, path)
    channels = [channel for channel in group.channels() if len(channel) > 1 and channel.dtype.kind in "fiu"]
    if not channels:
        raise RecordingError("no numeric channel", where=f"{path}: group {group.name!r}")
    columns = [_column(channel, path) for channel in channels]
    start, increments = 0.0, {float(c.properties["wf_increment"]) for c in channels if "wf_increment" in c.properties}
    if len(increments) > 1:
        raise RecordingError(
            "the channels have different sample times", where=str(path), found=f"{sorted(increments)} s", allowed="one"
        )
    if increments and not any(column.name == "time" for column in columns):
        start = float(channels[0].properties.get("wf_start_offset", 0.0))
        instants = np.asarray(start + np.arange(columns[0].values.size) * increments.pop(), dtype=float)
        columns.insert(0, Column("time", "s", instants, str(path)))
    return SignalTable(renamed(ColumnTable(tuple(columns), (), str(path)), options.header))


def _group(file: Any, name: str, path: Path) -> Any:
    groups = {group.name: group for group in file.groups()}
    if name in groups:
        return groups[name]
    if name or len(groups) != 1:
        raise RecordingError(
            f"no group {name!r}" if name else "not exactly one group",
            where=str(path),
            found=", ".join(sorted(groups)) or "none",
            hint="Say which one with variable.",
        )
    return next(iter(groups.values()))


def _column(channel: Any, path: Path) -> Column:
    return Column(
        channel.name, str(channel.properties.get("unit_string", "")), np.asarray(channel[:], dtype=float), str(path)
    )


READER = Reader(
    name="tdms",
    label="LabVIEW TDMS, one group",
    suffixes=(".tdms",),
    read=read,
    source="TDMS File Format Internal Structure, National Instruments",
    example="columns={'sprung.az': 'Accelerometer 1 [g]'}",
    extra="io",
)
