"""Functions of a model's native code and their slopes, with precomputed expressions of parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import casadi as ca

from jounce.core.errors import SimulationError
from jounce.kernel.lowering import AnyFunction, Lanes
from jounce.kernel.methods.runge_kutta import Step
from jounce.kernel.packing import SHARED, Graph, Packed, Parts
from jounce.mechanics.facts import SLOPE_LANES, SLOPES
from jounce.mechanics.model import Generic, Model
from jounce.mechanics.tangents import tangent

Labels: TypeAlias = tuple[tuple[str, int], ...]
"""Name (without the part's prefix) and parts of each element of an argument."""


@dataclass(frozen=True)
class ModelProgram:
    """Functions of one module of native code, the step built around them, and the shape of each result.

    ``lanes`` is the number of lanes of the extended parameters after the ``scalars``.
    """

    functions: dict[str, AnyFunction]
    step: Step
    shapes: dict[str, tuple[int, int]]
    scalars: int
    lanes: int

    @property
    def graphs(self) -> dict[str, ca.Function]:
        """Return the functions as graphs; functions with lanes have a single lane."""
        functions = self.functions.items()
        return {
            name: part if isinstance(part, ca.Function) else part.function
            for name, part in functions
        }


def plain_program(model: Model) -> ModelProgram:
    """Return the functions of a model without sensitivities, and their slopes by states and inputs.

    ``slopes`` takes lanes of (states, inputs) after the states, and returns the lanes of ``SLOPES``.
    """
    turns_linear = bool(model.switches) and model.facts.linear_without is not None
    generic, model = model.generic, model.generic.model if model.generic else model
    dx, du = (ca.SX.sym(f"d{name}", getattr(model, name).shape[0]) for name in "xu")
    along = tangent(model, dx, du, ca.SX(model.p.shape[0], 1))
    parts = {
        "rate": model.rate,
        "output": model.output,
        "switch": model.switch,
        "constraint": model.constraint,
    }
    if model.projection.shape[0]:
        parts["project_many"] = residual_first(model)
    slopes = ca.vertcat(*(getattr(along, name) for name in SLOPES))
    hoisted = Hoisted({**parts, "slopes": slopes}, model.p, ca.SX(0, 1), generic)
    functions: dict[str, AnyFunction] = {name: hoisted.function(name, model) for name in parts}
    lanes = 1 if model.alike else SLOPE_LANES
    if model.alike:
        functions["slopes"] = hoisted.function("slopes", model, ca.vertcat(dx, du))
        functions = _side_by_side(functions, hoisted, model)
    else:
        functions["slopes"] = hoisted.lanes("slopes", model, ca.vertcat(dx, du), lanes, 0)
    functions |= hoisted.derive(0)
    if turns_linear:
        functions["switch_many"] = hoisted.function("switch", model)
    n = model.x.shape[0]
    step = Step("rate", n, n, model.u.shape[0], model.switch.shape[0])
    shapes = {name: (part.shape[0], part.shape[1]) for name, part in parts.items()}
    shapes["slopes"] = slopes.shape[0], lanes
    return ModelProgram(functions, step, shapes, hoisted.scalars, hoisted.lanes_count)


def sensitive_program(model: Model, moved: tuple[str, ...], count: int) -> ModelProgram:
    """Return functions with sensitivities ``S = dx/dp``: after the states, one lane per direction.

    Each of ``count`` directions changes any of the parameters ``moved``, usually a single one.
    """
    for path in moved:
        if path not in model.parameters:
            raise SimulationError(
                "not a parameter of the model", where=path, allowed=", ".join(model.parameters)
            )
    generic, model = model.generic, model.generic.model if model.generic else model
    n = model.x.shape[0]
    dx, chosen, dp = ca.SX.sym("S", n), ca.SX.sym("dp", len(moved)), ca.SX(model.p.shape[0], 1)
    for i, path in enumerate(moved):
        dp[model.parameters.index(path)] = chosen[i]
    along = tangent(model, dx, ca.SX(model.u.shape[0], 1), dp)
    parts = {"switch": model.switch, "rate_s": ca.vertcat(model.rate, along.rate)}
    parts["output_s"] = ca.vertcat(model.output, along.output)
    parts["switch_slope"] = ca.vertcat(ca.vec(_switch_slope(model).T), along.switch)
    if model.projection.shape[0]:
        parts["project_many"] = residual_first(model)
        parts["project_s"] = ca.vertcat(parts["project_many"], along.projection)
    parts["constraint_s"] = along.constraint
    hoisted = Hoisted(parts, model.p, chosen, generic)
    functions: dict[str, AnyFunction] = {}
    scalars = {
        "rate_s": n,
        "output_s": model.output.shape[0],
        "project_s": n + 2,
        "constraint_s": 0,
    }
    scalars["switch_slope"] = model.switch.shape[0] * (n + 1)
    for name in parts:
        if name in scalars:
            functions[name] = hoisted.lanes(name, model, dx, count, scalars[name])
        else:
            functions[name] = hoisted.function(name, model)
    functions |= hoisted.derive(count)
    step = Step("rate_s", n * (1 + count), n, model.u.shape[0], model.switch.shape[0])
    shapes = {name: (part.shape[0], part.shape[1]) for name, part in parts.items()}
    return ModelProgram(functions, step, shapes, hoisted.scalars, hoisted.lanes_count)


def labels_of(
    hoisted: Hoisted, model: Model, parts: Parts
) -> tuple[Labels, Labels, Labels, Labels]:
    """Return name and parts of every state, input, extended parameter and mode."""
    order = range(model.track_order)
    inputs = tuple(
        (f"{name}/{i}", mask) for name, mask in map(parts.label, model.tracks) for i in order
    )
    states = tuple(map(parts.label, (*model.coordinates, *model.speeds, *model.internal)))
    return (
        states,
        inputs,
        hoisted.labels(parts, model.parameters),
        tuple(map(parts.label, model.switches)),
    )


def _side_by_side(
    functions: Mapping[str, AnyFunction], hoisted: Hoisted, model: Model
) -> dict[str, AnyFunction]:
    """Return the functions with similar parts of the model computed in parallel, plus one that projects a sample."""
    assert model.alike
    parts = Parts(*model.alike)
    states, *others = labels_of(hoisted, model, parts)
    seeds = tuple((f"change of {name}", mask) for name, mask in (*states, *others[0]))
    table: dict[tuple[int, ...], int] = {}
    packed_functions: dict[str, AnyFunction] = {}
    for name, function in functions.items():
        assert isinstance(function, ca.Function)
        labels = (states + seeds if name == "slopes" else states, *others)
        packed = packed_functions[name] = Packed(function, parts, labels, table)
        for elements in packed.graph.tables(2):
            if elements not in table:
                table[elements] = hoisted.copy(elements)
    if "project_many" in packed_functions:
        packed_functions["project"] = packed_functions["project_many"]
    return packed_functions


def residual_first(model: Model) -> ca.SX:
    """Return residual, conditioning, then the projected states."""
    n = model.x.shape[0]
    return ca.vertcat(model.projection[n:], model.projection[:n])


def _switch_slope(model: Model) -> ca.SX:
    """Return slopes of each switching function by the states, then by time."""
    order = model.track_order
    along_time = sum(
        (
            ca.jtimes(model.switch, model.u[i::order], model.u[i + 1 :: order])
            for i in range(order - 1)
        ),
        ca.SX(model.switch.shape[0], 1),
    )
    return ca.horzcat(ca.jacobian(model.switch, model.x), along_time)


class Hoisted:
    """Expressions with all subexpressions of parameters (and their directions) alone computed beforehand.

    Parameters
    ----------
    parts : dict
        Name to expression.
    p, dp : casadi.SX
        Parameters, and the directions of free ones.
    generic : Generic or None
        Symbols that replace numbers.
    """

    def __init__(
        self, parts: dict[str, ca.SX], p: ca.SX, dp: ca.SX, generic: Generic | None
    ) -> None:
        self._p, self._dp = p, dp
        self._names, self._constants, self._fixed = (
            (generic.names, generic.symbols, generic.values)
            if generic
            else ((), ca.SX(0, 1), ca.SX(0, 1))
        )
        self._copies: list[int] = []
        together = ca.cse(ca.densify(ca.vertcat(*(ca.vec(part) for part in parts.values()))))
        remaining, symbols, values = ca.extract_parametric(
            together, ca.vertcat(p, dp, self._constants)
        )
        symbols, values = (
            [*ca.vertsplit(self._constants), *symbols],
            [*ca.vertsplit(self._constants), *values],
        )
        wide = [ca.depends_on(value, dp) for value in values]
        self._single = [
            pair
            for pair, lane in zip(zip(symbols, values, strict=True), wide, strict=True)
            if not lane
        ]
        self._wide = [
            pair for pair, lane in zip(zip(symbols, values, strict=True), wide, strict=True) if lane
        ]
        ends = [0]
        for part in parts.values():
            ends.append(ends[-1] + part.numel())
        self._parts = {
            name: ca.reshape(remaining[begin:end], part.shape)
            for (name, part), begin, end in zip(parts.items(), ends[:-1], ends[1:], strict=True)
        }
        self.lanes_count = dp.shape[0] + len(self._wide)

    @property
    def scalars(self) -> int:
        """Number of extended parameters without lanes."""
        return int(self._numbers.shape[0]) + len(self._copies)

    def labels(self, parts: Parts, paths: tuple[str, ...]) -> tuple[tuple[str, int], ...]:
        """Return name and parts of every extended parameter."""
        own = tuple(parts.label(path) for path in (*paths, *self._names))
        values = ca.densify(ca.vertcat(*(value for _, value in self._single)))
        graph = Graph(
            ca.Function("derived", [ca.vertcat(self._p, self._constants)], [values]), parts, [own]
        )
        results = [graph.results[i] for i in range(len(self._single))]
        masks = graph.masks
        kinds = (
            ("", SHARED) if masks[i] == SHARED else (f"of {graph.shapes[i]}", masks[i])
            for i in results
        )
        return own[: len(paths)] + tuple(
            (name or f"shared {k}", mask) for k, (name, mask) in enumerate(kinds)
        )

    def copy(self, elements: tuple[int, ...]) -> int:
        """Append consecutive copies of extended parameters; return the index of the first."""
        self._copies += elements
        return self.scalars - len(elements)

    @cached_property
    def _numbers(self) -> ca.SX:
        return ca.vertcat(self._p, *(symbol for symbol, _ in self._single))

    @cached_property
    def _lanes(self) -> ca.SX:
        return ca.vertcat(self._dp, *(symbol for symbol, _ in self._wide))

    def function(
        self, name: str, model: Model, seeds: ca.SX | None = None, more: Sequence[ca.SX] = ()
    ) -> ca.Function:
        """Create a function of states, inputs, extended parameters, modes and ``more``; ``seeds`` follow the states."""
        x = model.x if seeds is None else ca.vertcat(model.x, seeds)
        return ca.Function(name, [x, model.u, self._numbers, model.m, *more], [self._parts[name]])

    def lanes(self, name: str, model: Model, seeds: ca.SX, count: int, scalars: int) -> Lanes:
        """Return the function with lanes after states and parameters; ``scalars`` elements of the result have none."""
        inputs = [
            ca.vertcat(model.x, seeds),
            model.u,
            ca.vertcat(self._numbers, self._lanes),
            model.m,
        ]
        function = ca.Function(name, inputs, [self._parts[name]])
        first = (model.x.shape[0], model.u.shape[0], self.scalars, model.m.shape[0], scalars)
        return Lanes(function, count, first)

    def _with_fixed_numbers(self, values: ca.SX) -> ca.SX:
        return ca.substitute(values, self._constants, self._fixed) if self._names else values

    def derive(self, count: int) -> dict[str, AnyFunction]:
        """Return functions for extended parameters and their lanes, which take parameters and directions as states."""
        none = [ca.SX.sym(name, 0) for name in "upm"]
        values = ca.densify(ca.vertcat(self._p, *(value for _, value in self._single)))
        values = self._with_fixed_numbers(ca.vertcat(values, values[self._copies]))
        wide = self._with_fixed_numbers(
            ca.densify(ca.vertcat(self._dp, *(value for _, value in self._wide)))
        )
        single = ca.Function("derived", [self._p, *none], [ca.cse(values)])
        if not self.lanes_count:
            return {"derived": single}
        lanes = ca.Function("derived_lanes", [ca.vertcat(self._p, self._dp), *none], [ca.cse(wide)])
        size = self._p.shape[0]
        return {"derived": single, "derived_lanes": Lanes(lanes, count, (size, 0, 0, 0, 0))}
