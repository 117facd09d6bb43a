"""The record to analyse: a Dataset, a table or a file, on uniform time, between two instants."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError, nearest
from jounce.core.findings import Finding, finding
from jounce.core.operation import Band, MadeBy, Mark, Number, Texts
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.recordings import read_recording
from jounce.recordings.carried import as_recording
from jounce.recordings.quality import FEWEST_SAMPLES, check_instants, check_time
from jounce.recordings.schema import describe

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

AnyRecord: TypeAlias = Annotated[
    "xr.Dataset | pd.DataFrame | tuple[xr.Dataset, list[Finding]] | Measured | Path | str",
    MadeBy(
        "jounce.recordings.options:chosen_recording",
        "jounce.recordings.options:recording_in_python",
    ),
]
"""A recording, with or without its findings, a table, or a file; commands and forms take a file and its columns."""
CHANNELS = Texts("Channel; all by default. May be repeated.", "CHANNEL")
BEGIN = Number('Ignore samples before this time, e.g. "1.2 s".', "TIME", "s")
END = Number("Ignore samples after this time.", "TIME", "s")
BAND = Band(
    'Frequency range to analyse, e.g. "0.5..30 Hz"; by default the whole recorded range.',
    "LOW..HIGH",
    "Hz",
)
SEGMENT = Number("Length of the averaged segments.", "TIME", "s", is_positive=True)
WINDOW = Mark("hann or boxcar.", "WINDOW")
CONFIDENCE = Number("Level of the intervals, between 0 and 1.", "LEVEL", "1")
ANTI_ALIAS_SHARE = 0.4
"""Fraction of its own sample rate up to which a channel is used; above it, anti-alias filters roll off."""


@dataclass(frozen=True)
class Measured:
    """A record on uniform time.

    Attributes
    ----------
    run : xarray.Dataset
        Channels over ``time`` (s).
    name : str
        File, or ``recording``.
    rate : float
        Samples per second, Hz.
    findings : tuple of Finding
        Findings from reading the file.
    """

    run: xr.Dataset
    name: str
    rate: float
    findings: tuple[Finding, ...] = ()

    @property
    def duration(self) -> float:
        """Time from the first to the last sample, s."""
        return (self.run.sizes["time"] - 1) / self.rate

    @property
    def names(self) -> list[str]:
        """Names of the real-valued channels over time."""
        return [
            str(name)
            for name, values in self.run.data_vars.items()
            if values.dims == ("time",) and _is_number(values)
        ]

    def unit(self, name: str) -> str:
        """SI unit of a channel."""
        return str(self.run[name].attrs.get("units", "1"))

    def label(self, name: str) -> str:
        """Label of a channel."""
        return str(self.run[name].attrs.get("long_name") or describe(name))

    def values(self, name: str) -> Array:
        """Samples of a channel, shape (n,), in its unit; raises an error if some are missing."""
        values = np.asarray(self.run[name].to_numpy(), dtype=float)
        refuse_gaps(self.run["time"].to_numpy(), values, where=f"{self.name}: {name}")
        return values

    def highest_frequency(self, name: str) -> float:
        """Frequency (Hz) up to which a channel was recorded: half its own sample rate if that was lower."""
        own = self.run[name].attrs.get("recorded_rate")
        return (
            0.5 * self.rate if own is None else min(0.5 * self.rate, ANTI_ALIAS_SHARE * float(own))
        )


def read_measured(
    record: AnyRecord, begin: float | str | None = None, end: float | str | None = None
) -> Measured:
    """Read or accept a record, and cut it to a section of time (s).

    Raises
    ------
    RecordingError
        For a file that cannot be read, time with gaps or without constant steps, and an empty section.
    """
    whole = record if isinstance(record, Measured) else _read(record)
    if begin is None and end is None:
        return whole
    time = whole.run["time"].to_numpy()
    low = float(time[0]) if begin is None else to_si(begin, "s", where="begin")
    high = float(time[-1]) if end is None else to_si(end, "s", where="end")
    slack = 1e-6 / whole.rate
    inside = np.flatnonzero((time >= low - slack) & (time <= high + slack))
    if inside.size < FEWEST_SAMPLES:
        raise RecordingError(
            "the section has too few samples",
            where=whole.name,
            found=f"{inside.size} from {low:g} s to {high:g} s",
            allowed=Phrase(
                "at least {fewest_samples}, from {time:g} s to {second_time:g} s",
                fewest_samples=FEWEST_SAMPLES,
                time=time[0],
                second_time=time[-1],
            ),
        )
    return Measured(
        whole.run.isel(time=slice(inside[0], inside[-1] + 1)),
        whole.name,
        whole.rate,
        whole.findings,
    )


def _read(record: Any) -> Measured:
    run, findings = read_recording(record) if isinstance(record, str | Path) else (record, ())
    if isinstance(run, tuple):
        run, findings = run
    given = as_recording(run)
    return from_recording(given, str(given.encoding.get("source", "recording")), tuple(findings))


def from_recording(run: xr.Dataset, name: str, findings: tuple[Finding, ...] = ()) -> Measured:
    """Accept a recording whose time must be uniform."""
    if "time" not in run.coords:
        raise RecordingError("no time coordinate", where=name, allowed="a coordinate 'time' in s")
    time = np.asarray(run["time"].to_numpy(), dtype=float)
    steps = check_instants(time, where=name)
    rate = (time.size - 1) / float(time[-1] - time[0])
    if np.ptp(steps) * rate > _EVEN and check_time(time, where=name)[1]:
        hint = "Read the file with resample, or resample the recording to constant steps."
        raise RecordingError("the time steps are not uniform", where=name, hint=hint)
    return Measured(run, name, rate, findings)


_EVEN = 1e-9  # of a step: smaller differences of steps need no further check


def select_channels(record: Measured, names: Sequence[str] | str | None) -> list[str]:
    """Names of the channels to analyse: those given, in one text or several; all channels by default."""
    present = record.names
    if names is None or not len(names):
        if not present:
            raise RecordingError("no channel varies over time", where=record.name)
        return present
    texts = [names] if isinstance(names, str) else names
    wanted = [part.strip() for text in texts for part in text.split(",") if part.strip()] or [""]
    for name in wanted:
        check_channel(record, name)
    return list(dict.fromkeys(wanted))


def check_channel(record: Measured, name: str) -> str:
    """Return the name of a channel; raise an error if the record does not have it."""
    if name not in record.names:
        names = record.names
        raise RecordingError(
            Phrase("no channel {name!r}", name=name),
            where=record.name,
            found=", ".join(names),
            hint=nearest(name, names),
        )
    return name


def band_of(
    record: Measured,
    band: tuple[float | str, float | str] | None,
    names: Sequence[str],
    lowest: float,
) -> tuple[tuple[float, float], list[Finding]]:
    """Frequencies (Hz) to analyse: the requested ones, limited to the band in which all channels were recorded."""
    tops = {name: record.highest_frequency(name) for name in names}
    top = min(tops.values(), default=0.5 * record.rate)
    low, high = (lowest, top) if band is None else (to_si(end, "Hz", where="band") for end in band)
    if not 0.0 <= low < high or low >= top:
        raise RecordingError(
            "the band contains no frequency of the record",
            where=f"{record.name}: band",
            found=f"{low:g} Hz to {high:g} Hz",
            allowed=Phrase("two frequencies from 0 to {top:g} Hz", top=top),
        )
    slow = [
        name
        for name in names
        if tops[name] < min(high if band else 0.5 * record.rate, 0.5 * record.rate)
    ]
    findings = []
    if high > top * (1.0 + 1e-9) or slow:
        channels = ", ".join(slow) or "the record"
        findings = [finding("analysis.band_ends", record.name, top, channels=channels, highest=top)]
    return (max(low, 0.0), min(high, top)), findings


def constant_channels(record: Measured, names: Sequence[str]) -> tuple[list[str], list[Finding]]:
    """Channels that are not constant, and a warning for each constant one."""
    moving, findings = [], []
    for name in names:
        values = record.values(name)
        spread = float(np.ptp(values))
        if spread <= _STILL * max(abs(float(values[0])), np.finfo(float).tiny):
            level = float(values[0])
            findings.append(
                finding("analysis.constant", f"{record.name}: {name}", level, level=level)
            )
        else:
            moving.append(name)
    return moving, findings


_STILL = 1e-12  # relative to the values: rounding error


def _is_number(variable: Any) -> bool:
    return variable.dtype.kind in "fiu"


def band_text(band: tuple[float, float]) -> str:
    """Write a frequency band in words.

    >>> band_text((0.5, 30.0))
    '0.5 to 30 Hz'
    """
    return f"{band[0]:.3g} to {band[1]:.4g} Hz"


def frequency_ranges(frequency: Array, condition: NDArray[np.bool_]) -> list[tuple[float, float]]:
    """First and last frequency of each range in which a condition, shape (n,), is true; the widest first.

    >>> frequency_ranges(np.array([1.0, 2.0, 3.0, 4.0]), np.array([True, False, True, True]))
    [(3.0, 4.0), (1.0, 1.0)]
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[0], condition.astype(np.int8), [0]])))
    ranges = [
        (float(frequency[a]), float(frequency[b - 1]))
        for a, b in zip(edges[::2], edges[1::2], strict=True)
    ]
    return sorted(ranges, key=lambda ends: ends[0] - ends[1])


def refuse_gaps(time: Array, values: Array, *, where: str) -> None:
    """Raise RecordingError if samples are missing (NaN or infinite), with the time (s) of the first."""
    lost = np.flatnonzero(~np.isfinite(values))
    if lost.size:
        raise RecordingError(
            Phrase(
                "{size} of {second_size} samples are missing",
                size=lost.size,
                second_size=values.size,
            ),
            where=where,
            found=f"the first at {float(time[lost[0]]):.6g} s",
            allowed="numbers only",
            hint="Choose a section without gaps (begin, end), or read the file with resample.",
        )
