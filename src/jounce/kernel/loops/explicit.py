"""Steps of the explicit method (see ``methods.explicit``)."""

from __future__ import annotations

import math
from typing import Any

from jounce.kernel.engine import FIRST_PROBE, LAST_STAGE, PROBES, RATES
from jounce.kernel.loops.adaptive import inputs, way_through
from jounce.kernel.loops.compiling import call_native, call_step, part
from jounce.kernel.loops.events import rate
from jounce.kernel.methods.explicit import Pair

_SAFETY, _SHRINK, _GROW = 0.9, 0.2, 5.0  # usual choices (Hairer, Norsett, Wanner, section II.4)


@part(forceinline=True)
def _look(problem: Any, method: Any, work: Any, t: float, changed: bool) -> None:
    """Provide the rate at the start of a step; reuse that at the end of the last step if the state is unchanged."""
    if changed or problem.engine.project != 0:
        rate(problem, work, t, RATES)


@part(forceinline=True)
def _step(problem: Any, method: Any, control: Any, work: Any, t: float, h: float) -> float:
    """Compute one step from the state to the end row, and the rate there."""
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
    """Compute three more stages, the coefficients of the interpolant of this step, and the inputs at the probes."""
    inputs(problem, work, t, h, problem.engine.after, FIRST_PROBE + len(PROBES))
    call_step(problem.engine.dense, work.rows, work.u, problem.p, problem.m, work.g, h)


integrate = way_through(_look, _step, _dense, Pair)
