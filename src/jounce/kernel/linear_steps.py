"""Steps of any length of a piecewise linear model: Taylor series between the edges of the input and the events.

Modes are held on each part of a step. Where a switching function leaves the side that its mode stands for, the part
ends at the located crossing, the mode flips, and the matrices of the new modes carry on. So also where an edge of the
input throws a switch over: that takes no time.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.kernel.call import call_many, call_native, part, sine_and_cosine
from jounce.kernel.explicit import Control, Problem
from jounce.kernel.propagators import PROBES, TERMS, Propagators, expand, find, powers_of, spread_derivatives, terms_for
from jounce.kernel.rows import add_rows
from jounce.kernel.sampling import Samples
from jounce.kernel.status import Status
from jounce.kernel.tracks import advance, fill

_CLOSE = 1e-19  # of a series' first terms, below which the rest counts for nothing
_HALVINGS, _VERTICES, _NEAR = 16, 3, 0.3
WATCHED = 0.5  # radians of the fastest motion between looks at the switches; the series converge well beyond
_COMPLETED, _NOT_FINITE = Status.COMPLETED.code, Status.NOT_FINITE.code
_TOO_MANY_STEPS, _CHATTER = Status.TOO_MANY_STEPS.code, Status.CHATTER.code


class Run(NamedTuple):
    """A run and where it stands.

    ``band`` is how far a switch may be on the wrong side between events; right after one, and at edges, it is the wider
    ``dead_band``, since times are rounded. ``x`` holds the state, ``trial`` one on the way; ``time`` and ``u`` an
    instant and the inputs there; ``part`` is (start, length) in s of the part of a step in work, with ``orders`` terms
    in its series. ``counts`` gets steps, rejected steps (none) and events; ``marks`` are: samples placed, those of them
    with outputs, events without time passing, parts of steps, and samples with an odd distance to the next passed.
    """

    problem: Problem
    control: Control
    props: Propagators
    out: Samples
    band: Array
    x: Array
    trial: Array
    time: Array
    u: Array
    part: Array
    orders: NDArray[np.int64]
    counts: NDArray[np.int64]
    marks: NDArray[np.int64]


@part()
def finish_outputs(run: Any) -> None:
    """Write the outputs of all samples placed since the last time; the modes must be theirs."""
    problem, out, placed, written = run.problem, run.out, run.marks[0], run.marks[1]
    if placed > written:
        address, count = problem.engine.output, placed - written
        call_many(address, out.states, out.inputs, problem.p, problem.m, out.outputs, written, count)
        run.marks[1] = placed


@part()
def longest_part(run: Any) -> float:
    """Longest part of a step (s) that one series covers and in which no switch escapes notice."""
    share = WATCHED if len(run.problem.m) > 0 else 1.0
    return float(share / run.props.pace[run.props.used[1]])


@part()
def step_to(run: Any, t: float, end: float, slack: float) -> int:
    """Take the state from ``t`` to ``end``, through all edges and events; give a status code."""
    problem, marks = run.problem, run.marks
    while True:
        edge = advance(problem.tracks, problem.piece, t, slack)
        status = _settle(run, t)
        if status != _COMPLETED or t >= end:
            return int(status)
        marks[3] += 1
        if marks[3] >= run.control.max_steps:
            return _TOO_MANY_STEPS
        stop = edge if edge < end - slack else end
        longest = longest_part(run)
        whole = not longest < stop - t
        length = stop - t if whole else longest
        if not length > 0.0:
            return _NOT_FINITE
        _expand(run, t, length)
        share, which = _crossing(run) if len(problem.m) > 0 else (2.0, -1)
        _state_at(run, length * min(share, 1.0))
        for d in range(run.x.shape[1]):
            run.x[0, d] = run.trial[0, d]
        run.counts[0] += 1
        if which < 0:
            marks[2] = 0
            t = stop if whole else t + length
            continue
        marks[2] = marks[2] + 1 if share * length <= 1e-3 * slack else 0
        t += share * length
        _flip(run, which)
        if marks[2] > 20 * len(problem.m):
            return _CHATTER


@part()
def _settle(run: Any, t: float) -> int:
    """Throw over the switches that lie on the wrong side now."""
    problem, marks = run.problem, run.marks
    if len(problem.m) == 0:
        return _COMPLETED
    while True:
        _switches_at(run, t, run.x, 0)
        which = -1
        for i in range(len(problem.m)):
            if which < 0 and _side(problem.m, i) * run.props.scratch.switches[0, i] < -run.control.dead_band[i]:
                which = i
        if which < 0:
            return _COMPLETED
        marks[2] += 1
        if marks[2] > 20 * len(problem.m):
            return _CHATTER
        _flip(run, which)


@part()
def _flip(run: Any, which: int) -> None:
    finish_outputs(run)
    run.problem.m[which] = 1.0 - run.problem.m[which]
    find(run.problem, run.props)
    run.counts[2] += 1


@part()
def _side(modes: Any, i: int) -> float:
    return 1.0 if modes[i] > 0.5 else -1.0


@part()
def _switches_at(run: Any, t: float, x: Any, row: int) -> None:
    """Switching functions at a time and a state, into a row."""
    problem = run.problem
    run.time[0] = t
    fill(problem.tracks, problem.piece, run.time, run.u)
    call_native(run.props.calls.switch, x, 0, run.u, problem.p, problem.m, run.props.scratch.switches, row)


@part()
def _expand(run: Any, t: float, length: float) -> None:
    """Series of the state over a part of a step."""
    problem, props = run.problem, run.props
    room = props.scratch
    run.part[0], run.part[1] = t, length
    current = props.used[1]
    terms = terms_for(length * props.pace[current], _CLOSE)
    driven = 0
    for k in range(props.layout.tracks):
        count = _derivatives(problem.tracks, problem.piece[k], problem.tracks.rate[k], t, room.derivatives)
        driven = max(driven, count)
        spread_derivatives(room, k, props.layout.order, terms)
    for d in range(run.x.shape[1]):
        room.series[0, d] = run.x[0, d]
    expand(props, props.matrix[current], 1.0, driven, terms, room.series, 0)
    run.orders[0] = terms


@part()
def _derivatives(tracks: Any, i: int, rate: float, t: float, to: Any) -> int:
    """Derivatives of a piece at a time; how many of them there are."""
    s = rate * (t - tracks.start[i])
    c0, c1, c2, c3 = (
        tracks.coefficients[i, 0],
        tracks.coefficients[i, 1],
        tracks.coefficients[i, 2],
        tracks.coefficients[i, 3],
    )
    for q in range(4, len(to)):
        to[q] = 0.0
    if tracks.kind[i] == 0:
        to[0], to[1] = c0 + s * (c1 + s * (c2 + s * c3)), rate * (c1 + s * (2.0 * c2 + 3.0 * s * c3))
        to[2], to[3] = rate * rate * (2.0 * c2 + 6.0 * s * c3), 6.0 * rate**3 * c3
        return 4 if c2 != 0.0 or c3 != 0.0 else 2
    w = rate * c2
    sine, cosine = sine_and_cosine(c2 * s + c3)
    to[0], to[1], to[2] = c0 + c1 * sine, c1 * w * cosine, -c1 * w * w * sine
    for q in range(3, len(to)):
        to[q] = -w * w * to[q - 2]
    return TERMS


@part()
def _state_at(run: Any, after: float) -> None:
    """State so long after the start of the part, into ``trial``."""
    room, terms = run.props.scratch, run.orders[0]
    powers_of(room.powers, 1.0, after, terms + 1)
    for d in range(run.trial.shape[1]):
        run.trial[0, d] = 0.0
    add_rows(run.props.loops.add, run.trial, 0, room.series, 0, room.powers, 0, terms + 1, 1)


@part()
def _look(run: Any, share: float, row: int) -> None:
    """Switching functions at a share of the part, into a row."""
    _state_at(run, share * run.part[1])
    _switches_at(run, run.part[0] + share * run.part[1], run.trial, row)


@part()
def _switch_at(run: Any, share: float, i: int) -> float:
    """One switching function at a share of the part."""
    _look(run, share, len(PROBES))
    return float(run.props.scratch.switches[len(PROBES), i])


@part()
def _crossing(run: Any) -> tuple[float, int]:
    """First share of the part at which a switch leaves its side, and which; (2, -1) when none does.

    The switching functions at its start are known.
    """
    g, band, modes = run.props.scratch.switches, run.band, run.problem.m
    before, first, which = 0.0, 2.0, -1
    for probe in range(1, len(PROBES)):
        here = PROBES[probe]
        _look(run, here, probe)
        for i in range(len(modes)):
            side, share = _side(modes, i), 2.0
            if side * g[probe, i] < -band[i]:
                share = _root(run, i, before, here)
            elif probe > 1:
                touched = _dip(run, i, side, band[i], probe)
                if touched > 0.0:
                    share = _root(run, i, before if touched > before else 2.0 * before - here, touched)
            if share < first:
                first, which = share, i
        if which >= 0:
            break
        before = here
    return first, which


@part()
def _dip(run: Any, i: int, side: float, band: float, probe: int) -> float:
    """Where switch ``i`` is on the wrong side between three probes that are all on the right one; -1 where it is not.

    Follows the vertices of parabolas, starting with the one through the probes.
    """
    g, width = run.props.scratch.switches, PROBES[1] - PROBES[0]
    middle = PROBES[probe] - width
    low, mid, high = side * g[probe - 2, i], side * g[probe - 1, i], side * g[probe, i]
    for _ in range(_VERTICES):
        bend = low - 2.0 * mid + high
        if bend <= 0.0:
            return -1.0
        move = 0.5 * (low - high) / bend
        depth = mid - 0.125 * (low - high) * (low - high) / bend
        if abs(move) > 1.0 or depth > _NEAR * min(low, mid, high):
            return -1.0
        vertex = middle + move * width
        if side * _switch_at(run, vertex, i) < -band:
            return float(vertex)
        width *= 0.25
        middle = min(max(vertex, width), 1.0 - width)
        low = side * _switch_at(run, middle - width, i)
        mid = side * _switch_at(run, middle, i)
        high = side * _switch_at(run, middle + width, i)
        if min(low, mid, high) < -band:
            return float(middle - width if low < -band else middle if mid < -band else middle + width)
    return -1.0


@part()
def _root(run: Any, i: int, low: float, high: float) -> float:
    """Locate the zero of switch ``i`` between two shares of the part (Illinois variant of regula falsi).

    Where the low end is at rounding distance from an event just passed, a point beside it on the right side is found.
    """
    g_low, g_high = _switch_at(run, low, i), _switch_at(run, high, i)
    start = low
    for _ in range(_HALVINGS):
        if g_low * g_high < 0.0:
            break
        low = start + 0.25 * (high - start)
        g_low = _switch_at(run, low, i)
        if g_low * g_high >= 0.0:
            high, g_high = low, g_low
    if g_low * g_high >= 0.0:
        return start
    for _ in range(60):
        share = (low * g_high - high * g_low) / (g_high - g_low)
        g = _switch_at(run, share, i)
        if g == 0.0 or abs(high - low) < 1e-13 or abs(share - high) < 1e-14:
            return float(share)
        if g * g_high < 0.0:
            low, g_low = high, g_high
        else:
            g_low *= 0.5
        high, g_high = share, g
    return high
