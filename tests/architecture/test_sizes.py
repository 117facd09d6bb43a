"""Names and sizes of modules and functions."""

from __future__ import annotations

from pathlib import Path

from rules import ROOT, SOURCE
from rules.sizes import name_problems, package_problems, size_problems


def test_names_say_what_lives_there() -> None:
    assert name_problems(SOURCE) == []
    assert package_problems(SOURCE) == []


def test_modules_and_functions_are_small() -> None:
    files = [file for folder in ("src", "tests") for file in (ROOT / folder).rglob("*.py")]
    assert files
    assert [problem for file in sorted(files) for problem in size_problems(file)] == []


def test_empty_names_are_noticed(tmp_path: Path) -> None:
    (tmp_path / "helpers").mkdir()
    (tmp_path / "helpers" / "springs.py").touch()
    (tmp_path / "utils.py").touch()
    assert [problem.rpartition("the name ")[2][:9] for problem in name_problems(tmp_path)] == ["'helpers'", "'utils' s"]


def test_folders_that_are_no_packages_are_noticed(tmp_path: Path) -> None:
    (tmp_path / "__init__.py").touch()
    (tmp_path / "roads").mkdir()
    (tmp_path / "roads" / "step.py").touch()
    assert package_problems(tmp_path) == [f"{tmp_path / 'roads'}: no __init__.py"]


def test_long_code_is_noticed(tmp_path: Path) -> None:
    long = tmp_path / "long.py"
    long.write_text("x = 1\n" * 501, encoding="utf-8")
    assert "501 lines" in size_problems(long)[0]
    wordy = tmp_path / "wordy.py"
    docstring = '    """Say."""\n'
    wordy.write_text(f"def f():\n{docstring}" + "    x = 1\n" * 60, encoding="utf-8")
    assert size_problems(wordy) == []
    wordy.write_text(f"def f():\n{docstring}" + "    x = 1\n" * 61, encoding="utf-8")
    assert "61 lines in its body" in size_problems(wordy)[0]
