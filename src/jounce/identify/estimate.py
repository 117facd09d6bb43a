"""An estimated number with its uncertainty."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Estimate:
    """A number found from measurements, and how well it is known.

    Attributes
    ----------
    value : float
        The estimate, in the SI unit of the quantity.
    standard_error : float or None
        Standard deviation of the estimate, same unit; None when the data cannot tell.
    interval : (float, float) or None
        Lower and upper end of the 95 % confidence interval, same unit; None when the data cannot tell.
    """

    value: float
    standard_error: float | None = None
    interval: tuple[float, float] | None = None

    def has(self, truth: float) -> bool:
        """Tell whether the 95 % interval covers ``truth`` (same unit); False where there is no interval."""
        return self.interval is not None and self.interval[0] <= truth <= self.interval[1]


def student_factor(degrees_of_freedom: float, *, level: float = 0.95) -> float:
    """Give the two-sided Student t factor.

    Parameters
    ----------
    degrees_of_freedom : float
        Number of independent residuals [1], at least 1; infinity gives the normal distribution.
    level : float
        Probability inside the interval [1].

    Returns
    -------
    float
        Half width of the interval in standard errors [1].

    Examples
    --------
    >>> round(student_factor(2), 3), round(student_factor(float("inf")), 3)
    (4.303, 1.96)
    """
    from scipy.special import ndtri, stdtrit

    tail = 0.5 + level / 2.0
    return float(ndtri(tail) if math.isinf(degrees_of_freedom) else stdtrit(degrees_of_freedom, tail))


def estimate(value: float, standard_error: float | None, degrees_of_freedom: float = math.inf) -> Estimate:
    """Make an estimate with its 95 % Student interval.

    Parameters
    ----------
    value : float
        The estimate, SI.
    standard_error : float or None
        Its standard deviation, same unit. None, NaN or infinity: the result carries no interval.
    degrees_of_freedom : float
        Independent residuals behind the standard error [1]; below 1 the result carries no interval.

    Returns
    -------
    Estimate
        Symmetric about ``value``.

    Examples
    --------
    >>> tuple(round(end, 3) for end in estimate(10.0, 1.0, 2).interval)
    (5.697, 14.303)
    """
    if standard_error is None or not math.isfinite(standard_error) or degrees_of_freedom < 1.0:
        return Estimate(float(value))
    half = student_factor(degrees_of_freedom) * standard_error
    return Estimate(float(value), float(standard_error), (float(value - half), float(value + half)))


def at_least_zero(found: Estimate) -> Estimate:
    """Cut value and interval of a quantity that cannot be negative at zero; the standard error stays.

    Examples
    --------
    >>> at_least_zero(Estimate(-1.0, 1.0, (-3.0, 1.0)))
    Estimate(value=0.0, standard_error=1.0, interval=(0.0, 1.0))
    """
    interval = None if found.interval is None else (max(0.0, found.interval[0]), max(0.0, found.interval[1]))
    return Estimate(max(0.0, found.value), found.standard_error, interval)


def mean_of_replicates(values: list[float], *, value: float | None = None) -> Estimate:
    """Estimate a quantity from repeated trials, the trials being the independent replicates.

    Parameters
    ----------
    values : list of float
        One value per trial, SI.
    value : float or None
        What to report instead of the mean, e.g. the value of a fit through all points together.

    Returns
    -------
    Estimate
        Standard error = standard deviation between trials / sqrt(number of trials), Student interval with
        (number - 1) degrees of freedom; no interval for a single trial.

    Examples
    --------
    >>> round(mean_of_replicates([1.0, 2.0, 3.0]).standard_error, 4)
    0.5774
    """
    count = len(values)
    mean = sum(values) / count
    if count < 2:
        return Estimate(mean if value is None else value)
    variance = sum((item - mean) ** 2 for item in values) / (count - 1)
    return estimate(mean if value is None else value, math.sqrt(variance / count), count - 1)
