"""Find the numbers of a rig that serve an objective best within bounds and limits, with exact slopes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from jounce.core.errors import FitError
from jounce.core.findings import Finding
from jounce.core.serialise import to_plain
from jounce.core.types import Array
from jounce.design.metrics import StationaryEvaluator
from jounce.design.problem import DesignProblem, LimitGiven, Objective, design_problem
from jounce.design.search import Search, is_optimal, least_violation, search
from jounce.design.text import optimisation_text
from jounce.identify.fit_problem import Bounds
from jounce.parts import Rig
from jounce.parts.rig import unit_of
from jounce.ride.stationary import linear_findings
from jounce.ride.surface import Density, Sides
from jounce.roads import Trial

_AT_BOUND = 1e-6
_KEPT = 1e-6
_ONE_PERCENT = 0.01
_HALVINGS = 20
_STEPS = tuple(0.5**k for k in range(6, -1, -1))


@dataclass(frozen=True)
class DesignNumber:
    """One free number of a design, SI.

    Attributes
    ----------
    path, unit : str
        Where it is in the rig; SI unit.
    start, value, lower, upper : float
        In that unit: before, after, bounds.
    at : str
        ``"lower"`` or ``"upper"`` where it ended at a bound.
    sensitivity : float
        Relative change of the objective for a relative change of the number (1), the others kept.
    flat : tuple of float or None
        Within this range the objective rises by at most 1 % and every limit holds, the others kept; None for trials.
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
    """One limit of a design in one channel, SI.

    Attributes
    ----------
    name, channel, unit : str
        Metric, channel and SI unit.
    start, value : float
        Before and after, in that unit.
    lower, upper : float or None
        Limits in that unit.
    is_active : bool
        Whether it holds the design back.
    gain : float
        Relative gain of the objective for a relative loosening of the limit (1): 0 where it is not active.
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
class Optimisation:
    """The best design found, SI.

    Attributes
    ----------
    rig : Rig
        With the numbers that were found.
    numbers : tuple of DesignNumber
        Free numbers.
    objective : dict
        Metric to its weight (1).
    value : float
        Objective over that of the start (1): weighted mean of the squared metrics, each relative to its start.
    before, after : dict
        Metric to its value, SI.
    constraints : tuple of DesignConstraint
        Every limit.
    converged : bool
        Whether the conditions of an optimum hold (to 1e-4 of the objective).
    iterations, evaluations : int
        Of the optimiser; designs judged.
    derivatives : str
        ``"exact"``, or ``"differences"`` for mechanisms on random roads.
    driven : str
        What it was judged on.
    findings : tuple of Finding
        Bounds that were hit, flat objectives, what the linear model does not know.
    """

    rig: Rig
    numbers: tuple[DesignNumber, ...]
    objective: dict[str, float]
    value: float
    before: dict[str, float]
    after: dict[str, float]
    constraints: tuple[DesignConstraint, ...]
    converged: bool
    iterations: int
    evaluations: int
    derivatives: Literal["exact", "differences"]
    driven: str
    findings: tuple[Finding, ...]

    def __str__(self) -> str:
        return optimisation_text(self)

    @property
    def values(self) -> dict[str, float]:
        """Free numbers by path, SI."""
        return {number.path: number.value for number in self.numbers}

    def to_dict(self) -> dict[str, Any]:
        """Give plain values, SI; the rig by its free numbers."""
        plain: dict[str, Any] = {name: to_plain(value) for name, value in vars(self).items() if name != "rig"}
        return {**plain, "values": to_plain(self.values)}


def optimise(
    rig: Rig,
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
) -> Optimisation:
    """Find the numbers of a rig with the least objective within bounds and limits.

    Metrics are written as words: ``"sprung.az"`` (r.m.s. about rest), ``"sprung.az weighted"`` (by Wk, or by any
    weighting by its name), ``"tyre.force coefficient"`` (r.m.s. over the static value), ``"strut.deflection static"``,
    ``"mode 1 frequency"``, ``"mode 2 damping_ratio"``. The last words of a channel stand for those of all corners:
    their root mean square in an objective (``"worst tyre.force"`` takes the largest), each of them in a constraint.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle: where the search starts.
    free : mapping
        Path to its bounds: ``(lower, upper)`` with units or in SI, or a range around the start as ``"±30 %"``.
    objective : str or mapping
        Metric, or metrics to weights (1). What is minimised is the weighted mean of the squared metrics, each over its
        value at the start.
    constraints : mapping, optional
        Metric to the most that it may be (``"20 mm"``, SI number), the least (``">= 1.2 Hz"``), or both as a pair.
    road : str, float or callable, optional
        Random road, as for :func:`stationary`: class, degree of roughness in m^3, or density.
    speed : float or str, optional
        On that road, m/s.
    trial : Trial, optional
        Instead of them a trial to simulate, lift-off, stops and friction included; r.m.s. about rest at its start.
    band : tuple of float or "iso", optional
        Spatial frequencies of the road, 1/m. By default white noise where all metrics are finite on it, otherwise the
        band of ISO 8608.
    sides : str, optional
        What left and right share, as for :func:`stationary`.
    starts : int
        Searches, the first from the rig, the others from points spread over the bounds.

    Returns
    -------
    Optimisation
        SI.

    Raises
    ------
    DescriptionError
        For an unknown metric or path, equal bounds, and values that are no limits.
    FitError
        When no design within the bounds keeps the limits, with the least that can be reached.

    Notes
    -----
    SciPy's SLSQP with exact slopes: Lyapunov equations and integrals over the spectrum are differentiated, simulated
    trials carry their sensitivities. Mechanisms on random roads take differences of fourth order.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.load("audi-a6-quarter-car").with_changes({"tyre.damping_coefficient": 0.0})
    >>> best = optimise(car, {"strut.damper.coefficient": (500.0, 5000.0)}, "sprung.az", road="C", speed="20 m/s")
    >>> round(best.values["strut.damper.coefficient"], 1)   # k sqrt((m_s + m_u) / k_t)
    1559.1
    """
    problem = design_problem(
        rig, free, objective, constraints,
        road=road, speed=speed, trial=trial, band=band, sides=sides,
    )  # fmt: skip
    found = search(problem, starts=starts)
    check_kept(problem, found)
    return outcome(problem, found)


def check_kept(problem: DesignProblem, found: Search) -> None:
    """Refuse a search that ended where limits are broken.

    Raises
    ------
    FitError
        Naming the limit that is broken most where all are broken least, and what it would have to be.
    """
    if found.violation <= _KEPT:
        return
    values = least_violation(problem)
    broken = min(problem.margins(values), key=lambda margin: margin[3])
    limit, channel, side, _, _ = broken
    numbers, _ = problem.numbers(values)[limit.metric.text]
    reached = float(numbers[limit.metric.channels.index(channel)])
    bound = limit.upper if side == "upper" else limit.lower
    design = ", ".join(f"{free.path} = {value:.5g}" for free, value in zip(problem.free, values, strict=True))
    unit = "" if limit.metric.unit == "1" else f" {limit.metric.unit}"
    raise FitError(
        "no design within the bounds keeps all limits",
        where=f"constraints: {channel if channel.endswith(limit.metric.text) else limit.metric.text}",
        found=f"{reached:.4g}{unit}",
        allowed=f"{'at most' if side == 'upper' else 'at least'} {bound:.4g}{unit}",
        hint=f"This is where the limits are broken least ({design}); loosen them or widen the bounds.",
    )


def outcome(problem: DesignProblem, found: Search) -> Optimisation:
    """Describe a design, how it compares with the start, and what holds it."""
    values = found.values
    conditions = is_optimal(problem, values)
    value, slopes = problem.objective(values)
    numbers = tuple(_number(problem, i, values, value, slopes) for i in range(len(values)))
    constraints = tuple(_constraints(problem, values, conditions.gains, value))
    best = problem.with_values(values)
    findings = [*problem.notes, *_findings(problem, numbers, converged=conditions.holds)]
    if isinstance(problem.evaluator, StationaryEvaluator):
        findings += _linear(problem, best)
    before, after = ({text: problem.whole(text, at)[0] for text in problem.metrics} for at in (problem.start, values))
    return Optimisation(
        best, numbers, problem.weights, value, before, after, constraints, conditions.holds, found.iterations,
        problem.evaluations, "exact" if problem.evaluator.is_exact else "differences", driven_over(problem),
        tuple(findings),
    )  # fmt: skip


def driven_over(problem: DesignProblem) -> str:
    """Say in words what a design is judged on."""
    surface = problem.surface
    if surface is None:
        return "a simulated trial"
    road = "a given spectrum" if surface.roughness is None else f"G_d(n0) = {surface.roughness * 1e6:.4g}e-6 m^3"
    waves = "all waves" if surface.band is None else f"waves of {surface.band[0]:g} to {surface.band[1]:g} 1/m"
    return f"random road, {road}, {surface.speed:g} m/s, {waves}"


def _number(problem: DesignProblem, i: int, values: Array, objective: float, slopes: Array) -> DesignNumber:
    free, value = problem.free[i], float(values[i])
    room = _AT_BOUND * (free.upper - free.lower)
    at: Literal["", "lower", "upper"] = ""
    if value - free.lower <= room:
        at = "lower"
    elif free.upper - value <= room:
        at = "upper"
    flat = _flat(problem, i, values, objective) if problem.trial is None else None
    unit, sensitivity = unit_of(problem.rig, free.path), float(value * slopes[i] / objective)
    return DesignNumber(free.path, unit, free.initial, value, free.lower, free.upper, at, sensitivity, flat)


def _flat(problem: DesignProblem, i: int, values: Array, objective: float) -> tuple[float, float]:
    """Range of a number, within its bounds, in which all limits hold and the objective rises by at most 1 %."""
    broken = -min([0.0, *(margin[3] for margin in problem.margins(values))])

    def is_as_good(value: float) -> bool:
        moved = values.copy()
        moved[i] = value
        if problem.objective(moved)[0] > (1.0 + _ONE_PERCENT) * objective:
            return False
        return all(margin[3] >= -max(_KEPT, broken) for margin in problem.margins(moved))

    best = float(values[i])
    return _reach(best, problem.free[i].lower, is_as_good), _reach(best, problem.free[i].upper, is_as_good)


def _reach(start: float, bound: float, is_as_good: Callable[[float], bool]) -> float:
    """How far from ``start`` to ``bound`` everything is as good: in growing steps, then by halving the last one."""
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
    problem: DesignProblem, values: Array, gains: dict[tuple[str, str, str], float], objective: float
) -> list[DesignConstraint]:
    found = []
    for limit in problem.limits:
        before, after = (problem.numbers(at)[limit.metric.text][0] for at in (problem.start, values))
        for i, channel in enumerate(limit.metric.channels):
            sides = [gains.get((limit.metric.text, channel, side)) for side in ("lower", "upper")]
            active = [gain for gain in sides if gain is not None]
            found.append(
                DesignConstraint(
                    limit.metric.text, channel, limit.metric.unit, float(before[i]), float(after[i]),
                    limit.lower, limit.upper, bool(active), max(active, default=0.0) / objective,
                )
            )  # fmt: skip
    return found


def _findings(problem: DesignProblem, numbers: tuple[DesignNumber, ...], *, converged: bool) -> list[Finding]:
    found = []
    if not converged:
        text = "the conditions of an optimum do not hold where the search ended; try more starts or narrower bounds."
        found.append(Finding("optimise", "warning", text))
    for number in numbers:
        if number.at:
            text = f"ended at its {number.at} bound; the objective would fall further beyond it."
            found.append(Finding(number.path, "warning", text, number.value))
        if number.flat == (number.lower, number.upper):
            text = "matters little: the objective stays within 1 %, and every limit holds, over its whole range."
            found.append(Finding(number.path, "note", text, number.value))
    value = problem.objective(np.array([number.value for number in numbers]))[0]
    if value > 1.0 - 1e-6:
        found.append(Finding("optimise", "note", "the start is as good as anything that was found.", value))
    return found


def _linear(problem: DesignProblem, best: Rig) -> list[Finding]:
    """What the linear model does not know of the best design."""
    from jounce.ride.covariance import Analysis, Signal
    from jounce.ride.family import LinearFamily

    assert problem.surface is not None
    family = LinearFamily(best)
    names = family.compiled.output_names
    wanted = [i for i, name in enumerate(names) if name.endswith(("tyre.force", "strut.deflection"))]
    moments = Analysis(family, problem.surface, tuple(Signal(i) for i in wanted)).at(slopes=False)
    there = [k for k in range(len(wanted)) if k not in moments.absent]
    sigma = {names[wanted[k]]: float(np.sqrt(max(moments.variances[k], 0.0))) for k in there}
    return linear_findings(best, sigma, {names[wanted[k]]: float(moments.rest[k]) for k in there})
