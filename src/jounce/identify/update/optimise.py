"""Minimise the objective over scaled parameters: BFGS within bounds, or trust-region least squares."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from jounce.core.errors import FitError
from jounce.core.types import Array
from jounce.identify.update.problem import UpdateProblem

METHODS = ("bfgs", "least-squares")
_BOUND = 1.0 - 1e-6
_SMALL_GAIN, _PERFECT = 1e-6, 1e-12


@dataclass(frozen=True)
class Optimum:
    """Where an optimiser ended."""

    scaled: Array
    objective: float
    iterations: int
    evaluations: int
    converged: bool


def minimise(problem: UpdateProblem, start: Array, method: str) -> Optimum:
    """Run one optimisation from ``start`` (scaled) within -1..+1."""
    before = problem.evaluations
    x, iterations = _METHODS[method](problem, start)
    x = np.clip(x, -1.0, 1.0)
    objective, _ = problem.objective(x)
    return Optimum(x, objective, iterations, problem.evaluations - before, is_stationary(problem, x))


def is_stationary(problem: UpdateProblem, x: Array) -> bool:
    """Tell whether a Gauss-Newton step within the bounds would lower the objective by less than 1e-6 of it."""
    residuals = problem.residuals(x)
    gradient = residuals.jacobian.T @ residuals.vector
    held = (np.abs(x) > 1.0 - 1e-5) & (gradient * x < 0.0)
    if held.all():
        return True
    curvature = residuals.jacobian[:, ~held].T @ residuals.jacobian[:, ~held]
    gain = gradient[~held] @ np.linalg.pinv(curvature, hermitian=True) @ gradient[~held]
    objective = float(residuals.vector @ residuals.vector)
    return bool(gain <= _SMALL_GAIN * objective or objective <= _PERFECT * problem.data_energy)


def minimise_from_many(problem: UpdateProblem, start: Array, method: str, starts: int, seed: int) -> list[Optimum]:
    """Run from ``start`` and from ``starts - 1`` Latin-hypercube points; best first."""
    points = [start]
    if starts > 1:
        from scipy.stats import qmc

        points += list(2.0 * qmc.LatinHypercube(problem.size, seed=seed).random(starts - 1) - 1.0)
    return sorted((minimise(problem, point, method) for point in points), key=lambda optimum: optimum.objective)


def _bfgs(problem: UpdateProblem, start: Array) -> tuple[Array, int]:
    """L-BFGS-B: the paper's BFGS, with the bounds inside the method."""
    from scipy.optimize import minimize

    scale = max(problem.objective(start)[0], 1e-300)

    def scaled_objective(x: Array) -> tuple[float, Array]:
        value, gradient = problem.objective(x)
        return value / scale, gradient / scale

    result = minimize(
        scaled_objective,
        start,
        jac=True,
        method="L-BFGS-B",
        bounds=[(-1.0, 1.0)] * problem.size,
        options={"ftol": 1e-13, "gtol": 1e-12, "maxiter": 200, "maxcor": 20},
    )
    return result.x, int(result.nit)


def _least_squares(problem: UpdateProblem, start: Array) -> tuple[Array, int]:
    from scipy.optimize import least_squares

    inside = np.clip(np.where(np.abs(start) < 1e-6, 0.0, start), -_BOUND, _BOUND)  # SciPy's first radius is |start|
    result = least_squares(
        lambda x: problem.residuals(x).vector,
        inside,
        jac=lambda x: problem.residuals(x).jacobian,
        bounds=(-1.0, 1.0),
        method="trf",
        xtol=1e-12,
        ftol=1e-12,
        gtol=1e-12,
        max_nfev=200,
    )
    return result.x, int(result.njev)


_METHODS = {"bfgs": _bfgs, "least-squares": _least_squares}


def check_method(method: str) -> None:
    """Refuse an unknown method."""
    if method not in METHODS:
        raise FitError("unknown method", found=method, allowed=", ".join(METHODS))
