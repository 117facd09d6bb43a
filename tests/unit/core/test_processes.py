"""Workers are refused at once where they could not begin: in a script without main guard, and in a pool's worker."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ASK = "from jounce.core.processes import check_workers\nprint('begins')\n"
CALL = "check_workers()\n"
GUARD = 'if __name__ == "__main__":\n    '
IN_A_FUNCTION = "def main():\n    check_workers()\n"
SWEEP = """import jounce as jn
trial = jn.Trial(road=jn.Step(height="10 mm"), speed="3 m/s", duration="0.1 s")
jn.simulate_many("kart-quarter-car", trial, {"sprung.mass": [15.0, 16.0]}, metrics="rms sprung.az", out="o", workers=2)
"""
IN_A_POOL = """import multiprocessing
from jounce.core.processes import refusal
def work(_):
    return str(refusal())
if __name__ == "__main__":
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        print(pool.map(work, [1])[0])
"""


def run(folder: Path, *arguments: str, text: str = "") -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *arguments],
        input=text,
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
        timeout=100,
    )


@pytest.mark.parametrize(
    ("script", "line"),
    [
        (ASK + CALL, 3),
        (ASK + IN_A_FUNCTION + "main()\n", 5),
        (ASK + "if True:\n    " + CALL, 4),
        (ASK + GUARD + "pass\n" + CALL, 5),
        (SWEEP, 3),
        (ASK + GUARD + CALL, 0),
        (ASK + IN_A_FUNCTION + GUARD + "main()\n", 0),
    ],
)
def test_a_script_needs_its_guard(tmp_path: Path, script: str, line: int) -> None:
    (tmp_path / "own.py").write_text(script, encoding="utf-8")
    for words in (["own.py"], ["-m", "own"]):
        done = run(tmp_path, *words)
        if not line:
            assert (done.returncode, done.stdout) == (0, "begins\n"), done.stderr
            continue
        assert done.returncode == 1
        assert f"own.py, line {line}: the script has no main guard" in done.stderr.splitlines()[-1]
        assert len(done.stderr.splitlines()) < 30
        assert not (tmp_path / "o").exists()


def test_what_workers_do_not_import_needs_none(tmp_path: Path) -> None:
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / "__main__.py").write_text(ASK + CALL, encoding="utf-8")
    for words, text in ((["-m", "own"], ""), (["-c", ASK + CALL], ""), (["-"], ASK + CALL)):
        assert run(tmp_path, *words, text=text).stdout == "begins\n"


def test_a_worker_of_a_pool_is_told_so(tmp_path: Path) -> None:
    (tmp_path / "own.py").write_text(IN_A_POOL, encoding="utf-8")
    assert (
        "workers: a worker of a pool cannot start workers of its own; allowed: 1"
        in run(tmp_path, "own.py").stdout
    )


def test_a_frozen_application_needs_none_that_could_be_read(tmp_path: Path) -> None:
    """Its script lies in the application, without source: what is guarded there cannot be seen."""
    frozen = "import os, sys\nsys.frozen = True\nos.remove('own.py')\n"
    (tmp_path / "own.py").write_text(frozen + ASK + GUARD + CALL, encoding="utf-8")
    done = run(tmp_path, "own.py")
    assert (done.returncode, done.stdout) == (0, "begins\n"), done.stderr
