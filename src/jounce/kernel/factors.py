"""Factors of the matrix of an implicit step, in place, for a few dozen states.

The rates of the coordinates, ``dq/dt = N(q) v``, depend on few states each: their rows are nearly empty, and the block
that couples coordinates among themselves is ``1 / (gamma h)`` with at most an antisymmetric part (of quaternions)
beside it. So the coordinates are eliminated first and without pivoting, skipping zeros; the rest is factorised with
partial pivoting. All loops run down columns, which lie in one piece.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.kernel.call import part

Array = NDArray[np.float64]


class Factors(NamedTuple):
    """Row ``j`` of ``columns`` is column ``j``: of the lower factor (diagonal 1) beyond ``j``, else of the upper one.

    ``inverse`` is that of the diagonal of the upper factor; ``swap`` says which rows changed places.
    """

    columns: Array
    inverse: Array
    swap: NDArray[np.int64]


def room(n: int) -> Factors:
    """Arrays for ``n`` states."""
    return Factors(np.zeros((n, n)), np.zeros(n), np.zeros(n, dtype=np.int64))


@part(fastmath={"contract"})
def factorise(factors: Any, slope: Any, shift: float, first: int) -> bool:
    """Factorise ``shift * 1 - slope``, where ``slope`` is one row, column after column; tell whether it is regular.

    The ``first`` states are eliminated without pivoting.
    """
    columns, inverse, swap = factors.columns, factors.inverse, factors.swap
    n = len(inverse)
    for j in range(n):
        for i in range(n):
            columns[j, i] = -slope[0, j * n + i]
        columns[j, j] += shift
    for k in range(n):
        swap[k] = k if k < first else _largest(columns[k], k)
        if swap[k] != k:
            for j in range(n):
                columns[j, k], columns[j, swap[k]] = columns[j, swap[k]], columns[j, k]
        pivot = columns[k, k]
        if pivot == 0.0 or not np.isfinite(pivot):
            return False
        inverse[k] = 1.0 / pivot
        for i in range(k + 1, n):
            columns[k, i] *= inverse[k]
        for j in range(k + 1, n):
            share = columns[j, k]
            if share != 0.0:
                for i in range(k + 1, n):
                    columns[j, i] -= share * columns[k, i]
    return True


@part()
def _largest(column: Any, k: int) -> int:
    """Place of the largest element of a column, from ``k`` on."""
    found = k
    for i in range(k + 1, len(column)):
        if abs(column[i]) > abs(column[found]):
            found = i
    return found


@part(fastmath={"contract"})
def solve(factors: Any, x: Any) -> None:
    """Put the solution for the right-hand side ``x`` in its place."""
    columns, inverse, swap = factors.columns, factors.inverse, factors.swap
    n = len(inverse)
    for k in range(n):
        if swap[k] != k:
            x[k], x[swap[k]] = x[swap[k]], x[k]
    for k in range(n):
        value = x[k]
        for i in range(k + 1, n):
            x[i] -= columns[k, i] * value
    for k in range(n - 1, -1, -1):
        x[k] *= inverse[k]
        value = x[k]
        for i in range(k):
            x[i] -= columns[k, i] * value
