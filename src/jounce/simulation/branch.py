"""A wheel that has gone over a dead point of its suspension: found by the angles that no suspension reaches."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
_TURNED = 0.6  # rad: camber or steer that moves so far in a run belongs to another way of assembling the linkage
_STEERED = 1.0  # rad: steer at rest that no rack makes
_ANGLES = ("wheel.camber", "wheel.steer")


def flipped_at(names: tuple[str, ...], outputs: Array) -> int | None:
    """Give the first sample at which the wheel has flipped over, None where it never does.

    Parameters
    ----------
    names : tuple of str
        Channels in the order of the rows.
    outputs : ndarray, shape (n_outputs, n)
        Samples, SI; the first one is the rest that the run starts from.
    """
    first: int | None = None
    for row, name in enumerate(names):
        if not name.endswith(_ANGLES):
            continue
        angle = outputs[row]
        turned = np.abs(np.angle(np.exp(1j * (angle - angle[0])))) > _TURNED
        if abs(angle[0]) > _STEERED:
            turned[0] = True
        if turned.any():
            here = int(np.argmax(turned))
            first = here if first is None else min(first, here)
    return first
