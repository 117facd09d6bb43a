"""Adaptive implicit integration (Rosenbrock method Rodas5P) for stiff models: bushings, sharp friction.

Each step solves eight linear systems with one matrix, made of the exact slopes of the rates at its start; nothing is
iterated. Fast modes that decay or that nothing excites do not limit the step. Edges of the input, switches, modes,
events, projection and samples are as in ``explicit``, and so are the arrays: the interpolant is put into the same rows.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.kernel import rodas5p
from jounce.kernel.call import call_native, call_step, compiled, part
from jounce.kernel.explicit import (
    _CHATTER,
    _COMPLETED,
    _NOT_FINITE,
    _STEP_TOO_SMALL,
    Control,
    Problem,
    _accept,
    _close,
    _crossing,
    _flip,
    _inputs,
    _limit,
    _scratch,
)
from jounce.kernel.layout import DENSE, FIRST_PROBE, PROBES, RATES, ROWS, STATE, TRIAL
from jounce.kernel.rodas5p import GAMMA, STAGES
from jounce.kernel.rosenbrock_steps import STAGE_RATE
from jounce.kernel.sampling import Samples, finish_samples, place_samples
from jounce.kernel.tracks import advance, fill, fill_rates

_C = rodas5p.C
_NODES = 6  # stages that see an input of their own: the last three all stand at the end of the step
_ORDER = 5.0
_SOUND = 1e-9  # soundness of the factors below which a shorter step is taken
_SAFETY, _SHRINK, _GROW = 0.9, 0.2, 4.0


class Slopes(NamedTuple):
    """Addresses of native functions for the linear systems of a step.

    ``look`` gives slopes at a state and last the rates, ``size`` numbers; ``along_input`` the slopes of the rates along
    the inputs, column after column; ``factor`` makes ``room`` numbers of slopes and shift, the first of which is the
    soundness of the factors; ``stages`` and ``interpolant`` use them (see ``rosenbrock_steps``).
    """

    look: int
    along_input: int
    factor: int
    stages: NDArray[np.int64]
    interpolant: int
    size: int
    room: int


class Stages(NamedTuple):
    """Scratch arrays of a step: stages and drift of the rates, slopes, the linear system, rates of the inputs."""

    k: Array
    slopes: Array
    factors: Array
    right: Array
    by_input: Array
    moving: Array


@part()
def _look(problem: Any, slopes: Any, work: Any, stages: Any, t: float) -> None:
    """Rates and their slopes at the state and ``t``, and how the rates change in time through the input alone."""
    work.times[0] = t
    fill(problem.tracks, problem.piece, work.times[:1], work.u[:, :1])
    call_native(slopes.look, work.rows, STATE, work.u, problem.p, problem.m, stages.slopes, 0)
    n, drift = stages.k.shape[1], stages.k[STAGES]
    for d in range(n):
        work.rows[RATES, d] = stages.slopes[0, slopes.size - n + d]
        drift[d] = 0.0
    fill_rates(problem.tracks, problem.piece, t, stages.moving)
    still = True
    for i in range(problem.inputs):
        still = still and stages.moving[i] == 0.0
    if still:
        return
    call_native(slopes.along_input, work.rows, STATE, work.u, problem.p, problem.m, stages.by_input, 0)
    for i in range(problem.inputs):
        for d in range(n):
            drift[d] += stages.by_input[0, i * n + d] * stages.moving[i]


@part()
def _step(problem: Any, slopes: Any, work: Any, stages: Any, t: float, h: float) -> bool:
    """One step from the state to the end row; tell whether its matrix was regular."""
    stages.right[0] = 1.0 / (GAMMA * h)
    call_native(slopes.factor, stages.slopes, 0, stages.right, problem.p, problem.m, stages.factors, 0)
    if not stages.factors[0, 0] > _SOUND:
        return False
    for i in range(1, _NODES):
        work.times[i] = t + _C[i] * h
    fill(problem.tracks, problem.piece, work.times[1:_NODES], work.u[:, 1:_NODES])
    for i in range(STAGES):
        call_step(slopes.stages[i], work.rows, stages.k, stages.slopes, stages.factors, stages.right, h)
        if i + 1 < STAGES:
            u = work.u[:, min(i + 1, _NODES - 1) :]
            call_native(problem.engine.rate, work.rows, TRIAL, u, problem.p, problem.m, work.rows, STAGE_RATE)
    return True


@part(fastmath={"contract", "reassoc"})
def _error(work: Any, stages: Any, tolerance: float) -> float:
    """Error of the states relative to what is allowed (root mean square); it is of order 4."""
    total, n = 0.0, len(work.widest)
    for d in range(n):
        share = stages.k[STAGES - 1, d] / (tolerance * work.widest[d] + 1e-15 * abs(work.rows[STATE, d]))
        total += share * share
    return math.sqrt(total / n)


@part()
def _prepare_dense(problem: Any, slopes: Any, work: Any, stages: Any, t: float, h: float) -> None:
    """Coefficients of the interpolant, in the nested form of ``explicit``, and the inputs at the probes."""
    call_step(slopes.interpolant, work.rows, stages.k, stages.slopes, stages.factors, stages.right, h)
    if len(problem.m) > 0:
        _inputs(problem, work, t, h, FIRST_PROBE, FIRST_PROBE + len(PROBES))


@part()
def _attempt(
    problem: Any, slopes: Any, control: Any, work: Any, stages: Any, t: float, h: float, dense: bool, edge: bool
) -> tuple[float, float, int]:
    """Try one step; give (share of it that holds, factor for the next step, switch that ends it or -1).

    A share of 0 with no switch means rejected; the dense output of an accepted step is prepared where wanted.
    """
    regular = _step(problem, slopes, work, stages, t, h)
    error = _error(work, stages, control.tolerance) if regular else math.nan
    if not math.isfinite(error):
        return 0.0, 0.1, -1
    factor = min(_GROW, _SAFETY * (error + 1e-12) ** (-1.0 / _ORDER))
    if error > 1.0:
        return 0.0, max(_SHRINK, factor), -1
    if dense or len(problem.m) > 0:
        _prepare_dense(problem, slopes, work, stages, t, h)
    if len(problem.m) > 0:
        theta, which = _crossing(problem, work, control.dead_band, t, h, edge)
        if which >= 0:
            if 0.0 < theta < 1.0:
                _step(problem, slopes, work, stages, t, theta * h)
                _prepare_dense(problem, slopes, work, stages, t, theta * h)
            return theta, max(1.0 - theta, 0.1), which
    return 1.0, factor, -1


def integrate(problem: Problem, slopes: Slopes, control: Control, out: Samples, counts: NDArray[np.int64]) -> int:
    """Integrate from the first to the last sample; fill the arrays at every sample; give a status code.

    At an input edge the samples are those just after it. ``counts`` gets steps, rejected steps and events. The state
    carries no sensitivities.
    """
    n = len(problem.x0)
    stages = Stages(
        np.zeros((STAGES + 1, n)),
        np.zeros((1, slopes.size)),
        np.zeros((1, slopes.room)),
        np.zeros(1 + n),
        np.zeros((1, n * max(problem.inputs, 1))),
        np.zeros(problem.inputs),
    )
    work = _scratch(problem, control)
    work.rows[DENSE:ROWS] = 0.0
    return int(_integrate(problem, slopes, control, work, stages, out, counts))


@compiled()
def _integrate(problem: Any, slopes: Any, control: Any, work: Any, stages: Any, out: Any, counts: Any) -> int:
    status = _walk(problem, slopes, control, work, stages, out, counts)
    finish_samples(problem, work, out)
    return int(status)


@part()
def _walk(problem: Any, slopes: Any, control: Any, work: Any, stages: Any, out: Any, counts: Any) -> int:
    times = out.times
    t, end = times[0], times[-1]
    slack = 1e-12 * max(1.0, abs(end))
    edge = advance(problem.tracks, problem.piece, t, slack)
    _look(problem, slopes, work, stages, t)
    h, stalled = min(1e-4, end - t, control.longest), 0
    at_edge, rejected = True, False
    while t < end - slack:
        stop = min(edge, end)
        tried = stop - t if stop - t < 1.1 * h else h
        limit = _limit(control, counts, t, tried)
        if limit != _COMPLETED:
            return int(limit)
        wanted = work.marks[0] < len(times) and times[work.marks[0]] < t + tried - slack
        share, factor, which = _attempt(problem, slopes, control, work, stages, t, tried, wanted, at_edge)
        h = min(_next_step(h, tried, share, factor, which, rejected), control.longest)
        rejected = share == 0.0 and which < 0
        if share * tried <= slack * 1e-3:
            if which < 0:
                counts[1] += 1
                if h < 1e-12 * max(1.0, abs(t)):
                    return _NOT_FINITE if factor <= 0.1 else _STEP_TOO_SMALL
                continue
            stalled += 1
            if stalled > 20 * len(problem.m):
                return _CHATTER
            h = tried
        else:
            stalled, at_edge = 0, False
            counts[0] += 1
            now = t + share * tried
            now = stop if stop - now <= slack else now
            place_samples(problem, work, t, share * tried, now - slack, out)
            t = now
            arrived = _settle(problem, work, t)
            if arrived != _COMPLETED:
                return int(arrived)
        if edge <= t + slack:
            edge, at_edge = advance(problem.tracks, problem.piece, t, slack), True
        if which >= 0:
            finish_samples(problem, work, out)
            _flip(problem, work, t, which, share < 0.0)
            counts[2] += 1
        _look(problem, slopes, work, stages, t)
    _stand_still(work.rows)
    place_samples(problem, work, t, 1.0, np.inf, out)
    return _COMPLETED


@part()
def _next_step(h: float, tried: float, share: float, factor: float, which: int, rejected: bool) -> float:
    """Length of the next step: one cut short by an edge says little of it; none grows right after a failure."""
    if which >= 0 or share == 0.0 or factor < 1.0:
        return tried * factor
    return tried if rejected else max(h, tried * factor)


@part()
def _stand_still(rows: Any) -> None:
    """Let the interpolant stay at the state."""
    for i in range(DENSE, ROWS):
        for d in range(rows.shape[1]):
            rows[i, d] = 0.0


@part()
def _settle(problem: Any, work: Any, t: float) -> int:
    """Take over the end of the step, on the constraints; tell how that ended. The rates are made by a look."""
    if not _accept(problem.x0, work.rows, work.widest):
        return _NOT_FINITE
    return _close(problem, work, t) if problem.engine.project != 0 else _COMPLETED
