"""Approximate an expensive log density by a polynomial fitted to exact values and slopes, sample it and diagnose it.

Around its mode the density of well-measured parameters is nearly Gaussian. A polynomial of third or fourth degree in
whitened coordinates then approximates the log density within hundredths. Exact values and slopes at some tens of points
determine it; new draws, evaluated exactly, measure its error.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations_with_replacement

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import FitError
from jounce.core.optional import require
from jounce.core.types import Array

_DEGREES = (
    (4, 4),
    (10, 3),
)  # up to how many unknowns, and of which degree first; more unknowns have squares only
_HIGHEST = 4  # degree; with values and slopes, ten unknowns need 137 points
_ROWS = 1.5  # equations per coefficient, more than one to allow an error estimate
_CHECKS = 16  # draws that are evaluated exactly
_ROUNDS = 3  # times that points are added if the polynomial is not accurate enough
_FOLDS = 8  # parts of the points, each left out in turn
_GOOD = 0.3  # standard deviation of the error of the log density: weights of draws then differ by as much (1)
_OUTSIDE = 1e-5  # share of a Gaussian outside the region of the polynomial
_FREEDOM = 7.0  # of the proposals' t distribution
_STRETCH = 0.2  # share of steps that follow the shape of the ensemble instead
_ENSEMBLES, _WALKERS = (
    4,
    16,
)  # independent chains, by which convergence is judged; walkers of each, or more

Exact = Callable[[Array], "tuple[float, Array, float] | None"]
"""Log density at given unknowns, its slopes, and an added part without known slopes; None if it cannot be evaluated."""


@dataclass(frozen=True)
class Polynomial:
    """A polynomial of several variables: powers (terms, variables) and coefficients (terms,)."""

    powers: NDArray[np.int64]
    coefficients: Array

    @staticmethod
    def terms(count: int, degree: int) -> NDArray[np.int64]:
        """Return the powers of all terms up to a degree."""
        chosen = [
            term
            for d in range(degree + 1)
            for term in combinations_with_replacement(range(count), d)
        ]
        return np.array([[term.count(i) for i in range(count)] for term in chosen], dtype=np.int64)

    @staticmethod
    def rows(powers: NDArray[np.int64], u: Array) -> Array:
        """Return the values of the terms at points (n, variables), shape (n, terms)."""
        table = np.stack([u**k for k in range(int(powers.max(initial=0)) + 1)])
        values = np.ones((len(u), len(powers)))
        for i in range(u.shape[1]):
            values *= table[powers[:, i], :, i].T
        return values

    @staticmethod
    def slope_rows(powers: NDArray[np.int64], u: Array, i: int) -> Array:
        """Return the derivatives of the terms by variable ``i``, shape (n, terms)."""
        lower = powers.copy()
        lower[:, i] = np.maximum(lower[:, i] - 1, 0)
        return Polynomial.rows(lower, u) * powers[:, i]

    @classmethod
    def through(
        cls, degree: int, u: Array, values: Array, slopes: Array | None = None
    ) -> Polynomial:
        """Fit by least squares to values and, if given, slopes (n, variables) at points (n, variables)."""
        powers = cls.terms(u.shape[1], degree)
        weight = _weights(u)
        rows, right = [weight[:, None] * cls.rows(powers, u)], [weight * values]
        for i in range(u.shape[1] if slopes is not None else 0):
            rows.append(weight[:, None] * cls.slope_rows(powers, u, i))
            right.append(weight * slopes[:, i])  # type: ignore[index]
        return cls(powers, np.linalg.lstsq(np.vstack(rows), np.concatenate(right), rcond=None)[0])

    def __call__(self, u: Array) -> Array:
        """Return the values at points (n, variables), shape (n,)."""
        return np.asarray(self.rows(self.powers, u) @ self.coefficients)

    @cached_property
    def _derivatives(self) -> Array:
        """Coefficients (terms, 1 + variables) of the polynomial and its derivatives, which have the same terms."""
        place = {tuple(power): k for k, power in enumerate(self.powers.tolist())}
        table = np.zeros((len(self.powers), 1 + self.powers.shape[1]))
        table[:, 0] = self.coefficients
        for power, coefficient in zip(self.powers.tolist(), self.coefficients, strict=True):
            for i, k in enumerate(power):
                if k:
                    table[place[(*power[:i], k - 1, *power[i + 1 :])], 1 + i] = k * coefficient
        return table

    def with_slopes(self, u: Array) -> tuple[float, Array]:
        """Return value and slopes (variables,) at one point (variables,)."""
        sums = np.prod(u**self.powers, axis=1) @ self._derivatives
        return float(sums[0]), sums[1:]


def _weights(u: Array) -> Array:
    """Return the weights of points (n, variables); improbable points may be less accurate."""
    return np.asarray(1.0 / (1.0 + 0.1 * np.sum(u**2, axis=1)))


@dataclass(frozen=True)
class Region:
    """Region of the unknowns: around a centre with a covariance (whitened by ``root``), between bounds."""

    centre: Array
    root: Array
    lower: Array
    upper: Array

    @cached_property
    def radius(self) -> float:
        """Whitened distance from the centre within which the density is used."""
        from scipy.stats import chi2

        return float(np.sqrt(chi2.isf(_OUTSIDE, len(self.centre))))

    def unknowns(self, u: Array) -> Array:
        """Return the unknowns at whitened points (n, unknowns)."""
        return np.asarray(self.centre + u @ self.root.T)

    def whiten(self, x: Array) -> Array:
        """Return the whitened points of unknowns (n, unknowns)."""
        return np.asarray(np.linalg.solve(self.root, (x - self.centre).T).T)

    def has(self, u: Array) -> NDArray[np.bool_]:
        """Whether whitened points (n, unknowns) lie inside."""
        x = self.unknowns(u)
        room = 1e-9 * (1.0 + np.abs(self.centre))
        inside = np.all((x >= self.lower - room) & (x <= self.upper + room), axis=1)
        return np.asarray(inside & (np.sum(u**2, axis=1) <= self.radius**2))

    def fold(self, u: Array) -> Array:
        """Reflect points beyond a bound back inside."""
        x = self.unknowns(u)
        x = np.where(
            x < self.lower, 2.0 * self.lower - x, np.where(x > self.upper, 2.0 * self.upper - x, x)
        )
        return self.whiten(np.clip(x, self.lower, self.upper))


@dataclass(frozen=True)
class LogDensity:
    """A log density as a polynomial over a region, with its error at draws that were evaluated exactly.

    ``error`` is the standard deviation of the difference between exact and approximate log density (1); a part without
    slopes contributes the standard error of its trend. ``evaluations`` is the number of exact evaluations.
    """

    region: Region
    polynomial: Polynomial
    error: float
    evaluations: int

    def __call__(self, u: Array) -> Array:
        """Return the log density at whitened points (n, unknowns); minus infinity outside the region."""
        return np.where(self.region.has(u), self.polynomial(u), -np.inf)


def fit_log_density(exact: Exact, region: Region, seed: int) -> LogDensity:
    """Fit a log density to exact values and slopes, check it with new draws, and add points if it is inaccurate."""
    count = len(region.centre)
    first = next((degree for most, degree in _DEGREES if count <= most), 2)
    rng = np.random.default_rng(seed)
    points: list[_Point] = []
    tried = 0

    def evaluate(places: Array) -> list[_Point]:
        nonlocal tried
        tried += len(places)
        both = [(u, exact(x)) for u, x in zip(places, region.unknowns(places), strict=True)]
        return [
            (u, point[0], region.root.T @ point[1], point[2])
            for u, point in both
            if point is not None
        ]

    points += evaluate(_design(region, max(_points_for(count, first), 2 * count + 4), rng))
    for left in range(_ROUNDS - 1, -1, -1):
        if len(points) < _points_for(count, 2):
            raise FitError(
                "too few of the points around the estimate can be simulated", where="posterior"
            )
        polynomial, unsure = _through(points)
        density = LogDensity(region, polynomial, math.nan, tried)
        fresh = sample(density, 4 * _ENSEMBLES * _WALKERS, int(rng.integers(2**31)))[0][:, -1]
        checked = evaluate(fresh[rng.choice(len(fresh), _CHECKS, replace=False)])
        if len(checked) < _CHECKS // 2:
            raise FitError("draws around the estimate cannot be simulated", where="posterior")
        at = np.array([u for u, _, _, _ in checked])
        more, scatter = unsure(at)
        off = np.array([value for _, value, _, _ in checked]) + more - polynomial(at)
        error = float(np.hypot(np.std(off), np.sqrt(np.mean(scatter**2))))
        points += checked
        if error < _GOOD or not left:
            break
        lacking = _points_for(count, _HIGHEST) - len(points)
        points += evaluate(
            _design(region, 1 + 2 * count + min(max(lacking, 0), len(points)), rng)[1 + 2 * count :]
        )
    return LogDensity(
        region, _through(points)[0], error, tried
    )  # including the draws that were checked


def _points_for(count: int, degree: int) -> int:
    """Return the number of points that determine a polynomial by values and slopes, with a margin."""
    return math.ceil(_ROWS * math.comb(count + degree, degree) / (1 + count))


_Point = tuple[Array, float, Array, float]
"""Whitened point, log density, its slopes, and the part without known slopes."""


def _through(points: Sequence[_Point]) -> tuple[Polynomial, Callable[[Array], tuple[Array, Array]]]:
    """Fit a polynomial to values and slopes, and a trend to the part without slopes.

    Cross-validation chooses the degree: exact values scatter by tenths where wheels lift off at some values of the
    parameters and not at others, and a higher degree would follow this scatter to places without points. Returns also
    a function that gives the trend (n,) and its standard error (n,) at whitened points.
    """
    u, values, slopes, more = (np.array(part) for part in zip(*points, strict=True))
    degrees = [d for d in range(2, _HIGHEST + 1) if len(points) >= _points_for(u.shape[1], d)]
    polynomial = Polynomial.through(_predicting(degrees, u, values, slopes)[0], u, values, slopes)
    if not np.any(more):
        return polynomial, lambda at: (np.zeros(len(at)), np.zeros(len(at)))
    degrees = [d for d in range(3) if len(points) >= _ROWS * math.comb(u.shape[1] + d, d)]
    degree, scatter = _predicting(degrees, u, more)
    trend = Polynomial.through(degree, u, more)
    whole = polynomial.coefficients.copy()
    whole[: len(trend.coefficients)] += trend.coefficients  # terms are sorted by degree
    held = np.linalg.pinv(_weights(u)[:, None] * Polynomial.rows(trend.powers, u))
    return Polynomial(polynomial.powers, whole), lambda at: (
        trend(at), scatter * np.linalg.norm(Polynomial.rows(trend.powers, at) @ held, axis=1)
    )  # fmt: skip


def _predicting(
    degrees: Sequence[int], u: Array, values: Array, slopes: Array | None = None
) -> tuple[int, float]:
    """Return the degree with the best cross-validated prediction, and its weighted r.m.s. error."""
    fold = np.arange(len(u)) % _FOLDS
    errors = []
    for degree in degrees:
        off = np.empty(len(u))
        for k in range(_FOLDS):
            training = fold != k
            part = Polynomial.through(
                degree, u[training], values[training], None if slopes is None else slopes[training]
            )
            off[~training] = values[~training] - part(u[~training])
        errors.append(float(np.sqrt(np.mean((_weights(u) * off) ** 2))))
    best = int(np.argmin(errors))
    return degrees[best], errors[best]


def _design(region: Region, count: int, rng: np.random.Generator) -> Array:
    """Return whitened points: the centre, two per axis, and others in random directions at all probable distances."""
    size = len(region.centre)
    axes = 2.0 * np.vstack([np.eye(size), -np.eye(size)])
    more = max(count - 1 - len(axes), 0)
    direction = rng.normal(size=(more, size))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    reach = np.linspace(0.5, 0.9 * region.radius, more + 1)[1:] if more else np.zeros(0)
    return region.fold(np.vstack([np.zeros((1, size)), axes, reach[:, None] * direction]))


def sample(density: LogDensity, count: int, seed: int) -> tuple[Array, float]:
    """Draw at least ``count`` whitened points (chains, draws, unknowns) by emcee, with the share of accepted steps.

    There are four independent ensembles, each of 16 walkers (or four per unknown). Four steps in five propose points of
    a t distribution around the mode, independent of the walker's position; it is close to the density itself. The fifth
    step stretches towards a different walker [goodman2010].
    """
    emcee = require("emcee", "posterior")
    size = len(density.region.centre)
    walkers = max(_WALKERS, 4 * size)
    steps = math.ceil(count / (_ENSEMBLES * walkers))
    chains, accepted = [], []
    for k in range(_ENSEMBLES):
        rng = np.random.default_rng([seed, k])
        moves = [
            (emcee.moves.MHMove(_independent), 1.0 - _STRETCH),
            (emcee.moves.StretchMove(), _STRETCH),
        ]
        sampler = emcee.EnsembleSampler(walkers, size, density, moves=moves, vectorize=True)
        state = emcee.State(_start_points(density, walkers, rng))
        sampler.random_state = np.random.RandomState(int(rng.integers(2**31))).get_state()
        warm = sampler.run_mcmc(
            state, max(50, steps // 10), skip_initial_state_check=True, store=False
        )
        sampler.run_mcmc(warm, steps, skip_initial_state_check=True)
        chains.append(np.swapaxes(sampler.get_chain(), 0, 1))
        accepted.append(float(np.mean(sampler.acceptance_fraction)))
    return np.concatenate(chains), float(np.mean(accepted))


def _start_points(density: LogDensity, walkers: int, rng: np.random.Generator) -> Array:
    """Return start points inside the region."""
    points = density.region.fold(rng.normal(size=(40 * walkers, len(density.region.centre))))
    return points[density.region.has(points)][:walkers]


def _independent(places: Array, random: np.random.RandomState) -> tuple[Array, Array]:
    """Propose points of a t distribution, with the log ratio of the proposal densities."""
    normal = random.normal(size=places.shape)
    new = normal * np.sqrt(_FREEDOM / random.chisquare(_FREEDOM, size=(len(places), 1)))
    power = -0.5 * (_FREEDOM + places.shape[1])

    def log(u: Array) -> Array:
        return np.asarray(power * np.log1p(np.sum(u**2, axis=1) / _FREEDOM))

    return new, log(places) - log(new)


@dataclass(frozen=True)
class Convergence:
    """Diagnostics of one sampled quantity: rank-normalised R-hat (1), effective draws in bulk and tails (1)."""

    r_hat: float
    bulk: float
    tail: float


def by_ensemble(draws: Array) -> Array:
    """Arrange draws (chains, draws) of one quantity by ensemble, with the earlier and later half as separate chains.

    The walkers of an ensemble are short and depend on each other. Convergence therefore requires agreement between
    ensembles, and between their early and late halves.
    """
    chains, each = draws.shape
    half = each // 2
    parts = draws[:, each - 2 * half :].reshape(_ENSEMBLES, chains // _ENSEMBLES, 2, half)
    return np.swapaxes(parts, 1, 2).reshape(_ENSEMBLES, -1)


def convergence(draws: Array) -> Convergence:
    """Diagnose draws (chains, draws) of one quantity with ArviZ [vehtari2021]."""
    arviz = require("arviz_stats.base", "posterior").array_stats
    given = {"chain_axis": 0, "draw_axis": 1}
    return Convergence(
        float(arviz.rhat(draws, method="rank", **given)),
        float(arviz.ess(draws, method="bulk", **given)),
        float(arviz.ess(draws, method="tail", prob=(0.05, 0.95), **given)),
    )


def profile(density: LogDensity, i: int, count: int = 61) -> tuple[Array, Array]:
    """Return unknown ``i`` over the region, and the profile log density there, 0 at its maximum."""
    from scipy.optimize import minimize

    region = density.region
    spread = float(np.sqrt((region.root @ region.root.T)[i, i]))
    reach = min(4.0, region.radius) * spread
    low, high = (
        max(region.lower[i], region.centre[i] - reach),
        min(region.upper[i], region.centre[i] + reach),
    )
    values = np.linspace(low, high, count)
    others = [j for j in range(len(region.centre)) if j != i]
    cov = region.root @ region.root.T
    heights = np.empty(count)
    middle = int(np.argmin(np.abs(values - region.centre[i])))
    for side in (range(middle, count), range(middle, -1, -1)):
        x = region.centre.copy()
        for k in side:
            begin = region.centre + cov[:, i] / cov[i, i] * (values[k] - region.centre[i])
            begin = np.clip(x if k != middle and _better(density, x, begin, values[k], i) else begin,
                            region.lower, region.upper)  # fmt: skip
            x, heights[k] = _climb(density, begin, values[k], i, others, minimize)
    return values, heights - float(np.max(heights))


def _better(density: LogDensity, candidate: Array, other: Array, value: float, i: int) -> bool:
    both = np.array([candidate, other])
    both[:, i] = value
    heights = density.polynomial(density.region.whiten(both))
    return bool(heights[0] > heights[1])


def _climb(
    density: LogDensity,
    begin: Array,
    value: float,
    i: int,
    others: list[int],
    minimize: Callable[..., object],
) -> tuple[Array, float]:
    """Maximise the density with unknown ``i`` held; return the point and the log density there."""
    x = begin.copy()
    x[i] = value
    region = density.region
    if not others:
        return x, float(density.polynomial(region.whiten(x[None]))[0])
    inverse = np.linalg.inv(region.root)
    scale = np.sqrt(np.diag(region.root @ region.root.T))[others]

    def negative_density(z: Array) -> tuple[float, Array]:
        x[others] = begin[others] + scale * z
        value, slopes = density.polynomial.with_slopes(inverse @ (x - region.centre))
        return -value, -(inverse.T @ slopes)[others] * scale

    bounds = [
        (max(-3.0, (region.lower[j] - begin[j]) / s), min(3.0, (region.upper[j] - begin[j]) / s))
        for j, s in zip(others, scale, strict=True)
    ]
    result: object = minimize(
        negative_density, np.zeros(len(others)), jac=True, method="L-BFGS-B", bounds=bounds
    )
    height = -negative_density(np.asarray(result.x))[0]  # type: ignore[attr-defined]
    return x.copy(), height
