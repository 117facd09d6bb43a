"""Exact propagation of piecewise linear models: no step-size error, whatever the step.

Between samples the state moves by matrices of the modes it is in (``propagators``). Edges of the input inside a step
add what their jumps of signals do until its end. Blocks of such steps are computed with the modes held, then the
switching functions are looked at in all of them; a step in which one may leave its side is done once more, in parts
(``linear_steps``), and where it does, the steps behind it are dropped.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.kernel.call import call_many, compiled, part, sine_and_cosine
from jounce.kernel.explicit import Control, Problem
from jounce.kernel.linear_plan import BLOCK, Blocks, Plan
from jounce.kernel.linear_steps import Run, finish_outputs, longest_part, step_to
from jounce.kernel.propagators import TERMS, find, powers_of
from jounce.kernel.rows import add_rows, march, set_rows
from jounce.kernel.sampling import Samples
from jounce.kernel.status import Status
from jounce.kernel.tracks import advance, fill

_FIRST_BLOCK = 12
"""Steps in the block after an event."""
_BAND = 1e-2  # share of the dead band of adaptive steps, whose errors are larger
_COMPLETED, _NOT_FINITE = Status.COMPLETED.code, Status.NOT_FINITE.code


class Work(NamedTuple):
    """A run and its blocks, for the loops."""

    run: Run
    blocks: Blocks


def propagate(problem: Problem, control: Control, plan: Plan, out: Samples, counts: NDArray[np.int64]) -> int:
    """Fill the arrays at every sample; give a status code.

    At an input edge the samples are those just after it. ``counts`` gets steps, rejected steps (none) and events.
    """
    width, inputs = plan.blocks.rows.shape[1], problem.inputs
    run = Run(
        problem,
        control,
        plan.props,
        out,
        band=_BAND * control.dead_band + 1e-14,
        x=np.zeros((1, width)),
        trial=np.zeros((1, width)),
        time=np.zeros(1),
        u=np.zeros((inputs, 1)),
        part=np.zeros(2),
        orders=np.zeros(1, dtype=np.int64),
        counts=counts,
        marks=np.zeros(5, dtype=np.int64),
    )
    run.x[0, : len(control.scale)] = problem.x0
    return int(_propagate(Work(run, plan.blocks)))


@compiled()
def _propagate(work: Any) -> int:
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
    while status == _COMPLETED and marks[0] < len(times):
        events, passed, laid = run.counts[2], 0, _clock(work, marks[0] - 1, sub, size)
        if laid > 0 and (switches == 0 or run.props.step <= 1.000001 * longest_part(run)):
            advance(problem.tracks, problem.piece, blocks.clock[0], slack)
            nodes = _lay_out(work, laid)
            if nodes > (1 if switches > 0 else 0):
                passed, status = _block(work, nodes, sub)
            if passed == laid:
                for track in range(len(problem.piece)):
                    problem.piece[track] = blocks.reached[track]
        if passed == 0:
            start, end = _next_step(work, marks[0] - 1, sub)
            status = step_to(run, start, end, slack)
            passed = blocks.parts if end == times[marks[0]] and sub == 0 else 1
            if end == times[marks[0]]:
                _place(run, end)
        sub = (sub + passed) % blocks.parts
        if marks[0] - marks[1] >= BLOCK:
            finish_outputs(run)
        size = _FIRST_BLOCK if run.counts[2] > events else min(2 * size, BLOCK)
    finish_outputs(run)
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
    """How many distances of samples, from one on, are such as the steps are made for."""
    odd, marks = work.blocks.odd, work.run.marks
    while odd[marks[4]] < sample:
        marks[4] += 1
    return int(odd[marks[4]] - sample)


@part(forceinline=True)
def _next_step(work: Any, sample: int, sub: int) -> tuple[float, float]:
    """Start and end of the next step alone: up to the next sample where the steps do not fit."""
    times, parts, step = work.run.out.times, work.blocks.parts, work.run.props.step
    if _regular(work, sample) == 0:
        return times[sample], times[sample + 1]
    start = times[sample] + sub * step
    return start, times[sample + 1] if sub == parts - 1 else start + step


@part(forceinline=True)
def _clock(work: Any, sample: int, sub: int, size: int) -> int:
    """Lay out the times of up to ``size`` steps; give their number."""
    times, clock, parts, step = work.run.out.times, work.blocks.clock, work.blocks.parts, work.run.props.step
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
    """Lay out what acts over each of ``nodes`` steps, apart from the state; give the number of steps that is good for.

    A step in which a sine begins or ends, or in which jumps have no series, ends the block before it.
    """
    run, blocks = work.run, work.blocks
    lay, rows = run.props.layout, blocks.rows
    for d in range(rows.shape[1]):
        rows[0, d] = run.x[0, d]
    set_rows(run.props.loops.set, rows, 1, run.props.matrix[run.props.used[1]], lay.drift, nodes)
    for row in range(len(blocks.most) if len(run.problem.m) > 0 else 0):
        blocks.most[row], jumps = 0.0, blocks.jumps[row]
        for node in range(nodes + 1):
            jumps[node] = 0.0
    for track in range(lay.tracks):
        nodes = _lay_track(work, track, nodes)
    return nodes


@part(forceinline=True)
def _lay_track(work: Any, track: int, nodes: int) -> int:
    """The same for one track."""
    run, blocks = work.run, work.blocks
    lay, tracks, cell, clock = run.props.layout, run.problem.tracks, run.props.used[1], blocks.clock
    matrix, terms, slack, c = run.props.matrix[cell], run.props.terms[cell], blocks.slack, tracks.coefficients
    i, last, rate, row = run.problem.piece[track], tracks.first[track + 1] - 1, tracks.rate[track], track * lay.signals
    value, slope, higher = blocks.signals[row], blocks.signals[row + 1], blocks.signals[row + 2 : row + lay.signals]
    stop, start, straight = tracks.stop[i] if i < last else np.inf, tracks.start[i], lay.signals == 2
    c0, c1 = c[i, 0], rate * c[i, 1]
    for node in range(nodes + 1):
        while clock[node] + slack >= stop:
            left = clock[node] - stop
            if left > slack:
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
            forcing, stride = lay.forcing + (blocks.wave[i] * lay.tracks + track) * lay.signals, blocks.signals.shape[1]
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
def _signals_at(tracks: Any, i: int, rate: float, s: float, node: int, value: Any, slope: Any, higher: Any) -> None:
    """Value and derivatives of a piece at a node."""
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
    """Add what a track's jumps of signals from piece ``i`` to the next make of the state at ``node``, ``left`` s on."""
    run, blocks, tracks = work.run, work.blocks, work.run.problem.tracks
    lay, c, powers, cell = run.props.layout, tracks.coefficients, run.props.scratch.powers, run.props.used[1]
    stop, rate, terms, matrix = tracks.stop[i], tracks.rate[track], run.props.terms[cell], run.props.matrix[cell]
    s = rate * (stop - tracks.start[i])
    for j in range(lay.signals):
        if j == 0:
            old = c[i, 0] + s * (c[i, 1] + s * (c[i, 2] + s * c[i, 3]))
            jump = c[i + 1, 0] - old
            rounding = 1e-15 * (abs(old) + max(1.0, abs(stop)) * abs(rate) * (abs(c[i, 1]) + abs(c[i + 1, 1])))
            if abs(jump) <= rounding:
                jump = 0.0
        elif j == 1:
            jump = rate * (c[i + 1, 1] - (c[i, 1] + s * (2.0 * c[i, 2] + 3.0 * s * c[i, 3])))
        elif j == 2:
            jump = rate * rate * (2.0 * c[i + 1, 2] - (2.0 * c[i, 2] + 6.0 * s * c[i, 3]))
        else:
            jump = 6.0 * rate**3 * (c[i + 1, 3] - c[i, 3])
        row = track * lay.signals + j
        blocks.jumps[row, node] += abs(jump)
        blocks.most[row] = max(blocks.most[row], blocks.jumps[row, node])
        if jump != 0.0:
            powers_of(powers, jump, left, terms + 1)
            add_rows(run.props.loops.add, blocks.rows, node, matrix, lay.series + row * TERMS + 1, powers, 1, terms, 1)


@part(forceinline=True)
def _block(work: Any, nodes: int, sub: int) -> tuple[int, int]:
    """Take the steps that are laid out, up to an event; give the number of steps taken and a status code."""
    run, blocks = work.run, work.blocks
    problem, lay = run.problem, run.props.layout
    matrix = run.props.matrix[run.props.used[1]]
    forced = lay.tracks * lay.signals if lay.waves == 1 else 0
    for d in range(lay.states):
        blocks.x[d, 0] = blocks.rows[0, d]
    march(run.props.loops.march, blocks.rows, nodes, matrix, lay.forcing, forced, blocks.signals, blocks.x)
    finite = True
    for d in range(lay.states):
        finite = finite and math.isfinite(blocks.x[d, nodes])
    sample = run.marks[0] - 1
    if len(problem.m) == 0 or not finite:
        _accept(work, sample, sub, 1, nodes)
        run.counts[0] += nodes
        for d in range(lay.states):
            run.x[0, d] = blocks.x[d, nodes]
        return nodes, _COMPLETED if finite else _NOT_FINITE
    _look(work, nodes)
    at = 0
    while True:
        suspect = _suspect(work, at, nodes)
        if suspect > at:
            _accept(work, sample, sub, at + 1, suspect)
            run.counts[0] += suspect - at
            run.marks[2] = 0
        for d in range(lay.states):
            run.x[0, d] = blocks.x[d, suspect]
        if suspect == nodes:
            return nodes, _COMPLETED
        advance(problem.tracks, problem.piece, blocks.clock[suspect], blocks.slack)
        events, at = run.counts[2], suspect + 1
        status = step_to(run, blocks.clock[suspect], blocks.clock[at], blocks.slack)
        if status != _COMPLETED or run.counts[2] > events:
            if status == _COMPLETED and (sub + at) % blocks.parts == 0:
                _place(run, blocks.clock[at])
            return at, int(status)
        _accept(work, sample, sub, at, at)


@part(forceinline=True)
def _look(work: Any, nodes: int) -> None:
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
    """First step in which a switch may leave its side, at its end or before; ``nodes`` where there is none.

    Inside a step a switch lies off its chord by what edges there can make of it, and by its curvature.
    """
    run, blocks = work.run, work.blocks
    g, band, modes, found = blocks.g, run.band, run.problem.m, nodes
    kick = run.props.kick[run.props.used[1]]
    for i in range(len(modes)):
        side, room = 1.0 if modes[i] > 0.5 else -1.0, -band[i]
        for row in range(kick.shape[0]):
            room += blocks.most[row] * kick[row, i]
        lowest, bend = _extremes(g[i], side, nodes)
        if lowest >= room + 0.5 * bend:
            continue
        for k in range(first, found):
            room = -band[i]
            for row in range(kick.shape[0]):
                room += blocks.jumps[row, k + 1] * kick[row, i]
            here, there = side * g[i, k], side * g[i, k + 1]
            bend = abs(here - 2.0 * there + side * g[i, k + 2]) if k + 2 <= nodes else 0.0
            if k > 0:
                before = abs(side * g[i, k - 1] - 2.0 * here + there)
                bend = bend + before if k + 2 <= nodes else 2.0 * before
            elif k + 2 <= nodes:
                bend *= 2.0
            if there < -band[i] or min(here, there) < room + 0.25 * bend:
                found = k
                break
    return found


@part(fastmath={"nnan", "nsz"})
def _extremes(g: Any, side: float, nodes: int) -> tuple[float, float]:
    """Lowest value and greatest bend of a switching function, seen from its side."""
    lowest, bend = min(side * g[0], side * g[nodes]), 0.0
    for k in range(1, nodes):
        lowest = min(lowest, side * g[k])
        bend = max(bend, abs(g[k - 1] - 2.0 * g[k] + g[k + 1]))
    return lowest, bend


@part()
def _accept(work: Any, sample: int, sub: int, first: int, last: int) -> None:
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
