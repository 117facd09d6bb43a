"""The rules of the house as functions: each gives a list of problems, empty when the rule holds."""

from __future__ import annotations

import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SOURCE = ROOT / "src" / "jounce"
SCRIPTS = SOURCE / "frozen" / "hooks"
"""Where files are no modules: PyInstaller runs them."""
CONFIGURATION = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def module_name(file: Path) -> str:
    """Name of the module that a file under ``src`` is."""
    parts = file.relative_to(SOURCE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def modules() -> list[str]:
    """Names of all modules of the product."""
    files = [
        file
        for file in SOURCE.rglob("*.py")
        if file.name != "__main__.py" and SCRIPTS not in file.parents
    ]
    return sorted(map(module_name, files))


def packages_below(name: str) -> list[str]:
    """Packages that stand before ``name`` in the import order, lowest first, as far as they exist."""
    layers = CONFIGURATION["tool"]["importlinter"]["contracts"][0]["layers"]
    order = [layer.strip("()") for layer in reversed(layers)]
    return [
        package
        for package in order[: order.index(name)]
        if (SOURCE / package / "__init__.py").is_file()
    ]
