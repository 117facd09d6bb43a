"""An axle that steers: both wheels over the travel of one rack, and how they share the turn."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.units import to_si
from jounce.kinematics.axle import Axle, AxleVariables, WheelRows
from jounce.kinematics.grids import Values, sweep_values
from jounce.kinematics.layout import AxleLayout
from jounce.kinematics.model import check_corner, has_rack
from jounce.kinematics.reach import no_pose
from jounce.parts import Rig

if TYPE_CHECKING:
    import xarray as xr

_STRAIGHT = 1e-6  # rad: turns below it share nothing


def sweep_steering(
    rig: Rig, rack: Values, travel: float | str = 0.0, *, vehicle: AxleLayout | None = None
) -> xr.Dataset:
    """Steer an axle of a corner and its mirror image by one rack.

    Parameters
    ----------
    rig : Rig
        A corner with a tie rod (or toe link); the other side is its mirror image.
    rack : float, str or array_like, shape (n,)
        Travel of the rack, m, positive to the left, ascending; or text, ``"-20 mm:20 mm:5 mm"``.
    travel : float or str
        Vertical travel of both wheel centres from design, m, bump positive.
    vehicle : AxleLayout, optional
        Its wheelbase adds ``ackermann`` and ``turning_radius``.

    Returns
    -------
    xarray.Dataset
        On ``rack_travel`` (m): ``left.<quantity>`` and ``right.<quantity>`` of the catalogue; ``mean_steer`` (rad,
        about +z), ``steer_difference`` (rad, inner minus outer wheel), ``track`` (m, between the contact points). With
        a vehicle ``ackermann`` [1], the difference as a share of that with which both wheels roll about one centre on
        the rear axle (1: Ackermann, 0: parallel, NaN straight ahead), and ``turning_radius`` (m, of that centre from
        the middle of the rear axle, positive to the left).

    Raises
    ------
    DescriptionError
        For a rig without hardpoints or rack, or values that do not ascend.
    SimulationError
        When no pose at all can be reached.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.AxleLayout(axle="front", wheelbase="2.7 m", centre_of_mass_height="0.55 m", brake_share=0.6)
    >>> steered = jn.sweep_steering(jn.load("reference-double-wishbone"), [-0.02, 0.0, 0.02], vehicle=car)
    >>> bool(steered["mean_steer"][0] > 0.0)
    True
    """
    corner, racks = check_corner(rig), sweep_values(rack, "rack travel")
    if not has_rack(corner):
        raise DescriptionError("no rack moves this wheel", where="rack travel", allowed="a corner with a tie rod")
    axle = Axle(corner)
    lifted = to_si(travel, "m", where="wheel travel")
    left, right = (axle.wheel(side, lifted, racks) for side in (1.0, -1.0))
    kept = np.isfinite(left.rows["steer"] + right.rows["steer"])
    if not kept.any():
        raise no_pose(axle.ends)
    found = AxleVariables("rack_travel", racks, "m", "travel of the steering rack", "positive: to the left (+y)")
    found.add_wheel(axle, left, "left", 1.0)
    found.add_wheel(axle, right, "right", -1.0)
    _add_rows(found, left, right, vehicle)
    return found.dataset(kept, axle, corner)


def _add_rows(found: AxleVariables, left: WheelRows, right: WheelRows, vehicle: AxleLayout | None) -> None:
    one, other = left.rows["steer"], -right.rows["steer"]
    mean = 0.5 * (one + other)
    difference = one - other  # the inner wheel is the left one in left turns, where both angles are positive
    track = left.rows["contact_point_y"] + right.rows["contact_point_y"]
    found.add("mean_steer", mean, "rad", "mean steer angle of both wheels", "about +z, a left turn")
    found.add("steer_difference", difference, "rad", "steer of the inner minus that of the outer wheel", "toe-out")
    found.add("track", track, "m", "distance of the contact points", "never negative")
    if vehicle is None:
        return
    inner = np.abs(np.where(mean > 0.0, one, other))
    turned = np.abs(mean) > _STRAIGHT
    with np.errstate(divide="ignore", invalid="ignore"):
        pivots = track - left.rows["scrub_radius"] - right.rows["scrub_radius"]
        ideal = inner - np.arctan(1.0 / (1.0 / np.tan(inner) + pivots / vehicle.wheelbase))
        share = np.where(turned, difference / ideal, np.nan)
        radius = np.where(turned, vehicle.wheelbase / np.tan(mean), np.inf)
    found.add("ackermann", share, "1", "steer difference over that of a common turning centre", "as Ackermann")
    found.add("turning_radius", radius, "m", "turning centre from the middle of the rear axle", "left")
