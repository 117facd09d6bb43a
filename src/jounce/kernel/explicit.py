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
from jounce.kernel.call import call_native
from jounce.kernel.tracks import advance, evaluate

_A, _B, _C, _D, _E3, _E5 = dop853.A, dop853.B, dop853.C, dop853.D, dop853.E3, dop853.E5
_PROBES = np.array([0.25, 0.5, 0.75, 1.0])
_COMPLETED, _NOT_FINITE, _STEP_TOO_SMALL, _TOO_MANY_STEPS, _CHATTER = 0, 1, 2, 3, 4


class Engine(NamedTuple):
    """Addresses of native functions ``f(x, u, p, m, out)``; 0 where there is none."""

    rate: int
    output: int
    switch: int
    switch_slope: int


class Control(NamedTuple):
    """How a run is steered.

    ``tolerance`` is relative to ``scale`` (typical size of each controlled state); ``dead_band`` is how far each
    switching function may lie on the wrong side of its mode.
    """

    tolerance: float
    scale: NDArray[np.float64]
    dead_band: NDArray[np.float64]
    max_steps: int


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _rate(engine: Any, tracks: Any, piece: Any, t: float, x: Any, u: Any, p: Any, m: Any, out: Any) -> None:  # noqa: ANN401
    evaluate(tracks, piece, t, u)
    call_native(engine.rate, x, u, p, m, out)


@njit(cache=True, error_model="numpy", fastmath={"contract"})  # type: ignore[untyped-decorator]
def _combine(x: Any, k: Any, weights: Any, stages: int, h: float, out: Any) -> None:  # noqa: ANN401
    for d in range(len(x)):
        total = 0.0
        for j in range(stages):
            total += weights[j] * k[j, d]
        out[d] = x[d] + h * total


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _step(engine: Any, tracks: Any, piece: Any, t: float, h: float, x: Any, p: Any, m: Any, work: Any) -> None:  # noqa: ANN401
    """One step from ``x`` (its rate is in k[0]) to work.end, with the rate there in k[12]."""
    k, trial, u = work.k, work.trial, work.u
    for i in range(1, 12):
        _combine(x, k, _A[i], i, h, trial)
        _rate(engine, tracks, piece, t + _C[i] * h, trial, u, p, m, k[i])
    _combine(x, k, _B, 12, h, work.end)
    _rate(engine, tracks, piece, t + h, work.end, u, p, m, k[12])


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _error(k: Any, h: float, controlled: int, bound: Any) -> float:  # noqa: ANN401
    """Error of the controlled states relative to ``bound`` (DOP853's blend of fifth and third order)."""
    fifth, third = 0.0, 0.0
    for d in range(controlled):
        e5, e3 = 0.0, 0.0
        for j in range(12):
            e5 += _E5[j] * k[j, d]
            e3 += _E3[j] * k[j, d]
        fifth += (e5 / bound[d]) ** 2
        third += (e3 / bound[d]) ** 2
    blend = fifth + 0.01 * third
    return 0.0 if blend == 0.0 else abs(h) * fifth / math.sqrt(blend * controlled)


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _prepare_dense(
    engine: Any, tracks: Any, piece: Any, t: float, h: float, x: Any, p: Any, m: Any, work: Any  # noqa: ANN401
) -> None:
    """Three more stages and the coefficients of the interpolant on this step."""
    k, dense = work.k, work.dense
    for i in range(13, 16):
        _combine(x, k, _A[i], i, h, work.trial)
        _rate(engine, tracks, piece, t + _C[i] * h, work.trial, work.u, p, m, k[i])
    for d in range(len(x)):
        change = work.end[d] - x[d]
        dense[0, d] = change
        dense[1, d] = h * k[0, d] - change
        dense[2, d] = 2.0 * change - h * (k[12, d] + k[0, d])
        for i in range(4):
            total = 0.0
            for j in range(16):
                total += _D[i, j] * k[j, d]
            dense[3 + i, d] = h * total


@njit(cache=True, error_model="numpy", fastmath={"contract"})  # type: ignore[untyped-decorator]
def _interpolate(x: Any, dense: Any, theta: float, out: Any) -> None:  # noqa: ANN401
    rest = 1.0 - theta
    for d in range(len(x)):
        y = dense[6, d] * theta
        y = (y + dense[5, d]) * rest
        y = (y + dense[4, d]) * theta
        y = (y + dense[3, d]) * rest
        y = (y + dense[2, d]) * theta
        y = (y + dense[1, d]) * rest
        out[d] = x[d] + (y + dense[0, d]) * theta


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _switches_at(
    engine: Any, tracks: Any, piece: Any, t: float, h: float, theta: float, x: Any, p: Any, m: Any, work: Any  # noqa: ANN401
) -> None:
    """Fill work.g with the switching functions at a fraction of the step."""
    _interpolate(x, work.dense, theta, work.trial)
    evaluate(tracks, piece, t + theta * h, work.u)
    call_native(engine.switch, work.trial, work.u, p, m, work.g)


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _wrong_side(g: Any, m: Any, band: Any, i: int) -> bool:  # noqa: ANN401
    return g[i] < -band[i] if m[i] > 0.5 else g[i] > band[i]


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _crossing(
    engine: Any, tracks: Any, piece: Any, t: float, h: float, x: Any, p: Any, m: Any, band: Any, work: Any  # noqa: ANN401
) -> tuple[float, int]:
    """First fraction of the step at which a switch leaves its side, and which; (2, -1) when none does."""
    before = 0.0
    for probe in _PROBES:
        _switches_at(engine, tracks, piece, t, h, probe, x, p, m, work)
        first, which = 2.0, -1
        work.seen[:] = work.g
        for i in range(len(m)):
            if _wrong_side(work.seen, m, band, i):
                theta = _root(engine, tracks, piece, t, h, x, p, m, work, i, before, probe)
                if theta < first:
                    first, which = theta, i
        if which >= 0:
            return first, which
        before = probe
    return 2.0, -1


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _root(
    engine: Any, tracks: Any, piece: Any, t: float, h: float, x: Any, p: Any, m: Any, work: Any,  # noqa: ANN401
    i: int, low: float, high: float,
) -> float:
    """Locate the zero of switch ``i`` between two fractions of the step (Illinois variant of regula falsi)."""
    _switches_at(engine, tracks, piece, t, h, low, x, p, m, work)
    g_low = work.g[i]
    _switches_at(engine, tracks, piece, t, h, high, x, p, m, work)
    g_high = work.g[i]
    if g_low * g_high >= 0.0:
        return low
    for _ in range(60):
        theta = (low * g_high - high * g_low) / (g_high - g_low)
        _switches_at(engine, tracks, piece, t, h, theta, x, p, m, work)
        g = work.g[i]
        if g == 0.0 or abs(high - low) < 1e-13 or abs(theta - high) < 1e-14:
            return theta
        if g * g_high < 0.0:
            low, g_low = high, g_high
        else:
            g_low *= 0.5
        high, g_high = theta, g
    return high


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def _flip(engine: Any, tracks: Any, piece: Any, t: float, x: Any, p: Any, m: Any, which: int, n: int, work: Any) -> None:  # noqa: ANN401
    """Flip one mode at an event; sensitivities behind the first ``n`` states jump by the saltation rule."""
    u, before, after = work.u, work.k[1], work.k[0]
    if len(x) > n:
        _rate(engine, tracks, piece, t, x, u, p, m, before)
        call_native(engine.switch_slope, x, u, p, m, work.slope)
    m[which] = 1.0 - m[which]
    _rate(engine, tracks, piece, t, x, u, p, m, after)
    if len(x) == n:
        return
    columns = (len(x) - n) // n
    row = work.slope[which]  # dg/dx (n), dg/dp (columns), dg/dt along the inputs
    speed = row[n + columns]
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
    _rate(engine, tracks, piece, t, x, u, p, m, after)


class _Work(NamedTuple):
    k: NDArray[np.float64]
    dense: NDArray[np.float64]
    trial: NDArray[np.float64]
    end: NDArray[np.float64]
    u: NDArray[np.float64]
    g: NDArray[np.float64]
    seen: NDArray[np.float64]
    slope: NDArray[np.float64]
    bound: NDArray[np.float64]
    widest: NDArray[np.float64]


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def integrate(
    engine: Any, control: Any, tracks: Any, x0: Any, p: Any, m: Any, times: Any, states: Any, outputs: Any, counts: Any  # noqa: ANN401
) -> int:
    """Integrate from ``times[0]`` to ``times[-1]``; fill ``states`` and ``outputs`` at every time; give a status code.

    ``m`` holds the modes and is left as at the end. ``counts`` gets steps, rejected steps and events.
    """
    n, size = len(control.scale), len(x0)
    piece = tracks.first[:-1].copy()
    work = _Work(
        np.zeros((16, size)), np.zeros((7, size)), np.zeros(size), np.zeros(size), np.zeros(2 * len(piece)),
        np.zeros(len(m)), np.zeros(len(m)), np.zeros((len(m), n + size // n)), np.zeros(n), control.scale.copy(),
    )
    x, t, end = x0.copy(), times[0], times[-1]
    slack = 1e-12 * max(1.0, abs(end))
    edge = advance(tracks, piece, t, slack)
    _rate(engine, tracks, piece, t, x, work.u, p, m, work.k[0])
    h, sample, flips = min(1e-3, end - t), 0, 0
    while t < end - slack:
        stop = min(edge, end)
        if counts[0] + counts[1] >= control.max_steps:
            return _TOO_MANY_STEPS
        h = min(h, stop - t)
        if stop - t - h < 0.1 * h:
            h = stop - t
        if h < 1e-14 * max(1.0, abs(t)):
            return _STEP_TOO_SMALL
        _step(engine, tracks, piece, t, h, x, p, m, work)
        for d in range(n):
            work.bound[d] = control.tolerance * work.widest[d] + 1e-15 * abs(x[d])
        error = _error(work.k, h, n, work.bound)
        if not math.isfinite(error):
            counts[1] += 1
            h *= 0.1
            if h < 1e-12:
                return _NOT_FINITE
            continue
        if error > 1.0:
            counts[1] += 1
            h *= max(0.2, 0.9 * error ** (-0.125))
            continue
        grow = min(5.0, 0.9 * (error + 1e-12) ** (-0.125))
        wanted = sample < len(times) and times[sample] < t + h - slack
        if wanted or len(m) > 0:
            _prepare_dense(engine, tracks, piece, t, h, x, p, m, work)
        which, new_h = -1, h
        if len(m) > 0:
            theta, which = _crossing(engine, tracks, piece, t, h, x, p, m, control.dead_band, work)
            if which >= 0:
                new_h = theta * h
                if new_h <= 1e-13 * max(1.0, abs(t)):
                    flips += 1
                    if flips > 20 * len(m):
                        return _CHATTER
                    _flip(engine, tracks, piece, t, x, p, m, which, n, work)
                    counts[2] += 1
                    continue
                if new_h < h:
                    _step(engine, tracks, piece, t, new_h, x, p, m, work)
                    _prepare_dense(engine, tracks, piece, t, new_h, x, p, m, work)
        counts[0] += 1
        flips = 0
        while sample < len(times) and times[sample] < t + new_h - slack:
            _interpolate(x, work.dense, (times[sample] - t) / new_h, states[sample])
            evaluate(tracks, piece, times[sample], work.u)
            call_native(engine.output, states[sample], work.u, p, m, outputs[sample])
            sample += 1
        t = t + new_h
        if stop - t <= slack:
            t = stop
        x[:] = work.end
        work.k[0, :] = work.k[12]
        for d in range(n):
            if not math.isfinite(x[d]):
                return _NOT_FINITE
            work.widest[d] = max(work.widest[d], abs(x[d] - x0[d]))
        if edge <= t + slack:
            edge = advance(tracks, piece, t, slack)
            _rate(engine, tracks, piece, t, x, work.u, p, m, work.k[0])
        if which >= 0:
            _flip(engine, tracks, piece, t, x, p, m, which, n, work)
            counts[2] += 1
            h = max(h - new_h, 0.1 * h)
        else:
            h = h * grow
    evaluate(tracks, piece, t, work.u)
    while sample < len(times):
        states[sample] = x
        call_native(engine.output, x, work.u, p, m, outputs[sample])
        sample += 1
    return _COMPLETED
