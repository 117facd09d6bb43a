"""Force laws fitted to deflection: linear, polynomial, power, monotone spline."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import FitError
from jounce.core.types import Array
from jounce.identify.regression import Uncertainty, linear_least_squares, uncertainty

Law = Literal["linear", "polynomial", "power", "monotone-spline"]
LAWS: tuple[Law, ...] = ("linear", "polynomial", "power", "monotone-spline")


@dataclass(frozen=True)
class FittedCurve:
    """A force-deflection law as plain numbers that can be evaluated.

    Attributes
    ----------
    kind : {"polynomial", "power", "table"}
        ``polynomial``: F = preload + sum of coefficients[i] * x^(i+1); ``power``: F = a x^b with coefficients (a, b);
        ``table``: monotone cubic (PCHIP) through ``deflection`` and ``force``.
    coefficients : tuple of float
        N/m, N/m^2, ...; or (a [N/m^b], b [1]); empty for a table.
    deflection, force : tuple of float
        Knots of a table [m], [N]; empty otherwise.
    preload : float
        Force at x = 0 [N]; only with ``intercept="keep"``.
    origin : float
        Deflection of the trials at which x = 0 [m]; not zero only with ``intercept="shift"``.
    """

    kind: Literal["polynomial", "power", "table"]
    coefficients: tuple[float, ...] = ()
    deflection: tuple[float, ...] = ()
    force: tuple[float, ...] = ()
    preload: float = 0.0
    origin: float = 0.0

    def __call__(self, deflection: ArrayLike) -> Array:
        """Give the force [N] at deflections of the trials [m], same shape."""
        x = np.asarray(deflection, float) - self.origin
        if self.kind == "polynomial":
            return np.asarray(self.preload + x * np.polynomial.polynomial.polyval(x, self.coefficients))
        if self.kind == "power":
            a, b = self.coefficients
            return np.asarray(a * np.maximum(x, 0.0) ** b)
        return np.asarray(self._spline()(x))

    def tangent(self, deflection: ArrayLike) -> Array:
        """Give dF/dx [N/m] at deflections of the trials [m], same shape."""
        x = np.asarray(deflection, float) - self.origin
        if self.kind == "polynomial":
            powers = np.arange(1, len(self.coefficients) + 1)
            return np.asarray(np.polynomial.polynomial.polyval(x, np.array(self.coefficients) * powers))
        if self.kind == "power":
            a, b = self.coefficients
            return np.asarray(a * b * np.maximum(x, 1e-12) ** (b - 1.0))
        return np.asarray(self._spline().derivative()(x))

    def _spline(self) -> Any:
        from scipy.interpolate import PchipInterpolator

        return PchipInterpolator(self.deflection, self.force, extrapolate=True)

    def deflection_at(self, force: float, limit: float) -> float | None:
        """Find the deflection [m] in 0...``limit`` at which the curve reaches ``force`` [N]; None when it does not."""
        grid = np.linspace(self.origin, max(limit, self.origin + 1e-9), 2001)
        values = self(grid)
        above = np.flatnonzero(values >= force)
        if not len(above):
            return None
        index = int(above[0])
        if index == 0:
            return float(grid[0])
        return float(np.interp(force, values[index - 1 : index + 1], grid[index - 1 : index + 1]))

    def to_table(self, limit: float) -> dict[str, Any]:
        """Give the curve as it is written in a rig file.

        Parameters
        ----------
        limit : float
            Largest deflection that a table made from a power law reaches [m].

        Returns
        -------
        dict
            ``{"kind": "polynomial", "coefficients": [...]}`` or ``{"kind": "table", "deflection": [...],
            "force": [...]}`` in SI, from x = 0 on. A preload is not part of it: it has its own key in the rig.
        """
        if self.kind == "polynomial":
            return {"kind": "polynomial", "coefficients": list(self.coefficients)}
        if self.kind == "table":
            return {"kind": "table", "deflection": list(self.deflection), "force": list(self.force)}
        deflection = limit * np.linspace(0.0, 1.0, 41) ** 2
        return {"kind": "table", "deflection": deflection.tolist(), "force": self(deflection).tolist()}


@dataclass(frozen=True)
class CurveFit:
    """One fit of a law to points: parameters in the law's order, with the intercept last where there is one."""

    curve: FittedCurve
    parameters: Array
    residual: Array
    uncertainty: Uncertainty | None


def fit_curve(deflection: Array, force: Array, *, law: Law, degree: int, intercept: str, where: str) -> CurveFit:
    """Fit one law to one set of points (deflection [m], force [N], both (n,)); ``where`` names it in errors."""
    needed = {"linear": 2, "polynomial": degree, "power": 2, "monotone-spline": 4}[law]
    if len(np.unique(deflection)) <= needed:
        raise FitError(
            "fewer points than the law needs",
            where=where,
            found=f"{len(np.unique(deflection))} different deflections",
            allowed=f"more than {needed} for law {law!r}",
            hint="Discard less, lower the degree or take a simpler law.",
        )
    if law == "linear":
        return _linear(deflection, force, intercept, where)
    if law == "polynomial":
        powers = np.arange(1, degree + 1)
        found, residual, spread = linear_least_squares(deflection[:, None] ** powers, force)
        return CurveFit(FittedCurve("polynomial", tuple(map(float, found))), found, residual, spread)
    return _power(deflection, force, where) if law == "power" else _monotone(deflection, force)


def _linear(deflection: Array, force: Array, intercept: str, where: str) -> CurveFit:
    regressors = np.column_stack([deflection, np.ones_like(deflection)])
    found, residual, spread = linear_least_squares(regressors, force)
    slope, level = map(float, found)
    if slope <= 0.0:
        raise FitError(
            "the force does not grow with the deflection",
            where=where,
            found=f"{slope:g} N/m",
            hint="Check the columns and their signs.",
        )
    preload = level if intercept == "keep" else 0.0
    origin = -level / slope if intercept == "shift" else 0.0
    return CurveFit(FittedCurve("polynomial", (slope,), preload=preload, origin=origin), found, residual, spread)


def _power(deflection: Array, force: Array, where: str) -> CurveFit:
    from scipy.optimize import least_squares

    use = (deflection > 0.0) & (force > 0.0)
    if np.count_nonzero(use) < 3:
        raise FitError("a power law needs at least three points with positive deflection and force", where=where)
    reach, top = float(deflection[use].max()), float(force[use].max())
    x, y = np.maximum(deflection, 0.0) / reach, force / top
    exponent, level = np.polyfit(np.log(x[use]), np.log(y[use]), 1)
    found = least_squares(
        lambda p: p[0] * x ** p[1] - y, [np.exp(level), max(exponent, 0.05)], bounds=([0.0, 0.02], [np.inf, 20.0])
    )
    exponent = float(found.x[1])
    scale = top / reach**exponent
    a = float(found.x[0]) * scale
    # d(a, b)/d(scaled a, b): a = scaled * top / reach^b
    transform = np.array([[1.0 / scale, 0.0], [0.0, 1.0]])
    jacobian = top * found.jac @ np.array([[1.0, found.x[0] * np.log(reach)], [0.0, 1.0]]) @ transform
    residual = -top * found.fun
    return CurveFit(
        FittedCurve("power", (a, exponent)), np.array([a, exponent]), residual, uncertainty(jacobian, residual)
    )


def _monotone(deflection: Array, force: Array) -> CurveFit:
    bins = int(np.clip(len(deflection) // 8, 3, 24))
    edges = np.linspace(0.0, float(deflection.max()), bins + 1)
    place = np.clip(np.digitize(deflection, edges) - 1, 0, bins - 1)
    keep = [index for index in range(bins) if np.any(place == index)]
    x = np.array([deflection[place == index].mean() for index in keep])
    y = np.array([force[place == index].mean() for index in keep])
    weight = np.array([np.count_nonzero(place == index) for index in keep], float)
    end = np.array([float(deflection.max()), _end_force(deflection, force)])
    x, y, weight = np.append(x, end[0]), np.append(y, end[1]), np.append(weight, 1.0)
    positive = x > 1e-9 * end[0]
    x, first = np.unique(x[positive], return_index=True)
    y, weight = y[positive][first], weight[positive][first]
    y = np.maximum(_increasing(y, weight), 0.0)
    x, y = np.concatenate([[0.0], x]), np.concatenate([[0.0], y])
    curve = FittedCurve("table", deflection=tuple(map(float, x)), force=tuple(map(float, y)))
    return CurveFit(curve, y[1:], force - curve(deflection), None)


def _end_force(deflection: Array, force: Array) -> float:
    """Force at the largest deflection, from a line through the last tenth of the range."""
    near = deflection >= 0.9 * deflection.max()
    if np.ptp(deflection[near]) == 0.0:
        return float(force[near].mean())
    return float(np.polyval(np.polyfit(deflection[near], force[near], 1), deflection.max()))


def _increasing(values: Array, weights: Array) -> Array:
    """Nearest non-decreasing sequence in weighted least squares (pool adjacent violators)."""
    blocks: list[list[float]] = []
    for value, weight in zip(values, weights, strict=True):
        blocks.append([float(value), float(weight), 1.0])
        while len(blocks) > 1 and blocks[-2][0] > blocks[-1][0]:
            value_b, weight_b, count_b = blocks.pop()
            value_a, weight_a, count_a = blocks.pop()
            total = weight_a + weight_b
            blocks.append([(value_a * weight_a + value_b * weight_b) / total, total, count_a + count_b])
    return np.concatenate([np.full(int(count), value) for value, _, count in blocks])
