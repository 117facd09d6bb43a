"""Designs evaluated by several cases at once: random roads, trials and kinematics, over a spread of the parts.

A metric is prefixed with its case, ``"rough: sprung.az weighted"``, and, if parameters are spread, with a statistic:
``"rough: p95 tyre.force coefficient"``. All designs are evaluated over the same samples; sampling noise therefore
cancels in comparisons of designs.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError, FitError, unknown
from jounce.core.findings import Finding
from jounce.core.phrases import Phrase
from jounce.core.seeds import is_whole
from jounce.core.types import Array
from jounce.design.problem import (
    DesignProblem,
    LimitGiven,
    Metric,
    Numbers,
    Objective,
    StationaryEvaluator,
    TrialEvaluator,
    numbers_of,
    read_limit,
    read_metric,
    read_weights,
    stationary_evaluator,
    units_of,
)
from jounce.identify.fit_problem import Bounds, FreeParameter
from jounce.kinematics import sweep_travel
from jounce.kinematics.catalogue import CATALOGUE
from jounce.parts import Corner, Rig
from jounce.parts.rig import quantity_at, unit_of
from jounce.ride.family import Families, LinearFamily
from jounce.roads import Trial
from jounce.variants.designs import Spread, sobol

Case = Trial | Mapping[str, Any]
"""A trial, ``{"road": ..., "speed": ...}`` for a random road, or ``{"travel": [...]}`` for kinematics over it (m)."""
_STEP = 1e-6  # of a variable's range: step of central differences of kinematics
_MOST_SAMPLES = 4096  # of a spread; each is evaluated at every step of a search
_KINDS = ("value", "range", "max", "min")
_STATISTICS = ("mean", "p95")


@dataclass(frozen=True)
class KinematicEvaluator:
    """Evaluates a 3-D corner over wheel travel (m): value at design, range, maximum and minimum; by differences."""

    rig: Corner
    paths: tuple[str, ...]
    steps: Array
    travel: Array
    metrics: tuple[Metric, ...]

    @property
    def is_exact(self) -> bool:
        """Whether its slopes are exact."""
        return False

    def at(self, values: Array) -> dict[str, Numbers]:
        """Return every metric by its text: value and slopes, SI."""
        here = self._numbers(values)
        slopes = np.zeros((len(values), len(here)))
        for i, step in enumerate(self.steps):
            move = step * np.eye(len(values))[i]
            slopes[i] = (self._numbers(values + move) - self._numbers(values - move)) / (2.0 * step)
        return {m.text: (here[k : k + 1], slopes[:, k : k + 1]) for k, m in enumerate(self.metrics)}

    def _numbers(self, values: Array) -> Array:
        rig = self.rig.with_changes(dict(zip(self.paths, map(float, values), strict=True)))
        swept = sweep_travel(rig, self.travel)
        numbers = []
        for metric in self.metrics:
            curve = swept[metric.channels[0]].to_numpy()
            if not np.all(np.isfinite(curve)):
                raise FitError("the linkage does not cover the whole travel", where=metric.text)
            number = {
                "value": float(np.interp(0.0, self.travel, curve)), "range": float(np.ptp(curve)),
                "max": float(np.max(curve)), "min": float(np.min(curve)),
            }  # fmt: skip
            numbers.append(number[metric.kind])
        return np.array(numbers)


@dataclass(frozen=True)
class OneByOne:
    """A case that is evaluated separately for each sample: simulated trials, kinematics."""

    evaluators: tuple[TrialEvaluator | KinematicEvaluator, ...]

    @property
    def is_exact(self) -> bool:
        """Whether all slopes are exact."""
        return all(evaluator.is_exact for evaluator in self.evaluators)

    def each(self, values: Array) -> dict[str, Numbers]:
        """Return every metric for values (samples, numbers): (samples, channels), (samples, numbers, channels), SI."""
        samples = [
            evaluator.at(sample) for evaluator, sample in zip(self.evaluators, values, strict=True)
        ]
        return {
            text: (
                np.stack([metrics[text][0] for metrics in samples]),
                np.stack([metrics[text][1] for metrics in samples]),
            )
            for text in samples[0]
        }


@dataclass(frozen=True)
class CasesEvaluator:
    """Evaluates the metrics of all cases; ``wanted`` maps each text to its case, metric and statistic.

    ``factors`` (samples, variables) multiply the free variables in each sample of the spread.
    """

    cases: Mapping[str, StationaryEvaluator | OneByOne]
    factors: Array
    wanted: Mapping[str, tuple[str, str, str]]

    @property
    def is_exact(self) -> bool:
        """Whether all slopes are exact."""
        return all(evaluator.is_exact for evaluator in self.cases.values())

    @property
    def has_kinks(self) -> bool:
        """Whether a metric is a percentile."""
        return any(statistic != "mean" for _, _, statistic in self.wanted.values())

    def at(self, values: Array) -> dict[str, Numbers]:
        """Return every metric by its text: values of its channels and their slopes, SI."""
        judged = {
            case: evaluator.each(values * self.factors) for case, evaluator in self.cases.items()
        }
        metrics = {}
        for text, (case, inner, statistic) in self.wanted.items():
            numbers, slopes = judged[case][inner]
            metrics[text] = _statistic(statistic, numbers, slopes * self.factors[:, :, None])
        return metrics


def _statistic(kind: str, numbers: Array, slopes: Array) -> Numbers:
    """Return the mean or 95th percentile over samples (samples, channels), with slopes (numbers, channels)."""
    if kind == "mean" or len(numbers) == 1:
        return numbers.mean(axis=0), slopes.mean(axis=0)
    order = np.argsort(numbers, axis=0)
    place = 0.95 * (len(numbers) - 1)
    low = int(place)
    share = place - low
    high = min(low + 1, len(numbers) - 1)
    value, slope = np.empty(numbers.shape[1]), np.empty(slopes.shape[1:])
    for k in range(numbers.shape[1]):
        first, second = order[low, k], order[high, k]
        value[k] = (1.0 - share) * numbers[first, k] + share * numbers[second, k]
        slope[:, k] = (1.0 - share) * slopes[first, :, k] + share * slopes[second, :, k]
    return value, slope


def cases_problem(
    rig: Rig,
    free: Mapping[str, Bounds],
    objective: Objective,
    constraints: Mapping[str, LimitGiven] | None = None,
    *,
    cases: Mapping[str, Case],
    spread: Mapping[str, Spread] | None = None,
    samples: int = 32,
    seed: int = 1,
    more: Sequence[str] = (),
) -> DesignProblem:
    """Read a design task of several cases (SI or texts); ``more`` are further metrics to evaluate."""
    if not cases:
        raise DescriptionError(
            "no case", where="cases", hint='e.g. {"rough": {"road": "C", "speed": "20 m/s"}}'
        )
    numbers = numbers_of(rig, free)
    weights = read_weights(objective)
    wanted: dict[str, tuple[str, str, str]] = {}
    inner: dict[str, dict[str, Metric]] = {case: {} for case in cases}
    metrics: dict[str, Metric] = {}
    for where, texts in (
        ("objective", weights),
        ("constraints", constraints or {}),
        ("metrics", more),
    ):
        for text in texts:
            case, statistic, words = _split_text(text, cases, spread, where)
            metric = _read_metric(words, cases[case], rig, where)
            wanted[text], inner[case][words] = (case, words, statistic), metric
            metrics[text] = replace(metric, text=text)
    limits = tuple(read_limit(metrics[text], given) for text, given in (constraints or {}).items())
    rigs, factors = _draw_samples(rig, numbers, spread or {}, samples, seed)
    families = Families(
        tuple(LinearFamily(sample, tuple(number.path for number in numbers)) for sample in rigs)
    )
    judges: dict[str, StationaryEvaluator | OneByOne] = {}
    notes: list[Finding] = []
    for case, asked in inner.items():
        if not asked:
            raise DescriptionError(
                "no metric uses this case",
                where=f"cases.{case}",
                hint=Phrase('e.g. "{case}: sprung.az"', case=case),
            )
        judges[case], case_notes = _build_evaluator(
            cases[case], families, numbers, tuple(asked.values()), case
        )
        notes += [note for note in case_notes if str(note) not in map(str, notes)]
    words = ", ".join(f"{case} ({_describe_case(given)})" for case, given in cases.items())
    if spread:
        words += f"; {len(rigs)} samples of {', '.join(spread)}, seed {seed}"
    problem = DesignProblem(
        rig,
        numbers,
        weights,
        limits,
        CasesEvaluator(judges, np.array(factors), wanted),
        metrics,
        None,
        None,
        tuple(notes),
        driven=words,
    )
    for text in weights:
        base = problem.base_of(metrics[text])
        if not (np.isfinite(base) and base != 0.0):
            raise FitError("is zero at the start and cannot be reduced", where=f"objective: {text}")
        problem.base[text] = base
    return problem


def _split_text(
    text: str, cases: Mapping[str, Case], spread: Mapping[str, Spread] | None, where: str
) -> tuple[str, str, str]:
    """Split a text into case, statistic and metric."""
    head, colon, tail = text.partition(":")
    case = head.strip() if colon else next(iter(cases))
    if colon and case not in cases:
        raise unknown(case, cases, what="case", where=f"{where}: {text}")
    if not colon and len(cases) > 1:
        allowed = ", ".join(f'"{name}: {text}"' for name in cases)
        raise DescriptionError("the case is missing", where=where, found=text, allowed=allowed)
    words = (tail if colon else text).split()
    statistic = words.pop(0) if words and words[0] in _STATISTICS else "mean"
    if statistic == "p95" and not spread:
        raise DescriptionError(
            "a percentile needs a spread", where=f"{where}: {text}", hint="Give a spread."
        )
    return case, statistic, " ".join(words)


def _read_metric(words: str, case: Case, rig: Rig, where: str) -> Metric:
    if not (isinstance(case, Mapping) and "travel" in case):
        return read_metric(words, units_of(rig), where=where)
    parts = words.split()
    kind = parts.pop(0) if len(parts) == 2 else "value"
    if kind not in _KINDS or len(parts) != 1:
        allowed = Phrase(
            "a quantity of the catalogue, or {kinds} before one", kinds=", ".join(_KINDS)
        )
        raise DescriptionError("not a kinematic metric", where=where, found=words, allowed=allowed)
    known = {quantity.name: quantity for quantity in CATALOGUE}
    if parts[0] not in known:
        raise unknown(parts[0], known, what="quantity", where=where)
    return Metric(words, (parts[0],), kind, known[parts[0]].unit)


def _draw_samples(
    rig: Rig,
    numbers: Sequence[FreeParameter],
    spread: Mapping[str, Spread],
    samples: int,
    seed: int,
) -> tuple[list[Rig], list[Array]]:
    """Draw the rigs of the spread, and the factors of the free variables in each."""
    ones = np.ones(len(numbers))
    if not spread:
        return [rig], [ones]
    if not (is_whole(samples) and 2 <= samples <= _MOST_SAMPLES):
        allowed = Phrase("2 to {most_samples}", most_samples=_MOST_SAMPLES)
        raise DescriptionError(
            "invalid number of samples", where="samples", found=samples, allowed=allowed
        )
    known = rig.parameters()
    for path in spread:
        if path not in known:
            from jounce.parts.rig import unknown_path

            raise unknown_path(f"spread: {path}", known, name=path)
    design = sobol(spread, samples, seed=seed)
    design.refuse_outside(
        lambda path: (known[path], unit_of(rig, path)), lambda path: quantity_at(rig, path)
    )
    columns = design.values(lambda path: (known[path], unit_of(rig, path)))
    places = {number.path: i for i, number in enumerate(numbers)}
    rigs, factors = [], []
    for k in range(samples):
        factor = ones.copy()
        for path, i in places.items():
            if path in columns:
                if known[path] == 0.0:
                    what = "a spread cannot apply to a free parameter that starts at zero"
                    raise DescriptionError(what, where=f"spread: {path}")
                factor[i] = columns[path][k] / known[path]
        rigs.append(
            rig.with_changes({p: float(v[k]) for p, v in columns.items() if p not in places})
        )
        factors.append(factor)
    return rigs, factors


def _build_evaluator(
    case: Case,
    families: Families,
    numbers: Sequence[FreeParameter],
    metrics: tuple[Metric, ...],
    name: str,
) -> tuple[StationaryEvaluator | OneByOne, tuple[Finding, ...]]:
    where = f"cases.{name}"
    if isinstance(case, Trial):
        return OneByOne(
            tuple(TrialEvaluator(family, case, metrics) for family in families.members)
        ), ()
    if not isinstance(case, Mapping):
        raise DescriptionError(
            "invalid case", where=where, found=case, allowed="a trial, road and speed, or travel"
        )
    if "travel" not in case:
        given = dict(case)
        road, speed = given.pop("road", None), given.pop("speed", None)
        for key in given:
            if key not in ("band", "sides"):
                raise unknown(
                    key, ("road", "speed", "band", "sides", "travel"), what="key", where=where
                )
        try:
            return stationary_evaluator(families, metrics, road, speed, given)
        except DescriptionError as error:
            if error.where not in case:
                raise
            place = f"{where}.{error.where}"
            raise DescriptionError(
                error.what, where=place, found=error.found, allowed=error.allowed, hint=error.hint
            ) from None
    rigs = [family.rig for family in families.members if isinstance(family.rig, Corner)]
    if set(case) != {"travel"} or len(rigs) < len(families):
        raise DescriptionError("kinematic metrics need a 3-D corner", where=where, found=dict(case))
    from jounce.core.units import to_si

    travel = np.array([to_si(value, "m", where=where) for value in case["travel"]])
    if len(travel) < 2 or np.any(np.diff(travel) <= 0.0) or not travel[0] <= 0.0 <= travel[-1]:
        allowed = "two or more rising values around 0"
        raise DescriptionError(
            "invalid travel", where=where, found=list(case["travel"]), allowed=allowed
        )
    grid = np.union1d(np.linspace(travel[0], travel[-1], 13), [0.0]) if len(travel) == 2 else travel
    steps = np.array([_STEP * (number.upper - number.lower) for number in numbers])
    paths = families.first.paths
    return OneByOne(
        tuple(
            KinematicEvaluator(rig, paths, np.maximum(steps, 1e-9), grid, metrics) for rig in rigs
        )
    ), ()


def _describe_case(case: Case) -> str:
    if isinstance(case, Trial):
        return "a simulated trial"
    if "travel" in case:
        return "kinematics"
    return f"random road {case.get('road')}, {case.get('speed')}"
