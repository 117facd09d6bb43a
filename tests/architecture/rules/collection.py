"""Every test that is written is run: a file whose name pytest does not collect is found."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path


def written_tests(folder: Path) -> set[str]:
    """Tests on disk under ``folder``, in any file and at any depth, as ``file::name``."""
    return {
        f"{file.relative_to(folder)}::{name}"
        for file in folder.rglob("*.py")
        for name in _test_names(ast.parse(file.read_text(encoding="utf-8")), "")
    }


def _test_names(node: ast.AST, prefix: str) -> list[str]:
    names = []
    for child in ast.iter_child_nodes(node):
        inside = prefix
        if isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            inside = f"{prefix}{child.name}::"
            if not isinstance(child, ast.ClassDef) and child.name.startswith("test_"):
                names.append(f"{prefix}{child.name}")
        names += _test_names(child, inside)
    return names


def collected_tests(folder: Path, *, configuration: Path) -> set[str]:
    """Tests that pytest collects under ``folder``, slow ones too, as ``file::name``."""
    command = [sys.executable, "-m", "pytest", "--collect-only", "-q", "-p", "no:cacheprovider"]
    command += [
        "-c",
        str(configuration),
        f"--rootdir={folder}",
        "-m",
        "slow or not slow",
        str(folder),
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder)
    if done.returncode not in (0, 5):  # 5: nothing was collected
        raise AssertionError(done.stdout + done.stderr)
    return {re.sub(r"\[.*", "", line) for line in done.stdout.splitlines() if "::" in line}


def collection_problems(
    folder: Path, *, configuration: Path, collected: set[str] | None = None
) -> list[str]:
    """Tests that are written but never run; ``collected`` where a run knows what pytest collects there."""
    missing = written_tests(folder) - (
        collected or collected_tests(folder, configuration=configuration)
    )
    return sorted(f"{name}: written but not collected by pytest" for name in missing)
