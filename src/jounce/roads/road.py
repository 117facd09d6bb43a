"""Interface of all roads: pieces, height, slope, end, and the known length."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import replace
from typing import ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike
from pydantic import model_validator

from jounce.core.description import Description
from jounce.core.errors import DescriptionError
from jounce.core.kinds import Kinds
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.core.units import NonNegativeLength, PositiveLength, as_number
from jounce.roads.profile import SHORTEST, Profile, lay_out, passes

LEVEL = 1e-6  # m; tolerance of the end heights of a closed belt loop


class Road(Description, ABC):
    """Height against driven distance for one wheel: an obstacle on a level road.

    The wheel is at distance 0 at time 0. The height is z of the road in m, positive upwards, 0 at nominal road level.
    The first height of the obstacle continues before it, the last height after it.

    Attributes
    ----------
    kind : str
        Kind of the road, e.g. ``"half-sine"``.
    start : float
        Distance driven before the obstacle begins, in m.
    recurrence : float or None
        Length of the belt loop in m, after which the obstacle recurs.
    """

    kinds: ClassVar[Kinds] = Kinds("kind", package="jounce.roads", schema="road.schema.json")
    start: NonNegativeLength = 0.0
    recurrence: PositiveLength | None = None

    @abstractmethod
    def profile(self) -> Profile:
        """Return the closed-form pieces of one pass, in m from ``start``."""

    def check(self) -> None:
        """Raise ValueError when the fields contradict each other."""

    @model_validator(mode="after")
    def _check_fields(self) -> Self:
        self.check()
        if self.recurrence is not None:
            _check_recurrence(self.profile(), self.recurrence)
        return self

    def segments(self, distance: float, behind: float = 0.0) -> Segments:
        """Return the road over [0, ``distance``] as closed-form pieces.

        Parameters
        ----------
        distance : float
            Driven distance in m, above 0.
        behind : float
            Distance in m by which the wheel trails the wheel at distance 0.

        Returns
        -------
        Segments
            Pieces against distance in m (``.in_time(speed)`` gives them against time); heights in m. Every jump of
            height or slope is an edge.

        Raises
        ------
        DescriptionError
            If ``distance`` is not finite and positive, or negligible compared with ``behind``.

        Examples
        --------
        >>> from jounce.roads import Rectangle
        >>> Rectangle(height="10 mm", length="60 mm", start="0.2 m").segments(1.0).edges.tolist()
        [0.0, 0.2, 0.26, 1.0]
        """
        distance, behind = (
            as_number(distance, "m", where="distance"),
            as_number(behind, "m", where="behind"),
        )
        if not (np.isfinite(distance) and distance > 0.0):
            raise DescriptionError(
                "invalid driving distance", found=f"{distance} m", allowed="above 0 m and finite"
            )
        if not distance > SHORTEST * abs(behind):  # otherwise start and end are the same float
            raise DescriptionError(
                "the wheel is implausibly far behind the front axle",
                found=f"{behind:g} m",
                allowed=Phrase(
                    "up to {distance:.0e} m for a run of {second_distance:g} m",
                    distance=distance / SHORTEST,
                    second_distance=distance,
                ),
            )
        pieces = self._between(0.0 - behind, float(distance) - behind)
        return replace(pieces, edges=pieces.edges + behind) if behind else pieces

    def height_at(self, x: ArrayLike) -> Array:
        """Return the height of the road in m (positive upwards) at the distances ``x`` in m, any shape.

        Examples
        --------
        >>> from jounce.roads import HalfSine
        >>> float(HalfSine(height="10 mm", length="60 mm").height_at(0.03))
        0.01
        """
        return self._evaluate(x)[0]

    def slope_at(self, x: ArrayLike) -> Array:
        """Return the slope dh/dx (1) at the distances ``x`` in m, any shape; at an edge, that of the following piece.

        A jump in height has no slope; it is an edge of `segments`.

        Examples
        --------
        >>> from jounce.roads import Triangle
        >>> Triangle(height="10 mm", length="0.2 m").slope_at([0.05, 0.15]).round(9).tolist()
        [0.1, -0.1]
        """
        return self._evaluate(x)[1]

    def end(self) -> float:
        """Return the distance in m at which the obstacle, or the last one of a train, ends on its first pass.

        A bare step ends at its position; a table or a measured course at its last height.

        Examples
        --------
        >>> from jounce.roads import HalfSine, Train
        >>> Train(of=HalfSine(height="10 mm", length="60 mm"), count=5, pitch="0.10 m").end()
        0.46
        """
        return self.start + float(self.profile().edges[-1])

    def is_course(self) -> bool:
        """Whether the road is a measured or random course rather than an obstacle on a level road."""
        return False

    def known_length(self) -> float:
        """Return the distance in m up to which the road is known.

        It is infinite for obstacles on a level road and for repeating roads. Tables, measured courses and random roads
        are known up to their last point.

        Examples
        --------
        >>> from jounce.roads import HalfSine, Iso8608
        >>> HalfSine(height="10 mm", length="60 mm").known_length()
        inf
        >>> Iso8608(class_="C", length="500 m", start="10 m").known_length()
        510.0
        """
        return math.inf

    def point_spacing(self) -> float | None:
        """Return the typical point spacing in m of a table, measured course or random road; None for obstacles."""
        return None

    def ends_level(self) -> bool:
        """Whether the road ends at its start height, like an obstacle, so that a run may continue beyond it."""
        profile = self.profile()
        return abs(profile.after - profile.before) <= LEVEL

    def check_covers(
        self, distance: float, *, behind: float = 0.0, where: str = "", continue_level: bool = False
    ) -> None:
        """Raise an error for a run that is longer than the road.

        Parameters
        ----------
        distance : float
            Driven distance in m.
        behind : float
            Distance of the first relevant wheel behind distance 0, m.
        where : str
            Location named in the error.
        continue_level : bool
            Whether to accept a road that ends at its start height, as it continues level.

        Raises
        ------
        DescriptionError
            If the road ends before the run does, or is entirely behind the start.

        Examples
        --------
        >>> from jounce.roads import Iso8608
        >>> Iso8608(class_="C", length="500 m").check_covers(400.0)
        """
        known = self.known_length()
        beyond = distance - behind > known * (1.0 + 1e-9) + 1e-9
        if beyond and not (continue_level and self.ends_level()):
            raise DescriptionError(
                "the road is shorter than the run",
                where=where,
                found=f"{distance:.6g} m driven",
                allowed=Phrase("up to {known:.6g} m", known=known + behind),
                hint="Shorten the run, drive slower, or use a longer road.",
            )

    def _between(self, low: float, high: float) -> Segments:
        return lay_out(self.profile(), passes(self.start, self.recurrence, high), low, high)

    def _evaluate(self, x: ArrayLike) -> tuple[Array, Array]:
        at = as_samples(x, "m", where="x", error=DescriptionError)
        if not np.isfinite(at).all():
            raise DescriptionError(
                "invalid distance", found="NaN or infinity", allowed="finite distances in m"
            )
        low, high = (float(at.min()), float(at.max())) if at.size else (0.0, 0.0)
        height, slope = self._between(min(low, 0.0) - 1.0, max(high, 0.0) + 1.0).evaluate(
            at.ravel()
        )
        return height.reshape(at.shape), slope.reshape(at.shape)


class SampledRoad(Road):
    """A road given by points, known up to the last point or, if it repeats, to infinity."""

    @abstractmethod
    def points(self) -> tuple[Array, Array]:
        """Return the points of one pass: distance from ``start`` and height, both in m, each of shape (n,)."""

    def is_course(self) -> bool:
        """Always."""
        return True

    def known_length(self) -> float:
        """Return the distance in m of the last point."""
        return self.end() if self.recurrence is None else math.inf

    def point_spacing(self) -> float | None:
        """Return the median distance in m between the points."""
        return float(np.median(np.diff(self.points()[0])))


class RoadOf(Road):
    """A road derived from an inner road ``of``, which determines course, known length and point spacing."""

    of: Road

    def is_course(self) -> bool:
        """Whether the inner road is a course."""
        return self.of.is_course()

    def known_length(self) -> float:
        """Return the distance in m up to which the inner road is known."""
        return self.of.known_length()

    def point_spacing(self) -> float | None:
        """Return the point spacing in m of the inner road."""
        return self.of.point_spacing()


ROADS = Road.kinds
"""All kinds of roads by their name in files."""


def _check_recurrence(profile: Profile, recurrence: float) -> None:
    if abs(profile.after - profile.before) > LEVEL:
        raise ValueError(
            Phrase(
                "the road cannot recur: it ends {after:g} m higher than it begins; leave out recurrence "
                "or close the loop",
                after=profile.after - profile.before,
            )
        )
    if recurrence < profile.span * (1.0 - 1e-9):
        raise ValueError(
            Phrase(
                "the obstacle recurs before it ends: recurrence {recurrence:g} m is shorter than its length {span:g} m",
                recurrence=recurrence,
                span=profile.span,
            )
        )
