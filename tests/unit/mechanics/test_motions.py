"""Motions against time: what passes through two points and more, steps, and what is none."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

TIME = np.array([-1.0, 0.0, 1.0, 1.5, 2.0, 3.0, 4.0])


@pytest.mark.parametrize("smooth", [True, False])
def test_two_points_are_a_line_with_level_ends(smooth: bool) -> None:
    value, rate = jn.mechanics.interpolated([1.0, 3.0], [2.0, -2.0], smooth=smooth).evaluate(TIME)
    np.testing.assert_allclose(value, [2.0, 2.0, 2.0, 1.0, 0.0, -2.0, -2.0], rtol=0.0, atol=1e-14)
    np.testing.assert_allclose(
        rate[[0, 1, 3, 4, 6]], [0.0, 0.0, -2.0, -2.0, 0.0], rtol=0.0, atol=1e-14
    )


@pytest.mark.parametrize(
    ("time", "value"),
    [
        ([1.0], [2.0]),
        ([], []),
        ([0.0, 1.0], [0.0, 1.0, 2.0]),
        ([[0.0, 1.0]], [[0.0, 1.0]]),
        ([0.0, 0.0], [0.0, 1.0]),
        ([0.0, np.nan], [0.0, 1.0]),
        ([0.0, 1.0], [np.inf, 1.0]),
    ],
)
def test_points_that_are_no_motion(time: object, value: object) -> None:
    with pytest.raises(jn.AssemblyError, match="invalid motion; found 'times of shape"):
        jn.mechanics.interpolated(time, value)


def test_steps_and_rates() -> None:
    value, rate = jn.mechanics.step(1.0, -2.0, begin=1.0, stop=3.0).evaluate(TIME)
    share = np.clip((TIME - 1.0) / 2.0, 0.0, 1.0)
    np.testing.assert_allclose(
        value, 1.0 - 3.0 * (3.0 * share**2 - 2.0 * share**3), rtol=0.0, atol=1e-14
    )
    np.testing.assert_allclose(
        rate, -3.0 * (6.0 * share - 6.0 * share**2) / 2.0, rtol=0.0, atol=1e-14
    )
    value, rate = jn.mechanics.constant_rate(0.5, start=3.0).evaluate(TIME)
    np.testing.assert_allclose(value, 3.0 + 0.5 * TIME, rtol=1e-14)
    np.testing.assert_allclose(rate, 0.5, rtol=1e-14)
    assert jn.mechanics.constant(4.0).evaluate(TIME)[1].tolist() == [0.0] * 7
