"""Ride studies: comparison of comfort, travel and road holding of one rig on one road with several controllers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.control import CONTROLS, Controller, as_controller
from jounce.core.display import size
from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.core.findings import findings_of
from jounce.core.old_names import old_property
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain, plain_table
from jounce.core.shown import Shown
from jounce.core.units import positive_si
from jounce.core.waiting import progress_through
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
"""Duration of a run over a synthetic road, s; a measured road is driven to its end."""
_SAMPLE = 1e-3  # s: the output step of a run
_RUN_IN = 10.0  # m over which a synthetic road fades in, and out after the end of the run


@dataclass(frozen=True)
class RideTrial(Shown):
    """A trial and the time at its start that the metrics skip.

    Attributes
    ----------
    trial : Trial
        Road under the left and the right wheels, speed and duration.
    settling : float
        Time skipped at the start, s: the road fades in, and the last axle has not yet reached it.
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
    """Create a trial over a random ISO 8608 road; full cars follow its two coherent tracks.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    class_ : {"A", ..., "H"}
        Road class.
    speed : float or str
        m/s, or text with a unit.
    duration : float or str
        Time over the rough road, s, in addition to the fade-in.
    seed : int
        Seed of the random road.
    step : float
        Spacing of the road's points, m.

    Returns
    -------
    RideTrial
        Trial, longer than ``duration`` by its settling time.

    Raises
    ------
    DescriptionError
        If the class is unknown or a number out of range.

    Examples
    --------
    >>> import jounce as jn
    >>> ride = iso_trial(jn.load("audi-a6-full-car"), "C", "20 m/s", duration="10 s")
    >>> ride.trial.right.side, round(ride.settling, 4), round(ride.trial.duration, 4)
    ('right', 0.646, 10.646)
    """
    check_rig(rig)
    velocity, rough = (
        positive_si(speed, "m/s", where="speed"),
        positive_si(duration, "s", where="duration"),
    )
    settling = _whole_samples((_RUN_IN + _wheelbase(rig)) / velocity)
    run_time = settling + _whole_samples(rough)
    left = Iso8608(
        class_=class_, length=velocity * run_time + _RUN_IN, step=step, seed=seed, run_in=_RUN_IN
    )
    right: Road | None = None
    if isinstance(rig, FullCar | FullCar3D):
        left = left.model_copy(update={"track": track_width(rig)})
        right = left.other_track()
    return RideTrial(Trial(road=left, right=right, speed=velocity, duration=run_time), settling)


def road_trial(
    rig: Rig, road: Road, speed: float | str, *, duration: float | str | None = None
) -> RideTrial:
    """Create a trial over a given road; a full car follows the two tracks of a measured course with a width.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    road : Road
        Road to drive over.
    speed : float or str
        m/s, or text with a unit.
    duration : float or str, optional
        Duration, s; by default, and at most, until the last axle reaches the road's end, with the front axle one
        wheelbase beyond it. If start and end heights differ, the continuation is unknown, and the run ends when the
        front axle reaches the end.

    Returns
    -------
    RideTrial
        The trial.

    Raises
    ------
    DescriptionError
        If a number is out of range, the run is longer than the road, or the points are too far apart for the speed.

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
    longest = (road.end() + beyond) / velocity
    if duration is None and longest <= 0.0:
        raise DescriptionError("the road has no length", where="road", hint="Give the duration.")
    run_time = longest if duration is None else positive_si(duration, "s", where="duration")
    road.check_covers(velocity * run_time, behind=beyond, where="duration")
    _check_fine_enough(road, velocity)
    trial = Trial(road=left, right=right, speed=velocity, duration=_whole_samples(run_time))
    return RideTrial(trial, behind / velocity)


def _check_fine_enough(road: Road, speed: float) -> None:
    """Raise an error if the road's points are too far apart to excite wheel hop at this speed."""
    spacing = road.point_spacing()
    if spacing is not None and speed / (2.0 * spacing) < FASTEST:
        raise DescriptionError(
            "the road's points are too far apart for the speed",
            where="road",
            found=f"{spacing:.3g} m, which shows nothing above {speed / (2.0 * spacing):.3g} Hz at {speed:g} m/s",
            allowed=Phrase(
                "at most {speed:.3g} m: wheels hop at about {fastest:g} Hz",
                speed=speed / (2.0 * FASTEST),
                fastest=FASTEST,
            ),
            hint="Use a finer profile, or drive faster.",
        )


def _whole_samples(time: float) -> float:
    """Round a time (s) up to whole output steps, for uniform signals up to the end."""
    return float(np.ceil(time / _SAMPLE - 1e-6) * _SAMPLE)


def _wheelbase(rig: Rig) -> float:
    return rig.wheelbase if isinstance(rig, Vehicle) else 0.0


def _tracks(rig: Rig, road: Road) -> tuple[Road, Road | None]:
    """Return the roads under the left and the right wheels; the second is None if both sides share the first."""
    if isinstance(rig, FullCar | FullCar3D) and isinstance(road, Crg):
        half = 0.5 * track_width(rig)
        try:
            left, right = (
                road.model_copy(update={"v": road.v + side * half}) for side in (1.0, -1.0)
            )
            left.profile()
            right.profile()
        except RecordingError:  # too narrow for the car: both sides follow the given offset
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
_SEGMENT = 8.0  # s: a resolution of 0.2 Hz separates bounce and pitch of the body (1 to 2 Hz)


@dataclass(frozen=True)
class Merit:
    """One column of the comparison: a metric at one place or at the worst corner (smaller is better)."""

    name: str
    unit: str
    label: str
    metric: str
    worst: bool = True


MERITS: tuple[Merit, ...] = (
    Merit("comfort", "m/s^2", "body, weighted r.m.s. (Wk)", "weighted_rms", worst=False),
    Merit("body_acceleration", "m/s^2", "body r.m.s.", "rms_acceleration", worst=False),
    Merit("travel", "m", "strut travel r.m.s., worst corner", "travel_rms"),
    Merit("travel_range", "m", "strut travel, peak to peak, worst corner", "travel_peak_to_peak"),
    Merit(
        "load_coefficient",
        "1",
        "dynamic wheel load coefficient, worst corner",
        "dynamic_load_coefficient",
    ),
    Merit("lift_off", "1", "time off the ground, worst corner", "lift_off_time"),
)
"""Comfort, travel and road holding, the columns of the comparison."""


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
        Ride metrics of those signals.
    merits : dict
        Values of the comparison's columns that the rig has, SI.
    settling : float
        Time skipped at the start, s.
    """

    control: str
    run: xr.Dataset = field(repr=False)
    metrics: RideMetrics
    merits: dict[str, float]
    settling: float = 0.0

    @property
    def evaluated_run(self) -> xr.Dataset:
        """Signals after the settling time, SI."""
        return self.run.sel(time=slice(self.settling, None))

    settled = old_property("Ride.settled", "evaluated_run")

    @property
    def duration(self) -> float:
        """Evaluated time, s."""
        time = self.evaluated_run["time"].to_numpy()
        return float(time[-1] - time[0])

    def spectra(self) -> dict[str, Spectrum]:
        """Power spectral densities by channel: body acceleration, and the load of every wheel with a tyre.

        Segments are an eighth of the run, at least 8 s to resolve the body's bounce, and at most half of the run.
        """
        signals = self.evaluated_run
        rate = 1.0 / float(signals["time"][1] - signals["time"][0])
        channels = list(map(str, signals.data_vars))
        matches = [channels_of(name, channels) for name in (*_BODY, "tyre.force")]
        names = [*(matches[0] or matches[1])[:1], *matches[2]]
        segment = min(max(self.duration / 8.0, _SEGMENT), self.duration / 2.0)
        return {
            name: power_spectrum(signals[name].to_numpy(), rate, segment=segment) for name in names
        }

    def standard_deviation(self, channel: str) -> float:
        """Standard deviation of a channel after settling, in its SI unit."""
        return float(self.evaluated_run[channel].std())

    def to_dict(self) -> dict[str, Any]:
        """Return plain values in SI, without signals."""
        by_metric: dict[str, dict[str, float]] = {}
        for item in self.metrics.values:
            by_metric.setdefault(item.metric, {})[item.place] = item.value
        table = {
            "control": self.control,
            "status": str(self.run.attrs["status"]),
            "merits": self.merits,
            "metrics": by_metric,
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
        Road, speed, duration, and the time skipped at the start.
    rides : tuple of Ride
        One ride per controller that reached the end.
    failed : dict
        Reason by controller, for failed rides.
    stationary : StationaryResponse or None
        Response of the linear model, without simulation, for passive rides over ISO roads.
    rig : Rig or None
        Rig or vehicle that was driven.
    """

    trial: RideTrial
    rides: tuple[Ride, ...]
    failed: dict[str, str]
    stationary: StationaryResponse | None = None
    rig: Rig | None = field(default=None, repr=False)

    @property
    def by_chance(self) -> dict[str, float | None]:
        """Relative sampling error (1) of the passive ride's standard deviations about the linear model's.

        Half of the 95 % interval by channel, None if the spectrum is unknown; empty without such a ride.
        """
        passive = next((ride for ride in self.rides if ride.control == "passive"), None)
        if self.stationary is None or passive is None:
            return {}
        return {
            name: self.stationary.chance(name, passive.duration)
            for name in self.stationary.standard_deviation
        }

    def ride(self, control: str) -> Ride:
        """Return the ride of a controller by its name."""
        for ride in self.rides:
            if ride.control == control:
                return ride
        allowed = ", ".join(ride.control for ride in self.rides)
        raise DescriptionError("no ride with this controller", where=control, allowed=allowed)

    def recording(self) -> xr.Dataset:
        """Return the signals of the only ride, SI."""
        if len(self.rides) != 1:
            raise DescriptionError(
                "a recording can hold only one ride",
                found=", ".join(ride.control for ride in self.rides),
            )
        return self.rides[0].run

    @property
    def driven(self) -> str:
        """Controller of a single ride, between commas; empty for several rides, which have a legend."""
        return f", {self.rides[0].control}," if len(self.rides) + len(self.failed) == 1 else ""

    @property
    def at_speed(self) -> str:
        """Speed in words."""
        return size(self.trial.trial.speed or 0.0, "m/s", "speed")

    def to_dict(self) -> dict[str, Any]:
        """Return plain values in SI."""
        road = self.trial.trial.road
        table: dict[str, Any] = {"seed": road.seed} if isinstance(road, Iso8608) else {}
        table |= {
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
    """Simulate one ride and compute its metrics.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : RideTrial or Trial
        Trial from :func:`jounce.ride.study.iso_trial` or ``road_trial``. For a plain trial, the time until the last
        axle reaches the start of the road is skipped.
    control : Controller, str, Path, callable or None
        As for :func:`jounce.simulate`; None keeps the rig passive.

    Returns
    -------
    Ride
        Signals and metrics, SI.

    Raises
    ------
    SimulationError
        If the run stops early.
    RecordingError
        If the trial is too short for its settling time.

    Examples
    --------
    >>> import jounce as jn
    >>> from jounce.ride.study import iso_trial
    >>> car = jn.load("audi-a6-half-car-4dof")
    >>> ride = drive(car, iso_trial(car, "B", 20.0, duration=5.0))
    >>> ride.control, 0.2 < ride.merits["comfort"] < 0.8
    ('passive', True)
    """
    trial = _as_ride(rig, trial)
    run = simulate(rig, trial.trial, control=control)
    metrics = ride_metrics(run, rig, settling=trial.settling)
    for missing in metrics.absent:
        if missing.metric == "weighted_rms":
            raise RecordingError(
                missing.reason,
                where=missing.place,
                hint="Increase the duration of the ride (duration).",
            )
    metrics = replace(metrics, findings=(*metrics.findings, *findings_of(run.attrs)))
    return Ride(control_name(control), run, metrics, _merits(metrics), trial.settling)


def compare_rides(
    rig: Rig,
    trial: RideTrial | Trial,
    controls: Sequence[AnyControl] = (PASSIVE,),
    *,
    progress: Progress = lambda _: None,
) -> RideStudy:
    """Drive the same trial with several controllers; those that fail are listed with the reason.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : RideTrial or Trial
        Road, speed and duration.
    controls : sequence of Controller, str, Path or callable
        Controllers, their names or files, or Python functions; ``"passive"`` is the rig without a controller.
    progress : callable
        Receives a message for each ride.

    Returns
    -------
    RideStudy
        Rides, and the reasons of those that failed.

    Raises
    ------
    DescriptionError
        If a controller is unknown.
    JounceError
        If no controller reaches the end; the error is that of the first.

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
    rides, failed = [], dict[str, str]()
    first_error: JounceError | None = None
    for k, (given, control) in enumerate(zip(controls, chosen, strict=True), 1):
        name = control_name(given)
        progress(progress_through("driving {which} of {count}: {name}", k, len(chosen), name=name))
        try:
            rides.append(
                replace(drive(rig, trial, None if name == PASSIVE else control), control=name)
            )
        except JounceError as error:
            failed[name], first_error = error.message(), first_error or error
    if first_error is not None and not rides:
        raise first_error
    response = _stationary(rig, trial, [ride.control for ride in rides])
    return RideStudy(trial, tuple(rides), failed, response, rig)


def all_controls() -> tuple[str, ...]:
    """Return the names of all built-in controllers, starting with the passive rig."""
    return (PASSIVE, *(name for name in CONTROLS if name != PASSIVE))


def control_name(control: AnyControl | None) -> str:
    """Return the name under which a controller is reported."""
    if control is None:
        return PASSIVE
    if isinstance(control, Controller):
        return control.name
    if isinstance(control, str | Path):
        return Path(control).stem if str(control).endswith(".toml") else str(control)
    return str(getattr(control, "__name__", "function"))


def _merits(metrics: RideMetrics) -> dict[str, float]:
    """Return the columns of the comparison that a recording supports."""
    merits = {}
    for merit in MERITS:
        values = {item.place: item.value for item in metrics.values if item.metric == merit.metric}
        if merit.worst and values:
            merits[merit.name] = max(values.values())
        elif not merit.worst:
            body = next((place for place in _BODY if place in values), None)
            if body is not None:
                merits[merit.name] = values[body]
    return merits


def _stationary(rig: Rig, trial: RideTrial, names: Sequence[str]) -> StationaryResponse | None:
    """Return the stationary response of the passive rig on an ISO road; None for other roads."""
    road, speed = trial.trial.road, trial.trial.speed
    if PASSIVE not in names or not isinstance(road, Iso8608) or speed is None:
        return None
    channels = compile_rig(rig).output_names
    weighting = {name: "Wk" for name in _BODY if channels_of(name, channels)}
    return with_spectra(
        stationary(rig, road.degree_of_roughness, speed, band="iso", weighting=weighting), rig
    )
