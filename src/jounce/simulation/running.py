"""Runs that do not start at rest: on a running belt, whose obstacle has passed before."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.phrases import Phrase
from jounce.parts import Rig
from jounce.roads import Road, Trial
from jounce.simulation.linear_model import linearise
from jounce.simulation.settings import RunSettings, Start
from jounce.simulation.solve import RunOutput, solve

LEFT_OVER = 1e-3
"""Remaining share of the transient from rest when a run on a belt begins: the energy of a residual of 1e-6."""
MOST_LOOPS = 200
"""Maximum number of preceding loops of a belt: a rig whose transient lasts longer is almost undamped."""


def loops_before(rig: Rig, period: float) -> int:
    """Return the number of loops of a belt, each of ``period`` (s), after which the transient from rest has decayed.

    It follows from the slowest decay of the rig's oscillations at rest.

    Raises
    ------
    SimulationError
        If the rig has no damping, since its transient never decays.

    Examples
    --------
    >>> import jounce as jn
    >>> loops_before(jn.load("kart-quarter-car"), 1.0)
    3
    """
    poles = np.linalg.eigvals(linearise(rig).A)
    swinging = poles[np.abs(poles.imag) > _SWINGING * np.abs(poles)]
    decay = float(np.min(-swinging.real, initial=math.inf))
    loops = math.ceil(-math.log(LEFT_OVER) / (decay * period)) if decay > 0.0 else MOST_LOOPS + 1
    if loops > MOST_LOOPS:
        raise SimulationError(
            "the rig does not settle into a periodic motion",
            where="start",
            found=f"an oscillation that decays with {max(decay, 0.0):.3g} 1/s, loops of {period:.3g} s",
            allowed=Phrase("at most {most_loops} loops", most_loops=MOST_LOOPS),
            hint="Add a damper, or start at rest.",
        )
    return max(loops, 1)


_SWINGING = (
    1e-6  # imaginary part over magnitude of a pole; smaller ratios are rounding of a real pole
)


def period_of(trial: Trial) -> float:
    """Return the time (s) between two passes of a belt's obstacle.

    Raises
    ------
    SimulationError
        If the road has no recurrence.
    """
    road, speed = trial.road, trial.speed
    if road is None or speed is None or road.recurrence is None:
        raise SimulationError(
            "only a belt can run before the start, and this road does not recur",
            where="start",
            allowed="rest, or a road with recurrence (the length of the belt)",
        )
    return road.recurrence / speed


def solved_running(
    rig: Rig, trial: Trial, settings: RunSettings, start: Start, **more: Any
) -> RunOutput:
    """Run a trial after some loops of its belt; ``more`` is passed to :func:`jounce.simulation.solve.solve`.

    The simulation starts from rest that many loops earlier; time counts from the beginning of the trial.
    """
    if start == "rest":
        return solve(rig, trial, settings, **more)
    period = period_of(trial)
    loops = loops_before(rig, period) if start == "periodic" else _count(start)
    if trial.speeds is not None:
        raise SimulationError("the speed changes during the run", where="start", allowed="rest")
    if any(trial.load(name).jumps.size for name in trial.loads):
        raise SimulationError(
            "a load starts during the run",
            where="start",
            allowed="rest",
            hint="Leave out the load.",
        )
    step = settings.output_step
    before = math.ceil(loops * period / step - 1e-9)  # a whole number of samples
    longer = _begun_earlier(trial, before * step, loops)
    run = solve(rig, longer, settings, **more)
    times = settings.times(trial.duration)
    channels = {
        name: (values[before:], unit, words) for name, (values, unit, words) in run.channels.items()
    }
    attributes = {
        **run.attributes,
        "start": f"{start if start == 'periodic' else ''} after {loops} loops".strip(),
    }
    return replace(
        run, time=times[: len(run.time) - before], channels=channels, attributes=attributes
    )


def _count(start: Start) -> int:
    try:
        loops = int(start)
    except ValueError:
        loops = -1
    if not 0 <= loops <= MOST_LOOPS:
        allowed = Phrase("rest, periodic, or 0 to {most_loops} loops", most_loops=MOST_LOOPS)
        raise SimulationError("invalid start", where="start", found=start, allowed=allowed)
    return loops


def _begun_earlier(trial: Trial, earlier: float, loops: int) -> Trial:
    """Return the trial started ``earlier`` (s), with its obstacles in their final positions after the loops."""
    assert trial.speed is not None
    given: dict[str, Any] = {"duration": trial.duration + earlier}
    for name in ("road", "right"):
        road: Road | None = getattr(trial, name)
        if road is not None and road.recurrence is not None:
            moved = road.start + trial.speed * earlier - loops * road.recurrence
            given[name] = road.with_fields(start=max(moved, 0.0))
    return trial.with_fields(**given)
