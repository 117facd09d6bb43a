"""Messages of findings as templates, read from the sources that make them: `#` stands for what is filled in."""

from __future__ import annotations

import ast
import re
from collections.abc import Collection, Iterable, Iterator
from itertools import product
from pathlib import Path

Texts = dict[str, list[ast.expr]]
"""What a name may have been set to."""


def templates_of(file: Path, but: Collection[str] = ()) -> set[str]:
    """Every message that a module, but some functions, gives a finding; what comes from elsewhere is left out."""
    found: set[str] = set()
    if "Finding(" not in (text := file.read_text(encoding="utf-8")):
        return found
    tree = ast.parse(text)
    constants = {name: [value] for _, name, value in _texts(tree)}
    saying = {"Finding": 2} | dict(_sayers(tree))
    for scope in ast.walk(tree):
        if isinstance(scope, ast.FunctionDef) and scope.name not in but:
            set_to, since = sorted(_texts(scope), key=lambda one: one[0]), 0
            calls = [one for one in ast.walk(scope) if isinstance(one, ast.Call) and _called(one) in saying]
            for call in sorted(calls, key=lambda one: one.lineno):
                if len(call.args) > (place := saying[_called(call)]):
                    before = [one for one in set_to if one[0] < call.lineno]
                    known = constants | {name: [value] for _, name, value in before}
                    for _, name, value in (one for one in before if one[0] > since):  # one of these, whichever it was
                        known[name] = [*(one for one in known[name] if one is not value), value]
                    found |= set(_said(call.args[place], known))
                since = call.lineno
    return {re.sub("#+", "#", one) for one in found if one.strip("#:;. ")}


def progress_of(file: Path) -> set[str]:
    """Every text with which a module says how far it is, as templates."""
    found: set[str] = set()
    for scope in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(scope, ast.FunctionDef):
            texts: Texts = {}
            for _, name, value in _texts(scope):
                texts.setdefault(name, []).append(value)
            for call in ast.walk(scope):
                if isinstance(call, ast.Call) and _called(call) in ("told", "progress", "say") and len(call.args) == 1:
                    what = call.args[0]
                    found |= set(_said(what.body if isinstance(what, ast.Lambda) else what, texts))
    return {re.sub("#+", "#", one) for one in found if one.strip("#:;. ")}


def _called(call: ast.Call) -> str:
    return getattr(call.func, "id", getattr(call.func, "attr", ""))


def _sayers(tree: ast.Module) -> Iterator[tuple[str, int]]:
    """Functions that make a finding of a message they are given, and which of their arguments it is."""
    for scope in ast.walk(tree):
        if not isinstance(scope, ast.FunctionDef):
            continue
        names = [one.arg for one in scope.args.args if one.arg != "self"]
        for call in ast.walk(scope):
            if isinstance(call, ast.Call) and _called(call) == "Finding" and len(call.args) > 2:
                message = getattr(call.args[2], "id", "")
                if message in names:
                    yield scope.name, names.index(message)


def template_of(sentence: str) -> tuple[str, list[str]]:
    """Give a format with named fields as a template, and the names in their order."""
    names: list[str] = re.findall(r"\{(\w+)[^}]*\}", sentence)
    return re.sub(r"\{\w+[^}]*\}", "#", sentence), names


def _texts(scope: ast.FunctionDef | ast.Module) -> Iterator[tuple[int, str, ast.expr]]:
    """Lines in which names are set to texts; those that are set with others at once may be anything."""
    inside = list(scope.body if isinstance(scope, ast.Module) else ast.walk(scope))
    assigned = [one for one in inside if isinstance(one, ast.Assign)]
    several = {
        part.id for one in assigned for part in getattr(one.targets[0], "elts", ()) if isinstance(part, ast.Name)
    }
    for one in assigned:
        if isinstance(one.targets[0], ast.Name) and one.targets[0].id not in several and _is_text(one.value):
            yield one.lineno, one.targets[0].id, one.value
    for more in inside:
        if isinstance(more, ast.AugAssign) and isinstance(more.target, ast.Name) and _is_text(more.value):
            so_far = ast.Name(more.target.id, ast.Load())
            yield more.lineno, more.target.id, ast.BinOp(so_far, ast.Add(), more.value)


def _is_text(value: ast.expr) -> bool:
    if isinstance(value, ast.IfExp):
        return _is_text(value.body) and _is_text(value.orelse)
    if isinstance(value, ast.BinOp):
        return _is_text(value.left) or _is_text(value.right)
    return isinstance(value, ast.JoinedStr) or (isinstance(value, ast.Constant) and isinstance(value.value, str))


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
    if isinstance(value, ast.Call) and _called(value) == "format" and isinstance(value.func, ast.Attribute):
        return [re.sub(r"\{[^}]*\}", "#", one) for one in _said(value.func.value, texts)]
    if isinstance(value, ast.Call) and _called(value) == "replace" and isinstance(value.func, ast.Attribute):
        return _said(value.func.value, texts)
    if isinstance(value, ast.Name) and value.id in texts:
        each = texts[value.id]
        left = [texts | {value.id: [other for other in each if other is not one]} for one in each]
        return [text for one, others in zip(each, left, strict=True) for text in _said(one, others)]
    return ["#"]


def _is_said(value: ast.expr, texts: Texts) -> bool:
    return (isinstance(value, ast.IfExp) and _is_text(value)) or (isinstance(value, ast.Name) and value.id in texts)


def german_of(english: str, german: str, least: int = 12) -> tuple[str, str] | None:
    """Give a sentence with named fields as templates, the fields of the German one numbered as those of the English.

    What says nothing itself, less than so many letters, and what the German one gives from elsewhere, has none.
    """
    template, names = template_of(english)
    if len(re.sub("[^a-z]", "", template)) < least or not set(template_of(german)[1]) <= set(names):
        return None
    return template, re.sub(r"\{(\w+)[^}]*\}", lambda field: f"#{names.index(field[1]) + 1}", german)
