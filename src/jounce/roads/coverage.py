"""How far a road holds data, and how far apart its points are."""

from __future__ import annotations

import math

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.roads.enveloping import Enveloped
from jounce.roads.iso8608 import Iso8608, SineSum
from jounce.roads.measured import Crg, Table
from jounce.roads.road import LEVEL, Road
from jounce.roads.train import Train


def covered(road: Road) -> float:
    """Distance in m up to which a road is known.

    Obstacles stand on a level road and are known without end, and so is what repeats; a table, a measured course or a
    random road is known up to its last point.

    Examples
    --------
    >>> from jounce.roads import HalfSine
    >>> covered(HalfSine(height="10 mm", length="60 mm")), covered(Iso8608(class_="C", length="500 m", start="10 m"))
    (inf, 510.0)
    """
    inner = _sampled(road)
    if inner is None or road.recurrence is not None or _goes_on(inner):
        return math.inf
    if isinstance(road, Enveloped):
        return covered(road.of)
    return road.end()


def ends_level(road: Road) -> bool:
    """Whether a road ends at the height at which it begins, as an obstacle does: a drive may go on beyond it."""
    profile = road.profile()
    return abs(profile.after - profile.before) <= LEVEL


def check_covered(
    road: Road, distance: float, *, behind: float = 0.0, where: str = "", level_goes_on: bool = False
) -> None:
    """Refuse a drive over more than the road holds.

    Parameters
    ----------
    road : Road
        What is driven over.
    distance : float
        Driven distance in m.
    behind : float
        How far the first wheel that matters follows behind distance 0, m.
    where : str
        Place that the error names.
    level_goes_on : bool
        Accept a road that ends as high as it begins.

    Raises
    ------
    DescriptionError
        When the road ends before the run does, or all of it lies before the start.

    Examples
    --------
    >>> check_covered(Iso8608(class_="C", length="500 m"), 400.0)
    """
    known = covered(road)
    if level_goes_on and ends_level(road):
        return
    if distance - behind > known * (1.0 + 1e-9) + 1e-9:
        raise DescriptionError(
            "the road is shorter than the run",
            where=where,
            found=f"{distance:.6g} m driven",
            allowed=f"up to {known + behind:.6g} m",
            hint="Shorten the run, drive slower, or use a longer road.",
        )


def point_spacing(road: Road) -> float | None:
    """Usual distance in m between the points of a table, a measured course or a random road; None for obstacles."""
    inner = _sampled(road)
    if isinstance(inner, Iso8608):
        return inner.length / max(2, math.ceil(inner.length / inner.step - 1e-9))
    if isinstance(inner, Crg):
        return float(np.median(np.diff(inner.points()[0])))
    return float(np.median(np.diff(inner.points()[0]))) if isinstance(inner, Table) else None


def is_course(road: Road) -> bool:
    """Tell whether a road is a course, measured or random, also in trains and envelopes, and no obstacle."""
    while isinstance(road, Train | Enveloped):
        road = road.of
    return isinstance(road, Table | Crg | Iso8608 | SineSum)


def _sampled(road: Road) -> Table | Crg | Iso8608 | None:
    """The sampled road inside trains and envelopes."""
    while isinstance(road, Train | Enveloped):
        road = road.of
    return road if isinstance(road, Table | Crg | Iso8608) else None


def _goes_on(road: Road) -> bool:
    return road.recurrence is not None or (isinstance(road, Crg) and road.is_endless())
