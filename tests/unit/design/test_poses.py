"""Rigs in other poses: points, bodies, wheel, spring and stops are where the linkage brings them."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.kinematics.moved_rigs import (
    rig_with_hardpoints,
    rigid_motion,
    rigs_along,
    spin_axis,
    wheel_angles,
)
from jounce.parts.leverage import spring_force

KART = jn.load("kart-double-wishbone")
MODELS = ("kart-double-wishbone", "hmmwv-front", "generic-mcpherson", "sedan-multi-link")


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("side", ["left", "right"])
def test_kinematics_go_on_from_the_new_pose(name, side):
    """The rig described in its pose at a travel has, at design, what the rig has at that travel."""
    rig = jn.load(name) if side == "left" else jn.load(name).mirrored()
    travel = 0.02
    # its strut stands on a link with universal joints, whose cross lies along the link as described: a little spin
    close = 5e-3 if name == "sedan-multi-link" else 1e-7
    (posed,) = rigs_along(rig, [travel])
    then, now = jn.sweep_travel(rig, [travel]), jn.sweep_travel(posed, [0.0])
    for quantity in ("camber", "toe", "caster", "roll_centre_height", "spring_length"):
        assert float(now[quantity][0]) == pytest.approx(
            float(then[quantity][0]), rel=1e-7, abs=1e-9
        ), quantity
    for quantity in (
        "motion_ratio",
        "damper_motion_ratio",
        "spring_force",
        "wheel_rate_spring",
        "stop_force",
    ):
        assert float(now[quantity][0]) == pytest.approx(
            float(then[quantity][0]), rel=close, abs=1e-9
        ), quantity


def test_springs_beside_the_strut_go_on_from_the_new_pose():
    """A torsion bar stays wound up and a third spring compressed, whichever pose describes the rig."""
    rig = KART.with_changes(
        {
            "torsion_bar": {"stiffness": 60.0, "preload": 3.0, "on": "lower_arm"},
            "third_spring": {"spring": {"rate": 2e3, "preload": 10.0}, "on": "lower_arm"},
            "hardpoints.third_spring_end": [0.0, 0.12, 0.125],
        }
    )
    (posed,) = rigs_along(rig, [0.02])
    then, now = jn.sweep_travel(rig, [0.02]), jn.sweep_travel(posed, [0.0])
    for quantity in (
        "torsion_bar_torque",
        "third_spring_force",
        "heave_force",
        "heave_rate",
        "wheel_rate",
    ):
        assert float(now[quantity][0]) == pytest.approx(float(then[quantity][0]), rel=1e-9), (
            quantity
        )


@pytest.mark.parametrize("name", MODELS)
def test_bodies_keep_their_masses_and_principal_moments(name):
    rig = jn.load(name)
    (posed,) = rigs_along(rig, [0.02])
    for body, moved in posed.body_masses().items():
        own = rig.body_masses()[body]
        assert moved.mass == own.mass
        assert moved.inertia.principal_moments == pytest.approx(
            own.inertia.principal_moments, rel=1e-9
        )
        assert moved.centre_of_mass != own.centre_of_mass


def test_dynamics_do_not_care_which_pose_the_description_is_in():
    """Modes about rest and the static state are those of the rig described at design."""
    (posed,) = rigs_along(KART, [0.015])
    for one, other in zip(jn.modes(KART), jn.modes(posed), strict=True):
        assert other.frequency_hz == pytest.approx(one.frequency_hz, rel=1e-8)
        assert other.damping_ratio == pytest.approx(one.damping_ratio, rel=1e-8)
    rest, moved = jn.equilibrium(KART), jn.equilibrium(posed)
    assert moved["strut.force"] == pytest.approx(rest["strut.force"], rel=1e-9)
    # the new design stands 15 mm farther in bump: the body is that much lower when the wheel is where it was
    assert rest["sprung.z"] - rest["unsprung.z"] == pytest.approx(
        moved["sprung.z"] - moved["unsprung.z"] - 0.015, abs=1e-9
    )


@pytest.mark.parametrize(
    "spring",
    [
        {"rate": 22730.0, "preload": 180.0},
        {"rate": 22730.0, "free_length": 0.208},
        {"curve": {"kind": "polynomial", "coefficients": [20e3, 1e5]}},
        {"curve": {"kind": "polynomial", "coefficients": [20e3, 1e5]}, "free_length": 0.208},
    ],
)
def test_spring_and_stops_are_the_same_things(spring):
    rig = KART.with_changes(
        {
            "strut.spring": spring,
            "strut.bump_stop": {"gap": 0.004, "rate": 5e4},
            "strut.rebound_stop": {"gap": 0.003, "rate": 5e4},
        }
    )
    for travel in (-0.01, 0.01):
        (posed,) = rigs_along(rig, [travel])
        sweep = jn.sweep_travel(rig, [travel])
        assert spring_force(posed) == pytest.approx(
            float(sweep["spring_force"][0] + sweep["stop_force"][0]), rel=1e-9, abs=1e-9
        )
        assert abs(float(sweep["stop_force"][0])) > 10.0


def test_a_damper_pushes_as_much_in_the_new_design():
    law = {
        "kind": "tanh",
        "coefficient": 160.0,
        "force": 0.0,
        "slope": 1.0,
        "stiffness": 1500.0,
        "offset": 40.0,
    }
    rig = KART.with_changes({"strut.damper": law})
    (posed,) = rigs_along(rig, [0.01])
    assert posed.strut.damper.at_rest()[0] == pytest.approx(
        float(jn.sweep_travel(rig, [0.01])["damper_force"][0]), rel=1e-9
    )
    assert posed.strut.damper.at_rest()[0] > 50.0


def test_a_curve_with_a_preload_has_no_other_length():
    spring = {"curve": {"kind": "polynomial", "coefficients": [20e3]}, "preload": 5.0}
    with pytest.raises(DescriptionError, match="Give free_length"):
        rigs_along(KART.with_changes({"strut.spring": spring}), [0.01])
    assert rigs_along(KART.with_changes({"strut.spring": {"rate": 2e4, "preload": 5.0}}), [0.01])


def test_poses_out_of_reach_are_refused():
    with pytest.raises(DescriptionError, match="out of reach"):
        rigs_along(KART, [0.0, 0.5])


def test_nothing_moved_is_nothing_changed():
    same = rig_with_hardpoints(KART, {})
    assert same.parameters() == pytest.approx(KART.parameters(), rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("count", [2, 3, 5])
def test_rigid_motion_is_found(count):
    generator = np.random.default_rng(count)
    points = generator.standard_normal((count, 3))
    axis, angle = np.array([1.0, 2.0, -0.5]) / np.sqrt(5.25), 0.4
    skew = np.cross(np.eye(3), -axis)
    turn = np.eye(3) + np.sin(angle) * skew + (1.0 - np.cos(angle)) * skew @ skew
    found, shift = rigid_motion(points, points @ turn.T + [0.1, 0.2, 0.3])
    assert points @ found.T + shift == pytest.approx(points @ turn.T + [0.1, 0.2, 0.3], abs=1e-12)
    assert np.linalg.det(found) == pytest.approx(1.0)
    if count > 2:  # two points leave the turn about their line open
        assert found == pytest.approx(turn, abs=1e-12)


@pytest.mark.parametrize("side", ["left", "right"])
def test_wheel_angles_are_read_from_the_axis(side):
    rig = KART.with_changes({"wheel.camber": "-2 deg", "wheel.toe": "0.7 deg"})
    rig = rig if side == "left" else rig.mirrored()
    assert np.degrees(wheel_angles(rig, spin_axis(rig))) == pytest.approx([-2.0, 0.7])
