"""Codes of findings in the sources, and the fields that each call fills in."""

from __future__ import annotations

import ast
import re
import string
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

CODE = re.compile(r"[a-z]+\.[a-z0-9_]+")


class Made(NamedTuple):
    """A call of `finding`: its code where it is written there, and the names it fills in; None where they are many."""

    where: str
    code: str | None
    names: set[str] | None


def made_in(file: Path) -> Iterator[Made]:
    """Every call of ``finding`` in a module."""
    for call in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "finding":
            names = {word.arg for word in call.keywords}
            known = None if None in names else {str(name) for name in names} - {"severity"}
            first = call.args[0]
            code = str(first.value) if isinstance(first, ast.Constant) else None
            yield Made(f"{file.name}:{call.lineno}", code, known)


def texts_in(file: Path) -> set[str]:
    """Texts of a module."""
    nodes = ast.walk(ast.parse(file.read_text(encoding="utf-8")))
    return {
        node.value
        for node in nodes
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    }


def codes_in(file: Path, packages: set[str]) -> set[str]:
    """Texts of a module that look like codes of packages, wherever they stand."""
    return {
        text
        for text in texts_in(file)
        if CODE.fullmatch(text) and text.partition(".")[0] in packages
    }


def fields_of(text: str) -> dict[str, str]:
    """Fields of a sentence with the format of each."""
    return {
        name: spec or "" for _, name, spec, _ in string.Formatter().parse(text) if name is not None
    }
