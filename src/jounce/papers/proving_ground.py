"""Measured damper, real vehicle, measured course: ride figures of a quarter car against speed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.findings import Finding
from jounce.core.serialise import to_plain
from jounce.core.types import Array
from jounce.papers.proving_ground_corner import Derived, LumpedCorner, lumped_corner
from jounce.papers.proving_ground_damper import (
    MeasuredDamper,
    Similitude,
    equivalent_coefficient,
    measured_dampers,
    referred_to_wheel,
)
from jounce.parts import QuarterCar
from jounce.parts.importers import shipped_corner
from jounce.roads import Table, Trial, load_road
from jounce.roads.road import Road
from jounce.simulation import modes, simulate

if TYPE_CHECKING:
    import xarray as xr

Progress = Callable[[str], None]
COURSE = "detrended_rms_course_1in"
BEGIN, END = 100.0, 404.8
"""Where the course is undulated, m; it is driven from end to end, beginning at rest on the springs."""
SPEEDS = tuple(kmh / 3.6 for kmh in (10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0))
SHOWN_SPEED = 20.0 / 3.6
LAW = "tanh-hysteretic"
AMPLITUDE, DAMPING_RATIO = 0.0254, 0.25
OWN = "own damper"
TYRE_RADIUS = 0.4699
_GRID = 0.025
FIGURES: dict[str, tuple[str, str]] = {
    "body_acceleration": ("m/s^2", "body r.m.s."),
    "bump_travel_utilisation": ("1", "bump travel use"),
    "rebound_travel_utilisation": ("1", "rebound travel use"),
    "wheel_load_variation": ("1", "wheel load r.m.s."),
    "lift_off": ("1", "time lifted off"),
    "damper_power": ("W", "damper power"),
    "tyre_power": ("W", "tyre power"),
    "road_power": ("W", "power from road"),
    "power_gap": ("1", "power imbalance"),
    "beyond_record": ("1", "faster than record"),
}
"""Ride figures over the undulated part: SI unit and name.

Body acceleration is unweighted; travel use is the largest deflection from design over the travel that is there; wheel
load r.m.s. is that of the dynamic part over the static load; powers are means; times are shares of the time.
"""


@dataclass(frozen=True)
class ProvingGround:
    """What the study found.

    Attributes
    ----------
    dampers : tuple of MeasuredDamper
        The records and the laws fitted to them.
    corner : LumpedCorner
        The vehicle.
    similitude : Similitude
        How the measured damper was scaled.
    equivalent : dict of str to float
        Equivalent linear damping ratio of each damper at the stated amplitude [1].
    derived : tuple of Derived
        Every number of the model with its origin.
    rigs : dict of str to QuarterCar
        By name of the damper.
    courses : dict of str to Road
        As measured, and as the tyre feels it.
    figures : xarray.Dataset
        Ride figures over ``damper`` and ``speed``.
    damping : xarray.Dataset
        Equivalent linear damping ratio over ``damper`` and ``amplitude`` of wheel travel.
    runs : dict of str to xarray.Dataset
        Signals at the shown speed, by name of the damper.
    point_contact : float
        R.m.s. body acceleration of the first damper at the shown speed without the tyre's envelope [m/s^2].
    findings : tuple of Finding
        What weakens the results.
    """

    dampers: tuple[MeasuredDamper, ...]
    corner: LumpedCorner
    similitude: Similitude
    equivalent: dict[str, float]
    derived: tuple[Derived, ...]
    rigs: dict[str, QuarterCar]
    courses: dict[str, Road]
    figures: xr.Dataset
    damping: xr.Dataset
    runs: dict[str, xr.Dataset]
    point_contact: float
    findings: tuple[Finding, ...]

    def to_dict(self) -> dict[str, Any]:
        """Give the results as plain data in SI, without signals."""
        keys = ("parameters", "nrmse", "r2", "energy_per_cycle", "fitted_energy_per_cycle")
        fits = {
            one.name: {law: {key: getattr(fit, key) for key in keys} for law, fit in one.laws.items()}
            for one in self.dampers
        }
        figures = {
            name: {
                str(damper): self.figures[name].sel(damper=damper).to_numpy()
                for damper in self.figures["damper"].to_numpy()
            }
            for name in FIGURES
        }
        plain: dict[str, Any] = to_plain(
            {
                "vehicle": self.corner.rig.source,
                "course": COURSE,
                "damper_fits": fits,
                "law": LAW,
                "similitude": self.similitude,
                "equivalent_damping_ratio": self.equivalent,
                "model": self.derived,
                "dampers_at_the_wheel": {name: rig.strut.damper.model_dump() for name, rig in self.rigs.items()},
                "speed": self.figures["speed"].to_numpy(),
                "figures": figures,
                "body_acceleration_point_contact": self.point_contact,
                "findings": self.findings,
            }
        )
        return plain


def run_proving_ground(speeds: tuple[float, ...] = SPEEDS, *, progress: Progress = lambda _: None) -> ProvingGround:
    """Drive a real vehicle with a measured damper over a measured course.

    The measured magneto-rheological damper (0 V and 0.88 V) is fitted, scaled to the vehicle, referred to the wheel and
    compared with the vehicle's own damper. The quarter car is the lumped one; body accelerations are not weighted.

    Parameters
    ----------
    speeds : tuple of float
        Driving speeds [m/s].
    progress : callable
        Called with one line of text as the work goes on.

    Returns
    -------
    ProvingGround
        Fits, model with the origin of each number, ride figures and signals.
    """
    progress("fit: damper laws")
    dampers, findings = measured_dampers()
    corner = lumped_corner(shipped_corner())
    similitude, equivalent = _scaled(dampers, corner)
    tables = {one.name: referred_to_wheel(one.laws[LAW].damper, similitude) for one in dampers}
    rigs = {name: _with_damper(corner.rig, table) for name, table in tables.items()} | {OWN: corner.rig}
    length = contact_length(corner.rig)
    measured = load_road(COURSE)
    course = enveloped(measured, length)
    runs: dict[str, xr.Dataset] = {}
    rows: dict[str, list[dict[str, float]]] = {name: [] for name in rigs}
    fastest = {one.name: one.peak_velocity / similitude.speed_ratio for one in dampers}
    for name, rig in rigs.items():
        for speed in speeds:
            progress(f"drive: {name}, {3.6 * speed:.0f} km/h")
            run = drive(rig, course, speed)
            rows[name].append(ride_figures(run, rig, corner, fastest.get(name, np.inf)))
        runs[name] = drive(rig, course, SHOWN_SPEED)
    first = next(iter(rigs))
    rough = drive(rigs[first], from_begin(measured), SHOWN_SPEED)
    return ProvingGround(
        dampers,
        corner,
        similitude,
        equivalent,
        (*corner.derived, *_derived(similitude, equivalent, length)),
        rigs,
        {"as measured": measured, f"averaged over {1e3 * length:.0f} mm of contact": course},
        _dataset(rows, speeds),
        _damping_over_amplitude(rigs),
        runs,
        float(np.std(rough["sprung.az"].to_numpy())),
        (*findings, *_advice(rows, speeds)),
    )


def drive(rig: QuarterCar, course: Road, speed: float) -> xr.Dataset:
    """Simulate a rig over the undulated part at a speed in m/s."""
    trial = Trial(road=from_begin(course), speed=speed, duration=(END - BEGIN) / speed)
    return simulate(rig, trial)


def from_begin(course: Road) -> Road:
    """Let the drive begin where the undulated part begins."""
    return course.model_copy(update={"start": -BEGIN})


def contact_length(rig: QuarterCar) -> float:
    """Length of the tyre's contact in m under static load (square root and linear term of the Magic Formula tyre)."""
    weight = (rig.sprung.mass + rig.unsprung.mass) * rig.gravity
    share = weight / (float(rig.tyre.stiffness or np.nan) * TYRE_RADIUS)
    return float(2.0 * TYRE_RADIUS * (0.671 * np.sqrt(share) + 0.733 * share))


def enveloped(course: Road, length: float) -> Table:
    """Average a course over a contact ``length`` in m: what a tyre passes on of steps shorter than its contact."""
    end = course.end()
    edges = course.segments(end).edges
    height = course.height_at(np.minimum(edges, end - 1e-9))
    area = np.concatenate([[0.0], np.cumsum(0.5 * (height[1:] + height[:-1]) * np.diff(edges))])
    x = np.arange(BEGIN - 1.0, END + 1.0, _GRID)
    high, low = (_integral(x + side * 0.5 * length, edges, height, area) for side in (1.0, -1.0))
    return Table(x=x, height=(high - low) / length)


def _integral(x: Array, edges: Array, height: Array, area: Array) -> Array:
    """Integral (m^2) of straight lines through points up to ``x`` in m."""
    piece = np.clip(np.searchsorted(edges, x, side="right") - 1, 0, len(edges) - 2)
    way = x - edges[piece]
    slope = np.diff(height) / np.diff(edges)
    return np.asarray(area[piece] + way * (height[piece] + 0.5 * way * slope[piece]))


def _scaled(dampers: tuple[MeasuredDamper, ...], corner: LumpedCorner) -> tuple[Similitude, dict[str, float]]:
    """Choose the scales; and tell the damping ratios that result, the vehicle's own damper beside them."""
    rig = corner.rig
    stroke = corner.damper_stroke / max(one.stroke for one in dampers)
    unit = Similitude(stroke, 1.0, corner.damper_motion_ratio)
    frequency = body_frequency(rig.with_changes({"strut.damper": {"coefficient": 0.0}}))
    critical = _critical(rig)
    shares = {
        one.name: equivalent_coefficient(referred_to_wheel(one.laws[LAW].damper, unit), AMPLITUDE, frequency) / critical
        for one in dampers
    }
    scale = DAMPING_RATIO / shares[dampers[0].name]
    own = 0.5 * (rig.strut.damper.bump_coefficient + rig.strut.damper.rebound_coefficient) / critical  # type: ignore[union-attr]
    return replace(unit, force_scale=scale), {name: scale * share for name, share in shares.items()} | {OWN: own}


def body_frequency(rig: QuarterCar) -> float:
    """Frequency of body bounce in Hz."""
    return float(modes(rig)[0].frequency_hz)


def _damping_over_amplitude(rigs: dict[str, QuarterCar]) -> xr.Dataset:
    import xarray as xr

    amplitudes = np.linspace(0.002, 0.1, 50)
    rows = []
    for rig in rigs.values():
        frequency = body_frequency(rig.with_changes({"strut.damper": {"coefficient": 0.0}}))
        table = rig.strut.damper.model_dump()
        if "bump_coefficient" in table:
            table = {"coefficient": 0.5 * (table["bump_coefficient"] + table["rebound_coefficient"])}
        rows.append([equivalent_coefficient(table, float(x), frequency) / _critical(rig) for x in amplitudes])
    return xr.Dataset(
        {"damping_ratio": (("damper", "amplitude"), rows, {"units": "1", "long_name": "equivalent damping ratio"})},
        coords={
            "damper": list(rigs),
            "amplitude": ("amplitude", amplitudes, {"units": "m", "long_name": "amplitude of wheel travel"}),
        },
    )


def _critical(rig: QuarterCar) -> float:
    """Critical damping coefficient of the sprung mass on its spring in N s/m."""
    return 2.0 * float(np.sqrt((rig.strut.spring.rate or 0.0) * rig.sprung.mass))


def _with_damper(rig: QuarterCar, table: dict[str, Any]) -> QuarterCar:
    plain = rig.model_dump(by_alias=True, exclude_none=True)
    plain["strut"]["damper"] = table
    plain["estimated"] = (*rig.estimated, "strut.damper")
    return QuarterCar.from_table(plain)


def _derived(similitude: Similitude, equivalent: dict[str, float], length: float) -> tuple[Derived, ...]:
    amplitude = f"at {1e3 * AMPLITUDE:g} mm of wheel travel and the frequency of body bounce"
    per_cycle = f"energy per cycle / (π ω x²) / 2√(k m), {amplitude}"
    stroke = "stroke of the vehicle's damper map over the largest measured one; velocities scale with it, time does not"
    force = f"so that the 0 V law has an equivalent damping ratio of {DAMPING_RATIO:g} {amplitude}; the same for 0.88 V"
    contact = f"2 R (0.671 √(F/(k R)) + 0.733 F/(k R)), R = {TYRE_RADIUS:g} m: Magic Formula tyre"
    ratios = (
        Derived(
            f"equivalent damping ratio, {name}",
            ratio,
            "1",
            "mean of bump and rebound / 2√(k m)" if name == OWN else per_cycle,
        )
        for name, ratio in equivalent.items()
    )
    return (
        Derived("stroke scale of the measured damper", similitude.stroke_scale, "1", stroke),
        Derived("force scale of the measured damper", similitude.force_scale, "1", force, True),
        *ratios,
        Derived("contact length of the tyre", length, "m", contact, True),
    )


def ride_figures(run: xr.Dataset, rig: QuarterCar, corner: LumpedCorner, fastest: float = np.inf) -> dict[str, float]:
    """Ride figures of one drive over the undulated part.

    Parameters
    ----------
    run : xarray.Dataset
        As :func:`drive` gives it.
    rig : QuarterCar
        What was driven.
    corner : LumpedCorner
        Tells the travel that is there.
    fastest : float
        Wheel speed against the body that the damper's record covers [m/s].

    Returns
    -------
    dict of str to float
        See :data:`FIGURES`, SI.
    """
    time = run["time"].to_numpy()
    signal = {str(name): run[name].to_numpy() for name in run.data_vars}
    span = float(time[-1] - time[0])

    def mean(values: Array) -> float:
        return float(np.trapezoid(values, time)) / span

    deflection, velocity, contact = signal["strut.deflection"], signal["strut.velocity"], signal["tyre.force"]
    static = (rig.sprung.mass + rig.unsprung.mass) * rig.gravity
    spring = rig.strut.spring.preload + (rig.strut.spring.rate or 0.0) * deflection
    damper = mean((signal["strut.force"] - spring) * velocity)
    elastic = (rig.tyre.stiffness or 0.0) * signal["tyre.deflection"]
    tyre = work(contact - elastic * (contact > 0.0), signal["tyre.deflection"]) / span
    road = work(contact, signal["road.z"]) / span
    stored = float(np.diff(_energy(rig, signal)[[0, -1]])[0]) / span
    return {
        "body_acceleration": float(np.sqrt(mean(signal["sprung.az"] ** 2))),
        "bump_travel_utilisation": float(deflection.max()) / corner.bump_travel,
        "rebound_travel_utilisation": -float(deflection.min()) / corner.rebound_travel,
        "wheel_load_variation": float(np.sqrt(mean((contact - static) ** 2))) / static,
        "lift_off": mean((contact == 0.0).astype(float)),
        "damper_power": damper,
        "tyre_power": tyre,
        "road_power": road,
        "power_gap": (road - damper - tyre - stored) / road,
        "beyond_record": mean((np.abs(velocity) > fastest).astype(float)),
    }


def work(force: Array, way: Array) -> float:
    """Integral (J) of a force (N) over a way (m), both sampled, shape (n,): exact where slopes jump between samples."""
    return float(0.5 * (force[1:] + force[:-1]) @ np.diff(way))


def _energy(rig: QuarterCar, signal: dict[str, Array]) -> Array:
    """Energy in masses, springs and height in J; a tyre without contact stores none."""
    rate, preload = rig.strut.spring.rate or 0.0, rig.strut.spring.preload
    deflection = signal["strut.deflection"]
    energy = 0.5 * rate * deflection**2 + preload * deflection
    energy += 0.5 * (rig.tyre.stiffness or 0.0) * np.maximum(signal["tyre.deflection"], 0.0) ** 2
    for body, mass in (("sprung", rig.sprung.mass), ("unsprung", rig.unsprung.mass)):
        energy += mass * (0.5 * signal[f"{body}.vz"] ** 2 + rig.gravity * signal[f"{body}.z"])
    return np.asarray(energy)


def _dataset(rows: dict[str, list[dict[str, float]]], speeds: tuple[float, ...]) -> xr.Dataset:
    import xarray as xr

    variables = {
        key: (
            ("damper", "speed"),
            [[row[key] for row in lines] for lines in rows.values()],
            {"units": unit, "long_name": words},
        )
        for key, (unit, words) in FIGURES.items()
    }
    coordinates = {"damper": list(rows), "speed": ("speed", list(speeds), {"units": "m/s", "long_name": "speed"})}
    return xr.Dataset(variables, coords=coordinates)


def _advice(rows: dict[str, list[dict[str, float]]], speeds: tuple[float, ...]) -> list[Finding]:
    findings = []
    for name, lines in rows.items():
        for key, kind in (("bump_travel_utilisation", "bump"), ("rebound_travel_utilisation", "rebound")):
            over = [3.6 * speed for row, speed in zip(lines, speeds, strict=True) if row[key] > 1.0]
            if over:
                worst = max(row[key] for row in lines)
                text = (
                    f"the {kind} travel is used up from {over[0]:.0f} km/h on (up to {100 * worst:.0f} %): the real "
                    "vehicle would strike its stop, which this model does not have."
                )
                findings.append(Finding(name, "warning", text, worst))
        beyond = max(row["beyond_record"] for row in lines)
        if beyond > 0.0:
            share = f"{100 * beyond:.1f} % of the time"
            text = f"the damper runs faster than in its record for up to {share}: there the law is extrapolated."
            findings.append(Finding(name, "warning" if beyond > 0.05 else "note", text, beyond))
    return findings
