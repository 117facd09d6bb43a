"""Computation of propagators (see ``methods.propagators``)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from jounce.kernel.loops.compiling import call_native, part
from jounce.kernel.loops.rows import add_rows
from jounce.kernel.methods.propagators import TERMS

_CLOSE, _CLOSE_JUMP = (
    1e-19,
    1e-16,
)  # of a series' first terms, below which the rest counts for nothing
_FAR = 1e6  # how far inputs are moved to see what they make of switching functions: m, m/s, N, ...


@part()
def find(problem: Any, props: Any) -> None:
    """Select the propagator of the current modes; build it if it does not exist yet."""
    modes, used = problem.m, props.used
    for c in range(min(used[0], len(props.fastest))):
        same = True
        for i in range(len(modes)):
            same = same and props.modes[c, i] == modes[i]
        if same:
            used[1] = c
            return
    used[1] = used[0] % len(props.fastest)  # the oldest makes room
    used[0] += 1
    build(problem, props, used[1])
    _kicks(problem, props, props.matrix[used[1]], used[1])


@part()
def build(problem: Any, props: Any, c: int) -> None:
    """Fill in all rows of a propagator for the problem's modes and parameters."""
    matrix, lay = props.matrix[c], props.layout
    for i in range(len(problem.m)):
        props.modes[c, i] = problem.m[i]
    read_slopes(problem, props, matrix)
    bound = rate_bound(props, matrix)
    for k in range(lay.waves):
        bound = max(bound, props.frequency[k])
    props.fastest[c] = bound
    z = bound * props.step
    props.terms[c] = terms_for(z, _CLOSE_JUMP) if z <= 1.0 else 0
    # The series of one step converge fast only up to about one radian; a longer step is a short one squared, again and
    # again.
    doublings = 0
    while z > 1.0 and doublings < 200:
        z *= 0.5
        doublings += 1
    _first_step(props, matrix, props.step * 0.5**doublings, terms_for(z, _CLOSE))
    for k in range(doublings):
        _double(props, matrix, props.step * 0.5 ** (doublings - k))


@part()
def terms_for(z: float, close: float) -> int:
    """Return the number of significant terms of the series of ``e^z``."""
    term, count = 1.0, 0
    while term > close and count < TERMS - 1:
        count += 1
        term *= z / count
    return count


@part()
def read_slopes(problem: Any, props: Any, matrix: Any) -> None:
    """Fill in ``A``, ``B`` and ``r`` for the problem's modes; the other rows are set to zero."""
    lay, calls, room = props.layout, props.calls, props.scratch
    n, lanes, directions = lay.states, calls.lanes, lay.states + lay.inputs
    matrix[:] = 0.0
    room.still[:] = 0.0
    for first in range(0, directions, lanes):
        room.seeds[:] = 0.0
        for lane in range(min(lanes, directions - first)):
            room.seeds[0, n + (first + lane) * lanes + lane] = 1.0
        call_native(calls.slopes, room.seeds, 0, room.still, problem.p, problem.m, room.slopes, 0)
        for lane in range(min(lanes, directions - first)):
            direction = first + lane
            row = lay.slope + direction if direction < n else lay.input_slope + direction - n
            for i in range(n):
                matrix[row, i] = room.slopes[0, i * lanes + lane]
    room.seeds[:] = 0.0
    call_native(calls.rate, room.seeds, 0, room.still, problem.p, problem.m, matrix, lay.constant)


@part()
def rate_bound(props: Any, matrix: Any) -> float:
    """Return a bound of the rates of a model (rad/s or 1/s): a norm of ``A^4``, scaled by typical state sizes."""
    n, width, first = props.layout.states, matrix.shape[1], props.layout.slope
    square, scale = props.scratch.square, props.scale
    square[:] = 0.0
    for i in range(n):
        for d in range(n):
            square[i, d] = matrix[first + i, d] * scale[i] / scale[d]
    # The norm of A itself overestimates: it multiplies stiffness over mass by speed over displacement. Roots of the
    # norms of its square and fourth power come closer to the largest eigenvalue, and are bounds as well.
    least = _norm(square, 0, n)
    for power in range(1, 3):
        for i in range(n):
            for d in range(width):
                square[width + i, d] = 0.0
            add_rows(props.loops.add, square, width + i, square, 0, square, i * width, n, 1)
        for i in range(n):
            for d in range(n):
                square[i, d] = square[width + i, d]
        least = min(least, _norm(square, 0, n) ** (0.5**power))
    return float(max(least, 1e-3))


@part()
def _norm(matrix: Any, first: int, count: int) -> float:
    largest = 0.0
    for i in range(first, first + count):
        total = 0.0
        for d in range(count):
            total += abs(matrix[i, d])
        largest = max(largest, total) if total == total else np.inf  # noqa: PLR0124 - not a number
    return largest


@part()
def spread_derivatives(room: Any, track: int, order: int, terms: int) -> None:
    """Write a track's columns of the inputs' series from its derivatives."""
    share = 1.0
    for p in range(terms):
        for i in range(order):
            room.inputs[p, track * order + i] = room.derivatives[p + i] * share
        share /= p + 1


@part()
def expand(
    props: Any, matrix: Any, constant: float, driven: int, terms: int, to: Any, row: int
) -> None:
    """Compute the series of the state up to the order ``terms`` from its order 0 in ``to[row]``.

    ``constant`` is the factor of ``r``, and ``driven`` the number of orders in the series of the inputs.
    """
    lay, width = props.layout, to.shape[1]
    for p in range(terms):
        at = row + p
        for d in range(width):
            to[at + 1, d] = constant * matrix[lay.constant, d] if p == 0 else 0.0
        add_rows(props.loops.add, to, at + 1, matrix, lay.slope, to, at * width, lay.states, 1)
        if p < driven:
            add_rows(
                props.loops.add,
                to,
                at + 1,
                matrix,
                lay.input_slope,
                props.scratch.inputs,
                p * lay.inputs,
                lay.inputs,
                1,
            )
        for d in range(width):
            to[at + 1, d] /= p + 1


@part(forceinline=True)
def powers_of(powers: Any, factor: float, t: float, count: int) -> None:
    """Compute ``factor`` times the powers of ``t``, starting with order 0."""
    for p in range(count):
        powers[p] = factor
        factor *= t


@part()
def _first_step(props: Any, matrix: Any, h: float, terms: int) -> None:
    """Compute the rows for a step at which all series converge."""
    lay, room = props.layout, props.scratch
    series, powers = room.series, room.powers
    room.inputs[:] = 0.0
    powers_of(powers, 1.0, h, terms + 1)
    for j in range(lay.states):
        series[0, :] = 0.0
        series[0, j] = 1.0
        expand(props, matrix, 0.0, 0, terms, series, 0)
        add_rows(props.loops.add, matrix, j, series, 1, powers, 1, terms, 1)
    series[0, :] = 0.0
    expand(props, matrix, 1.0, 0, terms, series, 0)
    add_rows(props.loops.add, matrix, lay.drift, series, 1, powers, 1, terms, 1)
    for wave in range(lay.waves):
        for track in range(lay.tracks):
            for j in range(lay.signals if wave == 0 else min(lay.signals, 3)):
                _force(props, matrix, wave, track, j, terms)


@part()
def _force(props: Any, matrix: Any, wave: int, track: int, signal: int, terms: int) -> None:
    """Compute the contribution of one signal over a step; for polynomials its series is stored."""
    lay, room = props.layout, props.scratch
    square = props.frequency[wave] ** 2
    room.derivatives[:] = 0.0
    room.derivatives[signal] = 1.0
    for q in range(1, TERMS):
        room.derivatives[q + 2] -= square * room.derivatives[q]
    room.inputs[:] = 0.0
    spread_derivatives(room, track, lay.order, TERMS)
    forced = lay.forcing + (wave * lay.tracks + track) * lay.signals + signal
    if wave > 0:
        room.series[0, :] = 0.0
        expand(props, matrix, 0.0, TERMS, terms, room.series, 0)
        add_rows(props.loops.add, matrix, forced, room.series, 1, room.powers, 1, terms, 1)
    else:
        row = lay.series + (track * lay.signals + signal) * TERMS
        expand(props, matrix, 0.0, 4, TERMS - 1, matrix, row)
        add_rows(props.loops.add, matrix, forced, matrix, row + 1, room.powers, 1, terms, 1)


@part()
def _double(props: Any, matrix: Any, h: float) -> None:
    """Compute the rows of a step of length ``2 h`` from those of ``h``."""
    lay, width = props.layout, matrix.shape[1]
    old = props.scratch.square
    for wave in range(lay.waves):
        _turn(props.scratch.turned, props.frequency[wave], h)
        for track in range(lay.tracks):
            _double_forcing(props, matrix, lay.forcing + (wave * lay.tracks + track) * lay.signals)
    # What acts over the second half acts as over the first, from where the first half has left the state.
    for d in range(width):
        old[0, d] = matrix[lay.drift, d]
        matrix[lay.drift, d] *= 2.0
    add_rows(props.loops.add, matrix, lay.drift, matrix, 0, old, 0, lay.states, 1)
    for j in range(lay.states):
        for d in range(width):
            old[j, d] = matrix[j, d]
    # e^2a - 1 = 2 (e^a - 1) + (e^a - 1)^2: kept without the one, slow states lose no digits beside fast ones.
    for j in range(lay.states):
        for d in range(width):
            matrix[j, d] *= 2.0
        add_rows(props.loops.add, matrix, j, old, 0, old, j * width, lay.states, 1)


@part()
def _double_forcing(props: Any, matrix: Any, first: int) -> None:
    """Do the same for the contributions of the signals of one track; ``turned`` advances them over the first step."""
    lay, old, width = props.layout, props.scratch.square, matrix.shape[1]
    for j in range(lay.signals):
        for d in range(width):
            old[j, d] = matrix[first + j, d]
    for j in range(lay.signals):
        add_rows(props.loops.add, matrix, first + j, matrix, 0, old, j * width, lay.states, 1)
        for i in range(lay.signals):
            for d in range(width):
                matrix[first + j, d] += props.scratch.turned[i, j] * old[i, d]


@part()
def _turn(turned: Any, w: float, h: float) -> None:
    """Compute the matrix that advances the signals by one step."""
    turned[:] = 0.0
    turned[0, 0] = 1.0
    if w == 0.0:
        for i in range(4):
            share = 1.0
            for j in range(i, 4):
                turned[i, j] = share
                share *= h / (j - i + 1)
        return
    # 1 - cos by the half angle, which loses no digits where the step is short against the wave.
    sine, cosine, half = math.sin(w * h), math.cos(w * h), math.sin(0.5 * w * h)
    turned[0, 1], turned[0, 2] = sine / w, 2.0 * (half / w) ** 2
    turned[1, 1], turned[1, 2] = cosine, sine / w
    turned[2, 1], turned[2, 2] = -w * sine, cosine


@part()
def _kicks(problem: Any, props: Any, matrix: Any, c: int) -> None:
    """Compute the largest deviation of each switching function from its chord due to a unit jump of each signal.

    The deviation is the jump itself plus the curvature that it causes over a quarter step, doubled for safety. At the
    end of a step only the jump itself counts, because the function deviates by it just before the end.
    """
    lay, kick, throw, found = props.layout, props.kick[c], props.throw[c], props.scratch.thrown
    if len(problem.m) == 0:
        return
    _throws(problem, props, matrix)
    for track in range(lay.tracks):
        for j in range(lay.signals):
            q, row = track * lay.order + j, track * lay.signals + j
            for i in range(len(problem.m)):
                kick[row, i] = (
                    2.0 * (found[q, i] + 0.25 * props.step * found[lay.inputs + q, i])
                    if j < lay.order
                    else 0.0
                )
                throw[row, i] = found[q, i] if j < lay.order else 0.0
                if 0 < j <= lay.order:
                    kick[row, i] += 0.5 * props.step * found[q - 1, i]


@part()
def _throws(problem: Any, props: Any, matrix: Any) -> None:
    """Compute the change of the switching functions along each input, then along its effect on the rates, both ways.

    The evaluation point is far out, so for a function that is the minimum of several lines, the steepest one counts.
    """
    lay, room = props.layout, props.scratch
    found, here, x, u = room.thrown, room.switches, room.seeds, room.base
    room.thrown[:] = 0.0
    for d in range(lay.states):
        x[0, d] = problem.x0[d]
    call_native(props.calls.switch, x, 0, u, problem.p, problem.m, here, 0)
    for q in range(lay.inputs):
        value = u[q, 0]
        for way in (-_FAR, _FAR):
            u[q, 0] = value + way
            call_native(props.calls.switch, x, 0, u, problem.p, problem.m, here, 1)
            u[q, 0] = value
            for d in range(lay.states):
                x[0, d] = problem.x0[d] + way * matrix[lay.input_slope + q, d]
            call_native(props.calls.switch, x, 0, u, problem.p, problem.m, here, 2)
            for d in range(lay.states):
                x[0, d] = problem.x0[d]
            for i in range(len(problem.m)):
                found[q, i] = max(found[q, i], abs(here[1, i] - here[0, i]) / _FAR)
                found[lay.inputs + q, i] = max(
                    found[lay.inputs + q, i], abs(here[2, i] - here[0, i]) / _FAR
                )
