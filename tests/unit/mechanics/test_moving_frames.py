"""Moving frames and bodies that carry several loops: the same equations as with joints to the body itself."""

from __future__ import annotations

import re

import casadi as ca
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import jounce as jn
from jounce.mechanics.bodies import RigidMass
from jounce.mechanics.carrier import Carried, CarriedMasses, Shifting, TravellingMasses

TENSOR = (0.5, 0.7, 0.4, 0.05, -0.1, 0.08)
FIELD, PUSH = (0.7, -1.3, -9.81), (30.0, -50.0, 400.0)
ARM_AXIS = (1.0, 0.2, -0.1)


def car(*, moving: bool, shared: bool = False, held: bool = False) -> jn.mechanics.Mechanism:
    """A body that carries an arm with an upright on three rods, a slider on a rod, and a load on a strap."""
    mechanism = jn.mechanics.Mechanism(gravity=9.81)
    masses = {} if held else {"body": (5.0, (0.1, 0.0, 0.3))}
    frame = mechanism.ground
    if not held:
        body = mechanism.body("body", *masses["body"], (1.0, 2.0, 1.5, 0.1, 0.2, -0.1))
        mechanism.free("body", body)
        frame = mechanism.moving_frame(body, ca.SX([*FIELD])) if moving else body

    def hung(name: str, mass: float, place: tuple[float, float, float]) -> jn.mechanics.Body:
        masses[name] = mass, place
        return mechanism.body(name, mass, place, TENSOR)

    def inward(vector: tuple[float, ...]) -> ca.SX:
        return frame.carrier.inward(ca.SX([*vector])) if moving else ca.SX([*vector])

    arm = hung("left.arm", 0.8, (0.0, 0.4, 0.1))
    mechanism.revolute("left.hinge", frame, arm, at=(0.0, 0.2, 0.1), axis=ARM_AXIS)
    upright = hung("left.upright", 1.7, (0.02, 0.65, 0.2))
    mechanism.spherical("left.ball", arm, upright, at=(0.0, 0.6, 0.1))
    for i, (x, z) in enumerate(((0.15, 0.3), (-0.1, 0.33), (-0.2, 0.12))):
        mechanism.rod(f"left.rod{i}", frame, upright, (2.0 * x, 0.25, z), (x, 0.58, z + 0.01))
    strut = (frame, arm, (0.0, 0.25, 0.5), (0.0, 0.5, 0.12))
    mechanism.spring_damper("left.strut", *strut, stiffness=900.0, damping=70.0, free_length=0.5)
    size = mechanism.constant("size", 2.0) if moving else 2.0
    mechanism.apply_force(upright, size * inward(PUSH), upright.point((0.05, 0.72, -0.1)))
    lower, upper = (
        hung("right.lower", 0.6, (0.0, -0.5, 0.1)),
        hung("right.upper", 0.5, (0.0, -0.5, 0.3)),
    )
    mechanism.revolute("right.below", frame, lower, at=(0.0, -0.2, 0.1), axis=ARM_AXIS)
    mechanism.prismatic("right.above", frame, upper, axis=(0.1, 0.3, 1.0))
    mechanism.rod("right.rod", lower, upper, (0.0, -0.6, 0.1), (0.05, -0.55, 0.3))
    load = hung("load", 1.1, (0.3, 0.1, 0.5))
    if moving:
        mechanism.free("load", load, moving_frame=None if held else frame)
    else:  # what a free body is, joint by joint
        slides = [mechanism.body(f"slide {axis}") for axis in "xyz"]
        for one, other, axis in zip([frame, *slides], slides, np.eye(3), strict=False):
            mechanism.prismatic(other.name, one, other, axis=tuple(axis))
        mechanism.spherical("load", slides[-1], load, at=(0.3, 0.1, 0.5))
    mechanism.spring_damper(
        "strap", frame, load, (0.3, 0.0, 0.2), (0.32, 0.12, 0.45), stiffness=300.0, damping=9.0
    )
    for name, (mass, place) in list(masses.items())[: 1 if moving else None]:
        mechanism.apply_force(
            mechanism.bodies[name], ca.SX([mass * FIELD[0], mass * FIELD[1], 0.0]), place
        )
    if shared:
        mechanism.share(
            [f"body.{axis}" for axis in ("x rate", "y rate", "z rate", "wx", "wy", "wz")]
        )
    return mechanism


TURNED = ("left.ball", "load")  # their orientations are told against what the axes belong to


def of_the_ground(x: dict[str, float]) -> dict[str, float]:
    """The same state with joints to the body itself."""
    found = {slid(name): value for name, value in x.items()}
    body, spin = turn(x, "body"), vector(x, "body.w")
    for joint in TURNED:
        own = turn(x, joint)
        e = (body * own).as_quat()
        found |= {f"{joint}.e{i}": e[i - 1] for i in range(4)}
        found |= dict(
            zip(spins(joint), vector(x, f"{joint}.w") + own.inv().apply(spin), strict=True)
        )
    return found


def rate_of_the_ground(x: dict[str, float], rate: dict[str, float]) -> dict[str, float]:
    """Rates of the speeds of that state."""
    found = {slid(name): value for name, value in rate.items()}
    spin, change = vector(x, "body.w"), vector(rate, "body.w")
    for joint in TURNED:
        own, back = vector(x, f"{joint}.w"), turn(x, joint).inv()
        told = vector(rate, f"{joint}.w") + back.apply(change) - np.cross(own, back.apply(spin))
        found |= dict(zip(spins(joint), told, strict=True))
    return found


def turn(x: dict[str, float], joint: str) -> Rotation:
    return Rotation.from_quat([x[f"{joint}.e{i}"] for i in (1, 2, 3, 0)])


def spins(joint: str) -> list[str]:
    return [f"{joint}.w{axis}" for axis in "xyz"]


def vector(x: dict[str, float], name: str) -> np.ndarray:
    return np.array([x[f"{name}{axis}"] for axis in "xyz"])


def slid(name: str) -> str:
    """Name of a state of the free load as that of a joint which makes it."""
    found = re.fullmatch(r"load\.([xyz])( rate)?", name)
    return f"slide {found[1]}.distance{found[2] or ''}" if found else name


def test_a_moving_frame_gives_the_equations_of_joints_to_its_body() -> None:
    generator, start = np.random.default_rng(4), dict[str, float]()
    found = []
    for is_moving, is_shared in ((True, False), (True, True), (False, False)):
        mechanism = car(moving=is_moving, shared=is_shared)
        model = mechanism.finish()
        n_q, n_v = model.facts.counts
        if not start:
            start = dict(zip(model.states, generator.normal(size=n_q + n_v), strict=True))
            start |= {name: 0.2 * start[name] for name in model.coordinates}
            for joint in model.quaternions:
                e = np.array([(i == 0) + start[f"{joint}.e{i}"] for i in range(4)])
                start |= {f"{joint}.e{i}": value for i, value in enumerate(e / np.linalg.norm(e))}
        state = start if is_moving else of_the_ground(start)
        values = [mechanism.values[name] for name in model.parameters]
        whole = ca.Function("f", [model.x, model.u, model.p], [model.rate, model.constraint])
        rate, gap = (
            part.full().ravel()
            for part in whole([state[name] for name in model.states], [], values)
        )
        speeds = dict(zip(model.states[n_q:], rate[n_q:], strict=True))
        assert (model.generic is not None) == is_moving
        found.append((rate_of_the_ground(start, speeds) if is_moving else speeds, gap))
    expected, gap = found.pop()
    assert max(map(abs, expected.values())) > 10.0
    for rate, own in found:
        np.testing.assert_allclose(own, gap, rtol=1e-9, atol=1e-12)
        assert rate == {
            name: pytest.approx(value, rel=1e-8, abs=1e-7) for name, value in expected.items()
        }


JOINTS = ("left.hinge", "left.ball", "right.below", "right.above", "body")
CLOSURES = ("left.rod0", "left.rod1", "left.rod2", "right.rod")


def test_a_moving_frame_gives_the_reactions_of_joints_to_its_body() -> None:
    """In any motion, loops open or not: at the joint, at another point and in other axes, and on the first body."""
    generator, start = np.random.default_rng(5), dict[str, float]()
    found = []
    for is_moving in (True, False):
        mechanism = car(moving=is_moving)
        for joint in (*JOINTS, *CLOSURES):
            given = {
                "left.ball": {"frame": "left.upright", "at": (0.1, 0.7, 0.2)},
                "right.below": {"on": "body"},
            }
            mechanism.watch_reaction(joint, **given.get(joint, {}))
        assert mechanism.reaction("left.hinge").body.name == "left.arm"
        model = mechanism.finish()
        if not start:
            start = dict(
                zip(model.states, 0.2 * generator.normal(size=len(model.states)), strict=True)
            )
            for joint in model.quaternions:
                e = np.array([(i == 0) + start[f"{joint}.e{i}"] for i in range(4)])
                start |= {f"{joint}.e{i}": value for i, value in enumerate(e / np.linalg.norm(e))}
        state = start if is_moving else of_the_ground(start)
        values = [mechanism.values[name] for name in model.parameters]
        shown = ca.Function("f", [model.x, model.u, model.p], [model.output])
        outputs = shown([state[name] for name in model.states], [], values).full().ravel()
        found.append(
            {output.name: value for output, value in zip(model.outputs, outputs, strict=True)}
        )
    moving, still = found
    assert len(moving) == 6 * len((*JOINTS, *CLOSURES))
    sizes = {
        joint: max(abs(still[f"{joint}.f{axis}"]) for axis in "xyz")
        for joint in (*JOINTS, *CLOSURES)
    }
    assert all(size > 1.0 for joint, size in sizes.items() if joint != "body")
    assert moving == {
        name: pytest.approx(value, rel=1e-9, abs=1e-8) for name, value in still.items()
    }


def test_loops_on_a_body_close_as_if_it_stood_still() -> None:
    """Projection moves what hangs on the body and not the body; it sees how near to singular each of its loops is."""
    shared, held = (car(moving=True, shared=not is_held, held=is_held) for is_held in (False, True))
    one, other = shared.finish(), held.finish()
    numbers = dict(zip(one.coordinates, one.start, strict=True))
    generator = np.random.default_rng(7)
    for name in (*one.coordinates, *one.speeds):
        numbers[name] = numbers.get(name, 0.0) + 0.1 * generator.normal()
    found = []
    for mechanism, model in ((shared, one), (held, other)):
        values = [mechanism.values[name] for name in model.parameters]
        where, count = [model.x, model.u, model.p], len(model.states)
        step = ca.Function("step", where, [model.projection, model.balance.constraint_rate])
        x, passed = np.array([numbers[name] for name in model.states]), []
        for _ in range(12):
            moved, drift = (part.full().ravel() for part in step(x, [], values))
            x = moved[:count]
            passed.append(dict(zip((*model.states, "left", "conditioning"), moved, strict=True)))
        assert passed[-1]["left"] < 1e-12
        np.testing.assert_allclose(drift, 0.0, atol=1e-12)
        found.append(passed)
    for first, second in zip(*found, strict=True):
        assert {name: first[name] for name in second} == {
            name: pytest.approx(value, rel=1e-8, abs=1e-10) for name, value in second.items()
        }
    assert 0.01 < found[0][-1]["conditioning"] < 0.99
    body = [name for name in one.states if name.startswith("body.") and ".e" not in name]
    assert [found[0][-1][name] for name in body] == [
        pytest.approx(numbers[name], abs=1e-15) for name in body
    ]


def test_heights_and_directions_are_those_of_the_ground() -> None:
    mechanism = car(moving=True)
    frame, body = mechanism.bodies["body axes"], mechanism.bodies["body"]
    place = ca.SX([0.4, -0.3, 0.2])
    seen, outside = frame.frame.point(place), body.frame.point(place)
    carrier, q = frame.carrier, ca.vertcat(*mechanism.collection.coordinates.values())
    v = mechanism.collection.v
    parts = [
        carrier.height(seen.value) - outside.value[2],
        carrier.outward(carrier.velocity(seen)) - outside.rate,
        carrier.outward(carrier.spin(frame.frame.orientation)) - body.frame.orientation.ground_spin,
        carrier.inward(carrier.outward(place)) - place,
        carrier.outward(carrier.up) - ca.SX([0, 0, 1]),
    ]
    generator = np.random.default_rng(1)
    numbers = generator.normal(size=q.numel())
    first = mechanism.finish().quaternions["body"]
    numbers[first : first + 4] /= np.linalg.norm(numbers[first : first + 4])
    p, values = (
        ca.vertcat(*mechanism.collection.parameters.values()),
        list(mechanism.values.values()),
    )
    function = ca.Function("f", [q, v, p], [ca.vertcat(*parts)])
    np.testing.assert_allclose(
        function(numbers, generator.normal(size=v.numel()), values).full(), 0.0, atol=1e-12
    )
    with pytest.raises(jn.AssemblyError, match="body axes: the name is used twice"):
        mechanism.moving_frame(body, ca.SX(3, 1))
    upright = mechanism.bodies["left.upright"]
    for other in (body, mechanism.ground):
        with pytest.raises(
            jn.AssemblyError, match=r"to different moving frames; found 'left\.upright, "
        ):
            mechanism.rod("rod", upright, other, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    mechanism.track("go")
    for watch in (
        lambda: mechanism.watch_body(upright),
        lambda: mechanism.watch_point("p", upright, (0.0, 0.0, 0.0)),
    ):
        with pytest.raises(
            jn.AssemblyError,
            match=r"not available for bodies in a moving frame; found 'left\.upright'",
        ):
            watch()


def test_masses_that_one_coordinate_moves_weigh_as_their_bodies():
    """Arm and tip as two bodies, and as functions of the hinge's angle: inertia, and what steady speeds leave of it."""
    mechanism = jn.mechanics.Mechanism(gravity=9.81)
    body = mechanism.body("body", 5.0, (0.1, 0.0, 0.3), (1.0, 2.0, 1.5))
    mechanism.free("body", body)
    frame = mechanism.moving_frame(body, ca.SX([*FIELD]))
    arm = mechanism.body("arm", 0.8, (0.0, 0.4, 0.1), TENSOR)
    tip = mechanism.body("tip", 0.3, (0.1, 0.7, 0.3), TENSOR)
    angle = mechanism.revolute("hinge", frame, arm, at=(0.0, 0.2, 0.1), axis=ARM_AXIS)
    mechanism.fixed("weld", arm, tip)
    carrier, v, q = frame.carrier, mechanism.collection.v, mechanism.collection.q
    speed = mechanism.rate_of(angle)
    moment, angular, tensor, energy = ca.SX(3, 1), ca.SX(3, 1), ca.SX(3, 3), ca.SX(0.0)
    bodies = []
    for one in (arm, tip):
        mass, design, inertia = (
            getattr(one.mass_properties, name) for name in ("mass", "centre", "inertia")
        )
        centre, orientation = one.frame.point(design), one.frame.orientation
        bodies.append(
            Carried(mass, centre, orientation, inertia, RigidMass(one.frame, one.mass_properties))
        )
        place, turned = carrier.arm(centre.value), orientation.turned(inertia)
        rate, spin = (
            ca.substitute(each, speed, 1.0) for each in (centre.rate, orientation.ground_spin)
        )
        moment += mass * place
        angular += mass * ca.cross(place, rate) + turned @ spin
        tensor += turned + mass * (ca.dot(place, place) * ca.SX.eye(3) - place @ place.T)
        energy += mass * ca.dot(rate, rate) + ca.dot(spin, turned @ spin)

    def shifting(value: ca.SX) -> Shifting:
        return Shifting(value, ca.reshape(ca.jacobian(value, angle), value.shape))

    first, total = shifting(moment), sum(one.mass for one in bodies)
    momenta = (first, shifting(first.slope), shifting(angular), shifting(tensor), shifting(energy))
    both = CarriedMasses(carrier, bodies), TravellingMasses(carrier, speed, total, *momenta)
    p = ca.vertcat(*mechanism.collection.parameters.values())
    f = ca.Function("f", [q, v, p], [part for one in both for part in (one.matrix(v), one.bias(v))])
    random = np.random.default_rng(3)
    values = np.array([mechanism.values[path] for path in mechanism.parameters])
    for _ in range(3):
        turn = random.normal(size=4)
        found = f(
            np.concatenate(
                [random.normal(size=3), turn / np.linalg.norm(turn), random.normal(size=1)]
            ),
            random.normal(size=7),
            values,
        )
        matrix, bias, other, rest = (each.full() for each in found)
        assert np.max(np.abs(matrix - other)) < 1e-13 * np.max(np.abs(matrix))
        assert np.max(np.abs(bias - rest)) < 1e-13 * np.max(np.abs(bias))
