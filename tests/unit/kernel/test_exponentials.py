"""The matrix exponentials of exact propagation, against SciPy's."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm

from jounce.kernel.linear import _exponentials


@pytest.mark.parametrize("step", [1e-6, 1e-3, 0.1])
def test_stiff_oscillator(step: float) -> None:
    """A wheel hop of 170 rad/s under a slow body, joined with a constant, as propagation uses it."""
    slope = np.zeros((5, 5))
    slope[:4, :4] = [[0, 0, 1, 0], [0, 0, 0, 1], [-1000, 1000, -8, 8], [4000, -30000, 30, -30]]
    slope[3, 4] = -9.81
    found, expected = _exponentials(slope[None] * step)[0], expm(slope * step)
    assert np.max(np.abs(found - expected)) <= 1e-13 * np.max(np.abs(expected))


def test_several_at_once_and_a_rotation_known_in_closed_form() -> None:
    angles = np.array([0.0, 0.3, 40.0])
    found = _exponentials(angles[:, None, None] * np.array([[0.0, 1.0], [-1.0, 0.0]]))
    cosine, sine = np.cos(angles), np.sin(angles)
    np.testing.assert_allclose(found[:, 0, 0], cosine, rtol=0.0, atol=1e-13)
    np.testing.assert_allclose(found[:, 0, 1], sine, rtol=0.0, atol=1e-13)
    np.testing.assert_allclose(found[:, 1, 0], -sine, rtol=0.0, atol=1e-13)


def test_what_is_not_finite_stays_so_without_a_warning() -> None:
    assert not np.isfinite(_exponentials(np.full((1, 2, 2), np.nan))).any()
