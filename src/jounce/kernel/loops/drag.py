"""Steps from turning point to turning point of a decay with drag (see ``identify.decay_path``)."""

from __future__ import annotations

import math

from jounce.kernel.arrays import Matrix, Vector
from jounce.kernel.loops.compiling import part

_STEPS = 96  # a half cycle


@part()
def _acceleration(
    x: float, v: float, side: float, damping: float, square: float, friction: float, drag: float
) -> float:
    """Return the acceleration of a swing away from ``side``, whose velocity has the sign of -side."""
    return -damping * v - square * (x - side * friction) + side * drag * v * v


@part()
def _step(
    x: float,
    v: float,
    h: float,
    side: float,
    damping: float,
    square: float,
    friction: float,
    drag: float,
) -> tuple[float, float]:
    """One step of the classical Runge-Kutta method."""
    a1 = _acceleration(x, v, side, damping, square, friction, drag)
    v2 = v + 0.5 * h * a1
    a2 = _acceleration(x + 0.5 * h * v, v2, side, damping, square, friction, drag)
    v3 = v + 0.5 * h * a2
    a3 = _acceleration(x + 0.5 * h * v2, v3, side, damping, square, friction, drag)
    v4 = v + h * a3
    a4 = _acceleration(x + h * v3, v4, side, damping, square, friction, drag)
    return x + h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4), v + h / 6.0 * (
        a1 + 2.0 * a2 + 2.0 * a3 + a4
    )


@part()
def _turn(
    x: float,
    v: float,
    h: float,
    side: float,
    damping: float,
    square: float,
    friction: float,
    drag: float,
) -> float:
    """Return the time (s) within a step ``h`` at which the velocity reaches zero, by bisection."""
    low, high = 0.0, h
    for _ in range(50):
        middle = 0.5 * (low + high)
        if _step(x, v, middle, side, damping, square, friction, drag)[1] * side > 0.0:
            high = middle
        else:
            low = middle
    return high


@part()
def follow(
    since: Vector,
    angular_frequency: float,
    damping_ratio: float,
    friction: float,
    drag: float,
    release: float,
    path: Matrix,
) -> None:
    """Fill in displacement, velocity and acceleration at each time of a path that is initially zero."""
    damping, square = 2.0 * damping_ratio * angular_frequency, angular_frequency**2
    longest = math.pi / angular_frequency / _STEPS
    x, v, t, side = release, 0.0, 0.0, math.copysign(1.0, release)
    stuck = abs(release) <= friction
    for i in range(len(since)):
        while t < since[i] and not stuck:
            h = min(longest, since[i] - t)
            ahead, speed = _step(x, v, h, side, damping, square, friction, drag)
            if speed * side > 0.0:
                h = _turn(x, v, h, side, damping, square, friction, drag)
                ahead, speed = _step(x, v, h, side, damping, square, friction, drag)
                speed, side = 0.0, math.copysign(1.0, ahead)
                stuck = abs(ahead) <= friction
            x, v, t = ahead, speed, t + h
        path[0, i] = x
        if since[i] >= 0.0 and not stuck:
            path[1, i] = v
            path[2, i] = _acceleration(x, v, side, damping, square, friction, drag)
