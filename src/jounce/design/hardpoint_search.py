"""The search for hardpoints: least squares of all targets in tolerances, from several starting points.

Free variables are scaled by their range, targets by their tolerance. A search is a Levenberg-Marquardt descent within
the boxes, from the rig itself and from points within the boxes. A slight pull towards the rig keeps undetermined
variables in place. If the best compromise misses a target, a second search only requires all targets to be within their
tolerances. If that fails, a third search finds the compromise subject to the mandatory targets by sequential quadratic
programming, since constraints cannot be expressed as least squares.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.seeds import check_seed
from jounce.core.types import Array
from jounce.design.free_points import FreeNumbers
from jounce.design.kinematic_study import FreePoint
from jounce.design.kinematic_targets import Evaluators, Wanted

_STEPS = 60  # at most; a search that needs more is reported as `UNSETTLED`
_PULL = 1e-4  # tolerances for a variable moved over its full range
_DAMPING, _LARGEST_DAMPING = (
    1e-3,
    1e10,
)  # of Levenberg-Marquardt: almost undamped at first; at the largest, steps are rounding
_SETTLED = 1e-10  # share of the cost below which a step is no improvement
_REACHED = 1e-9  # deviation in tolerances below which a target is met exactly
_SLACK = 1e-7  # tolerances that a smaller movement may cost a wanted value: a band of zero width has no interior
_INSIDE = 0.95  # share of the tolerance that the second search requires
UNSETTLED = "no more steps"
"""Reason for the end of a search that did not converge."""
_MOST_ROUNDS, _PRECISION, _FORBIDDEN = (
    200,
    1e-12,
    1e6,
)  # steps; share of the cost; tolerances where the linkage cannot be assembled
_REST = 1e-6  # share of the cost that a converged search could still gain over a whole box; margin of an active limit
_NOTHING = 1e-9  # effect, in tolerances over its box, below which a variable has no influence
_WITHIN = 1.0 + 1e-9  # tolerances, plus rounding


class Demand(NamedTuple):
    """Demand of a search on each value: dead band within the tolerance, weight beyond it, and pull to the rig."""

    inside: Array
    share: Array
    pull: float


@dataclass
class HardpointSearch:
    """Residuals of all targets in tolerances, for free variables scaled by their boxes."""

    evaluator: Evaluators
    free: FreeNumbers
    wanted: Sequence[Wanted]
    scale: Array = field(init=False)
    lower: Array = field(init=False)
    upper: Array = field(init=False)
    low: Array = field(init=False)
    high: Array = field(init=False)
    tolerance: Array = field(init=False)
    share: Array = field(init=False)
    must: Array = field(init=False)

    def __post_init__(self) -> None:
        self.low, self.high = (
            np.concatenate([getattr(item, end) for item in self.wanted]) for end in ("low", "high")
        )
        counts = [len(item.low) for item in self.wanted]
        self.tolerance = np.repeat([item.tolerance for item in self.wanted], counts)
        self.share = np.repeat(
            [item.text.weight / np.sqrt(len(item.low)) for item in self.wanted], counts
        )
        self.must = np.repeat([item.text.must for item in self.wanted], counts)
        self.scale = self.free.lengths
        self.lower, self.upper = self.free.lower / self.scale, self.free.upper / self.scale

    def numbers(self, x: Array) -> Array:
        """Return the model parameters for scaled free variables."""
        return np.asarray(self.free.origin + self.free.directions @ (self.scale * x))

    def off(self, values: Array) -> Array:
        """Return the deviation of values from the targets, in tolerances; positive above, negative below."""
        far = np.where(values > self.high, values - self.high, np.minimum(values - self.low, 0.0))
        return np.asarray(far / self.tolerance)

    @property
    def compromise(self) -> Demand:
        """Demand of the compromise: all targets, each in tolerances."""
        return Demand(np.zeros_like(self.share), self.share, _PULL)

    @property
    def bands(self) -> Demand:
        """Demand that all targets are within their tolerances."""
        return Demand(np.full_like(self.share, _INSIDE), self.share, 0.0)

    def residuals(self, x: Array, asked: Demand, *, slopes: bool) -> tuple[Array, Array, bool]:
        """Return residuals, slopes if requested, and whether every target is within its tolerance."""
        values, along = self.evaluator.together(self.numbers(x), slopes=slopes)
        off = self.off(values)
        met = bool(np.all(np.abs(off) <= _WITHIN))
        over = np.sign(off) * np.maximum(np.abs(off) - asked.inside, 0.0)
        if not slopes:
            return asked.share * over, along, met
        active = (over != 0.0) | ((self.low == self.high) & (asked.inside == 0.0))
        rows = (active * asked.share / self.tolerance)[:, None] * along * self.scale
        return asked.share * over, rows, met

    def judge(self, x: Array) -> tuple[float, bool, bool]:
        """Return the cost of the compromise at x, whether all targets are met, and whether the mandatory ones are."""
        values, _ = self.evaluator.together(self.numbers(x), slopes=False)
        off = self.off(values)
        met = np.abs(off) <= _WITHIN
        return (
            float(0.5 * np.sum((self.share * off) ** 2)),
            bool(met.all()),
            bool(met[self.must].all()),
        )

    def descend(self, x: Array, asked: Demand) -> tuple[Array, float, bool, int, str]:
        """Descend from x (Levenberg-Marquardt); return the point, cost, whether all targets are met, steps, reason."""
        x, pull = np.clip(x, self.lower, self.upper), asked.pull
        residuals_here, jacobian, met = self.residuals(x, asked, slopes=True)
        if not np.all(np.isfinite(residuals_here)):
            return x, np.inf, False, 0, "a pose is out of reach"
        damping, why, steps = _DAMPING, UNSETTLED, 0

        def cost_of(residuals: Array, at: Array) -> float:
            return float(0.5 * (residuals @ residuals + pull**2 * (at @ at)))

        cost = cost_of(residuals_here, x)
        for steps in range(1, _STEPS + 1):
            if np.max(np.abs(residuals_here)) <= _REACHED:
                return x, cost, met, steps, "all targets are met"
            gradient = jacobian.T @ residuals_here + pull**2 * x
            held = ((x <= self.lower) & (gradient > 0.0)) | ((x >= self.upper) & (gradient < 0.0))
            free = np.flatnonzero(~held)
            if not len(free) or np.max(np.abs(gradient[free])) < 1e-14:
                why = "no direction makes it better"
                break
            normal = jacobian[:, free].T @ jacobian[:, free] + pull**2 * np.eye(len(free))
            gained = 0.0
            while damping < _LARGEST_DAMPING:
                step = np.zeros_like(x)
                size = damping * np.maximum(np.diag(normal), 1e-9 * np.max(np.diag(normal)))
                step[free] = np.linalg.solve(normal + np.diag(size + 1e-300), -gradient[free])
                tried = np.clip(x + step, self.lower, self.upper)
                residuals, _, _ = self.residuals(tried, asked, slopes=False)
                cost_there = cost_of(residuals, tried) if np.all(np.isfinite(residuals)) else np.inf
                if cost_there < cost:
                    gained, x, cost = cost - cost_there, tried, cost_there
                    damping = max(damping / 5.0, 1e-12)
                    break
                damping *= 4.0
            if gained <= _SETTLED * cost:
                why = "no step makes it better"
                break
            residuals_here, jacobian, met = self.residuals(x, asked, slopes=True)
        return x, cost, met, steps, why

    def move_back(self, x: Array, asked: Demand) -> Array:
        """Move back to the point closest to the rig at which no target is worse than at x, if x meets all targets.

        A descent treats each missed limit as a value to reach, and moves even variables of little influence for it; the
        slight pull is too weak to move them back. Here limits are constraints: the movement is minimised with no value
        farther off than at x. The search starts from x and from the rig, since the path between them may be curved.
        """
        from scipy.optimize import minimize

        here, _ = self.evaluator.together(self.numbers(x), slopes=False)
        slack = (
            np.where(self.low == self.high, np.maximum(asked.inside, _SLACK), asked.inside)
            * self.tolerance
        )
        low, high = np.minimum(self.low - slack, here), np.maximum(self.high + slack, here)
        above, below = np.isfinite(high), np.isfinite(low)
        size = above.sum() + below.sum()
        seen: dict[bytes, tuple[Array, Array]] = {}

        def room(place: Array) -> tuple[Array, Array]:
            """Return the margins of values to their limits, in tolerances, and their slopes."""
            key = place.tobytes()
            if key not in seen:
                values, along = self.evaluator.together(self.numbers(place))
                along = along * self.scale / self.tolerance[:, None]
                inside = np.concatenate(
                    [
                        ((high - values) / self.tolerance)[above],
                        ((values - low) / self.tolerance)[below],
                    ]
                )
                if np.all(np.isfinite(inside)):
                    seen[key] = inside, np.vstack([-along[above], along[below]])
                else:
                    seen[key] = np.full(size, -_FORBIDDEN), np.zeros((size, len(place)))
            return seen[key]

        best = x
        for begin in (x, np.clip(np.zeros_like(x), self.lower, self.upper)):
            solution = minimize(
                lambda place: 0.5 * float(place @ place),
                begin,
                jac=lambda place: place,
                bounds=list(zip(self.lower, self.upper, strict=True)),
                constraints={
                    "type": "ineq",
                    "fun": lambda place: room(place)[0],
                    "jac": lambda place: room(place)[1],
                },
                method="SLSQP",
                options={"maxiter": _STEPS, "ftol": _PRECISION},
            )
            place = np.clip(np.asarray(solution.x, dtype=float), self.lower, self.upper)
            if np.min(room(place)[0]) >= -_SLACK and place @ place < best @ best:
                best = place
        return best

    def satisfy_constraints(self, x: Array) -> tuple[Array, int, str]:
        """Find the compromise that meets the mandatory targets, from x; return the point, rounds and reason."""
        from scipy.optimize import minimize, nnls

        seen: dict[bytes, tuple[float, Array, Array, Array]] = {}

        def at(place: Array) -> tuple[float, Array, Array, Array]:
            """Return the cost and its slopes, and the margins of the constraints with their slopes."""
            key = place.tobytes()
            if key not in seen:
                values, along = self.evaluator.together(self.numbers(place))
                off, along = self.off(values), along * self.scale / self.tolerance[:, None]
                if not np.all(np.isfinite(off)):
                    size = len(place)
                    seen[key] = (
                        np.inf,
                        np.zeros(size),
                        np.full(2 * len(firm), -1.0),
                        np.zeros((2 * len(firm), size)),
                    )
                else:
                    rows = self.share**2 * off
                    from_above = (values - self.high)[firm] / self.tolerance[firm]
                    from_below = (self.low - values)[firm] / self.tolerance[firm]
                    room = _INSIDE - np.concatenate([from_above, from_below])
                    cost = float(0.5 * (rows @ off + _PULL**2 * (place @ place)))
                    slopes = np.vstack([-along[firm], along[firm]])
                    seen[key] = (
                        cost,
                        rows @ along + _PULL**2 * place,
                        np.where(np.isfinite(room), room, 1.0),
                        slopes,
                    )
            return seen[key]

        firm = np.flatnonzero(self.must)
        begin = np.clip(x, self.lower, self.upper)
        size = max(at(begin)[0], _PRECISION)
        solution = minimize(
            lambda place: at(place)[0] / size if np.isfinite(at(place)[0]) else _FORBIDDEN,
            begin,
            jac=lambda place: at(place)[1] / size,
            bounds=list(zip(self.lower, self.upper, strict=True)),
            constraints={
                "type": "ineq",
                "fun": lambda place: at(place)[2],
                "jac": lambda place: at(place)[3],
            },
            method="SLSQP",
            options={"maxiter": _MOST_ROUNDS, "ftol": _PRECISION},
        )
        place = np.clip(np.asarray(solution.x, dtype=float), self.lower, self.upper)
        cost, slope, room, slopes = at(place)
        # The success flag of SLSQP may depend on rounding; the gain of a further step decides instead.
        walls = [np.diag(place < self.lower + _REST), -1.0 * np.diag(place > self.upper - _REST)]
        gain = nnls(np.vstack([slopes[room < _REST], *walls]).T, slope)[1] / size
        rests = solution.success or (np.isfinite(cost) and gain < _REST)
        ended = "no step makes it better" if rests else UNSETTLED
        return place, int(solution.nit), ended


@dataclass(frozen=True)
class Outcome:
    """End of a search, with x scaled by the boxes; ``holds`` is True if the mandatory targets are met."""

    x: Array
    cost: float
    met: bool
    holds: bool
    steps: int
    ended: str
    asked: Demand | None = None
    """Demand of the search, if all targets are met."""

    def move_back(self, search: HardpointSearch) -> Outcome:
        """Move closer to the rig if all targets are met."""
        if self.asked is None:
            return self
        x = search.move_back(self.x, self.asked)
        return Outcome(x, *search.judge(x), self.steps, self.ended, self.asked)

    @property
    def mean_displacement(self) -> float:
        """Root mean square displacement from the rig, in shares of the boxes."""
        return float(np.sqrt(np.mean(self.x**2)))

    @property
    def rank(self) -> tuple[bool, bool, float]:
        """Rank, the lowest is best: first designs that meet all targets, by displacement; then others, by cost."""
        return not self.met, not self.holds, self.mean_displacement if self.met else self.cost


def search_from(search: HardpointSearch, x: Array) -> Outcome:
    """Search from a point; if the compromise misses a target, try to bring all within their tolerances."""
    x, cost, met, steps, ended = search.descend(x, search.compromise)
    if not np.isfinite(cost):
        return Outcome(x, cost, False, False, steps, ended)
    if met:
        return Outcome(x, *search.judge(x), steps, ended, search.compromise)
    best = Outcome(x, cost, met, search.judge(x)[2], steps, ended)
    x, _, met, more, _ = search.descend(x, search.bands)
    steps += more
    if met:
        return Outcome(x, *search.judge(x), steps, "all targets are met", search.bands)
    if search.must.any():
        for begin in (best.x, x):
            x, more, ended = search.satisfy_constraints(begin)
            steps += more
            compromise = Outcome(x, *search.judge(x), steps, ended)
            best = min(best, compromise, key=lambda outcome: outcome.rank)
    return best


def places(search: HardpointSearch, starts: int, seed: int) -> list[Array]:
    """Return starting points: the rig (or the nearest point in the boxes), then a Latin hypercube in the boxes."""
    check_seed(seed)
    random = np.random.default_rng(seed)
    size = len(search.scale)
    first = np.clip(np.zeros(size), search.lower, search.upper)
    strata = (
        np.array([random.permutation(starts - 1) for _ in range(size)]).T
        if starts > 1
        else np.zeros((0, size))
    )
    shares = (strata + random.random(strata.shape)) / max(starts - 1, 1)
    return [first, *(search.lower + shares * (search.upper - search.lower))]


def refuse_idle(search: HardpointSearch, free: Sequence[FreePoint], seed: int) -> None:
    """Reject entries that affect no target, neither at the rig nor at a random point of the boxes."""
    check_seed(seed)
    random = np.random.default_rng(seed + 1)
    random_place = search.lower + random.random(len(search.scale)) * (search.upper - search.lower)
    effect = np.zeros(len(search.scale))
    for x in (np.zeros(len(search.scale)), random_place):
        values, slopes = search.evaluator.at(search.numbers(x))
        for item, value, slope in zip(search.wanted, values, slopes, strict=True):
            if np.all(np.isfinite(value)):
                effect = np.maximum(
                    effect, np.max(np.abs(slope * search.scale), axis=0) / item.tolerance
                )
    for k, entry in enumerate(free):
        own = [j for j, owner in enumerate(search.free.owners) if owner == k]
        if np.max(effect[own]) < _NOTHING:
            raise DescriptionError(
                "has no effect on any target",
                where=f"free[{k}].point",
                found=entry.point,
                hint="Leave it out, or add a target that it affects.",
            )
