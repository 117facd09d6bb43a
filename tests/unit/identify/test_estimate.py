"""Estimates and their intervals."""

import math

import numpy as np
import pytest

from jounce.identify.estimate import (
    Estimate,
    Uncertainty,
    _long_run,
    _not_below,
    at_least_zero,
    central_differences,
    combine,
    correlation_of,
    estimate,
    mean_of_replicates,
    student_factor,
)


@pytest.mark.parametrize(
    ("freedom", "factor"),
    # Student t, two-sided 95 %: any table, e.g. NIST/SEMATECH e-Handbook 1.3.6.7.2
    [(1, 12.706), (2, 4.303), (4, 2.776), (10, 2.228), (30, 2.042), (math.inf, 1.960)],
)
def test_student_factor_is_that_of_the_tables(freedom, factor):
    assert student_factor(freedom) == pytest.approx(factor, abs=6e-4)


def test_interval_is_symmetric_and_covers_its_value():
    found = estimate(5.0, 2.0, 4)
    assert found.interval[1] - 5.0 == pytest.approx(5.0 - found.interval[0])
    assert found.has(5.0)
    assert not found.has(5.0 + 2.78 * 2.0)


@pytest.mark.parametrize("error", [None, math.nan, math.inf])
def test_an_unknown_error_gives_no_interval(error):
    assert estimate(1.0, error, 5) == Estimate(1.0)
    assert not Estimate(1.0).has(1.0)


def test_too_few_residuals_give_no_interval():
    assert estimate(1.0, 0.1, 0.5).interval is None


def test_a_quantity_that_cannot_be_negative_is_cut_at_zero():
    assert at_least_zero(Estimate(1.0, 2.0, (-3.0, 5.0))) == Estimate(1.0, 2.0, (0.0, 5.0))
    assert at_least_zero(Estimate(-1.0, 2.0, (-5.0, -0.5))).interval == (0.0, 0.0)
    assert at_least_zero(Estimate(-1.0)) == Estimate(0.0)


def test_replicates_give_the_standard_error_of_the_mean():
    found = mean_of_replicates([10.0, 12.0, 14.0, 16.0])
    assert found.value == 13.0
    assert found.standard_error == pytest.approx(math.sqrt(20.0 / 3.0) / 2.0)
    assert found.interval[1] == pytest.approx(13.0 + 3.1824 * found.standard_error, rel=1e-4)


def test_one_replicate_has_no_interval():
    assert mean_of_replicates([3.0]) == Estimate(3.0)
    assert mean_of_replicates([3.0], value=3.1) == Estimate(3.1)


def test_estimates_of_unequal_errors_that_scatter_more_than_they_say():
    # by hand: 0 +- 1 and 10 +- 2: Q = 20, C = 1.25 - 1.0625 / 1.25 = 0.4, tau^2 = 47.5
    found = combine([Estimate(0.0, 1.0), Estimate(10.0, 2.0)])
    weights = 1.0 / 48.5, 1.0 / 51.5
    assert found.value == pytest.approx(10.0 * weights[1] / sum(weights), rel=1e-12)
    scatter = weights[0] * found.value**2 + weights[1] * (10.0 - found.value) ** 2
    assert found.standard_error == pytest.approx(
        math.sqrt(max(scatter, 1.0) / sum(weights)), rel=1e-12
    )
    assert found.interval[1] - found.value == pytest.approx(12.706 * found.standard_error, rel=1e-4)


@pytest.mark.parametrize("share", [-0.6, 0.0, 0.8])
@pytest.mark.parametrize("time", [1.5, 4.9, 400.0])
def test_long_run_variance_of_scores_is_the_banded_product(share, time):
    """Newey and West: white scores before and after a triangular band; what prewhitening took is put back."""
    noise = np.random.default_rng(2).normal(size=(90, 2)) @ [[1.0, 0.4], [0.0, 0.7]]
    noise[1:, 1] += 0.5 * noise[:-1, 0]  # one leads the other: the cross products are not symmetric
    scores = noise.copy()
    for i in range(1, 90):
        scores[i] += share * scores[i - 1]
    before, after = scores[:-1], scores[1:]
    kept = (before * after).sum(axis=0) / (before**2).sum(axis=0)
    kept = np.clip(kept + (1.0 + 3.0 * kept) / 90, 0.0, 0.97)
    white, width = after - kept * before, min(int(time) + 1, 45)
    apart = np.abs(np.subtract.outer(np.arange(89), np.arange(89)))
    band = np.maximum(1.0 - apart / (width + 1.0), 0.0)
    expected = (white.T @ band @ white) * 90 / 89 / np.outer(1.0 - kept, 1.0 - kept)
    np.testing.assert_allclose(_long_run(scores, time), expected, rtol=1e-12)


def test_variances_are_raised_and_keep_their_correlations():
    found = _not_below(np.array([[1.0, 0.6], [0.6, 4.0]]), np.diag([9.0, 1.0]))
    np.testing.assert_allclose(found, [[9.0, 1.8], [1.8, 4.0]], rtol=1e-12)
    np.testing.assert_allclose(correlation_of(found), [[1.0, 0.3], [0.3, 1.0]], rtol=1e-12)
    assert correlation_of(np.diag([0.0, 4.0])).tolist() == [[0.0, 0.0], [0.0, 1.0]]


def test_central_differences_are_exact_for_parabolas():
    values = np.array([2.0, -3.0])
    slopes = central_differences(
        lambda p: np.array([p[0] ** 2, p[0] * p[1], 5.0 * p[1] ** 2]), values, np.array([0.1, 0.7])
    )
    np.testing.assert_allclose(
        slopes, [[4.0, 0.0], [-3.0, 2.0], [0.0, -30.0]], rtol=1e-12, atol=1e-12
    )


def test_a_derived_quantity_knows_what_its_parameters_know():
    spread = Uncertainty(np.array([[4.0, 1.0], [1.0, 9.0]]), 10.0, 1.0)
    found = spread.propagate(7.0, np.array([1.0, -2.0]))
    assert found.standard_error == pytest.approx(math.sqrt(4.0 - 4.0 + 36.0))
    assert found.interval[1] == pytest.approx(7.0 + 2.2281 * 6.0, rel=1e-4)
    assert [one.standard_error for one in spread.estimates(np.array([1.0, 2.0]))] == [2.0, 3.0]
    assert Uncertainty(np.full((2, 2), np.inf), 1.0, 1.0).propagate(7.0, np.ones(2)) == Estimate(
        7.0
    )
