"""Whether a search has ended, told by a problem small enough to be seen through."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from jounce.identify.update import is_stationary

JACOBIAN = np.array([[1.0, 0.2], [0.1, 2.0], [0.3, -0.4]])


def problem(best):
    """Linear in two scaled parameters, with a misfit of its own that no parameter takes away."""
    rest = np.cross(JACOBIAN[:, 0], JACOBIAN[:, 1])
    aim = JACOBIAN @ np.asarray(best) + rest
    return SimpleNamespace(
        residuals=lambda x: SimpleNamespace(vector=JACOBIAN @ x - aim, jacobian=JACOBIAN), data_energy=float(aim @ aim)
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
