"""Messages of findings as templates, read from the sources that make them: `#` stands for what is filled in."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator
from itertools import product
from pathlib import Path

SAYING = {"Finding": 2, "_warn": 1}
"""Which argument of a call is a message."""


def templates_of(file: Path) -> set[str]:
    """Every message that a module can give a finding; what comes from elsewhere is only `#`, and left out."""
    found: set[str] = set()
    for scope in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(scope, ast.FunctionDef):
            set_to = sorted(_texts(scope), key=lambda one: one[0])
            for call in ast.walk(scope):
                if isinstance(call, ast.Call) and getattr(call.func, "id", "") in SAYING:
                    place = SAYING[call.func.id]  # type: ignore[attr-defined]
                    known = {name: value for line, name, value in set_to if line < call.lineno}  # the last before it
                    if len(call.args) > place:
                        found |= set(_said(call.args[place], known))
    return {re.sub("#+", "#", one) for one in found if one.strip("#; ")}


def template_of(sentence: str) -> tuple[str, list[str]]:
    """Give a format with named fields as a template, and the names in their order."""
    names: list[str] = re.findall(r"\{(\w+)[^}]*\}", sentence)
    return re.sub(r"\{\w+[^}]*\}", "#", sentence), names


def _texts(scope: ast.FunctionDef) -> Iterator[tuple[int, str, ast.expr]]:
    """Lines in which names are set to texts; those that are set with others at once may be anything."""
    assigned = [one for one in ast.walk(scope) if isinstance(one, ast.Assign)]
    several = {
        part.id for one in assigned for part in getattr(one.targets[0], "elts", ()) if isinstance(part, ast.Name)
    }
    for one in assigned:
        if isinstance(one.targets[0], ast.Name) and one.targets[0].id not in several and _is_text(one.value):
            yield one.lineno, one.targets[0].id, one.value


def _is_text(value: ast.expr) -> bool:
    if isinstance(value, ast.IfExp):
        return _is_text(value.body) and _is_text(value.orelse)
    if isinstance(value, ast.BinOp):
        return _is_text(value.left) or _is_text(value.right)
    return isinstance(value, ast.JoinedStr) or (isinstance(value, ast.Constant) and isinstance(value.value, str))


def _said(value: ast.expr, texts: dict[str, ast.expr]) -> Iterable[str]:
    if isinstance(value, ast.Constant):
        return [str(value.value)]
    if isinstance(value, ast.FormattedValue):
        return _said(value.value, texts) if _is_said(value.value, texts) else ["#"]
    if isinstance(value, ast.JoinedStr):
        return ["".join(parts) for parts in product(*(_said(part, texts) for part in value.values))]
    if isinstance(value, ast.BinOp) and isinstance(value.op, ast.Add):
        return [a + b for a, b in product(_said(value.left, texts), _said(value.right, texts))]
    if isinstance(value, ast.IfExp):
        return [*_said(value.body, texts), *_said(value.orelse, texts)]
    if isinstance(value, ast.Name) and value.id in texts:
        return _said(texts[value.id], {name: one for name, one in texts.items() if name != value.id})
    return ["#"]


def _is_said(value: ast.expr, texts: dict[str, ast.expr]) -> bool:
    return (isinstance(value, ast.IfExp) and _is_text(value)) or (isinstance(value, ast.Name) and value.id in texts)


def german_of(english: str, german: str) -> tuple[str, str] | None:
    """Give a sentence with named fields as templates, the fields of the German one numbered as those of the English.

    What says nothing itself, and what the German one gives from elsewhere, has none.
    """
    template, names = template_of(english)
    if len(re.sub("[^a-z]", "", template)) < 12 or not set(template_of(german)[1]) <= set(names):
        return None
    return template, re.sub(r"\{(\w+)[^}]*\}", lambda field: f"#{names.index(field[1]) + 1}", german)
