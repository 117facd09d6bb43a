"""A model bound to its native code: parameters by path, slopes, engine, sensitivities."""

from __future__ import annotations

import json
from collections import OrderedDict
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from functools import cache, cached_property
from typing import Any

import casadi as ca
import numpy as np

from jounce.control.actuators import AnyActuator
from jounce.core.errors import SimulationError
from jounce.core.sources import digest_of
from jounce.core.types import Array
from jounce.kernel.engine import Engine
from jounce.kernel.lowering import AnyFunction, Lanes
from jounce.kernel.methods.explicit import shortened
from jounce.kernel.methods.runge_kutta import SHORT_NAMES, STEP_NAMES, Step
from jounce.kernel.native import Native, Source, compile_functions, kept_code
from jounce.kernel.packing import SHARED, Graph, Packed, Parts
from jounce.mechanics.model import Facts, Generic, Model, Output, is_road
from jounce.mechanics.tangents import tangent
from jounce.parts import Rig
from jounce.parts.rig import structure_of

_PACKAGES = ("core", "parts", "control", "mechanics", "models", "kernel", "simulation")
"""Packages whose sources say what a rig compiles to."""


@dataclass(frozen=True)
class Compiled:
    """Native functions of one model; ``free`` are the parameters whose sensitivities ride along with the state.

    ``shapes`` are those of each function's result; ``scalars`` and ``lanes`` count the extended parameters without and
    with lanes (see ``Program``). ``source`` gives the symbolic model, which runs do not need; ``without`` is the same
    model without free parameters, where there are some. ``identity`` says everything the code of a rig depends on; it
    is empty where only the symbolic model says it.
    """

    facts: Facts
    free: tuple[str, ...]
    native: Native
    shapes: dict[str, tuple[int, int]]
    scalars: int
    lanes: int
    source: Callable[[], Model] = field(repr=False)
    without: Compiled | None = field(default=None, repr=False)
    identity: str = field(default="", repr=False)

    @property
    def plain(self) -> Compiled:
        """The model without free parameters."""
        return self.without or self

    @property
    def model(self) -> Model:
        """The symbolic model, built when it is first asked for."""
        return self.source()

    @cached_property
    def functions(self) -> dict[str, ca.Function]:
        """The native functions as graphs."""
        return _program(self.model, self.free).graphs

    @property
    def state_count(self) -> int:
        """Number of states without sensitivities."""
        return len(self.facts.states)

    @cached_property
    def output_names(self) -> tuple[str, ...]:
        """Channel names in the order of the outputs."""
        return tuple(output.name for output in self.facts.outputs)

    @cached_property
    def equilibria(self) -> OrderedDict[object, Any]:
        """States of rest found so far, the oldest first (see ``statics.find_equilibrium``)."""
        return OrderedDict()

    @cached_property
    def engine(self) -> Engine:
        """Addresses of the native functions, with sensitivities where there are free parameters."""
        address, suffix = self.native.address, "_s" if self.free else ""
        return Engine(
            address[f"rate{suffix}"],
            address[f"output{suffix}"],
            address.get("switch_slope", 0),
            address.get(f"project{suffix}", 0),
            address.get("project_many", 0),
            *(address[name] for name in STEP_NAMES),
        )

    @cached_property
    def short_engine(self) -> Engine:
        """The same with a pair of lower order, for runs whose steps the input keeps short."""
        return shortened(self.engine, *(self.native.address[name] for name in SHORT_NAMES.values()))

    def extended(self, p: Array) -> Array:
        """Parameters as the engine wants them: with what depends on them alone, and lanes where some are free."""
        values = self.native.evaluate("derived", (self.scalars,), p, *_NOTHING)
        if not self.free:
            return values
        inputs = np.concatenate([p, np.eye(len(self.free)).ravel()])
        lanes = self.native.evaluate("derived_lanes", (self.lanes * len(self.free),), inputs, *_NOTHING)
        return np.concatenate([values, lanes])

    def evaluate(self, name: str, x: Array, u: Array, p: Array, m: Array) -> Array:
        """Value of a function (vectors flat), or a slope such as ``rate_x``; ``p`` may be extended already."""
        plain = self.plain
        if name not in plain.shapes:
            part, _, by = name.rpartition("_")
            return plain.slopes(by, x, u, p, m)[part]
        rows, columns = plain.shapes[name]
        values = p if len(p) == plain.scalars else plain.extended(p)
        return plain.native.evaluate(name, (rows,) if columns == 1 else (rows, columns), x, u, values, m)

    def slopes(self, by: str, x: Array, u: Array, p: Array, m: Array) -> dict[str, Array]:
        """Slopes of ``rate``, ``output``, ``switch``, ``constraint`` by states (``"x"``) or inputs, a column each."""
        plain, facts = self.plain, self.facts
        (rows, lanes), n, n_u = plain.shapes["slopes"], len(x), len(u)
        values = p if len(p) == plain.scalars else plain.extended(p)
        states, count = np.zeros(n + (n + n_u) * lanes), {"x": n, "u": n_u}[by]
        states[:n] = x
        seeds = states[n + (n * lanes if by == "u" else 0) :].reshape(-1, lanes)
        whole = np.empty((rows, count))
        for first in range(0, count, lanes):
            group = range(first, min(first + lanes, count))
            seeds[:] = 0.0
            seeds[group, range(len(group))] = 1.0
            found = plain.native.evaluate("slopes", (rows * lanes,), states, u, values, m)
            whole[:, first : first + len(group)] = found.reshape(rows, lanes)[:, : len(group)]
        parts, begin = {}, 0
        for name, names in zip(SLOPES, (facts.states, facts.outputs, facts.switches, facts.constraints), strict=True):
            parts[name], begin = whole[begin : begin + len(names)], begin + len(names)
        return parts

    def free_slopes(self, x: Array, u: Array, p: Array, m: Array) -> tuple[Array, Array]:
        """Slopes of rates and constraints along the free parameters, states kept; one column for each of them."""
        n, count, values = len(x), len(self.free), self.extended(p)
        states = np.concatenate([x, np.zeros(n * count)])
        rate = self.native.evaluate("rate_s", (n * (1 + count),), states, u, values, m)[n:]
        loops = self.native.evaluate("constraint_s", (len(self.facts.constraints) * count,), states, u, values, m)
        return rate.reshape(-1, count), loops.reshape(-1, count)

    def projected(self, x: Array, u: Array, p: Array, m: Array) -> Array:
        """Move a state one step towards the constraints, its speeds onto them."""
        return self.evaluate("project_many", x, u, p, m)[2:] if self.facts.projects else x

    def parameter_values(self, parameters: dict[str, float]) -> Array:
        """Pick the model's parameters from the values by path."""
        return np.array([parameters[path] for path in self.facts.parameters])

    def sides(self, x: Array, u: Array, p: Array) -> Array:
        """Modes that follow the sides of their switches."""
        return (self.evaluate("switch", x, u, p, np.ones(len(self.facts.switches))) > 0.0).astype(float)

    def inputs(self, values: dict[str, float] | float = 0.0) -> Array:
        """Inputs at rest: the height (m) of all roads, or the value of some tracks by name; their rates are zero."""
        facts = self.facts
        u = np.zeros(len(facts.tracks) * facts.track_order)
        given = values if isinstance(values, dict) else dict.fromkeys(filter(is_road, facts.tracks), values)
        for name, value in given.items():
            u[facts.tracks.index(name) * facts.track_order] = value
        return u


_NOTHING = (np.zeros(0),) * 3
_compiled: dict[tuple[object, ...], Compiled] = {}


def compile_model(model: Model, free: tuple[str, ...] = ()) -> Compiled:
    """Give the native code of a model, with sensitivities to the parameters ``free`` (paths); made once a process.

    A free parameter that does not occur in the model is an error.
    """
    key = (id(model), free)
    if key not in _compiled:
        program = _program(model, free)
        native = compile_functions(program.functions, program.step)
        without = compile_model(model) if free else None
        numbers = (program.shapes, program.scalars, program.lanes)
        _compiled[key] = Compiled(model.facts, free, native, *numbers, lambda: model, without)
    return _compiled[key]


def compile_rig(
    rig: Rig, free: tuple[str, ...] = (), *, detail: bool = False, actuator: AnyActuator | None = None
) -> Compiled:
    """Give the native code of a rig's model; where the cache holds it, the model is not even built.

    Rigs that differ in numbers only share one. ``free`` is as for :func:`compile_model`, ``detail`` as for
    :func:`jounce.models.build`; the numbers of an ``actuator`` of every strut are parameters, too.
    """
    key = (type(rig).__name__, structure_of(rig), detail, free, actuator.structure if actuator else "")

    def model() -> Model:
        from jounce.models import build

        return build(rig, detail=detail, actuator=actuator)

    return compile_described(key, model, free, lambda: compile_rig(rig, detail=detail, actuator=actuator))


def compile_described(
    key: tuple[object, ...],
    model: Callable[[], Model],
    free: tuple[str, ...] = (),
    without: Callable[[], Compiled] | None = None,
) -> Compiled:
    """Give the native code of a model that a key says all of; where the cache holds it, the model is not even built.

    Keys are equal for models with equal equations; their text is the name in the cache. ``model`` builds the model;
    ``without`` gives the same one without free parameters, where there are some.
    """
    if key not in _compiled:
        identity = f"{_sources()} {key}"
        native, notes = kept_code(identity, lambda: _source(model(), free))
        table: dict[str, Any] = json.loads(notes)
        plain = without() if free and without is not None else None
        shapes = {name: (rows, columns) for name, (rows, columns) in table["shapes"].items()}
        numbers = (shapes, table["scalars"], table["lanes"])
        _compiled[key] = Compiled(_facts(table["facts"]), free, native, *numbers, model, plain, identity)
    return _compiled[key]


def _program(model: Model, free: tuple[str, ...]) -> Program:
    return sensitive_program(model, free) if free else plain_program(model)


def _source(model: Model, free: tuple[str, ...]) -> Source:
    program = _program(model, free)
    table = {"facts": asdict(model.facts), "shapes": program.shapes, "scalars": program.scalars, "lanes": program.lanes}
    return Source(program.functions, program.step, json.dumps(table))


def _facts(table: dict[str, Any]) -> Facts:
    values: dict[str, Any] = {name: tuple(value) if isinstance(value, list) else value for name, value in table.items()}
    values["outputs"] = tuple(Output(**output) for output in table["outputs"])
    return Facts(**values)


@cache
def _sources() -> str:
    """Digest of everything that turns a rig into code: our sources (and version) and the version of the algebra."""
    from importlib.metadata import version

    return f"{version('casadi')} {version('jounce')} {digest_of(*_PACKAGES)}"


SLOPE_LANES = 8
"""Directions that the function ``slopes`` differentiates along at once."""
SLOPES = ("rate", "output", "switch", "constraint")
"""Parts of its result, one after another."""


@dataclass(frozen=True)
class Program:
    """Functions of one module of native code, the step built around them, and the shape of each result.

    ``lanes`` is the number of lanes of the extended parameters behind the ``scalars``.
    """

    functions: dict[str, AnyFunction]
    step: Step
    shapes: dict[str, tuple[int, int]]
    scalars: int
    lanes: int

    @property
    def graphs(self) -> dict[str, ca.Function]:
        """The functions, those with lanes for a single one."""
        functions = self.functions.items()
        return {name: made if isinstance(made, ca.Function) else made.function for name, made in functions}


def plain_program(model: Model) -> Program:
    """Functions of the states alone, and their slopes along states and inputs.

    ``slopes`` takes lanes of (states, inputs) behind the states, and gives the lanes of ``SLOPES``.
    """
    generic, model = model.generic, model.generic.model if model.generic else model
    dx, du = (ca.SX.sym(f"d{name}", getattr(model, name).shape[0]) for name in "xu")
    along = tangent(model, dx, du, ca.SX(model.p.shape[0], 1))
    parts = {"rate": model.rate, "output": model.output, "switch": model.switch, "constraint": model.constraint}
    if model.projection.shape[0]:
        parts["project_many"] = _residual_first(model)
    slopes = ca.vertcat(*(getattr(along, name) for name in SLOPES))
    hoisted = _Hoisted({**parts, "slopes": slopes}, model.p, ca.SX(0, 1), generic)
    functions: dict[str, AnyFunction] = {name: hoisted.function(name, model) for name in parts}
    lanes = 1 if model.alike else SLOPE_LANES
    if model.alike:
        functions["slopes"] = hoisted.function("slopes", model, ca.vertcat(dx, du))
        functions = _side_by_side(functions, hoisted, model)
    else:
        functions["slopes"] = hoisted.lanes("slopes", model, ca.vertcat(dx, du), lanes, 0)
    functions |= hoisted.derived(0)
    if model.switches and model.facts.linear_without is not None:
        functions["switch_many"] = hoisted.function("switch", model)
    n = model.x.shape[0]
    step = Step("rate", n, n, model.u.shape[0], model.switch.shape[0])
    shapes = {name: (part.shape[0], part.shape[1]) for name, part in parts.items()}
    shapes["slopes"] = slopes.shape[0], lanes
    return Program(functions, step, shapes, hoisted.scalars, hoisted.lanes_count)


def sensitive_program(model: Model, free: tuple[str, ...]) -> Program:
    """Functions that carry sensitivities ``S = dx/dp`` along: behind the states, for each one lane a parameter."""
    for path in free:
        if path not in model.parameters:
            raise SimulationError("not a parameter of the model", where=path, allowed=", ".join(model.parameters))
    generic, model = model.generic, model.generic.model if model.generic else model
    n, count = model.x.shape[0], len(free)
    dx, chosen, dp = ca.SX.sym("S", n), ca.SX.sym("dp", count), ca.SX(model.p.shape[0], 1)
    for i, path in enumerate(free):
        dp[model.parameters.index(path)] = chosen[i]
    along = tangent(model, dx, ca.SX(model.u.shape[0], 1), dp)
    parts = {"switch": model.switch, "rate_s": ca.vertcat(model.rate, along.rate)}
    parts["output_s"] = ca.vertcat(model.output, along.output)
    parts["switch_slope"] = ca.vertcat(ca.vec(_switch_slope(model).T), along.switch)
    if model.projection.shape[0]:
        parts["project_many"] = _residual_first(model)
        parts["project_s"] = ca.vertcat(parts["project_many"], along.projection)
    parts["constraint_s"] = along.constraint
    hoisted = _Hoisted(parts, model.p, chosen, generic)
    functions: dict[str, AnyFunction] = {}
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


def _side_by_side(functions: Mapping[str, AnyFunction], hoisted: _Hoisted, model: Model) -> dict[str, AnyFunction]:
    """The same functions with what the model's parts do alike computed side by side; one more projects one sample."""
    assert model.alike
    parts, order = Parts(*model.alike), model.track_order
    inputs = tuple((f"{name}/{i}", mask) for name, mask in map(parts.label, model.tracks) for i in range(order))
    states = tuple(map(parts.label, (*model.coordinates, *model.speeds, *model.internal)))
    seeds = tuple((f"change of {name}", mask) for name, mask in (*states, *inputs))
    modes, numbers = tuple(map(parts.label, model.switches)), hoisted.labels(parts, model.parameters)
    table: dict[tuple[int, ...], int] = {}
    found: dict[str, AnyFunction] = {}
    for name, function in functions.items():
        assert isinstance(function, ca.Function)
        labels = (states + seeds if name == "slopes" else states, inputs, numbers, modes)
        packed = found[name] = Packed(function, parts, labels, table)
        for elements in packed.graph.tables(2):
            if elements not in table:
                table[elements] = hoisted.copy(elements)
    if "project_many" in found:
        found["project"] = found["project_many"]
    return found


def _residual_first(model: Model) -> ca.SX:
    """Residual, conditioning, then the projected states."""
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
    generic : Generic or None
        Symbols that stand for numbers.
    """

    def __init__(self, parts: dict[str, ca.SX], p: ca.SX, dp: ca.SX, generic: Generic | None) -> None:
        self._p, self._dp = p, dp
        self._names, self._constants, self._fixed = (
            (generic.names, generic.symbols, generic.values) if generic else ((), ca.SX(0, 1), ca.SX(0, 1))
        )
        self._copies: list[int] = []
        whole = ca.cse(ca.densify(ca.vertcat(*(ca.vec(part) for part in parts.values()))))
        left, symbols, values = ca.extract_parametric(whole, ca.vertcat(p, dp, self._constants))
        symbols, values = [*ca.vertsplit(self._constants), *symbols], [*ca.vertsplit(self._constants), *values]
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
        self.lanes_count = dp.shape[0] + len(self._wide)

    @property
    def scalars(self) -> int:
        """Number of extended parameters without lanes."""
        return self._numbers.shape[0] + len(self._copies)

    def labels(self, parts: Parts, paths: tuple[str, ...]) -> tuple[tuple[str, int], ...]:
        """Name and parts of every extended parameter."""
        own = tuple(parts.label(path) for path in (*paths, *self._names))
        values = ca.densify(ca.vertcat(*(value for _, value in self._single)))
        graph = Graph(ca.Function("derived", [ca.vertcat(self._p, self._constants)], [ca.cse(values)]), parts, [own])
        made = [graph.results[i] for i in range(len(self._single))]
        known = (("", SHARED) if graph.masks[i] == SHARED else (f"of {graph.shapes[i]}", graph.masks[i]) for i in made)
        return own[: len(paths)] + tuple((name or f"shared {k}", mask) for k, (name, mask) in enumerate(known))

    def copy(self, elements: tuple[int, ...]) -> int:
        """Append copies of extended parameters, side by side; give the place of the first."""
        self._copies += elements
        return self.scalars - len(elements)

    @property
    def _numbers(self) -> ca.SX:
        return ca.vertcat(self._p, *(symbol for symbol, _ in self._single))

    @property
    def _lanes(self) -> ca.SX:
        return ca.vertcat(self._dp, *(symbol for symbol, _ in self._wide))

    def function(self, name: str, model: Model, seeds: ca.SX | None = None) -> ca.Function:
        """A function of (states, inputs, extended parameters, modes), ``seeds`` behind the states."""
        x = model.x if seeds is None else ca.vertcat(model.x, seeds)
        return ca.Function(name, [x, model.u, self._numbers, model.m], [ca.cse(self._parts[name])])

    def lanes(self, name: str, model: Model, seeds: ca.SX, count: int, scalars: int) -> Lanes:
        """The same with lanes behind the states and the parameters; ``scalars`` elements of the result are none."""
        inputs = [ca.vertcat(model.x, seeds), model.u, ca.vertcat(self._numbers, self._lanes), model.m]
        function = ca.Function(name, inputs, [ca.cse(self._parts[name])])
        first = (model.x.shape[0], model.u.shape[0], self.scalars, model.m.shape[0], scalars)
        return Lanes(function, count, first)

    def _resolved(self, values: ca.SX) -> ca.SX:
        return ca.substitute(values, self._constants, self._fixed) if self._names else values

    def derived(self, count: int) -> dict[str, AnyFunction]:
        """Extended parameters, and lanes of them, from parameters and their directions (both in place of states)."""
        none = [ca.SX.sym(name, 0) for name in "upm"]
        values = ca.densify(ca.vertcat(self._p, *(value for _, value in self._single)))
        values = self._resolved(ca.vertcat(values, values[self._copies]))
        wide = self._resolved(ca.densify(ca.vertcat(self._dp, *(value for _, value in self._wide))))
        single = ca.Function("derived", [self._p, *none], [ca.cse(values)])
        if not self.lanes_count:
            return {"derived": single}
        lanes = ca.Function("derived_lanes", [ca.vertcat(self._p, self._dp), *none], [ca.cse(wide)])
        size = self._p.shape[0]
        return {"derived": single, "derived_lanes": Lanes(lanes, count, (size, 0, 0, 0, 0))}
