"""Search for the best design: SLSQP over scaled numbers, a start that keeps the limits, the conditions at the end."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from jounce.core.errors import FitError
from jounce.core.types import Array
from jounce.design.problem import DesignProblem

_ACTIVE = 1e-5
_STATIONARY = 1e-4
_EVEN = 1e-4
_WIDE = 3.0  # bounds wider than this ratio are searched by logarithm
_MOST = 200
_FINE = 1e-14


@dataclass(frozen=True)
class Search:
    """Where a search ended: values (SI), objective, largest broken share of a limit (1), iterations."""

    values: Array
    objective: float
    violation: float
    iterations: int


@dataclass(frozen=True)
class Conditions:
    """Whether the conditions of an optimum hold, and the multiplier of every active limit side by its names."""

    holds: bool
    gains: dict[tuple[str, str, str], float]


class Scale:
    """Free numbers as 0 to 1 between their bounds, by logarithm where these are far apart."""

    def __init__(self, problem: DesignProblem) -> None:
        self.lower = np.array([free.lower for free in problem.free])
        self.upper = np.array([free.upper for free in problem.free])
        self.is_log = (self.lower > 0.0) & (self.upper > _WIDE * np.maximum(self.lower, 1e-300))

    def values(self, u: Array) -> Array:
        """Give SI values for scaled ones."""
        inside = np.clip(u, 0.0, 1.0)
        safe = np.where(self.is_log, self.lower, 1.0)
        ratio = np.where(self.is_log, self.upper, 1.0) / safe
        straight = self.lower + inside * (self.upper - self.lower)
        found = np.where(self.is_log, safe * ratio**inside, straight)
        return np.asarray(np.clip(found, self.lower, self.upper))

    def slopes(self, u: Array) -> Array:
        """Slope of each value (SI) along its scaled one."""
        safe = np.where(self.is_log, self.lower, 1.0)
        ratio = np.where(self.is_log, self.upper, 1.0) / safe
        return np.asarray(np.where(self.is_log, self.values(u) * np.log(ratio), self.upper - self.lower))

    def scaled(self, values: Array) -> Array:
        """Give scaled values for those in SI."""
        safe = np.where(self.is_log, self.lower, 1.0)
        ratio = np.where(self.is_log, self.upper / safe, np.e)
        logarithmic = np.log(np.where(self.is_log, values, 1.0) / safe) / np.log(ratio)
        return np.asarray(np.where(self.is_log, logarithmic, (values - self.lower) / (self.upper - self.lower)))


class _Task:
    """What SLSQP sees: scaled numbers, then one bound for each metric whose worst corner counts."""

    def __init__(self, problem: DesignProblem) -> None:
        self.problem, self.scale = problem, Scale(problem)
        metrics = problem.metrics
        self.worst = [text for text in problem.weights if metrics[text].is_worst and len(metrics[text].channels) > 1]
        self.count = len(problem.free)

    def begin(self, values: Array) -> Array:
        tops = [abs(self.problem.whole(text, values)[0] / self.problem.base[text]) for text in self.worst]
        return np.concatenate([self.scale.scaled(values), tops])

    def objective(self, z: Array) -> tuple[float, Array]:
        u, tops = z[: self.count], z[self.count :]
        values, weights = self.scale.values(u), self.problem.weights
        total, slopes = 0.0, np.zeros(len(z))
        whole = sum(weights.values())
        for text, weight in weights.items():
            if text in self.worst:
                i = self.worst.index(text)
                total += weight * tops[i] ** 2 / whole
                slopes[self.count + i] += 2.0 * weight * tops[i] / whole
                continue
            number, along = self.problem.whole(text, values)
            share = weight / (self.problem.base[text] ** 2 * whole)
            total += share * number**2
            slopes[: self.count] += 2.0 * share * number * along * self.scale.slopes(u)
        return total, slopes

    def margins(self, z: Array) -> tuple[Array, Array]:
        """What must not become negative, and its slopes (margins, variables)."""
        u, tops = z[: self.count], z[self.count :]
        values, chain = self.scale.values(u), self.scale.slopes(u)
        rows = [(margin, slope * chain, None) for _, _, _, margin, slope in self.problem.margins(values)]
        found = [margin for margin, _, _ in rows]
        table = [np.concatenate([slope, np.zeros(len(tops))]) for _, slope, _ in rows]
        for i, text in enumerate(self.worst):
            numbers, slopes = self.problem.numbers(values)[text]
            base = self.problem.base[text]
            for k in range(len(numbers)):
                found.append(float(tops[i] - numbers[k] / base))
                row = np.zeros(len(z))
                row[: self.count], row[self.count + i] = -slopes[:, k] / base * chain, 1.0
                table.append(row)
        return np.array(found), np.array(table).reshape(len(found), len(z))


def search(
    problem: DesignProblem, *, starts: int = 1, seed: int = 0, begin: Array | None = None, precision: float = _FINE
) -> Search:
    """Search from the rig's own values (or ``begin``, SI) and from further points; the best that keeps the limits.

    It ends when the objective changes by less than ``precision`` (1) between steps.
    """
    if starts < 1:
        raise FitError("not a number of searches", where="starts", found=starts, allowed="1 or more")
    first = problem.start if begin is None else begin
    points = [first]
    if starts > 1:
        from scipy.stats import qmc

        spread = qmc.LatinHypercube(len(first), seed=seed).random(starts - 1)
        points += [Scale(problem).values(point) for point in spread]
    found = [_one(problem, point, precision) for point in points]
    if all(one.violation > _ACTIVE for one in found):
        found.append(_one(problem, least_violation(problem), precision))
    return min(found, key=lambda one: (max(one.violation, _ACTIVE), one.objective))


def _one(problem: DesignProblem, begin: Array, precision: float) -> Search:
    from scipy.optimize import minimize

    task = _Task(problem)
    z = task.begin(begin)
    constraints: list[dict[str, Any]] = []
    if problem.limits or task.worst:
        constraints.append({"type": "ineq", "fun": lambda z: task.margins(z)[0], "jac": lambda z: task.margins(z)[1]})
    bounds = [(0.0, 1.0)] * task.count + [(0.0, None)] * len(task.worst)
    iterations = 0
    for _ in range(3):  # SLSQP forgets its curvature at a new start, which helps where it stalled
        result = minimize(
            task.objective, z, jac=True, method="SLSQP", bounds=bounds, constraints=constraints,
            options={"ftol": precision, "maxiter": _MOST},
        )  # fmt: skip
        iterations += int(result.nit)
        z = np.asarray(result.x) if np.all(np.isfinite(result.x)) else z
        if is_optimal(problem, task.scale.values(z[: task.count])).holds:
            break
    values = task.scale.values(z[: task.count])
    return Search(values, problem.objective(values)[0], violation_of(problem, values), iterations)


def violation_of(problem: DesignProblem, values: Array) -> float:
    """Largest share (1) by which a limit is broken; 0 where all are kept."""
    return max((-margin for _, _, _, margin, _ in problem.margins(values)), default=0.0)


def least_violation(problem: DesignProblem) -> Array:
    """Values (SI) within the bounds where the limits are broken least."""
    from scipy.optimize import minimize

    scale = Scale(problem)
    count = len(problem.free)

    def margins(z: Array) -> Array:
        found = [margin for _, _, _, margin, _ in problem.margins(scale.values(z[:count]))]
        return np.asarray(np.array(found) + z[count])

    def slopes(z: Array) -> Array:
        chain = scale.slopes(z[:count])
        rows = [slope * chain for _, _, _, _, slope in problem.margins(scale.values(z[:count]))]
        return np.hstack([np.array(rows), np.ones((len(rows), 1))])

    best: Array = problem.start
    least = np.inf
    for u in (scale.scaled(problem.start), np.full(count, 0.5), np.full(count, 0.1), np.full(count, 0.9)):
        first = max(violation_of(problem, scale.values(u)), 0.0)
        result = minimize(
            lambda z: (z[count], np.eye(count + 1)[count]), np.append(u, first), jac=True, method="SLSQP",
            bounds=[(0.0, 1.0)] * count + [(0.0, None)],
            constraints=[{"type": "ineq", "fun": margins, "jac": slopes}], options={"ftol": 1e-12, "maxiter": _MOST},
        )  # fmt: skip
        values = scale.values(np.asarray(result.x)[:count])
        broken = violation_of(problem, values)
        if broken < least:
            best, least = values, broken
    return np.asarray(best, dtype=np.float64)


def is_optimal(problem: DesignProblem, values: Array) -> Conditions:
    """Check the conditions of Karush, Kuhn and Tucker at some values (SI), in scaled numbers."""
    from scipy.optimize import nnls

    task = _Task(problem)
    z = task.begin(values)
    _, slope = task.objective(z)
    margins, table = task.margins(z)
    names = [(limit.metric.text, channel, side) for limit, channel, side, _, _ in problem.margins(values)]
    active = [i for i in range(len(margins)) if margins[i] < _ACTIVE]
    walls = [_wall(i, z[i], len(z)) for i in range(task.count)]
    columns = [table[i] for i in active] + [wall for wall in walls if wall is not None]
    if not columns:
        holds = float(np.max(np.abs(slope), initial=0.0)) <= _STATIONARY
        return Conditions(holds, {})
    table = np.array(columns)
    small = _EVEN * np.eye(len(table))  # limits that say the same share what they hold
    multipliers, _ = nnls(np.vstack([table.T, small]), np.concatenate([slope, np.zeros(len(table))]))
    left = float(np.linalg.norm(multipliers @ table - slope))
    gains = {names[i]: float(multipliers[k]) for k, i in enumerate(active) if i < len(names)}
    return Conditions(bool(left <= _STATIONARY and violation_of(problem, values) <= _ACTIVE), gains)


def _wall(i: int, u: float, count: int) -> Array | None:
    """Direction into the bounds where a number lies on one of them."""
    row = np.zeros(count)
    row[i] = 1.0 if u < 1e-6 else -1.0 if u > 1.0 - 1e-6 else 0.0
    return row if row.any() else None
