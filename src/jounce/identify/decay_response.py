"""Free decay with viscous damping and dry friction, in closed form from turning point to turning point."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from jounce.core.types import Array

Quantity = Literal["displacement", "velocity", "acceleration"]
QUANTITIES: tuple[Quantity, ...] = ("displacement", "velocity", "acceleration")

_MOST_HALF_CYCLES = 5000


@dataclass(frozen=True)
class DecayParameters:
    """What a free decay of m x'' + c x' + F_c sign(x') + k (x - x_eq) = 0 depends on.

    Attributes
    ----------
    angular_frequency : float
        Undamped natural angular frequency sqrt(k/m) [rad/s].
    damping_ratio : float
        c / (2 sqrt(k m)) [1], below 1.
    friction_deflection : float
        x_k = F_c / k [m]: at rest within +-x_k of the equilibrium the mass stays where it is.
    offset : float
        Equilibrium x_eq of a displacement [m]; zero offset of a velocity [m/s] or acceleration [m/s^2] record.
    release_time : float
        Time of the turning point from which the decay is counted [s]; it may lie before the record.
    release_deflection : float
        Displacement from equilibrium at that turning point [m], signed.
    """

    angular_frequency: float
    damping_ratio: float
    friction_deflection: float
    offset: float
    release_time: float
    release_deflection: float

    @property
    def half_cycle_ratio(self) -> float:
        """What viscous damping alone leaves of an amplitude after half a cycle [1]."""
        return math.exp(-math.pi * self.damping_ratio / math.sqrt(1.0 - self.damping_ratio**2))


def turning_points(parameters: DecayParameters, count: int) -> Array:
    """Give the displacement from equilibrium at successive turning points.

    Parameters
    ----------
    parameters : DecayParameters
        The system and its release.
    count : int
        Largest number of half cycles followed.

    Returns
    -------
    array (n,)
        Signed values [m], the release first; it ends where the mass sticks or after ``count`` half cycles.

    Examples
    --------
    >>> k, m, c, friction = 18362.0, 16.0, 120.0, 15.0
    >>> system = DecayParameters((k / m) ** 0.5, c / (2 * (k * m) ** 0.5), friction / k, 0.0, 0.0, 0.020)
    >>> (1e3 * turning_points(system, 20)).round(4).tolist()
    [20.0, -12.7024, 7.5594, -3.9349, 1.3805, 0.4197]
    """
    q = parameters.half_cycle_ratio
    points = [parameters.release_deflection]
    while len(points) <= count and abs(points[-1]) > parameters.friction_deflection and points[-1] != 0.0:
        shifted = parameters.friction_deflection * math.copysign(1.0, points[-1])
        points.append(shifted - q * (points[-1] - shifted))
    return np.array(points)


def alternating(away: Array) -> Array:
    """Amplitudes of turning points given from equilibrium, up to the first that is not on its own side.

    >>> alternating(np.array([-20.0, 12.0, -7.0, -1.0])).tolist()
    [20.0, 12.0, 7.0]
    """
    turned = away * np.sign(away[0]) * (-1.0) ** np.arange(len(away))
    wrong = np.flatnonzero(turned <= 0.0)
    kept: Array = turned[: int(wrong[0]) if len(wrong) else len(turned)]
    return kept


def decay_response(time: Array, parameters: DecayParameters, quantity: Quantity) -> Array:
    """Give the decay at given times.

    Parameters
    ----------
    time : array (n,)
        Times [s]. Before ``release_time`` the mass is held at the release.
    parameters : DecayParameters
        The system and its release.
    quantity : {"displacement", "velocity", "acceleration"}
        What is returned: m (absolute, offset included), m/s or m/s^2.

    Returns
    -------
    array (n,)
        The response; constant displacement and zero motion once the mass sticks.
    """
    omega, ratio = parameters.angular_frequency, parameters.damping_ratio
    root = math.sqrt(1.0 - ratio * ratio)
    damped = omega * root
    since = time - parameters.release_time
    halves = int(min(max(float(since.max()) * damped / math.pi, 0.0) + 2.0, _MOST_HALF_CYCLES))
    points = turning_points(parameters, halves)
    last = len(points) - 1
    which = np.clip(np.floor(since * damped / math.pi), 0.0, last).astype(int)
    start = points[which]
    shifted = parameters.friction_deflection * np.sign(start)
    moving = (since >= 0.0) & ((which < last) | (abs(points[last]) > parameters.friction_deflection))
    local = np.where(moving, since - which * (math.pi / damped), 0.0)
    fall = np.exp(-ratio * omega * local)
    cosine, sine = np.cos(damped * local), np.sin(damped * local)
    if quantity == "displacement":
        position: Array = np.where(moving, shifted + (start - shifted) * fall * (cosine + ratio / root * sine), start)
        return position + parameters.offset
    if quantity == "velocity":
        return np.where(moving, -(start - shifted) * fall * omega / root * sine, 0.0) + parameters.offset
    shape = -(omega**2) * fall * (cosine - ratio / root * sine)
    response: Array = np.where(moving, (start - shifted) * shape, 0.0) + parameters.offset
    return response
