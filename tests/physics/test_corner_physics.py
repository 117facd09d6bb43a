"""3-D corners: energy, statics, mirror symmetry, reactions, tyre laws, guides, optional bodies."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

ROAD = jn.HalfSine(height="10 mm", length="100 mm", start="0.2 m")
TRIAL = jn.Trial(road=ROAD, speed="1.95 m/s", duration="0.5 s")
VEHICLES = (
    "kart-double-wishbone",
    "formula-student-front",
    "generic-mcpherson",
    "sedan-multi-link",
    "semi-trailing-arm",
)


@pytest.fixture(scope="module")
def detailed():
    rig = jn.load("kart-double-wishbone")
    return rig, jn.simulate(rig, TRIAL, detail=True, tolerance=1e-8)


@pytest.fixture(scope="module")
def leaning():
    """Its wheel leans by ten degrees on a radial tyre that damps."""
    changes = {"tyre.law": "radial", "tyre.damping_coefficient": 60.0, "wheel.camber": "10 deg"}
    rig = jn.load("kart-double-wishbone").with_changes(changes)
    return rig, jn.simulate(rig, TRIAL, detail=True, tolerance=1e-8)


@pytest.mark.parametrize("which", ["detailed", "leaning"])
def test_energy_balance(which, request):
    """What road and start put in is kinetic energy, weight, and what the elements have taken up."""
    _, run = request.getfixturevalue(which)
    stored = sum(
        run[f"energy.{name}"] for name in ("kinetic", "weight", "spring", "damper", "tyre")
    )
    change = stored - stored[0] - run["energy.road"]
    assert float(run["energy.kinetic"].max()) > 0.1
    assert float(run["energy.road"].max()) > 1.0
    assert float(run["energy.damper"][-1]) > 0.5
    assert float(np.abs(change).max()) < 1e-6 * float(run["energy.road"].max())


def test_loops_stay_closed(detailed):
    _, run = detailed
    assert float(run["constraint.residual"].max()) < 1e-13


@pytest.mark.parametrize("which", ["detailed", "leaning"])
def test_the_contact_point_is_on_the_road_or_the_lowest_of_a_wheel_in_the_air(which, request):
    rig, run = request.getfixturevalue(which)
    contact, centre = (
        np.stack([run[f"{name}.{axis}"].to_numpy() for axis in "xyz"], axis=1)
        for name in ("contact_point", "wheel_centre")
    )
    over, flies = (
        contact[:, 2] - run["road.z"].to_numpy(),
        (run["tyre.deflection"] < 0.0).to_numpy(),
    )
    assert 0.01 < flies.mean() < 0.5
    assert np.abs(over[~flies]).max() < 1e-12
    assert over[flies].min() > 0.0
    reach = np.linalg.norm(contact - centre, axis=1)
    assert reach[flies] == pytest.approx(rig.undeformed_radius, abs=1e-12)
    if which == "leaning":
        assert reach[~flies] == pytest.approx(
            rig.undeformed_radius - run["tyre.deflection"].to_numpy()[~flies], abs=1e-12
        )


def test_reactions_at_rest_carry_the_weight(detailed):
    rig, run = detailed
    start = run.isel(time=0)
    masses = rig.body_masses()
    assert float(start["tyre.force"]) == pytest.approx(
        9.81 * (rig.sprung.mass + sum(body.mass for body in masses.values())), rel=1e-9
    )
    assert float(start["sprung.fz"]) == pytest.approx(0.0, abs=1e-7)  # the guide slides
    strut = np.array(
        [float(start[f"strut_bottom.{axis}"] - start[f"strut_top.{axis}"]) for axis in "xyz"]
    )
    pushed = float(start["strut.force"]) * strut[2] / np.linalg.norm(strut)
    carried = (
        sum(float(start[f"{name}.fz"]) for name in ("lower_arm", "upper_arm", "tie_rod")) + pushed
    )
    suspension = 9.81 * sum(body.mass for body in masses.values())
    assert carried + float(start["tyre.force"]) == pytest.approx(suspension, rel=1e-6)


@pytest.mark.parametrize(  # the right side is another model: two seconds for that of five links
    "name",
    [
        pytest.param(name, marks=[pytest.mark.slow] if name == "sedan-multi-link" else [])
        for name in VEHICLES
    ],
)
def test_right_is_the_mirror_of_left(name):
    left = jn.load(name)
    right = left.mirrored()
    one, other = jn.simulate(left, TRIAL), jn.simulate(right, TRIAL)
    for channel in ("sprung.z", "unsprung.z", "tyre.force", "strut.force", "wheel.camber"):
        assert np.allclose(one[channel], other[channel], rtol=1e-7, atol=1e-9), channel
    assert np.allclose(one["wheel.steer"], -other["wheel.steer"], rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("name", VEHICLES)
def test_tyre_carries_everything_at_rest(name):
    rig = jn.load(name)
    mass = rig.sprung.mass + sum(body.mass for body in rig.body_masses().values())
    assert jn.equilibrium(rig)["tyre.force"] == pytest.approx(rig.gravity * mass, rel=1e-8)


def test_both_tyre_laws_are_one_where_the_wheel_stands_upright():
    """With no camber the wheel's plane is vertical; with camber a radial tyre is pressed in along it, by more force."""
    vertical = jn.load("kart-double-wishbone")
    radial = vertical.with_changes({"tyre.law": "radial"})
    one, other = jn.simulate(vertical, TRIAL), jn.simulate(radial, TRIAL)
    size = float(np.abs(one["unsprung.z"]).max())
    assert float(np.abs(one["unsprung.z"] - other["unsprung.z"]).max()) < 1e-3 * size
    leaning = {"wheel.camber": "10 deg"}
    one = jn.equilibrium(vertical.with_changes(leaning))
    other = jn.equilibrium(radial.with_changes(leaning))
    assert other["tyre.force"] == pytest.approx(
        one["tyre.force"], rel=1e-9
    )  # normal to the road, both carry the corner
    along = other["tyre.force"] * np.cos(other["wheel.camber"])
    assert vertical.tyre.stiffness * other["tyre.deflection"] == pytest.approx(along, rel=1e-9)


def test_a_radial_tyre_pushes_at_the_contact_point():
    """Forces and moments on the upright about its lower ball joint; its own mass is put into the wheel's centre."""
    rig = jn.load("kart-double-wishbone")
    changes = {"bodies.upright.centre_of_mass": list(rig.hardpoints.wheel_centre)}
    rig = rig.with_changes({"tyre.law": "radial", "wheel.camber": "-8 deg", **changes})
    rest = jn.simulate(rig, jn.Trial(road=jn.Flat(), speed=1.0, duration=0.001), detail=True).isel(
        time=0
    )

    def vector(name: str, kind: str = "") -> np.ndarray:
        return np.array([float(rest[f"{name}.{kind}{axis}"]) for axis in "xyz"])

    contact, centre = vector("contact_point"), vector("wheel_centre")
    assert contact[2] == pytest.approx(0.0, abs=1e-12)
    lean = float(rest["wheel.camber"])
    assert contact[1] - centre[1] == pytest.approx(
        -centre[2] * np.tan(lean) * np.cos(float(rest["wheel.steer"])), abs=1e-9
    )
    push = np.array([0.0, 0.0, float(rest["tyre.force"])])
    upright = rig.bodies.upright.mass * np.array([0.0, 0.0, -rig.gravity])
    joints = ("lower_ball_joint", "upper_ball_joint", "tie_rod")
    assert np.abs(push + upright + sum(vector(name, "f") for name in joints)).max() < 1e-9 * push[2]
    ball = vector("lower_ball_joint")
    about = np.cross(contact - ball, push) + np.cross(
        vector("upper_ball_joint") - ball, vector("upper_ball_joint", "f")
    )
    about += np.cross(vector("tie_rod_outer") - ball, vector("tie_rod", "f"))
    about += np.cross(centre - ball, upright)
    assert np.abs(about).max() < 1e-6 * push[2]


def test_blocked_body_leaves_one_mode():
    rig = jn.load("kart-double-wishbone").with_changes({"guide": "fixed"})
    modes = jn.modes(rig)
    assert len(modes) == 1
    assert set(modes[0].shape) == {"unsprung.z"}


def test_body_on_guide_and_joint_heaves_as_on_the_guide_when_its_turning_is_stiff():
    """A body whose inertia is large hardly turns: it then moves as on the vertical guide.

    Its centre of mass lies far below the joint: the tyre pushes from below and would tip it over otherwise.
    """
    rig = jn.load("kart-double-wishbone")
    turning = rig.with_changes(
        {
            "guide": "vertical+spherical",
            "sprung": {
                "mass": 16.0,
                "centre_of_mass": [0.0, 0.4, -0.8],
                "joint": [0.0, 0.4, 0.6],
                "inertia": {"xx": 100.0, "yy": 100.0, "zz": 100.0},
            },
        }
    )
    one, other = jn.simulate(rig, TRIAL), jn.simulate(turning, TRIAL, check=False)
    assert other.attrs["status"] == "completed"
    size = float(np.abs(one["sprung.z"] - one["sprung.z"][0]).max())
    change = (other["sprung.z"] - other["sprung.z"][0]) - (one["sprung.z"] - one["sprung.z"][0])
    assert float(np.abs(change).max()) < 0.05 * size


def test_rack_steers_the_wheel():
    rig = jn.load("reference-double-wishbone")
    straight = jn.equilibrium(rig)["wheel.steer"]
    left = jn.equilibrium(rig.with_changes({"steering": {"rack_travel": "5 mm"}}))["wheel.steer"]
    right = jn.equilibrium(rig.with_changes({"steering": {"rack_travel": "-5 mm"}}))["wheel.steer"]
    assert abs(straight) < 1e-3
    assert np.sign(left - straight) == -np.sign(right - straight)
    assert abs(left - straight) == pytest.approx(
        0.005 / 0.125, rel=0.2
    )  # the steering arm is about 125 mm long
