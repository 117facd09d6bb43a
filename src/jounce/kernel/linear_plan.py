"""Laying out an exact run: how long its steps are, and room for a block of them."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.kernel.call import compiled
from jounce.kernel.explicit import Control, Problem
from jounce.kernel.linear_steps import WATCHED
from jounce.kernel.propagators import Calls, Propagators, pace_of, propagators, read_slopes
from jounce.kernel.tracks import Tracks

BLOCK = 192
"""Most steps in a block, whose scratch arrays should stay in the cache."""
_MAX_WAVES, _MAX_PARTS, _MAX_STEPS = 8, 64, 20_000_000


class Blocks(NamedTuple):
    """How a run is cut up, and room for a block of steps.

    Every distance of samples of ``parts`` times the propagators' step is cut into so many steps; samples with another
    distance to the next are in ``odd``, and the last one. ``slack`` (s) is how far times are rounded. ``wave`` is the
    number of each piece's angular frequency, ``reached`` the piece of each track at the end of a block. At the nodes
    of a block: ``clock`` (s), ``rows`` (states), ``signals`` of the tracks, and, an element a row, ``x``, ``u`` and the
    switching functions ``g``; ``jumps`` (for each signal) are what edges make of it inside the step to a node, and
    ``most`` the largest in the block.
    """

    parts: int
    slack: float
    odd: NDArray[np.int64]
    wave: NDArray[np.int64]
    reached: NDArray[np.int64]
    clock: Array
    rows: Array
    signals: Array
    x: Array
    u: Array
    g: Array
    jumps: Array
    most: Array


class Plan(NamedTuple):
    """Propagators, and the blocks of their steps."""

    props: Propagators
    blocks: Blocks


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
    nodes, rows = BLOCK + 1, count * props.layout.signals
    slack = 1e-12 * max(1.0, abs(times[-1]))
    odd = np.flatnonzero(np.abs(np.diff(times) - typical) > slack)
    blocks = Blocks(
        parts,
        slack,
        np.append(odd, len(times) - 1),
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
    )
    return Plan(props._replace(step=typical / parts), blocks)


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
