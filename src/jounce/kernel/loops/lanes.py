"""Many variants side by side over one course (see ``methods.lanes``)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from jounce.kernel.engine import COMPLETED, Problem
from jounce.kernel.loops.compiling import call_native, call_one, part
from jounce.kernel.loops.exact import step_to
from jounce.kernel.loops.propagators import find
from jounce.kernel.loops.signals import advance
from jounce.kernel.methods.exact import Run
from jounce.kernel.methods.lanes import ALONE, NEARS, SUMS, Work
from jounce.kernel.methods.propagators import TERMS, Propagators

_STILL, _START = 0, 1  # rows of the ends of a course


@part()
def follow(work: Work) -> None:
    """Compute the results of every variant of the span."""
    wide = work.room.kept.shape[1]
    for first in range(work.span[0], work.span[1], wide):
        last = min(first + wide, work.span[1])
        for lane in range(wide):
            _lay_out(work, min(first + lane, last - 1), lane)
        _march(work, first, last - first)
        for lane in range(last - first):
            _take_down(work, first + lane, lane)


@part(forceinline=True)
def _run_of(work: Any, lane: int) -> Any:
    """Return the run of one variant of the block: its parameters, modes, propagators, and shared scratch arrays."""
    run, room, count = work.run, work.room, work.room.fastest.shape[1]
    problem, props, own = run.problem, run.props, lane * count
    return Run(
        Problem(
            problem.engine,
            problem.tracks,
            problem.piece,
            room.values[lane],
            room.modes[lane],
            problem.x0,
            problem.inputs,
        ),
        run.control,
        Propagators(
            props.calls,
            props.loops,
            props.layout,
            props.scratch,
            props.step,
            props.frequency,
            props.scale,
            room.matrix[own : own + count],
            room.mode_table[own : own + count],
            room.fastest[lane],
            room.terms[lane],
            room.kick[own : own + count],
            room.throw[own : own + count],
            room.used[lane],
        ),
        run.out,
        run.band,
        run.x,
        run.trial,
        run.time,
        run.u,
        run.part,
        run.orders,
        run.counts,
        run.marks,
    )  # fmt: skip


@part()
def _lay_out(work: Any, variant: int, lane: int) -> None:
    """Write the step data of a variant into its lane, and set the variant to its rest position."""
    room, course, none = work.room, work.course, work.modes
    call_native(
        work.addresses.derived,
        work.parameters,
        variant,
        course.still,
        none,
        none,
        room.values,
        lane,
    )
    count = room.fastest.shape[1]
    for i in range(len(work.modes)):
        room.modes[lane, i] = work.modes[i]
    room.used[lane, 0], room.lost[lane] = 0, 0
    for c in range(lane * count, (lane + 1) * count):
        room.laid[c] = 0
    for q in range(len(course.still)):
        work.run.props.scratch.base[q, 0] = course.still[q]
    run = _run_of(work, lane)
    find(run.problem, run.props)
    if not _fits(work, run) or not _rest(work, run):
        _lose(work, variant, lane)
        return
    for i in range(room.rest.shape[1]):
        room.rest[lane, i] = room.state[i, 0]
    for q in range(len(course.still)):
        room.inputs[q, 0] = course.still[q]
    call_one(
        work.addresses.output, room.state, room.inputs, run.problem.p, run.problem.m, room.outputs
    )
    for k in range(len(work.chosen)):
        work.rest[variant, k] = room.outputs[work.chosen[k], 0]
    _change(work, run, variant, lane)
    _look(work, run, lane, work.addresses.look, course.ends, _STILL)
    sound = _is_sound(work, room.one[1])
    for j in range(len(work.chosen)):
        at = room.rest.shape[1] + SUMS * j
        room.one[0, at], room.one[0, at + 1] = 0.0, 0.0
        room.one[0, at + 2], room.one[0, at + 3] = np.inf, -np.inf
    _look(work, run, lane, work.addresses.look, course.ends, _START)
    if not sound or not _is_sound(
        work, room.one[1]
    ):  # other contacts at rest, or thrown over at the start
        _lose(work, variant, lane)
        return
    for i in range(room.kept.shape[0]):
        room.kept[i, lane] = room.one[1, i]


@part()
def _lose(work: Any, variant: int, lane: int) -> None:
    """Exclude a variant: its lane is invalid from here on."""
    room = work.room
    work.alone[variant], room.lost[lane] = 1, 1
    for i in range(room.kept.shape[0]):
        room.kept[i, lane] = room.next[i, lane] = 0.0
    for i in range(room.variant.shape[0]):
        room.variant[i, lane] = 0.0


@part(forceinline=True)
def _fits(work: Any, run: Any) -> bool:
    """Whether the common step is short enough for the modes of a variant."""
    return bool(run.props.fastest[run.props.used[1]] * run.props.step <= work.fastest)


@part()
def _rest(work: Any, run: Any) -> bool:
    """Solve for the rest position of the variant in its modes by Gaussian elimination with pivoting; return success."""
    props, table, state = run.props, work.room.balance, work.room.state
    matrix, lay, n = props.matrix[props.used[1]], props.layout, props.layout.states
    for d in range(n):
        state[d, 0] = 0.0
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
        if not abs(table[best, k]) > 1e-12 * props.fastest[props.used[1]]:
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
def _change(work: Any, run: Any, variant: int, lane: int) -> None:
    """Update the step data of a lane for the modes of its variant."""
    room, modes = work.room, run.problem.m
    c = lane * room.fastest.shape[1] + run.props.used[1]
    column, first = room.columns[c], room.columns.shape[1] - len(modes)
    same = room.laid[c] == 1
    for i in range(len(modes)):
        same = same and column[first + i] == modes[i]
    if not same:
        _lay_column(work, run, variant, lane, column)
        room.laid[c] = 1
    for i in range(len(column)):
        room.variant[i, lane] = column[i]


@part()
def _lay_column(work: Any, run: Any, variant: int, lane: int, column: Any) -> None:
    """Write the step data: images of the states, drift, forcing, series, rows of outputs, parameters, modes."""
    props = run.props
    matrix, lay, n = props.matrix[props.used[1]], props.layout, props.layout.states
    at = 0
    for j in range(n):
        at = _put(column, at, matrix, j, n)
    at = _put(column, at, matrix, lay.drift, n)
    for signal in work.course.felt:
        at = _put(column, at, matrix, lay.forcing + signal, n)
    for signal in work.jumping:
        for p in range(work.terms):
            at = _put(column, at, matrix, lay.series + signal * TERMS + p + 1, n)
    at = _lay_outputs(work, run, variant, lane, column, at)
    for number in work.numbers:
        column[at] = run.problem.p[number]
        at += 1
    for i in range(len(run.problem.m)):
        column[at + i] = run.problem.m[i]


@part()
def _put(column: Any, at: int, matrix: Any, row: int, count: int) -> int:
    for i in range(count):
        column[at + i] = matrix[row, i]
    return at + count


@part()
def _lay_outputs(work: Any, run: Any, variant: int, lane: int, column: Any, at: int) -> int:
    """Write the rows of the outputs relative to their values at rest; return the next free position."""
    problem, room, still = run.problem, work.room, work.course.still
    n, inputs = room.rest.shape[1], len(still)
    _read_rows(work, run)
    for i in range(n):
        room.state[i, 0] = room.rest[lane, i]
    for q in range(inputs):
        room.inputs[q, 0] = still[q]
    call_one(work.addresses.output, room.state, room.inputs, problem.p, problem.m, room.outputs)
    for k in range(len(work.chosen)):
        constant = room.outputs[work.chosen[k], 0] - work.rest[variant, k]
        for i in range(n):
            constant -= room.rows[k, i] * room.rest[lane, i]
        for q in range(inputs):
            constant -= room.rows[k, n + q] * still[q]
        for place in range(work.begins[k], work.begins[k + 1]):
            column[at] = room.rows[k, work.depends[place]]
            at += 1
        column[at] = constant
        at += 1
    return at


@part()
def _read_rows(work: Any, run: Any) -> None:
    """Read the slopes of the evaluated outputs along states and inputs."""
    problem, calls, room, lay = run.problem, run.props.calls, run.props.scratch, run.props.layout
    n, lanes, directions = lay.states, calls.lanes, lay.states + lay.inputs
    for first in range(0, directions, lanes):
        room.seeds[:] = 0.0
        group = min(lanes, directions - first)
        for lane in range(group):
            room.seeds[0, n + (first + lane) * lanes + lane] = 1.0
        call_native(calls.slopes, room.seeds, 0, room.still, problem.p, problem.m, room.slopes, 0)
        for lane in range(group):
            for k in range(len(work.chosen)):
                work.room.rows[k, first + lane] = room.slopes[
                    0, (n + work.chosen[k]) * lanes + lane
                ]


@part()
def _look(work: Any, run: Any, lane: int, address: int, ends: Any, row: int) -> None:
    """Add the outputs of a variant to the sums in ``one``, and evaluate its switches."""
    room = work.room
    for i in range(room.rest.shape[1]):
        room.one[0, i] = room.state[i, 0]
    c = lane * room.fastest.shape[1] + run.props.used[1]
    call_native(address, room.one, 0, room.columns[c], ends[row], work.length, room.one, 1)


@part()
def _is_sound(work: Any, one: Any) -> bool:
    """Return whether all switching functions are on their side, apart from rounding."""
    switches, sound = len(work.modes), True
    for i in range(switches):
        sound = (
            sound and one[len(one) - 1 - NEARS * (switches - i)] >= -work.run.control.dead_band[i]
        )
    return sound


@part()
def _march(work: Any, first: int, count: int) -> None:
    """Propagate a block of variants through the whole course."""
    room, course, addresses = work.room, work.course, work.addresses
    here, there, last = room.kept, room.next, room.kept.shape[0] - 1
    watched, sub = len(work.modes) > 0, 0
    for track in range(len(room.piece)):
        room.piece[track] = work.run.problem.tracks.first[track]
    for k in range(len(course.edges)):
        sub += 1
        sampled, edge = sub == work.parts, course.edges[k]
        if edge == ALONE:
            for lane in range(count):
                if room.lost[lane] == 0:
                    _step_alone(work, first + lane, lane, k, sampled, here, there)
        else:
            kind = (0 if sampled else len(addresses.steps) // 2) + (
                course.kinds[edge] if edge >= 0 else 0
            )
            row = course.over_edges[edge] if edge >= 0 else course.level[k]
            call_one(addresses.steps[kind], here, room.variant, row, work.length, there)
        if watched and edge != ALONE and _lowest(there[last]) < 0.0:
            for lane in range(count):
                if there[last, lane] < 0.0 and room.lost[lane] == 0:
                    _step_alone(work, first + lane, lane, k, sampled, here, there)
        here, there = there, here
        if sampled:
            sub = 0
    if len(course.edges) % 2 == 1:
        for i in range(room.kept.shape[0]):
            for lane in range(count):
                room.kept[i, lane] = room.next[i, lane]


@part(fastmath={"nnan", "nsz"})
def _lowest(row: Any) -> float:
    found = row[0]
    for lane in range(1, len(row)):
        found = min(found, row[lane])
    return float(found)


@part()
def _step_alone(
    work: Any, variant: int, lane: int, k: int, sampled: bool, here: Any, there: Any
) -> None:
    """Propagate one variant separately over a step, through its events, and return it to the block."""
    room, course, run = work.room, work.course, _run_of(work, lane)
    n, last = room.rest.shape[1], room.kept.shape[0] - 1
    advance(run.problem.tracks, room.piece, course.clock[k], work.slack)
    for track in range(len(room.piece)):
        run.problem.piece[track] = room.piece[track]
    for d in range(n):
        run.x[0, d] = here[d, lane]
    run.counts[2], run.marks[2], run.marks[3] = 0, 0, 0
    status = step_to(run, course.clock[k], course.clock[k + 1], work.slack)
    if status != COMPLETED or not _fits(work, run):
        _lose(work, variant, lane)
        return
    if run.counts[2] > 0:
        work.events[variant] += run.counts[2]
        _change(work, run, variant, lane)
    for i in range(last):
        room.one[0, i] = here[i, lane]
    for d in range(n):
        room.state[d, 0] = run.x[0, d]
    _look(
        work, run, lane, work.addresses.look if sampled else work.addresses.glance, course.level, k
    )
    for i in range(last):
        there[i, lane] = room.one[1, i]


@part()
def _take_down(work: Any, variant: int, lane: int) -> None:
    """Store the results of a variant."""
    kept, n, sums = work.room.kept, work.room.rest.shape[1], work.sums.shape[1]
    if work.alone[variant] == 1:
        return
    for i in range(n + sums):
        if not math.isfinite(kept[i, lane]):
            work.alone[variant] = 1
    for j in range(sums):
        work.sums[variant, j] = kept[n + j, lane]
