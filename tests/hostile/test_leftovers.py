"""What a killed process leaves behind: nothing half-written, and nothing that grows."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
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
    old, young, foreign = (
        tmp_path / f".jounce-{name}" for name in ("00000000-1-a", "00000000-1-b", "mine.txt")
    )
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
    with pytest.raises(
        OutputError, match="the folder cannot be written; found 'No space left on device'"
    ):
        write_files(tmp_path / "out", {"a.txt": "new", "b.txt": "new"}, force=True)
    assert (tmp_path / "out" / "a.txt").read_text() == "old"
    assert [file.name for file in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize(
    "name",
    ["n" * 251 + ".csv", "päth with 'quotes' \"and\" \U0001f600 \u202e.csv", "-rf", "a" * 200],
)
def test_any_name_that_the_system_takes(tmp_path: Path, name: str) -> None:
    write_atomically(tmp_path / name, "whole")
    write_files(tmp_path / "in", {name: "whole"})
    assert [file.name for file in (tmp_path / "in").iterdir()] == [name]


def test_an_interrupted_write_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt), replacing(tmp_path / "run.csv"):
        raise KeyboardInterrupt
    assert list(tmp_path.iterdir()) == []


def test_names_that_others_gave_stop_nothing(tmp_path: Path) -> None:
    names = [
        f".jounce-{writing._machine()}-{'9' * 30}-x",
        ".jounce-a-b-c",
        ".jounce----",
        ".jounce-00000000-0-\u00b2",
    ]
    for name in names:
        (tmp_path / name).write_text("not ours")
    write_atomically(tmp_path / "run.csv", "whole")
    assert sorted(file.name for file in tmp_path.iterdir()) == sorted([*names, "run.csv"])


def test_a_clock_that_jumps_takes_nothing_from_a_process_that_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for days in (-20000.0, 20000.0):
        with replacing(tmp_path / "run.csv") as temporary:
            temporary.write_text("whole")
            now = time.time()
            monkeypatch.setattr(time, "time", lambda now=now, days=days: now + days * 86400.0)
            writing._sweep.cache_clear()
            write_atomically(tmp_path / "other.csv", "whole", force=True)
            assert temporary.exists()
        monkeypatch.undo()
    assert (tmp_path / "run.csv").read_text() == "whole"


def test_what_an_earlier_process_of_the_same_number_left_goes(tmp_path: Path) -> None:
    left = (
        tmp_path / f".jounce-{writing._machine()}-{os.getpid()}-000000-x.a-b"
    )  # a suffix with a hyphen
    left.mkdir()
    write_atomically(tmp_path / "run.csv", "whole")
    assert left.exists() == (os.name != "posix")


def test_what_is_moved_out_comes_back_where_the_new_cannot_go_in(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    write_files(out, {"a.txt": "old", "b/c.txt": "old"})
    (out / "mine.txt").write_text("mine")
    rename = Path.rename

    def refused(self: Path, target: Path) -> Path:
        if self.name == "c.txt" and self.parent.parent.name == "jounce-ready":
            raise OSError(5, "Input/output error")
        return rename(self, target)

    monkeypatch.setattr(Path, "rename", refused)
    with pytest.raises(OutputError, match="Input/output error"):
        write_files(out, {"a.txt": "new", "b/c.txt": "new", "d.txt": "new"}, force=True)
    found = {
        str(file.relative_to(out)): file.read_text() for file in out.rglob("*") if file.is_file()
    }
    assert found == {"a.txt": "old", "b/c.txt": "old", "mine.txt": "mine"}


def test_the_folder_that_one_stands_in_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    before = tmp_path.stat().st_ino
    write_files(".", {"a.txt": "new"})
    assert tmp_path.stat().st_ino == before
    assert Path("a.txt").read_text() == "new"


def test_working_folders_of_killed_processes_go(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    left = tmp_path / f".jounce-{writing._machine()}-{os.getpid()}-000000-x"
    left.mkdir()
    with writing.working_folder() as folder:
        assert folder.parent == tmp_path
        assert list(tmp_path.iterdir()) == [folder]
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(
    os.name != "posix", reason="elsewhere what still runs is not known, and left for a day"
)
def test_what_a_process_left_beside_the_folder_that_it_had_just_made_goes(tmp_path: Path) -> None:
    left = tmp_path / f".jounce-{writing._machine()}-{os.getpid()}-000000-x"
    left.mkdir()
    (tmp_path / "out").mkdir()
    write_files(tmp_path / "out", {"a.txt": "new"})
    assert [file.name for file in tmp_path.iterdir()] == ["out"]


def test_a_full_disk_in_a_working_folder_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    with (
        pytest.raises(
            OutputError,
            match=r"\.jounce-.*: a temporary file cannot be written; found 'No space left",
        ),
        writing.working_folder(),
    ):
        raise OSError(28, "No space left on device")
    with pytest.raises(FileNotFoundError), writing.working_folder():
        Path(tmp_path, "mine.csv").read_text()
    assert list(tmp_path.iterdir()) == []


def test_a_folder_in_the_place_of_a_file_and_a_file_in_the_way_are_refused_before_the_work(
    tmp_path: Path,
) -> None:
    (tmp_path / "run.nc").mkdir()
    for force in (False, True):
        with pytest.raises(OutputError, match="a folder with the name of the file exists"):
            writing.check_writable(tmp_path / "run.nc", force=force)
    (tmp_path / "mine.txt").write_text("mine")
    with pytest.raises(OutputError, match=r"inside a file; found '.*mine\.txt'"):
        writing.check_folder(tmp_path / "mine.txt" / "a" / "out")
    with pytest.raises(
        OutputError, match="the folder cannot be written; found 'File name too long'"
    ):
        writing.check_folder(tmp_path / ("x" * 300))


LEFT = ".jounce-00000000-1-a"  # of another machine


def day_old(*folders: Path) -> None:
    for folder in folders:
        os.utime(folder, (time.time() - 2 * 86400.0,) * 2)


@pytest.mark.skipif(os.name != "posix", reason="links need a permission there")
@pytest.mark.parametrize("name", ["jounce-ready", "jounce-old"])
def test_a_link_in_the_place_of_a_leftover_moves_nothing(tmp_path: Path, name: str) -> None:
    """An archive that brought such a link emptied the folder that it leads to."""
    mine, work = tmp_path / "mine", tmp_path / "work"
    for folder in (mine, work / LEFT):
        folder.mkdir(parents=True)
    (mine / "thesis.txt").write_text("mine")
    (work / LEFT / name).symlink_to(mine)
    day_old(work / LEFT)
    write_atomically(work / "run.csv", "whole")
    assert [file.name for file in mine.iterdir()] == ["thesis.txt"]
    assert [file.name for file in work.iterdir()] == ["run.csv"]


@pytest.mark.skipif(os.name != "posix", reason="links need a permission there")
def test_nothing_is_moved_through_a_link(tmp_path: Path) -> None:
    mine, work = tmp_path / "mine", tmp_path / "work"
    for folder in (mine, work / LEFT / "jounce-ready" / "keys"):
        folder.mkdir(parents=True)
    (work / "keys").symlink_to(mine)
    (work / LEFT / "jounce-ready" / "keys" / "own").write_text("foreign")
    day_old(work / LEFT)
    write_atomically(work / "run.csv", "whole")
    assert not list(mine.iterdir())
    assert (work / "run.csv").read_text() == "whole"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes there")
def test_pipes_and_links_among_leftovers_keep_nobody_waiting(tmp_path: Path) -> None:
    ready = tmp_path / LEFT / "jounce-ready"
    ready.mkdir(parents=True)
    os.mkfifo(ready / "pipe")
    (ready / "loop").symlink_to("loop")
    os.mkfifo(tmp_path / ".jounce-00000000-2-b")
    day_old(tmp_path / LEFT, tmp_path / ".jounce-00000000-2-b")
    write_files(tmp_path, {"a.txt": "a"})
    assert (tmp_path / "a.txt").read_text() == "a"
    assert not list(tmp_path.glob(".jounce-*"))


def test_leftovers_that_lie_deep_stay(tmp_path: Path) -> None:
    """Two thousand folders in each other, which Python's own functions walk by recursion."""
    deepest = os.open(tmp_path, os.O_RDONLY)
    for name in (LEFT, "jounce-ready", *["d"] * 2000):
        os.mkdir(name, dir_fd=deepest)
        within = os.open(name, os.O_RDONLY, dir_fd=deepest)
        os.close(deepest)
        deepest = within
    os.close(deepest)
    day_old(tmp_path / LEFT)
    write_files(tmp_path, {"a.txt": "a"})
    assert (tmp_path / "a.txt").read_text() == "a"
    subprocess.run(["rm", "-rf", str(tmp_path / LEFT)], check=True)


def test_a_file_is_written_though_its_temporary_name_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It was there, whole, and "cannot be written"."""
    with monkeypatch.context() as failing:

        def refuse(file: Path, **_: bool) -> None:
            raise OSError(5, "Input/output error", str(file))

        failing.setattr(Path, "unlink", refuse)
        write_atomically(tmp_path / "a.txt", "whole")
    assert (tmp_path / "a.txt").read_text() == "whole"
    assert len(list(tmp_path.iterdir())) == 2
