"""Trials on a belt that is already running: the averaged loop, one loop, or the whole record."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import xarray as xr

from jounce.core.errors import FitError
from jounce.identify.belt_loops import LEAD, cut_loops, loop_recording, running_trial
from jounce.identify.fit_problem import FitTrial
from jounce.identify.passages import Passages


def select_loop(
    passages: Passages, measured: xr.Dataset, number: int, *, channels: Sequence[str], name: str
) -> Passages:
    """Return the passages with a single loop (counted from 1) instead of the average.

    Raises
    ------
    FitError
        If the loop of this passage is incomplete.
    """
    time = np.asarray(measured["time"].to_numpy(), dtype=float)
    period = passages.period or float(time[-1] - time[0])
    count = max(round(period * (len(time) - 1) / float(time[-1] - time[0])), 8)
    loops, begun = cut_loops(measured, channels, time, np.array(passages.times), period, count)
    whole = [int(k) + 1 for k in begun]
    if number not in whole:
        raise FitError(
            "no loop of this passage is recorded in full",
            where=f"{name}: passage",
            found=number,
            allowed=", ".join(map(str, whole)) or "none",
        )
    loop = loop_recording(measured, channels, loops[whole.index(number)], period)
    alone = math.sqrt(passages.loop.attrs["passages"]) if passages.loop is not None else 1.0
    noise = {channel: alone * value for channel, value in passages.noise.items()}
    return replace(passages, loop=loop, scatter=None, repeatability={}, noise=noise)


def averaged_trial(trial: FitTrial, passages: Passages) -> FitTrial:
    """Return the trial with the averaged loop as its record, on a belt running at the speed of the passages."""
    road = trial.trial.road
    if passages.loop is None or road is None or road.recurrence is None:
        raise FitError("no complete loop of the belt was found", where=trial.name)
    driven, begin = running_trial(trial.rig, road, passages.speed)
    loop = passages.loop.assign_coords(
        time=("time", passages.loop["time"].to_numpy() + begin, {"units": "s"})
    )
    return replace(trial, trial=driven, measured=loop, noise=passages.noise)


def trial_on_running_belt(trial: FitTrial, passages: Passages) -> FitTrial:
    """Return the trial with its whole record, on a belt running at the speed of the passages.

    For records without a complete loop: the model meets the obstacle at its first passage in the record.
    """
    road = trial.trial.road
    assert road is not None
    assert road.recurrence is not None
    driven, begin = running_trial(trial.rig, road, passages.speed)
    period = road.recurrence / passages.speed
    time = np.asarray(trial.measured["time"].to_numpy(), dtype=float)
    shift = begin + LEAD * period - passages.times[0]
    if time[0] + shift < 0.0:  # earlier passages are longer ago than the simulated preceding loops
        shift += period * math.ceil(-(time[0] + shift) / period)
    shifted = trial.measured.assign_coords(
        time=("time", time + shift, trial.measured["time"].attrs)
    )
    return replace(
        trial, trial=driven.with_fields(duration=float(time[-1] + shift)), measured=shifted
    )
