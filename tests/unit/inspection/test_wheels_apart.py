"""Which part of a record is the test of which wheel."""

from __future__ import annotations

import numpy as np

from jounce.inspection.conditioning import moving_part

RATE, LEAST = 1000.0, 0.325e-3


def _two_plates() -> tuple[np.ndarray, np.ndarray]:
    """Heights (m) of two sprung plates: one after the other is swept, then both swing on with the body."""
    time = np.arange(30_000) / RATE
    angle = 2 * np.pi * (20.0 * time - 0.7 * time**2)
    first = np.where(time < 13.0, 2e-3 * np.sin(angle), 0.0)
    second = np.roll(first, 15_000)
    later = np.maximum(time - 9.0, 0.0)
    swing = np.where(later > 0.0, 2e-3 * np.exp(-0.1 * later) * np.sin(2 * np.pi * 1.3 * time), 0.0)
    return first + swing + 0.3 * second, second + swing + 0.3 * first


def test_wheels_tested_in_turn_do_not_overlap_where_the_body_swings_on() -> None:
    left, right = _two_plates()
    ours, theirs = moving_part(left, RATE, LEAST, right), moving_part(right, RATE, LEAST, left)
    assert ours is not None
    assert theirs is not None
    assert ours[0] == 0
    assert 12_500 <= ours[1] <= 15_000
    assert 14_500 <= theirs[0] <= 15_300
    assert theirs[1] >= 27_500


def test_plates_that_run_together_are_both_moving() -> None:
    left, _ = _two_plates()
    for values in (left, 1.2 * left):
        span = moving_part(values, RATE, LEAST, left)
        assert span is not None
        assert span[0] == 0
        assert span[1] >= 12_500


def test_a_plate_at_rest_beside_one_that_runs_does_not_move() -> None:
    left, _ = _two_plates()
    assert moving_part(0.02 * left, RATE, LEAST, left) is None
    assert moving_part(0.0 * left, RATE, LEAST) is None
