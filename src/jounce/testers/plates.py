"""Steady motion of a wheel on a tester's plate from its linear response: adhesion, phase angle, tyre rigidity."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.shown import Shown
from jounce.core.types import Array, Complex

_COARSE, _FINE = (
    0.1,
    0.01,
)  # Hz: steps of the coarse search for a minimum and of the refinement
RIGIDITY = 0.571, 46e3
"""EGEA: rigidity = 0.571 H25 / e_p + 46 N/mm."""
RIGIDITY_FREQUENCY = 25.0
"""Frequency of H25, Hz."""


@dataclass(frozen=True)
class SteadyResponse(Shown):
    """Steady response of one wheel on a tester for small motions.

    Attributes
    ----------
    frequency : ndarray, shape (n,)
        Hz.
    force_response : ndarray of complex, shape (n,)
        Contact force per plate displacement, N/m.
    plate_response : ndarray of complex, shape (n,)
        Plate displacement per exciter displacement (1); 1 for a rigid plate.
    static_load : float
        Static wheel load, N.
    amplitude : float
        Amplitude of the exciter, m.
    """

    frequency: Array
    force_response: Complex
    plate_response: Complex
    static_load: float
    amplitude: float

    @property
    def force_amplitude(self) -> Array:
        """Amplitude of the contact force, N, shape (n,); invalid above the static load, where the wheel lifts off."""
        return np.asarray(self.amplitude * np.abs(self.force_response * self.plate_response))

    @property
    def adhesion(self) -> Array:
        """Minimum over static contact force (1), shape (n,); 0 where the wheel would lift off."""
        return np.maximum(1.0 - self.force_amplitude / self.static_load, 0.0)

    @property
    def phase_angle(self) -> Array:
        """EGEA phase angle, rad between -pi/2 and 3/2 pi, shape (n,): pi minus the argument of the response."""
        return phase_angle(self.force_response)


def wrap_phase(angle: ArrayLike) -> Array:
    """Wrap angles (rad) to -pi/2 to 3/2 pi, the range of testers' phase angles."""
    return np.asarray(1.5 * np.pi - np.mod(1.5 * np.pi - np.asarray(angle), 2.0 * np.pi))


def phase_angle(response: ArrayLike) -> Array:
    """Compute the EGEA phase angle (rad) of contact-force responses to plate height (N/m): pi minus their argument."""
    return wrap_phase(np.pi - np.angle(np.asarray(response, dtype=complex)))


def least_adhesion(at: Callable[[Array], SteadyResponse], highest: float) -> tuple[float, float]:
    """Return the minimum adhesion (1; may be negative) up to a frequency (Hz), and its frequency to 0.01 Hz."""

    def value(frequency: Array) -> Array:
        result = at(frequency)
        return 1.0 - result.force_amplitude / result.static_load

    return least(value, _COARSE, highest)


def least(value: Callable[[Array], Array], low: float, high: float) -> tuple[float, float]:
    """Return the minimum of a function of frequency (Hz) on [low, high], and its frequency to 0.01 Hz."""
    coarse = np.linspace(low, high, int(np.ceil((high - low) / _COARSE)) + 1)
    about = float(coarse[np.argmin(value(coarse))])
    steps = np.arange(-_COARSE, _COARSE + 0.5 * _FINE, _FINE)
    fine = np.unique(np.clip(np.round((about + steps) / _FINE) * _FINE, low, high))
    values = value(fine)
    best = int(np.argmin(values))
    return float(values[best]), round(float(fine[best]), 9)


def tyre_rigidity(force_amplitude: float, amplitude: float) -> float:
    """Compute the EGEA tyre rigidity (N/m) from the force amplitude at 25 Hz (N) and the plate's amplitude (m).

    Examples
    --------
    >>> round(tyre_rigidity(3 * 248.0, 0.003) / 1e3, 1)   # N/mm, of a tyre of 200 N/mm
    187.6
    """
    slope, offset = RIGIDITY
    return slope * force_amplitude / amplitude + offset
