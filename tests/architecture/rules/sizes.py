"""Names and sizes: no drawers called `utils`, no module over 500 lines, no function body over 60."""

from __future__ import annotations

import ast
from pathlib import Path

FORBIDDEN_NAMES = {"utils", "util", "helpers", "helper", "manager", "managers", "data", "info", "misc", "common"}
MODULE_LINES, BODY_LINES = 500, 60
GENERATED = "# generated file"


def name_problems(source: Path) -> list[str]:
    """Modules and folders under ``source`` whose name says nothing."""
    return [
        f"{path}: the name {path.stem!r} says nothing about what lives there"
        for path in sorted(source.rglob("*"))
        if path.stem.lower() in FORBIDDEN_NAMES and (path.suffix == ".py" or path.is_dir())
    ]


def package_problems(source: Path) -> list[str]:
    """Folders with modules but without ``__init__.py``: the import contract would not see them."""
    folders = {file.parent for file in source.rglob("*.py")}
    return sorted(f"{folder}: no __init__.py" for folder in folders if not (folder / "__init__.py").is_file())


def size_problems(file: Path) -> list[str]:
    """A module that is too long, and functions whose body is (docstrings do not count)."""
    text = file.read_text(encoding="utf-8")
    if text.startswith(GENERATED):
        return []
    problems = []
    if (count := len(text.splitlines())) > MODULE_LINES:
        problems.append(f"{file}: {count} lines (limit {MODULE_LINES})")
    functions = [
        node for node in ast.walk(ast.parse(text)) if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))
    ]
    problems += [
        f"{file}:{node.lineno}: {node.name} has {size} lines in its body (limit {BODY_LINES})"
        for node in functions
        if (size := _body_lines(node)) > BODY_LINES
    ]
    return problems


def _body_lines(node: ast.FunctionDef | ast.AsyncFunctionDef) -> int:
    body = node.body[1:] if ast.get_docstring(node) and len(node.body) > 1 else node.body
    return (node.end_lineno or body[0].lineno) - body[0].lineno + 1
