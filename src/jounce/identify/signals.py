"""Noise, resolution, turning points and missing samples of a smooth signal."""

from __future__ import annotations

import math

import numpy as np

from jounce.core.types import Array


def noise_of(signal: Array, order: int = 3) -> float:
    """Estimate the standard deviation of the white noise in a smooth signal, in its unit.

    Differences of an order remove the motion, higher ones more of it; their median absolute value is robust to single
    jumps.

    >>> noise_of(np.sin(np.linspace(0.0, 6.0, 2000))) < 1e-6
    True
    """
    gain = math.sqrt(math.comb(2 * order, order))
    return float(np.median(np.abs(np.diff(signal, order))) / (0.6745 * gain))


def quantum_of(x: Array) -> float:
    """Return the quantisation step of a signal, in its unit; 0 if it is not quantised."""
    values = np.unique(x)
    gaps = np.diff(values[np.append(True, np.diff(values) > 1e-9 * max(float(np.ptp(x)), 1e-300))])
    if len(gaps) < 2 or len(gaps) > 0.5 * len(
        x
    ):  # hardly any value repeats: not quantised, or too finely to matter
        return 0.0
    counts = gaps / gaps.min()
    # Gaps are multiples of the step but for the digits of a file; without steps they are off by a half.
    return float(gaps.min()) if float(np.abs(counts - np.round(counts)).max()) < 0.02 else 0.0


def zigzag(signal: Array, threshold: float) -> list[int]:
    """Return indices of the first sample and of the turning points followed by a swing larger than ``threshold``.

    >>> zigzag(np.array([0.0, 3.0, 2.9, 3.1, 0.0, 1.0]), 0.5)
    [0, 3, 4]
    """
    # Between two local extremes nothing can turn: only these are visited, each at the first of equal samples.
    moves = np.flatnonzero(np.diff(signal))
    signs = np.sign(signal[moves + 1] - signal[moves])
    places = moves[np.flatnonzero(np.append(signs[1:] != signs[:-1], True))] + 1
    turns, extreme, direction, value = [0], 0, 0, float(signal[0]) if len(signal) else 0.0
    for index, height in zip(places.tolist(), signal[places].tolist(), strict=True):
        step = height - value
        if direction == 0:
            if abs(step) > threshold:
                direction, extreme, value = (1 if step > 0 else -1), index, height
        elif step * direction > 0.0:
            extreme, value = index, height
        elif -step * direction > threshold:
            turns.append(extreme)
            direction, extreme, value = -direction, index, height
    return turns


def count_lost_samples(time: Array, signal: Array) -> int:
    """Count gaps where a smooth signal jumps as if samples were missing, although the time steps are even.

    At a gap one step is at least 1.5 times as large as the two on either side, which are similar and far above the
    noise.

    >>> t = np.arange(400) * 1e-3
    >>> count_lost_samples(t, np.sin(20.0 * t)), count_lost_samples(t, np.sin(20.0 * np.append(t[:9], t[9:] + 2e-3)))
    (0, 1)
    """
    rates = np.diff(signal) / np.diff(time)
    if len(rates) < 5:
        return 0
    step = float(np.median(np.diff(time)))
    middle, beside = rates[2:-2], np.stack([rates[:-4], rates[1:-3], rates[3:-1], rates[4:]])
    side = np.sign(middle)
    sizes = side * beside
    least, most = sizes.min(axis=0), sizes.max(axis=0)
    least_step = max(
        _CLEAR * max(noise_of(signal), quantum_of(signal)), 1e-9 * float(np.ptp(signal))
    )
    jumps = (least * step > least_step) & (most < _LIKE * least) & (side * middle > _TORN * most)
    return int(np.count_nonzero(jumps))


_CLEAR, _LIKE, _TORN = 10.0, 1.3, 1.5  # times the noise, the least and the most of the steps beside
