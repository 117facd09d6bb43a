"""Steering axis: of links that are a double wishbone it is the line through the ball joints, at every pose."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

import jounce as jn
from jounce.kinematics.view import ScrewMotion, steering_screw
from jounce.parts.corners import DoubleWishbone, FiveLink

AXIS_ROWS = (
    "caster",
    "kingpin_inclination",
    "caster_trail",
    "scrub_radius",
    "spindle_offset",
    "wheel_centre_caster_offset",
    "caster_trail_wheel",
    "scrub_radius_wheel",
    "caster_gain",
)
TRAVEL, RACK = np.linspace(-0.06, 0.06, 5), np.array([-0.02, 0.0, 0.02])


def as_five_links(rig: DoubleWishbone) -> FiveLink:
    """The same mechanism, each arm two links that share the ball joint."""
    points = rig.hardpoints
    table = rig.model_dump(by_alias=True, exclude_none=True)
    links = [
        (f"{arm}_{end}", f"{arm[:5]}_ball_joint")
        for arm in ("lower_arm", "upper_arm")
        for end in ("front", "rear")
    ]
    links.append(("tie_rod_inner", "tie_rod_outer"))
    kept = ("wheel_centre", "strut_bottom", "strut_top")
    table["hardpoints"] = {name: getattr(points, name) for name in kept}
    for i, (inner, outer) in enumerate(links, 1):
        table["hardpoints"] |= {
            f"link_{i}_inner": getattr(points, inner),
            f"link_{i}_outer": getattr(points, outer),
        }
    table["model"] = "five-link"
    table["bodies"] = {"upright": table["bodies"]["upright"]}
    table["strut"] |= {"on": "upright", "pushrod_on": "upright"}
    return FiveLink.from_table(table)


@pytest.mark.parametrize(
    "name", ["reference-double-wishbone", "sedan-double-wishbone", "polaris-front", "suv-front"]
)
def test_a_double_wishbone_of_five_links_steers_about_its_ball_joints(name: str) -> None:
    rig = jn.load(name)
    ball, links = (jn.sweep_travel(one, TRAVEL, RACK) for one in (rig, as_five_links(rig)))
    for row in AXIS_ROWS:
        assert links[row].to_numpy() == pytest.approx(ball[row].to_numpy(), abs=1e-6), row
    assert np.max(np.abs(links["steering_axis_pitch"].to_numpy())) < 1e-9


def test_right_hand_links_have_the_axis_of_the_left_ones() -> None:
    rig = jn.load("sedan-multi-link")
    one, other = (
        jn.sweep_travel(rig, TRAVEL, RACK),
        jn.sweep_travel(rig.mirrored(), TRAVEL, -RACK[::-1]),
    )
    for row in (
        *AXIS_ROWS,
        "steering_axis_pitch",
        "caster_held_spring",
        "scrub_radius_held_spring",
    ):
        assert other[row].to_numpy()[:, ::-1] == pytest.approx(one[row].to_numpy(), abs=1e-9), row


def twists(rig: FiveLink) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Turn and velocity of the wheel centre for unit rates of travel and of rack, from differences of poses."""
    step = 1e-5
    grid = jn.sweep_travel(rig, [-step, 0.0, step], [-step, 0.0, step], points=True)
    names = ["wheel_centre", *(f"link_{i}_outer" for i in range(1, 6))]

    def places(travel: int, rack: int) -> np.ndarray:
        one = grid.isel(wheel_travel=travel, rack_travel=rack)
        return np.array([[float(one[f"{name}.{axis}"]) for axis in "xyz"] for name in names])

    def twist(ahead: np.ndarray, behind: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        velocity, arms = (ahead - behind) / (2.0 * step), (ahead + behind) / 2.0
        arms = arms - arms[0]
        rows = [
            np.array([[0.0, a[2], -a[1]], [-a[2], 0.0, a[0]], [a[1], -a[0], 0.0]]) for a in arms[1:]
        ]
        turn = np.linalg.lstsq(
            np.concatenate(rows), (velocity[1:] - velocity[0]).ravel(), rcond=None
        )[0]
        return turn, velocity[0]

    return {"travel": twist(places(2, 1), places(0, 1)), "rack": twist(places(1, 2), places(1, 0))}


@pytest.mark.parametrize("seed", range(40))
def test_the_steering_screw_is_a_pure_turn_or_that_of_least_pitch(seed: int) -> None:
    """Against a search over all motions of rack and travel together; both kinds occur among the seeds."""
    (turn, speed), (other_turn, other_speed) = np.random.default_rng(seed).normal(size=(2, 2, 3))
    found = steering_screw(
        ScrewMotion(ca.SX(turn), ca.SX(speed)), ScrewMotion(ca.SX(other_turn), ca.SX(other_speed))
    )
    spin, pitch = ca.evalf(found.turn).full()[:, 0], float(ca.evalf(found.pitch))
    shares = np.tan(np.linspace(-1.5707, 1.5707, 400_001))
    spins, speeds = turn + shares[:, None] * other_turn, speed + shares[:, None] * other_speed
    pitches = np.einsum("ij,ij->i", spins, speeds) / np.einsum("ij,ij->i", spins, spins)
    share = float((spin - turn) @ other_turn / (other_turn @ other_turn))
    roots = shares[:-1][np.diff(np.sign(pitches)) != 0.0]
    if len(roots):
        assert pitch == pytest.approx(0.0, abs=1e-10)
        assert abs(share) == pytest.approx(np.min(np.abs(roots)), rel=1e-3, abs=1e-3)
    else:
        assert abs(pitch) == pytest.approx(np.min(np.abs(pitches)), rel=1e-6)


def test_both_kinds_of_steering_screw_occur() -> None:
    kinds = set()
    for seed in range(40):
        (turn, speed), (other_turn, other_speed) = np.random.default_rng(seed).normal(
            size=(2, 2, 3)
        )
        a, b = other_turn @ other_speed, turn @ other_speed + other_turn @ speed
        kinds.add(bool(b**2 >= 4.0 * a * (turn @ speed)))
    assert kinds == {True, False}


def test_the_axis_at_held_spring_length_is_that_of_its_screw() -> None:
    rig = jn.load("sedan-multi-link")
    found, motion = jn.sweep_travel(rig, 0.0), twists(rig)
    step = 1e-5
    lengths = [float(jn.sweep_travel(rig, 0.0, at)["spring_length"][0]) for at in (-step, step)]
    share = (lengths[1] - lengths[0]) / (2.0 * step) / float(found["motion_ratio"][0])
    turn = motion["rack"][0] + share * motion["travel"][0]
    turn = turn * np.sign(turn[2])
    assert float(found["caster_held_spring"][0]) == pytest.approx(
        np.arctan2(-turn[0], turn[2]), abs=1e-6
    )
    assert float(found["kingpin_inclination_held_spring"][0]) == pytest.approx(
        np.arctan2(-turn[1], turn[2]), abs=1e-6
    )


def test_trail_and_scrub_in_the_axes_of_the_wheel() -> None:
    found = jn.sweep_rack(jn.load("reference-double-wishbone"), [-0.03, 0.0, 0.03])
    steer = found["steer"].to_numpy()
    trail, scrub = found["caster_trail"].to_numpy(), found["scrub_radius"].to_numpy()
    assert found["caster_trail_wheel"].to_numpy() == pytest.approx(
        trail * np.cos(steer) - scrub * np.sin(steer), abs=1e-12
    )
    assert found["scrub_radius_wheel"].to_numpy() == pytest.approx(
        scrub * np.cos(steer) + trail * np.sin(steer), abs=1e-12
    )
    assert abs(steer[0]) > 0.1
    assert abs(trail[0] - float(found["caster_trail_wheel"][0])) > 1e-3


def test_parallel_arms_have_their_centre_at_infinity_and_a_swing_arm_with_an_angle() -> None:
    rig = jn.load("reference-double-wishbone")
    points = rig.hardpoints
    shift = np.array(points.upper_ball_joint) - np.array(points.lower_ball_joint)
    changes = {
        f"hardpoints.upper_arm_{end}": tuple(
            map(float, np.array(getattr(points, f"lower_arm_{end}")) + shift)
        )
        for end in ("front", "rear")
    }
    rod = np.array(points.tie_rod_outer) - np.array(points.lower_ball_joint)
    changes["hardpoints.tie_rod_inner"] = tuple(map(float, np.array(points.lower_arm_rear) + rod))
    found = jn.sweep_travel(rig.with_changes(changes), [-0.02, 0.0, 0.02])
    assert np.isinf(found["front_view_swing_arm_length"]).all()
    assert not np.isfinite(found["instant_centre_y"]).any()
    angle = found["front_view_swing_arm_angle"].to_numpy()
    assert np.tan(angle) == pytest.approx(found["jacking"].to_numpy(), rel=1e-12)
    usual = jn.sweep_travel(rig, 0.0)
    rise = float(usual["instant_centre_z"][0] - usual["contact_point_z"][0])
    level = float(usual["front_view_swing_arm_length"][0])
    assert np.tan(float(usual["front_view_swing_arm_angle"][0])) == pytest.approx(
        rise / level, rel=1e-9
    )
    side = float(usual["side_instant_centre_z"][0] - usual["contact_point_z"][0])
    assert np.tan(float(usual["side_view_swing_arm_angle"][0])) == pytest.approx(
        side / float(usual["side_view_swing_arm_length"][0]), rel=1e-9
    )
