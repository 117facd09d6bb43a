"""Many variants of a piecewise linear model over one course, side by side: metrics of their outputs, without samples.

All variants have the same input signals at the same times. While no contact changes, a step consists of the same few
products for every variant, and the variants are side by side in vector registers. The step data of the variants
(``propagators``) are computed one by one, then a block of variants is propagated through the whole run. After each
step the switching functions are checked. A variant in which one may have left its side repeats the step separately,
through all its events (``methods.exact``), and returns to the block with the step data of its new modes. A variant
with motions too fast for the common step is marked ``alone`` and must run separately.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from jounce.core.remembered import Recent
from jounce.core.types import Array
from jounce.kernel.arrays import Block, IntegerMatrix, Integers, Matrix, Vector
from jounce.kernel.call import Loop
from jounce.kernel.engine import Tracks
from jounce.kernel.machine import vector_width
from jounce.kernel.methods.exact import Run
from jounce.kernel.native import Source, code_from_cache

if TYPE_CHECKING:
    import casadi as ca

    from jounce.kernel.lowering import Lowering

_follow = Loop("lanes")
SUMS, NEARS = 4, 2
"""Numbers kept of an output (sum, sum of squares, least, greatest) and of a switching function (it and its rate)."""
_TOGETHER = (
    3  # combinations of signals that jump in one step, for each of which there is code of its own
)
ALONE = -2
"""Number of a step that all variants take by themselves."""
_CACHE = 24_000  # bytes that the arrays of a block should not exceed
_MODES = 16  # combinations of modes whose matrices are kept of each variant of a block


LOOKS = ("look", "glance")
"""Functions for what is looked at where one variant has come to by itself, with a sample there or without."""


@dataclass(frozen=True)
class Sizes:
    """Properties that the code of a step depends on.

    They are: the numbers of states, tracks, nonzero signals and inputs; the states, then inputs, on which each
    evaluated output depends (``rows``); the numbers of switching functions and of signals that jump at edges inside
    steps; the combinations of such signals that occur in one step; the number of series terms of a jump; whether some
    steps have no sample at their end; and the number of model parameters that the switching functions and their rates
    need.
    """

    states: int
    tracks: int
    signals: int
    inputs: int
    rows: tuple[tuple[int, ...], ...]
    switches: int
    jumping: int
    together: tuple[tuple[int, ...], ...]
    terms: int
    parted: bool
    numbers: int = 0

    @property
    def outputs(self) -> int:
        """Number of outputs."""
        return len(self.rows)

    @property
    def memory(self) -> int:
        """Return the number of rows that a step changes; the last is the least distance of a switch to zero."""
        return self.states + SUMS * self.outputs + NEARS * self.switches + 1

    @property
    def places(self) -> tuple[int, int, int, int, int, int, int]:
        """Return the offsets of drift, forcing, series, outputs, parameters and modes in a variant, and the end."""
        drift = self.states**2
        forcing = drift + self.states
        series = forcing + self.states * self.signals
        outputs = series + self.states * self.terms * self.jumping
        numbers = outputs + sum(len(row) + 1 for row in self.rows)
        modes = numbers + self.numbers
        return drift, forcing, series, outputs, numbers, modes, modes + self.switches

    @property
    def lanes(self) -> int:
        """Variants side by side."""
        fit = _CACHE // (8 * (2 * self.memory + self.places[-1]))
        return (
            int(np.clip(fit // 8 * 8, 8, 32)) if fit >= 8 else vector_width()
        )  # one vector at least

    @property
    def modes(self) -> int:
        """Number of mode combinations per variant whose matrices are stored."""
        return int(min(2 ** min(self.switches, 60), _MODES))

    @property
    def steps(self) -> tuple[tuple[bool, tuple[int, ...] | None], ...]:
        """Return the kinds of step: whether a sample is at the end, and which signals jump inside (None: no edge)."""
        kinds = (None, *self.together)
        return tuple(
            (sampled, jumping) for sampled in (True, False)[: 1 + self.parted] for jumping in kinds
        )

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the functions."""
        return *LOOKS, *(f"step {i}" for i in range(len(self.steps)))


@dataclass(frozen=True)
class Steps:
    """Functions of the native module: ``f(kept, variant, course, length, kept)``, steps of many variants.

    ``watch`` returns the switching functions of the model, then their rates, from (states, inputs, rates of the last
    input of each track, extended parameters, modes); ``numbers`` are the parameters that it needs.
    """

    sizes: Sizes
    watch: ca.Function
    numbers: tuple[int, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the functions."""
        return self.sizes.names

    def add(self, lowering: Lowering) -> None:
        """Append the functions."""
        import casadi as ca

        for name in LOOKS:
            lowering.add(name, ca.Function(name, *self._graph(sampled=name == "look")))
        for i, (sampled, jumping) in enumerate(self.sizes.steps):
            graph = self._graph(sampled=sampled, steps=True, jumping=jumping)
            lowering.add_wide(f"step {i}", ca.Function("step", *graph), self.sizes.lanes)

    def _graph(
        self, *, sampled: bool, steps: bool = False, jumping: tuple[int, ...] | None = None
    ) -> tuple[list[ca.SX], list[ca.SX]]:
        import casadi as ca

        sizes, n, inputs, terms = self.sizes, self.sizes.states, self.sizes.inputs, self.sizes.terms
        drift, forcing, series, outputs, numbers, modes, end = sizes.places
        memory, variant, length = (
            ca.SX.sym("kept", sizes.memory),
            ca.SX.sym("variant", end),
            ca.SX.sym("length"),
        )
        side, over_edge = inputs + sizes.tracks, jumping is not None
        course = ca.SX.sym(
            "course",
            sizes.signals + 2 * side + (inputs + sizes.jumping * terms if over_edge else 0),
        )
        after = course[sizes.signals : sizes.signals + side]
        before = course[sizes.signals + side : sizes.signals + 2 * side]
        at_edges = course[sizes.signals + 2 * side :]
        x, sums, near = (
            memory[:n],
            memory[n : n + SUMS * sizes.outputs],
            memory[n + SUMS * sizes.outputs : -1],
        )
        moved, nearest = x, ca.SX(1.0)
        if steps:
            moved = x + ca.reshape(variant[: n * n], n, n) @ x + variant[drift:forcing]
            moved += ca.reshape(variant[forcing:series], n, sizes.signals) @ course[: sizes.signals]
        for jump in jumping or ():
            own, place = series + jump * terms * n, inputs + jump * terms
            moved += (
                ca.reshape(variant[own : own + terms * n], n, terms)
                @ at_edges[place : place + terms]
            )
        if sampled and sizes.outputs:
            signals, y, place = ca.vertcat(moved, after[:inputs]), ca.SX(sizes.outputs, 1), outputs
            for k, row in enumerate(sizes.rows):
                end_of_row = place + len(row)
                y[k] = ca.dot(variant[place:end_of_row], signals[list(row)]) + variant[end_of_row]
                place = end_of_row + 1
            total, squares, least, most = (sums[i::SUMS] for i in range(SUMS))
            updated = ca.horzcat(total + y, squares + y * y, ca.fmin(least, y), ca.fmax(most, y))
            sums = ca.reshape(updated.T, SUMS * sizes.outputs, 1)
        if sizes.switches:
            p, m, sign = (
                ca.SX(self.watch.size1_in(3), 1),
                variant[modes:],
                2.0 * variant[modes:] - 1.0,
            )
            for i, number in enumerate(self.numbers):
                p[number] = variant[numbers + i]

            def watch(at: ca.SX) -> tuple[ca.SX, ca.SX]:
                """Emit the distance of each switching function from zero, and the rate at which it moves away."""
                values = self.watch(moved, at[:inputs], at[inputs:], p, m)
                return sign * values[: sizes.switches], sign * values[sizes.switches :]

            there, leaving = watch(after)
            if steps:
                # Inside a step a parabola with the rates at both ends dips below its chord by an eighth of their
                # difference, times the step; a quarter is to be safe. Edges throw it beyond that.
                (end_of_step, arriving), here, left = watch(before), near[0::NEARS], near[1::NEARS]
                dip = 0.25 * length * ca.fabs(arriving - left)
                if over_edge:
                    throw = ca.vertcat(at_edges[:inputs], ca.SX(sizes.tracks, 1))
                    ways = [
                        ca.fabs(watch(before + way * throw)[0] - end_of_step) for way in (-1.0, 1.0)
                    ]
                    dip += ca.fmax(*ways)
                lowest = ca.fmin(ca.fmin(end_of_step, here) - dip, there)
                nearest = lowest[0]
                for i in range(1, sizes.switches):
                    nearest = ca.fmin(nearest, lowest[i])
            near = ca.reshape(ca.horzcat(there, leaving).T, NEARS * sizes.switches, 1)
        return [memory, variant, course, length], [
            ca.densify(ca.vertcat(moved, sums, near, nearest))
        ]


class Course(NamedTuple):
    """Excitation of all variants at each step: signals at its start, then inputs just after and just before its end.

    Only nonzero signals are included (``felt``). The inputs are followed by the rate of the last input of each track.
    ``edges`` numbers the steps with edges inside (-1: none, ``ALONE``: between sines); their rows in ``over_edges``
    continue with the change of each input at the edges and the weights of the jumps; ``kinds`` is the index of each
    step in ``Sizes.steps``. ``clock`` (s) are the ends of the steps, beginning with the start of the first. The rows
    of ``ends`` are for the inputs at rest (``still``) and for those just after the start.
    """

    clock: Vector
    level: Matrix
    over_edges: Matrix
    edges: Integers
    kinds: Integers
    felt: Integers
    still: Vector
    ends: Matrix


class Addresses(NamedTuple):
    """Native functions: of the model, then ``LOOKS``, and steps as ``Sizes.steps`` has them."""

    derived: int
    output: int
    look: int
    glance: int
    steps: Integers


class Room(NamedTuple):
    """Scratch arrays of a block of variants.

    ``kept`` and ``next`` alternate; their columns, and those of ``variant``, are variants. The following have one row
    (or one section) per variant: parameters (``values``), ``modes``, ``rest``; propagators (``matrix`` to ``used``,
    as in ``Propagators``), and ``columns``, the values of ``variant`` in the modes of each propagator; ``laid`` marks
    which of them are computed. ``lost`` marks variants that run alone. ``one`` is a column of ``kept`` before and
    after a step; ``piece`` are the pieces of the tracks at the last separate step of a variant.
    """

    kept: Matrix
    next: Matrix
    variant: Matrix
    values: Matrix
    modes: Matrix
    rest: Matrix
    matrix: Block
    mode_table: Matrix
    fastest: Matrix
    terms: IntegerMatrix
    kick: Block
    throw: Block
    used: IntegerMatrix
    columns: Matrix
    laid: Integers
    lost: Integers
    one: Matrix
    piece: Integers
    balance: Matrix
    rows: Matrix
    state: Matrix
    inputs: Matrix
    outputs: Matrix


class Work(NamedTuple):
    """Variants from ``first`` to ``stop`` (``span``), one row of ``parameters`` each, and their results.

    ``run`` is used for the separate steps of a variant; ``chosen`` are the evaluated outputs, ``modes`` those at
    rest. ``length`` of a step (s) is an array of one number. ``sums`` has ``SUMS`` numbers per output, relative to
    its value at ``rest``; ``events`` counts the events of a variant; ``alone`` is 1 if it must run separately.
    ``depends`` lists the states and inputs on which the outputs depend (``Sizes.rows``), output by output; ``begins``
    are the first indices.
    """

    run: Run
    addresses: Addresses
    course: Course
    room: Room
    parameters: Matrix
    span: Integers
    chosen: Integers
    modes: Vector
    jumping: Integers
    numbers: Integers
    length: Vector
    parts: int
    terms: int
    fastest: float
    slack: float
    sums: Matrix
    rest: Matrix
    events: Integers
    alone: Integers
    depends: Integers
    begins: Integers


def dependence(identity: str, output: Callable[[], ca.Function]) -> tuple[tuple[int, ...], ...]:
    """Return the states, then inputs, on which each output of a model may depend, for any parameters and modes.

    ``identity`` identifies the function of (states, inputs, extended parameters, modes) from which they follow.
    """

    def source() -> Source:
        import casadi as ca

        function = output()
        arguments = [ca.SX.sym(name, function.size1_in(i)) for i, name in enumerate("xupm")]
        pattern = ca.jacobian_sparsity(ca.densify(function(*arguments)), ca.vertcat(*arguments[:2]))
        rows, columns = (np.array(part, dtype=int) for part in pattern.get_triplet())
        of = [np.unique(columns[rows == row]).tolist() for row in range(function.size1_out(0))]
        return Source({}, notes=json.dumps(of))

    def make() -> tuple[tuple[int, ...], ...]:
        return tuple(
            map(tuple, json.loads(code_from_cache(f"outputs depend on {identity}", source)[1]))
        )

    return _dependences.of(identity, make)


_dependences: Recent[tuple[tuple[int, ...], ...]] = Recent()


def course(
    tracks: Tracks,
    signals: int,
    inputs: int,
    times: Array,
    jumping: Sequence[int],
    terms: int,
    frequency: Array,
) -> tuple[Course, tuple[tuple[int, ...], ...]]:
    """Tabulate tracks of polynomials and sines over steps of equal length between ``times`` (s).

    ``frequency`` are the angular frequencies of the sines (rad/s) after a zero: each step has the signals of all of
    them, which are zero while a track is on a different piece. If a sine begins or ends inside a step, all variants
    take the step separately. The second result lists the combinations of ``jumping`` signals that jump in one step.
    """
    count = len(tracks.rate)
    order = inputs // max(count, 1)
    slack = 1e-12 * max(1.0, abs(times[-1]))
    each = max(signals, order + 1)
    nodes, before = np.empty((2, len(times), count * each))
    level = np.zeros((len(times) - 1, len(frequency), count, signals))
    jumped = np.zeros((len(times), len(jumping)), dtype=bool)
    thrown = np.zeros((len(times), inputs + len(jumping) * terms))  # of the step to each node
    edges = np.full(len(times), -1, dtype=np.int64)
    for track in range(count):
        first, last = tracks.first[track], tracks.first[track + 1] - 1
        stops, own = tracks.stop[first:last], slice(track * each, (track + 1) * each)
        for table, side, shift in ((nodes, "right", slack), (before, "left", -slack)):
            piece = first + np.searchsorted(stops, times + shift, side=side)  # type: ignore[call-overload]
            table[:, own] = _signals(tracks, track, piece, times, each)
            if table is nodes:
                wave = np.searchsorted(frequency, _frequency(tracks, track, piece[:-1]))
                here = nodes[:-1, own][:, :signals].copy()
                here[wave > 0, 3:] = 0.0  # which follows from the others on a sine
                level[np.arange(len(times) - 1), wave, track] = here
        step = (
            np.searchsorted(times, stops - slack, side="left") - 1
        )  # the step in which each edge lies
        inside = (step >= 0) & (step < len(times) - 1)
        left = np.where(inside, times[np.minimum(step + 1, len(times) - 1)] - stops, 0.0)
        edge = np.flatnonzero(
            left > slack
        )  # on a node it needs nothing: the step behind it begins with the new piece
        left, node = left[edge], step[edge] + 1
        bent = (tracks.kind[first + edge] == 1) | (tracks.kind[first + edge + 1] == 1)
        edges[node] = np.maximum(edges[node], 0)
        edges[node[bent]] = ALONE
        old, new = (_signals(tracks, track, first + edge + i, stops[edge], signals) for i in (0, 1))
        for j, jump in enumerate(np.where(bent[:, None], 0.0, new - old).T):
            if j < order:
                np.add.at(thrown[:, track * order + j], node, np.abs(jump))
            if 0 < j <= order:
                np.add.at(
                    thrown[:, track * order + j - 1], node, np.abs(jump) * (times[1] - times[0])
                )
            if track * signals + j in jumping:
                which = list(jumping).index(track * signals + j)
                jumped[node[jump != 0.0], which] = True
                place = inputs + which * terms
                for term in range(terms):
                    np.add.at(thrown[:, place + term], node, jump * left ** (term + 1))
    held, rates = (
        [track * each + i for track in range(count) for i in places]
        for places in (range(order), (order,))
    )
    ends = [*held, *rates]
    felt = np.flatnonzero(np.any(level, axis=0).ravel())
    rows = np.hstack([level.reshape(len(level), -1)[:, felt], nodes[1:, ends], before[1:, ends]])
    edges = edges[1:].copy()
    over = np.flatnonzero(edges >= 0)
    edges[over] = np.arange(len(over))
    together, kinds = np.unique(jumped[1:][over], axis=0, return_inverse=True)
    if len(together) > _TOGETHER:
        together, kinds = (
            np.ones((1, len(jumping)), dtype=bool),
            np.zeros(len(over), dtype=np.int64),
        )
    still = np.where(np.arange(inputs) % max(order, 1) == 0, nodes[0, held], 0.0)
    alike = np.zeros((2, rows.shape[1]))
    for row, at in enumerate((np.append(still, np.zeros(count)), nodes[0, ends])):
        alike[row, -2 * len(ends) :] = np.tile(at, 2)
    laid = Course(
        np.ascontiguousarray(times, dtype=float),
        np.ascontiguousarray(rows),
        np.ascontiguousarray(np.hstack([rows[over], thrown[1:][over]])),
        edges,
        1 + kinds.ravel().astype(np.int64),
        felt,
        still,
        alike,
    )
    return laid, tuple(tuple(np.flatnonzero(row).tolist()) for row in together)


def frequencies(tracks: Tracks) -> Array:
    """Return the angular frequencies of all sines (rad/s), ascending, after a zero."""
    of_tracks = [
        _frequency(tracks, k, np.arange(*tracks.first[k : k + 2])) for k in range(len(tracks.rate))
    ]
    return np.unique(np.concatenate([np.zeros(1), *of_tracks]))


def _frequency(tracks: Tracks, track: int, piece: Integers) -> Array:
    return np.where(
        tracks.kind[piece] == 1, np.abs(tracks.coefficients[piece, 2] * tracks.rate[track]), 0.0
    )


def jumps(tracks: Tracks, signals: int) -> tuple[int, ...]:
    """Return which signals of tracks jump at an edge between polynomials by more than rounding."""
    jumping = set()
    for track in range(len(tracks.rate)):
        first, last = tracks.first[track], tracks.first[track + 1] - 1
        inner = np.arange(first, last)
        inner = inner[(tracks.kind[inner] == 0) & (tracks.kind[inner + 1] == 0)]
        at = tracks.stop[inner]
        old, new = (_signals(tracks, track, inner + j, at, signals) for j in (0, 1))
        size = 1e-12 * np.max(np.abs(np.vstack([old, new, np.zeros((1, signals))])), axis=0)
        jumping |= {
            track * signals + int(j)
            for j in np.flatnonzero(np.any(np.abs(new - old) > size, axis=0))
        }
    return tuple(sorted(jumping))


def _signals(tracks: Tracks, track: int, piece: Integers, times: Array, signals: int) -> Array:
    """Evaluate values and derivatives of some pieces at some times."""
    rate, c = tracks.rate[track], tracks.coefficients[piece].T
    s = rate * (times - tracks.start[piece])
    values = np.array(
        [
            c[0] + s * (c[1] + s * (c[2] + s * c[3])),
            rate * (c[1] + s * (2.0 * c[2] + 3.0 * s * c[3])),
            rate**2 * (2.0 * c[2] + 6.0 * s * c[3]),
            6.0 * rate**3 * c[3],
        ]
    )
    bent = tracks.kind[piece] == 1
    if bent.any():
        c, s, w = c[:, bent], s[bent], rate * c[2, bent]
        sine, cosine = np.sin(c[2] * s + c[3]), np.cos(c[2] * s + c[3])
        values[:, bent] = (
            c[0] + c[1] * sine,
            c[1] * w * cosine,
            -c[1] * w**2 * sine,
            -c[1] * w**3 * cosine,
        )
    return values[:signals].T


class Code(NamedTuple):
    """Addresses of the functions of a step, their sizes, and parameters of the switching functions."""

    address: tuple[int, ...]
    sizes: Sizes
    numbers: tuple[int, ...]


def code(
    identity: str, sizes: Sizes, functions: Callable[[], tuple[ca.Function, ca.Function]]
) -> Code:
    """Return native code of steps for a model; ``identity`` covers everything that its ``functions`` depend on.

    The functions are the switching functions and the rates, of (states, inputs, extended parameters, modes).
    """

    def make() -> Code:
        native, notes = code_from_cache(
            f"lanes {sizes} {identity}", lambda: _source(sizes, *functions())
        )
        numbers = tuple(json.loads(notes))
        return Code(
            tuple(native.address[name] for name in sizes.names),
            replace(sizes, numbers=len(numbers)),
            numbers,
        )

    return _codes.of((identity, sizes), make)


_codes: Recent[Code] = Recent()


def _source(sizes: Sizes, switch: ca.Function, rate: ca.Function) -> Source:
    import casadi as ca

    x, u, p, m = (ca.SX.sym(name, switch.size1_in(i)) for i, name in enumerate("xupm"))
    last, order = ca.SX.sym("last", sizes.tracks), sizes.inputs // max(sizes.tracks, 1)
    rates = [u[i + 1] if (i + 1) % order else last[i // order] for i in range(sizes.inputs)]
    at = switch(x, u, p, m)
    along = ca.jtimes(at, x, rate(x, u, p, m)) + ca.jtimes(at, u, ca.vertcat(*rates))
    watch = ca.Function("watch", [x, u, last, p, m], [ca.densify(ca.vertcat(at, along))])
    expression = ca.vertcat(at, along)
    numbers = tuple(i for i in range(p.shape[0]) if ca.depends_on(expression, p[i]))
    return Source(
        {}, Steps(replace(sizes, numbers=len(numbers)), watch, numbers), json.dumps(numbers)
    )


def room(sizes: Sizes, run: Run, values: int, outputs: int) -> Room:
    """Allocate the arrays for blocks of variants, given the numbers of extended parameters and outputs of the model.

    The propagators of ``run`` determine the sizes of those of a variant.
    """
    n, wide, all_modes = sizes.states, sizes.lanes, sizes.lanes * sizes.modes
    _, rows, width = run.props.matrix.shape
    return Room(
        np.zeros((sizes.memory, wide)),
        np.zeros((sizes.memory, wide)),
        np.zeros((sizes.places[-1], wide)),
        np.zeros((wide, values)),
        np.zeros((wide, sizes.switches)),
        np.zeros((wide, n)),
        np.zeros((all_modes, rows, width)),
        np.zeros((all_modes, sizes.switches)),
        np.zeros((wide, sizes.modes)),
        np.zeros((wide, sizes.modes), dtype=np.int64),
        np.zeros((all_modes, *run.props.kick.shape[1:])),
        np.zeros((all_modes, *run.props.kick.shape[1:])),
        np.zeros((wide, 2), dtype=np.int64),
        np.zeros((all_modes, sizes.places[-1])),
        np.zeros(all_modes, dtype=np.int64),
        np.zeros(wide, dtype=np.int64),
        np.zeros((2, sizes.memory)),
        np.zeros(sizes.tracks, dtype=np.int64),
        np.zeros((n, n + 1)),
        np.zeros((sizes.outputs, n + sizes.inputs)),
        np.zeros((n, 1)),
        np.zeros((sizes.inputs, 1)),
        np.zeros((outputs, 1)),
    )


def follow(work: Work) -> None:
    """Propagate the variants of a span through the run; the loop does not hold the interpreter lock."""
    _follow(work)
