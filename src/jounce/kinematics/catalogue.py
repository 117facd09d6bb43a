"""Every quantity of suspension kinematics: one frozen row with name, unit, sign, clause and formula.

Formulas are for a left wheel, x forward, y left, z up. Derivatives are exact, by the vertical travel of the wheel
centre unless a row says otherwise. The ground is the horizontal plane through the contact point.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from jounce.kinematics.view import Axis, CornerView, caster_of
from jounce.parts.corners import Corner


@dataclass(frozen=True)
class Quantity:
    """One quantity of the catalogue.

    Attributes
    ----------
    name : str
        Name of the variable.
    unit : str
        SI unit; "1" for ratios.
    long_name : str
        Label.
    formula : callable
        Expression for a view of the corner.
    sign : str
        Meaning of a positive value.
    clause : str
        Clause of the standard that defines it; empty without one.
    needs : str
        ``"axis"`` (a steering axis), ``"rack"``, ``"strut"`` (its ends), ``"rack strut"`` (both), ``"bar"`` (an
        anti-roll bar), ``"coil"``, ``"torsion"`` (bar), ``"third"`` (spring), ``"third damper"``, ``"damper"``,
        ``"tyre"`` (each described), ``"spring"`` (a coil or a torsion bar), ``"stiffness"`` (a spring, and a tyre whose
        deflection is known), ``"heave"`` (a third spring or a Z-bar), ``"rocker"``, ``"rocker strut"`` (a strut on it);
        empty for every corner.
    """

    name: str
    unit: str
    long_name: str
    formula: Callable[[CornerView], ca.SX]
    sign: str
    clause: str = ""
    needs: str = ""


def _track_of(view: CornerView) -> ca.SX:
    return view.rack.value if view.rack is not None else ca.SX(0.0)


def _ground_lead(view: CornerView) -> ca.SX:
    """From the contact point to the steering axis at the ground: forward and outward, vehicle's axes."""
    return view.steering_axis.leads(view.contact)


def _centre_lead(view: CornerView) -> ca.SX:
    """From the wheel centre to the steering axis at its height: forward and outward, vehicle's axes."""
    return view.steering_axis.leads(view.centre.value)


def _rack_lead(view: CornerView) -> ca.SX:
    return view.held_axis.leads(view.contact)


def _by_wheel(view: CornerView, lead: ca.SX) -> ca.SX:
    """A horizontal vector in the wheel's axes, which are turned by the steer angle: along the wheel and outward."""
    c, s = ca.cos(view.toe_out), ca.sin(view.toe_out)
    return ca.vertcat(c * lead[0] + s * lead[1], c * lead[1] - s * lead[0])


def _inclination_of(axis: Axis) -> ca.SX:
    """Inclination of a line in the front view, top inboard."""
    return ca.atan2(-axis.along[1], axis.along[2])


def _turning(view: CornerView, i: int) -> ca.SX:
    """Rotation of the upright about a horizontal axis, rad/m; zero within rounding, so that its centre is at infinity.

    Parallel links have no instant centre; the rounding of the rotation would place it 1e16 m away.
    """
    return ca.if_else(ca.fabs(view.spin[i]) > _PARALLEL, view.spin[i], 0.0)


def _front_centre(view: CornerView) -> tuple[ca.SX, ca.SX]:
    """Instant centre in the front view: y (of a left wheel) and z."""
    contact, patch, turn = view.contact, view.patch, _turning(view, 0)
    return contact[1] - patch[2] / turn, contact[2] + patch[1] / turn


def _side_centre(view: CornerView) -> tuple[ca.SX, ca.SX]:
    """Instant centre in the side view: x and z."""
    contact, patch, turn = view.contact, view.patch, _turning(view, 1)
    return contact[0] + patch[2] / turn, contact[2] - patch[0] / turn


def _lateral(view: CornerView) -> ca.SX:
    return view.patch[1] / view.patch[2]


def _wheel_force(view: CornerView) -> ca.SX:
    strut = (
        view.springs.force + view.stops.force
    ) * view.motion_ratio + view.still_damper.force * view.damper_ratio
    return strut + _torsion_force(view, ca.SX(1.0))


def _still_damper_rate(view: CornerView, rise: ca.SX, *, preload: bool = True) -> ca.SX:
    """Rate of the damper at rest, for a rise of ``rise`` per unit rise of the wheel centre."""
    still, ratio = view.still_damper, view.damper_ratio / rise
    rate = still.stiffness * ratio**2
    return rate + still.force * view.slope(ratio) / rise if preload else rate


def _torsion_force(view: CornerView, rise: ca.SX) -> ca.SX:
    """Force of the torsion bar, for a rise of ``rise`` per unit rise of the wheel centre."""
    if view.linkage.rig.torsion_bar is None:
        return ca.SX(0.0)
    return view.torsion_torque * view.slope(view.torsion_angle) / rise


def _torsion_rate(view: CornerView, rise: ca.SX, *, preload: bool = True) -> ca.SX:
    """Slope of that force along the rise."""
    if view.linkage.rig.torsion_bar is None:
        return ca.SX(0.0)
    ratio = view.slope(view.torsion_angle) / rise
    rate = view.mechanism.parameter("torsion_bar.stiffness") * ratio**2
    return rate + view.torsion_torque * view.slope(ratio) / rise if preload else rate


def _contact_ratio_rate(view: CornerView) -> ca.SX:
    return view.slope(view.contact_ratio) / view.patch[2]


def _stiffness(view: CornerView) -> ca.SX:
    return view.springs.stiffness + view.stops.stiffness


def _wheel_rate(view: CornerView) -> ca.SX:
    """Wheel rate at the wheel centre."""
    force = view.springs.force + view.stops.force
    coil = _stiffness(view) * view.motion_ratio**2 + force * view.slope(view.motion_ratio)
    return coil + _still_damper_rate(view, ca.SX(1.0)) + _torsion_rate(view, ca.SX(1.0))


def _wheel_rate_spring(view: CornerView) -> ca.SX:
    unit = ca.SX(1.0)
    elastic = _stiffness(view) * view.motion_ratio**2 + _still_damper_rate(
        view, unit, preload=False
    )
    return elastic + _torsion_rate(view, unit, preload=False)


def _contact_rate_spring(view: CornerView) -> ca.SX:
    rise = view.patch[2]
    elastic = _stiffness(view) * view.contact_ratio**2 + _still_damper_rate(
        view, rise, preload=False
    )
    return elastic + _torsion_rate(view, rise, preload=False)


def _contact_rate(view: CornerView) -> ca.SX:
    """Wheel rate at the contact patch."""
    force = view.springs.force + view.stops.force
    coil = _stiffness(view) * view.contact_ratio**2 + force * _contact_ratio_rate(view)
    return coil + _still_damper_rate(view, view.patch[2]) + _torsion_rate(view, view.patch[2])


def _ride_rate(view: CornerView) -> ca.SX:
    wheel, tyre = _wheel_rate(view), view.tyre_stiffness
    return wheel * tyre / (wheel + tyre)


def _bar_rate(view: CornerView) -> ca.SX:
    return 0.5 * view.bar_stiffness * view.bar_twist_ratio**2


def _third_force(view: CornerView) -> ca.SX:
    return 0.5 * (view.third.force + view.still_third_damper.force) * view.third_ratio


def _third_rate(view: CornerView) -> ca.SX:
    """Rate of the third spring at either wheel centre when both move alike."""
    parts = view.third, view.still_third_damper
    force, stiffness = sum(part.force for part in parts), sum(part.stiffness for part in parts)
    return 0.5 * (stiffness * view.third_ratio**2 + force * view.slope(view.third_ratio))


def _heave_bar_force(view: CornerView) -> ca.SX:
    """Force of a Z-bar on either wheel when both move alike: its twist is twice the rotation of one end."""
    return view.bar_stiffness * view.bar_angle * view.bar_heave_ratio


def _heave_force(view: CornerView) -> ca.SX:
    """Force of all springs on either wheel centre when both wheels move alike."""
    rig, force = view.linkage.rig, ca.SX(0.0)
    if "spring" not in rig.lacks:
        force += _wheel_force(view)
    if rig.third_spring is not None:
        force += _third_force(view)
    if rig.anti_roll_bar is not None and rig.anti_roll_bar.kind == "z":
        force += _heave_bar_force(view)
    return force


def _heave_rate(view: CornerView) -> ca.SX:
    """Wheel rate with everything that acts when both wheels move alike."""
    rig, rate = view.linkage.rig, ca.SX(0.0)
    if "spring" not in rig.lacks:
        rate += _wheel_rate(view)
    if rig.third_spring is not None:
        rate += _third_rate(view)
    if rig.anti_roll_bar is not None and rig.anti_roll_bar.kind == "z":
        rate += view.slope(_heave_bar_force(view))
    return rate


def _inclination_gain(view: CornerView) -> ca.SX:
    return view.slope(_inclination_of(view.steering_axis))


def _camber_per_steer(view: CornerView) -> ca.SX:
    return view.by_rack(view.camber) / view.by_rack(view.toe_out)


_PARALLEL = 1e-9  # rad/m: a swing arm of 1000 km, beyond which links count as parallel
_TOP_OUT, _LEFT_TURN = "positive: top outward", "positive: about +z, a left turn"
_BUMP = "positive: bump, the wheel rises"
_WINDS = "positive: bump winds it up"
_HEAVY = "ISO 23365:2022, "

# fmt: off
CATALOGUE: tuple[Quantity, ...] = (
    Quantity("wheel_travel", "m", "vertical travel of the wheel centre", lambda v: v.travel.value, _BUMP),
    Quantity("rack_travel", "m", "travel of the steering rack", _track_of, "positive: to the left (+y)", needs="rack"),
    Quantity("camber", "rad", "camber angle", lambda v: v.camber, _TOP_OUT, _HEAVY + "7.1.5"),
    Quantity("inclination", "rad", "inclination angle", lambda v: -v.side * v.camber,
        "positive: about +x, the same turn on both sides", _HEAVY + "7.1.4"),
    Quantity("steer", "rad", "steer angle", lambda v: v.side * v.toe_out, _LEFT_TURN, "ISO 8855:2011, 7.1.1"),
    Quantity("toe", "rad", "toe angle", lambda v: -v.toe_out, "positive: toe-in", "ISO 8855:2011, 7.1.6"),
    Quantity("caster", "rad", "caster angle", lambda v: v.caster, "positive: top rearward", _HEAVY + "7.1.6",
        needs="axis"),
    Quantity("kingpin_inclination", "rad", "kingpin inclination", lambda v: _inclination_of(v.steering_axis),
        "positive: top inboard", _HEAVY + "7.1.9", needs="axis"),
    Quantity("caster_trail", "m", "caster trail at the ground, vehicle's axes", lambda v: _ground_lead(v)[0],
        "positive: steering axis meets the ground ahead of the contact point", _HEAVY + "7.1.7", needs="axis"),
    Quantity("scrub_radius", "m", "kingpin offset at the ground, vehicle's axes", lambda v: -_ground_lead(v)[1],
        "positive: steering axis meets the ground inboard of the contact point", _HEAVY + "7.1.10", needs="axis"),
    Quantity("spindle_offset", "m", "kingpin offset at the wheel centre, vehicle's axes",
        lambda v: -_centre_lead(v)[1], "positive: steering axis inboard of the wheel centre", _HEAVY + "7.1.11",
        needs="axis"),
    Quantity("wheel_centre_caster_offset", "m", "caster offset at the wheel centre, vehicle's axes",
        lambda v: -_centre_lead(v)[0], "positive: wheel centre ahead of the steering axis", _HEAVY + "7.1.8",
        needs="axis"),
    Quantity("caster_trail_wheel", "m", "caster trail at the ground, wheel's axes (turned by the steer angle)",
        lambda v: _by_wheel(v, _ground_lead(v))[0],
        "positive: steering axis meets the ground ahead of the contact point", needs="axis"),
    Quantity("scrub_radius_wheel", "m", "kingpin offset at the ground, wheel's axes (turned by the steer angle)",
        lambda v: -_by_wheel(v, _ground_lead(v))[1],
        "positive: steering axis meets the ground inboard of the contact point", needs="axis"),
    Quantity("spindle_offset_wheel", "m",
        "kingpin offset at the wheel centre, wheel's axes (turned by the steer angle)",
        lambda v: -_by_wheel(v, _centre_lead(v))[1], "positive: steering axis inboard of the wheel centre",
        needs="axis"),
    Quantity("wheel_centre_caster_offset_wheel", "m",
        "caster offset at the wheel centre, wheel's axes (turned by the steer angle)",
        lambda v: -_by_wheel(v, _centre_lead(v))[0], "positive: wheel centre ahead of the steering axis",
        needs="axis"),
    Quantity("steering_axis_pitch", "m/rad", "motion along the steering axis over the turn about it",
        lambda v: v.steering_pitch, "positive: upward in a left turn; 0 where rack and travel make a pure turn",
        needs="axis"),
    Quantity("caster_held_spring", "rad", "caster angle of the screw that the rack makes at held spring length",
        lambda v: caster_of(v.held_axis), "positive: top rearward", needs="rack strut"),
    Quantity("kingpin_inclination_held_spring", "rad",
        "kingpin inclination of the screw that the rack makes at held spring length",
        lambda v: _inclination_of(v.held_axis), "positive: top inboard", needs="rack strut"),
    Quantity("caster_trail_held_spring", "m",
        "caster trail, vehicle's axes, of the screw that the rack makes at held spring length",
        lambda v: _rack_lead(v)[0], "positive: axis meets the ground ahead of the contact point", needs="rack strut"),
    Quantity("scrub_radius_held_spring", "m",
        "kingpin offset at the ground, vehicle's axes, of the screw that the rack makes at held spring length",
        lambda v: -_rack_lead(v)[1], "positive: axis meets the ground inboard of the contact point",
        needs="rack strut"),
    Quantity("wheel_centre_x", "m", "wheel centre, x", lambda v: v.centre.value[0], "positive: forward"),
    Quantity("wheel_centre_y", "m", "wheel centre, y", lambda v: v.side * v.centre.value[1], "positive: left"),
    Quantity("wheel_centre_z", "m", "wheel centre, z", lambda v: v.centre.value[2], "positive: up"),
    Quantity("contact_point_x", "m", "contact point, x", lambda v: v.contact[0], "positive: forward"),
    Quantity("contact_point_y", "m", "contact point, y", lambda v: v.side * v.contact[1], "positive: left"),
    Quantity("contact_point_z", "m", "contact point, z", lambda v: v.contact[2], "positive: up"),
    Quantity("half_track_change", "m", "half-track change: contact point against design",
        lambda v: v.contact[1] - v.design_contact[1], "positive: outward", _HEAVY + "7.2.2 (both wheels)"),
    Quantity("half_track_gradient", "1", "half-track gradient", lambda v: v.slope(v.contact[1]),
        "positive: outward in bump", _HEAVY + "7.2.3 (both wheels)"),
    Quantity("bump_steer", "rad/m", "bump steer", lambda v: v.slope(v.side * v.toe_out),
        "positive: turns about +z in bump", _HEAVY + "7.2.5"),
    Quantity("camber_gain", "rad/m", "camber gain", lambda v: v.slope(v.camber), "positive: top moves outward in bump",
        _HEAVY + "7.2.9"),
    Quantity("caster_gain", "rad/m", "caster gain", lambda v: v.slope(v.caster),
        "positive: top moves rearward in bump", _HEAVY + "7.2.11", needs="axis"),
    Quantity("instant_centre_y", "m", "front-view instant centre, y", lambda v: v.side * _front_centre(v)[0],
        "positive: left"),
    Quantity("instant_centre_z", "m", "front-view instant centre, z", lambda v: _front_centre(v)[1],
        "positive: above z = 0"),
    Quantity("side_instant_centre_x", "m", "side-view instant centre, x", lambda v: _side_centre(v)[0],
        "positive: ahead of x = 0"),
    Quantity("side_instant_centre_z", "m", "side-view instant centre, z", lambda v: _side_centre(v)[1],
        "positive: above z = 0"),
    Quantity("front_view_swing_arm_length", "m", "front-view swing arm length", lambda v: v.patch[2] / _turning(v, 0),
        "positive: instant centre inboard of the contact point"),
    Quantity("side_view_swing_arm_length", "m", "side-view swing arm length", lambda v: v.patch[2] / _turning(v, 1),
        "positive: instant centre ahead of the contact point"),
    Quantity("front_view_swing_arm_angle", "rad", "front-view swing arm angle to the ground",
        lambda v: ca.atan(_lateral(v)), "positive: rises inboard, as towards a roll centre above the ground"),
    Quantity("side_view_swing_arm_angle", "rad", "side-view swing arm angle to the ground",
        lambda v: -ca.atan(v.patch[0] / v.patch[2]), "positive: rises forward"),
    Quantity("roll_centre_height", "m", "roll centre height of a symmetric axle", lambda v: v.contact[1] * _lateral(v),
        "positive: above the plane through the contact point"),
    Quantity("jacking", "1", "jacking: vertical force on the wheel per outward lateral force", _lateral,
        "positive: a force outward pushes the wheel into bump"),
    Quantity("contact_patch_recession", "1", "contact patch recession: dx/dz with the wheel locked",
        lambda v: v.patch[0] / v.patch[2], "positive: forward in bump"),
    Quantity("wheel_centre_longitudinal_slope", "1", "wheel centre, dx/dz",
        lambda v: v.centre.rate[0] / v.centre.rate[2], "positive: forward in bump"),
    Quantity("wheel_centre_recession", "1", "wheel centre recession: its dx over the rise dz of the contact patch",
        lambda v: v.centre.rate[0] / v.patch[2], "positive: forward in bump"),
    Quantity("wheel_centre_lateral_slope", "1", "lateral motion of the wheel centre over its rise",
        lambda v: v.centre.rate[1] / v.centre.rate[2], "positive: outward in bump"),
    Quantity("spring_length", "m", "spring length", lambda v: v.spring.length, "never negative", needs="strut"),
    Quantity("damper_length", "m", "damper length", lambda v: v.damper.length, "never negative", needs="strut"),
    Quantity("motion_ratio", "1", "motion ratio: spring compression over wheel travel", lambda v: v.motion_ratio,
        "positive: bump compresses the spring", needs="strut"),
    Quantity("motion_ratio_contact", "1", "motion ratio at the contact patch: spring compression over its rise",
        lambda v: v.contact_ratio, "positive: bump compresses the spring", needs="strut"),
    Quantity("motion_ratio_gradient", "1/m", "motion-ratio gradient", lambda v: v.slope(v.motion_ratio),
        "positive: the ratio grows in bump", needs="strut"),
    Quantity("motion_ratio_contact_gradient", "1/m", "motion-ratio gradient at the contact patch", _contact_ratio_rate,
        "positive: the ratio grows in bump", needs="strut"),
    Quantity("damper_motion_ratio", "1", "damper motion ratio: damper compression over wheel travel",
        lambda v: v.damper_ratio, "positive: bump compresses the damper", needs="strut"),
    Quantity("spring_force", "N", "spring force", lambda v: v.springs.force, "positive: compression",
        needs="coil"),
    Quantity("stop_force", "N", "force of bump and rebound stops", lambda v: v.stops.force, "positive: compression",
        needs="spring"),
    Quantity("damper_force", "N", "force of the damper at rest: its gas, and what grows with its stroke",
        lambda v: v.still_damper.force, "positive: compression",
        needs="damper"),
    Quantity("wheel_force", "N", "force of spring, stops and damper at rest at the wheel centre", _wheel_force,
        "positive: pushes the wheel down",
        needs="spring"),
    Quantity("wheel_rate", "N/m", "wheel rate at the wheel centre, preload term included", _wheel_rate,
        "positive: stiffens in bump",
        needs="spring"),
    Quantity("wheel_rate_spring", "N/m", "wheel rate without the preload term",
        _wheel_rate_spring, "positive: stiffens in bump",
        needs="spring"),
    Quantity("wheel_rate_contact", "N/m", "wheel rate at the contact patch, preload term included", _contact_rate,
        "positive: stiffens in bump",
        needs="spring"),
    Quantity("wheel_rate_contact_spring", "N/m", "wheel rate at the contact patch without the preload term",
        _contact_rate_spring, "positive: stiffens in bump",
        needs="spring"),
    Quantity("wheel_damping_coefficient", "N*s/m", "damping coefficient at the wheel centre, about rest",
        lambda v: v.damping_coefficient * v.damper_ratio**2, "positive: dissipates energy",
        needs="damper"),
    Quantity("tyre_deflection", "m", "tyre deflection at the wheel's radius", lambda v: v.tyre_deflection,
        "positive: compression",
        needs="tyre"),
    Quantity("tyre_stiffness", "N/m", "stiffness of the tyre at its deflection", lambda v: v.tyre_stiffness,
        "never negative", needs="stiffness"),
    Quantity("ride_rate", "N/m", "ride rate: wheel rate and tyre in series", _ride_rate, "positive: stiffens in bump",
        needs="stiffness"),
    Quantity("anti_roll_bar_angle", "rad", "rotation of the anti-roll bar's end", lambda v: v.bar_angle,
        "positive: about its axis to the left (+y)", needs="bar"),
    Quantity("anti_roll_bar_motion_ratio", "rad/m",
        "anti-roll bar motion ratio: rotation of its end over wheel travel", lambda v: v.slope(v.bar_angle),
        "positive: bump turns it about its axis to the left (+y)", needs="bar"),
    Quantity("anti_roll_bar_motion_ratio_gradient", "rad/m^2", "anti-roll bar motion-ratio gradient",
        lambda v: v.slope(v.slope(v.bar_angle)), "positive: the ratio grows in bump", needs="bar"),
    Quantity("anti_roll_bar_rate", "N/m", "wheel rate of the anti-roll bar in opposite wheel travel", _bar_rate,
        "never negative", needs="bar"),
    Quantity("anti_roll_bar_arm_angle", "rad", "angle between the anti-roll bar's arm and its link",
        lambda v: v.bar_arm_angle, "never negative; a right angle moves the bar best", needs="bar"),
    Quantity("anti_roll_bar_stiffness", "N*m/rad", "stiffness of the anti-roll bar with its blades",
        lambda v: v.bar_stiffness, "never negative", needs="bar"),
    Quantity("torsion_bar_angle", "rad", "turn of the torsion bar from design", lambda v: v.torsion_angle, _WINDS,
        needs="torsion"),
    Quantity("torsion_bar_motion_ratio", "rad/m", "torsion-bar motion ratio: its turn over wheel travel",
        lambda v: v.slope(v.torsion_angle), _WINDS, needs="torsion"),
    Quantity("torsion_bar_torque", "N*m", "torque of the torsion bar", lambda v: v.torsion_torque,
        "positive: against bump", needs="torsion"),
    Quantity("third_spring_length", "m", "length of the third spring, both wheels moving alike",
        lambda v: v.third_length, "never negative", needs="third"),
    Quantity("third_spring_motion_ratio", "1",
        "third-spring motion ratio: its compression over the travel of both wheels", lambda v: v.third_ratio,
        "positive: bump of both wheels compresses it", needs="third"),
    Quantity("third_spring_force", "N", "force of the third spring, both wheels moving alike",
        lambda v: v.third.force, "positive: compression", needs="third"),
    Quantity("third_wheel_force", "N", "force of the third spring at each wheel centre, both wheels moving alike",
        _third_force, "positive: pushes the wheel down", needs="third"),
    Quantity("third_wheel_rate", "N/m", "wheel rate of the third spring, both wheels moving alike", _third_rate,
        "positive: stiffens in bump", needs="third"),
    Quantity("third_damping_coefficient", "N*s/m",
        "damping coefficient of the third damper at each wheel centre, both wheels moving alike, about rest",
        lambda v: 0.5 * v.third_damping_coefficient * v.third_ratio**2, "positive: dissipates energy",
        needs="third damper"),
    Quantity("heave_force", "N", "force at each wheel centre while both wheels move alike: with third spring and Z-bar",
        _heave_force, "positive: pushes the wheel down", needs="heave"),
    Quantity("heave_rate", "N/m", "wheel rate while both wheels move alike: with third spring and Z-bar", _heave_rate,
        "positive: stiffens in bump", needs="heave"),
    Quantity("rocker_angle", "rad", "turn of the rocker from design", lambda v: v.turn_of("rocker"),
        "positive: as bump turns it", needs="rocker"),
    Quantity("pushrod_angle", "rad", "angle between push rod and rocker arm", lambda v: v.pushrod_angle,
        "never negative; a right angle moves the rocker best", needs="rocker"),
    Quantity("rocker_spring_angle", "rad", "angle between spring and rocker arm", lambda v: v.strut_angle,
        "never negative; a right angle moves the spring best", needs="rocker strut"),
    Quantity("steer_gain", "rad/m", "steer gain: steer angle per rack travel", lambda v: v.by_rack(v.side * v.toe_out),
        "positive: a rack to the left turns the wheel to the left", needs="rack"),
    Quantity("kingpin_inclination_gain", "rad/m", "kingpin inclination gain", _inclination_gain,
        "positive: top moves inboard in bump", needs="axis"),
    Quantity("camber_per_steer", "1", "camber gain in steer, along the rack at the wheel centre's height",
        _camber_per_steer, "positive: top moves outward as the wheel toes out", needs="rack"),
    Quantity("ride_height_change", "m", "change of the body's height above the ground at the wheel, from design",
        lambda v: v.design_contact[2] - v.contact[2], "positive: the body rises, as in rebound"),
)
# fmt: on


_PARTS: dict[str, tuple[str, ...]] = {
    **{name: (name,) for name in ("strut", "spring", "damper", "tyre")},
    "rack strut": ("strut",),
    "rocker strut": ("strut",),
    "coil": ("spring",),
    "stiffness": ("spring", "tyre"),
}
"""Parts of the description for each value of ``needs``."""


def require_parts(rig: Corner, name: str) -> None:
    """Refuse a quantity if the description of a corner lacks its parts, and name these."""
    needs = next((row.needs for row in CATALOGUE if row.name == name), "")
    rig.require(*_PARTS.get(needs, ()), what=name)


def quantities(view: CornerView) -> tuple[Quantity, ...]:
    """Rows that apply to a corner."""
    rig = view.linkage.rig
    has = {
        "": True,
        "axis": view.steers,
        "rack": view.rack is not None,
        "strut": rig.has_strut,
        "rack strut": view.rack is not None and rig.has_strut,
        "bar": rig.anti_roll_bar is not None,
        "coil": "spring" not in rig.without,
        "spring": "spring" not in rig.lacks,
        "torsion": rig.torsion_bar is not None,
        "third": rig.third_spring is not None,
        "third damper": rig.third_spring is not None and rig.third_spring.damper is not None,
        "heave": {"third_spring", "anti_roll_bar"} & set(rig.besides_strut) != set(),
        "rocker": getattr(rig.hardpoints, "rocker_pivot", None) is not None,
        "rocker strut": rig.has_strut and rig.strut.on == "rocker",
        "damper": "damper" not in rig.without,
        "tyre": "tyre" not in rig.without,
        "stiffness": view.has_tyre_stiffness and not {"spring", "tyre"} & set(rig.lacks),
    }
    return tuple(row for row in CATALOGUE if has[row.needs])
