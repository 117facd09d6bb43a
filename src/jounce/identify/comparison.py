"""Two signals on the same instants in a handful of numbers: how far apart, how big, how late."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import FitError
from jounce.core.types import Array
from jounce.recordings.alignment import estimate_lag


@dataclass(frozen=True)
class Comparison:
    """What separates a compared (simulated) signal from a reference (measured) one.

    Ratios to something that is zero (a constant or vanishing reference) are NaN, written as null.

    Attributes
    ----------
    rmse : float
        Root mean square of the difference, in the unit of the signals.
    nrmse : float
        ``rmse`` over the root mean square of the reference about its mean (its standard deviation); 0 is perfect, 1 is
        as good as the reference's mean. Not normalised by the range, which would give smaller numbers.
    r2 : float
        Coefficient of determination, ``1 - nrmse^2``; 1 is perfect, negative is worse than the mean.
    peak_error : float
        Largest absolute value of the compared signal over that of the reference, minus 1; positive: too large.
    peak_time_error : float
        Instant of the compared signal's largest absolute value minus that of the reference's, in s; positive: late.
    magnitude : float
        Sprague-Geers M: ratio of root mean squares minus 1; positive: too large. Not sensitive to phase.
    phase : float
        Sprague-Geers P: angle between the signals over pi, 0 to 1. Not sensitive to magnitude.
    combined : float
        Sprague-Geers C: ``sqrt(M^2 + P^2)``.
    lag : float
        Delay of the compared signal with the largest cross-correlation, in s; positive: late.
    samples : int
        Instants compared.
    """

    rmse: float
    nrmse: float
    r2: float
    peak_error: float
    peak_time_error: float
    magnitude: float
    phase: float
    combined: float
    lag: float
    samples: int


def compare(reference: ArrayLike, compared: ArrayLike, time: ArrayLike, *, place: str = "comparison") -> Comparison:
    """Compare a signal with a reference.

    Parameters
    ----------
    reference : array_like, shape (n,)
        The measured signal, any unit.
    compared : array_like, shape (n,)
        The simulated signal on the same instants, same unit.
    time : array_like, shape (n,)
        Instants in s, ascending in constant steps, n >= 3.
    place : str
        Channel or trial named in errors.

    Returns
    -------
    Comparison
        Differences, ratios and delays.

    Raises
    ------
    FitError
        For lengths that differ, fewer than three samples, values that are not finite, or time that does not ascend in
        constant steps.

    Notes
    -----
    Source of M, P, C: M. A. Sprague, T. L. Geers, "A spectral-element method for modelling cavitation in transient
    fluid-structure interaction", Int. J. Numer. Meth. Engng 60 (2004) 2467-2499.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.linspace(0.0, 1.0, 1001)
    >>> result = compare(np.sin(20.0 * t), 1.1 * np.sin(20.0 * t), t)
    >>> round(result.peak_error, 6), round(result.magnitude, 6), round(abs(result.phase), 6), round(abs(result.lag), 9)
    (0.1, 0.1, 0.0, 0.0)
    """
    m, c, t = (np.asarray(values, dtype=float) for values in (reference, compared, time))
    _check(m, c, t, place)
    deviation = m - m.mean()
    constant = np.ptp(m) == 0.0
    rmse = float(np.sqrt(np.mean((c - m) ** 2)))
    nrmse = float("nan") if constant else rmse / float(np.sqrt(np.mean(deviation**2)))
    at_m, at_c = int(np.argmax(np.abs(m))), int(np.argmax(np.abs(c)))
    peak = float(abs(m[at_m]))
    magnitude, phase = _sprague_geers(m, c)
    return Comparison(
        rmse=rmse,
        nrmse=nrmse,
        r2=1.0 - nrmse**2,
        peak_error=float(abs(c[at_c])) / peak - 1.0 if peak > 0.0 else float("nan"),
        peak_time_error=float(t[at_c] - t[at_m]),
        magnitude=magnitude,
        phase=phase,
        combined=float(np.hypot(magnitude, phase)),
        lag=estimate_lag(m, c, (t.size - 1) / float(t[-1] - t[0])),
        samples=t.size,
    )


def _check(reference: Array, compared: Array, time: Array, place: str) -> None:
    if not reference.shape == compared.shape == time.shape or time.ndim != 1 or time.size < 3:
        raise FitError(
            "the signals cannot be compared",
            where=place,
            found=f"shapes {reference.shape}, {compared.shape} and time {time.shape}",
            allowed="signals on the same instants, at least 3",
        )
    if not (np.isfinite(reference).all() and np.isfinite(compared).all()):
        raise FitError("a signal to be compared holds values that are not finite", where=place)
    steps = np.diff(time)
    if not (steps > 0.0).all() or np.ptp(steps) > 0.01 * float(np.median(steps)):
        raise FitError("time does not ascend in constant steps", where=place, hint="Resample the recording first.")


def _sprague_geers(reference: Array, compared: Array) -> tuple[float, float]:
    """M and P; NaN where a signal vanishes."""
    mm, cc = float(reference @ reference), float(compared @ compared)
    if mm == 0.0:
        return float("nan"), float("nan")
    if cc == 0.0:
        return -1.0, float("nan")
    cosine = float(reference @ compared) / float(np.sqrt(mm) * np.sqrt(cc))
    return float(np.sqrt(cc / mm)) - 1.0, float(np.arccos(np.clip(cosine, -1.0, 1.0)) / np.pi)
