"""Which part of a record is the test of which wheel."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.inspection import evaluate, evaluation
from jounce.inspection.evaluation import wheel_load
from jounce.inspection.signals import (
    WheelSignals,
    _greatest_part,
    mean_shaking,
    moving_part,
    standstill_force,
)
from jounce.inspection.sweep import turns_of
from jounce.parts import load
from jounce.parts.testers import load_tester
from jounce.recordings import recording
from jounce.testers.testing import simulate_test

RATE, LEAST = 1000.0, 0.325e-3


def _two_plates() -> tuple[np.ndarray, np.ndarray]:
    """Heights (m) of two sprung plates: one after the other is swept, then both swing on with the body."""
    time = np.arange(30_000) / RATE
    angle = 2 * np.pi * (20.0 * time - 0.7 * time**2)
    first = np.where(time < 13.0, 2e-3 * np.sin(angle), 0.0)
    second = np.roll(first, 15_000)
    later = np.maximum(time - 9.0, 0.0)
    swing = np.where(later > 0.0, 2e-3 * np.exp(-0.1 * later) * np.sin(2 * np.pi * 1.3 * time), 0.0)
    return first + swing + 0.3 * second, second + swing + 0.3 * first


def test_wheels_tested_in_turn_do_not_overlap_where_the_body_swings_on() -> None:
    left, right = _two_plates()
    ours, theirs = moving_part(left, RATE, LEAST, right), moving_part(right, RATE, LEAST, left)
    assert ours is not None
    assert theirs is not None
    assert ours[0] == 0
    assert 12_500 <= ours[1] <= 15_000
    assert 14_500 <= theirs[0] <= 15_300
    assert theirs[1] >= 27_500


def test_plates_that_run_together_are_both_moving() -> None:
    left, _ = _two_plates()
    for values in (left, 1.2 * left):
        span = moving_part(values, RATE, LEAST, left)
        assert span is not None
        assert span[0] == 0
        assert span[1] >= 12_500


def test_a_plate_at_rest_beside_one_that_runs_does_not_move() -> None:
    left, _ = _two_plates()
    assert moving_part(0.02 * left, RATE, LEAST, left) is None
    assert moving_part(0.0 * left, RATE, LEAST) is None
    slow = (
        30.0 * LEAST * np.sin(2.0 * np.pi * 0.5 * np.arange(left.size) / RATE)
    )  # counts where the other one stands
    assert moving_part(slow, RATE, LEAST, 0.0 * left) == moving_part(slow, RATE, LEAST)
    assert moving_part(slow, RATE, LEAST, left) != moving_part(slow, RATE, LEAST)


@pytest.fixture(scope="module")
def run(twin):
    return twin.rigid_record(twin.Car(), twin.Programme(before=0.5), mp=20.0, fine=4)


@pytest.fixture(scope="module")
def both(twin, run):
    """Build a record of both wheels; the second one stands still, or runs after the first."""
    time, height, force, _ = run
    load, rest = twin.Car().static_load, np.zeros_like(height)

    def build(order: str, *, second: bool, leave_out: str = "", scale: float = 1.0):
        still = np.full_like(force, load)
        one = {"plate.z": np.append(height, rest), "plate.force": np.append(force, still)}
        other = {name: values[::-1].copy() * 0.0 for name, values in one.items()}
        other["plate.force"] += load
        if second:
            other = {"plate.z": np.append(rest, height), "plate.force": np.append(still, force)}
        whole = np.append(time, time + time[-1] + time[1])
        found = {
            f"{side}.{name}": (
                values * (scale if name == "plate.force" else 1.0),
                "m" if name == "plate.z" else "N",
                "",
            )
            for side, channels in (("left", one), ("right", other))
            for name, values in channels.items()
            if f"{side}.{name}" != leave_out
        }
        loads = {f"{side}.static_load": load for side in ("left", "right")}
        return recording(whole, found, attributes={**loads, "wheel_order": order})

    return build


def test_only_the_wheel_that_the_order_names_was_tested(both, eusama) -> None:
    found = evaluate(both("left", second=False), eusama)
    assert [wheel.wheel for wheel in found.wheels] == ["left"]
    assert found.is_gradable
    assert [
        wheel.wheel for wheel in evaluate(both("left, right", second=False), eusama).wheels
    ] == ["left", "right"]
    assert [wheel.wheel for wheel in evaluate(both("left", second=True), eusama).wheels] == [
        "left",
        "right",
    ]


def test_a_wheel_without_its_force_is_not_left_out(both, eusama) -> None:
    found = evaluate(both("left, right", second=True, leave_out="right.plate.force"), eusama)
    assert found.wheel("left").is_gradable
    assert found.wheel("right").reasons == (
        "right.plate.z is in the record, but right.plate.force is not: check the column names.",
    )
    alone = evaluate(both("left", second=True, leave_out="right.plate.force"), eusama)
    assert [wheel.wheel for wheel in alone.wheels] == ["left"]


def test_an_order_that_the_plates_contradict(both, eusama) -> None:
    found = evaluate(both("right, left", second=True), eusama)
    assert not found.is_gradable
    assert all(
        "the left plate runs first: left and right are swapped" in one.reasons[0]
        for one in found.wheels
    )
    assert evaluate(both("left, right", second=True), eusama).is_gradable
    assert evaluate(both("together", second=True), eusama).is_gradable


@pytest.mark.parametrize(
    ("scale", "unit"), [(1e-3, "kN"), (0.224809, "pounds (lbf)"), (0.1, "daN")]
)
def test_equal_wheels_in_another_unit_are_no_offset(both, eusama, scale: float, unit: str) -> None:
    found = evaluate(both("left, right", second=True, scale=scale), eusama)
    assert [len(wheel.reasons) for wheel in found.wheels] == [1, 1]
    assert all(f"the forces seem to be in {unit}" in wheel.reasons[0] for wheel in found.wheels)


def test_another_tester_in_the_header_is_said(both, eusama) -> None:
    record = both("left", second=False)
    record.attrs["tester"] = "FooTester"
    assert [one.message for one in evaluate(record, eusama).findings] == [
        "the header names the tester 'FooTester'; the record is evaluated as one from 'EUSAMA'."
    ]
    record.attrs["tester"] = "egea-specsus2018"  # another one that is shipped
    assert [one.code for one in evaluate(record, eusama).findings] == ["other_tester"]
    record.attrs["tester"] = "eusama"
    assert evaluate(record, eusama).findings == ()


def test_turns_of_a_sprung_plate_stand_on_the_swing_of_the_car() -> None:
    time = np.arange(12_000) / RATE
    frequency = 20.0 - 1.5 * time
    height = 0.5e-3 * np.sin(2 * np.pi * (20.0 * time - 0.75 * time**2))
    height += 1.5e-3 * np.sin(2 * np.pi * 1.3 * time) + 1e-3
    signals = WheelSignals("left", time, 4e3 + 0.0 * time, height, None, 4e3, 20.0)
    turns = turns_of(signals, load_tester("theta-msd3000"))
    assert turns is not None
    inside = (turns.top > 0.5) & (turns.top < 11.0)
    expected = np.interp(turns.top[inside], time, frequency)
    assert np.count_nonzero(inside) == pytest.approx(
        np.trapezoid(frequency[500:11_000], dx=1e-3), abs=2.0
    )
    assert np.abs(turns.frequency[inside] / expected - 1.0).max() < 0.15


def test_a_record_of_a_sprung_plate_is_not_taken_for_one_of_a_rigid_plate(both, eusama) -> None:
    record = both("left", second=False)
    record.attrs["tester"] = "theta-msd3000"
    (wheel,) = evaluate(record, eusama).wheels
    assert wheel.reasons == (
        "the header names the tester 'theta-msd3000' (sprung-plate); the record cannot be evaluated as one from "
        "'EUSAMA' (rigid-plate).",
    )
    assert wheel.adhesion is None


def test_a_rigid_plate_has_one_stroke(run, twin, left_record, eusama) -> None:
    time, height, force, _ = run
    slower = np.interp(time, [time[0], time[-1]], [0.8, 1.0])
    wheel = evaluate(
        left_record(time, height * slower, force, twin.Car().static_load), eusama
    ).wheels[0]
    assert not [one for one in wheel.findings if one.code == "not_rigid"]
    resonant = np.interp(time, [0.0, 3.0, 7.0, time[-1]], [0.6, 0.6, 1.0, 1.0])
    wheel = evaluate(
        left_record(time, height * resonant, force, twin.Car().static_load), eusama
    ).wheels[0]
    assert [one.code for one in wheel.findings if one.severity == "problem"] == ["not_rigid"]


def test_a_rigid_plate_stands_on_no_spring(run, twin, left_record) -> None:
    """A record without a name of its tester, evaluated as one of a sprung plate."""
    time, height, force, _ = run
    load_of_wheel = twin.Car().static_load
    sprung = load_tester("theta-msd3000")
    wheel = evaluate(left_record(time, height, force, load_of_wheel), sprung).wheels[0]
    assert [one.code for one in wheel.findings if one.severity == "problem"] == ["not_sprung"]
    assert wheel.corner is None
    stiff = sprung.with_changes({"plate_spring_rate": "5000 N/mm"})
    wheel = evaluate(left_record(time, height, force, load_of_wheel), stiff).wheels[0]
    assert "not_sprung" not in [one.code for one in wheel.findings]  # such a spring it may be
    varied = np.interp(time, [0.0, 3.0, 7.0, time[-1]], [0.8, 0.8, 1.0, 1.0])
    wheel = evaluate(left_record(time, height * varied, force, load_of_wheel), sprung).wheels[0]
    assert "not_sprung" not in [one.code for one in wheel.findings]


def test_loads_are_compared_with_the_axle_of_the_vehicle(both, eusama) -> None:
    record, vehicle = both("left", second=False), load("audi-a6-full-car")
    for axle in ("front", "rear"):
        record.attrs["axle"] = axle
        off = abs(record.attrs["left.static_load"] / wheel_load(vehicle, axle) - 1.0)
        codes = ["other_vehicle"] if off > 0.15 else []
        found = evaluate(record, eusama, vehicle).wheels[0]
        assert [one.code for one in found.findings if one.code == "other_vehicle"] == codes
    assert wheel_load(vehicle, "front") == pytest.approx(
        9.81 * (1636.0 * 1.62 / 2.91 / 2.0 + 45.0), rel=2e-3
    )
    heavier = vehicle.with_changes({"body.mass": 2600.0})
    record.attrs["axle"] = "front"
    assert "other_vehicle" in [
        one.code for one in evaluate(record, eusama, heavier).wheels[0].findings
    ]


@pytest.fixture(scope="module")
def sprung():
    return load_tester("theta-msd3000")


@pytest.fixture(scope="module")
def sprung_run(sprung):
    return simulate_test(load("audi-a6-quarter-car"), sprung, noise=0.01, seed=1, truth=False)


def test_a_sprung_plate_must_run_down_through_the_resonance_once(sprung, sprung_run) -> None:
    assert evaluate(sprung_run, sprung).is_gradable
    end = float(sprung_run["time"][-1])
    for length, message in (
        (0.5 * end, "the sweep is cut off"),
        (0.2 * end, "the sweep is missing"),
    ):
        cut = sprung_run.sel(time=slice(0.0, length))
        (wheel,) = evaluate(cut, sprung).wheels
        assert [message in reason for reason in wheel.reasons] == [True]
        assert wheel.theta_road is None
    later = sprung_run.assign_coords(time=sprung_run["time"] + end + 1e-3)
    twice = recording(
        np.append(sprung_run["time"], later["time"]),
        {
            name: (np.append(sprung_run[name], later[name]), sprung_run[name].attrs["units"], "")
            for name in sprung_run
        },
        attributes=sprung_run.attrs,
    )
    (wheel,) = evaluate(twice, sprung).wheels
    assert wheel.reasons == ("2 sweeps in one record: evaluate them separately.",)


def test_a_run_up_of_a_sprung_plate_is_a_test_too(sprung) -> None:
    upwards = sprung.with_changes(
        {"programme.start_frequency": 1.0, "programme.end_frequency": 20.0}
    )
    record = simulate_test(load("audi-a6-quarter-car"), upwards, noise=0.01, seed=1, truth=False)
    (wheel,) = evaluate(record, upwards).wheels
    assert wheel.is_gradable
    assert wheel.theta_road == pytest.approx(0.393, abs=0.02)


def shaken(stroke: float, seconds: float = 2.0) -> np.ndarray:
    """A plate that moves at 20 Hz with a stroke in m: a block of a tenth of a second holds two turns."""
    return 0.5 * stroke * np.cos(2.0 * np.pi * 20.0 * np.arange(round(seconds * RATE)) / RATE)


def test_a_plate_moves_by_blocks_of_a_tenth_of_a_second() -> None:
    height = shaken(1e-3)
    height[:630] = height[1410:] = 0.0
    assert moving_part(height, RATE, LEAST) == (600, 1500)
    assert moving_part(shaken(1.01 * LEAST), RATE, LEAST) == (0, 2000)
    assert moving_part(shaken(0.99 * LEAST), RATE, LEAST) is None
    for times, found in (
        (1.6, (0, 2000)),
        (1.7, None),
    ):  # shaken more than 0.6 times the other plate
        assert moving_part(shaken(2e-3), RATE, LEAST, times * shaken(2e-3)) == found
    for idle, end in ((0.21, 2000), (0.18, 1000)):
        ours, theirs = shaken(idle * LEAST), shaken(1.2 * LEAST)
        ours[:1000], theirs[1000:] = shaken(2e-3)[:1000], 0.0
        assert moving_part(ours, RATE, LEAST, theirs) == (0, end)


def test_mean_shaking_leaves_out_slow_swings() -> None:
    height = shaken(1e-3)
    assert mean_shaking(height + 0.05 * np.arange(2000) / RATE, RATE) == pytest.approx(
        1e-3, rel=0.02
    )
    height[1000:] = 3e-3
    assert mean_shaking(height, RATE) == pytest.approx(0.5e-3, rel=0.02)
    assert mean_shaking(height[:99], RATE) == 0.0 < mean_shaking(height[:100], RATE)


@pytest.mark.parametrize(
    ("gains", "part"),
    [
        ([1, -2, 3, 1, -1, 2, -9, 4], [2, 3, 4, 5]),
        ([-1, -2], []),
        ([5, -1, -1], [0]),
        ([-3, 1, 2], [1, 2]),
    ],
)
def test_the_part_with_the_greatest_sum(gains, part) -> None:
    assert _greatest_part(np.array(gains, dtype=float)).tolist() == part


@pytest.mark.parametrize(
    ("moving", "other", "part"),
    [
        ((200, 5000), None, (0, 200)),
        ((199, 5000), None, (6000, 10_000)),
        ((199, 7000), None, (8000, 10_000)),
        ((199, 7001), None, None),
        ((3000, 5000), (1000, 2000), (0, 1000)),
        ((3000, 5000), (3500, 9000), (0, 3000)),
        ((199, 3000), (6000, 9000), (4000, 6000)),
        ((199, 3000), (5999, 9000), None),
        ((199, 3000), (100, 2000), (4000, 10_000)),
    ],
)
def test_when_a_wheel_stands_still(moving, other, part) -> None:
    """0.2 s before the plate moves, or 2 s from one second after it has stopped, while the other one stands, too."""
    time = np.arange(10_000) / RATE
    force = 4e3 + 10.0 * time**2
    signals = WheelSignals("left", time, force, None, None, None, 20.0)
    found = standstill_force(signals, moving, other)
    assert found == (
        None if part is None else pytest.approx(float(np.median(force[slice(*part)])), rel=1e-12)
    )


def test_a_wheel_that_swings_on_does_not_stand() -> None:
    time = np.arange(10_000) / RATE
    for share, stands in ((0.099, True), (0.101, False)):
        force = 4e3 * (1.0 + share * np.sqrt(2.0) * np.sin(2.0 * np.pi * time))
        signals = WheelSignals("left", time, force, None, None, None, 20.0)
        assert (standstill_force(signals, (100, 5000), None) is not None) is stands


def test_how_much_the_other_plate_may_be_shaken() -> None:
    time, force = np.arange(2000) / RATE, np.full(2000, 4e3)

    def record(stroke: float, **more):
        heights = {
            "left.plate.z": (shaken(1e-3), "m", ""),
            "right.plate.z": (shaken(stroke), "m", ""),
        }
        return recording(time, {**heights, "left.plate.force": (force, "N", ""), **more})

    right = {"right.plate.force": (force, "N", "")}
    assert evaluation.tested_wheels(record(0.49e-3, **right), {"wheel_order": "left"}) == ("left",)
    assert evaluation.tested_wheels(record(0.51e-3, **right), {"wheel_order": "left"}) == (
        "left",
        "right",
    )
    assert evaluation.tested_wheels(record(0.1e-3, **right), {"wheel_order": "left, right"}) == (
        "left",
        "right",
    )
    for stroke, codes in ((0.096e-3, []), (0.104e-3, ["force_missing"])):
        lost = evaluation._without_force(record(stroke), {})
        assert [one.code for wheel in lost for one in wheel.findings] == codes


def test_loads_and_means_beside_the_vehicle_file() -> None:
    for share, told in ((1.149, False), (1.151, True), (0.851, False), (0.849, True)):
        found = evaluation._vehicle_findings(share * 4e3, 4e3, "left")
        assert [one.words for one in found] == (
            [{"load": share * 4e3, "expected": 4e3}] if told else []
        )
    assert evaluation._vehicle_findings(9e3, None, "left") == []
    time = 5.0 + np.arange(1000) / RATE
    signals = WheelSignals("left", time, 4e3 + 1e3 * (time - 5.0) ** 2, None, None, None, 20.0)
    means = evaluation._mean_by_turn(signals, np.array([5.1, 5.3, 5.6]))
    expected = [signals.force[100:300].mean(), signals.force[300:600].mean(), np.nan]
    np.testing.assert_allclose(means, expected, rtol=1e-12)
    turning = np.array([0.29, 0.2, 0.31, 9.0, 0.31, 0.29])
    blind = WheelSignals("left", np.arange(6.0), np.ones(6), None, turning, None, 20.0)
    assert evaluation._moving(blind, None, LEAST, None) == (2, 5)
