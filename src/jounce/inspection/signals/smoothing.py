"""Course over frequency with the noise taken out: the fitted model's course, and what the record shows beside it.

The same evaluation of the measured and of the modelled force gives two courses. Their difference is noise where the
model holds, and a smooth curve where it does not (friction, kinked dampers). How much of it is believed follows from
the record itself: a Gaussian process whose size has the greatest likelihood, often zero (Rasmussen and Williams).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from jounce.core.types import Array

_SIZES = np.array([0.3, 0.6, 1.2, 2.5, 5.0, 10.0, 30.0, 100.0, 1000.0])
_BELIEVED = 2.0  # log likelihood that a size must win over none
_FLOOR = 1e-9
_FEWEST = 8
_SAME = 0.06  # Hz


@dataclass(frozen=True)
class Course:
    """A quantity over frequency.

    Attributes
    ----------
    frequency : ndarray, shape (n,)
        Rising, Hz.
    value : ndarray, shape (n,)
        The quantity.
    error : ndarray, shape (n,)
        Standard error of what was added to the model, unit of the quantity.
    """

    frequency: Array
    value: Array
    error: Array

    def with_turns(self, frequency: Array, value: Array) -> Course:
        """Add turns (Hz, unit of the quantity) of which nothing was measured."""
        both = np.concatenate([self.frequency, frequency])
        order = np.argsort(both, kind="stable")
        order = order[np.diff(both[order], prepend=-1.0) > 1e-6]
        unknown = np.concatenate([self.error, np.zeros(frequency.size)])
        return Course(both[order], np.concatenate([self.value, value])[order], unknown[order])

    def lowest(self) -> tuple[float, float, float]:
        """Frequency (Hz), value and error of the turn with the least value."""
        at = int(np.argmin(self.value))
        return float(self.frequency[at]), float(self.value[at]), float(self.error[at])

    def least(self, low: float, high: float) -> tuple[float, float, float] | None:
        """Frequency (Hz), value and error where the course is least between two frequencies (Hz), ends included.

        None where the course does not reach over both ends.
        """
        from scipy.interpolate import CubicSpline

        f = self.frequency
        if f.size < 4 or f[0] > low + 1e-6 or f[-1] < high - 1e-6:
            return None
        grid = np.linspace(low, high, 1 + int(np.ceil((high - low) / 0.02)))
        near = slice(max(np.searchsorted(f, low) - 3, 0), np.searchsorted(f, high) + 3)
        values = CubicSpline(f[near], self.value[near])(grid)
        at = int(np.argmin(values))
        return float(grid[at]), float(values[at]), float(np.interp(grid[at], f, self.error))


def corrected_course(frequency: Array, measured: Array, modelled: Array, spread: Array, length: float) -> Course:
    """Put a modelled course right by a measured one.

    Parameters
    ----------
    frequency : ndarray, shape (n,)
        Hz, in any order.
    measured, modelled : ndarray, shape (n,)
        The quantity; NaN where it is not known.
    spread : ndarray, shape (n,)
        How the noise of the measured values goes from one to the other; its size does not matter.
    length : float
        Hz over which what the model misses may change.

    Returns
    -------
    Course
        Sorted by frequency, frequencies once.
    """
    known = np.isfinite(measured) & np.isfinite(modelled) & (spread > 0.0)
    order = np.argsort(frequency[known], kind="stable")
    f, y, base, wide = _merged(*(values[known][order] for values in (frequency, measured, modelled, spread)))
    if f.size < _FEWEST:
        return Course(f, y, np.full(f.size, np.nan))
    gap = y - base
    if not np.any(gap):
        return Course(f, y, np.zeros(f.size))
    noise = wide * _noise(gap, wide)
    added, error = _posterior(f, gap, noise, length)
    return Course(f, base + added, error)


def _merged(f: Array, y: Array, base: Array, wide: Array) -> tuple[Array, Array, Array, Array]:
    """Means of turns at nearly the same frequency."""
    starts = np.flatnonzero(np.diff(np.floor(f / _SAME), prepend=-1.0))
    if starts.size == f.size:
        return f, y, base, wide
    counts = np.diff(np.append(starts, f.size))
    means = [np.add.reduceat(values, starts) / counts for values in (f, y, base)]
    return means[0], means[1], means[2], np.sqrt(np.add.reduceat(wide**2, starts)) / counts


def _noise(gap: Array, wide: Array) -> float:
    """Size of what jumps from one value to the next, in units of ``wide``."""
    second = gap[:-2] - 2.0 * gap[1:-1] + gap[2:]
    scale = np.sqrt(wide[:-2] ** 2 + 4.0 * wide[1:-1] ** 2 + wide[2:] ** 2)
    jumps = float(np.median(np.abs(second) / scale)) / 0.6745
    return max(jumps, _FLOOR * float(np.max(np.abs(gap) / wide)), 1e-300)


def _posterior(f: Array, gap: Array, noise: Array, length: float) -> tuple[Array, Array]:
    """Mean and standard error of the smooth part of ``gap``; zero where none is believed.

    The process is written in cosines over the band, weighted as its kernel's spectrum (Solin and Sarkka).
    """
    reach = float(f[-1] - f[0]) + 2.0 * length
    order = np.arange(min(int(2.0 * reach / length) + 2, f.size // 2))
    weight = np.exp(-0.25 * (np.pi * order * length / reach) ** 2)
    basis = np.cos(np.pi * np.outer((f - f[0] + length) / reach, order)) * weight
    basis *= math.sqrt(1.0 / float(np.mean(np.sum(basis**2, axis=1))))
    white = basis / noise[:, None]
    values, vectors = np.linalg.eigh(white.T @ white)
    values = np.maximum(values, 0.0)
    along = vectors.T @ (white.T @ (gap / noise))
    rises = (_SIZES * float(np.median(noise))) ** 2
    grown = np.outer(rises, values)
    likelihoods = 0.5 * np.sum(np.outer(rises, along**2) / (1.0 + grown) - np.log1p(grown), axis=1)
    best = int(np.argmax(likelihoods))
    chosen = rises[best] if likelihoods[best] > _BELIEVED else 0.0
    shares = chosen / (1.0 + chosen * values)
    turned = basis @ vectors
    return turned @ (shares * along), np.sqrt((turned**2) @ shares)
