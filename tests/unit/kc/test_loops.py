"""Curves without friction, from loops of a spring with a slider beside it, whose law is known."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.kc.laboratory import loop
from jounce.kc.loops import lines_of

RATE, HOLD, LOAD = 30e3, 400e3, 80.0  # N/m, N/m, N: the slider slips over 0.2 mm


def force(sweep: np.ndarray, slipped: float = 0.0) -> tuple[np.ndarray, float]:
    """Return the forces of spring and slider along a sweep (m), and what has slipped at its end."""
    out = []
    for x in sweep:
        slipped = float(np.clip(slipped, x - LOAD / HOLD, x + LOAD / HOLD))
        out.append(RATE * x + HOLD * (x - slipped))
    return np.array(out), slipped


@pytest.mark.parametrize("one_sided", [False, True])
@pytest.mark.parametrize("is_force", [True, False])
def test_the_branch_that_has_slipped_is_the_spring(*, one_sided: bool, is_force: bool) -> None:
    """Where the mean is wrong by the friction, whichever of both is the input; all slips before the middle."""
    sweep = loop(20e-3, 1601, one_sided=one_sided)
    values, _ = force(sweep, force(sweep)[1])  # the second loop closes
    x, y = (sweep, values) if is_force else (values, sweep)
    inputs = np.linspace(x.min(), x.max(), 81)
    lines = lines_of(x, y, inputs)
    spring = RATE * inputs if is_force else inputs / RATE
    size = LOAD if is_force else LOAD / RATE

    def error(curve: np.ndarray) -> float:
        away = curve - spring
        return float(np.abs(away - np.median(away)).max())

    assert error(lines.mean) > 0.5 * size
    assert error(lines.elastic) < 0.02 * size


def test_of_a_single_branch_the_curve_is_the_branch() -> None:
    x = np.linspace(-1.0, 1.0, 21)
    lines = lines_of(x, x**3, x)
    assert lines.elastic == pytest.approx(lines.mean)
