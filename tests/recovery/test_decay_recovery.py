"""Known decays plus noise: estimates come back, and 95 % intervals cover about 95 % of the repetitions."""

import math
from functools import cache

import numpy as np
import pytest

from jounce.identify.decay import fit_decay
from jounce.identify.free_response import DecayParameters, decay_response

MASS, STIFFNESS = 16.0, 18362.0
FREQUENCY = math.sqrt(STIFFNESS / MASS) / (2 * math.pi)
SEEDS = 60


def truth(c, friction):
    omega = math.sqrt(STIFFNESS / MASS)
    ratio = c / (2 * math.sqrt(STIFFNESS * MASS))
    return DecayParameters(omega, ratio, friction / STIFFNESS, 0.003, 0.1, 0.020)


@cache
def repeated(c, friction, rate):
    """One decay with the noise of every seed."""
    time = np.arange(0.0, 2.5 if c == 0.0 else 1.3, 1.0 / rate)
    clean = decay_response(time, truth(c, friction), "displacement")
    noises = (np.random.default_rng(seed).normal(0.0, 1e-4, len(time)) for seed in range(SEEDS))
    return [fit_decay(time, clean + noise, mass=MASS) for noise in noises]


@pytest.mark.parametrize(
    ("c", "friction", "rate"),
    [
        (120.0, 15.0, 500.0),
        # seconds more for what is told apart more easily: no damping, no friction, strong damping
        pytest.param(0.0, 15.0, 250.0, marks=pytest.mark.slow),
        pytest.param(120.0, 0.0, 500.0, marks=pytest.mark.slow),
        pytest.param(400.0, 10.0, 1000.0, marks=pytest.mark.slow),
    ],
)
def test_intervals_cover_the_truth_in_about_95_percent(c, friction, rate):
    hits = np.zeros(4)
    for result in repeated(c, friction, rate):
        hits += [
            result.damping_coefficient.has(c),
            result.coulomb_force.has(friction),
            result.natural_frequency_hz.has(FREQUENCY),
            result.equilibrium.has(0.003),
        ]
    # binomial, 60 repetitions at 0.95: 3 standard deviations are 0.084
    assert np.all(hits / SEEDS >= 0.86), hits / SEEDS


def test_intervals_are_not_needlessly_wide():
    found = [result.coulomb_force for result in repeated(120.0, 15.0, 500.0)]
    values, errors = [one.value for one in found], [one.standard_error for one in found]
    assert 0.7 < np.mean(errors) / np.std(values, ddof=1) < 1.5


def test_combined_estimate_is_right_where_the_decrement_is_not():
    time = np.arange(0.0, 1.3, 1e-3)
    clean = decay_response(time, truth(120.0, 15.0), "displacement")
    result = fit_decay(
        time, clean + np.random.default_rng(1).normal(0.0, 1e-4, len(time)), mass=MASS
    )
    assert result.damping_ratio.value == pytest.approx(0.1107, rel=0.02)
    assert min(result.naive_damping_ratios) > 1.3 * 0.1107


def test_a_quantised_record_still_gives_its_damping():
    time = np.arange(0.0, 1.3, 1e-3)
    clean = decay_response(time, truth(120.0, 15.0), "displacement")
    result = fit_decay(time, np.round(clean / 5e-5) * 5e-5, mass=MASS)
    assert result.damping_coefficient.value == pytest.approx(120.0, rel=0.01)
    assert result.coulomb_force.value == pytest.approx(15.0, rel=0.02)
