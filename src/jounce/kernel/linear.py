"""Exact propagation of linear models: matrix exponentials of the state joined with its input signal.

On one piece of the road the input obeys a small linear equation of its own, ``u''' = -w^2 u'`` (``w = 0`` on parabolas
and straight lines, the angular frequency on sines). Joined with ``x' = A x + r + B0 u + B1 u'`` the whole is
autonomous, so a step of any length is one matrix exponential: no step-size error at all.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.kernel.call import call_many, compiled, part, sine_and_cosine
from jounce.kernel.explicit import Problem
from jounce.kernel.sampling import Samples
from jounce.kernel.tracks import Tracks, advance

Array = NDArray[np.float64]
MAX_TRANSITIONS = 256


class Plan(NamedTuple):
    """Nodes to step along, from the first sample on; at node ``j`` the input is on ``piece[j]`` of its track.

    Run ``r`` of equal steps leads from node ``run[r]`` to node ``run[r + 1]`` by matrix ``transition[r]``; with
    ``keep[r]`` every step ends on a sample. There is a matrix for each length of step (s) and, on sines, angular
    frequency of the input (rad/s).
    """

    grid: Array
    piece: NDArray[np.int64]
    run: NDArray[np.int64]
    transition: NDArray[np.int64]
    keep: NDArray[np.bool_]
    lengths: Array
    frequencies: Array


@part()
def _transition(plan: Any, distinct: int, guess: int, length: float, frequency: float) -> int:
    """Number of the matrix for a step: the guessed one, another one, a new one; -1 when there is no room for it."""
    for trial in range(-1, distinct):
        key = guess if trial < 0 else trial
        if key < distinct and abs(plan.lengths[key] - length) <= 1e-12 and plan.frequencies[key] == frequency:
            return key
    if distinct == len(plan.lengths):
        return -1
    plan.lengths[distinct], plan.frequencies[distinct] = length, frequency
    return distinct


@compiled()
def _plan(tracks: Any, piece: Any, times: Any, plan: Any) -> tuple[int, int, int]:
    """Fill the plan; give the numbers of steps, runs and distinct transitions (-1 when there are too many)."""
    slack = 1e-12 * max(1.0, abs(times[-1]))
    t, sample, node, runs, distinct, key = times[0], 1, 0, 0, 0, 0
    while True:
        edge = advance(tracks, piece, t, slack)
        i = piece[0]
        plan.grid[node], plan.piece[node] = t, i
        if sample == len(times):
            plan.run[runs] = node
            return node, runs, distinct
        stop = min(edge, times[sample])
        kept = times[sample] - stop <= slack
        stop = times[sample] if kept else stop
        frequency = abs(tracks.coefficients[i, 2] * tracks.rate[0]) if tracks.kind[i] == 1 else 0.0
        key = _transition(plan, distinct, key, stop - t, frequency)
        if key < 0:
            return node, runs, -1
        distinct = max(distinct, key + 1)
        if runs == 0 or plan.transition[runs - 1] != key or plan.keep[runs - 1] != kept:
            plan.run[runs], plan.transition[runs], plan.keep[runs] = node, key, kept
            runs += 1
        sample += 1 if kept else 0
        node += 1
        t = stop


def plan(tracks: Tracks, times: Array) -> Plan | None:
    """Plan an exact run, or None where it does not pay or is not exact (cubic or circular pieces, irregular steps)."""
    cubic = (tracks.kind == 0) & (tracks.coefficients[:, 3] != 0.0)
    if len(tracks.rate) != 1 or np.any(cubic) or np.any(tracks.kind == 2):
        return None
    size = len(times) + len(tracks.start) + 1
    full = Plan(
        np.empty(size),
        np.empty(size, dtype=np.int64),
        np.empty(size, dtype=np.int64),
        np.empty(size, dtype=np.int64),
        np.empty(size, dtype=np.bool_),
        np.empty(MAX_TRANSITIONS),
        np.empty(MAX_TRANSITIONS),
    )
    steps, runs, distinct = _plan(tracks, tracks.first[:-1].copy(), times, full)
    if distinct < 0:
        return None
    return Plan(
        full.grid[: steps + 1],
        full.piece[: steps + 1],
        full.run[: runs + 1],
        full.transition[:runs],
        full.keep[:runs],
        full.lengths[:distinct],
        full.frequencies[:distinct],
    )


def transitions(plan: Plan, slope: Array, offset: Array, input_slope: Array) -> Array:
    """Matrices that lead (x, 1, u, u', u'') over each distinct step, rows of ``x`` only.

    Parameters
    ----------
    plan : Plan
        Step lengths (s) and input frequencies (rad/s).
    slope, offset, input_slope : ndarray, shape (n, n), (n,), (n, 2)
        ``x' = slope x + offset + input_slope (u, u')``, SI.

    Returns
    -------
    ndarray, shape (k, n, n + 4)
        One matrix for each distinct step.
    """
    n = len(offset)
    joined = np.zeros((len(plan.lengths), n + 4, n + 4))
    joined[:, :n, :n] = slope
    joined[:, :n, n] = offset
    joined[:, :n, n + 1 : n + 3] = input_slope
    joined[:, n + 1, n + 2] = joined[:, n + 2, n + 3] = 1.0
    joined[:, n + 3, n + 2] = -(plan.frequencies**2)
    return np.ascontiguousarray(_exponentials(joined * plan.lengths[:, None, None])[:, :n, :])


def _exponentials(matrices: Array) -> Array:
    """Matrix exponentials by Taylor's series and doubling.

    ``scipy.linalg.expm`` takes milliseconds for one matrix where BLAS threads compete for the cores. Without the unit
    matrix in them (``e^2a - 1 = 2 (e^a - 1) + (e^a - 1)^2``) small elements keep their digits in the doubling.
    """
    norm = float(np.max(np.sum(np.abs(matrices), axis=1), initial=0.0))
    doublings = max(0, math.ceil(math.log2(norm / 0.5))) if 0.0 < norm < np.inf else 0
    small, unit = matrices / 2.0**doublings, np.eye(matrices.shape[-1])
    series = unit
    with np.errstate(over="ignore", invalid="ignore"):  # the run's status tells of it
        for j in range(14, 1, -1):  # 0.5^15 / 15! is below rounding
            series = unit + small @ series / j
        grown = small @ series
        for _ in range(doublings):
            grown = 2.0 * grown + grown @ grown
    return np.asarray(grown + unit)


_BLOCK = 512
"""Steps in a block: its scratch arrays stay in the first-level cache."""


@part()
def _signals(tracks: Any, plan: Any, first: int, last: int, signal: Any) -> None:
    """Input, its rate and its second rate at the nodes ``first`` to ``last`` of a block."""
    rate, start, kind, coefficients = tracks.rate[0], tracks.start, tracks.kind, tracks.coefficients
    grid, piece = plan.grid, plan.piece
    for at in range(last - first):
        i = piece[first + at]
        s = rate * (grid[first + at] - start[i])
        c0, c1, c2 = coefficients[i, 0], coefficients[i, 1], coefficients[i, 2]
        if kind[i] == 0:
            signal[0, at] = c0 + s * (c1 + s * c2)
            signal[1, at] = rate * (c1 + 2.0 * c2 * s)
            signal[2, at] = 2.0 * c2 * rate * rate
        else:
            sine, cosine = sine_and_cosine(c2 * s + coefficients[i, 3])
            signal[0, at] = c0 + c1 * sine
            signal[1, at] = rate * c1 * c2 * cosine
            signal[2, at] = -((rate * c2) ** 2) * c1 * sine


@part(fastmath={"contract"})
def _drive(matrix: Any, signal: Any, count: int, drive: Any) -> None:
    """What the input adds to each state over each of ``count`` steps."""
    n = drive.shape[0]
    for d in range(n):
        c, c0, c1, c2 = matrix[d, n], matrix[d, n + 1], matrix[d, n + 2], matrix[d, n + 3]
        for k in range(count):
            drive[d, k] = c + c0 * signal[0, k] + c1 * signal[1, k] + c2 * signal[2, k]


@part(fastmath={"contract"})
def _march(matrix: Any, drive: Any, count: int, x: Any, to: Any) -> None:
    """Columns of ``to``: the state after each step, ``x <- matrix x + drive[:, k]``."""
    n = drive.shape[0]
    if n == 4:
        _march_four(matrix, drive, count, x, to)
        return
    for k in range(count):
        for d in range(n):
            total = drive[d, k]
            for j in range(n):
                total += matrix[d, j] * x[j]
            to[d, k] = total
        for d in range(n):
            x[d] = to[d, k]


@part(fastmath={"contract"})
def _march_four(matrix: Any, drive: Any, count: int, x: Any, to: Any) -> None:
    """Four states, as quarter and half cars have, stay in registers."""
    a00, a01, a02, a03 = matrix[0, 0], matrix[0, 1], matrix[0, 2], matrix[0, 3]
    a10, a11, a12, a13 = matrix[1, 0], matrix[1, 1], matrix[1, 2], matrix[1, 3]
    a20, a21, a22, a23 = matrix[2, 0], matrix[2, 1], matrix[2, 2], matrix[2, 3]
    a30, a31, a32, a33 = matrix[3, 0], matrix[3, 1], matrix[3, 2], matrix[3, 3]
    x0, x1, x2, x3 = x[0], x[1], x[2], x[3]
    for k in range(count):
        y0 = (drive[0, k] + a00 * x0 + a01 * x1) + (a02 * x2 + a03 * x3)
        y1 = (drive[1, k] + a10 * x0 + a11 * x1) + (a12 * x2 + a13 * x3)
        y2 = (drive[2, k] + a20 * x0 + a21 * x1) + (a22 * x2 + a23 * x3)
        x3 = (drive[3, k] + a30 * x0 + a31 * x1) + (a32 * x2 + a33 * x3)
        x0, x1, x2 = y0, y1, y2
        to[0, k], to[1, k], to[2, k], to[3, k] = x0, x1, x2, x3
    x[0], x[1], x[2], x[3] = x0, x1, x2, x3


@part()
def _copy(source: Any, to: Any) -> None:
    """Fill ``to`` with the first columns of as many rows of ``source``."""
    for d in range(to.shape[0]):
        for k in range(to.shape[1]):
            to[d, k] = source[d, k]


def propagate(problem: Problem, plan: Plan, matrices: Array, out: Samples) -> int:
    """Fill the arrays at every sample, block by block; give a status code (0 completed, 1 not finite)."""
    x = problem.x0.copy()
    signal, drive, passed = np.empty((3, _BLOCK + 1)), np.empty((len(x), _BLOCK)), np.empty((len(x), _BLOCK))
    _propagate(problem, plan, matrices, signal, drive, passed, x, out)
    return 0 if np.all(np.isfinite(x)) else 1


@compiled()
def _propagate(problem: Any, plan: Any, matrices: Any, signal: Any, drive: Any, passed: Any, x: Any, out: Any) -> None:
    _signals(problem.tracks, plan, 0, 1, signal)
    _copy(signal, out.inputs[:, :1])
    for d in range(len(x)):
        out.states[d, 0] = x[d]
    sample, written = 1, 0
    for r in range(len(plan.transition)):
        matrix = matrices[plan.transition[r]]
        for first in range(plan.run[r], plan.run[r + 1], _BLOCK):
            count = min(_BLOCK, plan.run[r + 1] - first)
            _signals(problem.tracks, plan, first, first + count + 1, signal)
            _drive(matrix, signal, count, drive)
            if not plan.keep[r]:
                _march(matrix, drive, count, x, passed[:, :count])
            else:
                _march(matrix, drive, count, x, out.states[:, sample : sample + count])
                _copy(signal[:, 1:], out.inputs[:, sample : sample + count])
                sample += count
            if sample - written >= _BLOCK:
                _outputs(problem, out, written, sample)
                written = sample
    _outputs(problem, out, written, sample)


@part()
def _outputs(problem: Any, out: Any, first: int, last: int) -> None:
    """Outputs at the samples ``first`` to ``last``."""
    call_many(problem.engine.output, out.states, out.inputs, problem.p, problem.m, out.outputs, first, last - first)
