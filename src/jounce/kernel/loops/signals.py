"""Inputs and outputs of a run: inputs at given times, samples, commands of a controller.

Every track is a chain of closed-form pieces (lines and cubics, sines, circles). The loop stores the current piece and
advances it only at edges, so all stages of a step see the same smooth function, even if the step ends at an edge.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from jounce.kernel.engine import COMPLETED, DIVERGED, NO_COMMAND, STATE, TRIAL
from jounce.kernel.loops.compiling import call_many, call_native, call_step, part, sine_and_cosine

CLOSED = (
    1e-7  # residual of the constraints that one projection brings down to rounding: it is squared
)
PROJECTIONS = 4  # most of them in a row
_BLOCK = 256
"""Samples whose outputs are computed at once: enough for vectors of them, few enough to stay in the cache."""


@part()
def advance(tracks: Any, piece: Any, t: float, slack: float) -> float:
    """Advance ``piece`` to the pieces valid just after ``t``; return the next edge of any track."""
    edge = np.inf
    for k in range(len(piece)):
        last = tracks.first[k + 1] - 1
        while piece[k] < last and tracks.stop[piece[k]] <= t + slack:
            piece[k] += 1
        if piece[k] < last:
            edge = min(edge, tracks.stop[piece[k]])
    return edge


@part(forceinline=True)
def _fill_line(times: Any, start: float, height: float, slope: float, rows: Any) -> None:
    """Fill value, rate and acceleration of a line that begins at ``height``."""
    for j in range(len(times)):
        rows[0, j] = height + slope * (times[j] - start)
        rows[1, j] = slope
        if len(rows) > 2:
            rows[2, j] = 0.0


@part()
def fill(tracks: Any, piece: Any, times: Any, u: Any) -> None:
    """Fill a column of ``u`` for each time with (value, rate[, acceleration]) of every track, on the given pieces."""
    start, kind, coefficients, rates = tracks.start, tracks.kind, tracks.coefficients, tracks.rate
    order = u.shape[0] // max(len(piece), 1)
    for k in range(len(piece)):
        i, rate, value, slope = piece[k], rates[k], order * k, order * k + 1
        c0, c1, c2, c3 = (
            coefficients[i, 0],
            coefficients[i, 1],
            coefficients[i, 2],
            coefficients[i, 3],
        )
        # The cases stand outside the loops over times, which LLVM can then vectorise; most roads are lines, most loads
        # level.
        if kind[i] == 0 and c2 == 0.0 and c3 == 0.0:
            _fill_line(times, start[i], c0, rate * c1, u[value : value + order])
        elif kind[i] == 0:
            for j in range(len(times)):
                s = rate * (times[j] - start[i])
                u[value, j] = c0 + s * (c1 + s * (c2 + s * c3))
                u[slope, j] = rate * (c1 + s * (2.0 * c2 + 3.0 * s * c3))
                if order > 2:
                    u[slope + 1, j] = rate * rate * (2.0 * c2 + 6.0 * s * c3)
        elif kind[i] == 1:
            for j in range(len(times)):
                sine, cosine = sine_and_cosine(c2 * (rate * (times[j] - start[i])) + c3)
                u[value, j] = c0 + c1 * sine
                u[slope, j] = rate * c1 * c2 * cosine
                if order > 2:
                    u[slope + 1, j] = -rate * rate * c1 * c2 * c2 * sine
        else:
            for j in range(len(times)):
                s = rate * (times[j] - start[i]) - c2
                # Rounding can place an edge just outside the circle; there the slope is infinite and counts as none.
                root = math.sqrt(max(c1 * c1 - s * s, 0.0))
                u[value, j] = c0 + c3 * root
                u[slope, j] = -rate * c3 * s / root if root > 0.0 else 0.0
                if order > 2:
                    u[slope + 1, j] = -rate * rate * c3 * c1 * c1 / root**3 if root > 0.0 else 0.0


@part()
def fill_rates(tracks: Any, piece: Any, t: float, u: Any) -> None:
    """Fill ``u`` with the derivatives of what ``fill`` writes at ``t``: (rate, acceleration[, jerk]) of every track."""
    order = len(u) // max(len(piece), 1)
    for k in range(len(piece)):
        i, rate = piece[k], tracks.rate[k]
        c1, c2, c3 = tracks.coefficients[i, 1], tracks.coefficients[i, 2], tracks.coefficients[i, 3]
        s = rate * (t - tracks.start[i])
        first, second, third = 0.0, 0.0, 0.0
        if tracks.kind[i] == 0:
            first, second, third = (
                c1 + s * (2.0 * c2 + 3.0 * s * c3),
                2.0 * c2 + 6.0 * s * c3,
                6.0 * c3,
            )
        elif tracks.kind[i] == 1:
            sine, cosine = sine_and_cosine(c2 * s + c3)
            first, second, third = c1 * c2 * cosine, -c1 * c2 * c2 * sine, -c1 * c2**3 * cosine
        else:
            s -= c2
            root = math.sqrt(max(c1 * c1 - s * s, 0.0))
            if root > 0.0:
                first, second, third = (
                    -c3 * s / root,
                    -c3 * (c1 / root) ** 2 / root,
                    -3.0 * c3 * s * c1 * c1 / root**5,
                )
        u[order * k], u[order * k + 1] = rate * first, rate * rate * second
        if order > 2:
            u[order * k + 2] = rate**3 * third


@part(forceinline=True)
def _interpolate(
    problem: Any, work: Any, t: float, h: float, first: int, last: int, out: Any
) -> None:
    """Interpolate the states at the samples ``first`` to ``last`` on the step from ``t``."""
    for i in range(first, last):
        call_step(
            problem.engine.point_at,
            work.rows,
            work.u,
            problem.p,
            problem.m,
            work.g,
            (out.times[i] - t) / h,
        )
        for d in range(out.states.shape[0]):
            out.states[d, i] = work.rows[TRIAL, d]


@part()
def _project_samples(problem: Any, out: Any, first: int, last: int) -> None:
    """Project the samples ``first`` to ``last`` onto the constraints.

    Inside a step, samples may be too far from the constraints for one projection. The block is projected again until it
    converges.
    """
    address, count = problem.engine.project_many, last - first
    told = out.projected.shape[0] - out.states.shape[0]  # rows above those of the states
    for _ in range(PROJECTIONS):
        call_many(
            address, out.states, out.inputs, problem.p, problem.m, out.projected, first, count
        )
        widest = 0.0
        for i in range(first, last):
            for k in range(told // 2):
                widest = max(widest, out.projected[k, i])
            for d in range(out.states.shape[0]):
                out.states[d, i] = out.projected[told + d, i]
        if widest < CLOSED:
            return


@part()
def _carry_samples(
    problem: Any, work: Any, t: float, h: float, first: int, last: int, out: Any
) -> None:
    """Compute outputs at the samples ``first`` to ``last`` with the sensitivities of states and outputs."""
    n, rows = out.states.shape[0], work.rows
    for i in range(first, last):
        call_step(
            problem.engine.point_at,
            rows,
            work.u,
            problem.p,
            problem.m,
            work.g,
            (out.times[i] - t) / h,
        )
        for d in range(n):
            rows[TRIAL, d] = out.states[d, i]
        for d in range(n, rows.shape[1]):
            out.tangents[i, d - n] = rows[TRIAL, d]
        for k in range(out.inputs.shape[0]):
            work.sampled[k, 0] = out.inputs[k, i]
        call_native(
            problem.engine.output, rows, TRIAL, work.sampled, problem.p, problem.m, out.carried, i
        )
        for k in range(out.outputs.shape[0]):
            out.outputs[k, i] = out.carried[i, k]


@part()
def finish_samples(problem: Any, work: Any, out: Any) -> None:
    """Project the samples placed since the last call onto the constraints, and write their outputs.

    Many samples are processed at once, because native code handles several side by side. The modes must be those of the
    steps.
    """
    first, count = work.marks[1], work.marks[0] - work.marks[1]
    if count == 0:
        return
    work.marks[1] += count
    if problem.engine.project_many != 0:
        _project_samples(problem, out, first, first + count)
    if out.tangents.shape[1] == 0:
        call_many(
            problem.engine.output,
            out.states,
            out.inputs,
            problem.p,
            problem.m,
            out.outputs,
            first,
            count,
        )


@part(forceinline=True)
def place_samples(problem: Any, work: Any, t: float, h: float, until: float, out: Any) -> None:
    """Write states and inputs at all times before ``until`` on the step from ``t``; outputs follow block by block."""
    first = last = work.marks[0]
    while last < len(out.times) and out.times[last] < until:
        last += 1
    if last > first:
        fill(problem.tracks, problem.piece, out.times[first:last], out.inputs[:, first:last])
        _interpolate(problem, work, t, h, first, last, out)
        work.marks[0] = last
        if out.tangents.shape[1] > 0:
            # Sensitivities of outputs need those of the states, which only live on this step's interpolant.
            finish_samples(problem, work, out)
            _carry_samples(problem, work, t, h, first, last, out)
        elif last - work.marks[1] >= _BLOCK:
            finish_samples(problem, work, out)


@part()
def regulate(problem: Any, control: Any, rows: Any, t: float) -> int:
    """Measure at ``t``, call the law and set the commands; return the status."""
    for d in range(len(control.bound)):
        control.states[d, 0] = rows[STATE, d]
        # A loop that diverges does so for thousands of instants before numbers overflow: it is stopped when it is
        # clear.
        if abs(rows[STATE, d] - problem.x0[d]) > control.bound[d]:
            return DIVERGED
    control.time[0] = t
    fill(problem.tracks, problem.piece, control.time, control.inputs)
    call_many(
        problem.engine.output,
        control.states,
        control.inputs,
        problem.p,
        problem.m,
        control.outputs,
        0,
        1,
    )
    instant, count = control.instants[0], len(control.select)
    for j in range(count):
        control.measured[j] = control.outputs[control.select[j], 0] - control.offset[j]
    if instant < control.noise.shape[0]:
        for j in range(count):
            control.measured[j] += control.noise[instant, j]
    control.measured[count] = t
    call_native(
        control.law, control.memory, 0, control.measured, control.p, problem.m, control.result, 0
    )
    commands = len(control.pieces)
    for k in range(commands):
        if not math.isfinite(control.result[0, k]):
            return NO_COMMAND
        problem.tracks.coefficients[control.pieces[k], 0] = control.result[0, k]
    for k in range(control.memory.shape[1]):
        control.memory[0, k] = control.result[0, commands + k]
    control.instants[0] = instant + 1
    return COMPLETED
