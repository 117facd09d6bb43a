"""The text of a formula: read as a tree, with names in backquotes."""

from __future__ import annotations

import ast
import re
from collections.abc import Sequence

from jounce.core.errors import DescriptionError

_LONGEST, _MOST_NODES = 1000, 300
_QUOTED = re.compile(r"`([^`\n]{1,200})`")


def channels_in(formula: str, names: Sequence[str]) -> list[str]:
    """Return which of some names a formula uses."""
    tree, quoted = parse_formula(formula)
    used = {
        name_in(node, quoted)
        for node in ast.walk(tree)
        if isinstance(node, ast.Name | ast.Attribute)
    }
    return [name for name in names if name in used]


def parse_formula(formula: str) -> tuple[ast.expr, list[str]]:
    """Read a formula; names in backquotes are replaced by placeholders."""
    quoted: list[str] = []

    def stand_in(match: re.Match[str]) -> str:
        quoted.append(match[1])
        return f" _{len(quoted) - 1}_ "

    text = formula.strip()
    if len(text) > _LONGEST:
        raise DescriptionError("the formula is too long", allowed=f"{_LONGEST}", where="formula")
    try:
        tree = ast.parse(_QUOTED.sub(stand_in, text).strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        place = getattr(error, "offset", None)
        raise DescriptionError(
            "the formula cannot be read",
            where=text or "formula",
            found=text[max(0, place - 1) :][:40] if place else None,
            hint="Write for example: lowpass(sprung.az, '20 Hz') / '1 g'. Names with spaces are in backquotes.",
        ) from None
    if sum(1 for _ in ast.walk(tree)) > _MOST_NODES:
        raise DescriptionError("the formula is too long", allowed=f"{_MOST_NODES}", where=text)
    return tree, quoted


def name_in(node: ast.AST, quoted: Sequence[str]) -> str:
    """Return the dotted name of a node; empty if it is none."""
    if isinstance(node, ast.Name):
        match = re.fullmatch(r"_(\d+)_", node.id)
        return quoted[int(match[1])] if match and int(match[1]) < len(quoted) else node.id
    if isinstance(node, ast.Attribute):
        before = name_in(node.value, quoted)
        return f"{before}.{node.attr}" if before else ""
    return ""
