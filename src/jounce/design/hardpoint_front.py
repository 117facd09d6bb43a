"""Pareto front of hardpoint designs, from the best design for one goal to that for another."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError, JounceError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.design.free_points import Rigs
from jounce.design.front_search import SHARE, Aim, FrontSearch
from jounce.design.hardpoint_search import HardpointSearch, places, refuse_idle
from jounce.design.kinematic_study import FreePoint, KinematicTarget
from jounce.design.kinematics import KinematicTask, read_task, rigs_of, values_before
from jounce.design.mixtures import MOST_GOALS, achievement, mixtures, undominated_rows
from jounce.kinematics.clearances import Shape
from jounce.kinematics.sweeps import AxleLayout
from jounce.parts import Corner, DependentAxle, Rig

_FEWEST, _MOST = 3, 500  # designs: at least both ends and one between; each takes a search
_SOFT = 1e-3  # tolerances below which a goal is practically reached
_PRECISION, _FORBIDDEN = (
    1e-10,
    1e6,
)  # tolerances: far below manufacturing accuracy; far above any miss of a linkage that can be assembled
_INSIDE = 0.95  # tolerances
_HELD = 1.0 + 1e-6  # tolerances, plus the residual error of a search


@dataclass(frozen=True)
class FrontDesign(Plain):
    """A design on the front: ``goals`` as root mean square of their targets in tolerances; ``moved`` parameters, SI.

    ``met`` is True if all targets are within their tolerances.
    """

    goals: Mapping[str, float]
    moved: Mapping[str, float]
    met: bool


@dataclass(frozen=True)
class KinematicFront(Plain):
    """Pareto front of competing goals.

    Attributes
    ----------
    goals : mapping of str to tuple of int
        Goals by name, with the indices of their targets.
    held : tuple of int
        Indices of the targets that stay within their tolerances along the entire front.
    designs : tuple of FrontDesign
        Designs sorted by the first goal, best first.
    before : FrontDesign
        The initial rigs.
    evaluations : int
        Number of designs evaluated.
    start : mapping of str to Corner or DependentAxle
        The rigs from which the search started, by name.
    findings : tuple of Finding
        Findings.
    """

    goals: Mapping[str, tuple[int, ...]]
    held: tuple[int, ...]
    designs: tuple[FrontDesign, ...]
    before: FrontDesign
    evaluations: int
    start: Rigs
    findings: tuple[Finding, ...] = ()

    left_out = ("start",)

    def rigs(self, k: int) -> dict[str, Corner | DependentAxle]:
        """Return the rigs of design ``k`` (from 0) by name; a single rig has the name ''."""
        rigs: dict[str, Corner | DependentAxle] = {}
        for name, rig in self.start.items():
            head = f"{name}." if name else ""
            moved = {
                path.removeprefix(head): value for path, value in self.designs[k].moved.items()
            }
            rigs[name] = rig.with_changes(
                {path: value for path, value in moved.items() if path in rig.parameters()}
            )
        return rigs

    def table(self) -> str:
        """Return the front as CSV: one row per design, goals in tolerances, numbers in SI."""
        rows = [
            ",".join(
                (
                    "design",
                    *(f"{name} [tolerances]" for name in self.goals),
                    *self.before.moved,
                    "met",
                )
            )
        ]
        labels = ["before", *(str(k + 1) for k in range(len(self.designs)))]
        for label, design in zip(labels, (self.before, *self.designs), strict=True):
            numbers = (*design.goals.values(), *design.moved.values())
            rows.append(",".join((label, *map(repr, numbers), str(design.met))))
        return "\n".join([*rows, ""])


def kinematic_front(
    rig: Rig | str | Path | Mapping[str, Rig],
    free: Sequence[FreePoint | Mapping[str, Any]] | Mapping[str, Any],
    targets: Sequence[KinematicTarget | Mapping[str, Any]],
    *,
    vehicle: AxleLayout | Mapping[str, AxleLayout] | None = None,
    points: int = 20,
    starts: int = 4,
    seed: int = 0,
    shapes: Mapping[str, Shape] | None = None,
) -> KinematicFront:
    """Find the Pareto front of competing goals: no design is better than another in all of them.

    Targets with the same ``goal`` form one goal; if no target names a goal, each target without ``must`` is a goal of
    its own. Targets with ``must``, and targets without a goal if others have one, are constraints: they stay within
    their tolerances.

    Parameters
    ----------
    rig, free, targets, vehicle
        As for :func:`jounce.design_kinematics`; lengths in m, angles in rad, or texts with their units.
    points : int
        Approximate number of designs, 3 to 500; dominated designs are left out.
    starts : int
        Number of searches for the optimum of each goal; the first starts from the rig, the others within the boxes.
    seed : int
        Seed of the starting points.
    shapes : mapping of str to Solid or Rim, optional
        Bodies by name, as for :func:`jounce.design_kinematics`, m.

    Returns
    -------
    KinematicFront
        Designs with their goals (root mean square in tolerances) and numbers (SI).

    Raises
    ------
    DescriptionError
        As for :func:`jounce.design_kinematics`; for fewer than two goals; and if no design meets the constraints.

    Examples
    --------
    >>> import jounce as jn
    >>> targets = [
    ...     {"quantity": "camber_gain", "value": "-45 deg/m", "tolerance": "1 deg/m"},
    ...     {"quantity": "roll_centre_height", "value": "20 mm", "tolerance": "1 mm"},
    ... ]
    >>> front = kinematic_front("formula-student-front", {"hardpoints.upper_arm_front[2]": "20 mm"}, targets, points=5)
    >>> gains = [design.goals["camber_gain"] for design in front.designs]
    >>> gains == sorted(gains)
    True
    """
    if not _FEWEST <= points <= _MOST:
        raise DescriptionError(
            "invalid number of designs",
            where="points",
            found=points,
            allowed=Phrase("{fewest} to {most}", fewest=_FEWEST, most=_MOST),
        )
    if starts < 1:
        raise DescriptionError(
            "invalid number of searches", where="starts", found=starts, allowed="1 or more"
        )
    return front_of(read_task(rig, free, targets, vehicle, shapes), points, starts, seed)


def front_of(task: KinematicTask, points: int, starts: int, seed: int) -> KinematicFront:
    """Search for the front of a task."""
    search = task.search()
    goals, held = _goals(search)
    values_before(search)
    refuse_idle(search, task.free, seed)
    race = _HardpointFrontSearch(search, goals, held)
    corners = [_find_corner(race, i, starts, seed) for i in range(len(goals))]
    reached = np.array([race.goals_at(x) for x in corners])
    best, worst = reached.min(axis=0), reached.max(axis=0)
    span = np.maximum(worst - best, _SOFT)
    tried = list(corners)
    race.between(tried, best, span, mixtures(len(goals), points))
    sound = [x for x in tried if race.holds(x)]
    front_rows = undominated_rows(np.array([race.goals_at(x) for x in sound]), span)
    designs = [
        design
        for design in (_describe_design(race, sound[i]) for i in front_rows)
        if design is not None
    ]
    findings = []
    if len(designs) == 1:
        findings.append(finding("design.best_in_all_goals", "front"))
    start = _describe_design(race, np.zeros(len(search.scale)))
    assert start is not None
    order = sorted(designs, key=lambda design: tuple(design.goals.values()))
    return KinematicFront(
        goals,
        tuple(held),
        tuple(order),
        start,
        search.evaluator.evaluations,
        dict(task.rigs),
        tuple(findings),
    )


def _goals(search: HardpointSearch) -> tuple[dict[str, tuple[int, ...]], list[int]]:
    """Return the goals by name with their targets, and the targets that are constraints."""
    named = any(item.text.goal is not None for item in search.wanted)
    goals: dict[str, list[int]] = {}
    held = []
    for i, item in enumerate(search.wanted):
        if item.text.must or (named and item.text.goal is None):
            held.append(i)
            continue
        name = item.text.goal if named else item.label
        if not named and name in goals:
            name = f"{name} {i}"
        goals.setdefault(str(name), []).append(i)
    if not 2 <= len(goals) <= MOST_GOALS:
        raise DescriptionError(
            "at least two goals are needed",
            where="target",
            found=", ".join(goals) or "none",
            allowed=Phrase("2 to {most_goals} goals", most_goals=MOST_GOALS),
            hint='Give targets that belong together the same goal = "...", and constraints must = true.',
        )
    return {name: tuple(members) for name, members in goals.items()}, held


class _HardpointFrontSearch(FrontSearch):
    """Goals and constraints of a search, with their slopes; designs are scaled variables."""

    rounds = 150

    def __init__(
        self, search: HardpointSearch, goals: Mapping[str, tuple[int, ...]], held: Sequence[int]
    ) -> None:
        self.search, self.goals = search, goals
        parts = search.evaluator.parts
        count = parts[-1].stop
        self._weights = np.zeros((len(goals), count))  # of the squares in the mean of each goal
        for k, members in enumerate(goals.values()):
            for i in members:
                part = parts[i]
                self._weights[k, part] = 1.0 / (len(members) * (part.stop - part.start))
        firm = [np.arange(parts[i].start, parts[i].stop) for i in held]
        self._firm = np.concatenate(firm) if firm else np.zeros(0, dtype=int)
        self._seen: tuple[bytes, tuple[Array, Array, Array, Array]] | None = None

    def at(self, x: Array) -> tuple[Array, Array, Array, Array]:
        """Return goals (root mean squares, tolerances) and margins of the constraints, each with slopes."""
        key = x.tobytes()
        if self._seen is not None and self._seen[0] == key:
            return self._seen[1]
        search = self.search
        values, along = search.evaluator.together(search.numbers(x))
        off, along = search.off(values), along * search.scale / search.tolerance[:, None]
        if np.all(np.isfinite(off)):
            goals = np.sqrt(self.means(off) + _SOFT**2)
            slopes = (self._weights * off) @ along / goals[:, None]
            firm = self._firm
            ends = [(values - search.high)[firm], (search.low - values)[firm]]
            room = _INSIDE - np.concatenate(ends) / np.tile(search.tolerance[firm], 2)
            result = (
                goals,
                slopes,
                np.where(np.isfinite(room), room, 1.0),
                np.vstack([-along[firm], along[firm]]),
            )
        else:
            size, count = len(x), 2 * len(self._firm)
            goals = np.full(len(self.goals), _FORBIDDEN)
            result = (
                goals,
                np.zeros((len(goals), size)),
                np.full(count, -1.0),
                np.zeros((count, size)),
            )
        self._seen = key, result
        return result

    def means(self, off: Array) -> Array:
        """Return the mean square of each goal from the deviations of its values, in tolerances."""
        return np.asarray(self._weights @ off**2)

    def goals_at(self, x: Array) -> Array:
        """Return the goals at a point."""
        return self.at(x)[0]

    def holds(self, x: Array) -> bool:
        """Whether a point is within reach and meets the constraints."""
        goals, _, room, _ = self.at(x)
        return bool(np.all(goals < _FORBIDDEN) and np.all(room >= _INSIDE - _HELD))

    def rank(self, x: Array, aim: Aim) -> tuple[float, float]:
        """Rank a design: constraint violation (0 or 1), then the worst normalised goal."""
        return float(not self.holds(x)), achievement(self.goals_at(x), *aim)

    def rows(self, u: Array) -> tuple[Array, Array, Sequence[int]]:
        """Return the goals and their slopes, one row each."""
        goals, slopes, _, _ = self.at(u)
        return goals, slopes, range(len(goals))

    def room(self, u: Array) -> tuple[Array, Array]:
        """Return the margins of the constraints and their slopes."""
        return self.at(u)[2:]

    def run(self, x: Array, aim: Aim) -> tuple[Array, bool]:
        """Minimise the worst normalised goal."""
        begin = np.clip(x, self.search.lower, self.search.upper)
        return self.towards(begin, self.goals_at(begin), aim, self.search.lower, self.search.upper)

    def least(self, x: Array, weights: Array) -> Array:
        """Minimise the weighted sum of the goals from x."""
        from scipy.optimize import minimize

        lower, upper = self.search.lower, self.search.upper
        firm = {"type": "ineq", "fun": lambda x: self.at(x)[2], "jac": lambda x: self.at(x)[3]}
        result = minimize(
            lambda x: float(weights @ self.at(x)[0]), np.clip(x, lower, upper), jac=lambda x: weights @ self.at(x)[1],
            bounds=[*zip(lower, upper, strict=True)], constraints=firm if len(self._firm) else (), method="SLSQP",
            options={"maxiter": self.rounds, "ftol": _PRECISION},
        )  # fmt: skip
        return np.asarray(np.clip(result.x, lower, upper), dtype=float)


def _find_corner(race: _HardpointFrontSearch, i: int, starts: int, seed: int) -> Array:
    """Minimise one goal from several starts."""
    weights = np.full(len(race.goals), SHARE)
    weights[i] = 1.0
    ended = [race.least(x, weights) for x in places(race.search, starts, seed)]
    good = [x for x in ended if race.holds(x)]
    if not good:
        raise DescriptionError(
            "no design within the boxes meets the constraints",
            where="free",
            found=f"{starts} starts",
            hint="Widen the boxes, relax the targets, or give more starts.",
        )
    return min(good, key=lambda x: float(weights @ race.goals_at(x)))


def _describe_design(race: _HardpointFrontSearch, x: Array) -> FrontDesign | None:
    """Describe the design at a point; None if its parameters do not form a valid rig."""
    search = race.search
    try:
        rigs = rigs_of(search, x)
    except JounceError:
        return None
    numbering = search.evaluator.numbering
    known = dict(zip(numbering.paths, numbering.values(rigs).tolist(), strict=True))
    values, _ = search.evaluator.together(numbering.values(rigs), slopes=False)
    off = search.off(values)
    goals = np.sqrt(race.means(off))
    return FrontDesign(
        {name: float(goal) for name, goal in zip(race.goals, goals, strict=True)},
        {path: known[path] for path in search.free.paths},
        bool(np.all(np.abs(off) <= _HELD)),
    )
