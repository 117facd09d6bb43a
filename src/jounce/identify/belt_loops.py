"""Loops of a belt: simulate trials on a belt that is already running, and cut and average recorded loops."""

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
"""Lead of an averaged loop before the obstacle, as a share of the distance between two passages."""
_ALIKE = 0.1
"""Minimum assumed scatter of the differences from the average, as a share of the median difference."""
_ODD = 4.0
"""Difference from the average, in robust standard deviations, above which a loop counts as an outlier."""


def running_trial(rig: Rig, road: Road, speed: float) -> tuple[Trial, float]:
    """Return a trial on a belt that is already running, and the start time (s) of its last loop.

    In each loop the obstacle of ``road`` begins after a share :data:`LEAD` of the recurrence distance.
    """
    assert road.recurrence is not None
    period = road.recurrence / speed
    loops = loops_before(rig, period)
    shifted = road.model_copy(update={"start": LEAD * road.recurrence})
    return Trial(road=shifted, speed=speed, duration=(loops + 1) * period), loops * period


def cut_loops(
    data: xr.Dataset, names: Sequence[str], time: Array, times: Array, period: float, count: int
) -> tuple[Array, np.ndarray]:
    """Return the complete loops of a record at ``count`` even phases, shape (loops, channels, count), and their starts.

    A loop is complete if the record contains all of it and no passage in it was missed.
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
    """Return the noise standard deviation of averaged loops, one value per channel.

    ``loops`` has shape (loops, channels, samples). A fit treats samples as independent, but the differences between
    loops are not white (speed, pressure, remaining vibration of earlier loops). The noise is therefore taken from their
    spectral density at the frequencies where the signal has its power.
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
    """Return a loop as a recording, with one row per channel."""
    channels = {
        name: (row, str(data[name].attrs["units"]), str(data[name].attrs.get("long_name", "")))
        for name, row in zip(names, values, strict=True)
    }
    clock = np.arange(values.shape[1]) * (period / values.shape[1])
    return recording_of(clock, channels, attributes=attributes)


def alike_loops(loops: Array) -> np.ndarray:
    """Mark the loops that are similar to the median of all loops."""
    middle = np.median(loops, axis=0)
    size = np.std(middle, axis=1)[:, None]
    away = np.sqrt(np.mean(((loops - middle) / np.where(size > 0.0, size, 1.0)) ** 2, axis=(1, 2)))
    usual = float(np.median(away))
    spread = 1.4826 * float(np.median(np.abs(away - usual)))
    return np.asarray(away <= usual + _ODD * max(spread, _ALIKE * usual))
