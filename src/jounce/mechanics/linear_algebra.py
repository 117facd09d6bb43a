"""Linear algebra inside the expression graph: no branches, no pivoting."""

from __future__ import annotations

import casadi as ca


def ldl_solve(matrix: ca.SX, rhs: ca.SX) -> ca.SX:
    """Solve ``matrix @ x = rhs`` for a symmetric positive definite matrix by an unrolled L D L^T factorisation.

    Structural zeros stay zeros, so a diagonal mass matrix costs one division a row.
    """
    size = matrix.shape[0]
    lower = ca.SX.eye(size)
    diagonal: list[ca.SX] = []
    for j in range(size):
        diagonal.append(matrix[j, j] - sum((lower[j, k] ** 2 * diagonal[k] for k in range(j)), ca.SX(0)))
        for i in range(j + 1, size):
            inner = sum((lower[i, k] * lower[j, k] * diagonal[k] for k in range(j)), ca.SX(0))
            lower[i, j] = (matrix[i, j] - inner) / diagonal[j]
    x = ca.SX(rhs)
    for i in range(size):
        for k in range(i):
            x[i, :] -= lower[i, k] * x[k, :]
    for i in range(size):
        x[i, :] = x[i, :] / diagonal[i]
    for i in reversed(range(size)):
        for k in range(i + 1, size):
            x[i, :] -= lower[k, i] * x[k, :]
    return x
