"""Many variants of one corner swept in one native loop."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError, nearest
from jounce.core.types import Array
from jounce.kernel.poses import walk_variants
from jounce.kinematics.grids import Values
from jounce.kinematics.model import KinematicModel
from jounce.kinematics.sweeps import prepare_sweep
from jounce.parts import Rig
from jounce.parts.rig import unit_of, unknown_path

if TYPE_CHECKING:
    from collections.abc import Sequence

    import xarray as xr

_MOST = 200_000_000  # numbers in one result


def sweep_variants(
    rig: Rig,
    changes: Mapping[str, Sequence[float] | Array],
    travel: Values,
    *,
    rack: float | None = None,
    quantities: Sequence[str] | None = None,
) -> xr.Dataset:
    """Sweep many variants of a corner over the same travel, all in one native loop.

    Parameters
    ----------
    rig : Rig
        The corner that all variants start from.
    changes : mapping of str to array_like, shape (k,)
        Path of a number of the description to its value in each variant, SI; all of one length.
    travel : float, str or array_like, shape (n,)
        Vertical travel of the wheel centre from design, m, bump positive, ascending.
    rack : float, optional
        Travel of the rack, m, positive to the left; the description's own by default.
    quantities : sequence of str, optional
        Which of the catalogue are kept; all by default.

    Returns
    -------
    xarray.Dataset
        Quantities on ``variant`` and ``wheel_travel`` (m); the changed numbers are coordinates along ``variant``. NaN
        where a variant cannot reach a pose; ``reached`` tells how many poses each of them reached.

    Raises
    ------
    DescriptionError
        For a rig without hardpoints, unknown paths or names, values that are not finite or of different lengths.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("reference-double-wishbone")
    >>> heights = {"hardpoints.tie_rod_inner[2]": [0.180, 0.185, 0.190]}
    >>> sorted(jn.sweep_variants(rig, heights, [-0.04, 0.0, 0.04])["bump_steer"].sizes.items())
    [('variant', 3), ('wheel_travel', 3)]
    """
    import xarray as xr

    sweep = prepare_sweep(rig, travel, rack)
    model = sweep.model
    values = _values(model, rig, changes)
    chosen = _chosen(model, quantities)
    count, poses = len(next(iter(values.values()))), len(sweep.layout.place)
    if count * poses * len(chosen) > _MOST:
        raise DescriptionError(
            "too many results", where="changes, travel, quantities", found=count * poses * len(chosen)
        )
    parameters = np.tile(sweep.walk.p, (count, 1))
    for path, column in values.items():
        parameters[:, model.parameters.index(path)] = column
    out = np.empty((len(chosen), count, poses))
    place = sweep.layout.place.astype(np.int64)
    walk_variants(sweep.walk, parameters, sweep.found, sweep.work, place, chosen, out)
    variables = {}
    for row, value in zip((model.rows[i] for i in chosen), out, strict=True):
        if row.name not in ("wheel_travel", "rack_travel"):
            attributes = {"units": row.unit, "long_name": row.long_name, "sign": row.sign}
            variables[row.name] = xr.Variable(("variant", "wheel_travel"), value, attributes)
    at = np.sort(sweep.layout.targets[:, 0])
    coordinates = {
        "wheel_travel": xr.Variable(("wheel_travel",), at, {"units": "m", "long_name": "wheel travel"}),
        **{path: _coordinate(xr, rig, path, column) for path, column in values.items()},
    }
    found = xr.Dataset(variables, coordinates, {"model": str(getattr(rig, "model", ""))})
    return found.assign(reached=("variant", np.isfinite(out[0]).sum(axis=1), {"units": "1", "long_name": "poses"}))


def _coordinate(xr: object, rig: Rig, path: str, column: Array) -> object:
    return xr.Variable(("variant",), column, {"units": unit_of(rig, path), "long_name": path})  # type: ignore[attr-defined]


def _values(model: KinematicModel, rig: Rig, changes: Mapping[str, Sequence[float] | Array]) -> dict[str, Array]:
    if not changes:
        raise DescriptionError("no variants", where="changes", allowed="path of a number to its values")
    known = rig.parameters()
    found: dict[str, Array] = {}
    for path, given in changes.items():
        if path not in known:
            raise unknown_path(path, known)
        if path not in model.parameters:
            raise DescriptionError(
                "does not enter the kinematics", where=path, hint=nearest(path, model.parameters) or "Leave it out."
            )
        column = np.atleast_1d(np.asarray(given, dtype=np.float64))
        if column.ndim != 1 or not len(column) or not np.all(np.isfinite(column)):
            raise DescriptionError("not a list of finite numbers", where=f"changes: {path}", found=str(given)[:60])
        found[path] = column
    lengths = {len(column) for column in found.values()}
    if len(lengths) > 1:
        raise DescriptionError("the changes have different lengths", where="changes", found=sorted(lengths))
    return found


def _chosen(model: KinematicModel, quantities: Sequence[str] | None) -> NDArray[np.int64]:
    names = [row.name for row in model.rows]
    for name in quantities or ():
        if name not in names:
            hint = nearest(name, names)
            raise DescriptionError("no such quantity", where=name, allowed=", ".join(names), hint=hint)
    return np.array([names.index(name) for name in quantities or names], dtype=np.int64)
