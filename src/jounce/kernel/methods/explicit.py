"""Adaptive explicit integration: Dormand-Prince 8(5,3), or 5(4) where edges of the input keep steps short.

The state may carry sensitivities behind it: ``S = dx/dp`` of the variational equation, for each state one number a
parameter. They do not steer the step size; at an event they jump by the saltation rule.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.kernel.call import call_native, call_step, compiled, part
from jounce.kernel.engine import (
    FIRST_PROBE,
    LAST_STAGE,
    NO_FEEDBACK,
    PROBES,
    RATES,
    Control,
    Engine,
    Feedback,
    Problem,
    Samples,
    scratch,
)
from jounce.kernel.events import rate
from jounce.kernel.methods.adaptive import inputs, way_through
from jounce.kernel.methods.runge_kutta import NODES, SHORT_FIRST, SHORT_NODES
from jounce.kernel.signals import finish_samples

_SAFETY, _SHRINK, _GROW = 0.9, 0.2, 5.0  # usual choices (Hairer, Norsett, Wanner, section II.4)


def shortened(engine: Engine, step: int, dense: int, error: int) -> Engine:
    """The same with the pair of lower order: 6 stages in place of 15, for steps that edges keep short."""
    return engine._replace(step=step, dense=dense, error=error, first=SHORT_FIRST, after=FIRST_PROBE, shrink=-0.2)


class Pair(NamedTuple):
    """How an explicit method goes its way (``adaptive.walk``)."""

    first: float = 1e-3
    waits: bool = False


@part(forceinline=True)
def _look(problem: Any, method: Any, work: Any, t: float, changed: bool) -> None:
    """Rate at the start of a step; it is that at the end of the last one unless something has moved the state since."""
    if changed or problem.engine.project != 0:
        rate(problem, work, t, RATES)


@part(forceinline=True)
def _step(problem: Any, method: Any, control: Any, work: Any, t: float, h: float) -> float:
    """One step from the state to the end row, with the rate there."""
    inputs(problem, work, t, h, problem.engine.first, LAST_STAGE + 1)
    call_step(problem.engine.step, work.rows, work.u, problem.p, problem.m, work.g, h)
    work.step[0] = h
    call_native(problem.engine.error, work.rows, 0, work.u, work.step, work.widest, work.errors, 0)
    # DOP853's blend: the fifth-order error, made smaller where the third-order one says that it overestimates.
    fifth, third = work.errors[0, 0], work.errors[0, 1]
    blend = fifth + 0.01 * third
    error = 0.0 if blend == 0.0 else float(abs(h) * fifth / math.sqrt(blend * len(work.widest)))
    if not math.isfinite(error):
        return -0.1
    if error > 1.0:
        return -float(max(_SHRINK, _SAFETY * error**problem.engine.shrink))
    return float(min(_GROW, _SAFETY * (error + 1e-12) ** problem.engine.shrink))


@part(forceinline=True)
def _dense(problem: Any, method: Any, work: Any, t: float, h: float) -> None:
    """Three more stages, the coefficients of the interpolant on this step and the inputs at the probes."""
    inputs(problem, work, t, h, problem.engine.after, FIRST_PROBE + len(PROBES))
    call_step(problem.engine.dense, work.rows, work.u, problem.p, problem.m, work.g, h)


def integrate(
    problem: Problem, control: Control, out: Samples, counts: NDArray[np.int64], feedback: Feedback = NO_FEEDBACK
) -> int:
    """Integrate from the first to the last sample; fill the arrays at every sample; give a status code.

    At an input edge the samples are those just after it. ``counts`` gets steps, rejected steps and events. ``feedback``
    is a controller around the model.
    """
    problem = problem._replace(x0=np.ascontiguousarray(problem.x0))  # of one type, whatever it is a part of
    work = scratch(problem, control, NODES if problem.engine.first == 1 else SHORT_NODES)
    return int(_integrate(problem, feedback, Pair(), control, work, out, counts))


_walk = way_through(_look, _step, _dense)


@compiled()
def _integrate(problem: Any, feedback: Any, method: Any, control: Any, work: Any, out: Any, counts: Any) -> int:
    status = _walk(method, problem, feedback, control, work, out, counts)
    finish_samples(problem, work, out)
    return int(status)
