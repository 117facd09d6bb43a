"""Quarter car on a plate as a linear response: tyre force over plate height, its poles."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.constants import GRAVITY
from jounce.core.types import Array

Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class Corner:
    """Linear quarter car as a plate under its wheel sees it.

    Attributes
    ----------
    sprung_mass, unsprung_mass : float
        kg. What a record gives is the mass that acts on the wheel; of a car it may differ from the share that the wheel
        carries.
    spring_rate, damping_coefficient : float
        Of the suspension at the wheel, N/m and N s/m.
    tyre_stiffness, tyre_damping_coefficient : float
        N/m and N s/m.
    """

    sprung_mass: float
    unsprung_mass: float
    spring_rate: float
    damping_coefficient: float
    tyre_stiffness: float
    tyre_damping_coefficient: float = 0.0

    @property
    def static_load(self) -> float:
        """Weight of both masses, N, at 9.81 m/s^2."""
        return (self.sprung_mass + self.unsprung_mass) * GRAVITY


def force_response(corner: Corner, frequency: ArrayLike) -> Complex:
    """Dynamic tyre force over plate height of a wheel that stays on the plate.

    Parameters
    ----------
    corner : Corner
        The quarter car.
    frequency : array_like, shape (n,)
        Hz, not negative.

    Returns
    -------
    ndarray of complex, shape (n,)
        (F - F_st) / z_plate in N/m, force up on the tyre and height up positive. The EGEA phase angle is 180 degrees
        less its angle, the EUSAMA adhesion is one less its magnitude times the plate's amplitude over the static load.

    Examples
    --------
    >>> car = Corner(400.0, 40.0, 25e3, 1000.0, 200e3)
    >>> float(abs(force_response(car, [25.0])[0]).round(-2))
    250400.0
    """
    s = 2j * np.pi * np.asarray(frequency, dtype=float)
    with np.errstate(divide="ignore", invalid="ignore"):
        strut = corner.spring_rate + corner.damping_coefficient * s
        tyre = corner.tyre_stiffness + corner.tyre_damping_coefficient * s
        body = strut / (corner.sprung_mass * s * s + strut)
        wheel = 1.0 / (corner.unsprung_mass * s * s + strut * (1.0 - body) + tyre)
        return np.asarray(tyre - tyre * tyre * wheel)


def responses(parameters: Array, s: Complex) -> Complex:
    """Responses (m, n) in N/m of m quarter cars at ``s`` in 1/s (n,).

    Columns of the parameters (m, 6): unsprung mass, rate, damping, tyre stiffness, tyre damping, sprung mass, SI.
    """
    unsprung, rate, damping, stiffness, loss, sprung = (column[:, None] for column in parameters.T)
    strut, tyre, square = rate + damping * s, stiffness + loss * s, s * s
    hung = strut - strut * strut / (sprung * square + strut)
    return np.asarray(tyre - tyre * tyre / (unsprung * square + hung + tyre))


def road_poles(corner: Corner) -> Complex:
    """Poles with the plate at rest, which are those on the road, 1/s."""
    return _roots(_road_polynomial(corner))


def _road_polynomial(corner: Corner) -> Array:
    """Characteristic polynomial with the plate at rest, highest power first, SI."""
    ms, mu, k, c = corner.sprung_mass, corner.unsprung_mass, corner.spring_rate, corner.damping_coefficient
    kt, ct = corner.tyre_stiffness, corner.tyre_damping_coefficient
    return np.array([ms * mu, ms * (c + ct) + mu * c, ms * (k + kt) + mu * k + c * ct, c * kt + k * ct, k * kt])


def rig_poles(corner: Corner, plate_mass: float, spring_rate: float, damping_coefficient: float = 0.0) -> Complex:
    """Poles on a sprung plate (kg, N/m, N s/m) whose exciter is at rest, 1/s."""
    ms, mu, k, c = corner.sprung_mass, corner.unsprung_mass, corner.spring_rate, corner.damping_coefficient
    tyre = np.array([corner.tyre_damping_coefficient, corner.tyre_stiffness])
    free = np.array([ms * mu, (ms + mu) * c, (ms + mu) * k, 0.0, 0.0])  # the car on a tyre without stiffness
    plate = np.array([plate_mass, damping_coefficient, spring_rate])
    alone = np.convolve(_road_polynomial(corner), plate)
    together = np.convolve(tyre, free)
    alone[-together.size :] += together
    return _roots(alone)


def _roots(polynomial: Array) -> Complex:
    count = polynomial.size - 1
    companion = np.zeros((count, count))
    companion[0] = -polynomial[1:] / polynomial[0]
    companion[np.arange(1, count), np.arange(count - 1)] = 1.0
    return np.linalg.eigvals(companion).astype(complex)


def wheel_damping(poles: Complex) -> tuple[float, float]:
    """Damping ratio (1) and natural frequency (Hz) of the wheel's mode: the second lowest that oscillates.

    Where only the body does not oscillate, its poles are slow and the wheel's mode is the lowest of the others; a fast
    pole on the real axis is a wheel that does not oscillate, which counts as ratio 1.
    """
    upper = sorted(poles[poles.imag > 1e-6 * np.abs(poles)], key=abs)
    real = np.sort(np.abs(poles[np.abs(poles.imag) <= 1e-6 * np.abs(poles)].real))
    if len(upper) == len(poles) // 2:
        pole = upper[1]
    elif not upper or real[-1] > abs(upper[0]):
        return 1.0, float(real[-1]) / (2.0 * math.pi)
    else:
        pole = upper[0]
    return float(-pole.real / abs(pole)), float(abs(pole)) / (2.0 * math.pi)
