"""Shim tables: how a row of the sheet changes with spacers under a point, and which spacer brings it to a value."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Literal

import numpy as np

from jounce.core.display import display_unit
from jounce.core.errors import DescriptionError, JounceError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.numbers import number
from jounce.core.serialise import Plain
from jounce.core.shown import Shown
from jounce.core.tables import TextTable
from jounce.core.units import to_si
from jounce.kc.laboratory import Laboratory, axle_of, run_test
from jounce.kc.overview import range_of_line, usual_text, usual_unit
from jounce.kc.slopes import kc_slopes, slope_unit
from jounce.kc.tests import TESTS
from jounce.kinematics.sweeps import sweep_values
from jounce.parts import Rig

if TYPE_CHECKING:
    import xarray as xr

_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
_EXACT = 1e-9  # m: thickness to which a shim is found


@dataclass(frozen=True)
class ShimRow(Plain):
    """A row of a shim table, SI.

    Attributes
    ----------
    shim : float
        Thickness, m.
    slope : float or None
        Slope of the fitted line; None if the axle cannot do the test.
    at_low, at_high : float or None
        Change of the quantity from zero input to the ends of the line.
    """

    shim: float
    slope: float | None
    at_low: float | None
    at_high: float | None


@dataclass(frozen=True)
class KcShims(Plain, Shown):
    """A shim table.

    Attributes
    ----------
    point, test, quantity : str
        Point that a shim moves, test, and quantity.
    along : tuple of float
        Unit vector [1] of positive shims.
    unit, slope_unit, input_unit : str
        SI units of the quantity, of its slope and of the input.
    low, high : float
        Range of the lines, SI.
    rows : tuple of ShimRow
        One for each shim.
    wanted : float
        Slope that is wanted, SI.
    shim : float or None
        Thickness that gives it, m; None if no thickness of the table does.
    findings : tuple of Finding
        Findings.
    """

    point: str
    test: str
    quantity: str
    along: tuple[float, float, float]
    unit: str
    slope_unit: str
    input_unit: str
    low: float
    high: float
    rows: tuple[ShimRow, ...]
    wanted: float
    shim: float | None
    findings: tuple[Finding, ...] = ()

    def __str__(self) -> str:
        return str(self.table())

    def table(self) -> TextTable:
        """Write the table in usual units."""
        thick, own = display_unit("m", 0.01), usual_unit(self.unit)
        slope, along = usual_unit(self.unit, self.input_unit), display_unit(self.input_unit)
        ends = [f"at {_plain(end * along.factor)} {along.name}" for end in (self.low, self.high)]
        rows = [
            (
                _plain(row.shim * thick.factor),
                usual_text(row.slope, slope),
                usual_text(row.at_low, own),
                usual_text(row.at_high, own),
            )
            for row in self.rows
        ]
        if self.shim is None:
            last = f"no shim of the table gives {usual_text(self.wanted, slope)} {slope.name}"
        else:
            shim = f"{number(self.shim * thick.factor)} {thick.name}"
            last = f"{shim} gives {usual_text(self.wanted, slope)} {slope.name}"
        return TextTable(
            f"Shims under {self.point}, {self.quantity} in {self.test}: {last}",
            (
                f"shim [{thick.name}]",
                f"slope [{slope.name}]",
                *(f"{end} [{own.name}]" for end in ends),
            ),
            rows,
            texts=(),
        )


def kc_shims(
    axle: Rig,
    point: str = "tie_rod_outer",
    shims: str | Sequence[float | str] = "-5 mm:5 mm:1 mm",
    *,
    along: Literal["x", "y", "z"] | tuple[float, float, float] = "z",
    test: str = "bounce",
    quantity: str = "toe",
    wanted: float | str = 0.0,
    over: float | str | tuple[float | str, float | str] | None = None,
    travel: float | str = 0.0,
    on: Literal["front", "rear"] | None = None,
) -> KcShims:
    """Print a shim table: how a row of the K&C sheet changes with spacers under a point.

    The usual one is that of bump steer: spacers under the rod end of the steering arm. A shim moves the point on both
    sides of the axle; the static wheel position is set again, as with the length of the tie rod.

    Parameters
    ----------
    axle : Rig
        A corner with hardpoints, a dependent axle, or a 3-D car.
    point : str
        Hardpoint that a shim moves.
    shims : str or sequence of float or str
        Thicknesses, m or with a unit: ``"-5 mm:5 mm:1 mm"`` or a list.
    along : {"x", "y", "z"} or tuple of float
        Direction in which a positive shim moves the point, in the axes of the description; of any length.
    test, quantity : str
        Test and quantity of the sheet; a quantity without a wheel is that of the left one.
    wanted : float or str
        Slope that is sought, SI or with a unit.
    over : float, str or tuple, optional
        Range of the fitted line (SI unit of the input, or with a unit): half of it, or its two ends; by default half of
        the test's range.
    travel : float or str
        Height of the pads before the test, m.
    on : {"front", "rear"}, optional
        Axle of a car.

    Returns
    -------
    KcShims
        Slope and changes at the ends of the line for each shim, and the shim that gives ``wanted``.

    Raises
    ------
    DescriptionError
        If a point, test or quantity is unknown, or the shims are not ascending.
    SimulationError
        If there is no equilibrium without a shim.

    Examples
    --------
    >>> import jounce as jn
    >>> table = jn.kc_shims(jn.load("generic-mcpherson"), shims="-4 mm:4 mm:2 mm")
    >>> len(table.rows), table.rows[2].shim
    (5, 0.0)
    """
    rig = axle_of(axle, on)
    points = rig.hardpoints.given()
    if point not in points:
        raise unknown(point, points, what="hardpoint", where="point")
    if test not in TESTS:
        raise unknown(test, TESTS, what="test", where="test")
    direction = _direction(along)
    thicknesses = sweep_values(shims, "shims", "m")
    height = to_si(travel, "m", where="travel")

    def run(shim: float) -> tuple[float, float, float]:
        place = np.array(points[point]) + shim * np.array(direction)
        changes = {f"hardpoints.{point}[{k}]": float(place[k]) for k in range(3)}
        moved = rig.with_changes(changes) if shim else rig
        return read(run_test(Laboratory(moved, height), TESTS[test])[0])

    first, _ = run_test(Laboratory(rig, height), TESTS[test])
    name = quantity if quantity in first else f"left.{quantity}"
    if name not in first:
        known = [str(item).removeprefix("left.") for item in first.data_vars]
        raise unknown(quantity, known, what="quantity", where="quantity")
    unit, sweep = str(first[name].attrs["units"]), np.asarray(first["input"].values)
    input_unit = TESTS[test].unit
    low, high = range_of_line(sweep, input_unit, over)
    kc_slopes(first[[name]], within=(low, high))  # refuses a range without samples

    def read(dataset: xr.Dataset) -> tuple[float, float, float]:
        part = dataset[[name]]
        fit = kc_slopes(part, within=(low, high)).isel(quantity=0)
        x, y = part["input"].values, part[name].values
        order = np.unique(x, return_index=True)[1]
        ends = np.interp([low, 0.0, high], x[order], y[order])
        return float(fit["slope"]), float(ends[0] - ends[1]), float(ends[2] - ends[1])

    unit_of_slope = slope_unit(unit, input_unit)
    goal = to_si(wanted, unit_of_slope, where="wanted")
    rows = []
    for shim in thicknesses.tolist():
        try:
            values: tuple[float | None, ...] = run(shim)
        except JounceError:
            values = (None, None, None)
        rows.append(ShimRow(shim, *values))
    best = _shim_for(goal, rows, lambda shim: run(shim)[0])
    missing = [f"{1e3 * row.shim:g} mm" for row in rows if row.slope is None]
    findings = []
    if missing:
        findings.append(finding("kc.shims_left_out", point, len(missing), shims=missing))
    return KcShims(
        point, test, name, direction, unit, unit_of_slope, input_unit, low, high,
        tuple(rows), goal, best, tuple(findings),
    )  # fmt: skip


def _plain(value: float) -> str:
    return f"{value + 0.0:.6g}".replace("-", "−")


def _direction(along: str | tuple[float, float, float]) -> tuple[float, float, float]:
    """Return the unit vector of a direction."""
    if isinstance(along, str):
        if along not in _AXES:
            raise unknown(along, _AXES, what="direction", where="along")
        return _AXES[along]
    vector = np.array(along, dtype=float)
    length = float(np.linalg.norm(vector)) if vector.shape == (3,) else 0.0
    if not (np.isfinite(length) and length > 0.0):
        raise DescriptionError(
            "not a direction", where="along", found=str(along), allowed="x, y, z or three numbers"
        )
    x, y, z = (vector / length).tolist()
    return x, y, z


def _shim_for(
    goal: float, rows: Sequence[ShimRow], slope_at: Callable[[float], float]
) -> float | None:
    """Return the thinnest shim that gives a slope, between two rows of the table; None if none does."""
    known = [(row.shim, row.slope - goal) for row in rows if row.slope is not None]
    spans = [
        (a, b)
        for a, b in pairwise(known)
        if a[1] == 0.0 or b[1] == 0.0 or (a[1] < 0.0) != (b[1] < 0.0)
    ]
    if not spans:
        return None
    from scipy.optimize import brentq

    (low, at_low), (high, at_high) = min(spans, key=lambda span: abs(span[0][0] + span[1][0]))
    if at_low == 0.0 or at_high == 0.0:
        return low if at_low == 0.0 else high
    return float(brentq(lambda shim: slope_at(shim) - goal, low, high, xtol=_EXACT, maxiter=100))
