"""Loads between bodies and on coordinates: force, energy, power lost and what the joint carries, in closed form."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

import jounce as jn
from jounce.mechanics import Mechanism, System, add_bushing, add_elastic_rod

BALL, ORIGIN, X, Y = (0.1, 0.1, 0.1), (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)
MASS, INERTIA = 2.0, 0.1


def seen(mechanism: Mechanism, *state: float) -> dict[str, float]:
    """Rates of the states and outputs of a mechanism, switches as their signs say."""
    model = mechanism.finish()
    where = [model.x, model.u, model.p, model.m]
    switches, both = (
        ca.Function("f", where, list(graphs))
        for graphs in ([model.switch], [model.rate, model.output])
    )
    x = [*state, *np.zeros(len(model.states) - len(state))]
    p, m = [mechanism.values[name] for name in model.parameters], ca.DM.zeros(len(model.switches))
    m = switches(x, np.zeros(0), p, m) > 0.0
    rates, outputs = (part.full().ravel() for part in both(x, np.zeros(0), p, m))
    found = {f"rate of {name}": value for name, value in zip(model.states, rates, strict=True)}
    return found | {
        output.name: value for output, value in zip(model.outputs, outputs, strict=True)
    }


def sled() -> tuple[Mechanism, object, ca.SX]:
    """A block of 2 kg on a slide along x."""
    mechanism = Mechanism(gravity=0.0)
    block = mechanism.body("block", MASS, ORIGIN, BALL)
    place = mechanism.prismatic("slide", mechanism.ground, block, axis=X)
    return mechanism, block, place


def stretched(x: float, v: float) -> tuple[float, float, float]:
    """Length, its rate and share along x of a line from (-0.3, 0.4, 0) to the end of the block at x."""
    length = float(np.hypot(x + 0.35, 0.5))
    return length, v * (x + 0.35) / length, (x + 0.35) / length


@pytest.mark.parametrize("x", [-0.1, 0.2])
@pytest.mark.parametrize("v", [-1.5, 0.7])
@pytest.mark.parametrize("kind", ["spring and damper", "elastic rod", "bushing", "law"])
def test_what_acts_between_bodies(kind: str, x: float, v: float) -> None:
    mechanism, block, place = sled()
    at, end = (-0.3, 0.4, 0.0), (0.05, -0.1, 0.0)
    length, rate, share = stretched(x, v)
    across = 0.5 / length
    if kind == "spring and damper":
        force = mechanism.spring_damper(
            "load",
            mechanism.ground,
            block,
            at,
            end,
            stiffness=300.0,
            damping=20.0,
            free_length=0.45,
        )[1]
        push = -300.0 * (length - 0.45) - 20.0 * rate
        stored, lost, shown = 0.5 * 300.0 * (length - 0.45) ** 2, 20.0 * rate**2, push
    elif kind == "law":
        force = mechanism.spring_damper(
            "load", mechanism.ground, block, at, end, force=-50.0 * place
        )[1]
        push = shown = -50.0 * x
        stored = lost = None
    elif kind == "elastic rod":
        force, power = add_elastic_rod(
            mechanism, "load", mechanism.ground, block, at, end, (1e3, 4e3, 9e3), (10.0, 30.0, 5.0)
        )
        mechanism.output("power", power, "W", "power taken up")
        design = np.hypot(0.35, 0.5)
        shares = (0.35 / design) ** 2, (0.5 / design) ** 2
        along = 1.0 / (shares[0] / 1e3 + shares[1] / 4e3)
        shown = (
            along * (length - design)
            + along**2 * (shares[0] * 10.0 / 1e6 + shares[1] * 30.0 / 16e6) * rate
        )
        push, stored, lost = -shown, None, None
    else:
        bushing = add_bushing(
            mechanism,
            "load",
            mechanism.ground,
            block,
            at,
            (1e3, 4e3, 9e3),
            damping=(10.0, 30.0, 5.0),
        )
        force = bushing.force[0]
        mechanism.output("power", bushing.power, "W", "power taken up")
        mechanism.output("energy", bushing.energy, "J", "energy")
        push, share, across, stored, lost = -1e3 * x - 10.0 * v, 1.0, 0.0, None, None
        shown = push
    mechanism.output("force", force, "N", "force")
    mechanism.watch_reaction("slide")
    mechanism.watch_energy()
    found = seen(mechanism, x, v)
    assert found["force"] == pytest.approx(shown, rel=1e-6)
    assert found["rate of slide.distance rate"] == pytest.approx(push * share / MASS, rel=1e-6)
    assert found["slide.fx"] == pytest.approx(
        0.0, abs=1e-9
    )  # the slide holds what it does not let go
    assert found["slide.fy"] == pytest.approx(push * across, rel=1e-6, abs=1e-9)
    if kind != "bushing":
        assert found["slide.tz"] == pytest.approx(push * (0.05 * across - 0.1 * share), rel=1e-6)
    assert found["energy.kinetic"] == pytest.approx(0.5 * MASS * v**2)
    if stored is not None:
        assert found["energy.elastic"] == pytest.approx(stored, rel=1e-6)
        assert found["rate of energy.dissipated"] == pytest.approx(lost, rel=1e-6)
    if kind == "elastic rod":
        assert found["power"] == pytest.approx(shown * rate, rel=1e-6)
    if kind == "bushing":
        assert found["energy"] == pytest.approx(0.5 * 1e3 * x**2)
        assert found["power"] == pytest.approx(-push * v)


@pytest.mark.parametrize(
    ("x", "v"), [(-0.15, 0.5), (-0.15, -0.5), (-0.15, 9.0), (0.0, 1.0), (0.25, 0.5), (0.25, -9.0)]
)
def test_what_a_stop_stores_and_loses(x: float, v: float) -> None:
    mechanism, _, place = sled()
    mechanism.stop("stop", place, lower=-0.1, upper=0.2, stiffness=500.0, damping=40.0)
    mechanism.watch_energy()
    found = seen(mechanism, x, v)
    end, side = (-0.1, 1.0) if x < 0.0 else (0.2, -1.0)
    depth, rate = max(side * (end - x), 0.0), -side * v
    push = max(500.0 * depth + 40.0 * rate, 0.0) if depth else 0.0
    assert found["rate of slide.distance rate"] == pytest.approx(side * push / MASS)
    assert found["energy.elastic"] == pytest.approx(0.5 * 500.0 * depth**2)
    assert found["rate of energy.dissipated"] == pytest.approx(
        rate * (push - 500.0 * depth) if depth else 0.0
    )


def test_what_friction_loses() -> None:
    mechanism, _, place = sled()
    force = mechanism.friction("rub", place, 30.0, regularisation_rate=0.01)
    mechanism.output("force", force, "N", "friction")
    mechanism.watch_energy()
    for v in (-0.005, 0.02):
        found = seen(mechanism, 0.0, v)
        drag = -30.0 * np.tanh(v / 0.01)
        assert found["force"] == pytest.approx(drag)
        assert found["rate of slide.distance rate"] == pytest.approx(drag / MASS)
        assert found["rate of energy.dissipated"] == pytest.approx(-drag * v)
    model = mechanism.finish()
    sliding = ca.Function("f", [model.x, model.p], [model.switch])
    p = [mechanism.values[name] for name in model.parameters]
    for v in (-0.03, 0.03):
        assert float(sliding([0.0, v, 0.0], p)) == pytest.approx(0.0, abs=1e-12)


def test_what_a_rotational_spring_and_damper_stores_and_loses() -> None:
    mechanism = Mechanism(gravity=0.0)
    wheel = mechanism.body("wheel", MASS, ORIGIN, BALL)
    mechanism.revolute("hinge", mechanism.ground, wheel, at=ORIGIN, axis=Y)
    torque = mechanism.rotational_spring_damper(
        "torsion", "hinge", stiffness=8.0, damping=0.5, free_angle=0.3
    )
    mechanism.output("torque", torque, "N*m", "torque")
    mechanism.watch_energy()
    mechanism.watch_reaction("hinge")
    found = seen(mechanism, -0.2, 1.5)
    assert found["torque"] == pytest.approx(8.0 * 0.5 - 0.5 * 1.5)
    assert found["rate of hinge.angle rate"] == pytest.approx((8.0 * 0.5 - 0.5 * 1.5) / INERTIA)
    assert found["energy.elastic"] == pytest.approx(0.5 * 8.0 * 0.25)
    assert found["rate of energy.dissipated"] == pytest.approx(0.5 * 1.5**2)
    assert found["energy.kinetic"] == pytest.approx(0.5 * INERTIA * 1.5**2)
    assert found["hinge.ty"] == pytest.approx(0.0, abs=1e-9)


def test_forces_at_points_and_along_expressions_are_carried_by_the_joint() -> None:
    """What acts on a hinged body: force and torque in ground axes, a force along a height, a force on a rate."""
    loads: list[Callable[[Mechanism, jn.mechanics.Body], None]] = [
        lambda m, b: m.apply_force(b, (3.0, -2.0, 5.0), (0.4, 0.1, 0.0)),
        lambda m, b: m.apply_torque(b, (1.0, 2.0, 3.0)),
        lambda m, b: m.force(b.point((0.4, 0.1, 0.0)).value[2], 7.0),
        lambda m, _: m.load(m.rate_of(m.coordinate_named("hinge.angle")), 1.5),
        lambda m, b: m.push_apart(m.ground, b, (0.4, 0.1, -1.0), b.point((0.4, 0.1, 0.0)), 7.0),
    ]
    arm = np.array([0.4, 0.1, 0.0])
    down = np.array([0.0, 0.0, 7.0])
    expected = [((3.0, -2.0, 5.0), np.cross(arm, (3.0, -2.0, 5.0))), (np.zeros(3), (1.0, 2.0, 3.0)),
                (down, np.cross(arm, down)), (np.zeros(3), (0.0, 1.5, 0.0)), (down, np.cross(arm, down))]  # fmt: skip
    for load, (force, torque) in zip(loads, expected, strict=True):
        mechanism = Mechanism(gravity=0.0)
        body = mechanism.body("body", MASS, ORIGIN, BALL)
        mechanism.revolute("hinge", mechanism.ground, body, at=ORIGIN, axis=Y)
        load(mechanism, body)
        mechanism.watch_reaction("hinge")
        found = seen(mechanism)
        assert found["rate of hinge.angle rate"] == pytest.approx(torque[1] / INERTIA, rel=1e-6)
        assert [found[f"hinge.f{axis}"] for axis in "xyz"] == pytest.approx(
            [-one for one in force], abs=1e-6
        )
        held = [0.0 if i == 1 else -one for i, one in enumerate(torque)]
        assert [found[f"hinge.t{axis}"] for axis in "xyz"] == pytest.approx(held, abs=1e-6)


def test_a_model_is_linear_between_its_switches_where_nothing_bends_it() -> None:
    def model(law: Callable[[ca.SX, ca.SX], ca.SX], *, stop: bool = False) -> jn.mechanics.Model:
        system = System()
        z = system.coordinate("z")
        system.point_mass(ca.SX(1.0), z)
        p = system.parameter("stop.progression" if stop else "k")
        system.force(z, law(z, p))
        system.output("z", z, "m", "height")
        return system.finish()

    assert model(lambda z, k: -k * z).facts.linear_without == ()
    for law in (lambda z, k: -k * ca.fabs(z), lambda z, k: -ca.fmax(z, k), lambda z, k: -k * z**3):
        assert model(law).facts.linear_without is None
    bent = model(lambda z, k: -3.0 * z - k * z**3, stop=True)
    assert bent.facts.linear_without == ("stop.progression",)
    assert bent.is_piecewise_linear(("stop.progression",))
    assert not bent.is_piecewise_linear()
    looped, block, _ = sled()
    assert looped.finish().facts.linear_without == ()
    looped.rod("rod", looped.ground, block, (0.0, 0.0, 1.0), ORIGIN)
    assert looped.finish().facts.linear_without is None
    free = Mechanism(gravity=0.0)
    free.free("flight", free.body("body", MASS, ORIGIN, BALL))
    assert free.finish().facts.linear_without is None
