"""The arithmetic of a Runge-Kutta step as expression graphs of one state; native code runs them over all states."""

from __future__ import annotations

from functools import cache

import casadi as ca

from jounce.kernel import dopri5
from jounce.kernel.dop853 import DENSE_STAGES, E3, E5, STAGES, A, D
from jounce.kernel.layout import RATES, ROWS


@cache
def element_functions() -> dict[str, ca.Function]:
    """Functions of one step for one state, whose rates at the 16 stages are ``k``.

    - ``stage<i>(x, k, h, -)``: where stage ``i`` evaluates the rates; ``stage12`` is the end of the step;
    - ``short<i>``: the same for the pair of lower order, whose stages are the first and the last six;
    - ``interpolant((x, end), k, h, -)``, ``short_interpolant``: the seven coefficients of the interpolant;
    - ``point(x, coefficients, theta, -)``: value at a fraction of the step.
    """
    x, end, h, theta, none = (ca.SX.sym(name) for name in ("x", "end", "h", "theta", "none"))
    k, c = ca.SX.sym("k", DENSE_STAGES), ca.SX.sym("c", 7)
    stages = {f"stage{i}": [x + h * _sum(A[i], k)] for i in range(1, DENSE_STAGES)}
    stages |= {f"short{i}": [x + h * _sum(weights, k)] for i, weights in dopri5.A.items()}
    functions = {name: ca.Function(name, [x, k, h, none], value) for name, value in stages.items()}
    change = end - x
    first = [change, h * k[0] - change, 2.0 * change - h * (k[STAGES] + k[0])]
    for name, weights in (("interpolant", D), ("short_interpolant", [dopri5.D])):
        rows = [*first, *(h * _sum(part, k) for part in weights)]
        rows += [ca.SX.zeros(1)] * (7 - len(rows))
        functions[name] = ca.Function(name, [ca.vertcat(x, end), k, h, none], [ca.densify(ca.vertcat(*rows))])
    y = c[6] * theta
    for j in range(5, 0, -1):
        y = (y + c[j]) * (theta if j % 2 == 0 else 1.0 - theta)
    functions["point"] = ca.Function("point", [x, c, theta, none], [x + (y + c[0]) * theta])
    return functions


def error_function(size: int, controlled: int, *, short: bool = False) -> ca.Function:
    """Squared fifth- and third-order errors of the first ``controlled`` states, relative to what is allowed.

    Of the pair of lower order the fourth-order one, then zero. The inputs are the work matrix (see ``layout``), none,
    (step, tolerance) and the widest motion so far.
    """
    rows, none = ca.SX.sym("rows", size, ROWS), ca.SX.sym("none")
    h, tolerance, widest = ca.SX.sym("h"), ca.SX.sym("tolerance"), ca.SX.sym("widest", controlled)
    bound = tolerance * widest + 1e-15 * ca.fabs(rows[:controlled, 0])
    rates = [rows[:controlled, RATES + j] for j in range(DENSE_STAGES)]
    errors = [ca.sumsqr(_sum(weights, rates) / bound) for weights in ((dopri5.E,) if short else (E5, E3))]
    errors += [ca.SX.zeros(1)] * short
    return ca.Function(
        "error", [ca.vec(rows), none, ca.vertcat(h, tolerance), widest], [ca.densify(ca.vertcat(*errors))]
    )


def _sum(weights: object, k: object) -> ca.SX:
    """Weighted sum of the stages' rates; zero weights cost nothing."""
    total = ca.SX(0.0)
    for j, weight in enumerate(weights):  # type: ignore[arg-type, var-annotated]
        if weight != 0.0:
            total += float(weight) * k[j]  # type: ignore[index]
    return total
