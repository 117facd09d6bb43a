"""Export of a rig's equations of motion: mass matrix, forces and constraints."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Annotated, ClassVar

import casadi as ca

from jounce.core.operation import File, Switch, operation
from jounce.core.serialise import Plain
from jounce.core.turns import once
from jounce.core.writing import Formats
from jounce.exchange.expressions import (
    LATEX,
    PYTHON,
    Language,
    Written,
    identifiers,
    latex_name,
    write_expressions,
)
from jounce.mechanics.facts import speed_of
from jounce.models import build
from jounce.parts import Rig, as_rig
from jounce.parts.options import AnyRig

RESULTS = ("M", "Q", "G", "gamma", "dq", "dz")
_MEANING = {
    "M": "mass matrix",
    "Q": "forces: applied, gyroscopic and gravity",
    "G": "Jacobian of the loop equations",
    "gamma": "second rate of the loop equations at zero acceleration",
    "dq": "rates of the coordinates",
    "dz": "rates of the internal states",
}


@dataclass(frozen=True)
class Equations(Plain):
    """Equations of motion ``M a = Q + G^T lambda``, ``G a + gamma = 0``, ``dq/dt = dq``; all SI.

    ``x`` are coordinates, speeds and internal states, ``u`` inputs with their rates, ``p`` parameters of the rig,
    ``m`` modes (1 for a tyre or stop in contact), ``a`` the rates of the speeds, and ``lambda`` the constraint forces
    of the loops.

    Attributes
    ----------
    name : str
        Name of the rig.
    coordinates, speeds, internal, inputs, parameters, modes, constraints : tuple of str
        Names in the order of symbols and rows.
    numbers : dict
        Values of the parameters, SI.
    function : casadi.Function
        Function of (x, u, p, m) that returns M, Q, G, gamma, dq and dz.

    Examples
    --------
    >>> import jounce as jn
    >>> found = jn.equations(jn.load("kart-quarter-car"))
    >>> found.speeds, [str(size) for size in found.function.sx_out(0).shape]
    (('sprung.vz', 'unsprung.vz'), ['2', '2'])
    """

    left_out: ClassVar[tuple[str, ...]] = ("function",)
    name: str
    coordinates: tuple[str, ...]
    speeds: tuple[str, ...]
    internal: tuple[str, ...]
    inputs: tuple[str, ...]
    parameters: tuple[str, ...]
    modes: tuple[str, ...]
    constraints: tuple[str, ...]
    numbers: dict[str, float]
    function: ca.Function = field(repr=False, compare=False)

    @property
    def arguments(self) -> dict[str, tuple[str, ...]]:
        """Names of the elements of x, u, p and m."""
        states = (*self.coordinates, *self.speeds, *self.internal)
        return {"x": states, "u": self.inputs, "p": self.parameters, "m": self.modes}

    @once
    def _graph(self) -> ca.Function:
        """Function with common subexpressions eliminated."""
        symbols = [ca.SX.sym(name, len(names)) for name, names in self.arguments.items()]
        whole = self.function(*symbols)
        ends = [0]
        for part in whole:
            ends.append(ends[-1] + part.numel())
        flat = ca.cse(ca.vertcat(*(ca.densify(ca.vec(part)) for part in whole)))
        pieces = [ca.sparsify(flat[a:b]) for a, b in pairwise(ends)]
        return ca.Function("equations", symbols, pieces)

    def _write(
        self, names: list[list[str]], language: Language
    ) -> tuple[Written, list[tuple[int, int]]]:
        shapes = [self.function.size_out(i) for i in range(len(RESULTS))]
        return write_expressions(self._graph, names, language), shapes

    def latex(self) -> str:
        """Return the equations as body of a LaTeX document: definitions of repeated expressions, then the matrices."""
        names = [[latex_name(name) for name in group] for group in self.arguments.values()]
        code, shapes = self._write(names, LATEX)
        lines = [f"% {self.name}: M a = Q + G^T lambda, G a + gamma = 0; SI"]
        lines += [
            rf"\begin{{equation*}} {name} = {text} \end{{equation*}}"
            for name, text in code.definitions
        ]
        symbols = {"gamma": r"\gamma", "dq": r"\dot q", "dz": r"\dot z"}
        for result, shape, elements in zip(RESULTS, shapes, code.results, strict=True):
            if not elements:
                continue
            rows = [" & ".join(elements[i :: shape[0]]) for i in range(shape[0])]
            body = r" \\ ".join(rows)
            lines.append(f"% {_MEANING[result]}")
            symbol = symbols.get(result, result)
            lines.append(
                rf"\begin{{equation*}} {symbol} = \begin{{pmatrix}} {body} \end{{pmatrix}} \end{{equation*}}"
            )
        return "\n".join(lines) + "\n"

    def sympy(self) -> str:
        """Return a Python module with the equations as SymPy expressions; running it requires SymPy."""
        groups = self.arguments
        names = [identifiers(group, "mode_" if key == "m" else "") for key, group in groups.items()]
        taken = [name for group in names for name in group]
        identifiers(taken)
        code, shapes = self._write(names, PYTHON)
        functions = (
            "Abs, Eq, Matrix, Max, Min, Ne, Piecewise, Symbol, acos, asin, atan, atan2, cos, "
            "cosh, exp, log, sign, "
        )
        lines = [
            f'"""{self.name}: M a = Q + G.T lambda, G a + gamma = 0, dq/dt = dq; SI."""',
            "",
            f"from sympy import {functions}sin, sinh, sqrt, tan, tanh",
            "",
        ]
        for key, group, own in zip(groups, groups.values(), names, strict=True):
            lines += [
                f"{name} = Symbol({theirs!r}, real=True)"
                for name, theirs in zip(own, group, strict=True)
            ]
            lines += [f"{key} = Matrix([{', '.join(own)}])", ""]
        lines += [f"numbers = {self.numbers!r}  # of p, by name", ""]
        lines += [f"{name} = {text}" for name, text in code.definitions]
        for result, shape, elements in zip(RESULTS, shapes, code.results, strict=True):
            rows = [f"[{', '.join(elements[i :: shape[0]])}]" for i in range(shape[0])]
            content = f"[{', '.join(rows)}]" if elements else f"{shape[0]}, {shape[1]}, []"
            lines.append(f"{result} = Matrix({content})  # {_MEANING[result]}")
        return "\n".join(lines) + "\n"

    def c(self) -> str:
        """Return C code generated by CasADi, with the order of the elements in a comment."""
        generator = ca.CodeGenerator("equations.c")
        generator.add(self._graph)
        head = [
            f"/* {self.name}: M a = Q + G^T lambda, G a + gamma = 0; SI, column by column, zeros left out."
        ]
        head += [f"   {key}: {', '.join(names)}" for key, names in self.arguments.items() if names]
        head += [f"   {result}: {_MEANING[result]}" for result in RESULTS]
        return "\n".join(head) + f" */\n{_BEGIN}{generator.dump()}{_END}"


_BEGIN = """/* Generated by CasADi; what stems from its runtime is free of copyright or under MIT-0. */
#ifdef __cplusplus
extern "C" {
#endif

"""
_END = """#ifdef __cplusplus
} /* extern "C" */
#endif
"""


@operation(
    "export equations",
    named={"changes": "set", "path": "out"},
    echo={"rig": "rig", "out": "out"},
    page="jounce.report.exchange:equations_page",
    title="{rig}",
    doing="writing the equations",
    example="jounce export equations kart-quarter-car --out kart.tex",
)
def write_equations(
    rig: AnyRig,
    path: Annotated[Path | str, File("File to write: .tex, .py (SymPy), .c or .casadi.", "FILE")],
    *,
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
) -> Equations:
    """Write the equations of motion of a rig: mass matrix, forces and constraints.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name.
    path : Path or str
        File to write: LaTeX (``.tex``), SymPy (``.py``), C (``.c``) or CasADi (``.casadi``).
    force : bool
        Overwrite an existing file.

    Returns
    -------
    Equations
        The equations, as from :func:`equations`, SI.

    Raises
    ------
    OutputError
        For a different suffix, or an existing file.

    Examples
    --------
    >>> import tempfile
    >>> write_equations("kart-quarter-car", tempfile.mkdtemp() + "/kart.tex").inputs
    ('road.z', 'road.vz')
    """
    EQUATION_FORMATS.check(path, force=force)
    formed = equations(as_rig(rig))
    EQUATION_FORMATS.write(formed, path, force=force)
    return formed


def equations(rig: Rig) -> Equations:
    """Return the equations of motion that :func:`jounce.simulate` integrates, as symbols.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.

    Returns
    -------
    Equations
        Mass matrix, forces and constraints (SI) as a CasADi function, and as text: ``latex()``, ``sympy()``, ``c()``.

    Examples
    --------
    >>> import jounce as jn
    >>> found = equations(jn.load("kart-quarter-car"))
    >>> M, Q, *_ = found.function([0, 0, 0, 0], [0, 0], list(found.numbers.values()), [0])
    >>> [round(float(mass), 2) for mass in (M[0, 0], M[1, 1])]   # kg
    [16.0, 5.0]
    """
    model = build(rig)
    balance, n_q, n_v = model.balance, len(model.coordinates), len(model.speeds)
    unknown, residual = balance.unknown, balance.residual
    acceleration = unknown[:n_v]
    nothing = ca.DM.zeros(unknown.shape[0], 1)
    force = ca.substitute(residual, unknown, nothing)
    loops = residual.shape[0] - n_v
    gradient = ca.jacobian(residual[n_v:], acceleration) if loops else ca.SX(0, n_v)
    results = [
        -ca.jacobian(residual[:n_v], acceleration),
        force[:n_v],
        gradient,
        force[n_v:],
        balance.rate[:n_q],
        ca.substitute(balance.rate[n_q + n_v :], unknown, nothing),
    ]
    symbols = [model.x, model.u, model.p, model.m]
    function = ca.Function(
        "equations", symbols, [ca.densify(part) for part in results], list("xupm"), list(RESULTS)
    )
    order = model.track_order
    inputs = [name for track in model.tracks for name in _inputs(track)[:order]]
    values = rig.parameters()
    constraints = tuple(str(name) for name in model.constraints)
    return Equations(
        str(getattr(rig, "name", "") or getattr(rig, "model", "") or type(rig).__name__),
        model.coordinates, model.speeds, model.internal, tuple(inputs), model.parameters, model.switches, constraints,
        {path: float(values[path]) for path in model.parameters}, function,
    )  # fmt: skip


def _inputs(track: str) -> tuple[str, str, str]:
    rate = speed_of(track)
    return track, rate, f"{rate} rate"


def _writer(text: Callable[[Equations], str]) -> Callable[[Equations, Path], object]:
    return lambda formed, file: file.write_text(text(formed), encoding="utf-8", newline="\n")


def _casadi(formed: Equations) -> str:
    """Return the function as ``casadi.Function.load`` reads it; CasADi itself does not detect a full disk."""
    serializer = ca.StringSerializer()
    serializer.pack(formed.function)
    return str(serializer.encode())


EQUATION_FORMATS = Formats(
    "equations",
    {
        ".tex": _writer(Equations.latex),
        ".py": _writer(Equations.sympy),
        ".c": _writer(Equations.c),
        ".casadi": _writer(_casadi),
    },
)
"""Formats of equations: LaTeX, a Python module for SymPy, C, and a CasADi function."""
