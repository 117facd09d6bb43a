"""Conversion of CasADi graphs to text: LaTeX, or Python for SymPy."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import casadi as ca

from jounce.core.errors import OutputError

_SUM, _PRODUCT, _SIGN, _POWER, _ATOM = range(5)  # precedence of the parts of an expression
_OPERATIONS = {
    getattr(ca, f"OP_{name}"): name
    for name in (
        "ADD", "SUB", "MUL", "DIV", "NEG", "SQ", "TWICE", "INV", "SQRT", "POW", "CONSTPOW", "EXP", "LOG", "SIN", "COS",
        "TAN", "ASIN", "ACOS", "ATAN", "ATAN2", "SINH", "COSH", "TANH", "FABS", "SIGN", "COPYSIGN", "FMIN", "FMAX",
        "LT", "LE", "EQ", "NE", "NOT", "AND", "OR", "IF_ELSE_ZERO", "ASSIGN",
    )
}  # fmt: skip


@dataclass(frozen=True)
class _Node:
    """Operation on earlier nodes, or a leaf with a text."""

    kind: str
    operands: tuple[int, ...] = ()
    text: str = ""


Part = tuple[str, int]
"""Text of an expression, and its precedence."""


@dataclass(frozen=True)
class Language:
    """Notation of operations, numbers and repeated expressions."""

    write: Callable[[str, Sequence[Part]], Part]
    number: Callable[[float], str]
    shared: Callable[[int], str]


@dataclass(frozen=True)
class Written:
    """Definitions of repeated expressions in order, and the elements of each result by column."""

    definitions: tuple[tuple[str, str], ...]
    results: tuple[tuple[str, ...], ...]


def write_expressions(
    function: ca.Function, names: Sequence[Sequence[str]], language: Language
) -> Written:
    """Convert a function to text; ``names`` are the names of the elements of each argument."""
    nodes, results = _nodes(function, names, language.number)
    uses = [0] * len(nodes)
    for node in nodes:
        for operand in node.operands:
            uses[operand] += 1
    for row in results:
        for index in row:
            uses[index] += index >= 0
    parts: list[Part] = []
    definitions: list[tuple[str, str]] = []
    for node, count in zip(nodes, uses, strict=True):
        part = (
            (node.text, _ATOM)
            if not node.kind
            else language.write(node.kind, [parts[i] for i in node.operands])
        )
        if node.kind and count > 1:
            name = language.shared(len(definitions) + 1)
            definitions.append((name, part[0]))
            part = name, _ATOM
        parts.append(part)
    zero = language.number(0.0)
    result = tuple(tuple(parts[i][0] if i >= 0 else zero for i in row) for row in results)
    return Written(tuple(definitions), result)


def _nodes(
    function: ca.Function, names: Sequence[Sequence[str]], number: Callable[[float], str]
) -> tuple[list[_Node], list[list[int]]]:
    """Return unique operations, and the node index of each element of the results; -1 for zero."""
    nodes: list[_Node] = []
    at: dict[int, int] = {}  # work vector index to the node stored there last
    results = [[-1] * function.numel_out(i) for i in range(function.n_out())]
    for k in range(function.n_instructions()):
        kind, left, right = (
            function.instruction_id(k),
            function.instruction_output(k),
            function.instruction_input(k),
        )
        if kind == ca.OP_OUTPUT:
            result, element = left
            row, column = function.sparsity_out(result).get_triplet()
            shape = function.size_out(result)
            results[result][row[element] + shape[0] * column[element]] = at[right[0]]
            continue
        if kind == ca.OP_INPUT:
            node = _Node("", text=names[right[0]][right[1]])
        elif kind == ca.OP_CONST:
            node = _Node("", text=number(function.instruction_constant(k)))
        elif kind in _OPERATIONS:
            node = _Node(_OPERATIONS[kind], tuple(at[i] for i in right))
        else:
            raise OutputError(
                "an operation that cannot be written as text", where="equations", found=kind
            )
        nodes.append(node)
        at[left[0]] = len(nodes) - 1
    return nodes, results


def _in_brackets(part: Part, least: int) -> str:
    """Return a part, in brackets if its precedence requires them."""
    return part[0] if part[1] >= least else f"({part[0]})"


# --- Python for SymPy


_CALLS = {
    "SQRT": "sqrt", "EXP": "exp", "LOG": "log", "SIN": "sin", "COS": "cos", "TAN": "tan", "ASIN": "asin",
    "ACOS": "acos", "ATAN": "atan", "ATAN2": "atan2", "SINH": "sinh", "COSH": "cosh", "TANH": "tanh", "FABS": "Abs",
    "SIGN": "sign", "FMIN": "Min", "FMAX": "Max",
}  # fmt: skip
_CONDITIONS = {
    "LT": "{0} < {1}", "LE": "{0} <= {1}", "EQ": "Eq({0}, {1})", "NE": "Ne({0}, {1})", "NOT": "Eq({0}, 0)",
    "AND": "Ne({0}*{1}, 0)", "OR": "Ne(Abs({0}) + Abs({1}), 0)",
}  # fmt: skip


def _python(kind: str, parts: Sequence[Part]) -> Part:
    texts = [part[0] for part in parts]
    if kind in _CALLS:
        return f"{_CALLS[kind]}({', '.join(texts)})", _ATOM
    if kind in _CONDITIONS:
        condition = _CONDITIONS[kind].format(*(_in_brackets(part, _POWER) for part in parts))
        return f"Piecewise((1, {condition}), (0, True))", _ATOM
    forms: dict[str, Callable[..., Part]] = {
        "ADD": lambda a, b: (f"{a[0]} + {b[0]}", _SUM),
        "SUB": lambda a, b: (f"{a[0]} - {_in_brackets(b, _PRODUCT)}", _SUM),
        "MUL": lambda a, b: (f"{_in_brackets(a, _PRODUCT)}*{_in_brackets(b, _PRODUCT)}", _PRODUCT),
        "DIV": lambda a, b: (f"{_in_brackets(a, _PRODUCT)}/{_in_brackets(b, _POWER)}", _PRODUCT),
        "NEG": lambda a: (f"-{_in_brackets(a, _POWER)}", _SUM),
        "SQ": lambda a: (f"{_in_brackets(a, _ATOM)}**2", _POWER),
        "TWICE": lambda a: (f"2*{_in_brackets(a, _PRODUCT)}", _PRODUCT),
        "INV": lambda a: (f"1/{_in_brackets(a, _POWER)}", _PRODUCT),
        "POW": lambda a, b: (f"{_in_brackets(a, _ATOM)}**{_in_brackets(b, _ATOM)}", _POWER),
        "CONSTPOW": lambda a, b: (f"{_in_brackets(a, _ATOM)}**{_in_brackets(b, _ATOM)}", _POWER),
        "COPYSIGN": lambda a, b: (f"Abs({a[0]})*sign({b[0]})", _PRODUCT),
        "IF_ELSE_ZERO": lambda a, b: (f"Piecewise(({b[0]}, Ne({a[0]}, 0)), (0, True))", _ATOM),
        "ASSIGN": lambda a: a,
    }
    return forms[kind](*parts)


def _python_number(value: float) -> str:
    text = repr(int(value)) if value == int(value) and abs(value) < 1e15 else repr(value)
    return f"({text})" if value < 0.0 else text


PYTHON = Language(_python, _python_number, lambda i: f"w{i}")
"""Expressions as Python, with the names of SymPy's functions."""


# --- LaTeX


_WORDS = {
    "EXP": r"\exp", "LOG": r"\ln", "SIN": r"\sin", "COS": r"\cos", "TAN": r"\tan", "ASIN": r"\arcsin",
    "ACOS": r"\arccos", "ATAN": r"\arctan", "SINH": r"\sinh", "COSH": r"\cosh", "TANH": r"\tanh",
    "SIGN": r"\operatorname{sgn}", "ATAN2": r"\operatorname{atan2}", "FMIN": r"\min", "FMAX": r"\max",
    "COPYSIGN": r"\operatorname{copysign}",
}  # fmt: skip
_RELATIONS = {"LT": "<", "LE": r"\le", "EQ": "=", "NE": r"\ne", "AND": r"\wedge", "OR": r"\vee"}


def _latex(kind: str, parts: Sequence[Part]) -> Part:
    def around(part: Part, least: int) -> str:
        return part[0] if part[1] >= least else rf"\left({part[0]}\right)"

    texts = [part[0] for part in parts]
    if kind in _WORDS:
        return rf"{_WORDS[kind]}\left({', '.join(texts)}\right)", _ATOM
    if kind in _RELATIONS:
        return rf"\left[{texts[0]} {_RELATIONS[kind]} {texts[1]}\right]", _ATOM
    forms: dict[str, Callable[..., Part]] = {
        "ADD": lambda a, b: (
            f"{a[0]} + {b[0]}" if not b[0].startswith("-") else f"{a[0]} {b[0]}",
            _SUM,
        ),
        "SUB": lambda a, b: (f"{a[0]} - {around(b, _PRODUCT)}", _SUM),
        "MUL": lambda a, b: (rf"{around(a, _PRODUCT)} \, {around(b, _PRODUCT)}", _PRODUCT),
        "DIV": lambda a, b: (rf"\frac{{{a[0]}}}{{{b[0]}}}", _PRODUCT),
        "NEG": lambda a: (f"-{around(a, _PRODUCT)}", _SUM),
        "SQ": lambda a: (f"{{{around(a, _ATOM)}}}^{{2}}", _POWER),
        "TWICE": lambda a: (rf"2 \, {around(a, _PRODUCT)}", _PRODUCT),
        "INV": lambda a: (rf"\frac{{1}}{{{a[0]}}}", _PRODUCT),
        "POW": lambda a, b: (f"{{{around(a, _ATOM)}}}^{{{b[0]}}}", _POWER),
        "CONSTPOW": lambda a, b: (f"{{{around(a, _ATOM)}}}^{{{b[0]}}}", _POWER),
        "SQRT": lambda a: (rf"\sqrt{{{a[0]}}}", _ATOM),
        "FABS": lambda a: (rf"\left|{a[0]}\right|", _ATOM),
        "NOT": lambda a: (rf"\left[{a[0]} = 0\right]", _ATOM),
        "IF_ELSE_ZERO": lambda a, b: (rf"{around(a, _PRODUCT)} \, {around(b, _PRODUCT)}", _PRODUCT),
        "ASSIGN": lambda a: a,
    }
    return forms[kind](*parts)


def _latex_number(value: float) -> str:
    mantissa, _, power = f"{value:.12g}".partition("e")
    text = mantissa if not power else rf"{mantissa} \cdot 10^{{{int(power)}}}"
    return rf"\left({text}\right)" if value < 0.0 else text


LATEX = Language(_latex, _latex_number, lambda i: f"w_{{{i}}}")
"""Expressions as LaTeX; a comparison is 1 if true and 0 otherwise."""


def latex_name(name: str) -> str:
    r"""Return a LaTeX symbol for a name of the rig.

    >>> print(latex_name("upper_arm.angle rate"))
    \mathrm{upper\_arm.angle\ rate}
    """
    plain = name.replace("_", r"\_").replace(" ", r"\ ")
    return rf"\mathrm{{{plain}}}"


def identifiers(names: Sequence[str], prefix: str = "") -> list[str]:
    """Convert names of a rig to Python identifiers; refuse a collision.

    >>> identifiers(["tyre.force", "mode of tyre"])
    ['tyre_force', 'mode_of_tyre']
    """
    made = [prefix + "".join(sign if sign.isalnum() else "_" for sign in name) for name in names]
    twice = sorted({name for name in made if made.count(name) > 1})
    if twice:
        raise OutputError(
            "two names are the same in Python", where="equations", found=", ".join(twice)
        )
    return made
