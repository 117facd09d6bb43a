"""Implicit steps: coefficients of Rodas5P and native functions of its stages, without loops.

Rosenbrock method of order 5 with an embedded one of order 4 and a dense output of order 4. L-stable and stiffly
accurate, and designed to retain its order on stiff problems with moving equilibria. Coefficients of the form without
matrix products, for ``W = I / (GAMMA h) - J``:

``W k_i = f(t + C_i h, x + sum_j A_ij k_j) + sum_j B_ij k_j / h + D_i h df/dt``.

The last three stages accumulate: stage 6 starts at ``x + sum_j A_6j k_j``, each of the next two at the end of the
previous one, and the end of the last one is the end of the step; its ``k`` is the error estimate.

G. Steinebach: Construction of Rosenbrock-Wanner method Rodas5P and numerical benchmarks within the Julia Differential
Equations package. BIT Numerical Mathematics 63:27, 2023 [steinebach2023].

The native functions are ``void f(rows, k, slopes, factors, right, double h)``. ``rows`` is the work matrix (see
``engine``); ``k`` holds the stages and last the drift of the rates; ``right`` the shift and then room for a right-hand
side.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from llvmlite import ir

from jounce.kernel.engine import DENSE, END, RATES, STATE, TRIAL

if TYPE_CHECKING:
    import casadi as ca

    from jounce.kernel.lowering import Lowering

# fmt: off
STAGES = 8
GAMMA = 0.21193756319429014
C = np.array([0.0, 0.6358126895828704, 0.4095798393397535, 0.9769306725060716, 0.4288403609558664, 1.0, 1.0, 1.0])
D = np.array([0.21193756319429014, -0.42387512638858027, -0.3384627126235924, 1.8046452872882734, 2.325825639765069,
    0.0, 0.0, 0.0])
_LAST = [-7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256, 0.030198172008377946]
A = np.zeros((STAGES + 1, STAGES))
"""Row ``i``: where stage ``i`` is placed; the last row: where the step ends."""
A[1, :1] = [3.0]
A[2, :2] = [2.849394379747939, 0.45842242204463923]
A[3, :3] = [-6.954028509809101, 2.489845061869568, -10.358996098473584]
A[4, :4] = [2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641]
A[5, :5] = _LAST
A[6, :6] = [*_LAST, 1.0]
A[7, :7] = [*_LAST, 1.0, 1.0]
A[8, :8] = [*_LAST, 1.0, 1.0, 1.0]
B = np.zeros((STAGES, STAGES))
B[1, :1] = [-14.155112264123755]
B[2, :2] = [-17.97296035885952, -2.859693295451294]
B[3, :3] = [147.12150275711716, -1.41221402718213, 71.68940251302358]
B[4, :4] = [165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306]
B[5, :5] = [24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125, -0.6610691825249471]
B[6, :6] = [30.91273214028599, -3.1208243349937974, 77.79954646070892, 34.28646028294783, -19.097331116725623,
    -28.087943162872662]
B[7, :7] = [37.80277123390563, -3.2571969029072276, 112.26918849496327, 66.9347231244047, -40.06618937091002,
    -54.66780262877968, -9.48861652309627]
H = np.array([
    [25.948786856663858, -2.5579724845846235, 10.433815404888879, -2.3679251022685204, 0.524948541321073,
     1.1241088310450404, 0.4272876194431874, -0.17202221070155493],
    [-9.91568850695171, -0.9689944594115154, 3.0438037242978453, -24.495224566215796, 20.176138334709044,
     15.98066361424651, -6.789040303419874, -6.710236069923372],
    [11.419903575922262, 2.8879645146136994, 72.92137995996029, 80.12511834622643, -52.072871366152654,
     -59.78993625266729, -0.15582684282751913, 4.883087185713722],
])
"""Interpolant: ``x + theta (end - x + (1 - theta) (h_0 + theta (h_1 + theta h_2)))`` with ``h_r = sum_j H_rj k_j``."""
# fmt: on

_DOUBLE, _INDEX = ir.DoubleType(), ir.IntType(64)
STAGE_RATE = RATES + 1
"""Row of the rates at a stage; those at the state stay in ``RATES``."""


@dataclass(frozen=True)
class RosenbrockStep:
    """Step of ``size`` states; the module must already have the function ``solve``."""

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
            lowering.add_wide(name, function, self.size, inlined=True)
        for i in range(STAGES):
            self._stage(lowering, i)
        native, builder, h = self._start(lowering, "interpolant")
        rows, k = native.args[:2]
        out = self._row(builder, rows, DENSE)
        self._over_states(
            lowering, builder, "interpolant of one", [self._row(builder, rows, STATE), k, h, h, out]
        )
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
        self._over_states(
            lowering, builder, f"place {i + 1}", [self._row(builder, rows, STATE), k, h, h, to]
        )
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

    def _over_states(
        self, lowering: Lowering, builder: ir.IRBuilder, name: str, pointers: list[ir.Value]
    ) -> None:
        builder.call(lowering.module.globals[name], pointers)


def _element_functions() -> dict[str, ca.Function]:
    """Functions of one state: its place or rate, its stages ``k`` (last the drift) and the step ``h``."""
    import casadi as ca

    x, end, h, none = (ca.SX.sym(name) for name in ("x", "end", "h", "none"))
    k = ca.SX.sym("k", STAGES + 1)

    def weighted_sum(weights: Iterable[float]) -> ca.SX:
        return sum(
            (float(weight) * k[j] for j, weight in enumerate(weights) if weight != 0.0), ca.SX(0.0)
        )

    expressions = {
        f"right {i}": [x + D[i] * h * k[STAGES] + weighted_sum(B[i]) / h] for i in range(STAGES)
    }
    expressions |= {f"place {i}": [x + weighted_sum(A[i])] for i in range(1, STAGES + 1)}
    functions = {
        name: ca.Function("f", [x, k, h, none], value) for name, value in expressions.items()
    }
    first, second, third = (weighted_sum(H[i]) for i in range(3))
    rows = ca.vertcat(end - x, first, second + third, -third)
    functions["interpolant of one"] = ca.Function("f", [ca.vertcat(x, end), k, h, none], [rows])
    return functions
