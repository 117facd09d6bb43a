"""Residuals of several trials as functions of scaled free parameters, with exact sensitivities.

The scaling is ``p_i = p_i0 + half_range_i * s_i`` with ``s_i`` from -1 to +1 between the bounds, as in paper 1 for its
+-10 % bounds. The objective of its Eq. 2 is the plain sum of squares over all channels and samples.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Protocol

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError, FitError, SimulationError, unknown
from jounce.core.phrases import Phrase
from jounce.core.segments import Segments
from jounce.core.shown import Shown
from jounce.core.text import place_in
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.core.waiting import report_progress
from jounce.identify.lags import Shifted, best_lag
from jounce.identify.settings import UpdateSettings
from jounce.kernel.engine import Status
from jounce.mechanics.facts import is_road
from jounce.parts import Rig
from jounce.parts.rig import check_rig, unit_of, unknown_path
from jounce.recordings.carried import as_recording
from jounce.recordings.conditioning import cut_to_range
from jounce.recordings.quality import frozen_samples
from jounce.recordings.schema import check_recording
from jounce.recordings.sensors import Datum, Sensor, bias_of, filter_signals
from jounce.recordings.signals import shift_signals
from jounce.roads import Trial, as_trial
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.prepare import solve
from jounce.simulation.problem import excitation, force_actuator
from jounce.simulation.reduced import with_slopes
from jounce.simulation.result import Solution
from jounce.simulation.solve import start_offset

_FEWEST = 2  # samples of a recording
_FREE_LAG = 1.0 - 1e-9
"""Share of its bound from which a lag counts as held by the bound."""


@dataclass(frozen=True)
class FitTrial(Shown):
    """One trial to fit: its set-up and its recording.

    Attributes
    ----------
    name : str
        Name of the trial in results and messages.
    rig : Rig
        The rig as set up for this trial (strut angle, tyre pressure), with its start values.
    trial : Trial
        Road and speed, or base motion.
    measured : xarray.Dataset
        Recording; a table with columns ``name [unit]`` is converted. Every variable that is also an output of the model
        is compared.
    sensors : dict
        Mapping from channel to sensor, applied to the simulation before the comparison. If a sensor states no
        ``datum``, or a channel has no sensor, :func:`jounce.identify.datum.with_datums` determines it; until then it is
        "undeformed".
    added : dict
        Mapping from path to an addition to the rig in this trial only (SI), such as a known mass. ``rig`` includes it;
        fitted values exclude it.
    wheel_load : float or None
        Measured static force of the wheel on the ground, including ``added``, N; for rigs with one wheel. It determines
        the scale of the masses for intervals that include model error.
    offset : dict
        Mapping from state to its initial distance from equilibrium (SI), as for :func:`jounce.simulate`; by default the
        run starts at rest.
    noise : dict
        Mapping from channel to the standard deviation of its noise (SI), if known from the scatter of repeated
        passages. For other channels the noise is estimated from the residuals at high frequencies.
    """

    name: str
    rig: Rig
    trial: Trial
    measured: xr.Dataset
    sensors: Mapping[str, Sensor] = field(default_factory=dict)
    added: Mapping[str, float] = field(default_factory=dict)
    wheel_load: float | None = None
    offset: Mapping[str, float] = field(default_factory=dict)
    noise: Mapping[str, float] = field(default_factory=dict)

    @property
    def rig_without(self) -> Rig:
        """Return the rig without the additions of this trial."""
        values = self.rig.parameters()
        return self.rig.with_changes(
            {path: values[path] - more for path, more in self.added.items()}
        )

    def in_motion(self, offset: Mapping[str, float]) -> FitTrial:
        """Return the trial started away from equilibrium (SI by state), in which no sensor begins at its zero."""
        sensors = dict(self.sensors)
        for name in map(str, self.measured.data_vars):
            sensor = sensors.get(name, Sensor())
            if sensor.datum in (None, "rest"):
                sensors[name] = sensor.with_fields(datum="free offset")
        return replace(self, offset=offset, sensors=sensors)

    def __post_init__(self) -> None:
        check_rig(self.rig)
        for name, value in (
            ("trial", as_trial(self.trial)),
            ("measured", as_recording(self.measured, where=f"{self.name}: measured")),
        ):
            object.__setattr__(self, name, value)


@dataclass(frozen=True)
class FreeParameter:
    """One free parameter: its path, start value and bounds, SI."""

    path: str
    initial: float
    lower: float
    upper: float

    @property
    def half_range(self) -> float:
        """Value of one scaled unit, SI."""
        return 0.5 * (self.upper - self.lower)

    def value(self, scaled: float) -> float:
        """Return the value at a scaled coordinate."""
        return 0.5 * (self.upper + self.lower) + self.half_range * scaled

    def scale(self, value: float) -> float:
        """Return the scaled coordinate of a value."""
        return (value - 0.5 * (self.upper + self.lower)) / self.half_range


class Unknown(Protocol):
    """An unknown of trials and sensors, in addition to the rig's parameters."""

    @property
    def name(self) -> str:
        """Key of the unknown in results."""
        ...

    @property
    def free(self) -> FreeParameter:
        """Start value and bounds of the unknown."""
        ...

    def concerns(self, trial: FitTrial) -> bool:
        """Whether it affects a trial."""
        ...

    def apply_to(self, trial: FitTrial, value: float) -> FitTrial:
        """Return the trial with this value of the unknown."""
        ...


@dataclass(frozen=True)
class Channel:
    """One compared channel of one trial, ready for evaluation.

    ``frozen`` marks stuck samples without information (see `frozen_samples`), which ``measured`` bridges by a line.
    ``noise`` is the standard deviation of the channel's noise if it is known.
    """

    name: str
    column: int
    measured: Array
    sensor: Sensor | None
    bias: float
    weight: float
    datum: Datum = "undeformed"
    frozen: NDArray[np.bool_] | None = None
    noise: float | None = None

    def offset(self, table: Array, slope: Array) -> tuple[Array, Array]:
        """Return table and lag derivative with a free offset eliminated as the best constant, as if it were fitted.

        Frozen samples of the table equal the record, so their residual is zero for all parameters.
        """
        if self.datum == "free offset":
            seen = slice(None) if self.frozen is None else ~self.frozen
            table = table - table[seen].mean(axis=0)
            table[:, 0] += self.measured[seen].mean()
            slope = slope - slope[seen if len(slope) > 1 else slice(None)].mean()
        if self.frozen is not None:
            table, slope = table.copy(), self.mask_frozen(slope)
            table[self.frozen] = 0.0
            table[self.frozen, 0] = self.measured[self.frozen]
        return table, slope

    def mask_frozen(self, slope: Array) -> Array:
        """Return a slope of the reading, set to 0 where the record is frozen."""
        return slope if self.frozen is None else np.where(self.frozen, 0.0, slope)


@dataclass(frozen=True)
class Prepared:
    """One trial with its compiled model, output times and channels."""

    source: FitTrial
    compiled: Compiled
    times: Array
    uniform: int
    rate: float
    channels: tuple[Channel, ...]
    start: Array
    factors: Array
    offsets: Array

    def own(self, values: Array) -> Array:
        """Convert values of the first trial, without additions, to values of this trial."""
        return values * self.factors + self.offsets

    def solve(self, values: Array, tolerance: float) -> Solution:
        """Simulate with the free parameters at ``values`` (SI, of the first trial)."""
        p, names, free = self.start.copy(), self.compiled.facts.parameters, self.compiled.free
        if free:
            p[[names.index(path) for path in free]] = self.own(values)
        rig, trial = self.source.rig, self.source.trial
        signals, numbers = self.tracks(), dict(zip(names, p.tolist(), strict=True))
        offset = start_offset(self.compiled, self.source.offset)
        solution = None
        if offset is None:  # reduced corners start at rest
            solution = with_slopes(rig, trial, numbers, signals, self.times, tolerance, free)
        if solution is None:
            solution = solve(
                self.compiled, p, signals, self.times, tolerance=tolerance, offset=offset
            )
        if solution.status is not Status.COMPLETED:
            raise SimulationError(
                "the simulation diverged", where=self.source.name, found=solution.status.help
            )
        return solution

    def tracks(self) -> list[Segments]:
        """Return the inputs of the model against time (s)."""
        return excitation(
            self.compiled.facts, self.source.rig, self.source.trial, self.compiled.free
        )

    def road(self, channel: Channel) -> Array:
        """Return the height of the road (m) below the first wheel at the instants of a channel."""
        first = next(i for i, name in enumerate(self.compiled.facts.tracks) if is_road(name))
        return np.asarray(
            self.tracks()[first].evaluate(self.times)[0][len(self.times) - len(channel.measured) :]
        )

    def table(self, channel: Channel, solution: Solution) -> Array:
        """Return the simulated reading of a channel and its derivatives by the free parameters, one row per sample."""
        table = np.vstack(
            [solution.outputs[channel.column], *solution.output_slopes[channel.column]]
        ).T
        if channel.datum == "rest":
            table = table - table[0]  # the run starts at rest
        table = table[len(self.times) - self.uniform :]
        if channel.sensor is not None:
            table = filter_signals(table, self.rate, channel.sensor, where=channel.name)
        table = table[len(table) - len(channel.measured) :]
        table[:, 0] += channel.bias
        return (
            table if channel.sensor is None else cut_to_range(channel.name, channel.sensor, table)
        )


@dataclass(frozen=True)
class Residuals:
    """Residuals (weighted, measured minus simulated) and their derivatives by the scaled parameters.

    ``direct`` are the derivatives at constant lags, shape (n, parameters); ``lag_slope`` is the derivative by the lag
    of the row's trial, per s, zero for a lag that is not free. ``blocks`` are the rows of each channel of each trial,
    ``groups`` those of each trial, ``lags`` the lag of each recording behind its simulation, s.
    """

    vector: Array
    direct: Array
    lag_slope: Array
    blocks: tuple[slice, ...]
    groups: tuple[slice, ...]
    lags: Array

    @cached_property
    def jacobian(self) -> Array:
        """Derivatives for least squares with fitted lags, without the part that a lag explains.

        The lags are the best ones for the current parameters (variable projection, Kaufman's form).
        """
        jacobian = self.direct.copy()
        for rows in self.groups:
            project_out(jacobian[rows], self.lag_slope[rows])
        return jacobian

    def with_lags(self, unit: float) -> Array:
        """Return derivatives by the parameters, then by the lag of each trial, in units of ``unit`` (s)."""
        lags = np.zeros((len(self.vector), len(self.groups)))
        for i, rows in enumerate(self.groups):
            lags[rows, i] = unit * self.lag_slope[rows]
        return np.hstack([self.direct, lags])


_ASIDE = 1e-3  # of half the range: step to either side for derivatives by nuisances


def project_out(columns: Array, direction: Array) -> None:
    """Remove from each column, in place, the part that one direction explains."""
    length = float(direction @ direction)
    if length > 0.0:
        columns -= np.outer(direction / length, direction @ columns)


class UpdateProblem:
    """Residuals and exact Jacobian of all trials as functions of the scaled parameters.

    With ``align`` each recording lags behind its simulation by the best-fitting lag. This needs no further simulation,
    so the lags are not unknowns of the search.
    """

    def __init__(
        self,
        trials: Sequence[FitTrial],
        free: Sequence[FreeParameter],
        settings: UpdateSettings,
        nuisances: Sequence[Unknown] = (),
    ) -> None:
        self.free, self.settings, self.nuisances = tuple(free), settings, tuple(nuisances)
        self.tolerance, self.align, self.lag_bound = (
            settings.tolerance,
            settings.fits_lags,
            settings.lag_bound,
        )
        self.trials = tuple(prepare_trial(trial, self.free, settings) for trial in trials)
        self.evaluations = 0
        count = sum(len(c.measured) for trial in self.trials for c in trial.channels)
        unknowns = self.size + (len(self.trials) if self.align else 0)
        if count < unknowns:
            raise FitError(
                "fewer data than parameters",
                found=f"{count} samples",
                allowed=Phrase("at least {unknowns}", unknowns=unknowns),
                hint="Give longer recordings or free fewer parameters.",
            )
        self._last: tuple[bytes, Residuals] | None = None

    def coarser(self, tolerance: float) -> UpdateProblem:
        """Return the same problem with coarser simulations and a separate evaluation count."""
        problem = copy(self)
        problem.tolerance, problem.evaluations, problem._last = (
            max(tolerance, self.tolerance),
            0,
            None,
        )
        return problem

    @property
    def size(self) -> int:
        """Number of unknowns of the search: the free parameters, then the nuisances."""
        return len(self.free) + len(self.nuisances)

    @property
    def data_energy(self) -> float:
        """Weighted sum of squares of the measured signals."""
        return sum(
            float(np.sum((c.weight * c.measured) ** 2))
            for trial in self.trials
            for c in trial.channels
        )

    def values(self, scaled: Array) -> Array:
        """Return parameter values (SI) at scaled coordinates, without those of the nuisances that follow them."""
        return np.array(
            [free.value(s) for free, s in zip(self.free, scaled[: len(self.free)], strict=True)]
        )

    def residuals(self, scaled: Array) -> Residuals:
        """Evaluate residuals and Jacobian with respect to the scaled unknowns."""
        key = np.asarray(scaled).tobytes()
        if self._last is None or self._last[0] != key:
            self._last = (key, self._evaluate(np.asarray(scaled, dtype=float)))
            self.evaluations += 1
            report_progress(self._step)
        return self._last[1]

    def _step(self) -> dict[str, Any]:
        """Return the last evaluation for progress reports: objective, and parameters with their bounds (SI)."""
        assert self._last is not None
        key, residuals = self._last
        values = self.values(np.frombuffer(key))
        return {
            "evaluation": self.evaluations,
            "objective": float(residuals.vector @ residuals.vector),
            "parameters": {
                parameter.path: {
                    "value": float(value),
                    "initial": parameter.initial,
                    "lower": parameter.lower,
                    "upper": parameter.upper,
                }
                for parameter, value in zip(self.free, values, strict=True)
            },
        }

    def objective(self, scaled: Array) -> tuple[float, Array]:
        """Return the sum of squared residuals (Eq. 2 when unweighted) and its gradient."""
        r = self.residuals(scaled)
        return float(r.vector @ r.vector), 2.0 * (r.jacobian.T @ r.vector)

    def _evaluate(self, scaled: Array) -> Residuals:
        values = self.values(scaled)
        vectors, jacobians, slopes, blocks, groups, lags, at = [], [], [], [], [], [], 0
        for trial in self.trials:
            scales = np.array(
                [f.half_range * factor for f, factor in zip(self.free, trial.factors, strict=True)]
            )
            tables = self._tables(trial, values, scaled[len(self.free) :])
            scales = np.concatenate([scales, np.ones(len(self.nuisances))])
            lag, aligned = self._align(trial, tables)
            begin = at
            for channel, (table, slope) in zip(trial.channels, aligned, strict=True):
                vectors.append(channel.weight * (channel.measured - table[:, 0]))
                jacobians.append(-channel.weight * scales * table[:, 1:])
                slopes.append(-channel.weight * slope)
                blocks.append(slice(at, at + len(table)))
                at += len(table)
            groups.append(slice(begin, at))
            lags.append(lag)
        return Residuals(
            np.concatenate(vectors),
            np.vstack(jacobians),
            np.concatenate(slopes),
            tuple(blocks),
            tuple(groups),
            np.array(lags),
        )

    def speed_slope(self, scaled: Array) -> Array:
        """Return the derivative of the residuals by the logarithm of the speed of all trials, at constant lags."""
        return self.slope(
            scaled,
            lambda trial, more: replace(trial, trial=trial.trial.at_speed(1.0 + more)),
            _ASIDE,
        )

    def slope(
        self, scaled: Array, change: Callable[[FitTrial, float], FitTrial | None], step: float
    ) -> Array:
        """Return the derivative of the residuals by a change of the trials, at constant lags.

        ``change`` returns a trial changed by an amount (plus or minus ``step``), or None if the trial is not affected.
        """
        values, lags, columns = self.values(scaled), self.residuals(scaled).lags, list[Array]()
        for trial, lag in zip(self.trials, lags, strict=True):
            source, sides = trial.source, []
            if change(source, step) is None:
                columns += [np.zeros(len(channel.measured)) for channel in trial.channels]
                continue
            for nuisance, place in zip(self.nuisances, scaled[len(self.free) :], strict=True):
                source = nuisance.apply_to(source, nuisance.free.value(place))
            for more in (step, -step):
                moved = replace(trial, source=change(source, more) or source)
                solution = moved.solve(values, self.tolerance)
                tables = [moved.table(channel, solution)[:, :1] for channel in trial.channels]
                sides.append([shift_signals(table, trial.rate, lag)[:, 0] for table in tables])
            for channel, above, below in zip(trial.channels, *sides, strict=True):
                slope = (above - below) / (2.0 * step)
                slope = slope - (slope.mean() if channel.datum == "free offset" else 0.0)
                columns.append(-channel.weight * channel.mask_frozen(slope))
        return np.concatenate(columns)

    def _tables(self, trial: Prepared, values: Array, scaled: Array) -> list[Array]:
        """Return readings of the channels with their derivatives by the parameters and by the scaled nuisances."""
        solutions: dict[tuple[float | None, ...], Solution] = {}

        def tables(at: Array) -> list[Array]:
            source = trial.source
            for nuisance, place in zip(self.nuisances, at, strict=True):
                source = nuisance.apply_to(source, nuisance.free.value(place))
            channels = [
                replace(channel, sensor=source.sensors.get(channel.name))
                for channel in trial.channels
            ]
            moved = replace(trial, source=source) if self.nuisances else trial
            run = (source.trial.speed, *source.offset.values())
            if run not in solutions:
                solutions[run] = moved.solve(values, self.tolerance)
            return [moved.table(channel, solutions[run]) for channel in channels]

        readings = tables(scaled)
        for nuisance, aside in zip(
            self.nuisances, _ASIDE * np.eye(len(self.nuisances)), strict=True
        ):
            if nuisance.concerns(trial.source):
                above, below = tables(scaled + aside), tables(scaled - aside)
                slopes = [
                    (high[:, :1] - low[:, :1]) / (2.0 * _ASIDE)
                    for high, low in zip(above, below, strict=True)
                ]
            else:
                slopes = [np.zeros((len(table), 1)) for table in readings]
            readings = [
                np.hstack([table, slope]) for table, slope in zip(readings, slopes, strict=True)
            ]
        return readings

    def _align(
        self, trial: Prepared, tables: list[Array]
    ) -> tuple[float, list[tuple[Array, Array]]]:
        """Return the lag of a trial's recording, and each channel's table there with the lag derivative (0 if held)."""
        both = list(zip(trial.channels, tables, strict=True))
        if not self.align:
            return 0.0, [channel.offset(table, np.zeros(len(table))) for channel, table in both]
        shifted = [
            Shifted.of(
                channel.measured,
                table,
                channel.weight,
                trial.rate,
                offset=channel.datum == "free offset",
            )
            for channel, table in both
        ]
        lag = best_lag(shifted, self.lag_bound)
        free = float(abs(lag) < self.lag_bound * _FREE_LAG)
        aligned = zip(trial.channels, (signal.at(lag) for signal in shifted), strict=True)
        return lag, [channel.offset(table, free * slope) for channel, (table, slope) in aligned]


def readings(
    trial: FitTrial, *, lag: float = 0.0, tolerance: float = 1e-6
) -> dict[str, tuple[Array, Array, Array]]:
    """Simulate a trial with its rig's own values and read it through its sensors.

    Returns a mapping from channel to (time in s, measured, simulated), in the channel's SI unit. ``lag`` (s) is the lag
    of the recording behind the simulation.
    """
    return Simulated(trial, tolerance).readings(lag)


class Simulated:
    """A trial simulated once with its rig's own values: sensor readings, and all outputs of the model."""

    def __init__(self, trial: FitTrial, tolerance: float = 1e-6) -> None:
        self.trial = trial
        self.prepared = prepare_trial(trial, (), UpdateSettings())
        self.solution = self.prepared.solve(np.zeros(0), tolerance)

    def readings(self, lag: float = 0.0) -> dict[str, tuple[Array, Array, Array]]:
        """Return channel to (time in s, measured, simulated), SI; the recording lags by ``lag`` (s)."""
        prepared = self.prepared
        time = self.trial.measured["time"].to_numpy()
        signals = {}
        for channel in prepared.channels:
            shifted = shift_signals(prepared.table(channel, self.solution), prepared.rate, lag)
            signals[channel.name] = (
                time,
                channel.measured,
                channel.offset(shifted, np.zeros(len(shifted)))[0][:, 0],
            )
        return signals

    def outputs(self, lag: float = 0.0) -> dict[str, Array]:
        """Return all outputs of the model (SI) at the recording's instants, without sensors, delayed by ``lag`` (s).

        Outputs are interpolated linearly: a spectral shift would make the force of a lifted tyre oscillate below zero.
        """
        times = self.prepared.times
        at = times[-len(self.trial.measured["time"]) :] - lag
        names = self.prepared.compiled.output_names
        return {
            name: np.interp(at, times, output)
            for name, output in zip(names, self.solution.outputs, strict=True)
        }


def prepare_trial(
    trial: FitTrial, free: Sequence[FreeParameter], settings: UpdateSettings
) -> Prepared:
    """Compile a trial's model with the free parameters and prepare its channels; raise errors for incomparable ones."""
    paths = tuple(item.path for item in free)
    compiled = compile_rig(trial.rig, paths, actuator=force_actuator(trial.trial))
    names, weights = settings.channels, settings.weights
    _check_channels(compiled.output_names, names, weights)
    given = (
        ("command", "actuator.force") if trial.trial.actuator_force is not None else ()
    )  # inputs, not answers
    common = [
        name
        for name in compiled.output_names
        if name in trial.measured and name not in given and (names is None or name in names)
    ]
    if not common:
        raise FitError(
            "the recording contains no channel of the model",
            where=trial.name,
            found=", ".join(str(name) for name in trial.measured.data_vars),
            allowed=", ".join(compiled.output_names),
            hint='Map the columns, e.g. columns = {"sprung.az" = "acc1 [g]"}.',
        )
    check_recording(trial.measured[common], where=trial.name)
    values = trial.rig.parameters()
    time = trial.measured["time"].to_numpy()
    if len(time) < _FEWEST:
        raise FitError(
            "too few samples",
            where=trial.name,
            found=len(time),
            allowed=Phrase("at least {fewest}", fewest=_FEWEST),
        )
    rate = 1.0 / float(np.median(np.diff(time)))
    times, uniform = _from_rest(time, rate)
    if time[-1] < trial.trial.obstacle_end():
        raise FitError(
            "the recording ends before the obstacle pass does",
            where=trial.name,
            found=f"{time[-1]:.4g} s",
            allowed=Phrase(
                "at least {obstacle_end:.4g} s", obstacle_end=trial.trial.obstacle_end()
            ),
            hint="Check speed and start, or record longer.",
        )
    channels = [_channel(trial, compiled, name, weights) for name in common]
    if not any(channel.weight > 0.0 for channel in channels):
        raise FitError(
            "no channel of the recording has a weight",
            where=trial.name,
            found=", ".join(common),
            hint="Give one of them a weight above 0, or leave the trial out.",
        )
    offsets = np.array([trial.added.get(item.path, 0.0) for item in free])
    plain = np.array([values[item.path] for item in free]) - offsets
    factors = np.array(
        [
            value / item.initial if item.initial else 1.0
            for value, item in zip(plain, free, strict=True)
        ]
    )
    return Prepared(
        trial,
        compiled,
        times,
        uniform,
        rate,
        tuple(channels),
        compiled.parameter_values(values),
        factors,
        offsets,
    )


def _check_channels(
    known: Sequence[str], names: Sequence[str] | None, weights: str | Mapping[str, float]
) -> None:
    """Raise an error for channels that the model does not have and for invalid weights."""
    given = {} if isinstance(weights, str) else weights
    for what, chosen in (("channels", names or ()), ("weights", given)):
        for name in chosen:
            if name not in known:
                raise unknown(name, known, what="channel", where=what)
    for name, weight in given.items():
        if not (np.isfinite(weight) and weight >= 0.0):
            raise FitError(
                "invalid weight", where=f"weights: {name}", found=weight, allowed="0 or more"
            )


def _from_rest(time: Array, rate: float) -> tuple[Array, int]:
    """Return output times from 0 on, and the number of final ones at the recording's rate (which sensors filter)."""
    if time[0] <= 0.0:
        return time, len(time)
    before = time[0] - np.arange(int(time[0] * rate + 1e-6), 0, -1) / rate
    uniform = np.concatenate([np.maximum(before, 0.0), time])
    return (uniform if uniform[0] == 0.0 else np.concatenate([[0.0], uniform])), len(uniform)


def _channel(
    trial: FitTrial, compiled: Compiled, name: str, weights: str | Mapping[str, float]
) -> Channel:
    column, sensor = compiled.output_names.index(name), trial.sensors.get(name)
    measured = np.asarray(trial.measured[name].to_numpy(), dtype=float)
    frozen = frozen_samples(measured)
    if frozen.any():
        at = np.arange(len(measured))
        measured = np.interp(at, at[~frozen], measured[~frozen])
    bias = (
        0.0 if sensor is None else bias_of(sensor, compiled.facts.outputs[column].unit, where=name)
    )
    datum = (sensor and sensor.datum) or "undeformed"
    weight = _weight(weights, name, measured)
    held = frozen if frozen.any() else None
    return Channel(name, column, measured, sensor, bias, weight, datum, held, trial.noise.get(name))


def _weight(weights: str | Mapping[str, float], name: str, measured: Array) -> float:
    """Return the weight of a channel's residuals: 1 (Eq. 2 as printed), 1 over r.m.s. and root length, or as given."""
    if weights == "printed":
        return 1.0
    if weights == "normalised":
        spread = float(np.std(measured))
        if spread == 0.0:
            raise FitError(
                "the channel is constant and cannot be normalised", where=name, hint="Leave it out."
            )
        return float(1.0 / (spread * np.sqrt(len(measured))))
    if isinstance(weights, str):
        raise FitError(
            "unknown weighting", found=weights, allowed="printed, normalised, or {channel: weight}"
        )
    return float(np.sqrt(weights.get(name, 0.0)))


# free parameters ------------------------------------------------------------------------------------------------------


Bounds = str | float | Sequence[str | float]


def free_parameters(
    rig: Rig, free: Mapping[str, Bounds], *, where: str = ""
) -> tuple[FreeParameter, ...]:
    """Read the free parameters and their bounds for a rig's values, SI; raise an error if bounds exclude the start."""
    check_free(rig, free, where=where)
    values = rig.parameters()
    parameters = []
    for path, bounds in free.items():
        initial, place = values[path], f"{where}: {path}"
        lower, upper = _range(bounds, initial, unit_of(rig, path), place)
        if not lower <= initial <= upper:
            raise FitError(
                "the bounds exclude the start value",
                where=place,
                found=f"{initial:g}",
                allowed=Phrase("{lower:g} to {upper:g}", lower=lower, upper=upper),
                hint="Move the bounds or the start value.",
            )
        parameters.append(FreeParameter(path, initial, lower, upper))
    return tuple(parameters)


def check_free(rig: Rig, free: Mapping[str, Bounds], *, where: str = "", more: int = 0) -> None:
    """Check that there are free parameters (``more`` are checked elsewhere), with known paths and valid bounds."""
    if not free and not more:
        raise FitError(
            "no free parameter",
            where=where,
            hint='Name at least one, e.g. free = {"strut.spring.rate" = "10 %"}.',
        )
    values = rig.parameters()
    for path, bounds in free.items():
        if path not in values:
            raise unknown_path(place_in(where, path), values, name=path)
        _range(bounds, values[path] or 1.0, unit_of(rig, path), place_in(where, path))


def _range(bounds: Bounds, initial: float, unit: str, place: str) -> tuple[float, float]:
    """Return the lower and upper bound in SI."""
    if not isinstance(bounds, str | int | float):
        return _absolute(bounds, unit, place)
    share = to_si(bounds, "1", where=place)
    if share <= 0.0:
        raise FitError(
            "the range must be above zero", where=place, found=bounds, allowed='e.g. "10 %"'
        )
    if initial == 0.0:
        raise FitError(
            "a relative range needs a nonzero start value",
            where=place,
            allowed="[lower, upper] with units",
        )
    lower, upper = sorted((initial * (1.0 - share), initial * (1.0 + share)))
    return lower, upper


def _absolute(bounds: object, unit: str, place: str) -> tuple[float, float]:
    if not isinstance(bounds, Sequence) or len(bounds) != 2:
        raise FitError(
            "invalid pair of bounds", where=place, found=bounds, allowed='"10 %" or [lower, upper]'
        )
    lower, upper = (to_si(value, unit, where=place) for value in bounds)
    if lower >= upper:
        raise DescriptionError(
            "the lower bound must be below the upper", where=place, found=list(bounds)
        )
    return lower, upper
