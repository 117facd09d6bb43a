"""Log densities of updated parameters: noise only, and with all uncertain inputs integrated out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np

from jounce.core.errors import FitError, SimulationError
from jounce.core.types import Array
from jounce.identify.discrepancy import ModelErrorFit
from jounce.identify.fit_problem import FitTrial, FreeParameter, Residuals
from jounce.identify.log_density import Region
from jounce.identify.settings import UpdateSettings
from jounce.identify.update import robust_covariance

_SETTLING, _CLIMBS = (
    16,
    3,
)  # climbs of the doubts: at the best parameters, and at others starting from there
_LITTLE_GAIN = 0.01  # gain of twice the log density below which climbing stops
_WIDE = 10.0  # maximum width in scaled units


class _Residual(Protocol):
    """Residuals as functions of scaled unknowns."""

    def residuals(self, scaled: Array) -> Residuals: ...


@dataclass(frozen=True)
class Basis:
    """Inputs of a posterior: trials, free parameters, and the extended model if model error is included.

    ``covariance`` is that of the scaled parameters, ``values`` are the estimates (SI). ``noise`` and ``residual`` are
    the standard deviations (SI) of noise and residuals of each channel.
    """

    trials: tuple[FitTrial, ...]
    free: tuple[FreeParameter, ...]
    calibration: ModelErrorFit | None
    covariance: Array
    values: Mapping[str, float] = field(default_factory=dict)
    settings: UpdateSettings = field(default_factory=UpdateSettings)
    noise: Mapping[str, float] = field(default_factory=dict)
    residual: Mapping[str, float] = field(default_factory=dict)


# noise only ----------------------------------------------------------------------------------------------------------


class NoiseDensity:
    """Log density of scaled parameters with residuals treated as noise, with the covariance that an update reports."""

    def __init__(
        self, problem: _Residual, best: Array, lower: Array, upper: Array, lowest: Array
    ) -> None:
        self.problem, self.best, self.lowest = problem, best, lowest
        residuals = problem.residuals(best)
        jacobian = residuals.jacobian
        count, size = jacobian.shape
        norms = np.linalg.norm(jacobian, axis=0)
        if not np.all(norms > 1e-9 * max(float(np.max(norms, initial=0.0)), 1e-300)):
            raise FitError(
                "the data are insensitive to a parameter",
                where=f"unknown {int(np.argmin(norms)) + 1}",
            )
        square = float(residuals.vector @ residuals.vector)
        if square <= 0.0:
            raise FitError(
                "the model explains the data exactly: no noise is left to estimate uncertainties from",
                where="posterior",
            )
        self.variance = square / max(count - size, 1)
        self.covariance: Array = robust_covariance(residuals.vector, jacobian, residuals.blocks)
        plain = np.linalg.cholesky(jacobian.T @ jacobian / self.variance).T
        wanted = np.linalg.cholesky(np.linalg.inv(self.covariance)).T
        self.turn = np.linalg.solve(plain, wanted)
        spread = np.linalg.inv(np.linalg.inv(self.covariance) + np.eye(size) / _WIDE**2)
        self.region = Region(best, np.linalg.cholesky(spread), lower, upper)

    def __call__(self, x: Array) -> tuple[float, Array, float] | None:
        """Return log density and slopes; None where the model cannot be simulated."""
        at = self.best + self.turn @ (x - self.best)
        if np.any(at < self.lowest):
            return None
        try:
            residuals = self.problem.residuals(at)
        except SimulationError:
            return None
        value = -0.5 * float(residuals.vector @ residuals.vector) / self.variance
        return (
            value,
            -(self.turn.T @ (residuals.jacobian.T @ residuals.vector)) / self.variance,
            0.0,
        )


# model error ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Climbed:
    """State of the climbing doubts: their ``step``, the remaining step, information, score and sum of squares."""

    step: Array
    more: Array
    information: Array
    score: Array
    square: float


class DoubtDensity:
    """Log density of scaled parameters with all uncertain inputs integrated out around their best values."""

    def __init__(self, fit: ModelErrorFit) -> None:
        self.fit = fit
        problem, state = fit.problem, fit.state
        self.size = len(problem.free)
        self.best = state.theta
        information, _, _ = self._linear(fit.blocks, state)
        p = self.size
        self.information = information
        self.follow = -np.linalg.solve(
            information[p:, p:], information[p:, :p]
        )  # doubts by parameters
        self.spread = np.linalg.inv(information[p:, p:])
        profiled = information[:p, :p] + information[:p, p:] @ self.follow
        self.covariance: Array = np.asarray(np.linalg.inv(profiled), dtype=float)
        lower = np.array(
            [item.scale(0.0) if item.lower >= 0.0 else -np.inf for item in problem.free]
        )
        spread = np.linalg.inv(profiled + np.eye(p) / _WIDE**2)
        best = np.maximum(self.best, lower)
        self.region = Region(best, np.linalg.cholesky(spread), lower, np.full(p, np.inf))
        self.seen: list[tuple[Array, Array]] = []
        self.beside = [dict(run.beside) for run in problem.runs]
        self.settled = np.zeros(
            len(information) - p
        )  # remaining step of the doubts at the end of the fit
        try:
            self.settled = self._climb(state, fit.blocks, _SETTLING).step
            self.beside = [dict(run.beside) for run in problem.runs]
        except SimulationError:  # then every point keeps this remaining step
            pass

    def _linear(self, blocks: Any, state: Any) -> tuple[Array, Array, float]:
        """Return information and score of all unknowns and the sum of squares, at the fit's variances."""
        fit = self.fit
        system = fit.problem.system(blocks, state)
        information, score, square = system.beforehand()
        for name, variance in fit.variance.items():
            information = information + system.normal[name][0] / variance
            score = score + system.normal[name][1] / variance
        for name, _, residual, _ in system.rows:
            square += float(residual @ residual) / fit.variance[name]
        return information, score, square

    def __call__(self, x: Array) -> tuple[float, Array, float] | None:
        """Return log density and slopes; None where the extended model cannot be simulated."""
        fit, p = self.fit, self.size
        moved = x - fit.state.theta
        step = np.concatenate([moved, self.settled + self.follow @ moved])
        for run, beside in zip(fit.problem.runs, self.beside, strict=True):
            run.beside = (
                beside  # not those of the previous point: the density is a function of x alone
            )
        try:
            state = fit.problem.step_state(fit.state, step, fit.blocks, 1.0)
            at = self._climb(state, fit.problem.blocks(state)[0], _CLIMBS)
        except SimulationError:
            return None
        inner = at.information[p:, p:]
        self.seen.append((x, step[p:] + at.step + at.more))
        value = -0.5 * (at.square - float(at.score[p:] @ at.more))
        return (
            value,
            at.score[:p] - at.information[:p, p:] @ at.more,
            -0.5 * float(np.linalg.slogdet(inner)[1]),
        )

    def _climb(self, state: Any, blocks: Any, climbs: int) -> _Climbed:
        """Move the doubts to their maximum by the slopes of the blocks, which are those at the state.

        Forces parallel to the strut depend on the motion that they cause. Each climb uses the forces of the
        previous run, and they converge with the doubts. If wheels lift off, or if doubts with similar effects
        exchange values, the sum of squares may rise on the way: the best climb is returned.
        """
        problem, p = self.fit.problem, self.size
        information, score, square = self._linear(blocks, state)
        step, best = np.zeros(len(information) - p), None
        for left in range(climbs, -1, -1):
            more = np.asarray(np.linalg.solve(information[p:, p:], score[p:]), dtype=float)
            if best is None or square < best.square:
                best = _Climbed(step, more, information, score, square)
            if not left or float(score[p:] @ more) < _LITTLE_GAIN:
                break
            state = problem.step_state(state, np.concatenate([np.zeros(p), more]), blocks, 1.0)
            blocks = problem.residuals(state, blocks)
            _, score, square = self._linear(blocks, state)
            step = step + more
        assert best is not None
        return best

    def doubts(self, x: Array, seed: int) -> Array:
        """Draw steps of all doubts (n, unknowns less parameters) conditional on scaled parameters (n, parameters)."""
        rng = np.random.default_rng([seed, 7])
        mean = self.settled + (x - self.fit.state.theta) @ self.follow.T
        if (
            len(self.seen) > 2 * self.size + 2
        ):  # residual of a straight line: its mean over all evaluated points
            at, steps = (np.array(part) for part in zip(*self.seen, strict=True))
            rows = np.column_stack([np.ones(len(at)), at - self.fit.state.theta])
            mean = (
                np.column_stack([np.ones(len(x)), x - self.fit.state.theta])
                @ np.linalg.lstsq(rows, steps)[0]
            )
        return np.asarray(mean + rng.normal(size=mean.shape) @ np.linalg.cholesky(self.spread).T)
