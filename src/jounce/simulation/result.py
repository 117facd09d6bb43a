"""Result of a run: its arrays, its status, and checks that it is still valid for a suspension."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.kernel.engine import Status
from jounce.mechanics.facts import ModelFacts
from jounce.simulation.compiled import Compiled

_TURNED = 0.6  # rad: a larger change of camber or steer (34 degrees) indicates a different branch of the linkage
_STEERED = 1.0  # rad: no rack steers by 57 degrees at rest
_APART = 10.0  # m: no strut is that long
_TURNS = ("body.pitch", "body.roll")  # a car rotated by more than 1 rad has rolled over
_ANGLES = ("wheel.camber", "wheel.steer")


@dataclass(frozen=True)
class Solution:
    """Arrays of one run.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Output times, s.
    states, outputs : ndarray, shape (n_states, n), (n_outputs, n)
        One row for each signal, SI.
    status : Status
        How the run ended.
    steps, rejected, events : int
        Steps accepted and rejected, events handled.
    state_slopes, output_slopes : ndarray, shape (n_states, n_free, n), (n_outputs, n_free, n)
        Sensitivities to the free parameters, SI.
    method : {"exact", "explicit", "implicit", "reduced explicit", "reduced implicit"}
        Method of integration.
    """

    time: Array
    states: Array
    outputs: Array
    status: Status
    steps: int
    rejected: int
    events: int
    state_slopes: Array
    output_slopes: Array
    method: str


def samples_reached(solution: Solution, facts: ModelFacts, *, check: bool) -> int:
    """Return the number of computed samples; with ``check`` raise an error unless all were computed."""
    if solution.status is Status.COMPLETED:
        return len(solution.time)
    reached = int(np.sum(np.isfinite(solution.states[0])))
    if check:
        at = max(reached - 1, 0)
        last = f"it stopped after {solution.time[at]:.4g} s: {solution.status.help}{_pose(solution, facts, at)}"
        raise SimulationError(Phrase("the run did not reach its end; {last}", last=last))
    return reached


def _pose(solution: Solution, facts: ModelFacts, at: int) -> str:
    """Describe the pose of a mechanism at a sample, if the mechanism stopped the run."""
    if solution.status not in (Status.LOOP_OPENED, Status.LOCKED_UP, Status.FLIPPED):
        return ""
    values = zip(facts.coordinates, solution.states[:, at], strict=False)
    return "; pose: " + ", ".join(f"{name} = {value:.5g}" for name, value in values)


def cut_at_branch(compiled: Compiled, solution: Solution) -> Solution:
    """Truncate a run when a wheel flips over or a suspension runs away, and set the status accordingly."""
    left, status = flipped_at(compiled.output_names, solution.outputs), Status.FLIPPED
    if left is None and solution.status in (Status.COMPLETED, Status.NOT_FINITE):
        left, status = ran_away_at(compiled.output_names, solution.outputs), Status.RUN_AWAY
    if left is None:
        return solution
    solution.states[:, left + 1 :] = np.nan
    return replace(solution, status=status)


def flipped_at(names: tuple[str, ...], outputs: Array) -> int | None:
    """Return the first sample at which the wheel has flipped over, None if it never does.

    Rows of ``outputs`` (SI) are channels in the order of ``names``; the first sample is the initial state of rest.
    """
    first: int | None = None
    for row, name in enumerate(names):
        if not name.endswith(_ANGLES):
            continue
        angle = outputs[row]
        is_flipped = np.abs(np.angle(np.exp(1j * (angle - angle[0])))) > _TURNED
        if abs(angle[0]) > _STEERED:
            is_flipped[0] = True
        if is_flipped.any():
            sample = int(np.argmax(is_flipped))
            first = sample if first is None else min(first, sample)
    return first


def angles_of(names: tuple[str, ...]) -> list[str]:
    """Return the channels that show whether a wheel has flipped over."""
    return [name for name in names if name.endswith(_ANGLES)]


def turns_little(courses: Array) -> NDArray[np.bool_]:
    """Return which signals of such a channel (rad, one per row) vary so little that no wheel has flipped over.

    :func:`flipped_at` decides for the others, whose angle may also have wrapped at half a turn.
    """
    first = courses[:, 0]
    largest = np.maximum(courses.max(axis=1) - first, first - courses.min(axis=1))
    return np.asarray((largest <= _TURNED) & (np.abs(first) <= _STEERED))


def ran_away_at(names: tuple[str, ...], outputs: Array) -> int | None:
    """Return the first sample at which a strut deflects by more than 10 m or the body rotates by more than 1 rad.

    None if there is no such sample. Arguments as for :func:`flipped_at`.
    """
    first: int | None = None
    for row, limit in branch_limits(names).items():
        course = outputs[row]
        if course.max() <= limit and course.min() >= -limit:  # false for NaN
            continue
        beyond = np.abs(course) > limit
        if beyond.any():
            sample = int(np.argmax(beyond))
            first = sample if first is None else min(first, sample)
    return first


def branch_limits(names: tuple[str, ...]) -> dict[int, float]:
    """Return the validity limit (SI) of channels, by their row in ``names``."""
    limits = {row: 1.0 for row, name in enumerate(names) if name in _TURNS}
    return limits | {
        row: _APART for row, name in enumerate(names) if name.endswith("strut.deflection")
    }
