"""Left and right wheel of one test in two files: joined row by row, or over the input of the test."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.findings import finding
from jounce.core.types import Array
from jounce.kc.loops import lines_of
from jounce.kc.readings import Readings
from jounce.kc.vocabulary import WHEELS

if TYPE_CHECKING:
    from collections.abc import Iterable

    import xarray as xr

_SAME = 0.05  # of the range: reach by which the inputs of two files of one test differ at most


def wheel_of(names: Iterable[object]) -> str:
    """Return the wheel that variables belong to; empty for those of both or none.

    >>> wheel_of(["left.toe", "rack_travel"]), wheel_of(["left.toe", "right.toe"])
    ('left', '')
    """
    sides = {side for side, _, rest in (str(name).partition(".") for name in names) if rest}
    wheels = sides & {*WHEELS}
    return wheels.pop() if len(wheels) == 1 else ""


def are_two_wheels(first: Iterable[object], other: Iterable[object]) -> bool:
    """Whether variables are those of one wheel, and others those of the other."""
    return {wheel_of(first), wheel_of(other)} == {*WHEELS}


def together(first: Readings, other: Readings, place: str) -> Readings | None:
    """Join the readings of both wheels row by row; None if they are not those of two wheels at the same rows."""
    sizes = {len(values) for part in (first, other) for values in part.values.values()}
    if len(sizes) != 1 or not are_two_wheels(first.values, other.values):
        return None
    joined = finding("kc.wheels_by_row", place)
    return Readings(
        {**other.values, **first.values},
        {**other.channels, **first.channels},
        [*first.findings, *other.findings, joined],
    )


def joined(first: xr.Dataset, other: xr.Dataset) -> xr.Dataset | None:
    """Add the other wheel's curves to a test, over its own input; None if they do not belong to one test.

    Rising and falling branches are joined with their like.
    """
    if not are_two_wheels(first.data_vars, other.data_vars):
        return None
    mine, its = (np.asarray(data["input"].values, dtype=float) for data in (first, other))
    reach = float(np.ptp(mine))
    if first["input"].attrs["units"] != other["input"].attrs["units"] or (
        max(abs(mine.max() - its.max()), abs(mine.min() - its.min())) > _SAME * reach
    ):
        return None
    way = np.asarray(first["direction"].values, dtype=float)
    added = {
        name: ("sample", _over(its, np.asarray(data.values, dtype=float), mine, way), data.attrs)
        for name, data in other.data_vars.items()
        if name not in first
    }
    return first.assign(added)


def _over(sweep: Array, values: Array, inputs: Array, way: Array) -> Array:
    lines = lines_of(sweep, values, inputs)
    own = np.where(way > 0.0, lines.up, lines.down)
    return np.asarray(np.where(np.isnan(own), lines.mean, own))
