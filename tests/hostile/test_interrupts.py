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


def _begin(folder):
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(folder / "cache")}
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    started = subprocess.Popen([sys.executable, "-c", BEGUN, *WORDS], cwd=folder, env=environment, **pipes)
    assert started.stdout.readline() == "begun\n"
    return started


@pytest.fixture(scope="module")
def whole_time(tmp_path_factory):
    """How long the command takes here when nobody interrupts it [s]."""
    with _begin(tmp_path_factory.mktemp("whole")) as started:
        begin = time.monotonic()
        _, said = started.communicate(timeout=300)
    assert started.returncode == 0, said
    return time.monotonic() - begin


@pytest.mark.parametrize("part", [0.0, 0.1, 0.25, 0.4, 0.6, 0.8])
def test_interrupted_with_an_empty_cache(tmp_path, whole_time, part):
    for attempt in range(5):  # a machine may be faster this time: what has ended already is begun again
        folder = tmp_path / str(attempt)
        folder.mkdir()
        with _begin(folder) as started:
            time.sleep(part * whole_time * 0.8**attempt)
            has_ended = started.poll() is not None
            started.send_signal(signal.SIGINT)
            _, said = started.communicate(timeout=300)
        if not has_ended:
            break
    else:
        pytest.fail("the command ended before every interrupt")
    lines = [line for line in said.splitlines() if not line.startswith("compiling")]
    assert started.returncode == 130, said
    assert lines == ["jounce: interrupted; no file is left half-written."]
