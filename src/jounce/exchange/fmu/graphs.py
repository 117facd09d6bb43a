"""A model as C: its functions as CasADi writes them, behind the plain names that ``c/core.h`` declares."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from jounce.core.types import Array
from jounce.mechanics.model import Model
from jounce.mechanics.tangents import tangent

_ARGUMENTS = {  # C name to arguments and results, in the order of core.h
    "derived": ("p", "e"),
    "rate": ("x u e m", "dx"),
    "output": ("x u e m", "y"),
    "switch": ("x u e m", "z"),
    "project": ("x u e m", "out"),
    "loops": ("x u e m", "value rate"),
    "slopes": ("x u p m sx su sp", "dx y z on"),
    "adjoint": ("x u p m dx y z on", "sx su sp"),
    "law": ("memory measured g", "out"),
}
_SPOTLESS = """#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-variable"
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#endif
"""  # what is generated holds functions and arguments that not every model needs


@dataclass(frozen=True)
class Graphs:
    """The functions of a model by their names in C; ``extended`` counts the parameters with what depends on them."""

    model: Model
    functions: dict[str, ca.Function]
    extended: int


def graphs_of(model: Model, law: ca.Function | None = None, *, adjoint: bool = True) -> Graphs:
    """Write a model out as functions; what depends on parameters alone is taken out of them and computed once.

    ``law`` is a controller's function of (memory, measurements and time, numbers, nothing). ``adjoint`` adds the
    transposed derivatives.
    """
    n, projects = model.x.shape[0], bool(model.projection.shape[0])
    parts = {"rate": model.rate, "output": model.output, "switch": model.switch}
    if projects:
        parts["project"] = ca.vertcat(model.projection[n:], model.projection[:n])
    whole = ca.cse(ca.densify(ca.vertcat(*parts.values())))
    left, symbols, values = ca.extract_parametric(whole, model.p)
    ends = np.cumsum([0, *(part.shape[0] for part in parts.values())]).tolist()
    e = ca.vertcat(model.p, *symbols)
    functions = {
        name: _function(name, [model.x, model.u, e, model.m], [left[begin:end]])
        for name, begin, end in zip(parts, ends[:-1], ends[1:], strict=True)
    }
    functions["derived"] = _function("derived", [model.p], [ca.vertcat(model.p, *values)])
    loops = (model.constraint, model.balance.constraint_rate) if model.constraints else (ca.SX(0, 1), ca.SX(0, 1))
    known = ca.vertcat(model.p, *(ca.SX.sym("derived") for _ in symbols))
    functions["loops"] = _function("loops", [model.x, model.u, known, model.m], list(loops))
    seeds = [ca.SX.sym(f"d{name}", getattr(model, name).shape[0]) for name in "xup"]
    along = tangent(model, *seeds)
    results = [along.rate, along.output, along.switch, along.projection if projects else ca.SX(n, 1)]
    where = [model.x, model.u, model.p, model.m]
    functions["slopes"] = _function("slopes", [*where, *seeds], results)
    if adjoint:
        weights = [ca.SX.sym(f"weight{i}", part.shape[0]) for i, part in enumerate(results)]
        back = ca.jtimes(ca.vertcat(*results), ca.vertcat(*seeds), ca.vertcat(*weights), True)
        functions["adjoint"] = _function("adjoint", [*where, *weights], ca.vertsplit(back, _ends(seeds)))
    if law is not None:
        memory, measured, numbers = (ca.SX.sym(name, law.size1_in(i)) for i, name in enumerate(("l", "y", "g")))
        functions["law"] = _function("law", [memory, measured, numbers], [law(memory, measured, numbers, ca.SX(0, 1))])
    return Graphs(model, functions, e.shape[0])


def _ends(parts: Sequence[ca.SX]) -> list[int]:
    return [int(end) for end in np.cumsum([0, *(part.shape[0] for part in parts)])]


def _function(name: str, arguments: list[ca.SX], results: list[ca.SX]) -> ca.Function:
    # Plain names such as `switch` would be words of C.
    return ca.Function(f"graph_{name}", arguments, ca.cse([ca.densify(part) for part in results]))


def source(graphs: Graphs) -> str:
    """Text of ``model.c``."""
    generator = ca.CodeGenerator("model.c", {"with_header": False, "include_math": True})
    for function in graphs.functions.values():
        generator.add(function)
    lines = [_SPOTLESS, "#define CASADI_SYMBOL_EXPORT static", generator.dump(), '#include "core.h"', ""]
    for name, function in graphs.functions.items():
        takes, gives = (text.split() for text in _ARGUMENTS[name])
        signature = ", ".join([f"const double *{word}" for word in takes] + [f"double *{word}" for word in gives])
        lines += [
            f"void jn_{name}({signature}) {{",
            f"    const double *arg[{max(function.sz_arg(), len(takes))}] = {{{', '.join(takes)}}};",
            f"    double *res[{max(function.sz_res(), len(gives))}] = {{{', '.join(gives)}}};",
            f"    {function.name()}(arg, res, 0, 0, 0);",  # its locals are its work
            "}",
        ]
    return "\n".join(lines) + "\n"


def header(
    graphs: Graphs,
    token: str,
    numbers: Mapping[str, Array],
    whole: Mapping[str, Sequence[int]],
    period: float,
    at_rest: bool,
) -> str:
    """Text of ``model.h``: counts, start values (x0, u0, p0, ...), lists of numbers and of indices.

    ``period`` is that of the controller, s; ``at_rest`` says whether it starts in equilibrium unless told otherwise.
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
    lines = ["#ifndef JN_MODEL_H", "#define JN_MODEL_H", f'#define JN_TOKEN "{token}"', f"#define JN_PERIOD {period!r}"]
    lines += [f"#define JN_{name} {value}" for name, value in counts.items()]
    tables = [("double", name, map(repr, map(float, values)), "0.0") for name, values in numbers.items()]
    tables += [("int", name, map(str, values), "0") for name, values in whole.items()]
    for kind, name, values, none in tables:
        lines.append(f"static const {kind} jn_{name}[] = {{{', '.join(values) or none}}};")
    return "\n".join([*lines, "#endif", ""])
