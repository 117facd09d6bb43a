"""Rough roads: ISO 8608 classes, random roads with two tracks, and a deterministic benchmark."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray
from pydantic import BeforeValidator, Field

from jounce.core.description import Seed, Whole
from jounce.core.errors import DescriptionError, unknown
from jounce.core.misplaced import error_at, misplaced_value
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.core.units import (
    Length,
    NonNegativeLength,
    PositiveLength,
    PositiveNumber,
    Unit,
    as_number,
)
from jounce.roads.profile import Profile, hermite_profile, lay_out, linear_profile, periodic_places
from jounce.roads.road import Road, SampledRoad

RoadClass = Literal["A", "B", "C", "D", "E", "F", "G", "H"]
CLASSES: tuple[RoadClass, ...] = ("A", "B", "C", "D", "E", "F", "G", "H")
REFERENCE = 0.1  # 1/m: n0 of ISO 8608, the reference of the degree of roughness
BAND = (0.011, 2.83)  # 1/m: range recommended by ISO 8608
MEAN_A = 16e-6  # m^3: geometric mean of class A; it increases by a factor of four per class
SpatialFrequency = Annotated[float, Unit("1/m", above=0.0)]
Roughness = Annotated[float, Unit("m^3", above=0.0)]
Waviness = Annotated[float, Unit("1", above=0.0, at_most=5.0)]
GOLDEN = 0.6180339887498949  # (sqrt(5) - 1) / 2
MOST_POINTS = 20_000_000  # 160 MB
_LINES = 10.0  # minimum number of spectral lines up to twice the lowest frequency


def class_roughness(name: str, *, where: str = "") -> float:
    """Return the degree of roughness G_d(n0) in m^3 of a road class: its geometric mean at n0 = 0.1 1/m.

    Parameters
    ----------
    name : str
        "A" (very good) to "H"; lower case is accepted.
    where : str
        Location named in errors.

    Returns
    -------
    float
        16e-6 m^3 for A, increasing by a factor of four per class.

    Raises
    ------
    DescriptionError
        For any other name.

    Examples
    --------
    >>> round(1e6 * class_roughness("C"))
    256
    """
    letter = str(name).strip().upper()
    if letter not in CLASSES:
        raise unknown(str(name), CLASSES, what="road class", where=where)
    return float(MEAN_A * 4 ** CLASSES.index(letter))


def as_roughness(road: str | float, *, where: str = "") -> float:
    """Convert a class name to its degree of roughness in m^3; a number (m^3, above 0) is returned unchanged."""
    if isinstance(road, str):
        return class_roughness(road, where=where)
    try:
        roughness = as_number(road, "m^3", where=where)
    except DescriptionError:  # a table, or an integer too large for a float
        roughness = math.nan
    if not (math.isfinite(roughness) and roughness > 0.0):
        raise DescriptionError(
            "invalid degree of roughness", where=where, found=road, allowed="above 0 m^3, or A to H"
        )
    return roughness


def height_variance(
    roughness: float, low: ArrayLike, high: ArrayLike, waviness: float = 2.0
) -> Array:
    """Integrate G_d from ``low`` to ``high`` (1/m), in m^2; ``roughness`` in m^3.

    Examples
    --------
    >>> round(1e3 * float(height_variance(16e-6, 0.011, 2.83)) ** 0.5, 3)  # mm
    3.806
    """
    low, high = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
    if waviness == 1.0:
        return np.asarray(roughness * REFERENCE * np.log(high / low))
    power = waviness - 1.0
    scale = roughness * REFERENCE**waviness / power
    return np.asarray(scale * (low**-power - high**-power))


def track_coherence(
    n: ArrayLike,
    track: float | Array,
    *,
    model: str = "isotropic",
    decay: float = 5.7,
    waviness: float = 2.0,
) -> Array:
    """Compute the coherence gamma^2 between the heights under the left and the right wheels.

    Parameters
    ----------
    n : array_like
        Spatial frequencies in 1/m, at least 0.
    track : float
        Lateral distance of the tracks in m; an array is broadcast with ``n``.
    model : {"isotropic", "exponential"}
        ``"isotropic"``: the surface has the same spectrum in every direction, gamma = 2 / Gamma(w/2) (y/2)^(w/2)
        K_(w/2)(y) with y = 2 pi n B (for w = 2 this is y K_1(y)); ``"exponential"``: gamma^2 = exp(-decay n B).
    decay : float
        Decay (1) of the exponential model. By default it is one half at the same frequency as the isotropic model with
        w = 2.
    waviness : float
        Exponent w (1) of the isotropic model.

    Returns
    -------
    ndarray
        gamma^2 (1), from 1 for long waves to 0 for short ones; the shape of ``n``.

    Examples
    --------
    >>> track_coherence([0.0, 0.05, 0.5], 1.5).round(3).tolist()
    [1.0, 0.708, 0.001]
    """
    at = as_samples(n, "1/m", where="n", error=DescriptionError)
    if model == "exponential":
        return np.asarray(np.exp(-decay * at * track))
    from scipy.special import gamma, kv

    order = 0.5 * waviness
    y = 2.0 * math.pi * np.maximum(at, 1e-9 / track) * track
    return np.asarray(np.minimum(2.0 / gamma(order) * (0.5 * y) ** order * kv(order, y), 1.0) ** 2)


def _letter(value: object) -> object:
    """Normalise a class name; the error lists the classes."""
    if isinstance(value, str):
        try:
            class_roughness(value)
        except DescriptionError as error:
            raise misplaced_value((), error) from None
        return value.strip().upper()
    return value


ClassName = Annotated[RoadClass, BeforeValidator(_letter)]


def _one_roughness(class_: str | None, roughness: float | None) -> float:
    if (class_ is None) == (roughness is None):
        given = (
            "neither a class nor a roughness is"
            if class_ is None
            else "both a class and a roughness are"
        )
        raise ValueError(
            Phrase(
                '{given} given; give class = "A" to "H", or roughness = G_d(0.1 1/m) in m^3',
                given=given,
            )
        )
    return class_roughness(class_) if class_ is not None else float(roughness or 0.0)


class Iso8608(SampledRoad):
    """Random road of an ISO 8608 class; the same seed gives the same road.

    The height is a sum of cosines with equally spaced spatial frequencies, random phases and amplitudes
    A = sqrt(2 G_d(n) dn), so every road matches the level of its class exactly; its mean is zero. It is faded in and
    out over ``run_in`` by half a cosine wave, so both ends are level, without a jump or a kink. The left and right
    roads of the same seed are the two tracks of one road.

    Attributes
    ----------
    class : {"A", ..., "H"}
        Road class with its geometric mean; ``class_`` in Python. Mutually exclusive with ``roughness``.
    roughness : float
        Degree of roughness G_d(n0) in m^3 at n0 = 0.1 1/m.
    length : float
        Length in m; the road is level before and after it.
    step : float
        Spacing of the points in m, 5 cm; slightly reduced if the length is not a multiple of it.
    seed : int
        Seed of the random phases.
    waviness : float
        Exponent w (1) of the spectrum, 2.
    band : tuple of float
        Lowest and highest spatial frequency in 1/m, 0.011 to 2.83; limited to half the sampling frequency.
    run_in : float or None
        Length in m of the fades; by default 10 m or a tenth of the length, if that is less. Metrics may exclude it.
    side : {"left", "right"}
        Track.
    track : float
        Lateral distance in m between the two tracks, 1.5 m.
    coherence : {"isotropic", "exponential"}
        Coherence model of the tracks, see `track_coherence`.
    coherence_decay : float
        Decay (1) of the exponential coherence.
    interpolation : {"linear", "cubic"}
        Lines between the points, or cubics with exact slopes.
    start : float
        Distance in m at which the road begins; negative if the run begins inside it.

    Notes
    -----
    Spectrum: ISO 8608:2016 (key iso-8608). The fades remove 5/8 of the power of 2 ``run_in``: -0.055 dB per kilometre.
    Linear interpolation attenuates a wave of spatial frequency n by sinc^2(n step): 6 % in height at 2.83 1/m and 5 cm.

    Examples
    --------
    >>> left = Iso8608(class_="C", length="500 m", seed=1)
    >>> right = left.other_track()
    >>> float(left.height_at(0.0)), right.side, bool(abs(left.height_at(250.0)) < 0.1)
    (0.0, 'right', True)
    """

    kind: Literal["iso-8608"] = "iso-8608"
    start: Length = 0.0
    class_: ClassName | None = Field(default=None, alias="class")
    roughness: Roughness | None = None
    length: PositiveLength
    step: PositiveLength = 0.05
    seed: Seed = 0
    waviness: Waviness = 2.0
    band: tuple[SpatialFrequency, SpatialFrequency] = BAND
    run_in: NonNegativeLength | None = None
    side: Literal["left", "right"] = "left"
    track: PositiveLength = 1.5
    coherence: Literal["isotropic", "exponential"] = "isotropic"
    coherence_decay: PositiveNumber = 5.7
    interpolation: Literal["linear", "cubic"] = "linear"

    def check(self) -> None:
        """Reject class and roughness together, overlapping fades, and too many points."""
        _one_roughness(self.class_, self.roughness)
        low, high = self.band
        if high <= low:
            raise ValueError(
                Phrase(
                    "band: {high:g} 1/m is not above {low:g} 1/m; give [lowest, highest]",
                    high=high,
                    low=low,
                )
            )
        if low >= 0.5 / self.step:
            raise ValueError(
                Phrase(
                    "points every {step:g} m cannot represent waves of {low:g} 1/m and more; make step smaller",
                    step=self.step,
                    low=low,
                )
            )
        if 2.0 * self.fade > self.length * (1.0 + 1e-9):
            text = "two fades of {fade:g} m do not fit into the length {length:g} m"
            most = Phrase("a run_in up to {most:g} m", most=0.5 * self.length)
            raise error_at((), Phrase(text, fade=self.fade, length=self.length), allowed=most)
        points = _points(self.length, self.step) * _periods(self.length, low)
        if points > MOST_POINTS:
            most = Phrase("up to {most}; make step larger or the road shorter", most=MOST_POINTS)
            raise error_at((), Phrase("{points} points", points=points), allowed=most)

    @property
    def degree_of_roughness(self) -> float:
        """Return G_d(n0) in m^3 at n0 = 0.1 1/m, from the class or as given."""
        return _one_roughness(self.class_, self.roughness)

    @property
    def fade(self) -> float:
        """Return the length in m over which the road is faded in and out."""
        return min(10.0, 0.1 * self.length) if self.run_in is None else self.run_in

    def other_track(self) -> Iso8608:
        """Return the track of the other side of the same road."""
        return self.model_copy(update={"side": "left" if self.side == "right" else "right"})

    def points(self) -> tuple[Array, Array]:
        """Return the points of the road: distance from ``start`` and height, both in m, each of shape (n + 1,)."""
        x, height, _ = self._sample()
        return x, height

    def profile(self) -> Profile:
        """Return the pieces between the points."""
        return _iso_profile(*self._key())

    def end(self) -> float:
        """Return the distance in m at which the road ends."""
        return self.start + self.length

    def point_spacing(self) -> float:
        """Return the distance in m between the points."""
        return self.length / _points(self.length, self.step)

    def _key(self) -> tuple[Any, ...]:
        coherence = (
            (self.track, self.coherence, self.coherence_decay) if self.side == "right" else None
        )
        spectrum = (self.degree_of_roughness, self.waviness, self.band)
        return spectrum, self.length, self.step, self.seed, self.fade, coherence, self.interpolation

    def _sample(self) -> tuple[Array, Array, Array | None]:
        return _sample(*self._key())


def _points(length: float, step: float) -> int:
    return max(2, math.ceil(length / step - 1e-9))


def _periods(length: float, low: float) -> int:
    """Return the period of the sum of cosines in road lengths; short roads need a finer frequency spacing."""
    return max(1, math.ceil(_LINES / (low * length) - 1e-9))


def _phases(seed: int, stream: int, count: int) -> Array:
    """Draw phases in rad, uniform over [0, 2 pi), from the bit stream of PCG64, which NumPy guarantees to keep."""
    bits = np.random.PCG64(np.random.SeedSequence((seed, stream))).random_raw(count)
    return np.asarray(bits >> np.uint64(11), dtype=float) * (2.0 * math.pi / 2**53)


def _track_offset(spread: Array, seed: int) -> Array:
    """Draw the phase difference in rad of the other track, from a normal distribution with mean cosine gamma."""
    from scipy.special import ndtri

    share = np.clip(_phases(seed, 1, len(spread)) / (2.0 * math.pi), 2.0**-54, 1.0 - 2.0**-53)
    return np.asarray(spread * ndtri(share))


@lru_cache(maxsize=2)  # as long as profiles
def _track_spread(
    spectrum: tuple[float, float, tuple[float, float]],
    length: float,
    step: float,
    coherence: tuple[float, str, float],
) -> Array:
    """Return the standard deviation of the phase difference, which does not depend on the seed."""
    track, model, decay = coherence
    _, n, _ = _amplitudes(spectrum, length, step)
    gamma = np.sqrt(track_coherence(n, track, model=model, decay=decay, waviness=spectrum[1]))
    return np.asarray(np.sqrt(-2.0 * np.log(np.clip(gamma, 1e-200, 1.0))))


def _sample(
    spectrum: tuple[float, float, tuple[float, float]],
    length: float,
    step: float,
    seed: int,
    fade: float,
    coherence: tuple[float, str, float] | None,
    interpolation: str,
) -> tuple[Array, Array, Array | None]:
    """Return the points of a road and, for cubics, the slopes there."""
    count, periods = _points(length, step), _periods(length, spectrum[2][0])
    total = count * periods
    lines, n, size = _amplitudes(spectrum, length, step)
    phase = _phases(seed, 0, len(n))
    if coherence is not None:
        phase += _track_offset(_track_spread(spectrum, length, step, coherence), seed)
    waves = np.zeros(total // 2 + 1, dtype=complex)
    waves[lines] = size * np.exp(1j * phase)
    x = np.linspace(0.0, length, count + 1)
    height = _over_length(waves, total, count)
    if interpolation == "linear":
        return (
            x,
            height * _fade(x, length, fade)[0] + 0.0,
            None,
        )  # + 0.0 turns -0.0 at a zero fade into 0.0
    waves[lines] *= 2j * math.pi * n
    slope = _over_length(waves, total, count)
    share, share_slope = _fade(x, length, fade)
    return x, height * share + 0.0, slope * share + height * share_slope


@lru_cache(maxsize=2)  # as long as profiles
def _amplitudes(
    spectrum: tuple[float, float, tuple[float, float]], length: float, step: float
) -> tuple[slice, Array, Array]:
    """Return index, spatial frequency (1/m) and half amplitude of the waves, for any seed."""
    roughness, waviness, (low, high) = spectrum
    count, periods = _points(length, step), _periods(length, low)
    total, spacing = count * periods, 1.0 / (length * periods)
    high = min(high, 0.5 * count / length)
    first, last = max(1, round(low / spacing)), min(round(high / spacing), (total - 1) // 2)
    n: Array = np.asarray(np.arange(first, last + 1) * spacing, dtype=float)
    # each line has the power of its bin; the first and last bins are limited to the band
    power = height_variance(
        roughness,
        np.clip(n - 0.5 * spacing, low, high),
        np.clip(n + 0.5 * spacing, low, high),
        waviness,
    )
    return slice(first, max(last + 1, first)), n, 0.5 * total * np.sqrt(2.0 * power)


def _over_length(waves: Array | NDArray[np.complex128], total: int, count: int) -> Array:
    """Return values at the first ``count + 1`` points of a period of ``total`` points."""
    values = np.fft.irfft(waves, total)
    return np.append(values[:count], values[count % total])


def _fade(x: Array, length: float, fade: float) -> tuple[Array, Array]:
    """Return the fade factor (1), half a cosine wave at each end, and its derivative (1/m)."""
    share, slope = np.ones_like(x), np.zeros_like(x)
    if fade == 0.0:
        return share, slope
    near = np.minimum(x, length - x)
    inside = near < fade
    angle = math.pi * near[inside] / fade
    side = np.where(x[inside] < 0.5 * length, 1.0, -1.0)
    share[inside] = 0.5 * (1.0 - np.cos(angle))
    slope[inside] = side * 0.5 * math.pi / fade * np.sin(angle)
    return share, slope


@lru_cache(maxsize=4)  # 10 km at 1 cm are 48 MB
def _iso_profile(*key: Any) -> Profile:
    x, height, slope = _sample(*key)
    return linear_profile(x, height) if slope is None else hermite_profile(x, height, slope)


class SineSum(Road):
    """Deterministic rough road: cosines at multiples of one spatial frequency with golden-ratio phases.

    z(x) = sum of A_i cos(2 pi n_i x + phi_i) with n_i = i ``spacing``, A_i = sqrt(2 G_d(n_i) spacing) and
    phi_i = 2 pi frac(0.6180339887498949 i), for i from ``first`` to ``last``. It repeats after 1 / ``spacing``
    without ends, so steady-state values can be computed over one period. The defaults are the class C benchmark for the
    comparison of controllers. The phases are proportional to i, so all waves coincide in one sharp peak per period: in
    effect a train of pulses. Mean squares are those of the class; peaks and lift-off are not those of a random road
    (use `Iso8608` where they matter).

    Attributes
    ----------
    class : {"A", ..., "H"}
        Road class; ``class_`` in Python. Mutually exclusive with ``roughness``; by default C.
    roughness : float
        Degree of roughness G_d(n0) in m^3 at n0 = 0.1 1/m.
    spacing : float
        Spatial frequency n_1 in 1/m, 0.01.
    first, last : int
        Indices of the lowest and the highest cosine, 2 and 300.
    waviness : float
        Exponent w (1) of the spectrum, 2.
    step : float
        Spacing of the points in m, 2 cm; they are joined by cubics with exact slopes.
    start : float
        Distance in m of x = 0.

    Examples
    --------
    >>> road = SineSum()
    >>> x = road.period() * np.arange(1000) / 1000
    >>> round(1e3 * float(np.sqrt(np.mean(road.height_at(x) ** 2))), 5), road.period()  # mm, m
    (12.81605, 100.0)
    """

    kind: Literal["sine-sum"] = "sine-sum"
    start: Length = 0.0
    class_: ClassName | None = Field(default=None, alias="class")
    roughness: Roughness | None = None
    spacing: SpatialFrequency = 0.01
    first: Whole = Field(default=2, ge=1)
    last: Whole = Field(default=300, ge=1, le=1_000_000)
    waviness: Waviness = 2.0
    step: PositiveLength = 0.02

    def check(self) -> None:
        """Reject an empty sum, class and roughness together, a recurrence, and a step too long for the waves."""
        if self.recurrence is not None:
            raise ValueError("the sum of sines repeats by itself; leave out recurrence")
        self._roughness()
        if self.last < self.first:
            raise ValueError(
                Phrase("last = {last} is below first = {first}", last=self.last, first=self.first)
            )
        shortest = 1.0 / (self.last * self.spacing)
        if self.step > 0.25 * shortest:  # a cubic over a quarter wave has a height error of 1.6 %
            raise ValueError(
                Phrase(
                    "points every {step:g} m cannot represent waves of {shortest:g} m; make step smaller",
                    step=self.step,
                    shortest=shortest,
                )
            )
        if _points(self.period(), self.step) > MOST_POINTS:
            raise ValueError(
                Phrase(
                    "more than {most_points} points in one period; make step or spacing larger",
                    most_points=MOST_POINTS,
                )
            )

    def period(self) -> float:
        """Return the distance in m after which the road repeats."""
        return 1.0 / self.spacing

    def is_course(self) -> bool:
        """Always."""
        return True

    def profile(self) -> Profile:
        """Return the pieces of one period."""
        return _sum_profile(
            self._roughness(), self.spacing, self.first, self.last, self.waviness, self.step
        )

    def _roughness(self) -> float:
        if self.class_ is None and self.roughness is None:
            return class_roughness("C")
        return _one_roughness(self.class_, self.roughness)

    def _between(self, low: float, high: float) -> Segments:
        return lay_out(
            self.profile(), periodic_places(self.start, self.period(), low, high), low, high
        )


@lru_cache(maxsize=8)
def _sum_profile(
    roughness: float, spacing: float, first: int, last: int, waviness: float, step: float
) -> Profile:
    count = _points(1.0 / spacing, step)
    i = np.arange(first, last + 1)
    n = spacing * i
    amplitude = np.sqrt(2.0 * roughness * (n / REFERENCE) ** -waviness * spacing)
    waves = np.zeros(count // 2 + 1, dtype=complex)
    waves[i] = 0.5 * count * amplitude * np.exp(2j * math.pi * np.mod(GOLDEN * i, 1.0))
    height = _over_length(waves, count, count)
    waves[i] *= 2j * math.pi * n
    return hermite_profile(
        np.linspace(0.0, 1.0 / spacing, count + 1), height, _over_length(waves, count, count)
    )
