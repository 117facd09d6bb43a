"""Sweeps of one corner: wheel travel, rack, or any pair of both."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kernel.poses import REACHED, Found, Walk, Work, space_for, walk_poses
from jounce.kinematics import layout as around
from jounce.kinematics.grids import Grid, Values, grid, sweep_values
from jounce.kinematics.layout import AxleLayout
from jounce.kinematics.model import KinematicModel, check_corner, has_rack, kinematic_model
from jounce.kinematics.reach import End, ends_of_travel, no_pose, told
from jounce.parts import Corner, Rig

if TYPE_CHECKING:
    import xarray as xr

_DIMENSIONS = ("wheel_travel", "rack_travel")


@dataclass(frozen=True)
class PreparedSweep:
    """A sweep with everything laid out: ``run`` only computes, as often as wanted.

    Attributes
    ----------
    rig : Corner
        The corner.
    model : KinematicModel
        Its model.
    layout : Grid
        Order of the poses.
    walk, found, work
        Arrays of the walk (see ``kernel.poses``).
    """

    rig: Corner
    model: KinematicModel
    layout: Grid
    walk: Walk
    found: Found
    work: Work

    def run(self) -> Array:
        """Compute all poses; give the quantities, shape (rows, travels, racks), NaN where out of reach."""
        walk_poses(self.walk, self.found, self.work)
        return self.in_place(self.found.outputs, self.found.outcome == REACHED)

    def in_place(self, values: Array, reached: NDArray[np.bool_]) -> Array:
        """Bring values of the walk, shape (rows, targets), into the order of the grid."""
        ordered = np.full((len(values), len(self.layout.place)), np.nan)
        ordered[:, self.layout.place[reached]] = values[:, reached]
        return ordered.reshape(len(values), *self.layout.shape)

    def points(self) -> dict[str, Array]:
        """Places of all points in the last run, ``<name>.x`` and so on, m, shape (travels, racks)."""
        names, native = self.model.point_names, self.model.points
        reached = self.found.outcome == REACHED
        places = np.full((3 * len(names), len(reached)), np.nan)
        for i in np.flatnonzero(reached):
            at = self.found.poses[:, i], self.found.inputs[:, i], self.walk.p, np.zeros(1)
            places[:, i] = native.evaluate("output", (3 * len(names),), *at)
        keys = [f"{name}.{axis}" for name in names for axis in "xyz"]
        return dict(zip(keys, self.in_place(places, reached), strict=True))

    def ends(self) -> list[End]:
        """Where the last run had to stop."""
        return ends_of_travel(self.model, self.walk, self.layout, self.found)


def prepare_sweep(rig: Rig, travel: Values, rack: Values | None = None) -> PreparedSweep:
    """Lay out a sweep of a corner.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints.
    travel : float or array_like, shape (n,)
        Vertical travel of the wheel centre from design, m, bump positive, ascending.
    rack : float or array_like, shape (m,), optional
        Travel of the rack, m, positive to the left, ascending; the description's own by default.

    Raises
    ------
    DescriptionError
        For a rig without hardpoints, a rack that moves nothing, or values that do not ascend.

    Examples
    --------
    >>> import jounce as jn
    >>> sweep = prepare_sweep(jn.load("reference-double-wishbone"), [-0.04, 0.0, 0.04])
    >>> sweep.run().shape[1:]
    (3, 1)
    """
    corner = check_corner(rig)
    model = kinematic_model(corner)
    layout = grid(sweep_values(travel, "wheel travel"), sweep_values(_rack_of(corner, rack), "rack travel"))
    tracks = len(model.tracks)
    walk = Walk(
        model.native.address["pose"],
        model.native.address["output"],
        model.parameter_values(corner),
        model.start,
        np.zeros(tracks),
        np.ascontiguousarray(layout.targets[:, :tracks]),
        layout.before,
    )
    return PreparedSweep(corner, model, layout, walk, *space_for(walk, len(model.rows)))


def _rack_of(corner: Corner, rack: Values | None) -> Values:
    if rack is None:
        steering = getattr(corner, "steering", None)
        return 0.0 if steering is None else float(steering.rack_travel)
    if not has_rack(corner) and np.any(sweep_values(rack, "rack travel") != 0.0):
        raise DescriptionError(
            "no rack moves this wheel",
            where="rack travel",
            found=f'model = "{getattr(corner, "model", "")}"',
            allowed="0, or a corner with a tie rod",
        )
    return rack


def sweep_travel(
    rig: Rig,
    bump: Values,
    rack: Values | None = None,
    *,
    vehicle: AxleLayout | None = None,
    points: bool = False,
) -> xr.Dataset:
    """Sweep the wheel of a corner up and down: the whole catalogue of kinematic quantities at each pose.

    Poses are exact to rounding and derivatives come from the joints' equations, not from differences. Masses, gravity
    and tyres do not matter: travel is that of the wheel centre against the body, from the hardpoints as given.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints.
    bump : float, str or array_like, shape (n,)
        Vertical travel of the wheel centre from design, m, bump positive, ascending; or text, ``"-80 mm:80 mm:4 mm"``.
    rack : float, str or array_like, shape (m,), optional
        Travel of the rack, m, positive to the left, or text; the description's own (or 0) by default. Several values
        give every pair of travel and rack.
    vehicle : AxleLayout, optional
        Adds ``anti_dive`` (front), or ``anti_lift`` and ``anti_squat`` (rear) [1].
    points : bool
        Adds the place of every hardpoint and of the contact point as ``<name>.x``, ``.y``, ``.z`` (m, ground axes).

    Returns
    -------
    xarray.Dataset
        One variable a quantity on ``wheel_travel`` (m), and ``rack_travel`` (m) where several were given; each with
        ``units``, ``long_name``, ``sign`` and ``clause``. ``attrs["status"]`` is "completed", or "end_of_travel" when
        the mechanism could not go on: poses beyond are left out (NaN where a pair is out of reach) and
        ``attrs["stopped"]`` says where and why.

    Raises
    ------
    DescriptionError
        For a rig without hardpoints, a rack that moves nothing, or values that do not ascend.
    SimulationError
        When no pose at all can be reached.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> sweep = jn.sweep_travel(jn.load("reference-double-wishbone"), np.linspace(-0.08, 0.08, 41))
    >>> round(float(np.degrees(sweep["camber"].sel(wheel_travel=0.04, method="nearest"))), 4)
    -2.3572
    """
    return _swept(
        prepare_sweep(rig, bump, rack),
        rack is not None and (np.ndim(rack) > 0 or (isinstance(rack, str) and ":" in rack)),
        True,
        vehicle,
        points,
    )


def sweep_rack(
    rig: Rig, rack: Values, travel: float | str = 0.0, *, vehicle: AxleLayout | None = None, points: bool = False
) -> xr.Dataset:
    """Sweep the steering rack of a corner with the wheel centre at one height.

    Parameters
    ----------
    rig : Rig
        A corner with a tie rod (or toe link) and hardpoints.
    rack : float, str or array_like, shape (m,)
        Travel of the rack, m, positive to the left, ascending; or text, ``"-20 mm:20 mm:5 mm"``.
    travel : float or str
        Vertical travel of the wheel centre from design, m, bump positive.
    vehicle : AxleLayout, optional
        Adds anti-dive, or anti-lift and anti-squat.
    points : bool
        Adds the places of all hardpoints, m.

    Returns
    -------
    xarray.Dataset
        As :func:`sweep_travel`, on ``rack_travel`` (m).

    Raises
    ------
    DescriptionError
        For a rig without hardpoints or rack, or values that do not ascend.
    SimulationError
        When no pose at all can be reached.

    Examples
    --------
    >>> import jounce as jn
    >>> steered = jn.sweep_rack(jn.load("reference-double-wishbone"), [-0.01, 0.0, 0.01])
    >>> bool(steered["steer"][0] > 0.0)  # its tie rod lies behind the axle: a rack to the right turns it to the left
    True
    """
    corner = check_corner(rig)
    if not has_rack(corner):
        raise DescriptionError(
            "no rack moves this wheel",
            where="rack travel",
            found=f'model = "{getattr(corner, "model", "")}"',
            allowed="a corner with a tie rod",
        )
    return _swept(prepare_sweep(rig, to_si(travel, "m", where="wheel travel"), rack), True, False, vehicle, points)


def _swept(
    sweep: PreparedSweep, along_rack: bool, along_travel: bool, vehicle: AxleLayout | None, points: bool
) -> xr.Dataset:
    values = sweep.run()
    ends = sweep.ends() if np.any(sweep.found.outcome != REACHED) else []
    reached = np.isfinite(values[0])
    if not reached.any():
        raise no_pose(ends)
    keep = np.flatnonzero(reached.any(axis=1)), np.flatnonzero(reached.any(axis=0))
    result = Result(sweep.rig, (along_travel, along_rack))
    for row, value in zip(sweep.model.rows, values, strict=True):
        result.add(row.name, value[np.ix_(*keep)], row.unit, row.long_name, row.sign, row.clause)
    if vehicle is not None:
        slopes = (result.values["contact_patch_recession"], result.values["wheel_centre_longitudinal_slope"])
        for name, share in around.shares(vehicle, *slopes).items():
            result.add(name, share, "1", around.ROWS[name], around.SIGN)
    if points:
        for name, value in sweep.points().items():
            result.add(name, value[np.ix_(*keep)], "m", f"place of {name}", "ground axes")
    return result.dataset(ends)


class Result:
    """Variables of a sweep on their grid, for the Dataset."""

    def __init__(self, rig: Corner, along: tuple[bool, bool]) -> None:
        self.rig, self.along = rig, along
        self.values: dict[str, Array] = {}
        self._attributes: dict[str, dict[str, Any]] = {}

    def add(self, name: str, value: Array, unit: str, long_name: str, sign: str, clause: str = "") -> None:
        """Add a variable with its values on the whole grid."""
        self.values[name] = value
        self._attributes[name] = {"units": unit, "long_name": long_name, "sign": sign}
        if clause:
            self._attributes[name]["clause"] = clause

    def dataset(self, ends: Sequence[End]) -> xr.Dataset:
        """Put all together; a dimension that was not swept is a scalar coordinate."""
        import xarray as xr

        dimensions = tuple(name for name, swept in zip(_DIMENSIONS, self.along, strict=True) if swept)
        at = tuple(slice(None) if swept else 0 for swept in self.along)
        variables = {}
        for name, value in self.values.items():
            if name not in _DIMENSIONS:
                variables[name] = xr.Variable(dimensions, value[at], self._attributes[name])
        coordinates = {name: self._coordinate(xr, i) for i, name in enumerate(_DIMENSIONS) if name in self.values}
        return xr.Dataset(variables, coordinates, self._facts(ends))

    def _coordinate(self, xr: Any, i: int) -> Any:
        name = _DIMENSIONS[i]
        axis = np.nanmax(self.values[name], axis=1 - i)
        if not self.along[i]:
            return xr.Variable((), axis[0], self._attributes[name])
        return xr.Variable((name,), axis, self._attributes[name])

    def _facts(self, ends: Sequence[End]) -> dict[str, Any]:
        travel = self.values["wheel_travel"]
        return {
            "model": str(getattr(self.rig, "model", "")),
            "side": self.rig.side,
            "status": "end_of_travel" if ends else "completed",
            "reached": [float(np.nanmin(travel)), float(np.nanmax(travel))],
            "stopped": told(ends),
        }
