"""Import circles between modules, also those for types only, inside functions and through names of a lazy package."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path


def import_circle(package: Path) -> list[str]:
    """Modules of one circle, the first at both ends; empty where there is none.

    A name that a package hands on counts as taken from the module that has it, so the packages' own files are left out.
    """
    modules = {_module(file, package): file for file in package.rglob("*.py")}
    handed_on: dict[str, dict[str, tuple[str, str]]] = {}
    for file in package.rglob("__init__.py*"):
        handed_on.setdefault(_module(file, package), {}).update(_handed_on(file, package))
    graph = {
        name: {home for home in _homes(file, package, modules, handed_on) if home != name}
        for name, file in modules.items()
        if file.name != "__init__.py"
    }
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


def _module(file: Path, package: Path) -> str:
    return ".".join(file.relative_to(package.parent).with_suffix("").parts).removesuffix(
        ".__init__"
    )


def _imports(file: Path, package: Path) -> Iterator[tuple[str, str, str]]:
    """Module, name in it and name here of everything that a file imports, wherever in it."""
    here = _module(file, package).split(".")
    inside = here if file.name.startswith("__init__.") else here[:-1]
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from ((alias.name, "", "") for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            above = inside[: len(inside) - node.level + 1] if node.level else []
            module = ".".join([*above, *([node.module] if node.module else [])])
            yield from ((module, alias.name, alias.asname or alias.name) for alias in node.names)


def _handed_on(file: Path, package: Path) -> Iterator[tuple[str, tuple[str, str]]]:
    yield from ((here, (module, name)) for module, name, here in _imports(file, package) if here)


def _homes(
    file: Path,
    package: Path,
    modules: dict[str, Path],
    handed_on: dict[str, dict[str, tuple[str, str]]],
) -> Iterator[str]:
    """Modules whose names a file uses."""
    for module, name, _ in _imports(file, package):
        while handed_on.get(module, {}).get(name, (module, name)) != (module, name):
            module, name = handed_on[module][name]  # noqa: PLW2901
        for candidate in (f"{module}.{name}", module):
            if candidate in modules and modules[candidate].name != "__init__.py":
                yield candidate
                break
