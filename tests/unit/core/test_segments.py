"""How far a signal reaches, from its pieces alone."""

import numpy as np
import pytest

import jounce as jn
from jounce.core.segments import CIRCLE, POLYNOMIAL, Segments, flat, piecewise_linear


@pytest.mark.parametrize("rate", [1.0, 13.9])
@pytest.mark.parametrize("seed", range(3))
def test_straight_lines_reach_as_far_as_their_points(rate, seed):
    random = np.random.default_rng(seed)
    x, height = np.cumsum(random.uniform(0.01, 0.5, 40)), random.normal(0.0, 0.02, 40)
    lines = piecewise_linear(x, height).in_time(rate)
    assert lines.extent == pytest.approx(np.ptp(height), rel=1e-12)
    assert lines.extent == pytest.approx(
        np.ptp(lines.evaluate(np.linspace(x[0], x[-1], 20001) / rate)[0]), rel=1e-2
    )


def test_lines_that_do_not_meet_reach_to_both_of_their_ends():
    jump = Segments(
        np.array([0.0, 1.0, 2.0]),
        np.zeros(2, dtype=np.int64),
        np.array([[0.0, 3.0, 0, 0], [-2.0, 0, 0, 0]]),
    )
    assert jump.extent == pytest.approx(5.0)
    assert flat(3.0, 0.4).extent == 0.0


def test_curves_reach_beyond_their_ends():
    bump = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m").segments(1.0)
    assert bump.extent == pytest.approx(0.010, rel=1e-9)
    parabola = Segments(
        np.array([0.0, 2.0]), np.zeros(1, dtype=np.int64), np.array([[0.0, 2.0, -1.0, 0.0]])
    )
    assert parabola.extent == pytest.approx(1.0)


@pytest.mark.parametrize("before", ["line", "circle"])
def test_a_jump_gets_a_ramp_that_ends_where_it_was(before) -> None:
    kind, first = (
        (POLYNOMIAL, [0.01, 0.1, 0.0, 0.0]) if before == "line" else (CIRCLE, [0.0, 0.3, 0.1, 1.0])
    )
    signal = Segments(
        np.array([0.0, 0.2, 0.5, 1.0]),
        np.array([kind, POLYNOMIAL, POLYNOMIAL]),
        np.array([first, [0.5, 0.0, 0.0, 0.0], [0.5, -1.0, 0.0, 0.0]]),
        rate=2.0,
    )
    reached = signal.on_pieces(np.array([0]), np.array([0.2]))[0][0]
    assert signal.jumps == pytest.approx([0.5 - reached, 0.0], abs=1e-15)
    for shortest, width in ((1e-9, 1e-5 * (0.5 - reached) / 2.0), (1e-3, 1e-3), (1.0, 0.1)):
        found = signal.with_ramps(shortest)
        assert found.edges == pytest.approx([0.0, 0.2 - width, 0.2, 0.5, 1.0], rel=1e-12)
        edges = found.edges[1:3]
        heights = found.evaluate(edges)[0]
        assert heights == pytest.approx([float(signal.evaluate(edges[:1])[0][0]), 0.5], rel=1e-12)
        steep = found.on_pieces(np.array([1, 1]), edges)  # no jump is left
        assert steep[0] == pytest.approx(heights, rel=1e-12)
        assert steep[1] * width == pytest.approx(np.full(2, np.diff(heights)[0]), rel=1e-6)
    level = flat(1.0)
    assert level.with_ramps(1e-9) is level
    assert level.jumps.tolist() == []
