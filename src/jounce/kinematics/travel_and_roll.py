"""Sweeps over travel and roll: the kind of rig, a corner or a dependent axle, decides how."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.units import to_si
from jounce.kinematics.axle import check_roll, roll_of_corner
from jounce.kinematics.dependent import no_rack, roll_of_axle, travel_of_axle
from jounce.kinematics.sweeps import AxleLayout, Values, sweep_values, travel_of_corner
from jounce.parts import DependentAxle, Rig

if TYPE_CHECKING:
    import xarray as xr


def sweep_travel(
    rig: Rig,
    bump: Values,
    rack: Values | None = None,
    *,
    vehicle: AxleLayout | None = None,
    points: bool = False,
) -> xr.Dataset:
    """Sweep a corner, or both wheels of a dependent axle, over wheel travel; return all kinematic quantities.

    Poses are exact to rounding; derivatives are computed from the loop equations, not from differences. Masses, gravity
    and tyres have no effect: travel is that of the wheel centre relative to the body, from the hardpoints as given.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints, a solid axle or a twist beam.
    bump : float, str or array_like, shape (n,)
        Vertical travel of the wheel centre from design, m, bump positive, monotonic; or text, ``"-80 mm:80 mm:4 mm"``.
    rack : float, str or array_like, shape (m,), optional
        Travel of the rack, m, positive to the left, or text; the description's own (or 0) by default. Several values
        give every pair of travel and rack.
    vehicle : AxleLayout, optional
        Adds ``anti_dive`` (front; of a driven one also ``anti_lift``), or ``anti_lift`` and ``anti_squat`` (rear) [1];
        with its mass also ``dive_per_g``, ``lift_per_g``, ``squat_per_g`` (m).
    points : bool
        Whether to add the position of every hardpoint and of the contact point as ``<name>.x``, ``.y``, ``.z`` (m,
        ground axes).

    Returns
    -------
    xarray.Dataset
        One variable for each quantity on ``wheel_travel`` (m), and ``rack_travel`` (m) if several were given; each with
        ``units``, ``long_name``, ``sign`` and ``clause``. ``attrs["status"]`` is "completed", or "end_of_travel" if the
        mechanism could not move further: poses beyond are omitted (NaN for a pair out of reach), and
        ``attrs["stopped"]`` describes where and why. ``attrs["findings"]`` reports toggles: parts or spring that move
        three times as fast as at the start of the sweep.

    A dependent axle has ``left.<quantity>`` and ``right.<quantity>``, and as an axle ``lateral_shift``,
    ``longitudinal_shift``, ``track`` and ``roll_centre_height`` (m), ``axle_steer``, ``axle_roll`` and
    ``roll_axis_inclination`` (rad), ``roll_steer`` and ``jacking`` [1]; with a vehicle also ``wheelbase_change`` (m).
    Slopes are those of both wheels together, ``roll_...`` those of body roll.

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints or no rack to move, or values are not monotonic.
    SimulationError
        If no pose can be reached.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> sweep = jn.sweep_travel(jn.load("reference-double-wishbone"), np.linspace(-0.08, 0.08, 41))
    >>> round(float(np.degrees(sweep["camber"].sel(wheel_travel=0.04, method="nearest"))), 4)
    -2.3572
    """
    if isinstance(rig, DependentAxle):
        no_rack(
            rig, rack is not None and bool(np.any(sweep_values(rack, "rack travel"))), "rack travel"
        )
        if points:
            raise DescriptionError(
                "hardpoints are not available for a sweep of an axle",
                where="points",
                hint="Leave it out.",
            )
        return travel_of_axle(rig, sweep_values(bump, "wheel travel"), vehicle)
    return travel_of_corner(rig, bump, rack, vehicle, points=points)


def sweep_roll(rig: Rig, roll: Values, rack: float | str = 0.0) -> xr.Dataset:
    """Sweep the roll angle of the body on an axle on a plane road: a corner and its mirror image, or a dependent axle.

    The wheels travel by the same amount in opposite directions, so that both contact points stay on the road. Tyre
    deflections are neglected.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints, whose other side is its mirror image; a solid axle or a twist beam.
    roll : float, str or array_like, shape (n,)
        Roll angle of the body, rad, positive about +x (left side up), monotonic; or text, ``"-4 deg:4 deg:1 deg"``.
    rack : float or str
        Travel of the rack, m, positive to the left.

    Returns
    -------
    xarray.Dataset
        On ``roll_angle`` (rad): ``left.<quantity>`` and ``right.<quantity>`` of the catalogue (against the body), with
        ``camber_to_ground`` (rad), ``roll_steer`` and ``roll_camber`` (rad/rad); ``track`` (m), ``roll_centre_height``
        and ``roll_centre_y`` (m, above the road and left of the middle between the contact points), ``roll_moment``
        (N m, of springs and anti-roll bar, against the roll) and ``roll_stiffness`` (N m/rad). Attributes, and
        rows of a dependent axle, as in :func:`sweep_travel`.

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints, or angles are not monotonic or exceed 1.2 rad.
    SimulationError
        If no pose can be reached.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> rolled = jn.sweep_roll(jn.load("reference-double-wishbone"), np.radians([-2.0, 0.0, 2.0]))
    >>> bool(rolled["left.wheel_travel"][2] < 0.0 < rolled["right.wheel_travel"][2])
    True
    """
    angles, at = sweep_values(roll, "roll", "rad"), to_si(rack, "m", where="rack travel")
    check_roll(angles, "roll")
    if isinstance(rig, DependentAxle):
        no_rack(rig, at != 0.0, "rack travel")
        return roll_of_axle(rig, angles)
    return roll_of_corner(rig, angles, at)
