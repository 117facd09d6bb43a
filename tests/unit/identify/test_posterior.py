"""Posteriors against closed forms and quadrature, their diagnostics, and what they refuse."""

import numpy as np
import pytest
from scipy.stats import norm, truncnorm

import jounce as jn
from jounce.core.errors import DescriptionError, FitError
from jounce.identify.fit_problem import Channel
from jounce.identify.log_density import (
    Polynomial,
    Region,
    by_ensemble,
    convergence,
    fit_log_density,
    sample,
)
from jounce.identify.next_trial import Candidate, next_trials
from jounce.identify.posterior import posterior_of
from jounce.identify.prediction import _lay_over_recording, _moving

TRIAL = jn.Trial(
    road=jn.HalfSine(height="10 mm", length="60 mm", start="0.1 m"), speed="2 m/s", duration="0.6 s"
)
FREE = {"strut.spring.rate": "20 %", "tyre.stiffness": "20 %"}


def recorded(rig, seed, trial=TRIAL):
    noise = {"sprung.az": jn.Sensor(noise="0.3 m/s^2"), "unsprung.az": jn.Sensor(noise="1 m/s^2")}
    return jn.apply_sensors(jn.simulate(rig, trial, tolerance=1e-7)[list(noise)], noise, seed=seed)


def linear(seed=0, count=300):
    draw = np.random.default_rng(seed)
    matrix = draw.normal(size=(count, 3)) @ np.array(
        [[1.0, 0.5, 0.0], [0.0, 1.0, 0.3], [0.0, 0.0, 1.0]]
    )
    y = matrix @ [1.0, -2.0, 3.0] + 0.4 * draw.normal(size=count)
    best = np.linalg.lstsq(matrix, y)[0]
    return matrix, y, best


def test_a_linear_gaussian_posterior_is_its_closed_form():
    matrix, y, best = linear()
    free = {
        name: (value, value - 4.0, value + 4.0) for name, value in zip("abc", best, strict=True)
    }
    found = posterior_of(lambda p: (y - matrix @ p, -matrix), free, draws=20_000, seed=3)
    covariance = np.linalg.inv(matrix.T @ matrix) * np.sum((y - matrix @ best) ** 2) / (len(y) - 3)
    draws = np.array([found.samples[name].to_numpy().ravel() for name in "abc"])
    sampled = np.cov(draws)
    # the sandwich of an update estimates the same covariance from the residuals: their level and correlation are noise
    assert np.allclose(np.sqrt(np.diag(sampled)), np.sqrt(np.diag(covariance)), rtol=0.12)
    sandwich = [
        (one.gaussian[1] - one.gaussian[0]) / (2 * 1.96) for one in found.parameters.values()
    ]
    assert np.allclose(np.sqrt(np.diag(sampled)), sandwich, rtol=0.03)
    assert np.allclose(draws.mean(axis=1), best, atol=4.0 * np.max(sandwich) / np.sqrt(5000))
    for i, name in enumerate("abc"):
        one = found.parameters[name]
        assert np.allclose(
            one.interval, norm.interval(0.95, best[i], sandwich[i]), atol=0.06 * sandwich[i]
        )
        assert np.allclose(
            one.likelihood, norm.interval(0.95, best[i], sandwich[i]), atol=0.02 * sandwich[i]
        )
        assert one.convergence.r_hat < 1.01
        assert one.convergence.bulk > 3000.0
    assert found.density_error < 1e-6


def test_draws_of_a_curved_density_agree_with_quadrature():
    x = np.linspace(0.2, 2.0, 60)
    y = np.exp(-1.3 * x) + 0.05 * np.random.default_rng(2).normal(size=60)
    grid = np.linspace(0.4, 4.0, 20_001)
    squares = np.sum((y[:, None] - np.exp(-grid * x[:, None])) ** 2, axis=0)
    best = grid[np.argmin(squares)]
    found = posterior_of(
        lambda p: (y - np.exp(-p[0] * x), (x * np.exp(-p[0] * x))[:, None]),
        {"rate": (best, 0.4, 4.0)},
        draws=20_000,
    )
    # the same adjusted likelihood on a grid: curvature at the top is that of the sandwich
    slope = x * np.exp(-best * x)
    error = (found.parameters["rate"].gaussian[1] - best) / 1.96
    variance = np.min(squares) / 59
    turn = np.sqrt(variance / np.sum(slope**2)) / error
    adjusted = np.interp(best + turn * (grid - best), grid, squares)
    weight = np.exp(-0.5 * (adjusted - np.min(squares)) / variance)
    share = np.cumsum(weight) / np.sum(weight)
    expected = np.interp([0.025, 0.975], share, grid)
    assert np.allclose(found.parameters["rate"].interval, expected, atol=0.05 * error)


def test_draws_stay_within_bounds_and_say_that_these_decide():
    matrix, y, best = linear()
    found = posterior_of(
        lambda p: (y - matrix[:, :1] @ p, -matrix[:, :1]),
        {"a": (best[0], best[0], best[0] + 4.0)},
        draws=2000,
    )
    draws = found.samples["a"].to_numpy().ravel()
    assert draws.min() >= best[0]
    assert any("an update holds it at the bound" in finding.message for finding in found.findings)


def test_a_polynomial_gives_back_what_it_goes_through():
    draw = np.random.default_rng(4)
    u = draw.normal(size=(40, 2))
    values = 1.0 + u[:, 0] - 2.0 * u[:, 0] * u[:, 1] ** 2
    slopes = np.column_stack([1.0 - 2.0 * u[:, 1] ** 2, -4.0 * u[:, 0] * u[:, 1]])
    found = Polynomial.through(3, u, values, slopes)
    at = draw.normal(size=(5, 2))
    assert np.allclose(found(at), 1.0 + at[:, 0] - 2.0 * at[:, 0] * at[:, 1] ** 2)
    value, slopes = found.with_slopes(at[0])
    assert value == pytest.approx(found(at)[0])
    assert slopes == pytest.approx([1.0 - 2.0 * at[0, 1] ** 2, -4.0 * at[0, 0] * at[0, 1]])


def test_sampling_is_reproducible_and_truncated_draws_have_their_moments():
    region = Region(np.zeros(1), np.eye(1), np.array([-0.5]), np.array([np.inf]))
    density = fit_log_density(lambda x: (-0.5 * float(x @ x), -x, 0.0), region, 1)
    first, again, other = (sample(density, 6000, seed)[0] for seed in (1, 1, 2))
    assert np.array_equal(first, again)
    assert not np.array_equal(first, other)
    mean, variance = truncnorm.stats(-0.5, np.inf)
    assert np.allclose([first.mean(), first.var()], [mean, variance], atol=0.06)


def test_scatter_of_exact_values_is_not_followed_to_where_no_point_is():
    """Six unknowns, a Gaussian whose values, slopes and determinant jump as they do where a wheel lifts off or not."""
    draw = np.random.default_rng(1)

    def exact(x):
        return (
            -0.5 * float(x @ x) + 0.15 * draw.normal(),
            -x + 0.15 * draw.normal(size=6),
            0.3 * x[0] + 0.35 * draw.normal(),
        )

    density = fit_log_density(
        exact, Region(np.zeros(6), np.eye(6), np.full(6, -np.inf), np.full(6, np.inf)), 1
    )
    assert density.polynomial.powers.sum(axis=1).max() == 2
    assert density.error < 0.5
    u = draw.normal(size=(500, 6))
    off = density.polynomial(u) - (-0.5 * np.sum(u**2, axis=1) + 0.3 * u[:, 0])
    assert np.std(off) < 0.3
    assert density.error > np.std(off) > 0.02


def test_walkers_of_an_ensemble_are_no_chains_of_their_own():
    draws = np.arange(8 * 5.0).reshape(8, 5)  # four ensembles of two walkers
    early, late = (
        [1.0, 2.0, 6.0, 7.0],
        [3.0, 4.0, 8.0, 9.0],
    )  # of an odd number the first is left out
    assert by_ensemble(draws)[0].tolist() == early + late
    drifting = np.random.default_rng(1).normal(size=(64, 200)) + np.linspace(0.0, 2.0, 200)
    assert convergence(by_ensemble(drifting)).r_hat > 1.1


def test_chains_that_differ_are_said_not_to_have_converged():
    draws = np.random.default_rng(1).normal(size=(4, 500))
    assert convergence(draws).r_hat < 1.02
    draws[0] += 2.0
    assert convergence(draws).r_hat > 1.1


@pytest.fixture(scope="module")
def rig():
    return jn.load("kart-quarter-car")


@pytest.fixture(scope="module")
def found(rig):
    truth = rig.with_changes({"strut.spring.rate": "24 N/mm"})
    trials = [jn.FitTrial("one", rig, TRIAL, recorded(truth, 1))]
    return jn.posterior(trials, FREE, draws=4000, predicted_with=20)


def test_ten_virtual_benches_are_covered_and_their_recordings_predicted(rig, found):
    inside, bands = [], []
    for seed in range(10):
        draw = np.random.default_rng([11, seed])
        changes = {path: rig.parameters()[path] * draw.uniform(0.92, 1.08) for path in FREE}
        trials = [jn.FitTrial("one", rig, TRIAL, recorded(rig.with_changes(changes), seed))]
        one = jn.posterior(
            trials, FREE, draws=1000, predicted_with=5, predict=None if seed < 2 else ()
        )
        inside += [
            p.interval[0] <= changes[path] <= p.interval[1] for path, p in one.parameters.items()
        ]
        bands += [band.inside for band in one.predictions.get("one", {}).values()]
    assert sum(inside) >= 16  # of 20: fewer than once in 300 where 95 % are covered
    assert all(0.93 < share < 0.98 for share in bands)


def test_what_a_posterior_says_in_words_and_as_plain_data(found):
    plain = found.to_dict()
    assert plain["counted"] == "noise only"
    assert "samples" not in plain
    assert "strut.spring.rate" in str(found)
    low, high = found.parameters["strut.spring.rate"].interval
    assert low < 24e3 < high
    assert found.predictions["one"]["sprung.az"].is_fitted


def test_draws_are_laid_over_the_recording_each_with_its_own_lag():
    """The lag of a trial is unknown: one for all draws would leave to the curves what each draw's own takes away."""
    time = np.arange(2000) / 1000.0  # long after the obstacle: what counts is early

    def curve(late):
        return np.exp(-(((time - 0.15 - late) / 0.02) ** 2))

    channel = Channel("sprung.az", 0, curve(0.0), None, 0.0, 1.0)
    drawn = {"sprung.az": [curve(0.05 + late) for late in (-3.3e-3, 0.4e-3, 2.1e-3)]}
    for align in (False, True):
        ((_, table, _),) = _lay_over_recording(
            [channel], drawn, {"sprung.az": "m/s^2"}, 1000.0, align=align
        )
        assert (np.max(np.abs(table - channel.measured)) < 1e-4) == align


def test_the_gain_of_a_trial_agrees_with_sampling(rig):
    """Nested over a grid of one parameter: E log p(y|x) - log p(y), with white noise of known size."""
    free, sigma = {"tyre.stiffness": "10 %"}, 3.0
    sensor = {"unsprung.az": jn.Sensor(noise=f"{sigma} m/s^2")}
    clean = jn.simulate(rig, TRIAL, tolerance=1e-7)[["unsprung.az"]]
    basis = jn.posterior(
        [jn.FitTrial("one", rig, TRIAL, jn.apply_sensors(clean, sensor, seed=1))],
        free,
        draws=1000,
        predict=(),
    )
    faster = TRIAL.model_copy(update={"speed": 3.0})
    gain = next_trials(basis, [Candidate("faster", rig, faster)], count=1).candidates[0].gain
    now = basis.parameters["tyre.stiffness"]
    error = (now.gaussian[1] - now.gaussian[0]) / (2.0 * 1.96)
    values = now.value + error * np.linspace(-4.0, 4.0, 33)
    prior = norm.pdf(np.linspace(-4.0, 4.0, 33))
    prior /= prior.sum()
    runs = [
        jn.simulate(rig.with_changes({"tyre.stiffness": v}), faster, tolerance=1e-7) for v in values
    ]
    curves = np.array([run["unsprung.az"].to_numpy() for run in runs])
    draw = np.random.default_rng(5)
    gains = []
    for _ in range(1500):
        k = draw.choice(33, p=prior)
        y = curves[k] + sigma * draw.normal(size=curves.shape[1])
        log = -0.5 * np.sum((y - curves) ** 2, axis=1) / sigma**2
        gains.append(log[k] - log.max() - np.log(np.sum(prior * np.exp(log - log.max()))))
    # the information of the fitted trial is that of its residuals, which scatter by some per cent
    assert gain == pytest.approx(np.mean(gains), abs=0.1)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"draws": 10}, "invalid number of draws"),
        ({"draws": True}, "invalid number of draws"),
        ({"predicted_with": 1}, "invalid number of draws"),
        ({"seed": -1}, "invalid seed"),
        ({"seed": 1.5}, "invalid seed"),
        ({"doubt": 3}, "invalid uncertainty"),
        ({"free": {}}, "no free parameter"),
        ({"free": {"strut.spring.rat": "5 %"}}, "unknown parameter"),
        ({"trials": []}, "no trial to fit"),
    ],
)
def test_what_a_posterior_refuses(rig, change, words):
    given = {
        "trials": [jn.FitTrial("one", rig, TRIAL, jn.simulate(rig, TRIAL)[["sprung.az"]])],
        "free": FREE,
        **change,
    }
    with pytest.raises((FitError, DescriptionError), match=words):
        jn.posterior(given.pop("trials"), given.pop("free"), **given)


def test_two_trials_of_one_name_are_refused(rig, found):
    both = [jn.FitTrial("one", rig, TRIAL, jn.simulate(rig, TRIAL)[["sprung.az"]])] * 2
    with pytest.raises(FitError, match="trials: two trials have the same name; found 'one'"):
        jn.posterior(both, FREE)
    with pytest.raises(FitError, match="predict: two trials have the same name; found 'one'"):
        jn.posterior(both[:1], FREE, predict=both)


def test_the_level_of_a_signal_does_not_fall_towards_its_ends():
    for count in (20, 400):  # shorter than what it is taken over, and longer
        time = np.arange(count) / 1000.0
        assert _moving(np.full(count, -3.0), time) == pytest.approx(np.full(count, 3.0))


def test_a_fit_without_noise_and_one_without_influence_are_refused():
    x = np.linspace(0.0, 1.0, 20)
    with pytest.raises(FitError, match="no noise is left"):
        posterior_of(lambda _: (0.0 * x, -x[:, None]), {"a": (1.0, 0.0, 2.0)})
    with pytest.raises(FitError, match="insensitive"):
        posterior_of(
            lambda _: (x - 0.5, np.column_stack([x, 0.0 * x])), {"a": (1.0, 0, 2), "b": (1.0, 0, 2)}
        )
    with pytest.raises(FitError, match="exclude the estimate"):
        posterior_of(lambda _: (x, x[:, None]), {"a": (3.0, 0.0, 2.0)})


def test_next_trials_refuse_what_they_cannot_rank(rig, found):
    with pytest.raises(FitError, match="no trial to choose"):
        next_trials(found, [])
    with pytest.raises(FitError, match="invalid number of trials"):
        next_trials(found, [Candidate("one", rig, TRIAL)], count=0)
    matrix, y, best = linear()
    other = posterior_of(
        lambda p: (y - matrix[:, :1] @ p, -matrix[:, :1]), {"a": (best[0], -9.0, 9.0)}, draws=1000
    )
    with pytest.raises(FitError, match="does not come from an update"):
        next_trials(other, [Candidate("one", rig, TRIAL)])


def test_many_starts_are_sifted_and_end_where_each_alone_would(rig):
    truth = rig.with_changes({"strut.spring.rate": "24 N/mm", "tyre.stiffness": "130 N/mm"})
    trials = [jn.FitTrial("one", rig, TRIAL, recorded(truth, 4))]
    alone, many = (jn.update_model(trials, FREE, starts=starts) for starts in (1, 12))
    assert many.objective_after <= alone.objective_after * (1.0 + 1e-9)
    assert many.values() == pytest.approx(alone.values(), rel=1e-5)
    assert many.evaluations > alone.evaluations
