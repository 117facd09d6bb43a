"""A finished symbolic model, from which every engine, linearisation and gradient is derived."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace

import casadi as ca

from jounce.core.turns import once
from jounce.mechanics.facts import Equation, ModelFacts, Output

_KINKED = {
    getattr(ca, f"OP_{name}")
    for name in (
        "SIGN",
        "FABS",
        "FLOOR",
        "CEIL",
        "FMIN",
        "FMAX",
        "IF_ELSE_ZERO",
        "LT",
        "LE",
        "EQ",
        "NE",
        "COPYSIGN",
        "FMOD",
    )
}  # operations whose derivative hides the dependence
Alike = tuple[tuple[tuple[str, ...], ...], tuple[tuple[int, ...], ...]]
"""Name prefixes of each part, then those of its assembly; and groups of parts that are computed side by side."""


@dataclass(frozen=True)
class Balance:
    """Rates and outputs as functions of unknowns, for derivatives that need not differentiate the solver.

    Attributes
    ----------
    unknown : casadi.SX
        Symbols of accelerations and multipliers.
    found : casadi.SX
        Their solution.
    residual : casadi.SX
        Residual as a function of states, inputs, parameters and unknowns; zero at the solution.
    answer : callable
        Function that returns the change of the unknowns cancelling a change of the residual.
    rate, output : casadi.SX
        As in the model, but as functions of the unknowns instead of their solution.
    moved : callable
        Function that returns the coordinates after a small displacement in terms of the speeds.
    correction : callable
        Function that returns the displacement (or change of the speeds) cancelling a constraint residual (or its rate).
    constraint_rate : casadi.SX
        Rate of the loop equations.
    """

    unknown: ca.SX
    found: ca.SX
    residual: ca.SX
    answer: Callable[[ca.SX], ca.SX]
    rate: ca.SX
    output: ca.SX
    moved: Callable[[ca.SX], ca.SX]
    correction: Callable[[ca.SX], ca.SX]
    constraint_rate: ca.SX


@dataclass(frozen=True)
class Generic:
    """A model with symbols for the numbers in which its similar parts differ: names, symbols, values."""

    model: Model
    names: tuple[str, ...]
    symbols: ca.SX
    values: ca.SX


@dataclass(frozen=True)
class Model:
    """Symbolic equations ``dx/dt = rate(x, u, p, m)``, outputs and switching functions.

    The state ``x`` is (coordinates, speeds, internal states). The inputs ``u`` are, for each track, its value and its
    first ``track_order - 1`` time derivatives. ``m`` holds one mode (0 or 1) for each switch: within a step modes are
    constant and all equations smooth; mode ``i`` is 1 exactly where ``switch[i] > 0``.

    Attributes
    ----------
    coordinates, speeds, internal, constraints, tracks, parameters, switches : tuple of str
        Names, in the order of the symbols.
    track_order : int
        Inputs per track: 2 (value, rate) or 3 (value, rate, acceleration).
    outputs : tuple of Output
        Signals, in the order of ``output``.
    start : tuple of float
        Coordinates in the design pose (m, rad; 1 for quaternions).
    x, u, p, m : casadi.SX
        Symbols of states, inputs, parameters and modes.
    rate, output, switch : casadi.SX
        Expressions of the symbols.
    loops : dict
        Closing joint to the joints around its loop.
    units : tuple of str
        Units of coordinates and speeds.
    quaternions : dict
        Joint to the index of the first of four coordinates that are its quaternion.
    equations : tuple of Equation
        The loop equations named in ``constraints``, with their joints and units.
    constraint : casadi.SX
        Loop equations, zero where the loops are closed.
    projection : casadi.SX
        States projected onto the constraints, then the norm of the residual before projection and the conditioning of
        the constraints (1: independent, 0: singular); empty without loops.
    balance : Balance
        Equations of accelerations and multipliers.
    alike : tuple, optional
        Name prefixes of similar parts (one tuple each), and the groups that are computed together.
    generic : Generic, optional
        The same model with symbols instead of some numbers.
    """

    coordinates: tuple[str, ...]
    speeds: tuple[str, ...]
    internal: tuple[str, ...]
    constraints: tuple[str, ...]
    tracks: tuple[str, ...]
    track_order: int
    parameters: tuple[str, ...]
    switches: tuple[str, ...]
    outputs: tuple[Output, ...]
    start: tuple[float, ...]
    loops: dict[str, tuple[str, ...]]
    units: tuple[str, ...]
    quaternions: dict[str, int]
    equations: tuple[Equation, ...]
    x: ca.SX
    u: ca.SX
    p: ca.SX
    m: ca.SX
    rate: ca.SX
    output: ca.SX
    switch: ca.SX
    constraint: ca.SX
    projection: ca.SX
    balance: Balance
    alike: Alike | None = None
    generic: Generic | None = None

    @once
    def facts(self) -> ModelFacts:
        """Names and counts."""
        return ModelFacts(
            **{field.name: getattr(self, field.name) for field in fields(ModelFacts)[:-2]},
            projects=bool(self.projection.shape[0]),
            linear_without=next(
                (zero for zero in self._bending() if self.is_piecewise_linear(zero)), None
            ),
        )

    @property
    def states(self) -> tuple[str, ...]:
        """Names of all states: coordinates, speeds, internal states."""
        return self.facts.states

    def is_piecewise_linear(self, zero: tuple[str, ...] = ()) -> bool:
        """Whether rates and outputs are affine in states and inputs as long as no mode changes.

        The switching functions may be nonlinear. Parameters in ``zero`` are assumed to be zero.
        """
        if self.constraints or self.projection.shape[0]:
            return False
        signals, equations = ca.vertcat(self.x, self.u), ca.vertcat(self.rate, self.output)
        if zero:
            gone = ca.vertcat(*(self.p[self.parameters.index(name)] for name in zero))
            equations = ca.substitute(equations, gone, ca.SX.zeros(len(zero)))
        function = ca.Function("equations", [signals, self.p, self.m], [equations])
        if {function.instruction_id(k) for k in range(function.n_instructions())} & _KINKED:
            return False
        return not ca.depends_on(ca.jacobian(equations, signals), signals)

    def _bending(self) -> tuple[tuple[str, ...], ...]:
        """Parameter sets to set to zero when testing piecewise linearity: none, and those that stiffen bump stops."""
        stiffening = tuple(name for name in self.parameters if name.endswith(".progression"))
        return ((), stiffening) if stiffening else ((),)


def with_numbers(model: Model, constants: Mapping[str, tuple[ca.SX, float]]) -> Model:
    """Replace symbols by their numbers; keep the original model as ``generic``."""
    symbols, values = (
        ca.vertcat(*(symbol for symbol, _ in constants.values())),
        ca.SX([x for _, x in constants.values()]),
    )

    def put(*parts: ca.SX) -> list[ca.SX]:
        return list(
            ca.substitute(list(parts), [symbols], [values])
        )  # in one call: shared subexpressions stay shared

    old = model.balance
    solution, residual, rate, output, constraint_rate, *own = put(
        old.found,
        old.residual,
        old.rate,
        old.output,
        old.constraint_rate,
        model.rate,
        model.output,
        model.switch,
        model.constraint,
        model.projection,
    )
    balance = Balance(
        unknown=old.unknown,
        found=solution,
        residual=residual,
        answer=lambda change: put(old.answer(change))[0],
        rate=rate,
        output=output,
        moved=lambda change: put(old.moved(change))[0],
        correction=lambda change: put(old.correction(change))[0],
        constraint_rate=constraint_rate,
    )
    return replace(
        model,
        rate=own[0],
        output=own[1],
        switch=own[2],
        constraint=own[3],
        projection=own[4],
        balance=balance,
        generic=Generic(model, tuple(constants), symbols, values),
    )
