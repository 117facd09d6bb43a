"""Adaptive explicit integration (Dormand-Prince 8(5,3), dense output) that lands on input edges and on events.

Modes (one 0/1 flag for each switching function) are constant within a step, so every step integrates a smooth
equation. After a step the switching functions are checked at its end and inside it; where one has left the side that
its mode stands for, the step is repeated up to the located crossing and the mode flips.

The state may carry sensitivities behind it: ``S = dx/dp`` of the variational equation, for each state one number a
parameter. They do not steer the step size; at an event they jump by the saltation rule.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.kernel import dopri5
from jounce.kernel.call import call_native, call_step, compiled, part
from jounce.kernel.dop853 import DENSE_STAGES
from jounce.kernel.feedback import NO_FEEDBACK, Feedback, regulate
from jounce.kernel.layout import (
    DENSE,
    END,
    FIRST_PROBE,
    LAST_STAGE,
    NODES,
    PROBES,
    RATES,
    ROWS,
    SHORT_NODES,
    STATE,
)
from jounce.kernel.sampling import Samples, finish_samples, place_samples
from jounce.kernel.tracks import Tracks, advance, fill

_LAST_RATE, _LAST_PROBE = RATES + LAST_STAGE, len(PROBES)
_HALVINGS = 16
_VERTICES, _NEAR = 3, 0.3  # parabolas followed into a dip that comes within this share of the nearest probe
_COMPLETED, _NOT_FINITE, _STEP_TOO_SMALL, _TOO_MANY_STEPS, _CHATTER, _LOOP_OPENED, _LOCKED_UP = range(7)
_PROJECTIONS = 4
_CLOSED = 1e-7  # violation that one projection brings down to rounding
_SINGULAR = 1e-10  # conditioning of the constraints at which a mechanism counts as locked up


class Engine(NamedTuple):
    """Addresses of native functions: of the model, then of a step (see ``steps``); 0 where there is none.

    The stages that a step evaluates begin with row ``first``, those of its interpolant with ``after``; ``shrink`` is
    the exponent of the error in the choice of the next step.
    """

    rate: int
    output: int
    switch_slope: int
    project: int
    project_many: int
    step: int
    dense: int
    point_at: int
    probe: int
    switch_at: int
    error: int
    first: int = 1
    after: int = LAST_STAGE + 1
    shrink: float = -0.125

    def short(self, step: int, dense: int, error: int) -> Engine:
        """The same with the pair of lower order: 6 stages in place of 15, for steps that edges keep short."""
        return self._replace(step=step, dense=dense, error=error, first=dopri5.FIRST, after=FIRST_PROBE, shrink=-0.2)


class Control(NamedTuple):
    """How a run is steered.

    ``tolerance`` is relative to the size of each controlled state so far, at least ``scale``; ``dead_band`` is how far
    each switching function may lie on the wrong side of its mode; no step is longer than ``longest`` (s).
    """

    tolerance: float
    scale: Array
    dead_band: Array
    max_steps: int
    longest: float


class Problem(NamedTuple):
    """What is integrated: native functions, tracks, parameter values, modes (changed in place) and first state.

    ``inputs`` is the number of inputs that the tracks make: two or three for each.
    """

    engine: Engine
    tracks: Tracks
    piece: NDArray[np.int64]
    p: Array
    m: Array
    x0: Array
    inputs: int


class Work(NamedTuple):
    """Scratch arrays: ``rows`` (see ``layout``), times and inputs at a step's nodes, switching functions at its probes.

    ``step`` is (length, tolerance), ``errors`` the squared errors, ``slope`` that of the switching functions,
    ``sampled`` the inputs at a sample; ``marks`` how many samples are placed, and how many of them finished.
    """

    rows: Array
    times: Array
    nodes: Array
    u: Array
    g: Array
    step: Array
    errors: Array
    slope: Array
    widest: Array
    projected: Array
    sampled: Array
    marks: NDArray[np.int64]


@part()
def _rate(problem: Any, work: Any, t: float, into: int) -> None:
    """Rate of the state at ``t``; the input there is left in node 0."""
    work.times[0] = t
    fill(problem.tracks, problem.piece, work.times[:1], work.u[:, :1])
    call_native(problem.engine.rate, work.rows, STATE, work.u, problem.p, problem.m, work.rows, into)


@part(forceinline=True)
def _inputs(problem: Any, work: Any, t: float, h: float, first: int, last: int) -> None:
    """Inputs at the nodes ``first`` to ``last`` of a step."""
    for i in range(first, last):
        work.times[i] = t + work.nodes[i] * h
    fill(problem.tracks, problem.piece, work.times[first:last], work.u[:, first:last])


@part(forceinline=True)
def _step(problem: Any, work: Any, t: float, h: float) -> None:
    """One step from the state to the end row, with the rate there."""
    _inputs(problem, work, t, h, problem.engine.first, LAST_STAGE + 1)
    call_step(problem.engine.step, work.rows, work.u, problem.p, problem.m, work.g, h)


@part(forceinline=True)
def _error(problem: Any, work: Any, h: float) -> float:
    """Error of the controlled states relative to what is allowed (DOP853's blend of fifth and third order)."""
    work.step[0] = h
    call_native(problem.engine.error, work.rows, 0, work.u, work.step, work.widest, work.errors, 0)
    fifth, third = work.errors[0, 0], work.errors[0, 1]
    blend = fifth + 0.01 * third
    return 0.0 if blend == 0.0 else float(abs(h) * fifth / math.sqrt(blend * len(work.widest)))


@part(forceinline=True)
def _prepare_dense(problem: Any, work: Any, t: float, h: float) -> None:
    """Three more stages, the coefficients of the interpolant on this step and the inputs at the probes."""
    _inputs(problem, work, t, h, problem.engine.after, DENSE_STAGES + len(PROBES))
    call_step(problem.engine.dense, work.rows, work.u, problem.p, problem.m, work.g, h)


@part()
def _switch_at(problem: Any, work: Any, t: float, h: float, theta: float, i: int) -> float:
    """Switching function ``i`` at a fraction of the step."""
    work.times[0] = t + theta * h
    fill(problem.tracks, problem.piece, work.times[:1], work.u[:, :1])
    call_step(problem.engine.switch_at, work.rows, work.u, problem.p, problem.m, work.g, theta)
    return float(work.g[_LAST_PROBE, i])


@part(forceinline=True)
def _crossing(problem: Any, work: Any, band: Any, t: float, h: float, edge: bool) -> tuple[float, int]:
    """First fraction of the step at which a switch leaves its side, and which; (2, -1) when none does.

    On a step that starts at an ``edge`` of the input the fraction is -1 for a switch that the edge has thrown.
    """
    before, first, which = 0.0, 2.0, -1
    g, modes = work.g, problem.m
    call_step(problem.engine.probe, work.rows, work.u, problem.p, modes, g, 0.0)
    for probe in range(len(PROBES)):
        here = NODES[FIRST_PROBE + probe]
        for i in range(len(modes)):
            side = 1.0 if modes[i] > 0.5 else -1.0
            theta = 2.0
            if probe == 0:
                theta = -1.0 if edge and side * g[probe, i] < -band[i] else 2.0
            elif side * g[probe, i] < -band[i]:
                theta = _root(problem, work, t, h, i, before, here)
            elif probe > 1:
                touched = _dip(problem, work, t, h, i, side, band[i], probe)
                if touched > 0.0:
                    theta = _root(problem, work, t, h, i, before if touched > before else 2.0 * before - here, touched)
            if theta < first:
                first, which = theta, i
        if which >= 0:
            break
        before = here
    return first, which


@part()
def _dip(problem: Any, work: Any, t: float, h: float, i: int, side: float, band: float, probe: int) -> float:
    """Where switch ``i`` is on the wrong side between three probes that are all on the right one; -1 where it is not.

    Follows the vertices of parabolas, starting with the one through the probes.
    """
    width = NODES[FIRST_PROBE + 1] - NODES[FIRST_PROBE]
    middle = NODES[FIRST_PROBE + probe] - width
    low, mid, high = side * work.g[probe - 2, i], side * work.g[probe - 1, i], side * work.g[probe, i]
    for _ in range(_VERTICES):
        bend = low - 2.0 * mid + high
        if bend <= 0.0:
            return -1.0
        move = 0.5 * (low - high) / bend
        depth = mid - 0.125 * (low - high) * (low - high) / bend
        if abs(move) > 1.0 or depth > _NEAR * min(low, mid, high):
            return -1.0
        vertex = middle + move * width
        value = side * _switch_at(problem, work, t, h, vertex, i)
        if value < -band:
            return float(vertex)
        width *= 0.25
        middle = min(max(vertex, width), 1.0 - width)
        low = side * _switch_at(problem, work, t, h, middle - width, i)
        mid = side * _switch_at(problem, work, t, h, middle, i)
        high = side * _switch_at(problem, work, t, h, middle + width, i)
        if min(low, mid, high) < -band:
            return float(middle - width if low < -band else middle if mid < -band else middle + width)
    return -1.0


@part()
def _root(problem: Any, work: Any, t: float, h: float, i: int, low: float, high: float) -> float:
    """Locate the zero of switch ``i`` between two fractions of the step (Illinois variant of regula falsi).

    Where the low end is at rounding distance from an event just passed, a point beside it on the right side is found.
    """
    g_low = _switch_at(problem, work, t, h, low, i)
    g_high = _switch_at(problem, work, t, h, high, i)
    start = low
    for _ in range(_HALVINGS):
        if g_low * g_high < 0.0:
            break
        low = start + 0.25 * (high - start)
        g_low = _switch_at(problem, work, t, h, low, i)
        if g_low * g_high >= 0.0:
            high, g_high = low, g_low
    if g_low * g_high >= 0.0:
        return start
    for _ in range(60):
        theta = (low * g_high - high * g_low) / (g_high - g_low)
        g = _switch_at(problem, work, t, h, theta, i)
        if g == 0.0 or abs(high - low) < 1e-13 or abs(theta - high) < 1e-14:
            return float(theta)
        if g * g_high < 0.0:
            low, g_low = high, g_high
        else:
            g_low *= 0.5
        high, g_high = theta, g
    return high


@part()
def _flip(problem: Any, work: Any, t: float, which: int, thrown: bool) -> None:
    """Flip one mode at an event; the rate just after it is left in the first rate.

    An event thrown by an edge of the input has a fixed time: sensitivities do not jump there.
    """
    n, size = len(work.widest), work.rows.shape[1]
    jumps = size > n and not thrown
    if jumps:
        _rate(problem, work, t, RATES + 1)
        call_native(problem.engine.switch_slope, work.rows, STATE, work.u, problem.p, problem.m, work.slope, 0)
    problem.m[which] = 1.0 - problem.m[which]
    _rate(problem, work, t, RATES)
    if jumps:
        _jump_sensitivities(work.rows, work.slope, which, n, (size - n) // n)
        _rate(problem, work, t, RATES)


@part()
def _jump_sensitivities(rows: Any, slope: Any, which: int, n: int, columns: int) -> None:
    """Saltation: ``S+ = S- + (f+ - f-) (dg/dx S- + dg/dp) / (dg/dt)``, f- in the second rate and f+ in the first.

    ``slope`` holds for each switch its slopes along the states and time; then, for each, those along the sensitivities.
    """
    x, before, after = rows[STATE], rows[RATES + 1], rows[RATES]
    switches = slope.shape[1] // (n + 1 + columns)
    row = slope[0, which * (n + 1) : (which + 1) * (n + 1)]
    shift = slope[0, switches * (n + 1) + which * columns :]
    speed = row[n]
    for d in range(n):
        speed += row[d] * before[d]
    if abs(speed) < 1e-300:
        return
    for d in range(n):
        jump = (after[d] - before[d]) / speed
        for c in range(columns):
            x[n + d * columns + c] += jump * shift[c]


@part(forceinline=True)
def _attempt(
    problem: Any, control: Any, work: Any, t: float, h: float, dense: bool, edge: bool
) -> tuple[float, float, int]:
    """Try one step; give (share of it that holds, factor for the next step, switch that ends it or -1).

    A share of 0 with no switch means rejected; the dense output of an accepted step is prepared where wanted.
    """
    _step(problem, work, t, h)
    error = _error(problem, work, h)
    if not math.isfinite(error):
        return 0.0, 0.1, -1
    if error > 1.0:
        return 0.0, max(0.2, 0.9 * error**problem.engine.shrink), -1
    grow = min(5.0, 0.9 * (error + 1e-12) ** problem.engine.shrink)
    if dense or len(problem.m) > 0:
        _prepare_dense(problem, work, t, h)
    if len(problem.m) > 0:
        theta, which = _crossing(problem, work, control.dead_band, t, h, edge)
        if which >= 0:
            if 0.0 < theta < 1.0:
                _step(problem, work, t, theta * h)
                _prepare_dense(problem, work, t, theta * h)
            return theta, max(1.0 - theta, 0.1), which
    return 1.0, grow, -1


def _scratch(problem: Problem, control: Control) -> Work:
    n, size, switches = len(control.scale), len(problem.x0), len(problem.m)
    rows = np.zeros((ROWS, size))
    rows[STATE] = problem.x0
    return Work(
        rows,
        np.zeros(len(NODES)),
        NODES if problem.engine.first == 1 else SHORT_NODES,
        np.zeros((len(NODES), problem.inputs)).T,
        np.zeros((_LAST_PROBE + 1, switches)),
        np.array([0.0, control.tolerance]),
        np.zeros((1, 2)),
        np.zeros((1, switches * (n + size // n))),
        control.scale.copy(),
        np.zeros((1, size + 2)),
        np.zeros((problem.inputs, 1)),
        np.zeros(2, dtype=np.int64),
    )


@part()
def _project(problem: Any, work: Any, t: float) -> int:
    """Move the state onto the constraints and renew its rate; tell how that ended."""
    status = _close(problem, work, t)
    call_native(problem.engine.rate, work.rows, STATE, work.u, problem.p, problem.m, work.rows, RATES)
    return int(status)


@part(forceinline=True)
def _close(problem: Any, work: Any, t: float) -> int:
    """Move the state onto the constraints; tell how that ended."""
    size = work.rows.shape[1]
    work.times[0] = t
    fill(problem.tracks, problem.piece, work.times[:1], work.u[:, :1])
    for _ in range(_PROJECTIONS):
        call_native(problem.engine.project, work.rows, STATE, work.u, problem.p, problem.m, work.projected, 0)
        violation, conditioning = work.projected[0, 0], work.projected[0, 1]
        for d in range(size):
            work.rows[STATE, d] = work.projected[0, 2 + d]
        if violation < _CLOSED:
            return _COMPLETED if conditioning > _SINGULAR else _LOCKED_UP
    return _LOOP_OPENED


@part(forceinline=True)
def _accept(x0: Any, rows: Any, widest: Any) -> bool:
    """Take over the end of the step; tell whether it is finite."""
    for d in range(rows.shape[1]):
        rows[STATE, d] = rows[END, d]
        rows[RATES, d] = rows[_LAST_RATE, d]
    finite = True
    for d in range(len(widest)):
        finite = finite and math.isfinite(rows[STATE, d])
        widest[d] = max(widest[d], abs(rows[STATE, d] - x0[d]))
    return finite


@part(forceinline=True)
def _arrive(problem: Any, work: Any, t: float) -> int:
    """Take over the end of the step, on the constraints; tell how that ended."""
    if not _accept(problem.x0, work.rows, work.widest):
        return _NOT_FINITE
    return _project(problem, work, t) if problem.engine.project != 0 else _COMPLETED


@part(forceinline=True)
def _limit(control: Any, counts: Any, t: float, h: float) -> int:
    """Tell whether another step may be tried."""
    if counts[0] + counts[1] >= control.max_steps:
        return _TOO_MANY_STEPS
    return _STEP_TOO_SMALL if h < 1e-14 * max(1.0, abs(t)) else _COMPLETED


@part(inline="always")
def _renew(
    problem: Any, feedback: Any, work: Any, start: float, t: float, edge: float, instant: float, slack: float
) -> tuple[int, float, float]:
    """Go on to new inputs at an edge, to new commands at a control instant; give the next of both (no call: slow)."""
    status, following = _COMPLETED, instant
    if edge <= t + slack:
        edge = advance(problem.tracks, problem.piece, t, slack)
    if feedback.law == 0:
        following = np.inf
    elif instant <= t + slack:
        status = regulate(problem, feedback, work.rows, t)
        following = start + feedback.period * feedback.instants[0]
    _rate(problem, work, t, RATES)
    return int(status), edge, following


def integrate(
    problem: Problem, control: Control, out: Samples, counts: NDArray[np.int64], feedback: Feedback = NO_FEEDBACK
) -> int:
    """Integrate from the first to the last sample; fill the arrays at every sample; give a status code.

    At an input edge the samples are those just after it. ``counts`` gets steps, rejected steps and events. ``feedback``
    is a controller around the model.
    """
    return int(_integrate(problem, feedback, control, _scratch(problem, control), out, counts))


@compiled()
def _integrate(problem: Any, feedback: Any, control: Any, work: Any, out: Any, counts: Any) -> int:
    status = _walk(problem, feedback, control, work, out, counts)
    finish_samples(problem, work, out)
    return int(status)


@part()
def _walk(problem: Any, feedback: Any, control: Any, work: Any, out: Any, counts: Any) -> int:
    times = out.times
    t, end = times[0], times[-1]
    slack = 1e-12 * max(1.0, abs(end))
    edge = instant = t
    h, stalled = min(1e-3, end - t, control.longest), 0
    at_edge = True
    while t < end - slack:
        if min(edge, instant) <= t + slack:
            status, edge, instant = _renew(problem, feedback, work, times[0], t, edge, instant, slack)
            if status != _COMPLETED:
                return int(status)
        stop = min(edge, instant, end)
        tried = stop - t if stop - t < 1.1 * h else h
        limit = _limit(control, counts, t, tried)
        if limit != _COMPLETED:
            return int(limit)
        wanted = work.marks[0] < len(times) and times[work.marks[0]] < t + tried - slack
        share, factor, which = _attempt(problem, control, work, t, tried, wanted, at_edge)
        h = tried * factor if which >= 0 or share == 0.0 or factor < 1.0 else max(h, tried * factor)
        h = min(h, control.longest)
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
            place_samples(problem, work, t, share * tried, now - slack, out)
            t = now
            status, at_edge = _arrive(problem, work, t), min(edge, instant) <= t + slack
            if status != _COMPLETED:
                return int(status)
        if which >= 0:
            finish_samples(problem, work, out)
            _flip(problem, work, t, which, share < 0.0)
            counts[2] += 1
    advance(problem.tracks, problem.piece, t, slack)
    _place_last(problem, work, t, out)
    return _COMPLETED


@part(forceinline=True)
def _place_last(problem: Any, work: Any, t: float, out: Any) -> None:
    """Write the samples at the end of the run, where the state is."""
    for i in range(DENSE, ROWS):
        for d in range(work.rows.shape[1]):
            work.rows[i, d] = 0.0
    place_samples(problem, work, t, 1.0, np.inf, out)
