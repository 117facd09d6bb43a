"""Every test on disk is run, and the strictness of the configuration bites."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from rules import ROOT
from rules.collection import collection_problems, written_tests

CONFIGURATION = ROOT / "pyproject.toml"


def test_every_written_test_is_collected(collected: set[str] | None) -> None:
    known = {name.removeprefix("tests/") for name in collected} if collected else None
    assert len(written_tests(ROOT / "tests")) > 20
    assert collection_problems(ROOT / "tests", configuration=CONFIGURATION, collected=known) == []


def test_uncollected_tests_are_noticed(tmp_path: Path) -> None:
    (tmp_path / "test_good.py").write_text("def test_one(): pass\n", encoding="utf-8")
    (tmp_path / "check_lost.py").write_text("def test_two(): pass\n", encoding="utf-8")
    nested = (
        "class Rig:\n    def test_three(self): pass\n\ndef outer():\n    def test_four(): pass\n"
    )
    (tmp_path / "test_nested.py").write_text(nested, encoding="utf-8")
    assert [
        problem.partition(": ")[0]
        for problem in collection_problems(tmp_path, configuration=CONFIGURATION)
    ] == [
        "check_lost.py::test_two",
        "test_nested.py::Rig::test_three",
        "test_nested.py::outer::test_four",
    ]


def run_pytest(file: Path) -> str:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-c", CONFIGURATION]
    command += [f"--rootdir={file.parent}", file]
    return subprocess.run(
        command, capture_output=True, text=True, check=False, cwd=file.parent
    ).stdout


def test_returned_values_and_warnings_fail(tmp_path: Path) -> None:
    file = tmp_path / "test_bad.py"
    returns, warns = "def test_returns(): return True\n", "def test_warns(): warnings.warn('x')\n"
    file.write_text(f"import warnings\n{returns}{warns}def test_good(): pass\n", encoding="utf-8")
    assert "2 failed, 1 passed" in run_pytest(file)


def test_misspelt_marker_fails(tmp_path: Path) -> None:
    file = tmp_path / "test_bad.py"
    file.write_text("import pytest\n@pytest.mark.slwo\ndef test_marked(): pass\n", encoding="utf-8")
    assert "'slwo' not found in `markers`" in run_pytest(file)
