"""Search for the best-fitting parameters of a model, from one or several starts."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.identify.fit_problem import UpdateProblem

SAME_PLACE = 0.1
"""Distance, as a share of half the range, below which two searches have found the same optimum."""
_BOUND = 1.0 - 1e-6  # of half the range: SciPy's search begins strictly inside its bounds
AT_BOUND = 1.0 - 1e-5
"""Scaled value from which a parameter counts as at its bound; searches end slightly closer to it."""
_SMALL_GAIN, _PERFECT = 1e-6, 1e-12
"""Gain of a further step, as a share of the objective and of the records' energy, below which a point is optimal.

At the first limit, the remaining step is a thousandth of a standard error times the root of the number of samples.
"""


@dataclass(frozen=True)
class Optimum:
    """Final point of an optimiser."""

    scaled: Array
    objective: float
    iterations: int
    evaluations: int
    converged: bool


@dataclass(frozen=True)
class SearchOutcome:
    """The best point, the others sorted by residual, the number of starts, and whether two starts led to the best."""

    best: Optimum
    others: tuple[Optimum, ...]
    starts: int
    is_confirmed: bool


def search_from_starts(
    problem: UpdateProblem, start: Array, method: str, seed: int, *, starts: int | None
) -> SearchOutcome:
    """Search from ``start`` (scaled) and from Latin-hypercube points within the bounds.

    ``starts`` is their total number. By default searches continue until two have led to the best optimum, with at least
    `_FEWEST` and at most `_MOST` starts. All but the first are coarse; one that may be better is then completed.
    """
    if starts == 1:
        return SearchOutcome(minimise(problem, start, method), (), 1, is_confirmed=True)
    if starts is None:
        return _until_two_agree(problem, start, method, seed)
    points = [start, *_spread(problem.size, starts - 1, seed)]
    if starts >= _MANY:
        ends = sorted(
            (end for _, end in _rough_ends(problem, points[1:])), key=lambda end: end.objective
        )
        points = [start, *(end.scaled for end in _each_once(ends)[:_FINISHED])]
    ends = sorted(
        (minimise(problem, point, method) for point in points), key=lambda end: end.objective
    )
    return SearchOutcome(ends[0], tuple(_each_once(ends)[1:]), starts, is_confirmed=True)


_MANY, _FINISHED = (
    12,
    4,
)  # number of starts from which they are screened, and number of the best that are completed
_FEWEST, _MOST = 4, 8
"""Minimum and maximum number of starts of an adaptive search.

If two thirds of all starts lead to a different optimum than the first, one of three others finds it in 19 of 20 cases.
"""
_AS_GOOD = 1.05  # ratio to the best coarse objective within which a search has found an equally good optimum
_COARSE, _LOOSE = (
    1e-5,
    0.03,
)  # relative error of displacements and of the objective in a coarse descent


def _until_two_agree(problem: UpdateProblem, start: Array, method: str, seed: int) -> SearchOutcome:
    best, others, agreements = minimise(problem, start, method), list[Optimum](), 1
    tried = 1
    for rough, end in _rough_ends(problem, _spread(problem.size, _MOST - 1, seed)):
        tried += 1
        here, _ = rough.objective(best.scaled)
        if _is_near(end, best) or abs(end.objective - here) < (_AS_GOOD - 1.0) * here:
            agreements += 1
        elif end.objective > here:
            others.append(end)
        else:
            finished = minimise(problem, end.scaled, method)
            agreements = agreements + 1 if _is_near(finished, best) else 1
            others.append(best)
            best = min(best, finished, key=lambda end: end.objective)
        if tried >= _FEWEST and agreements > 1:
            break
    apart = [
        end
        for end in _each_once(sorted(others, key=lambda end: end.objective))
        if not _is_near(end, best)
    ]
    return SearchOutcome(best, tuple(apart), tried, is_confirmed=agreements > 1)


def _spread(size: int, count: int, seed: int) -> list[Array]:
    """Return Latin-hypercube points between -1 and +1."""
    from scipy.stats import qmc

    return list(2.0 * qmc.LatinHypercube(size, seed=seed).random(count) - 1.0)


def _is_near(first: Optimum, other: Optimum) -> bool:
    return bool(np.max(np.abs(first.scaled - other.scaled)) < SAME_PLACE)


def _each_once(ends: list[Optimum]) -> list[Optimum]:
    """Return distinct optima, keeping the first of those at the same point."""
    apart: list[Optimum] = []
    for end in ends:
        if not any(_is_near(end, other) for other in apart):
            apart.append(end)
    return apart


def minimise(problem: UpdateProblem, start: Array, method: str) -> Optimum:
    """Run one optimisation from ``start`` (scaled) within -1..+1."""
    before = problem.evaluations
    x, iterations = _METHODS[method](problem, start)
    x = np.clip(x, -1.0, 1.0)
    objective, _ = problem.objective(x)
    return Optimum(
        x, objective, iterations, problem.evaluations - before, is_stationary(problem, x)
    )


def is_stationary(problem: UpdateProblem, x: Array) -> bool:
    """Whether a Gauss-Newton step within the bounds would lower the objective by less than a millionth."""
    residuals = problem.residuals(x)
    gradient = residuals.jacobian.T @ residuals.vector
    clamped = (np.abs(x) > AT_BOUND) & (gradient * x < 0.0)
    if clamped.all():
        return True
    curvature = residuals.jacobian[:, ~clamped].T @ residuals.jacobian[:, ~clamped]
    gain = gradient[~clamped] @ np.linalg.pinv(curvature, hermitian=True) @ gradient[~clamped]
    objective = float(residuals.vector @ residuals.vector)
    return bool(gain <= _SMALL_GAIN * objective or objective <= _PERFECT * problem.data_energy)


def _rough_ends(
    problem: UpdateProblem, points: list[Array]
) -> Iterator[tuple[UpdateProblem, Optimum]]:
    """Descend from each point with coarse simulations; return the coarse problem and the end points.

    Points that cannot be simulated are skipped.
    """
    from scipy.optimize import least_squares

    rough = problem.coarser(_COARSE)
    for point in points:
        inside = np.clip(point, -_BOUND, _BOUND)
        try:
            count = len(rough.residuals(inside).vector)
        except SimulationError:
            continue

        def vector(x: Array, count: int = count) -> Array:
            try:
                return rough.residuals(x).vector
            except SimulationError:
                return np.full(count, np.inf)

        before = rough.evaluations
        result = least_squares(
            vector, inside, jac=lambda x: rough.residuals(x).jacobian, bounds=(-1.0, 1.0), xtol=1e-3, ftol=_LOOSE,
            gtol=1e-12, max_nfev=12,
        )  # fmt: skip
        problem.evaluations += rough.evaluations - before
        yield (
            rough,
            Optimum(
                result.x,
                2.0 * float(result.cost),
                int(result.njev),
                int(result.nfev),
                converged=True,
            ),
        )


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

    inside = np.clip(
        np.where(np.abs(start) < 1e-6, 0.0, start), -_BOUND, _BOUND
    )  # SciPy's first radius is |start|
    count = len(problem.residuals(inside).vector)

    def vector(x: Array) -> Array:
        """Return residuals; infinite if a step cannot be simulated, which makes the search try a shorter one."""
        try:
            return problem.residuals(x).vector
        except SimulationError:
            return np.full(count, np.inf)

    result = least_squares(
        vector,
        inside,
        jac=lambda x: problem.residuals(x).jacobian,
        bounds=(-1.0, 1.0),
        method="trf",
        xtol=1e-9,  # of the bounds' half range; below it simulations of finite tolerance differ by chance
        ftol=1e-8,
        gtol=1e-12,
        max_nfev=200,
    )
    return result.x, int(result.njev)


_METHODS = {"bfgs": _bfgs, "least-squares": _least_squares}
