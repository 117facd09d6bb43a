"""Slow, readable twin of the low pass that goes with each period: NumPy only, the prototype's taps are given."""

from __future__ import annotations

import numpy as np


def weights(reach, period, taps, half):
    """Weights (2 reach + 1,) of one period, whose gain is 1 at 0 and at the period's frequency."""
    j = np.arange(-reach, reach + 1)
    value = np.interp(np.abs(j) / period, np.linspace(0.0, half, taps.size), taps)
    wave, bell = np.cos(2.0 * np.pi * j / period), 1.0 + np.cos(np.pi * j / (reach + 1.0))
    value /= value.sum()
    centre = (bell @ wave) / bell.sum()
    correction = bell * (wave - centre)
    return value + correction * (1.0 - value @ wave) / (correction @ wave)


def least_in_period(signal, rate, start, top, frequency, taps, half, window):
    """Least value of the smoothed signal between two places in periods after a top, and its time: a parabola.

    At least 40 places of a turn are worked out: every sample of short turns, every second or third one of longer ones.
    """
    period = rate / frequency
    reach, step = int(half * period), max(1, int(period / 40.0))
    smooth = np.convolve(
        signal, weights(reach, period, taps, half), mode="same"
    )  # what is near the ends is not used
    middle = (top - start) * rate
    place = np.arange(np.floor(middle + (window[0] - 0.55) * period), signal.size, step).astype(int)
    inside = place[(place >= middle + window[0] * period) & (place <= middle + window[1] * period)]
    at = inside[np.argmin(smooth[inside])]
    a, b, c = np.polyfit([-1.0, 0.0, 1.0], smooth[[at - step, at, at + step]], 2)
    return c - b * b / (4.0 * a), start + (at - 0.5 * b / a * step) / rate
