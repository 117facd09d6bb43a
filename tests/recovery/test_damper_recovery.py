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
    truth = {
        "coefficient": 250.0,
        "stiffness": 1500.0,
        "hysteretic_force": 180.0,
        "rate": 400.0,
        "sigma": 2.0,
    }
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
        hits += [
            found["force"].has(150.0),
            found["slope"].has(40.0),
            found["displacement_coupling"].has(1.5),
        ]
    assert np.all(hits >= 34), hits


@pytest.mark.parametrize(("rate", "resolution"), [(300, 0.0), (3000, 0.0), (3000, 40e-6)])
@pytest.mark.parametrize("motion", ["sine", "triangle"])
def test_noise_of_a_displacement_does_not_soften_the_damper(motion, rate, resolution):
    """Central differences of 20 um of noise, sampled so finely, made 1500 N s/m a fifth of it."""
    time = np.arange(0.0, 4.0, 1.0 / rate)
    phase = 1.5 * time
    if motion == "sine":
        x, v = 0.020 * np.sin(2 * math.pi * phase), 0.060 * math.pi * np.cos(2 * math.pi * phase)
    else:
        x, v = (
            0.020 * (4.0 * np.abs((phase + 0.25) % 1.0 - 0.5) - 1.0),
            0.12 * np.where((phase + 0.25) % 1.0 < 0.5, -1, 1),
        )
    shaken = x + np.random.default_rng(1).normal(0.0, 20e-6, len(time))
    if resolution:
        shaken = resolution * np.round(x / resolution)
    result = fit_damper(shaken, None, 1500.0 * v, time)
    assert result.parameters["coefficient"].value == pytest.approx(
        1500.0, rel=2e-3 if motion == "sine" else 0.03
    )


def test_noise_that_no_average_takes_away_is_told():
    shaken = X[::4] + np.random.default_rng(1).normal(0.0, 1e-3, len(X[::4]))
    result = fit_damper(shaken, None, 1500.0 * V[::4], TIME[::4])
    (told,) = (one for one in result.findings if "noise of the displacement" in one.message)
    assert result.parameters["coefficient"].value == pytest.approx(
        1500.0 * (1.0 - told.value), rel=0.03
    )


def test_energy_of_a_cycle_is_the_dampers_however_the_record_ends():
    """Gas of five times the damping force gave half of the energy where the last cycle was not whole."""
    time = TIME[TIME < 3.6]
    x, v = X[: len(time)], V[: len(time)]
    result = fit_damper(x, v, 200.0 * v + 150.0, time)
    assert result.energy_per_cycle == pytest.approx(
        math.pi * 200.0 * 2 * math.pi * 0.020**2, rel=0.01
    )


def test_energy_of_a_cycle_that_dies_away_is_the_mean_of_all():
    """Half of the path is not the number of cycles, where amplitudes differ."""
    time = np.arange(0.0, 6.0, 1e-3)
    size = 0.020 * np.exp(-0.3 * time)
    x = size * np.sin(2 * math.pi * time)
    v = np.gradient(x, time)
    result = fit_damper(x, v, 500.0 * v, time)
    whole = (
        time <= 5.0
    )  # from the first pass upwards to the last; mid-stroke is not 0, which moves both a little
    work = float(np.trapezoid(500.0 * v[whole] ** 2, time[whole]))
    assert result.energy_per_cycle == pytest.approx(work / 5.0, rel=0.02)
