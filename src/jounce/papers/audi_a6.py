"""Paper 2's half car: an Audi A6 brakes onto an obstacle (case A) and accelerates into a pothole (case B)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

import jounce as jn
from jounce.papers import Array, Progress, no_progress
from jounce.papers.audi_a6_paper import (
    Erratum,
    PrintedSign,
    StartUp,
    paper_errata,
    printed_sign,
    start_up,
)

if TYPE_CHECKING:
    import xarray as xr

CaseName = Literal["case-a", "case-b"]
VEHICLE = "audi-a6-half-car"
VARIANTS = ("simulink", "sign-corrected", "physical")
SPEED, RAMP = 10.0, 0.5
"""Driving speed (m/s) and length of the raised-cosine ramps (m) of the physical variant; estimated."""
DRIVING, ON, OFF, DURATION = 3.0, 6.0, 8.0, 10.0
"""Times at which the moment begins, the front axle reaches and leaves the obstacle, and the run ends, s."""
WINDOWS = ((DRIVING, ON), (ON, OFF), (OFF, DURATION))
DEMO_MOMENT = 100.0
"""Step of the pitch moment in the demo on which the paper is based, N m."""
DECELERATION, CENTRE_HEIGHT = 3.0, 0.55
"""Deceleration (m/s^2) and height of the centre of gravity (m) for a second pitch moment; estimated."""
_TOLERANCE = 1e-9  # far below the three digits printed in the paper
_FINE = 1e-4  # s: the channels have no time derivative of accelerations for interpolation


@dataclass(frozen=True)
class Window:
    """Extremes of a signal (SI unit) within a closed time window, and the times (s) of their first occurrence."""

    start: float
    end: float
    min: float
    t_min: float
    max: float
    t_max: float


def extremes_within(time: Array, value: Array, rate: Array, start: float, end: float) -> Window:
    """Find the extremes within a window (s) of a signal with known samples and time derivatives (SI).

    Between samples the signal is interpolated by a cubic Hermite polynomial, with an error of fourth order in the
    sample distance. The rate must not jump; the ends of the window are included.

    Examples
    --------
    >>> t = np.linspace(0.0, 1.0, 51)
    >>> found = extremes_within(t, np.sin(6.0 * t), 6.0 * np.cos(6.0 * t), 0.0, 1.0)
    >>> round(found.max, 5), round(found.t_max, 5), round(found.min, 5)
    (1.0, 0.2618, -1.0)
    """
    from scipy.interpolate import CubicHermiteSpline

    slack = 1e-9 * max(1.0, abs(end))
    if not (start < end and time[0] - slack <= start and end <= time[-1] + slack):
        raise jn.RecordingError(
            "unknown time window",
            found=f"{start:g} to {end:g} s",
            allowed=f"within {time[0]:g} to {time[-1]:g} s",
        )
    signal = CubicHermiteSpline(time, value, rate)
    level = signal.derivative().roots(extrapolate=False)  # NaN for a constant piece
    at = np.sort([start, end, *level[(level >= start) & (level <= end)]])
    values = signal(at)
    low, high = int(np.argmin(values)), int(np.argmax(values))
    return Window(
        start, end, float(values[low]), float(at[low]), float(values[high]), float(at[high])
    )


@dataclass(frozen=True)
class Case:
    """One of the paper's two cases: obstacle ``height`` in m, ``sign`` of the pitch moment (1 nose down, -1 up)."""

    name: CaseName
    title: str
    height: float
    sign: float
    figures: tuple[int, int]


CASES: dict[str, Case] = {
    case.name: case
    for case in (
        Case("case-a", "Case A: braking onto a 5 cm obstacle", 0.05, 1.0, (12, 13)),
        Case("case-b", "Case B: accelerating into a 2 cm pothole", -0.02, -1.0, (14, 15)),
    )
}


@dataclass(frozen=True)
class AxleStatics:
    """One axle at rest: ``force`` of both wheels and ``force_per_wheel`` in N, ``compression`` of a spring in m."""

    force: float
    force_per_wheel: float
    compression: float


@dataclass(frozen=True)
class StaticEquilibrium:
    """Static equilibrium: height ``z`` (m) of the centre of gravity, pitch ``theta`` (rad, nose down), and axles."""

    z: float
    theta: float
    front: AxleStatics
    rear: AxleStatics


@dataclass(frozen=True)
class CaseRun(jn.Plain):
    """One pitch moment (N m from 3 s on, nose down positive) in one of the `VARIANTS`.

    ``outputs`` has the extremes of ``z`` (m, up) and ``theta`` (rad, nose down) as changes from the ``statics``;
    ``peak_acceleration`` is the maximum magnitude at the body's centre of gravity from 6 s to 8 s (m/s^2);
    ``least_wheel_force`` is the minimum force on one wheel (N), negative if the model pulls at the road.
    """

    moment: float
    variant: str
    statics: StaticEquilibrium
    outputs: dict[str, tuple[Window, ...]]
    peak_acceleration: float
    least_wheel_force: float
    signals: xr.Dataset

    def to_dict(self) -> dict[str, Any]:
        """Return the results as plain data in SI, without signals."""
        return jn.plain_table(
            {
                "moment": self.moment,
                "variant": self.variant,
                "statics": self.statics,
                "outputs": {name: {"windows": windows} for name, windows in self.outputs.items()},
                "peak_acceleration": self.peak_acceleration,
                "least_wheel_force": self.least_wheel_force,
            }
        )


@dataclass(frozen=True)
class AudiCase(jn.Plain):
    """Results of one case of the paper.

    Attributes
    ----------
    case : Case
        The case.
    vehicle : HalfCar
        The vehicle of the paper's Table 2.
    runs : tuple of CaseRun
        Runs of each moment in all variants.
    modes : tuple of Mode
        Bounce and pitch modes; the same in all variants.
    printed : PrintedSign
        Consequences of the printed sign of eq. (9).
    start_up : StartUp
        Consequences of the demo's initial height.
    errata : tuple of Erratum
        Values printed in the paper with the corrected ones.
    findings : tuple of Finding
        Warnings about the results.
    """

    case: Case
    vehicle: jn.HalfCar
    runs: tuple[CaseRun, ...]
    modes: tuple[jn.Mode, ...]
    printed: PrintedSign
    start_up: StartUp
    errata: tuple[Erratum, ...]
    findings: tuple[jn.Finding, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return the results as plain data in SI, without signals."""
        return jn.plain_table(
            {
                "case": self.case.name,
                "vehicle": self.vehicle.model_dump(by_alias=True, exclude_none=True),
                "obstacle_height": self.case.height,
                "runs": self.runs,
                "modes": self.modes,
                "printed_sign_of_eq_9": self.printed,
                "start_up_of_the_demo": self.start_up,
                "paper": self.errata,
                "findings": self.findings,
            }
        )


def run_audi_a6(name: str, *, progress: Progress = no_progress) -> AudiCase:
    """Run one of the paper's cases: two pitch moments, each in all three variants of the half car.

    Braking (case A, moment positive) or accelerating (case B, moment negative) begins at 3 s; the front axle is on a
    5 cm obstacle (A) or in a 2 cm pothole (B) from 6 s to 8 s; the run ends at 10 s.

    Parameters
    ----------
    name : {"case-a", "case-b"}
        Name of the case.
    progress : callable
        Called with one line of text at each step of the work.

    Returns
    -------
    AudiCase
        Extremes, statics, modes, signals, and the paper's values with the corrected ones.

    Raises
    ------
    JounceError
        For an unknown case.

    Examples
    --------
    >>> run = run_audi_a6("case-a").runs[0]
    >>> run.variant, run.moment, round(1e3 * run.outputs["z"][1].min, 2)    # mm: the demo has the road sign reversed
    ('simulink', 100.0, -60.93)
    """
    if name not in CASES:
        raise jn.DescriptionError(f"unknown case {name!r}", where="study", allowed=", ".join(CASES))
    case, vehicle = CASES[name], jn.load(VEHICLE)
    assert isinstance(vehicle, jn.HalfCar)
    runs = []
    for moment in moments(case, vehicle):
        for variant in VARIANTS:
            progress(f"simulate: {moment:g} N m, {variant}")
            runs.append(case_run(vehicle, case, moment, variant))
    progress("compare with the paper")
    result = printed_sign(vehicle), start_up(vehicle), paper_errata()
    return AudiCase(case, vehicle, tuple(runs), jn.modes(vehicle), *result, _findings(case, runs))


def moments(case: Case, vehicle: jn.HalfCar) -> tuple[float, float]:
    """Return the pitch moments of a case in N m: that of the demo, and that of 3 m/s^2 at a height of 0.55 m."""
    return case.sign * DEMO_MOMENT, case.sign * vehicle.body.mass * DECELERATION * CENTRE_HEIGHT


def course(case: Case, variant: str) -> jn.Road:
    """Return the road of a case: steps, or ramps in the physical variant; the front axle reaches them at 6 and 8 s."""
    start, length = SPEED * ON, SPEED * (OFF - ON)
    if variant == "physical":
        return jn.Trapezoid(
            height=case.height, length=length + RAMP, ramp=RAMP, shape="cosine", start=start
        )
    return jn.Rectangle(height=case.height, length=length, start=start)


def case_run(vehicle: jn.HalfCar, case: Case, moment: float, variant: str) -> CaseRun:
    """Run one variant with a pitch moment in N m from 3 s on."""
    car = vehicle.with_changes({"compat": variant})
    load = jn.PitchMoment(value=moment, start=DRIVING)
    trial = jn.Trial(road=course(case, variant), speed=SPEED, duration=DURATION, pitch_moment=load)
    run = jn.simulate(car, trial, tolerance=_TOLERANCE)
    statics = half_car_statics(car)
    signals = _signals(run, statics)
    time = run["time"].to_numpy()
    rates = {"z": "body.vz", "theta": "body.pitch_rate"}
    outputs = {
        name: tuple(
            extremes_within(time, signals[channel].to_numpy(), run[rates[name]].to_numpy(), *window)
            for window in WINDOWS
        )
        for name, channel in (("z", "bounce.displacement"), ("theta", "pitch.angle"))
    }
    fine = jn.simulate(car, trial, tolerance=_TOLERANCE, output_step=_FINE)["body.az"]
    peak = float(np.abs(fine.sel(time=slice(ON, OFF - _FINE)).to_numpy()).max())
    least = min(float(run[f"{axle}.strut.force"].min()) for axle in ("front", "rear"))
    return CaseRun(moment, variant, statics, outputs, peak, least, signals)


def half_car_statics(vehicle: jn.HalfCar) -> StaticEquilibrium:
    """Compute the static equilibrium of a half car on a level road."""
    rest = jn.equilibrium(vehicle)
    axles = (
        AxleStatics(
            2.0 * rest[f"{axle}.strut.force"],
            rest[f"{axle}.strut.force"],
            rest[f"{axle}.strut.deflection"],
        )
        for axle in ("front", "rear")
    )
    return StaticEquilibrium(rest["body.z"], rest["body.pitch"], *axles)


def _signals(run: xr.Dataset, statics: StaticEquilibrium) -> xr.Dataset:
    """Collect the signals of the paper's scopes: changes of bounce and pitch, axle forces, road and moment."""
    value = {str(name): run[name].to_numpy() for name in run.data_vars}
    channels = {
        "bounce.displacement": (
            value["body.z"] - statics.z,
            "m",
            "bounce: change of height from static equilibrium",
        ),
        "pitch.angle": (
            value["body.pitch"] - statics.theta,
            "rad",
            "pitch: change from static equilibrium, nose down",
        ),
        "front.force": (2.0 * value["front.strut.force"], "N", "front axle: force on the body, up"),
        "rear.force": (2.0 * value["rear.strut.force"], "N", "rear axle: force on the body, up"),
        "front.road.z": (value["front.road.z"], "m", "road under the front axle, up"),
        "rear.road.z": (value["rear.road.z"], "m", "road under the rear axle, up"),
        "pitch.moment": (value["body.pitch_moment"], "N*m", "pitch moment of driving, nose down"),
    }
    return jn.recording(run["time"].to_numpy(), channels)


def _findings(case: Case, runs: list[CaseRun]) -> tuple[jn.Finding, ...]:
    moments = {"demo": DEMO_MOMENT, "estimated": abs(runs[-1].moment)}
    moments |= {"deceleration": DECELERATION, "height": CENTRE_HEIGHT}
    ramps = {"speed": SPEED, "ramp": RAMP, "on": ON, "off": OFF}
    findings = [
        jn.Finding("pitch moment", "warning", "", None, "papers.moment_not_given", moments),
        jn.Finding("simulink", "warning", "", None, "papers.road_sign"),
        jn.Finding("physical", "note", "", None, "papers.ramps_estimated", ramps),
        jn.Finding("vehicle", "warning", "", None, "papers.axles_without_mass"),
    ]
    for run in runs:
        force = run.least_wheel_force
        if force < 0.0:
            place = f"{case.name}, {run.moment:g} N m, {run.variant}"
            findings.append(
                jn.Finding(place, "warning", "", force, "papers.wheel_would_lift", {"force": force})
            )
    return tuple(findings)
