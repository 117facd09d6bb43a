"""Tighter tolerances give smaller errors, and physics does not know what time it is."""

from __future__ import annotations

import numpy as np
import pytest

from jounce import parts
from jounce.models import build
from jounce.roads import HalfCylinder, HalfSine, Rectangle, Train
from jounce.simulation.compiled import compile_model
from jounce.simulation.prepare import solve
from jounce.simulation.settings import output_times

KART = parts.load("kart-quarter-car")
RIGS = {
    "lift-off": {},
    "tyre damping": {"tyre.damping_coefficient": 60.0},
    "bilinear": {"strut.damper": {"bump_coefficient": 80.0, "rebound_coefficient": 240.0}},
    "cubic tyre": {
        "tyre.stiffness": None,
        "tyre.curve": {"kind": "polynomial", "coefficients": [6e4, 0.0, 5e9]},
    },
}


def states(rig, segments, duration, tolerance, method="auto"):
    compiled = compile_model(build(rig))
    solution = solve(
        compiled,
        compiled.parameter_values(rig.parameters()),
        segments,
        output_times(duration, 1e-3),
        tolerance=tolerance,
        method=method,
    )
    assert solution.status.name == "COMPLETED"
    return solution


@pytest.mark.parametrize("name", RIGS)
def test_error_falls_with_the_tolerance(name):
    """Halving step by halving step from 1e-4 to 1e-8 the error falls in proportion, on the whole."""
    rig = KART.with_changes(RIGS[name])
    segments = HalfSine(height=0.01, length=0.06, start=0.1).segments(3.0).in_time(2.86)
    reference = states(rig, segments, 0.6, 1e-12, "explicit").states[:2]
    tolerances = 1e-4 * 0.5 ** np.arange(14)
    found = [
        np.max(np.abs(states(rig, segments, 0.6, t, "explicit").states[:2] - reference))
        for t in tolerances
    ]
    order = np.polyfit(np.log(tolerances), np.log(found), 1)[0]
    assert 0.6 < order < 1.5, (order, found)


def test_tighter_costs_more():
    segments = HalfSine(height=0.01, length=0.06, start=0.1).segments(3.0).in_time(2.86)
    steps = [states(KART, segments, 0.6, t, "explicit").steps for t in (1e-4, 1e-6, 1e-8, 1e-10)]
    assert steps == sorted(steps)
    assert steps[-1] < 8 * steps[0]  # eighth order: six decades for less than that


@pytest.mark.parametrize(
    "shape",
    [
        HalfSine(height=0.01, length=0.06),
        Rectangle(height=0.01, length=0.06),
        HalfCylinder(radius=0.01),
        Train(of=HalfSine(height=0.01, length=0.06), count=5, pitch=0.15),
    ],
    ids=lambda shape: shape.kind,
)
@pytest.mark.parametrize("shift", [0.2, 2.0, 20.0])
def test_an_obstacle_met_later_gives_the_same_answer_later(shape, shift):
    speed, duration = 2.0, 0.7
    early, late = (shape.model_copy(update={"start": start}) for start in (0.1, 0.1 + shift))
    a = states(KART, early.segments(speed * duration).in_time(speed), duration, 1e-9).states
    later = shift / speed
    b = states(
        KART, late.segments(speed * (duration + later)).in_time(speed), duration + later, 1e-9
    ).states
    shifted = b[:, round(later / 1e-3) :]
    assert np.max(np.abs(shifted[:2] - a[:2])) < 1e-9 * np.ptp(a[1]) * 10
    assert np.max(np.abs(shifted - a)) < 1e-8 * np.ptp(a[3])


def test_nothing_happens_on_a_level_road():
    segments = Rectangle(height=0.0, length=0.06, start=0.1).segments(3.0).in_time(1.95)
    found = states(KART, segments, 1.5, 1e-5).states
    assert np.max(np.abs(found - found[:, :1])) < 1e-13


def test_height_of_the_road_does_not_matter():
    """A wheel that starts on a plateau 50 mm up does what it does at level 0, 50 mm higher."""
    hole = Rectangle(height=-0.01, length=0.06, start=0.1).segments(3.0).in_time(1.95)
    raised = type(hole)(
        hole.edges, hole.kind, hole.coefficients + np.array([0.05, 0.0, 0.0, 0.0]), hole.rate
    )
    a, b = (states(KART, segments, 0.6, 1e-9).states for segments in (hole, raised))
    assert np.max(np.abs(b[:2] - a[:2] - 0.05)) < 1e-10


@pytest.mark.parametrize(("method", "rounding"), [("auto", 1e-14), ("explicit", 1e-15)])
def test_samples_do_not_steer_the_steps(method, rounding):
    """Coarse output is the fine one at fewer times, but for the rounding of 600 exact steps, or of the last digit."""
    compiled = compile_model(build(KART))
    p = compiled.parameter_values(KART.parameters())
    segments = HalfSine(height=0.01, length=0.06, start=0.1).segments(3.0).in_time(2.86)
    fine, coarse = (
        solve(compiled, p, segments, output_times(0.6, step), method=method)
        for step in (1e-3, 1e-1)
    )
    assert fine.states[:, ::100] == pytest.approx(coarse.states, abs=rounding)
