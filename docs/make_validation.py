"""Write the table of explanation/kinematics-validation.md: every row of the catalogue and differences of poses."""

from __future__ import annotations

import math
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = Path(__file__).parent / "explanation" / "kinematics-validation.md"
MARK = "<!-- docs/make_validation.py writes the following -->\n\n"
_OF_AXIS = "steering axis"
_AT_GROUND = f"{_OF_AXIS}, at the height of the contact point"
_AT_CENTRE = f"{_OF_AXIS}, at the height of the wheel centre"
_HELD = "screw between poses over rack and travel at which the spring keeps its length"
_PATCH = "velocity of the upright's point at the contact point"
_CENTRE = "velocities of the upright's points in this view"
_ENERGY = "energy of springs, stops and gas over travel"
HOW = {
    "wheel_travel": "height of the wheel centre, less that at design",
    "rack_travel": "y of the tie rod's inner end, less that at design",
    "camber": "wheel's axis, turned as the upright's points are",
    "inclination": "wheel's axis, turned as the upright's points are",
    "steer": "wheel's axis, turned as the upright's points are",
    "toe": "wheel's axis, turned as the upright's points are",
    "caster": _OF_AXIS,
    "kingpin_inclination": _OF_AXIS,
    "caster_trail": _AT_GROUND,
    "scrub_radius": _AT_GROUND,
    "spindle_offset": _AT_CENTRE,
    "wheel_centre_caster_offset": _AT_CENTRE,
    "caster_trail_wheel": f"{_AT_GROUND}; along the wheel",
    "scrub_radius_wheel": f"{_AT_GROUND}; across the wheel",
    "spindle_offset_wheel": f"{_AT_CENTRE}; across the wheel",
    "wheel_centre_caster_offset_wheel": f"{_AT_CENTRE}; along the wheel",
    "steering_axis_pitch": "screw between poses over rack and travel that is nearest to a pure turn",
    "caster_held_spring": _HELD,
    "kingpin_inclination_held_spring": _HELD,
    "caster_trail_held_spring": _HELD,
    "scrub_radius_held_spring": _HELD,
    "wheel_centre_x": "place",
    "wheel_centre_y": "place",
    "wheel_centre_z": "place",
    "contact_point_x": "lowest point of the wheel's circle",
    "contact_point_y": "lowest point of the wheel's circle",
    "contact_point_z": "lowest point of the wheel's circle",
    "half_track_change": "y of the contact point, less that at design",
    "half_track_gradient": "slope of the contact point's y over travel",
    "bump_steer": "slope of the steer angle over travel",
    "camber_gain": "slope of the camber over travel",
    "caster_gain": "slope of the caster over travel",
    "instant_centre_y": _CENTRE,
    "instant_centre_z": _CENTRE,
    "side_instant_centre_x": _CENTRE,
    "side_instant_centre_z": _CENTRE,
    "front_view_swing_arm_length": _CENTRE,
    "side_view_swing_arm_length": _CENTRE,
    "front_view_swing_arm_angle": _PATCH,
    "side_view_swing_arm_angle": _PATCH,
    "roll_centre_height": f"{_PATCH}, times its distance from the middle of the car",
    "jacking": _PATCH,
    "contact_patch_recession": _PATCH,
    "wheel_centre_longitudinal_slope": "slope of the wheel centre's x over travel",
    "wheel_centre_recession": "slope of the wheel centre's x, over the rise of the contact patch",
    "wheel_centre_lateral_slope": "slope of the wheel centre's y over travel",
    "spring_length": "distance of its ends",
    "damper_length": "distance of its ends",
    "motion_ratio": "slope of the spring's length over travel",
    "motion_ratio_contact": "slope of the spring's length over the rise of the contact patch",
    "motion_ratio_gradient": "second slope of the spring's length over travel",
    "motion_ratio_contact_gradient": "slope of the ratio at the contact patch over the rise of that",
    "damper_motion_ratio": "slope of the damper's length over travel",
    "spring_force": "law of the spring at the distance of its ends",
    "stop_force": "law of the stops at the distance of the spring's ends",
    "damper_force": "law of the damper at the distance of its ends, at rest",
    "wheel_force": f"slope of the {_ENERGY}",
    "wheel_rate": f"second slope of the {_ENERGY}",
    "wheel_rate_spring": "stiffness times squared slope of the lengths of spring and damper, and of the bar's turn",
    "wheel_rate_contact": "slope of the force at the contact patch (virtual work) over its rise",
    "wheel_rate_contact_spring": "stiffness times squared slopes over the rise of the contact patch",
    "wheel_damping_coefficient": "coefficient times squared slope of the damper's length",
    "tyre_deflection": "radii of the description",
    "tyre_stiffness": "of the description",
    "ride_rate": "wheel rate by differences, in series with the tyre",
    "anti_roll_bar_angle": "turn of the arm's end about the bar's axis",
    "anti_roll_bar_motion_ratio": "slope of that turn over travel",
    "anti_roll_bar_motion_ratio_gradient": "second slope of that turn over travel",
    "anti_roll_bar_rate": "energy of the bar twisted by opposite travel",
    "anti_roll_bar_arm_angle": "angle between arm and link",
    "anti_roll_bar_stiffness": "of the description",
    "torsion_bar_angle": "turn of the arm about its axis",
    "torsion_bar_motion_ratio": "slope of that turn over travel",
    "torsion_bar_torque": "law of the bar at that turn",
    "third_spring_length": "distance of its end from that of the mirror image",
    "third_spring_motion_ratio": "slope of that distance over travel",
    "third_spring_force": "law of the spring at that distance",
    "third_wheel_force": "slope of half of its energy, its damper's gas too, over travel",
    "third_wheel_rate": "second slope of half of its energy, its damper's gas too, over travel",
    "third_damping_coefficient": "half of the coefficient times squared slope of that distance",
    "heave_force": "slope of the energy of all springs, half of those between the wheels",
    "heave_rate": "second slope of the energy of all springs, half of those between the wheels",
    "rocker_angle": "turn of the push rod's inner end about the rocker's axis",
    "pushrod_angle": "angle between places",
    "rocker_spring_angle": "angle between places",
    "steer_gain": "slope of the steer angle over rack travel",
    "kingpin_inclination_gain": "slope of the kingpin inclination over travel",
    "camber_per_steer": "slopes of camber and steer over rack travel",
    "ride_height_change": "height of the contact point, less that at design",
}
"""How each row is found from poses."""
AXLE = {
    "camber_to_ground": "wheel's axis in axes of the road",
    "roll_steer": "slope of the steer angle over roll",
    "roll_camber": "slope of the camber over roll",
    "roll_caster": "slope of the caster over roll",
    "track": "distance of both contact points along the road",
    "roll_centre_height": "normals to the motion of the wheels' points at the contact points, from poses",
    "roll_centre_y": "normals to the motion of the wheels' points at the contact points, from poses",
    "anti_roll_bar_twist": "turns of both ends",
    "anti_roll_bar_torque": "law of the bar at that twist",
    "roll_moment": "work of the springs at both wheels and of the bar over roll",
    "roll_stiffness": "slope of the roll moment",
    "roll_stiffness_bar": "second slope of the bar's energy over roll",
    "roll_stiffness_springs": "what is left of the slope of the roll moment",
    "roll_stiffness_total": "that slope in series with the tyres",
    "mean_steer": "headings of both wheels",
    "steer_difference": "headings of both wheels",
    "ideal_outer_steer": "from the outer contact point to where the inner normal meets the line of the rear axle",
    "ackermann_error": "headings of both wheels and that angle",
    "ackermann": "headings of both wheels and that angle",
    "turning_radius": "normals of both wheels on the line of the rear axle",
    "turn_diameter_kerbs": "outer contact point around that centre",
    "turn_diameter_walls": "corner of the body around that centre",
    "pinion_angle": "travel of the rack over its ratio",
    "c_factor": "slope of the handwheel's angle over rack travel",
    "steering_ratio": "slopes of the handwheel's angle and of the mean steer angle over rack travel",
}
"""How each row of an axle is found from both wheels."""


def table() -> str:
    """Every row: unit, what it is compared with, the suspensions that have it, and the largest difference."""
    sys.path.insert(0, str(ROOT / "tests" / "twins"))
    from validation_cases import CASES, compared, compared_axle

    from jounce.kinematics.catalogue import CATALOGUE

    found: dict[str, list[tuple[str, float]]] = {}
    for case in CASES:
        for name, error in compared(*case)[0].items():
            found.setdefault(name, []).append((case[0], error))
    lines = ["| row | unit | compared with | suspensions | at most |", "|---|---|---|---:|---:|"]
    for row in CATALOGUE:
        largest = max(error for _, error in found[row.name])
        bound = _bound(largest)
        count = len({name for name, _ in found[row.name]})
        lines.append(f"| `{row.name}` | {row.unit} | {HOW[row.name]} | {count} | {bound} |")
    lines += [
        "",
        "Both wheels together, in roll and steered:",
        "",
        "| row of an axle | compared with | at most |",
        "|---|---|---|",
    ]
    lines += [
        f"| `{name}` | {AXLE[name]} | {_bound(error)} |" for name, error in compared_axle().items()
    ]
    return "\n".join(lines) + "\n"


def _bound(error: float) -> str:
    """The next power of ten above a difference, rounding of one number being the least."""
    return f"1e{math.ceil(math.log10(max(error, 1e-15)))}"


if __name__ == "__main__":
    above, mark, _ = PAGE.read_text(encoding="utf-8").partition(MARK)
    PAGE.write_text(above + mark + table(), encoding="utf-8")
