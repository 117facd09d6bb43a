"""The double-wishbone template and the twin in absolute coordinates.

A road car's hardpoints (arms not parallel to x), full inertias, the strut on lower arm, upper arm or upright, a wheel
that leaves the road: motion, forces of the elements and forces in every joint agree. Free length and tyre radius are
such that it rests in the design position, found by the twin alone.
"""

from __future__ import annotations

import double_wishbone_twin as twin
import numpy as np
import pytest

import jounce as jn

pytestmark = pytest.mark.usefixtures("optimised")

INERTIA = {
    "lower_arm": (0.08, 0.07, 0.12, 0.008, -0.005, 0.01),
    "upper_arm": (0.03, 0.03, 0.05, -0.003, 0.002, 0.004),
    "upright": (1.1, 1.9, 1.2, 0.05, -0.12, 0.09),
}
STRUTS = {
    "lower_arm": (0.0, 0.64, 0.15),
    "upper_arm": (-0.01, 0.6, 0.39),
    "upright": (0.03, 0.68, 0.33),
}
BUMP = {"height": 0.05, "length": 0.6, "speed": 8.0}
CHANNELS = {
    "zs": "sprung.z",
    "zu": "unsprung.z",
    "as": "sprung.az",
    "au": "unsprung.az",
    "tyre_force": "tyre.force",
    "strut_force": "strut.force",
}
JOINTS = ("lower_arm", "upper_arm", "lower_ball_joint", "upper_ball_joint", "tie_rod")


def described(on: str):
    rig = jn.load("reference-double-wishbone")
    changes = {f"hardpoints.strut_bottom[{i}]": value for i, value in enumerate(STRUTS[on])}
    names = ("xx", "yy", "zz", "xy", "xz", "yz")
    for body, elements in INERTIA.items():
        changes |= {
            f"bodies.{body}.inertia.{name}": value
            for name, value in zip(names, elements, strict=True)
        }
    return rig.with_changes({"strut.on": on, "tyre.lift_off": True, **changes})


def corner(rig, on: str, free_length: float, radius: float):
    """The twin of a rig, with a free length and a tyre radius of its own."""
    names = [
        f"{arm}_{end}"
        for arm in ("lower", "upper")
        for end in ("arm_front", "arm_rear", "ball_joint")
    ]
    names += ["tie_rod_inner", "tie_rod_outer", "wheel_centre", "strut_bottom", "strut_top"]
    points = {name: getattr(rig.hardpoints, name) for name in names}
    bodies = {}
    for name, elements in INERTIA.items():
        body = getattr(rig.bodies, name)
        bodies[name] = (body.mass, body.centre_of_mass, elements)
    bodies["chassis"] = (rig.sprung.mass, (0.0, 0.0, 0.5), (1.0, 1.0, 1.0, 0.0, 0.0, 0.0))
    law = {
        "rate": rig.strut.spring.rate,
        "damping": rig.strut.damper.coefficient,
        "free_length": free_length,
    }
    system = twin.double_wishbone(points, bodies, law, gravity=rig.gravity, strut_on=on)
    return twin.Corner(system, rig.tyre.stiffness, radius, unilateral=True)


def resting(rig, on: str):
    """Twin that rests at design: the tyre carries it all, and the body's acceleration is linear in the free length."""
    weight = rig.gravity * (
        rig.sprung.mass + sum(getattr(rig.bodies, name).mass for name in INERTIA)
    )
    radius = rig.hardpoints.wheel_centre[2] + weight / rig.tyre.stiffness
    tried = [corner(rig, on, length, radius) for length in (0.4, 0.5)]
    rates = [made.channels(made.system.at_design(), 0.0, touching=True)[2] for made in tried]
    return corner(rig, on, 0.4 - 0.1 * rates[0] / (rates[1] - rates[0]), radius)


@pytest.mark.slow
@pytest.mark.parametrize("on", STRUTS)
def test_every_channel_agrees(on: str) -> None:
    rig = described(on)
    made = resting(rig, on)
    free_length = made.system.springs[0][3][2]
    rig = rig.with_changes(
        {"strut.spring": {"rate": rig.strut.spring.rate, "free_length": free_length}}
    )
    rig = rig.with_changes({"tyre.undeformed_radius": made.radius})
    road = jn.HalfSine(height=BUMP["height"], length=BUMP["length"], start=0.1 * BUMP["speed"])
    run = jn.simulate(
        rig, jn.Trial(road=road, speed=BUMP["speed"], duration=0.8), tolerance=1e-10, detail=True
    )
    obstacle = twin.Obstacle(BUMP["height"], BUMP["length"], BUMP["speed"], 0.1)
    expected = made.run(obstacle, run["time"].values, rtol=1e-12, atol=1e-14)
    assert run.attrs["events"] == len(expected["events"]) >= 2
    found = {
        name: float(
            np.abs(run[channel].values - expected[name]).max() / np.abs(expected[name]).max()
        )
        for name, channel in CHANNELS.items()
    }
    for joint in JOINTS:  # forces on the second body: arm, upright, upright end of the rod
        ours, theirs = (
            np.stack([source[f"{joint}.f{x}"] for x in "xyz"]) for source in (run, expected)
        )
        found[joint] = float(np.abs(ours - theirs).max() / np.abs(theirs).max())
    assert {name: value for name, value in found.items() if value > 1e-11} == {}
    assert float(run["constraint.residual"].max()) < 1e-12
