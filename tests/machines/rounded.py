"""Which test files hang on another library's rounding: they are found, not listed.

They keep golden numbers, name linear algebra or an optimiser, or call a module of jounce that does.
"""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
SOURCES = ROOT / "src" / "jounce"
ROUNDING = ("numpy.linalg", "np.linalg", "scipy.linalg", "scipy.optimize")


@cache
def rounds(file: Path) -> bool:
    """Whether a file names what another library rounds otherwise."""
    text = file.read_text(encoding="utf-8")
    return any(word in text for word in ROUNDING)


@cache
def public() -> dict[str, str]:
    """Module of every public name."""
    tree = ast.parse((SOURCES / "__init__.pyi").read_text(encoding="utf-8"))
    imports = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.module]
    return {name.name: f"jounce.{node.module}" for node in imports for name in node.names}


def used_by(file: Path) -> set[str]:
    """Modules of jounce that a file calls."""
    found = set()
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("jounce."):
            found |= {node.module, *(f"{node.module}.{name.name}" for name in node.names)}
        elif (
            isinstance(node, ast.Attribute)
            and isinstance(node.value, ast.Name)
            and node.value.id == "jn"
        ):
            found.add(public().get(node.attr, ""))
    return found


def files_of(module: str) -> list[Path]:
    """Source of a module; of a package, all of its modules."""
    place = SOURCES.joinpath(*module.split(".")[1:])
    return (
        [place.with_suffix(".py")]
        if place.with_suffix(".py").is_file()
        else sorted(place.glob("*.py"))
    )


def is_rounded(test: Path, *, itself: bool = False) -> bool:
    """Whether a test's numbers hang on another library's rounding; of modules that it calls only without ``itself``."""
    if "golden" in test.parts or rounds(test):
        return True
    return not itself and any(
        rounds(file) for module in used_by(test) if module for file in files_of(module)
    )
