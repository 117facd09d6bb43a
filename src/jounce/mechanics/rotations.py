"""Rotations as expressions: quaternions, rotations about a fixed axis, cross-product matrices."""

from __future__ import annotations

import casadi as ca


def quaternion_matrix(e: ca.SX) -> ca.SX:
    """Return the rotation matrix of a unit quaternion (scalar part e0)."""
    w, x, y, z = e[0], e[1], e[2], e[3]
    return ca.vertcat(
        ca.horzcat(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        ca.horzcat(2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        ca.horzcat(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


def quaternion_rate(e: ca.SX, w: ca.SX) -> ca.SX:
    """Return the rate of a quaternion (1/s) for the angular velocity ``w`` (rad/s) in the body's own axes."""
    vector = e[1:]
    return 0.5 * ca.vertcat(-ca.dot(vector, w), e[0] * w + ca.cross(vector, w))


def skew(a: ca.SX) -> ca.SX:
    """Return the matrix of the cross product ``a x``."""
    zero = ca.SX(1, 1)
    return ca.vertcat(
        ca.horzcat(zero, -a[2], a[1]),
        ca.horzcat(a[2], zero, -a[0]),
        ca.horzcat(-a[1], a[0], zero),
    )


def unit(a: ca.SX) -> ca.SX:
    """Return the unit vector along ``a``."""
    return a / ca.sqrt(ca.dot(a, a))


def rotate(vector: ca.SX, axis: ca.SX, angle: ca.SX) -> ca.SX:
    """Rotate a vector about a unit axis by a right-handed angle, rad."""
    along = ca.dot(axis, vector) * axis
    return along + (vector - along) * ca.cos(angle) + ca.cross(axis, vector) * ca.sin(angle)


def normals(axis: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Return two unit vectors that form a right-handed frame ``(n1, n2, axis)`` with a unit vector.

    They are constructed from the ground axis that is farthest from ``axis``.
    """
    x, y, z = (ca.fabs(axis[i]) for i in range(3))
    is_x = ca.logic_and(x <= y, x <= z)
    is_y = ca.logic_and(ca.logic_not(is_x), y <= z)
    second = unit(ca.cross(axis, ca.vertcat(is_x, is_y, 1 - is_x - is_y)))
    return ca.cross(second, axis), second


def matrix_quaternion(matrix: ca.SX) -> ca.SX:
    """Return the unit quaternion of a rotation matrix, scalar part first and never negative.

    It uses the one of the four formulas with the largest divisor.
    """
    m, trace = matrix, ca.trace(matrix)
    sizes = [trace, *(2.0 * m[i, i] - trace for i in range(3))]
    candidates = [
        ca.vertcat(1.0 + trace, m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]),
        ca.vertcat(m[2, 1] - m[1, 2], 1.0 + sizes[1], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0]),
        ca.vertcat(m[0, 2] - m[2, 0], m[0, 1] + m[1, 0], 1.0 + sizes[2], m[1, 2] + m[2, 1]),
        ca.vertcat(m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], 1.0 + sizes[3]),
    ]
    best, result = sizes[0], candidates[0]
    for size, candidate in zip(sizes[1:], candidates[1:], strict=True):
        result = ca.if_else(size > best, candidate, result)
        best = ca.fmax(size, best)
    result = ca.if_else(result[0] < 0.0, -result, result)
    return result / ca.sqrt(ca.dot(result, result))


_SMALL = 0.1  # rad: the series is exact to the last bit below, the closed form above
_TINY = 1e-24  # keeps the slope of a square root finite at zero rotation
_SERIES = (1 / 47900160, 1 / 1209600, 1 / 30240, 1 / 720, 1 / 12)
"""Coefficients of ``(1 - h cot(h)) / (2 h)^2`` in the square of the angle ``2 h``, highest power first."""


def rotation_vector(matrix: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Return the rotation vector (axis times angle, rad) of a rotation matrix, and the matrix from spin to its rate.

    The angle is below 180 degrees, where the axis jumps. The spin is that of the rotated axes, in the original axes.
    """
    lean = 0.5 * ca.vertcat(
        matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]
    )
    sine = ca.sqrt(ca.dot(lean, lean) + _TINY)
    angle = ca.atan2(sine, 0.5 * (ca.trace(matrix) - 1.0))
    vector = angle / sine * lean
    half = 0.5 * ca.fmax(angle, _SMALL)
    closed = (1.0 - half * ca.cos(half) / ca.sin(half)) / (4.0 * half * half)
    series = ca.SX(0)
    for factor in _SERIES:
        series = series * ca.dot(vector, vector) + factor
    cross = skew(vector)
    bend = ca.if_else(angle < _SMALL, series, closed)
    return vector, ca.SX.eye(3) - 0.5 * cross + bend * (cross @ cross)


def roll_pitch_yaw(matrix: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Return roll, pitch and yaw (rad) of a rotation matrix (intrinsic z-y'-x'', ISO 8855)."""
    pitch = -ca.asin(ca.fmin(ca.fmax(matrix[2, 0], -1.0), 1.0))
    return ca.atan2(matrix[2, 1], matrix[2, 2]), pitch, ca.atan2(matrix[1, 0], matrix[0, 0])
