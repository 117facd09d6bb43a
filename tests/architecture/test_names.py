"""Names of modules and folders."""

from __future__ import annotations

from pathlib import Path

from rules import SOURCE
from rules.names import name_problems, package_problems


def test_names_say_what_lives_there() -> None:
    assert name_problems(SOURCE) == []
    assert package_problems(SOURCE) == []


def test_empty_names_are_noticed(tmp_path: Path) -> None:
    (tmp_path / "helpers").mkdir()
    (tmp_path / "helpers" / "springs.py").touch()
    (tmp_path / "utils.py").touch()
    assert [problem.rpartition("the name ")[2][:9] for problem in name_problems(tmp_path)] == [
        "'helpers'",
        "'utils' s",
    ]


def test_folders_that_are_no_packages_are_noticed(tmp_path: Path) -> None:
    (tmp_path / "__init__.py").touch()
    (tmp_path / "roads").mkdir()
    (tmp_path / "roads" / "step.py").touch()
    assert package_problems(tmp_path) == [f"{tmp_path / 'roads'}: no __init__.py"]
