"""Pareto front of several competing metrics, from the best design for one metric to that for another.

Searches follow evenly spread mixtures of the metrics, then fill the widest gaps between designs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.text import align_columns
from jounce.core.types import Array
from jounce.core.waiting import report_work
from jounce.design.cases import Case
from jounce.design.front_search import SHARE, Aim, FrontSearch
from jounce.design.mixtures import MOST_GOALS, achievement, across_gap, mixtures, undominated_rows
from jounce.design.optimise import Scale, check_kept, road_in_words, search, task_of, violation_of
from jounce.design.problem import DesignProblem, Limit, LimitGiven
from jounce.identify.fit_problem import Bounds
from jounce.parts import Rig, as_rig
from jounce.parts.rig import unit_of
from jounce.ride.surface import Density
from jounce.variants.designs import Spread

_FEWEST, _MOST, _FEWEST_GOALS = (
    3,
    500,
    2,
)  # designs: at least both ends and one between; each takes a search
_HELD = (
    1e-6  # relative increase allowed above the minimum of one metric while the others are minimised
)
_KEPT = 1e-6  # share of a limit that rounding of a search may break
_NEAR, _NEARER, _MOST_NEAR = (
    0.05,
    1e-5,
    60,
)  # scaled steps of the search around a kink, and evaluations per variable


@dataclass(frozen=True)
class DesignFront(Plain):
    """Pareto front of several metrics, SI.

    Attributes
    ----------
    goals : dict
        Metric to its values, ndarray of shape (points,), ascending in the first one.
    goal_units : dict
        Metric to SI unit.
    numbers : dict
        Path to the values of the free numbers, ndarray of shape (points,), SI.
    number_units : dict
        Path to SI unit.
    present : dict
        Metric to its value for the present rig, SI.
    start : dict
        Path to its value in the present rig, SI.
    converged : bool
        Whether all searches converged.
    evaluations : int
        Number of designs evaluated.
    driven : str
        The road, in words.
    findings : tuple of Finding
        Findings.
    """

    goals: dict[str, Array]
    goal_units: dict[str, str]
    numbers: dict[str, Array]
    number_units: dict[str, str]
    present: dict[str, float]
    start: dict[str, float]
    converged: bool
    evaluations: int
    driven: str
    findings: tuple[Finding, ...]

    @property
    def count(self) -> int:
        """Number of designs."""
        return len(next(iter(self.goals.values())))

    def __str__(self) -> str:
        heads = [f"{name} [{self.goal_units[name]}]" for name in self.goals]
        heads += [f"{path} [{self.number_units[path]}]" for path in self.numbers]
        columns = [*self.goals.values(), *self.numbers.values()]
        present = [*self.present.values(), *self.start.values()]
        rows = [["", *heads], ["as it is", *(f"{value:.5g}" for value in present)]]
        rows += [
            [str(i + 1), *(f"{column[i]:.5g}" for column in columns)] for i in range(self.count)
        ]
        return "\n".join(
            [f"Best designs on {self.driven}", *align_columns(rows), *map(str, self.findings)]
        )


def design_front(  # noqa: PLR0913 - each is a choice of its own
    rig: Rig | str | Path,
    free: Mapping[str, Bounds],
    goals: Sequence[str],
    road: str | float | Density | None = None,
    speed: float | str | None = None,
    *,
    constraints: Mapping[str, LimitGiven] | None = None,
    points: int = 25,
    band: tuple[float, float] | Literal["iso"] | None = None,
    cases: Mapping[str, Case] | None = None,
    spread: Mapping[str, Spread] | None = None,
    samples: int = 32,
    seed: int = 1,
) -> DesignFront:
    """Find the Pareto front of competing metrics: no design is better than another in all of them.

    The magnitude of each metric is minimised. See :func:`pareto` for comfort against road holding, including the best
    dampers, and :func:`kinematic_front` for kinematics.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name in the library: where the search starts.
    free : mapping
        Path to its bounds, SI or texts with units, as for :func:`optimise`.
    goals : sequence of str
        Metrics as for :func:`optimise`, 2 to 8 of them.
    road : str, float or callable
        Random road: class, degree of roughness in m^3, or density.
    speed : float or str
        m/s.
    constraints : mapping, optional
        Limits for all designs, SI or texts with units, as for :func:`optimise`.
    points : int
        Approximate number of designs, 3 to 500; dominated designs are left out.
    band : tuple of float or "iso", optional
        Spatial frequencies of the road, 1/m; by default white noise where all metrics are finite on it.
    cases : mapping, optional
        Several cases instead of one road, by name, as for :func:`optimise`.
    spread : mapping, optional
        Path to its spread, SI or texts with units, as for :func:`optimise`, for robust designs.
    samples, seed : int
        Number and seed of the samples of the spread, as for :func:`optimise`.

    Returns
    -------
    DesignFront
        SI.

    Raises
    ------
    DescriptionError, FitError
        As for :func:`optimise`, and for fewer than two metrics.

    Examples
    --------
    >>> import jounce as jn
    >>> free = {"strut.damper.coefficient": ("300 N*s/m", "6000 N*s/m"), "strut.spring.rate": "±40 %"}
    >>> goals = ["sprung.az", "tyre.force", "strut.deflection"]
    >>> front = design_front("audi-a6-quarter-car", free, goals, "C", "20 m/s", points=6)
    >>> bool(front.goals["sprung.az"][0] < front.present["sprung.az"])   # the most comfortable design
    True
    """
    if not _FEWEST <= points <= _MOST:
        raise DescriptionError(
            "invalid number of points",
            where="points",
            found=points,
            allowed=Phrase("{fewest} to {most}", fewest=_FEWEST, most=_MOST),
        )
    names = [goals] if isinstance(goals, str) else [str(goal) for goal in goals]
    if not _FEWEST_GOALS <= len(names) <= MOST_GOALS or len(set(names)) < len(names):
        allowed = Phrase(
            "{fewest_goals} to {most_goals} different metrics",
            fewest_goals=_FEWEST_GOALS,
            most_goals=MOST_GOALS,
        )
        raise DescriptionError(
            "at least two goals are needed", where="front", found=", ".join(names), allowed=allowed
        )
    rig = as_rig(rig)
    given = {
        name: value
        for name, value in (("road", road), ("speed", speed), ("band", band))
        if value is not None
    }
    objective = dict.fromkeys(names, 1.0)
    problem = task_of(rig, free, objective, constraints, given, cases, spread, samples, seed)
    race = _GoalSearch(problem, names)
    tried: list[Array] = []
    with report_work(
        lambda: Phrase(
            "searching design {which} of about {points}: {judged} evaluated",
            which=len(tried) + 1,
            points=points,
            judged=problem.evaluations,
        )
    ):
        settled, span = _search(race, points, tried)
    sound = [values for values in tried if violation_of(problem, values) <= _KEPT]
    goal_rows = np.array([race.goals_at(values) for values in sound])
    front_rows = sorted(undominated_rows(goal_rows, span), key=lambda i: tuple(goal_rows[i]))
    designs = np.array([sound[i] for i in front_rows])
    paths, units = (
        [number.path for number in problem.free],
        {name: problem.metrics[name].unit for name in names},
    )
    whole = {
        name: np.array([problem.whole(name, values)[0] for values in designs]) for name in names
    }
    return DesignFront(
        whole, units,
        {path: designs[:, i] for i, path in enumerate(paths)},
        {path: unit_of(rig, path) for path in paths},
        {name: problem.base[name] for name in names},
        dict(zip(paths, problem.start.tolist(), strict=True)),
        settled, problem.evaluations, road_in_words(problem),
        (*problem.notes, *_findings(len(designs), settled=settled)),
    )  # fmt: skip


def _search(race: _GoalSearch, points: int, tried: list[Array]) -> tuple[bool, Array]:
    """Append designs of the front to ``tried``; return whether all searches converged, and the goals' ranges."""
    problem = race.problem
    tried.extend(_find_corner(problem, name) for name in race.names)
    reached = np.array([race.goals_at(values) for values in tried])
    best, span = reached.min(axis=0), np.ptp(reached, axis=0)
    span = np.where(span > 0.0, span, np.maximum(np.abs(best), 1e-300))
    return race.between(tried, best, span, _aims(race, tried, best, span, points)), span


def _aims(
    race: _GoalSearch, tried: list[Array], best: Array, span: Array, points: int
) -> Iterator[Array]:
    """Yield mixtures to search along: first evenly spread ones, then those in wide gaps between ``tried`` designs."""
    yield from mixtures(len(best), max(points // 2, len(best) + 1))
    known: set[tuple[int, int]] = set()
    while len(tried) < points:
        goals = np.array([race.goals_at(values) for values in tried])
        front_rows = undominated_rows(goals, span)
        pairs = {
            (front_rows.index(i), front_rows.index(j))
            for i, j in known
            if i in front_rows and j in front_rows
        }
        before = set(pairs)
        mixture = across_gap((goals[front_rows] - best) / span, pairs)
        if mixture is None:
            return
        known |= {(front_rows[i], front_rows[j]) for i, j in pairs - before}
        yield mixture


def _findings(count: int, *, settled: bool) -> list[Finding]:
    findings = []
    if not settled:
        findings.append(finding("design.goal_searches_unsettled", "front"))
    if count == 1:
        findings.append(finding("design.best_in_all_metrics", "front"))
    return findings


def _find_corner(problem: DesignProblem, name: str) -> Array:
    """Find the design that minimises one metric; among equal ones, the design with the smallest other metrics."""
    alone = replace(problem, weights={name: 1.0})
    first = search(alone)
    check_kept(alone, first)
    least = problem.whole(name, first.values)[0]
    others = {metric: 1.0 for metric in problem.weights if metric != name}
    held = Limit(problem.metrics[name], None, least + _HELD * abs(least), is_whole=True)
    if least < 0.0:
        held = Limit(problem.metrics[name], least - _HELD * abs(least), None, is_whole=True)
    second = search(
        replace(problem, weights=others, limits=(*problem.limits, held)), begin=first.values
    )
    return second.values if second.violation <= _KEPT else first.values


class _GoalSearch(FrontSearch):
    """Goals and limits of a task in scaled variables, with their slopes; designs are values in SI."""

    rounds, tries = 200, 3

    def __init__(self, problem: DesignProblem, names: Sequence[str]) -> None:
        self.problem, self.names, self.scale = problem, names, Scale(problem)

    def goals_at(self, values: Array) -> Array:
        """Return the magnitude of each metric, SI."""
        return np.array([abs(self.problem.whole(name, values)[0]) for name in self.names])

    def rows(self, u: Array) -> tuple[Array, Array, Sequence[int]]:
        """Return rows of goals (several for a worst-corner metric), their slopes, and the goal of each row."""
        values, chain = self.scale.values(u), self.scale.slopes(u)
        goals, slopes, of = [], [], []
        for k, name in enumerate(self.names):
            numbers, along = self.problem.numbers(values)[name]
            if not self.problem.metrics[name].is_worst:
                number, slope = self.problem.whole(name, values)
                numbers, along = np.array([number]), slope[:, None]
            for i, number in enumerate(numbers.tolist()):
                sign = -1.0 if number < 0.0 else 1.0
                goals.append(sign * number)
                slopes.append(sign * along[:, i] * chain)
                of.append(k)
        return np.array(goals), np.array(slopes), of

    def room(self, u: Array) -> tuple[Array, Array]:
        """Return the margins of the limits, and their slopes."""
        margins = self.problem.margins(self.scale.values(u))
        chain = self.scale.slopes(u)
        table = np.array([slope * chain for _, _, _, _, slope in margins]).reshape(
            len(margins), len(u)
        )
        return np.array([margin for _, _, _, margin, _ in margins]), table

    def rank(self, x: Array, aim: Aim) -> tuple[float, float]:
        """Rank a design: violation of the limits, then the worst normalised metric."""
        return max(violation_of(self.problem, x), _KEPT), achievement(self.goals_at(x), *aim)

    def run(self, x: Array, aim: Aim) -> tuple[Array, bool]:
        """Minimise the worst normalised goal from given values (SI); return the values and whether it converged."""
        size = len(x)
        u, is_at_rest = self.towards(
            self.scale.normalise(x), self.goals_at(x), aim, np.zeros(size), np.ones(size)
        )
        values = self.scale.values(u)
        return self._refine(values, aim) if self.problem.has_kinks else (values, is_at_rest)

    def _refine(self, values: Array, aim: Aim) -> tuple[Array, bool]:
        """Refine the result of a gradient search without gradients (COBYLA), since it may have stopped at a kink."""
        from scipy.optimize import minimize

        def worst(u: Array) -> float:
            goals = self.goals_at(self.scale.values(u))
            return achievement(goals, *aim) + SHARE * float(np.sum((goals - aim.best) / aim.span))

        def margins(u: Array) -> Array:
            return np.concatenate([self.room(u)[0], u, 1.0 - u])

        begin = self.scale.normalise(values)
        result = minimize(
            worst, begin, method="COBYLA", constraints=[{"type": "ineq", "fun": margins}], tol=_NEARER,
            options={"rhobeg": _NEAR, "maxiter": _MOST_NEAR * len(values)},
        )  # fmt: skip
        u = np.clip(np.asarray(result.x), 0.0, 1.0)
        around = self.scale.values(u)
        better = worst(u) < worst(begin) and violation_of(self.problem, around) <= _KEPT
        return (around if better else values), bool(result.success)
