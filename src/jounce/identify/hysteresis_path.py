"""The normalised Bouc-Wen state along a measured path."""

from __future__ import annotations

import numpy as np

from jounce.core.types import Array
from jounce.kernel.call import kept


@kept()
def _rate(u: float, sigma: float, exponent: float) -> float:
    """du/ds for motion in the direction in which u is counted."""
    if u >= 0.0:
        return float(1.0 - u**exponent)
    return float(1.0 + (2.0 * sigma - 1.0) * (-u) ** exponent)


@kept()
def _advance(u: float, distance: float, sigma: float, exponent: float) -> float:
    while distance > 0.0:
        if u >= 1.0 - 1e-13:
            return 1.0
        first = _rate(u, sigma, exponent)
        step = 0.2 / exponent if u >= 0.0 else (0.005 - 0.1 * u) / first
        step = min(step, distance)
        second = _rate(u + 0.5 * step * first, sigma, exponent)
        third = _rate(u + 0.5 * step * second, sigma, exponent)
        fourth = _rate(u + step * third, sigma, exponent)
        u = min(1.0, u + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth))
        distance -= step
    return u


@kept()
def bouc_wen_path(displacement: Array, rate: float, sigma: float, exponent: float, start: float) -> Array:
    """Follow ``z' = rate (v - sigma |v| |z|^(n-1) z + (sigma - 1) v |z|^n)`` along a path of displacements.

    The law does not depend on time, only on the path; between two samples the motion is taken as one-way, and the path
    is divided so that the state changes little per Runge-Kutta step.

    Parameters
    ----------
    displacement : array (n,)
        Displacements in the order they are passed [m].
    rate : float
        Inverse of the distance over which the force builds up [1/m].
    sigma : float
        Shape of the unloading [1], at least 1/2; 1/2 is symmetric.
    exponent : float
        n, sharpness of the yield [1], at least 1.
    start : float
        z at the first sample [1], -1 to 1.

    Returns
    -------
    array (n,)
        z at each sample [1], within -1...1.

    Examples
    --------
    >>> path = np.array([0.0, 0.001, 0.002])    # m; z = 1 - exp(-rate x)
    >>> bouc_wen_path(path, 1e3, 0.5, 1.0, 0.0).round(3).tolist()
    [0.0, 0.632, 0.865]

    References
    ----------
    Ikhouane and Rodellar (2007), Systems with Hysteresis, Wiley (normalised form).
    """
    state = np.empty(len(displacement))
    z = start
    state[0] = z
    for index in range(1, len(displacement)):
        change = displacement[index] - displacement[index - 1]
        if change > 0.0:
            z = _advance(z, rate * change, sigma, exponent)
        elif change < 0.0:
            z = -_advance(-z, -rate * change, sigma, exponent)
        state[index] = z
    return state
