"""What the system lacks is said of the system: it grades no record, damages no file, leaves nothing out."""

from __future__ import annotations

import errno
import os
import re
import signal
import subprocess
import sys

import numpy as np
import pytest

from jounce.core.errors import (
    NO_THREAD,
    RecordingError,
    ResourceError,
    is_of_system,
    reason,
    resource_error,
    unforeseen,
)
from jounce.inspection.archive import lane, reevaluation
from jounce.inspection.archive.store import Store
from jounce.inspection.archive.watching import FolderWatch
from jounce.parts.testers import load_tester
from jounce.recordings import isolated
from jounce.variants import many

TESTER = load_tester("eusama")
LACKING = [
    MemoryError(),
    RuntimeError(NO_THREAD),
    ImportError("x.so: failed to map segment from shared object"),
    OSError(errno.EAGAIN, os.strerror(errno.EAGAIN)),
    OSError(errno.EMFILE, os.strerror(errno.EMFILE)),
    OSError(errno.EFBIG, os.strerror(errno.EFBIG)),
    OSError(errno.EIO, os.strerror(errno.EIO)),
    ResourceError("a process that reads files was ended"),
]
errors = pytest.mark.parametrize(
    "error", LACKING, ids=lambda error: f"{type(error).__name__} {error}"[:30]
)


def raising(error):
    def work(*_, **__):
        raise error

    return work


@pytest.fixture
def record(tmp_path):
    file = tmp_path / "lane.csv"
    file.write_text(
        "time [s],left.plate.z [mm]\n" + "".join(f"{0.01 * k:.2f},{k % 7}\n" for k in range(99))
    )
    return file


@errors
def test_what_lacks_is_named_with_what_helps(error):
    assert is_of_system(error)
    known = resource_error(error, "here")
    assert known is error or (known.where == "here" and known.hint)
    with pytest.raises(ResourceError):
        reason(error)


@pytest.mark.parametrize(
    "error", [ValueError("x"), OSError(errno.ENOENT, "gone"), RecordingError("damaged")]
)
def test_what_a_file_is_remains_its_own(error):
    assert not is_of_system(error)
    assert reason(error) == str(unforeseen(error))


def test_one_array_larger_than_the_machine_is_the_question_s_own_fault():
    with pytest.raises(MemoryError) as caught:
        np.empty(1 << 58)
    assert not is_of_system(caught.value)
    assert reason(caught.value).startswith("not enough memory for this")


@errors
def test_no_record_is_graded_by_it(record, tmp_path, monkeypatch, error):
    store = Store(tmp_path / "lane.sqlite")
    monkeypatch.setattr(lane, "_evaluate", raising(error))
    with pytest.raises((ResourceError, OSError)):
        lane.import_record(record, store, TESTER)
    watch = FolderWatch(tmp_path, store, TESTER, settle=0.0)
    assert [seen.problem.endswith("jounce tries again.") for seen in watch.look()] == [True]
    assert not list(store.numbers())
    monkeypatch.undo()
    assert [seen.imported.number for seen in watch.look()] == [1]
    store.close()


@errors
def test_no_stored_record_is_graded_anew_by_it(record, tmp_path, monkeypatch, error):
    store = Store(tmp_path / "lane.sqlite")
    number = lane.import_record(record, store, TESTER).number
    before = store.newest_grading(number)
    monkeypatch.setattr(reevaluation, "stored_signals", raising(error))
    with pytest.raises(ResourceError):
        reevaluation.reevaluate(store, tester=TESTER, workers=1)
    assert store.newest_grading(number) == before
    store.close()


@errors
def test_no_variant_is_left_out_by_it(error):
    class Results:
        reasons: dict[int, str] = {}

    with pytest.raises(ResourceError):
        many._TrialGroup._run_alone(None, Results(), 3, raising(error))
    assert Results.reasons == {}


@pytest.fixture
def fresh(monkeypatch):
    """No child waits; those of this test go."""
    children: list[isolated._Child] = []
    monkeypatch.setattr(isolated, "_IDLE", children)
    yield children
    for child in children:
        child.end()


def test_a_child_that_does_not_start_says_nothing_of_the_file(fresh, tmp_path, monkeypatch):
    import jounce as jn

    file = tmp_path / "a.nc"
    file.write_bytes(b"CDF\x01")
    monkeypatch.setattr(isolated, "_CHILD", "raise SystemExit(1)")
    with pytest.raises(ResourceError, match="does not start; found 'exit code 1'"):
        jn.read_recording(file)


@pytest.mark.skipif(os.name != "posix", reason="no signals there")
def test_a_child_that_is_ended_from_outside_says_nothing_of_the_file(fresh, tmp_path, monkeypatch):
    import jounce as jn

    file = tmp_path / "a.nc"
    file.write_bytes(b"CDF\x01")
    killed = "isolated._read = lambda *_: os.kill(os.getpid(), signal.SIGKILL)"
    begin = f"import os, signal\nfrom jounce.recordings import isolated\n{killed}\n"
    monkeypatch.setattr(
        isolated, "_CHILD", isolated._CHILD.replace("serve(READERS)", f"{begin}serve(READERS)")
    )
    with pytest.raises(
        ResourceError, match=f"was terminated externally; found '{signal.SIGKILL.name}'"
    ):
        jn.read_recording(file)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="elsewhere memory is not limited")
@pytest.mark.parametrize(
    "words",
    [
        ["modes", "kart-quarter-car"],
        [
            "simulate",
            "kart-quarter-car",
            "--road",
            "detrended_rms_course_1in",
            "--speed",
            "2 m/s",
            "--duration",
            "1 s",
        ],
        ["export", "fmu", "kart-quarter-car", "--out", "rig.fmu"],
    ],
    ids=lambda words: words[0],
)
@pytest.mark.parametrize("megabytes", [250, 500])
@pytest.mark.some(2)
def test_little_memory_is_named_and_not_the_duration(tmp_path, words, megabytes):
    command = [
        "sh",
        "-c",
        f'ulimit -v {megabytes * 1000}; exec "$@"',
        "sh",
        sys.executable,
        "-m",
        "jounce",
        *words,
    ]
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(tmp_path), "OPENBLAS_NUM_THREADS": "1"}
    ended = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert ended.returncode == 2
    assert re.search(r"memory.*\(ulimit -v\)", ended.stderr)
    assert "shorter duration" not in ended.stderr


@pytest.mark.skipif(os.name != "posix", reason="no such limits there")
@pytest.mark.parametrize(("limit", "what"), [("-n 5", "open files"), ("-f 1", "size of files")])
def test_other_limits_are_named(tmp_path, limit, what):
    words = ["export", "fmu", "kart-quarter-car", "--out", "rig.fmu"]
    command = [
        "sh",
        "-c",
        f'ulimit {limit}; exec "$@"',
        "sh",
        sys.executable,
        "-m",
        "jounce",
        *words,
    ]
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(tmp_path)}
    ended = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert ended.returncode == 2, ended.stdout
    assert re.search(rf"aise the limit of (the )?{what} \(ulimit", ended.stderr)
    assert not list(tmp_path.glob("rig*"))
