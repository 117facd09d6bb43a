"""A model bound to its native code: parameters by path, slopes, engine, sensitivities."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.remembered import Recent
from jounce.core.sources import digest_of
from jounce.core.turns import once
from jounce.core.types import Array
from jounce.kernel.engine import Engine
from jounce.kernel.methods.explicit import shorten
from jounce.kernel.methods.runge_kutta import SHORT_NAMES, STEP_NAMES
from jounce.kernel.native import Native, Source, code_from_cache, compile_functions
from jounce.mechanics.facts import SLOPES, ModelFacts, Output, is_road
from jounce.parts import Rig
from jounce.parts.rig import check_rig, structure_of

if TYPE_CHECKING:
    import casadi as ca

    from jounce.control.actuators import AnyActuator
    from jounce.mechanics.model import Model
    from jounce.simulation.programs import ModelProgram

_STATES_OF_REST = 256  # cached per model, unless the cache is set smaller
_PACKAGES = ("core", "parts", "control", "mechanics", "models", "kernel", "simulation")
"""Packages whose sources determine the compiled code of a rig."""


@dataclass(frozen=True)
class Compiled:
    """Native functions of one model; ``free`` are the parameters whose sensitivities are integrated with the state.

    ``moved`` are the model's parameters that change with them: the same, or parameters computed from them.
    ``shapes`` are the shapes of each function's result; ``scalars`` and ``lanes`` count the extended parameters without
    and with lanes (see ``ModelProgram``). ``source`` builds the symbolic model, which runs do not need; ``without`` is
    the same model without free parameters, if it has any. ``identity`` names everything that the code of a rig depends
    on; it is empty for a model defined only by its symbols.
    """

    facts: ModelFacts
    free: tuple[str, ...]
    native: Native
    shapes: dict[str, tuple[int, int]]
    scalars: int
    lanes: int
    source: Callable[[], Model] = field(repr=False)
    without: Compiled | None = field(default=None, repr=False)
    moved: tuple[str, ...] = ()
    identity: str = field(default="", repr=False)

    @property
    def plain(self) -> Compiled:
        """The model without free parameters."""
        return self.without or self

    @property
    def model(self) -> Model:
        """The symbolic model, built on first use."""
        return self.source()

    @once
    def functions(self) -> dict[str, ca.Function]:
        """The native functions as graphs."""
        return _program(self.model, self.moved, len(self.free)).graphs

    @property
    def state_count(self) -> int:
        """Number of states without sensitivities."""
        return len(self.facts.states)

    @once
    def output_names(self) -> tuple[str, ...]:
        """Channel names in the order of the outputs."""
        return tuple(output.name for output in self.facts.outputs)

    @once
    def equilibria(self) -> Recent[Any]:
        """Cache of recent equilibria (see ``statics.find_equilibrium``)."""
        return Recent(_STATES_OF_REST)

    @once
    def engine(self) -> Engine:
        """Addresses of the native functions, with sensitivities if there are free parameters."""
        address, suffix = self.native.address, "_s" if self.free else ""
        return Engine(
            address[f"rate{suffix}"],
            address[f"output{suffix}"],
            address.get("switch_slope", 0),
            address.get(f"project{suffix}", 0),
            address.get("project_many", 0),
            *(address[name] for name in STEP_NAMES),
        )

    @once
    def short_engine(self) -> Engine:
        """Engine with an integrator of lower order, for runs whose inputs force short steps."""
        return shorten(self.engine, *(self.native.address[name] for name in SHORT_NAMES.values()))

    def extend(self, p: Array, along: Array | None = None) -> Array:
        """Extend the parameters by all quantities that depend only on them, and by lanes if there are free parameters.

        ``along`` contains the derivatives of the moved parameters by the free parameters, one column each; by default
        the identity.
        """
        values = self.native.evaluate("derived", (self.scalars,), p, *_NOTHING)
        if not self.free:
            return values
        inputs = np.concatenate([p, (np.eye(len(self.free)) if along is None else along).ravel()])
        lanes = self.native.evaluate(
            "derived_lanes", (self.lanes * len(self.free),), inputs, *_NOTHING
        )
        return np.concatenate([values, lanes])

    def evaluate(self, name: str, x: Array, u: Array, p: Array, m: Array) -> Array:
        """Evaluate a function (vectors are flat), or a slope such as ``rate_x``; ``p`` may already be extended."""
        plain = self.plain
        if name not in plain.shapes:
            part, _, by = name.rpartition("_")
            return plain.slopes(by, x, u, p, m)[part]
        rows, columns = plain.shapes[name]
        values = p if len(p) == plain.scalars else plain.extend(p)
        return plain.native.evaluate(
            name, (rows,) if columns == 1 else (rows, columns), x, u, values, m
        )

    def slopes(self, by: str, x: Array, u: Array, p: Array, m: Array) -> dict[str, Array]:
        """Return slopes of ``rate``, ``output``, ``switch``, ``constraint`` by states (``"x"``) or inputs."""
        plain, facts = self.plain, self.facts
        (rows, lanes), n, n_u = plain.shapes["slopes"], len(x), len(u)
        values = p if len(p) == plain.scalars else plain.extend(p)
        states, count = np.zeros(n + (n + n_u) * lanes), {"x": n, "u": n_u}[by]
        states[:n] = x
        seeds = states[n + (n * lanes if by == "u" else 0) :].reshape(-1, lanes)
        table = np.empty((rows, count))
        for first in range(0, count, lanes):
            group = range(first, min(first + lanes, count))
            seeds[:] = 0.0
            seeds[group, range(len(group))] = 1.0
            columns = plain.native.evaluate("slopes", (rows * lanes,), states, u, values, m)
            table[:, first : first + len(group)] = columns.reshape(rows, lanes)[:, : len(group)]
        parts, begin = {}, 0
        for name, names in zip(
            SLOPES, (facts.states, facts.outputs, facts.switches, facts.constraints), strict=True
        ):
            parts[name], begin = table[begin : begin + len(names)], begin + len(names)
        return parts

    def free_slopes(
        self, x: Array, u: Array, p: Array, m: Array, along: Array | None = None
    ) -> tuple[Array, Array]:
        """Return slopes of rates and constraints by the free parameters at constant states, one column each."""
        n, count, values = len(x), len(self.free), self.extend(p, along)
        states = np.concatenate([x, np.zeros(n * count)])
        rate = self.native.evaluate("rate_s", (n * (1 + count),), states, u, values, m)[n:]
        loops = self.native.evaluate(
            "constraint_s", (len(self.facts.constraints) * count,), states, u, values, m
        )
        return rate.reshape(-1, count), loops.reshape(-1, count)

    def project(self, x: Array, u: Array, p: Array, m: Array) -> Array:
        """Move a state's coordinates one step towards the constraints, and its speeds onto them."""
        return self.evaluate("project_many", x, u, p, m)[2:] if self.facts.projects else x

    def parameter_values(self, parameters: dict[str, float]) -> Array:
        """Pick the model's parameters from the values by path."""
        return np.array([parameters[path] for path in self.facts.parameters])

    def sides(self, x: Array, u: Array, p: Array) -> Array:
        """Return the modes given by the signs of their switches."""
        return (self.evaluate("switch", x, u, p, np.ones(len(self.facts.switches))) > 0.0).astype(
            float
        )

    def inputs(self, values: dict[str, float] | float = 0.0) -> Array:
        """Return inputs at rest: a height (m) for all roads, or values of tracks by name; rates are zero."""
        facts = self.facts
        u = np.zeros(len(facts.tracks) * facts.track_order)
        given = (
            values
            if isinstance(values, dict)
            else dict.fromkeys(filter(is_road, facts.tracks), values)
        )
        for name, value in given.items():
            u[facts.tracks.index(name) * facts.track_order] = value
        return u


_NOTHING = (np.zeros(0),) * 3
_compiled: Recent[Compiled] = Recent()


def compile_model(model: Model, free: tuple[str, ...] = ()) -> Compiled:
    """Compile a model, with sensitivities to the parameters ``free`` (paths); once per process.

    A free parameter that is not in the model is an error.
    """

    def make() -> Compiled:
        program = _program(model, free, len(free))
        native = compile_functions(program.functions, program.step)
        without = compile_model(model) if free else None
        numbers = (program.shapes, program.scalars, program.lanes)
        return Compiled(model.facts, free, native, *numbers, lambda: model, without, free)

    return _compiled.of((id(model), free), make)


def compile_rig(
    rig: Rig,
    free: tuple[str, ...] = (),
    *,
    detail: bool = False,
    actuator: AnyActuator | None = None,
) -> Compiled:
    """Compile the model of a rig; if the code is cached, the model is not built.

    Rigs that differ in numbers only share the code. ``free`` is as for :func:`compile_model`, ``detail`` as for
    :func:`jounce.models.build`; the numbers of an ``actuator`` of every strut become parameters.
    """
    check_rig(rig)
    key = (
        type(rig).__name__,
        structure_of(rig),
        detail,
        free,
        actuator.structure if actuator else "",
    )

    def model() -> Model:
        from jounce.models import build

        return build(rig, detail=detail, actuator=actuator)

    return compile_described(
        key, model, free, lambda: compile_rig(rig, detail=detail, actuator=actuator)
    )


def compile_described(
    key: tuple[object, ...],
    model: Callable[[], Model],
    free: tuple[str, ...] = (),
    without: Callable[[], Compiled] | None = None,
    moved: tuple[str, ...] | None = None,
) -> Compiled:
    """Compile a model identified by a key; if the code is cached, the model is not built.

    Equal keys mean equal equations; their text is the name in the cache. ``model`` builds the model; ``without``
    returns the same model without free parameters, if it has any; ``moved`` are the parameters that change with the
    free ones, if they differ.
    """
    changed = free if moved is None else moved

    def make() -> Compiled:
        identity = f"{sources()} {key}"
        native, notes = code_from_cache(identity, lambda: _source(model(), changed, len(free)))
        table: dict[str, Any] = json.loads(notes)
        plain = without() if free and without is not None else None
        shapes = {name: (rows, columns) for name, (rows, columns) in table["shapes"].items()}
        numbers = (shapes, table["scalars"], table["lanes"])
        return Compiled(
            _facts(table["facts"]), free, native, *numbers, model, plain, changed, identity
        )

    return _compiled.of(key, make)


def _program(model: Model, moved: tuple[str, ...], count: int) -> ModelProgram:
    from jounce.simulation.programs import plain_program, sensitive_program

    return sensitive_program(model, moved, count) if count else plain_program(model)


def _source(model: Model, moved: tuple[str, ...], count: int) -> Source:
    program = _program(model, moved, count)
    table = {
        "facts": asdict(model.facts),
        "shapes": program.shapes,
        "scalars": program.scalars,
        "lanes": program.lanes,
    }
    return Source(program.functions, program.step, json.dumps(table))


def _facts(table: dict[str, Any]) -> ModelFacts:
    values: dict[str, Any] = {
        name: tuple(value) if isinstance(value, list) else value for name, value in table.items()
    }
    values["outputs"] = tuple(Output(**output) for output in table["outputs"])
    return ModelFacts(**values)


@cache
def sources() -> str:
    """Return a digest of all that determines a rig's code: sources and version of jounce, and version of CasADi."""
    from importlib.metadata import version

    return f"{version('casadi')} {version('jounce')} {digest_of(*_PACKAGES)}"
