"""Readers of measured files: one module each, one row each in ``READERS``."""

from __future__ import annotations

from jounce.recordings.readers import csv, mat, mdf, netcdf, tdms, uff
from jounce.recordings.readers.table import Reader, ReaderOptions, SignalTable

READERS: tuple[Reader, ...] = (csv.READER, netcdf.READER, mat.READER, tdms.READER, mdf.READER, uff.READER)
"""Every format that can be read, in the order of lists."""

__all__ = ["READERS", "Reader", "ReaderOptions", "SignalTable"]
