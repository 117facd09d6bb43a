"""Stationary responses to random roads from the linear model: standard deviations without simulation."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

import numpy as np

from jounce.core.constants import NORMAL_95
from jounce.core.errors import DescriptionError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.parts import Rig, as_rig
from jounce.parts.dampers import MapDamper, damper_laws
from jounce.recordings.schema import channels_of, is_channel
from jounce.ride.covariance import KICKED, WANDERS, Gain, RandomVibration, Signal
from jounce.ride.family import Families, LinearFamily
from jounce.ride.metrics import gaps_of
from jounce.ride.surface import Density, Sides, Surface, surface
from jounce.ride.weighting import weighting_response

_ABSENT = {
    WANDERS: f'{WANDERS}; give band="iso" or a cut_off',
    KICKED: f'{KICKED}; give band="iso"',
}
_LIFTS = 3.0  # standard deviations: a Gaussian signal exceeds them for 0.13 % of the time
_TINY = 1e-12  # SI: rounding level of zero
_USUAL_SPEED = 0.3  # m/s, assumed without a channel; cars of the library have 0.22 to 0.25 r.m.s. on class C at 20 m/s
_BENDS = 0.1  # relative error of a damper's slope that is reported; standard deviations change by about half of it


@dataclass(frozen=True)
class StationaryResponse(Plain):
    """Standard deviations of a rig's channels on a random road, from its linear model about rest, SI.

    Attributes
    ----------
    standard_deviation : dict
        Standard deviation about the static value by channel.
    weighted : dict
        Weighted standard deviation, for channels with a weighting.
    static : dict
        Static value by channel.
    absent : dict
        Reason by channel, for channels without a stationary variance.
    units : dict
        SI unit by channel.
    slopes : dict
        Slope of the standard deviation by parameter path and channel, per SI unit of the parameter. Channels that would
        follow the road's height if the parameter changed are omitted.
    weighted_slopes : dict
        Slopes of the weighted standard deviations.
    surface : Surface
        Road and speed.
    findings : tuple of Finding
        Warnings about motions outside the validity of the linear model.
    spectra : Mapping of str to ndarray
        One-sided density by channel at ``frequency`` (Hz), SI unit squared per Hz; empty unless requested.
    frequency : ndarray or None
        Frequencies of the spectra, Hz.
    """

    also = ("load_coefficients",)
    left_out = ("spectra", "frequency")

    standard_deviation: dict[str, float]
    weighted: dict[str, float]
    static: dict[str, float]
    absent: dict[str, str]
    units: dict[str, str]
    slopes: dict[str, dict[str, float]]
    weighted_slopes: dict[str, dict[str, float]]
    surface: Surface
    findings: tuple[Finding, ...] = ()
    spectra: Mapping[str, Array] = field(default_factory=dict)
    frequency: Array | None = None

    def chance(self, channel: str, duration: float) -> float | None:
        """Return the relative sampling error (1) of a standard deviation over a ``duration`` (s), half a 95 % interval.

        For a Gaussian signal, the variance of the estimate is proportional to the integral of the squared density over
        the duration. None if the spectrum is unknown.
        """
        if self.frequency is None or channel not in self.spectra:
            return None
        density = self.spectra[channel]
        variance = float(np.trapezoid(density, self.frequency))
        scatter = math.sqrt(float(np.trapezoid(density**2, self.frequency)) / duration)
        return 0.5 * NORMAL_95 * scatter / variance if variance > 0.0 else None

    def __getitem__(self, channel: str) -> float:
        """Return the standard deviation of a channel, SI.

        Raises
        ------
        DescriptionError
            If a channel is unknown or absent; the message contains the reason.
        """
        if channel in self.standard_deviation:
            return self.standard_deviation[channel]
        error = unknown(
            channel, self.standard_deviation, what="stationary channel", where="stationary response"
        )
        if channel in self.absent:
            error = type(error)(
                f"{channel!r} has no stationary variance",
                where="stationary response",
                hint=self.absent[channel] + ".",
            )
        raise error

    def __str__(self) -> str:
        width = max(map(len, self.units))
        lines = [f"{'':{width}}  standard deviation  static (SI)"]
        for name, value in self.standard_deviation.items():
            unit = "" if self.units[name] == "1" else self.units[name]
            static = self.static[name] if abs(self.static[name]) > _TINY else 0.0
            lines.append(f"{name:{width}}  {value:10.4g} {unit:7}  {static:11.4g}")
        lines += [
            f"{name:{width}}  {value:10.4g}, weighted" for name, value in self.weighted.items()
        ]
        reasons = dict.fromkeys(self.absent.values())
        lines += [
            f"absent: {', '.join(name for name in self.absent if self.absent[name] == reason)}: {reason}"
            for reason in reasons
        ]
        return "\n".join([*lines, *map(str, self.findings)])

    @property
    def load_coefficients(self) -> dict[str, float]:
        """Dynamic wheel load coefficient (1) by channel: standard deviation of the tyre force over its static value."""
        return {
            name: value / self.static[name]
            for name, value in self.standard_deviation.items()
            if is_channel(name, "tyre.force") and self.static[name] > 0.0
        }


def stationary(
    rig: Rig | str | Path,
    road: str | float | Density,
    speed: float | str,
    *,
    band: tuple[float, float] | Literal["iso"] | None = None,
    cut_off: float | None = None,
    waviness: float = 2.0,
    sides: Sides | None = None,
    contact_length: float | str = 0.0,
    weighting: Mapping[str, str | Gain] | None = None,
    parameters: Sequence[str] = (),
) -> StationaryResponse:
    """Compute standard deviations of all channels on a random road, from the linear model about rest.

    Without a band the road's vertical velocity is white noise, and the exact covariance, including the delay of the
    rear wheels, follows from Lyapunov equations. With a band it is an integral over the road's spectrum.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name in the library.
    road : str, float or callable
        Class ("C", "iso:C"), degree of roughness G_d(n0) in m^3, or one-sided density (m^3) as a function of an array
        of spatial frequencies (1/m).
    speed : float or str
        m/s.
    band : tuple of float or "iso", optional
        Lowest and highest spatial frequency in 1/m; "iso" is 0.011 to 2.83, the range recommended by ISO 8608.
    cut_off : float, optional
        Spatial frequency n00 in 1/m below which the road is flat: ``dz/dt = -2 pi n00 v z + w``.
    waviness : float
        Exponent w of the spectrum (1); values other than 2 require a band.
    sides : {"uncorrelated", "same", "isotropic", "exponential"}, optional
        Relation of left and right wheels; the last two (:func:`jounce.roads.rough.track_coherence`) require a band.
        By default uncorrelated without a band and isotropic with one.
    contact_length : float or str
        Length over which the tyre averages the road, m; requires a band.
    weighting : mapping, optional
        Weighting by channel, or by channel suffix for all corners ("sprung.az"): an ISO 2631-1 weighting ("Wk") or a
        function that returns the magnitude at frequencies (Hz); requires a band.
    parameters : sequence of str
        Paths of parameters whose slopes are computed.

    Returns
    -------
    StationaryResponse
        Values in SI. Under white noise, channels that follow the road's height are unbounded and therefore absent.

    Raises
    ------
    DescriptionError
        If a class, channel or path is unknown, or options are inconsistent.
    SimulationError
        If there is no equilibrium, or the model about it is not asymptotically stable.

    Notes
    -----
    The model describes small motions about static equilibrium without lift-off, stops and friction; findings report
    when these matter.

    Examples
    --------
    >>> import jounce as jn
    >>> response = stationary(jn.load("audi-a6-half-car-4dof"), "B", "20 m/s", band="iso")
    >>> round(response["body.az"], 3), round(response.load_coefficients["front.tyre.force"], 3)
    (0.575, 0.104)
    """
    road_surface = surface(
        road,
        speed,
        waviness=waviness,
        band=band,
        cut_off=cut_off,
        sides=sides,
        contact_length=contact_length,
    )
    family = LinearFamily(as_rig(rig), tuple(parameters))
    outputs = family.compiled.facts.outputs
    names = [output.name for output in outputs]
    gains = _gains(weighting or {}, names)
    if gains and road_surface.band is None:
        raise DescriptionError(
            "this requires a frequency band",
            where="weighting",
            hint='Give band="iso" (0.011 to 2.83 1/m).',
        )
    count = len(names)
    signals = [Signal(i) for i in range(count)] + [
        Signal(names.index(name), gain) for name, gain in gains.items()
    ]
    moments = RandomVibration(Families((family,)), road_surface, tuple(signals)).at()
    sigma = np.sqrt(np.maximum(moments.variances[0], 0.0))
    slopes = moments.variance_slopes[0] / np.where(sigma > 0.0, 2.0 * sigma, np.inf)
    present = [i for i in range(count) if i not in moments.absent]
    static = dict(zip(names, map(float, moments.static[0, :count]), strict=True))
    values = {names[i]: float(sigma[i]) for i in present}
    return StationaryResponse(
        values,
        {name: float(sigma[count + i]) for i, name in enumerate(gains)},
        static,
        {names[i]: _ABSENT[reason] for i, reason in sorted(moments.absent.items())},
        {output.name: output.unit for output in outputs},
        {
            path: {names[i]: float(slopes[k, i]) for i in present if np.isfinite(slopes[k, i])}
            for k, path in enumerate(family.paths)
        },
        {
            path: {name: float(slopes[k, count + i]) for i, name in enumerate(gains)}
            for k, path in enumerate(family.paths)
        },
        road_surface,
        tuple(linear_findings(family.rig, values, static)),
    )


def with_spectra(
    response: StationaryResponse, rig: Rig, *, points: int = 800
) -> StationaryResponse:
    """Add the densities of a rig's channels over the band of the road, at ``points`` frequencies."""
    surface_ = response.surface
    if surface_.band is None:
        return response
    family = LinearFamily(rig, ())
    names = [output.name for output in family.compiled.facts.outputs]
    low, high = (n * surface_.speed for n in surface_.band)
    frequency = np.geomspace(low, high, points)
    densities = RandomVibration(
        Families((family,)), surface_, tuple(Signal(i) for i in range(len(names)))
    ).densities(frequency)
    known = {
        name: row
        for name, row in zip(names, densities, strict=True)
        if name in response.standard_deviation
    }
    return replace(response, spectra=known, frequency=frequency)


def weighting_gain(weighting: str | Gain) -> Gain:
    """Return the magnitude of a weighting as a function of frequency (Hz)."""
    if callable(weighting):
        return weighting
    return lambda frequency: np.abs(weighting_response(weighting, frequency))


def _gains(weighting: Mapping[str, str | Gain], names: Sequence[str]) -> dict[str, Gain]:
    gains: dict[str, Gain] = {}
    for name, chosen in weighting.items():
        channels = channels_of(name, names)
        if not channels:
            raise unknown(name, names, what="channel", where="weighting")
        gains.update(dict.fromkeys(channels, weighting_gain(chosen)))
    return gains


def linear_findings(
    rig: Rig, sigma: Mapping[str, float], static: Mapping[str, float]
) -> list[Finding]:
    """Report motions outside the validity of the linear model, from standard deviations and static values (SI)."""
    findings = []
    for name, value in sigma.items():
        if is_channel(name, "tyre.force") and 0.0 < static[name] < _LIFTS * value:
            times = static[name] / value
            share = 0.5 * math.erfc(times / math.sqrt(2.0))
            findings.append(
                finding("ride.contact_lost", name, share, share=share, deviations=times)
            )
    numbers = rig.parameters()
    findings += _stop_findings(rig, sigma, static)
    frictions = [
        path for path, value in numbers.items() if path.endswith("friction.force") and value > _TINY
    ]
    for path in frictions:
        findings.append(finding("ride.friction_at_rest", path, numbers[path]))
    for path in (path for path in numbers if path.endswith("damper.hysteretic_force")):
        findings.append(finding("ride.hysteresis_at_rest", path, numbers[path]))
    for path in (path for path in numbers if path.endswith("bump_coefficient")):
        findings.append(finding("ride.mean_coefficient", path, numbers[path]))
    return [*findings, *_nonlinear_dampers(rig, sigma)]


def _nonlinear_dampers(rig: Rig, sigma: Mapping[str, float]) -> Iterator[Finding]:
    """Report dampers whose slope at rest differs from their equivalent coefficient on this road.

    Third dampers are skipped because their velocity is unknown, and laws with a state because their slope at rest is
    not a damping coefficient.
    """
    for path, law in damper_laws(rig):
        if "third_spring" in path or law.remembers or isinstance(law, MapDamper):
            continue
        place = path.partition(".")[0]  # "strut", or the axle
        speeds = [
            sigma[name]
            for name in sigma
            if is_channel(name, "strut.velocity") and name.startswith(place)
        ]
        speed, whence = (
            max(speeds, default=_USUAL_SPEED),
            "standard deviation" if speeds else "assumed",
        )
        if speed <= 0.0:
            continue
        equivalent, at_rest = law.statistical_coefficient(speed), law.slope_at_rest()
        if abs(equivalent - at_rest) > _BENDS * abs(equivalent):
            yield finding(
                "ride.curve_bends",
                path,
                equivalent,
                speed=speed,
                whence=whence,
                equivalent=equivalent,
                at_rest=at_rest,
            )


def _stop_findings(
    rig: Rig, sigma: Mapping[str, float], static: Mapping[str, float]
) -> list[Finding]:
    struts = [name for name in sigma if is_channel(name, "strut.deflection") and sigma[name] > 0.0]
    gaps = gaps_of(
        rig, [name.removesuffix("strut.deflection").removesuffix(".") for name in struts]
    )
    findings = []
    for name, (rebound, bump) in zip(struts, gaps.values(), strict=True):
        for stop, gap, sign in (("bump", bump, 1.0), ("rebound", rebound, -1.0)):
            if gap is None:
                continue
            room = (gap - sign * static[name]) / sigma[name]
            if room < _LIFTS:
                findings.append(
                    finding("ride.stop_near", name, room, stop=f"{stop} stop", room=room)
                )
    return findings
