"""Curves of springs, dampers and tyres from a table that was copied from a spreadsheet."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np

from jounce.core.columns import Column, ColumnTable, columns_in
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import conversion_factor, is_unit_of

Over = Literal["deflection", "velocity"]
Turned = Literal["", "over", "force", "both"]
_SI: dict[Over, str] = {"deflection": "m", "velocity": "m/s"}
_USUAL = {"m": ("m", "mm", 0.5), "m/s": ("m/s", "mm/s", 5.0), "N": ("N", "N", np.inf)}
"""Unit in SI, unit of numbers whose largest magnitude is beyond the limit that follows."""
_PLACE = Path("table")


@dataclass(frozen=True)
class PastedCurve(Shown):
    """A force over deflection or velocity, read from a table.

    Attributes
    ----------
    over, force : tuple of float
        Deflections (m) or velocities (m/s) in ascending order, and forces (N).
    columns : tuple of str
        Columns of the table that were read.
    units : tuple of str
        Their units.
    is_unit_stated : bool
        Whether the table (or the caller) states both units.
    """

    over: tuple[float, ...]
    force: tuple[float, ...]
    columns: tuple[str, str]
    units: tuple[str, str]
    is_unit_stated: bool

    def to_dict(self) -> dict[str, Any]:
        """Return plain data."""
        return {**vars(self)}


def read_pasted_curve(
    text: str, over: Over, *, over_unit: str = "", force_unit: str = "", turned: Turned = ""
) -> PastedCurve:
    r"""Read a force over deflection or velocity from a text with any separator, decimal commas and units in headings.

    Parameters
    ----------
    text : str
        Rows of two numbers, with headings or without; more columns if their units tell which ones are read.
    over : {"deflection", "velocity"}
        Quantity of the first column.
    over_unit, force_unit : str
        Units that the headings lack. By default N, and m or mm (m/s or mm/s), by the size of the numbers.
    turned : {"", "over", "force", "both"}
        Columns whose sign is reversed: jounce takes compression (bump) as positive.

    Returns
    -------
    PastedCurve
        The curve in m or m/s, and N.

    Raises
    ------
    RecordingError
        For a cell that is not a number, or a value given twice; the message names the line.
    DescriptionError
        For an unknown unit.

    Examples
    --------
    >>> found = read_pasted_curve("v [mm/s]\tF [kN]\n100\t0,5\n-100\t-0,9\n0\t0\n", "velocity")
    >>> found.over, found.force
    ((-0.1, 0.0, 0.1), (-900.0, 0.0, 500.0))
    """
    table = columns_in(text.rstrip() + "\n", _PLACE, 2)
    first, second = _pair(table, _SI[over])
    x, x_unit = _in_si(first, _SI[over], over_unit)
    y, y_unit = _in_si(second, "N", force_unit)
    x = -x if turned in ("over", "both") else x
    y = -y if turned in ("force", "both") else y
    if len(x) < 2:
        raise RecordingError("a curve has two rows of numbers at least", where=str(_PLACE))
    order = np.argsort(x, kind="stable")
    twice = np.flatnonzero(np.diff(x[order]) <= 0.0)
    if len(twice):
        row = int(order[twice[0] + 1])
        raise RecordingError(
            Phrase("a {quantity} is given twice", quantity=Phrase(over)),
            where=f"{_PLACE}, line {table.lines[row]}",
            found=f"{first.values[row]:g}",
            allowed="each value once",
        )
    is_stated = bool((first.unit or over_unit) and (second.unit or force_unit))
    return PastedCurve(
        tuple(np.round(x[order], 9).tolist()),
        tuple(np.round(y[order], 6).tolist()),
        (first.label, second.label),
        (x_unit, y_unit),
        is_stated,
    )


def _pair(table: ColumnTable, si: str) -> tuple[Column, Column]:
    """Return the columns of the quantity and of the force: by their units, else the first two of two."""
    of_unit = [
        next((column for column in table if column.unit and is_unit_of(column.unit, unit)), None)
        for unit in (si, "N")
    ]
    if of_unit[0] is not None and of_unit[1] is not None:
        return of_unit[0].readable(), of_unit[1].readable()
    if len(table) != 2:
        raise RecordingError(
            "not two columns",
            where=str(_PLACE),
            found=", ".join(column.label for column in table),
            allowed=Phrase("one column in {si} and one in N, or units in the headings", si=si),
        )
    return table[0], table[1]


def _in_si(column: Column, si: str, given: str) -> tuple[Array, str]:
    """Return the values in SI and their unit: that of the heading, the given one, or the usual one."""
    if not np.all(np.isfinite(column.values)):
        raise RecordingError("a cell is empty", where=column.where, allowed="a number in each row")
    small, large, limit = _USUAL[si]
    unit = column.unit or given
    if not unit:
        unit = large if float(np.max(np.abs(column.values), initial=0.0)) > limit else small
    if column.unit and given and column.unit != given:
        raise DescriptionError(
            "the column has another unit", where=column.where, found=column.unit, allowed=given
        )
    return column.values * conversion_factor(unit, si, where=column.where), unit
