"""A design task in numbers: free numbers within bounds, an objective, limits, all with slopes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError, FitError
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.design.metrics import (
    Evaluator,
    Metric,
    Numbers,
    StationaryEvaluator,
    TrialEvaluator,
    combined,
    read_metric,
    units_of,
)
from jounce.identify.fit_problem import Bounds, Free, free_parameters
from jounce.parts import Rig
from jounce.ride.family import LinearFamily
from jounce.ride.surface import Surface, surface
from jounce.roads import Trial

Objective = str | Mapping[str, float]
Bound = str | float | None
LimitGiven = Bound | tuple[Bound, Bound] | list[Bound]


@dataclass(frozen=True)
class Limit:
    """What a metric may be, in each of its channels or (``is_whole``) all together, SI; None where a side is open."""

    metric: Metric
    lower: float | None
    upper: float | None
    is_whole: bool = False


@dataclass(frozen=True)
class DesignProblem:
    """A design task.

    Attributes
    ----------
    rig : Rig
        Where it starts.
    free : tuple of Free
        What may vary.
    weights : dict
        Metric of the objective to its weight (1).
    limits : tuple of Limit
        Constraints.
    evaluator : Evaluator
        Gives the metrics.
    metrics : dict
        All metrics by their text.
    surface : Surface or None
        Road of a stationary response.
    trial : Trial or None
        What is simulated otherwise.
    notes : tuple of Finding
        What was decided on the way.
    base : dict
        Metric of the objective to its value at the start, SI.
    """

    rig: Rig
    free: tuple[Free, ...]
    weights: dict[str, float]
    limits: tuple[Limit, ...]
    evaluator: Evaluator
    metrics: dict[str, Metric]
    surface: Surface | None
    trial: Trial | None
    notes: tuple[Finding, ...] = ()
    base: dict[str, float] = field(default_factory=dict)
    _memory: dict[bytes, dict[str, Numbers]] = field(default_factory=dict, repr=False)

    @property
    def start(self) -> Array:
        """Values of the rig, SI."""
        return np.array([free.initial for free in self.free])

    @property
    def evaluations(self) -> int:
        """How many designs were judged."""
        return len(self._memory)

    def numbers(self, values: Array) -> dict[str, Numbers]:
        """All metrics at some values (SI) of the free numbers, with slopes."""
        key = np.asarray(values, dtype=float).tobytes()
        if key not in self._memory:
            self._memory[key] = self.evaluator.at(np.asarray(values, dtype=float))
        return self._memory[key]

    def whole(self, text: str, values: Array) -> tuple[float, Array]:
        """One number of a metric over all its channels, and its slopes, SI."""
        return combined(self.metrics[text], self.numbers(values)[text])

    def objective(self, values: Array) -> tuple[float, Array]:
        """Objective over that of the start (1), and its slopes per SI unit of the free numbers."""
        total, slopes = 0.0, np.zeros(len(self.free))
        for text, weight in self.weights.items():
            number, along = self.whole(text, values)
            share = weight / (self.base[text] ** 2 * sum(self.weights.values()))
            total += share * number**2
            slopes = slopes + 2.0 * share * number * along
        return total, slopes

    def with_values(self, values: Array) -> Rig:
        """The rig with other values (SI) of the free numbers."""
        return self.rig.with_changes(dict(zip([free.path for free in self.free], map(float, values), strict=True)))

    def margins(self, values: Array) -> list[tuple[Limit, str, str, float, Array]]:
        """For each side of each limit and channel how far it is kept, relative to the limit, with slopes."""
        found = []
        for limit in self.limits:
            numbers, slopes = self.numbers(values)[limit.metric.text]
            channels: tuple[str, ...] = limit.metric.channels
            if limit.is_whole:
                number, along = combined(limit.metric, (numbers, slopes))
                numbers, slopes, channels = np.array([number]), along[:, None], (limit.metric.text,)
            for i, channel in enumerate(channels):
                for side, bound, sign in (("lower", limit.lower, 1.0), ("upper", limit.upper, -1.0)):
                    if bound is not None:
                        size = abs(bound) or abs(self.base_of(limit.metric)) or 1.0
                        margin = sign * (float(numbers[i]) - bound) / size
                        found.append((limit, channel, side, margin, sign * slopes[:, i] / size))
        return found

    def base_of(self, metric: Metric) -> float:
        """Value of a metric at the start, SI."""
        return self.whole(metric.text, self.start)[0]


def design_problem(
    rig: Rig,
    free: Mapping[str, Bounds],
    objective: Objective,
    constraints: Mapping[str, LimitGiven] | None = None,
    *,
    road: Any = None,
    speed: float | str | None = None,
    trial: Trial | None = None,
    more: Sequence[str] = (),
    **settings: Any,
) -> DesignProblem:
    """Read a design task; ``more`` are further metrics to be known, ``settings`` those of the road (SI or texts).

    Raises
    ------
    DescriptionError, FitError
        For anything that cannot be understood or does not fit the rig.
    """
    numbers = free_parameters(rig, {path: _relative(bounds) for path, bounds in free.items()}, where="free")
    units = units_of(rig)
    weights = _weights(objective)
    metrics = {text: read_metric(text, units, where="objective") for text in weights}
    limits = []
    for text, given in (constraints or {}).items():
        metrics[text] = read_metric(text, units, where="constraints")
        limits.append(_limit(metrics[text], given))
    metrics |= {text: read_metric(text, units, where="metrics") for text in more}
    family = LinearFamily(rig, tuple(number.path for number in numbers))
    _check_used(family)
    _check_bounds(rig, numbers)
    evaluator: Evaluator
    road_surface: Surface | None = None
    notes: tuple[Finding, ...] = ()
    if trial is not None:
        _refuse_both(road, speed, settings)
        evaluator = TrialEvaluator(family, trial, tuple(metrics.values()))
    else:
        evaluator, notes = _stationary(family, tuple(metrics.values()), road, speed, settings)
        road_surface = evaluator.surface
    problem = DesignProblem(rig, numbers, weights, tuple(limits), evaluator, metrics, road_surface, trial, notes)
    for text in weights:
        base = problem.base_of(metrics[text])
        if not (np.isfinite(base) and base != 0.0):
            raise FitError(
                "is zero before anything is changed, so there is nothing to lower", where=f"objective: {text}"
            )
        problem.base[text] = base
    return problem


def _relative(bounds: Bounds) -> Bounds:
    return bounds.replace("±", "").replace("+-", "").strip() if isinstance(bounds, str) else bounds


def _weights(objective: Objective) -> dict[str, float]:
    given = {objective: 1.0} if isinstance(objective, str) else dict(objective)
    if not given:
        raise DescriptionError("no objective", where="objective", hint='Give one, e.g. {"sprung.az": 1.0}.')
    every: Mapping[str, object] = given  # what callers give is not always what they should
    for text, number in every.items():
        is_number = isinstance(number, (int, float)) and not isinstance(number, bool)
        if not (is_number and np.isfinite(given[text]) and given[text] > 0.0):
            raise DescriptionError("not a weight", where=f"objective: {text}", found=number, allowed="above 0")
    return {text: float(weight) for text, weight in given.items()}


def _limit(metric: Metric, given: LimitGiven) -> Limit:
    where = f"constraints: {metric.text}"
    if isinstance(given, (tuple, list)):
        if len(given) != 2:
            raise DescriptionError("not limits", where=where, found=list(given), allowed="a value, or (lower, upper)")
        lower, upper = (None if side is None else to_si(side, metric.unit, where=where) for side in given)
    else:
        text = given.strip() if isinstance(given, str) else given
        is_lower = isinstance(text, str) and text.startswith(">")
        if isinstance(text, str):
            text = text.lstrip("<>= ")
        if text is None:
            raise DescriptionError("no limit", where=where, allowed="a value, or (lower, upper)")
        bound = to_si(_number(text), metric.unit, where=where)
        lower, upper = (bound, None) if is_lower else (None, bound)
    if lower is None and upper is None:
        raise DescriptionError("no limit", where=where, allowed="a value, or (lower, upper)")
    if lower is not None and upper is not None and lower > upper:
        raise DescriptionError("the lower limit lies above the upper", where=where, found=f"{lower:g}, {upper:g}")
    return Limit(metric, lower, upper)


def _number(text: str | float) -> str | float:
    try:
        return float(text)
    except ValueError:
        return text


def _check_used(family: LinearFamily) -> None:
    used = family.compiled.facts.parameters
    for path in family.paths:
        if path not in used:
            raise DescriptionError(
                "the model does not feel this number", where=f"free: {path}", allowed=", ".join(sorted(used))
            )


def _check_bounds(rig: Rig, numbers: Sequence[Free]) -> None:
    """Refuse bounds that the description does not allow."""
    for number in numbers:
        for value in (number.lower, number.upper):
            rig.with_changes({number.path: value})


def _refuse_both(road: Any, speed: float | str | None, settings: Mapping[str, Any]) -> None:
    given = {"road": road, "speed": speed, **settings}
    for name, value in given.items():
        if value is not None:
            raise DescriptionError(
                "a trial brings its own road", where=name, hint="Give either trial or road and speed."
            )


def _stationary(
    family: LinearFamily,
    metrics: tuple[Metric, ...],
    road: Any,
    speed: float | str | None,
    settings: dict[str, Any],
) -> tuple[StationaryEvaluator, tuple[Finding, ...]]:
    """Metrics on a road: white noise where all of them are finite there, otherwise over the band of ISO 8608."""
    if road is None or speed is None:
        missing = "road" if road is None else "speed"
        raise DescriptionError(f"no {missing}", where=missing, hint='Give road="C" and speed="20 m/s", or a trial.')
    given = {name: value for name, value in settings.items() if value is not None}
    reasons: dict[str, str] = {}
    for metric in metrics:
        if metric.weighting:
            reasons[metric.text] = "a weighting is a matter of frequencies"
    is_white = given.get("band") is None and not callable(road)
    if is_white and not reasons:
        evaluator = StationaryEvaluator(family, surface(road, speed, **given), metrics)
        reasons = evaluator.absent()
        if not reasons:
            return evaluator, ()
    if not is_white:
        return StationaryEvaluator(family, surface(road, speed, **given), metrics), ()
    evaluator = StationaryEvaluator(family, surface(road, speed, **{**given, "band": "iso"}), metrics)
    text, reason = next(iter(reasons.items()))
    note = Finding(text, "note", f"{reason}; waves of 0.011 to 2.83 1/m are taken instead of white noise.")
    return evaluator, (note,)
