"""Signals as a chain of closed-form pieces, whose edges integrators can step to exactly.

A road over distance and a base motion over time are both ``Segments``. This module has the slow, readable
evaluation; the kernel has the compiled one.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array

POLYNOMIAL, SINE, CIRCLE = 0, 1, 2


@dataclass(frozen=True)
class Segments:
    """Pieces of a height signal over an ascending coordinate (distance in m, or time in s).

    On piece ``i`` the local coordinate is ``s = rate * (x - edges[i])`` in metres and the height is, by ``kind[i]``,

    - POLYNOMIAL: ``c0 + c1 s + c2 s^2 + c3 s^3``,
    - SINE: ``c0 + c1 sin(c2 s + c3)``,
    - CIRCLE: ``c0 + c3 sqrt(c1^2 - (s - c2)^2)`` (``c1`` radius, ``c2`` centre, ``c3`` +1 or -1).

    Attributes
    ----------
    edges : ndarray, shape (n + 1,)
        Ascending edges of the pieces; the first and the last piece extend beyond the outer edges.
    kind : ndarray of int64, shape (n,)
        Kind of each piece.
    coefficients : ndarray, shape (n, 4)
        ``c0 .. c3`` of each piece, SI.
    rate : float
        Metres of local coordinate for one unit of ``x``: 1 over distance, the speed in m/s over time.
    """

    edges: Array
    kind: NDArray[np.int64]
    coefficients: Array
    rate: float = 1.0

    @cached_property
    def extent(self) -> float:
        """Maximum minus minimum height, evaluated at the ends and midpoints of the pieces, m."""
        if self.is_made_of_lines:
            begin = self.coefficients[:, 0]
            end = begin + self.rate * np.diff(self.edges) * self.coefficients[:, 1]
            return float(max(begin.max(), end.max()) - min(begin.min(), end.min()))
        first, last = self.edges[:-1], self.edges[1:]
        ends = np.nextafter(last, first)
        return float(np.ptp(self.evaluate(np.concatenate([first, 0.5 * (first + last), ends]))[0]))

    @cached_property
    def is_made_of_lines(self) -> bool:
        """Whether all pieces are straight lines; roads can have thousands of them."""
        return not self.kind.any() and not self.coefficients[:, 2:].any()

    @cached_property
    def fastest_wave(self) -> float:
        """Highest angular frequency of the sines, radians per unit of ``x``; 0 without sines."""
        return float(
            np.max(np.abs(self.coefficients[self.kind == SINE, 2]) * self.rate, initial=0.0)
        )

    def in_time(self, speed: float) -> Segments:
        """Return the same heights as a function of time for a constant ``speed`` in m/s."""
        return replace(self, edges=self.edges / speed, rate=self.rate * speed)

    def split_at(self, x: Array) -> Segments:
        """Return the same signal with additional edges at ``x`` (unit of ``edges``); values outside are ignored.

        Examples
        --------
        >>> import numpy as np
        >>> line = piecewise_linear(np.array([0.0, 2.0]), np.array([0.0, 4.0]))
        >>> line.split_at(np.array([0.5])).coefficients[:, :2].tolist()
        [[0.0, 2.0], [1.0, 2.0]]
        """
        inside = np.setdiff1d(x[(x > self.edges[0]) & (x < self.edges[-1])], self.edges)
        if not inside.size:
            return self
        piece = self.piece_at(inside)
        s = self.rate * (inside - self.edges[piece])
        table = self.coefficients[piece].copy()
        c0, c1, c2, c3 = table.T.copy()
        kind = self.kind[piece]
        polynomial = (
            c0 + s * (c1 + s * (c2 + s * c3)),
            c1 + s * (2.0 * c2 + 3.0 * s * c3),
            c2 + 3.0 * s * c3,
        )
        for column, moved in enumerate(polynomial):
            table[:, column] = np.where(kind == POLYNOMIAL, moved, table[:, column])
        table[:, 3] = np.where(kind == SINE, c3 + c2 * s, table[:, 3])
        table[:, 2] = np.where(kind == CIRCLE, c2 - s, table[:, 2])
        return replace(
            self,
            edges=np.insert(self.edges, piece + 1, inside),
            kind=np.insert(self.kind, piece + 1, kind),
            coefficients=np.insert(self.coefficients, piece + 1, table, axis=0),
        )

    def stretch_to(self, edges: Array) -> Segments:
        """Return the same pieces between new edges, each stretched to fit.

        Examples
        --------
        >>> import numpy as np
        >>> line = piecewise_linear(np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0, 0.0]))
        >>> line.stretch_to(np.array([0.0, 0.5, 4.5])).evaluate(np.array([0.25, 2.5]))[0].tolist()
        [0.5, 0.5]
        """
        stretch = np.diff(self.edges) / np.diff(edges)
        table = self.coefficients.copy()
        for power in (1, 2, 3):
            table[:, power] *= np.where(self.kind == POLYNOMIAL, stretch**power, 1.0)
        table[:, 2] *= np.where(self.kind == SINE, stretch, 1.0)
        for column, factor in ((1, 1.0 / stretch), (2, 1.0 / stretch), (3, stretch)):
            table[:, column] *= np.where(self.kind == CIRCLE, factor, 1.0)
        return replace(self, edges=edges, coefficients=table)

    def in_time_along(self, time: Array, distance: Array) -> Segments:
        """Return the same heights over time, for the distance (m) travelled at each time (s); both must ascend."""
        split = self.split_at(distance)
        return split.stretch_to(np.interp(split.edges, distance, time))

    def times(self, factor: float) -> Segments:
        """Return the same pieces with heights multiplied by a factor (1)."""
        if factor == 1.0:
            return self
        scaled = {POLYNOMIAL: (0, 1, 2, 3), SINE: (0, 1), CIRCLE: (0, 3)}
        table = self.coefficients.copy()
        for kind, columns in scaled.items():
            for column in columns:
                table[self.kind == kind, column] *= factor
        return replace(self, coefficients=table)

    def evaluate(self, x: Array) -> tuple[Array, Array]:
        """Height (m) and its derivative (m per unit of ``x``) at ``x``; at an edge, those of the right-hand piece."""
        x = np.asarray(x, dtype=float)
        return self.on_pieces(self.piece_at(x), x)

    def piece_at(self, x: Array) -> NDArray[np.int64]:
        """Index of the piece at ``x`` (unit of ``edges``); at an edge, that of the right-hand piece."""
        return (self.edges.searchsorted(x, side="right") - 1).clip(0, len(self.kind) - 1)

    def on_pieces(self, piece: NDArray[np.int64], x: Array) -> tuple[Array, Array]:
        """Height (m) and derivative of the given pieces at ``x`` (unit of ``edges``), inside or outside the pieces."""
        s = self.rate * (x - self.edges[piece])
        coefficients, kind = self.coefficients.T[:, piece], self.kind[piece]
        height, slope = _polynomial(s, *coefficients)
        for other, law in ((SINE, _sine), (CIRCLE, _circle)):
            chosen = kind == other
            if chosen.any():
                height[chosen], slope[chosen] = law(s[chosen], *coefficients[:, chosen])
        return height, self.rate * slope

    @cached_property
    def jumps(self) -> Array:
        """Height of the jump at each inner edge, positive upwards, shape (n - 1,), m."""
        inner, pieces = self.edges[1:-1], np.arange(len(self.kind))
        if self.is_made_of_lines:
            before = (
                self.coefficients[:-1, 0]
                + self.rate * np.diff(self.edges[:-1]) * self.coefficients[:-1, 1]
            )
            return np.asarray(self.coefficients[1:, 0] - before)
        return np.asarray(
            self.on_pieces(pieces[1:], inner)[0] - self.on_pieces(pieces[:-1], inner)[0]
        )

    def with_ramps(self, shortest: float) -> Segments:
        """Return the same signal with a ramp just before each jump, at least ``shortest`` long (unit of ``x``).

        The ramp, over 1e-5 of the jump's height, gives the impulse of the jump to forces that depend on the rate of
        the signal, such as that of a tyre's damper.
        """
        (at,) = np.nonzero(np.abs(self.jumps) > JUMP)
        if not len(at):
            return self
        edge, left = self.edges[at + 1], self.edges[at]
        width = np.maximum(_CHORD * np.abs(self.jumps[at]) / self.rate, shortest)
        begin = edge - np.minimum(width, 0.5 * (edge - left))
        lower = self.on_pieces(at, begin)[0]
        ramps = np.zeros((len(at), 4))
        ramps[:, 0] = lower
        ramps[:, 1] = (self.on_pieces(at + 1, edge)[0] - lower) / (self.rate * (edge - begin))
        return replace(
            self,
            edges=np.insert(self.edges, at + 1, begin),
            kind=np.insert(self.kind, at + 1, POLYNOMIAL),
            coefficients=np.insert(self.coefficients, at + 1, ramps, axis=0),
        )

    def with_finite_slopes(self) -> Segments:
        """Return the same signal with a short chord wherever a circle begins or ends with a vertical tangent.

        The slope of a circle is infinite there; the chord, over 1e-5 of the radius, gives a damper the same impulse.
        """
        if not np.any(self.kind == CIRCLE):
            return self
        edges, kinds, coefficients = [float(self.edges[0])], [], []
        for start, stop, kind, c in zip(
            self.edges[:-1], self.edges[1:], self.kind, self.coefficients, strict=True
        ):
            for end, piece_kind, piece in _split(kind, c, self.rate * (stop - start)):
                edges.append(float(stop) if end is None else float(start + end / self.rate))
                kinds.append(piece_kind)
                coefficients.append(piece)
        return replace(
            self,
            edges=np.array(edges),
            kind=np.array(kinds, dtype=np.int64),
            coefficients=np.array(coefficients),
        )


_CHORD = (
    1e-5  # of the radius, or of the height of a jump: far shorter than a step, longer than rounding
)
JUMP = 1e-6
"""Minimum difference of heights at an edge that counts as a jump, m."""


def _split(kind: int, c: Array, length: float) -> list[tuple[float | None, int, Array]]:
    """Parts of one piece: end (local coordinate in m; None: end of the piece), kind and coefficients of each."""
    short = _CHORD * c[1]
    if kind != CIRCLE or length <= 2.0 * short:
        return [(None, kind, c)]
    base, radius, centre, sign = c
    rise = sign * np.sqrt(radius**2 - (radius - short) ** 2)
    begins, ends = radius - centre <= short * _CHORD, radius - (length - centre) <= short * _CHORD
    parts: list[tuple[float | None, int, Array]] = []
    if begins:
        parts.append((short, POLYNOMIAL, np.array([base, rise / short, 0.0, 0.0])))
        centre -= short
    parts.append((length - short if ends else None, CIRCLE, np.array([base, radius, centre, sign])))
    if ends:
        parts.append((None, POLYNOMIAL, np.array([base + rise, -rise / short, 0.0, 0.0])))
    return parts


def _polynomial(s: Array, c0: Array, c1: Array, c2: Array, c3: Array) -> tuple[Array, Array]:
    return np.asarray(c0 + s * (c1 + s * (c2 + s * c3))), np.asarray(
        c1 + s * (2.0 * c2 + 3.0 * s * c3)
    )


def _sine(s: Array, c0: Array, c1: Array, c2: Array, c3: Array) -> tuple[Array, Array]:
    return c0 + c1 * np.sin(c2 * s + c3), c1 * c2 * np.cos(c2 * s + c3)


def _circle(s: Array, c0: Array, c1: Array, c2: Array, c3: Array) -> tuple[Array, Array]:
    share = (s - c2) / c1
    root = c1 * np.sqrt(np.maximum((1.0 - share) * (1.0 + share), 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = np.where(root > 0.0, -c3 * (s - c2) / root, 0.0)
    return c0 + c3 * root, slope


def flat(end: float, height: float = 0.0) -> Segments:
    """One level piece from 0 to ``end``."""
    return Segments(
        np.array([0.0, end]), np.zeros(1, dtype=np.int64), np.array([[height, 0.0, 0.0, 0.0]])
    )


def piecewise_linear(x: Array, height: Array) -> Segments:
    """Straight lines through the points (``x`` strictly ascending)."""
    x, height = np.asarray(x, dtype=float), np.asarray(height, dtype=float)
    coefficients = np.zeros((len(x) - 1, 4))
    coefficients[:, 0] = height[:-1]
    coefficients[:, 1] = np.diff(height) / np.diff(x)
    return Segments(x, np.zeros(len(x) - 1, dtype=np.int64), coefficients)
