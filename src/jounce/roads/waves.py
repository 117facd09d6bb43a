"""Waves: a sine, and sine sweeps over wavelength along a road or over frequency in time."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Literal

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.segments import SINE
from jounce.core.types import Array
from jounce.core.units import Angle, Height, PositiveLength, positive_si, to_si
from jounce.roads.profile import Profile, hermite_profile
from jounce.roads.road import Road
from jounce.roads.trial import Excitation

Law = Literal["linear", "logarithmic"]
PER_WAVE = 64  # points per wave: cubics between them have an error of 3e-7 of the amplitude
MOST_WAVES = 20_000  # 1.3 million points


class Sine(Road):
    """Sine waves ``a sin(2 pi x / wavelength + phase)``; the road continues at the last height.

    Attributes
    ----------
    amplitude, wavelength : float
        Half the trough-to-crest height, and the crest-to-crest distance, in m.
    length : float
        Length of the waves in m.
    phase : float
        Phase in rad at the start of the waves; the road before them has the height at that point.

    Examples
    --------
    >>> waves = Sine(amplitude="10 mm", wavelength="2 m", length="20 m", start="5 m")
    >>> waves.height_at([5.0, 5.5, 30.0]).round(12).tolist()
    [0.0, 0.01, -0.0]
    """

    kind: Literal["sine"] = "sine"
    amplitude: Height
    wavelength: PositiveLength
    length: PositiveLength
    phase: Angle = 0.0

    def profile(self) -> Profile:
        """Return one sine piece."""
        rate = 2.0 * math.pi / self.wavelength
        height = [self.amplitude * math.sin(self.phase + rate * x) for x in (0.0, self.length)]
        return Profile(
            edges=np.array([0.0, self.length]),
            kind=np.array([SINE], dtype=np.int64),
            coefficients=np.array([[0.0, self.amplitude, rate, self.phase]]),
            before=height[0],
            after=height[1],
        )


class SineSweep(Road):
    """Sine sweep with constant amplitude whose wavelength 1/n changes along the road.

    The spatial frequency n = 1 / wavelength goes from the first to the last one linearly or logarithmically (equal
    ratios over equal distances); the height is ``a sin(2 pi integral of n dx)``.

    Attributes
    ----------
    amplitude : float
        Half the trough-to-crest height, in m.
    first_wavelength, last_wavelength : float
        Wavelengths in m at the beginning and at the end.
    length : float
        Length of the sweep in m.
    law : {"logarithmic", "linear"}
        Change of the spatial frequency with distance.

    Examples
    --------
    >>> sweep = SineSweep(amplitude="5 mm", first_wavelength="10 m", last_wavelength="0.5 m", length="100 m")
    >>> sweep.end(), float(sweep.height_at(0.0)), round(1e3 * float(sweep.height_at(np.linspace(0, 9, 9001)).max()), 4)
    (100.0, 0.0, 5.0)
    """

    kind: Literal["sine-sweep"] = "sine-sweep"
    amplitude: Height
    first_wavelength: PositiveLength
    last_wavelength: PositiveLength
    length: PositiveLength
    law: Law = "logarithmic"

    def check(self) -> None:
        """Reject sweeps with too many waves."""
        waves = _cycles(
            1.0 / self.first_wavelength, 1.0 / self.last_wavelength, self.length, self.law
        )
        if waves > MOST_WAVES:
            most = Phrase("up to {most}; make the sweep shorter", most=MOST_WAVES)
            raise error_at((), Phrase("{waves:.0f} waves", waves=waves), allowed=most)

    def profile(self) -> Profile:
        """Return cubics with exact slopes, 64 per wave."""
        return _sweep_profile(
            self.amplitude,
            1.0 / self.first_wavelength,
            1.0 / self.last_wavelength,
            self.length,
            self.law,
        )


def swept_sine(
    amplitude: str | float,
    first_frequency: str | float,
    last_frequency: str | float,
    duration: str | float,
    *,
    law: Law = "logarithmic",
) -> Excitation:
    """Create a sine sweep of the support over time, as produced by a shaker.

    Parameters
    ----------
    amplitude : str or float
        Half the stroke, in m or with a unit.
    first_frequency, last_frequency : str or float
        Frequencies at the beginning and at the end, above 0 Hz, in Hz or with a unit; either may be the higher one.
    duration : str or float
        Length of the sweep, above 0 s, in s or with a unit.
    law : {"logarithmic", "linear"}
        Change of the frequency with time.

    Returns
    -------
    Excitation
        Height in m over time in s, a cubic spline with 64 samples per wave.

    Raises
    ------
    DescriptionError
        For invalid units, frequencies or durations that are not positive, and more than 20 000 waves.

    Examples
    --------
    >>> sweep = swept_sine("2 mm", "1 Hz", "25 Hz", "10 s")
    >>> sweep.end(), round(max(sweep.height), 5)
    (10.0, 0.002)
    """
    a = to_si(amplitude, "m", where="amplitude")
    named = (("first_frequency", first_frequency, "Hz"), ("last_frequency", last_frequency, "Hz"))
    first, last, length = (
        positive_si(value, si, where=name)
        for name, value, si in (*named, ("duration", duration, "s"))
    )
    if law not in ("linear", "logarithmic"):
        raise DescriptionError("unknown law", where="law", found=law, allowed="linear, logarithmic")
    waves = _cycles(first, last, length, law)
    if waves > MOST_WAVES:
        raise DescriptionError(
            "too many waves",
            where="duration",
            found=f"{waves:.0f}",
            allowed=Phrase("up to {most_waves}", most_waves=MOST_WAVES),
        )
    time, phase, _ = _swept(first, last, length, law)
    return Excitation(time=time, height=a * np.sin(phase))


def _cycles(first: float, last: float, length: float, law: str) -> float:
    """Return the number of waves in a sweep from ``first`` to ``last`` (1/m or Hz) over ``length`` (m or s)."""
    if law == "linear" or math.isclose(first, last, rel_tol=1e-9):
        return 0.5 * (first + last) * length
    return length * (last - first) / math.log(last / first)


def _swept(first: float, last: float, length: float, law: str) -> tuple[Array, Array, Array]:
    """Return coordinate (m or s), phase (rad) and frequency (1/m or Hz) at points evenly spaced in phase."""
    total = _cycles(first, last, length, law)
    count = max(8, math.ceil(PER_WAVE * total))
    cycles = total * np.arange(count + 1) / count
    change = (last - first) / length
    if math.isclose(first, last, rel_tol=1e-9):
        x = cycles / first
        frequency = np.full_like(x, first)
    elif law == "linear":
        frequency = np.sqrt(np.maximum(first**2 + 2.0 * change * cycles, 0.0))
        x = 2.0 * cycles / (first + frequency)
    else:
        rate = math.log(last / first) / length
        frequency = first + rate * cycles
        x = np.log(frequency / first) / rate
    x[0], x[-1] = 0.0, length
    return x, 2.0 * math.pi * cycles, frequency


@lru_cache(maxsize=8)
def _sweep_profile(amplitude: float, first: float, last: float, length: float, law: str) -> Profile:
    x, phase, n = _swept(first, last, length, law)
    return hermite_profile(
        x, amplitude * np.sin(phase), amplitude * 2.0 * math.pi * n * np.cos(phase)
    )
