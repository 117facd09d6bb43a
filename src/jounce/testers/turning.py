"""How an eccentric exciter turns over a tester's programme: exact pieces of its angle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.parts.testers import Programme

_RUN_OUT = 10.0  # Hz/s: how fast an eccentric exciter is stopped that has not reached rest at the end of its sweep


@dataclass(frozen=True)
class Turning:
    """Angle of an eccentric exciter over one controlled test: held, swept, stopped.

    Attributes
    ----------
    edges : ndarray, shape (4,)
        Begin of hold, sweep, stop, and its end, s.
    coefficients : ndarray, shape (3, 3)
        Angle (rad), rate (rad/s) and half the acceleration (rad/s^2) at the begin of each.
    """

    edges: Array
    coefficients: Array

    @property
    def end(self) -> float:
        """Angle at which it stands in the end, rad."""
        angle, rate, half = self.coefficients[-1]
        length = self.edges[-1] - self.edges[-2]
        return float(angle + length * (rate + length * half))


def turning(programme: Programme, static_load: float, begin: float = 0.0, angle: float = 0.0) -> Turning:
    """Give the exciter's angle over a programme, exact: a quadratic in time where the frequency changes.

    Parameters
    ----------
    programme : Programme
        Hold and sweep.
    static_load : float
        Of the wheel, N.
    begin : float
        When it starts to turn, s.
    angle : float
        Where it starts, rad.

    Returns
    -------
    Turning
        Pieces.

    Examples
    --------
    >>> from jounce.parts.testers import load_tester
    >>> found = turning(load_tester("eusama").programme, 4000.0)
    >>> found.edges.tolist()   # s: 25 Hz for 1.5 s, then 2.5 Hz/s down to rest
    [0.0, 1.5, 11.5, 11.5]
    """
    first, last = 2.0 * np.pi * programme.start_frequency, 2.0 * np.pi * programme.end_frequency
    slope = np.copysign(2.0 * np.pi * programme.sweep_rate, last - first)
    lengths = programme.hold(static_load), (last - first) / slope, last / (2.0 * np.pi * _RUN_OUT)
    rows, edges = [], [begin]
    for length, rate, half in zip(lengths, (first, first, last), (0.0, 0.5 * slope, -np.pi * _RUN_OUT), strict=True):
        rows.append([angle, rate, half])
        angle += length * (rate + length * half)
        edges.append(edges[-1] + length)
    return Turning(np.array(edges), np.array(rows))


def angle_of(tests: list[Turning]) -> Segments:
    """Join the tests of one exciter, which stands still before, between and after them."""
    edges, rows = [-1.0], [[tests[0].coefficients[0, 0] if tests else 0.0, 0.0, 0.0]]
    for test in tests:
        edges += list(test.edges[:3])
        rows += [list(row) for row in test.coefficients]
        edges.append(test.edges[3])
        rows.append([test.end, 0.0, 0.0])
    edges.append(edges[-1] + 1.0)
    kept = [i for i in range(len(rows)) if edges[i + 1] > edges[i]]
    coefficients = np.zeros((len(kept), 4))
    coefficients[:, :3] = np.array(rows)[kept]
    return Segments(np.array([*(edges[i] for i in kept), edges[-1]]), np.zeros(len(kept), np.int64), coefficients)
