"""Lags of recordings: the best one is found without a simulation, and costs the parameters nothing."""

import numpy as np
import pytest
from scipy.linalg import toeplitz
from scipy.optimize import least_squares

import jounce as jn
from jounce.identify.fit_problem import (
    Channel,
    Residuals,
    Simulated,
    UpdateProblem,
    free_parameters,
)
from jounce.identify.lags import Shifted, best_lag
from jounce.identify.settings import UpdateSettings
from jounce.identify.update import _correlation, _level, robust_covariance

RATE = 1000.0
TIME = np.arange(800) / RATE
RIG = jn.load("kart-quarter-car")


def bump(at, width=0.02):
    return np.exp(-(((TIME - at) / width) ** 2))


def pair(lag, *, weight=1.0, offset=False, constant=0.0):
    return Shifted.of(bump(0.4 + lag) + constant, bump(0.4)[:, None], weight, RATE, offset=offset)


@pytest.mark.parametrize("lag", [0.0, 0.35e-3, -7.2e-3, 18.6e-3])
def test_a_lag_comes_back(lag):
    assert best_lag([pair(lag)], 0.02) == pytest.approx(lag, abs=1e-8)


def test_what_lies_before_and_after_a_record_is_its_first_and_last_value():
    ramp = 3.0 + 2.0 * np.arange(50.0)
    shifted = Shifted.of(ramp, ramp[:, None], 1.0, RATE, offset=False)
    early, late = (shifted.at(lag)[0][:, 0] for lag in (-4.0 / RATE, 4.0 / RATE))
    assert early == pytest.approx(np.minimum(ramp + 8.0, ramp[-1]))
    assert late == pytest.approx(np.maximum(ramp - 8.0, ramp[0]))


def test_a_tyre_that_lifts_off_has_no_force_however_late_its_record_is():
    road = jn.HalfSine(height="15 mm", length="60 mm", start="0.1 m")
    trial = jn.Trial(road=road, speed="2 m/s", duration="0.3 s")
    run = jn.simulate(RIG, trial)
    simulated = Simulated(jn.FitTrial("one", RIG, trial, run[["sprung.az"]]))
    force = simulated.outputs(1.3e-3)["tyre.force"]
    assert force.min() == 0.0
    late = np.interp(run["time"] - 1.3e-3, run["time"], run["tyre.force"])
    assert force == pytest.approx(late, abs=1e-3 * float(run["tyre.force"].max()))


def test_a_lag_beyond_its_bound_is_held_there():
    assert best_lag([pair(0.03)], 0.02) == 0.02


@pytest.mark.parametrize("constant", [0.0, 5.0])
def test_a_free_offset_does_not_move_the_lag(constant):
    assert best_lag([pair(4.3e-3, offset=True, constant=constant)], 0.02) == pytest.approx(
        4.3e-3, abs=1e-8
    )


def test_the_best_lag_is_found_though_a_nearer_one_is_a_valley_too():
    """Oscillations repeat: downhill from zero ends one period off."""
    wave = np.sin(2.0 * np.pi * 60.0 * TIME)
    shifted = Shifted.of(
        np.sin(2.0 * np.pi * 60.0 * (TIME - 0.015)) * bump(0.415, 0.1),
        (wave * bump(0.4, 0.1))[:, None],
        1.0,
        RATE,
    )
    assert best_lag([shifted], 0.02) == pytest.approx(0.015, abs=1e-5)


def test_channels_count_by_their_weights():
    alone = [best_lag([pair(lag)], 0.02) for lag in (1e-3, 2e-3)]
    heavy = best_lag([pair(1e-3, weight=10.0), pair(2e-3, weight=1.0)], 0.02)
    assert alone[0] < heavy < alone[0] + 0.02e-3


@pytest.mark.parametrize("offset", [False, True])
def test_whole_samples_of_lag_are_compared_by_weighted_sums_of_squares(offset):
    reach, kept = 30, slice(30, -30)
    channel = pair(4e-3, weight=3.0, offset=offset, constant=0.7)
    residuals = [
        channel.measured[kept] - np.roll(bump(0.4), lag)[kept] for lag in range(-reach, reach + 1)
    ]
    squares = np.array([9.0 * np.sum((one - offset * one.mean()) ** 2) for one in residuals])
    found = channel.misfit(reach)
    assert found - found.min() == pytest.approx(squares - squares.min(), abs=1e-9)


@pytest.mark.source(
    kind="program",
    key="scipy",
    of="signals and identification",
    where="its least_squares over parameters and lags at once, slopes by differences",
    tolerance="0.01 % of a parameter, 0.2 µs of a lag",
    compares="parameters and lags found one within the other",
)
def test_eliminated_lags_give_what_the_joint_search_gives():
    """Truth of other structure, so that parameters and lags pull at each other."""
    trials = []
    for i, (speed, lag) in enumerate(((1.95, 0.4e-3), (2.86, -0.5e-3))):
        road = {"height": "10 mm", "length": "60 mm"}
        driven = jn.Trial(
            road=jn.HalfSine(start=0.2 + speed * lag, **road), speed=speed, duration=0.6
        )
        truth = RIG.with_changes(
            {"strut.damper": {"bump_coefficient": 110.0, "rebound_coefficient": 190.0}}
        )
        measured = jn.simulate(truth, driven, tolerance=1e-7)[["sprung.az", "unsprung.az"]]
        trial = jn.Trial(road=jn.HalfSine(start=0.2, **road), speed=speed, duration=0.6)
        trials.append(jn.FitTrial(str(i), RIG, trial, measured))
    free = {
        "strut.spring.rate": "20 %",
        "strut.damper.coefficient": "50 %",
        "tyre.stiffness": "20 %",
    }
    problem = UpdateProblem(
        trials,
        free_parameters(RIG, free),
        UpdateSettings(weights="normalised"),
    )

    def joint(x):
        vectors = []
        for trial, lag in zip(problem.trials, x[3:] * 1e-3, strict=True):
            solution = trial.solve(problem.values(x[:3]), 1e-8)
            for channel in trial.channels:
                shifted = jn.recordings.shift_signals(
                    trial.table(channel, solution)[:, 0], trial.rate, lag
                )
                vectors.append(channel.weight * (channel.measured - shifted))
        return np.concatenate(vectors)

    reference = least_squares(joint, np.zeros(5), diff_step=1e-5, xtol=1e-10)
    found = jn.update_model(trials, free, weights="normalised", align="lag")
    for item, scaled in zip(problem.free, reference.x, strict=False):
        assert found.parameters[item.path].value == pytest.approx(item.value(scaled), rel=1e-4)
    assert list(found.lags.values()) == pytest.approx(reference.x[3:] * 1e-3, abs=2e-7)
    assert found.objective_after == pytest.approx(2.0 * reference.cost, rel=1e-6)


def test_covariance_of_coloured_residuals_is_the_banded_product():
    """The sandwich's middle as it is defined: tapered autocorrelations on the diagonals of a Toeplitz matrix."""
    noise = np.random.default_rng(4)
    white = noise.standard_normal((2, 300))
    vector = np.concatenate([np.convolve(row, 0.8 ** np.arange(15), mode="same") for row in white])
    jacobian = noise.standard_normal((600, 3))
    jacobian[:300, 2] = 0.0
    blocks = (slice(0, 300), slice(300, 600))
    meat = np.zeros((3, 3))
    for block in blocks:
        level = _level(vector[block])
        column = np.zeros(300)
        correlation = _correlation(vector[block] / level)
        column[: len(correlation) + 1] = [1.0, *correlation]
        rows = jacobian[block] * level[:, None]
        meat += rows.T @ toeplitz(column) @ rows
    bread = np.linalg.inv(jacobian.T @ jacobian)
    assert len(correlation) > 5
    assert robust_covariance(vector, jacobian, blocks) == pytest.approx(
        bread @ meat @ bread * 600 / 597, rel=1e-9
    )


@pytest.mark.parametrize(("count", "width"), [(20, 20), (200, 25), (1000, 50)])
def test_the_level_of_residuals_is_that_of_a_twentieth_of_the_record(count, width):
    values = np.random.default_rng(5).normal(size=count) * np.linspace(1.0, 3.0, count)
    first = np.clip(np.arange(count) - width // 2, 0, count - width)
    assert _level(values) == pytest.approx(
        [np.sqrt(np.mean(values[i : i + width] ** 2)) for i in first]
    )


def test_autocorrelation_counts_three_times_as_far_as_it_is_significant():
    values = np.convolve(
        np.random.default_rng(6).normal(size=900), 0.8 ** np.arange(40), mode="valid"
    )
    count = len(values)
    plain = np.array(
        [values[lag:] @ values[:-lag] / (values @ values) for lag in range(1, count // 4)]
    )
    end = int(np.argmax(np.abs(plain) < 2.0 / np.sqrt(count)))
    assert 5 < end < 40
    taper = 1.0 - np.arange(1, 3 * end + 1) / (3 * end + 1)
    assert _correlation(values) == pytest.approx(plain[: 3 * end] * taper)
    slow = np.cos(np.arange(100) * 0.01)  # significant as far as is looked
    assert len(_correlation(slow)) == 24
    assert len(_correlation(np.zeros(100))) == 0


def test_a_lag_takes_from_slopes_what_it_can_explain_itself():
    """Two trials: the columns are orthogonal to what their own lag does; a lag that is held does nothing."""
    draw = np.random.default_rng(7).normal
    direct, lag = draw(size=(7, 2)), np.append(draw(size=4), np.zeros(3))
    groups = (slice(0, 4), slice(4, 7))
    found = Residuals(draw(size=7), direct, lag, (slice(0, 7),), groups, np.zeros(2))
    explained = np.outer(lag, lag) / (lag @ lag)
    assert found.jacobian == pytest.approx(direct - explained @ direct)
    whole = found.with_lags(0.02)
    assert whole[:, :2] == pytest.approx(direct)
    assert whole[:, 2] == pytest.approx(0.02 * lag)
    assert not whole[:, 3].any()


def test_a_free_offset_is_the_best_constant():
    measured, table, slope = (
        np.array([1.0, 2.0, 6.0]),
        np.array([[4.0, 1.0], [0.0, 5.0], [2.0, 0.0]]),
        np.arange(3.0),
    )
    channel = Channel("az", 0, measured, None, 0.0, 1.0, "free offset")
    moved, turned = channel.offset(table, slope)
    assert moved == pytest.approx(np.array([[5.0, -1.0], [1.0, 3.0], [3.0, -2.0]]))
    assert turned.tolist() == [-1.0, 0.0, 1.0]
    assert Channel("az", 0, measured, None, 0.0, 1.0).offset(table, slope) == (table, slope)
