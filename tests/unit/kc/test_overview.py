"""Overview of a K&C sheet: closed forms of its rows, roll centres of forces and of kinematics, ranges, units."""

from __future__ import annotations

import csv

import numpy as np
import pytest

import jounce as jn
from jounce.core.display import local_units
from jounce.core.errors import DescriptionError
from jounce.kc.overview import fitted_range, usual_unit
from jounce.kc.tests import TESTS

_SOFT = {
    "stiffness": ["8 kN/mm", "6 kN/mm", "3 kN/mm"],
    "rotational_stiffness": ["10 N*m/deg"] * 3,
}
_POINTS = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "lower_ball_joint")
IDEAL = ("generic-mcpherson", "reference-double-wishbone", "sedan-multi-link", "semi-trailing-arm")


def soft() -> jn.Rig:
    bushings = {"bushings": dict.fromkeys(_POINTS, _SOFT)}
    return jn.load("reference-double-wishbone").with_changes(bushings)


@pytest.mark.parametrize("travel", [0.0, 0.02])
@pytest.mark.parametrize("name", IDEAL)
def test_roll_centre_and_support_angles_of_ideal_joints_are_those_of_kinematics(
    name, travel
) -> None:
    rig = jn.load(name)
    centres = jn.kc_centres(rig, travel=travel).sel(source="forces")
    bounce = jn.kc_test(rig, "bounce", to=0.02, points=5)
    at = int(np.argmax(bounce["input"].values)) if travel else 0
    lifted = float(bounce["left.wheel_centre_z"][at])
    pose = jn.sweep_axle(rig, left_travel=lifted, right_travel=lifted).isel(pose=0)
    assert float(centres["roll_centre_height"]) == pytest.approx(
        float(pose["roll_centre_height"]), abs=1e-9
    )
    for test, slope, sign in (
        ("braking", "contact_patch_recession", 1.0),
        ("braking-inboard", "wheel_centre_recession", 1.0),
        ("driving", "wheel_centre_recession", -1.0),
        ("driving-hub", "contact_patch_recession", -1.0),
    ):
        want = sign * np.arctan(float(pose[f"left.{slope}"]))
        assert float(centres[test]) == pytest.approx(want, abs=1e-9)


def test_bushings_move_the_centres_of_forces_only() -> None:
    centres = jn.kc_centres(soft())
    ideal = jn.kc_centres(jn.load("reference-double-wishbone"))
    forces, kinematics = centres["roll_centre_height"].values
    assert kinematics == pytest.approx(float(ideal["roll_centre_height"][0]), abs=1e-12)
    assert abs(forces - kinematics) > 1e-3


@pytest.fixture(scope="module")
def tests():
    return jn.kc_tests(soft())


def test_rows_are_the_slopes_of_the_curves(tests) -> None:
    overview = jn.kc_overview(tests, within={"bounce": "20 mm", "braking": "1500 N"})
    assert list(dict.fromkeys(row.test for row in overview)) == list(TESTS)
    fit = jn.kc_slopes(tests["bounce"], within="20 mm").set_index(quantity="quantity")
    row = overview.row("bounce", "ride_camber")
    assert row.left == float(fit["slope"].sel(quantity="left.camber"))
    assert (row.low, row.high) == (-0.02, 0.02)
    assert row.nonlinearity >= float(fit["nonlinearity"].sel(quantity="left.camber"))
    braking = overview.row("braking", "wind_up")
    assert (braking.low, braking.high) == (0.0, 1500.0)
    assert braking.usual().name == "deg/kN"
    text = str(overview)
    assert "deg/kN" in text
    assert "roll stiffness" in text


def test_stiffness_in_roll_follows_from_the_wheel_rates(tests) -> None:
    """Without an anti-roll bar, the moment is that of two wheel rates on half the track, for small angles."""
    rig = jn.load("reference-double-wishbone")
    ends = {"bounce": "1 mm", "roll": "0.1 deg"}
    overview = jn.kc_overview({name: jn.kc_test(rig, name, to=to) for name, to in ends.items()})
    rate, track = overview.row("bounce", "wheel_rate").left, 1.52
    want = 0.5 * track**2 * rate
    assert overview.row("roll", "roll_stiffness").axle == pytest.approx(want, rel=2e-3)
    body, ground = (overview.row("roll", f"roll_camber{name}") for name in ("", "_ground"))
    assert ground.left - body.left == pytest.approx(1.0, abs=1e-9)
    assert ground.right - body.right == pytest.approx(-1.0, abs=1e-9)


def test_steering_has_a_ratio_where_the_rack_has_one() -> None:
    rig = jn.load("formula-student-front").with_changes({"steering": {"rack_ratio": "13 mm/rad"}})
    tests = jn.kc_tests(rig, ("steer",), to="2 mm")
    row = jn.kc_overview(tests).row("steer", "steering_ratio")
    gain = jn.sweep_steering(rig, [-1e-4, 0.0, 1e-4])["steering_ratio"].values[1]
    assert row.axle == pytest.approx(float(gain), rel=1e-3)
    bare = jn.kc_overview(jn.kc_tests(jn.load("formula-student-front"), ("steer",), to="2 mm"))
    with pytest.raises(DescriptionError, match="steering_ratio"):
        bare.row("steer", "steering_ratio")


def test_the_table_has_usual_units_and_si(tests) -> None:
    overview = jn.kc_overview(tests, jn.kc_centres(soft()))
    rows = list(csv.DictReader(overview.table().splitlines()))
    assert len(rows) == len(overview)
    row = next(row for row in rows if row["key"] == "roll_centre_height")
    assert float(row["axle"]) == pytest.approx(1e3 * float(row["axle [SI]"]))
    assert float(row["kinematic [SI]"]) == pytest.approx(0.0789, abs=1e-4)
    with local_units("imperial"):
        assert overview.row("bounce", "wheel_rate").usual().name == "lbf/in"


def test_units_of_slopes() -> None:
    assert usual_unit("rad", "N*m").name == "deg/(100 N·m)"
    assert usual_unit("rad", "N*m").factor == pytest.approx(100.0 * 180.0 / np.pi)
    assert usual_unit("m", "N").factor == pytest.approx(1e6)


def test_ranges_are_checked(tests) -> None:
    assert fitted_range(tests["braking"]) == (0.0, 1000.0)
    assert fitted_range(tests["roll"], ("-1 deg", "2 deg")) == pytest.approx(
        (-np.pi / 180.0, np.pi / 90.0)
    )
    with pytest.raises(DescriptionError, match="bonce"):
        jn.kc_overview(tests, within={"bonce": "20 mm"})
    with pytest.raises(DescriptionError, match="fewer than two inputs"):
        jn.kc_overview(tests, within={"bounce": "1 um"})
