"""What a linear model is driven over: the spectrum of a road, a speed, and what left and right wheels share."""

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
_TWO = 2.0


@dataclass(frozen=True)
class Surface(Plain):
    """A random road at a speed.

    Attributes
    ----------
    roughness : float or None
        G_d(n0), m^3; None for a spectrum given as a function.
    density : callable or None
        One-sided density of the height (m^3) of spatial frequency (1/m), where there is no roughness.
    speed : float
        m/s.
    waviness : float
        Exponent w (1).
    band : tuple of float or None
        Spatial frequencies that are there, 1/m; None for all of them (white noise).
    cut_off : float or None
        Spatial frequency n00 (1/m) below which the road is flat: ``dz/dt = -2 pi n00 v z + w``.
    sides : str
        What left and right wheels share.
    contact_length : float
        Of the tyre, m: shorter waves are averaged out.
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
        """Density (m^3) of the height that the tyre feels, at spatial frequencies (1/m)."""
        if self.density is not None:
            found = np.asarray(self.density(n), dtype=float)
            if found.shape != n.shape or not np.all(np.isfinite(found)) or np.any(found < 0.0):
                raise DescriptionError(
                    "the spectrum does not give densities", where="road", allowed="finite and at least 0 m^3"
                )
        elif self.cut_off is not None:
            found = float(self.roughness or 0.0) * REFERENCE**2 / (n**2 + self.cut_off**2)
        else:
            found = float(self.roughness or 0.0) * (n / REFERENCE) ** -self.waviness
        return np.asarray(found * np.sinc(n * self.contact_length) ** 2)

    def shared(self, n: Array, track: float | Array) -> Array | None:
        """Root of the coherence (1) of left and right heights at distances (m); None where they are independent."""
        if self.sides not in ("isotropic", "exponential"):
            return None
        found = track_coherence(n, track, model=self.sides, waviness=self.waviness)
        return np.asarray(np.sqrt(found))


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
    """Read a road, SI: a class ("C", "iso:C"), a roughness (m^3, or text with its unit) or a density as a function.

    ``band`` in 1/m ("iso" is that of ISO 8608); by default all waves, for a density that of ISO 8608.

    Raises
    ------
    DescriptionError
        For values out of range and choices that do not fit each other.
    """
    velocity = to_si(speed, "m/s", where="speed")
    if velocity <= 0.0:
        raise DescriptionError("out of range", where="speed", found=speed, allowed="above 0 m/s")
    length = to_si(contact_length, "m", where="contact_length")
    if length < 0.0:
        raise DescriptionError("out of range", where="contact_length", found=contact_length, allowed="at least 0 m")
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
    found = Surface(roughness, density, velocity, slope, limits, cut, chosen, length)
    _check(found)
    return found


def read_roughness(road: str | float) -> float:
    """Degree of roughness (m^3) of a class ("C", "iso:C"), a text with its unit, or a number in m^3."""
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
            "not a band of spatial frequencies", where="band", found=str(band), allowed='"iso" or (low, high) in 1/m'
        )
    return low, high


def _check(found: Surface) -> None:
    if not (math.isfinite(found.waviness) and 0.0 < found.waviness < 4.0):
        raise DescriptionError("out of range", where="waviness", found=found.waviness, allowed="above 0, below 4")
    if found.cut_off is not None and not (math.isfinite(found.cut_off) and found.cut_off > 0.0):
        raise DescriptionError("out of range", where="cut_off", found=found.cut_off, allowed="above 0 1/m")
    if found.cut_off is not None and (found.waviness != _TWO or found.density is not None):
        raise DescriptionError("a cut-off belongs to a road of waviness 2", where="cut_off", found=found.cut_off)
    if found.band is not None:
        return
    hint = 'Give band="iso" (0.011 to 2.83 1/m).'
    for name, value, is_fit in (
        ("waviness", found.waviness, found.waviness == _TWO),
        ("contact_length", found.contact_length, found.contact_length == 0.0),
        ("sides", found.sides, found.sides in ("uncorrelated", "same")),
    ):
        if not is_fit:
            raise DescriptionError("this needs a band of frequencies", where=name, found=value, hint=hint)
