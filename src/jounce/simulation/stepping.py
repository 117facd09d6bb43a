"""A run taken step by step: commands in, measurements out; it goes on from where it stands."""

from __future__ import annotations

import numpy as np

from jounce.control.actuators import AnyActuator
from jounce.control.laws import Passive
from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.kernel.explicit import integrate
from jounce.kernel.status import Status
from jounce.parts import Rig
from jounce.roads import Trial
from jounce.simulation.compiled import compile_rig
from jounce.simulation.controlled import close_loop, command_names
from jounce.simulation.excitation import excitation
from jounce.simulation.run import prepare, room


class Stepper:
    """A rig with actuators on a trial, at a command rate: every ``step`` holds commands for one period.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : Trial
        What is driven over.
    actuator : SemiActiveDamper, ActiveActuator or MagnetorheologicalDamper
        Of every strut; open numbers are filled in as for controllers.
    rate : float
        Steps per second, Hz.
    samples : int
        Outputs a step, evenly spread, the last one at its end.
    tolerance : float
        Relative error of the displacements.

    Notes
    -----
    ``corners`` and ``channels`` name the commands and the outputs, ``limits`` has the smallest and the largest command
    of each corner, ``time`` (s) says where the run stands, ``status`` how the last step ended.

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
            raise SimulationError("not a rate", where="rate", found=rate, allowed="above 0 Hz")
        loop = close_loop(rig, Passive(damping_coefficient=0.0, actuator=actuator))
        assert loop is not None
        self._compiled = compiled = compile_rig(rig, actuator=loop.actuator)
        p = compiled.parameter_values({**rig.parameters(), **loop.parameters(compiled)})
        signals = loop.with_rest(compiled, excitation(compiled.facts, rig, trial))
        end = trial.duration
        prepared = prepare(compiled, p, signals, np.array([0.0, end]), tolerance=tolerance, method="explicit")
        self._prepared = loop.around(compiled, prepared, signals)
        tracks = [compiled.facts.tracks.index(name) for name in command_names(loop.corners)]
        self._pieces = self._prepared.problem.tracks.first[tracks]
        self._problem = prepared.problem._replace(x0=prepared.problem.x0.copy())
        self._shares = np.arange(samples + 1) / samples
        self._out = room(compiled, np.zeros(samples + 1))
        self._counts = np.zeros(3, dtype=np.int64)
        self.corners, self.channels = loop.corners, compiled.output_names
        self.limits = np.array([controller.actuator.limits for controller in loop.controllers.values()])
        self.period, self.end = 1.0 / rate, end
        self.time, self.status, self._steps = 0.0, Status.COMPLETED, 0

    def start(self) -> Array:
        """Go back to static equilibrium at the start; give the outputs there, shape (channels,)."""
        prepared, problem = self._prepared, self._problem
        prepared._start()
        problem.x0[:] = prepared.problem.x0
        self.time, self.status, self._steps = 0.0, Status.COMPLETED, 0
        return self._compiled.evaluate("output", problem.x0, prepared.still, problem.p, problem.m)

    @property
    def finished(self) -> bool:
        """Whether the trial's end is reached."""
        return self.time >= self.end - 1e-9 * max(1.0, self.end)

    def step(self, commands: Array) -> Array:
        """Hold commands for one period (at most to the trial's end).

        Parameters
        ----------
        commands : ndarray, shape (corners,)
            In the order of ``corners``; clipped to the limits.

        Returns
        -------
        ndarray, shape (channels, samples)
            Outputs, SI; what was not reached is no number (``status`` says why).

        Raises
        ------
        SimulationError
            When the run is over, or for commands that are not finite numbers.
        """
        given = np.asarray(commands, dtype=np.float64).ravel()
        if len(given) != len(self.corners) or not np.all(np.isfinite(given)):
            raise SimulationError(
                "not commands", where="step", found=given.tolist(), allowed=f"{len(self.corners)} finite numbers"
            )
        if self.finished or self.status is not Status.COMPLETED:
            raise SimulationError("the run is over", where=f"t = {self.time:.6g} s", hint="Start it again.")
        out, problem = self._out, self._problem
        problem.tracks.coefficients[self._pieces, 0] = np.clip(given, self.limits[:, 0], self.limits[:, 1])
        self._steps += 1
        until = min(self._steps * self.period, self.end)
        out.times[:] = self.time + self._shares * (until - self.time)
        out.states[:] = np.nan
        out.outputs[:] = np.nan
        self.status = Status.of(integrate(problem, self._prepared.control, out, self._counts))
        if self.status is Status.COMPLETED:
            problem.x0[:] = out.states[:, -1]
            self.time = until
            self._check_motion()
        return out.outputs[:, 1:].copy()

    def _check_motion(self) -> None:
        moved = np.abs(self._problem.x0 - self._prepared.problem.x0)
        if np.any(moved > self._prepared.feedback.bound):
            self.status = Status.DIVERGED
