"""Linear algebra inside the expression graph: no branches, no pivoting."""

from __future__ import annotations

import casadi as ca


class Ldl:
    """Unrolled factorisation ``matrix = L D L^T`` of a symmetric positive definite matrix.

    Rows are eliminated from last to first; the mass matrix of a tree with its root first is factorised without fill-in.
    """

    def __init__(self, matrix: ca.SX) -> None:
        self.size = matrix.shape[0]
        flipped = matrix[::-1, ::-1] if self.size else matrix
        self._lower = ca.SX(self.size, self.size)
        self.pivots: list[ca.SX] = []
        for j in range(self.size):
            self.pivots.append(flipped[j, j] - self._inner(j, j))
            for i in range(j + 1, self.size):
                entry = flipped[i, j] - self._inner(i, j)
                if entry.nnz():
                    self._lower[i, j] = entry / self.pivots[j]

    def _inner(self, i: int, j: int) -> ca.SX:
        shared = (
            k
            for k in range(j)
            if self._lower.sparsity().has_nz(i, k) and self._lower.sparsity().has_nz(j, k)
        )
        return sum(
            (self._lower[i, k] * self._lower[j, k] * self.pivots[k] for k in shared), ca.SX(1, 1)
        )

    def forward(self, rhs: ca.SX) -> ca.SX:
        """Return ``L^-1 rhs`` (in the factor's own order of rows)."""
        x = ca.SX(rhs[::-1, :]) if self.size else ca.SX(rhs)
        for i in range(self.size):
            for k in range(i):
                if self._lower.sparsity().has_nz(i, k):
                    x[i, :] -= self._lower[i, k] * x[k, :]
        return x

    def scale(self, rows: ca.SX) -> ca.SX:
        """Return ``D^-1 rows``."""
        return (
            ca.vertcat(*(rows[i, :] / self.pivots[i] for i in range(self.size)))
            if self.size
            else rows
        )

    def backward(self, rows: ca.SX) -> ca.SX:
        """Return ``L^-T rows`` in the order of the matrix."""
        x = ca.SX(rows)
        for i in reversed(range(self.size)):
            for k in range(i + 1, self.size):
                if self._lower.sparsity().has_nz(k, i):
                    x[i, :] -= self._lower[k, i] * x[k, :]
        return x[::-1, :] if self.size else x

    def solve(self, rhs: ca.SX) -> ca.SX:
        """Return ``matrix^-1 rhs``."""
        return self.backward(self.scale(self.forward(rhs)))
