"""Rows of a whole axle from both wheels: places in space, differences over roll and rack, energies of springs.

What each wheel does is held against poses elsewhere (``catalogue_from_poses``); here both are put together again, in
axes of the road (y to the left along it, z up), with the body rolled onto it.
"""

from __future__ import annotations

import numpy as np
from catalogue_from_poses import FromPoses

import jounce as jn

STEP = 2e-3  # rad of roll
RACK = 0.5e-3  # m
WEIGHTS = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
SIDES = {"left": 1.0, "right": -1.0}


def slope(values, step: float) -> float:
    """Difference of order eight in the middle of nine values."""
    values = np.asarray(values)
    return float(
        sum(w * (values[4 + k] - values[4 - k]) for k, w in enumerate(WEIGHTS, start=1)) / step
    )


def wheel_axis(rows, name: str):
    """Axis of a wheel, outboard, body axes, shape (n, 3)."""
    camber, steer, side = rows[f"{name}.camber"], rows[f"{name}.steer"], SIDES[name]
    level = np.cos(camber)
    return np.stack(
        [-side * np.sin(steer) * level, side * np.cos(steer) * level, -np.sin(camber)], axis=-1
    )


def onto_road(vectors, roll, pitch=0.0):
    """Vectors of the body in axes of the road: the body is pitched about y (nose down), then rolled about x."""
    x, y, z = np.moveaxis(np.asarray(vectors), -1, 0)
    c, s = np.cos(roll), np.sin(roll)
    y, z = c * y - s * z, s * y + c * z
    c, s = np.cos(pitch), np.sin(pitch)
    return np.stack([c * x + s * z, y, c * z - s * x], axis=-1)


def contact(rows, name: str, radius: float, roll, pitch=0.0):
    """Contact point of a wheel in axes of the road, shape (n, 3), and the wheel's axis there."""
    axis = onto_road(wheel_axis(rows, name), roll, pitch)
    centre = onto_road(
        np.stack([rows[f"{name}.wheel_centre_{one}"] for one in "xyz"], axis=-1), roll, pitch
    )
    down = axis * axis[..., 2:] - np.array([0.0, 0.0, 1.0])
    return centre + radius * down / np.linalg.norm(down, axis=-1, keepdims=True), axis


def arrays(swept) -> dict:
    return {str(name): swept[name].to_numpy() for name in (*swept.data_vars, *swept.coords)}


def middle(value) -> float:
    return float(np.asarray(value)[4])


def rolled(rig, roll: float, rack: float) -> tuple[dict[str, float], dict[str, float]]:
    """Rows of the middle of nine rolled poses, by jounce and from its wheels."""
    at = roll + STEP * np.arange(-4, 5)
    rows = arrays(jn.sweep_roll(rig, at, rack))
    points = {name: contact(rows, name, rig.wheel.radius, at) for name in SIDES}
    found = {}
    for name, (_, axis) in points.items():
        found[f"{name}.camber_to_ground"] = middle(-np.arcsin(axis[..., 2]))
        found[f"{name}.roll_steer"] = slope(rows[f"{name}.steer"], STEP)
        found[f"{name}.roll_camber"] = slope(rows[f"{name}.camber"], STEP)
        found[f"{name}.roll_caster"] = slope(rows[f"{name}.caster"], STEP)
    assert np.allclose(
        points["left"][0][:, 2], points["right"][0][:, 2], atol=1e-12
    )  # one plane road
    apart = points["left"][0] - points["right"][0]
    found["track"] = middle(apart[:, 1])
    found |= roll_centre(rig, rows, roll, rack)
    twist = rows["right.anti_roll_bar_angle"] - rows["left.anti_roll_bar_angle"]
    found["anti_roll_bar_twist"] = middle(twist)
    found["anti_roll_bar_torque"] = rig.anti_roll_bar.stiffness * middle(twist)
    force = {name: rows[f"{name}.wheel_force"] for name in SIDES}
    travels = {name: rows[f"{name}.wheel_travel"] for name in SIDES}
    exact = {name: slope(travels[name], STEP) for name in SIDES}
    springs = sum(middle(force[name]) * exact[name] for name in SIDES)
    bar = rig.anti_roll_bar.stiffness * middle(twist) * slope(twist, STEP)
    found["roll_moment"] = springs + bar
    found["roll_stiffness"] = slope(rows["roll_moment"], STEP)
    energy = 0.5 * rig.anti_roll_bar.stiffness * twist**2
    second = (
        -205 / 72 * energy[4]
        + sum(
            w * (energy[4 + k] + energy[4 - k])
            for k, w in enumerate((8 / 5, -1 / 5, 8 / 315, -1 / 560), start=1)
        )
    ) / STEP**2
    found["roll_stiffness_bar"] = float(second)
    found["roll_stiffness_springs"] = found["roll_stiffness"] - found["roll_stiffness_bar"]
    tyres = 0.5 * rig.tyre.stiffness * found["track"] ** 2
    found["roll_stiffness_total"] = 1.0 / (1.0 / found["roll_stiffness"] + 1.0 / tyres)
    return {name: middle(rows[name]) for name in found}, found


def roll_centre(rig, rows, roll: float, rack: float) -> dict[str, float]:
    """Where the normals meet along which the wheels' points at the contact points do not move, in front view."""
    ends, ways = [], []
    for name, side in SIDES.items():
        wheel = rig if side > 0.0 else rig.mirrored()
        up = np.array([0.0, side * np.sin(roll), np.cos(roll)])
        found = FromPoses(wheel, jn.sweep_travel, middle(rows[f"{name}.wheel_travel"]), rack, up)
        place, speed = (
            found.now(value) * [1.0, side, 1.0] for value in (found.contact, found.patch)
        )
        ends.append(onto_road(place, roll)[1:])
        ways.append(onto_road(np.array([0.0, speed[2], -speed[1]]), roll)[1:])
    share = np.linalg.solve(np.column_stack([ways[0], -ways[1]]), ends[1] - ends[0])
    place = ends[0] + share[0] * ways[0]
    half = 0.5 * (ends[0] + ends[1])
    return {
        "roll_centre_height": float(place[1] - ends[0][1]),
        "roll_centre_y": float(place[0] - half[0]),
    }


def steered(rig, car, rack: float, travel: float) -> tuple[dict[str, float], dict[str, float]]:
    """Rows of the middle of nine racks: normals of both wheels and the line of the rear axle, seen from above."""
    at = rack + RACK * np.arange(-4, 5)
    rows = arrays(jn.sweep_steering(rig, at, travel, vehicle=car))
    place, ahead = {}, {}
    for name, side in SIDES.items():
        point, axis = contact(rows, name, rig.wheel.radius, 0.0 * at)
        place[name], ahead[name] = point[4, :2], np.cross(axis[4], [0.0, 0.0, 1.0])[:2] * side
    heading = {name: float(np.arctan2(way[1], way[0])) for name, way in ahead.items()}
    rear = rig.hardpoints.wheel_centre[0] - car.wheelbase
    mean = 0.5 * (heading["left"] + heading["right"])
    turn = np.sign(mean)  # 1: to the left
    inner, outer = ("left", "right") if turn > 0.0 else ("right", "left")

    def on_rear(name: str) -> float:
        """y where the normal through a wheel's contact point meets the line of the rear axle."""
        x, y = place[name]
        return float(y + (x - rear) / np.tan(heading[name]))

    x, y = place[outer]
    ideal = abs(float(np.arctan((x - rear) / (on_rear(inner) - y))))
    centre = 0.5 * (on_rear(inner) + on_rear(outer))
    found = {
        "mean_steer": mean,
        "steer_difference": heading["left"] - heading["right"],
        "track": float(place["left"][1] - place["right"][1]),
        "ideal_outer_steer": ideal,
        "ackermann_error": abs(heading[outer]) - ideal,
        "ackermann": (abs(heading[inner]) - abs(heading[outer])) / (abs(heading[inner]) - ideal),
        "turning_radius": centre,
        "turn_diameter_kerbs": 2.0 * float(np.hypot(x - rear, centre - y))
        + (rig.wheel.width or 0.0),
        "turn_diameter_walls": 2.0
        * float(np.hypot(abs(centre) + 0.5 * car.body_width, car.wheelbase + car.front_overhang)),
        "pinion_angle": rack / rig.steering.rack_ratio,
    }
    per_rack = slope(rows["handwheel_angle"], RACK)
    found["c_factor"] = 2.0 * np.pi / per_rack
    found["steering_ratio"] = per_rack / slope(rows["mean_steer"], RACK)
    return {name: middle(rows[name]) for name in found}, found
