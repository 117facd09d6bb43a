"""Measured and simulated signals: one schema, readers, quality checks, sensors, filters, alignment."""

from __future__ import annotations

from jounce.recordings.files import read_columns, read_recording, write_recording
from jounce.recordings.quality import check_channels, check_time
from jounce.recordings.readers import READERS, Reader
from jounce.recordings.schema import channel_unit, check_recording, recording
from jounce.recordings.sensors import Sensor, apply_sensors, filter_signals
from jounce.recordings.signals import (
    band_limit,
    cfc_filter,
    derivative,
    estimate_lag,
    resample,
    shift_signals,
    shift_with_derivative,
)

__all__ = [
    "READERS",
    "Reader",
    "Sensor",
    "apply_sensors",
    "band_limit",
    "cfc_filter",
    "channel_unit",
    "check_channels",
    "check_recording",
    "check_time",
    "derivative",
    "estimate_lag",
    "filter_signals",
    "read_columns",
    "read_recording",
    "recording",
    "resample",
    "shift_signals",
    "shift_with_derivative",
    "write_recording",
]
