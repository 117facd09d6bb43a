"""Integration of a run with error control, shared by the explicit and implicit methods.

A method provides three functions, which are compiled into its loop (``way_through``):

- ``look(problem, method, work, t, changed)`` prepares a step from the current state; ``changed`` is true if the
  input or the modes have changed;
- ``step(problem, method, control, work, t, h)`` computes the step and returns the growth factor of the next one; if
  the error is too large, the factor is negative, and its magnitude applies to the repeated step;
- ``dense(problem, method, work, t, h)`` writes the interpolant of the last step into its rows, and the inputs at the
  probes.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from jounce.kernel.arrays import Integers
from jounce.kernel.engine import (
    CHATTER,
    COMPLETED,
    DENSE,
    END,
    LAST_STAGE,
    LOCKED_UP,
    LOOP_OPENED,
    NOT_FINITE,
    PROBES,
    RATES,
    ROWS,
    STATE,
    STEP_TOO_SMALL,
    TOO_MANY_STEPS,
    Control,
    Feedback,
    Problem,
    Samples,
    Work,
)
from jounce.kernel.loops.compiling import call_native, call_step, part
from jounce.kernel.loops.events import crossing, flip
from jounce.kernel.loops.signals import (
    CLOSED,
    PROJECTIONS,
    advance,
    fill,
    finish_samples,
    place_samples,
    regulate,
)

_LAST_RATE, _INTERVALS = RATES + LAST_STAGE, len(PROBES) - 1
_SINGULAR = 1e-10  # conditioning of the constraints at which a mechanism counts as locked up
_STALLED = 20  # events of each switch without time passing: more than any sequence of contacts that comes to an end


@part(forceinline=True)
def inputs(problem: Any, work: Any, t: float, h: float, first: int, last: int) -> None:
    """Evaluate the inputs at the nodes ``first`` to ``last`` of a step."""
    for i in range(first, last):
        work.times[i] = t + work.nodes[i] * h
    fill(problem.tracks, problem.piece, work.times[first:last], work.u[:, first:last])


@part(forceinline=True)
def _arrive(problem: Any, work: Any, t: float) -> int:
    """Accept the end of the step, projected onto the constraints; return the status."""
    rows, widest, finite = work.rows, work.widest, True
    for d in range(rows.shape[1]):
        rows[STATE, d] = rows[END, d]
        rows[RATES, d] = rows[_LAST_RATE, d]
    for d in range(len(widest)):
        finite = finite and math.isfinite(rows[STATE, d])
        # The error is relative to what a state has moved so far, which needs no guess of its size.
        widest[d] = max(widest[d], abs(rows[STATE, d] - problem.x0[d]))
    if not finite:
        return NOT_FINITE
    return _close(problem, work, t) if problem.engine.project != 0 else COMPLETED


@part(forceinline=True)
def _close(problem: Any, work: Any, t: float) -> int:
    """Project the state onto the constraints; return the status.

    The rates keep the second derivatives of the constraints at zero. Rounding and step errors accumulate as the
    square of time; they are removed after every step, while one projection is sufficient.
    """
    size = work.rows.shape[1]
    systems = (work.projected.shape[1] - size) // 2
    work.times[0] = t
    fill(problem.tracks, problem.piece, work.times[:1], work.u[:, :1])
    for _ in range(PROJECTIONS):
        call_native(
            problem.engine.project,
            work.rows,
            STATE,
            work.u,
            problem.p,
            problem.m,
            work.projected,
            0,
        )
        closed = sound = True  # comparisons that a residual without a number fails
        for k in range(systems):
            closed = closed and work.projected[0, k] < CLOSED
            sound = sound and work.projected[0, systems + k] > _SINGULAR
        for d in range(size):
            work.rows[STATE, d] = work.projected[0, 2 * systems + d]
        if closed:
            return COMPLETED if sound else LOCKED_UP
    return LOOP_OPENED


def way_through(look: Any, step: Any, dense: Any, kind: type) -> Any:
    """Create the loop of a method from its three functions; ``kind`` is the tuple type of its constants."""

    @part()
    def walk(
        method: Any, problem: Any, feedback: Any, control: Any, work: Any, out: Any, counts: Any
    ) -> int:
        """Integrate from the first sample to the last; return a status code.

        ``method.first`` is the initial step size (s); with ``method.waits``, a step does not grow right after a
        rejected one.
        """
        times = out.times
        t, end = times[0], times[-1]
        slack = 1e-12 * max(
            1.0, abs(end)
        )  # rounding of times: what is closer together is the same instant
        # The run begins with an edge and a control instant, so that pieces and commands are set there.
        edge = instant = t
        h, stalled = min(method.first, end - t, control.longest), 0
        at_edge = moved = changed = True
        rejected = False
        while t < end - slack:
            if min(edge, instant) <= t + slack:
                if edge <= t + slack:
                    edge = advance(problem.tracks, problem.piece, t, slack)
                if feedback.law == 0:
                    instant = np.inf
                elif instant <= t + slack:
                    status = regulate(problem, feedback, work.rows, t)
                    if status != COMPLETED:
                        return int(status)
                    # counted from the start: a sum of periods would drift away from the clock of the samples
                    instant = times[0] + feedback.period * feedback.instants[0]
                changed = True
            if moved or changed:
                look(problem, method, work, t, changed)
                moved = changed = False
            stop = min(edge, instant, end)
            tried = (
                stop - t if stop - t < 1.1 * h else h
            )  # a tenth more spares a tiny step behind a whole one
            if counts[0] + counts[1] >= control.max_steps:
                return TOO_MANY_STEPS
            if tried < 1e-14 * max(1.0, abs(t)):
                return STEP_TOO_SMALL
            factor = step(problem, method, control, work, t, tried)
            share, which = (1.0, -1) if factor > 0.0 else (0.0, -1)
            factor = abs(factor)
            if share > 0.0:
                switches = len(problem.m) > 0
                sampled = work.marks[0] < len(times) and times[work.marks[0]] < t + tried - slack
                if (
                    sampled or switches
                ):  # most steps between dense edges show no sample and need no interpolant
                    dense(problem, method, work, t, tried)
                if switches:
                    call_step(
                        problem.engine.probe, work.rows, work.u, problem.p, problem.m, work.g, 0.0
                    )
                    event, which = crossing(
                        problem, work, t, tried, work.g, control.dead_band, _INTERVALS, at_edge
                    )
                    if which >= 0:
                        # Behind the event what is left of the step is tried.
                        share, factor = event, max(1.0 - event, 0.1)
                        # The interpolant is less exact than a step, so there is one up to the event.
                        if 0.0 < share < 1.0:
                            step(problem, method, control, work, t, share * tried)
                            dense(problem, method, work, t, share * tried)
            # A step cut short by an edge says little of how long the next may be: h is kept, unless it has to shrink.
            if which >= 0 or share == 0.0 or factor < 1.0:
                h = tried * factor
            else:
                h = tried if method.waits and rejected else max(h, tried * factor)
            h = min(h, control.longest)
            rejected = share == 0.0 and which < 0
            if share * tried <= slack * 1e-3:
                if which < 0:
                    counts[1] += 1
                    if h < 1e-12 * max(
                        1.0, abs(t)
                    ):  # rates without a number shrink steps by ten, stiff ones by less
                        return NOT_FINITE if factor <= 0.1 else STEP_TOO_SMALL
                    continue
                # Several switches may flip at one instant (both wheels of an axle on one edge), but not for ever.
                stalled += 1
                if stalled > _STALLED * len(problem.m):
                    return CHATTER
                # A function that is near zero for long is on the side that the error of the interpolant says, and that
                # hangs on the modes: a shorter step has less of it.
                twice = stalled > len(problem.m) and stalled % len(problem.m) == 0
                h = 0.5 * tried if twice else tried
            else:
                stalled = 0
                counts[0] += 1
                now = t + share * tried
                now = stop if stop - now <= slack else now
                place_samples(problem, work, t, share * tried, now - slack, out)
                t = now
                status = _arrive(problem, work, t)
                if status != COMPLETED:
                    return int(status)
                moved, at_edge = True, min(edge, instant) <= t + slack
            if which >= 0:
                finish_samples(problem, work, out)  # outputs are those of the modes that still hold
                flip(problem, work, t, which, share < 0.0)
                counts[2] += 1
                changed = True
        advance(problem.tracks, problem.piece, t, slack)
        # The last sample is at the end of the last step, where the state is: an interpolant that stays there gives it.
        for i in range(DENSE, ROWS):
            for d in range(work.rows.shape[1]):
                work.rows[i, d] = 0.0
        place_samples(problem, work, t, 1.0, np.inf, out)
        return COMPLETED

    def integrate(
        problem: Problem,
        feedback: Feedback,
        method: Any,
        control: Control,
        work: Work,
        out: Samples,
        counts: Integers,
    ) -> int:
        """Integrate from the first sample to the last; return a status code."""
        status = walk(method, problem, feedback, control, work, out, counts)
        finish_samples(problem, work, out)
        return int(status)

    integrate.__annotations__["method"] = kind
    return part()(integrate)
