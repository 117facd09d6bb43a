"""Explicit steps: coefficients of the two pairs, their arithmetic, and native functions of whole steps.

Dormand-Prince 8(5,3) with its seventh-order dense output, and Dormand-Prince 5(4) with its fourth-order one for steps
that the input keeps much shorter than the tolerance requires. Coefficients: Hairer, Norsett, Wanner, "Solving
Ordinary Differential Equations I", 2nd ed. 1993, sections II.5, II.6 and II.10, and the authors' program DOP853
[hairer1993].

The native functions contain the arithmetic of the stages and the rates of the model without calls in between. All are
``void f(rows, u, p, m, g, double h)``: ``rows`` is the work matrix (see ``engine``); ``u`` holds the inputs at each
node of the step, one after another; ``g`` the switching functions at each probe, one after another, and last those of
``switch_at``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from llvmlite import ir

from jounce.core.types import Array
from jounce.kernel.engine import (
    DENSE,
    END,
    FIRST_PROBE,
    LAST_STAGE,
    PROBES,
    RATES,
    ROWS,
    STAGES,
    STATE,
    TRIAL,
)

if TYPE_CHECKING:
    import casadi as ca

    from jounce.kernel.lowering import Lowering


def _spread(weights: dict[int, float]) -> Array:
    """Return the weights of some stages, with zeros for the others."""
    row = np.zeros(STAGES)
    row[list(weights)] = list(weights.values())
    return row


# fmt: off
_A = {  # stage: the stages it is placed by
    1: {0: 0.05260015195876773},
    2: {0: 0.0197250569845379, 1: 0.0591751709536137},
    3: {0: 0.02958758547680685, 2: 0.08876275643042054},
    4: {0: 0.2413651341592667, 2: -0.8845494793282861, 3: 0.924834003261792},
    5: {0: 0.037037037037037035, 3: 0.17082860872947386, 4: 0.12546768756682242},
    6: {0: 0.037109375, 3: 0.17025221101954405, 4: 0.06021653898045596, 5: -0.017578125},
    7: {0: 0.03709200011850479, 3: 0.17038392571223998, 4: 0.10726203044637328, 5: -0.015319437748624402,
        6: 0.008273789163814023},
    8: {0: 0.6241109587160757, 3: -3.3608926294469414, 4: -0.868219346841726, 5: 27.59209969944671,
        6: 20.154067550477894, 7: -43.48988418106996},
    9: {0: 0.47766253643826434, 3: -2.4881146199716677, 4: -0.590290826836843, 5: 21.230051448181193,
        6: 15.279233632882423, 7: -33.28821096898486, 8: -0.020331201708508627},
    10: {0: -0.9371424300859873, 3: 5.186372428844064, 4: 1.0914373489967295, 5: -8.149787010746927,
        6: -18.52006565999696, 7: 22.739487099350505, 8: 2.4936055526796523, 9: -3.0467644718982196},
    11: {0: 2.273310147516538, 3: -10.53449546673725, 4: -2.0008720582248625, 5: -17.9589318631188,
        6: 27.94888452941996, 7: -2.8589982771350235, 8: -8.87285693353063, 9: 12.360567175794303,
        10: 0.6433927460157636},
    12: {0: 0.054293734116568765, 5: 4.450312892752409, 6: 1.8915178993145003, 7: -5.801203960010585,
        8: 0.3111643669578199, 9: -0.1521609496625161, 10: 0.20136540080403034, 11: 0.04471061572777259},
    13: {0: 0.056167502283047954, 6: 0.25350021021662483, 7: -0.2462390374708025, 8: -0.12419142326381637,
        9: 0.15329179827876568, 10: 0.00820105229563469, 11: 0.007567897660545699, 12: -0.008298},
    14: {0: 0.03183464816350214, 5: 0.028300909672366776, 6: 0.053541988307438566, 7: -0.05492374857139099,
        10: -0.00010834732869724932, 11: 0.0003825710908356584, 12: -0.00034046500868740456, 13: 0.1413124436746325},
    15: {0: -0.42889630158379194, 5: -4.697621415361164, 6: 7.683421196062599, 7: 4.06898981839711,
        8: 0.3567271874552811, 12: -0.0013990241651590145, 13: 2.9475147891527724, 14: -9.15095847217987},
}
C = np.array([0.0, 0.05260015195876773, 0.0789002279381516, 0.1183503419072274, 0.2816496580927726, 0.3333333333333333,
    0.25, 0.3076923076923077, 0.6512820512820513, 0.6, 0.8571428571428571, 1.0, 1.0, 0.1, 0.2, 0.7777777777777778])
_E3 = {0: -0.18980075407240762, 5: 4.450312892752409, 6: 1.8915178993145003, 7: -5.801203960010585,
    8: -0.4226823213237919, 9: -0.1521609496625161, 10: 0.20136540080403034, 11: 0.02265179219836082}
_E5 = {0: 0.01312004499419488, 5: -1.2251564463762044, 6: -0.4957589496572502, 7: 1.6643771824549864,
    8: -0.35032884874997366, 9: 0.3341791187130175, 10: 0.08192320648511571, 11: -0.022355307863886294}
_D = [  # the last four coefficients of the interpolant
    {0: -8.428938276109013, 5: 0.5667149535193777, 6: -3.0689499459498917, 7: 2.38466765651207, 8: 2.117034582445028,
        9: -0.871391583777973, 10: 2.2404374302607883, 11: 0.6315787787694688, 12: -0.08899033645133331,
        13: 18.148505520854727, 14: -9.194632392478356, 15: -4.436036387594894},
    {0: 10.427508642579134, 5: 242.28349177525817, 6: 165.20045171727028, 7: -374.5467547226902, 8: -22.113666853125306,
        9: 7.733432668472264, 10: -30.674084731089398, 11: -9.332130526430229, 12: 15.697238121770845,
        13: -31.139403219565178, 14: -9.35292435884448, 15: 35.81684148639408},
    {0: 19.985053242002433, 5: -387.0373087493518, 6: -189.17813819516758, 7: 527.8081592054236, 8: -11.57390253995963,
        9: 6.8812326946963, 10: -1.0006050966910838, 11: 0.7777137798053443, 12: -2.778205752353508,
        13: -60.19669523126412, 14: 84.32040550667716, 15: 11.99229113618279},
    {0: -25.69393346270375, 5: -154.18974869023643, 6: -231.5293791760455, 7: 357.6391179106141, 8: 93.40532418362432,
        9: -37.45832313645163, 10: 104.0996495089623, 11: 29.8402934266605, 12: -43.53345659001114,
        13: 96.32455395918828, 14: -39.17726167561544, 15: -149.72683625798564},
]
# fmt: on
A, E3, E5, D = (
    {i: _spread(row) for i, row in _A.items()},
    _spread(_E3),
    _spread(_E5),
    [_spread(row) for row in _D],
)

SHORT_FIRST = LAST_STAGE - 5
"""Row of the second stage of the pair of lower order: its seven stand in the rows of the first stage and of the last
six up to the end of the step, so that both pairs share all arrays."""


def _short(weights: Sequence[float]) -> Array:
    """Return the weights of the seven stages, each in its row."""
    rows = (0, *range(SHORT_FIRST, LAST_STAGE + 1))
    return _spread(dict(zip(rows, weights, strict=False)))


SHORT_A = {
    SHORT_FIRST + i: _short(weights)
    for i, weights in enumerate(
        (
            [1 / 5],
            [3 / 40, 9 / 40],
            [44 / 45, -56 / 15, 32 / 9],
            [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
            [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
            [35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
        )
    )
}
"""Weights of the rates before each stage, by its row; those of ``LAST_STAGE`` make the step."""
SHORT_C = _short([0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0, 1.0])
"""Fractions of a step at which the stages stand."""
SHORT_E = _short([71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40])
"""Error of fourth order."""
SHORT_D = _short(
    [
        -12715105075 / 11282082432,
        0.0,
        87487479700 / 32700410799,
        -10690763975 / 1880347072,
        701980252875 / 199316789632,
        -1453857185 / 822651844,
        69997945 / 29380423,
    ]
)
"""Last coefficient of the interpolant."""
NODES = np.concatenate([C, PROBES])
"""Fractions of a step at which the inputs are wanted: the stages, then the probes."""
SHORT_NODES = np.concatenate([SHORT_C, PROBES])
"""The same for the pair of lower order."""


@cache
def _element_functions() -> dict[str, ca.Function]:
    """Return the functions of one step for one state, whose rates at the 16 stages are ``k``.

    - ``stage<i>(x, k, h, -)``: where stage ``i`` evaluates the rates; ``stage12`` is the end of the step;
    - ``short<i>``: the same for the pair of lower order, whose stages are the first and the last six;
    - ``interpolant((x, end), k, h, -)``, ``short_interpolant``: the seven coefficients of the interpolant;
    - ``point(x, coefficients, theta, -)``: value at a fraction of the step.
    """
    import casadi as ca

    x, end, h, theta, none = (ca.SX.sym(name) for name in ("x", "end", "h", "theta", "none"))
    k, c = ca.SX.sym("k", STAGES), ca.SX.sym("c", 7)
    stages = {f"stage{i}": [x + h * _sum(A[i], k)] for i in range(1, STAGES)}
    stages |= {f"short{i}": [x + h * _sum(weights, k)] for i, weights in SHORT_A.items()}
    functions = {name: ca.Function(name, [x, k, h, none], value) for name, value in stages.items()}
    change = end - x
    first = [change, h * k[0] - change, 2.0 * change - h * (k[LAST_STAGE] + k[0])]
    for name, weights in (("interpolant", D), ("short_interpolant", [SHORT_D])):
        rows = [*first, *(h * _sum(part, k) for part in weights)]
        rows += [ca.SX.zeros(1)] * (7 - len(rows))
        functions[name] = ca.Function(
            name, [ca.vertcat(x, end), k, h, none], [ca.densify(ca.vertcat(*rows))]
        )
    y = c[6] * theta
    for j in range(5, 0, -1):
        y = (y + c[j]) * (theta if j % 2 == 0 else 1.0 - theta)
    functions["point"] = ca.Function("point", [x, c, theta, none], [x + (y + c[0]) * theta])
    return functions


@cache
def _error_function(*, short: bool = False) -> ca.Function:
    """Return the squared fifth- and third-order errors of one state, relative to the tolerance.

    For the pair of lower order, the fourth-order error, then zero. The inputs are the state's column of the work matrix
    (see ``engine``), none, (step, tolerance) and the widest motion so far.
    """
    import casadi as ca

    column, none, steering = ca.SX.sym("column", ROWS), ca.SX.sym("none"), ca.SX.sym("steering", 2)
    widest, rates = ca.SX.sym("widest"), column[RATES : RATES + STAGES]
    bound = steering[1] * widest + 1e-15 * ca.fabs(column[STATE])
    errors = [
        ca.sumsqr(_sum(weights, rates) / bound) for weights in ((SHORT_E,) if short else (E5, E3))
    ]
    errors += [ca.SX.zeros(1)] * short
    return ca.Function("error", [column, none, steering, widest], [ca.densify(ca.vertcat(*errors))])


def _sum(weights: Iterable[float], k: Any) -> ca.SX:
    """Return the weighted sum of the rates of the stages, without terms of zero weight."""
    import casadi as ca

    return sum(
        (float(weight) * k[j] for j, weight in enumerate(weights) if weight != 0.0), ca.SX(0.0)
    )


_DOUBLE, _INDEX = ir.DoubleType(), ir.IntType(64)
STEP_NAMES = ("step", "dense", "point_at", "probe", "switch_at", "error")
SHORT_NAMES = {"step": "short_step", "dense": "short_dense", "error": "short_error"}
"""What the pair of lower order has of its own."""


@dataclass(frozen=True)
class Step:
    """System of a step: the name of the rate function and the lengths of its arrays.

    ``size`` states are integrated, of which the first ``controlled`` determine the step size and the switches.
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
        """Append the functions of ``STEP_NAMES``; the module must already have the rate function and ``switch``.

        - ``step``: one step of length ``h`` from the state with known rate to the end row, and the rate there;
        - ``dense``: three more stages and the interpolant of that step;
        - ``point_at``: all states at the fraction ``h``, in the trial row;
        - ``short_step``, ``short_dense`` and ``short_error``: the same for the pair of lower order, without
          additional stages;
        - ``probe``: switching functions at all probes; ``switch_at``: at the fraction ``h``, the input at node 0.
        """
        for name, function in _element_functions().items():
            lowering.add_wide(name, function, self.size, inlined=True)
        lowering.add_wide(
            "probed", _element_functions()["point"], self.controlled, self.size, inlined=True
        )
        lowering.add_sum("error", _error_function(), self.size, self.controlled)
        driver = _Driver(lowering, self, "step")
        for i in range(1, LAST_STAGE + 1):
            driver.stage(i, END if i == LAST_STAGE else TRIAL)
        driver.finish()
        driver = _Driver(lowering, self, "dense")
        for i in range(LAST_STAGE + 1, STAGES):
            driver.stage(i, TRIAL)
        driver.over_states("interpolant", RATES, driver.scalar, DENSE)
        driver.finish()
        lowering.add_sum("short_error", _error_function(short=True), self.size, self.controlled)
        driver = _Driver(lowering, self, "short_step")
        for i in SHORT_A:
            driver.stage(i, END if i == LAST_STAGE else TRIAL, "short")
        driver.finish()
        driver = _Driver(lowering, self, "short_dense")
        driver.over_states("short_interpolant", RATES, driver.scalar, DENSE)
        driver.finish()
        driver = _Driver(lowering, self, "point_at")
        driver.over_states("point", DENSE, driver.scalar, TRIAL)
        driver.finish()
        driver = _Driver(lowering, self, "probe")
        for i, fraction in enumerate(PROBES):
            driver.switch(ir.Constant(_DOUBLE, fraction), FIRST_PROBE + i, i)
        driver.finish()
        driver = _Driver(lowering, self, "switch_at")
        driver.switch(driver.native.args[5], 0, len(PROBES))
        driver.finish()


class _Driver:
    """Builds one function as a sequence of calls."""

    def __init__(self, lowering: Lowering, step: Step, name: str) -> None:
        self._step, self._functions = step, lowering.module.globals
        self.native = lowering.declare(name, [_DOUBLE.as_pointer()] * 5 + [_DOUBLE])
        self._builder = ir.IRBuilder(self.native.append_basic_block())
        self.scalar = self._builder.alloca(_DOUBLE)
        self._builder.store(self.native.args[5], self.scalar)

    def over_states(self, name: str, inputs: int, scalar: ir.Value, out: int) -> None:
        """Run a function of one state over the states, from the rows ``inputs`` to the rows ``out``."""
        x, u, to = (self._row(i) for i in (STATE, inputs, out))
        self._call(name, [x, u, scalar, scalar, to])

    def stage(self, i: int, at: int, method: str = "stage") -> None:
        """Place stage ``i`` in row ``at`` and evaluate the rates there."""
        self.over_states(f"{method}{i}", RATES, self.scalar, at)
        _, u, p, m, *_ = self.native.args
        self._call(
            self._step.rate,
            [self._row(at), self._offset(u, i * self._step.inputs), p, m, self._row(RATES + i)],
        )

    def switch(self, fraction: ir.Value, node: int, place: int) -> None:
        """Evaluate the switching functions at a fraction of the step, with the input of a node."""
        if self._step.switches == 0:
            return
        _, u, p, m, g, _ = self.native.args
        self._builder.store(fraction, self.scalar)
        self.over_states("probed", DENSE, self.scalar, TRIAL)
        inputs, to = (
            self._offset(u, node * self._step.inputs),
            self._offset(g, place * self._step.switches),
        )
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
