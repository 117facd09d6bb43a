"""Runs of mechanisms through poses in which their loops do not determine the motion.

On both sides of such a pose the motion is smooth, but close to it rounding errors dominate: steps shrink indefinitely,
or the mechanism leaves its branch and its energy jumps. Both cases are detected. The run then restarts a little earlier
with different steps; steps that do not end close to the pose pass it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.kernel.engine import Status
from jounce.mechanics.mechanism import BALANCE
from jounce.simulation.prepare import PreparedRun
from jounce.simulation.result import Solution

_LOST = 1e-3  # share of the largest kinetic energy by which the energy balance may jump
_STILL = 1e-12  # J: smaller energies are zero
_KINK = 1e-9  # change of a rate that counts as a kink
_BEFORE = (
    1,
    2,
    4,
    8,
    16,
    32,
    3,
    6,
    12,
    24,
    48,
    5,
    7,
    14,
    28,
)  # number of samples before the pose at which the run restarts
_LOOSER = (
    *(1.0,) * 3,
    *(10.0,) * 3,
    *(100.0,) * 3,
    *(1e3,) * 3,
    *(1e4,) * 3,
)  # factors of the tolerance, until past the pose
_LOOSEST = 1e-5  # tolerance of such a step
# samples carried over a pose; samples before it for each; interpolation nodes
_AHEAD, _WIDTH, _NODES = (2, 4, 8), 8, 13
# distance from closed loops, relative to the state, at which a curve may end; projections
_ON_CURVE, _CLOSINGS = 1e-4, 4
_PAST = 2  # samples beyond the pose that must succeed
_CROSSINGS = 1000  # maximum number of crossings in one run
_LOST_WAY = (Status.LOCKED_UP, Status.STEP_TOO_SMALL, Status.NOT_FINITE)

Begin = Callable[[Array, Array, float], PreparedRun]
"""Function that prepares a run from a state at the first of given times (s) with a tolerance."""


def run_through(
    begin: Begin, x: Array, times: Array, tolerance: float, tracks: list[Segments]
) -> tuple[Solution, tuple[float, ...]]:
    """Run a mechanism with loops, through singular configurations if possible.

    Returns the run, and the times (s) at which it passed a singular configuration with modified steps.
    """
    strict = not any(_has_kinks(track) for track in tracks)
    first = _run_and_judge(begin(x, times, tolerance), tolerance, strict=strict)
    run, reached, crossings = first, _sample_count(first), []
    for _ in range(_CROSSINGS):
        if run.status not in _LOST_WAY or not strict:
            break
        past = _pass_pose(begin, run, reached, tolerance)
        if past is None:
            break
        crossings.append(float(times[reached - 1]))
        at = _sample_count(past) - 1
        remainder = _run_and_judge(
            begin(past.states[:, at], times[at:], tolerance), tolerance, strict=strict
        )
        run, reached = _join(past, remainder, at), at + _sample_count(remainder)
    return run, tuple(crossings)


def _pass_pose(begin: Begin, run: Solution, reached: int, tolerance: float) -> Solution | None:
    """Extend the run by some samples past the pose where it ended; return None if no steps pass it."""
    for back, looser in zip(_BEFORE, _LOOSER, strict=True):
        at, end = max(reached - 1 - back, 0), min(reached + _PAST, len(run.time))
        loose = max(min(looser * tolerance, _LOOSEST), tolerance)
        part = _run_and_judge(begin(run.states[:, at], run.time[at:end], loose), loose, strict=True)
        if part.status is Status.COMPLETED:
            return _join(run, part, at)
    return next(
        filter(None, (_carried_over(begin, run, reached, ahead, tolerance) for ahead in _AHEAD)),
        None,
    )


def _carried_over(
    begin: Begin, run: Solution, reached: int, ahead: int, tolerance: float
) -> Solution | None:
    """Continue the run over a pose along its smooth curve; return None if that fails.

    Where two branches of motion meet (two hinges of a loop become collinear, and the part between them could also swing
    like a door), every state slightly off the curve belongs to neither branch, and no step succeeds. The motion itself
    is smooth: a polynomial through the preceding motion extrapolates it. The result is accepted only if it closes the
    loops on the other side and conserves the energy.
    """
    last, target = reached - 1, reached - 1 + ahead
    width = min(_WIDTH * ahead, last)
    if target + _PAST >= len(run.time) or width < ahead:
        return None
    begins, ends = float(run.time[last - width]), float(run.time[last])
    nodes = 0.5 * (begins + ends) - 0.5 * (ends - begins) * np.cos(
        np.pi * np.arange(_NODES) / (_NODES - 1)
    )
    before = begin(run.states[:, last - width], nodes, tolerance).run()
    if _sample_count(before) < _NODES:
        return None
    from scipy.interpolate import BarycentricInterpolator

    curve = BarycentricInterpolator(nodes, before.states, axis=1)
    states, outputs = run.states.copy(), run.outputs.copy()
    for i in range(last + 1, target + 1):
        x = curve(run.time[i])
        at_pose = begin(x, run.time[i : i + _PAST], tolerance)
        compiled, fixed = at_pose.compiled, (at_pose.still, at_pose.problem.p, at_pose.problem.m)
        closed = x
        for _ in range(_CLOSINGS):
            closed = compiled.project(closed, *fixed)
        if not np.max(np.abs(closed - x)) < _ON_CURVE * (1.0 + np.max(np.abs(x))):
            return None
        states[:, i], outputs[:, i] = closed, compiled.evaluate("output", closed, *fixed)
    times = run.time[target : target + _PAST + 1]
    remainder = _run_and_judge(begin(states[:, target], times, tolerance), tolerance, strict=True)
    names = at_pose.compiled.output_names
    balance, taken = (
        outputs[names.index(BALANCE)],
        states[at_pose.compiled.facts.states.index(BALANCE)],
    )
    size = abs(balance[target] + taken[target]) + abs(taken[target] - taken[0]) + _STILL
    if (
        remainder.status is not Status.COMPLETED
        or abs(balance[target] - balance[last]) > _LOST * size
    ):
        return None
    return _join(replace(run, states=states, outputs=outputs), remainder, target)


def _join(run: Solution, part: Solution, at: int) -> Solution:
    """Concatenate a run up to the sample ``at`` and its continuation."""
    states, outputs = (np.full_like(table, np.nan) for table in (run.states, run.outputs))
    states[:, :at], outputs[:, :at] = run.states[:, :at], run.outputs[:, :at]
    end = at + len(part.time)
    states[:, at:end], outputs[:, at:end] = part.states, part.outputs
    steps, rejected, events = (
        getattr(run, name) + getattr(part, name) for name in ("steps", "rejected", "events")
    )
    return replace(
        run,
        states=states,
        outputs=outputs,
        status=part.status,
        steps=steps,
        rejected=rejected,
        events=events,
    )


def _run_and_judge(prepared: PreparedRun, tolerance: float, *, strict: bool) -> Solution:
    """Run, and truncate the result where its energy jumps."""
    solution, facts = prepared.run(), prepared.compiled.facts
    states = solution.states.copy()
    outputs, reached = solution.outputs.copy(), _sample_count(solution)
    if strict and BALANCE in facts.internal and reached:
        balance = outputs[prepared.compiled.output_names.index(BALANCE), :reached]
        taken = states[facts.states.index(BALANCE), :reached]
        size = (
            np.maximum.accumulate(np.abs(balance + taken))
            + np.maximum.accumulate(np.abs(taken - taken[0]))
            + _STILL
        )
        # The balance is integrated like the state; errors of many steps exceed the tolerance of one step.
        wrong = np.abs(balance - balance[0]) > max(_LOST, 100.0 * tolerance) * size
        if wrong.any():
            states[:, int(np.argmax(wrong)) :] = np.nan
            return replace(solution, states=states, outputs=outputs, status=Status.LOCKED_UP)
    return replace(solution, states=states, outputs=outputs)


def _sample_count(solution: Solution) -> int:
    """Return the number of computed samples."""
    return int(np.sum(np.isfinite(solution.states[0])))


def _has_kinks(track: Segments) -> bool:
    """Whether the rate of a motion jumps at any time, which causes an impact."""
    inner = track.edges[1:-1]
    before, after = track.evaluate(np.nextafter(inner, -np.inf))[1], track.evaluate(inner)[1]
    return bool(np.any(np.abs(after - before) > _KINK * (1.0 + np.abs(after))))
