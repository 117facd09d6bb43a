"""Threads that call jounce at once get the numbers of a single one, cold and warm, and end no process."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = Path(__file__).parent / "threads_run.py"
QUICK = ("simulate", "simulate_many", "compliance", "modes", "equilibrium", "sweep_travel", "stationary")
PROCESSES = int(os.environ.get("JOUNCE_PROCESSES", "20"))


def run(folder, *arguments, cache="cache"):
    """Run the program in a process of its own; a crash is its exit code."""
    words = [sys.executable, str(PROGRAM), *map(str, arguments)]
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(folder / cache), "TMPDIR": str(folder)}
    ended = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr[-2000:]
    answer = json.loads(ended.stdout.splitlines()[-1])
    assert answer["wrong"] == {}
    return answer["examples"]


def test_cold_and_warm_and_beside_a_store_that_evicts(tmp_path):
    for seed, keep in ((1, 0), (2, 0), (3, 1)):  # the first one compiles
        assert run(tmp_path, seed, 8, keep, *QUICK) == len(QUICK)


@pytest.mark.slow
def test_all_public_examples(tmp_path):
    assert run(tmp_path, 1, 8, 0) > 150
    assert run(tmp_path, 2, 8, 1) > 150


@pytest.mark.slow
def test_many_processes(tmp_path):
    for seed in range(PROCESSES):
        run(tmp_path, seed, 8, seed % 3, *QUICK)
