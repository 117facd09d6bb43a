"""Sensitivities that ride along with the state equal central differences of runs at a tight tolerance."""

from __future__ import annotations

import numpy as np
import pytest

from jounce import parts
from jounce.models import build
from jounce.roads import HalfSine, Rectangle, Triangle
from jounce.simulation.compiled import compile_model
from jounce.simulation.prepare import solve
from jounce.simulation.settings import output_times

KART = parts.load("kart-quarter-car")
BUMP = HalfSine(height=0.01, length=0.06, start=0.1)
CLEAT = Rectangle(height=0.01, length=0.06, start=0.1)
BASIC = (
    "sprung.mass",
    "unsprung.mass",
    "gravity",
    "strut.angle",
    "strut.spring.rate",
    "strut.damper.coefficient",
    "tyre.stiffness",
)
DAMPED = {"tyre.damping_coefficient": 60.0}
TABLE = {
    "strut.damper": {
        "velocity": [-1.0, -0.2, 0.0, 0.3, 1.0],
        "force": [-120.0, -60.0, 0.0, 30.0, 60.0],
    }
}
BLOW_OFF = {
    "kind": "blow-off",
    "bump_blow_off_force": 9.0,
    "bump_blow_off_velocity": 0.06,
    "bump_high_speed_coefficient": 40.0,
    "rebound_blow_off_force": 25.0,
    "rebound_blow_off_velocity": 0.1,
    "rebound_high_speed_coefficient": 80.0,
}
TANH = {
    "strut.damper": {
        "kind": "tanh",
        "coefficient": 80.0,
        "force": 20.0,
        "slope": 30.0,
        "displacement_coupling": 3.0,
        "stiffness": 500.0,
        "offset": 4.0,
    }
}
FRICTION = {
    "strut.friction": {"force": 12.0},
    "guide.friction": {"force": 6.0, "regularisation_velocity": 0.005},
}
POLYNOMIAL_TYRE = {
    "tyre.stiffness": None,
    "tyre.curve": {"kind": "polynomial", "coefficients": [6e4, 2e7]},
}
TABLE_TYRE = {
    "tyre.stiffness": None,
    "tyre.curve": {
        "kind": "table",
        "deflection": [0.0, 0.001, 0.002, 0.01],
        "force": [0.0, 60.0, 150.0, 1400.0],
    },
}
CASES = {
    "lift-off": ({}, BUMP, BASIC),
    "tyre damping": (DAMPED, BUMP, (*BASIC, "tyre.damping_coefficient")),
    "no lift-off": (
        {"tyre.lift_off": False},
        BUMP,
        ("sprung.mass", "unsprung.mass", "strut.spring.rate"),
    ),
    "cleat": ({}, CLEAT, BASIC),
    "preload": ({"strut.spring.preload": 40.0}, BUMP, ("strut.angle",)),
    "bilinear": (
        {"strut.damper": {"bump_coefficient": 80.0, "rebound_coefficient": 240.0}},
        BUMP,
        ("strut.damper.bump_coefficient", "strut.damper.rebound_coefficient"),
    ),
    "velocity table": (
        TABLE,
        BUMP,
        (*(f"strut.damper.force[{i}]" for i in range(5)), "strut.damper.velocity[1]"),
    ),
    "blow-off": (
        {"strut.damper": BLOW_OFF},
        BUMP,
        tuple(f"strut.damper.{name}" for name in BLOW_OFF if name != "kind"),
    ),
    "tanh": (
        TANH,
        BUMP,
        tuple(
            f"strut.damper.{name}"
            for name in ("coefficient", "force", "slope", "displacement_coupling", "offset")
        ),
    ),
    "friction": (
        FRICTION,
        BUMP,
        ("strut.friction.force", "guide.friction.force", "guide.friction.regularisation_velocity"),
    ),
    "bump stop": (
        {"strut.bump_stop": {"gap": 0.012, "rate": 6e4, "progression": 3e8}},
        BUMP,
        tuple(f"strut.bump_stop.{name}" for name in ("gap", "rate", "progression")),
    ),
    "polynomial tyre": (
        POLYNOMIAL_TYRE,
        BUMP,
        ("tyre.curve.coefficients[0]", "tyre.curve.coefficients[1]"),
    ),
    "table tyre": (TABLE_TYRE, BUMP, ("tyre.curve.force[2]", "tyre.curve.deflection[2]")),
    "spring curve": (
        {
            "strut.spring": {
                "rate": None,
                "preload": 60.0,
                "curve": {"kind": "polynomial", "coefficients": [15e3, 4e5]},
            }
        },
        BUMP,
        ("strut.spring.curve.coefficients[0]", "strut.spring.curve.coefficients[1]"),
    ),
}


def compare(
    changes, road, free, *, speed: float = 1.95, duration: float = 0.5, allowed: float = 2e-5
) -> None:
    rig = KART.with_changes(changes)
    model = build(rig)
    plain, sensitive = compile_model(model), compile_model(model, free)
    p, times = plain.parameter_values(rig.parameters()), output_times(duration, 1e-3)
    segments = road.segments(speed * duration).in_time(speed)
    run = solve(sensitive, p, segments, times, tolerance=1e-9)
    n = plain.state_count
    assert run.state_slopes.shape == (n, len(free), len(times))
    assert run.output_slopes.shape == (len(plain.output_names), len(free), len(times))
    for column, path in enumerate(free):
        i = model.parameters.index(path)
        step = 1e-5 * (abs(p[i]) or 1.0)
        ahead, behind = (
            solve(plain, p + sign * step * np.eye(len(p))[i], segments, times, tolerance=1e-12)
            for sign in (1, -1)
        )
        expected = (ahead.states - behind.states) / (2.0 * step)
        found = run.state_slopes[:, column]
        size = np.max(np.abs(expected[: n // 2]))
        assert np.max(np.abs(found - expected)[: n // 2]) < allowed * size, path
        size = np.max(np.abs(expected))
        assert np.max(np.abs(found - expected)) < allowed * size, path
    forces = plain.output_names.index("strut.deflection")  # outputs follow the chain rule, too
    expected = (ahead.outputs - behind.outputs)[forces] / (2.0 * step)
    assert np.max(np.abs(run.output_slopes[forces, -1] - expected)) < allowed * np.max(
        np.abs(expected)
    )


@pytest.mark.parametrize("name", CASES)
def test_every_kind_of_parameter(name):
    compare(
        *CASES[name], allowed=1e-4 if name == "friction" else 2e-5
    )  # sharp bends cost the differences digits


def test_states_are_those_of_a_run_without_sensitivities():
    model = build(KART)
    plain, sensitive = compile_model(model), compile_model(model, BASIC)
    p, times = plain.parameter_values(KART.parameters()), output_times(0.5, 1e-3)
    segments = BUMP.segments(1.0).in_time(1.95)
    a, b = (
        solve(compiled, p, segments, times, method="explicit").states
        for compiled in (plain, sensitive)
    )
    assert np.max(np.abs(a - b)) < 1e-12


@pytest.mark.parametrize(
    ("changes", "road"),
    [
        ({}, Rectangle(height=0.01, length=0.4, start=0.1)),
        ({"tyre.damping_coefficient": 600.0}, Triangle(height=0.004, length=0.02, start=0.1)),
    ],
    ids=["long cleat", "crest of a triangle"],
)
def test_contact_lost_at_an_edge_of_the_road(changes, road):
    compare(changes, road, ("tyre.stiffness", "unsprung.mass"))


def test_bouc_wen():
    damper = {
        "kind": "bouc-wen",
        "coefficient": 80.0,
        "hysteretic_force": 20.0,
        "rate": 800.0,
        "sigma": 0.8,
        "exponent": 2.0,
    }
    compare(
        {"strut.damper": damper},
        BUMP,
        ("strut.damper.hysteretic_force", "strut.damper.rate"),
        allowed=1e-4,
    )
