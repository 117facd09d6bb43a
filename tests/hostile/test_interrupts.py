"""Ctrl-C while a command loads and compiles: one line, and the exit code of what was interrupted."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time

import pytest

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals are sent otherwise there")
WORDS = ("kinematics", "hmmwv-front", "--travel", "-50 mm:50 mm:5 mm")


BEGUN = """
import signal, sys
from jounce.__main__ import run
signal.signal(signal.SIGINT, signal.default_int_handler)  # which a shell may have told to ignore it
print("begun", flush=True)
sys.exit(run())
"""


@pytest.mark.parametrize("after", [0.0, 0.2, 0.5, 1.0, 1.7, 2.3])
def test_interrupted_with_an_empty_cache(tmp_path, after):
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(tmp_path / "cache")}
    words = [sys.executable, "-c", BEGUN, *WORDS]
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with subprocess.Popen(words, cwd=tmp_path, env=environment, **pipes) as started:
        assert started.stdout.readline() == "begun\n"
        time.sleep(after)
        started.send_signal(signal.SIGINT)
        _, said = started.communicate(timeout=120)
    lines = [line for line in said.splitlines() if not line.startswith("compiling")]
    assert started.returncode == 130, said
    assert lines == ["jounce: interrupted; no file is left half-written."]
