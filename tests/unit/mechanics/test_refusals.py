"""What a mechanism refuses, with names: one clear message each, before anything is compiled."""

from __future__ import annotations

import re
from types import SimpleNamespace

import casadi
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
        ({"mass": 0.0}, "bob: invalid mass; found '0 kg'"),
        ({"mass": -1.0}, "bob: invalid mass; found '-1 kg'"),
        ({"mass": NAN}, "bob.mass: not a finite number"),
        ({"mass": "1 m"}, "bob.mass: wrong unit"),
        ({"centre_of_mass": None}, "bob: a mass without a centre of mass"),
        ({"centre_of_mass": (1.0, 0.0)}, "bob.centre_of_mass: invalid vector; found '2 numbers'"),
        ({"centre_of_mass": (NAN, 0.0, 0.0)}, "bob.centre_of_mass[0]: not a finite number"),
        (
            {"inertia": (1.0, 1.0, 3.0)},
            "bob: impossible inertia; found 'principal moments 1, 1, 3 kg m^2'",
        ),
        ({"inertia": (-1.0, 1.0, 1.0)}, "bob: impossible inertia"),
        (
            {"inertia": (1.0, 1.0, 1.0, 0.0)},
            "bob.inertia: invalid inertia tensor; found '4 numbers'",
        ),
        (
            {"inertia": np.array([[1.0, 0.1, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])},
            "found 'not symmetric'",
        ),
        ({"mass": None}, "bob: a centre of mass or an inertia without a mass"),
        ({"mass": None, "inertia": None}, "bob: a centre of mass or an inertia without a mass"),
        (
            {"mass": None, "centre_of_mass": None},
            "bob: a centre of mass or an inertia without a mass",
        ),
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
        ({"values": {"bob.mass": -2.0}}, "bob: invalid mass; found '-2 kg'"),
        ({"values": {"gravity": NAN}}, "values: gravity: not a finite number"),
        ({"values": {"pivot.axis[1]": 0.0}}, "pivot.axis: an axis without direction"),
        ({"motions": {"go": jn.mechanics.constant(0.0)}}, "motions: unknown track 'go'"),
        ({"duration": 0.0}, "duration: invalid duration; found '0 s'"),
        ({"duration": -1.0}, "duration: invalid duration"),
        ({"duration": "3 kg"}, "duration: wrong unit"),
        ({"output_step": 0.0}, "output_step: invalid output step"),
        ({"tolerance": 0.0}, "tolerance: invalid tolerance"),
        ({"tolerance": NAN}, "tolerance: invalid tolerance"),
        ({"tolerance": "1e-6"}, "tolerance: not a number; found '1e-6'"),
        (
            {"output_step": "1 ms"},
            "output_step: not a number; found '1 ms'; allowed: a number in s",
        ),
        ({"output_step": float("inf")}, "output_step: invalid output step"),
        ({"values": {3: 1.0}}, "values: invalid name; found 'int'"),
        ({"redundant": "delete"}, "redundant: unknown choice 'delete'"),
    ],
)
def test_what_a_run_is_given(given, text):
    with refused(text):
        jn.simulate_mechanism(pendulum()[0], **({"duration": 0.1} | given))


def test_axes_and_places():
    mechanism, body = pendulum()
    with refused(
        "hinge.axis: an axis without direction; found (0.0, 0.0, 0.0); allowed: not all zero"
    ):
        mechanism.revolute("hinge", mechanism.ground, mechanism.body("a"), at=ORIGIN, axis=ORIGIN)
    with refused("slide.axis: not a finite number"):
        mechanism.prismatic("slide", mechanism.ground, mechanism.body("b"), axis=(0.0, NAN, 0.0))
    with refused("ball.at: invalid vector; found '2 numbers'"):
        mechanism.spherical("ball", mechanism.ground, mechanism.body("c"), at=(0.0, 0.0))
    with refused(
        "cross: the axes of a universal joint are not at right angles; found '0 degrees between them'"
    ):
        mechanism.universal(
            "cross", mechanism.ground, mechanism.body("d"), at=ORIGIN, axis=Y, second_axis=Y
        )
    with refused("45 degrees between them"):
        mechanism.universal(
            "other", mechanism.ground, body, at=ORIGIN, axis=Y, second_axis=(0.0, 1.0, 1.0)
        )
    tilt = mechanism.parameter("tilt")  # without a number nothing is known of its angle
    tilted = casadi.vertcat(0.0, casadi.cos(tilt), casadi.sin(tilt))
    mechanism.universal(
        "late", mechanism.ground, mechanism.body("f"), at=ORIGIN, axis=Y, second_axis=tilted
    )
    with refused("rail.axis: an axis without direction"):
        mechanism.driven(
            "rail", mechanism.ground, mechanism.body("e"), axis=ORIGIN, travel=mechanism.track("t")
        )


def test_bodies_that_hang_on_nothing():
    mechanism, body = pendulum()
    one, other = (
        mechanism.body("one", 1.0, ORIGIN, BALL),
        mechanism.body("other", 1.0, ORIGIN, BALL),
    )
    with refused("hinge: neither body is connected to the ground yet; found 'one, other'"):
        mechanism.revolute("hinge", one, other, at=ORIGIN, axis=Y)
    with refused("link: the body has no joint yet; found 'one'"):
        mechanism.rod("link", body, one, ORIGIN, (0.0, 0.0, 1.0))
    with refused("spring: the body has no joint yet; found 'one'"):
        mechanism.spring_damper("spring", body, one, ORIGIN, (0.0, 0.0, 1.0), stiffness=1.0)
    with refused("one: the body has no joint yet"):
        mechanism.watch_point("seen", one, ORIGIN)
    with refused("one: the body has no joint. Give the body a joint, or free()."):
        jn.simulate_mechanism(mechanism, 0.1)


def test_names_and_bodies_used_twice():
    mechanism, body = pendulum()
    with refused("bob: the name is used twice"):
        mechanism.body("bob")
    with refused("pivot.at[0]: the name is used twice"):
        mechanism.spherical("pivot", mechanism.ground, mechanism.body("a"), at=ORIGIN)
    with refused("flight: the body already has a joint; found 'bob'"):
        mechanism.free("flight", body)
    with refused("rail: both bodies already have joints"):
        mechanism.driven("rail", mechanism.ground, body, axis=Y, travel=0.1)
    with refused("weld: both bodies already have joints"):
        mechanism.fixed("weld", mechanism.ground, body)
    with refused("hinge: a body cannot be joined to itself; found 'bob'"):
        mechanism.revolute("hinge", body, body, at=ORIGIN, axis=Y)
    with refused("hinge2: the body belongs to a different mechanism; found 'bob'"):
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
    forces = mechanism.spherical(
        "ball", mechanism.ground, body, at=(1.0, 0.0, 0.0)
    )  # closes a loop: gives its forces
    track = mechanism.track("go")
    with refused("drive: more than one coordinate; found '3 expressions'"):
        mechanism.motion("drive", forces, track)
    with refused(
        "drive: not a condition on coordinates; found 'an expression of ball.x multiplier'"
    ):
        mechanism.motion("drive", forces[0], track)
    with refused("rule: not a condition on coordinates; found 'an expression of no coordinate'"):
        mechanism.condition("rule", track.value)


def test_motions_that_are_none():
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bob", 1.0, ORIGIN, BALL)
    mechanism.motion(
        "drive", mechanism.prismatic("slide", mechanism.ground, body, axis=Y), mechanism.track("go")
    )
    with refused("go: some tracks have no motion"):
        jn.simulate_mechanism(mechanism, 0.1)
    with refused("motions: go: invalid motion; found '0.1'"):
        jn.simulate_mechanism(mechanism, 0.1, motions={"go": 0.1})
    with refused("motions: go: invalid motion; found 'not a finite number'"):
        jn.simulate_mechanism(mechanism, 0.1, motions={"go": jn.mechanics.constant_rate(NAN)})
    with refused("two finite points or more, ascending in time"):
        jn.mechanics.interpolated([0.0, 1.0, 0.5], [0.0, 1.0, 2.0])
    with refused("two finite points or more, ascending in time"):
        jn.mechanics.interpolated([0.0, 1.0], [0.0, NAN])
    with refused("invalid motion; found 'from 1 s to 1 s'"):
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
        mechanism.body(name, 1.0, 0.5 * (p + q), BALL)
        for name, p, q in (("crank", a, b), ("rocker", c, d))
    )
    coupler = (
        mechanism.body("coupler", 1.0, 0.5 * (b + c), BALL) if mass else mechanism.body("coupler")
    )
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
    with refused("C: redundant joints: their constraints are dependent") as caught:
        jn.simulate_mechanism(chain(GOOD), 0.1)
    text = str(caught.value)
    assert "3 superfluous equations (C.y; C.tilt; C.tilt_2)" in text
    assert all(joint in text.split("in the loop of ")[1] for joint in "ABCD")
    assert 'redundant="remove"' in text


def test_loops_that_cannot_close_are_named():
    with refused("C: the mechanism cannot be assembled; found 'C has a gap of 2.") as caught:
        jn.simulate_mechanism(chain(GOOD, closing="point", gap=4.0), 0.1, redundant="remove")
    assert "Check the positions of these joints" in str(caught.value)


@pytest.mark.parametrize("redundant", ["refuse", "remove"])
def test_singular_configurations_are_no_place_to_start(redundant):
    with refused("C: the mechanism is in a singular configuration"):
        jn.simulate_mechanism(chain(FLAT, closing="point"), 0.1, redundant=redundant)


def test_massless_links_in_a_loop_are_named():
    with refused(
        "B.angle: nothing with mass or inertia moves when these coordinates change together"
    ):
        jn.simulate_mechanism(chain(GOOD, mass=False), 0.1, redundant="remove")


def test_two_motions_of_one_coordinate_are_named():
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bob", 1.0, ORIGIN, BALL)
    place = mechanism.prismatic("slide", mechanism.ground, body, axis=Y)
    mechanism.motion("one", place, mechanism.track("a"))
    mechanism.motion("two", place, mechanism.track("b"))
    still = jn.mechanics.constant(0.0)
    with refused(
        "one, two: redundant joints: their constraints are dependent; found '1 superfluous equation (one, two)'"
    ):
        jn.simulate_mechanism(mechanism, 0.1, motions={"a": still, "b": still})


def test_equations_that_repeat_each_other_are_told_in_groups():
    mechanism = jn.mechanics.Mechanism()
    body, other = (mechanism.body(name, 1.0, ORIGIN, BALL) for name in ("bob", "other"))
    places = [
        mechanism.prismatic(f"slide {one.name}", mechanism.ground, one, axis=Y)
        for one in (body, other)
    ]
    still = {}
    for i, place in enumerate((*places, *places, places[0])):
        mechanism.motion(f"drive {i}", place, mechanism.track(f"t{i}"))
        still[f"t{i}"] = jn.mechanics.constant(0.0)
    with refused(
        "redundant joints: their constraints are dependent; found '3 superfluous equations ("
    ) as caught:
        jn.simulate_mechanism(mechanism, 0.1, motions=still)
    groups = [
        set(group.split(", "))
        for group in str(caught.value).split("equations (")[1].split(")")[0].split("; ")
    ]
    first, second = {f"drive {i}" for i in (0, 2, 4)}, {"drive 1", "drive 3"}
    assert sorted(map(len, groups)) == [2, 2, 3]
    assert second in groups
    assert first in groups
    assert all(group <= first or group == second for group in groups)


def test_equations_on_what_cannot_move_are_each_superfluous():
    mechanism, _ = pendulum()
    one, other = (mechanism.body(name, 1.0, ORIGIN, BALL) for name in ("one", "other"))
    for each in (one, other):
        mechanism.fixed(f"weld of {each.name}", mechanism.ground, each)
    mechanism.coincident("peg", one, other, at=ORIGIN)
    with refused(
        "peg: redundant joints: their constraints are dependent; found '3 superfluous equations (peg.x; peg.y; peg.z)"
    ):
        jn.simulate_mechanism(mechanism, 0.1)


def test_loops_that_stay_askew_are_told_in_degrees():
    mechanism, _ = pendulum()
    mechanism.parallel("level", mechanism.ground, mechanism.bodies["bob"], axis=(0.0, 0.0, 1.0))
    mechanism.motion("drive", mechanism.coordinate_named("pivot.angle"), mechanism.track("turn"))
    with refused("the mechanism cannot be assembled") as caught:
        jn.simulate_mechanism(mechanism, 0.1, motions={"turn": jn.mechanics.constant(0.5)})
    askew, missed = (float(re.search(pattern, str(caught.value))[1]) for pattern in
                     (r"level is misaligned by (\S+) degrees", r"drive violates its condition by (\S+) "))  # fmt: skip
    assert np.radians(askew) + missed == pytest.approx(
        0.5, rel=1e-3
    )  # the angle lies between 0 and what is driven
    assert str(caught.value).startswith(
        "level, drive: " if np.radians(askew) > missed else "drive, level: "
    )


def test_loops_that_are_no_numbers_are_named():
    mechanism, body = pendulum()
    along = mechanism.parameter("along")
    mechanism.revolute(
        "hinge", mechanism.ground, body, at=ORIGIN, axis=casadi.vertcat(0.0, along, 0.0)
    )
    model = mechanism.finish()
    p = np.array([mechanism.values.get(name, 0.0) for name in model.parameters])
    with refused("hinge: the loop cannot be computed; found 'not a number'. Check the axes"):
        jn.mechanics.assemble(model, p, np.zeros(0))
    with refused("redundant: unknown choice 'drop'"):
        jn.mechanics.assemble(model, p, np.zeros(0), redundant="drop")


def test_nothing_is_removed_where_nothing_repeats():
    mechanism, body = pendulum()
    arm = mechanism.body("arm", 1.0, (1.0, 0.0, -1.0), BALL)
    mechanism.revolute("elbow", body, arm, at=(1.0, 0.0, 0.0), axis=Y)
    mechanism.rod("rod", mechanism.ground, arm, (1.0, 0.0, -2.0), (1.5, 0.0, -1.0))
    assert mechanism.finish("remove").constraints == mechanism.finish().constraints != ()


def test_forces_along_what_moves_nothing():
    mechanism, body = pendulum()
    angle, place = mechanism.coordinate_named("pivot.angle"), body.point((1.0, 0.0, 0.0)).value
    other, far = pendulum()
    text = (
        "force: the expression moves no part of this mechanism, so a force along it has no effect"
    )
    for along in (
        mechanism.rate_of(angle),
        other.coordinate_named("pivot.angle"),
        far.point(ORIGIN).value[2],
        3.0,
    ):
        with refused(text):
            mechanism.force(along, 100.0)
    with refused("force: the numbers of forces and expressions must be equal"):
        mechanism.force(place, 100.0)
    mechanism.force(mechanism.switch("up", angle) * place[2], 100.0)


@pytest.mark.parametrize(
    ("name", "hint"),
    [(None, ""), (3.0, ""), ("", ""), (" a", ""), ("body", " Give the name, 'bob'.")],
)
def test_a_thing_in_the_place_of_its_name_is_told(name, hint):
    mechanism, body = pendulum()
    with pytest.raises(jn.AssemblyError) as caught:
        mechanism.track(body if name == "body" else name)
    assert str(caught.value).partition("text without leading or trailing blanks.")[2] == hint


def test_what_a_finished_builder_cannot_give():
    given = loaded()
    with refused("n: a body without mass or joint has no outputs"):
        given.m.watch_body(given.m.body("n", 1.0, ORIGIN))
    given.m.free("flight", given.m.bodies["n"])
    with refused("reaction of pivot: unknown body it acts on 'slider'"):
        given.m.reaction("pivot", on="slider")
    given.m.watch_angle("turn", given.b, given.s, Y)
    with refused("turn: the name is used twice"):
        given.m.watch_angle("turn", given.b, given.s, Y)
    given.m.rod(
        "rod", given.m.ground, given.s, ORIGIN, (0.0, 0.0, 1.0), length=given.m.parameter("length")
    )
    with refused("inputs: unknown track 'stop'"):
        given.m.finish("remove", inputs={"stop": 1.0})
    with refused(
        "length: some parameters have no value. Give the values of the parameters in values."
    ):
        given.m.finish("remove")


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
    with refused("force on bob: a point of a different body; found 'other'"):
        mechanism.apply_force(body, (0.0, 0.0, 5.0), other.point(ORIGIN))
    mechanism.apply_force(body, (0.0, 0.0, 5.0), body.point(ORIGIN))


def state_of(mechanism):
    """All that a builder has collected."""
    return mechanism.to_dict(), {
        name: len(part) for name, part in vars(mechanism.collection).items() if part
    }


def loaded():
    """A mechanism m with a pendulum b and on it a slider s at the distance q; another mechanism and its pendulum o."""
    mechanism, body = pendulum()
    slider = mechanism.body("slider", 0.5, ORIGIN, BALL)
    distance = mechanism.prismatic("slide", body, slider, axis=(1.0, 0.0, 0.0))
    mechanism.track("go")
    return SimpleNamespace(m=mechanism, b=body, s=slider, q=distance, o=pendulum())


def symbols(count):
    return casadi.SX.sym("strange", count)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        # points and design places
        (lambda t: t.b.point(casadi.vertcat(t.q, 0, 0)), "point of bob: not a number; found 'an expression of slide"),
        (lambda t: t.b.direction(casadi.vertcat(t.q, 0, 1)), "direction of bob: not a number"),
        (lambda t: t.b.point((1, 0)), "point of bob: invalid vector; found '2 numbers'; allowed: three: x, y, z"),
        (lambda t: t.b.point((NAN, 0, 0)), "point of bob: not a finite number"),
        (lambda t: t.b.point("here"), "point of bob: not a number with a unit"),
        (lambda t: t.b.point(None), "point of bob: not an expression; found 'NoneType'"),
        (lambda t: t.m.rod("rod", t.b, t.m.ground, ORIGIN, (0, 0, 1), length=1 + t.q), "rod.length: not a number"),
        (lambda t: t.m.spherical("ball", t.m.ground, t.s, casadi.vertcat(t.q, 0, 0)), "ball.at: not a number"),
        (lambda t: t.m.revolute("h", t.m.ground, t.m.body("n"), ORIGIN, casadi.vertcat(t.q, 0, 1)), "h.axis: not a n"),
        (lambda t: t.m.watch_point("p", t.b, casadi.vertcat(t.q, 0, 0)), "p.at: not a number"),
        (lambda t: t.m.body("n", 1.0, casadi.vertcat(t.q, 0, 0)), "n.centre_of_mass: not a number"),
        (lambda t: t.m.driven("d", t.m.ground, t.m.body("n"), Y, 2 * t.m.collection.tracks["go"].value), "d.travel: n"),
        # forces and torques
        (lambda t: t.m.apply_force(t.b, (1, 2), ORIGIN), "force on bob: invalid vector; found '2 numbers'"),
        (lambda t: t.m.apply_force(t.b, "5 N", ORIGIN), "force on bob: invalid vector; found '1 numbers'"),
        (lambda t: t.m.apply_force(t.b, ("5 m", 0, 0), ORIGIN), "force on bob: wrong unit; found 'm'"),
        (lambda t: t.m.apply_force(t.b, ORIGIN, (1, 0)), "force on bob: invalid vector"),
        (lambda t: t.m.apply_force("bob", ORIGIN, ORIGIN), "force: not a body; found 'bob'"),
        (lambda t: t.m.apply_force(t.b, ORIGIN, t.m.ground.point(ORIGIN)), "of a different body; found 'ground'"),
        (lambda t: t.m.apply_force(t.b, ORIGIN, t.o[1].point(ORIGIN)), "found 'bob of another mechanism'"),
        (lambda t: t.m.apply_force(t.m.ground, ORIGIN, ORIGIN), "force: the ground does not move"),
        (lambda t: t.m.apply_force(t.o[1], ORIGIN, ORIGIN), "force: the body belongs to a different mechanism"),
        (lambda t: t.m.apply_force(t.b, symbols(3), ORIGIN), "force: a force that cannot be computed"),
        (lambda t: t.m.apply_torque(t.b, (1, 2)), "torque on bob: invalid vector"),
        (lambda t: t.m.apply_torque(t.b, (1, 2, NAN)), "torque on bob: not a finite number"),
        (lambda t: t.m.push_apart(t.b, t.s, ORIGIN, (1, 0), 5.0), "force between points: invalid vector"),
        (lambda t: t.m.push_apart(t.b, t.s, t.s.point(Y), t.s.point(ORIGIN), 5.0), "of a different body; found 's"),
        (lambda t: t.m.push_apart(t.b, t.s, ORIGIN, Y, (1.0, 2.0)), "a single expression is required; found '2 exp"),
        (lambda t: t.m.force(t.q, "5 N*m"), "magnitude of force: wrong unit; found 'N*m'"),
        (lambda t: t.m.force(t.q, None), "magnitude of force: not an expression"),
        (lambda t: t.m.force("slide.distance", 5.0), "force: not a number with a unit"),
        (lambda t: t.m.force(t.q, symbols(1)), "a force that cannot be computed; found 'an expression of strange'"),
        (lambda t: t.m.load(t.m.rate_of(t.q), (1, 2)), "load: the numbers of forces and rates must be equal"),
        (lambda t: t.m.load("rate", 1.0), "rate of load: not a number with a unit"),
        # springs, stops, friction
        (lambda t: t.m.spring_damper("k", t.b, t.s, ORIGIN, Y, stiffness=-1.0), "k.stiffness: out of range; found '-1"),
        (lambda t: t.m.spring_damper("k", t.b, t.s, ORIGIN, Y, damping=-1.0), "k.damping: out of range"),
        (lambda t: t.m.spring_damper("k", t.b, t.s, ORIGIN, Y, free_length="-1 m"), "k.free_length: out of range"),
        (lambda t: t.m.spring_damper("k", t.b, t.s, ORIGIN, Y, stiffness="1 N"), "k.stiffness: wrong unit"),
        (lambda t: t.m.spring_damper("k", t.b, t.s, ORIGIN, Y, stiffness=1.0, force=t.q), "takes no other numbers"),
        (lambda t: t.m.spring_damper("", t.b, t.s, ORIGIN, Y), "spring and damper: invalid name; found ''"),
        (lambda t: t.m.spring_damper("k ", t.b, t.s, ORIGIN, Y), "invalid name; found 'k '"),
        (lambda t: t.m.spring_damper("k", t.b, 3, ORIGIN, Y), "k: not a body; found 'int'"),
        (lambda t: t.m.rotational_spring_damper("r", "pivot", stiffness=-1.0), "r.stiffness: out of range"),
        (lambda t: t.m.rotational_spring_damper("r", t.b), "r: invalid name; found 'Body'; allowed: text without"),
        (lambda t: t.m.stop("end", t.q, stiffness=1e3), "end: a travel stop without limits"),
        (lambda t: t.m.stop("end", t.q, lower=1.0, upper=-1.0, stiffness=1e3), "end: the lower limit of the stop"),
        (lambda t: t.m.stop("end", t.q, upper=1.0, stiffness=0.0), "end.stiffness: out of range; found '0 N/m'"),
        (lambda t: t.m.stop("end", t.q, upper=1.0, stiffness=1.0, damping=-1.0), "end.damping: out of range"),
        (lambda t: t.m.friction("f", t.q, -5.0), "f.force: out of range; found '-5 N'; allowed: at least 0 N"),
        (lambda t: t.m.friction("f", t.q, 5.0, regularisation_rate=0.0), "f.regularisation_rate: out of range"),
        (lambda t: t.m.friction("f", "slide.distance", 5.0), "f: not a number with a unit"),
        (lambda t: jn.mechanics.add_bushing(t.m, "u", t.b, t.s, ORIGIN, (1, -1, 1)), "u.stiffness: out of range"),
        (lambda t: jn.mechanics.add_elastic_rod(t.m, "u", t.b, t.s, ORIGIN, Y, (1, -1, 1)), "u.stiffness: out of ra"),
        # conditions
        (lambda t: t.m.motion("d", t.q, "go"), "d: not a track of this mechanism; found 'go'"),
        (lambda t: t.m.motion("d", t.q, t.o[0].track("go")), "d: not a track of this mechanism"),
        (lambda t: t.m.motion("d", "slide.distance", t.m.collection.tracks["go"]), "d: not a number with a unit"),
        (lambda t: t.m.coupler("c", t.q * t.q), "c: not a linear combination of coordinates; found 'sq(slide.distance"),
        (lambda t: t.m.coupler("", t.q), "invalid name; found ''"),
        (lambda t: t.m.condition("c", None), "c: not an expression; found 'NoneType'"),
        # bodies and joints
        (lambda t: t.m.body("n", -1.0, ORIGIN), "n: invalid mass; found '-1 kg'"),
        (lambda t: t.m.body("n", 1.0, ORIGIN, (1, 1, -1)), "n: impossible inertia"),
        (lambda t: t.m.body("n", 1.0, ORIGIN, 5.0), "n.inertia: invalid inertia tensor; found '1 numbers'"),
        (lambda t: t.m.body("n", 1.0, ORIGIN, casadi.SX(2, 2)), "n.inertia: invalid inertia tensor"),
        (lambda t: t.m.body("n", 1.0, "here"), "n.centre_of_mass: invalid vector"),
        (lambda t: t.m.body(""), "invalid name; found ''"),
        (lambda t: t.m.body(3), "invalid name; found 'int'"),
        (lambda t: t.m.revolute("h", t.b, "slider", ORIGIN, Y), "h: not a body; found 'slider'"),
        (lambda t: t.m.revolute("h", t.m.ground, t.m.body("n"), ORIGIN, None), "h.axis: invalid"),
        (lambda t: t.m.revolute("h", t.m.ground, t.m.body("n"), ORIGIN, (0, 1)), "h.axis: invalid vector"),
        (lambda t: t.m.revolute(None, t.m.ground, t.m.body("n"), ORIGIN, Y), "invalid name; found 'NoneType'"),
        (lambda t: t.m.add("revolute"), "add: not a joint; found 'str'"),
        (lambda t: t.m.act(5.0), "act: not a load; found 'float'"),
        (lambda t: t.m.free("f", t.m.body("n")), "n: a free body without mass. Give mass and centre_of_mass."),
        (lambda t: t.m.watch_body(t.m.body("n")), "n: a body without mass or joint has no outputs"),
        (lambda t: t.m.number("n", symbols(2)), "n: not a number; found '2 expressions'; allowed: one"),
        (lambda t: t.m.moving_frame(t.b, (0, 1)), "field of bob axes: invalid vector"),
        (lambda t: t.m.screw("t", t.m.ground, t.m.body("n"), ORIGIN, Y, pitch=0.0), "t: a screw without pitch"),
        (lambda t: t.m.universal("u", t.m.ground, t.m.body("n"), ORIGIN, Y, (0, 1, 1)), "u: the axes of a universal"),
        # names, signals and what is watched
        (lambda t: t.m.coordinate_named("pivot.angel"), "unknown coordinate 'pivot.angel'"),
        (lambda t: t.m.coordinate_named(3), "coordinate: invalid name; found 'int'"),
        (lambda t: t.m.track(""), "invalid name; found ''"),
        (lambda t: t.m.switch("up", "q"), "switch up: not a number with a unit"),
        (lambda t: t.m.set_internal_rate("z", t.q), "unknown internal state 'z'"),
        (lambda t: t.m.output("out", t.b.point(Y).value, "m", "-"), "out: a single expression is required; found"),
        (lambda t: t.m.output("out", "q", "m", "-"), "output out: not a number with a unit"),
        (lambda t: t.m.watch_reaction("pivot", frame=t.b), "invalid name; found 'Body'"),
        (lambda t: t.m.watch_reaction("pivot", on=t.s), "reaction of pivot: invalid name; found 'Body'"),
        (lambda t: t.m.watch_reaction(t.q), "reaction: invalid name"),
        (lambda t: t.m.watch_reaction("pivot", at=(1, 0)), "pivot.reaction_at: invalid vector"),
        (lambda t: t.m.watch_body(t.o[1]), "watch_body: the body belongs to a different mechanism; found 'bob'"),
        (lambda t: t.m.watch_body("bob"), "watch_body: not a body; found 'bob'"),
        (lambda t: t.m.watch_point("p", t.o[1], ORIGIN), "p: the body belongs to a different mechanism"),
        (lambda t: t.m.watch_point("", t.b, ORIGIN), "invalid name; found ''"),
        (lambda t: t.m.watch_angle("a", t.b, t.s, (0, 1)), "a.axis: invalid vector"),
        (lambda t: t.m.rate_of("q"), "rate: not a number with a unit"),
        # equations
        (lambda t: t.m.finish("foo"), "redundant: unknown choice 'foo'; allowed: keep, remove"),
        (lambda t: t.m.model("foo"), "redundant: unknown choice 'foo'; allowed: refuse, remove"),
        (lambda _: jn.mechanics.Mechanism(gravity="9.81"), "gravity: the unit is missing"),
        (lambda _: jn.mechanics.Mechanism(gravity=symbols(1)), "gravity: not a number"),
    ],
)  # fmt: skip
def test_wrong_arguments_are_refused_and_leave_the_builder_as_it_was(call, text):
    given = loaded()
    before = state_of(given.m)
    with refused(text):
        call(given)
    after = state_of(given.m)
    bare = [
        body for body in after[0]["bodies"] if body != {"name": "n"}
    ]  # made for the call, not by it
    assert (after[0] | {"bodies": bare}, after[1]) == before
    assert set(given.m.bodies) == {"ground", *(body["name"] for body in after[0]["bodies"])}


def test_the_corrected_call_is_taken():
    given = loaded()
    mechanism, body, slider, distance = given.m, given.b, given.s, given.q
    with refused("invalid vector"):
        mechanism.rod("rod", body, slider, (0.0, 0.0, 1.0), (0.0, 1.0))
    mechanism.rod("rod", body, slider, (0.0, 0.0, 1.0), (0.0, 1.0, 0.0))
    with refused("lower limit of the stop is above the upper one"):
        mechanism.stop("end", distance, lower=1.0, upper=0.0, stiffness=1e3)
    mechanism.stop("end", distance, lower=0.0, upper=1.0, stiffness=1e3)
    with refused("invalid mass"):
        mechanism.body("other", 0.0, ORIGIN)
    other = mechanism.body("other", 1.0, ORIGIN)
    with refused("a screw without pitch"):
        mechanism.screw("thread", mechanism.ground, other, ORIGIN, Y, 0.0)
    assert not other.is_placed
    mechanism.screw("thread", mechanism.ground, other, ORIGIN, Y, 0.1)
    with refused("invalid vector"):
        mechanism.coincident("pin", body, other, (0.0, 1.0))
    mechanism.coincident("pin", body, other, (0.0, 1.0, 0.0))


def test_numbers_with_units_are_taken_where_numbers_stand():
    given = loaded()
    mechanism, body, slider, distance = given.m, given.b, given.s, given.q
    mechanism.apply_force(body, ("5 N", 0.0, "2 kN"), ("80 mm", 0.0, 0.0))
    mechanism.apply_torque(body, ("5 N*m", 0.0, 0.0))
    mechanism.force(distance, "3 kN")
    mechanism.push_apart(body, slider, ("80 mm", 0, 0), (0, 0, 1), "1 kN")
    loads = mechanism.to_dict()["loads"]
    assert loads[0]["force"] == [5.0, 0.0, 2000.0]
    assert loads[0]["at"] == [0.08, 0.0, 0.0]
    assert loads[1]["torque"] == [5.0, 0.0, 0.0]
    assert loads[2]["magnitude"] == 3000.0
    assert (loads[3]["at"], loads[3]["force"]) == ([0.08, 0.0, 0.0], 1000.0)


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ({"rod.length": 0.0}, "rod: a rod without length; found '0 m'"),
        ({"rod.length": "-1 mm"}, "rod: a rod without length; found '-0.001 m'"),
        ({"tie.at[2]": 0.0}, "tie: a rod without length; found '0 m'"),
        ({"thread.pitch": 0.0}, "thread: a screw without pitch"),
        (
            {"cross.second_axis[1]": 1.0},
            "cross: the axes of a universal joint are not at right angles",
        ),
        ({"cross.axis[1]": 0.0}, "cross.axis: an axis without direction"),
        ({"spring.stiffness": -3.0}, "spring.stiffness: out of range; found '-3 N/m'"),
        ({"drag.force": -1.0}, "drag.force: out of range"),
        (
            {"end.upper": -2.0},
            "end: the lower limit of the stop is above the upper one; found '-1 to -2 rad'",
        ),
        ({"cross body.mass": 0.0}, "cross body: invalid mass"),
    ],
)
def test_numbers_that_are_changed_for_a_run_are_checked_as_when_they_are_built_in(values, text):
    mechanism = jn.mechanics.Mechanism()
    nut, cross = (
        mechanism.body("nut", 1.0, ORIGIN, BALL),
        mechanism.body("cross body", 1.0, ORIGIN, BALL),
    )
    turn = mechanism.screw("thread", mechanism.ground, nut, ORIGIN, Y, "50 mm")
    mechanism.universal("cross", mechanism.ground, cross, ORIGIN, Y, (1.0, 0.0, 0.0))
    mechanism.rod("rod", nut, cross, ORIGIN, (0.0, 0.0, 1.0), length=1.0)
    mechanism.rod("tie", mechanism.ground, cross, (0.0, 0.0, -1.0), ORIGIN)
    mechanism.spring_damper("spring", nut, cross, ORIGIN, Y, stiffness=3.0)
    mechanism.friction("drag", turn, 0.1)
    mechanism.stop("end", turn, lower=-1.0, upper=1.0, stiffness=1e3)
    with refused(text):
        jn.simulate_mechanism(mechanism, 0.1, values=values)


def test_equations_of_one_name_are_said_with_both_joints():
    mechanism, body = flying()
    mechanism.coincident("tie", mechanism.ground, body, ORIGIN)
    with refused("tie.x: an equation with this name already exists; found 'tie.x of tie'"):
        mechanism.rod("tie.x", mechanism.ground, body, ORIGIN, Y)
    mechanism.rod("other", mechanism.ground, body, ORIGIN, Y)


@pytest.mark.parametrize("order", ["body first", "coordinates first", "joint last"])
def test_signals_of_one_name_are_refused_when_they_are_asked_for(order):
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bob", 1.0, ORIGIN, BALL)
    text = "bob: its coordinates have the same signal names as a watched body or point"
    if order == "joint last":
        other = mechanism.body("other", 1.0, ORIGIN, BALL)
        mechanism.free("flight", other)
        mechanism.watch_point("bob", other, Y)
        mechanism.watch_coordinates()
        with refused(text):
            mechanism.free("bob", body)
        mechanism.free("flight of bob", body)
    else:
        mechanism.free("bob", body)
        first, second = (mechanism.watch_coordinates, lambda: mechanism.watch_body(body))[
            :: 1 if order[0] == "c" else -1
        ]
        first()
        with refused(text):
            second()
    jn.mechanics.assemble(
        mechanism.finish(), np.array(list(mechanism.values.values())), np.zeros(0)
    )


def test_an_output_of_another_mechanism_is_said_before_anything_is_compiled():
    given = loaded()
    given.m.output("strange", given.o[0].coordinate_named("pivot.angle"), "rad", "-")
    with refused(
        "output strange: the expression contains symbols that this mechanism does not have; found 'pivot.angle'"
    ):
        given.m.finish()


def test_an_elastic_rod_whose_ends_are_one_point_is_refused():
    mechanism, body = pendulum()
    both = (mechanism.ground, body, (1.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    with refused(
        "both ends coincide, so its force has no direction; found '0 m in the design pose'"
    ):
        jn.mechanics.add_elastic_rod(mechanism, "stay", *both, stiffness=(1e6, 1e6, 1e6))


@pytest.mark.parametrize("what", ["spring", "push", "values"])
def test_a_spring_whose_ends_are_one_point_at_the_start_is_refused(what):
    """It took 2.6 million steps to turn over."""
    mechanism, body = pendulum()
    at, values = (1.0, 0.0, 0.0), {}
    if what == "spring":
        mechanism.spring_damper(
            "coil", mechanism.ground, body, at, at, stiffness=1e4, free_length=0.2
        )
    elif what == "push":
        mechanism.push_apart(mechanism.ground, body, at, at, force=10.0)
    else:
        mechanism.spring_damper(
            "coil", mechanism.ground, body, (1.0, 0.0, 0.5), at, stiffness=1e4, free_length=0.5
        )
        values = {"coil.at[2]": 0.0}
    with refused("both ends coincide, so its force has no direction; found '0 m at the start'"):
        jn.simulate_mechanism(mechanism, 0.1, values=values)


def test_a_spring_may_have_its_ends_in_one_point_elsewhere():
    mechanism, body = pendulum()
    at = (1.0, 0.0, 0.0)
    mechanism.spring_damper("coil", mechanism.ground, body, at, at, stiffness=1e2, free_length=0.2)
    assert jn.simulate_mechanism(mechanism, 0.01, start={"pivot.angle": 0.5}).sizes["time"] > 1
