"""EUSAMA adhesion and EGEA relative force amplitude from the turns of a run-down."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from jounce.core.constants import NORMAL_95
from jounce.inspection.signals.analysis import UNDERFLOW, Analysis
from jounce.inspection.signals.smoothing import corrected_course

_LENGTH = 1.2
_NEAR = 4.0  # Hz


@dataclass(frozen=True)
class Adhesion:
    """Least and greatest force of a test.

    Attributes
    ----------
    adhesion : float
        Least over static force (1); 0 with lift-off.
    frequency_hz : float
        Where the force is least, Hz.
    lift_off : bool
        Whether the tyre left the plate.
    relative_force_amplitude : float
        Static less least force over static force (1); with lift-off greatest less static.
    half_width : float or None
        Of the 95 % intervals of both (1); None where it is not known.
    """

    adhesion: float
    frequency_hz: float
    lift_off: bool
    relative_force_amplitude: float
    half_width: float | None


def find_adhesion(analysis: Analysis, highest: float) -> Adhesion | None:
    """Find the adhesion of a run-down up to the ``highest`` frequency in Hz; None where no turn could be evaluated."""
    least, load = analysis.measured[:, 0], analysis.load
    known = np.isfinite(least)
    if np.count_nonzero(known) < 4:
        return None
    greatest = float(np.nanmax(analysis.measured[:, 2]))
    lowest = int(np.nanargmin(least))
    if analysis.lifted[known].any():
        at = float(analysis.frequency[lowest])
        return Adhesion(0.0, at, True, (greatest - load) / load, None)
    modelled = analysis.modelled[:, 0] if analysis.fit is not None else np.full(least.size, load)
    near = np.abs(analysis.frequency - analysis.frequency[lowest]) < _NEAR
    if analysis.fit is not None and np.isfinite(modelled).any():
        near |= np.abs(analysis.frequency - analysis.frequency[int(np.nanargmin(modelled))]) < _NEAR
    course = corrected_course(
        analysis.frequency[near], least[near], modelled[near], np.ones(int(np.count_nonzero(near))), _LENGTH
    )
    at, force, error = course.lowest() if course.value.size else (analysis.frequency[lowest], least[lowest], math.nan)
    fit = analysis.fit
    if fit is not None:
        spread = fit.spread_at(at, np.abs)
        error = math.hypot(error, spread * analysis.amplitude)
    half = NORMAL_95 * error / load if math.isfinite(error) else None
    share = force / load
    lifted = share <= 0.0
    amplitude = (greatest - load) / load if share < UNDERFLOW else 1.0 - share
    return Adhesion(max(share, 0.0), min(float(at), highest), lifted, amplitude, half)
