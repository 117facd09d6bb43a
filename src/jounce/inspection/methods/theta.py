"""THETA: damping ratio of the wheel on a sprung plate and on the road, by four methods; the fit is the one to grade."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.constants import NORMAL_95
from jounce.core.types import Array
from jounce.inspection.signals.response import Corner, force_response, rig_poles, road_poles, wheel_damping
from jounce.inspection.signals.response_fit import ResponseFit

if TYPE_CHECKING:
    from jounce.parts.testers import Tester

_LOWEST, _HIGHEST, _POINTS = 1.5, 15.0, 541
_FEWEST_EXTREMES = 4
_EVEN = 0.2


@dataclass(frozen=True)
class Theta:
    """Damping ratios (1) on the rig and on the road, each with the half width of its 95 % interval (1)."""

    rig: float
    road: float
    rig_half_width: float
    road_half_width: float


def theta_by_fit(fit: ResponseFit, tester: Tester | None) -> Theta:
    """Damping ratios of the wheel from a fitted quarter car.

    Parameters
    ----------
    fit : ResponseFit
        Quarter car of the record.
    tester : Tester or None
        Its plate and plate spring stand under the wheel on the rig; on a rigid plate rig and road are the same.

    Returns
    -------
    Theta
        From the poles of the three-mass model (rig), and of the quarter car on a plate at rest (road).
    """

    def on_road(corner: Corner) -> float:
        return wheel_damping(road_poles(corner))[0]

    def on_rig(corner: Corner) -> float:
        if tester is None or tester.plate_spring_rate is None:
            return on_road(corner)
        damping = tester.plate_damping_coefficient or 0.0
        return wheel_damping(rig_poles(corner, tester.plate_mass, tester.plate_spring_rate, damping))[0]

    road, half = on_road(fit.corner), NORMAL_95 * fit.spread(on_road)
    if tester is None or tester.plate_spring_rate is None:
        return Theta(road, road, half, half)
    return Theta(on_rig(fit.corner), road, NORMAL_95 * fit.spread(on_rig), half)


def half_power(frequency: Array, amplitude: Array) -> float | None:
    """Damping ratio (1) from the width of a resonance at 0.707 of its height.

    Parameters
    ----------
    frequency, amplitude : ndarray, shape (n,)
        Hz in any order, and amplitudes in any unit.

    Returns
    -------
    float or None
        (f2 - f1) / (2 f_r) (1); None where one of the two points does not exist, as above some 0.2 of damping.
    """
    order = np.argsort(frequency)
    f, a = frequency[order], amplitude[order]
    top = int(np.argmax(a))
    level = a[top] / math.sqrt(2.0)
    below, above = np.flatnonzero(a[:top] < level), np.flatnonzero(a[top:] < level)
    if below.size == 0 or above.size == 0:
        return None
    i, j = int(below[-1]), top + int(above[0])
    low = np.interp(level, a[i : i + 2], f[i : i + 2])
    high = f[j - 1] + (a[j - 1] - level) / (a[j - 1] - a[j]) * (f[j] - f[j - 1])
    return float((high - low) / (2.0 * f[top]))


def plate_gain(corner: Corner, tester: Tester, frequency: Array) -> Array:
    """Height of a sprung plate over that of the exciter (1), frequencies (n,) in Hz."""
    s = 2j * np.pi * np.asarray(frequency, dtype=float)
    spring = float(tester.plate_spring_rate or 0.0) + float(tester.plate_damping_coefficient or 0.0) * s
    return np.asarray(abs(spring / (tester.plate_mass * s * s + spring + force_response(corner, frequency))))


def theta_by_amplification(gain: float, corner: Corner, tester: Tester) -> float | None:
    """Damping ratio (1) of the rig whose plate is moved ``gain`` times (1) as much as the exciter at resonance.

    Of the corner everything but the damper counts. None where no damper gives this amplification.
    """
    from dataclasses import replace

    from scipy.optimize import brentq

    frequency = np.linspace(_LOWEST, _HIGHEST, _POINTS)

    def miss(logarithm: float) -> float:
        trial = replace(corner, damping_coefficient=math.exp(logarithm))
        return math.log(float(plate_gain(trial, tester, frequency).max()) / gain)

    critical = 2.0 * math.sqrt((corner.spring_rate + corner.tyre_stiffness) * corner.unsprung_mass)
    low, high = math.log(0.01 * critical), math.log(0.6 * critical)
    if not (gain > 0.0 and miss(low) > 0.0 > miss(high)):
        return None
    found = replace(corner, damping_coefficient=math.exp(brentq(miss, low, high, xtol=1e-6)))
    damping = tester.plate_damping_coefficient or 0.0
    return wheel_damping(rig_poles(found, tester.plate_mass, float(tester.plate_spring_rate or 0.0), damping))[0]


def theta_by_decay(height: Array, sample_rate: float) -> tuple[float, float] | None:
    """Damping ratio (1) and frequency (Hz) of the free decay at the end of a record, after the exciter has stopped.

    Turning points of the height (n,) in m are followed backwards from the end as long as they come evenly and grow
    (rate in Hz). None where fewer than four do.
    """
    size = max(round(0.005 * sample_rate), 1)
    smooth = np.convolve(height, np.full(size, 1.0 / size), mode="valid")
    rest = float(np.mean(smooth[-max(round(0.3 * sample_rate), 3) :]))
    away = smooth - rest
    slope = np.diff(away)
    turns = np.flatnonzero((slope[:-1] > 0.0) != (slope[1:] > 0.0)) + 1
    if turns.size < _FEWEST_EXTREMES:
        return None
    floor = max(5e-3 * float(np.max(np.abs(away))), 4.0 * float(np.std(away[-max(round(0.1 * sample_rate), 3) :])))
    turns = turns[np.abs(away[turns]) > floor]
    kept = _even_turns(turns, away)
    if kept.size < _FEWEST_EXTREMES:
        return None
    slope_of_log = float(np.polyfit(np.arange(kept.size), np.log(np.abs(away[kept])), 1)[0])
    ratio = -slope_of_log / math.hypot(math.pi, slope_of_log)
    half_turn = float(kept[-1] - kept[0]) / (kept.size - 1) / sample_rate
    return (ratio, 0.5 / half_turn) if ratio > 0.0 else None


def _even_turns(turns: NDArray[np.intp], away: Array) -> NDArray[np.intp]:
    """Turning points of the decay: from the last one back, on alternating sides, growing, at even distances."""
    kept = [int(turns[-1])] if turns.size else []
    for at in turns[-2::-1]:
        now, then = away[kept[-1]], away[at]
        if now * then > 0.0 or abs(then) <= abs(now):
            break
        if len(kept) > 1 and abs((kept[-1] - at) / (kept[-2] - kept[-1]) - 1.0) > _EVEN:
            break
        if len(kept) > 1 and abs(math.log(-then / now) / math.log(-now / away[kept[-2]]) - 1.0) > 3.0 * _EVEN:
            break
        kept.append(int(at))
    return np.array(kept[::-1], dtype=np.intp)
