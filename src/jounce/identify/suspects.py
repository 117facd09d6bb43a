"""Test the residuals of a fit for possible faults of records and trials: filters, speed, height, reference.

Each suspect is modelled as a change of the readings or as a further unknown, after one step of the fitted values.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.identify.fit_problem import FitTrial, Residuals, UpdateProblem
from jounce.identify.nuisances import FASTEST, LOW_PASS, SPEED, START, begins_unknown, start_motions
from jounce.recordings.sensors import Sensor, filter_signals
from jounce.recordings.signals import shift_signals

_EXPLAINS = 0.35  # share of the residual above which the explaining fault is reported
ALIKE = 0.8  # ratio of the residuals of two faults above which they cannot be distinguished
_CORNERS = 12  # that are tried, the neighbours 40 or 52 % apart
_SLIGHT = 0.003  # of the speed: smaller errors do no harm
_COUPLED = (0.1, 10.0)  # Hz: corners of high passes
_AHEAD, _AHEAD_STEP = (
    0.04,
    0.005,
)  # s: largest lead or lag of the road at the sensor relative to the wheel
_WHOLE = (0.7, 1.3)  # plausible ratios to the road's height for a distance to the road
_SEEN = 1e-10  # of the largest singular value
_MATTERS = 1e-4  # share of the records' energy below which nothing is reported


@dataclass(frozen=True)
class WeightedResiduals:
    """Weighted residuals of all trials at the optimum, and their derivatives by all fitted values, one column each.

    ``readings`` contains, for each channel in each trial, its rows, weight, simulated reading and sample rate (Hz), and
    whether its offset is free.
    """

    vector: Array
    jacobian: Array
    readings: Mapping[str, Sequence[tuple[slice, float, Array, float, bool]]]
    energy: float

    @property
    def size(self) -> float:
        """Sum of squares of the residuals."""
        return float(self.vector @ self.vector)

    def rate_of(self, channel: str) -> float:
        """Return the lowest sample rate of a channel, Hz."""
        return min(reading[3] for reading in self.readings[channel])

    def explained_by(self, slope: Array) -> tuple[float, float]:
        """Return the value of a further unknown, and the share of the residual that it would explain (1).

        ``slope`` is the derivative of the residuals by this unknown.
        """
        if self.size < _MATTERS * self.energy:
            return 0.0, 0.0
        beside, left = (
            column - self.fitted_space @ (self.fitted_space.T @ column)
            for column in (slope, self.vector)
        )
        length, pull = float(beside @ beside), float(beside @ left)
        if length <= 0.0:
            return 0.0, 0.0
        return -pull / length, 1.0 - (float(left @ left) - pull**2 / length) / self.size

    @cached_property
    def fitted_space(self) -> Array:
        """Orthonormal basis of the residual changes that the fitted values can produce."""
        directions, sizes, _ = np.linalg.svd(self.jacobian, full_matrices=False)
        return np.asarray(directions[:, sizes > _SEEN * sizes.max(initial=0.0)])

    def after(self, changes: Sequence[tuple[slice, Array, Array]] = ()) -> float:
        """Return the sum of squares after one step of the fitted values, with some rows of the problem replaced."""
        gram, pull, size = self._products
        gram, pull = gram.copy(), pull.copy()
        for rows, vector, jacobian in changes:
            touched = np.flatnonzero(self.jacobian[rows].any(axis=0))
            old, both = self.jacobian[rows][:, touched], np.ix_(touched, touched)
            gram[both] += jacobian.T @ jacobian - old.T @ old
            pull[touched] += jacobian.T @ vector - old.T @ self.vector[rows]
            size += float(vector @ vector) - float(self.vector[rows] @ self.vector[rows])
        return size - float(pull @ np.linalg.pinv(gram, rcond=1e-12, hermitian=True) @ pull)

    @cached_property
    def _products(self) -> tuple[Array, Array, float]:
        return self.jacobian.T @ self.jacobian, self.jacobian.T @ self.vector, self.size


def low_pass_in(rest: WeightedResiduals, channel: str) -> tuple[float, Finding] | None:
    """Find a low-pass corner (Hz) that would explain most of a channel's residual, and more than a delay."""
    if rest.size < _MATTERS * rest.energy:
        return None
    rate = rest.rate_of(channel)
    corner, after = _best_corner(
        rest, channel, "low_pass", np.geomspace(0.01 * rate, 0.4 * rate, _CORNERS)
    )
    share = 1.0 - after / rest.size
    late = {
        delay: _residual_after_delay(rest, channel, delay)
        for delay in np.linspace(0.0, 20.0, 11) / rate
    }
    delay = min(late, key=lambda candidate: late[candidate])
    if share < _EXPLAINS or late[delay] < ALIKE * after:
        return None
    code = (
        "identify.behind_low_pass"
        if after < ALIKE * late[delay]
        else "identify.behind_low_pass_or_late"
    )
    numbers = {"share": share, "delay": delay, "low": 0.5 * corner, "high": 2.0 * corner}
    return share, finding(
        code, channel, corner, corner=corner, name=f"{channel}{LOW_PASS}", **numbers
    )


def high_pass_in(rest: WeightedResiduals, channel: str) -> tuple[float, Finding] | None:
    """Find a high-pass corner (Hz) that would explain most of a channel's residual."""
    if rest.size < _MATTERS * rest.energy:
        return None
    corner, after = _best_corner(rest, channel, "high_pass", np.geomspace(*_COUPLED, _CORNERS))
    share = 1.0 - after / rest.size
    if share < _EXPLAINS:
        return None
    return share, finding("identify.behind_high_pass", channel, corner, corner=corner, share=share)


def _best_corner(
    rest: WeightedResiduals, channel: str, kind: str, corners: Array
) -> tuple[float, float]:
    """Return the corner (Hz) of a filter of this kind with the smallest residual, and that residual."""

    def residual_with(corner: float) -> float:
        sensor = Sensor.model_validate({kind: float(corner)})
        return _residual_after_change(
            rest, [channel], lambda table, rate: filter_signals(table, rate, sensor)
        )

    misfits = {float(corner): residual_with(corner) for corner in corners}
    best = min(misfits, key=lambda candidate: misfits[candidate])
    near = best * np.geomspace(0.75, 1.33, 7)
    misfits |= {
        float(corner): residual_with(corner)
        for corner in near
        if corner < FASTEST * rest.rate_of(channel)
    }
    best = min(misfits, key=lambda candidate: misfits[candidate])
    return best, misfits[best]


def late_share(rest: WeightedResiduals) -> float:
    """Return the share of the residual explained by a common delay of all records; other causes must explain more."""
    rate = min(reading[3] for channel in rest.readings.values() for reading in channel)

    def residual_with(samples: float) -> float:
        return _residual_after_change(
            rest,
            rest.readings,
            lambda table, rate_of: shift_signals(table, rate_of, samples / rate),
        )

    coarse = {float(samples): residual_with(float(samples)) for samples in range(-10, 21, 2)}
    best = min(coarse, key=lambda samples: coarse[samples])
    near = [residual_with(best + part) for part in (-1.5, -1.0, -0.5, 0.5, 1.0, 1.5)]
    return 1.0 - min(coarse[best], *near) / rest.size


def _residual_after_change(rest: WeightedResiduals, channels: Iterable[str], change: Any) -> float:
    """Return the residual if a linear map changes the readings of channels, after a step of the fitted values."""
    changes = []
    for rows, weight, reading, rate, is_free in (
        entry for channel in channels for entry in rest.readings[channel]
    ):
        own = rest.jacobian[rows]
        both = change(np.column_stack([reading, own[:, own.any(axis=0)]]), rate)
        moved = weight * (reading - both[:, 0])
        changes.append(
            (rows, rest.vector[rows] + moved - (moved.mean() if is_free else 0.0), both[:, 1:])
        )
    return rest.after(changes)


def _residual_after_delay(rest: WeightedResiduals, channel: str, delay: float) -> float:
    return _residual_after_change(
        rest, [channel], lambda table, rate: shift_signals(table, rate, delay)
    )


def speed_in(rest: WeightedResiduals, slope: Array) -> tuple[float, Finding] | None:
    """Find a speed error that would explain most of the residual; ``slope`` is the derivative by the log speed."""
    error, share = rest.explained_by(slope)
    if share < _EXPLAINS or abs(error) < _SLIGHT:
        return None
    return share, finding("identify.speed_off", SPEED, error, excess=error, share=share)


def start_in(rest: WeightedResiduals, slopes: Array) -> tuple[float, Finding] | None:
    """Test whether records that begin in motion would explain most of the residual.

    ``slopes`` are derivatives by the start amplitude of each natural vibration of each trial (m).
    """
    if not slopes.size or rest.size < _MATTERS * rest.energy:
        return None
    beside, left = (
        column - rest.fitted_space @ (rest.fitted_space.T @ column)
        for column in (slopes, rest.vector)
    )
    amplitudes = np.linalg.lstsq(beside, -left, rcond=_SEEN)[0]
    after = left + beside @ amplitudes
    share = 1.0 - float(after @ after) / rest.size
    if share < _EXPLAINS_FREELY:
        return None
    largest = float(np.max(np.abs(amplitudes)))
    return share, finding(
        "identify.begins_in_motion",
        START,
        largest,
        size=largest,
        wide=math.ceil(4e3 * largest),
        share=share,
    )


def _start_slopes(problem: UpdateProblem, scaled: Array) -> Array:
    """Return derivatives of the residuals by the start amplitudes of the trials' vibrations, one column each."""
    columns = []
    for trial in problem.trials:
        source = trial.source
        if not begins_unknown(source) or source.offset:
            continue
        for motion in start_motions(source):
            for shape in (motion.displaced, motion.moving):

                def begun(
                    trial: FitTrial, size: float, name: str = source.name, shape: Any = shape
                ) -> FitTrial | None:
                    return (
                        trial.in_motion({state: size * v for state, v in shape.items()})
                        if trial.name == name
                        else None
                    )

                columns.append(problem.slope(scaled, begun, _SHIFTED))
    return np.column_stack(columns) if columns else np.zeros((0, 0))


_SHIFTED = 1e-5
"""Amplitude step (m) for start slopes: small compared with the motion, large compared with rounding."""
_EXPLAINS_FREELY = 0.6
"""Explained share of the residual above which a start in motion is reported: it has four amplitudes per trial, so the
limit is higher than for a single unknown of all trials (`_EXPLAINS`)."""


def road_in(
    rest: WeightedResiduals, channel: str, roads: Sequence[tuple[slice, Array]]
) -> tuple[float, Finding] | None:
    """Test whether a channel is measured from the road, not the ground; ``roads`` are heights (m) in its rows."""
    best, at = (0.0, 0.0), 0.0
    rate = rest.rate_of(channel)
    weights = [entry[1] for entry in rest.readings[channel]]
    for ahead in np.arange(-_AHEAD, 1.01 * _AHEAD, _AHEAD_STEP):
        slope = np.zeros_like(rest.vector)
        for (rows, height), weight in zip(roads, weights, strict=True):
            slope[rows] = weight * shift_signals(height[:, None], rate, -ahead)[:, 0]
        explained = rest.explained_by(slope)
        if explained[1] > best[1]:
            best, at = explained, float(ahead)
    times, share = best
    if share < _EXPLAINS or not _WHOLE[0] < times < _WHOLE[1]:
        return None
    code = "identify.road_ahead" if at > 0.0 else "identify.road_behind"
    if abs(at) < _AHEAD_STEP:
        code = "identify.road_below"
    return share, finding(code, channel, times, ahead=abs(at), share=share)


def suspects(
    problem: UpdateProblem, residuals: Residuals, scaled: Array, whole: Array, loud: Sequence[str]
) -> list[tuple[float, Finding]]:
    """Report faults of sensors and trials that explain most of the residual, with their share.

    ``loud`` are the channels with residuals above their noise: without one there is nothing to explain.
    """
    if not loud:
        return []
    readings = dict[str, list[tuple[slice, float, Array, float, bool]]]()
    both = [(trial, channel) for trial in problem.trials for channel in trial.channels]
    for (trial, channel), block in zip(both, residuals.blocks, strict=True):
        if channel.weight > 0.0:
            read = channel.measured - residuals.vector[block] / channel.weight
            entry = (block, channel.weight, read, trial.rate, channel.datum == "free offset")
            readings.setdefault(channel.name, []).append(entry)
    rest = WeightedResiduals(residuals.vector, whole, readings, problem.data_energy)
    freed = {entry.name for entry in problem.nuisances}
    passes = [(channel.name, channel.sensor) for _, channel in both if channel.sensor is not None]
    low = {name for name, sensor in passes if sensor.low_pass is not None} | {
        f.removesuffix(LOW_PASS) for f in freed
    }
    high = {name for name, sensor in passes if sensor.high_pass is not None}
    causes = [low_pass_in(rest, name) for name in loud if name not in low]
    causes += [high_pass_in(rest, name) for name in loud if name not in high]
    trials = [trial.source.trial for trial in problem.trials]
    if SPEED not in freed and all(trial.speed is not None for trial in trials):
        causes.append(speed_in(rest, problem.speed_slope(scaled)))
    if not any(START in name for name in freed):
        causes.append(start_in(rest, _start_slopes(problem, scaled)))
    if all(trial.road is not None for trial in trials):
        causes += [
            road_in(rest, name, _roads(problem, residuals, name))
            for name in loud
            if name.endswith(HEIGHT)
        ]
    likely = sorted((entry for entry in causes if entry is not None), key=lambda entry: -entry[0])
    if likely and not problem.align:
        late = late_share(rest)
        likely = [entry for entry in likely if 1.0 - entry[0] < ALIKE * (1.0 - late)]
    return [entry for entry in likely if entry[0] > likely[0][0] - _AS_LIKELY]


def _roads(problem: UpdateProblem, residuals: Residuals, channel: str) -> list[tuple[slice, Array]]:
    """Return the rows of a channel and the height of the road (m) there, for each trial."""
    both = [(trial, recorded) for trial in problem.trials for recorded in trial.channels]
    heights = []
    for (trial, recorded), rows in zip(both, residuals.blocks, strict=True):
        if recorded.name == channel:
            lag = residuals.lags[problem.trials.index(trial)]
            height = shift_signals(trial.road(recorded)[:, None], trial.rate, lag)[:, 0]
            heights.append(
                (rows, height - (height.mean() if recorded.datum == "free offset" else 0.0))
            )
    return heights


HEIGHT = ".z"
"""Suffix of channels that are measured from the ground."""
_AS_LIKELY = 0.1  # share of the residual by which a reported fault may explain less than the best
CLEARLY = 0.6  # share of the residual above which a fault makes the other channels irrelevant
