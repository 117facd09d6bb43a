"""Cars on solid axles and twist beams against a model of their own in maximal coordinates: modes, bumps, energy."""

from __future__ import annotations

import numpy as np
import pytest
from cars_on_axles import Car, Equations

import jounce as jn
from jounce.parts import DependentAxle, FullCar3D
from jounce.parts.vehicles import SpatialAxle

WATT = {
    "watt_pivot": [-0.1, 0.0, 0.34],
    "watt_upper_axle": [-0.1, 0.0, 0.40],
    "watt_upper_body": [-0.1, 0.5, 0.41],
    "watt_lower_axle": [-0.1, 0.0, 0.28],
    "watt_lower_body": [-0.1, -0.5, 0.27],
}
LEVER = {
    "mass": 1.5,
    "centre_of_mass": [-0.1, 0.0, 0.34],
    "inertia": {"xx": 0.004, "yy": 0.004, "zz": 0.001},
}
SPEED, HEIGHT, LENGTH, START = 8.0, 0.03, 0.8, 0.4


def rod() -> DependentAxle:
    return jn.load("van-rear-axle")  # type: ignore[return-value]


def watt() -> DependentAxle:
    table = rod().model_dump(by_alias=True, exclude_none=True)
    points = {k: v for k, v in table["hardpoints"].items() if not k.startswith("panhard")}
    table |= {"hardpoints": points | WATT, "bodies": table["bodies"] | {"watt_lever": LEVER}}
    return type(rod()).from_table(table)  # type: ignore[return-value]


def beam() -> DependentAxle:
    ideal = {"bushings": {}, "strut.spring.preload": 6000.0}
    return jn.load("twist-beam").with_changes(ideal)  # type: ignore[return-value]


def car(rear: DependentAxle) -> FullCar3D:
    """A car with a solid axle in front, and any behind."""
    front = SpatialAxle(distance=1.45, axle=rod(), anti_roll_bar_rate=12e3)
    axles = {"front": front, "rear": SpatialAxle(distance=1.45, axle=rear)}
    return jn.load("van-full-car-3d").model_copy(update=axles)  # type: ignore[return-value]


@pytest.mark.parametrize(
    "rear",
    [rod, pytest.param(watt, marks=pytest.mark.slow), pytest.param(beam, marks=pytest.mark.slow)],
)
def test_modes_are_those_of_the_car_linearised_in_maximal_coordinates(rear) -> None:
    ours = [(2.0 * np.pi * m.frequency_hz, m.damping_ratio) for m in jn.modes(car(rear()))]
    found = Equations(Car(car(rear()))).eigenvalues()
    theirs = [(abs(value), -value.real / abs(value)) for value in found]
    assert len(ours) == 7
    assert np.array(ours) == pytest.approx(np.array(theirs), rel=1e-9)


def bump(t: float) -> tuple[np.ndarray, np.ndarray]:
    """Height and rate of a half sine under the left wheels; order: front left, front right, rear left, rear right."""
    heights, rates = np.zeros(4), np.zeros(4)
    for wheel, behind in ((0, 0.0), (2, 2.9)):
        s = (SPEED * t - behind - START) / LENGTH
        if 0.0 < s < 1.0:
            heights[wheel] = HEIGHT * np.sin(np.pi * s)
            rates[wheel] = HEIGHT * np.pi * SPEED / LENGTH * np.cos(np.pi * s)
    return heights, rates


def one_sided(duration: float) -> jn.Trial:
    road = jn.HalfSine(height=HEIGHT, length=LENGTH, start=START)
    return jn.Trial(road=road, right=jn.Flat(), speed=SPEED, duration=duration)


def test_a_bump_under_the_left_wheels_moves_the_car_as_in_maximal_coordinates() -> None:
    run = jn.simulate(car(rod()), one_sided(0.9), tolerance=1e-9)
    equations = Equations(Car(car(rod())))
    times = run["time"].values[::10]
    states = equations.run(times, bump)
    n = states.shape[1] // 2
    shown = [equations.shown(state[:n]) for state in states]
    body = np.array([np.array(part[0])[:, 0] for part in shown])
    wheels = np.array([np.array(part[1])[:, 0] for part in shown]) - 0.34
    for i, (name, scale) in enumerate((("z", 1.0), ("pitch", 1.0), ("roll", 1.0))):
        ours = run[f"body.{name}"].values[::10]
        assert np.ptp(ours) > 0.004 * scale
        assert ours == pytest.approx(body[:, i], abs=1e-9), name
    for i, place in enumerate(("front_left", "front_right", "rear_left", "rear_right")):
        ours = run[f"{place}.unsprung.z"].values[::10]
        assert ours == pytest.approx(wheels[:, i], abs=1e-9), place


def test_without_dampers_the_energy_after_a_bump_stays() -> None:
    undamped = car(rod()).with_changes(
        {"front.anti_roll_bar_rate": 0.0}
        | {
            f"{end}.axle.{path}": 0.0
            for end in ("front", "rear")
            for path in ("strut.damper.coefficient", "tyre.damping_coefficient")
        }
    )
    trial = one_sided(1.1)
    run = jn.simulate(undamped, trial, tolerance=1e-9, detail=True)
    energy = run["energy.kinetic"].values + run["energy.weight"].values
    for end in ("front", "rear"):
        axle = getattr(undamped, end).axle
        spring = axle.strut.spring
        for side in ("left", "right"):
            place = f"{end}_{side}"
            d, pressed = (run[f"{place}.{part}.deflection"].values for part in ("strut", "tyre"))
            assert -axle.strut.rebound_stop.gap < d.min() < d.max() < axle.strut.bump_stop.gap
            energy = energy + spring.preload * d + 0.5 * spring.rate * d**2
            energy = energy + 0.5 * axle.tyre.stiffness * np.maximum(pressed, 0.0) ** 2
    after = run["time"].values > (START + LENGTH + 2.9) / SPEED + 0.01
    assert np.ptp(energy) > 20.0
    assert np.ptp(energy[after]) < 1e-4 * np.ptp(energy)


@pytest.mark.slow
def test_a_symmetric_road_does_not_roll_a_symmetric_car() -> None:
    rear = SpatialAxle(
        distance=1.45, axle=jn.load("twist-beam").with_changes({"strut.spring.preload": 6000.0})
    )
    twist = jn.load("van-full-car-3d").model_copy(update={"rear": rear})
    road = jn.HalfSine(height=HEIGHT, length=LENGTH, start=START)
    run = jn.simulate(twist, jn.Trial(road=road, speed=SPEED, duration=0.9))
    assert np.ptp(run["body.pitch"].values) > 0.005
    assert np.abs(run["body.roll"].values).max() < 1e-9
    assert run["rear_left.unsprung.z"].values == pytest.approx(
        run["rear_right.unsprung.z"].values, abs=1e-9
    )
    assert np.abs(run["rear.beam.twist"].values).max() < 1e-9
    alone = jn.simulate(twist, one_sided(0.9))
    assert np.ptp(alone["rear.beam.twist"].values) > 0.01


def test_one_wheel_of_a_solid_axle_leans_the_other() -> None:
    run = jn.simulate(car(rod()), one_sided(0.9))
    lean = run["rear_left.wheel.camber"].values + run["rear_right.wheel.camber"].values
    start = lean[0]
    assert lean == pytest.approx(np.full_like(lean, start), abs=1e-12)  # one body
    assert np.ptp(run["rear_right.wheel.camber"].values) > 0.01
