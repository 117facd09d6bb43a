"""Runs that have left what a suspension is: by angles and deflections that none reaches."""

from __future__ import annotations

import numpy as np

from jounce.core.types import Array

_TURNED = 0.6  # rad: camber or steer that moves so far in a run belongs to another way of assembling the linkage
_STEERED = 1.0  # rad: steer at rest that no rack makes
_APART = 10.0  # m: no strut is that long
_TURNS = ("body.pitch", "body.roll")  # rad: a car that has turned that far lies on its roof
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


def ran_away_at(names: tuple[str, ...], outputs: Array) -> int | None:
    """Give the first sample at which a strut deflects by more than 10 m or the body turns by more than 1 rad, or None.

    Arguments as above.
    """
    limits = [_APART if name.endswith("strut.deflection") else 1.0 if name in _TURNS else np.inf for name in names]
    beyond = np.any(np.abs(outputs) > np.array(limits)[:, np.newaxis], axis=0)
    return int(np.argmax(beyond)) if beyond.any() else None
