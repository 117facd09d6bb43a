"""Which parameters the data can tell apart, before a fit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from jounce.core.findings import Finding
from jounce.core.types import Array

_WEAK, _ALIKE = 1e-6, 0.98


@dataclass(frozen=True)
class Identifiability:
    """Sensitivity of the data to each unknown, at the start values.

    Attributes
    ----------
    parameters : tuple of str
        Unknowns, in the order of the arrays.
    sensitivity : tuple of float
        Root mean square change of the weighted residuals for one scaled unit of each unknown.
    singular_values : tuple of float
        Of the scaled sensitivity matrix, descending.
    rank : int
        Number of directions the data can tell apart.
    condition : float
        Largest over smallest singular value.
    correlation : tuple of tuple of float
        Correlation of the estimates that the data allow.
    findings : tuple of Finding
        Parameters without influence and pairs that act alike.
    """

    parameters: tuple[str, ...]
    sensitivity: tuple[float, ...]
    singular_values: tuple[float, ...]
    rank: int
    condition: float
    correlation: tuple[tuple[float, ...], ...]
    findings: tuple[Finding, ...]


def identifiability(jacobian: Array, names: tuple[str, ...]) -> Identifiability:
    """Judge a sensitivity matrix.

    Parameters
    ----------
    jacobian : ndarray, shape (n_samples, n_unknowns)
        Derivatives of the residuals with respect to the scaled unknowns.
    names : tuple of str
        Unknowns.
    """
    norms = np.linalg.norm(jacobian, axis=0)
    singular = np.linalg.svd(jacobian, compute_uv=False)
    rank = int(np.sum(singular > _WEAK * singular[0])) if singular[0] > 0.0 else 0
    correlation = correlation_of(np.asarray(np.linalg.pinv(jacobian.T @ jacobian, hermitian=True), dtype=float))
    findings = [
        Finding(name, "warning", "the data do not react to this parameter; fix it or measure something else", 0.0)
        for name, norm in zip(names, norms, strict=True)
        if norm <= _WEAK * norms.max()
    ]
    for i in range(len(names)):
        for j in range(i):
            if abs(correlation[i, j]) > _ALIKE:
                text = f"cannot be told apart from {names[j]} with these data (correlation {correlation[i, j]:+.3f})"
                findings.append(Finding(names[i], "warning", text, float(correlation[i, j])))
    condition = float(singular[0] / singular[-1]) if singular[-1] > 0.0 else float("inf")
    return Identifiability(
        names,
        tuple(float(norm) / np.sqrt(len(jacobian)) for norm in norms),
        tuple(float(value) for value in singular),
        rank,
        condition,
        tuple(tuple(float(value) for value in row) for row in correlation),
        tuple(findings),
    )


def correlation_of(covariance: Array) -> Array:
    """Correlation matrix of a covariance; rows without variance become zero."""
    deviation = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        correlation = covariance / np.outer(deviation, deviation)
    return np.asarray(np.nan_to_num(correlation, nan=0.0, posinf=0.0, neginf=0.0), dtype=float)
