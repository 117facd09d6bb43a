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
    """Times to step to and, for each step, which transition matrix leads there; ``keep`` marks output samples."""

    grid: Array
    transition: NDArray[np.int64]
    keep: NDArray[np.bool_]
    lengths: Array
    frequencies: Array


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
    return Plan(grid[:steps], transition[:steps], keep[:steps], lengths[:distinct], frequencies[:distinct])


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


@njit(cache=True, error_model="numpy", fastmath={"contract", "reassoc"})  # type: ignore[untyped-decorator]
def _advance_state(matrix: Any, here: Any, signal: Any, out: Any) -> None:  # noqa: ANN401
    n = len(out)
    for d in range(n):
        total = matrix[d, n] + matrix[d, n + 1] * signal[0] + matrix[d, n + 2] * signal[1] + matrix[d, n + 3] * signal[2]
        for j in range(n):
            total += matrix[d, j] * here[j]
        out[d] = total


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def propagate(problem: Any, plan: Any, matrices: Any, out: Any) -> int:  # noqa: ANN401
    """Fill the arrays at every sample; give a status code (0 completed, 1 not finite)."""
    tracks, piece, times, u = problem.tracks, problem.piece, out.times, np.zeros((2, 1))
    n = out.states.shape[0]
    slack = 1e-12 * max(1.0, abs(times[-1]))
    signal, after, here = np.zeros(3), np.zeros(n), problem.x0.copy()
    t, sample = times[0], 0
    for step in range(len(plan.grid) + 1):
        advance(tracks, piece, t, slack)
        evaluate(tracks, piece, t, u, 0)
        if step == 0 or plan.keep[step - 1]:
            out.states[:, sample] = here
            out.inputs[0, sample], out.inputs[1, sample] = u[0, 0], u[1, 0]
            sample += 1
        if step == len(plan.grid):
            break
        i = piece[0]
        signal[0], signal[1] = u[0, 0], u[1, 0]
        if tracks.kind[i] == 0:
            signal[2] = 2.0 * tracks.coefficients[i, 2] * tracks.rate[0] ** 2
        else:
            signal[2] = -(plan.frequencies[plan.transition[step]] ** 2) * (signal[0] - tracks.coefficients[i, 0])
        _advance_state(matrices[plan.transition[step]], here, signal, after)
        here[:] = after
        t = plan.grid[step]
    call_many(problem.engine.output, out.states, out.inputs, problem.p, problem.m, out.outputs, 0, len(times))
    return 0 if math.isfinite(here.sum()) else 1
