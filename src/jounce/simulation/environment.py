"""A suspension as a Gymnasium environment, for learning controllers (extra ``learn``)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from jounce.control.actuators import AnyActuator, SemiActiveDamper
from jounce.control.laws import Passive
from jounce.core.errors import DescriptionError, SimulationError, unknown, value_or_kind
from jounce.core.optional import require
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.text import qualify
from jounce.core.types import Array
from jounce.kernel.engine import Status
from jounce.kernel.methods.explicit import integrate
from jounce.parts import Rig
from jounce.roads import Trial
from jounce.simulation.compiled import compile_rig
from jounce.simulation.controlled import close_loop, command_names
from jounce.simulation.prepare import prepare, room
from jounce.simulation.problem import excitation

OBSERVED = ("sprung.az", "sprung.vz", "unsprung.vz", "strut.deflection", "strut.velocity")
"""Default observations of each corner, if the model has them."""
COST = {"sprung.az": 1.0, "strut.deflection": 4e3, "tyre.deflection": 4e4}
"""Default weights of mean squares (of changes from rest) in the cost, per squared unit of each channel."""
_SCALES = {"az": 2.0, "vz": 0.3, "velocity": 0.5, "deflection": 0.03, "force": 2000.0, "z": 0.05}
"""Typical sizes (SI) of a car's motion, which scale observations to about 1."""
_WIDEST = 10.0  # observations are clipped at this many typical sizes
_FINEST = 1e-3  # s between samples of the cost: ten per period at 100 Hz
_LOST = 1e3  # negative reward of a diverged run: more than the cost of any regular step


class Stepper:
    """A rig with actuators on a trial, run step by step: each ``step`` holds commands for one period.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : Trial
        Road, speed and duration.
    actuator : SemiActiveDamper, ActiveActuator or MagnetorheologicalDamper
        Actuator of every strut; missing numbers get defaults as for controllers.
    rate : float
        Steps per second, Hz.
    samples : int
        Outputs per step, evenly spaced, the last at its end.
    tolerance : float
        Relative error of the displacements.

    Notes
    -----
    ``corners`` and ``channels`` name commands and outputs, ``limits`` contains the minimum and maximum command of
    each corner, ``time`` (s) is the current time, ``status`` the outcome of the last step.

    Examples
    --------
    >>> from jounce.control import SemiActiveDamper
    >>> from jounce.parts import load
    >>> from jounce.roads import HalfSine
    >>> trial = Trial(road=HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.5 s")
    >>> run = Stepper(load("kart-quarter-car"), trial, SemiActiveDamper(), rate=100.0)
    >>> first = run.start()
    >>> outputs = run.step(run.limits[:, 1])   # firm
    >>> outputs.shape == (len(run.channels), 1), round(run.time, 6)
    (True, 0.01)
    """

    def __init__(
        self,
        rig: Rig,
        trial: Trial,
        actuator: AnyActuator,
        rate: float,
        *,
        samples: int = 1,
        tolerance: float = 1e-5,
    ) -> None:
        if not (np.isfinite(rate) and rate > 0.0):
            raise SimulationError("invalid rate", where="rate", found=rate, allowed="above 0 Hz")
        loop = close_loop(rig, Passive(damping_coefficient=0.0, actuator=actuator))
        assert loop is not None
        self._compiled = compiled = compile_rig(rig, actuator=loop.actuator)
        p = compiled.parameter_values({**rig.parameters(), **loop.parameters(compiled)})
        signals = loop.with_rest(compiled, excitation(compiled.facts, rig, trial))
        end = trial.duration
        prepared = prepare(
            compiled, p, signals, np.array([0.0, end]), tolerance=tolerance, method="explicit"
        )
        self._prepared = loop.around(compiled, prepared, signals)
        tracks = [compiled.facts.tracks.index(name) for name in command_names(loop.corners)]
        self._pieces = self._prepared.problem.tracks.first[tracks]
        self._problem = prepared.problem._replace(x0=prepared.problem.x0.copy())
        self._shares = np.arange(samples + 1) / samples
        self._times = np.zeros(samples + 1)
        self._out = room(compiled, self._times)
        self._counts = np.zeros(3, dtype=np.int64)
        self.corners, self.channels = loop.corners, compiled.output_names
        self.limits = np.array(
            [controller.actuator.limits for controller in loop.controllers.values()]
        )
        self.period, self.end = 1.0 / rate, end
        self.time, self.status, self._steps = 0.0, Status.COMPLETED, 0

    def start(self) -> Array:
        """Reset to static equilibrium at the start and return the outputs there, shape (channels,)."""
        prepared, problem = self._prepared, self._problem
        prepared.start()
        problem.x0[:] = prepared.problem.x0
        self.time, self.status, self._steps = 0.0, Status.COMPLETED, 0
        return self._compiled.evaluate("output", problem.x0, prepared.still, problem.p, problem.m)

    @property
    def is_finished(self) -> bool:
        """Whether the trial has ended."""
        return self.time >= self.end - 1e-9 * max(1.0, self.end)

    def step(self, commands: Array) -> Array:
        """Hold commands for one period, or until the trial's end.

        Commands are in the order of ``corners`` and are clipped to the limits. The outputs have the shape (channels,
        samples), SI; samples that were not reached are NaN (``status`` is the reason).
        """
        given = as_samples(commands, where="step", error=SimulationError).ravel()
        if len(given) != len(self.corners) or not np.all(np.isfinite(given)):
            raise SimulationError(
                "invalid commands",
                where="step",
                found=given.tolist(),
                allowed=Phrase("{count} finite numbers", count=len(self.corners)),
            )
        if self.is_finished or self.status is not Status.COMPLETED:
            raise SimulationError(
                "the run is over", where=f"t = {self.time:.6g} s", hint="Reset the run."
            )
        out, problem = self._out, self._problem
        problem.tracks.coefficients[self._pieces, 0] = np.clip(
            given, self.limits[:, 0], self.limits[:, 1]
        )
        self._steps += 1
        until = min(self._steps * self.period, self.end)
        self._times[:] = self.time + self._shares * (until - self.time)
        out.states[:] = np.nan
        out.outputs[:] = np.nan
        self.status = Status.of(integrate(problem, self._prepared.control, out, self._counts))
        if self.status is Status.COMPLETED:
            problem.x0[:] = out.states[:, -1]
            self.time = until
            self._check_motion()
        return out.outputs[:, 1:].copy()

    def _check_motion(self) -> None:
        change = np.abs(self._problem.x0 - self._prepared.problem.x0)
        if np.any(change > self._prepared.feedback.bound):
            self.status = Status.DIVERGED


def ride_environment(
    rig: Rig,
    trial: Trial | Callable[[np.random.Generator], Trial],
    *,
    actuator: AnyActuator | None = None,
    rate: float = 100.0,
    observed: Sequence[str] = OBSERVED,
    cost: Mapping[str, float] | None = None,
) -> Any:
    """Create a Gymnasium environment of a rig or vehicle with actuators on a road.

    An action contains one number in [-1, 1] per corner, from minimum to maximum command. An observation contains the
    observed channels of all corners as changes from rest, divided by a typical size and clipped to [-10, 10]. The
    reward is the negative cost: weighted mean squares over the step, summed over the corners.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : Trial or callable
        Road, speed and duration; or a function that creates a trial from a ``numpy.random.Generator`` at every reset.
    actuator : SemiActiveDamper, ActiveActuator or MagnetorheologicalDamper, optional
        Actuator of every strut; by default a damper between 0.2 and 8/3 of the corner's own.
    rate : float
        Steps per second, Hz.
    observed : sequence of str
        Channel names without the corner.
    cost : mapping, optional
        Weight of the mean square by channel name without the corner, 1 over its unit squared.

    Returns
    -------
    gymnasium.Env
        Environment with ``reset(seed=...)`` and ``step(action)``; ``info`` contains ``time`` (s), ``commands`` (by
        corner, in the actuator's unit), ``cost`` by channel and, if the run stops early, ``status``.

    Raises
    ------
    MissingPackageError
        If Gymnasium is not installed.
    DescriptionError
        If the model does not have a channel.

    Examples
    --------
    >>> import jounce as jn
    >>> road = jn.HalfSine(height="10 mm", length="60 mm")
    >>> trial = jn.Trial(road=road, speed="1.95 m/s", duration="1 s")
    >>> environment = ride_environment(jn.load("kart-quarter-car"), trial)
    >>> observation, info = environment.reset(seed=1)
    >>> observation, reward, terminated, truncated, info = environment.step([0.0])
    >>> bool(reward <= 0.0), terminated, truncated
    (True, False, False)
    """
    return _environment_class()(
        rig, trial, actuator or SemiActiveDamper(), rate, observed, dict(cost or COST)
    )


@cache
def _environment_class() -> Any:
    gymnasium = require("gymnasium", "learn")

    class RideEnv(gymnasium.Env):  # type: ignore[misc, name-defined] # the base class requires the extra
        """A suspension on a road; created by :func:`ride_environment`."""

        metadata: ClassVar[dict[str, Any]] = {"render_modes": []}

        def __init__(
            self,
            rig: Rig,
            trial: Trial | Callable[[np.random.Generator], Trial],
            actuator: AnyActuator,
            rate: float,
            observed: Sequence[str],
            cost: dict[str, float],
        ) -> None:
            self._trial = trial
            self._make: Callable[[Trial], Stepper] = lambda chosen: _stepper(
                rig, chosen, actuator, rate
            )
            first = trial if isinstance(trial, Trial) else trial(np.random.default_rng(0))
            if not isinstance(first, Trial):
                raise DescriptionError(
                    Phrase("the function returned {first}", first=value_or_kind(first)),
                    where="trial",
                    allowed="a trial",
                )
            self._run = self._make(first)
            self._observed, self._scales = _columns(self._run, observed, default=OBSERVED)
            self._cost = _weights(self._run, cost, default=COST)
            self._rest = self._run.start()
            box = gymnasium.spaces.Box
            self.action_space = box(-1.0, 1.0, (len(self._run.corners),), np.float32)
            self.observation_space = box(-_WIDEST, _WIDEST, self._observed.shape, np.float32)

        def reset(
            self, *, seed: int | None = None, options: dict[str, Any] | None = None
        ) -> tuple[NDArray[np.float32], dict[str, Any]]:
            """Begin a run at rest, on a new road if the trial is random."""
            super().reset(seed=seed, options=options)
            if not isinstance(self._trial, Trial):
                self._run = self._make(self._trial(self.np_random))
            self._rest = self._run.start()
            return self._observation(self._rest), {"time": 0.0}

        def step(
            self, action: Any
        ) -> tuple[NDArray[np.float32], float, bool, bool, dict[str, Any]]:
            """Hold the commands of an action for one period."""
            low, high = self._run.limits.T
            share = 0.5 + 0.5 * np.clip(
                as_samples(action, where="step", error=SimulationError), -1.0, 1.0
            )
            commands = low + (high - low) * share
            outputs = self._run.step(commands)
            info: dict[str, Any] = {
                "time": self._run.time,
                "commands": dict(zip(self._run.corners, commands.tolist(), strict=True)),
            }
            if self._run.status is not Status.COMPLETED:
                info["status"] = self._run.status.name.lower()
                return self._observation(self._rest), -_LOST, True, False, info
            change = outputs - self._rest[:, None]
            info["cost"] = {
                name: weight * float(np.mean(change[row] ** 2)) for name, row, weight in self._cost
            }
            return (
                self._observation(outputs[:, -1]),
                -sum(info["cost"].values()),
                False,
                self._run.is_finished,
                info,
            )

        def _observation(self, outputs: Array) -> NDArray[np.float32]:
            """Return the observation of a sample."""
            scaled = (outputs - self._rest)[self._observed] / self._scales
            return np.clip(scaled, -_WIDEST, _WIDEST).astype(np.float32)

    return RideEnv


def _stepper(rig: Rig, trial: Trial, actuator: AnyActuator, rate: float) -> Stepper:
    if not (np.isfinite(rate) and rate > 0.0):
        raise SimulationError("invalid rate", where="rate", found=rate, allowed="above 0 Hz")
    return Stepper(rig, trial, actuator, rate, samples=max(1, round(1.0 / (rate * _FINEST))))


def _columns(
    run: Stepper, words: Sequence[str], default: Sequence[str]
) -> tuple[NDArray[np.intp], Array]:
    """Return indices of observed outputs and their typical sizes, corner by corner."""
    names = [name for corner in run.corners for name in _present(run, corner, words, default)]
    scales = [_SCALES.get(name.rpartition(".")[2], 1.0) for name in names]
    return np.array([run.channels.index(name) for name in names], dtype=np.intp), np.array(scales)


def _weights(
    run: Stepper, cost: Mapping[str, float], default: Mapping[str, float]
) -> list[tuple[str, int, float]]:
    """Return channel, output index and weight of every term of the cost."""
    terms = []
    for word, weight in cost.items():
        if not (np.isfinite(weight) and weight >= 0.0):
            raise SimulationError(
                "invalid weight", where=f"cost: {word}", found=weight, allowed="0 or more"
            )
        names = [
            name for corner in run.corners for name in _present(run, corner, [word], list(default))
        ]
        terms += [(name, run.channels.index(name), weight) for name in names]
    return terms


def _present(run: Stepper, corner: str, words: Sequence[str], default: Sequence[str]) -> list[str]:
    """Return the channels of a corner; default channels may be missing (massless axles)."""
    channels = []
    for word in words:
        name = qualify(corner, word)
        if name in run.channels:
            channels.append(name)
        elif word not in default:
            raise unknown(name, run.channels, what="channel", where="environment")
    return channels
