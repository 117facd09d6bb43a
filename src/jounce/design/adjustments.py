"""Effects of suspension adjustments on wheel alignment, and lengths for a required camber and toe."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from jounce.core.errors import DescriptionError, JounceError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kinematics import sweep_travel
from jounce.kinematics.adjustments import (
    PUBLISHED_ANGLES,
    SETTINGS,
    Adjustable,
    Value,
    apply_adjustments,
    corner_of,
    read_settings,
    write_setting,
)
from jounce.kinematics.model import kinematic_model
from jounce.kinematics.refitting import rods
from jounce.parts import Corner, DoubleWishbone, FiveLink, McPherson, Rig
from jounce.parts.variants import strut_angle_findings
from jounce.simulation import equilibrium


def adjustment_findings(values: Mapping[str, float]) -> list[Finding]:
    """Report doubtful settings (SI): angles that the prototype did not offer or that are too steep."""
    if "strut_angle" not in values:
        return []
    angle = values["strut_angle"]
    steep = strut_angle_findings(angle, "strut_angle")
    # 0.05 deg: an angle rounded to tenths still counts as the published one.
    if steep or any(abs(np.degrees(angle) - known) < 0.05 for known in PUBLISHED_ANGLES):
        return steep
    built = ", ".join(f"{known:g}" for known in PUBLISHED_ANGLES)
    return [finding("design.angle_not_built", "strut_angle", angle, angle=angle, built=built)]


QUANTITIES: Mapping[str, str] = {
    "camber": "rad",
    "toe": "rad",
    "caster": "rad",
    "camber_gain": "rad/m",
    "roll_centre_height": "m",
    "ride_height": "m",
    "wheel_rate": "N/m",
}
"""Reported quantities, with their SI units."""
OVER_TRAVEL: Mapping[str, str] = {
    "camber": "rad",
    "toe": "rad",
    "roll_centre_height": "m",
    "motion_ratio": "1",
    "wheel_rate": "N/m",
}
"""Quantities reported over travel, with their SI units: some settings change the wheel only away from design."""
_TRAVELS = (-0.03, -0.015, 0.0, 0.015, 0.03)  # m: a choice, five rows of a table
_STEP = 1e-3
"""Share of a setting's range used as the step for its effect per unit."""
_CLOSE = 1e-10  # rad: far below the accuracy of wheel alignment, and above rounding of an assembled linkage
_NUDGE = 1e-6  # m: step of differences; lengths of 0.3 m are rounded to 1e-16 m, and are curved over centimetres
_ROUNDS = 30  # of Newton's method, at most; convergence takes only a few


@dataclass(frozen=True)
class WheelState:
    """Wheel alignment, SI: angles and roll centre at design height, ride height and wheel rate at rest.

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
        N/m, with its preload term; None without a spring.
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
    """Effect of one setting.

    Attributes
    ----------
    setting : str
        Its name.
    unit : str
        SI unit of its value.
    lowest, base, highest : float
        Ends of its range and the rig's own value, SI.
    at_lowest, at_highest : WheelState or None
        Wheel at the ends of the range; None if the linkage cannot be assembled there.
    per_unit : dict
        Quantity to its change per SI unit of the setting, at the rig's own value; None if undefined.
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
    """Quantities (SI) over wheel travel (m, bump positive), NaN out of reach of the linkage."""

    travel: tuple[float, ...]
    before: dict[str, tuple[float, ...]]
    after: dict[str, tuple[float, ...]]


@dataclass(frozen=True)
class AdjustReport(Shown):
    """Effect of adjustments on a rig: the settings (SI), the wheel before and after, and the adjusted rig.

    ``effects`` has the effect of each possible setting on the given rig, ``over_travel`` the effect of the chosen
    settings away from design.
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
    """Changes of length for a required camber and toe, m, and the resulting angles, rad.

    ``others`` has the changes of parts that a double wishbone does not have: a strut's top mount, links.
    """

    lower_arm_length: float
    upper_arm_length: float
    tie_rod_length: float
    camber: float
    toe: float
    others: Mapping[str, float] = field(default_factory=dict)

    def settings(self) -> dict[str, float]:
        """Settings that are not zero, in the form that ``adjusted`` accepts."""
        lengths = {name: getattr(self, name) for name in _LENGTHS} | dict(self.others)
        return {name: value for name, value in lengths.items() if value != 0.0}


def wheel_state(rig: Corner) -> WheelState:
    """Return the wheel alignment of a corner."""
    if rig.guide == "fixed":
        ride, travel = None, 0.0
    else:
        rest = equilibrium(rig)
        ride, travel = rest["sprung.z"], rest["unsprung.z"] - rest["sprung.z"]
    points = sorted({0.0, travel})
    sweep = sweep_travel(rig, points)
    design, at_rest = (sweep.isel(wheel_travel=points.index(value)) for value in (0.0, travel))
    camber, toe, gain, centre = (
        float(design[name]) for name in ("camber", "toe", "camber_gain", "roll_centre_height")
    )
    caster = float(design["caster"]) if "caster" in design else None
    rate = float(at_rest["wheel_rate"]) if "wheel_rate" in at_rest else None
    return WheelState(camber, toe, caster, gain, centre, ride, rate)


def adjust_report(
    rig: Rig, settings: Mapping[str, Value] | None = None, *, effects: bool = True
) -> AdjustReport:
    """Report the effect of settings on a rig, and of each possible setting.

    Parameters
    ----------
    rig : Rig
        A rig with hardpoints; it is not changed.
    settings : dict, optional
        Settings to make: name to value, text with a unit or SI.
    effects : bool
        Whether to vary every possible setting over its range as well.

    Returns
    -------
    AdjustReport

    Raises
    ------
    DescriptionError
        For a rig without hardpoints, a setting that it does not have, or a value out of range.
    AssemblyError
        If the linkage cannot be assembled with the settings.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> report = adjust_report(jn.load("kart-double-wishbone"), {"tie_rod_length": "20 mm"}, effects=False)
    >>> round(float(np.degrees(report.after.toe)), 1)   # the paper gives 10.5 deg
    10.7
    """
    values = read_settings(rig, settings or {})
    changed, rig = apply_adjustments(rig, values), corner_of(rig)
    before = wheel_state(rig)
    findings = adjustment_findings(values)
    effects_by_setting: list[Effect] = []
    for setting in (item for item in SETTINGS.values() if effects and item.fits(rig)):
        try:
            effects_by_setting.append(_effect(rig, setting, findings))
        except JounceError as error:
            findings.append(finding("design.not_available", setting.name, error=error))
    after = wheel_state(changed) if values else before
    first = _over_travel(rig)
    over = OverTravel(_TRAVELS, first, _over_travel(changed) if values else first)
    return AdjustReport(
        values, before, after, changed, tuple(effects_by_setting), over, tuple(findings)
    )


def _over_travel(rig: Corner) -> dict[str, tuple[float, ...]]:
    """Return the quantities of the rig over travel, as far as the linkage reaches."""
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
    """Find the lengths of arms, links and tie rod for a required camber and toe.

    For a double wishbone, one arm is lengthened: the upper one for more camber, the lower one for less. For a McPherson
    strut the top mount is moved; for five links, the link with the largest effect on camber is adjusted. The tie rod or
    toe link sets the toe. Without a required toe, the tie rod is not adjusted and the toe follows from the camber
    adjustment; without a required camber, only the tie rod is adjusted.

    Parameters
    ----------
    rig : Rig
        A double wishbone, McPherson strut or five-link corner; it is not changed.
    camber : str or float, optional
        Required static camber, text with a unit or rad, top outward positive.
    toe : str or float, optional
        Required static toe, text with a unit or rad, toe-in positive.

    Returns
    -------
    Lengths
        Changes of length in m, and the resulting camber and toe, rad.

    Raises
    ------
    DescriptionError
        If no target is given, for a trailing arm, whose arm carries the wheel directly, or if the lengths cannot reach
        the target.

    Examples
    --------
    >>> import jounce as jn
    >>> found = lengths_for(jn.load("kart-double-wishbone"), camber="-2 deg", toe="0.5 deg")
    >>> round(1e3 * found.lower_arm_length, 2), found.upper_arm_length   # mm
    (7.68, 0.0)
    """
    if camber is None and toe is None:
        raise DescriptionError(
            "no target is given", where="lengths_for", allowed="camber, toe, or both"
        )
    corner = corner_of(rig)
    if not rods(corner):
        raise DescriptionError(
            "none of its lengths sets camber or toe",
            where="rig",
            found=f'model = "{getattr(rig, "model", "")}"',
            allowed="double-wishbone, mcpherson, five-link",
            hint="Use wedges (camber_wedge, toe_wedge).",
        )
    wished = {
        name: to_si(value, "rad", where=name)
        for name, value in (("camber", camber), ("toe", toe))
        if value is not None
    }
    camber_lengths, toe_length = (
        _camber_lengths(corner, wished.get("camber")),
        _TOE_LENGTHS[type(corner)],
    )
    # The tie rod also changes the camber slightly: all lengths are tried if a camber is required.
    for camber_length in camber_lengths if camber is not None else camber_lengths[:1]:
        names = [{"camber": camber_length, "toe": toe_length}[name] for name in wished]
        lengths = _solve(corner, wished, names)
        if lengths is not None:
            break
    else:
        raise _unreachable(corner, wished, {"camber": camber_lengths, "toe": [toe_length]})
    wheel = apply_adjustments(corner, lengths).wheel
    every = {name: lengths.pop(name, 0.0) for name in _LENGTHS}
    return Lengths(**every, camber=wheel.camber, toe=wheel.toe, others=lengths)


_TOE_LENGTHS: Mapping[type[Corner], str] = {
    DoubleWishbone: "tie_rod_length",
    McPherson: "tie_rod_length",
    FiveLink: "link_5_length",
}
_PROBE = 1e-4  # m: only used to sort the lengths by their effect


def _camber_lengths(rig: Corner, camber: float | None) -> list[str]:
    """Return the lengths that set the camber, in the order in which they are tried."""
    if isinstance(rig, McPherson):
        return ["camber_plate"]
    if isinstance(rig, DoubleWishbone):
        arms = ["lower_arm_length", "upper_arm_length"]
        return arms[::-1] if camber is None or camber >= rig.wheel.camber else arms
    tilts = {}
    for name in (f"link_{i}_length" for i in range(1, 5)):
        ends = [apply_adjustments(rig, {name: length}).wheel.camber for length in (-_PROBE, _PROBE)]
        tilts[name] = abs(ends[1] - ends[0])
    return sorted(tilts, key=lambda name: -tilts[name])


def _solve(rig: Corner, wished: Mapping[str, float], names: list[str]) -> dict[str, float] | None:
    """Solve for lengths by Newton's method; None if it ends at a bound or the linkage cannot be assembled."""
    low, high = (
        np.array([getattr(SETTINGS[name], end) for name in names]) for end in ("lowest", "highest")
    )
    target = np.array(list(wished.values()))

    def miss(lengths: Array) -> Array:
        wheel = apply_adjustments(rig, _by_name(names, lengths)).wheel
        return np.asarray([getattr(wheel, name) for name in wished] - target, dtype=float)

    lengths = np.clip(np.zeros(len(names)), low, high)
    for _ in range(_ROUNDS):
        try:
            missed = miss(lengths)
            if np.max(np.abs(missed)) < _CLOSE:
                return _by_name(names, lengths)
            inward = np.where(lengths + _NUDGE > high, -_NUDGE, _NUDGE)
            columns = [(miss(lengths + step) - missed) / step.sum() for step in np.diag(inward)]
            lengths = np.clip(
                lengths - np.linalg.solve(np.column_stack(columns), missed), low, high
            )
        except (JounceError, np.linalg.LinAlgError):
            return None
    return None


def _by_name(names: list[str], lengths: Array) -> dict[str, float]:
    return {name: float(value) for name, value in zip(names, lengths, strict=True)}


def _unreachable(
    rig: Corner, wished: Mapping[str, float], candidates: Mapping[str, list[str]]
) -> DescriptionError:
    """Return the error that states the reachable angles."""
    texts, used = [], list[str]()
    for name in wished:
        ends = []
        for setting in candidates[name]:
            for end in (SETTINGS[setting].lowest, SETTINGS[setting].highest):
                try:
                    ends.append(float(getattr(apply_adjustments(rig, {setting: end}).wheel, name)))
                except JounceError:
                    continue
            low, high = SETTINGS[setting].lowest, SETTINGS[setting].highest
            used.append(f"{setting} {write_setting(low, 'm')} to {write_setting(high, 'm')}")
        texts.append(
            f"{name} from {write_setting(min(ends), 'rad')} to {write_setting(max(ends), 'rad')}"
            if ends
            else f"no {name}"
        )
    wishes = ", ".join(f"{name} {write_setting(value, 'rad')}" for name, value in wished.items())
    return DescriptionError(
        "the published adjustment range does not reach this"
        if isinstance(rig, DoubleWishbone)
        else "the adjustable lengths do not reach this",
        where=", ".join(wished),
        found=wishes,
        allowed=Phrase(
            "about {texts}, each taken alone ({used})",
            texts=" and ".join(texts),
            used=", ".join(used),
        ),
        hint="Use wedges (camber_wedge, toe_wedge) for the rest.",
    )


def _effect(rig: Corner, setting: Adjustable, findings: list[Finding]) -> Effect:
    """Vary a setting over its range; add a finding to ``findings`` where the linkage cannot be assembled."""
    base, (lowest, highest) = setting.base(rig), setting.range_for(rig)

    def at(value: float) -> WheelState | None:
        try:
            return wheel_state(apply_adjustments(rig, {setting.name: value}))
        except JounceError as error:
            findings.append(
                finding(
                    "design.out_of_reach",
                    setting.name,
                    value,
                    wanted=write_setting(value, setting.unit),
                    error=error,
                )
            )
            return None

    step = _STEP * (highest - lowest)
    low, high = (float(np.clip(base + sign * step, lowest, highest)) for sign in (-1.0, 1.0))
    if (
        setting.name == "short_upper_arm"
    ):  # any short arm includes the block: compare two short arms
        low, high = highest - 2.0 * step, highest - step
    per_unit = _slopes(at(low), at(high), high - low)
    return Effect(
        setting.name, setting.unit, lowest, base, highest, at(lowest), at(highest), per_unit
    )


def _slopes(
    low: WheelState | None, high: WheelState | None, step: float
) -> dict[str, float | None]:
    """Return the change of every quantity per unit of a setting."""
    slopes: dict[str, float | None] = {}
    for name in QUANTITIES:
        first, second = getattr(low, name, None), getattr(high, name, None)
        slopes[name] = (
            None if first is None or second is None or step == 0.0 else float(second - first) / step
        )
    return slopes
