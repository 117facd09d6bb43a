"""Where a package may be changed, and how: the operators of Cosmic Ray, at places that decide a number or a verdict."""

from __future__ import annotations

import ast
import difflib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import parso.python.tree
from cosmic_ray.ast import ast_nodes, get_ast
from cosmic_ray.mutating import mutate_code
from cosmic_ray.operators.number_replacer import NumberReplacer
from cosmic_ray.plugins import get_operator

TURNED = (
    *(
        f"ReplaceBinaryOperator_{pair}"
        for pair in ("Add_Sub", "Sub_Add", "Mul_Div", "Div_Mul", "FloorDiv_Mul", "Mod_Mul")
    ),
    *(f"ReplaceBinaryOperator_{pair}" for pair in ("Pow_Mul", "BitAnd_BitOr", "BitOr_BitAnd")),
    *(
        f"ReplaceComparisonOperator_{pair}"
        for pair in ("Lt_Gt", "Gt_Lt", "LtE_GtE", "GtE_LtE", "Eq_NotEq", "NotEq_Eq")
    ),
    *(f"ReplaceComparisonOperator_{pair}" for pair in ("Is_IsNot", "IsNot_Is")),
    *(
        "ReplaceUnaryOperator_Delete_USub",
        "ReplaceUnaryOperator_Delete_Not",
        "ReplaceUnaryOperator_Delete_Invert",
    ),
    *(
        "ReplaceTrueWithFalse",
        "ReplaceFalseWithTrue",
        "ReplaceAndWithOr",
        "ReplaceOrWithAnd",
        "AddNot",
    ),
)
"""Operators of Cosmic Ray. ``<`` is not made ``<=``: of floats that changes nothing, of counts a constant does it."""

HARMLESS_ARGUMENTS = {
    "strict",
    "stacklevel",
    "frozen",
    "slots",
    "kw_only",
    "repr",
    "compare",
    "copy",
    "maxsize",
}
NO_OPERATORS = {"parameters", "dictorsetmaker"}
"""Where a star stands before keyword arguments, and two before a table: not what Cosmic Ray takes them for."""
TINY = 1e-7
"""Constants below it are tolerances and guards against a division by zero: 7 % more of them is the same."""


class Constant(NumberReplacer):
    """A whole number is one more, any other 7 % more: Cosmic Ray's own "one more" would leave 2e5 as it is."""

    def mutation_positions(self, node: object) -> Iterator[tuple[object, object]]:
        """The one position of a number, unless it is tiny."""
        if isinstance(node, parso.python.tree.Number) and (
            isinstance(_value(node), int) or abs(_value(node)) > TINY
        ):
            yield node.start_pos, node.end_pos

    def mutate(self, node: parso.python.tree.Number, _: int) -> parso.python.tree.Number:
        """The same node with another number."""
        value = _value(node)
        changed: complex = value + 1
        if isinstance(value, complex):
            changed = complex(0.0, float(f"{value.imag * 1.07:.12g}"))
        elif isinstance(value, float):
            changed = float(f"{value * 1.07:.12g}") or 1.0
        return parso.python.tree.Number(repr(changed), node.start_pos, node.prefix)


def _value(node: parso.python.tree.Number) -> complex:
    return ast.literal_eval(node.value)


OPERATORS = {"Constant": Constant} | {name: get_operator(f"core/{name}") for name in TURNED}


@dataclass(frozen=True, order=True)
class Mutant:
    """One change of one file: the operator's name and which of its places in the file."""

    file: Path
    line: int
    column: int
    operator: str
    occurrence: int

    @property
    def source(self) -> str:
        """The changed file."""
        return mutate_code(_text(self.file), OPERATORS[self.operator](), self.occurrence)

    @property
    def change(self) -> tuple[str, str]:
        """What stood on the changed lines, and what stands there now."""
        before, after = _text(self.file).splitlines(), self.source.splitlines()
        changes = [
            code
            for code in difflib.SequenceMatcher(None, before, after, False).get_opcodes()
            if code[0] != "equal"
        ]
        first, last = changes[0], changes[-1]
        return _joined(before[first[1] : last[2]]), _joined(after[first[3] : last[4]])


def _joined(lines: list[str]) -> str:
    return " ".join(line.strip() for line in lines)


@cache
def _text(file: Path) -> str:
    return file.read_text(encoding="utf-8")


def mutants(files: list[Path]) -> list[Mutant]:
    """All mutants of some files, in order."""
    return sorted(mutant for file in files for mutant in _mutants_of(file))


def _mutants_of(file: Path) -> Iterator[Mutant]:
    nodes = list(ast_nodes(get_ast(_text(file))))
    left_out = _left_out(ast.parse(_text(file)), _text(file).splitlines())
    for name, operator in OPERATORS.items():
        places = (
            (node, place) for node in nodes for place, _ in operator().mutation_positions(node)
        )
        for occurrence, (node, (line, column)) in enumerate(places):
            is_none = node.parent is not None and node.parent.type in NO_OPERATORS
            if not is_none and not any(start <= (line, column) < end for start, end in left_out):
                yield Mutant(file, line, column, name, occurrence)


def _left_out(tree: ast.Module, lines: list[str]) -> list[tuple[tuple[int, int], tuple[int, int]]]:
    """Spans that decide no number: annotations, errors, texts, how classes are made, what only type checkers read."""
    found: list[ast.AST | None] = []
    for node in ast.walk(tree):
        match node:
            case ast.AnnAssign():
                found.append(node.annotation)
            case ast.arg():
                found.append(node.annotation)
            case ast.FunctionDef(name="__str__" | "__repr__"):
                found.append(node)
            case ast.FunctionDef():
                found.append(node.returns)
            case ast.ClassDef():
                found += node.decorator_list
            case ast.Raise() | ast.JoinedStr():
                found.append(node)
            case ast.Call(func=ast.Name(id="isinstance")):
                found.append(node)
            case ast.keyword(arg=name) if name in HARMLESS_ARGUMENTS:
                found.append(node)
            case ast.If(test=ast.Name(id="TYPE_CHECKING")):
                found.append(node)
            case ast.Assign() if node in tree.body:  # names for types
                found += [
                    part
                    for part in ast.walk(node)
                    if isinstance(part, ast.BinOp) and isinstance(part.op, ast.BitOr)
                ]

    def place(line: int, offset: int) -> tuple[int, int]:
        return line, len(lines[line - 1].encode()[:offset].decode())

    return [
        (place(node.lineno, node.col_offset), place(node.end_lineno, node.end_col_offset))
        for node in found
        if node
    ]
