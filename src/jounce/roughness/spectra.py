"""ISO 8608 road spectra, equivalent noise, and the roughness of measured profiles."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import as_number
from jounce.roads.rough import BAND, CLASSES, MEAN_A, REFERENCE, RoadClass, as_roughness

_UNEVEN = 1e-3  # share of the spacing
_PER_OCTAVE = 3  # bands for the line fit: enough averages per band, and enough bands


def roughness_class(roughness: float) -> RoadClass:
    """Return the road class, "A" to "H", of a degree of roughness G_d(n0) in m^3, above 0.

    The limit between two classes is twice the mean of the smoother class. Smoother or rougher roads are "A" or "H".

    Examples
    --------
    >>> roughness_class(256e-6), roughness_class(31e-6), roughness_class(33e-6)
    ('C', 'A', 'B')
    """
    if not (math.isfinite(roughness) and roughness > 0.0):
        raise DescriptionError(
            "invalid degree of roughness", found=f"{roughness} m^3", allowed="above 0 m^3"
        )
    place = math.floor(math.log(roughness / (0.5 * MEAN_A), 4.0))
    return CLASSES[min(max(place, 0), len(CLASSES) - 1)]


def road_psd(road: str | float, n: ArrayLike, *, waviness: float = 2.0) -> Array:
    """Return the one-sided spectral density of the height, G_d(n) = G_d(n0) (n / n0)^-w with n0 = 0.1 1/m.

    Parameters
    ----------
    road : str or float
        Class "A" to "H", or a degree of roughness G_d(n0) in m^3.
    n : array_like
        Spatial frequencies in cycles per metre (1/m), above 0; not the angular frequency in rad/m.
    waviness : float
        Exponent w (1).

    Returns
    -------
    ndarray
        G_d in m^3, the shape of ``n``. The density over angular frequency is smaller by a factor of 2 pi.

    Raises
    ------
    DescriptionError
        If the class is unknown or a frequency is not positive.

    Notes
    -----
    ISO 8608:2016 (key iso-8608).

    Examples
    --------
    >>> (1e6 * road_psd("A", [0.1, 0.2])).round(6).tolist()
    [16.0, 4.0]
    """
    at = as_samples(n, "1/m", where="n", error=DescriptionError)
    if not (np.isfinite(at).all() and (at > 0.0).all()):
        raise DescriptionError(
            "invalid spatial frequency", found="0, negative, or not finite", allowed="above 0 1/m"
        )
    return np.asarray(
        as_roughness(road) * (at / REFERENCE) ** -as_number(waviness, "1", where="waviness")
    )


def white_noise_intensity(road: str | float, speed: float) -> float:
    """Return the white-noise intensity W of the vertical velocity of a road with waviness 2.

    Parameters
    ----------
    road : str or float
        Class "A" to "H", or a degree of roughness G_d(n0) in m^3.
    speed : float
        Speed in m/s, above 0.

    Returns
    -------
    float
        W = 2 pi^2 n0^2 G_d(n0) v in m^2/s: E[w(t) w(t + s)] = W delta(s). The one-sided density of the velocity
        is 2 W (m^2/s^2/Hz).

    Examples
    --------
    >>> round(1e5 * white_noise_intensity("A", 20.0), 4)
    6.3165
    """
    speed = as_number(speed, "m/s", where="speed")
    if not (math.isfinite(speed) and speed > 0.0):
        raise DescriptionError("invalid speed", found=f"{speed} m/s", allowed="above 0 m/s")
    return 2.0 * math.pi**2 * REFERENCE**2 * as_roughness(road) * speed


def filtered_noise(
    road: str | float, speed: float, *, cutoff: float = BAND[0]
) -> tuple[float, float]:
    """Return a first-order filter from white noise to the height of a road with waviness 2, at a speed in m/s above 0.

    Pole and gain are those of dz/dt = -pole z + gain w with w of one-sided density 1 per Hz (two-sided 1/2):
    pole = 2 pi cutoff v in 1/s, gain = 2 pi n0 sqrt(G_d(n0) v) in m/s; the variance of z is gain^2 / (4 pole). Below
    ``cutoff`` (1/m) the spectrum is flat, which makes the variance finite. The road is a class or G_d(n0) in m^3.

    Examples
    --------
    >>> pole, gain = filtered_noise("C", 20.0)
    >>> round(pole, 4), round(gain, 5), round(1e3 * (gain**2 / (4 * pole)) ** 0.5, 2)  # 1/s, m/s, mm
    (1.3823, 0.04496, 19.12)
    """
    intensity = white_noise_intensity(road, speed)
    if not (math.isfinite(cutoff) and cutoff > 0.0):
        raise DescriptionError(
            "invalid spatial frequency", found=f"{cutoff} 1/m", allowed="above 0 1/m"
        )
    return 2.0 * math.pi * cutoff * speed, math.sqrt(2.0 * intensity)


@dataclass(frozen=True)
class RoadSpectrum(Shown):
    """Spectrum of a profile and a line fitted to it, SI units.

    Attributes
    ----------
    roughness : float
        G_d(n0) of the line in m^3 at n0 = 0.1 1/m.
    waviness : float
        Exponent w (1) of the line.
    road_class : str
        ISO 8608 class of this roughness.
    band : tuple of float
        Range of spatial frequencies in 1/m in which the line was fitted.
    deviation : float
        Standard deviation of the smoothed spectrum from the line in dB.
    n, psd : ndarray
        Spatial frequencies in 1/m and one-sided density G_d in m^3.
    """

    roughness: float
    waviness: float
    road_class: RoadClass
    band: tuple[float, float]
    deviation: float
    n: Array = field(repr=False)
    psd: Array = field(repr=False)


def estimate_roughness(
    x: ArrayLike,
    height: ArrayLike,
    *,
    band: tuple[float, float] = BAND,
    waviness: float | None = None,
) -> RoadSpectrum:
    """Estimate spectrum, degree of roughness and class of a profile with evenly spaced points.

    Parameters
    ----------
    x : array_like, shape (n,)
        Distance in m, ascending and evenly spaced.
    height : array_like, shape (n,)
        Height in m.
    band : tuple of float
        Lowest and highest spatial frequency in 1/m for the fit, limited to the range of the profile.
    waviness : float, optional
        Fixed exponent (1), 2 for a standard class; fitted by default.

    Returns
    -------
    RoadSpectrum
        Spectrum, fitted line (logarithmic least squares over third-octave bands) and class.

    Raises
    ------
    RecordingError
        For unequal lengths, values that are not finite, unevenly spaced x, and profiles too short or too coarse for a
        fit over two octaves.

    Notes
    -----
    Welch's method (Hann windows with 50 % overlap) is applied to the slope, whose flat spectrum prevents leakage from
    long waves into short ones. The result is divided by the gain of the difference. Exclude fades of synthetic roads.

    Examples
    --------
    >>> from jounce.roads import Iso8608
    >>> x, height = Iso8608(class_="D", length=4000.0, run_in=0.0).points()
    >>> spectrum = estimate_roughness(x, height)
    >>> spectrum.road_class, round(spectrum.waviness, 1)
    ('D', 2.0)
    """
    step, z = _check_profile(x, height)
    waviness = None if waviness is None else as_number(waviness, "1", where="waviness")
    band = (as_number(band[0], "1/m", where="band[0]"), as_number(band[1], "1/m", where="band[1]"))
    n, psd, averages = _welch(step, z, band[0])
    low, high = max(band[0], n[0]), min(band[1], 0.4 / step)
    centre, level, weight = _average_bands(n, psd, (low, high), averages)
    if len(centre) < 2 * _PER_OCTAVE:
        raise RecordingError(
            "the profile is too short or too coarse for its roughness",
            found=f"{step * (len(z) - 1):g} m with points every {step:g} m",
            allowed=Phrase(
                "waves over two octaves between {band:g} and {second_band:g} 1/m",
                band=band[0],
                second_band=band[1],
            ),
        )
    across = np.log10(centre / REFERENCE)
    if waviness is None:
        slope, offset = np.polyfit(across, level, 1, w=np.sqrt(weight))
    else:
        slope = -waviness
        offset = float(np.average(level - slope * across, weights=weight))
    rest = level - slope * across - offset
    roughness = float(10.0**offset)
    deviation = 10.0 * float(np.sqrt(np.average(rest**2, weights=weight)))
    return RoadSpectrum(
        roughness,
        -float(slope),
        roughness_class(roughness),
        (float(low), float(high)),
        deviation,
        n,
        psd,
    )


def _check_profile(x: ArrayLike, height: ArrayLike) -> tuple[float, Array]:
    at, z = as_samples(x, "m", where="x"), as_samples(height, "m", where="height")
    if at.ndim != 1 or at.shape != z.shape or len(at) < 16:
        raise RecordingError(
            "invalid profile",
            found=f"{at.shape} distances, {z.shape} heights",
            allowed="at least 16 of both",
        )
    if not (np.isfinite(at).all() and np.isfinite(z).all()):
        raise RecordingError(
            "the profile contains NaN or infinite values", hint="Fill the gaps or cut them off."
        )
    steps = np.diff(at)
    step = float((at[-1] - at[0]) / (len(at) - 1))
    if step <= 0.0 or np.abs(steps - step).max() > _UNEVEN * step:
        i = int(np.argmax(np.abs(steps - step)))
        raise RecordingError(
            "the distance is reversed" if step <= 0.0 else "the points are not evenly spaced",
            found=f"{steps[i]:g} m after x = {at[i]:g} m, on average {step:g} m",
            hint="Sort the points, or interpolate them to even spacing.",
        )
    return step, z


def _welch(step: float, z: Array, low: float) -> tuple[Array, Array, float]:
    """Return spatial frequencies (1/m), density (m^3) computed from the slope, and the number of averages."""
    from scipy.signal import welch

    segment = min(len(z) - 1, max(16, round(5.0 / (low * step))))
    n, slope_psd = welch(np.diff(z) / step, fs=1.0 / step, nperseg=segment, detrend="constant")
    n, slope_psd = n[2:], slope_psd[2:]  # the window spreads the mean over the first two lines
    return n, slope_psd / (2.0 * np.sin(np.pi * n * step) / step) ** 2, (len(z) - 1) / segment


def _average_bands(
    n: Array, psd: Array, band: tuple[float, float], averages: float
) -> tuple[Array, Array, Array]:
    """Average the level (log10 m^3) in third-octave bands; return also the weight of each band (1)."""
    low, high = band[0], band[1] - n[0]  # the window spreads the end of the band over two lines
    count = int(np.ceil(_PER_OCTAVE * np.log2(high / low) - 1e-9)) if high > low else 0
    borders = low * 2.0 ** (np.arange(count + 1) / _PER_OCTAVE)
    centres, levels, weights = [], [], []
    for left, right in pairwise(borders):
        inside = (n >= left) & (n < min(right, high))
        if inside.any():
            centre = 10.0 ** np.log10(n[inside]).mean()
            flat = psd[inside] * (n[inside] / centre) ** 2
            values = (
                float(inside.sum()) * averages
            )  # independent values with two degrees of freedom each
            # the mean of a logarithm is below the logarithm of the mean
            levels.append(np.log10(np.mean(flat)) + 0.5 / (values * np.log(10.0)))
            centres.append(centre)
            weights.append(values / (values + 10.0))
    return np.array(centres), np.array(levels), np.array(weights)
