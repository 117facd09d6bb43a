"""Adaptive implicit integration (Rosenbrock method Rodas5P) for stiff models: bushings, sharp friction.

Each step solves eight linear systems with one matrix, built from the exact slopes of the rates at its start, without
iteration. Fast modes that decay or are not excited do not limit the step.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from jounce.kernel.arrays import Integers, Matrix, Vector
from jounce.kernel.call import Loop
from jounce.kernel.engine import DENSE, NO_FEEDBACK, ROWS, Control, Problem, Samples, scratch
from jounce.kernel.methods.rosenbrock import STAGES
from jounce.kernel.methods.runge_kutta import NODES

_integrate = Loop("implicit")


class Slopes(NamedTuple):
    """Addresses of native functions for the linear systems of a step.

    ``look`` returns the slopes at a state followed by the rates, ``size`` numbers; ``along_input`` the slopes of the
    rates along the inputs, column by column; ``factor`` computes ``room`` numbers from slopes and shift, the first of
    which is the quality of the factors; ``stages`` and ``interpolant`` use them (see ``rosenbrock``).
    """

    look: int
    along_input: int
    factor: int
    stages: Integers
    interpolant: int
    size: int
    room: int


class Rosenbrock(NamedTuple):
    """Constants of the method for ``adaptive.walk``, and scratch arrays of a step.

    The arrays are: stages and time derivative of the rates, slopes, the linear system, rates of the inputs.
    """

    slopes_at: Slopes
    k: Matrix
    slopes: Matrix
    factors: Matrix
    right: Vector
    by_input: Matrix
    moving: Vector
    first: float = 1e-4
    waits: bool = True


def integrate(
    problem: Problem, slopes: Slopes, control: Control, out: Samples, counts: Integers
) -> int:
    """Integrate from the first to the last sample; fill the arrays at every sample; return a status code.

    A sample at an input edge has the values just after it. ``counts`` gets steps, rejected steps and events. The state
    has no sensitivities.
    """
    n = len(problem.x0)
    method = Rosenbrock(
        slopes,
        np.zeros((STAGES + 1, n)),
        np.zeros((1, slopes.size)),
        np.zeros((1, slopes.room)),
        np.zeros(1 + n),
        np.zeros((1, n * max(problem.inputs, 1))),
        np.zeros(problem.inputs),
    )
    problem = problem._replace(
        x0=np.ascontiguousarray(problem.x0)
    )  # of one type, whatever it is a part of
    work = scratch(problem, control, NODES)
    work.rows[DENSE:ROWS] = 0.0
    return _integrate(problem, NO_FEEDBACK, method, control, work, out, counts)
