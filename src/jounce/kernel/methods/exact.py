"""Exact propagation of piecewise linear models, without discretisation error for any step size.

Between samples the state advances by the matrices of its modes (``propagators``). Edges of the input inside a step add
the effect of their signal jumps. Blocks of steps are computed with fixed modes, then the switching functions of all
steps are evaluated. A step in which one may leave its side is repeated in parts; if it does, the later steps are
discarded.

Steps of any length (``step_to``) are Taylor series between the edges of the input and the events. Modes are held on
each part of a step. If a switching function leaves its side, the part ends at the located crossing, the mode flips,
and the matrices of the new modes apply. A flip caused by an edge of the input is treated likewise, in zero time.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from jounce.core.remembered import once_per_object
from jounce.core.types import Array
from jounce.kernel.arrays import Integers, Matrix, Vector
from jounce.kernel.call import Loop
from jounce.kernel.engine import Control, Problem, Samples, Tracks
from jounce.kernel.methods.propagators import Calls, Propagators, propagators

_propagate, _bound_rates = Loop("exact"), Loop("rate_bound")

BLOCK = 192
"""Most steps in a block, whose scratch arrays should stay in the cache."""
MOST_WAVES, _MAX_PARTS, _MAX_STEPS = (
    8,
    64,
    20_000_000,
)  # beyond, steps with error control are the faster way
_BAND = 1e-2  # share of the dead band of adaptive steps, whose errors are larger
WATCHED = 0.5  # radians of the fastest motion between looks at the switches; the series converge well beyond


class Blocks(NamedTuple):
    """Division of a run into steps, and arrays for a block of them.

    Sample intervals of ``parts`` times the step of the propagators are divided into ``parts`` steps; ``odd`` lists
    the samples with a different interval to the next one, and the last sample. ``slack`` (s) is the rounding of
    times. ``wave`` is the number of each piece's angular frequency, ``reached`` the piece of each track at the end of
    a block. At the nodes of a block: ``clock`` (s), ``rows`` (states), ``signals`` of the tracks, and, one row per
    element, ``x``, ``u`` and the switching functions ``g``; ``jumps`` are the jumps of each signal at edges inside
    the step to a node, and ``most`` the largest in the block; ``thrown`` and ``most_thrown`` are the jumps on the
    node itself.
    """

    parts: int
    slack: float
    odd: Integers
    wave: Integers
    reached: Integers
    clock: Vector
    rows: Matrix
    signals: Matrix
    x: Matrix
    u: Matrix
    g: Matrix
    jumps: Matrix
    most: Vector
    thrown: Matrix
    most_thrown: Vector


class Plan(NamedTuple):
    """Propagators, and the blocks of their steps."""

    props: Propagators
    blocks: Blocks


def plan(
    problem: Problem, control: Control, calls: Calls, slopes: int, times: Array
) -> Plan | None:
    """Plan an exact run with samples at ``times``; return None if a piece is circular or the run takes too many steps.

    The problem's modes are those at the start; ``slopes`` is the number of quantities that the native function of
    slopes differentiates.
    """
    tracks, switches = problem.tracks, len(problem.m)
    frequency, wave = np.zeros(1), np.zeros(len(tracks.kind), dtype=np.int64)
    if tracks.kind.any():  # roads of thousands of lines have none
        speed = np.abs(tracks.coefficients[:, 2] * np.repeat(tracks.rate, np.diff(tracks.first)))
        frequency = np.unique(np.append(0.0, speed[tracks.kind == 1]))
        wave = np.where(tracks.kind == 1, np.searchsorted(frequency, speed), 0).astype(np.int64)
    if np.any(tracks.kind == 2) or len(frequency) > MOST_WAVES or len(times) < 2:
        return None
    count = len(tracks.rate)
    sizes = (
        len(control.scale),
        count,
        problem.inputs // max(count, 1),
        signals_of(tracks, problem.inputs),
    )
    props = propagators(calls, sizes, slopes, switches, frequency, control.scale)
    typical, odd = spacing(times)
    z = max(rate_bound_of(problem, props), float(frequency[-1])) * typical
    parts = parts_for(z, switches > 0)
    along_edges = z / parts * len(tracks.start) if z > parts else 0.0
    if not parts * len(times) + along_edges < _MAX_STEPS:
        return None
    nodes, rows = BLOCK + 1, count * props.layout.signals
    blocks = Blocks(
        parts,
        _slack(times),
        odd,
        wave,
        np.zeros(count, dtype=np.int64),
        clock=np.zeros(nodes),
        rows=np.zeros((nodes, props.matrix.shape[2])),
        signals=np.zeros((rows, nodes)),
        x=np.zeros((sizes[0], nodes)),
        u=np.zeros((problem.inputs, nodes)),
        g=np.zeros((switches, nodes)),
        jumps=np.zeros((rows, nodes)),
        most=np.zeros(rows),
        thrown=np.zeros((rows, nodes)),
        most_thrown=np.zeros(rows),
    )
    return Plan(props._replace(step=typical / parts), blocks)


def signals_of(tracks: Tracks, inputs: int) -> int:
    """Return the number of signals of each track: its inputs, and derivatives up to the last nonzero one."""
    bent = cubic = False
    if tracks.kind.any() or tracks.coefficients[:, 2:].any():
        bent = bool((tracks.kind == 1).any() or tracks.coefficients[:, 2].any())
        cubic = bool(((tracks.kind == 0) & (tracks.coefficients[:, 3] != 0.0)).any())
    return max(4 if cubic else 3 if bent else 2, inputs // max(len(tracks.rate), 1))


def spacing(times: Array) -> tuple[float, Integers]:
    """Return the typical sample interval (s), and the samples after which the interval changes, including the last one.

    Read-only times that many runs share are evaluated only once.
    """
    return (_looked_at if times.flags.writeable else _spacing)(times)


def _looked_at(times: Array) -> tuple[float, Integers]:
    distances = np.diff(times)
    typical = typical_step(times, distances)
    return typical, np.append(
        np.flatnonzero(np.abs(distances - typical) > _slack(times)), len(times) - 1
    )


_spacing = once_per_object(_looked_at)


def _slack(times: Array) -> float:
    """Return the rounding of times, s."""
    return 1e-12 * max(1.0, abs(float(times[-1])))


def typical_step(times: Array, distances: Array) -> float:
    """Return the most frequent sample interval (s)."""
    whole = distances[:-1] if len(distances) > 1 else distances  # the last one may be shorter
    if np.max(np.abs(whole - whole[0])) <= 1e-12 * max(1.0, abs(times[-1])):
        return float((times[len(whole)] - times[0]) / len(whole))
    return float(np.median(distances))


def parts_for(z: float, watched: bool) -> int:
    """Return the number of steps between two samples; the fastest motion covers ``z`` radians in that interval."""
    if watched:  # short enough that the switches between two looks are nearly parabolas
        return max(1, math.ceil(min(z / WATCHED, 1e9)))
    return max(1, math.ceil(z)) if z <= _MAX_PARTS else 1


def rate_bound_of(problem: Problem, props: Propagators) -> float:
    """Return a bound of the rates for the initial modes, for all modes on, and for all modes off."""
    # Modes to come are not known; all contacts closed and all open are the extremes of stiffness, near enough for a
    # step.
    start, bounds = problem.m.copy(), []
    for modes in (start, np.ones_like(start), np.zeros_like(start)) if len(start) else (start,):
        problem.m[:] = modes
        _bound_rates(problem, props)
        bounds.append(props.fastest[0])
    problem.m[:] = start
    return float(max(bounds))


class Run(NamedTuple):
    """A run and its current state.

    ``band`` is the distance by which a switch may be on the wrong side between events; right after an event, and at
    edges, the wider ``dead_band`` applies, because times are rounded. ``x`` is the state, ``trial`` an intermediate
    one; ``time`` and ``u`` are an instant and the inputs there; ``part`` is (start, length) in s of the current part
    of a step, with ``orders`` terms in its series. ``counts`` receives steps, rejected steps (none) and events;
    ``marks`` counts samples placed, samples with outputs, events at one instant, parts of steps, and samples with
    irregular intervals.
    """

    problem: Problem
    control: Control
    props: Propagators
    out: Samples
    band: Vector
    x: Matrix
    trial: Matrix
    time: Vector
    u: Matrix
    part: Vector
    orders: Integers
    counts: Integers
    marks: Integers


class Work(NamedTuple):
    """Run and its blocks, the argument of the loops."""

    run: Run
    blocks: Blocks


def propagate(
    problem: Problem, control: Control, plan: Plan, out: Samples, counts: Integers
) -> int:
    """Fill the arrays at every sample; return a status code.

    A sample at an input edge has the values just after it. ``counts`` gets steps, rejected steps (none) and events.
    """
    return _propagate(Work(run_of(problem, control, plan.props, out, counts), plan.blocks))


def run_of(
    problem: Problem, control: Control, props: Propagators, out: Samples, counts: Integers
) -> Run:
    """Prepare a run at its start."""
    width = props.matrix.shape[2]
    run = Run(
        problem,
        control,
        props,
        out,
        band=_BAND * control.dead_band + 1e-14,
        x=np.zeros((1, width)),
        trial=np.zeros((1, width)),
        time=np.zeros(1),
        u=np.zeros((problem.inputs, 1)),
        part=np.zeros(2),
        orders=np.zeros(1, dtype=np.int64),
        counts=counts,
        marks=np.zeros(5, dtype=np.int64),
    )
    run.x[0, : len(control.scale)] = problem.x0
    return run
