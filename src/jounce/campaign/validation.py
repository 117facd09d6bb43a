"""Where does the model hold? Every trial, fitted or held out, channel by channel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.identify.comparison import compare, iso18571
from jounce.identify.fit_problem import FitTrial, readings
from jounce.recordings import estimate_lag

HOLDS, PARTLY, FAILS = "holds", "holds partly", "does not hold"
_GOOD, _FAIR = 0.80, 0.58  # ISO/TS 18571 grades
_CLOSE, _LOOSE = 0.95, 0.75  # R2: a residual of 22 % and 50 % of the signal


@dataclass(frozen=True)
class ChannelComparison:
    """One channel of one trial: ``nrmse`` relative to the measured standard deviation, ``peak_error`` to its peak."""

    nrmse: float
    r2: float
    peak_error: float
    iso18571: float
    grade: str
    lag: float


@dataclass(frozen=True)
class Signals:
    """Curves behind a comparison: time (s), measured and simulated reading (SI)."""

    time: Array
    measured: Array
    simulated: Array


@dataclass(frozen=True)
class TrialComparison:
    """One trial against the model: numbers and verdict (by its worst channel's ISO/TS 18571 rating and R2)."""

    channels: dict[str, ChannelComparison]
    verdict: str
    objective: float


def compare_trial(
    trial: FitTrial, lag: float | None = 0.0
) -> tuple[TrialComparison, dict[str, Signals], list[Finding]]:
    """Simulate a trial with its rig's values and hold it against its recording.

    Parameters
    ----------
    trial : FitTrial
        Trial with rig, road and recording.
    lag : float or None
        Known lag of the recording, s; None: estimated from the signals by cross-correlation.
    """
    if lag is None:
        lag = _lag(readings(trial))
    curves = readings(trial, lag=lag)
    channels: dict[str, ChannelComparison] = {}
    signals: dict[str, Signals] = {}
    findings: list[Finding] = []
    objective = 0.0
    for name, (time, measured, simulated) in curves.items():
        numbers = compare(measured, simulated, time, place=f"{trial.name}, {name}")
        rating = iso18571(measured, simulated, 1.0 / float(np.median(np.diff(time))), place=f"{trial.name}, {name}")
        channels[name] = ChannelComparison(
            numbers.nrmse, numbers.r2, numbers.peak_error, rating.rating, rating.grade, numbers.lag
        )
        signals[name] = Signals(time, measured, simulated)
        findings += rating.findings
        objective += float(np.sum((measured - simulated) ** 2))
    return TrialComparison(channels, verdict_of(channels), objective), signals, findings


def verdict_of(channels: dict[str, ChannelComparison]) -> str:
    """Judge by the worst channel.

    ``holds``: ISO/TS 18571 above 0.80 (good) and R2 above 0.95; ``holds partly``: above 0.58 (fair) and 0.75. The
    rating alone forgives too much here: a record that is mostly at rest scores near 0.9 with a third of its motion
    missed.
    """
    rating = min(channel.iso18571 for channel in channels.values())
    explained = min(channel.r2 for channel in channels.values())
    if rating > _GOOD and explained > _CLOSE:
        return HOLDS
    return PARTLY if rating > _FAIR and explained > _LOOSE else FAILS


def _lag(curves: dict[str, tuple[Array, Array, Array]]) -> float:
    """Lag of the recording from its channel with the largest standard deviation in SI, an acceleration as a rule."""
    time, measured, simulated = max(curves.values(), key=lambda curve: float(np.std(curve[1])))
    return float(estimate_lag(simulated, measured, 1.0 / float(np.median(np.diff(time)))))
