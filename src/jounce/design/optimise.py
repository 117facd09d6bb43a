"""The best design within bounds and limits: the search (SLSQP over scaled numbers), its result and active limits."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np

from jounce.core.errors import DescriptionError, FitError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.text import align_columns
from jounce.core.types import Array
from jounce.core.waiting import report_work
from jounce.design.cases import Case, cases_problem
from jounce.design.problem import (
    DesignProblem,
    LimitGiven,
    Objective,
    StationaryEvaluator,
    design_problem,
)
from jounce.identify.fit_problem import Bounds
from jounce.parts import Rig, as_rig
from jounce.parts.rig import unit_of
from jounce.ride.stationary import linear_findings
from jounce.ride.surface import Density, Sides
from jounce.roads import Trial
from jounce.variants.designs import Spread

_ACTIVE = (
    1e-5  # share of a limit within which it counts as met, and as active: searches end far closer
)
_STATIONARY = 1e-4  # residual slope at an optimum: 0.01 % of the initial objective over the range of a variable
_EVEN = 1e-4  # regularisation weight of the multipliers
_MOST_STARTS = 1000  # each is a search
_WIDE = 3.0  # bounds wider than this ratio are searched on a logarithmic scale
_MOST = 200  # iterations
_FINE = (
    1e-14  # of the objective, which is 1 at the start: rounding level, since evaluations are exact
)


@dataclass(frozen=True)
class SearchResult:
    """End of a search: values (SI), objective, largest relative violation of a limit (1), iterations.

    ``settled`` is True if a search around kinks, which percentiles cause, found nothing better.
    """

    values: Array
    objective: float
    violation: float
    iterations: int
    settled: bool = False


@dataclass(frozen=True)
class Conditions:
    """Result of the optimality check, and the multiplier of each active side of a limit by its names."""

    holds: bool
    gains: dict[tuple[str, str, str], float]


class Scale:
    """Scaling of the free variables to 0..1 between their bounds, logarithmic for wide bounds."""

    def __init__(self, problem: DesignProblem) -> None:
        self.lower = np.array([free.lower for free in problem.free])
        self.upper = np.array([free.upper for free in problem.free])
        self.is_log = (self.lower > 0.0) & (self.upper > _WIDE * np.maximum(self.lower, 1e-300))

    def values(self, u: Array) -> Array:
        """Convert scaled values to SI."""
        inside = np.clip(u, 0.0, 1.0)
        safe = np.where(self.is_log, self.lower, 1.0)
        ratio = np.where(self.is_log, self.upper, 1.0) / safe
        straight = self.lower + inside * (self.upper - self.lower)
        values = np.where(self.is_log, safe * ratio**inside, straight)
        return np.asarray(np.clip(values, self.lower, self.upper))

    def slopes(self, u: Array) -> Array:
        """Return the derivative of each value (SI) with respect to its scaled value."""
        safe = np.where(self.is_log, self.lower, 1.0)
        ratio = np.where(self.is_log, self.upper, 1.0) / safe
        return np.asarray(
            np.where(self.is_log, self.values(u) * np.log(ratio), self.upper - self.lower)
        )

    def normalise(self, values: Array) -> Array:
        """Convert SI values to scaled ones."""
        safe = np.where(self.is_log, self.lower, 1.0)
        ratio = np.where(self.is_log, self.upper / safe, math.e)
        logarithmic = np.log(np.where(self.is_log, values, 1.0) / safe) / np.log(ratio)
        return np.asarray(
            np.where(self.is_log, logarithmic, (values - self.lower) / (self.upper - self.lower))
        )


class _SlsqpProblem:
    """The problem as passed to SLSQP: scaled variables, then one bound for each metric that takes its worst corner."""

    def __init__(self, problem: DesignProblem) -> None:
        self.problem, self.scale = problem, Scale(problem)
        metrics = problem.metrics
        self.worst = [
            text
            for text in problem.weights
            if metrics[text].is_worst and len(metrics[text].channels) > 1
        ]
        self.count = len(problem.free)

    def begin(self, values: Array) -> Array:
        tops = [
            abs(self.problem.whole(text, values)[0] / self.problem.base[text])
            for text in self.worst
        ]
        return np.concatenate([self.scale.normalise(values), tops])

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
        """Return margins, which must not become negative, and their slopes (margins, variables)."""
        u, tops = z[: self.count], z[self.count :]
        values, chain = self.scale.values(u), self.scale.slopes(u)
        rows = [
            (margin, slope * chain, None) for _, _, _, margin, slope in self.problem.margins(values)
        ]
        margins = [margin for margin, _, _ in rows]
        table = [np.concatenate([slope, np.zeros(len(tops))]) for _, slope, _ in rows]
        for i, text in enumerate(self.worst):
            numbers, slopes = self.problem.numbers(values)[text]
            base = self.problem.base[text]
            for k in range(len(numbers)):
                margins.append(float(tops[i] - numbers[k] / base))
                row = np.zeros(len(z))
                row[: self.count], row[self.count + i] = -slopes[:, k] / base * chain, 1.0
                table.append(row)
        return np.array(margins), np.array(table).reshape(len(margins), len(z))


def search(
    problem: DesignProblem,
    *,
    starts: int = 1,
    seed: int = 0,
    begin: Array | None = None,
    precision: float = _FINE,
) -> SearchResult:
    """Search from the rig's own values (or ``begin``, SI) and from further points; return the best valid result.

    The search ends when the objective changes by less than ``precision`` (1) between steps.
    """
    if not 1 <= starts <= _MOST_STARTS:
        raise FitError(
            "invalid number of searches",
            where="starts",
            found=starts,
            allowed=Phrase("1 to {most_starts}", most_starts=_MOST_STARTS),
        )
    first = problem.start if begin is None else begin
    points = [first]
    if starts > 1:
        from scipy.stats import qmc

        spread = qmc.LatinHypercube(len(first), seed=seed).random(starts - 1)
        points += [Scale(problem).values(point) for point in spread]
    results = [_run_slsqp(problem, point, precision) for point in points]
    if all(result.violation > _ACTIVE for result in results):
        results.append(_run_slsqp(problem, least_violation(problem), precision))
    best = min(results, key=lambda result: (max(result.violation, _ACTIVE), result.objective))
    return _refine_at_kink(problem, best) if problem.has_kinks else best


_NEAR, _NEARER, _MOST_NEAR = (
    0.05,
    1e-5,
    60,
)  # scaled steps of the search around a kink, and evaluations per variable


def _refine_at_kink(problem: DesignProblem, best: SearchResult) -> SearchResult:
    """Refine the result of a gradient search without gradients (COBYLA), since it may have stopped at a kink."""
    from scipy.optimize import minimize

    scale = Scale(problem)
    count = len(problem.free)

    def margins(u: Array) -> Array:
        rows = [margin for _, _, _, margin, _ in problem.margins(scale.values(u))]
        return np.asarray([*rows, *u, *(1.0 - u)])

    result = minimize(
        lambda u: problem.objective(scale.values(u))[0], scale.normalise(best.values), method="COBYLA",
        constraints=[{"type": "ineq", "fun": margins}], tol=_NEARER,
        options={"rhobeg": _NEAR, "maxiter": _MOST_NEAR * count},
    )  # fmt: skip
    values = scale.values(np.clip(np.asarray(result.x), 0.0, 1.0))
    objective, violation = problem.objective(values)[0], violation_of(problem, values)
    iterations = best.iterations + int(result.nfev)
    if objective < best.objective and violation <= max(best.violation, _KEPT):
        return SearchResult(values, objective, violation, iterations, bool(result.success))
    return SearchResult(
        best.values, best.objective, best.violation, iterations, bool(result.success)
    )


def _run_slsqp(problem: DesignProblem, begin: Array, precision: float) -> SearchResult:
    from scipy.optimize import minimize

    task = _SlsqpProblem(problem)
    z = task.begin(begin)
    constraints: list[dict[str, Any]] = []
    if problem.limits or task.worst:
        constraints.append(
            {
                "type": "ineq",
                "fun": lambda z: task.margins(z)[0],
                "jac": lambda z: task.margins(z)[1],
            }
        )
    bounds = [(0.0, 1.0)] * task.count + [(0.0, None)] * len(task.worst)
    iterations = 0
    for _ in range(
        3
    ):  # a restart resets the curvature estimate of SLSQP, which helps after a stall
        result = minimize(
            task.objective, z, jac=True, method="SLSQP", bounds=bounds, constraints=constraints,
            options={"ftol": precision, "maxiter": _MOST},
        )  # fmt: skip
        iterations += int(result.nit)
        z = np.asarray(result.x) if np.all(np.isfinite(result.x)) else z
        if is_optimal(problem, task.scale.values(z[: task.count])).holds:
            break
    values = task.scale.values(z[: task.count])
    return SearchResult(
        values, problem.objective(values)[0], violation_of(problem, values), iterations
    )


def violation_of(problem: DesignProblem, values: Array) -> float:
    """Return the largest relative violation (1) of a limit; 0 if all are met."""
    return max((-margin for _, _, _, margin, _ in problem.margins(values)), default=0.0)


def least_violation(problem: DesignProblem) -> Array:
    """Find the values (SI) within the bounds with the smallest violation of the limits."""
    from scipy.optimize import minimize

    scale = Scale(problem)
    count = len(problem.free)

    def margins(z: Array) -> Array:
        margin_values = [margin for _, _, _, margin, _ in problem.margins(scale.values(z[:count]))]
        return np.asarray(np.array(margin_values) + z[count])

    def slopes(z: Array) -> Array:
        chain = scale.slopes(z[:count])
        rows = [slope * chain for _, _, _, _, slope in problem.margins(scale.values(z[:count]))]
        return np.hstack([np.array(rows), np.ones((len(rows), 1))])

    best: Array = problem.start
    least = np.inf
    for u in (
        scale.normalise(problem.start),
        np.full(count, 0.5),
        np.full(count, 0.1),
        np.full(count, 0.9),
    ):
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
    """Check the Karush-Kuhn-Tucker conditions at given values (SI), in scaled variables."""
    from scipy.optimize import nnls

    task = _SlsqpProblem(problem)
    z = task.begin(values)
    _, slope = task.objective(z)
    margins, table = task.margins(z)
    names = [
        (limit.metric.text, channel, side) for limit, channel, side, _, _ in problem.margins(values)
    ]
    active = [i for i in range(len(margins)) if margins[i] < _ACTIVE]
    walls = [_wall(i, z[i], len(z)) for i in range(task.count)]
    columns = [table[i] for i in active] + [wall for wall in walls if wall is not None]
    if not columns:
        holds = float(np.max(np.abs(slope), initial=0.0)) <= _STATIONARY
        return Conditions(holds, {})
    table = np.array(columns)
    small = _EVEN * np.eye(len(table))  # equivalent limits share their multiplier
    multipliers, _ = nnls(
        np.vstack([table.T, small]), np.concatenate([slope, np.zeros(len(table))])
    )
    left = float(np.linalg.norm(multipliers @ table - slope))
    gains = {names[i]: float(multipliers[k]) for k, i in enumerate(active) if i < len(names)}
    return Conditions(bool(left <= _STATIONARY and violation_of(problem, values) <= _ACTIVE), gains)


def _wall(i: int, u: float, count: int) -> Array | None:
    """Return the inward direction if a variable is on one of its bounds, otherwise None."""
    row = np.zeros(count)
    row[i] = 1.0 if u < 1e-6 else -1.0 if u > 1.0 - 1e-6 else 0.0
    return row if row.any() else None


_AT_BOUND = 1e-6  # of the range
_KEPT = 1e-6  # share of a limit that rounding of a search may break
_ONE_PERCENT = (
    0.01  # rise of the objective that is neglected, a choice: with 2 % ranges are about 40 % wider
)
_HALVINGS = 20  # at most: half the range is then known to a millionth
_STEPS = tuple(0.5**k for k in range(6, -1, -1))


@dataclass(frozen=True)
class DesignNumber:
    """A free parameter of a design, SI.

    Attributes
    ----------
    path, unit : str
        Path in the rig; SI unit.
    start, value, lower, upper : float
        Value before and after, and bounds, in that unit.
    at : str
        ``"lower"`` or ``"upper"`` if it ended at a bound.
    sensitivity : float
        Relative change of the objective per relative change of the parameter (1), the others fixed.
    flat : tuple of float or None
        Range in which the objective rises by at most 1 % and every limit is met, the other parameters fixed; None if
        the design is judged by simulated trials or several cases.
    """

    path: str
    unit: str
    start: float
    value: float
    lower: float
    upper: float
    at: Literal["", "lower", "upper"]
    sensitivity: float
    flat: tuple[float, float] | None


@dataclass(frozen=True)
class DesignConstraint:
    """A limit of a design in one channel, SI.

    Attributes
    ----------
    name, channel, unit : str
        Metric, channel and SI unit.
    start, value : float
        Value before and after, in that unit.
    lower, upper : float or None
        Limits in that unit.
    is_active : bool
        Whether the limit restricts the design.
    gain : float
        Relative improvement of the objective per relative relaxation of the limit (1); 0 if it is not active.
    """

    name: str
    channel: str
    unit: str
    start: float
    value: float
    lower: float | None
    upper: float | None
    is_active: bool
    gain: float


@dataclass(frozen=True)
class Optimisation(Plain):
    """The best design found, SI.

    Attributes
    ----------
    rig : Rig
        Rig with the parameters found.
    numbers : tuple of DesignNumber
        Free numbers.
    objective : dict
        Metric to its weight (1).
    value : float
        Objective relative to its initial value (1): weighted mean of the squared metrics, each relative to its start.
    before, after : dict
        Metric to its value, SI.
    units : dict
        Metric to its SI unit.
    constraints : tuple of DesignConstraint
        Every limit.
    converged : bool
        Whether the conditions of an optimum hold (to 1e-4 of the objective).
    iterations, evaluations : int
        Iterations of the optimiser; designs evaluated.
    derivatives : str
        ``"exact"``, or ``"differences"`` for mechanisms on random roads.
    driven : str
        Road or cases on which the design was evaluated.
    findings : tuple of Finding
        Bounds that were reached, flat objectives, effects that the linear model neglects.
    """

    left_out = ("rig",)
    also = ("values",)

    rig: Rig
    numbers: tuple[DesignNumber, ...]
    objective: dict[str, float]
    value: float
    before: dict[str, float]
    after: dict[str, float]
    units: dict[str, str]
    constraints: tuple[DesignConstraint, ...]
    converged: bool
    iterations: int
    evaluations: int
    derivatives: Literal["exact", "differences"]
    driven: str
    findings: tuple[Finding, ...]

    def __str__(self) -> str:
        rows = [["", "start", "best", "unit", ""]]
        for item in self.numbers:
            at = f"at its {item.at} bound" if item.at else ""
            rows.append([item.path, f"{item.start:.5g}", f"{item.value:.5g}", item.unit, at])
        for name in self.objective:
            change = f"{100.0 * (self.after[name] / self.before[name] - 1.0):+.1f} %"
            rows.append(
                [
                    name,
                    f"{self.before[name]:.5g}",
                    f"{self.after[name]:.5g}",
                    self.units[name],
                    change,
                ]
            )
        for limit in self.constraints:
            active = "at its limit" if limit.is_active else ""
            words = (
                limit.channel
                if limit.channel.endswith(limit.name)
                else f"{limit.name}, {limit.channel}"
            )
            rows.append([words, f"{limit.start:.5g}", f"{limit.value:.5g}", limit.unit, active])
        end = "converged" if self.converged else "did not converge"
        head = f"Best design on {self.driven}: {end}, {self.evaluations} designs"
        return "\n".join(
            [head, *(line.rstrip() for line in align_columns(rows)), *map(str, self.findings)]
        )

    @property
    def values(self) -> dict[str, float]:
        """Free numbers by path, SI."""
        return {number.path: number.value for number in self.numbers}


def optimise(  # noqa: PLR0913 - each is a choice of its own
    rig: Rig | str | Path,
    free: Mapping[str, Bounds],
    objective: Objective,
    constraints: Mapping[str, LimitGiven] | None = None,
    *,
    road: str | float | Density | None = None,
    speed: float | str | None = None,
    trial: Trial | None = None,
    band: tuple[float, float] | Literal["iso"] | None = None,
    sides: Sides | None = None,
    starts: int = 1,
    cases: Mapping[str, Case] | None = None,
    spread: Mapping[str, Spread] | None = None,
    samples: int = 32,
    seed: int = 1,
) -> Optimisation:
    """Find the parameters of a rig that minimise an objective within bounds and limits.

    Metrics are written as words: ``"sprung.az"`` (r.m.s. about rest), ``"sprung.az weighted"`` (by Wk, or by any
    weighting by its name), ``"tyre.force coefficient"`` (r.m.s. over the static value), ``"strut.deflection static"``,
    ``"mode 1 frequency"``, ``"mode 2 damping_ratio"``. A channel name without its corner selects that channel of all
    corners: an objective takes their root mean square (``"worst tyre.force"`` takes the largest), a constraint applies
    to each.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name in the library: where the search starts.
    free : mapping
        Path to its bounds: ``(lower, upper)`` with units or in SI, or a range around the start as ``"±30 %"``.
    objective : str or mapping
        Metric, or metrics to weights (1). The weighted mean of the squared metrics is minimised, each relative to its
        initial value.
    constraints : mapping, optional
        Metric to its upper limit (``"20 mm"``, or a number in SI), its lower limit (``">= 1.2 Hz"``), or a pair of
        both.
    road : str, float or callable, optional
        Random road, as for :func:`stationary`: class, degree of roughness in m^3, or density.
    speed : float or str, optional
        Speed on that road, m/s.
    trial : Trial, optional
        A trial to simulate instead of road and speed, with lift-off, stops and friction; r.m.s. values are about the
        state of rest at its start.
    band : tuple of float or "iso", optional
        Spatial frequencies of the road, 1/m. By default white noise where all metrics are finite on it, otherwise the
        band of ISO 8608.
    sides : str, optional
        Relation of the left and right tracks, as for :func:`stationary`.
    starts : int
        Number of searches; the first starts from the rig, the others from points spread over the bounds.
    cases : mapping, optional
        Several roads or trials by name, evaluated together instead of a single one: a :class:`jounce.Trial`,
        ``{"road": ..., "speed": ...}`` (m/s), or ``{"travel": ["-30 mm", "30 mm"]}`` for kinematics of a 3-D corner.
        Metrics are then prefixed with the name of the case: ``"rough: sprung.az weighted"``, ``"corner: range toe"``
        (``range``, ``max`` or ``min`` of a quantity of the catalogue over the travel; without such a word, its value at
        design).
    spread : mapping, optional
        Path to its spread in production or in use, as for :func:`jounce.sobol`. Each design is then evaluated over
        ``samples`` of the spread, the same for all designs: ``"rough: p95 tyre.force coefficient"`` is the 95th
        percentile; without ``p95`` the mean is used. If a free parameter has a spread, its value is multiplied by each
        sample.
    samples : int
        Number of samples of the spread, 2 to 4096; preferably a power of 2.
    seed : int
        Seed of the samples.

    Returns
    -------
    Optimisation
        SI.

    Raises
    ------
    DescriptionError
        For an unknown metric or path, equal bounds, or invalid limits.
    FitError
        If no design within the bounds meets the limits; the message states the smallest violation found.

    Notes
    -----
    Uses SciPy's SLSQP with exact gradients: Lyapunov equations and integrals over the spectrum are differentiated, and
    simulated trials include sensitivity equations. For mechanisms on random roads the gradients are fourth-order finite
    differences.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.load("audi-a6-quarter-car").with_changes({"tyre.damping_coefficient": 0.0})
    >>> best = optimise(car, {"strut.damper.coefficient": (500.0, 5000.0)}, "sprung.az", road="C", speed="20 m/s")
    >>> round(best.values["strut.damper.coefficient"], 1)   # k sqrt((m_s + m_u) / k_t)
    1559.1
    """
    given = {"road": road, "speed": speed, "trial": trial, "band": band, "sides": sides}
    problem = task_of(
        as_rig(rig), free, objective, constraints, given, cases, spread, samples, seed
    )
    with report_work(
        lambda: Phrase(
            "searching for the best design: {judged} evaluated", judged=problem.evaluations
        )
    ):
        result = search(problem, starts=starts)
        check_kept(problem, result)
        return outcome(problem, result)


def task_of(
    rig: Rig, free: Mapping[str, Bounds], objective: Objective, constraints: Mapping[str, LimitGiven] | None,
    given: Mapping[str, Any], cases: Mapping[str, Case] | None, spread: Mapping[str, Spread] | None, samples: int,
    seed: int, more: Sequence[str] = (),
) -> DesignProblem:  # fmt: skip
    """Return the design task for one road or trial, or for several cases and samples."""
    if cases is None and spread is None:
        return design_problem(rig, free, objective, constraints, more=more, **given)
    chosen = {name: value for name, value in given.items() if value is not None}
    if cases is not None and chosen:
        raise DescriptionError(
            "cases have their own roads",
            where=next(iter(chosen)),
            hint="Give either cases or a road.",
        )
    if cases is None:
        trial = chosen.pop("trial", None)
        if trial is not None and chosen:
            raise DescriptionError("a trial has its own road", where=next(iter(chosen)))
        cases = {"all": trial if trial is not None else chosen}
    return cases_problem(
        rig,
        free,
        objective,
        constraints,
        cases=cases,
        spread=spread,
        samples=samples,
        seed=seed,
        more=more,
    )


def check_kept(problem: DesignProblem, result: SearchResult) -> None:
    """Raise an error if the search result violates limits, naming the worst one at the smallest violation."""
    if result.violation <= _KEPT:
        return
    values = least_violation(problem)
    broken = min(problem.margins(values), key=lambda margin: margin[3])
    limit, channel, side, _, _ = broken
    numbers, _ = problem.numbers(values)[limit.metric.text]
    reached = float(numbers[limit.metric.channels.index(channel)])
    bound = limit.upper if side == "upper" else limit.lower
    design = ", ".join(
        f"{free.path} = {value:.5g}" for free, value in zip(problem.free, values, strict=True)
    )
    unit = "" if limit.metric.unit == "1" else f" {limit.metric.unit}"
    raise FitError(
        "no design within the bounds meets all limits",
        where=f"constraints: {channel if channel.endswith(limit.metric.text) else limit.metric.text}",
        found=f"{reached:.4g}{unit}",
        allowed=f"{'at most' if side == 'upper' else 'at least'} {bound:.4g}{unit}",
        hint=Phrase(
            "The violation is smallest at {design}; relax the limits or widen the bounds.",
            design=design,
        ),
    )


def outcome(problem: DesignProblem, result: SearchResult) -> Optimisation:
    """Describe a design, compare it with the start, and list the active limits."""
    values = result.values
    conditions = is_optimal(problem, values)
    value, slopes = problem.objective(values)
    numbers = tuple(_number(problem, i, values, value, slopes) for i in range(len(values)))
    constraints = tuple(_constraints(problem, values, conditions.gains, value))
    best = problem.with_values(values)
    findings = [
        *problem.notes,
        *_findings(problem, numbers, converged=conditions.holds or result.settled),
    ]
    if isinstance(problem.evaluator, StationaryEvaluator):
        findings += _linear(problem, best)
    before, after = (
        {text: problem.whole(text, at)[0] for text in problem.metrics}
        for at in (problem.start, values)
    )
    units = {text: metric.unit for text, metric in problem.metrics.items()}
    return Optimisation(
        best, numbers, problem.weights, value, before, after, units, constraints, conditions.holds or result.settled,
        result.iterations, problem.evaluations, "exact" if problem.evaluator.is_exact else "differences",
        road_in_words(problem), tuple(findings),
    )  # fmt: skip


def road_in_words(problem: DesignProblem) -> str:
    """Describe in words the road or the cases on which a design is evaluated."""
    if problem.driven:
        return problem.driven
    surface = problem.surface
    if surface is None:
        return "a simulated trial"
    road = (
        "a given spectrum"
        if surface.roughness is None
        else f"G_d(n0) = {surface.roughness * 1e6:.4g}e-6 m^3"
    )
    waves = (
        "all waves"
        if surface.band is None
        else f"waves of {surface.band[0]:g} to {surface.band[1]:g} 1/m"
    )
    return f"random road, {road}, {surface.speed:g} m/s, {waves}"


def _number(
    problem: DesignProblem, i: int, values: Array, objective: float, slopes: Array
) -> DesignNumber:
    free, value = problem.free[i], float(values[i])
    room = _AT_BOUND * (free.upper - free.lower)
    at: Literal["", "lower", "upper"] = ""
    if value - free.lower <= room:
        at = "lower"
    elif free.upper - value <= room:
        at = "upper"
    flat = _flat_range(problem, i, values, objective) if problem.surface is not None else None
    unit, sensitivity = unit_of(problem.rig, free.path), float(value * slopes[i] / objective)
    return DesignNumber(
        free.path, unit, free.initial, value, free.lower, free.upper, at, sensitivity, flat
    )


def _flat_range(
    problem: DesignProblem, i: int, values: Array, objective: float
) -> tuple[float, float]:
    """Return the range of a variable, within its bounds, with all limits met and at most 1 % rise of the objective."""
    broken = -min([0.0, *(margin[3] for margin in problem.margins(values))])

    def is_as_good(value: float) -> bool:
        moved = values.copy()
        moved[i] = value
        if problem.objective(moved)[0] > (1.0 + _ONE_PERCENT) * objective:
            return False
        return all(margin[3] >= -max(_KEPT, broken) for margin in problem.margins(moved))

    best = float(values[i])
    return _reach(best, problem.free[i].lower, is_as_good), _reach(
        best, problem.free[i].upper, is_as_good
    )


def _reach(start: float, bound: float, is_as_good: Callable[[float], bool]) -> float:
    """Find how far ``start`` can move towards ``bound`` without loss: growing steps, then bisection of the last one."""
    near = far = start
    for share in _STEPS if bound != start else ():
        far = start + share * (bound - start)
        if not is_as_good(far):
            break
        near = far
    for _ in range(_HALVINGS if near != far else 0):
        middle = 0.5 * (near + far)
        near, far = (middle, far) if is_as_good(middle) else (near, middle)
        if abs(far - near) < 1e-3 * abs(start):
            break
    return near


def _constraints(
    problem: DesignProblem,
    values: Array,
    gains: dict[tuple[str, str, str], float],
    objective: float,
) -> list[DesignConstraint]:
    constraints = []
    for limit in problem.limits:
        before, after = (
            problem.numbers(at)[limit.metric.text][0] for at in (problem.start, values)
        )
        for i, channel in enumerate(limit.metric.channels):
            sides = [gains.get((limit.metric.text, channel, side)) for side in ("lower", "upper")]
            active = [gain for gain in sides if gain is not None]
            constraints.append(
                DesignConstraint(
                    limit.metric.text, channel, limit.metric.unit, float(before[i]), float(after[i]),
                    limit.lower, limit.upper, bool(active), max(active, default=0.0) / objective,
                )
            )  # fmt: skip
    return constraints


def _findings(
    problem: DesignProblem, numbers: tuple[DesignNumber, ...], *, converged: bool
) -> list[Finding]:
    findings = []
    if not converged:
        findings.append(finding("design.no_optimum", "optimise"))
    for number in numbers:
        if number.at:
            findings.append(finding("design.at_bound", number.path, number.value, bound=number.at))
        if number.flat == (number.lower, number.upper):
            findings.append(finding("design.little_influence", number.path, number.value))
    value = problem.objective(np.array([number.value for number in numbers]))[0]
    if value > 1.0 - 1e-6:  # it is 1 at the start
        given = problem.numbers(problem.start)
        is_broken = any(_is_broken(limit, given[limit.metric.text][0]) for limit in problem.limits)
        code = "design.start_breaks_limit" if is_broken else "design.start_is_best"
        findings.append(finding(code, "optimise", value, cost=value - 1.0))
    return findings


def _is_broken(limit: Any, values: Array) -> bool:
    low = -np.inf if limit.lower is None else limit.lower - 1e-9 * abs(limit.lower)
    high = np.inf if limit.upper is None else limit.upper + 1e-9 * abs(limit.upper)
    return bool(np.any((values < low) | (values > high)))


def _linear(problem: DesignProblem, best: Rig) -> list[Finding]:
    """Report effects on the best design that the linear model neglects."""
    from jounce.ride.covariance import RandomVibration, Signal
    from jounce.ride.family import Families, LinearFamily

    assert problem.surface is not None
    family = LinearFamily(best)
    names = family.compiled.output_names
    wanted = [
        i for i, name in enumerate(names) if name.endswith(("tyre.force", "strut.deflection"))
    ]
    moments = RandomVibration(
        Families((family,)), problem.surface, tuple(Signal(i) for i in wanted)
    ).at(slopes=False)
    there = [k for k in range(len(wanted)) if k not in moments.absent]
    sigma = {names[wanted[k]]: float(np.sqrt(max(moments.variances[0, k], 0.0))) for k in there}
    return linear_findings(
        best, sigma, {names[wanted[k]]: float(moments.static[0, k]) for k in there}
    )
