"""Rows of the matrix that an integration works in (one column a state), shared by native functions and loops."""

from __future__ import annotations

import numpy as np

from jounce.kernel import dopri5
from jounce.kernel.dop853 import DENSE_STAGES, STAGES, C

STATE, END, TRIAL, RATES = 0, 1, 2, 3
"""The state, its value after the step, where a stage or a switch is evaluated, and the first of the stages' rates."""
DENSE = RATES + DENSE_STAGES
"""First of the seven rows of the interpolant."""
ROWS = DENSE + 7

PROBES = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Fractions of a step at which the switching functions are checked; at 0 an edge of the input may have thrown one."""
NODES = np.concatenate([C, PROBES])
"""Fractions of a step at which the inputs are wanted: the stages, then the probes."""
SHORT_NODES = np.concatenate([dopri5.C, PROBES])
"""The same for the pair of lower order."""
LAST_STAGE = STAGES
FIRST_PROBE = DENSE_STAGES
