"""The compiled evaluation of road pieces is the readable one."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE, Segments
from jounce.kernel import tracks

SIGNAL = Segments(
    np.array([0.0, 0.5, 1.0, 1.4, 3.0]),
    np.array([POLYNOMIAL, SINE, CIRCLE, POLYNOMIAL]),
    np.array([[0.1, -0.2, 0.3, 0.4], [0.05, 0.2, 7.0, 0.3], [0.1, 0.3, 0.2, 1.0], [-0.3, 0.0, 0.0, 0.0]]),
).in_time(1.7)


def evaluated(signals, t):
    """Value and rate of every track at one time, through the compiled functions."""
    flattened = tracks.flatten(signals)
    piece = flattened.first[:-1].copy()
    edge = tracks.advance(flattened, piece, t, 1e-12)
    u = np.zeros((2 * len(signals), 1))
    tracks.evaluate(flattened, piece, t, u, 0)
    return u[:, 0], edge


@pytest.mark.parametrize("t", [-0.2, 0.0, 0.1, 0.4, 0.55, 0.6, 0.7, 0.9, 1.5, 4.0])
def test_compiled_is_readable(t):
    found, edge = evaluated([SIGNAL], t)
    height, rate = SIGNAL.evaluate(np.array([t]))
    assert found == pytest.approx([height[0], rate[0]], rel=1e-14)
    inner = SIGNAL.edges[1:-1]
    later = inner[inner > t + 1e-12]
    assert edge == (later[0] if len(later) else np.inf)


def test_right_hand_piece_counts_at_an_edge():
    found, _ = evaluated([SIGNAL], float(SIGNAL.edges[3]))
    assert found == pytest.approx([-0.3, 0.0])


def test_tracks_do_not_mix():
    other = Segments(np.array([0.0, 9.0]), np.array([POLYNOMIAL]), np.array([[2.0, 1.0, 0.0, 0.0]]))
    found, edge = evaluated([other, SIGNAL], 0.1)
    assert found[:2].tolist() == [2.1, 1.0]
    assert found[2:] == pytest.approx(np.ravel(SIGNAL.evaluate(np.array([0.1]))), rel=1e-14)
    assert edge == SIGNAL.edges[1]


def test_rate_is_the_slope_of_the_height():
    for t in (0.1, 0.45, 0.7, 1.5):
        (ahead, _), _ = evaluated([SIGNAL], t + 1e-6)
        (behind, _), _ = evaluated([SIGNAL], t - 1e-6)
        (_, rate), _ = evaluated([SIGNAL], t)
        assert (ahead - behind) / 2e-6 == pytest.approx(rate, rel=1e-6, abs=1e-8)
