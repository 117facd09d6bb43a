from __future__ import annotations

import re

import numpy as np
import pytest

import jounce as jn
from jounce.core.units import to_si
from jounce.kinematics import CATALOGUE
from jounce.kinematics.model import kinematic_model

SI = {"m", "s", "kg", "rad", "N", "J", "W", "Pa", "Hz"}

STEERED = {"rack", "rack strut"}
SOME_HAVE = {"bar", "torsion", "third", "third damper", "heave", "rocker", "rocker strut"}


@pytest.mark.parametrize("row", CATALOGUE, ids=lambda row: row.name)
def test_every_row_says_what_it_is(row) -> None:
    assert re.fullmatch(r"[a-z]+(_[a-z]+)*", row.name)
    assert to_si(f"1 {row.unit}" if row.unit != "1" else 1.0, row.unit) == 1.0
    assert set(re.findall("[A-Za-z]+", row.unit)) <= SI
    assert row.long_name
    assert row.sign.startswith(("positive: ", "never negative"))
    assert (
        row.needs
        in {"", "axis", "strut", "spring", "damper", "tyre", "stiffness", "coil"}
        | STEERED
        | SOME_HAVE
    )


def test_names_are_unique() -> None:
    assert len({row.name for row in CATALOGUE}) == len(CATALOGUE)


def test_rows_that_a_corner_cannot_have_are_absent() -> None:
    names = {row.name for row in CATALOGUE}
    full = {row.name for row in kinematic_model(jn.load("reference-double-wishbone")).rows}
    assert names - full == {row.name for row in CATALOGUE if row.needs in SOME_HAVE}
    arm = {row.name for row in kinematic_model(jn.load("semi-trailing-arm")).rows}
    assert names - arm == {
        row.name for row in CATALOGUE if row.needs in SOME_HAVE | STEERED | {"axis"}
    }


def test_a_curved_tyre_has_its_slope_at_the_deflection_given() -> None:
    curve = {"kind": "polynomial", "coefficients": [150e3, 4e6]}
    rig = jn.load("reference-double-wishbone")
    table = {"curve": curve, "undeformed_radius": 0.31}
    found = jn.sweep_travel(rig.with_changes({"tyre": table}), 0.0)
    tyre, wheel = 150e3 + 2.0 * 4e6 * 0.01, float(found["wheel_rate"][0])
    assert float(found["tyre_deflection"][0]) == pytest.approx(0.01)
    assert float(found["ride_rate"][0]) == pytest.approx(wheel * tyre / (wheel + tyre), rel=1e-12)
    unknown = jn.sweep_travel(rig.with_changes({"tyre": {"curve": curve}}), 0.0)
    assert "ride_rate" not in unknown


def test_corners_that_differ_in_numbers_share_a_model() -> None:
    rig = jn.load("reference-double-wishbone")
    model = kinematic_model(rig)
    assert (
        kinematic_model(rig.with_changes({"strut.spring.rate": 30e3, "wheel.camber": -0.01}))
        is model
    )
    assert kinematic_model(jn.load("generic-mcpherson")) is not model


def test_a_lumped_rig_has_no_kinematics() -> None:
    with pytest.raises(jn.DescriptionError, match="a lumped rig has no kinematics") as caught:
        jn.sweep_travel(jn.load("kart-quarter-car"), 0.0)
    assert "double-wishbone" in str(caught.value)


def test_bushings_count_as_ideal_joints() -> None:
    rig = jn.load("reference-double-wishbone")
    soft = rig.with_changes({"bushings": {"lower_arm_front": {"stiffness": [1e6, 1e6, 1e5]}}})
    rigid, found = (
        jn.sweep_travel(rig, [-0.02, 0.0, 0.02]),
        jn.sweep_travel(soft, [-0.02, 0.0, 0.02]),
    )
    assert found["steer"].to_numpy() == pytest.approx(rigid["steer"].to_numpy(), abs=1e-13)


def test_swing_arms_reach_from_the_contact_point_to_the_instant_centres() -> None:
    found = jn.sweep_travel(jn.load("reference-double-wishbone"), [-0.02, 0.0, 0.02])
    inboard = found["contact_point_y"] - found["instant_centre_y"]
    ahead = found["side_instant_centre_x"] - found["contact_point_x"]
    assert found["front_view_swing_arm_length"].values == pytest.approx(inboard.values, rel=1e-12)
    assert found["side_view_swing_arm_length"].values == pytest.approx(ahead.values, rel=1e-12)
    assert (inboard > 0.0).all()


def test_the_swing_arm_of_a_trailing_arm_is_positive() -> None:
    arm = jn.sweep_travel(jn.load("semi-trailing-arm"), 0.0)  # its pivot lies ahead of the wheel
    assert float(arm["side_view_swing_arm_length"][0]) > 0.0


def test_masses_do_not_matter() -> None:
    rig = jn.load("reference-double-wishbone")
    model = kinematic_model(rig)
    assert not [
        path for path in model.parameters if path.startswith(("bodies.", "sprung.", "gravity"))
    ]
    heavy = rig.with_changes({"bodies.upright.mass": 900.0, "bodies.lower_arm.mass": 0.01})
    one, other = (jn.sweep_travel(item, [-0.05, 0.05]) for item in (rig, heavy))
    assert all(np.array_equal(one[name], other[name]) for name in one.data_vars)
