"""The regression table of a double wishbone: every printed value, to half a unit of its last digit.

The table was computed once from the stated hardpoints with velocities of the contact patch, fixed to the upright;
``tests/twins/corner_kinematics_twin.py`` reproduces it independently. Its wheel rate and the change of its motion ratio
are those at the contact point: k MR(C)^2 and d MR(C) / dz(C).
"""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

pytestmark = pytest.mark.source(
    kind="computed",
    of="suspension kinematics",
    where="a double wishbone; velocities of the contact patch beside jounce",
    tolerance="half a unit of the last printed digit",
)

RIG = jn.load("reference-double-wishbone")
DEG, MM = np.pi / 180.0, 1e-3
# name -> (unit of the table, values at -40, 0, +40 mm of wheel-centre travel, half a unit of the last printed digit)
TABLE = {
    "camber": (DEG, (0.0204, -1.0, -2.3572), 0.5e-4),
    "steer": (DEG, (-0.0223, 0.0, -0.2112), 0.5e-4),
    "caster": (DEG, (3.9700, 4.3987, 4.8273), 0.5e-4),
    "kingpin_inclination": (DEG, (5.5571, 6.5819, 7.9247), 0.5e-4),
    "caster_trail": (MM, (13.573, 15.766, 17.618), 0.5e-3),
    "scrub_radius": (MM, (29.048, 29.087, 29.229), 0.5e-3),
    "contact_point_y": (MM, (759.053, 765.236, 767.407), 0.5e-3),
    "roll_centre_height": (MM, (157.15, 78.918, 4.385), (0.5e-2, 0.5e-3, 0.5e-3)),
    "spring_length": (MM, (416.737, 389.102, 360.795), 0.5e-3),
}
# name -> (unit, value at design, half a unit of the last printed digit)
AT_DESIGN = {
    "instant_centre_y": (MM, -1182.70, 0.5e-2),
    "instant_centre_z": (MM, 200.935, 0.5e-3),
    "contact_point_z": (MM, 0.0457, 0.5e-4),
    "contact_patch_recession": (1.0, -0.005843, 0.5e-6),
    "wheel_centre_longitudinal_slope": (1.0, -0.05928, 0.5e-5),
    "camber_gain": (DEG / MM, -0.0294928, 0.5e-7),
    "bump_steer": (DEG / MM, -0.0023553, 0.5e-7),
    "motion_ratio": (1.0, 0.698500, 0.5e-6),
    "motion_ratio_contact": (1.0, 0.696622, 0.5e-6),
    "motion_ratio_contact_gradient": (1.0 / MM, 3.4886e-4, 0.5e-8),
}


@pytest.fixture(scope="module")
def sweep():
    return jn.sweep_travel(RIG, [-0.04, 0.0, 0.04])


@pytest.mark.parametrize("name", TABLE)
def test_table_holds_to_its_printed_digits(sweep, name: str) -> None:
    unit, values, half = TABLE[name]
    for found, value, room in zip(
        sweep[name].to_numpy() / unit, values, np.broadcast_to(half, 3), strict=True
    ):
        assert found == pytest.approx(value, abs=room * 1.000001)


@pytest.mark.parametrize("name", AT_DESIGN)
def test_values_at_design_hold_to_their_printed_digits(sweep, name: str) -> None:
    unit, value, half = AT_DESIGN[name]
    assert float(sweep[name][1]) / unit == pytest.approx(value, abs=half * 1.000001)


def test_instant_centre_above_the_contact_point(sweep) -> None:
    height = float(sweep["instant_centre_z"][1] - sweep["contact_point_z"][1])
    assert height / MM == pytest.approx(200.889, abs=0.5e-3)


def test_wheel_rate_and_its_preload_term() -> None:
    """k = 40 N/mm and a spring force of 4000 N / MR(C) at design."""
    ratio = float(jn.sweep_travel(RIG, 0.0)["motion_ratio_contact"][0])
    rig = RIG.with_changes({"strut.spring.rate": 40e3, "strut.spring.preload": 4000.0 / ratio})
    found = jn.sweep_travel(rig, 0.0)
    spring = float(found["wheel_rate_contact_spring"][0])
    assert spring * MM == pytest.approx(19.411, abs=0.5e-3)
    assert (float(found["wheel_rate_contact"][0]) - spring) * MM == pytest.approx(2.003, abs=0.5e-3)


@pytest.mark.no_source
def test_planar_construction_is_not_good_enough(sweep) -> None:
    """Arm planes met with the plane through the contact point give 78.13 mm, 1 % low: the table tells the two apart."""
    assert float(sweep["roll_centre_height"][1]) / MM - 78.13 > 0.7
