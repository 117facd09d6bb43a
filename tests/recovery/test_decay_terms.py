"""Viscous damping, dry friction and quadratic drag told apart; hits and windows of impact tests; nothing below zero."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest
from scipy.linalg import expm

from jounce.core.errors import DescriptionError, FitError
from jounce.identify.decay import combine_decays, fit_decay
from jounce.identify.decay_path import drag_path
from jounce.identify.free_response import DecayParameters, decay_response

MASS, OMEGA = 16.0, 33.9
TIME = np.arange(0.0, 3.0, 2e-3)
NOISE = {"displacement": 2e-5, "velocity": 1e-3, "acceleration": 0.05}


def truth(ratio, friction, drag, offset=0.0):
    return DecayParameters(OMEGA, ratio, friction, offset, 0.2, 0.020, drag)


def record(parameters, quantity="displacement", noise=0.0, seed=0):
    clean = decay_response(TIME, parameters, quantity)
    return clean + np.random.default_rng(seed).normal(0.0, 1.0, len(TIME)) * noise


def messages(result):
    return " | ".join(finding.message for finding in result.findings)


def test_the_path_without_drag_is_the_closed_form():
    exact = truth(0.11, 0.8e-3, 0.0)
    path = drag_path(TIME - 0.2, OMEGA, 0.11, 0.8e-3, 0.0, 0.020)
    for row, quantity in zip(path, ("displacement", "velocity", "acceleration"), strict=True):
        closed = decay_response(TIME, exact, quantity)
        assert np.max(np.abs(row - closed)) < 1e-7 * np.ptp(closed), quantity


def test_the_path_with_drag_alone_has_its_first_integral():
    """Without viscous damping, e^(2 b s x) (v^2 + ...) is constant over a swing: here checked as d(v^2)/dx."""
    x, v, _ = drag_path(np.linspace(0.0, math.pi / OMEGA, 400), OMEGA, 0.0, 0.0, 6.0, 0.020)
    moving = slice(1, -30)
    # v^2 (x) for x' < 0: v^2 = C e^(2 b x) + (w^2 / (2 b^2)) (1 + 2 b x)
    b, square = 6.0, OMEGA**2
    constant = -square / (2 * b * b) * (1 + 2 * b * 0.020) * math.exp(-2 * b * 0.020)
    exact = constant * np.exp(2 * b * x) + square / (2 * b * b) * (1 + 2 * b * x)
    assert v[moving] ** 2 == pytest.approx(exact[moving], rel=1e-6)


@pytest.mark.some(2)
@pytest.mark.parametrize("quantity", ["displacement", "velocity", "acceleration"])
@pytest.mark.parametrize(
    ("ratio", "friction", "drag"),
    [
        (0.03, 0.0, 0.0),
        (0.03, 4e-4, 0.0),
        (0.0, 8e-4, 0.0),
        (0.03, 0.0, 3.0),
        (0.0, 0.0, 6.0),
        (0.02, 3e-4, 4.0),
        (0.0, 8e-4, 3.0),
    ],
)
@pytest.mark.parametrize("noisy", [False, True])
def test_three_ways_to_lose_energy_are_told_apart(quantity, ratio, friction, drag, noisy):
    result = fit_decay(
        TIME,
        record(truth(ratio, friction, drag), quantity, NOISE[quantity] if noisy else 0.0),
        mass=MASS,
        quantity=quantity,
    )
    assert result.damping_ratio.value == pytest.approx(ratio, abs=1e-3 if noisy else 1e-5)
    assert result.coulomb_force.value == pytest.approx(
        friction * MASS * OMEGA**2, abs=0.1 if noisy else 1e-3
    )
    assert (result.quadratic_drag is not None) == (drag > 0.0)
    if drag:
        assert result.quadratic_drag.value == pytest.approx(
            drag * MASS, rel=0.03 if noisy else 1e-4
        )
        assert "quadratic drag" in messages(result)


@pytest.mark.parametrize("ratio", [0.03, 0.0])
def test_what_would_be_negative_is_fitted_again_at_zero(ratio):
    """Drag looks like negative friction; the printed numbers are those of one fit, with friction zero."""
    signal = record(truth(ratio, 0.0, 3.0), noise=1e-5)
    result = fit_decay(TIME, signal, mass=MASS, quadratic_drag="no")
    assert result.coulomb_force.value == 0.0
    assert result.parameters.friction_deflection == 0.0
    assert result.parameters.quadratic_drag == 0.0
    assert result.damping_coefficient.value == pytest.approx(
        2.0 * result.parameters.damping_ratio * result.parameters.angular_frequency * MASS,
        rel=1e-12,
    )
    used = (result.window[0] <= TIME) & (result.window[1] >= TIME)
    left = signal[used] - decay_response(TIME[used], result.parameters, "displacement")
    assert result.rms_residual == pytest.approx(float(np.sqrt(np.mean(left**2))), rel=1e-9)
    # refitted: no other damping ratio would leave less
    for factor in (0.97, 1.03):
        worse = DecayParameters(
            **{**vars(result.parameters), "damping_ratio": factor * result.parameters.damping_ratio}
        )
        assert np.sum(
            (signal[used] - decay_response(TIME[used], worse, "displacement")) ** 2
        ) > np.sum(left**2)


def test_drag_can_be_asked_for_and_is_zero_where_there_is_none():
    result = fit_decay(
        TIME, record(truth(0.05, 0.0, 0.0), noise=2e-5), mass=MASS, quadratic_drag="yes"
    )
    assert result.quadratic_drag.interval[0] == 0.0
    assert result.quadratic_drag.interval[1] < 5.0
    assert result.damping_ratio.has(0.05)
    with pytest.raises(DescriptionError, match="allowed: auto, no, yes"):
        fit_decay(TIME, record(truth(0.05, 0.0, 0.0)), mass=MASS, quadratic_drag="perhaps")


def test_runs_with_and_without_drag_are_not_mixed_silently():
    runs = [fit_decay(TIME, record(truth(0.03, 0.0, drag)), mass=MASS) for drag in (0.0, 3.0)]
    found = combine_decays(runs)
    assert found.quadratic_drag is None
    assert "1 of 2 runs show quadratic drag" in messages(found)
    both = combine_decays([runs[1], runs[1]])
    assert both.quadratic_drag.value == pytest.approx(48.0, rel=1e-3)


# impact tests ---------------------------------------------------------------------------------------------------------


@cache
def struck(ratio, hits, *, rate=1000.0, frequency=5.0, seconds=4.0, contact=5e-3):
    """Displacement, velocity and acceleration of a mass hit by half-sine pulses at times (s) with sizes."""
    omega, sub = 2 * math.pi * frequency, 10
    time = np.arange(0.0, seconds, 1.0 / rate / sub)
    force = np.zeros(len(time))
    for at, size in hits:
        inside = (time >= at) & (time < at + contact)
        force[inside] += (
            size * math.pi / 2 / contact * np.sin(math.pi * (time[inside] - at) / contact)
        )
    matrix = np.array([[0.0, 1.0, 0.0], [-(omega**2), -2 * ratio * omega, 1.0], [0.0, 0.0, 0.0]])
    step = expm(matrix / rate / sub)
    states = np.zeros((len(time), 2))
    for i in range(len(time) - 1):
        states[i + 1] = step[:2, :2] @ states[i] + step[:2, 2] * force[i]
    x, v = states.T
    a = force - 2 * ratio * omega * v - omega**2 * x
    return time[::sub], {"displacement": x[::sub], "velocity": v[::sub], "acceleration": a[::sub]}


@pytest.mark.some(3)
@pytest.mark.parametrize("quantity", ["displacement", "velocity", "acceleration"])
@pytest.mark.parametrize("ratio", [0.005, 0.03, 0.15])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_whole_record_of_an_impact_test(quantity, ratio, sign):
    time, motion = struck(ratio, ((1.0, 0.5),))
    result = fit_decay(time, sign * motion[quantity], mass=MASS, quantity=quantity)
    assert result.damping_ratio.value == pytest.approx(ratio, rel=0.01)
    assert result.natural_frequency_hz.value == pytest.approx(5.0, rel=1e-3)
    assert result.window[0] > 1.0
    assert ("was left out: the impact" in messages(result)) == (quantity == "acceleration")


@pytest.mark.parametrize("quantity", ["displacement", "velocity", "acceleration"])
@pytest.mark.parametrize(
    "sizes",
    [
        (0.5, 0.4, 0.5),
        pytest.param((0.5, 0.7, 0.3), marks=pytest.mark.slow),
        pytest.param((0.5, 0.2, 0.2), marks=pytest.mark.slow),
    ],
)
def test_several_hits_in_one_record(quantity, sizes):
    time, motion = struck(0.03, tuple(zip((0.5, 1.9, 3.1), sizes, strict=True)), seconds=5.0)
    result = fit_decay(time, motion[quantity], mass=MASS, quantity=quantity)
    wrong = abs(result.damping_ratio.value / 0.03 - 1.0) > 0.02
    if min(sizes) < 0.4 and wrong:  # hits that hardly stand out of the ringing
        assert "problem" in {finding.severity for finding in result.findings}
    else:
        assert not wrong


@pytest.mark.parametrize("spike", [2.0, -2.0, 50.0])
@pytest.mark.parametrize("ratio", [0.003, 0.1])
def test_a_spike_of_the_hit_does_not_crash_the_fit(spike, ratio):
    """ "Residuals are not finite in the initial point": two samples of the hit were taken for the whole decay."""
    time = np.arange(0.0, 3.0, 1e-3)
    omega, since = 2 * math.pi * 5.0, time - 0.3
    signal = np.where(since > 0.0, np.exp(-ratio * omega * since) * np.sin(omega * since), 0.0)
    signal[300:302] += spike
    signal += np.random.default_rng(4).normal(0.0, 1e-3, len(time))
    result = fit_decay(time, signal, mass=1.0)
    assert result.damping_ratio.value == pytest.approx(ratio, rel=0.05)


def test_a_record_that_ends_while_it_moves():
    time = np.arange(0.0, 1.5, 1e-3)
    signal = np.exp(-0.2 * time) * np.cos(75.0 * time)
    assert fit_decay(time, signal, mass=1.0).damping_ratio.value == pytest.approx(
        0.2 / 75.0, rel=1e-3
    )


@pytest.mark.parametrize(
    ("begin", "end"), [(0.6, 1.7), ("600 ms", "1.7 s"), (0.6, None), (None, 1.7)]
)
def test_a_time_window(begin, end):
    time, motion = struck(0.03, ((0.5, 0.5), (1.9, 0.9)), seconds=4.0)
    result = fit_decay(time, motion["displacement"], mass=MASS, begin=begin, end=end)
    assert result.damping_ratio.value == pytest.approx(0.03, rel=1e-3)
    assert begin is None or result.window[0] >= 0.6
    assert end is None or result.window[1] <= 1.7


@pytest.mark.parametrize(
    ("begin", "end", "text"),
    [(1.0, 0.5, "too few"), (9.0, None, "too few"), (0.0, 0.3, "never changes")],
)
def test_windows_without_a_decay_are_refused(begin, end, text):
    time, motion = struck(0.03, ((0.5, 0.5),))
    with pytest.raises(FitError, match=text):
        fit_decay(time, motion["displacement"], mass=MASS, begin=begin, end=end)
    with pytest.raises(DescriptionError, match="from"):
        fit_decay(time, motion["displacement"], mass=MASS, begin="3 mm")
