"""A controller around the model: at fixed instants it sees the outputs and sets what some tracks hold until the next.

The law is one native function ``f(memory, measured, p, m, out)``; ``out`` is the commands, then the next memory. It is
compiled from a graph like all others, or it is the address of a Python function made callable from outside.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.kernel.call import call_many, call_native, part
from jounce.kernel.layout import STATE
from jounce.kernel.tracks import fill

REGULATED, DIVERGED, NO_COMMAND = 0, 8, 9


class Feedback(NamedTuple):
    """Law, what it is fed, and its arrays (all but the first eight are scratch).

    Attributes
    ----------
    law : int
        Address of the law; 0 where there is no controller.
    period : float
        Distance of the control instants, s.
    pieces : ndarray of int64
        Piece of each command's track: its only one, whose value is set.
    select : ndarray of int64
        Output behind each measurement.
    offset : ndarray
        Taken from each measurement.
    noise : ndarray, shape (instants, measurements)
        Added to each measurement; no rows: none.
    bound : ndarray
        How far each state may go from where the run started before it counts as diverging.
    p : ndarray
        Parameters of the law.
    memory : ndarray, shape (1, n)
        State of the law, from one instant to the next.
    measured : ndarray
        Measurements, then the time (s).
    result : ndarray, shape (1, commands + n)
        What the law gives.
    time, states, inputs, outputs : ndarray
        Where the model is evaluated: columns.
    instants : ndarray of int64, shape (1,)
        Instants so far.
    """

    law: int
    period: float
    pieces: NDArray[np.int64]
    select: NDArray[np.int64]
    offset: Array
    noise: Array
    bound: Array
    p: Array
    memory: Array
    measured: Array
    result: Array
    time: Array
    states: Array
    inputs: Array
    outputs: Array
    instants: NDArray[np.int64]


_ROW, _COLUMN, _FLAT, _NUMBERS = np.zeros((1, 0)), np.zeros((0, 1)), np.zeros(0), np.zeros(0, dtype=np.int64)
NO_FEEDBACK = Feedback(
    0, 1.0, _NUMBERS, _NUMBERS, _FLAT, np.zeros((0, 0)), _FLAT, _FLAT, _ROW, _FLAT, _ROW, _FLAT, _COLUMN, _COLUMN,
    _COLUMN, _NUMBERS,
)  # fmt: skip


def feedback(
    law: int,
    period: float,
    *,
    pieces: NDArray[np.int64],
    select: NDArray[np.int64],
    offset: Array,
    noise: Array,
    bound: Array,
    p: Array,
    counts: tuple[int, int, int],
) -> Feedback:
    """Make the arrays around a law, for ``counts`` of memory, inputs and outputs; the others are as in the class."""
    memory, inputs, outputs = counts
    scratch = (
        np.zeros((1, memory)),
        np.zeros(len(select) + 1),
        np.zeros((1, len(pieces) + memory)),
        np.zeros(1),
        np.zeros((len(bound), 1)),
        np.zeros((inputs, 1)),
        np.zeros((outputs, 1)),
        np.zeros(1, dtype=np.int64),
    )
    return Feedback(law, period, pieces, select, offset, noise, bound, p, *scratch)


@part()
def regulate(problem: Any, control: Any, rows: Any, t: float) -> int:
    """Measure at ``t``, call the law, set the commands; tell how that ended."""
    for d in range(len(control.bound)):
        control.states[d, 0] = rows[STATE, d]
        if abs(rows[STATE, d] - problem.x0[d]) > control.bound[d]:
            return DIVERGED
    control.time[0] = t
    fill(problem.tracks, problem.piece, control.time, control.inputs)
    call_many(problem.engine.output, control.states, control.inputs, problem.p, problem.m, control.outputs, 0, 1)
    instant, count = control.instants[0], len(control.select)
    for j in range(count):
        control.measured[j] = control.outputs[control.select[j], 0] - control.offset[j]
    if instant < control.noise.shape[0]:
        for j in range(count):
            control.measured[j] += control.noise[instant, j]
    control.measured[count] = t
    call_native(control.law, control.memory, 0, control.measured, control.p, problem.m, control.result, 0)
    commands = len(control.pieces)
    for k in range(commands):
        if not math.isfinite(control.result[0, k]):
            return NO_COMMAND
        problem.tracks.coefficients[control.pieces[k], 0] = control.result[0, k]
    for k in range(control.memory.shape[1]):
        control.memory[0, k] = control.result[0, commands + k]
    control.instants[0] = instant + 1
    return REGULATED
