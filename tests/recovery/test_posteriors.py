"""Posteriors of virtual benches: as many intervals hold the truth as they say, with and without errors of the model."""

import importlib.util
import sys
from pathlib import Path

import numpy as np
import pytest

import jounce as jn

_file = Path(__file__).with_name("wrong_models.py")
_spec = importlib.util.spec_from_file_location("wrong_models", _file)
wrong_models = importlib.util.module_from_spec(_spec)
sys.modules[_spec.name] = wrong_models  # its dataclasses look themselves up
_spec.loader.exec_module(wrong_models)

ROAD = jn.HalfSine(height="10 mm", length="60 mm", start="0.1 m")
FREE = {"strut.spring.rate": "20 %", "strut.damper.coefficient": "40 %", "tyre.stiffness": "20 %"}
NOISE = {"sprung.az": jn.Sensor(noise="0.3 m/s^2"), "unsprung.az": jn.Sensor(noise="1 m/s^2")}


def covered_without_error(seed):
    """Whether the 95 % interval of each parameter holds it, of a bench that is as its model says."""
    rig = jn.load("kart-quarter-car")
    draw = np.random.default_rng([13, seed])
    changes = {path: rig.parameters()[path] * draw.uniform(0.9, 1.1) for path in FREE}
    trial = jn.Trial(road=ROAD, speed=draw.uniform(1.5, 4.0), duration="0.8 s")
    run = jn.simulate(rig.with_changes(changes), trial, tolerance=1e-7)[list(NOISE)]
    fit = jn.FitTrial("one", rig, trial, jn.apply_sensors(run, NOISE, seed=seed))
    found = jn.posterior([fit], FREE, draws=4000, predict=())
    return [p.interval[0] <= changes[path] <= p.interval[1] for path, p in found.parameters.items()]


def counted_with_error(seed):
    """The posterior of a bench of three trials whose laws are not the model's, and of each identified part."""
    one = wrong_models.bench(seed, trials=3)
    found = jn.posterior(one.trials, wrong_models.FREE, align="lag", doubt=jn.Doubt(), draws=4000, predict=())
    assert found.counted == "model error"
    told = found.update.discrepancy.parameters
    known = {path: p for path, p in found.parameters.items() if told[path].identified}
    return found, [counted(path, p.interval, p.value, one) for path, p in known.items()]


def gaussian(one):
    """The same of the Gaussian approximation, which is the posterior within some per cent and takes a tenth as long."""
    settings = {"weights": "normalised", "align": "lag", "doubt": jn.Doubt()}
    told = jn.update_model(one.trials, wrong_models.FREE, **settings).discrepancy.parameters
    return [counted(path, law.interval, law.value, one) for path, law in told.items() if law.identified]


def counted(path, interval, value, one):
    """Whether an interval holds both readings of the truth, and its half-width over its value."""
    held = all(interval[0] <= true[path] <= interval[1] for true in (one.component, one.effective))
    return held, 0.5 * (interval[1] - interval[0]) / value


@pytest.mark.slow
def test_two_hundred_benches_without_model_error():
    inside = [covered for seed in range(200) for covered in covered_without_error(seed)]
    assert 0.925 <= np.mean(inside) <= 0.975  # of 600, correlated in threes: three standard errors


@pytest.mark.slow
def test_benches_that_are_off_by_what_is_doubted():
    """Where errors are drawn from their priors 95 % have to be covered, neither fewer nor more: nothing else is wrong.

    This is what says that intervals are no wider than what is stated; a bench of other errors cannot.
    """
    rows = [row for seed in range(100) for row in gaussian(wrong_models.doubted_bench(seed, trials=3))]
    covered, _ = np.array(rows).T
    assert 0.92 <= np.mean(covered) <= 0.98  # of some 510, correlated in sixes: three standard errors


@pytest.mark.slow
def test_two_hundred_benches_with_model_error():
    """Seeds from 400 on are others than those the intervals were developed on; the counts are in the documentation.

    No upper end of what is covered: masses are doubted by more than these benches are off by, and a rest that three
    trials tell of has wide tails. Both are stated and not estimated, so more than 95 % are covered, and an end that is
    nearly one could not fail. That intervals are not simply wide is asked of those that are off by what is doubted,
    above, and that they are of use of their widths.
    """
    rows = [row for seed in range(400, 600) for row in gaussian(wrong_models.bench(seed, trials=3))]
    covered, widths = np.array(rows).T
    assert np.mean(covered) >= 0.92
    assert np.median(widths) < 0.1


@pytest.mark.slow
def test_posteriors_with_model_error():
    """A quarter of a minute each."""
    found = [counted_with_error(seed) for seed in range(400, 455)]
    covered, widths = np.array([row for _, rows in found for row in rows]).T
    errors = np.array([one.density_error for one, _ in found])
    assert np.mean(covered) >= 0.92
    assert np.median(widths) < 0.1
    assert np.mean(errors < 0.5) > 0.9
    assert all(any("log density" in str(f) for f in one.findings) == (one.density_error > 0.5) for one, _ in found)
    ratios = [
        np.ptp(one.parameters[path].interval) / np.ptp(law.interval)
        for one, _ in found
        for path, law in one.update.discrepancy.parameters.items()
        if law.identified
    ]
    assert 0.9 < np.median(ratios) < 1.1  # so that what is counted of the approximation counts for the posterior
