"""Every joint twice: as a joint of the tree, and as one that closes the loop of a body that could fly."""

from __future__ import annotations

from functools import cache

import casadi
import numpy as np
import pytest

import jounce as jn

KINDS = ("revolute", "universal", "spherical", "cylindrical", "prismatic")
AXIS, SECOND, AT = (0.2, 0.9, -0.3), (0.9, -0.2, 0.0), (0.3, 0.1, 0.2)
HINGE = (0.3, 1.0, 0.1)
CENTRE, INERTIA = (0.7, 0.25, 0.35), (0.05, 0.08, 0.06, 0.01, -0.005, 0.008)


def give(mechanism, kind, carrier, body, swapped):
    bodies, axes = (carrier, body), (AXIS, SECOND)
    if swapped:
        bodies, axes = bodies[::-1], axes[::-1]
    if kind == "universal":  # its first axis is on the first body
        mechanism.universal("J", *bodies, at=AT, axis=axes[0], second_axis=axes[1])
    elif kind == "spherical":
        mechanism.spherical("J", *bodies, at=AT)
    else:
        getattr(mechanism, kind)("J", *bodies, at=AT, axis=AXIS)


def unit(vector):
    return np.array(vector) / np.linalg.norm(vector)


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
    mechanism.spring_damper("spring", mechanism.ground, body, (0.7, 0.2, 1.2), CENTRE, stiffness=40.0)
    mechanism.watch_body(body)
    mechanism.watch_energy()
    mechanism.watch_reaction("J")
    mechanism.watch_reaction("hinge")
    found, along = mechanism.reaction("J"), carrier.direction(casadi.SX(unit(AXIS))).value
    mechanism.output("along.force", casadi.dot(found.force, along), "N", "force along the joint's axis")
    mechanism.output("along.torque", casadi.dot(found.torque, along), "N*m", "torque along the joint's axis")
    return mechanism


@cache
def run_of(kind: str, closing: bool, swapped: bool = False):
    """Starts with the carrier turning at 1 rad/s and the body with it, as if welded."""
    spin = np.array(HINGE) / np.linalg.norm(HINGE)
    start = {"hinge.angle rate": 1.0}
    if closing:
        start |= {f"flight.{axis} rate": speed for axis, speed in zip("xyz", np.cross(spin, CENTRE), strict=True)}
    if closing or kind == "spherical":  # its speeds are against the ground
        start |= {f"{'flight' if closing else 'J'}.w{axis}": part for axis, part in zip("xyz", spin, strict=True)}
    mechanism = model(kind, closing, swapped)
    return jn.simulate_mechanism(mechanism, 1.0, start=start, output_step=0.05, tolerance=1e-9)


@pytest.mark.parametrize("kind", KINDS)
def test_closing_joint_moves_as_the_joint_of_the_tree(kind: str):
    tree, loop = run_of(kind, False), run_of(kind, True)
    for name in tree.data_vars:
        if name.startswith(("body.", "carrier.", "energy.", "hinge.", "J.")):
            np.testing.assert_allclose(loop[name], tree[name], rtol=1e-7, atol=2e-7, err_msg=name)
    assert float(loop["constraint.residual"].max()) < 1e-12


@pytest.mark.parametrize(("kind", "closing"), [("universal", False), ("universal", True), ("prismatic", False)])
def test_naming_the_bodies_the_other_way_turns_the_reaction_over(kind: str, closing: bool):
    given, swapped = run_of(kind, closing), run_of(kind, closing, swapped=True)
    for axis in "xyz":
        np.testing.assert_allclose(swapped[f"body.{axis}"], given[f"body.{axis}"], rtol=0.0, atol=1e-7)
        for name in (f"J.f{axis}", f"J.t{axis}"):
            np.testing.assert_allclose(swapped[name], -given[name], rtol=1e-6, atol=1e-6, err_msg=name)


@pytest.mark.parametrize("closing", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_energy_is_kept(kind: str, closing: bool):
    run = run_of(kind, closing)
    total = run["energy.kinetic"] + run["energy.weight"] + run["energy.elastic"]
    assert float(abs(total - total[0]).max()) < 1e-7 * float(run["energy.kinetic"].max())


@pytest.mark.parametrize("closing", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_joint_holds_nothing_along_what_it_frees(kind: str, closing: bool):
    run = run_of(kind, closing)
    size = max(float(abs(run[f"J.f{axis}"]).max()) for axis in "xyz")
    turns, slides = kind != "prismatic", kind in ("prismatic", "cylindrical")
    assert size > 1.0
    assert (float(abs(run["along.torque"]).max()) < 1e-9 * size) == turns
    assert (float(abs(run["along.force"]).max()) < 1e-9 * size) == slides
    if kind == "spherical":
        assert max(float(abs(run[f"J.t{axis}"]).max()) for axis in "xyz") < 1e-9 * size
