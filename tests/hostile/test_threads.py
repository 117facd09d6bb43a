"""Threads that call jounce at once get the numbers of a single one, cold and warm, and end no process."""

from __future__ import annotations

import contextlib
import json
import os
import socket
import subprocess
import sys
import time
import urllib.request
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import threads_many

from rules import ROOT

PROGRAM = Path(__file__).parent / "threads_run.py"
QUICK = (
    "simulate",
    "simulate_many",
    "compliance",
    "modes",
    "equilibrium",
    "sweep_travel",
    "stationary",
)
PROCESSES = int(os.environ.get("JOUNCE_PROCESSES", "20"))


def run(folder, *arguments, cache="cache"):
    """Run the program in a process of its own; a crash is its exit code."""
    words = [sys.executable, str(PROGRAM), *map(str, arguments)]
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(folder / cache), "TMPDIR": str(folder)}
    ended = subprocess.run(
        words, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
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
@pytest.mark.parametrize("cold", [False, True])
def test_many_processes(cold):
    assert threads_many.count(PROCESSES // 5 if cold else PROCESSES, cold=cold)["wrong"] == []


def page_of_the_documentation() -> str:
    text = (ROOT / "docs/how-to/call-from-threads.md").read_text(encoding="utf-8")
    return text.partition("```python\n")[2].partition("```")[0]


def test_first_visitors_of_a_web_page(tmp_path):
    pytest.importorskip("fastapi")
    rigs = ("kart-quarter-car", "audi-a6-quarter-car")
    visits = [f"{rig}/{mass}" for rig in rigs for mass in (90, 100, 110)]
    (tmp_path / "page.py").write_text(page_of_the_documentation(), encoding="utf-8")
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        port = found.getsockname()[1]
    words = [
        sys.executable,
        "-m",
        "uvicorn",
        "page:app",
        "--port",
        str(port),
        "--log-level",
        "error",
    ]
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(tmp_path / "cache")}
    server = subprocess.Popen(words, cwd=tmp_path, env=environment)
    try:
        for _ in range(1200):
            with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port)):
                break
            assert server.poll() is None
            time.sleep(0.05)

        def visit(path: str) -> float:
            with urllib.request.urlopen(f"http://127.0.0.1:{port}/{path}", timeout=120) as answer:
                return float(answer.read())

        with ThreadPoolExecutor(len(visits)) as visitors:
            at_once = list(visitors.map(visit, visits))
        assert at_once == [visit(path) for path in visits]
        assert len(set(at_once)) == len(visits)
        assert server.poll() is None
    finally:
        server.terminate()
        server.wait()
