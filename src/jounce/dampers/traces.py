"""The travel of one damper over time: its spikes and jumps, where it stands, its noise, and its velocity."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.identify.signals import noise_of, quantum_of

Single = NDArray[np.float32]
Span = tuple[int, int]
"""First sample, and the one after the last."""

FASTEST = 3.0
"""Velocity (m/s) that no damper reaches within one sample; a single step that needs more is a jump."""
HARDEST = 3000.0
"""Acceleration of a damper's stroke (m/s^2) that only a spike exceeds."""
_CLEAR = 8.0  # standard deviations of second differences from which a spike stands out
_BRIEF = 0.1  # s: a jump that comes back within this time is a dropout
_ALONE = 3.0  # times the steps beside it: a jump, and not a fast motion
_FAR = 0.5  # of the usual range: further outside lies a brief excursion that is a spike
_SEEN = 100_000  # samples from which the usual range is told
_WINDOWS, _WINDOW = 16, 4096  # of a record, from which its noise is told
_LENGTH = 1.8  # half length of the kernel, in periods of the width between passband and stopband
_CHUNK = 1 << 15  # samples at a time: what fits the cache
_BLOCK, _ROWS = 4096, 16  # samples of a transform, and transforms at a time: what fits the cache
_FLAT = 0.01  # gain by which the passband may err


@dataclass(frozen=True)
class Differentiator:
    """A filter that differentiates up to a frequency, without a shift in time.

    The kernel is odd, exact for a ramp, and the least squares fit to a derivative below the cut-off and to zero above.

    Attributes
    ----------
    kernel : ndarray, shape (2 m + 1,)
        Weights in 1/s, to be convolved with the travel.
    cutoff : float
        Frequency (Hz) at which half of the amplitude is left.
    passband : float
        Frequency (Hz) up to which the velocity errs by less than 1 %.
    """

    kernel: Array
    cutoff: float
    passband: float

    @property
    def noise_gain(self) -> float:
        """Velocity (r.m.s.) for each unit of white noise in the travel (r.m.s.), 1/s."""
        return float(np.linalg.norm(self.kernel))


def differentiator(rate: float, cutoff: float) -> Differentiator:
    """Make the filter for a sample rate and a cut-off (Hz), which must lie below half the rate.

    >>> made = differentiator(1000.0, 60.0)
    >>> len(made.kernel), round(made.passband), round(made.noise_gain, 1)
    (63, 31, 66.2)
    """
    corner = cutoff / rate
    width = min(corner, 2.0 * (0.5 - corner))  # from passband to stopband, in cycles a sample
    half = max(2, math.ceil(_LENGTH / width))
    n = np.arange(1, half + 1)
    frequency = (np.arange(8 * half) + 0.5) / (16.0 * half)
    gains = np.sin(2.0 * math.pi * np.outer(frequency, n)) / (math.pi * frequency[:, np.newaxis])
    is_passed, is_stopped = frequency < corner - 0.5 * width, frequency > corner + 0.5 * width
    weight = np.where(is_stopped, frequency / corner, 1.0) * (is_passed | is_stopped)
    side = np.linalg.lstsq(gains * weight[:, np.newaxis], weight * is_passed, rcond=None)[0]
    side /= 2.0 * float(side @ n)  # exact for a ramp
    gain = gains @ side
    beyond, below = np.flatnonzero(np.abs(gain - 1.0) > _FLAT), np.flatnonzero(gain < 0.5)
    passed = float(frequency[max(beyond[0] - 1, 0)]) * rate if beyond.size else 0.5 * rate
    halved = 0.5 * rate
    if below.size:
        pair = slice(below[0] - 1, below[0] + 1)
        halved = float(np.interp(-0.5, -gain[pair], frequency[pair])) * rate
    kernel = rate * np.concatenate([side[::-1], [0.0], -side])
    return Differentiator(kernel, halved, passed)


def velocity_of(travel: Array, made: Differentiator) -> Single:
    """Differentiate a travel (m) to a velocity (m/s), in single precision, by overlapping transforms.

    Beyond its ends the travel is continued through them by a half turn, so that its slope is kept.
    """
    from scipy import fft

    half, count = len(made.kernel) // 2, travel.size
    block = _BLOCK if count > _BLOCK else 1 << max(8, (count + 4 * half).bit_length())
    step = block - 2 * half
    blocks = -(-count // step)
    padded = np.empty(blocks * step + 2 * half, np.float32)
    middle = float(travel[count // 2])
    padded[half : half + count] = (
        travel - middle
    )  # the digits of single precision are for the motion
    reach = min(half, count - 1)
    padded[:half] = 2.0 * padded[half] - _edge(padded[half + 1 : half + 1 + reach], half)[::-1]
    last = half + count
    tail = _edge(padded[last - 1 - reach : last - 1][::-1], half)
    padded[last : last + half] = 2.0 * padded[last - 1] - tail
    padded[last + half :] = padded[last + half - 1]
    kernel = fft.rfft(made.kernel.astype(np.float32), block)
    velocity = np.empty(blocks * step, np.float32)
    windows = np.lib.stride_tricks.sliding_window_view(padded, block)[::step]
    for first in range(0, blocks, _ROWS):
        spectrum = fft.rfft(windows[first : first + _ROWS], axis=1)
        spectrum *= kernel
        rows = fft.irfft(spectrum, block, axis=1)[:, 2 * half :]
        velocity[first * step : first * step + rows.size].reshape(rows.shape)[:] = rows
    return velocity[:count]


def _edge(values: Single, count: int) -> Single:
    """Return values continued by their last to a count."""
    return np.pad(values, (0, count - len(values)), mode="edge") if len(values) < count else values


def noise_in(travel: Array) -> float:
    """Estimate the white noise (r.m.s., in the unit of the travel) from windows spread over the record.

    Of a travel that is quantised coarsely, it is that of rounding. At low sample rates it contains some motion.
    """
    pieces = _windows(travel)
    quantum = quantum_of(np.concatenate(pieces))
    return max(
        float(np.median([noise_of(piece, 5) for piece in pieces])), quantum / math.sqrt(12.0)
    )


def largest_motion_in(travel: Array) -> float:
    """Return the largest standard deviation of windows spread over the record, in the unit of the travel."""
    return max(float(piece.std()) for piece in _windows(travel))


def _windows(travel: Array) -> list[Array]:
    """Return windows spread over a record."""
    starts = np.linspace(0, max(travel.size - _WINDOW, 0), _WINDOWS).astype(int)
    return [travel[start : start + _WINDOW] for start in np.unique(starts).tolist()]


def spikes_in(
    travel: Array, rate: float, ends: tuple[float, float]
) -> tuple[NDArray[np.intp], list[int]]:
    """Find samples of spikes and brief dropouts, and places where the level jumps and stays.

    A spike is a single sample whose second difference needs more than 3000 m/s^2 and stands out of the noise. A jump is
    a single step of more than 3 m/s between small ones; two that cancel within 0.1 s are a dropout. Brief excursions
    far outside the range of all other samples are spikes, too. ``ends`` are the least and the largest travel.

    >>> travel = 0.01 * np.sin(np.arange(2000) * 0.01)
    >>> travel[700] += 0.03
    >>> spikes_in(travel, 1000.0, (-0.01, 0.04))
    (array([700]), [])
    """
    bends = np.concatenate([np.diff(piece, 2) for piece in _windows(travel)])
    usual = _CLEAR * 0.5 * float(np.median(np.abs(bends))) / 0.6745
    least = max(min(0.5 * HARDEST / rate**2, FASTEST / rate), usual)
    least_jump = max(FASTEST / rate, usual)
    sharp, jumps = list[int](), dict[int, float]()
    for start in range(0, travel.size - 2, _CHUNK):
        part = travel[start : start + _CHUNK + 2]
        steps = part[1:] - part[:-1]
        if max(steps.max(), -steps.min()) <= least:
            continue
        size = np.abs(0.5 * (steps[1:] - steps[:-1]))
        peaks = np.flatnonzero((size[1:-1] >= size[:-2]) & (size[1:-1] >= size[2:])) + 1
        sharp += (start + 1 + peaks[size[peaks] > least]).tolist()
        size = np.abs(steps)
        alone = (size[1:-1] > _ALONE * size[:-2]) & (size[1:-1] > _ALONE * size[2:])
        for place in (np.flatnonzero(alone & (size[1:-1] > least_jump)) + 1).tolist():
            jumps[start + place] = float(steps[place])
    brief, lasting = _returning(jumps, rate, least_jump)
    near = {place for jump in jumps for place in range(jump - 1, jump + 3)}
    spikes = [*_outside(travel, rate, ends), *(place for place in sharp if place not in near)]
    spikes += [place for first, last in brief for place in range(first, last)]
    return np.unique(np.asarray(spikes, dtype=np.intp)), lasting


def _outside(travel: Array, rate: float, ends: tuple[float, float]) -> list[int]:
    """Return samples of brief excursions far outside the usual range."""
    sample = travel[:: max(1, travel.size // _SEEN)]
    low, high = np.quantile(sample, (0.0005, 0.9995))
    most = _FAR * float(high - low)
    if ends[1] <= high + most and ends[0] >= low - most:
        return []
    far = (travel > high + most) | (travel < low - most)
    return [
        place
        for first, last in spans_of(far)
        if last - first <= max(1, round(0.2 * _BRIEF * rate))
        for place in range(first, last)
    ]


def spans_of(mask: NDArray[np.bool_]) -> list[Span]:
    """Return the stretches in which a mask is true.

    >>> spans_of(np.array([True, False, True, True]))
    [(0, 1), (2, 4)]
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[0], mask.astype(np.int8), [0]])))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def _returning(
    jumps: Mapping[int, float], rate: float, least: float
) -> tuple[list[Span], list[int]]:
    """Return the samples between jumps that cancel each other, and the places of jumps that last."""
    places = sorted(jumps)
    brief, lasting = list[Span](), list[int]()
    k = 0
    while k < len(places):
        first, total, end = places[k], jumps[places[k]], k
        while abs(total) > least and end + 1 < len(places):
            if places[end + 1] - first > _BRIEF * rate:
                break
            end += 1
            total += jumps[places[end]]
        if end > k and abs(total) <= max(least, 0.5 * abs(jumps[first])):
            brief.append((first + 1, places[end] + 1))
        else:
            lasting.append(first)
        k = end + 1
    return brief, lasting


def without_spikes(travel: Array, spikes: NDArray[np.intp]) -> Array:
    """Replace samples by lines between their neighbours."""
    if not spikes.size:
        return travel
    keep = np.ones(travel.size, dtype=bool)
    keep[spikes] = False
    near = np.unique(np.clip(np.concatenate([spikes - 1, spikes + 1]), 0, travel.size - 1))
    known = near[keep[near]]
    if not known.size:
        return travel
    mended = travel.copy()
    mended[spikes] = np.interp(spikes, known, travel[known])
    return mended


def still_spans(travel: Array, rate: float, shortest: float) -> list[Span]:
    """Return the stretches in which a travel repeats one number for a time (s)."""
    step = max(1, int(0.05 * shortest * rate))
    coarse = travel[::step]
    spans = []
    for first, last in spans_of(coarse[1:] == coarse[:-1]):
        begin, end = first * step, min(last * step + 1, travel.size)
        if end - begin < shortest * rate or np.ptp(travel[begin:end]) > 0.0:
            continue
        while begin > 0 and travel[begin - 1] == travel[begin]:
            begin -= 1
        while end < travel.size and travel[end] == travel[begin]:
            end += 1
        spans.append((begin, end))
    return spans


def standing_share(travels: list[Array], rate: float, least: float) -> float:
    """Return the share of time [1] in which no damper moves by ``least`` (m) within a second."""
    step, wide = max(1, int(0.1 * rate)), 10
    still: Any = True
    for travel in travels:
        coarse = travel[::step]
        if coarse.size <= wide:
            return 0.0
        rows = coarse[: coarse.size // wide * wide].reshape(-1, wide)
        still = still & (np.ptp(rows, axis=1) < least)
    return float(np.mean(still))
