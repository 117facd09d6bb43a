"""Steps along the path of a Bouc-Wen law (see ``identify.hysteresis_path``)."""

from __future__ import annotations

from jounce.kernel.arrays import Vector
from jounce.kernel.loops.compiling import part


@part()
def _rate(u: float, sigma: float, exponent: float) -> float:
    """Return du/ds for motion in the positive direction of u."""
    if u >= 0.0:
        return float(1.0 - u**exponent)
    return float(1.0 + (2.0 * sigma - 1.0) * (-u) ** exponent)


@part()
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


@part()
def follow(
    displacement: Vector, rate: float, sigma: float, exponent: float, start: float, state: Vector
) -> None:
    """Fill in the state at each sample of the displacement."""
    z = start
    for index in range(len(displacement)):
        change = displacement[index] - displacement[max(index - 1, 0)]
        if change > 0.0:
            z = _advance(z, rate * change, sigma, exponent)
        elif change < 0.0:
            z = -_advance(-z, -rate * change, sigma, exponent)
        state[index] = z
