"""Compare two signals sampled at the same instants: error measures, and the rating of ISO/TS 18571."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, floor
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import FitError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.types import Array
from jounce.identify.warping import warping_path
from jounce.recordings.signals import correlation_coefficients, estimate_lag, resample

# differences ----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Comparison:
    """Differences between a compared (simulated) signal and a reference (measured) one.

    Ratios with a zero denominator (a constant or vanishing reference) are NaN, written as null.

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


def compare(
    reference: ArrayLike, compared: ArrayLike, time: ArrayLike, *, place: str = "comparison"
) -> Comparison:
    """Compare a signal with a measured reference of the same unit, sampled at the same instants.

    ``time`` (s) must increase in constant steps and have at least three samples. Errors mention ``place``.

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
    m, c, t = (
        as_samples(values, si, where=place)
        for values, si in ((reference, ""), (compared, ""), (time, "s"))
    )
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
            allowed="signals at the same instants, at least 3 samples",
        )
    if not (np.isfinite(reference).all() and np.isfinite(compared).all()):
        raise FitError("a signal to be compared contains values that are not finite", where=place)
    steps = np.diff(time)
    # 1 %, as for recordings.
    if not (steps > 0.0).all() or np.ptp(steps) > 0.01 * float(np.median(steps)):
        raise FitError(
            "time does not increase in constant steps",
            where=place,
            hint="Resample the recording first.",
        )


def _sprague_geers(reference: Array, compared: Array) -> tuple[float, float]:
    """Return M and P; NaN if a signal vanishes."""
    mm, cc = float(reference @ reference), float(compared @ compared)
    if mm == 0.0:
        return float("nan"), float("nan")
    if cc == 0.0:
        return -1.0, float("nan")
    cosine = float(reference @ compared) / float(np.sqrt(mm) * np.sqrt(cc))
    return float(np.sqrt(cc / mm)) - 1.0, float(np.arccos(np.clip(cosine, -1.0, 1.0)) / np.pi)


# rating by ISO/TS 18571 -----------------------------------------------------------------------------------------------


Grade = Literal["excellent", "good", "fair", "poor"]
# Default parameters of ISO/TS 18571:2014, except for the shortest signal:
SAMPLE_RATE = 10_000.0  # Hz
INNER_CORRIDOR, OUTER_CORRIDOR, CORRIDOR_EXPONENT = (
    0.05,
    0.5,
    2,
)  # as shares of the largest absolute value; 1
LARGEST_SHIFT = 0.2  # as a share of the length
WARPING_WINDOW, LARGEST_MAGNITUDE_ERROR, LARGEST_SLOPE_ERROR = (
    0.1,
    0.5,
    2.0,
)  # as shares of the length and of the reference's size
WEIGHTS = (0.4, 0.2, 0.2, 0.2)  # for corridor, phase, magnitude and slope
SHORTEST = 12  # samples: slopes are averaged over nine
GRADES: tuple[tuple[float, Grade], ...] = ((0.94, "excellent"), (0.80, "good"), (0.58, "fair"))
_TIE = 1e-12  # correlation: smaller differences are rounding
_NEARLY, _VALLEY = (
    0.01,
    0.05,
)  # correlation: a rival peak is nearly as high and separated by a valley


@dataclass(frozen=True)
class Rating:
    """How well one signal reproduces another by ISO/TS 18571, each score from 0 (no match) to 1 (perfect).

    Attributes
    ----------
    corridor : float
        Share of agreement within corridors of 5 % and 50 % of the reference's largest absolute value.
    phase : float
        1 without a shift, 0 when the best shift reaches 20 % of the record.
    magnitude : float
        From the difference that remains after shift and time warping; 0 for errors of 50 % or more.
    slope : float
        From the difference of the smoothed slopes after the shift; 0 for errors of 200 % or more.
    rating : float
        0.4 corridor + 0.2 phase + 0.2 magnitude + 0.2 slope.
    grade : {"excellent", "good", "fair", "poor"}
        By ``rating``: above 0.94, above 0.80, above 0.58, or less.
    shift : float
        Best shift in s, positive when the compared signal comes later.
    findings : tuple of Finding
        What limits the rating, e.g. a sample rate below the 10 kHz of the standard.
    """

    corridor: float
    phase: float
    magnitude: float
    slope: float
    rating: float
    grade: Grade
    shift: float
    findings: tuple[Finding, ...] = ()


def iso18571(
    reference: ArrayLike, compared: ArrayLike, sample_rate: float, *, place: str = "rating"
) -> Rating:
    """Rate a signal against a measured reference by ISO/TS 18571:2014 with its default parameters.

    Both signals share their instants and unit and have at least 12 samples. The reference must not be constant, as the
    standard defines no rating for it. The standard works at 10 kHz: signals at other rates (Hz) are resampled (cubic
    spline, band-limited before downsampling), with a finding if the rate is lower. The rating is not symmetric: it is
    relative to the size of ``reference``. A constant compared signal gets phase score 1, because no shift improves its
    correlation.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(0.0, 0.5, 1e-4)
    >>> bump = np.exp(-(((t - 0.2) / 0.03) ** 2))
    >>> iso18571(bump, bump, 10e3).rating, iso18571(bump, 1.1 * bump, 10e3).grade
    (1.0, 'excellent')
    """
    t, c = as_samples(reference, where=place), as_samples(compared, where=place)
    _check_rated(t, c, sample_rate, place)
    findings = []
    if abs(sample_rate - SAMPLE_RATE) > 1e-6 * SAMPLE_RATE:
        if sample_rate < SAMPLE_RATE:
            findings.append(
                finding("identify.sampled_slowly", place, sample_rate, sample_rate=sample_rate)
            )
        both = resample(np.arange(t.size) / sample_rate, np.stack((t, c), axis=1), SAMPLE_RATE)[1]
        t, c = np.ascontiguousarray(both[:, 0]), np.ascontiguousarray(both[:, 1])
    shift, rival = best_shift(t, c)
    if rival is not None:
        findings.append(
            finding(
                "identify.signals_repeat",
                place,
                rival / SAMPLE_RATE,
                rival=rival / SAMPLE_RATE,
                shift=shift / SAMPLE_RATE,
            )
        )
    shifted_t, shifted_c = _overlap(t, c, shift)
    scores = (
        corridor_score(t, c),
        max(0.0, 1.0 - abs(shift) / (LARGEST_SHIFT * t.size)),
        magnitude_score(shifted_t, shifted_c),
        slope_score(shifted_t, shifted_c),
    )
    rating = float(sum(w * score for w, score in zip(WEIGHTS, scores, strict=True)))
    return Rating(*scores, rating, grade_of(rating), shift / SAMPLE_RATE, tuple(findings))


def _check_rated(reference: Array, compared: Array, sample_rate: float, place: str) -> None:
    if reference.shape != compared.shape or reference.ndim != 1 or reference.size < SHORTEST:
        raise FitError(
            "the signals cannot be rated",
            where=place,
            found=f"shapes {reference.shape} and {compared.shape}",
            allowed=Phrase(
                "two signals of the same length, at least {shortest} samples", shortest=SHORTEST
            ),
        )
    if not (np.isfinite(reference).all() and np.isfinite(compared).all()):
        raise FitError("a signal to be rated contains values that are not finite", where=place)
    if not sample_rate > 0.0:
        raise FitError("the sample rate is not positive", where=place, found=f"{sample_rate:g} Hz")
    if np.ptp(reference) == 0.0:
        raise FitError(
            "the reference is constant, ISO/TS 18571 defines no rating for it",
            where=place,
            found=float(reference[0]),
        )


def grade_of(rating: float) -> Grade:
    """Return the grade of an overall rating (0 to 1) on the sliding scale of ISO/TS 18571."""
    return next((grade for limit, grade in GRADES if rating > limit), "poor")


def corridor_score(reference: Array, compared: Array) -> float:
    """Return the corridor score: the mean over the samples of 1 inside, 0 outside and a quadratic in between."""
    size = float(np.abs(reference).max())
    inner, outer = INNER_CORRIDOR * size, OUTER_CORRIDOR * size
    share = np.clip((outer - np.abs(reference - compared)) / (outer - inner), 0.0, 1.0)
    return float(np.mean(share**CORRIDOR_EXPONENT))


def best_shift(reference: Array, compared: Array) -> tuple[int, int | None]:
    """Find the shift in samples, at most 20 % either way, with the largest correlation coefficient.

    The shift is positive when ``compared`` comes later. Among equal correlations the smallest shift is chosen, then the
    positive one. One Fourier transform gives the coefficients of all shifts; those near the maximum are recomputed
    directly. The second value is a smaller shift that correlates almost as well, as in periodic signals, or None.
    """
    most = floor(reference.size * LARGEST_SHIFT)
    roughly = correlation_coefficients(reference, compared, most)
    near = np.flatnonzero(roughly >= roughly.max() - 1e-9) - most
    order = near[np.lexsort((near < 0, np.abs(near)))]
    best, largest = 0, _correlation(reference, compared, 0)
    for shift in order.tolist():
        value = _correlation(reference, compared, shift)
        if value > largest + _TIE:
            best, largest = shift, value
    return best, _rival(roughly, best + most, most)


def _rival(correlations: Array, best: int, middle: int) -> int | None:
    """Find the smallest shift at a separate maximum that is nearly as high as the one at index ``best``."""
    reach = abs(best - middle)
    inner = correlations[middle - reach : middle + reach + 1]
    if reach < 2:
        return None
    top = correlations[best]
    peaks = (
        np.flatnonzero(
            (inner[1:-1] >= inner[:-2]) & (inner[1:-1] >= inner[2:]) & (inner[1:-1] > top - _NEARLY)
        )
        + 1
    )
    peaks += middle - reach
    for index in peaks[np.argsort(np.abs(peaks - middle))].tolist():
        between = correlations[min(index, best) : max(index, best) + 1]
        if between.min() < top - _VALLEY:
            return int(index - middle)
    return None


def _overlap(reference: Array, compared: Array, shift: int) -> tuple[Array, Array]:
    """Return the overlapping parts of both signals when the compared one comes ``shift`` samples later."""
    if shift >= 0:
        return reference[: reference.size - shift], compared[shift:]
    return reference[-shift:], compared[:shift]


def _correlation(reference: Array, compared: Array, shift: int) -> float:
    t, c = _overlap(reference, compared, shift)
    t, c = t - t.mean(), c - c.mean()
    size = float(np.sqrt((t @ t) * (c @ c)))
    return float(t @ c) / size if size > 0.0 else -1.0


def magnitude_score(reference: Array, compared: Array) -> float:
    """Return the magnitude score of shifted signals, from their difference after dynamic time warping."""
    i, j = warping_path(compared, reference, ceil(WARPING_WINDOW * reference.size) - 1)
    return _linear_score(compared[i] - reference[j], reference[j], LARGEST_MAGNITUDE_ERROR)


def slope_score(reference: Array, compared: Array) -> float:
    """Return the slope score of shifted signals, from the difference of their derivatives, smoothed over 9 samples."""
    slope_t, slope_c = _smooth_slope(reference), _smooth_slope(compared)
    return _linear_score(slope_c - slope_t, slope_t, LARGEST_SLOPE_ERROR)


def _linear_score(difference: Array, reference: Array, largest: float) -> float:
    size, error = float(np.abs(reference).sum()), float(np.abs(difference).sum())
    if error == 0.0:
        return 1.0
    return max(0.0, 1.0 - error / size / largest) if size > 0.0 else 0.0


def _smooth_slope(values: Array) -> Array:
    """Return the difference per sample, averaged over 9 neighbours; over 7, 5, 3 and 1 towards both ends."""
    slope = np.gradient(values)
    smooth = np.empty_like(slope)
    smooth[4:-4] = np.convolve(slope, np.full(9, 1.0 / 9.0), mode="valid")
    for index in range(4):
        smooth[index] = slope[: 2 * index + 1].mean()
        smooth[-1 - index] = slope[-1 - 2 * index :].mean()
    return smooth
