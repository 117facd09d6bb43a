"""Low pass that goes with the frequency of each period, and what the force does in that period (compiled)."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

from jounce.core.types import Array
from jounce.kernel.call import kept, part

PASS, STOP, RIPPLE = 2.0, 4.0, 0.01
_POINTS = 1025
_PER_TURN = 40.0  # samples of a turn that are worked out, at least
_FAST = {"reassoc", "contract", "arcp", "nsz"}  # sums in any order; NaN stays NaN
FIELDS = ("least", "least_time", "greatest", "down", "up", "mean", "half_amplitude")


@cache
def prototype() -> tuple[Array, float]:
    """Give one half of the filter's impulse response against time in periods, and the length of that half.

    Returns
    -------
    taps : ndarray, shape (1025,)
        Weight per period (1) from the middle to the end.
    half : float
        Length of a half in periods (1).

    Notes
    -----
    A Kaiser window on a sinc between pass band (2 f) and stop band (4 f) with a ripple of 0.01 (EGEA SPECSUS2018), and
    within that ripple moved so that the gain is exactly 1 at 0, f and 2 f: amplitudes are not biased by the filter.
    """
    from scipy.signal.windows import kaiser

    attenuation = -20.0 * math.log10(RIPPLE)
    shape = 0.5842 * (attenuation - 21.0) ** 0.4 + 0.07886 * (attenuation - 21.0)
    half = 0.5 * (attenuation - 7.95) / (2.285 * 2.0 * math.pi * (STOP - PASS))
    window = kaiser(2 * _POINTS - 1, shape)[_POINTS - 1 :]
    u = np.linspace(0.0, half, _POINTS)
    weights = np.full(_POINTS, 2.0 * half / (_POINTS - 1))
    weights[[0, -1]] *= 0.5
    waves = np.cos(2.0 * np.pi * np.outer(np.arange(3), u))
    taps = window * (STOP + PASS) * np.sinc((STOP + PASS) * u)
    gains = (waves * window * weights) @ waves.T
    taps += window * (np.linalg.solve(gains, 1.0 - (waves * weights) @ taps) @ waves)
    taps.setflags(write=False)
    return taps, half


@part(fastmath=_FAST)
def _dot(weight, values):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
    total = 0.0
    for j in range(values.size):
        total += weight[j] * values[j]
    return total


@part(fastmath=_FAST)
def _weigh(weight, wave, bell, reach, period, taps, half):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
    """Taps of one period; the sampled ones, too, are given the gain 1 at 0 and at the period's frequency."""
    for j in range(reach + 1):
        place = j / period / half * (taps.size - 1)
        k = min(int(place), taps.size - 2)
        weight[reach + j] = taps[k] + (place - k) * (taps[k + 1] - taps[k])
        wave[j], bell[j] = math.cos(2.0 * math.pi * j / period), 1.0 + math.cos(math.pi * j / (reach + 1.0))
    total = first = 0.5 * weight[reach]
    bells = waved = squared = 1.0  # of one half, as are all sums here
    for j in range(1, reach + 1):
        total += weight[reach + j]
        first += weight[reach + j] * wave[j]
        bells += bell[j]
        waved += bell[j] * wave[j]
        squared += bell[j] * wave[j] * wave[j]
    scale, centre = 0.5 / total, waved / bells
    lift = 0.5 * (1.0 - 2.0 * first * scale) / (squared - waved * centre)
    for j in range(reach + 1):
        value = weight[reach + j] * scale + lift * bell[j] * (wave[j] - centre)
        weight[reach + j] = weight[reach - j] = value


@part(fastmath=False)
def _fall_and_rise(smooth, at, length, line):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
    """Places where a signal falls below a line before its least value and rises above it afterwards, else NaN."""
    fall, rise = math.nan, math.nan
    m = at
    while m > 0 and smooth[m] < line:
        m -= 1
    if smooth[m] >= line:
        fall = m + (smooth[m] - line) / (smooth[m] - smooth[m + 1])
    m = at
    while m < length - 1 and smooth[m] < line:
        m += 1
    if smooth[m] >= line:
        rise = m - (smooth[m] - line) / (smooth[m] - smooth[m - 1])
    return fall, rise


@part(fastmath=False)
def _vertex(smooth, at):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
    """Value of the parabola through three samples at its turning point, and where that is from the middle one."""
    bend = smooth[at - 1] - 2.0 * smooth[at] + smooth[at + 1]
    tilt = smooth[at - 1] - smooth[at + 1]
    if abs(tilt) >= abs(bend) or bend == 0.0:
        return smooth[at], 0.0
    return smooth[at] - 0.125 * tilt * tilt / bend, 0.5 * tilt / bend


@kept(error_model="numpy", fastmath=_FAST)
def _periods(signals, rate, start, tops, frequencies, level, taps, half, low, high):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
    count, rows, samples = tops.size, signals.shape[0], signals.shape[1]
    found = np.full((rows, count, 7), np.nan)
    longest = int(rate / frequencies.min() * (high - low + 1.2)) + 8
    smooth = np.empty(longest)
    widest = int(half * rate / frequencies.min()) + 2
    weight, wave, bell = np.empty(2 * widest), np.empty(widest), np.empty(widest)
    for i in range(count):
        f = frequencies[i]
        period = rate / f
        reach = int(half * period)
        middle = (tops[i] - start) * rate
        first = math.floor(middle + (low - 0.55) * period)
        last = math.ceil(middle + (high + 0.55) * period)
        if first - reach < 0 or last + reach >= samples:
            continue
        _weigh(weight, wave, bell, reach, period, taps, half)
        step = max(1, int(period / _PER_TURN))
        length = (last - first) // step + 1
        for row in range(rows):
            for m in range(length):
                begin = first + m * step - reach
                smooth[m] = _dot(weight, signals[row, begin : begin + 2 * reach + 1])
            begin = math.ceil((middle + low * period - first) / step)
            end = math.floor((middle + high * period - first) / step)
            at = begin
            for m in range(begin, end + 1):
                if smooth[m] < smooth[at]:
                    at = m
            if at in (0, begin, end, length - 1):
                continue
            one = round(period / step)
            low_end, high_end = max(at - one // 2, 1), min(at + (one + 1) // 2, length - 1)
            top, mean = low_end, 0.0
            for m in range(low_end, high_end):
                mean += smooth[m]
                if smooth[m] > smooth[top]:
                    top = m
            least, shift = _vertex(smooth, at)
            greatest, _ = _vertex(smooth, top)
            found[row, i, 0] = least
            found[row, i, 1] = start + (first + (at + shift) * step) / rate
            found[row, i, 2] = greatest
            found[row, i, 5] = mean / max(high_end - low_end, 1)
            found[row, i, 6] = 0.5 * (greatest - least)
            line = level
            if not (least + 0.1 * (greatest - least) < level < greatest - 0.1 * (greatest - least)):
                line = 0.5 * (least + greatest)
            fall, rise = _fall_and_rise(smooth, at, length, line)
            found[row, i, 3] = start + (first + fall * step) / rate
            found[row, i, 4] = start + (first + rise * step) / rate
    return found


def force_in_periods(
    signals: Array,
    rate: float,
    start: float,
    tops: Array,
    frequencies: Array,
    level: float,
    window: tuple[float, float],
) -> Array:
    """Find what forces do in each period of the plate, after the low pass that goes with the period.

    Parameters
    ----------
    signals : ndarray, shape (rows, n)
        Forces in N.
    rate, start : float
        Samples per second (Hz), and time (s) of the first one.
    tops, frequencies : ndarray, shape (periods,)
        When the plate is highest (s), and its frequency then (Hz).
    level : float
        N; crossings of this level around the least force are looked for (of the middle, where it is never crossed).
    window : (float, float)
        Where the least force is looked for, in periods (1) after the top.

    Returns
    -------
    ndarray, shape (rows, periods, 7)
        Least force (N) and its time (s), greatest force (N) in the period around it, times (s) at which the force
        falls below the level before and rises above it after the least force, mean force (N), half of greatest less
        least (N). NaN where the record does not reach or the least force lies at the window's end.
    """
    taps, half = prototype()
    block = np.ascontiguousarray(signals)
    return np.asarray(
        _periods(block, float(rate), float(start), tops, frequencies, float(level), taps, half, window[0], window[1])
    )
