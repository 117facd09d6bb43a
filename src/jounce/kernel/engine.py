"""Data of the loops of a run: addresses of native functions, inputs, samples, a controller, scratch arrays.

This module does not compute. The loops (``kernel.loops``) read these tuples and write into their arrays,
so consecutive runs need no new memory and compiled code sees no Python objects.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from enum import Enum
from typing import NamedTuple

import numpy as np

from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.kernel.arrays import Columns, Integers, Matrix, Vector


class Status(Enum):
    """How a run ended; ``help`` explains it to the user."""

    COMPLETED = (0, "the run reached its end")
    NOT_FINITE = (
        1,
        "the solution is no longer a finite number: the model is unstable or an input is extreme",
    )
    STEP_TOO_SMALL = (
        2,
        "the step fell below what time can resolve: the model is too stiff or jumps without a switch",
    )
    TOO_MANY_STEPS = (
        3,
        "the step budget is used up: shorten the run, loosen the tolerance or soften the stiffest part",
    )
    CHATTER = (
        4,
        "contact switches on and off without time passing: add tyre damping or soften the law",
    )
    LOOP_OPENED = (
        5,
        "the loops of the mechanism cannot be closed any more: it has reached the end of its travel",
    )
    LOCKED_UP = (
        6,
        "the mechanism is in a singular configuration: its joints do not determine how it moves on (lock-up or flip)",
    )
    FLIPPED = (
        7,
        "the suspension passed a singular configuration and the wheel flipped over: an obstacle is too high, "
        "stops are too soft",
    )
    DIVERGED = (
        8,
        "the closed loop diverges: smaller gains, a faster actuator or a higher control rate may hold it",
    )
    NO_COMMAND = (9, "the controller gave no finite command")
    RUN_AWAY = (
        10,
        "a strut deflects beyond 10 m or the body turns over: the model is unstable (see its modes) or loads extreme",
    )

    def __init__(self, code: int, text: str) -> None:
        self.code, self.help = code, text

    @classmethod
    def of(cls, code: int) -> Status:
        """Return the status for the return code of a loop."""
        return next(status for status in cls if status.code == code)


# Compiled loops take constants, not members of an enumeration.
COMPLETED, NOT_FINITE, STEP_TOO_SMALL = (
    Status.COMPLETED.code,
    Status.NOT_FINITE.code,
    Status.STEP_TOO_SMALL.code,
)
TOO_MANY_STEPS, CHATTER = Status.TOO_MANY_STEPS.code, Status.CHATTER.code
LOOP_OPENED, LOCKED_UP = Status.LOOP_OPENED.code, Status.LOCKED_UP.code
DIVERGED, NO_COMMAND = Status.DIVERGED.code, Status.NO_COMMAND.code

# Rows of the matrix that a step works in, one column a state. Native functions and loops share it, so its places are
# constants. It has room for the method with most stages; the others leave rows unused, and all put their interpolant
# into the same rows, so that samples and events need not know which method made it.
STAGES = 16
"""Rates that a step of the largest method evaluates, those of its interpolant included."""
LAST_STAGE = 12
"""The stage at the end of its step."""
STATE, END, TRIAL, RATES = 0, 1, 2, 3
"""The state, its value after the step, where a stage or a switch is evaluated, and the first of the stages' rates."""
DENSE = RATES + STAGES
"""First of the seven rows of the interpolant."""
ROWS = DENSE + 7
PROBES = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Fractions of a step at which the switching functions are checked; at 0 an edge of the input may have thrown one."""
FIRST_PROBE = STAGES
"""Nodes of a step, at which its inputs are wanted, are the stages and behind them the probes."""


class Tracks(NamedTuple):
    """Pieces of all tracks, one after another; piece ``i`` of the flat arrays is valid on ``[start, stop]``."""

    first: Integers
    start: Vector
    stop: Vector
    kind: Integers
    coefficients: Matrix
    rate: Vector


def flatten(signals: list[Segments]) -> Tracks:
    """Put the signals (against time) into the arrays that the loops read."""
    counts = [len(signal.kind) for signal in signals]
    return Tracks(
        first=np.concatenate([[0], np.cumsum(counts)]).astype(np.int64),
        start=np.concatenate([signal.edges[:-1] for signal in signals]),
        stop=np.concatenate([signal.edges[1:] for signal in signals]),
        kind=np.concatenate([signal.kind for signal in signals], dtype=np.int64),
        coefficients=np.ascontiguousarray(
            np.concatenate([signal.coefficients for signal in signals])
        ),
        rate=np.array([signal.rate for signal in signals]),
    )


class Engine(NamedTuple):
    """Addresses of native functions: of the model, then of a step (``methods.runge_kutta``); 0 where there is none.

    The stages of a step begin with row ``first``, those of its interpolant with ``after``; ``shrink`` is
    the exponent of the error in the choice of the next step size.
    """

    rate: int
    output: int
    switch_slope: int
    project: int
    project_many: int
    step: int
    dense: int
    point_at: int
    probe: int
    switch_at: int
    error: int
    first: int = 1
    after: int = LAST_STAGE + 1
    shrink: float = -0.125


class Control(NamedTuple):
    """Step control of a run.

    ``tolerance`` is relative to the size of each controlled state so far, at least ``scale``; ``dead_band`` is how far
    each switching function may lie on the wrong side of its mode; no step is longer than ``longest`` (s).
    """

    tolerance: float
    scale: Vector
    dead_band: Vector
    max_steps: int
    longest: float


class Problem(NamedTuple):
    """System to integrate: native functions, tracks, parameter values, modes (changed in place) and first state.

    ``inputs`` is the number of inputs of all tracks: two or three per track.
    """

    engine: Engine
    tracks: Tracks
    piece: Integers
    p: Vector
    m: Vector
    x0: Vector
    inputs: int


_NONE = np.zeros((0, 0))


class Samples(NamedTuple):
    """Sample times of a run and the arrays that it fills: one row per element, one column per sample.

    If the model projects, ``projected`` contains the results of the projection of each system (residual,
    conditioning) above its states; otherwise it is empty. With sensitivities,
    ``tangents`` has one row per sample for the states, and ``carried`` one for the outputs and their
    sensitivities; the parameter index varies fastest in both.
    """

    times: Vector
    states: Matrix
    inputs: Matrix
    outputs: Matrix
    projected: Matrix
    tangents: Matrix = _NONE
    carried: Matrix = _NONE


class Feedback(NamedTuple):
    """Controller around the model: it reads the outputs at fixed instants and sets some tracks until the next instant.

    The law is one native function ``f(memory, measured, p, m, out)``; ``out`` is the commands, then the next memory. It
    is compiled from a graph like all others, or it is the address of a Python function (:class:`Callback`).

    Attributes
    ----------
    law : int
        Address of the law; 0 where there is no controller.
    period : float
        Distance of the control instants, s.
    pieces : ndarray of int64
        Piece of each command's track: its only one, whose value is set.
    select : ndarray of int64
        Output behind each measurement.
    offset : ndarray
        Taken from each measurement.
    noise : ndarray, shape (instants, measurements)
        Added to each measurement; no rows: none.
    bound : ndarray
        How far each state may go from where the run started before it counts as diverging.
    p : ndarray
        Parameters of the law.
    memory : ndarray, shape (1, n)
        State of the law, from one instant to the next.
    measured : ndarray
        Measurements, then the time (s).
    result : ndarray, shape (1, commands + n)
        What the law gives.
    time, states, inputs, outputs : ndarray
        Where the model is evaluated: columns.
    instants : ndarray of int64, shape (1,)
        Instants so far.
    """

    law: int
    period: float
    pieces: Integers
    select: Integers
    offset: Vector
    noise: Matrix
    bound: Vector
    p: Vector
    memory: Matrix
    measured: Vector
    result: Matrix
    time: Vector
    states: Matrix
    inputs: Matrix
    outputs: Matrix
    instants: Integers


_ROW, _COLUMN, _FLAT, _NUMBERS = (
    np.zeros((1, 0)),
    np.zeros((0, 1)),
    np.zeros(0),
    np.zeros(0, dtype=np.int64),
)
NO_FEEDBACK = Feedback(
    0, 1.0, _NUMBERS, _NUMBERS, _FLAT, _NONE, _FLAT, _FLAT, _ROW, _FLAT, _ROW, _FLAT, _COLUMN, _COLUMN, _COLUMN,
    _NUMBERS,
)  # fmt: skip


def feedback(
    law: int,
    period: float,
    *,
    pieces: Integers,
    select: Integers,
    offset: Vector,
    noise: Matrix,
    bound: Vector,
    p: Vector,
    counts: tuple[int, int, int],
) -> Feedback:
    """Allocate a law's arrays for ``counts`` of memory, inputs and outputs; the others are fields of the class."""
    memory, inputs, outputs = counts
    scratch = (
        np.zeros((1, memory)),
        np.zeros(len(select) + 1),
        np.zeros((1, len(pieces) + memory)),
        np.zeros(1),
        np.zeros((len(bound), 1)),
        np.zeros((inputs, 1)),
        np.zeros((outputs, 1)),
        np.zeros(1, dtype=np.int64),
    )
    return Feedback(law, period, pieces, select, offset, noise, bound, p, *scratch)


_PROTOTYPE = ctypes.CFUNCTYPE(
    None
)  # what a law is given lies in arrays that it has; arguments would be made objects


class Callback:
    """A Python function at an address; its exceptions are stored, since none may pass through compiled code.

    The loop runs without the interpreter lock; the call acquires the lock while the function runs.
    ``address`` is that of ``void f(void*, void*, void*, void*, void*)``, which lives as long as this object; ``raised``
    is what the function raised, or None.

    Parameters
    ----------
    function, failed : callable
        What is called; what is called after it raised.
    """

    def __init__(self, function: Callable[[], None], failed: Callable[[], None]) -> None:
        self.raised: BaseException | None = None

        def call() -> None:
            try:
                function()
            except BaseException as error:  # noqa: BLE001 - also an interrupt must wait for the loop to end
                self.raised = error
                failed()

        self._call = _PROTOTYPE(call)
        self.address = int(ctypes.cast(self._call, ctypes.c_void_p).value or 0)


class Work(NamedTuple):
    """Scratch arrays: ``rows`` (see above), times and inputs at the nodes of a step, switching functions at its probes.

    ``step`` is (length, tolerance), ``errors`` the squared errors, ``slope`` that of the switching functions,
    ``sampled`` the inputs at a sample; ``marks`` the numbers of placed and of finished samples.
    """

    rows: Matrix
    times: Vector
    nodes: Vector
    u: Columns
    g: Matrix
    step: Vector
    errors: Matrix
    slope: Matrix
    widest: Vector
    projected: Matrix
    sampled: Matrix
    marks: Integers


def scratch(problem: Problem, control: Control, nodes: Array, systems: int = 1) -> Work:
    """Allocate the arrays for steps of several systems with given nodes (fractions of a step, the probes last)."""
    n, size, switches = len(control.scale), len(problem.x0), len(problem.m)
    extra_rows = 2 * systems
    rows = np.zeros((ROWS, size))
    rows[STATE] = problem.x0
    return Work(
        rows,
        np.zeros(len(nodes)),
        nodes,
        # one node's inputs lie side by side, as native code reads them. With fewer than two inputs NumPy would call the
        # same array C-ordered, which is another type: the loop would be compiled once more for it
        np.zeros((len(nodes), max(problem.inputs, 2))).T,
        np.zeros((len(PROBES) + 1, switches)),
        np.array([0.0, control.tolerance]),
        np.zeros((1, 2)),
        np.zeros((1, switches * (n + size // n))),
        control.scale.copy(),
        np.zeros((1, size + extra_rows)),
        np.zeros((problem.inputs, 1)),
        np.zeros(2, dtype=np.int64),
    )
