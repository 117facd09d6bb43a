"""Targets on rows of a K&C sheet: values, slopes, designs that meet them, and what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.design.kinematics import read_task
from jounce.report.kinematic_design import kinematic_design_page

ELASTIC = "mcpherson-elastic"
STIFFNESS = "bushings.lower_arm_front.stiffness[0]"
TOE_OF_FORCE = {"test": "lateral-in-phase", "quantity": "toe", "value": "0 deg/kN"}


def test_values_are_those_of_the_sheet_and_slopes_are_exact() -> None:
    """Hardpoints and stiffnesses, usual and stated ranges, another state, and a range beyond the usual one."""
    rig = jn.load(ELASTIC)
    free = {"hardpoints.tie_rod_inner[2]": "10 mm", STIFFNESS: "100 N/mm"}
    targets: list[dict[str, Any]] = [
        TOE_OF_FORCE,
        {"test": "bounce", "quantity": "right.camber", "value": "0 deg/m", "over": "20 mm"},
        {"test": "bounce", "quantity": "toe", "value": 0.0, "over": ["-60 mm", "60 mm"]},
        {"test": "braking", "quantity": "toe", "value": 0.0, "at": {"travel": "10 mm"}},
    ]
    search = read_task(rig, free, targets).search()
    assert [item.unit for item in search.wanted] == ["rad/N", "rad/m", "rad/m", "rad/N"]
    values, along = search.evaluator.together(search.numbers(np.zeros(2)))
    runs = [
        (jn.kc_test(rig, "lateral-in-phase"), "left.toe", "1 kN"),
        (jn.kc_test(rig, "bounce"), "right.camber", "20 mm"),
        (jn.kc_test(rig, "bounce", to="60 mm"), "left.toe", "60 mm"),
        (jn.kc_test(rig, "braking", travel="10 mm"), "left.toe", ("0 N", "1 kN")),
    ]
    for value, (run, name, within) in zip(values, runs, strict=True):
        want = jn.kc_slopes(run, within=within).set_index(quantity="quantity")["slope"]
        assert value == pytest.approx(float(want.sel(quantity=name)), rel=1e-9)
    for j, step in enumerate(1e-3 * np.eye(2)):
        ends = [
            search.evaluator.together(search.numbers(sign * step), slopes=False)[0]
            for sign in (1.0, -1.0)
        ]
        want = (ends[0] - ends[1]) / 2e-3
        allowed = 5e-3 * np.abs(want) + np.array([1e-12, 1e-8, 1e-8, 1e-12])  # friction slips
        assert np.all(np.abs(along[:, j] * search.scale[j] - want) <= allowed), (j, want)


def test_a_stiffness_and_a_point_meet_targets_of_force_and_of_travel() -> None:
    rig = jn.load("double-wishbone-elastic")
    free = {
        "hardpoints.tie_rod_inner[2]": "15 mm",
        "hardpoints.tie_rod_inner[0]": "40 mm",
        "bushings.lower_arm_rear.stiffness[1]": "2 kN/mm",
    }
    targets = [
        {"quantity": "bump_steer", "value": "0 deg/m", "tolerance": "0.1 deg/m"},
        {**TOE_OF_FORCE, "value": "-0.045 deg/kN", "tolerance": "0.001 deg/kN"},
    ]
    design = jn.design_kinematics(rig, free, targets, starts=1)
    assert design.met
    run = jn.kc_test(design.rig, "lateral-in-phase")
    line = jn.kc_slopes(run, within="1 kN").set_index(quantity="quantity")["slope"]
    assert np.degrees(1e3 * float(line.sel(quantity="left.toe"))) == pytest.approx(-0.045, abs=1e-3)
    assert design.targets[1].label == "lateral-in-phase: left.toe"
    assert design.targets[1].pose(0) == "-1000 … 1000 N"
    assert "lateral-in-phase" in design.curve_table()


def test_a_twist_beam_is_designed_to_its_roll_steer() -> None:
    """Free: the height of its pivots, within the room that a floor leaves."""
    target = {"test": "roll", "quantity": "steer", "value": -0.05, "tolerance": 0.001}
    design = jn.design_kinematics(jn.load("twist-beam"), {"hardpoints.pivot[2]": "40 mm"}, [target])
    assert design.met
    run = jn.kc_test(design.rig, "roll")
    line = jn.kc_slopes(run, within=float(design.targets[0].at[1])).set_index(quantity="quantity")
    assert float(line["slope"].sel(quantity="left.steer")) == pytest.approx(-0.05, abs=1e-3)
    assert design.moved["hardpoints.pivot[2]"].after > 0.31
    titles = [section.title for section in kinematic_design_page(design, title="x").sections]
    assert "Targets" in titles
    assert "Geometry" not in titles  # it has no centres to draw


def test_stiffnesses_of_bushings_spread_rows_of_the_sheet() -> None:
    """The variance follows from exact slopes: each bushing has one deviation for all its directions."""
    rig = jn.load("mcpherson-elastic").with_changes({"strut.friction": {"force": 0.0}})
    row = {"test": "aligning-in-phase", "quantity": "toe", "value": 0.0}
    made = jn.kinematic_spread(rig, [row], {"stiffnesses": 0.15, "cars": 60})
    (target,) = made.targets
    assert target.quantity == "aligning-in-phase left.toe"
    names = [name for name in target.causes if name.startswith(("bushings.", "links."))]
    rows = jn.kc_sensitivities(rig, "aligning-in-phase", names, quantities=["left.toe"])
    x = rows["input"].values
    inside = np.abs(x) <= x.max() / 2
    variance = 0.0
    for name in names:
        change = 0.0
        for path in map(str, rows["parameter"].values):
            if path.startswith(f"{name}.") and "stiffness" in path:
                slopes = rows["sensitivity"].sel(parameter=path).values[0]
                slope = np.polyfit(x[inside], slopes[inside], 1)[0]
                change += slope * rig.parameters()[path]
        variance += (0.075 * change) ** 2
    width = (target.high[0] - target.low[0]) / 3.92  # of a normal distribution, from 60 cars
    assert width == pytest.approx(np.sqrt(variance), rel=0.35)
    with pytest.raises(DescriptionError, match="no stiffnesses"):
        jn.kinematic_spread(jn.load("generic-mcpherson"), [row], {"stiffnesses": 0.15})


@pytest.mark.parametrize(
    ("rig", "free", "target", "said"),
    [
        (
            ELASTIC,
            {STIFFNESS: "0.1 kN/mm"},
            {**TOE_OF_FORCE, "test": "lateral"},
            "lateral-in-phase",
        ),
        (ELASTIC, {STIFFNESS: "0.1 kN/mm"}, {**TOE_OF_FORCE, "quantity": "toee"}, "toe"),
        (ELASTIC, {STIFFNESS: "0.1 kN/mm"}, {**TOE_OF_FORCE, "value": "0 deg/mm"}, "rad/N"),
        (ELASTIC, {STIFFNESS: "0.1 kN/mm"}, {**TOE_OF_FORCE, "over": "20 mm"}, "over"),
        (ELASTIC, {STIFFNESS: "0.1 kN/mm"}, {**TOE_OF_FORCE, "over": ["1 kN", "0 N"]}, "over"),
        (ELASTIC, {STIFFNESS: "0.1 kN/mm"}, {**TOE_OF_FORCE, "over": "1 N"}, "two inputs"),
        (ELASTIC, {STIFFNESS: "0.1 kN/mm"}, {**TOE_OF_FORCE, "along": "rack"}, "along"),
        (ELASTIC, {STIFFNESS: "0.1 kN/mm"}, {**TOE_OF_FORCE, "at": {"roll": "1 deg"}}, "travel"),
        (ELASTIC, {STIFFNESS: "0.1 kN/mm"}, {"quantity": "toe", "value": 0.0}, "does not enter"),
        (ELASTIC, {"bushings.lower_arm_reer.stiffness[0]": 1e5}, TOE_OF_FORCE, "lower_arm_rear"),
        (
            "twist-beam",
            {"hardpoints.pivot[2]": "9 mm"},
            {"quantity": "toe", "value": 0.0},
            "test =",
        ),
        (
            "twist-beam",
            {"hardpoints.pivot[2]": "9 mm"},
            {"test": "steer", "quantity": "toe", "value": 0.0},
            "rack",
        ),
        (
            ELASTIC,
            {STIFFNESS: "0.1 kN/mm"},
            {"test": "steer", "quantity": "handwheel_angle", "value": 0.0},
            "handwheel",
        ),
        (
            "twist-beam",
            {"hardpoints.damper_top[2]": "9 mm"},
            {"test": "roll", "quantity": "steer", "value": 0.0},
            "does not enter",
        ),
    ],
)
def test_refused(rig: str, free: dict[str, Any], target: dict[str, Any], said: str) -> None:
    with pytest.raises((DescriptionError, ValueError), match=r"(?s).*" + said):
        jn.design_kinematics(jn.load(rig), free, [target], starts=1)
