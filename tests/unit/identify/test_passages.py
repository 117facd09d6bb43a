"""Passages of obstacles in records that begin anywhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import FitError
from jounce.identify.belt_loops import LEAD, running_trial
from jounce.identify.fit_problem import FitTrial
from jounce.identify.passages import ObstacleNotFoundError, find_passages
from jounce.identify.trials_on_belt import averaged_trial, select_loop
from jounce.recordings import Sensor
from jounce.simulation.running import loops_before

ONE = jn.HalfSine(height="10 mm", length="60 mm")
BELT = 1.97
RIG = jn.load("kart-quarter-car")
OTHER = {
    "strut.spring.rate": "24 N/mm",
    "strut.damper.coefficient": "190 N*s/m",
    "tyre.stiffness": "130 N/mm",
}


def record(road: jn.Road, speed: float, *, begin: float = 3.3, duration: float = 5.0) -> xr.Dataset:
    """Accelerations of a rig unlike the one that looks for them, on a belt that has been running."""
    run = jn.simulate(
        RIG.with_changes(OTHER), jn.Trial(road=road, speed=speed, duration=begin + duration)
    )
    part = run[["sprung.az", "unsprung.az"]].sel(time=slice(begin, None))
    draw = np.random.default_rng(1)
    for name, noise in (("sprung.az", 0.2), ("unsprung.az", 1.0)):
        part[name] = part[name] + noise * draw.standard_normal(part.sizes["time"])
        part[name].attrs = run[name].attrs
    return part.assign_coords(time=("time", part["time"].to_numpy() - begin, run["time"].attrs))


def on_belt(road: jn.Road) -> jn.Road:
    return road.with_fields(recurrence=BELT)


@pytest.mark.parametrize("speed", [1.95, 2.86, 3.87])
@pytest.mark.parametrize("pitch", [None, 0.10, 0.15, 0.20])
def test_every_passage_is_found_and_timed(speed: float, pitch: float | None) -> None:
    road = on_belt(ONE if pitch is None else jn.Train(of=ONE, count=5, pitch=pitch))
    found = find_passages(record(road, speed), RIG, road, 1.02 * speed)
    first = np.arange(20) * BELT / speed - 3.3  # the first obstacle stands where the run begins
    expected = first[(first > 0.0) & (first < 5.0)]
    inside = expected[expected < 4.85]
    assert len(found.times) in (len(inside), len(expected))
    away = [min(abs(time - other) for other in expected) for time in found.times]
    assert max(away) < 2.5e-3
    assert found.speed == pytest.approx(speed, rel=5e-4)
    assert found.loop is not None
    assert found.loop.sizes["time"] == pytest.approx(BELT / speed * 1000.0, abs=1)
    assert max(found.repeatability.values()) < 0.1
    if (speed, pitch) == (3.87, 0.20):  # the motion repeats after two loops only
        assert found.odd == (2, 4, 6, 8)
        assert [item.code for item in found.findings] == ["identify.alternating_passages"]
    else:
        assert not found.odd


def test_a_single_obstacle_is_found_where_it_is() -> None:
    late = ONE.model_copy(update={"start": 1.76 * 1.95})
    run = jn.simulate(RIG.with_changes(OTHER), jn.Trial(road=late, speed=1.95, duration=3.0))[
        ["sprung.az", "unsprung.az"]
    ]
    found = find_passages(run, RIG, ONE, 1.95)
    assert found.times == pytest.approx((1.76,), abs=2e-3)
    assert found.period is None
    assert found.loop is None


def test_an_obstacle_that_never_comes_is_said() -> None:
    time = np.arange(0.0, 3.0, 1e-3)
    noise = np.random.default_rng(2).standard_normal(time.size)
    quiet = jn.recording(
        time, {"sprung.az": (0.2 * noise, "m/s^2", ""), "unsprung.az": (noise, "m/s^2", "")}
    )
    with pytest.raises(FitError, match="the obstacle is not found") as refused:
        find_passages(quiet, RIG, on_belt(ONE), 1.95, name="trial 3")
    assert "half-sine of 0.06 m at 1.95 m/s in sprung.az, unsprung.az" in refused.value.allowed


def test_a_record_upside_down_is_found_and_said() -> None:
    road = on_belt(ONE)
    turned = -record(road, 1.95)
    for name in turned.data_vars:
        turned[name].attrs = {"units": "m/s^2"}
    found = find_passages(turned, RIG, road, 1.95)
    assert len(found.times) in (4, 5)
    assert [item.code for item in found.findings] == ["identify.upside_down"]
    mounted = {name: Sensor(orientation=-1) for name in map(str, turned.data_vars)}
    assert not find_passages(turned, RIG, road, 1.95, sensors=mounted).findings


def test_a_speed_that_cannot_be_is_asked_about() -> None:
    road = on_belt(ONE)
    found = find_passages(record(road, 1.95), RIG, road, 1.7)
    assert [item.code for item in found.findings] == ["identify.other_speed"]
    assert found.speed == pytest.approx(1.95, rel=1e-3)


def test_an_odd_passage_is_named_and_left_out() -> None:
    road = on_belt(ONE)
    data = record(road, 3.87)
    plain = find_passages(data, RIG, road, 3.87)
    struck = data.copy(deep=True)
    time = struck["time"].to_numpy()
    hit = np.abs(time - (plain.times[3] + 0.2)) < 0.01
    struck["sprung.az"] = struck["sprung.az"] + np.where(hit, 60.0, 0.0)
    struck["sprung.az"].attrs = data["sprung.az"].attrs
    found = find_passages(struck, RIG, road, 3.87)
    assert found.odd == (4,)
    assert [item.code for item in found.findings] == ["identify.odd_passages"]


def test_the_average_is_less_noisy_than_a_loop() -> None:
    road = on_belt(ONE)
    found = find_passages(record(road, 3.87), RIG, road, 3.87)
    trial, begin = running_trial(RIG, road, found.speed)
    truth = jn.simulate(RIG.with_changes(OTHER), trial, tolerance=1e-7)
    time = found.loop["time"].to_numpy()
    for name, noise in (("sprung.az", 0.2), ("unsprung.az", 1.0)):
        wanted = np.interp(time + begin, truth["time"].to_numpy(), truth[name].to_numpy())
        left = found.loop[name].to_numpy() - wanted
        shifted = min(np.std(np.roll(left + wanted, k) - wanted) for k in (-3, -2, -1, 0, 1, 2, 3))
        assert np.median(found.scatter[name]) == pytest.approx(noise, rel=0.3)
        assert shifted < 3.0 * noise


def test_a_running_belt_is_periodic_after_its_loops() -> None:
    road, speed = on_belt(ONE), 3.87
    trial, begin = running_trial(RIG, road, speed)
    run = jn.simulate(RIG, trial, tolerance=1e-7)
    period = BELT / speed
    assert begin == pytest.approx(loops_before(RIG, period) * period)
    longer = jn.simulate(RIG, trial.model_copy(update={"duration": 20.0 * period}), tolerance=1e-7)
    grid = np.linspace(0.0, period, 200, endpoint=False)
    first, last = (
        np.interp(grid + at, one["time"].to_numpy(), one["sprung.z"].to_numpy())
        for one, at in ((run, begin), (longer, 18.0 * period))
    )
    assert np.max(np.abs(first - last)) < 2e-3 * np.ptp(last)


def test_a_start_from_rest_lacks_what_the_last_loops_left() -> None:
    road = on_belt(jn.Train(of=ONE, count=5, pitch=0.10))
    trial, begin = running_trial(RIG, road, 3.87)
    run = jn.simulate(RIG, trial)
    time, moved = run["time"].to_numpy(), run["sprung.az"].to_numpy()
    grid = np.linspace(0.0, 0.99 * BELT / 3.87, 500)
    first, last = (np.interp(grid + at, time, moved) for at in (0.0, begin))
    assert 1.0 - np.mean((first - last) ** 2) / np.var(last) < 0.9


def test_an_averaged_trial_explains_its_record() -> None:
    road = on_belt(ONE)
    data = record(road, 3.87)
    right = RIG.with_changes(OTHER)
    trial = FitTrial("one", right, jn.Trial(road=road, speed=3.87, duration=5.0), data)
    averaged = averaged_trial(trial, find_passages(data, right, road, 3.87))
    found = jn.update_model(
        [averaged], {"strut.spring.rate": "10 %"}, align="lag", weights="normalised"
    )
    assert found.parameters["strut.spring.rate"].value == pytest.approx(24e3, rel=2e-3)
    with pytest.raises(FitError, match="no complete loop of the belt"):
        averaged_trial(trial, find_passages(data.sel(time=slice(0.0, 0.45)), right, ONE, 3.87))


def test_select_loop_is_that_of_the_record() -> None:
    measured, road = record(on_belt(ONE), 1.95), on_belt(ONE)
    found = find_passages(measured, RIG, road, 1.95)
    loop = select_loop(
        found, measured, 2, channels=["sprung.az", "unsprung.az"], name="trial 1"
    ).loop
    assert loop is not None
    assert found.period is not None
    begin = found.times[1] - LEAD * found.period
    own = (found.times[2] - found.times[1]) / found.period  # the loop is brought to the mean period
    instants = begin + own * loop["time"].to_numpy()
    expected = np.interp(instants, measured["time"], measured["sprung.az"])
    np.testing.assert_allclose(
        loop["sprung.az"], expected, atol=0.6
    )  # straight lines between samples with noise
    assert np.corrcoef(loop["sprung.az"], expected)[0, 1] > 0.995


def test_a_loop_that_begins_before_the_record_is_refused() -> None:
    measured, road = record(on_belt(ONE), 1.95), on_belt(ONE)
    found = find_passages(measured, RIG, road, 1.95)
    assert found.period is not None
    late = measured.sel(time=slice(found.times[0] - 0.5 * LEAD * found.period, None))
    with pytest.raises(
        FitError, match="no loop of this passage is recorded in full; found 1; allowed: 2, 3"
    ):
        select_loop(found, late, 1, channels=["sprung.az"], name="trial 1")
    with pytest.raises(FitError, match="found 99; allowed: 1, 2"):
        select_loop(found, measured, 99, channels=["sprung.az"], name="trial 1")


def test_a_missed_passage_does_not_shift_the_numbers_of_the_others() -> None:
    road = on_belt(ONE)
    measured = record(road, 2.86, duration=6.0)
    found = find_passages(measured, RIG, road, 2.86)
    time = measured["time"].to_numpy()
    hidden, strange = (np.abs(time - found.times[k] - 0.1) < 0.25 for k in (2, 5))
    for name in ("sprung.az", "unsprung.az"):
        measured[name][hidden] = 0.0
        measured[name][strange] *= 1.6
    again = find_passages(measured, RIG, road, 2.86)
    assert len(again.times) == len(found.times) - 1
    assert again.times[4] == pytest.approx(found.times[5], abs=0.02)
    assert again.odd == (5,)  # the strange one is the sixth that came and the fifth that was found


def test_the_noise_of_an_average_is_its_error_where_the_signal_is() -> None:
    """White noise of 0.2 and 1.0 m/s^2 over n loops leaves 1/sqrt(n) of it; slow noise counts by its density."""
    road = on_belt(ONE)
    found = find_passages(record(road, 3.87), RIG, road, 3.87)
    loops = found.loop.attrs["passages"]
    for name, noise in (("sprung.az", 0.2), ("unsprung.az", 1.0)):
        assert found.noise[name] == pytest.approx(noise / np.sqrt(loops), rel=0.35)
    alone = select_loop(
        found, record(road, 3.87), 2, channels=["sprung.az", "unsprung.az"], name="one"
    )
    assert alone.noise["sprung.az"] == pytest.approx(np.sqrt(loops) * found.noise["sprung.az"])


def test_a_fit_weighs_an_average_with_the_scatter_of_its_loops() -> None:
    road, right = on_belt(ONE), RIG.with_changes(OTHER)
    data = record(road, 3.87)
    trial = FitTrial("one", right, jn.Trial(road=road, speed=3.87, duration=5.0), data)
    averaged = averaged_trial(trial, find_passages(data, right, road, 3.87))
    assert averaged.noise["sprung.az"] > 0.0
    louder = replace(averaged, noise={name: 10.0 * value for name, value in averaged.noise.items()})
    three = [[replace(one, name=f"trial {k}") for k in range(3)] for one in (averaged, louder)]
    narrow, wide = (
        jn.update_model(
            trials, {"strut.spring.rate": "30 %"}, weights="normalised", align="lag", doubt=EXACT
        )
        for trials in three
    )
    path = "strut.spring.rate"
    assert wide.discrepancy.noise["sprung.az"] == pytest.approx(
        10.0 * narrow.discrepancy.noise["sprung.az"]
    )
    assert (
        wide.discrepancy.parameters[path].half_width
        > 3.0 * narrow.discrepancy.parameters[path].half_width
    )


EXACT = jn.Doubt(**{name: 0.0 for name in jn.Doubt.model_fields if name != "values"})


@pytest.mark.parametrize("speed", [1.95, 3.87])
@pytest.mark.parametrize("apart", [0.25, 0.985, 1.5])
def test_another_obstacle_on_the_belt_is_refused(speed: float, apart: float) -> None:
    """0.985 m is half the belt: its loops look like those of a belt of half the length."""
    both = jn.Train(of=ONE, count=2, pitch=apart).model_copy(update={"recurrence": BELT})
    with pytest.raises(FitError, match="an obstacle that the road does not describe") as refused:
        find_passages(record(both, speed), RIG, on_belt(ONE), speed)
    behind = float(str(refused.value.found).split()[2])
    assert min(abs(behind - apart), abs(behind - (BELT - apart))) < 0.01


@pytest.mark.parametrize("speed", [1.95, 3.0, 3.87])
@pytest.mark.parametrize(
    "road", [ONE, jn.Train(of=ONE, count=5, pitch=0.1), jn.Train(of=ONE, count=3, pitch=0.3)]
)
def test_what_swings_on_is_no_other_obstacle(road: jn.Road, speed: float) -> None:
    found = find_passages(record(on_belt(road), speed), RIG, on_belt(road), speed)
    assert found.findings == ()


def test_an_obstacle_that_comes_again_without_a_belt_is_said() -> None:
    found = find_passages(record(on_belt(ONE), 1.95), RIG, ONE, 1.95)
    (said,) = found.findings
    assert said.code == "identify.met_again"
    assert said.value == 5.0
    assert "0.741 s, 1.75 s, 2.76 s, 3.77 s, 4.78 s" in said.message


def test_what_was_looked_for_in_vain_lies_where_the_record_is_most_like_it() -> None:
    time = np.arange(0.0, 3.0, 1e-3)
    noise = np.random.default_rng(2).standard_normal((2, time.size))
    names = ("sprung.az", "unsprung.az")
    quiet = jn.recording(
        time, {name: (row, "m/s^2", "") for name, row in zip(names, noise, strict=True)}
    )
    with pytest.raises(ObstacleNotFoundError) as refused:
        find_passages(quiet, RIG, on_belt(ONE), 1.95)
    sought = refused.value.sought
    assert sought is not None
    assert set(sought.record.data_vars) == set(names)
    at = sought.response["time"].to_numpy()
    inside = (at >= 0.0) & (at <= time[-1])
    parts = [np.interp(at[inside], time, quiet[name].to_numpy()) for name in names]
    wanted = [sought.response[name].to_numpy()[inside] for name in names]
    like = [np.corrcoef(part, want)[0, 1] for part, want in zip(parts, wanted, strict=True)]
    assert (
        np.mean(like) > sought.likeness > 0.1
    )  # which counts quiet parts as loud: by chance it is 0.0


@pytest.mark.parametrize("turned", ["sprung.az", "unsprung.az"])
def test_one_sensor_upside_down_is_named(turned: str) -> None:
    road = on_belt(ONE)
    data = record(road, 1.95)
    data[turned] = -data[turned]
    data[turned].attrs = {"units": "m/s^2"}
    found = find_passages(data, RIG, road, 1.95, name="trial 2")
    assert len(found.times) in (4, 5)
    assert [(item.code, item.place) for item in found.findings] == [
        ("identify.upside_down", f"trial 2: {turned}")
    ]
