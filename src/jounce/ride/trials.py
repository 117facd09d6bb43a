"""Trials for ride studies: a class of ISO 8608 or a measured road under every wheel of a rig or vehicle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.units import positive_si
from jounce.parts import FullCar, FullCar3D, Rig, Vehicle
from jounce.roads import Crg, Trial, check_covered, point_spacing
from jounce.roads.advice import FASTEST
from jounce.roads.coverage import ends_level
from jounce.roads.iso8608 import Iso8608
from jounce.roads.road import Road

DEFAULT_DURATION = 60.0
"""s, of a run over a synthetic road; a measured one is driven to its end."""
_SAMPLE = 1e-3  # s
_RUN_IN = 10.0  # m over which a synthetic road fades in, and out behind the end of the run


@dataclass(frozen=True)
class RideTrial:
    """A trial and the part of it that counts.

    Attributes
    ----------
    trial : Trial
        Road under the left and the right wheels, speed and duration.
    settling : float
        s at the start that metrics leave out: the road fades in, and the last axle has not yet met it.
    """

    trial: Trial
    settling: float


def iso_trial(
    rig: Rig,
    class_: str,
    speed: float | str,
    *,
    duration: float | str = DEFAULT_DURATION,
    seed: int = 0,
    step: float = 0.05,
) -> RideTrial:
    """Drive over a random road of ISO 8608; full cars meet its two coherent tracks.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    class_ : {"A", ..., "H"}
        Road class.
    speed : float or str
        m/s, or text with a unit.
    duration : float or str
        Time over the rough road, s; the time it takes to come in is added in front.
    seed : int
        Which of all roads of that class.
    step : float
        Distance of the road's points, m.

    Returns
    -------
    RideTrial
        The trial, longer than ``duration`` by what it leaves out at its start.

    Raises
    ------
    DescriptionError
        For an unknown class, and numbers out of range.

    Examples
    --------
    >>> import jounce as jn
    >>> ride = iso_trial(jn.load("audi-a6-full-car"), "C", "20 m/s", duration="10 s")
    >>> ride.trial.right.side, round(ride.settling, 4), round(ride.trial.duration, 4)
    ('right', 0.646, 10.646)
    """
    velocity, rough = positive_si(speed, "m/s", where="speed"), positive_si(duration, "s", where="duration")
    settling = _whole_samples((_RUN_IN + _wheelbase(rig)) / velocity)
    lasting = settling + _whole_samples(rough)
    left = Iso8608(class_=class_, length=velocity * lasting + _RUN_IN, step=step, seed=seed, run_in=_RUN_IN)
    if isinstance(rig, FullCar | FullCar3D):
        left = left.model_copy(update={"track": _track(rig)})
        return RideTrial(_trial(left, left.other_track(), velocity, lasting), settling)
    return RideTrial(_trial(left, None, velocity, lasting), settling)


def road_trial(rig: Rig, road: Road, speed: float | str, *, duration: float | str | None = None) -> RideTrial:
    """Drive over a given road; a measured course with a width is read under both tracks of a full car.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    road : Road
        What is driven over.
    speed : float or str
        m/s, or text with a unit.
    duration : float or str, optional
        s; by default, and at most, until the last axle reaches the road's end: the front axle is then one wheelbase
        beyond it. On a road that does not end at the height at which it begins nobody knows how it goes on: there it
        is until the front axle reaches the end.

    Returns
    -------
    RideTrial
        The trial.

    Raises
    ------
    DescriptionError
        For numbers out of range, a run longer than the road, and points too far apart for the speed.

    Examples
    --------
    >>> import jounce as jn
    >>> course = jn.load_road("detrended_rms_course_1in")
    >>> driven = road_trial(jn.load("audi-a6-full-car"), course, "10 m/s")
    >>> driven.trial.duration, round(driven.settling, 6)   # s: the course and the wheelbase; the wheelbase
    (50.766, 0.291)
    """
    behind = _wheelbase(rig)
    velocity = positive_si(speed, "m/s", where="speed")
    left, right = _tracks(rig, road)
    beyond = behind if all(ends_level(side) for side in (left, right) if side is not None) else 0.0
    whole = (road.end() + beyond) / velocity
    if duration is None and whole <= 0.0:
        raise DescriptionError("the road ends where it begins", where="road", hint="Give the duration.")
    lasting = whole if duration is None else positive_si(duration, "s", where="duration")
    check_covered(road, velocity * lasting, behind=beyond, where="duration")
    _check_fine_enough(road, velocity)
    return RideTrial(_trial(left, right, velocity, _whole_samples(lasting)), behind / velocity)


def _check_fine_enough(road: Road, speed: float) -> None:
    """Refuse points so far apart that a drive over them shows no wheel hop."""
    apart = point_spacing(road)
    if apart is not None and speed / (2.0 * apart) < FASTEST:
        raise DescriptionError(
            "the road's points are too far apart for the speed",
            where="road",
            found=f"{apart:.3g} m, which shows nothing above {speed / (2.0 * apart):.3g} Hz at {speed:g} m/s",
            allowed=f"at most {speed / (2.0 * FASTEST):.3g} m: wheels hop at about {FASTEST:g} Hz",
            hint="Take a finer profile, or drive faster.",
        )


def _trial(left: Road, right: Road | None, speed: float, duration: float) -> Trial:
    return Trial(road=left, right=right, speed=speed, duration=duration)


def _whole_samples(time: float) -> float:
    """Time (s) made up to whole output steps, so that signals are uniform to their end."""
    return float(np.ceil(time / _SAMPLE - 1e-6) * _SAMPLE)


def _wheelbase(rig: Rig) -> float:
    return rig.wheelbase if isinstance(rig, Vehicle) else 0.0


def _track(rig: FullCar | FullCar3D) -> float:
    """Distance of the front wheels, m."""
    if isinstance(rig, FullCar):
        return rig.front.track
    return 2.0 * abs(rig.front.corner.hardpoints.wheel_centre[1])


def _tracks(rig: Rig, road: Road) -> tuple[Road, Road | None]:
    """The road under the left and the right wheels."""
    if isinstance(rig, FullCar | FullCar3D) and isinstance(road, Crg):
        half = 0.5 * _track(rig)
        left, right = (road.model_copy(update={"v": road.v + side * half}) for side in (1.0, -1.0))
        try:
            left.profile()
            right.profile()
        except RecordingError:  # too narrow for the car: both sides roll along the given offset
            return road, None
        return left, right
    return road, None
