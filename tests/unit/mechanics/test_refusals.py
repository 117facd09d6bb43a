"""What a mechanism refuses, with names: one clear message each, before anything is compiled."""

from __future__ import annotations

import re

import numpy as np
import pytest

import jounce as jn

Y, ORIGIN = (0.0, 1.0, 0.0), (0.0, 0.0, 0.0)
BALL = (0.1, 0.1, 0.1)
NAN = float("nan")


def pendulum(**changed):
    mechanism = jn.mechanics.Mechanism()
    given = {"mass": 1.0, "centre_of_mass": (1.0, 0.0, 0.0), "inertia": BALL} | changed
    body = mechanism.body("bob", **given)
    mechanism.revolute("pivot", mechanism.ground, body, at=ORIGIN, axis=Y)
    mechanism.watch_body(body)
    return mechanism, body


def flying():
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bob", 1.0, (1.0, 0.0, 0.0), BALL)
    mechanism.free("flight", body)
    return mechanism, body


def refused(text: str):
    """Any of jounce's errors with this text in it."""
    return pytest.raises(jn.JounceError, match=re.escape(text))


@pytest.mark.parametrize(
    ("changed", "text"),
    [
        ({"mass": 0.0}, "bob: not a mass; found '0 kg'"),
        ({"mass": -1.0}, "bob: not a mass; found '-1 kg'"),
        ({"mass": NAN}, "bob.mass: not a finite number"),
        ({"mass": "1 m"}, "bob.mass: wrong unit"),
        ({"centre_of_mass": None}, "bob: a mass without its place"),
        ({"centre_of_mass": (1.0, 0.0)}, "bob.centre_of_mass: not a vector; found '2 numbers'"),
        ({"centre_of_mass": (NAN, 0.0, 0.0)}, "bob.centre_of_mass[0]: not a finite number"),
        ({"inertia": (1.0, 1.0, 3.0)}, "bob: no body has this inertia; found 'principal moments 1, 1, 3 kg m^2'"),
        ({"inertia": (-1.0, 1.0, 1.0)}, "bob: no body has this inertia"),
        ({"inertia": (1.0, 1.0, 1.0, 0.0)}, "bob.inertia: not a tensor of inertia; found '4 numbers'"),
        ({"inertia": np.array([[1.0, 0.1, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])}, "found 'not symmetric'"),
        ({"mass": None}, "bob: a centre of mass or an inertia without a mass"),
    ],
)
def test_masses(changed, text):
    with refused(text):
        mechanism, _ = pendulum(**changed)
        jn.simulate_mechanism(mechanism, 0.1)


@pytest.mark.parametrize(
    ("given", "text"),
    [
        ({"start": {"pivot.angel": 1.0}}, "start: unknown coordinate or speed 'pivot.angel'"),
        ({"start": {"pivot.angel": 1.0}}, "Did you mean 'pivot.angle'?"),
        ({"start": {"pivot.angle": NAN}}, "start: pivot.angle: not a finite number"),
        ({"start": {"pivot.angle": "3 mm"}}, "start: pivot.angle: wrong unit"),
        ({"values": {"bob.mas": 1.0}}, "values: unknown parameter 'bob.mas'"),
        ({"values": {"bob.mass": -2.0}}, "bob: not a mass; found '-2 kg'"),
        ({"values": {"gravity": NAN}}, "values: gravity: not a finite number"),
        ({"values": {"pivot.axis[1]": 0.0}}, "its mass matrix is not finite"),
        ({"motions": {"go": jn.mechanics.constant(0.0)}}, "motions: unknown track 'go'"),
        ({"duration": 0.0}, "duration: not a duration; found '0 s'"),
        ({"duration": -1.0}, "duration: not a duration"),
        ({"duration": "3 kg"}, "duration: wrong unit"),
        ({"output_step": 0.0}, "output_step: not an output step"),
        ({"tolerance": 0.0}, "tolerance: not a tolerance"),
        ({"redundant": "delete"}, "redundant: unknown choice 'delete'"),
    ],
)
def test_what_a_run_is_given(given, text):
    with refused(text):
        jn.simulate_mechanism(pendulum()[0], **({"duration": 0.1} | given))


def test_axes_and_places():
    mechanism, body = pendulum()
    with refused("hinge.axis: an axis without direction"):
        mechanism.revolute("hinge", mechanism.ground, mechanism.body("a"), at=ORIGIN, axis=ORIGIN)
    with refused("slide.axis: not a finite number"):
        mechanism.prismatic("slide", mechanism.ground, mechanism.body("b"), axis=(0.0, NAN, 0.0))
    with refused("ball.at: not a vector; found '2 numbers'"):
        mechanism.spherical("ball", mechanism.ground, mechanism.body("c"), at=(0.0, 0.0))
    with refused("cross: the axes of a universal joint are not at right angles; found '0 degrees between them'"):
        mechanism.universal("cross", mechanism.ground, mechanism.body("d"), at=ORIGIN, axis=Y, second_axis=Y)
    with refused("45 degrees between them"):
        mechanism.universal("other", mechanism.ground, body, at=ORIGIN, axis=Y, second_axis=(0.0, 1.0, 1.0))
    with refused("rail.axis: an axis without direction"):
        mechanism.driven("rail", mechanism.ground, mechanism.body("e"), axis=ORIGIN, travel=mechanism.track("t"))


def test_bodies_that_hang_on_nothing():
    mechanism, body = pendulum()
    one, other = mechanism.body("one", 1.0, ORIGIN, BALL), mechanism.body("other", 1.0, ORIGIN, BALL)
    with refused("hinge: neither body hangs on anything yet; found 'one, other'"):
        mechanism.revolute("hinge", one, other, at=ORIGIN, axis=Y)
    with refused("link: the body hangs on nothing yet; found 'one'"):
        mechanism.rod("link", body, one, ORIGIN, (0.0, 0.0, 1.0))
    with refused("spring: the body hangs on nothing yet; found 'one'"):
        mechanism.spring_damper("spring", body, one, ORIGIN, (0.0, 0.0, 1.0), stiffness=1.0)
    with refused("one: the body hangs on nothing yet"):
        mechanism.watch_point("seen", one, ORIGIN)
    with refused("one: the body hangs on nothing. Give it a joint, or free()."):
        jn.simulate_mechanism(mechanism, 0.1)


def test_names_and_bodies_used_twice():
    mechanism, body = pendulum()
    with refused("bob: the name is used twice"):
        mechanism.body("bob")
    with refused("pivot.at[0]: the name is used twice"):
        mechanism.spherical("pivot", mechanism.ground, mechanism.body("a"), at=ORIGIN)
    with refused("flight: the body hangs already; found 'bob'"):
        mechanism.free("flight", body)
    with refused("rail: both bodies hang already"):
        mechanism.driven("rail", mechanism.ground, body, axis=Y, travel=0.1)
    with refused("weld: both bodies hang already"):
        mechanism.fixed("weld", mechanism.ground, body)
    with refused("hinge: a body cannot be joined to itself; found 'bob'"):
        mechanism.revolute("hinge", body, body, at=ORIGIN, axis=Y)
    with refused("hinge2: the body belongs to another mechanism; found 'bob'"):
        mechanism.revolute("hinge2", mechanism.ground, pendulum()[1], at=ORIGIN, axis=Y)


def test_names_that_are_unknown():
    mechanism, _ = pendulum()
    with refused("reaction: unknown joint 'pivott'"):
        mechanism.watch_reaction("pivott")
    with refused("reaction of pivot: unknown body 'bobb'"):
        mechanism.watch_reaction("pivot", frame="bobb")
    with refused("spring: unknown joint with an angle in the tree 'pivott'"):
        mechanism.rotational_spring_damper("spring", "pivott", stiffness=1.0)


def test_rods_without_length():
    for length, found in ((None, "0 m"), (0.0, "0 m"), (-1.0, "-1 m")):
        mechanism, body = flying()
        with refused(f"rod: a rod without length; found '{found}'"):
            mechanism.rod("rod", mechanism.ground, body, Y, Y, length=length)


def test_motions_of_what_is_no_coordinate():
    mechanism, body = flying()
    forces = mechanism.spherical("ball", mechanism.ground, body, at=(1.0, 0.0, 0.0))  # closes a loop: gives its forces
    track = mechanism.track("go")
    with refused("drive: not one coordinate; found '3 expressions'"):
        mechanism.motion("drive", forces, track)
    with refused("drive: not a condition on coordinates; found 'an expression of ball.x multiplier'"):
        mechanism.motion("drive", forces[0], track)
    with refused("rule: not a condition on coordinates; found 'an expression of no coordinate'"):
        mechanism.condition("rule", track.value)


def test_motions_that_are_none():
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bob", 1.0, ORIGIN, BALL)
    mechanism.motion("drive", mechanism.prismatic("slide", mechanism.ground, body, axis=Y), mechanism.track("go"))
    with refused("go: tracks without a motion"):
        jn.simulate_mechanism(mechanism, 0.1)
    with refused("motions: go: not a motion; found '0.1'"):
        jn.simulate_mechanism(mechanism, 0.1, motions={"go": 0.1})
    with refused("motions: go: not a motion; found 'not a finite number'"):
        jn.simulate_mechanism(mechanism, 0.1, motions={"go": jn.mechanics.constant_rate(NAN)})
    with refused("two finite points or more, ascending in time"):
        jn.mechanics.interpolated([0.0, 1.0, 0.5], [0.0, 1.0, 2.0])
    with refused("two finite points or more, ascending in time"):
        jn.mechanics.interpolated([0.0, 1.0], [0.0, NAN])
    with refused("not a motion; found 'from 1 s to 1 s'"):
        jn.mechanics.step(0.0, 1.0, 1.0, 1.0)


@pytest.mark.parametrize(
    ("start", "text"),
    [
        ({"flight.e0": 0.0}, "flight: no orientation; found 'a quaternion of zeros'"),
        ({"flight.x": "1 deg"}, "start: flight.x: wrong unit"),
        ({"flight.wx": float("inf")}, "start: flight.wx: not a finite number"),
    ],
)
def test_starts_of_a_flight(start, text):
    with refused(text):
        jn.simulate_mechanism(flying()[0], 0.1, start=start)


def test_motions_that_move_no_mass():
    mechanism = jn.mechanics.Mechanism()
    mechanism.free("flight", mechanism.body("point", 1.0, ORIGIN))
    with refused("flight.wx, flight.wy, flight.wz: nothing with mass or inertia moves"):
        jn.simulate_mechanism(mechanism, 0.1)
    mechanism = jn.mechanics.Mechanism()
    mechanism.revolute("pivot", mechanism.ground, mechanism.body("bob"), at=ORIGIN, axis=Y)
    with refused("pivot.angle: nothing with mass or inertia moves"):
        jn.simulate_mechanism(mechanism, 0.1)


def chain(points, *, mass=True, closing="revolute", gap=0.0):
    """Ground, crank, coupler and rocker through four points of the plane; ``gap`` shifts the last hinge on one side."""
    mechanism = jn.mechanics.Mechanism()
    a, b, c, d = (np.array([x, 0.0, z]) for x, z in points)
    crank, rocker = (
        mechanism.body(name, 1.0, 0.5 * (p + q), BALL) for name, p, q in (("crank", a, b), ("rocker", c, d))
    )
    coupler = mechanism.body("coupler", 1.0, 0.5 * (b + c), BALL) if mass else mechanism.body("coupler")
    mechanism.revolute("A", mechanism.ground, crank, at=a, axis=Y)
    mechanism.revolute("B", crank, coupler, at=b, axis=Y)
    mechanism.revolute("D", mechanism.ground, rocker, at=d, axis=Y)
    if closing == "revolute":
        mechanism.revolute("C", coupler, rocker, at=c, axis=Y)
    else:
        mechanism.coincident("C", coupler, rocker, at=c, second_at=c + np.array([gap, 0.0, 0.0]))
    return mechanism


GOOD = ((0.0, 0.0), (0.0, 0.2), (0.4, 0.3), (0.5, 0.0))
FLAT = ((0.0, 0.0), (1.0, 0.0), (3.0, 0.0), (2.0, 0.0))  # a parallelogram with all bars on one line


def test_redundant_hinges_are_named_with_their_loop():
    with refused("C: redundant joints: they repeat each other") as caught:
        jn.simulate_mechanism(chain(GOOD), 0.1)
    text = str(caught.value)
    assert "3 superfluous equations (C.y; C.tilt; C.tilt_2)" in text
    assert all(joint in text.split("in the loop of ")[1] for joint in "ABCD")
    assert 'redundant="remove"' in text


def test_loops_that_cannot_close_are_named():
    with refused("C: the mechanism cannot be assembled; found 'C stays open by 2.") as caught:
        jn.simulate_mechanism(chain(GOOD, closing="point", gap=4.0), 0.1, redundant="remove")
    assert "Check the places of these joints" in str(caught.value)


@pytest.mark.parametrize("redundant", ["refuse", "remove"])
def test_singular_configurations_are_no_place_to_start(redundant):
    with refused("C: the mechanism is in a singular configuration"):
        jn.simulate_mechanism(chain(FLAT, closing="point"), 0.1, redundant=redundant)


def test_massless_links_in_a_loop_are_named():
    with refused("B.angle: nothing with mass or inertia moves when these coordinates change together"):
        jn.simulate_mechanism(chain(GOOD, mass=False), 0.1, redundant="remove")


def test_two_motions_of_one_coordinate_are_named():
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bob", 1.0, ORIGIN, BALL)
    place = mechanism.prismatic("slide", mechanism.ground, body, axis=Y)
    mechanism.motion("one", place, mechanism.track("a"))
    mechanism.motion("two", place, mechanism.track("b"))
    still = jn.mechanics.constant(0.0)
    with refused("one, two: redundant joints: they repeat each other; found '1 superfluous equation (one, two)'"):
        jn.simulate_mechanism(mechanism, 0.1, motions={"a": still, "b": still})


def test_forces_along_what_moves_nothing():
    mechanism, body = pendulum()
    angle, place = mechanism.coordinate_named("pivot.angle"), body.point((1.0, 0.0, 0.0)).value
    other, far = pendulum()
    text = "force: a force along what moves nothing of this mechanism"
    for along in (mechanism.rate_of(angle), other.coordinate_named("pivot.angle"), far.point(ORIGIN).value[2], 3.0):
        with refused(text):
            mechanism.force(along, 100.0)
    with refused("force: as many forces as expressions"):
        mechanism.force(place, 100.0)
    mechanism.force(mechanism.switch("up", angle) * place[2], 100.0)


def test_reactions_that_are_watched_twice():
    mechanism, _ = pendulum()
    for _ in range(2):
        mechanism.watch_reaction("pivot")
    with refused("reaction of pivot: the reaction is watched twice"):
        mechanism.watch_reaction("pivot", frame="bob")


def test_forces_at_points_of_another_body():
    mechanism, body = pendulum()
    other = mechanism.body("other", 1.0, ORIGIN, BALL)
    mechanism.free("flight", other)
    with refused("force on bob: a point of another body; found 'other'"):
        mechanism.apply_force(body, (0.0, 0.0, 5.0), other.point(ORIGIN))
    mechanism.apply_force(body, (0.0, 0.0, 5.0), body.point(ORIGIN))
