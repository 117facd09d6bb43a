"""Standard errors of fitted parameters that also hold for correlated and uneven residuals."""

from __future__ import annotations

import numpy as np

from jounce.core.types import Array

_SHARE = 20  # the level of the residuals is taken over this share of a record
_LEAST = 1e-12  # of the largest level: what is smaller is rounding, where nothing moves
_FEWEST = 25  # samples, at least
_REACH = 3  # times the lag at which the residuals stop resembling each other


def robust_covariance(vector: Array, jacobian: Array, blocks: tuple[slice, ...]) -> Array:
    """Covariance of least-squares estimates under autocorrelated noise of changing level.

    Sandwich ``(J'J)^-1 (J' G J) (J'J)^-1``: ``G`` is the covariance of the residuals, from their level (moving r.m.s.)
    and their autocorrelation as far as it is significant, tapered by Bartlett weights [newey1987]. For white
    residuals of constant level this is the classical covariance. The autocorrelation is that of the residuals, not of
    the scores ``J r``: those sum to zero at the optimum, which makes intervals from them too short.

    Parameters
    ----------
    vector : ndarray, shape (n,)
        Residuals at the optimum.
    jacobian : ndarray, shape (n, k)
        Their derivatives.
    blocks : tuple of slice
        Rows of each channel of each trial; residuals of different blocks are taken as independent.

    Returns
    -------
    ndarray, shape (k, k)
        Covariance of the unknowns.
    """
    count, unknowns = jacobian.shape
    bread = np.linalg.pinv(jacobian.T @ jacobian, hermitian=True)
    meat = np.zeros((unknowns, unknowns))
    for block in blocks:
        level = _level(vector[block])
        rows = jacobian[block] * level[:, None]
        meat += rows.T @ rows
        least = max(_LEAST * float(np.max(level, initial=0.0)), np.finfo(float).tiny)
        correlation = _correlation(vector[block] / np.maximum(level, least))
        for lag, weighted in enumerate(correlation, 1):
            cross = rows[lag:].T @ rows[:-lag]
            meat += weighted * (cross + cross.T)
    return np.asarray(bread @ meat @ bread * (count / max(count - unknowns, 1)))


def _level(residuals: Array) -> Array:
    """Root mean square of the residuals around each sample."""
    width = min(max(_FEWEST, len(residuals) // _SHARE), len(residuals))
    summed = np.concatenate([[0.0], np.cumsum(residuals**2)])
    first = np.clip(np.arange(len(residuals)) - width // 2, 0, len(residuals) - width)
    return np.asarray(np.sqrt(np.maximum(summed[first + width] - summed[first], 0.0) / width))


def _correlation(residuals: Array) -> Array:
    """Tapered autocorrelation from lag 1 on; empty where the residuals are white."""
    count = len(residuals)
    energy = float(residuals @ residuals)
    longest = count // 4
    values = (
        np.array([residuals[lag:] @ residuals[:-lag] / energy for lag in range(1, longest)])
        if energy > 0.0
        else np.zeros(0)
    )
    quiet = np.flatnonzero(np.abs(values) < 2.0 / np.sqrt(count))
    end = int(quiet[0]) if len(quiet) else len(values)
    reach = min(_REACH * end, len(values))
    return np.asarray(values[:reach] * (1.0 - np.arange(1, reach + 1) / (reach + 1.0)))
