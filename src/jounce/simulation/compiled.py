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

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Compiled:
    """Native functions of one model; ``free`` are the parameters whose sensitivities ride along with the state.

    ``functions`` are the same functions as CasADi evaluates them: slow, but with the same meaning.
    """

    model: Model
    free: tuple[str, ...]
    functions: dict[str, ca.Function]
    native: Native

    @property
    def state_count(self) -> int:
        """Number of states without sensitivities."""
        return int(self.model.x.shape[0])

    @cached_property
    def output_names(self) -> tuple[str, ...]:
        """Channel names in the order of the outputs."""
        return tuple(output.name for output in self.model.outputs)

    @cached_property
    def engine(self) -> Engine:
        """Addresses of the native functions, with sensitivities where there are free parameters."""
        address, suffix = self.native.address, "_s" if self.free else ""
        return Engine(
            address[f"rate{suffix}"],
            address[f"output{suffix}"],
            address.get("switch_slope", 0),
            *(address[name] for name in STEP_NAMES),
        )

    @cached_property
    def is_linear(self) -> bool:
        """Whether the model is affine in states and inputs and nothing switches."""
        return self.model.is_linear()

    def evaluate(self, name: str, x: Array, u: Array, p: Array, m: Array) -> Array:
        """Value of a native function, in the shape of its expression (vectors flat)."""
        rows, columns = self.functions[name].size_out(0)
        return self.native.evaluate(name, (rows,) if columns == 1 else (rows, columns), x, u, p, m)

    def parameter_values(self, parameters: dict[str, float]) -> Array:
        """Pick the model's parameters from the values by path."""
        return np.array([parameters[path] for path in self.model.parameters])


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
        functions = {
            **_plain(model),
            **_statics(model),
            **(_sensitive(model, free) if free else {}),
        }
        step = Step(
            "rate_s" if free else "rate", states * (1 + len(free)), states, model.u.shape[0], model.switch.shape[0]
        )
        _compiled[key] = Compiled(model, free, functions, compile_functions(functions, step))
    return _compiled[key]


def _function(name: str, model: Model, x: ca.SX, expression: ca.SX) -> ca.Function:
    return ca.Function(name, [x, model.u, model.p, model.m], [ca.cse(ca.densify(expression))])


def _plain(model: Model) -> dict[str, ca.Function]:
    parts = {"rate": model.rate, "output": model.output, "switch": model.switch}
    return {name: _function(name, model, model.x, expression) for name, expression in parts.items()}


def _statics(model: Model) -> dict[str, ca.Function]:
    """Slopes of the rates, for equilibrium and linearisation (column-major, as CasADi stores them)."""
    return {
        "rate_x": _function("rate_x", model, model.x, ca.jacobian(model.rate, model.x)),
        "rate_u": _function("rate_u", model, model.x, ca.jacobian(model.rate, model.u)),
        "rate_p": _function("rate_p", model, model.x, ca.jacobian(model.rate, model.p)),
    }


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

    values, rates = model.u[0::2], model.u[1::2]
    along_time = ca.jtimes(model.switch, values, rates)
    slope = ca.horzcat(ca.jacobian(model.switch, model.x), ca.jacobian(model.switch, symbols), along_time)
    return {
        "rate_s": _function("rate_s", model, state, total(model.rate)),
        "output_s": _function("output_s", model, state, total(model.output)),
        "switch_slope": _function("switch_slope", model, state, slope.T),
    }
