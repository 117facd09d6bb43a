"""Vehicles keep the laws that need no model to check: weight, momentum, energy, superposition, reciprocity, order."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.models import build
from jounce.simulation.compiled import compile_model

HALF = jn.load("audi-a6-half-car")
HALF4 = jn.load("audi-a6-half-car-4dof")
FULL = jn.load("audi-a6-full-car")
CARS = {car.model: car for car in (HALF, HALF4, FULL)}
BUMP = jn.HalfSine(height="60 mm", length="0.5 m", start="2 m")
HOLE = jn.Trapezoid(height="-30 mm", length="1 m", ramp="0.2 m", start="3 m")
SMOOTH = jn.Versine(height="20 mm", length="4 m", start="1 m")
LINEAR = {f"{axle}.tyre.lift_off": False for axle in ("front", "rear")}
TURN = {"value": 4.0, "start": 0.2, "ramp": 0.1}


def run(
    car,
    *,
    road=BUMP,
    speed=10.0,
    duration=1.5,
    tolerance=1e-9,
    output_step=1e-3,
    method="auto",
    **loads,
):
    trial = jn.Trial(road=road, speed=speed, duration=duration, **loads)
    return jn.simulate(car, trial, tolerance=tolerance, output_step=output_step, method=method)


def lever(car, corner: str) -> tuple[float, float]:
    """Forward and left of the centre of gravity, m."""
    axle = getattr(car, corner.partition("_")[0])
    x = axle.distance if corner.startswith("front") else -axle.distance
    side = 1.0 if corner.endswith("left") else -1.0 if corner.endswith("right") else 0.0
    return x, side * 0.5 * getattr(axle, "track", 0.0)


def wheels_each(car) -> float:
    return 1.0 if car.model == "full-car" else 2.0


@pytest.mark.parametrize("model", CARS)
def test_weight_at_rest(model):
    """The road carries what is there, in force and in moment about the centre of gravity."""
    car = CARS[model]
    rest, n = jn.equilibrium(car), wheels_each(car)
    part = "strut" if model == "half-car" else "tyre"
    carried = {corner: n * rest[f"{corner}.{part}.force"] for corner in car.corners}
    wheel = {
        c: n * getattr(getattr(car, c.partition("_")[0]), "unsprung_mass", 0.0) for c in car.corners
    }
    total = car.body.mass + sum(wheel.values())
    assert abs(sum(carried.values()) - total * 9.81) < 1e-8
    moment = sum(lever(car, c)[0] * (carried[c] - 9.81 * wheel[c]) for c in car.corners)
    assert abs(moment) < 1e-8


@pytest.mark.parametrize("model", ["half-car-4dof", "full-car"])
def test_momentum_of_all_masses(model):
    """What the road pushes beyond the weight accelerates the masses; its moments turn the body, lift-off or not."""
    car = CARS[model]
    loads = {"deceleration": {"value": 3.0, "start": 0.1}}
    if model == "full-car":
        loads |= {"right": HOLE, "lateral_acceleration": TURN}
    found, n = run(car, **loads), wheels_each(car)
    axle = {c: getattr(car, c.partition("_")[0]) for c in car.corners}
    excess = {  # of each wheel: tyre force less weight and inertia = what it passes on to the body
        c: n
        * (
            found[f"{c}.tyre.force"] - axle[c].unsprung_mass * (9.81 + found[f"{c}.unsprung.az"])
        ).values
        for c in car.corners
    }
    body = car.body
    lift = sum(excess.values()) - body.mass * (9.81 + found["body.az"].values)
    assert np.max(np.abs(lift)) < 1e-7
    nose_down = (
        -sum(lever(car, c)[0] * excess[c] for c in car.corners) + found["body.pitch_moment"].values
    )
    assert (
        np.max(np.abs(nose_down - body.pitch_inertia * found["body.pitch_acceleration"].values))
        < 1e-6
    )
    if model == "full-car":
        # the lateral forces act at the road: all of m a h, whatever the roll centres
        turn = body.mass * body.height * found["body.lateral_acceleration"].values
        rolled = sum(lever(car, c)[1] * excess[c] for c in car.corners) + turn
        assert (
            np.max(np.abs(rolled - body.roll_inertia * found["body.roll_acceleration"].values))
            < 1e-6
        )
        assert np.max(np.abs(turn)) > 3000.0


def test_energy_of_the_full_car():
    """Work of road, moments and gravity = change of what masses and springs hold + what dampers take.

    Also over lift-off (the tyre's law has no memory) and in a turn, with bars and stops.
    """
    changes = {
        "front.tyre.damping_coefficient": 0.0,
        "rear.tyre.damping_coefficient": 0.0,
        "front.bump_stop": {"gap": 0.19, "rate": 6e4},
    }
    car = FULL.with_changes(changes)
    found = run(
        car,
        right=HOLE,
        lateral_acceleration=TURN,
        deceleration={"value": 3.0, "start": 0.1},
        output_step=1e-4,
    )
    v = {name: found[name].values for name in found}
    dt = float(found["time"][1] - found["time"][0])
    stored = 0.5 * 1636.0 * v["body.vz"] ** 2 + 0.5 * 2500.0 * v["body.pitch_rate"] ** 2
    stored = stored + 0.5 * 600.0 * v["body.roll_rate"] ** 2 + 1636.0 * 9.81 * v["body.z"]
    lost = moved = 0.0
    for corner in car.corners:
        axle = getattr(car, corner.partition("_")[0])
        d = v[f"{corner}.strut.deflection"]
        stored = stored + 0.5 * axle.spring_rate * d**2
        if axle.bump_stop is not None:
            stored = stored + 0.5 * 6e4 * np.maximum(d - 0.19, 0.0) ** 2
        stored = stored + 0.5 * axle.unsprung_mass * v[f"{corner}.unsprung.vz"] ** 2
        stored = stored + axle.unsprung_mass * 9.81 * v[f"{corner}.unsprung.z"]
        stored = stored + 0.5 * 3e5 * np.maximum(v[f"{corner}.tyre.deflection"], 0.0) ** 2
        lost = lost + axle.damping_coefficient * v[f"{corner}.strut.velocity"] ** 2
        rate = np.gradient(v[f"{corner}.road.z"], dt)
        moved = moved + v[f"{corner}.tyre.force"] * rate
    for end in ("front", "rear"):  # a bar holds half its rate times the square of the difference
        axle = getattr(car, end)
        twist = v[f"{end}_left.strut.deflection"] - v[f"{end}_right.strut.deflection"]
        stored = stored + 0.5 * axle.anti_roll_bar_rate * twist**2
    moved = moved + v["body.pitch_moment"] * v["body.pitch_rate"]
    side = 1636.0 * v["body.lateral_acceleration"]
    for end, share in (("front", 1.62 / 2.91), ("rear", 1.29 / 2.91)):
        axle = getattr(car, end)
        moved = moved + share * side * (0.55 - axle.roll_centre_height) * v["body.roll_rate"]
        couple = share * side * axle.roll_centre_height / axle.track
        moved = moved + couple * (v[f"{end}_left.unsprung.vz"] - v[f"{end}_right.unsprung.vz"])
    power = moved - lost
    work = np.concatenate(([0.0], np.cumsum(0.5 * (power[1:] + power[:-1])) * dt))
    gained = stored - stored[0]
    assert min(float(v[f"{c}.tyre.force"].min()) for c in car.corners) == 0.0
    assert float(v["front_left.strut.deflection"].max()) > 0.19
    assert np.max(np.abs(gained - work)) < 2e-3 * np.max(np.abs(gained))
    assert np.max(np.abs(gained)) > 100.0


@pytest.mark.parametrize("compat", ["physical", "sign-corrected", "simulink"])
def test_superposition_of_the_half_car(compat):
    car = HALF.with_changes({"compat": compat})
    step = {"value": 500.0, "start": 0.3, "ramp": 0.2}
    both, road, load = (
        run(car, pitch_moment=step),
        run(car),
        run(car, road=jn.Flat(), pitch_moment=step),
    )
    for name in ("body.z", "body.pitch", "body.az", "front.strut.force", "rear.sprung.vz"):
        rest = float(road[name][0])
        total = (road[name] + load[name]).values - rest
        assert np.max(np.abs(both[name].values - total)) < 1e-8 * max(np.ptp(total), 1e-6), name


def test_superposition_of_the_full_car():
    """Left road, right road and turn add up as long as no wheel lifts off."""
    car = FULL.with_changes(LINEAR)
    flat = jn.Flat()
    everything = run(car, road=SMOOTH, right=HOLE, lateral_acceleration=TURN)
    parts = [
        run(car, road=SMOOTH, right=flat),
        run(car, road=flat, right=HOLE),
        run(car, road=flat, lateral_acceleration=TURN),
    ]
    for name in (
        "body.z",
        "body.roll",
        "body.pitch",
        "front_left.tyre.force",
        "rear_right.unsprung.az",
    ):
        rest = float(parts[0][name][0])
        total = sum(part[name].values - rest for part in parts) + rest
        assert np.max(np.abs(everything[name].values - total)) < 1e-7 * np.ptp(total), name


@pytest.mark.parametrize("model", ["half-car-4dof", "full-car"])
def test_reciprocity(model):
    """Tyre force at wheel j from the road at wheel i = the other way round, at every frequency (Maxwell-Betti)."""
    car = CARS[model]
    model = jn.linearise(car)
    for f in (0.0, 1.3, 8.0):
        for i in car.corners:
            for j in car.corners:
                there, back = (
                    model.frequency_response(f, f"{a}.tyre.force", f"{b}.road.z")[0]
                    for a, b in ((i, j), (j, i))
                )
                assert abs(there - back) < 1e-6 * 3e5


@pytest.mark.parametrize("model", ["half-car-4dof", "full-car"])
def test_stiffness_and_damping_are_symmetric_and_positive(model):
    car = CARS[model]
    a = jn.linearise(car).A
    n = len(a) // 2
    wheels = [
        getattr(car, c.partition("_")[0]).unsprung_mass * wheels_each(car) for c in car.corners
    ]
    body = [
        car.body.mass,
        car.body.pitch_inertia,
        *([car.body.roll_inertia] if model == "full-car" else []),
    ]
    masses = np.diag([*body, *wheels])
    for matrix in (-masses @ a[n:, :n], -masses @ a[n:, n:]):
        np.testing.assert_allclose(matrix, matrix.T, rtol=0, atol=1e-9 * np.max(np.abs(matrix)))
        assert np.linalg.eigvalsh(0.5 * (matrix + matrix.T)).min() > 0.0


@pytest.mark.parametrize("model", ["half-car-4dof", "full-car"])
def test_lift_off_converges(model):
    """Tighter tolerances meet the same end and beginning of contact; the error follows the tolerance."""
    car = CARS[model]
    loads = {"right": HOLE} if model == "full-car" else {}
    exact = run(car, tolerance=1e-11, method="explicit", **loads)
    assert exact.attrs["events"] >= 4
    scale = float(np.ptp(exact["body.z"].values))
    errors = []
    for tolerance in (1e-4, 1e-6, 1e-8):
        found = run(car, tolerance=tolerance, method="explicit", **loads)
        assert found.attrs["events"] == exact.attrs["events"]
        errors.append(float(np.max(np.abs(found["body.z"] - exact["body.z"]))) / scale)
        assert errors[-1] < 3.0 * tolerance
    assert errors[2] < 1e-2 * errors[0]


@pytest.mark.parametrize("model", CARS)
def test_nothing_moves_on_a_level_road(model):
    found = run(CARS[model], road=jn.Flat(), duration=5.0)
    for name in found:
        assert float(np.ptp(found[name].values)) < 1e-9, name


@pytest.mark.parametrize("model", CARS)
def test_a_road_at_another_height_moves_everything_by_it(model):
    lifted = jn.Table(x=[0.0, 1.0], height=[0.3, 0.3])
    found, level = (
        run(CARS[model], road=lifted, duration=0.2),
        run(CARS[model], road=jn.Flat(), duration=0.2),
    )
    for name in found:
        step = 0.3 if name.endswith(("body.z", "road.z", "sprung.z")) else 0.0
        np.testing.assert_allclose(found[name], level[name] + step, rtol=0, atol=1e-7)


def test_the_rear_axle_follows():
    found = run(HALF4, output_step=1e-3)
    late = round(2.91 / 10.0 / 1e-3)
    front, rear = found["front.road.z"].values, found["rear.road.z"].values
    np.testing.assert_allclose(rear[late:], front[:-late], rtol=0, atol=1e-12)
    assert np.all(rear[:late] == 0.0)


def test_a_free_body_conserves_nothing_it_should_not():
    """Undamped: after the bump the energy stays; a run of ten seconds loses none of it."""
    changes = {**LINEAR}
    for axle in ("front", "rear"):
        changes |= {f"{axle}.damping_coefficient": 0.0, f"{axle}.tyre.damping_coefficient": 0.0}
    car = HALF4.with_changes(changes)
    found = run(car, road=SMOOTH, duration=10.0, tolerance=1e-10)
    v = {name: found[name].values for name in found}
    energy = (
        0.5 * 1636.0 * v["body.vz"] ** 2
        + 0.5 * 2500.0 * v["body.pitch_rate"] ** 2
        + 1636.0 * 9.81 * v["body.z"]
    )
    for corner, k, m in (("front", 28e3, 45.0), ("rear", 21e3, 42.0)):
        energy = (
            energy + k * v[f"{corner}.strut.deflection"] ** 2 + m * v[f"{corner}.unsprung.vz"] ** 2
        )
        energy = (
            energy
            + 3e5 * v[f"{corner}.tyre.deflection"] ** 2
            + 2 * m * 9.81 * v[f"{corner}.unsprung.z"]
        )
    after = energy[found["time"].values > 1.0] - energy[0]
    assert np.ptp(after) < 1e-6 * abs(after.mean())
    assert after.mean() > 1.0


@pytest.mark.parametrize("model", CARS)
def test_changing_a_number_never_compiles_again(model):
    car = CARS[model]
    other = car.with_changes(
        {"body.mass": 1000.0, "front.spring_rate": 40e3, "rear.distance": 1.1, "gravity": 1.6}
    )
    assert compile_model(build(car)) is compile_model(build(other)) or (
        compile_model(build(car)).functions is compile_model(build(other)).functions
    )


def test_a_rate_is_no_track():
    """The response is to a value that brings its rate along; a rate alone is nothing that moves."""
    model = jn.linearise(HALF)
    for name in ("front.road.z rate", "pitch_moment rate"):
        assert name in model.inputs
        with pytest.raises(jn.DescriptionError, match="unknown track") as caught:
            model.frequency_response(1.0, "body.z", name)
        assert "allowed: front.road.z, pitch_moment, rear.road.z." in str(caught.value)
