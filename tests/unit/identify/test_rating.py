from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import FitError
from jounce.identify.comparison import (
    _rival,
    _smooth_slope,
    corridor_score,
    grade_of,
    iso18571,
    magnitude_score,
    slope_score,
)

RATE = 10e3
TIME = np.arange(3000) / RATE
BUMP = np.exp(-(((TIME - 0.1) / 0.01) ** 2))


def late_bump(delay: float) -> np.ndarray:
    return np.exp(-(((TIME - 0.1 - delay) / 0.01) ** 2))


def test_a_signal_matches_itself() -> None:
    rating = iso18571(BUMP, BUMP, RATE)
    assert (rating.corridor, rating.phase, rating.magnitude, rating.slope, rating.rating) == (
        1.0,
        1.0,
        1.0,
        1.0,
        1.0,
    )
    assert (rating.grade, rating.shift, rating.findings) == ("excellent", 0.0, ())


@pytest.mark.parametrize("delay", [-0.02, 0.006, 0.03])
def test_phase_score_of_a_pure_delay(delay: float) -> None:
    rating = iso18571(BUMP, late_bump(delay), RATE)
    assert rating.shift == pytest.approx(delay, abs=1e-9)
    assert rating.phase == pytest.approx(
        1.0 - abs(delay) / (0.2 * 0.3), abs=1e-9
    )  # 20 % of 3000 samples
    assert rating.magnitude == pytest.approx(1.0, abs=1e-6)
    assert rating.slope == pytest.approx(1.0, abs=1e-6)


def test_scores_of_a_pure_scale() -> None:
    rating = iso18571(BUMP, 1.2 * BUMP, RATE)
    assert rating.phase == 1.0
    assert rating.slope == pytest.approx(1.0 - 0.2 / 2.0, abs=1e-9)  # slope error 20 % of 200 %
    share = np.clip(
        (0.5 - 0.2 * BUMP) / 0.45, 0.0, 1.0
    )  # corridors of 5 % and 50 % of the largest value, 1
    assert rating.corridor == pytest.approx(np.mean(share**2), abs=1e-12)
    total = 0.4 * rating.corridor + 0.2 * (rating.phase + rating.magnitude + rating.slope)
    assert rating.rating == pytest.approx(total, abs=1e-15)


def test_rating_is_relative_to_the_reference() -> None:
    one, other = iso18571(BUMP, 1.4 * BUMP, RATE), iso18571(1.4 * BUMP, BUMP, RATE)
    assert one.slope == pytest.approx(0.8, abs=1e-9)
    assert other.slope == pytest.approx(1.0 - 0.4 / 1.4 / 2.0, abs=1e-9)


def test_opposite_signal_is_poor() -> None:
    rating = iso18571(BUMP, -3.0 * BUMP, RATE)
    assert rating.grade == "poor"
    assert rating.slope == 0.0
    assert 0.0 <= rating.rating < 0.58


def test_shift_stops_at_a_fifth_of_the_record() -> None:
    rating = iso18571(BUMP, late_bump(0.065), RATE)
    assert rating.phase == 0.0
    assert abs(rating.shift) == pytest.approx(0.06, abs=1e-9)


@pytest.mark.parametrize(
    ("rating", "grade"),
    [
        (1.0, "excellent"),
        (0.9401, "excellent"),
        (0.94, "good"),
        (0.8, "fair"),
        (0.81, "good"),
        (0.58, "poor"),
        (0, "poor"),
    ],
)
def test_grades(rating: float, grade: str) -> None:
    assert grade_of(rating) == grade


def test_slow_records_are_resampled_with_a_finding() -> None:
    fast, slow = (
        iso18571(BUMP, 1.2 * late_bump(0.004), RATE),
        iso18571(BUMP[::10], 1.2 * late_bump(0.004)[::10], 1000.0),
    )
    assert [(f.severity, f.value) for f in slow.findings] == [("note", 1000.0)]
    assert "10 kHz" in slow.findings[0].message
    assert slow.rating == pytest.approx(fast.rating, abs=2e-3)
    assert slow.shift == pytest.approx(0.004, abs=1.01e-4)


def test_fast_records_are_resampled_silently() -> None:
    t = np.arange(12_000) / 40e3
    fast = np.exp(-(((t - 0.1) / 0.01) ** 2))
    rating = iso18571(fast, 1.2 * fast, 40e3)
    assert rating.findings == ()
    assert rating.rating == pytest.approx(iso18571(BUMP, 1.2 * BUMP, RATE).rating, abs=1e-3)


def test_periodic_signals_are_ambiguous() -> None:
    wave = np.sin(2.0 * np.pi * 60.0 * TIME)
    rating = iso18571(wave, np.sin(2.0 * np.pi * 60.0 * TIME + 0.9), RATE)
    assert abs(rating.shift) > 0.05  # the standard takes the largest correlation, by however little
    (finding,) = rating.findings
    assert finding.severity == "warning"
    assert finding.value == pytest.approx(-0.9 / (2.0 * np.pi * 60.0), abs=1e-4)
    assert iso18571(wave, wave, RATE).shift == 0.0  # among equal ones the smallest counts


def test_constant_compared_signal() -> None:
    rating = iso18571(BUMP, np.zeros(TIME.size), RATE)
    assert rating.shift == 0.0
    assert rating.phase == 1.0
    assert rating.magnitude == 0.0
    assert rating.slope == pytest.approx(0.5, abs=1e-12)


def test_edges_of_the_corridors_and_of_the_slope_average() -> None:
    reference = np.full(20, 2.0)
    assert corridor_score(reference, reference + 0.1) == pytest.approx(
        1.0, abs=1e-12
    )  # inner: 5 % of 2
    assert corridor_score(reference, reference + 1.0) == pytest.approx(
        0.0, abs=1e-12
    )  # outer: 50 % of 2
    assert corridor_score(reference, reference + 0.55) == pytest.approx(
        0.25, abs=1e-12
    )  # half way, squared
    ramp = np.arange(20.0)
    assert slope_score(ramp, 2.0 * ramp) == pytest.approx(0.5, abs=1e-12)
    assert slope_score(ramp, ramp + 7.0) == 1.0


@pytest.mark.parametrize(
    ("reference", "compared", "rate", "message"),
    [
        (BUMP, BUMP[1:], RATE, r"trial 3: .*found 'shapes \(3000,\) and \(2999,\)'"),
        (BUMP[:11], BUMP[:11], RATE, "at least 12 samples"),
        (BUMP * 0.0, BUMP, RATE, "the reference is constant"),
        (np.where(TIME > 0.1, np.nan, BUMP), BUMP, RATE, "not finite"),
        (BUMP, np.where(TIME > 0.1, np.inf, BUMP), RATE, "not finite"),
        (BUMP, BUMP, 0.0, "sample rate is not positive"),
        (BUMP, BUMP, float("nan"), "sample rate is not positive"),
    ],
)
def test_bad_input(reference: np.ndarray, compared: np.ndarray, rate: float, message: str) -> None:
    with pytest.raises(FitError, match=message):
        iso18571(reference, compared, rate, place="trial 3")


def test_a_rival_is_a_smaller_shift_behind_a_valley() -> None:
    coefficients = np.array([0.0, 0.0, 0.0, 0.5, 0.995, 0.5, 0.6, 1.0, 0.0, 0.0])
    assert _rival(coefficients, 7, 5) == -1
    assert _rival(coefficients, 6, 5) is None  # between neighbours there is no room for one
    for height, valley, found in ((0.991, 0.94, -1), (0.989, 0.94, None), (0.991, 0.96, None)):
        assert (
            _rival(np.where(coefficients == 0.995, height, np.maximum(coefficients, valley)), 7, 5)
            == found
        )


def test_slopes_are_averaged_over_nine_samples_and_over_fewer_towards_the_ends() -> None:
    values = np.random.default_rng(7).normal(size=15)
    slope = np.gradient(values)
    widths = [0, 1, 2, 3, *[4] * 7, 3, 2, 1, 0]
    expected = [slope[i - w : i + w + 1].mean() for i, w in enumerate(widths)]
    assert _smooth_slope(values) == pytest.approx(expected, rel=1e-12)


def test_signals_are_warped_within_a_tenth_of_their_length() -> None:
    """A spike of one sample is reached 19 samples away, and not 20, in a record of 200."""
    for late, score in ((19, 1.0), (20, 0.0)):
        assert magnitude_score(np.eye(200)[60], np.eye(200)[60 + late]) == score


@pytest.mark.parametrize(("below", "told"), [(0.98e-6, 0), (1.04e-6, 1)])
def test_a_rate_a_millionth_below_that_of_the_standard_is_that_of_the_standard(
    below: float, told: int
) -> None:
    assert len(iso18571(BUMP, BUMP, RATE * (1.0 - below)).findings) == told
