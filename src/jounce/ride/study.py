"""Ride studies: one rig or vehicle over a road with several controllers, comfort beside travel and road holding."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.control import CONTROLS, Controller, as_controller
from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.core.findings import findings_of
from jounce.core.serialise import Plain, plain_table
from jounce.core.shown import Shown
from jounce.core.units import positive_si
from jounce.parts import FullCar, FullCar3D, Rig, Vehicle
from jounce.parts.rig import check_rig
from jounce.parts.vehicles import track_width
from jounce.recordings.schema import channels_of
from jounce.ride.metrics import RideMetrics, ride_metrics
from jounce.ride.spectra import Spectrum, power_spectrum
from jounce.ride.stationary import StationaryResponse, stationary, with_spectra
from jounce.roads import Crg, Iso8608, Road, Trial
from jounce.roads.trial import FASTEST
from jounce.simulation import simulate
from jounce.simulation.compiled import compile_rig

if TYPE_CHECKING:
    import xarray as xr


# trials ---------------------------------------------------------------------------------------------------------------


DEFAULT_DURATION = 60.0
"""s, of a run over a synthetic road; a measured one is driven to its end."""
_SAMPLE = 1e-3  # s
_RUN_IN = 10.0  # m over which a synthetic road fades in, and out behind the end of the run


@dataclass(frozen=True)
class RideTrial(Shown):
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
    check_rig(rig)
    velocity, rough = positive_si(speed, "m/s", where="speed"), positive_si(duration, "s", where="duration")
    settling = _whole_samples((_RUN_IN + _wheelbase(rig)) / velocity)
    lasting = settling + _whole_samples(rough)
    left = Iso8608(class_=class_, length=velocity * lasting + _RUN_IN, step=step, seed=seed, run_in=_RUN_IN)
    right: Road | None = None
    if isinstance(rig, FullCar | FullCar3D):
        left = left.model_copy(update={"track": track_width(rig)})
        right = left.other_track()
    return RideTrial(Trial(road=left, right=right, speed=velocity, duration=lasting), settling)


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
    behind = _wheelbase(check_rig(rig))
    velocity = positive_si(speed, "m/s", where="speed")
    left, right = _tracks(rig, road)
    beyond = behind if all(side.ends_level() for side in (left, right) if side is not None) else 0.0
    whole = (road.end() + beyond) / velocity
    if duration is None and whole <= 0.0:
        raise DescriptionError("the road ends where it begins", where="road", hint="Give the duration.")
    lasting = whole if duration is None else positive_si(duration, "s", where="duration")
    road.check_covers(velocity * lasting, behind=beyond, where="duration")
    _check_fine_enough(road, velocity)
    trial = Trial(road=left, right=right, speed=velocity, duration=_whole_samples(lasting))
    return RideTrial(trial, behind / velocity)


def _check_fine_enough(road: Road, speed: float) -> None:
    """Refuse points so far apart that a drive over them shows no wheel hop."""
    apart = road.point_spacing()
    if apart is not None and speed / (2.0 * apart) < FASTEST:
        raise DescriptionError(
            "the road's points are too far apart for the speed",
            where="road",
            found=f"{apart:.3g} m, which shows nothing above {speed / (2.0 * apart):.3g} Hz at {speed:g} m/s",
            allowed=f"at most {speed / (2.0 * FASTEST):.3g} m: wheels hop at about {FASTEST:g} Hz",
            hint="Take a finer profile, or drive faster.",
        )


def _whole_samples(time: float) -> float:
    """Time (s) made up to whole output steps, so that signals are uniform to their end."""
    return float(np.ceil(time / _SAMPLE - 1e-6) * _SAMPLE)


def _wheelbase(rig: Rig) -> float:
    return rig.wheelbase if isinstance(rig, Vehicle) else 0.0


def _tracks(rig: Rig, road: Road) -> tuple[Road, Road | None]:
    """The road under the left and the right wheels."""
    if isinstance(rig, FullCar | FullCar3D) and isinstance(road, Crg):
        half = 0.5 * track_width(rig)
        try:
            left, right = (road.model_copy(update={"v": road.v + side * half}) for side in (1.0, -1.0))
            left.profile()
            right.profile()
        except RecordingError:  # too narrow for the car: both sides roll along the given offset
            return road, None
        return left, right
    return road, None


# rides ----------------------------------------------------------------------------------------------------------------


def _as_ride(rig: Rig, trial: RideTrial | Trial) -> RideTrial:
    if not isinstance(trial, Trial):
        return trial
    return RideTrial(trial, _wheelbase(rig) / trial.speed if trial.speed else 0.0)


Progress = Callable[[str], None]
AnyControl = Controller | str | Path | Callable[..., Any]
PASSIVE = "passive"
_BODY = ("body.az", "sprung.az")
_SEGMENT = 8.0  # s: resolves the body's bounce


@dataclass(frozen=True)
class Merit:
    """One column of the comparison: a metric at its place, or the worst of all corners (smaller is better)."""

    name: str
    unit: str
    label: str
    metric: str
    worst: bool = True


MERITS: tuple[Merit, ...] = (
    Merit("comfort", "m/s^2", "body, weighted r.m.s. (Wk)", "weighted_rms", worst=False),
    Merit("body_acceleration", "m/s^2", "body r.m.s.", "rms_acceleration", worst=False),
    Merit("travel", "m", "strut travel r.m.s., worst corner", "travel_rms"),
    Merit("travel_range", "m", "strut travel, whole range, worst corner", "travel_peak_to_peak"),
    Merit("load_coefficient", "1", "dynamic wheel load coefficient, worst corner", "dynamic_load_coefficient"),
    Merit("lift_off", "1", "time lifted off, worst corner", "lift_off_time"),
)
"""Comfort, travel and road holding as the comparison shows them."""


@dataclass(frozen=True)
class Ride(Plain):
    """One run of the study.

    Attributes
    ----------
    control : str
        Name of the controller, or of its file or function.
    run : xarray.Dataset
        Signals, SI.
    metrics : RideMetrics
        What they amount to.
    merits : dict
        The columns of the comparison that the rig has, SI.
    settling : float
        Time at the start that is left out of everything, s.
    """

    control: str
    run: xr.Dataset = field(repr=False)
    metrics: RideMetrics
    merits: dict[str, float]
    settling: float = 0.0

    @property
    def settled(self) -> xr.Dataset:
        """Signals from the settling time on, SI."""
        return self.run.sel(time=slice(self.settling, None))

    @property
    def duration(self) -> float:
        """Time that counts, s."""
        time = self.settled["time"].to_numpy()
        return float(time[-1] - time[0])

    def spectra(self) -> dict[str, Spectrum]:
        """Power spectral densities by channel: body acceleration, and the load of every wheel where there are tyres.

        Pieces are an eighth of the run, at least 8 s, so that they resolve the body's bounce, and at most half of it.
        """
        signals = self.settled
        rate = 1.0 / float(signals["time"][1] - signals["time"][0])
        channels = list(map(str, signals.data_vars))
        found = [channels_of(name, channels) for name in (*_BODY, "tyre.force")]
        names = [*(found[0] or found[1])[:1], *found[2]]
        segment = min(max(self.duration / 8.0, _SEGMENT), self.duration / 2.0)
        return {name: power_spectrum(signals[name].to_numpy(), rate, segment=segment) for name in names}

    def standard_deviation(self, channel: str) -> float:
        """Of a channel after settling, in its SI unit."""
        return float(self.settled[channel].std())

    def to_dict(self) -> dict[str, Any]:
        """Give plain values, SI; signals stay out."""
        found: dict[str, dict[str, float]] = {}
        for item in self.metrics.values:
            found.setdefault(item.metric, {})[item.place] = item.value
        table = {
            "control": self.control,
            "status": str(self.run.attrs["status"]),
            "merits": self.merits,
            "metrics": found,
            "comfort": self.metrics.comfort,
            "absent": self.metrics.absent,
            "findings": self.metrics.findings,
        }
        return plain_table(table)


@dataclass(frozen=True)
class RideStudy(Plain):
    """Rides of one rig over one trial.

    Attributes
    ----------
    trial : RideTrial
        Road, speed, duration and what is left out at the start.
    rides : tuple of Ride
        One for each controller that reached the end.
    failed : dict
        Controller to the reason why there is no ride.
    stationary : StationaryResponse or None
        For passive rides over ISO roads what the linear model says without simulation.
    """

    trial: RideTrial
    rides: tuple[Ride, ...]
    failed: dict[str, str]
    stationary: StationaryResponse | None = None

    @property
    def by_chance(self) -> dict[str, float | None]:
        """By what share (1) standard deviations of the passive ride differ by chance from the linear model's.

        Channel to half of the 95 % interval, None where the spectrum is not known; empty without such a ride.
        """
        passive = next((ride for ride in self.rides if ride.control == "passive"), None)
        if self.stationary is None or passive is None:
            return {}
        return {name: self.stationary.chance(name, passive.duration) for name in self.stationary.standard_deviation}

    def ride(self, control: str) -> Ride:
        """Give the ride of a controller by its name."""
        for ride in self.rides:
            if ride.control == control:
                return ride
        allowed = ", ".join(ride.control for ride in self.rides)
        raise DescriptionError("no ride of that controller", where=control, allowed=allowed)

    def to_dict(self) -> dict[str, Any]:
        """Give plain values, SI."""
        table: dict[str, Any] = {
            "speed": self.trial.trial.speed,
            "duration": self.trial.trial.duration,
            "settling": self.trial.settling,
            "runs": self.rides,
            "failed": self.failed,
        }
        if self.stationary is not None:
            table["stationary"] = {**self.stationary.to_dict(), "by_chance": self.by_chance}
        return plain_table(table)


def drive(rig: Rig, trial: RideTrial | Trial, control: AnyControl | None = None) -> Ride:
    """Drive once and say what it amounts to.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : RideTrial or Trial
        From :func:`jounce.ride.study.iso_trial` or ``road_trial``; of a plain trial, what comes before the last axle
        has reached its begin does not count.
    control : Controller, str, Path, callable or None
        As for :func:`jounce.simulate`; the rig as it is without one.

    Returns
    -------
    Ride
        Signals and metrics, SI.

    Raises
    ------
    SimulationError
        When the run does not reach its end.
    RecordingError
        When the trial is too short for its settling time.

    Examples
    --------
    >>> import jounce as jn
    >>> from jounce.ride.study import iso_trial
    >>> car = jn.load("audi-a6-half-car-4dof")
    >>> driven = drive(car, iso_trial(car, "B", 20.0, duration=5.0))
    >>> driven.control, 0.2 < driven.merits["comfort"] < 0.8
    ('passive', True)
    """
    trial = _as_ride(rig, trial)
    run = simulate(rig, trial.trial, control=control)
    metrics = ride_metrics(run, rig, settling=trial.settling)
    for missing in metrics.absent:
        if missing.metric == "weighted_rms":
            raise RecordingError(missing.reason, where=missing.place, hint="Drive for longer (duration).")
    metrics = replace(metrics, findings=(*metrics.findings, *findings_of(run.attrs)))
    return Ride(control_name(control), run, metrics, _merits(metrics), trial.settling)


def compare_rides(
    rig: Rig,
    trial: RideTrial | Trial,
    controls: Sequence[AnyControl] = (PASSIVE,),
    *,
    progress: Progress = lambda _: None,
) -> RideStudy:
    """Drive the same trial with several controllers; what cannot be driven is listed with its reason.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : RideTrial or Trial
        What is driven.
    controls : sequence of Controller, str, Path or callable
        Controllers, their names or files, or Python functions; ``"passive"`` is the rig as it is.
    progress : callable
        Told what goes on.

    Returns
    -------
    RideStudy
        Rides, and what failed.

    Raises
    ------
    DescriptionError
        For an unknown controller.
    JounceError
        Where not a single controller reached the end: the error of the first.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.load("audi-a6-half-car-4dof")
    >>> study = compare_rides(car, jn.iso_trial(car, "C", "20 m/s", duration="5 s"), ["passive", "skyhook"])
    >>> study.ride("skyhook").merits["comfort"] < study.ride("passive").merits["comfort"]
    True
    """
    trial = _as_ride(rig, trial)
    chosen = [as_controller(control) for control in controls]
    rides, failed = [], {}
    problem: JounceError | None = None
    for k, (given, control) in enumerate(zip(controls, chosen, strict=True), 1):
        name = control_name(given)
        progress(f"driving {k} of {len(chosen)}: {name}")
        try:
            rides.append(replace(drive(rig, trial, None if name == PASSIVE else control), control=name))
        except JounceError as error:
            failed[name], problem = str(error), problem or error
    if problem is not None and not rides:
        raise problem
    return RideStudy(trial, tuple(rides), failed, _stationary(rig, trial, [ride.control for ride in rides]))


def all_controls() -> tuple[str, ...]:
    """Names of all controllers that come with jounce, the passive rig first."""
    return (PASSIVE, *(name for name in CONTROLS if name != PASSIVE))


def control_name(control: AnyControl | None) -> str:
    """Give the name under which a controller is reported."""
    if control is None:
        return PASSIVE
    if isinstance(control, Controller):
        return control.name
    if isinstance(control, str | Path):
        return Path(control).stem if str(control).endswith(".toml") else str(control)
    return str(getattr(control, "__name__", "function"))


def _merits(metrics: RideMetrics) -> dict[str, float]:
    """Columns of the comparison that a recording gives."""
    found = {}
    for merit in MERITS:
        values = {item.place: item.value for item in metrics.values if item.metric == merit.metric}
        if merit.worst and values:
            found[merit.name] = max(values.values())
        elif not merit.worst:
            body = next((place for place in _BODY if place in values), None)
            if body is not None:
                found[merit.name] = values[body]
    return found


def _stationary(rig: Rig, trial: RideTrial, names: Sequence[str]) -> StationaryResponse | None:
    """What the linear model says of an ISO road, for the rig as it is."""
    road, speed = trial.trial.road, trial.trial.speed
    if PASSIVE not in names or not isinstance(road, Iso8608) or speed is None:
        return None
    channels = compile_rig(rig).output_names
    weighting = {name: "Wk" for name in _BODY if channels_of(name, channels)}
    return with_spectra(stationary(rig, road.degree_of_roughness, speed, band="iso", weighting=weighting), rig)
