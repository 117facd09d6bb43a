"""The adjustments of the double-wishbone prototype: named settings with the range that its paper gives.

Arms are lengthened at turnbuckles, which moves the ball joint away from the arm's inner axis; the upright goes along as
a rigid body until both arms, the tie rod and the height of the wheel centre agree again. That pose is the new design.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import cast

import casadi as ca
import numpy as np

from jounce.core.errors import AssemblyError, DescriptionError, unknown
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.design.poses import moved_rig, rigid_motion
from jounce.mechanics import Mechanism, Model, assemble
from jounce.parts import DoubleWishbone, Rig
from jounce.parts.bodies import Triple, distance
from jounce.parts.leverage import static_spring_force
from jounce.parts.variants import LARGEST, strut_angle, strut_angle_findings, with_strut_angle

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
    """One adjustment.

    Attributes
    ----------
    name : str
        As in ``adjusted`` and ``jounce adjust --set``.
    unit : str
        SI unit of its value.
    lowest, highest : float
        Range, SI; of the prototype where it depends on the rig.
    text : str
        What it is.
    source : str
        Where the range comes from: the paper, or an estimate.
    base : callable
        Value that a rig has as it is.
    ends : callable or None
        Range for a rig, where it depends on it.
    """

    name: str
    unit: str
    lowest: float
    highest: float
    text: str
    source: str
    base: Callable[[DoubleWishbone], float] = field(default_factory=lambda: _unchanged)
    ends: Callable[[DoubleWishbone], tuple[float, float]] | None = None

    def range_for(self, rig: DoubleWishbone) -> tuple[float, float]:
        """Lowest and highest value for a rig, SI."""
        return (self.lowest, self.highest) if self.ends is None else self.ends(rig)


def _unchanged(_rig: DoubleWishbone) -> float:
    """Value that a change has in a rig as it is."""
    return 0.0


def _preload(rig: DoubleWishbone) -> float:
    """Spring force at design length, N."""
    spring = rig.strut.spring
    if spring.free_length is None:
        return spring.preload or 0.0
    if spring.rate is None:
        raise DescriptionError(
            "a curved spring has no single preload", where="strut.spring", hint="Set its free_length."
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
    """Check settings; give their values in SI.

    Parameters
    ----------
    rig : Rig
        The double wishbone that they are for.
    settings : dict
        Name to value, text with a unit or SI.

    Raises
    ------
    DescriptionError
        For another rig, an unknown setting, or a value out of its range. A strut angle only has to be possible.
    """
    corner = _double_wishbone(rig)
    found = {}
    for name, given in settings.items():
        if name not in SETTINGS:
            raise unknown(name, SETTINGS, what="setting", where="adjust")
        setting = SETTINGS[name]
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
    """What a careful colleague would say of settings (SI): angles that were not built or are too steep."""
    if "strut_angle" not in values:
        return []
    angle = values["strut_angle"]
    steep = strut_angle_findings(angle, "strut_angle")
    if steep or any(abs(np.degrees(angle) - known) < 0.05 for known in PUBLISHED_ANGLES):
        return steep
    built = ", ".join(f"{known:g}" for known in PUBLISHED_ANGLES)
    text = f"{np.degrees(angle):.4g} deg is none of the angles that were built ({built} deg)."
    return [Finding("strut_angle", "note", text, float(angle))]


def adjusted(rig: Rig, settings: Mapping[str, Value]) -> DoubleWishbone:
    """Give the rig with some adjustments made.

    Parameters
    ----------
    rig : Rig
        A double wishbone without a rocker; it is not changed.
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
            "these adjustments are those of a double wishbone",
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
    geometry = [name for name in values if name.endswith(("_length", "_support")) or name == "short_upper_arm"]
    if not any(values[name] != SETTINGS[name].base(rig) for name in geometry):
        return rig
    if rig.hardpoints.rocker_pivot is not None:
        raise DescriptionError(
            "the linkage of a rig with a rocker cannot be adjusted here",
            where=geometry[0],
            hint="Change its hardpoints.",
        )
    before = rig.hardpoints.given()
    inner, lengths = _supports_and_lengths(rig, values)
    places: dict[str, Triple] = {**before, **inner}
    places |= _upright_places(places, lengths)
    for arm in ("lower_arm", "upper_arm"):
        places |= _carried(rig, arm, before, places)
    turn, shift = rigid_motion(np.array([before[n] for n in _UPRIGHT]), np.array([places[n] for n in _UPRIGHT]))
    places |= {name: _triple(turn @ np.array(before[name]) + shift) for name in _on(rig, "upright")}
    return moved_rig(rig, places)


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
    places = [upright.point(points[name]).value for name in _UPRIGHT]
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
            "arms, upright and tie rod do not go together with these settings",
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
