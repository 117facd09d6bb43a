"""Sweeps of dependent axles: both wheels and the axle between them, over travel, roll, or any attitude of the body."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.kinematics.axle import AxleVariables, Ground, check_roll, travel_by_roll
from jounce.kinematics.catalogue import CATALOGUE
from jounce.kinematics.dependent_poses import MOTIONS, AxlePoses, SweptAxle
from jounce.kinematics.sweeps import (
    ANTI_EFFECTS,
    ANTI_SIGN,
    AxleLayout,
    End,
    ends_text,
    no_pose,
    shares,
)
from jounce.parts.axles import DependentAxle, SolidAxle

if TYPE_CHECKING:
    import xarray as xr

_SIDES = {"left": 1.0, "right": -1.0}
_ITERATIONS, _LEVEL = 40, 1e-12  # m: rounding of a height
_OFF = 1e-9  # m: most distance from the road of a wheel that touches it
_STEP = 0.03  # m: most travel of one iteration
_ROWS = {
    row.name: row
    for row in CATALOGUE
    if row.name
    in (
        "wheel_travel",
        "camber",
        "inclination",
        "steer",
        "toe",
        "half_track_change",
        "half_track_gradient",
        "bump_steer",
        "camber_gain",
        "contact_patch_recession",
        "wheel_centre_recession",
        "wheel_centre_longitudinal_slope",
        "wheel_centre_lateral_slope",
        "spring_length",
        "damper_length",
        "motion_ratio",
        "damper_motion_ratio",
        *(f"{at}_{i}" for at in ("wheel_centre", "contact_point") for i in "xyz"),
    )
}
_ROLLS = "positive: about +x, left side up"
_STIFF = "positive: stiffens in bump"


def no_rack(rig: DependentAxle, given: bool, where: str) -> None:
    """Raise an error if a rack is to steer a dependent axle."""
    if given:
        raise DescriptionError(
            "a dependent axle has no steering rack",
            where=where,
            found=Phrase('model = "{model}"', model=getattr(rig, "model", "")),
            hint="Leave it out.",
        )


@dataclass(frozen=True)
class _OnRoad:
    """An axle on a plane road, with roll and pitch of the body, rad; ``ends`` are those on the way to it."""

    poses: AxlePoses
    roll: Array
    pitch: Array
    ends: tuple[End, ...]

    def ground(self, name: str, motion: str) -> Ground:
        side = _SIDES[name]
        wheel = self.poses.wheel(int(side < 0.0), motion)
        return Ground(wheel, self.roll, side, self.pitch)

    def grounds(self, motion: str) -> tuple[Ground, Ground]:
        return self.ground("left", motion), self.ground("right", motion)


# sweeps ---------------------------------------------------------------------------------------------------------------


def travel_of_axle(rig: DependentAxle, travel: Array, vehicle: AxleLayout | None) -> xr.Dataset:
    """Sweep both wheels together, the road level under the body."""
    axle = SweptAxle(rig)
    level = np.zeros_like(travel)
    poses = axle.at(travel, travel, stops=True)
    on_road = _OnRoad(poses, level, level, poses.ends)
    row = _ROWS["wheel_travel"]
    variables = AxleVariables("wheel_travel", travel, "m", row.long_name, row.sign)
    return _dataset(variables, axle, on_road, vehicle, kept=False)


def roll_of_axle(rig: DependentAxle, roll: Array) -> xr.Dataset:
    """Roll the body; both wheels travel by the same amount in opposite directions."""
    axle = SweptAxle(rig)
    level = np.zeros_like(roll)
    away = np.abs(axle.wheels[0][1][1]) * np.sin(roll)
    ends: tuple[End, ...] = ()
    for _ in range(_ITERATIONS):
        poses = axle.at(-away, away)
        ends += poses.ends  # a lost pose is NaN in all further iterations
        on_road = _OnRoad(poses, roll, level, ends)
        left, right = on_road.grounds("opposed")
        off = left.height - right.height
        if np.nanmax(np.abs(off), initial=0.0) < _LEVEL:
            break
        away = away + off / (left.height_by_travel + right.height_by_travel)
    else:
        poses = poses.without(np.abs(off) > _OFF, np.stack([-away, away], axis=1))
        on_road = _OnRoad(poses, roll, level, ends + poses.ends)
    variables = AxleVariables("roll_angle", roll, "rad", "roll angle of the body", _ROLLS)
    return _dataset(variables, axle, on_road, None, kept=False)


def poses_of_axle(
    rig: DependentAxle, at: Mapping[str, Array], vehicle: AxleLayout | None, *, placed: bool
) -> xr.Dataset:
    """Sweep pairs of travels, or attitudes of the body if ``placed``; see ``sweep_axle``."""
    axle = SweptAxle(rig)
    on_road = _on_road(axle, at) if placed else _on_wheels(axle, at)
    count = len(on_road.roll)
    variables = AxleVariables("pose", np.arange(float(count)), "1", "pose", "in the order given")
    reached = on_road.poses.reached
    heave = at["heave"] if placed else _middle(axle) @ on_road.ground("left", "together").normal.T
    if not placed:
        heave = heave - on_road.ground("left", "together").height
    variables.add(
        "heave",
        np.where(reached, heave, np.nan),
        "m",
        "rise of the body above the road, middle of the axle",
        "positive: the body rises",
    )
    roll = np.where(reached, on_road.roll, np.nan)
    variables.add("roll_angle", roll, "rad", "roll angle of the body", _ROLLS)
    nose_down = "positive: about +y, nose down"
    variables.add("pitch_angle", on_road.pitch, "rad", "pitch angle of the body", nose_down)
    return _dataset(variables, axle, on_road, vehicle, kept=True)


def _middle(axle: SweptAxle) -> Array:
    """Middle of the axle at design, the zero of heave, m."""
    still = np.zeros(1)
    rows = axle.at(still, still).wheel(0, "together").rows
    return np.array([rows["wheel_centre_x"][0], 0.0, rows["contact_point_z"][0]])


def _on_road(axle: SweptAxle, at: Mapping[str, Array]) -> _OnRoad:
    """Move the wheels until both touch the road given by heave, roll and pitch of the body."""
    middle, half_track = _middle(axle), abs(axle.wheels[0][1][1])
    tilt = half_track * np.sin(at["roll"])
    left, right = -at["heave"] - tilt, -at["heave"] + tilt
    ends: tuple[End, ...] = ()
    for _ in range(_ITERATIONS):
        poses = axle.at(left, right)
        ends += poses.ends
        on_road = _OnRoad(poses, at["roll"], at["pitch"], ends)
        gaps, slopes = [], []
        for name, side in _SIDES.items():
            together, opposed = (on_road.ground(name, motion) for motion in MOTIONS)
            gaps.append(together.height - (together.normal @ middle - at["heave"]))
            slopes.append([together.height_by_travel, side * opposed.height_by_travel])
        (a, b), (c, d) = slopes
        if np.nanmax(np.abs(gaps), initial=0.0) < _LEVEL:
            break
        size = a * d - b * c
        up, apart = (d * gaps[0] - b * gaps[1]) / size, (a * gaps[1] - c * gaps[0]) / size
        left = left - np.clip(up + apart, -_STEP, _STEP)
        right = right - np.clip(up - apart, -_STEP, _STEP)
    else:
        lost = np.any(np.abs(gaps) > _OFF, axis=0)
        poses = poses.without(np.asarray(lost), np.stack([left, right], axis=1))
        on_road = _OnRoad(poses, at["roll"], at["pitch"], ends + poses.ends)
    return on_road


def _on_wheels(axle: SweptAxle, at: Mapping[str, Array]) -> _OnRoad:
    """Place the road under both wheels."""
    poses = axle.at(at["left travel"], at["right travel"])
    roll = np.zeros_like(at["pitch"])
    for _ in range(_ITERATIONS):
        on_road = _OnRoad(poses, roll, at["pitch"], poses.ends)
        left, right = on_road.grounds("together")
        off = left.height - right.height
        if np.nanmax(np.abs(off), initial=0.0) < _LEVEL:
            break
        roll = roll - off / (left.height_by_roll - right.height_by_roll)
    check_roll(roll[np.isfinite(roll)], "travel")
    return on_road


def _dataset(
    variables: AxleVariables,
    axle: SweptAxle,
    on_road: _OnRoad,
    vehicle: AxleLayout | None,
    *,
    kept: bool,
) -> xr.Dataset:
    """Dataset of all rows; poses out of reach are left out unless they are ``kept``, as NaN."""
    reached = on_road.poses.reached
    if not reached.any():
        raise no_pose(on_road.ends)
    for name in _SIDES:
        _add_wheel(variables, axle, on_road, name)
    _add_axle(variables, on_road)
    _add_road(variables, on_road)
    if vehicle is not None:
        _add_shares(variables, axle, on_road, vehicle)
    data = variables.dataset(reached | kept, (), axle.rig)
    if not reached.all():
        data.attrs.update(status="end_of_travel", stopped=ends_text(on_road.ends))
    if not axle.is_ideal:
        data.attrs["findings"] = str(finding("kinematics.bushings_yield", "bushings"))
    return data


# rows -----------------------------------------------------------------------------------------------------------------


def _add_wheel(variables: AxleVariables, axle: SweptAxle, on_road: _OnRoad, name: str) -> None:
    """Add the rows of a wheel; slopes are those of both wheels together, or of the body's roll."""
    side, poses = _SIDES[name], on_road.poses
    together, opposed = (on_road.ground(name, motion) for motion in MOTIONS)
    seen = together.wheel.rows_seen_from(side)
    seen |= {
        "wheel_travel": poses.travels[:, int(side < 0.0)],
        "inclination": -side * seen["camber"],
        "toe": -side * seen["steer"],
    }
    own: dict[str, Any] = {}
    for part, ratio in (("spring", "motion_ratio"), ("damper", "damper_motion_ratio")):
        line = poses.length(f"{name}.{part}")
        if line is not None:
            seen[f"{part}_length"], seen[ratio] = line[0], -line[1][:, 0]
            text = (
                f"{ratio.replace('_', ' ')} in roll: {part} compression over opposed wheel travel"
            )
            own[f"{ratio}_roll"] = -side * line[1][:, 1], "1", text, _ROWS[ratio].sign
    for row in _ROWS.values():
        if row.name in seen:
            label = f"{name}: {row.long_name}"
            variables.add(f"{name}.{row.name}", seen[row.name], row.unit, label, row.sign)
    gain = side * -travel_by_roll(*on_road.grounds("opposed"))
    turned = opposed.wheel.rows_seen_from(side)
    top, left = "positive: top outward", "positive: about +z"
    own |= {
        "spin": (
            seen["spin"],
            "rad",
            "rotation of the wheel carrier about the wheel's axis",
            "positive: as in rolling forward",
        ),
        "camber_to_ground": (-np.arcsin(together.lean), "rad", "camber angle to the road", top),
        "steer_to_ground": (
            side * together.toe_out,
            "rad",
            "steer angle along the road",
            f"{left}, a left turn",
        ),
        "roll_steer": (gain * turned["bump_steer"], "1", "roll steer", left),
        "roll_camber": (gain * turned["camber_gain"], "1", "roll camber", top),
    }
    if axle.is_ideal:
        k = int(side < 0.0)
        both, other = poses.force_rates[:, k, k], poses.force_rates[:, k, 1 - k]
        own |= {
            "wheel_force": (
                poses.forces[:, k],
                "N",
                "force of springs, bar and beam at the wheel centre",
                "positive: pushes the wheel down",
            ),
            "wheel_rate": (
                both + other,
                "N/m",
                "wheel rate at the wheel centre, both wheels together",
                _STIFF,
            ),
            "wheel_rate_roll": (
                both - other,
                "N/m",
                "wheel rate at the wheel centre, wheels opposed",
                _STIFF,
            ),
        }
    for row_name, (value, unit, text, sign) in own.items():
        variables.add(f"{name}.{row_name}", value, unit, f"{name}: {text}", sign)


def _add_axle(variables: AxleVariables, on_road: _OnRoad) -> None:
    """Add shifts and turns of the axle against the body."""
    left, right = (ground.wheel for ground in on_road.grounds("together"))
    axles = "from design, against the body"
    start = [wheel[1] for wheel in on_road.poses.axle.wheels]
    middle = 0.5 * (left.centre + right.centre * [1.0, -1.0, 1.0]) - 0.5 * (start[0] + start[1])
    across = left.centre - right.centre * [1.0, -1.0, 1.0]
    steer = 0.5 * (left.rows["steer"] - right.rows["steer"])
    values = variables.values
    roll_steer = 0.5 * (values["left.roll_steer"] + values["right.roll_steer"])
    rows = {
        "lateral_shift": (
            middle[:, 1],
            "m",
            f"middle of the wheel centres, {axles}",
            "positive: to the left",
        ),
        "longitudinal_shift": (
            middle[:, 0],
            "m",
            f"middle of the wheel centres, {axles}",
            "positive: forward",
        ),
        "axle_steer": (
            steer,
            "rad",
            "mean steer angle of both wheels against the body",
            "positive: about +z, a left turn",
        ),
        "axle_roll": (
            np.arctan2(across[:, 2], across[:, 1]),
            "rad",
            "roll angle of the line of wheel centres against the body",
            _ROLLS,
        ),
        "roll_steer": (
            roll_steer,
            "1",
            "roll steer of the axle, mean of both wheels",
            "positive: about +z as the left side rises",
        ),
        "roll_axis_inclination": (
            -np.arctan(roll_steer),
            "rad",
            "inclination of the axis about which the axle rolls",
            "positive: rises forward; a rear axle then oversteers in roll",
        ),
    }
    for name, row in rows.items():
        variables.add(name, *row)


def _add_road(variables: AxleVariables, on_road: _OnRoad) -> None:
    """Add track, roll centre and jacking, by virtual work on the points that touch the road.

    While the road turns about its line in the centre plane of the body, the links move the contact points sideways. The
    roll centre's height is their mean movement over the turn: a lateral force at this height does not roll the body.
    """
    sides = list(_SIDES.items())
    grounds = on_road.grounds("together")
    normal = grounds[0].normal
    forward = np.array([1.0, 0.0, 0.0]) - normal[:, :1] * normal
    leftward = np.cross(normal, forward / np.linalg.norm(forward, axis=1)[:, None])
    points = [g.contact * [1.0, side, 1.0] for g, (_, side) in zip(grounds, sides, strict=True)]
    along = [(point * leftward).sum(axis=1) for point in points]
    track = along[0] - along[1]
    speeds = [
        [on_road.poses.carried(k, point, motion) for motion in MOTIONS]
        for k, point in enumerate(points)
    ]
    (a, b), (c, d) = [[(v * normal).sum(axis=1) for v in row] for row in speeds]
    sideways = [sum((row[m] * leftward).sum(axis=1) for row in speeds) / 2.0 for m in range(2)]
    size = a * d - b * c

    def mean_movement(left: Array | float, right: Array | float) -> Array:
        """Mean lateral movement of the contact points for normal movements of the road under them."""
        up, apart = (d * left - b * right) / size, (a * right - c * left) / size
        return np.asarray(up * sideways[0] + apart * sideways[1])

    x = 0.5 * (points[0][:, 0] + points[1][:, 0])
    z = (grounds[0].height - normal[:, 0] * x) / normal[:, 2]
    middle = leftward[:, 0] * x + leftward[:, 2] * z
    height = mean_movement(along[0] - middle, along[1] - middle)
    above = "positive: up"
    variables.add("track", track, "m", "track: distance of the contact points", "never negative")
    text = "roll centre height above the road, force-based"
    variables.add("roll_centre_height", height, "m", text, above)
    text = "jacking: lift of the body over the lateral force of the road on both wheels"
    lift = "positive: a force to the left lifts the body"
    variables.add("jacking", -mean_movement(1.0, 1.0), "1", text, lift)


def _add_shares(
    variables: AxleVariables, axle: SweptAxle, on_road: _OnRoad, vehicle: AxleLayout
) -> None:
    """Add anti-effects, and the change of the wheelbase.

    Brakes and the differential of a solid axle are parts of it, so their torques act on it.
    """
    wheels = [ground.wheel.rows for ground in on_road.grounds("together")]
    rise = sum(rows["patch_rise"] for rows in wheels)
    contact, centre = (
        sum(rows[name] * rows["patch_rise"] for rows in wheels) / rise
        for name in ("contact_patch_recession", "wheel_centre_recession")
    )
    if isinstance(axle.rig, SolidAxle):
        centre = contact
    for name, share in shares(vehicle, np.asarray(contact), np.asarray(centre)).items():
        variables.add(name, share, "1", ANTI_EFFECTS[vehicle.axle, name], ANTI_SIGN)
    longer = variables.values["longitudinal_shift"] * (1.0 if vehicle.axle == "front" else -1.0)
    variables.add("wheelbase_change", longer, "m", "change of the wheelbase", "positive: longer")
