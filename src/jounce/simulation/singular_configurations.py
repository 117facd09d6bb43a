"""Runs of mechanisms through poses in which their loops do not say how they go on.

On both sides of such a pose the motion is smooth, but close to it rounding decides: steps shrink without end, or the
mechanism leaves the branch it was on and its energy jumps. Both are noticed. The run then begins again a little before
with other steps, and steps that do not end close to the pose pass it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.kernel.engine import Status
from jounce.mechanics.mechanism import BALANCE
from jounce.simulation.prepare import Prepared
from jounce.simulation.result import Solution

_LOST = 1e-3  # share of the largest kinetic energy that no error may make come or go in the loops
_STILL = 1e-12  # J: less than that is nothing
_KINK = 1e-9  # change of a rate that counts as one
_BEFORE = (1, 2, 4, 8, 16, 32, 3, 6, 12, 24, 48, 5, 7, 14, 28)  # samples from which a pose is tried again
_LOOSER = (*(1.0,) * 3, *(10.0,) * 3, *(100.0,) * 3, *(1e3,) * 3, *(1e4,) * 3)  # times the tolerance, until past it
_LOOSEST = 1e-5
_AHEAD, _WIDTH, _NODES = (2, 4, 8), 8, 13  # samples to be carried over a pose, those before it in them, points of those
_ON_CURVE, _CLOSINGS = 1e-4, 4  # how far from closed loops, relative to the state, a curve may end
_PAST = 2  # samples
_CROSSINGS = 1000
_LOST_WAY = (Status.LOCKED_UP, Status.STEP_TOO_SMALL, Status.NOT_FINITE)

Begin = Callable[[Array, Array, float], Prepared]
"""A run from a state at the first of some times (s) with a tolerance."""


def run_through(
    begin: Begin, x: Array, times: Array, tolerance: float, tracks: list[Segments]
) -> tuple[Solution, tuple[float, ...]]:
    """Run a mechanism with loops, through singular configurations where it gets through.

    Gives the run, and the times (s) about which it was taken through one by other steps.
    """
    strict = not any(_has_kinks(track) for track in tracks)
    first = _judged(begin(x, times, tolerance), tolerance, strict=strict)
    whole, reached, crossings = first, _reached(first), []
    for _ in range(_CROSSINGS):
        if whole.status not in _LOST_WAY or not strict:
            break
        past = _passed(begin, whole, reached, tolerance)
        if past is None:
            break
        crossings.append(float(times[reached - 1]))
        at = _reached(past) - 1
        rest = _judged(begin(past.states[:, at], times[at:], tolerance), tolerance, strict=strict)
        whole, reached = _joined(past, rest, at), at + _reached(rest)
    return whole, tuple(crossings)


def _passed(begin: Begin, run: Solution, reached: int, tolerance: float) -> Solution | None:
    """The run with some samples more, past the pose where it ended; None where no steps get past it."""
    for back, looser in zip(_BEFORE, _LOOSER, strict=True):
        at, end = max(reached - 1 - back, 0), min(reached + _PAST, len(run.time))
        loose = max(min(looser * tolerance, _LOOSEST), tolerance)
        part = _judged(begin(run.states[:, at], run.time[at:end], loose), loose, strict=True)
        if part.status is Status.COMPLETED:
            return _joined(run, part, at)
    return next(filter(None, (_carried_over(begin, run, reached, ahead, tolerance) for ahead in _AHEAD)), None)


def _carried_over(begin: Begin, run: Solution, reached: int, ahead: int, tolerance: float) -> Solution | None:
    """The run carried over a pose along the smooth curve it was on; None where that leads nowhere.

    Where two ways to move meet (two hinges of a loop come onto one line, so that what is between them could also swing
    like a door), every state a little off the curve belongs to neither way, and no step gets through. The motion itself
    is smooth there: a polynomial through what came before goes on where momentum takes it. It is only taken where it
    closes the loops on the other side and keeps the energy.
    """
    last, target = reached - 1, reached - 1 + ahead
    width = min(_WIDTH * ahead, last)
    if target + _PAST >= len(run.time) or width < ahead:
        return None
    begins, ends = float(run.time[last - width]), float(run.time[last])
    nodes = 0.5 * (begins + ends) - 0.5 * (ends - begins) * np.cos(np.pi * np.arange(_NODES) / (_NODES - 1))
    before = begin(run.states[:, last - width], nodes, tolerance).run()
    if _reached(before) < _NODES:
        return None
    from scipy.interpolate import BarycentricInterpolator

    curve = BarycentricInterpolator(nodes, before.states, axis=1)
    states, outputs = run.states.copy(), run.outputs.copy()
    for i in range(last + 1, target + 1):
        x = curve(run.time[i])
        there = begin(x, run.time[i : i + _PAST], tolerance)
        compiled, fixed = there.compiled, (there.still, there.problem.p, there.problem.m)
        closed = x
        for _ in range(_CLOSINGS):
            closed = compiled.projected(closed, *fixed)
        if not np.max(np.abs(closed - x)) < _ON_CURVE * (1.0 + np.max(np.abs(x))):
            return None
        states[:, i], outputs[:, i] = closed, compiled.evaluate("output", closed, *fixed)
    rest = _judged(begin(states[:, target], run.time[target : target + _PAST + 1], tolerance), tolerance, strict=True)
    names = there.compiled.output_names
    balance, taken = outputs[names.index(BALANCE)], states[there.compiled.facts.states.index(BALANCE)]
    size = abs(balance[target] + taken[target]) + abs(taken[target] - taken[0]) + _STILL
    if rest.status is not Status.COMPLETED or abs(balance[target] - balance[last]) > _LOST * size:
        return None
    return _joined(replace(run, states=states, outputs=outputs), rest, target)


def _joined(run: Solution, part: Solution, at: int) -> Solution:
    """A run up to the sample ``at``, and from there another one."""
    states, outputs = (np.full_like(whole, np.nan) for whole in (run.states, run.outputs))
    states[:, :at], outputs[:, :at] = run.states[:, :at], run.outputs[:, :at]
    end = at + len(part.time)
    states[:, at:end], outputs[:, at:end] = part.states, part.outputs
    steps, rejected, events = (getattr(run, name) + getattr(part, name) for name in ("steps", "rejected", "events"))
    return replace(
        run, states=states, outputs=outputs, status=part.status, steps=steps, rejected=rejected, events=events
    )


def _judged(prepared: Prepared, tolerance: float, *, strict: bool) -> Solution:
    """Run, and end the run where its energy jumped."""
    solution, facts = prepared.run(), prepared.compiled.facts
    states = solution.states.copy()
    outputs, reached = solution.outputs.copy(), _reached(solution)
    if strict and BALANCE in facts.internal and reached:
        balance = outputs[prepared.compiled.output_names.index(BALANCE), :reached]
        taken = states[facts.states.index(BALANCE), :reached]
        size = np.maximum.accumulate(np.abs(balance + taken)) + np.maximum.accumulate(np.abs(taken - taken[0])) + _STILL
        wrong = np.abs(balance - balance[0]) > max(_LOST, 100.0 * tolerance) * size
        if wrong.any():
            states[:, int(np.argmax(wrong)) :] = np.nan
            return replace(solution, states=states, outputs=outputs, status=Status.LOCKED_UP)
    return replace(solution, states=states, outputs=outputs)


def _reached(solution: Solution) -> int:
    """Number of samples that were computed."""
    return int(np.sum(np.isfinite(solution.states[0])))


def _has_kinks(track: Segments) -> bool:
    """Whether a motion changes its rate at once somewhere: what it drives is struck there."""
    inner = track.edges[1:-1]
    before, after = track.evaluate(np.nextafter(inner, -np.inf))[1], track.evaluate(inner)[1]
    return bool(np.any(np.abs(after - before) > _KINK * (1.0 + np.abs(after))))
