"""Road classes of ISO 8608: spectral densities, limits, and the white noise that stands for a road at a speed."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import DescriptionError, unknown
from jounce.core.types import Array

RoadClass = Literal["A", "B", "C", "D", "E", "F", "G", "H"]
CLASSES: tuple[RoadClass, ...] = ("A", "B", "C", "D", "E", "F", "G", "H")
REFERENCE = 0.1  # 1/m: n0, where the degree of roughness is stated
BAND = (0.011, 2.83)  # 1/m: the range that ISO 8608 recommends
_MEAN_A = 16e-6  # m^3: geometric mean of class A; each class has four times that of the class before


def class_roughness(name: str, *, where: str = "") -> float:
    """Degree of roughness G_d(n0) in m^3 of a road class: its geometric mean at n0 = 0.1 1/m.

    Parameters
    ----------
    name : str
        "A" (very good) to "H"; small letters are taken, too.
    where : str
        Place that an error names.

    Returns
    -------
    float
        16e-6 m^3 for A, four times as much for each class after it.

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
    return float(_MEAN_A * 4 ** CLASSES.index(letter))


def roughness_class(roughness: float) -> RoadClass:
    """Road class whose limits hold a degree of roughness.

    Parameters
    ----------
    roughness : float
        G_d(n0) in m^3, above 0. The limit between two classes is twice the mean of the smoother one.

    Returns
    -------
    str
        "A" to "H"; what is smoother or rougher than all of them is "A" or "H".

    Examples
    --------
    >>> roughness_class(256e-6), roughness_class(31e-6), roughness_class(33e-6)
    ('C', 'A', 'B')
    """
    if not (math.isfinite(roughness) and roughness > 0.0):
        raise DescriptionError("not a degree of roughness", found=f"{roughness} m^3", allowed="above 0 m^3")
    place = math.floor(math.log(roughness / (0.5 * _MEAN_A), 4.0))
    return CLASSES[min(max(place, 0), len(CLASSES) - 1)]


def as_roughness(road: str | float) -> float:
    """Degree of roughness in m^3 of a class by its name, or the number itself (m^3, above 0)."""
    if isinstance(road, str):
        return class_roughness(road)
    if not (math.isfinite(road) and road > 0.0):
        raise DescriptionError("not a degree of roughness", found=f"{road} m^3", allowed="above 0 m^3, or A to H")
    return float(road)


def road_psd(road: str | float, n: ArrayLike, *, waviness: float = 2.0) -> Array:
    """One-sided spectral density of the height, G_d(n) = G_d(n0) (n / n0)^-w with n0 = 0.1 1/m.

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
        G_d in m^3, the shape of ``n``; against angular frequency it is 2 pi times less.

    Raises
    ------
    DescriptionError
        For an unknown class and frequencies that are not above 0.

    Notes
    -----
    ISO 8608:2016 (key iso-8608).

    Examples
    --------
    >>> (1e6 * road_psd("A", [0.1, 0.2])).round(6).tolist()
    [16.0, 4.0]
    """
    at = np.asarray(n, dtype=float)
    if not (np.isfinite(at).all() and (at > 0.0).all()):
        raise DescriptionError("not a spatial frequency", found="0, negative, or not finite", allowed="above 0 1/m")
    return np.asarray(as_roughness(road) * (at / REFERENCE) ** -waviness)


def white_noise_intensity(road: str | float, speed: float) -> float:
    """Intensity W of the white noise that is the vertical velocity of a road with waviness 2.

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
    if not (math.isfinite(speed) and speed > 0.0):
        raise DescriptionError("not a speed", found=f"{speed} m/s", allowed="above 0 m/s")
    return 2.0 * math.pi**2 * REFERENCE**2 * as_roughness(road) * speed


def filtered_noise(road: str | float, speed: float, *, cutoff: float = BAND[0]) -> tuple[float, float]:
    """First-order filter that makes the height of a road with waviness 2 from white noise.

    Parameters
    ----------
    road : str or float
        Class "A" to "H", or a degree of roughness G_d(n0) in m^3.
    speed : float
        Speed in m/s, above 0.
    cutoff : float
        Spatial frequency in 1/m below which the spectrum is flat, so that the variance is finite.

    Returns
    -------
    pole, gain : float
        dz/dt = -pole z + gain w with w of one-sided density 1 per Hz (two-sided 1/2); pole = 2 pi cutoff v in 1/s,
        gain = 2 pi n0 sqrt(G_d(n0) v) in m/s. The variance of z is gain^2 / (4 pole).

    Examples
    --------
    >>> pole, gain = filtered_noise("C", 20.0)
    >>> round(pole, 4), round(gain, 5), round(1e3 * (gain**2 / (4 * pole)) ** 0.5, 2)  # 1/s, m/s, mm
    (1.3823, 0.04496, 19.12)
    """
    intensity = white_noise_intensity(road, speed)
    if not (math.isfinite(cutoff) and cutoff > 0.0):
        raise DescriptionError("not a spatial frequency", found=f"{cutoff} 1/m", allowed="above 0 1/m")
    return 2.0 * math.pi * cutoff * speed, math.sqrt(2.0 * intensity)


def height_variance(roughness: float, low: ArrayLike, high: ArrayLike, waviness: float = 2.0) -> Array:
    """Integral of G_d from ``low`` to ``high`` (1/m), in m^2; ``roughness`` in m^3.

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
    n: ArrayLike, track: float, *, model: str = "isotropic", decay: float = 5.7, waviness: float = 2.0
) -> Array:
    """Coherence gamma^2 between the heights under the left and the right wheels.

    Parameters
    ----------
    n : array_like
        Spatial frequencies in 1/m, at least 0.
    track : float
        Lateral distance of both tracks in m.
    model : {"isotropic", "exponential"}
        ``"isotropic"``: the surface has the same spectrum in every direction, gamma = 2 / Gamma(w/2) (y/2)^(w/2)
        K_(w/2)(y) with y = 2 pi n B (for w = 2 this is y K_1(y)); ``"exponential"``: gamma^2 = exp(-decay n B).
    decay : float
        Decay (1) of the exponential model. The default reaches one half where the isotropic model with w = 2 does.
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
    at = np.asarray(n, dtype=float)
    if model == "exponential":
        return np.asarray(np.exp(-decay * at * track))
    from scipy.special import gamma, kv

    order = 0.5 * waviness
    y = 2.0 * math.pi * np.maximum(at, 1e-9 / track) * track
    return np.asarray(np.minimum(2.0 / gamma(order) * (0.5 * y) ** order * kv(order, y), 1.0) ** 2)
