"""Narrow places: no shared memory, no more processes or threads. The work goes on, or its error names the place."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
import small_study

from jounce.core.processes import NO_THREAD, NoWorkersError, starting_workers

COMMAND = [sys.executable, "-m", "jounce"]
SWEEP = [*COMMAND, *small_study.COMMAND]
GOES_ON = "A single process needs no workers. This process works alone."
OTHER = 54_321  # a user without an entry, whom limits of processes bind
CAPABILITIES = "+dac_override,+dac_read_search"  # to read the interpreter, wherever it lies


def run(words, folder):
    """Run a command beside a study; give what it ended with."""
    (folder / "study.toml").write_text(small_study.STUDY, encoding="utf-8")
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(folder / "cache")}
    return subprocess.run(
        words, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )


def is_possible(*words):
    """Whether the system lets this user do so."""
    try:
        return subprocess.run(words, capture_output=True, check=False).returncode == 0
    except OSError:
        return False


@pytest.mark.parametrize(
    ("options", "reason"),
    [("ro", os.strerror(30)), ("size=4k", os.strerror(28))],
    ids=["read-only", "full"],
)
@pytest.mark.some(2)
def test_without_shared_memory_one_process_does_the_sweep(tmp_path, options, reason):
    apart = ["unshare", "--mount"]
    if not is_possible(*apart, "mount", "-t", "tmpfs", "none", "/dev/shm"):
        pytest.skip("this user may not mount")
    fill = "head -c 4096 /dev/zero > /dev/shm/full" if options != "ro" else ""
    mount = f"mount -t tmpfs -o {options} none /dev/shm\n{fill}"
    ended = run([*apart, "sh", "-c", f'{mount}\nexec "$@"', "sh", *SWEEP], tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert (
        f"/dev/shm: no worker processes can be started; found {reason!r}. {GOES_ON}" in ended.stderr
    )


@pytest.mark.parametrize(
    "words", [SWEEP, [*COMMAND, "modes", "kart-quarter-car"]], ids=["sweep", "modes"]
)
def test_where_nothing_more_can_be_started(tmp_path, words):
    other = [
        "prlimit", "--nproc=1",
        "setpriv", f"--reuid={OTHER}", f"--regid={OTHER}", "--clear-groups",
        f"--inh-caps={CAPABILITIES}", f"--ambient-caps={CAPABILITIES}",
    ]  # fmt: skip
    if not is_possible(*other, *COMMAND, "version"):
        pytest.skip("this user may not be another one")
    tmp_path.chmod(0o777)
    ended = run([*other, *words], tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert ("sweep" in words) == (GOES_ON in ended.stderr)


def test_what_workers_lack_is_named():
    def refuse(error):
        with pytest.raises(NoWorkersError) as caught, starting_workers():
            raise error
        return caught.value.where

    assert refuse(OSError(24, "Too many open files")) == "the limit of open files (ulimit -n)"
    assert refuse(RuntimeError(NO_THREAD)) == "the limit of processes (ulimit -u)"
    assert (
        refuse(BlockingIOError(11, "Resource temporarily unavailable"))
        == "the limit of processes (ulimit -u)"
    )
    with pytest.raises(RuntimeError, match="another"), starting_workers():
        raise RuntimeError("another")
