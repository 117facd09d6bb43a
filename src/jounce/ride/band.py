"""Variances on a road of any spectrum, by integration over a band of frequencies, with exact slopes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.ride.covariance import Relative, Source

Complex = NDArray[np.complex128]
_PANELS = 12  # a decade
_POINTS = 8  # of Gauss and Legendre in each panel
_NEAR = tuple(0.4 * 2.5**k for k in range(9))  # half widths of a resonance at which panels end
_FAR = 0.3  # of its frequency, beyond which a resonance needs no panels of its own
_PERIODS = 0.4  # of the waves between front and rear that a panel may hold
_CHUNK = 80  # nodes summed at once: small products stay on one core, and several cores would only wait for each other
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
        if value.imag > 0.0:
            reach = [share * width for share in _NEAR if share * width < _FAR * middle]
            edges += [middle + side * way for way in reach for side in (-1.0, 1.0)]
    inside = np.unique([edge for edge in edges if low <= edge <= high])
    if delay > 0.0:
        parts = np.maximum(1, np.ceil(np.diff(inside) * delay / _PERIODS).astype(int))
        first, width = np.repeat(inside[:-1], parts), np.repeat(np.diff(inside) / parts, parts)
        place = np.arange(len(first)) - np.repeat(np.cumsum(parts) - parts, parts)
        inside = np.append(first + place * width, inside[-1])
    points, weights = np.polynomial.legendre.leggauss(_POINTS)
    half, middle_of = 0.5 * np.diff(inside), 0.5 * (inside[1:] + inside[:-1])
    nodes = (middle_of[:, None] + half[:, None] * points).ravel()
    return nodes, (half[:, None] * weights).ravel()


class Inverse:
    """``(s - A)^-1`` at many frequencies (rad/s times i), by eigenvectors where they are independent."""

    def __init__(self, a: Array, s: Complex) -> None:
        self.a, self.s = a, s
        values, self._vectors = np.linalg.eig(a)
        self._are_independent = bool(np.linalg.cond(self._vectors) < _DEFECTIVE)
        self._shares = 1.0 / (s[:, None] - values)
        self._left = np.linalg.inv(self._vectors) if self._are_independent else self._vectors

    def times(self, b: Array) -> Complex:
        """Inverse times b, shape (n, m): shape (f, n, m)."""
        if self._are_independent:
            return np.asarray(self._vectors @ (self._shares[:, :, None] * (self._left @ b)))
        return np.asarray(np.linalg.solve(self._shifted(), np.broadcast_to(b, (len(self.s), *b.shape))))

    def before(self, c: Array) -> Complex:
        """C, shape (m, n), times the inverse: shape (f, m, n)."""
        if self._are_independent:
            return np.asarray(((c @ self._vectors) * self._shares[:, None, :]) @ self._left)
        turned = np.linalg.solve(np.swapaxes(self._shifted(), 1, 2), np.broadcast_to(c.T, (len(self.s), *c.T.shape)))
        return np.asarray(np.swapaxes(turned, 1, 2))

    def _shifted(self) -> Complex:
        return np.asarray(self.s[:, None, None] * np.eye(len(self.a)) - self.a)


@dataclass(frozen=True)
class _Pull:
    """Slopes of the variances along A (outputs, n, n; turned), b, C, d, f and the delays of one source."""

    matrix: Array
    drive: Array
    state: Array
    height: Array
    rate: Array
    delay: Array


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
    def _inverse(self) -> Inverse:
        return Inverse(self.model.A, self._s)

    def _summed(self, table: Array, source: Source) -> Array:
        """One column for each group of wheels."""
        return np.stack([table[:, list(group.wheels)].sum(axis=1) for group in source], axis=1)

    @cached_property
    def _waves(self) -> list[Complex]:
        """Phase of each group, for each source: shape (f, groups)."""
        delays = [np.array([group.delay for group in source]) for source in self.sources]
        return [np.asarray(np.exp(-self._s[:, None] * delay)) for delay in delays]

    @cached_property
    def _moved(self) -> list[Complex]:
        """States for unit rate of the road, for each source: shape (f, n, groups)."""
        return [self._inverse.times(self._summed(self.model.b, source)) for source in self.sources]

    @cached_property
    def _by_group(self) -> list[Complex]:
        """Response to unit height, each group at its time: shape (f, outputs, groups)."""
        found = []
        for source, moved, waves in zip(self.sources, self._moved, self._waves, strict=True):
            whole = self.model.C @ moved + self._summed(self.model.f, source)
            height = whole * self._s[:, None, None] + self._summed(self.model.d, source)
            found.append(height * waves[:, None, :])
        return found

    @cached_property
    def _responses(self) -> list[Complex]:
        """Response of each output to each source, shape (outputs, f)."""
        return [np.asarray(part.sum(axis=2).T) for part in self._by_group]

    @cached_property
    def _weights(self) -> Array:
        """What a squared response counts, shape (outputs, f)."""
        return self.band.power * self.band.gain

    def variances(self) -> Array:
        """Variance of each output, in the square of its SI unit."""
        found = np.sum([np.abs(part) ** 2 for part in self._responses], axis=0)
        if self.band.coherence is not None:
            found = found + 2.0 * self.band.coherence * self._shared()
        return np.asarray(np.sum(found * self._weights, axis=1))

    def _shared(self) -> Array:
        left, right = self._responses
        return np.asarray((left * right.conj()).real)

    @cached_property
    def _pulls(self) -> list[_Pull]:
        """How the variances follow the parts of the model, for each source: once for all slopes."""
        seen = self._inverse.before(self.model.C)
        return [self._pull(i, seen) for i in range(len(self.sources))]

    def _pull(self, i: int, seen: Complex) -> _Pull:
        answer = self._responses[i].conj()
        if self.band.coherence is not None:
            answer = answer + self.band.coherence * self._responses[1 - i].conj()
        answer = 2.0 * answer * self._weights
        waves = self._waves[i]
        rates = waves * self._s[:, None]
        state = np.einsum("fng,fg->fn", self._moved[i], rates)
        return _Pull(
            _summed_products(state, answer, seen),
            np.swapaxes(_summed_products(rates, answer, seen), 1, 2),
            np.einsum("rf,fn->rn", answer, state).real,  # without the cores of a matrix product, as above
            np.einsum("rf,fg->rg", answer, waves).real,
            np.einsum("rf,fg->rg", answer, rates).real,
            np.einsum("rf,f,frg->rg", answer, self._s, self._by_group[i]).real,
        )

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
        total = np.zeros(len(self.model.C))
        for source, pull in zip(self.sources, self._pulls, strict=True):
            late = np.array([later[group.wheels[0]] for group in source])
            total += np.einsum("rij,ji->r", pull.matrix, along.A)
            total += np.einsum("rjg,jg->r", pull.drive, self._summed(along.b, source))
            total += np.sum(pull.state * along.C, axis=1) - pull.delay @ late
            total += np.sum(pull.height * self._summed(along.d, source), axis=1)
            total += np.sum(pull.rate * self._summed(along.f, source), axis=1)
        if coherence is not None:
            total += np.sum(2.0 * coherence * self._shared() * self._weights, axis=1)
        return total


def _summed_products(left: Complex, weights: Complex, right: Complex) -> Array:
    """Real part of the sum over f of weights (r, f) times left (f, n) times right (f, r, m): shape (r, n, m)."""
    total: Array = np.zeros((weights.shape[0], left.shape[1], right.shape[2]))
    for first in range(0, len(left), _CHUNK):
        part = slice(first, first + _CHUNK)
        total += ((left[part].T * weights[:, None, part]) @ np.swapaxes(right[part], 0, 1)).real
    return total


def longest_delay(sources: Sequence[Source]) -> float:
    """Longest delay (s) between wheels that one source drives."""
    return max(source[-1].delay - source[0].delay for source in sources)
