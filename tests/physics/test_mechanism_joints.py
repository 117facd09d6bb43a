"""Every joint twice: as a joint of the tree, and as one that closes the loop of a body that could fly."""

from __future__ import annotations

import dataclasses
from functools import cache

import casadi
import numpy as np
import pytest

import jounce as jn
from jounce.mechanics.joints import Joint

AXIS, SECOND, AT = (0.2, 0.9, -0.3), (0.9, -0.2, 0.0), (0.3, 0.1, 0.2)
HINGE = (0.3, 1.0, 0.1)
PITCH, BALL = 0.4, (0.75, 0.2, 0.3)  # m a turn; the other end of the link
CENTRE, INERTIA = (0.7, 0.25, 0.35), (0.05, 0.08, 0.06, 0.01, -0.005, 0.008)
NUMBERS = {
    "at": AT,
    "axis": AXIS,
    "second_axis": SECOND,
    "second_at": BALL,
    "pitch": PITCH,
    "length": None,
}
NUMBERS |= {"travel": 0.1, "point": tuple(np.array(AT) - np.array(AXIS))}
"""What the fields of joints are here; that of a joint of a new form is added to them."""


def kinds_of(base=Joint):
    """Every class of joint by its kind."""
    found = {}
    for one in base.__subclasses__():
        found |= (
            {one.kind: one} if one.kind and one.__module__.startswith("jounce.") else {}
        ) | kinds_of(one)
    return found


JOINTS = kinds_of()
KINDS = tuple(kind for kind, one in JOINTS.items() if one.hangs and one.closes)
_CAN = {kind: ((False, one.hangs), (True, one.closes)) for kind, one in JOINTS.items()}
ROLES = [(kind, closing) for kind, roles in _CAN.items() for closing, can in roles if can]
SAME_BOTH_WAYS = {
    "revolute",
    "universal",
    "spherical",
    "cylindrical",
    "prismatic",
}  # reactions at the joint are


def give(mechanism, kind, carrier, body, swapped):
    """Join two bodies, the second named first where they are swapped."""
    made, bodies = JOINTS[kind], (body, carrier) if swapped else (carrier, body)
    needed = [one.name for one in dataclasses.fields(made) if "read" in one.metadata]
    lacking = [name for name in needed if name not in NUMBERS]
    assert not lacking, f"say in NUMBERS what {', '.join(lacking)} of a {made.__name__} is"
    numbers = {name: NUMBERS[name] for name in needed}
    if swapped and "second_axis" in numbers:  # the first axis is on the first body
        numbers |= {"axis": SECOND, "second_axis": AXIS}
    mechanism.add(made("J", *bodies, **numbers))


def unit(vector):
    return np.array(vector) / np.linalg.norm(vector)


def reach_of(carrier, body):
    """From the hinge of a link to its ball."""
    return body.point(BALL).value - carrier.point(AT).value


@cache
def model(kind: str, closing: bool, swapped: bool) -> jn.mechanics.Mechanism:
    """A carrier that swings about a hinge, and a body joined to it."""
    mechanism = jn.mechanics.Mechanism()
    carrier = mechanism.body("carrier", 2.0, (0.2, 0.0, -0.1), (0.1, 0.12, 0.09, 0.0, 0.01, 0.0))
    mechanism.revolute("hinge", mechanism.ground, carrier, at=(0.0, 0.0, 0.0), axis=HINGE)
    body = mechanism.body("body", 1.5, CENTRE, INERTIA)
    if closing:
        mechanism.free("flight", body)
    give(mechanism, kind, carrier, body, swapped)
    mechanism.spring_damper(
        "spring", mechanism.ground, body, (0.7, 0.2, 1.2), CENTRE, stiffness=40.0
    )
    mechanism.watch_body(body)
    mechanism.watch_energy()
    fields = {one.name for one in dataclasses.fields(JOINTS[kind])}
    place = (
        BALL if "second_at" in fields else AT if "at" in fields else CENTRE
    )  # the same point, hanging and closing
    mechanism.watch_reaction("J", at=None if kind in SAME_BOTH_WAYS else place)
    mechanism.watch_reaction("hinge")
    found, along = mechanism.reaction("J"), carrier.direction(casadi.SX(unit(AXIS))).value
    mechanism.output(
        "across.force",
        casadi.dot(found.force, casadi.cross(along, reach_of(carrier, body))),
        "N*m",
        "-",
    )
    mechanism.output(
        "along.force", casadi.dot(found.force, along), "N", "force along the joint's axis"
    )
    mechanism.output(
        "along.torque", casadi.dot(found.torque, along), "N*m", "torque along the joint's axis"
    )
    own, other = (
        one.frame.origin.rate + casadi.cross(one.spin, found.point - one.frame.origin.value)
        for one in (body, carrier)
    )
    power = casadi.dot(found.force, own - other) + casadi.dot(
        found.torque, body.spin - carrier.spin
    )
    mechanism.output(
        "J.power",
        power,
        "W",
        "power of the reaction on the motion of the bodies against each other",
    )
    return mechanism


@cache
def run_of(kind: str, closing: bool, swapped: bool = False):
    """Starts with the carrier turning at 1 rad/s and the body with it, as if welded."""
    spin = np.array(HINGE) / np.linalg.norm(HINGE)
    start = {"hinge.angle rate": 1.0}
    if closing:
        start |= {
            f"flight.{axis} rate": speed
            for axis, speed in zip("xyz", np.cross(spin, CENTRE), strict=True)
        }
    if kind == "free" and not closing:
        start |= {
            f"J.{axis} rate": speed for axis, speed in zip("xyz", np.cross(spin, AT), strict=True)
        }
    if closing or JOINTS[kind].has_quaternion:  # its speeds are against the ground
        start |= {
            f"{'flight' if closing else 'J'}.w{axis}": part
            for axis, part in zip("xyz", spin, strict=True)
        }
    mechanism = model(kind, closing, swapped)
    return jn.simulate_mechanism(mechanism, 1.0, start=start, output_step=0.05, tolerance=1e-9)


SWAPPED = [(kind, True) for kind in KINDS if kind not in SAME_BOTH_WAYS]


@pytest.mark.parametrize(("kind", "swapped"), [*((kind, False) for kind in KINDS), *SWAPPED])
@pytest.mark.some(2)
def test_closing_joint_moves_as_the_joint_of_the_tree(kind: str, swapped: bool):
    tree, loop = run_of(kind, False, swapped), run_of(kind, True, swapped)
    for name in tree.data_vars:
        if name.startswith(("body.", "carrier.", "energy.", "hinge.", "J.")):
            np.testing.assert_allclose(loop[name], tree[name], rtol=1e-7, atol=2e-7, err_msg=name)
    assert float(loop["constraint.residual"].max()) < 1e-12


@pytest.mark.parametrize(
    ("kind", "closing"), [("universal", False), ("universal", True), ("prismatic", False)]
)
def test_naming_the_bodies_the_other_way_turns_the_reaction_over(kind: str, closing: bool):
    given, swapped = run_of(kind, closing), run_of(kind, closing, swapped=True)
    for axis in "xyz":
        np.testing.assert_allclose(
            swapped[f"body.{axis}"], given[f"body.{axis}"], rtol=0.0, atol=1e-7
        )
        for name in (f"J.f{axis}", f"J.t{axis}"):
            np.testing.assert_allclose(
                swapped[name], -given[name], rtol=1e-6, atol=1e-6, err_msg=name
            )


@pytest.mark.some(2)
@pytest.mark.parametrize(("kind", "closing"), ROLES)
def test_energy_is_kept_and_the_reaction_does_no_work(kind: str, closing: bool):
    run = run_of(kind, closing)
    total = run["energy.kinetic"] + run["energy.weight"] + run["energy.elastic"]
    size = float(run["energy.kinetic"].max())
    assert float(abs(total - total[0]).max()) < 1e-7 * size
    assert float(abs(run["J.power"]).max()) < 1e-7 * size  # W beside J: they move at some 1 rad/s
    held = max(float(abs(run[f"J.{part}{axis}"]).max()) for part in "ft" for axis in "xyz")
    assert (held > 0.1) == (kind != "free")


def test_every_joint_is_tried_in_every_role():
    assert {kind for kind, _ in ROLES} == set(JOINTS)
    assert len(JOINTS) >= 15


@pytest.mark.parametrize("closing", [False, True])
@pytest.mark.parametrize(
    "kind", ["revolute", "universal", "spherical", "cylindrical", "prismatic", "screw", "link"]
)
def test_joint_holds_nothing_along_what_it_frees(kind: str, closing: bool):
    run = run_of(kind, closing)
    size = max(float(abs(run[f"J.f{axis}"]).max()) for axis in "xyz")
    turns, slides = kind not in ("prismatic", "screw"), kind in ("prismatic", "cylindrical")
    assert size > 1.0
    if kind == "screw":
        lead = run["along.torque"] + PITCH / (2.0 * np.pi) * run["along.force"]
        assert float(abs(lead).max()) < 1e-9 * size
    if kind == "link":
        assert float(abs(run["across.force"]).max()) < 1e-9 * size
    assert (float(abs(run["along.torque"]).max()) < 1e-9 * size) == turns
    assert (float(abs(run["along.force"]).max()) < 1e-9 * size) == slides
    if kind in ("spherical", "link"):
        assert max(float(abs(run[f"J.t{axis}"]).max()) for axis in "xyz") < 1e-9 * size


def nut(pitch):
    """2 kg on a vertical thread without friction, 0.03 kg m^2 about it."""
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("nut", 2.0, (0.0, 0.0, 0.3), (0.02, 0.02, 0.03))
    mechanism.screw(
        "thread", mechanism.ground, body, at=(0.0, 0.0, 0.0), axis=(0.0, 0.0, 1.0), pitch=pitch
    )
    mechanism.watch_coordinates()
    mechanism.watch_body(body)
    mechanism.watch_reaction("thread")
    return mechanism


def test_nut_falls_down_its_thread():
    """With the lead h = pitch / 2 pi it turns at -m g h / (J + m h^2); the thread carries m g J / (J + m h^2)."""
    run = jn.simulate_mechanism(nut("50 mm"), 1.0, output_step=0.1, tolerance=1e-10)
    lead = 0.05 / (2.0 * np.pi)
    turning = -2.0 * 9.81 * lead / (0.03 + 2.0 * lead**2)
    np.testing.assert_allclose(
        run["thread.angle"], 0.5 * turning * run["time"] ** 2, rtol=0.0, atol=1e-9
    )
    np.testing.assert_allclose(run["nut.z"] - 0.3, lead * run["thread.angle"], rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(
        run["thread.fz"], 2.0 * 9.81 * 0.03 / (0.03 + 2.0 * lead**2), rtol=1e-10
    )
    np.testing.assert_allclose(run["thread.tz"], 0.03 * turning, rtol=1e-10)


def test_closing_screw_counts_its_turns():
    """A spindle that a motor turns many times pushes a carriage, which a guide keeps from turning with it."""
    mechanism = jn.mechanics.Mechanism()
    spindle = mechanism.body("spindle", 1.0, (0.0, 0.0, 0.0), (0.01, 0.02, 0.02))
    carriage = mechanism.body("carriage", 3.0, (0.1, 0.1, 0.0), (0.01, 0.01, 0.01))
    turn = mechanism.revolute(
        "bearing", mechanism.ground, spindle, at=(0.0, 0.0, 0.0), axis=(1.0, 0.0, 0.0)
    )
    mechanism.prismatic(
        "guide", mechanism.ground, carriage, axis=(1.0, 0.0, 0.0), at=(0.0, 0.2, 0.0)
    )
    mechanism.screw(
        "thread", spindle, carriage, at=(0.1, 0.0, 0.0), axis=(1.0, 0.0, 0.0), pitch="-4 mm"
    )
    mechanism.motion("motor", turn, mechanism.track("angle"))
    mechanism.watch_coordinates()
    drive = {"angle": jn.mechanics.constant_rate(40.0)}
    run = jn.simulate_mechanism(mechanism, 2.0, motions=drive, redundant="remove", output_step=0.1)
    np.testing.assert_allclose(
        run["guide.distance"], 0.004 * 40.0 * run["time"] / (2.0 * np.pi), rtol=0.0, atol=1e-9
    )
    with pytest.raises(jn.AssemblyError, match="lead: a screw without pitch"):
        mechanism.screw(
            "lead", mechanism.ground, mechanism.body("other"), (0, 0, 0), (1, 0, 0), pitch=0.0
        )
