"""Standard errors with white and with correlated residuals."""

import numpy as np
import pytest

from jounce.identify.estimate import (
    _long_run,
    _not_below,
    correlation_time,
    linear_least_squares,
    r_squared,
    uncertainty,
)


def autoregressive(rng, count, share):
    noise = rng.normal(0.0, 1.0, count)
    for index in range(1, count):
        noise[index] += share * noise[index - 1]
    return noise


def test_white_residuals_have_correlation_time_near_one():
    times = [correlation_time(np.random.default_rng(seed).normal(size=500)) for seed in range(40)]
    assert 1.0 <= np.mean(times) < 1.1


def test_correlation_time_of_an_autoregressive_process():
    # integrated autocorrelation of AR(1): (1 + a) / (1 - a)
    times = [
        correlation_time(autoregressive(np.random.default_rng(seed), 5000, 0.8))
        for seed in range(20)
    ]
    assert np.mean(times) == pytest.approx(9.0, rel=0.15)


def test_classical_errors_of_a_line():
    x = np.linspace(0.0, 1.0, 50)
    rng = np.random.default_rng(3)
    y = 2.0 * x + 1.0 + rng.normal(0.0, 0.1, 50)
    regressors = np.column_stack([x, np.ones_like(x)])
    found, residual, spread = linear_least_squares(regressors, y)
    expected = np.linalg.inv(regressors.T @ regressors) * (residual @ residual) / 48
    assert spread.correlation_time == 1.0
    assert np.allclose(spread.covariance, expected, rtol=1e-9)
    assert found[0] == pytest.approx(np.polyfit(x, y, 1)[0], rel=1e-12)


@pytest.mark.parametrize("share", [0.0, 0.7, 0.9])
def test_intervals_of_a_slope_cover_about_95_percent(share):
    x = np.linspace(0.0, 1.0, 600)
    regressors = np.column_stack([x, np.ones_like(x)])
    hits = 0
    for seed in range(300):
        y = 2.0 * x + autoregressive(np.random.default_rng(seed), 600, share)
        found, _, spread = linear_least_squares(regressors, y)
        hits += spread.estimates(found)[0].has(2.0)
    assert 0.90 <= hits / 300 <= 0.99


def test_a_parameter_without_influence_is_not_determined():
    spread = linear_least_squares(np.column_stack([np.ones(9), np.zeros(9)]), np.arange(9.0))[2]
    assert spread.estimates(np.array([1.0, 0.0]))[1].interval is None


def test_r_squared():
    measured = np.array([1.0, 2.0, 3.0])
    assert r_squared(measured, np.zeros(3)) == 1.0
    assert r_squared(measured, measured - 2.0) == 0.0
    assert r_squared(np.ones(3), np.zeros(3)) == 0.0


@pytest.mark.parametrize("count", [60, 61, 400])
def test_the_correlation_time_sums_pairs_as_long_as_they_are_significant(count):
    values = autoregressive(np.random.default_rng(count), count, 0.7)
    centred = values - values.mean()
    correlation = [
        float(centred[lag:] @ centred[: count - lag]) / float(centred @ centred)
        for lag in range(count // 2)
    ]
    total, lag = 1.0, 1
    while lag + 1 < count // 2 and correlation[lag] + correlation[lag + 1] > 2.0 / np.sqrt(count):
        total, lag = total + 2.0 * (correlation[lag] + correlation[lag + 1]), lag + 2
    assert lag >= 3
    assert correlation_time(values) == pytest.approx(total)
    assert correlation_time(values[:7]) == correlation_time(np.ones(count)) == 1.0


def test_coloured_residuals_leave_fewer_degrees_of_freedom():
    x = np.linspace(0.0, 1.0, 300)
    regressors = np.column_stack([5.0 * x, np.ones_like(x)])
    residual = autoregressive(np.random.default_rng(1), 300, 0.8)
    found, time = uncertainty(regressors, residual), correlation_time(residual)
    assert time > 3.0
    inverse = np.linalg.inv(regressors.T @ regressors)
    classical = inverse * (residual @ residual) / 298.0
    sandwich = inverse @ _long_run(regressors * residual[:, None], time) @ inverse
    np.testing.assert_allclose(
        found.covariance, _not_below(sandwich, classical) * 300.0 / (300.0 - 2.0 * time), rtol=1e-8
    )
    assert found.degrees_of_freedom == pytest.approx(300.0 / time - 2.0)
    short = uncertainty(regressors[::100], residual[::100])
    assert (short.degrees_of_freedom, short.correlation_time) == (1.0, 1.0)
