"""What every road answers: pieces, height, slope and where it ends."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike
from pydantic import model_validator

from jounce.core.description import Description
from jounce.core.errors import DescriptionError
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.core.units import NonNegativeLength, PositiveLength
from jounce.roads.profile import Profile, laid_out, passes

LEVEL = 1e-6  # m; a belt loop whose ends differ by more is not closed


class Road(Description, ABC):
    """Height against driven distance for one wheel: an obstacle on a level road.

    Distance 0 is where the wheel stands at time 0. The height is z of the road in m, up positive, 0 at nominal road
    level; before the obstacle its first height holds, after it its last.

    Attributes
    ----------
    kind : str
        What it is, e.g. ``"half-sine"``.
    start : float
        Distance driven before the obstacle begins, in m.
    recurrence : float or None
        Length of the belt loop in m: the obstacle comes again each time this distance has been driven.
    """

    start: NonNegativeLength = 0.0
    recurrence: PositiveLength | None = None

    @abstractmethod
    def profile(self) -> Profile:
        """Closed-form pieces of one pass, in m from ``start``."""

    def check(self) -> None:
        """Raise ValueError when the fields contradict each other."""

    @model_validator(mode="after")
    def _checked(self) -> Self:
        self.check()
        if self.recurrence is not None:
            _check_recurrence(self.profile(), self.recurrence)
        return self

    def segments(self, distance: float, behind: float = 0.0) -> Segments:
        """Give the road over [0, ``distance``] as closed-form pieces.

        Parameters
        ----------
        distance : float
            Driven distance in m, above 0.
        behind : float
            How far the wheel follows behind the one at distance 0, m: it meets everything so much later.

        Returns
        -------
        Segments
            Pieces against distance in m (``.in_time(speed)`` gives them against time); heights in m. Every jump of
            height or slope is an edge.

        Raises
        ------
        DescriptionError
            When ``distance`` is not a finite length above 0.

        Examples
        --------
        >>> from jounce.roads import Rectangle
        >>> Rectangle(height="10 mm", length="60 mm", start="0.2 m").segments(1.0).edges.tolist()
        [0.0, 0.2, 0.26, 1.0]
        """
        if not (np.isfinite(distance) and distance > 0.0):
            raise DescriptionError("not a distance to drive", found=f"{distance} m", allowed="above 0 m and finite")
        pieces = self._between(0.0 - behind, float(distance) - behind)
        return replace(pieces, edges=pieces.edges + behind) if behind else pieces

    def height_at(self, x: ArrayLike) -> Array:
        """Height of the road in m (up positive) at the distances ``x`` in m, any shape.

        Examples
        --------
        >>> from jounce.roads import HalfSine
        >>> float(HalfSine(height="10 mm", length="60 mm").height_at(0.03))
        0.01
        """
        return self._evaluated(x)[0]

    def slope_at(self, x: ArrayLike) -> Array:
        """Slope dh/dx (1) at the distances ``x`` in m, any shape; at an edge that of the piece after it.

        A jump of height has no slope: it is an edge of `segments`.

        Examples
        --------
        >>> from jounce.roads import Triangle
        >>> Triangle(height="10 mm", length="0.2 m").slope_at([0.05, 0.15]).round(9).tolist()
        [0.1, -0.1]
        """
        return self._evaluated(x)[1]

    def end(self) -> float:
        """Distance in m at which the obstacle (of a train, the last one) ends on its first pass.

        A bare step ends where it stands; a table or a measured course where its last height is.

        Examples
        --------
        >>> from jounce.roads import HalfSine, Train
        >>> Train(of=HalfSine(height="10 mm", length="60 mm"), count=5, pitch="0.10 m").end()
        0.46
        """
        return self.start + float(self.profile().edges[-1])

    def _between(self, low: float, high: float) -> Segments:
        return laid_out(self.profile(), passes(self.start, self.recurrence, high), low, high)

    def _evaluated(self, x: ArrayLike) -> tuple[Array, Array]:
        at = np.asarray(x, dtype=float)
        if not np.isfinite(at).all():
            raise DescriptionError("not a distance", found="NaN or infinity", allowed="finite distances in m")
        low, high = (float(at.min()), float(at.max())) if at.size else (0.0, 0.0)
        height, slope = self._between(min(low, 0.0) - 1.0, max(high, 0.0) + 1.0).evaluate(at.ravel())
        return height.reshape(at.shape), slope.reshape(at.shape)


def _check_recurrence(one: Profile, recurrence: float) -> None:
    if abs(one.after - one.before) > LEVEL:
        raise ValueError(
            f"the road cannot recur: it ends {one.after - one.before:g} m higher than it begins; "
            "leave out recurrence or close the loop"
        )
    if recurrence < one.span * (1.0 - 1e-9):
        raise ValueError(
            f"the obstacle comes again before it ends: recurrence {recurrence:g} m is shorter than "
            f"its length {one.span:g} m"
        )
