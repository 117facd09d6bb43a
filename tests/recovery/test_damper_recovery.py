"""Known damper laws plus noise: intervals cover the truth."""

import math

import numpy as np
import pytest

from jounce.identify.damper import fit_damper
from jounce.identify.hysteresis_path import bouc_wen_path

TIME = np.arange(0.0, 6.0, 0.01)
X = 0.020 * np.sin(2 * math.pi * TIME)
V = 0.040 * math.pi * np.cos(2 * math.pi * TIME)


def noise(seed, share, size=5.0):
    from scipy.signal import lfilter

    white = np.random.default_rng(seed).normal(0.0, size, len(TIME) + 200)
    return lfilter([math.sqrt(1 - share**2)], [1.0, -share], white)[200:]


@pytest.mark.parametrize("share", [0.0, 0.8])
def test_bilinear_intervals_cover_with_white_and_with_correlated_noise(share):
    hits = np.zeros(2)
    for seed in range(200):
        force = np.where(V > 0.0, 400.0, 900.0) * V + noise(seed, share)
        found = fit_damper(X, V, force, TIME, law="bilinear").parameters
        hits += [found["bump_coefficient"].has(400.0), found["rebound_coefficient"].has(900.0)]
    assert np.all(hits / 200 >= 0.90), hits / 200


def test_bouc_wen_intervals_cover():
    truth = {"coefficient": 250.0, "stiffness": 1500.0, "hysteretic_force": 180.0, "rate": 400.0, "sigma": 2.0}
    clean = 250.0 * V + 1500.0 * X + 180.0 * bouc_wen_path(X, 400.0, 2.0, 1.5, 0.0)
    hits = dict.fromkeys(truth, 0)
    for seed in range(25):
        found = fit_damper(X, V, clean + noise(seed, 0.0), TIME, law="bouc-wen").parameters
        for key, value in truth.items():
            hits[key] += found[key].has(value)
    # binomial, 25 repetitions at 0.95: 20 or fewer hits happen once in 140
    assert min(hits.values()) >= 21, hits


def test_tanh_intervals_cover():
    clean = 300.0 * V + 2e3 * X + 150.0 * np.tanh(40.0 * (V + 1.5 * X))
    hits = np.zeros(3)
    for seed in range(40):
        found = fit_damper(X, V, clean + noise(seed, 0.0), TIME, law="tanh-hysteretic").parameters
        hits += [found["force"].has(150.0), found["slope"].has(40.0), found["displacement_coupling"].has(1.5)]
    assert np.all(hits >= 34), hits
