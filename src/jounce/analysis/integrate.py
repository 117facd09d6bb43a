"""Integrate accelerations to velocity and displacement without drift; report the valid band and the error in it."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias, get_args

import numpy as np

from jounce.analysis.record import (
    BEGIN,
    CHANNELS,
    END,
    AnyRecord,
    Measured,
    constant_channels,
    read_measured,
    select_channels,
)
from jounce.core.errors import DescriptionError, RecordingError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.operation import Mark, Number, operation
from jounce.core.phrases import Phrase
from jounce.core.results import Shows
from jounce.core.serialise import Plain, plain_table
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.recordings.schema import place_of, quantity_of, recording_of
from jounce.ride.spectra import Spectrum, power_spectrum
from jounce.variants.threads import processors

if TYPE_CHECKING:
    import xarray as xr

Motion: TypeAlias = Literal["random", "transient", "periodic"]
_ORDER = 6  # order of the high pass: its gain is x^6 / (1 + x^6) at x times the corner
VALID = 19.0 ** (1.0 / _ORDER)
"""Multiple of the corner frequency (1.63) above which the high pass removes less than 5 %."""
_INTEGRALS = {
    "ax": ("vx", "x"),
    "ay": ("vy", "y"),
    "az": ("vz", "z"),
    "acceleration": ("velocity", "displacement"),
    "angular_acceleration": ("angular_velocity", "angle"),
    "pitch_acceleration": ("pitch_rate", "pitch"),
    "roll_acceleration": ("roll_rate", "roll"),
}
_UNITS = {"m/s^2": ("m/s", "m"), "rad/s^2": ("rad/s", "rad")}
_FEWEST_CYCLES = 4.0  # cycles of the lowest corner in a record; two are lost at its ends
_ABOVE_NOISE = 4.0  # density over the floor above which it is motion: then 3/4 of it is


@dataclass(frozen=True)
class IntegratedChannel(Plain):
    """One acceleration with its velocity and displacement.

    Attributes
    ----------
    channel : str
        The acceleration.
    velocity_channel, displacement_channel : str
        Names of the resulting channels.
    unit : str
        Unit of the acceleration: ``m/s^2`` or ``rad/s^2``.
    corner : float
        Frequency (Hz) at which the high pass halves the amplitude; 0 without a high pass.
    band : (float, float)
        Frequency range (Hz) in which the amplitude is accurate to 5 %.
    noise : float
        Noise density of the acceleration, in its unit per root of Hz: as given, or the minimum in the record.
    velocity_error, displacement_error : float
        Standard deviation of velocity and displacement within the band due to this noise, m/s and m.
    removed : float
        Root mean square displacement (m) of the record below the corner, which is lost: drift and slow motion.
    velocity, displacement : ndarray, shape (n,)
        m/s and m, or rad/s and rad, with zero mean; those of transients start at zero instead.
    """

    left_out = ("velocity", "displacement")
    channel: Annotated[str, Shows("channel")]
    velocity_channel: str
    displacement_channel: Annotated[str, Shows("displacement")]
    unit: str
    corner: Annotated[float, Shows("corner", "Hz")]
    band: Annotated[tuple[float, float], Shows("amplitudes within 5 %", "Hz")]
    noise: float
    velocity_error: Annotated[
        float, Shows("velocity error from noise", lambda channel: channel.velocity_unit)
    ]
    displacement_error: Annotated[
        float, Shows("displacement error from noise", lambda channel: channel.displacement_unit)
    ]
    removed: Annotated[float, Shows("removed", lambda channel: channel.displacement_unit)]
    velocity: Array
    displacement: Array

    @property
    def velocity_unit(self) -> str:
        """SI unit of the velocity."""
        return _UNITS[self.unit][0]

    @property
    def displacement_unit(self) -> str:
        """SI unit of the displacement."""
        return _UNITS[self.unit][1]


@dataclass(frozen=True)
class Integration(Plain):
    """Accelerations of a record with their velocities and displacements.

    Attributes
    ----------
    record : str
        File, or ``recording``.
    motion : {"random", "transient", "periodic"}
        Assumed kind of motion.
    time : ndarray, shape (n,)
        Instants, s.
    valid : (float, float)
        First and last instant (s) not affected by the ends of the record.
    channels : tuple of IntegratedChannel
        In the order of the record.
    findings : tuple of Finding
        How the corner was chosen, and limits of the result.
    source : Measured
        The record that was integrated.
    """

    record: str
    motion: Annotated[Motion, Shows("motion")]
    time: Array
    valid: Annotated[tuple[float, float], Shows("valid", "s")]
    channels: Annotated[tuple[IntegratedChannel, ...], Shows("Channels")]
    findings: tuple[Finding, ...]
    source: Measured

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI, without the signals."""
        return plain_table(
            {name: value for name, value in vars(self).items() if name not in ("time", "source")}
        )

    def recording(self) -> xr.Dataset:
        """Return accelerations, velocities and displacements as a recording."""
        signals = {}
        for channel in self.channels:
            signals[channel.channel] = (
                self.source.values(channel.channel)[: len(self.time)],
                channel.unit,
                "",
            )
            signals[channel.velocity_channel] = (channel.velocity, channel.velocity_unit, "")
            signals[channel.displacement_channel] = (
                channel.displacement,
                channel.displacement_unit,
                "",
            )
        return recording_of(
            self.time, signals, {"valid_from": self.valid[0], "valid_to": self.valid[1]}
        )


@operation(
    "analyse integrate",
    named={"channels": "channel", "begin": "from", "end": "to"},
    offers=("recording", "figure", "report"),
    page="jounce.report:integration_page",
    title="Motion of {record}",
    doing="integrating",
    example='jounce analyse integrate lap.csv --channel sprung.az --above "0.5 Hz" --out motion.csv',
)
def integrate_acceleration(
    record: AnyRecord,
    channels: Annotated[Sequence[str] | str | None, CHANNELS] = None,
    *,
    motion: Annotated[
        Motion, Mark("random, transient (from rest to rest) or periodic.", "MOTION")
    ] = "random",
    above: Annotated[
        float | str | None,
        Number(
            "Corner frequency for random motion; by default where the density rises above its floor.",
            "FREQUENCY",
            "Hz",
            is_positive=True,
        ),
    ] = None,
    period: Annotated[
        float | str | None,
        Number(
            "Period of periodic motion; by default the whole record.", "TIME", "s", is_positive=True
        ),
    ] = None,
    noise: Annotated[
        float | None,
        Number(
            "Noise density of the sensor, in SI per root of Hz; by default the minimum in the record.",
            "DENSITY",
            "1",
            is_positive=True,
        ),
    ] = None,
    begin: Annotated[float | str | None, BEGIN] = None,
    end: Annotated[float | str | None, END] = None,
) -> Integration:
    """Integrate accelerations to velocity and displacement without drift, and report the valid band.

    Parameters
    ----------
    record : Dataset, DataFrame, (Dataset, list of Finding), Path or str
        A recording, a table with columns ``name [unit]``, the result of `read_recording`, or a file.
    channels : sequence of str, optional
        Accelerations; by default every channel in m/s^2 or rad/s^2.
    motion : {"random", "transient", "periodic"}
        ``random``: continues beyond both ends; frequencies below a corner are removed, without phase shift.
        ``transient``: begins and ends at rest at the same position, which determines the sensor's offset and drift;
        all frequencies are valid. ``periodic``: repeats; only multiples of its frequency are used.
    above : float or str, optional
        Corner frequency for random motion, Hz or text with a unit, at which the amplitude is halved; by default where
        the density rises above its floor.
    period : float or str, optional
        Period of periodic motion, s or text with a unit; by default the length of the record.
    noise : float, optional
        Noise density of the sensor, in m/s^2 (or rad/s^2) per root of Hz; by default the minimum density of the
        record, which may include some motion.
    begin, end : float or str, optional
        Section of the record to use, s or text with a unit.

    Returns
    -------
    Integration
        In SI. An accelerometer does not record the absolute position: displacements have zero mean; those of
        transients start at 0.

    Raises
    ------
    RecordingError
        For an unreadable or too short record, missing samples, no acceleration, a corner outside the range of the
        record, and a record whose drift hides the motion.
    DescriptionError
        For an unknown motion, and options of a different motion.

    Notes
    -----
    White noise of density ``s`` adds ``s / (2 pi f)^2`` to the displacement at the frequency f. For a transient of
    duration T, the straight line that brings velocity and displacement back to zero is also the best estimate of
    offset and drift; the remaining error due to noise has the variance ``s^2 t^3 (T - t)^3 / (6 T^3)``.

    Examples
    --------
    >>> import jounce as jn, numpy as np
    >>> t = np.arange(0.0, 20.0, 0.001)
    >>> w = 2.0 * np.pi * 2.0
    >>> run = jn.recording(t, {"body.az": (0.3 - 0.01 * w**2 * np.sin(w * t), "m/s^2", "")})    # 10 mm, and an offset
    >>> (found,) = jn.integrate_acceleration(run, above="0.4 Hz").channels
    >>> middle = slice(8000, 12000)
    >>> bool(np.allclose(found.displacement[middle], 0.01 * np.sin(w * t[middle]), atol=1e-5))
    True
    """
    if motion not in get_args(Motion):
        raise unknown(str(motion), get_args(Motion), what="motion", where="motion")
    for name, given, of in (("above", above, "random"), ("period", period, "periodic")):
        if given is not None and motion != of:
            raise DescriptionError(
                Phrase("this option is for {of} motion", of=of),
                where=name,
                found=f"motion {motion}",
            )
    used = read_measured(record, begin, end)
    names = _accelerations(used, channels)
    moving, still = constant_channels(used, names)
    if not moving:
        raise RecordingError(
            "every acceleration is constant", where=used.name, found=", ".join(names)
        )
    length = to_si(period, "s", where="period") if period is not None else None
    corner = to_si(above, "Hz", where="above") if above is not None else None
    samples = used.run.sizes["time"]
    if motion == "periodic":
        samples = _whole_periods(used, length)
    time = used.run["time"].to_numpy()[:samples]

    def integrate_channel(name: str) -> tuple[IntegratedChannel, list[Finding]]:
        values = used.values(name)[:samples]
        level = _level(values)
        spectrum = _density(used, level)
        density = noise**2 if noise is not None else _floor(spectrum, used.highest_frequency(name))
        if motion == "random":
            chosen_corner, words = _corner(used, name, spectrum, corner)
            return _random(used, name, level, spectrum, density, chosen_corner), words
        if motion == "transient":
            return _transient(used, name, values, density), _not_at_rest(
                used, name, values, density
            )
        return _periodic(used, name, values, density, length or samples / used.rate), []

    with ThreadPoolExecutor(
        min(len(moving), processors())
    ) as threads:  # nearly all time is spent in Fourier transforms
        done = list(threads.map(integrate_channel, moving))
    results = [result for result, _ in done]
    findings = [*used.findings, *still, *(word for _, words in done for word in words)]
    margin = max(1.0 / channel.corner for channel in results) if motion == "random" else 0.0
    valid = float(time[0]) + margin, float(time[-1]) - margin
    return Integration(used.name, motion, time, valid, tuple(results), tuple(findings), used)


def _accelerations(used: Measured, channels: Sequence[str] | str | None) -> list[str]:
    names = select_channels(used, channels)
    usable = [name for name in names if used.unit(name) in _UNITS]
    wrong = [f"{name} in {used.unit(name)}" for name in names if name not in usable]
    if not usable or (channels is not None and wrong):
        raise RecordingError(
            "only accelerations are integrated",
            where=used.name,
            found=", ".join(wrong) or "none",
            allowed="channels in m/s^2 or rad/s^2",
            hint="Name the columns of the file, such as sprung.az.",
        )
    return usable


def _density(used: Measured, level: Array) -> Spectrum:
    """Spectral density of a detrended acceleration, from segments of a quarter of the record or 30 s."""
    count = min(max(len(level) // 4, 32), int(30.0 * used.rate))
    return power_spectrum(level, used.rate, segment=count / used.rate)


def _level(values: Array) -> Array:
    """Values minus their fitted straight line."""
    away: Array = values - values.mean()
    steps = np.arange(values.size, dtype=float)
    steps -= 0.5 * (values.size - 1)
    steps *= float(steps @ away) / float(steps @ steps)
    away -= steps
    return away


def _third_octaves(spectrum: Spectrum) -> tuple[Array, Array]:
    """Frequencies (Hz) from the second line on, and the mean density of the third octave around each."""
    f, total = spectrum.frequency, np.concatenate([[0.0], np.cumsum(spectrum.density)])
    inner = np.arange(2, len(f))
    low = np.minimum(np.searchsorted(f, f[inner] * 2.0 ** (-1.0 / 6.0)), inner)
    high = np.maximum(np.searchsorted(f, f[inner] * 2.0 ** (1.0 / 6.0)), inner + 1)
    return f[inner], (total[high] - total[low]) / (high - low)


def _floor(spectrum: Spectrum, highest: float) -> float:
    """Minimum of the third-octave densities."""
    f, density = _third_octaves(spectrum)
    # Anti-alias filters begin to act at four fifths of the highest frequency.
    inside = (f <= 0.8 * highest) & (f > _FEWEST_LINES * spectrum.step)
    return float(density[inside].min()) if inside.any() else float(density.min())


_FEWEST_LINES = 45.0  # ten in a third octave: the minimum of fewer is below the floor


def _corner(
    used: Measured, name: str, spectrum: Spectrum, given: float | None
) -> tuple[float, list[Finding]]:
    """Corner (Hz) of the high pass: as given, or where the density rises above its floor."""
    lowest = _FEWEST_CYCLES / used.duration
    at = f"{used.name}: {name}"
    if given is not None:
        if not lowest <= given < 0.25 * used.rate:  # above, half of the usable band is removed
            raise RecordingError(
                "the corner frequency does not suit the record",
                where=f"{at}: above",
                found=f"{given:g} Hz",
                allowed=Phrase(
                    "{lowest:.3g} Hz, {fewest_cycles:g} cycles of the record, to {rate:g} Hz",
                    lowest=lowest,
                    fewest_cycles=_FEWEST_CYCLES,
                    rate=0.25 * used.rate,
                ),
            )
        return given, []
    f, density = _third_octaves(spectrum)
    top = int(np.argmax(density / f))
    if top == 0 or f[top] <= lowest:
        raise RecordingError(
            "drift hides the motion: the density falls from the lowest frequency",
            where=at,
            allowed="a corner frequency of your choice, higher than this",
            hint="Check the spectrum and choose a corner frequency at which it rises above the drift.",
        )
    valley = int(np.argmin(density[:top]))
    above = np.flatnonzero(density[valley : top + 1] > _ABOVE_NOISE * density[valley])
    corner = max(float(f[valley + int(above[0])]) if above.size else float(f[top]) / 2.0, lowest)
    return corner, [finding("analysis.corner", at, corner, corner=corner)]


def _names(name: str) -> tuple[str, str]:
    words = _INTEGRALS.get(quantity_of(name))
    place = place_of(name)
    if words is None:
        return f"{name}.velocity", f"{name}.displacement"
    return tuple(f"{place}.{word}" if place else word for word in words)  # type: ignore[return-value]


def _gain(frequency: Array, corner: float) -> Array:
    """Gain of the high pass, 0 at 0."""
    x = (frequency / corner) ** _ORDER
    return np.asarray(x / (1.0 + x))


def _random(
    used: Measured, name: str, level: Array, spectrum: Spectrum, density: float, corner: float
) -> IntegratedChannel:
    """Integrate in the frequency domain, after extending the record by its mirror images."""
    from scipy import fft

    pad = min(len(level) - 1, int(3.0 / corner * used.rate))
    longer = np.pad(level, pad, mode="reflect")
    size = fft.next_fast_len(len(longer), real=True)
    angular = fft.rfftfreq(size, 0.5 / np.pi / used.rate)
    angular[0] = 1.0  # the gain is 0 there
    both = np.empty((2, len(angular)), dtype=complex)
    both[0] = fft.rfft(longer, size)
    both[0] *= _gain(angular, 2.0 * np.pi * corner) / angular
    both[0, 0] = 0.0
    both[0] *= -1j
    np.divide(both[0], angular, out=both[1])
    both[1] *= -1j
    velocity, displacement = fft.irfft(both, size, overwrite_x=True)[:, pad : pad + len(level)]
    f = spectrum.frequency[1:]
    lost = (
        np.sum(spectrum.density[1:] / (2.0 * np.pi * f) ** 4 * (1.0 - _gain(f, corner)) ** 2)
        * spectrum.step
    )
    return _channel(
        used,
        name,
        corner=corner,
        lowest=VALID * corner,
        noise=density,
        errors=_errors_above(density, corner, used.highest_frequency(name)),
        removed=float(lost) ** 0.5,
        velocity=velocity,
        displacement=displacement,
    )


def _errors_above(density: float, corner: float, highest: float) -> tuple[float, float]:
    """Standard deviations of velocity and displacement due to white noise through the high pass."""
    f = np.geomspace(0.02 * corner, highest, 2000)
    squared = density * _gain(f, corner) ** 2
    return tuple(
        float(np.trapezoid(squared / (2.0 * np.pi * f) ** power, f)) ** 0.5 for power in (2, 4)
    )


def _transient(used: Measured, name: str, values: Array, density: float) -> IntegratedChannel:
    """Integrate from rest to rest: subtract the straight line that makes both integrals end at zero."""
    from scipy.interpolate import CubicSpline

    time = np.arange(len(values)) / used.rate
    spline = CubicSpline(time, values)
    velocity, displacement = spline.antiderivative(1)(time), spline.antiderivative(2)(time)
    whole = float(time[-1])
    table = np.array([[whole, whole**2 / 2.0], [whole**2 / 2.0, whole**3 / 6.0]])
    offset, drift = np.linalg.solve(table, [velocity[-1], displacement[-1]])
    velocity = velocity - offset * time - drift * time**2 / 2.0
    displacement = displacement - offset * time**2 / 2.0 - drift * time**3 / 6.0
    line = offset * time**2 / 2.0 + drift * time**3 / 6.0
    # Standard deviation of the motion due to noise of this density, with both ends at rest, averaged over the record.
    errors = (0.5 * density * whole / 15.0) ** 0.5, (0.5 * density * whole**3 / 420.0) ** 0.5
    return _channel(
        used,
        name,
        corner=0.0,
        lowest=0.0,
        noise=density,
        errors=errors,
        removed=float(np.std(line)),
        velocity=velocity,
        displacement=displacement,
    )


def _not_at_rest(used: Measured, name: str, values: Array, density: float) -> list[Finding]:
    """Warn of a record that does not begin and end at rest."""
    few = max(8, len(values) // 50)
    # Motion at the ends exceeds a tenth of the range; below eight standard deviations it may be noise alone.
    ends = float(max(np.ptp(values[:few]), np.ptp(values[-few:])))
    if ends <= max(0.1 * float(np.ptp(values)), 8.0 * (density * used.rate / 2.0) ** 0.5):
        return []
    return [
        finding(
            "analysis.not_at_rest", f"{used.name}: {name}", ends, ends=ends, unit=used.unit(name)
        )
    ]


def _whole_periods(used: Measured, period: float | None) -> int:
    """Number of samples in the largest number of whole periods that fit in the record."""
    samples = int(used.run.sizes["time"])
    if period is None:
        return samples
    count = int((samples + 0.5) / (period * used.rate)) if period > 0.0 else 0
    if count < 1 or period * used.rate < 8.0:  # fewer samples do not resolve a period
        raise RecordingError(
            "the record contains no whole period",
            where=f"{used.name}: period",
            found=f"{period:g} s",
            allowed=Phrase(
                "{rate:g} s to {samples:g} s", rate=8.0 / used.rate, samples=samples / used.rate
            ),
        )
    return min(round(count * period * used.rate), samples)


def _periodic(
    used: Measured, name: str, values: Array, density: float, period: float
) -> IntegratedChannel:
    """Integrate a periodic motion at the multiples of its frequency."""
    size = len(values)
    count = max(round(size / used.rate / period), 1)
    frequency = np.fft.rfftfreq(size, 1.0 / used.rate)
    transform = np.fft.rfft(values)
    removed = transform.copy()
    removed[::count], removed[0] = 0.0, 0.0
    lines = np.zeros_like(transform)
    lines[count::count] = transform[count::count]
    s = 2j * np.pi * frequency
    s[0] = 1.0
    harmonics = frequency[count::count]
    share = density * used.rate / size
    errors = tuple(
        float(np.sum(share / (2.0 * np.pi * harmonics) ** power)) ** 0.5 for power in (2, 4)
    )
    return _channel(
        used,
        name,
        corner=0.0,
        lowest=float(frequency[count]),
        noise=density,
        errors=errors,
        removed=float(np.std(np.fft.irfft(removed / s**2, size))),
        velocity=np.fft.irfft(lines / s, size),
        displacement=np.fft.irfft(lines / s**2, size),
    )


def _channel(
    used: Measured,
    name: str,
    *,
    corner: float,
    lowest: float,
    noise: float,
    errors: tuple[float, float],
    removed: float,
    velocity: Array,
    displacement: Array,
) -> IntegratedChannel:
    band = lowest, used.highest_frequency(name)
    return IntegratedChannel(
        name,
        *_names(name),
        used.unit(name),
        corner,
        band,
        noise**0.5,
        *errors,
        removed,
        velocity,
        displacement,
    )
