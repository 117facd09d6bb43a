"""The benchmark problems shared by all peers: the kart-scale quarter car on an obstacle, and on a long linear road."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class QuarterCar:
    """Parameters in SI; z up, springs positive in compression, all springs undeformed at z = 0."""

    sprung: float = 16.0
    unsprung: float = 5.0
    lever: float = float(np.cos(np.radians(26.0)))
    rate: float = 22730.0
    damping: float = 150.0
    tyre: float = 138468.0
    gravity: float = 9.81

    def rest(self) -> Array:
        """Static equilibrium (sprung.z, unsprung.z, 0, 0)."""
        unsprung = -(self.sprung + self.unsprung) * self.gravity / self.tyre
        return np.array(
            [
                unsprung - self.sprung * self.gravity / (self.rate * self.lever**2),
                unsprung,
                0.0,
                0.0,
            ]
        )

    def matrices(self) -> tuple[Array, Array, Array]:
        """``x' = A x + B z_road + g`` without lift-off."""
        k, c = self.rate * self.lever**2, self.damping * self.lever**2
        a = np.array(
            [
                [0, 0, 1, 0],
                [0, 0, 0, 1],
                [-k / self.sprung, k / self.sprung, -c / self.sprung, c / self.sprung],
                [
                    k / self.unsprung,
                    -(k + self.tyre) / self.unsprung,
                    c / self.unsprung,
                    -c / self.unsprung,
                ],
            ]
        )
        b = np.array([0, 0, 0, self.tyre / self.unsprung])
        return a, b, np.array([0, 0, -self.gravity, -self.gravity])


@dataclass(frozen=True)
class Obstacle:
    """Half-sine bump of the shipped campaign."""

    height: float = 0.01
    length: float = 0.06
    start: float = 0.2
    speed: float = 1.95

    @property
    def edges(self) -> tuple[float, float]:
        """Times at which the bump begins and ends, s."""
        return self.start / self.speed, (self.start + self.length) / self.speed


DURATION, SAMPLES = 3.0, 3001
TIMES = np.linspace(0.0, DURATION, SAMPLES)
CHANNELS = (
    "road.z",
    "sprung.z",
    "sprung.vz",
    "sprung.az",
    "unsprung.z",
    "unsprung.vz",
    "unsprung.az",
    "strut.deflection",
    "strut.force",
    "tyre.deflection",
    "tyre.force",
)


def long_road(seed: int = 0) -> tuple[Array, Array]:
    """Ten seconds of a random road, a height (m) each millisecond (s)."""
    time = np.arange(10001) * 1e-3
    height = 1e-4 * np.cumsum(np.random.default_rng(seed).normal(size=len(time)))
    return time, height - height[0]


def channels_of(states: Array, road: Array, car: QuarterCar, *, lift_off: bool) -> Array:
    """All channels from states of shape (4, n), for peers that give states only."""
    zs, zu, vs, vu = states
    deflection = car.lever * (zu - zs)
    force = car.rate * deflection + car.damping * car.lever * (vu - vs)
    tyre = car.tyre * (road - zu)
    if lift_off:
        tyre = np.maximum(tyre, 0.0)
    body = car.lever * force / car.sprung - car.gravity
    wheel = (tyre - car.lever * force) / car.unsprung - car.gravity
    return np.array([road, zs, vs, body, zu, vu, wheel, deflection, force, road - zu, tyre])


def displacement_error(states: Array, reference: Array) -> float:
    """Largest error of both displacements relative to the range of each."""
    return float(
        np.max(np.max(np.abs(states[:2] - reference[:2]), axis=1) / np.ptp(reference[:2], axis=1))
    )
