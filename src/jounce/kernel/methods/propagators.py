"""Step matrices of a piecewise linear model: one set for each combination of modes, made when it first occurs.

With modes held the model is ``x' = A x + r + B u``; ``u`` are value, rate (and acceleration) of every track. On one
piece a track is known by its *signals*, its value and first derivatives. They obey a small linear equation of their
own, ``u^(J) = 0`` on polynomials and ``u''' = -w^2 u'`` on sines. So all that a step needs are Taylor series in time,
summed over a length at which they converge at once, and doubled until they reach the step.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from jounce.core.types import Array
from jounce.kernel.arrays import Block, Integers, Matrix, Vector
from jounce.kernel.methods.rows import RowLoops, padded_length, row_loops

PROBES = (0.0, 0.5, 1.0)
"""Shares of a part of a step at which the switching functions are looked at."""
TERMS = 24
"""Rows of a series, from order 0 on."""
_MOST = 256  # propagators that are kept


class Calls(NamedTuple):
    """Addresses of native functions; ``slopes`` takes ``lanes`` directions at once."""

    rate: int
    switch: int
    switch_many: int
    slopes: int
    lanes: int


class Layout(NamedTuple):
    """Sizes, and where things begin in the rows of a propagator.

    ``signals`` are those of one track; ``waves`` counts the angular frequencies of sines, number 0 being polynomials.
    The first rows hold the images of ``e^(A h) - 1``; the row ``drift`` what the constant adds over a step; from
    ``forcing`` on, for each wave, track and signal, what that adds; from ``slope`` on the images of ``A``; then ``r``;
    from ``input_slope`` on the images of ``B``; from ``series`` on, for each track and signal, the series of what it
    does since it began.
    """

    states: int
    inputs: int
    order: int
    tracks: int
    signals: int
    waves: int
    drift: int
    forcing: int
    slope: int
    constant: int
    input_slope: int
    series: int
    rows: int


class Scratch(NamedTuple):
    """Workspace.

    Directions and slopes along them; derivatives of a track, series of all inputs and of the state; powers of time;
    squares; turned signals; inputs at rest and at the start; switching functions, and their changes.
    """

    seeds: Matrix
    slopes: Matrix
    derivatives: Vector
    inputs: Matrix
    series: Matrix
    powers: Vector
    square: Matrix
    turned: Matrix
    still: Matrix
    base: Matrix
    switches: Matrix
    thrown: Matrix


class Propagators(NamedTuple):
    """All propagators made so far, for steps of ``step`` s, and the modes each belongs to.

    For each of them ``fastest`` is a bound of its rates and those of the waves (rad/s or 1/s), ``terms`` how many terms
    of a series a jump inside a step takes (0: it has none), ``kick`` how far, at most, a jump of a signal inside a step
    throws a switching function off its chord, and ``throw`` how far one at its end. ``used`` is how many there were,
    and which one is in use.
    """

    calls: Calls
    loops: RowLoops
    layout: Layout
    scratch: Scratch
    step: float
    frequency: Vector
    scale: Vector
    matrix: Block
    modes: Matrix
    fastest: Vector
    terms: Integers
    kick: Block
    throw: Block
    used: Integers


def propagators(
    calls: Calls,
    sizes: tuple[int, int, int, int],
    slopes: int,
    switches: int,
    frequency: Array,
    scale: Array,
) -> Propagators:
    """Allocate propagators; the length of their step is set later.

    ``sizes`` are numbers of states, of tracks, and for each track of inputs and of signals; ``slopes`` is how many
    quantities the native function of slopes differentiates; ``frequency`` holds the angular frequencies of the sines
    (rad/s) after a zero, ``scale`` typical sizes of the states.
    """
    width, count = padded_length(sizes[0]), min(2 ** min(switches, 60), _MOST)
    layout = _layout(*sizes, waves=len(frequency), width=width)
    return Propagators(
        calls,
        row_loops(width, sizes[0]),
        layout,
        _scratch(layout, width, calls, slopes, switches),
        0.0,
        frequency,
        scale,
        np.zeros((count, layout.rows, width)),
        np.zeros((count, switches)),
        np.zeros(count),
        np.zeros(count, dtype=np.int64),
        np.zeros((count, layout.tracks * layout.signals, switches)),
        np.zeros((count, layout.tracks * layout.signals, switches)),
        np.zeros(2, dtype=np.int64),
    )


def terms_of(z: float) -> int:
    """Terms of a series needed for a jump inside a step in which the fastest motion turns by ``z`` radians."""
    term, count = 1.0, 0
    while term > 1e-16 and count < TERMS - 1:
        count += 1
        term *= z / count
    return count


def _layout(
    states: int, tracks: int, order: int, signals: int, *, waves: int, width: int
) -> Layout:
    forcing = width + 1
    slope = forcing + waves * tracks * signals
    constant = slope + states
    series = constant + 1 + tracks * order
    rows = series + tracks * signals * TERMS
    sizes = (states, tracks * order, order, tracks, signals, waves)
    return Layout(*sizes, width, forcing, slope, constant, constant + 1, series, rows)


def _scratch(layout: Layout, width: int, calls: Calls, slopes: int, switches: int) -> Scratch:
    n, inputs = layout.states, layout.inputs
    return Scratch(
        seeds=np.zeros((1, n + (n + inputs) * calls.lanes)),
        slopes=np.zeros((1, slopes * calls.lanes)),
        derivatives=np.zeros(TERMS + 4),
        inputs=np.zeros((TERMS, inputs)),
        series=np.zeros((TERMS, width)),
        powers=np.zeros(TERMS),
        square=np.zeros((2 * width, width)),
        turned=np.zeros((4, 4)),
        still=np.zeros((inputs, 1)),
        base=np.zeros((inputs, 1)),
        switches=np.zeros((len(PROBES) + 1, switches)),
        thrown=np.zeros((2 * inputs, switches)),
    )
