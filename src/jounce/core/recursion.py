"""First-order recursions over long signals without a loop over their samples."""

from __future__ import annotations

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Number = TypeVar("Number", np.float64, np.complex128)
_BLOCK = 64


def first_order(drive: NDArray[Number], factor: complex, rest: complex = 0.0) -> NDArray[Number]:
    """Compute the states ``w[i+1] = factor w[i] + drive[i]`` after each step, from ``w[0] = rest``; any unit.

    Blocks of samples are solved by one matrix product, and the last state of each is carried into the next.
    """
    blocks = -(-drive.size // _BLOCK)
    padded = np.zeros(blocks * _BLOCK, dtype=drive.dtype)
    padded[: drive.size] = drive
    powers = (factor ** np.arange(_BLOCK + 1)).astype(drive.dtype)
    gaps = np.subtract.outer(np.arange(_BLOCK), np.arange(_BLOCK))
    own = padded.reshape(blocks, _BLOCK) @ np.where(gaps >= 0, powers[abs(gaps)], 0.0).T
    carried = np.empty(blocks, dtype=drive.dtype)
    state, across = rest, powers[_BLOCK].item()
    for block, end in enumerate(own[:, -1].tolist()):
        carried[block] = state
        state = across * state + end
    own += np.outer(carried, powers[1:])
    return own.ravel()[: drive.size]
