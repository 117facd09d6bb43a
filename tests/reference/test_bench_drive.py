"""The paper's bench: drive, photo-sensor and limits (paper 1 sections 2 and 9, domain A1)."""

import math

import numpy as np
import pytest

from jounce.bench.drive import (
    BeltLoad,
    BenchDrive,
    attainable_speed,
    belt_speed,
    drive_margin,
    inverter_frequency_for,
    photo_sensor_speed,
)
from jounce.core.errors import DescriptionError, FitError
from jounce.core.serialise import to_json

pytestmark = pytest.mark.source(
    kind="computed",
    of="bench",
    key="quarter-car-prototype",
    where="sections 2 and 9: motor plate, cylinder, belt; calculated by hand",
    tolerance="half a unit of the last printed digit",
)

BARE = BenchDrive(
    belt_reference="bare",
    cylinder_radius="50 mm",
    belt_thickness="3 mm",
    pulley_slip=0.0,
    flat_belt_slip=0.0,
    efficiency=1.0,
    standstill_torque=0.5,
)


def messages(result):
    return " | ".join(finding.message for finding in result.findings)


def test_rated_point_of_the_motor():
    # domain A1: 2-pole motor, slip 5.55 %, 178.025 rad/s = 1700 rpm at the cylinder
    assert BARE.motor_slip == pytest.approx(0.0555, abs=5e-5)
    found = belt_speed(BARE, 60.0)
    assert found.motor_speed == pytest.approx(356.05, rel=1e-9)
    assert found.cylinder_speed == pytest.approx(178.025, rel=1e-9)
    assert found.cylinder_speed * 60 / (2 * math.pi) == pytest.approx(1700.0, abs=0.1)
    assert found.speed == pytest.approx(178.025 * 0.05)


def test_torque_and_pull():
    # domain A1: 4.213 N m at the motor, 8.426 N m at the cylinder, 168.5 N at R = 50 mm; 652 W at 3.87 m/s
    assert BARE.rated_torque == pytest.approx(4.213, abs=5e-4)
    margin = drive_margin(BARE, 3.87)
    assert margin.available_force == pytest.approx(168.5, abs=0.05)
    assert margin.available_power == pytest.approx(652.0, abs=0.5)
    # domain A1 quotes 24.6 Hz: the synchronous frequency, without the motor's slip
    assert margin.inverter_frequency * (1 - BARE.motor_slip) == pytest.approx(24.64, abs=0.01)


@pytest.mark.parametrize(
    ("speed", "time"), [(1.95, 1.010), (2.86, 0.689), (3.79, 0.520), (3.87, 0.509)]
)
def test_recurrence_of_an_obstacle(speed, time):
    # domain A1: belt length 1.97 m / speed
    found = belt_speed(BARE, inverter_frequency_for(BARE, speed))
    assert found.speed == pytest.approx(speed)
    assert found.recurrence_time == pytest.approx(time, abs=6e-4)


@pytest.mark.no_source
@pytest.mark.parametrize(
    ("reference", "radius"), [("bare", 0.050), ("pitch", 0.0515), ("outer", 0.053)]
)
def test_belt_reference_sets_the_radius(reference, radius):
    drive = BenchDrive(belt_reference=reference, cylinder_radius=0.05, belt_thickness=0.003)
    assert drive.radius == pytest.approx(radius)


@pytest.mark.no_source
def test_slips_are_seen_or_not_seen_by_the_sensor():
    drive = BenchDrive(pulley_slip=0.03, flat_belt_slip=0.02)
    found = belt_speed(drive, 30.0)
    assert found.sensor_speed == pytest.approx(0.97 * found.ideal_speed)
    assert found.speed == pytest.approx(0.98 * found.sensor_speed)
    assert "not the slip between flat belt and cylinder" in messages(found)


@pytest.mark.no_source
def test_uncertainty_of_counting_is_that_of_random_windows():
    rng = np.random.default_rng(1)
    errors, claimed = [], []
    for turns, phase in zip(rng.uniform(5.0, 7.0, 4000), rng.uniform(0.0, 1.0, 4000), strict=True):
        found = photo_sensor_speed(BARE, math.floor(turns * 10.0 + phase), 10.0)
        errors.append(found.speed.value - 2 * math.pi * turns * 0.05)
        claimed.append(found.speed.standard_error)
    assert np.std(errors) == pytest.approx(np.mean(claimed), rel=0.03)
    assert np.mean(np.abs(errors) <= 1.96 * np.array(claimed)) == pytest.approx(0.95, abs=0.02)


@pytest.mark.no_source
def test_error_of_the_radius_adds_to_that_of_counting():
    found = photo_sensor_speed(BARE, 1000, 10.0, radius_error=0.5e-3)
    assert found.speed.standard_error / found.speed.value == pytest.approx(0.01, rel=0.01)


@pytest.mark.no_source
def test_few_pulses_are_reported():
    assert "count longer" in messages(photo_sensor_speed(BARE, 6, 1.0))
    assert "count longer" not in messages(
        photo_sensor_speed(BARE, 60, 1.0, pulses_per_revolution=10)
    )


@pytest.mark.no_source
def test_required_pull_is_the_sum_of_its_parts():
    load = BeltLoad(
        wheel_load=200.0,
        rolling_resistance=0.02,
        bed_friction=0.25,
        bed_load=120.0,
        bending_force=8.0,
        drag=2.0,
        inertia=0.01,
        acceleration=0.5,
    )
    assert load.force(3.0, 0.05) == pytest.approx(4.0 + 30.0 + 8.0 + 6.0 + 2.0)
    assert drive_margin(BARE, 3.0, load).required_force == pytest.approx(50.0)
    assert drive_margin(BARE, 3.0, load).required_power == pytest.approx(150.0)


@pytest.mark.no_source
@pytest.mark.parametrize(
    ("pull", "text"), [(60.0, ""), (130.0, "the cooling is not"), (180.0, "rated torque")]
)
def test_overload_and_overheating_are_told_apart(pull, text):
    load = BeltLoad(wheel_load=0.0, bending_force=pull)
    margin = drive_margin(BARE, 3.0, load)
    assert text in messages(margin)
    assert (margin.margin < 0.0) == (pull > 168.5)
    assert (margin.continuous_margin < 0.0) == bool(text)
    assert margin.required_torque == pytest.approx(pull * 0.05 / 2.0)


@pytest.mark.no_source
@pytest.mark.parametrize(
    ("pull", "drag", "limit", "speed"),
    [
        (60.0, 0.0, "supply frequency", 8.90125),
        (168.0, 5.0, "cooling", 0.0),
        (200.0, 0.0, "torque", 0.0),
    ],
)
def test_attainable_speed_and_its_limit(pull, drag, limit, speed):
    found = attainable_speed(BARE, BeltLoad(wheel_load=0.0, bending_force=pull, drag=drag))
    assert found.limited_by == limit
    assert found.speed == pytest.approx(speed, abs=0.01)


@pytest.mark.no_source
def test_slow_running_may_overheat_where_fast_running_does_not():
    # continuous pull 168.516 (0.5 + 0.5 v / 8.90125) = 120 at v = 3.775
    found = attainable_speed(BARE, BeltLoad(wheel_load=0.0, bending_force=120.0))
    assert found.lowest_continuous_speed == pytest.approx(3.775, abs=0.01)
    assert found.limited_by == "supply frequency"


@pytest.mark.no_source
def test_cooling_may_end_before_the_torque():
    # needed 80 + 10 v; continuous 168.516 (0.5 + 0.5 v / 8.90125) is above it up to v = 7.972; rated up to 8.852
    found = attainable_speed(BARE, BeltLoad(wheel_load=0.0, bending_force=80.0, drag=10.0))
    assert found.limited_by == "cooling"
    assert found.speed == pytest.approx(7.972, abs=0.006)
    assert found.short_time_speed == pytest.approx(8.852, abs=0.006)


@pytest.mark.no_source
def test_torque_limits_where_drag_grows():
    # 100 + 20 v = 168.516 at v = 3.426
    found = attainable_speed(BARE, BeltLoad(wheel_load=0.0, bending_force=100.0, drag=20.0))
    assert found.short_time_speed == pytest.approx(3.426, abs=0.01)


@pytest.mark.no_source
def test_the_observed_ceiling_implies_a_load():
    # rated pull 168.5 N; own-fan cooling at 3.87 m/s leaves 0.5 + 0.5 * 3.87 / 8.90125 of it
    found = attainable_speed(BARE, observed_ceiling=3.87)
    assert found.implied_force == pytest.approx(168.516 * (0.5 + 0.5 * 3.87 / 8.90125), rel=1e-4)
    assert "a ceiling of 3.87 m/s implies" in messages(found)
    assert attainable_speed(BARE).implied_force is None


@pytest.mark.no_source
def test_speeds_above_the_supply_frequency_are_reported():
    assert "above the supply frequency" in messages(drive_margin(BARE, 9.5))
    assert drive_margin(BARE, 9.5).available_power == pytest.approx(168.516 * 8.90125, rel=1e-4)


@pytest.mark.no_source
def test_estimated_values_are_named_until_they_are_given():
    text = messages(drive_margin(BenchDrive(), 2.0))
    for name in (
        "cylinder_radius",
        "belt_thickness",
        "pulley_slip",
        "efficiency",
        "bed_friction",
        "wheel_load",
    ):
        assert name in text
    given = BenchDrive(cylinder_radius="60 mm")
    assert "cylinder_radius" not in messages(belt_speed(given, 30.0))
    assert "estimated" not in messages(belt_speed(BARE, 30.0))


@pytest.mark.no_source
def test_results_are_plain_data():
    assert "limited_by" in to_json(attainable_speed(BARE, observed_ceiling=3.87))


@pytest.mark.no_source
def test_unusable_values_are_refused():
    with pytest.raises(FitError, match="not positive"):
        belt_speed(BARE, 0.0)
    with pytest.raises(FitError, match="not positive"):
        inverter_frequency_for(BARE, -1.0)
    with pytest.raises(FitError, match="pulses"):
        photo_sensor_speed(BARE, 0, 1.0)
    with pytest.raises(FitError, match="radius"):
        photo_sensor_speed(BARE, 10, 1.0, radius_error=-1.0)
    with pytest.raises(DescriptionError, match="cylinder_radius"):
        BenchDrive(cylinder_radius="-5 mm")
    with pytest.raises(DescriptionError, match="unknown key"):
        BenchDrive(radius="5 mm")
    with pytest.raises(DescriptionError, match="unit"):
        BenchDrive(motor_power="1.5 kg")
