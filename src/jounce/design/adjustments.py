"""Adjustments of a suspension: what can be set, its effect on the wheel, lengths for a wanted camber and toe."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TypeVar, cast

import numpy as np

from jounce.core.errors import DescriptionError, JounceError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.design.poses import spin_axis
from jounce.design.refitting import Changes, has_rocker, refit, rod_lengths, rods, triple
from jounce.kinematics import sweep_travel
from jounce.kinematics.model import kinematic_model
from jounce.parts import Corner, DoubleWishbone, FiveLink, McPherson, Rig
from jounce.parts.leverage import static_spring_force
from jounce.parts.variants import LARGEST, strut_angle, strut_angle_findings, with_strut_angle
from jounce.simulation import equilibrium

Value = str | float
PUBLISHED_ANGLES = (10.0, 16.0, 21.0, 26.0)
"""Strut angles of the prototype, degrees."""
BLOCK_MASS = 2.6
"""Mass of the block that carries a short upper arm, kg."""
C = TypeVar("C", bound=Corner)


@dataclass(frozen=True)
class Adjustable:
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
    base: Callable[[Corner], float] = field(default_factory=lambda: _unchanged)
    ends: Callable[[Corner], tuple[float, float]] | None = None
    fits: Callable[[Corner], bool] = field(default_factory=lambda: _always)

    def range_for(self, rig: Corner) -> tuple[float, float]:
        """Lowest and highest value for a rig, SI."""
        return (self.lowest, self.highest) if self.ends is None else self.ends(rig)


def _unchanged(_rig: Corner) -> float:
    """Value that a change has in a rig as it is."""
    return 0.0


def _always(_rig: Corner) -> bool:
    return True


def _has(point: str) -> Callable[[Corner], bool]:
    """Tell of a rig whether it has a hardpoint."""
    return lambda rig: hasattr(rig.hardpoints, point)


def _is_double_wishbone(rig: Corner) -> bool:
    return isinstance(rig, DoubleWishbone)


def _has_coil(rig: Corner) -> bool:
    return "spring" not in rig.without


def _preload(rig: Corner) -> float:
    """Spring force at design length, N."""
    spring = rig.strut.spring
    if spring.free_length is None:
        return spring.preload or 0.0
    if spring.rate is None:
        raise DescriptionError(
            "a spring curve has no single preload", where="strut.spring", hint="Set its free_length."
        )
    return spring.rate * (spring.free_length - rig.hardpoints.length("spring"))


def arm_length(rig: Corner, arm: str) -> float:
    """Length of the ``"lower"`` or ``"upper"`` arm: distance of its ball joint from its inner axis, m."""
    front, rear, ball = _arm(rig, arm)
    _, along, _ = _foot(front, rear, ball)
    return float(np.linalg.norm(along))


def _preloads(rig: Corner) -> tuple[float, float]:
    """From no load to twice what the spring carries at rest, N."""
    return 0.0, 2.0 * static_spring_force(rig)


def _short_arms(rig: Corner) -> tuple[float, float]:
    """From half of the upper arm's length to all of it, m."""
    return 0.5 * arm_length(rig, "upper"), arm_length(rig, "upper")


_PAPER = "quarter-car prototype paper, section 4"
_SHIMS = "no published range; estimated"
_ESTIMATED = "the paper gives no range; estimated"
_FIVE, _TOE = float(np.radians(5.0)), float(np.radians(10.5))
_TURNBUCKLE = "lengthening of the {} arm at its turnbuckle"
SETTINGS: dict[str, Adjustable] = {
    item.name: item
    for item in (
        Adjustable(
            "lower_arm_length",
            "m",
            0.0,
            0.020,
            _TURNBUCKLE.format("lower"),
            _PAPER,
            fits=_has("lower_arm_front"),
        ),
        Adjustable(
            "upper_arm_length",
            "m",
            0.0,
            0.020,
            _TURNBUCKLE.format("upper"),
            _PAPER,
            fits=_has("upper_arm_front"),
        ),
        Adjustable(
            "tie_rod_length",
            "m",
            -0.020,
            0.020,
            "lengthening of the tie rod",
            f"toe of 10.5 deg: {_PAPER}",
            fits=_has("tie_rod_inner"),
        ),
        *(
            Adjustable(
                f"link_{i}_length", "m", -0.010, 0.010, f"lengthening of link {i}", _SHIMS, fits=_has("link_1_inner")
            )
            for i in range(1, 6)
        ),
        *(
            Adjustable(
                f"{arm}_arm_support",
                "m",
                -0.030,
                0.030,
                f"rise of the {arm} arm's inner supports",
                _ESTIMATED,
                fits=_has(f"{arm}_arm_front"),
            )
            for arm in ("lower", "upper")
        ),
        Adjustable(
            "strut_angle",
            "rad",
            float(np.radians(PUBLISHED_ANGLES[0])),
            float(np.radians(PUBLISHED_ANGLES[-1])),
            "angle of the strut to the vertical, top inboard",
            f"10, 16, 21, 26 deg: {_PAPER}",
            strut_angle,
            fits=_is_double_wishbone,
        ),
        Adjustable(
            "spring_preload",
            "N",
            0.0,
            361.7,
            "spring force at design length",
            _ESTIMATED,
            _preload,
            ends=_preloads,
            fits=_has_coil,
        ),
        Adjustable(
            "camber_shim",
            "m",
            -0.010,
            0.010,
            "shims between the upright and its joints above the wheel centre, wheel outward",
            _SHIMS,
            fits=lambda rig: bool(_shimmed(rig)),
        ),
        Adjustable(
            "camber_plate",
            "m",
            -0.020,
            0.020,
            "move of the strut's top mount outward",
            _SHIMS,
            fits=lambda rig: isinstance(rig, McPherson),
        ),
        Adjustable("pushrod_length", "m", -0.010, 0.010, "lengthening of the push rod", _SHIMS, fits=has_rocker),
        Adjustable("camber_wedge", "rad", -_FIVE, _FIVE, "tilt of the wheel on the upright, top outward", _ESTIMATED),
        Adjustable("toe_wedge", "rad", -_TOE, _TOE, "turn of the wheel on the upright, toe-in", _ESTIMATED),
        Adjustable(
            "short_upper_arm",
            "m",
            0.1125,
            0.225,
            "length of a short upper arm, its inner supports on a block of 2.6 kg",
            f"block: {_PAPER}; lengths estimated",
            lambda rig: arm_length(rig, "upper"),
            ends=_short_arms,
            fits=_is_double_wishbone,
        ),
    )
}


def read_settings(rig: Rig, settings: Mapping[str, Value]) -> dict[str, float]:
    """Check settings (a strut angle only has to be possible, all else lies in its range); give their values in SI."""
    corner = _corner(rig)
    found = {}
    for name, given in settings.items():
        if name not in SETTINGS:
            raise unknown(name, SETTINGS, what="setting", where="adjust")
        setting = SETTINGS[name]
        if not setting.fits(corner):
            allowed = ", ".join(item.name for item in SETTINGS.values() if item.fits(corner))
            raise DescriptionError("this rig has nothing to set there", where=name, allowed=allowed)
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
    return [finding("design.angle_not_built", "strut_angle", angle, angle=angle, built=built)]


def adjusted(rig: Rig, settings: Mapping[str, Value]) -> Corner:
    """Give the rig with some adjustments made.

    Parameters
    ----------
    rig : Rig
        A rig with hardpoints; it is not changed.
    settings : dict
        Setting to value, text with a unit or SI; see ``SETTINGS``. Lengths and supports of arms are changes.

    Returns
    -------
    Corner
        Its design is the newly assembled pose: the height of the wheel centre is kept, the upright moved as a rigid
        body, arms (with the foot of the strut) turned about their inner axes; camber and toe are those of the moved
        upright. The spring keeps its free length, a torsion bar and a third spring what they are; push rod and link of
        the anti-roll bar keep their lengths; a Z-bar is set without torque. A preload of the spring is set last.

    Raises
    ------
    DescriptionError
        For a rig without hardpoints, a setting that it does not have, or a value out of its range.
    AssemblyError
        When arms, upright and rods do not go together.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> rig = adjusted(jn.load("kart-double-wishbone"), {"upper_arm_length": "20 mm"})
    >>> round(float(np.degrees(rig.wheel.camber)), 1)   # the paper gives 5 deg
    5.2
    """
    corner, values = _corner(rig), read_settings(rig, settings)
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


def _corner(rig: Rig) -> Corner:
    if not isinstance(rig, Corner):
        raise DescriptionError(
            "only a rig with hardpoints is adjusted",
            where="rig",
            found=f'model = "{getattr(rig, "model", "")}"',
            allowed="double-wishbone, mcpherson, five-link, trailing-arm; such as kart-double-wishbone of the library",
        )
    return rig


def _preloaded(rig: C, force: float) -> C:
    """Turn the spring's seat until its force at design length is ``force`` (N)."""
    spring = rig.strut.spring
    if spring.free_length is None:
        return rig.with_changes({"strut.spring.preload": force})
    longer = (force - _preload(rig)) / cast(float, spring.rate)
    return rig.with_changes({"strut.spring.free_length": spring.free_length + longer})


def _arm(rig: Corner, arm: str) -> tuple[Array, Array, Array]:
    """Front and rear support and ball joint of an arm."""
    names = (f"{arm}_arm_front", f"{arm}_arm_rear", f"{arm}_ball_joint")
    front, rear, ball = (np.array(getattr(rig.hardpoints, name)) for name in names)
    return front, rear, ball


def _foot(front: Array, rear: Array, ball: Array) -> tuple[Array, Array, Array]:
    """Foot of the ball joint on the arm's axis, the way from there to the ball joint, direction of the axis."""
    axis = (front - rear) / np.linalg.norm(front - rear)
    foot = front + axis * ((ball - front) @ axis)
    return foot, ball - foot, axis


def _assembled(rig: C, values: Mapping[str, float]) -> C:
    """Make the changes of the linkage, if there are any."""
    geometry = [name for name in values if name.endswith(("_length", "_support")) or name in _OTHER_GEOMETRY]
    if not any(values[name] != SETTINGS[name].base(rig) for name in geometry):
        return rig
    inner: dict[str, Array] = {}
    lengths: dict[str, float] = {}
    for arm in _arms(rig):
        front, rear, ball = _arm(rig, arm)
        foot, along, axis = _foot(front, rear, ball)
        own = float(np.linalg.norm(along))
        reach = own + values.get(f"{arm}_arm_length", 0.0)
        shift = np.array([0.0, 0.0, values.get(f"{arm}_arm_support", 0.0)])
        if arm == "upper" and "short_upper_arm" in values:
            shift = shift + along * (own - values["short_upper_arm"]) / own
            reach -= own - values["short_upper_arm"]
        for name, end in (("front", front), ("rear", rear)):
            inner[f"{arm}_arm_{name}"] = end + shift
            lengths[f"{arm}_arm_{name}"] = float(np.hypot((end - foot) @ axis, reach))
    for name, length in rod_lengths(rig).items():
        link = name.removesuffix("_inner")
        if f"{link}_length" in values:
            lengths[name] = length + values[f"{link}_length"]
    if "camber_plate" in values:
        outward = np.array([0.0, rig.sign * values["camber_plate"], 0.0])
        tops = {f"{element}_top" for element in ("strut", "spring", "damper")} & rig.hardpoints.given().keys()
        inner |= {name: getattr(rig.hardpoints, name) + outward for name in tops}
    shims = {name: -values["camber_shim"] * spin_axis(rig) for name in _shimmed(rig)} if "camber_shim" in values else {}
    changes = Changes({k: triple(v) for k, v in inner.items()}, lengths, shims, values.get("pushrod_length", 0.0))
    return refit(rig, changes)


def _arms(rig: Corner) -> list[str]:
    """Arms that hang on an axis: ``"lower"`` and ``"upper"``, as many as the suspension has."""
    return [arm for arm in ("lower", "upper") if hasattr(rig.hardpoints, f"{arm}_arm_front")]


def _shimmed(rig: Corner) -> list[str]:
    """Joints of the upright above the wheel centre, but for the tie rod's, where shims change the camber."""
    height, points = rig.hardpoints.wheel_centre[2], rig.hardpoints.given()
    joints = [name for name in dict.fromkeys(rods(rig).values()) if name not in _TIE_RODS]
    above = [name for name in joints if points[name][2] > height]
    return above if 0 < len(above) < len(joints) else []


_TIE_RODS = ("tie_rod_outer", "link_5_outer")
_OTHER_GEOMETRY = ("short_upper_arm", "camber_shim", "camber_plate")


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
    camber, toe : float
        rad; top outward and toe-in positive.
    caster : float or None
        rad, top rearward positive; None without a steering axis.
    camber_gain : float
        Change of camber with travel, rad/m, positive where the top goes outward in bump.
    roll_centre_height : float
        Above the ground, m.
    ride_height : float or None
        Rise of the body from design at rest, m; None for a fixed body.
    wheel_rate : float or None
        N/m, with its preload term; None where no spring is described.
    """

    camber: float
    toe: float
    caster: float | None
    camber_gain: float
    roll_centre_height: float
    ride_height: float | None
    wheel_rate: float | None


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
    rig: Corner
    effects: tuple[Effect, ...]
    over_travel: OverTravel
    findings: tuple[Finding, ...] = field(default_factory=tuple)


_LENGTHS = ("lower_arm_length", "upper_arm_length", "tie_rod_length")


@dataclass(frozen=True)
class Lengths(Shown):
    """Lengthenings that reach a camber and a toe, m, and what they reach, rad.

    ``others`` are those of what a double wishbone does not have: a strut's top mount, links.
    """

    lower_arm_length: float
    upper_arm_length: float
    tie_rod_length: float
    camber: float
    toe: float
    others: Mapping[str, float] = field(default_factory=dict)

    def settings(self) -> dict[str, float]:
        """Those that are not zero, as ``adjusted`` takes them."""
        found = {name: getattr(self, name) for name in _LENGTHS} | dict(self.others)
        return {name: value for name, value in found.items() if value != 0.0}


def wheel_state(rig: Corner) -> WheelState:
    """Give how the wheel of a corner stands."""
    if rig.guide == "fixed":
        ride, travel = None, 0.0
    else:
        rest = equilibrium(rig)
        ride, travel = rest["sprung.z"], rest["unsprung.z"] - rest["sprung.z"]
    points = sorted({0.0, travel})
    sweep = sweep_travel(rig, points)
    design, at_rest = (sweep.isel(wheel_travel=points.index(value)) for value in (0.0, travel))
    camber, toe, gain, centre = (float(design[name]) for name in ("camber", "toe", "camber_gain", "roll_centre_height"))
    caster = float(design["caster"]) if "caster" in design else None
    rate = float(at_rest["wheel_rate"]) if "wheel_rate" in at_rest else None
    return WheelState(camber, toe, caster, gain, centre, ride, rate)


def adjust_report(rig: Rig, settings: Mapping[str, Value] | None = None, *, effects: bool = True) -> AdjustReport:
    """Report what settings do to a rig, and what each setting could do.

    Parameters
    ----------
    rig : Rig
        A rig with hardpoints; it is not changed.
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
        For a rig without hardpoints, a setting that it does not have, or a value out of its range.
    AssemblyError
        When arms, upright and rods do not go together with the settings.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> report = adjust_report(jn.load("kart-double-wishbone"), {"tie_rod_length": "20 mm"}, effects=False)
    >>> round(float(np.degrees(report.after.toe)), 1)   # the paper gives 10.5 deg
    10.7
    """
    values = read_settings(rig, settings or {})
    changed, rig = adjusted(rig, values), _corner(rig)
    before = wheel_state(rig)
    findings = adjustment_findings(values)
    found: list[Effect] = []
    for setting in (item for item in SETTINGS.values() if effects and item.fits(rig)):
        try:
            found.append(_effect(rig, setting, findings))
        except JounceError as error:
            findings.append(finding("design.not_available", setting.name, error=error))
    after = wheel_state(changed) if values else before
    first = _over_travel(rig)
    over = OverTravel(_TRAVELS, first, _over_travel(changed) if values else first)
    return AdjustReport(values, before, after, changed, tuple(found), over, tuple(findings))


def _over_travel(rig: Corner) -> dict[str, tuple[float, ...]]:
    """Quantities of the rig at all travels that the linkage reaches."""
    has = {row.name for row in kinematic_model(rig).rows}
    names, rows = [name for name in OVER_TRAVEL if name in has], []
    for travel in _TRAVELS:
        try:
            pose = sweep_travel(rig, [travel]).isel(wheel_travel=0)
        except JounceError:
            rows.append(dict.fromkeys(names, float("nan")))
        else:
            rows.append({name: float(pose[name]) for name in names})
    return {name: tuple(row[name] for row in rows) for name in names}


def lengths_for(rig: Rig, camber: Value | None = None, toe: Value | None = None) -> Lengths:
    """Find the lengths of arms, links and tie rod that give a wanted camber and toe.

    Of a double wishbone one arm is lengthened, the upper one for more camber, the lower one for less; of a McPherson
    strut the top mount is moved; of five links the one is set that tilts the wheel most for its length. Tie rod or toe
    link set the toe. Without a wanted toe they are left alone, and the toe comes out as it does; without a wanted
    camber the others are.

    Parameters
    ----------
    rig : Rig
        A corner whose upright hangs on rods: a double wishbone, a McPherson strut, five links; it is not changed.
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
        When no target is given, for a trailing arm, whose arm carries the wheel itself, or when the target is out of
        what the lengths reach.

    Examples
    --------
    >>> import jounce as jn
    >>> found = lengths_for(jn.load("kart-double-wishbone"), camber="-2 deg", toe="0.5 deg")
    >>> round(1e3 * found.lower_arm_length, 2), found.upper_arm_length   # mm
    (7.68, 0.0)
    """
    if camber is None and toe is None:
        raise DescriptionError("no target is given", where="lengths_for", allowed="camber, toe, or both")
    corner = _corner(rig)
    if not rods(corner):
        raise DescriptionError(
            "no length of it sets camber or toe",
            where="rig",
            found=f'model = "{getattr(rig, "model", "")}"',
            allowed="double-wishbone, mcpherson, five-link",
            hint="Use wedges (camber_wedge, toe_wedge).",
        )
    wished = {
        name: to_si(value, "rad", where=name) for name, value in (("camber", camber), ("toe", toe)) if value is not None
    }
    ways, turning = _cambering(corner, wished.get("camber")), _TOE_LENGTHS[type(corner)]
    for way in ways if camber is not None else ways[:1]:  # the tie rod turns the wheel a little, too
        names = [{"camber": way, "toe": turning}[name] for name in wished]
        lengths = _solve(corner, wished, names)
        if lengths is not None:
            break
    else:
        raise _out_of_reach(corner, wished, {"camber": ways, "toe": [turning]})
    wheel = adjusted(corner, lengths).wheel
    every = {name: lengths.pop(name, 0.0) for name in _LENGTHS}
    return Lengths(**every, camber=wheel.camber, toe=wheel.toe, others=lengths)


_TOE_LENGTHS: Mapping[type[Corner], str] = {
    DoubleWishbone: "tie_rod_length",
    McPherson: "tie_rod_length",
    FiveLink: "link_5_length",
}
_PROBE = 1e-4  # m


def _cambering(rig: Corner, camber: float | None) -> list[str]:
    """Lengths that set the camber, those first that are taken first."""
    if isinstance(rig, McPherson):
        return ["camber_plate"]
    if isinstance(rig, DoubleWishbone):
        arms = ["lower_arm_length", "upper_arm_length"]
        return arms[::-1] if camber is None or camber >= rig.wheel.camber else arms
    tilts = {}
    for name in (f"link_{i}_length" for i in range(1, 5)):
        ends = [adjusted(rig, {name: length}).wheel.camber for length in (-_PROBE, _PROBE)]
        tilts[name] = abs(ends[1] - ends[0])
    return sorted(tilts, key=lambda name: -tilts[name])


def _solve(rig: Corner, wished: Mapping[str, float], names: list[str]) -> dict[str, float] | None:
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


def _out_of_reach(rig: Corner, wished: Mapping[str, float], ways: Mapping[str, list[str]]) -> DescriptionError:
    """Say what the lengths reach."""
    texts, used = [], list[str]()
    for name in wished:
        ends = []
        for way in ways[name]:
            for end in (SETTINGS[way].lowest, SETTINGS[way].highest):
                try:
                    ends.append(float(getattr(adjusted(rig, {way: end}).wheel, name)))
                except JounceError:
                    continue
            used.append(f"{way} {shown(SETTINGS[way].lowest, 'm')} to {shown(SETTINGS[way].highest, 'm')}")
        texts.append(f"{name} from {shown(min(ends), 'rad')} to {shown(max(ends), 'rad')}" if ends else f"no {name}")
    found = ", ".join(f"{name} {shown(value, 'rad')}" for name, value in wished.items())
    return DescriptionError(
        "the published adjustment range does not reach this"
        if isinstance(rig, DoubleWishbone)
        else "the lengths do not reach this",
        where=", ".join(wished),
        found=found,
        allowed=f"about {' and '.join(texts)}, each by itself ({', '.join(used)})",
        hint="Use wedges (camber_wedge, toe_wedge) for the rest.",
    )


def _effect(rig: Corner, setting: Adjustable, findings: list[Finding]) -> Effect:
    """Take a setting over its range; notes where the linkage does not go together are added to ``findings``."""
    base, (lowest, highest) = setting.base(rig), setting.range_for(rig)

    def at(value: float) -> WheelState | None:
        try:
            return wheel_state(adjusted(rig, {setting.name: value}))
        except JounceError as error:
            findings.append(
                finding("design.out_of_reach", setting.name, value, wanted=shown(value, setting.unit), error=error)
            )
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
