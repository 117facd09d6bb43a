"""Compliance on bushings: differences, reciprocity, a rigid body on springs by hand, and the limit of hard bushings."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

ARMS = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")
SOFT = {"stiffness": [6e6, 8e6, 3e6], "rotational_stiffness": [50.0, 60.0, 70.0]}


def on_bushings(stiffness: float = 1.0):
    """Harder in all directions by a factor; what resists the arms' turning stays soft."""
    bushing = {**SOFT, "stiffness": [stiffness * value for value in SOFT["stiffness"]]}
    return jn.load("reference-double-wishbone").with_changes(
        {"bushings": dict.fromkeys(ARMS, bushing)}
    )


RIGS = {
    "double-wishbone": on_bushings,
    "with a soft tie rod": lambda: on_bushings().with_changes({"bushings.tie_rod_inner": SOFT}),
    "springs beside the strut": lambda: on_bushings().with_changes(
        {
            "torsion_bar": {"stiffness": 900.0, "preload": 120.0, "on": "lower_arm"},
            "third_spring": {"spring": {"rate": 40e3, "preload": 200.0}, "on": "lower_arm"},
            "hardpoints.third_spring_end": [0.0, 0.4, 0.3],
            "anti_roll_bar": {"stiffness": 400.0, "on": "lower_arm", "kind": "z"},
            "hardpoints.arb_pivot": [-0.3, 0.4, 0.3],
            "hardpoints.arb_arm_end": [-0.1, 0.45, 0.3],
            "hardpoints.arb_link_end": [-0.05, 0.55, 0.2],
        }
    ),
    "mcpherson": lambda: jn.load("generic-mcpherson").with_changes(
        {"bushings": {"lower_arm_front": SOFT, "lower_arm_rear": SOFT}}
    ),
    "five-link": lambda: jn.load("sedan-multi-link").with_changes(
        {"strut.on": "upright", "bushings": {"link_1_inner": SOFT, "link_3_inner": SOFT}}
    ),
    "trailing-arm": lambda: jn.load("semi-trailing-arm").with_changes(
        {"bushings": {"arm_inner": SOFT, "arm_outer": SOFT}}
    ),
}


@pytest.fixture(scope="module", params=RIGS)
def rig(request: pytest.FixtureRequest):
    return RIGS[request.param]()


@pytest.mark.parametrize(
    ("load", "field", "step", "through"),
    [
        ("braking", "longitudinal_force", 20.0, "contact_point"),
        ("driving", "longitudinal_force", 20.0, "wheel_centre"),
        ("lateral", "lateral_force", 20.0, "contact_point"),
        ("aligning", "aligning_torque", 2.0, "contact_point"),
    ],
)
def test_compliances_are_slopes_of_the_state(
    rig, load: str, field: str, step: float, through: str
) -> None:
    found = jn.compliance(rig, 0.01)
    states = [
        jn.compliance(rig, 0.01, load=jn.ContactLoad(**{field: sign * step, "through": through}))
        for sign in (-1.0, 1.0)
    ]
    for name in ("toe", "camber", "steer"):
        slope = float(states[1][name][0] - states[0][name][0]) / (2.0 * step)
        slope *= -1.0 if load == "braking" else 1.0  # a newton of braking is one to the rear
        own = float(found[f"{load}.{name}"][0])
        assert own == pytest.approx(slope, rel=2e-4, abs=2e-11), name


def test_displacements_are_reciprocal(rig) -> None:
    """Maxwell and Betti: the patch's x under a lateral force is its y under a longitudinal one, and so on."""
    found = jn.compliance(rig, [-0.01, 0.0, 0.01])
    for one, other, sign in (
        ("braking.patch_y", "lateral.patch_x", -1.0),
        ("driving.patch_x", "braking.wheel_centre_x", -1.0),
        ("driving.patch_y", "lateral.wheel_centre_x", 1.0),
    ):
        assert found[one].to_numpy() == pytest.approx(
            sign * found[other].to_numpy(), rel=1e-8, abs=1e-15
        )
    for name, sign in (
        ("braking.patch_x", -1.0),
        ("lateral.patch_y", 1.0),
        ("driving.wheel_centre_x", 1.0),
    ):
        assert np.all(sign * found[name] > 0.0)  # loads do work: braking pushes to the rear


def test_hard_bushings_are_ideal_joints() -> None:
    hard, travel = jn.compliance(on_bushings(1e5), [-0.02, 0.0, 0.02]), [-0.02, 0.0, 0.02]
    ideal = jn.sweep_travel(jn.load("reference-double-wishbone"), travel)
    for name in ("toe", "camber"):
        assert hard[name].to_numpy() == pytest.approx(ideal[name].to_numpy(), abs=1e-6)
    soft = jn.compliance(on_bushings(1.0), travel)
    assert np.all(np.abs(hard["lateral.camber"]) < 2e-5 * np.abs(soft["lateral.camber"]))


def test_an_arm_on_two_bushings_by_hand() -> None:
    """One rigid body: stiffness of bushings and spring about the design pose, ground holding the patch's height."""
    rig = RIGS["trailing-arm"]()
    places = rig.hardpoints
    length = places.length("spring")
    spring = {
        "rate": 30e3,
        "free_length": length,
    }  # unloaded at design, so nothing moves before the load
    rig = rig.with_changes({"strut.spring": spring})
    found = jn.compliance(rig, 0.0)

    def rows(point) -> np.ndarray:
        """Displacement of a point for (translation, rotation) of the body."""
        x, y, z = point
        return np.hstack([np.eye(3), [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]])

    stiffness = np.zeros((6, 6))
    for name in ("arm_inner", "arm_outer"):
        stiffness += (
            rows(getattr(places, name)).T @ np.diag(SOFT["stiffness"]) @ rows(getattr(places, name))
        )
        stiffness[3:, 3:] += np.diag(SOFT["rotational_stiffness"])
    bottom, top = np.array(places.at("spring_bottom")), np.array(places.at("spring_top"))
    along = (top - bottom) / np.linalg.norm(top - bottom) @ rows(bottom)
    stiffness += 30e3 * np.outer(along, along)
    swept = jn.sweep_travel(rig, 0.0)
    patch = np.array([float(swept[f"contact_point_{axis}"][0]) for axis in "xyz"])
    held = rows(patch)[2:]
    matrix = np.block([[stiffness, held.T], [held, np.zeros((1, 1))]])
    for load, force in (
        ("braking", -rows(patch)[0]),
        ("lateral", rows(patch)[1]),
        ("aligning", np.eye(6)[5]),
    ):
        moved = np.linalg.solve(matrix, [*force, 0.0])[:6]
        shift = rows(patch) @ moved
        assert float(found[f"{load}.patch_x"][0]) == pytest.approx(shift[0], rel=1e-7)
        assert float(found[f"{load}.patch_y"][0]) == pytest.approx(shift[1], rel=1e-7)
        centre = rows(places.wheel_centre) @ moved
        assert float(found[f"{load}.wheel_centre_x"][0]) == pytest.approx(centre[0], rel=1e-7)


def test_mirror_image_yields_alike() -> None:
    rig = on_bushings()
    one, other = jn.compliance(rig, [0.0, 0.02]), jn.compliance(rig.mirrored(), [0.0, 0.02])
    assert other["lateral.camber"].to_numpy() == pytest.approx(
        -one["lateral.camber"].to_numpy(), rel=1e-7
    )
    assert other["lateral.patch_y"].to_numpy() == pytest.approx(
        one["lateral.patch_y"].to_numpy(), rel=1e-7
    )
    assert other["braking.toe"].to_numpy() == pytest.approx(one["braking.toe"].to_numpy(), rel=1e-7)
    assert other["aligning.toe"].to_numpy() == pytest.approx(
        -one["aligning.toe"].to_numpy(), rel=1e-7
    )


def test_what_cannot_be_answered_is_refused() -> None:
    rig = jn.load("reference-double-wishbone")
    with pytest.raises(jn.DescriptionError, match="no bushings"):
        jn.compliance(rig)
    with pytest.raises(jn.DescriptionError, match="vertical"):
        jn.compliance(on_bushings(), load=jn.ContactLoad(vertical_force=1.0))
    with pytest.raises(jn.SimulationError, match="no pose"):
        jn.compliance(on_bushings(), 0.5)
    loose = {"stiffness": [0.0, 0.0, 0.0]}
    free = rig.with_changes({"bushings": {"upper_arm_front": loose, "upper_arm_rear": loose}})
    with pytest.raises(jn.SimulationError, match="leave a motion unconstrained"):
        jn.compliance(free)


def test_springs_beside_the_strut_hold_the_wheel_too() -> None:
    """They are no part of the loads: without their forces the same bushings yield otherwise."""
    beside = RIGS["springs beside the strut"]()
    loose = beside.with_changes(
        {"torsion_bar.stiffness": 1e-6, "torsion_bar.preload": 0.0, "anti_roll_bar.stiffness": 1e-6}
    )
    loose = loose.with_changes(
        {"third_spring.spring.rate": 1e-6, "third_spring.spring.preload": 0.0}
    )
    plain, found, without = (jn.compliance(rig, 0.02) for rig in (on_bushings(), beside, loose))
    for name in ("lateral.patch_y", "braking.patch_x", "lateral.toe"):
        assert without[name].to_numpy() == pytest.approx(plain[name].to_numpy(), rel=1e-6), name
        assert abs(float(found[name][0] / plain[name][0]) - 1.0) > 1e-4, name
