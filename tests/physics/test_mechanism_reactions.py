"""Reactions beside loads of every kind: each body alone, under all that is shown to act on it, moves as it does."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

import jounce as jn
from jounce.mechanics import assemble

X, Y, Z, ORIGIN = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)
GRAVITY = 9.81


def signals(mechanism, start, *, inputs=None, values=None):
    """Outputs at a state near ``start`` that closes the loops, by name; nothing is compiled."""
    model = mechanism.finish()
    p = np.array([{**mechanism.values, **(values or {})}[path] for path in model.parameters])
    u = np.zeros(model.u.shape[0])
    for name, value in (inputs or {}).items():
        first = model.tracks.index(name) * model.track_order
        u[first : first + len(value)] = value
    x = assemble(model, p, u, start).x
    modes = (
        ca.Function("switch", [model.x, model.u, model.p], [model.switch])(x, u, p).full()[:, 0]
        > 0.0
    )
    found = ca.Function("output", [model.x, model.u, model.p, model.m], [model.output])(
        x, u, p, modes
    ).full()[:, 0]
    return {output.name: float(value) for output, value in zip(model.outputs, found, strict=True)}


def vector(found, name, letter):
    return np.array([found[f"{name}.{letter}{axis}"] for axis in "xyz"])


def trailing_arm(kind: str):
    """An arm on a slanted hinge with a spring to the ground, given in one of three ways."""
    mechanism = jn.mechanics.Mechanism()
    arm = mechanism.body("arm", 18.0, (-0.35, 0.05, -0.02), (0.6, 0.9, 0.6))
    mechanism.revolute("hinge", mechanism.ground, arm, at=ORIGIN, axis=(0.2, 1.0, 0.0))
    top, bottom = (-0.28, 0.03, 0.3), (-0.3, 0.02, 0.0)
    if kind == "spring_damper":
        mechanism.spring_damper(
            "spring", mechanism.ground, arm, top, bottom, stiffness=20e3, damping=1500.0
        )
    else:
        one, other = mechanism.ground.point(top), arm.point(bottom)
        length = ca.norm_2(other.value - one.value)
        design = float(np.linalg.norm(np.array(top) - bottom))
        force = -20e3 * (length - design) - 1500.0 * mechanism.rate_of(length)
        if kind == "force":
            mechanism.force(length, force)
        else:
            mechanism.spring_damper("spring", mechanism.ground, arm, top, bottom, force=force)
    mechanism.watch_reaction("hinge")
    return mechanism


def test_a_force_along_a_length_loads_the_hinge_as_the_spring_does():
    start = {"hinge.angle": 0.2, "hinge.angle rate": 1.0}
    given, own, law = (
        signals(trailing_arm(kind), start) for kind in ("spring_damper", "force", "law")
    )
    axis = np.array([0.2, 1.0, 0.0]) / np.linalg.norm([0.2, 1.0, 0.0])
    assert abs(vector(own, "hinge", "t") @ axis) < 1e-10
    for name, value in given.items():
        assert own[name] == pytest.approx(value, rel=1e-10, abs=1e-9), name
        assert law[name] == pytest.approx(value, rel=1e-10, abs=1e-9), name


# a mechanism with a bit of everything ---------------------------------------------------------------------------

BODIES = {
    "arm": (4.0, (0.3, 0.1, 0.05), (0.1, 0.2, 0.15, 0.01, 0.0, -0.02)),
    "wrist": (2.0, (0.7, 0.15, 0.1), (0.05, 0.04, 0.06)),
    "slider": (1.5, (0.9, 0.2, 0.4), (0.02, 0.02, 0.03)),
    "nut": (3.0, (-0.2, 0.3, 0.2), (0.03, 0.05, 0.04, 0.0, 0.005, 0.0)),
    "ball": (1.0, (-0.5, 0.4, 0.5), (0.02, 0.03, 0.02)),
}
JOINTS = {  # first, second, at, axis
    "shoulder": ("ground", "arm", (0.0, 0.0, 0.1), (0.3, 1.0, 0.1)),
    "cross": ("arm", "wrist", (0.6, 0.15, 0.1), (1.0, 0.0, 0.0)),
    "slide": ("wrist", "slider", (0.8, 0.2, 0.2), (0.1, 0.2, 1.0)),
    "thread": ("nut", "ground", (-0.2, 0.2, 0.1), (0.0, 0.3, 1.0)),
    "tie": ("nut", "ball", (-0.25, 0.35, 0.3), (0.0, 1.0, 0.2)),
}
PITCH = 0.05
NODES = {
    "a": ("arm", (0.4, 0.0, 0.1)),
    "s": ("slider", (0.95, 0.1, 0.5)),
    "n": ("nut", (-0.3, 0.2, 0.4)),
}
NODES["b"] = ("ball", (-0.45, 0.35, 0.55))
START = {
    "shoulder.angle": 0.3,
    "cross.angle": -0.2,
    "cross.second_angle": 0.4,
    "slide.distance": 0.03,
}
START |= {"thread.angle": 0.5, "tie.angle": 0.3, "tie.e1": 0.2, "tie.e3": -0.1}
START |= {
    "shoulder.angle rate": 1.0,
    "cross.angle rate": 2.0,
    "slide.distance rate": -0.3,
    "tie.wx": 1.0,
}


def stretch(a, s, n, norm, dot):
    """Some expression of three points and a direction."""
    return norm(a - s) * 0.7 + norm(s - n) ** 2 + 0.3 * dot(a, n)


def everything(*, extra: bool):
    mechanism = jn.mechanics.Mechanism(gravity=GRAVITY)
    bodies = {"ground": mechanism.ground} | {
        name: mechanism.body(name, *given) for name, given in BODIES.items()
    }
    made = {}
    for name, (first, second, at, axis) in JOINTS.items():
        pair = bodies[first], bodies[second]
        if name == "cross":
            made[name] = mechanism.universal(name, *pair, at, axis, (0.0, 1.0, 0.0))
        elif name == "slide":
            made[name] = mechanism.prismatic(name, *pair, axis, at)
        elif name == "thread":
            made[name] = mechanism.screw(name, *pair, at, axis, PITCH)
        elif name == "tie":
            made[name] = mechanism.link(name, *pair, at, axis, (-0.5, 0.4, 0.4))
        else:
            made[name] = mechanism.revolute(name, *pair, at, axis)
    node = {name: bodies[body].point(place).value for name, (body, place) in NODES.items()}
    mechanism.force(stretch(node["a"], node["s"], node["n"], ca.norm_2, ca.dot), ca.SX(130.0))
    mechanism.stop(
        "stop", ca.norm_2(node["s"] - node["b"]), upper=0.1, stiffness=300.0
    )  # a taut string
    turned = bodies["wrist"].direction(X).value
    mechanism.force(ca.dot(turned, bodies["nut"].direction(Z).value), ca.SX(7.0))
    mechanism.friction("friction", made["slide"], 11.0, regularisation_rate=1e-3)
    mechanism.force(made["cross"][1], ca.SX(5.0))
    mechanism.rod("rod", bodies["arm"], bodies["ball"], (0.2, 0.1, 0.2), (-0.5, 0.5, 0.5))
    if extra:
        mechanism.condition(
            "rule", ca.norm_2(node["a"] - node["n"]) - ca.norm_2(node["s"] - node["b"]) * 0.6 - 0.02
        )
        mechanism.motion("drive", made["shoulder"], mechanism.track("turn"))
    for body in bodies.values():
        if body.name != "ground":
            mechanism.watch_body(body)
    for name, (first, second, at, _) in JOINTS.items():
        on = second if second != "ground" else first
        mechanism.watch_reaction(name, at=at, on=on)
        mechanism.watch_point(f"at {name}", bodies[on], at)
    mechanism.watch_point("rod end", bodies["ball"], (-0.5, 0.5, 0.5))
    mechanism.watch_point("rod begin", bodies["arm"], (0.2, 0.1, 0.2))
    mechanism.watch_reaction("rod", at=(-0.5, 0.5, 0.5))
    for name, (body, place) in NODES.items():
        mechanism.watch_point(f"node {name}", bodies[body], place)
    for name, body, axis in (("wrist x", "wrist", X), ("nut z", "nut", Z)):
        for i, part in enumerate(ca.vertsplit(bodies[body].direction(axis).value)):
            mechanism.output(f"{name}.{'xyz'[i]}", part, "1", name)
    for name in ("shoulder", "cross", "slide", "thread", "tie"):
        first, _, _, axis = JOINTS[name]
        along = np.array(axis) / np.linalg.norm(axis)
        for i, part in enumerate(ca.vertsplit(bodies[first].direction(along).value)):
            mechanism.output(f"axis {name}.{'xyz'[i]}", part, "1", name)
    for i, part in enumerate(ca.vertsplit(bodies["wrist"].direction(Y).value)):
        mechanism.output(f"axis second.{'xyz'[i]}", part, "1", "second axis of the cross")
    return mechanism


def wrench(force, point, torque=None):
    """Force and moment about the ground's origin."""
    return np.concatenate([force, np.cross(point, force) + (0.0 if torque is None else torque)])


def inertia_of(found, name):
    """Rate of momentum and of angular momentum about the ground's origin, from the motion that is shown."""
    mass, _, elements = BODIES[name]
    xx, yy, zz, xy, xz, yz = (*elements, 0.0, 0.0, 0.0)[:6]
    q = np.array([found[f"{name}.q{i}"] for i in range(4)])
    w, (x, y, z) = q[0], q[1:]
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    turn = np.eye(3) + 2.0 * w * skew + 2.0 * skew @ skew
    tensor = turn @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ turn.T
    spin, rate = vector(found, name, "w"), vector(found, name, "alpha_")
    centre, push = vector(found, name, ""), mass * vector(found, name, "a")
    return wrench(push, centre, tensor @ rate + np.cross(spin, tensor @ spin))


def partial(function, places, name, step=1e-6):
    """Slope of an expression by one of its places, by differences."""
    found = np.zeros(3)
    for i in range(3):
        ends = []
        for sign in (1.0, -1.0):
            moved = {key: value.copy() for key, value in places.items()}
            moved[name][i] += sign * step
            ends.append(function(moved))
        found[i] = (ends[0] - ends[1]) / (2.0 * step)
    return found


@pytest.mark.parametrize("extra", [False, True])
def test_every_body_is_in_balance_under_all_that_is_shown(extra: bool):
    mechanism = everything(extra=extra)
    shown = {}
    if extra:
        for on in ("arm", "slider", "nut", "ball"):
            other = everything(extra=True)
            other.watch_reaction("rule", on=on, at=BODIES[on][1])
            shown[on] = signals(other, START, inputs={"turn": (0.3, 1.0)})
    found = signals(mechanism, START, inputs={"turn": (0.3, 1.0)} if extra else None)
    total = {name: -inertia_of(found, name) for name in BODIES}

    def act(body, what):
        if body in total:
            total[body] += what

    for name, (mass, _, _) in BODIES.items():
        act(name, wrench(np.array([0.0, 0.0, -mass * GRAVITY]), vector(found, name, "")))
    for name, (first, second, _, _) in JOINTS.items():
        on = second if second != "ground" else first
        other = second if on == first else first
        one = wrench(
            vector(found, name, "f"), vector(found, f"at {name}", ""), vector(found, name, "t")
        )
        act(on, one)
        act(other, -one)
    rod = wrench(vector(found, "rod", "f"), vector(found, "rod end", ""), vector(found, "rod", "t"))
    act("ball", rod)
    act("arm", -rod)
    places = {name: vector(found, f"node {name}", "") for name in NODES}

    def of_three(p):
        return stretch(p["a"], p["s"], p["n"], np.linalg.norm, np.dot)

    for name in "asn":
        act(NODES[name][0], wrench(130.0 * partial(of_three, places, name), places[name]))
    string = places["s"] - places["b"]
    taut = 300.0 * (np.linalg.norm(string) - 0.1) * string / np.linalg.norm(string)
    act("slider", wrench(-taut, places["s"]))
    act("ball", wrench(taut, places["b"]))
    one, other = vector(found, "wrist x", ""), vector(found, "nut z", "")
    act("wrist", np.concatenate([np.zeros(3), 7.0 * np.cross(one, other)]))
    act("nut", np.concatenate([np.zeros(3), 7.0 * np.cross(other, one)]))
    drag = wrench(
        11.0 * vector(found, "axis slide", ""), vector(found, "at slide", "")
    )  # it slides back
    act("slider", drag)
    act("wrist", -drag)
    act("wrist", np.concatenate([np.zeros(3), 5.0 * vector(found, "axis second", "")]))
    act("arm", np.concatenate([np.zeros(3), -5.0 * vector(found, "axis second", "")]))
    for on, signal in shown.items():
        act(
            on,
            wrench(
                vector(signal, "rule", "f"), vector(signal, on, ""), vector(signal, "rule", "t")
            ),
        )
    for name, left in total.items():
        np.testing.assert_allclose(left, 0.0, rtol=0.0, atol=1e-6, err_msg=name)


def test_reactions_do_no_work_on_the_motions_that_the_joints_leave_free():
    found = signals(everything(extra=False), START)
    force, torque = ({name: vector(found, name, letter) for name in JOINTS} for letter in "ft")
    axis = {name: vector(found, f"axis {name}", "") for name in JOINTS}
    size = max(np.linalg.norm(part) for part in force.values())
    assert size > 10.0
    assert abs(torque["shoulder"] @ axis["shoulder"]) < 1e-10 * size
    assert abs(torque["cross"] @ axis["cross"]) < 1e-10 * size
    assert abs(torque["cross"] @ vector(found, "axis second", "")) < 1e-10 * size
    assert abs(force["slide"] @ axis["slide"]) < 1e-10 * size
    screw = (
        torque["thread"] @ axis["thread"] + PITCH / (2.0 * np.pi) * force["thread"] @ axis["thread"]
    )
    assert abs(screw) < 1e-10 * size
    assert abs(torque["thread"] @ axis["thread"]) > 1e-3  # as on any thread, a thrust turns it


def test_a_motion_is_shown_by_itself_and_in_the_joint_it_drives():
    mechanism = everything(extra=True)
    mechanism.watch_reaction("drive", on="arm", at=(0.3, 0.1, 0.05))
    found = signals(mechanism, START, inputs={"turn": (0.3, 1.0)})
    axis = vector(found, "axis shoulder", "")
    np.testing.assert_allclose(vector(found, "drive", "f"), 0.0, rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(
        np.cross(vector(found, "drive", "t"), axis), 0.0, rtol=0.0, atol=1e-9
    )
    assert vector(found, "shoulder", "t") @ axis == pytest.approx(
        vector(found, "drive", "t") @ axis, rel=1e-9
    )


def test_names_that_end_like_equations_are_names():
    """Rods ``tie.x`` and ``tie.y`` are two closures, and ``link.x`` is not ``link``."""
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("body", 1.0, ORIGIN, (0.1, 0.1, 0.1))
    mechanism.free("flight", body)
    for name, end in (("tie.x", X), ("tie.y", Y), ("link.x", Z)):
        mechanism.rod(name, mechanism.ground, body, end, ORIGIN)
        mechanism.watch_reaction(name)
    assert mechanism.closures == ("tie.x", "tie.y", "link.x")
    assert mechanism.loops()["tie.x"] == ("tie.x", "flight")
    found = signals(mechanism, {})
    assert found["link.x.fz"] == pytest.approx(GRAVITY)
    assert found["tie.x.fx"] == pytest.approx(0.0, abs=1e-12)


def test_orientation_of_a_body_in_quaternion_and_angles():
    """Yaw about z, then pitch about the new y, then roll about the new x (ISO 8855)."""
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("car", 1.0, ORIGIN, (0.1, 0.1, 0.1))
    stand, gimbal = (
        mechanism.body("stand", 1.0, ORIGIN, (1.0, 1.0, 1.0)),
        mechanism.body("gimbal", 1.0, ORIGIN),
    )
    mechanism.revolute("yaw", mechanism.ground, stand, at=ORIGIN, axis=Z)
    mechanism.revolute("pitch", stand, gimbal, at=ORIGIN, axis=Y)
    mechanism.revolute("roll", gimbal, body, at=ORIGIN, axis=X)
    mechanism.watch_body(body)
    for yaw, pitch, roll in (
        (0.3, -0.4, 0.7),
        (2.9, 1.2, -2.8),
        (-3.0, 0.1, 3.1),
        (0.0, -1.5, 0.0),
    ):
        found = signals(mechanism, {"yaw.angle": yaw, "pitch.angle": pitch, "roll.angle": roll})
        assert [found[f"car.{name}"] for name in ("yaw", "pitch", "roll")] == pytest.approx(
            [yaw, pitch, roll]
        )
        q = np.array([found[f"car.q{i}"] for i in range(4)])
        halves = [np.array([np.cos(0.5 * a), np.sin(0.5 * a)]) for a in (yaw, pitch, roll)]
        (cz, sz), (cy, sy), (cx, sx) = halves
        e = [cx * cy * cz + sx * sy * sz, sx * cy * cz - cx * sy * sz]
        e += [cx * sy * cz + sx * cy * sz, cx * cy * sz - sx * sy * cz]
        np.testing.assert_allclose(q, np.sign(e[0]) * np.array(e), rtol=0.0, atol=1e-12)


def hinged(turn=0.4):
    """A body on a hinge at the origin, and where its point (1, 0, 0) is when it has turned."""
    mechanism = jn.mechanics.Mechanism(gravity=GRAVITY)
    body = mechanism.body("bob", 2.0, (0.5, 0.0, 0.0), (0.1, 0.1, 0.1))
    mechanism.revolute("pivot", mechanism.ground, body, at=ORIGIN, axis=Y)
    mechanism.watch_reaction("pivot")
    return mechanism, body, {"pivot.angle": turn}


def test_a_force_along_a_vector_is_that_force_on_the_point():
    force = (3.0, -4.0, 50.0)
    along, start = hinged()[0::2]
    along.force(along.bodies["bob"].point(X).value, ca.SX(force))
    applied, body, _ = hinged()
    applied.apply_force(body, force, X)
    found, expected = signals(along, start), signals(applied, start)
    assert abs(expected["pivot.fy"]) == pytest.approx(4.0)
    for name, value in expected.items():
        assert found[name] == pytest.approx(value, rel=1e-10, abs=1e-10), name


def test_what_holds_a_quaternion_is_not_transmitted_by_a_ball_joint_between_bodies():
    """A quaternion is against the ground: what keeps it acts from there, and the ball transmits a force only."""
    for kind in ("ball", "link"):
        mechanism = jn.mechanics.Mechanism(gravity=GRAVITY)
        arm = mechanism.body("arm", 2.0, (0.3, 0.0, 0.0), (0.02, 0.03, 0.04))
        other = mechanism.body("other", 1.0, (0.8, 0.0, 0.1), (0.01, 0.02, 0.015))
        mechanism.revolute("hinge", mechanism.ground, arm, at=ORIGIN, axis=Y)
        if kind == "ball":
            e = mechanism.spherical("tie", arm, other, at=(0.6, 0.0, 0.0))
        else:
            e = mechanism.link(
                "tie", arm, other, (0.5, 0.0, 0.0), (0.2, 1.0, 0.0), (0.6, 0.0, 0.1)
            )[1:]
        mechanism.condition("hold", e[2])
        end = (0.6, 0.0, 0.0) if kind == "ball" else (0.6, 0.0, 0.1)
        mechanism.watch_reaction("tie", at=end)
        mechanism.watch_reaction("hold")
        found = signals(mechanism, {})
        np.testing.assert_allclose(vector(found, "tie", "t"), 0.0, rtol=0.0, atol=1e-9)
        assert abs(found["hold.ty"]) > 0.1
