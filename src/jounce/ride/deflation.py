"""Linear models without the motions that a road never reaches: free turning, the memory of hysteresis.

What neither comes to rest nor is ever moved would leave a model without a covariance. All that the road reaches lies in
the invariant subspace of what does come to rest; ``x = U1 y`` describes it with fewer states. Along a number this
subspace turns by ``U2 K`` with ``T22 K - K T11 = -U2' A' U1`` (A' the slope of A, T the Schur form).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from jounce.core.types import Array
from jounce.ride.family import Matrices

_NEUTRAL = 1e-6  # of the largest eigenvalue: rounding of a double eigenvalue at zero
_UNREACHED = 1e-7


def without_unreached(model: Matrices, slopes: Sequence[Matrices]) -> tuple[Matrices, list[Matrices]]:
    """Give a model and its slopes without neutral motions that the road does not reach; as they are where it does.

    Parameters
    ----------
    model : Matrices
        Linear model, SI.
    slopes : sequence of Matrices
        Its slopes along some numbers.
    """
    values = np.linalg.eigvals(model.A)
    bound = -_NEUTRAL * float(np.max(np.abs(values), initial=0.0))
    if not len(values) or float(np.max(values.real)) < bound:
        return model, list(slopes)
    from scipy.linalg import schur

    form, basis, count = schur(model.A, output="real", sort=lambda real, _: real < bound)
    if count == len(form):
        return model, list(slopes)
    kept, left = basis[:, :count], basis[:, count:]
    for b in model.B:
        if np.max(np.abs(left.T @ b), initial=0.0) > _UNREACHED * max(float(np.max(np.abs(b), initial=0.0)), 1.0):
            return model, list(slopes)
    found = _reduced(model, kept)
    return found, [_moved(model, part, form, kept, left) for part in slopes]


def _reduced(model: Matrices, kept: Array) -> Matrices:
    b = np.stack([kept.T @ part for part in model.B])
    return Matrices(kept.T @ model.A @ kept, b, model.C @ kept, model.D, model.rest)


def _moved(model: Matrices, along: Matrices, form: Array, kept: Array, left: Array) -> Matrices:
    """Slope of the reduced model, the subspace turning with the number."""
    from scipy.linalg import solve_sylvester

    count = kept.shape[1]
    turn = solve_sylvester(form[count:, count:], -form[:count, :count], -left.T @ along.A @ kept)
    found = _reduced(along, kept)
    a, c = found.A + kept.T @ model.A @ left @ turn, found.C + model.C @ left @ turn
    return Matrices(a, found.B, c, found.D, found.rest)
