"""Virtual presses with springs and bump stops of known laws, which the library does not contain.

A press drives triangles between free travel and full stroke. It has noise in both channels, an offset of load cell and
of stroke, and backlash, by which the measured stroke leads the part after a reversal.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

Array = np.ndarray
Law = Callable[[Array], Array]


def linear(rate: float) -> Law:
    return lambda d: rate * np.maximum(d, 0.0)


def progressive(rate: float, square: float, cube: float) -> Law:
    return lambda d: np.where(d > 0.0, rate * d + square * d**2 + cube * d**3, 0.0)


@dataclass(frozen=True)
class Helper:
    """A helper spring in series with the main one: both deflect until the helper's coils touch at ``block`` (N)."""

    helper: float
    main: float
    block: float

    @property
    def soft(self) -> float:
        return self.helper * self.main / (self.helper + self.main)

    @property
    def knee(self) -> float:
        return self.block / self.soft

    def __call__(self, d: Array) -> Array:
        d = np.maximum(d, 0.0)
        return np.where(d < self.knee, self.soft * d, self.block + self.main * (d - self.knee))


def with_bind(law: Law, at: float, solid: float) -> Law:
    """Coils touch at a deflection (m); beyond it the press itself yields (N/m)."""
    return lambda d: law(np.minimum(d, at)) + solid * np.maximum(d - at, 0.0)


@dataclass(frozen=True)
class RubberStop:
    """Exponential rubber with two Maxwell branches and softening below the largest past deflection (Mullins)."""

    scale: float = 60.0  # N
    growth: float = 90.0  # 1/m
    branches: tuple[tuple[float, float], ...] = ((0.25, 0.08), (0.2, 1.5))  # share, s
    softening: float = 0.25

    def elastic(self, d: Array) -> Array:
        return self.scale * np.expm1(self.growth * np.maximum(d, 0.0))

    def forces(self, d: Array, step: float) -> Array:
        """Force (N) along a path of deflections (m), ``step`` (s) apart, with what the part remembers."""
        base = self.elastic(d)
        reach = np.maximum.accumulate(np.maximum(d, 1e-9))
        soft = 1.0 - self.softening * np.clip(1.0 - np.maximum(d, 0.0) / reach, 0.0, 1.0)
        total = soft * base
        for share, constant in self.branches:
            decay = np.exp(-step / constant)
            gain = share * (1.0 - decay) * constant / step
            state = 0.0
            along = np.empty_like(base)
            rises = np.diff(base, prepend=base[0])
            for i, rise in enumerate(rises.tolist()):
                state = state * decay + gain * rise
                along[i] = state
            total = total + along
        return np.maximum(total, 0.0)


@dataclass(frozen=True)
class Press:
    speed: float = 0.005  # m/s
    stroke: float = 0.05  # m beyond contact
    free: float = 0.006  # m of travel before contact
    cycles: int = 4
    samples: int = 500  # of a stroke
    force_noise: float = 2.0  # N
    stroke_noise: float = 5e-6  # m
    force_offset: float = 15.0
    stroke_offset: float = 0.012
    backlash: float = 0.0
    friction: float = 0.0  # N, of the part's ends
    signs: tuple[int, int] = (1, 1)

    def path(self) -> tuple[Array, Array]:
        """Time (s) and true deflection from contact (m)."""
        whole = self.stroke + self.free
        lasting = whole / self.speed
        time = np.linspace(0.0, 2.0 * self.cycles * lasting, 2 * self.cycles * self.samples + 1)
        phase = (time / lasting) % 2.0
        up = np.where(phase <= 1.0, phase, 2.0 - phase)
        return time, whole * up - self.free

    def record(
        self, part: Law | RubberStop, rng: np.random.Generator
    ) -> tuple[Array, Array, Array]:
        """Time (s), stroke (m) and force (N) as recorded."""
        time, d = self.path()
        step = float(time[1])
        rises = np.gradient(d, time) > 0.0
        force = part.forces(d, step) if isinstance(part, RubberStop) else part(d)
        force = force + np.where(d > 0.0, self.friction * np.where(rises, 1.0, -1.0), 0.0)
        force = np.maximum(force, 0.0)
        measured = d + self.backlash * np.where(rises, 0.5, -0.5)
        measured = measured + self.stroke_offset + rng.normal(0.0, self.stroke_noise, d.size)
        force = force + self.force_offset + rng.normal(0.0, self.force_noise, d.size)
        return time, self.signs[0] * measured, self.signs[1] * force
