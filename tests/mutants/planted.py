"""A module given from another text: here, and in the processes that this one starts (readers of files are isolated)."""

from __future__ import annotations

import importlib.abc
import importlib.machinery
import importlib.util
import os
import sys
from pathlib import Path


class Planted(importlib.machinery.SourceFileLoader, importlib.abc.MetaPathFinder):
    """Gives one module from a copy. Its code has the copy's name, for Numba keeps what it compiles by that file."""

    def __init__(self, name: str, file: str, copy: str) -> None:
        super().__init__(name, file)
        self.copy = copy

    def find_spec(self, name: str, *_: object) -> importlib.machinery.ModuleSpec | None:
        return (
            importlib.util.spec_from_file_location(name, self.path, loader=self)
            if name == self.name
            else None
        )

    def get_code(self, _: str) -> object:
        return compile(Path(self.copy).read_bytes(), self.copy, "exec")


def plant(name: str, file: Path, copy: Path) -> None:
    """Give a module from a copy of its file, which lies in a folder of its own."""
    sys.meta_path.insert(0, Planted(name, str(file), str(copy)))
    here, arguments = str(Path(__file__).parent), f"{name!r}, {str(file)!r}, {str(copy)!r}"
    (copy.parent / "sitecustomize.py").write_text(
        f"import sys\nsys.path.insert(0, {here!r})\nfrom planted import Planted\nsys.path.remove({here!r})\n"
        f"sys.meta_path.insert(0, Planted({arguments}))\n",
        encoding="utf-8",
    )
    paths = [str(copy.parent), *filter(None, [os.environ.get("PYTHONPATH")])]
    os.environ["PYTHONPATH"] = os.pathsep.join(paths)
