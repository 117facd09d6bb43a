"""How far a signal reaches, from its pieces alone."""

import numpy as np
import pytest

import jounce as jn
from jounce.core.segments import Segments, flat, piecewise_linear


@pytest.mark.parametrize("rate", [1.0, 13.9])
@pytest.mark.parametrize("seed", range(3))
def test_straight_lines_reach_as_far_as_their_points(rate, seed):
    random = np.random.default_rng(seed)
    x, height = np.cumsum(random.uniform(0.01, 0.5, 40)), random.normal(0.0, 0.02, 40)
    lines = piecewise_linear(x, height).in_time(rate)
    assert lines.extent == pytest.approx(np.ptp(height), rel=1e-12)
    assert lines.extent == pytest.approx(np.ptp(lines.evaluate(np.linspace(x[0], x[-1], 20001) / rate)[0]), rel=1e-2)


def test_lines_that_do_not_meet_reach_to_both_of_their_ends():
    jump = Segments(
        np.array([0.0, 1.0, 2.0]), np.zeros(2, dtype=np.int64), np.array([[0.0, 3.0, 0, 0], [-2.0, 0, 0, 0]])
    )
    assert jump.extent == pytest.approx(5.0)
    assert flat(3.0, 0.4).extent == 0.0


def test_curves_reach_beyond_their_ends():
    bump = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m").segments(1.0)
    assert bump.extent == pytest.approx(0.010, rel=1e-9)
    parabola = Segments(np.array([0.0, 2.0]), np.zeros(1, dtype=np.int64), np.array([[0.0, 2.0, -1.0, 0.0]]))
    assert parabola.extent == pytest.approx(1.0)
