"""Records that cannot be graded say why in one sentence and get no value; what only weakens a value is a finding."""

from __future__ import annotations

import re

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.inspection import evaluate
from jounce.inspection.evaluation import require_gradable
from jounce.parts.testers import load_tester
from jounce.recordings import recording


@pytest.fixture(scope="module")
def car_run(twin):
    """Car A: time, height, force under the plate (20 kg), contact force."""
    return twin.rigid_record(twin.Car(), twin.Programme(before=0.5), mp=20.0, fine=4)


@pytest.fixture(scope="module")
def load(twin):
    return twin.Car().static_load


def assert_unfit(record, tester, message: str, wheel: str = "left") -> None:
    inspection = evaluate(record, tester)
    found = inspection.wheel(wheel)
    assert not found.is_gradable
    assert not inspection.is_gradable
    assert [text for text in found.reasons if message in text], found.reasons
    assert len(found.reasons) == 1
    assert found.verdict == "not graded"
    assert (
        found.adhesion
        is found.phase_angle_min_deg
        is found.theta_road
        is found.tyre_rigidity
        is None
    )
    assert found.grade == {}
    with pytest.raises(RecordingError, match="lane.csv: .*" + re.escape(message[:12])):
        require_gradable(inspection, "lane.csv")


def assert_weakened(record, tester, message: str) -> None:
    inspection = evaluate(record, tester)
    found = inspection.wheel("left")
    require_gradable(inspection)
    assert [
        one for one in found.findings if message in one.message and one.severity == "warning"
    ], found.findings
    assert found.adhesion is not None


def test_good_record_has_no_findings(car_run, load, left_record, eusama):
    time, height, force, _ = car_run
    found = evaluate(left_record(time, height, force, load), eusama)
    assert found.findings == found.wheel("left").findings == ()
    require_gradable(found)


@pytest.mark.parametrize(
    ("change", "text"),
    [
        (
            lambda record: record["left.plate.force"].assign_attrs(units="kN"),
            "a different unit; found 'kN'; allowed: N",
        ),
        (
            lambda record: record["left.plate.force"].astype(complex),
            "not real numbers; found 'complex128'",
        ),
        (
            lambda record: record["time"].assign_attrs(units="ks"),
            "time has the wrong unit; found 'ks'",
        ),
    ],
)
def test_a_record_that_is_not_in_si_is_refused(
    change, text: str, car_run, load, left_record, eusama
) -> None:
    time, height, force, _ = car_run
    record = left_record(time, height, force, load)
    changed = change(record)
    with pytest.raises(RecordingError, match=text):
        evaluate(record.assign({changed.name: changed}), eusama)


CHANGES = {
    "swapped columns": (lambda t, z, f: (t, 1e-3 * f, 1e3 * z), "plate and force are swapped"),
    "pounds": (lambda t, z, f: (t, z, 0.224809 * f), "pounds (lbf)"),
    "inches": (lambda t, z, f: (t, z / 25.4, f), "inches"),
    "metres for millimetres": (lambda t, z, f: (t, 1e-3 * z, f), "metres"),
    "another stroke": (lambda t, z, f: (t, 2.0 * z, f), "wrong tester"),
    "force offset": (lambda t, z, f: (t, z, f + 600.0), "offset of +600 N"),
    "inverted height": (lambda t, z, f: (t, -z, f), "the plate height has the wrong sign"),
    "jitter": (lambda t, z, f: (t + 3e-4 * np.sin(1e5 * t), z, f), "the time step jitters"),
    "time that falls": (
        lambda t, z, f: (np.where(t > 3.0, t - 1.0, t), z, f),
        "time does not increase",
    ),
    "no sweep": (lambda t, z, f: (t[:2450], 1.0 * z[:2450], f[:2450]), "sweep is missing"),
    "cut off": (
        lambda t, z, f: (t[:7000], z[:7000], f[:7000]),
        "the record is too short, the sweep is cut off",
    ),
    "too short": (lambda t, z, f: (t[:500], z[:500], f[:500]), "the record is too short"),
    "dropout": (
        lambda t, z, f: (t, z, np.where((t > 6.0) & (t < 6.05), 0.0, f)),
        "a dropout of the signal",
    ),
    "saturated": (lambda t, z, f: (t, z, np.minimum(f, 5400.0)), "saturated"),
    "not a number": (
        lambda t, z, f: (t, z, np.where(np.arange(t.size) == 4000, np.nan, f)),
        "1 sample is not a number",
    ),
    "two sweeps": (
        lambda t, z, f: (np.arange(2 * t.size) * 1e-3, np.tile(z, 2), np.tile(f, 2)),
        "2 sweeps in one record",
    ),
    "wrong weight": (lambda t, z, f: (t, z, 0.85 * f), "the static load contradicts the signal"),
    "dead plate": (lambda t, z, f: (t, 0.0 * z, f), "the plate never moves"),
    "slow sampling": (lambda t, z, f: (t[::8], z[::8], f[::8]), "samples per second is too few"),
    "no wheel": (
        lambda t, z, f: (t, z, 0.0 * f + 4316.4),
        "no wheel on a plate explains this record",
    ),
}


@pytest.mark.parametrize("name", CHANGES)
def test_unfit_records_say_why(name, car_run, load, left_record, eusama):
    change, message = CHANGES[name]
    time, height, force = change(*car_run[:3])
    assert_unfit(left_record(time, height, force, load), eusama, message)


WEAKER = {
    "load off": (lambda t, z, f: (t, z, f + 150.0), "+3.5 %, but only 2 % is allowed"),
    "sampling": (lambda t, z, f: (t[::2], z[::2], f[::2]), "500 samples per second"),
    "a few clipped": (
        lambda t, z, f: (t, z, np.minimum(f, np.sort(f)[-25])),
        "the force is clipped",
    ),
    "stroke off": (lambda t, z, f: (t, 1.15 * z, f), "they may differ by 0.6 mm"),
    "slips": (lambda t, z, f: (t, z, f - 500.0 * ((t > 5.0) & (t < 7.0))), "the wheel slips"),
    "another machine": (
        lambda t, z, f: (t, z, f + 120.0 * np.sin(2 * np.pi * 14.3 * t)),
        "vibrates at 14.3 Hz",
    ),
}


@pytest.mark.parametrize("name", WEAKER)
def test_weaker_records_say_so(name, car_run, load, left_record, eusama):
    change, message = WEAKER[name]
    time, height, force = change(*car_run[:3])
    assert_weakened(left_record(time, height, force, load), eusama, message)


def test_limits_of_a_static_load_that_is_off(car_run, left_record, eusama):
    time, height, force, _ = car_run
    measured = evaluate(left_record(time, height, force), eusama).wheel("left").static_load
    for off, words in (
        (0.0195, ""),
        (0.0205, "but only 2 % is allowed"),
        (0.0795, "but only 2 % is allowed"),
    ):
        found = evaluate(left_record(time, height, force, measured / (1.0 + off)), eusama).wheel(
            "left"
        )
        told = [one.value for one in found.findings if "% is allowed" in one.message]
        assert told == ([pytest.approx(1.0 + off, abs=1e-4)] if words else [])
    assert_unfit(
        left_record(time, height, force, measured / 1.0805),
        eusama,
        "the static load contradicts the signal",
    )


def test_small_jitter_is_resampled(car_run, load, left_record, eusama):
    time, height, force, _ = car_run
    straight = evaluate(left_record(time, height, force, load), eusama).wheel("left")
    shaken = evaluate(left_record(time + 2e-6 * np.sin(1e5 * time), height, force, load), eusama)
    assert "resampled" in shaken.findings[0].message
    assert shaken.wheel("left").adhesion == pytest.approx(straight.adhesion, abs=1e-3)


def test_sweep_that_is_too_fast(twin, load, left_record, eusama):
    time, height, force, _ = twin.rigid_record(
        twin.Car(), twin.Programme(rate=6.0), mp=20.0, fine=4
    )
    assert_weakened(left_record(time, height, force, load), eusama, "the sweep is too fast: 6 Hz/s")


def test_tyre_and_weight_out_of_range(twin, left_record, eusama):
    soft, light = twin.Car(kt=120e3), twin.Car(ms=75.0, mu=14.0, k=5e3, c=900.0, kt=120e3)
    for car, message in ((soft, "below 160 N/mm"), (light, "outside the wheel-load range")):
        time, height, force, _ = twin.rigid_record(car, twin.Programme(), mp=20.0, fine=4)
        assert_weakened(left_record(time, height, force, car.static_load), eusama, message)


def test_static_load_from_the_signal_is_said(car_run, load, left_record, eusama):
    time, height, force, _ = car_run
    found = evaluate(left_record(time, height, force), eusama).wheel("left")
    assert found.static_load == pytest.approx(load, rel=1e-3)
    assert "the header gives no static load" in found.findings[0].message
    assert_unfit(
        left_record(time, height, 0.0224809 * force), eusama, "which is implausible for a wheel"
    )


@pytest.fixture(scope="module")
def axle(twin):
    """Left, then right: time, heights, forces, loads."""
    cars = twin.Car(), twin.Car(ms=350.0, c=800.0)
    runs = [twin.rigid_record(car, twin.Programme(before=0.5), mp=20.0, fine=4) for car in cars]
    count = runs[0][0].size
    time = np.arange(2 * count) / 1000.0
    heights = [
        np.append(runs[0][1], np.full(count, runs[0][1][-1])),
        np.append(np.zeros(count), runs[1][1]),
    ]
    rest = [np.full(count, car.static_load) for car in cars]
    forces = [np.append(runs[0][2], rest[0]), np.append(rest[1], runs[1][2])]
    return time, heights, forces, [car.static_load for car in cars]


class TestBothWheels:
    @staticmethod
    def build(time, heights, forces, loads, **facts):
        channels, known = {}, dict(facts)
        for side, z, f, weight in zip(("left", "right"), heights, forces, loads, strict=True):
            channels |= {f"{side}.plate.z": (z, "m", ""), f"{side}.plate.force": (f, "N", "")}
            known[f"{side}.static_load"] = weight
        return recording(time, channels, attributes=known)

    def test_one_after_the_other(self, axle, eusama, twin):
        found = evaluate(self.build(*axle, axle="front"), eusama)
        assert found.axle == {"axle": "front"}
        assert [wheel.wheel for wheel in found.wheels] == ["left", "right"]
        assert [one.code for wheel in found.wheels for one in wheel.findings] == ["order_missing"]
        for wheel, car in zip(found.wheels, (twin.Car(), twin.Car(ms=350.0, c=800.0)), strict=True):
            assert wheel.theta_road == pytest.approx(car.wheel_damping(), rel=2e-3)

    def test_swapped_sides(self, axle, eusama):
        time, heights, forces, loads = axle
        assert_unfit(
            self.build(time, heights[::-1], forces[::-1], loads),
            eusama,
            "left and right are swapped",
        )
        assert_unfit(
            self.build(time, heights, forces, loads[::-1]),
            eusama,
            "left and right are swapped",
            "right",
        )

    def test_same_offset_on_both(self, axle, eusama):
        time, heights, forces, loads = axle
        assert_unfit(
            self.build(time, heights, [f - 450.0 for f in forces], loads), eusama, "-450 N off"
        )

    def test_one_bad_wheel_leaves_the_other(self, axle, eusama):
        time, heights, forces, loads = axle
        broken = np.where(np.arange(time.size) == 15_000, np.nan, forces[1])
        found = evaluate(self.build(time, heights, [forces[0], broken], loads), eusama)
        assert found.wheel("left").is_gradable
        assert found.wheel("left").adhesion == pytest.approx(0.611, abs=2e-3)
        assert (
            found.wheel("right")
            .reasons[0]
            .startswith("1 sample is not a number, the first at 15 s")
        )

    def test_other_plate_left_running(self, axle, eusama):
        time, heights, forces, loads = axle
        running = np.where(time < 12.0, 3e-3 * np.sin(50.0 * np.pi * time), heights[1])
        record = self.build(time, [heights[0], running], forces, loads)
        assert_weakened(record, eusama, "the other plate runs for")
        record.attrs["wheel_order"] = "together"
        found = evaluate(record, eusama).wheel("left").findings
        assert [one.severity for one in found if "the other plate" in one.message] == ["note"]


def test_force_alone_needs_a_tacho(car_run, load, twin, eusama):
    time, _, _, force = car_run
    forces = {"left.plate.force": (force, "N", "")}
    weights = {"left.static_load": load}
    assert_unfit(
        recording(time, forces, attributes=weights),
        eusama,
        "neither left.plate.z nor left.plate.frequency",
    )
    angle = twin.Programme(before=0.5).angle(time)
    tacho = np.gradient(angle, time) / (2.0 * np.pi)
    record = recording(
        time, forces | {"left.plate.frequency": (tacho, "Hz", "")}, attributes=weights
    )
    found = evaluate(record, eusama).wheel("left")
    assert found.adhesion == pytest.approx(0.6107, abs=2e-3)
    assert found.phase_angle_min_deg is found.theta_road is found.tyre_rigidity is None
    assert len(found.findings) == 2


def test_wrong_questions(car_run, load, left_record, eusama):
    record = left_record(*car_run[:3], load)
    with pytest.raises(DescriptionError, match=r"unknown method 'eusma'.*Did you mean 'eusama'"):
        evaluate(record, eusama, methods=["eusma"])
    with pytest.raises(DescriptionError, match="method of a sprung plate 'egea'"):
        evaluate(record, load_tester("boge"), methods=["egea"])
    with pytest.raises(RecordingError, match="the record has no plate force"):
        evaluate(record.drop_vars("left.plate.force"), eusama)


@pytest.mark.parametrize("delay", [3e-3, 6e-3, -2e-3])
def test_a_force_that_comes_late_or_early_gives_no_phase_angle(
    car_run, load, left_record, delay
) -> None:
    """3 ms of an amplifier's filter are ten degrees too many: they would pass a wheel that must fail."""
    time, height, force, _ = car_run
    tester = load_tester("egea-specsus2018")
    facts = {"left.plate_mass": 20.0}
    right = evaluate(left_record(time, height, force, load, **facts), tester).wheel("left")
    delayed = np.interp(time - delay, time, force)
    apart = evaluate(left_record(time, height, delayed, load, **facts), tester).wheel("left")
    assert right.findings == ()
    assert right.phase_angle_min_deg is not None
    assert apart.phase_angle_min_deg is None
    (said,) = [one for one in apart.findings if one.code in ("force_late", "force_early")]
    assert said.value == pytest.approx(delay, rel=0.2)
