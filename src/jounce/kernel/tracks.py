"""Input signals for the compiled loops: every track a chain of closed-form pieces, flattened into arrays."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from jounce.core.segments import Segments
from jounce.kernel.call import sine_and_cosine

Array = NDArray[np.float64]


class Tracks(NamedTuple):
    """Pieces of all tracks, one after another; piece ``i`` of the flat arrays is valid on ``[start, stop]``."""

    first: NDArray[np.int64]
    start: Array
    stop: Array
    kind: NDArray[np.int64]
    coefficients: Array
    rate: Array


def flatten(signals: list[Segments]) -> Tracks:
    """Put the signals (against time) into the arrays that the loops read."""
    counts = [len(signal.kind) for signal in signals]
    return Tracks(
        first=np.concatenate([[0], np.cumsum(counts)]).astype(np.int64),
        start=np.concatenate([signal.edges[:-1] for signal in signals]),
        stop=np.concatenate([signal.edges[1:] for signal in signals]),
        kind=np.concatenate([signal.kind for signal in signals]).astype(np.int64),
        coefficients=np.ascontiguousarray(np.concatenate([signal.coefficients for signal in signals])),
        rate=np.array([signal.rate for signal in signals]),
    )


@njit(cache=True, error_model="numpy")  # type: ignore[untyped-decorator]
def advance(tracks: Any, piece: Any, t: float, slack: float) -> float:  # noqa: ANN401
    """Move ``piece`` to the pieces that hold just after ``t``; give the next edge of any track."""
    edge = np.inf
    for k in range(len(piece)):
        last = tracks.first[k + 1] - 1
        while piece[k] < last and tracks.stop[piece[k]] <= t + slack:
            piece[k] += 1
        if piece[k] < last:
            edge = min(edge, tracks.stop[piece[k]])
    return edge


@njit(cache=True, error_model="numpy", inline="always")  # type: ignore[untyped-decorator]
def evaluate(tracks: Any, piece: Any, t: float, u: Any, column: int) -> None:  # noqa: ANN401
    """Fill one column of ``u`` with (value, time derivative) of every track at ``t``, on the pieces given."""
    for k in range(len(piece)):
        i = piece[k]
        rate = tracks.rate[k]
        s = rate * (t - tracks.start[i])
        c0, c1 = tracks.coefficients[i, 0], tracks.coefficients[i, 1]
        c2, c3 = tracks.coefficients[i, 2], tracks.coefficients[i, 3]
        if tracks.kind[i] == 0:
            u[2 * k, column] = c0 + s * (c1 + s * (c2 + s * c3))
            u[2 * k + 1, column] = rate * (c1 + s * (2.0 * c2 + 3.0 * s * c3))
        elif tracks.kind[i] == 1:
            sine, cosine = sine_and_cosine(c2 * s + c3)
            u[2 * k, column] = c0 + c1 * sine
            u[2 * k + 1, column] = rate * c1 * c2 * cosine
        else:
            root = math.sqrt(max(c1 * c1 - (s - c2) * (s - c2), 0.0))
            u[2 * k, column] = c0 + c3 * root
            u[2 * k + 1, column] = -rate * c3 * (s - c2) / root if root > 0.0 else 0.0
