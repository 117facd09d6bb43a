"""Properties of a force in each period of a plate (see ``inspection.turn_forces``)."""

from __future__ import annotations

import math

from jounce.kernel.arrays import Block, Matrix, Vector
from jounce.kernel.loops.compiling import FAST, dot, part

_PER_TURN = 40.0  # samples of a turn that are worked out, at least


@part(fastmath=FAST)
def _weigh(weight, wave, bell, reach, period, taps, half):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
    """Compute the filter taps of one period, normalised to gain 1 at 0 and at the frequency of the period."""
    for j in range(reach + 1):
        place = j / period / half * (taps.size - 1)
        k = min(int(place), taps.size - 2)
        weight[reach + j] = taps[k] + (place - k) * (taps[k + 1] - taps[k])
        wave[j], bell[j] = (
            math.cos(2.0 * math.pi * j / period),
            1.0 + math.cos(math.pi * j / (reach + 1.0)),
        )
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
    """Return where a signal falls below a line before its minimum and rises above it afterwards; NaN if it does not."""
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
    """Return the extreme value of the parabola through three samples, and its position relative to the middle one."""
    bend = smooth[at - 1] - 2.0 * smooth[at] + smooth[at + 1]
    tilt = smooth[at - 1] - smooth[at + 1]
    if abs(tilt) >= abs(bend) or bend == 0.0:
        return smooth[at], 0.0
    return smooth[at] - 0.125 * tilt * tilt / bend, 0.5 * tilt / bend


@part(fastmath=FAST)
def find(
    signals: Matrix,
    rate: float,
    start: float,
    tops: Vector,
    frequencies: Vector,
    level: float,
    taps: Vector,
    half: float,
    low: float,
    high: float,
    smooth: Vector,
    weight: Vector,
    wave: Vector,
    bell: Vector,
    found: Block,
) -> None:
    """Compute the properties of each force in each period; the four arrays before ``found`` are scratch space."""
    count, rows, samples = tops.size, signals.shape[0], signals.shape[1]
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
        weights = weight[: 2 * reach + 1]
        step = max(1, int(period / _PER_TURN))
        length = (last - first) // step + 1
        for row in range(rows):
            for m in range(length):
                begin = first + m * step - reach
                smooth[m] = dot(weights, signals[row, begin : begin + weights.size])
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
