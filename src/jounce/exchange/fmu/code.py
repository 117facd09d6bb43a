"""Conversion of expression graphs to C: one constant per value; equal operations on two parts form pairs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import chain

from jounce.kernel.packing import Emission, Packed

_NUMBERS = {
    "ASSIGN": "{0}", "ADD": "{0} + {1}", "SUB": "{0} - {1}", "MUL": "{0} * {1}", "DIV": "{0} / {1}", "NEG": "-{0}",
    "SQ": "{0} * {0}", "TWICE": "{0} + {0}", "INV": "1.0 / {0}", "LT": "{0} < {1}", "LE": "{0} <= {1}",
    "EQ": "{0} == {1}", "NE": "{0} != {1}", "NOT": "{0} == 0.0", "AND": "{0} != 0.0 && {1} != 0.0",
    "OR": "{0} != 0.0 || {1} != 0.0", "IF_ELSE_ZERO": "{0} != 0.0 ? {1} : 0.0",
    "SIGN": "{0} > 0.0 ? 1.0 : {0} < 0.0 ? -1.0 : {0}", "CONSTPOW": "pow({0}, {1})",
    **{name.upper(): f"{name}({{0}})" for name in (
        "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "sqrt", "exp", "log", "log1p", "expm1",
        "fabs", "floor", "ceil",
    )},
    **{name.upper(): f"{name}({{0}}, {{1}})" for name in ("pow", "fmin", "fmax", "copysign", "atan2", "hypot")},
}  # fmt: skip
"""C expression of each scalar operation."""
_PAIRS = {
    "ASSIGN": "{0}", "ADD": "plus({0}, {1})", "SUB": "minus({0}, {1})", "MUL": "times({0}, {1})",
    "DIV": "over({0}, {1})", "SQ": "times({0}, {0})", "TWICE": "plus({0}, {0})", "NEG": "negative({0})",
    "INV": "over(both(1.0, 1.0), {0})", "BOTH": "both({0}, {1})",
}  # fmt: skip
"""C expression of each operation on pairs; all others are scalar."""

_LONG = 1_000_000  # characters of a function: above it, GCC needs a minute to allocate registers


class _Statements:
    """Converts a function to statements; values are names, constants, or elements of arguments."""

    def __init__(self, arguments: Sequence[str]) -> None:
        self._arguments = arguments
        self._made: list[tuple[str, str, str, list[str]]] = []  # type, name, operation, operands

    def constant(self, value: float) -> str:
        text = {"inf": "INFINITY", "-inf": "-INFINITY", "nan": "NAN"}.get(
            repr(float(value)), repr(float(value))
        )
        return f"({text})" if text.startswith("-") else text

    def load(self, argument: int, element: int) -> str:
        return f"{self._arguments[argument]}[{element}]"

    def load_wide(self, offset: int, count: int) -> str:
        return self.gather([self.load(2, offset + k) for k in range(count)])

    def scalar(self, operation: str, values: list[str]) -> str:
        name = operation.removeprefix("OP_")
        if name not in _NUMBERS:
            raise NotImplementedError(f"the operation {operation} has no form in C")
        return self._new("double", name, values)

    def wide(self, operation: str, values: list[str]) -> str | None:
        name = operation.removeprefix("OP_")
        return self._new("pair", name, values) if name in _PAIRS else None

    def lane(self, vector: str, lane: int) -> str:
        return f"at({vector}, {lane})"

    def gather(self, values: list[str]) -> str:
        return self._new("pair", "BOTH", values)

    def _new(self, kind: str, operation: str, values: list[str]) -> str:
        self._made.append((kind, f"{kind[0]}{len(self._made)}", operation, values))
        return self._made[-1][1]

    def lines(self) -> list[str]:
        """Return the statements; a common divisor is inverted once because a division costs ten multiplications."""
        divisors = Counter(
            values[1] for _, _, operation, values in self._made if operation == "DIV"
        )
        inverted: dict[str, str] = {}
        result = []
        for kind, name, operation, values in self._made:
            forms = _NUMBERS if kind == "double" else _PAIRS
            text = forms[operation].format(*values)
            if operation == "DIV" and divisors[values[1]] > 1:
                above, below = values
                if below not in inverted:
                    inverted[below] = f"i{len(inverted)}"
                    result.append(f"const {kind} {inverted[below]} = {forms['INV'].format(below)};")
                text = forms["MUL"].format(above, inverted[below])
            result.append(f"const {kind} {name} = {text};")
        return result


def function_text(name: str, packed: Packed, takes: Sequence[str], gives: Mapping[str, int]) -> str:
    """Return C code of a function with arguments ``takes``, and consecutive results ``gives`` with their sizes."""
    statements = _Statements(takes)
    emission = Emission(packed, statements)
    places = list(
        chain.from_iterable(
            [f"{result}[{i}]" for i in range(size)] for result, size in gives.items()
        )
    )
    results = [
        f"{places[element]} = {emission.number(node)};"
        for element, node in packed.graph.results.items()
    ]
    parameters = [f"const double *restrict {word}" for word in takes] + [
        f"double *restrict {word}" for word in gives
    ]
    unused = " ".join(f"(void){word};" for word in (*takes, *gives))
    body = "\n    ".join([unused, *statements.lines(), *results])
    kind = "JN_LONG " if len(body) > _LONG else ""
    return f"{kind}void {name}({', '.join(parameters)}) {{\n    {body}\n}}\n"
