"""Steering effort: rack force, pinion and handwheel torque from the road's forces on both wheels."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kinematics.axle import AxleVariables, TwoWheelAxle, handwheel_rows
from jounce.kinematics.column import handwheel_angle, rack_travel
from jounce.kinematics.loads import ContactLoad, balance_poses, vector_forces
from jounce.kinematics.model import check_corner, check_rack
from jounce.kinematics.sweeps import Values, prepare_sweep, sweep_values
from jounce.parts import Corner, Rig

if TYPE_CHECKING:
    import xarray as xr


def steering_effort(
    rig: Rig, left: ContactLoad, right: ContactLoad, rack: Values = 0.0, travel: float | str = 0.0
) -> xr.Dataset:
    """Compute rack force and handwheel torque for loads of the road on both wheels.

    Parts are rigid and massless; joints, rack and column have no friction; anti-roll bar and third spring are
    neglected. Springs have the force that the loads require.

    Parameters
    ----------
    rig : Rig
        A corner with a rack; the other side is its mirror image.
    left, right : ContactLoad
        Loads of the road on each wheel, N and N m, ground axes.
    rack : float, str or array_like, shape (n,)
        Travel of the rack, m, positive to the left, monotonic.
    travel : float or str
        Vertical travel of both wheel centres from design, m, bump positive.

    Returns
    -------
    xarray.Dataset
        On ``rack_travel`` (m): ``rack_force`` (N, of both wheels on the rack, positive to the left),
        ``left.rack_force`` and ``right.rack_force``; with ``steering.rack_ratio`` also ``pinion_torque`` and
        ``handwheel_torque`` (N m, holding torques, positive to the left) and the rows of the handwheel.

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints or rack, or values are not monotonic.
    SimulationError
        If no pose can be reached.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("formula-student-front").with_changes({"steering": {"rack_ratio": "13 mm/rad"}})
    >>> side = jn.ContactLoad(lateral_force="1 kN", vertical_force="1 kN")
    >>> effort = jn.steering_effort(rig, side, side)
    >>> abs(round(float(effort["handwheel_torque"][0] - 0.013 * -effort["rack_force"][0]), 9))   # N m, no column
    0.0
    """
    corner, racks = check_corner(rig), sweep_values(rack, "rack travel")
    check_rack(corner)
    corner = corner if corner.side == "left" else corner.mirrored()
    height = to_si(travel, "m", where="wheel travel")
    variables = AxleVariables(
        "rack_travel", racks, "m", "travel of the steering rack", "positive: to the left (+y)"
    )
    axle, to_left = TwoWheelAxle(corner), "positive: to the left"
    sides = ((corner, left), (corner.mirrored(), right))
    forces = [_rack_force(axle, side, load, racks, height) for side, load in sides]
    total = forces[0] + forces[1]
    variables.add("rack_force", total, "N", "force of both wheels on the rack", to_left)
    for name, force in zip(("left", "right"), forces, strict=True):
        variables.add(
            f"{name}.rack_force", force, "N", f"{name}: force of the wheel on the rack", to_left
        )
    steering = getattr(corner, "steering", None)
    if steering is not None and steering.rack_ratio is not None:
        slope = rack_travel(steering, handwheel_angle(steering, racks))[1]
        variables.add(
            "pinion_torque",
            -total * steering.rack_ratio,
            "N*m",
            "torque that holds the pinion",
            to_left,
        )
        variables.add(
            "handwheel_torque", -total * slope, "N*m", "torque that holds the handwheel", to_left
        )
        handwheel_rows(
            variables, axle, racks, *(axle.wheel(sign, height, racks) for sign in (1.0, -1.0))
        )
    return variables.dataset(np.isfinite(total), axle.ends, corner)


def _rack_force(
    axle: TwoWheelAxle, rig: Corner, load: ContactLoad, racks: Array, travel: float
) -> Array:
    """Force of a wheel on the rack, N, to the left; NaN at unreachable rack travels, which the axle records."""
    sweep = prepare_sweep(rig, travel, racks)
    rows, joints = balance_poses(sweep, load)
    axle.note(sweep)
    forces = vector_forces(joints, joints.balance.solve())
    inner = "tie_rod_inner" if "tie_rod_inner" in forces else "link_5_inner"
    force = np.full(len(racks), np.nan)
    reached = np.argmin(np.abs(racks - rows["rack_travel"][:, None]), axis=1)
    force[reached] = forces[inner][:, 1]
    return force
