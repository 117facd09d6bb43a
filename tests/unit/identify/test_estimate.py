"""Estimates and their intervals."""

import math

import pytest

from jounce.identify.estimate import Estimate, at_least_zero, estimate, mean_of_replicates, student_factor


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
