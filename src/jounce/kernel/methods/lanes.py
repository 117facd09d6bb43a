"""Many variants of a piecewise linear model over one course, side by side: metrics of their outputs, no samples kept.

All variants feel the same signals at the same times, and each keeps the modes it rests in; so a step is the same
handful of products for every variant, and variants lie side by side in vector registers. What a step needs of a
variant (``propagators``) is made one after another, a block of variants is then taken through the whole run. A variant
whose switching functions come near to their other side, or whose motions are too fast for the common step, is left to
the careful way (``methods.exact``): its ``margin`` says so.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from llvmlite import ir

from jounce.core.types import Array
from jounce.kernel.arrays import Integers, Matrix, Vector
from jounce.kernel.call import Loop
from jounce.kernel.engine import Problem, Tracks
from jounce.kernel.methods.propagators import Propagators
from jounce.kernel.native import Native, Source, kept_code

if TYPE_CHECKING:
    import casadi as ca

    from jounce.kernel.lowering import Lowering

_follow = Loop("lanes")
SUMS, NEARS = 4, 3
"""Numbers kept of an output (sum, sum of squares, least, greatest) and of a switching function."""
_CACHE = 24_000  # bytes that the arrays of a block should not exceed


@dataclass(frozen=True)
class Sizes:
    """What the code of a step is made for.

    Numbers of states, of signals of all tracks, of inputs, of outputs and switching functions that are looked at; which
    signals jump at edges inside steps; how many terms of a series a jump takes; and how many numbers of the model the
    switching functions need.
    """

    states: int
    signals: int
    inputs: int
    outputs: int
    switches: int
    jumping: tuple[int, ...]
    terms: int
    numbers: int = 0

    @property
    def kept(self) -> int:
        """Rows of what a step changes."""
        return self.states + SUMS * self.outputs + NEARS * self.switches

    @property
    def places(self) -> tuple[int, int, int, int, int, int]:
        """Where drift, forcing, series, outputs and numbers begin in the rows of a variant; and the end."""
        drift = self.states**2
        forcing = drift + self.states
        series = forcing + self.states * self.signals
        outputs = series + self.states * self.terms * len(self.jumping)
        numbers = outputs + self.outputs * (self.states + self.inputs + 1)
        return drift, forcing, series, outputs, numbers, numbers + self.numbers

    @property
    def lanes(self) -> int:
        """Variants side by side."""
        fit = _CACHE // (8 * (2 * self.kept + self.places[-1]))
        return int(np.clip(fit // 8 * 8, 8, 32))


NAMES = ("step", "step_over_edge", "part", "part_over_edge")
"""Functions of a step: with a sample at its end or without, and with edges of the course inside or without."""


@dataclass(frozen=True)
class Steps:
    """What the module of native code holds: ``f(kept, variant, course, modes, kept)`` of many variants.

    ``switch`` is the model's function of (states, inputs, extended parameters, modes), of which it needs ``numbers``.
    """

    sizes: Sizes
    switch: ca.Function
    numbers: tuple[int, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the functions."""
        return NAMES

    def add(self, lowering: Lowering) -> None:
        """Append the functions."""
        import casadi as ca

        for name in NAMES:
            inputs, result = self._graph(name.startswith("step"), name.endswith("edge"))
            lowering.add_many(f"{name} of many", ca.Function(name, inputs, [result]), internal=True)
            # With a number of variants that it knows, LLVM sees that rows do not overlap, and takes them in vectors.
            native = lowering.declare(name, [ir.DoubleType().as_pointer()] * 5)
            builder = ir.IRBuilder(native.append_basic_block())
            wide = (ir.IntType(64)(number) for number in (self.sizes.lanes, 0, self.sizes.lanes))
            builder.call(lowering.module.globals[f"{name} of many"], [*native.args, *wide])
            builder.ret_void()

    def _graph(self, sampled: bool, over_edge: bool) -> tuple[list[ca.SX], ca.SX]:
        import casadi as ca

        sizes, n, inputs = self.sizes, self.sizes.states, self.sizes.inputs
        drift, forcing, series, outputs, numbers, end = sizes.places
        kept, variant, m = ca.SX.sym("kept", sizes.kept), ca.SX.sym("variant", end), ca.SX.sym("m", sizes.switches)
        count = len(sizes.jumping) * sizes.terms
        course = ca.SX.sym("course", sizes.signals + 2 * inputs + (inputs + count if over_edge else 0))
        signals, ends = course[: sizes.signals], course[sizes.signals : sizes.signals + 2 * inputs]
        after, before = ends[:inputs], ends[inputs:]
        x, sums, near = kept[:n], kept[n : n + SUMS * sizes.outputs], kept[n + SUMS * sizes.outputs :]
        moved = x + ca.reshape(variant[: n * n], n, n) @ x + variant[drift:forcing]
        moved += ca.reshape(variant[forcing:series], n, sizes.signals) @ signals
        if over_edge and count:
            moved += ca.reshape(variant[series:outputs], n, count) @ course[sizes.signals + 3 * inputs :]
        if sampled and sizes.outputs:
            table = ca.reshape(variant[outputs:numbers], n + inputs + 1, sizes.outputs).T
            y = table @ ca.vertcat(moved, after, 1.0)
            total, squares, least, most = (sums[i::SUMS] for i in range(SUMS))
            found = ca.horzcat(total + y, squares + y * y, ca.fmin(least, y), ca.fmax(most, y))
            sums = ca.reshape(found.T, SUMS * sizes.outputs, 1)
        if sizes.switches:
            p = ca.SX(self.switch.size1_in(2), 1)
            for i, number in enumerate(self.numbers):
                p[number] = variant[numbers + i]

            def distance(u: ca.SX) -> ca.SX:
                """How far each switching function is from its other side."""
                return (2.0 * m - 1.0) * self.switch(moved, u, p, m)

            # It may come nearer inside a step than at its ends: by its bend, and by what edges throw it.
            change, last, margin = (near[i::NEARS] for i in range(NEARS))
            last_of_step = distance(before)
            bend = ca.fabs(last_of_step - last - change)
            if over_edge:
                thrown = course[sizes.signals + 2 * inputs : sizes.signals + 3 * inputs]
                ways = [ca.fabs(distance(before + way * thrown) - last_of_step) for way in (-1.0, 1.0)]
                bend += ca.fmax(*ways)
            nearest = ca.fmin(margin, ca.fmin(last_of_step, last) - bend)
            found = ca.horzcat(last_of_step - last, distance(after), nearest)
            near = ca.reshape(found.T, NEARS * sizes.switches, 1)
        return [kept, variant, course, m], ca.densify(ca.vertcat(moved, sums, near))


class Course(NamedTuple):
    """What all variants feel: at each step the signals at its start, then the inputs just after and before its end.

    ``edges`` numbers the steps with edges inside (-1: none), whose rows in ``over_edges`` go on with how far these
    throw each input, and what their jumps weigh.
    ``still`` are the inputs that the variants rest under, ``start`` those just after the start.
    """

    level: Matrix
    over_edges: Matrix
    edges: Integers
    still: Vector
    start: Vector


class Addresses(NamedTuple):
    """Native functions: of the model, then of the steps in the order of ``NAMES``."""

    derived: int
    output: int
    switch: int
    step: int
    step_over_edge: int
    part: int
    part_over_edge: int


class Room(NamedTuple):
    """Arrays that a block of variants works in; ``kept`` and ``next`` take turns."""

    kept: Matrix
    next: Matrix
    variant: Matrix
    balance: Matrix
    rows: Matrix
    state: Matrix
    inputs: Matrix
    values: Matrix
    outputs: Matrix
    switches: Matrix


class Work(NamedTuple):
    """Variants from ``first`` to ``stop`` (``span``), one row of ``parameters`` each, and what is found of them.

    ``chosen`` are the outputs looked at, ``side`` the sign of each switching function at rest. ``sums`` has ``SUMS``
    numbers of each output, about its value at ``rest``; ``margin`` is how near a switch came, below zero where the
    variant has to go the careful way.
    """

    problem: Problem
    props: Propagators
    addresses: Addresses
    course: Course
    room: Room
    parameters: Matrix
    span: Integers
    chosen: Integers
    side: Vector
    jumping: Integers
    numbers: Integers
    parts: int
    terms: int
    fastest: float
    sums: Matrix
    rest: Matrix
    margin: Vector


def course(tracks: Tracks, signals: int, inputs: int, times: Array, jumping: Sequence[int], terms: int) -> Course:
    """Lay out what tracks of polynomials do over steps between ``times`` (s), all of one length."""
    count = len(tracks.rate)
    order = inputs // max(count, 1)
    slack = 1e-12 * max(1.0, abs(times[-1]))
    nodes, before = np.empty((2, len(times), count * signals))
    weights: dict[int, Array] = {}
    for track in range(count):
        first, last = tracks.first[track], tracks.first[track + 1] - 1
        stops, own = tracks.stop[first:last], slice(track * signals, (track + 1) * signals)
        for found, side, shift in ((nodes, "right", slack), (before, "left", -slack)):
            piece = first + np.searchsorted(stops, times + shift, side=side)  # type: ignore[call-overload]
            found[:, own] = _signals(tracks, track, piece, times, signals)
        step = np.searchsorted(times, stops - slack, side="left") - 1  # the step in which each edge lies
        for i, k in enumerate(step):
            left = times[k + 1] - stops[i] if 0 <= k < len(times) - 1 else 0.0
            if left <= slack:  # an edge on a node needs nothing: the step behind it begins with the new piece
                continue
            at = np.array([stops[i]])
            old, new = (_signals(tracks, track, np.array([first + i + j]), at, signals)[0] for j in (0, 1))
            of = weights.setdefault(int(k), np.zeros(inputs + len(jumping) * terms))
            for j, jump in enumerate(new - old):
                if j < order:
                    of[track * order + j] += abs(jump)
                if 0 < j <= order:
                    of[track * order + j - 1] += abs(jump) * (times[k + 1] - times[k])
                if track * signals + j in jumping:
                    place = inputs + list(jumping).index(track * signals + j) * terms
                    of[place : place + terms] += jump * left ** np.arange(1, terms + 1)
    held = [track * signals + i for track in range(count) for i in range(order)]
    values = nodes[:, held]
    level = np.ascontiguousarray(np.hstack([nodes[:-1], values[1:], before[1:, held]]))
    edges = np.full(len(times) - 1, -1, dtype=np.int64)
    edges[list(weights)] = np.arange(len(weights))
    over = np.zeros((len(weights), level.shape[1] + inputs + len(jumping) * terms))
    for row, (k, of) in enumerate(weights.items()):
        over[row, : level.shape[1]], over[row, level.shape[1] :] = level[k], of
    still = np.where(np.arange(inputs) % max(order, 1) == 0, values[0], 0.0)
    return Course(level, over, edges, still, values[0].copy())


def jumps(tracks: Tracks, signals: int) -> tuple[int, ...]:
    """Which signals of tracks of polynomials jump at an edge, but for rounding."""
    found = set()
    for track in range(len(tracks.rate)):
        first, last = tracks.first[track], tracks.first[track + 1] - 1
        inner = np.arange(first, last)
        at = tracks.stop[first:last]
        old, new = (_signals(tracks, track, inner + j, at, signals) for j in (0, 1))
        size = 1e-12 * np.max(np.abs(np.vstack([old, new, np.zeros((1, signals))])), axis=0)
        found |= {track * signals + int(j) for j in np.flatnonzero(np.any(np.abs(new - old) > size, axis=0))}
    return tuple(sorted(found))


def _signals(tracks: Tracks, track: int, piece: Integers, times: Array, signals: int) -> Array:
    """Value and derivatives of some pieces at some times."""
    rate, c = tracks.rate[track], tracks.coefficients[piece].T
    s = rate * (times - tracks.start[piece])
    found = [
        c[0] + s * (c[1] + s * (c[2] + s * c[3])),
        rate * (c[1] + s * (2.0 * c[2] + 3.0 * s * c[3])),
        rate**2 * (2.0 * c[2] + 6.0 * s * c[3]),
        6.0 * rate**3 * c[3],
    ]
    return np.array(found[:signals]).T


class Code(NamedTuple):
    """Addresses of the functions of a step, what they are made for, and which numbers the switching functions need."""

    address: tuple[int, ...]
    sizes: Sizes
    numbers: tuple[int, ...]


def code(identity: str, sizes: Sizes, switch: Callable[[], ca.Function]) -> Code:
    """Native code of steps for a model; ``identity`` says everything that its switching functions depend on."""
    key = (identity, sizes)
    if key not in _KEPT:
        native, notes = kept_code(f"lanes {sizes} {identity}", lambda: _source(sizes, switch()))
        numbers = tuple(json.loads(notes))
        found = Code(tuple(native.address[name] for name in NAMES), replace(sizes, numbers=len(numbers)), numbers)
        _KEPT[key] = found, native
    return _KEPT[key][0]


_KEPT: dict[tuple[str, Sizes], tuple[Code, Native]] = {}


def _source(sizes: Sizes, switch: ca.Function) -> Source:
    import casadi as ca

    x, u, p, m = (ca.SX.sym(name, switch.size1_in(i)) for i, name in enumerate("xupm"))
    found = switch(x, u, p, m)
    numbers = tuple(i for i in range(p.shape[0]) if ca.depends_on(found, p[i]))
    return Source({}, Steps(replace(sizes, numbers=len(numbers)), switch, numbers), json.dumps(numbers))


def room(sizes: Sizes, values: int, outputs: int) -> Room:
    """Arrays for blocks of variants, with so many extended parameters and outputs of the model."""
    n, wide = sizes.states, sizes.lanes
    return Room(
        np.zeros((sizes.kept, wide)),
        np.zeros((sizes.kept, wide)),
        np.zeros((sizes.places[-1], wide)),
        np.zeros((n, n + 1)),
        np.zeros((sizes.outputs, n + sizes.inputs)),
        np.zeros((n, 1)),
        np.zeros((sizes.inputs, 1)),
        np.zeros((1, values)),
        np.zeros((outputs, 1)),
        np.zeros((2, sizes.switches)),
    )


def follow(work: Work) -> None:
    """Take the variants of a span through the run; the loop holds no lock of the interpreter meanwhile."""
    _follow(work)
