"""Sensitivities of 3-D corners equal central differences of runs at a tight tolerance, for every kind of number."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce import parts
from jounce.roads import HalfSine
from jounce.simulation.compiled import compile_rig
from jounce.simulation.prepare import solve
from jounce.simulation.settings import output_times

PROTOTYPE = parts.load(Path(__file__).parent.parent / "files" / "prototype-double-wishbone.toml")
ROAD = HalfSine(height=0.01, length=0.1, start=0.1).segments(2.0).in_time(1.95)
TIMES = output_times(0.5, 1e-3)
POINTS = (
    "hardpoints.lower_arm_front[2]",
    "hardpoints.lower_ball_joint[1]",
    "hardpoints.upper_ball_joint[0]",
    "hardpoints.tie_rod_outer[2]",
    "hardpoints.strut_bottom[2]",
    "hardpoints.wheel_centre[1]",
)
NUMBERS = (
    "tyre.stiffness",  # not in the order of the model's parameters
    "gravity",
    "sprung.mass",
    "bodies.upright.mass",
    "bodies.lower_arm.inertia.xx",
    "bodies.upright.centre_of_mass[1]",
    "strut.spring.rate",
    "strut.spring.free_length",
    "strut.damper.coefficient",
)
FREE = (*POINTS, *NUMBERS)
STOP = {"strut.bump_stop": {"gap": 0.004, "rate": 6e4, "progression": 3e8}}
CASES = {
    "bilateral tyre": ({"tyre.lift_off": False}, FREE),
    "unilateral tyre": ({"tyre.lift_off": True}, FREE),
    "radial tyre with damping, bump stop": (
        {"tyre.law": "radial", "tyre.damping_coefficient": 60.0, "wheel.camber": -0.02} | STOP,
        ("tyre.damping_coefficient", "wheel.camber", "strut.bump_stop.gap", "strut.bump_stop.rate"),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_every_kind_of_number(name):
    changes, free = CASES[name]
    rig = PROTOTYPE.with_changes(changes)
    plain, sensitive = compile_rig(rig), compile_rig(rig, free)
    p = plain.parameter_values(rig.parameters())
    run = solve(sensitive, p, ROAD, TIMES, tolerance=1e-8)
    if "unilateral" in name:
        assert run.events >= 2
    for column, path in enumerate(free):
        i = plain.facts.parameters.index(path)
        step = 1e-4 * max(abs(p[i]), 1e-2)
        ahead, behind = (
            solve(plain, p + sign * step * np.eye(len(p))[i], ROAD, TIMES, tolerance=1e-12)
            for sign in (1, -1)
        )
        pairs = {
            "states": (run.state_slopes[:, column], (ahead.states - behind.states) / (2.0 * step)),
            "outputs": (
                run.output_slopes[:, column],
                (ahead.outputs - behind.outputs) / (2.0 * step),
            ),
        }
        n_q, n_v = plain.facts.counts
        groups = {"states": [slice(0, n_q), slice(n_q, n_q + n_v)]}
        groups["outputs"] = [slice(k, k + 1) for k in range(len(plain.output_names))]
        for what, (found, expected) in pairs.items():
            for rows in groups[what]:
                size = np.max(np.abs(expected[rows]))
                assert np.max(np.abs(found[rows] - expected[rows])) <= 3e-5 * size + 1e-12, (
                    path,
                    what,
                    rows,
                )


def test_states_are_those_of_a_run_without_sensitivities():
    rig = PROTOTYPE.with_changes({"tyre.lift_off": True})
    plain, sensitive = compile_rig(rig), compile_rig(rig, FREE)
    p = plain.parameter_values(rig.parameters())
    a, b = (solve(compiled, p, ROAD, TIMES) for compiled in (plain, sensitive))
    assert (a.steps, a.rejected, a.events) == (b.steps, b.rejected, b.events)
    assert np.max(np.abs(a.states - b.states)) < 1e-10
    assert np.max(np.abs(a.outputs - b.outputs)) < 1e-6 * np.max(np.abs(a.outputs))
