"""Kinematic sweeps against the readable twin: other unknowns, other constraints, the same physics."""

from __future__ import annotations

import corner_kinematics_twin as twin
import numpy as np
import pytest

import jounce as jn
from jounce.kinematics.loads import ContactLoad

pytestmark = pytest.mark.usefixtures("optimised")

TRAILING_ARM = """schema = "jounce.rig/1"
model = "trailing-arm"
guide = "fixed"
[hardpoints]
arm_inner = ["400 mm", "300 mm", "300 mm"]
arm_outer = ["350 mm", "550 mm", "290 mm"]
wheel_centre = ["0 mm", "700 mm", "300 mm"]
strut_bottom = ["50 mm", "550 mm", "280 mm"]
strut_top = ["50 mm", "520 mm", "600 mm"]
[wheel]
radius = "300 mm"
camber = "-1 deg"
toe = "0.2 deg"
[bodies.arm]
mass = "20 kg"
centre_of_mass = ["100 mm", "600 mm", "300 mm"]
inertia = {xx = 0.5, yy = 1.0, zz = 1.0}
[strut]
spring = {rate = "25 N/mm", preload = "3000 N"}
damper = {coefficient = "1500 N*s/m"}
[tyre]
stiffness = "200 N/mm"
"""
# the twin's name of a quantity -> the catalogue's
NAMES = {
    "front_instant_centre_y": "instant_centre_y",
    "front_instant_centre_z": "instant_centre_z",
    "contact_dx_dz": "contact_patch_recession",
    "contact_dy_dz": "jacking",
    "wheel_centre_dx_dz": "wheel_centre_longitudinal_slope",
    "wheel_centre_dy_dz": "wheel_centre_lateral_slope",
    "motion_ratio_gradient": "motion_ratio_gradient",
    "motion_ratio_gradient_contact": "motion_ratio_contact_gradient",
    "wheel_rate_spring_contact": "wheel_rate_contact_spring",
    "caster_gain": "caster_gain",
}
TRAVEL = np.linspace(-0.08, 0.08, 9)


@pytest.fixture(scope="module")
def trailing_arm(tmp_path_factory: pytest.TempPathFactory):
    file = tmp_path_factory.mktemp("rigs") / "arm.toml"
    file.write_text(TRAILING_ARM, encoding="utf-8")
    return jn.load(file)


def twin_of(rig):
    points = {name: np.array(place) for name, place in rig.hardpoints.given().items()}
    wheel = rig.wheel
    build = getattr(twin, rig.model.replace("-", "_"))
    return build(points, wheel.radius, wheel.camber, wheel.toe)


def loaded(name: str):
    """A rig of the library; the twin's five-link has its strut on the upright, so ours gets it there."""
    rig = jn.load(name)
    return rig.with_changes({"strut.on": "upright"}) if name == "sedan-multi-link" else rig


def rig_named(name: str, request: pytest.FixtureRequest):
    return request.getfixturevalue("trailing_arm") if name == "trailing-arm" else loaded(name)


RIGS = (
    "reference-double-wishbone",
    "audi-double-wishbone",
    "polaris-front",
    "kart-double-wishbone",
    "generic-mcpherson",
    "sedan-multi-link",
    "trailing-arm",
)


@pytest.mark.parametrize("name", RIGS)
@pytest.mark.some(3)
def test_every_quantity_over_travel(name: str, request: pytest.FixtureRequest) -> None:
    rig = rig_named(name, request)
    twin, span = twin_of(rig), 0.3 if name == "kart-double-wishbone" else 1.0
    found = jn.sweep_travel(rig, span * TRAVEL)
    assert found.attrs["status"] == "completed"
    _compare(twin, found, rig, span * TRAVEL, 0.0)


@pytest.mark.parametrize("name", RIGS[:-1])
def test_every_quantity_with_the_rack_away(name: str) -> None:
    rig, travel = loaded(name), np.array([-0.02, 0.0, 0.02])
    found = jn.sweep_travel(rig, travel, rack=[-0.012, 0.0, 0.012])
    twin = twin_of(rig)
    for rack in (-0.012, 0.012):
        _compare(twin, found.sel(rack_travel=rack), rig, travel, rack)


def _compare(twin, found, rig, travel, rack: float) -> None:
    for k, z in enumerate(travel):
        force = float(found["spring_force"][k] + found["stop_force"][k])
        stiffness = float(found["wheel_rate_spring"][k] / found["motion_ratio"][k] ** 2)
        expected = twin.quantities(z, rack, spring_rate=stiffness, spring_force=force)
        contact = expected.pop("contact_point")
        centre = expected.pop("wheel_centre")
        for i, axis in enumerate("xyz"):
            assert float(found[f"contact_point_{axis}"][k]) == pytest.approx(contact[i], abs=1e-12)
            assert float(found[f"wheel_centre_{axis}"][k]) == pytest.approx(centre[i], abs=1e-12)
        for name, value in expected.items():
            own = float(found[NAMES.get(name, name)][k])
            assert own == pytest.approx(value, rel=2e-8, abs=1e-10), (rig.model, name, z)


@pytest.mark.parametrize("name", RIGS[:-1])
def test_steering_ratio_and_virtual_axis(name: str) -> None:
    rig = loaded(name)
    twin = twin_of(rig)
    found = jn.sweep_travel(rig, [-0.03, 0.0, 0.03])
    for k, z in enumerate((-0.03, 0.0, 0.03)):
        pose = twin.pose(z)
        _, turn = twin.steering_motion(pose)
        spin = pose.turned(twin.spin)
        rate = np.cross(turn, spin)
        ratio = (spin[0] * rate[1] - spin[1] * rate[0]) / (spin[0] ** 2 + spin[1] ** 2)
        assert float(found["steer_gain"][k]) == pytest.approx(ratio, rel=1e-9)
        if rig.model == "five-link":
            _, along = twin.virtual_axis(pose)
            assert float(found["caster"][k]) == pytest.approx(
                np.arctan2(-along[0], along[2]), abs=1e-10
            )
            assert float(found["kingpin_inclination"][k]) == pytest.approx(
                np.arctan2(-along[1], along[2]), abs=1e-10
            )


@pytest.mark.parametrize("name", ["reference-double-wishbone", "sedan-multi-link"])
def test_joint_loads(name: str) -> None:
    rig = loaded(name)
    twin, travel = twin_of(rig), (-0.04, 0.0, 0.04)
    load = ContactLoad(
        longitudinal_force=500.0, lateral_force=-2000.0, vertical_force=4000.0, aligning_torque=30.0
    )
    found = jn.pickup_loads(rig, load, travel)
    names: dict[tuple[float, ...], list[str]] = {}  # links may share a point
    for point, place in rig.hardpoints.given().items():
        names.setdefault(tuple(place), []).append(point)
    for k, z in enumerate(travel):
        expected = twin.contact_loads(z, (500.0, -2000.0, 4000.0), (0.0, 0.0, 30.0))
        assert float(found["spring.force"][k]) == pytest.approx(expected["spring_force"], rel=1e-9)
        for place, force in expected["on_upright"].items():
            own = [
                -sum(float(found[f"{point}.f{axis}"][k]) for point in names[tuple(place)])
                for axis in "xyz"
            ]
            assert own == pytest.approx(force, rel=1e-8, abs=1e-6), (place, z)
