"""Transfer function and coherence between two measured channels, with random errors, compared with a linear model."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray

from jounce.analysis.options import ComparedRig
from jounce.analysis.record import (
    BAND,
    BEGIN,
    CONFIDENCE,
    END,
    SEGMENT,
    WINDOW,
    AnyRecord,
    Measured,
    band_of,
    check_channel,
    constant_channels,
    frequency_ranges,
    read_measured,
)
from jounce.analysis.spectrum import check_confidence, segment_samples
from jounce.core.errors import RecordingError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.operation import Mark, operation
from jounce.core.phrases import Phrase
from jounce.core.results import Shows
from jounce.core.serialise import Plain, plain_table
from jounce.core.types import Array
from jounce.identify.estimate import student_factor
from jounce.parts import Rig, as_rig
from jounce.ride.spectra import (
    WINDOWS,
    cross_spectrum,
    independent_segments,
    power_spectrum,
    relative_error,
)
from jounce.simulation.linear_model import LinearModel, linearise

Estimator: TypeAlias = Literal["H1", "H2", "Hv"]
FEWEST_PARTS = 8
"""Number of segments of a short record, without overlap: the error of gains is 19 % where the coherence is 1/2."""
LOW_COHERENCE = 0.5
"""Below it, less than half of the output follows the input: errors of the gain reach 13 % even with 30 segments."""
_FEWEST_AVERAGES = 2.0  # a single segment has coherence 1, whatever it contains
_SELDOM = 0.02  # fraction of the band that may lack coherence without a finding: lines at its ends
_KNOWN = 0.1  # largest relative error of a gain whose peaks are examined
_BIAS = 0.05  # of a peak's height: a larger loss due to the segments is reported
_EXCITED = 1e-3  # of the largest neighbouring power of the input; below is noise of 10 bits


@dataclass(frozen=True)
class TransferEstimate(Plain):
    """Transfer function between two channels.

    Attributes
    ----------
    record : str
        File, or ``recording``.
    output, given : str
        Channels of output and input.
    output_unit, given_unit : str
        Their SI units.
    estimator : {"H1", "H2", "Hv"}
        H1 is unbiased with noise in the output only, H2 with noise in the input only, Hv with noise in both.
    begin, end : float
        First and last instant, s.
    sample_rate : float
        Samples per second, Hz.
    window : str
        Window of each segment.
    segment, resolution : float
        Length of the segments, s, and noise bandwidth of the window, Hz.
    averages : float
        Number of independent segments (1).
    confidence : float
        Level of the intervals (1).
    significant : float
        Coherence (1) below which two unrelated channels remain with this confidence.
    frequency : ndarray, shape (n,)
        Hz, within the band.
    response : ndarray of complex, shape (n,)
        Unit of the output over that of the input; the angle is positive where the output leads.
    coherence : ndarray, shape (n,)
        Fraction (1) of the output power that is linearly related to the input.
    gain_error : ndarray, shape (n,)
        Relative standard error of the gain (1); infinite without coherence.
    phase_error : ndarray, shape (n,)
        Standard error of the phase, rad; infinite without coherence.
    model : ndarray of complex, shape (n,), or None
        Response of the linear model.
    findings : tuple of Finding
        Frequencies without coherence or excitation, and assumptions of the estimate.
    """

    record: str
    output: Annotated[str, Shows("output")]
    given: Annotated[str, Shows("input")]
    output_unit: str
    given_unit: str
    estimator: Annotated[Estimator, Shows("estimator")]
    begin: Annotated[float, Shows("from", "s")]
    end: Annotated[float, Shows("to", "s")]
    sample_rate: Annotated[float, Shows("sample rate", "Hz")]
    window: Annotated[str, Shows("window")]
    segment: Annotated[float, Shows("segment", "s")]
    resolution: Annotated[float, Shows("resolution", "Hz")]
    averages: Annotated[float, Shows("independent segments", "1")]
    confidence: Annotated[float, Shows("confidence", "%")]
    significant: Annotated[float, Shows("coherence by chance, up to", "1")]
    frequency: Array
    response: NDArray[np.complex128]
    coherence: Array
    gain_error: Array
    phase_error: Array
    model: NDArray[np.complex128] | None
    findings: tuple[Finding, ...]

    @property
    def gain(self) -> Array:
        """Magnitude, unit of the output over that of the input."""
        return np.abs(self.response)

    @property
    def phase(self) -> Array:
        """Angle, rad, from -pi to pi; positive where the output leads."""
        return np.angle(self.response)

    @property
    def factor(self) -> float:
        """Half width of an interval in standard errors (1)."""
        return student_factor(2.0 * self.averages - 2.0, level=self.confidence)

    @property
    def gain_interval(self) -> tuple[Array, Array]:
        """Lower and upper ends of the gain's interval, unit of the output over that of the input."""
        half = self.factor * self.gain_error
        return self.gain * np.clip(1.0 - half, 0.0, None), self.gain * (1.0 + half)

    def rows(self) -> list[dict[str, Any]]:
        """Return one row for each frequency, SI."""
        low, high = self.gain_interval
        columns = {
            "frequency": self.frequency,
            "gain": self.gain,
            "gain_low": low,
            "gain_high": high,
            "phase": self.phase,
            "phase_error": self.phase_error,
            "coherence": self.coherence,
        }
        if self.model is not None:
            columns |= {"model_gain": np.abs(self.model), "model_phase": np.angle(self.model)}
        table = np.stack(list(columns.values()), axis=1).tolist()
        return [dict(zip(columns, row, strict=True)) for row in table]

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI; complex numbers as real and imaginary parts."""
        plain = {
            name: value for name, value in vars(self).items() if name not in ("response", "model")
        }
        for name in ("response", "model"):
            value = getattr(self, name)
            parts = None if value is None else {"real": value.real, "imaginary": value.imag}
            plain[name] = parts
        return plain_table(plain)


@operation(
    "analyse transfer",
    named={"begin": "from", "end": "to", "given": "input", "changes": "set"},
    offers=("numbers", "figure", "report"),
    page="jounce.report:transfer_page",
    title="Transfer function of {record}",
    example="jounce analyse transfer lap.csv --input unsprung.az --output sprung.az --figure transfer.png",
)
def estimate_transfer(  # noqa: PLR0913 - independent options
    record: AnyRecord,
    output: Annotated[str, Mark("Channel of the output.", "CHANNEL")],
    given: Annotated[str, Mark("Channel of the input.", "CHANNEL")],
    *,
    estimator: Annotated[
        Estimator, Mark("H1 (noise in the output), H2 (in the input) or Hv (in both).", "ESTIMATOR")
    ] = "H1",
    rig: ComparedRig = None,
    band: Annotated[tuple[float | str, float | str] | None, BAND] = None,
    segment: Annotated[float | str | None, SEGMENT] = None,
    window: Annotated[str, WINDOW] = "hann",
    confidence: Annotated[float, CONFIDENCE] = 0.95,
    begin: Annotated[float | str | None, BEGIN] = None,
    end: Annotated[float | str | None, END] = None,
) -> TransferEstimate:
    """Estimate transfer function and coherence between two channels of a record, with their random errors.

    Parameters
    ----------
    record : Dataset, DataFrame, (Dataset, list of Finding), Path or str
        A recording, a table with columns ``name [unit]``, the result of `read_recording`, or a file.
    output, given : str
        Channels of output and input.
    estimator : {"H1", "H2", "Hv"}
        H1 is unbiased with noise in the output only, H2 with noise in the input only, Hv with noise in both.
    rig : Rig, Path or str, optional
        A rig whose linear model is compared, without dry friction: both channels must be its channels.
    band : (float, float), optional
        Lowest and highest frequency, Hz or text with a unit; by default the range in which both channels were recorded.
    segment : float or str, optional
        Length of the averaged segments, s or text with a unit; by default an eighth of the record, but at most 8 s. It
        must exceed the decay time of the system: otherwise peaks and their coherence are too low.
    window : {"hann", "boxcar"}
        Hann segments overlap by half; boxcar segments do not.
    confidence : float
        Level of the intervals (1), between 0 and 1.
    begin, end : float or str, optional
        Section of the record to use, s or text with a unit.

    Returns
    -------
    TransferEstimate
        In SI. With the coherence c and n independent segments, the relative standard error of the gain and the standard
        error of the phase (rad) are ``sqrt((1 - c) / (2 n c))``; for the gain of Hv it is ``sqrt((1 - c) / (2 n))``.

    Raises
    ------
    RecordingError
        For an unreadable or too short record, missing samples, a channel that is constant or unknown, a band outside
        the range of the record, and fewer than two independent segments, whose coherence would always be 1.
    DescriptionError
        For an unknown estimator or window, and a confidence outside (0, 1).

    References
    ----------
    bendat2010, sections 6.1 and 9.2.

    Examples
    --------
    >>> import jounce as jn, numpy as np
    >>> noise = np.random.default_rng(0).normal(size=20_000)
    >>> t = np.arange(noise.size) / 200.0
    >>> run = jn.recording(t, {"road.z": (noise, "m", ""), "body.z": (2.0 * noise, "m", "")})
    >>> found = jn.estimate_transfer(run, "body.z", "road.z")
    >>> bool(np.allclose(found.gain[1:-1], 2.0)), bool(found.coherence[1:-1].min() > 0.999)
    (True, True)
    """
    if estimator not in get_args(Estimator):
        raise unknown(str(estimator), get_args(Estimator), what="estimator", where="estimator")
    if window not in WINDOWS:
        raise unknown(str(window), WINDOWS, what="window", where="window")
    check_confidence(confidence)
    used = read_measured(record, begin, end)
    names = [check_channel(used, name) for name in (given, output)]
    check_moving(used, names)
    count = segment_samples(used, segment, FEWEST_PARTS)
    averages, resolution = (
        independent_segments(used.run.sizes["time"], count, window),
        WINDOWS[window] * used.rate / count,
    )
    if averages < _FEWEST_AVERAGES:
        raise RecordingError(
            "a coherence needs at least two independent segments",
            where=f"{used.name}: segment",
            found=f"{averages:.2g} of {count / used.rate:g} s",
            allowed=Phrase("at most {duration:.3g} s", duration=used.duration / 3.0),
        )
    limits, notes = band_of(used, band, names, 0.5 * used.rate / count)
    frequency, own, other, cross = _spectra(used, given, output, count, window)
    inside = (frequency >= limits[0]) & (frequency <= limits[1])
    frequency, own, other, cross = frequency[inside], own[inside], other[inside], cross[inside]
    both = own * other
    coherence = np.clip(
        np.divide(abs(cross) ** 2, both, out=np.zeros_like(own), where=both > 0.0), 0.0, 1.0
    )
    response = _response(estimator, own, other, cross)
    error = relative_error(coherence, averages)
    significant = 1.0 - (1.0 - confidence) ** (1.0 / max(averages - 1.0, 1e-9))
    model, words = (
        (None, []) if rig is None else _of_model(as_rig(rig), frequency, output, given, used.name)
    )
    power = power_spectrum(
        used.values(given), used.rate, segment=count / used.rate, window=window
    ).density[inside]
    doubts = [*_incoherent(used.name, frequency, coherence, power, significant), *words]
    doubts += _flattened_peaks(used.name, frequency, np.abs(response), error, resolution)
    return TransferEstimate(
        used.name,
        output,
        given,
        used.unit(output),
        used.unit(given),
        estimator,
        float(used.run["time"][0]),
        float(used.run["time"][-1]),
        used.rate,
        window,
        count / used.rate,
        resolution,
        averages,
        confidence,
        significant,
        frequency,
        response,
        coherence,
        np.sqrt((1.0 - coherence) / (2.0 * averages)) if estimator == "Hv" else error,
        error,
        model,
        (*used.findings, *notes, *doubts),
    )


def check_moving(used: Measured, names: list[str]) -> None:
    """Raise an error for constant channels."""
    still = constant_channels(used, names)[1]
    if still:
        raise RecordingError(
            "the channel is constant",
            where=still[0].place,
            found=still[0].value,
            allowed="a channel that moves",
            hint="Was the sensor connected?",
        )


def _spectra(
    used: Measured, given: str, output: str, count: int, window: str
) -> tuple[Array, Array, Array, NDArray[np.complex128]]:
    """Frequencies (Hz), and auto- and cross-spectral densities of input and output, after whitening by the input."""
    white = whiten({name: used.values(name) for name in (given, output)}, given, count)
    x, y = white[given], white[output]
    frequency, own = cross_spectrum(x, x, used.rate, count, window)
    other = cross_spectrum(y, y, used.rate, count, window)[1]
    cross = cross_spectrum(x, y, used.rate, count, window)[1]
    return frequency, own.real, other.real, cross


def whiten(signals: dict[str, Array], given: str, count: int) -> dict[str, Array]:
    """Filter all channels so that the input has equal power at all frequencies, which prevents blurring by the window.

    Input and outputs pass the same filter, without phase shift, which preserves the transfer functions. Without it, a
    road, whose power falls with the square of the frequency, or a wheel's acceleration, whose power rises, would leak
    from line to line and shift the lowest mode. ``count`` is the number of samples in the later segments.
    """
    from scipy import fft, signal
    from scipy.ndimage import uniform_filter1d

    size = len(signals[given])
    frequency, density = signal.welch(signals[given], 1.0, nperseg=count)
    density[:2] = density[min(2, count // 2)]  # the mean was removed
    level = uniform_filter1d(
        np.log(np.maximum(density, _LEAST_POWER * density.max())), 3, mode="nearest"
    )
    longer = fft.next_fast_len(size + count, real=True)
    gain = np.exp(-0.5 * np.interp(fft.rfftfreq(longer), frequency, level))
    return {
        name: fft.irfft(fft.rfft(values - values.mean(), longer) * gain, longer)[:size]
        for name, values in signals.items()
    }


_LEAST_POWER = 1e-6  # of the strongest line: weaker ones are not amplified further


def _response(
    estimator: Estimator, own: Array, other: Array, cross: NDArray[np.complex128]
) -> NDArray[np.complex128]:
    """Transfer function of an estimator; 0 where there is no excitation."""
    zero = np.zeros_like(cross)
    if estimator == "H1":
        return np.divide(cross, own, out=zero, where=own > 0.0)
    size = abs(cross)
    if estimator == "H2":
        return np.divide(other * cross, size**2, out=zero, where=size > 0.0)
    gain = np.sqrt(np.divide(other, own, out=np.zeros_like(own), where=own > 0.0))
    return np.divide(gain * cross, size, out=zero, where=size > 0.0)


def _incoherent(
    name: str, frequency: Array, coherence: Array, own: Array, significant: float
) -> list[Finding]:
    """Report frequencies at which the output does not follow the input, with the likely cause."""
    from scipy.ndimage import uniform_filter1d

    low = uniform_filter1d(coherence, min(5, len(coherence))) < max(LOW_COHERENCE, significant)
    share = float(low.mean())
    if share < _SELDOM:
        return []
    ranges = ", ".join(f"{a:.3g} to {b:.3g}" for a, b in frequency_ranges(frequency, low)[:4])
    if share > _NEARLY_ALL:
        return [finding("analysis.incoherent", name, share)]
    is_quiet = bool(np.median(own[low]) < _EXCITED * float(own.max()))
    cause = (
        "the input hardly excites there"
        if is_quiet
        else "noise, other inputs, lost contact or dry friction"
    )
    return [
        finding(
            "analysis.low_coherence", name, share, limit=LOW_COHERENCE, ranges=ranges, cause=cause
        )
    ]


_NEARLY_ALL = 0.95  # of the band without coherence: the remainder may be chance


def _flattened_peaks(
    name: str, frequency: Array, gain: Array, error: Array, resolution: float
) -> list[Finding]:
    """Report peaks too narrow for the segments, which reduce their height (Bendat and Piersol, section 8.5)."""
    from scipy.signal import find_peaks

    known = np.where(error < _KNOWN, gain, 0.0)
    places, facts = find_peaks(known, prominence=0.3 * float(known.max()))
    findings = []
    for at, rise in zip(places.tolist(), facts["prominences"].tolist(), strict=True):
        if rise < 4.0 * error[at] * gain[at]:  # it may be chance
            continue
        below = np.flatnonzero(gain[:at] < gain[at] * 0.5**0.5)
        above = np.flatnonzero(gain[at:] < gain[at] * 0.5**0.5)
        if not below.size or not above.size:
            continue
        width = float(frequency[at + above[0]] - frequency[below[-1]])
        loss = (resolution / width) ** 2 / 3.0
        if loss > _BIAS:
            centre = float(frequency[at])
            findings.append(
                finding(
                    "analysis.flat_peak", name, centre, frequency=centre, width=width, loss=loss
                )
            )
    return findings


def sliding_model(rig: Rig) -> LinearModel:
    """Linear model of a rig without dry friction, as it behaves in large motions."""
    frictions = {
        path: 0.0
        for path, value in rig.parameters().items()
        if path.endswith("friction.force") and value
    }
    return linearise(rig.with_changes(frictions) if frictions else rig)


def _of_model(
    rig: Rig, frequency: Array, output: str, given: str, where: str
) -> tuple[NDArray[np.complex128] | None, list[Finding]]:
    """Transfer function of a rig's linear model, or None with the reason as a finding."""
    model = sliding_model(rig)
    tracks = [name for name in model.inputs if f"{name} rate" in model.inputs]
    missing = [name for name in (output, given) if name not in model.outputs and name not in tracks]
    if missing:
        return None, [finding("analysis.no_model_channel", where, channels=", ".join(missing))]
    positive = np.maximum(frequency, 1e-6)
    if given in tracks:
        return model.frequency_response(positive, output, given), []
    roads = [name for name in tracks if name.endswith("road.z")]
    if len(roads) != 1:
        return None, [finding("analysis.several_roads", where, channel=given)]
    below = model.frequency_response(positive, given, roads[0])
    return model.frequency_response(positive, output, roads[0]) / below, []
