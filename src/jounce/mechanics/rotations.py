"""Rotations as expressions: quaternions, turns about a fixed axis, cross-product matrices."""

from __future__ import annotations

import casadi as ca


def quaternion_matrix(e: ca.SX) -> ca.SX:
    """Rotation matrix of a unit quaternion (e0 scalar part)."""
    w, x, y, z = e[0], e[1], e[2], e[3]
    return ca.vertcat(
        ca.horzcat(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        ca.horzcat(2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        ca.horzcat(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


def quaternion_rate(e: ca.SX, w: ca.SX) -> ca.SX:
    """Rate of a quaternion (1/s) for the angular velocity ``w`` (rad/s) in the body's own axes."""
    vector = e[1:]
    return 0.5 * ca.vertcat(-ca.dot(vector, w), e[0] * w + ca.cross(vector, w))


def skew(a: ca.SX) -> ca.SX:
    """Matrix of the cross product ``a x``."""
    zero = ca.SX(1, 1)
    return ca.vertcat(
        ca.horzcat(zero, -a[2], a[1]),
        ca.horzcat(a[2], zero, -a[0]),
        ca.horzcat(-a[1], a[0], zero),
    )


def unit(a: ca.SX) -> ca.SX:
    """Vector of length one along ``a``."""
    return a / ca.sqrt(ca.dot(a, a))


def normals(axis: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Two unit vectors that form a right-handed frame ``(n1, n2, axis)`` with a unit vector.

    They lean on the ground axis that is farthest from ``axis``.
    """
    x, y, z = (ca.fabs(axis[i]) for i in range(3))
    is_x = ca.logic_and(x <= y, x <= z)
    is_y = ca.logic_and(ca.logic_not(is_x), y <= z)
    second = unit(ca.cross(axis, ca.vertcat(is_x, is_y, 1 - is_x - is_y)))
    return ca.cross(second, axis), second
