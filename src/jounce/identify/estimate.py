"""Estimates with their uncertainty: least squares, replicates, and combination of independent estimates."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from jounce.core.numbers import estimate_text
from jounce.core.shown import Shown
from jounce.core.types import Array


@dataclass(frozen=True)
class Estimate(Shown):
    """A value estimated from measurements, with its uncertainty.

    Attributes
    ----------
    value : float
        The estimate, in the SI unit of the quantity.
    standard_error : float or None
        Standard deviation of the estimate, same unit; None if the data do not determine it.
    interval : (float, float) or None
        Lower and upper end of the 95 % confidence interval, same unit; None if the data do not determine it.
    """

    value: float
    standard_error: float | None = None
    interval: tuple[float, float] | None = None

    def __str__(self) -> str:
        return estimate_text(self, "1")

    def has(self, truth: float) -> bool:
        """Whether the 95 % interval covers ``truth`` (same unit); False without an interval."""
        return self.interval is not None and self.interval[0] <= truth <= self.interval[1]


def student_factor(degrees_of_freedom: float, *, level: float = 0.95) -> float:
    """Return the two-sided Student t factor: half width of an interval in standard errors [1].

    >>> round(student_factor(2), 3), round(student_factor(float("inf")), 3)
    (4.303, 1.96)
    """
    from scipy.special import ndtri, stdtrit

    tail = 0.5 + level / 2.0
    return float(
        ndtri(tail) if math.isinf(degrees_of_freedom) else stdtrit(degrees_of_freedom, tail)
    )


def estimate(
    value: float, standard_error: float | None, degrees_of_freedom: float = math.inf
) -> Estimate:
    """Make an estimate with its 95 % Student interval, symmetric about ``value``.

    Without a finite standard error, or with less than one degree of freedom, the estimate has no interval.

    >>> tuple(round(end, 3) for end in estimate(10.0, 1.0, 2).interval)
    (5.697, 14.303)
    """
    if standard_error is None or not math.isfinite(standard_error) or degrees_of_freedom < 1.0:
        return Estimate(float(value))
    half = student_factor(degrees_of_freedom) * standard_error
    return Estimate(float(value), float(standard_error), (float(value - half), float(value + half)))


def at_least_zero(given: Estimate) -> Estimate:
    """Clip value and interval of a non-negative quantity at zero; the standard error is unchanged.

    >>> at_least_zero(Estimate(-1.0, 1.0, (-3.0, 1.0)))
    Estimate(value=0.0, standard_error=1.0, interval=(0.0, 1.0))
    """
    interval = (
        None
        if given.interval is None
        else (max(0.0, given.interval[0]), max(0.0, given.interval[1]))
    )
    return Estimate(max(0.0, given.value), given.standard_error, interval)


def mean_of_replicates(values: list[float], *, value: float | None = None) -> Estimate:
    """Estimate a quantity from repeated trials, treated as independent replicates.

    ``value`` replaces the reported mean, e.g. by the result of a fit to all points together. The standard error is the
    standard deviation between trials over the root of their number; one trial gives no interval.

    >>> round(mean_of_replicates([1.0, 2.0, 3.0]).standard_error, 4)
    0.5774
    """
    count = len(values)
    mean = sum(values) / count
    if count < 2:
        return Estimate(mean if value is None else value)
    variance = sum((item - mean) ** 2 for item in values) / (count - 1)
    return estimate(mean if value is None else value, math.sqrt(variance / count), count - 1)


def combine(estimates: Sequence[Estimate]) -> Estimate:
    """Combine independent estimates of one quantity (random effects).

    The result is the weighted mean; if a standard error is missing, the plain mean with the scatter between entries.

    >>> combine([Estimate(1.0, 0.1), Estimate(3.0, 0.1)]).value
    2.0
    """
    if len(estimates) == 1:
        return estimates[0]
    values = np.array([item.value for item in estimates])
    errors = np.array([item.standard_error or 0.0 for item in estimates])
    freedom = len(values) - 1
    if np.any(errors <= 0.0):
        return estimate(
            float(values.mean()), float(values.std(ddof=1)) / math.sqrt(len(values)), freedom
        )
    weight = errors**-2.0
    mean = float(np.average(values, weights=weight))
    excess = float(weight @ (values - mean) ** 2) - freedom
    between = max(0.0, excess / float(weight.sum() - (weight**2).sum() / weight.sum()))
    weight = 1.0 / (errors**2 + between)
    mean = float(np.average(values, weights=weight))
    scatter = float(weight @ (values - mean) ** 2) / freedom
    return estimate(mean, math.sqrt(max(scatter, 1.0) / float(weight.sum())), freedom)


@dataclass(frozen=True)
class Uncertainty:
    """Uncertainty of the parameters of a least-squares fit.

    ``covariance`` is that of the parameters (products of their units). ``degrees_of_freedom`` is the effective number
    of independent residuals less the number of parameters, at least 1. ``correlation_time`` is the number of samples
    per independent sample, 1 for white residuals.
    """

    covariance: Array
    degrees_of_freedom: float
    correlation_time: float

    def estimates(self, values: Array) -> tuple[Estimate, ...]:
        """Return one estimate per parameter."""
        errors = np.sqrt(np.maximum(np.diag(self.covariance), 0.0))
        return tuple(
            estimate(float(v), float(e), self.degrees_of_freedom)
            for v, e in zip(values, errors, strict=True)
        )

    def propagate(self, value: float, gradient: Array) -> Estimate:
        """Return the estimate of a quantity computed from the parameters (first-order propagation)."""
        if not np.all(np.isfinite(self.covariance)):
            return Estimate(value)
        variance = float(gradient @ self.covariance @ gradient)
        return estimate(value, math.sqrt(max(variance, 0.0)), self.degrees_of_freedom)


def correlation_time(residual: Array) -> float:
    """Return samples per independent residual [1] (integrated autocorrelation, initial positive sequence)."""
    count = len(residual)
    centred = residual - residual.mean()
    variance = float(centred @ centred)
    if count < 8 or variance <= 0.0:
        return 1.0
    spectrum = np.abs(np.fft.rfft(centred, 2 * count)) ** 2
    correlation = np.fft.irfft(spectrum)[:count] / variance
    pairs = (
        correlation[1 : count // 2 : 2][: (count // 2 - 1) // 2]
        + correlation[2 : count // 2 : 2][: (count // 2 - 1) // 2]
    )
    negative = np.flatnonzero(pairs <= 2.0 / math.sqrt(count))  # 95 % of white noise are below
    stop = int(negative[0]) if len(negative) else len(pairs)
    return float(max(1.0, 1.0 + 2.0 * pairs[:stop].sum()))


def uncertainty(jacobian: Array, residual: Array) -> Uncertainty:
    """Compute the parameter covariance of a least-squares fit, allowing for autocorrelated residuals.

    White residuals give the classical covariance. Otherwise a Newey-West estimate on prewhitened scores is used, whose
    variances are at least the classical ones. Parameters that the data do not determine have infinite variances.

    References
    ----------
    Newey and West (1987), Econometrica 55, 703-708; Andrews and Monahan (1992), Econometrica 60, 953-966.
    """
    count, parameters = jacobian.shape
    scale = np.linalg.norm(jacobian, axis=0)
    if count <= parameters or np.any(scale == 0.0):
        return Uncertainty(np.full((parameters, parameters), np.inf), 1.0, 1.0)
    scaled = jacobian / scale
    inverse = np.linalg.pinv(scaled.T @ scaled, rcond=1e-14)
    classical = inverse * float(residual @ residual) / (count - parameters)
    time = correlation_time(residual)
    covariance = classical
    if time > 1.0:
        covariance = _not_below(
            inverse @ _long_run(scaled * residual[:, None], time) @ inverse, classical
        )
        covariance = covariance * count / max(count - parameters * time, 1.0)
    freedom = max(count / time - parameters, 1.0)
    return Uncertainty(covariance / np.outer(scale, scale), freedom, time)


def _long_run(scores: Array, time: float) -> Array:
    """Compute the long-run sum of squares of the scores: Newey-West on individually prewhitened scores, recoloured."""
    count = len(scores)
    before, after = scores[:-1], scores[1:]
    share = (before * after).sum(axis=0) / np.maximum((before**2).sum(axis=0), 1e-300)
    share = np.clip(share + (1.0 + 3.0 * share) / count, 0.0, 0.97)
    white = after - share * before
    width = min(int(time) + 1, count // 2)
    total: Array = white.T @ white
    for lag in range(1, width + 1):
        cross = white[lag:].T @ white[:-lag]
        total = total + (1.0 - lag / (width + 1.0)) * (cross + cross.T)
    return total * count / (count - 1) / np.outer(1.0 - share, 1.0 - share)


def _not_below(covariance: Array, floor: Array) -> Array:
    """Raise variances of ``covariance`` to at least those of ``floor``, keeping its correlations."""
    variance = np.maximum(np.diag(covariance), 1e-300)
    factor = np.sqrt(np.maximum(np.diag(floor) / variance, 1.0))
    raised: Array = covariance * np.outer(factor, factor)
    return raised


def linear_least_squares(regressors: Array, target: Array) -> tuple[Array, Array, Uncertainty]:
    """Fit ``target = regressors @ coefficients``; return coefficients, measured minus fitted, and uncertainty."""
    scale = np.linalg.norm(regressors, axis=0)
    scale = np.where(scale > 0.0, scale, 1.0)
    coefficients = np.linalg.lstsq(regressors / scale, target, rcond=None)[0] / scale
    residual = target - regressors @ coefficients
    return coefficients, residual, uncertainty(regressors, residual)


def correlation_of(covariance: Array) -> Array:
    """Return the correlation matrix of a covariance; rows without variance are zero."""
    deviation = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        correlation = covariance / np.outer(deviation, deviation)
    return np.asarray(np.nan_to_num(correlation, nan=0.0, posinf=0.0, neginf=0.0), dtype=float)


def r_squared(measured: Array, residual: Array) -> float:
    """Return the share of the variance explained [1]; 0 if the measured values are constant."""
    spread = measured - measured.mean()
    total = float(spread @ spread)
    return 1.0 - float(residual @ residual) / total if total > 0.0 else 0.0


def central_differences(function: Callable[[Array], Array], values: Array, steps: Array) -> Array:
    """Return derivatives of a function by each of its arguments, shape (..., values), by central differences."""
    moves = np.diag(steps)
    columns = [
        (function(values + move) - function(values - move)) / (2.0 * step)
        for move, step in zip(moves, steps, strict=True)
    ]
    return np.stack(columns, axis=-1)
