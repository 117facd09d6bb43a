"""Records of simulated tests: channels, sensors, programme, findings, files, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, JounceError, OutputError, SimulationError
from jounce.inspection.evaluation import evaluate
from jounce.inspection.simulated import simulate_inspection
from jounce.parts import load
from jounce.parts.testers import Programme, load_tester
from jounce.parts.variants import wear_dampers
from jounce.parts.vehicles import axle_of
from jounce.recordings.schema import check_recording
from jounce.testers.plate_response import closed_form_adhesion, steady_response, wheel_mode
from jounce.testers.programme import angle_of, swept_angle
from jounce.testers.testing import Sensors, findings_of_test, simulate_test, write_test

EGEA = load_tester("egea-specsus2018")
QUICK = EGEA.with_changes({"programme.sweep_rate": "20 Hz/s", "programme.hold_time_per_load": 0.0})
CAR = load("audi-a6-quarter-car")


def test_the_angle_is_smooth_and_ends_at_rest():
    programme = Programme(start_frequency=20.0, end_frequency=5.0, hold_time=1.0, sweep_rate=3.0)
    test = swept_angle(programme, 4000.0, begin=2.0)
    assert test.edges == pytest.approx([2.0, 3.0, 8.0, 8.5], abs=1e-12)
    angle = angle_of([test])
    before, after = (angle.evaluate(test.edges[1:] + side) for side in (-1e-9, 1e-9))
    assert np.allclose(before[0], after[0], atol=1e-6)
    assert np.allclose(before[1], after[1], atol=1e-4)
    rates = angle.evaluate(np.array([1.0, 2.5, 5.5, 9.0]))[1] / (2.0 * np.pi)
    assert rates == pytest.approx([0.0, 20.0, 12.5, 0.0], abs=1e-9)
    assert angle.evaluate(np.array([9.0]))[0][0] == pytest.approx(test.end, rel=1e-12)


def test_sweeps_may_go_up():
    programme = Programme(start_frequency=2.0, end_frequency=12.0, hold_time=0.0, sweep_rate=2.0)
    rates = angle_of([swept_angle(programme, 4000.0)]).evaluate(np.array([0.0, 2.5, 4.999]))[1] / (
        2.0 * np.pi
    )
    assert rates == pytest.approx([2.0, 7.0, 11.998], abs=1e-9)


def test_a_record_is_a_recording():
    record = simulate_test(CAR, QUICK, about={"axle": "rear", "vehicle": "A6"})
    check_recording(record)
    assert {
        "left.plate.z",
        "left.plate.force",
        "truth.left.tyre.force",
        "truth.left.sprung.az",
    } <= set(record)
    assert record.attrs["left.static_load"] == pytest.approx(4954.05, abs=1e-6)
    assert (record.attrs["left.plate_mass"], record.attrs["axle"]) == (20.0, "rear")
    assert np.allclose(np.diff(record["time"]), 1e-3, atol=1e-12)
    assert record["left.plate.z"].values.max() == pytest.approx(0.003, rel=1e-3)
    jerk = 1000.0 * 0.003 * 2.0 * np.pi * 25.0  # the damped tyre feels the plate start at speed
    assert record["left.plate.force"].values[0] == pytest.approx(4954.05 + jerk, abs=0.01)
    right = simulate_test(CAR, QUICK, wheel="right", truth=False)
    assert set(right) == {"right.plate.z", "right.plate.force"}
    assert right.attrs["wheel_order"] == "right"


def test_left_is_tested_before_right():
    record = simulate_test(axle_of(load("audi-a6-full-car"), "front"), QUICK, truth=False)
    assert record.attrs["wheel_order"] == "left, right"
    moving = {
        side: np.flatnonzero(np.abs(np.diff(record[f"{side}.plate.z"])) > 1e-9)
        for side in ("left", "right")
    }
    assert moving["left"][-1] + 950 < moving["right"][0]
    same = simulate_test(load("audi-a6-full-car"), QUICK, truth=False)
    assert same.equals(record)


def test_noise_is_as_asked_and_repeatable():
    clean, noisy, again, other = (
        simulate_test(CAR, QUICK, noise=noise, seed=seed, truth=False)["left.plate.force"].values
        for noise, seed in ((0.0, 1), (0.01, 1), (0.01, 1), (0.01, 2))
    )
    assert np.array_equal(noisy, again)
    assert not np.array_equal(noisy, other)
    assert np.std(noisy - clean) == pytest.approx(0.01 * 4954.05, rel=0.05)
    assert abs(np.mean(noisy - clean)) < 3.0 * 49.5 / np.sqrt(len(clean))


def test_sensors_clip_shift_and_count():
    sensors = Sensors(displacement_noise=1e-5, force_offset=100.0, force_limit=5500.0, tacho=True)
    clean, read = (
        simulate_test(CAR, QUICK, truth=False),
        simulate_test(CAR, QUICK, truth=False, sensors=sensors),
    )
    force = np.minimum(clean["left.plate.force"].values + 100.0, 5500.0)
    assert np.allclose(read["left.plate.force"], force, atol=1e-9)
    assert np.std(read["left.plate.z"].values - clean["left.plate.z"].values) == pytest.approx(
        1e-5, rel=0.1
    )
    assert read["left.plate.frequency"].values[0] == pytest.approx(25.0, abs=1e-6)


def test_findings_name_what_is_out_of_range():
    assert findings_of_test(CAR, EGEA) == []
    heavy = CAR.with_changes({"sprung.mass": 1500.0})
    light = CAR.with_changes({"sprung.mass": 40.0})
    assert "outside" in findings_of_test(heavy, EGEA)[0].message
    assert findings_of_test(light, EGEA)[0].value == pytest.approx(85.0 * 9.81, rel=1e-9)
    quick = [one.message for one in findings_of_test(CAR, QUICK)]
    assert ["faster" in quick[0], "shorter" in quick[1]] == [True, True]
    slow = findings_of_test(CAR, EGEA.with_changes({"sampling_frequency": 500.0}))
    assert slow[0].place == "sampling_frequency"


def test_files_have_a_header_that_says_the_load(tmp_path):
    record = simulate_test(CAR, QUICK, truth=False, about={"vehicle": 'the "blue" one'})
    file = write_test(record, tmp_path / "lane.csv")
    text = file.read_text(encoding="utf-8").splitlines()
    assert '# left.plate_mass = "20.0 kg"' in text
    assert '# vehicle = "the \\"blue\\" one"' in text
    assert "time [s],left.plate.z [mm],left.plate.force [N]" in text
    with pytest.raises(OutputError):
        write_test(record, file)
    write_test(record, tmp_path / "lane.nc")
    with pytest.raises(OutputError):
        write_test(record, tmp_path / "lane.ods")


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda: simulate_test(load("audi-a6-half-car"), EGEA), "cannot be placed on a tester"),
        (lambda: simulate_test(load("formula-student-car"), EGEA), "cannot be placed on a tester"),
        (lambda: simulate_test(CAR, EGEA, wheel="middle"), "left, right"),
        (lambda: simulate_test(CAR, EGEA, other="running"), "excited, still"),
        (lambda: simulate_test(CAR, EGEA, noise=-0.1), "noise"),
        (lambda: simulate_test(CAR, EGEA, noise=float("nan")), "noise"),
        (lambda: Sensors(force_limit=-1.0), "force_limit"),
        (lambda: steady_response(CAR, EGEA, [0.0]), "above 0 Hz"),
        (lambda: steady_response(CAR, EGEA, [10.0], wheel="both"), "left, right"),
        (lambda: wheel_mode(CAR, EGEA, on="moon"), "rig, road"),
        (
            lambda: simulate_test(load("audi-a6-full-car"), EGEA, about={"axle": "middle"}),
            "front, rear",
        ),
        (lambda: wear_dampers(CAR, 1.5), "0 .new. to 1"),
    ],
)
def test_refused(call, says):
    with pytest.raises(JounceError, match=says) as caught:
        call()
    assert isinstance(caught.value, (DescriptionError, SimulationError))


@pytest.mark.parametrize(
    "name", ["audi-a6-quarter-car", "audi-a6-full-car", "kart-double-wishbone", "polaris-front"]
)
def test_wear_takes_force_from_the_dampers_only(name):
    new = load(name)
    half, before = wear_dampers(new, 0.5).parameters(), new.parameters()
    changed = {path for path, value in before.items() if half[path] != value}
    assert changed
    assert all("damp" in path and "tyre" not in path for path in changed)
    assert all(half[path] == pytest.approx(0.5 * before[path], rel=1e-12) for path in changed)
    assert wear_dampers(new, 0.0).parameters() == before


def test_an_overdamped_wheel_has_no_mode():
    assert wheel_mode(CAR.with_changes({"strut.damper.coefficient": 20000.0}), EGEA) is None


def test_the_band_limit_counts_with_a_damped_tyre():
    damped = CAR.with_changes({"tyre.damping_coefficient": 3000.0})
    adhesion, at = closed_form_adhesion(damped, EGEA)
    assert at == 25.0
    assert adhesion == pytest.approx(
        float(steady_response(damped, EGEA, [25.0]).adhesion[0]), abs=1e-12
    )


def test_a_tester_is_named_as_a_rig_is() -> None:
    named, given = (steady_response(CAR, tester, [16.6]) for tester in ("egea-specsus2018", EGEA))
    assert named.adhesion.tolist() == given.adhesion.tolist()
    assert simulate_inspection(CAR, "egea-specsus2018", steady=True).wheel.adhesion is not None
    record = simulate_test(CAR, QUICK)
    named, given = (
        evaluate(record, tester).wheels[0].phase_angle_min_deg
        for tester in ("egea-specsus2018", EGEA)
    )
    assert named == given is not None
    for call in (
        lambda: simulate_test(CAR, "egea-specsus2018x"),
        lambda: evaluate(record, "egea-specsus2018x"),
    ):
        with pytest.raises(DescriptionError, match="egea-specsus2018"):
            call()
    with pytest.raises(DescriptionError, match="not a tester"):
        simulate_inspection(CAR, 6)  # type: ignore[arg-type]
