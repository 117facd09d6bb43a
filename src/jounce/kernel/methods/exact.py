"""Exact propagation of piecewise linear models: no step-size error, whatever the step.

Between samples the state moves by matrices of the modes it is in (``propagators``). Edges of the input inside a step
add what their jumps of signals do until its end. Blocks of such steps are computed with the modes held, then the
switching functions are looked at in all of them; a step in which one may leave its side is done once more, in parts,
and where it does, the steps behind it are dropped.

Steps of any length (``step_to``) are Taylor series between the edges of the input and the events. Modes are held on
each part of a step. Where a switching function leaves its side, the part ends at the located crossing, the mode flips,
and the matrices of the new modes carry on. So also where an edge of the input throws a switch over: that takes no time.
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
    """Division of a run into steps, and space for a block of them.

    Every distance of samples of ``parts`` times the propagators' step is cut into so many steps; samples with another
    distance to the next are in ``odd``, and the last one. ``slack`` (s) is how far times are rounded. ``wave`` is the
    number of each piece's angular frequency, ``reached`` the piece of each track at the end of a block. At the nodes
    of a block: ``clock`` (s), ``rows`` (states), ``signals`` of the tracks, and, an element a row, ``x``, ``u`` and the
    switching functions ``g``; ``jumps`` (for each signal) are what edges make of it inside the step to a node, and
    ``most`` the largest in the block; ``thrown`` and ``most_thrown`` those on the node itself.
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
    """Plan an exact run with samples at ``times``; None where a piece is circular, or where it takes too many steps.

    The problem's modes are those at the start; ``slopes`` is how many quantities the native function of slopes
    differentiates.
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
    """Number of signals that each track needs: its inputs, and derivatives up to the last that does not vanish."""
    bent = cubic = False
    if tracks.kind.any() or tracks.coefficients[:, 2:].any():
        bent = bool((tracks.kind == 1).any() or tracks.coefficients[:, 2].any())
        cubic = bool(((tracks.kind == 0) & (tracks.coefficients[:, 3] != 0.0)).any())
    return max(4 if cubic else 3 if bent else 2, inputs // max(len(tracks.rate), 1))


def spacing(times: Array) -> tuple[float, Integers]:
    """Typical distance of samples (s), and the samples after which the distance changes, including the last one.

    What many runs share, such as times that nobody can change, is looked at once.
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
    """How far times are rounded, s."""
    return 1e-12 * max(1.0, abs(float(times[-1])))


def typical_step(times: Array, distances: Array) -> float:
    """The most frequent distance between samples (s)."""
    whole = distances[:-1] if len(distances) > 1 else distances  # the last one may be shorter
    if np.max(np.abs(whole - whole[0])) <= 1e-12 * max(1.0, abs(times[-1])):
        return float((times[len(whole)] - times[0]) / len(whole))
    return float(np.median(distances))


def parts_for(z: float, watched: bool) -> int:
    """Steps between two samples, over which the fastest motion goes through ``z`` radians."""
    if watched:  # short enough that the switches between two looks are nearly parabolas
        return max(1, math.ceil(min(z / WATCHED, 1e9)))
    return max(1, math.ceil(z)) if z <= _MAX_PARTS else 1


def rate_bound_of(problem: Problem, props: Propagators) -> float:
    """Bound of the rates with the modes at the start, with all ones and with none."""
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
    """A run and its blocks, for the loops."""

    run: Run
    blocks: Blocks


def propagate(
    problem: Problem, control: Control, plan: Plan, out: Samples, counts: Integers
) -> int:
    """Fill the arrays at every sample; give a status code.

    At an input edge the samples are those just after it. ``counts`` gets steps, rejected steps (none) and events.
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
