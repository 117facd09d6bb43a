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
from jounce.kernel.linear_steps import WATCHED, Run, finish_outputs, longest_part, step_to
from jounce.kernel.propagators import TERMS, Calls, Propagators, find, pace_of, powers_of, propagators, read_slopes
from jounce.kernel.rows import add_rows, march, set_rows
from jounce.kernel.sampling import Samples
from jounce.kernel.status import Status
from jounce.kernel.tracks import Tracks, advance, fill

Array = NDArray[np.float64]
_BLOCK, _FIRST_BLOCK = 192, 12
"""Most steps in a block, whose scratch arrays should stay in the cache, and steps in the one after an event."""
_BAND = 1e-2  # share of the dead band of adaptive steps, whose errors are larger
_MAX_WAVES, _MAX_PARTS, _MAX_STEPS = 8, 64, 20_000_000
_COMPLETED, _NOT_FINITE = Status.COMPLETED.code, Status.NOT_FINITE.code


class Plan(NamedTuple):
    """How a run is cut up, and room for a block of steps.

    Every distance of samples of ``parts`` times the propagators' step is cut into so many steps. ``wave`` is the number
    of each piece's angular frequency. At the nodes of a block: ``clock`` (s), ``rows`` (states), ``signals`` of the
    tracks, and, an element a row, ``x``, ``u`` and the switching functions ``g``; ``jumps`` (for each signal) are what
    edges make of it inside the step to a node, and ``most`` the largest in the block.
    """

    parts: int
    wave: NDArray[np.int64]
    props: Propagators
    clock: Array
    rows: Array
    signals: Array
    x: Array
    u: Array
    g: Array
    jumps: Array
    most: Array


class Work(NamedTuple):
    """A run and its plan, for the loops."""

    run: Run
    plan: Plan


def plan(problem: Problem, control: Control, calls: Calls, slopes: int, times: Array) -> Plan | None:
    """Plan an exact run; None where a piece is circular, or where that would take too many steps.

    Parameters
    ----------
    problem : Problem
        What is computed; its modes are those at the start.
    control : Control
        Its ``scale`` says how large the states typically are.
    calls : Calls
        Native functions.
    slopes : int
        How many quantities the native function of slopes differentiates.
    times : ndarray, shape (n,)
        Samples, s.
    """
    tracks, switches = problem.tracks, len(problem.m)
    speed = np.abs(tracks.coefficients[:, 2] * np.repeat(tracks.rate, np.diff(tracks.first)))
    frequency = np.unique(speed[tracks.kind == 1])
    frequency = np.concatenate([np.zeros(1), frequency[frequency > 0.0]])
    if np.any(tracks.kind == 2) or len(frequency) > _MAX_WAVES or len(times) < 2:
        return None
    count = len(tracks.rate)
    sizes = (len(control.scale), count, problem.inputs // max(count, 1), _signals(tracks, problem.inputs))
    props = propagators(calls, sizes, slopes, switches, frequency, control.scale)
    typical = _typical(times)
    z = max(_pace(problem, props), float(frequency[-1])) * typical
    parts = _parts(z, switches > 0)
    along_edges = z / parts * len(tracks.start) if z > parts else 0.0
    if not parts * len(times) + along_edges < _MAX_STEPS:
        return None
    wave = np.where(tracks.kind == 1, np.searchsorted(frequency, speed), 0).astype(np.int64)
    nodes, rows = _BLOCK + 1, count * props.layout.signals
    return Plan(
        parts,
        wave,
        props._replace(step=typical / parts),
        clock=np.zeros(nodes),
        rows=np.zeros((nodes, props.matrix.shape[2])),
        signals=np.zeros((rows, nodes)),
        x=np.zeros((sizes[0], nodes)),
        u=np.zeros((problem.inputs, nodes)),
        g=np.zeros((switches, nodes)),
        jumps=np.zeros((rows, nodes)),
        most=np.zeros(rows),
    )


def _signals(tracks: Tracks, inputs: int) -> int:
    """Number of signals that each track needs: its inputs, and derivatives up to the last that does not vanish."""
    bent = np.any(tracks.kind == 1) or np.any(tracks.coefficients[:, 2])
    cubic = np.any((tracks.kind == 0) & (tracks.coefficients[:, 3] != 0.0))
    return max(4 if cubic else 3 if bent else 2, inputs // max(len(tracks.rate), 1))


def _typical(times: Array) -> float:
    """Distance of the samples (s) that is met most."""
    distances = np.diff(times)
    whole = distances[:-1] if len(distances) > 1 else distances
    if np.max(np.abs(whole - whole[0])) <= 1e-12 * max(1.0, abs(times[-1])):
        return float((times[len(whole)] - times[0]) / len(whole))
    return float(np.median(distances))


def _parts(z: float, watched: bool) -> int:
    """Steps between two samples, over which the fastest motion goes through ``z`` radians."""
    if watched:
        return max(1, math.ceil(min(z / WATCHED, 1e9)))
    return max(1, math.ceil(z)) if z <= _MAX_PARTS else 1


def _pace(problem: Problem, props: Propagators) -> float:
    """Bound of the rates with the modes at the start, with all ones and with none."""
    start, paces = problem.m.copy(), []
    for modes in (start, np.ones_like(start), np.zeros_like(start)) if len(start) else (start,):
        problem.m[:] = modes
        paces.append(_pace_now(problem, props))
    problem.m[:] = start
    return float(max(paces))


@compiled()
def _pace_now(problem: Any, props: Any) -> float:
    read_slopes(problem, props, props.matrix[0])
    return float(pace_of(props, props.matrix[0]))


def propagate(problem: Problem, control: Control, plan: Plan, out: Samples, counts: NDArray[np.int64]) -> int:
    """Fill the arrays at every sample; give a status code.

    At an input edge the samples are those just after it. ``counts`` gets steps, rejected steps (none) and events.
    """
    width, inputs = plan.rows.shape[1], problem.inputs
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
        marks=np.zeros(4, dtype=np.int64),
    )
    run.x[0, : len(control.scale)] = problem.x0
    return int(_propagate(Work(run, plan)))


@compiled()
def _propagate(work: Any) -> int:
    run, plan, times = work.run, work.plan, work.run.out.times
    problem, marks = run.problem, run.marks
    slack, sub = 1e-12 * max(1.0, abs(times[-1])), 0
    switches = len(problem.m)
    run.time[0] = times[0]
    advance(problem.tracks, problem.piece, times[0], slack)
    fill(problem.tracks, problem.piece, run.time, plan.props.scratch.base)
    find(problem, plan.props)
    status = step_to(run, times[0], times[0], slack)
    _place(run, times[0])
    size = _FIRST_BLOCK if switches > 0 else _BLOCK
    while status == _COMPLETED and marks[0] < len(times):
        events, passed, nodes = run.counts[2], 0, _clock(plan, times, marks[0] - 1, sub, size, slack)
        if nodes > 0 and (switches == 0 or plan.props.step <= 1.000001 * longest_part(run)):
            advance(problem.tracks, problem.piece, plan.clock[0], slack)
            nodes = _lay_out(work, nodes, slack)
            if nodes > (1 if switches > 0 else 0):
                passed, status = _block(work, nodes, sub, slack)
        if passed == 0:
            start, end = _next_step(plan, times, marks[0] - 1, sub, slack)
            status = step_to(run, start, end, slack)
            passed = plan.parts if end == times[marks[0]] and sub == 0 else 1
            if end == times[marks[0]]:
                _place(run, end)
        sub = (sub + passed) % plan.parts
        if marks[0] - marks[1] >= _BLOCK:
            finish_outputs(run)
        size = _FIRST_BLOCK if run.counts[2] > events else min(2 * size, _BLOCK)
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


@part()
def _regular(plan: Any, times: Any, sample: int, slack: float) -> bool:
    """Whether the distance to the next sample is the one that the steps are made for."""
    return bool(abs(times[sample + 1] - times[sample] - plan.parts * plan.props.step) <= slack)


@part()
def _next_step(plan: Any, times: Any, sample: int, sub: int, slack: float) -> tuple[float, float]:
    """Start and end of the next step alone: up to the next sample where the steps do not fit."""
    if not _regular(plan, times, sample, slack):
        return times[sample], times[sample + 1]
    start = times[sample] + sub * plan.props.step
    return start, times[sample + 1] if sub == plan.parts - 1 else start + plan.props.step


@part()
def _clock(plan: Any, times: Any, sample: int, sub: int, size: int, slack: float) -> int:
    """Lay out the times of up to ``size`` steps; give their number."""
    node, clock, step = 0, plan.clock, plan.props.step
    clock[0] = times[sample] + sub * step
    while node < size and sample + 1 < len(times) and (sub > 0 or _regular(plan, times, sample, slack)):
        node, sub = node + 1, sub + 1
        if sub == plan.parts:
            sample, sub = sample + 1, 0
        clock[node] = times[sample] + sub * step
    return node


@part()
def _lay_out(work: Any, nodes: int, slack: float) -> int:
    """Lay out what acts over each of ``nodes`` steps, apart from the state; give the number of steps that is good for.

    A step in which a sine begins or ends, or in which jumps have no series, ends the block before it.
    """
    run, plan = work.run, work.plan
    lay, rows, cell = plan.props.layout, plan.rows, plan.props.used[1]
    matrix = plan.props.matrix[cell]
    for d in range(rows.shape[1]):
        rows[0, d] = run.x[0, d]
    set_rows(plan.props.loops.set, rows, 1, matrix, lay.drift, nodes)
    for row in range(len(plan.most) if len(run.problem.m) > 0 else 0):
        plan.most[row], jumps = 0.0, plan.jumps[row]
        for node in range(nodes + 1):
            jumps[node] = 0.0
    for track in range(lay.tracks):
        piece = run.problem.piece[track]
        nodes = _lay_track(run.problem.tracks, piece, plan, matrix, plan.props.terms[cell], track, nodes, slack)
    return nodes


@part()
def _lay_track(tracks: Any, i: int, plan: Any, matrix: Any, terms: int, track: int, nodes: int, slack: float) -> int:
    """The same for one track, from its piece ``i`` on."""
    clock, lay, c = plan.clock, plan.props.layout, tracks.coefficients
    last, rate, row = tracks.first[track + 1] - 1, tracks.rate[track], track * lay.signals
    value, slope, higher = plan.signals[row], plan.signals[row + 1], plan.signals[row + 2 : row + lay.signals]
    stop = tracks.stop[i] if i < last else np.inf
    for node in range(nodes + 1):
        while clock[node] + slack >= stop:
            left = clock[node] - stop
            if left > slack:
                if terms == 0 or tracks.kind[i] == 1 or tracks.kind[i + 1] == 1:
                    return node - 1
                _add_edge(tracks, i, rate, plan, matrix, terms, track, node, left)
            i += 1
            stop = tracks.stop[i] if i < last else np.inf
        s = rate * (clock[node] - tracks.start[i])
        if tracks.kind[i] == 0 and lay.signals == 2:
            value[node], slope[node] = c[i, 0] + s * c[i, 1], rate * c[i, 1]
        else:
            _signals_at(tracks, i, rate, s, node, value, slope, higher)
        if lay.waves > 1 and node < nodes:
            forcing, stride = lay.forcing + (plan.wave[i] * lay.tracks + track) * lay.signals, plan.signals.shape[1]
            add_rows(
                plan.props.loops.add,
                plan.rows,
                node + 1,
                matrix,
                forcing,
                plan.signals,
                row * stride + node,
                lay.signals,
                stride,
            )
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
def _add_edge(
    tracks: Any,
    i: int,
    rate: float,
    plan: Any,
    matrix: Any,
    terms: int,
    track: int,
    node: int,
    left: float,
) -> None:
    """Add what a track's jumps of signals from piece ``i`` to the next make of the state at ``node``, ``left`` s on."""
    lay, c, powers = plan.props.layout, tracks.coefficients, plan.props.scratch.powers
    stop = tracks.stop[i]
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
        plan.jumps[row, node] += abs(jump)
        plan.most[row] = max(plan.most[row], plan.jumps[row, node])
        if jump != 0.0:
            powers_of(powers, jump, left, terms + 1)
            add_rows(plan.props.loops.add, plan.rows, node, matrix, lay.series + row * TERMS + 1, powers, 1, terms, 1)


@part()
def _block(work: Any, nodes: int, sub: int, slack: float) -> tuple[int, int]:
    """Take the steps that are laid out, up to an event; give the number of steps taken and a status code."""
    run, plan = work.run, work.plan
    problem, lay = run.problem, plan.props.layout
    matrix = plan.props.matrix[plan.props.used[1]]
    forced = lay.tracks * lay.signals if lay.waves == 1 else 0
    for d in range(lay.states):
        plan.x[d, 0] = plan.rows[0, d]
    march(plan.props.loops.march, plan.rows, nodes, matrix, lay.forcing, forced, plan.signals, plan.x)
    finite = True
    for d in range(lay.states):
        finite = finite and math.isfinite(plan.x[d, nodes])
    sample = run.marks[0] - 1
    if len(problem.m) == 0 or not finite:
        _accept(work, sample, sub, 1, nodes)
        run.counts[0] += nodes
        for d in range(lay.states):
            run.x[0, d] = plan.x[d, nodes]
        return nodes, _COMPLETED if finite else _NOT_FINITE
    _look(work, nodes)
    at = 0
    while True:
        suspect = _suspect(run, plan, at, nodes)
        if suspect > at:
            _accept(work, sample, sub, at + 1, suspect)
            run.counts[0] += suspect - at
            run.marks[2] = 0
        for d in range(lay.states):
            run.x[0, d] = plan.x[d, suspect]
        if suspect == nodes:
            return nodes, _COMPLETED
        advance(problem.tracks, problem.piece, plan.clock[suspect], slack)
        events, at = run.counts[2], suspect + 1
        status = step_to(run, plan.clock[suspect], plan.clock[at], slack)
        if status != _COMPLETED or run.counts[2] > events:
            if status == _COMPLETED and (sub + at) % plan.parts == 0:
                _place(run, plan.clock[at])
            return at, int(status)
        _accept(work, sample, sub, at, at)


@part()
def _look(work: Any, nodes: int) -> None:
    """Evaluate the switching functions at all nodes."""
    problem, plan = work.run.problem, work.plan
    lay, address = plan.props.layout, plan.props.calls.switch_many
    if lay.signals == lay.order:
        call_many(address, plan.x, plan.signals, problem.p, problem.m, plan.g, 0, nodes + 1)
        return
    for track in range(lay.tracks):
        for i in range(lay.order):
            for k in range(nodes + 1):
                plan.u[track * lay.order + i, k] = plan.signals[track * lay.signals + i, k]
    call_many(address, plan.x, plan.u, problem.p, problem.m, plan.g, 0, nodes + 1)


@part()
def _suspect(run: Any, plan: Any, first: int, nodes: int) -> int:
    """First step in which a switch may leave its side, at its end or before; ``nodes`` where there is none.

    Inside a step a switch lies off its chord by what edges there can make of it, and by its curvature.
    """
    g, band, modes, found = plan.g, run.band, run.problem.m, nodes
    kick = plan.props.kick[plan.props.used[1]]
    for i in range(len(modes)):
        side, room = 1.0 if modes[i] > 0.5 else -1.0, -band[i]
        for row in range(kick.shape[0]):
            room += plan.most[row] * kick[row, i]
        lowest, bend = _extremes(g[i], side, nodes)
        if lowest >= room + 0.5 * bend:
            continue
        for k in range(first, found):
            room = -band[i]
            for row in range(kick.shape[0]):
                room += plan.jumps[row, k + 1] * kick[row, i]
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
    run, plan = work.run, work.plan
    out, lay, parts = run.out, plan.props.layout, plan.parts
    begin = -((sub + first) // -parts) * parts - sub  # the first node that is a sample
    at = sample + (begin + sub) // parts
    count = (last - begin) // parts + 1 if begin <= last else 0
    for d in range(lay.states):
        _copy(plan.x[d, begin:], parts, out.states[d, at : at + count])
    for track in range(lay.tracks):
        for i in range(lay.order):
            _copy(
                plan.signals[track * lay.signals + i, begin:], parts, out.inputs[track * lay.order + i, at : at + count]
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
