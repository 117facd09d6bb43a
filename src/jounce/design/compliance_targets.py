"""Targets on rows of a K&C sheet: slopes of lines through tests, with exact derivatives along the free variables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError, JounceError, unknown
from jounce.core.types import Array
from jounce.kc.laboratory import Laboratory, run_test
from jounce.kc.overview import range_of_line
from jounce.kc.sensitivities import kc_parameters, line_of, sensitivities_of
from jounce.kc.slopes import slope_unit
from jounce.kc.tests import TESTS
from jounce.parts import Corner, DependentAxle

_AROUND = 1e-9  # share of a range by which an input on its end may lie outside of it


@dataclass(frozen=True)
class SheetRow:
    """A row of a K&C sheet: the slope of the line through a quantity of a test.

    Attributes
    ----------
    test, quantity : str
        Test, and a variable of it such as ``left.toe``.
    unit : str
        SI unit of the slope.
    low, high : float
        Range of the line, in the SI unit of the input.
    travel : float
        Height of the pads before the test, m.
    rack : float or None
        Rack travel before the test, m; None for that of the description.
    """

    test: str
    quantity: str
    unit: str
    low: float
    high: float
    travel: float = 0.0
    rack: float | None = None

    @property
    def end(self) -> float | None:
        """End of the test's range (SI), if the usual one does not contain the line."""
        far = max(abs(self.low), abs(self.high))
        return far if far > abs(TESTS[self.test].range) * (1.0 + _AROUND) else None

    def line(self, inputs: Array, values: Array) -> Array:
        """Return the slope of the line through values (samples, n) over inputs, NaN without two of them."""
        slack = _AROUND * (self.high - self.low)
        inside = (inputs >= self.low - slack) & (inputs <= self.high + slack)
        if not np.isfinite(values[inside]).all() or np.unique(inputs[inside]).size < 2:
            return np.full(values.shape[1], np.nan)
        return np.asarray(line_of(inputs[inside], values[inside][None])[0])


def read_sheet_row(
    rig: Corner | DependentAxle,
    test: str,
    quantity: str,
    over: str | Sequence[float | str] | None,
    travel: float,
    rack: float | None,
    where: str,
) -> SheetRow:
    """Read a row of a sheet; a quantity without a wheel is that of the left wheel, if each wheel has it."""
    if test not in TESTS:
        raise unknown(test, TESTS, what="test", where=f"{where}.test")
    laboratory = Laboratory(rig, travel, rack)
    names = {
        str(name): str(values.attrs["units"])
        for name, values in run_test(laboratory, TESTS[test], points=5)[0].data_vars.items()
        if not str(name).startswith("handwheel")  # which follow from the rack
    }
    name = quantity if quantity in names else f"left.{quantity}"
    if name not in names:
        short = [item.removeprefix("left.") for item in names if item.startswith("left.")]
        raise unknown(quantity, [*short, *names], what="quantity", where=f"{where}.quantity")
    unit, inputs = TESTS[test].unit, laboratory.inputs(TESTS[test], None, 41)
    within: Any = over if over is None or isinstance(over, str) else tuple(over)
    try:
        low, high = range_of_line(inputs, unit, within)
    except DescriptionError as error:
        raise DescriptionError(
            error.what, where=f"{where}.over", found=error.found, allowed=error.allowed
        ) from None
    row = SheetRow(test, name, slope_unit(names[name], unit), low, high, travel, rack)
    if np.isnan(row.line(laboratory.inputs(TESTS[test], row.end, 41), np.zeros((41, 1)))).any():
        raise DescriptionError(
            "fewer than two inputs in the range",
            where=f"{where}.over",
            found=f"{low:g} to {high:g} {unit}",
            allowed="a lower end first, and a wider range",
        )
    return row


class SheetEvaluator:
    """Evaluates rows of a K&C sheet for the parameters of a rig, with slopes along ``directions`` (parameters, n)."""

    def __init__(
        self,
        rig: Corner | DependentAxle,
        rows: Sequence[SheetRow],
        paths: Sequence[str],
        directions: Array,
    ) -> None:
        self.rig, self.rows = rig, list(rows)
        known = set(kc_parameters(rig))
        self._moving = [
            i for i, path in enumerate(paths) if path in known and np.any(directions[i])
        ]
        self._paths = tuple(paths[i] for i in self._moving)
        self._directions = directions[self._moving]
        self._all = tuple(paths)
        self._start = rig.parameters()
        self._why = ""
        self._by_state: dict[tuple[float, float | None], dict[float | None, list[int]]] = {}
        for i, row in enumerate(rows):
            state = self._by_state.setdefault((row.travel, row.rack), {})
            state.setdefault(row.end, []).append(i)

    def together(self, numbers: Array, *, slopes: bool = True) -> tuple[Array, Array]:
        """Return the rows (n,) at parameters, NaN where a test cannot be done, and their slopes (n, directions)."""
        self._why = ""
        values = np.full(len(self.rows), np.nan)
        along = np.full((len(self.rows) if slopes else 0, self._directions.shape[1]), np.nan)
        changes = {
            path: float(value)
            for path, value in zip(self._all, numbers, strict=True)
            if value != self._start[path]
        }
        try:
            rig = self.rig.with_changes(changes) if changes else self.rig
            for (travel, rack), group in self._by_state.items():
                laboratory = Laboratory(rig, travel, rack)
                for end, members in group.items():
                    self._evaluate(laboratory, end, members, values, along if slopes else None)
        except JounceError as error:
            self._why = str(error)
        return values, along

    def _evaluate(
        self,
        laboratory: Laboratory,
        end: float | None,
        members: Sequence[int],
        values: Array,
        along: Array | None,
    ) -> None:
        """Write rows whose tests have the same end, and their slopes."""
        tests = dict.fromkeys(self.rows[i].test for i in members)
        if along is None:
            for test in tests:
                run, _ = run_test(laboratory, TESTS[test], end)
                for i in members:
                    row = self.rows[i]
                    if row.test == test:
                        curve = run[row.quantity].values[:, None]
                        values[i] = row.line(run["input"].values, curve)[0]
            return
        wanted = sorted({self.rows[i].quantity for i in members})
        each = sensitivities_of(laboratory, dict.fromkeys(tests, end), self._paths, wanted)
        for i in members:
            row = self.rows[i]
            rows = each[row.test].sel(quantity=row.quantity)
            inputs = rows["input"].values
            values[i] = row.line(inputs, rows["value"].values[:, None])[0]
            along[i] = row.line(inputs, rows["sensitivity"].values) @ self._directions

    def ends_in_words(self) -> list[str]:
        """Return why the last rows have no value."""
        return [self._why] if self._why else []
