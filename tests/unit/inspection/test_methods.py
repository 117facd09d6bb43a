"""A method of inspection is one row: with it records are evaluated, limits are given, and wheels are graded."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest

from jounce.core.catalogue import Row, catalogue_of
from jounce.core.errors import DescriptionError
from jounce.inspection import evaluate, grade
from jounce.inspection.findings import sentence_of, warning
from jounce.inspection.limits import Limits, shipped_limits
from jounce.inspection.methods import (
    METHODS,
    QUANTITIES,
    Method,
    MethodResult,
    WheelTest,
    methods_on,
)
from jounce.inspection.quantities import WheelQuantity

STROKE = WheelQuantity(
    "mean_stroke", "m", "mm", 1e3, 2, "mean stroke of the plate", "mittlerer Hub der Platte"
)


def mean_stroke(test: WheelTest) -> MethodResult:
    value = float(np.mean(test.strokes))
    about = [warning(f"{test.signals.wheel}.plate.z", "long_stroke", value, stroke=1e3 * value)]
    return MethodResult({STROKE.name: value}, {STROKE.name: 1e-5}, about)


@pytest.fixture
def scratch(monkeypatch) -> Method:
    """What one more row of the table gives."""
    row = Row(
        "warning", "the plate moves {stroke:.1f} mm.", "Die Platte bewegt sich um {stroke:.1f} mm."
    )
    method = Method("stroke", "STROKE", "eusama", ("rigid-plate",), (STROKE,), mean_stroke)
    monkeypatch.setitem(METHODS, method.key, method)
    monkeypatch.setitem(QUANTITIES, STROKE.name, STROKE)
    monkeypatch.setitem(catalogue_of("inspection").rows, "long_stroke", row)
    return method


BANDS = {
    "quantity": "mean_stroke",
    "source": "a scratch",
    "bands": [
        {"to": "5 mm", "label": "short", "colour": "red", "verdict": "fail"},
        {"from": "5 mm", "label": "long", "label_de": "lang", "colour": "green", "verdict": "pass"},
    ],
}


def test_one_row_is_a_method(scratch, twin, left_record, eusama) -> None:
    time, height, force, _ = twin.rigid_record(twin.Car(), twin.Programme(), mp=20.0, fine=4)
    record = left_record(time, height, force, twin.Car().static_load)
    assert methods_on("rigid-plate") == ("eusama", "egea", "theta", "stroke")
    inspection = evaluate(record, eusama)
    wheel = inspection.wheel("left")
    assert wheel.value("mean_stroke") == pytest.approx(6e-3, rel=2e-2)
    assert wheel.to_dict()["mean_stroke"] == wheel.more["mean_stroke"]
    assert [sentence_of(one, "de") for one in wheel.findings] == [
        "Die Platte bewegt sich um 6.0 mm.".replace(".0", ",0")
    ]
    table = tomllib.loads(shipped_limits().read_text(encoding="utf-8"))
    limits = Limits.from_table({**table, "methods": {**table["methods"], "stroke": BANDS}})
    graded = grade(inspection, limits, deciding=["stroke"])
    assert graded.wheels[0].verdict == "pass"
    assert graded.wheels[0].grade["stroke"] == "long"
    assert any("mean stroke of the plate 6.0" in reason for reason in graded.wheels[0].reasons)
    assert evaluate(record, eusama, methods=["stroke"]).wheel("left").adhesion is None


def test_without_its_row_it_is_none(twin, left_record, eusama) -> None:
    time, height, force, _ = twin.rigid_record(twin.Car(), twin.Programme(), mp=20.0, fine=4)
    with pytest.raises(DescriptionError, match="stroke"):
        evaluate(
            left_record(time, height, force, twin.Car().static_load), eusama, methods=["stroke"]
        )
