"""Two masses on a road by NumPy and SciPy alone: what measured spectra, transfer functions and modes must find."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import signal

Array = NDArray[np.float64]


@dataclass(frozen=True)
class TwoMasses:
    """Body and wheel of a car's corner, SI; the input is the height of the road."""

    sprung: float = 250.0
    unsprung: float = 35.0
    spring: float = 16e3
    damper: float = 1000.0
    tyre: float = 160e3

    @property
    def matrices(self) -> tuple[Array, Array, Array, Array]:
        """State space of both accelerations, m/s^2, over the height of the road, m."""
        k, c = self.spring, self.damper
        rows = [
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
            [-k / self.sprung, k / self.sprung, -c / self.sprung, c / self.sprung],
            [
                k / self.unsprung,
                -(k + self.tyre) / self.unsprung,
                c / self.unsprung,
                -c / self.unsprung,
            ],
        ]
        a = np.array(rows)
        b = np.array([[0.0], [0.0], [0.0], [self.tyre / self.unsprung]])
        return a, b, a[2:], np.array([[0.0], [self.tyre / self.unsprung]])

    def modes(self) -> list[tuple[float, float]]:
        """Undamped frequency, Hz, and damping ratio of body and wheel."""
        poles = np.linalg.eigvals(self.matrices[0])
        pairs = [(abs(p) / (2.0 * np.pi), -p.real / abs(p)) for p in poles if p.imag > 0.0]
        return sorted((float(f), float(z)) for f, z in pairs)

    def response(self, frequency: Array) -> NDArray[np.complex128]:
        """Accelerations of body and wheel over the road's height, 1/s^2, shape (n, 2)."""
        a, b, c, d = self.matrices
        return np.array(
            [(c @ np.linalg.solve(2j * np.pi * f * np.eye(4) - a, b) + d)[:, 0] for f in frequency]
        )

    def drive(
        self, seed: int, duration: float, rate: float = 200.0, noise: float = 0.05
    ) -> tuple[Array, Array, Array]:
        """Drive over a random road: time (s), its height (m), and both accelerations, shape (n, 2), with noise.

        The slope of the road is white above 0.1 Hz. The noise is that share of each acceleration's r.m.s.
        """
        rng, fine = np.random.default_rng(seed), 4
        step = 1.0 / (fine * rate)
        steps = rng.normal(size=round(duration / step)) * 0.01 * np.sqrt(step)
        road = signal.lfilter([1.0], [1.0, -np.exp(-2.0 * np.pi * 0.1 * step)], steps)
        a, b, c, d = signal.cont2discrete(self.matrices, step, "foh")[:4]
        numerators, denominator = signal.ss2tf(a, b, c, d)
        both = np.stack([signal.lfilter(row, denominator, road) for row in numerators], axis=1)
        road, both = (
            signal.decimate(one, fine, ftype="fir", axis=0) for one in (road, both)
        )  # filters as a card has
        both = both + noise * both.std(axis=0) * rng.normal(size=both.shape)
        return np.arange(len(both)) / rate, road, both
