"""The search between competing goals, shared by all Pareto fronts.

The corners of a front minimise one goal each. Between them, the worst normalised goal is minimised along mixtures of
the goals (the achievement function of the reference-point method); this also finds nonconvex parts of a front. With
exact gradients each search takes only tens of designs.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import ClassVar, NamedTuple

import numpy as np

from jounce.core.types import Array
from jounce.design.mixtures import achievement

SHARE = (
    1e-3  # weight of the other goals relative to the worst one: excludes weakly dominated designs
)
_PRECISION = 1e-10  # of the achievement, which is about 1: far finer than the resolution of a plot
_STILL = 1e-6  # scaled movement after a restart below which a search has converged


class Aim(NamedTuple):
    """Aim of a search between the corners: best values of the goals, their ranges, and the mixture of them."""

    best: Array
    span: Array
    mixture: Array


class FrontSearch:
    """Goals and constraints of designs, with their slopes along scaled variables."""

    rounds: ClassVar[int]  # steps of one search
    tries: ClassVar[int] = 1  # restarts of a search that has not converged

    def run(self, x: Array, aim: Aim) -> tuple[Array, bool]:
        """Search towards an aim from a design; return the design and whether the search converged."""
        raise NotImplementedError

    def rank(self, x: Array, aim: Aim) -> tuple[float, float]:
        """Rank a design, the lowest is best: violation of the constraints, then the worst normalised goal."""
        raise NotImplementedError

    def rows(self, u: Array) -> tuple[Array, Array, Sequence[int]]:
        """Return goals at scaled variables (one or several rows each), their slopes, and the goal of each row."""
        raise NotImplementedError

    def room(self, u: Array) -> tuple[Array, Array]:
        """Return the margins of the constraints at scaled variables (negative if violated), and their slopes."""
        raise NotImplementedError

    def between(
        self, tried: list[Array], best: Array, span: Array, mixtures: Iterable[Array]
    ) -> bool:
        """Add a design to those ``tried`` for each mixture of goals; return whether all searches converged."""
        is_settled = True
        for mixture in mixtures:
            aim = Aim(best, span, mixture)
            begins = sorted(tried, key=lambda x: self.rank(x, aim))[:2]
            x, is_at_rest = min(
                (self.run(x, aim) for x in begins), key=lambda end: self.rank(end[0], aim)
            )
            tried.append(x)
            is_settled &= is_at_rest
        return is_settled

    def towards(
        self, begin: Array, goals: Array, aim: Aim, lower: Array, upper: Array
    ) -> tuple[Array, bool]:
        """Minimise the worst normalised goal, starting from scaled variables whose ``goals`` are already known."""
        from scipy.optimize import minimize

        size = len(begin)

        def least(z: Array) -> tuple[float, Array]:
            goals, slopes, of = self.rows(z[:size])
            span = aim.span[of]
            beside = SHARE * float(np.sum((goals - aim.best[of]) / span))
            return float(z[size]) + beside, np.append(
                SHARE * (slopes / span[:, None]).sum(axis=0), 1.0
            )

        def room(z: Array) -> tuple[Array, Array]:
            goals, slopes, of = self.rows(z[:size])
            width = (aim.span * aim.mixture)[of]
            firm, table = self.room(z[:size])
            rows = np.hstack([-slopes / width[:, None], np.ones((len(goals), 1))])
            left = np.concatenate([z[size] - (goals - aim.best[of]) / width, firm])
            return left, np.vstack([rows, np.hstack([table, np.zeros((len(firm), 1))])])

        z, is_at_rest = np.append(begin, achievement(goals, *aim)), False
        for _ in range(
            self.tries
        ):  # a restart resets the curvature estimate of SLSQP, which helps after a stall
            result = minimize(
                least, z, jac=True, method="SLSQP",
                bounds=[*zip(lower, upper, strict=True), (None, None)],
                constraints={"type": "ineq", "fun": lambda z: room(z)[0], "jac": lambda z: room(z)[1]},
                options={"ftol": _PRECISION, "maxiter": self.rounds},
            )  # fmt: skip
            moved = float(np.max(np.abs(result.x - z)))
            z, is_at_rest = np.asarray(result.x), bool(result.success) or moved < _STILL
            if is_at_rest:
                break
        return np.clip(z[:size], lower, upper), is_at_rest
