"""Steps of the implicit method (see ``methods.implicit``)."""

from __future__ import annotations

import math
from typing import Any

from jounce.kernel.engine import FIRST_PROBE, PROBES, RATES, STATE, TRIAL
from jounce.kernel.loops.adaptive import inputs, way_through
from jounce.kernel.loops.compiling import call_native, call_step, part
from jounce.kernel.loops.signals import fill, fill_rates
from jounce.kernel.methods.implicit import Rosenbrock
from jounce.kernel.methods.rosenbrock import GAMMA, STAGE_RATE, STAGES, C

_OWN = 6  # stages that see an input of their own: the last three all stand at the end of the step
_ORDER = 5.0
_SOUND = 1e-9  # soundness of the factors below which a shorter step is taken: a larger shift makes pivots sound
_SAFETY, _SHRINK, _GROW = 0.9, 0.2, 4.0


@part()
def _look(problem: Any, method: Any, work: Any, t: float, changed: bool) -> None:
    """Evaluate the rates, their slopes, and their time derivative due to the input alone, at the state and ``t``."""
    work.times[0] = t
    fill(problem.tracks, problem.piece, work.times[:1], work.u[:, :1])
    address = method.slopes_at
    call_native(address.look, work.rows, STATE, work.u, problem.p, problem.m, method.slopes, 0)
    n, drift = method.k.shape[1], method.k[STAGES]
    for d in range(n):
        work.rows[RATES, d] = method.slopes[0, address.size - n + d]
        drift[d] = 0.0
    fill_rates(problem.tracks, problem.piece, t, method.moving)
    still = True
    for i in range(problem.inputs):
        still = still and method.moving[i] == 0.0
    if still:  # on flat road, and in the air: the slopes along the inputs cost as much as a stage
        return
    call_native(
        address.along_input, work.rows, STATE, work.u, problem.p, problem.m, method.by_input, 0
    )
    for i in range(problem.inputs):
        for d in range(n):
            drift[d] += method.by_input[0, i * n + d] * method.moving[i]


@part()
def _step(problem: Any, method: Any, control: Any, work: Any, t: float, h: float) -> float:
    """Compute one step from the state to the end row."""
    method.right[0] = 1.0 / (GAMMA * h)
    address = method.slopes_at
    call_native(
        address.factor, method.slopes, 0, method.right, problem.p, problem.m, method.factors, 0
    )
    if not method.factors[0, 0] > _SOUND:
        return -0.1
    for i in range(1, _OWN):
        work.times[i] = t + C[i] * h
    fill(problem.tracks, problem.piece, work.times[1:_OWN], work.u[:, 1:_OWN])
    for i in range(STAGES):
        call_step(
            address.stages[i], work.rows, method.k, method.slopes, method.factors, method.right, h
        )
        if i + 1 < STAGES:
            u = work.u[:, min(i + 1, _OWN - 1) :]
            call_native(
                problem.engine.rate,
                work.rows,
                TRIAL,
                u,
                problem.p,
                problem.m,
                work.rows,
                STAGE_RATE,
            )
    error = _error(work, method, control.tolerance)
    if not math.isfinite(error):
        return -0.1
    factor = min(_GROW, _SAFETY * (error + 1e-12) ** (-1.0 / _ORDER))
    return float(-max(_SHRINK, factor) if error > 1.0 else factor)


@part()
def _error(work: Any, method: Any, tolerance: float) -> float:
    """Return the r.m.s. error of the states relative to the tolerance, from the last stage (order 4)."""
    total, n = 0.0, len(work.widest)
    for d in range(n):
        share = method.k[STAGES - 1, d] / (
            tolerance * work.widest[d] + 1e-15 * abs(work.rows[STATE, d])
        )
        total += share * share
    return math.sqrt(total / n)


@part()
def _dense(problem: Any, method: Any, work: Any, t: float, h: float) -> None:
    """Compute the interpolant, in the nested form of the explicit method, and the inputs at the probes."""
    address = method.slopes_at
    call_step(
        address.interpolant, work.rows, method.k, method.slopes, method.factors, method.right, h
    )
    if len(problem.m) > 0:
        inputs(problem, work, t, h, FIRST_PROBE, FIRST_PROBE + len(PROBES))


integrate = way_through(_look, _step, _dense, Rosenbrock)
