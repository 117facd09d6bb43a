"""Poles of measured frequency responses, spectra or free decays: initial values by least squares, then refined.

The fitted lines include the effect of a window. A Welch estimate multiplies each impulse response or correlation by
the autocorrelation of the window; the model does the same in closed form. Short segments therefore neither widen a
peak nor add damping.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array

Complex: TypeAlias = "NDArray[Any]"
Kind: TypeAlias = Literal["transfer", "spectrum", "decay"]
HIGHEST_ORDER = 24
"""Highest order of the compared denominators: 12 pole pairs, three times those of a full car in bounce."""
SAME = {"transfer": (0.02, 0.10), "decay": (0.02, 0.10), "spectrum": (0.05, 0.25)}
"""Largest relative changes of frequency and damping of a stable pole from one order to the next: the usual 1 to 2 %
and 5 to 10 %, more for spectra, whose scatter is proportional to their level."""
_FEWEST_ORDERS = 4  # orders that must agree on a mode
_MOST_DAMPING = 0.9  # ratio: above, a pole has no resonance that would define a frequency
MOST_MODES = (
    6  # bounce, pitch and roll of the body, three of the wheels: measured bands resolve fewer
)


@dataclass(frozen=True)
class Lines:
    """Measured spectral lines over frequency, and the spectrum of the window applied to them.

    Attributes
    ----------
    kind : {"transfer", "spectrum", "decay"}
        Complex responses, real densities, or Fourier transforms of a free decay.
    frequency : ndarray, shape (n,)
        Hz.
    values : ndarray of complex, shape (n, k)
        One column for each output.
    weight : ndarray, shape (n, k)
        Reciprocal of the standard error of each line, in any scale.
    length : float
        Length of the window, s.
    step : float
        Sample time, s.
    is_hann : bool
        Whether a Hann window was used; boxcar otherwise.
    """

    kind: Kind
    frequency: Array
    values: Complex
    weight: Array
    length: float
    step: float
    is_hann: bool = True

    def columns(self, poles: Complex) -> Array:
        """Basis of the linear part of the model: two columns per pole, and smooth remainders; shape (n or 2 n, m)."""
        omega = 2.0 * np.pi * self.frequency
        parts: list[Complex] = []
        for pole in poles:
            kernel, other = self._kernel(pole, omega), self._kernel(np.conj(pole), omega)
            parts += [kernel + other, 1j * (kernel - other)]
        scaled = self.frequency / self.frequency[-1]
        if self.kind == "spectrum":
            real = [part.real for part in parts]
            return np.stack(
                [*real, np.ones_like(scaled), scaled**2, (self.frequency[0] / self.frequency) ** 2],
                axis=1,
            )
        below = self.frequency[0] / self.frequency
        last = (
            [scaled**2, below**2] if self.kind == "transfer" else [1j * below]
        )  # drift of a decay, which leaks
        ends = [np.ones_like(scaled), 1j * scaled, *last]
        table = np.stack([*parts, *ends], axis=1)
        return np.concatenate([table.real, table.imag])

    def data(self, values: Complex) -> Array:
        """Lines as real numbers, in the layout of `columns`."""
        return (
            values.real if self.kind == "spectrum" else np.concatenate([values.real, values.imag])
        )

    def weights(self) -> Array:
        """Weights as real numbers, in the layout of `columns`."""
        return (
            self.weight if self.kind == "spectrum" else np.concatenate([self.weight, self.weight])
        )

    def _kernel(self, pole: complex, omega: Array) -> Complex:
        """Transform of exp(pole t), t > 0, times the autocorrelation of the window (for a decay: the window itself)."""
        if self.kind == "decay":
            ratio = np.exp((pole - 1j * omega) * self.step)
            return np.asarray(
                self.step * (1.0 - ratio ** round(self.length / self.step)) / (1.0 - ratio)
            )
        p, length = pole - 1j * omega, self.length
        if not self.is_hann:
            return _falling(p, length)
        turn = 2j * np.pi / length
        up, down = p + turn, p - turn
        level = (
            2.0 / 3.0 * _falling(p, length) + (_falling(up, length) + _falling(down, length)) / 6.0
        )
        return np.asarray(level + (_whole(up, length) - _whole(down, length)) / (4j * np.pi))


def _whole(p: Complex, length: float) -> Complex:
    """Integral of exp(p t) from 0 to the length."""
    return np.asarray(np.expm1(p * length) / p)


def _falling(p: Complex, length: float) -> Complex:
    """Integral of (1 - t / length) exp(p t) from 0 to the length."""
    return np.asarray((np.expm1(p * length) - p * length) / (p * p * length))


@dataclass(frozen=True)
class Stabilisation:
    """Poles of denominators of rising order.

    Attributes
    ----------
    order : ndarray of int, shape (n,)
        Order of the denominator.
    frequency : ndarray, shape (n,)
        Undamped natural frequency, Hz.
    damping_ratio : ndarray, shape (n,)
        Fraction of critical damping (1).
    is_stable : ndarray of bool, shape (n,)
        Whether the previous order has the same pole: frequency within 2 % and damping within 10 % (spectra: 5 and
        25 %).
    """

    order: NDArray[np.int_]
    frequency: Array
    damping_ratio: Array
    is_stable: NDArray[np.bool_]


def stabilisation(lines: Lines, response: Complex, highest: int = HIGHEST_ORDER) -> Stabilisation:
    """Find the poles of common denominators of rising order (least-squares complex frequency).

    ``response`` (n, k) must have the poles of positive time only: the lines themselves, except for spectra.
    """
    low, high = lines.frequency[0], lines.frequency[-1]
    turned = 1.0 / (2.0 * np.pi * np.sqrt(low * high))
    highest = min(highest, len(lines.frequency) // 3)
    s = 2j * np.pi * lines.frequency * turned
    # The bilinear map spreads the octaves of the band over the unit circle, and preserves poles and orders.
    powers = ((1.0 - s) / (1.0 + s))[:, None] ** np.arange(highest + 1)
    rows: list[tuple[int, float, float, bool]] = []
    before: list[tuple[float, float]] = []
    weight = lines.weight / lines.weight.max(axis=0)
    for order in range(2, highest + 1):
        roots = np.roots(_denominator(powers[:, : order + 1], response, weight))
        roots = roots[(np.abs(roots) > 0.0) & (np.abs(roots + 1.0) > _AT_INFINITY)].astype(complex)
        poles = (roots - 1.0) / (roots + 1.0) / turned
        size = np.abs(poles)
        keep = (poles.imag > 0.0) & (poles.real < 0.0) & (-poles.real < _MOST_DAMPING * size)
        now = sorted(zip(size[keep] / (2.0 * np.pi), -poles.real[keep] / size[keep], strict=True))
        now = [(float(f), float(z)) for f, z in now if low <= f <= high]
        rows += [
            (order, f, z, any(_is_same((f, z), other, SAME[lines.kind]) for other in before))
            for f, z in now
        ]
        before = now
    table = np.array(rows, dtype=float).reshape(-1, 4)
    return Stabilisation(
        table[:, 0].astype(int), table[:, 1], table[:, 2], table[:, 3].astype(bool)
    )


def _denominator(powers: Complex, response: Complex, weight: Array) -> Array:
    """Coefficients of the common denominator of all outputs; the last one is 1.

    With this normalisation poles that only fit noise are unstable, and are dropped. The first step minimises the
    equation error instead of the response error; dividing by the previous denominator makes both equal (Sanathanan
    and Koerner).
    """
    divisor: Array = np.ones(len(powers))
    free: NDArray[Any] = np.zeros(0)
    for _ in range(_ITERATIONS):
        reduced = np.zeros((powers.shape[1],) * 2)
        for column, scale in zip(response.T, weight.T, strict=True):
            x = (scale / divisor)[:, None] * powers
            y = -column[:, None] * x
            r, s, t = (x.conj().T @ x).real, (x.conj().T @ y).real, (y.conj().T @ y).real
            reduced += t - s.T @ np.linalg.lstsq(r, s, rcond=None)[0]
        free = np.append(np.linalg.lstsq(reduced[:-1, :-1], -reduced[:-1, -1], rcond=None)[0], 1.0)
        divisor = np.asarray(np.maximum(np.abs(powers @ free), 1e-6), dtype=np.float64)
    return free


_ITERATIONS = 3  # only initial values are needed: fits to the response follow
_AT_INFINITY = 1e-9  # a root of -1, up to rounding


def _is_same(
    first: tuple[float, float], other: tuple[float, float], limits: tuple[float, float]
) -> bool:
    return all(abs(a / b - 1.0) < limit for a, b, limit in zip(first, other, limits, strict=True))


def stable_modes(diagram: Stabilisation, kind: Kind) -> list[tuple[float, float, int]]:
    """Frequency (Hz), damping ratio (1) and number of agreeing orders of each mode, sorted by falling number."""
    stable = np.flatnonzero(diagram.is_stable)
    remaining = set(stable.tolist())
    poles = list(zip(diagram.frequency.tolist(), diagram.damping_ratio.tolist(), strict=True))
    modes = []
    while remaining:
        members = {
            i: [
                j
                for j in remaining
                if _is_same(poles[j], poles[i], (1.5 * SAME[kind][0], 2.5 * SAME[kind][1]))
            ]
            for i in remaining
        }
        best = max(members.values(), key=len)
        remaining -= set(best)
        orders = len(set(diagram.order[best].tolist()))
        if orders >= _FEWEST_ORDERS:
            modes.append(
                (
                    float(np.median(diagram.frequency[best])),
                    float(np.median(diagram.damping_ratio[best])),
                    orders,
                )
            )
    return sorted(modes, key=lambda mode: -mode[2])[:MOST_MODES]


def poles_of(parameters: Array) -> Complex:
    """Poles (rad/s) from pairs ``log f``, ``log(z / (1 - z))`` of frequency f (Hz) and damping ratio z (1)."""
    frequency, ratio = np.exp(parameters[0::2]), 1.0 / (1.0 + np.exp(-parameters[1::2]))
    return np.asarray(2.0 * np.pi * frequency * (-ratio + 1j * np.sqrt(1.0 - ratio**2)))


def parameters_of(modes: Sequence[tuple[float, float]]) -> Array:
    """Parameters as `poles_of` takes them, from frequencies (Hz) and damping ratios (1)."""
    return np.array([value for f, z in modes for value in (np.log(f), np.log(z / (1.0 - z)))])


@dataclass(frozen=True)
class PoleFit:
    """Poles fitted to lines.

    ``parameters`` as `poles_of` takes them, ``residual`` (m,) weighted, ``slopes`` (m, p) its derivatives with respect
    to the parameters, ``model`` (n, k) the fitted lines, ``cost`` the sum of squares.
    """

    parameters: Array
    residual: Array
    slopes: Array
    model: Complex
    cost: float


def fit_poles(lines: Lines, start: Array) -> PoleFit:
    """Fit poles to lines; the linear part of the model is solved for at each iterate (variable projection)."""
    from scipy.optimize import least_squares

    data, weights = lines.data(lines.values), lines.weights()
    limits = start[0::2]

    def residual(parameters: Array) -> Array:
        return _project(lines.columns(poles_of(parameters)), data, weights)[0]

    low, high = np.full(start.shape, -12.0), np.full(start.shape, 4.0)
    low[0::2], high[0::2] = limits - 0.7, limits + 0.7
    solution = least_squares(
        residual, start, bounds=(low, high), x_scale="jac", xtol=1e-9, ftol=1e-10
    )
    model = _project(lines.columns(poles_of(solution.x)), data, weights)[1]
    half = len(lines.frequency)
    values = model.astype(complex) if lines.kind == "spectrum" else model[:half] + 1j * model[half:]
    return PoleFit(
        solution.x,
        solution.fun,
        np.asarray(solution.jac),
        values,
        float(solution.fun @ solution.fun),
    )


def residual_at(lines: Lines, parameters: Array, values: Complex) -> Array:
    """Weighted residual (m,) of other values of the lines for given poles."""
    return _project(lines.columns(poles_of(parameters)), lines.data(values), lines.weights())[0]


def _project(columns: Array, data: Array, weights: Array) -> tuple[Array, Array]:
    """Weighted residual of the best linear combination of columns for each output, and the combination itself."""
    scale = np.sqrt(np.mean(columns**2, axis=0))
    columns = columns / np.where(scale > 0.0, scale, 1.0)
    residuals, models = [], []
    for values, weight in zip(data.T, weights.T, strict=True):
        coefficients = np.linalg.lstsq(weight[:, None] * columns, weight * values, rcond=1e-12)[0]
        model = columns @ coefficients
        residuals.append(weight * (values - model))
        models.append(model)
    return np.concatenate(residuals), np.stack(models, axis=1)


def covariance_by_groups(
    fit: PoleFit, lines: Lines, leave_out: Callable[[int], Complex], groups: int
) -> Array:
    """Covariance (p, p) of the parameters by leaving out each group of segments, with one Gauss-Newton step."""
    inverse = np.linalg.pinv(fit.slopes)
    base = residual_at(lines, fit.parameters, lines.values)
    steps = np.stack(
        [
            inverse @ (base - residual_at(lines, fit.parameters, leave_out(group)))
            for group in range(groups)
        ]
    )
    away = steps - steps.mean(axis=0)
    return np.asarray((groups - 1.0) / groups * away.T @ away)


def covariance_by_lines(fit: PoleFit, freedom: int) -> Array:
    """Covariance (p, p) of the parameters if each line has its own error (White's sandwich estimator)."""
    inverse = np.linalg.pinv(fit.slopes)
    return np.asarray((inverse * fit.residual**2) @ inverse.T * len(fit.residual) / max(freedom, 1))
