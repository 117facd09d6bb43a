"""Adjustments of a double wishbone: what can be set, its effect on the wheel, lengths for a wanted camber and toe."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import cast

import casadi as ca
import numpy as np

from jounce.core.errors import AssemblyError, DescriptionError, JounceError, unknown
from jounce.core.findings import Finding
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.design.poses import moved_rig, rigid_motion, spin_axis
from jounce.kinematics import sweep_travel
from jounce.mechanics import Mechanism, Model, assemble
from jounce.parts import DoubleWishbone, Rig
from jounce.parts.bodies import Triple, distance
from jounce.parts.leverage import static_spring_force
from jounce.parts.variants import LARGEST, strut_angle, strut_angle_findings, with_strut_angle
from jounce.simulation import equilibrium

Value = str | float
PUBLISHED_ANGLES = (10.0, 16.0, 21.0, 26.0)
"""Strut angles of the prototype, degrees."""
BLOCK_MASS = 2.6
"""Mass of the block that carries a short upper arm, kg."""
_RODS = {
    "lower_arm_front": "lower_ball_joint",
    "lower_arm_rear": "lower_ball_joint",
    "upper_arm_front": "upper_ball_joint",
    "upper_arm_rear": "upper_ball_joint",
    "tie_rod_inner": "tie_rod_outer",
}
_UPRIGHT = ("lower_ball_joint", "upper_ball_joint", "tie_rod_outer", "wheel_centre")


@dataclass(frozen=True)
class Setting:
    """One adjustment: range in the SI ``unit``, what it is, and where the range comes from.

    ``base`` gives the value that a rig has as it is; ``ends`` the range for a rig where it depends on it; ``fits``
    whether a rig has what is set.
    """

    name: str
    unit: str
    lowest: float
    highest: float
    text: str
    source: str
    base: Callable[[DoubleWishbone], float] = field(default_factory=lambda: _unchanged)
    ends: Callable[[DoubleWishbone], tuple[float, float]] | None = None
    fits: Callable[[DoubleWishbone], bool] = field(default_factory=lambda: _always)

    def range_for(self, rig: DoubleWishbone) -> tuple[float, float]:
        """Lowest and highest value for a rig, SI."""
        return (self.lowest, self.highest) if self.ends is None else self.ends(rig)


def _unchanged(_rig: DoubleWishbone) -> float:
    """Value that a change has in a rig as it is."""
    return 0.0


def _always(_rig: DoubleWishbone) -> bool:
    return True


def _has_rocker(rig: DoubleWishbone) -> bool:
    return rig.hardpoints.rocker_pivot is not None


def _preload(rig: DoubleWishbone) -> float:
    """Spring force at design length, N."""
    spring = rig.strut.spring
    if spring.free_length is None:
        return spring.preload or 0.0
    if spring.rate is None:
        raise DescriptionError(
            "a spring curve has no single preload", where="strut.spring", hint="Set its free_length."
        )
    return spring.rate * (spring.free_length - rig.hardpoints.length("spring"))


def arm_length(rig: DoubleWishbone, arm: str) -> float:
    """Length of the ``"lower"`` or ``"upper"`` arm: distance of its ball joint from its inner axis, m."""
    front, rear, ball = _arm(rig, arm)
    _, along, _ = _foot(front, rear, ball)
    return float(np.linalg.norm(along))


def _preloads(rig: DoubleWishbone) -> tuple[float, float]:
    """From no load to twice what the spring carries at rest, N."""
    return 0.0, 2.0 * static_spring_force(rig)


def _short_arms(rig: DoubleWishbone) -> tuple[float, float]:
    """From half of the upper arm's length to all of it, m."""
    return 0.5 * arm_length(rig, "upper"), arm_length(rig, "upper")


_PAPER = "quarter-car prototype paper, section 4"
_SHIMS = "no published range; estimated"
_ESTIMATED = "the paper gives no range; estimated"
_FIVE, _TOE = float(np.radians(5.0)), float(np.radians(10.5))
_TURNBUCKLE = "lengthening of the {} arm at its turnbuckle"
SETTINGS: dict[str, Setting] = {
    item.name: item
    for item in (
        Setting("lower_arm_length", "m", 0.0, 0.020, _TURNBUCKLE.format("lower"), _PAPER),
        Setting("upper_arm_length", "m", 0.0, 0.020, _TURNBUCKLE.format("upper"), _PAPER),
        Setting("tie_rod_length", "m", -0.020, 0.020, "lengthening of the tie rod", f"toe of 10.5 deg: {_PAPER}"),
        Setting("lower_arm_support", "m", -0.030, 0.030, "rise of the lower arm's inner supports", _ESTIMATED),
        Setting("upper_arm_support", "m", -0.030, 0.030, "rise of the upper arm's inner supports", _ESTIMATED),
        Setting(
            "strut_angle",
            "rad",
            float(np.radians(PUBLISHED_ANGLES[0])),
            float(np.radians(PUBLISHED_ANGLES[-1])),
            "angle of the strut to the vertical, top inboard",
            f"10, 16, 21, 26 deg: {_PAPER}",
            strut_angle,
        ),
        Setting(
            "spring_preload", "N", 0.0, 361.7, "spring force at design length", _ESTIMATED, _preload, ends=_preloads
        ),
        Setting("camber_shim", "m", -0.010, 0.010, "shims between upright and upper ball joint, wheel outward", _SHIMS),
        Setting("pushrod_length", "m", -0.010, 0.010, "lengthening of the push rod", _SHIMS, fits=_has_rocker),
        Setting("camber_wedge", "rad", -_FIVE, _FIVE, "tilt of the wheel on the upright, top outward", _ESTIMATED),
        Setting("toe_wedge", "rad", -_TOE, _TOE, "turn of the wheel on the upright, toe-in", _ESTIMATED),
        Setting(
            "short_upper_arm",
            "m",
            0.1125,
            0.225,
            "length of a short upper arm, its inner supports on a block of 2.6 kg",
            f"block: {_PAPER}; lengths estimated",
            lambda rig: arm_length(rig, "upper"),
            ends=_short_arms,
        ),
    )
}


def read_settings(rig: Rig, settings: Mapping[str, Value]) -> dict[str, float]:
    """Check settings (a strut angle only has to be possible, all else lies in its range); give their values in SI."""
    corner = _double_wishbone(rig)
    found = {}
    for name, given in settings.items():
        if name not in SETTINGS:
            raise unknown(name, SETTINGS, what="setting", where="adjust")
        setting = SETTINGS[name]
        if not setting.fits(corner):
            raise DescriptionError("this rig has nothing to set there", where=name, hint="It needs a rocker.")
        value = to_si(given, setting.unit, where=name)
        low, high = (-LARGEST, LARGEST) if name == "strut_angle" else setting.range_for(corner)
        if not low - 1e-12 <= value <= high + 1e-12:
            raise DescriptionError(
                "out of range",
                where=name,
                found=given,
                allowed=f"{shown(low, setting.unit)} to {shown(high, setting.unit)} ({setting.source})",
            )
        found[name] = value
    return found


def shown(value: float, unit: str) -> str:
    """Write a value in the unit that people use for it: mm, deg."""
    factor, name = {"m": (1e3, "mm"), "rad": (180.0 / np.pi, "deg")}.get(unit, (1.0, unit))
    return f"{value * factor:.4g} {name}"


def adjustment_findings(values: Mapping[str, float]) -> list[Finding]:
    """Doubts about settings (SI): angles that were not built or are too steep."""
    if "strut_angle" not in values:
        return []
    angle = values["strut_angle"]
    steep = strut_angle_findings(angle, "strut_angle")
    if steep or any(abs(np.degrees(angle) - known) < 0.05 for known in PUBLISHED_ANGLES):
        return steep
    built = ", ".join(f"{known:g}" for known in PUBLISHED_ANGLES)
    text = f"{np.degrees(angle):.4g} deg is not one of the angles that were built ({built} deg)."
    return [Finding("strut_angle", "note", text, float(angle))]


def adjusted(rig: Rig, settings: Mapping[str, Value]) -> DoubleWishbone:
    """Give the rig with some adjustments made.

    Parameters
    ----------
    rig : Rig
        A double wishbone; it is not changed.
    settings : dict
        Setting to value, text with a unit or SI; see ``SETTINGS``. Lengths and supports of arms are changes.

    Returns
    -------
    DoubleWishbone
        Its design is the newly assembled pose: the height of the wheel centre is kept, the upright moved as a rigid
        body, arms (with the foot of the strut) turned about their inner axes; camber and toe are those of the moved
        upright. The spring keeps its free length. A preload is set last.

    Raises
    ------
    DescriptionError
        For another rig, an unknown setting, or a value out of its range.
    AssemblyError
        When arms, upright and tie rod do not go together.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> rig = adjusted(jn.load("kart-double-wishbone"), {"upper_arm_length": "20 mm"})
    >>> round(float(np.degrees(rig.wheel.camber)), 1)   # the paper gives 5 deg
    5.2
    """
    corner, values = _double_wishbone(rig), read_settings(rig, settings)
    corner.require_strut_alone("an adjustment")
    corner = _assembled(corner, values)
    wedges = {
        f"wheel.{name}": getattr(corner.wheel, name) + values[f"{name}_wedge"]
        for name in ("camber", "toe")
        if f"{name}_wedge" in values
    }
    corner = corner.with_changes(wedges) if wedges else corner
    if "short_upper_arm" in values and corner.sprung is not None:
        corner = corner.with_changes({"sprung.mass": corner.sprung.mass + BLOCK_MASS})
    corner = with_strut_angle(corner, values["strut_angle"]) if "strut_angle" in values else corner
    return _preloaded(corner, values["spring_preload"]) if "spring_preload" in values else corner


def _double_wishbone(rig: Rig) -> DoubleWishbone:
    if not isinstance(rig, DoubleWishbone):
        raise DescriptionError(
            "these adjustments are for a double wishbone",
            where="rig",
            found=f'model = "{getattr(rig, "model", "")}"',
            allowed='model = "double-wishbone", e.g. kart-double-wishbone of `jounce library`',
        )
    return rig


def _preloaded(rig: DoubleWishbone, force: float) -> DoubleWishbone:
    """Turn the spring's seat until its force at design length is ``force`` (N)."""
    spring = rig.strut.spring
    if spring.free_length is None:
        return rig.with_changes({"strut.spring.preload": force})
    longer = (force - _preload(rig)) / cast(float, spring.rate)
    return rig.with_changes({"strut.spring.free_length": spring.free_length + longer})


def _arm(rig: DoubleWishbone, arm: str) -> tuple[Array, Array, Array]:
    """Front and rear support and ball joint of an arm."""
    names = (f"{arm}_arm_front", f"{arm}_arm_rear", f"{arm}_ball_joint")
    front, rear, ball = (np.array(getattr(rig.hardpoints, name)) for name in names)
    return front, rear, ball


def _foot(front: Array, rear: Array, ball: Array) -> tuple[Array, Array, Array]:
    """Foot of the ball joint on the arm's axis, the way from there to the ball joint, direction of the axis."""
    axis = (front - rear) / np.linalg.norm(front - rear)
    foot = front + axis * ((ball - front) @ axis)
    return foot, ball - foot, axis


def _assembled(rig: DoubleWishbone, values: Mapping[str, float]) -> DoubleWishbone:
    """Make the changes of the linkage, if there are any."""
    geometry = [name for name in values if name.endswith(("_length", "_support")) or name in _OTHER_GEOMETRY]
    if not any(values[name] != SETTINGS[name].base(rig) for name in geometry):
        return rig
    before = rig.hardpoints.given()
    inner, lengths = _supports_and_lengths(rig, values)
    upright = np.array(before["upper_ball_joint"]) - values.get("camber_shim", 0.0) * spin_axis(rig)
    before["upper_ball_joint"] = _triple(upright)  # where the upright has it; the arm's end is found
    places: dict[str, Triple] = {**before, **inner}
    places |= _upright_places(places, lengths)
    turn, shift = rigid_motion(np.array([before[n] for n in _UPRIGHT]), np.array([places[n] for n in _UPRIGHT]))
    places |= {name: _triple(turn @ np.array(before[name]) + shift) for name in _on(rig, "upright")}
    before = rig.hardpoints.given()
    for arm in ("lower_arm", "upper_arm"):
        places |= _carried(rig, arm, before, places)
    if _has_rocker(rig):
        places |= _rocker_places(rig, before, places, values.get("pushrod_length", 0.0))
    return moved_rig(rig, places, (turn, shift) if "camber_shim" in values else None)


_OTHER_GEOMETRY = ("short_upper_arm", "camber_shim")


def _rocker_places(
    rig: DoubleWishbone, before: Mapping[str, Triple], places: Mapping[str, Triple], longer: float
) -> dict[str, Triple]:
    """Places of the rocker's points where the push rod fits, the nearer of both ways to turn it."""
    pivot, end, inner = (np.array(before[name]) for name in ("rocker_pivot", "rocker_axis", "pushrod_inner"))
    outer = np.array(places["pushrod_outer"]) - pivot
    length = distance(before["pushrod_outer"], before["pushrod_inner"]) + longer
    axis = (end - pivot) / np.linalg.norm(end - pivot)
    arm = inner - pivot
    along = (arm @ axis) * axis
    flat = arm - along
    across = np.cross(axis, flat)
    # |arm turned - outer| = length is a cos(turn) + b sin(turn) = needed
    a, b = float(flat @ outer), float(across @ outer)
    needed = 0.5 * float(arm @ arm + outer @ outer - length**2) - float(along @ outer)
    if abs(needed) > np.hypot(a, b):
        raise AssemblyError("rocker and push rod do not go together", where="pushrod_length", found=shown(longer, "m"))
    middle, half = np.arctan2(b, a), np.arccos(needed / np.hypot(a, b))
    turns = [(middle + sign * half + np.pi) % (2.0 * np.pi) - np.pi for sign in (1.0, -1.0)]
    turn = min(turns, key=abs)

    def turned(name: str) -> Triple:
        away = np.array(before[name]) - pivot
        on_axis = (away @ axis) * axis
        rest = away - on_axis
        return _triple(pivot + on_axis + rest * np.cos(turn) + np.cross(axis, rest) * np.sin(turn))

    return {name: turned(name) for name in ("pushrod_inner", *_on(rig, "rocker"))}


def _supports_and_lengths(
    rig: DoubleWishbone, values: Mapping[str, float]
) -> tuple[dict[str, Triple], dict[str, float]]:
    """Moved inner points, and lengths of the five rods that hold the upright."""
    inner: dict[str, Triple] = {}
    lengths: dict[str, float] = {}
    for arm in ("lower", "upper"):
        front, rear, ball = _arm(rig, arm)
        foot, along, axis = _foot(front, rear, ball)
        own = float(np.linalg.norm(along))
        reach = own + values.get(f"{arm}_arm_length", 0.0)
        shift = np.array([0.0, 0.0, values.get(f"{arm}_arm_support", 0.0)])
        if arm == "upper" and "short_upper_arm" in values:
            shift = shift + along * (own - values["short_upper_arm"]) / own
            reach -= own - values["short_upper_arm"]
        for name, end in (("front", front), ("rear", rear)):
            inner[f"{arm}_arm_{name}"] = _triple(end + shift)
            lengths[f"{arm}_arm_{name}"] = float(np.hypot((end - foot) @ axis, reach))
    points = rig.hardpoints
    lengths["tie_rod_inner"] = distance(points.tie_rod_inner, points.tie_rod_outer) + values.get("tie_rod_length", 0.0)
    return inner, lengths


@cache
def _upright_on_rods() -> tuple[Model, ca.Function, dict[str, float]]:
    """Upright that flies, held by five rods, its wheel centre at one height; places of its points; values of it all."""
    mechanism = Mechanism()
    origin = (0.0, 0.0, 0.0)
    upright = mechanism.body("upright", 1.0, origin, (1.0, 1.0, 1.0))
    mechanism.free("upright", upright)
    points = {name: mechanism.vector(name, origin) for name in _UPRIGHT}
    for inner, outer in _RODS.items():
        mechanism.rod(inner, mechanism.ground, upright, origin, points[outer], length=1.0)
    places = [upright.frame.point(points[name]).value for name in _UPRIGHT]
    mechanism.condition("wheel_centre_height", places[-1][2] - mechanism.number("height", 0.0))
    model = mechanism.finish()
    return model, ca.Function("places", [model.x, model.p], [ca.horzcat(*places)]), mechanism.values


def _upright_places(places: Mapping[str, Triple], lengths: Mapping[str, float]) -> dict[str, Triple]:
    """Places of the upright's points where all rods fit and the wheel centre keeps its height."""
    model, function, known = _upright_on_rods()
    values = {**known, "height": places["wheel_centre"][2]}
    for name, length in lengths.items():
        values[f"{name}.length"] = length
        values |= {f"{name}.at[{i}]": places[name][i] for i in range(3)}
    for name in _UPRIGHT:
        values |= {f"{name}[{i}]": places[name][i] for i in range(3)}
    p = np.array([values[path] for path in model.parameters])
    try:
        pose = assemble(model, p, np.zeros(model.u.shape[0]))
    except AssemblyError as error:
        raise AssemblyError(
            "the linkage cannot be assembled with these settings",
            where=error.where,
            found=error.found,
            hint="Make smaller changes.",
        ) from None
    found = function(pose.x, p).full()
    return {name: _triple(found[:, i]) for i, name in enumerate(_UPRIGHT)}


def _on(rig: DoubleWishbone, body: str) -> list[str]:
    """Points besides its joints that move with a body."""
    names = []
    if rig.strut.on == body:
        ends = ("strut_bottom", "spring_bottom", "damper_bottom")
        names += [name for name in ends if getattr(rig.hardpoints, name) is not None]
    if rig.anti_roll_bar is not None and rig.anti_roll_bar.on == body:
        names.append("arb_link_end")
    if _has_rocker(rig) and getattr(rig.strut, "pushrod_on", "upright") == body:
        names.append("pushrod_outer")
    return names


def _carried(
    rig: DoubleWishbone, arm: str, before: Mapping[str, Triple], after: Mapping[str, Triple]
) -> dict[str, Triple]:
    """Points on an arm: they turn with it and keep their distance from its ball joint."""
    ball = arm.replace("arm", "ball_joint")
    names = (f"{arm}_front", f"{arm}_rear", ball)
    turn, _ = rigid_motion(np.array([before[n] for n in names]), np.array([after[n] for n in names]))
    old, new = np.array(before[ball]), np.array(after[ball])
    return {name: _triple(new + turn @ (np.array(before[name]) - old)) for name in _on(rig, arm)}


def _triple(place: Array) -> Triple:
    x, y, z = (float(value) for value in place)
    return x, y, z


QUANTITIES: Mapping[str, str] = {
    "camber": "rad",
    "toe": "rad",
    "caster": "rad",
    "camber_gain": "rad/m",
    "roll_centre_height": "m",
    "ride_height": "m",
    "wheel_rate": "N/m",
}
"""What is reported, with its SI unit."""
OVER_TRAVEL: Mapping[str, str] = {
    "camber": "rad",
    "toe": "rad",
    "roll_centre_height": "m",
    "motion_ratio": "1",
    "wheel_rate": "N/m",
}
"""What is reported over travel, with its SI unit: what arms of another length change shows away from design only."""
_TRAVELS = (-0.03, -0.015, 0.0, 0.015, 0.03)  # m
_STEP = 1e-3
"""Share of a setting's range over which its effect per unit is taken."""
_CLOSE = 1e-10  # rad
_NUDGE = 1e-6  # m
_ROUNDS = 30


@dataclass(frozen=True)
class WheelState:
    """How the wheel stands. Angles and roll centre at design height; ride height and wheel rate at rest. SI.

    Attributes
    ----------
    camber, toe, caster : float
        rad; top outward, toe-in, top rearward positive.
    camber_gain : float
        Change of camber with travel, rad/m, positive where the top goes outward in bump.
    roll_centre_height : float
        Above the ground, m.
    ride_height : float or None
        Rise of the body from design at rest, m; None for a fixed body.
    wheel_rate : float
        N/m, with its preload term.
    """

    camber: float
    toe: float
    caster: float
    camber_gain: float
    roll_centre_height: float
    ride_height: float | None
    wheel_rate: float


@dataclass(frozen=True)
class Effect:
    """What one setting does.

    Attributes
    ----------
    setting : str
        Its name.
    unit : str
        SI unit of its value.
    lowest, base, highest : float
        Ends of its range and the rig's own value, SI.
    at_lowest, at_highest : WheelState or None
        Wheel at the ends; None where the linkage does not go together there.
    per_unit : dict
        Quantity to its change for one SI unit of the setting, at the rig's own value; None where there is none.
    """

    setting: str
    unit: str
    lowest: float
    base: float
    highest: float
    at_lowest: WheelState | None
    at_highest: WheelState | None
    per_unit: dict[str, float | None]


@dataclass(frozen=True)
class OverTravel:
    """Quantities (SI) over wheel travel (m, bump positive), NaN where the wheel does not get to."""

    travel: tuple[float, ...]
    before: dict[str, tuple[float, ...]]
    after: dict[str, tuple[float, ...]]


@dataclass(frozen=True)
class AdjustReport(Shown):
    """What adjustments do to a rig: settings that were made (SI), the wheel before and after, the rig with them.

    ``effects`` says what each setting would do to the rig as given, ``over_travel`` what the settings did away from
    design.
    """

    settings: dict[str, float]
    before: WheelState
    after: WheelState
    rig: DoubleWishbone
    effects: tuple[Effect, ...]
    over_travel: OverTravel
    findings: tuple[Finding, ...] = field(default_factory=tuple)


@dataclass(frozen=True)
class Lengths(Shown):
    """Lengthenings that reach a camber and a toe, m, and what they reach, rad."""

    lower_arm_length: float
    upper_arm_length: float
    tie_rod_length: float
    camber: float
    toe: float

    def settings(self) -> dict[str, float]:
        """Those that are not zero, as ``adjusted`` takes them."""
        found = {name: getattr(self, name) for name in ("lower_arm_length", "upper_arm_length", "tie_rod_length")}
        return {name: value for name, value in found.items() if value != 0.0}


def wheel_state(rig: DoubleWishbone) -> WheelState:
    """Give how the wheel of a double wishbone stands."""
    if rig.guide == "fixed":
        ride, travel = None, 0.0
    else:
        rest = equilibrium(rig)
        ride, travel = rest["sprung.z"], rest["unsprung.z"] - rest["sprung.z"]
    points = sorted({0.0, travel})
    sweep = sweep_travel(rig, points)
    design, at_rest = (sweep.isel(wheel_travel=points.index(value)) for value in (0.0, travel))
    camber, toe, caster, gain, centre = (
        float(design[name]) for name in ("camber", "toe", "caster", "camber_gain", "roll_centre_height")
    )
    return WheelState(camber, toe, caster, gain, centre, ride, float(at_rest["wheel_rate"]))


def adjust_report(rig: Rig, settings: Mapping[str, Value] | None = None, *, effects: bool = True) -> AdjustReport:
    """Report what settings do to a rig, and what each setting could do.

    Parameters
    ----------
    rig : Rig
        A double wishbone; it is not changed.
    settings : dict, optional
        Settings to make: name to value, text with a unit or SI.
    effects : bool
        Whether every setting is taken over its range, too.

    Returns
    -------
    AdjustReport

    Raises
    ------
    DescriptionError
        For another rig, an unknown setting, or a value out of its range.
    AssemblyError
        When arms, upright and tie rod do not go together with the settings.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> report = adjust_report(jn.load("kart-double-wishbone"), {"tie_rod_length": "20 mm"}, effects=False)
    >>> round(float(np.degrees(report.after.toe)), 1)   # the paper gives 10.5 deg
    10.7
    """
    values = read_settings(rig, settings or {})
    changed = adjusted(rig, values)
    assert isinstance(rig, DoubleWishbone)
    before = wheel_state(rig)
    findings = adjustment_findings(values)
    found: list[Effect] = []
    for setting in (item for item in SETTINGS.values() if effects and item.fits(rig)):
        try:
            found.append(_effect(rig, setting, findings))
        except JounceError as error:
            findings.append(Finding(setting.name, "note", f"is not available: {error}"))
    after = wheel_state(changed) if values else before
    first = _over_travel(rig)
    over = OverTravel(_TRAVELS, first, _over_travel(changed) if values else first)
    return AdjustReport(values, before, after, changed, tuple(found), over, tuple(findings))


def _over_travel(rig: DoubleWishbone) -> dict[str, tuple[float, ...]]:
    """Quantities at all travels that the linkage reaches."""
    rows = []
    for travel in _TRAVELS:
        try:
            pose = sweep_travel(rig, [travel]).isel(wheel_travel=0)
        except JounceError:
            rows.append(dict.fromkeys(OVER_TRAVEL, float("nan")))
        else:
            rows.append({name: float(pose[name]) for name in OVER_TRAVEL})
    return {name: tuple(row[name] for row in rows) for name in OVER_TRAVEL}


def lengths_for(rig: Rig, camber: Value | None = None, toe: Value | None = None) -> Lengths:
    """Find the lengths of arms and tie rod that give a wanted camber and toe.

    One arm is lengthened, the upper one for more camber, the lower one for less, and the tie rod sets the toe. Without
    a wanted toe the tie rod is left alone, and the toe comes out as it does; without a wanted camber the arms are.

    Parameters
    ----------
    rig : Rig
        A double wishbone; it is not changed.
    camber : str or float, optional
        Wanted static camber, text with a unit or rad, top outward positive.
    toe : str or float, optional
        Wanted static toe, text with a unit or rad, toe-in positive.

    Returns
    -------
    Lengths
        Changes of length in m, and the camber and toe that they give, rad.

    Raises
    ------
    DescriptionError
        When no target is given, or when it is out of what the published lengths reach.

    Examples
    --------
    >>> import jounce as jn
    >>> found = lengths_for(jn.load("kart-double-wishbone"), camber="-2 deg", toe="0.5 deg")
    >>> round(1e3 * found.lower_arm_length, 2), found.upper_arm_length   # mm
    (7.68, 0.0)
    """
    if camber is None and toe is None:
        raise DescriptionError("no target is given", where="lengths_for", allowed="camber, toe, or both")
    read_settings(rig, {})
    assert isinstance(rig, DoubleWishbone)
    wished = {
        name: to_si(value, "rad", where=name) for name, value in (("camber", camber), ("toe", toe)) if value is not None
    }
    arms = ["lower_arm_length", "upper_arm_length"]
    if wished.get("camber", rig.wheel.camber) >= rig.wheel.camber:
        arms.reverse()
    for arm in arms if camber is not None else arms[:1]:  # the tie rod turns the wheel a little, too
        names = [{"camber": arm, "toe": "tie_rod_length"}[name] for name in wished]
        lengths = _solve(rig, wished, names)
        if lengths is not None:
            break
    else:
        raise _out_of_reach(rig, wished)
    wheel = adjusted(rig, lengths).wheel
    every = {name: lengths.get(name, 0.0) for name in (*sorted(arms), "tie_rod_length")}
    return Lengths(**every, camber=wheel.camber, toe=wheel.toe)


def _solve(rig: DoubleWishbone, wished: Mapping[str, float], names: list[str]) -> dict[str, float] | None:
    """Newton with bounds; None when it ends at a bound or the linkage does not go together."""
    low, high = (np.array([getattr(SETTINGS[name], end) for name in names]) for end in ("lowest", "highest"))
    target = np.array(list(wished.values()))

    def miss(lengths: Array) -> Array:
        wheel = adjusted(rig, _named(names, lengths)).wheel
        return np.asarray([getattr(wheel, name) for name in wished] - target, dtype=float)

    lengths = np.clip(np.zeros(len(names)), low, high)
    for _ in range(_ROUNDS):
        try:
            missed = miss(lengths)
            if np.max(np.abs(missed)) < _CLOSE:
                return _named(names, lengths)
            inward = np.where(lengths + _NUDGE > high, -_NUDGE, _NUDGE)
            columns = [(miss(lengths + step) - missed) / step.sum() for step in np.diag(inward)]
            lengths = np.clip(lengths - np.linalg.solve(np.column_stack(columns), missed), low, high)
        except (JounceError, np.linalg.LinAlgError):
            return None
    return None


def _named(names: list[str], lengths: Array) -> dict[str, float]:
    return {name: float(value) for name, value in zip(names, lengths, strict=True)}


def _out_of_reach(rig: DoubleWishbone, wished: Mapping[str, float]) -> DescriptionError:
    """Say what the published lengths reach."""
    longest = {
        "camber": ({"lower_arm_length": 0.020}, {"upper_arm_length": 0.020}),
        "toe": ({"tie_rod_length": -0.020}, {"tie_rod_length": 0.020}),
    }
    texts = []
    for name in wished:
        ends = sorted(getattr(adjusted(rig, lengths).wheel, name) for lengths in longest[name])
        texts.append(f"{name} from {shown(ends[0], 'rad')} to {shown(ends[1], 'rad')}")
    found = ", ".join(f"{name} {shown(value, 'rad')}" for name, value in wished.items())
    return DescriptionError(
        "the published adjustment range does not reach this",
        where=", ".join(wished),
        found=found,
        allowed=f"about {' and '.join(texts)}, each by itself (arms up to 20 mm longer, tie rod 20 mm to either side)",
        hint="Use wedges (camber_wedge, toe_wedge) for the rest.",
    )


def _effect(rig: DoubleWishbone, setting: Setting, findings: list[Finding]) -> Effect:
    """Take a setting over its range; notes where the linkage does not go together are added to ``findings``."""
    base, (lowest, highest) = setting.base(rig), setting.range_for(rig)

    def at(value: float) -> WheelState | None:
        try:
            return wheel_state(adjusted(rig, {setting.name: value}))
        except JounceError as error:
            text = f"{shown(value, setting.unit)} is out of reach: {error}"
            findings.append(Finding(setting.name, "note", text, value))
            return None

    step = _STEP * (highest - lowest)
    one, other = (float(np.clip(base + sign * step, lowest, highest)) for sign in (-1.0, 1.0))
    if setting.name == "short_upper_arm":  # the block comes with any short arm: compare two of them
        one, other = highest - 2.0 * step, highest - step
    per_unit = _slopes(at(one), at(other), other - one)
    return Effect(setting.name, setting.unit, lowest, base, highest, at(lowest), at(highest), per_unit)


def _slopes(one: WheelState | None, other: WheelState | None, step: float) -> dict[str, float | None]:
    """Change of every quantity for one unit of a setting."""
    found: dict[str, float | None] = {}
    for name in QUANTITIES:
        first, second = getattr(one, name, None), getattr(other, name, None)
        found[name] = None if first is None or second is None or step == 0.0 else float(second - first) / step
    return found
