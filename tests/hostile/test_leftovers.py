"""What a killed process leaves behind: nothing half-written, and nothing that grows."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from jounce.core import writing
from jounce.core.errors import OutputError
from jounce.core.writing import replacing, write_atomically, write_files

WRITER = """
import sys
from jounce.core.writing import replacing, write_files
from pathlib import Path
with replacing(Path(sys.argv[1]) / "run.csv") as temporary:
    temporary.write_text("half")
    print("writing", flush=True)
    sys.stdin.read()
"""


@pytest.fixture(autouse=True)
def not_swept_yet() -> None:
    writing._sweep.cache_clear()


@pytest.mark.skipif(os.name != "posix", reason="elsewhere leftovers go after a day")
def test_what_a_killed_process_left_is_swept_by_the_next_one(tmp_path: Path) -> None:
    asked = [sys.executable, "-c", WRITER, str(tmp_path)]
    with subprocess.Popen(asked, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "writing\n"
        write_atomically(tmp_path / "other.csv", "whole")
        assert len(list(tmp_path.glob(".jounce-*"))) == 1  # it still runs
        child.send_signal(signal.SIGKILL)
    assert not (tmp_path / "run.csv").exists()
    writing._sweep.cache_clear()
    write_atomically(tmp_path / "run.csv", "whole")
    assert sorted(file.name for file in tmp_path.iterdir()) == ["other.csv", "run.csv"]


def test_leftovers_of_other_machines_go_after_a_day(tmp_path: Path) -> None:
    old, young, foreign = (tmp_path / f".jounce-{name}" for name in ("00000000-1-a", "00000000-1-b", "mine.txt"))
    for file in (old, young, foreign):
        file.write_text("left")
    day_before = time.time() - 2 * 86400.0
    os.utime(old, (day_before, day_before))
    write_atomically(tmp_path / "run.csv", "whole")
    assert sorted(file.name for file in tmp_path.iterdir()) == [young.name, foreign.name, "run.csv"]


def test_all_files_or_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_files(tmp_path / "out", {"a.txt": "old"})
    write = Path.write_bytes

    def full(self: Path, content: bytes) -> int:
        if self.name == "b.txt":
            raise OSError(28, "No space left on device")
        return write(self, content)

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(OutputError, match="the folder cannot be written; found 'No space left on device'"):
        write_files(tmp_path / "out", {"a.txt": "new", "b.txt": "new"}, force=True)
    assert (tmp_path / "out" / "a.txt").read_text() == "old"
    assert [file.name for file in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize(
    "name", ["n" * 251 + ".csv", "päth with 'quotes' \"and\" \U0001f600 \u202e.csv", "-rf", "a" * 200]
)
def test_any_name_that_the_system_takes(tmp_path: Path, name: str) -> None:
    write_atomically(tmp_path / name, "whole")
    write_files(tmp_path / "in", {name: "whole"})
    assert [file.name for file in (tmp_path / "in").iterdir()] == [name]


def test_an_interrupted_write_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt), replacing(tmp_path / "run.csv"):
        raise KeyboardInterrupt
    assert list(tmp_path.iterdir()) == []
