"""Load cases of an axle: forces in all links, joints and pickup points from the car's accelerations."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np

from jounce.core.constants import GRAVITY
from jounce.core.description import Description
from jounce.core.errors import DescriptionError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.old_names import old_argument
from jounce.core.text import guard_formula
from jounce.core.types import Array
from jounce.core.units import Mass, Unit
from jounce.kinematics.axle import TwoWheelAxle
from jounce.kinematics.loads import (
    ContactLoad,
    Joints,
    balance_poses,
    pickup_loads,
    single_forces,
    vector_forces,
)
from jounce.kinematics.model import check_corner
from jounce.kinematics.sweeps import CarLength, prepare_sweep
from jounce.mechanics.contact import towards_road
from jounce.parts import Corner, Rig

if TYPE_CHECKING:
    import xarray as xr

_Share = Annotated[float, Unit("1", at_least=0.0, at_most=1.0)]
_Gs = Annotated[float, Unit("1")]
_TRAVELS = np.linspace(-0.1, 0.1, 41)  # m: range in which the spring's equilibrium is searched


class LoadedAxle(Description):
    """Vehicle data of an axle, for the wheel loads.

    ``axle``; ``mass`` (kg) of the whole car, ``wheelbase`` (m), ``centre_of_mass_height`` (m, above the ground);
    ``weight_share`` of this axle at rest, ``brake_share`` and ``drive_share`` of it in longitudinal forces, and
    ``roll_share`` is its share of the lateral load transfer, by default that of its weight.
    """

    axle: Literal["front", "rear"]
    mass: Mass
    wheelbase: CarLength
    centre_of_mass_height: CarLength
    weight_share: _Share
    brake_share: _Share
    drive_share: _Share = 0.0
    roll_share: _Share | None = None


class LoadCase(Description):
    """Accelerations of the car in g.

    ``longitudinal`` is forward (braking is negative), ``lateral`` to the left; ``vertical`` multiplies the weight on
    the wheels: 3 in a bump of 3 g.
    """

    longitudinal: _Gs = 0.0
    lateral: _Gs = 0.0
    vertical: _Gs = 1.0


LOAD_CASES: dict[str, LoadCase] = {
    "static": LoadCase(),
    "braking 1 g": LoadCase(longitudinal=-1.0),
    "cornering 1 g": LoadCase(lateral=1.0),
    "bump 3 g": LoadCase(vertical=3.0),
    "braking and cornering 0.7 g each": LoadCase(longitudinal=-0.7, lateral=0.7),
}
"""Common load cases by name."""


def load_cases(
    rig: Rig, car: LoadedAxle, cases: Mapping[str, LoadCase | Mapping[str, float]] | None = None
) -> xr.Dataset:
    """Compute forces in every link, joint and pickup point of both wheels of an axle for load cases of the car.

    Wheel loads follow from weight and load transfer of a rigid car, between the axles over the wheelbase, between the
    wheels over the track of the contact points at design; a wheel or an axle that would lift off carries no load, and
    the other one the total. The wheels share longitudinal and lateral forces of the axle in proportion to their loads;
    brakes are outboard, and the body reacts drive torque. Each wheel is at the travel at which its spring, stops and
    damper gas carry its load, with anti-roll bar and third spring between both wheels (at design if the rig has no
    spring). Parts are massless. ``attrs["findings"]`` names cases that the springs cannot carry, and those in which the
    car would tip over an axle.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints; the other side is its mirror image.
    car : LoadedAxle
        Vehicle data of the axle.
    cases : mapping of str to LoadCase, optional
        Cases by name, accelerations in g; `LOAD_CASES` by default.

    Returns
    -------
    xarray.Dataset
        On ``case`` and ``wheel`` (left, right): ``longitudinal_force``, ``lateral_force``, ``vertical_force`` at the
        contact point (N), ``wheel_travel`` (m), the forces of :func:`pickup_loads` at each hardpoint (N), and the
        forces of anti-roll bar and third spring (``anti_roll_bar_link.axial_force``, ``third_spring.force``).

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints, or there is no case.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.LoadedAxle(
    ...     axle="front", mass="280 kg", wheelbase="1.55 m", centre_of_mass_height="0.3 m", weight_share=0.48,
    ...     brake_share=0.65,
    ... )
    >>> cases = jn.load_cases(jn.load("formula-student-front"), car)
    >>> round(float(cases["vertical_force"].sel(case="static", wheel="left")), 1)   # N
    659.2
    """
    return solved_cases(rig, car, cases)[0]


def solved_cases(
    rig: Rig, car: LoadedAxle, cases: Mapping[str, LoadCase | Mapping[str, float]] | None = None
) -> tuple[xr.Dataset, list[Finding]]:
    """Solve load cases as :func:`load_cases`, and return the findings as well."""
    import xarray as xr

    corner = check_corner(rig)
    chosen = LOAD_CASES if cases is None else cases
    if not chosen:
        raise DescriptionError(
            "no load case", where="cases", allowed="a name and its accelerations"
        )
    read = {
        name: case if isinstance(case, LoadCase) else LoadCase(**case)
        for name, case in chosen.items()
    }
    left = corner if corner.side == "left" else corner.mirrored()
    right, rack = left.mirrored(), _rack_travel(left)
    sides = {
        "left": left,
        "right": right.with_changes({"steering.rack_travel": rack}) if rack else right,
    }
    is_connected = left.anti_roll_bar is not None or left.third_spring is not None
    forces, notes = [], []
    for name, case in read.items():
        loads = wheel_loads(car, case, left)
        notes += _tips(car, case, name)
        if is_connected and not {"spring"} & set(left.lacks):
            travels, findings = _together(left, loads, name)
        else:
            stands = [
                _equilibrium(side, load, f"{name}, {wheel} wheel")
                for (wheel, side), load in zip(sides.items(), loads, strict=True)
            ]
            travels, findings = (
                (stands[0][0], stands[1][0]),
                [note for _, more in stands for note in more],
            )
        notes += findings
        pairs = zip(
            sides.values(),
            loads,
            travels,
            from_across(left, travels) if is_connected else (None, None),
            strict=True,
        )
        forces.append([_of_wheel(*pair) for pair in pairs])
    units = {name: unit for name, (_, unit, _) in forces[0][0].items()}
    texts = {name: text for name, (_, _, text) in forces[0][0].items()}
    variables = {
        name: (
            ("case", "wheel"),
            np.array([[wheel[name][0] for wheel in pair] for pair in forces]),
            {"units": units[name], "long_name": texts[name]},
        )
        for name in units
    }
    facts = {"model": str(getattr(rig, "model", "")), "findings": "; ".join(map(str, notes))}
    return xr.Dataset(variables, {"case": list(read), "wheel": list(sides)}, facts), notes


def wheel_loads(car: LoadedAxle, case: LoadCase, rig: Corner) -> tuple[ContactLoad, ContactLoad]:
    """Return the road loads on the left and the right wheel (N, ground axes) in a case."""
    weight = car.mass * GRAVITY
    axle = min(max(_axle_load(car, case), 0.0), max(case.vertical * weight, 0.0))
    share = car.weight_share if car.roll_share is None else car.roll_share
    wheel = rig.wheel
    level = math.cos(wheel.camber)
    axis = math.sin(wheel.toe) * level, math.cos(wheel.toe) * level, -math.sin(wheel.camber)
    (_, outward, _), _ = towards_road(axis, (0.0, 0.0, 1.0))
    track = 2.0 * (abs(rig.hardpoints.wheel_centre[1]) + wheel.radius * outward)
    across = weight * case.lateral * car.centre_of_mass_height * share / track
    left = min(max(0.5 * axle - across, 0.0), axle)
    braked = case.longitudinal < 0.0
    longitudinal = weight * case.longitudinal * (car.brake_share if braked else car.drive_share)
    lateral = weight * case.lateral * car.weight_share
    parts = (left / axle, 1.0 - left / axle) if axle > 0.0 else (0.0, 0.0)
    left_load, right_load = (
        ContactLoad(
            longitudinal_force=longitudinal * part,
            lateral_force=lateral * part,
            vertical_force=axle * part,
            through="contact_point" if braked else "wheel_centre",
        )
        for part in parts
    )
    return left_load, right_load


def _axle_load(car: LoadedAxle, case: LoadCase) -> float:
    """Return the axle load (N) from moment equilibrium; negative if the axle would lift off."""
    weight = car.mass * GRAVITY
    ahead = weight * case.longitudinal * car.centre_of_mass_height / car.wheelbase
    return case.vertical * weight * car.weight_share + (-ahead if car.axle == "front" else ahead)


def _tips(car: LoadedAxle, case: LoadCase, name: str) -> list[Finding]:
    """Report braking or driving that would lift an axle off the road, so no equilibrium exists."""
    axle, total = _axle_load(car, case), case.vertical * car.mass * GRAVITY
    if total <= 0.0 or 0.0 <= axle <= total:
        return []
    lifted = car.axle if axle < 0.0 else {"front": "rear", "rear": "front"}[car.axle]
    return [
        finding(
            "kinematics.car_tips",
            name,
            min(axle, total - axle),
            end=f"{lifted} axle",
            load=min(axle, total - axle),
        )
    ]


@dataclass(frozen=True)
class FromAcross:
    """Effects of the other wheel on one wheel: tension of the bar's link (N), ends on a T-bar (m), third spring.

    ``turn`` is the torque (N m about the bar's axis to the left) on a U- or Z-bar's end; ``tension`` that of a T-bar's
    link; ``third`` the force of the third spring and its vector on the suspension (N).
    """

    turn: float | None = None
    tension: float | None = None
    arm_end: Array | None = None
    stem_end: Array | None = None
    third: tuple[float, Array] | None = None


def from_across(left: Corner, travels: tuple[float, float]) -> list[FromAcross]:
    """Effects of anti-roll bar and third spring on each wheel of an axle."""
    axle, rack = TwoWheelAxle(left), np.full(1, _rack_travel(left))
    wheels = [
        axle.wheel(side, np.full(1, travel), rack)
        for side, travel in zip((1.0, -1.0), travels, strict=True)
    ]
    connection = axle.connection(*wheels)
    third = (
        None
        if connection.third is None
        else (float(connection.third[0][0]), connection.third[1][0])
    )
    return [
        FromAcross(
            turn=float(connection.turns[i][0]) if connection.turns else None,
            tension=float(connection.links[i][0]) if connection.links else None,
            arm_end=connection.arm_ends[i][0] if connection.arm_ends else None,
            stem_end=None if connection.stem_end is None else connection.stem_end[0],
            third=None if third is None else (third[0], sign * third[0] * third[1]),
        )
        for i, sign in enumerate((1.0, -1.0))
    ]


def _rack_travel(rig: Corner) -> float:
    steering = getattr(rig, "steering", None)
    return 0.0 if steering is None else float(steering.rack_travel)


def _of_wheel(
    rig: Corner, load: ContactLoad, travel: float, across: FromAcross | None
) -> dict[str, tuple[float, str, str]]:
    """Return every force of one wheel: value, unit and label."""
    _, joints = balance_poses(prepare_sweep(rig, travel), load)
    if across is not None:
        _put_across(joints, across)
    unknowns = joints.balance.solve()
    forces = {
        name: (
            float(getattr(load, name)),
            "N",
            f"{name.replace('_', ' ')} of the road on the wheel",
        )
        for name in ("longitudinal_force", "lateral_force", "vertical_force")
    }
    forces["wheel_travel"] = travel, "m", "vertical travel of the wheel centre, bump positive"
    for name, force in vector_forces(joints, unknowns).items():
        for k, axis in enumerate("xyz"):
            text = f"{name.replace('_', ' ')}: force along {axis} on the part nearer to the body"
            forces[f"{name}.f{axis}"] = float(force[0, k]), "N", text
    for name, value, text in single_forces(joints, unknowns):
        forces[name] = float(value[0]), "N*m" if name.endswith(".torque") else "N", text
    return forces


def _put_across(joints: Joints, across: FromAcross) -> None:
    """Apply the forces of link and third spring to the suspension."""
    rig, points = joints.rig, joints.points
    if rig.anti_roll_bar is not None:
        end = points["arb_arm_end"][0] if across.arm_end is None else across.arm_end
        link = points["arb_link_end"][0] - end
        link = link / np.linalg.norm(link)
        tension = across.tension
        if tension is None:
            lever = np.cross(bar_axis(rig), end - points["arb_pivot"][0])
            tension = float((across.turn or 0.0) / (link @ lever))
        joints.push(
            rig.anti_roll_bar.on,
            -tension * link[None, :],
            ("arb_link_end", "arb_arm_end", "arb_pivot"),
        )
        text = "link of the anti-roll bar: axial force, tension positive"
        joints.given["anti_roll_bar_link.axial_force"] = np.full(1, tension), text
    if rig.third_spring is not None and across.third is not None:
        force, push = across.third
        joints.push(rig.third_spring.on, push[None, :], ("third_spring_end",))
        joints.given["third_spring.force"] = (
            np.full(1, force),
            "force of the third spring, compression positive",
        )


def bar_axis(rig: Corner) -> Array:
    """Direction of the anti-roll bar's axis, to the left, shape (3,)."""
    points = rig.hardpoints
    if points.arb_axis is None or points.arb_pivot is None:
        return np.array([0.0, 1.0, 0.0])
    along = np.array(points.arb_axis) - np.array(points.arb_pivot)
    return np.asarray(along / np.linalg.norm(along) * (-1.0 if along[1] < 0.0 else 1.0))


_NEWTON, _CLOSE, _FARTHEST, _STEP = (
    60,
    1e-9,
    0.1,
    0.01,
)  # iterations; N over N; m of travel; m in one step
_DIFFERENCE = 1e-6  # m: of slopes that only set the direction of steps


def _together(
    rig: Corner, loads: tuple[ContactLoad, ContactLoad], name: str
) -> tuple[tuple[float, float], list[Finding]]:
    """Find the travels (m) of both wheels at which all springs carry both loads, or come closest."""
    axle, rack = TwoWheelAxle(rig), np.full(3, _rack_travel(rig))
    size = sum(
        abs(load.vertical_force) + abs(load.lateral_force) + abs(load.longitudinal_force)
        for load in loads
    )
    travel, step, share = np.zeros(2), np.zeros(2), 1.0
    best, least = travel, np.inf
    for _ in range(_NEWTON):
        tried = travel[:, None] + _DIFFERENCE * np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
        wheels = [axle.wheel(side, at, rack) for side, at in zip((1.0, -1.0), tried, strict=True)]
        forces = axle.connection(*wheels).forces
        off = np.array(
            [
                wheel.rows["wheel_force"] + force - _equivalent_force(load, wheel.rows, side)
                for wheel, force, load, side in zip(wheels, forces, loads, (1.0, -1.0), strict=True)
            ]
        )
        worst = float(np.max(np.abs(off[:, 0])))
        if not worst < least:  # out of reach, or no improvement: halve the step from the best pose
            share *= 0.5
            if share < _CLOSE:
                break
            travel = best + share * step
            continue
        best, least, share = travel, worst, 1.0
        if worst <= _CLOSE * max(size, 1.0):
            return (float(travel[0]), float(travel[1])), []
        slopes = (off[:, 1:] - off[:, :1]) / _DIFFERENCE
        if not np.all(np.isfinite(slopes)):  # at the end of travel
            break
        step = np.linalg.lstsq(slopes, -off[:, 0], rcond=None)[0]
        step = step * min(1.0, _STEP / max(float(np.max(np.abs(step))), _CLOSE))
        travel = np.clip(best + step, -_FARTHEST, _FARTHEST)
    return (float(best[0]), float(best[1])), [
        finding(
            "kinematics.springs_cannot_carry",
            name,
            least if np.isfinite(least) else None,
            travel=_FARTHEST,
        )
    ]


def _equivalent_force(load: ContactLoad, rows: dict[str, Array], side: float) -> Array:
    """Return the wheel-centre force (N, up) that does the same work along travel as a load (no aligning torque)."""
    rise = rows["motion_ratio"] / rows["motion_ratio_contact"]  # of the contact patch
    ahead = rows["contact_patch_recession"] * rise
    if load.through == "wheel_centre":
        ahead = rows["wheel_centre_longitudinal_slope"]
    lateral = side * load.lateral_force * rows["jacking"] * rise
    return np.asarray(load.vertical_force * rise + lateral + load.longitudinal_force * ahead)


def _equilibrium(rig: Corner, load: ContactLoad, where: str) -> tuple[float, list[Finding]]:
    """Find the travel (m) at which spring and stops provide the force that the load requires, or come closest."""
    if "spring" in rig.lacks:
        return 0.0, []
    sweep = prepare_sweep(rig, _TRAVELS)
    rows = {name: value[:, 0] for name, value in sweep.quantities().items()}
    reached = np.flatnonzero(np.isfinite(rows["wheel_travel"]))
    low, high = float(_TRAVELS[reached[0]]), float(_TRAVELS[reached[-1]])

    def over(travel: Array) -> Array:
        """Force (or torque) of the springs over the required one."""
        own = prepare_sweep(rig, travel).quantities()
        required = pickup_loads(rig, load, travel)
        if (
            "spring" in rig.without
        ):  # a torsion bar carries the load; only stops act along the strut
            strut = own["stop_force"] * own["motion_ratio"] / own["torsion_bar_motion_ratio"]
            return np.asarray(
                (own["torsion_bar_torque"] + strut)[:, 0] - required["torsion_bar.torque"]
            )
        force = (own["spring_force"] + own["stop_force"])[:, 0]
        return np.asarray(force - required["spring.force"].to_numpy())

    for _ in range(4):  # each round narrows the bracket 40 times: 0.2 m to 0.1 um
        travels = np.linspace(low, high, 41)
        excess = over(travels)
        crossed = np.flatnonzero((excess[:-1] <= 0.0) & (excess[1:] > 0.0))
        if not len(crossed):
            nearest = float(travels[np.nanargmax(np.where(excess > 0.0, -excess, excess))])
            return nearest, [
                finding(
                    "kinematics.spring_cannot_carry",
                    where,
                    load.vertical_force,
                    travel=_TRAVELS[-1],
                    nearest=nearest,
                )
            ]
        i = int(crossed[np.argmin(np.abs(travels[crossed]))])
        low, high = float(travels[i]), float(travels[i + 1])
    return 0.5 * (low + high), []


@old_argument("found", "loads")
def load_case_table(loads: xr.Dataset, quantities: Sequence[str] | None = None) -> str:
    """Return load cases as CSV, one row for each case and wheel, SI.

    Parameters
    ----------
    loads : xarray.Dataset
        As returned by :func:`load_cases`.
    quantities : sequence of str, optional
        Columns; all by default.

    Returns
    -------
    str
        Header ``name [unit]`` and rows.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.LoadedAxle(
    ...     axle="front", mass=280.0, wheelbase=1.55, centre_of_mass_height=0.3, weight_share=0.48, brake_share=0.65
    ... )
    >>> jn.load_case_table(jn.load_cases(jn.load("formula-student-front"), car)).splitlines()[0][:32]
    'case,wheel,longitudinal_force [N'
    """
    if not {"case", "wheel"} <= set(loads.coords):
        raise DescriptionError(
            "no load cases", where="loads", allowed="the result of jn.load_cases(...)"
        )
    names = list(map(str, quantities or loads.data_vars))
    for name in names:
        if name not in loads.data_vars:
            raise unknown(name, map(str, loads.data_vars), what="quantity", where="quantities")
    rows = [
        ",".join(["case", "wheel", *(f"{name} [{loads[name].attrs['units']}]" for name in names)])
    ]
    for case in loads["case"].to_numpy():
        for wheel in loads["wheel"].to_numpy():
            forces: Any = loads.sel(case=case, wheel=wheel)
            label = guard_formula(str(case).replace('"', "'"))
            rows.append(
                ",".join([f'"{label}"', str(wheel), *(repr(float(forces[name])) for name in names)])
            )
    return "\n".join([*rows, ""])
