"""Adaptive explicit integration (Dormand-Prince 8(5,3), dense output) that lands on input edges and on events.

Modes (one 0/1 flag for each switching function) are constant within a step, so every step integrates a smooth
equation. After a step the switching functions are checked at its end and inside it; where one has left the side that
its mode stands for, the step is repeated up to the located crossing and the mode flips.

The state may carry sensitivities behind it: columns ``S = dx/dp`` of the variational equation. They do not steer the
step size; at an event they jump by the saltation rule.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from jounce.kernel import dop853
from jounce.kernel.call import call_many, call_native
from jounce.kernel.tracks import Tracks, advance, evaluate

Array = NDArray[np.float64]
_C = dop853.C
_PROBES = (0.25, 0.5, 0.75, 1.0)
_COMPLETED, _NOT_FINITE, _STEP_TOO_SMALL, _TOO_MANY_STEPS, _CHATTER = 0, 1, 2, 3, 4


class Engine(NamedTuple):
    """Addresses of native functions ``f(x, u, p, m, out)``; 0 where there is none."""

    rate: int
    output: int
    switch: int
    switch_slope: int
    stages: NDArray[np.int64]
    dense: int
    error: int


class Control(NamedTuple):
    """How a run is steered.

    ``tolerance`` is relative to the size of each controlled state so far, at least ``scale``; ``dead_band`` is how far
    each switching function may lie on the wrong side of its mode.
    """

    tolerance: float
    scale: Array
    dead_band: Array
    max_steps: int


class Problem(NamedTuple):
    """What is integrated: native functions, inputs, parameter values, modes (changed in place) and first state."""

    engine: Engine
    tracks: Tracks
    piece: NDArray[np.int64]
    p: Array
    m: Array
    x0: Array


class Samples(NamedTuple):
    """Where the run is sampled and the arrays it fills: one row an element, one column a sample."""

    times: Array
    states: Array
    inputs: Array
    outputs: Array


class Work(NamedTuple):
    """Scratch arrays: row 0 of ``x`` is the state, row 1 its value after the step, row 2 a trial."""

    k: Array
    dense: Array
    step: Array
    none: Array
    errors: Array
    x: Array
    u: Array
    g: Array
    seen: Array
    slope: Array
    widest: Array


_STATE, _END, _TRIAL = 0, 1, 2


@njit(cache=True, error_model="numpy", inline="always")  # type: ignore[untyped-decorator]
def _rate(problem: Any, work: Any, t: float, row: int, into: int) -> None:  # noqa: ANN401
    evaluate(problem.tracks, problem.piece, t, work.u, 0)
    call_native(problem.engine.rate, work.x, row, work.u, problem.p, problem.m, work.k, into)


@njit(cache=True, error_model="numpy", inline="always")  # type: ignore[untyped-decorator]
def _place(problem: Any, work: Any, stage: int, into: int) -> None:  # noqa: ANN401
    """Fill a row of x with where a stage evaluates the rates."""
    call_native(problem.engine.stages[stage], work.x, _STATE, work.k, work.step, work.none, work.x, into)


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _step(problem: Any, work: Any, t: float, h: float) -> None:  # noqa: ANN401
    """One step from the state (its rate is in k[0]) to the end row, with the rate there in k[12]."""
    work.step[0] = h
    for i in range(1, 12):
        _place(problem, work, i, _TRIAL)
        _rate(problem, work, t + _C[i] * h, _TRIAL, i)
    _place(problem, work, 12, _END)
    _rate(problem, work, t + h, _END, 12)


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _error(problem: Any, work: Any) -> float:  # noqa: ANN401
    """Error of the controlled states relative to what is allowed (DOP853's blend of fifth and third order)."""
    call_native(problem.engine.error, work.x, _STATE, work.k, work.step, work.widest, work.errors, 0)
    fifth, third = work.errors[0, 0], work.errors[0, 1]
    blend = fifth + 0.01 * third
    return 0.0 if blend == 0.0 else abs(work.step[0]) * fifth / math.sqrt(blend * len(work.widest))


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _prepare_dense(problem: Any, work: Any, t: float, h: float) -> None:  # noqa: ANN401
    """Three more stages and the coefficients of the interpolant on this step."""
    for i in range(13, 16):
        _place(problem, work, i, _TRIAL)
        _rate(problem, work, t + _C[i] * h, _TRIAL, i)
    call_native(problem.engine.dense, work.x, _STATE, work.k, work.step, work.x[_END], work.dense, 0)


@njit(cache=True, error_model="numpy", fastmath={"contract"}, inline="always")  # type: ignore[untyped-decorator]
def _interpolated(work: Any, d: int, theta: float) -> float:  # noqa: ANN401
    """State ``d`` at a fraction of the step."""
    rest, dense = 1.0 - theta, work.dense
    size = work.x.shape[1]
    y = dense[0, 6 * size + d] * theta
    y = (y + dense[0, 5 * size + d]) * rest
    y = (y + dense[0, 4 * size + d]) * theta
    y = (y + dense[0, 3 * size + d]) * rest
    y = (y + dense[0, 2 * size + d]) * theta
    y = (y + dense[0, size + d]) * rest
    return work.x[_STATE, d] + (y + dense[0, d]) * theta


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _switches_at(problem: Any, work: Any, t: float, h: float, theta: float) -> None:  # noqa: ANN401
    """Fill g with the switching functions at a fraction of the step."""
    for d in range(work.x.shape[1]):
        work.x[_TRIAL, d] = _interpolated(work, d, theta)
    evaluate(problem.tracks, problem.piece, t + theta * h, work.u, 0)
    call_native(problem.engine.switch, work.x, _TRIAL, work.u, problem.p, problem.m, work.g, 0)


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _crossing(problem: Any, work: Any, band: Any, t: float, h: float) -> tuple[float, int]:  # noqa: ANN401
    """First fraction of the step at which a switch leaves its side, and which; (2, -1) when none does."""
    before, first, which = 0.0, 2.0, -1
    seen, now, modes = work.seen, work.g, problem.m
    for probe in _PROBES:
        _switches_at(problem, work, t, h, probe)
        for i in range(len(modes)):
            seen[i] = now[0, i]
        for i in range(len(modes)):
            g = seen[i]
            if g < -band[i] if modes[i] > 0.5 else g > band[i]:
                theta = _root(problem, work, t, h, i, before, probe)
                if theta < first:
                    first, which = theta, i
        if which >= 0:
            break
        before = probe
    return first, which


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _root(problem: Any, work: Any, t: float, h: float, i: int, low: float, high: float) -> float:  # noqa: ANN401
    """Locate the zero of switch ``i`` between two fractions of the step (Illinois variant of regula falsi)."""
    _switches_at(problem, work, t, h, low)
    g_low = work.g[0, i]
    _switches_at(problem, work, t, h, high)
    g_high = work.g[0, i]
    if g_low * g_high >= 0.0:
        return low
    for _ in range(60):
        theta = (low * g_high - high * g_low) / (g_high - g_low)
        _switches_at(problem, work, t, h, theta)
        g = work.g[0, i]
        if g == 0.0 or abs(high - low) < 1e-13 or abs(theta - high) < 1e-14:
            return theta
        if g * g_high < 0.0:
            low, g_low = high, g_high
        else:
            g_low *= 0.5
        high, g_high = theta, g
    return high


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _flip(problem: Any, work: Any, t: float, which: int) -> None:  # noqa: ANN401
    """Flip one mode at an event; the rate just after it is left in k[0]."""
    n, size = len(work.widest), work.x.shape[1]
    if size > n:
        _rate(problem, work, t, _STATE, 1)
        call_native(problem.engine.switch_slope, work.x, _STATE, work.u, problem.p, problem.m, work.slope, 0)
    problem.m[which] = 1.0 - problem.m[which]
    _rate(problem, work, t, _STATE, 0)
    if size > n:
        _jump_sensitivities(work, which, n, (size - n) // n)
        _rate(problem, work, t, _STATE, 0)


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _jump_sensitivities(work: Any, which: int, n: int, columns: int) -> None:  # noqa: ANN401
    """Saltation: ``S+ = S- + (f+ - f-) (dg/dx S- + dg/dp) / (dg/dt)``, f- in k[1] and f+ in k[0]."""
    x, before, after = work.x[_STATE], work.k[1], work.k[0]
    width = n + columns + 1
    row = work.slope[0, which * width : (which + 1) * width]
    speed = row[width - 1]
    for d in range(n):
        speed += row[d] * before[d]
    if abs(speed) < 1e-300:
        return
    for c in range(columns):
        shift = row[n + c]
        for d in range(n):
            shift += row[d] * x[n + c * n + d]
        for d in range(n):
            x[n + c * n + d] += (after[d] - before[d]) * shift / speed


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _attempt(problem: Any, control: Any, work: Any, t: float, h: float, dense: bool) -> tuple[float, float, int]:  # noqa: ANN401
    """Try one step; give (share of it that holds, factor for the next step, switch that ends it or -1).

    A share of 0 with no switch means rejected; the dense output of an accepted step is prepared where wanted.
    """
    _step(problem, work, t, h)
    error = _error(problem, work)
    if not math.isfinite(error):
        return 0.0, 0.1, -1
    if error > 1.0:
        return 0.0, max(0.2, 0.9 * error**-0.125), -1
    grow = min(5.0, 0.9 * (error + 1e-12) ** -0.125)
    if dense or len(problem.m) > 0:
        _prepare_dense(problem, work, t, h)
    if len(problem.m) > 0:
        theta, which = _crossing(problem, work, control.dead_band, t, h)
        if which >= 0:
            if 0.0 < theta < 1.0:
                _step(problem, work, t, theta * h)
                _prepare_dense(problem, work, t, theta * h)
            return theta, max(1.0 - theta, 0.1), which
    return 1.0, grow, -1


@njit(cache=True, error_model="numpy", fastmath={"contract"})  # type: ignore[untyped-decorator]
def _sample(problem: Any, work: Any, t: float, h: float, until: float, first: int, out: Any) -> int:  # noqa: ANN401
    """Write states, inputs and outputs at all times before ``until`` on the step from ``t``; give the next sample."""
    last = first
    while last < len(out.times) and out.times[last] < until:
        evaluate(problem.tracks, problem.piece, out.times[last], out.inputs, last)
        last += 1
    for d in range(work.x.shape[1]):
        for i in range(first, last):
            out.states[d, i] = _interpolated(work, d, (out.times[i] - t) / h)
    call_many(problem.engine.output, out.states, out.inputs, problem.p, problem.m, out.outputs, first, last - first)
    return last


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _start(problem: Any, control: Any, t: float) -> Any:  # noqa: ANN401
    """Scratch arrays with the first state and its rate."""
    n, size, switches = len(control.scale), len(problem.x0), len(problem.m)
    work = Work(
        np.zeros((16, size)), np.zeros((1, 7 * size)), np.zeros(2), np.zeros(1), np.zeros((1, 2)), np.zeros((3, size)), np.zeros((2 * len(problem.piece), 1)),
        np.zeros((1, switches)), np.zeros(switches), np.zeros((1, switches * (n + size // n))), control.scale.copy(),
    )
    work.x[_STATE, :] = problem.x0
    work.step[1] = control.tolerance
    _rate(problem, work, t, _STATE, 0)
    return work


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _accept(problem: Any, work: Any) -> bool:  # noqa: ANN401
    """Take over the end of the step; tell whether it is finite."""
    for d in range(work.x.shape[1]):
        work.x[_STATE, d] = work.x[_END, d]
        work.k[0, d] = work.k[12, d]
    finite = True
    for d in range(len(work.widest)):
        finite = finite and math.isfinite(work.x[_STATE, d])
        work.widest[d] = max(work.widest[d], abs(work.x[_STATE, d] - problem.x0[d]))
    return finite


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def integrate(problem: Any, control: Any, out: Any, counts: Any) -> int:  # noqa: ANN401
    """Integrate from the first to the last sample; fill the arrays at every sample; give a status code.

    At an input edge the samples are those just after it. ``counts`` gets steps, rejected steps and events.
    """
    times = out.times
    t, end = times[0], times[-1]
    slack = 1e-12 * max(1.0, abs(end))
    edge = advance(problem.tracks, problem.piece, t, slack)
    work = _start(problem, control, t)
    h, sample, stalled = min(1e-3, end - t), 0, 0
    while t < end - slack:
        stop = min(edge, end)
        if counts[0] + counts[1] >= control.max_steps:
            return _TOO_MANY_STEPS
        tried = stop - t if stop - t < 1.1 * h else h
        if tried < 1e-14 * max(1.0, abs(t)):
            return _STEP_TOO_SMALL
        wanted = sample < len(times) and times[sample] < t + tried - slack
        share, factor, which = _attempt(problem, control, work, t, tried, wanted)
        h = tried * factor if which >= 0 or share == 0.0 or factor < 1.0 else max(h, tried * factor)
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
            stalled = 0
            counts[0] += 1
            now = t + share * tried
            now = stop if stop - now <= slack else now
            sample = _sample(problem, work, t, share * tried, now - slack, sample, out)
            t = now
            if not _accept(problem, work):
                return _NOT_FINITE
        if edge <= t + slack:
            edge = advance(problem.tracks, problem.piece, t, slack)
            _rate(problem, work, t, _STATE, 0)
        if which >= 0:
            _flip(problem, work, t, which)
            counts[2] += 1
    work.x[_END, :] = work.x[_STATE]
    work.dense[:] = 0.0
    _sample(problem, work, t, 1.0, np.inf, sample, out)
    return _COMPLETED
