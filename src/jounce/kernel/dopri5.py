"""Dormand-Prince 5(4) pair with its fourth-order dense output, for steps that the input keeps far below the tolerance.

Coefficients: Hairer, Norsett, Wanner, "Solving Ordinary Differential Equations I", 2nd ed. 1993, table II.5.2 and
section II.6 [hairer1993]. Its seven stages stand in the rows of the longer method's first stage and of its last six, so
that both share all arrays.
"""

from __future__ import annotations

import numpy as np

from jounce.kernel.dop853 import DENSE_STAGES
from jounce.kernel.dop853 import STAGES as LAST

FIRST = LAST - 5
"""Row of the second stage; the sixth is right before ``LAST``, the end of the step."""
_ROWS = [0, *range(FIRST, LAST + 1)]


def _spread(weights: list[float]) -> np.ndarray:
    """Weights of the seven stages, each in its row."""
    found = np.zeros(DENSE_STAGES)
    found[_ROWS[: len(weights)]] = weights
    return found


A = {
    FIRST + i: _spread(weights)
    for i, weights in enumerate(
        (
            [1 / 5],
            [3 / 40, 9 / 40],
            [44 / 45, -56 / 15, 32 / 9],
            [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
            [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
            [35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
        )
    )
}
"""Weights of the rates before each stage, by its row; those of ``LAST`` make the step."""
C = _spread([0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0, 1.0])
"""Fractions of a step at which the stages stand."""
E = _spread([71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40])
"""Error of fourth order."""
D = _spread(
    [
        -12715105075 / 11282082432,
        0.0,
        87487479700 / 32700410799,
        -10690763975 / 1880347072,
        701980252875 / 199316789632,
        -1453857185 / 822651844,
        69997945 / 29380423,
    ]
)
"""Last coefficient of the interpolant."""
