"""Quarter car in the frequency bins of a record (see ``inspection.quarter_car``)."""

from __future__ import annotations

import math

from jounce.kernel.arrays import ComplexVector, Matrix, Vector
from jounce.kernel.loops.compiling import FAST, dot, part

_FREE = 6


@part(fastmath=FAST)
def _over(value):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
    return value.conjugate() / (value.real * value.real + value.imag * value.imag)


@part(fastmath=FAST)
def _take_off(row, basis):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
    """Make a row orthogonal to the rows of a basis, in place."""
    for k in range(basis.shape[0]):
        share = dot(basis[k], row)
        for i in range(row.size):
            row[i] -= share * basis[k, i]


@part(fastmath=FAST)
def _bins(parameters, speed, height, force, basis, gap, slopes, falls):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
    """Fill in transients, residuals of the response, their slopes, and relative slopes of the denominator, per bin."""
    unsprung, rate, damping, stiffness, loss, sprung = parameters
    n = speed.size
    for i in range(n):
        s, square = complex(0.0, speed[i]), -speed[i] * speed[i]
        strut, tyre = complex(rate, damping * speed[i]), complex(stiffness, loss * speed[i])
        hung, wheel = sprung * square + strut, unsprung * square + strut + tyre
        over = _over(hung * wheel - strut * strut)
        body, moved = strut * _over(hung), tyre * hung * over
        missed = force[i] - (tyre - tyre * moved) * height[i]
        gap[i], gap[n + i] = missed.real, missed.imag
        through, left, contact = moved * moved, (1.0 - body), (1.0 - moved)
        by_strut, by_tyre = through * left * left, contact * contact
        both = hung + wheel - 2.0 * strut
        column, relative = over, complex(0.0, speed[i] / speed[n - 1])
        for k in range(basis.shape[0]):
            basis[k, i], basis[k, n + i] = column.real, column.imag
            column *= relative
        of_bin = (
            through * square,
            by_strut,
            by_strut * s,
            by_tyre,
            by_tyre * s,
            through * square * body * body,
        )
        of_poles = (square * hung, both, both * s, hung, hung * s, square * wheel)
        for k in range(_FREE):
            slope, fall = of_bin[k] * height[i], of_poles[k] * over
            slopes[k, i], slopes[k, n + i] = slope.real, slope.imag
            falls[k, i], falls[k, n + i] = fall.real, fall.imag


@part(fastmath=FAST)
def _make_orthonormal(basis):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN202
    """Orthonormalise by two passes of Gram-Schmidt, which are sufficient."""
    for k in range(basis.shape[0]):
        for _ in range(2):
            size = math.sqrt(dot(basis[k], basis[k]))
            for i in range(basis.shape[1]):
                basis[k, i] /= size
            _take_off(basis[k], basis[:k])
        size = math.sqrt(dot(basis[k], basis[k]))
        for i in range(basis.shape[1]):
            basis[k, i] /= size


@part(fastmath=FAST)
def equations(
    parameters: Vector,
    speed: Vector,
    height: ComplexVector,
    force: ComplexVector,
    basis: Matrix,
    transient: Vector,
    slopes: Matrix,
    falls: Matrix,
    gap: Vector,
    normal: Matrix,
    right: Vector,
) -> None:
    """Compute the residual force and the normal equations; the first four arrays after the bins are scratch space."""
    n = speed.size
    _bins(parameters, speed, height, force, basis, gap, slopes, falls)
    _make_orthonormal(basis)
    for k in range(basis.shape[0]):
        share = dot(basis[k], gap)
        for i in range(2 * n):
            transient[i] += share * basis[k, i]
    for i in range(2 * n):
        gap[i] -= transient[i]
    for k in range(_FREE):
        for i in range(n):
            slopes[k, i] -= transient[i] * falls[k, i] - transient[n + i] * falls[k, n + i]
            slopes[k, n + i] -= transient[i] * falls[k, n + i] + transient[n + i] * falls[k, i]
        _take_off(slopes[k], basis)
        right[k] = dot(slopes[k], gap)
        for j in range(k + 1):
            normal[k, j] = normal[j, k] = dot(slopes[k], slopes[j])
