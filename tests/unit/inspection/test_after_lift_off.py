"""What a record in which the tyre leaves the plate still says, and what it does not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from jounce.inspection import Inspection, WheelResult, evaluate
from jounce.inspection.grading import difference_of, grade, grade_vehicle
from jounce.inspection.limits import load_limits
from jounce.parts import load
from jounce.parts.testers import load_tester
from jounce.testers.testing import simulate_test

LIMITS = """
schema = "jounce.limits/1"
version = "1"
date = "2026-11-23"
source = "a workshop"

[methods.egea]
quantity = "phase_angle_min_deg"
source = "a workshop"
bands = [
  { to = "30 deg", label = "too small", colour = "red", verdict = "fail" },
  { from = "30 deg", to = "45 deg", to_included = true, label = "low", colour = "yellow", verdict = "advise" },
  { from = "45 deg", label = "good", colour = "green", verdict = "pass" },
]

[differences.phase]
quantity = "phase_angle_min_deg"
across = "wheels"
definition = "absolute"
methods = ["egea"]
source = "a workshop"
bands = [
  { from = 0, to = "12 deg", to_included = true, label = "in range", colour = "green", verdict = "pass" },
  { from = "12 deg", label = "too far apart", colour = "red", verdict = "fail" },
]
"""
WORN = {"strut.damper.coefficient": 250.0, "tyre.damping_coefficient": 100.0}


@pytest.fixture(scope="module")
def tester():
    return load_tester("egea-specsus2018")


@pytest.fixture(scope="module")
def limits(tmp_path_factory: pytest.TempPathFactory):
    file = tmp_path_factory.mktemp("limits") / "workshop.toml"
    file.write_text(LIMITS)
    return load_limits(file)


@pytest.fixture(scope="module")
def alike(tester) -> tuple[WheelResult, ...]:
    """One worn wheel, tested with two seeds of the noise."""
    car = load("audi-a6-quarter-car").with_changes(WORN)
    records = [simulate_test(car, tester, noise=0.01, seed=seed, truth=False) for seed in (1, 2)]
    return tuple(evaluate(record, tester).wheels[0] for record in records)


def test_the_phase_angle_after_lift_off_is_unreliable_and_has_no_interval(alike) -> None:
    angles = [wheel.phase_angle_min_deg for wheel in alike]
    assert np.ptp(angles) > 5.0  # the noise alone moves an angle by 0.2 degrees
    for wheel in alike:
        assert wheel.lift_off
        assert wheel.adhesion == 0.0
        assert wheel.unreliable == ("phase_angle_min_deg", "phase_frequency_hz")
        assert not set(wheel.unreliable) & set(wheel.uncertainty)
        assert "phase_after_lift_off" in [one.code for one in wheel.findings]
        assert (
            wheel.body_damping_ratio
            == wheel.value("body_damping_ratio")
            == pytest.approx(0.03, abs=0.02)
        )
        assert wheel.explained_force == wheel.value("explained_force") > 0.99
        assert wheel.to_dict()["unreliable"] == list(wheel.unreliable)


def test_a_wheel_that_stays_on_the_plate_keeps_its_interval(tester) -> None:
    sound = evaluate(
        simulate_test(load("audi-a6-quarter-car"), tester, truth=False), tester
    ).wheels[0]
    assert sound.unreliable == ()
    assert 0.0 < sound.uncertainty["phase_angle_min_deg"] < 1.0
    assert "phase_after_lift_off" not in [one.code for one in sound.findings]


def _graded(left, right, limits):
    return grade(Inspection((left, right), axle={"axle": "front"}, methods=("egea",)), limits)


def _wheel(name: str, angle: float, *, unreliable: bool) -> WheelResult:
    about = {"unreliable": ("phase_angle_min_deg",), "lift_off": True} if unreliable else {}
    halves = {} if unreliable else {"phase_angle_min_deg": 0.2}
    return WheelResult(
        name, static_load=4e3, phase_angle_min_deg=angle, uncertainty=halves, **about
    )


@pytest.mark.parametrize(("left", "right"), [(True, True), (True, False), (False, True)])
def test_wheels_are_not_called_unequal_by_an_unreliable_value(
    limits, left: bool, right: bool
) -> None:
    wheels = _wheel("left", 50.0, unreliable=left), _wheel("right", 70.0, unreliable=right)
    graded = _graded(*wheels, limits)
    (difference,) = [one for one in graded.differences if one.quantity == "phase_angle_min_deg"]
    sides = tuple(side for side, doubted in (("left", left), ("right", right)) if doubted)
    assert (difference.bands, difference.unreliable) == ({}, sides)
    assert graded.verdict == "pass"
    (said,) = [one for one in graded.reasons if one.kind == "unreliable_difference"]
    assert (
        f"is not graded: the value is unreliable where the tyre leaves the plate ({', '.join(sides)})"
        in said.text()
    )
    assert ("links" in said.text("de").rpartition("(")[2]) == left
    for wheel, doubted in zip(graded.grades, (left, right), strict=True):
        assert ("unreliable" in [one.kind for one in wheel.reasons]) == doubted
    sound = _graded(
        _wheel("left", 50.0, unreliable=False), _wheel("right", 70.0, unreliable=False), limits
    )
    assert sound.verdict == "fail"


def test_a_wheel_fails_by_its_own_small_value_and_says_that_it_is_unreliable(alike, limits) -> None:
    graded = _graded(replace(alike[0], wheel="left"), replace(alike[1], wheel="right"), limits)
    assert graded.verdict == "fail"
    assert [one.verdict for one in graded.grades] == ["fail", "fail"]
    assert all(
        any("unreliable after lift-off" in text for text in wheel.reasons)
        for wheel in graded.wheels
    )
    assert not any("too far apart" in reason.text() for reason in graded.reasons)


def test_front_and_rear_are_not_compared_by_an_unreliable_value(limits) -> None:
    one, other = _wheel("left", 50.0, unreliable=True), _wheel("left", 70.0, unreliable=False)
    found = difference_of("phase_angle_min_deg", one, other, ("front", "rear"), "left")
    assert found.unreliable == ("front",)
    assert found.to_dict()["unreliable"] == ["front"]
    axles = [
        grade(Inspection((wheel,), axle={"axle": axle}, methods=("egea",)), limits)
        for wheel, axle in ((one, "front"), (other, "rear"))
    ]
    assert all(not difference.bands for difference in grade_vehicle(axles).differences)
