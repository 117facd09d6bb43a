"""Sensor calibration from points: sensitivity and zero with intervals, and linearity."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import FitError, RecordingError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.operation import Columns, File, operation
from jounce.core.phrases import Phrase
from jounce.core.results import Shows
from jounce.core.samples import as_samples
from jounce.core.serialise import Plain
from jounce.core.units import conversion_factor, is_unit_of
from jounce.identify.estimate import Estimate, estimate
from jounce.recordings.options import VARIABLE

STANDARD_GRAVITY = 9.80665
"""Standard gravity in m/s^2, for tilt tests of accelerometers; local gravity differs by less than 0.3 %."""
_NOT_STRAIGHT = 0.01
"""Largest residual, as a share of the range, above which a sensor is reported as nonlinear."""


def _unit_of_sensitivity(result: Calibration) -> str:
    quantity = result.quantity_unit
    return f"{_unit_of_record(result)}/{quantity if quantity.isalpha() else f'({quantity})'}"


def _unit_of_record(result: Calibration) -> str:
    return result.recorded_unit.replace("1", "counts")


@dataclass(frozen=True)
class Calibration(Plain):
    """A linear calibration: recorded = zero + sensitivity x reference.

    Attributes
    ----------
    sensitivity : Estimate
        Recorded change per SI unit of the quantity, in the recorded unit per SI unit.
    zero : Estimate
        Reading at a quantity of 0, in the recorded unit.
    quantity_unit, recorded_unit : str
        SI units of the quantity and of the reading (V, A or 1 for counts).
    residual : float
        Largest difference between a point and the line, as a share of the range of the points (1).
    reference, recorded : tuple of float
        The points: reference values (SI) and readings (V, A or counts).
    findings : tuple of Finding
        Limitations of the calibration.
    """

    sensitivity: Annotated[Estimate, Shows("sensitivity", _unit_of_sensitivity)]
    zero: Annotated[Estimate, Shows("zero", _unit_of_record)]
    quantity_unit: str
    recorded_unit: str
    residual: Annotated[float, Shows("largest residual, of the range", "%")]
    reference: tuple[float, ...]
    recorded: tuple[float, ...]
    findings: tuple[Finding, ...] = ()

    also = ("gain_doubt",)

    @property
    def gain_doubt(self) -> Annotated[float | None, Shows("standard error of the gain", "%", 3)]:
        """Relative standard error of the sensitivity (1); None with two points, which leave no residual."""
        error = self.sensitivity.standard_error
        return None if error is None else abs(error / self.sensitivity.value)

    def off_the_line(self) -> tuple[float, ...]:
        """Return the residuals, reading minus line, in the recorded unit."""
        zero, slope = self.zero.value, self.sensitivity.value
        return tuple(
            y - zero - slope * x for x, y in zip(self.reference, self.recorded, strict=True)
        )

    def sensor(self) -> dict[str, Any]:
        """Return the sensor keys for a campaign file or for a channel in the laboratory settings."""
        unit, recorded, doubt = self.quantity_unit, _unit_of_record(self), self.gain_doubt
        keys: dict[str, Any] = {
            "sensitivity": f"{abs(self.sensitivity.value):.6g} {recorded}/({unit})"
        }
        if self.sensitivity.value < 0.0:
            keys["orientation"] = -1
        if doubt is not None:
            keys["gain_doubt"] = float(f"{doubt:.3g}")
        return {**keys, "zero": f"{self.zero.value:.6g} {recorded}"}


def fit_calibration(
    reference: ArrayLike,
    recorded: ArrayLike,
    *,
    unit: str,
    recorded_unit: str = "V",
    name: str = "calibration",
) -> Calibration:
    """Fit a straight line through calibration points by least squares.

    Parameters
    ----------
    reference : array_like, shape (n,)
        Known values of the quantity, SI; for a tilt test, gravity times the cosine of the angle.
    recorded : array_like, shape (n,)
        Reading at each reference value, in ``recorded_unit``: V, A or counts (1).
    unit, recorded_unit : str
        SI units of ``reference`` and ``recorded``.
    name : str
        Name of the calibration in errors and findings.

    Returns
    -------
    Calibration
        The fitted line, with 95 % intervals if there are at least three points.

    Raises
    ------
    FitError
        For fewer than two points, equal reference values, or a constant reading.

    Examples
    --------
    >>> found = fit_calibration([0.0, 0.01, 0.02], [0.4, 1.4, 2.4], unit="m")
    >>> round(found.sensitivity.value, 9), round(found.zero.value, 9)
    (100.0, 0.4)
    """
    x, y = (
        as_samples(reference, where=f"{name}: reference"),
        as_samples(recorded, where=f"{name}: recorded"),
    )
    if x.shape != y.shape or x.ndim != 1 or x.size < 2:
        raise FitError(
            "too few points",
            where=name,
            found=f"{x.size} and {y.size}",
            allowed="two or more pairs",
        )
    for what, values in (("equal reference values", x), ("a constant reading", y)):
        if np.ptp(values) == 0.0:
            raise FitError(
                Phrase("{what} cannot determine a sensitivity", what=what) if values is x else what,
                where=name,
                found=f"{values[0]:g}",
                hint="Calibrate with at least two reference values that are far apart.",
            )
    centre = float(x.mean())
    spread = float(np.sum((x - centre) ** 2))
    slope = float(np.sum((x - centre) * y)) / spread
    level = float(y.mean()) - slope * centre
    left = y - level - slope * x
    freedom = x.size - 2
    variance = float(left @ left) / freedom if freedom else None
    error = None if variance is None else float(np.sqrt(variance / spread))
    zero_error = (
        None if variance is None else float(np.sqrt(variance * (1.0 / x.size + centre**2 / spread)))
    )
    residual = float(np.max(np.abs(left)) / np.ptp(y))
    findings = []
    if residual > _NOT_STRAIGHT:
        worst = int(np.argmax(np.abs(left)))
        findings.append(
            finding(
                "identify.off_the_line",
                name,
                residual,
                point=float(x[worst]),
                unit=unit,
                share=residual,
            )
        )
    if freedom == 0:
        findings.append(finding("identify.two_points", name))
    return Calibration(
        estimate(slope, error, freedom) if error is not None else Estimate(slope),
        estimate(level, zero_error, freedom) if zero_error is not None else Estimate(level),
        unit,
        recorded_unit,
        residual,
        tuple(map(float, x)),
        tuple(map(float, y)),
        tuple(findings),
    )


POINTS = Columns(
    "Column of the reference values (reference) or of the readings (recorded), with its unit if the header gives none: "
    r'reference="F \[kN]". Repeat it.',
    "NAME=COLUMN",
    'reference="F [kN]"',
)
QUANTITIES = ("rad", "m/s^2", "m", "N", "Pa", "m/s", "rad/s", "N*m")
"""SI units of the quantities that sensors are calibrated against; an angle means a tilt test."""
_COUNTS = ("count", "counts", "lsb", "digits", "bits")


@operation(
    "fit calibration",
    named={"path": "points"},
    echo={"file": "points"},
    offers=("figure", "report"),
    page="jounce.report.laboratory:calibration_page",
    title="{points}",
    doing="fitting",
    example="jounce fit calibration tilt.csv",
)
def read_calibration(
    path: Annotated[
        Path | str,
        File(
            "Table of reference values, or of angles from the vertical, and the reading at each.",
            "FILE",
        ),
    ],
    *,
    columns: Annotated[Mapping[str, str] | str | None, POINTS] = None,
    variable: Annotated[str, VARIABLE] = "",
) -> Calibration:
    r"""Fit the sensitivity and the zero of a sensor to the points of a file.

    A column of angles (of the sensitive axis from the vertical) is a tilt test.

    Parameters
    ----------
    path : Path or str
        Any file of columns: text, workbook, or a format of the extra ``io``. One column contains the known values, one
        the readings, in V, A or counts.
    columns : mapping of str to str, or str, optional
        Columns ``reference`` and ``recorded`` of the file, with a unit if the file gives none; by default the first
        columns with matching units. A string lists the names and units of all columns in order.
    variable : str
        Sheet of a workbook, matrix (``.mat``) or group (``.tdms``, ``.nc``) to read.

    Returns
    -------
    Calibration
        Sensitivity and zero with 95 % intervals, as :func:`fit_calibration` gives them.

    Raises
    ------
    RecordingError
        For a file that cannot be read.
    FitError
        For columns without a unit or with an unsuitable unit, or points that do not determine the line.

    Examples
    --------
    >>> import tempfile
    >>> file = Path(tempfile.mkdtemp()) / "tilt.csv"
    >>> _ = file.write_text("angle [deg],out [V]\n0,2.6\n90,2.5\n180,2.4\n")
    >>> round(read_calibration(file).sensitivity.value, 6)
    0.010197
    """
    from jounce.core.files import existing_file
    from jounce.recordings.reader import ReaderOptions
    from jounce.recordings.readers import read_signals

    file = existing_file(path, RecordingError)
    names = columns if isinstance(columns, str) else ""
    table = read_signals(file, ReaderOptions(variable, names)).columns
    given = dict(columns) if isinstance(columns, Mapping) else {}
    reference, recorded = _points_in(table, given, str(file))
    unit, electrical = _quantity_of(reference), _recorded_unit(recorded)
    x = reference.times(conversion_factor(reference.unit, unit))
    y = recorded.times(1.0 if electrical == "1" else conversion_factor(recorded.unit, electrical))
    if unit == "rad":
        x, unit = (
            np.round(STANDARD_GRAVITY * np.cos(x), 12),
            "m/s^2",
        )  # 90 deg is 0, not 6e-16 of it
    return fit_calibration(x, y, unit=unit, recorded_unit=electrical, name=file.name)


def _points_in(table: ColumnTable, given: Mapping[str, str], file: str) -> tuple[Column, Column]:
    """Return the reference and reading columns: the named ones, or the first with matching units."""
    from jounce.recordings.files import locate

    words = ("reference", "recorded")
    for name in given:
        if name not in words:
            raise unknown(name, words, what="column of a calibration", where=file)
    reference, recorded = (locate(table, given[name]) if name in given else None for name in words)
    free = [
        column
        for column in table
        if column.name not in {chosen.name for chosen in (reference, recorded) if chosen}
    ]
    if recorded is None:
        electrical = [column for column in free if _recorded_unit(column)]
        recorded = min(electrical, key=lambda column: _recorded_unit(column) == "1", default=None)
    if reference is None:
        sizes = (column for column in free if column is not recorded and _quantity_of(column))
        reference = next(sizes, None)
    if reference is None or not _quantity_of(reference):
        raise _unusable(
            "reference values",
            reference,
            table,
            file,
            f"{', '.join(QUANTITIES)}, or converts to one of them",
        )
    if recorded is None or not _recorded_unit(recorded):
        raise _unusable(
            "readings", recorded, table, file, "V, A or counts, or converts to one of them"
        )
    return reference, recorded


def _unusable(
    what: str, column: Column | None, table: ColumnTable, file: str, allowed: str
) -> FitError:
    """Build the error for a column that is missing or has no suitable unit."""
    bare = next((item.name for item in ([column] if column else table) if not item.unit), "")
    name, unit = ("reference", "N") if what == "reference values" else ("recorded", "V")
    return FitError(
        Phrase("not a calibration: no column of {what} with its unit", what=what),
        where=file,
        found=", ".join(item.label for item in ([column] if column else table)),
        allowed=Phrase("a unit that is {allowed}", allowed=allowed),
        hint=Phrase(
            "State the unit: --columns {name}='{bare} [{unit}]'.", name=name, bare=bare, unit=unit
        )
        if bare
        else "",
    )


def _quantity_of(column: Column) -> str:
    """Return the SI unit of a reference column; empty for any other column."""
    return next((si for si in QUANTITIES if column.unit and is_unit_of(column.unit, si)), "")


def _recorded_unit(column: Column) -> str:
    """Return the unit of a column of readings: V, A or 1 for counts; empty for any other column."""
    if column.unit.casefold() in _COUNTS or (not column.unit and column.name.casefold() in _COUNTS):
        return "1"
    return next((si for si in ("V", "A") if column.unit and is_unit_of(column.unit, si)), "")
