"""Native functions of the stages of an implicit step: right-hand side, linear system, next place, no loop between.

All are ``void f(rows, k, slopes, factors, right, double h)``. ``rows`` is the work matrix (see ``layout``); ``k`` holds
the stages and last the drift of the rates; ``right`` the shift and then room for a right-hand side.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
from llvmlite import ir

from jounce.kernel.layout import DENSE, END, RATES, STATE, TRIAL
from jounce.kernel.lowering import Lowering
from jounce.kernel.rodas5p import STAGES, A, B, D, H

_DOUBLE, _INDEX = ir.DoubleType(), ir.IntType(64)
STAGE_RATE = RATES + 1
"""Row of the rates at a stage; those at the state stay in ``RATES``."""


@dataclass(frozen=True)
class RosenbrockStep:
    """A step of ``size`` states; the module has the function ``solve`` already."""

    size: int

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the functions: one for each stage, then the interpolant."""
        return (*(f"stage_{i}" for i in range(STAGES)), "interpolant")

    def add(self, lowering: Lowering) -> None:
        """Append the functions.

        - ``stage_<i>``: solves for stage ``i`` and puts into the trial row where the next one is, or into the end row
          where the step ends;
        - ``interpolant``: rows of the interpolant, in the nested form of the explicit method.
        """
        for name, function in _element_functions().items():
            lowering.add_many(name, function, internal=True)
        for i in range(STAGES):
            self._stage(lowering, i)
        native, builder, h = self._start(lowering, "interpolant")
        rows, k = native.args[:2]
        out = self._row(builder, rows, DENSE)
        self._over_states(lowering, builder, "interpolant of one", [self._row(builder, rows, STATE), k, h, h, out])
        builder.ret_void()

    def _stage(self, lowering: Lowering, i: int) -> None:
        native, builder, h = self._start(lowering, f"stage_{i}")
        rows, k, slopes, factors, right, _ = native.args
        side = builder.gep(right, [_INDEX(1)])
        rate = self._row(builder, rows, STAGE_RATE if i else RATES)
        self._over_states(lowering, builder, f"right {i}", [rate, k, h, h, side])
        solved = self._row(builder, k, i)
        builder.call(lowering.module.globals["solve"], [side, right, factors, slopes, solved])
        to = self._row(builder, rows, TRIAL if i + 1 < STAGES else END)
        self._over_states(lowering, builder, f"place {i + 1}", [self._row(builder, rows, STATE), k, h, h, to])
        builder.ret_void()

    @staticmethod
    def _start(lowering: Lowering, name: str) -> tuple[ir.Function, ir.IRBuilder, ir.Value]:
        native = lowering.declare(name, [_DOUBLE.as_pointer()] * 5 + [_DOUBLE])
        builder = ir.IRBuilder(native.append_basic_block())
        h = builder.alloca(_DOUBLE)
        builder.store(native.args[5], h)
        return native, builder, h

    def _row(self, builder: ir.IRBuilder, matrix: ir.Value, row: int) -> ir.Value:
        return builder.gep(matrix, [_INDEX(row * self.size)])

    def _over_states(self, lowering: Lowering, builder: ir.IRBuilder, name: str, pointers: list[ir.Value]) -> None:
        builder.call(lowering.module.globals[name], [*pointers, *map(_INDEX, (self.size, 0, self.size))])


def _element_functions() -> dict[str, ca.Function]:
    """Functions of one state: its place or rate, its stages ``k`` (last the drift) and the step ``h``."""
    x, end, h, none = (ca.SX.sym(name) for name in ("x", "end", "h", "none"))
    k = ca.SX.sym("k", STAGES + 1)

    def weighted(weights: object) -> ca.SX:
        return sum((float(weight) * k[j] for j, weight in enumerate(weights) if weight != 0.0), ca.SX(0.0))  # type: ignore[arg-type, var-annotated]

    found = {f"right {i}": [x + D[i] * h * k[STAGES] + weighted(B[i]) / h] for i in range(STAGES)}
    found |= {f"place {i}": [x + weighted(A[i])] for i in range(1, STAGES + 1)}
    functions = {name: ca.Function("f", [x, k, h, none], value) for name, value in found.items()}
    first, second, third = (weighted(H[i]) for i in range(3))
    rows = ca.vertcat(end - x, first, second + third, -third)
    functions["interpolant of one"] = ca.Function("f", [ca.vertcat(x, end), k, h, none], [rows])
    return functions
