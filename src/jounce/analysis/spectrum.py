"""Power spectral densities of channels by Welch's method, with confidence intervals and significant peaks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from jounce.analysis.record import (
    BAND,
    BEGIN,
    CHANNELS,
    CONFIDENCE,
    END,
    SEGMENT,
    WINDOW,
    AnyRecord,
    Measured,
    band_of,
    constant_channels,
    read_measured,
    select_channels,
)
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.operation import operation
from jounce.core.phrases import Phrase
from jounce.core.results import Shows, own_unit
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.ride.spectra import WINDOWS, Spectrum, independent_segments, power_spectrum

LONGEST_SEGMENT = 8.0
"""Length (s) of the segments of a long record: the resolution is 0.19 Hz, at most half a body resonance's width."""
FEWEST_PARTS = 8
"""Number of segments of a short record without overlap; with overlap there are 15, with 28 degrees of freedom."""
_FEWEST_SAMPLES = 64  # four segments of the minimum length, 16 samples
_FEW_AVERAGES = 4.0  # below it, a 95 % interval spans a factor of 8
_CHANCE = 0.05  # probability that pure noise has a peak
_MOST_PEAKS = 6  # listed for a channel, the strongest ones


@dataclass(frozen=True)
class SpectralPeak(Plain):
    """A statistically significant peak of a spectrum.

    Attributes
    ----------
    frequency : float
        Centre of the range above half of its height, Hz.
    rms : float
        Root mean square of the peak, in the unit of the channel: of a sine, or of the middle of a resonance.
    ratio : float
        Ratio of its density to that of the neighbouring valley (1).
    """

    frequency: Annotated[float, Shows("frequency", "Hz")]
    rms: float
    ratio: Annotated[float, Shows("above the neighbouring valley", "1")]


@dataclass(frozen=True)
class ChannelSpectrum(Plain):
    """One-sided power spectral density of a channel.

    Attributes
    ----------
    channel, label, unit : str
        Name, label and SI unit of the channel.
    frequency : ndarray, shape (n,)
        Hz, within the band.
    density : ndarray, shape (n,)
        Unit of the channel squared per Hz.
    rms : float
        Root mean square within the band, in the unit of the channel.
    peaks : tuple of SpectralPeak
        By rising frequency.
    """

    channel: Annotated[str, Shows("channel")]
    label: str
    unit: str
    frequency: Array
    density: Array
    rms: Annotated[float, Shows("r.m.s. within the band", own_unit)]
    peaks: tuple[SpectralPeak, ...]


@dataclass(frozen=True)
class RecordSpectra(Plain):
    """Spectra of the channels of a record.

    Attributes
    ----------
    record : str
        File, or ``recording``.
    begin, end : float
        First and last instant, s.
    sample_rate : float
        Samples per second, Hz.
    band : (float, float)
        Frequency range of the densities, Hz.
    window : str
        Window of each segment.
    segment : float
        Length of the segments, s.
    resolution : float
        Noise bandwidth of the window, Hz.
    averages, degrees_of_freedom : float
        Number of independent segments averaged (1), and twice that number, for the chi-squared distribution.
    confidence : float
        Level of the intervals (1).
    interval : (float, float)
        Factors (1) by which a density is multiplied to get the ends of its interval.
    channels : tuple of ChannelSpectrum
        In the order of the record.
    findings : tuple of Finding
        Omitted channels, and limits of the spectra.
    """

    record: str
    begin: Annotated[float, Shows("from", "s")]
    end: Annotated[float, Shows("to", "s")]
    sample_rate: Annotated[float, Shows("sample rate", "Hz")]
    band: Annotated[tuple[float, float], Shows("band", "Hz")]
    window: Annotated[str, Shows("window")]
    segment: Annotated[float, Shows("segment", "s")]
    resolution: Annotated[float, Shows("resolution", "Hz")]
    averages: Annotated[float, Shows("independent segments", "1")]
    degrees_of_freedom: Annotated[float, Shows("degrees of freedom", "1")]
    confidence: Annotated[float, Shows("confidence", "%")]
    interval: Annotated[tuple[float, float], Shows("interval factors of a density", "1")]
    channels: Annotated[tuple[ChannelSpectrum, ...], Shows("Channels")]
    findings: tuple[Finding, ...]

    def rows(self) -> list[dict[str, Any]]:
        """Return one row for each frequency, with the density of each channel, SI."""
        if not self.channels:
            return []
        columns = {"frequency": self.channels[0].frequency}
        columns |= {channel.channel: channel.density for channel in self.channels}
        table = np.stack(list(columns.values()), axis=1).tolist()
        return [dict(zip(columns, row, strict=True)) for row in table]


@operation(
    "analyse spectrum",
    named={"channels": "channel", "begin": "from", "end": "to"},
    offers=("numbers", "figure", "report"),
    page="jounce.report:spectra_page",
    title="Spectra of {record}",
    example='jounce analyse spectrum lap.csv --channel sprung.az --band "0.5..30 Hz" --figure spectrum.png',
)
def estimate_spectra(
    record: AnyRecord,
    channels: Annotated[Sequence[str] | str | None, CHANNELS] = None,
    *,
    band: Annotated[tuple[float | str, float | str] | None, BAND] = None,
    segment: Annotated[float | str | None, SEGMENT] = None,
    window: Annotated[str, WINDOW] = "hann",
    confidence: Annotated[float, CONFIDENCE] = 0.95,
    begin: Annotated[float | str | None, BEGIN] = None,
    end: Annotated[float | str | None, END] = None,
) -> RecordSpectra:
    """Estimate the power spectral density of each channel by Welch's method, with its confidence interval.

    Parameters
    ----------
    record : Dataset, DataFrame, (Dataset, list of Finding), Path or str
        A recording, a table with columns ``name [unit]``, the result of `read_recording`, or a file.
    channels : sequence of str, optional
        Channels; all by default.
    band : (float, float), optional
        Lowest and highest frequency, Hz or text with a unit; by default the whole recorded range.
    segment : float or str, optional
        Length of the averaged segments, s or text with a unit; by default an eighth of the record, but at most 8 s.
    window : {"hann", "boxcar"}
        Hann segments overlap by half; boxcar segments do not.
    confidence : float
        Level of the intervals (1), between 0 and 1.
    begin, end : float or str, optional
        Section of the record to use, s or text with a unit.

    Returns
    -------
    RecordSpectra
        One-sided densities in SI: their integral over frequency is the mean square. Intervals hold for stationary
        Gaussian noise (chi-squared); the power of a sine has a smaller error.

    Raises
    ------
    RecordingError
        For an unreadable or too short record, missing samples, time without constant steps, unknown channels, a band
        outside the range of the record, and a segment longer than the record.
    DescriptionError
        For an unknown window, and a confidence outside (0, 1).

    References
    ----------
    bendat2010, section 8.5.

    Examples
    --------
    >>> import jounce as jn, numpy as np
    >>> t = np.arange(0.0, 60.0, 0.005)
    >>> wave = jn.recording(t, {"sprung.az": (3.0 * np.sin(2.0 * np.pi * 5.0 * t), "m/s^2", "")})
    >>> (found,) = jn.estimate_spectra(wave).channels
    >>> round(found.rms**2, 3), [round(peak.frequency, 2) for peak in found.peaks]    # 3^2 / 2
    (4.5, [5.0])
    """
    used = read_measured(record, begin, end)
    names = select_channels(used, channels)
    check_confidence(confidence)
    count = segment_samples(used, segment, FEWEST_PARTS)
    length = count / used.rate
    limits, notes = band_of(used, band, names, 0.0)
    moving, still = constant_channels(used, names)
    spectra = {
        name: power_spectrum(used.values(name), used.rate, segment=length, window=window)
        for name in moving
    }
    averages = independent_segments(used.run.sizes["time"], count, window)
    rows = tuple(_channel(used, name, spectrum, limits) for name, spectrum in spectra.items())
    few = finding("analysis.few_segments", used.name, averages, averages=averages, length=length)
    doubts = [few] if averages < _FEW_AVERAGES else []
    return RecordSpectra(
        used.name,
        float(used.run["time"][0]),
        float(used.run["time"][-1]),
        used.rate,
        limits,
        window,
        length,
        WINDOWS[window] / length,
        averages,
        2.0 * averages,
        confidence,
        chi_squared_factors(2.0 * averages, confidence),
        rows,
        (*used.findings, *still, *notes, *doubts),
    )


def check_confidence(confidence: float) -> None:
    """Raise an error for a confidence level outside (0, 1)."""
    if not 0.0 < confidence < 1.0:
        allowed = "between 0 and 1, such as 0.95"
        raise DescriptionError(
            "invalid confidence level", where="confidence", found=confidence, allowed=allowed
        )


def segment_samples(
    used: Measured, segment: float | str | None, parts: int, longest: float = LONGEST_SEGMENT
) -> int:
    """Number of samples in a segment; by default 1/``parts`` of the record, but at most ``longest`` seconds."""
    samples = used.run.sizes["time"]
    if samples < _FEWEST_SAMPLES:
        raise RecordingError(
            "the record is too short for a spectrum",
            where=used.name,
            found=f"{samples} samples",
            allowed=Phrase("at least {fewest_samples}", fewest_samples=_FEWEST_SAMPLES),
        )
    usual = min(max(samples // parts, _FEWEST_SAMPLES // 4), int(longest * used.rate))
    if segment is None:
        return usual
    length = to_si(segment, "s", where="segment")
    count = round(length * used.rate)
    if not _FEWEST_SAMPLES // 4 <= count <= samples:
        shortest = _FEWEST_SAMPLES // 4 / used.rate
        raise RecordingError(
            "the segment does not fit the record",
            where=f"{used.name}: segment",
            found=f"{length:g} s",
            allowed=Phrase(
                "{shortest:g} s to {samples:g} s, such as {usual:.3g} s",
                shortest=shortest,
                samples=samples / used.rate,
                usual=usual / used.rate,
            ),
        )
    return count


def chi_squared_factors(freedom: float, confidence: float) -> tuple[float, float]:
    """Factors from an estimate with ``freedom`` degrees of freedom to the ends of its interval.

    >>> [round(factor, 3) for factor in chi_squared_factors(10.0, 0.95)]
    [0.488, 3.08]
    """
    from scipy.stats import chi2

    tail = 0.5 * (1.0 - confidence)
    return float(freedom / chi2.ppf(1.0 - tail, freedom)), float(freedom / chi2.ppf(tail, freedom))


def _channel(
    used: Measured, name: str, spectrum: Spectrum, band: tuple[float, float]
) -> ChannelSpectrum:
    frequency = spectrum.frequency
    inside = (frequency >= band[0] * (1.0 - 1e-9)) & (frequency <= band[1] * (1.0 + 1e-9))
    rms = spectrum.mean_square(*band) ** 0.5
    peaks = spectral_peaks(spectrum, band)
    return ChannelSpectrum(
        name,
        used.label(name),
        used.unit(name),
        frequency[inside],
        spectrum.density[inside],
        rms,
        peaks,
    )


def spectral_peaks(spectrum: Spectrum, band: tuple[float, float]) -> tuple[SpectralPeak, ...]:
    """Find peaks above the neighbouring valleys by more than the random difference of two estimates of one density."""
    from scipy.signal import find_peaks
    from scipy.stats import f as f_distribution

    freedom = 2.0 * spectrum.averages
    # A peak and its valley are the extremes of many lines: every pair of lines is a chance to exceed the limit.
    least = float(
        np.log(f_distribution.isf(_CHANCE / len(spectrum.density) ** 2, freedom, freedom))
    )
    floor = float(spectrum.density.max()) * 1e-30
    density = np.maximum(spectrum.density, floor)
    density[:2], density[-1] = (
        density[2:9].min(),
        density[-2],
    )  # the mean was removed; the last line has half the degrees of freedom
    where, facts = find_peaks(np.log(density), prominence=least, distance=3)
    peaks = [
        _peak(spectrum, density, int(at), float(np.exp(rise)))
        for at, rise in zip(where, facts["prominences"], strict=True)
        if band[0] <= spectrum.frequency[at] <= band[1]
    ]
    apart: list[SpectralPeak] = []
    for peak in sorted(
        peaks, key=lambda peak: -peak.ratio
    ):  # the wider of two peaks contains the smaller one next to it
        # The main lobe of a Hann window is four lines wide, its resolution 1.5 lines.
        if all(
            abs(peak.frequency - other.frequency) > 2.0 * spectrum.resolution for other in apart
        ):
            apart.append(peak)
    strongest = sorted(apart, key=lambda peak: -peak.rms)[:_MOST_PEAKS]
    return tuple(sorted(strongest, key=lambda peak: peak.frequency))


def _peak(spectrum: Spectrum, density: Array, at: int, ratio: float) -> SpectralPeak:
    """Centre and level of a peak: the range where the density, smoothed over five lines, exceeds half its maximum."""
    smooth = np.convolve(density[max(at - _REACH, 0) : at + _REACH + 1], np.full(5, 0.2), "same")
    inner = min(at, _REACH)
    outside = np.flatnonzero(
        (smooth < 0.5 * smooth[inner]) | (smooth > 1.5 * smooth[inner])
    )  # or a higher peak
    first = max(int(outside[outside < inner].max(initial=-1)) + 1, 0)
    last = min(int(outside[outside > inner].min(initial=len(smooth))), len(smooth))
    lines = slice(max(at - inner + first, 0), at - inner + last)
    if last - first <= _NARROW:  # a sine: the main lobe of the window
        lines = slice(max(at - 2, 0), at + 3)
    f, step = spectrum.frequency[lines], spectrum.step
    centre = float(f @ spectrum.density[lines] / spectrum.density[lines].sum())
    return SpectralPeak(
        centre, spectrum.mean_square(float(f[0]) - step, float(f[-1]) + step) ** 0.5, ratio
    )


_NARROW = 7  # width of a smoothed sine, in lines
_REACH = 400  # lines on each side of a peak, 50 Hz in segments of 8 s
