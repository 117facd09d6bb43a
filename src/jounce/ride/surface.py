"""Random road for linear models: spectrum, speed, and coherence of left and right."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from jounce.core.errors import DescriptionError, unknown
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import as_number, to_si
from jounce.roads.rough import BAND, REFERENCE, as_roughness, track_coherence

Density = Callable[[Array], Array]
Sides = Literal["uncorrelated", "same", "isotropic", "exponential"]
SIDES: tuple[Sides, ...] = ("uncorrelated", "same", "isotropic", "exponential")
_TWO = 2.0  # waviness of ISO 8608


@dataclass(frozen=True)
class Surface(Plain):
    """A random road at a speed.

    Attributes
    ----------
    roughness : float or None
        Degree of roughness G_d(n0), m^3; None for a spectrum given as a function.
    density : callable or None
        One-sided density of the height (m^3) as a function of spatial frequency (1/m), in place of a roughness.
    speed : float
        m/s.
    waviness : float
        Exponent w (1).
    band : tuple of float or None
        Spatial frequencies of the road, 1/m; None for all of them (white noise).
    cut_off : float or None
        Spatial frequency n00 (1/m) below which the road is flat: ``dz/dt = -2 pi n00 v z + w``.
    sides : str
        Relation of left and right wheels.
    contact_length : float
        Contact length of the tyre, m; shorter waves are averaged out.
    """

    left_out = ("density",)

    roughness: float | None
    density: Density | None
    speed: float
    waviness: float = _TWO
    band: tuple[float, float] | None = None
    cut_off: float | None = None
    sides: Sides = "uncorrelated"
    contact_length: float = 0.0

    @property
    def intensity(self) -> float:
        """Intensity W of the road's vertical velocity, m^2/s."""
        assert self.roughness is not None
        return 2.0 * math.pi**2 * REFERENCE**2 * self.roughness * self.speed

    @property
    def corner_rate(self) -> float | None:
        """Rate of the low-frequency cut-off, 1/s."""
        return None if self.cut_off is None else 2.0 * math.pi * self.cut_off * self.speed

    def heights(self, n: Array) -> Array:
        """Return the density (m^3) of the height averaged by the tyre, at spatial frequencies (1/m)."""
        if self.density is not None:
            density = np.asarray(self.density(n), dtype=float)
            if (
                density.shape != n.shape
                or not np.all(np.isfinite(density))
                or np.any(density < 0.0)
            ):
                raise DescriptionError(
                    "the spectrum does not give densities",
                    where="road",
                    allowed="finite and at least 0 m^3",
                )
        elif self.cut_off is not None:
            density = float(self.roughness or 0.0) * REFERENCE**2 / (n**2 + self.cut_off**2)
        else:
            density = float(self.roughness or 0.0) * (n / REFERENCE) ** -self.waviness
        return np.asarray(density * np.sinc(n * self.contact_length) ** 2)

    def root_coherence(self, n: Array, track: float | Array) -> Array | None:
        """Return the root coherence (1) of left and right heights at distances (m); None for independent sides."""
        if self.sides not in ("isotropic", "exponential"):
            return None
        coherence = track_coherence(n, track, model=self.sides, waviness=self.waviness)
        return np.asarray(np.sqrt(coherence))


def surface(
    road: str | float | Density,
    speed: float | str,
    *,
    waviness: float = _TWO,
    band: tuple[float, float] | Literal["iso"] | None = None,
    cut_off: float | None = None,
    sides: Sides | None = None,
    contact_length: float | str = 0.0,
) -> Surface:
    """Read a road, SI: a class ("C", "iso:C"), a roughness (m^3 or text with a unit) or a density function.

    ``band`` is in 1/m ("iso" is that of ISO 8608). By default all waves are included; for a density function, those of
    the ISO 8608 band.

    Raises
    ------
    DescriptionError
        If a value is out of range or options are inconsistent.
    """
    velocity = to_si(speed, "m/s", where="speed")
    if velocity <= 0.0:
        raise DescriptionError("out of range", where="speed", found=speed, allowed="above 0 m/s")
    length = to_si(contact_length, "m", where="contact_length")
    if length < 0.0:
        raise DescriptionError(
            "out of range", where="contact_length", found=contact_length, allowed="at least 0 m"
        )
    density = road if callable(road) else None
    roughness = None if callable(road) else read_roughness(road)
    limits = _band(band)
    if limits is None and density is not None:
        limits = BAND
    chosen: Sides = sides or ("uncorrelated" if limits is None else "isotropic")
    if chosen not in SIDES:
        raise unknown(str(chosen), SIDES, what="relation of left and right", where="sides")
    slope = as_number(waviness, "1", where="waviness")
    cut = None if cut_off is None else as_number(cut_off, "1/m", where="cut_off")
    road_surface = Surface(roughness, density, velocity, slope, limits, cut, chosen, length)
    _check(road_surface)
    return road_surface


def read_roughness(road: str | float) -> float:
    """Return the degree of roughness (m^3) of a class ("C", "iso:C"), a text with a unit, or a number in m^3."""
    if not isinstance(road, str):
        return as_roughness(road, where="road")
    text = road.strip()
    if text.lower().startswith("iso:"):
        text = text[4:]
    if any(mark.isdigit() for mark in text):
        return as_roughness(to_si(text, "m^3", where="road"), where="road")
    return as_roughness(text, where="road")


def _band(band: tuple[float, float] | Literal["iso"] | None) -> tuple[float, float] | None:
    if band is None or band == "iso":
        return None if band is None else BAND
    try:
        low, high = (as_number(value, "1/m", where="band") for value in band)
    except (TypeError, ValueError, DescriptionError):
        low, high = math.nan, math.nan
    if not (0.0 < low < high < math.inf):
        raise DescriptionError(
            "invalid band of spatial frequencies",
            where="band",
            found=str(band),
            allowed='"iso" or (low, high) in 1/m',
        )
    return low, high


def _check(surface: Surface) -> None:
    # Chosen limits; ISO 8608 uses 2.
    if not (math.isfinite(surface.waviness) and 0.0 < surface.waviness < 4.0):
        raise DescriptionError(
            "out of range", where="waviness", found=surface.waviness, allowed="above 0 and below 4"
        )
    if surface.cut_off is not None and not (
        math.isfinite(surface.cut_off) and surface.cut_off > 0.0
    ):
        raise DescriptionError(
            "out of range", where="cut_off", found=surface.cut_off, allowed="above 0 1/m"
        )
    if surface.cut_off is not None and (surface.waviness != _TWO or surface.density is not None):
        raise DescriptionError(
            "a cut-off applies only to a road of waviness 2", where="cut_off", found=surface.cut_off
        )
    if surface.band is not None:
        return
    hint = 'Give band="iso" (0.011 to 2.83 1/m).'
    for name, value, is_fit in (
        ("waviness", surface.waviness, surface.waviness == _TWO),
        ("contact_length", surface.contact_length, surface.contact_length == 0.0),
        ("sides", surface.sides, surface.sides in ("uncorrelated", "same")),
    ):
        if not is_fit:
            raise DescriptionError(
                "this requires a frequency band", where=name, found=value, hint=hint
            )
