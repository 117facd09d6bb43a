"""The trade-off between comfort and road holding: the best dampers for each, and the Pareto front."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np

from jounce.core.errors import DescriptionError, FitError
from jounce.core.findings import Finding, finding
from jounce.core.operation import Count, Mark, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.shown import Shown
from jounce.core.text import align_columns
from jounce.core.types import Array
from jounce.core.waiting import report_work
from jounce.design.cases import Case
from jounce.design.optimise import check_kept, is_optimal, road_in_words, search, task_of
from jounce.design.options import FREE, LIMITS, RANDOM_ROAD, ROAD_BAND, ROAD_SPEED
from jounce.design.problem import (
    DesignProblem,
    Limit,
    LimitGiven,
    Metric,
    StationaryEvaluator,
    combine_channels,
    design_problem,
)
from jounce.design.springs import wheels_of
from jounce.identify.fit_problem import Bounds
from jounce.parts import Rig, as_rig
from jounce.parts.options import AnyRig
from jounce.parts.rig import unit_of
from jounce.ride.closed_forms import comfort_damping, road_holding_damping
from jounce.ride.family import Families, LinearFamily
from jounce.ride.surface import Density
from jounce.variants.designs import Spread

COMFORT, HOLDING, TRAVEL = "sprung.az", "tyre.force coefficient", "strut.deflection"
_RANGE = (0.2, 5.0)
"""Range of the search for the best damper, as multiples of the closed-form value."""
_SAME = 1e-6  # relative difference of the two ends below which comfort and road holding agree
_PRECISION = (
    1e-9  # of the objective, which is 1 at the start: far finer than the resolution of a plot
)
_FEWEST, _MOST = 3, 500  # designs: at least both ends and one between; each takes a search


@dataclass(frozen=True)
class BestDamper(Shown):
    """Dampers that minimise one metric, by the closed form of each wheel and by a search on the whole model, SI.

    Attributes
    ----------
    goal : str
        ``comfort`` or ``road holding``.
    metric, unit : str
        Metric that is minimised, and its unit.
    present, closed_form, searched : dict
        Path to the damping coefficient, N*s/m.
    values : dict
        ``present``, ``closed_form`` and ``searched`` to the value of the metric.
    """

    goal: Literal["comfort", "road holding"]
    metric: str
    unit: str
    present: dict[str, float]
    closed_form: dict[str, float]
    searched: dict[str, float]
    values: dict[str, float]


def best_dampers(
    rig: Rig | str | Path,
    road: str | float | Density,
    speed: float | str,
    *,
    band: tuple[float, float] | Literal["iso"] | None = None,
    comfort: str = COMFORT,
    holding: str = HOLDING,
) -> tuple[BestDamper, BestDamper]:
    """Compute the best dampers for comfort and for road holding, in closed form and by a search.

    Parameters
    ----------
    rig : Rig, str or Path
        Quarter car, half-car-4dof or full car with linear dampers; its file, or its name in the library.
    road : str, float or callable
        As for :func:`optimise`: class, degree of roughness in m^3, or density.
    speed : float or str
        m/s.
    band : tuple of float or "iso", optional
        Spatial frequencies of the road, 1/m; by default white noise where all metrics are finite on it.
    comfort, holding : str
        Metrics to minimise.

    Returns
    -------
    tuple of BestDamper
        The results for comfort and for road holding. The closed forms apply to one wheel on white noise with an
        undamped tyre; the search uses the complete model.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.load("audi-a6-quarter-car").with_changes({"tyre.damping_coefficient": 0.0})
    >>> for best in best_dampers(car, "C", "20 m/s"):
    ...     print(best.goal, *(round(c["strut.damper.coefficient"]) for c in (best.closed_form, best.searched)))
    comfort 1559 1559
    road holding 3243 3243
    """
    rig = as_rig(rig)
    wheels, values = wheels_of(rig), rig.parameters()
    best = []
    goals: tuple[tuple[Literal["comfort", "road holding"], str, Any], ...] = (
        ("comfort", comfort, comfort_damping),
        ("road holding", holding, road_holding_damping),
    )
    for goal, metric, formula in goals:
        closed = {
            wheel.damper: formula(wheel.quarter_car(values)) / wheel.motion_ratio**2
            for wheel in wheels
        }
        free: dict[str, Bounds] = {
            path: (_RANGE[0] * c, _RANGE[1] * c) for path, c in closed.items()
        }
        begin = {
            path: min(max(values[path], _RANGE[0] * c), _RANGE[1] * c) for path, c in closed.items()
        }
        more = [comfort, holding]  # to evaluate both on the same road
        problem = design_problem(
            rig.with_changes(begin), free, metric, more=more, road=road, speed=speed, band=band
        )
        ended = search(problem).values
        searched = {
            number.path: float(value) for number, value in zip(problem.free, ended, strict=True)
        }
        present = {path: values[path] for path in closed}
        numbers = {
            name: _metric_with(problem, metric, dampers)
            for name, dampers in (
                ("present", present),
                ("closed_form", closed),
                ("searched", searched),
            )
        }
        unit = problem.metrics[metric].unit
        best.append(BestDamper(goal, metric, unit, present, closed, searched, numbers))
    return best[0], best[1]


def _metric_with(problem: DesignProblem, metric: str, dampers: Mapping[str, float]) -> float:
    values = np.array([dampers[number.path] for number in problem.free])
    return problem.whole(metric, values)[0]


@dataclass(frozen=True)
class ParetoMark:
    """A design for comparison with the front, SI: its name, free parameters and dampers by path, and metrics."""

    name: str
    kind: Literal["present", "closed form", "searched"]
    values: dict[str, float]
    comfort: float
    holding: float
    travel: float


@dataclass(frozen=True)
class ParetoFront(Plain):
    """Best designs from the most comfortable to the one that holds the road best, SI.

    Attributes
    ----------
    metrics : dict
        ``comfort``, ``holding`` and ``travel`` to the metric in words.
    units : dict
        Role to the SI unit of its metric.
    comfort, holding, travel : ndarray, shape (points,)
        Metrics along the front, each in its unit.
    numbers : dict
        Path to the values along the front, ndarray of shape (points,), SI.
    number_units : dict
        Path to SI unit.
    marks : tuple of ParetoMark
        The present rig, and the rig with only its dampers changed to the best ones by closed form and by search.
    converged : bool
        Whether all points are optimal.
    driven : str
        The road, in words.
    findings : tuple of Finding
        Findings.
    words : dict
        Role to its metric with the wheels that it combines: "sprung.az, unweighted r.m.s. of front and rear".
    """

    metrics: dict[str, str]
    units: dict[str, str]
    comfort: Array
    holding: Array
    travel: Array
    numbers: dict[str, Array]
    number_units: dict[str, str]
    marks: tuple[ParetoMark, ...]
    converged: bool
    driven: str
    findings: tuple[Finding, ...]
    words: dict[str, str]

    @property
    def roles(self) -> tuple[str, ...]:
        """``comfort``, ``holding`` and, if it is a different metric, ``travel``."""
        pair = ("comfort", "holding")
        return (
            pair
            if self.metrics["travel"] in [self.metrics[role] for role in pair]
            else (*pair, "travel")
        )

    @property
    def heading(self) -> str:
        """Return the two ends of the front in words."""
        usual = self.metrics["comfort"] == COMFORT and self.metrics["holding"] == HOLDING
        return (
            "comfort to road holding"
            if usual
            else f"{self.metrics['comfort']} to {self.metrics['holding']}"
        )

    def __str__(self) -> str:
        rows = [
            [
                "",
                *(f"{self.words[role]} [{self.units[role]}]" for role in self.roles),
                *self.numbers,
            ]
        ]
        columns = [*(getattr(self, role) for role in self.roles), *self.numbers.values()]
        rows += [
            [str(i + 1), *(f"{column[i]:.5g}" for column in columns)]
            for i in range(len(self.comfort))
        ]
        beside = [
            f"{mark.name} ({mark.kind}): {', '.join(f'{getattr(mark, role):.5g}' for role in self.roles)}"
            for mark in self.marks
        ]
        head = f"From {self.heading} on {self.driven}"
        return "\n".join([head, *align_columns(rows), *beside, *map(str, self.findings)])


@operation(
    "design pareto",
    named={"rig": "vehicle", "changes": "set", "constraints": "limit"},
    faces={"road": "iso:C", "speed": "20 m/s"},
    python_only=("cases", "spread", "samples", "seed"),
    echo={"rig": "vehicle", "set": "set"},
    offers=("figure", "report"),
    page="jounce.report:front_page",
    title="{vehicle}",
    doing="searching",
    example='jounce design pareto audi-a6-quarter-car --free strut.damper.coefficient="300..6000" --figure front.png',
)
def pareto(  # noqa: PLR0913 - each is a choice of its own
    rig: AnyRig,
    free: Annotated[Mapping[str, Bounds], FREE],
    road: Annotated[str | float | Density | None, RANDOM_ROAD] = None,
    speed: Annotated[float | str | None, ROAD_SPEED] = None,
    *,
    comfort: Annotated[str, Mark("Metric of comfort.", "METRIC")] = COMFORT,
    holding: Annotated[str, Mark("Metric of road holding.", "METRIC")] = HOLDING,
    travel: Annotated[str, Mark("Metric reported alongside.", "METRIC")] = TRAVEL,
    constraints: Annotated[Mapping[str, LimitGiven] | None, LIMITS] = None,
    points: Annotated[
        int, Count("Number of designs, ends included.", "NUMBER", _FEWEST, _MOST)
    ] = 25,
    band: Annotated[tuple[float, float] | Literal["iso"] | None, ROAD_BAND] = None,
    cases: Mapping[str, Case] | None = None,
    spread: Mapping[str, Spread] | None = None,
    samples: int = 32,
    seed: int = 1,
) -> ParetoFront:
    """Find the Pareto front between comfort and road holding, with the best dampers in closed form and by search.

    No design on the front is dominated by another. The two ends minimise one metric each. Between them, comfort is
    optimised under decreasing limits of road holding (the epsilon-constraint method); each search starts from the
    previous design.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name in the library: where the search starts.
    free : mapping
        Path to its bounds, as for :func:`optimise`.
    road : str, float or callable
        Random road: class, degree of roughness in m^3, or density.
    speed : float or str
        m/s.
    comfort, holding, travel : str
        Metrics as for :func:`optimise`; ``travel`` is only reported.
    constraints : mapping, optional
        Limits for all points, as for :func:`optimise`.
    points : int
        Number of designs, ends included: 3 to 500.
    band : tuple of float or "iso", optional
        Spatial frequencies of the road, 1/m; by default white noise where all metrics are finite on it.
    cases : mapping, optional
        Several cases instead of one road, by name, as for :func:`optimise`; ``comfort``, ``holding`` and ``travel`` are
        then metrics of these cases (SI).
    spread : mapping, optional
        Path to its spread, as for :func:`optimise`, for robust designs: ``"p95 sprung.az"``.
    samples, seed : int
        Number and seed of the samples of the spread, as for :func:`optimise`.

    Returns
    -------
    ParetoFront
        SI.

    Raises
    ------
    DescriptionError, FitError
        As for :func:`optimise`.

    Examples
    --------
    >>> import jounce as jn
    >>> free = {"strut.damper.coefficient": ("300 N*s/m", "6000 N*s/m")}
    >>> front = pareto(jn.load("audi-a6-quarter-car"), free, "C", "20 m/s", points=5)
    >>> bool((front.comfort[1:] > front.comfort[:-1]).all() and (front.holding[1:] < front.holding[:-1]).all())
    True
    """
    if not _FEWEST <= points <= _MOST:
        raise DescriptionError(
            "invalid number of points",
            where="points",
            found=points,
            allowed=Phrase("{fewest} to {most}", fewest=_FEWEST, most=_MOST),
        )
    rig = as_rig(rig)
    given: dict[str, Any] = {"road": road, "speed": speed, "band": band}
    chosen = {name: value for name, value in given.items() if value is not None}
    soft = task_of(
        rig,
        free,
        comfort,
        constraints,
        chosen,
        cases,
        spread,
        samples,
        seed,
        more=[holding, travel],
    )
    firm = replace(
        soft, weights={holding: 1.0}, base={holding: soft.base_of(soft.metrics[holding])}
    )
    designs: list[Array] = []
    with report_work(
        lambda: Phrase(
            "searching design {which} of {points} on the front: {judged} evaluated",
            which=len(designs) + 1,
            points=points,
            judged=soft.evaluations,
        )
    ):
        table, converged = _front(soft, firm, holding, points, designs)
    whole = {
        name: np.array([soft.whole(text, values)[0] for values in table])
        for name, text in (("comfort", comfort), ("holding", holding), ("travel", travel))
    }
    metrics = {"comfort": comfort, "holding": holding, "travel": travel}
    if soft.surface is not None:
        marks, notes = _marks(soft, metrics, {**given, "band": soft.surface.band})
    else:
        present = {name: soft.whole(text, soft.start)[0] for name, text in metrics.items()}
        marks, notes = (ParetoMark("as it is", "present", _present(soft), **present),), []
    paths = [number.path for number in soft.free]
    return ParetoFront(
        metrics,
        {name: soft.metrics[text].unit for name, text in metrics.items()},
        whole["comfort"], whole["holding"], whole["travel"],
        {path: table[:, i] for i, path in enumerate(paths)},
        {path: unit_of(rig, path) for path in paths},
        marks, converged, road_in_words(soft), (*soft.notes, *notes, *_findings(whole, converged=converged)),
        {name: _in_words(soft.metrics[text]) for name, text in metrics.items()},
    )  # fmt: skip


def _in_words(metric: Metric) -> str:
    """Return a metric with the wheels that it combines, which its name does not say."""
    places = [channel.partition(".")[0].replace("_", " ") for channel in metric.channels]
    if len(places) < 2:
        return metric.text
    weighted = "unweighted " if metric.unit == "m/s^2" and metric.kind == "rms" else ""
    how = "worst" if metric.is_worst else f"{weighted}r.m.s."
    return f"{metric.text}, {how} of {', '.join(places[:-1])} and {places[-1]}"


def _front(
    soft: DesignProblem, firm: DesignProblem, holding: str, points: int, table: list[Array]
) -> tuple[Array, bool]:
    """Compute the free variables (points, variables) along the front, adding each design to ``table`` at once."""
    ends = [search(problem) for problem in (soft, firm)]
    for problem, end in zip((soft, firm), ends, strict=True):
        check_kept(problem, end)
    first, last = (soft.whole(holding, end.values)[0] for end in ends)
    if first <= last * (1.0 + _SAME):
        return np.array([ends[0].values]), is_optimal(soft, ends[0].values).holds
    # With two goals, a limit on one of them controls where the designs are, and each takes a single-goal search.
    # The mixtures of `front_search` work for any number of goals, but their designs cluster where the front bends.
    along = np.cos(0.5 * np.pi * np.arange(1, points - 1) / (points - 1)) ** 2
    table.append(ends[0].values)
    holds = ends[0].settled or is_optimal(soft, ends[0].values).holds
    for share in along:  # dense where one of the two goals costs almost nothing
        bound = last + (first - last) * float(share)
        limit = Limit(soft.metrics[holding], None, bound, is_whole=True)
        problem = replace(soft, limits=(*soft.limits, limit))
        result = search(problem, begin=table[-1], precision=_PRECISION)
        holds &= result.settled or is_optimal(problem, result.values).holds
        table.append(result.values)
    table.append(ends[1].values)
    return np.array(table), bool(
        holds and (ends[1].settled or is_optimal(firm, ends[1].values).holds)
    )


def _marks(
    soft: DesignProblem, metrics: dict[str, str], given: dict[str, Any]
) -> tuple[tuple[ParetoMark, ...], list[Finding]]:
    """Return the present rig, and the best dampers if closed forms exist for the rig."""
    marks = [_mark("as it is", "present", soft, {}, metrics)]
    try:
        best = best_dampers(
            soft.rig, **given, comfort=metrics["comfort"], holding=metrics["holding"]
        )
    except (DescriptionError, FitError) as error:
        return tuple(marks), [finding("design.no_best_dampers", "closed forms", error=error)]
    for damper in best:
        name = f"best damper for {damper.goal}"
        marks.append(_mark(name, "closed form", soft, damper.closed_form, metrics))
        marks.append(_mark(name, "searched", soft, damper.searched, metrics))
    return tuple(marks), []


def _mark(
    name: str,
    kind: Literal["present", "closed form", "searched"],
    soft: DesignProblem,
    changes: dict[str, float],
    metrics: dict[str, str],
) -> ParetoMark:
    assert isinstance(soft.evaluator, StationaryEvaluator)
    families = Families((LinearFamily(soft.rig.with_changes(changes)),))
    numbers = replace(soft.evaluator, families=families).at(np.zeros(0))
    values = {
        role: combine_channels(soft.metrics[text], numbers[text])[0]
        for role, text in metrics.items()
    }
    return ParetoMark(
        name,
        kind,
        {**_present(soft), **changes},
        values["comfort"],
        values["holding"],
        values["travel"],
    )


def _present(soft: DesignProblem) -> dict[str, float]:
    """Return the free parameters of the present rig."""
    has = soft.rig.parameters()
    return {number.path: has[number.path] for number in soft.free}


def _findings(whole: dict[str, Array], *, converged: bool) -> list[Finding]:
    findings = []
    if not converged:
        findings.append(finding("design.points_unsettled", "pareto"))
    if len(whole["comfort"]) == 1:
        findings.append(finding("design.best_in_both", "pareto"))
    return findings
