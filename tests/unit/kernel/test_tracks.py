"""The road as the compiled loops see it, height and rate, is the readable evaluation of its pieces."""

from __future__ import annotations

import numpy as np
import pytest

from jounce import parts
from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE, Segments
from jounce.models import build
from jounce.simulation.compiled import compile_model
from jounce.simulation.prepare import solve

RIG = parts.load("kart-quarter-car").with_changes(
    {"tyre.damping_coefficient": 100.0, "tyre.lift_off": False}
)
RIGS = {
    "linear model": RIG,
    "nonlinear model": RIG.with_changes({"guide.friction": {"force": 1.0}}),
}
EDGES = np.array([0.0, 0.5, 1.0, 1.4, 3.0])
KINDS = [POLYNOMIAL, SINE, CIRCLE, POLYNOMIAL]
COEFFICIENTS = np.array(
    [
        [0.01, -0.02, 0.03, 0.04],
        [0.05, 0.02, 7.0, 0.3],
        [0.1, 0.3, 0.2, 1.0],
        [-0.03, 0.0, 0.0, 0.0],
    ]
)
QUADRATIC = COEFFICIENTS * np.array([1.0, 1.0, 1.0, 0.0])
SIGNALS = {
    "all kinds": Segments(EDGES, np.array(KINDS), COEFFICIENTS).in_time(1.7),
    "without cubic and circle": Segments(
        EDGES,
        np.array([POLYNOMIAL, SINE, POLYNOMIAL, POLYNOMIAL]),
        np.vstack([QUADRATIC[0], COEFFICIENTS[1], QUADRATIC[2:]]),
    ).in_time(1.7),
}


def seen(rig, signal, times):
    """Height and rate of the road as the model's outputs hold them."""
    compiled = compile_model(build(rig))
    solution = solve(
        compiled, compiled.parameter_values(rig.parameters()), signal, times, tolerance=1e-6
    )
    assert solution.status.name == "COMPLETED"
    out = dict(zip(compiled.output_names, solution.outputs, strict=True))
    damping = out["tyre.force"] - rig.tyre.stiffness * out["tyre.deflection"]
    return out["road.z"], damping / rig.tyre.damping_coefficient + out["unsprung.vz"]


@pytest.mark.parametrize("signal", SIGNALS)
@pytest.mark.parametrize("rig", RIGS)
def test_compiled_is_readable(rig, signal):
    """Also at the edges, where the right-hand piece counts, and beyond the last."""
    edges = SIGNALS[signal].edges[1:-1]
    times = np.sort(np.concatenate([np.linspace(0.0, 2.5, 83), edges]))
    height, rate = SIGNALS[signal].evaluate(times)
    found_height, found_rate = seen(RIGS[rig], SIGNALS[signal], times)
    np.testing.assert_allclose(found_height, height, rtol=0.0, atol=1e-15)
    np.testing.assert_allclose(found_rate, rate, rtol=0.0, atol=1e-10)
    assert np.isin(edges, times).all()


def test_pieces_are_what_their_definition_says():
    """By hand, at local coordinate s = 1.7 m/s (t - edge)."""
    signal = SIGNALS["all kinds"]
    start = signal.edges
    s = 1.7 * 0.05
    expected = [
        0.01 - 0.02 * s + 0.03 * s**2 + 0.04 * s**3,
        0.05 + 0.02 * np.sin(7.0 * s + 0.3),
        0.1 + np.sqrt(0.3**2 - (s - 0.2) ** 2),
        -0.03,
    ]
    times = np.concatenate([[0.0], start[:4] + 0.05])
    assert seen(RIGS["nonlinear model"], signal, times)[0][1:] == pytest.approx(expected, rel=1e-13)
