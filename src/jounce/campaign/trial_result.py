"""Comparison of trials with the model: metrics of each channel, verdict, and curves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from jounce.campaign.belt import TrialOnBelt
from jounce.campaign.description import TrialEntry
from jounce.core.findings import Finding
from jounce.core.results import Shows
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.identify.comparison import compare, iso18571
from jounce.identify.datum import with_datums
from jounce.identify.fit_problem import FitTrial, Simulated
from jounce.parts import Rig
from jounce.recordings import estimate_lag
from jounce.roads import Trial

HOLDS, PARTLY, FAILS = "holds", "holds partly", "does not hold"
_GOOD, _FAIR = 0.80, 0.58  # ISO/TS 18571 grades
CLOSE, LOOSE = 0.95, 0.75  # R2: a residual of 22 % and 50 % of the signal


@dataclass(frozen=True)
class ChannelComparison:
    """Metrics of one channel: ``nrmse`` relative to the measured standard deviation, ``peak_error`` to the peak.

    ``objective`` is the channel's part of Eq. 2: the sum of squared differences, in the square of the channel's unit.
    """

    nrmse: Annotated[float, Shows("NRMSE", "1", 2)]
    r2: Annotated[float, Shows("R²", "1", 4)]
    peak_error: Annotated[float, Shows("peak error", "%", 2)]
    iso18571: Annotated[float, Shows("ISO 18571", "1", 2)]
    grade: Annotated[str, Shows("grade")]
    lag: float
    objective: float


@dataclass(frozen=True)
class Signals:
    """Curves of a comparison: time (s), measured and simulated signal (SI)."""

    time: Array
    measured: Array
    simulated: Array


@dataclass(frozen=True)
class TrialComparison:
    """Comparison of one trial with the model: metrics and verdict (worst ISO/TS 18571 rating and R2 of a channel)."""

    channels: dict[str, ChannelComparison]
    verdict: str
    objective: float


@dataclass(frozen=True)
class TrialMotion:
    """Simulation of a trial: the rig as set up, and all outputs (SI) over time (s)."""

    rig: Rig
    trial: Trial
    time: Array
    outputs: Mapping[str, Array]


def compare_trial(
    trial: FitTrial, lag: float | None = 0.0
) -> tuple[TrialComparison, dict[str, Signals], list[Finding], TrialMotion]:
    """Simulate a trial and compare it with its recording, which lags by ``lag`` (s; None: estimated by correlation)."""
    (trial,), _ = with_datums([trial])
    model = Simulated(trial)
    if lag is None:
        lag = _lag(model.readings())
    curves = model.readings(lag)
    channels: dict[str, ChannelComparison] = {}
    signals: dict[str, Signals] = {}
    findings: list[Finding] = []
    for name, (time, measured, simulated) in curves.items():
        numbers = compare(measured, simulated, time, place=f"{trial.name}, {name}")
        rating = iso18571(
            measured,
            simulated,
            1.0 / float(np.median(np.diff(time))),
            place=f"{trial.name}, {name}",
        )
        channels[name] = ChannelComparison(
            numbers.nrmse,
            numbers.r2,
            numbers.peak_error,
            rating.rating,
            rating.grade,
            numbers.lag,
            float(np.sum((measured - simulated) ** 2)),
        )
        signals[name] = Signals(time, measured, simulated)
        findings += rating.findings
    objective = sum(channel.objective for channel in channels.values())
    motion = TrialMotion(
        trial.rig, trial.trial, trial.measured["time"].to_numpy(), model.outputs(lag)
    )
    return TrialComparison(channels, verdict_of(channels), objective), signals, findings, motion


def verdict_of(channels: dict[str, ChannelComparison]) -> str:
    """Judge by the worst channel.

    ``holds``: ISO/TS 18571 above 0.80 (good) and R2 above 0.95; ``holds partly``: above 0.58 (fair) and 0.75. The
    rating alone is too lenient: a record that is mostly at rest scores near 0.9 even if a third of the motion is
    missing.
    """
    rating = min(channel.iso18571 for channel in channels.values())
    explained = min(channel.r2 for channel in channels.values())
    if rating > _GOOD and explained > CLOSE:
        return HOLDS
    return PARTLY if rating > _FAIR and explained > LOOSE else FAILS


def _lag(curves: dict[str, tuple[Array, Array, Array]]) -> float:
    """Estimate the lag of the recording from its channel with the largest standard deviation in SI."""
    time, measured, simulated = max(curves.values(), key=lambda curve: float(np.std(curve[1])))
    return float(estimate_lag(simulated, measured, 1.0 / float(np.median(np.diff(time)))))


@dataclass(frozen=True)
class TrialResult(Shown):
    """One trial before (characterised model) and after (last update); None if the recording is not usable.

    ``obstacle_pitch`` is the pitch of a train of obstacles in m, None for a single obstacle. ``motion`` is the
    simulation after the last update, ``belt`` the belt speed and passages if the record starts in motion.
    """

    entry: TrialEntry
    obstacle_pitch: float | None
    before: TrialComparison | None
    after: TrialComparison | None
    signals_before: dict[str, Signals]
    signals: dict[str, Signals]
    motion: TrialMotion | None = None
    belt: TrialOnBelt | None = None
