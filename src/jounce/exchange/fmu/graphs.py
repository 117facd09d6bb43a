"""Functions of a model as C code, with the names declared in ``c/core.h``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from jounce.core.types import Array
from jounce.exchange.fmu.code import function_text
from jounce.kernel.packing import SHARED, Packed, Parts
from jounce.mechanics.model import Model
from jounce.mechanics.tangents import tangent
from jounce.simulation.programs import Hoisted, labels_of, residual_first

_ARGUMENTS = {  # C name to (arguments, results), in the order of core.h
    "derived": ("p", "e"),
    "rate": ("x u e m", "dx"),
    "output": ("x u e m", "y"),
    "switch": ("x u e m", "z"),
    "project": ("x u e m", "out"),
    "loops": ("x u e m", "value rate"),
    "slopes": ("x u e m sx su sp", "dx y z on"),
    "adjoint": ("x u e m dx y z on", "sx su sp"),
    "law": ("memory measured g", "out"),
}


@dataclass(frozen=True)
class Graphs:
    """Functions of a model by their C names, with the size of each result.

    ``extended`` is the number of parameters and of values derived from them.
    """

    model: Model
    functions: dict[str, tuple[Packed, tuple[int, ...]]]
    extended: int


def graphs_of(model: Model, law: ca.Function | None = None, *, adjoint: bool = True) -> Graphs:
    """Build the functions of a model; expressions that depend only on parameters are computed once.

    ``law`` is a controller's function of (memory, measurements and time, parameters, empty). ``adjoint`` adds the
    adjoint derivatives.
    """
    generic, model = model.generic, model.generic.model if model.generic else model
    n, projects = model.x.shape[0], bool(model.projection.shape[0])
    seeds = [ca.SX.sym(f"d{name}", getattr(model, name).shape[0]) for name in "xup"]
    along = tangent(model, *seeds)
    slopes = [along.rate, along.output, along.switch, along.projection if projects else ca.SX(n, 1)]
    parts = {"rate": [model.rate], "output": [model.output], "switch": [model.switch]}
    if projects:
        parts["project"] = [residual_first(model)]
    loops = (
        [model.constraint, model.balance.constraint_rate]
        if model.constraints
        else [ca.SX(0, 1), ca.SX(0, 1)]
    )
    parts |= {"loops": loops, "slopes": slopes}
    more = {"slopes": seeds}
    if adjoint:
        weights = more["adjoint"] = [
            ca.SX.sym(f"weight{i}", part.shape[0]) for i, part in enumerate(slopes)
        ]
        back = ca.jtimes(ca.vertcat(*slopes), ca.vertcat(*seeds), ca.vertcat(*weights), True)
        parts["adjoint"] = ca.vertsplit(
            back, [0, *np.cumsum([seed.shape[0] for seed in seeds]).tolist()]
        )
    whole = {name: ca.vertcat(*results) for name, results in parts.items()}
    hoisted = Hoisted(whole, model.p, ca.SX(0, 1), generic)
    alike = _in_pairs(model)
    states, inputs, numbers, modes = labels_of(hoisted, model, alike)
    outputs = tuple(alike.label(output.name) for output in model.outputs)
    behind = {
        "slopes": (states, inputs, numbers[: model.p.shape[0]]),
        "adjoint": (states, outputs, modes, states),
    }
    functions = {}
    for name, results in parts.items():
        function = hoisted.function(name, model, more=more.get(name, ()))
        packed = Packed(function, alike, (states, inputs, numbers, modes, *behind.get(name, ())))
        functions[name] = packed, tuple(part.shape[0] for part in results)
    derived = hoisted.derive(0)["derived"]
    assert isinstance(derived, ca.Function)
    functions = {"derived": _plain(derived), **functions}
    if law is not None:
        memory, measured, numbers = (
            ca.SX.sym(name, law.size1_in(i)) for i, name in enumerate(("l", "y", "g"))
        )
        functions["law"] = _plain(
            ca.Function(
                "law", [memory, measured, numbers], [law(memory, measured, numbers, ca.SX(0, 1))]
            )
        )
    return Graphs(model, functions, hoisted.scalars)


def _in_pairs(model: Model) -> Parts:
    """Group similar parts in pairs: vector registers of all 64-bit processors hold two doubles."""
    if not model.alike:
        return Parts((), ())
    prefixes, groups = model.alike
    return Parts(
        prefixes, tuple(group[i : i + 2] for group in groups for i in range(0, len(group), 2))
    )


def _plain(function: ca.Function) -> tuple[Packed, tuple[int, ...]]:
    """Pack a function without parts and with one result."""
    labels = (
        tuple((str(k), SHARED) for k in range(function.size1_in(i))) for i in range(function.n_in())
    )
    dense = ca.Function(
        function.name(), function.sx_in(), [ca.cse(ca.densify(function(*function.sx_in())))]
    )
    return Packed(dense, Parts((), ()), tuple(labels)), (function.size1_out(0),)


def source(graphs: Graphs) -> str:
    """Return the content of ``model.c``."""
    texts = ['#include "core.h"', "#include <math.h>", '#include "pairs.h"', ""]
    for name, (packed, sizes) in graphs.functions.items():
        takes, gives = (text.split() for text in _ARGUMENTS[name])
        texts.append(
            function_text(f"jn_{name}", packed, takes, dict(zip(gives, sizes, strict=True)))
        )
    return "\n".join(texts)


def header(
    graphs: Graphs,
    token: str,
    numbers: Mapping[str, Array],
    whole: Mapping[str, Sequence[int]],
    period: float,
    at_rest: bool,
) -> str:
    """Return the content of ``model.h``: counts, start values (x0, u0, p0, ...), arrays of numbers and indices.

    ``period`` is the control period, s; ``at_rest`` is the default of ``settings.start_at_rest``.
    """
    model = graphs.model
    counts = {
        "NX": model.x.shape[0],
        "NQ": len(model.coordinates),
        "NV": len(model.speeds),
        "NI": len(model.internal),
        "NC": len(model.constraints),
        "NT": len(model.tracks),
        "ORDER": model.track_order,
        "NU": model.u.shape[0],
        "NP": model.p.shape[0],
        "NE": graphs.extended,
        "NY": model.output.shape[0],
        "NM": len(model.switches),
        "NG": len(numbers["g0"]),
        "MEMORY": len(numbers["memory0"]),
        "MEASURED": len(whole["measured"]),
        "COMMANDS": len(whole["command"]),
        "PROJECTS": int(bool(model.projection.shape[0])),
        "AT_REST": int(at_rest),
        "ADJOINT": int("adjoint" in graphs.functions),
    }
    lines = [
        "#ifndef JN_MODEL_H",
        "#define JN_MODEL_H",
        f'#define JN_TOKEN "{token}"',
        f"#define JN_PERIOD {period!r}",
    ]
    lines += [f"#define JN_{name} {value}" for name, value in counts.items()]
    tables = [
        ("double", name, map(repr, map(float, values)), "0.0") for name, values in numbers.items()
    ]
    tables += [("int", name, map(str, values), "0") for name, values in whole.items()]
    for kind, name, values, none in tables:
        lines.append(f"static const {kind} jn_{name}[] = {{{', '.join(values) or none}}};")
    return "\n".join([*lines, "#endif", ""])
