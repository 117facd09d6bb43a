"""Newton's method for bodies between elastic elements (see ``kernel.equilibrium``).

A step starts from an extrapolation of the steps before. The matrix of its first iteration is kept while the changes
shrink fast; a step that does not settle is halved.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from jounce.kernel.equilibrium import (
    ALIGN,
    ALONG,
    BUSHING,
    DISTANCE,
    DOT,
    FACTOR,
    HOLD,
    LENGTH,
    LINE,
    LOADS,
    NO_EQUILIBRIUM,
    POINT,
    POLYNOMIAL,
    POWER,
    PRELOAD,
    RATE,
    SETTLED,
    SIGN,
    SINGULAR,
    SLIP,
    STOP,
    TABLE,
    TWIST,
    A,
    Assembly,
    B,
    C,
    F,
    K,
    P,
    Path,
    Q,
    S,
    Seeds,
    Settled,
    Space,
)
from jounce.kernel.loops.compiling import part

Triple = tuple[float, float, float]
_SCALE = 1e6  # N/m: makes rows and columns of constraints as large as those of stiff joints
_ITERATIONS = 60
_FRESH = 1e-8  # m, rad: change after which a step with the exact matrix is exact
_KEPT = 1e-12  # the same with a matrix of a pose nearby
_SLOW = 0.03  # ratio of two changes above which the matrix is formed again
_LEAST = 1.0 / 32.0  # share of a step
_FARTHEST = 0.1  # m, rad: change of a pose in a step, which keeps it on its branch
_LARGEST = 0.5  # m, rad: a change that no mechanism makes in a step
_SHORTEST = 1.0 / 512.0  # of a step
_SMALLEST = 1e-13  # pivot, as a share of the largest: rounding
_ORTHOGONAL = 20  # iterations; two after small steps. What is left would deform a body for good
_TAKEN = 0.01  # of the largest entry of its column: the least that is taken as a pivot
_FLAT = 1e-4  # rad: rotation below which a series is exact


@part()
def _cross(a: Triple, b: Triple) -> Any:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


@part()
def _dot(a: Triple, b: Triple) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@part()
def _plus(a: Triple, b: Triple) -> Any:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


@part()
def _minus(a: Triple, b: Triple) -> Any:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


@part()
def _times(k: float, a: Triple) -> Any:
    return (k * a[0], k * a[1], k * a[2])


@part()
def _unit(j: int) -> Triple:
    return (1.0 if j == 0 else 0.0, 1.0 if j == 1 else 0.0, 1.0 if j == 2 else 0.0)


@part()
def _turn(pose: Any, body: int, v: Triple) -> Any:
    """Return a direction of the design, turned with a body."""
    if body < 0:
        return v
    r = pose[body]
    return (
        r[3] * v[0] + r[4] * v[1] + r[5] * v[2],
        r[6] * v[0] + r[7] * v[1] + r[8] * v[2],
        r[9] * v[0] + r[10] * v[1] + r[11] * v[2],
    )


@part()
def _back(pose: Any, body: int, v: Triple) -> Any:
    """Return a direction in the axes of a body."""
    if body < 0:
        return v
    r = pose[body]
    return (
        r[3] * v[0] + r[6] * v[1] + r[9] * v[2],
        r[4] * v[0] + r[7] * v[1] + r[10] * v[2],
        r[5] * v[0] + r[8] * v[1] + r[11] * v[2],
    )


@part()
def _place(pose: Any, body: int, v: Triple) -> Any:
    """Return a point of the design, moved with a body."""
    if body < 0:
        return v
    r = pose[body]
    return _plus((r[0], r[1], r[2]), _turn(pose, body, v))


@part()
def _triple(row: Any, first: int) -> Any:
    return (row[first], row[first + 1], row[first + 2])


# rotations ------------------------------------------------------------------------------------------------------------


@part()
def _rotation_vector(pose: Any, a: int, b: int) -> Any:
    """Return axis times angle of the second body relative to the first, in the axes of the first."""
    x = _back(pose, a, _turn(pose, b, _unit(0)))
    y = _back(pose, a, _turn(pose, b, _unit(1)))
    z = _back(pose, a, _turn(pose, b, _unit(2)))
    sine = (0.5 * (y[2] - z[1]), 0.5 * (z[0] - x[2]), 0.5 * (x[1] - y[0]))
    size = math.sqrt(_dot(sine, sine))
    angle = math.atan2(size, 0.5 * (x[0] + y[1] + z[2] - 1.0))
    return _times(1.0 + size * size / 6.0 if size < _FLAT else angle / size, sine)


@part()
def _bend(angle: float) -> tuple[float, float]:
    """Return ``c = (1 - angle/2 cot(angle/2)) / angle^2`` and its derivative divided by the angle."""
    if angle < 0.05:
        square = angle * angle
        return (
            1.0 / 12.0 + square / 720.0 + square * square / 30240.0,
            1.0 / 360.0 + square / 7560.0 + square * square / 201600.0,
        )
    half = 0.5 * angle
    cot = math.cos(half) / math.sin(half)
    c = (1.0 - half * cot) / (angle * angle)
    slope = (-0.5 * cot + 0.5 * half * (1.0 + cot * cot)) / (angle * angle) - 2.0 * c / angle
    return c, slope / angle


@part()
def _twist(theta: Triple, t: Triple) -> Any:
    """Return the torque of a twist: transpose of the rate of the rotation vector by the spin, times ``t``."""
    c, _ = _bend(math.sqrt(_dot(theta, theta)))
    across = _cross(theta, t)
    return _plus(t, _plus(_times(0.5, across), _times(c, _cross(theta, across))))


@part()
def _twist_change(theta: Triple, t: Triple, d: Triple) -> Any:
    """Return the change of ``_twist`` for a change of the rotation vector at constant ``t``."""
    square = _dot(theta, theta)
    c, slope = _bend(math.sqrt(square))
    along = _dot(theta, t)
    change = _minus(_times(_dot(d, t), theta), _times(2.0 * _dot(theta, d), t))
    change = _times(c, _plus(change, _times(along, d)))
    bent = _minus(_times(along, theta), _times(square, t))
    change = _plus(change, _times(slope * _dot(theta, d), bent))
    return _plus(change, _times(0.5, _cross(d, t)))


@part()
def _unwound(theta: Triple, spin: Triple) -> Any:
    """Return the rate of the rotation vector for a spin in the axes of the first body."""
    c, _ = _bend(math.sqrt(_dot(theta, theta)))
    across = _cross(theta, spin)
    return _plus(spin, _plus(_times(-0.5, across), _times(c, _cross(theta, across))))


@part()
def _move(pose: Any, body: int, v: Triple, w: Triple) -> None:
    """Rotate a body about the ground's origin by exactly ``w``, and shift it by ``v``."""
    r = pose[body]
    angle = math.sqrt(_dot(w, w))
    s = 1.0 - angle * angle / 6.0 if angle < _FLAT else math.sin(angle) / angle
    c = 0.5 - angle * angle / 24.0 if angle < _FLAT else (1.0 - math.cos(angle)) / (angle * angle)
    for j in range(4):  # place, and columns of the rotation
        x = (r[0], r[1], r[2]) if j == 0 else (r[2 + j], r[5 + j], r[8 + j])
        first = _cross(w, x)
        x = _plus(x, _plus(_times(s, first), _times(c, _cross(w, first))))
        if j == 0:
            r[0], r[1], r[2] = x[0] + v[0], x[1] + v[1], x[2] + v[2]
        else:
            r[2 + j], r[5 + j], r[8 + j] = x


@part()
def _orthogonal(pose: Any, body: int) -> None:
    """Make a nearly orthogonal matrix orthogonal."""
    r = pose[body]
    for _ in range(_ORTHOGONAL):
        x, y, z = _triple(r, 3), _triple(r, 6), _triple(r, 9)
        xx, yy, zz = 1.5 - 0.5 * _dot(x, x), 1.5 - 0.5 * _dot(y, y), 1.5 - 0.5 * _dot(z, z)
        xy, xz, yz = -0.5 * _dot(x, y), -0.5 * _dot(x, z), -0.5 * _dot(y, z)
        for j in range(3):
            r[3 + j] = xx * x[j] + xy * y[j] + xz * z[j]
            r[6 + j] = xy * x[j] + yy * y[j] + yz * z[j]
            r[9 + j] = xz * x[j] + yz * y[j] + zz * z[j]
        off = max(abs(xx - 1.0), abs(yy - 1.0), abs(zz - 1.0), abs(xy), abs(xz), abs(yz))
        if off < 1e-9:  # it was squared by this iteration
            return


# laws -----------------------------------------------------------------------------------------------------------------


@part()
def _law(assembly: Any, law: int, x: float, linear: float) -> tuple[float, float]:
    """Return a law's force and its slope."""
    if law < 0:
        return linear * x, linear
    kind, first, count = assembly.laws[law, 0], assembly.laws[law, 1], assembly.laws[law, 2]
    data = assembly.law_data
    if kind == POLYNOMIAL:
        force, slope = 0.0, 0.0
        for i in range(count - 1, -1, -1):
            slope = slope * x + force
            force = force * x + data[first + i]
        return force * x, slope * x + force
    if kind == POWER:
        if x <= 0.0:
            return 0.0, 0.0
        force = data[first] * x ** data[first + 1]
        return force, data[first + 1] * force / x
    if kind == TABLE:
        last = first + count
        i = first
        while i < last - 2 and x > data[i + 1]:
            i += 1
        slope = (data[count + i + 1] - data[count + i]) / (data[i + 1] - data[i])
        return data[count + i] + slope * (x - data[i]), slope
    if kind == STOP:
        past = x - data[first]
        if past <= 0.0:
            return 0.0, 0.0
        rate, progression = data[first + 1], data[first + 2]
        return past * (rate + progression * past * past), rate + 3.0 * progression * past * past
    return 0.0, 0.0


@part()
def _elastic(
    assembly: Any, element: int, i: int, x: float, slipped: float
) -> tuple[float, float, float]:
    """Return force on the second body along direction ``i`` of a bushing, its slope, and what the curve alone gives."""
    row = assembly.data[element]
    law = assembly.kinds[element, 4 + i]
    force, slope = _law(assembly, law, x, row[K + i])
    bare = force
    if law >= 0:
        force, slope = row[C + i] * force, row[C + i] * slope
    force, slope = row[F + i] - force, -slope
    hold = row[B + i]
    if hold > 0.0:
        dry = hold * (x - slipped)
        if abs(dry) > row[S + i]:
            force -= math.copysign(row[S + i], dry)
        else:
            force, slope = force - dry, slope - hold
    return force, slope, bare


@part()
def _push(assembly: Any, element: int, length: float, slipped: float) -> tuple[float, float, float]:
    """Return the force of a line, pushing apart, its slope by length, and what its curve alone gives."""
    row = assembly.data[element]
    sign, law = row[SIGN], assembly.kinds[element, 4]
    bare, slope = _law(assembly, law, sign * (row[LENGTH] - length), row[RATE])
    factor = row[FACTOR] if law >= 0 else 1.0
    force, slope = row[PRELOAD] + sign * factor * bare, -factor * slope
    if row[HOLD] > 0.0:
        dry = row[HOLD] * (length - slipped)
        if abs(dry) > row[SLIP]:
            force -= math.copysign(row[SLIP], dry)
        else:
            force, slope = force - dry, slope - row[HOLD]
    return force, slope, bare


# residual and matrix --------------------------------------------------------------------------------------------------


@part()
def _add(space: Any, column: int, body: int, sign: float, force: Triple, moment: Triple) -> None:
    """Add a force and a moment on a body, with the opposite sign, to a right-hand side."""
    if body < 0:
        return
    for j in range(3):
        space.right[6 * body + j, column] -= sign * force[j]
        space.right[6 * body + 3 + j, column] -= sign * moment[j]


@part()
def _enter(space: Any, body: int, sign: float, column: int, force: Triple, moment: Triple) -> None:
    """Add the change of a force and a moment on a body to the column of an unknown."""
    if body < 0:
        return
    for j in range(3):
        space.matrix[6 * body + j, column] += sign * force[j]
        space.matrix[6 * body + 3 + j, column] += sign * moment[j]


@part()
def _row(space: Any, row: int, body: int, sign: float, force: Triple, moment: Triple) -> None:
    """Add the slopes of an equation of a constraint by the motion of a body."""
    if body < 0:
        return
    for j in range(3):
        space.matrix[row, 6 * body + j] += _SCALE * sign * force[j]
        space.matrix[row, 6 * body + 3 + j] += _SCALE * sign * moment[j]


@part()
def _couple(
    space: Any,
    a: int,
    b: int,
    xa: Triple,
    xb: Triple,
    force: Triple,
    stiff: Any,
    follows: bool,
    torque: Triple,
) -> None:
    """Add the changes of force and torque between two bodies by their motions.

    ``stiff`` has in rows 0 to 2 the force's slope by displacement, in rows 3 to 5 the torque's by rotation.
    Directions that follow the first body turn force and torque with it, and its lever is the point of the second.
    """
    lever = xb if follows else xa
    for side in range(2):
        body = b if side == 0 else a
        if body < 0:
            continue
        sign = 1.0 if side == 0 else -1.0
        for j in range(6):
            d = _unit(j % 3)
            moved = d if j < 3 else _cross(d, xb if side == 0 else lever)
            change = (
                sign * (stiff[0, 0] * moved[0] + stiff[0, 1] * moved[1] + stiff[0, 2] * moved[2]),
                sign * (stiff[1, 0] * moved[0] + stiff[1, 1] * moved[1] + stiff[1, 2] * moved[2]),
                sign * (stiff[2, 0] * moved[0] + stiff[2, 1] * moved[1] + stiff[2, 2] * moved[2]),
            )
            turned = (0.0, 0.0, 0.0)
            if j >= 3:
                i = j - 3
                turned = (sign * stiff[3, i], sign * stiff[4, i], sign * stiff[5, i])
                if follows and side == 1:
                    change = _plus(change, _cross(d, force))
                    turned = _plus(turned, _cross(d, torque))
            moment = _plus(_cross(xb, change), turned)
            if side == 0:
                moment = _plus(moment, _cross(moved, force))
            _enter(space, b, 1.0, 6 * body + j, change, moment)
            _enter(space, a, -1.0, 6 * body + j, change, moment)


@part()
def _hand(row: Any) -> float:
    """Return -1 for axes that are a mirror image: rotations about them count the other way."""
    volume = _dot(_triple(row, A), _cross(_triple(row, A + 3), _triple(row, A + 6)))
    return 1.0 if volume > 0.0 else -1.0


@part()
def _bushing(
    assembly: Any, settled: Any, space: Any, element: int, step: int, tangent: bool
) -> None:
    pose, row, stiff = space.pose, assembly.data[element], space.work
    a, b = assembly.kinds[element, 1], assembly.kinds[element, 2]
    point = _triple(row, P)
    xa, xb = _place(pose, a, point), _place(pose, b, point)
    gap = _minus(xb, xa)
    theta = _rotation_vector(pose, a, b)
    force, inner = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    hand = _hand(row)
    for i in range(9):
        for j in range(3):
            stiff[i, j] = 0.0
    for i in range(3):
        own = _triple(row, A + 3 * i)
        axis = _turn(pose, a, own)
        own = _times(hand, own)
        f, slope, _ = _elastic(assembly, element, i, _dot(axis, gap), space.slipped[element, i])
        t, bend, _ = _elastic(
            assembly, element, 3 + i, _dot(own, theta), space.slipped[element, 3 + i]
        )
        force, inner = _plus(force, _times(f, axis)), _plus(inner, _times(t, own))
        if step >= 0:
            settled.forces[step, 6 * element + i] = f
            settled.forces[step, 6 * element + 3 + i] = t
        if tangent:
            for k in range(3):
                for j in range(3):
                    stiff[k, j] += slope * axis[k] * axis[j]
                    stiff[6 + k, j] += bend * own[k] * own[j]
    torque = _turn(pose, a, _twist(theta, inner))
    moment = _plus(_cross(xb, force), torque)
    _add(space, 0, b, 1.0, force, moment)
    _add(space, 0, a, -1.0, force, moment)
    if tangent:
        for j in range(3):
            rate = _unwound(theta, _back(pose, a, _unit(j)))
            change = (
                stiff[6, 0] * rate[0] + stiff[6, 1] * rate[1] + stiff[6, 2] * rate[2],
                stiff[7, 0] * rate[0] + stiff[7, 1] * rate[1] + stiff[7, 2] * rate[2],
                stiff[8, 0] * rate[0] + stiff[8, 1] * rate[1] + stiff[8, 2] * rate[2],
            )
            turned = _plus(_twist(theta, change), _twist_change(theta, inner, rate))
            turned = _turn(pose, a, turned)
            for k in range(3):
                stiff[3 + k, j] = turned[k]
        _couple(space, a, b, xa, xb, force, stiff, True, torque)


@part()
def _along(stiff: Any, n: Triple, slope: float, across: float) -> None:
    for i in range(3):
        for j in range(3):
            stiff[i, j] = (slope - across) * n[i] * n[j] + (across if i == j else 0.0)
            stiff[3 + i, j] = 0.0


@part()
def _line(assembly: Any, settled: Any, space: Any, element: int, step: int, tangent: bool) -> None:
    pose, row = space.pose, assembly.data[element]
    a, b = assembly.kinds[element, 1], assembly.kinds[element, 2]
    xa, xb = _place(pose, a, _triple(row, P)), _place(pose, b, _triple(row, Q))
    reach = _minus(xb, xa)
    length = math.sqrt(_dot(reach, reach))
    n = _times(1.0 / length, reach)
    f, slope, _ = _push(assembly, element, length, space.slipped[element, 0])
    force = _times(f, n)
    moment = _cross(xb, force)
    _add(space, 0, b, 1.0, force, moment)
    _add(space, 0, a, -1.0, force, moment)
    if step >= 0:
        settled.forces[step, 6 * element] = f
        settled.forces[step, 6 * element + 1] = length
    if tangent:
        _along(space.work, n, slope, f / length)
        _couple(space, a, b, xa, xb, force, space.work, False, (0.0, 0.0, 0.0))


@part()
def _wound(pose: Any, row: Any, a: int, b: int) -> float:
    """Return the rotation of the second body about an axis that it shares with the first."""
    u, w = _triple(row, P), _triple(row, Q)
    now = _back(pose, a, _turn(pose, b, w))
    return math.atan2(_dot(now, _cross(u, w)), _dot(now, w))


@part()
def _twisted(
    assembly: Any, settled: Any, space: Any, element: int, step: int, tangent: bool
) -> None:
    pose, row, stiff = space.pose, assembly.data[element], space.work
    a, b = assembly.kinds[element, 1], assembly.kinds[element, 2]
    angle = _wound(pose, row, a, b) - row[LENGTH]
    tau = row[PRELOAD] - row[RATE] * angle
    axis = _turn(pose, a, _triple(row, P))
    torque, none = _times(tau, axis), (0.0, 0.0, 0.0)
    _add(space, 0, b, 1.0, none, torque)
    _add(space, 0, a, -1.0, none, torque)
    if step >= 0:
        settled.forces[step, 6 * element] = tau
        settled.forces[step, 6 * element + 1] = angle
    if tangent:
        for i in range(3):
            for j in range(3):
                stiff[i, j] = 0.0
                stiff[3 + i, j] = -row[RATE] * axis[i] * axis[j]
        _couple(space, a, b, none, none, none, stiff, True, torque)


@part()
def _multiply(
    space: Any, a: int, b: int, column: int, n: Triple, lever_a: Triple, lever_b: Triple
) -> None:
    """Enter a multiplier's force along ``n`` with its levers, and the row of its equation."""
    at_b, at_a = _cross(lever_b, n), _cross(lever_a, n)
    scaled = _times(_SCALE, n)
    _enter(space, b, 1.0, column, scaled, _times(_SCALE, at_b))
    _enter(space, a, -1.0, column, scaled, _times(_SCALE, at_a))


@part()
def _rigid(assembly: Any, space: Any, element: int, first: int, tangent: bool) -> None:
    """Add forces and equations of a constraint."""
    pose, row, stiff = space.pose, assembly.data[element], space.work
    kind, a, b = (
        assembly.kinds[element, 0],
        assembly.kinds[element, 1],
        assembly.kinds[element, 2],
    )
    at = assembly.kinds[element, 3]
    if kind == DOT and at < 0:
        return
    multipliers, n, none = space.multipliers[0], first + at, (0.0, 0.0, 0.0)
    xa, xb = _place(pose, a, _triple(row, P)), _place(pose, b, _triple(row, Q))
    if kind == POINT:
        force = _triple(multipliers, at)
        _add(space, 0, b, 1.0, force, _cross(xb, force))
        _add(space, 0, a, -1.0, force, _cross(xa, force))
        for i in range(3):
            space.right[n + i, 0] -= _SCALE * (xb[i] - xa[i])
        if tangent:
            for i in range(3):
                d = _unit(i)
                _multiply(space, a, b, n + i, d, xa, xb)
                _row(space, n + i, b, 1.0, d, _cross(xb, d))
                _row(space, n + i, a, -1.0, d, _cross(xa, d))
                if b >= 0:
                    moment = _cross(_cross(d, xb), force)
                    _enter(space, b, 1.0, 6 * b + 3 + i, none, moment)
                    moment = _cross(d, force)
                    _enter(space, b, 1.0, 6 * b + i, none, moment)
                if a >= 0:
                    moment = _cross(_cross(d, xa), force)
                    _enter(space, a, -1.0, 6 * a + 3 + i, none, moment)
                    moment = _cross(d, force)
                    _enter(space, a, -1.0, 6 * a + i, none, moment)
        return
    force = multipliers[at]
    if kind == DISTANCE:
        reach = _minus(xb, xa)
        length = math.sqrt(_dot(reach, reach))
        e = _times(1.0 / length, reach)
        pushed = _times(force, e)
        moment = _cross(xb, pushed)
        _add(space, 0, b, 1.0, pushed, moment)
        _add(space, 0, a, -1.0, pushed, moment)
        space.right[n, 0] -= _SCALE * (length - row[LENGTH])
        if tangent:
            _multiply(space, a, b, n, e, xb, xb)
            _row(space, n, b, 1.0, e, _cross(xb, e))
            _row(space, n, a, -1.0, e, _cross(xb, e))
            _along(stiff, e, 0.0, force / length)
            _couple(space, a, b, xa, xb, pushed, stiff, False, none)
        return
    e = _turn(pose, a, _triple(row, A if kind == ALIGN else ALONG))
    if kind == ALIGN:
        f = _turn(pose, b, _triple(row, P))
        axis = _cross(f, e)
        torque = _times(force, axis)
        _add(space, 0, b, 1.0, none, torque)
        _add(space, 0, a, -1.0, none, torque)
        space.right[n, 0] -= _SCALE * (_dot(e, f) - row[LENGTH])
        if tangent:
            scaled = _times(_SCALE, axis)
            _enter(space, b, 1.0, n, none, scaled)
            _enter(space, a, -1.0, n, none, scaled)
            _row(space, n, b, 1.0, none, axis)
            _row(space, n, a, -1.0, none, axis)
            for i in range(3):
                d = _unit(i)
                if b >= 0:
                    change = _times(force, _cross(_cross(d, f), e))
                    _enter(space, b, 1.0, 6 * b + 3 + i, none, change)
                    _enter(space, a, -1.0, 6 * b + 3 + i, none, change)
                if a >= 0:
                    change = _times(force, _cross(f, _cross(d, e)))
                    _enter(space, b, 1.0, 6 * a + 3 + i, none, change)
                    _enter(space, a, -1.0, 6 * a + 3 + i, none, change)
        return
    reach = _minus(xb, xa)
    pushed = _times(force, e)
    moment = _cross(xb, pushed)
    _add(space, 0, b, 1.0, pushed, moment)
    _add(space, 0, a, -1.0, pushed, moment)
    space.right[n, 0] -= _SCALE * (_dot(e, reach) - row[LENGTH])
    if tangent:
        _multiply(space, a, b, n, e, xb, xb)
        _row(space, n, b, 1.0, e, _cross(xb, e))
        _row(space, n, a, -1.0, e, _cross(xb, e))
        for i in range(3):
            for j in range(3):
                stiff[i, j] = stiff[3 + i, j] = 0.0
        _couple(space, a, b, xa, xb, pushed, stiff, True, none)


# wheels and controls --------------------------------------------------------------------------------------------------


@part()
def _contact(pose: Any, assembly: Any, wheel: int) -> tuple[Triple, Triple, Triple, Triple]:
    """Return wheel centre, contact point, the wheel's axis and the direction down in its plane."""
    row, body = assembly.wheels[wheel], assembly.carriers[wheel]
    centre, s = _place(pose, body, _triple(row, 0)), _turn(pose, body, _triple(row, 3))
    level = math.sqrt(1.0 - s[2] * s[2])
    down = (s[0] * s[2] / level, s[1] * s[2] / level, (s[2] * s[2] - 1.0) / level)
    return centre, _plus(centre, _times(row[6], down)), s, down


@part()
def _lowered(s: Triple, down: Triple, change: Triple) -> Any:
    """Return the change of the direction down for a change of the wheel's axis."""
    level = math.sqrt(1.0 - s[2] * s[2])
    bent = _plus(_times(s[2], change), _times(change[2], s))
    return _times(1.0 / level, _plus(bent, _times(s[2] * change[2] / level, down)))


@part()
def _ahead(s: Triple) -> Triple:
    """Return the level direction in which a wheel with this axis heads."""
    scale = math.copysign(1.0, s[1]) / math.sqrt(1.0 - s[2] * s[2])
    return scale * s[1], -scale * s[0], 0.0


@part()
def _swung(s: Triple, change: Triple) -> Any:
    """Return the change of the heading for a change of the wheel's axis."""
    square = 1.0 - s[2] * s[2]
    scale = math.copysign(1.0, s[1]) / math.sqrt(square)
    turned = (scale * change[1], -scale * change[0], 0.0)
    return _plus(turned, _times(s[2] * change[2] / square, _ahead(s)))


@part()
def _load(assembly: Any, space: Any, wheel: int) -> tuple[Triple, float, Triple, float]:
    """Return the horizontal force, moment, force at the centre, and how far behind the first acts."""
    now, i = space.now, len(assembly.controls) + wheel * LOADS
    through = (now[i + 3], now[i + 4], now[i + 5])
    return (now[i], now[i + 1], 0.0), now[i + 2], through, now[i + 6]


@part()
def _wheel(assembly: Any, space: Any, wheel: int, tangent: bool) -> None:
    """Add the loads on a wheel; the vertical force is a control's."""
    pose, body = space.pose, assembly.carriers[wheel]
    centre, contact, s, down = _contact(pose, assembly, wheel)
    radius = assembly.wheels[wheel, 6]
    level, aligning, through, trail = _load(assembly, space, wheel)
    at = _minus(contact, _times(trail, _ahead(s)))
    moment = _plus(_cross(at, level), _cross(centre, through))
    moment = _plus(moment, (0.0, 0.0, aligning))
    _add(space, 0, body, 1.0, _plus(level, through), moment)
    if not tangent:
        return
    none = (0.0, 0.0, 0.0)
    for j in range(6):
        d = _unit(j % 3)
        moved, lowered = d, none
        if j >= 3:
            moved, turned = _cross(d, centre), _cross(d, s)
            lowered = _times(radius, _lowered(s, down, turned))
            lowered = _minus(lowered, _times(trail, _swung(s, turned)))
        change = _plus(_cross(_plus(moved, lowered), level), _cross(moved, through))
        _enter(space, body, 1.0, 6 * body + j, none, change)


@part()
def _control(
    assembly: Any, path: Any, space: Any, index: int, step: int, first: int, tangent: bool
) -> None:
    """Add the force of a control, and its value in the equations of the step."""
    pose = space.pose
    kind, which = assembly.controls[index, 0], assembly.controls[index, 1]
    multiplier = space.multipliers[0, first - 6 * _bodies(space) + index]
    e, a, b = (0.0, 0.0, 1.0), -1, -1
    if kind == 0:
        centre, at, s, down = _contact(pose, assembly, which)
        b, value = assembly.carriers[which], at[2]
    else:
        row = assembly.data[which]
        a, b = assembly.kinds[which, 1], assembly.kinds[which, 2]
        e = _turn(pose, a, _triple(row, ALONG))
        back, at = _place(pose, a, _triple(row, P)), _place(pose, b, _triple(row, Q))
        value = _dot(e, _minus(at, back)) - row[LENGTH]
    pushed = _times(multiplier, e)
    moment = _cross(at, pushed)
    _add(space, 0, b, 1.0, pushed, moment)
    _add(space, 0, a, -1.0, pushed, moment)
    for i in range(len(assembly.controls)):
        weight = path.values[step, i * len(assembly.controls) + index]
        space.right[first + i, 0] -= _SCALE * weight * value
        share = path.forces[step, i * len(assembly.controls) + index]
        space.right[first + i, 0] -= share * multiplier
        if tangent:
            space.matrix[first + i, first + index] += _SCALE * share
            _row(space, first + i, b, weight, e, _cross(at, e))
            _row(space, first + i, a, -weight, e, _cross(at, e))
    if not tangent:
        return
    _multiply(space, a, b, first + index, e, at, at)
    none = (0.0, 0.0, 0.0)
    if kind == 0:
        radius = assembly.wheels[which, 6]
        for j in range(6):
            d = _unit(j % 3)
            moved = d
            if j >= 3:
                moved = _plus(_cross(d, centre), _times(radius, _lowered(s, down, _cross(d, s))))
            _enter(space, b, 1.0, 6 * b + j, none, _cross(moved, pushed))
    else:
        stiff = space.work
        for i in range(3):
            for j in range(3):
                stiff[i, j] = stiff[3 + i, j] = 0.0
        _couple(space, a, b, back, at, pushed, stiff, True, none)


@part()
def _bodies(space: Any) -> int:
    return len(space.pose) // 4


@part()
def _form(
    assembly: Any, path: Any, settled: Any, space: Any, step: int, tangent: bool, keep: int
) -> None:
    """Write the residual of the current pose to the right-hand side, and the matrix."""
    controls, bodies = len(assembly.controls), _bodies(space)
    first = len(space.right) - controls
    for i in range(len(space.right)):
        space.right[i, 0] = 0.0
        if tangent:
            for j in range(len(space.right)):
                space.matrix[i, j] = 0.0
    for element in range(len(assembly.kinds)):
        kind = assembly.kinds[element, 0]
        if kind == BUSHING:
            _bushing(assembly, settled, space, element, keep, tangent)
        elif kind == LINE:
            _line(assembly, settled, space, element, keep, tangent)
        elif kind == TWIST:
            _twisted(assembly, settled, space, element, keep, tangent)
        else:
            _rigid(assembly, space, element, 6 * bodies, tangent)
    for wheel in range(len(assembly.carriers)):
        _wheel(assembly, space, wheel, tangent)
    for index in range(controls):
        _control(assembly, path, space, index, step, first, tangent)
    for i in range(controls):
        is_value = False
        for j in range(controls):
            is_value = is_value or path.values[step, i * controls + j] != 0.0
        space.right[first + i, 0] += (_SCALE if is_value else 1.0) * space.now[i]


# solution -------------------------------------------------------------------------------------------------------------


@part()
def _factor(space: Any) -> bool:
    """Factor the matrix in the given order, without zeros; return False if it is singular.

    A pivot from the diagonal is taken where it is not small in its column: it keeps the order, and so the zeros.
    """
    matrix, pivots, order, filled = space.factors, space.pivots, space.order, space.filled
    n, largest = len(matrix), 0.0
    for i in range(n):
        for j in range(n):
            matrix[i, j] = space.matrix[order[i], order[j]]
            largest = max(largest, abs(matrix[i, j]))
    for k in range(n):
        best, chosen = abs(matrix[k, k]), k
        for i in range(k + 1, n):
            if abs(matrix[i, k]) > best:
                best, chosen = abs(matrix[i, k]), i
        if abs(matrix[k, k]) >= _TAKEN * best:
            chosen = k
        pivots[k] = chosen
        if not best > _SMALLEST * largest:
            return False
        if chosen != k:
            for j in range(n):
                matrix[k, j], matrix[chosen, j] = matrix[chosen, j], matrix[k, j]
        inverse, count = 1.0 / matrix[k, k], 0
        for j in range(k + 1, n):
            if matrix[k, j] != 0.0:
                filled[count] = j
                count += 1
        for i in range(k + 1, n):
            if matrix[i, k] != 0.0:
                share = matrix[i, k] * inverse
                matrix[i, k] = share
                for at in range(count):
                    matrix[i, filled[at]] -= share * matrix[k, filled[at]]
    return True


@part()
def _solve(space: Any, first: int, last: int) -> None:
    """Solve for right-hand sides ``first`` to ``last`` in place."""
    matrix, pivots, order, right = space.factors, space.pivots, space.order, space.right
    ordered, n = space.ordered, len(space.factors)
    for i in range(n):
        for j in range(first, last):
            ordered[i, j] = right[order[i], j]
    for k in range(n):
        chosen = pivots[k]
        if chosen != k:
            for j in range(first, last):
                ordered[k, j], ordered[chosen, j] = ordered[chosen, j], ordered[k, j]
    for i in range(n):
        for k in range(i):
            if matrix[i, k] != 0.0:
                for j in range(first, last):
                    ordered[i, j] -= matrix[i, k] * ordered[k, j]
    for i in range(n - 1, -1, -1):
        for k in range(i + 1, n):
            if matrix[i, k] != 0.0:
                for j in range(first, last):
                    ordered[i, j] -= matrix[i, k] * ordered[k, j]
        for j in range(first, last):
            ordered[i, j] /= matrix[i, i]
            right[order[i], j] = ordered[i, j]


@part()
def _newton(assembly: Any, path: Any, settled: Any, space: Any, step: int) -> int:
    """Settle the current pose under the loads in ``now``."""
    n = len(space.right)
    fresh, last, before, share = True, np.inf, np.inf, 1.0
    for iteration in range(_ITERATIONS):
        _form(assembly, path, settled, space, step, fresh and iteration == 0, -1)
        residual = 0.0
        for i in range(n):
            residual = max(residual, abs(space.right[i, 0]))
        if residual > before and last > _FRESH and share > _LEAST:
            # At kinks of laws and of dry friction a whole step may lead from one side to the other and back.
            share *= 0.5
            _copy(space, 3, 0)
            _advance(space, share)
            continue
        if fresh and iteration > 0:
            _form(assembly, path, settled, space, step, True, -1)
        if fresh and not _factor(space):
            return SINGULAR
        _solve(space, 0, 1)
        change = 0.0
        for i in range(n):
            space.change[i] = space.right[i, 0]
            if i < 6 * _bodies(space):
                change = max(change, abs(space.right[i, 0]))
        if not change < _LARGEST:
            return NO_EQUILIBRIUM
        _copy(space, 0, 3)
        _advance(space, 1.0)
        if change < (_FRESH if fresh else _KEPT):
            return SETTLED
        fresh = change > _SLOW * last if not fresh else change > 1e-3
        last, before, share = change, residual, 1.0
    return NO_EQUILIBRIUM


@part()
def _advance(space: Any, share: float) -> None:
    """Make a share of the change of the last solution."""
    change, bodies = space.change, _bodies(space)
    for body in range(bodies):
        i = 6 * body
        _move(
            space.pose,
            body,
            _times(share, (change[i], change[i + 1], change[i + 2])),
            _times(share, (change[i + 3], change[i + 4], change[i + 5])),
        )
    for i in range(6 * bodies, len(change)):
        space.multipliers[0, i - 6 * bodies] += share * _SCALE * change[i]


@part()
def _slip(assembly: Any, space: Any) -> None:
    """Let dry friction slip to where it holds at the current pose."""
    pose = space.pose
    for element in range(len(assembly.kinds)):
        kind, row = assembly.kinds[element, 0], assembly.data[element]
        a, b = assembly.kinds[element, 1], assembly.kinds[element, 2]
        if kind == LINE and row[HOLD] > 0.0:
            reach = _minus(_place(pose, b, _triple(row, Q)), _place(pose, a, _triple(row, P)))
            _drag(space, element, 0, math.sqrt(_dot(reach, reach)), row[SLIP] / row[HOLD])
        elif kind == BUSHING:
            point = _triple(row, P)
            gap = _minus(_place(pose, b, point), _place(pose, a, point))
            theta = _rotation_vector(pose, a, b)
            for i in range(3):
                own = _triple(row, A + 3 * i)
                if row[B + i] > 0.0:
                    x = _dot(_turn(pose, a, own), gap)
                    _drag(space, element, i, x, row[S + i] / row[B + i])
                if row[B + 3 + i] > 0.0:
                    x = _hand(row) * _dot(own, theta)
                    _drag(space, element, 3 + i, x, row[S + 3 + i] / row[B + 3 + i])


@part()
def _drag(space: Any, element: int, i: int, x: float, reach: float) -> None:
    held = space.slipped[element, i]
    space.slipped[element, i] = min(max(held, x - reach), x + reach)


@part()
def _copy(space: Any, source: int, target: int) -> None:
    """Copy pose and multipliers: 0 the current, 1 the last settled, 2 the one before, 3 before a step of Newton's."""
    bodies = _bodies(space)
    for body in range(bodies):
        for i in range(12):
            space.pose[target * bodies + body, i] = space.pose[source * bodies + body, i]
    for i in range(space.multipliers.shape[1]):
        space.multipliers[target, i] = space.multipliers[source, i]


@part()
def _way(space: Any) -> float:
    """Return the largest change of a body's place (m) or direction from the last settled pose."""
    bodies, way = _bodies(space), 0.0
    for body in range(bodies):
        for i in range(12):
            way = max(way, abs(space.pose[body, i] - space.pose[bodies + body, i]))
    return way


@part()
def _near(assembly: Any, path: Any, settled: Any, space: Any, step: int) -> int:
    """Settle the current pose, and refuse one that is far from the last: it may belong to another branch."""
    outcome = _newton(assembly, path, settled, space, step)
    return (
        NO_EQUILIBRIUM if outcome == SETTLED and step > 0 and _way(space) > _FARTHEST else outcome
    )


@part()
def _predict(space: Any, ratio: float) -> None:
    """Extrapolate from the two poses before, by a ratio of step sizes."""
    bodies = _bodies(space)
    for body in range(bodies):
        for i in range(12):
            last, before = space.pose[bodies + body, i], space.pose[2 * bodies + body, i]
            space.pose[body, i] = last + ratio * (last - before)
        _orthogonal(space.pose, body)
    for i in range(space.multipliers.shape[1]):
        last, before = space.multipliers[1, i], space.multipliers[2, i]
        space.multipliers[0, i] = last + ratio * (last - before)


@part()
def _now(path: Any, space: Any, step: int, share: float) -> None:
    """Write targets and loads at a share of the way from the step before."""
    controls = path.targets.shape[1]
    for i in range(len(space.now)):
        if i < controls:
            end = path.targets[step, i]
            start = path.targets[step - 1, i] if step > 0 else end
        else:
            end = path.loads[step, i - controls]
            start = path.loads[step - 1, i - controls] if step > 0 else end
        space.now[i] = start + share * (end - start)


@part()
def follow(assembly: Assembly, path: Path, seeds: Seeds, settled: Settled, space: Space) -> None:
    """Settle all steps, or those up to the first that cannot be settled."""
    bodies, steps = _bodies(space), len(path.targets)
    gone = 0.0  # size of the step before, as a share of a whole one
    for step in range(steps):
        done, share, outcome = 0.0, 1.0, SETTLED
        while done < 1.0:
            _now(path, space, step, done + share)
            _predict(space, share / gone if gone > 0.0 else 0.0)
            outcome = _near(assembly, path, settled, space, step)
            if outcome != SETTLED and gone > 0.0:
                _copy(space, 1, 0)
                outcome = _near(assembly, path, settled, space, step)
            if outcome != SETTLED:
                _copy(space, 1, 0)
                share *= 0.5
                if step == 0 or share < _SHORTEST:
                    settled.outcome[step] = outcome
                    _form(assembly, path, settled, space, step, True, -1)
                    return
                continue
            _slip(assembly, space)
            _copy(space, 1, 2)
            _copy(space, 0, 1)
            done, gone = done + share, share if step > 0 else 0.0
            share = min(2.0 * share, 1.0 - done)
        tangent = settled.slopes.shape[2] > 0
        _form(assembly, path, settled, space, step, tangent, step)
        settled.outcome[step] = SETTLED
        for body in range(bodies):
            for i in range(12):
                settled.poses[step, 12 * body + i] = space.pose[body, i]
        for i in range(space.multipliers.shape[1]):
            settled.multipliers[step, i] = space.multipliers[0, i]
        if tangent:
            _slopes(assembly, path, seeds, settled, space, step)


# slopes by parameters -------------------------------------------------------------------------------------------------


@part()
def _slopes(assembly: Any, path: Any, seeds: Any, settled: Any, space: Any, step: int) -> None:
    bodies, n = _bodies(space), len(space.right)
    for i in range(n):
        for j in range(1, space.right.shape[1]):
            space.right[i, j] = 0.0
    if not _factor(space):
        return
    for seed in range(len(seeds.places)):
        place, column = seeds.places[seed, 0], 1 + seeds.places[seed, 1]
        change = seeds.changes[seed]
        if place < 0:
            _vary_wheel(assembly, path, space, -1 - place, column, change, step)
            continue
        kind = assembly.kinds[place, 0]
        if kind == BUSHING:
            _vary_bushing(assembly, space, place, column, change)
        elif kind == TWIST:
            _vary_twist(assembly, space, place, column, change)
        else:
            _vary_rigid(assembly, space, place, 6 * bodies, column, change)
    _solve(space, 1, space.right.shape[1])
    for i in range(n):
        scale = 1.0 if i < 6 * bodies else _SCALE
        for j in range(1, space.right.shape[1]):
            settled.slopes[step, i, j - 1] = scale * space.right[i, j]


@part()
def _vary_bushing(assembly: Any, space: Any, element: int, column: int, change: Any) -> None:
    pose, row = space.pose, assembly.data[element]
    a, b = assembly.kinds[element, 1], assembly.kinds[element, 2]
    point = _triple(row, P)
    xa, xb = _place(pose, a, point), _place(pose, b, point)
    moved = _turn(pose, b, _triple(change, P))
    gap, apart = _minus(xb, xa), _minus(moved, _turn(pose, a, _triple(change, P)))
    theta = _rotation_vector(pose, a, b)
    force, pushed, twisted = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    hand = _hand(row)
    for i in range(3):
        own, tilted = _triple(row, A + 3 * i), _triple(change, A + 3 * i)
        axis, bent = _turn(pose, a, own), _turn(pose, a, tilted)
        own, tilted = _times(hand, own), _times(hand, tilted)
        x, angle = _dot(axis, gap), _dot(own, theta)
        f, slope, bare = _elastic(assembly, element, i, x, space.slipped[element, i])
        t, bend, wound = _elastic(assembly, element, 3 + i, angle, space.slipped[element, 3 + i])
        df = slope * (_dot(axis, apart) + _dot(bent, gap)) + change[F + i]
        dt = bend * _dot(tilted, theta) + change[F + 3 + i]
        df -= change[C + i] * bare if assembly.kinds[element, 4 + i] >= 0 else change[K + i] * x
        dt -= (
            change[C + 3 + i] * wound
            if assembly.kinds[element, 7 + i] >= 0
            else change[K + 3 + i] * angle
        )
        force = _plus(force, _times(f, axis))
        pushed = _plus(pushed, _plus(_times(df, axis), _times(f, bent)))
        twisted = _plus(twisted, _plus(_times(dt, own), _times(t, tilted)))
    moment = _plus(_cross(moved, force), _cross(xb, pushed))
    moment = _plus(moment, _turn(pose, a, _twist(theta, twisted)))
    _add(space, column, b, 1.0, pushed, moment)
    _add(space, column, a, -1.0, pushed, moment)


@part()
def _vary_twist(assembly: Any, space: Any, element: int, column: int, change: Any) -> None:
    pose, row = space.pose, assembly.data[element]
    a, b = assembly.kinds[element, 1], assembly.kinds[element, 2]
    angle = _wound(pose, row, a, b) - row[LENGTH]
    tau = row[PRELOAD] - row[RATE] * angle
    dtau = change[PRELOAD] - change[RATE] * angle + row[RATE] * change[LENGTH]
    axis, tilted = _turn(pose, a, _triple(row, P)), _turn(pose, a, _triple(change, P))
    torque = _plus(_times(dtau, axis), _times(tau, tilted))
    _add(space, column, b, 1.0, (0.0, 0.0, 0.0), torque)
    _add(space, column, a, -1.0, (0.0, 0.0, 0.0), torque)


@part()
def _vary_rigid(
    assembly: Any, space: Any, element: int, first: int, column: int, change: Any
) -> None:
    """Vary a line or a constraint; of a DOT that is a control, its force only."""
    pose, row = space.pose, assembly.data[element]
    kind, a, b = (
        assembly.kinds[element, 0],
        assembly.kinds[element, 1],
        assembly.kinds[element, 2],
    )
    at = assembly.kinds[element, 3]
    if kind == DOT and at < 0:
        return
    n, none, right = first + at, (0.0, 0.0, 0.0), space.right
    if kind == ALIGN:
        force = space.multipliers[0, at]
        e, f = _turn(pose, a, _triple(row, A)), _turn(pose, b, _triple(row, P))
        de, df = _turn(pose, a, _triple(change, A)), _turn(pose, b, _triple(change, P))
        torque = _times(force, _plus(_cross(df, e), _cross(f, de)))
        _add(space, column, b, 1.0, none, torque)
        _add(space, column, a, -1.0, none, torque)
        right[n, column] -= _SCALE * (_dot(de, f) + _dot(e, df) - change[LENGTH])
        return
    xa, xb = _place(pose, a, _triple(row, P)), _place(pose, b, _triple(row, Q))
    da, db = _turn(pose, a, _triple(change, P)), _turn(pose, b, _triple(change, Q))
    reach, apart = _minus(xb, xa), _minus(db, da)
    if kind == POINT:
        pushed = _triple(space.multipliers[0], at)
        _add(space, column, b, 1.0, none, _cross(db, pushed))
        _add(space, column, a, -1.0, none, _cross(da, pushed))
        for i in range(3):
            right[n + i, column] -= _SCALE * apart[i]
        return
    if kind == DOT:
        force = space.multipliers[0, at]
        e, de = _turn(pose, a, _triple(row, ALONG)), _turn(pose, a, _triple(change, ALONG))
        pushed, bent = _times(force, e), _times(force, de)
        right[n, column] -= _SCALE * (_dot(de, reach) + _dot(e, apart) - change[LENGTH])
    else:
        length = math.sqrt(_dot(reach, reach))
        e = _times(1.0 / length, reach)
        longer = _dot(e, apart)
        tilted = _times(1.0 / length, _minus(apart, _times(longer, e)))
        if kind == LINE:
            force, slope, bare = _push(assembly, element, length, space.slipped[element, 0])
            df = slope * (longer - change[LENGTH]) + change[PRELOAD]
            df += row[SIGN] * change[FACTOR] * bare
            if assembly.kinds[element, 4] < 0:
                df += change[RATE] * (row[LENGTH] - length)
        else:
            force, df = space.multipliers[0, at], 0.0
            right[n, column] -= _SCALE * (longer - change[LENGTH])
        pushed, bent = _times(force, e), _plus(_times(df, e), _times(force, tilted))
    moment = _plus(_cross(db, pushed), _cross(xb, bent))
    _add(space, column, b, 1.0, bent, moment)
    _add(space, column, a, -1.0, bent, moment)


@part()
def _vary_wheel(
    assembly: Any, path: Any, space: Any, wheel: int, column: int, change: Any, step: int
) -> None:
    """Vary a wheel's centre, axis and radius."""
    pose, body, none = space.pose, assembly.carriers[wheel], (0.0, 0.0, 0.0)
    _, _, s, down = _contact(pose, assembly, wheel)
    centre, axis = _turn(pose, body, _triple(change, 0)), _turn(pose, body, _triple(change, 3))
    lowered = _times(assembly.wheels[wheel, 6], _lowered(s, down, axis))
    contact = _plus(centre, _plus(lowered, _times(change[6], down)))
    level, _, through, trail = _load(assembly, space, wheel)
    at = _minus(contact, _times(trail, _swung(s, axis)))
    moment = _plus(_cross(at, level), _cross(centre, through))
    _add(space, column, body, 1.0, none, moment)
    controls = len(assembly.controls)
    first = len(space.right) - controls
    for index in range(controls):
        if assembly.controls[index, 0] == 0 and assembly.controls[index, 1] == wheel:
            force = space.multipliers[0, first - 6 * _bodies(space) + index]
            _add(space, column, body, 1.0, none, _cross(contact, (0.0, 0.0, force)))
            for i in range(controls):
                weight = path.values[step, i * controls + index]
                space.right[first + i, column] -= _SCALE * weight * contact[2]
