"""Loops of a belt: how a trial begins on one that has been running, and how its loops are cut and averaged."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from jounce.core.types import Array
from jounce.parts import Rig
from jounce.recordings.schema import recording_of
from jounce.roads import Road, Trial
from jounce.simulation.running import loops_before

LEAD = 0.05
"""Share of the distance between two passages by which an averaged loop begins before the obstacle."""
_ALIKE = 0.1
"""Scatter of the differences to the average that loops have at least, as a share of their usual one."""
_ODD = 4.0
"""Robust standard deviations of the difference to the average, beyond which a loop counts as odd."""


def running_trial(rig: Rig, road: Road, speed: float) -> tuple[Trial, float]:
    """A trial on a belt that has been running, and the time (s) at which its last loop begins.

    The obstacle of ``road`` begins :data:`LEAD` of its recurrence after each loop does.
    """
    assert road.recurrence is not None
    period = road.recurrence / speed
    loops = loops_before(rig, period)
    shifted = road.model_copy(update={"start": LEAD * road.recurrence})
    return Trial(road=shifted, speed=speed, duration=(loops + 1) * period), loops * period


def cut_loops(
    data: xr.Dataset, names: Sequence[str], time: Array, times: Array, period: float, count: int
) -> tuple[Array, np.ndarray]:
    """Whole loops of a record, each at ``count`` even phases; shape (loops, channels, count), and where they begin.

    A loop is whole where the record holds all of it and no passage was missed in it.
    """
    from scipy.interpolate import CubicSpline

    signals = CubicSpline(time, np.stack([data[name].to_numpy() for name in names], axis=1))
    loops, numbers = [], []
    for number, (begin, own) in enumerate(
        zip(times[:-1] - LEAD * period, np.diff(times), strict=True)
    ):
        if round(own / period) == 1 and begin >= time[0] and begin + own <= time[-1]:
            loops.append(signals(begin + own * np.arange(count) / count).T)
            numbers.append(number)
    return np.array(loops), np.array(numbers, dtype=int)


def noise_of_average(loops: Array) -> list[float]:
    """Standard deviation of the noise of the average of loops, a value a channel; loops are (loops, channels, samples).

    A fit counts its samples as independent. What differs from loop to loop is hardly white (speed, pressure, what is
    left of earlier loops), so its density counts where the signal has its power.
    """
    count, _, samples = loops.shape
    mean = loops.mean(axis=0)
    power = np.abs(np.fft.rfft(mean - mean.mean(axis=1, keepdims=True), axis=1)) ** 2
    apart = np.sum(np.abs(np.fft.rfft(loops - mean, axis=2)) ** 2, axis=0) / (samples * (count - 1))
    within = np.sum(power * apart, axis=1) / np.maximum(np.sum(power, axis=1), 1e-300)
    return [float(value) for value in np.sqrt(within / count)]


def loop_recording(
    data: xr.Dataset, names: Sequence[str], values: Array, period: float, **attributes: Any
) -> xr.Dataset:
    """A loop as a recording: one row for each channel."""
    channels = {
        name: (row, str(data[name].attrs["units"]), str(data[name].attrs.get("long_name", "")))
        for name, row in zip(names, values, strict=True)
    }
    clock = np.arange(values.shape[1]) * (period / values.shape[1])
    return recording_of(clock, channels, attributes=attributes)


def alike_loops(loops: Array) -> np.ndarray:
    """Which loops are like the median of all."""
    middle = np.median(loops, axis=0)
    size = np.std(middle, axis=1)[:, None]
    away = np.sqrt(np.mean(((loops - middle) / np.where(size > 0.0, size, 1.0)) ** 2, axis=(1, 2)))
    usual = float(np.median(away))
    spread = 1.4826 * float(np.median(np.abs(away - usual)))
    return np.asarray(away <= usual + _ODD * max(spread, _ALIKE * usual))
