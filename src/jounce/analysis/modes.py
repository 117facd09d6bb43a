"""Modal frequencies and damping ratios from measured channels, with intervals, compared with those of a model."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jounce.analysis.options import ComparedRig
from jounce.analysis.poles import (
    MOST_MODES,
    Complex,
    Kind,
    Lines,
    PoleFit,
    Stabilisation,
    covariance_by_groups,
    covariance_by_lines,
    fit_poles,
    parameters_of,
    stabilisation,
    stable_modes,
)
from jounce.analysis.record import (
    BAND,
    BEGIN,
    END,
    SEGMENT,
    AnyRecord,
    Measured,
    band_of,
    band_text,
    check_channel,
    read_measured,
    select_channels,
)
from jounce.analysis.spectrum import segment_samples
from jounce.analysis.transfer import check_moving, sliding_model, whiten
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.operation import Count, Mark, Switch, Texts, operation
from jounce.core.phrases import Phrase
from jounce.core.results import Shows
from jounce.core.serialise import Plain, plain_table
from jounce.core.types import Array
from jounce.identify.estimate import Estimate, student_factor
from jounce.parts import Rig, as_rig
from jounce.simulation.linear_model import LinearModel

FEWEST_PARTS = 24
"""Number of segments of a short record, without overlap: the intervals follow from their scatter."""
GROUPS = 20
"""Number of groups of neighbouring segments left out in turn (jackknife): 19 degrees of freedom."""
_FEWEST_GROUPS = 6  # 5 degrees of freedom, Student's factor 2.6; for 4 groups it is 3.2
_FEWEST_LINES = 24  # the number of poles of the highest order
_LARGEST_ERROR = 0.1  # relative error of a frequency above which a pole is useless
_NEAR = 1.5  # largest frequency ratio of a measured mode and the model's
_CYCLES = (
    2.0  # of the lowest frequency in a segment: below, window and detrending remove everything
)


@dataclass(frozen=True)
class MeasuredMode(Plain):
    """A vibration mode identified from a record.

    Attributes
    ----------
    frequency : Estimate
        Undamped natural frequency, Hz, with its 95 % interval.
    damping_ratio : Estimate
        Fraction of critical damping (1), with its 95 % interval.
    orders : int
        Number of denominator orders (1) that agree on this mode.
    model_frequency, model_damping_ratio : float or None
        Values of the nearest mode of the model, Hz and 1.
    """

    frequency: Annotated[Estimate, Shows("frequency", "Hz")]
    damping_ratio: Annotated[Estimate, Shows("damping ratio", "1")]
    orders: Annotated[int, Shows("orders that agree")]
    model_frequency: Annotated[float | None, Shows("model", "Hz")] = None
    model_damping_ratio: Annotated[float | None, Shows("damping ratio of the model", "1")] = None

    @property
    def damped_frequency(self) -> float:
        """Frequency of the free decay, Hz."""
        return self.frequency.value * float(np.sqrt(max(1.0 - self.damping_ratio.value**2, 0.0)))


@dataclass(frozen=True)
class FittedModes(Plain):
    """Modes found in a record.

    Attributes
    ----------
    record : str
        File, or ``recording``.
    kind : {"transfer", "spectrum", "decay"}
        Fitted quantity: transfer functions, densities of the outputs, or a free decay.
    outputs : tuple of str
        Channels of the outputs.
    given : str
        Channel of the input; empty without one.
    begin, end : float
        First and last instant, s.
    sample_rate : float
        Samples per second, Hz.
    band : (float, float)
        Fitted frequency range, Hz.
    segment : float
        Length of the segments, or of the whole decay, s.
    modes : tuple of MeasuredMode
        By rising frequency.
    stabilisation : Stabilisation
        Poles of denominators of rising order.
    frequency : ndarray, shape (n,)
        Hz.
    measured, fitted : ndarray of complex, shape (n, k)
        Lines of each output, in SI: output over input, density, or Fourier transform.
    findings : tuple of Finding
        Missing modes, and assumptions of the estimate.
    """

    record: str
    kind: Annotated[Kind, Shows("fitted to")]
    outputs: Annotated[tuple[str, ...], Shows("outputs")]
    given: Annotated[str, Shows("input")]
    begin: Annotated[float, Shows("from", "s")]
    end: Annotated[float, Shows("to", "s")]
    sample_rate: Annotated[float, Shows("sample rate", "Hz")]
    band: Annotated[tuple[float, float], Shows("band", "Hz")]
    segment: Annotated[float, Shows("segment", "s")]
    modes: Annotated[tuple[MeasuredMode, ...], Shows("Modes")]
    stabilisation: Stabilisation
    frequency: Array
    measured: Complex
    fitted: Complex
    findings: tuple[Finding, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI, without the lines."""
        left_out = ("frequency", "measured", "fitted")
        return plain_table(
            {name: value for name, value in vars(self).items() if name not in left_out}
        )

    def rows(self) -> list[dict[str, Any]]:
        """Return one row for each mode, SI."""
        return [_row(mode) for mode in self.modes]


_Leaving: TypeAlias = "Callable[[int], Complex] | None"


@operation(
    "analyse modes",
    named={"outputs": "output", "begin": "from", "end": "to", "given": "input", "changes": "set"},
    offers=("numbers", "figure", "report"),
    page="jounce.report:measured_modes_page",
    title="Modes of {record}",
    doing="fitting",
    example="jounce analyse modes lap.csv --input road.z --rig kart-quarter-car --figure modes.png",
)
def fit_modes(
    record: AnyRecord,
    outputs: Annotated[
        Sequence[str] | str | None,
        Texts("Output channel; by default all except the input. May be repeated.", "CHANNEL"),
    ] = None,
    given: Annotated[
        str | None,
        Mark("Channel of the input; without one, spectra of the outputs are fitted.", "CHANNEL"),
    ] = None,
    *,
    decay: Annotated[bool, Switch("The record is a free decay.")] = False,
    rig: ComparedRig = None,
    count: Annotated[
        int | None,
        Count(
            "Number of modes; by default chosen by an information criterion.",
            "COUNT",
            least=1,
            most=MOST_MODES,
        ),
    ] = None,
    band: Annotated[tuple[float | str, float | str] | None, BAND] = None,
    segment: Annotated[float | str | None, SEGMENT] = None,
    begin: Annotated[float | str | None, BEGIN] = None,
    end: Annotated[float | str | None, END] = None,
) -> FittedModes:
    """Find modal frequencies and damping ratios in a record, with 95 % intervals.

    With an input (``given``) the transfer functions to all outputs are fitted, without an input the spectra of the
    outputs, and with ``decay`` their free motion after a release. The fit starts from poles on which denominators of
    rising order agree (least-squares complex frequency) and includes the effect of the window on the measured lines.

    Parameters
    ----------
    record : Dataset, DataFrame, (Dataset, list of Finding), Path or str
        A recording, a table with columns ``name [unit]``, what `read_recording` gives, or a file.
    outputs : sequence of str, optional
        Channels of the outputs; all but the input by default.
    given : str, optional
        Channel of the input. If an output of the rig is used as the input, such as the wheel's acceleration, the modes
        are those of the rig with this motion held fixed.
    decay : bool
        The record is a free decay from ``begin`` on.
    rig : Rig, Path or str, optional
        A rig whose modes are compared, without dry friction.
    count : int, optional
        Number of modes (1); by default chosen by an information criterion.
    band : (float, float), optional
        Lowest and highest frequency, Hz or text with a unit; it should extend beyond each mode by at least the width
        of its peak. By default from two cycles in a segment to 40 Hz.
    segment : float or str, optional
        Length of the averaged segments, s or text with a unit; by default 1/24 of the record, but 4 to 8 s.
    begin, end : float or str, optional
        Stretch of time that counts, s or text with a unit.

    Returns
    -------
    FittedModes
        Contains no modes if no orders agree on one; a finding reports this. Intervals are computed by leaving out
        groups of segments in turn, those of a decay from the residual of the fit. Without an input, the spectrum of the
        excitation is assumed to be smooth over the band.

    Raises
    ------
    RecordingError
        For an unreadable or too short record, missing samples, constant or unknown channels, and a band outside the
        range of the record or narrower than 24 lines.
    DescriptionError
        For a decay with an input, and a count below 1 or above 6.

    References
    ----------
    peeters2004 (initial poles), golub1973 (variable projection), bendat2010.

    Examples
    --------
    >>> import jounce as jn, numpy as np
    >>> t = np.arange(0.0, 4.0, 0.002)
    >>> fall = np.exp(-0.1 * 2.0 * np.pi * 3.0 * t) * np.cos(2.0 * np.pi * 3.0 * np.sqrt(0.99) * t)
    >>> run = jn.recording(t, {"body.z": (0.01 * fall, "m", "")})
    >>> (mode,) = jn.fit_modes(run, decay=True, count=1, band=(0.5, 20.0)).modes
    >>> round(mode.frequency.value, 3), round(mode.damping_ratio.value, 3)
    (3.0, 0.1)
    """
    if decay and given is not None:
        raise DescriptionError(
            "a free decay has no input", where="given", found=given, allowed="none with decay"
        )
    if count is not None and not 1 <= count <= MOST_MODES:
        raise DescriptionError(
            "invalid number of modes",
            where="count",
            found=count,
            allowed=Phrase("1 to {most_modes}", most_modes=MOST_MODES),
        )
    used = read_measured(record, begin, end)
    if given is not None:
        check_channel(used, given)
    names = [
        name for name in select_channels(used, outputs) if outputs is not None or name != given
    ]
    if not names or given in names:
        raise RecordingError(
            "no output",
            where=used.name,
            found=", ".join(names),
            allowed="channels other than the input",
        )
    check_moving(used, [*names, *([given] if given else [])])
    samples = _decay_samples(used) if decay else _samples(used, segment)
    length = samples / used.rate
    everything = [*names, *([given] if given else [])]
    lowest = (1.0 if decay else _CYCLES) / length
    limits, notes = band_of(
        used, band or (lowest, min(_HIGHEST, _top(used, everything))), everything, lowest
    )
    lines, response, leave_out, groups, doubts = _lines(used, names, given, decay, samples, limits)
    table = stabilisation(lines, response)
    starts = stable_modes(table, lines.kind)
    fit, lines = _fit(lines, starts, count)
    candidates = [] if fit is None else _modes(fit, lines, starts, leave_out, groups)
    modes = [mode for mode in candidates if count is not None or _is_known(mode)]
    modes.sort(key=lambda mode: mode.frequency.value)
    doubts += _doubts(used.name, modes, count, limits)
    if rig is not None:
        modes, words = _beside_model(modes, as_rig(rig), given, limits, used.name)
        doubts += words
    return FittedModes(
        used.name,
        lines.kind,
        tuple(names),
        given or "",
        float(used.run["time"][0]),
        float(used.run["time"][-1]),
        used.rate,
        limits,
        length,
        tuple(modes),
        table,
        lines.frequency,
        lines.values,
        np.full_like(lines.values, np.nan) if fit is None else fit.model,
        (*used.findings, *notes, *doubts),
    )


_HIGHEST = 40.0  # Hz: wheel hop is below 20, on karts with stiff tyres below 30
_SHORTEST = 4.0  # s: two cycles of 0.5 Hz, half the lowest body frequency


def _top(used: Measured, names: Sequence[str]) -> float:
    return min(used.highest_frequency(name) for name in names)


def _samples(used: Measured, segment: float | str | None) -> int:
    count = segment_samples(used, segment, FEWEST_PARTS)
    return (
        max(count, min(round(_SHORTEST * used.rate), used.run.sizes["time"] // 8))
        if segment is None
        else count
    )


def _decay_samples(used: Measured) -> int:
    return segment_samples(used, used.run.sizes["time"] / used.rate, 1)


def _inside(
    samples: int, rate: float, band: tuple[float, float]
) -> tuple[Array, NDArray[np.bool_]]:
    """Frequencies (Hz) of the lines within the band, and their mask among all lines."""
    frequency = np.asarray(np.fft.rfftfreq(samples, 1.0 / rate), dtype=np.float64)
    inside = (
        (frequency >= band[0] * (1.0 - 1e-9))
        & (frequency <= band[1] * (1.0 + 1e-9))
        & (frequency > 0.0)
    )
    return frequency[inside], inside


def _lines(
    used: Measured,
    names: list[str],
    given: str | None,
    decay: bool,
    samples: int,
    band: tuple[float, float],
) -> tuple[Lines, Complex, _Leaving, int, list[Finding]]:
    """Lines to fit, responses for the initial poles, lines without each group of segments, and number of groups."""
    f, inside = _inside(samples, used.rate, band)
    if len(f) < _FEWEST_LINES:
        raise RecordingError(
            "the band is too narrow for modes",
            where=f"{used.name}: band",
            found=f"{len(f)} lines in {band_text(band)}",
            allowed=Phrase("at least {fewest_lines}", fewest_lines=_FEWEST_LINES),
            hint="Use longer segments, a longer record or a wider band.",
        )
    if decay:
        step = 1.0 / used.rate
        values = np.stack([np.fft.rfft(used.values(name))[inside] * step for name in names], axis=1)
        weight = np.ones(values.shape) / np.abs(values).max(axis=0)
        return (
            Lines("decay", f, values, weight, samples * step, step, is_hann=False),
            values,
            None,
            0,
            [],
        )
    signals, rate = _decimate(used, [*names, *([given] if given else [])], band[1])
    samples = round(samples * rate / used.rate)
    f, inside = _inside(samples, rate, band)
    if given is not None:
        signals = whiten(signals, given, samples)
    outputs = [_segments(signals[name], rate, samples) for name in names]
    count = outputs[0].shape[1]
    groups = min(GROUPS, count)
    if groups < _FEWEST_GROUPS:
        raise RecordingError(
            "the record is too short for intervals",
            where=used.name,
            found=f"{count} segments of {samples / rate:.3g} s",
            allowed=Phrase("at least {fewest_groups}", fewest_groups=_FEWEST_GROUPS),
            hint="Use shorter segments, or a free decay.",
        )
    group = np.arange(count) * groups // count
    if given is None:
        made = _spectrum_lines(f, outputs, group, inside, samples / rate, 1.0 / rate)
        return (*made, groups, [finding("analysis.smooth_excitation", used.name)])
    source = _segments(signals[given], rate, samples)[inside]
    made = _transfer_lines(
        f, source, [output[inside] for output in outputs], group, samples / rate, 1.0 / rate
    )
    return (*made, groups, [])


def _decimate(
    used: Measured, names: Sequence[str], highest: float
) -> tuple[dict[str, Array], float]:
    """Channels decimated to a rate sufficient for the band, without phase shift, and that rate (Hz)."""
    from scipy import signal

    factor = max(1, int(used.rate / (_OVERSAMPLED * highest)))
    values = {name: used.values(name) for name in names}
    if factor == 1:
        return values, used.rate
    return {
        name: signal.resample_poly(record - record.mean(), 1, factor)
        for name, record in values.items()
    }, used.rate / factor


_OVERSAMPLED = 6.0  # samples in the shortest period: anti-alias filters act from 2.5 on


def _segments(values: Array, rate: float, samples: int) -> Complex:
    """Transforms of Hann segments that overlap by half, shape (frequencies, segments)."""
    from scipy import signal

    options: dict[str, Any] = {
        "window": "hann",
        "nperseg": samples,
        "noverlap": samples // 2,
        "detrend": "constant",
    }
    return np.asarray(
        signal.stft(values, rate, boundary=None, padded=False, scaling="psd", **options)[2]
    )


def _transfer_lines(
    f: Array,
    source: Complex,
    outputs: list[Complex],
    group: NDArray[np.int_],
    length: float,
    step: float,
) -> tuple[Lines, Complex, _Leaving]:
    own = _by_group(np.abs(source) ** 2, group).real
    cross = [_by_group(np.conj(source) * output, group) for output in outputs]
    whole = own.sum(axis=1)
    values = np.stack([spectrum.sum(axis=1) / whole for spectrum in cross], axis=1)
    others = np.stack([(np.abs(output) ** 2).sum(axis=1) for output in outputs], axis=1)
    noise = np.clip(others / whole[:, None] - np.abs(values) ** 2, 0.0, None)
    noise = _smooth(noise) + 1e-3 * np.abs(values) ** 2 + 1e-12 * (np.abs(values) ** 2).max(axis=0)

    def leave_out(left_out: int) -> Complex:
        rest = whole - own[:, left_out]
        return np.stack([(part.sum(axis=1) - part[:, left_out]) / rest for part in cross], axis=1)

    return Lines("transfer", f, values, 1.0 / np.sqrt(noise), length, step), values, leave_out


def _spectrum_lines(
    f: Array,
    outputs: list[Complex],
    group: NDArray[np.int_],
    inside: NDArray[np.bool_],
    length: float,
    step: float,
) -> tuple[Lines, Complex, _Leaving]:
    powers = [_by_group(np.abs(output) ** 2, group).real for output in outputs]
    whole = np.stack([spectrum.sum(axis=1) for spectrum in powers], axis=1) / len(group)
    sizes = np.bincount(group)

    def leave_out(left_out: int) -> Complex:
        rest = len(group) - sizes[left_out]
        parts = [(power.sum(axis=1) - power[:, left_out])[inside] / rest for power in powers]
        return np.stack(parts, axis=1).astype(complex)

    weight = 1.0 / (_smooth(whole[inside]) + 1e-12 * whole[inside].max(axis=0))
    lines = Lines("spectrum", f, whole[inside].astype(complex), weight, length, step)
    response = np.stack([_causal(column)[inside] for column in whole.T], axis=1)
    return lines, response, leave_out


def _causal(density: Array) -> Complex:
    """Fourier transform of the correlation at positive lags up to 0.4 of a segment, with the window divided out."""
    correlation = np.fft.irfft(density)
    size = len(correlation)
    u = np.arange(2 * size // 5) / size
    seen = (1.0 - u) * (2.0 / 3.0 + np.cos(2.0 * np.pi * u) / 3.0) + np.sin(2.0 * np.pi * u) / (
        2.0 * np.pi
    )
    positive = np.zeros(size)
    positive[: len(u)] = correlation[: len(u)] / seen * (0.5 + 0.5 * np.cos(np.pi * u / u[-1]))
    positive[0] *= 0.5
    return np.asarray(np.fft.rfft(positive))


def _by_group(segments: NDArray[Any], group: NDArray[np.int_]) -> NDArray[Any]:
    """Sum of the segments of each group, shape (frequencies, groups)."""
    return np.add.reduceat(segments, np.flatnonzero(np.diff(group, prepend=-1)), axis=1)


def _smooth(values: Array) -> Array:
    """Mean over nine neighbouring lines."""
    from scipy.ndimage import uniform_filter1d

    return np.asarray(uniform_filter1d(values, 9, axis=0, mode="nearest"))


def _fit(
    lines: Lines, starts: list[tuple[float, float, int]], count: int | None
) -> tuple[PoleFit | None, Lines]:
    """Fit ``count`` modes, or the number that minimises the criterion; return the fit with the weighted lines."""
    if not starts:
        return None, lines
    lines, fit = _refine(lines, parameters_of([start[:2] for start in starts]))
    while fit.parameters.size > 2:
        pairs = fit.parameters.size // 2
        if count is not None and pairs <= count:
            break
        tries = [
            fit_poles(lines, np.delete(fit.parameters, [2 * k, 2 * k + 1])) for k in range(pairs)
        ]
        best = min(tries, key=lambda attempt: attempt.cost)
        if count is None and _criterion(fit, lines) < _criterion(best, lines):
            break
        lines, fit = _refine(lines, best.parameters)
    return fit, lines


def _refine(lines: Lines, start: Array) -> tuple[Lines, PoleFit]:
    """Fit lines; refit spectra with weights from the fitted levels, decays with weights from the residuals."""
    fit = fit_poles(lines, start)
    if lines.kind == "transfer":
        return lines, fit
    for _ in range(2):
        if lines.kind == "spectrum":
            model = fit.model.real
            weight = 1.0 / np.maximum(model, 0.05 * _smooth(lines.values.real))
        else:
            left = np.sqrt(np.mean(np.abs(lines.values - fit.model) ** 2, axis=0))
            weight = np.ones(lines.values.shape) / np.maximum(
                left, 1e-9 * np.abs(lines.values).max(axis=0)
            )
        lines = Lines(
            lines.kind,
            lines.frequency,
            lines.values,
            weight,
            lines.length,
            lines.step,
            is_hann=lines.is_hann,
        )
        fit = fit_poles(lines, fit.parameters)
    return lines, fit


def _criterion(fit: PoleFit, lines: Lines) -> float:
    """Bayesian information criterion (Schwarz): two parameters for each pole and two for each of its outputs."""
    size = len(fit.residual) / (
        1.5 if lines.is_hann else 1.0
    )  # neighbouring lines of Hann segments share noise
    numbers = fit.parameters.size * (1.0 + lines.values.shape[1])
    return float(size * np.log(max(fit.cost, 1e-300) / size) + numbers * np.log(size))


def _modes(
    fit: PoleFit,
    lines: Lines,
    starts: list[tuple[float, float, int]],
    leave_out: _Leaving,
    groups: int,
) -> list[MeasuredMode]:
    if leave_out is None:
        linear = fit.parameters.size + 3
        freedom = len(fit.residual) - fit.parameters.size - linear * lines.values.shape[1]
        covariance = covariance_by_lines(fit, freedom)
    else:
        freedom = groups - 1
        covariance = covariance_by_groups(fit, lines, leave_out, groups)
    errors = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    factor = student_factor(max(freedom, 1))
    modes = []
    for k in range(0, fit.parameters.size, 2):
        f, z = float(np.exp(fit.parameters[k])), float(1.0 / (1.0 + np.exp(-fit.parameters[k + 1])))
        slopes = f, z * (1.0 - z)
        frequency, ratio = (
            Estimate(value, slope * float(error), _ends(back, parameter, factor * error))
            for value, slope, error, parameter, back in (
                (f, slopes[0], errors[k], fit.parameters[k], np.exp),
                (z, slopes[1], errors[k + 1], fit.parameters[k + 1], _ratio),
            )
        )
        nearest = min(starts, key=lambda start: abs(np.log(start[0] / f)))
        modes.append(MeasuredMode(frequency, ratio, nearest[2]))
    return modes


def _ratio(parameter: float) -> float:
    return float(1.0 / (1.0 + np.exp(-parameter)))


def _ends(back: Callable[[float], float], parameter: float, half: float) -> tuple[float, float]:
    """Ends of an interval that is symmetric in the logarithm."""
    return float(back(parameter - half)), float(back(parameter + half))


def _is_known(mode: MeasuredMode) -> bool:
    error = mode.frequency.standard_error
    return error is not None and error <= _LARGEST_ERROR * mode.frequency.value


def _doubts(
    where: str, modes: list[MeasuredMode], count: int | None, band: tuple[float, float]
) -> list[Finding]:
    low, high = band
    if not modes:
        return [finding("analysis.no_mode", where, low=low, high=high)]
    findings = []
    if count is not None and len(modes) < count:
        findings.append(
            finding("analysis.fewer_modes", where, len(modes), present=len(modes), wanted=count)
        )
    for mode in modes:
        width = mode.damping_ratio.value * mode.frequency.value
        frequency = mode.frequency.value
        if not low + width <= frequency <= high - width:
            edge = finding(
                "analysis.mode_at_edge", where, frequency, frequency=frequency, low=low, high=high
            )
            findings.append(edge)
    return findings


def _beside_model(
    modes: list[MeasuredMode], rig: Rig, given: str | None, band: tuple[float, float], where: str
) -> tuple[list[MeasuredMode], list[Finding]]:
    """Add the nearest mode of the model to each measured mode; report model modes that are not in the record."""
    model = sliding_model(rig)
    tracks = [name for name in model.inputs if f"{name} rate" in model.inputs]
    findings = []
    held = given is not None and given not in tracks
    if held and given not in model.outputs:
        return modes, [finding("analysis.no_model_channel", where, channels=given)]
    if held:
        findings.append(finding("analysis.held_output", where, channel=given))
    theirs = oscillating(
        poles_with_held_output(model, given, tracks[0])
        if held and given
        else np.linalg.eigvals(model.A)
    )
    remaining, beside = list(theirs), []
    for mode in modes:
        near = min(
            remaining, key=lambda pair: abs(np.log(pair[0] / mode.frequency.value)), default=None
        )
        if near is None or not 1.0 / _NEAR < near[0] / mode.frequency.value < _NEAR:
            beside.append(mode)
            continue
        remaining.remove(near)
        beside.append(MeasuredMode(mode.frequency, mode.damping_ratio, mode.orders, *near))
    for frequency, _ in remaining:
        if band[0] <= frequency <= band[1]:
            findings.append(
                finding("analysis.mode_not_measured", where, frequency, frequency=frequency)
            )
        else:
            outside = finding(
                "analysis.mode_outside_band",
                where,
                frequency,
                frequency=frequency,
                low=band[0],
                high=band[1],
            )
            findings.append(outside)
    return beside, findings


def oscillating(poles: NDArray[Any]) -> list[tuple[float, float]]:
    """Frequency (Hz) and damping ratio (1) of each pair of poles (rad/s), by rising frequency.

    >>> [(round(f, 3), round(z, 3)) for f, z in oscillating(np.roots([1.0, 2.0, 101.0]))]
    [(1.599, 0.1)]
    """
    pairs = [
        (float(abs(p)) / (2.0 * np.pi), float(-p.real / abs(p)))
        for p in poles
        if p.imag > 1e-9 * abs(p)
    ]
    return sorted(pairs)


def poles_with_held_output(model: LinearModel, output: str, track: str) -> Complex:
    """Poles (rad/s) of a linear model with an output held fixed: the transmission zeros from a track to that output."""
    from scipy.linalg import eigvals

    row, first = model.outputs.index(output), model.inputs.index(track)
    b0, b1 = model.B[:, [first]], model.B[:, [first + 1]]
    d0, d1 = model.D[row, first], model.D[row, first + 1]
    size = len(model.states)
    left = np.block([[model.A, b0], [model.C[[row]], np.array([[d0]])]])
    right = np.block([[np.eye(size), -b1], [np.zeros((1, size)), np.array([[-d1]])]])
    poles = eigvals(left, right)
    # The pencil returns zeros at infinity as large numbers; no rig has poles at 1e8 rad/s.
    return np.asarray(poles[np.isfinite(poles) & (np.abs(poles) < 1e8)])


def _row(mode: MeasuredMode) -> dict[str, Any]:
    row: dict[str, Any] = {}
    for name in ("frequency", "damping_ratio"):
        value = getattr(mode, name)
        low, high = value.interval or (None, None)
        row |= {name: value.value, f"{name}_low": low, f"{name}_high": high}
        row[f"model_{name}"] = getattr(mode, f"model_{name}")
    return {**row, "orders": mode.orders}
