"""Trials: road, speed, duration and manoeuvre loads, with findings about them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Protocol, Self, runtime_checkable

import numpy as np
from pydantic import BeforeValidator, model_validator

from jounce.core.description import Description
from jounce.core.errors import RecordingError
from jounce.core.files import State, existing_file, state_of
from jounce.core.findings import Finding, at_place, finding
from jounce.core.misplaced import error_at
from jounce.core.old_names import old_method
from jounce.core.phrases import Phrase
from jounce.core.remembered import once_per_object
from jounce.core.samples import Listed
from jounce.core.segments import JUMP, Segments, flat
from jounce.core.types import Array
from jounce.core.units import Acceleration, Number, PositiveSpeed, Unit
from jounce.parts import HalfCar, Rig, Vehicle
from jounce.parts.rig import questions, unit_question
from jounce.parts.vehicles import FullCar, track_width
from jounce.recordings.formats import RecordingFormat
from jounce.roads.measured import (
    Forces,
    Interpolation,
    Lengths,
    Times,
    check_source,
    file_profile,
    point_profile,
)
from jounce.roads.obstacles import HalfSine, Train, Versine
from jounce.roads.profile import Profile, lay_out
from jounce.roads.road import Road, SampledRoad
from jounce.roads.rough import Iso8608

NonNegativeTime = Annotated[float, Unit("s", at_least=0.0)]
Moment = Annotated[float, Unit("N*m")]


class Load(Description):
    """A load that is constant from ``start``, or piecewise linear through points.

    A load present from the outset (``start`` 0, no ramp) is part of the initial equilibrium of the run.

    Attributes
    ----------
    value : float or None
        Final value, in the unit of the load (N m or m/s^2).
    start, ramp : float
        Start, and duration of a linear rise, s; 0 for a step.
    time, values : tuple of float
        Alternatively, points at strictly ascending times, s; constant before the first and after the last.
    """

    value: Number | None = None
    start: NonNegativeTime = 0.0
    ramp: NonNegativeTime = 0.0
    time: Annotated[tuple[NonNegativeTime, ...], Listed] = ()
    values: Annotated[tuple[Number, ...], Listed] = ()

    @model_validator(mode="before")
    @classmethod
    def _plain_value(cls, table: Any) -> Any:
        return (
            {"value": table}
            if isinstance(table, (str, int, float)) and not isinstance(table, bool)
            else table
        )

    @model_validator(mode="after")
    def _check_form(self) -> Self:
        if (self.value is None) == (not self.time):
            raise ValueError("give either value (with start and ramp), or time and values")
        if self.time and (self.start or self.ramp):
            raise ValueError("start and ramp apply to value only; points have their own times")
        if len(self.time) != len(self.values) or len(self.time) == 1:
            raise ValueError(
                Phrase(
                    "time has {count} numbers and values has {second_count}; give equal numbers of both, at least 2",
                    count=len(self.time),
                    second_count=len(self.values),
                )
            )
        for a, b in pairwise(self.time):
            if b <= a:
                raise ValueError(Phrase("time does not increase: {a:g} s, then {b:g} s", a=a, b=b))
        return self

    def segments(self, duration: float) -> Segments:
        """Return the load over [0, ``duration``] (s) as pieces, in the unit of the load."""
        if self.value is not None:
            points = [(0.0, 0.0), (self.start, 0.0), (self.start + self.ramp, self.value)]
        else:
            points = [(0.0, self.values[0]), *zip(self.time, self.values, strict=True)]
        return _lines(points, duration)


def _lines(points: list[tuple[float, float]], duration: float) -> Segments:
    """Return lines through points up to ``duration``, constant after the last; points at equal times are a jump."""
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
    """Braking or driving moment on the body, N m, positive nose-down."""

    value: Moment | None = None
    values: Annotated[tuple[Moment, ...], Listed] = ()


class DrivingAcceleration(Load):
    """Deceleration (positive when braking) or lateral acceleration (positive to the left), m/s^2."""

    value: Acceleration | None = None
    values: Annotated[tuple[Acceleration, ...], Listed] = ()


LOADS = ("pitch_moment", "deceleration", "lateral_acceleration")
"""Loads of a trial, by name of the model input."""


FEWEST_SAMPLES = 4  # minimum for a cubic spline
_TEXTS = (".csv", ".txt", ".tsv")
_KEYS = set(RecordingFormat.model_fields)
ExcitationDatum = Literal["undeformed", "rest"]
"""Reference level of the heights of an excitation."""


class Excitation(RecordingFormat):
    """Height of the support under the tyre over time: a shaker, a test stand, or a profile measured over time.

    The first height applies before the first sample, the last height after the last. A file may be any recording, read
    with the same keys as other recordings.

    Attributes
    ----------
    time : tuple of float
        Samples in s, strictly ascending, at least 4; time 0 is the start of the trial. Arrays are accepted.
    height : tuple of float
        Height in m at these times, positive upwards.
    file : Path or None
        Alternatively, a recording with ``time`` and ``road.z``, e.g. text with ``time [s], road.z [mm]``. Its time
        steps may vary unless one of the following keys is used.
    columns, variable, sample_time, resample, database
        Options for reading the file, as in `read_recording`.
    interpolation : {"cubic", "linear"}
        Not-a-knot cubic spline (a smooth velocity), or lines.
    datum : {"undeformed", "rest"}
        Zero level of the heights: the design level (unchanged heights), or the first height, for a sensor that was not
        zeroed.

    Examples
    --------
    >>> shaker = Excitation(time=[0.0, 0.1, 0.2, 0.3], height=["0 mm", "1 mm", "0 mm", "-1 mm"])
    >>> shaker.end()
    0.3
    >>> raw = Excitation(time=[0.0, 0.1, 0.2, 0.3], height=["310 mm", "311 mm", "310 mm", "309 mm"], datum="rest")
    >>> raw.profile().before, round(raw.profile().after, 9)
    (0.0, -0.001)
    """

    time: Times = ()
    height: Lengths = ()
    file: Path | None = None
    interpolation: Interpolation = "cubic"
    datum: ExcitationDatum = "undeformed"

    @model_validator(mode="after")
    def _check_fields(self) -> Self:
        if self.file is None and (self.time or self.height) and len(self.time) < FEWEST_SAMPLES:
            raise ValueError(
                Phrase(
                    "{count} samples; an excitation needs at least {fewest_samples}",
                    count=len(self.time),
                    fewest_samples=FEWEST_SAMPLES,
                )
            )
        check_source(self.file, {"time": self.time, "height": self.height}, self.interpolation)
        if self.file is not None:
            self.profile()
        elif self._keys():
            raise ValueError(
                Phrase(
                    "{keys}: only applies to a file, and none is given; give file",
                    keys=", ".join(self._keys()),
                )
            )
        return self

    def profile(self) -> Profile:
        """Return pieces through the samples: coordinate in s, heights in m from the datum."""
        result = self._as_written()
        if self.datum == "undeformed":
            return result
        begin, levels = result.before, result.coefficients.copy()
        levels[:, 0] -= begin
        return replace(result, coefficients=levels, before=0.0, after=result.after - begin)

    def _as_written(self) -> Profile:
        if self.file is None:
            return point_profile(self.time, self.height, self.interpolation)
        if self._is_plain():
            return file_profile(
                self.file, {"time": "s", "road.z": "m"}, self.interpolation, FEWEST_SAMPLES
            )
        return self._read_recording(self.file)[0]

    def findings(self) -> list[Finding]:
        """Return findings of the file's reader, and report a start height that suggests a wrong zero level."""
        if self.file is None:
            return []
        result = [] if self._is_plain() else list(self._read_recording(self.file)[1])
        profile = self.profile()
        heights = np.array([*profile.coefficients[:, 0], profile.after])
        if abs(profile.before) > np.ptp(heights):
            result.append(
                finding(
                    "roads.datum",
                    f"{self.file}: road.z",
                    profile.before,
                    start=profile.before,
                    range=np.ptp(heights),
                )
            )
        return result

    def _is_plain(self) -> bool:
        """Whether the file is a text file without further options."""
        return self.file is not None and self.file.suffix.lower() in _TEXTS and not self._keys()

    def _keys(self) -> list[str]:
        """Return the options for reading the file."""
        return sorted(name for name in _KEYS if getattr(self, name) not in ({}, "", None))

    def _read_recording(self, file: Path) -> tuple[Profile, tuple[Finding, ...]]:
        state = state_of(existing_file(file, RecordingError))
        return _read_recording(file, self.model_dump_json(include=_KEYS), self.interpolation, state)

    def end(self) -> float:
        """Return the time of the last sample in s."""
        return float(self.profile().edges[-1])


@lru_cache(maxsize=16)
def _read_recording(
    file: Path, keys: str, interpolation: Interpolation, _state: State
) -> tuple[Profile, tuple[Finding, ...]]:
    """Read the heights of a recording as pieces, with the reader's findings."""
    time, height, findings = RecordingFormat.model_validate_json(keys).signal(
        file, Path(), "road.z"
    )
    if len(time) < FEWEST_SAMPLES:
        raise RecordingError(
            "too few samples",
            where=str(file),
            found=len(time),
            allowed=Phrase("at least {fewest_samples}", fewest_samples=FEWEST_SAMPLES),
        )
    return point_profile(tuple(time), tuple(height), interpolation), tuple(findings)


class ActuatorForce(Description):
    """Measured force over time of an actuator parallel to spring and damper, a known input.

    The first force applies before the first sample and is part of the equilibrium; the last force applies after the
    last sample.

    Attributes
    ----------
    time : tuple of float
        Samples in s, strictly ascending, at least 4; time 0 is the start of the trial. Arrays are accepted.
    force : tuple of float
        Force in N at these times, positive if it pushes body and wheel apart. Arrays are accepted.
    interpolation : {"cubic", "linear"}
        Not-a-knot cubic spline, or lines (for steps).

    Examples
    --------
    >>> ActuatorForce(time=[0.0, 0.1, 0.2, 0.3], force=["0 N", "50 N", "0 N", "-50 N"]).force
    (0.0, 50.0, 0.0, -50.0)
    """

    time: Times
    force: Forces
    interpolation: Interpolation = "cubic"

    @model_validator(mode="after")
    def _check_fields(self) -> Self:
        if len(self.time) < FEWEST_SAMPLES:
            raise ValueError(
                Phrase(
                    "{count} samples; an actuator force needs at least {fewest_samples}",
                    count=len(self.time),
                    fewest_samples=FEWEST_SAMPLES,
                )
            )
        check_source(None, {"time": self.time, "force": self.force}, self.interpolation)
        return self

    def segments(self, duration: float) -> Segments:
        """Return the force (N) over [0, ``duration``] (s) as pieces."""
        return lay_out(
            point_profile(self.time, self.force, self.interpolation), [(0.0, 0.0)], 0.0, duration
        )


def _from_file(value: object) -> object:
    return {"file": value} if isinstance(value, str | Path) else value


_SAME_MEAN = 1e-6  # relative tolerance of a given speed about the mean of the speeds over time


class SpeedOverTime(Description):
    """A varying speed: straight lines through points.

    Attributes
    ----------
    time : tuple of float
        Strictly ascending times from 0, s; the last speed applies after the last time.
    speed : tuple of float
        Speeds at these times, m/s, above 0.

    Examples
    --------
    >>> slowing = SpeedOverTime(time=[0.0, 2.0], speed=["3 m/s", "1 m/s"])
    >>> time, distance = slowing.distance_over_time(3.0)
    >>> round(float(distance[-1]), 6)
    5.0
    """

    time: Annotated[tuple[NonNegativeTime, ...], Listed]
    speed: Annotated[tuple[PositiveSpeed, ...], Listed]

    @model_validator(mode="after")
    def _check_points(self) -> Self:
        if len(self.time) != len(self.speed) or len(self.time) < 2:
            raise ValueError(
                Phrase(
                    "time has {count} numbers and speed has {second_count}; give equal numbers of both, at least 2",
                    count=len(self.time),
                    second_count=len(self.speed),
                )
            )
        if self.time[0] != 0.0:
            raise ValueError(
                Phrase(
                    "time begins at {time:g} s; it must begin at 0, where the trial starts",
                    time=self.time[0],
                )
            )
        for a, b in pairwise(self.time):
            if b <= a:
                raise ValueError(Phrase("time does not increase: {a:g} s, then {b:g} s", a=a, b=b))
        return self

    def distance_over_time(self, duration: float) -> tuple[Array, Array]:
        """Return times (s) up to ``duration`` and the distance (m) driven at each; between them the speed is constant.

        The speed changes by half a per cent per step.
        """
        nodes = np.array([t for t in self.time if t < duration])
        nodes = np.append(nodes, duration)
        speeds = np.interp(nodes, self.time, self.speed)
        parts = [
            np.linspace(a, b, 1 + max(1, math.ceil(abs(math.log(w / v)) / _SPEED_STEP)))[:-1]
            for (a, v), (b, w) in pairwise(zip(nodes, speeds, strict=True))
        ]
        time = np.append(np.concatenate(parts), duration)
        speed = np.interp(time, self.time, self.speed)
        steps = 0.5 * (speed[1:] + speed[:-1]) * np.diff(time)
        return time, np.concatenate([[0.0], np.cumsum(steps)])

    travelled: ClassVar[Any] = old_method("SpeedOverTime.travelled", "distance_over_time")


_SPEED_STEP = 0.005  # relative speed change per constant step: a distance error of 10 um on a bench


class Trial(Description):
    """One run: a road at a speed, or an excitation over time; for vehicles also manoeuvre loads.

    Attributes
    ----------
    road : Road or None
        Road; requires ``speed`` and ``duration``.
    speed : float or None
        Constant speed in m/s, above 0; the mean if ``speeds`` are given.
    speeds : SpeedOverTime or None
        Varying speed in place of ``speed``, ``{time = [...], speed = [...]}``.
    excitation : Excitation or None
        Excitation in place of road and speed; a path is short for ``{file = path}``.
    duration : float
        Length of the run in s, above 0. By default an excitation is run up to its last sample.
    right : Road or None
        Road under the right wheels of a full car; by default the same road as under the left wheels.
    pitch_moment : PitchMoment or None
        Braking moment on a vehicle's body, N m, positive nose-down; ``"100 N*m"`` is a constant moment.
    deceleration : DrivingAcceleration or None
        Braking deceleration, m/s^2; its moment follows from the body's mass and the height of its centre of gravity.
    lateral_acceleration : DrivingAcceleration or None
        Lateral acceleration of a full car, m/s^2, positive to the left.
    actuator_force : ActuatorForce or None
        Measured force of an actuator parallel to spring and damper of a single corner, a known input.

    Examples
    --------
    >>> from jounce.roads import HalfSine
    >>> trial = Trial(road=HalfSine(height="10 mm", length="60 mm", start="0.39 m"), speed="1.95 m/s", duration="3 s")
    >>> trial.segments().edges.round(4).tolist()
    [0.0, 0.2, 0.2308, 3.0]
    """

    road: Road | None = None
    speed: PositiveSpeed | None = None
    speeds: SpeedOverTime | None = None
    excitation: Annotated[Excitation | None, BeforeValidator(_from_file)] = None
    duration: Annotated[float, Unit("s", above=0.0)] = (
        0.0  # 0 is replaced by the excitation's last time
    )
    right: Road | None = None
    pitch_moment: PitchMoment | None = None
    deceleration: DrivingAcceleration | None = None
    lateral_acceleration: DrivingAcceleration | None = None
    actuator_force: ActuatorForce | None = None

    @model_validator(mode="after")
    def _check_fields(self) -> Self:
        if (self.road is None) == (self.excitation is None):
            given = (
                "both a road and an excitation are"
                if self.road
                else "neither a road nor an excitation is"
            )
            raise error_at(
                (), Phrase("{given} given", given=given), allowed="road and speed, or excitation"
            )
        if self.speeds is not None and self.road is None:
            raise ValueError(
                "speeds are given without a road; an excitation is already a function of time"
            )
        if self.speeds is not None and "duration" in self.model_fields_set:
            mean = float(self.speeds.distance_over_time(self.duration)[1][-1]) / self.duration
            if self.speed is not None and abs(self.speed / mean - 1.0) > _SAME_MEAN:
                raise ValueError(
                    Phrase(
                        "speed ({speed:g} m/s) and speeds (a mean of {mean:g} m/s) are given; leave out speed",
                        speed=self.speed,
                        mean=mean,
                    )
                )
            object.__setattr__(self, "speed", mean)
        if self.road is not None and self.speed is None:
            raise ValueError("the speed is missing; a road needs a speed, e.g. speed = '1.95 m/s'")
        if self.excitation is not None and self.speed is not None:
            raise ValueError(
                "a speed does not apply to an excitation, which is already a function of time; leave out the speed"
            )
        if self.right is not None and self.road is None:
            raise ValueError(
                "right is given without road: the right wheels have a road, the left ones none"
            )
        if "duration" not in self.model_fields_set:
            object.__setattr__(self, "duration", self._default_duration())
        return self

    def at_speed(self, factor: float) -> Trial:
        """Return the same trial driven at a multiple of its speed; one without a speed stays unchanged.

        Parameters
        ----------
        factor : float
            The new speed as a multiple of the old one (1), above 0.

        Returns
        -------
        Trial
            The trial at the new speed.
        """
        if self.speed is None:
            return self
        if self.speeds is not None:
            faster = [factor * speed for speed in self.speeds.speed]
            return self.with_fields(
                speeds=SpeedOverTime(time=self.speeds.time, speed=faster), speed=None
            )
        return self.with_fields(speed=factor * self.speed)

    def _default_duration(self) -> float:
        if self.excitation is None:
            raise ValueError("the duration is missing, e.g. duration = '3 s'")
        end = self.excitation.end()
        if end <= 0.0:
            raise ValueError(
                Phrase(
                    "the excitation's last time is {end:g} s; it must be after 0, where the trial starts",
                    end=end,
                )
            )
        return end

    def segments(self, behind: float = 0.0, side: int = 1) -> Segments:
        """Return the height under a tyre over [0, ``duration``] as closed-form pieces.

        Parameters
        ----------
        behind : float
            Distance of the wheel behind the front axle, m. An excitation moves all wheels simultaneously.
        side : int
            1 for the left road (the only one unless ``right`` is given), -1 for the right one.

        Returns
        -------
        Segments
            Pieces over time in s; heights in m, positive upwards. Every jump in height or slope is an edge.
        """
        cached = _pieces_of(self)
        if cached is None:
            return self._lay_out(behind, side)
        if (behind, side) not in cached:
            if len(cached) >= _MOST_WHEELS:
                cached.clear()
            cached[behind, side] = self._lay_out(behind, side)
        return cached[behind, side]

    def _lay_out(self, behind: float, side: int) -> Segments:
        road = self.right if self.right is not None and side < 0 else self.road
        if road is not None and self.speed is not None:
            driven = road.segments(self.speed * self.duration, behind)
            if self.speeds is None:
                return driven.in_time(self.speed)
            return driven.in_time_along(*self.speeds.distance_over_time(self.duration))
        if self.excitation is None:
            raise AssertionError("a trial has a road or an excitation")
        return lay_out(self.excitation.profile(), [(0.0, 0.0)], 0.0, self.duration)

    def load(self, name: str) -> Segments:
        """Return a manoeuvre load over [0, ``duration``] (s); zero if the trial does not include it."""
        given: PitchMoment | DrivingAcceleration | None = getattr(self, name)
        return flat(self.duration) if given is None else given.segments(self.duration)

    @property
    def loads(self) -> tuple[str, ...]:
        """Return the names of the given manoeuvre loads."""
        return tuple(name for name in LOADS if getattr(self, name) is not None)

    def obstacle_end(self) -> float:
        """Return the time in s at which the obstacle has been passed; 0 for courses and excitations."""
        if self.road is None or self.road.is_course():
            return 0.0
        return self.end()

    def end(self) -> float:
        """Return the end time in s of the last obstacle's first pass or of the excitation, ignoring the duration."""
        if self.road is not None and self.speed is not None:
            if self.speeds is None:
                return self.road.end() / self.speed
            time, distance = self.speeds.distance_over_time(self.duration)
            end = self.road.end()
            beyond = max(end - float(distance[-1]), 0.0) / self.speeds.speed[-1]
            return float(np.interp(end, distance, time)) + beyond
        return self.excitation.end() if self.excitation is not None else 0.0


_MOST_WHEELS = 16  # wheels whose roads are cached: those of four cars


@once_per_object
def _pieces_of(trial: Trial) -> dict[tuple[float, int], Segments] | None:
    """Return the cache of heights under the wheels; None for a road from a file, which may change."""
    return {} if is_lasting(trial) else None


@runtime_checkable
class HoldsTrial(Protocol):
    """Protocol of objects with a trial: a ride trial, a measured trial, or a candidate."""

    @property
    def trial(self) -> Trial:
        """Road, speed and duration."""
        ...


def as_trial(given: Trial | HoldsTrial) -> Trial:
    """Return the trial of an object that has one."""
    return given if isinstance(given, Trial) or not isinstance(given, HoldsTrial) else given.trial


@once_per_object
def is_lasting(trial: Trial) -> bool:
    """Whether a trial's description is complete without files, which may change."""
    return not _names_a_file(trial)


def _names_a_file(value: object) -> bool:
    if isinstance(value, Description):
        return any(_names_a_file(getattr(value, name)) for name in type(value).model_fields)
    return isinstance(value, Path)


FASTEST = 15.0
"""Frequency (Hz) that the points of a road should resolve: typical wheel hop."""
FEWEST_OUTPUTS = 4
"""Minimum number of samples during an obstacle pass; with fewer, peaks are missed."""
_AS_FAR = 0.05
"""Relative tolerance between a road's track distance and the vehicle's track width."""
_UPRIGHT = 100.0  # slope: within 0.6 degrees


def _check_side_forces(trial: Trial, rig: Rig | None) -> Iterator[Finding]:
    """Report loads that a lumped car does not transfer."""
    if trial.lateral_acceleration is not None and isinstance(rig, FullCar):
        yield finding("roads.side_forces_left_out", "trial: lateral_acceleration")


def trial_findings(
    trial: Trial, rig: Rig | None = None, *, output_step: float | None = None
) -> list[Finding]:
    """Report findings about the road and the loads of a run.

    Parameters
    ----------
    trial : Trial
        Trial.
    rig : Rig, optional
        Rig whose axles are checked as well.
    output_step : float, optional
        Time step of the result, s.

    Returns
    -------
    list of Finding
        Findings; empty if no problem was found.

    Examples
    --------
    >>> from jounce.roads import Table
    >>> short = Table(x=[0.0, 0.01, 0.02], height=["0 mm", "2 mm", "0 mm"])
    >>> [found.message for found in trial_findings(Trial(road=short, speed="1 m/s", duration="5 s"))]
    ['the road ends after 0.02 m, but the run covers 5 m; the remainder is level. Shorten the run.']
    """
    behind = rig.wheelbase if isinstance(rig, Vehicle) else 0.0
    result = [
        *_check_loads(trial),
        *_check_side_forces(trial, rig),
        *(trial.excitation.findings() if trial.excitation is not None else ()),
    ]
    if trial.speed is not None:
        result += unit_question("trial: speed", Unit("m/s"), trial.speed)
        for name, road in (("road", trial.road), ("right", trial.right)):
            if road is not None:
                result += _check_road(
                    road, trial.speed, trial.duration, f"trial: {name}", output_step
                )
        result += _check_rear(trial, behind)
        if isinstance(rig, HalfCar) and rig.compat == "physical" and _jumps(trial.segments()):
            result.append(finding("roads.jump_through_dampers", "trial: road"))
        result += _check_blows(trial, rig)
        if isinstance(trial.road, Iso8608) and trial.right is None and _has_sides(rig):
            result.append(finding("roads.same_track", "trial: road"))
        result += _check_tracks(trial, rig)
    return result


def _check_tracks(trial: Trial, rig: Rig | None) -> Iterator[Finding]:
    """Report a road track distance that differs from the vehicle's, because the coherence determines roll."""
    wide = track_width(rig)
    for name, road in (("road", trial.road), ("right", trial.right)):
        if not wide or not isinstance(road, Iso8608) or road.side != "right":
            continue
        if abs(road.track - wide) > _AS_FAR * wide:
            yield finding(
                "roads.tracks_apart",
                f"trial: {name}",
                road.track,
                track=road.track,
                wheel_track=wide,
            )


def road_findings(road: Road, place: str = "") -> list[Finding]:
    """Report implausible sizes of obstacles and waves; measured roads are not checked."""
    if isinstance(road, SampledRoad):
        return []
    start = f"{place}: " if place else ""
    findings = [at_place(f"{start}{item.place}", item) for item in questions(road)]
    while isinstance(road, Train):
        road = road.of
    if (
        not findings
        and isinstance(road, (HalfSine, Versine))
        and abs(road.height) > _STEEPEST * road.length
    ):
        numbers = {"height": road.height, "length": road.length}
        findings.append(finding("roads.higher_than_long", f"{start}height", road.height, **numbers))
    return findings


_STEEPEST = 1.0
"""Height-to-length ratio of a rounded obstacle above which a wrong unit is likely, because it acts like a step."""


def _check_road(
    road: Road, speed: float, duration: float, place: str, output_step: float | None
) -> Iterator[Finding]:
    yield from road_findings(road, place)
    driven = speed * duration
    if road.start >= driven:
        yield finding("roads.starts_after_run", place, duration, start=road.start)
        return
    span = road.profile().span
    if isinstance(road, SampledRoad):
        if road.recurrence is None and road.end() < driven * (1.0 - 1e-9):
            yield finding("roads.ends_before_run", place, road.end(), end=road.end(), driven=driven)
        apart = road.point_spacing() or span
        if speed / (2.0 * apart) < FASTEST:
            yield finding(
                "roads.points_coarse",
                place,
                apart,
                spacing=apart,
                highest=speed / (2.0 * apart),
                speed=speed,
                hop=FASTEST,
            )
    elif output_step is not None and 0.0 < span < FEWEST_OUTPUTS * output_step * speed:
        yield finding(
            "roads.output_coarse",
            place,
            span / speed,
            duration=span / speed,
            output_step=output_step,
        )


def _check_rear(trial: Trial, behind: float) -> Iterator[Finding]:
    road, speed = trial.road, trial.speed
    if road is None or speed is None or behind == 0.0:
        return
    driven = speed * trial.duration
    if (
        road.start < driven <= road.start + behind
        and road.profile().span > 0.0
        and not isinstance(road, SampledRoad)
    ):
        yield finding("roads.rear_after_run", "trial: duration", trial.duration, wheelbase=behind)


def _check_loads(trial: Trial) -> Iterator[Finding]:
    for name in trial.loads:
        load = trial.load(name)
        heights = load.evaluate(np.linspace(0.0, trial.duration, 2 * len(load.edges) + 1))[0]
        given = getattr(trial, name)
        if not np.any(heights) and (given.value or any(given.values)):
            yield finding(
                "roads.load_after_run", f"trial: {name}", trial.duration, duration=trial.duration
            )


def _check_blows(trial: Trial, rig: Rig | None) -> Iterator[Finding]:
    """Report the impulse of a damped tyre on a vertical rise of the road; at a vertical drop the tyre lifts off."""
    numbers = {} if rig is None else rig.parameters()
    damping = max(
        (value for path, value in numbers.items() if path.endswith("tyre.damping_coefficient")),
        default=0.0,
    )
    sides = (1,) if trial.right is None else (1, -1)
    rise = max(float(np.max(trial.segments(side=side).jumps, initial=0.0)) for side in sides)
    if damping > 0.0 and rise > JUMP:
        yield finding(
            "roads.jump_under_tyre_damper",
            "trial: road",
            damping * rise,
            rise=rise,
            blow=damping * rise,
        )
    if damping > 0.0 and any(_rises_upright(trial.segments(side=side)) for side in sides):
        yield finding("roads.upright_under_tyre_damper", "trial: road")


def _rises_upright(signal: Segments) -> bool:
    finite = signal.with_finite_slopes()
    return bool(np.any(finite.evaluate(finite.edges[1:-1])[1] > _UPRIGHT * signal.rate))


def _jumps(signal: Segments) -> bool:
    return bool(np.any(np.abs(signal.jumps) > JUMP))


def _has_sides(rig: Rig | None) -> bool:
    return isinstance(rig, Vehicle) and any(place.side for place in rig.wheels.values())
