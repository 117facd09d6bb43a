"""Known truths come back from model updating: noise-free exactly, noisy within intervals that cover as stated."""

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError, FitError
from jounce.identify.fit_problem import UpdateProblem, free_parameters
from jounce.identify.search import minimise
from jounce.identify.settings import UpdateSettings
from jounce.recordings import Sensor, apply_sensors
from jounce.roads import HalfSine

START = jn.load("kart-quarter-car").with_changes({"strut.angle": "26 deg"})
TRUTH = {
    "strut.spring.rate": 1.06 * 22730.0,
    "strut.damper.coefficient": 0.93 * 150.0,
    "tyre.stiffness": 0.95 * 138468.0,
}
FREE = dict.fromkeys(TRUTH, "10 %")
CHANNELS = ["sprung.az", "unsprung.az"]


def obstacle(lag=0.0, speed=1.95):
    return HalfSine(height="10 mm", length="60 mm", start=0.2 + speed * lag)


def made(
    rig,
    speed=1.95,
    duration=1.0,
    *,
    lag=0.0,
    changes=TRUTH,
    sensors=None,
    name="trial",
    tolerance=1e-9,
):
    """A trial as described, and what the same model with other values gives on it."""
    trial = jn.Trial(road=obstacle(), speed=speed, duration=duration)
    driven = jn.Trial(road=obstacle(lag, speed), speed=speed, duration=duration)
    measured = jn.simulate(rig.with_changes(changes), driven, tolerance=tolerance)[CHANNELS]
    if sensors:
        measured = apply_sensors(measured, sensors)
    return jn.FitTrial(name, rig, trial, measured, sensors or {})


def with_noise(trial, deviation, seed):
    noise = np.random.default_rng(seed)
    measured = trial.measured.copy(deep=True)
    for name in CHANNELS:
        measured[name].values = measured[name].values + deviation * noise.standard_normal(
            measured.sizes["time"]
        )
    return jn.FitTrial(trial.name, trial.rig, trial.trial, measured, trial.sensors)


def assert_recovered(result, truth, relative):
    for path, value in truth.items():
        assert result.parameters[path].value == pytest.approx(value, rel=relative), path


@pytest.mark.parametrize("method", ["least-squares", "bfgs"])
@pytest.mark.parametrize("lift_off", [True, False])
def test_noise_free_truth_comes_back_to_a_millionth(method, lift_off):
    rig = START.with_changes({"tyre.lift_off": lift_off})
    result = jn.update_model([made(rig)], FREE, method=method, tolerance=1e-9)
    assert_recovered(result, TRUTH, 1e-6)
    assert result.reduction_percent > 99.9999
    assert not any(parameter.at_bound for parameter in result.parameters.values())
    assert result.evaluations < (25 if method == "least-squares" else 120)


def test_curve_coefficients_and_friction_come_back():
    rig = START.with_changes({"guide.friction": {"force": 5.0, "regularisation_velocity": 0.02}})
    table = rig.model_dump(by_alias=True, exclude_none=True)
    table["tyre"] = {"curve": {"kind": "polynomial", "coefficients": [120e3, 2e6]}}
    rig = type(rig).from_table(table)
    truth = {
        "tyre.curve.coefficients[0]": 126e3,
        "tyre.curve.coefficients[1]": 1.85e6,
        "guide.friction.force": 7.0,
    }
    free = {
        "tyre.curve.coefficients[0]": "10 %",
        "tyre.curve.coefficients[1]": "10 %",
        "guide.friction.force": [0.0, 20.0],
    }
    result = jn.update_model([made(rig, changes=truth)], free, tolerance=1e-9)
    assert_recovered(result, truth, 1e-5)


def test_sensors_are_looked_through():
    sensors = {name: Sensor(high_pass=0.5, low_pass=150.0) for name in CHANNELS}
    result = jn.update_model([made(START, sensors=sensors)], FREE, tolerance=1e-9)
    assert_recovered(result, TRUTH, 1e-6)


def test_several_trials_share_their_values_and_tell_more():
    one = made(START, 1.95, name="slow")
    both = [one, made(START.with_changes({"strut.angle": "10 deg"}), 3.79, name="fast")]
    noisy = [with_noise(trial, 0.5, 10 + i) for i, trial in enumerate(both)]
    assert_recovered(jn.update_model(both, FREE, tolerance=1e-9), TRUTH, 1e-6)
    alone, together = jn.update_model(noisy[:1], FREE), jn.update_model(noisy, FREE)
    for path in TRUTH:
        assert together.parameters[path].standard_error < alone.parameters[path].standard_error


def test_a_common_factor_serves_two_tyre_pressures():
    soft = START.with_changes({"tyre.stiffness": 125800.0})
    trials = [
        made(START, name="0.31 MPa", changes={"tyre.stiffness": 0.97 * 138468.0}),
        made(soft, name="0.25 MPa", changes={"tyre.stiffness": 0.97 * 125800.0}),
    ]
    result = jn.update_model(trials, {"tyre.stiffness": "10 %"}, tolerance=1e-9)
    assert result.parameters["tyre.stiffness"].value == pytest.approx(0.97 * 138468.0, rel=1e-6)
    assert any("common factor" in finding.message for finding in result.findings)


def test_lag_is_estimated_with_the_parameters():
    late = 0.83e-3
    trials = [made(START, lag=late, name="late"), made(START, 2.86, lag=-0.4e-3, name="early")]
    blind = jn.update_model(trials, FREE)
    found = jn.update_model(trials, FREE, align="lag")
    assert found.lags["late"] == pytest.approx(late, abs=5e-6)
    assert found.lags["early"] == pytest.approx(-0.4e-3, abs=5e-6)
    assert_recovered(
        found, TRUTH, 2e-3
    )  # the cubic between samples rounds off the kinks of a landing
    worst = max(abs(blind.parameters[path].value / value - 1.0) for path, value in TRUTH.items())
    assert worst > 0.01  # unaligned, the parameters take the blame


def test_intervals_cover_the_truth_in_about_95_percent_of_repetitions():
    """Binomial(150, 0.95): outside 133...149 with probability 0.003, for each of three parameters."""
    clean, repetitions = made(START, duration=0.6), 150
    hits = dict.fromkeys(TRUTH, 0)
    deviations = {path: [] for path in TRUTH}
    for seed in range(repetitions):
        result = jn.update_model([with_noise(clean, 0.8, seed)], FREE)
        for path, value in TRUTH.items():
            low, high = result.parameters[path].interval
            hits[path] += low <= value <= high
            deviations[path].append(
                (result.parameters[path].value - value) / result.parameters[path].standard_error
            )
    for path, count in hits.items():
        assert 133 <= count <= 149, (path, count)
        assert np.mean(deviations[path]) == pytest.approx(0.0, abs=3.5 / np.sqrt(repetitions)), path
        assert np.std(deviations[path]) == pytest.approx(1.0, abs=0.2), path


@pytest.mark.parametrize("method", ["least-squares", "bfgs"])
def test_values_stop_at_their_bounds_and_say_so(method):
    trial = made(START, changes={"strut.spring.rate": TRUTH["strut.spring.rate"]})
    result = jn.update_model([trial], {"strut.spring.rate": "3 %"}, method=method)
    rate = result.parameters["strut.spring.rate"]
    assert rate.at_bound
    said = [found.message for found in result.findings if found.place == "strut.spring.rate"]
    assert any("intervals of the other values hold it there" in text for text in said)
    assert rate.value == pytest.approx(1.03 * 22730.0, rel=1e-4)
    assert rate.standard_error is None
    assert any(
        "bound" in finding.message and finding.place == "strut.spring.rate"
        for finding in result.findings
    )


def test_several_starts_find_the_same_optimum():
    result = jn.update_model([made(START)], FREE, starts=4, tolerance=1e-9)
    assert_recovered(result, TRUTH, 1e-6)


# --- what cannot be fitted ---------------------------------------------------------------------------------------


def test_bounds_that_exclude_the_start_are_refused():
    with pytest.raises(FitError, match="exclude the start") as caught:
        jn.update_model([made(START)], {"strut.spring.rate": ["30 N/mm", "40 N/mm"]})
    assert "strut.spring.rate" in str(caught.value)


def test_zero_free_parameters_are_refused():
    with pytest.raises(FitError, match="no free parameter"):
        jn.update_model([made(START)], {})


def test_fewer_data_than_parameters_are_refused():
    trial = made(START)
    one = jn.FitTrial(
        trial.name, trial.rig, trial.trial, trial.measured[["sprung.az"]].isel(time=[0, 1000])
    )
    with pytest.raises(FitError, match="fewer data than parameters"):
        jn.update_model([one], FREE)


@pytest.mark.parametrize(
    ("free", "message"),
    [
        ({"strut.spring.rte": "10 %"}, "unknown parameter"),
        ({"strut.spring.rate": "0 %"}, "above zero"),
        ({"strut.spring.rate": "-10 %"}, "above zero"),
        ({"strut.spring.rate": "10 mm"}, "unit"),
        ({"strut.spring.rate": ["25 N/mm", "20 N/mm"]}, "lower bound"),
        ({"strut.spring.rate": ["20 N/mm", "25 mm"]}, "unit"),
        ({"strut.spring.rate": ["20 N/mm"]}, "pair of bounds"),
        ({"tyre.damping_coefficient": "10 %"}, "zero start value"),
    ],
)
def test_impossible_bounds_are_refused(free, message):
    with pytest.raises((FitError, DescriptionError), match=message):
        jn.update_model([made(START)], free)


def test_a_recording_shorter_than_the_pass_is_refused():
    trial = made(START)
    short = jn.FitTrial(
        trial.name, trial.rig, trial.trial, trial.measured.sel(time=slice(0.0, 0.12))
    )
    with pytest.raises(FitError, match="ends before"):
        jn.update_model([short], FREE)


def test_a_recording_without_a_common_channel_is_refused():
    trial = made(START)
    other = jn.FitTrial(
        trial.name,
        trial.rig,
        trial.trial,
        trial.measured.rename({name: f"rear.{name}" for name in CHANNELS}),
    )
    with pytest.raises(FitError, match="no channel"):
        jn.update_model([other], FREE)


def test_rounding_in_the_scaled_start_does_not_stop_least_squares():
    """SciPy's first trust radius is the size of the start unless that is exactly zero."""
    problem = UpdateProblem(
        [made(START)],
        free_parameters(made(START).rig, FREE),
        UpdateSettings(weights="printed"),
    )
    before, _ = problem.objective(np.zeros(problem.size))
    for start in (0.0, -1.6e-15):
        found = minimise(problem, np.full(problem.size, start), "least-squares")
        assert found.objective < 1e-9 * before
