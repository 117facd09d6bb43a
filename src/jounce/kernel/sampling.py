"""What a run gives at its samples: states on a step's interpolant, inputs, outputs, and sensitivities of both."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from jounce.core.types import Array
from jounce.kernel.call import call_many, call_native, call_step, part
from jounce.kernel.layout import TRIAL
from jounce.kernel.tracks import fill

_NONE = np.zeros((0, 0))
_BLOCK = 256
"""Samples whose outputs are computed at once."""


class Samples(NamedTuple):
    """Where the run is sampled and the arrays it fills: one row an element, one column a sample.

    ``projected`` has two rows more than ``states`` where the model projects, and none elsewhere. With sensitivities,
    ``tangents`` has one row a sample of those of the states, and ``carried`` one of the outputs and their
    sensitivities; both run through the parameters fastest.
    """

    times: Array
    states: Array
    inputs: Array
    outputs: Array
    projected: Array
    tangents: Array = _NONE
    carried: Array = _NONE


@part()
def _interpolate(problem: Any, work: Any, t: float, h: float, first: int, last: int, out: Any) -> None:
    """States at the samples ``first`` to ``last``, on the step from ``t``."""
    for i in range(first, last):
        call_step(problem.engine.point_at, work.rows, work.u, problem.p, problem.m, work.g, (out.times[i] - t) / h)
        for d in range(out.states.shape[0]):
            out.states[d, i] = work.rows[TRIAL, d]


@part()
def _project_samples(problem: Any, out: Any, first: int, last: int) -> None:
    """Move the samples ``first`` to ``last`` onto the constraints."""
    address, count = problem.engine.project_many, last - first
    call_many(address, out.states, out.inputs, problem.p, problem.m, out.projected, first, count)
    for d in range(out.states.shape[0]):
        for i in range(first, last):
            out.states[d, i] = out.projected[2 + d, i]


@part()
def _carry_samples(problem: Any, work: Any, t: float, h: float, first: int, last: int, out: Any) -> None:
    """Outputs at the samples ``first`` to ``last`` with the sensitivities of states and outputs."""
    n, rows = out.states.shape[0], work.rows
    for i in range(first, last):
        call_step(problem.engine.point_at, rows, work.u, problem.p, problem.m, work.g, (out.times[i] - t) / h)
        for d in range(n):
            rows[TRIAL, d] = out.states[d, i]
        for d in range(n, rows.shape[1]):
            out.tangents[i, d - n] = rows[TRIAL, d]
        for k in range(out.inputs.shape[0]):
            work.sampled[k, 0] = out.inputs[k, i]
        call_native(problem.engine.output, rows, TRIAL, work.sampled, problem.p, problem.m, out.carried, i)
        for k in range(out.outputs.shape[0]):
            out.outputs[k, i] = out.carried[i, k]


@part()
def finish_samples(problem: Any, work: Any, out: Any) -> None:
    """Move the samples placed since the last time onto the constraints, and write their outputs.

    That is done for many samples at once: native code takes several side by side. The modes must be those of the steps.
    """
    first, count = work.marks[1], work.marks[0] - work.marks[1]
    if count == 0:
        return
    work.marks[1] += count
    if problem.engine.project_many != 0:
        _project_samples(problem, out, first, first + count)
    if out.tangents.shape[1] == 0:
        call_many(problem.engine.output, out.states, out.inputs, problem.p, problem.m, out.outputs, first, count)


@part(forceinline=True)
def place_samples(problem: Any, work: Any, t: float, h: float, until: float, out: Any) -> None:
    """Write states and inputs at all times before ``until`` on the step from ``t``; outputs follow block by block."""
    first = last = work.marks[0]
    while last < len(out.times) and out.times[last] < until:
        last += 1
    if last > first:
        fill(problem.tracks, problem.piece, out.times[first:last], out.inputs[:, first:last])
        _interpolate(problem, work, t, h, first, last, out)
        work.marks[0] = last
        if out.tangents.shape[1] > 0:
            finish_samples(problem, work, out)
            _carry_samples(problem, work, t, h, first, last, out)
        elif last - work.marks[1] >= _BLOCK:
            finish_samples(problem, work, out)
