"""Input signals for the compiled loops: every track a chain of closed-form pieces, flattened into arrays."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.kernel.call import part, sine_and_cosine


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


@part()
def advance(tracks: Any, piece: Any, t: float, slack: float) -> float:
    """Move ``piece`` to the pieces that hold just after ``t``; give the next edge of any track."""
    edge = np.inf
    for k in range(len(piece)):
        last = tracks.first[k + 1] - 1
        while piece[k] < last and tracks.stop[piece[k]] <= t + slack:
            piece[k] += 1
        if piece[k] < last:
            edge = min(edge, tracks.stop[piece[k]])
    return edge


@part(forceinline=True)
def _fill_line(times: Any, start: float, height: float, slope: float, rows: Any) -> None:
    """Fill value, rate and acceleration of a line that begins at ``height``."""
    for j in range(len(times)):
        rows[0, j] = height + slope * (times[j] - start)
        rows[1, j] = slope
        if len(rows) > 2:
            rows[2, j] = 0.0


@part()
def fill(tracks: Any, piece: Any, times: Any, u: Any) -> None:
    """Fill a column of ``u`` for each time with (value, rate[, acceleration]) of every track, on the pieces given."""
    start, kind, coefficients, rates = tracks.start, tracks.kind, tracks.coefficients, tracks.rate
    order = u.shape[0] // max(len(piece), 1)
    for k in range(len(piece)):
        i, rate, value, slope = piece[k], rates[k], order * k, order * k + 1
        c0, c1, c2, c3 = coefficients[i, 0], coefficients[i, 1], coefficients[i, 2], coefficients[i, 3]
        if kind[i] == 0 and c2 == 0.0 and c3 == 0.0:  # most roads are lines, and most loads are level
            _fill_line(times, start[i], c0, rate * c1, u[value : value + order])
        elif kind[i] == 0:
            for j in range(len(times)):
                s = rate * (times[j] - start[i])
                u[value, j] = c0 + s * (c1 + s * (c2 + s * c3))
                u[slope, j] = rate * (c1 + s * (2.0 * c2 + 3.0 * s * c3))
                if order > 2:
                    u[slope + 1, j] = rate * rate * (2.0 * c2 + 6.0 * s * c3)
        elif kind[i] == 1:
            for j in range(len(times)):
                sine, cosine = sine_and_cosine(c2 * (rate * (times[j] - start[i])) + c3)
                u[value, j] = c0 + c1 * sine
                u[slope, j] = rate * c1 * c2 * cosine
                if order > 2:
                    u[slope + 1, j] = -rate * rate * c1 * c2 * c2 * sine
        else:
            for j in range(len(times)):
                s = rate * (times[j] - start[i]) - c2
                root = math.sqrt(max(c1 * c1 - s * s, 0.0))
                u[value, j] = c0 + c3 * root
                u[slope, j] = -rate * c3 * s / root if root > 0.0 else 0.0
                if order > 2:
                    u[slope + 1, j] = -rate * rate * c3 * c1 * c1 / root**3 if root > 0.0 else 0.0


@part()
def fill_rates(tracks: Any, piece: Any, t: float, u: Any) -> None:
    """Fill ``u`` with the rates of what ``fill`` gives at ``t``: (rate, acceleration[, jerk]) of every track."""
    order = len(u) // max(len(piece), 1)
    for k in range(len(piece)):
        i, rate = piece[k], tracks.rate[k]
        c1, c2, c3 = tracks.coefficients[i, 1], tracks.coefficients[i, 2], tracks.coefficients[i, 3]
        s = rate * (t - tracks.start[i])
        first, second, third = 0.0, 0.0, 0.0
        if tracks.kind[i] == 0:
            first, second, third = c1 + s * (2.0 * c2 + 3.0 * s * c3), 2.0 * c2 + 6.0 * s * c3, 6.0 * c3
        elif tracks.kind[i] == 1:
            sine, cosine = sine_and_cosine(c2 * s + c3)
            first, second, third = c1 * c2 * cosine, -c1 * c2 * c2 * sine, -c1 * c2**3 * cosine
        else:
            s -= c2
            root = math.sqrt(max(c1 * c1 - s * s, 0.0))
            if root > 0.0:
                first, second, third = -c3 * s / root, -c3 * (c1 / root) ** 2 / root, -3.0 * c3 * s * c1 * c1 / root**5
        u[order * k], u[order * k + 1] = rate * first, rate * rate * second
        if order > 2:
            u[order * k + 2] = rate**3 * third
