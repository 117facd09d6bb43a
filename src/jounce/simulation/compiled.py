"""A model bound to its native code: parameters by path, equilibrium, modes, scales, sensitivities."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.kernel.explicit import Engine
from jounce.kernel.native import Native, compile_functions
from jounce.kernel.steps import STEP_NAMES, Step
from jounce.mechanics import Model
from jounce.mechanics.model import Facts

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Compiled:
    """Native functions of one model; ``free`` are the parameters whose sensitivities ride along with the state.

    ``functions`` are the same functions as CasADi evaluates them: slow, but with the same meaning.
    """

    model: Model
    facts: Facts
    free: tuple[str, ...]
    functions: dict[str, ca.Function]
    native: Native

    @property
    def state_count(self) -> int:
        """Number of states without sensitivities."""
        return len(self.facts.states)

    @cached_property
    def output_names(self) -> tuple[str, ...]:
        """Channel names in the order of the outputs."""
        return tuple(output.name for output in self.facts.outputs)

    @cached_property
    def engine(self) -> Engine:
        """Addresses of the native functions, with sensitivities where there are free parameters."""
        address, suffix = self.native.address, "_s" if self.free else ""
        return Engine(
            address[f"rate{suffix}"],
            address[f"output{suffix}"],
            address.get("switch_slope", 0),
            address.get("project", 0),
            address.get("project_many", 0),
            *(address[name] for name in STEP_NAMES),
        )

    def evaluate(self, name: str, x: Array, u: Array, p: Array, m: Array) -> Array:
        """Value of a function, in the shape of its expression (vectors flat)."""
        rows, columns = self.functions[name].size_out(0)
        if name not in self.native.address:
            value = self.functions[name](x, u, p, m).full()
            return np.asarray(value[:, 0] if columns == 1 else value)
        return self.native.evaluate(name, (rows,) if columns == 1 else (rows, columns), x, u, p, m)

    def projected(self, x: Array, u: Array, p: Array, m: Array) -> Array:
        """Move a state one step towards the constraints, its speeds onto them."""
        return self.evaluate("project_x", x, u, p, m)[: len(x)] if self.facts.projects else x

    def parameter_values(self, parameters: dict[str, float]) -> Array:
        """Pick the model's parameters from the values by path."""
        return np.array([parameters[path] for path in self.facts.parameters])

    def inputs(self, values: dict[str, float] | float = 0.0) -> Array:
        """Inputs at rest: the value of every track, or of some by name; their rates are zero."""
        facts = self.facts
        u = np.zeros(len(facts.tracks) * facts.track_order)
        given = values if isinstance(values, dict) else dict.fromkeys(facts.tracks, values)
        for name, value in given.items():
            u[facts.tracks.index(name) * facts.track_order] = value
        return u


_compiled: dict[tuple[int, tuple[str, ...]], Compiled] = {}


def compile_model(model: Model, free: tuple[str, ...] = ()) -> Compiled:
    """Give the native code of a model, with sensitivities to the ``free`` parameters; made once a process.

    Parameters
    ----------
    model : Model
        The symbolic model.
    free : tuple of str
        Paths of parameters to differentiate with respect to.

    Raises
    ------
    SimulationError
        When a free parameter does not occur in the model.
    """
    key = (id(model), free)
    if key not in _compiled:
        for path in free:
            if path not in model.parameters:
                raise SimulationError("not a parameter of the model", where=path, allowed=", ".join(model.parameters))
        states = model.x.shape[0]
        native = {**_plain(model), **(_sensitive(model, free) if free else {})}
        step = Step(
            "rate_s" if free else "rate", states * (1 + len(free)), states, model.u.shape[0], model.switch.shape[0]
        )
        functions = {**native, **_statics(model)}
        if not model.constraints:
            native = functions
        _compiled[key] = Compiled(model, model.facts, free, functions, compile_functions(native, step))
    return _compiled[key]


def _function(name: str, model: Model, x: ca.SX, expression: ca.SX) -> ca.Function:
    return ca.Function(name, [x, model.u, model.p, model.m], [ca.cse(ca.densify(expression))])


def _plain(model: Model) -> dict[str, ca.Function]:
    parts = {"rate": model.rate, "output": model.output, "switch": model.switch}
    if model.projection.shape[0]:
        parts["project"] = parts["project_many"] = model.projection
    return {name: _function(name, model, model.x, expression) for name, expression in parts.items()}


def _statics(model: Model) -> dict[str, ca.Function]:
    """Slopes of the rates, for equilibrium and linearisation (column-major, as CasADi stores them)."""
    parts = {
        "rate_x": ca.jacobian(model.rate, model.x),
        "rate_u": ca.jacobian(model.rate, model.u),
        "rate_p": ca.jacobian(model.rate, model.p),
    }
    if model.constraints:
        parts["constraint"] = model.constraint
        parts["constraint_x"] = ca.jacobian(model.constraint, model.x)
        parts["constraint_p"] = ca.jacobian(model.constraint, model.p)
    if model.projection.shape[0]:
        parts["project_x"] = model.projection
    return {name: _function(name, model, model.x, expression) for name, expression in parts.items()}


def _sensitive(model: Model, free: tuple[str, ...]) -> dict[str, ca.Function]:
    """Rates, outputs, switch slopes of the state with its sensitivities ``S = dx/dp`` behind it, column by column."""
    n, count = model.x.shape[0], len(free)
    symbols = ca.vertcat(*(model.p[model.parameters.index(path)] for path in free))
    sensitivity = ca.SX.sym("S", n, count)
    state = ca.vertcat(model.x, ca.vec(sensitivity))

    def total(expression: ca.SX) -> ca.SX:
        columns = [
            ca.jtimes(expression, model.x, sensitivity[:, c]) + ca.jacobian(expression, symbols[c])
            for c in range(count)
        ]
        return ca.vertcat(expression, *columns)

    order = model.track_order
    along_time = sum(
        (ca.jtimes(model.switch, model.u[i::order], model.u[i + 1 :: order]) for i in range(order - 1)),
        ca.SX(model.switch.shape[0], 1),
    )
    slope = ca.horzcat(ca.jacobian(model.switch, model.x), ca.jacobian(model.switch, symbols), along_time)
    parts = {"rate_s": total(model.rate), "output_s": total(model.output), "switch_slope": slope.T}
    if model.projection.shape[0]:
        moved, rest = model.projection[:n], model.projection[n:]
        parts["project"] = parts["project_many"] = ca.vertcat(total(moved), rest)
    return {name: _function(name, model, state, expression) for name, expression in parts.items()}
