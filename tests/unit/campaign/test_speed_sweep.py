"""The speed sweep: exact sensitivities, and what it says about the middle speeds of the prototype paper."""

import numpy as np
import pytest

import jounce as jn
from jounce.campaign.speed_sweep import speed_sweep
from jounce.core.errors import DescriptionError, FitError

OBSTACLE = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
RIG = jn.load("kart-quarter-car")


@pytest.fixture(scope="module")
def sweep():
    return speed_sweep(RIG, OBSTACLE, np.linspace(1.5, 4.0, 51), duration="2 s")


def test_numbers_agree_with_a_plain_simulation(sweep):
    one = sweep.sel(speed=2.0)
    run = jn.simulate(RIG, jn.Trial(road=OBSTACLE, speed=2.0, duration="2 s"), tolerance=1e-7)
    body = run["sprung.z"] - run["sprung.z"][0]
    assert float(one["peak_body_displacement"]) == pytest.approx(
        float(np.abs(body).max()), rel=1e-4
    )
    assert float(one["peak_body_acceleration"]) == pytest.approx(
        float(np.abs(run["sprung.az"]).max()), rel=1e-4
    )
    assert float(one["peak_wheel_acceleration"]) == pytest.approx(
        float(np.abs(run["unsprung.az"]).max()), rel=1e-4
    )
    assert float(one["lift_off_time"]) == pytest.approx(
        1e-3 * int((run["tyre.force"] == 0.0).sum()), abs=1.1e-3
    )


@pytest.mark.parametrize("path", ["strut.spring.rate", "strut.damper.coefficient"])
def test_sensitivity_is_the_derivative_by_the_logarithm(sweep, path):
    # central difference over +-0.1 % on an independent run; the body's acceleration has no jumps at contact events
    value, share = RIG.parameters()[path], 1e-3
    trial = jn.Trial(road=OBSTACLE, speed=2.0, duration="2 s")
    plus, minus = (
        jn.simulate(RIG.with_changes({path: value * factor}), trial, tolerance=1e-8)[
            "sprung.az"
        ].to_numpy()
        for factor in (1.0 + share, 1.0 - share)
    )
    expected = np.sqrt(np.mean(((plus - minus) / (2.0 * share)) ** 2))
    found = float(sweep["sensitivity"].sel(speed=2.0, channel="sprung.az", parameter=path))
    assert found == pytest.approx(expected, rel=0.01)


def test_sensitivities_stay_finite_while_friction_holds_the_rig_at_rest():
    rig = RIG.with_changes({"guide.friction": {"force": 10.0, "regularisation_velocity": 0.005}})
    sweep = speed_sweep(rig, OBSTACLE, [0.3, 1.0], duration="2 s")
    assert float(sweep["relative_sensitivity"].max()) < 100.0


def test_the_body_answers_most_at_middle_speeds(sweep):
    # between the trials of the prototype paper at 1.95 and 3.79 m/s, whose misfit it could not explain
    body = sweep.sel(channel="sprung.az")
    for signal in (
        sweep["peak_body_displacement"],
        body["sensitivity"].sel(parameter="strut.spring.rate"),
        body["sensitivity"].sel(parameter="strut.damper.coefficient"),
    ):
        worst = float(signal.idxmax("speed"))
        assert 2.2 < worst < 3.2
        ends = [float(signal.sel(speed=v, method="nearest")) for v in (1.95, 3.79)]
        assert (
            max(ends) < float(signal.max()) < 1.25 * min(ends)
        )  # more there, yet by some per cent only


def test_contact_does_not_change_its_kind_over_one_obstacle(sweep):
    assert set(sweep["contact_events"].to_numpy()) == {6.0}  # three times off, three times back
    steps = np.abs(np.diff(sweep["relative_sensitivity"].to_numpy(), axis=0))
    assert steps.max() < 0.1 * float(
        sweep["relative_sensitivity"].max()
    )  # no peak between the tested speeds


@pytest.mark.parametrize("pitch", [0.10, 0.15, 0.20])
@pytest.mark.some(3)
def test_a_train_is_critical_where_the_wheel_falls_in_step_with_it(pitch):
    train = jn.Train(of=OBSTACLE, count=5, pitch=pitch)
    sweep = speed_sweep(RIG, train, np.linspace(1.5, 4.0, 251), duration="2 s")
    found = sweep["relative_sensitivity"].sel(channel="unsprung.az", parameter="strut.spring.rate")
    assert 5.0 < float(found.max() / found.median()) < 9.0
    assert 0.01 * int((found > 0.5 * found.max()).sum()) < 0.1  # m/s
    critical = float(found.idxmax("speed"))
    assert (
        14.6 < float(sweep["pass_frequency"].sel(speed=critical)) < 15.5
    )  # the same time between obstacles
    leap = {  # from the first to the last obstacle, a little faster and a little slower
        side: jn.simulate(RIG, jn.Trial(road=train, speed=critical + side, duration="0.8 s"))[
            "unsprung.z"
        ]
        for side in (0.05, -0.05)
    }
    assert float(leap[0.05].max()) > 1.35 * float(leap[-0.05].max())
    assert float(sweep["obstacle_frequency"].sel(speed=critical)) == pytest.approx(critical / 0.060)


def test_without_lift_off_and_load_change_the_answer_is_linear():
    rig = RIG.with_changes({"tyre.lift_off": False})
    small = jn.HalfSine(height="5 mm", length="60 mm", start="0.2 m")
    one, half = (speed_sweep(rig, road, ["2 m/s"], duration="1 s") for road in (OBSTACLE, small))
    for name in ("peak_body_acceleration", "peak_wheel_acceleration", "peak_body_displacement"):
        assert float(one[name][0]) == pytest.approx(2.0 * float(half[name][0]), rel=1e-4)
    assert float(one["contact_events"][0]) == 0.0
    assert np.allclose(one["relative_sensitivity"], half["relative_sensitivity"], rtol=1e-3)


@pytest.mark.parametrize("speeds", [[], [0.0], [2.0, -1.0], ["2 mm"], [float("nan")]])
def test_impossible_speeds_are_refused(speeds):
    with pytest.raises(DescriptionError, match="speeds"):
        speed_sweep(RIG, OBSTACLE, speeds)


def test_unknown_and_zero_parameters_are_refused():
    with pytest.raises(DescriptionError, match=r"strut\.spring\.rate"):
        speed_sweep(RIG, OBSTACLE, [2.0], parameters=["strut.spring.rat"])
    with pytest.raises(FitError, match="zero"):
        speed_sweep(RIG, OBSTACLE, [2.0], parameters=["tyre.damping_coefficient"])
