"""Mechanisms of one body against ADAMS: positions, velocities, accelerations and what the joints carry.

Source: results of MSC ADAMS in the tests of Project Chrono (see ``tests/files/adams``). What the files mean was worked
out from them alone, with ``F = m (a - g)`` the force that everything but gravity puts on the body and ``T(p)`` its
torque about a point p (Euler's equations); ``test_meaning_of_the_files`` holds it to the files' digits. All vectors are
in ground axes, Avel and Aacc too; Quat turns body axes into ground axes.

| case | force file | torque file | about |
|---|---|---|---|
| revolute | -F, on the ground | -T | joint |
| spherical | -F, on the ground | -T = 0 | joint |
| cylindrical | -F, on the ground | -T | the joint's place on the ground, also when the body has slid away |
| distance | -F, on the ground | 0 | - |
| rotational spring | -F, on the ground | -T, the spring's torque with it | joint |
| translational spring | -F, on the ground: the spring's force | 0 | - |
| linear actuator, A | along the slide, **on the body** | 0 | - |
| linear actuator, P | across the slide, on the ground; F = A - P | -T | the joint's place on the ground |

The files hold 7 digits; integration errors of ADAMS are larger. Limits are a little above the differences found, and
those were the same with our tolerance 100 times looser, so they are the files'.
"""

from __future__ import annotations

import json
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

import jounce as jn

pytestmark = pytest.mark.source(
    kind="program",
    of="mechanisms in space",
    key="msc-adams",
    where="16 cases in the tests of Project Chrono, tests/files/adams",
    tolerance="seven digits of the files, and the errors of that integration",
)

FILES = Path(__file__).parents[1] / "files" / "adams"
CASES = json.loads((FILES / "cases.json").read_text(encoding="utf-8"))
NAMES = sorted(file.stem for file in FILES.glob("*.npz"))
GRAVITY = 9.80665
WEIGHT = np.array([0.0, 0.0, -GRAVITY])
# Joints whose case in cases.json has another word
WORDS = {
    "Revolute": "revolute",
    "Spherical": "spherical",
    "Cylindrical": "cylindrical",
    "Distance": "distance",
    "LinActuator": "lin_actuator",
    "RotSpring": "rotspring",
    "TranSpring": "transpring",
}
# Limits on the largest difference over the largest value of the case (of what vanishes: over the weight or gravity);
# what is found is half to two thirds of it. ADAMS's first spherical case is itself 8.4e-4 m off its revolute twin.
QUANTITIES = (
    "position",
    "orientation",
    "velocity",
    "acceleration",
    "spin",
    "spin rate",
    "force",
    "torque",
)
LIMITS = {
    "Cylindrical_Case01": (6e-6, 1e-12, 2e-6, 1e-12, 1e-12, 1e-12, 1e-12, 1e-12),
    "Cylindrical_Case02": (4e-6, 3e-6, 2e-6, 1e-4, 3e-6, 2e-4, 4e-5, 1e-12),
    "Cylindrical_Case03": (5e-6, 2e-5, 8e-6, 2e-4, 1e-5, 4e-4, 8e-5, 7e-5),
    "Distance_Case01": (4e-7, 1e-12, 2e-7, 1e-4, 1e-12, 1e-12, 8e-5, 0.0),
    "Distance_Case02": (6e-6, 4e-5, 6e-5, 2e-5, 1e-4, 2e-4, 1e-5, 0.0),
    "Distance_Case03": (3e-7, 2e-5, 2e-7, 1e-4, 2e-6, 5e-5, 6e-5, 0.0),
    "LinActuator_Case01": (1e-12, 1e-12, 1e-12, 1e-12, 1e-12, 1e-12, 1e-12, 1e-12),
    "LinActuator_Case02": (6e-6, 1e-12, 4e-6, 1e-12, 1e-12, 1e-12, 2e-6, 6e-6),
    "Revolute_Case01": (4e-6, 3e-6, 2e-6, 1e-4, 3e-6, 2e-4, 4e-5, 1e-12),
    "Revolute_Case02": (8e-6, 2e-5, 1e-5, 2e-4, 1e-5, 4e-4, 8e-5, 2e-4),
    "RotSpring_Case01": (1e-6, 1e-6, 2e-5, 2e-4, 2e-5, 2e-4, 8e-5, 8e-6),
    "RotSpring_Case02": (6e-7, 7e-7, 4e-6, 4e-4, 4e-6, 3e-4, 3e-4, 2e-6),
    "Spherical_Case01": (6e-4, 6e-4, 6e-4, 8e-4, 5e-4, 7e-4, 7e-4, 1e-12),
    "Spherical_Case02": (3e-6, 3e-6, 2e-6, 1e-4, 3e-6, 2e-4, 4e-5, 1e-12),
    "TranSpring_Case01": (5e-6, 1e-12, 3e-6, 1e-6, 1e-12, 1e-12, 5e-6, 0.0),
    "TranSpring_Case02": (4e-7, 1e-12, 2e-7, 4e-7, 1e-12, 1e-12, 4e-7, 0.0),
}


class Recorded:
    """One case as in its files."""

    def __init__(self, name: str) -> None:
        self.name, _, number = name.partition("_")
        with np.load(FILES / f"{name}.npz") as stored:
            self.files = {kind: stored[kind] for kind in stored}
        self.case = CASES[WORDS[self.name]].get(number, {})
        self.case = self.case if isinstance(self.case, dict) else {"law": self.case}
        self.inertia = np.eye(3) if self.name == "LinActuator" else np.diag([0.04, 0.1, 0.1])
        self.turned = matrices(self.files["Quat"])
        self.place = np.array(self.case.get("jointLoc", (0.0, 0.0, 0.0)), dtype=float)

    def __getitem__(self, kind: str):
        return self.files[kind]

    @property
    def design_inertia(self):
        tensor = self.turned[0] @ self.inertia @ self.turned[0].T
        return np.round((tensor + tensor.T) / 2.0, 12)

    def force(self):
        """Force on the body from everything but gravity, from its acceleration."""
        return self["Acc"] - WEIGHT

    def torque(self):
        """Torque of the same about the joint's place on the ground, from Euler's equations."""
        inertia = self.turned @ self.inertia @ self.turned.transpose(0, 2, 1)
        spin, rate = self["Avel"], self["Aacc"]
        own = times(inertia, rate) + np.cross(spin, times(inertia, spin))
        return own + np.cross(self["Pos"] - self.place, self.force())


def matrices(quaternions):
    w, x, y, z = (quaternions / np.linalg.norm(quaternions, axis=1)[:, None]).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.array(rows).transpose(2, 0, 1)


def times(matrix, vector):
    return np.einsum("nij,nj->ni", matrix, vector)


def difference(got, expected, scale: float | None = None) -> float:
    scale = np.abs(expected).max() if scale is None else scale
    return float(np.abs(got - expected).max() / max(scale, 1e-9))


@pytest.mark.no_source
@pytest.mark.parametrize("name", NAMES)
def test_meaning_of_the_files(name: str) -> None:
    """The table above, from the files alone."""
    case = Recorded(name)
    weight = np.linalg.norm(WEIGHT)
    if case.name == "LinActuator":
        slide = case.turned[0] @ np.array([0.0, 0.0, 1.0])
        along = np.outer(case.force() @ slide, slide)
        assert difference(case["RforceA"], along, weight) < 2e-6
        assert difference(case["RforceP"], along - case.force(), weight) < 1e-6
        assert (
            difference(case["RtorqueP"], -case.torque(), max(np.abs(case.torque()).max(), weight))
            < 1e-5
        )
        assert np.abs(case["RtorqueA"]).max() == 0.0
        return
    assert difference(case["Rforce"], -case.force(), max(np.abs(case.force()).max(), weight)) < 5e-6
    if case.name in {"Distance", "TranSpring"}:
        assert np.abs(case["Rtorque"]).max() == 0.0
    else:
        scale = max(np.abs(case["Rtorque"]).max(), 2.0 * weight)
        assert difference(case["Rtorque"], -case.torque(), scale) < 2e-5
    spin = np.gradient(case.turned, case["time"], axis=0) @ case.turned.transpose(0, 2, 1)
    spin = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], axis=1)
    typical = np.median(
        np.abs(spin - case["Avel"])[1:-1]
    )  # central differences over 0.01 s, some turn 34 rad/s
    assert typical <= 0.01 * np.abs(case["Avel"]).max()


# --- the same cases in jounce -----------------------------------------------------------------------------------------


def built(case: Recorded):
    """Mechanism, motions, and the outputs of force and torque on the body as (name, sign) or None."""
    made = jn.mechanics.Mechanism(gravity=GRAVITY)
    ground, centre = made.ground, case["Pos"][0]
    bob = made.body("bob", mass=1.0, centre_of_mass=centre, inertia=case.design_inertia)
    axis = case.turned[0] @ np.array([0.0, 0.0, 1.0])
    motions = None
    match case.name:
        case "Revolute" | "RotSpring":
            made.revolute("joint", ground, bob, at=case.place, axis=axis)
        case "Spherical":
            made.spherical("joint", ground, bob, at=case.place)
        case "Cylindrical":
            made.cylindrical("joint", ground, bob, at=case.place, axis=axis)
        case "Distance":
            made.free("flight", bob)
            made.rod(
                "joint", ground, bob, at=case.case["ground_pt"], second_at=case.case["body_pt"]
            )
        case "TranSpring":
            made.free("flight", bob)
            law = {
                "stiffness": case.case["k"],
                "damping": case.case["c"],
                "free_length": case.case["L0"],
            }
            _, push = made.spring_damper(
                "spring", ground, bob, case.case["ground_pt"], case.case["body_pt"], **law
            )
            made.output("spring push", push, "N", "force of the spring")
        case "LinActuator":
            slide = made.prismatic("joint", ground, bob, axis=axis, at=case.place)
            track = made.track("drive")
            made.output(
                "actuator", made.motion("actuator", slide, track), "N", "force of the drive"
            )
            motions = {"drive": jn.mechanics.constant_rate(case.case["speed_m_s"])}
    if case.name == "RotSpring":
        law = {"stiffness": 200.0, "damping": 10.0}
        if "|angle|" in case.case["law"]:
            angle = made.coordinate_named("joint.angle")
            law = {"torque": -(50.0 + 10.0 * ca.fabs(angle)) * angle - 10.0 * made.rate_of(angle)}
        made.output(
            "spring torque",
            made.rotational_spring_damper("spring", "joint", **law),
            "N*m",
            "spring's torque",
        )
    made.watch_body(bob)
    for i, name in enumerate(("along x", "along y", "along z")):
        made.watch_point(name, bob, centre + np.eye(3)[i])
    if case.name != "TranSpring":
        made.watch_reaction("joint")
    return made, motions


def vector(run, *names: str):
    return np.stack([run[name].values for name in names], axis=1)


def compared(case: Recorded) -> dict[str, float]:
    made, motions = built(case)
    start = (
        {"joint.distance rate": motions["drive"].evaluate(np.zeros(1))[1][0]} if motions else None
    )
    run = jn.simulate_mechanism(
        made, "5 s", start=start, motions=motions, output_step=0.01, tolerance=1e-8
    )
    scale = max(np.abs(case["Acc"]).max(), GRAVITY)
    place = vector(run, "bob.x", "bob.y", "bob.z")
    axes = [vector(run, f"along {a}.x", f"along {a}.y", f"along {a}.z") - place for a in "xyz"]
    turned = np.stack(axes, axis=2) @ case.turned[0]
    found = {
        "position": difference(place, case["Pos"]),
        "orientation": difference(turned, case.turned, 1.0),
        "velocity": difference(vector(run, "bob.vx", "bob.vy", "bob.vz"), case["Vel"]),
        "acceleration": difference(vector(run, "bob.ax", "bob.ay", "bob.az"), case["Acc"], scale),
        "spin": difference(vector(run, "bob.wx", "bob.wy", "bob.wz"), case["Avel"]),
        "spin rate": difference(
            vector(run, "bob.alpha_x", "bob.alpha_y", "bob.alpha_z"), case["Aacc"]
        ),
    }
    return found | carried(case, run, place)


def carried(case: Recorded, run, place) -> dict[str, float]:
    """Differences of force and torque, ours on the body at the joint as the files have them."""
    weight = np.linalg.norm(WEIGHT)
    if case.name == "TranSpring":
        reach = place - np.array(case.case["ground_pt"])  # the spring's end is the centre of mass
        length = np.maximum(np.linalg.norm(reach, axis=1), 1e-12)
        force = run["spring push"].values[:, None] * reach / length[:, None]
        return {
            "force": difference(-force, case["Rforce"], max(np.abs(case["Rforce"]).max(), weight))
        }
    force = vector(run, "joint.fx", "joint.fy", "joint.fz")
    torque = vector(run, "joint.tx", "joint.ty", "joint.tz")
    axis = case.turned[0] @ np.array([0.0, 0.0, 1.0])
    if case.name == "RotSpring":
        torque = torque + np.outer(run["spring torque"], axis)
    if case.name in {"Cylindrical", "LinActuator"}:  # ours is given where the body has slid to
        torque = torque + np.cross(np.outer((place - place[0]) @ axis, axis), force)
    if case.name == "LinActuator":
        along = np.outer(run["actuator"], axis)
        across = difference(along - force, case["RforceP"], weight)
        found = {"force": max(across, difference(along, case["RforceA"], weight))}
        return found | {
            "torque": difference(
                -torque, case["RtorqueP"], max(np.abs(case["RtorqueP"]).max(), weight)
            )
        }
    found = {"force": difference(-force, case["Rforce"], max(np.abs(case["Rforce"]).max(), weight))}
    if case.name != "Distance":
        found["torque"] = difference(
            -torque, case["Rtorque"], max(np.abs(case["Rtorque"]).max(), 2.0 * weight)
        )
    return found


@pytest.mark.parametrize("name", NAMES)
def test_motion_and_reactions_are_those_of_adams(name: str) -> None:
    found = compared(Recorded(name))
    limits = dict(zip(QUANTITIES, LIMITS[name], strict=True))
    assert found == {key: pytest.approx(0.0, abs=limits[key]) for key in found}


@pytest.mark.no_source
def test_a_wrong_inertia_would_be_noticed() -> None:
    """The same comparison with an inertia 1 % off: the pendulum swings another way by far more than the limits."""
    case = Recorded("Revolute_Case02")
    case.inertia = 1.01 * case.inertia
    assert compared(case)["position"] > 10.0 * LIMITS["Revolute_Case02"][0]
