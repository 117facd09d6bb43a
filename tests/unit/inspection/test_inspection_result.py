"""The result as plain JSON: the keys that other programs read, no NaN, uncertainties beside the values."""

from __future__ import annotations

import dataclasses
import json

import pytest

from jounce.inspection import Inspection, WheelResult, evaluate
from jounce.inspection.archive.exporting import VALUES
from jounce.inspection.grading import grade
from jounce.inspection.methods import QUANTITIES
from jounce.inspection.quantities import NUMBERS

KEYS = {
    "adhesion",
    "phase_angle_min_deg",
    "phase_frequency_hz",
    "relative_force_amplitude",
    "tyre_rigidity",
    "theta_rig",
    "theta_road",
    "lift_off",
    "uncertainty",
    "grade",
    "verdict",
    "reasons",
    "findings",
}


@pytest.fixture(scope="module")
def inspection(twin, left_record, eusama):
    car = twin.Car()
    time, height, force, _ = twin.rigid_record(car, twin.Programme(), mp=20.0, fine=4)
    return evaluate(
        left_record(time, height, force, car.static_load, axle="rear", vehicle="A6"),
        eusama,
        vehicle=None,
    )


def test_keys(inspection):
    table = json.loads(json.dumps(inspection.to_dict(), allow_nan=False))
    assert table["axle"] == {"axle": "rear"}
    assert table["facts"]["vehicle"] == "A6"
    (wheel,) = table["wheels"]
    assert set(wheel) >= KEYS
    assert wheel["wheel"] == "left"
    assert wheel["theta_graded"] == "theta_road"
    assert wheel["verdict"] == "not graded"
    assert (wheel["grade"], wheel["reasons"], wheel["findings"], wheel["lift_off"]) == (
        {},
        [],
        [],
        False,
    )
    values = {
        "adhesion",
        "phase_angle_min_deg",
        "relative_force_amplitude",
        "tyre_rigidity",
        "theta_rig",
        "theta_road",
    }
    values.add("body_damping_ratio")
    assert set(wheel["uncertainty"]) == values
    assert all(0.0 <= wheel["uncertainty"][key] < 0.01 * wheel[key] for key in values)
    assert wheel["adhesion"] + wheel["relative_force_amplitude"] == pytest.approx(1.0)
    assert wheel["tyre_rigidity"] == pytest.approx(0.571 * 250.4e3 + 46e3, rel=2e-3)


def test_unfit_wheels_are_null(left_record, inspection, eusama, twin):
    time, height, force, _ = twin.rigid_record(twin.Car(), twin.Programme(), mp=20.0, fine=4)
    (wheel,) = evaluate(left_record(time[:800], height[:800], force[:800]), eusama).to_dict()[
        "wheels"
    ]
    assert all(
        wheel[key] is None
        for key in KEYS - {"lift_off", "uncertainty", "grade", "verdict", "reasons", "findings"}
    )
    assert wheel["findings"][0]["severity"] == "problem"


def test_methods_are_chosen(twin, left_record, eusama):
    time, height, force, _ = twin.rigid_record(twin.Car(), twin.Programme(), mp=20.0, fine=4)
    found = evaluate(left_record(time, height, force, 4316.4), eusama, methods=["theta"])
    assert found.methods == ("theta",)
    wheel = found.wheel("left")
    assert wheel.adhesion is wheel.phase_angle_min_deg is wheel.tyre_rigidity is None
    assert wheel.theta_road == pytest.approx(0.1708, abs=2e-4)


def test_vehicle_of_another_weight_is_said(twin, left_record, eusama):
    @dataclasses.dataclass
    class Part:
        mass: float

    @dataclasses.dataclass
    class Rig:
        sprung: Part
        unsprung: Part

    time, height, force, _ = twin.rigid_record(twin.Car(), twin.Programme(), mp=20.0, fine=4)
    record = left_record(time, height, force, 4316.4)
    heavy = evaluate(record, eusama, Rig(Part(600.0), Part(40.0))).wheel("left").findings
    assert ["is not that of the vehicle file" in one.message for one in heavy] == [True]
    assert evaluate(record, eusama, Rig(Part(410.0), Part(40.0))).wheel("left").findings == ()


def test_curves_go_with_the_values(inspection):
    wheel = inspection.wheel("left")
    curves = wheel.curves
    assert curves.least_force.min() / wheel.static_load == pytest.approx(wheel.adhesion, abs=2e-3)
    inside = (curves.frequency > 6.3) & (curves.frequency < 18.0)
    assert curves.phase_deg[inside].min() == pytest.approx(wheel.phase_angle_min_deg, abs=0.5)
    assert (curves.greatest_force[2:-4] > curves.least_force[2:-4]).all()


def test_nothing_graded_without_wheels():
    assert not Inspection(()).is_gradable
    assert WheelResult("left").verdict == "not graded"


def test_a_result_prints_as_a_table_of_eighty_columns() -> None:
    wheels = tuple(
        WheelResult(
            side,
            adhesion=share,
            phase_angle_min_deg=41.25,
            uncertainty={"adhesion": 0.0123},
            lift_off=True,
        )
        for side, share in (("left", 0.399), ("right", None))
    )
    text = str(Inspection(wheels, axle={"axle": "front"}))
    assert max(map(len, text.splitlines())) <= 80
    lines = [" ".join(line.split()) for line in text.splitlines()]
    assert "adhesion (EUSAMA) 39.9 % ± 1.3 % –" in lines
    assert "least phase angle (EGEA) 41.2° 41.2°" in lines
    assert "tyre leaves the plate yes yes" in lines


def test_every_number_of_a_wheel_is_described_once() -> None:
    told = {name for name, one in WheelResult("left").to_dict().items() if one is None}
    assert told <= set(NUMBERS)
    assert list(VALUES) == list(NUMBERS)
    assert set(QUANTITIES) < set(NUMBERS)


def test_a_graded_axle_prints_values_verdict_and_reasons(inspection) -> None:
    text = str(grade(inspection))
    table, *reasons = text.split("\nverdict")
    assert text.startswith("rear: pass")
    assert max(map(len, table.splitlines())) <= 80
    assert "left: " in reasons[0]
