"""What is compiled of a model: its functions, those along tangents, and what depends on parameters only.

Every function takes the parameters extended by all that depends on them alone (``derived``), so that it is computed
once a run. Where tangents are carried along, the lanes of the parameters (one for each direction) follow behind.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from jounce.core.errors import SimulationError
from jounce.kernel.lowering import Lanes
from jounce.kernel.steps import Step
from jounce.mechanics import Model
from jounce.mechanics.tangents import tangent

SLOPE_LANES = 8
"""Directions that the function ``slopes`` differentiates along at once."""
SLOPES = ("rate", "output", "switch", "constraint")
"""Parts of its result, one after another."""


@dataclass(frozen=True)
class Program:
    """Functions of one module of native code, the step built around them, and the shape of each result.

    ``lanes`` is the number of lanes of the extended parameters behind the ``scalars``.
    """

    functions: dict[str, ca.Function | Lanes]
    step: Step
    shapes: dict[str, tuple[int, int]]
    scalars: int
    lanes: int

    @property
    def graphs(self) -> dict[str, ca.Function]:
        """The functions, those with lanes for a single one."""
        return {name: made.function if isinstance(made, Lanes) else made for name, made in self.functions.items()}


def plain_program(model: Model) -> Program:
    """Functions of the states alone, and their slopes along states and inputs.

    ``slopes`` takes lanes of (states, inputs) behind the states, and gives the lanes of ``SLOPES``.
    """
    dx, du = (ca.SX.sym(f"d{name}", getattr(model, name).shape[0]) for name in "xu")
    along = tangent(model, dx, du, ca.SX(model.p.shape[0], 1))
    parts = {"rate": model.rate, "output": model.output, "switch": model.switch, "constraint": model.constraint}
    if model.projection.shape[0]:
        parts["project_many"] = _violation_first(model)
    slopes = ca.vertcat(*(getattr(along, name) for name in SLOPES))
    hoisted = _Hoisted({**parts, "slopes": slopes}, model.p, ca.SX(0, 1))
    functions: dict[str, ca.Function | Lanes] = {name: hoisted.function(name, model) for name in parts}
    functions["slopes"] = hoisted.lanes("slopes", model, ca.vertcat(dx, du), SLOPE_LANES, 0)
    functions |= hoisted.derived(0)
    n = model.x.shape[0]
    step = Step("rate", n, n, model.u.shape[0], model.switch.shape[0])
    shapes = {name: (part.shape[0], part.shape[1]) for name, part in {**parts, "slopes": slopes}.items()}
    return Program(functions, step, shapes, hoisted.scalars, hoisted.lanes_count)


def sensitive_program(model: Model, free: tuple[str, ...]) -> Program:
    """Functions that carry sensitivities ``S = dx/dp`` along: behind the states, for each state one lane a parameter.

    Raises
    ------
    SimulationError
        When a free parameter does not occur in the model.
    """
    for path in free:
        if path not in model.parameters:
            raise SimulationError("not a parameter of the model", where=path, allowed=", ".join(model.parameters))
    n, count = model.x.shape[0], len(free)
    dx, chosen, dp = ca.SX.sym("S", n), ca.SX.sym("dp", count), ca.SX(model.p.shape[0], 1)
    for i, path in enumerate(free):
        dp[model.parameters.index(path)] = chosen[i]
    along = tangent(model, dx, ca.SX(model.u.shape[0], 1), dp)
    parts = {"switch": model.switch, "rate_s": ca.vertcat(model.rate, along.rate)}
    parts["output_s"] = ca.vertcat(model.output, along.output)
    parts["switch_slope"] = ca.vertcat(ca.vec(_switch_slope(model).T), along.switch)
    if model.projection.shape[0]:
        parts["project_many"] = _violation_first(model)
        parts["project_s"] = ca.vertcat(parts["project_many"], along.projection)
    parts["constraint_s"] = along.constraint
    hoisted = _Hoisted(parts, model.p, chosen)
    functions: dict[str, ca.Function | Lanes] = {}
    scalars = {"rate_s": n, "output_s": model.output.shape[0], "project_s": n + 2, "constraint_s": 0}
    scalars["switch_slope"] = model.switch.shape[0] * (n + 1)
    for name in parts:
        if name in scalars:
            functions[name] = hoisted.lanes(name, model, dx, count, scalars[name])
        else:
            functions[name] = hoisted.function(name, model)
    functions |= hoisted.derived(count)
    step = Step("rate_s", n * (1 + count), n, model.u.shape[0], model.switch.shape[0])
    shapes = {name: (part.shape[0], part.shape[1]) for name, part in parts.items()}
    return Program(functions, step, shapes, hoisted.scalars, hoisted.lanes_count)


def _violation_first(model: Model) -> ca.SX:
    """Violation, conditioning, then the projected states."""
    n = model.x.shape[0]
    return ca.vertcat(model.projection[n:], model.projection[:n])


def _switch_slope(model: Model) -> ca.SX:
    """Slopes of each switching function along the states, then along time."""
    order = model.track_order
    along_time = sum(
        (ca.jtimes(model.switch, model.u[i::order], model.u[i + 1 :: order]) for i in range(order - 1)),
        ca.SX(model.switch.shape[0], 1),
    )
    return ca.horzcat(ca.jacobian(model.switch, model.x), along_time)


class _Hoisted:
    """Expressions without the parts that depend on parameters (and their directions) only.

    Parameters
    ----------
    parts : dict
        Name to expression.
    p, dp : casadi.SX
        Parameters, and the directions of those that may move.
    """

    def __init__(self, parts: dict[str, ca.SX], p: ca.SX, dp: ca.SX) -> None:
        self._p, self._dp = p, dp
        whole = ca.cse(ca.densify(ca.vertcat(*(ca.vec(part) for part in parts.values()))))
        left, symbols, values = ca.extract_parametric(whole, ca.vertcat(p, dp))
        wide = [ca.depends_on(value, dp) for value in values]
        self._single = [pair for pair, lane in zip(zip(symbols, values, strict=True), wide, strict=True) if not lane]
        self._wide = [pair for pair, lane in zip(zip(symbols, values, strict=True), wide, strict=True) if lane]
        ends = [0]
        for part in parts.values():
            ends.append(ends[-1] + part.numel())
        self._parts = {
            name: ca.reshape(left[begin:end], part.shape)
            for (name, part), begin, end in zip(parts.items(), ends[:-1], ends[1:], strict=True)
        }
        self.scalars = p.shape[0] + len(self._single)
        self.lanes_count = dp.shape[0] + len(self._wide)

    @property
    def _numbers(self) -> ca.SX:
        return ca.vertcat(self._p, *(symbol for symbol, _ in self._single))

    @property
    def _lanes(self) -> ca.SX:
        return ca.vertcat(self._dp, *(symbol for symbol, _ in self._wide))

    def function(self, name: str, model: Model) -> ca.Function:
        """A function of (states, inputs, extended parameters, modes)."""
        return ca.Function(name, [model.x, model.u, self._numbers, model.m], [ca.cse(self._parts[name])])

    def lanes(self, name: str, model: Model, seeds: ca.SX, count: int, scalars: int) -> Lanes:
        """The same with lanes behind the states and the parameters; ``scalars`` elements of the result are none."""
        inputs = [ca.vertcat(model.x, seeds), model.u, ca.vertcat(self._numbers, self._lanes), model.m]
        function = ca.Function(name, inputs, [ca.cse(self._parts[name])])
        first = (model.x.shape[0], model.u.shape[0], self.scalars, model.m.shape[0], scalars)
        return Lanes(function, count, first)

    def derived(self, count: int) -> dict[str, ca.Function | Lanes]:
        """Extended parameters, and lanes of them, from parameters and their directions (both in place of states)."""
        none = [ca.SX.sym(name, 0) for name in "upm"]
        values = ca.densify(ca.vertcat(self._p, *(value for _, value in self._single)))
        wide = ca.densify(ca.vertcat(self._dp, *(value for _, value in self._wide)))
        single = ca.Function("derived", [self._p, *none], [ca.cse(values)])
        if not self.lanes_count:
            return {"derived": single}
        lanes = ca.Function("derived_lanes", [ca.vertcat(self._p, self._dp), *none], [ca.cse(wide)])
        size = self._p.shape[0]
        return {"derived": single, "derived_lanes": Lanes(lanes, count, (size, 0, 0, 0, 0))}
