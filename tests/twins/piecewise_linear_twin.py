"""Slow, readable twin of exact propagation: one matrix exponential for every stretch between edges and events.

On a stretch with fixed modes the model is ``x' = A x + r + B0 u + B1 u'``. The road's piece obeys ``u'''' = 0`` or, on
a sine, ``u''' = -w^2 u'``; state, a one and the road's derivatives together are an autonomous linear system. Its
exponential from SciPy gives the state at any time, so crossings of the switching functions are found by bisection.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq

LOOKS = 5000.0  # a second
BAND, BAND_AT_EDGES = 1e-13, 1e-9


def derivatives(road, i: int, t: float) -> list[float]:
    """Height of a piece and its first three derivatives by time."""
    c0, c1, c2, c3 = road.coefficients[i]
    v, s = road.rate, road.rate * (t - road.edges[i])
    if road.kind[i] == 1:
        w, angle = v * c2, c2 * s + c3
        sine, cosine = math.sin(angle), math.cos(angle)
        return [c0 + c1 * sine, c1 * w * cosine, -c1 * w**2 * sine, -c1 * w**3 * cosine]
    return [
        c0 + c1 * s + c2 * s**2 + c3 * s**3,
        v * (c1 + 2 * c2 * s + 3 * c3 * s**2),
        v**2 * (2 * c2 + 6 * c3 * s),
        6 * v**3 * c3,
    ]


class Stretch:
    """The joined system on one piece with fixed modes, from a time on."""

    def __init__(self, compiled, p, road, i: int, modes, t: float, x) -> None:
        zero, still = np.zeros(len(x)), np.zeros(2)
        self.compiled, self.p, self.road, self.i, self.modes, self.t = (
            compiled,
            p,
            road,
            i,
            modes,
            t,
        )
        n = len(x)
        self.matrix = np.zeros((n + 5, n + 5))
        self.matrix[:n, :n] = compiled.evaluate("rate_x", zero, still, p, modes)
        self.matrix[:n, n] = compiled.evaluate("rate", zero, still, p, modes)
        self.matrix[:n, n + 1 : n + 3] = compiled.evaluate("rate_u", zero, still, p, modes)
        self.matrix[[n + 1, n + 2, n + 3], [n + 2, n + 3, n + 4]] = 1.0
        if road.kind[i] == 1:
            self.matrix[n + 4, n + 3] = -((road.rate * road.coefficients[i, 2]) ** 2)
        self.start = np.concatenate([x, [1.0], derivatives(road, i, t)])

    def at(self, t: float):
        """State, a one and derivatives of the road."""
        return expm(self.matrix * (t - self.t)) @ self.start

    def switches(self, joined):
        return self.compiled.evaluate("switch", joined[:-5], joined[-4:-2], self.p, self.modes)


def run(compiled, p, road, times, x):
    """States at ``times`` (s), from ``x`` on."""
    first = np.array(derivatives(road, 0, times[0])[:2])
    modes = (
        compiled.evaluate("switch", x, first, p, np.ones(len(compiled.facts.switches))) > 0.0
    ).astype(float)
    found, t, i = [x], times[0], 0
    for end in times[1:]:
        while t < end:
            while i < len(road.kind) - 1 and road.edges[i + 1] <= t:
                i += 1
            stop = min(end, road.edges[i + 1]) if i < len(road.kind) - 1 else end
            stretch = Stretch(compiled, p, road, i, modes, t, x)
            t, which = first_crossing(stretch, stop)
            x = stretch.at(t)[:-5]
            if which is not None:
                modes = modes.copy()
                modes[which] = 1.0 - modes[which]
        found.append(x)
    return np.array(found).T


def first_crossing(stretch: Stretch, stop: float):
    """Time at which a switch first leaves its side, and which; the end and None where none does."""
    sides, joined = 2.0 * stretch.modes - 1.0, stretch.start
    wrong = np.flatnonzero(sides * stretch.switches(joined) < -BAND_AT_EDGES)
    if wrong.size:
        return stretch.t, wrong[0]
    looks = max(2, math.ceil(LOOKS * (stop - stretch.t)))
    step = (stop - stretch.t) / looks
    onwards = expm(stretch.matrix * step)
    for k in range(looks):
        joined = onwards @ joined
        wrong = np.flatnonzero(sides * stretch.switches(joined) < -BAND)
        if wrong.size:
            low, high = stretch.t + k * step, stretch.t + (k + 1) * step
            return min((_root(stretch, sides[i], i, low, high), i) for i in wrong)
    return stop, None


def _root(stretch: Stretch, side: float, i: int, low: float, high: float) -> float:
    def value(t: float) -> float:
        return side * stretch.switches(stretch.at(t))[i]

    while value(low) <= 0.0:  # an event has just passed
        low += 1e-9
        if low >= high:
            return stretch.t
    return brentq(value, low, high, xtol=1e-16, rtol=1e-15)
