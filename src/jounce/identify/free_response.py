"""Free decay of a mass with viscous damping, dry friction and quadratic drag, from turning point to turning point.

Without drag it has a closed form. A rotation obeys the same equations with angles, inertia and torques.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.identify.motion import Quantity, order_of

_MOST_HALF_CYCLES = (
    5000  # bounds time and memory while a search tries frequencies that are far too high
)


@dataclass(frozen=True)
class DecayParameters:
    """Parameters of a free decay of ``m x'' + c x' + F_c sign(x') + d x' |x'| + k (x - x_eq) = 0``.

    Attributes
    ----------
    angular_frequency : float
        Undamped natural angular frequency sqrt(k/m) [rad/s].
    damping_ratio : float
        Viscous damping ratio c / (2 sqrt(k m)) [1], below 1.
    friction_deflection : float
        x_k = F_c / k [m]: a mass at rest within +-x_k of the equilibrium sticks.
    offset : float
        Equilibrium x_eq of a displacement [m]; zero offset of a velocity [m/s] or acceleration [m/s^2] record.
    release_time : float
        Time of the turning point at which the decay starts [s]; it may precede the record.
    release_deflection : float
        Displacement from equilibrium at that turning point [m], signed.
    quadratic_drag : float
        d / m [1/m] of a force proportional to the square of the velocity; 0 without drag.
    """

    angular_frequency: float
    damping_ratio: float
    friction_deflection: float
    offset: float
    release_time: float
    release_deflection: float
    quadratic_drag: float = 0.0

    @property
    def half_cycle_ratio(self) -> float:
        """Share of an amplitude that remains after half a cycle of viscous damping alone [1]."""
        return math.exp(-math.pi * self.damping_ratio / math.sqrt(1.0 - self.damping_ratio**2))


def turning_points(parameters: DecayParameters, count: int) -> Array:
    """Compute the displacements from equilibrium at the turning points (m, signed), release first, without drag.

    The sequence ends when the mass sticks, or after ``count`` half cycles.

    >>> k, m, c, friction = 18362.0, 16.0, 120.0, 15.0
    >>> system = DecayParameters((k / m) ** 0.5, c / (2 * (k * m) ** 0.5), friction / k, 0.0, 0.0, 0.020)
    >>> (1e3 * turning_points(system, 20)).round(4).tolist()
    [20.0, -12.7024, 7.5594, -3.9349, 1.3805, 0.4197]
    """
    q = parameters.half_cycle_ratio
    points = [parameters.release_deflection]
    while (
        len(points) <= count
        and abs(points[-1]) > parameters.friction_deflection
        and points[-1] != 0.0
    ):
        shifted = parameters.friction_deflection * math.copysign(1.0, points[-1])
        points.append(shifted - q * (points[-1] - shifted))
    return np.array(points)


def alternating(away: Array) -> Array:
    """Return the amplitudes of turning points about equilibrium, up to the first one on the wrong side.

    >>> alternating(np.array([-20.0, 12.0, -7.0, -1.0])).tolist()
    [20.0, 12.0, 7.0]
    """
    turned = away * np.sign(away[0]) * (-1.0) ** np.arange(len(away))
    wrong = np.flatnonzero(turned <= 0.0)
    amplitudes: Array = turned[: int(wrong[0]) if len(wrong) else len(turned)]
    return amplitudes


@dataclass(frozen=True)
class _Swings:
    """Turning points and, for each sample, the previous one, whether the mass moves, and the time since then (s)."""

    points: Array
    which: NDArray[np.int_]
    moving: NDArray[np.bool_]
    local: Array


def _swings(time: Array, parameters: DecayParameters) -> _Swings:
    since = time - parameters.release_time
    damped = parameters.angular_frequency * math.sqrt(1.0 - parameters.damping_ratio**2)
    halves = int(min(max(float(since.max()) * damped / math.pi, 0.0) + 2.0, _MOST_HALF_CYCLES))
    points = turning_points(parameters, halves)
    last = len(points) - 1
    which = np.clip(np.floor(since * damped / math.pi), 0.0, last).astype(int)
    moving = (since >= 0.0) & (
        (which < last) | (abs(points[last]) > parameters.friction_deflection)
    )
    return _Swings(points, which, moving, np.where(moving, since - which * (math.pi / damped), 0.0))


class _Shape:
    """A swing from 1 towards 0 without friction: its time derivatives, and their slopes by the damping ratio."""

    def __init__(self, parameters: DecayParameters, local: Array) -> None:
        self.omega, self.ratio = parameters.angular_frequency, parameters.damping_ratio
        self.root = math.sqrt(1.0 - self.ratio**2)
        self.phase = self.omega * local
        self.fall = np.exp(-self.ratio * self.phase)
        self.cosine, self.sine = np.cos(self.root * self.phase), np.sin(self.root * self.phase)

    def derivative(self, order: int) -> Array:
        """Return the time derivative of order 0 to 3."""
        omega, share = self.omega, self.ratio / self.root
        if order == 0:
            return np.asarray(self.fall * (self.cosine + share * self.sine))
        if order == 1:
            return np.asarray(-omega / self.root * self.fall * self.sine)
        if order == 2:
            return np.asarray(-(omega**2) * self.fall * (self.cosine - share * self.sine))
        return -2.0 * self.ratio * omega * self.derivative(2) - omega**2 * self.derivative(1)

    def by_ratio(self, order: int) -> Array:
        """Return the slope of a time derivative of order 0 to 2 by the damping ratio, at fixed time since the turn."""
        omega, ratio, root, sine = self.omega, self.ratio, self.root, self.sine
        turn = self.phase * ratio / root
        bent = turn * ratio / root * self.cosine
        if order == 0:
            moved = (turn + root**-3) * sine - bent
        elif order == 1:
            moved = -omega * (ratio / root**3 * sine - turn / root * self.cosine)
        else:
            moved = -(omega**2) * ((turn - root**-3) * sine + bent)
        return np.asarray(self.fall * moved - self.phase * self.derivative(order))


def decay_response(time: Array, parameters: DecayParameters, quantity: Quantity) -> Array:
    """Compute a decay at given times (s): displacement (m, offset included), velocity (m/s) or acceleration (m/s^2).

    Before ``release_time`` the mass is held at the release; once it sticks, it remains at rest.
    """
    if parameters.quadratic_drag != 0.0:
        return _drag_response(time, parameters, quantity)
    swings, order = _swings(time, parameters), order_of(quantity)
    start = swings.points[swings.which]
    shifted = parameters.friction_deflection * np.sign(start)
    moved = (start - shifted) * _Shape(parameters, swings.local).derivative(order)
    if order == 0:
        return np.where(swings.moving, shifted + moved, start) + parameters.offset
    return np.where(swings.moving, moved, 0.0) + parameters.offset


def decay_slopes(time: Array, parameters: DecayParameters, quantity: Quantity) -> Array:
    """Return the slopes of ``decay_response`` without drag by all parameters except the drag, in order; shape (n, 6).

    At a jump (of the acceleration, at a turning point with friction) the slopes are those of the adjacent swing.
    """
    omega, ratio = parameters.angular_frequency, parameters.damping_ratio
    swings, order = _swings(time, parameters), order_of(quantity)
    points, which = swings.points, swings.which
    shape = _Shape(parameters, swings.local)
    value, rate = shape.derivative(order), shape.derivative(order + 1)
    side = np.sign(points)
    swing = (points - parameters.friction_deflection * side)[which]
    by_ratio, by_friction, by_release = _slopes_of_points(points, parameters)
    reached = which * (math.pi / omega) / shape.root  # how long the mass took to this turning point
    at_start = 1.0 if order == 0 else 0.0
    slopes = np.ones((len(time), 6))
    slopes[:, 0] = swing * (order * value + (swings.local + reached) * rate) / omega
    slopes[:, 1] = by_ratio[which] * value + swing * (
        shape.by_ratio(order) - rate * reached * ratio / shape.root**2
    )
    slopes[:, 2] = (by_friction - side)[which] * value + at_start * side[which]
    slopes[:, 4] = -swing * rate
    slopes[:, 5] = by_release[which] * value
    still = ~swings.moving
    for column, of_point in (
        (0, None),
        (1, by_ratio),
        (2, by_friction),
        (4, None),
        (5, by_release),
    ):
        slopes[still, column] = 0.0 if of_point is None else at_start * of_point[which[still]]
    return slopes


def _slopes_of_points(points: Array, parameters: DecayParameters) -> tuple[Array, Array, Array]:
    """Return the slopes of the turning points by damping ratio, friction deflection and release deflection."""
    q, friction = parameters.half_cycle_ratio, parameters.friction_deflection
    slope_of_q = -math.pi * q / (1.0 - parameters.damping_ratio**2) ** 1.5
    by_ratio, by_friction = [0.0], [0.0]
    for point in points[:-1].tolist():
        side = math.copysign(1.0, point)
        by_ratio.append(-q * by_ratio[-1] - slope_of_q * (point - friction * side))
        by_friction.append((1.0 + q) * side - q * by_friction[-1])
    return (
        np.array(by_ratio),
        np.array(by_friction),
        np.asarray((-q) ** np.arange(len(points)), dtype=np.float64),
    )


def _drag_response(time: Array, parameters: DecayParameters, quantity: Quantity) -> Array:
    from jounce.identify.decay_path import drag_path  # loads machine code

    since = np.ascontiguousarray(time - parameters.release_time)
    names = (
        "angular_frequency",
        "damping_ratio",
        "friction_deflection",
        "quadratic_drag",
        "release_deflection",
    )
    path = drag_path(since, *(float(getattr(parameters, name)) for name in names))
    response: Array = path[order_of(quantity)] + parameters.offset
    return response
