"""Calibration of a sensor from points: sensitivity and zero with intervals, and how straight it is."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import FitError
from jounce.core.findings import Finding, finding
from jounce.core.samples import as_samples
from jounce.core.shown import Shown
from jounce.identify.estimate import Estimate, estimate

STANDARD_GRAVITY = 9.80665
"""m/s^2; what an accelerometer reads when it is turned over: local gravity differs by less than 0.3 %."""
_NOT_STRAIGHT = 0.01
"""Largest residual over the range from which on a sensor is called not straight: a class of accelerometers is 1 %."""


@dataclass(frozen=True)
class Calibration(Shown):
    """A straight calibration: recorded = zero + sensitivity x reference.

    Attributes
    ----------
    sensitivity : Estimate
        What is recorded for one SI unit of the quantity, in the recorded unit a unit.
    zero : Estimate
        What is recorded where the quantity is 0, in the recorded unit.
    quantity_unit, recorded_unit : str
        SI units of the quantity and of what is recorded (V, A or 1 for counts).
    residual : float
        Largest difference between a point and the line, as a share of the range of the points (1).
    reference, recorded : tuple of float
        The points: sizes of the quantity (SI), and what was recorded of them (V, A or counts).
    findings : tuple of Finding
        What weakens it.
    """

    sensitivity: Estimate
    zero: Estimate
    quantity_unit: str
    recorded_unit: str
    residual: float
    reference: tuple[float, ...]
    recorded: tuple[float, ...]
    findings: tuple[Finding, ...] = ()

    @property
    def gain_doubt(self) -> float | None:
        """Standard error of the sensitivity as a share of it (1); None with two points, which leave no residual."""
        error = self.sensitivity.standard_error
        return None if error is None else abs(error / self.sensitivity.value)


def fit_calibration(
    reference: ArrayLike, recorded: ArrayLike, *, unit: str, recorded_unit: str = "V", name: str = "calibration"
) -> Calibration:
    """Fit a straight line through calibration points by least squares.

    Parameters
    ----------
    reference : array_like, shape (n,)
        Known sizes of the quantity, SI; for a tilt test, gravity times the cosine of the angle.
    recorded : array_like, shape (n,)
        What was recorded at each of them, in V, A or counts (1), as ``recorded_unit`` says.
    unit, recorded_unit : str
        SI units of both.
    name : str
        Names the calibration in errors and findings.

    Returns
    -------
    Calibration
        With 95 % intervals from three points on.

    Raises
    ------
    FitError
        For fewer than two points, points of one size only, or a recorded value that does not change.

    Examples
    --------
    >>> found = fit_calibration([0.0, 0.01, 0.02], [0.4, 1.4, 2.4], unit="m")
    >>> round(found.sensitivity.value, 9), round(found.zero.value, 9)
    (100.0, 0.4)
    """
    x, y = as_samples(reference, where=f"{name}: reference"), as_samples(recorded, where=f"{name}: recorded")
    if x.shape != y.shape or x.ndim != 1 or x.size < 2:
        raise FitError("too few points", where=name, found=f"{x.size} and {y.size}", allowed="two or more pairs")
    for what, values in (("points of one size", x), ("a recorded value that does not change", y)):
        if np.ptp(values) == 0.0:
            raise FitError(
                f"{what} tell nothing of a sensitivity" if values is x else what,
                where=name,
                found=f"{values[0]:g}",
                hint="Calibrate at two sizes at least that are far apart.",
            )
    centre = float(x.mean())
    spread = float(np.sum((x - centre) ** 2))
    slope = float(np.sum((x - centre) * y)) / spread
    level = float(y.mean()) - slope * centre
    left = y - level - slope * x
    freedom = x.size - 2
    variance = float(left @ left) / freedom if freedom else None
    error = None if variance is None else float(np.sqrt(variance / spread))
    zero_error = None if variance is None else float(np.sqrt(variance * (1.0 / x.size + centre**2 / spread)))
    residual = float(np.max(np.abs(left)) / np.ptp(y))
    findings = []
    if residual > _NOT_STRAIGHT:
        worst = int(np.argmax(np.abs(left)))
        findings.append(
            finding("identify.off_the_line", name, residual, point=float(x[worst]), unit=unit, share=residual)
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


def read_calibration(path: Path | str) -> Calibration:
    r"""Fit the calibration in a file with one column of known sizes and one of what was recorded (V, mV, A, counts).

    A column of angles (of the sensitive axis from the vertical) is a tilt test.

    Parameters
    ----------
    path : Path or str
        Any file of columns: text, workbook, or a format of the extra ``io``.

    Returns
    -------
    Calibration
        Sensitivity and zero with 95 % intervals.

    Raises
    ------
    FitError
        For other columns, or points that tell nothing.

    Examples
    --------
    >>> import tempfile
    >>> file = Path(tempfile.mkdtemp()) / "tilt.csv"
    >>> _ = file.write_text("angle [deg],out [V]\n0,2.6\n90,2.5\n180,2.4\n")
    >>> round(read_calibration(file).sensitivity.value, 6)
    0.010197
    """
    from jounce.core.units import conversion_factor, is_unit_of
    from jounce.recordings.reader import ReaderOptions
    from jounce.recordings.readers import read_signals

    file = Path(path)
    table = read_signals(file, ReaderOptions()).columns
    electrical = [(column, si) for column in table for si in ("V", "A") if column.unit and is_unit_of(column.unit, si)]
    counts = [
        (column, "1") for column in table if not column.unit or column.unit.casefold() in ("counts", "count", "lsb")
    ]
    recorded = (electrical or counts)[:1]
    sizes = [column for column in table if not recorded or column is not recorded[0][0]]
    unit = next((si for si in ("rad", "m/s^2", "m", "N", "Pa", "m/s") if sizes and is_unit_of(sizes[0].unit, si)), None)
    if not recorded or unit is None:
        raise FitError(
            "not a calibration",
            where=str(file),
            found=", ".join(column.label for column in table),
            allowed="a column of known sizes with its unit, and one in V, mV, A or counts",
        )
    column, si = recorded[0]
    x = sizes[0].scaled(conversion_factor(sizes[0].unit, unit))
    y = column.scaled(conversion_factor(column.unit, si) if si != "1" else 1.0)
    if unit == "rad":
        x, unit = STANDARD_GRAVITY * np.cos(x), "m/s^2"
    return fit_calibration(x, y, unit=unit, recorded_unit=si, name=file.name)
