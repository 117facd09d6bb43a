"""Ride figures of a quarter car over speed, with a measured damper, a real vehicle and a measured course.

A laboratory-scale damper is fitted, scaled by similitude and referred to the wheel. A real double wishbone is reduced
to a quarter car with documented values. The model is driven over a measured proving-ground course.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

import jounce as jn
from jounce.papers import Array, Progress, no_progress

if TYPE_CHECKING:
    import xarray as xr

COURSE = "detrended_rms_course_1in"
BEGIN, END = 100.0, 404.8
"""Undulated part of the course, m; it is driven from end to end, starting in static equilibrium."""
SPEEDS = tuple(kmh / 3.6 for kmh in (10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0))
SHOWN_SPEED = 20.0 / 3.6  # m/s, for figures over time
LAW = "tanh-hysteretic"
AMPLITUDE, DAMPING_RATIO = (
    0.0254,
    0.25,
)  # m, the r.m.s. height of the course (1 inch); 1, an estimate
OWN = "own damper"
TYRE_RADIUS = 0.4699  # m: 37 inches across
_OFTEN = (
    0.05  # fraction of time beyond the damper's record above which a warning is given; a choice
)
_GRID = 0.025  # m
FIGURES: dict[str, tuple[str, str]] = {
    "body_acceleration": ("m/s^2", "body r.m.s."),
    "bump_travel_utilisation": ("1", "bump travel utilisation"),
    "rebound_travel_utilisation": ("1", "rebound travel utilisation"),
    "wheel_load_variation": ("1", "wheel load r.m.s."),
    "lift_off": ("1", "time off the ground"),
    "damper_power": ("W", "damper power"),
    "tyre_power": ("W", "tyre power"),
    "road_power": ("W", "power from road"),
    "power_gap": ("1", "power imbalance"),
    "beyond_record": ("1", "faster than record"),
}
"""Ride figures over the undulated part: SI unit and name.

Body acceleration is unweighted; travel utilisation is the largest deflection from design over the available travel;
wheel load r.m.s. is that of the dynamic part over the static load; powers are means; times are fractions.
"""
RECORDS = {"0 V": "shaking_table_0v.csv", "0.88 V": "shaking_table_088v.csv"}
LAWS: tuple[Literal["linear", "tanh-hysteretic", "bouc-wen"], ...] = (
    "linear",
    "tanh-hysteretic",
    "bouc-wen",
)
_COLUMNS = {"time": "s", "displacement": "m", "velocity": "m/s", "force": "N"}
_GRAVITY = 9.81  # m/s^2, as in the papers
WHEEL_MASS, TYRE_MASS, TYRE_STIFFNESS, TYRE_DAMPING = 18.8, 37.6, 326332.0, 500.0
"""Values of the same vehicle, from the repository of its hardpoints; see their SOURCE.md. kg, kg, N/m, N s/m."""
_STEP = 1e-4  # rad, of the lower arm
_SOURCE = "suspension file"
_SPRUNG = "spring force × motion ratio / g: what the spring carries at design position"
_UNSPRUNG = (
    "spindle, upright; arms as I/lever² about their axes; a third of the tie rod; wheel 18.8 kg and tyre 37.6 kg of "
    "the same vehicle"
)
_TYRE = "a tyre file of the same vehicle; other files of the vehicle have 411 121 and 441 900 N/m"
_TYRE_DAMPING = "a tyre file of the same vehicle, scaled by its author from a different tyre"


@dataclass(frozen=True)
class Derived:
    """One value of the model (``value`` in the SI ``unit``) and its origin: a source, or a formula."""

    name: str
    value: float
    unit: str
    origin: str
    is_estimated: bool = False


@dataclass(frozen=True)
class VehicleCorner:
    """A corner with its spring and damper referred to vertical motion of the wheel centre.

    The rig has the vehicle's own damper; its strut deflection is 0 at the design position. Motion ratios are the
    shortening of the element over the rise of the wheel centre (1). Travels are those of the wheel from design to the
    minimum and maximum length of the spring, each positive (m); ``damper_stroke`` is the length range of the damper
    map (m).
    """

    rig: jn.QuarterCar
    spring_motion_ratio: float
    damper_motion_ratio: float
    bump_travel: float
    rebound_travel: float
    damper_stroke: float
    derived: tuple[Derived, ...]


class FrontView:
    """Front-view motion of a double wishbone, without steering and the inclination of the upper arm's axis.

    The lower arm rotates in space about its axis; upright and upper arm form a four-bar linkage in the y-z plane. Its
    fixed upper pivot is the point of the upper arm's axis at the x of the upper ball joint.
    """

    def __init__(self, corner: jn.ChronoCorner) -> None:
        points = corner.points
        self.points = points
        self.axis_point = points["lower_arm_front"]
        axis = points["lower_arm_front"] - points["lower_arm_rear"]
        self.axis = axis / np.linalg.norm(axis)
        slant = points["upper_arm_rear"] - points["upper_arm_front"]
        share = (points["upper_ball_joint"][0] - points["upper_arm_front"][0]) / slant[0]
        self.upper_pivot = (points["upper_arm_front"] + share * slant)[1:]
        self.design = self.points["lower_ball_joint"][1:], self.points["upper_ball_joint"][1:]

    def on_lower_arm(self, name: str, angle: float) -> Array:
        """Position of a point of the lower arm, shape (3,) in m, for an arm angle in rad, bump positive."""
        away = self.points[name] - self.axis_point
        cosine, sine = np.cos(angle), np.sin(angle)
        along = self.axis * (self.axis @ away)
        return np.asarray(
            self.axis_point + along + cosine * (away - along) + sine * np.cross(self.axis, away)
        )

    def wheel_height(self, angle: float) -> float:
        """Height of the wheel centre in m at an ``angle`` of the lower arm in rad."""
        lower = self.on_lower_arm("lower_ball_joint", angle)[1:]
        upper = self._upper_ball_joint(lower)
        before, now = self.design[1] - self.design[0], upper - lower
        turn = np.arctan2(now[1], now[0]) - np.arctan2(before[1], before[0])
        out = self.points["wheel_centre"][1:] - self.design[0]
        return float(lower[1] + np.sin(turn) * out[0] + np.cos(turn) * out[1])

    def length(self, element: str, angle: float) -> float:
        """Length of ``"spring"`` or ``"damper"`` in m at an ``angle`` of the lower arm in rad."""
        foot = self.on_lower_arm(f"{element}_bottom", angle)
        return float(np.linalg.norm(self.points[f"{element}_top"] - foot))

    def motion_ratio(self, element: str, angle: float = 0.0) -> float:
        """Shortening of an element over rise of the wheel centre, 1, at an ``angle`` of the lower arm in rad."""
        low, high = angle - _STEP, angle + _STEP
        shortening = self.length(element, low) - self.length(element, high)
        return shortening / (self.wheel_height(high) - self.wheel_height(low))

    def lever(self) -> float:
        """Rise of the wheel centre per angle of the lower arm at design position in m/rad."""
        return (self.wheel_height(_STEP) - self.wheel_height(-_STEP)) / (2.0 * _STEP)

    def travel_at(self, element: str, length: float) -> float:
        """Rise of the wheel centre from design in m at which an element has a ``length`` in m."""
        from scipy.optimize import brentq

        angle = float(brentq(lambda angle: self.length(element, angle) - length, -0.5, 0.6))
        return self.wheel_height(angle) - self.wheel_height(0.0)

    def _upper_ball_joint(self, lower: Array) -> Array:
        """Outer intersection of two circles, about the upper pivot and the lower ball joint."""
        upright = float(np.linalg.norm(self.design[1] - self.design[0]))
        arm = float(np.linalg.norm(self.design[1] - self.upper_pivot))
        between = lower - self.upper_pivot
        distance = float(np.linalg.norm(between))
        along = (arm**2 - upright**2 + distance**2) / (2.0 * distance)
        aside = float(np.sqrt(arm**2 - along**2))
        unit = between / distance
        return np.asarray(self.upper_pivot + along * unit + aside * np.array([-unit[1], unit[0]]))


def hmmwv_corner() -> jn.ChronoCorner:
    """Read the shipped front corner of a HMMWV."""
    folder = Path(str(resources.files("jounce"))) / "parts" / "library" / "hmmwv"
    return jn.read_chrono_corner(folder / "HMMWV_DoubleWishboneFront_mapShock.json")


def lumped_corner(corner: jn.ChronoCorner) -> VehicleCorner:
    """Reduce a double wishbone to the vertical motion of its wheel centre.

    Examples
    --------
    >>> lumped = lumped_corner(hmmwv_corner())
    >>> round(lumped.spring_motion_ratio, 3), round(lumped.rig.sprung.mass)   # 1, kg
    (0.45, 711)
    """
    view = FrontView(corner)
    ratios = view.motion_ratio("spring"), view.motion_ratio("damper")
    design = view.length("spring", 0.0)
    spring_force = corner.spring_rate * (corner.spring_free_length - design)
    turned = 10.0 * _STEP
    rise = view.wheel_height(turned) - view.wheel_height(-turned)
    bend = (view.motion_ratio("spring", turned) - view.motion_ratio("spring", -turned)) / rise
    rate = corner.spring_rate * ratios[0] ** 2 + spring_force * bend
    bump, rebound = corner.damper.coefficients_at(view.length("damper", 0.0))
    travels = (
        view.travel_at("spring", corner.spring_shortest),
        -view.travel_at("spring", corner.spring_longest),
    )
    masses = spring_force * ratios[0] / _GRAVITY, _unsprung_mass(corner, view)
    damping = bump * ratios[1] ** 2, rebound * ratios[1] ** 2
    stroke = float(np.ptp(corner.damper.length))
    likewise, in_map = "likewise, damper", "middle of the damper map × ratio²"
    origins = (
        Derived("spring length at design position", design, "m", _SOURCE),
        Derived(
            "spring force at design position",
            spring_force,
            "N",
            f"rate × (free length − length), {_SOURCE}",
        ),
        Derived(
            "motion ratio of the spring",
            ratios[0],
            "1",
            "front view of arms and spring: −dℓ/dz at the wheel centre",
        ),
        Derived("motion ratio of the damper", ratios[1], "1", likewise),
        Derived("wheel rate", rate, "N/m", "rate × ratio² + spring force × d(ratio)/dz"),
        Derived("sprung mass of the corner", masses[0], "kg", _SPRUNG, True),
        Derived("unsprung mass", masses[1], "kg", _UNSPRUNG, True),
        Derived("tyre stiffness", TYRE_STIFFNESS, "N/m", _TYRE, True),
        Derived("tyre damping coefficient", TYRE_DAMPING, "N*s/m", _TYRE_DAMPING, True),
        Derived(
            "bump travel",
            travels[0],
            "m",
            "wheel travel from design to the spring's shortest length",
        ),
        Derived(
            "rebound travel",
            travels[1],
            "m",
            "wheel travel from design to the spring's longest length",
        ),
        Derived("own damper at the wheel, bump", damping[0], "N*s/m", in_map),
        Derived("own damper at the wheel, rebound", damping[1], "N*s/m", in_map),
        Derived("stroke of the damper", stroke, "m", "range of lengths of the damper map"),
    )
    return VehicleCorner(_rig(corner, masses, rate, damping), *ratios, *travels, stroke, origins)


def _rig(
    corner: jn.ChronoCorner, masses: tuple[float, float], rate: float, damping: tuple[float, float]
) -> jn.QuarterCar:
    return jn.QuarterCar.from_table(
        {
            "source": f"{corner.name}, github.com/projectchrono/chrono, BSD-3-Clause; referred to the wheel centre",
            "estimated": [
                "sprung.mass",
                "unsprung.mass",
                "tyre.stiffness",
                "tyre.damping_coefficient",
            ],
            "gravity": _GRAVITY,
            "sprung": {"mass": masses[0]},
            "unsprung": {"mass": masses[1]},
            "strut": {
                "spring": {"rate": rate, "preload": masses[0] * _GRAVITY},
                "damper": {"bump_coefficient": damping[0], "rebound_coefficient": damping[1]},
            },
            "tyre": {"stiffness": TYRE_STIFFNESS, "damping_coefficient": TYRE_DAMPING},
        }
    )


def _unsprung_mass(corner: jn.ChronoCorner, view: FrontView) -> float:
    """Equivalent mass at the wheel centre with the kinetic energy of the parts, kg."""
    parts, points = corner.parts, corner.points
    lower = _about_axis(corner, "lower_arm", view.axis, view.axis_point)
    upper_axis = points["upper_arm_front"] - points["upper_arm_rear"]
    upper_axis = upper_axis / np.linalg.norm(upper_axis)
    upper = _about_axis(corner, "upper_arm", upper_axis, points["upper_arm_front"])
    reach = float(points["upper_ball_joint"][1] - view.upper_pivot[0])
    whole = parts["spindle"].mass + parts["upright"].mass + WHEEL_MASS + TYRE_MASS
    return whole + lower / view.lever() ** 2 + upper / reach**2 + corner.tie_rod_mass / 3.0


def _about_axis(corner: jn.ChronoCorner, name: str, axis: Array, point: Array) -> float:
    """Moment of inertia of a part about an axis (unit vector through a point) in kg m^2."""
    part = corner.parts[name]
    away = part.centre - point
    return float(axis**2 @ part.moments + part.mass * np.linalg.norm(np.cross(axis, away)) ** 2)


@dataclass(frozen=True)
class StudyDamper:
    """One record of the damper (at the voltage in its name) with the laws fitted to it."""

    name: str
    laws: dict[str, jn.DamperResult]
    curves: dict[str, jn.DamperCurve]

    @property
    def stroke(self) -> float:
        """Largest minus smallest displacement of the record [m]."""
        return float(np.ptp(self.curves[LAWS[0]].displacement))

    @property
    def peak_velocity(self) -> float:
        """Largest speed of the record [m/s]."""
        return float(np.abs(self.curves[LAWS[0]].velocity).max())


@dataclass(frozen=True)
class ForceScaling:
    """Scaling of a small damper to a large one on a vehicle.

    With r = motion_ratio / stroke_scale, the force at the wheel is
    ``motion_ratio * force_scale * law(r * wheel displacement, r * wheel velocity)``: time is not scaled. The scales are
    ratios of the large damper to the small one (1).
    """

    stroke_scale: float
    force_scale: float
    motion_ratio: float

    @property
    def speed_ratio(self) -> float:
        """Ratio of the velocities of the small damper and the wheel [1]."""
        return self.motion_ratio / self.stroke_scale


def measured_dampers() -> tuple[tuple[StudyDamper, ...], tuple[jn.Finding, ...]]:
    """Read the shipped records and fit the laws; velocities are central differences of the displacement."""
    folder = Path(str(resources.files("jounce"))) / "library" / "measurements" / "mr_damper"
    result, findings = [], list[jn.Finding]()
    for name, file in RECORDS.items():
        columns, reading = jn.read_columns(folder / file, _COLUMNS)
        findings += reading
        record = columns["displacement"], columns["velocity"], columns["force"], columns["time"]
        place = f"damper at {name}"
        laws: dict[str, jn.DamperResult] = {
            law: jn.fit_damper(*record, law=law, velocity_from="displacement", name=place)
            for law in LAWS
        }
        findings += [
            finding for finding in laws["tanh-hysteretic"].findings if finding not in findings
        ]
        curves: dict[str, jn.DamperCurve] = {
            law: jn.damper_curve(fit, *record, velocity_from="displacement")
            for law, fit in laws.items()
        }
        result.append(StudyDamper(name, laws, curves))
    return tuple(result), tuple(findings)


def referred_to_wheel(table: Mapping[str, Any], similitude: ForceScaling) -> dict[str, Any]:
    """Return the damper table of a rig with its strut at the wheel, from the table of the measured damper.

    Coefficients of velocity or displacement are scaled by motion_ratio * force_scale * r, forces by
    motion_ratio * force_scale, and arguments inside the law (``slope`` of tanh in s/m, ``rate`` of Bouc-Wen in 1/m) by
    r = motion_ratio / stroke_scale; ``displacement_coupling`` (1/s), ``sigma`` and ``exponent`` are not scaled. The
    static ``offset`` is omitted: the spring's preload carries the vehicle.

    Examples
    --------
    >>> referred_to_wheel({"coefficient": 1000.0}, ForceScaling(stroke_scale=2.0, force_scale=10.0, motion_ratio=0.5))
    {'coefficient': 1250.0}
    """
    force, speed = similitude.motion_ratio * similitude.force_scale, similitude.speed_ratio
    factors = {
        "coefficient": force * speed,
        "stiffness": force * speed,
        "force": force,
        "hysteretic_force": force,
        "slope": speed,
        "rate": speed,
        "displacement_coupling": 1.0,
        "sigma": 1.0,
        "exponent": 1.0,
        "offset": 0.0,
    }
    strange = [key for key in table if key != "kind" and key not in factors]
    if strange:
        raise jn.FitError(
            "this law cannot be scaled", found=", ".join(strange), allowed="linear, tanh, bouc-wen"
        )
    return {key: value if key == "kind" else value * factors[key] for key, value in table.items()}


def equivalent_coefficient(table: Mapping[str, Any], amplitude: float, frequency: float) -> float:
    """Return the linear damping coefficient (N s/m) of equal energy per cycle (``amplitude`` m, ``frequency`` Hz)."""
    return jn.harmonic_energy(table, amplitude, frequency) / (
        2.0 * np.pi**2 * frequency * amplitude**2
    )


@dataclass(frozen=True)
class ProvingGround:
    """Results of the study: records and laws, vehicle, scaling of the damper, ride figures and signals.

    ``equivalent`` has the equivalent linear damping ratio (1) of each damper at the stated amplitude, ``damping`` the
    same over the amplitude of wheel travel. ``derived`` has all values of the model with their origin, ``figures`` the
    ride figures over ``damper`` and ``speed``, ``runs`` the signals at the shown speed, and ``point_contact`` the
    r.m.s. body acceleration (m/s^2) of the first damper at that speed without the tyre's envelope.
    """

    dampers: tuple[StudyDamper, ...]
    corner: VehicleCorner
    similitude: ForceScaling
    equivalent: dict[str, float]
    derived: tuple[Derived, ...]
    rigs: dict[str, jn.QuarterCar]
    courses: dict[str, jn.Road]
    figures: xr.Dataset
    damping: xr.Dataset
    runs: dict[str, xr.Dataset]
    point_contact: float
    findings: tuple[jn.Finding, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return the results as plain data in SI, without signals."""
        keys = ("parameters", "nrmse", "r2", "energy_per_cycle", "fitted_energy_per_cycle")
        fits = {
            specimen.name: {
                law: {key: getattr(fit, key) for key in keys} for law, fit in specimen.laws.items()
            }
            for specimen in self.dampers
        }
        figures = {
            name: {
                str(damper): self.figures[name].sel(damper=damper).to_numpy()
                for damper in self.figures["damper"].to_numpy()
            }
            for name in FIGURES
        }
        return jn.plain_table(
            {
                "vehicle": self.corner.rig.source,
                "course": COURSE,
                "damper_fits": fits,
                "law": LAW,
                "similitude": self.similitude,
                "equivalent_damping_ratio": self.equivalent,
                "model": self.derived,
                "dampers_at_the_wheel": {
                    name: rig.strut.damper.model_dump() for name, rig in self.rigs.items()
                },
                "speed": self.figures["speed"].to_numpy(),
                "figures": figures,
                "body_acceleration_point_contact": self.point_contact,
                "findings": self.findings,
            }
        )


def run_proving_ground(
    speeds: tuple[float, ...] = SPEEDS, *, progress: Progress = no_progress
) -> ProvingGround:
    """Simulate a real vehicle with a measured damper on a measured course, at ``speeds`` in m/s.

    The measured magneto-rheological damper (0 V and 0.88 V) is fitted, scaled to the vehicle, referred to the wheel and
    compared with the vehicle's own damper. The model is the lumped quarter car; body accelerations are unweighted.
    """
    progress("fit: damper laws")
    dampers, findings = measured_dampers()
    corner = lumped_corner(hmmwv_corner())
    similitude, equivalent = _choose_scales(dampers, corner)
    tables = {
        damper.name: referred_to_wheel(damper.laws[LAW].damper, similitude) for damper in dampers
    }
    rigs = {name: _with_damper(corner.rig, table) for name, table in tables.items()} | {
        OWN: corner.rig
    }
    length = contact_length(corner.rig)
    measured = jn.load_road(COURSE)
    course = envelope(measured, length)
    runs: dict[str, xr.Dataset] = {}
    rows: dict[str, list[dict[str, float]]] = {name: [] for name in rigs}
    fastest = {damper.name: damper.peak_velocity / similitude.speed_ratio for damper in dampers}
    for k, (name, rig) in enumerate(rigs.items()):
        for i, speed in enumerate(speeds, 1):
            which = f"{k * len(speeds) + i} of {len(rigs) * len(speeds)}"
            progress(f"drive {which}: {name}, {3.6 * speed:.0f} km/h")
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
        (*corner.derived, *_derived_values(similitude, equivalent, length)),
        rigs,
        {"as measured": measured, f"averaged over {1e3 * length:.0f} mm of contact": course},
        _dataset(rows, speeds),
        _damping_over_amplitude(rigs),
        runs,
        float(np.std(rough["sprung.az"].to_numpy())),
        (*findings, *_advice(rows, speeds)),
    )


def drive(rig: jn.QuarterCar, course: jn.Road, speed: float) -> xr.Dataset:
    """Simulate a rig over the undulated part at a speed in m/s."""
    trial = jn.Trial(road=from_begin(course), speed=speed, duration=(END - BEGIN) / speed)
    return jn.simulate(rig, trial)


def from_begin(course: jn.Road) -> jn.Road:
    """Shift the course to begin at its undulated part."""
    return course.model_copy(update={"start": -BEGIN})


def contact_length(rig: jn.QuarterCar) -> float:
    """Return the tyre's contact length in m under static load (square-root and linear term of the Magic Formula)."""
    weight = (rig.sprung.mass + rig.unsprung.mass) * rig.gravity
    share = weight / (float(rig.tyre.stiffness or np.nan) * TYRE_RADIUS)
    return float(2.0 * TYRE_RADIUS * (0.671 * np.sqrt(share) + 0.733 * share))


def envelope(course: jn.Road, length: float) -> jn.Table:
    """Average a course over a contact ``length`` in m: the enveloping of short obstacles by a tyre."""
    end = course.end()
    edges = course.segments(end).edges
    height = course.height_at(np.minimum(edges, end - 1e-9))
    area = np.concatenate([[0.0], np.cumsum(0.5 * (height[1:] + height[:-1]) * np.diff(edges))])
    x = np.arange(BEGIN - 1.0, END + 1.0, _GRID)
    high, low = (_integral(x + side * 0.5 * length, edges, height, area) for side in (1.0, -1.0))
    return jn.Table(x=x, height=(high - low) / length)


def _integral(x: Array, edges: Array, height: Array, area: Array) -> Array:
    """Integral (m^2) of a piecewise linear height up to ``x`` in m."""
    piece = np.clip(np.searchsorted(edges, x, side="right") - 1, 0, len(edges) - 2)
    way = x - edges[piece]
    slope = np.diff(height) / np.diff(edges)
    return np.asarray(area[piece] + way * (height[piece] + 0.5 * way * slope[piece]))


def _choose_scales(
    dampers: tuple[StudyDamper, ...], corner: VehicleCorner
) -> tuple[ForceScaling, dict[str, float]]:
    """Choose the scales; return them with the damping ratios, including that of the vehicle's own damper."""
    rig = corner.rig
    stroke = corner.damper_stroke / max(damper.stroke for damper in dampers)
    unit = ForceScaling(stroke, 1.0, corner.damper_motion_ratio)
    frequency = body_frequency(rig.with_changes({"strut.damper": {"coefficient": 0.0}}))
    critical = _critical(rig)
    shares = {
        damper.name: equivalent_coefficient(
            referred_to_wheel(damper.laws[LAW].damper, unit), AMPLITUDE, frequency
        )
        / critical
        for damper in dampers
    }
    scale = DAMPING_RATIO / shares[dampers[0].name]
    damper: Any = rig.strut.damper  # with two coefficients, as in the paper
    own = 0.5 * (damper.bump_coefficient + damper.rebound_coefficient) / critical
    return replace(unit, force_scale=scale), {
        name: scale * share for name, share in shares.items()
    } | {OWN: own}


def body_frequency(rig: jn.QuarterCar) -> float:
    """Return the body bounce frequency in Hz."""
    return float(jn.modes(rig)[0].frequency_hz)


def _damping_over_amplitude(rigs: dict[str, jn.QuarterCar]) -> xr.Dataset:
    import xarray as xr

    amplitudes = np.linspace(0.002, 0.1, 50)
    rows = []
    for rig in rigs.values():
        frequency = body_frequency(rig.with_changes({"strut.damper": {"coefficient": 0.0}}))
        table = rig.strut.damper.model_dump()
        if "bump_coefficient" in table:
            table = {
                "coefficient": 0.5 * (table["bump_coefficient"] + table["rebound_coefficient"])
            }
        rows.append(
            [
                equivalent_coefficient(table, float(x), frequency) / _critical(rig)
                for x in amplitudes
            ]
        )
    return xr.Dataset(
        {
            "damping_ratio": (
                ("damper", "amplitude"),
                rows,
                {"units": "1", "long_name": "equivalent damping ratio"},
            )
        },
        coords={
            "damper": list(rigs),
            "amplitude": (
                "amplitude",
                amplitudes,
                {"units": "m", "long_name": "amplitude of wheel travel"},
            ),
        },
    )


def _critical(rig: jn.QuarterCar) -> float:
    """Critical damping coefficient of the sprung mass on its spring in N s/m."""
    return 2.0 * float(np.sqrt((rig.strut.spring.rate or 0.0) * rig.sprung.mass))


def _with_damper(rig: jn.QuarterCar, table: dict[str, Any]) -> jn.QuarterCar:
    plain = rig.model_dump(by_alias=True, exclude_none=True)
    plain["strut"]["damper"] = table
    plain["estimated"] = (*rig.estimated, "strut.damper")
    return jn.QuarterCar.from_table(plain)


def _derived_values(
    similitude: ForceScaling, equivalent: dict[str, float], length: float
) -> tuple[Derived, ...]:
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


def ride_figures(
    run: xr.Dataset, rig: jn.QuarterCar, corner: VehicleCorner, fastest: float = np.inf
) -> dict[str, float]:
    """Compute the ride figures (see `FIGURES`, SI) of one run over the undulated part.

    ``fastest`` is the maximum wheel speed relative to the body (m/s) covered by the damper's record.
    """
    time = run["time"].to_numpy()
    signal = {str(name): run[name].to_numpy() for name in run.data_vars}
    span = float(time[-1] - time[0])

    def mean(values: Array) -> float:
        return float(np.trapezoid(values, time)) / span

    deflection, velocity, contact = (
        signal["strut.deflection"],
        signal["strut.velocity"],
        signal["tyre.force"],
    )
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
    """Integrate a sampled force (N) over a displacement (m), shape (n,), to J: exact for piecewise linear signals."""
    return float(0.5 * (force[1:] + force[:-1]) @ np.diff(way))


def _energy(rig: jn.QuarterCar, signal: dict[str, Array]) -> Array:
    """Kinetic, elastic and potential energy in J; a tyre without contact stores none."""
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
    coordinates = {
        "damper": list(rows),
        "speed": ("speed", list(speeds), {"units": "m/s", "long_name": "speed"}),
    }
    return xr.Dataset(variables, coords=coordinates)


def _advice(rows: dict[str, list[dict[str, float]]], speeds: tuple[float, ...]) -> list[jn.Finding]:
    findings = []
    for name, lines in rows.items():
        for key, kind in (
            ("bump_travel_utilisation", "bump"),
            ("rebound_travel_utilisation", "rebound"),
        ):
            over = [speed for row, speed in zip(lines, speeds, strict=True) if row[key] > 1.0]
            if over:
                worst = max(row[key] for row in lines)
                numbers = {"kind": kind, "speed": over[0], "worst": worst}
                findings.append(
                    jn.Finding(name, "warning", "", worst, "papers.travel_used_up", numbers)
                )
        beyond = max(row["beyond_record"] for row in lines)
        if beyond > 0.0:
            severity: Literal["warning", "note"] = "warning" if beyond > _OFTEN else "note"
            findings.append(
                jn.Finding(name, severity, "", beyond, "papers.beyond_record", {"share": beyond})
            )
    return findings
