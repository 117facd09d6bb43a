"""Loads of driving against time: pitch moment, deceleration, lateral acceleration."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Any, Self

import numpy as np
from pydantic import model_validator

from jounce.core.description import Description
from jounce.core.segments import Segments
from jounce.core.units import Acceleration, Number, Unit

NonNegativeTime = Annotated[float, Unit("s", at_least=0.0)]
Moment = Annotated[float, Unit("N*m")]


class Load(Description):
    """A load that begins at ``start`` and stays, or goes along lines through points.

    On from the very start (``start`` 0 without a ramp) it is part of the equilibrium that the run starts from.

    Attributes
    ----------
    value : float or None
        What it grows to, in the unit of its kind (N m or m/s^2).
    start, ramp : float
        When it begins, and how long it takes to grow along a line; 0 for a step. s.
    time, values : tuple of float
        In place of them: points, times strictly ascending, s; level before the first and after the last.
    """

    value: Number | None = None
    start: NonNegativeTime = 0.0
    ramp: NonNegativeTime = 0.0
    time: tuple[NonNegativeTime, ...] = ()
    values: tuple[Number, ...] = ()

    @model_validator(mode="before")
    @classmethod
    def _plain_value(cls, table: Any) -> Any:
        return {"value": table} if isinstance(table, (str, int, float)) and not isinstance(table, bool) else table

    @model_validator(mode="after")
    def _one_form(self) -> Self:
        if (self.value is None) == (not self.time):
            raise ValueError("give either value (with start and ramp), or time and values")
        if self.time and (self.start or self.ramp):
            raise ValueError("start and ramp go with value; points have their own times")
        if len(self.time) != len(self.values) or len(self.time) == 1:
            raise ValueError(
                f"time has {len(self.time)} numbers and values has {len(self.values)}; give as many, at least 2"
            )
        for a, b in pairwise(self.time):
            if b <= a:
                raise ValueError(f"time does not ascend: {a:g} s, then {b:g} s")
        return self

    def segments(self, duration: float) -> Segments:
        """Give the load over [0, ``duration``] (s) as pieces, in its unit."""
        if self.value is not None:
            points = [(0.0, 0.0), (self.start, 0.0), (self.start + self.ramp, self.value)]
        else:
            points = [(0.0, self.values[0]), *zip(self.time, self.values, strict=True)]
        return _lines(points, duration)


def _lines(points: list[tuple[float, float]], duration: float) -> Segments:
    """Lines through points up to ``duration``, level after the last; two points at one time are a jump."""
    edges, pieces = [0.0], []
    for (t0, f0), (t1, f1) in pairwise(points):
        if t0 < min(t1, duration):
            pieces.append([f0, (f1 - f0) / (t1 - t0), 0.0, 0.0])
            edges.append(min(t1, duration))
    if edges[-1] < duration:
        pieces.append([points[-1][1], 0.0, 0.0, 0.0])
        edges.append(duration)
    return Segments(np.array(edges), np.zeros(len(pieces), dtype=np.int64), np.array(pieces))


class PitchMoment(Load):
    """Moment of braking and driving on the body, N m, nose down positive."""

    value: Moment | None = None
    values: tuple[Moment, ...] = ()


class DrivingAcceleration(Load):
    """Deceleration (positive when braking) or lateral acceleration (positive to the left), m/s^2."""

    value: Acceleration | None = None
    values: tuple[Acceleration, ...] = ()


LOADS = ("pitch_moment", "deceleration", "lateral_acceleration")
"""Loads of a trial, by the names of the models' inputs."""
