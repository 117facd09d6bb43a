"""What a run gives at its samples: states on a step's interpolant, inputs, outputs, and sensitivities of both."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.kernel.call import call_many, call_native, part
from jounce.kernel.layout import DENSE, STATE, TRIAL
from jounce.kernel.tracks import fill

Array = NDArray[np.float64]
_NONE = np.zeros((0, 0))


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


@part(fastmath={"contract"})
def _interpolate(rows: Any, t: float, h: float, times: Any, first: int, last: int, states: Any) -> None:
    """States at the samples ``first`` to ``last``, on the step from ``t``."""
    for d in range(states.shape[0]):
        x, c0, c1, c2 = rows[STATE, d], rows[DENSE, d], rows[DENSE + 1, d], rows[DENSE + 2, d]
        c3, c4, c5, c6 = rows[DENSE + 3, d], rows[DENSE + 4, d], rows[DENSE + 5, d], rows[DENSE + 6, d]
        for i in range(first, last):
            theta = (times[i] - t) / h
            rest = 1.0 - theta
            y = (((c6 * theta + c5) * rest + c4) * theta + c3) * rest
            states[d, i] = x + (((y + c2) * theta + c1) * rest + c0) * theta


@part(fastmath={"contract"})
def _interpolate_behind(rows: Any, theta: float, first: int, to: Any) -> None:
    """Elements from ``first`` on of the state row at a fraction of the step, in the same elements of the row ``to``."""
    rest = 1.0 - theta
    for d in range(first, rows.shape[1]):
        y = (rows[DENSE + 6, d] * theta + rows[DENSE + 5, d]) * rest + rows[DENSE + 4, d]
        y = (y * theta + rows[DENSE + 3, d]) * rest + rows[DENSE + 2, d]
        to[d] = rows[STATE, d] + ((y * theta + rows[DENSE + 1, d]) * rest + rows[DENSE, d]) * theta


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
        for d in range(n):
            rows[TRIAL, d] = out.states[d, i]
        _interpolate_behind(rows, (out.times[i] - t) / h, n, rows[TRIAL])
        for d in range(n, rows.shape[1]):
            out.tangents[i, d - n] = rows[TRIAL, d]
        for k in range(out.inputs.shape[0]):
            work.sampled[k, 0] = out.inputs[k, i]
        call_native(problem.engine.output, rows, TRIAL, work.sampled, problem.p, problem.m, out.carried, i)
        for k in range(out.outputs.shape[0]):
            out.outputs[k, i] = out.carried[i, k]


@part(forceinline=True)
def sample_step(problem: Any, work: Any, t: float, h: float, until: float, first: int, out: Any) -> int:
    """Write states, inputs and outputs at all times before ``until`` on the step from ``t``; give the next sample."""
    last = first
    while last < len(out.times) and out.times[last] < until:
        last += 1
    if last > first:
        fill(problem.tracks, problem.piece, out.times[first:last], out.inputs[:, first:last])
        _interpolate(work.rows, t, h, out.times, first, last, out.states)
        if problem.engine.project_many != 0:
            _project_samples(problem, out, first, last)
        if out.tangents.shape[1] > 0:
            _carry_samples(problem, work, t, h, first, last, out)
        else:
            call_many(
                problem.engine.output, out.states, out.inputs, problem.p, problem.m, out.outputs, first, last - first
            )
    return last
