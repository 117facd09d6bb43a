"""Exact propagation of linear models: matrix exponentials of the state joined with its input signal.

On one piece of the road the input obeys a small linear equation of its own, ``u''' = -w^2 u'`` (``w = 0`` on parabolas
and straight lines, the angular frequency on sines). Joined with ``x' = A x + r + B0 u + B1 u'`` the whole is
autonomous, so a step of any length is one matrix exponential: no step-size error at all.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from jounce.kernel.call import call_many
from jounce.kernel.tracks import Tracks, advance, evaluate

Array = NDArray[np.float64]
MAX_TRANSITIONS = 256


class Plan(NamedTuple):
    """Times to step to and, for each step, which transition matrix leads there; ``keep`` marks output samples.

    On piece ``i`` of the input, ``u'' = curvature[i] - stiffness[i] (u - c0)``.
    """

    grid: Array
    transition: NDArray[np.int64]
    keep: NDArray[np.bool_]
    lengths: Array
    frequencies: Array
    curvature: Array
    stiffness: Array


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _plan(tracks: Any, times: Any, grid: Any, transition: Any, keep: Any, lengths: Any, frequencies: Any) -> tuple[int, int]:  # noqa: ANN401
    """Fill the plan; give the numbers of steps and of distinct transitions (-1 when there are too many)."""
    piece = tracks.first[:-1].copy()
    slack = 1e-12 * max(1.0, abs(times[-1]))
    t, sample, step, distinct = times[0], 1, 0, 0
    while sample < len(times):
        edge = advance(tracks, piece, t, slack)
        stop = min(edge, times[sample])
        keep[step] = times[sample] - stop <= slack
        stop = times[sample] if keep[step] else stop
        i = piece[0]
        frequency = abs(tracks.coefficients[i, 2] * tracks.rate[0]) if tracks.kind[i] == 1 else 0.0
        key = 0
        while key < distinct and not (abs(lengths[key] - (stop - t)) <= 1e-12 and frequencies[key] == frequency):
            key += 1
        if key == distinct:
            if distinct == len(lengths):
                return step, -1
            lengths[key], frequencies[key] = stop - t, frequency
            distinct += 1
        grid[step], transition[step] = stop, key
        sample += 1 if keep[step] else 0
        step += 1
        t = stop
    return step, distinct


def plan(tracks: Tracks, times: Array) -> Plan | None:
    """Plan an exact run, or None where it does not pay or is not exact (cubic or circular pieces, irregular steps)."""
    if len(tracks.rate) != 1 or np.any(tracks.kind == 2) or np.any((tracks.kind == 0) & (tracks.coefficients[:, 3] != 0.0)):
        return None
    size = len(times) + len(tracks.start) + 1
    grid, transition, keep = np.empty(size), np.empty(size, dtype=np.int64), np.zeros(size, dtype=np.bool_)
    lengths, frequencies = np.empty(MAX_TRANSITIONS), np.empty(MAX_TRANSITIONS)
    steps, distinct = _plan(tracks, times, grid, transition, keep, lengths, frequencies)
    if distinct < 0:
        return None
    bend = tracks.coefficients[:, 2] * tracks.rate[0]
    curvature = np.where(tracks.kind == 0, 2.0 * bend * tracks.rate[0], 0.0)
    stiffness = np.where(tracks.kind == 1, bend**2, 0.0)
    return Plan(
        grid[:steps], transition[:steps], keep[:steps], lengths[:distinct], frequencies[:distinct], curvature, stiffness
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
    from scipy.linalg import expm

    n = len(offset)
    joined = np.zeros((len(plan.lengths), n + 4, n + 4))
    joined[:, :n, :n] = slope
    joined[:, :n, n] = offset
    joined[:, :n, n + 1 : n + 3] = input_slope
    joined[:, n + 1, n + 2] = joined[:, n + 2, n + 3] = 1.0
    joined[:, n + 3, n + 2] = -(plan.frequencies**2)
    return np.ascontiguousarray(expm(joined * plan.lengths[:, None, None])[:, :n, :])


_BLOCK = 1024


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _signals(problem: Any, plan: Any, start: float, first: int, last: int, slack: float, signal: Any) -> None:  # noqa: ANN401
    """Input, its rate and its second rate at the start of each step of a block (and after the last one)."""
    tracks, piece, u = problem.tracks, problem.piece, np.zeros((2, 1))
    grid, curvature, stiffness, coefficients = plan.grid, plan.curvature, plan.stiffness, tracks.coefficients
    for step in range(first, last + 1):
        t = start if step == 0 else grid[step - 1]
        advance(tracks, piece, t, slack)
        evaluate(tracks, piece, t, u, 0)
        i, at = piece[0], step - first
        signal[0, at], signal[1, at] = u[0, 0], u[1, 0]
        signal[2, at] = curvature[i] - stiffness[i] * (u[0, 0] - coefficients[i, 0])


@njit(cache=True, error_model="numpy", fastmath={"contract"})  # type: ignore[untyped-decorator]
def _drive(matrix: Any, signal: Any, first: int, last: int, drive: Any) -> None:  # noqa: ANN401
    """What the input adds to each state over the steps ``first`` to ``last`` of a block."""
    n = drive.shape[0]
    for d in range(n):
        c, c0, c1, c2 = matrix[d, n], matrix[d, n + 1], matrix[d, n + 2], matrix[d, n + 3]
        for k in range(first, last):
            drive[d, k] = c + c0 * signal[0, k] + c1 * signal[1, k] + c2 * signal[2, k]


@njit(cache=True, error_model="numpy", fastmath={"contract"})  # type: ignore[untyped-decorator]
def _march(matrix: Any, drive: Any, first: int, last: int, x: Any) -> None:  # noqa: ANN401
    """States after each step: ``x[:, k + 1] = matrix x[:, k] + drive[:, k]``."""
    n = drive.shape[0]
    if n == 4:
        _march_four(matrix, drive, first, last, x)
        return
    for k in range(first, last):
        for d in range(n):
            total = drive[d, k]
            for j in range(n):
                total += matrix[d, j] * x[j, k]
            x[d, k + 1] = total


@njit(cache=True, error_model="numpy", fastmath={"contract"})  # type: ignore[untyped-decorator]
def _march_four(matrix: Any, drive: Any, first: int, last: int, x: Any) -> None:  # noqa: ANN401
    """Four states, as quarter and half cars have, stay in registers."""
    a00, a01, a02, a03 = matrix[0, 0], matrix[0, 1], matrix[0, 2], matrix[0, 3]
    a10, a11, a12, a13 = matrix[1, 0], matrix[1, 1], matrix[1, 2], matrix[1, 3]
    a20, a21, a22, a23 = matrix[2, 0], matrix[2, 1], matrix[2, 2], matrix[2, 3]
    a30, a31, a32, a33 = matrix[3, 0], matrix[3, 1], matrix[3, 2], matrix[3, 3]
    x0, x1, x2, x3 = x[0, first], x[1, first], x[2, first], x[3, first]
    for k in range(first, last):
        y0 = (drive[0, k] + a00 * x0 + a01 * x1) + (a02 * x2 + a03 * x3)
        y1 = (drive[1, k] + a10 * x0 + a11 * x1) + (a12 * x2 + a13 * x3)
        y2 = (drive[2, k] + a20 * x0 + a21 * x1) + (a22 * x2 + a23 * x3)
        x3 = (drive[3, k] + a30 * x0 + a31 * x1) + (a32 * x2 + a33 * x3)
        x0, x1, x2 = y0, y1, y2
        x[0, k + 1], x[1, k + 1], x[2, k + 1], x[3, k + 1] = x0, x1, x2, x3


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def propagate(problem: Any, plan: Any, matrices: Any, out: Any) -> int:  # noqa: ANN401
    """Fill the arrays at every sample, block by block; give a status code (0 completed, 1 not finite)."""
    states, inputs, times, keep, transition = out.states, out.inputs, out.times, plan.keep, plan.transition
    n, steps = states.shape[0], len(plan.grid)
    slack = 1e-12 * max(1.0, abs(times[-1]))
    signal, drive, x = np.zeros((3, _BLOCK + 1)), np.zeros((n, _BLOCK)), np.zeros((n, _BLOCK + 1))
    x[:, 0] = problem.x0
    sample = 0
    for first in range(0, max(steps, 1), _BLOCK):
        last = min(first + _BLOCK, steps)
        _signals(problem, plan, times[0], first, last, slack, signal)
        run = first
        while run < last:
            which, begin = transition[run], run
            while run < last and transition[run] == which:
                run += 1
            _drive(matrices[which], signal, begin - first, run - first, drive)
            _march(matrices[which], drive, begin - first, run - first, x)
        begin = sample
        for step in range(first, last + 1 if last == steps else last):
            if step == 0 or keep[step - 1]:
                for d in range(n):
                    states[d, sample] = x[d, step - first]
                inputs[0, sample], inputs[1, sample] = signal[0, step - first], signal[1, step - first]
                sample += 1
        call_many(
            problem.engine.output, out.states, out.inputs, problem.p, problem.m, out.outputs, begin, sample - begin
        )
        x[:, 0] = x[:, last - first]
    return 0 if math.isfinite(x[:, 0].sum()) else 1
