"""Speed from the pulses of a photo sensor or toothed wheel, corrected for missing and double pulses."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.catalogue import Severity
from jounce.core.errors import RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import positive_si

FEWEST_PULSES = 4
"""Minimum number of pulses (three periods): with fewer, a missing pulse looks like a slow revolution."""
_HYSTERESIS = 0.25
"""Hysteresis around the middle level as a fraction of the pulse height, within which noise triggers no edge."""
_LEAST_CONTRAST = 4.0
"""Minimum ratio of the pulse height to the scatter of the signal between pulses."""
_NOT_BETWEEN = 0.6
"""Maximum fraction of samples around the middle level; a sine has a third, noise nearly all."""
_PLAUSIBLE = 150.0
"""Maximum plausible speed (m/s) of a belt or wheel, as for channels of speed."""


@dataclass(frozen=True)
class PulseSpeed(Shown):
    """Speed calculated from pulses.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Instants of the pulses, s, without double pulses.
    distance : ndarray, shape (n,)
        Distance travelled at each pulse, m, 0 at the first; missing pulses are counted.
    speed : ndarray, shape (n,)
        Speed at each pulse, averaged over one revolution, m/s.
    mean : float
        Mean speed of the whole record, m/s.
    resolution : float
        Standard deviation (m/s) of ``speed`` due to sampling and jitter.
    variation : float
        Standard deviation (m/s) of ``speed`` around its mean.
    missing, doubled : int
        Number of missed pulses, and of pulses detected twice.
    findings : tuple of Finding
        Missing and double pulses, and a varying speed.
    """

    time: Array
    distance: Array
    speed: Array
    mean: float
    resolution: float
    variation: float
    missing: int
    doubled: int
    findings: tuple[Finding, ...] = ()


def pulse_speed(
    time: ArrayLike,
    signal: ArrayLike,
    *,
    per_turn: int,
    radius: float | str,
    where: str = "pulses",
) -> PulseSpeed:
    """Calculate the speed of a belt or wheel from a pulse signal.

    Edges are counted over one revolution of the cylinder, which cancels uneven spacing of the marks and reduces the
    effect of sampling.

    Parameters
    ----------
    time : array_like, shape (n,)
        Instants of the samples, s, at constant steps.
    signal : array_like, shape (n,)
        Voltage of the sensor, or any signal that changes between two levels at each mark.
    per_turn : int
        Pulses per revolution.
    radius : float or str
        Effective radius, m: radius of the cylinder plus half the thickness of the belt.
    where : str
        Name of the signal in errors and findings.

    Returns
    -------
    PulseSpeed
        Speed over time.

    Raises
    ------
    RecordingError
        If the signal does not have two levels, has fewer than four pulses, or the speed is implausible for a bench.

    Examples
    --------
    >>> import numpy as np
    >>> time = np.arange(4000) / 2000.0
    >>> seen = np.mod(10.0 * time, 1.0) < 0.02   # ten pulses a second
    >>> found = pulse_speed(time, 5.0 * seen, per_turn=2, radius="50 mm")
    >>> round(found.mean, 3), found.missing, found.doubled
    (1.571, 0, 0)
    """
    at = as_samples(time, "s", where=f"{where}: time")
    circumference = 2.0 * math.pi * positive_si(radius, "m", where=f"{where}: radius")
    if per_turn < 1:
        raise RecordingError(
            "invalid number of pulses per revolution",
            where=where,
            found=per_turn,
            allowed="1 or more",
        )
    seen = edges(at, as_samples(signal, where=where), where=where)
    marks, is_mark, doubled = _number_marks(seen)
    seen, missing = seen[is_mark], int(marks[-1] + 1 - len(marks))
    distance = circumference / per_turn * marks
    mean = float(distance[-1] / (seen[-1] - seen[0]))
    if mean > _PLAUSIBLE:
        raise RecordingError(
            "an implausible speed for a bench",
            where=where,
            found=f"{mean:.4g} m/s",
            allowed=Phrase("up to {plausible:g} m/s", plausible=_PLAUSIBLE),
            hint="Check the radius, the pulses per revolution and the time step.",
        )
    speed = _over_a_turn(seen, distance, per_turn)
    step = float(at[1] - at[0])
    span = max(per_turn, 1) * circumference / per_turn / mean
    resolution = mean * step / math.sqrt(6.0) / span
    variation = float(speed.std())
    findings = _findings(missing, doubled, len(marks), variation, resolution, mean, where)
    return PulseSpeed(
        seen, distance, speed, mean, resolution, variation, missing, doubled, tuple(findings)
    )


def edges(time: Array, signal: Array, *, where: str = "pulses") -> Array:
    """Find the instants (s) of rising edges of a two-level signal, by linear interpolation between samples."""
    low, high = float(signal.min()), float(signal.max())
    middle, height = 0.5 * (low + high), high - low
    below = signal[signal < middle]
    scatter = 1.4826 * float(np.median(np.abs(below - np.median(below)))) if below.size else 0.0
    between = float(np.mean(np.abs(signal - middle) < _HYSTERESIS * height))
    if height <= 0.0 or height < _LEAST_CONTRAST * scatter or between > _NOT_BETWEEN:
        raise RecordingError(
            "no pulses: the signal does not alternate between two levels",
            where=where,
            found=f"{low:.4g} to {high:.4g}",
            hint="Was the sensor connected, and is this its column?",
        )
    upper, lower = middle + _HYSTERESIS * height, middle - _HYSTERESIS * height
    level = np.where(signal > upper, 1, np.where(signal < lower, -1, 0))
    known = np.flatnonzero(level)
    rising = np.flatnonzero((level[known[1:]] > 0) & (level[known[:-1]] < 0))
    after = known[rising + 1]
    before = known[rising]
    for i in range(len(after)):  # the two samples between which it crosses the middle
        inside = np.flatnonzero(signal[before[i] : after[i] + 1] >= middle)
        after[i] = before[i] + inside[0]
    share = (middle - signal[after - 1]) / (signal[after] - signal[after - 1])
    instants = time[after - 1] + share * (time[after] - time[after - 1])
    if len(instants) < FEWEST_PULSES:
        raise RecordingError(
            "too few pulses",
            where=where,
            found=len(instants),
            allowed=Phrase("at least {fewest_pulses}", fewest_pulses=FEWEST_PULSES),
            hint="Record longer, or put more marks on the cylinder.",
        )
    return np.asarray(instants, dtype=float)


def _number_marks(seen: Array) -> tuple[Array, NDArray[np.bool_], int]:
    """Number the detected marks; also return which edges are marks, and how many are duplicates."""
    usual = float(np.median(np.diff(seen)))
    is_mark = np.ones(len(seen), dtype=bool)
    last = 0
    for i in range(
        1, len(seen)
    ):  # an edge less than half a period behind the last one is the same mark again
        if seen[i] - seen[last] < 0.5 * usual:
            is_mark[i] = False
        else:
            last = i
    periods = np.diff(seen[is_mark])
    local = _running_median(periods)
    marks = np.concatenate([[0.0], np.cumsum(np.maximum(np.round(periods / local), 1.0))])
    return marks, is_mark, int(np.count_nonzero(~is_mark))


_WINDOW = 9  # periods: an odd number whose middle one a speed that changes, or a gap, does not move


def _running_median(values: Array) -> Array:
    width = min(_WINDOW, len(values) - (len(values) + 1) % 2)
    padded = np.pad(values, width // 2, mode="reflect" if width // 2 < len(values) else "edge")
    return np.asarray(
        np.median(np.lib.stride_tricks.sliding_window_view(padded, width), axis=1)[: len(values)]
    )


def _over_a_turn(seen: Array, distance: Array, per_turn: int) -> Array:
    """Return the speed at each pulse, averaged from half a revolution before it to half a revolution after it."""
    half = max(per_turn // 2, 1)
    index = np.arange(len(seen))
    first, last = np.clip(index - half, 0, None), np.clip(index + half, None, len(seen) - 1)
    return np.asarray((distance[last] - distance[first]) / (seen[last] - seen[first]))


_VARIES = 3.0  # resolutions: what sampling alone exceeds in one of 400 records
_STEADY = 0.002  # share of the speed by which a belt on an inverter swings at least
_MANY = 0.1  # share of missing pulses from which on the sensor should be looked at
_WORTH_A_WORD = 0.005  # share of missing and double pulses: sensors lose or double a few, and those are corrected


def _findings(
    missing: int,
    doubled: int,
    count: int,
    variation: float,
    resolution: float,
    mean: float,
    where: str,
) -> list[Finding]:
    findings = []
    if missing + doubled > _WORTH_A_WORD * count:
        severity: Severity = "warning" if missing > _MANY * count else "note"
        findings.append(
            finding(
                "recordings.pulses_corrected",
                where,
                float(missing),
                severity=severity,
                missing=missing,
                count=count + missing,
                doubled=doubled,
            )
        )
    if variation > _VARIES * resolution and variation > _STEADY * mean:
        findings.append(
            finding("recordings.speed_varies", where, variation, share=variation / mean, mean=mean)
        )
    return findings
