"""An axle at any pair of wheel travels, or any attitude of the body over a plane road; the sides may differ."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.types import Array
from jounce.kinematics.axle import (
    AxleVariables,
    Ground,
    TwoWheelAxle,
    WheelRows,
    add_axle_rows,
    add_steering,
    check_roll,
    handwheel_rows,
)
from jounce.kinematics.column import rack_travel, steering_of
from jounce.kinematics.dependent import no_rack, poses_of_axle
from jounce.kinematics.model import check_corner, check_rack
from jounce.kinematics.sweeps import AxleLayout, Values, no_pose, path_values
from jounce.parts import Corner, DependentAxle, Rig

if TYPE_CHECKING:
    import xarray as xr

_ITERATIONS, _LEVEL = 60, 1e-12  # m: rounding of a height
_STEP = (
    0.03  # m of travel in one iteration: two of them span the usual travel, so none overshoots it
)


def sweep_axle(
    rig: Rig,
    *,
    right: Rig | None = None,
    left_travel: Values | None = None,
    right_travel: Values | None = None,
    heave: Values | None = None,
    roll: Values | None = None,
    pitch: Values | None = None,
    rack: Values | None = None,
    handwheel: Values | None = None,
    vehicle: AxleLayout | None = None,
) -> xr.Dataset:
    """Sweep both wheels of an axle pose by pose, for pairs of travels or for attitudes of the body.

    The road is a plane under both contact points; tyre deflections are neglected. Given travels determine the attitude
    of the body; with ``heave`` and ``roll`` each wheel travels until it touches the road. Values are given pose by
    pose; a single value applies to all poses.

    Parameters
    ----------
    rig : Rig
        The left corner, a right one being mirrored; or a solid axle or a twist beam, which has both wheels.
    right : Rig, optional
        The right corner, unless it is the mirror image of the left one.
    left_travel, right_travel : float, str or array_like, shape (n,), optional
        Vertical travel of each wheel centre from design, m, bump positive; 0 by default.
    heave : float, str or array_like, shape (n,), optional
        Rise of the body above the road in the middle of the axle, m, from design; instead of the travels.
    roll : float, str or array_like, shape (n,), optional
        Roll angle of the body, rad, about +x (left side up); instead of the travels.
    pitch : float, str or array_like, shape (n,), optional
        Pitch angle of the body, rad, about +y (nose down), about the middle of the axle; before the roll.
    rack : float, str or array_like, shape (n,), optional
        Travel of the rack, m, positive to the left; 0 by default.
    handwheel : float, str or array_like, shape (n,), optional
        Angle of the handwheel, rad, positive to the left, instead of ``rack``; needs ``steering.column`` and
        ``steering.rack_ratio`` of the left corner.
    vehicle : AxleLayout, optional
        Adds Ackermann and turn diameters as in :func:`sweep_steering`.

    Returns
    -------
    xarray.Dataset
        On ``pose``: ``left.<quantity>`` and ``right.<quantity>`` of the catalogue (against the body) with
        ``camber_to_ground`` and ``steer_to_ground`` (rad); ``heave`` (m), ``roll_angle``, ``pitch_angle`` (rad),
        ``track``, ``roll_centre_height``, ``roll_centre_y`` (m), steer angles as in :func:`sweep_steering`; twist and
        torque of the anti-roll bar, length and force of the third spring, and ``left.axle_force``,
        ``right.axle_force`` (N, of all springs at the wheel centre). NaN out of reach.

    Raises
    ------
    DescriptionError
        If rigs do not form an axle, travels and an attitude are both given, or values have different lengths.
    SimulationError
        If no pose can be reached.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("formula-student-front")
    >>> poses = jn.sweep_axle(rig, heave="-10 mm", roll=["0 deg", "1 deg"], pitch="0.5 deg")
    >>> [round(1e3 * float(travel), 1) for travel in poses["left.wheel_travel"]]   # mm
    [10.0, -0.6]
    """
    given = {
        "left travel": (left_travel, "m"),
        "right travel": (right_travel, "m"),
        "heave": (heave, "m"),
        "roll": (roll, "rad"),
        "pitch": (pitch, "rad"),
        "rack travel": (rack, "m"),
        "handwheel": (handwheel, "rad"),
    }
    read = {
        name: path_values(value, name, unit)
        for name, (value, unit) in given.items()
        if value is not None
    }
    travelled, placed = ({name for name in names if name in read} for names in (_TRAVELS, _PLACES))
    if travelled and placed:
        raise DescriptionError(
            "wheel travels and a body attitude are both given",
            where="jounce sweep of an axle",
            found=", ".join(sorted(travelled | placed)),
            allowed="left and right travel, or heave and roll",
        )
    if "rack travel" in read and "handwheel" in read:
        raise DescriptionError(
            "a rack travel and a handwheel angle are both given",
            where="handwheel",
            hint="Give only one of them.",
        )
    check_roll(read.get("roll", np.zeros(1)), "roll")
    check_roll(read.get("pitch", np.zeros(1)), "pitch")
    counts = {len(values) for values in read.values() if len(values) > 1}
    if len(counts) > 1:
        counts_text = ", ".join(f"{name}: {len(values)}" for name, values in read.items())
        raise DescriptionError(
            "different numbers of values", where="sweep of an axle", found=counts_text
        )
    count = max(counts, default=1)
    at = {name: np.broadcast_to(read.get(name, np.zeros(1)), (count,)).copy() for name in given}
    if isinstance(rig, DependentAxle):
        steered = bool(np.any(at["rack travel"])) or handwheel is not None
        no_rack(rig, steered, "handwheel" if handwheel is not None else "rack")
        if right is not None:
            raise DescriptionError(
                "a dependent axle has both wheels", where="right", hint="Leave it out."
            )
        return poses_of_axle(rig, at, vehicle, placed=bool(placed))
    corner, other = _pair(rig, right)
    if handwheel is not None:
        at["rack travel"] = rack_travel(steering_of(corner), at["handwheel"])[0]
    if np.any(at["rack travel"] != 0.0):
        check_rack(corner, "0, or a corner with a tie rod")
    axle = TwoWheelAxle(corner, right=other)
    pose = _on_road(axle, at) if placed else _on_wheels(axle, at)
    return _dataset(axle, pose, at, vehicle)


_TRAVELS = ("left travel", "right travel")
_PLACES = ("heave", "roll")


def _pair(rig: Rig, right: Rig | None) -> tuple[Corner, Corner | None]:
    """Return the left corner, and the right one if it is different."""
    corner = check_corner(rig)
    corner = corner if corner.side == "left" else corner.mirrored()
    if right is None:
        return corner, None
    other = check_corner(right)
    check_pair_of_corners(corner, other)
    return corner, other


def check_pair_of_corners(left: Corner, right: Corner, where: str = "right") -> None:
    """Raise an error for corners that are not the two sides of one axle."""
    if right.side != "right":
        raise DescriptionError(
            "not a right corner", where=where, found=f'side = "{right.side}"', allowed='"right"'
        )
    for name in ("anti_roll_bar", "third_spring"):
        left_end, right_end = getattr(left, name), getattr(right, name)
        if (left_end is None) != (right_end is None) or getattr(left_end, "kind", "") != getattr(
            right_end, "kind", ""
        ):
            raise DescriptionError(
                "both corners of an axle need this table",
                where=name,
                allowed="a table in both files, or in none",
            )


@dataclass(frozen=True)
class _Pose:
    left: Ground
    right: Ground
    heave: Array


class _Middle:
    """Middle of the axle at design, the zero of heave: x of the wheel centres, y 0, z of the contact points."""

    def __init__(self, axle: TwoWheelAxle) -> None:
        at = [axle.wheel(side, np.zeros(1), 0.0) for side in (1.0, -1.0)]
        x, z = (
            np.mean([float(wheel.rows[f"{of}"][0]) for wheel in at])
            for of in ("wheel_centre_x", "contact_point_z")
        )
        self.place = np.array([x, 0.0, z])

    def height(self, ground: Ground) -> Array:
        """Height of the middle along the normal of the road, m."""
        return np.asarray(ground.normal @ self.place)


def _on_road(axle: TwoWheelAxle, at: dict[str, Array]) -> _Pose:
    """Move each wheel until it touches the road given by heave, roll and pitch of the body."""
    middle = _Middle(axle)
    grounds = []
    for side in (1.0, -1.0):
        half_track = abs(float(axle.of(side).hardpoints.wheel_centre[1]))
        travel = -at["heave"] - side * half_track * np.tan(at["roll"])
        for _ in range(_ITERATIONS):
            ground = Ground(
                axle.wheel(side, travel, at["rack travel"]), at["roll"], side, at["pitch"]
            )
            gap = ground.height - (middle.height(ground) - at["heave"])
            if np.nanmax(np.abs(gap), initial=0.0) < _LEVEL:
                break
            travel = travel - np.clip(gap / ground.height_by_travel, -_STEP, _STEP)
        grounds.append(ground)
    return _Pose(grounds[0], grounds[1], at["heave"])


def _on_wheels(axle: TwoWheelAxle, at: dict[str, Array]) -> _Pose:
    """Place the road under both wheels."""
    wheels = [
        axle.wheel(side, at[f"{name} travel"], at["rack travel"])
        for side, name in ((1.0, "left"), (-1.0, "right"))
    ]
    roll = np.zeros_like(at["roll"])
    for _ in range(_ITERATIONS):
        left, right = (
            Ground(wheel, roll, side, at["pitch"])
            for wheel, side in zip(wheels, (1.0, -1.0), strict=True)
        )
        off = left.height - right.height
        if np.nanmax(np.abs(off), initial=0.0) < _LEVEL:
            break
        roll = roll - off / (left.height_by_roll - right.height_by_roll)
    return _Pose(left, right, _Middle(axle).height(left) - left.height)


def _dataset(
    axle: TwoWheelAxle, pose: _Pose, at: dict[str, Array], vehicle: AxleLayout | None
) -> xr.Dataset:
    left, right = pose.left, pose.right
    reached = np.isfinite(left.height + right.height)
    if not reached.any():
        raise no_pose(axle.ends)
    count = len(reached)
    variables = AxleVariables("pose", np.arange(float(count)), "1", "pose", "in the order given")
    for name, ground in (("left", left), ("right", right)):
        variables.add_wheel(axle, ground.wheel, name, ground.side)
        lean, heading = ground.lean, ground.side * ground.toe_out
        variables.add(
            f"{name}.camber_to_ground",
            -np.arcsin(lean),
            "rad",
            "camber angle to the road",
            "positive: top outward",
        )
        text = "steer angle along the road, against the body's x axis seen from above it"
        variables.add(
            f"{name}.steer_to_ground", heading, "rad", text, "positive: about +z, a left turn"
        )
    up, left_up = "positive: the body rises", "positive: about +x, left side up"
    variables.add(
        "heave",
        np.where(reached, pose.heave, np.nan),
        "m",
        "rise of the body above the road, middle of the axle",
        up,
    )
    variables.add(
        "roll_angle", np.where(reached, left.roll, np.nan), "rad", "roll angle of the body", left_up
    )
    variables.add(
        "pitch_angle",
        at["pitch"],
        "rad",
        "pitch angle of the body",
        "positive: about +y, nose down",
    )
    add_axle_rows(variables, left, right)
    add_steering(variables, left.wheel, right.wheel, vehicle, axle)
    handwheel_rows(variables, axle, at["rack travel"], left.wheel, right.wheel)
    _add_forces(variables, axle, left.wheel, right.wheel)
    return variables.dataset(np.ones(count, dtype=bool), axle.ends, axle.rig)


def _add_forces(
    variables: AxleVariables, axle: TwoWheelAxle, left: WheelRows, right: WheelRows
) -> None:
    """Forces of all springs at both wheel centres, and the connections."""
    connection = axle.connection(left, right)
    for name, (value, unit, text, sign) in connection.rows.items():
        variables.add(name, value, unit, text, sign)
    for name, wheel, force in (
        ("left", left, connection.forces[0]),
        ("right", right, connection.forces[1]),
    ):
        if "wheel_force" in wheel.rows:
            text = f"{name}: force of all springs at the wheel centre"
            variables.add(
                f"{name}.axle_force",
                wheel.rows["wheel_force"] + force,
                "N",
                text,
                "positive: pushes the wheel down",
            )
