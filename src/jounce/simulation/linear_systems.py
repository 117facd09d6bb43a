"""Linear systems of the implicit method, ``(s - df/dx) d = r`` with a shift ``s``, as expression graphs.

The rates depend on the accelerations, which solve the equations of motion. The slopes of the rates are never formed:
the changes of the accelerations are unknowns in addition to those of the states, and their sparse system is eliminated
in the order coordinates, internal states, speeds, multipliers. It needs no pivoting: for the coordinates the matrix is
the shift plus at most an antisymmetric part, for the speeds ``s M + C + K / s``, for the multipliers ``G (..)^-1 G^T``.
A pivot may vanish only if the shift is as small as the rate of an unstable motion; the soundness of the pivots is
reported.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass

import casadi as ca
import numpy as np

from jounce.core.remembered import once_per_object
from jounce.kernel.methods.implicit import Slopes
from jounce.kernel.methods.rosenbrock import RosenbrockStep
from jounce.kernel.native import Native, Source, code_from_cache, compile_functions
from jounce.mechanics import Model
from jounce.simulation.compiled import Compiled

_FUNCTIONS = ("look", "along_input", "factor", "interpolant")


def slopes_of(compiled: Compiled) -> Slopes:
    """Return native functions for the linear systems of a model, kept as long as the model and cached on disk."""
    return _slopes_of(compiled.plain)[0]


@once_per_object
def _slopes_of(plain: Compiled) -> tuple[Slopes, Native]:
    if plain.identity:
        native, notes = code_from_cache(f"implicit {plain.identity}", lambda: _source(plain.model))
    else:
        source = _source(plain.model)
        native, notes = compile_functions(source.functions, source.step), source.notes
    look, along_input, factor, interpolant = (native.address[name] for name in _FUNCTIONS)
    stages = np.array(
        [address for name, address in native.address.items() if name.startswith("stage_")]
    )
    size, room = json.loads(notes)
    return Slopes(look, along_input, factor, stages, interpolant, size, room), native


def _source(model: Model) -> Source:
    functions = linear_functions(model)
    step = RosenbrockStep(model.x.shape[0])
    return Source(
        functions,
        step,
        notes=json.dumps([functions[name].size1_out(0) for name in ("look", "factor")]),
    )


def linear_functions(model: Model) -> dict[str, ca.Function]:
    """Return graphs of the functions that evaluate slopes, factorise and solve.

    Returns
    -------
    dict
        - ``look(x, u, p, m)``: non-zero elements of the slopes of the balance and of the rates, then the rates;
        - ``along_input(x, u, p, m)``: slopes of the rates by the inputs, column by column;
        - ``factor(slopes, shift, -, -)``: soundness of the pivots (1 is best, 0 useless), then the factors;
        - ``solve(r, -, factors, slopes)``: the solution, with ``factors`` from ``factor``.
    """
    slopes, values = _slopes(model)
    known = [model.x, model.u, model.p, model.m]
    looked, flat = _elements(values), _elements(slopes.all)
    none, shift, r = ca.SX.sym("none", 0), ca.SX.sym("shift"), ca.SX.sym("r", model.x.shape[0])
    factors = Factors(slopes.matrix(shift))
    symbols = ca.SX.sym("factors", factors.values.shape[0] + 1)
    solved = slopes.in_state_order(factors.solve(symbols[1:], slopes.right_side(r)))
    factor = ca.vertcat(factors.soundness, factors.values)
    return {
        "look": ca.Function(
            "look",
            known,
            [ca.cse(ca.densify(_eliminate(model, ca.vertcat(looked, model.balance.rate))))],
        ),
        "along_input": ca.Function("along_input", known, [ca.cse(ca.densify(_along_input(model)))]),
        "factor": ca.Function("factor", [flat, shift, none, none], [ca.cse(ca.densify(factor))]),
        "solve": ca.Function("solve", [r, none, symbols, flat], [ca.cse(ca.densify(solved))]),
    }


def _elements(matrices: Iterable[ca.SX]) -> ca.SX:
    """Concatenate the non-zero elements of matrices."""
    return ca.vertcat(*(ca.vec(matrix.nz[:]) for matrix in matrices))


def _eliminate(model: Model, expression: ca.SX) -> ca.SX:
    return ca.substitute(expression, model.balance.unknown, model.balance.found)


def _along_input(model: Model) -> ca.SX:
    """Return slopes of the rates by the inputs, using the factors that solve for the accelerations."""
    balance = model.balance
    changed = ca.jacobian(balance.residual, model.u)
    columns = [balance.answer(changed[:, i]) for i in range(changed.shape[1])]
    answered = ca.horzcat(*columns) if columns else ca.SX(balance.unknown.shape[0], 0)
    direct = ca.jacobian(balance.rate, model.u)
    return _eliminate(model, direct + ca.jacobian(balance.rate, balance.unknown) @ answered)


def _slopes(model: Model) -> tuple[_Slopes, list[ca.SX]]:
    """Return symbols of the non-zero slopes, and their values in terms of the unknowns."""
    balance, (n_q, n_v) = model.balance, (len(model.coordinates), len(model.speeds))
    rows = balance.residual.shape[0]
    unknown = balance.unknown[:rows]  # multipliers of dropped rows have no effect
    others = ca.vertcat(balance.rate[:n_q], balance.rate[n_q + n_v :])
    values = [
        ca.jacobian(balance.residual, model.x),
        ca.jacobian(balance.residual, unknown),
        ca.jacobian(others, model.x),
        ca.jacobian(others, unknown),
    ]
    symbols = [ca.SX.sym(f"slope{i}", value.sparsity()) for i, value in enumerate(values)]
    return _Slopes(n_q, n_v, *symbols), values


@dataclass(frozen=True)
class _Slopes:
    """Slopes of the balance and of the other rates (coordinates, internal states) by states and unknowns.

    The order of elimination is: coordinates, internal states, speeds (from the tree's ends to its root), multipliers.
    """

    coordinates: int
    speeds: int
    balance_state: ca.SX
    balance_unknown: ca.SX
    rate_state: ca.SX
    rate_unknown: ca.SX

    @property
    def all(self) -> tuple[ca.SX, ...]:
        """All matrices, in the order of their values."""
        return self.balance_state, self.balance_unknown, self.rate_state, self.rate_unknown

    @property
    def _order(self) -> list[int]:
        """Return the indices of the states in the order of elimination."""
        n_q, n_v, size = self.coordinates, self.speeds, self.rate_state.shape[1]
        return [*range(n_q), *range(n_q + n_v, size), *reversed(range(n_q, n_q + n_v))]

    def matrix(self, shift: ca.SX) -> ca.SX:
        """Return the matrix of (states, multipliers) in the order of elimination; speeds replace accelerations."""
        n_q, n_v, others = self.coordinates, self.speeds, self.rate_state.shape[0]
        upper = -self._with_accelerations(self.rate_state, self.rate_unknown, shift)
        for i in range(others):
            upper[i, i if i < n_q else i + n_v] += shift
        lower = self._with_accelerations(self.balance_state, self.balance_unknown, shift)
        upper = ca.horzcat(upper, -self.rate_unknown[:, n_v:])
        forces = ca.horzcat(-lower[:n_v, :], -self.balance_unknown[:n_v, n_v:])
        loops = ca.horzcat(lower[n_v:, :], self.balance_unknown[n_v:, n_v:])
        columns = [*self._order, *range(lower.shape[1], upper.shape[1])]
        return ca.vertcat(upper[:, columns], forces[::-1, columns], loops[:, columns])

    def _with_accelerations(self, by_state: ca.SX, by_unknown: ca.SX, shift: ca.SX) -> ca.SX:
        """Return slopes by the states if the accelerations change by ``shift`` times the speeds."""
        n_q, n_v = self.coordinates, self.speeds
        speeds = by_state[:, n_q : n_q + n_v] + shift * by_unknown[:, :n_v]
        return ca.horzcat(by_state[:, :n_q], speeds, by_state[:, n_q + n_v :])

    def right_side(self, r: ca.SX) -> ca.SX:
        """Return the right-hand side in the order of elimination."""
        n_q, n_v = self.coordinates, self.speeds
        speeds = r[n_q : n_q + n_v]
        upper = ca.vertcat(r[:n_q], r[n_q + n_v :]) - self.rate_unknown[:, :n_v] @ speeds
        forces = self.balance_unknown[:, :n_v] @ speeds
        return ca.vertcat(upper, (-forces[:n_v])[::-1], forces[n_v:])

    def in_state_order(self, solution: ca.SX) -> ca.SX:
        """Reorder a solution from the order of elimination to that of the states."""
        order = self._order
        return ca.vertcat(*(solution[order.index(i)] for i in range(len(order))))


class Factors:
    """Unrolled factorisation ``L U`` of a sparse matrix without pivoting; exploits structural zeros."""

    def __init__(self, matrix: ca.SX) -> None:
        size = matrix.shape[0]
        self._diagonal = [matrix[i, i] for i in range(size)]
        rows = [
            {j: matrix[i, j] for j in range(size) if matrix.sparsity().has_nz(i, j)}
            for i in range(size)
        ]
        self._lower: list[dict[int, ca.SX]] = [{} for _ in range(size)]
        self._pivots: list[ca.SX] = []
        self._inverses: list[ca.SX] = []
        for k in range(size):
            pivot = rows[k].pop(k)
            self._pivots.append(pivot)
            self._inverses.append(1.0 / pivot)
            for i in range(k + 1, size):
                if k in rows[i]:
                    share = rows[i].pop(k) * self._inverses[k]
                    self._lower[i][k] = share
                    for j, value in rows[k].items():
                        rows[i][j] = rows[i].get(j, 0.0) - share * value
        self._upper = rows

    @property
    def values(self) -> ca.SX:
        """All inputs of ``solve``, as a flat vector."""
        parts = (
            *(ca.vertcat(*row.values()) for row in (*self._lower, *self._upper)),
            *self._inverses,
        )
        return ca.vertcat(*parts)

    @property
    def soundness(self) -> ca.SX:
        """Minimum ratio of a pivot to its original diagonal element, for non-zero elements."""
        worst = ca.SX(1.0)
        for pivot, diagonal in zip(self._pivots, self._diagonal, strict=True):
            if diagonal.nnz():
                worst = ca.fmin(worst, ca.fabs(pivot / diagonal))
        return worst

    def solve(self, values: ca.SX, right: ca.SX) -> ca.SX:
        """Return the solution for a right-hand side, with the ``values`` of the factors as symbols."""
        size, place = len(self._inverses), iter(range(values.shape[0]))
        lower = [{k: values[next(place)] for k in row} for row in self._lower]
        upper = [{k: values[next(place)] for k in row} for row in self._upper]
        inverses = [values[next(place)] for _ in range(size)]
        x = [right[i] for i in range(size)]
        for i in range(size):
            for k, share in lower[i].items():
                x[i] -= share * x[k]
        for i in reversed(range(size)):
            for j, value in upper[i].items():
                x[i] -= value * x[j]
            x[i] *= inverses[i]
        return ca.vertcat(*x)
