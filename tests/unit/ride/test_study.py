"""Trials of a ride study, and the columns of its comparison."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import jounce as jn
from jounce.control import CONTROLS
from jounce.core.errors import DescriptionError
from jounce.recordings import recording
from jounce.ride import study
from jounce.ride.stationary import linear_findings
from jounce.ride.study import Ride, _merits, all_controls
from jounce.roads.trial import trial_findings

TIME = np.arange(0.0, 10.0 + 5e-4, 1e-3)
WAVE = np.sin(2.0 * np.pi * 5.0 * TIME)


def test_merits_are_those_of_the_worst_corner_and_of_the_body() -> None:
    channels = {"body.az": (WAVE, "m/s^2", ""), "front.unsprung.az": (9.0 * WAVE, "m/s^2", "")}
    for place, size in (("front", 0.02), ("rear", 0.03)):
        channels[f"{place}.strut.deflection"] = (size * WAVE, "m", "")
        channels[f"{place}.tyre.force"] = (np.maximum(4000.0 + 2e5 * size * WAVE, 0.0), "N", "")
    metrics = jn.ride_metrics(recording(TIME, channels))
    merits = _merits(metrics)
    assert merits["travel"] == pytest.approx(0.03 * np.sqrt(0.5), rel=1e-6)
    assert merits["travel_range"] == pytest.approx(0.06, rel=1e-6)
    assert merits["load_coefficient"] == metrics.value("dynamic_load_coefficient", "rear")
    assert (
        merits["lift_off"]
        == metrics.value("lift_off_time", "rear")
        > metrics.value("lift_off_time", "front")
    )
    assert merits["body_acceleration"] == metrics.value("rms_acceleration", "body.az")
    assert merits["comfort"] == metrics.value("weighted_rms", "body.az")


def test_all_controllers_are_studied_after_the_passive_rig() -> None:
    names = all_controls()
    assert names[0] == "passive"
    assert sorted(names) == sorted(CONTROLS)


def test_spectra_resolve_a_body_that_bounces() -> None:
    """Pieces of an eighth of the run, of 8 s at least, and of half the run at most."""
    for duration, piece in ((80.0, 10.0), (40.0, 8.0), (12.0, 6.0)):
        time = np.arange(0.0, 2.0 + duration + 5e-3, 1e-2)
        run = recording(time, {"body.az": (np.sin(9.0 * time), "m/s^2", "")})
        (found,) = Ride("passive", run, jn.ride_metrics(run), {}, settling=2.0).spectra().values()
        assert found.resolution == pytest.approx(1.5 / piece, rel=1e-2)  # of a Hann window


def test_a_linear_model_says_where_a_rig_leaves_it() -> None:
    numbers = {
        "front.bump_stop.gap": 0.03,
        "front.rebound_stop.gap": 0.045,
        "front.spring.rate": 3e4,
    }
    numbers |= {
        "rear.bump_stop.gap": 0.1,
        "strut.bump_stop.gap": 0.059,
        "strut.rebound_stop.gap": 0.061,
    }
    laws = {
        "front.friction.force": 30.0,
        "front.damper.hysteretic_force": 40.0,
        "rear.bump_coefficient": 50.0,
    }
    numbers |= laws | {"rear.friction.force": 0.0}
    sigma = {
        "front_left.tyre.force": 1500.0,
        "rear_left.tyre.force": 1000.0,
        "front_left.strut.deflection": 0.02,
    }
    static = {
        "front_left.tyre.force": 3000.0,
        "rear_left.tyre.force": 4000.0,
        "front_left.strut.deflection": -0.01,
    }
    sigma |= {"rear_left.strut.deflection": 0.0, "body.az": 1e4}
    static |= {"rear_left.strut.deflection": 0.0, "body.az": 9.81}
    found = linear_findings(SimpleNamespace(parameters=lambda: numbers), sigma, static)
    assert [item.place for item in found] == [
        "front_left.tyre.force",
        *["front_left.strut.deflection"] * 2,
        *laws,
    ]
    assert [item.severity for item in found[3:]] == ["warning", "warning", "note"]
    # of a normal load 2.28 % lies below zero where that is two standard deviations away
    assert [item.value for item in found] == pytest.approx(
        [0.02275013, 0.04 / 0.02, 0.035 / 0.02, *laws.values()]
    )
    rig = SimpleNamespace(parameters=lambda: numbers)
    for load in (0.0, 0.5, 2.95, 3.05):  # as far away as three standard deviations
        told = [
            item.place
            for item in linear_findings(rig, {"tyre.force": 1.0}, {"tyre.force": load})[:-3]
        ]
        assert told == (["tyre.force"] if 0.0 < load < 3.0 else [])
    numbers = {path: value for path, value in numbers.items() if path.startswith("strut.")}
    quarter = linear_findings(rig, {"strut.deflection": 0.02}, {"strut.deflection": 0.0})
    assert [(item.place, item.value) for item in quarter] == [
        ("strut.deflection", pytest.approx(2.95))
    ]
    assert "static load is 2 standard deviations" in found[0].message
    assert "bump stop is 2 standard deviations" in found[1].message


def test_the_stops_of_a_car_on_3d_corners_are_seen() -> None:
    car = jn.load("formula-student-car")  # bump stops close 25 mm from design
    names = [f"{corner}.strut.deflection" for corner in car.corners]
    found = linear_findings(
        car, dict.fromkeys(names, 8e-3), dict(zip(names, (5e-3, 0.0, 0.0, -5e-3), strict=True))
    )
    assert [(item.place, item.value) for item in found if item.place in names] == [
        (names[0], pytest.approx(20 / 8))
    ]


def test_an_iso_road_is_as_long_and_as_fine_as_the_drive_needs() -> None:
    ride = jn.iso_trial(jn.load("audi-a6-half-car-4dof"), "C", "20 m/s", duration="10 s")
    assert ride.trial.duration == pytest.approx(10.0 + ride.settling, abs=1e-9)
    assert ride.trial.road.step == 0.05
    road = ride.trial.road
    assert (road.length, road.run_in, road.seed) == (
        pytest.approx(20.0 * ride.trial.duration + 10.0),
        10.0,
        0,
    )
    quarter = jn.iso_trial(jn.load("audi-a6-quarter-car"), "C", 20.0, seed=3)
    assert (quarter.settling, quarter.trial.duration, quarter.trial.road.seed) == (
        pytest.approx(0.5),
        60.5,
        3,
    )
    assert quarter.trial.right is None
    full = jn.iso_trial(jn.load("audi-a6-full-car"), "C", 20.0, duration=5.0)
    assert full.trial.road.track == pytest.approx(1.54)


def test_a_road_is_driven_until_the_last_axle_has_left_it() -> None:
    car = jn.load("audi-a6-half-car-4dof")
    x = np.linspace(0.0, 20.0, 101)
    level, raised = (
        jn.Table(x=x, height=0.02 * np.sin(0.4 * np.pi * x) + rise * x) for rise in (0.0, 5e-4)
    )
    assert jn.road_trial(car, level, 10.0).trial.duration == pytest.approx(
        (20.0 + car.wheelbase) / 10.0, abs=1e-3
    )
    assert jn.road_trial(car, raised, 10.0).trial.duration == pytest.approx(
        2.0, abs=1e-3
    )  # nobody knows how it goes on
    assert jn.road_trial(car, level, 10.0).settling == pytest.approx(car.wheelbase / 10.0)


def test_names_of_controls() -> None:
    def own(measurement, t):
        raise NotImplementedError

    named = [
        study.control_name(one)
        for one in (None, "skyhook", Path("a/soft.toml"), "b/firm.toml", own)
    ]
    assert named == ["passive", "skyhook", "soft", "firm", "own"]
    assert study.control_name(jn.controller("clipped-lqr")) == "lqr"
    assert study.all_controls()[0] == "passive"
    assert sorted(study.all_controls()) == sorted({*study.CONTROLS, "passive"})


def test_points_too_far_apart_for_the_speed_are_refused() -> None:
    """A drive shows waves of twice the distance of the points; wheels hop at 15 Hz and more."""
    car = jn.load("audi-a6-quarter-car")
    x = np.arange(0.0, 200.5, 0.5)
    road = jn.Table(x=x, height=0.01 * np.sin(x) * np.sin(x / 200.0 * np.pi))
    slowest = 2.0 * 0.5 * study.FASTEST
    assert study.road_trial(car, road, 1.001 * slowest).settling == 0.0
    words = f"found '0.5 m, which shows nothing above .* Hz at 5 m/s'; allowed: at most {2.5 / study.FASTEST:.3g} m"
    with pytest.raises(DescriptionError, match=words):
        study.road_trial(car, road, 5.0)


def test_a_measured_course_lies_under_both_tracks() -> None:
    car, course = jn.load("audi-a6-full-car"), jn.load_road("detrended_rms_course_1in")
    left, right = study._tracks(car, course)
    assert (left.v, right.v) == pytest.approx((0.5 * car.front.track, -0.5 * car.front.track))
    narrow = course.model_copy(update={"v": 2.9})
    assert study._tracks(car, narrow) == (narrow, None)
    assert study._tracks(jn.load("audi-a6-half-car-4dof"), course) == (course, None)


def ride_of(control: str, seconds: float = 10.0) -> Ride:
    run = recording(TIME, {"body.az": (WAVE, "m/s^2", "")}).isel(
        time=slice(0, round(1e3 * seconds) + 1)
    )
    return Ride(control, run, jn.ride_metrics(run), {}, settling=2.0)


def test_a_comparison_lists_what_failed_and_stops_where_nothing_is_driven(monkeypatch) -> None:
    def drive(rig, trial, control):
        if control is not None:
            raise jn.SimulationError(f"{control.name} left its range")
        return ride_of("passive")

    monkeypatch.setattr(study, "drive", drive)
    rig, told = jn.load("audi-a6-quarter-car"), []
    trial = study.RideTrial(
        jn.Trial(road=jn.HalfSine(height=0.01, length=0.1), speed=5.0, duration=1.0), 0.0
    )
    found = jn.compare_rides(rig, trial, ["skyhook", "passive"], progress=told.append)
    assert told == ["driving 1 of 2: skyhook", "driving 2 of 2: passive"]
    assert ([ride.control for ride in found.rides], found.failed) == (
        ["passive"],
        {"skyhook": "skyhook left its range."},
    )
    assert (found.stationary, found.by_chance) == (None, {})
    assert found.ride("passive").duration == pytest.approx(8.0)
    assert found.ride("passive").standard_deviation("body.az") == pytest.approx(
        np.sqrt(0.5), rel=1e-3
    )
    with pytest.raises(jn.SimulationError, match="skyhook left its range"):
        jn.compare_rides(rig, trial, ["skyhook", "groundhook"])
    with pytest.raises(DescriptionError, match="no ride with this controller; allowed: passive"):
        found.ride("skyhook")


def test_chance_counts_for_the_time_of_the_passive_ride() -> None:
    linear = SimpleNamespace(
        standard_deviation={"body.az": 1.0}, chance=lambda _, duration: duration
    )
    rides = ride_of("skyhook"), ride_of("passive", 6.0)
    whole = study.RideStudy(SimpleNamespace(), rides, {}, linear)
    assert whole.by_chance == {"body.az": pytest.approx(4.0)}
    assert study.RideStudy(SimpleNamespace(), rides[:1], {}, linear).by_chance == {}


def test_a_linear_model_stands_beside_passive_rides_over_iso_roads() -> None:
    rig = jn.load("audi-a6-quarter-car")
    trial = jn.iso_trial(rig, "C", 20.0, duration=5.0)
    assert study._stationary(rig, trial, ["skyhook"]) is None
    bump = study.RideTrial(
        jn.Trial(road=jn.HalfSine(height=0.01, length=0.1), speed=5.0, duration=1.0), 0.0
    )
    assert study._stationary(rig, bump, ["passive"]) is None
    found = study._stationary(rig, trial, ["passive", "skyhook"])
    again = jn.stationary(rig, "C", 20.0, band="iso", weighting={"sprung.az": "Wk"})
    assert (found.standard_deviation, found.weighted) == (again.standard_deviation, again.weighted)
    assert found.frequency.size == 800


def test_a_drive_too_short_to_be_weighted_is_refused(monkeypatch) -> None:
    monkeypatch.setattr(study, "simulate", lambda *_, **__: ride_of("", 2.0).run)
    trial = SimpleNamespace(trial=None, settling=0.0)
    with pytest.raises(jn.RecordingError, match=r"too short for Wk.*Increase the duration"):
        study.drive(jn.load("audi-a6-quarter-car"), trial)
    monkeypatch.setattr(study, "simulate", lambda *_, **__: ride_of("").run)
    assert study.drive(jn.load("audi-a6-quarter-car"), trial).control == "passive"


def test_spectra_are_those_of_the_body_and_of_every_tyre() -> None:
    names = ("body.az", "sprung.az", "front.sprung.az", "front.tyre.force", "rear.tyre.force")
    run = recording(
        TIME, {name: (WAVE, "N" if name.endswith("force") else "m/s^2", "") for name in names}
    )
    ride = Ride("passive", run, jn.ride_metrics(run, metrics=["rms_acceleration"]), {})
    assert list(ride.spectra()) == ["body.az", "front.tyre.force", "rear.tyre.force"]
    assert ride.duration == pytest.approx(10.0)
    short = run.drop_vars("body.az")
    assert next(iter(Ride("passive", short, ride.metrics, {}).spectra())) == "sprung.az"


def test_both_tracks_of_a_road_are_as_far_apart_as_the_wheels_in_the_mean() -> None:
    car = jn.load("sedan-full-car-3d")
    trial = jn.iso_trial(car, "C", "20 m/s", duration="1 s").trial
    assert (
        trial.road.track == trial.right.track == pytest.approx(0.7979 + 0.8)
    )  # half tracks of front and rear
    car = jn.load("audi-a6-full-car").with_changes({"front.track": "1.4 m", "rear.track": "1.7 m"})
    trial = jn.iso_trial(car, "C", "20 m/s", duration="1 s").trial
    assert trial.road.track == pytest.approx(1.55)
    assert [str(one) for one in trial_findings(trial, car)] == []
