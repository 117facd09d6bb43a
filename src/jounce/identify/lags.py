"""Estimate the lag of a recording behind its simulation from a single run, since a shift needs no second one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.types import Array

if TYPE_CHECKING:
    from scipy.interpolate import PPoly

_STEPS = 60  # at most; bisection alone would need 29
_RESOLVED = 1e-8  # samples: a shorter step ends the search


@dataclass(frozen=True)
class Shifted:
    """A recording with its simulated reading, which can be evaluated at any lag.

    ``measured`` has shape (n,), ``table`` (n, 1 + k): the reading and its derivatives by k parameters. ``weight`` is
    the weight of the residuals, ``rate`` is in Hz. Beyond its ends a signal keeps its first or last value. With
    ``offset`` the lag is estimated together with a constant offset of the reading.
    """

    measured: Array
    table: PPoly
    weight: float
    rate: float
    offset: bool = False

    @classmethod
    def of(
        cls, measured: Array, table: Array, weight: float, rate: float, *, offset: bool = False
    ) -> Shifted:
        """Fit a cubic spline to each column."""
        from scipy.interpolate import CubicSpline

        return cls(
            measured, CubicSpline(np.arange(len(table), dtype=float), table), weight, rate, offset
        )

    def at(self, lag: float) -> tuple[Array, Array]:
        """Return the table at a lag (s), shape (n, 1 + k), and the lag derivative of the reading, shape (n,), per s."""
        wanted = np.arange(len(self.measured)) - lag * self.rate
        read = np.clip(wanted, 0.0, len(self.measured) - 1.0)
        return np.asarray(self.table(read)), -self.rate * np.where(
            read == wanted, self._reading(read, 1), 0.0
        )

    def pull(self, lag: float) -> tuple[float, float]:
        """Return first and second derivative of half the weighted sum of squares by the lag (in samples)."""
        wanted = np.arange(len(self.measured)) - lag * self.rate
        read = np.clip(wanted, 0.0, len(self.measured) - 1.0)
        inside = read == wanted
        residual = self.measured - self._reading(read, 0)
        slope, bend = (np.where(inside, self._reading(read, order), 0.0) for order in (1, 2))
        if self.offset:
            residual, slope = residual - residual.mean(), slope - slope.mean()
        return self.weight**2 * float(residual @ slope), self.weight**2 * float(
            slope @ slope - residual @ bend
        )

    def misfit(self, reach: int) -> Array:
        """Return the weighted sum of squares at integer lags from ``-reach`` to ``reach`` samples, less a constant."""
        from scipy.signal import correlate

        seen = self.measured[reach : len(self.measured) - reach]
        reading = self._reading(np.arange(len(self.measured), dtype=float), 0)
        energy, total = (_window_sums(values, len(seen)) for values in (reading**2, reading))
        square = energy - 2.0 * correlate(reading, seen, mode="valid", method="fft")
        if self.offset:
            square -= (seen.sum() - total) ** 2 / len(seen)
        return np.asarray(
            self.weight**2 * square[::-1]
        )  # the window from sample i on is that of lag reach - i

    def _reading(self, at: Array, order: int) -> Array:
        from scipy.interpolate import PPoly

        piecewise = PPoly.construct_fast(self.table.c[..., 0], self.table.x)
        return np.asarray(piecewise(at, order))


def _window_sums(values: Array, width: int) -> Array:
    summed = np.concatenate([[0.0], np.cumsum(values)])
    return np.asarray(summed[width:] - summed[: len(summed) - width])


def best_lag(channels: Sequence[Shifted], bound: float) -> float:
    """Find the lag (s) within plus or minus ``bound`` at which the channels of a trial jointly fit best.

    The search first takes the best integer lag, to avoid local minima, and then refines it by Newton's method within
    the neighbouring samples.
    """
    rate, count = channels[0].rate, len(channels[0].measured)
    reach = min(int(bound * rate), max((count - 1) // 4, 0))
    coarse = (int(np.argmin(sum(channel.misfit(reach) for channel in channels))) - reach) / rate
    low, high = max(coarse - 2.0 / rate, -bound), min(coarse + 2.0 / rate, bound)
    lag = coarse
    for _ in range(_STEPS):
        slope, bend = (
            sum(parts) for parts in zip(*(channel.pull(lag) for channel in channels), strict=True)
        )
        low, high = (lag, high) if slope < 0.0 else (low, lag)
        newton = lag - slope / bend / rate if bend > 0.0 else np.inf
        last, lag = lag, newton if low <= newton <= high else 0.5 * (low + high)
        if abs(lag - last) * rate < _RESOLVED:
            break
    return lag
