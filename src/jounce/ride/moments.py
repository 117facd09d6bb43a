"""Variances of some signals of a rig on a random road at any values of its numbers, with exact slopes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from jounce.core.types import Array
from jounce.ride.band import Band, BandVariance, frequencies, longest_delay
from jounce.ride.covariance import (
    Covariance,
    Relative,
    Source,
    cut_off_slope,
    relative,
    relative_slope,
    sources_of,
    with_cut_off,
)
from jounce.ride.deflation import without_unreached
from jounce.ride.family import LinearFamily, Matrices
from jounce.ride.surface import Surface

Gain = Callable[[Array], Array]
"""Magnitude (1) of a weighting at frequencies (Hz)."""
_TRACK_STEP = 1e-4  # relative, of the difference that gives the slope of a coherence


@dataclass(frozen=True)
class Signal:
    """A channel by its place among the outputs, and the weighting of its frequencies, if any."""

    output: int
    gain: Gain | None = None


@dataclass(frozen=True)
class Moments:
    """Variances and static values of signals, SI, and their slopes.

    Attributes
    ----------
    variances, rest : ndarray, shape (signals,)
        Variance and static value.
    variance_slopes, rest_slopes : ndarray, shape (numbers, signals)
        Along each number of the family; none of them where no slopes were wanted.
    absent : dict
        Signals without a stationary variance, by place, with the reason.
    model : Matrices
        The linear model, all outputs.
    slopes : tuple of Matrices
        Its slopes.
    """

    variances: Array
    rest: Array
    variance_slopes: Array
    rest_slopes: Array
    absent: dict[int, str]
    model: Matrices
    slopes: tuple[Matrices, ...]


@dataclass(frozen=True)
class Analysis:
    """Random vibration of one rig on one road.

    Attributes
    ----------
    family : LinearFamily
        The rig and the numbers that vary.
    surface : Surface
        Road and speed; a weighted signal needs one with a band.
    signals : tuple of Signal
        What is wanted.
    """

    family: LinearFamily
    surface: Surface
    signals: tuple[Signal, ...]

    def at(self, values: Array | None = None, *, slopes: bool = True) -> Moments:
        """Give variances at some values (SI) of the numbers, those of the rig by default."""
        given = self.family.start if values is None else values
        model, along = self.family.at(given, slopes=slopes)
        rows = [signal.output for signal in self.signals]
        chosen, moving = without_unreached(model.of_rows(rows), [part.of_rows(rows) for part in along])
        if self.surface.band is None:
            found = self._white(chosen, moving, given)
        else:
            found = self._banded(chosen, moving, given)
        count = len(self.signals)
        rest_slopes = np.array([part.rest for part in moving]).reshape(len(moving), count)
        variance_slopes = np.array(found[1]).reshape(len(moving), count)
        return Moments(found[0], chosen.rest, variance_slopes, rest_slopes, found[2], model, along)

    def _sources(self, values: Array) -> tuple[Source, ...]:
        delays = self.family.geometry_at(values)[:-1] / self.surface.speed
        sides = [place.side for place in self.family.places]
        return sources_of([float(delay) for delay in delays], sides, same=self.surface.sides == "same")

    @cached_property
    def _later(self) -> Array:
        """Slopes of the delays, s, shape (numbers, wheels)."""
        return np.asarray(self.family.geometry[1][:, :-1] / self.surface.speed)

    def _white(
        self, model: Matrices, along: Sequence[Matrices], values: Array
    ) -> tuple[Array, list[Array], dict[int, str]]:
        rate, intensity = self.surface.corner_rate, self.surface.intensity
        whole = model if rate is None else with_cut_off(model, rate)
        parts = along if rate is None else [cut_off_slope(part, rate) for part in along]
        found = relative(whole)
        covariance = Covariance(found, self._sources(values))
        slopes = [
            intensity * covariance.slopes(relative_slope(whole, found, part, size), later)
            for part, later, size in zip(parts, self._later, _sizes(values), strict=True)
        ]
        return intensity * covariance.variances(), slopes, covariance.absent()

    def _banded(
        self, model: Matrices, along: Sequence[Matrices], values: Array
    ) -> tuple[Array, list[Array], dict[int, str]]:
        found, sources = relative(model), self._sources(values)
        band = self._band(found, sources, float(self.family.geometry_at(values)[-1]))
        variance = BandVariance(found, sources, band)
        slopes = []
        for i, part in enumerate(along):
            wider = self._coherence_slope(band, i, values)
            moving = relative_slope(model, found, part, _sizes(values)[i])
            slopes.append(variance.slopes(moving, self._later[i], wider))
        return variance.variances(), slopes, {}

    def _band(self, model: Relative, sources: tuple[Source, ...], track: float) -> Band:
        surface = self.surface
        assert surface.band is not None
        low, high = (n * surface.speed for n in surface.band)
        frequency, weights = frequencies(low, high, model.A, longest_delay(sources))
        n = frequency / surface.speed
        gain = np.ones((len(self.signals), len(n)))
        for row, signal in zip(gain, self.signals, strict=True):
            if signal.gain is not None:
                row[:] = np.abs(signal.gain(frequency)) ** 2
        shared = surface.shared(n, track) if len(sources) == 2 else None
        return Band(frequency, weights * surface.heights(n) / surface.speed, gain, shared)

    def _coherence_slope(self, band: Band, number: int, values: Array) -> Array | None:
        """Slope of the root of the coherence along a number that moves left and right apart."""
        wider = float(self.family.geometry[1][number, -1])
        if band.coherence is None or wider == 0.0:
            return None
        track = float(self.family.geometry_at(values)[-1])
        n, step = band.frequency / self.surface.speed, _TRACK_STEP * track
        sides = [self.surface.shared(n, track + sign * step) for sign in (1.0, -1.0)]
        assert sides[0] is not None
        assert sides[1] is not None
        return np.asarray(wider * (sides[0] - sides[1]) / (2.0 * step))


def _sizes(values: Array) -> list[float]:
    """Size of each number, 1 (of its SI unit) for zero."""
    return [abs(float(value)) or 1.0 for value in values]
