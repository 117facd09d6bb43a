"""Standard errors of fitted parameters that also hold for correlated residuals."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def robust_covariance(vector: Array, jacobian: Array, blocks: tuple[slice, ...]) -> Array:
    """Covariance of least-squares estimates, consistent under autocorrelated and unequal noise.

    Sandwich ``(J'J)^-1 S (J'J)^-1`` with the long-run variance ``S`` of the scores by Bartlett weights over the square
    root of each block's length (Newey and West 1987 [newey1987]), scaled by n / (n - k).

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
        scores = jacobian[block] * vector[block, None]
        meat += scores.T @ scores
        reach = int(np.sqrt(len(scores)))
        for lag in range(1, reach + 1):
            cross = scores[lag:].T @ scores[:-lag]
            meat += (1.0 - lag / (reach + 1.0)) * (cross + cross.T)
    return np.asarray(bread @ meat @ bread * (count / max(count - unknowns, 1)))
