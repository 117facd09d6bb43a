"""What a run gives: its arrays, how it ended, and whether what they show is still a suspension."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.kernel.engine import Status
from jounce.mechanics.facts import Facts
from jounce.simulation.compiled import Compiled

_TURNED = 0.6  # rad: camber or steer that moves so far in a run belongs to another way of assembling the linkage
_STEERED = 1.0  # rad: steer at rest that no rack makes
_APART = 10.0  # m: no strut is that long
_TURNS = ("body.pitch", "body.roll")  # rad: a car that has turned that far lies on its roof
_ANGLES = ("wheel.camber", "wheel.steer")


@dataclass(frozen=True)
class Solution:
    """Arrays of one run.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Output times, s.
    states, outputs : ndarray, shape (n_states, n), (n_outputs, n)
        One row a signal, SI.
    status : Status
        How the run ended.
    steps, rejected, events : int
        Work done.
    state_slopes, output_slopes : ndarray, shape (n_states, n_free, n), (n_outputs, n_free, n)
        Sensitivities to the free parameters, SI.
    method : {"exact", "explicit", "implicit", "reduced explicit", "reduced implicit"}
        What computed them.
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


def samples_reached(solution: Solution, facts: Facts, *, check: bool) -> int:
    """Number of samples that were computed; all of them, or an error with ``check``."""
    if solution.status is Status.COMPLETED:
        return len(solution.time)
    reached = int(np.sum(np.isfinite(solution.states[0])))
    if check:
        at = max(reached - 1, 0)
        last = f"it stopped after {solution.time[at]:.4g} s: {solution.status.help}{_pose(solution, facts, at)}"
        raise SimulationError(f"the run did not reach its end; {last}")
    return reached


def _pose(solution: Solution, facts: Facts, at: int) -> str:
    """Pose of a mechanism at a sample, where the mechanism is what stopped the run."""
    if solution.status not in (Status.LOOP_OPENED, Status.LOCKED_UP, Status.FLIPPED):
        return ""
    values = zip(facts.coordinates, solution.states[:, at], strict=False)
    return "; pose: " + ", ".join(f"{name} = {value:.5g}" for name, value in values)


def held_to_its_branch(compiled: Compiled, solution: Solution) -> Solution:
    """Give the run up to where a wheel flips over or a suspension runs away, with a status that says so."""
    left, status = flipped_at(compiled.output_names, solution.outputs), Status.FLIPPED
    if left is None and solution.status in (Status.COMPLETED, Status.NOT_FINITE):
        left, status = ran_away_at(compiled.output_names, solution.outputs), Status.RUN_AWAY
    if left is None:
        return solution
    solution.states[:, left + 1 :] = np.nan
    return replace(solution, status=status)


def flipped_at(names: tuple[str, ...], outputs: Array) -> int | None:
    """Give the first sample at which the wheel has flipped over, None where it never does.

    Rows of ``outputs`` (SI) are channels in the order of ``names``; the first sample is the rest that the run starts
    from.
    """
    first: int | None = None
    for row, name in enumerate(names):
        if not name.endswith(_ANGLES):
            continue
        angle = outputs[row]
        turned = np.abs(np.angle(np.exp(1j * (angle - angle[0])))) > _TURNED
        if abs(angle[0]) > _STEERED:
            turned[0] = True
        if turned.any():
            here = int(np.argmax(turned))
            first = here if first is None else min(first, here)
    return first


def angles_of(names: tuple[str, ...]) -> list[str]:
    """Channels that tell whether a wheel has flipped over."""
    return [name for name in names if name.endswith(_ANGLES)]


def turns_little(courses: Array) -> NDArray[np.bool_]:
    """Tell which courses of such a channel (rad, one a row) turn so little that no wheel has flipped over.

    :func:`flipped_at` says of the others whether it has: an angle may also have passed half a turn.
    """
    first = courses[:, 0]
    turned = np.maximum(courses.max(axis=1) - first, first - courses.min(axis=1))
    return np.asarray((turned <= _TURNED) & (np.abs(first) <= _STEERED))


def ran_away_at(names: tuple[str, ...], outputs: Array) -> int | None:
    """Give the first sample at which a strut deflects by more than 10 m or the body turns by more than 1 rad, or None.

    Arguments as above.
    """
    first: int | None = None
    for row, limit in branch_limits(names).items():
        course = outputs[row]
        if course.max() <= limit and course.min() >= -limit:  # what is not a number is neither
            continue
        beyond = np.abs(course) > limit
        if beyond.any():
            here = int(np.argmax(beyond))
            first = here if first is None else min(first, here)
    return first


def branch_limits(names: tuple[str, ...]) -> dict[int, float]:
    """Size (SI) that a channel may reach in what is still a suspension, by its row in ``names``."""
    limits = {row: 1.0 for row, name in enumerate(names) if name in _TURNS}
    return limits | {row: _APART for row, name in enumerate(names) if name.endswith("strut.deflection")}
