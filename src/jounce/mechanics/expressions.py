"""Validate names, numbers and expressions that users pass to a builder."""

from __future__ import annotations

from numbers import Real

import casadi as ca
import numpy as np

from jounce.core.errors import AssemblyError
from jounce.core.phrases import Phrase
from jounce.core.units import to_si


def check_name(name: object, where: str = "") -> str:
    """Refuse invalid names: other types, empty text, and blanks around a name."""
    if isinstance(name, str) and name and name == name.strip():
        return name
    named = getattr(name, "name", None)
    hint = (
        Phrase("Give the name, {named!r}.", named=named)
        if isinstance(named, str) and not isinstance(name, str)
        else ""
    )
    text = name if isinstance(name, str) else type(name).__name__
    raise AssemblyError(
        "invalid name",
        where=where,
        found=text,
        allowed="text without leading or trailing blanks",
        hint=hint,
    )


def expression_of(value: object, where: str, unit: str = "1") -> ca.SX:
    """Convert one or more expressions, numbers (SI) or texts with a unit to an expression."""
    if isinstance(value, ca.SX | ca.DM):
        return ca.SX(value)
    if isinstance(value, str | Real):
        return ca.SX(to_si(value, unit, where=where))
    if (
        isinstance(value, list | tuple | np.ndarray)
        and len(np.shape(np.asarray(value, dtype=object))) == 1
    ):
        return ca.vertcat(*(expression_of(part, where, unit) for part in value))
    allowed = (
        Phrase("numbers in {unit} or with their unit, or expressions of casadi.SX", unit=unit)
        if unit != "1"
        else "casadi.SX"
    )
    raise AssemblyError(
        "not an expression", where=where, found=type(value).__name__, allowed=allowed
    )


def vector_of(value: object, where: str, unit: str = "m") -> ca.SX:
    """Convert three expressions, numbers (SI) or texts with a unit to a vector expression."""
    vector = expression_of(value, where, unit)
    if vector.shape != (3, 1):
        raise AssemblyError(
            "invalid vector",
            where=where,
            found=f"{vector.numel()} numbers",
            allowed="three: x, y, z",
        )
    return vector


def text_of(expression: ca.SX) -> str:
    """Write an expression with all digits; repeated parts are ``@1``, ``@2``."""
    symbols = ca.symvar(expression)
    function = ca.Function("text", symbols, [ca.densify(expression)])
    count = function.n_instructions()
    codes = [function.instruction_id(k) for k in range(count)]
    uses = [0] * count
    makers: dict[int, int] = {}
    for k, code in enumerate(codes):
        if code not in (ca.OP_CONST, ca.OP_INPUT):
            for register in function.instruction_input(k):
                uses[makers[register]] += 1
        if code != ca.OP_OUTPUT:
            makers[function.instruction_output(k)[0]] = k
    register_texts: dict[int, str] = {}
    again: list[str] = []
    x, y = ca.SX.sym("x"), ca.SX.sym("y")
    for k, code in enumerate(codes):
        if code == ca.OP_OUTPUT:
            break
        if code == ca.OP_CONST:
            text = repr(function.instruction_constant(k)).removesuffix(".0")
        elif code == ca.OP_INPUT:
            text = symbols[function.instruction_input(k)[0]].name()
        else:
            given = [register_texts[register] for register in function.instruction_input(k)]
            operation = ca.SX.binary(code, x, y) if len(given) == 2 else ca.SX.unary(code, x)
            text = ca.print_operator(operation, given)
            if uses[k] > 1:
                again.append(f"@{len(again) + 1} = {text}")
                text = f"@{len(again)}"
        register_texts[function.instruction_output(k)[0]] = text
    return ", ".join([*again, register_texts[function.instruction_input(count - 1)[0]]])
