"""Turning points of a measured decay, and what two regressions through them say."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from jounce.core.errors import FitError
from jounce.core.types import Array
from jounce.identify.decay_response import alternating


@dataclass(frozen=True)
class Peaks:
    """Successive turning points of a signal.

    Attributes
    ----------
    time : array (n,)
        When they occur [s], the first being the largest excursion.
    value : array (n,)
        Signal there, maxima and minima alternating, unit of the signal.
    """

    time: Array
    value: Array

    def half_period(self) -> float:
        """Give the time from one turning point to the next [s]; the release is not one of them."""
        gaps = np.diff(self.time)[1:]
        return float(np.average(gaps, weights=np.abs(np.diff(self.value))[1:]))


def noise_of(signal: Array) -> float:
    """Give the standard deviation of the white noise in a smooth signal, unit of the signal.

    Third differences remove the motion; their median absolute value is not disturbed by single jumps.

    Examples
    --------
    >>> noise_of(np.sin(np.linspace(0.0, 6.0, 2000))) < 1e-6
    True
    """
    return float(np.median(np.abs(np.diff(signal, 3))) / (0.6745 * math.sqrt(20.0)))


def find_release(signal: Array, noise: float) -> int:
    """Give the index at which the largest excursion is left: the end of a hold, or just past the first peak.

    Parameters
    ----------
    signal : array (n,)
        The record, any unit.
    noise : float
        Standard deviation of its noise, same unit.

    Returns
    -------
    int
        Index of the last sample within 2 % of the largest excursion from the final value (more when the noise is
        larger) before the signal falls below 70 % of it.
    """
    tail = float(np.median(signal[-max(5, len(signal) // 10) :]))
    away = np.abs(_smooth(signal, noise) - tail)
    top = int(np.argmax(away))
    fallen = np.flatnonzero(away[top:] < 0.7 * away[top])
    end = top + (int(fallen[0]) if len(fallen) else len(signal) - top)
    limit = float(away[top]) - max(0.02 * float(away[top]), 3.0 * noise)
    return int(top + np.flatnonzero(away[top:end] >= limit)[-1])


def _smooth(signal: Array, noise: float) -> Array:
    """Average over a few samples when the noise exceeds 1 % of the range."""
    share = noise / max(float(np.ptp(signal)), 1e-300)
    width = int(np.clip(1 + 2 * round(100.0 * share), 1, max(1, len(signal) // 50)))
    return _averaged(signal, width)


def _averaged(signal: Array, width: int) -> Array:
    """Moving average over an odd number of samples."""
    if width < 3:
        return signal
    padded = np.pad(signal, width // 2, mode="edge")
    return np.convolve(padded, np.ones(width) / width, mode="same")[width // 2 : width // 2 + len(signal)]


def find_peaks(time: Array, signal: Array, noise: float) -> Peaks:
    """Find the turning points of a decaying oscillation, both polarities, refined between samples by a parabola.

    Parameters
    ----------
    time : array (n,)
        Times from the release on [s].
    signal : array (n,)
        The record from the release on, any unit.
    noise : float
        Standard deviation of its noise, same unit. Reversals within the noise are not counted.

    Returns
    -------
    Peaks
        The release (first sample) and every following turning point.

    Raises
    ------
    FitError
        When the signal does not turn after the release: no oscillation to work on.
    """
    reach = float(np.ptp(signal))
    coarse = zigzag(_smooth(signal, noise), max(12.0 * noise, 0.03 * reach))
    half = _half_period(time, coarse)
    width = max(1, round(half / 12.0 / float(np.median(np.diff(time)))))
    smooth = _averaged(signal, width | 1)
    turns = zigzag(smooth, max(8.0 * noise / math.sqrt(width), 2e-4 * reach))
    turns = [0, *(turn for turn in turns[1:] if turn >= coarse[1] - width)]
    refined = [(float(time[turns[0]]), float(smooth[turns[0]]))]
    refined += [_parabola(time, signal, smooth, index, half) for index in turns[1:]]
    if len(refined) == 2:  # the mass rests after its first swing back
        refined.append((refined[1][0] + half, float(np.median(signal[-max(5, len(signal) // 4) :]))))
    moments, values = np.array(refined).T
    return Peaks(moments, values)


def _half_period(time: Array, turns: list[int]) -> float:
    """Half period [s] from coarse turning points; a refusal when there is no swing."""
    if len(turns) < 2:
        raise FitError(
            "no oscillation to work on",
            found="no turning point after the release",
            allowed="at least 1",
            hint="Damping near critical, friction that stops the first swing, or not a free decay.",
        )
    gaps = np.diff(time[turns])
    return float(np.median(gaps[1:] if len(gaps) > 1 else gaps))


def zigzag(signal: Array, threshold: float) -> list[int]:
    """Give the indices of the first sample and of turning points.

    Parameters
    ----------
    signal : array (n,)
        Any unit.
    threshold : float
        A turning point counts when the signal comes back from it by more than this, unit of the signal.

    Examples
    --------
    >>> zigzag(np.array([0.0, 3.0, 2.9, 3.1, 0.0, 1.0]), 0.5)
    [0, 3, 4]
    """
    turns, extreme, direction = [0], 0, 0
    for index in range(1, len(signal)):
        step = signal[index] - signal[extreme]
        if direction == 0:
            if abs(step) > threshold:
                direction, extreme = (1 if step > 0 else -1), index
        elif step * direction > 0.0:
            extreme = index
        elif -step * direction > threshold:
            turns.append(extreme)
            direction, extreme = -direction, index
    return turns


def _parabola(time: Array, signal: Array, smooth: Array, index: int, half: float) -> tuple[float, float]:
    near = np.abs(time - time[index]) <= half / 10.0
    near[max(index - 1, 0) : index + 2] = True
    local = time[near] - time[index]
    if len(local) < 3:
        return float(time[index]), float(smooth[index])
    square, slope, level = np.polyfit(local, signal[near], 2)
    shift = -slope / (2.0 * square) if square != 0.0 else 0.0
    if abs(shift) > half / 8.0:
        return float(time[index]), float(smooth[index])
    return float(time[index] + shift), float(level + 0.5 * slope * shift)


@dataclass(frozen=True)
class PeakRegression:
    """Viscous and dry damping from turning points.

    Attributes
    ----------
    damping_ratio : float
        [1].
    friction_deflection : float
        F_c / k, unit of the signal; negative when the peaks fall more slowly than any friction would allow.
    equilibrium : float
        Where the oscillation is centred, unit of the signal.
    """

    damping_ratio: float
    friction_deflection: float
    equilibrium: float


def ratio_from_decrement(decrement: float) -> float:
    """Give the damping ratio [1] that belongs to a logarithmic decrement per full cycle [1].

    Examples
    --------
    >>> round(ratio_from_decrement(0.631484), 6)
    0.1
    """
    return decrement / math.hypot(2.0 * math.pi, decrement)


def regress_peaks(peaks: Peaks) -> PeakRegression:
    """Separate viscous from dry damping by the recursion of turning points.

    The swings D_i between neighbouring turning points obey |D_(i+1)| = q |D_i| - 2 x_k (1 + q) whatever the equilibrium
    is; this gives q and the equilibrium. The amplitudes X_i about it then obey X_(i+1) = q X_i - x_k (1 + q), which is
    fitted using only turning points on alternating sides (a mass about to stick turns twice on the same side).

    Parameters
    ----------
    peaks : Peaks
        At least three turning points.

    Returns
    -------
    PeakRegression
        From three turning points alone the friction is taken as zero.

    Examples
    --------
    >>> x = np.array([20.0, -12.702389, 7.559395, -3.934868, 1.380481, 0.419723])
    >>> found = regress_peaks(Peaks(np.arange(6.0), x + 5.0))
    >>> [round(value, 4) for value in (found.damping_ratio, found.friction_deflection, found.equilibrium)]
    [0.1107, 0.8169, 5.0]
    """
    swing = np.abs(np.diff(peaks.value))
    if len(swing) < 3:
        q = float(np.clip(swing[1] / swing[0], 1e-4, 0.9999))
        return PeakRegression(_ratio_of(q), 0.0, _equilibrium(peaks, swing, q, 0.0))
    q, intercept = np.polyfit(swing[:-1], swing[1:], 1, w=swing[:-1])
    q = float(np.clip(q, 1e-4, 0.9999))
    friction = -float(intercept) / (2.0 * (1.0 + q))
    centre = _equilibrium(peaks, swing, q, friction)
    positive = alternating(peaks.value - centre)
    if len(positive) >= 4:
        slope, level = np.polyfit(positive[:-1], positive[1:], 1)
        if 0.0 < slope < 1.0:
            q, friction = float(slope), -float(level) / (1.0 + float(slope))
    return PeakRegression(_ratio_of(q), friction, centre)


def _ratio_of(q: float) -> float:
    """Damping ratio from the ratio of neighbouring amplitudes."""
    return ratio_from_decrement(-2.0 * math.log(q))


def _equilibrium(peaks: Peaks, swing: Array, q: float, friction: float) -> float:
    side = np.sign(-np.diff(peaks.value))  # +1 where the swing starts above
    amplitude = side * (friction + swing / (1.0 + q))
    return float(np.average(peaks.value[:-1] - amplitude, weights=swing))
