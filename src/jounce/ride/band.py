"""Variances on a road of any spectrum, by integration over a band of frequencies, with exact slopes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from jounce.ride.covariance import Relative, Source

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
_PANELS = 12  # a decade
_POINTS = 8  # of Gauss and Legendre in each panel
_NEAR = (0.3, 1.0, 2.5, 6.0)  # half widths of a resonance at which panels end
_PERIODS = 0.4  # of the waves between front and rear that a panel may hold
_DEFECTIVE = 1e6  # condition of the eigenvectors beyond which they are not used


def frequencies(low: float, high: float, a: Array, delay: float) -> tuple[Array, Array]:
    """Nodes (Hz) and weights (Hz) of a quadrature that resolves the resonances of a model and its delays.

    Parameters
    ----------
    low, high : float
        Band, Hz.
    a : ndarray, shape (n, n)
        Matrix of the model's states, 1/s.
    delay : float
        Longest delay between wheels, s.
    """
    count = max(1, int(np.ceil(_PANELS * np.log10(high / low))))
    edges = [*np.geomspace(low, high, count + 1)]
    for value in np.linalg.eigvals(a):
        middle, width = abs(value.imag) / (2.0 * np.pi), abs(value.real) / (2.0 * np.pi)
        if value.imag > 0.0 and width < 0.3 * middle:
            edges += [middle, *(middle + side * share * width for share in _NEAR for side in (-1.0, 1.0))]
    inside = np.unique([edge for edge in edges if low <= edge <= high])
    if delay > 0.0:
        parts = np.maximum(1, np.ceil(np.diff(inside) * delay / _PERIODS).astype(int))
        pieces = [np.linspace(inside[i], inside[i + 1], parts[i] + 1)[:-1] for i in range(len(parts))]
        inside = np.concatenate([*pieces, inside[-1:]])
    points, weights = np.polynomial.legendre.leggauss(_POINTS)
    half, middle_of = 0.5 * np.diff(inside), 0.5 * (inside[1:] + inside[:-1])
    nodes = (middle_of[:, None] + half[:, None] * points).ravel()
    return nodes, (half[:, None] * weights).ravel()


@dataclass(frozen=True)
class Band:
    """What arrives at the wheels at some frequencies.

    Attributes
    ----------
    frequency : ndarray, shape (f,)
        Nodes, Hz.
    power : ndarray, shape (f,)
        Density of the road's height times the weight of the node, m^2.
    gain : ndarray, shape (outputs, f)
        Squared magnitude by which each output is weighted (1).
    coherence : ndarray, shape (f,), or None
        Of left and right, its root (1), where they are two sources; None where sources know nothing of each other.
    """

    frequency: Array
    power: Array
    gain: Array
    coherence: Array | None = None


@dataclass(frozen=True)
class BandVariance:
    """Variances of the outputs of a relative model over a band.

    Attributes
    ----------
    model : Relative
        The model.
    sources : tuple
        What drives which wheel when.
    band : Band
        Spectrum of the road.
    """

    model: Relative
    sources: tuple[Source, ...]
    band: Band

    @cached_property
    def _s(self) -> Complex:
        return np.asarray(2j * np.pi * self.band.frequency)

    @cached_property
    def _inverse(self) -> Complex:
        """``(s - A)^-1`` at every frequency, shape (f, n, n)."""
        values, vectors = np.linalg.eig(self.model.A)
        if np.linalg.cond(vectors) < _DEFECTIVE:
            return np.asarray((vectors / (self._s[:, None, None] - values)) @ np.linalg.inv(vectors))
        n = len(self.model.A)
        return np.asarray(np.linalg.inv(self._s[:, None, None] * np.eye(n) - self.model.A))

    def _summed(self, table: Array, source: Source) -> Array:
        """One column for each group of wheels."""
        return np.stack([table[:, list(group.wheels)].sum(axis=1) for group in source], axis=1)

    def _waves(self, source: Source) -> Complex:
        """Phase of each group, shape (f, groups)."""
        return np.asarray(np.exp(-self._s[:, None] * np.array([group.delay for group in source])))

    @cached_property
    def _moved(self) -> list[Complex]:
        """States for unit rate of the road, for each source: shape (f, n, groups)."""
        return [np.asarray(self._inverse @ self._summed(self.model.b, source)) for source in self.sources]

    @cached_property
    def _seen(self) -> Complex:
        """Outputs for unit change of the states' rates: shape (f, outputs, n)."""
        return np.asarray(self.model.C @ self._inverse)

    @cached_property
    def _by_group(self) -> list[Complex]:
        """Response to unit height, each group at its time: shape (f, outputs, groups)."""
        found = []
        for source, moved in zip(self.sources, self._moved, strict=True):
            whole = self.model.C @ moved + self._summed(self.model.f, source)
            height = whole * self._s[:, None, None] + self._summed(self.model.d, source)
            found.append(height * self._waves(source)[:, None, :])
        return found

    @cached_property
    def _responses(self) -> list[Complex]:
        """Response of each output to each source, shape (outputs, f)."""
        return [np.asarray(part.sum(axis=2).T) for part in self._by_group]

    def _weighted(self, density: Array) -> Array:
        return np.asarray((density * self.band.gain) @ self.band.power)

    def variances(self) -> Array:
        """Variance of each output, in the square of its SI unit."""
        found = sum(np.abs(part) ** 2 for part in self._responses)
        if self.band.coherence is not None:
            found = found + 2.0 * self.band.coherence * self._shared()
        return self._weighted(np.asarray(found))

    def _shared(self) -> Array:
        left, right = self._responses
        return np.asarray((left * right.conj()).real)

    def slopes(self, along: Relative, later: Array, coherence: Array | None = None) -> Array:
        """Slope of the variances along a number.

        Parameters
        ----------
        along : Relative
            Slope of the model.
        later : ndarray, shape (wheels,)
            Slope of the delays, s.
        coherence : ndarray, shape (f,), optional
            Slope of the root of the coherence.
        """
        moving = [self._change(i, along, later) for i in range(len(self.sources))]
        found = sum(2.0 * (part.conj() * change).real for part, change in zip(self._responses, moving, strict=True))
        if self.band.coherence is not None:
            (left, right), (left_change, right_change) = self._responses, moving
            mixed = (left_change * right.conj() + left * right_change.conj()).real
            found = found + 2.0 * self.band.coherence * mixed
            if coherence is not None:
                found = found + 2.0 * coherence * self._shared()
        return self._weighted(np.asarray(found))

    def _change(self, i: int, along: Relative, later: Array) -> Complex:
        """Slope of the response to a source, shape (outputs, f)."""
        source, moved = self.sources[i], self._moved[i]
        push = along.A @ moved + self._summed(along.b, source)
        whole = along.C @ moved + self._seen @ push + self._summed(along.f, source)
        height = whole * self._s[:, None, None] + self._summed(along.d, source)
        late = np.array([later[group.wheels[0]] for group in source])
        change = height * self._waves(source)[:, None, :] - self._by_group[i] * (self._s[:, None] * late)[:, None, :]
        return np.asarray(change.sum(axis=2).T)


def contact_filter(wavenumber: Array, length: float) -> Array:
    """Share of a wave (``wavenumber`` in 1/m) that a tyre with a contact ``length`` (m) feels: its moving average."""
    return np.asarray(np.sinc(wavenumber * length))


def longest_delay(sources: Sequence[Source]) -> float:
    """Longest delay (s) between wheels that one source drives."""
    return max(source[-1].delay - source[0].delay for source in sources)
