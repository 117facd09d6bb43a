"""Vehicles and their readable twin are the same physics: every channel, on every model, load, law and kind of road."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

pytestmark = pytest.mark.usefixtures("optimised")

HALF = jn.load("audi-a6-half-car")
DEMO = jn.load("sldemo-half-car")
HALF4 = jn.load("audi-a6-half-car-4dof")
FULL = jn.load("audi-a6-full-car")
WHEELS = {"half-car-4dof": HALF4, "full-car": FULL}
BUMP = jn.HalfSine(height="15 mm", length="0.5 m", start="2 m")
HIGH_BUMP = jn.HalfSine(height="60 mm", length="0.5 m", start="2 m")
HOLE = jn.Trapezoid(height="-30 mm", length="1 m", ramp="0.2 m", start="3 m")
SPEED = 10.0


def compare(
    twin,
    vehicle,
    road,
    *,
    duration=0.7,
    speed=SPEED,
    right=None,
    allowed=2e-8,
    tolerance=1e-10,
    **loads,
):
    """Loads are (value, start, ramp); differences are counted against the range of the same kind of channel."""
    given = {
        name: {"value": value, "start": start, "ramp": ramp}
        for name, (value, start, ramp) in loads.items()
    }
    trial = jn.Trial(road=road, speed=speed, duration=duration, right=right, **given)
    run = jn.simulate(vehicle, trial, tolerance=tolerance).isel(time=slice(None, None, 3))
    assert run.attrs["status"] == "completed"
    signals = {name: twin.ramp(*values) for name, values in loads.items()}
    expected = twin.twin_of(
        vehicle, twin.driven(vehicle, road, speed, duration, right=right, **signals)
    ).run(run["time"].values)
    assert set(expected) == set(run) - {"body.lateral_acceleration"}
    sizes = {}
    for name, values in expected.items():
        kind = name.rpartition(".")[2]
        sizes[kind] = max(sizes.get(kind, 1e-9), float(np.ptp(values)))
    for name, values in expected.items():
        if (
            "roll" in name
            and vehicle.model == "full-car"
            and right is None
            and "lateral_acceleration" not in loads
        ):
            assert np.max(np.abs(run[name])) < 1e-9, name  # symmetric: nothing rolls
            continue
        error = np.max(np.abs(run[name].values - values)) / sizes[name.rpartition(".")[2]]
        assert error < allowed, (name, error)
    return run, expected


@pytest.mark.parametrize(
    "load", [{}, {"pitch_moment": (100.0, 0.3, 0.2)}, {"pitch_moment": (-2700.0, 0.25, 0.0)}]
)
@pytest.mark.parametrize("compat", ["physical", "sign-corrected", "simulink"])
@pytest.mark.parametrize("car", [HALF, DEMO], ids=["audi", "demo"])
def test_half_car_in_all_forms(vehicle_twin, car, compat, load):
    compare(vehicle_twin, car.with_changes({"compat": compat}), HIGH_BUMP, **load)


@pytest.mark.parametrize("compat", ["physical", "sign-corrected", "simulink"])
def test_half_car_on_a_step_and_under_a_load_from_the_start(vehicle_twin, compat):
    step = jn.Ramp(height="50 mm", length="0.5 m", shape="cosine", start="6 m")
    compare(
        vehicle_twin,
        HALF.with_changes({"compat": compat}),
        step,
        duration=1.3,
        pitch_moment=(100.0, 0.0, 0.0),
    )


@pytest.mark.parametrize(
    "road",
    [
        HIGH_BUMP,
        HOLE,
        jn.Rectangle(height="10 mm", length="0.3 m", start="2 m"),
        jn.Triangle(height="20 mm", length="0.4 m", start="2 m"),
        jn.CircularSegment(height="60 mm", length="3.7 m", start="2 m"),
        jn.Versine(height="30 mm", length="2 m", start="2 m", recurrence="4 m"),
        jn.Train(of=BUMP, count=3, pitch="0.8 m"),
        jn.Table(x=[0, 1, 2, 3, 4, 6], height=[0.01, 0.02, 0.01, -0.02, 0.0, 0.01], start="-1 m"),
    ],
    ids=lambda road: road.kind,
)
@pytest.mark.parametrize("model", WHEELS)
@pytest.mark.some(3)
def test_roads(vehicle_twin, model, road):
    compare(vehicle_twin, WHEELS[model], road, allowed=5e-8)


@pytest.mark.parametrize(
    "loads",
    [
        {"pitch_moment": (2000.0, 0.3, 0.1)},
        {"deceleration": (4.0, 0.3, 0.0)},
        {"deceleration": (-3.0, 0.0, 0.0)},
        {"deceleration": (3.0, 0.2, 0.3), "pitch_moment": (-500.0, 0.4, 0.0)},
    ],
)
@pytest.mark.parametrize("model", WHEELS)
def test_loads(vehicle_twin, model, loads):
    compare(vehicle_twin, WHEELS[model], BUMP, **loads)


@pytest.mark.parametrize(
    "loads",
    [
        {"lateral_acceleration": (4.0, 0.3, 0.2)},
        {"lateral_acceleration": (-4.0, 0.0, 0.0)},
        {
            "lateral_acceleration": (5.0, 0.2, 0.1),
            "deceleration": (3.0, 0.4, 0.0),
            "pitch_moment": (100.0, 0.0, 0.3),
        },
    ],
)
def test_cornering(vehicle_twin, loads):
    compare(vehicle_twin, FULL, BUMP, **loads)


def test_left_and_right_on_different_roads(vehicle_twin):
    run, _ = compare(
        vehicle_twin, FULL, HIGH_BUMP, right=HOLE, lateral_acceleration=(3.0, 0.2, 0.2)
    )
    assert np.ptp(run["body.roll"].values) > 0.01
    assert (
        min(float(run[f"{corner}.tyre.force"].min()) for corner in FULL.corners) == 0.0
    )  # a wheel lifts off


@pytest.mark.parametrize("rear_faster", [0.5, 2.0])
def test_an_unsymmetric_car(vehicle_twin, rear_faster):
    car = FULL.with_changes(
        {
            "rear.track": 1.3,
            "rear.roll_centre_height": -0.05,
            "front.roll_centre_height": 0.2,
            "rear.anti_roll_bar_rate": 0.0,
            "rear.spring_rate": 21000.0 * rear_faster,
            "gravity": 3.7,
        }
    )
    compare(
        vehicle_twin, car, HIGH_BUMP, right=BUMP, allowed=1e-7, lateral_acceleration=(2.0, 0.1, 0.2)
    )


TABLE = {
    "velocity": [-1.0, -0.2, -0.05, 0.0, 0.05, 0.3, 1.0],
    "force": [-3000.0, -900.0, -400.0, 0.0, 150.0, 500.0, 1200.0],
}
TANH = {
    "kind": "tanh",
    "coefficient": 1500.0,
    "force": 300.0,
    "slope": 10.0,
    "displacement_coupling": 2.0,
}
POLYNOMIAL = {"kind": "polynomial", "coefficients": [2e5, 2e6]}
BLOW_OFF = {
    "kind": "blow-off",
    "bump_blow_off_force": 300.0,
    "bump_blow_off_velocity": 0.1,
    "bump_high_speed_coefficient": 700.0,
    "rebound_blow_off_force": 700.0,
    "rebound_blow_off_velocity": 0.15,
    "rebound_high_speed_coefficient": 1500.0,
}
LAWS = {
    "no lift-off": {"front.tyre.lift_off": False, "rear.tyre.lift_off": False},
    "bilinear damper": {
        "front.damping_coefficient": None,
        "front.damper": {"bump_coefficient": 1500.0, "rebound_coefficient": 4500.0},
    },
    "blow-off damper": {"rear.damping_coefficient": None, "rear.damper": BLOW_OFF},
    "velocity table": {"rear.damping_coefficient": None, "rear.damper": TABLE},
    "tanh damper": {
        "front.damping_coefficient": None,
        "front.damper": {**TANH, "stiffness": 500.0, "offset": 40.0},
    },
    "bump stop": {"front.bump_stop": {"gap": 0.175, "rate": 6e4, "progression": 3e8}},
    "rebound stop": {"rear.rebound_stop": {"gap": -0.15, "rate": 6e4, "progression": 3e7}},
    "both stops closed at rest": {
        "rear.bump_stop": {"gap": 0.15, "rate": 6e4},
        "front.rebound_stop": {"gap": -0.18, "rate": 6e4},
    },
    "preload": {"front.spring_rate": None, "front.spring": {"rate": 25e3, "preload": 1500.0}},
    "spring curve": {
        "rear.spring_rate": None,
        "rear.spring": {"curve": {"kind": "polynomial", "coefficients": [1.5e4, 4e4]}},
    },
    "tyre curve": {"front.tyre.stiffness": None, "front.tyre.curve": POLYNOMIAL},
    "strong tyre damping": {"front.tyre.damping_coefficient": 1000.0},
    "friction": {"front.friction": {"force": 80.0, "regularisation_velocity": 0.02}},
}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("model", WHEELS)
@pytest.mark.some(3)
def test_laws(vehicle_twin, model, law):
    right = BUMP if model == "full-car" else None
    compare(
        vehicle_twin, WHEELS[model].with_changes(LAWS[law]), HIGH_BUMP, right=right, allowed=2e-7
    )


def test_everything_at_once(vehicle_twin):
    names = (
        "velocity table",
        "bump stop",
        "rebound stop",
        "spring curve",
        "tyre curve",
        "friction",
    )
    changes = {
        path: value
        for name in names
        for path, value in LAWS[name].items()
        if not path.startswith("rear.spring")
    }
    loads = {"lateral_acceleration": (5.0, 0.2, 0.1), "deceleration": (3.0, 0.4, 0.0)}
    compare(vehicle_twin, FULL.with_changes(changes), HIGH_BUMP, right=HOLE, allowed=3e-7, **loads)


@pytest.mark.parametrize(
    ("path", "factor"),
    [
        ("front.roll_centre_height", 1.05),
        ("rear.anti_roll_bar_rate", 1.05),
        ("body.height", 1.05),
        ("rear.track", 1.02),
    ],
)
def test_the_comparison_can_fail(vehicle_twin, path, factor):
    """A few percent of any number that only cornering feels is seen."""
    changed = FULL.with_changes({path: FULL.parameters()[path] * factor})
    loads = {"lateral_acceleration": (4.0, 0.3, 0.2)}
    trial = jn.Trial(
        road=BUMP,
        speed=SPEED,
        duration=0.8,
        lateral_acceleration={"value": 4.0, "start": 0.3, "ramp": 0.2},
    )
    run = jn.simulate(changed, trial, tolerance=1e-9)
    signals = {name: vehicle_twin.ramp(*values) for name, values in loads.items()}
    expected = vehicle_twin.twin_of(
        FULL, vehicle_twin.driven(FULL, BUMP, SPEED, 0.8, **signals)
    ).run(run["time"].values)
    assert (
        max(
            np.max(np.abs(run[name] - expected[name]))
            for name in expected
            if name.endswith("tyre.force")
        )
        > 5.0
    )


def perturbed(twin, car, signals, x):
    """Rates of all states, and all channels, under constant inputs ``name -> (value, rate)``."""
    inputs = {name: twin.constant(*pair) for name, pair in signals.items()}
    model = twin.twin_of(car, inputs)
    return np.asarray(model.rate(1.0, x)), model.channels(1.0, x)


@pytest.mark.parametrize(
    "car",
    [
        HALF.with_changes({"body.height": 0.6}),
        HALF.with_changes({"compat": "simulink"}),
        HALF.with_changes({"compat": "sign-corrected"}),
        HALF4.with_changes({"front.tyre.lift_off": False, "rear.tyre.lift_off": False}),
        FULL.with_changes(
            {"front.tyre.lift_off": False, "rear.tyre.lift_off": False, "rear.track": 1.4}
        ),
    ],
    ids=lambda car: f"{car.model} {getattr(car, 'compat', '')}".strip(),
)
def test_linear_models(vehicle_twin, car):
    """Every element of A, B, C and D; all is linear, so differences of one are exact."""
    compare_linear(vehicle_twin, car)


@pytest.mark.parametrize("seed", range(12))
def test_linear_models_of_any_car(vehicle_twin, seed):
    """Every number of a car drawn anew: an index that is mixed up somewhere does not stay hidden."""
    random = np.random.default_rng(seed)
    for car in (HALF, HALF4, FULL):
        sizes = random.uniform(0.5, 2.0, len(car.parameters()))
        changes = {
            path: value * size
            for (path, value), size in zip(car.parameters().items(), sizes, strict=True)
        }
        if car is not HALF:
            changes |= {"front.tyre.lift_off": False, "rear.tyre.lift_off": False}
        compare_linear(vehicle_twin, car.with_changes(changes))


def compare_linear(vehicle_twin, car):
    model = jn.linearise(car)
    full = car.model == "full-car"
    rest = vehicle_twin.twin_of(car, {}).rest()
    kept = [
        i
        for i in range(len(rest))
        if car.model != "half-car-4dof" or i not in (2, 2 + len(rest) // 2)
    ]
    names = ["body.z", "body.pitch", *(["body.roll"] if full else [])]
    names += [] if car.model == "half-car" else [f"{corner}.unsprung.z" for corner in car.corners]
    speeds = [
        f"{name}_rate" if name.endswith(("pitch", "roll")) else f"{name[:-1]}vz" for name in names
    ]
    assert list(model.states) == [*names, *speeds]
    base, outputs = perturbed(vehicle_twin, car, {}, rest)
    rows = [name for name in model.outputs if name in outputs]
    assert set(model.outputs) - set(rows) <= {"body.lateral_acceleration"}
    at = [model.outputs.index(name) for name in rows]
    a, b, c, d = (np.array(getattr(model, name)) for name in "ABCD")

    def check(column, x, signals, rates, outs, what):
        moved, channels = perturbed(vehicle_twin, car, signals, x)
        np.testing.assert_allclose(
            rates[:, column], (moved - base)[kept], rtol=1e-9, atol=1e-7, err_msg=what
        )
        found = [channels[name] - outputs[name] for name in rows]
        np.testing.assert_allclose(outs[at, column], found, rtol=1e-9, atol=1e-7, err_msg=what)

    for column, i in enumerate(kept):
        check(column, rest + np.eye(len(rest))[i], {}, a, c, model.states[column])
    tracks = [name for name in model.inputs if f"{name} rate" in model.inputs]
    assert len(tracks) == len(car.corners) + 1 + (car.body.height is not None) + full
    for track in tracks:
        column = model.inputs.index(track)
        check(column, rest, {track: (1.0, 0.0)}, b, d, track)
        check(column + 1, rest, {track: (0.0, 1.0)}, b, d, f"{track} rate")


@pytest.mark.parametrize("model", WHEELS)
def test_both_methods_agree(model):
    loads = {"deceleration": {"value": 3.0, "start": 0.4}}
    if model == "full-car":
        loads |= {"right": HOLE, "lateral_acceleration": {"value": 4.0, "start": 0.2, "ramp": 0.1}}
    trial = jn.Trial(road=HIGH_BUMP, speed=SPEED, duration=1.5, **loads)
    one, other = (
        jn.simulate(WHEELS[model], trial, tolerance=1e-8, method=name)
        for name in ("explicit", "implicit")
    )
    assert (one.attrs["method"], other.attrs["method"]) == ("explicit", "implicit")
    for name in one:
        size = max(float(np.ptp(one[name].values)), 1e-9)
        assert np.max(np.abs(one[name].values - other[name].values)) < 1e-6 * size, name
