"""What is legal in a trial and looks wrong: roads that end, points too far apart, loads that never come."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from jounce.core.findings import Finding
from jounce.core.segments import Segments
from jounce.parts import HalfCar, Rig, Vehicle
from jounce.roads.coverage import point_spacing
from jounce.roads.iso8608 import Iso8608
from jounce.roads.measured import Crg, Table
from jounce.roads.road import Road
from jounce.roads.trial import Trial

FASTEST = 15.0
"""Hz, what points of a road should at least show the wheels: about where they hop."""
FEWEST_OUTPUTS = 4
"""Samples of the result while an obstacle passes; with less its peaks are not seen."""
_JUMP = 1e-6  # m
_SAMPLED = (Table, Crg, Iso8608)


def trial_findings(trial: Trial, rig: Rig | None = None, *, output_step: float | None = None) -> list[Finding]:
    """Say what a reader of the run must know about its road and its loads.

    Parameters
    ----------
    trial : Trial
        What is driven.
    rig : Rig, optional
        With it also what its axles do not feel.
    output_step : float, optional
        Distance of the result's samples, s.

    Returns
    -------
    list of Finding
        Empty when nothing looks wrong.

    Examples
    --------
    >>> from jounce.roads import Table
    >>> short = Table(x=[0.0, 0.01, 0.02], height=["0 mm", "2 mm", "0 mm"])
    >>> [found.message for found in trial_findings(Trial(road=short, speed="1 m/s", duration="5 s"))]
    ['the road ends after 0.02 m and the run drives 5 m; the rest of it is level. Shorten the run.']
    """
    behind = rig.wheelbase if isinstance(rig, Vehicle) else 0.0
    found = list(_loads(trial))
    if trial.speed is not None:
        for name, road in (("road", trial.road), ("right", trial.right)):
            if road is not None:
                found += _road(road, trial.speed, trial.duration, f"trial: {name}", output_step)
        found += _rear(trial, behind)
        if isinstance(rig, HalfCar) and rig.compat == "physical" and _jumps(trial.segments()):
            text = (
                "the road jumps, and the dampers of massless axles do not feel it; "
                'an edge is a ramp of some length, e.g. the shape "cosine" over a tyre\'s contact'
            )
            found.append(Finding("trial: road", "warning", text))
        if isinstance(trial.road, Iso8608) and trial.right is None and _has_sides(rig):
            text = (
                "the left and the right wheels meet the same track; "
                'the right one is other_track(), or side = "right" in a file.'
            )
            found.append(Finding("trial: road", "note", text))
    return found


def _road(road: Road, speed: float, duration: float, place: str, output_step: float | None) -> Iterator[Finding]:
    driven = speed * duration
    if road.start >= driven:
        text = (
            f"the run ends before the obstacle begins, {road.start:g} m from the start; drive longer or start nearer."
        )
        yield Finding(place, "warning", text, duration)
        return
    span = road.profile().span
    if isinstance(road, _SAMPLED):
        if road.recurrence is None and road.end() < driven * (1.0 - 1e-9):
            text = (
                f"the road ends after {road.end():g} m and the run drives {driven:g} m; the rest of it is level. "
                "Shorten the run."
            )
            yield Finding(place, "warning", text, road.end())
        apart = point_spacing(road) or span
        if speed / (2.0 * apart) < FASTEST:
            text = (
                f"its points, {apart:.3g} m apart, show nothing above {speed / (2.0 * apart):.3g} Hz at {speed:g} m/s; "
                f"wheels hop at about {FASTEST:g} Hz. Take a finer profile."
            )
            yield Finding(place, "warning", text, apart)
    elif output_step is not None and 0.0 < span < FEWEST_OUTPUTS * output_step * speed:
        text = (
            f"the obstacle passes in {1e3 * span / speed:.3g} ms and the result has a sample every "
            f"{1e3 * output_step:g} ms; its peaks are not seen. Take a finer output step."
        )
        yield Finding(place, "warning", text, span / speed)


def _rear(trial: Trial, behind: float) -> Iterator[Finding]:
    road, speed = trial.road, trial.speed
    if road is None or speed is None or behind == 0.0:
        return
    driven = speed * trial.duration
    if road.start < driven <= road.start + behind and road.profile().span > 0.0 and not isinstance(road, _SAMPLED):
        text = f"the run ends before the rear axle, {behind:g} m behind, meets the obstacle."
        yield Finding("trial: duration", "warning", text, trial.duration)


def _loads(trial: Trial) -> Iterator[Finding]:
    for name in trial.loads:
        load = trial.load(name)
        heights = load.evaluate(np.linspace(0.0, trial.duration, 2 * len(load.edges) + 1))[0]
        given = getattr(trial, name)
        if not np.any(heights) and (given.value or any(given.values)):
            text = f"it begins after the run of {trial.duration:g} s is over."
            yield Finding(f"trial: {name}", "warning", text, trial.duration)


def _jumps(signal: Segments) -> bool:
    inner = signal.edges[1:-1]
    before = signal.evaluate(np.nextafter(inner, -np.inf))[0]
    return bool(np.any(np.abs(signal.evaluate(inner)[0] - before) > _JUMP))


def _has_sides(rig: Rig | None) -> bool:
    return isinstance(rig, Vehicle) and any(place.side for place in rig.wheels.values())
