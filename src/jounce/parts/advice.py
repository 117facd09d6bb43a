"""Plausibility checks of rigs and vehicles: findings on valid but unlikely values, each with its value."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.findings import Finding, at_place, finding
from jounce.core.remembered import once_per_object
from jounce.core.text import place_in
from jounce.parts.axles import DependentAxle
from jounce.parts.bushings import Mount
from jounce.parts.compliance import bushings_of, compliance_findings
from jounce.parts.corners import Corner
from jounce.parts.dampers import ClickDamper, MapDamper, VelocityTable
from jounce.parts.leverage import (
    carried_beside_spring,
    motion_ratio,
    spring_force,
    static_deflection,
    static_spring_force,
    static_tyre_deflection,
)
from jounce.parts.points import LARGE
from jounce.parts.rig import Rig, questions
from jounce.parts.vehicles import (
    Axle,
    FullAxle,
    FullCar,
    FullCar3D,
    HalfCar,
    HalfCar4DOF,
    QuarterCar,
    WheeledAxle,
)

AnyVehicle = HalfCar | HalfCar4DOF | FullCar | FullCar3D

STEEP_STRUT = np.radians(30.0)
"""Angle of the strut to the vertical in front view, rad, above which the literature rejects a strut."""
BODY_POINTS = {
    "lower_arm": ("lower_arm_front", "lower_arm_rear", "lower_ball_joint"),
    "upper_arm": ("upper_arm_front", "upper_arm_rear", "upper_ball_joint"),
    "tie_rod": ("tie_rod_inner", "tie_rod_outer"),
    "rocker": ("rocker_pivot", "rocker_axis", "pushrod_inner"),
    "strut": ("strut_bottom", "strut_top"),
    "arm": ("arm_inner", "arm_outer", "wheel_centre"),
    "wheel": ("wheel_centre",),
    **{f"link_{i}": (f"link_{i}_inner", f"link_{i}_outer") for i in range(1, 6)},
}
"""Hardpoints of each body; an upright has the outer points of the suspension."""
LONGEST = 6.0
"""m; upper bound of a car's axle distances from the centre of gravity, its width and its height."""
INDICES = (0.4, 2.0)
"""Range of the dynamic index of road vehicles: pitch inertia / (mass * front distance * rear distance), 1."""
FREQUENCIES = (0.6, 6.0)
"""Range of the body's natural frequency on one axle, Hz: from the softest coach to a race car."""
_SMALL = 5e-3
"""m; a car's coordinates in metres, read as millimetres, are below 6 mm; no model car is as small as 5 mm."""
MOST_PRESSED = 0.15
"""m; maximum static deflection of a tyre in a lumped model, where its radius is unknown."""
_PRESSED = 0.3
"""Maximum static tyre deflection over radius: sidewalls of car tyres are 0.25 to 0.4 of the radius high."""
_LEVER = 0.02
"""Minimum lever of a T-bar's link over the length of the arm; below it, the link does not hold the bar."""
RATIOS = (0.05, 1.5)
"""Plausible damping ratios (1) of the body on one axle."""


def rig_findings(rig: Rig, where: str = "") -> list[Finding]:
    """List implausible values of a rig.

    Parameters
    ----------
    rig : Rig
        Any rig or vehicle. Quarter cars get only a few checks.
    where : str
        Source file of the rig, prefixed to the path of each finding.

    Returns
    -------
    list of Finding
        Empty when nothing looks wrong. Values are in SI.

    Examples
    --------
    >>> from jounce.parts import load
    >>> rig = load("reference-double-wishbone")
    >>> rig_findings(rig)
    []
    >>> found = rig_findings(rig.with_changes({"hardpoints.strut_top": ["10 mm", "400 mm", "520 mm"]}))
    >>> found[0].place, round(found[0].value, 3)   # rad
    ('hardpoints.strut_top', 0.575)
    """
    return [at_place(place_in(where, item.place), item) for item in _check_all(rig)]


@once_per_object
def _check_all(rig: Rig) -> tuple[Finding, ...]:
    """Collect all findings; cached because every run needs them."""
    if isinstance(rig, Corner):  # if a size is wrong, all other checks would fail too
        checks: tuple[Callable[[Corner], Iterator[Finding]], ...]
        checks = (
            _check_estimated,
            _check_order,
            _check_wheel,
            _check_bars,
            compliance_findings,
            _check_strut,
            _check_bodies,
            _check_sprung_mass,
            _check_statics,
        )
        checks = checks[:5] if rig.lacks else checks  # the others need the omitted parts
        findings = list(_check_size(rig)) or [finding for check in checks for finding in check(rig)]
    else:
        lumped = (
            _check_vehicle(rig)
            if isinstance(rig, AnyVehicle)
            else _check_at_rest(rig)
            if isinstance(rig, QuarterCar)
            else _check_dependent(rig)
            if isinstance(rig, DependentAxle)
            else ()
        )
        findings = [*_check_estimated(rig), *lumped]
    asked_of = rig.parameters().keys() - {
        item.place for item in findings
    }  # without placeholders of omitted parts
    findings += [item for item in questions(rig) if item.place in asked_of]
    return tuple(findings)


def _is_choice(rig: Rig, path: str) -> bool:
    """Whether a path points to a string of the description, such as ``strut.on``."""
    here: object = rig
    for part in path.split("."):
        here = (
            getattr(here, part, None) if part in getattr(type(here), "model_fields", ()) else None
        )
    return isinstance(here, str)


def _check_estimated(rig: Rig) -> Iterator[Finding]:
    known = rig.parameters()
    for entry in rig.estimated:
        is_number = any(
            path == entry or path.startswith((f"{entry}.", f"{entry}[")) for path in known
        )
        if not is_number and not _is_choice(rig, entry):
            yield finding("parts.estimated_unknown", "estimated", entry=entry)


def size_findings(points: Mapping[str, ArrayLike], place: str) -> Iterator[Finding]:
    """Report points (m) of implausible size: millimetres read as metres, or metres as millimetres."""
    sizes = {name: float(np.max(np.abs(point))) for name, point in points.items()}
    largest = max(sizes.values(), default=0.0)
    if largest > LARGE:
        name = max(sizes, key=sizes.__getitem__)
        yield finding("parts.size_metres", place, largest, name=name, distance=largest)
    if 0.0 < largest < _SMALL:
        yield finding("parts.size_millimetres", place, largest, largest=largest)


def _check_size(rig: Corner) -> Iterator[Finding]:
    yield from size_findings(rig.hardpoints.given(), "hardpoints")
    mounts = {path: part for path, part in bushings_of(rig).items() if isinstance(part, Mount)}
    for path, mount in mounts.items():
        yield from size_findings({"point": mount.point}, path)
    yield from _check_radius(rig)


def _check_dependent(rig: DependentAxle) -> Iterator[Finding]:
    yield from size_findings(rig.hardpoints.given(), "hardpoints")
    yield from _check_radius(rig)


def _check_radius(rig: Corner | DependentAxle) -> Iterator[Finding]:
    radius = rig.wheel.radius
    if radius > 2.0 or radius < 0.02:  # m: from a toy to a mine truck; the library has 0.13 to 0.47
        yield finding("parts.wheel_radius", "wheel.radius", radius, radius=radius)


def _check_order(rig: Corner) -> Iterator[Finding]:
    """Report points whose names appear to be swapped."""
    points = rig.hardpoints.given()
    for arm in ("lower_arm", "upper_arm"):
        if f"{arm}_front" in points and points[f"{arm}_front"][0] < points[f"{arm}_rear"][0]:
            yield finding("parts.arm_swapped", f"hardpoints.{arm}_front", arm=arm)
    if (
        "upper_ball_joint" in points
        and points["upper_ball_joint"][2] < points["lower_ball_joint"][2]
    ):
        yield finding("parts.ball_joints_swapped", "hardpoints.upper_ball_joint")
    for arm in ("lower_arm", "upper_arm"):
        ball = arm.replace("arm", "ball_joint")
        if ball in points and f"{arm}_front" in points:
            pivots = [rig.sign * points[f"{arm}_{end}"][1] for end in ("front", "rear")]
            out = rig.sign * points[ball][1] - max(pivots)
            if out < 0.0:
                yield finding("parts.ball_joint_inboard", f"hardpoints.{ball}", out, distance=-out)
    for rod in ("tie_rod", *(f"link_{i}" for i in range(1, 6))):
        inner, outer = f"{rod}_inner", f"{rod}_outer"
        if inner in points and rig.sign * points[inner][1] > rig.sign * points[outer][1]:
            yield finding("parts.rod_swapped", f"hardpoints.{inner}", outer=outer)
    for name, point in points.items():
        if rig.sign * point[1] < 0.0 and name not in ("rocker_axis", "arb_pivot", "arb_axis"):
            yield finding("parts.across_the_middle", f"hardpoints.{name}", point[1])


def _check_wheel(rig: Corner) -> Iterator[Finding]:
    height, radius = rig.hardpoints.wheel_centre[2], rig.undeformed_radius
    if abs(height - radius) > 0.2 * radius:  # corners of the library: up to 11 %
        code = "parts.wheel_low" if height < radius else "parts.wheel_high"
        off = radius - height
        yield finding(
            code, "hardpoints.wheel_centre", off, off=abs(off), height=height, radius=radius
        )
    for name in ("camber", "toe"):
        angle = getattr(rig.wheel, name)
        if (
            abs(angle) > 0.2
        ):  # rad: the kart prototype has the largest known angle, 10.5 deg (0.18 rad) of toe
            yield finding("parts.steep_angle", f"wheel.{name}", angle, angle=angle)


def _check_strut(rig: Corner) -> Iterator[Finding]:
    bottom, top = (
        np.array(rig.hardpoints.at("strut_bottom")),
        np.array(rig.hardpoints.at("strut_top")),
    )
    along, strut = top - bottom, rig.strut
    if strut.on != "rocker":
        if along[2] <= 0.0:
            yield finding("parts.strut_swapped", "hardpoints.strut_top")
        elif (angle := float(np.arctan2(abs(along[1]), along[2]))) > STEEP_STRUT:
            yield finding("parts.strut_leans", "hardpoints.strut_top", angle, angle=angle)
    for name in ("bump_stop", "rebound_stop"):
        stop = getattr(strut, name)
        if stop is not None and stop.gap < 0.0:
            yield finding("parts.stop_pressed_in", f"strut.{name}.gap", stop.gap, gap=-stop.gap)
    yield from _check_driving("strut.damper", strut.damper)


def _check_driving(place: str, damper: object) -> Iterator[Finding]:
    """Report the first point of a damper table at which it drives the motion instead of damping it."""
    if isinstance(damper, VelocityTable):
        rows = {"": damper.force}
    elif isinstance(damper, MapDamper | ClickDamper):
        rows = {f"[{i}]": row for i, row in enumerate(damper.force)}
    else:
        return
    for index, row in rows.items():
        for velocity, force in zip(damper.velocity, row, strict=True):
            if velocity * force < 0.0:
                yield finding(
                    "parts.table_drives",
                    f"{place}.force{index}",
                    force,
                    force=force,
                    velocity=velocity,
                )
                return


def _check_bodies(rig: Corner) -> Iterator[Finding]:
    points = rig.hardpoints.given()
    for name, body in rig.body_masses().items():
        names = BODY_POINTS.get(name, rig.hardpoints.outer)
        own = np.array([points[point] for point in names if point in points])
        extent = float(np.linalg.norm(own[:, np.newaxis] - own, axis=2).max())
        reach = max(extent, rig.wheel.radius if name in ("upright", "wheel", "arm") else 0.0)
        away = float(np.linalg.norm(np.array(body.centre_of_mass) - own, axis=1).min())
        # Twice the maxima of the library: 0.54 of the extent, and radii of gyration of 0.77 of it.
        if away > 1.5 * reach:
            yield finding(
                "parts.centre_of_mass_away",
                f"bodies.{name}.centre_of_mass",
                away,
                distance=away,
                reach=reach,
            )
        gyration = float(np.sqrt(body.inertia.principal_moments[-1] / body.mass))
        if gyration > 1.5 * reach:
            yield finding(
                "parts.radius_of_gyration",
                f"bodies.{name}.inertia",
                gyration,
                gyration=gyration,
                reach=reach,
            )


def _check_bars(rig: Corner) -> Iterator[Finding]:
    """Report a T-bar whose links do not hold its hinge and its stem."""
    if rig.anti_roll_bar is None or rig.anti_roll_bar.kind != "t":
        return
    points = {
        name: np.array(point)
        for name, point in rig.hardpoints.given().items()
        if name.startswith("arb_")
    }
    arm, stem = (points[name] - points["arb_pivot"] for name in ("arb_arm_end", "arb_axis"))
    link = points["arb_link_end"] - points["arb_arm_end"]
    for axis, name in (
        (np.array([0.0, 1.0, 0.0]), "its hinge"),
        (stem / np.linalg.norm(stem), "its stem"),
    ):
        lever = float(abs(link @ np.cross(axis, arm)) / np.linalg.norm(link))
        if lever < _LEVER * np.linalg.norm(arm):
            yield finding(
                "parts.t_bar_held_loosely", "hardpoints.arb_link_end", lever, axis=name, lever=lever
            )


def _check_sprung_mass(rig: Corner) -> Iterator[Finding]:
    if rig.sprung is None or rig.guide == "vertical+spherical":
        return
    unused = [
        name
        for name in ("centre_of_mass", "inertia", "joint")
        if getattr(rig.sprung, name) is not None
    ]
    if unused:
        yield finding("parts.sprung_unused", "sprung", unused=", ".join(unused))


def _check_statics(rig: Corner) -> Iterator[Finding]:
    """Report a spring that cannot carry the car, or carries it far from the design position."""
    try:
        ratio = motion_ratio(rig)
        needed = 0.0 if rig.guide == "fixed" else static_spring_force(rig)
    except np.linalg.LinAlgError:
        yield finding("parts.wheel_locked", "hardpoints")
        return
    if (
        ratio < 0.1
    ):  # corners of the library: 0.45 and more; below, the spring would need 100 times the wheel rate
        yield finding("parts.spring_ratio", "strut", ratio, ratio=ratio)
        return
    bar = rig.anti_roll_bar
    if rig.guide == "fixed" or (bar is not None and bar.kind == "z"):
        return
    length, beside = rig.hardpoints.length("spring"), carried_beside_spring(rig)

    def lacking(deflection: float) -> float:
        """Return the force (N) that the spring lacks to carry the car, with the levers of the design pose."""
        more = (carried_beside_spring(rig, deflection / ratio) - beside) / ratio
        return needed - spring_force(rig, deflection) - more

    low, high = -length, length
    if lacking(low) >= 0.0 >= lacking(high):
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if lacking(middle) > 0.0 else (low, middle)
    deflection = 0.5 * (low + high) if high < length or low > -length else None
    if rig.besides_strut:  # all springs together, at the wheel
        place = "strut.spring" if "spring" not in rig.without else rig.besides_strut[0]
        numbers: dict[str, Any] = {
            "needed": needed * ratio + beside,
            "present": spring_force(rig) * ratio + beside,
        }
        weak, away = "parts.springs_weak", "parts.springs_away"
    else:
        place, numbers = (
            "strut.spring",
            {"needed": needed, "present": spring_force(rig), "length": length},
        )
        weak, away = "parts.spring_weak", "parts.spring_away"
    if (
        deflection is None or deflection > 0.6 * length
    ):  # coils are then solid; springs of the library: up to 13 %
        yield finding(weak, place, numbers["needed"], **numbers)
        return
    travel = deflection / ratio
    if (
        abs(travel) > 0.25 * rig.wheel.radius
    ):  # about the full travel; corners of the library: up to 18 %
        direction = "bump" if travel > 0.0 else "rebound"
        yield finding(away, place, travel, travel=abs(travel), direction=direction, **numbers)
    yield from _check_deflection("tyre", static_tyre_deflection(rig), _PRESSED * rig.wheel.radius)


def _check_deflection(place: str, deflection: float, most: float) -> Iterator[Finding]:
    """Report a tyre whose static deflection exceeds ``most`` (m)."""
    if deflection > most:
        yield finding("parts.tyre_pressed_in", place, deflection, deflection=deflection)


def _check_vehicle(car: AnyVehicle) -> Iterator[Finding]:
    lengths = {path: value for path, value in car.parameters().items() if path.count(".") == 1}
    wrong = [
        finding("parts.length_metres", path, value, length=value)
        for path, value in lengths.items()
        if path.endswith((".distance", ".track", ".height", ".roll_centre_height"))
        and abs(value) > LONGEST
    ]
    if wrong:
        yield from wrong
        return
    body = car.body
    index = body.pitch_inertia / (body.mass * car.front.distance * car.rear.distance)
    if not INDICES[0] <= index <= INDICES[1]:
        yield finding("parts.dynamic_index", "body.pitch_inertia", index, index=index)
    for name, other in (("front", car.rear), ("rear", car.front)):
        axle = getattr(car, name)
        mass = 0.5 * body.mass * other.distance / car.wheelbase  # sprung mass per wheel, kg
        if not isinstance(
            axle, Axle | WheeledAxle
        ):  # axles of 3-D corners have no springs of their own
            suspension, at = axle.suspension, f"{name}.{axle.part}"
            if isinstance(suspension, DependentAxle):
                if suspension.only_in_kc:
                    names = ", ".join(suspension.only_in_kc)
                    yield finding("parts.kc_only", at, names=names)
                own = 0.5 * suspension.total_mass
            else:
                for item in compliance_findings(suspension):
                    yield at_place(f"{at}.{item.place}", item)
                own = sum(body.mass for body in suspension.body_masses().values())
            assert suspension.tyre is not None
            yield from _check_deflection(
                f"{at}.tyre",
                static_deflection(suspension.tyre, car.gravity * (mass + own)),
                _PRESSED * suspension.wheel.radius,
            )
            continue
        if axle.spring_rate is not None:
            yield from _check_frequency(name, axle, mass, axle.spring_rate)
        if isinstance(axle, WheeledAxle):
            yield from _check_axle(name, axle, mass, car.gravity)
        if (
            isinstance(axle, FullAxle)
            and body.height is not None
            and axle.roll_centre_height > body.height
        ):
            yield finding(
                "parts.roll_centre_high",
                f"{name}.roll_centre_height",
                axle.roll_centre_height,
                roll_centre_height=axle.roll_centre_height,
                height=body.height,
            )


def _check_frequency(
    name: str, axle: Axle | WheeledAxle, mass: float, rate: float
) -> Iterator[Finding]:
    angular = float(np.sqrt(rate / mass))
    frequency = angular / (2.0 * np.pi)
    if not FREQUENCIES[0] <= frequency <= FREQUENCIES[1]:
        yield finding(
            "parts.body_frequency",
            f"{name}.spring_rate",
            frequency,
            frequency=frequency,
            mass=mass,
            rate=rate,
        )
    elif axle.damping_coefficient:
        ratio = axle.damping_coefficient / (2.0 * mass * angular)
        if not RATIOS[0] <= ratio <= RATIOS[1]:
            yield finding("parts.body_damping", f"{name}.damping_coefficient", ratio, ratio=ratio)


def _check_at_rest(rig: QuarterCar) -> Iterator[Finding]:
    """Report a tyre that is too soft, and a stop gap that counts from static ride height, not the undeformed spring."""
    weight = rig.gravity * (rig.sprung.mass + rig.unsprung.mass)
    yield from _check_deflection("tyre", static_deflection(rig.tyre, weight), MOST_PRESSED)
    spring, stop = rig.strut.spring, rig.strut.bump_stop
    if stop is None or spring.rate is None:
        return
    rest = (rig.sprung.mass * rig.gravity / np.cos(rig.strut.angle) - spring.preload) / spring.rate
    if stop.gap < rest:
        yield finding("parts.stop_closed_at_rest", "strut.bump_stop.gap", stop.gap, rest=rest)


def _check_axle(name: str, axle: WheeledAxle, mass: float, gravity: float) -> Iterator[Finding]:
    weight = gravity * (mass + axle.unsprung_mass)
    yield from _check_deflection(f"{name}.tyre", static_deflection(axle.tyre, weight), MOST_PRESSED)
    if axle.unsprung_mass > 0.5 * mass:  # axles of the library: up to 12 %
        yield finding(
            "parts.unsprung_mass",
            f"{name}.unsprung_mass",
            axle.unsprung_mass,
            unsprung_mass=axle.unsprung_mass,
            mass=mass,
        )
    if axle.spring_rate is not None:
        rest = mass * gravity / axle.spring_rate
        if axle.bump_stop is not None and axle.bump_stop.gap < rest:
            yield finding(
                "parts.stop_closed_at_rest", f"{name}.bump_stop.gap", axle.bump_stop.gap, rest=rest
            )
        if axle.rebound_stop is not None and -axle.rebound_stop.gap > rest:
            yield finding(
                "parts.stop_closed_at_rest",
                f"{name}.rebound_stop.gap",
                axle.rebound_stop.gap,
                rest=rest,
            )
    yield from _check_driving(f"{name}.damper", axle.damper)
