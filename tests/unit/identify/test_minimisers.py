"""Whether a search has ended, told by a problem small enough to be seen through."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from jounce.identify.search import is_stationary

JACOBIAN = np.array([[1.0, 0.2], [0.1, 2.0], [0.3, -0.4]])


def problem(best):
    """Linear in two scaled parameters, with a misfit of its own that no parameter takes away."""
    rest = np.cross(JACOBIAN[:, 0], JACOBIAN[:, 1])
    aim = JACOBIAN @ np.asarray(best) + rest
    return SimpleNamespace(
        residuals=lambda x: SimpleNamespace(vector=JACOBIAN @ x - aim, jacobian=JACOBIAN),
        data_energy=float(aim @ aim),
    )


@pytest.mark.parametrize(
    ("best", "x", "ends"),
    [
        ((0.9, -0.4), (0.9, -0.4), True),
        ((0.9, -0.4), (0.5, -0.4), False),  # one of two still moves outwards
        ((0.9, -0.4), (0.5, -0.2), False),  # both do, and neither has met its bound
        ((1.5, -1.7), (1.0, -1.0), True),  # both want to go where they must not
        ((0.5, 0.2), (1.0, -1.0), False),  # on their bounds, but they want to come back
    ],
)
def test_a_search_has_ended_where_no_step_within_the_bounds_gains(best, x, ends):
    assert is_stationary(problem(best), np.array(x)) == ends


@pytest.mark.parametrize(("gain", "ends"), [(0.97e-6, True), (1.03e-6, False)])
def test_a_step_that_gains_a_millionth_goes_on(gain, ends):
    """What a step gains of the squares is what the linear problem has beside its own misfit."""
    best, way = np.array([0.3, -0.2]), np.array([1.0, 0.5])
    rest = np.sum(np.cross(JACOBIAN[:, 0], JACOBIAN[:, 1]) ** 2)
    off = np.sqrt(gain / (1.0 - gain) * rest) / np.linalg.norm(JACOBIAN @ way)
    assert is_stationary(problem(best), best + off * way) == ends


@pytest.mark.parametrize(("share", "ends"), [(0.9e-12, True), (1.1e-12, False)])
def test_what_leaves_a_millionth_of_the_signals_is_perfect(share, ends):
    vector = JACOBIAN @ [1.0, 1.0]
    energy = float(vector @ vector) / share
    one = SimpleNamespace(
        residuals=lambda _: SimpleNamespace(vector=vector, jacobian=JACOBIAN), data_energy=energy
    )
    assert is_stationary(one, np.zeros(2)) == ends
