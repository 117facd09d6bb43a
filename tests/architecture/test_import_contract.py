"""The import contract of pyproject.toml holds, and breaking it is noticed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from rules import CONFIGURATION, ROOT, packages_below
from rules.circles import import_circle

PACKAGES = sorted(folder.parent.name for folder in (ROOT / "src" / "jounce").glob("*/__init__.py"))
RUN = "from importlinter.cli import lint_imports_command as run; run(['--no-cache'])"


def lint_imports(folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", RUN]
    return subprocess.run(
        command,
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, **environment},
    )


def test_contract_holds() -> None:
    done = lint_imports(ROOT)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "3 kept, 0 broken" in done.stdout


def test_everything_below_the_kernel_but_core_is_forbidden_to_it() -> None:
    forbidden = CONFIGURATION["tool"]["importlinter"]["contracts"][1]["forbidden_modules"]
    assert set(forbidden) == {f"jounce.{name}" for name in packages_below("kernel")} - {
        "jounce.core"
    }


def test_every_other_package_is_forbidden_to_the_papers() -> None:
    forbidden = CONFIGURATION["tool"]["importlinter"]["contracts"][2]["forbidden_modules"]
    assert set(forbidden) == {f"jounce.{name}" for name in PACKAGES} - {"jounce.papers"}


@pytest.mark.parametrize(
    ("importer", "imported", "contract"),
    [
        ("core", "papers", "A package imports only packages that stand before it BROKEN"),
        ("roads", "kernel", "A package imports only packages that stand before it BROKEN"),
        ("kernel", "parts", "The kernel knows numbers only BROKEN"),
        ("papers", "roads", "The papers use what is public BROKEN"),
    ],
)
def test_broken_contract_is_noticed(
    tmp_path: Path, importer: str, imported: str, contract: str
) -> None:
    (tmp_path / "pyproject.toml").write_text(
        (ROOT / "pyproject.toml").read_text(encoding="utf-8"), encoding="utf-8"
    )
    for package in PACKAGES:
        (tmp_path / "jounce" / package).mkdir(parents=True)
        (tmp_path / "jounce" / package / "__init__.py").write_text("", encoding="utf-8")
    (tmp_path / "jounce" / "__init__.py").write_text("", encoding="utf-8")
    code = f"def later():\n    from jounce.{imported} import anything\n"
    (tmp_path / "jounce" / importer / "work.py").write_text(code, encoding="utf-8")
    done = lint_imports(tmp_path, PYTHONPATH=str(tmp_path))
    assert done.returncode == 1
    assert contract in done.stdout


def test_no_modules_import_each_other() -> None:
    assert import_circle(ROOT / "src" / "jounce") == []


@pytest.mark.parametrize(
    "back",
    [
        "from jounce.roads.first import anything",
        "from jounce.roads import first",
        "from . import first",
        "from jounce.roads import anything",
        "def later():\n    from jounce.roads.first import anything",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from jounce.roads.first import anything",
    ],
)
def test_circles_are_noticed(tmp_path: Path, back: str) -> None:
    folder = tmp_path / "jounce" / "roads"
    folder.mkdir(parents=True)
    (tmp_path / "jounce" / "__init__.py").write_text("", encoding="utf-8")
    (folder / "__init__.py").write_text("", encoding="utf-8")
    (folder / "__init__.pyi").write_text(
        "from .first import anything as anything\n", encoding="utf-8"
    )
    (folder / "first.py").write_text("import jounce.roads.second\n", encoding="utf-8")
    (folder / "second.py").write_text("", encoding="utf-8")
    assert import_circle(tmp_path / "jounce") == []
    (folder / "second.py").write_text(back + "\n", encoding="utf-8")
    assert set(import_circle(tmp_path / "jounce")) == {"jounce.roads.first", "jounce.roads.second"}
