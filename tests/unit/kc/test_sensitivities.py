"""Slopes of K&C tests by hardpoints and stiffnesses against central differences of the tests themselves."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.kc.sensitivities import kc_parameters
from jounce.kc.tests import TESTS

SOFT = {
    "stiffness": ["8 kN/mm", "6 kN/mm", "3 kN/mm"],
    "rotational_stiffness": ["10 N*m/deg"] * 3,
}
PLACES = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "tie_rod_outer", "strut_top")
PARAMETERS = (
    "hardpoints.lower_ball_joint[0]",
    "hardpoints.tie_rod_inner[2]",
    "hardpoints.strut_bottom[1]",
    "hardpoints.wheel_centre[2]",
    "bushings.lower_arm_rear.stiffness[1]",
    "strut.spring.rate",
    "wheel.camber",
)
SIZES = {"rad": 1e-9, "m": 1e-10, "N": 1e-3, "N*m": 1e-4}
"""Change of a quantity by a usual change of a parameter that matters to nobody."""


def double_wishbone(**bushing: object) -> jn.Rig:
    rig = jn.load("reference-double-wishbone")
    changes = {"bushings": dict.fromkeys(PLACES, SOFT | bushing)}
    return rig.with_changes(changes | {"links": {"tie_rod": {"stiffness": "50 kN/mm"}}})


def with_value(rig: jn.Rig, path: str, value: float) -> jn.Rig:
    return rig.with_changes({path: float(value)})


def check(rig: jn.Rig, test: str, parameters: tuple[str, ...], **options: object) -> None:
    """Compare with central differences, relative to the largest change of each quantity."""
    rows = jn.kc_sensitivities(rig, test, parameters, **options)
    for path in parameters:
        value = rig.parameters()[path]
        usual = 1e-3 if "hardpoints" in path or "wheel" in path else 0.1 * abs(value)
        step = 0.02 * usual
        own = {key: item for key, item in options.items() if key != "quantities"}
        ends = [jn.kc_test(with_value(rig, path, value + s * step), test, **own) for s in (1, -1)]
        for name, unit in zip(rows["quantity"].values, rows["unit"].values, strict=True):
            want = (ends[0][name].values - ends[1][name].values) / (2.0 * step)
            exact = rows["sensitivity"].sel(quantity=name, parameter=path).values
            allowed = 2e-4 * np.abs(want).max() + SIZES[unit] / usual
            assert exact == pytest.approx(want, abs=allowed), (name, path)


@pytest.mark.parametrize("test", TESTS)
@pytest.mark.some(3)
def test_every_test_of_a_double_wishbone_on_bushings(test: str) -> None:
    check(double_wishbone(), test, PARAMETERS, points=9)


@pytest.mark.parametrize(
    ("test", "options"),
    [
        ("lateral-left", {"held": "height"}),
        ("aligning-in-phase", {"handwheel": "free"}),
        ("lateral-in-phase", {"travel": "20 mm", "steer": "25 mm", "trail": "60 mm"}),
        ("bounce", {"quantities": ("left.tie_rod_outer.force_y", "right.strut_top.torque_x")}),
    ],
)
def test_options_of_a_test_count(test: str, options: dict) -> None:
    check(double_wishbone(), test, PARAMETERS[:4], points=9, **options)


@pytest.mark.parametrize(
    ("name", "test", "parameters"),
    [
        (
            "solid-axle",
            "lateral-in-phase",
            ("hardpoints.wheel_centre[2]", "hardpoints.strut_top[1]"),
        ),
        ("twist-beam", "roll", ("hardpoints.wheel_centre[0]", "beam.torsional_stiffness")),
        ("generic-mcpherson", "lateral-opposed", ("hardpoints.strut_top[1]", "strut.spring.rate")),
        ("sedan-multi-link", "roll", ("hardpoints.link_3_outer[2]", "hardpoints.wheel_centre[1]")),
        ("semi-trailing-arm", "bounce", ("hardpoints.arm_inner[0]", "strut.spring.rate")),
        (
            "formula-student-front",
            "roll",
            ("hardpoints.pushrod_inner[2]", "hardpoints.rocker_axis[0]", "strut.spring.preload"),
        ),
    ],
)
def test_other_suspensions(name: str, test: str, parameters: tuple[str, ...]) -> None:
    check(jn.load(name), test, parameters, points=9)


def test_friction_of_an_axle_with_all_compliance() -> None:
    """Exact where the solver does not halve a step; a rack on a soft housing is measured in it."""
    parameters = ("anti_roll_bar.stiffness", "hardpoints.arb_arm_end[0]")
    rig = jn.load("mcpherson-elastic")
    check(rig, "roll", parameters, points=17)


@pytest.mark.parametrize("is_soft", [False, True], ids=["stiff column", "soft column"])
def test_angle_and_torque_of_the_handwheel_have_slopes(is_soft: bool) -> None:
    column = {"handwheel": [-600, 350, 900], "upper_joint": [-300, 350, 700]}
    column |= {"lower_joint": [-150, 330, 450], "pinion": [-100, 200, 300]}
    steering = {
        "rack_ratio": "8 mm/rad",
        "column": {k: [1e-3 * x for x in v] for k, v in column.items()},
    }
    parameters = PARAMETERS[:2]
    if is_soft:
        steering |= {"column_stiffness": "2 N*m/deg", "assistance": 3.0}
        parameters += ("steering.rack_ratio", "steering.assistance", "steering.column_stiffness")
    rig = double_wishbone().with_changes({"steering": steering})
    for test in ("steer", "lateral-in-phase"):
        rows = jn.kc_sensitivities(rig, test, parameters, points=9)
        assert {"handwheel_angle", "handwheel_torque"} <= {*rows["quantity"].values}
        check(rig, test, parameters, points=9)


def test_curves_of_bushings_count() -> None:
    table = {"kind": "table", "deflection": ["-1 mm", "-0.2 mm", "0 mm", "0.2 mm", "1 mm"]}
    table |= {"force": ["-9 kN", "-1 kN", "0 N", "1 kN", "9 kN"]}
    cubic = {"kind": "polynomial", "coefficients": [4e6, 0.0, 3e12]}
    rig = double_wishbone(curves={"x": table, "y": cubic})
    quantities = ("left.toe", "left.lower_arm_front.force_x", "left.lower_arm_front.force_y")
    check(rig, "braking", PARAMETERS[:2], points=9, quantities=quantities, to="800 N")


@pytest.mark.parametrize("test", ["lateral-in-phase", "bounce"])
def test_friction_keeps_what_slipped(test: str) -> None:
    rig = double_wishbone(friction=["60 N", "60 N", "60 N"])
    rig = rig.with_changes({"strut.friction": {"force": "40 N"}})
    check(rig, test, PARAMETERS, points=13)


def test_slopes_of_the_fitted_line() -> None:
    rig, path = double_wishbone(), "hardpoints.tie_rod_inner[2]"
    rows = jn.kc_sensitivities(rig, "bounce", [path])
    ends = [
        jn.kc_slopes(jn.kc_test(with_value(rig, path, rig.parameters()[path] + s * 1e-5), "bounce"))
        for s in (1, -1)
    ]
    for name in ("left.toe", "right.camber", "left.vertical_force"):
        want = (ends[0]["slope"] - ends[1]["slope"]).sel(quantity=name) / 2e-5
        exact = rows["slope_sensitivity"].sel(quantity=name, parameter=path)
        assert float(exact) == pytest.approx(float(want), rel=1e-5)
        line = jn.kc_slopes(jn.kc_test(rig, "bounce"))["slope"].sel(quantity=name)
        assert float(rows["slope"].sel(quantity=name)) == pytest.approx(float(line), rel=1e-9)


def test_all_tests_and_parameters_come_with_units() -> None:
    rig = double_wishbone()
    rows = jn.kc_sensitivities(rig, points=9)
    assert list(rows["test"].values) == list(TESTS)
    assert tuple(rows["parameter"].values) == kc_parameters(rig)
    assert "links.tie_rod.stiffness" in rows["parameter"]
    assert rows["parameter_unit"].sel(parameter="strut.spring.rate").item() == "N/m"
    assert rows["slope_unit"].sel(test="bounce", quantity="left.toe").item() == "rad/m"
    assert np.isfinite(rows["sensitivity"]).all()
    toe = rows["slope_sensitivity"].sel(test="lateral-in-phase", quantity="left.toe")
    assert float(np.abs(toe).max()) > 0.0


def test_a_whole_point_stands_for_its_coordinates() -> None:
    rows = jn.kc_sensitivities(jn.load("generic-mcpherson"), "bounce", ["hardpoints.tie_rod_inner"])
    assert [p[-3:] for p in rows["parameter"].values] == ["[0]", "[1]", "[2]"]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"parameters": ["hardpoints.tie_rod"]}, "unknown parameter of the axle"),
        ({"parameters": ["sprung.mass"]}, "unknown parameter of the axle"),
        ({"quantities": ["left.toes"]}, "unknown quantity"),
        ({"tests": "lateral"}, "unknown test"),
    ],
)
def test_unknown_names_are_refused(options: dict, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        jn.kc_sensitivities(jn.load("generic-mcpherson"), **({"tests": "bounce"} | options))


def test_a_stiffness_that_a_curve_replaces_is_no_parameter() -> None:
    rig = jn.load("double-wishbone-elastic")
    curves = rig.bushings.lower_arm_rear.curves
    assert curves.x is not None
    assert curves.y is None
    own = [path for path in kc_parameters(rig) if path.startswith("bushings.lower_arm_rear.stiff")]
    assert own == [f"bushings.lower_arm_rear.stiffness[{k}]" for k in (1, 2)]
