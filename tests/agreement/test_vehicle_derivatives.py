"""Exact sensitivities and gradients of vehicles equal central differences of runs, and of the readable twin."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

pytestmark = pytest.mark.usefixtures("optimised")

HALF = jn.load("audi-a6-half-car")
HALF4 = jn.load("audi-a6-half-car-4dof")
FULL = jn.load("audi-a6-full-car")
DISTANCES = ("front.distance", "rear.distance")
BUMP = jn.HalfSine(height="20 mm", length="0.5 m", start="2 m")
HIGH_BUMP = jn.HalfSine(height="60 mm", length="0.5 m", start="2 m")
LOADS = {
    "half-car": {"pitch_moment": {"value": 800.0, "start": 0.2}},
    "half-car-4dof": {"pitch_moment": {"value": 800.0, "start": 0.2}, "deceleration": 3.0},
    "full-car": {
        "right": jn.Versine(height="30 mm", length="2 m", start="3 m"),
        "lateral_acceleration": {"value": 4.0, "start": 0.3, "ramp": 0.1},
        "deceleration": {"value": 3.0, "start": 0.2},
    },
}
CHANNELS = (
    "body.z",
    "body.pitch",
    "body.roll",
    "front.strut.force",
    "rear_left.tyre.force",
    "front_right.unsprung.z",
)


def trial_of(car, road=BUMP, duration=1.0):
    return jn.Trial(road=road, speed="10 m/s", duration=duration, **LOADS[car.model])


def differences(car, trial, path: str, run) -> dict[str, np.ndarray]:
    value = car.parameters()[path]
    step = 1e-5 * (abs(value) or 1.0)
    ahead, behind = (run(car.with_changes({path: value + sign * step}), trial) for sign in (1, -1))
    return {
        name: (np.asarray(ahead[name]) - np.asarray(behind[name])) / (2.0 * step) for name in ahead
    }


def compare(slopes, car, trial, run, paths, *, allowed: float) -> None:
    for path in paths:
        expected = differences(car, trial, path, run)
        for name in (name for name in CHANNELS if name in expected and name in slopes):
            found = slopes[name].sel(parameter=path).values
            error = np.abs(found - expected[name])
            size = max(np.max(np.abs(expected[name])), 1e-13)
            assert np.median(error) < allowed * size, (path, name)
            assert np.quantile(error, 0.995) < 30.0 * allowed * size, (
                path,
                name,
            )  # a sample at a located event


def simulated(car, trial):
    return jn.simulate(car, trial, tolerance=1e-12)


@pytest.mark.parametrize("road", [BUMP, HIGH_BUMP], ids=["on the road", "lift-off"])
@pytest.mark.parametrize("car", [HALF, HALF4, FULL], ids=lambda car: car.model)
def test_every_parameter(car, road):
    trial = trial_of(car, road)
    paths = [path for path in car.parameters() if path not in DISTANCES]
    compare(
        jn.sensitivities(car, trial, paths, tolerance=1e-9),
        car,
        trial,
        simulated,
        paths,
        allowed=2e-5,
    )


@pytest.mark.parametrize(
    ("car", "trial"),
    [
        (HALF.with_changes({"compat": "sign-corrected"}), trial_of(HALF)),
        (
            HALF4,
            jn.Trial(
                road=jn.Flat(),
                speed="10 m/s",
                duration="1 s",
                deceleration={"value": 3.0, "start": "0.1 s"},
            ),
        ),
        (
            HALF4,
            jn.Trial(
                excitation=jn.Excitation(
                    time=np.linspace(0, 1, 101), height=0.01 * np.sin(np.arange(101))
                )
            ),
        ),
    ],
    ids=["both axles at once", "flat road", "shaker"],
)
def test_distances_where_nothing_is_delayed(car, trial):
    compare(
        jn.sensitivities(car, trial, DISTANCES, tolerance=1e-9),
        car,
        trial,
        simulated,
        DISTANCES,
        allowed=2e-5,
    )


@pytest.mark.parametrize("car", [HALF, HALF4, FULL], ids=lambda car: car.model)
def test_the_wheelbase_on_a_road_is_refused(car):
    """It moves the road under the rear axle in time, which sensitivities along with the run do not see."""
    for derive in (
        lambda: jn.sensitivities(car, trial_of(car), ["rear.distance"]),
        lambda: jn.gradient(car, trial_of(car), ["body.mass", "front.distance"], {"body.az": 1.0}),
    ):
        with pytest.raises(jn.SimulationError, match="rear axle meets the road"):
            derive()


@pytest.mark.parametrize("car", [HALF, FULL], ids=lambda car: car.model)
def test_the_twin_says_the_same(vehicle_twin, car):
    """Central differences of the twin, which shares no code with the model."""
    trial, duration = trial_of(car, duration=0.6), 0.6
    times = np.linspace(0.0, duration, 601)
    if car is HALF:
        loads = {"pitch_moment": vehicle_twin.ramp(800.0, 0.2)}
    else:
        lateral, braking = vehicle_twin.ramp(4.0, 0.3, 0.1), vehicle_twin.ramp(3.0, 0.2)
        loads = {"lateral_acceleration": lateral, "deceleration": braking}

    def run(changed, _):
        signals = vehicle_twin.driven(changed, BUMP, 10.0, duration, right=trial.right, **loads)
        return vehicle_twin.twin_of(changed, signals).run(times, tolerance=1e-12)

    paths = ["body.mass", "front.spring_rate", "rear.damping_coefficient"]
    if car is FULL:
        paths = ["body.height", "rear.track", "front.roll_centre_height", "rear.anti_roll_bar_rate"]
    compare(
        jn.sensitivities(car, trial, paths, tolerance=1e-9), car, trial, run, paths, allowed=1e-4
    )


@pytest.mark.parametrize("car", [HALF, HALF4, FULL], ids=lambda car: car.model)
def test_gradient(car):
    trial, path = trial_of(car), "rear.damping_coefficient"
    objective = {"body.az": 1.0, "body.pitch_acceleration": 0.5}
    found = jn.gradient(car, trial, [path, "body.mass"], objective, tolerance=1e-9)
    for name in (path, "body.mass"):
        value = car.parameters()[name]
        step = 1e-4 * value
        sums = []
        for sign in (1, -1):
            run = simulated(car.with_changes({name: value + sign * step}), trial)
            sums.append(
                sum(weight * float((run[key] ** 2).mean()) for key, weight in objective.items())
            )
        assert abs(found.gradient[name] / ((sums[0] - sums[1]) / (2 * step)) - 1.0) < 1e-4
