"""Texts that say how far a job is, as templates read from their sources: `#` stands for what is filled in."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator
from itertools import product
from pathlib import Path

Texts = dict[str, list[ast.expr]]
"""What a name may have been set to."""


def progress_of(file: Path) -> set[str]:
    """Every text with which a module says how far it is, as templates."""
    found: set[str] = set()
    for scope in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(scope, ast.FunctionDef):
            texts: Texts = {}
            for _, name, value in _texts(scope):
                texts.setdefault(name, []).append(value)
            for call in ast.walk(scope):
                if (
                    isinstance(call, ast.Call)
                    and _called(call) in ("report_work", "progress", "say")
                    and len(call.args) == 1
                ):
                    what = call.args[0]
                    found |= set(_said(what.body if isinstance(what, ast.Lambda) else what, texts))
    return {re.sub("#+", "#", one) for one in found if one.strip("#:;. ")}


def _called(call: ast.Call) -> str:
    return getattr(call.func, "id", getattr(call.func, "attr", ""))


def _texts(scope: ast.FunctionDef | ast.Module) -> Iterator[tuple[int, str, ast.expr]]:
    """Lines in which names are set to texts; those that are set with others at once may be anything."""
    inside = list(scope.body if isinstance(scope, ast.Module) else ast.walk(scope))
    assigned = [one for one in inside if isinstance(one, ast.Assign)]
    several = {
        part.id
        for one in assigned
        for part in getattr(one.targets[0], "elts", ())
        if isinstance(part, ast.Name)
    }
    for one in assigned:
        if (
            isinstance(one.targets[0], ast.Name)
            and one.targets[0].id not in several
            and _is_text(one.value)
        ):
            yield one.lineno, one.targets[0].id, one.value
    for more in inside:
        if (
            isinstance(more, ast.AugAssign)
            and isinstance(more.target, ast.Name)
            and _is_text(more.value)
        ):
            so_far = ast.Name(more.target.id, ast.Load())
            yield more.lineno, more.target.id, ast.BinOp(so_far, ast.Add(), more.value)


def _is_text(value: ast.expr) -> bool:
    if isinstance(value, ast.IfExp):
        return _is_text(value.body) and _is_text(value.orelse)
    if isinstance(value, ast.BinOp):
        return _is_text(value.left) or _is_text(value.right)
    return isinstance(value, ast.JoinedStr) or (
        isinstance(value, ast.Constant) and isinstance(value.value, str)
    )


def _said(value: ast.expr, texts: Texts) -> Iterable[str]:
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
    if (
        isinstance(value, ast.Call)
        and _called(value) == "format"
        and isinstance(value.func, ast.Attribute)
    ):
        return [re.sub(r"\{[^}]*\}", "#", one) for one in _said(value.func.value, texts)]
    if isinstance(value, ast.Call) and _called(value) in ("Stage", "progress_through", "Phrase"):
        return [re.sub(r"\{[^}]*\}", "#", one) for one in _said(value.args[0], texts)]
    if (
        isinstance(value, ast.Call)
        and _called(value) == "replace"
        and isinstance(value.func, ast.Attribute)
    ):
        return _said(value.func.value, texts)
    if isinstance(value, ast.Name) and value.id in texts:
        each = texts[value.id]
        left = [texts | {value.id: [other for other in each if other is not one]} for one in each]
        return [text for one, others in zip(each, left, strict=True) for text in _said(one, others)]
    return ["#"]


def _is_said(value: ast.expr, texts: Texts) -> bool:
    return (isinstance(value, ast.IfExp) and _is_text(value)) or (
        isinstance(value, ast.Name) and value.id in texts
    )
