"""What each adjustment does to the wheel, and the lengths that reach a wished camber and toe."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from jounce.core.errors import DescriptionError, JounceError
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.design.adjustments import SETTINGS, Setting, Value, adjusted, adjustment_findings, read_settings, shown
from jounce.kinematics import sweep_travel
from jounce.parts import DoubleWishbone, Rig
from jounce.simulation import equilibrium

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
class AdjustReport:
    """What adjustments do to a rig.

    Attributes
    ----------
    settings : dict
        Settings that were made, SI.
    before, after : WheelState
        Wheel of the rig as given, and with the settings.
    rig : DoubleWishbone
        The rig with the settings.
    effects : tuple of Effect
        What each setting would do to the rig as given.
    findings : tuple of Finding
        What the reader must know.
    """

    settings: dict[str, float]
    before: WheelState
    after: WheelState
    rig: DoubleWishbone
    effects: tuple[Effect, ...]
    findings: tuple[Finding, ...] = field(default_factory=tuple)


@dataclass(frozen=True)
class Lengths:
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
    """Say what settings do to a rig, and what each setting could do.

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
    for setting in SETTINGS.values() if effects else ():
        try:
            found.append(_effect(rig, setting, findings))
        except JounceError as error:
            findings.append(Finding(setting.name, "note", f"is not available: {error}"))
    after = wheel_state(changed) if values else before
    return AdjustReport(values, before, after, changed, tuple(found), tuple(findings))


def lengths_for(rig: Rig, camber: Value | None = None, toe: Value | None = None) -> Lengths:
    """Find the lengths of arms and tie rod that reach a wished camber and toe.

    One arm is lengthened, the upper one for more camber, the lower one for less, and the tie rod sets the toe. Without
    a wished toe the tie rod is left alone, and the toe comes out as it does; without a wished camber the arms are.

    Parameters
    ----------
    rig : Rig
        A double wishbone; it is not changed.
    camber : str or float, optional
        Wished static camber, text with a unit or rad, top outward positive.
    toe : str or float, optional
        Wished static toe, text with a unit or rad, toe-in positive.

    Returns
    -------
    Lengths
        Changes of length in m, and the camber and toe that they give, rad.

    Raises
    ------
    DescriptionError
        When nothing is wished, or when it is out of what the published lengths reach.

    Examples
    --------
    >>> import jounce as jn
    >>> found = lengths_for(jn.load("kart-double-wishbone"), camber="-2 deg", toe="0.5 deg")
    >>> round(1e3 * found.lower_arm_length, 2), found.upper_arm_length   # mm
    (7.68, 0.0)
    """
    if camber is None and toe is None:
        raise DescriptionError("nothing is wished", where="lengths_for", allowed="camber, toe, or both")
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
        "the published lengths do not reach this",
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
