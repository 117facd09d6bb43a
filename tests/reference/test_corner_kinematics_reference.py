"""The readable twin of the corner kinematics against the published table of a double wishbone, to its printed digits.

The table (millimetres, degrees, wheel travel from the design position) was computed with yet another program: upright
pose by Newton's method on five rod lengths, velocities from the rod equations. Its numbers are the reference of the
kinematic sweeps, too.
"""

from __future__ import annotations

import corner_kinematics_twin as twin
import numpy as np
import pytest

pytestmark = pytest.mark.source(
    kind="computed",
    of="suspension kinematics",
    where="a double wishbone; Newton steps on five rod lengths beside jounce (held: the readable twin)",
    tolerance="half a unit of the last printed digit",
)

MILLIMETRES = {
    "lower_arm_front": (150, 400, 155),
    "lower_arm_rear": (-150, 400, 145),
    "lower_ball_joint": (5, 720, 140),
    "upper_arm_front": (110, 450, 385),
    "upper_arm_rear": (-130, 450, 365),
    "upper_ball_joint": (-15, 690, 400),
    "tie_rod_inner": (-130, 380, 185),
    "tie_rod_outer": (-120, 700, 180),
    "wheel_centre": (0, 760, 300),
    "strut_bottom": (0, 640, 150),
    "strut_top": (10, 520, 520),
}
HARDPOINTS = {name: tuple(x / 1000.0 for x in point) for name, point in MILLIMETRES.items()}
# travel: camber, steer, caster, kingpin inclination, caster trail, scrub radius, contact y, roll centre height, spring
TABLE = {
    -40: ".0204 -.0223 3.9700 5.5571 13.573 29.048 759.053 157.15 416.737",
    0: "-1.0000 0.0000 4.3987 6.5819 15.766 29.087 765.236 78.918 389.102",
    40: "-2.3572 -.2112 4.8273 7.9247 17.618 29.229 767.407 4.385 360.795",
}
DEGREE, MM = np.pi / 180.0, 1e-3


@pytest.fixture(scope="module")
def corner():
    return twin.double_wishbone(HARDPOINTS, radius=0.3, camber=-1.0 * DEGREE)


def printed(text: str) -> tuple[float, float]:
    """A printed number and half of its last digit."""
    return float(text), 0.5 * 10.0 ** -len(text.partition(".")[2])


@pytest.mark.parametrize("travel", TABLE)
def test_table_to_its_printed_digits(corner, travel: int) -> None:
    got = corner.quantities(travel * MM)
    angles = [got[name] / DEGREE for name in ("camber", "steer", "caster", "kingpin_inclination")]
    lengths = [got[name] / MM for name in ("caster_trail", "scrub_radius")]
    lengths += [
        got["contact_point"][1] / MM,
        got["roll_centre_height"] / MM,
        got["spring_length"] / MM,
    ]
    for value, text in zip([*angles, *lengths], TABLE[travel].split(), strict=True):
        expected, half_digit = printed(text)
        assert value == pytest.approx(expected, abs=half_digit * 1.01)


def test_instant_centres_and_rates_at_design(corner) -> None:
    got = corner.quantities(0.0, spring_rate=40e3, spring_force=4000.0 / 0.696622)
    expected = {
        "front_instant_centre_y": ("-1182.70", MM),
        "front_instant_centre_z": ("200.935", MM),
        "contact_dx_dz": ("-.005843", 1.0),
        "wheel_centre_dx_dz": ("-.05928", 1.0),
        "camber_gain": ("-.0294928", DEGREE / MM),
        "bump_steer": ("-.0023553", DEGREE / MM),
        "motion_ratio": (".698500", 1.0),
        "motion_ratio_contact": (".696622", 1.0),
        # printed 3.4886e-4 per mm without saying of what: ratio and height are those of the contact point
        "motion_ratio_gradient_contact": (".34886", 1.0),
        "wheel_rate_spring_contact": ("19.411", 1e3),
    }
    for name, (text, unit) in expected.items():
        value, half_digit = printed(text)
        assert got[name] / unit == pytest.approx(value, abs=half_digit * 1.01), name
    preload_term = got["wheel_rate_contact"] - got["wheel_rate_spring_contact"]
    assert preload_term == pytest.approx(2003.0, abs=0.5)
    assert got["contact_point"][2] / MM == pytest.approx(0.0457, abs=5e-5)


def variants():
    mcpherson = {
        "lower_arm_front": (0.15, 0.35, 0.18),
        "lower_arm_rear": (-0.2, 0.37, 0.19),
        "lower_ball_joint": (0.01, 0.7, 0.16),
        "tie_rod_inner": (-0.13, 0.34, 0.22),
        "tie_rod_outer": (-0.14, 0.68, 0.21),
        "wheel_centre": (0.0, 0.75, 0.31),
        "strut_bottom": (0.0, 0.64, 0.38),
        "strut_top": (-0.02, 0.56, 0.85),
    }
    five = {
        "wheel_centre": (0.0, 0.75, 0.31),
        "strut_bottom": (-0.06, 0.64, 0.2),
        "strut_top": (-0.05, 0.56, 0.65),
    }
    ends = [
        ((0.15, 0.35, 0.18), (0.03, 0.7, 0.17)),
        ((-0.2, 0.37, 0.19), (-0.02, 0.705, 0.165)),
        ((0.14, 0.42, 0.42), (0.02, 0.68, 0.43)),
        ((-0.13, 0.43, 0.41), (-0.03, 0.685, 0.425)),
        ((-0.15, 0.34, 0.25), (-0.16, 0.68, 0.25)),
    ]
    for i, (inner, outer) in enumerate(ends, start=1):
        five |= {f"link_{i}_inner": inner, f"link_{i}_outer": outer}
    arm = {
        "arm_inner": (0.45, 0.3, 0.32),
        "arm_outer": (0.42, 0.65, 0.31),
        "wheel_centre": (0.0, 0.72, 0.3),
        "strut_bottom": (-0.03, 0.6, 0.22),
        "strut_top": (-0.01, 0.58, 0.6),
    }
    return {
        "double wishbone": twin.double_wishbone(HARDPOINTS, 0.3, -0.02, 0.003),
        "mcpherson": twin.mcpherson(mcpherson, 0.31, -0.01, 0.002),
        "five link": twin.five_link(five, 0.31, -0.01, 0.002),
        "trailing arm": twin.trailing_arm(arm, 0.3, -0.01, 0.002),
    }


@pytest.mark.no_source
@pytest.mark.parametrize("name", variants())
def test_exact_derivatives_are_those_of_the_poses(name: str) -> None:
    """Central differences of poses against the analytic velocities and accelerations of the twin."""
    corner, step, travel = variants()[name], 2e-5, 0.031
    above, here, below = (corner.quantities(travel + s) for s in (step, 0.0, -step))

    def slope(quantity: str, against: str = "wheel_centre", axis: int | None = None):
        change = (
            above[quantity] - below[quantity]
            if axis is None
            else (above[quantity] - below[quantity])[axis]
        )
        return change / (above[against][2] - below[against][2])

    pairs = {"camber_gain": "camber", "bump_steer": "steer", "caster_gain": "caster"}
    for gain, quantity in pairs.items():
        if gain in here:
            assert here[gain] == pytest.approx(slope(quantity), rel=1e-6, abs=1e-7)
    assert here["motion_ratio"] == pytest.approx(-slope("spring_length"), rel=1e-7)
    assert here["motion_ratio_contact"] == pytest.approx(
        -slope("spring_length", "contact_point"), rel=1e-7
    )
    assert here["motion_ratio_gradient"] == pytest.approx(slope("motion_ratio"), rel=1e-6, abs=1e-6)
    contact = slope("motion_ratio_contact", "contact_point")
    assert here["motion_ratio_gradient_contact"] == pytest.approx(contact, rel=1e-6, abs=1e-6)
    assert here["wheel_centre_dx_dz"] == pytest.approx(
        slope("wheel_centre", axis=0), rel=1e-6, abs=1e-8
    )
    assert here["wheel_centre_dy_dz"] == pytest.approx(
        slope("wheel_centre", axis=1), rel=1e-6, abs=1e-8
    )


@pytest.mark.no_source
@pytest.mark.parametrize("name", variants())
def test_spring_force_is_that_of_virtual_work(name: str) -> None:
    corner = variants()[name]
    got = corner.contact_loads(0.02, (0.0, 0.0, 1000.0))
    assert got["spring_force"] == pytest.approx(
        1000.0 / corner.quantities(0.02)["motion_ratio_contact"], rel=1e-10
    )


@pytest.mark.no_source
def test_forces_on_the_upright_balance() -> None:
    """Double wishbone, cornering and braking: outer points and contact patch in equilibrium about the wheel centre."""
    corner, force = variants()["double wishbone"], np.array([-600.0, 900.0, 2500.0])
    pose = corner.pose(0.015)
    on_upright = corner.contact_loads(0.015, force)["on_upright"]
    spin = pose.turned(corner.spin)
    arm = corner.radius * twin.unit(-twin.UP + spin * spin[2])
    total = force + sum(on_upright.values())
    moment = np.cross(arm, force) + sum(np.cross(pose.arm(p), f) for p, f in on_upright.items())
    assert np.abs(total).max() < 1e-9
    assert np.abs(moment).max() < 1e-9
