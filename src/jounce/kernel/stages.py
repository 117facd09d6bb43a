"""The arithmetic of a Runge-Kutta step as expression graphs, so that it becomes straight native code like the model.

All functions have the kernel's four inputs and one output. ``k`` holds the rates of the 16 stages, one after another.
"""

from __future__ import annotations

import casadi as ca

from jounce.kernel.dop853 import DENSE_STAGES, STAGES, A, D, E3, E5

STAGE_NAMES = tuple(f"stage{i}" for i in range(DENSE_STAGES))


def step_functions(size: int, controlled: int) -> dict[str, ca.Function]:
    """Functions of one step for ``size`` states, of which the first ``controlled`` steer the step size.

    - ``stage<i>(x, k, h, -)``: where stage ``i`` evaluates the rates; ``stage12`` is the end of the step;
    - ``dense(x, k, h, end)``: the seven rows of the interpolant;
    - ``error(x, k, (h, tolerance), widest)``: squared fifth- and third-order errors relative to what is allowed.
    """
    x, end = ca.SX.sym("x", size), ca.SX.sym("end", size)
    k, h, tolerance = ca.SX.sym("k", size, DENSE_STAGES), ca.SX.sym("h"), ca.SX.sym("tolerance")
    none = ca.SX.sym("none", 0)
    rates = ca.vec(k)
    functions = {
        name: ca.Function(name, [x, rates, h, none], [x + h * _sum(A[i], k)]) for i, name in enumerate(STAGE_NAMES)
    }
    change = end - x
    rows = [
        change,
        h * k[:, 0] - change,
        2.0 * change - h * (k[:, STAGES] + k[:, 0]),
        *(h * _sum(D[i], k) for i in range(4)),
    ]
    functions["dense"] = ca.Function("dense", [x, rates, h, end], [ca.vertcat(*rows)])
    widest = ca.SX.sym("widest", controlled)
    bound = tolerance * widest + 1e-15 * ca.fabs(x[:controlled])
    errors = [ca.sumsqr(_sum(weights, k)[:controlled] / bound) for weights in (E5, E3)]
    functions["error"] = ca.Function("error", [x, rates, ca.vertcat(h, tolerance), widest], [ca.vertcat(*errors)])
    return functions


def _sum(weights: object, k: ca.SX) -> ca.SX:
    """Weighted sum of the stages' rates; zero weights cost nothing."""
    total = ca.SX.zeros(k.shape[0], 1)
    for j, weight in enumerate(weights):  # type: ignore[arg-type, var-annotated]
        if weight != 0.0:
            total += float(weight) * k[:, j]
    return total
