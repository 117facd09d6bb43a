"""Adjustments of a suspension: settings with their ranges, and the adjusted rig."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TypeVar, cast

import numpy as np

from jounce.core.errors import DescriptionError, unknown
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kinematics.moved_rigs import spin_axis
from jounce.kinematics.refitting import Changes, has_rocker, refit, rod_lengths, rods, triple
from jounce.parts import Corner, DoubleWishbone, McPherson, Rig
from jounce.parts.leverage import static_spring_force
from jounce.parts.variants import LARGEST, strut_angle, with_strut_angle

Value = str | float
PUBLISHED_ANGLES = (10.0, 16.0, 21.0, 26.0)
"""Strut angles of the prototype, degrees."""
BLOCK_MASS = 2.6
"""Mass of the block that carries a short upper arm, kg."""
C = TypeVar("C", bound=Corner)
ROUNDING = 1e-12
"""Tolerance on ranges given in degrees or millimetres, SI."""


@dataclass(frozen=True)
class Adjustable:
    """An adjustment: range in the SI ``unit``, description, and source of the range.

    ``base`` returns the present value of a rig; ``ends`` the range if it depends on the rig; ``fits`` whether a rig has
    the adjustable part.
    """

    name: str
    unit: str
    lowest: float
    highest: float
    text: str
    source: str
    base: Callable[[Corner], float] = field(default_factory=lambda: _zero)
    ends: Callable[[Corner], tuple[float, float]] | None = None
    fits: Callable[[Corner], bool] = field(default_factory=lambda: _always)

    def range_for(self, rig: Corner) -> tuple[float, float]:
        """Lowest and highest value for a rig, SI."""
        return (self.lowest, self.highest) if self.ends is None else self.ends(rig)

    def allowed_for(self, rig: Corner) -> tuple[float, float]:
        """Lowest and highest value that a rig accepts, SI: a strut angle only has to be possible."""
        return (-LARGEST, LARGEST) if self.name == "strut_angle" else self.range_for(rig)


def _zero(_rig: Corner) -> float:
    """Base value of a change: zero in the rig as described."""
    return 0.0


def _always(_rig: Corner) -> bool:
    return True


def _has(point: str) -> Callable[[Corner], bool]:
    """Return a predicate for rigs that have a hardpoint."""
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
            "a spring curve has no single preload",
            where="strut.spring",
            hint="Set the free_length of the spring.",
        )
    return spring.rate * (spring.free_length - rig.hardpoints.length("spring"))


def arm_length(rig: Corner, arm: str) -> float:
    """Length of the ``"lower"`` or ``"upper"`` arm: distance of its ball joint from its inner axis, m."""
    front, rear, ball = _arm(rig, arm)
    _, along, _ = _foot(front, rear, ball)
    return float(np.linalg.norm(along))


def _preloads(rig: Corner) -> tuple[float, float]:
    """Return the range of preload: from zero to twice the static spring force, N."""
    return 0.0, 2.0 * static_spring_force(rig)


def _short_arms(rig: Corner) -> tuple[float, float]:
    """Return the range of a short arm: from half of the upper arm's length to its full length, m."""
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
                f"link_{i}_length",
                "m",
                -0.010,
                0.010,
                f"lengthening of link {i}",
                _SHIMS,
                fits=_has("link_1_inner"),
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
            fits=lambda rig: bool(_shim_joints(rig)),
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
        Adjustable(
            "pushrod_length",
            "m",
            -0.010,
            0.010,
            "lengthening of the push rod",
            _SHIMS,
            fits=has_rocker,
        ),
        Adjustable(
            "camber_wedge",
            "rad",
            -_FIVE,
            _FIVE,
            "tilt of the wheel on the upright, top outward",
            _ESTIMATED,
        ),
        Adjustable(
            "toe_wedge", "rad", -_TOE, _TOE, "turn of the wheel on the upright, toe-in", _ESTIMATED
        ),
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
    """Check settings against the rig's ranges; return their values in SI."""
    corner = corner_of(rig)
    values = {}
    for name, given in settings.items():
        if name not in SETTINGS:
            raise unknown(name, SETTINGS, what="setting", where="adjust")
        setting = SETTINGS[name]
        if not setting.fits(corner):
            allowed = ", ".join(adjustables(corner))
            raise DescriptionError(
                "the rig does not have this adjustment", where=name, allowed=allowed
            )
        value = to_si(given, setting.unit, where=name)
        low, high = setting.allowed_for(corner)
        if not low - ROUNDING <= value <= high + ROUNDING:
            raise DescriptionError(
                "out of range",
                where=name,
                found=given,
                allowed=Phrase(
                    "{write_setting} to {second_write_setting} ({source})",
                    write_setting=write_setting(low, setting.unit),
                    second_write_setting=write_setting(high, setting.unit),
                    source=setting.source,
                ),
            )
        values[name] = value
    return values


def adjustables(rig: Rig) -> dict[str, Adjustable]:
    """Return the adjustments of a rig by name; empty without hardpoints."""
    return (
        {item.name: item for item in SETTINGS.values() if item.fits(rig)}
        if isinstance(rig, Corner)
        else {}
    )


def write_setting(value: float, unit: str) -> str:
    """Write a value in its usual unit: mm, deg."""
    factor, name = {"m": (1e3, "mm"), "rad": (180.0 / np.pi, "deg")}.get(unit, (1.0, unit))
    return f"{value * factor:.4g} {name}"


def apply_adjustments(rig: Rig, settings: Mapping[str, Value]) -> Corner:
    """Return the rig with some adjustments applied.

    Parameters
    ----------
    rig : Rig
        A rig with hardpoints; it is not changed.
    settings : dict
        Setting to value, text with a unit or SI; see ``SETTINGS``. Lengths and supports of arms are changes.

    Returns
    -------
    Corner
        Rig with the newly assembled pose as its design. The wheel centre keeps its height, the upright moves as a rigid
        body, and arms (with the lower end of the strut) rotate about their inner axes; camber and toe are those of the
        moved upright. The spring keeps its free length; torsion bar and third spring are unchanged; push rod and link
        of the anti-roll bar keep their lengths; a Z-bar is set without torque. A preload of the spring is set last.

    Raises
    ------
    DescriptionError
        For a rig without hardpoints, a setting that it does not have, or a value out of its range.
    AssemblyError
        If the linkage cannot be assembled.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> rig = apply_adjustments(jn.load("kart-double-wishbone"), {"upper_arm_length": "20 mm"})
    >>> round(float(np.degrees(rig.wheel.camber)), 1)   # the paper gives 5 deg
    5.2
    """
    corner, values = corner_of(rig), read_settings(rig, settings)
    corner = _change_linkage(corner, values)
    wedges = {
        f"wheel.{name}": getattr(corner.wheel, name) + values[f"{name}_wedge"]
        for name in ("camber", "toe")
        if f"{name}_wedge" in values
    }
    corner = corner.with_changes(wedges) if wedges else corner
    if "short_upper_arm" in values and corner.sprung is not None:
        corner = corner.with_changes({"sprung.mass": corner.sprung.mass + BLOCK_MASS})
    corner = with_strut_angle(corner, values["strut_angle"]) if "strut_angle" in values else corner
    return _set_preload(corner, values["spring_preload"]) if "spring_preload" in values else corner


def corner_of(rig: Rig) -> Corner:
    """Return the rig as a corner; raise an error without hardpoints."""
    if not isinstance(rig, Corner):
        raise DescriptionError(
            "only a corner with hardpoints can be adjusted",
            where="rig",
            found=f'model = "{getattr(rig, "model", "")}"',
            allowed="double-wishbone, mcpherson, five-link, trailing-arm; such as kart-double-wishbone of the library",
        )
    return rig


def _set_preload(rig: C, force: float) -> C:
    """Adjust the spring seat to give the force ``force`` (N) at design length."""
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
    """Return the foot of the ball joint on the arm's axis, the vector from there to the ball joint, and the axis."""
    axis = (front - rear) / np.linalg.norm(front - rear)
    foot = front + axis * ((ball - front) @ axis)
    return foot, ball - foot, axis


def _change_linkage(rig: C, values: Mapping[str, float]) -> C:
    """Apply the changes of the linkage, if any."""
    geometry = [
        name for name in values if name.endswith(("_length", "_support")) or name in _OTHER_GEOMETRY
    ]
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
        tops = {
            f"{element}_top" for element in ("strut", "spring", "damper")
        } & rig.hardpoints.given().keys()
        inner |= {name: getattr(rig.hardpoints, name) + outward for name in tops}
    shims = (
        {name: -values["camber_shim"] * spin_axis(rig) for name in _shim_joints(rig)}
        if "camber_shim" in values
        else {}
    )
    changes = Changes(
        {k: triple(v) for k, v in inner.items()}, lengths, shims, values.get("pushrod_length", 0.0)
    )
    return refit(rig, changes)


def _arms(rig: Corner) -> list[str]:
    """Return the arms hinged on an axis: ``"lower"`` and ``"upper"``, if the suspension has them."""
    return [arm for arm in ("lower", "upper") if hasattr(rig.hardpoints, f"{arm}_arm_front")]


def _shim_joints(rig: Corner) -> list[str]:
    """Return the joints of the upright above the wheel centre, except the tie rod's, where shims change camber."""
    height, points = rig.hardpoints.wheel_centre[2], rig.hardpoints.given()
    joints = [name for name in dict.fromkeys(rods(rig).values()) if name not in _TIE_RODS]
    above = [name for name in joints if points[name][2] > height]
    return above if 0 < len(above) < len(joints) else []


_TIE_RODS = ("tie_rod_outer", "link_5_outer")
_OTHER_GEOMETRY = ("short_upper_arm", "camber_shim", "camber_plate")
