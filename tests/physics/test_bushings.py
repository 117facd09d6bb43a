"""Bushings: what they do between two bodies, and in place of the joints of a suspension."""

from __future__ import annotations

from pathlib import Path

import casadi
import numpy as np
import pytest

import jounce as jn
from jounce import parts
from jounce.mechanics import Mechanism, add_bushing, add_elastic_rod
from jounce.roads import HalfSine, Trial

PROTOTYPE = parts.load(Path(__file__).parents[1] / "files" / "prototype-double-wishbone.toml")
ARMS = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")
BUMP = Trial(road=HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.3 s")
STIFFNESS, TURNING = (3e5, 5e5, 2e5), (300.0, 500.0, 200.0)
SHAFT = (0.05, 0.08, 0.06)


def two_bodies(damping=(0.0, 0.0, 0.0), rotational_damping=(0.0, 0.0, 0.0)):
    """Two bodies in flight with a bushing between them, away from both centres of mass."""
    mechanism = Mechanism(gravity=0.0)
    first = mechanism.body("first", 3.0, (0.1, 0.0, 0.0), (0.05, 0.08, 0.06))
    second = mechanism.body("second", 2.0, (-0.2, 0.1, 0.05), (0.02, 0.03, 0.04))
    mechanism.free("first", first)
    mechanism.free("second", second)
    soft = add_bushing(
        mechanism,
        "mount",
        first,
        second,
        (0.02, -0.1, 0.03),
        STIFFNESS,
        damping=damping,
        rotational_stiffness=TURNING,
        rotational_damping=rotational_damping,
    )
    for i, axis in enumerate("xyz"):
        mechanism.output(f"mount.f{axis}", soft.force[i], "N", f"force along {axis}")
        mechanism.output(f"mount.t{axis}", soft.torque[i], "N*m", f"torque about {axis}")
        for name, body in (("first", first), ("second", second)):
            point = body.point(body.mass_properties.centre)
            spin = body.frame.orientation.rotate(
                body.mass_properties.inertia @ body.frame.orientation.spin
            )
            moment = body.mass_properties.mass * casadi.cross(point.value, point.rate) + spin
            mechanism.output(
                f"{name}.p{axis}", body.mass_properties.mass * point.rate[i], "N*s", "momentum"
            )
            mechanism.output(
                f"{name}.l{axis}", moment[i], "N*m*s", "moment of momentum about the origin"
            )
    mechanism.output("mount.energy", soft.energy, "J", "energy")
    mechanism.output("mount.power", soft.power, "W", "power")
    mechanism.output("kinetic", mechanism.kinetic_energy(), "J", "kinetic energy")
    return mechanism


def turned_about(axis, angle):
    axis = np.array(axis) / np.linalg.norm(axis)
    e = np.concatenate([[np.cos(0.5 * angle)], np.sin(0.5 * angle) * axis])
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return e, np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross


def forces(mechanism, start):
    run = jn.simulate_mechanism(mechanism, 1e-3, start=start, output_step=1e-3)
    return np.array([float(run[f"mount.{kind}{axis}"][0]) for kind in "ft" for axis in "xyz"])


def test_a_rigid_motion_of_both_gives_no_force():
    """Both turn by 70 degrees about a far point and move on with the velocities of one rigid body."""
    e, matrix = turned_about((0.3, -1.0, 0.4), np.deg2rad(70.0))
    pivot, spin, drift = (
        np.array([0.5, 0.2, -0.3]),
        np.array([3.0, -2.0, 1.0]),
        np.array([0.4, 0.1, -0.7]),
    )
    start = {}
    for name, centre in (
        ("first", np.array([0.1, 0.0, 0.0])),
        ("second", np.array([-0.2, 0.1, 0.05])),
    ):
        place = pivot + matrix @ (centre - pivot)
        velocity = drift + np.cross(spin, place - pivot)
        start |= {
            f"{name}.{axis}": value for axis, value in zip("xyz", place - centre, strict=True)
        }
        start |= {f"{name}.{axis} rate": value for axis, value in zip("xyz", velocity, strict=True)}
        start |= {f"{name}.e{i}": value for i, value in enumerate(e)}
        start |= {
            f"{name}.w{axis}": value for axis, value in zip("xyz", matrix.T @ spin, strict=True)
        }
    found = forces(
        two_bodies(damping=(50.0, 60.0, 70.0), rotational_damping=(0.5, 0.6, 0.7)), start
    )
    np.testing.assert_allclose(found, 0.0, atol=1e-8)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_forces_of_small_displacements(axis):
    shift = 1e-4
    found = forces(two_bodies(), {f"second.{'xyz'[axis]}": shift})
    wanted = np.zeros(6)
    wanted[axis] = -STIFFNESS[axis] * shift
    np.testing.assert_allclose(found, wanted, atol=1e-6)


@pytest.mark.parametrize("degrees", [1e-6, 5.0, 20.0, 90.0, -120.0, 179.0])
@pytest.mark.parametrize("axis", [0, 1, 2])
def test_torques_of_turns_about_the_bushing(axis, degrees):
    """The second body turns about the bushing itself: no displacement there, and a torque of stiffness times angle."""
    angle, way = np.deg2rad(degrees), np.eye(3)[axis]
    e, matrix = turned_about(way, angle)
    at, centre = np.array([0.02, -0.1, 0.03]), np.array([-0.2, 0.1, 0.05])
    moved = at + matrix @ (centre - at) - centre
    start = {f"second.{name}": value for name, value in zip("xyz", moved, strict=True)}
    start |= {f"second.e{i}": value for i, value in enumerate(e)}
    found = forces(two_bodies(), start)
    wanted = np.zeros(6)
    wanted[3 + axis] = -TURNING[axis] * angle
    np.testing.assert_allclose(found[:3], 0.0, atol=1e-8)
    np.testing.assert_allclose(found[3:], wanted[3:], rtol=1e-9, atol=1e-9)


def test_a_torque_does_the_work_of_its_energy_far_from_the_design_pose():
    """Turned by 100 degrees about a slanting axis, then let go: energy goes to and fro, and none is lost."""
    e, _ = turned_about((1.0, -2.0, 0.5), np.deg2rad(100.0))
    start = {f"second.e{i}": value for i, value in enumerate(e)} | {"second.wx": 8.0}
    run = jn.simulate_mechanism(two_bodies(), 0.2, start=start, output_step=1e-3, tolerance=1e-9)
    whole = (run["kinetic"] + run["mount.energy"]).values
    assert float(run["kinetic"].max() - run["kinetic"].min()) > 100.0
    np.testing.assert_allclose(whole, whole[0], rtol=1e-6)


def shaken(**damping):
    start = {
        "second.x": 2e-3,
        "second.z": -1e-3,
        "first.wx": 4.0,
        "second.wy": -6.0,
        "second.y rate": 0.5,
    }
    return jn.simulate_mechanism(
        two_bodies(**damping), 0.5, start=start, output_step=1e-3, tolerance=1e-9
    )


def test_inner_forces_keep_momentum_and_energy():
    """Force and torque on both bodies act at one place: moment of momentum is kept too, in large motions."""
    run = shaken()
    for axis in "xyz":
        for kind, size in (("p", 1.0), ("l", 0.1)):
            total = run[f"first.{kind}{axis}"] + run[f"second.{kind}{axis}"]
            assert float(abs(total - total[0]).max()) < 1e-6 * size
    energy = run["kinetic"] + run["mount.energy"]
    assert float(abs(energy - energy[0]).max()) < 1e-6 * float(energy[0])
    assert np.ptp(run["kinetic"].to_numpy()) > 0.1 * float(energy[0])


def test_damping_takes_energy_as_its_power_says():
    run = shaken(damping=(20.0, 30.0, 10.0), rotational_damping=(0.2, 0.1, 0.3))
    energy = run["kinetic"] + run["mount.energy"]
    assert np.all(np.diff(energy) <= 1e-9)
    taken = np.trapezoid(run["mount.power"], run["time"])
    assert taken == pytest.approx(float(run["kinetic"][0] - run["kinetic"][-1]), rel=2e-2)
    assert float(energy[-1]) < 0.9 * float(energy[0])


def test_methods_agree_on_a_mechanism_of_ones_own():
    """Strongly damped bushing: the implicit method is chosen; both give the same motion."""
    more = {"damping": (3e4, 3e4, 3e4), "rotational_damping": (300.0, 300.0, 300.0)}
    start = {"second.x": 1e-3, "first.wx": 4.0, "second.y rate": 0.5}
    runs = {
        method: jn.simulate_mechanism(
            two_bodies(**more), 1.0, start=start, output_step=1e-2, method=method
        )
        for method in ("auto", "explicit", "implicit")
    }
    assert [run.attrs["method"] for run in runs.values()] == ["implicit", "explicit", "implicit"]
    assert runs["implicit"].attrs["steps"] < 0.05 * runs["explicit"].attrs["steps"]
    for axis in "xyz":
        difference = runs["implicit"][f"second.p{axis}"] - runs["explicit"][f"second.p{axis}"]
        assert float(abs(difference[1:]).max()) < 1e-5


def test_an_elastic_rod_is_its_bushing_along_itself():
    """A mass on a slanting rod, moved along it: the compliance is ``sum e_i^2 / k_i``."""
    along, length = np.array([0.6, 0.0, 0.8]), 0.5
    mechanism = Mechanism(gravity=0.0)
    bob = mechanism.body("bob", 1.0, tuple(length * along), SHAFT)
    mechanism.prismatic("slide", mechanism.ground, bob, axis=tuple(along))
    tension, _ = add_elastic_rod(
        mechanism,
        "rod",
        mechanism.ground,
        bob,
        (0.0, 0.0, 0.0),
        tuple(length * along),
        (2e5, 0.0, 4e5),
    )
    mechanism.output("rod.tension", tension, "N", "tension")
    run = jn.simulate_mechanism(mechanism, 1e-3, start={"slide.distance": 1e-3}, output_step=1e-3)
    stiffness = 1.0 / (0.6**2 / 2e5 + 0.8**2 / 4e5)
    assert float(run["rod.tension"][0]) == pytest.approx(stiffness * 1e-3, rel=1e-9)


def on_bushings(rig, points, stiffness, **more):
    law = {"stiffness": (stiffness,) * 3, "damping": (1e-3 * stiffness,) * 3, **more}
    table = rig.model_dump(by_alias=True, exclude_none=True) | {
        "bushings": dict.fromkeys(points, law)
    }
    return type(rig).model_validate(table)


RIGS = {
    "double wishbone": (PROTOTYPE, ARMS),
    "one side of an arm": (PROTOTYPE, ("lower_arm_front", "upper_arm_rear")),
    "tie rod": (PROTOTYPE, ("tie_rod_inner",)),
    "mcpherson": (
        parts.load("generic-mcpherson"),
        ("lower_arm_front", "lower_arm_rear", "strut_top"),
    ),
    "five links": (parts.load("sedan-multi-link"), tuple(f"link_{i}_inner" for i in range(1, 6))),
    "trailing arm": (parts.load("semi-trailing-arm"), ("arm_inner", "arm_outer")),
}


# rods on bushings as the others have them, seconds to compile
ALIKE = ("one side of an arm", "tie rod", "five links")


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=[pytest.mark.slow] if n in ALIKE else []) for n in RIGS]
)
def test_stiff_bushings_become_the_ideal_joints(name):
    """The difference from the ideal joints falls in proportion to the compliance."""
    rig, points = RIGS[name]
    ideal = jn.simulate(rig, BUMP, tolerance=1e-7)
    differences = []
    for stiffness in (1e8, 1e9):
        soft = jn.simulate(on_bushings(rig, points, stiffness), BUMP, tolerance=1e-7)
        sizes = {
            c: np.ptp(ideal[c].to_numpy()) for c in ("sprung.z", "unsprung.z", "tyre.force")
        } | {"wheel.camber": 0.01}
        shares = [float(abs(soft[c] - ideal[c]).max()) / size for c, size in sizes.items()]
        differences.append(max(shares))
    assert differences[0] < 0.02
    assert differences[1] > 1e-6
    assert differences[1] < 0.2 * differences[0]


def test_energy_of_a_suspension_on_bushings():
    """What the road puts in is found in weights, springs, damper, bushings and motion."""
    rig = on_bushings(PROTOTYPE, ARMS, 2e6, rotational_stiffness=(20.0, 20.0, 20.0))
    run = jn.simulate(rig, BUMP, tolerance=1e-8, detail=True)
    taken = [
        name for name in run.data_vars if str(name).startswith("energy.") and name != "energy.road"
    ]
    total = sum(run[name] - run[name][0] for name in taken) - run["energy.road"]
    assert "energy.bushings" in taken
    assert float(abs(total).max()) < 1e-6 * float(abs(run["energy.road"]).max())
    assert float(run["energy.bushings"].max()) > 1e-4


def test_static_forces_of_bushings_carry_the_arm():
    """Front and rear bushings of the lower arm together give what the joint of the rigid rig gives, at rest."""
    still = Trial(
        road=HalfSine(height="10 mm", length="60 mm", start="10 m"),
        speed="1.95 m/s",
        duration="2 ms",
    )
    rigid = jn.simulate(PROTOTYPE, still, detail=True)
    soft = jn.simulate(
        on_bushings(PROTOTYPE, ARMS, 1e8, rotational_stiffness=(0.0,) * 3), still, detail=True
    )
    for axis in "xyz":
        joint = float(rigid[f"lower_arm.f{axis}"][0])
        pair = sum(float(soft[f"lower_arm_{end}.f{axis}"][0]) for end in ("front", "rear"))
        assert pair == pytest.approx(joint, rel=1e-3, abs=0.05)
