"""The kernel and the readable twin are the same physics: every channel, on every law and kind of road."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import jounce as jn
from jounce import parts
from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE, Segments
from jounce.models import build
from jounce.simulation.compiled import compile_model
from jounce.simulation.prepare import solve
from jounce.simulation.settings import output_times

pytestmark = pytest.mark.usefixtures("optimised")

KART = parts.load("kart-quarter-car")
AUDI = parts.load("audi-a6-quarter-car")
POWER = {"kind": "power", "coefficient": 1.5e6, "exponent": 1.4}

BLOW_OFF = {
    "kind": "blow-off",
    "bump_blow_off_force": 9.0,
    "bump_blow_off_velocity": 0.06,
    "bump_high_speed_coefficient": 40.0,
    "rebound_blow_off_force": 25.0,
    "rebound_blow_off_velocity": 0.1,
    "rebound_high_speed_coefficient": 80.0,
}

RIGS = {
    "linear": {"tyre.lift_off": False},
    "linear with tyre damping": {"tyre.lift_off": False, "tyre.damping_coefficient": 60.0},
    "lift-off": {},
    "little tyre damping": {"tyre.damping_coefficient": 20.0},
    "much tyre damping": {"tyre.damping_coefficient": 600.0},
    "bilinear damper": {"strut.damper": {"bump_coefficient": 80.0, "rebound_coefficient": 240.0}},
    "blow-off damper": {"strut.damper": BLOW_OFF},
    "velocity table": {
        "strut.damper": {
            "velocity": [-1.0, -0.2, -0.05, 0.0, 0.05, 0.3, 1.0],
            "force": [-120.0, -60.0, -30.0, 0.0, 10.0, 30.0, 60.0],
        }
    },
    "tanh damper": {
        "strut.damper": {
            "kind": "tanh",
            "coefficient": 80.0,
            "force": 20.0,
            "slope": 30.0,
            "displacement_coupling": 3.0,
            "stiffness": 500.0,
            "offset": 4.0,
        }
    },
    "friction": {
        "strut.friction": {"force": 12.0},
        "guide.friction": {"force": 6.0, "regularisation_velocity": 0.005},
    },
    "bump stop": {"strut.bump_stop": {"gap": 0.012, "rate": 6e4, "progression": 3e8}},
    "bump stop closed at rest": {
        "strut.bump_stop": {"gap": 0.005, "rate": 6e4, "progression": 3e8}
    },
    "polynomial tyre": {
        "tyre.stiffness": None,
        "tyre.curve": {"kind": "polynomial", "coefficients": [6e4, 2e7, -1e8]},
    },
    "table tyre": {
        "tyre.stiffness": None,
        "tyre.curve": {
            "kind": "table",
            "deflection": [0.0, 0.001, 0.002, 0.004, 0.01],
            "force": [0.0, 60.0, 150.0, 420.0, 1400.0],
        },
    },
    "spring curve and preload": {
        "strut.spring": {
            "curve": {"kind": "polynomial", "coefficients": [15e3, 4e5, 2e7]},
            "preload": 60.0,
        }
    },
    "spring table": {
        "strut.spring": {
            "rate": None,
            "curve": {
                "kind": "table",
                "deflection": [0.0, 0.005, 0.01, 0.02],
                "force": [0.0, 80.0, 190.0, 500.0],
            },
        }
    },
    "upright strut and preload": {"strut.angle": 0.0, "strut.spring.preload": 100.0},
    "strut at 10 deg": {"strut.angle": "10 deg"},
    "no damping at all": {"strut.damper.coefficient": 0.0},
}


def obstacle(
    kind: int, coefficients: list[float], *, length: float = 0.06, start: float = 0.1
) -> Segments:
    """Flat, one piece, flat: against distance."""
    flat = [0.0] * 4
    return Segments(
        np.array([0.0, start, start + length, 100.0]),
        np.array([POLYNOMIAL, kind, POLYNOMIAL]),
        np.array([flat, coefficients, flat]),
    )


HALF_SINE = obstacle(SINE, [0.0, 0.01, np.pi / 0.06, 0.0])
ROADS = {
    "rectangle": obstacle(POLYNOMIAL, [0.01, 0.0, 0.0, 0.0]),
    "long rectangle": obstacle(POLYNOMIAL, [0.01, 0.0, 0.0, 0.0], length=0.4),
    "hole": obstacle(POLYNOMIAL, [-0.01, 0.0, 0.0, 0.0], length=0.1),
    "half-cylinder": obstacle(CIRCLE, [0.0, 0.01, 0.01, 1.0], length=0.02),
    "cubic": obstacle(POLYNOMIAL, [0.0, 0.0, 3 * 0.01 / 0.06**2, -2 * 0.01 / 0.06**3]),
    "shaken": Segments(
        np.array([0.0, 9.0]), np.array([SINE]), np.array([[0.0, 0.002, 2 * np.pi * 2.5, 0.0]])
    ),
}


def compare(twin, rig, road, *, duration: float = 0.6, allowed: float = 2e-8) -> None:
    times = output_times(duration, 1e-3)
    compiled = compile_model(build(rig))
    solution = solve(
        compiled, compiled.parameter_values(rig.parameters()), road, times, tolerance=1e-10
    )
    expected = twin.QuarterCarTwin(rig, twin.road_pieces(road)).run(times, tolerance=1e-11)
    assert solution.status.name == "COMPLETED"
    for name, row in zip(compiled.output_names, solution.outputs, strict=True):
        size = max(np.ptp(expected[name]), 1e-9)
        assert np.max(np.abs(row - expected[name])) < allowed * size, name


@pytest.mark.parametrize("name", RIGS)
@pytest.mark.some(2)
def test_laws(twin, name):
    allowed = (
        3e-7 if name == "friction" else 2e-8
    )  # the friction force magnifies errors of small velocities
    compare(twin, KART.with_changes(RIGS[name]), HALF_SINE.in_time(2.86), allowed=allowed)


@pytest.mark.parametrize("speed", [1.95, 2.86, 3.79])
def test_speeds(twin, speed):
    compare(twin, KART, HALF_SINE.in_time(speed), duration=1.0)


@pytest.mark.parametrize("name", ROADS)
def test_roads(twin, name):
    compare(twin, KART, ROADS[name].in_time(1.95))


@pytest.mark.parametrize("name", [name for name in ROADS if name != "half-cylinder"])
def test_roads_with_tyre_damping(twin, name):
    """At a jump of the road the twin's tyre damper feels nothing, by its own definition."""
    compare(twin, KART.with_changes({"tyre.damping_coefficient": 60.0}), ROADS[name].in_time(1.95))


def test_passenger_car(twin):
    road = obstacle(SINE, [0.0, 0.08, np.pi / 0.5, 0.0], length=0.5, start=0.5)
    compare(twin, AUDI, road.in_time(8.0), duration=1.2)


def test_everything_at_once(twin):
    changes = {
        **RIGS["friction"],
        **RIGS["bump stop"],
        **RIGS["table tyre"],
        **RIGS["velocity table"],
    }
    compare(
        twin,
        KART.with_changes({**changes, "tyre.damping_coefficient": 30.0}),
        HALF_SINE.in_time(1.95),
        allowed=3e-7,
    )


def test_bouc_wen(twin):
    compare(
        twin, KART.with_changes({"strut.damper": BOUC_WEN}), HALF_SINE.in_time(2.86), allowed=1e-7
    )


def test_bouc_wen_coarsely(twin):
    compare(
        twin, KART.with_changes({"strut.damper": BOUC_WEN}), HALF_SINE.in_time(2.86), allowed=2e-5
    )


BOUC_WEN = {
    "kind": "bouc-wen",
    "coefficient": 80.0,
    "hysteretic_force": 20.0,
    "rate": 800.0,
    "sigma": 0.8,
    "exponent": 1.6,
    "stiffness": 300.0,
    "offset": -3.0,
}


def test_power_law_tyre(twin):
    compare(
        twin,
        KART.with_changes({"tyre.stiffness": None, "tyre.curve": POWER}),
        HALF_SINE.in_time(1.95),
    )


def test_power_law_spring(twin):
    rig = KART.with_changes({"strut.spring": {"rate": None, "curve": POWER}})
    compare(twin, rig, HALF_SINE.in_time(1.95))


def test_half_cylinder_with_tyre_damping():
    """The tyre damper's impulse at the vertical foot is finite: the run must pass it and converge."""
    rig = KART.with_changes({"tyre.damping_coefficient": 60.0})
    compiled = compile_model(build(rig))
    p, times = compiled.parameter_values(rig.parameters()), output_times(0.4, 1e-3)
    runs = [
        solve(compiled, p, ROADS["half-cylinder"].in_time(1.95), times, tolerance=t)
        for t in (1e-5, 1e-7)
    ]
    assert [run.status.name for run in runs] == ["COMPLETED"] * 2
    assert np.max(np.abs(runs[0].states[:2] - runs[1].states[:2])) < 1e-5 * np.ptp(
        runs[1].states[1]
    )


@pytest.mark.parametrize("height", [0.01, -0.01])
@pytest.mark.parametrize("lift_off", [True, False])
def test_a_jump_gives_the_wheel_the_blow_of_the_tyre_s_damper(height, lift_off):
    """A jump of the road moves the velocity of the wheel by c h / m, but where the tyre may leave the road: down.

    The course behind the jump is that of the equations of motion from there on, by SciPy.
    """
    rig = AUDI.with_changes({"tyre.lift_off": lift_off})
    run = jn.simulate(
        rig, jn.Trial(road=jn.Step(height=height, start=1.0), speed=5.0, duration=0.7)
    )
    body, wheel, k, c, tyre, d = (rig.parameters()[path] for path in (
        "sprung.mass", "unsprung.mass", "strut.spring.rate", "strut.damper.coefficient", "tyre.stiffness",
        "tyre.damping_coefficient"))  # fmt: skip
    load = (body + wheel) * 9.81

    def rates(_, x):
        force = load + tyre * (height - x[1]) - d * x[3]
        force = max(force, 0.0) if lift_off else force
        strut = k * (x[1] - x[0]) + c * (x[3] - x[2])
        return [x[2], x[3], strut / body, (force - load - strut) / wheel]

    blow = 0.0 if lift_off and height < 0.0 else d * height / wheel
    after = run["time"].values > 0.2
    found = solve_ivp(rates, (0.0, 0.5), [0.0, 0.0, 0.0, blow], method="DOP853", rtol=1e-9, atol=1e-12, max_step=1e-3,
                      t_eval=run["time"].values[after] - 0.2).y  # fmt: skip
    for name, expected in (("sprung.z", found[0]), ("unsprung.z", found[1])):
        moved = run[name].values[after] - run[name].values[0]
        assert np.max(np.abs(moved - expected)) < 1e-5 * np.ptp(expected), name


@pytest.mark.parametrize(("step", "reason"), [(0.0, ""), (1e-3, "bump"), (-1e-3, "rebound")])
def test_the_twin_itself_can_fail(twin, step, reason):
    """A millimetre of preload-like disturbance is seen: the comparison is not blind."""
    changed = KART.with_changes({"strut.spring.preload": step * 18e3})
    road = HALF_SINE.in_time(1.95)
    times = output_times(0.3, 1e-3)
    compiled = compile_model(build(KART))
    z = solve(
        compiled, compiled.parameter_values(KART.parameters()), road, times, tolerance=1e-9
    ).outputs[6]
    expected = twin.QuarterCarTwin(changed, twin.road_pieces(road)).run(times)["sprung.z"]
    assert (np.max(np.abs(z - expected)) > 5e-4) == bool(reason)
