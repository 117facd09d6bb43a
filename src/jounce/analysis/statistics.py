"""Statistics of each channel: level, range, distribution and drift, with the uncertainty of mean and r.m.s."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from jounce.analysis.record import (
    BEGIN,
    CHANNELS,
    END,
    AnyRecord,
    Measured,
    read_measured,
    select_channels,
)
from jounce.core.findings import Finding, finding
from jounce.core.operation import operation
from jounce.core.results import Shows, own_unit
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.identify.estimate import Estimate, estimate
from jounce.recordings.quality import check_channels

PIECES = 20
"""Number of pieces of a record whose scatter gives the uncertainty of mean and r.m.s.: 19 degrees of freedom."""
_UNEVEN = 3.0  # ratio of the highest r.m.s. of a piece to the median; Gaussian noise of 50 periods reaches 1.5
_DRIFT = (
    1.0  # change of the trend from end to end, in standard deviations; a pure straight line has 3.5
)


@dataclass(frozen=True)
class ChannelStatistics(Plain):
    """Level, range and distribution of one channel, in its unit.

    Attributes
    ----------
    channel, label, unit : str
        Name, label and SI unit of the channel.
    samples : int
        Number of samples (1).
    mean, rms : Estimate
        Mean and root mean square, with 95 % intervals from the scatter of 20 pieces; no interval for shorter records.
    standard_deviation : float
        Standard deviation about the mean.
    minimum, maximum : float
        Extremes.
    time_of_minimum, time_of_maximum : float
        Times of the extremes, s.
    crest_factor : float
        Largest deviation from the mean over the standard deviation (1); 1.41 for a sine.
    skewness, kurtosis : float
        Third and fourth standardised moment (1); 0 and 3 for Gaussian noise, 0 and 1.5 for a sine.
    crossings : float
        Upward crossings of the mean per second, Hz: the frequency of a sine.
    drift : float
        Change of the fitted straight line from the first to the last sample.
    """

    channel: Annotated[str, Shows("channel")]
    label: str
    unit: str
    samples: int
    mean: Annotated[Estimate, Shows("mean", own_unit)]
    rms: Annotated[Estimate, Shows("r.m.s.", own_unit)]
    standard_deviation: Annotated[float, Shows("standard deviation", own_unit)]
    minimum: Annotated[float, Shows("minimum", own_unit)]
    maximum: Annotated[float, Shows("maximum", own_unit)]
    time_of_minimum: float
    time_of_maximum: float
    crest_factor: Annotated[float, Shows("crest factor", "1")]
    skewness: Annotated[float, Shows("skewness", "1")]
    kurtosis: Annotated[float, Shows("kurtosis", "1")]
    crossings: Annotated[float, Shows("crossings per second", "Hz")]
    drift: Annotated[float, Shows("drift", own_unit)]

    @property
    def peak_to_peak(self) -> float:
        """Maximum minus minimum, in the unit of the channel."""
        return self.maximum - self.minimum


@dataclass(frozen=True)
class RecordStatistics(Plain):
    """Statistics of the selected channels, with findings about the sensors.

    Attributes
    ----------
    record : str
        File, or ``recording``.
    begin, end : float
        First and last instant, s.
    sample_rate : float
        Samples per second, Hz.
    channels : tuple of ChannelStatistics
        In the order of the record.
    findings : tuple of Finding
        Constant, clipped, frozen and drifting channels, and channels whose level changes.
    source : Measured
        The record they were computed from.
    """

    left_out = ("source",)
    record: str
    begin: Annotated[float, Shows("from", "s")]
    end: Annotated[float, Shows("to", "s")]
    sample_rate: Annotated[float, Shows("sample rate", "Hz")]
    channels: Annotated[tuple[ChannelStatistics, ...], Shows("Channels")]
    findings: tuple[Finding, ...]
    source: Measured

    def rows(self) -> list[dict[str, Any]]:
        """Return one row for each channel, SI."""
        return [_row(channel) for channel in self.channels]


@operation(
    "analyse statistics",
    named={"channels": "channel", "begin": "from", "end": "to"},
    offers=("numbers", "figure", "report"),
    page="jounce.report:statistics_page",
    title="Statistics of {record}",
    example="jounce analyse statistics lap.csv --figure channels.png",
)
def describe_channels(
    record: AnyRecord,
    channels: Annotated[Sequence[str] | str | None, CHANNELS] = None,
    *,
    begin: Annotated[float | str | None, BEGIN] = None,
    end: Annotated[float | str | None, END] = None,
) -> RecordStatistics:
    """Compute the statistics of each channel of a record.

    Parameters
    ----------
    record : Dataset, DataFrame, (Dataset, list of Finding), Path or str
        A recording, a table with columns ``name [unit]``, the result of `read_recording`, or a file.
    channels : sequence of str, optional
        Channels; all by default.
    begin, end : float or str, optional
        Section of the record to use, s or text with a unit.

    Returns
    -------
    RecordStatistics
        Each channel in its SI unit. Intervals assume that the pieces of the record are independent: the level must
        not change, and each piece must contain several periods.

    Raises
    ------
    RecordingError
        For an unreadable file, missing samples, time without constant steps, and unknown channels.

    Examples
    --------
    >>> import jounce as jn, numpy as np
    >>> t = np.arange(0.0, 10.0, 0.001)
    >>> wave = jn.recording(t, {"sprung.az": (2.0 * np.sin(2.0 * np.pi * 5.0 * t), "m/s^2", "")})
    >>> (found,) = jn.describe_channels(wave).channels
    >>> round(found.rms.value, 3), round(found.crest_factor, 3), round(found.crossings, 1)
    (1.414, 1.414, 5.0)
    """
    used = read_measured(record, begin, end)
    names = select_channels(used, channels)
    values = {name: used.values(name) for name in names}
    time = used.run["time"].to_numpy()
    rows = tuple(_statistics(used, name, signal, time) for name, signal in values.items())
    checked = () if used.findings else check_channels(values, where=used.name)
    doubts = [finding for row in rows for finding in _doubts(used, row, values[row.channel])]
    findings = (*used.findings, *checked, *doubts)
    return RecordStatistics(
        used.name, float(time[0]), float(time[-1]), used.rate, rows, findings, used
    )


def _statistics(used: Measured, name: str, signal: Array, time: Array) -> ChannelStatistics:
    low, high = int(signal.argmin()), int(signal.argmax())
    mean = float(signal.mean())
    away = signal - mean
    square = away * away
    variance = float(square.mean())
    deviation = variance**0.5
    is_still = deviation <= 1e-12 * abs(mean) or deviation == 0.0
    scale = 1.0 if is_still else deviation
    above = away > 0.0
    rising = int(np.count_nonzero(above[1:] & ~above[:-1]))
    steps = np.arange(signal.size) - 0.5 * (signal.size - 1)
    slope = float(steps @ away) / float(steps @ steps)
    return ChannelStatistics(
        name,
        used.label(name),
        used.unit(name),
        signal.size,
        _by_pieces(signal, mean),
        _root(_by_pieces(signal * signal, variance + mean**2)),
        deviation,
        float(signal[low]),
        float(signal[high]),
        float(time[low]),
        float(time[high]),
        0.0 if is_still else max(float(signal[high]) - mean, mean - float(signal[low])) / scale,
        0.0 if is_still else float(square @ away) / signal.size / scale**3,
        0.0 if is_still else float(square @ square) / signal.size / scale**4,
        0.0 if is_still else rising / used.duration,
        slope * (signal.size - 1),
    )


def _by_pieces(values: Array, mean: float) -> Estimate:
    """Estimate a mean, with its error from the scatter of the means of pieces."""
    count = values.size // PIECES
    if count < 2:
        return Estimate(mean)
    means = values[: count * PIECES].reshape(PIECES, count).mean(axis=1)
    return estimate(mean, float(means.std(ddof=1)) / PIECES**0.5, PIECES - 1)


def _root(square: Estimate) -> Estimate:
    value = max(square.value, 0.0) ** 0.5
    if square.interval is None or square.standard_error is None or value == 0.0:
        return Estimate(value)
    low, high = (max(end, 0.0) ** 0.5 for end in square.interval)
    return Estimate(value, 0.5 * square.standard_error / value, (low, high))


def _doubts(used: Measured, row: ChannelStatistics, signal: Array) -> list[Finding]:
    """Report changes of the level and drift."""
    at, doubts = f"{used.name}: {row.channel}", []
    if abs(row.drift) > _DRIFT * row.standard_deviation > 0.0:
        doubts.append(finding("analysis.drift", at, row.drift, drift=row.drift, unit=row.unit))
    count = signal.size // PIECES
    if count >= 2 and row.standard_deviation > 0.0:
        levels = (signal[: count * PIECES].reshape(PIECES, count) - row.mean.value).std(axis=1)
        usual, loudest = float(np.median(levels)), int(levels.argmax())
        if levels[loudest] > _UNEVEN * usual:
            step = count / used.rate
            level, begin = float(levels[loudest]), loudest * step
            doubts.append(
                finding(
                    "analysis.level_changes",
                    at,
                    level,
                    loudest=level,
                    usual=usual,
                    begin=begin,
                    end=begin + step,
                    unit=row.unit,
                )
            )
    return doubts


def _row(channel: ChannelStatistics) -> dict[str, Any]:
    plain = channel.to_dict()
    for name in ("mean", "rms"):
        given = plain[name]
        low, high = given["interval"] or (None, None)
        plain |= {name: given["value"], f"{name}_low": low, f"{name}_high": high}
    return {**plain, "peak_to_peak": channel.peak_to_peak}
