"""Names: no drawers called `utils`, no folders that the import contract would not see."""

from __future__ import annotations

from pathlib import Path

from rules import SCRIPTS

FORBIDDEN_NAMES = {
    "utils",
    "util",
    "helpers",
    "helper",
    "manager",
    "managers",
    "data",
    "info",
    "misc",
    "common",
}


def name_problems(source: Path) -> list[str]:
    """Modules and folders under ``source`` whose name says nothing."""
    return [
        f"{path}: the name {path.stem!r} says nothing about what lives there"
        for path in sorted(source.rglob("*"))
        if path.stem.lower() in FORBIDDEN_NAMES and (path.suffix == ".py" or path.is_dir())
    ]


def package_problems(source: Path) -> list[str]:
    """Folders with modules but without ``__init__.py``: the import contract would not see them."""
    folders = {file.parent for file in source.rglob("*.py") if SCRIPTS not in file.parents}
    return sorted(
        f"{folder}: no __init__.py" for folder in folders if not (folder / "__init__.py").is_file()
    )
