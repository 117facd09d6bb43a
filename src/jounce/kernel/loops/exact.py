"""Exact propagation, block by block and by steps of any length (see ``methods.exact``)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from jounce.kernel.engine import CHATTER, COMPLETED, NOT_FINITE, TOO_MANY_STEPS, Problem
from jounce.kernel.loops.compiling import call_many, call_native, part, sine_and_cosine
from jounce.kernel.loops.events import locator
from jounce.kernel.loops.propagators import (
    expand,
    find,
    powers_of,
    rate_bound,
    read_slopes,
    spread_derivatives,
    terms_for,
)
from jounce.kernel.loops.rows import add_rows, march, set_rows
from jounce.kernel.loops.signals import advance, fill, finish_samples
from jounce.kernel.methods.exact import BLOCK, WATCHED, Work
from jounce.kernel.methods.propagators import PROBES, TERMS, Propagators

_FIRST_BLOCK = 12
"""Steps in the block after an event: the next one often follows soon, and what is behind it is computed in vain."""
_CLOSE = 1e-19  # of a series' first terms, below which the rest counts for nothing
_STALLED = 20  # events of each switch without time passing: more than any sequence of contacts that comes to an end
_INTERVALS = len(PROBES) - 1


@part()
def bound_rates(problem: Problem, props: Propagators) -> None:
    """Write a bound of the rates (rad/s or 1/s) in the current modes into the first propagator."""
    read_slopes(problem, props, props.matrix[0])
    props.fastest[0] = rate_bound(props, props.matrix[0])


@part()
def propagate(work: Work) -> int:
    """Propagate from the first sample to the last; return a status code."""
    run, blocks, times = work.run, work.blocks, work.run.out.times
    problem, marks = run.problem, run.marks
    slack, sub = blocks.slack, 0
    switches = len(problem.m)
    run.time[0] = times[0]
    advance(problem.tracks, problem.piece, times[0], slack)
    fill(problem.tracks, problem.piece, run.time, run.props.scratch.base)
    find(problem, run.props)
    status = step_to(run, times[0], times[0], slack)
    _place(run, times[0])
    size = _FIRST_BLOCK if switches > 0 else BLOCK
    while status == COMPLETED and marks[0] < len(times):
        # ``sub`` counts the steps since the last sample. First a block of steps is tried; what it cannot do (odd
        # distances, modes too fast for its steps, edges without a series) is done by a single step of any length.
        events, passed, laid = run.counts[2], 0, _clock(work, marks[0] - 1, sub, size)
        if laid > 0 and (switches == 0 or run.props.step <= 1.000001 * _longest_part(run)):
            advance(problem.tracks, problem.piece, blocks.clock[0], slack)
            nodes = _lay_out(work, laid)
            # With switches a block of one step is no gain: to judge its bend takes a neighbour.
            if nodes > (1 if switches > 0 else 0):
                passed, status = _block(work, nodes, sub)
            if (
                passed == laid
            ):  # the pieces at its end are known; after an event ``step_to`` has moved them on
                for track in range(len(problem.piece)):
                    problem.piece[track] = blocks.reached[track]
        if passed == 0:
            start, end = _next_step(work, marks[0] - 1, sub)
            status = step_to(run, start, end, slack)
            passed = blocks.parts if end == times[marks[0]] and sub == 0 else 1
            if end == times[marks[0]]:
                _place(run, end)
        sub = (sub + passed) % blocks.parts
        if (
            marks[0] - marks[1] >= BLOCK
        ):  # many at once, since native code takes several side by side
            finish_samples(problem, run, run.out)
        size = _FIRST_BLOCK if run.counts[2] > events else min(2 * size, BLOCK)
    finish_samples(problem, run, run.out)
    return int(status)


@part()
def _place(run: Any, t: float) -> None:
    """Write the state at the next sample, and the inputs there."""
    problem, out, sample = run.problem, run.out, run.marks[0]
    run.time[0] = t
    fill(problem.tracks, problem.piece, run.time, out.inputs[:, sample : sample + 1])
    for d in range(out.states.shape[0]):
        out.states[d, sample] = run.x[0, d]
    run.marks[0] += 1


@part(forceinline=True)
def _regular(work: Any, sample: int) -> int:
    """Return the number of consecutive sample intervals that equal the interval of the steps."""
    odd, marks = work.blocks.odd, work.run.marks
    while odd[marks[4]] < sample:
        marks[4] += 1
    return int(odd[marks[4]] - sample)


@part(forceinline=True)
def _next_step(work: Any, sample: int, sub: int) -> tuple[float, float]:
    """Return start and end of the next single step: up to the next sample if the regular steps do not fit."""
    times, parts, step = work.run.out.times, work.blocks.parts, work.run.props.step
    if _regular(work, sample) == 0:
        return times[sample], times[sample + 1]
    start = times[sample] + sub * step
    return start, times[sample + 1] if sub == parts - 1 else start + step


@part(forceinline=True)
def _clock(work: Any, sample: int, sub: int, size: int) -> int:
    """Set the times of up to ``size`` steps; return their number."""
    times, clock, parts, step = (
        work.run.out.times,
        work.blocks.clock,
        work.blocks.parts,
        work.run.props.step,
    )
    nodes = int(min(size, _regular(work, sample) * parts - sub))
    if parts == 1:
        _copy(times[sample:], 1, clock[: nodes + 1])
        return nodes
    for node in range(nodes + 1):
        clock[node] = times[sample] + sub * step
        sub += 1
        if sub == parts:
            sample, sub = sample + 1, 0
    return nodes


@part(forceinline=True)
def _lay_out(work: Any, nodes: int) -> int:
    """Tabulate the inputs of each of ``nodes`` steps; return the number of steps for which the table is valid.

    The block ends before a step in which a sine begins or ends, or in which jumps have no series.
    """
    run, blocks = work.run, work.blocks
    lay, rows = run.props.layout, blocks.rows
    for d in range(rows.shape[1]):
        rows[0, d] = run.x[0, d]
    set_rows(run.props.loops.set, rows, 1, run.props.matrix[run.props.used[1]], lay.drift, nodes)
    for row in range(
        len(blocks.most) if len(run.problem.m) > 0 else 0
    ):  # only switches ask what edges do inside steps
        blocks.most[row], blocks.most_thrown[row], jumps, thrown = (
            0.0,
            0.0,
            blocks.jumps[row],
            blocks.thrown[row],
        )
        for node in range(nodes + 1):
            jumps[node], thrown[node] = 0.0, 0.0
    for track in range(lay.tracks):
        nodes = _lay_track(work, track, nodes)
    return nodes


@part(forceinline=True)
def _lay_track(work: Any, track: int, nodes: int) -> int:
    """Do the same for one track."""
    run, blocks = work.run, work.blocks
    lay, tracks, cell, clock = run.props.layout, run.problem.tracks, run.props.used[1], blocks.clock
    matrix, terms, slack, c = (
        run.props.matrix[cell],
        run.props.terms[cell],
        blocks.slack,
        tracks.coefficients,
    )
    i, last, rate, row = (
        run.problem.piece[track],
        tracks.first[track + 1] - 1,
        tracks.rate[track],
        track * lay.signals,
    )
    value, slope, higher = (
        blocks.signals[row],
        blocks.signals[row + 1],
        blocks.signals[row + 2 : row + lay.signals],
    )
    stop, start = tracks.stop[i] if i < last else np.inf, tracks.start[i]
    straight, watched = lay.signals == 2, len(run.problem.m) > 0
    c0, c1 = c[i, 0], rate * c[i, 1]
    for node in range(nodes + 1):
        while clock[node] + slack >= stop:
            left = clock[node] - stop
            # Behind an edge on a node the next step begins with the new piece, but just before it switches may have
            # been on their other side. Inside a step the old piece is carried on over the edge, and what the jump of
            # its signals does in the time left is added.
            if left <= slack:
                if watched and node > 0:
                    if straight:
                        _throw(blocks, row, node, c[i + 1, 0] - (c0 + (stop - start) * c1))
                        _throw(blocks, row + 1, node, rate * c[i + 1, 1] - c1)
                    else:
                        _throw_on_node(work, track, i, node)
            else:
                if terms == 0 or tracks.kind[i] == 1 or tracks.kind[i + 1] == 1:
                    return node - 1
                _add_edge(work, track, i, node, left)
            i += 1
            stop, start = tracks.stop[i] if i < last else np.inf, tracks.start[i]
            c0, c1 = c[i, 0], rate * c[i, 1]
        if straight:
            value[node], slope[node] = c0 + (clock[node] - start) * c1, c1
        else:
            _signals_at(tracks, i, rate, rate * (clock[node] - start), node, value, slope, higher)
        if lay.waves > 1 and node < nodes:
            forcing, stride = (
                lay.forcing + (blocks.wave[i] * lay.tracks + track) * lay.signals,
                blocks.signals.shape[1],
            )
            add_rows(
                run.props.loops.add,
                blocks.rows,
                node + 1,
                matrix,
                forcing,
                blocks.signals,
                row * stride + node,
                lay.signals,
                stride,
            )
    blocks.reached[track] = i
    return nodes


@part(forceinline=True)
def _signals_at(
    tracks: Any, i: int, rate: float, s: float, node: int, value: Any, slope: Any, higher: Any
) -> None:
    """Evaluate value and derivatives of a piece at a node."""
    c0, c1 = tracks.coefficients[i, 0], tracks.coefficients[i, 1]
    c2, c3 = tracks.coefficients[i, 2], tracks.coefficients[i, 3]
    second, third = rate * rate * (2.0 * c2 + 6.0 * s * c3), 6.0 * rate**3 * c3
    if tracks.kind[i] == 0:
        value[node] = c0 + s * (c1 + s * (c2 + s * c3))
        slope[node] = rate * (c1 + s * (2.0 * c2 + 3.0 * s * c3))
    else:
        sine, cosine = sine_and_cosine(c2 * s + c3)
        value[node], slope[node] = c0 + c1 * sine, rate * c1 * c2 * cosine
        second, third = -((rate * c2) ** 2) * c1 * sine, 0.0
    for j in range(higher.shape[0]):
        higher[j, node] = second if j == 0 else third


@part(forceinline=True)
def _add_edge(work: Any, track: int, i: int, node: int, left: float) -> None:
    """Add the effect of a track's signal jumps after piece ``i`` on the state at ``node``, ``left`` s later."""
    run, blocks, tracks = work.run, work.blocks, work.run.problem.tracks
    lay, powers, cell = run.props.layout, run.props.scratch.powers, run.props.used[1]
    terms, matrix = run.props.terms[cell], run.props.matrix[cell]
    for j in range(lay.signals):
        jump = _jump(tracks, track, i, j)
        row = track * lay.signals + j
        blocks.jumps[row, node] += abs(jump)
        blocks.most[row] = max(blocks.most[row], blocks.jumps[row, node])
        if jump != 0.0:
            powers_of(powers, jump, left, terms + 1)
            add_rows(
                run.props.loops.add,
                blocks.rows,
                node,
                matrix,
                lay.series + row * TERMS + 1,
                powers,
                1,
                terms,
                1,
            )


@part()
def _jump(tracks: Any, track: int, i: int, j: int) -> float:
    """Return the jump of signal ``j`` of a track from its polynomial ``i`` to the next."""
    c, rate, stop = tracks.coefficients, tracks.rate[track], tracks.stop[i]
    s = rate * (stop - tracks.start[i])
    if j == 0:
        old = c[i, 0] + s * (c[i, 1] + s * (c[i, 2] + s * c[i, 3]))
        # Pieces that join differ by rounding of their values and of the edge's time, which is no jump.
        jump = c[i + 1, 0] - old
        rounding = 1e-15 * (
            abs(old) + max(1.0, abs(stop)) * abs(rate) * (abs(c[i, 1]) + abs(c[i + 1, 1]))
        )
        return jump if abs(jump) > rounding else 0.0
    if j == 1:
        return float(rate * (c[i + 1, 1] - (c[i, 1] + s * (2.0 * c[i, 2] + 3.0 * s * c[i, 3]))))
    if j == 2:
        return float(rate * rate * (2.0 * c[i + 1, 2] - (2.0 * c[i, 2] + 6.0 * s * c[i, 3])))
    return float(6.0 * rate**3 * (c[i + 1, 3] - c[i, 3]))


@part(forceinline=True)
def _throw(blocks: Any, row: int, node: int, jump: float) -> None:
    blocks.thrown[row, node] += abs(jump)
    blocks.most_thrown[row] = max(blocks.most_thrown[row], blocks.thrown[row, node])


@part()
def _throw_on_node(work: Any, track: int, i: int, node: int) -> None:
    """Record the jumps of a track from piece ``i`` to the next at the node itself."""
    blocks, tracks, found, lay = (
        work.blocks,
        work.run.problem.tracks,
        work.run.props.scratch.powers,
        work.run.props.layout,
    )
    for piece, way in ((i, -1.0), (i + 1, 1.0)):
        _derivatives(
            tracks, piece, tracks.rate[track], tracks.stop[i], work.run.props.scratch.derivatives
        )
        for j in range(lay.order):
            found[j] = way * work.run.props.scratch.derivatives[j] + (
                found[j] if way > 0.0 else 0.0
            )
    for j in range(lay.order):
        _throw(blocks, track * lay.signals + j, node, found[j])


@part(forceinline=True)
def _block(work: Any, nodes: int, sub: int) -> tuple[int, int]:
    """Compute the tabulated steps up to an event; return the number of steps and a status code."""
    run, blocks = work.run, work.blocks
    problem, lay = run.problem, run.props.layout
    matrix = run.props.matrix[run.props.used[1]]
    forced = lay.tracks * lay.signals if lay.waves == 1 else 0
    for d in range(lay.states):
        blocks.x[d, 0] = blocks.rows[0, d]
    march(
        run.props.loops.march,
        blocks.rows,
        nodes,
        matrix,
        lay.forcing,
        forced,
        blocks.signals,
        blocks.x,
    )
    finite = True
    for d in range(lay.states):
        finite = finite and math.isfinite(blocks.x[d, nodes])
    sample = run.marks[0] - 1
    if len(problem.m) == 0 or not finite:
        _write(work, sample, sub, 1, nodes)
        run.counts[0] += nodes
        for d in range(lay.states):
            run.x[0, d] = blocks.x[d, nodes]
        return nodes, COMPLETED if finite else NOT_FINITE
    _look_at_block(work, nodes)
    # Between the steps taken as they are, suspects are done in parts. A suspect without an event ends where the block
    # has it (but for rounding), so the block goes on behind it.
    at = 0
    while True:
        suspect = _suspect(work, at, nodes)
        if suspect > at:
            _write(work, sample, sub, at + 1, suspect)
            run.counts[0] += suspect - at
            run.marks[2] = 0
        for d in range(lay.states):
            run.x[0, d] = blocks.x[d, suspect]
        if suspect == nodes:
            return nodes, COMPLETED
        advance(problem.tracks, problem.piece, blocks.clock[suspect], blocks.slack)
        events, at = run.counts[2], suspect + 1
        status = step_to(run, blocks.clock[suspect], blocks.clock[at], blocks.slack)
        if status != COMPLETED or run.counts[2] > events:
            if status == COMPLETED and (sub + at) % blocks.parts == 0:
                _place(run, blocks.clock[at])
            return at, int(status)
        _write(work, sample, sub, at, at)


@part(forceinline=True)
def _look_at_block(work: Any, nodes: int) -> None:
    """Evaluate the switching functions at all nodes."""
    run, blocks, problem = work.run, work.blocks, work.run.problem
    lay, address = run.props.layout, run.props.calls.switch_many
    if lay.signals == lay.order:
        call_many(address, blocks.x, blocks.signals, problem.p, problem.m, blocks.g, 0, nodes + 1)
        return
    for track in range(lay.tracks):
        for i in range(lay.order):
            for k in range(nodes + 1):
                blocks.u[track * lay.order + i, k] = blocks.signals[track * lay.signals + i, k]
    call_many(address, blocks.x, blocks.u, problem.p, problem.m, blocks.g, 0, nodes + 1)


@part(forceinline=True)
def _suspect(work: Any, first: int, nodes: int) -> int:
    """Return the first step in or at the end of which a switch may leave its side; ``nodes`` if there is none.

    Inside a step, a switching function deviates from its chord by the effect of input edges and by its curvature.
    """
    run, blocks = work.run, work.blocks
    g, band, modes, found = blocks.g, run.band, run.problem.m, nodes
    kick, throw = run.props.kick[run.props.used[1]], run.props.throw[run.props.used[1]]
    for i in range(len(modes)):
        side, room = 1.0 if modes[i] > 0.5 else -1.0, -band[i]
        for row in range(kick.shape[0]):
            room += blocks.most[row] * kick[row, i] + blocks.most_thrown[row] * throw[row, i]
        # Most switches are far from their sides all through a block: one bound for all its steps says so.
        lowest, bend = _extremes(g[i], side, nodes)
        if lowest >= room + 0.5 * bend:
            continue
        for k in range(first, found):
            room, thrown = -band[i], 0.0
            for row in range(kick.shape[0]):
                room += blocks.jumps[row, k + 1] * kick[row, i]
                thrown += blocks.thrown[row, k + 1] * throw[row, i]
            # Second differences on both sides of the step stand for the curvature inside; at the block's ends, where
            # there is only one, it counts twice. A parabola lies off its chord by an eighth of it; a quarter is to be
            # safe.
            here, there = side * g[i, k], side * g[i, k + 1]
            bend = abs(here - 2.0 * there + side * g[i, k + 2]) if k + 2 <= nodes else 0.0
            if k > 0:
                before = abs(side * g[i, k - 1] - 2.0 * here + there)
                bend = bend + before if k + 2 <= nodes else 2.0 * before
            elif k + 2 <= nodes:
                bend *= 2.0
            if there < -band[i] or min(here, there - thrown) < room + 0.25 * bend:
                found = k
                break
    return found


@part(fastmath={"nnan", "nsz"})
def _extremes(g: Any, side: float, nodes: int) -> tuple[float, float]:
    """Return the lowest value and the largest curvature of a switching function, as seen from its side."""
    lowest, bend = min(side * g[0], side * g[nodes]), 0.0
    for k in range(1, nodes):
        lowest = min(lowest, side * g[k])
        bend = max(bend, abs(g[k - 1] - 2.0 * g[k] + g[k + 1]))
    return lowest, bend


@part()
def _write(work: Any, sample: int, sub: int, first: int, last: int) -> None:
    """Write the samples among the nodes ``first`` to ``last``; the block begins ``sub`` steps after ``sample``."""
    run, blocks = work.run, work.blocks
    out, lay, parts = run.out, run.props.layout, blocks.parts
    begin = -((sub + first) // -parts) * parts - sub  # the first node that is a sample
    at = sample + (begin + sub) // parts
    count = (last - begin) // parts + 1 if begin <= last else 0
    for d in range(lay.states):
        _copy(blocks.x[d, begin:], parts, out.states[d, at : at + count])
    for track in range(lay.tracks):
        for i in range(lay.order):
            _copy(
                blocks.signals[track * lay.signals + i, begin:],
                parts,
                out.inputs[track * lay.order + i, at : at + count],
            )
    run.marks[0] += count


@part()
def _copy(source: Any, stride: int, to: Any) -> None:
    if stride == 1:
        for k in range(len(to)):
            to[k] = source[k]
    else:
        for k in range(len(to)):
            to[k] = source[k * stride]


@part()
def _longest_part(run: Any) -> float:
    """Return the longest part of a step (s) that one series covers without missing a switch."""
    share = WATCHED if len(run.problem.m) > 0 else 1.0
    return float(share / run.props.fastest[run.props.used[1]])


@part()
def step_to(run: Any, t: float, end: float, slack: float) -> int:
    """Propagate the state from ``t`` to ``end`` through all edges and events; return a status code."""
    problem, marks = run.problem, run.marks
    while True:
        edge = advance(problem.tracks, problem.piece, t, slack)
        status = _settle(run, t)
        if status != COMPLETED or t >= end:
            return int(status)
        marks[3] += 1
        if marks[3] >= run.control.max_steps:
            return TOO_MANY_STEPS
        # A part ends at the next edge and is no longer than one series converges over, or than no dip escapes the
        # probes.
        stop = edge if edge < end - slack else end
        longest = _longest_part(run)
        whole = not longest < stop - t
        length = stop - t if whole else longest
        if not length > 0.0:
            return NOT_FINITE
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
        marks[2] = (
            marks[2] + 1 if share * length <= 1e-3 * slack else 0
        )  # events without time passing
        t += share * length
        _flip(run, which)
        if marks[2] > _STALLED * len(problem.m):
            return CHATTER


@part()
def _settle(run: Any, t: float) -> int:
    """Flip the switches that are on the wrong side now."""
    problem, marks = run.problem, run.marks
    if len(problem.m) == 0:
        return COMPLETED
    while True:
        _switches_at(run, t, run.x, 0)
        which = -1
        for i in range(len(problem.m)):
            side = 1.0 if problem.m[i] > 0.5 else -1.0
            if which < 0 and side * run.props.scratch.switches[0, i] < -run.control.dead_band[i]:
                which = i
        if which < 0:
            return COMPLETED
        marks[2] += 1
        if marks[2] > _STALLED * len(problem.m):
            return CHATTER
        _flip(run, which)


@part()
def _flip(run: Any, which: int) -> None:
    finish_samples(run.problem, run, run.out)  # outputs are those of the modes that still hold
    run.problem.m[which] = 1.0 - run.problem.m[which]
    find(run.problem, run.props)
    run.counts[2] += 1


@part()
def _switches_at(run: Any, t: float, x: Any, row: int) -> None:
    """Evaluate the switching functions at a time and a state into a row."""
    problem = run.problem
    run.time[0] = t
    fill(problem.tracks, problem.piece, run.time, run.u)
    call_native(
        run.props.calls.switch, x, 0, run.u, problem.p, problem.m, run.props.scratch.switches, row
    )


@part()
def _expand(run: Any, t: float, length: float) -> None:
    """Compute the series of the state over a part of a step."""
    problem, props = run.problem, run.props
    room = props.scratch
    run.part[0], run.part[1] = t, length
    current = props.used[1]
    terms = terms_for(length * props.fastest[current], _CLOSE)
    driven = 0
    for k in range(props.layout.tracks):
        count = _derivatives(
            problem.tracks, problem.piece[k], problem.tracks.rate[k], t, room.derivatives
        )
        driven = max(driven, count)
        spread_derivatives(room, k, props.layout.order, terms)
    for d in range(run.x.shape[1]):
        room.series[0, d] = run.x[0, d]
    expand(props, props.matrix[current], 1.0, driven, terms, room.series, 0)
    run.orders[0] = terms


@part()
def _derivatives(tracks: Any, i: int, rate: float, t: float, to: Any) -> int:
    """Compute the derivatives of a piece at a time; return their number."""
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
        to[0], to[1] = (
            c0 + s * (c1 + s * (c2 + s * c3)),
            rate * (c1 + s * (2.0 * c2 + 3.0 * s * c3)),
        )
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
    """Compute the state at a time after the start of the part into ``trial``."""
    room, terms = run.props.scratch, run.orders[0]
    powers_of(room.powers, 1.0, after, terms + 1)
    for d in range(run.trial.shape[1]):
        run.trial[0, d] = 0.0
    add_rows(run.props.loops.add, run.trial, 0, room.series, 0, room.powers, 0, terms + 1, 1)


@part()
def _look(run: Any, share: float, row: int) -> None:
    """Evaluate the switching functions at a fraction of the part into a row."""
    _state_at(run, share * run.part[1])
    _switches_at(run, run.part[0] + share * run.part[1], run.trial, row)


@part()
def _switch_at(problem: Any, run: Any, t: float, length: float, share: float, i: int) -> float:
    """Evaluate one switching function at a fraction of the part."""
    _look(run, share, len(PROBES))
    return float(run.props.scratch.switches[len(PROBES), i])


_locate = locator(_switch_at)


@part()
def _crossing(run: Any) -> tuple[float, int]:
    """Return the first fraction of the part at which a switch leaves its side, and the switch; (2, -1) if none does.

    The switching functions at its start are known: ``_settle`` has just evaluated them.
    """
    g = run.props.scratch.switches
    for probe in range(1, _INTERVALS + 1):
        _look(run, PROBES[probe], probe)
    at, length = run.part[0], run.part[1]
    share, which = _locate(run.problem, run, at, length, g, run.band, _INTERVALS, False)
    return share, which
