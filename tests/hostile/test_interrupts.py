"""Signals that end a command: one line, an exit code that names the signal, nothing half-written, no process left."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time

import pytest
import small_study

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals are sent otherwise there")
KINEMATICS = ("kinematics", "hmmwv-front", "--travel", "-50 mm:50 mm:5 mm")
SWEEP = small_study.COMMAND
LINE = "jounce: interrupted; no file is left half-written."
HINT = "jounce: what is finished is kept; the same command with --resume goes on."


BEGUN = """
import signal, sys
from jounce.__main__ import run
signal.signal(signal.SIGINT, signal.default_int_handler)  # which a shell may have told to ignore it
signal.signal(signal.SIGHUP, signal.SIG_DFL)
print("begun", flush=True)
if __name__ == "__main__":
    sys.exit(run())
"""


def _begin(folder, words=KINEMATICS):
    for name in ("temporary", "cache"):
        (folder / name).mkdir(exist_ok=True)
    (folder / "study.toml").write_text(small_study.STUDY, encoding="utf-8")
    environment = {
        **os.environ,
        "JOUNCE_CACHE_DIR": str(folder / "cache"),
        "TMPDIR": str(folder / "temporary"),
    }
    pipes = {
        "stdout": subprocess.PIPE,
        "stderr": subprocess.PIPE,
        "text": True,
        "start_new_session": True,
    }
    started = subprocess.Popen(
        [sys.executable, "-c", BEGUN, *words], cwd=folder, env=environment, **pipes
    )
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


@pytest.mark.parametrize(
    ("part", "number"),
    [
        *((part, signal.SIGINT) for part in (0.0, 0.1, 0.25, 0.4, 0.6, 0.8)),
        *((part, number) for part in (0.1, 0.4) for number in (signal.SIGTERM, signal.SIGHUP)),
    ],
)
@pytest.mark.some(2)
def test_ended_with_an_empty_cache(tmp_path, whole_time, part, number):
    for attempt in range(
        5
    ):  # a machine may be faster this time: what has ended already is begun again
        folder = tmp_path / str(attempt)
        folder.mkdir()
        with _begin(folder) as started:
            time.sleep(part * whole_time * 0.8**attempt)
            has_ended = started.poll() is not None
            started.send_signal(number)
            _, said = started.communicate(timeout=300)
        if not has_ended:
            break
    else:
        pytest.fail("the command ended before every interrupt")
    assert started.returncode == 128 + number, said
    assert _lines(said) == [LINE]
    assert not any((folder / "temporary").iterdir())


def _lines(said):
    return [line for line in said.splitlines() if not line.startswith("compiling")]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize(
    "file",
    [
        pytest.param("sweep.json", id="simulating"),
        pytest.param("summary.json", id="drawing", marks=pytest.mark.slow),
    ],
)
def test_a_sweep_says_how_it_goes_on(tmp_path, number, file):
    """Workers get the signal, too, as from a terminal."""
    with _begin(tmp_path, SWEEP) as started:
        while not (tmp_path / "swept" / file).exists():
            assert started.poll() is None, started.stderr.read()
            time.sleep(0.005)
        os.killpg(started.pid, number)
        _, said = started.communicate(timeout=300)
    if file == "summary.json" and started.returncode == 0:
        pytest.skip("the command ended before its interrupt")
    assert started.returncode == 128 + number, said
    assert _lines(said) == [HINT, LINE]
    assert not any((tmp_path / "temporary").iterdir())
    assert _is_empty(started.pid)


def _is_empty(group):
    """Whether all processes of a group end within some seconds."""
    for _ in range(600):
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.05)
    return False


HEARD_BY_ANOTHER = """
import signal, threading
from jounce.core.processes import starting_workers
signal.signal(signal.SIGINT, signal.default_int_handler)
def hear():
    signal.pthread_sigmask(signal.SIG_SETMASK, [])
    signal.pthread_kill(threading.get_ident(), signal.SIGINT)
started = []
try:
    with starting_workers():
        thread = threading.Thread(target=hear)
        thread.start()
        thread.join()
        started.append(1)
except KeyboardInterrupt:
    print("interrupted", len(started))
"""


def test_workers_are_started_whole_whoever_hears_the_signal():
    """The kernel may give it to another thread, which blocks nothing: the first message to a worker was cut off."""
    ended = subprocess.run(
        [sys.executable, "-c", HEARD_BY_ANOTHER], capture_output=True, text=True, check=True
    )
    assert (ended.stdout, ended.stderr) == ("interrupted 1\n", "")


COUNTED = """
import os, signal, time
from multiprocessing import get_context, resource_tracker
from jounce.core.processes import starting_workers
with starting_workers():
    lock = get_context("spawn").Lock()
counts = resource_tracker._resource_tracker._pid
for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
    os.kill(counts, number)
time.sleep(0.5)
print(os.waitpid(counts, os.WNOHANG))
"""


def test_the_process_that_counts_semaphores_hears_nothing():
    """It ended with a closed terminal, and its successor printed a traceback below the one line."""
    ended = subprocess.run(
        [sys.executable, "-c", COUNTED], capture_output=True, text=True, check=True
    )
    assert ended.stdout == "(0, 0)\n"
    assert ended.stderr == ""
