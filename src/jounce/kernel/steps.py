"""Native functions of a whole Runge-Kutta step: the stages' arithmetic and the model's rates with no calls between.

All are ``void f(rows, u, p, m, g, double h)``. ``rows`` is the work matrix (see ``layout``); ``u`` holds the inputs at
each node of the step, one after another; ``g`` the switching functions at each probe, one after another, and last those
of ``switch_at``.
"""

from __future__ import annotations

from dataclasses import dataclass

from llvmlite import ir

from jounce.kernel import dopri5
from jounce.kernel.dop853 import DENSE_STAGES
from jounce.kernel.layout import DENSE, END, FIRST_PROBE, LAST_STAGE, PROBES, RATES, STATE, TRIAL
from jounce.kernel.lowering import Lowering
from jounce.kernel.stages import element_functions, error_function

_DOUBLE, _INDEX = ir.DoubleType(), ir.IntType(64)
STEP_NAMES = ("step", "dense", "point_at", "probe", "switch_at", "error")
SHORT_NAMES = {"step": "short_step", "dense": "short_dense", "error": "short_error"}
"""What the pair of lower order has of its own."""


@dataclass(frozen=True)
class Step:
    """What a step integrates: the name of the rate function and the lengths of its arrays.

    ``size`` states are integrated, of which the first ``controlled`` steer the step size and feed the switches.
    """

    rate: str
    size: int
    controlled: int
    inputs: int
    switches: int

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the functions."""
        return (*STEP_NAMES, *SHORT_NAMES.values())

    def add(self, lowering: Lowering) -> None:
        """Append the functions."""
        add_step_functions(lowering, self)


def add_step_functions(lowering: Lowering, step: Step) -> None:
    """Append the functions of ``STEP_NAMES``; the module has the rate function and ``switch`` already.

    - ``step``: one step of length ``h`` from the state, its rate known, to the end row and the rate there;
    - ``dense``: three more stages and the interpolant of that step;
    - ``point_at``: all states at the fraction ``h``, in the trial row;
    - ``short_step``, ``short_dense`` and ``short_error``: the same by the pair of lower order, no more stages;
    - ``probe``: switching functions at all probes; ``switch_at``: at the fraction ``h``, the input at node 0.
    """
    for name, function in element_functions().items():
        lowering.add_many(name, function, internal=True)
    lowering.add("error", error_function(step.size, step.controlled))
    driver = _Driver(lowering, step, "step")
    for i in range(1, LAST_STAGE + 1):
        driver.stage(i, END if i == LAST_STAGE else TRIAL)
    driver.finish()
    driver = _Driver(lowering, step, "dense")
    for i in range(LAST_STAGE + 1, DENSE_STAGES):
        driver.stage(i, TRIAL)
    driver.over_states("interpolant", RATES, driver.scalar, DENSE, step.size)
    driver.finish()
    _add_short(lowering, step)
    driver = _Driver(lowering, step, "point_at")
    driver.over_states("point", DENSE, driver.scalar, TRIAL, step.size)
    driver.finish()
    driver = _Driver(lowering, step, "probe")
    for i, fraction in enumerate(PROBES):
        driver.switch(ir.Constant(_DOUBLE, fraction), FIRST_PROBE + i, i)
    driver.finish()
    driver = _Driver(lowering, step, "switch_at")
    driver.switch(driver.native.args[5], 0, len(PROBES))
    driver.finish()


def _add_short(lowering: Lowering, step: Step) -> None:
    """Append the functions of the pair of lower order."""
    lowering.add("short_error", error_function(step.size, step.controlled, short=True))
    driver = _Driver(lowering, step, "short_step")
    for i in dopri5.A:
        driver.stage(i, END if i == LAST_STAGE else TRIAL, "short")
    driver.finish()
    driver = _Driver(lowering, step, "short_dense")
    driver.over_states("short_interpolant", RATES, driver.scalar, DENSE, step.size)
    driver.finish()


class _Driver:
    """Builds one function as a sequence of calls."""

    def __init__(self, lowering: Lowering, step: Step, name: str) -> None:
        self._step, self._functions = step, lowering.module.globals
        self.native = lowering.declare(name, [_DOUBLE.as_pointer()] * 5 + [_DOUBLE])
        self._builder = ir.IRBuilder(self.native.append_basic_block())
        self.scalar = self._builder.alloca(_DOUBLE)
        self._builder.store(self.native.args[5], self.scalar)

    def over_states(self, name: str, inputs: int, scalar: ir.Value, out: int, count: int) -> None:
        """Run a function of one state over the first ``count`` states, from the rows ``inputs`` to the rows ``out``."""
        x, u, to = (self._row(i) for i in (STATE, inputs, out))
        self._call(name, [x, u, scalar, scalar, to, _INDEX(self._step.size), _INDEX(0), _INDEX(count)])

    def stage(self, i: int, at: int, method: str = "stage") -> None:
        """Place stage ``i`` in row ``at`` and evaluate the rates there."""
        self.over_states(f"{method}{i}", RATES, self.scalar, at, self._step.size)
        _, u, p, m, *_ = self.native.args
        self._call(self._step.rate, [self._row(at), self._offset(u, i * self._step.inputs), p, m, self._row(RATES + i)])

    def switch(self, fraction: ir.Value, node: int, place: int) -> None:
        """Evaluate the switching functions at a fraction of the step, with the input of a node."""
        if self._step.switches == 0:
            return
        _, u, p, m, g, _ = self.native.args
        self._builder.store(fraction, self.scalar)
        self.over_states("point", DENSE, self.scalar, TRIAL, self._step.controlled)
        inputs, to = self._offset(u, node * self._step.inputs), self._offset(g, place * self._step.switches)
        self._call("switch", [self._row(TRIAL), inputs, p, m, to])

    def finish(self) -> None:
        """End the function."""
        self._builder.ret_void()

    def _row(self, i: int) -> ir.Value:
        return self._offset(self.native.args[0], i * self._step.size)

    def _offset(self, pointer: ir.Value, elements: int) -> ir.Value:
        return self._builder.gep(pointer, [_INDEX(elements)])

    def _call(self, name: str, arguments: list[ir.Value]) -> None:
        self._builder.call(self._functions[name], arguments)
