from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.recordings import estimate_lag, shift_signals, shift_with_derivative
from jounce.recordings.signals import correlation_coefficients

RATE = 1000.0
TIME = np.arange(1500) / RATE


def motion(time: np.ndarray) -> np.ndarray:
    return np.where(
        time > 0.3, np.exp(-4.0 * (time - 0.3)) * np.sin(60.0 * (time - 0.3)) * (time - 0.3), 0.0
    )


@pytest.mark.parametrize("lag", [-0.0123, -0.0004, 0.0, 0.0017, 0.2])
def test_shift_reads_between_samples(lag: float) -> None:
    inner = slice(210, -20)
    np.testing.assert_allclose(
        shift_signals(motion(TIME), RATE, lag)[inner],
        motion(TIME - lag)[inner],
        rtol=0.0,
        atol=2e-5,
    )


def test_ends_are_held() -> None:
    late = shift_signals(TIME + 1.0, RATE, 0.0105)
    assert (late[:11] == 1.0).all()
    assert late[20] == pytest.approx(1.0095, abs=1e-12)
    early = shift_signals(TIME + 1.0, RATE, -0.0105)
    assert (early[-10:] == TIME[-1] + 1.0).all()


def test_derivative_with_respect_to_the_lag() -> None:
    both = np.stack((motion(TIME), np.cos(9.0 * TIME)), axis=1)
    shifted, slope = shift_with_derivative(both, RATE, 0.0052)
    h = 1e-6
    numeric = (shift_signals(both, RATE, 0.0052 + h) - shift_signals(both, RATE, 0.0052 - h)) / (
        2.0 * h
    )
    np.testing.assert_allclose(slope, numeric, rtol=0.0, atol=1e-5)
    assert (slope[:5] == 0.0).all()
    np.testing.assert_array_equal(shifted, shift_signals(both, RATE, 0.0052))


@pytest.mark.parametrize("lag", [-0.0323, -0.0004, 0.0, 0.00027, 0.0401])
@pytest.mark.parametrize("scale", [1.0, -1.0])
def test_lag_is_found_below_a_sample(lag: float, scale: float) -> None:
    found = estimate_lag(scale * motion(TIME), scale * 1.3 * motion(TIME - lag) + 0.01, RATE)
    assert found == pytest.approx(lag, abs=2e-5)


def test_lag_survives_noise() -> None:
    rng = np.random.default_rng(5)
    noisy = motion(TIME - 0.0123) + 0.005 * rng.standard_normal(TIME.size)
    assert estimate_lag(motion(TIME), noisy, RATE) == pytest.approx(0.0123, abs=3e-4)


def test_lag_stays_within_the_largest_allowed() -> None:
    assert abs(estimate_lag(motion(TIME), motion(TIME - 0.2), RATE, maximum_lag=0.02)) <= 0.021
    assert estimate_lag(motion(TIME), motion(TIME - 0.2), RATE, maximum_lag=9.0) == pytest.approx(
        0.2, abs=2e-5
    )


def test_constant_signals_have_no_lag() -> None:
    assert estimate_lag(motion(TIME), np.full(TIME.size, 0.1), RATE) == 0.0
    assert estimate_lag(np.zeros(3), np.zeros(3), RATE) == 0.0
    assert np.isfinite(estimate_lag(np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0]), RATE))


def test_bad_input() -> None:
    with pytest.raises(RecordingError, match=r"found 'shapes \(5,\) and \(4,\)'"):
        estimate_lag(np.zeros(5), np.zeros(4), RATE)
    with pytest.raises(RecordingError, match="too short to shift"):
        shift_signals([1.0], RATE, 0.1)


def test_coefficients_are_those_of_the_overlapping_parts() -> None:
    rng = np.random.default_rng(8)
    a, b = rng.standard_normal((2, 60)) + 5.0
    found = correlation_coefficients(a, b, 20)
    for shift in range(-20, 21):
        left, right = (a[: 60 - shift], b[shift:]) if shift >= 0 else (a[-shift:], b[:shift])
        assert found[shift + 20] == pytest.approx(np.corrcoef(left, right)[0, 1], abs=1e-12)
    for first, second, flat in ((a, b, False), (np.where(np.arange(60) < 50, 5.0, a), b, True)):
        for one, other, sign in ((first, second, 1), (second, first, -1)):
            coefficients = correlation_coefficients(one, other, 20)
            constant = np.flatnonzero(coefficients == -1.0) - 20
            assert sorted(sign * constant) == [*range(10, 21)] * flat
