"""Many variants of a corner or axle over the same sweep: for a wheel in one native loop, for an axle one by one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError, SimulationError, nearest
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples, as_values
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kernel.poses import walk_variants
from jounce.kinematics.axle import AxleVariables, TwoWheelAxle, check_roll, roll_axle, steering_rows
from jounce.kinematics.dependent import no_rack, roll_of_axle, travel_of_axle
from jounce.kinematics.model import KinematicModel, check_corner, check_rack, kinematic_model
from jounce.kinematics.sweeps import AxleLayout, PreparedSweep, Values, prepare_sweep, sweep_values
from jounce.parts import Corner, DependentAxle, Rig
from jounce.parts.points import LARGE
from jounce.parts.rig import unit_of, unknown_path
from jounce.recordings.carried import by_path

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

_MOST_RESULTS = 200_000_000  # numbers in one result, 1.6 GB
_IN_RUNS_ONLY = ("tyre.", "bodies.", "gravity", "strut.damper.")  # of a dependent axle
Changes = Mapping[str, Sequence[float | str] | Sequence[Sequence[float | str]] | Array]
"""Value of a parameter, or position of a point, in each variant, by path."""


def sweep_variants(
    rig: Rig,
    changes: Changes | pd.DataFrame,
    travel: Values | None = None,
    *,
    rack: Values | None = None,
    roll: Values | None = None,
    axle: bool = False,
    vehicle: AxleLayout | None = None,
    quantities: Sequence[str] | None = None,
) -> xr.Dataset:
    """Sweep many variants of a corner over the same travel, rack, or both; or of an axle over roll or rack.

    Variants of a single wheel are swept in one native loop, variants of an axle one by one. Solid axles and twist beams
    are swept over travel or roll.

    Parameters
    ----------
    rig : Rig
        The base of all variants: a corner with hardpoints, a solid axle or a twist beam.
    changes : mapping of str to array_like, shape (k,) or (k, 3), or DataFrame
        Value of a parameter of the description in each variant by path, or of a point
        (``"hardpoints.tie_rod_inner"``) its positions; SI or texts with units; all of the same length.
    travel : float, str or array_like, shape (n,), optional
        Vertical travel of the wheel centre from design, m, bump positive, monotonic; 0 by default.
    rack : float, str or array_like, shape (m,), optional
        Travel of the rack, m, positive to the left; the description's own by default. Several values give every pair
        of travel and rack.
    roll : float, str or array_like, shape (r,), optional
        Roll angle of the body, rad: the axle is swept as by :func:`sweep_roll`, without travel.
    axle : bool
        The axle is steered over ``rack`` as by :func:`sweep_steering`, at one travel.
    vehicle : AxleLayout, optional
        With ``axle`` adds Ackermann and turn diameters.
    quantities : sequence of str, optional
        Quantities to keep, of the catalogue or of the axle (``"roll_centre_height"``, ``"left.camber"``); default all.

    Returns
    -------
    xarray.Dataset
        Quantities on ``variant`` and ``wheel_travel`` (m), ``rack_travel`` (m) or ``roll_angle`` (rad), whichever is
        swept; the changed parameters are coordinates along ``variant``. NaN for poses that a variant cannot reach;
        ``reached`` is the number of reached poses of each variant.

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints, paths or names are unknown, values are not finite or of different lengths, or sweeps
        exclude each other.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("reference-double-wishbone")
    >>> heights = {"hardpoints.tie_rod_inner[2]": [0.180, 0.185, 0.190]}
    >>> sorted(jn.sweep_variants(rig, heights, [-0.04, 0.0, 0.04])["bump_steer"].sizes.items())
    [('variant', 3), ('wheel_travel', 3)]
    >>> rolled = jn.sweep_variants(rig, heights, roll="-2 deg:2 deg:1 deg", quantities=["roll_centre_height"])
    >>> rolled["roll_centre_height"].dims
    ('variant', 'roll_angle')
    """
    if roll is not None and (travel is not None or axle):
        raise DescriptionError(
            "wheel travel follows from the roll angle and cannot be set",
            where="roll",
            hint="Leave out the others.",
        )
    if vehicle is not None and not axle:
        raise DescriptionError(
            "needs a steered axle", where="vehicle", hint="Add axle=True, or leave it out."
        )
    if isinstance(rig, DependentAxle):
        no_rack(rig, rack is not None or axle, "rack")
        return _of_dependent(rig, changes, 0.0 if travel is None else travel, roll, quantities)
    corner = check_corner(rig)
    if roll is not None or axle:
        return _of_axle(
            corner, changes, 0.0 if travel is None else travel, rack, roll, vehicle, quantities
        )
    return _of_wheel(corner, changes, 0.0 if travel is None else travel, rack, quantities)


def _of_wheel(
    rig: Corner,
    changes: Changes,
    travel: Values,
    rack: Values | None,
    quantities: Sequence[str] | None,
) -> xr.Dataset:
    import xarray as xr

    sweep = prepare_sweep(rig, travel, rack)
    model = sweep.model
    parameters, columns = _parameters(sweep, rig, changes)
    chosen = _choose_rows(model, quantities)
    count, poses = len(parameters), len(sweep.layout.place)
    _refuse_many(count * poses * len(chosen))
    out = np.empty((len(chosen), count, poses))
    place = sweep.layout.place.astype(np.int64)
    walk_variants(sweep.walk, parameters, sweep.found, sweep.work, place, chosen, out)
    several = rack is not None and sweep.layout.shape[1] > 1
    along = ("wheel_travel", "rack_travel") if several else ("wheel_travel",)
    shape = (count, *sweep.layout.shape[: len(along)])
    variables = {}
    for row, value in zip((model.rows[i] for i in chosen), out, strict=True):
        if row.name not in ("wheel_travel", "rack_travel"):
            attributes = {"units": row.unit, "long_name": row.long_name, "sign": row.sign}
            variables[row.name] = xr.Variable(("variant", *along), value.reshape(shape), attributes)
    at = (np.unique(sweep.layout.targets[:, i]) for i in range(len(along)))
    coordinates = {
        name: xr.Variable((name,), values, {"units": "m", "long_name": name.replace("_", " ")})
        for name, values in zip(along, at, strict=True)
    }
    return _together(rig, variables, coordinates, columns, np.isfinite(out[0]).sum(axis=1))


def _of_dependent(
    rig: DependentAxle,
    changes: Changes,
    travel: Values,
    roll: Values | None,
    quantities: Sequence[str] | None,
) -> xr.Dataset:
    import xarray as xr

    known = [path for path in rig.parameters() if not path.startswith(_IN_RUNS_ONLY)]
    columns = _read_changes(known, rig, changes)
    if roll is None:
        at = sweep_values(travel, "wheel travel")
    else:
        at = sweep_values(roll, "roll", "rad")
        check_roll(at, "roll")

    def of(variant: DependentAxle) -> xr.Dataset:
        return travel_of_axle(variant, at, None) if roll is None else roll_of_axle(variant, at)

    first = of(rig)
    along = str(next(iter(first.sizes)))
    names = _names(quantities, list(map(str, first.data_vars)))
    count = len(next(iter(columns.values())))
    _refuse_many(count * len(at) * len(names))
    out = np.full((len(names), count, len(at)), np.nan)
    reached = np.zeros(count, dtype=np.int64)
    for k in range(count):
        variant = rig.with_changes({path: float(column[k]) for path, column in columns.items()})
        try:
            swept = of(variant)
        except SimulationError:  # this variant reaches no pose
            continue
        place = np.isin(at, swept[along].values)
        for row, name in enumerate(names):
            if name in swept:  # forces only where joints are ideal
                out[row, k, place] = swept.variables[name].values
        reached[k] = int(place.sum())
    variables = {
        name: xr.Variable(("variant", along), value, first.variables[name].attrs)
        for name, value in zip(names, out, strict=True)
    }
    coordinates = {along: xr.Variable((along,), at, first.variables[along].attrs)}
    return _together(rig, variables, coordinates, columns, reached)


def _of_axle(
    rig: Corner,
    changes: Changes,
    travel: Values,
    rack: Values | None,
    roll: Values | None,
    vehicle: AxleLayout | None,
    quantities: Sequence[str] | None,
) -> xr.Dataset:
    import xarray as xr

    parameters, columns = _parameters(prepare_sweep(rig, 0.0), rig, changes)
    lifted, steered = (
        _one(travel, "wheel travel"),
        None if rack is None else sweep_values(rack, "rack travel"),
    )
    if roll is None:
        check_rack(rig)
        if steered is None:
            raise DescriptionError(
                "nothing to sweep is given", where="rack", allowed='"-20 mm:20 mm:5 mm", or roll'
            )
        at = steered
    else:
        at = sweep_values(roll, "roll", "rad")
        check_roll(at, "roll")
    rack_of_roll = 0.0 if rack is None or roll is None else _one(rack, "rack travel")

    def of(numbers: Array) -> AxleVariables:
        axle = TwoWheelAxle(rig, numbers)
        if roll is not None:
            return roll_axle(axle, at, rack_of_roll)
        return steering_rows(
            axle, axle.wheel(1.0, lifted, at), axle.wheel(-1.0, lifted, at), at, vehicle
        )

    first = of(kinematic_model(rig).parameter_values(rig))
    names = _names(quantities, list(first.values))
    _refuse_many(len(parameters) * len(at) * len(names))
    out = np.full((len(names), len(parameters), len(at)), np.nan)
    reached = np.zeros(len(parameters), dtype=np.int64)
    for k, numbers in enumerate(parameters):
        try:
            axle_variables = of(numbers)
        except SimulationError:  # this variant reaches no pose
            continue
        out[:, k] = [axle_variables.values[name] for name in names]
        both = (
            axle_variables.values["left.wheel_travel"] + axle_variables.values["right.wheel_travel"]
        )
        reached[k] = int(np.isfinite(both).sum())
    variables = {
        name: xr.Variable(("variant", first.along), value, first.attributes[name])
        for name, value in zip(names, out, strict=True)
        if name != first.along
    }
    coordinates = {first.along: xr.Variable((first.along,), at, first.coordinate)}
    return _together(rig, variables, coordinates, columns, reached)


def _together(
    rig: Corner | DependentAxle,
    variables: dict[str, Any],
    coordinates: dict[str, Any],
    columns: dict[str, Array],
    reached: NDArray[np.integer],
) -> xr.Dataset:
    import xarray as xr

    for path, column in columns.items():
        coordinates[path] = xr.Variable(
            ("variant",), column, {"units": unit_of(rig, path), "long_name": path}
        )
    result = xr.Dataset(variables, coordinates, {"model": str(getattr(rig, "model", ""))})
    return result.assign(reached=("variant", reached, {"units": "1", "long_name": "poses"}))


def _one(values: Values, name: str) -> float:
    """A single value where only one is allowed."""
    if isinstance(values, str) or np.ndim(np.asarray(values, dtype=object)):
        read = sweep_values(values, name)
        if len(read) > 1:
            raise DescriptionError(
                "only a single value can be used here", where=name, found=f"{len(read)} values"
            )
        return float(read[0])
    return to_si(values, "m", where=name)


def _refuse_many(count: int) -> None:
    if count > _MOST_RESULTS:
        raise DescriptionError("too many results", where="changes, travel, quantities", found=count)


def _parameters(
    sweep: PreparedSweep, rig: Corner, changes: Changes
) -> tuple[Array, dict[str, Array]]:
    """Return the parameters of all variants, shape (k, parameters), and the changed columns by path."""
    columns = _read_changes(sweep.model.parameters, rig, changes)
    parameters = np.tile(sweep.walk.p, (len(next(iter(columns.values()))), 1))
    for path, column in columns.items():
        parameters[:, sweep.model.parameters.index(path)] = column
    return parameters, columns


def _read_changes(
    used: Sequence[str], rig: Corner | DependentAxle, changes: Changes
) -> dict[str, Array]:
    """Return the changed parameters, which must be among those ``used`` by the sweep, as columns by path."""
    changes = by_path(changes)
    if not changes:
        raise DescriptionError(
            "no variants", where="changes", allowed="the path of a parameter and its values"
        )
    known = rig.parameters()
    columns: dict[str, Array] = {}
    for path, values in changes.items():
        parts = [path] if path in known else [f"{path}[{i}]" for i in range(3)]
        if parts[-1] not in known:
            raise unknown_path(path, known)
        if parts[0] not in used:
            raise DescriptionError(
                "has no effect on the kinematics",
                where=path,
                hint=nearest(path, used) or "Leave it out.",
            )
        where = f"changes: {path}"
        if len(parts) == 1:
            read = [as_values(values, unit_of(rig, path), where=where)]
        else:
            read = _places(values, where)
        for part, column in zip(parts, read, strict=True):
            if column.ndim != 1 or not len(column) or not np.all(np.isfinite(column)):
                raise DescriptionError(
                    "not a list of finite numbers", where=where, found=str(values)[:60]
                )
            far = float(np.max(np.abs(column)))
            if part.startswith("hardpoints.") and far > LARGE:
                raise DescriptionError(
                    "too far away for a point of a corner; a bare number is in metres",
                    where=where,
                    found=f"{far:g} m",
                    allowed=Phrase("up to {large:g} m", large=LARGE),
                    hint='Millimetres meant? Write "65 mm", or divide by 1000.',
                )
            if part in columns:
                raise DescriptionError(
                    "given twice, as a point and as one of its coordinates",
                    where=f"changes: {part}",
                )
            columns[part] = column
    lengths = {len(column) for column in columns.values()}
    if len(lengths) > 1:
        raise DescriptionError(
            "the changes have different lengths", where="changes", found=sorted(lengths)
        )
    return columns


def _places(given: object, where: str) -> list[Array]:
    """Return columns x, y, z (m) of positions, one per variant."""
    if isinstance(given, Sequence) and not isinstance(given, str):
        rows = [as_values(row, "m", where=f"{where}[{i}]") for i, row in enumerate(given)]
    else:
        rows = list(np.atleast_2d(as_samples(given, "m", where=where, error=DescriptionError)))
    if not rows or {row.shape for row in rows} != {(3,)}:
        raise DescriptionError(
            "not a list of positions",
            where=where,
            found=str(given)[:60],
            allowed="[[x, y, z], ...]",
        )
    return list(np.array(rows).T)


def _choose_rows(model: KinematicModel, quantities: Sequence[str] | None) -> NDArray[np.int64]:
    names = [row.name for row in model.rows]
    return np.array([names.index(name) for name in _names(quantities, names)], dtype=np.int64)


def _names(quantities: Sequence[str] | None, known: list[str]) -> list[str]:
    """Return the quantities to keep, all by default; refuse unknown ones."""
    for name in quantities or ():
        if name not in known:
            raise DescriptionError(
                "no such quantity",
                where=name,
                allowed=", ".join(known),
                hint=nearest(name, known),
            )
    return known if quantities is None else list(quantities)
