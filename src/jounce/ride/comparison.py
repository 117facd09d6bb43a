"""Ride studies: one rig or vehicle over a road with several controllers, comfort beside travel and road holding."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jounce.control import Controller
from jounce.control.catalogue import CONTROLS, as_controller
from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.core.serialise import to_plain
from jounce.parts import Rig
from jounce.recordings.schema import channels_of
from jounce.ride.metrics import RideMetrics, ride_metrics
from jounce.ride.spectra import Spectrum, power_spectrum
from jounce.ride.stationary import StationaryResponse, stationary
from jounce.ride.trials import RideTrial
from jounce.roads.iso8608 import Iso8608
from jounce.simulation import simulate

if TYPE_CHECKING:
    import xarray as xr

Progress = Callable[[str], None]
AnyControl = Controller | str | Path | Callable[..., Any]
PASSIVE = "passive"
_BODY = ("body.az", "sprung.az")


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
class Ride:
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

    def spectra(self) -> dict[str, Spectrum]:
        """Power spectral densities by channel: body acceleration, and wheel load where the rig has a tyre."""
        signals = self.settled
        rate = 1.0 / float(signals["time"][1] - signals["time"][0])
        channels = list(map(str, signals.data_vars))
        found = [channels_of(name, channels) for name in (*_BODY, "tyre.force")]
        names = [*(found[0] or found[1])[:1], *found[2][:1]]
        return {name: power_spectrum(signals[name].to_numpy(), rate) for name in names}

    def standard_deviation(self, channel: str) -> float:
        """Of a channel after settling, in its SI unit."""
        return float(self.settled[channel].std())

    def to_dict(self) -> dict[str, Any]:
        """Give plain values, SI; signals stay out."""
        found: dict[str, dict[str, float]] = {}
        for item in self.metrics.values:
            found.setdefault(item.metric, {})[item.place] = item.value
        return {
            "control": self.control,
            "status": str(self.run.attrs["status"]),
            "merits": self.merits,
            "metrics": found,
            "comfort": self.metrics.comfort,
            "absent": to_plain(self.metrics.absent),
            "findings": to_plain(self.metrics.findings),
        }


@dataclass(frozen=True)
class RideStudy:
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

    def ride(self, control: str) -> Ride:
        """Give the ride of a controller by its name."""
        for ride in self.rides:
            if ride.control == control:
                return ride
        allowed = ", ".join(ride.control for ride in self.rides)
        raise DescriptionError("no ride of that controller", where=control, allowed=allowed)

    def to_dict(self) -> dict[str, Any]:
        """Give plain values, SI."""
        plain = {
            "speed": self.trial.trial.speed,
            "duration": self.trial.trial.duration,
            "settling": self.trial.settling,
            "runs": [ride.to_dict() for ride in self.rides],
            "failed": self.failed,
        }
        if self.stationary is not None:
            plain["stationary"] = self.stationary.to_dict()
        return plain


def drive(rig: Rig, trial: RideTrial, control: AnyControl | None = None) -> Ride:
    """Drive once and say what it amounts to.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : RideTrial
        From :func:`jounce.ride.trials.iso_trial` or ``road_trial``.
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
    >>> from jounce.ride.trials import iso_trial
    >>> car = jn.load("audi-a6-half-car-4dof")
    >>> driven = drive(car, iso_trial(car, "B", 20.0, duration=5.0))
    >>> driven.control, 0.2 < driven.merits["comfort"] < 0.8
    ('passive', True)
    """
    run = simulate(rig, trial.trial, control=control)
    metrics = ride_metrics(run, rig, settling=trial.settling)
    for missing in metrics.absent:
        if missing.metric == "weighted_rms":
            raise RecordingError(missing.reason, where=missing.place, hint="Drive for longer (duration).")
    return Ride(control_name(control), run, metrics, _merits(metrics), trial.settling)


def compare_rides(
    rig: Rig, trial: RideTrial, controls: Sequence[AnyControl] = (PASSIVE,), *, progress: Progress = lambda _: None
) -> RideStudy:
    """Drive the same trial with several controllers; what cannot be driven is listed with its reason.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : RideTrial
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
    chosen = [as_controller(control) for control in controls]
    rides, failed = [], {}
    problem: JounceError | None = None
    for given, control in zip(controls, chosen, strict=True):
        name = control_name(given)
        progress(f"driving: {name}")
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
    weighting = {name: "Wk" for name in _BODY if channels_of(name, _channels(rig))}
    return stationary(rig, road.degree_of_roughness, speed, band="iso", weighting=weighting)


def _channels(rig: Rig) -> tuple[str, ...]:
    from jounce.simulation.compiled import compile_rig

    return compile_rig(rig).output_names
