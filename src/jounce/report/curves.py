"""Signals as files beside a page: netCDF with everything, CSV for other programs."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from jounce.recordings.files import write_recording

if TYPE_CHECKING:
    import xarray as xr


def curve_files(name: str, signals: xr.Dataset) -> tuple[tuple[str, bytes], ...]:
    """Give a recording as ``curves/<name>.csv`` and ``curves/<name>.nc``, path and content each."""
    with tempfile.TemporaryDirectory(prefix="jounce-curves-") as folder:
        files = [write_recording(signals, Path(folder) / f"{name}{suffix}") for suffix in (".csv", ".nc")]
        return tuple((f"curves/{file.name}", file.read_bytes()) for file in files)
