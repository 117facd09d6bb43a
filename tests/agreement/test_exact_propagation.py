"""Exact propagation of piecewise linear models against adaptive steps at their finest, and against a readable twin."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from jounce import parts
from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE, Segments, flat, piecewise_linear
from jounce.mechanics import Model, System
from jounce.models import build
from jounce.simulation.compiled import compile_model
from jounce.simulation.prepare import solve
from jounce.simulation.settings import output_times

pytestmark = pytest.mark.usefixtures("optimised")

KART = parts.load("kart-quarter-car")
RIGS = {
    "linear": {"tyre.lift_off": False},
    "lift-off": {},
    "tyre damping": {"tyre.damping_coefficient": 60.0},
    "bilinear damper": {"strut.damper": {"bump_coefficient": 80.0, "rebound_coefficient": 240.0}},
    "velocity table": {
        "strut.damper": {
            "velocity": [-1.0, -0.2, -0.05, 0.0, 0.05, 0.3, 1.0],
            "force": [-120.0, -60.0, -30.0, 0.0, 10.0, 30.0, 60.0],
        }
    },
    "bump stop": {"strut.bump_stop": {"gap": 0.009, "rate": 3e5}},
    "table tyre": {
        "tyre.stiffness": None,
        "tyre.curve": {
            "kind": "table",
            "deflection": [0.0, 0.001, 0.002, 0.01],
            "force": [0.0, 60.0, 150.0, 1400.0],
        },
    },
}


def obstacle(kind: int, coefficients: list[float], length: float = 0.06) -> Segments:
    """Flat, one piece, flat: at 2.86 m/s."""
    pieces = np.array([[0.0] * 4, coefficients, [0.0] * 4])
    edges = np.array([0.0, 0.1, 0.1 + length, 100.0])
    return Segments(edges, np.array([POLYNOMIAL, kind, POLYNOMIAL]), pieces).in_time(2.86)


def rough(seed: int, *, height: float = 3e-3, count: int = 120) -> Segments:
    """Straight lines between points at irregular times, some of them close together."""
    generator = np.random.default_rng(seed)
    steps = generator.exponential(0.6 / count, count) + 1e-7
    return piecewise_linear(np.cumsum(steps), height * np.cumsum(generator.normal(0.0, 0.4, count)))


def curved(seed: int) -> Segments:
    """Jumps, cubics and sines of three frequencies."""
    generator = np.random.default_rng(seed)
    edges = np.concatenate([[0.0], np.sort(generator.uniform(0.02, 0.58, 14)), [2.0]])
    kinds = generator.integers(0, 2, 15)
    coefficients = generator.normal(0.0, 1.0, (15, 4)) * np.array([2e-3, 0.02, 0.1, 1.0])
    sines = kinds == SINE
    coefficients[sines, 1], coefficients[sines, 2] = (
        3e-3,
        generator.choice([30.0, 55.0, 90.0], int(sines.sum())),
    )
    return Segments(edges, kinds, coefficients)


ROADS = {
    "half-sine": obstacle(SINE, [0.0, 0.03, np.pi / 0.06, 0.0]),
    "rectangle": obstacle(POLYNOMIAL, [0.02, 0.0, 0.0, 0.0]),
    "narrow": obstacle(SINE, [0.0, 0.02, np.pi / 1e-3, 0.0], length=1e-3),
    "rough": rough(1),
    "rougher": rough(2, height=9e-3),
    "curved": curved(3),
}


def compared(model: Model, values: dict[str, float], signals, times, allowed: float) -> int:
    """Compare states and outputs, relative to their range; give the number of events."""
    compiled = compile_model(model)
    p = compiled.parameter_values(values)
    found = solve(compiled, p, signals, times)
    assert (found.method, found.status.name) == ("exact", "COMPLETED")
    expected = solve(compiled, p, signals, times, tolerance=1e-12, method="explicit")
    for of in ("states", "outputs"):
        a, b = getattr(found, of), getattr(expected, of)
        reach = np.maximum(np.ptp(b, axis=1), 1e-6)
        assert np.max(np.max(np.abs(a - b), axis=1) / reach) < allowed
    assert found.events == expected.events
    return found.events


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize("name", RIGS)
def test_laws_and_roads(name: str, road: str) -> None:
    rig = KART.with_changes(RIGS[name])
    events = compared(build(rig), rig.parameters(), ROADS[road], output_times(0.6, 1e-3), 2e-9)
    assert events == 0 if name == "linear" else events > 0 or road == "narrow"


@pytest.mark.parametrize("step", [0.1, 7.3e-3, 1e-3, 1e-5])
@pytest.mark.parametrize("name", ["lift-off", "bilinear damper"])
def test_output_steps(name: str, step: float) -> None:
    """Samples do not matter, not even those of another last distance."""
    rig = KART.with_changes(RIGS[name])
    compiled = compile_model(build(rig))
    p, road = compiled.parameter_values(rig.parameters()), ROADS["rougher"]
    fine, times = output_times(0.6, 1e-4), output_times(0.6, step)
    solution, reference = solve(compiled, p, road, times), solve(compiled, p, road, fine)
    common = np.flatnonzero(np.min(np.abs(times[:, None] - fine[None, ::1000]), axis=1) < 1e-9)
    at = np.round(times[common] / 1e-4).astype(int)
    assert len(common) >= 2
    size = np.ptp(reference.states, axis=1)
    difference = np.abs(solution.states[:, common] - reference.states[:, at])
    assert np.max(difference / size[:, None]) < 1e-11
    assert solution.events == reference.events


@pytest.mark.parametrize("seed", range(3))
def test_contacts_that_open_and_close_just_before_an_edge_on_a_sample(seed: int) -> None:
    """The force of a tyre with damping jumps where the slope of the road does: what it was before that counts, too."""
    rig = parts.load("audi-a6-quarter-car")
    times = output_times(1.0, 1e-3)
    heights = np.random.default_rng(seed).normal(0.0, 6e-3, 501).cumsum()
    assert (
        compared(build(rig), rig.parameters(), piecewise_linear(times[::2], heights), times, 2e-9)
        > 20
    )


def test_irregular_samples() -> None:
    rig = KART
    compiled = compile_model(build(rig))
    p, road = compiled.parameter_values(rig.parameters()), ROADS["half-sine"]
    times = np.unique(
        np.concatenate([output_times(0.6, 1e-2), np.random.default_rng(0).uniform(0.0, 0.6, 60)])
    )
    found, expected = (solve(compiled, p, road, t).states for t in (times, output_times(0.6, 1e-2)))
    at = np.searchsorted(times, output_times(0.6, 1e-2))
    assert np.max(np.abs(found[:, at] - expected)) < 1e-11


def half_car() -> tuple[Model, dict[str, float]]:
    """Body on two tyres that may lift off and two bilinear dampers, driven by two roads and a moment."""
    system = System()
    number = system.parameter
    roads = [system.track(f"{end}.road.z") for end in ("front", "rear")]
    moment = system.track("pitch_moment")
    wheels = [system.coordinate(f"{end}.z") for end in ("front", "rear")]
    z, pitch = system.coordinate("body.z"), system.coordinate("body.pitch")
    system.point_mass(number("mass"), z)
    system.point_mass(number("inertia"), pitch)
    system.force(z, -number("mass") * 9.81)
    system.force(pitch, moment.value)
    for road, wheel, arm in zip(roads, wheels, (1.1, -1.4), strict=True):
        name = f"wheel at {arm}"
        system.point_mass(ca.SX(40.0), wheel)
        system.force(wheel, ca.SX(-40.0 * 9.81))
        deflection = wheel - (z - arm * pitch)
        velocity = system.rate_of(deflection)
        bump = system.switch(f"bump of {name}", velocity)
        system.force(-deflection, 2.2e4 * deflection + (3e3 - 1.7e3 * bump) * velocity)
        depth = road.value - wheel
        force = 2e5 * depth + 80.0 * system.rate_of(depth)
        contact = system.switch(f"contact of {name}", ca.fmin(force, 2e5 * depth))
        system.force(-depth, force * contact)
        system.output(f"{name}.force", force * contact, "N", "tyre force")
    system.output("body.az", system.acceleration_of(z), "m/s^2", "acceleration")
    return system.finish(), {"mass": 700.0, "inertia": 1200.0}


@pytest.mark.parametrize("seed", range(6))
def test_several_tracks(seed: int) -> None:
    """The rear wheel meets the front's road later by what is no number of samples."""
    model, values = half_car()
    front = rough(seed, height=0.012)
    delay = 0.0123456789
    edges = np.concatenate([[0.0], front.edges[0:1] + delay, front.edges[1:] + delay])
    level = front.coefficients[:1] * [1.0, 0.0, 0.0, 0.0]
    rear = Segments(edges, np.append(0, front.kind), np.vstack([level, front.coefficients]))
    braking = piecewise_linear(np.array([0.0, 0.2, 0.3, 5.0]), np.array([0.0, 0.0, 900.0, 900.0]))
    signals = dict(
        zip(("front.road.z", "rear.road.z", "pitch_moment"), (front, rear, braking), strict=True)
    )
    times = output_times(0.6, 1e-3)
    assert compared(model, values, [signals[name] for name in model.tracks], times, 2e-9) > 0


def test_a_stop_that_stiffens_or_a_round_obstacle_is_left_to_adaptive_steps() -> None:
    stiffening = KART.with_changes(
        {"strut.bump_stop": {"gap": 0.009, "rate": 3e5, "progression": 1e8}}
    )
    for rig, road in (
        (stiffening, ROADS["rough"]),
        (KART, obstacle(CIRCLE, [0.0, 0.03, 0.03, 1.0])),
    ):
        compiled = compile_model(build(rig))
        p = compiled.parameter_values(rig.parameters())
        assert solve(compiled, p, road, output_times(0.1, 1e-3)).method == "explicit"


def test_steps_and_events_are_counted() -> None:
    compiled = compile_model(build(KART))
    p = compiled.parameter_values(KART.parameters())
    still = solve(compiled, p, flat(1.0), output_times(1.0, 1e-3))
    assert (still.method, still.steps, still.rejected, still.events) == ("exact", 1000, 0, 0)
    moved = solve(compiled, p, ROADS["half-sine"], output_times(0.6, 1e-3))
    assert moved.events >= 2
    assert 600 < moved.steps < 700


@pytest.mark.parametrize("name", ["lift-off", "tyre damping", "bilinear damper"])
@pytest.mark.parametrize("road", ["half-sine", "rough", "curved"])
def test_readable_twin(piecewise_twin, name: str, road: str) -> None:
    rig = KART.with_changes(RIGS[name])
    compiled = compile_model(build(rig))
    p, times = compiled.parameter_values(rig.parameters()), output_times(0.3, 5e-3)
    found = solve(compiled, p, ROADS[road], times)
    expected = piecewise_twin.run(compiled, p, ROADS[road], times, found.states[:, 0])
    assert np.max(np.abs(found.states - expected) / np.ptp(expected, axis=1, keepdims=True)) < 1e-9
