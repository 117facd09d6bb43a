"""Files that end the process that reads them, keep it busy or fill its memory: one message, and the next is read."""

from __future__ import annotations

import ctypes
import io
import struct
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from jounce.core import child_processes
from jounce.core.errors import JounceError, RecordingError
from jounce.recordings import isolated, read_recording, readers, recording, write_recording
from jounce.recordings.isolated import read_isolated
from jounce.recordings.reader import Reader, ReaderOptions, SignalTable

EVIL = """
import os, signal, time
import numpy as np
from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import DescriptionError
from jounce.recordings import readers

def evil(path, options):
    what = path.read_text()
    if what == "crash":
        os.kill(os.getpid(), signal.SIGSEGV)
    if what == "exit":
        os._exit(7)
    if what == "loop":
        while True:
            pass
    if what == "sleep":
        time.sleep(60.0)
    if what == "memory":
        np.ones(300_000_000)
    if what == "grow":
        kept = []
        while len(kept) < 40:
            kept.append(np.ones(5_000_000))
            time.sleep(0.05)
    if what == "unknown":
        raise KeyError("x")
    if what == "refused":
        raise DescriptionError("wrong", where="here", found=3, allowed="less", hint="Try.")
    print("noise on the standard output")
    fault = readers.RecordingError("text", where="a")
    columns = (Column("a", "m", np.arange(3.0), "f"), Column("b", "", np.empty(0), "f", fault, "B"))
    from jounce.core.findings import Finding, finding

    other = ColumnTable((Column("\\ud800", "s", np.arange(2.0)),), ("c",), "g", [4, 5], (finding("core.cut_off", "r"),))
    attributes = {"n": np.float64(2.5), "i": np.int64(7), "t": np.array(["x", "y"], dtype=object), "l": np.arange(2)}
    attributes |= {"text": "µ", "nan": float("nan"), "bytes": b"ab", "odd": object}
    findings = (Finding("p", "note", "m", np.float64(1.0)),)
    return readers.SignalTable(ColumnTable(columns), {"a": "long"}, attributes, ("z",), (other,), findings)

readers.reader("evil", "a reader of this test", (".evil",), source="none", example="none", is_isolated=True)(evil)
"""
EVIL_READER = Reader("evil", "", (".evil",), lambda *_: SignalTable(None), "", "", is_isolated=True)


@pytest.fixture
def evil(monkeypatch, tmp_path):
    """Read a file that misbehaves as its text says, with limits that are soon reached."""
    boot = f"{isolated._PATH}{EVIL}from jounce.recordings.isolated import serve; serve(readers.READERS)"
    monkeypatch.setattr(isolated, "_CHILD", boot)
    monkeypatch.setattr(isolated, "MEMORY", 3e8)
    monkeypatch.setattr(isolated, "_IDLE", [])

    def read(
        what: str, seconds: float = 20.0
    ) -> SignalTable:  # long enough where much else is to be done, too
        monkeypatch.setattr(isolated, "TIME", seconds)
        file = tmp_path / "a.evil"
        file.write_text(what)
        return read_isolated(EVIL_READER, file, ReaderOptions())

    yield read
    isolated._end_all()


@pytest.mark.skipif(sys.platform == "win32", reason="signals and limits of POSIX")
@pytest.mark.parametrize(
    ("what", "says"),
    [
        (
            "crash",
            r"a\.evil: the reading process crashed \(SIGSEGV\), so the file is damaged",
        ),
        ("exit", r"a\.evil: the reading process ended unexpectedly \(exit code 7\)"),
        (
            "loop",
            r"a\.evil: reading does not finish, so the file is damaged; found 'more than 1 s'; allowed: ",
        ),
        ("sleep", r"a\.evil: reading does not finish"),
        ("unknown", r"a\.evil: this cannot be used.*\(KeyError: 'x'\)"),
        ("refused", r"^here: wrong; found 3; allowed: less\. Try\.$"),
    ],
)
@pytest.mark.some(2)
def test_what_a_file_does_is_one_message(evil, what: str, says: str) -> None:
    with pytest.raises(JounceError, match=says):
        evil(what, 1.0 if what in ("loop", "sleep") else 20.0)
    assert evil("whole").columns["a"].values.tolist() == [0.0, 1.0, 2.0]


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="elsewhere memory is not limited")
def test_memory_is_limited_by_the_size_of_the_file(evil) -> None:
    with pytest.raises(
        RecordingError,
        match=r"a\.evil: the file takes more memory than a file of its size may; found '",
    ):
        evil("memory")
    assert evil("whole").left_out == ("z",)


@pytest.mark.skipif(not Path("/bin/ps").exists(), reason="memory is looked at by ps")
def test_memory_is_looked_at_where_the_system_does_not_limit_it(
    evil, monkeypatch: pytest.MonkeyPatch
) -> None:
    begin = "from jounce.recordings.isolated import serve"
    unlimited = f"from jounce.recordings import isolated; isolated.limit = lambda *_: None; {begin}"
    monkeypatch.setattr(isolated, "_CHILD", isolated._CHILD.replace(begin, unlimited))
    monkeypatch.setattr(child_processes, "LIMITS_MEMORY", False)
    monkeypatch.setattr(child_processes, "_BETWEEN_LOOKS", 0.05)
    with pytest.raises(
        RecordingError, match=r"a\.evil: the file takes more memory than a file of its size may"
    ):
        evil("grow")
    assert evil("whole").left_out == ("z",)


@pytest.mark.parametrize(("answers", "taken"), [(1, 3e9), (0, 0.0)])
def test_windows_tells_what_a_process_takes(
    monkeypatch: pytest.MonkeyPatch, answers: int, taken: float
) -> None:
    """Under a fake of its library: size of the structure, place of the number (PagefileUsage), and no answer."""

    class Ask:
        def __call__(self, handle: int, at: int, size: int) -> int:
            assert (handle, size) == (7, 8 + 8 * ctypes.sizeof(ctypes.c_size_t))
            assert ctypes.c_uint32.from_address(at).value == size
            ctypes.c_size_t.from_address(
                at + 8 + 6 * ctypes.sizeof(ctypes.c_size_t)
            ).value = 3_000_000_000
            return answers

    class Library:
        def __init__(self, name: str) -> None:
            assert name == "kernel32"
            self.K32GetProcessMemoryInfo = Ask()

    class Process:
        _handle = 7

    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(ctypes, "WinDLL", Library, raising=False)
    assert child_processes._memory_of(Process()) == taken
    monkeypatch.delattr(ctypes, "WinDLL")
    assert child_processes._memory_of(Process()) == 0.0


def test_everything_comes_back_as_it_was_read(evil) -> None:
    signals = evil("whole")
    a, b = signals.columns
    assert (a.name, a.unit, a.file, a.fault, a.written) == ("a", "m", "f", None, "")
    assert a.values.flags.writeable
    assert str(b.fault) == "a: text."
    assert (b.written, b.values.size) == ("B", 0)
    (other,) = signals.others
    assert (other.names, other.comments, other.name_row(1)) == (("\ud800",), ("c",), "line 5")
    assert [(one.place, one.code) for one in other.remarks] == [("r", "core.cut_off")]
    found = dict(signals.attributes)
    assert isinstance(found["n"], np.float64)
    assert isinstance(found["i"], np.int64)
    assert np.isnan(found.pop("nan"))
    assert found.pop("t").tolist() == ["x", "y"]
    assert found.pop("l").tolist() == [0, 1]
    assert found == {"n": 2.5, "i": 7, "text": "µ", "bytes": "ab", "odd": "<class 'object'>"}
    assert [str(one) for one in signals.findings] == ["note: p: m"]
    assert signals.long_names == {"a": "long"}


def test_a_child_that_was_killed_while_it_waits_is_replaced(tmp_path: Path) -> None:
    file = tmp_path / "a.nc"
    write_recording(
        recording(np.arange(50) * 0.01, {"tyre.force": (np.arange(50.0), "N", "")}), file
    )
    read_recording(file)
    waiting = isolated._IDLE[-1].process
    waiting.kill()
    waiting.wait()
    assert read_recording(file)[0].sizes["time"] == 50


def test_one_child_reads_many_files_of_a_library_that_reserves_much(
    tmp_path: Path, monkeypatch
) -> None:
    pa, parquet = pytest.importorskip("pyarrow"), pytest.importorskip("pyarrow.parquet")
    monkeypatch.setattr(isolated, "_IDLE", [])
    table = pa.table({"time [s]": np.arange(50) * 0.01, "tyre.force [N]": np.arange(50.0)})
    seen = set()
    for name in ("a.parquet", "b.parquet"):
        parquet.write_table(table, tmp_path / name)
        assert read_recording(tmp_path / name)[0].sizes["time"] == 50
        seen |= {child.process.pid for child in isolated._IDLE}
    assert len(seen) == 1
    isolated._end_all()


def test_the_same_in_a_process_that_can_start_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "a.nc"
    write_recording(
        recording(np.arange(50) * 0.01, {"tyre.force": (np.arange(50.0), "N", "")}), file
    )
    in_child = read_recording(file)[0]
    monkeypatch.setattr(readers, "is_possible", lambda: False)
    monkeypatch.setattr(isolated, "read_isolated", None)
    here = read_recording(file)[0]
    assert here.identical(in_child)
    assert {key: type(value) for key, value in here.attrs.items()} == {
        key: type(value) for key, value in in_child.attrs.items()
    }


def test_a_file_that_promises_more_than_the_memory_is_refused_in_seconds(tmp_path: Path) -> None:
    from scipy.io import savemat

    stream = io.BytesIO()
    savemat(stream, {"time": np.arange(100) * 0.01, "az": np.ones(100)})
    content = bytearray(stream.getvalue())
    at = content.index(struct.pack("<ii", 1, 100))
    content[at : at + 8] = struct.pack("<ii", 1, 2_000_000_000)
    file = tmp_path / "a.mat"
    file.write_bytes(content)
    start = time.monotonic()
    with pytest.raises(RecordingError, match=r"a\.mat"):
        read_recording(file)
    assert time.monotonic() - start < 60.0
