"""The lag of a recording behind its simulation, estimated from one simulation, since a shift needs no second run."""

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
    """A recording beside its simulated reading, which can be read at any lag.

    ``measured`` has shape (n,), ``table`` (n, 1 + k): the reading and its derivatives by k parameters; ``weight`` is
    that of the residuals, ``rate`` in Hz. Before its first and after its last sample a signal keeps their values. With
    ``offset`` the lag is sought with any constant added to the reading.
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
        """Lay a cubic spline through every column."""
        from scipy.interpolate import CubicSpline

        return cls(
            measured, CubicSpline(np.arange(len(table), dtype=float), table), weight, rate, offset
        )

    def at(self, lag: float) -> tuple[Array, Array]:
        """Table at a lag (s), shape (n, 1 + k), and the derivative of the reading by the lag, shape (n,), per s."""
        wanted = np.arange(len(self.measured)) - lag * self.rate
        read = np.clip(wanted, 0.0, len(self.measured) - 1.0)
        return np.asarray(self.table(read)), -self.rate * np.where(
            read == wanted, self._reading(read, 1), 0.0
        )

    def pull(self, lag: float) -> tuple[float, float]:
        """First and second derivative by the lag (in samples) of half the weighted sum of squares."""
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
        """Weighted sum of squares at whole samples of lag from ``-reach`` to ``reach``, less a constant."""
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
    """Lag (s), at most ``bound`` to either side, at which the channels of a trial fit best together.

    The best whole sample first, so that the search cannot end beside a better lag, then Newton's method within the
    samples around it.
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
