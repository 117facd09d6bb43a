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


def test_energy_balance(detailed):
    """What road and start put in is kinetic energy, weight, and what the elements have taken up."""
    _, run = detailed
    stored = sum(run[f"energy.{name}"] for name in ("kinetic", "weight", "spring", "damper", "tyre"))
    change = stored - stored[0] - run["energy.road"]
    assert float(run["energy.kinetic"].max()) > 0.1
    assert float(run["energy.road"].max()) > 1.0
    assert float(run["energy.damper"][-1]) > 0.5
    assert float(np.abs(change).max()) < 1e-6 * float(run["energy.road"].max())


def test_loops_stay_closed(detailed):
    _, run = detailed
    assert float(run["constraint.residual"].max()) < 1e-13


def test_reactions_at_rest_carry_the_weight(detailed):
    rig, run = detailed
    start = run.isel(time=0)
    masses = rig.body_masses()
    assert float(start["tyre.force"]) == pytest.approx(
        9.81 * (rig.sprung.mass + sum(body.mass for body in masses.values())), rel=1e-9
    )
    assert float(start["sprung.fz"]) == pytest.approx(0.0, abs=1e-7)  # the guide slides
    strut = np.array([float(start[f"strut_bottom.{axis}"] - start[f"strut_top.{axis}"]) for axis in "xyz"])
    pushed = float(start["strut.force"]) * strut[2] / np.linalg.norm(strut)
    carried = sum(float(start[f"{name}.fz"]) for name in ("lower_arm", "upper_arm", "tie_rod")) + pushed
    suspension = 9.81 * sum(body.mass for body in masses.values())
    assert carried + float(start["tyre.force"]) == pytest.approx(suspension, rel=1e-6)


@pytest.mark.parametrize(  # the right side is another model: two seconds for that of five links
    "name", [pytest.param(name, marks=[pytest.mark.slow] if name == "sedan-multi-link" else []) for name in VEHICLES]
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


def test_radial_tyre_is_vertical_where_the_wheel_stands_upright():
    """With no camber the wheel's plane is vertical: both laws give the same force; with camber the radial one leans."""
    vertical = jn.load("kart-double-wishbone")
    radial = vertical.with_changes({"tyre.law": "radial"})
    one, other = jn.simulate(vertical, TRIAL), jn.simulate(radial, TRIAL)
    size = float(np.abs(one["unsprung.z"]).max())
    assert float(np.abs(one["unsprung.z"] - other["unsprung.z"]).max()) < 1e-3 * size
    leaning = {"wheel.camber": "10 deg"}
    one = jn.equilibrium(vertical.with_changes(leaning))
    other = jn.equilibrium(radial.with_changes(leaning))
    assert other["tyre.force"] * np.cos(other["wheel.camber"]) == pytest.approx(one["tyre.force"], rel=1e-9)


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
    assert abs(left - straight) == pytest.approx(0.005 / 0.125, rel=0.2)  # the steering arm is about 125 mm long
