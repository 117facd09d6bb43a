"""The way through a run by steps whose error is controlled, the same for explicit and implicit methods.

A method brings three functions, which are compiled into its loop (``way_through``):

- ``look(problem, method, work, t, changed)`` prepares a step from the state, which has moved; where the input or the
  laws are others than before, ``changed`` says so;
- ``step(problem, method, control, work, t, h)`` takes it and gives the factor by which the next may be longer, negative
  where the error is too large: then its size is the factor for another try;
- ``dense(problem, method, work, t, h)`` puts the interpolant of the step just taken into its rows, and the inputs at
  the probes.
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
    """Inputs at the nodes ``first`` to ``last`` of a step."""
    for i in range(first, last):
        work.times[i] = t + work.nodes[i] * h
    fill(problem.tracks, problem.piece, work.times[first:last], work.u[:, first:last])


@part(forceinline=True)
def _arrive(problem: Any, work: Any, t: float) -> int:
    """Take over the end of the step, on the constraints; tell how that ended."""
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
    """Move the state onto the constraints; tell how that ended.

    The rates keep the constraints' second derivatives at zero; what rounding and steps add up to drifts like time
    squared and is taken out after every step, while it is still so small that one projection is enough.
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
    """Make the loop of a method from its three functions; ``kind`` is the tuple that says how it goes its way."""

    @part()
    def walk(
        method: Any, problem: Any, feedback: Any, control: Any, work: Any, out: Any, counts: Any
    ) -> int:
        """Go from the first sample to the last; give a status code.

        ``method.first`` is the first step to try (s); where ``method.waits``, no step grows right after a rejected one.
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
        """Go from the first sample to the last; give a status code."""
        status = walk(method, problem, feedback, control, work, out, counts)
        finish_samples(problem, work, out)
        return int(status)

    integrate.__annotations__["method"] = kind
    return part()(integrate)
