"""Closed-form profiles of single obstacles, and their layout along a road."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE, Segments
from jounce.core.types import Array

Piece = tuple[float, int, tuple[float, float, float, float]]
SHORTEST = 1e-12  # pieces shorter than this (relative to 1 m, or to the coordinate) are rounding


@dataclass(frozen=True)
class Profile:
    """Pieces of one obstacle over its own coordinate, and the levels on either side.

    Attributes
    ----------
    edges : ndarray, shape (n + 1,)
        Ascending borders in m (or s); a bare step has one edge and no piece.
    kind : ndarray of int64, shape (n,)
        Piece kinds of `jounce.core.segments`.
    coefficients : ndarray, shape (n, 4)
        Their coefficients, SI.
    before, after : float
        Height in m on either side.
    """

    edges: Array
    kind: NDArray[np.int64]
    coefficients: Array
    before: float = 0.0
    after: float = 0.0

    @property
    def span(self) -> float:
        """Length from the first to the last edge, in m (or s)."""
        return float(self.edges[-1] - self.edges[0])


def profile(*pieces: Piece, after: float = 0.0) -> Profile:
    """Return a profile from x = 0 and level 0; pieces are (length in m, kind, coefficients), empty ones are skipped."""
    long_pieces = [piece for piece in pieces if piece[0] > SHORTEST]
    lengths = [piece[0] for piece in long_pieces]
    return Profile(
        edges=np.concatenate([[0.0], np.cumsum(lengths)]),
        kind=np.array([piece[1] for piece in long_pieces], dtype=np.int64),
        coefficients=np.array([piece[2] for piece in long_pieces], dtype=float).reshape(
            len(long_pieces), 4
        ),
        after=after,
    )


def linear_profile(x: Array, height: Array) -> Profile:
    """Return lines through points (``x`` strictly ascending, m or s; heights in m); collinear lines are merged."""
    slope = np.diff(height) / np.diff(x)
    bends = np.concatenate([[True], np.diff(slope) != 0.0])
    coefficients = np.zeros((int(bends.sum()), 4))
    coefficients[:, 0] = height[:-1][bends]
    coefficients[:, 1] = slope[bends]
    edges = np.append(x[:-1][bends], x[-1])
    kind = np.zeros(len(coefficients), dtype=np.int64)
    return Profile(edges, kind, coefficients, float(height[0]), float(height[-1]))


def cubic_profile(x: Array, height: Array) -> Profile:
    """Return a cubic spline (not-a-knot) through points; ``x`` strictly ascending, m or s; heights in m."""
    from scipy.interpolate import CubicSpline

    coefficients = np.ascontiguousarray(CubicSpline(x, height).c[::-1].T)
    kind = np.zeros(len(coefficients), dtype=np.int64)
    return Profile(
        np.asarray(x, dtype=float), kind, coefficients, float(height[0]), float(height[-1])
    )


def hermite_profile(x: Array, height: Array, slope: Array) -> Profile:
    """Return cubics through points (``x`` strictly ascending, m or s; heights in m) with given slopes."""
    return hermite_pieces(x, height[:-1], height[1:], slope[:-1], slope[1:])


def hermite_pieces(
    x: Array, left: Array, right: Array, left_slope: Array, right_slope: Array
) -> Profile:
    """Return cubics between edges ``x`` (m or s), each with own end heights (m) and slopes; jumps are preserved."""
    span = np.diff(x)
    mean = (right - left) / span
    coefficients = np.empty((len(span), 4))
    coefficients[:, 0] = left
    coefficients[:, 1] = left_slope
    coefficients[:, 2] = (3.0 * mean - 2.0 * left_slope - right_slope) / span
    coefficients[:, 3] = (left_slope + right_slope - 2.0 * mean) / span**2
    edges = np.asarray(x, dtype=float)
    return Profile(
        edges, np.zeros(len(span), dtype=np.int64), coefficients, float(left[0]), float(right[-1])
    )


def repeat(profile: Profile, count: int, pitch: float) -> Profile:
    """Repeat a profile with ``pitch`` in m from start to start, each at the end level of the previous one."""
    if count == 1:
        return profile
    rise = profile.after - profile.before
    places = [(k * pitch, k * rise) for k in range(count)]
    laid = lay_out(
        profile, places, float(profile.edges[0]), (count - 1) * pitch + float(profile.edges[-1])
    )
    return Profile(
        laid.edges, laid.kind, laid.coefficients, profile.before, profile.after + (count - 1) * rise
    )


def lay_out(
    profile: Profile, places: Iterable[tuple[float, float]], low: float, high: float
) -> Segments:
    """Lay a profile at ascending ``places``; return the heights over [``low``, ``high``] (m or s).

    A place is the position of the profile's origin and its height offset in m. Level pieces fill the gaps; the level
    before the first place is that of the profile.
    """
    starts: list[Array] = []
    kinds: list[NDArray[np.int64]] = []
    coefficients: list[Array] = []
    cursor, level = low, profile.before

    def fill(until: float) -> None:
        if until - cursor > _rounding(until) or (
            until == high and not starts
        ):  # a course may be shorter
            starts.append(np.array([cursor]))
            kinds.append(np.array([POLYNOMIAL]))
            coefficients.append(np.array([[level, 0.0, 0.0, 0.0]]))

    for position, lift in places:
        begin, end = position + float(profile.edges[0]), position + float(profile.edges[-1])
        if begin > high - _rounding(high):
            break
        if end > low + _rounding(low):
            fill(begin)
            starts.append(position + profile.edges[:-1])
            kinds.append(profile.kind)
            coefficients.append(
                profile.coefficients + np.array([lift, 0.0, 0.0, 0.0])
                if lift
                else profile.coefficients
            )
            cursor = end
        level = profile.after + lift
    fill(high)
    parts = (
        (starts[0], kinds[0], coefficients[0])
        if len(starts) == 1
        else (np.concatenate(starts), np.concatenate(kinds), np.concatenate(coefficients))
    )
    return _cut(*parts, low, high)


def _rounding(x: float) -> float:
    return SHORTEST * max(1.0, abs(x))


def _cut(
    starts: Array, kind: NDArray[np.int64], coefficients: Array, low: float, high: float
) -> Segments:
    """Cut the pieces to [low, high] without changing their heights."""
    first = max(int(np.searchsorted(starts, low + _rounding(low), side="right")) - 1, 0)
    last = max(int(np.searchsorted(starts, high - _rounding(high), side="left")), first + 1)
    starts, kind, coefficients = starts[first:last], kind[first:last], coefficients[first:last]
    if starts[0] != low:
        coefficients = coefficients.copy()
        coefficients[0] = _advance(int(kind[0]), coefficients[0], low - float(starts[0]))
    return Segments(np.concatenate([[low], starts[1:], [high]]), kind, coefficients)


def _advance(kind: int, c: Array, by: float) -> Array:
    """Shift the origin of a piece's local coordinate by ``by``; return the coefficients of the same curve."""
    if kind == SINE:
        return np.array([c[0], c[1], c[2], c[3] + c[2] * by])
    if kind == CIRCLE:
        return np.array([c[0], c[1], c[2] - by, c[3]])
    return np.array(
        [
            c[0] + by * (c[1] + by * (c[2] + by * c[3])),
            c[1] + by * (2.0 * c[2] + 3.0 * by * c[3]),
            c[2] + 3.0 * by * c[3],
            c[3],
        ]
    )


def passes(first: float, recurrence: float | None, high: float) -> Iterable[tuple[float, float]]:
    """Return the places up to ``high`` of an obstacle that starts at ``first`` and recurs every ``recurrence`` (m)."""
    if recurrence is None:
        return [(first, 0.0)]
    count = max(1, math.ceil((high - first) / recurrence) + 1)
    return ((first + k * recurrence, 0.0) for k in range(count))


def periodic_places(
    start: float, period: float, low: float, high: float
) -> list[tuple[float, float]]:
    """Return the places (m) at which the periods of an infinite periodic road start, from ``low`` to ``high``."""
    first, last = math.floor((low - start) / period) - 1, math.ceil((high - start) / period) + 1
    return [(start + k * period, 0.0) for k in range(first, last)]
