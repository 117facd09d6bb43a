"""Step matrices of a piecewise linear model: one set per combination of modes, computed when it first occurs.

In fixed modes the model is ``x' = A x + r + B u``; ``u`` are value, rate (and acceleration) of every track. On one
piece a track is described by its *signals*, its value and first derivatives. They satisfy a small linear equation,
``u^(J) = 0`` for polynomials and ``u''' = -w^2 u'`` for sines. A step is therefore computed from Taylor series in time,
summed over a length at which they converge quickly, and doubled until they reach the step.
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
    """Sizes and row offsets of a propagator.

    ``signals`` are those of one track; ``waves`` counts the angular frequencies of sines, number 0 being polynomials.
    The first rows contain the images of ``e^(A h) - 1``; the row ``drift`` the effect of the constant over a step;
    the rows from ``forcing`` on the effect of each wave, track and signal; from ``slope`` on the images of ``A``,
    then ``r``; from ``input_slope`` on the images of ``B``; from ``series`` on the series of the effect of each track
    and signal.
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
    """All propagators computed so far, for steps of ``step`` s, and the modes of each.

    For each of them, ``fastest`` is a bound of its rates and those of the waves (rad/s or 1/s); ``terms`` the number
    of series terms for a jump inside a step (0: no series); ``kick`` the largest deviation of a switching function
    from its chord due to a jump inside a step, and ``throw`` that due to a jump at its end. ``used`` contains the
    number of propagators and the index of the current one.
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

    ``sizes`` are the numbers of states, of tracks, and of inputs and signals per track; ``slopes`` is the number of
    quantities that the native function of slopes differentiates; ``frequency`` contains the angular frequencies of
    the sines (rad/s) after a zero, ``scale`` typical sizes of the states.
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
    """Return the number of series terms for a jump inside a step in which the fastest motion turns by ``z`` radians."""
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
