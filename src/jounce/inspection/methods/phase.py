"""EGEA phase angle of every turn, and its least value in the band."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from jounce.core.constants import NORMAL_95
from jounce.core.types import Array
from jounce.inspection.signals.analysis import Analysis
from jounce.inspection.signals.response import force_response
from jounce.inspection.signals.smoothing import corrected_course
from jounce.testers.plates import phase_angle

_LENGTH = 2.0
_END, _BESIDE = 0.05, 2.0  # Hz


@dataclass(frozen=True)
class PhaseMinimum:
    """Least phase angle.

    Attributes
    ----------
    angle_deg, frequency_hz : float
        In degrees, and where (Hz).
    half_width_deg : float or None
        Of its 95 % interval, degrees.
    at_end : bool
        Whether it lies at an end of the band.
    in_lift_off : bool
        Whether the tyre leaves the plate there, so that the angle is that of the fitted quarter car.
    """

    angle_deg: float
    frequency_hz: float
    half_width_deg: float | None
    at_end: bool
    in_lift_off: bool = False


def phase_angles(analysis: Analysis, rows: Array) -> Array:
    """Phase angle (degrees) of each turn from what the force does in it (n, 7).

    ``360 f (t_ref - t_top)``: t_ref lies midway between the time at which the force falls below the static load and the
    one at which it rises above it again, around its least value; f is one over the time from this top to the next. The
    fall is before the top where the angle is below 90 degrees.
    """
    reference = 0.5 * (rows[:, 3] + rows[:, 4])
    return np.asarray(360.0 * analysis.turn_frequency * (reference - analysis.top))


def find_phase_minimum(analysis: Analysis, band: tuple[float, float]) -> tuple[PhaseMinimum | None, Array]:
    """Find the least phase angle within a band.

    Parameters
    ----------
    analysis : Analysis
        Turns of the test.
    band : (float, float)
        Hz, ends included.

    Returns
    -------
    minimum : PhaseMinimum or None
        None where the turns do not reach over the band.
    angles : ndarray, shape (n,)
        Of the turns, degrees, as measured.
    """
    measured = phase_angles(analysis, analysis.measured)
    frequency = analysis.turn_frequency
    if analysis.fit is None:
        modelled = np.full(measured.size, float(np.nanmedian(measured)) if np.isfinite(measured).any() else 0.0)
        spread = 1.0 / np.maximum(analysis.measured[:, 6], 1.0)
    else:
        modelled = phase_angles(analysis, analysis.modelled)
        swing = np.where(np.isfinite(analysis.modelled[:, 6]), analysis.modelled[:, 6], analysis.measured[:, 6])
        spread = 1.0 / np.maximum(swing, 1.0)
    inside = (frequency > band[0] - _BESIDE) & (frequency < band[1] + _BESIDE)
    steady = inside & ~analysis.lifted
    course = corrected_course(frequency[steady], measured[steady], modelled[steady], spread[steady], _LENGTH)
    hops = frequency[inside & analysis.lifted]
    if hops.size and analysis.fit is not None:
        course = course.with_turns(hops, np.degrees(phase_angle(force_response(analysis.fit.corner, hops))))
    found = course.least(*band)
    if found is None:
        return None, measured
    at, angle, error = found
    fit = analysis.fit
    if fit is not None:
        error = math.hypot(error, math.degrees(fit.spread_at(at, phase_angle)))
    half = NORMAL_95 * error if math.isfinite(error) else None
    hopping = bool(hops.size) and float(np.min(np.abs(hops - at))) < _END
    return PhaseMinimum(angle, at, half, min(at - band[0], band[1] - at) < _END, hopping), measured
