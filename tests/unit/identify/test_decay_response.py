"""The closed-form decay with viscous damping and dry friction."""

import math

import numpy as np
import pytest

from jounce.identify.decay import (
    Peaks,
    _early,
    _half_period,
    _parabola,
    _rest_gap,
    _slopes_with_drag,
    find_peaks,
    find_release,
    ratio_from_decrement,
    regress_peaks,
    until_it_grows,
)
from jounce.identify.estimate import Uncertainty
from jounce.identify.free_response import DecayParameters, decay_response, turning_points
from jounce.identify.signals import noise_of, zigzag

MASS, STIFFNESS, DAMPING, FRICTION = 16.0, 18362.0, 120.0, 15.0
# domain A6, verified there by integration; the last value is on the side of the one before it
A6_SEQUENCE_MM = [20.0, -12.702389, 7.559395, -3.934868, 1.380481, 0.419723]


def system(c=DAMPING, friction=FRICTION, offset=0.0, release=0.0, deflection=0.020):
    omega = math.sqrt(STIFFNESS / MASS)
    ratio = c / (2 * math.sqrt(STIFFNESS * MASS))
    return DecayParameters(omega, ratio, friction / STIFFNESS, offset, release, deflection)


def test_turning_points_are_those_of_the_reference():
    assert system().damping_ratio == pytest.approx(0.110696, abs=5e-7)
    assert 1e3 * turning_points(system(), 50) == pytest.approx(A6_SEQUENCE_MM, abs=1e-6)


def test_pure_friction_takes_four_friction_deflections_per_cycle():
    # domain A6: pure Coulomb, loss per cycle 4 F_c / k
    points = np.abs(turning_points(system(c=0.0), 50))
    assert points[:-2] - points[2:] == pytest.approx(4 * FRICTION / STIFFNESS, rel=1e-12)


@pytest.mark.parametrize("deflection", [0.020, -0.020])
def test_response_solves_the_equation_of_motion(deflection):
    p = system(offset=0.003, release=0.05, deflection=deflection)
    t = np.linspace(0.0, 1.2, 2401)
    x = decay_response(t, p, "displacement") - 0.003
    v, a = (decay_response(t, p, q) - 0.003 for q in ("velocity", "acceleration"))
    moving = np.abs(v) > 1e-6
    force = MASS * a + DAMPING * v + FRICTION * np.sign(v) + STIFFNESS * x
    assert np.max(np.abs(force[moving])) < 1e-7
    assert np.allclose(x[t < 0.05], deflection)
    assert np.max(np.abs(np.gradient(x, t) - v)) < 0.01
    assert np.count_nonzero(moving) > 800


def test_response_agrees_with_an_integration():
    from scipy.integrate import solve_ivp

    def rate(_, state):
        force = -DAMPING * state[1] - FRICTION * np.tanh(state[1] / 1e-6) - STIFFNESS * state[0]
        return [state[1], force / MASS]

    t = np.linspace(0.0, 0.35, 200)
    found = solve_ivp(
        rate, (0.0, 0.35), [0.020, 0.0], method="LSODA", t_eval=t, rtol=1e-9, atol=1e-12
    )
    assert np.max(np.abs(found.y[0] - decay_response(t, system(), "displacement"))) < 2e-8


def test_a_mass_released_inside_the_friction_band_stays():
    p = system(deflection=0.5e-3)
    t = np.linspace(0.0, 1.0, 50)
    assert np.all(decay_response(t, p, "displacement") == 0.5e-3)
    assert np.all(decay_response(t, p, "acceleration") == 0.0)


@pytest.mark.parametrize(
    ("ratio", "decrement"),
    # domain A6
    [(0.05, 0.314553), (0.10, 0.631484), (0.13, 0.823805), (0.20, 1.282550), (0.30, 1.975970)],
)
def test_damping_ratio_of_a_decrement(ratio, decrement):
    assert ratio_from_decrement(decrement) == pytest.approx(ratio, abs=5e-7)


def test_regression_separates_viscous_from_dry_damping():
    found = regress_peaks(Peaks(np.arange(6.0), np.array(A6_SEQUENCE_MM) + 3.0))
    assert found.damping_ratio == pytest.approx(0.110696, abs=2e-6)
    assert found.friction_deflection == pytest.approx(0.8169, abs=1e-4)
    assert found.equilibrium == pytest.approx(3.0, abs=1e-5)


def test_regression_of_three_turning_points_takes_no_friction():
    found = regress_peaks(Peaks(np.arange(3.0), np.array([1.0, -0.5, 0.25])))
    assert found.friction_deflection == 0.0
    assert found.damping_ratio == pytest.approx(ratio_from_decrement(2 * math.log(2.0)))
    assert found.equilibrium == pytest.approx(0.0, abs=1e-12)


def test_peaks_are_found_between_samples():
    t = np.arange(0.0, 1.0, 0.004)
    peaks = find_peaks(t, decay_response(t, system(), "displacement"), 0.0)
    assert 1e3 * peaks.value[1:5] == pytest.approx(A6_SEQUENCE_MM[1:5], abs=0.02)
    assert peaks.half_period() == pytest.approx(
        math.pi / math.sqrt(STIFFNESS / MASS * (1 - 0.110696**2)), rel=0.01
    )


def test_noise_is_measured_under_a_motion():
    t = np.arange(0.0, 2.0, 1e-3)
    noise = np.random.default_rng(0).normal(0.0, 2e-4, len(t))
    assert noise_of(decay_response(t, system(), "displacement") + noise) == pytest.approx(
        2e-4, rel=0.1
    )


def test_noise_is_measured_to_a_few_percent_of_itself():
    noise = np.random.default_rng(1).normal(0.0, 3e-4, 200_000)
    assert noise_of(noise) == pytest.approx(3e-4, rel=0.01)


def test_turning_points_are_left_by_more_than_the_threshold_both_ways():
    for turn in (1.0, -1.0):
        for offset in (0.0, 7.0):
            signal = offset + turn * np.array(
                [0.0, 0.9, 0.1, 3.0, 2.1, 3.1, 0.0, 0.9, -0.5, 1.0, 0.2, 5.0, 3.9]
            )
            assert zigzag(signal, 1.0) == [0, 5, 8, 11]
            assert zigzag(signal, 0.85) == [0, 3, 4, 5, 6, 7, 8, 11]
            assert zigzag(signal, 0.75) == [*range(12)]
    assert zigzag(np.array([1.0, 1.9, 1.0]), 1.0) == [0]


@pytest.mark.parametrize(
    ("begin", "noise", "index"),
    [
        ([1.0, 1.0, 0.985, 0.975], 0.0, 2),  # within 2 % of the largest excursion
        ([1.0, 1.0, 0.985, 0.975], 0.007, 2),
        ([1.0, 1.0, 0.985, 0.975], 0.009, 3),  # or three times the noise
        ([0.2, 1.0, 0.71, 0.99], 0.0, 3),  # before it falls below 70 %
        ([0.2, 1.0, 0.69, 0.99], 0.0, 1),
    ],
)
@pytest.mark.parametrize("rest", [0.0, 3.0])
def test_the_release_is_where_the_largest_excursion_is_left(begin, noise, index, rest):
    for turn in (1.0, -1.0):
        assert find_release(rest + turn * np.array([*begin, *np.zeros(60)]), noise) == index
    assert (
        find_release(np.array([0.0, 0.0, 1.0, 1.0, 1.0]), 0.0) == 1
    )  # the end of the record is where it rests


def test_a_second_hit_is_a_swing_that_is_suddenly_much_larger():
    def kept(*swings, noise=0.0):
        values = np.cumsum([0.0, *(size * (-1.0) ** i for i, size in enumerate(swings))])
        return len(until_it_grows(Peaks(np.arange(float(len(values))), values), noise).time) - 1

    assert kept(9.0, 4.0, 2.0, 7.9, 3.0) == 5  # less than twice the larger of the two before
    assert kept(9.0, 4.0, 2.0, 8.1, 3.0) == 3
    assert kept(9.0, 2.0, 4.0, 8.1, 3.0) == 3
    assert kept(9.0, 19.0, 4.0) == 3  # of two before there is only one
    assert kept(9.0, 0.1, 0.05, 0.85) == 4  # less than a tenth of the first
    assert kept(9.0, 0.1, 0.05, 0.95) == 3
    assert kept(9.0, 0.1, 0.05, 0.95, noise=0.006) == 4  # or within the noise


def test_a_turning_point_is_refined_where_a_parabola_has_it():
    time = np.arange(40.0)
    signal = 3.0 - 0.2 * (time - 20.3) ** 2
    assert _parabola(time, signal, signal, 20, 20.0) == pytest.approx((20.3, 3.0))
    for half, shift in ((2.45, 0.3), (2.35, 0.0)):  # an eighth of half a period away at most
        assert _parabola(time, signal, signal, 20, half)[0] == pytest.approx(20.0 + shift)
    assert _parabola(time[:2], signal[:2], 9.0 + signal, 1, 2.4) == (
        1.0,
        9.0 + signal[1],
    )  # two samples make none
    wide = (
        3.0 - 0.2 * (time - 20.3) ** 2 + np.where(np.abs(time - 20.0) > 2.5, 5.0, 0.0)
    )  # a tenth of half a period
    assert _parabola(time, wide, wide, 20, 29.0) == pytest.approx((20.3, 3.0))
    assert _parabola(time, wide, wide, 20, 31.0) != pytest.approx((20.3, 3.0), abs=0.01)


def test_half_a_period_is_between_turning_points_behind_the_release():
    peaks = Peaks(np.array([0.0, 3.0, 4.0, 6.0]), np.array([9.0, -5.0, 1.0, -1.0]))
    assert peaks.half_period() == pytest.approx((1.0 * 6.0 + 2.0 * 2.0) / 8.0)
    time = np.arange(50.0)
    assert _half_period(time, [0, 9, 12, 14, 19]) == 3.0
    assert _half_period(time, [0, 9]) == 9.0


def test_the_large_swings_are_those_of_a_fifth_of_the_first_and_three_at_least():
    time = np.linspace(0.0, 9.0, 901)

    def end(*swings):
        values = np.cumsum([0.0, *(size * (-1.0) ** i for i, size in enumerate(swings))])
        return time[_early(time, Peaks(np.arange(float(len(values))), values))][-1]

    assert end(10.0, 8.0, 6.0, 2.1, 1.9, 1.0, 0.5) == 4.0
    assert end(10.0, 1.0, 0.5, 0.2, 0.1) == 3.0
    assert end(10.0, 9.0, 8.0, 7.0, 6.0) == 5.0
    few = np.linspace(0.0, 9.0, 31)  # fewer than 20 samples: all of them
    assert _early(few, Peaks(np.arange(6.0), np.array([10.0, 0.0, 9.0, 3.0, 4.0, 3.8]))).all()


@pytest.mark.parametrize("quantity", ["displacement", "velocity", "acceleration"])
def test_slopes_with_drag_are_those_of_differences(quantity):
    time = np.linspace(0.0, 1.0, 300)
    values = np.array([30.0, 0.1, 1e-4, 0.002, -0.013, 0.02, 4.0])
    steps = 1e-5 * np.abs(values)
    found = _slopes_with_drag(time, values, quantity, steps)
    for i, move in enumerate(np.diag(steps)):
        ends = [
            decay_response(time, DecayParameters(*(values + way * move)), quantity)
            for way in (1.0, -1.0)
        ]
        slope = (ends[0] - ends[1]) / (2.0 * steps[i])
        off = np.abs(found[:, i] - slope)
        assert np.median(off) < 1e-3 * np.abs(slope).max(), i


def test_the_rest_is_held_against_where_the_response_ends():
    time = np.linspace(1.5, 2.0, 60)
    p = system(offset=0.003)
    values = np.append(list(vars(p).values())[:6], 0.0)
    end = decay_response(time, p, "displacement").mean()
    covariance = np.zeros((7, 7))
    covariance[3, 3] = 4e-10
    gap, doubt = _rest_gap(
        time, np.full(60, end + 1e-4), values, Uncertainty(covariance, 50.0, 1.0)
    )
    assert (gap, doubt) == (pytest.approx(1e-4), pytest.approx(2e-5, rel=1e-6))
