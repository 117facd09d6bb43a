"""Adaptive explicit integration: Dormand-Prince 8(5,3), or 5(4) where edges of the input keep steps short.

The state may be followed by its sensitivities ``S = dx/dp`` from the variational equation, one number per state and
parameter. They do not affect the step size; at an event they jump by the saltation rule.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from jounce.kernel.arrays import Integers
from jounce.kernel.call import Loop
from jounce.kernel.engine import (
    FIRST_PROBE,
    NO_FEEDBACK,
    Control,
    Engine,
    Feedback,
    Problem,
    Samples,
    scratch,
)
from jounce.kernel.methods.runge_kutta import NODES, SHORT_FIRST, SHORT_NODES

_integrate = Loop("explicit")


def shorten(engine: Engine, step: int, dense: int, error: int) -> Engine:
    """Return the method with the pair of lower order: 6 stages instead of 15, for steps that edges keep short."""
    return engine._replace(
        step=step, dense=dense, error=error, first=SHORT_FIRST, after=FIRST_PROBE, shrink=-0.2
    )


class Pair(NamedTuple):
    """Constants of an explicit method for ``adaptive.walk``."""

    first: float = 1e-3
    waits: bool = False


def integrate(
    problem: Problem,
    control: Control,
    out: Samples,
    counts: Integers,
    feedback: Feedback = NO_FEEDBACK,
    systems: int = 1,
) -> int:
    """Integrate from the first to the last sample; fill the arrays at every sample; return a status code.

    A sample at an input edge has the values just after it. ``counts`` gets steps, rejected steps and events.
    ``feedback`` is a controller around the model; each of several ``systems`` side by side is projected onto its own
    constraints.
    """
    problem = problem._replace(
        x0=np.ascontiguousarray(problem.x0)
    )  # of one type, whatever it is a part of
    work = scratch(problem, control, NODES if problem.engine.first == 1 else SHORT_NODES, systems)
    return _integrate(problem, feedback, Pair(), control, work, out, counts)
