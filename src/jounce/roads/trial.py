"""Trials: what the wheel is driven over, or how its support is moved, and for how long."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Self

from pydantic import BeforeValidator, model_validator

from jounce.core.description import Description
from jounce.core.segments import Segments, flat
from jounce.core.units import PositiveSpeed, Unit
from jounce.roads.coverage import is_course
from jounce.roads.loads import LOADS, DrivingAcceleration, PitchMoment
from jounce.roads.measured import (
    Interpolation,
    Lengths,
    Times,
    check_source,
    file_profile,
    point_profile,
)
from jounce.roads.profile import Profile, laid_out
from jounce.roads.train import AnyRoad

FEWEST_SAMPLES = 4


class Excitation(Description):
    """Height of the support under the tyre against time: a shaker, a test stand, a profile measured over time.

    Before the first sample its height holds, after the last sample the last one's.

    Attributes
    ----------
    time : tuple of float
        Samples in s, strictly ascending, at least 4; time 0 is the start of the trial. Arrays are taken, too.
    height : tuple of float
        Height in m at these times, up positive.
    file : Path or None
        Instead of both: a text file with the columns ``time`` and ``road.z``, e.g. ``time [s], road.z [mm]``.
    interpolation : {"cubic", "linear"}
        Not-a-knot cubic spline (a smooth velocity), or lines.

    Examples
    --------
    >>> shaker = Excitation(time=[0.0, 0.1, 0.2, 0.3], height=["0 mm", "1 mm", "0 mm", "-1 mm"])
    >>> shaker.end()
    0.3
    """

    time: Times = ()
    height: Lengths = ()
    file: Path | None = None
    interpolation: Interpolation = "cubic"

    @model_validator(mode="after")
    def _checked(self) -> Self:
        if self.file is None and (self.time or self.height) and len(self.time) < FEWEST_SAMPLES:
            raise ValueError(f"{len(self.time)} samples; an excitation needs at least {FEWEST_SAMPLES}")
        check_source(self.file, {"time": self.time, "height": self.height}, self.interpolation)
        if self.file is not None:
            self.profile()
        return self

    def profile(self) -> Profile:
        """Pieces through the samples: coordinate in s, heights in m."""
        if self.file is not None:
            return file_profile(self.file, {"time": "s", "road.z": "m"}, self.interpolation, FEWEST_SAMPLES)
        return point_profile(self.time, self.height, self.interpolation)

    def end(self) -> float:
        """Time of the last sample in s."""
        return float(self.profile().edges[-1])


def _from_file(value: object) -> object:
    return {"file": value} if isinstance(value, str | Path) else value


class Trial(Description):
    """One run: a road driven over at a constant speed, or an excitation in time; for vehicles also loads of driving.

    Attributes
    ----------
    road : Road or None
        What is driven over; with ``speed`` and ``duration``.
    speed : float or None
        Constant speed in m/s, above 0.
    excitation : Excitation or None
        Instead of road and speed; a path stands for ``{file = path}``.
    duration : float
        Length of the run in s, above 0. Only with an excitation it may be left out: up to its last sample.
    right : Road or None
        Road under the right wheels of a full car; by default they roll over the same road as the left ones.
    pitch_moment : PitchMoment or None
        Moment of braking on a vehicle's body, N m, nose down positive; ``"100 N*m"`` stands for a constant one.
    deceleration : DrivingAcceleration or None
        Braking, m/s^2: its moment is that of the body's mass at the height of its centre of gravity.
    lateral_acceleration : DrivingAcceleration or None
        Of a full car, m/s^2, positive to the left.

    Examples
    --------
    >>> from jounce.roads import HalfSine
    >>> trial = Trial(road=HalfSine(height="10 mm", length="60 mm", start="0.39 m"), speed="1.95 m/s", duration="3 s")
    >>> trial.segments().edges.round(4).tolist()
    [0.0, 0.2, 0.2308, 3.0]
    """

    road: AnyRoad | None = None
    speed: PositiveSpeed | None = None
    excitation: Annotated[Excitation | None, BeforeValidator(_from_file)] = None
    duration: Annotated[float, Unit("s", above=0.0)] = 0.0  # replaced by the excitation's last time
    right: AnyRoad | None = None
    pitch_moment: PitchMoment | None = None
    deceleration: DrivingAcceleration | None = None
    lateral_acceleration: DrivingAcceleration | None = None

    @model_validator(mode="after")
    def _checked(self) -> Self:
        if (self.road is None) == (self.excitation is None):
            given = "both a road and an excitation are" if self.road else "neither a road nor an excitation is"
            raise ValueError(f"{given} given; allowed: road and speed, or excitation")
        if self.road is not None and self.speed is None:
            raise ValueError("the speed is missing; a road is driven over at a speed, e.g. speed = '1.95 m/s'")
        if self.excitation is not None and self.speed is not None:
            raise ValueError("a speed is given with an excitation, which is in time already; leave out the speed")
        if self.right is not None and self.road is None:
            raise ValueError("a road under the right wheels is given without road, the one under the left wheels")
        if "duration" not in self.model_fields_set:
            object.__setattr__(self, "duration", self._default_duration())
        return self

    def _default_duration(self) -> float:
        if self.excitation is None:
            raise ValueError("the duration is missing, e.g. duration = '3 s'")
        end = self.excitation.end()
        if end <= 0.0:
            raise ValueError(f"the excitation's last time is {end:g} s; it must lie after 0, where the trial starts")
        return end

    def segments(self, behind: float = 0.0, side: int = 1) -> Segments:
        """Give the height under a tyre over [0, ``duration``] as closed-form pieces.

        Parameters
        ----------
        behind : float
            How far the wheel follows behind the front axle, m: it meets the road later. An excitation moves all wheels
            at once.
        side : int
            1 for the left road (the only one unless ``right`` is given), -1 for the right one.

        Returns
        -------
        Segments
            Pieces against time in s; heights in m, up positive. Every jump of height or slope is an edge.
        """
        road = self.right if self.right is not None and side < 0 else self.road
        if road is not None and self.speed is not None:
            return road.segments(self.speed * self.duration, behind).in_time(self.speed)
        if self.excitation is None:
            raise AssertionError("a trial has a road or an excitation")
        return laid_out(self.excitation.profile(), [(0.0, 0.0)], 0.0, self.duration)

    def load(self, name: str) -> Segments:
        """Give one of the loads of driving over [0, ``duration``] (s), zero where the trial has none."""
        given: PitchMoment | DrivingAcceleration | None = getattr(self, name)
        return flat(self.duration) if given is None else given.segments(self.duration)

    @property
    def loads(self) -> tuple[str, ...]:
        """Names of the loads of driving that are given."""
        return tuple(name for name in LOADS if getattr(self, name) is not None)

    def obstacle_end(self) -> float:
        """Time in s at which the obstacle pass ends; 0 for courses and excitations, which have none."""
        if self.road is None or is_course(self.road):
            return 0.0
        return self.end()

    def end(self) -> float:
        """Time in s at which the first pass of the last obstacle, or the excitation, ends (duration or not)."""
        if self.road is not None and self.speed is not None:
            return self.road.end() / self.speed
        return self.excitation.end() if self.excitation is not None else 0.0
