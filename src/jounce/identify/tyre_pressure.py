"""Tyre stiffness against inflation pressure."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from jounce.core.errors import FitError
from jounce.core.findings import Finding
from jounce.identify.estimate import Estimate


@dataclass(frozen=True)
class PressureStiffness:
    """Radial stiffness of a tyre measured at several pressures.

    Attributes
    ----------
    pressures : tuple of float
        Increasing inflation pressures [Pa].
    stiffnesses : tuple of Estimate
        Radial stiffness at each [N/m].
    slope : float or None
        dk/dp of the line through all points [N/m/Pa]; None for one pressure.
    at_zero_pressure : float or None
        Stiffness that line gives at no pressure: the carcass [N/m].
    exponent : float or None
        n of the power law k ~ p^n through all points [1]. Not 1: stiffness is not proportional to pressure.
    findings : tuple of Finding
        E.g. a stiffness that falls with the pressure.
    """

    pressures: tuple[float, ...]
    stiffnesses: tuple[Estimate, ...]
    slope: float | None
    at_zero_pressure: float | None
    exponent: float | None
    findings: tuple[Finding, ...]

    def at(self, pressure: float) -> tuple[Estimate, list[Finding]]:
        """Interpolate the stiffness linearly between measured pressures.

        Parameters
        ----------
        pressure : float
            Inflation pressure [Pa], above 0.

        Returns
        -------
        stiffness : Estimate
            Radial stiffness [N/m]; its interval combines those of the two neighbouring pressures.
        findings : list of Finding
            A warning outside the measured pressures, where the nearest two are extended; with a single measured
            pressure its stiffness is returned unchanged.

        Raises
        ------
        FitError
            For a pressure that is not a positive number.
        """
        if not (math.isfinite(pressure) and pressure > 0.0):
            raise FitError("not an inflation pressure", found=f"{pressure} Pa", allowed="above 0 Pa")
        p = np.array(self.pressures)
        findings = [] if p[0] <= pressure <= p[-1] else [self._outside(pressure)]
        if len(p) == 1:
            return self.stiffnesses[0], findings
        right = int(np.clip(np.searchsorted(p, pressure), 1, len(p) - 1))
        share = float((pressure - p[right - 1]) / (p[right] - p[right - 1]))
        return _blend(self.stiffnesses[right - 1], self.stiffnesses[right], share), findings

    def _outside(self, pressure: float) -> Finding:
        return Finding(
            "tyre pressure",
            "warning",
            f"{pressure / 1e6:.3g} MPa lies outside the measured pressures ({self.pressures[0] / 1e6:.3g} to "
            f"{self.pressures[-1] / 1e6:.3g} MPa): the stiffness is extrapolated; measure there.",
            pressure,
        )


def _blend(low: Estimate, high: Estimate, share: float) -> Estimate:
    value = (1.0 - share) * low.value + share * high.value
    if low.standard_error is None or high.standard_error is None or low.interval is None or high.interval is None:
        return Estimate(value)

    def combined(a: float, b: float) -> float:
        return math.hypot((1.0 - share) * a, share * b)

    half = combined(low.value - low.interval[0], high.value - high.interval[0])
    return Estimate(value, combined(low.standard_error, high.standard_error), (value - half, value + half))


def stiffness_against_pressure(points: Sequence[tuple[float, Estimate]]) -> PressureStiffness:
    """Collect the stiffnesses of one tyre at several pressures.

    Parameters
    ----------
    points : sequence of (float, Estimate)
        Inflation pressure [Pa] and radial stiffness [N/m], in any order, each pressure once.

    Returns
    -------
    PressureStiffness
        With the line and the power law through the points.

    Raises
    ------
    FitError
        No points, a pressure that is not positive or given twice, a stiffness that is not positive.

    Examples
    --------
    >>> tyre = stiffness_against_pressure([(0.25e6, Estimate(125800.0)), (0.31e6, Estimate(138468.0))])
    >>> round(tyre.slope, 5), round(tyre.exponent, 3), round(tyre.at(0.28e6)[0].value)
    (0.21113, 0.446, 132134)
    """
    if not points:
        raise FitError("no stiffness at any pressure", allowed="at least one pressure")
    ordered = sorted(points, key=lambda point: point[0])
    p, k = np.array([point[0] for point in ordered]), np.array([point[1].value for point in ordered])
    if not (np.all(np.isfinite(p)) and p[0] > 0.0):
        raise FitError("not an inflation pressure", found=f"{p[0]} Pa", allowed="above 0 Pa")
    if np.any(np.diff(p) == 0.0):
        raise FitError(
            "a pressure is given twice", found=f"{p[np.argmin(np.diff(p))]:g} Pa", hint="Fit its trials together."
        )
    if not (np.all(np.isfinite(k)) and np.all(k > 0.0)):
        raise FitError("a stiffness is not positive", found=f"{k.min():g} N/m", allowed="above 0 N/m")
    line = np.polyfit(p, k, 1) if len(p) > 1 else None
    exponent = float(np.polyfit(np.log(p), np.log(k), 1)[0]) if len(p) > 1 else None
    findings: list[Finding] = []
    if np.any(np.diff(k) < 0.0):
        findings.append(Finding("tyre pressure", "warning", "the stiffness falls with rising pressure: files swapped?"))
    return PressureStiffness(
        tuple(map(float, p)),
        tuple(point[1] for point in ordered),
        float(line[0]) if line is not None else None,
        float(line[1]) if line is not None else None,
        exponent,
        tuple(findings),
    )
