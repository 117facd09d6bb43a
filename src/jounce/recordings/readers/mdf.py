"""ASAM MDF files (measurement data format, versions 3 and 4)."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import RecordingError
from jounce.core.optional import require
from jounce.recordings.readers.table import Reader, ReaderOptions, SignalTable, refuse_variable, renamed


def read(path: Path, options: ReaderOptions) -> SignalTable:
    """Read the numeric channels on the time axis that most channels share; bus frames are not decoded."""
    refuse_variable(path, options)
    asammdf = require("asammdf", "io")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with asammdf.MDF(path) as file:
                signals = [signal for signal in file.iter_channels(skip_master=True) if _is_numeric(signal)]
    except Exception as error:  # noqa: BLE001 - asammdf raises bare exceptions of many kinds
        raise RecordingError(f"not an MDF file ({error})", where=str(path)) from None
    if not signals:
        raise RecordingError("no numeric channel over time", where=str(path), hint="Decode bus frames first.")
    axes = [signal.timestamps.tobytes() for signal in signals]
    usual = max(axes, key=axes.count)
    kept = [signal for signal, axis in zip(signals, axes, strict=True) if axis == usual]
    columns = [Column("time", "s", np.asarray(kept[0].timestamps, dtype=float), str(path))]
    columns += [
        Column(signal.name, str(signal.unit or ""), np.asarray(signal.samples, dtype=float), str(path))
        for signal in kept
    ]
    left_out = tuple(signal.name for signal, axis in zip(signals, axes, strict=True) if axis != usual)
    return SignalTable(renamed(ColumnTable(tuple(columns), (), str(path)), options.header), left_out=left_out)


def _is_numeric(signal: Any) -> bool:
    return bool(signal.samples.ndim == 1 and signal.samples.dtype.kind in "fiu" and signal.samples.size > 1)


READER = Reader(
    name="mdf",
    label="ASAM MDF 3 or 4, channels on one time axis",
    suffixes=(".mf4", ".mdf", ".dat"),
    read=read,
    source="ASAM MDF 4.2",
    example="columns={'sprung.az': 'AccZ_body [g]'}",
    extra="io",
)
