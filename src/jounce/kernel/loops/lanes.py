"""Many variants side by side over one course (see ``methods.lanes``)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from jounce.kernel.loops.compiling import call_native, call_one, part
from jounce.kernel.loops.propagators import build
from jounce.kernel.methods.lanes import NEARS, SUMS, Work
from jounce.kernel.methods.propagators import TERMS


@part()
def follow(work: Work) -> None:
    """Fill in what is found of every variant of the span."""
    wide = work.room.kept.shape[1]
    for first in range(work.span[0], work.span[1], wide):
        last = min(first + wide, work.span[1])
        for lane in range(wide):
            _lay_out(work, min(first + lane, last - 1), lane)
        _march(work)
        for lane in range(last - first):
            _take_down(work, first + lane, lane)


@part()
def _lay_out(work: Any, variant: int, lane: int) -> None:
    """Put what a step needs of a variant into its lane, and the variant where it rests."""
    problem, props, room = work.problem, work.props, work.room
    # The extended parameters lie where the problem has its own.
    call_native(
        work.addresses.derived, work.parameters, variant, work.course.still, problem.m, problem.m, room.values, 0
    )
    build(problem, props, 0)
    work.margin[variant] = 0.0
    if not props.fastest[0] * props.step <= work.fastest or not _rest(work):
        work.margin[variant] = -np.inf
        room.kept[:, lane] = 0.0
        room.variant[:, lane] = 0.0
        return
    _read_rows(work)
    matrix, lay, n = props.matrix[0], props.layout, props.layout.states
    at = 0
    for j in range(n):
        at = _put(room.variant, at, lane, matrix, j, n)
    at = _put(room.variant, at, lane, matrix, lay.drift, n)
    for j in range(lay.tracks * lay.signals):
        at = _put(room.variant, at, lane, matrix, lay.forcing + j, n)
    for signal in work.jumping:
        for p in range(work.terms):
            at = _put(room.variant, at, lane, matrix, lay.series + signal * TERMS + p + 1, n)
    at = _begin(work, variant, lane, at)
    for number in work.numbers:
        room.variant[at, lane] = room.values[0, number]
        at += 1


@part()
def _put(to: Any, at: int, lane: int, matrix: Any, row: int, count: int) -> int:
    for i in range(count):
        to[at + i, lane] = matrix[row, i]
    return at + count


@part()
def _rest(work: Any) -> bool:
    """Find where the variant rests, with its modes held: Gauss, with the greatest pivot; tell whether there is such."""
    props, table, state = work.props, work.room.balance, work.room.state
    matrix, lay, n = props.matrix[0], props.layout, props.layout.states
    for i in range(n):
        for j in range(n):
            table[i, j] = matrix[lay.slope + j, i]
        table[i, n] = -matrix[lay.constant, i]
        for q in range(lay.inputs):
            table[i, n] -= matrix[lay.input_slope + q, i] * work.course.still[q]
    for k in range(n):
        best = k
        for i in range(k + 1, n):
            if abs(table[i, k]) > abs(table[best, k]):
                best = i
        if not abs(table[best, k]) > 1e-12 * props.fastest[0]:
            return False
        for j in range(k, n + 1):
            table[k, j], table[best, j] = table[best, j], table[k, j]
        for i in range(k + 1, n):
            share = table[i, k] / table[k, k]
            for j in range(k, n + 1):
                table[i, j] -= share * table[k, j]
    for k in range(n - 1, -1, -1):
        total = table[k, n]
        for j in range(k + 1, n):
            total -= table[k, j] * state[j, 0]
        state[k, 0] = total / table[k, k]
    total = 0.0
    for k in range(n):
        total += abs(state[k, 0])
    return math.isfinite(total)


@part()
def _read_rows(work: Any) -> None:
    """Slopes of the outputs looked at, along states and inputs."""
    problem, calls, room, lay = work.problem, work.props.calls, work.props.scratch, work.props.layout
    n, lanes, directions = lay.states, calls.lanes, lay.states + lay.inputs
    for first in range(0, directions, lanes):
        room.seeds[:] = 0.0
        group = min(lanes, directions - first)
        for lane in range(group):
            room.seeds[0, n + (first + lane) * lanes + lane] = 1.0
        call_native(calls.slopes, room.seeds, 0, room.still, problem.p, problem.m, room.slopes, 0)
        for lane in range(group):
            for k in range(len(work.chosen)):
                work.room.rows[k, first + lane] = room.slopes[0, (n + work.chosen[k]) * lanes + lane]


@part()
def _begin(work: Any, variant: int, lane: int, at: int) -> int:
    """Lay out the rows of outputs, about rest, and what is kept at the start; give the place behind them."""
    problem, room, course = work.problem, work.room, work.course
    n, inputs, seeds = room.state.shape[0], len(course.still), work.props.scratch.seeds
    for q in range(inputs):
        room.inputs[q, 0] = course.still[q]
    for i in range(n):
        room.kept[i, lane] = seeds[0, i] = room.state[i, 0]
    call_one(work.addresses.output, room.state, room.inputs, problem.p, problem.m, room.outputs)
    row = n
    for k in range(len(work.chosen)):
        constant, first = 0.0, 0.0
        for i in range(n):
            room.variant[at + i, lane] = room.rows[k, i]
            constant -= room.rows[k, i] * room.state[i, 0]
        for q in range(inputs):
            room.variant[at + n + q, lane] = room.rows[k, n + q]
            constant -= room.rows[k, n + q] * course.still[q]
            first += room.rows[k, n + q] * (course.start[q] - course.still[q])
        room.variant[at + n + inputs, lane] = constant
        at += n + inputs + 1
        work.rest[variant, k] = room.outputs[work.chosen[k], 0]
        room.kept[row, lane], room.kept[row + 1, lane] = first, first * first
        room.kept[row + 2, lane], room.kept[row + 3, lane] = first, first
        row += SUMS
    call_native(work.addresses.switch, seeds, 0, room.inputs, problem.p, problem.m, room.switches, 0)
    for q in range(inputs):
        room.inputs[q, 0] = course.start[q]
    call_native(work.addresses.switch, seeds, 0, room.inputs, problem.p, problem.m, room.switches, 1)
    for i in range(len(work.side)):
        still, start = work.side[i] * room.switches[0, i], work.side[i] * room.switches[1, i]
        room.kept[row, lane], room.kept[row + 1, lane], room.kept[row + 2, lane] = 0.0, start, min(still, start)
        row += NEARS
    return at


@part()
def _march(work: Any) -> None:
    """Take a block of variants through the whole course."""
    room, course, addresses, none = work.room, work.course, work.addresses, work.problem.m
    here, there, wide = room.kept, room.next, room.kept.shape[1]
    sub = 0
    for k in range(len(course.edges)):
        sub += 1
        sampled, edge = sub == work.parts, course.edges[k]
        if edge >= 0:
            address = addresses.step_over_edge if sampled else addresses.part_over_edge
            call_one(address, here, room.variant, course.over_edges[edge], none, there)
        else:
            address = addresses.step if sampled else addresses.part
            call_one(address, here, room.variant, course.level[k], none, there)
        here, there = there, here
        if sampled:
            sub = 0
    if len(course.edges) % 2 == 1:
        for i in range(room.kept.shape[0]):
            for lane in range(wide):
                room.kept[i, lane] = room.next[i, lane]


@part()
def _take_down(work: Any, variant: int, lane: int) -> None:
    """Take down what was found of a variant."""
    kept, n, sums = work.room.kept, work.room.state.shape[0], work.sums.shape[1]
    if work.margin[variant] < 0.0:
        return
    for i in range(n + sums):
        if not math.isfinite(kept[i, lane]):
            work.margin[variant] = -np.inf
    for j in range(sums):
        work.sums[variant, j] = kept[n + j, lane]
    nearest = np.inf
    for i in range(len(work.side)):
        nearest = min(nearest, kept[n + sums + NEARS * i + 2, lane])
    work.margin[variant] = min(work.margin[variant], nearest) if nearest <= 0.0 else work.margin[variant]
